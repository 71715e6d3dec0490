//! Names of the files that a result folder holds for a case.

use crate::result::result_file::CaseResult;
use bracket_engine::model::AnalysisKind;

/// Kind of the field file with the stress of the live loads alone, which proves that the load
/// factor has no limit.
pub const LIVE_FIELD: &str = "static_live";
/// Kind of the field file with the stress of the dead loads alone, beside [`LIVE_FIELD`].
pub const DEAD_FIELD: &str = "static_dead";

/// End of the names of the field files of a load step, which are counted from 1.
pub fn step_suffix(number: usize) -> String {
    format!("_step{number}")
}

/// The stem of the files of an entry. It is the stem of the case; the kind of analysis is added if
/// an earlier entry has the same case.
pub fn entry_stem(earlier: &[CaseResult], entry: &CaseResult) -> String {
    stem_of(&entry.name, entry.analysis, earlier.iter().any(|c| c.name == entry.name))
}

/// The stem of the files of a case. `again` means that an earlier analysis has the same case.
pub fn stem_of(case: &str, analysis: AnalysisKind, again: bool) -> String {
    if again { format!("{}_{}", file_stem(case), analysis.word()) } else { file_stem(case) }
}

/// A file name made from the name of a case, short enough for every file system.
pub fn file_stem(case: &str) -> String {
    case.chars()
        .take(100)
        .map(|c| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' })
        .collect()
}
