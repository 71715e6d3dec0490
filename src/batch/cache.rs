//! A folder of results by their keys, which several sweeps share.

use super::row::Record;
use super::sweep_folder::{SweepFolder, copy_folder, unique};
use super::worker::{Job, found, keep};
use crate::diag::Diagnostic;
use std::path::Path;

/// A cache: the folder `cases` in it holds result folders by key. A key names all that a result
/// depends on, so a result is never out of date.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: SweepFolder,
}

impl Cache {
    /// The cache at a path, which may be absent.
    pub fn at(path: &Path) -> Self {
        Self { folder: SweepFolder::at(path) }
    }

    /// Copies the result of a job into the folder of a sweep; returns its record, or `None` if the
    /// cache does not have it.
    pub fn fetch(&self, job: &Job, into: &SweepFolder) -> Result<Option<Record>, Box<Diagnostic>> {
        if found(job, &self.folder).is_none() {
            return Ok(None);
        }
        copy(&job.key, &self.folder, into)?;
        Ok(found(job, into))
    }

    /// Copies the result of a job from the folder of a sweep, if there is one and the cache does
    /// not have it.
    pub fn store(&self, job: &Job, from: &SweepFolder) -> Result<(), Box<Diagnostic>> {
        match (found(job, from), found(job, &self.folder)) {
            (Some(_), None) => copy(&job.key, from, &self.folder),
            _ => Ok(()),
        }
    }
}

/// Copies a result folder aside and renames it into its place.
fn copy(key: &str, from: &SweepFolder, into: &SweepFolder) -> Result<(), Box<Diagnostic>> {
    let work = into.path().join("work").join(format!("{key}.{}", unique()));
    let copied = copy_folder(&from.case_folder(key), &work)
        .and_then(|()| keep(&work, &into.case_folder(key)));
    let _ = std::fs::remove_dir_all(&work);
    copied
}
