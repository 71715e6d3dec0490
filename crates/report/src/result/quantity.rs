//! The bracketed quantity, the problem it belongs to, and the numbers of a bracket in the form of
//! `result.json`.

use serde::{Deserialize, Serialize};

/// The quantity that `lower` and `upper` bracket.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Potential energy of the whole structure at equilibrium \[N mm\], negative under load.
    PotentialEnergy,
    /// Factor on the loads at collapse.
    LoadFactor,
}

/// The problem whose solution the bracket contains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FrictionModel {
    /// No friction anywhere, or no contact at all.
    Frictionless,
    /// Associated friction: slip dilates.
    Associated,
    /// Coulomb friction.
    Coulomb,
    /// The last problem of the fixed point for Coulomb friction: its cones are shifted by the slip
    /// of the previous problem.
    ShiftedCones,
}

/// An upper bound: a number, or the word `unbounded`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Upper {
    /// A finite bound.
    Finite(f64),
    /// The loads can grow without limit.
    Unbounded(Unbounded),
}

/// The word `unbounded`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Unbounded {
    /// The word itself.
    Unbounded,
}

impl Upper {
    /// The loads can grow without limit.
    pub const UNBOUNDED: Self = Upper::Unbounded(Unbounded::Unbounded);

    /// The bound, if it is finite.
    pub fn finite(self) -> Option<f64> {
        match self {
            Upper::Finite(x) => Some(x),
            Upper::Unbounded(_) => None,
        }
    }
}

impl From<f64> for Upper {
    fn from(x: f64) -> Self {
        Upper::Finite(x)
    }
}

/// A raw bracket beside the main one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RawBracket {
    /// Lower bound, unit of the case's quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper bound, unit of the case's quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<Upper>,
}

/// Magnitude of a load at load factor 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LoadSize {
    /// A force \[N\].
    Force(f64),
    /// A moment \[N mm\].
    Moment(f64),
}

impl LoadSize {
    /// Its value \[N\] or \[N mm\].
    pub fn value(self) -> f64 {
        match self {
            LoadSize::Force(v) | LoadSize::Moment(v) => v,
        }
    }

    /// The load times a factor.
    pub fn times(self, factor: f64) -> Self {
        match self {
            LoadSize::Force(v) => LoadSize::Force(factor * v),
            LoadSize::Moment(v) => LoadSize::Moment(factor * v),
        }
    }
}
