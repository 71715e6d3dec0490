//! The modelled part of an assembly: the parts on the kept side of its symmetry planes, cut at
//! those planes.

use super::flat::{Bounds, FlatSolid};
use super::line::{Line, Stretches, intersect};
use crate::assembly::assembly::{Assembly, MidPlane, Part, Surface, SymmetryPlane};

/// Coordinates closer than this to a plane count as lying on it \[mm\].
pub const ON_PLANE: f64 = 1e-6;

/// A part of which at least a piece is kept.
#[derive(Clone, Debug)]
pub struct Body<'a> {
    /// The part.
    pub part: &'a Part,
    /// Its whole solid, not cut by symmetry.
    pub solid: FlatSolid,
    /// Bounding box of the whole solid \[mm\].
    pub whole: Bounds,
    /// Bounding box of the kept part \[mm\].
    pub bounds: Bounds,
    /// Axes of all symmetry planes in use; the body keeps its part with `x[axis] ≥ 0`.
    pub planes: Vec<usize>,
}

/// The meshed part of a joint.
#[derive(Clone, Debug)]
pub struct Scene<'a> {
    /// The whole joint.
    pub assembly: &'a Assembly,
    /// The symmetry planes in use.
    pub symmetry: Vec<SymmetryPlane>,
    /// The kept parts, in the order of the assembly.
    pub bodies: Vec<Body<'a>>,
}

impl Body<'_> {
    /// The intervals of a line inside the kept part of the body.
    pub fn stretches(&self, line: &Line) -> Stretches {
        let mut inside = line.through(&self.solid);
        for &axis in &self.planes {
            if inside.is_empty() {
                break;
            }
            inside = intersect(&inside, &line.positive(axis));
        }
        inside
    }

    /// Axes of the symmetry planes that actually cut the body.
    pub fn cuts(&self) -> Vec<usize> {
        self.planes.iter().copied().filter(|&k| self.whole.min[k] < -ON_PLANE).collect()
    }
}

/// A plane inside the shank of a bolt.
#[derive(Clone, Copy, Debug)]
pub struct ShankCut<'a> {
    /// The bolt's part.
    pub part: &'a String,
    /// Name of the section.
    pub name: &'a String,
    /// A plane across the shank, wider than it.
    pub surface: &'a Surface,
}

/// The cuts of all shanks: for the preload, and at the sections between plies.
pub fn shank_cuts(joint: &Assembly) -> impl Iterator<Item = ShankCut<'_>> {
    let preloads = joint.preloads.iter();
    let preloads = preloads.map(|p| ShankCut { part: &p.part, name: &p.cut, surface: &p.surface });
    let sections = joint.sections.iter();
    let sections = sections.map(|s| ShankCut { part: &s.part, name: &s.name, surface: &s.surface });
    preloads.chain(sections)
}

impl<'a> Scene<'a> {
    /// The scene of the positive side of each symmetry plane, or of the whole joint if `full`.
    pub fn new(assembly: &'a Assembly, full: bool) -> Self {
        let mut symmetry = if full { Vec::new() } else { assembly.symmetry.clone() };
        symmetry.sort_by_key(|s| s.axis);
        symmetry.dedup();
        let planes: Vec<usize> = symmetry.iter().map(|s| s.axis).collect();
        let bodies = assembly
            .parts
            .iter()
            .filter_map(|part| {
                let solid = FlatSolid::from_solid(&part.solid);
                let whole = solid.bounds();
                if planes.iter().any(|&k| whole.max[k] <= ON_PLANE) {
                    return None;
                }
                let mut bounds = whole;
                for &k in &planes {
                    bounds.min[k] = bounds.min[k].max(0.0);
                }
                Some(Body { part, solid, whole, bounds, planes: planes.clone() })
            })
            .collect();
        Scene { assembly, symmetry, bodies }
    }

    /// Planes at which the shank of a part is cut: for its preload, and at its sections between
    /// plies.
    pub fn shank_cuts<'s>(&'s self, part: &'s Part) -> impl Iterator<Item = MidPlane> + 's {
        let mine = shank_cuts(self.assembly).filter(|cut| *cut.part == part.name);
        mine.filter_map(|cut| match *cut.surface {
            Surface::Plane { axis, at, min, max } => Some(MidPlane { axis, at, min, max }),
            Surface::Mantle { .. } => None,
        })
    }

    /// Index of the body of a part; `None` if the part is not kept.
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|b| b.part.name == name)
    }

    /// Number of copies of the modelled part that make the whole joint: 1, 2, 4 or 8.
    pub fn copies(&self) -> u32 {
        1 << self.symmetry.len()
    }
}
