//! The answer of a load case: the bracket and its meaning to an engineer.

use crate::figures::{Rounding, bracket, percent_up, significant, utilisation};
use crate::markdown::collapse::{collapse, estimate_words};
use crate::markdown::markup::{inline, paragraph};
use crate::markdown::preload::preload_words;
use crate::markdown::report_data::ReportData;
use crate::markdown::words::analysis_word;
use crate::markdown::yielding::displacement;
use crate::result::result_file::CaseResult;
use crate::result::result_file::FrictionModel;
use crate::result::result_file::Quantity;
use crate::result::result_file::RawBracket;
use crate::result::result_file::Upper;
use bracket_engine::analysis::cone_shift::FixedPointRun;

fn problem_words(problem: FrictionModel, contact: bool) -> &'static str {
    match problem {
        FrictionModel::Frictionless if !contact => "",
        FrictionModel::Frictionless => " with frictionless contact",
        FrictionModel::Associated => " with contact and associated friction",
        FrictionModel::Coulomb => " with contact and Coulomb friction",
        FrictionModel::ShiftedCones => {
            " with contact, in the last step of the fixed point for Coulomb friction (shifted \
             cones)"
        }
    }
}

pub(crate) fn answer(page: &mut String, case: &CaseResult, data: &ReportData) {
    let contact = data.model.contact;
    let (what, unit) = match case.quantity {
        Quantity::PotentialEnergy => ("potential energy of the whole structure", " N mm"),
        Quantity::LoadFactor => ("load factor at collapse", ""),
    };
    let strict = case.is_strict();
    let name = format!(
        "**{}** ({}{})",
        inline(&case.name),
        analysis_word(case.analysis),
        problem_words(case.problem, contact)
    );
    let text = match (case.lower, case.upper) {
        (_, Some(Upper::Finite(0.0))) if case.quantity == Quantity::LoadFactor => {
            let verb = if strict { "is" } else { "is estimated as" };
            format!(
                "{name}: the {what} {verb} **0**: a mechanism moves the structure freely, and the \
                 live loads drive it."
            )
        }
        (Some(lower), Some(Upper::Finite(upper))) => {
            let digits = if case.quantity == Quantity::PotentialEnergy { 4 } else { 3 };
            let (low, high) = bracket(lower, upper, digits);
            let verb = if strict { "lies between" } else { "is estimated between" };
            let gap = case.gap.map(|g| format!(", gap **{}**", percent_up(g))).unwrap_or_default();
            format!("{name}: the {what} {verb} **{low}** and **{high}**{unit}{gap}.")
        }
        (Some(lower), Some(Upper::Unbounded(_))) => {
            let low = significant(lower, 6, Rounding::Down);
            format!(
                "{name}: the loads can grow without limit; the {what} is unbounded above and at \
                 least **{low}**{unit}."
            )
        }
        (Some(lower), None) => {
            let low = significant(lower, 6, Rounding::Down);
            let verb = if strict { "is at least" } else { "is estimated (from below) at" };
            format!("{name}: the {what} {verb} **{low}**{unit}; no upper value was computed.")
        }
        (None, Some(Upper::Finite(upper))) => {
            let high = significant(upper, 6, Rounding::Up);
            let verb = if strict { "is at most" } else { "is estimated (from above) at" };
            format!("{name}: the {what} {verb} **{high}**{unit}; no lower value was computed.")
        }
        (None, Some(Upper::Unbounded(_))) => {
            let proof = if strict {
                ": a stress field in equilibrium with the live loads brings no point nearer to \
                 yield"
            } else {
                ""
            };
            format!("{name}: the loads can grow without limit{proof}.")
        }
        (None, None) => {
            let why = case.ended_by().map_or_else(String::new, |s| format!(" ({s})"));
            format!("{name}: **not analysed**, no bound was obtained{why}.")
        }
    };
    paragraph(page, &text);
    if !strict && (case.lower.is_some() || case.upper.is_some()) {
        paragraph(
            page,
            "**These are estimates, not bounds**: a residual of the certificate exceeds its \
             tolerance, or no certificate was computed.",
        );
    }
    meaning(page, case, data);
}

