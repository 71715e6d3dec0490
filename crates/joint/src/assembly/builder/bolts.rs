//! Bolts of the joint: their parts, contacts, cuts and lines of action.

use super::context::Context;
use crate::assembly::assembly::{
    Assembly, BoltPreload, InterfaceRule, Part, PartMaterial, PartRole, Solid, Surface,
};
use crate::assembly::end_plate::EndPlate;
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, identifier, within};
use crate::assembly::hole::{Hole, bolt_pieces};
use crate::assembly::member_ends::Frame;
use crate::assembly::scope::Scope;
use crate::assembly::seen_bolts::{self, Meshed};
use crate::assembly::template::BoltEntry;
use std::collections::BTreeMap;

/// The line of action of a bolt. The force of the bolt is the force on it from the last part it
/// passes through: the pressure under the nut along the shank, and the bearing on the shank across
/// it.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct BoltLine {
    /// The bolt's part.
    pub part: String,
    /// The part under the nut.
    pub last: String,
    /// Unit vector from head to nut.
    pub axis: [f64; 3],
    /// Centre of the head's bearing face \[mm\].
    pub position: [f64; 3],
}

/// A bolt's hole, and the parts that the bolt passes through with their thicknesses.
pub(in crate::assembly) struct Bolt<'a> {
    entry: &'a BoltEntry,
    scope: Scope,
    pub name: String,
    pub hole: Hole,
    /// Length of an anchor below the parts \[mm\]; `None`: a bolt with a head.
    pub anchor: Option<f64>,
    pub through: Vec<(String, f64)>,
}

impl Bolt<'_> {
    /// A plane across the shank, wider than it, at a distance from the head's bearing face \[mm\].
    pub(super) fn plane(&self, distance: f64) -> Surface {
        let centre = self.hole.point(distance);
        let beside = |sign: f64| std::array::from_fn(|k| centre[k] + sign * self.hole.beyond(k));
        let axis = self.hole.axis;
        Surface::Plane { axis, at: centre[axis], min: beside(-1.0), max: beside(1.0) }
    }

    /// The held end of an anchor: name and place of its face; `None`: a bolt.
    pub(super) fn anchorage(&self) -> Option<(String, Surface)> {
        Some((format!("ANCHORAGE_{}", self.name), self.plane(-self.anchor?)))
    }

    /// Gap all round the shank \[mm\].
    pub(super) fn shank_gap(&self) -> Result<f64, AssemblyError> {
        within(&self.entry.name, self.scope.length(&self.entry.shank_gap))
    }
}

