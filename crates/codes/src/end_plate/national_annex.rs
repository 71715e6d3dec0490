//! What a national annex changes beside the partial factors, and a list of what is not covered.

use super::clamped_plates::clamped;
use crate::check::{Binding, Check, CheckId, Status, Topic};
use crate::ductility::{Clamped, plastic_distribution};
use crate::formula::{Number, Traced};
use crate::subject::{Part, Place};
use bracket_base::say;
use bracket_joint::assembly::EndPlate;
use bracket_joint::catalog::BoltGrade;
use bracket_joint::spec::code::FySource;

/// The catalogue's name of the annex of the United Kingdom.
const UK: &str = "UK";
/// The catalogue's name of the annex of Germany.
const GERMANY: &str = "DE";

/// Bolt classes that the German annex excludes.
const GERMAN_EXCLUDED: [&str; 3] = ["4.8", "5.8", "6.8"];

/// Thickness from which the German rule of least throats applies \[mm\].
const GERMAN_THIN: f64 = 3.0;

/// Whether the UK annex applies.
pub(super) fn is_uk(e: &EndPlate) -> bool {
    e.annex.as_deref() == Some(UK)
}

/// Whether the rows of the joint have the triangular limit of the UK annex: neither end plate nor
/// column flange is thin enough for its bolts.
///
/// # Source
/// UK National Annex to BS EN 1993-1-8, NA.2.7; SCI P398, 2.
pub(super) fn triangular(e: &EndPlate) -> bool {
    let holds = |(part, c): (Part, Clamped)| plastic_distribution(part, &c).status == Status::Ok;
    is_uk(e) && !clamped(e).any(holds)
}

/// The rules of the annex that the checks follow, and those that they leave out.
pub(super) fn checks(e: &EndPlate) -> Vec<Check> {
    match e.annex.as_deref() {
        None => Vec::new(),
        Some(UK) => british(e),
        Some(GERMANY) => german(e),
        Some(other) => vec![Check::assumption(
            Topic::Detailing,
            Place::Annex(other.into()),
            "national annex",
            CheckId::AnnexNotCovered,
            "the partial factors of the annex are used and nothing else: its choices in EN \
             1993-1-8 3.1.1(3), bolt classes; 3.4.2(1), preload; 5.2.1(2), classification; \
             6.2.7.2(9), forces of the rows; and its additional rules are not covered",
        )],
    }
}

/// The annex of the United Kingdom.
fn british(e: &EndPlate) -> Vec<Check> {
    let (clause, id) = ("UK NA to BS EN 1993-1-8, NA.2.7", CheckId::AnnexRowForces);
    let words = if triangular(e) {
        "neither end plate nor column flange is thin enough for its bolts, t ≤ (d/1.9) \
         √(f_ub/f_y): every row has at most its share of a triangle, F_tr,Rd ≤ F_t1,Rd h_r/h_1"
    } else {
        "end plate or column flange is thin enough for its bolts, t ≤ (d/1.9) √(f_ub/f_y): the \
         rows may reach their plastic forces"
    };
    let mut out =
        vec![Check::assumption(Topic::ComponentMethod, Part::BoltRows, clause, id, words)];
    if e.fy_source == FySource::Table31 {
        let (clause, id) = ("UK NA to BS EN 1993-1-1, NA.2.4", CheckId::AnnexYieldStrengths);
        let words = "f_y and f_u are those of Table 3.1; this annex asks for those of the product \
                     standard, which are lower above 16 mm: code.fy_source: product_standard";
        let check = Check::assumption(Topic::Detailing, Place::Annex(UK.into()), clause, id, words);
        out.push(Check { status: Status::Warning, ..check });
    }
    out.push(Check::assumption(
        Topic::Detailing,
        Place::Annex(UK.into()),
        "UK NA to BS EN 1993-1-8",
        CheckId::AnnexNotCovered,
        "its choices in EN 1993-1-8 3.1.1(3), bolt classes; 3.4.2(1), preload; 5.2.1(2), \
         classification; and γ_M2 = 1.1 of net sections in EN 1993-1-1 are not covered",
    ));
    out
}

/// The annex of Germany.
fn german(e: &EndPlate) -> Vec<Check> {
    let mut out = german_throats(e);
    out.extend(excluded_class(e.annex.as_deref(), &e.grade));
    out.push(Check::assumption(
        Topic::Detailing,
        Place::Annex(GERMANY.into()),
        "DIN EN 1993-1-8/NA",
        CheckId::AnnexNotCovered,
        "its rules to EN 1993-1-8 3.1.1, galvanised bolts; 3.4.2(1), preload F_p,C* and its \
         procedure; 4.5.3.2(6), f_u of parts above 40 mm and β_w of its own; 5.2.1(2), \
         classification; 6.2.7.2(9), forces of the rows; are not covered",
    ));
    out
}

/// A bolt class that an annex excludes.
pub(crate) fn excluded_class(annex: Option<&str>, grade: &BoltGrade) -> Option<Check> {
    (annex == Some(GERMANY) && GERMAN_EXCLUDED.contains(&grade.grade.as_str())).then(|| {
        let (clause, id) = ("DIN EN 1993-1-8/NA, NDP to 3.1.1(3)", CheckId::AnnexBoltClass);
        let words = say!("bolts of class {} may not be used in Germany", &grade.grade);
        let check = Check::assumption(Topic::Detailing, Part::Bolts, clause, id, words);
        Check { status: Status::Failed, binding: Binding::Beside, ..check }
    })
}

/// Least throats beside the thicker of the parts that a weld joins.
///
/// # Source
/// DIN EN 1993-1-8/NA:2010, NCI to 4.5.2, formula NA.1: a ≥ √max t − 0.5, a and t in mm, t ≥ 3 mm.
/// The annex lets the welding conditions waive it, with a ≥ 5 mm for t ≥ 30 mm.
fn german_throats(e: &EndPlate) -> Vec<Check> {
    let mut welds = vec![
        (Part::BeamFlange, e.flange_throat, e.beam.tf.max(e.thickness)),
        (Part::BeamWeb, e.web_throat, e.beam.tw.max(e.thickness)),
        (Part::Rib, e.rib_throat, e.rib.max(e.thickness).max(e.beam.tf)),
    ];
    if let Some(c) = &e.column {
        let (s, t) = (&c.section, c.stiffener.max(c.section.tf));
        welds.push((Part::Stiffeners, c.stiffener_throat, t.max(s.tw)));
        welds.push((Part::Doubler, c.doubler_throat, c.doubler.max(s.tw)));
    }
    let there = |(part, a, t): (Part, f64, f64)| {
        let exists = match part {
            Part::Rib => e.rib > 0.0,
            Part::Stiffeners => e.column.as_ref().is_some_and(|c| c.stiffener > 0.0),
            Part::Doubler => e.column.as_ref().is_some_and(|c| c.doubler > 0.0),
            _ => true,
        };
        (exists && a > 0.0 && t >= GERMAN_THIN).then(|| {
            let what = ("DIN EN 1993-1-8/NA, NCI to 4.5.2", CheckId::AnnexThroat);
            let rule = Traced::length("t_max", t).sqrt() - Traced::from(0.5);
            let mut check =
                Check::at_least((Topic::Welds, part), what, "a", rule, a, Status::Failed);
            if check.status == Status::Failed {
                let words = "welding conditions may waive it, then a ≥ 5 mm for t ≥ 30 mm";
                check.derivation.lines.push(words.into());
            }
            check
        })
    };
    welds.into_iter().filter_map(there).collect()
}
