//! The output folder of `mesh` and `study`. It is filled under a temporary name and then renamed;
//! it is removed if anything fails.

use crate::diag::{Diagnostic, Diagnostics};
use crate::mesh::mesher_error::MesherError;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// An output folder that appears only when it is complete.
pub struct Folder {
    wanted: PathBuf,
    /// The temporary folder that receives the files.
    pub aside: PathBuf,
    /// Locked while the folder moves into place.
    moving: Arc<Mutex<()>>,
}

impl Folder {
    /// Starts a folder. An existing folder is replaced only if it is empty or contains the file
    /// `mark`. `command` is the subcommand that writes it.
    pub fn new(wanted: &Path, mark: &str, command: &str) -> Result<Self, Diagnostics> {
        let free = match std::fs::read_dir(wanted) {
            Ok(mut entries) => entries.next().is_none() || wanted.join(mark).exists(),
            Err(_) => !wanted.exists(),
        };
        if !free {
            return Err(Diagnostic::input(
                "cli/out-exists",
                format!("`{}` exists and was not written by `bracket {command}`", wanted.display()),
            )
            .help("choose another folder with `--out`, or remove this one")
            .into());
        }
        let mut name = wanted.file_name().unwrap_or("out".as_ref()).to_os_string();
        name.push(format!(".part{}", std::process::id()));
        let aside = wanted.with_file_name(name);
        std::fs::create_dir_all(&aside).map_err(|e| MesherError::write(&aside, e))?;
        Ok(Folder { wanted: wanted.to_path_buf(), aside, moving: Arc::default() })
    }

    /// Returns a function that removes the files written so far. It is for a program that ends
    /// right afterwards, on any thread.
    pub fn give_up(&self) -> impl Fn() + Send + 'static {
        let (aside, moving) = (self.aside.clone(), self.moving.clone());
        move || {
            // the lock is never released, so that no move can begin from now on
            std::mem::forget(moving.lock().unwrap_or_else(PoisonError::into_inner));
            let _ = std::fs::remove_dir_all(&aside);
        }
    }

    /// Moves the folder into place.
    pub fn finish(self) -> Result<(), MesherError> {
        let _moving = self.moving.lock().unwrap_or_else(PoisonError::into_inner);
        if self.wanted.exists() {
            std::fs::remove_dir_all(&self.wanted)
                .map_err(|e| MesherError::write(&self.wanted, e))?;
        }
        std::fs::rename(&self.aside, &self.wanted).map_err(|e| MesherError::write(&self.wanted, e))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // after `finish` nothing is left to remove
        let _ = std::fs::remove_dir_all(&self.aside);
    }
}
