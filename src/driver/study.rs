//! The study of speed against error: compares uniform and adaptive meshes and solvers.

use crate::driver::adaptive::Begun;
use crate::driver::case::Case;
use crate::driver::interrupt::Interrupt;
use crate::driver::limits::Limits;
use crate::driver::meshing::{Extent, find_mesher, mesh, mesh_options};
use crate::driver::passes::Share;
use crate::driver::present::INTERRUPTED;
use crate::driver::remesh::{ByBisection, Places};
use crate::driver::setup::Refinement;
use crate::driver::spec_cases::{cases, give_remesh};
use crate::driver::spec_checks::{analysis_kinds, check_input};
use crate::driver::spec_file::{self, SpecFile};
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus, number};
use bracket_base::text_file;
use bracket_base::yaml;
use bracket_engine::analysis::memory::forget_peak;
use bracket_engine::mesh::{TetMesh, bisect, merge, msh};
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::file::{ModelFile, Nodes};
use bracket_engine::model::resolve::{load_model, resolve};
use bracket_engine::refine::plan;
use bracket_engine::solve::{Patterns, Solver, StopRules};
use bracket_joint::meshing::joint::MeshOptions;
use bracket_joint::spec::analysis::AnalysisSpec;
use bracket_report::console::log::Log;
use bracket_report::result::file_names::file_stem;
use bracket_report::result::folder::{Content, ResultFolder};
use bracket_report::result::study::{Meshes, Study, study_rows};
use bracket_report::study::MARK;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// The options of a study.
#[derive(Clone, Debug)]
pub struct StudyOptions {
    /// Connection spec or model file.
    pub file: PathBuf,
    /// Folder for the study; `None`: named after the input, with `_study`.
    pub out: Option<PathBuf>,
    /// Solvers to compare.
    pub solvers: Vec<Solver>,
    /// Number of uniform meshes, each about twice as large as the one before; 0: adaptive meshes
    /// only.
    pub uniform: u32,
    /// Factor on all element sizes of a spec's first mesh.
    pub size_factor: f64,
    /// Gap at which the adaptive meshes end, a fraction; `None`: as in the file.
    pub target_gap: Option<f64>,
    /// Largest number of tets, for uniform meshes too; `None`: as in the file.
    pub max_macro_tets: Option<usize>,
    /// Largest number of adaptive meshes; `None`: as in the file.
    pub max_passes: Option<u32>,
    /// Show nothing on standard error.
    pub quiet: bool,
}

/// Source of the meshes.
trait Source {
    /// The load cases on the uniform mesh of a level; level 0 is the first mesh. With `adaptive`
    /// the cases can be meshed again.
    fn cases(&self, level: u32, adaptive: bool) -> Result<Vec<Case<'_>>, Diagnostics>;
}

/// A connection spec.
struct Spec<'a> {
    input: &'a SpecFile,
    kinds: Vec<AnalysisKind>,
    options: MeshOptions,
    place: Places<'a>,
    interrupt: &'a Interrupt,
    log: &'a Log,
}

/// A model file and its mesh.
struct Model<'a> {
    name: String,
    file: ModelFile,
    mesh: TetMesh,
    place: Places<'a>,
}

/// Ratio of the element sizes of a level to those of the level before. It gives about twice the
/// tets.
const FINER: f64 = 0.76;

impl Source for Spec<'_> {
    fn cases(&self, level: u32, adaptive: bool) -> Result<Vec<Case<'_>>, Diagnostics> {
        let start = Instant::now();
        let mut options = self.options.clone();
        options.sizes.factor *= FINER.powi(level as i32);
        let meshed = mesh(&options, self.input, self.log)?;
        let seconds = start.elapsed().as_secs_f64();
        let mut cases = cases(self.input, &meshed, &self.kinds, None, seconds, self.interrupt)?;
        if adaptive {
            give_remesh(
                &mut cases,
                self.input,
                &options,
                &meshed,
                self.place,
                (self.interrupt, self.log),
            );
        }
        Ok(cases)
    }
}

