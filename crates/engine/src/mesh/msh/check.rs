//! Checks the content of a file and builds a consistent mesh from it.

use super::raw::{Raw, RawCell};
use crate::mesh::error::{MeshError, MshPlace};
use crate::mesh::orient;
use crate::mesh::quality::{FLAT_VOLUME, longest_edge};
use crate::mesh::tet::signed_volume;
use crate::mesh::topology::{FaceTable, sorted};
use crate::mesh::{NamedFaces, TetMesh};
use bracket_base::say;
use bracket_base::words::Text;
use std::collections::{BTreeMap, HashMap};
use std::path::Path;

/// Checks the raw mesh, drops unused nodes, and orients the tets alike. Unless `flat_too`, flat and
/// inverted tets are errors.
pub(super) fn finish(
    raw: Raw,
    file: &Path,
    flat_too: bool,
) -> Result<(TetMesh, Vec<Text>), MeshError> {
    let at = |line| MshPlace { file: file.to_path_buf(), line };
    if raw.tets.is_empty() {
        return Err(MeshError::NoTets { at: at(0) });
    }
    if let Some(t) = raw.tets.iter().find(|t| t.physical == 0) {
        return Err(MeshError::NoBody { at: at(t.line), element: t.tag });
    }
    let numbers = Numbers::new(&raw, file)?;
    let mut mesh = TetMesh::default();
    // nodes keep their order in the file; nodes without a tet are dropped
    let mut new_index = vec![u32::MAX; raw.nodes.len()];
    let mut tets: Vec<[u32; 4]> = Vec::with_capacity(raw.tets.len());
    for t in &raw.tets {
        let nodes = numbers.of(t, file)?;
        for n in nodes {
            new_index[n as usize] = 0;
        }
        tets.push(nodes);
    }
    for (i, x) in raw.nodes.iter().enumerate() {
        if new_index[i] == 0 {
            new_index[i] = mesh.nodes.len() as u32;
            mesh.nodes.push(*x);
        }
    }
    tets.iter_mut().for_each(|t| *t = t.map(|n| new_index[n as usize]));
    mesh.tets = tets;
    let mut turned = 0;
    if !flat_too {
        turned = orient_by_volume(&mut mesh, &raw, file)?;
    }
    let bodies = groups(raw.tets.iter().map(|t| t.physical));
    mesh.bodies = bodies.keys().map(|p| name(&raw, 3, *p)).collect();
    mesh.tet_body = raw.tets.iter().map(|t| bodies[&t.physical]).collect();
    mesh.tet_region = regions(&raw, mesh.bodies.len());

    check_tets(&mesh, &raw, file)?;
    if flat_too {
        turned = orient::alike(&mut mesh).map_err(|pair| folded(pair, &raw, file))?;
    }
    let table = FaceTable::new(&mesh.tets);
    check_sides(&table, &raw, file)?;

    let surfaces = groups(raw.triangles.iter().map(|t| t.physical));
    mesh.faces = surfaces
        .keys()
        .map(|p| NamedFaces { name: name(&raw, 2, *p), triangles: Vec::new() })
        .collect();
    let mut seen: HashMap<(i64, [u32; 3]), u64> = HashMap::with_capacity(raw.triangles.len());
    for t in &raw.triangles {
        let nodes = numbers.of(t, file)?.map(|n| new_index[n as usize]);
        let surface = &mut mesh.faces[surfaces[&t.physical] as usize];
        if nodes.contains(&u32::MAX) || table.owners(nodes).is_empty() {
            let surface = surface.name.clone();
            return Err(MeshError::LooseTriangle { at: at(t.line), element: t.tag, surface });
        }
        if let Some(first) = seen.insert((t.physical, sorted(nodes).0), t.tag) {
            return Err(MeshError::Duplicate {
                at: at(t.line),
                kind: "triangle",
                element: t.tag,
                first,
            });
        }
        surface.triangles.push(nodes);
    }

    let mut notes = Vec::new();
    if turned > 0 {
        notes.push(say!(
            "{} of {} tetrahedra had the opposite node order and were turned",
            turned,
            mesh.tets.len()
        ));
    }
    Ok((mesh, notes))
}

/// The name of a physical group; gmsh allows groups without one.
fn name(raw: &Raw, dim: u8, physical: i64) -> String {
    let kind = if dim == 3 { "VOLUME" } else { "SURFACE" };
    raw.names.get(&(dim, physical)).cloned().unwrap_or_else(|| format!("{kind}_{physical}"))
}

/// Region of each tet, numbered by body and entity; empty if every body is a single entity.
fn regions(raw: &Raw, bodies: usize) -> Vec<u32> {
    let mut numbers: BTreeMap<(i64, i64), u32> =
        raw.tets.iter().map(|t| ((t.physical, t.entity), 0)).collect();
    if numbers.len() == bodies {
        return Vec::new();
    }
    numbers.values_mut().zip(0..).for_each(|(number, i)| *number = i);
    raw.tets.iter().map(|t| numbers[&(t.physical, t.entity)]).collect()
}

