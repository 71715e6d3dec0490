//! Supports, loads and clearances of the joint.

use super::context::Context;
use crate::assembly::actions;
use crate::assembly::assembly::{Action, Clearance, FaceLoad, FaceRule, FaceSupport};
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, identifier, rectangle, within};
use crate::assembly::load_checks;
use crate::assembly::member_ends;
use crate::assembly::template::Axis;

impl Context<'_> {
    /// The supports. Adds their faces to the named faces.
    pub(in crate::assembly) fn supports(
        &self,
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
                out.push(FaceSupport { face: name, fix, ground: None });
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
