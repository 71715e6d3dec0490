//! The data that every builder of the joint reads.

use crate::assembly::assembly::{InterfaceRule, Surface};
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, within};
use crate::assembly::inputs::Inputs;
use crate::assembly::scope::Scope;
use crate::assembly::small_actions::SmallActions;
use crate::assembly::template::Template;
use crate::spec::analysis::MeshSize;
use crate::spec::connection::ConnectionSpec;
use crate::spec::expr::Expr;

/// The spec, its template and the values of both. The parts of a joint are built from it.
pub(in crate::assembly) struct Context<'a> {
    pub spec: &'a ConnectionSpec,
    pub template: &'a Template,
    pub inputs: &'a Inputs<'a>,
    pub scope: &'a Scope,
    pub small: &'a SmallActions,
}

impl Context<'_> {
    /// Target element size of a part: from the spec, else from the template.
    pub fn size(&self, at: &str, scope: &Scope, auto: &Expr) -> Result<f64, AssemblyError> {
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

    /// An open interface with the friction law and coefficient of the spec.
    pub fn rule(
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
}
