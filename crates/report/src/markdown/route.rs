//! The route of analysis: its steps with what they show, and their largest values.

use crate::document::Doc;
use crate::document::table::{Table, bold, dash};
use crate::figures::{Rounding, percent, significant, utilisation};
use crate::result::case_result::CaseResult;
use crate::result::quantity::Quantity;
use crate::result::result_file::ResultFile;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::route::{LARGEST_STRAIN, PlateStrain, RouteStep, RouteUse, StepState};
use bracket_codes::unit::number;
use bracket_codes::verdict::{Route, Verdict};

/// The section of the report.
pub(crate) fn section(doc: &mut Doc, result: &ResultFile) {
    if !shown(result).is_empty() {
        doc.heading("Route of analysis");
        steps(doc, result);
    }
}

/// The load cases with their steps.
fn shown(result: &ResultFile) -> Vec<(&CaseResult, &[RouteStep])> {
    result.cases.iter().filter_map(|c| Some((c, of_case(c, result)?))).collect()
}

/// The steps of each load case; none where the code's route decides and nothing was measured for
/// that of analysis.
pub(crate) fn steps(doc: &mut Doc, result: &ResultFile) {
    let shown = shown(result);
    if shown.is_empty() {
        return;
    }
    doc.paragraph(
        "Where the code has no method for the joint, these steps together stand for one. A step \
         that is proved rests on a bound or on a rule; one that is estimated rests on numbers \
         without a proven error, with the difference between two fields or two meshes added.",
    );
    for (case, steps) in shown {
        doc.paragraph(say!("{}:", &case.name));
        doc.table(&Table::new(
            ["step", "", "utilisation", "finding", "clause"],
            steps.iter().map(step_row),
        ));
        let uses = steps.iter().filter(|s| s.uses.len() > 1).flat_map(|s| s.uses.iter().take(4));
        let rows: Vec<_> = uses.map(use_row).collect();
        if !rows.is_empty() {
            let columns = ["largest values", "value", "difference in it", "limit", "utilisation"];
            doc.table(&Table::new(columns, rows));
        }
        strains(doc, result, &case.name);
        let open = steps
            .iter()
            .filter(|s| !s.holds())
            .filter_map(|s| Some(say!("{}: {}", Text::from(s.step.title()), s.next.clone()?)));
        let open: Vec<Text> = open.collect();
        if !open.is_empty() {
            doc.paragraph(say!("What would close the open steps: {}.", Text::joined("; ", open)));
        }
    }
}

/// The steps of a case, where they matter: they decide, they are measured, or nothing else decides.
fn of_case<'a>(case: &'a CaseResult, result: &ResultFile) -> Option<&'a [RouteStep]> {
    let demand = case.demand.as_ref().filter(|d| !d.steps.is_empty())?;
    let measured = result.cases.iter().any(|c| c.name == case.name && c.evidence.is_some());
    let matters = demand.route == Some(Route::Analysis) || demand.verdict == Verdict::Undecided;
    // each load case once, beside its limit analysis
    let limit = case.quantity == Quantity::LoadFactor;
    (limit && (measured || matters)).then_some(&demand.steps[..])
}

/// The largest strains of each part on the last mesh, by thickness: flanges and webs are apart.
fn strains(doc: &mut Doc, result: &ResultFile, name: &str) {
    let evidence = result.cases.iter().filter(|c| c.name == name).find_map(|c| c.evidence.as_ref());
    let mut largest: Vec<&PlateStrain> = Vec::new();
    for plate in evidence.iter().flat_map(|e| &e.plates) {
        let same = |p: &&mut &PlateStrain| p.part == plate.part && p.thickness == plate.thickness;
        match largest.iter_mut().find(same) {
            Some(kept) if plate.membrane > kept.membrane => *kept = plate,
            Some(_) => {}
            None => largest.push(plate),
        }
    }
    if largest.is_empty() {
        return;
    }
    largest.sort_by(|a, b| b.membrane.total_cmp(&a.membrane));
    doc.paragraph(say!(
        "Largest strains of the plates on the last mesh. The membrane strain is the largest \
         principal strain, as the mean over a prism of the plate's thickness, elastic strain \
         included; {} % are allowed. The strain at a surface is equivalent plastic strain, as the \
         mean over the outer quarter of such a prism, and is no part of the check:",
        number(100.0 * LARGEST_STRAIN)
    ));
    let columns = [
        "part",
        "thickness [mm]",
        "membrane strain [%]",
        "at x, y, z [mm]",
        "plastic strain at a surface [%]",
        "at x, y, z [mm]",
    ];
    let at = |x: [f64; 3]| x.map(|x| significant(x, 3, Rounding::Nearest)).join(", ");
    let row = |p: &&PlateStrain| {
        let thickness = number(p.thickness);
        let (membrane, surface) = (percent(p.membrane), percent(p.surface));
        [p.part.clone(), thickness, membrane, at(p.membrane_at), surface, at(p.surface_at)]
            .map(Text::from)
    };
    doc.table(&Table::new(columns, largest.iter().map(row)));
}

fn step_row(s: &RouteStep) -> [Text; 5] {
    let state = match s.state {
        StepState::Proved => "proved".into(),
        StepState::Estimated => "estimated".into(),
        StepState::Open => bold("open"),
    };
    let used = s.utilisation.map_or_else(dash, used);
    [s.step.title().into(), state, used, s.finding.clone(), s.source.clone()]
}

fn use_row(u: &RouteUse) -> [Text; 5] {
    let show = |x: f64| Text::from(u.unit.show(x));
    let spread = u.spread.map_or_else(dash, show);
    [u.what.clone(), show(u.value), spread, show(u.limit), used(u.utilisation())]
}

fn used(value: f64) -> Text {
    utilisation(value, Rounding::Up).into()
}
