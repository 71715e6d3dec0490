//! Output of faults: for people with the line and a caret under the place, for programs as JSON.

use crate::diag::{Diagnostic, Diagnostics, Place, visible};
use crate::text_file;
use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
use std::fs::File;
use std::io::{BufRead, BufReader, Cursor, Read};

/// Lines shown before the faulty one.
const CONTEXT: usize = 1;

/// Longest line that is shown as an excerpt \[bytes\]. In a longer one the caret would be off the
/// screen.
const LONGEST_LINE: usize = 400;

/// Number of bytes that are read to find a line. A fault further down in a huge mesh file is shown
/// without excerpt.
const READ_LIMIT: u64 = 256 << 20;

/// Most faults that are shown to people; programs get all of them.
const SHOWN: usize = 30;

/// The faults as text for people, one after the other, ending with a newline. Of very many faults,
/// the first ones and the number of the others.
pub fn text(faults: &Diagnostics, colour: bool) -> String {
    let mut out: String = faults.iter().take(SHOWN).map(|d| one(d, colour) + "\n").collect();
    let more = faults.iter().count().saturating_sub(SHOWN);
    if more > 0 {
        out += &format!("and {more} more faults; correct the first ones and try again\n");
    }
    out
}

/// The faults for programs, one JSON object per line: `{"code", "fault", "message", "place":
/// {"file", "line", "column", "path"}, "help"}`. Absent keys are left out.
pub fn json(faults: &Diagnostics) -> String {
    faults
        .iter()
        .map(|d| serde_json::to_string(d).expect("plain strings and numbers serialise") + "\n")
        .collect()
}

fn one(fault: &Diagnostic, colour: bool) -> String {
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    let message = visible(&fault.message);
    let title = Level::ERROR.primary_title(message.as_str()).id(fault.code);
    let file = fault.place.file.as_ref().map(|f| visible(&f.display().to_string()));
    let excerpt = excerpt(&fault.place);
    let label = fault.place.path.as_deref().map(visible);
    let mut group = title.elements(Vec::<annotate_snippets::Message>::new());
    match (&file, &excerpt) {
        (Some(file), Some(e)) => {
            let caret = AnnotationKind::Primary.span(e.span.clone());
            let caret = match &label {
                Some(path) => caret.label(path.as_str()),
                None => caret,
            };
            group = group.element(
                Snippet::source(e.source.as_str())
                    .line_start(e.first_line)
                    .path(file.as_str())
                    .fold(false)
                    .annotation(caret),
            );
        }
        (Some(file), None) => {
            let mut origin = Origin::path(file.as_str());
            if let Some(line) = fault.place.line {
                origin = origin.line(line);
                if let Some(column) = fault.place.column {
                    origin = origin.char_column(column);
                }
            }
            group = group.element(origin);
            if let Some(path) = &fault.place.path {
                group = group.element(Level::NOTE.message(format!("at `{}`", visible(path))));
            }
        }
        (None, _) => {
            if let Some(path) = &fault.place.path {
                group = group.element(Level::NOTE.message(format!("at `{}`", visible(path))));
            }
        }
    }
    if let Some(help) = fault.help.as_deref().map(visible) {
        group = group.element(Level::HELP.message(help));
    }
    renderer.render(&[group])
}

/// A few lines of a file, and the range of bytes that is at fault.
struct Excerpt {
    source: String,
    first_line: usize,
    span: std::ops::Range<usize>,
}

fn excerpt(place: &Place) -> Option<Excerpt> {
    let (file, line) = (place.file.as_ref()?, place.line?);
    // opening a pipe or a device would block for ever
    if line == 0 || !file.metadata().ok()?.is_file() {
        return None;
    }
    let mut reader: Box<dyn BufRead> = match text_file::utf16_of(file) {
        Some(text) => Box::new(Cursor::new(text)),
        None => Box::new(BufReader::new(File::open(file).ok()?.take(READ_LIMIT))),
    };
    let first_line = line.saturating_sub(CONTEXT).max(1);
    let (mut kept, mut bytes) = (Vec::new(), Vec::new());
    for number in 1..=line {
        bytes.clear();
        if reader.read_until(b'\n', &mut bytes).ok()? == 0 {
            return None;
        }
        if number >= first_line {
            let text = String::from_utf8_lossy(&bytes);
            // the byte-order mark of UTF-8 is no character of the first line
            let text =
                text.trim_start_matches('\u{feff}').trim_end_matches(['\n', '\r']).to_string();
            kept.push(if text.len() > LONGEST_LINE && number < line { "…".into() } else { text });
        }
    }
    let fault = kept.pop()?;
    // a workbook has no lines to show
    if fault.len() > LONGEST_LINE || fault.contains(['\0', char::REPLACEMENT_CHARACTER]) {
        return None;
    }
    let mut source = String::new();
    for text in &kept {
        source.push_str(text);
        source.push('\n');
    }
    let (start, end) = word(&fault, place.column);
    let span = source.len() + start..source.len() + end;
    source.push_str(&fault);
    Some(Excerpt { source, first_line, span })
}

