//! The two programs of a pass behind one face: what a pass asks of either.

use crate::analysis::diagnosis;
use crate::certify::bracket::{LowerBound, UpperBound};
use crate::certify::certificate::{certify_displacement, certify_stress};
use crate::certify::fields::{DisplacementField, StressField};
use crate::math::vec3::V3;
use crate::model::loads::Loads;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::dofs::DofMap;
use crate::programs::{ConicProgram, Kinematic, Static};
use crate::recover::elastic::{self, RecoverError};
use crate::solve::{Patterns, Solution, SolveOptions};

/// Which of the two programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Program {
    /// Displacements: the upper bound.
    Kinematic,
    /// Stresses: the lower bound.
    Static,
}

impl Program {
    /// In the words of a report.
    pub fn name(self) -> &'static str {
        match self {
            Program::Kinematic => "kinematic",
            Program::Static => "static",
        }
    }

    /// The bound it gives of the potential energy.
    pub fn bound(self) -> &'static str {
        match self {
            Program::Kinematic => "upper",
            Program::Static => "lower",
        }
    }
}

/// The next of a sequence of programs that differ in the offsets of their rows.
pub(crate) struct Another {
    /// All offsets.
    pub offsets: Vec<f64>,
    /// How many were solved.
    pub number: usize,
    /// Largest change that the last of them brought, as a fraction.
    pub change: f64,
}

/// What a pass asks of a program.
pub(crate) trait DiscreteProgram<'a>: Sized + Send + Sync {
    /// The field its solution stands for, and the bound that follows.
    type Answer: Send;
    /// Which it is.
    const PROGRAM: Program;

    /// What its solve is asked for, of what the caller asks for.
    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        asked.clone()
    }
    /// Builds it.
    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError>;
    /// Its conic program.
    fn program(&self) -> &ConicProgram;
    /// Its unknowns.
    fn map(&self) -> &DofMap;
    /// The point that its solver measures the unknowns from; empty: zero.
    fn measured_from(&self, _: &AnalysisModel) -> Vec<f64> {
        Vec::new()
    }
    /// The rigid motions that only contact resists, in its unknowns.
    fn contact_modes(&self, model: &AnalysisModel) -> Vec<Vec<f64>>;
    /// What to solve after this optimal solution; `None`: it was the last.
    fn another(&self, _: &AnalysisModel, _: &Solution) -> Option<Another> {
        None
    }
    /// Field and certified bound of an optimal solution, the last of its sequence; `patterns`: what
    /// is known of the mesh's matrices.
    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError>;
    /// Displacements of points along a direction of its unknowns, each with its part.
    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)>;
    /// What moves along the direction of an unbounded solution, in words.
    fn mechanism(&self, model: &AnalysisModel, solution: &Solution) -> String {
        diagnosis::mechanism(model, self.motion(model, &solution.x))
    }
    /// Tets with a yield condition, where only some need one.
    fn yielding(&self) -> Option<usize> {
        None
    }
    /// The contact each cone belongs to: interfaces first, then contacts with the ground.
    fn contacts(&self) -> Vec<usize>;
    /// Why an infeasible program has no solution, in words.
    fn conflict(&self, model: &AnalysisModel, z: &[f64]) -> Option<String> {
        diagnosis::conflict(model, self.program(), &self.contacts(), z)
    }
}

impl<'a> DiscreteProgram<'a> for Kinematic {
    type Answer = (DisplacementField, UpperBound);
    const PROGRAM: Program = Program::Kinematic;

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Kinematic::new(model)
    }

    fn program(&self) -> &ConicProgram {
        &self.program
    }

    fn map(&self) -> &DofMap {
        &self.map
    }

    fn measured_from(&self, model: &AnalysisModel) -> Vec<f64> {
        self.closed(model)
    }

    fn contact_modes(&self, model: &AnalysisModel) -> Vec<Vec<f64>> {
        self.contact_modes(model).into_iter().map(|m| m.unknowns).collect()
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let field = elastic::displacement(model, self, solution, patterns)?;
        let bound = UpperBound::new(certify_displacement(model, &field), model.symmetry);
        Ok((field, bound))
    }

    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        let u = self.map.expand(x);
        model
            .node_parts()
            .into_iter()
            .enumerate()
            .map(|(n, p)| (p, [u[3 * n], u[3 * n + 1], u[3 * n + 2]]))
            .collect()
    }

    fn contacts(&self) -> Vec<usize> {
        self.points.iter().map(|p| p.contact).collect()
    }
}

impl<'a> DiscreteProgram<'a> for Static<'a> {
    type Answer = (StressField, LowerBound);
    const PROGRAM: Program = Program::Static;

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Static::new(model)
    }

    fn program(&self) -> &ConicProgram {
        &self.program
    }

    fn map(&self) -> &DofMap {
        &self.map
    }

    fn measured_from(&self, _: &AnalysisModel) -> Vec<f64> {
        self.closed()
    }

    fn contact_modes(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        self.contact_modes().into_iter().map(|m| m.unknowns).collect()
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let field = elastic::stress(self, solution, patterns)?;
        let bound = LowerBound::new(certify_stress(model, &field, Loads::ALL), model.symmetry);
        Ok((field, bound))
    }

    fn motion(&self, _: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        let v = self.map.expand(x);
        (0..v.len() / 9)
            .flat_map(|f| {
                let part = self.elements.part(f) as u32;
                let at = |p: usize| [v[9 * f + 3 * p], v[9 * f + 3 * p + 1], v[9 * f + 3 * p + 2]];
                [(part, at(0)), (part, at(1)), (part, at(2))]
            })
            .collect()
    }

    fn contacts(&self) -> Vec<usize> {
        self.vertices.iter().map(|v| v.contact).collect()
    }
}
