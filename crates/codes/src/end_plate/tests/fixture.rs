//! Specs and look-ups that the tests of the end plate share.

use crate::check::Check;
use crate::design_code::build;
use crate::end_plate::{HandChecks, hand_checks};
use bracket_base::diag::Diagnostics;
use bracket_base::yaml;
use bracket_joint::assembly::Facts;
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::ConnectionSpec;
use std::path::Path;

pub(super) const PAPER: &str = include_str!("../../../../../examples/paper_joint/joint.yaml");
pub(super) const TEMPLATE: &str =
    include_str!("../../../../../templates/double_sided_end_plate.yaml");

pub(super) fn of_spec(text: &str, base: &Path) -> Result<HandChecks, Diagnostics> {
    let spec = yaml::parse::<ConnectionSpec>(text, Path::new("joint.yaml"))?;
    let joint = build(&spec, base, &Catalog::builtin().expect("the shipped catalogue is sound"))?;
    Ok(joint.facts.as_ref().and_then(Facts::end_plate).map(hand_checks).unwrap_or_default())
}

pub(super) fn checks(text: &str) -> HandChecks {
    of_spec(text, Path::new(".")).unwrap_or_else(|faults| panic!("{faults:#?}"))
}

/// The notes in English.
pub(super) fn notes(h: &HandChecks) -> Vec<String> {
    h.notes.iter().map(ToString::to_string).collect()
}

/// The paper's spec with one piece of text replaced.
pub(super) fn with(old: &str, new: &str) -> String {
    assert_eq!(PAPER.matches(old).count(), 1, "`{old}`");
    PAPER.replace(old, new)
}

pub(super) fn find<'a>(h: &'a HandChecks, subject: &str, title: &str) -> &'a Check {
    let found = h
        .checks
        .iter()
        .find(|c| c.subject.to_string().starts_with(subject) && c.id().title() == title);
    found.unwrap_or_else(|| panic!("no `{title}` of `{subject}` in {:#?}", h.checks))
}

/// A one-sided joint with the given loads.
pub(super) fn loaded(loads: &str) -> HandChecks {
    checks(&joint("", loads))
}

/// A one-sided joint; the column has stiffeners unless `more` says otherwise.
pub(super) fn joint(more: &str, loads: &str) -> String {
    let stiffened = "column_stiffeners: true, column_stiffener_thickness: 10.7";
    let more = match more {
        m if m.contains("column_stiffeners") => m.to_owned(),
        "" => stiffened.to_owned(),
        m => format!("{stiffened}, {m}"),
    };
    format!(
        "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB200, steel: S235}}, \
         beam: {{profile: IPE300, steel: S235}}}}\nplate: {{thickness: 15}}\nbolts: {{size: M20, \
         grade: \"8.8\", rows: [-90, 90, 190]}}\nparameters: {{{more}}}\nloads: [{loads}]\n"
    )
}

pub(super) fn used(c: &Check) -> f64 {
    c.utilisation.unwrap_or(f64::NAN)
}

pub(super) fn step(c: &Check, symbol: &str) -> f64 {
    c.values.iter().find(|s| s.symbol == symbol).map_or(f64::NAN, |s| s.value)
}

pub(super) fn near(a: f64, b: f64, part: f64) {
    assert!((a / b - 1.0).abs() < part, "{a} is not {b}");
}

/// IPE300 on HEB200, S235, M20 8.8; welds of 6 and 4 mm.
pub(super) fn welded(loads: &str) -> HandChecks {
    checks(&joint("flange_weld: 6, web_weld: 4", loads))
}

pub(super) const ONE: &str = "{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}";

/// The same joint with the given bolts, additional entries and loads.
pub(super) fn bolted(bolts: &str, more: &str, loads: &str) -> String {
    let text = joint(more, loads).replace("size: M20, grade: \"8.8\",", &format!("{bolts},"));
    format!("{text}friction: {{mu: 0.2}}\n")
}
