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
    /// The beam with its haunch at the end plate.
    HaunchedBeam,
    /// The beam at the tip of its haunch.
    HaunchTip,
    /// The haunch of the beam.
    Haunch,
    /// The flange of the haunch.
    HaunchFlange,
    /// The web of the haunch.
    HaunchWeb,
    /// The stiffeners of the beam at the tip of the haunch.
    HaunchStiffener,
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
    /// The member before the splice axis.
    LeftMember,
    /// The member behind the splice axis.
    RightMember,
    /// The upper flange of a spliced member.
    UpperFlange,
    /// The lower flange of a spliced member.
    LowerFlange,
    /// The wall of a hollow column.
    ColumnWall,
    /// The flange of a column at positive x.
    FlangeAtPlus,
    /// The flange of a column at negative x.
    FlangeAtMinus,
    /// Either flange of a spliced member.
    SplicedFlange,
    /// The web of a spliced member.
    SplicedWeb,
    /// The cover outside a flange.
    OuterCover,
    /// The pair of covers inside a flange.
    InnerCovers,
    /// The two covers of a web.
    WebCovers,
    /// The bolts of a flange on one side of the splice axis.
    FlangeBolts,
    /// The bolts of a web on one side of the splice axis.
    WebBolts,
    /// The plate under a column.
    BasePlate,
    /// The anchor bolts of a base.
    Anchors,
    /// The concrete under a base plate.
    Concrete,
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
            Part::HaunchedBeam => "beam with its haunch at the plate",
            Part::HaunchTip => "beam at the tip of the haunch",
            Part::Haunch => "haunch",
            Part::HaunchFlange => "haunch flange",
            Part::HaunchWeb => "haunch web",
            Part::HaunchStiffener => "stiffeners at the tip of the haunch",
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
            Part::LeftMember => "left member",
            Part::RightMember => "right member",
            Part::UpperFlange => "upper flange",
            Part::LowerFlange => "lower flange",
            Part::ColumnWall => "column wall",
            Part::FlangeAtPlus => "flange at positive x",
            Part::FlangeAtMinus => "flange at negative x",
            Part::SplicedFlange => "flange",
            Part::SplicedWeb => "web",
            Part::OuterCover => "outer cover",
            Part::InnerCovers => "inner covers",
            Part::WebCovers => "web covers",
            Part::FlangeBolts => "flange bolts",
            Part::WebBolts => "web bolts",
            Part::BasePlate => "base plate",
            Part::Anchors => "anchor bolts",
            Part::Concrete => "concrete",
            Part::Bolts => "bolts",
            Part::BoltRows => "bolt rows",
            Part::Holes => "holes",
            Part::Welds => "welds",
            Part::TStubs => "T-stubs",
            Part::MemberEnds => "all member ends",
        }
    }
}
