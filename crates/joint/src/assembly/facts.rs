//! What the hand checks read of a joint, by family of connections.

use super::actions::PlaneActions;
use super::assembly::Assembly;
use super::builder::Context;
use super::code_values::CodeValues;
use super::column_span::column_span;
use super::content::Content;
use super::coverage;
use super::end_plate::{EndPlate, end_plate};
use super::error::AssemblyError;
use super::member_ends::Frame;
use serde::Serialize;

/// Facts of a joint for its hand checks. Each room that needs more than the actions matches the
/// family once.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Facts {
    /// A bolted end plate, on a column or of a splice.
    EndPlate(EndPlate),
}

impl Facts {
    /// The facts of a joint under `actions`; `None` if its template has no `hand_checks`. `frames`
    /// are those of the member ends named there.
    pub(super) fn of(
        context: &Context<'_>,
        code: &CodeValues,
        assembly: &Assembly,
        actions: Vec<PlaneActions>,
        frames: &[Frame],
    ) -> Result<Option<Self>, AssemblyError> {
        let Some(entry) = &context.template.hand_checks else { return Ok(None) };
        let mut seen = end_plate(context, entry, code, actions)?;
        if let (Some(column), Some(role)) = (&mut seen.column, &entry.column) {
            column.span = column_span(context, assembly, frames, role)?;
        }
        Ok(Some(Facts::EndPlate(seen)))
    }

    /// Compares the facts with the geometry: all bolts must be seen, and what the hand checks do
    /// not cover is named in facts and `content`.
    pub(super) fn compare(
        &mut self,
        context: &Context<'_>,
        assembly: &Assembly,
        frames: &[Frame],
        content: &mut Content,
    ) -> Result<(), AssemblyError> {
        let Some(entry) = &context.template.hand_checks else { return Ok(()) };
        match self {
            Facts::EndPlate(seen) => {
                context.all_seen(assembly, frames, seen)?;
                coverage::compare(content, assembly, frames, entry, seen);
            }
        }
        Ok(())
    }

    /// The facts of an end plate; `None` of another family.
    pub fn end_plate(&self) -> Option<&EndPlate> {
        match self {
            Facts::EndPlate(e) => Some(e),
        }
    }

    /// The actions of the load cases at the planes of the connection.
    pub fn actions(&self) -> &[PlaneActions] {
        match self {
            Facts::EndPlate(e) => &e.actions,
        }
    }
}