impl Source for Model<'_> {
    fn cases(&self, level: u32, adaptive: bool) -> Result<Vec<Case<'_>>, Diagnostics> {
        let start = Instant::now();
        let mut mesh = self.mesh.clone();
        for _ in 0..level {
            mesh = bisect::refine(&mesh, &vec![2.0; mesh.tets.len()]).mesh;
        }
        let model = resolve(&self.file, mesh.clone(), self.place)?;
        let remesh = ByBisection::new(&self.file, self.place, mesh);
        Ok(vec![Case {
            name: self.name.clone(),
            model,
            model_file: ("model.yaml".into(), self.file.clone()),
            remesh: if adaptive { Some(Box::new(remesh)) } else { None },
            mesh_seconds: Some(start.elapsed().as_secs_f64()),
            direction: None,
        }])
    }
}

/// Largest number of uniform meshes: the last would have a thousand times the tets of the first.
const MOST_UNIFORM: u32 = 10;

/// Refuses options out of range.
fn check(options: &StudyOptions) -> Result<(), Diagnostics> {
    let wrong = |message: String, help: &str| {
        Err(Diagnostic::input("cli/value", message).help(help).into())
    };
    if options.uniform > MOST_UNIFORM {
        return wrong(
            format!("--uniform is {}, at most {MOST_UNIFORM} meshes are made", options.uniform),
            "3 to 5 show the rate of convergence",
        );
    }
    Extent { full: false, size_factor: options.size_factor }.check()?;
    if let Some(g) = options.target_gap.filter(|g| !(*g > 0.0 && *g < 1.0)) {
        return wrong(
            format!("--target-gap is {}, it must lie between 0 and 1", number(g)),
            "write a fraction such as 0.02",
        );
    }
    if options.max_passes == Some(0) {
        return wrong(
            "--max-passes is 0, it must be at least 1".into(),
            "leave the option out to use the value of the file",
        );
    }
    if options.max_macro_tets == Some(0) {
        return wrong(
            "--max-macro-tets is 0, it must be at least 1".into(),
            "leave the option out to use the value of the file",
        );
    }
    Ok(())
}

/// Runs a study and writes its folder.
pub fn run_study(options: &StudyOptions, mut limits: Limits) -> Result<Study, Diagnostics> {
    check(options)?;
    let text = text_file::read(&options.file, |e| {
        Diagnostic::input("study/read", format!("`{}` cannot be read: {e}", options.file.display()))
            .file(&options.file)
            .help("name a connection spec or a model file")
    })?;
    let stem = options
        .file
        .file_stem()
        .map_or_else(|| "model".into(), |s| s.to_string_lossy().into_owned());
    let target =
        options.out.clone().unwrap_or_else(|| options.file.with_file_name(format!("{stem}_study")));
    let log = Arc::new(Log::new(options.quiet));
    let defaults = AnalysisSpec::default();
    let is_model = yaml::top_level(&text, &["mesh", "bodies"]);
    let begin = |limits: &Limits| -> Result<ResultFolder, Diagnostics> {
        let content = Content::Files { mark: MARK, command: "study" };
        let folder = ResultFolder::begin_with(&target, content)?;
        limits.interrupt.begin(&log, WHEN_INTERRUPTED, folder.give_up());
        Ok(folder)
    };
    let (study, folder) = if is_model {
        // the input is checked completely before the folder is created
        load_model(&options.file)?;
        let parsed = yaml::parse::<ModelFile>(&text, &options.file)?;
        let mut file = parsed.value.clone();
        let mut mesh = msh::read(&options.file.parent().unwrap_or(Path::new("")).join(&file.mesh))?;
        if file.nodes == Nodes::Split {
            merge::merge_coincident(&mut mesh)?;
            file.nodes = Nodes::Shared;
        }
        let adapt = file.adapt.as_ref();
        let ends = plan::Limits {
            target_gap: adapt.map_or(defaults.target_gap, |a| a.target_gap),
            max_passes: adapt.and_then(|a| a.max_passes).unwrap_or(defaults.max_passes),
            max_macro_tets: adapt.and_then(|a| a.max_macro_tets).unwrap_or(defaults.max_macro_tets),
        };
        let place = |path: &str| parsed.index.place(path);
        let folder = begin(&limits)?;
        let source = Model { name: file_stem(&stem), file, mesh, place: &place };
        (study(options, &source, ends, &mut limits, &log)?, folder)
    } else {
        let input = spec_file::read(&options.file, None)?;
        let kinds = analysis_kinds(&input)?;
        check_input(&input, &kinds)?;
        let asked = &input.spec.value.analysis;
        limits.time = asked.time_limit.map(|t| t.0);
        let mesher = find_mesher(&limits.interrupt, limits.time, &log)?;
        let ends = plan::Limits {
            target_gap: asked.target_gap,
            max_passes: asked.max_passes,
            max_macro_tets: asked.max_macro_tets,
        };
        let folder = begin(&limits)?;
        let mesh_options = mesh_options(
            Extent { full: false, size_factor: options.size_factor },
            &input,
            &kinds,
            &mesher,
            &limits.interrupt,
            folder.path(),
        );
        let place = |path: &str| input.spec.index.place(path);
        let interrupt = limits.interrupt.clone();
        let source = Spec {
            input: &input,
            kinds,
            options: mesh_options,
            place: &place,
            interrupt: &interrupt,
            log: &log,
        };
        (study(options, &source, ends, &mut limits, &log)?, folder)
    };
    study.write(folder.path())?;
    folder.finish()?;
    log.line(format!("study: {}", target.join("study.md").display()));
    if limits.interrupt.asked() {
        log.line(format!("exit code {}: {INTERRUPTED}", ExitStatus::Undecided.code()));
    }
    Ok(study)
}

