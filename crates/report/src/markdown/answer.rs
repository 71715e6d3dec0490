//! The answer of a load case: the bracket and its meaning to an engineer.

use crate::document::Doc;
use crate::figures::{Rounding, bracket, percent_up, significant, utilisation};
use crate::markdown::collapse::{collapse, estimate_words};
use crate::markdown::preload::preload_words;
use crate::markdown::report_data::ReportData;
use crate::markdown::words::{analysis_word, moved};
use crate::markdown::yielding::displacement;
use crate::result::result_file::CaseResult;
use crate::result::result_file::FrictionModel;
use crate::result::result_file::Quantity;
use crate::result::result_file::RawBracket;
use crate::result::result_file::Upper;
use bracket_base::say;
use bracket_base::words::Text;
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

pub(crate) fn answer(doc: &mut Doc, case: &CaseResult, data: &ReportData) {
    let contact = data.model.contact;
    let strict = case.is_strict();
    let name = say!(
        "**{}** ({}{})",
        &case.name,
        analysis_word(case.analysis),
        problem_words(case.problem, contact)
    );
    doc.paragraph(say!("{}: {}.", name, bounds(case, strict)));
    if !strict && (case.lower.is_some() || case.upper.is_some()) {
        doc.paragraph(
            "**These are estimates, not bounds**: a residual of the certificate exceeds its \
             tolerance, or no certificate was computed.",
        );
    }
    meaning(doc, case, data);
}

/// What is known of the quantity of a case.
fn bounds(case: &CaseResult, strict: bool) -> Text {
    let energy = case.quantity == Quantity::PotentialEnergy;
    let (what, unit) = match energy {
        true => ("potential energy of the whole structure", " N mm"),
        false => ("load factor at collapse", ""),
    };
    let unit = unit.to_owned();
    match (case.lower, case.upper) {
        (_, Some(Upper::Finite(0.0))) if !energy => match strict {
            true => say!(
                "the {} is **0**: a mechanism moves the structure freely, and the live loads \
                 drive it",
                what
            ),
            false => say!(
                "the {} is estimated as **0**: a mechanism moves the structure freely, and the \
                 live loads drive it",
                what
            ),
        },
        (Some(lower), Some(Upper::Finite(upper))) => {
            let (low, high) = bracket(lower, upper, if energy { 4 } else { 3 });
            let gap = |g| say!(", gap **{}**", percent_up(g));
            let gap = case.gap.map_or_else(Text::default, gap);
            match strict {
                true => {
                    say!("the {} lies between **{}** and **{}**{}{}", what, low, high, unit, gap)
                }
                false => say!(
                    "the {} is estimated between **{}** and **{}**{}{}",
                    what,
                    low,
                    high,
                    unit,
                    gap
                ),
            }
        }
        (Some(lower), Some(Upper::Unbounded(_))) => say!(
            "the loads can grow without limit; the {} is unbounded above and at least **{}**{}",
            what,
            significant(lower, 6, Rounding::Down),
            unit
        ),
        (Some(lower), None) => {
            let low = significant(lower, 6, Rounding::Down);
            match strict {
                true => {
                    say!(
                        "the {} is at least **{}**{}; no upper value was computed",
                        what,
                        low,
                        unit
                    )
                }
                false => say!(
                    "the {} is estimated (from below) at **{}**{}; no upper value was computed",
                    what,
                    low,
                    unit
                ),
            }
        }
        (None, Some(Upper::Finite(upper))) => {
            let high = significant(upper, 6, Rounding::Up);
            match strict {
                true => {
                    say!(
                        "the {} is at most **{}**{}; no lower value was computed",
                        what,
                        high,
                        unit
                    )
                }
                false => say!(
                    "the {} is estimated (from above) at **{}**{}; no lower value was computed",
                    what,
                    high,
                    unit
                ),
            }
        }
        (None, Some(Upper::Unbounded(_))) => match strict {
            true => {
                "the loads can grow without limit: a stress field in equilibrium with the live \
                     loads brings no point nearer to yield"
                    .into()
            }
            false => "the loads can grow without limit".into(),
        },
        (None, None) => match case.ended_by() {
            Some(status) => {
                say!("**not analysed**, no bound was obtained ({})", status)
            }
            None => "**not analysed**, no bound was obtained".into(),
        },
    }
}

