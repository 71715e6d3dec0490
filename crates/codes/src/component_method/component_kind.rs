//! The components of rows in tension, and what limits the force of a row.

use crate::check::CheckId;
use crate::subject::Part;
use bracket_base::display_text;
use bracket_base::say;
use bracket_base::words::Text;

/// A component that rows in tension share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComponentKind {
    /// Column flange in bending, with its bolts.
    ColumnFlange,
    /// Column web in tension.
    ColumnWeb,
    /// End plate in bending, with its bolts.
    EndPlate,
    /// Beam web in tension.
    BeamWeb,
}

impl ComponentKind {
    /// The part of the joint.
    pub fn part(self) -> Part {
        match self {
            ComponentKind::ColumnFlange => Part::ColumnFlange,
            ComponentKind::ColumnWeb => Part::ColumnWeb,
            ComponentKind::EndPlate => Part::EndPlate,
            ComponentKind::BeamWeb => Part::BeamWeb,
        }
    }

    /// The component as a report prints it.
    pub fn words(self) -> &'static str {
        self.part().words()
    }
}

/// A component that limits the sum of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Summed {
    /// Column web in compression.
    ColumnWeb,
    /// Beam flange and web in compression.
    BeamFlange,
    /// Column web panel in shear, over β.
    Panel,
}

/// Rule by which a row stays elastic beside the rows above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElasticRule {
    /// EN 1993-1-8:2005 6.2.7.2(9).
    NearlyBolts,
    /// UK annex, NA.2.7.
    Triangular,
}

/// What limits the force of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitedBy {
    /// A component of the row alone.
    Row(ComponentKind),
    /// A component of a group of rows.
    Group {
        /// The component.
        component: ComponentKind,
        /// First and last row of the group, counted from 0.
        rows: [usize; 2],
    },
    /// A force in proportion to the lever arm.
    Elastic(ElasticRule),
    /// A component that limits the sum of the rows.
    Sum(CheckId),
}

impl LimitedBy {
    /// The component of the row or of its group.
    pub fn component(self) -> Option<ComponentKind> {
        match self {
            LimitedBy::Row(component) | LimitedBy::Group { component, .. } => Some(component),
            LimitedBy::Elastic(_) | LimitedBy::Sum(_) => None,
        }
    }

    /// What limits the force, as a report prints it.
    pub fn text(self) -> Text {
        match self {
            LimitedBy::Row(component) => component.words().into(),
            LimitedBy::Group { component, rows: [first, last] } => {
                say!("{}, rows {}–{}", component.words(), first + 1, last + 1)
            }
            LimitedBy::Elastic(ElasticRule::NearlyBolts) => "6.2.7.2(9), lever arms".into(),
            LimitedBy::Elastic(ElasticRule::Triangular) => "UK NA.2.7, triangular limit".into(),
            LimitedBy::Sum(id) => id.title().into(),
        }
    }
}

display_text!(LimitedBy);
