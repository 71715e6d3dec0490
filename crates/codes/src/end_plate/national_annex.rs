//! What a national annex changes beside the partial factors, and a list of what is not covered.

use super::at_plate;
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
    let mut out: Vec<Check> = is_uk(e).then(|| british_rows(e)).into_iter().collect();
    out.extend(of_any_joint(e.annex.as_deref(), e.fy_source, &e.grade, &throats(e)));
    out
}

/// The rules that are none of rows of bolts in tension; `welds` are the fillet welds with the part,
/// the throat and the thickness of the thicker part joined \[mm\].
pub(crate) fn of_any_joint(
    annex: Option<&str>,
    fy_source: FySource,
    grade: &BoltGrade,
    welds: &[(Part, f64, f64)],
) -> Vec<Check> {
    let left_out = |clause: &'static str, words: &'static str| {
        let (place, id) =
            (Place::Annex(annex.unwrap_or_default().into()), CheckId::AnnexNotCovered);
        Check::assumption(Topic::Detailing, place, clause, id, words)
    };
    let mut out = Vec::new();
    match annex {
        None => return out,
        Some(UK) => {
            out.extend(british_strengths(fy_source));
            out.push(left_out(
                "UK NA to BS EN 1993-1-8",
                "its choices in EN 1993-1-8 3.1.1(3), bolt classes; 3.4.2(1), preload; 5.2.1(2), \
                 classification; and γ_M2 = 1.1 of net sections in EN 1993-1-1 are not covered",
            ));
        }
        Some(GERMANY) => {
            out.extend(welds.iter().filter_map(german_throat));
            out.extend(german_class(grade));
            out.push(left_out(
                "DIN EN 1993-1-8/NA",
                "its rules to EN 1993-1-8 3.1.1, galvanised bolts; 3.4.2(1), preload F_p,C* and \
                 its procedure; 4.5.3.2(6), f_u of parts above 40 mm and β_w of its own; 5.2.1(2), \
                 classification; 6.2.7.2(9), forces of the rows; are not covered",
            ));
        }
        Some(_) => out.push(left_out(
            "national annex",
            "the partial factors of the annex are used and nothing else: its choices in EN \
             1993-1-8 3.1.1(3), bolt classes; 3.4.2(1), preload; 5.2.1(2), classification; \
             6.2.7.2(9), forces of the rows; and its additional rules are not covered",
        )),
    }
    out
}

/// The rule of the annex of the United Kingdom for the forces of rows.
fn british_rows(e: &EndPlate) -> Check {
    let (clause, id) = ("UK NA to BS EN 1993-1-8, NA.2.7", CheckId::AnnexRowForces);
    let words = if triangular(e) {
        "neither end plate nor column flange is thin enough for its bolts, t ≤ (d/1.9) \
         √(f_ub/f_y): every row has at most its share of a triangle, F_tr,Rd ≤ F_t1,Rd h_r/h_1"
    } else {
        "end plate or column flange is thin enough for its bolts, t ≤ (d/1.9) √(f_ub/f_y): the \
         rows may reach their plastic forces"
    };
    Check::assumption(Topic::ComponentMethod, Part::BoltRows, clause, id, words)
}

/// A warning where the yield strengths are not those that the annex of the United Kingdom asks for.
fn british_strengths(source: FySource) -> Option<Check> {
    (source == FySource::Table31).then(|| {
        let (clause, id) = ("UK NA to BS EN 1993-1-1, NA.2.4", CheckId::AnnexYieldStrengths);
        let words = "f_y and f_u are those of Table 3.1; this annex asks for those of the product \
                     standard, which are lower above 16 mm: code.fy_source: product_standard";
        let check = Check::assumption(Topic::Detailing, Place::Annex(UK.into()), clause, id, words);
        Check { status: Status::Warning, ..check }
    })
}

/// Whether the annex of Germany excludes the class of a bolt.
fn german_class(grade: &BoltGrade) -> Option<Check> {
    GERMAN_EXCLUDED.contains(&grade.grade.as_str()).then(|| {
        let (clause, id) = ("DIN EN 1993-1-8/NA, NDP to 3.1.1(3)", CheckId::AnnexBoltClass);
        let words = say!("bolts of class {} may not be used in Germany", &grade.grade);
        let check = Check::assumption(Topic::Detailing, Part::Bolts, clause, id, words);
        Check { status: Status::Failed, binding: Binding::Beside, ..check }
    })
}

/// The fillet welds of an end-plate joint, with the thickness of the thicker part joined \[mm\].
fn throats(e: &EndPlate) -> Vec<(Part, f64, f64)> {
    let mut welds = vec![
        (Part::BeamFlange, e.flange_throat, e.beam.tf.max(e.thickness)),
        (Part::BeamWeb, e.web_throat, e.beam.tw.max(e.thickness)),
        (Part::Rib, e.rib_throat, e.rib.max(e.thickness).max(e.beam.tf)),
    ];
    if let Some(h) = at_plate::haunch(e) {
        welds.push((Part::HaunchFlange, e.flange_throat, h.flange.max(e.thickness)));
        let thicker = h.web.max(e.beam.tf);
        welds.push((Part::HaunchWeb, h.seam_throat, thicker));
        welds.push((Part::HaunchWeb, e.web_throat, h.web.max(e.thickness)));
    }
    if let Some(c) = &e.column {
        let (s, t) = (&c.section, c.stiffener.max(c.section.tf));
        welds.push((Part::Stiffeners, c.stiffener_throat, t.max(s.tw)));
        welds.push((Part::Doubler, c.doubler_throat, c.doubler.max(s.tw)));
    }
    welds.retain(|(part, ..)| match part {
        Part::Rib => e.rib > 0.0,
        Part::Stiffeners => e.column.as_ref().is_some_and(|c| c.stiffener > 0.0),
        Part::Doubler => e.column.as_ref().is_some_and(|c| c.doubler > 0.0),
        _ => true,
    });
    welds
}

/// Least throat beside the thicker of the parts that a weld joins.
///
/// # Source
/// DIN EN 1993-1-8/NA:2010, NCI to 4.5.2, formula NA.1: a ≥ √max t − 0.5, a and t in mm, t ≥ 3 mm.
/// The annex lets the welding conditions waive it, with a ≥ 5 mm for t ≥ 30 mm.
fn german_throat(&(part, a, t): &(Part, f64, f64)) -> Option<Check> {
    (a > 0.0 && t >= GERMAN_THIN).then(|| {
        let what = ("DIN EN 1993-1-8/NA, NCI to 4.5.2", CheckId::AnnexThroat);
        let rule = Traced::length("t_max", t).sqrt() - Traced::from(0.5);
        let mut check = Check::at_least((Topic::Welds, part), what, "a", rule, a, Status::Failed);
        if check.status == Status::Failed {
            let words = "welding conditions may waive it, then a ≥ 5 mm for t ≥ 30 mm";
            check.derivation.lines.push(words.into());
        }
        check
    })
}
