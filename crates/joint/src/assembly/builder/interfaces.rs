//! Contacts and welds of the joint other than those of its bolts.

use super::context::Context;
use crate::assembly::assembly::{InterfaceRule, WeldRule};
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, identifier, rectangle, within};
use crate::assembly::scope::path_of;
use crate::assembly::template::WeldEntry;

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

    /// The welds with a throat above zero, and a fault for each whose steels have no β_w: no
    /// analysis can give it a strength.
    pub(in crate::assembly) fn welds(
        &self,
    ) -> Result<(Vec<WeldRule>, Vec<AssemblyError>), AssemblyError> {
        let (mut out, mut without) = (Vec::new(), Vec::new());
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
                let length = w.length.as_ref().map(|l| within(at, s.length(l))).transpose()?;
                let steels = [self.steel_of(at, &between[0])?, self.steel_of(at, &between[1])?];
                let weaker = steels[0].weaker(&steels[1]);
                let Some(steel) = weaker.of_welds() else {
                    without.push(self.no_strength(w, &weaker.grade));
                    continue;
                };
                let surface = rectangle(at, &s, &w.face)?;
                out.push(WeldRule {
                    name,
                    between,
                    surface,
                    imprint: w.imprint,
                    throat,
                    thickness,
                    length,
                    closed: w.closed,
                    steel,
                });
            }
        }
        Ok((out, without))
    }

    /// The fault of a fillet weld of a steel without β_w, at the parameter that gives its throat.
    fn no_strength(&self, weld: &WeldEntry, grade: &str) -> AssemblyError {
        let is_parameter = |n: &&str| self.template.parameters.iter().any(|p| p.name == *n);
        let names = weld.throat.names();
        let (path, what) = match names.into_iter().find(is_parameter) {
            Some(name) => (path_of(name), format!("`{name}` gives fillet welds")),
            None => ("template".into(), format!("`{}` is a fillet weld", weld.name)),
        };
        AssemblyError::NoWeldStrength { path, what, grade: grade.into() }
    }
}
