//! The answer of a load case in a sentence, as the terminal shows it.

use crate::figures::{self, Rounding};
use crate::result::case_result::PartYield;
use crate::result::result_file::CaseResult;
use crate::result::result_file::Quantity;
use crate::result::result_file::Upper;

/// Largest plastic strain with its place, yielded parts and motion of the loaded faces, all
/// estimates from the field of the upper bound; `None` without that field.
fn plastic_state(c: &CaseResult) -> Option<String> {
    let flows = |p: &&PartYield| p.yielded.is_some_and(|y| y > 0.0);
    let strain = |p: &&PartYield| p.plastic_strain.unwrap_or(0.0);
    let mut yielded: Vec<&PartYield> = c.yielding.iter().filter(flows).collect();
    yielded.sort_by(|a, b| strain(b).total_cmp(&strain(a)));
    let mut parts = match yielded.first() {
        Some(p) => {
            let at = p.strain_at.map_or_else(String::new, |x| {
                format!(" at x, y, z = {} mm", x.map(|x| format!("{x:.0}")).join(", "))
            });
            let names: Vec<&str> = yielded.iter().map(|p| &p.part[..]).collect();
            vec![
                format!(
                    "largest plastic strain {} % in {}{at}",
                    figures::fixed(100.0 * strain(p), 2, Rounding::Nearest),
                    p.part
                ),
                format!("yielded: {}", names.join(", ")),
            ]
        }
        None if c.yielding.iter().any(|p| p.yielded.is_some()) => vec!["no part yields".into()],
        None => return None,
    };
    parts.extend(c.face_motions.iter().map(|m| {
        let turn = figures::significant(1e3 * m.turn(), 3, Rounding::Nearest);
        format!("{} turns by {turn} mrad", m.face)
    }));
    let bolts = c.static_forces.iter().flat_map(|s| &s.bolts);
    if let Some(b) = bolts.max_by(|a, b| a.tension.total_cmp(&b.tension)) {
        let force = figures::significant(1e-3 * b.tension, 3, Rounding::Nearest);
        parts.push(format!("largest bolt tension {force} kN in {}", b.bolt));
    }
    Some(format!("{} (estimates)", parts.join("; ")))
}

/// The lines of the answer: the bounds in the user's units, the plastic state, the warnings.
pub fn answer(c: &CaseResult) -> Vec<String> {
    let strict = c.certificate.is_some_and(|x| x.strict);
    let word = if strict { "certified" } else { "ESTIMATE, not certified" };
    let (what, unit, digits) = match c.quantity {
        Quantity::PotentialEnergy => ("potential energy", " N mm", 4),
        Quantity::LoadFactor => ("load factor", "", 3),
    };
    let name = &c.name;
    let lower = |l| figures::significant(l, 7, Rounding::Down);
    let mut text = match (c.lower, c.upper) {
        (_, Some(Upper::Finite(0.0))) if c.quantity == Quantity::LoadFactor => {
            format!("{name}: {what} 0, a mechanism needs no load ({word})")
        }
        (Some(l), Some(Upper::Finite(u))) => {
            let (l, u) = figures::bracket(l, u, digits);
            let gap = c.gap.map_or(String::new(), |g| format!(", gap {}", figures::percent_up(g)));
            format!("{name}: {what} between {l} and {u}{unit}{gap} ({word})")
        }
        (Some(l), None) => format!("{name}: {what} at least {}{unit} ({word})", lower(l)),
        (None, Some(Upper::Finite(u))) => {
            format!(
                "{name}: {what} at most {}{unit} ({word})",
                figures::significant(u, 7, Rounding::Up)
            )
        }
        (Some(l), Some(Upper::Unbounded(_))) => {
            format!("{name}: {what} at least {}, without limit above", lower(l))
        }
        (None, Some(Upper::Unbounded(_))) => format!("{name}: {what} without limit ({word})"),
        (None, None) => format!("{name}: no bound"),
    };
    if let (true, Some(load), Some([l, u])) = (strict, c.load, c.load_displacement) {
        let (l, u) = figures::bracket(l, u, 4);
        let (what, unit) = load.moves();
        text += &format!("; {what} of the load ({}) between {l} and {u} {unit}", load.words());
    }
    if let Some((l, u, unit)) = c.collapse_load() {
        text += &format!("; collapse load between {l} and {u} {unit}");
    }
    let mut lines = vec![text];
    if let Some(state) = plastic_state(c) {
        lines.push(format!("{name}: {state}"));
    }
    lines.extend(c.warnings.iter().map(|w| format!("{name}: warning: {w}")));
    lines
}
