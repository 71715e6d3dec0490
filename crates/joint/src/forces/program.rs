//! Frame programs: how they name, direct and sign internal forces.
//!
//! Bracket's actions are those of a section whose outward normal is x′: `N, Vy, Vz, T, My, Mz` are
//! components of force and moment along x′, y′, z′, right-handed, with z′ up (along the depth of
//! the section) and y′ = z′ × x′. At the start of a member x′ is its own axis x. At its end x′ is
//! −x, and the force on the section is the opposite one:
//! `N, Vy, −Vz, T, My, −Mz`.

use bracket_base::units::Kind;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A frame program with a table of internal forces of its own form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Program {
    /// Structural Analysis Format, sheet `ResultInternalForce1D`.
    Saf,
    /// SAP2000, table `Element Forces - Frames`.
    Sap2000,
    /// ETABS, tables `Element Forces - Beams` and `- Columns`.
    Etabs,
    /// Autodesk Robot, table of forces of bars.
    Robot,
    /// Dlubal RFEM and RSTAB, internal forces of members.
    Rfem,
    /// STAAD, end forces of members.
    Staad,
    /// SCIA Engineer, internal forces on members.
    Scia,
    /// IDEA StatiCa, container of an open model with its results (IOM, XML).
    Iom,
}

/// What a column of a table of forces holds.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
pub enum Quantity {
    /// Name of the load case or combination.
    #[serde(rename = "case")]
    Case,
    /// Name of the member.
    #[serde(rename = "member")]
    Member,
    /// Place on the member: its distance from the start.
    #[serde(rename = "station")]
    Station,
    /// Node at the end of the member.
    #[serde(rename = "node")]
    Node,
    /// Member end of the template.
    #[serde(rename = "end")]
    End,
    /// Point at which the actions act.
    #[serde(rename = "at")]
    At,
    /// Limit state.
    #[serde(rename = "state")]
    State,
    /// Kind of a row of an envelope.
    #[serde(skip)]
    Step,
    /// Axial force.
    N,
    /// Shear along y′.
    Vy,
    /// Shear along z′.
    Vz,
    /// Torsion.
    T,
    /// Moment about y′.
    My,
    /// Moment about z′.
    Mz,
}

impl Quantity {
    /// The six actions, in the order of a row.
    pub const ACTIONS: [Self; 6] = [Self::N, Self::Vy, Self::Vz, Self::T, Self::My, Self::Mz];
    /// All quantities.
    pub const ALL: [Self; 14] = [
        Self::Case,
        Self::Member,
        Self::Station,
        Self::Node,
        Self::End,
        Self::At,
        Self::State,
        Self::Step,
        Self::N,
        Self::Vy,
        Self::Vz,
        Self::T,
        Self::My,
        Self::Mz,
    ];

    /// Index of an action; `None` for what is none.
    pub fn action(self) -> Option<usize> {
        Self::ACTIONS.iter().position(|a| *a == self)
    }

    /// Kind of an action: a force or a moment.
    pub fn kind(self) -> Kind {
        match self {
            Self::N | Self::Vy | Self::Vz => Kind::Force,
            _ => Kind::Moment,
        }
    }

    /// Its key in `columns`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Case => "case",
            Self::Member => "member",
            Self::Station => "station",
            Self::Node => "node",
            Self::End => "end",
            Self::At => "at",
            Self::State => "state",
            Self::Step => "step",
            Self::N => "N",
            Self::Vy => "Vy",
            Self::Vz => "Vz",
            Self::T => "T",
            Self::My => "My",
            Self::Mz => "Mz",
        }
    }
}

/// Headers of a quantity, with the sign that makes it Bracket's.
pub struct Heading {
    /// The quantity.
    pub quantity: Quantity,
    /// −1 where the column has the opposite sign.
    pub sign: f64,
    /// Its headers, without units; a cell of the first that is not empty counts.
    pub names: &'static [&'static str],
}

const fn h(quantity: Quantity, sign: f64, names: &'static [&'static str]) -> Heading {
    Heading { quantity, sign, names }
}

