//! Spec + template + catalogue → [`Assembly`].

use super::assembly::{
    Action, Assembly, BoltPreload, Clearance, FaceLoad, FaceRule, FaceSupport, InterfaceRule,
    MidPlane, Part, PartMaterial, PartRole, Solid, Surface, WeldRule,
};
use super::end_plate::{EndPlate, Strength, end_plate};
use super::error::AssemblyError;
use super::origin::Origin;
use super::part::{Hole, Placed, bolt_pieces, cuboid, perforated};
use super::scope::{Resolved, Scope};
use super::seen_bolts::{self, Meshed};
use super::template::{self, Axis, BoltEntry, PartEntry, RectangleEntry, RoleEntry, Template};
use super::{actions, inputs, symmetry};
use crate::catalog::Catalog;
use crate::diag::{Diagnostic, Diagnostics};
use crate::spec::analysis::MeshSize;
use crate::spec::connection::ConnectionSpec;
use crate::spec::expr::ExprError;
use crate::spec::yaml::Parsed;
use inputs::Inputs;
use std::collections::BTreeMap;
use std::path::Path;

/// An assembly, and what the report says about how it came to be.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Joint {
    /// The assembly.
    pub assembly: Assembly,
    /// Every parameter with its value and where it came from.
    pub resolved: Vec<Resolved>,
    /// Catalogue entries used: role and name.
    pub catalogue: Vec<(String, String)>,
    /// What the hand checks see of the connection, where the template says it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end_plate: Option<EndPlate>,
    /// What the report must say about the input.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// Where the bolts lie whose nuts are in contact.
    pub bolts: Vec<BoltLine>,
}

/// A bolt as a line of action. Its force is what the last part it passes puts on it: the nut's
/// pressure along the shank, and what bears on the shank across.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct BoltLine {
    /// The bolt's part.
    pub part: String,
    /// The part under its nut.
    pub last: String,
    /// Unit vector from head to nut.
    pub axis: [f64; 3],
    /// Centre of the head's bearing face \[mm\].
    pub position: [f64; 3],
}

/// Builds the joint a spec describes; `base` is the folder of the spec (for templates given by
/// path).
pub fn build(
    spec: &Parsed<ConnectionSpec>,
    base: &Path,
    catalog: &Catalog,
) -> Result<Joint, Diagnostics> {
    let (template, origin) = template::load(&spec.value.template, base).map_err(|faults| {
        let at_spec = |d: Diagnostic| match &d.place {
            p if p.file.is_none() => Diagnostic { place: spec.index.place("template"), ..d },
            _ => d,
        };
        Diagnostics(faults.0.into_iter().map(at_spec).collect())
    })?;
    // what is wrong with a template of the user's is told in its own file
    let one = |f: AssemblyError| match (&origin, &f) {
        (
            Origin::File { .. },
            AssemblyError::Template { .. }
            | AssemblyError::TemplateEntry { .. }
            | AssemblyError::UnseenBolts { .. },
        ) => origin.placed(&template, f),
        _ => f.placed(&spec.index),
    };
    let placed = |faults: Vec<AssemblyError>| Diagnostics(faults.into_iter().map(&one).collect());
    let inputs = Inputs::read(&spec.value, &template, catalog).map_err(&placed)?;
    let mut scope = inputs.scope();
    let resolved = scope.resolve(&template, &inputs.given).map_err(&placed)?;
    inputs::rules(&template, &scope).map_err(&placed)?;
    let builder =
        Builder { spec: &spec.value, template: &template, inputs: &inputs, scope: &scope };
    let assembly = builder.assembly().map_err(|e| placed(vec![e]))?;
    let bolts = builder.bolt_lines().map_err(|e| placed(vec![e]))?;
    let (actions, frames) = match &template.hand_checks {
        Some(entry) => actions::ends(&template, &scope)
            .and_then(|ends| {
                let actions = actions::on_planes(&spec.value.loads, &ends, &entry.ends)?;
                Ok((actions, actions::frames(&ends, &entry.ends)?))
            })
            .map_err(|e| placed(vec![e]))?,
        None => Default::default(),
    };
    let end_plate =
        end_plate(&spec.value, &template, &inputs, &scope, actions).map_err(|e| placed(vec![e]))?;
    if let Some(seen) = &end_plate {
        builder.all_seen(&assembly, &frames, seen).map_err(|e| placed(vec![e]))?;
    }
    let mut resolved = resolved;
    resolved.extend(inputs.preload_resolved(&spec.value));
    resolved.push(inputs.friction_resolved(&spec.value));
    resolved.extend(inputs.partial_factors().resolved.iter().cloned());
    Ok(Joint {
        assembly,
        resolved,
        catalogue: inputs.catalogue(),
        end_plate,
        notes: inputs.notes(),
        bolts,
    })
}

