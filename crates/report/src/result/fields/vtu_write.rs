//! The bytes of a `.vtu` file.

use crate::result::fields::vtu::{VtuError, VtuGrid, nodes_per_cell};
use std::fmt::Write as _;

impl VtuGrid {
    /// The bytes of the file.
    pub fn to_bytes(&self) -> Result<Vec<u8>, VtuError> {
        self.check()?;
        let per_cell = nodes_per_cell(self.cell_type)?;
        let cells = self.cells.len() / per_cell;
        let mut head = String::from("<?xml version=\"1.0\"?>\n");
        let mut data = Vec::new();
        // writing to a String cannot fail, so the results of `write!` are dropped
        let _ = write!(
            head,
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">\n<UnstructuredGrid>\n"
        );
        if !self.field_data.is_empty() {
            head.push_str("<FieldData>\n");
            for (name, components, values) in &self.field_data {
                let tuples = Some(values.len() / components);
                array(
                    &mut head,
                    &mut data,
                    "Float64",
                    name,
                    *components,
                    tuples,
                    values.iter().map(|v| v.to_le_bytes()),
                );
            }
            head.push_str("</FieldData>\n");
        }
        let _ = write!(
            head,
            "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{cells}\">\n<Points>\n",
            self.points.len()
        );
        array(
            &mut head,
            &mut data,
            "Float64",
            "Points",
            3,
            None,
            self.points.iter().flatten().map(|v| v.to_le_bytes()),
        );
        head.push_str("</Points>\n<Cells>\n");
        let connectivity = self.cells.iter().map(|&n| i64::from(n).to_le_bytes());
        array(&mut head, &mut data, "Int64", "connectivity", 0, None, connectivity);
        let offsets = (1..=cells).map(|i| ((i * per_cell) as i64).to_le_bytes());
        array(&mut head, &mut data, "Int64", "offsets", 0, None, offsets);
        array(
            &mut head,
            &mut data,
            "UInt8",
            "types",
            0,
            None,
            (0..cells).map(|_| [self.cell_type]),
        );
        head.push_str("</Cells>\n");
        for (tag, arrays) in [("PointData", &self.point_data), ("CellData", &self.cell_data)] {
            if arrays.is_empty() {
                continue;
            }
            let _ = writeln!(head, "<{tag}>");
            for (name, components, values) in arrays {
                array(
                    &mut head,
                    &mut data,
                    "Float64",
                    name,
                    *components,
                    None,
                    values.iter().map(|v| v.to_le_bytes()),
                );
            }
            let _ = writeln!(head, "</{tag}>");
        }
        head.push_str("</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
        let mut bytes = head.into_bytes();
        bytes.append(&mut data);
        bytes.extend_from_slice(b"\n</AppendedData>\n</VTKFile>\n");
        Ok(bytes)
    }
}

/// Appends one array: its tag to the header, length and values to the data.
fn array<const N: usize>(
    head: &mut String,
    data: &mut Vec<u8>,
    kind: &str,
    name: &str,
    components: usize,
    tuples: Option<usize>,
    values: impl Iterator<Item = [u8; N]>,
) {
    let _ = write!(head, "<DataArray type=\"{kind}\" Name=\"{}\"", escape(name));
    if components > 0 {
        let _ = write!(head, " NumberOfComponents=\"{components}\"");
    }
    if let Some(tuples) = tuples {
        let _ = write!(head, " NumberOfTuples=\"{tuples}\"");
    }
    let offset = data.len();
    let _ = writeln!(head, " format=\"appended\" offset=\"{offset}\"/>");
    data.extend_from_slice(&[0; 8]);
    data.extend(values.flatten());
    let length = (data.len() - offset - 8) as u64;
    data[offset..offset + 8].copy_from_slice(&length.to_le_bytes());
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
