//! The sentences on a load factor in addition to its bracket: the load at collapse, the effect of
//! friction, the mechanism and the welds.

use crate::figures::{Rounding, bracket, percent_up, significant};
use crate::markdown::markup::{inline, paragraph, strings, table};
use crate::markdown::report_data::Table;
use crate::result::result_file::CaseResult;
use crate::result::result_file::FrictionModel;
use crate::result::result_file::Quantity;
use crate::result::result_file::Upper;
use bracket_engine::analysis::cone_shift::FixedPointRun;

/// The load factor from the fixed point for Coulomb's law.
pub(crate) fn estimate_words(factor: f64, run: Option<&FixedPointRun>) -> String {
    let value = significant(factor, 4, Rounding::Nearest);
    let how = run.map_or(String::new(), |run| {
        let open = run.missing.map_or(String::new(), |m| {
            format!(
                ", and the last one misses Coulomb's law by {} of the load factor",
                percent_up(m)
            )
        });
        format!(
            " It took {} problems{open}. Where parts wedge, Coulomb's law can have several load \
             factors; this is one of them.",
            run.solves
        )
    });
    format!("Fixed point for Coulomb friction: {value} (an estimate, not a bound).{how}")
}

/// The meaning of the load factor to an engineer.
pub(crate) fn collapse(page: &mut String, case: &CaseResult) {
    if let (Some(load), Some((low, high, unit))) = (case.load, case.collapse_load()) {
        let word = if case.is_strict() { "lies" } else { "is estimated" };
        let given = load.words();
        paragraph(
            page,
            &format!(
                "The given load of the whole structure is {given}; the load at collapse {word} \
                 between {low} and {high} {unit}."
            ),
        );
    }
    if let (Some(load), None, Some(Upper::Finite(upper))) = (case.load, case.lower, case.upper)
        && upper > 0.0
    {
        let most = significant((upper * load.value() * load.scale()).next_up(), 4, Rounding::Up);
        let word = if case.is_strict() { "is" } else { "is estimated as" };
        let unit = load.unit();
        paragraph(
            page,
            &format!(
                "The given load of the whole structure is {}; the load at collapse {word} at most \
                 {most} {unit}; no lower bound is known.",
                load.words()
            ),
        );
    }
    if let Some(lower) = case.lower.filter(|l| *l > 0.0) {
        let low = significant(lower, 4, Rounding::Down);
        // the associated model is stronger than the Coulomb structure that it may represent
        let dilates = if case.problem == FrictionModel::Associated {
            " with its associated friction"
        } else {
            ""
        };
        let safe = if case.is_strict() {
            format!(
                "Every load up to {low} times the given one can be carried by the model{dilates}"
            )
        } else {
            format!("About {low} times the given load can be carried by the model (an estimate)")
        };
        paragraph(page, &format!("{safe}; instability and limited ductility are not covered."));
    }
    let smooth = case.frictionless.and_then(|f| f.lower);
    match (case.problem, smooth, case.upper) {
        (FrictionModel::Coulomb, Some(_), Some(_)) => paragraph(
            page,
            "Under Coulomb's law the load factor is at least that without friction (the lower \
             value) and at most that with associated friction (the upper value).",
        ),
        (FrictionModel::Associated, Some(low), Some(Upper::Finite(high))) if case.is_strict() => {
            let (low, high) = bracket(low, high, 3);
            paragraph(
                page,
                &format!(
                    "Without dilation (Coulomb's law with the same coefficient) the load factor \
                     is at least that without friction and at most that with associated friction: \
                     between {low} and {high}."
                ),
            );
        }
        _ => {}
    }
}

/// Where the mechanism dissipates and which part limits the lower bound.
pub(crate) fn mechanism(page: &mut String, case: &CaseResult) {
    if case.quantity != Quantity::LoadFactor {
        return welds(page, case);
    }
    if case.dissipation.is_empty() && case.limiting_part.is_none() && case.welds.is_empty() {
        return;
    }
    page.push_str(&format!("## Collapse of {}\n\n", inline(&case.name)));
    if let Some(part) = &case.limiting_part {
        let part = inline(part);
        paragraph(
            page,
            &format!(
                "The stress of the lower bound is nearest to the yield surface in body **{part}**."
            ),
        );
    }
    if !case.dissipation.is_empty() {
        paragraph(
            page,
            "The picture of the mechanism shows the structure as it collapses. What is grey yields \
             little or not at all, what is red yields most. Gaps between parts are those of the \
             mechanism.",
        );
        if case.lower.is_some() {
            let own = match case.history.len() {
                0 | 1 => "Each bound has its own picture",
                _ => "Each bound has its own mesh and its own picture",
            };
            paragraph(
                page,
                &format!(
                    "The picture of the limiting zones marks in violet what limits the lower \
                     bound: the zones in which more strength would raise it. {own}. The two \
                     pictures need not mark the same zones while the bounds are far apart."
                ),
            );
        }
        paragraph(page, "Where the mechanism of the upper bound dissipates energy:");
        let mut parts: Vec<(String, f64)> =
            case.dissipation.iter().map(|p| (p.part.clone(), p.share)).collect();
        parts
            .extend(case.welds.iter().filter_map(|w| Some((format!("weld {}", w.weld), w.share?))));
        parts.extend(
            case.support_slip.iter().map(|s| (format!("slip on support {}", s.support), s.share)),
        );
        parts.extend(case.tie_slip.iter().map(|s| (format!("slip along {}", s.tie), s.share)));
        parts.sort_by(|a, b| b.1.total_cmp(&a.1));
        let rows =
            parts.into_iter().map(|(name, share)| vec![name, format!("{:.1}", 100.0 * share)]);
        table(
            page,
            &Table {
                columns: strings(["place", "share of the dissipation [%]"]),
                rows: rows.collect(),
            },
        );
    }
    welds(page, case);
}

/// Demand on each weld.
fn welds(page: &mut String, case: &CaseResult) {
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
    let name = inline(&case.name);
    paragraph(page, &format!("Demand on the welds from the stress of the lower bound ({name}):"));
    let columns = strings([
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
    let cut = |row: Vec<String>| {
        row.into_iter().zip(&filled).filter(|(_, f)| **f).map(|(cell, _)| cell).collect()
    };
    table(page, &Table { columns: cut(columns), rows: rows.into_iter().map(cut).collect() });
}
