//! Mends the flat, inverted and sliver tets of a mesh on the spot.
//!
//! gmsh occasionally leaves a tet of nearly zero volume. The polyhedron stays exactly the same
//! ([`Polyhedron`]): the volume of each region, the area of each facet, edges and corners. What
//! changes is only how its inside is divided: nodes move in their facet, along their edge or inside
//! their region; edges and faces are removed and inserted; an edge collapses or is split. A change
//! is made only if the worst shape of all tets that it touches rises and all volumes are positive.
//! The same mesh is mended in the same way each time.

mod draft;
mod edges;
mod flips;
mod moves;
mod search;

use super::TetMesh;
use super::polyhedron::Polyhedron;
use super::restore;
use draft::{Draft, shape};
use std::collections::BTreeSet;

/// Smallest accepted dihedral angle \[degrees\]; flatter tets spoil the optimisation problem of the
/// static analysis.
pub const FLAT: f64 = 0.5;

/// Angle that a single change should reach \[degrees\]; rows of changes are not tried then.
const ENOUGH: f64 = 2.0;

/// Changes in all, over the number of flat tets.
const PATIENCE: usize = 20;

/// What was mended.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mended {
    /// Number of flat tets of each body before.
    pub of_body: Vec<usize>,
    /// Number of tets that are still flat.
    pub left: usize,
    /// Smallest dihedral angle before \[degrees\]; 0 if a tet was flat or inverted.
    pub worst_before: f64,
    /// Smallest dihedral angle of the tets that were made \[degrees\].
    pub worst_after: f64,
}

impl Mended {
    /// Number of flat tets before.
    pub fn tets(&self) -> usize {
        self.of_body.iter().sum()
    }

    /// One line for the progress and the log.
    pub fn words(&self) -> String {
        let count = self.tets();
        let tets = if count == 1 { "tet" } else { "tets" };
        let left = match self.left {
            0 => String::new(),
            n => format!("; {n} flat tets are left"),
        };
        format!(
            "mended {count} flat {tets}: smallest dihedral angle {:.2}° before, {:.2}° after{left}",
            self.worst_before, self.worst_after
        )
    }
}

/// The tets of a mesh whose shape is below `least`: flat, inverted and sliver tets.
fn flat_tets(mesh: &TetMesh, least: f64) -> Vec<usize> {
    (0..mesh.tets.len()).filter(|e| shape(&mesh.corners(*e)) < least).collect()
}

/// The worst shape of the tets with a dihedral angle below `least` degrees, if there are any: the
/// smallest angle, or a number that is not positive if one of them is flat or inverted.
pub fn worst_flat(mesh: &TetMesh, least: f64) -> Option<f64> {
    let shapes = (0..mesh.tets.len()).map(|e| shape(&mesh.corners(e)));
    shapes.filter(|own| *own < least).min_by(f64::total_cmp)
}

/// Mends the tets with a dihedral angle below `least` degrees (usually [`FLAT`]) in a mesh whose
/// bodies share nodes and whose tets are oriented alike. Named faces that do not bound a region are
/// lost.
///
/// Returns why it cannot be mended if a flat or inverted tet is left.
pub fn mend(
    mesh: &TetMesh,
    least: f64,
    stop: &dyn Fn() -> bool,
) -> Result<(TetMesh, Mended), String> {
    let enough = least + ENOUGH - FLAT;
    let flat = flat_tets(mesh, least);
    let mut mended = Mended { of_body: vec![0; mesh.bodies.len()], ..Mended::default() };
    for e in &flat {
        mended.of_body[mesh.tet_body[*e] as usize] += 1;
    }
    let polyhedron = Polyhedron::new(mesh);
    let mut draft = Draft::new(mesh, &polyhedron);
    let worst = |draft: &Draft| {
        let alive = (0..draft.tets.len()).filter(|e| draft.alive[*e]);
        alive.map(|e| draft.shape[e]).fold(f64::INFINITY, f64::min)
    };
    mended.worst_before = worst(&draft).max(0.0);
    let mut hopeless: BTreeSet<u32> = BTreeSet::new();
    for _ in 0..PATIENCE * flat.len() {
        let open = (0..draft.tets.len() as u32).filter(|e| {
            draft.alive[*e as usize] && draft.shape[*e as usize] < least && !hopeless.contains(e)
        });
        let by_shape = |a: &u32, b: &u32| {
            draft.shape[*a as usize].total_cmp(&draft.shape[*b as usize]).then(a.cmp(b))
        };
        let Some(next) = open.min_by(by_shape).filter(|_| !stop()) else { break };
        if search::improve(&mut draft, next, least, enough) {
            // the tets around may have become better ones to mend
            hopeless.clear();
        } else {
            hopeless.insert(next);
        }
    }
    mended.worst_after = worst(&draft);
    let made = rebuilt(mesh, &polyhedron, draft)?;
    mended.left = flat_tets(&made, least).len();
    Ok((made, mended))
}

/// The mended mesh, checked against the polyhedron.
fn rebuilt(old: &TetMesh, p: &Polyhedron, draft: Draft) -> Result<TetMesh, String> {
    let alive = (0..draft.tets.len()).filter(|e| draft.alive[*e]);
    let (tets, regions): (Vec<_>, Vec<u32>) =
        alive.map(|e| (draft.tets[e], draft.region[e])).unzip();
    let triangles: Vec<_> = draft.triangles().into_iter().map(|(t, f)| (t, f + 1)).collect();
    let facet_of = restore::facets_of_faces(p, &tets, &regions, &triangles)?;
    let mesh = restore::assemble(old, p, draft.nodes, tets, &regions, &facet_of);
    restore::check(p, &mesh, &regions, &facet_of)?;
    Ok(restore::dropped(mesh))
}

#[cfg(test)]
mod tests;
