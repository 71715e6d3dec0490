//! Format 4.1: nodes and elements in blocks, physical tags on the geometric entities.

use super::lines::Lines;
use super::raw::{Kind, Raw, RawCell, checked_kind, physical_names};
use crate::mesh::error::{MeshError, MshPlace};
use std::collections::BTreeMap;

/// Physical tags of each entity, by dimension and tag.
type Entities = BTreeMap<(u8, i64), Vec<i64>>;

pub(super) fn read(lines: &mut Lines<'_>) -> Result<Raw, MeshError> {
    let mut raw = Raw::default();
    let mut entities = None;
    let (mut has_nodes, mut has_elements) = (false, false);
    while let Some(section) = lines.section()? {
        match section {
            "PhysicalNames" => physical_names(lines, &mut raw)?,
            "Entities" => entities = Some(read_entities(lines)?),
            "Nodes" => {
                has_nodes = true;
                nodes(lines, &mut raw)?;
            }
            "Elements" => {
                has_elements = true;
                let Some(entities) = &entities else {
                    return Err(missing(lines, "Entities"));
                };
                elements(lines, entities, &mut raw)?;
            }
            _ => {
                lines.skip()?;
                continue;
            }
        }
        lines.end()?;
    }
    match (has_nodes, has_elements) {
        (false, _) => Err(missing(lines, "Nodes")),
        (_, false) => Err(missing(lines, "Elements")),
        _ => Ok(raw),
    }
}

fn missing(lines: &Lines<'_>, section: &'static str) -> MeshError {
    MeshError::MissingSection { at: MshPlace { line: 0, ..lines.at() }, section }
}

fn read_entities(lines: &mut Lines<'_>) -> Result<Entities, MeshError> {
    let mut entities = Entities::new();
    let counts: [u64; 4] = lines.words()?.numbers("the numbers of entities")?;
    for (dim, n) in counts.into_iter().enumerate() {
        for _ in 0..n {
            let mut words = lines.words()?;
            let tag: i64 = words.number("an entity tag")?;
            // a point has one position, other entities a bounding box
            for _ in 0..if dim == 0 { 3 } else { 6 } {
                let _: f64 = words.number("a coordinate")?;
            }
            let count: usize = words.number("the number of physical tags")?;
            let mut physical = Vec::new();
            for _ in 0..count {
                let p: i64 = words.number("a physical tag")?;
                physical.push(p.saturating_abs());
            }
            if dim == 3 && count > 1 {
                return Err(MeshError::TwoBodies { at: lines.at(), tag, count });
            }
            entities.insert((dim as u8, tag), physical);
        }
    }
    Ok(entities)
}

fn nodes(lines: &mut Lines<'_>, raw: &mut Raw) -> Result<(), MeshError> {
    let [blocks, total, _, _] = lines.words()?.numbers("the numbers of blocks and nodes")?;
    let room = (total as usize).min(lines.left() / 4);
    raw.nodes.reserve(room);
    raw.node_tags.reserve(room);
    for _ in 0..blocks {
        let mut words = lines.words()?;
        for _ in 0..3 {
            let _: i64 = words.number("an entity, its dimension and the parametric flag")?;
        }
        let n: usize = words.number("the number of nodes")?;
        let start = raw.node_tags.len();
        for _ in 0..n {
            raw.node_tags.push(lines.words()?.number("a node tag")?);
            raw.node_lines.push(lines.line());
        }
        for i in start..start + n {
            let node = raw.node_tags[i];
            raw.nodes.push(lines.words()?.point(node)?);
        }
    }
    Ok(())
}

fn elements(lines: &mut Lines<'_>, entities: &Entities, raw: &mut Raw) -> Result<(), MeshError> {
    let [blocks, total, _, _] = lines.words()?.numbers("the numbers of blocks and elements")?;
    raw.tets.reserve((total as usize).min(lines.left() / 12));
    for _ in 0..blocks {
        let mut words = lines.words()?;
        let dim: u8 = words.number("a dimension")?;
        let entity: i64 = words.number("an entity tag")?;
        let code: u32 = words.number("an element type")?;
        let n: usize = words.number("the number of elements")?;
        let at = lines.at();
        let physical = entities.get(&(dim, entity));
        for _ in 0..n {
            let mut words = lines.words()?;
            let tag = words.number("an element tag")?;
            let line = lines.line();
            let unknown = |kind| MeshError::UnknownEntity { at: at.clone(), kind, tag: entity };
            match checked_kind(code, tag, lines)? {
                Kind::Tet => {
                    let physical =
                        physical.ok_or_else(|| unknown("volume"))?.first().copied().unwrap_or(0);
                    let nodes = words.numbers("a node tag")?;
                    raw.tets.push(RawCell { tag, physical, entity, line, nodes });
                }
                Kind::Triangle => {
                    let nodes = words.numbers("a node tag")?;
                    for p in physical.ok_or_else(|| unknown("surface"))? {
                        raw.triangles.push(RawCell { tag, physical: *p, entity, line, nodes });
                    }
                }
                _ => {}
            }
        }
    }
    Ok(())
}
