//! The sentences on a load factor in addition to its bracket: the load at collapse, the effect of
//! friction, the mechanism and the welds.

use crate::document::Doc;
use crate::document::table::Table;
use crate::figures::{Rounding, bracket, percent_up, significant};
use crate::result::interface_use::ResultantUse;
use crate::result::result_file::CaseResult;
use crate::result::result_file::FrictionModel;
use crate::result::result_file::Quantity;
use crate::result::result_file::Upper;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::analysis::cone_shift::FixedPointRun;

/// The load factor from the fixed point for Coulomb's law.
pub(crate) fn estimate_words(factor: f64, run: Option<&FixedPointRun>) -> Text {
    let value = significant(factor, 4, Rounding::Nearest);
    let Some(run) = run else {
        return say!("Fixed point for Coulomb friction: {} (an estimate, not a bound).", value);
    };
    let open = run.missing.map_or_else(Text::default, |m| {
        say!(", and the last one misses Coulomb's law by {} of the load factor", percent_up(m))
    });
    say!(
        "Fixed point for Coulomb friction: {} (an estimate, not a bound). It took {} problems{}. \
         Where parts wedge, Coulomb's law can have several load factors; this is one of them.",
        value,
        run.solves,
        open
    )
}

/// The meaning of the load factor to an engineer.
pub(crate) fn collapse(doc: &mut Doc, case: &CaseResult) {
    let strict = case.is_strict();
    if let (Some(load), Some((low, high, unit))) = (case.load, case.collapse_load()) {
        let word = if strict { "lies" } else { "is estimated" };
        doc.paragraph(say!(
            "The given load of the whole structure is {}; the load at collapse {} between {} and \
             {} {}.",
            load.words(),
            word,
            low,
            high,
            unit.to_owned()
        ));
    }
    if let (Some(load), None, Some(Upper::Finite(upper))) = (case.load, case.lower, case.upper)
        && upper > 0.0
    {
        let most = significant((upper * load.value() * load.scale()).next_up(), 4, Rounding::Up);
        let word = if strict { "is" } else { "is estimated as" };
        doc.paragraph(say!(
            "The given load of the whole structure is {}; the load at collapse {} at most {} {}; \
             no lower bound is known.",
            load.words(),
            word,
            most,
            load.unit().to_owned()
        ));
    }
    if let Some(lower) = case.lower.filter(|l| *l > 0.0) {
        let low = significant(lower, 4, Rounding::Down);
        // the associated model is stronger than the Coulomb structure that it may represent
        let dilates = match case.problem {
            FrictionModel::Associated => " with its associated friction",
            _ => "",
        };
        doc.paragraph(match strict {
            true => say!(
                "Every load up to {} times the given one can be carried by the model{}; \
                 instability and limited ductility are not covered.",
                low,
                dilates
            ),
            false => say!(
                "About {} times the given load can be carried by the model (an estimate); \
                 instability and limited ductility are not covered.",
                low
            ),
        });
    }
    let smooth = case.frictionless.and_then(|f| f.lower);
    match (case.problem, smooth, case.upper) {
        (FrictionModel::Coulomb, Some(_), Some(_)) => doc.paragraph(
            "Under Coulomb's law the load factor is at least that without friction (the lower \
             value) and at most that with associated friction (the upper value).",
        ),
        (FrictionModel::Associated, Some(low), Some(Upper::Finite(high))) if case.is_strict() => {
            let (low, high) = bracket(low, high, 3);
            doc.paragraph(say!(
                "Without dilation (Coulomb's law with the same coefficient) the load factor is at \
                 least that without friction and at most that with associated friction: between \
                 {} and {}.",
                low,
                high
            ));
        }
        _ => {}
    }
}

/// Where the mechanism dissipates and which part limits the lower bound.
pub(crate) fn mechanism(doc: &mut Doc, case: &CaseResult) {
    if case.quantity != Quantity::LoadFactor {
        return welds(doc, case);
    }
    if case.dissipation.is_empty() && case.limiting_part.is_none() && case.welds.is_empty() {
        return;
    }
    doc.heading(say!("Collapse of {}", &case.name));
    if let Some(part) = &case.limiting_part {
        doc.paragraph(say!(
            "The stress of the lower bound is nearest to the yield surface in body **{}**.",
            part
        ));
    }
    if !case.dissipation.is_empty() {
        doc.paragraph(
            "The picture of the mechanism shows the structure as it collapses. What is grey yields \
             little or not at all, what is red yields most. Gaps between parts are those of the \
             mechanism.",
        );
        if case.lower.is_some() {
            let own = match case.history.len() {
                0 | 1 => "Each bound has its own picture",
                _ => "Each bound has its own mesh and its own picture",
            };
            doc.paragraph(say!(
                "The picture of the limiting zones marks in violet what limits the lower bound: \
                 the zones in which more strength would raise it. {}. The two pictures need not \
                 mark the same zones while the bounds are far apart.",
                own
            ));
        }
        doc.paragraph("Where the mechanism of the upper bound dissipates energy:");
        let bodies = case.dissipation.iter().map(|p| (Text::given(&p.part), p.share));
        let welds = case.welds.iter().filter_map(|w| Some((say!("weld {}", &w.weld), w.share?)));
        let supports =
            case.support_slip.iter().map(|s| (say!("slip on support {}", &s.support), s.share));
        let ties = case.tie_slip.iter().map(|s| (say!("slip along {}", &s.tie), s.share));
        let limits = case.resultants.iter();
        let moved = limits.filter(|r| r.share.is_some_and(|s| s >= LEAST_SHARE));
        let limits = moved.filter_map(|r| Some((say!("limit {}", &r.limit), r.share?)));
        let ground = case.crushing.iter();
        let crushed = ground.filter(|g| g.share.is_some_and(|s| s >= LEAST_SHARE));
        let crushed =
            crushed.filter_map(|g| Some((say!("crushed ground under {}", &g.ground), g.share?)));
        let interfaces = welds.chain(supports).chain(ties).chain(crushed).chain(limits);
        let mut parts: Vec<(Text, f64)> = bodies.chain(interfaces).collect();
        parts.sort_by(|a, b| b.1.total_cmp(&a.1));
        let rows =
            parts.into_iter().map(|(name, share)| [name, format!("{:.1}", 100.0 * share).into()]);
        doc.table(&Table::new(["place", "share of the dissipation [%]"], rows));
    }
    welds(doc, case);
    resultants(doc, case);
}

