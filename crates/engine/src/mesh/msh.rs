//! gmsh files, formats 2.2 and 4.1, ASCII: tets in physical volumes, triangles in physical
//! surfaces.

mod check;
mod lines;
mod raw;
mod v2;
mod v4;

use super::TetMesh;
use super::error::{MeshError, MshPlace};
use bracket_base::text_file;
use bracket_base::words::Text;
use lines::Lines;
use std::path::Path;

/// Reads a mesh file.
///
/// Tets of negative volume are reoriented (two nodes swapped). Points, lines, and triangles without
/// a physical surface are ignored. Nodes that belong to no tet are dropped.
pub fn read(path: &Path) -> Result<TetMesh, MeshError> {
    read_with_notes(path).map(|(mesh, _)| mesh)
}

/// Like [`read`], with the notes of the reader.
pub fn read_with_notes(path: &Path) -> Result<(TetMesh, Vec<Text>), MeshError> {
    parse(&bytes(path)?, path)
}

/// Like [`read`], but lets flat and inverted tets pass: those are to be mended. The tets are
/// oriented alike by their common faces instead of by their volumes.
pub fn read_to_mend(path: &Path) -> Result<TetMesh, MeshError> {
    content(&bytes(path)?, path, true).map(|(mesh, _)| mesh)
}

fn bytes(path: &Path) -> Result<Vec<u8>, MeshError> {
    text_file::bytes(path)
        .map_err(|source| MeshError::Io { at: MshPlace { file: path.into(), line: 0 }, source })
}

/// Reads the bytes of a mesh file; `file` is the name for messages.
pub fn parse(bytes: &[u8], file: &Path) -> Result<(TetMesh, Vec<Text>), MeshError> {
    content(bytes, file, false)
}

fn content(bytes: &[u8], file: &Path, flat_too: bool) -> Result<(TetMesh, Vec<Text>), MeshError> {
    let at = |line| MshPlace { file: file.to_path_buf(), line };
    // the header is read as bytes, because no text follows it in a binary file
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
    check::finish(raw, file, flat_too)
}

#[cfg(test)]
mod tests;
