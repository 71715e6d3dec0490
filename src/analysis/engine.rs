//! One pass: both programs on one mesh, their fields, certificates and bracket.

use crate::analysis::coulomb::{self, FixedPointRun};
use crate::analysis::memory::{Limit, Room, RoomSource, plan, room};
use crate::analysis::preload::{self, Tightened};
use crate::analysis::program_run::{DiscreteProgram, Program};
use crate::certify::PlasticField;
use crate::certify::bracket::{Bracket, Contradiction, LowerBound, UpperBound};
use crate::certify::contributions::{Contributions, contributions, plastic_contributions};
use crate::certify::fields::{DisplacementField, StressField};
use crate::math::dense::sequential_kernels;
use crate::model::file::Bounds;
use crate::model::opening::ConeShift;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::{ConicProgram, Kinematic, Static};
use crate::recover::elastic::RecoverError;
use crate::solve::status::Iterations;
use crate::solve::{
    self, Forecast, Iteration, Prepared, Solution, SolveOptions, SolveStatus, collapse, pages,
};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Limits of a pass.
#[derive(Clone)]
pub struct PassOptions {
    /// Of each solve; the time limit counts from the start of the pass.
    pub solve: SolveOptions,
    /// The memory there is for solves.
    pub room: RoomSource,
}

impl Default for PassOptions {
    /// Both programs, as the machine's memory allows.
    fn default() -> Self {
        Self { solve: SolveOptions::default(), room: Arc::new(|| room(None)) }
    }
}

/// Why a program was not started.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// Memory its solve needs \[bytes\].
    pub needed: u64,
    /// The memory there was.
    pub room: Room,
}

/// How one program went.
#[derive(Clone, Debug)]
pub struct ProgramRun {
    /// How the solve ended.
    pub status: SolveStatus,
    /// Iterations.
    pub iterations: u32,
    /// Unknowns.
    pub dofs: usize,
    /// Contact cones.
    pub cones: usize,
    /// Time to assemble \[s\].
    pub assembly_seconds: f64,
    /// Time to order and solve \[s\].
    pub solve_seconds: f64,
    /// Time to recover and certify the field \[s\].
    pub certify_seconds: f64,
    /// What the solve was expected to cost, where that could be told.
    pub forecast: Option<Forecast>,
    /// Every iteration, seconds counted from the start of the solve. Numbers begin again where
    /// another solver took over or another problem of a sequence began.
    pub trace: Vec<Iteration>,
    /// For a program too large for the memory: how much it lacks.
    pub refusal: Option<Refusal>,
    /// Tets with a yield condition in the last of its solves, in an elastic, perfectly plastic
    /// analysis.
    pub yielding: Option<usize>,
    /// Solves that led here.
    pub rounds: u32,
    /// For an unbounded program: which parts move, in words.
    pub mechanism: Option<String>,
    /// For an infeasible program: which contacts exclude each other, in words.
    pub conflict: Option<String>,
    /// Why no field could be certified although the solve ended well.
    pub trouble: Option<String>,
}

/// What a pass leaves.
#[derive(Clone, Debug, Default)]
pub struct Pass {
    /// The kinematic program.
    pub kinematic: Option<ProgramRun>,
    /// The static program.
    pub statics: Option<ProgramRun>,
    /// Displacements of an optimal kinematic program.
    pub displacement: Option<DisplacementField>,
    /// The same with plastic strain, in an elastic, perfectly plastic analysis.
    pub plastic: Option<PlasticField>,
    /// Stresses of an optimal static program.
    pub stress: Option<StressField>,
    /// The upper bound.
    pub upper: Option<UpperBound>,
    /// The lower bound.
    pub lower: Option<LowerBound>,
    /// Both.
    pub bracket: Option<Bracket>,
    /// Contributions to the gap of the meshed part, when both fields exist.
    pub contributions: Option<Contributions>,
    /// The preloaded bolts, their cuts frozen.
    pub preload: Vec<Tightened>,
    /// Coulomb friction: how its fixed point went.
    pub fixed_point: Option<FixedPointRun>,
    /// Coulomb friction: the shift of the contact cones in the problem that the bounds belong to.
    pub shift: ConeShift,
}

