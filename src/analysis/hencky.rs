//! A pass of elastic, perfectly plastic analysis (Hencky): both programs on one mesh, yield
//! conditions only where they are needed.
//!
//! An elastic solution tells where the stress can reach yield; there, with some margin, the tets
//! get yield conditions (flow, in the kinematic program), the others stay elastic and cost nothing.
//! The solution tells which of those are beyond yield all the same; they join, and it is solved
//! again until none is. The static field is then admissible at every point and optimal among all
//! fields of the mesh; the kinematic one is admissible whatever flows.
//!
//! Under Coulomb's law each of the kinematic solves is a fixed point as in elastic analysis, which
//! starts from the slips of the one before; the static program then solves the last of these
//! problems.

use crate::analysis::coulomb::{Slid, Slips};
use crate::analysis::diagnosis;
use crate::analysis::engine::{
    Both, Event, Pass, PassError, PassOptions, ProgramRun, Progress, both_of,
};
use crate::analysis::program_run::{Another, DiscreteProgram, Program};
use crate::certify::bracket::{LowerBound, UpperBound};
use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::limit_certificate::hidden_utilisation;
use crate::certify::plastic_certificate::{
    certify_plastic_motion, certify_yielding_stress, dissipation, trial_utilisations, utilisations,
};
use crate::certify::plastic_field::PlasticField;
use crate::elements::hencky_kinematic::Flow;
use crate::elements::hencky_static::YIELD_POINTS;
use crate::elements::yielding_element::YIELD_ROWS;
use crate::math::vec3::V3;
use crate::mesh::numbering::FaceNumbering;
use crate::model::file::Bounds;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::dofs::DofMap;
use crate::programs::{ConicProgram, Kinematic, Static};
use crate::recover::elastic::RecoverError;
use crate::recover::plastic::{approximate_stress, plastic_motion, yielding_stress};
use crate::solve::{Patterns, Solution, SolveOptions, SolveStatus};
use std::time::Instant;

/// Accuracy of an elastic solution that only tells where yield conditions go: relative gap and
/// residual.
const ROUGH: [f64; 2] = [2e-2, 5e-3];
/// Relative gap at which a solve ends.
pub const GAP: f64 = 1e-7;
/// Residual at which it ends: fields are made admissible all the same.
const RESIDUAL: f64 = 1e-7;
/// Residual of a stress in equilibrium to rounding, and how many times what it may hide is left as
/// room: measured, what bringing a solution into equilibrium adds to the largest utilisation is
/// about ten times that on a joint of 7 000 tets.
const ROUNDING: f64 = 2e-13;
const CORRECTION: f64 = 30.0;
/// Room that is left before any stress has asked for it, at most.
const MOST_FIRST: f64 = 1e-4;
/// Utilisation by the elastic stress from which on a tet has a yield condition, and that from which
/// on those that share a face with it have one too: what a tet loses by yielding its neighbours
/// take over.
const FIRST: f64 = 0.6;
const AROUND: f64 = 0.9;
/// Utilisation from which on tets join, when some are found beyond yield, solve after solve; then
/// all.
const LATER: [f64; 4] = [0.8, 0.7, 0.5, 0.3];
/// Room under the yield surface that the program leaves for bringing its stress into equilibrium,
/// relative: the first that is tried, and the last.
const ROOM: [f64; 2] = [2e-7, 1e-3];
/// Dissipation, relative to the energy, of tets without flow in the program that is not worth
/// another solve.
const WORTH: f64 = 1e-6;

/// The kinematic program.
struct HenckyKinematic {
    kinematic: Kinematic,
    rough: bool,
    /// Under Coulomb's law.
    slips: Option<Slips>,
}

/// What it leaves.
struct Moved {
    field: PlasticField,
    /// Under Coulomb's law.
    slid: Option<Slid>,
}

/// The static program.
struct HenckyStatic<'a> {
    statics: Static<'a>,
    rough: bool,
}