/// The meaning of the numbers to an engineer.
fn meaning(page: &mut String, case: &CaseResult, data: &ReportData) {
    let word = if case.is_strict() { "lies" } else { "is estimated" };
    match (case.quantity, case.load.zip(case.load_displacement)) {
        (Quantity::PotentialEnergy, Some((load, [low, high]))) => {
            let (a, b) = bracket(low, high, 3);
            let (what, unit) = load.moves();
            let mean = if what == "displacement" {
                " (along the load, the mean over its face)"
            } else {
                ""
            };
            paragraph(
                page,
                &format!(
                    "The load of the whole structure is {}. Its {what}{mean} {word} between {a} \
                     and {b} {unit}.",
                    load.words()
                ),
            );
        }
        (Quantity::PotentialEnergy, None) => {
            let shifted = case.problem == FrictionModel::ShiftedCones;
            let all = [
                (data.model.preload, "preload"),
                (data.model.initial_gap, "initial gaps"),
                (shifted, "Coulomb friction"),
            ];
            let with: Vec<&str> =
                all.into_iter().filter(|(is, _)| *is).map(|(_, what)| what).collect();
            let why = match with.len() {
                0 => String::new(),
                _ => format!(": with {} it does not bracket a displacement", with.join(" and ")),
            };
            paragraph(page, &format!("The bracket applies to the energy only{why}."));
            displacement(page, case);
        }
        (Quantity::LoadFactor, _) => collapse(page, case),
    }
    if let Some([low, high]) = case.utilisation {
        let (a, b) = (utilisation(low, Rounding::Down), utilisation(high, Rounding::Up));
        paragraph(page, &format!("Utilisation (demand over capacity) between {a} and {b}."));
    }
    for (label, raw) in
        [("Frictionless", case.frictionless), ("Associated friction", case.associated)]
    {
        if let Some(raw) = raw {
            paragraph(page, &format!("{label} alone: {}.", raw_bracket(raw)));
        }
    }
    for bolt in &case.preload {
        paragraph(page, &preload_words(bolt));
    }
    match (case.coulomb_estimate, &case.fixed_point) {
        (Some(estimate), run) => paragraph(page, &estimate_words(estimate, run.as_ref())),
        (None, Some(run)) => paragraph(page, &fixed_point_words(run)),
        (None, None) => {}
    }
    if let Some(peak) = case.peak_contact_pressure {
        let side = |name: &str, p: Option<f64>| {
            p.map(|p| format!("{} MPa ({name})", significant(p, 3, Rounding::Nearest)))
        };
        let sides: Vec<String> =
            [side("static side", peak.static_), side("kinematic side", peak.kinematic)]
                .into_iter()
                .flatten()
                .collect();
        if !sides.is_empty() {
            paragraph(
                page,
                &format!(
                    "Peak contact pressure: {}; local values are estimates.",
                    sides.join(", ")
                ),
            );
        }
    }
}

/// How close the problem of the bracket is to Coulomb's law.
fn fixed_point_words(run: &FixedPointRun) -> String {
    let problems =
        if run.solves == 1 { "one problem".into() } else { format!("{} problems", run.solves) };
    let contraction = match run.contraction {
        Some(c) => format!("; a plain step reduces the error to {} of its size", percent_up(c)),
        None => String::new(),
    };
    format!(
        "Coulomb's law was reached through {problems}; the last one changed the slips by at most \
         {} of the largest slip{contraction}. The bracket is strict for this last problem.",
        percent_up(run.change)
    )
}

fn raw_bracket(raw: RawBracket) -> String {
    match (raw.lower, raw.upper) {
        (Some(lower), Some(Upper::Finite(upper))) => {
            let (a, b) = bracket(lower, upper, 3);
            format!("between {a} and {b}")
        }
        (lower, upper) => {
            let low = lower.map(|l| format!("at least {}", significant(l, 6, Rounding::Down)));
            let high = upper.map(|u| match u {
                Upper::Finite(u) => format!("at most {}", significant(u, 6, Rounding::Up)),
                Upper::Unbounded(_) => "unbounded above".into(),
            });
            [low, high].into_iter().flatten().collect::<Vec<_>>().join(", ")
        }
    }
}
