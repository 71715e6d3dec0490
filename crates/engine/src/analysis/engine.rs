//! Runs both programs on one mesh: assembly, plan of the memory, solves, certificates.

use crate::analysis::diagnosis;
use crate::analysis::discrete_program::{BaseProgram, DiscreteProgram};
use crate::analysis::event::{Event, Progress};
use crate::analysis::memory::{Limit, plan};
use crate::analysis::pass::{PassError, PassOptions};
use crate::analysis::program::Program;
use crate::analysis::program_outcome::{InsufficientMemory, ProgramOutcome};
use crate::model::file::Bounds;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::{ConicProgram, Kinematic, Static};
use crate::recover::elastic::RecoverError;
use crate::solve;
use crate::solve::Iteration;
use crate::solve::Prepared;
use crate::solve::Solution;
use crate::solve::SolveOptions;
use crate::solve::SolveStatus;
use crate::solve::allocator;
use crate::solve::feasibility;
use crate::solve::status::{HandOver, Iterations};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Input common to both programs of a pass.
struct Context<'a> {
    model: &'a AnalysisModel,
    options: &'a PassOptions,
    progress: &'a Progress,
    start: Instant,
}

/// A program after its assembly.
struct Assembled<P> {
    problem: P,
    /// Time to assemble \[s\].
    seconds: f64,
    /// The point from which the solver measures the unknowns, and the program in unknowns measured
    /// from it; `None`: zero.
    moved: Option<(Vec<f64>, ConicProgram)>,
}

/// A program before its solve.
struct Job<'p, P> {
    problem: &'p P,
    /// The point from which the solver measures the unknowns; empty: zero.
    origin: &'p [f64],
    /// `None`: the user interrupted before the program was ordered.
    prepared: Option<Prepared<'p>>,
    outcome: ProgramOutcome,
}

/// A program after its solve, with field and bound where both could be certified.
pub(crate) struct Finished<A> {
    pub(crate) outcome: ProgramOutcome,
    pub(crate) answer: Option<A>,
}

/// Whether a program may start.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Admission {
    Start,
    /// It starts after the other program if the machine still has this much memory \[bytes\].
    StartIf(u64),
    Refused(InsufficientMemory),
}

/// Admission and order of both programs.
struct Schedule {
    kinematic: Admission,
    statics: Admission,
    /// The program that runs first, the smaller one: an early bound is worth more than a late one.
    /// `None`: side by side.
    first: Option<Program>,
}

/// Both programs after their solves; `None`: not requested. Neither of two that were requested:
/// they would take longer than [`PassOptions::both_within`].
pub(crate) type Both<K, S> = (Option<Finished<K>>, Option<Finished<S>>);

