//! The section with all warnings.

use crate::document::Doc;
use crate::markdown::report_data::ReportData;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::{Check, Status, Topic};

pub(crate) fn warnings(doc: &mut Doc, data: &ReportData) {
    let all = all_warnings(data);
    if !all.is_empty() {
        doc.heading("Warnings");
        doc.list(all);
    }
}

/// All warnings, a sentence each.
pub(crate) fn all_warnings(data: &ReportData) -> Vec<Text> {
    let mut out = data.result.warnings.clone();
    out.extend(detailing(&data.result.checks));
    // what several cases have in common is one warning
    let mut of_cases: Vec<(&Text, Vec<&str>)> = Vec::new();
    for case in &data.result.cases {
        for warning in &case.warnings {
            match of_cases.iter_mut().find(|(w, _)| *w == warning) {
                Some((_, cases)) => cases.push(&case.name),
                None => of_cases.push((warning, vec![&case.name])),
            }
        }
    }
    for (_, cases) in &mut of_cases {
        cases.dedup();
    }
    out.extend(of_cases.into_iter().map(|(w, cases)| say!("{}: {}", cases.join(", "), w)));
    out
}

/// The warnings of detailing: a sentence for each rule, with the place that breaks it most and the
/// other ones by name.
fn detailing(checks: &[Check]) -> Vec<Text> {
    let used = |c: &Check| c.utilisation.unwrap_or(f64::INFINITY);
    let broken = |c: &&Check| c.topic == Topic::Detailing && c.status == Status::Warning;
    let mut rules: Vec<Vec<&Check>> = Vec::new();
    for c in checks.iter().filter(broken) {
        match rules.iter_mut().find(|r| (&r[0].title, &r[0].clause) == (&c.title, &c.clause)) {
            Some(places) => places.push(c),
            None => rules.push(vec![c]),
        }
    }
    let sentence = |places: Vec<&Check>| {
        let worst = places.iter().copied().reduce(|a, b| if used(b) > used(a) { b } else { a })?;
        let rest = places.iter().filter(|c| c.subject != worst.subject);
        let rest = Text::joined("; ", rest.map(|c| c.subject.text()));
        Some(match rest.is_empty() {
            true => say!("detailing: {}", worst.sentence()),
            false => say!("detailing: {}; less so at: {}", worst.sentence(), rest),
        })
    };
    rules.into_iter().filter_map(sentence).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_codes::eurocode::spacing::wrench_check;
    use bracket_codes::subject::{Part, Place, Subject};

    /// An M24 joint whose rows, webs and stiffeners are all near to bolts breaks one rule of
    /// practice, not six.
    #[test]
    fn a_rule_is_one_warning_wherever_it_is_broken() {
        let check = |place, room| wrench_check(place, room, 24.0);
        let row = |z| Subject::from(Place::Rows(vec![z]));
        let places =
            [(row(90.0), 40.0), (Part::BeamWeb.into(), 30.0), (Part::ColumnWeb.into(), 45.0)];
        let mut checks: Vec<Check> = places.into_iter().map(|(p, room)| check(p, room)).collect();
        checks.push(check(row(10.0), 80.0));
        let said = detailing(&checks);
        assert_eq!(said.len(), 1, "{said:?}");
        assert_eq!(
            said[0],
            "detailing: beam web: spanner clearance: c = 30 mm < 2 d + 5 = 2 · 24 + 5 = 53 mm \
             (practice); less so at: row at z = 90 mm; column web"
        );
        assert!(detailing(&checks[3..]).is_empty());
    }
}
