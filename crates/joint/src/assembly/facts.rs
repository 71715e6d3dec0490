//! What the hand checks read of a joint, by family of connections.

use super::actions::PlaneActions;
use super::assembly::Assembly;
use super::base_entry::{self, column_base};
use super::builder::Context;
use super::code_values::CodeValues;
use super::column_base::ColumnBase;
use super::column_span::column_span;
use super::content::Content;
use super::cover_splice::CoverSplice;
use super::coverage;
use super::end_plate::{EndPlate, end_plate};
use super::error::AssemblyError;
use super::member_ends::Frame;
use super::simple_entry::{self, simple_joint};
use super::simple_joint::SimpleJoint;
use super::splice_entry::{self, cover_splice};
use super::template::HandCheckEntry;
use serde::Serialize;

/// Facts of a joint for its hand checks. Each room that needs more than the actions matches the
/// family once.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Facts {
    /// A bolted end plate, on a column or of a splice.
    EndPlate(EndPlate),
    /// A fin plate or a header plate.
    Simple(SimpleJoint),
    /// A splice of beams with bolted cover plates.
    CoverSplice(Box<CoverSplice>),
    /// A column on a plate with anchors, on concrete.
    ColumnBase(Box<ColumnBase>),
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
        let facts = match entry {
            HandCheckEntry::EndPlate(entry) => {
                let mut seen = end_plate(context, entry, code, actions)?;
                if let (Some(column), Some(role)) = (&mut seen.column, &entry.column) {
                    column.span = column_span(context, assembly, frames, role)?;
                }
                Facts::EndPlate(seen)
            }
            HandCheckEntry::Simple(entry) => {
                Facts::Simple(simple_joint(context, entry, code, actions)?)
            }
            HandCheckEntry::CoverSplice(entry) => {
                Facts::CoverSplice(Box::new(cover_splice(context, entry, code, actions)?))
            }
            HandCheckEntry::ColumnBase(entry) => {
                let of = (assembly, frames);
                Facts::ColumnBase(Box::new(column_base(context, entry, code, of, actions)?))
            }
        };
        Ok(Some(facts))
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
        let frame = || match frames {
            [one] => Ok(one),
            _ => Err(AssemblyError::TemplateEntry {
                at: "hand_checks.ends".into(),
                problem: format!("{} member ends; these checks know one", frames.len()),
            }),
        };
        match (self, entry) {
            (Facts::EndPlate(seen), HandCheckEntry::EndPlate(entry)) => {
                context.all_seen(assembly, frames, seen)?;
                coverage::compare(content, assembly, frames, entry, seen);
            }
            (Facts::Simple(seen), HandCheckEntry::Simple(entry)) => {
                let expected = simple_entry::expected(seen, entry, frame()?, content);
                seen.not_checked = expected.compare(content, assembly)?;
                content.not_checked.clone_from(&seen.not_checked);
            }
            (Facts::CoverSplice(seen), HandCheckEntry::CoverSplice(entry)) => {
                let expected = splice_entry::expected(seen, entry, frame()?);
                seen.not_checked = expected.compare(content, assembly)?;
                content.not_checked.clone_from(&seen.not_checked);
            }
            (Facts::ColumnBase(seen), HandCheckEntry::ColumnBase(entry)) => {
                let expected = base_entry::expected(seen, entry, frame()?);
                seen.not_checked = expected.compare(content, assembly)?;
                content.not_checked.clone_from(&seen.not_checked);
            }
            // the facts are those of the entry
            _ => {}
        }
        Ok(())
    }

    /// The facts of an end plate; `None` of another family.
    pub fn end_plate(&self) -> Option<&EndPlate> {
        match self {
            Facts::EndPlate(e) => Some(e),
            _ => None,
        }
    }

    /// The actions of the load cases at the planes of the connection.
    pub fn actions(&self) -> &[PlaneActions] {
        match self {
            Facts::EndPlate(e) => &e.actions,
            Facts::Simple(e) => &e.actions,
            Facts::CoverSplice(e) => &e.actions,
            Facts::ColumnBase(e) => &e.actions,
        }
    }
}
