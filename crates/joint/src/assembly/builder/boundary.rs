//! Supports, loads and clearances of the joint.

use super::bolts::Bolt;
use super::context::Context;
use crate::assembly::actions;
use crate::assembly::assembly::{Action, Clearance, FaceLoad, FaceRule, FaceSupport};
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, identifier, rectangle, within};
use crate::assembly::foundation::Foundation;
use crate::assembly::load_checks;
use crate::assembly::member_ends;
use crate::assembly::scope::Scope;
use crate::assembly::shear_reaction;
use crate::assembly::template::{Axis, GroundEntry};
use crate::spec::expr::Expr;
use crate::strength::Nominal;

impl Context<'_> {
    /// The supports, with the ends of anchors. Adds their faces to the named faces.
    pub(in crate::assembly) fn supports(
        &self,
        bolts: &[Bolt<'_>],
        faces: &mut Vec<FaceRule>,
    ) -> Result<Vec<FaceSupport>, AssemblyError> {
        let mut out = Vec::new();
        for e in &self.template.supports {
            let at = e.name.as_str();
            for s in within(at, self.scope.turns(&e.each, e.when.as_ref()))? {
                let name = identifier(at, within(at, s.text(at))?)?;
                let part = within(at, s.text(&e.part))?;
                let surface = rectangle(at, &s, &e.face)?;
                faces.push(FaceRule { name: name.clone(), part, surface, imprint: e.imprint });
                let fix = [Axis::X, Axis::Y, Axis::Z].map(|a| e.fix.contains(&a));
                let ground = e.ground.as_ref().map(|g| foundation(at, &s, g)).transpose()?;
                if ground.is_some() == fix.contains(&true) {
                    let problem = "a support has either `fix` with some axes or `ground`";
                    return entry_fault(at, problem);
                }
                out.push(FaceSupport { face: name, fix, ground });
            }
        }
        for b in bolts {
            if let Some((face, surface)) = b.anchorage() {
                let part = b.name.clone();
                faces.push(FaceRule { name: face.clone(), part, surface, imprint: false });
                out.push(FaceSupport { face, fix: [true; 3], ground: None });
            }
        }
        Ok(out)
    }

    /// The loads. Adds their faces to the named faces.
    pub(in crate::assembly) fn loads(
        &self,
        faces: &mut Vec<FaceRule>,
    ) -> Result<Vec<FaceLoad>, AssemblyError> {
        let mut out = Vec::new();
        let ends = member_ends::ends(self.template, self.scope)?;
        // any other value would multiply pressures
        if let Some(e) = self.template.sections.iter().find(|e| e.outward.abs() != 1) {
            return entry_fault(&e.name, format!("`outward` is {}, not 1 or -1", e.outward));
        }
        for (i, l) in self.spec.loads.iter().enumerate() {
            if load_checks::is_at_an_end(l) {
                let rules = (self.template, self.small);
                out.extend(actions::on_end(l, i, rules, &ends, faces)?);
                continue;
            }
            // spec_checks.rs has rejected loads without a known section
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
            if !self.small.is_idle(&l.name) {
                out.push(FaceLoad {
                    face,
                    case: l.name.clone(),
                    action: Action::Traction(traction),
                    dead: l.dead,
                });
            }
        }
        if let Some(e) = &self.template.shear_reaction {
            let edges = shear_reaction::edges(e, self.scope)?;
            out.extend(edges.reactions(&out));
            faces.extend(edges.faces);
        }
        Ok(out)
    }

    /// The required clearances.
    pub(in crate::assembly) fn clearances(&self) -> Result<Vec<Clearance>, AssemblyError> {
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

/// The concrete of a support: sizes and strengths are positive, edges and grout may be zero.
fn foundation(at: &str, scope: &Scope, e: &GroundEntry) -> Result<Foundation, AssemblyError> {
    let positive = |what: &str, x: f64, unit: &str| {
        if x > 0.0 {
            Ok(x)
        } else {
            entry_fault(at, format!("`ground.{what}` is {x}{unit}, not > 0"))
        }
    };
    let no_less = |what: &str, e: &Expr| -> Result<f64, AssemblyError> {
        let x = within(at, scope.length(e))?;
        if x >= 0.0 {
            Ok(x)
        } else {
            entry_fault(at, format!("`ground.{what}` is {x} mm, below 0"))
        }
    };
    let length = |what, e| positive(what, within(at, scope.length(e))?, " mm");
    let number = |what, e, unit| positive(what, within(at, scope.number(e))?, unit);
    let [[a, b], [c, d]] = &e.edge;
    let friction = within(at, scope.number(&e.friction))?;
    if !(0.0..=1.0).contains(&friction) {
        return entry_fault(at, format!("`ground.friction` is {friction}, not between 0 and 1"));
    }
    Ok(Foundation {
        f_ck: Nominal::new(number("f_ck", &e.f_ck, " MPa")?),
        plate: [length("plate", &e.plate[0])?, length("plate", &e.plate[1])?],
        edge: [
            [no_less("edge", a)?, no_less("edge", b)?],
            [no_less("edge", c)?, no_less("edge", d)?],
        ],
        depth: length("depth", &e.depth)?,
        grout: no_less("grout", &e.grout)?,
        grout_strength: Nominal::new(number("grout_strength", &e.grout_strength, " MPa")?),
        friction,
        rigid: e.rigid.as_ref().map_or(Ok(false), |r| within(at, scope.truth(r)))?,
    })
}
