//! gmsh files, formats 2.2 and 4.1, ASCII: tets in physical volumes, triangles in physical
//! surfaces.

mod check;
mod lines;
mod v2;
mod v4;

use super::TetMesh;
use super::error::{MeshError, MshPlace};
use lines::Lines;
use std::collections::BTreeMap;
use std::path::Path;

/// What a file holds before it is checked.
#[derive(Debug, Default)]
pub(super) struct Raw {
    /// Coordinates in file order.
    pub nodes: Vec<[f64; 3]>,
    /// Tag of each node.
    pub node_tags: Vec<u64>,
    /// Line of each tag.
    pub node_lines: Vec<usize>,
    /// Names by dimension and physical tag.
    pub names: BTreeMap<(u8, i64), String>,
    /// Tets.
    pub tets: Vec<RawCell<4>>,
    /// Triangles, once per physical surface.
    pub triangles: Vec<RawCell<3>>,
}

/// An element as it stands in the file.
#[derive(Clone, Copy, Debug)]
pub(super) struct RawCell<const N: usize> {
    pub tag: u64,
    pub physical: i64,
    pub line: usize,
    /// Node tags.
    pub nodes: [u64; N],
}

/// Reads a mesh file.
///
/// Tets of negative volume are turned (two nodes swapped). Points, lines, and triangles without a
/// physical surface are ignored; nodes that belong to no tet are dropped.
pub fn read(path: &Path) -> Result<TetMesh, MeshError> {
    read_with_notes(path).map(|(mesh, _)| mesh)
}

/// Like [`read`], and says what it noticed on the way.
pub fn read_with_notes(path: &Path) -> Result<(TetMesh, Vec<String>), MeshError> {
    let bytes = std::fs::read(path)
        .map_err(|source| MeshError::Io { at: MshPlace { file: path.into(), line: 0 }, source })?;
    parse(&bytes, path)
}

/// Reads the bytes of a mesh file; `file` is named in messages.
pub fn parse(bytes: &[u8], file: &Path) -> Result<(TetMesh, Vec<String>), MeshError> {
    let at = |line| MshPlace { file: file.to_path_buf(), line };
    // the header is read from bytes: what follows it in a binary file is not text
    let mut head =
        bytes.split(|b| *b == b'\n').map(|l| String::from_utf8_lossy(l).trim().to_string());
    if head.next().as_deref() != Some("$MeshFormat") {
        return Err(MeshError::NotGmsh { at: at(1) });
    }
    let format = head.next().unwrap_or_default();
    let words: Vec<&str> = format.split_whitespace().collect();
    let version = words.first().copied().unwrap_or_default().to_string();
    if words.get(1) == Some(&"1") {
        return Err(MeshError::Binary { at: at(2) });
    }
    if version != "2.2" && version != "4.1" {
        return Err(MeshError::Version { at: at(2), version });
    }
    let text = std::str::from_utf8(bytes).map_err(|e| MeshError::Malformed {
        at: at(bytes[..e.valid_up_to()].iter().filter(|b| **b == b'\n').count() + 1),
        section: "MeshFormat".to_string(),
        expected: "text",
        found: "bytes that are not UTF-8".to_string(),
    })?;
    let mut lines = Lines::new(text, file);
    let raw = if version == "2.2" { v2::read(&mut lines)? } else { v4::read(&mut lines)? };
    check::finish(raw, file)
}

/// Reads `$PhysicalNames`.
fn physical_names(lines: &mut Lines<'_>, raw: &mut Raw) -> Result<(), MeshError> {
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

/// What to do with an element type.
enum Kind {
    Tet,
    Triangle,
    Ignored,
    HigherOrder(&'static str),
    Other(&'static str),
}

/// gmsh's element types.
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

/// Refuses element types that cannot be read.
fn checked_kind(code: u32, element: u64, lines: &Lines<'_>) -> Result<Kind, MeshError> {
    match kind(code) {
        Kind::HigherOrder(kind) => Err(MeshError::HigherOrder { at: lines.at(), element, kind }),
        Kind::Other(kind) => Err(MeshError::OtherShape { at: lines.at(), element, kind }),
        k => Ok(k),
    }
}

#[cfg(test)]
mod tests;
