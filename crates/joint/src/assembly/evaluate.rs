//! Evaluates the expressions of template entries. An error reports its entry.

use super::assembly::Surface;
use super::error::AssemblyError;
use super::extent::Extent;
use super::scope::Scope;
use super::template::{BoxEntry, RectangleEntry, Template};
use crate::spec::expr::ExprError;
use bracket_base::diag::AtLeastOne;

/// Adds the name of the template entry to the fault of one of its expressions.
pub(super) fn within<T>(at: &str, result: Result<T, ExprError>) -> Result<T, AssemblyError> {
    result.map_err(|cause| AssemblyError::Template { at: at.to_owned(), cause })
}

/// A fault of a template entry that lies outside its expressions.
pub(super) fn entry_fault<T>(at: &str, problem: impl Into<String>) -> Result<T, AssemblyError> {
    Err(AssemblyError::TemplateEntry { at: at.to_owned(), problem: problem.into() })
}

/// The name, if it is an identifier: capitals, digits and `_`, with a capital first.
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

/// The extent of a box.
pub(super) fn block(at: &str, s: &Scope, b: &BoxEntry) -> Result<Extent, AssemblyError> {
    let x = [
        within(at, s.interval(&b.x))?,
        within(at, s.interval(&b.y))?,
        within(at, s.interval(&b.z))?,
    ];
    match (0..3).find(|&k| x[k][1] - x[k][0] <= 0.0) {
        Some(k) => entry_fault(at, format!("a box has no extent along {}", ["x", "y", "z"][k])),
        None => Ok(x),
    }
}

/// The rectangle of a template entry on its coordinate plane.
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

/// Checks the template's conditions on the values.
pub fn rules(template: &Template, scope: &Scope) -> Result<(), AtLeastOne<AssemblyError>> {
    let mut faults = Vec::new();
    for check in &template.checks {
        let at =
            |cause| AssemblyError::Template { at: format!("checks: {}", check.that.text()), cause };
        for s in scope.turns(&check.each, check.when.as_ref()).map_err(at)? {
            if !s.truth(&check.that).map_err(at)? {
                faults.push(AssemblyError::Rule {
                    path: s.text(&check.at).map_err(at)?,
                    message: s.text(&check.say).map_err(at)?,
                    help: s.text(&check.help).map_err(at)?,
                });
            }
        }
    }
    AtLeastOne::refuse(faults)
}
