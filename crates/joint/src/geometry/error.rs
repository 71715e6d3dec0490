//! Faults of a joint's geometry found before meshing.

use bracket_base::diag::{Diagnostic, number};

/// Descriptions of two parts, with their identifiers.
pub type Pair = [String; 2];

/// A fault found in the geometry stage. Lengths in mm.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GeometryError {
    /// The material of two parts overlaps.
    #[error(
        "{} and {} overlap by {depth:.3} mm near {}, at most {limit} mm is allowed",
        pair[0],
        pair[1],
        point(at)
    )]
    Clash {
        /// The parts.
        pair: Pair,
        /// Depth of the overlap.
        depth: f64,
        /// Largest overlap allowed.
        limit: f64,
        /// A point in the overlap.
        at: [f64; 3],
    },
    /// Two parts nearly touch: no elements of good quality fit in the gap.
    #[error(
        "{} and {} are {gap:.3} mm apart: a gap must be 0 or at least {limit} mm",
        pair[0],
        pair[1]
    )]
    Sliver {
        /// The parts.
        pair: Pair,
        /// Width of the gap.
        gap: f64,
        /// Smallest gap allowed.
        limit: f64,
    },
    /// An interface is defined between parts that do not touch.
    #[error(
        "{} and {} must touch for their interface, but they are {gap:.3} mm apart",
        pair[0],
        pair[1]
    )]
    Apart {
        /// The parts.
        pair: Pair,
        /// Distance.
        gap: f64,
    },
    /// Two parts have too little clearance.
    #[error(
        "{} and {} are {distance:.1} mm apart, at least {min:.1} mm is needed ({reason})",
        pair[0],
        pair[1]
    )]
    Clearance {
        /// The parts.
        pair: Pair,
        /// Distance.
        distance: f64,
        /// Smallest distance allowed.
        min: f64,
        /// Reason for the clearance.
        reason: String,
    },
    /// A name that is not an identifier, occurs twice, or refers to nothing.
    #[error("{what}")]
    Name {
        /// Description of the fault.
        what: String,
    },
    /// A dimension that is not a positive, finite number.
    #[error("the {part} has {what} of {}, which must be a finite number above 0", number(*value))]
    Dimension {
        /// Description of the part.
        part: String,
        /// Name of the dimension.
        what: String,
        /// Its value.
        value: f64,
    },
}

impl GeometryError {
    /// Kind and size of a fault of two parts: faults with the same cause have one remedy.
    pub fn cause(&self) -> Option<String> {
        match self {
            Self::Clash { depth, .. } => Some(format!("overlap {depth:.3}")),
            Self::Sliver { gap, .. } => Some(format!("gap {gap:.3}")),
            Self::Apart { gap, .. } => Some(format!("apart {gap:.3}")),
            Self::Clearance { distance, min, reason, .. } => {
                Some(format!("clearance {distance:.1} {min:.1} {reason}"))
            }
            Self::Name { .. } | Self::Dimension { .. } => None,
        }
    }
}

fn point(p: &[f64; 3]) -> String {
    let [x, y, z] = p.map(|c| (c * 10.0).round() / 10.0 + 0.0);
    format!("x = {x}, y = {y}, z = {z} mm")
}

impl From<GeometryError> for Diagnostic {
    fn from(error: GeometryError) -> Self {
        use GeometryError as E;
        let (code, help) = match &error {
            E::Clash { .. } => {
                ("geometry/clash", "move one of them, or choose a smaller bolt or a larger spacing")
            }
            E::Sliver { .. } => ("geometry/gap", "let them touch, or leave at least 1 mm"),
            E::Apart { .. } => {
                ("geometry/apart", "move the parts together, or remove this contact")
            }
            E::Clearance { .. } => {
                ("geometry/clearance", "move them apart, or choose a smaller bolt")
            }
            E::Name { .. } => {
                ("geometry/name", "names are capital letters, digits and `_`, and are used once")
            }
            E::Dimension { .. } => ("geometry/dimension", "check the dimensions of this part"),
        };
        Diagnostic::input(code, error.to_string()).help(help)
    }
}
