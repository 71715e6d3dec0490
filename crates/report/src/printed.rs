//! The files around a printed report: its pictures, and how it is written.

use crate::words::Words;
use bracket_base::diag::Diagnostic;
use std::path::{Component, Path, PathBuf};

/// A picture of a result folder, drawings with `words`; `None` if there is none of this name.
pub fn picture(folder: &Path, name: &str, words: &Words) -> Option<Vec<u8>> {
    let mut parts = Path::new(name).components();
    let inside = matches!((parts.next(), parts.next()), (Some(Component::Normal(_)), None))
        && !name.contains('\\');
    let bytes =
        inside.then(|| bracket_base::text_file::bytes(&folder.join(name)).ok()).flatten()?;
    match String::from_utf8(bytes) {
        Ok(text) if name.ends_with(".svg") => Some(words.drawing(&text).into_bytes()),
        Ok(text) => Some(text.into_bytes()),
        Err(other) => Some(other.into_bytes()),
    }
}

/// The temporary name under which a file is written.
pub fn part(path: &Path) -> PathBuf {
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    part.into()
}

/// Writes a file aside and renames it, so that no half of it is ever seen.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Box<Diagnostic>> {
    let part = part(path);
    let written = std::fs::write(&part, bytes).and_then(|()| std::fs::rename(&part, path));
    written.map_err(|e| {
        let _ = std::fs::remove_file(&part);
        let message = format!("`{}` cannot be written: {e}", path.display());
        let help = "check the folder and the disk, or name another file with --out";
        Box::new(Diagnostic::environment("report/write", message).file(path).help(help))
    })
}
