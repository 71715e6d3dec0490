//! An output folder: a result, or the files of `mesh` and `study`. It is written aside and renamed,
//! so that it is either complete or absent.
//!
//! All files go into `NAME.part` beside the target. Only [`ResultFolder::finish`] moves it into
//! place. If a run ends in any other way, the part is removed and the target is unchanged.
//!
//! An earlier result is moved to `NAME.old.part` first. Of its files only those go that its
//! `digests.b3` lists; whatever else the user put there moves into the new folder. Remains of a
//! program that was killed between these steps are put in order by the next run.

use crate::result::digests::{DIGESTS_FILE, Digests, files};
pub use crate::result::folder_error::FolderError;
use crate::result::result_file::RESULT_FILE;
use crate::result::result_file::ResultError;
use crate::result::result_file::ResultFile;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// File that marks a `.part` folder as written by this program. It is locked while a run writes
/// into the folder.
const MARKER: &str = ".bracket-run";

/// Suffix of the earlier result while the new one takes its place.
const OLD: &str = ".old.part";

/// What a folder holds, and how an earlier one is recognised.
#[derive(Clone, Copy, Debug)]
pub enum Content {
    /// A result, with a valid `result.json`.
    Result,
    /// Files of another subcommand.
    Files {
        /// The file that every such folder has.
        mark: &'static str,
        /// The subcommand.
        command: &'static str,
    },
}

fn io_error(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> FolderError {
    move |source| FolderError::Io { action, path: path.into(), source }
}

/// A result folder in progress. If it is dropped before it is finished, it leaves nothing behind.
#[derive(Debug)]
pub struct ResultFolder {
    content: Content,
    target: PathBuf,
    part: PathBuf,
    /// Parent folders created for the part, outermost first.
    parents: Vec<PathBuf>,
    /// Holds the lock on the marker.
    _lock: File,
    /// Locked while a file is written and while the folder moves into place; true once it is there.
    finished: Arc<Mutex<bool>>,
}

impl ResultFolder {
    /// Starts a result for `target`, after checking that `target` may be replaced. Call it before
    /// the work begins.
    pub fn begin(target: &Path) -> Result<Self, FolderError> {
        Self::begin_with(target, Content::Result)
    }

    /// The same for a folder with other content.
    pub fn begin_with(target: &Path, content: Content) -> Result<Self, FolderError> {
        let target = resolve(target)?;
        check_replaceable(&target, content)?;
        let part = with_suffix(&target, ".part");
        let mut parents: Vec<PathBuf> = Vec::new();
        for parent in
            target.ancestors().skip(1).take_while(|p| !p.as_os_str().is_empty() && !p.exists())
        {
            parents.insert(0, parent.into());
        }
        let result = parents
            .iter()
            .try_for_each(|p| fs::create_dir(p).map_err(io_error("create the folder", p)))
            .and_then(|()| claim(&part, &target));
        match result {
            Ok(lock) => {
                let finished = Arc::default();
                let out = Self { content, target, part, parents, _lock: lock, finished };
                // with the part in hand: no other run is about to move its own into place
                recover(&out.target)?;
                check_replaceable(&out.target, content)?;
                Ok(out)
            }
            Err(e) => {
                remove_empty(&parents);
                Err(e)
            }
        }
    }

    /// The folder that receives the files, for other programs that write files themselves.
    pub fn path(&self) -> &Path {
        &self.part
    }

    /// The final place of the result.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// Writes one file. `name` is relative to the folder (`fields/TOP_static.vtu`); sub-folders are
    /// created.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        let inside = !name.is_empty()
            && Path::new(name).components().all(|c| matches!(c, std::path::Component::Normal(_)))
            && name != MARKER;
        if !inside {
            return Err(FolderError::Name { name: name.into() });
        }
        let path = self.part.join(name);
        // whoever gives up waits for this file, and none is begun afterwards
        let _writing = self.finished.lock().unwrap_or_else(PoisonError::into_inner);
        // messages name the target, because the user does not know the part
        let shown = self.target.join(name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(io_error("create the folder of", &shown))?;
        }
        let mut file = File::create(&path).map_err(io_error("create", &shown))?;
        file.write_all(bytes).map_err(io_error("write", &shown))?;
        // some file systems report a full disk only now
        file.sync_all().map_err(io_error("write", &shown))
    }

    /// Returns a function for a process that ends right afterwards, on any thread: it removes the
    /// files written so far. A finished folder is left alone; while a folder is being moved into
    /// place, the function waits.
    pub fn give_up(&self) -> impl Fn() + Send + 'static {
        let (finished, part, parents) =
            (self.finished.clone(), self.part.clone(), self.parents.clone());
        move || {
            let finished = finished.lock().unwrap_or_else(PoisonError::into_inner);
            if !*finished {
                // files that other writers leave meanwhile remain in the part; the next run to the
                // same target removes them
                let _ = fs::remove_dir_all(&part);
                remove_empty(&parents);
            }
            // no move may begin from now on
            std::mem::forget(finished);
        }
    }

    /// Moves the folder into place and replaces an earlier result of this program.
    pub fn finish(self) -> Result<PathBuf, FolderError> {
        if let Content::Result = self.content {
            let incomplete = |why: String| FolderError::Incomplete { why };
            let text = fs::read_to_string(self.part.join(RESULT_FILE))
                .map_err(|e| incomplete(e.to_string()))?;
            ResultFile::from_json(&text).map_err(|e| incomplete(e.to_string()))?;
        }
        // held to the end, so that nobody removes the part while it is moved
        let mut finished = self.finished.lock().unwrap_or_else(PoisonError::into_inner);
        // the target may have changed during the run
        check_replaceable(&self.target, self.content)?;
        let marker = self.part.join(MARKER);
        fs::remove_file(&marker).map_err(io_error("remove", &marker))?;
        let digests = Digests::of(&self.part).map_err(io_error("read", &self.part))?;
        let list = self.part.join(DIGESTS_FILE);
        fs::write(&list, digests.text()).map_err(io_error("write", &list))?;
        let old = with_suffix(&self.target, OLD);
        let replaces = self.target.exists();
        if replaces {
            if old.exists() {
                return Err(FolderError::InTheWay { path: old });
            }
            fs::rename(&self.target, &old).map_err(io_error("replace", &self.target))?;
        }
        if let Err(source) = fs::rename(&self.part, &self.target) {
            if replaces {
                // put the earlier result back; if that fails too, it still exists under its
                // temporary name
                let _ = fs::rename(&old, &self.target);
            }
            return Err(FolderError::Io { action: "finish", path: self.target.clone(), source });
        }
        *finished = true;
        if replaces {
            // the new result is in place: failing to remove the old one must not undo that
            let _ = retire(&old, &self.target);
        }
        drop(finished);
        Ok(self.target.clone())
    }
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        if !*self.finished.lock().unwrap_or_else(PoisonError::into_inner) {
            let _ = fs::remove_dir_all(&self.part);
            remove_empty(&self.parents);
        }
    }
}

