//! A sheet of a workbook: Excel's `.xlsx` and its relatives, OpenDocument's `.ods`.

use super::rows::{Grid, Row};
use crate::diag::Diagnostic;
use calamine::{Data, Reader, Sheets, open_workbook_auto_from_rs};
use std::io::Cursor;

/// Most cells of a sheet that are read.
const MOST_CELLS: usize = 20_000_000;

fn broken(e: calamine::Error) -> Box<Diagnostic> {
    Diagnostic::input("table/workbook", format!("the workbook cannot be read: {e}"))
        .help("open it in the program that wrote it, and save it as .xlsx or CSV again")
        .into()
}

/// Names of the sheets.
pub fn sheet_names(bytes: &[u8]) -> Result<Vec<String>, Box<Diagnostic>> {
    let book: Sheets<_> = open_workbook_auto_from_rs(Cursor::new(bytes)).map_err(broken)?;
    Ok(book.sheet_names())
}

/// Reads a sheet: the one that is named, else the only one, else the first of the `usual` ones.
pub fn read(bytes: &[u8], sheet: Option<&str>, usual: &[&str]) -> Result<Grid, Box<Diagnostic>> {
    let mut book: Sheets<_> = open_workbook_auto_from_rs(Cursor::new(bytes)).map_err(broken)?;
    let names = book.sheet_names();
    let name = choose(&names, sheet, usual)?;
    let range = book.worksheet_range(&name).map_err(broken)?;
    let [rows, columns] = [range.height(), range.width()];
    if rows.saturating_mul(columns) > MOST_CELLS {
        let message = format!("the sheet `{name}` has {rows} rows of {columns} cells");
        let help = "delete what is far outside of the table, or save the table as CSV";
        return Err(Diagnostic::input("table/size", message).help(help).into());
    }
    let first = range.start().map_or(0, |(row, _)| row as usize) + 1;
    let rows = range.rows().enumerate().filter_map(|(i, cells)| {
        let cells: Vec<String> = cells.iter().map(text).collect();
        let empty = cells.iter().all(String::is_empty);
        (!empty).then_some(Row { line: first + i, cells })
    });
    Ok(Grid { rows: rows.collect(), separator: None, sheet: Some(name) })
}

/// The name of the sheet to read. Case does not count: writers differ in it.
fn choose(
    names: &[String],
    sheet: Option<&str>,
    usual: &[&str],
) -> Result<String, Box<Diagnostic>> {
    let find = |wanted: &str| names.iter().find(|n| n.trim().eq_ignore_ascii_case(wanted.trim()));
    let list = names.iter().map(|n| format!("`{n}`")).collect::<Vec<_>>().join(", ");
    let found = match (sheet, names) {
        (Some(wanted), _) => find(wanted),
        (None, [only]) => Some(only),
        (None, _) => usual.iter().find_map(|n| find(n)),
    };
    found.cloned().ok_or_else(|| {
        let message = match sheet {
            Some(wanted) => format!("the workbook has no sheet `{wanted}`, only {list}"),
            None if names.is_empty() => "the workbook has no sheet".into(),
            None => format!("the workbook has several sheets: {list}"),
        };
        Diagnostic::input("table/sheet", message).help("name one of them with `sheet`").into()
    })
}

