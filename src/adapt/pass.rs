//! One pass: both programs on one mesh, their fields, certificates and bracket.

use crate::bounds::bracket::{Bracket, Contradiction, LowerBound, UpperBound};
use crate::bounds::certificate::{certify_displacement, certify_stress};
use crate::bounds::error::{Contributions, contributions};
use crate::bounds::fields::{DisplacementField, StressField};
use crate::bounds::recover::{self, RecoverError};
use crate::math::vec3::{self, V3};
use crate::model::file::Bounds;
use crate::model::holds::ModelError;
use crate::model::{AnalysisModel, Kinematic, Static};
use crate::solve::status::Iterations;
use crate::solve::{self, Solution, SolveOptions, SolveStatus, collapse};
use std::sync::Arc;
use std::time::Instant;

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
    /// Time to solve \[s\].
    pub solve_seconds: f64,
    /// Time to recover and certify the field \[s\].
    pub certify_seconds: f64,
    /// For an unbounded program: which parts move, in words.
    pub mechanism: Option<String>,
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
    /// The contributions of elements and contacts do not add up to the gap: the two certificates do not fit together.
    #[error("the contributions to the gap sum to {sum:.9e}, the bounds differ by {gap:.9e} N mm")]
    Identity {
        /// Π_p + Π_c of the meshed part.
        gap: f64,
        /// Sum of the contributions.
        sum: f64,
    },
}

impl From<PassError> for crate::diag::Diagnostic {
    fn from(e: PassError) -> Self {
        match e {
            PassError::Model(e) => e.into(),
            e => crate::diag::Diagnostic::undecided("bounds/contradiction", e.to_string())
                .help("the numbers are withheld; try another mesh or `--solver clarabel`, and report the case"),
        }
    }
}

/// What a program tells while it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Assembling.
    Assembly,
    /// Solving.
    Solve,
    /// Recovering and certifying the field.
    Certify,
}

