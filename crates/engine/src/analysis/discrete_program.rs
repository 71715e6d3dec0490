//! The interface between the engine and the programs it solves.
//!
//! [`BaseProgram`] is one of the two dual programs after assembly: [`Kinematic`] or [`Static`].
//! [`DiscreteProgram`] is a problem that such a program solves: what the solver aims at, which
//! problem follows a solution, and which field and bound the solution gives.

use crate::analysis::diagnosis;
use crate::analysis::program::Program;
use crate::certify::bracket::{LowerBound, UpperBound};
use crate::certify::certificate::{certify_displacement, certify_stress};
use crate::certify::fields::{DisplacementField, StressField};
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use crate::programs::dofs::DofMap;
use crate::programs::{ConicProgram, Kinematic, Static};
use crate::recover::elastic::{self, RecoverError};
use crate::recover::moving_parts::mechanism;
use crate::solve::{Patterns, Solution, SolveOptions};
use bracket_base::math::vec3::V3;
use bracket_base::words::Text;

/// The next of a sequence of problems that differ in the offsets of their rows.
pub(crate) struct NextProblem {
    /// Offsets of all rows.
    pub offsets: Vec<f64>,
    /// Problems solved so far.
    pub solves: usize,
    /// Largest change in the last of them, as a fraction.
    pub change: f64,
}

/// One of the two programs after assembly.
pub(crate) trait BaseProgram: Send + Sync {
    /// Which of the two it is.
    const PROGRAM: Program;

    /// The conic program.
    fn conic(&self) -> &ConicProgram;
    /// Its unknowns.
    fn map(&self) -> &DofMap;
    /// Unknowns that close the frozen cuts of preloaded bolts with little strain; empty where there
    /// are no cuts.
    fn closed_cuts(&self, model: &AnalysisModel) -> Vec<f64>;
    /// Its unknowns in the rigid motions that only contact resists.
    fn mode_vectors(&self, model: &AnalysisModel) -> Vec<Vec<f64>>;
    /// Displacements of points, each with its part, along the direction `x` of the unknowns.
    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)>;
    /// Index of the contact that each cone belongs to: interfaces first, then contacts with the
    /// ground.
    fn cone_contacts(&self) -> Vec<usize>;
}

/// A problem that the engine solves with one of the two programs.
pub(crate) trait DiscreteProgram: Sized + Send + Sync {
    /// The program that it solves.
    type Base: BaseProgram;
    /// The certified field of a solution with its bound.
    type Answer: Send;
    /// Which of the two programs it solves.
    const PROGRAM: Program = Self::Base::PROGRAM;

    /// The program that it solves.
    fn base(&self) -> &Self::Base;
    /// Options of its solve, derived from those of the user.
    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        asked.clone()
    }
    /// The point from which the solver measures the unknowns; empty: zero.
    fn origin(&self, _: &AnalysisModel) -> Vec<f64> {
        Vec::new()
    }
    /// The rigid motions that make the problem unbounded if contact does not stop them.
    fn contact_modes(&self, model: &AnalysisModel) -> Vec<Vec<f64>> {
        self.base().mode_vectors(model)
    }
    /// The problem to solve after this optimal solution; `None`: the solution is the last one.
    fn next_problem(&self, _: &AnalysisModel, _: &Solution) -> Option<NextProblem> {
        None
    }
    /// Field and certified bound of the last optimal solution; `patterns`: the known sparsity
    /// patterns of the mesh's matrices.
    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError>;
    /// The parts that move along the direction of an unbounded solution.
    fn mechanism(&self, model: &AnalysisModel, solution: &Solution) -> Text {
        mechanism(model, self.base().motion(model, &solution.x))
    }
    /// Number of tets with a yield condition, where only part of the tets may have one.
    fn yielding(&self) -> Option<usize> {
        None
    }
    /// Why the infeasible problem with the certificate `z` has no solution.
    fn conflict(&self, model: &AnalysisModel, z: &[f64]) -> Option<Text> {
        let base = self.base();
        diagnosis::conflict(model, base.conic(), &base.cone_contacts(), z)
    }
}

impl BaseProgram for Kinematic {
    const PROGRAM: Program = Program::Kinematic;

    fn conic(&self) -> &ConicProgram {
        &self.program
    }

    fn map(&self) -> &DofMap {
        &self.map
    }

    fn closed_cuts(&self, model: &AnalysisModel) -> Vec<f64> {
        self.closed(model)
    }

    fn mode_vectors(&self, model: &AnalysisModel) -> Vec<Vec<f64>> {
        self.contact_modes(model).into_iter().map(|m| m.unknowns).collect()
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

    fn cone_contacts(&self) -> Vec<usize> {
        self.points.iter().map(|p| p.contact).collect()
    }
}

impl BaseProgram for Static<'_> {
    const PROGRAM: Program = Program::Static;

    fn conic(&self) -> &ConicProgram {
        &self.program
    }

    fn map(&self) -> &DofMap {
        &self.map
    }

    fn closed_cuts(&self, _: &AnalysisModel) -> Vec<f64> {
        self.closed()
    }

    fn mode_vectors(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        self.contact_modes().into_iter().map(|m| m.unknowns).collect()
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

    fn cone_contacts(&self) -> Vec<usize> {
        self.vertices.iter().map(|v| v.contact).collect()
    }
}

/// Elastic analysis.
impl DiscreteProgram for Kinematic {
    type Base = Self;
    type Answer = (DisplacementField, UpperBound);

    fn base(&self) -> &Self {
        self
    }

    fn origin(&self, model: &AnalysisModel) -> Vec<f64> {
        self.closed_cuts(model)
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
}

/// Elastic analysis.
impl DiscreteProgram for Static<'_> {
    type Base = Self;
    type Answer = (StressField, LowerBound);

    fn base(&self) -> &Self {
        self
    }

    fn origin(&self, model: &AnalysisModel) -> Vec<f64> {
        self.closed_cuts(model)
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
}