/// Byte range of the word that starts at a column (counted in characters from 1); of the whole text
/// if there is no column.
fn word(line: &str, column: Option<usize>) -> (usize, usize) {
    let Some(column) = column else {
        let start = line.len() - line.trim_start().len();
        return (start, line.trim_end().len().max(start));
    };
    let start = line.char_indices().nth(column.saturating_sub(1)).map_or(line.len(), |(i, _)| i);
    let rest = &line[start..];
    let mut ends = rest.char_indices().skip(1);
    let length = match rest.chars().next() {
        None => 0,
        // a quoted word ends at its closing quote
        Some(q @ ('"' | '\'')) => ends.find(|(_, c)| *c == q).map_or(rest.len(), |(i, _)| i + 1),
        Some(_) => ends
            .find(|(_, c)| c.is_whitespace() || ",:[]{}#".contains(*c))
            .map_or(rest.len(), |(i, _)| i),
    };
    (start, start + length)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faulty(text: &[u8]) -> (tempfile::TempDir, std::path::PathBuf) {
        let folder = tempfile::tempdir().expect("temporary folder");
        let file = folder.path().join("joint.yaml");
        std::fs::write(&file, text).expect("writes");
        (folder, file)
    }

    #[test]
    fn the_caret_stands_under_the_word() {
        let (_folder, file) = faulty("bolts:\n  größe: M17, grade: \"8.8\"\n".as_bytes());
        let fault = Diagnostic::input("spec/unknown-bolt", "there is no bolt `M17`")
            .file(&file)
            .at(2, 10)
            .path("bolts.größe")
            .help("sizes: M16, M18, M20");
        let shown = text(&fault.into(), false);
        let lines: Vec<_> = shown.lines().collect();
        assert_eq!(lines[0], "error[spec/unknown-bolt]: there is no bolt `M17`");
        assert!(lines[1].ends_with("joint.yaml:2:10"), "{shown}");
        let source = lines.iter().position(|l| l.contains("größe: M17")).expect("shows the line");
        let column = |s: &str, what: &str| s[..s.find(what).expect(what)].chars().count();
        assert_eq!(
            column(lines[source], "M17"),
            column(lines[source + 1], "^^^ bolts.größe"),
            "{shown}"
        );
        assert!(shown.contains("help: sizes: M16, M18, M20"), "{shown}");
        assert!(shown.contains("bolts:"), "{shown}");
    }

    #[test]
    fn shows_something_whatever_the_place() {
        let (_folder, file) = faulty(b"a: 1\n\xff\xfe: 2\n");
        let base = Diagnostic::input("x/y", "broken");
        for place in [
            base.clone(),
            base.clone().path("a.b"),
            base.clone().file("no/such/file.yaml").at(3, 4).path("a.b"),
            base.clone().file(&file),
            base.clone().file(&file).at(1, 500),
            base.clone().file(&file).at(2, 1),
            base.clone().file(&file).at(99, 1),
            base.clone().file(&file).at(0, 0),
            base.clone().file(file.parent().expect("parent")).at(1, 1),
        ] {
            let shown = text(&place.clone().into(), false);
            assert!(shown.starts_with("error[x/y]: broken"), "{shown}");
            if let Some(file) = &place.place.file {
                assert!(shown.contains(&file.display().to_string()), "{shown}");
            }
            if let Some(path) = &place.place.path {
                assert!(shown.contains(path.as_str()), "{shown}");
            }
        }
    }

    #[test]
    fn json_is_one_object_a_line() {
        let faults = Diagnostics::from_list(vec![
            Diagnostic::input("a/b", "first\nwith a line end").file("f.yaml").at(1, 2),
            Diagnostic::environment("c/d", "second").help("do"),
        ])
        .expect("two faults");
        let out = json(&faults);
        let lines: Vec<serde_json::Value> =
            out.lines().map(|l| serde_json::from_str(l).expect("JSON")).collect();
        assert_eq!(lines.len(), 2);
        assert_eq!(lines[0]["place"]["column"], 2);
        assert_eq!(lines[0]["fault"], "input");
        assert!(lines[0].get("help").is_none());
        assert_eq!(lines[1]["help"], "do");
    }
}