/// Why a pass could not run, or contradicts itself.
#[derive(Debug, thiserror::Error)]
pub enum PassError {
    /// A program could not be built.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The two bounds contradict each other.
    #[error(transparent)]
    Contradiction(#[from] Contradiction),
    /// The contributions of elements and contacts do not add up to the gap: the two certificates do
    /// not fit together.
    #[error("the contributions to the gap sum to {sum:.9e}, the bounds differ by {gap:.9e}")]
    Identity {
        /// The upper bound less the lower one, of the meshed part.
        gap: f64,
        /// Sum of the contributions.
        sum: f64,
    },
}

impl From<PassError> for crate::diag::Diagnostic {
    fn from(e: PassError) -> Self {
        match e {
            PassError::Model(e) => e.into(),
            e => crate::diag::Diagnostic::undecided("bounds/contradiction", e.to_string()).help(
                "the numbers are withheld; try another mesh or `--solver clarabel`, and report \
                 the case",
            ),
        }
    }
}

/// What a program tells while it runs.
#[derive(Clone, Copy, Debug)]
pub enum Event<'a> {
    /// It is being assembled.
    Assembly,
    /// It is assembled and ordered.
    Forecast {
        /// Unknowns.
        unknowns: usize,
        /// What the solve will cost; `None` where nobody can tell.
        forecast: Option<&'a Forecast>,
    },
    /// It waits until the other one has ended: side by side they do not fit.
    Waits {
        /// Memory that both need side by side \[bytes\].
        needed: u64,
        /// The memory there is.
        room: Room,
    },
    /// It does not fit and is not started, though the other one is.
    Refused(&'a Refusal),
    /// Its solve begins.
    Solve {
        /// What it will cost; `None` where nobody can tell.
        forecast: Option<&'a Forecast>,
    },
    /// The solver's next iterate.
    Iteration(&'a Iteration),
    /// Preload: before the loads the bolts are tightened, by both programs.
    Tightening,
    /// Coulomb friction: it is solved once more, its contact cones shifted by the slips so far.
    Slips {
        /// How many times it was solved.
        solves: usize,
        /// Largest change of the shift at the last of them, part of the largest shift.
        change: f64,
    },
    /// Its field is being recovered and certified.
    Certify,
    /// The static program of limit analysis is solved once more, every friction coefficient zero.
    Frictionless,
    /// Limit analysis: the fixed point for Coulomb's law begins.
    Coulomb,
    /// It is solved once more with a yield condition on so many tets.
    Yielding {
        /// Tets with a yield condition.
        tets: usize,
    },
    /// It is done with.
    Ended(&'a ProgramRun),
}

/// Told what each program does.
pub type Progress = Arc<dyn Fn(Program, Event<'_>) + Send + Sync>;

/// Tells nobody.
pub fn silent() -> Progress {
    Arc::new(|_, _| {})
}

/// What every program of a pass needs.
struct Context<'a> {
    model: &'a AnalysisModel,
    options: &'a PassOptions,
    progress: &'a Progress,
    start: Instant,
}

/// A program as its solver sees it.
struct Built<P> {
    problem: P,
    /// How long its assembly took \[s\].
    seconds: f64,
    /// The point that the solver measures its unknowns from, and the program in those; `None`:
    /// zero.
    moved: Option<(Vec<f64>, ConicProgram)>,
}

/// A program before its solve.
struct Job<'p, P> {
    problem: &'p P,
    /// The point that the solver measures its unknowns from; empty: zero.
    from: &'p [f64],
    /// `None`: the user interrupted before it was ordered.
    prepared: Option<Prepared<'p>>,
    run: ProgramRun,
}

/// A program after its solve: field and bound where both could be certified.
pub(crate) struct Done<A> {
    pub(crate) run: ProgramRun,
    pub(crate) answer: Option<A>,
}

/// What the plan says to a program.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Ticket {
    Start,
    /// In turn, if the machine still has so much memory then \[bytes\].
    StartIf(u64),
    Refused(Refusal),
}

/// The plan for both programs.
struct Turns {
    kinematic: Ticket,
    statics: Ticket,
    /// In turn, the smaller one first: a bound early is worth more than one late. `None`: side by
    /// side.
    first: Option<Program>,
}

/// Runs both programs: side by side where the memory allows it, else in turn; one that does not fit
/// is not started.
///
/// With Coulomb friction the kinematic program is solved a few times first, and both bounds are of
/// the problem with shifted contact cones that this ends with.
pub fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<Pass, PassError> {
    if model.preload.iter().any(|p| p.closure.is_none() && !p.faces.is_empty()) {
        return preload::tighten_and_run(model, options, progress);
    }
    if model.has_coulomb_friction() {
        return coulomb::run(model, options, progress);
    }
    let (kinematic, statics) = both::<Kinematic, Static>(model, options, progress)?;
    let mut pass = Pass::default();
    if let Some(k) = kinematic {
        pass.kinematic = Some(k.run);
        if let Some((field, bound)) = k.answer {
            pass.displacement = Some(field);
            pass.upper = Some(bound);
        }
    }
    pass.add_static(statics);
    pass.join(model)?;
    Ok(pass)
}

/// How both programs went; `None`: not asked for.
pub(crate) type Both<K, S> = (Option<Done<K>>, Option<Done<S>>);

/// Assembles, orders, solves and certifies both programs, as far as the memory allows.
pub(crate) fn both<'a, K: DiscreteProgram<'a>, S: DiscreteProgram<'a>>(
    model: &'a AnalysisModel,
    options: &'a PassOptions,
    progress: &'a Progress,
) -> Result<Both<K::Answer, S::Answer>, PassError> {
    let kinematic = (model.bounds != Bounds::Static).then_some(|| K::assemble(model));
    let statics = (model.bounds != Bounds::Kinematic).then_some(|| S::assemble(model));
    both_of(model, options, progress, kinematic, statics)
}

