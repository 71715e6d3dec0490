//! The files of a case in a result folder.

use crate::diag::{Diagnostic, Diagnostics};
use crate::model::AnalysisModel;
use crate::result::result_file::CaseResult;
use std::path::Path;

/// Number of random points at which a field is sampled.
pub const POINTS: usize = 10_000;

/// A case of a result folder with a model of it.
pub struct CaseFiles<'a> {
    /// The model.
    pub model: &'a AnalysisModel,
    /// The entry of the result.
    pub case: &'a CaseResult,
    /// The result folder.
    pub folder: &'a Path,
    /// Stem of the file names.
    pub stem: &'a str,
    /// Whether the fields of the kinematic and of the static program, and of the static one without
    /// friction, are on this model's mesh.
    pub wanted: [bool; 3],
}

impl CaseFiles<'_> {
    /// The bytes of a field file.
    pub fn field(&self, kind: &str) -> Result<Vec<u8>, Diagnostics> {
        read(&self.folder.join("fields").join(format!("{}_{kind}.vtu", self.stem)))
    }
}

/// Reads a file of a result folder.
pub fn read(path: &Path) -> Result<Vec<u8>, Diagnostics> {
    std::fs::read(path).map_err(|e| {
        Diagnostic::input("verify/read", format!("`{}` cannot be read: {e}", path.display()))
            .file(path)
            .help(
                "name the folder of a finished result, as `bracket run` or `bracket analyse` left \
                 it",
            )
            .into()
    })
}