/// The text of a cell. A number is written with as many digits as it needs.
fn text(cell: &Data) -> String {
    match cell {
        Data::Empty => String::new(),
        Data::String(s) => s.trim().to_string(),
        Data::Error(e) => format!("{e}"),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;

    /// The sheets of a workbook, each a list of rows of XML cells.
    fn workbook(sheets: &[(&str, &str)]) -> Vec<u8> {
        let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
        let mut add = |name: &str, text: &str| {
            let stored = zip::write::SimpleFileOptions::default()
                .compression_method(zip::CompressionMethod::Stored);
            zip.start_file(name, stored).expect("a file");
            zip.write_all(text.as_bytes()).expect("written");
        };
        let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
        let office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
        let package = "http://schemas.openxmlformats.org/package/2006/relationships";
        let types = "http://schemas.openxmlformats.org/package/2006/content-types";
        add("[Content_Types].xml", &format!("<Types xmlns=\"{types}\"/>"));
        let root = format!(
            "<Relationships xmlns=\"{package}\"><Relationship Id=\"r\" \
             Type=\"{office}/officeDocument\" \
             Target=\"xl/workbook.xml\"/></Relationships>"
        );
        add("_rels/.rels", &root);
        let mut list = String::new();
        let mut links = String::new();
        for (i, (name, rows)) in sheets.iter().enumerate() {
            let (id, file) = (format!("rId{i}"), format!("worksheets/sheet{i}.xml"));
            list += &format!("<sheet name=\"{name}\" sheetId=\"{}\" r:id=\"{id}\"/>", i + 1);
            links += &format!(
                "<Relationship Id=\"{id}\" Type=\"{office}/worksheet\" Target=\"{file}\"/>"
            );
            let sheet =
                format!("<worksheet xmlns=\"{main}\"><sheetData>{rows}</sheetData></worksheet>");
            add(&format!("xl/{file}"), &sheet);
        }
        add(
            "xl/workbook.xml",
            &format!(
                "<workbook xmlns=\"{main}\" xmlns:r=\"{office}\"><sheets>{list}</sheets></workbook>"
            ),
        );
        let links = format!("<Relationships xmlns=\"{package}\">{links}</Relationships>");
        add("xl/_rels/workbook.xml.rels", &links);
        zip.finish().expect("a workbook").into_inner()
    }

    /// Numbers come with all their digits, empty rows are left out, and rows have the number that a
    /// spreadsheet shows.
    #[test]
    fn cells_of_a_sheet() {
        let rows = "<row r=\"2\"><c r=\"A2\" t=\"inlineStr\"><is><t> N [kN] </t></is></c>\
                    <c r=\"B2\" t=\"str\"><v>case</v></c></row>\
                    <row r=\"4\"><c r=\"A4\"><v>-0.10877399322016867</v></c>\
                    <c r=\"B4\"><v>7</v></c></row>";
        let bytes = workbook(&[("Model", ""), ("Forces", rows)]);
        assert_eq!(sheet_names(&bytes).expect("a workbook"), ["Model", "Forces"]);
        let grid = read(&bytes, Some("Forces"), &[]).unwrap_or_else(|e| panic!("{e:?}"));
        assert_eq!((grid.sheet.as_deref(), grid.separator), (Some("Forces"), None));
        let told: Vec<(usize, Vec<&str>)> = grid
            .rows
            .iter()
            .map(|r| (r.line, r.cells.iter().map(String::as_str).collect()))
            .collect();
        assert_eq!(told, [(2, vec!["N [kN]", "case"]), (4, vec!["-0.10877399322016867", "7"])]);
        assert!(read(&bytes, None, &[]).expect_err("two").message.contains("several sheets"));
    }

    #[test]
    fn sheets_are_chosen_by_name() {
        let names = ["Model".to_string(), "ResultInternalForce1D".to_string()];
        let chosen = |sheet, usual: &[&str]| choose(&names, sheet, usual);
        assert_eq!(chosen(Some("model"), &[]).expect("there"), "Model");
        assert_eq!(
            chosen(None, &["Forces", "ResultInternalForce1D"]).expect("there"),
            "ResultInternalForce1D"
        );
        assert_eq!(choose(&names[..1], None, &[]).expect("the only one"), "Model");
        for (sheet, why) in [(None, "several sheets: `Model`"), (Some("A"), "no sheet `A`")] {
            assert!(chosen(sheet, &[]).expect_err(why).message.contains(why));
        }
        assert!(read(b"PK\x03\x04", None, &[]).expect_err("broken").message.contains("cannot be"));
    }
}
