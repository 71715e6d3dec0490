//! The grips of the bolts: plies with their room, and the sections of the shanks.

use super::bolts::Bolt;
use super::context::Context;
use super::shapes::Shape;
use crate::assembly::assembly::{Grip, Ply, Room, Section};
use crate::assembly::axes::across;
use crate::assembly::block::Block;
use crate::assembly::content::{Extent, SAME_PLACE};
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, within};
use crate::assembly::hole::Hole;
use crate::strength::Strength;
use std::collections::BTreeMap;

/// Another hole is a neighbour in a direction if its distance across it is at most this times its
/// distance along it: 45°.
const NEIGHBOUR: f64 = 1.0;

/// A part with holes: its steel, and its plates, flanges and webs.
struct Bolted {
    steel: Strength,
    plates: Vec<Plate>,
}

/// A plate, flange or web: the blocks that cuts leave of it, and what it was before, where it is
/// turned or has an outline.
struct Plate {
    blocks: Vec<Block>,
    oblique: Option<Oblique>,
}

/// A turned plate, or one with an outline, with the boxes cut out of it.
struct Oblique {
    whole: Block,
    cuts: Vec<Extent>,
}

impl Oblique {
    /// Distance of the axis of a hole from the nearest edge, of the plate or of a cut \[mm\].
    fn to_edge(&self, centre: [f64; 3]) -> f64 {
        let k = self.whole.axis;
        let place = [centre[(k + 1) % 3], centre[(k + 2) % 3]];
        let cuts = self.cuts.iter().map(|c| Block::of(c, k).polygon);
        let polygons = cuts.chain([self.whole.polygon.clone()]);
        polygons.map(|p| to_outline(&p, place)).fold(f64::INFINITY, f64::min)
    }
}

/// Distance of a point from the nearest edge of an outline \[mm\].
fn to_outline(outline: &[[f64; 2]], p: [f64; 2]) -> f64 {
    let of = |i: usize| {
        let (a, b) = (outline[i], outline[(i + 1) % outline.len()]);
        let d = [b[0] - a[0], b[1] - a[1]];
        let along = ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
        let f = along.clamp(0.0, 1.0);
        (a[0] + f * d[0] - p[0]).hypot(a[1] + f * d[1] - p[1])
    };
    (0..outline.len()).map(of).fold(f64::INFINITY, f64::min)
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
                let across_another = |p: &Plate| {
                    let turned = p.oblique.as_ref().filter(|o| o.whole.axis != b.hole.axis);
                    turned.is_some() && p.holds(middle, b.hole.axis)
                };
                if of.plates.iter().any(across_another) {
                    let problem = format!(
                        "the bolt passes `{part}` where it is turned, or has its outline, about \
                         another axis than the bolt's: distances to edges have no meaning there"
                    );
                    return entry_fault(&b.name, problem);
                }
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
                anchored: b.anchor.is_some(),
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
                if i > 0 || b.anchor.is_some() {
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
                let plates = self.shapes(entry, &scope)?.iter().flat_map(plates_of).collect();
                out.insert(name, Bolted { steel, plates });
            }
        }
        Ok(out)
    }
}

/// The plates of a solid.
fn plates_of(shape: &Shape<'_>) -> Vec<Plate> {
    let whole = shape.uncut();
    let of = |(blocks, whole): (Vec<Block>, Option<Block>)| {
        let oblique = whole.map(|whole| Oblique { whole, cuts: shape.cuts.clone() });
        Plate { blocks, oblique }
    };
    shape.plates().into_iter().zip(whole).map(of).collect()
}

impl Plate {
    /// Whether a point inside a ply is in it.
    fn holds(&self, centre: [f64; 3], axis: usize) -> bool {
        self.blocks.iter().any(|b| b.reach(centre, axis, 1.0).is_some())
    }
}