/// What a solve leaves of a field `F` and its bound `B`.
struct Found<F, B> {
    /// `None` of a rough solve.
    certified: Option<(F, B)>,
    /// Utilisation of every tet.
    used: Vec<f64>,
    /// What the tets without flow in the program dissipate, over the energy.
    beyond: f64,
    /// Room under the yield surface that a stress in equilibrium will ask for.
    room: f64,
}

/// One program from solve to solve.
struct Side<A> {
    /// Tets with a yield condition.
    yields: Vec<bool>,
    /// An elastic solution with little accuracy, to begin with.
    rough: bool,
    /// Room under the yield surface.
    room: f64,
    /// All solves so far.
    run: Option<ProgramRun>,
    /// The last certified field and bound.
    answer: Option<A>,
    /// Nothing is left to do.
    done: bool,
}

impl<A> Side<A> {
    fn new(model: &AnalysisModel, asked: bool) -> Self {
        let yields = vec![false; model.mesh.tets.len()];
        Self { yields, rough: true, room: ROOM[0], run: None, answer: None, done: !asked }
    }

    fn count(&self) -> usize {
        self.yields.iter().filter(|y| **y).count()
    }

    /// Adds what another solve took.
    fn add_run(&mut self, run: ProgramRun) {
        let Some(earlier) = self.run.take() else {
            self.run = Some(run);
            return;
        };
        let mut trace = earlier.trace;
        trace.extend(run.trace);
        self.run = Some(ProgramRun {
            iterations: earlier.iterations + run.iterations,
            assembly_seconds: earlier.assembly_seconds + run.assembly_seconds,
            solve_seconds: earlier.solve_seconds + run.solve_seconds,
            certify_seconds: earlier.certify_seconds + run.certify_seconds,
            rounds: earlier.rounds + 1,
            trace,
            ..run
        });
    }

    /// Tets used from a threshold on join, and neighbours of those near yield; the threshold falls
    /// with every solve.
    fn grow(&mut self, model: &AnalysisModel, used: &[f64]) {
        let rounds = self.run.as_ref().map_or(0, |r| r.rounds as usize);
        let least = match self.count() {
            0 => FIRST,
            _ => LATER.get(rounds.saturating_sub(2)).copied().unwrap_or(0.0),
        };
        let mut joins: Vec<bool> = used.iter().map(|u| *u >= least).collect();
        for &(a, b) in &FaceNumbering::new(&model.mesh).tets {
            let Some(b) = b else { continue };
            let (a, b) = (a as usize, b as usize);
            joins[a] |= used[b] >= AROUND;
            joins[b] |= used[a] >= AROUND;
        }
        let radii = model.yield_radii();
        for (e, yields) in self.yields.iter_mut().enumerate() {
            *yields |= joins[e] && radii[model.mesh.tet_body[e] as usize].is_some();
        }
    }

    /// What follows from a solve that ended without a field.
    fn without_field(&mut self, status: SolveStatus) {
        use SolveStatus::{Interrupted, TimeLimit, TooLarge};
        // little accuracy may have been the reason
        self.done = !std::mem::take(&mut self.rough)
            || matches!(status, Interrupted | TimeLimit | TooLarge);
    }
}

type Motion = Side<(Moved, UpperBound)>;
type Stress = Side<(StressField, LowerBound)>;

/// Runs both programs; under Coulomb's law one after the other, the static one with the shift of
/// the kinematic one.
pub fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<Pass, PassError> {
    let start = Instant::now();
    let slides = model.has_coulomb_friction();
    let mut kinematic = Side::new(model, slides || model.bounds != Bounds::Static);
    let mut statics = Side::new(model, !slides && model.bounds != Bounds::Kinematic);
    solve(model, options, progress, start, &mut kinematic, &mut statics)?;
    let Some(slid) = kinematic.answer.as_ref().and_then(|(moved, _)| moved.slid.clone()) else {
        return pass(model, kinematic, statics);
    };
    let shifted = slid.shifted(model);
    if model.bounds != Bounds::Kinematic {
        statics = Side::new(model, true);
        solve(&shifted, options, progress, start, &mut kinematic, &mut statics)?;
    }
    let pass = pass(&shifted, kinematic, statics)?;
    Ok(Pass { fixed_point: Some(slid.run), shift: slid.shift, ..pass })
}

