//! A connection spec as a caller gives it: its text, its place, and what holds in place of it.

use crate::driver::overrides::Overrides;
use crate::driver::spec_file::{self, SpecFile};
use bracket_base::diag::Diagnostics;
use std::path::{Path, PathBuf};

/// A connection spec that is to be checked or analysed.
#[derive(Clone, Debug, Default)]
pub struct SpecInput {
    /// Text of the spec.
    pub text: String,
    /// File of the text: messages name it, and paths within the text start from its folder. A text
    /// that is in no file may have any name here.
    pub path: PathBuf,
    /// Catalogue folder that takes precedence over that of the spec.
    pub catalog: Option<PathBuf>,
    /// What holds in place of `analysis` in the spec.
    pub overrides: Overrides,
}

impl SpecInput {
    /// The spec with this text. Paths within it start from the current folder.
    pub fn new(text: impl Into<String>) -> Self {
        Self { text: text.into(), path: "joint.yaml".into(), ..Self::default() }
    }

    /// The spec in a file.
    pub fn read(path: &Path) -> Result<Self, Diagnostics> {
        let text = spec_file::text(path)?;
        Ok(Self { text, path: path.into(), ..Self::default() })
    }

    /// Parses the spec and builds its joint.
    pub fn open(&self) -> Result<SpecFile, Diagnostics> {
        spec_file::parse(&self.text, &self.path, self.catalog.as_deref())
    }
}