/// The same with programs assembled as told; `None`: not asked for.
pub(crate) fn both_of<'a, K: DiscreteProgram<'a>, S: DiscreteProgram<'a>>(
    model: &'a AnalysisModel,
    options: &'a PassOptions,
    progress: &'a Progress,
    kinematic: Option<impl FnOnce() -> Result<K, ModelError> + Send>,
    statics: Option<impl FnOnce() -> Result<S, ModelError> + Send>,
) -> Result<Both<K::Answer, S::Answer>, PassError> {
    sequential_kernels();
    let context = Context { model, options, progress, start: Instant::now() };
    let (kinematic, statics) = rayon::join(
        || kinematic.map(|build| context.assemble(build)).transpose(),
        || statics.map(|build| context.assemble(build)).transpose(),
    );
    let (kinematic, statics) = (kinematic?, statics?);
    let (k, s) = rayon::join(
        || kinematic.as_ref().map(|built| context.prepare(built)),
        || statics.as_ref().map(|built| context.prepare(built)),
    );
    let turns = context.turns(k.as_ref().map(|j| &j.run), s.as_ref().map(|j| &j.run));
    let kinematic = || k.map(|job| context.finish(job, turns.kinematic)).transpose();
    let statics = || s.map(|job| context.finish(job, turns.statics)).transpose();
    let (kinematic, statics) = match turns.first {
        None => rayon::join(kinematic, statics),
        Some(Program::Kinematic) => (kinematic(), statics()),
        Some(Program::Static) => {
            let s = statics();
            (kinematic(), s)
        }
    };
    Ok((kinematic?, statics?))
}

