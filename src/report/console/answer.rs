//! The answer of a load case in a sentence, as the terminal shows it.

use crate::report::figures::{self, Rounding};
use crate::result::result_file::CaseResult;
use crate::result::result_file::Quantity;
use crate::result::result_file::Upper;

/// The answer in a sentence, in the user's units, followed by its warnings.
pub fn answer(c: &CaseResult) -> String {
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
    for w in &c.warnings {
        text += &format!("\n{name}: warning: {w}");
    }
    text
}