/// The meaning of the numbers to an engineer.
fn meaning(doc: &mut Doc, case: &CaseResult, data: &ReportData) {
    let word = if case.is_strict() { "lies" } else { "is estimated" };
    match (case.quantity, case.load.zip(case.load_displacement)) {
        (Quantity::PotentialEnergy, Some((load, [low, high]))) => {
            let (a, b) = bracket(low, high, 3);
            let (what, unit) = load.moves();
            doc.paragraph(say!(
                "The load of the whole structure is {}. Its {} {} between {} and {} {}.",
                load.words(),
                moved(what),
                word,
                a,
                b,
                unit.to_owned()
            ));
        }
        (Quantity::PotentialEnergy, None) => {
            let shifted = case.problem == FrictionModel::ShiftedCones;
            let all = [
                (data.model.preload, "preload"),
                (data.model.initial_gap, "initial gaps"),
                (shifted, "Coulomb friction"),
            ];
            let with = all.into_iter().filter(|(is, _)| *is).map(|(_, what)| what.into());
            let with = Text::joined(" and ", with);
            doc.paragraph(match with.is_empty() {
                true => "The bracket applies to the energy only.".into(),
                false => say!(
                    "The bracket applies to the energy only: with {} it does not bracket a \
                     displacement.",
                    with
                ),
            });
            displacement(doc, case);
        }
        (Quantity::LoadFactor, _) => collapse(doc, case),
    }
    if let Some([low, high]) = case.utilisation {
        let (a, b) = (utilisation(low, Rounding::Down), utilisation(high, Rounding::Up));
        doc.paragraph(say!("Utilisation (demand over capacity) between {} and {}.", a, b));
    }
    for (label, raw) in
        [("Frictionless", case.frictionless), ("Associated friction", case.associated)]
    {
        if let Some(raw) = raw {
            doc.paragraph(say!("{} alone: {}.", label, raw_bracket(raw)));
        }
    }
    for bolt in &case.preload {
        doc.paragraph(preload_words(bolt));
    }
    match (case.coulomb_estimate, &case.fixed_point) {
        (Some(estimate), run) => doc.paragraph(estimate_words(estimate, run.as_ref())),
        (None, Some(run)) => doc.paragraph(fixed_point_words(run)),
        (None, None) => {}
    }
    if let Some(peak) = case.peak_contact_pressure {
        let side = |name: &'static str, p: Option<f64>| {
            p.map(|p| say!("{} MPa ({})", significant(p, 3, Rounding::Nearest), name))
        };
        let sides = [side("static side", peak.static_), side("kinematic side", peak.kinematic)];
        let sides = Text::joined(", ", sides.into_iter().flatten());
        if !sides.is_empty() {
            doc.paragraph(say!("Peak contact pressure: {}; local values are estimates.", sides));
        }
    }
}

/// How close the problem of the bracket is to Coulomb's law.
fn fixed_point_words(run: &FixedPointRun) -> Text {
    let problems = match run.solves {
        1 => "one problem".into(),
        n => say!("{} problems", n),
    };
    let contraction = run.contraction.map_or_else(Text::default, |c| {
        say!("; a plain step reduces the error to {} of its size", percent_up(c))
    });
    say!(
        "Coulomb's law was reached through {}; the last one changed the slips by at most {} of \
         the largest slip{}. The bracket is strict for this last problem.",
        problems,
        percent_up(run.change),
        contraction
    )
}

fn raw_bracket(raw: RawBracket) -> Text {
    match (raw.lower, raw.upper) {
        (Some(lower), Some(Upper::Finite(upper))) => {
            let (a, b) = bracket(lower, upper, 3);
            say!("between {} and {}", a, b)
        }
        (lower, upper) => {
            let low = lower.map(|l| say!("at least {}", significant(l, 6, Rounding::Down)));
            let high = upper.map(|u| match u {
                Upper::Finite(u) => say!("at most {}", significant(u, 6, Rounding::Up)),
                Upper::Unbounded(_) => "unbounded above".into(),
            });
            Text::joined(", ", [low, high].into_iter().flatten())
        }
    }
}