impl Pass {
    /// Takes in what the static program left.
    pub(crate) fn add_static(&mut self, statics: Option<Done<(StressField, LowerBound)>>) {
        let Some(s) = statics else { return };
        self.statics = Some(s.run);
        if let Some((field, bound)) = s.answer {
            self.stress = Some(field);
            self.lower = Some(bound);
        }
    }

    /// Joins the two bounds, and checks that the contributions to the gap add up to it.
    pub(crate) fn join(&mut self, model: &AnalysisModel) -> Result<(), PassError> {
        self.preload =
            preload::tightened(model, self.lower.as_ref().map(|l| &l.certificate().tensions[..]));
        if let (Some(l), Some(u)) = (&self.lower, &self.upper) {
            self.bracket = Some(Bracket::new(l.clone(), u.clone())?);
        }
        if let (Some(u), Some(s)) = (&self.displacement, &self.stress) {
            let c = match &self.plastic {
                Some(u) => plastic_contributions(model, u, s),
                None => contributions(model, u, s),
            };
            // asserted where both fields are admissible
            if let Some(b) = self.bracket.as_ref().filter(|b| b.is_strict()) {
                let copies = f64::from(model.symmetry);
                // with preload both energies may vanish
                let strain = b.lower().certificate().strain_energy.unwrap_or(0.0);
                check_identity(
                    [b.lower().value() / copies, b.upper().value() / copies],
                    strain,
                    c.total(),
                )?;
            }
            self.contributions = Some(c);
        }
        Ok(())
    }

    /// The programs that ran or were to run.
    pub fn runs(&self) -> impl Iterator<Item = (Program, &ProgramRun)> {
        runs(&self.kinematic, &self.statics)
    }
}

/// The programs that ran or were to run, each with its name.
pub(crate) fn runs<'a>(
    kinematic: &'a Option<ProgramRun>,
    statics: &'a Option<ProgramRun>,
) -> impl Iterator<Item = (Program, &'a ProgramRun)> {
    let kinematic = kinematic.iter().map(|r| (Program::Kinematic, r));
    kinematic.chain(statics.iter().map(|r| (Program::Static, r)))
}

impl<'a> Context<'a> {
    fn tell(&self, program: Program, event: Event<'_>) {
        (self.progress)(program, event);
    }

