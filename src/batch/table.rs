//! Reads the table of a sweep: one joint a row, in a text or in the only sheet of a workbook.
//!
//! Where the comma separates no cells it may stand before decimals. A line of a text that starts
//! with `#` is a comment.

use super::column::{self, Column, Decimals};
use super::dimension::{Dimension, Setting};
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
use bracket_base::grid::{self, Comments, Grid, Row};
use std::collections::BTreeMap;
use std::path::Path;

/// Faults that are reported at once; a wrong column has one in every row.
const SHOWN: usize = 5;

/// Most columns; a spec has some hundred values.
const MOST_COLUMNS: usize = 1000;

/// Reads a table.
pub fn read(file: &Path) -> Result<Dimension, Diagnostics> {
    let grid = grid::read(file, None, &[], Comments::Hash, |e| {
        Diagnostic::input(
            "sweep/table",
            format!("the table `{}` cannot be read: {e}", file.display()),
        )
        .file(file)
        .help("`table` is a path relative to the sweep file")
    })?;
    of_grid(&grid, file)
}

/// The place of a cell.
fn place(file: &Path, line: usize, header: Option<&str>) -> Place {
    let path = header.map(str::to_owned);
    Place { file: Some(file.into()), line: Some(line), column: None, path }
}

/// The joints of a table.
pub(super) fn of_grid(grid: &Grid, file: &Path) -> Result<Dimension, Diagnostics> {
    let fault = |line: usize, header: Option<&str>, message: String, help: &str| Diagnostic {
        place: place(file, line, header),
        ..Diagnostic::input("sweep/table", message).help(help)
    };
    let Some((Row { line: first, cells: headers }, rows)) = grid.rows.split_first() else {
        let help = "the first row holds paths of the spec, each further row a joint";
        return Err(fault(1, None, "the table is empty".into(), help).into());
    };
    let decimals = match grid.separator {
        Some('\t' | ';') => Decimals::PointOrComma,
        _ => Decimals::Point,
    };
    if headers.len() > MOST_COLUMNS {
        let message = format!("{} columns, at most {MOST_COLUMNS} are read", headers.len());
        let help = "each row is a joint, each column a value that varies";
        return Err(fault(*first, None, message, help).into());
    }
    let columns = columns(headers).map_err(|faults| {
        let help = "a header is `name`, `expect`, `note.` with a word, or a path of the spec, \
                    with the unit of its numbers behind it: `loads.ULS1.My [kN m]`";
        faults.map(|(header, message)| fault(*first, Some(&header), message, help))
    })?;
    let mut steps = Vec::new();
    let mut faults = Vec::new();
    let mut named: BTreeMap<String, usize> = BTreeMap::new();
    let mut signs: [Option<(usize, String)>; 2] = [None, None];
    for Row { line, cells } in rows {
        let line = *line;
        if cells.len() != headers.len() {
            let message =
                format!("the row has {} cells, the header {}", cells.len(), headers.len());
            let help = "a decimal comma or a comma in a name splits a cell: write points, and put \
                        names into quotes";
            return Err(fault(line, None, message, help).into());
        }
        let mut step = Setting {
            name: None,
            values: Vec::new(),
            expect: None,
            notes: Vec::new(),
            place: place(file, line, None),
        };
        for ((header, column), cell) in headers.iter().zip(&columns).zip(cells) {
            let read = match column {
                Column::Name => {
                    step.name = Some(cell.clone()).filter(|n| !n.is_empty());
                    Ok(())
                }
                Column::Expect => column::verdict(cell).map(|v| step.expect = v),
                Column::Note(_) => {
                    step.notes.push(cell.clone());
                    Ok(())
                }
                Column::Path(_, unit) => {
                    if let Some(sign) = column::decimal_sign(cell) {
                        signs[usize::from(sign == ',')].get_or_insert((line, cell.clone()));
                    }
                    column::value(cell, unit.as_deref(), decimals).map(|v| step.values.push(v))
                }
            };
            if let Err(message) = read {
                let message = format!("column `{header}`: {message}");
                faults.push(fault(line, Some(header), message, "correct the cell"));
            }
        }
        if let Some(earlier) = step.name.as_ref().and_then(|n| named.insert(n.clone(), line)) {
            let name = step.name.as_deref().unwrap_or_default();
            let message = format!("the name `{name}` stands in line {earlier} too");
            faults.push(fault(line, Some("name"), message, "give every joint a name of its own"));
        }
        steps.push(step);
    }
    if let (Decimals::PointOrComma, [Some((of_point, point)), Some((of_comma, comma))]) =
        (decimals, &signs)
    {
        let line = *of_point.max(of_comma);
        let message = format!(
            "`{point}` in line {of_point} has a point and `{comma}` in line {of_comma} a comma: \
             one of them may separate thousands"
        );
        let help = "write all decimals of the table with the same sign and no thousands";
        faults.push(fault(line, None, message, help));
    }
    if faults.len() > SHOWN {
        let more = format!("{} more faults in the table", faults.len() - SHOWN);
        faults.truncate(SHOWN);
        faults.push(fault(1, None, more, "correct these first"));
    }
    Diagnostics::refuse(faults)?;
    if steps.is_empty() {
        let help = "each row below the header is a joint";
        return Err(fault(*first, None, "the table has a header but no rows".into(), help).into());
    }
    let (mut paths, mut notes) = (Vec::new(), Vec::new());
    for column in columns {
        match column {
            Column::Path(path, _) => paths.push(path),
            Column::Note(header) => notes.push(header),
            Column::Name | Column::Expect => {}
        }
    }
    let what = format!("the table `{}`", file.display());
    Ok(Dimension { what, table: true, paths, notes, steps })
}

