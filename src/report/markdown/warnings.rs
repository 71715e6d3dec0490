//! The section with all warnings.

use crate::checks::{Status, Topic};
use crate::report::markdown::markup::{heading, inline};
use crate::report::markdown::report_data::ReportData;

pub(crate) fn warnings(page: &mut String, data: &ReportData) {
    let all = all_warnings(data);
    if !all.is_empty() {
        heading(page, "Warnings");
        for warning in all {
            page.push_str(&format!("- {}\n", inline(&warning)));
        }
        page.push('\n');
    }
}

/// All warnings, a sentence each.
pub(crate) fn all_warnings(data: &ReportData) -> Vec<String> {
    let of_cases = data
        .result
        .cases
        .iter()
        .flat_map(|c| c.warnings.iter().map(move |w| format!("{}: {w}", c.name)));
    let detailing = data
        .result
        .checks
        .iter()
        .filter(|c| c.topic == Topic::Detailing && c.status == Status::Warning);
    let detailing = detailing.map(|c| format!("detailing: {}", c.sentence()));
    data.result.warnings.iter().cloned().chain(detailing).chain(of_cases).collect()
}