/// Effect of the first Ctrl-C, as the log announces it.
const WHEN_INTERRUPTED: &str =
    "the solvers stop after their current iteration, and the rows so far are written";

/// All rows: for each solver first the uniform meshes, then the adaptive ones.
fn study(
    options: &StudyOptions,
    source: &dyn Source,
    ends: plan::Limits,
    limits: &mut Limits,
    log: &Arc<Log>,
) -> Result<Study, Diagnostics> {
    let ends = plan::Limits {
        target_gap: options.target_gap.unwrap_or(ends.target_gap),
        max_passes: options.max_passes.unwrap_or(ends.max_passes),
        max_macro_tets: options.max_macro_tets.unwrap_or(ends.max_macro_tets),
    };
    let mut refinement = Refinement { adapt: None, finer: "", coarser: "a coarser first mesh" };
    let mut rows = Vec::new();
    for solver in &options.solvers {
        limits.solver = *solver;
        // uniform levels, then the adaptive meshes, which start from level 0
        for level in (0..options.uniform).map(Some).chain([None]) {
            if limits.interrupt.asked() {
                break;
            }
            let cases = match source.cases(level.unwrap_or(0), level.is_none()) {
                // the rows so far are worth more than the reason why the mesher stopped
                Err(_) if limits.interrupt.asked() && !rows.is_empty() => break,
                cases => cases?,
            };
            let tets = cases.first().map_or(0, |c| c.model.mesh.tets.len());
            if level > Some(0) && tets > ends.max_macro_tets {
                log.line(format!(
                    "no larger uniform mesh: it would have {tets} tets, at most {} are allowed",
                    ends.max_macro_tets
                ));
                continue;
            }
            refinement.adapt = level.is_none().then_some(ends);
            for case in cases {
                forget_peak();
                let until = limits.time.map_or(f64::INFINITY, |t| log.seconds() + t);
                let meshes = if level.is_none() { Meshes::Adaptive } else { Meshes::Uniform };
                // a mesh that does not fit into the memory is skipped
                let patterns = Patterns::default();
                let share = Share {
                    until,
                    both_within: f64::INFINITY,
                    first_stop: StopRules::on_mesh(refinement.refines()),
                    patterns: &patterns,
                    evidence: None,
                    decide: false,
                };
                let begun = Begun::new(case, true, share, refinement.coarser, limits, log);
                match begun.and_then(|b| b.end(until, &refinement, limits)) {
                    Ok(done) => rows.extend(study_rows(meshes, solver_name(*solver), &done.entry)),
                    Err(e) if rows.is_empty() => return Err(e),
                    Err(e) => log.line(format!("left out: {}", e.first().message)),
                }
            }
        }
    }
    Ok(Study { target_gap: ends.target_gap, rows })
}

fn solver_name(solver: Solver) -> &'static str {
    match solver {
        Solver::Condensed => "condensed",
        Solver::Clarabel => "clarabel",
    }
}