/// The room around a hole with its axis through `centre`, a point inside the ply, among the plates
/// and holes of a part.
fn room(centre: [f64; 3], axis: usize, plates: &[Plate], holes: &[Hole]) -> Option<Room> {
    let plate = plates.iter().find(|p| p.holds(centre, axis))?;
    let axes = across(axis);
    if let Some(oblique) = &plate.oblique {
        let apart = |o: &Hole| axes.map(|k| o.base[k] - centre[k]);
        let others = holes.iter().filter(|o| o.axis == axis).map(apart);
        let others = others.map(|[a, b]| a.hypot(b)).filter(|d| *d > SAME_PLACE);
        let pitch = others.fold(f64::INFINITY, f64::min);
        let edge = oblique.to_edge(centre);
        return Some(Room { edge: [[edge; 2]; 2], pitch: [[pitch; 2]; 2], oblique: true });
    }
    let edge = axes.map(|k| [-1.0, 1.0].map(|sign| to_edge(centre, k, sign, &plate.blocks)));
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
    Some(Room { edge, pitch, oblique: false })
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
        let plates = [beside, plate].map(|x| boxes(vec![Block::of(&x, 2)]));
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
        let plates = [vec![Block::of(&flange, 2)], Block::of(&web, 2).minus(&notch)].map(boxes);
        let of = |x: f64| room([x, 0.0, 70.0], 1, &plates, &[]).expect("inside").edge;
        assert_eq!(of(50.0), [[50.0, 450.0], [210.0, 40.0]]);
        assert_eq!(of(120.0), [[120.0, 380.0], [210.0, 70.0]]);
    }

    /// In a triangular plate and in one that is turned all distances are the least ones: the
    /// same as in the plate that is not turned.
    #[test]
    fn the_room_of_a_hole_in_an_oblique_plate() {
        let hole = |p: [f64; 3]| Hole { base: p, axis: 1, ..hole(0.0, 0.0, 0.0) };
        let outline = vec![[0.0, 0.0], [200.0, 0.0], [0.0, 300.0]];
        let blocks = Block::triangles(1, [-5.0, 5.0], &outline);
        let whole = Block { axis: 1, span: [-5.0, 5.0], polygon: outline };
        // a cut 20 mm beside the hole
        let cuts = vec![[[80.0, 90.0], [-9.0, 9.0], [30.0, 90.0]]];
        let plate = Plate { blocks, oblique: Some(Oblique { whole, cuts }) };
        // the axes after y are z and x
        let holes = [hole([60.0, 0.0, 40.0]), hole([30.0, 0.0, 80.0])];
        let found = room([60.0, 0.0, 40.0], 1, &[plate], &holes).expect("inside");
        assert!(found.oblique);
        assert!((found.edge[0][0] - 20.0).abs() < 1e-9 && found.edge[0] == found.edge[1]);
        assert!((found.pitch[1][0] - 50.0).abs() < 1e-9, "{found:?}");
        let turn = crate::assembly::turn::Turn { axis: 1, angle: 0.5, at: [0.0; 3] };
        let bar = Block::of(&[[0.0, 200.0], [-5.0, 5.0], [0.0, 80.0]], 1).turned(&turn);
        let oblique = Some(Oblique { whole: bar.clone(), cuts: vec![] });
        let plate = Plate { blocks: vec![bar], oblique };
        let at = turn.point([40.0, 0.0, 35.0]);
        let found = room(at, 1, &[plate], &[]).expect("inside");
        assert!((found.edge[0][1] - 35.0).abs() < 1e-9, "{found:?}");
    }

    fn boxes(blocks: Vec<Block>) -> Plate {
        Plate { blocks, oblique: None }
    }

    /// A hole in the next row on the other side counts in the direction that it is nearer to.
    #[test]
    fn staggered_holes_are_neighbours_in_one_direction() {
        let plate = [[0.0, 15.0], [-100.0, 100.0], [0.0, 200.0]];
        let holes = [hole(15.0, 0.0, 50.0), hole(15.0, 30.0, 90.0)];
        let found = room([7.5, 0.0, 50.0], 0, &[boxes(vec![Block::of(&plate, 2)])], &holes)
            .expect("inside");
        assert_eq!(found.pitch, [[f64::INFINITY; 2], [f64::INFINITY, 40.0]]);
    }
}
