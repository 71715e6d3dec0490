//! Members and plates of the joint.

use super::context::Context;
use super::shapes::{Body, Shape};
use crate::assembly::assembly::{MidPlane, Part, PartMaterial, PartRole, Solid};
use crate::assembly::axes::{cuboid, without};
use crate::assembly::block;
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, identifier, within};
use crate::assembly::hole::{Hole, around_holes, perforated};
use crate::assembly::scope::Scope;
use crate::assembly::template::{MidEntry, PartEntry, RoleEntry};
use crate::spec::expr::ExprError;
use crate::strength::Strength;
use std::collections::BTreeMap;

impl Context<'_> {
    /// A member or plate with its holes cut out.
    pub(in crate::assembly) fn part(
        &self,
        entry: &PartEntry,
        scope: &Scope,
        holes: &BTreeMap<&str, Vec<Hole>>,
        materials: &mut BTreeMap<String, PartMaterial>,
    ) -> Result<Part, AssemblyError> {
        let at = entry.name.as_str();
        let name = identifier(at, within(at, scope.text(at))?)?;
        let holes = holes.get(name.as_str()).map_or(&[][..], Vec::as_slice);
        let (mut solids, mut convex, mut mid_planes) = (Vec::new(), Vec::new(), Vec::new());
        let mut oblique_planes = Vec::new();
        for shape in self.shapes(entry, scope)? {
            let (mid, s) = (shape.entry.mid.as_ref(), &shape.scope);
            let (whole, planes) = match &shape.body {
                Body::Profile(_, placed) => (placed.solid(), placed.mid_planes()),
                Body::Shaped(_, placed) => {
                    let oblique = placed.oblique_planes().into_iter();
                    let turned = |p: Vec<_>| match &shape.turn {
                        Some(t) => p.into_iter().map(|x| t.point(x)).collect(),
                        None => p,
                    };
                    oblique_planes.extend(oblique.map(turned));
                    (placed.solid(), placed.mid_planes())
                }
                Body::Cuboid(x) => {
                    (cuboid(x[0], x[1], x[2]), vec![within(at, mid_plane(s, *x, mid))?])
                }
                Body::Prism(p) => {
                    let plane = within(at, plane_across(s, p.axis, p.bounds(), mid))?;
                    (block::prism(p.axis, p.span, &p.outline), vec![plane])
                }
            };
            convex.extend(convex_pieces(&shape, holes));
            let whole = match &shape.turn {
                Some(turn) => {
                    oblique_planes.extend(planes.iter().map(|p| turn.mid_plane(p)));
                    turn.solid(&whole)
                }
                None => {
                    mid_planes.extend(planes);
                    whole
                }
            };
            let cuts = shape.cuts;
            solids.push(if cuts.is_empty() {
                whole
            } else {
                let cuts = cuts.into_iter().map(|[x, y, z]| cuboid(x, y, z));
                Solid::Difference([whole].into_iter().chain(cuts).collect())
            });
        }
        let body = match solids.len() {
            0 => return entry_fault(at, "the part has no solids"),
            1 => solids.remove(0),
            _ => Solid::Union(solids),
        };
        let solid = if holes.is_empty() {
            body
        } else {
            let mut cut = vec![body];
            cut.extend(holes.iter().map(Hole::cylinder));
            Solid::Difference(cut)
        };
        if !self.spec.analysis.mesh.layers {
            mid_planes.clear();
            oblique_planes.clear();
        }
        let thickness = within(at, scope.length(&entry.thickness))?;
        let material = self.inputs.steel_material(self.spec, &entry.steel, thickness, materials)?;
        let role = match entry.role {
            RoleEntry::Member => PartRole::Member,
            RoleEntry::Plate => PartRole::Plate,
        };
        let label = within(at, scope.text(&entry.label))?;
        Ok(Part {
            name,
            label,
            role,
            material,
            solid,
            convex,
            mid_planes,
            oblique_planes,
            size: self.size(at, scope, &entry.size)?,
        })
    }

    /// Strengths of the steel of a member or plate.
    pub(super) fn steel_of(&self, at: &str, part: &str) -> Result<Strength, AssemblyError> {
        for entry in &self.template.parts {
            for scope in within(&entry.name, self.scope.turns(&entry.each, entry.when.as_ref()))? {
                if within(&entry.name, scope.text(&entry.name))? == part {
                    let thickness = within(&entry.name, scope.length(&entry.thickness))?;
                    return self.inputs.strength(self.spec, &entry.steel, thickness);
                }
            }
        }
        entry_fault(at, format!("there is no member or plate `{part}`"))
    }
}

/// The convex pieces of a solid, with its holes and cuts left free.
fn convex_pieces(shape: &Shape<'_>, holes: &[Hole]) -> Vec<Solid> {
    match (&shape.turn, &shape.body) {
        (None, Body::Profile(_, placed)) => placed.convex(holes, &shape.cuts),
        (None, Body::Cuboid(x)) => {
            let left = without(*x, &shape.cuts);
            left.into_iter().flat_map(|x| perforated(x, holes)).collect()
        }
        (None, Body::Shaped(_, placed)) => {
            let left = shape.left(placed.blocks());
            left.iter().flat_map(|b| around_holes(b, holes)).collect()
        }
        (Some(turn), Body::Shaped(_, placed)) if holes.is_empty() && shape.cuts.is_empty() => {
            placed.blocks().iter().map(|b| turn.solid(&b.solid())).collect()
        }
        (turn, body) => {
            let blocks = shape.plates().into_iter().flatten();
            let mut out: Vec<Solid> = blocks.flat_map(|b| around_holes(&b, holes)).collect();
            if let (Some(turn), Body::Profile(_, placed)) = (turn, body) {
                out.extend(placed.turned_fillets(turn, &shape.cuts));
            }
            out
        }
    }
}

/// The mid-thickness plane of a box: normal to its thinnest direction, or as the template states.
fn mid_plane(s: &Scope, x: [[f64; 2]; 3], entry: Option<&MidEntry>) -> Result<MidPlane, ExprError> {
    let thickness = |k: usize| x[k][1] - x[k][0];
    let thinnest =
        [1, 2].into_iter().fold(0, |best, k| if thickness(k) < thickness(best) { k } else { best });
    plane_across(s, thinnest, x, entry)
}

/// The plane halfway across an axis, or as the template states. The mesher keeps of it what is
/// inside the part.
fn plane_across(
    s: &Scope,
    axis: usize,
    x: [[f64; 2]; 3],
    entry: Option<&MidEntry>,
) -> Result<MidPlane, ExprError> {
    let axis = entry.map_or(axis, |e| e.axis.index());
    let at = (x[axis][0] + x[axis][1]) / 2.0;
    let mut extent = x;
    if let Some(e) = entry {
        for (k, i) in [&e.x, &e.y, &e.z].into_iter().enumerate() {
            if let Some(i) = i {
                extent[k] = s.interval(i)?;
            }
        }
    }
    extent[axis] = [at, at];
    Ok(MidPlane { axis, at, min: extent.map(|i| i[0]), max: extent.map(|i| i[1]) })
}
