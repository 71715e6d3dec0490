//! Format 2.2: one list of nodes, one list of elements with their tags.

use super::lines::Lines;
use super::raw::{Kind, Raw, RawCell, checked_kind, physical_names};
use crate::mesh::error::{MeshError, MshPlace};

pub(super) fn read(lines: &mut Lines<'_>) -> Result<Raw, MeshError> {
    let mut raw = Raw::default();
    let (mut nodes, mut elements) = (false, false);
    while let Some(section) = lines.section()? {
        match section {
            "PhysicalNames" => physical_names(lines, &mut raw)?,
            "Nodes" => {
                nodes = true;
                let n: usize = lines.words()?.number("the number of nodes")?;
                raw.nodes.reserve(n.min(lines.left() / 4));
                raw.node_tags.reserve(n.min(lines.left() / 4));
                for _ in 0..n {
                    let mut words = lines.words()?;
                    let tag = words.number("a node tag")?;
                    raw.nodes.push(words.point(tag)?);
                    raw.node_tags.push(tag);
                    raw.node_lines.push(lines.line());
                }
            }
            "Elements" => {
                elements = true;
                let n: usize = lines.words()?.number("the number of elements")?;
                raw.tets.reserve(n.min(lines.left() / 12));
                for _ in 0..n {
                    element(lines, &mut raw)?;
                }
            }
            _ => {
                lines.skip()?;
                continue;
            }
        }
        lines.end()?;
    }
    for (found, section) in [(nodes, "Nodes"), (elements, "Elements")] {
        if !found {
            return Err(MeshError::MissingSection {
                at: MshPlace { line: 0, ..lines.at() },
                section,
            });
        }
    }
    Ok(raw)
}

fn element(lines: &mut Lines<'_>, raw: &mut Raw) -> Result<(), MeshError> {
    let mut words = lines.words()?;
    let tag = words.number("an element tag")?;
    let code = words.number("an element type")?;
    let line = lines.line();
    let kind = checked_kind(code, tag, lines)?;
    let ntags: usize = words.number("the number of tags")?;
    let (mut physical, mut entity) = (0, 0);
    for i in 0..ntags {
        let t: i64 = words.number("a tag")?;
        match i {
            0 => physical = t.saturating_abs(),
            1 => entity = t,
            _ => {}
        }
    }
    match kind {
        Kind::Tet => {
            let nodes = words.numbers("a node tag")?;
            raw.tets.push(RawCell { tag, physical, entity, line, nodes });
        }
        Kind::Triangle if physical != 0 => {
            let nodes = words.numbers("a node tag")?;
            raw.triangles.push(RawCell { tag, physical, entity, line, nodes });
        }
        _ => {}
    }
    Ok(())
}
