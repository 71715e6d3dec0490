//! Reads text files in the encodings that common programs save. Specs, models, templates and
//! catalogue tables are all read here.
//!
//! UTF-8 is read with or without byte-order mark, UTF-16 only with one. Any other file is refused
//! with line and byte, because guessing the encoding would put wrong letters into names that must
//! match.

pub mod foreign;

use crate::diag::Diagnostic;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Largest file that is read \[bytes\].
const LARGEST: u64 = 256 << 20;

const HELP: &str =
    "save the file as UTF-8: most editors offer it under `Save as` or `Save with encoding`";

/// Reads a text file. `unread` makes the message for a file that the operating system cannot read.
pub fn read(
    path: &Path,
    unread: impl FnOnce(std::io::Error) -> Diagnostic,
) -> Result<String, Box<Diagnostic>> {
    let bytes = whole(path, unread)?;
    if let Some(what) = foreign::of_bytes(&bytes) {
        let table = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv"));
        return Err(if table { no_table(what, path) } else { not_ours(what, path) }.into());
    }
    decode(bytes).map_err(|fault| undecoded(fault, path).into())
}

/// A table as a file holds it.
#[derive(Debug)]
pub enum Table {
    /// A text.
    Text(String),
    /// A workbook of a spreadsheet.
    Workbook(Vec<u8>),
}

/// Reads the file of a table; `unread`: see [`read`].
///
/// A text that is not UTF-8 is read in the code page of Windows (1252), in which Excel saves CSV: a
/// table is read for its numbers, and its names have to match only each other.
pub fn read_table(
    path: &Path,
    unread: impl FnOnce(std::io::Error) -> Diagnostic,
) -> Result<Table, Box<Diagnostic>> {
    let bytes = whole(path, unread)?;
    if foreign::is_workbook(&bytes) {
        return Ok(Table::Workbook(bytes));
    }
    if let Some(what) = foreign::of_bytes(&bytes) {
        return Err(no_table(what, path).into());
    }
    let marked = [&b"\xff\xfe"[..], b"\xfe\xff", b"\xef\xbb\xbf"];
    let of_windows = !bytes.contains(&0) && !marked.iter().any(|m| bytes.starts_with(m));
    match String::from_utf8(bytes) {
        Err(e) if of_windows => {
            let (text, _) = encoding_rs::WINDOWS_1252.decode_without_bom_handling(e.as_bytes());
            Ok(Table::Text(text.into_owned()))
        }
        read => decode(read.map_or_else(|e| e.into_bytes(), String::into_bytes))
            .map(Table::Text)
            .map_err(|fault| undecoded(fault, path).into()),
    }
}

/// The bytes of a file, if it is not too large.
fn whole(
    path: &Path,
    unread: impl FnOnce(std::io::Error) -> Diagnostic,
) -> Result<Vec<u8>, Box<Diagnostic>> {
    let mut bytes = Vec::new();
    // a device such as /dev/zero has no end
    let read = File::open(path).and_then(|f| f.take(LARGEST + 1).read_to_end(&mut bytes));
    read.map_err(|e| Box::new(unread(e)))?;
    if bytes.len() as u64 > LARGEST {
        let message = format!("the file has more than {} MB", LARGEST >> 20);
        let help = "specs have some kB; divide a table, or name the right file";
        return Err(Diagnostic::input("file/size", message).file(path).help(help).into());
    }
    Ok(bytes)
}

fn undecoded(fault: NotText, path: &Path) -> Diagnostic {
    let d = Diagnostic::input("file/encoding", fault.problem).file(path).help(HELP);
    match fault.at {
        Some((line, column)) => d.at(line, column),
        None => d,
    }
}

/// The fault of a file of another program in place of a spec, model or sweep.
pub fn not_ours(what: &str, path: &Path) -> Diagnostic {
    let help = "Bracket reads YAML; `bracket new TEMPLATE -o FILE` writes a starter";
    Diagnostic::input("file/kind", format!("this is {what}, not a spec")).file(path).help(help)
}

/// The fault of a file of another program in place of a table.
fn no_table(what: &str, path: &Path) -> Diagnostic {
    let help = "Bracket reads CSV and workbooks (.xlsx, .ods): save the table as one of them";
    Diagnostic::input("file/kind", format!("this is {what}, not a table")).file(path).help(help)
}

/// The text of a UTF-16 file with its byte-order mark; `None` for every other file.
pub fn utf16_of(path: &Path) -> Option<String> {
    let mut bytes = Vec::new();
    let mut file = regular(path).ok()?.take(LARGEST);
    file.by_ref().take(2).read_to_end(&mut bytes).ok()?;
    let unit = match bytes[..] {
        [0xff, 0xfe] => u16::from_le_bytes,
        [0xfe, 0xff] => u16::from_be_bytes,
        _ => return None,
    };
    bytes.clear();
    file.read_to_end(&mut bytes).ok()?;
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    Some(char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect())
}