/// Physical tags in increasing order, each with its index.
fn groups(tags: impl Iterator<Item = i64>) -> BTreeMap<i64, u32> {
    let mut all: BTreeMap<i64, u32> = tags.map(|t| (t, 0)).collect();
    for (i, index) in all.values_mut().enumerate() {
        *index = i as u32;
    }
    all
}

/// Turns tets of negative volume; returns their number. Flat tets are errors.
fn orient_by_volume(mesh: &mut TetMesh, raw: &Raw, file: &Path) -> Result<usize, MeshError> {
    let mut turned = 0;
    for (e, raw_tet) in raw.tets.iter().enumerate() {
        let x = mesh.corners(e);
        let volume = signed_volume(&x);
        let limit = FLAT_VOLUME * longest_edge(&x).powi(3);
        if volume.abs() <= limit {
            let at = MshPlace { file: file.to_path_buf(), line: raw_tet.line };
            return Err(MeshError::Flat { at, element: raw_tet.tag, volume, limit });
        }
        if volume < 0.0 {
            mesh.tets[e].swap(2, 3);
            turned += 1;
        }
    }
    Ok(turned)
}

/// Checks that no two tets have the same nodes.
fn check_tets(mesh: &TetMesh, raw: &Raw, file: &Path) -> Result<(), MeshError> {
    let mut keys: Vec<([u32; 4], u32)> = (0u32..)
        .zip(&mesh.tets)
        .map(|(e, t)| {
            let mut k = *t;
            k.sort_unstable();
            (k, e)
        })
        .collect();
    keys.sort_unstable();
    match keys.windows(2).find(|w| w[0].0 == w[1].0) {
        None => Ok(()),
        Some(w) => {
            let (first, second) = (&raw.tets[w[0].1 as usize], &raw.tets[w[1].1 as usize]);
            let at = MshPlace { file: file.to_path_buf(), line: second.line };
            Err(MeshError::Duplicate {
                at,
                kind: "tetrahedron",
                element: second.tag,
                first: first.tag,
            })
        }
    }
}

/// The error for two tets that overlap.
fn folded([first, second]: [u32; 2], raw: &Raw, file: &Path) -> MeshError {
    let (element, other) = (&raw.tets[second as usize], &raw.tets[first as usize]);
    let at = MshPlace { file: file.to_path_buf(), line: element.line };
    MeshError::Folded { at, element: element.tag, other: other.tag }
}

/// Checks that a face has at most two tets, on opposite sides: their outward orders of the face are
/// opposite.
fn check_sides(table: &FaceTable, raw: &Raw, file: &Path) -> Result<(), MeshError> {
    for owners in table.faces() {
        if owners.len() > 2 || (owners.len() == 2 && owners[0].even == owners[1].even) {
            let later = if owners[0].even == owners[1].even { 1 } else { owners.len() - 1 };
            return Err(folded([owners[0].tet, owners[later].tet], raw, file));
        }
    }
    Ok(())
}

/// Map from node tags to positions in the file.
enum Numbers {
    /// For small tags: a table.
    Dense(Vec<u32>),
    /// For sparse tags: a hash map.
    Sparse(HashMap<u64, u32>),
}

impl Numbers {
    fn new(raw: &Raw, file: &Path) -> Result<Self, MeshError> {
        let largest = raw.node_tags.iter().copied().max().unwrap_or(0);
        let mut numbers = if largest < 4 * raw.nodes.len() as u64 + 1000 {
            Numbers::Dense(vec![u32::MAX; largest as usize + 1])
        } else {
            Numbers::Sparse(HashMap::with_capacity(raw.nodes.len()))
        };
        for (i, tag) in (0u32..).zip(&raw.node_tags) {
            let fresh = match &mut numbers {
                Numbers::Dense(v) => std::mem::replace(&mut v[*tag as usize], i) == u32::MAX,
                Numbers::Sparse(m) => m.insert(*tag, i).is_none(),
            };
            if !fresh {
                let at = MshPlace { file: file.to_path_buf(), line: raw.node_lines[i as usize] };
                return Err(MeshError::Repeated { at, what: format!("node {tag}") });
            }
        }
        Ok(numbers)
    }

    fn of<const N: usize>(&self, cell: &RawCell<N>, file: &Path) -> Result<[u32; N], MeshError> {
        let mut nodes = [u32::MAX; N];
        for (n, tag) in nodes.iter_mut().zip(cell.nodes) {
            *n = match self {
                Numbers::Dense(v) => {
                    usize::try_from(tag).ok().and_then(|t| v.get(t)).copied().unwrap_or(u32::MAX)
                }
                Numbers::Sparse(m) => m.get(&tag).copied().unwrap_or(u32::MAX),
            };
            if *n == u32::MAX {
                let at = MshPlace { file: file.to_path_buf(), line: cell.line };
                return Err(MeshError::UnknownNode { at, element: cell.tag, node: tag });
            }
        }
        Ok(nodes)
    }
}
