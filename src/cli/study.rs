//! `bracket study`: speed against error, uniform and adaptive meshes and solvers side by side.

use super::spec_file::{self, SpecFile, top_level};
use crate::analysis::memory::forget_peak;
use crate::cli::{CommandResult, Common, Format, run};
use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::adaptive::{self, Share};
use crate::driver::aside::Folder;
use crate::driver::case::{
    AnalysisOptions, Case, Limits, RunContext, SolverChoice, file_stem, use_threads,
};
use crate::driver::remesh::{ByBisection, ByMap, Places};
use crate::mesh::gmsh::Mesher;
use crate::mesh::joint::MeshOptions;
use crate::mesh::{TetMesh, bisect, merge, msh};
use crate::model::file::{ModelFile, Nodes};
use crate::model::resolve::{load_model, resolve};
use crate::refine::plan;
use crate::report::console::log::Log;
use crate::report::console::out;
use crate::report::study::{MARK, Meshes, Study, study_rows};
use crate::solve::Patterns;
use crate::spec::analysis::AnalysisKind;
use crate::spec::analysis::AnalysisSpec;
use crate::spec::yaml;
use crate::text_file;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// Speed against error: a row for each mesh and solver, as table, CSV and plots.
#[derive(Debug, clap::Args)]
pub struct StudyArgs {
    /// Connection spec or model file.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Folder for the study (default: named after the input, with `_study`).
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Solvers to compare.
    #[arg(long, value_enum, value_delimiter = ',', default_values = ["condensed"])]
    pub solver: Vec<SolverChoice>,
    /// Uniform meshes, each about twice as large as the one before; 0: adaptive ones only.
    #[arg(long, value_name = "N", default_value_t = 3)]
    pub uniform: u32,
    /// Multiplies all element sizes of a spec's first mesh.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    pub size_factor: f64,
    /// Gap at which adaptive meshes end, a fraction (default: as the file says).
    #[arg(long, value_name = "GAP")]
    pub target_gap: Option<f64>,
    /// Tets at most, uniform meshes too (default: as the file says).
    #[arg(long, value_name = "N")]
    pub max_macro_tets: Option<usize>,
    /// Adaptive meshes at most (default: as the file says).
    #[arg(long, value_name = "N")]
    pub max_passes: Option<u32>,
    /// Memory the study may use in all, for example 8GiB (default: what the machine has left).
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    pub memory_limit: Option<String>,
}

/// Where the meshes come from.
trait Source {
    /// The load cases on the uniform mesh of a level, 0 being the first mesh; with `adaptive` they
    /// can be meshed again.
    fn cases(&self, level: u32, adaptive: bool) -> Result<Vec<Case<'_>>, Diagnostics>;
}

/// A connection spec.
struct Spec<'a> {
    input: &'a SpecFile,
    kinds: Vec<AnalysisKind>,
    options: MeshOptions,
    place: Places<'a>,
    log: &'a Log,
}

/// A model file and its mesh.
struct Model<'a> {
    name: String,
    file: ModelFile,
    mesh: TetMesh,
    place: Places<'a>,
}

/// Sizes of a level over those of the one before: twice the tets, about.
const FINER: f64 = 0.76;

impl Source for Spec<'_> {
    fn cases(&self, level: u32, adaptive: bool) -> Result<Vec<Case<'_>>, Diagnostics> {
        let start = Instant::now();
        let mut options = self.options.clone();
        options.sizes.factor *= FINER.powi(level as i32);
        let meshed = run::mesh(&options, self.input, self.log)?;
        let seconds = start.elapsed().as_secs_f64();
        let mut cases = run::cases(self.input, &meshed, &self.kinds, None, seconds)?;
        for case in cases.iter_mut().filter(|_| adaptive) {
            let kind = (case.name.clone(), case.model.analysis);
            let assembly = &self.input.joint.assembly;
            let by_map =
                ByMap::new(assembly, options.clone(), kind, self.place, meshed.mesh.clone());
            case.remesh = Some(Box::new(by_map.estimating(case.model.coulomb_estimate)));
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
            demand: None,
        }])
    }
}

/// Most uniform meshes: the last would be a thousand times the first.
const MOST_UNIFORM: u32 = 10;

fn check(args: &StudyArgs) -> Result<(), Diagnostics> {
    let wrong = |message: String, help: &str| {
        Err(Diagnostic::input("cli/value", message).help(help).into())
    };
    if args.uniform > MOST_UNIFORM {
        return wrong(
            format!("--uniform is {}, at most {MOST_UNIFORM} meshes are made", args.uniform),
            "3 to 5 tell a rate",
        );
    }
    if !(args.size_factor.is_finite() && (0.05..=20.0).contains(&args.size_factor)) {
        return wrong(
            format!("--size-factor is {}, it must be between 0.05 and 20", args.size_factor),
            "1 is the usual size",
        );
    }
    if let Some(g) = args.target_gap.filter(|g| !(*g > 0.0 && *g < 1.0)) {
        return wrong(
            format!("--target-gap is {g}, it must lie between 0 and 1"),
            "write a fraction such as 0.02",
        );
    }
    if args.max_passes == Some(0) {
        return wrong(
            "--max-passes is 0, it must be at least 1".into(),
            "leave the option out for what the file says",
        );
    }
    if args.max_macro_tets == Some(0) {
        return wrong(
            "--max-macro-tets is 0, it must be at least 1".into(),
            "leave the option out for what the file says",
        );
    }
    Ok(())
}