/// Reads a regular file. A device or a pipe is refused, because it may have no end.
pub fn bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    let mut out = Vec::new();
    regular(path)?.read_to_end(&mut out)?;
    Ok(out)
}

/// Reads a regular file as UTF-8, as this program writes its own files.
pub fn utf8_of(path: &Path) -> std::io::Result<String> {
    let invalid = |e| std::io::Error::new(std::io::ErrorKind::InvalidData, e);
    String::from_utf8(bytes(path)?).map_err(invalid)
}

/// Opens a regular file.
pub fn regular(path: &Path) -> std::io::Result<File> {
    // asked before it is opened, because that waits for the other end of a pipe
    let meta = std::fs::metadata(path)?;
    if !meta.is_file() {
        let kind = if meta.is_dir() {
            std::io::ErrorKind::IsADirectory
        } else {
            std::io::ErrorKind::InvalidInput
        };
        return Err(std::io::Error::new(kind, "it is not a regular file"));
    }
    File::open(path)
}

/// Reason and place at which bytes are not text.
#[derive(Debug, PartialEq)]
struct NotText {
    problem: String,
    at: Option<(usize, usize)>,
}

fn decode(bytes: Vec<u8>) -> Result<String, NotText> {
    if bytes.starts_with(&[0xff, 0xfe, 0, 0]) || bytes.starts_with(&[0, 0, 0xfe, 0xff]) {
        return Err(NotText {
            problem: "the file is UTF-32 text, which is not read".into(),
            at: None,
        });
    }
    match bytes.as_slice() {
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] => utf8(rest.to_vec(), 3),
        _ => utf8(bytes, 0),
    }
}

/// Decodes UTF-8. `skipped` is the number of bytes of the file before `bytes`.
fn utf8(bytes: Vec<u8>, skipped: usize) -> Result<String, NotText> {
    let text = String::from_utf8(bytes).map_err(|e| {
        let i = e.utf8_error().valid_up_to();
        let bytes = e.as_bytes();
        let byte = bytes[i];
        // older programs on Windows and Linux write Latin-1
        let latin = if byte >= 0xa0 {
            format!("; in Latin-1 it is `{}`", char::from(byte))
        } else {
            String::new()
        };
        let problem = format!(
            "byte {} of the file is 0x{byte:02X}, which is not UTF-8 text{latin}",
            skipped + i + 1
        );
        NotText { problem, at: Some(place(&bytes[..i])) }
    })?;
    match text.find('\0') {
        None => Ok(text),
        Some(i) => {
            let problem = format!(
                "byte {} of the file is zero: it is UTF-16 text without a byte-order mark, or no \
                 text",
                skipped + i + 1
            );
            Err(NotText { problem, at: Some(place(&text.as_bytes()[..i])) })
        }
    }
}

/// Line and column of the position after the valid text `before`.
fn place(before: &[u8]) -> (usize, usize) {
    let text = String::from_utf8_lossy(before);
    let line = text.matches('\n').count() + 1;
    let column = text.rsplit('\n').next().map_or(0, |l| l.chars().count()) + 1;
    (line, column)
}

