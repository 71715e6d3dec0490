//! Reads the values of a template's `hand_checks`, with faults at their keys.

use super::builder::Context;
use super::error::AssemblyError;
use crate::catalog::{BoltGrade, BoltSize, IProfile, Section};
use crate::spec::expr::{Expr, ExprError};
use crate::strength::Strength;

/// A reader of the values.
pub(super) struct Values<'c, 'a>(pub &'c Context<'a>);

impl Values<'_, '_> {
    /// A fault of a key.
    pub fn wrong(&self, key: &str, problem: String) -> AssemblyError {
        AssemblyError::TemplateEntry { at: format!("hand_checks.{key}"), problem }
    }

    fn named<T>(&self, key: &str, result: Result<T, ExprError>) -> Result<T, AssemblyError> {
        result.map_err(|cause| AssemblyError::Template { at: format!("hand_checks.{key}"), cause })
    }

    /// A length of any sign \[mm\].
    pub fn length(&self, key: &str, e: &Expr) -> Result<f64, AssemblyError> {
        self.named(key, self.0.scope.length(e))
    }

    /// An angle \[rad\].
    pub fn angle(&self, key: &str, e: &Expr) -> Result<f64, AssemblyError> {
        self.named(key, self.0.scope.angle(e))
    }

    /// A length above 0 \[mm\].
    pub fn positive(&self, key: &str, e: &Expr) -> Result<f64, AssemblyError> {
        match self.length(key, e)? {
            value if value > 0.0 => Ok(value),
            value => Err(self.wrong(key, format!("{value} mm; it must be above 0"))),
        }
    }

    /// A length of at least 0 \[mm\]; 0 where it is absent.
    pub fn or_none(&self, key: &str, e: Option<&Expr>) -> Result<f64, AssemblyError> {
        match e.map_or(Ok(0.0), |e| self.length(key, e))? {
            value if value >= 0.0 => Ok(value),
            value => Err(self.wrong(key, format!("{value} mm; it must be at least 0 mm"))),
        }
    }

    /// True or false.
    pub fn truth(&self, key: &str, e: &Expr) -> Result<bool, AssemblyError> {
        self.named(key, self.0.scope.truth(e))
    }

    /// The lengths of expressions in rising order, equal ones once \[mm\].
    pub fn rising(&self, key: &str, all: &[Expr]) -> Result<Vec<f64>, AssemblyError> {
        let mut out: Vec<f64> =
            all.iter().map(|e| self.length(key, e)).collect::<Result<_, _>>()?;
        out.sort_by(f64::total_cmp);
        out.dedup_by(|a, b| (*a - *b).abs() < super::content::SAME_PLACE);
        Ok(out)
    }

    /// The lengths of a list parameter in rising order \[mm\].
    pub fn list(&self, key: &str, name: &str) -> Result<Vec<f64>, AssemblyError> {
        let mut out = self.0.scope.list(name).map_err(|problem| self.wrong(key, problem))?;
        out.sort_by(f64::total_cmp);
        Ok(out)
    }

    /// The section of a member role.
    pub fn profile(&self, key: &str, role: &str) -> Result<IProfile, AssemblyError> {
        let found = self.0.inputs.profile(role);
        found.cloned().ok_or_else(|| self.wrong(key, format!("there is no member `{role}`")))
    }

    /// The section of a role.
    pub fn section(&self, key: &str, role: &str) -> Result<Section<'_>, AssemblyError> {
        let found = self.0.inputs.section(role);
        found.ok_or_else(|| self.wrong(key, format!("there is no member `{role}`")))
    }

    /// The steel of the first role that the spec gives, at a thickness \[mm\].
    pub fn steel(&self, roles: &[String], thickness: f64) -> Result<Strength, AssemblyError> {
        self.0.inputs.strength(self.0.spec, roles, thickness)
    }

    /// The bolts of the spec.
    pub fn bolts(&self, key: &str) -> Result<(BoltSize, BoltGrade), AssemblyError> {
        let found = self.0.inputs.bolt.map(|(size, grade)| (size.clone(), grade.clone()));
        found.ok_or_else(|| self.wrong(key, "the template has no `bolts`".into()))
    }

    /// Diameter of the holes, at least that of the bolts \[mm\].
    pub fn hole(&self, e: &Expr, bolt: &BoltSize) -> Result<f64, AssemblyError> {
        match self.length("hole", e)? {
            value if value >= bolt.d => Ok(value),
            value => Err(self.wrong("hole", format!("{value} mm, less than the bolt"))),
        }
    }
}