/// Resultant limits listed in a report, the most used ones.
const LISTED: usize = 16;

/// Least share of the dissipation of a resultant limit that is listed.
const LEAST_SHARE: f64 = 5e-4;

/// Forces through the cuts whose resultants are limited.
fn resultants(doc: &mut Doc, case: &CaseResult) {
    let row = |r: &ResultantUse| {
        let force = r.force?.map(|f| format!("{:.2}", f / 1e3));
        let used = format!("{:.1}", 100.0 * r.utilisation?);
        let most = format!("{:.2}", r.at_most / 1e3);
        let [x, y, z] = force;
        Some([r.limit.clone(), x, y, z, most, used].map(Text::from))
    };
    let mut most_used: Vec<&ResultantUse> = case.resultants.iter().collect();
    let used = |r: &ResultantUse| r.utilisation.unwrap_or(0.0);
    most_used.sort_by(|a, b| used(b).total_cmp(&used(a)));
    let rows: Vec<_> = most_used.iter().filter_map(|r| row(r)).take(LISTED).collect();
    if rows.is_empty() {
        return;
    }
    doc.paragraph(say!(
        "Limited forces of the meshed part in the stress of the lower bound ({}):",
        &case.name
    ));
    doc.paragraph(
        "A force is that of side B of a cut on side A. Of a bolt, side B is that of the nut; on \
         the part at the nut the bolt presses the other way round.",
    );
    if rows.len() < case.resultants.len() {
        doc.paragraph(say!(
            "The {} most used of {} limits; `result.json` has all of them.",
            rows.len(),
            case.resultants.len()
        ));
    }
    let columns = ["limited force", "F_x [kN]", "F_y [kN]", "F_z [kN]", "at most [kN]", "used [%]"];
    doc.table(&Table::new(columns, rows));
}

/// Demand on each weld.
fn welds(doc: &mut Doc, case: &CaseResult) {
    let rows: Vec<Vec<String>> = case
        .welds
        .iter()
        .filter_map(|w| {
            let work = w.work.map(|w| significant(w, 4, Rounding::Up));
            let used = [w.utilisation, w.mean_utilisation];
            let percent = |u: Option<f64>| u.map_or(String::new(), |u| format!("{:.1}", 100.0 * u));
            let stress = |u: Option<f64>| {
                u.zip(w.throat_strength).map_or(String::new(), |(u, f)| format!("{:.0}", u * f))
            };
            let strength = w.throat_strength.map_or(String::new(), |f| format!("{f:.0}"));
            w.utilisation?;
            let [largest, mean] = used;
            let shares = [percent(largest), percent(mean)];
            let stresses = [stress(largest), stress(mean), strength];
            Some(
                [
                    vec![w.weld.clone()],
                    shares.to_vec(),
                    stresses.to_vec(),
                    vec![work.unwrap_or_default()],
                ]
                .concat(),
            )
        })
        .collect();
    if rows.is_empty() {
        return;
    }
    doc.paragraph(say!("Demand on the welds from the stress of the lower bound ({}):", &case.name));
    let columns = Table::columns([
        "weld",
        "largest traction over strength [%]",
        "mean [%]",
        "stress on the throat, largest [MPa]",
        "mean [MPa]",
        "strength of the throat [MPa]",
        "work dissipated, upper bound [N mm]",
    ]);
    // columns that are empty for every weld are left out
    let filled: Vec<bool> =
        (0..columns.len()).map(|k| rows.iter().any(|row| !row[k].is_empty())).collect();
    let cut = |row: Vec<Text>| {
        row.into_iter().zip(&filled).filter(|(_, f)| **f).map(|(cell, _)| cell).collect()
    };
    let rows = rows.into_iter().map(|row| row.into_iter().map(Text::from).collect());
    doc.table(&Table { columns: cut(columns), rows: rows.map(cut).collect() });
}
