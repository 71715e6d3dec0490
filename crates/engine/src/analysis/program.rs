//! The two dual programs of an analysis.

/// One of the two dual programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Program {
    /// Displacements: the upper bound.
    Kinematic,
    /// Stresses: the lower bound.
    Static,
}

impl Program {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Program::Kinematic => "kinematic",
            Program::Static => "static",
        }
    }

    /// The bound of the potential energy that it gives.
    pub fn bound(self) -> &'static str {
        match self {
            Program::Kinematic => "upper",
            Program::Static => "lower",
        }
    }
}
