//! The plates of a joint, and the flanges and webs of its profiles, as slabs: where strains are
//! averaged, and the zones around bolts, welds and re-entrant edges that are left out.

use super::assembly::{Assembly, InterfaceRule, Surface, SymmetryPlane};
use super::axes::unit;
use super::block::Block;
use super::content::{Content, Extent, Fastener};
use super::ledges::LEDGE;
use super::turn::Turn;
use bracket_base::math::vec3::{V3, dot};
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
    /// Its slab before it is turned, not cut by planes of symmetry \[mm\].
    pub extent: Extent,
    /// How it is turned.
    pub turn: Option<Turn>,
    /// What it is in space, where it is no box along the axes of the joint.
    pub oblique: Vec<Block>,
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
        let part = part.to_owned();
        Self { part, kind, normal, extent, turn: None, oblique: Vec::new(), bearings, edges }
    }

    /// The same, turned; what it is in space.
    fn turned(self, turn: Option<Turn>, oblique: Vec<Block>) -> Self {
        Self { turn, oblique, ..self }
    }

    /// What it is in space.
    fn blocks(&self) -> Vec<Block> {
        match self.oblique.is_empty() {
            true => vec![Block::of(&self.extent, 2)],
            false => self.oblique.clone(),
        }
    }

    /// Its own axes in space: the two of its plane in rising order, then its normal.
    fn axes(&self) -> [V3; 3] {
        axes_of(self.normal).map(|k| self.turn.map_or(unit(k), |t| t.vector(unit(k))))
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
        // what lies beyond a plane of symmetry is not meshed
        let beyond = |k: usize| self.oblique.iter().all(|b| b.bounds()[k][1] <= LEDGE);
        if !self.oblique.is_empty() && symmetry.iter().any(|s| beyond(s.axis)) {
            return None;
        }
        // a turned sheet is cut by the planes across its line; of others it has one side alone
        let cuts = symmetry.iter().map(|s| s.axis);
        for k in cuts.filter(|k| self.turn.is_none_or(|t| t.axis == *k)) {
            if kept[k][1] <= LEDGE {
                return None;
            }
            if kept[k][0] < -LEDGE {
                (kept[k][0], mirrored[k]) = (0.0, true);
            }
        }
        let body = u32::try_from(body).ok()?;
        let mut plate = Plate::in_box(body, self.normal, kept, mirrored);
        if let Some(turn) = &self.turn {
            plate.axes = self.axes();
            for (i, k) in axes_of(self.normal).into_iter().enumerate() {
                // coordinates count from the origin of the joint
                let moved = dot(turn.at, plate.axes[i]) - turn.at[k];
                plate.extent[i] = plate.extent[i].map(|x| x + moved);
            }
        }
        Some(Plate { excluded: self.zones(), ..plate })
    }

    fn zones(&self) -> Vec<Zone> {
        let [u, v, _] = self.axes();
        let place = |p: V3| [dot(p, u), dot(p, v)];
        let disc = |b: &Bearing| Zone::Disc { centre: place(b.centre), radius: b.radius };
        let mut zones: Vec<Zone> = self.bearings.iter().map(disc).collect();
        let grow = BESIDE_EDGE * self.thickness();
        for [a, b] in &self.edges {
            let (a, b) = (place(*a), place(*b));
            let min = [0, 1].map(|k| a[k].min(b[k]) - grow);
            let max = [0, 1].map(|k| a[k].max(b[k]) + grow);
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
        let facets = m.facets.iter().map(|(extent, turn)| {
            let block = Block::of(extent, turn.axis).turned(turn);
            Sheet::new(&m.part, SheetKind::Web, *extent).turned(Some(*turn), vec![block])
        });
        let flat = all.map(|(kind, extent)| {
            let blocks = m.turn.map(|t| vec![Block::of(extent, t.axis).turned(&t)]);
            Sheet::new(&m.part, kind, *extent).turned(m.turn, blocks.unwrap_or_default())
        });
        flat.chain(facets).collect::<Vec<_>>()
    });
    let plates = content
        .pieces
        .iter()
        .map(|p| Sheet::new(&p.part, SheetKind::Plate, p.extent).turned(p.turn, p.drawn.clone()));
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
    if !(of.oblique.is_empty() && other.oblique.is_empty()) {
        return oblique_edges(of, other, assembly);
    }
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

/// The same for sheets of any direction: the sides of the rectangle, in the plane of the first,
/// round what of the other one is in its thickness, without those on its own border. Sheets of two
/// parts with a contact between them are taken as open.
fn oblique_edges(of: &Sheet, other: &Sheet, assembly: &Assembly) -> Vec<[V3; 2]> {
    let between = |i: &&InterfaceRule| {
        of.part != other.part && i.between.contains(&of.part) && i.between.contains(&other.part)
    };
    if assembly.interfaces.iter().any(|i| between(&i)) {
        return Vec::new();
    }
    let axes = of.axes();
    let own: Vec<V3> = of.blocks().iter().flat_map(Block::corners).collect();
    let range = |points: &[V3], axis: V3| {
        let all = points.iter().map(|p| dot(*p, axis));
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    };
    let [low, high] = range(&own, axes[2]);
    let grown = [low - LEDGE, high + LEDGE];
    let blocks = other.blocks();
    let near: Vec<V3> = blocks.iter().flat_map(|b| b.between(axes[2], grown)).collect();
    let (mine, its) = (
        [range(&own, axes[0]), range(&own, axes[1])],
        [range(&near, axes[0]), range(&near, axes[1])],
    );
    let common = [0, 1].map(|i| [mine[i][0].max(its[i][0]), mine[i][1].min(its[i][1])]);
    if common.iter().any(|[a, b]| b - a <= -LEDGE) {
        return Vec::new();
    }
    let middle = 0.5 * (low + high);
    let place = |c: [f64; 2]| -> V3 {
        std::array::from_fn(|k| c[0] * axes[0][k] + c[1] * axes[1][k] + middle * axes[2][k])
    };
    let mut out = Vec::new();
    for i in [0, 1] {
        for end in [0, 1] {
            let at = common[i][end];
            if !same(mine[i][end], at) {
                let point = |o: f64| place(if i == 0 { [at, o] } else { [o, at] });
                out.push([point(common[1 - i][0]), point(common[1 - i][1])]);
            }
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
    let bolts = content.fasteners.iter().filter(|b| b.axis == k && b.passes(&of.part));
    // the normal of a sheet that is turned about it stays
    for bolt in bolts.filter(|_| of.turn.is_none_or(|t| t.axis == k)) {
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
