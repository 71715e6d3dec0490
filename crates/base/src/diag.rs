//! One message for each fault: what is wrong, where, which limit it violates, and what to do next.
//!
//! Every stage has its own error enum. Each of them converts into a [`Diagnostic`], which the
//! command line prints (as text or JSON) and turns into an exit code.

use std::fmt;
use std::path::PathBuf;

/// Exit status of the process. `README.md` explains the exit codes in a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum ExitStatus {
    /// The command completed its work, and what it judged is verified.
    Ok = 0,
    /// The joint is verified not OK, a check fails, or a certificate is refuted.
    NotOk = 1,
    /// The input is wrong.
    BadInput = 2,
    /// No certificate could be produced within the limits.
    Undecided = 3,
    /// The machine lacks something (mesher, disk, memory).
    Environment = 4,
}

impl ExitStatus {
    /// The exit code of the process.
    pub fn code(self) -> u8 {
        self as u8
    }
}

/// Category of a fault: who has to act on it. It decides the exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Fault {
    /// The input is wrong.
    Input,
    /// No certificate could be produced within the limits.
    Undecided,
    /// The machine lacks something (mesher, disk, memory).
    Environment,
}

impl Fault {
    /// Exit status of a process that this fault stopped.
    pub fn exit_status(self) -> ExitStatus {
        match self {
            Fault::Input => ExitStatus::BadInput,
            Fault::Undecided => ExitStatus::Undecided,
            Fault::Environment => ExitStatus::Environment,
        }
    }

    /// The exit code of the process.
    pub fn exit_code(self) -> u8 {
        self.exit_status().code()
    }
}

/// Place of a fault. Every field is optional: a place may be a line in a file, a path inside a YAML
/// document, or unknown.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Place {
    /// The file as the user named it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
    /// 1-based line.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// 1-based column.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
    /// Path inside the document, for example `bolts.rows[1]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<String>,
}

/// One fault, ready for display.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Diagnostic {
    /// Stable short code, for example `spec/unknown-key`.
    pub code: &'static str,
    /// Category: who has to act.
    pub fault: Fault,
    /// One sentence: the quantity, its value and the limit it violates.
    pub message: String,
    /// Place of the fault.
    pub place: Place,
    /// What to do next.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub help: Option<String>,
}

impl Diagnostic {
    /// A fault of the input.
    pub fn input(code: &'static str, message: impl Into<String>) -> Self {
        Self {
            code,
            fault: Fault::Input,
            message: message.into(),
            place: Place::default(),
            help: None,
        }
    }

    /// A fault of the machine or of its installation.
    pub fn environment(code: &'static str, message: impl Into<String>) -> Self {
        Self { fault: Fault::Environment, ..Self::input(code, message) }
    }

    /// No certificate could be produced within the limits.
    pub fn undecided(code: &'static str, message: impl Into<String>) -> Self {
        Self { fault: Fault::Undecided, ..Self::input(code, message) }
    }

    /// Sets the file.
    pub fn file(mut self, file: impl Into<PathBuf>) -> Self {
        self.place.file = Some(file.into());
        self
    }

    /// Sets the path inside the document.
    pub fn path(mut self, path: impl Into<String>) -> Self {
        self.place.path = Some(path.into());
        self
    }

    /// Sets line and column, both counted from 1.
    pub fn at(mut self, line: usize, column: usize) -> Self {
        self.place.line = Some(line);
        self.place.column = Some(column);
        self
    }

    /// Sets the advice on what to do next.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)
    }
}

impl std::error::Error for Diagnostic {}

/// The faults that ended a run.
pub type Diagnostics = AtLeastOne<Diagnostic>;

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let messages: Vec<&str> = self.0.iter().map(|d| d.message.as_str()).collect();
        f.write_str(&messages.join("; "))
    }
}

impl std::error::Error for Diagnostics {}

/// A list that is never empty: no constructor creates an empty one, and no method removes the last
/// entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AtLeastOne<T>(Vec<T>);