fn remove_empty(parents: &[PathBuf]) {
    for parent in parents.iter().rev() {
        // removes empty folders only, because others may have written there meanwhile
        let _ = fs::remove_dir(parent);
    }
}

/// Resolves a link or a name such as `.` to the folder itself, so that the part is beside it on the
/// same disk.
fn resolve(target: &Path) -> Result<PathBuf, FolderError> {
    if target.symlink_metadata().is_ok() && (target.is_symlink() || target.file_name().is_none()) {
        return target.canonicalize().map_err(io_error("find", target));
    }
    match target.file_name() {
        Some(_) => Ok(target.into()),
        None => Err(FolderError::Io {
            action: "create the folder",
            path: target.into(),
            source: io::Error::new(io::ErrorKind::InvalidInput, "it has no name"),
        }),
    }
}

fn with_suffix(target: &Path, suffix: &str) -> PathBuf {
    let mut name = target.file_name().unwrap_or_default().to_os_string();
    name.push(suffix);
    target.with_file_name(name)
}

/// Removes an earlier result that has been replaced. Files that it does not list are the user's:
/// they move to the same place in the new folder, with `.kept` behind the name if that is taken.
fn retire(old: &Path, target: &Path) -> io::Result<()> {
    let digests = Digests::read(old)?.unwrap_or_default();
    for name in files(old)?.into_iter().filter(|n| !digests.lists(n)) {
        let mut to = target.join(&name);
        while to.symlink_metadata().is_ok() {
            to = with_suffix(&to, ".kept");
        }
        to.parent().map_or(Ok(()), fs::create_dir_all)?;
        fs::rename(old.join(&name), to)?;
    }
    fs::remove_dir_all(old)
}

