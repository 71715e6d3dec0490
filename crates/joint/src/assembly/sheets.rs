//! The plates of a joint, and the flanges and webs of its profiles, as slabs: where strains are
//! averaged, and the zones around bolts, welds and re-entrant edges that are left out.

use super::assembly::{Assembly, InterfaceRule, Surface, SymmetryPlane};
use super::content::{Content, Extent, Fastener};
use super::ledges::LEDGE;
use bracket_engine::estimate::plate::{Plate, Zone, axes_of};
use bracket_engine::mesh::TetMesh;

/// Width of the zone on each side of the toe of a weld or of a re-entrant edge, over the thickness.
/// The stress is singular at such an edge; the check of the weld covers it.
const BESIDE_EDGE: f64 = 0.5;

/// What a sheet is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SheetKind {
    /// A plate of the template: end plate, stiffener, doubler, rib.
    Plate,
    /// A flange of a profile, over its whole width.
    Flange,
    /// The web of a profile, between the flanges.
    Web,
}

/// A bearing face of a head or nut on a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearing {
    /// Its centre \[mm\].
    pub centre: [f64; 3],
    /// Half of the width across flats \[mm\]: the meshed bolts have no washers.
    pub radius: f64,
}

/// A plate, or a flange or web of a profile.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The part that it belongs to.
    pub part: String,
    /// What it is.
    pub kind: SheetKind,
    /// Axis of its normal, 0 = x: its thinnest direction.
    pub normal: usize,
    /// Its slab, not cut by planes of symmetry \[mm\].
    pub extent: Extent,
    /// Heads and nuts that lie on it.
    pub bearings: Vec<Bearing>,
    /// Ends of the toes of welds and of the re-entrant edges where other sheets join it \[mm\].
    pub edges: Vec<[[f64; 3]; 2]>,
}

impl Sheet {
    fn new(part: &str, kind: SheetKind, extent: Extent) -> Self {
        let size = |k: usize| extent[k][1] - extent[k][0];
        let normal =
            [1, 2].into_iter().fold(0, |best, k| if size(k) < size(best) { k } else { best });
        let (bearings, edges) = (Vec::new(), Vec::new());
        Self { part: part.to_owned(), kind, normal, extent, bearings, edges }
    }

    /// Thickness \[mm\].
    pub fn thickness(&self) -> f64 {
        let [low, high] = self.extent[self.normal];
        high - low
    }

    /// The kept side of it in a mesh, with the zones that are left out: under heads and nuts, and
    /// half a thickness around toes and re-entrant edges. `None` if nothing of it is meshed.
    pub fn plate(&self, mesh: &TetMesh, symmetry: &[SymmetryPlane]) -> Option<Plate> {
        let body = mesh.bodies.iter().position(|b| *b == self.part)?;
        let (mut kept, mut mirrored) = (self.extent, [false; 3]);
        for k in symmetry.iter().map(|s| s.axis) {
            if kept[k][1] <= LEDGE {
                return None;
            }
            if kept[k][0] < -LEDGE {
                (kept[k][0], mirrored[k]) = (0.0, true);
            }
        }
        let plate = Plate::in_box(u32::try_from(body).ok()?, self.normal, kept, mirrored);
        Some(Plate { excluded: self.zones(), ..plate })
    }

    fn zones(&self) -> Vec<Zone> {
        let [u, v, _] = axes_of(self.normal);
        let disc =
            |b: &Bearing| Zone::Disc { centre: [b.centre[u], b.centre[v]], radius: b.radius };
        let mut zones: Vec<Zone> = self.bearings.iter().map(disc).collect();
        let grow = BESIDE_EDGE * self.thickness();
        for [a, b] in &self.edges {
            let min = [u, v].map(|k| a[k].min(b[k]) - grow);
            let max = [u, v].map(|k| a[k].max(b[k]) + grow);
            let zone = Zone::Rectangle { min, max };
            // the edges at both faces of a sheet that stands on another one are one in its plane
            if !zones.contains(&zone) {
                zones.push(zone);
            }
        }
        zones
    }
}