use Quantity::{At, Case, End, Member, My, Mz, N, Node, State, Station, Step, T, Vy, Vz};

/// Bracket's own headers. Those of actions count with their case: `MY` is a header of Robot, whose
/// moments have the opposite sign.
const OWN: &[Heading] = &[
    h(Case, 1.0, &["case", "name", "load case", "combination", "load combination"]),
    h(Member, 1.0, &["member"]),
    h(Station, 1.0, &["station", "x"]),
    h(Node, 1.0, &["node"]),
    h(End, 1.0, &["end"]),
    h(At, 1.0, &["at"]),
    h(State, 1.0, &["state"]),
    h(Step, 1.0, &["StepType", "step type"]),
    h(N, 1.0, &["N"]),
    h(Vy, 1.0, &["Vy"]),
    h(Vz, 1.0, &["Vz"]),
    h(T, 1.0, &["T", "Mx", "Mt"]),
    h(My, 1.0, &["My"]),
    h(Mz, 1.0, &["Mz"]),
];

/// SAF. Tension is positive, `My` is positive with tension at the bottom of a member whose z points
/// up, `Vz` is positive at the start of a beam under gravity (read in a workbook: members with a
/// load of −3 kN/m in global Z).
const SAF: &[Heading] = &[
    h(Case, 1.0, &["Load combination", "Load case"]),
    h(Member, 1.0, &["Member", "Member Rib"]),
    h(Station, 1.0, &["Section at"]),
    h(N, 1.0, &["N"]),
    h(Vy, -1.0, &["Vy"]),
    h(Vz, -1.0, &["Vz"]),
    h(T, 1.0, &["Mx"]),
    h(My, -1.0, &["My"]),
    h(Mz, -1.0, &["Mz"]),
];

/// The programs of CSI. Forces on a positive face point along the axes 1, 2, 3; moments are
/// positive with compression at the positive 2 and 3 faces (CSI Analysis Reference). 2 is up, so
/// that z′ is 2 and y′ is −3.
const fn csi(cases: &'static [&'static str], members: &'static [&'static str]) -> [Heading; 10] {
    [
        h(Case, 1.0, cases),
        h(Member, 1.0, members),
        h(Station, 1.0, &["Station"]),
        h(Step, 1.0, &["StepType", "Step Type"]),
        h(N, 1.0, &["P"]),
        h(Vy, -1.0, &["V3"]),
        h(Vz, 1.0, &["V2"]),
        h(T, 1.0, &["T"]),
        h(My, -1.0, &["M3"]),
        h(Mz, -1.0, &["M2"]),
    ]
}

/// SAP2000.
const SAP2000: &[Heading] = &csi(&["OutputCase", "Output Case"], &["Frame"]);

/// ETABS.
const ETABS: &[Heading] =
    &csi(&["Output Case", "OutputCase", "Load Case/Combo"], &["Unique Name", "UniqueName"]);

/// Robot. A force has the sign of the nodal force at the beginning of the bar that has the same
/// effect: compression is positive, `MY` with tension on the negative side of z, `MZ` with tension
/// on the positive side of y (Autodesk, Sign convention for bar elements).
const ROBOT: &[Heading] = &[
    h(Case, 1.0, &["Case"]),
    h(Member, 1.0, &["Bar"]),
    h(Node, 1.0, &["Node"]),
    h(Station, 1.0, &["Point", "Position"]),
    h(N, -1.0, &["FX"]),
    h(Vy, -1.0, &["FY"]),
    h(Vz, -1.0, &["FZ"]),
    h(T, -1.0, &["MX"]),
    h(My, -1.0, &["MY"]),
    h(Mz, -1.0, &["MZ"]),
];

