//! Places, parts and circumstances that a check names.

use super::frame::Frame;
use super::part::Part;
use super::sense::Sense;
use crate::unit::number as n;
use serde::{Deserialize, Serialize};
use std::fmt;

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
    /// A name of the user: the words of a part of a template.
    Named(String),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let heights = |all: &[f64]| {
            let all: Vec<String> = all.iter().map(|z| n(*z)).collect();
            format!("z = {} mm", all.join(" and "))
        };
        match self {
            Place::End(name) | Place::Named(name) => f.write_str(name),
            Place::Part(part) => f.write_str(part.words()),
            Place::Seam { of, to } => write!(f, "{} to the {}", of.words(), to.words()),
            Place::Sense(sense) => f.write_str(sense.words()),
            Place::Beta(beta) => write!(f, "β = {}", n(*beta)),
            Place::Row { number, z } => write!(f, "row {number} at {}", heights(&[*z])),
            Place::Rows(z) => {
                write!(f, "{} at {}", if z.len() > 1 { "rows" } else { "row" }, heights(z))
            }
            Place::Heights(z) => f.write_str(&heights(z)),
            Place::EndBolt => f.write_str("end bolt"),
            Place::InnerBolt => f.write_str("inner bolt"),
            Place::VerticalForce => f.write_str("vertical force"),
            Place::Thread => f.write_str("thread in the shear plane"),
            Place::Capped => f.write_str("tension capped at F_t,Rd"),
            Place::Frame(frame) => f.write_str(frame.words()),
            Place::Bolt { size, grade } => write!(f, "{size} {grade}"),
            Place::Washers(count) => write!(f, "{count} washers"),
            Place::Annex(name) => write!(f, "annex {name}"),
        }
    }
}
