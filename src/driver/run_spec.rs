//! The analysis of a connection spec: geometry, mesh, cases, result.

use crate::driver::case::not_analysed;
use crate::driver::check_spec::checks_alone;
use crate::driver::demands::demands;
use crate::driver::finish::{Analyses, Finished, finish};
use crate::driver::input_hash::{checked_hash, spec_hash};
use crate::driver::limits::{Limits, WHEN_INTERRUPTED};
use crate::driver::meshing::{Extent, clean, find_mesher, mesh, mesh_options, quality_table};
use crate::driver::run_cases::run_cases;
use crate::driver::spec_cases::{asked_cases, cases, give_remesh};
use crate::driver::spec_checks::{analysis_kinds, check_input};
use crate::driver::spec_context::{spec_checks, spec_context};
use crate::driver::spec_file::{self, SpecFile};
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::yaml;
use bracket_codes::verdict::Verdict;
use bracket_codes::{Analysed, HandChecks, Status, Topic, judge};
use bracket_engine::mesh::msh_write;
use bracket_engine::model::AnalysisKind;
use bracket_engine::refine::plan;
use bracket_joint::geometry::Scene;
use bracket_joint::meshing::joint::JointMesh;
use bracket_joint::spec::polygon::PolygonSpec;
use bracket_report::console::log::Log;
use bracket_report::markdown::report_data::{GivenActions, ResolvedValue};
use bracket_report::result::folder::ResultFolder;
use bracket_report::result::result_file::ResultFile;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

/// Name of the kind of analysis among the values that the report resolves.
pub const KIND: &str = "analysis.kind";
/// Name of the factor on the element sizes among them.
pub const SIZE_FACTOR: &str = "mesh size factor";
/// Origin of what an option of the command line sets.
pub const COMMAND_LINE: &str = "command line";

/// Codes of the faults of a mesher that gave no mesh, or not even its version, in the time it had.
const OUT_OF_TIME: [&str; 2] = ["mesher/time", "mesher/version"];

/// The spec to analyse, and the options that override it.
#[derive(Clone, Debug)]
pub struct SpecRun {
    /// The spec's file.
    pub spec: PathBuf,
    /// Catalogue folder that takes precedence over that of the spec.
    pub catalog: Option<PathBuf>,
    /// Folder of the result.
    pub folder: PathBuf,
    /// Part of the joint that is meshed, and fineness of the mesh.
    pub extent: Extent,
    /// Kind of analysis, in place of `analysis.kind`.
    pub kind: Option<AnalysisKind>,
    /// Largest number of meshes, in place of `analysis.max_passes`.
    pub max_passes: Option<u32>,
    /// Also write the assembly and the mesher's script.
    pub keep: bool,
    /// Show nothing on standard error.
    pub quiet: bool,
}

/// Analyses a spec and writes its result folder. The spec sets the time limit.
pub fn run_spec(run: &SpecRun, mut limits: Limits) -> Result<Finished, Diagnostics> {
    run.extent.check()?;
    let input = spec_file::read(&run.spec, run.catalog.as_deref())?;
    let kinds = match run.kind {
        Some(kind) => vec![kind],
        None => analysis_kinds(&input)?,
    };
    check_input(&input, &kinds)?;
    let checks = spec_checks(&input);
    let asked = &input.spec.value.analysis;
    limits.time = asked.time_limit.map(|t| t.0);
    let log = Arc::new(Log::new(run.quiet));
    let polygon = run.polygon(&input);
    if asked_cases(&input, &kinds, polygon).is_empty() {
        let folder = ResultFolder::begin(&run.folder)?;
        limits.interrupt.begin_short(folder.give_up());
        input.store(&folder)?;
        log.line("nothing acts in any load case: there is nothing to analyse");
        return checks_alone(&run.spec, &input, checks, folder, &log);
    }
    let loads = &input.spec.value.loads;
    let judged = !demands(loads).is_empty();
    let out_of_time = |f: &Diagnostics| {
        let over = limits.time.is_some_and(|t| log.seconds() >= t);
        judged && over && OUT_OF_TIME.contains(&f.first().code)
    };
    let mesher = match find_mesher(&limits.interrupt, limits.time, &log) {
        Err(faults) if !out_of_time(&faults) => return Err(faults),
        mesher => mesher,
    };
    let folder = ResultFolder::begin(&run.folder)?;
    limits.interrupt.begin(&log, WHEN_INTERRUPTED, folder.give_up());
    input.store(&folder)?;
    input.catalog.warnings().iter().for_each(|w| log.line(spec_file::catalog_warning(w)));
    report_checks(&checks, &demands(loads), &log);
    let start = Instant::now();
    let asked_mesh = mesher.and_then(|mesher| {
        let flag = &limits.interrupt;
        let options = mesh_options(run.extent, &input, &kinds, &mesher, flag, folder.path());
        match mesh(&options, &input, &log) {
            Err(faults) if out_of_time(&faults) => clean(&options).and(Err(faults)),
            meshed => Ok((meshed?, options)),
        }
    });
    let (meshed, options) = match asked_mesh {
        Err(faults) if out_of_time(&faults) => {
            let unmeshed = Unmeshed { input: &input, kinds: &kinds, faults, checks };
            return unmeshed.finish(run, &limits, folder, &log);
        }
        found => found?,
    };
    let mesh_seconds = start.elapsed().as_secs_f64();
    let mesh_file = folder.path().join("mesh.msh");
    msh_write::write(&meshed.mesh, &mesh_file)?;
    if run.keep {
        keep(&input, &meshed, &folder)?;
    }
    let place = |path: &str| input.spec.index.place(path);
    let mut cases = cases(&input, &meshed, &kinds, polygon, mesh_seconds, &limits.interrupt)?;
    let max_passes = run.max_passes.unwrap_or(asked.max_passes);
    if max_passes > 1 {
        give_remesh(&mut cases, &input, &options, &meshed, &place);
    }
    limits.interrupt.check("meshing")?;
    let mut context = spec_context(&run.spec, &input, checks)?;
    context.input.project.push(("mesher".into(), format!("gmsh {}", meshed.mesher)));
    context.input.resolved.extend(run.overrides());
    let models =
        cases.iter().map(|c| yaml::to_string(&c.model_file.1)).collect::<Result<Vec<_>, _>>()?;
    context.input_hash = spec_hash(&input, &kinds, run.extent, &models);
    context.mesh_quality = quality_table(&meshed.quality);
    context.mirror = meshed.symmetry_used.iter().map(|p| p.axis).collect();
    context.adapt = Some(plan::Limits {
        target_gap: asked.target_gap,
        max_passes,
        max_macro_tets: asked.max_macro_tets,
    });
    context.polygon = polygon.cloned();
    run_cases(cases, context, &limits, folder, &log)
}

