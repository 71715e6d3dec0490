//! Names that several sections share.

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