/// Solves until both sides are done.
fn solve(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
    start: Instant,
    kinematic: &mut Motion,
    statics: &mut Stress,
) -> Result<(), PassError> {
    while !(kinematic.done && statics.done) {
        let mut options = options.clone();
        options.solve.time_limit =
            (options.solve.time_limit - start.elapsed().as_secs_f64()).max(0.0);
        for (program, tets, done) in [
            (Program::Kinematic, kinematic.count(), kinematic.done),
            (Program::Static, statics.count(), statics.done),
        ] {
            if tets > 0 && !done {
                progress(program, Event::Yielding { tets });
            }
        }
        let (k, s): Both<_, _> = both_of(
            model,
            &options,
            progress,
            (!kinematic.done).then_some(|| {
                let slid = kinematic.answer.as_ref().and_then(|(moved, _)| moved.slid.as_ref());
                HenckyKinematic::new(model, &kinematic.yields, kinematic.rough, slid)
            }),
            (!statics.done).then_some(|| {
                HenckyStatic::new(model, &statics.yields, statics.room, statics.rough)
            }),
        )?;
        if let Some(k) = k {
            after_motion(model, kinematic, k.run, k.answer);
        }
        if let Some(s) = s {
            after_stress(model, statics, s.run, s.answer);
        }
    }
    Ok(())
}

/// Takes a kinematic solve in.
fn after_motion(
    model: &AnalysisModel,
    side: &mut Motion,
    run: ProgramRun,
    found: Option<Found<Moved, UpperBound>>,
) {
    let Some(found) = found else {
        side.without_field(run.status);
        // a bound that stands needs no better one
        if side.answer.is_none() || run.status == SolveStatus::Unbounded {
            side.add_run(run);
            side.answer = None;
        }
        return;
    };
    side.add_run(run);
    side.rough = false;
    side.done = found.certified.is_some() && found.beyond <= WORTH;
    if found.certified.is_some() {
        side.answer = found.certified;
    }
    if !side.done {
        side.grow(model, &found.used);
    }
}

/// Takes a static solve in.
fn after_stress(
    model: &AnalysisModel,
    side: &mut Stress,
    run: ProgramRun,
    found: Option<Found<StressField, LowerBound>>,
) {
    let Some(found) = found else {
        side.without_field(run.status);
        side.add_run(run);
        return;
    };
    side.add_run(run);
    side.rough = false;
    let Some((field, bound)) = found.certified else {
        side.room = side.room.max(found.room.min(MOST_FIRST));
        side.grow(model, &found.used);
        return;
    };
    let over = bound.certificate().yields.unwrap_or(0.0);
    let outside =
        side.yields.iter().zip(&found.used).any(|(y, u)| !y && *u > 1.0 - 2.0 * side.room);
    if over <= 0.0 {
        side.answer = Some((field, bound));
        side.done = true;
    } else if !outside {
        // nothing to add: the room was too little for what the solver left
        side.room = (4.0 * side.room).max(4.0 * over);
        if side.room > ROOM[1] {
            side.done = true;
            let words = format!("its stress exceeds the yield strength by {over:.1e} of it");
            side.run.iter_mut().for_each(|r| r.trouble = Some(words.clone()));
        }
        return;
    }
    if !side.done {
        side.grow(model, &found.used);
    }
}

/// Joins what both programs have left.
fn pass(model: &AnalysisModel, kinematic: Motion, statics: Stress) -> Result<Pass, PassError> {
    let mut pass = Pass { kinematic: kinematic.run, statics: statics.run, ..Pass::default() };
    if let Some((Moved { field, .. }, bound)) = kinematic.answer {
        pass.displacement = Some(field.nodes.clone());
        pass.plastic = Some(field);
        pass.upper = Some(bound);
    }
    if let Some((field, bound)) = statics.answer {
        pass.stress = Some(field);
        pass.lower = Some(bound);
    }
    pass.join(model)?;
    Ok(pass)
}