impl<T> AtLeastOne<T> {
    /// The list, or `None` if there are no entries.
    pub fn from_list(entries: Vec<T>) -> Option<Self> {
        (!entries.is_empty()).then_some(Self(entries))
    }

    /// `Ok` if there are no faults, otherwise an error with all of them.
    pub fn refuse(faults: Vec<T>) -> Result<(), Self> {
        Self::from_list(faults).map_or(Ok(()), Err)
    }

    /// The first entry.
    pub fn first(&self) -> &T {
        &self.0[0]
    }

    /// The first entry, without the others.
    pub fn into_first(mut self) -> T {
        self.0.swap_remove(0)
    }

    /// The last entry.
    pub fn last_mut(&mut self) -> &mut T {
        let last = self.0.len() - 1;
        &mut self.0[last]
    }

    /// The entries in their order, mutable.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.0.iter_mut()
    }

    /// The entries in their order.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.0.iter()
    }

    /// The same list with every entry converted.
    pub fn map<U>(self, convert: impl FnMut(T) -> U) -> AtLeastOne<U> {
        AtLeastOne(self.0.into_iter().map(convert).collect())
    }
}

impl<T> From<T> for AtLeastOne<T> {
    fn from(only: T) -> Self {
        Self(vec![only])
    }
}

impl From<Box<Diagnostic>> for Diagnostics {
    fn from(only: Box<Diagnostic>) -> Self {
        Self(vec![*only])
    }
}

impl<T> IntoIterator for AtLeastOne<T> {
    type Item = T;
    type IntoIter = std::vec::IntoIter<T>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl Diagnostics {
    /// Exit status of a process that these faults stopped; the first fault decides.
    pub fn exit_status(&self) -> ExitStatus {
        self.first().fault.exit_status()
    }

    /// The exit code of the process.
    pub fn exit_code(&self) -> u8 {
        self.exit_status().code()
    }
}

/// `, did you mean "x"?` for the closest word of `known`; empty if none is close.
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let lower = word.to_lowercase();
    let letters = |k: &str| k.chars().count();
    // of a short word something must stay
    let near = |(d, k): &(usize, &str)| {
        *d <= 1 + k.len().max(word.len()) / 4 && *d < letters(k).max(letters(word))
    };
    let mut found: Vec<(usize, &str)> = known
        .into_iter()
        .map(|k| (strsim::damerau_levenshtein(&lower, &k.to_lowercase()), k))
        .filter(near)
        .collect();
    let least = found.iter().map(|f| f.0).min().unwrap_or(0);
    found.retain(|f| f.0 == least);
    // a name cut short: the full ones
    let whole: Vec<String> = found
        .iter()
        .filter(|(d, k)| *d > 0 && k.to_lowercase().starts_with(&lower))
        .map(|(_, k)| format!("`{k}`"))
        .collect();
    match &whole[..] {
        [first @ .., last] if (1..4).contains(&first.len()) => {
            format!(", did you mean {} or {last}?", first.join(", "))
        }
        [one] => format!(", did you mean {one}?"),
        _ => found.iter().min().map_or_else(String::new, |f| format!(", did you mean `{}`?", f.1)),
    }
}

/// A number of the user in a message: in powers of ten where it would have hundreds of digits.
pub fn number(x: f64) -> String {
    let usual = x == 0.0 || !x.is_finite() || (1e-6..1e15).contains(&x.abs());
    if usual { x.to_string() } else { format!("{x:e}") }
}

/// A text of the user for a terminal or a plain file. Control characters, which command a terminal,
/// marks that turn the direction of writing, and the line ends of Unicode become the replacement
/// character; usual line ends and tabs stay.
pub fn visible(text: &str) -> String {
    let turns = |c: char| {
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2066}'..='\u{2069}')
    };
    let commands = |c: char| c.is_control() && c != '\n' && c != '\t';
    text.chars().map(|c| if turns(c) || commands(c) { '\u{fffd}' } else { c }).collect()
}

/// A text of the user within a line of a terminal: as [`visible`], and no line end of it can make
/// another line of the program's look.
pub fn in_line(text: &str) -> String {
    visible(text).replace(['\n', '\t'], " ")
}
