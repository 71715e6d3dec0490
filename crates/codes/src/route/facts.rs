//! What the route needs to know of a joint beside its fields.

use crate::design_code::DesignCode;
use crate::eurocode::welds::WeldedSteel;
use bracket_joint::assembly::Joint;
use bracket_joint::assembly::assembly::Grip;
use bracket_joint::spec::code::PartialFactors;
use bracket_joint::strength::{BoltLimits, Nominal, NominalStrength};

/// Facts of a joint for the route of analysis.
#[derive(Clone, Debug, PartialEq)]
pub struct RouteFacts {
    /// The bolts with their design resistances.
    pub bolts: Vec<(Grip, BoltLimits)>,
    /// Steels by the key of their material, with f_y and f_u.
    pub steels: Vec<(String, [Nominal; 2])>,
    /// The fillet welds.
    pub welds: Vec<WeldFacts>,
    /// Partial factors.
    pub factors: PartialFactors,
    /// Whether hand checks cover net section and block tearing.
    pub hand_checked: bool,
}

/// A fillet weld on each side of a plate.
#[derive(Clone, Debug, PartialEq)]
pub struct WeldFacts {
    /// Name of the weld.
    pub name: String,
    /// Throat of each weld \[mm\].
    pub throat: f64,
    /// Thickness of the plate \[mm\].
    pub thickness: f64,
    /// True: one weld round the outside of a hollow section.
    pub closed: bool,
    /// Its steel.
    pub steel: WeldedSteel,
}

impl RouteFacts {
    /// The facts of a joint.
    pub fn of(joint: &Joint) -> Self {
        let (assembly, code) = (&joint.assembly, DesignCode::of(joint));
        let gamma_m2 = joint.factors.gamma_m2;
        let grips = assembly.grips.iter().map(|g| (g.clone(), code.bolt_limits(g)));
        let steels = assembly.materials.iter().filter_map(|(key, m)| match (m.strength, m.fu) {
            (NominalStrength::Steel(fy), Some(fu)) => Some((key.clone(), [fy, fu])),
            _ => None,
        });
        let welds = assembly.welds.iter().map(|w| WeldFacts {
            name: w.name.clone(),
            throat: w.throat,
            thickness: w.thickness,
            closed: w.closed,
            steel: WeldedSteel { fu: w.steel.fu, beta_w: w.steel.beta_w, gamma_m2 },
        });
        Self {
            bolts: grips.collect(),
            steels: steels.collect(),
            welds: welds.collect(),
            factors: joint.factors,
            hand_checked: joint.facts.is_some(),
        }
    }
}