impl<'a> Context<'a> {
    /// The bolts of all passes of their loops.
    pub(in crate::assembly) fn bolts(&self) -> Result<Vec<Bolt<'a>>, AssemblyError> {
        let mut out = Vec::new();
        for entry in &self.template.bolts {
            let at = entry.name.as_str();
            let Some((size, _)) = self.inputs.bolt else {
                return entry_fault(at, "the template needs `bolts`");
            };
            for scope in within(at, self.scope.turns(&entry.each, entry.when.as_ref()))? {
                let name = identifier(at, within(at, scope.text(at))?)?;
                let toward = within(at, scope.number(&entry.toward))?;
                if toward.abs() != 1.0 {
                    return entry_fault(at, format!("`toward` is {toward}, not 1 or -1"));
                }
                if entry.corner == entry.axis {
                    return entry_fault(at, "`corner` and `axis` are the same axis");
                }
                let mut through = Vec::new();
                for g in &entry.through {
                    through.push((
                        within(at, scope.text(&g.part))?,
                        within(at, scope.length(&g.thickness))?,
                    ));
                }
                let length: f64 = through.iter().map(|(_, t)| t).sum();
                if !through.iter().all(|(_, t)| *t > 0.0) || through.is_empty() {
                    return entry_fault(
                        at,
                        "a bolt passes at least one part, each of positive thickness",
                    );
                }
                let base = within(at, scope.point(&entry.head))?;
                let segments = self.spec.analysis.mesh.segments;
                let hole = Hole {
                    base,
                    axis: entry.axis.index(),
                    toward,
                    length,
                    radius: size.d / 2.0,
                    segments,
                };
                let anchor =
                    entry.anchor.as_ref().map(|e| within(at, scope.length(e))).transpose()?;
                if anchor.is_some_and(|l| l <= 0.0) {
                    return entry_fault(at, "`anchor` is not a positive length");
                }
                out.push(Bolt { entry, scope, name, hole, anchor, through });
            }
        }
        Ok(out)
    }

    /// Rejects a joint with bolts that the hand checks do not include.
    pub(in crate::assembly) fn all_seen(
        &self,
        assembly: &Assembly,
        frames: &[Frame],
        seen: &EndPlate,
    ) -> Result<(), AssemblyError> {
        let bolts = self.bolts()?;
        let meshed = bolts.iter().map(|b| Meshed {
            name: &b.name,
            axis: b.hole.axis,
            position: b.hole.base,
            through: b.through.iter().map(|(part, _)| part.as_str()).collect(),
        });
        seen_bolts::check(&meshed.collect::<Vec<_>>(), &assembly.parts, frames, seen)
    }

    /// The lines of action of the bolts whose nuts are in contact.
    pub(in crate::assembly) fn bolt_lines(&self) -> Result<Vec<BoltLine>, AssemblyError> {
        let mut out = Vec::new();
        for b in self.bolts()? {
            let open = within(&b.entry.name, b.scope.truth(&b.entry.nut_contact))?;
            if let Some((last, _)) = b.through.last().filter(|_| open) {
                let (axis, position) = (b.hole.direction(), b.hole.base);
                out.push(BoltLine { part: b.name.clone(), last: last.clone(), axis, position });
            }
        }
        Ok(out)
    }

    /// The cuts of preloaded shanks, at half the thickness of the part under the head. The mesh of
    /// that part has a plane there too.
    pub(in crate::assembly) fn preloads(&self, bolts: &[Bolt<'_>]) -> Vec<BoltPreload> {
        let Some(force) = self.inputs.preload else { return Vec::new() };
        let cut = |b: &Bolt<'_>| {
            let (_, thickness) = b.through.first()?;
            let surface = b.plane(thickness / 2.0);
            let (part, cut) = (b.name.clone(), format!("CUT_{}", b.name));
            Some(BoltPreload { part, cut, surface, axis: b.hole.direction(), force })
        };
        bolts.iter().filter_map(cut).collect()
    }

    /// The part of a bolt: shank, head and nut fused.
    pub(in crate::assembly) fn bolt_part(
        &self,
        b: &Bolt<'_>,
        materials: &mut BTreeMap<String, PartMaterial>,
    ) -> Result<Part, AssemblyError> {
        let at = b.entry.name.as_str();
        let Some((size, grade)) = self.inputs.bolt else {
            return entry_fault(at, "the template needs `bolts`");
        };
        let pieces = bolt_pieces(size, &b.hole, b.entry.corner.index(), b.anchor);
        let material = self.inputs.bolt_material(size, grade, materials);
        Ok(Part {
            name: b.name.clone(),
            label: within(at, b.scope.text(&b.entry.label))?,
            role: PartRole::Bolt,
            material,
            solid: Solid::Union(pieces.clone()),
            convex: pieces,
            mid_planes: Vec::new(),
            oblique_planes: Vec::new(),
            size: self.size(at, &b.scope, &b.entry.size)?,
        })
    }

    /// The contacts of a bolt: head and nut where the template makes them open, and the shank in
    /// every hole.
    pub(in crate::assembly) fn bolt_contacts(
        &self,
        b: &Bolt<'_>,
    ) -> Result<Vec<InterfaceRule>, AssemblyError> {
        let at = b.entry.name.as_str();
        let Some((size, _)) = self.inputs.bolt else {
            return entry_fault(at, "the template needs `bolts`");
        };
        let gap = b.shank_gap()?;
        let mut out = Vec::new();
        let face = |distance: f64, across_flats: f64| {
            let centre = b.hole.point(distance);
            let axis = b.hole.axis;
            let corner = b.entry.corner.index();
            let (mut min, mut max) = (centre, centre);
            for k in (0..3).filter(|&k| k != axis) {
                let half =
                    if k == corner { across_flats / 3f64.sqrt() } else { across_flats / 2.0 };
                (min[k], max[k]) = (centre[k] - half, centre[k] + half);
            }
            Surface::Plane { axis, at: centre[axis], min, max }
        };
        let (first, last) = match (b.through.first(), b.through.last()) {
            (Some((f, _)), Some((l, _))) => (f, l),
            _ => return entry_fault(at, "a bolt passes at least one part"),
        };
        if b.anchor.is_none() && within(at, b.scope.truth(&b.entry.head_contact))? {
            let between = [b.name.clone(), first.clone()];
            out.push(self.rule(
                between,
                format!("HEAD_{}", b.name),
                face(0.0, size.head_width),
                0.0,
            ));
        }
        if within(at, b.scope.truth(&b.entry.nut_contact))? {
            let between = [b.name.clone(), last.clone()];
            out.push(self.rule(
                between,
                format!("NUT_{}", b.name),
                face(b.hole.length, size.nut_width),
                0.0,
            ));
        }
        let mut from = 0.0;
        for (part, thickness) in &b.through {
            let mantle = Surface::Mantle {
                base: b.hole.point(from),
                axis: b.hole.direction(),
                radius: b.hole.radius,
                length: *thickness,
            };
            let between = [b.name.clone(), part.clone()];
            out.push(self.rule(between, format!("SHANK_{}_{part}", b.name), mantle, gap));
            from += thickness;
        }
        Ok(out)
    }
}