/// RFEM. `N` and `MT` are positive on the positive face along x. With z down, the other four are
/// components on that face along y and z; with z up they are defined with the opposite signs
/// (Dlubal, FAQ 004650). Both are the same with z′ up.
const RFEM: &[Heading] = &[
    h(
        Case,
        1.0,
        &["Load case", "LC", "LC/CO", "Loading", "Load combination", "CO", "Lastfall", "LF", "LK"],
    ),
    h(Member, 1.0, &["Member No.", "Member", "Stab Nr.", "Stab"]),
    h(Node, 1.0, &["Node No.", "Node", "Knoten Nr.", "Knoten"]),
    h(Station, 1.0, &["Location x", "x", "Stelle x"]),
    h(N, 1.0, &["N"]),
    h(Vy, -1.0, &["Vy", "V-y"]),
    h(Vz, -1.0, &["Vz", "V-z"]),
    h(T, 1.0, &["MT", "M-T"]),
    h(My, -1.0, &["My", "M-y"]),
    h(Mz, -1.0, &["Mz", "M-z"]),
];

/// STAAD: forces of the nodes on the ends of a member, with y up, so that z′ is y and y′ is −z.
/// Signs are those at its start; at its end the force is the opposite one.
const STAAD: &[Heading] = &[
    h(Case, 1.0, &["L/C", "LC", "Load"]),
    h(Member, 1.0, &["Beam", "Member"]),
    h(Node, 1.0, &["Node", "Joint"]),
    h(N, -1.0, &["Fx", "Axial"]),
    h(Vy, 1.0, &["Fz", "Shear-Z"]),
    h(Vz, -1.0, &["Fy", "Shear-Y"]),
    h(T, -1.0, &["Mx", "Torsion"]),
    h(My, 1.0, &["Mz", "Mom-Z"]),
    h(Mz, -1.0, &["My", "Mom-Y"]),
];

/// SCIA Engineer: signs of SAF, which its maker began.
const SCIA: &[Heading] = &[
    h(Case, 1.0, &["Case", "Combination"]),
    h(Member, 1.0, &["Name", "Member"]),
    h(Station, 1.0, &["dx"]),
    h(N, 1.0, &["N"]),
    h(Vy, -1.0, &["Vy"]),
    h(Vz, -1.0, &["Vz"]),
    h(T, 1.0, &["Mx"]),
    h(My, -1.0, &["My"]),
    h(Mz, -1.0, &["Mz"]),
];

impl Program {
    /// All programs.
    pub const ALL: [Self; 8] = [
        Self::Saf,
        Self::Sap2000,
        Self::Etabs,
        Self::Robot,
        Self::Rfem,
        Self::Staad,
        Self::Scia,
        Self::Iom,
    ];

    /// Its word in a spec.
    pub fn word(self) -> &'static str {
        match self {
            Self::Saf => "saf",
            Self::Sap2000 => "sap2000",
            Self::Etabs => "etabs",
            Self::Robot => "robot",
            Self::Rfem => "rfem",
            Self::Staad => "staad",
            Self::Scia => "scia",
            Self::Iom => "iom",
        }
    }

    /// Sheets of a workbook that hold forces.
    pub fn sheets(program: Option<Self>) -> &'static [&'static str] {
        match program {
            Some(Self::Saf) => &["ResultInternalForce1D"],
            Some(Self::Sap2000) => &["Element Forces - Frames"],
            Some(Self::Etabs) => &["Element Forces - Beams", "Element Forces - Columns"],
            _ => &[],
        }
    }

    /// Headers and signs at the start of a member.
    pub fn headings(program: Option<Self>) -> &'static [Heading] {
        match program {
            None => OWN,
            Some(Self::Saf) => SAF,
            Some(Self::Sap2000) => SAP2000,
            Some(Self::Etabs) => ETABS,
            Some(Self::Robot) => ROBOT,
            Some(Self::Rfem) => RFEM,
            Some(Self::Staad) => STAAD,
            Some(Self::Scia) => SCIA,
            // no table: elements of XML
            Some(Self::Iom) => &[],
        }
    }

    /// The actions at the end of a member from those that the signs of its start give.
    pub fn at_end(program: Option<Self>, actions: [f64; 6]) -> [f64; 6] {
        let [n, vy, vz, t, my, mz] = match program {
            Some(Self::Staad) => actions.map(|a| -a),
            _ => actions,
        };
        [n, vy, -vz, t, my, -mz]
    }
}
