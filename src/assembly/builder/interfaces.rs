//! Contacts and welds of the joint other than those of its bolts.

use super::context::Context;
use crate::assembly::assembly::{InterfaceRule, WeldRule};
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, identifier, rectangle, within};

impl Context<'_> {
    /// The contacts listed in the template.
    pub(in crate::assembly) fn contacts(&self) -> Result<Vec<InterfaceRule>, AssemblyError> {
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

    /// The welds with a throat above zero.
    pub(in crate::assembly) fn welds(&self) -> Result<Vec<WeldRule>, AssemblyError> {
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
}
