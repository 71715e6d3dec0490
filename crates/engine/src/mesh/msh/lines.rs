//! Lines, words and numbers of a gmsh file, with their line numbers.

use crate::mesh::error::{MeshError, MshPlace};
use std::path::Path;
use std::str::FromStr;

/// A reader of lines that counts them for messages.
pub(super) struct Lines<'a> {
    rest: &'a str,
    file: &'a Path,
    section: &'a str,
    line: usize,
}

/// The words of one line.
pub(super) struct Words<'a> {
    rest: &'a str,
    whole: &'a str,
    file: &'a Path,
    section: &'a str,
    line: usize,
}

impl<'a> Lines<'a> {
    pub fn new(text: &'a str, file: &'a Path) -> Self {
        Self { rest: text, file, section: "", line: 0 }
    }

    /// Number of remaining bytes, an upper limit for every count in the file.
    pub fn left(&self) -> usize {
        self.rest.len()
    }

    /// Place of the line read last.
    pub fn at(&self) -> MshPlace {
        MshPlace { file: self.file.to_path_buf(), line: self.line }
    }

    pub fn line(&self) -> usize {
        self.line
    }

    fn next_line(&mut self) -> Option<&'a str> {
        if self.rest.is_empty() {
            return None;
        }
        let (line, rest) = self.rest.split_once('\n').unwrap_or((self.rest, ""));
        self.rest = rest;
        self.line += 1;
        Some(line.trim())
    }

    /// The next line inside a section.
    pub fn words(&mut self) -> Result<Words<'a>, MeshError> {
        loop {
            match self.next_line() {
                None => {
                    return Err(MeshError::Truncated {
                        at: self.at(),
                        section: self.section.to_string(),
                    });
                }
                Some("") => {}
                Some(l) => {
                    return Ok(Words {
                        rest: l,
                        whole: l,
                        file: self.file,
                        section: self.section,
                        line: self.line,
                    });
                }
            }
        }
    }

    /// The name of the next section. Its `$End` must be read with [`Lines::end`] or
    /// [`Lines::skip`].
    pub fn section(&mut self) -> Result<Option<&'a str>, MeshError> {
        loop {
            match self.next_line() {
                None => return Ok(None),
                Some("") => {}
                Some(l) => match l.strip_prefix('$') {
                    Some(name) if !name.starts_with("End") => {
                        self.section = name;
                        return Ok(Some(name));
                    }
                    // gmsh skips lines between sections; here a stray line is an error, because it
                    // indicates a wrong count in the section before it
                    _ => return Err(self.malformed("the start of a section", l)),
                },
            }
        }
    }

    /// Reads `$EndName`.
    pub fn end(&mut self) -> Result<(), MeshError> {
        let words = self.words()?;
        if words.whole.strip_prefix("$End") == Some(self.section) {
            Ok(())
        } else {
            Err(self.malformed("the end of the section", words.whole))
        }
    }

    /// Skips to `$EndName`.
    pub fn skip(&mut self) -> Result<(), MeshError> {
        while self.words()?.whole.strip_prefix("$End") != Some(self.section) {}
        Ok(())
    }

    pub fn malformed(&self, expected: &'static str, found: &str) -> MeshError {
        let found = found.chars().take(40).collect();
        MeshError::Malformed { at: self.at(), section: self.section.to_string(), expected, found }
    }
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<&'a str> {
        let s = self.rest.trim_start();
        if s.is_empty() {
            return None;
        }
        let end = s.find(|c: char| c.is_ascii_whitespace()).unwrap_or(s.len());
        self.rest = &s[end..];
        Some(&s[..end])
    }

    /// The next number of the line.
    pub fn number<T: FromStr>(&mut self, expected: &'static str) -> Result<T, MeshError> {
        let word = self.next();
        word.and_then(|w| w.parse().ok()).ok_or_else(|| MeshError::Malformed {
            at: MshPlace { file: self.file.to_path_buf(), line: self.line },
            section: self.section.to_string(),
            expected,
            found: word.unwrap_or(self.whole).chars().take(40).collect(),
        })
    }

    /// The next numbers of the line.
    pub fn numbers<const N: usize>(
        &mut self,
        expected: &'static str,
    ) -> Result<[u64; N], MeshError> {
        let mut all = [0; N];
        for x in &mut all {
            *x = self.number(expected)?;
        }
        Ok(all)
    }

    /// Three finite coordinates of `node`.
    pub fn point(&mut self, node: u64) -> Result<[f64; 3], MeshError> {
        let mut x = [0.0_f64; 3];
        for c in &mut x {
            *c = self.number("a coordinate")?;
            if !c.is_finite() {
                let at = MshPlace { file: self.file.to_path_buf(), line: self.line };
                return Err(MeshError::NotFinite { at, node, value: *c });
            }
        }
        Ok(x)
    }

    /// The rest of the line.
    pub fn rest(&self) -> &'a str {
        self.rest.trim()
    }
}
