//! A folder of results by their keys, which several sweeps share.

use super::row::{Outcome, Record};
use super::sweep_folder::{SweepFolder, copy_folder};
use super::work_folder::{clear_work, own, work_folder};
use super::worker::{Job, RESULT, found, keep};
use bracket_base::diag::Diagnostic;
use bracket_report::console::log::Log;
use std::path::Path;

/// A cache: the folder `cases` in it holds result folders by key.
///
/// A key names spec, catalogue, template and versions. It does not name the memory and the
/// processors of a machine: the bounds of a result from elsewhere hold, and may be wider.
#[derive(Clone, Debug)]
pub struct Cache<'a> {
    folder: SweepFolder,
    log: &'a Log,
}

impl<'a> Cache<'a> {
    /// The cache at a path, which is made if it is absent.
    pub fn at(path: &Path, log: &'a Log) -> Result<Self, Box<Diagnostic>> {
        std::fs::create_dir_all(path).map_err(|e| {
            let message = format!("the cache `{}` cannot be used: {e}", path.display());
            Diagnostic::environment("sweep/cache", message)
                .help("name a folder that can be written, or leave out --cache")
        })?;
        let folder = SweepFolder::at(path);
        clear_work(&folder);
        Ok(Self { folder, log })
    }

    /// Copies the result of a job into the folder of a sweep; returns its record, or `None` if the
    /// cache does not have it.
    pub fn fetch(&self, job: &Job, into: &SweepFolder) -> Option<Record> {
        found(job, &self.folder)?;
        self.copy(&job.key, &self.folder, into);
        found(job, into)
    }

    /// Copies the result of a job, whose record is `record`, from the folder of a sweep. A result
    /// that a limit of the sweep cut short is of this sweep only.
    pub fn store(&self, job: &Job, record: &Record, from: &SweepFolder) {
        let whole = record.result && record.outcome != Outcome::TimedOut;
        if whole && found(job, &self.folder).is_none() {
            self.copy(&job.key, from, &self.folder);
        }
    }

    /// Copies a result folder aside and renames it into its place. The sweep goes on without a
    /// cache that fails.
    fn copy(&self, key: &str, from: &SweepFolder, into: &SweepFolder) {
        let work = work_folder(into, key);
        let copied = own(&work, &[std::process::id()])
            .and_then(|()| copy_folder(&from.case_folder(key), &work.join(RESULT)))
            .and_then(|()| keep(&work.join(RESULT), &into.case_folder(key)));
        let _ = std::fs::remove_dir_all(&work);
        if let Err(d) = copied {
            self.log.line(format!("cache: {}", d.message));
        }
    }
}
