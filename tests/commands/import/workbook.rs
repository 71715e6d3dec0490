//! A workbook as a spreadsheet writes it, with sheets of texts and numbers.

use std::io::{Cursor, Write as _};

const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
const PACKAGE: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
const TYPES: &str = "http://schemas.openxmlformats.org/package/2006/content-types";

/// A cell: a number where it is one.
fn cell(text: &str) -> String {
    match text.parse::<f64>() {
        Ok(_) => format!("<c><v>{text}</v></c>"),
        Err(_) => format!("<c t=\"inlineStr\"><is><t>{text}</t></is></c>"),
    }
}

/// The bytes of a workbook; each sheet is a name and rows whose cells stand between bars.
pub fn workbook(sheets: &[(&str, Vec<String>)]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let mut add = |name: &str, text: &str| {
        let stored = zip::write::SimpleFileOptions::default()
            .compression_method(zip::CompressionMethod::Stored);
        zip.start_file(name, stored).expect("a file");
        zip.write_all(text.as_bytes()).expect("written");
    };
    add("[Content_Types].xml", &format!("<Types xmlns=\"{TYPES}\"/>"));
    let root = format!(
        "<Relationships xmlns=\"{PACKAGE}\"><Relationship Id=\"r\" \
         Type=\"{OFFICE}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
    );
    add("_rels/.rels", &root);
    let (mut list, mut links) = (String::new(), String::new());
    for (i, (name, rows)) in sheets.iter().enumerate() {
        let file = format!("worksheets/sheet{i}.xml");
        list += &format!("<sheet name=\"{name}\" sheetId=\"{}\" r:id=\"rId{i}\"/>", i + 1);
        links +=
            &format!("<Relationship Id=\"rId{i}\" Type=\"{OFFICE}/worksheet\" Target=\"{file}\"/>");
        let row = |r: &String| format!("<row>{}</row>", r.split('|').map(cell).collect::<String>());
        let rows: String = rows.iter().map(row).collect();
        let sheet =
            format!("<worksheet xmlns=\"{MAIN}\"><sheetData>{rows}</sheetData></worksheet>");
        add(&format!("xl/{file}"), &sheet);
    }
    let book = format!(
        "<workbook xmlns=\"{MAIN}\" xmlns:r=\"{OFFICE}\"><sheets>{list}</sheets></workbook>"
    );
    add("xl/workbook.xml", &book);
    let links = format!("<Relationships xmlns=\"{PACKAGE}\">{links}</Relationships>");
    add("xl/_rels/workbook.xml.rels", &links);
    zip.finish().expect("a workbook").into_inner()
}