/// All sheets of a joint: flanges and webs of its profiles, then its plates. A plate that a web
/// cuts is two.
pub fn sheets(content: &Content, assembly: &Assembly) -> Vec<Sheet> {
    let of_profiles = content.members.iter().flat_map(|m| {
        let flanges = m.flanges.iter().map(|e| (SheetKind::Flange, e));
        let all = flanges.chain(m.web.iter().map(|e| (SheetKind::Web, e)));
        all.map(|(kind, extent)| Sheet::new(&m.part, kind, *extent))
    });
    let plates = content.pieces.iter().map(|p| Sheet::new(&p.part, SheetKind::Plate, p.extent));
    let mut all: Vec<Sheet> = of_profiles.chain(plates).collect();
    for i in 0..all.len() {
        let edges = all.iter().enumerate().filter(|(j, _)| *j != i);
        all[i].edges = edges.flat_map(|(_, other)| joint_edges(&all[i], other, assembly)).collect();
        all[i].bearings = bearings(&all[i], content);
    }
    all
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= LEDGE
}

/// What two boxes have in common along each axis; along one of them they touch. `None` if they do
/// not touch in a face.
fn contact(a: &Extent, b: &Extent) -> Option<(usize, Extent)> {
    let common: Extent = std::array::from_fn(|k| [a[k][0].max(b[k][0]), a[k][1].min(b[k][1])]);
    let size = common.map(|[low, high]| high - low);
    let axis = [1, 2].into_iter().fold(0, |best, k| if size[k] < size[best] { k } else { best });
    let touch = size[axis].abs() <= LEDGE && (0..3).all(|k| k == axis || size[k] > LEDGE);
    touch.then_some((axis, common))
}

/// The edges of the face in which a sheet meets another one, tied or welded, where the surfaces of
/// the two make a corner. Where both end, they are flush.
fn joint_edges(of: &Sheet, other: &Sheet, assembly: &Assembly) -> Vec<[[f64; 3]; 2]> {
    let Some((axis, common)) = contact(&of.extent, &other.extent) else { return Vec::new() };
    if is_open(of, other, axis, &common, &assembly.interfaces) {
        return Vec::new();
    }
    let mut out = Vec::new();
    for i in (0..3).filter(|&i| i != axis) {
        for end in [0, 1] {
            let at = common[i][end];
            if same(of.extent[i][end], at) && same(other.extent[i][end], at) {
                continue;
            }
            let point = |low_or_high: usize| {
                std::array::from_fn(|k| if k == i { at } else { common[k][low_or_high] })
            };
            out.push([point(0), point(1)]);
        }
    }
    out
}

/// True if a contact is given between two sheets of different parts where they touch.
fn is_open(
    a: &Sheet,
    b: &Sheet,
    axis: usize,
    common: &Extent,
    interfaces: &[InterfaceRule],
) -> bool {
    let between = |i: &&InterfaceRule| {
        a.part != b.part && i.between.contains(&a.part) && i.between.contains(&b.part)
    };
    let here = |i: &InterfaceRule| match &i.surface {
        None => true,
        Some((_, Surface::Plane { axis: k, at, min, max })) => {
            let covers = |d: usize| min[d] < common[d][1] && max[d] > common[d][0];
            *k == axis && same(*at, common[axis][0]) && (0..3).all(|d| d == axis || covers(d))
        }
        Some((_, Surface::Mantle { .. })) => false,
    };
    interfaces.iter().filter(between).any(here)
}

/// Heads and nuts on either surface of a sheet.
fn bearings(of: &Sheet, content: &Content) -> Vec<Bearing> {
    let Some((size, _)) = &content.bolt else { return Vec::new() };
    let k = of.normal;
    let mut out = Vec::new();
    for bolt in content.fasteners.iter().filter(|b| b.axis == k && b.passes(&of.part)) {
        for (centre, width) in [(bolt.head, size.head_width), (nut(bolt), size.nut_width)] {
            let inside = |d: usize| of.extent[d][0] < centre[d] && centre[d] < of.extent[d][1];
            let on = of.extent[k].iter().any(|x| same(*x, centre[k]));
            if on && (0..3).all(|d| d == k || inside(d)) {
                out.push(Bearing { centre, radius: 0.5 * width });
            }
        }
    }
    out
}

/// Centre of the bearing face of a nut \[mm\].
fn nut(bolt: &Fastener) -> [f64; 3] {
    let mut at = bolt.head;
    at[bolt.axis] += bolt.toward * bolt.grip();
    at
}

#[cfg(test)]
mod tests;
