//! Members and plates of the joint.

use super::context::Context;
use crate::assembly::assembly::{MidPlane, Part, PartMaterial, PartRole, Solid};
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, identifier, within};
use crate::assembly::part::{Hole, Placed, cuboid, perforated};
use crate::assembly::scope::Scope;
use crate::assembly::strength::Strength;
use crate::assembly::template::{MidEntry, PartEntry, RoleEntry};
use crate::spec::expr::ExprError;
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
        for solid in &entry.solids {
            for s in within(at, scope.turns(&solid.each, solid.when.as_ref()))? {
                match (&solid.profile, &solid.cuboid) {
                    (Some(p), None) => {
                        let Some(profile) = self.inputs.profile(&p.member) else {
                            return entry_fault(at, format!("there is no member `{}`", p.member));
                        };
                        let (along, depth) = (p.along.index(), p.depth.index());
                        if along == depth {
                            return entry_fault(at, "`along` and `depth` are the same axis");
                        }
                        let span = within(at, s.interval(&[p.from.clone(), p.to.clone()]))?;
                        let centre =
                            p.centre.as_ref().map_or(Ok([0.0; 3]), |c| within(at, s.point(c)))?;
                        let placed = Placed { profile, along, depth, span, centre };
                        solids.push(placed.solid());
                        convex.extend(placed.convex(holes));
                        mid_planes.extend(placed.mid_planes());
                    }
                    (None, Some(b)) => {
                        let x = [
                            within(at, s.interval(&b.x))?,
                            within(at, s.interval(&b.y))?,
                            within(at, s.interval(&b.z))?,
                        ];
                        if let Some(k) = (0..3).find(|&k| x[k][1] - x[k][0] <= 0.0) {
                            return entry_fault(
                                at,
                                format!("a box has no extent along {}", ["x", "y", "z"][k]),
                            );
                        }
                        solids.push(cuboid(x[0], x[1], x[2]));
                        convex.extend(perforated(x, holes));
                        mid_planes.push(within(at, mid_plane(&s, x, solid.mid.as_ref()))?);
                    }
                    _ => {
                        return entry_fault(
                            at,
                            "each solid is a `profile` or a `box`, one of them",
                        );
                    }
                }
            }
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

/// The mid-thickness plane of a box: normal to its thinnest direction, or as the template states.
fn mid_plane(s: &Scope, x: [[f64; 2]; 3], entry: Option<&MidEntry>) -> Result<MidPlane, ExprError> {
    let thickness = |k: usize| x[k][1] - x[k][0];
    let thinnest =
        [1, 2].into_iter().fold(0, |best, k| if thickness(k) < thickness(best) { k } else { best });
    let axis = entry.map_or(thinnest, |e| e.axis.index());
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