/// The columns of a header, or the faulty headers with the reason.
fn columns(
    headers: &[String],
) -> Result<Vec<Column>, bracket_base::diag::AtLeastOne<(String, String)>> {
    let mut columns: Vec<Column> = Vec::new();
    let mut faults = Vec::new();
    for header in headers {
        match Column::parse(header) {
            Err(e) => faults.push((header.clone(), e)),
            Ok(c) => {
                let same = |o: &Column| match (o, &c) {
                    (Column::Path(a, _), Column::Path(b, _)) => a == b,
                    (a, b) => a == b,
                };
                if columns.iter().any(same) {
                    faults.push((header.clone(), format!("the column `{header}` is there twice")));
                }
                columns.push(c);
            }
        }
    }
    bracket_base::diag::AtLeastOne::refuse(faults)?;
    Ok(columns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn read(text: &str) -> Result<Dimension, Diagnostics> {
        let file = Path::new("joints.csv");
        let grid =
            grid::of_text(text, Comments::Hash).map_err(|d| Diagnostics::from(d.file(file)))?;
        of_grid(&grid, file)
    }

    #[test]
    fn commas_semicolons_and_tabs() {
        for s in [",", ";", "\t"] {
            let text = ["name,plate.thickness,expect", "# a remark", "A,12,ok", "B,,"].join("\n");
            let d = read(&text.replace(',', s)).unwrap_or_else(|e| panic!("{e:?}"));
            assert_eq!(d.paths.len(), 1);
            let values: Vec<_> = d.steps.iter().map(|s| s.values.clone()).collect();
            assert_eq!(values, [vec![Some(json!(12.0))], vec![None]]);
            assert_eq!(d.steps[0].name.as_deref(), Some("A"));
            assert_eq!((d.steps[0].place.line, d.steps[1].place.line), (Some(3), Some(4)));
            assert!(d.steps[0].expect.is_some() && d.steps[1].expect.is_none());
        }
    }

    /// Spreadsheets of many countries write `12,5;A`. A table with commas as separators cannot
    /// contain a decimal comma.
    #[test]
    fn a_decimal_comma_is_read_where_it_separates_no_cells() {
        for s in [";", "\t"] {
            let text = ["t|loads.U.My [kN m]|bolts.rows", "12,5|-43,25|\"[-105,5; 105]\""];
            let d = read(&text.join("\n").replace('|', s)).unwrap_or_else(|e| panic!("{e:?}"));
            let want = [json!(12.5), json!("-43.25 kN m"), json!([-105.5, 105.0])];
            assert_eq!(d.steps[0].values, want.map(Some));
        }
        assert!(read("t,u\n12,5\n").is_ok(), "two whole numbers");
        assert!(read("t,u\n12,5,1\n").is_err());
    }

    #[test]
    fn a_header_without_end_is_refused_at_once() {
        let header: Vec<String> = (0..200_000).map(|i| format!("parameters.a{i}")).collect();
        let first = read(&format!("{}\n", header.join(","))).map(|_| ()).expect_err("too many");
        assert!(first.into_first().message.starts_with("200000 columns"));
    }

    #[test]
    fn faults_name_line_and_column() {
        for (text, line, header, why) in [
            ("", 1, None, "is empty"),
            ("name\n", 1, None, "no rows"),
            ("a..b\n1\n", 1, Some("a..b"), "not a path"),
            ("t,t\n1,2\n", 1, Some("t"), "there twice"),
            ("t;name\n1,250;A\n", 2, Some("t"), "may be 1.250 or 1250"),
            ("t;u\n12,5;A\n1.250;B\n", 3, None, "may separate thousands"),
            ("t,name\n12,5,A\n", 2, None, "has 3 cells"),
            ("name,t\nA,1\nA,2\n", 3, Some("name"), "in line 2 too"),
            ("expect,t\nmaybe,1\n", 2, Some("expect"), "not a verdict"),
        ] {
            let faults = read(text).expect_err(text);
            let d = faults.first();
            assert!(d.message.contains(why), "{text}: {d:?}");
            assert_eq!((d.place.line, d.place.path.as_deref()), (Some(line), header), "{text}");
        }
        let many: String = (0..20).map(|_| "x,1,2\n").collect();
        let faults =
            read(&format!("t,u,v [mm]\n{}", many.replace("2\n", "[1\n"))).expect_err("many");
        assert_eq!(faults.iter().count(), SHOWN + 1);
    }
}
