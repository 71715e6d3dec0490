//! Content of a gmsh file before it is checked, common to both formats.

use super::lines::Lines;
use crate::mesh::error::MeshError;
use std::collections::BTreeMap;

/// Content of a file before it is checked.
#[derive(Debug, Default)]
pub struct Raw {
    /// Coordinates in file order.
    pub nodes: Vec<[f64; 3]>,
    /// Tag of each node.
    pub node_tags: Vec<u64>,
    /// Line of each node tag.
    pub node_lines: Vec<usize>,
    /// Names by dimension and physical tag.
    pub names: BTreeMap<(u8, i64), String>,
    /// Tets.
    pub tets: Vec<RawCell<4>>,
    /// Triangles, once per physical surface.
    pub triangles: Vec<RawCell<3>>,
}

/// An element as written in the file.
#[derive(Clone, Copy, Debug)]
pub struct RawCell<const N: usize> {
    /// Tag of the element.
    pub tag: u64,
    /// Physical tag; 0: none.
    pub physical: i64,
    /// Tag of the geometric entity; 0: none.
    pub entity: i64,
    /// Line in the file.
    pub line: usize,
    /// Node tags.
    pub nodes: [u64; N],
}

/// Reads `$PhysicalNames`.
pub fn physical_names(lines: &mut Lines<'_>, raw: &mut Raw) -> Result<(), MeshError> {
    let n: usize = lines.words()?.number("the number of names")?;
    for _ in 0..n {
        let mut words = lines.words()?;
        let dim: u8 = words.number("a dimension")?;
        let tag: i64 = words.number("a physical tag")?;
        let rest = words.rest();
        let name = rest
            .strip_prefix('"')
            .and_then(|r| r.strip_suffix('"'))
            .ok_or_else(|| lines.malformed("a name in quotes", rest))?;
        let twice = raw.names.iter().any(|((d, _), n)| *d == dim && n == name);
        if raw.names.insert((dim, tag), name.to_string()).is_some() || twice {
            let what = format!("the physical name `{name}` (dimension {dim}, tag {tag})");
            return Err(MeshError::Repeated { at: lines.at(), what });
        }
    }
    Ok(())
}

/// Treatment of an element type by the reader.
pub enum Kind {
    Tet,
    Triangle,
    Ignored,
    HigherOrder(&'static str),
    Other(&'static str),
}

/// Treatment of gmsh's element types.
fn kind(code: u32) -> Kind {
    match code {
        4 => Kind::Tet,
        2 => Kind::Triangle,
        1 | 8 | 15 | 26 | 27 | 28 => Kind::Ignored,
        9 => Kind::HigherOrder("6-node triangle"),
        20 | 21 => Kind::HigherOrder("triangle of third order"),
        22..=25 => Kind::HigherOrder("triangle of higher order"),
        11 => Kind::HigherOrder("10-node tetrahedron"),
        29 => Kind::HigherOrder("20-node tetrahedron"),
        30 | 31 => Kind::HigherOrder("tetrahedron of higher order"),
        3 | 10 | 16 => Kind::Other("quadrangle"),
        5 | 12 | 17 => Kind::Other("hexahedron"),
        6 | 13 | 18 => Kind::Other("prism"),
        7 | 14 | 19 => Kind::Other("pyramid"),
        _ => Kind::Other("element of a type this reader does not know"),
    }
}

/// Treatment of an element type; an error for types that the reader does not support.
pub fn checked_kind(code: u32, element: u64, lines: &Lines<'_>) -> Result<Kind, MeshError> {
    match kind(code) {
        Kind::HigherOrder(kind) => Err(MeshError::HigherOrder { at: lines.at(), element, kind }),
        Kind::Other(kind) => Err(MeshError::OtherShape { at: lines.at(), element, kind }),
        k => Ok(k),
    }
}