struct Builder<'a> {
    spec: &'a ConnectionSpec,
    template: &'a Template,
    inputs: &'a Inputs<'a>,
    scope: &'a Scope,
}

/// A bolt's hole and the parts it passes, with their thicknesses.
struct Bolt<'a> {
    entry: &'a BoltEntry,
    scope: Scope,
    name: String,
    hole: Hole,
    through: Vec<(String, f64)>,
}

/// Names the template entry an expression's fault belongs to.
pub(super) fn within<T>(at: &str, result: Result<T, ExprError>) -> Result<T, AssemblyError> {
    result.map_err(|cause| AssemblyError::Template { at: at.to_owned(), cause })
}

pub(super) fn entry_fault<T>(at: &str, problem: impl Into<String>) -> Result<T, AssemblyError> {
    Err(AssemblyError::TemplateEntry { at: at.to_owned(), problem: problem.into() })
}

pub(super) fn identifier(at: &str, name: String) -> Result<String, AssemblyError> {
    let word = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
    if name.starts_with(|c: char| c.is_ascii_uppercase()) && name.chars().all(word) {
        Ok(name)
    } else {
        entry_fault(
            at,
            format!("`{name}` is not a name: capitals, digits and `_`, a capital first"),
        )
    }
}

impl<'a> Builder<'a> {
    fn assembly(&self) -> Result<Assembly, AssemblyError> {
        let bolts = self.bolts()?;
        let mut holes: BTreeMap<&str, Vec<Hole>> = BTreeMap::new();
        for b in &bolts {
            for (part, _) in &b.through {
                holes.entry(part).or_default().push(b.hole);
            }
        }
        let mut materials = BTreeMap::new();
        let mut parts = Vec::new();
        for entry in &self.template.parts {
            for scope in within(&entry.name, self.scope.turns(&entry.each, entry.when.as_ref()))? {
                parts.push(self.part(entry, &scope, &holes, &mut materials)?);
            }
        }
        for b in &bolts {
            parts.push(self.bolt_part(b, &mut materials)?);
        }
        let names: Vec<&str> = parts.iter().map(|p: &Part| p.name.as_str()).collect();
        for (i, name) in names.iter().enumerate() {
            if names[..i].contains(name) {
                return entry_fault(name, "two parts have this name");
            }
        }
        let known = |at: &str, name: &str| {
            if names.contains(&name) {
                Ok(())
            } else {
                entry_fault(at, format!("there is no part `{name}`"))
            }
        };
        for b in &bolts {
            b.through.iter().try_for_each(|(part, _)| known(&b.name, part))?;
        }
        let mut interfaces = self.contacts()?;
        for b in &bolts {
            interfaces.extend(self.bolt_contacts(b)?);
        }
        for i in &interfaces {
            i.between.iter().try_for_each(|p| known("contacts", p))?;
        }
        let mut faces = Vec::new();
        let supports = self.supports(&mut faces)?;
        let loads = self.loads(&mut faces)?;
        for f in &faces {
            known(&f.name, &f.part)?;
        }
        let name = self.spec.project.title.clone().unwrap_or_else(|| self.template.title.clone());
        let clearances = self.clearances()?;
        let symmetry = Vec::new();
        let welds = self.welds()?;
        for w in &welds {
            w.between.iter().try_for_each(|p| known("welds", p))?;
        }
        let preloads = self.preloads(&bolts);
        let mut a = Assembly {
            name,
            parts,
            materials,
            interfaces,
            faces,
            supports,
            loads,
            symmetry,
            clearances,
            welds,
            preloads,
        };
        a.symmetry = symmetry::planes(&a);
        Ok(a)
    }

    fn size(
        &self,
        at: &str,
        scope: &Scope,
        auto: &crate::spec::expr::Expr,
    ) -> Result<f64, AssemblyError> {
        match self.spec.analysis.mesh.size {
            MeshSize::Fixed(l) => Ok(l.0),
            MeshSize::Auto => {
                let size = within(at, scope.length(auto))?;
                if size > 0.0 {
                    Ok(size)
                } else {
                    entry_fault(at, format!("the element size {size} mm is not positive"))
                }
            }
        }
    }

