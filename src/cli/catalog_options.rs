//! `--catalog`, for every command that reads a spec.

use std::path::{Path, PathBuf};

/// The folder of the user's own catalogue tables.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct CatalogOptions {
    /// Add the tables of your own folder to the built-in catalogue; in place of `catalog` in the
    /// spec.
    #[arg(long, value_name = "DIR")]
    pub catalog: Option<PathBuf>,
}

impl CatalogOptions {
    /// The folder, if one is given.
    pub fn folder(&self) -> Option<&Path> {
        self.catalog.as_deref()
    }
}