/// Which bodies flow along an unbounded direction, and where the parts move; `own`: where each
/// element's own unknowns start, `points`: how many yield points it has then.
fn collapse(
    model: &AnalysisModel,
    own: &[usize],
    points: impl Fn(usize) -> usize,
    multipliers: &[f64],
    motion: String,
) -> String {
    let mut flow = vec![0.0; model.mesh.bodies.len()];
    // those of welds come behind
    let tets = model.mesh.tets.len();
    let mut dissipated = multipliers.chunks_exact(YIELD_ROWS).map(|z| z[0].max(0.0));
    for (e, _) in own.windows(2).take(tets).enumerate().filter(|(_, o)| o[1] > o[0]) {
        flow[model.mesh.tet_body[e] as usize] += dissipated.by_ref().take(points(e)).sum::<f64>();
    }
    match diagnosis::plastic_flow(model, &flow) {
        Some(flows) => format!("{flows}; {motion}"),
        None => motion,
    }
}

/// Relative gap and residual of a solve: elastic ones are those of the elastic analysis.
fn accuracy(rough: bool, yielding: Option<usize>, asked: &SolveOptions) -> SolveOptions {
    let [gap, residual] = match yielding {
        _ if rough => ROUGH,
        Some(0) => [0.0; 2],
        _ => [GAP, RESIDUAL],
    };
    SolveOptions {
        gap: asked.gap.max(gap),
        residual: asked.residual.max(residual),
        ..asked.clone()
    }
}

/// Tets that have unknowns of their own; those of weld faces come behind.
fn with_own(own: &[usize], tets: usize) -> usize {
    own.windows(2).take(tets).filter(|o| o[1] > o[0]).count()
}

impl HenckyKinematic {
    /// `slid`: what the solve before has left under Coulomb's law.
    fn new(
        model: &AnalysisModel,
        flows: &[bool],
        rough: bool,
        slid: Option<&Slid>,
    ) -> Result<Self, ModelError> {
        let flow: Vec<Option<Flow>> = flows.iter().map(|f| f.then_some(Flow::Split)).collect();
        let mut kinematic = Kinematic::with_plasticity_in(model, &flow)?;
        let slips = model.has_coulomb_friction().then(|| Slips::new(&kinematic, slid));
        if let Some(slips) = &slips {
            kinematic.program.h = slips.offsets();
        }
        // without cones a solve is one of linear equations
        let rough = rough && !kinematic.program.cones.is_empty();
        Ok(Self { kinematic, rough, slips })
    }
}