    fn assemble<P: DiscreteProgram<'a>>(
        &self,
        build: impl FnOnce() -> Result<P, ModelError>,
    ) -> Result<Built<P>, PassError> {
        let start = Instant::now();
        self.tell(P::PROGRAM, Event::Assembly);
        let problem = build()?;
        let from = problem.measured_from(self.model);
        let moved = (!from.is_empty()).then(|| {
            let program = problem.program().measured_from(&from);
            (from, program)
        });
        Ok(Built { problem, seconds: start.elapsed().as_secs_f64(), moved })
    }

    /// Orders a program and forecasts its cost.
    fn prepare<'p, P: DiscreteProgram<'a>>(&self, built: &'p Built<P>) -> Job<'p, P> {
        let start = Instant::now();
        let problem = &built.problem;
        let (from, program): (&[f64], _) = match &built.moved {
            Some((from, program)) => (from, program),
            None => (&[], problem.program()),
        };
        let map = problem.map();
        let options = &self.options.solve;
        let prepared =
            (!options.interrupted()).then(|| solve::prepare(program, &map.block, options));
        let forecast = prepared.as_ref().and_then(Prepared::forecast);
        let run = ProgramRun {
            status: SolveStatus::Interrupted,
            iterations: 0,
            dofs: map.n,
            cones: program.cones.len(),
            assembly_seconds: built.seconds,
            solve_seconds: start.elapsed().as_secs_f64(),
            certify_seconds: 0.0,
            forecast,
            trace: Vec::new(),
            refusal: None,
            yielding: problem.yielding(),
            rounds: 1,
            mechanism: None,
            conflict: None,
            trouble: None,
        };
        Job { problem, from, prepared, run }
    }

    /// Tells the forecasts and decides what starts when.
    fn turns(&self, kinematic: Option<&ProgramRun>, statics: Option<&ProgramRun>) -> Turns {
        let runs = [(Program::Kinematic, kinematic), (Program::Static, statics)];
        let mut turns = Turns { kinematic: Ticket::Start, statics: Ticket::Start, first: None };
        if self.options.solve.interrupted() {
            return turns;
        }
        for (program, run) in runs {
            let Some(run) = run else { continue };
            self.tell(
                program,
                Event::Forecast { unknowns: run.dofs, forecast: run.forecast.as_ref() },
            );
        }
        let Some(room) = (self.options.room)() else { return turns };
        let needs = runs.map(|(_, run)| run.and_then(|r| r.forecast).map_or(0, |f| f.bytes));
        let plan = plan(&needs, room.bytes);
        let any = (0..2).any(|i| runs[i].1.is_some() && plan.starts[i]);
        for (i, ticket) in [&mut turns.kinematic, &mut turns.statics].into_iter().enumerate() {
            if !plan.starts[i] {
                let refusal = Refusal { needed: needs[i], room };
                *ticket = Ticket::Refused(refusal);
                // where nothing starts the caller says so at once
                if any {
                    self.tell(runs[i].0, Event::Refused(&refusal));
                }
            }
        }
        if !plan.together {
            let (first, second) = if needs[0] <= needs[1] { (0, 1) } else { (1, 0) };
            let waits = if second == 0 { &mut turns.kinematic } else { &mut turns.statics };
            *waits = Ticket::StartIf(needs[second]);
            turns.first = Some(runs[first].0);
            self.tell(
                runs[second].0,
                Event::Waits { needed: needs[0].saturating_add(needs[1]), room },
            );
        }
        turns
    }

    /// Solves a program and certifies its field, as far as its ticket and the user let it.
    fn finish<P: DiscreteProgram<'a>>(
        &self,
        job: Job<'_, P>,
        ticket: Ticket,
    ) -> Result<Done<P::Answer>, PassError> {
        let Job { problem, from, prepared, mut run } = job;
        let refusal = match ticket {
            Ticket::Start => None,
            Ticket::Refused(refusal) => Some(refusal),
            // others may have taken memory meanwhile; what the user allows was counted by the plan,
            // and what this process still holds of the first program it will use again
            Ticket::StartIf(needed) => {
                let now = (self.options.room)().filter(|r| r.limit == Limit::Machine);
                let refusal = now.filter(|r| r.bytes < needed).map(|room| Refusal { needed, room });
                refusal.iter().for_each(|r| self.tell(P::PROGRAM, Event::Refused(r)));
                refusal
            }
        };
        let mut answer = None;
        if self.options.solve.interrupted() {
            run.status = SolveStatus::Interrupted;
        } else if let Some(refusal) = refusal {
            run.status = SolveStatus::TooLarge;
            run.refusal = Some(refusal);
        } else if let Some(prepared) = prepared {
            let solution = self.solve(problem, from, prepared, &mut run);
            let start = Instant::now();
            answer = self.judge(problem, &solution, &mut run)?;
            run.certify_seconds = start.elapsed().as_secs_f64();
        }
        self.tell(P::PROGRAM, Event::Ended(&run));
        Ok(Done { run, answer })
    }

    /// Solves a program, telling and keeping its iterations.
    fn solve<P: DiscreteProgram<'a>>(
        &self,
        problem: &P,
        from: &[f64],
        mut prepared: Prepared<'_>,
        run: &mut ProgramRun,
    ) -> Solution {
        self.tell(P::PROGRAM, Event::Solve { forecast: run.forecast.as_ref() });
        let start = Instant::now();
        let trace: Arc<Mutex<Vec<Iteration>>> = Arc::default();
        let (kept, told) = (trace.clone(), self.progress.clone());
        let tell: Iterations = Arc::new(move |i| {
            // one clock for all: a solver that takes over starts its own
            let i = Iteration { seconds: start.elapsed().as_secs_f64(), ..*i };
            kept.lock().unwrap_or_else(PoisonError::into_inner).push(i);
            told(P::PROGRAM, Event::Iteration(&i));
        });
        let given = &self.options.solve;
        let left = (given.time_limit - self.start.elapsed().as_secs_f64()).max(0.0);
        let mut options =
            SolveOptions { progress: Some(tell), time_limit: left, ..problem.accuracy(given) };
        let mut solution = moved_by(from, prepared.solve_first(&options));
        run.iterations = solution.iterations;
        let rows = if from.is_empty() { Vec::new() } else { problem.program().g.mul(from) };
        while solution.status == SolveStatus::Optimal
            && let Some(next) = problem.another(self.model, &solution)
        {
            self.tell(P::PROGRAM, Event::Slips { solves: next.number, change: next.change });
            options.time_limit = (left - start.elapsed().as_secs_f64()).max(0.0);
            let mut offsets = next.offsets;
            offsets.iter_mut().zip(&rows).for_each(|(h, moved)| *h += moved);
            solution = moved_by(from, prepared.solve_at(&offsets, &options));
            run.iterations += solution.iterations;
        }
        drop(prepared);
        pages::give_back();
        if stalled(solution.status) {
            let modes = problem.contact_modes(self.model);
            let direction = || collapse::direction(problem.program(), &modes, &options);
            if let Some(x) = (!modes.is_empty()).then(direction).flatten() {
                solution.status = SolveStatus::Unbounded;
                solution.x = x;
                // the multipliers are those of the attempt that failed
                solution.z.fill(0.0);
            }
        }
        run.status = solution.status;
        run.solve_seconds += start.elapsed().as_secs_f64();
        run.trace = std::mem::take(&mut *trace.lock().unwrap_or_else(PoisonError::into_inner));
        solution
    }

    /// Field and bound of an optimal solution; of any other, its certificate in words. Only optimal
    /// ones give a bound.
    fn judge<P: DiscreteProgram<'a>>(
        &self,
        problem: &P,
        solution: &Solution,
        run: &mut ProgramRun,
    ) -> Result<Option<P::Answer>, PassError> {
        match solution.status {
            SolveStatus::Optimal => {
                self.tell(P::PROGRAM, Event::Certify);
                match problem.recover(self.model, solution, &self.options.solve.patterns) {
                    Ok(answer) => return Ok(Some(answer)),
                    Err(RecoverError::Model(e)) => return Err(e.into()),
                    Err(e) => run.trouble = Some(e.to_string()),
                }
            }
            SolveStatus::Unbounded => {
                run.mechanism = Some(problem.mechanism(self.model, solution));
            }
            SolveStatus::Infeasible => {
                run.conflict = problem.conflict(self.model, &solution.z);
            }
            _ => {}
        }
        Ok(None)
    }
}

/// Σ contributions = gap, to 1e-8 of the bounds (lower, upper) or of what else measures them.
pub(crate) fn check_identity(
    [lower, upper]: [f64; 2],
    beside: f64,
    sum: f64,
) -> Result<(), PassError> {
    let gap = upper - lower;
    if (gap - sum).abs() > 1e-8 * lower.abs().max(upper.abs()).max(beside).max(sum) {
        return Err(PassError::Identity { gap, sum });
    }
    Ok(())
}

/// An optimal solution in unknowns that are not measured from a point any more.
fn moved_by(from: &[f64], mut solution: Solution) -> Solution {
    if solution.status == SolveStatus::Optimal {
        solution.x.iter_mut().zip(from).for_each(|(x, from)| *x += from);
    }
    solution
}

/// True when the solver gave up without an answer.
fn stalled(status: SolveStatus) -> bool {
    use SolveStatus::{Infeasible, IterationLimit, NumericalError, ReducedAccuracy};
    matches!(status, Infeasible | IterationLimit | NumericalError | ReducedAccuracy)
}
