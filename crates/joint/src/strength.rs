//! Nominal and design strengths. They are two types: a nominal strength is a fact of the steel, a
//! design strength is what a design code makes of it. Only a design code (the crate `codes`) turns
//! one into the other.
//!
//! A design strength is no nominal strength:
//!
//! ```compile_fail,E0308
//! use bracket_joint::strength::{Design, NominalStrength};
//!
//! let divided = Design::new(235.0 / 1.1);
//! let _ = NominalStrength::Steel(divided);
//! ```
//!
//! and a nominal strength is no design strength:
//!
//! ```compile_fail,E0308
//! use bracket_joint::strength::{DesignStrengths, Nominal};
//!
//! let mut strengths = DesignStrengths::default();
//! strengths.welds.insert("WEB".into(), Nominal::new(360.0));
//! ```
//!
//! Each in its place compiles:
//!
//! ```
//! use bracket_joint::strength::{Design, DesignStrengths, Nominal, NominalStrength};
//!
//! let _ = NominalStrength::Steel(Nominal::new(235.0));
//! let mut strengths = DesignStrengths::default();
//! strengths.welds.insert("WEB".into(), Design::new(207.8));
//! ```

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A nominal strength of a steel, bolt or weld: f_y, f_u or f_ub of a table, before any partial
/// factor.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Nominal(f64);

impl Nominal {
    /// The nominal strength of `mpa` \[MPa\].
    pub const fn new(mpa: f64) -> Self {
        Self(mpa)
    }

    /// Its value \[MPa\].
    pub const fn mpa(self) -> f64 {
        self.0
    }
}

/// A design strength: a nominal one after the factors of a design code.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Design(f64);

impl Design {
    /// The design strength of `mpa` \[MPa\].
    pub const fn new(mpa: f64) -> Self {
        Self(mpa)
    }

    /// Its value \[MPa\].
    pub const fn mpa(self) -> f64 {
        self.0
    }
}

/// Nominal strengths of a steel at the thickness of its part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Strength {
    /// Grade.
    pub grade: String,
    /// Yield strength.
    pub fy: Nominal,
    /// Ultimate strength.
    pub fu: Nominal,
    /// Young's modulus \[MPa\].
    pub e: f64,
    /// β_w of fillet welds, if the steel has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub beta_w: Option<f64>,
}

impl Strength {
    /// The steel that governs the design of fillet welds between two parts: the one with the
    /// smaller f_u.
    pub fn weaker<'a>(&'a self, other: &'a Strength) -> &'a Strength {
        if other.fu < self.fu { other } else { self }
    }

    /// What decides the strength of fillet welds to this steel; `None` for grades without β_w.
    pub fn of_welds(&self) -> Option<WeldSteel> {
        Some(WeldSteel { fu: self.fu, beta_w: self.beta_w? })
    }
}

/// The steel that governs a fillet weld: the weaker of the two parts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeldSteel {
    /// Ultimate strength.
    pub fu: Nominal,
    /// Correlation factor β_w \[-\].
    pub beta_w: f64,
}

/// A bolt as far as the strength of its shank depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoltShank {
    /// Ultimate strength of the bolt.
    pub fub: Nominal,
    /// Tensile stress area A_s of the thread \[mm²\].
    pub stress_area: f64,
    /// Area of the shank, which the mesh has from head to nut \[mm²\].
    pub shank_area: f64,
}

/// What decides how strong a material is, without a design code.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum NominalStrength {
    /// The material does not yield.
    Unlimited,
    /// Rolled steel with this yield strength at the thickness of its part.
    Steel(Nominal),
    /// A bolt.
    Bolt(BoltShank),
}

impl NominalStrength {
    /// Share of the stiffness of the meshed shank that the part really has: a bolt stretches with
    /// its stress area, and its mesh has the shank from head to nut.
    pub fn stiffness_share(&self) -> f64 {
        match self {
            NominalStrength::Bolt(shank) => shank.stress_area / shank.shank_area,
            NominalStrength::Unlimited | NominalStrength::Steel(_) => 1.0,
        }
    }
}

/// Design resistances of a bolt in its grip: limits of the forces in the sections of its shank.
#[derive(Clone, Debug, PartialEq)]
pub struct BoltLimits {
    /// Yield strength of a shank whose forces the limits hold: the shank carries either resistance
    /// alone.
    pub shank: Design,
    /// Tension resistance \[N\].
    pub tension: f64,
    /// Shear resistance of a section between two plies \[N\].
    pub shear: f64,
    /// `c` of `V ≤ shear (1 − N/(c · tension))`.
    pub interaction: f64,
    /// Resistance of the plies under head and nut against punching \[N\].
    pub punching: [f64; 2],
    /// Resistance of each ply against bearing \[N\], on the two axes across the bolt in rising
    /// order, for forces of the bolt on the ply in the negative and the positive direction. `None`
    /// where the design code has no rule.
    pub bearing: Vec<Option<[[f64; 2]; 2]>>,
}

/// The concrete under a base plate, as a design code has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearing {
    /// Bearing strength.
    pub strength: Design,
    /// Pressure per settlement \[N/mm³\]; `None`: it does not settle.
    pub stiffness: Option<f64>,
}

/// Design strengths of the materials and welds of an assembly, with which an analysis computes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DesignStrengths {
    /// Yield strength by the key of the material, for every material of the assembly; `None`: the
    /// material does not yield.
    pub materials: BTreeMap<String, Option<Design>>,
    /// Shear strength on the throat by the name of the weld, for every weld of the assembly.
    pub welds: BTreeMap<String, Design>,
    /// Yield strength of the parts with holes by their name, at most that of their material.
    pub perforated: BTreeMap<String, Design>,
    /// Resistances of the bolts by the name of their part, for every bolt of the assembly.
    pub bolts: BTreeMap<String, BoltLimits>,
    /// Concrete by the name of the support's face, for every support on concrete.
    pub ground: BTreeMap<String, Bearing>,
}