/// Completes what a program was doing when it was killed while it replaced an earlier result.
fn recover(target: &Path) -> Result<(), FolderError> {
    let old = with_suffix(target, OLD);
    // an old folder without a list is not of this program
    if !matches!(Digests::read(&old), Ok(Some(_))) {
        return Ok(());
    }
    let done = match target.symlink_metadata() {
        Ok(_) => retire(&old, target),
        Err(_) => fs::rename(&old, target),
    };
    match done {
        // another run has done it meanwhile
        Err(e) if e.kind() != io::ErrorKind::NotFound => Err(io_error("put in order", &old)(e)),
        _ => Ok(()),
    }
}

/// Checks that an existing target is a folder of this program with the content that replaces it,
/// and with the list of its files.
fn check_replaceable(target: &Path, content: Content) -> Result<(), FolderError> {
    let not_ours = |why: String| match content {
        Content::Result => FolderError::NotOurs { path: target.into(), why },
        Content::Files { command, .. } => FolderError::NotOf { path: target.into(), command, why },
    };
    match target.symlink_metadata() {
        Err(e) if matches!(e.kind(), io::ErrorKind::NotFound) => return Ok(()),
        Err(e) => return Err(io_error("look at", target)(e)),
        Ok(meta) if !meta.is_dir() => return Err(not_ours("it is not a folder".into())),
        Ok(_) => {}
    }
    match content {
        Content::Result => {
            let text =
                bracket_base::text_file::utf8_of(&target.join(RESULT_FILE)).map_err(|e| match e
                    .kind()
                {
                    io::ErrorKind::NotFound => not_ours(format!("it holds no {RESULT_FILE}")),
                    _ => not_ours(format!("its {RESULT_FILE} cannot be read: {e}")),
                })?;
            ResultFile::is_of_this_program(&text)
                .map_err(|e: ResultError| not_ours(e.to_string()))?;
        }
        // an empty folder has nothing to lose
        Content::Files { .. } if fs::read_dir(target).is_ok_and(|mut d| d.next().is_none()) => {
            return outside(target);
        }
        Content::Files { mark, .. } if !target.join(mark).is_file() => {
            return Err(not_ours(format!("it holds no {mark}")));
        }
        Content::Files { .. } => {}
    }
    match Digests::read(target) {
        Ok(Some(_)) => {}
        Ok(None) => {
            return Err(not_ours(format!(
                "without {DIGESTS_FILE} its files cannot be told from yours"
            )));
        }
        Err(e) => return Err(not_ours(format!("its {DIGESTS_FILE} cannot be read: {e}"))),
    }
    outside(target)
}

/// Refuses a target that holds the current folder.
fn outside(target: &Path) -> Result<(), FolderError> {
    if let (Ok(current), Ok(full)) = (std::env::current_dir(), target.canonicalize())
        && current.starts_with(&full)
    {
        return Err(FolderError::StandingInside { path: target.into() });
    }
    Ok(())
}

/// Creates the part folder and locks its marker. The remains of a killed run are removed first.
/// Messages name the target.
fn claim(part: &Path, target: &Path) -> Result<File, FolderError> {
    let marker = part.join(MARKER);
    if part.symlink_metadata().is_ok() {
        let lock = File::open(&marker).map_err(|_| FolderError::InTheWay { path: part.into() })?;
        match lock.try_lock() {
            Ok(()) => fs::remove_dir_all(part).map_err(io_error("remove the unfinished", part))?,
            Err(fs::TryLockError::WouldBlock) => {
                return Err(FolderError::Busy { path: part.into() });
            }
            Err(fs::TryLockError::Error(e)) => return Err(io_error("lock", &marker)(e)),
        }
    }
    fs::create_dir(part).map_err(|e| match e.kind() {
        io::ErrorKind::AlreadyExists => FolderError::Busy { path: part.into() },
        _ => io_error("create the folder", target)(e),
    })?;
    let made =
        File::create_new(&marker).and_then(|f| f.try_lock().map(|()| f).map_err(io::Error::from));
    made.map_err(|e| {
        let _ = fs::remove_dir_all(part);
        io_error("create a file in", target)(e)
    })
}
