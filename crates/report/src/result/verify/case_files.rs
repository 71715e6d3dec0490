//! The files of a case in a result folder.

use crate::result::result_file::CaseResult;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_engine::model::AnalysisModel;
use std::path::{Path, PathBuf};

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
    /// End of the names of its field files: that of a load step, or empty.
    pub suffix: &'a str,
    /// Whether the fields of the kinematic and of the static program, and of the static one without
    /// friction, are on this model's mesh.
    pub wanted: [bool; 3],
}

impl CaseFiles<'_> {
    /// True if there is a field file of this kind.
    pub fn has(&self, kind: &str) -> bool {
        self.path(kind).exists()
    }

    /// The claimed value of a bound; NaN, which no field gives, if there is a field and no claim.
    pub fn claim(&self, claimed: Option<f64>, kind: &str) -> Option<f64> {
        claimed.or(self.has(kind).then_some(f64::NAN))
    }

    fn path(&self, kind: &str) -> PathBuf {
        self.folder.join("fields").join(format!("{}_{kind}{}.vtu", self.stem, self.suffix))
    }

    /// The bytes of a field file.
    pub fn field(&self, kind: &str) -> Result<Vec<u8>, Diagnostics> {
        read(&self.path(kind))
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