/// Assembles and runs the programs whose bounds the model requests: side by side where the memory
/// allows it, else one after the other. A program that does not fit is not started.
pub(crate) fn both<'a, K: DiscreteProgram, S: DiscreteProgram>(
    model: &'a AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
    kinematic: impl FnOnce(&'a AnalysisModel) -> Result<K, ModelError> + Send,
    statics: impl FnOnce(&'a AnalysisModel) -> Result<S, ModelError> + Send,
) -> Result<Both<K::Answer, S::Answer>, PassError> {
    let kinematic = (model.bounds != Bounds::Static).then_some(|| kinematic(model));
    let statics = (model.bounds != Bounds::Kinematic).then_some(|| statics(model));
    assemble_and_run(model, options, progress, kinematic, statics)
}

/// Runs a kinematic program alone.
pub(crate) fn kinematic_alone<K: DiscreteProgram>(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
    build: impl FnOnce() -> Result<K, ModelError> + Send,
) -> Result<Option<Finished<K::Answer>>, PassError> {
    let none = None::<fn() -> Result<Static<'static>, ModelError>>;
    Ok(assemble_and_run(model, options, progress, Some(build), none)?.0)
}

/// Runs a static program alone.
pub(crate) fn static_alone<S: DiscreteProgram>(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
    build: impl FnOnce() -> Result<S, ModelError> + Send,
) -> Result<Option<Finished<S::Answer>>, PassError> {
    let none = None::<fn() -> Result<Kinematic, ModelError>>;
    Ok(assemble_and_run(model, options, progress, none, Some(build))?.1)
}

/// Assembles and runs the given programs; `None`: not requested.
pub(crate) fn assemble_and_run<K: DiscreteProgram, S: DiscreteProgram>(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
    kinematic: Option<impl FnOnce() -> Result<K, ModelError> + Send>,
    statics: Option<impl FnOnce() -> Result<S, ModelError> + Send>,
) -> Result<Both<K::Answer, S::Answer>, PassError> {
    // faer's parallel dense kernels would make the last digits depend on the number of threads
    bracket_base::math::dense::sequential_kernels();
    let context = Context { model, options, progress, start: Instant::now() };
    let (kinematic, statics) = rayon::join(
        || kinematic.map(|build| context.assemble(build)).transpose(),
        || statics.map(|build| context.assemble(build)).transpose(),
    );
    let (kinematic, statics) = (kinematic?, statics?);
    let (k, s) = rayon::join(
        || kinematic.as_ref().map(|program| context.prepare(program)),
        || statics.as_ref().map(|program| context.prepare(program)),
    );
    if let (Some(k), Some(s)) = (&k, &s)
        && context.too_long([&k.outcome, &s.outcome])
    {
        return Ok((None, None));
    }
    let schedule = context.schedule(k.as_ref().map(|j| &j.outcome), s.as_ref().map(|j| &j.outcome));
    let kinematic = || k.map(|job| context.finish(job, schedule.kinematic)).transpose();
    let statics = || s.map(|job| context.finish(job, schedule.statics)).transpose();
    let (kinematic, statics) = match schedule.first {
        None => rayon::join(kinematic, statics),
        Some(Program::Kinematic) => (kinematic(), statics()),
        Some(Program::Static) => {
            let s = statics();
            (kinematic(), s)
        }
    };
    Ok((kinematic?, statics?))
}

impl Context<'_> {
    fn report(&self, program: Program, event: Event<'_>) {
        (self.progress)(program, event);
    }

    fn assemble<P: DiscreteProgram>(
        &self,
        build: impl FnOnce() -> Result<P, ModelError>,
    ) -> Result<Assembled<P>, PassError> {
        let start = Instant::now();
        self.report(P::PROGRAM, Event::Assembly);
        let problem = build()?;
        let origin = problem.origin(self.model);
        let moved = (!origin.is_empty()).then(|| {
            let program = problem.base().conic().measured_from(&origin);
            (origin, program)
        });
        Ok(Assembled { problem, seconds: start.elapsed().as_secs_f64(), moved })
    }

    /// Orders a program and forecasts its cost.
    fn prepare<'p, P: DiscreteProgram>(&self, assembled: &'p Assembled<P>) -> Job<'p, P> {
        let start = Instant::now();
        let problem = &assembled.problem;
        let (origin, program): (&[f64], _) = match &assembled.moved {
            Some((origin, program)) => (origin, program),
            None => (&[], problem.base().conic()),
        };
        let map = problem.base().map();
        let options = &self.options.solve;
        let prepared =
            (!options.interrupted()).then(|| solve::prepare(program, &map.block, options));
        let forecast = prepared.as_ref().and_then(Prepared::forecast);
        let outcome = ProgramOutcome {
            status: SolveStatus::Interrupted,
            iterations: 0,
            dofs: map.n,
            cones: program.cones.len(),
            assembly_seconds: assembled.seconds,
            solve_seconds: start.elapsed().as_secs_f64(),
            certify_seconds: 0.0,
            forecast,
            handed_over: 0,
            trace: Vec::new(),
            refusal: None,
            yielding: problem.yielding(),
            rounds: 1,
            mechanism: None,
            conflict: None,
            long_tets: None,
            trouble: None,
        };
        Job { problem, origin, prepared, outcome }
    }

    /// Whether both programs together would take longer than they may.
    fn too_long(&self, outcomes: [&ProgramOutcome; 2]) -> bool {
        let within = self.options.both_within;
        if within.is_infinite() || self.options.solve.interrupted() {
            return false;
        }
        let seconds = outcomes.map(|o| o.forecast.map_or(f64::INFINITY, |f| f.seconds));
        let expected = seconds[0] + seconds[1];
        if expected <= within {
            return false;
        }
        self.report(Program::Kinematic, Event::Later { expected, within });
        true
    }

    /// Reports the forecasts and decides which programs start, and in which order.
    fn schedule(
        &self,
        kinematic: Option<&ProgramOutcome>,
        statics: Option<&ProgramOutcome>,
    ) -> Schedule {
        let outcomes = [(Program::Kinematic, kinematic), (Program::Static, statics)];
        let mut schedule =
            Schedule { kinematic: Admission::Start, statics: Admission::Start, first: None };
        if self.options.solve.interrupted() {
            return schedule;
        }
        for (program, outcome) in outcomes {
            let Some(outcome) = outcome else { continue };
            self.report(
                program,
                Event::Forecast { unknowns: outcome.dofs, forecast: outcome.forecast.as_ref() },
            );
        }
        let Some(room) = (self.options.room)() else { return schedule };
        let needs = outcomes.map(|(_, o)| o.and_then(|o| o.forecast).map_or(0, |f| f.bytes));
        let plan = plan(&needs, room.bytes);
        let any = (0..2).any(|i| outcomes[i].1.is_some() && plan.starts[i]);
        let admissions = [&mut schedule.kinematic, &mut schedule.statics];
        for (i, admission) in admissions.into_iter().enumerate() {
            if !plan.starts[i] {
                let refusal = InsufficientMemory { needed: needs[i], room };
                *admission = Admission::Refused(refusal);
                // where no program starts, the caller reports it
                if any {
                    self.report(outcomes[i].0, Event::Refused(&refusal));
                }
            }
        }
        if !plan.together {
            let (first, second) = if needs[0] <= needs[1] { (0, 1) } else { (1, 0) };
            let waits = if second == 0 { &mut schedule.kinematic } else { &mut schedule.statics };
            *waits = Admission::StartIf(needs[second]);
            schedule.first = Some(outcomes[first].0);
            self.report(
                outcomes[second].0,
                Event::Waits { needed: needs[0].saturating_add(needs[1]), room },
            );
        }
        schedule
    }

    /// Solves a program and certifies its field, as far as memory and user allow.
    fn finish<P: DiscreteProgram>(
        &self,
        job: Job<'_, P>,
        admission: Admission,
    ) -> Result<Finished<P::Answer>, PassError> {
        let Job { problem, origin, prepared, mut outcome } = job;
        let refusal = match admission {
            Admission::Start => None,
            Admission::Refused(refusal) => Some(refusal),
            // Other processes may have taken memory meanwhile. A limit of the user was checked by
            // the plan; the memory that this process still holds of the first program is used
            // again.
            Admission::StartIf(needed) => {
                let now = (self.options.room)().filter(|r| r.limit == Limit::Machine);
                let refusal = now
                    .filter(|r| r.bytes < needed)
                    .map(|room| InsufficientMemory { needed, room });
                refusal.iter().for_each(|r| self.report(P::PROGRAM, Event::Refused(r)));
                refusal
            }
        };
        let mut answer = None;
        if self.options.solve.interrupted() {
            outcome.status = SolveStatus::Interrupted;
        } else if let Some(refusal) = refusal {
            outcome.status = SolveStatus::TooLarge;
            outcome.refusal = Some(refusal);
        } else if let Some(prepared) = prepared {
            let solution = self.solve(problem, origin, prepared, &mut outcome);
            let start = Instant::now();
            answer = self.recover(problem, &solution, &mut outcome)?;
            outcome.certify_seconds = start.elapsed().as_secs_f64();
        }
        self.report(P::PROGRAM, Event::Ended(&outcome));
        Ok(Finished { outcome, answer })
    }

    /// Solves a program, reporting and keeping its iterations.
    fn solve<P: DiscreteProgram>(
        &self,
        problem: &P,
        origin: &[f64],
        mut prepared: Prepared<'_>,
        outcome: &mut ProgramOutcome,
    ) -> Solution {
        self.report(P::PROGRAM, Event::Solve { forecast: outcome.forecast.as_ref() });
        let start = Instant::now();
        let trace: Arc<Mutex<Vec<Iteration>>> = Arc::default();
        let (kept, progress) = (trace.clone(), self.progress.clone());
        let report: Iterations = Arc::new(move |i| {
            // one clock for all solvers: one that takes over starts its own
            let i = Iteration { seconds: start.elapsed().as_secs_f64(), ..*i };
            kept.lock().unwrap_or_else(PoisonError::into_inner).push(i);
            progress(P::PROGRAM, Event::Iteration(&i));
        });
        let handed_over = Arc::<AtomicU64>::default();
        let (kept, progress, room) =
            (handed_over.clone(), self.progress.clone(), self.options.room.clone());
        let hand_over: HandOver = Arc::new(move |bytes| {
            let fits = room().is_none_or(|r| r.bytes >= bytes);
            if fits {
                kept.fetch_max(bytes, Ordering::Relaxed);
                progress(P::PROGRAM, Event::HandOver { bytes });
            }
            fits
        });
        let given = &self.options.solve;
        let left = (given.time_limit - self.start.elapsed().as_secs_f64()).max(0.0);
        let mut options = SolveOptions {
            progress: Some(report),
            hand_over: Some(hand_over),
            time_limit: left,
            ..problem.accuracy(given)
        };
        let program = problem.base().conic();
        let mut solution = back_from(origin, prepared.solve_first(&options));
        outcome.iterations = solution.iterations;
        let rows = if origin.is_empty() { Vec::new() } else { program.g.mul(origin) };
        while solution.status.is_solution()
            && let Some(next) = problem.next_problem(self.model, &solution)
        {
            let event = Event::ConeShift { solves: next.solves, change: next.change };
            self.report(P::PROGRAM, event);
            options.time_limit = (left - start.elapsed().as_secs_f64()).max(0.0);
            let mut offsets = next.offsets;
            offsets.iter_mut().zip(&rows).for_each(|(h, moved)| *h += moved);
            solution = back_from(origin, prepared.solve_at(&offsets, &options));
            outcome.iterations += solution.iterations;
        }
        drop(prepared);
        allocator::give_back();
        if stalled(solution.status) {
            options.time_limit = (left - start.elapsed().as_secs_f64()).max(0.0);
            let modes = problem.contact_modes(self.model);
            let direction = || feasibility::direction(program, &modes, &options);
            if let Some(x) = (!modes.is_empty()).then(direction).flatten() {
                solution.status = SolveStatus::Unbounded;
                solution.x = x;
                // the multipliers belong to the attempt that failed
                solution.z.fill(0.0);
            }
        }
        outcome.status = solution.status;
        outcome.handed_over = handed_over.load(Ordering::Relaxed);
        outcome.solve_seconds += start.elapsed().as_secs_f64();
        outcome.trace = std::mem::take(&mut *trace.lock().unwrap_or_else(PoisonError::into_inner));
        solution
    }

    /// Field and bound of a solution; the diagnosis of an unbounded or infeasible one.
    /// Only solutions give a bound.
    fn recover<P: DiscreteProgram>(
        &self,
        problem: &P,
        solution: &Solution,
        outcome: &mut ProgramOutcome,
    ) -> Result<Option<P::Answer>, PassError> {
        match solution.status {
            status if status.is_solution() => {
                self.report(P::PROGRAM, Event::Certify);
                match problem.recover(self.model, solution, &self.options.solve.patterns) {
                    Ok(answer) => return Ok(Some(answer)),
                    Err(RecoverError::Model(e)) => return Err(e.into()),
                    Err(e) => outcome.trouble = Some(e.text()),
                }
            }
            SolveStatus::Unbounded => {
                outcome.mechanism = Some(problem.mechanism(self.model, solution));
            }
            SolveStatus::Infeasible => {
                outcome.conflict = problem.conflict(self.model, &solution.z);
            }
            status if stalled(status) => outcome.long_tets = diagnosis::long_tets(self.model),
            _ => {}
        }
        Ok(None)
    }
}

/// A solution in unknowns measured from zero, from one measured from `origin`.
fn back_from(origin: &[f64], mut solution: Solution) -> Solution {
    if solution.status.is_solution() {
        solution.x.iter_mut().zip(origin).for_each(|(x, origin)| *x += origin);
    }
    solution
}

/// True when the solver ended without a solution or a certificate.
fn stalled(status: SolveStatus) -> bool {
    use SolveStatus::{Infeasible, IterationLimit, NumericalError, ReducedAccuracy};
    matches!(status, Infeasible | IterationLimit | NumericalError | ReducedAccuracy)
}
