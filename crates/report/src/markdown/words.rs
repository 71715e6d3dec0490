//! Names that several sections share.

use crate::result::result_file::{CaseResult, ResultFile};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::model::AnalysisKind;

/// The kind of analysis in the words of the report.
pub(crate) fn analysis_word(kind: AnalysisKind) -> &'static str {
    match kind {
        AnalysisKind::Elastic => "elastic",
        AnalysisKind::Elastoplastic => "elastic, perfectly plastic",
        AnalysisKind::Limit => "limit analysis",
    }
}

/// What a load moves, in the words of a report.
pub(crate) fn moved(what: &'static str) -> Text {
    match what {
        "displacement" => "displacement (along the load, the mean over its face)".into(),
        other => other.into(),
    }
}

/// The name of a case; in a run of several kinds of analysis with its kind.
pub(crate) fn case_title(case: &CaseResult, result: &ResultFile) -> Text {
    match result.cases.iter().all(|c| c.analysis == case.analysis) {
        true => Text::given(case.name.clone()),
        false => say!("{}, {}", &case.name, Text::from(analysis_word(case.analysis))),
    }
}
