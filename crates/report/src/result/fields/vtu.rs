//! Fields as `.vtu` files (VTK XML, appended raw): written for ParaView, read back bit for bit by
//! `bracket verify`.
//!
//! The format is little-endian, with 64-bit block headers, 64-bit floats, and one cell type per
//! file. The reader accepts only the form that the writer produces, and checks every length before
//! use.

use bracket_base::diag::Diagnostic;

/// Triangle, 3 nodes.
pub const TRIANGLE: u8 = 5;
/// Tetrahedron, 4 nodes.
pub const TETRA: u8 = 10;
/// Quadratic triangle, 6 nodes, mid-side nodes on edges 01 12 02.
pub const QUADRATIC_TRIANGLE: u8 = 22;
/// Quadratic tetrahedron, 10 nodes, mid-side nodes in the order of
/// [`bracket_engine::mesh::tet::EDGES`], which is VTK's.
pub const QUADRATIC_TETRA: u8 = 24;

/// A named array: name, number of components, values (components fastest).
pub type Array = (String, usize, Vec<f64>);

/// An unstructured grid with its fields.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VtuGrid {
    /// Node coordinates \[mm\].
    pub points: Vec<[f64; 3]>,
    /// Node indices, [`nodes_per_cell`] per cell.
    pub cells: Vec<u32>,
    /// VTK's number of the cell type.
    pub cell_type: u8,
    /// Fields with one value per point.
    pub point_data: Vec<Array>,
    /// Fields with one value per cell.
    pub cell_data: Vec<Array>,
    /// Values of the whole grid.
    pub field_data: Vec<Array>,
}

/// Reason why a `.vtu` file cannot be written or read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum VtuError {
    /// The cell type is not supported.
    #[error("cell type {0} is not one of 5, 10, 22, 24")]
    CellType(u64),
    /// An array has the wrong length.
    #[error("array `{name}` has {found} values where {wanted} are wanted")]
    Length {
        /// Name of the array.
        name: String,
        /// Its length.
        found: usize,
        /// The length it must have.
        wanted: usize,
    },
    /// An array name is empty or used twice.
    #[error("array name `{0}` is empty or used twice")]
    Name(String),
    /// A cell refers to a point that does not exist.
    #[error("a cell refers to point {found}, there are {points}")]
    Point {
        /// The index.
        found: u64,
        /// Number of points.
        points: usize,
    },
    /// The file does not have the form that this program writes.
    #[error("not a `.vtu` file of this program: {0}")]
    Form(String),
    /// The file ends early.
    #[error("array `{name}` runs past the end of the file: it was cut short")]
    Truncated {
        /// Name of the array.
        name: String,
    },
}

impl From<VtuError> for Diagnostic {
    fn from(e: VtuError) -> Self {
        Diagnostic::input("report/vtu", e.to_string()).help(
            "use a field file of a finished result folder, unchanged; run the analysis again if \
             it is damaged",
        )
    }
}

/// Nodes of a cell of the given VTK type.
pub fn nodes_per_cell(cell_type: u8) -> Result<usize, VtuError> {
    match cell_type {
        TRIANGLE => Ok(3),
        TETRA => Ok(4),
        QUADRATIC_TRIANGLE => Ok(6),
        QUADRATIC_TETRA => Ok(10),
        other => Err(VtuError::CellType(other.into())),
    }
}

impl VtuGrid {
    /// Number of cells.
    pub fn cell_count(&self) -> Result<usize, VtuError> {
        Ok(self.cells.len() / nodes_per_cell(self.cell_type)?)
    }

    /// The point field called `name`.
    pub fn point_array(&self, name: &str) -> Option<&Array> {
        self.point_data.iter().find(|a| a.0 == name)
    }

    /// The cell field called `name`.
    pub fn cell_array(&self, name: &str) -> Option<&Array> {
        self.cell_data.iter().find(|a| a.0 == name)
    }

    /// The grid-wide values called `name`.
    pub fn field_array(&self, name: &str) -> Option<&Array> {
        self.field_data.iter().find(|a| a.0 == name)
    }

    /// Refuses arrays of the wrong length, names used twice and cells without their points.
    pub(super) fn check(&self) -> Result<(), VtuError> {
        let per_cell = nodes_per_cell(self.cell_type)?;
        let cells = self.cells.len() / per_cell;
        let length = |name: &str, found: usize, wanted: usize| {
            (found == wanted).then_some(()).ok_or(VtuError::Length {
                name: name.into(),
                found,
                wanted,
            })
        };
        length("connectivity", self.cells.len(), cells * per_cell)?;
        if let Some(&n) = self.cells.iter().find(|&&n| n as usize >= self.points.len()) {
            return Err(VtuError::Point { found: n.into(), points: self.points.len() });
        }
        for (arrays, count) in [
            (&self.point_data, Some(self.points.len())),
            (&self.cell_data, Some(cells)),
            (&self.field_data, None),
        ] {
            for (i, (name, components, values)) in arrays.iter().enumerate() {
                if name.is_empty() || *components == 0 || arrays[..i].iter().any(|a| a.0 == *name) {
                    return Err(VtuError::Name(name.clone()));
                }
                length(
                    name,
                    values.len(),
                    components * count.unwrap_or(values.len() / components),
                )?;
            }
        }
        Ok(())
    }
}