/// Told which program (`kinematic`, `static`) reaches which stage, its iteration and its relative gap.
pub type Progress = Arc<dyn Fn(&'static str, Stage, u32, f64) + Send + Sync>;

struct Timed<T> {
    run: ProgramRun,
    result: Option<T>,
}

/// Runs both programs side by side.
pub fn run(model: &AnalysisModel, options: &SolveOptions, progress: &Progress) -> Result<Pass, PassError> {
    // faer's parallel dense kernels would make the last digits depend on the number of threads
    faer::set_global_parallelism(faer::Par::Seq);
    let (kinematic, statics) = rayon::join(
        || (model.bounds != Bounds::Static).then(|| run_kinematic(model, options, progress)).transpose(),
        || (model.bounds != Bounds::Kinematic).then(|| run_static(model, options, progress)).transpose(),
    );
    let mut pass = Pass::default();
    if let Some(k) = kinematic? {
        pass.kinematic = Some(k.run);
        if let Some((field, bound)) = k.result {
            pass.displacement = Some(field);
            pass.upper = Some(bound);
        }
    }
    if let Some(s) = statics? {
        pass.statics = Some(s.run);
        if let Some((field, bound)) = s.result {
            pass.stress = Some(field);
            pass.lower = Some(bound);
        }
    }
    if let (Some(l), Some(u)) = (&pass.lower, &pass.upper) {
        pass.bracket = Some(Bracket::new(l.clone(), u.clone())?);
    }
    if let (Some(u), Some(s)) = (&pass.displacement, &pass.stress) {
        let c = contributions(model, u, s);
        check_identity(model, pass.bracket.as_ref(), c.total())?;
        pass.contributions = Some(c);
    }
    Ok(pass)
}

/// Σ contributions = gap, to 1e-8 of the energies; asserted where both fields are admissible.
fn check_identity(model: &AnalysisModel, bracket: Option<&Bracket>, sum: f64) -> Result<(), PassError> {
    let Some(b) = bracket.filter(|b| b.is_strict()) else { return Ok(()) };
    let copies = f64::from(model.symmetry);
    let gap = (b.upper().value() - b.lower().value()) / copies;
    let size = b.lower().value().abs().max(b.upper().value().abs()) / copies;
    if (gap - sum).abs() > 1e-8 * size.max(sum) {
        return Err(PassError::Identity { gap, sum });
    }
    Ok(())
}

fn start_run(solution: &Solution, dofs: usize, cones: usize, assembly: f64) -> ProgramRun {
    ProgramRun {
        status: solution.status,
        iterations: solution.iterations,
        dofs,
        cones,
        assembly_seconds: assembly,
        solve_seconds: solution.seconds,
        certify_seconds: 0.0,
        mechanism: None,
        trouble: None,
    }
}

/// Solves a program, telling its iterations.
fn solve_told(
    name: &'static str,
    program: &crate::model::ConicProgram,
    block: &[u32],
    options: &SolveOptions,
    progress: &Progress,
) -> Solution {
    progress(name, Stage::Solve, 0, 1.0);
    let told = progress.clone();
    let tell: Iterations = Arc::new(move |i| told(name, Stage::Solve, i.number, i.gap));
    solve::solve(program, block, &SolveOptions { progress: Some(tell), ..options.clone() })
}

fn run_kinematic(
    model: &AnalysisModel,
    options: &SolveOptions,
    progress: &Progress,
) -> Result<Timed<(DisplacementField, UpperBound)>, PassError> {
    let start = Instant::now();
    progress("kinematic", Stage::Assembly, 0, 1.0);
    let kinematic = Kinematic::new(model)?;
    let assembly = start.elapsed().as_secs_f64();
    let mut solution = solve_told("kinematic", &kinematic.program, &kinematic.map.block, options, progress);
    if stalled(solution.status) {
        let modes: Vec<Vec<f64>> = kinematic.contact_modes(model).into_iter().map(|m| m.unknowns).collect();
        unless_collapse(&mut solution, &kinematic.program, &modes, options);
    }
    let mut run = start_run(&solution, kinematic.map.n, kinematic.program.cones.len(), assembly);
    let start = Instant::now();
    let mut result = None;
    match solution.status {
        SolveStatus::Optimal => {
            progress("kinematic", Stage::Certify, solution.iterations, 0.0);
            match recover::displacement(&kinematic, &solution) {
                Ok(field) => {
                    let bound = UpperBound::new(certify_displacement(model, &field), model.symmetry);
                    result = Some((field, bound));
                }
                Err(e) => run.trouble = Some(e.to_string()),
            }
        }
        SolveStatus::Unbounded => {
            let u = kinematic.map.expand(&solution.x);
            let moved =
                model.node_parts().into_iter().enumerate().map(|(n, p)| (p, [u[3 * n], u[3 * n + 1], u[3 * n + 2]]));
            run.mechanism = Some(mechanism(model, moved));
        }
        _ => {}
    }
    run.certify_seconds = start.elapsed().as_secs_f64();
    Ok(Timed { run, result })
}

fn run_static(
    model: &AnalysisModel,
    options: &SolveOptions,
    progress: &Progress,
) -> Result<Timed<(StressField, LowerBound)>, PassError> {
    let start = Instant::now();
    progress("static", Stage::Assembly, 0, 1.0);
    let statics = Static::new(model)?;
    let assembly = start.elapsed().as_secs_f64();
    let mut solution = solve_told("static", &statics.program, &statics.map.block, options, progress);
    if stalled(solution.status) {
        let modes: Vec<Vec<f64>> = statics.contact_modes().into_iter().map(|m| m.unknowns).collect();
        unless_collapse(&mut solution, &statics.program, &modes, options);
    }
    let mut run = start_run(&solution, statics.map.n, statics.program.cones.len(), assembly);
    let start = Instant::now();
    let mut result = None;
    match solution.status {
        SolveStatus::Optimal => {
            progress("static", Stage::Certify, solution.iterations, 0.0);
            match recover::stress(&statics, &solution) {
                Ok(field) => {
                    let bound = LowerBound::new(certify_stress(model, &field), model.symmetry);
                    result = Some((field, bound));
                }
                Err(RecoverError::Model(e)) => return Err(e.into()),
                Err(e) => run.trouble = Some(e.to_string()),
            }
        }
        SolveStatus::Unbounded => {
            let v = statics.map.expand(&solution.x);
            let moved = (0..v.len() / 9).flat_map(|f| {
                let part = statics.elements.part(f) as u32;
                let at = |p: usize| [v[9 * f + 3 * p], v[9 * f + 3 * p + 1], v[9 * f + 3 * p + 2]];
                [(part, at(0)), (part, at(1)), (part, at(2))]
            });
            run.mechanism = Some(mechanism(model, moved));
        }
        _ => {}
    }
    run.certify_seconds = start.elapsed().as_secs_f64();
    Ok(Timed { run, result })
}

/// True when the solver gave up without an answer.
fn stalled(status: SolveStatus) -> bool {
    use SolveStatus::{Infeasible, IterationLimit, NumericalError, ReducedAccuracy};
    matches!(status, Infeasible | IterationLimit | NumericalError | ReducedAccuracy)
}

/// Asks whether a stalled program lacks equilibrium, and if so says `Unbounded`.
fn unless_collapse(
    solution: &mut Solution,
    program: &crate::model::ConicProgram,
    modes: &[Vec<f64>],
    options: &SolveOptions,
) {
    if let Some(x) = collapse::direction(program, modes, options) {
        solution.status = SolveStatus::Unbounded;
        solution.x = x;
    }
}

/// Which parts move along an unbounded direction, in words.
fn mechanism(model: &AnalysisModel, moved: impl Iterator<Item = (u32, V3)>) -> String {
    let mut mean = vec![([0.0; 3], 0.0); model.parts.len()];
    for (p, u) in moved {
        let m = &mut mean[p as usize];
        *m = (vec3::add(m.0, u), m.1 + 1.0);
    }
    let mean: Vec<V3> = mean.into_iter().map(|(s, n)| if n > 0.0 { vec3::scale(1.0 / n, s) } else { s }).collect();
    let largest = mean.iter().map(|m| vec3::norm(*m)).fold(0.0, f64::max);
    let moving: Vec<String> = mean
        .iter()
        .zip(&model.parts)
        .filter(|(m, _)| vec3::norm(**m) > 0.05 * largest)
        .map(|(m, name)| {
            let d = (0..3).max_by(|&a, &b| m[a].abs().total_cmp(&m[b].abs())).unwrap_or(0);
            format!("part {name} moves along {}{}", if m[d] < 0.0 { "−" } else { "+" }, ["x", "y", "z"][d])
        })
        .collect();
    if moving.is_empty() { "the parts turn without moving their centres".into() } else { moving.join(", ") }
}

/// Peak resident memory of this process so far \[MiB\]; `None` where the system does not tell.
pub fn peak_memory_mib() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib / 1024)
}