/// Runs `bracket study`.
pub fn run(args: &StudyArgs, common: &Common) -> CommandResult {
    check(args)?;
    let options = AnalysisOptions {
        out: None,
        solver: SolverChoice::Condensed,
        memory_limit: args.memory_limit.clone(),
        keep: false,
    };
    let mut limits = options.limits()?;
    use_threads(common)?;
    let text = text_file::read(&args.file, |e| {
        Diagnostic::input("study/read", format!("`{}` cannot be read: {e}", args.file.display()))
            .file(&args.file)
            .help("name a connection spec or a model file")
    })?;
    let stem =
        args.file.file_stem().map_or_else(|| "model".into(), |s| s.to_string_lossy().into_owned());
    let target =
        args.out.clone().unwrap_or_else(|| args.file.with_file_name(format!("{stem}_study")));
    let log = Arc::new(Log::new(common.quiet));
    let defaults = AnalysisSpec::default();
    let is_model = top_level(&text, "mesh") && top_level(&text, "bodies");
    let begin = |limits: &Limits| -> Result<Folder, Diagnostics> {
        let folder = Folder::new(&target, MARK, "study")?;
        limits.interrupt.begin(&log, WHEN_INTERRUPTED, folder.give_up());
        Ok(folder)
    };
    let (study, folder) = if is_model {
        // every check of the input first
        load_model(&args.file)?;
        let parsed = yaml::parse::<ModelFile>(&text, &args.file)?;
        let mut file = parsed.value.clone();
        let mut mesh = msh::read(&args.file.parent().unwrap_or(Path::new("")).join(&file.mesh))?;
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
        (study(args, &source, ends, &mut limits, &log)?, folder)
    } else {
        let input = spec_file::read(&args.file, None)?;
        let kinds = run::analysis_kinds(&input)?;
        run::check_names(&input, &kinds)?;
        run::check_preload(&input, &kinds)?;
        run::check_sizes(&input)?;
        let mesher = Mesher::find()?;
        let asked = &input.spec.value.analysis;
        limits.time = asked.time_limit.map(|t| t.0);
        let ends = plan::Limits {
            target_gap: asked.target_gap,
            max_passes: asked.max_passes,
            max_macro_tets: asked.max_macro_tets,
        };
        let folder = begin(&limits)?;
        let options = run::mesh_options(
            false,
            args.size_factor,
            &input,
            &mesher,
            &limits.interrupt,
            &folder.aside,
        );
        let place = |path: &str| input.spec.index.place(path);
        let source = Spec { input: &input, kinds, options, place: &place, log: &log };
        (study(args, &source, ends, &mut limits, &log)?, folder)
    };
    let any = study.rows.iter().any(|r| r.gap.is_some());
    study.write(&folder.aside)?;
    folder.finish()?;
    log.line(format!("study: {}", target.join("study.md").display()));
    match common.format {
        Format::Text => out::text(&study.markdown())?,
        Format::Json => out::json(&study.rows)?,
    }
    Ok(if any { 0 } else { 3 })
}

/// What the first Ctrl-C leads to.
const WHEN_INTERRUPTED: &str =
    "the mesh under way ends at its next iteration, and the rows so far are written";

/// All rows: for each solver the uniform meshes, then the adaptive ones.
fn study(
    args: &StudyArgs,
    source: &dyn Source,
    ends: plan::Limits,
    limits: &mut Limits,
    log: &Arc<Log>,
) -> Result<Study, Diagnostics> {
    let ends = plan::Limits {
        target_gap: args.target_gap.unwrap_or(ends.target_gap),
        max_passes: args.max_passes.unwrap_or(ends.max_passes),
        max_macro_tets: args.max_macro_tets.unwrap_or(ends.max_macro_tets),
    };
    let mut context =
        RunContext { finer: "", coarser: "a coarser first mesh", ..RunContext::default() };
    let mut rows = Vec::new();
    for solver in &args.solver {
        limits.solver = *solver;
        // uniform levels, then the adaptive meshes, which begin with the first level
        for level in (0..args.uniform).map(Some).chain([None]) {
            if limits.interrupt.asked() {
                break;
            }
            let cases = source.cases(level.unwrap_or(0), level.is_none())?;
            let tets = cases.first().map_or(0, |c| c.model.mesh.tets.len());
            if level > Some(0) && tets > ends.max_macro_tets {
                log.line(format!(
                    "no larger uniform mesh: {tets} tets, at most {} are wanted",
                    ends.max_macro_tets
                ));
                continue;
            }
            context.adapt = level.is_none().then_some(ends);
            for case in cases {
                forget_peak();
                let until = limits.time.map_or(f64::INFINITY, |t| log.seconds() + t);
                let meshes = if level.is_none() { Meshes::Adaptive } else { Meshes::Uniform };
                // a mesh that does not fit ends the study with what there is
                match adaptive::analyse(
                    case,
                    true,
                    &Share { until, patterns: &Patterns::default() },
                    &context,
                    limits,
                    log,
                ) {
                    Ok(done) => rows.extend(study_rows(meshes, solver_name(*solver), &done.entry)),
                    Err(e) if rows.is_empty() => return Err(e),
                    Err(e) => log.line(format!("left out: {}", e.first().message)),
                }
            }
        }
    }
    Ok(Study { target_gap: ends.target_gap, rows })
}

fn solver_name(solver: SolverChoice) -> &'static str {
    match solver {
        SolverChoice::Condensed => "condensed",
        SolverChoice::Clarabel => "clarabel",
    }
}
