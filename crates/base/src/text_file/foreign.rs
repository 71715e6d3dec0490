//! Files of other programs that people give as input by mistake.

const EXCEL: &str = "an Excel file";
const SPREADSHEET: &str = "a spreadsheet (ODS)";
const OLD_OFFICE: &str = "a Word or Excel file of an old version";

/// Beginnings of binary files, and what they are.
const BINARY: [(&[u8], &str); 10] = [
    (b"%PDF", "a PDF file"),
    (b"\xd0\xcf\x11\xe0", OLD_OFFICE),
    (b"\x1f\x8b", "a compressed file (gzip)"),
    (b"7z\xbc\xaf", "a compressed file (7z)"),
    (b"Rar!", "a compressed file (rar)"),
    (b"\x89PNG", "a picture (PNG)"),
    (b"\xff\xd8\xff", "a picture (JPEG)"),
    (b"AC10", "an AutoCAD drawing (DWG)"),
    (b"SQLite format 3", "a database (SQLite)"),
    (b"\x7fELF", "a program"),
];

/// Whether the bytes are a workbook of a spreadsheet, also of Excel before 2007.
pub fn is_workbook(bytes: &[u8]) -> bool {
    let what = of_bytes(bytes);
    what.is_some_and(|w| [EXCEL, SPREADSHEET, OLD_OFFICE].contains(&w))
}

/// What a file of another program is, by its bytes; `None` if it may be a text of ours.
pub fn of_bytes(bytes: &[u8]) -> Option<&'static str> {
    if bytes.starts_with(b"PK\x03\x04") {
        // the names of the members stand uncompressed between them
        let has = |name: &[u8]| bytes.windows(name.len()).any(|w| w == name);
        let office: [(&[u8], &str); 5] = [
            (b"xl/workbook", EXCEL),
            (b"word/document", "a Word file"),
            (b"ppt/presentation", "a PowerPoint file"),
            (b"opendocument.spreadsheet", SPREADSHEET),
            (b"opendocument.text", "a text document (ODT)"),
        ];
        let found = office.into_iter().find(|(name, _)| has(name));
        return Some(found.map_or("a ZIP archive", |(_, what)| what));
    }
    BINARY.into_iter().find(|(head, _)| bytes.starts_with(head)).map(|(_, what)| what)
}

/// What a text of another program is, by its beginning; `None` if it may be one of ours.
pub fn of_text(text: &str) -> Option<&'static str> {
    let start = text.trim_start();
    let head: String = start.chars().take(2000).collect();
    let lower = head.to_lowercase();
    if lower.starts_with("<!doctype html") || lower.starts_with("<html") {
        return Some("an HTML page");
    }
    if head.starts_with("ISO-10303-21") {
        let ifc = lower.contains("file_schema") && lower.contains("'ifc");
        return Some(if ifc { "an IFC file" } else { "a STEP file" });
    }
    if head.starts_with('<') {
        return Some(if lower.contains("ifc") { "an IFC-XML file" } else { "an XML file" });
    }
    let dxf = head.lines().next().is_some_and(|l| l.trim() == "0")
        && head.lines().nth(1).is_some_and(|l| l.trim() == "SECTION");
    match () {
        () if head.starts_with("{\\rtf") => Some("a formatted text (RTF)"),
        () if head.starts_with("$MeshFormat") => Some("a mesh of gmsh"),
        () if dxf => Some("a drawing (DXF)"),
        () => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_other_programs_are_known_by_their_beginning() {
        let xlsx = b"PK\x03\x04\x14\0\x06\0[Content_Types].xml..PK\x03\x04..xl/workbook.xml";
        for (bytes, what) in [
            (&xlsx[..], "an Excel file"),
            (b"PK\x03\x04....word/document.xml", "a Word file"),
            (b"PK\x03\x04\0\0a.txt", "a ZIP archive"),
            (b"%PDF-1.7\n%\xe2", "a PDF file"),
            (b"\xd0\xcf\x11\xe0\xa1\xb1", "a Word or Excel file of an old version"),
        ] {
            assert_eq!(of_bytes(bytes), Some(what));
        }
        for (text, what) in [
            ("\n<?xml version='1.0'?><OpenModel/>", "an XML file"),
            ("<ifcXML>", "an IFC-XML file"),
            ("<!DOCTYPE html><html>", "an HTML page"),
            ("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));", "an IFC file"),
            ("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AP214'));", "a STEP file"),
            ("  0\nSECTION\n", "a drawing (DXF)"),
            ("{\\rtf1\\ansi", "a formatted text (RTF)"),
        ] {
            assert_eq!(of_text(text), Some(what), "{text}");
        }
        for ours in
            ["template: beam_splice\n", "{\"template\": \"a\"}", "# <a>\nb: 1", "0: 1\n", ""]
        {
            assert_eq!((of_text(ours), of_bytes(ours.as_bytes())), (None, None), "{ours}");
        }
    }
}