/// Decodes UTF-16 that follows its byte-order mark.
fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, NotText> {
    let mut text = String::with_capacity(bytes.len() / 2);
    let cut = |text: &str, problem: String| NotText { problem, at: Some(place(text.as_bytes())) };
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    for c in char::decode_utf16(units) {
        match c {
            Ok('\0') => return Err(cut(&text, "the file has a zero among its UTF-16 text".into())),
            Ok(c) => text.push(c),
            Err(e) => {
                let problem = format!(
                    "0x{:04X} is half of a character in this UTF-16 text",
                    e.unpaired_surrogate()
                );
                return Err(cut(&text, problem));
            }
        }
    }
    match bytes.len() % 2 {
        0 => Ok(text),
        _ => Err(cut(
            &text,
            format!(
                "the file is UTF-16 text of {} bytes, an odd number: its end is missing",
                bytes.len() + 2
            ),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "title: Größe µ\nplate: {t: 15}\n";

    fn marked(mark: &[u8], text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
        mark.iter().copied().chain(text.encode_utf16().flat_map(bytes)).collect()
    }

    #[test]
    fn one_text_in_four_encodings() {
        let with_mark = [b"\xef\xbb\xbf", TEXT.as_bytes()].concat();
        let le = marked(&[0xff, 0xfe], TEXT, u16::to_le_bytes);
        let be = marked(&[0xfe, 0xff], TEXT, u16::to_be_bytes);
        for bytes in [TEXT.as_bytes().to_vec(), with_mark, le, be] {
            assert_eq!(decode(bytes).as_deref(), Ok(TEXT));
        }
        assert_eq!(decode(Vec::new()).as_deref(), Ok(""));
        assert_eq!(decode(vec![0xef, 0xbb, 0xbf]).as_deref(), Ok(""));
        assert_eq!(decode(vec![0xff, 0xfe]).as_deref(), Ok(""));
    }

    #[test]
    fn what_is_no_text_is_refused_with_line_and_byte() {
        let latin: Vec<u8> = TEXT.chars().map(|c| c as u8).collect();
        let refused = |bytes: Vec<u8>| decode(bytes).expect_err("no text");
        let f = refused(latin.clone());
        assert_eq!(f.at, Some((1, 10)));
        assert_eq!(
            f.problem,
            "byte 10 of the file is 0xF6, which is not UTF-8 text; in Latin-1 it is `ö`"
        );
        let f = refused([b"\xef\xbb\xbfa: 1\n", latin.as_slice()].concat());
        assert_eq!((f.at, f.problem.starts_with("byte 18 ")), (Some((2, 10)), true), "{f:?}");
        // 0x96 is a dash in Windows-1252 and no character in Latin-1
        let f = refused(b"a: 1 \x96 2".to_vec());
        assert_eq!(f.problem, "byte 6 of the file is 0x96, which is not UTF-8 text");
        // the text ends within a character
        assert_eq!(refused(TEXT.as_bytes()[..10].to_vec()).at, Some((1, 10)));
        let bare = marked(&[], "ab", u16::to_le_bytes);
        assert!(
            refused(bare).problem.contains("byte 2 of the file is zero: it is UTF-16 text without")
        );
        assert!(refused(b"\xff\xfe\0\0a\0\0\0".to_vec()).problem.contains("UTF-32"));
        assert!(refused(b"\xff\xfea\0b".to_vec()).problem.contains("5 bytes, an odd number"));
        assert!(
            refused(b"\xff\xfea\0\0\xd8b\0".to_vec())
                .problem
                .contains("0xD800 is half of a character")
        );
        assert!(refused(b"\xff\xfea\0\0\0".to_vec()).problem.contains("a zero among"));
        assert!(refused(b"PK\x03\x04\x00\x00".to_vec()).problem.contains("or no text"));
    }

    /// Excel saves `CSV` in the code page of Windows, and specs are never read in it.
    #[test]
    fn a_table_in_the_code_page_of_windows() {
        let dir = tempfile::tempdir().expect("a folder");
        let path = dir.path().join("forces.csv");
        let unread = |e: std::io::Error| Diagnostic::input("spec/read", e.to_string());
        let text = |bytes: &[u8]| {
            std::fs::write(&path, bytes).expect("written");
            match read_table(&path, unread) {
                Ok(Table::Text(text)) => text,
                other => panic!("{other:?}"),
            }
        };
        assert_eq!(text(b"St\xfctze \x96 A;1"), "Stütze – A;1");
        assert_eq!(text("Stütze;1".as_bytes()), "Stütze;1");
        assert_eq!(text(&marked(&[0xff, 0xfe], "ü\t1", u16::to_le_bytes)), "ü\t1");
        for bytes in [&b"%PDF-1.7"[..], b"a\0b\0\xfc"] {
            std::fs::write(&path, bytes).expect("written");
            assert!(read_table(&path, unread).is_err());
        }
        std::fs::write(&path, b"PK\x03\x04....xl/workbook").expect("written");
        assert!(matches!(read_table(&path, unread), Ok(Table::Workbook(_))));
    }

    #[test]
    #[cfg(unix)]
    fn a_device_without_end_is_not_read() {
        let e = bytes(Path::new("/dev/zero")).expect_err("no file");
        assert_eq!(e.to_string(), "it is not a regular file");
        let dir = tempfile::tempdir().expect("a folder");
        assert!(bytes(dir.path()).is_err());
        std::fs::write(dir.path().join("a"), "a").expect("written");
        std::os::unix::fs::symlink("a", dir.path().join("link")).expect("linked");
        assert_eq!(bytes(&dir.path().join("link")).expect("read"), b"a");
    }

    #[test]
    fn the_file_and_the_cure_are_named() {
        let dir = tempfile::tempdir().expect("a folder");
        let path = dir.path().join("spec.yaml");
        let unread = |e: std::io::Error| Diagnostic::input("spec/read", e.to_string());
        assert_eq!(read(&path, unread).map(drop).expect_err("absent").code, "spec/read");
        std::fs::write(&path, b"a: \xe9").expect("written");
        let d = read(&path, unread).expect_err("Latin-1");
        assert_eq!((d.code, d.place.file.as_deref()), ("file/encoding", Some(path.as_path())));
        assert_eq!((d.place.line, d.place.column), (Some(1), Some(4)));
        assert!(d.help.is_some_and(|h| h.contains("UTF-8")));
    }
}
