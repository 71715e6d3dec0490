//! Parts of a joint.

use serde::{Deserialize, Serialize};

/// A part of a joint, or parts that a check takes together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// The whole joint.
    Joint,
    /// The end plate.
    EndPlate,
    /// The fin plate of a simple joint.
    FinPlate,
    /// The header plate of a simple joint.
    HeaderPlate,
    /// The beam as a member.
    Beam,
    /// A flange of the beam.
    BeamFlange,
    /// The web of the beam.
    BeamWeb,
    /// Beam and end plate, which one weld joins.
    BeamAndEndPlate,
    /// The column as a member.
    Column,
    /// The flange of the column that the end plate is bolted to.
    ColumnFlange,
    /// The web of the column.
    ColumnWeb,
    /// The web of the beam that supports a simple joint.
    SupportingWeb,
    /// The web of the column between the flanges of the beam.
    Panel,
    /// One stiffener of the column.
    Stiffener,
    /// All stiffeners of the column.
    Stiffeners,
    /// The stiffeners level with the flange in tension.
    StiffenersInTension,
    /// The stiffeners level with the compressed flange.
    CompressedStiffeners,
    /// Flanges of the beam and stiffeners of the column.
    FlangesAndStiffeners,
    /// The supplementary web plate of the column.
    Doubler,
    /// The rib on the beam flange.
    Rib,
    /// The bolts.
    Bolts,
    /// The rows of bolts.
    BoltRows,
    /// The bolt holes.
    Holes,
    /// The welds.
    Welds,
    /// The T-stubs of the component method.
    TStubs,
    /// All member ends.
    MemberEnds,
}

impl Part {
    /// The part as a report prints it.
    pub fn words(self) -> &'static str {
        match self {
            Part::Joint => "joint",
            Part::EndPlate => "end plate",
            Part::FinPlate => "fin plate",
            Part::HeaderPlate => "header plate",
            Part::Beam => "beam",
            Part::BeamFlange => "beam flange",
            Part::BeamWeb => "beam web",
            Part::BeamAndEndPlate => "beam and end plate",
            Part::Column => "column",
            Part::ColumnFlange => "column flange",
            Part::ColumnWeb => "column web",
            Part::SupportingWeb => "web of the supporting beam",
            Part::Panel => "column web panel",
            Part::Stiffener => "column stiffener",
            Part::Stiffeners => "column stiffeners",
            Part::StiffenersInTension => "stiffeners in tension",
            Part::CompressedStiffeners => "compressed stiffeners",
            Part::FlangesAndStiffeners => "flanges and stiffeners",
            Part::Doubler => "web doubler",
            Part::Rib => "rib",
            Part::Bolts => "bolts",
            Part::BoltRows => "bolt rows",
            Part::Holes => "holes",
            Part::Welds => "welds",
            Part::TStubs => "T-stubs",
            Part::MemberEnds => "all member ends",
        }
    }
}
