//! Ids of the checks, with their titles.

use serde::{Deserialize, Serialize};

/// Makes the enum and its titles from one table.
macro_rules! ids {
    ($($id:ident $title:literal,)*) => {
        /// What a check checks.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[derive(Serialize, Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum CheckId {
            $(#[doc = $title] $id,)*
        }

        impl CheckId {
            /// All ids.
            pub const ALL: &[CheckId] = &[$(CheckId::$id,)*];

            /// The title in English, as a report prints it.
            pub fn title(self) -> &'static str {
                match self {
                    $(CheckId::$id => $title,)*
                }
            }
        }
    };
}

ids! {
    // detailing and holes
    EndDistance "end distance",
    EndDistanceExposed "end distance, exposed steel",
    EdgeDistance "edge distance",
    EdgeDistanceExposed "edge distance, exposed steel",
    PitchOfRows "pitch of the rows",
    PitchOfRowsExposed "pitch of the rows, exposed or compressed steel",
    GaugeOfColumns "gauge of the bolt columns",
    GaugeOfColumnsExposed "gauge of the bolt columns, exposed or compressed steel",
    SpannerClearance "spanner clearance",
    WasherClearOfRoot "washer clear of the root fillet",
    PlateOverhang "end plate no wider than the column flange, where it bears",
    StiffenerOutstand "outstand of the stiffener",
    BoltLength "least length of the bolt",
    FreeThread "free thread under the nut",
    NormalHoles "normal round holes",
    SmallBoltHoles "round holes with 2 mm clearance of small bolts",
    OversizeHoles "oversize round holes",
    // what the rules do not cover
    OutsideRange "outside the range of the rules",
    LoadsNotHeld "loads that the checks do not hold",
    NotChecked "not checked",
    NothingActs "nothing acts",
    // national annexes
    AnnexNotCovered "rules of the national annex that are not covered",
    AnnexRowForces "forces of the bolt rows",
    AnnexYieldStrengths "yield strengths by the product standard",
    AnnexBoltClass "bolt class of the annex",
    AnnexThroat "least throat beside the thicker part",
    // bolts
    BoltTensionResistance "tension resistance of a bolt",
    BoltShearResistance "shear resistance of a bolt, per plane",
    LongJoint "long joint",
    Packing "packs between the plates",
    PunchingResistance "punching resistance at a bolt",
    BearingResistance "bearing resistance at a bolt",
    BearingAcross "bearing resistance at a bolt, across the member",
    BlockTearing "block tearing",
    BlockTearingAcross "block tearing across the member",
    BoltGroupShear "shear of the bolt group, reduced for tension",
    BoltTension "tension of a bolt, prying included, by the row forces of the component method",
    BoltShearAndTension "shear and tension of a bolt",
    ShearAcross "shear force across the member",
    FourBolts "four bolts in a row",
    SlipResistance "slip resistance of a bolt",
    SlipUltimate "slip of the preloaded bolts at the ultimate limit state (category C)",
    SlipServiceability "slip of the preloaded bolts at serviceability (category B)",
    SlipNoCase "category B: no load case has `state: SLS`, so that slip is not checked",
    SlipFactor "slip factor above class A: EN 1090-2 asks for a test of the surfaces",
    PreloadedAssemblies "preloaded bolts are assemblies of EN 14399: take a size `HR …` or `HV …`",
    Preload "preload of a bolt",
    PreloadLimit "preload of the slip resistance, no more than F_p,C",
    WeakAxisOfJoint "moment of the joint about the weak axis",
    TorsionOfJoint "torsion of the joint",
    // cover-plate splices
    SpliceShares "shares of flanges and web in the actions",
    SpliceLeastForces "least forces of a column splice",
    SpliceWeakAxis "least moment and shear force of a column splice across the web",
    SpliceContact "compression by contact of the ends",
    SpliceBoltShear "shear of a bolt",
    FlangeTension "tension of the flange beside its holes",
    FlangeCompression "compression of the flange",
    FlangeYieldsFirst "yielding of the flange before its holes tear",
    CoverTension "tension of the covers beside their holes",
    CoverCompression "compression of the covers between the bolts",
    WebTension "tension of the web beside its holes",
    WebNetShear "shear of the web beside its holes",
    WebCoverShear "shear of the web covers",
    WebCoverNetShear "shear of the web covers beside their holes",
    WebCoverBending "bending of the web covers with axial and shear force",
    WebCoverNetBending "bending of the web covers with axial force beside their holes",
    WebCoverBuckling "buckling of the web covers between the bolts",
    CoverClearOfRoot "cover clear of the root fillet",
    // column bases
    BaseStrength "bearing strength of the concrete",
    BaseGrout "grout under the base plate",
    BaseCompression "compression of the base on its effective area",
    BaseFlangeCompression "compression of the base under a flange",
    BaseTension "tension of the base at an anchor row",
    BaseMoment "moment resistance of the base at constant eccentricity",
    BaseShear "shear of the base by friction and anchors",
    AnchorShear "shear resistance of an anchor bolt",
    AnchorShearAndTension "shear and tension of an anchor bolt",
    Anchorage "anchorage in the concrete by EN 1992-4",
    BaseRigidLength "length of the column from which the base is rigid",
    // welds
    WeldSimplified "fillet weld, simplified method",
    WeldDirectional "fillet weld, directional method",
    WeldAcross "fillet weld across the force, directional method",
    WeldFullStrength "fillet weld of full strength",
    ThroatFullStrength "throat of a double fillet weld of full strength",
    LeastThroat "least throat",
    LeastWeldLength "least effective length",
    WeldLengths "effective length of fillet welds",
    WeldStrength "strength of fillet welds",
    WebWeldBesideRows "web weld beside the rows in tension, directional method",
    WebWeldNotWeakest "web weld no weaker than the rows in tension",
    FlangeWeldNotWeakest "flange weld no weaker than the joint",
    FlangeWeldOfHinge "flange weld where a plastic hinge turns in the joint",
    StiffenerWelds "fillet welds of the column stiffeners",
    DoublerThroat "throat of the welds of a web doubler",
    DoublerWelds "shear flow in the welds of a web doubler",
    RibThroat "throat of welds as strong as the rib",
    // beam
    BeamShear "shear of the beam",
    BeamShearAcross "shear of the beam along its flanges",
    BeamShearTorsion "shear of the beam beside torsion",
    BeamShearAcrossTorsion "shear of the beam along its flanges beside torsion",
    BeamShearBuckling "shear buckling of the beam web, h_w/t_w > 72 ε",
    BeamAxial "axial force of the beam",
    BeamMoment "moment of the beam with its shear and axial force",
    BeamBothAxes "bending of the beam about both axes",
    BeamTorsion "torsion of the beam",
    BeamMomentResistance "moment resistance of the beam",
    Tying "tying resistance, without welds",
    // haunch of the beam
    HaunchSteel "steel of the haunch",
    HaunchFlangeThickness "thickness of the haunch flange, no less than that of the beam",
    HaunchFlangeWidth "width of the haunch flange, no less than that of the beam",
    HaunchWebThickness "thickness of the haunch web, no less than that of the beam",
    HaunchAngle "angle of the haunch flange with the flange of the beam",
    HaunchTipWeld "weld of the haunch flange at its tip",
    HaunchHeld "compressed flanges of haunch and beam held sideways",
    HaunchTipWeb "web of the beam under the haunch flange",
    HaunchTipFlange "flange of the beam in bending under the haunch flange",
    HaunchWebShear "shear of the haunch web along the beam",
    HaunchSeam "fillet welds of the haunch web, simplified method",
    InclinedFillet "angle of the fillet welds of a flange",
    // simple joints
    BoltInGroup "shear of the most loaded bolt of the group",
    BearingInGroup "bearing at the most loaded bolt of the group",
    BearingAlong "bearing resistance at a bolt, along the beam",
    BearingOfGroup "bearing of the bolt group",
    GrossShear "shear of the gross section",
    NetShear "shear of the net section",
    NetTension "tension beside the holes",
    ShearAndTension "shear and tension together",
    BlockShearAndTension "block tearing under shear and tension together",
    PlateBending "bending of the plate in its plane",
    PlateBuckling "lateral torsional buckling of a long fin plate",
    WebBending "bending of the beam web around the bolts of a long fin plate",
    WebAtPlate "shear of the beam web over the height of the plate",
    NotchMoment "moment of the beam at the notch, with its shear force",
    LastLineMoment "moment of the notched beam at the last line of bolts, with its shear force",
    NotchDepth "depth of the notch for local stability",
    NotchLength "length of the notch for local stability",
    SupportShear "local shear of the support",
    SupportPunching "thickness of the fin plate, so that it does not punch through the support",
    SupportTension "tension of the support",
    PushedPlate "compression of a simple joint",
    MomentOfPinned "moment of a nominally pinned joint",
    PinnedThickness "thickness for the rotation of a pinned joint",
    PinnedDistances "end and edge distances of a pinned joint",
    PlateHeight "height of the plate beside that of the beam",
    // column and its stiffeners
    ColumnShear "shear of the column",
    ColumnAxial "axial force of the column",
    ColumnNetTension "tension of the column beside its holes",
    ColumnMoment "moment of the column with its shear and axial force",
    ColumnNotChecked "column beside the joint, not checked",
    NodeEquilibrium "equilibrium of the node",
    WebLongitudinal "longitudinal stress of the column web",
    StiffenedWebCrushing "crushing of the column web with the net section of its stiffeners",
    StiffenersInTension "net section of the stiffeners in tension",
    // component method
    PryingForces "prying forces",
    TStub "T-stub in tension",
    ColumnWebTension "column web in tension",
    BeamWebTension "beam web in tension",
    ColumnWebCompression "column web in compression",
    StiffenedWebCompression "stiffened column web in compression",
    BeamFlangeCompression "beam flange and web in compression",
    ColumnPanel "column web panel in shear",
    RowTension "tension resistance of a row",
    MomentResistance "moment resistance of the joint",
    StrengthBesideBeam "strength against that of the beam",
    StrengthClass "class by strength",
    MethodResistance "resistance by the component method",
    MomentAndAxial "moment and axial force of the joint",
    AxialLeftOut "axial force that the code leaves out, in equilibrium",
    PanelNoColumnShear "column web panel in shear (column shear not given, V_Ed = 0)",
    PanelByEquilibrium "column web panel in shear (column shear by equilibrium of the node)",
    // stability
    Unseen "stability that a limit analysis does not see",
    ColumnWebBuckling "column web in compression, with its buckling",
    AxialBuckling "axial compression of the joint, with the buckling of the column web",
    // stiffness
    InitialStiffness "initial rotational stiffness",
    ElasticStiffness "rotational stiffness for elastic analysis",
    StiffnessAtMoment "rotational stiffness under the moment",
    StiffnessClass "class by stiffness",
    RigidLimit "limit of rigid joints",
    PinnedLimit "limit of nominally pinned joints",
    RigidLength "system length of the beam from which the joint is rigid",
    // rotation capacity
    RotationCapacity "thickness for rotation capacity",
    PlasticRows "thickness for plastic forces of the rows",
    PanelSlenderness "slenderness of the web panel",
}
