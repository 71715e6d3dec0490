//! The digests of a result folder: `digests.b3` holds the BLAKE3 hash and the name of every other
//! file that the run wrote, one a line, as the program `b3sum` writes and checks them.
//!
//! The list says which files belong to the result, and `verify` refutes a file that has changed.

use bracket_base::text_file;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

/// Name of the file inside a result folder.
pub const DIGESTS_FILE: &str = "digests.b3";

/// Hashes of files by their names relative to the folder, with `/` between folders.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Digests(BTreeMap<String, String>);

impl Digests {
    /// The digests of all files in a folder except the list itself.
    pub fn of(folder: &Path) -> io::Result<Self> {
        let mut out = Self::default();
        for name in files(folder)? {
            let hash = hash_of(&folder.join(&name))?;
            out.0.insert(name, hash);
        }
        Ok(out)
    }

    /// Reads the list of a folder; `None` if it has none.
    pub fn read(folder: &Path) -> io::Result<Option<Self>> {
        match text_file::utf8_of(&folder.join(DIGESTS_FILE)) {
            Ok(text) => Self::parse(&text).map(Some).ok_or_else(|| {
                io::Error::new(io::ErrorKind::InvalidData, "it is no list of digests")
            }),
            Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(e),
        }
    }

    fn parse(text: &str) -> Option<Self> {
        let line = |l: &str| {
            let (hash, name) = l.split_once("  ")?;
            let whole = hash.len() == 64 && hash.bytes().all(|b| b.is_ascii_hexdigit());
            (whole && !name.is_empty()).then(|| (name.to_string(), hash.to_string()))
        };
        text.lines().map(line).collect::<Option<_>>().map(Self)
    }

    /// Text of the file.
    pub fn text(&self) -> String {
        self.0.iter().map(|(name, hash)| format!("{hash}  {name}\n")).collect()
    }

    /// Stores the digest of a file.
    pub fn set(&mut self, name: &str, bytes: &[u8]) {
        self.0.insert(name.into(), blake3::hash(bytes).to_hex().to_string());
    }

    /// True if the list has a file of this name, or is it itself.
    pub fn lists(&self, name: &str) -> bool {
        name == DIGESTS_FILE || self.0.contains_key(name)
    }

    /// What is wrong with a file of a folder: it is not listed, missing or has changed.
    pub fn difference(&self, folder: &Path, name: &str) -> Option<String> {
        let Some(hash) = self.0.get(name) else {
            return Some(format!("{DIGESTS_FILE} does not list {name}"));
        };
        match hash_of(&folder.join(name)) {
            Ok(found) if found == *hash => None,
            Ok(_) => Some(format!("{name} is not the file that the run wrote: its digest differs")),
            Err(e) => Some(format!("{name} is in {DIGESTS_FILE} and cannot be read: {e}")),
        }
    }

    /// A sentence for every listed file of a folder that is missing or has changed.
    pub fn differences(&self, folder: &Path) -> Vec<String> {
        self.0.keys().filter_map(|name| self.difference(folder, name)).collect()
    }
}

/// The hash of a regular file, however large.
fn hash_of(path: &Path) -> io::Result<String> {
    let mut hasher = blake3::Hasher::new();
    hasher.update_reader(text_file::regular(path)?)?;
    Ok(hasher.finalize().to_hex().to_string())
}

/// Names of all files in a folder and its sub-folders except the list of digests.
pub fn files(folder: &Path) -> io::Result<Vec<String>> {
    let mut out = Vec::new();
    let mut open = vec![String::new()];
    while let Some(within) = open.pop() {
        for entry in fs::read_dir(folder.join(&within))? {
            let entry = entry?;
            let name = format!("{within}{}", entry.file_name().to_string_lossy());
            // a link is a file of its own, whatever it leads to
            if entry.file_type()?.is_dir() {
                open.push(format!("{name}/"));
            } else if name != DIGESTS_FILE {
                out.push(name);
            }
        }
    }
    out.sort();
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_and_a_missing_file_are_found() {
        let dir = tempfile::tempdir().expect("a folder");
        let path = dir.path();
        fs::create_dir(path.join("fields")).expect("made");
        for name in ["a.txt", "b.txt", "fields/c.vtu"] {
            fs::write(path.join(name), name).expect("written");
        }
        let digests = Digests::of(path).expect("read");
        fs::write(path.join(DIGESTS_FILE), digests.text()).expect("written");
        assert_eq!(Digests::read(path).expect("read").as_ref(), Some(&digests));
        assert_eq!(Digests::of(path).expect("read"), digests, "without itself");
        assert!(digests.differences(path).is_empty());
        assert!(digests.lists("fields/c.vtu") && !digests.lists("notes.txt"));
        fs::write(path.join("a.txt"), "A").expect("written");
        fs::remove_file(path.join("fields/c.vtu")).expect("removed");
        let found = digests.differences(path);
        assert!(found.len() == 2 && found[0].starts_with("a.txt is not"), "{found:?}");
        assert!(found[1].starts_with("fields/c.vtu is in digests.b3"), "{found:?}");
        // b3sum of the empty file
        let mut of_nothing = Digests::default();
        of_nothing.set("x", b"");
        let hash = "af1349b9f5f9a1a6a0404dea36dcc9499bcb25c9adc112b7cc9a93cae41f3262";
        assert_eq!(of_nothing.text(), format!("{hash}  x\n"));
        // a device has no end, and no digest
        #[cfg(unix)]
        {
            fs::remove_file(path.join("b.txt")).expect("removed");
            std::os::unix::fs::symlink("/dev/zero", path.join("b.txt")).expect("linked");
            let found = digests.differences(path);
            assert!(found[1].contains("it is not a regular file"), "{found:?}");
        }
        fs::write(path.join(DIGESTS_FILE), "nothing\n").expect("written");
        assert!(Digests::read(path).is_err());
    }
}