/// A run whose time ended before there was a mesh. The checks of the code still have a verdict.
struct Unmeshed<'a> {
    input: &'a SpecFile,
    kinds: &'a [AnalysisKind],
    /// Why there is no mesh.
    faults: Diagnostics,
    checks: HandChecks,
}

impl Unmeshed<'_> {
    /// Writes the result without analyses.
    fn finish(
        self,
        run: &SpecRun,
        limits: &Limits,
        folder: ResultFolder,
        log: &Log,
    ) -> Result<Finished, Diagnostics> {
        let Unmeshed { input, kinds, faults, checks } = self;
        let mut context = spec_context(&run.spec, input, checks)?;
        context.input.resolved.extend(run.overrides());
        context.input_hash = checked_hash(input)?;
        let symmetry = Scene::new(&input.joint.assembly, run.extent.full).copies();
        let mut result = ResultFile::new(context.input_hash.clone(), symmetry, Verdict::None);
        result.asked =
            asked_cases(input, kinds, run.polygon(input)).into_iter().map(|c| c.name).collect();
        result.warnings.clone_from(&context.checks.notes);
        result.warnings.push(not_analysed(&result.asked));
        result.warnings.push(faults.first().message.clone());
        let interrupt = limits.interrupt.clone();
        finish(result, context, Analyses { interrupt, ..Analyses::default() }, folder, log)
    }
}

impl SpecRun {
    /// The polygon to compute; a run without limit analysis has none.
    fn polygon<'s>(&self, input: &'s SpecFile) -> Option<&'s PolygonSpec> {
        let limit = matches!(self.kind, None | Some(AnalysisKind::Limit));
        input.spec.value.polygon.as_ref().filter(|_| limit)
    }

    /// What the command line sets in place of the spec.
    fn overrides(&self) -> Vec<ResolvedValue> {
        let factor = Some(self.extent.size_factor).filter(|f| *f != 1.0);
        [
            (KIND, self.kind.map(|k| k.word().to_string())),
            ("analysis.max_passes", self.max_passes.map(|n| n.to_string())),
            (SIZE_FACTOR, factor.map(|f| f.to_string())),
        ]
        .into_iter()
        .filter_map(|(name, value)| {
            let (name, origin) = (name.into(), COMMAND_LINE.into());
            Some(ResolvedValue { name, value: value?, unit: String::new(), origin })
        })
        .collect()
    }
}

/// Writes the data that pass between the stages: the assembly and the mesher's script.
fn keep(input: &SpecFile, meshed: &JointMesh, folder: &ResultFolder) -> Result<(), Diagnostics> {
    let text = serde_json::to_string_pretty(&input.joint).map_err(|e| {
        Diagnostic::environment("cli/keep", format!("the assembly cannot be written: {e}"))
    })?;
    folder.write("joint.json", text.as_bytes())?;
    folder.write("joint.geo", meshed.geo.as_bytes())?;
    Ok(())
}

/// Reports the hand checks before meshing starts: faults of the detailing, and the verdict by code
/// alone.
fn report_checks(hand: &HandChecks, demands: &[GivenActions], log: &Log) {
    for c in hand.checks.iter().filter(|c| c.topic == Topic::Detailing) {
        match c.status {
            Status::Failed => log.line(format!("check failed: {}", c.sentence())),
            Status::Warning => log.line(format!("detailing: {}", c.sentence())),
            Status::Ok | Status::Information | Status::Undecided => {}
        }
    }
    if demands.is_empty() {
        return;
    }
    let alone: Vec<Analysed> = demands.iter().map(|d| Analysed::not(d.case.clone())).collect();
    let (judgement, _) = judge(&mut hand.clone(), &alone);
    log.line(format!("by code alone: {}: {}", judgement.verdict.words(), judgement.reason));
}
