//! Profiles and steels of the members of a SAF workbook: its sheets of members, sections and
//! materials.
//!
//! Columns are found by their headers, whose case and order differ between versions of SAF.

use super::frame_model::{FrameMember, FrameModel};
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
use bracket_base::grid::{self, Comments, Grid, Row};
use std::collections::BTreeMap;
use std::path::Path;

/// Length to which workbooks cut the names of sheets.
const LONGEST: usize = 31;

/// The sheets.
const MEMBERS: &str = "StructuralCurveMember";
const SECTIONS: &str = "StructuralCrossSection";
const MATERIALS: &str = "StructuralMaterial";

/// Form codes of sections whose principal axes are turned: angles, Z and sigma sections.
///
/// # Source
/// SAF documentation, annex Formcodes.
const TURNED: [u32; 10] = [4, 10, 11, 12, 16, 17, 20, 21, 22, 23];

/// A sheet whose columns are known by their headers.
struct Sheet {
    name: String,
    header: Row,
    rows: Vec<Row>,
}

/// A header without case, blanks, hyphens and unit.
fn plain(header: &str) -> String {
    let name = header.split('[').next().unwrap_or_default();
    name.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_ascii_lowercase()
}

fn fault(file: &Path, line: usize, sheet: &str, message: String, help: &str) -> Diagnostic {
    let path = Some(sheet.to_owned());
    let place = Place { file: Some(file.into()), line: Some(line), column: None, path };
    Diagnostic { place, ..Diagnostic::input("loads/model", message).help(help) }
}

impl Sheet {
    fn of(name: &str, grid: Grid) -> Option<Self> {
        let mut rows = grid.rows.into_iter();
        Some(Self { name: name.into(), header: rows.next()?, rows: rows.collect() })
    }

    /// The number of a column.
    fn column(&self, header: &str, file: &Path) -> Result<usize, Diagnostics> {
        let found = self.header.cells.iter().position(|c| plain(c) == plain(header));
        found.ok_or_else(|| {
            let message = format!("the sheet `{}` has no column `{header}`", self.name);
            let help = "export the workbook again, or give profile and steel in the table of \
                        joints and save the forces alone as CSV";
            fault(file, self.header.line, &self.name, message, help).into()
        })
    }
}

/// Reads the sheets of a workbook; `None` if it does not have all three.
pub fn read(file: &Path) -> Result<Option<FrameModel>, Diagnostics> {
    let unread = |e| {
        Diagnostic::input("loads/model", format!("the workbook cannot be read: {e}"))
            .file(file)
            .help("check the path")
    };
    let names = grid::sheet_names(file, unread)?;
    let named = |wanted: &str| {
        let cut = &wanted[..wanted.len().min(LONGEST)];
        names.iter().find(|n| n.trim().eq_ignore_ascii_case(cut))
    };
    let mut sheets = Vec::new();
    for wanted in [MEMBERS, SECTIONS, MATERIALS] {
        let Some(name) = named(wanted) else { return Ok(None) };
        let grid = grid::read(file, Some(name), &[], Comments::None, unread)?;
        let Some(sheet) = Sheet::of(name, grid) else { return Ok(None) };
        sheets.push(sheet);
    }
    let [members, sections, materials] = [0, 1, 2].map(|i| &sheets[i]);
    of(members, sections, materials, file).map(Some)
}

fn of(
    members: &Sheet,
    sections: &Sheet,
    materials: &Sheet,
    file: &Path,
) -> Result<FrameModel, Diagnostics> {
    let cell = |row: &Row, i: usize| row.cells.get(i).cloned().unwrap_or_default();
    let [material, quality] = [materials.column("Name", file)?, materials.column("Quality", file)?];
    let qualities: BTreeMap<String, String> =
        materials.rows.iter().map(|r| (cell(r, material), cell(r, quality))).collect();
    let [name, of, profile] = [
        sections.column("Name", file)?,
        sections.column("Material", file)?,
        sections.column("Profile", file)?,
    ];
    let form = sections.column("Form code", file).ok();
    let known: BTreeMap<String, &Row> = sections.rows.iter().map(|r| (cell(r, name), r)).collect();
    let [member, section] = [members.column("Name", file)?, members.column("Cross section", file)?];
    let mut out = BTreeMap::new();
    for row in &members.rows {
        let section = cell(row, section);
        let Some(of_section) = known.get(&section) else {
            let message = format!(
                "member `{}` has the section `{section}`, which the sheet `{}` does not have",
                cell(row, member),
                sections.name
            );
            let help = "export the workbook again with all sections";
            return Err(fault(file, row.line, &members.name, message, help).into());
        };
        let steel = qualities.get(&cell(of_section, of)).cloned().unwrap_or_default();
        // a code may have words behind it
        let code = form.map(|i| cell(of_section, i)).unwrap_or_default();
        let digits: String = code.chars().take_while(char::is_ascii_digit).collect();
        let turned = digits.parse().is_ok_and(|code: u32| TURNED.contains(&code));
        let profile = cell(of_section, profile);
        let path = Some(MEMBERS.to_owned());
        let place = Place { file: Some(file.into()), line: Some(row.line), column: None, path };
        out.insert(cell(row, member), FrameMember { place, section, profile, steel, turned });
    }
    Ok(out.into_iter().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet(name: &str, rows: &[&str]) -> Sheet {
        let cells = |text: &&str| text.split('|').map(str::to_owned).collect();
        let rows = rows.iter().enumerate().map(|(i, r)| Row { line: i + 1, cells: cells(r) });
        let grid = Grid { rows: rows.collect(), separator: None, sheet: None };
        Sheet::of(name, grid).expect("a header")
    }

    fn model(sections: &[&str]) -> Result<FrameModel, Diagnostics> {
        let members = sheet(MEMBERS, &["Type|name|Cross-section", "Beam|B1|CS1", "Column|C1|CS2"]);
        let materials = sheet(MATERIALS, &["Quality|Name", "S 235|Steel"]);
        of(&members, &sheet(SECTIONS, sections), &materials, Path::new("model.xlsx"))
    }

    #[test]
    fn columns_are_found_by_their_headers() {
        let head = "NAME|Material|Form code|Profile";
        let model = model(&[head, "CS1|Steel|1|IPE 300", "CS2|Concrete|16|Z200"]).expect("a model");
        let beam = model.member("B1").expect("a beam");
        assert_eq!((beam.profile.as_str(), beam.steel.as_str()), ("IPE 300", "S 235"));
        assert!(!beam.turned && beam.place.line == Some(2));
        let other = model.member("C1").expect("a column");
        assert!(other.turned && other.steel.is_empty());
        assert_eq!(model.member("b1"), None);
    }

    #[test]
    fn faults_name_sheet_and_row() {
        let lacks = model(&["Name|Material", "CS1|Steel"]).expect_err("no profile").into_first();
        assert!(lacks.message.contains("no column `Profile`"), "{lacks:?}");
        let lacks =
            model(&["Name|Material|Profile", "CS1|Steel|IPE300"]).expect_err("no CS2").into_first();
        assert!(lacks.message.contains("section `CS2`"), "{lacks:?}");
        assert_eq!((lacks.place.line, lacks.place.path.as_deref()), (Some(3), Some(MEMBERS)));
    }
}