    fn part(
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

    fn bolts(&self) -> Result<Vec<Bolt<'a>>, AssemblyError> {
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
                out.push(Bolt { entry, scope, name, hole, through });
            }
        }
        Ok(out)
    }

    /// That the hand checks see every bolt.
    fn all_seen(
        &self,
        assembly: &Assembly,
        frames: &[actions::Frame],
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

    fn bolt_lines(&self) -> Result<Vec<BoltLine>, AssemblyError> {
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

    /// The cuts of preloaded shanks: at half the thickness of the part under the head, where its
    /// own mesh has a plane as well.
    fn preloads(&self, bolts: &[Bolt<'_>]) -> Vec<BoltPreload> {
        let Some(force) = self.inputs.preload else { return Vec::new() };
        let cut = |b: &Bolt<'_>| {
            let (_, thickness) = b.through.first()?;
            let centre = b.hole.point(thickness / 2.0);
            let beside = |sign: f64| std::array::from_fn(|k| centre[k] + sign * b.hole.beyond(k));
            let surface = Surface::Plane {
                axis: b.hole.axis,
                at: centre[b.hole.axis],
                min: beside(-1.0),
                max: beside(1.0),
            };
            let (part, cut) = (b.name.clone(), format!("CUT_{}", b.name));
            Some(BoltPreload { part, cut, surface, axis: b.hole.direction(), force })
        };
        bolts.iter().filter_map(cut).collect()
    }

    fn bolt_part(
        &self,
        b: &Bolt<'_>,
        materials: &mut BTreeMap<String, PartMaterial>,
    ) -> Result<Part, AssemblyError> {
        let at = b.entry.name.as_str();
        let Some((size, grade)) = self.inputs.bolt else {
            return entry_fault(at, "the template needs `bolts`");
        };
        let pieces = bolt_pieces(size, &b.hole, b.entry.corner.index());
        let material = self.inputs.bolt_material(size, grade, materials);
        Ok(Part {
            name: b.name.clone(),
            label: within(at, b.scope.text(&b.entry.label))?,
            role: PartRole::Bolt,
            material,
            solid: Solid::Union(pieces.to_vec()),
            convex: pieces.to_vec(),
            mid_planes: Vec::new(),
            size: self.size(at, &b.scope, &b.entry.size)?,
        })
    }

    fn rule(
        &self,
        between: [String; 2],
        name: String,
        surface: Surface,
        gap: f64,
    ) -> InterfaceRule {
        InterfaceRule {
            between,
            surface: Some((name, surface)),
            mu: self.inputs.mu,
            friction: self.spec.friction.law,
            gap,
        }
    }

    fn bolt_contacts(&self, b: &Bolt<'_>) -> Result<Vec<InterfaceRule>, AssemblyError> {
        let at = b.entry.name.as_str();
        let Some((size, _)) = self.inputs.bolt else {
            return entry_fault(at, "the template needs `bolts`");
        };
        let gap = within(at, b.scope.length(&b.entry.shank_gap))?;
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
        if within(at, b.scope.truth(&b.entry.head_contact))? {
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

    fn contacts(&self) -> Result<Vec<InterfaceRule>, AssemblyError> {
        let mut out = Vec::new();
        for c in &self.template.contacts {
            let at = c.name.as_str();
            for s in within(at, self.scope.turns(&c.each, c.when.as_ref()))? {
                let name = identifier(at, within(at, s.text(at))?)?;
                let between =
                    [within(at, s.text(&c.between[0]))?, within(at, s.text(&c.between[1]))?];
                let gap = c.gap.as_ref().map_or(Ok(0.0), |g| within(at, s.length(g)))?;
                out.push(self.rule(between, name, rectangle(at, &s, &c.face)?, gap));
            }
        }
        Ok(out)
    }

    /// The welds with a throat.
    fn welds(&self) -> Result<Vec<WeldRule>, AssemblyError> {
        let mut out = Vec::new();
        for w in &self.template.welds {
            let at = w.name.as_str();
            for s in within(at, self.scope.turns(&w.each, w.when.as_ref()))? {
                let throat = within(at, s.length(&w.throat))?;
                if throat <= 0.0 {
                    continue;
                }
                let name = identifier(at, within(at, s.text(at))?)?;
                let between =
                    [within(at, s.text(&w.between[0]))?, within(at, s.text(&w.between[1]))?];
                let thickness = within(at, s.length(&w.thickness))?;
                if thickness <= 0.0 {
                    return entry_fault(
                        at,
                        format!("the thickness {thickness} mm is not positive"),
                    );
                }
                let steels = [self.steel_of(at, &between[0])?, self.steel_of(at, &between[1])?];
                let weaker = steels[0].weaker(&steels[1]);
                let gamma_m2 = self.inputs.partial_factors().gamma_m2;
                let Some(strength) = weaker.weld_strength(gamma_m2) else {
                    return Err(AssemblyError::Value {
                        path: "parameters".into(),
                        problem: format!(
                            "`{name}` is a fillet weld, for which {} has no β_w (EN 1993-1-8 \
                             Table 4.1)",
                            weaker.grade
                        ),
                        help: "take a throat of 0 mm (full penetration), or a steel with β_w: \
                               `bracket catalog list steels`"
                            .into(),
                    });
                };
                let surface = rectangle(at, &s, &w.face)?;
                out.push(WeldRule {
                    name,
                    between,
                    surface,
                    imprint: w.imprint,
                    throat,
                    thickness,
                    strength,
                });
            }
        }
        Ok(out)
    }

    /// Strengths of the steel of a member's or plate's part.
    fn steel_of(&self, at: &str, part: &str) -> Result<Strength, AssemblyError> {
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

    fn supports(&self, faces: &mut Vec<FaceRule>) -> Result<Vec<FaceSupport>, AssemblyError> {
        let mut out = Vec::new();
        for e in &self.template.supports {
            let at = e.name.as_str();
            for s in within(at, self.scope.turns(&e.each, e.when.as_ref()))? {
                let name = identifier(at, within(at, s.text(at))?)?;
                let part = within(at, s.text(&e.part))?;
                let surface = rectangle(at, &s, &e.face)?;
                faces.push(FaceRule { name: name.clone(), part, surface, imprint: e.imprint });
                let fix = [Axis::X, Axis::Y, Axis::Z].map(|a| e.fix.contains(&a));
                out.push(FaceSupport { face: name, fix });
            }
        }
        Ok(out)
    }

    fn loads(&self, faces: &mut Vec<FaceRule>) -> Result<Vec<FaceLoad>, AssemblyError> {
        let mut out = Vec::new();
        let ends = actions::ends(self.template, self.scope)?;
        // anything else would multiply pressures
        if let Some(e) = self.template.sections.iter().find(|e| e.outward.abs() != 1) {
            return entry_fault(&e.name, format!("`outward` is {}, not 1 or -1", e.outward));
        }
        for (i, l) in self.spec.loads.iter().enumerate() {
            if actions::is_at_an_end(l) {
                out.extend(actions::on_end(l, i, self.template, &ends, faces)?);
                continue;
            }
            // inputs.rs has refused loads without a known section
            let Some(e) =
                self.template.sections.iter().find(|e| Some(&e.name) == l.section.as_ref())
            else {
                continue;
            };
            let at = e.name.as_str();
            let face = identifier(at, at.to_uppercase())?;
            if !faces.iter().any(|f| f.name == face) {
                let surface = rectangle(at, self.scope, &e.face)?;
                let part = within(at, self.scope.text(&e.part))?;
                faces.push(FaceRule { name: face.clone(), part, surface, imprint: e.imprint });
            }
            let mut traction = l.traction.map_or([0.0; 3], |t| t.map(|s| s.0));
            if let Some(p) = l.pressure {
                traction[e.face.axis.index()] -= p.0 * f64::from(e.outward);
            }
            out.push(FaceLoad {
                face,
                case: l.name.clone(),
                action: Action::Traction(traction),
                dead: l.dead,
            });
        }
        Ok(out)
    }

    fn clearances(&self) -> Result<Vec<Clearance>, AssemblyError> {
        let mut out = Vec::new();
        for c in &self.template.clearances {
            let at = c.reason.as_str();
            for s in within(at, self.scope.turns(&c.each, c.when.as_ref()))? {
                let between =
                    [within(at, s.text(&c.between[0]))?, within(at, s.text(&c.between[1]))?];
                let min = within(at, s.length(&c.min))?;
                out.push(Clearance { between, min, reason: c.reason.clone() });
            }
        }
        Ok(out)
    }
}

/// The plane at mid-thickness of a box: across its thinnest direction, or as the template says.
fn mid_plane(
    s: &Scope,
    x: [[f64; 2]; 3],
    entry: Option<&template::MidEntry>,
) -> Result<MidPlane, ExprError> {
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

pub(super) fn rectangle(at: &str, s: &Scope, r: &RectangleEntry) -> Result<Surface, AssemblyError> {
    let axis = r.axis.index();
    let level = within(at, s.length(&r.at))?;
    let (mut min, mut max) = ([level; 3], [level; 3]);
    for (k, i) in [&r.x, &r.y, &r.z].into_iter().enumerate() {
        match i {
            Some(i) if k != axis => [min[k], max[k]] = within(at, s.interval(i))?,
            None if k == axis => {}
            Some(_) => return entry_fault(at, "a face has no extent along its normal"),
            None => {
                return entry_fault(
                    at,
                    format!("the face lacks its extent along {}", ["x", "y", "z"][k]),
                );
            }
        }
    }
    Ok(Surface::Plane { axis, at: level, min, max })
}
