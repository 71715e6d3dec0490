//! Names that several sections share.

use bracket_engine::model::AnalysisKind;

/// The kind of analysis in the words of the report.
pub(crate) fn analysis_word(kind: AnalysisKind) -> &'static str {
    match kind {
        AnalysisKind::Elastic => "elastic",
        AnalysisKind::Elastoplastic => "elastic, perfectly plastic",
        AnalysisKind::Limit => "limit analysis",
    }
}