impl<'a> DiscreteProgram<'a> for HenckyKinematic {
    type Answer = Found<Moved, UpperBound>;
    const PROGRAM: Program = Program::Kinematic;

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Self::new(model, &vec![true; model.mesh.tets.len()], false, None)
    }

    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        accuracy(self.rough, self.yielding(), asked)
    }

    fn program(&self) -> &ConicProgram {
        &self.kinematic.program
    }

    fn map(&self) -> &DofMap {
        &self.kinematic.map
    }

    fn contact_modes(&self, model: &AnalysisModel) -> Vec<Vec<f64>> {
        self.kinematic.contact_modes(model).into_iter().map(|m| m.unknowns).collect()
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        if self.rough {
            let u = self.kinematic.nodal(&solution.x);
            let field = PlasticField::elastic(DisplacementField { u }, model.mesh.tets.len());
            return Ok(Found {
                certified: None,
                used: trial_utilisations(model, &field),
                beyond: f64::INFINITY,
                room: 0.0,
            });
        }
        let slips = self.slips.as_ref();
        let slid = slips.map(|s| s.found(model, &self.kinematic)).transpose()?;
        let shifted = slid.as_ref().map(|s| s.shifted(model));
        let model = shifted.as_ref().unwrap_or(model);
        let offsets = slips.map_or_else(|| self.kinematic.program.h.clone(), Slips::offsets);
        let field = plastic_motion(model, &self.kinematic, &offsets, solution, patterns)?;
        let bound = UpperBound::new(certify_plastic_motion(model, &field), model.symmetry);
        let own = &self.kinematic.own;
        let outside = |e: usize| own.get(e..e + 2).is_none_or(|o| o[1] == o[0]);
        let beyond = dissipation(model, &field, outside)
            / bound.certificate().energy.abs().max(f64::MIN_POSITIVE);
        let used = trial_utilisations(model, &field);
        Ok(Found { certified: Some((Moved { field, slid }, bound)), used, beyond, room: 0.0 })
    }

    fn another(&self, model: &AnalysisModel, solution: &Solution) -> Option<Another> {
        // where yield conditions go needs no shift
        let slips = self.slips.as_ref().filter(|_| !self.rough)?;
        slips.another(model, &self.kinematic, solution)
    }

    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        DiscreteProgram::motion(&self.kinematic, model, x)
    }

    fn mechanism(&self, model: &AnalysisModel, solution: &Solution) -> String {
        let k = &self.kinematic;
        let points = |e: usize| if k.split[e] { 16 } else { 4 };
        let rest = solution.z.get(k.program.g.nrows()..).unwrap_or_default();
        collapse(
            model,
            &k.own,
            points,
            rest,
            diagnosis::mechanism(model, self.motion(model, &solution.x)),
        )
    }

    fn yielding(&self) -> Option<usize> {
        Some(with_own(&self.kinematic.own, self.kinematic.split.len()))
    }

    fn contacts(&self) -> Vec<usize> {
        DiscreteProgram::contacts(&self.kinematic)
    }
}

impl<'a> HenckyStatic<'a> {
    fn new(
        model: &'a AnalysisModel,
        yields: &[bool],
        room: f64,
        rough: bool,
    ) -> Result<Self, ModelError> {
        let statics = Static::with_plasticity_in(model, yields, room)?;
        let rough = rough && !statics.program.cones.is_empty();
        Ok(Self { statics, rough })
    }
}

impl<'a> DiscreteProgram<'a> for HenckyStatic<'a> {
    type Answer = Found<StressField, LowerBound>;
    const PROGRAM: Program = Program::Static;

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Self::new(model, &vec![true; model.mesh.tets.len()], ROOM[0], false)
    }

    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        accuracy(self.rough, self.yielding(), asked)
    }

    fn program(&self) -> &ConicProgram {
        &self.statics.program
    }

    fn map(&self) -> &DofMap {
        &self.statics.map
    }

    fn contact_modes(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        self.statics.contact_modes().into_iter().map(|m| m.unknowns).collect()
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        if self.rough {
            let field = approximate_stress(&self.statics, solution)?;
            let used = utilisations(model, &field);
            let room = CORRECTION * hidden_utilisation(model, &field, ROUNDING);
            return Ok(Found { certified: None, used, beyond: f64::INFINITY, room });
        }
        let field = yielding_stress(model, &self.statics, solution, patterns)?;
        let bound = LowerBound::new(certify_yielding_stress(model, &field), model.symmetry);
        let used = utilisations(model, &field);
        Ok(Found { certified: Some((field, bound)), used, beyond: 0.0, room: 0.0 })
    }

    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        DiscreteProgram::motion(&self.statics, model, x)
    }

    fn mechanism(&self, model: &AnalysisModel, solution: &Solution) -> String {
        let s = &self.statics;
        let rest = solution.z.get(s.program.g.nrows()..).unwrap_or_default();
        let motion = diagnosis::mechanism(model, self.motion(model, &solution.x));
        collapse(model, &s.own, |_| YIELD_POINTS, rest, motion)
    }

    fn yielding(&self) -> Option<usize> {
        Some(with_own(&self.statics.own, self.statics.elements.model().mesh.tets.len()))
    }

    fn contacts(&self) -> Vec<usize> {
        DiscreteProgram::contacts(&self.statics)
    }
}
