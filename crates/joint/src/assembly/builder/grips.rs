//! The grips of the bolts: plies with their room, and the sections of the shanks.

use super::bolts::Bolt;
use super::context::Context;
use super::shapes::Shape;
use crate::assembly::assembly::{Grip, Ply, Room, Section};
use crate::assembly::axes::across;
use crate::assembly::block::Block;
use crate::assembly::content::SAME_PLACE;
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, within};
use crate::assembly::hole::Hole;
use crate::strength::Strength;
use std::collections::BTreeMap;

/// Another hole is a neighbour in a direction if its distance across it is at most this times its
/// distance along it: 45°.
const NEIGHBOUR: f64 = 1.0;

/// A part with holes: its steel, and the blocks of its plates, flanges and webs.
struct Bolted {
    steel: Strength,
    plates: Vec<Vec<Block>>,
}

impl Context<'_> {
    /// The grips of the bolts; `holes` are the holes of each part.
    pub(in crate::assembly) fn grips(
        &self,
        bolts: &[Bolt<'_>],
        holes: &BTreeMap<&str, Vec<Hole>>,
    ) -> Result<Vec<Grip>, AssemblyError> {
        let bolted = self.bolted(holes)?;
        let extents: BTreeMap<&str, f64> = holes.iter().map(|(p, h)| (*p, extent(h))).collect();
        let mut out = Vec::new();
        for b in bolts {
            let Some((size, grade)) = self.inputs.bolt else {
                return entry_fault(&b.name, "the template needs `bolts`");
            };
            let mut plies = Vec::new();
            let mut from = 0.0;
            for (part, thickness) in &b.through {
                let Some(of) = bolted.get(part.as_str()) else {
                    return entry_fault(&b.name, format!("there is no part `{part}`"));
                };
                let middle = b.hole.point(from + 0.5 * thickness);
                let others = holes.get(part.as_str()).map_or(&[][..], Vec::as_slice);
                plies.push(Ply {
                    part: part.clone(),
                    thickness: *thickness,
                    fu: of.steel.fu,
                    room: room(middle, b.hole.axis, &of.plates, others),
                });
                from += thickness;
            }
            let gap = b.shank_gap()?;
            let extent = b.through.iter().filter_map(|(p, _)| extents.get(p.as_str()));
            out.push(Grip {
                part: b.name.clone(),
                axis: b.hole.direction(),
                size: size.clone(),
                grade: grade.clone(),
                hole: if gap > 0.0 { size.d + 2.0 * gap } else { size.hole_normal },
                extent: extent.copied().fold(0.0, f64::max),
                plies,
            });
        }
        Ok(out)
    }

    /// The sections of the shanks between the plies.
    pub(in crate::assembly) fn sections(&self, bolts: &[Bolt<'_>]) -> Vec<Section> {
        let mut out = Vec::new();
        for b in bolts {
            let mut distance = 0.0;
            for (i, (_, thickness)) in b.through.iter().enumerate() {
                if i > 0 {
                    let name = format!("SECTION_{}_{i}", b.name);
                    out.push(Section { part: b.name.clone(), name, surface: b.plane(distance) });
                }
                distance += thickness;
            }
        }
        out
    }

    /// The parts with holes.
    fn bolted(
        &self,
        holes: &BTreeMap<&str, Vec<Hole>>,
    ) -> Result<BTreeMap<String, Bolted>, AssemblyError> {
        let mut out = BTreeMap::new();
        for entry in &self.template.parts {
            let at = entry.name.as_str();
            for scope in within(at, self.scope.turns(&entry.each, entry.when.as_ref()))? {
                let name = within(at, scope.text(at))?;
                if !holes.contains_key(name.as_str()) {
                    continue;
                }
                let thickness = within(at, scope.length(&entry.thickness))?;
                let steel = self.inputs.strength(self.spec, &entry.steel, thickness)?;
                let plates = self.shapes(entry, &scope)?.iter().flat_map(Shape::plates).collect();
                out.insert(name, Bolted { steel, plates });
            }
        }
        Ok(out)
    }
}

/// The room around a hole with its axis through `centre`, a point inside the ply, among the plates
/// and holes of a part. A plate is the blocks that cuts leave of it.
fn room(centre: [f64; 3], axis: usize, plates: &[Vec<Block>], holes: &[Hole]) -> Option<Room> {
    let plate = plates.iter().find(|p| p.iter().any(|b| b.reach(centre, axis, 1.0).is_some()))?;
    let axes = across(axis);
    let edge = axes.map(|k| [-1.0, 1.0].map(|sign| to_edge(centre, k, sign, plate)));
    let mut pitch = [[f64::INFINITY; 2]; 2];
    for other in holes.iter().filter(|o| o.axis == axis) {
        let from = axes.map(|k| other.base[k] - centre[k]);
        // a hole beyond the edge is in another plate of the part
        if (0..2).any(|i| from[i] < -edge[i][0] || from[i] > edge[i][1]) {
            continue;
        }
        for i in 0..2 {
            let (along, off) = (from[i].abs(), from[1 - i].abs());
            if along > 0.0 && off <= NEIGHBOUR * along {
                let nearest = &mut pitch[i][usize::from(from[i] > 0.0)];
                *nearest = nearest.min(along);
            }
        }
    }
    Some(Room { edge, pitch })
}

/// Distance from a point in a plate along axis `k`, in a direction of it, to the edge.
fn to_edge(centre: [f64; 3], k: usize, sign: f64, plate: &[Block]) -> f64 {
    let (mut at, mut distance) = (centre, 0.0);
    // from block to block, as long as one goes on
    loop {
        let further = plate.iter().filter_map(|b| b.reach(at, k, sign)).fold(0.0, f64::max);
        if further < SAME_PLACE {
            return distance;
        }
        distance += further;
        at[k] += sign * further;
    }
}

/// The largest distance between two holes \[mm\].
fn extent(holes: &[Hole]) -> f64 {
    let distance = |a: &Hole, b: &Hole| {
        across(a.axis).iter().map(|&k| (a.base[k] - b.base[k]).powi(2)).sum::<f64>().sqrt()
    };
    let pairs = holes.iter().enumerate().flat_map(|(i, a)| holes[..i].iter().map(move |b| (a, b)));
    pairs.filter(|(a, b)| a.axis == b.axis).map(|(a, b)| distance(a, b)).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hole(x: f64, y: f64, z: f64) -> Hole {
        Hole { base: [x, y, z], axis: 0, toward: -1.0, length: 30.0, radius: 10.0, segments: 16 }
    }

    /// Four holes in a plate of 150 x 200 mm, one in the flange behind, one in a plate that starts
    /// beside.
    #[test]
    fn room_of_a_hole_by_direction() {
        let plate = [[0.0, 15.0], [-75.0, 75.0], [0.0, 200.0]];
        let beside = [[0.0, 15.0], [-75.0, 75.0], [200.0, 400.0]];
        let holes = [
            hole(15.0, -45.0, 40.0),
            hole(15.0, 45.0, 40.0),
            hole(15.0, -45.0, 110.0),
            hole(15.0, 45.0, 110.0),
            hole(15.0, -45.0, 210.0),
        ];
        let plates = [beside, plate].map(|x| vec![Block::of(&x, 2)]);
        let of = |centre: [f64; 3]| room(centre, 0, &plates, &holes);
        let found = of([7.5, -45.0, 40.0]).expect("inside the plate");
        assert_eq!(found.edge, [[30.0, 120.0], [40.0, 160.0]]);
        assert_eq!(found.pitch, [[f64::INFINITY, 90.0], [f64::INFINITY, 70.0]]);
        let upper = of([7.5, 45.0, 110.0]).expect("inside the plate");
        assert_eq!(upper.edge, [[120.0, 30.0], [110.0, 90.0]]);
        assert_eq!(upper.pitch, [[90.0, f64::INFINITY], [70.0, f64::INFINITY]]);
        assert_eq!(of([20.0, 45.0, 110.0]), None);
    }

    /// Beside a notch a web is two boxes: the edge above the hole is that of the notch, the edge
    /// along the beam is the far end of the web.
    #[test]
    fn the_room_of_a_hole_beside_a_notch() {
        let web = [[0.0, 500.0], [-4.0, 4.0], [-140.0, 140.0]];
        let notch = [[-10.0, 80.0], [-100.0, 100.0], [110.0, 150.0]];
        let flange = [[80.0, 500.0], [-75.0, 75.0], [140.0, 150.0]];
        let plates = [vec![Block::of(&flange, 2)], Block::of(&web, 2).minus(&notch)];
        let of = |x: f64| room([x, 0.0, 70.0], 1, &plates, &[]).expect("inside").edge;
        assert_eq!(of(50.0), [[50.0, 450.0], [210.0, 40.0]]);
        assert_eq!(of(120.0), [[120.0, 380.0], [210.0, 70.0]]);
    }

    /// In a triangular plate the edge along an axis is where the sloping side is.
    #[test]
    fn the_room_of_a_hole_in_a_triangle() {
        let outline = [[0.0, 0.0], [200.0, 0.0], [0.0, 300.0]];
        let plates = [Block::triangles(1, [-5.0, 5.0], &outline)];
        // the axes after y are z and x
        let found = room([60.0, 0.0, 40.0], 1, &plates, &[]).expect("inside").edge;
        let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
        assert!(near(found[0][0], 60.0) && near(found[0][1], 180.0), "{found:?}");
        assert!(near(found[1][0], 40.0) && near(found[1][1], 120.0), "{found:?}");
    }

    /// A hole in the next row on the other side counts in the direction that it is nearer to.
    #[test]
    fn staggered_holes_are_neighbours_in_one_direction() {
        let plate = [[0.0, 15.0], [-100.0, 100.0], [0.0, 200.0]];
        let holes = [hole(15.0, 0.0, 50.0), hole(15.0, 30.0, 90.0)];
        let found =
            room([7.5, 0.0, 50.0], 0, &[vec![Block::of(&plate, 2)]], &holes).expect("inside");
        assert_eq!(found.pitch, [[f64::INFINITY; 2], [f64::INFINITY, 40.0]]);
    }
}
