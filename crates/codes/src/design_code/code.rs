//! A design code with its partial factors.

use crate::eurocode::bolts::shank_strength;
use crate::eurocode::concrete;
use crate::eurocode::grip;
use crate::eurocode::welds::shear_strength;
use crate::eurocode::yielding::{net_strength, yield_strength};
use bracket_joint::assembly::assembly::Grip;
use bracket_joint::assembly::{Assembly, Foundation, Joint};
use bracket_joint::spec::code::{Edition, PartialFactors};
use bracket_joint::strength::{
    Bearing, BoltLimits, BoltShank, Design, DesignStrengths, Nominal, NominalStrength, WeldSteel,
};
use std::collections::BTreeMap;

/// A design code with its partial factors: the primitives that the analyses and the checks share.
///
/// It is a closed enum and no trait: the spec names its code when the program runs, all codes are
/// known here, and a `match` without a default shows every place that a new code must fill. The
/// clauses themselves are functions in a room of their code ([`crate::eurocode`]), which the checks
/// call as well, so that each formula stands once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DesignCode {
    /// EN 1993-1-1:2005 and EN 1993-1-8:2005.
    En1993_2005(PartialFactors),
}

impl DesignCode {
    /// The code of an edition, with these partial factors.
    pub fn new(edition: Edition, factors: PartialFactors) -> Self {
        match edition {
            Edition::Ec2005 => Self::En1993_2005(factors),
        }
    }

    /// The code by which a joint was built.
    pub fn of(joint: &Joint) -> Self {
        Self::new(joint.edition, joint.factors)
    }

    /// Design yield strength of rolled steel.
    pub fn yield_strength(&self, fy: Nominal) -> Design {
        match self {
            Self::En1993_2005(f) => yield_strength(fy, f.gamma_m0),
        }
    }

    /// Design yield strength of a bolt's shank: the design tension resistance over the area of the
    /// shank.
    pub fn shank_strength(&self, bolt: &BoltShank) -> Design {
        match self {
            Self::En1993_2005(f) => shank_strength(bolt, f.gamma_m2),
        }
    }

    /// Design strength of a part with holes, of a steel with this design yield strength.
    pub fn net_strength(&self, fyd: Design, fu: Nominal) -> Design {
        match self {
            Self::En1993_2005(f) => net_strength(fyd, fu, f.gamma_m2),
        }
    }

    /// Resistances of a bolt in its grip.
    pub fn bolt_limits(&self, grip: &Grip) -> BoltLimits {
        match self {
            Self::En1993_2005(f) => grip::limits(grip, f),
        }
    }

    /// Design shear strength of a fillet weld on its throat.
    pub fn weld_strength(&self, steel: &WeldSteel) -> Design {
        match self {
            Self::En1993_2005(f) => shear_strength(steel, f.gamma_m2),
        }
    }

    /// Design bearing strength of the concrete under a base plate.
    pub fn bearing_strength(&self, foundation: &Foundation) -> Design {
        match self {
            Self::En1993_2005(f) => {
                Design::new(concrete::bearing_strength(foundation, f.concrete).value)
            }
        }
    }

    /// Design yield strength of a material; `None` if it does not yield.
    pub fn strength(&self, nominal: &NominalStrength) -> Option<Design> {
        match nominal {
            NominalStrength::Unlimited => None,
            NominalStrength::Steel(fy) => Some(self.yield_strength(*fy)),
            NominalStrength::Bolt(bolt) => Some(self.shank_strength(bolt)),
        }
    }

    /// Design strengths of all materials and welds of an assembly, and resistances of its bolts.
    /// Its ground does not settle.
    pub fn strengths(&self, assembly: &Assembly) -> DesignStrengths {
        let each = assembly.materials.iter();
        let materials: BTreeMap<String, Option<Design>> =
            each.map(|(n, m)| (n.clone(), self.strength(&m.strength))).collect();
        let mut perforated = BTreeMap::new();
        for ply in assembly.grips.iter().flat_map(|g| &g.plies) {
            let part = assembly.parts.iter().find(|p| p.name == ply.part);
            if let Some(fyd) = part.and_then(|p| *materials.get(&p.material)?) {
                perforated.insert(ply.part.clone(), self.net_strength(fyd, ply.fu));
            }
        }
        let (welds, grips) = (assembly.welds.iter(), assembly.grips.iter());
        let ground = assembly.supports.iter().filter_map(|s| {
            let strength = self.bearing_strength(s.ground.as_ref()?);
            Some((s.face.clone(), Bearing { strength, stiffness: None }))
        });
        DesignStrengths {
            ground: ground.collect(),
            materials,
            perforated,
            welds: welds.map(|w| (w.name.clone(), self.weld_strength(&w.steel))).collect(),
            bolts: grips.map(|g| (g.part.clone(), self.bolt_limits(g))).collect(),
        }
    }
}
