//! Places, parts and circumstances that a check names.

use super::frame::Frame;
use super::part::Part;
use super::sense::Sense;
use crate::unit::number as n;
use bracket_base::display_text;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::catalog::{BoltGrade, BoltSize};
use serde::{Deserialize, Serialize};

/// One entry of a subject.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// A member end, by its name in the template.
    End(String),
    /// A part of the joint.
    Part(Part),
    /// The seam of a part on another one.
    Seam {
        /// The part that the weld holds.
        of: Part,
        /// The part that it is welded to.
        to: Part,
    },
    /// Sense of bending.
    Sense(Sense),
    /// Transformation parameter β.
    Beta(f64),
    /// A row of bolts.
    Row {
        /// Its number from the tension side.
        number: usize,
        /// z from the axis of the beam \[mm\].
        z: f64,
    },
    /// Rows of bolts by z from the axis of the beam \[mm\].
    Rows(Vec<f64>),
    /// Heights z of rows from the axis of the beam \[mm\].
    Heights(Vec<f64>),
    /// The bolt nearest to the end of a plate.
    EndBolt,
    /// A bolt between others.
    InnerBolt,
    /// The force along the column.
    VerticalForce,
    /// The thread of a bolt in the shear plane.
    Thread,
    /// Tension that counts no more than F_t,Rd.
    Capped,
    /// Kind of the frame around the joint.
    Frame(Frame),
    /// A bolt by size and grade.
    Bolt {
        /// Size: `M20`.
        size: String,
        /// Grade: `8.8`.
        grade: String,
    },
    /// Number of washers.
    Washers(u32),
    /// A national annex by its name in the catalogue.
    Annex(String),
    /// The words of a part of a template.
    Named(Text),
}

/// Heights of rows: `90 and -90`.
fn heights(all: &[f64]) -> Text {
    let mut all = all.iter().map(|z| Text::given(n(*z)));
    let first = all.next().unwrap_or_default();
    all.fold(first, |before, z| say!("{} and {}", before, z))
}

impl Place {
    /// The bolts of a size and a grade.
    pub fn bolt(size: &BoltSize, grade: &BoltGrade) -> Self {
        Place::Bolt { size: size.size.clone(), grade: grade.grade.clone() }
    }

    /// The place as a report prints it.
    pub fn text(&self) -> Text {
        match self {
            Place::End(name) => Text::given(name.as_str()),
            Place::Named(name) => name.clone(),
            Place::Part(part) => part.words().into(),
            Place::Seam { of, to } => say!("{} to the {}", of.words(), to.words()),
            Place::Sense(sense) => sense.words().into(),
            Place::Beta(beta) => Text::given(format!("β = {}", n(*beta))),
            Place::Row { number, z } => say!("row {} at z = {} mm", *number, n(*z)),
            Place::Rows(z) if z.len() > 1 => say!("rows at z = {} mm", heights(z)),
            Place::Rows(z) => say!("row at z = {} mm", heights(z)),
            Place::Heights(z) => say!("z = {} mm", heights(z)),
            Place::EndBolt => "end bolt".into(),
            Place::InnerBolt => "inner bolt".into(),
            Place::VerticalForce => "vertical force".into(),
            Place::Thread => "thread in the shear plane".into(),
            Place::Capped => "tension capped at F_t,Rd".into(),
            Place::Frame(frame) => frame.words().into(),
            Place::Bolt { size, grade } => Text::given(format!("{size} {grade}")),
            Place::Washers(count) => say!("{} washers", *count),
            Place::Annex(name) => say!("annex {}", name),
        }
    }
}

display_text!(Place);
