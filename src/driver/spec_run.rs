//! The analysis of a connection spec: geometry, mesh, cases, verdict.

use crate::driver::case::{Case, not_analysed};
use crate::driver::check_spec::{report_detailing, unanalysed};
use crate::driver::combinations::{Wanted, solve_combinations};
use crate::driver::demands::demands;
use crate::driver::input_hash::spec_hash;
use crate::driver::judge::{Judged, by_code};
use crate::driver::limits::{Limits, WHEN_INTERRUPTED};
use crate::driver::meshing::{clean, find_mesher, mesh, mesh_options};
use crate::driver::overrides::Overrides;
use crate::driver::remesh::Places;
use crate::driver::setup::{Refinement, RunSetup};
use crate::driver::solve::solve;
use crate::driver::solved::{NoFiles, RunSink, Solved};
use crate::driver::spec_cases::{AskedCase, asked_cases, case, cases, give_remesh};
use crate::driver::spec_checks::{analysis_kinds, check_input};
use crate::driver::spec_context::spec_checks;
use crate::driver::spec_file::{SpecFile, catalog_warning};
use crate::driver::spec_input::SpecInput;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::yaml;
use bracket_codes::HandChecks;
use bracket_codes::route::RouteFacts;
use bracket_codes::verdict::Verdict;
use bracket_engine::mesh::gmsh::Mesher;
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::file::ModelFile;
use bracket_engine::refine::plan;
use bracket_joint::geometry::Scene;
use bracket_joint::meshing::joint::{JointMesh, MeshOptions};
use bracket_joint::spec::polygon::PolygonSpec;
use bracket_report::console::log::Log;
use bracket_report::markdown::report_data::GivenActions;
use bracket_report::result::evidence::EvidencePlan;
use bracket_report::result::result_file::CaseResult;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// Codes of the faults of a mesher that gave no mesh, or not even its version, in the time it had.
const OUT_OF_TIME: [&str; 2] = ["mesher/time", "mesher/version"];

/// A spec whose joint is analysed.
pub struct Ran {
    /// The spec with its joint and its catalogue.
    pub input: SpecFile,
    /// The checks of the code, with the notes of the joint.
    pub checks: HandChecks,
    /// The result with bounds, demands and verdict, as `bracket run` writes it.
    pub judged: Judged,
    /// Version of the mesher; `None` if there is no mesh.
    pub mesher: Option<String>,
}

impl Ran {
    /// The verdict by code and by analysis.
    pub fn verdict(&self) -> Verdict {
        self.judged.result.verdict
    }

    /// The cases with their bounds.
    pub fn cases(&self) -> &[CaseResult] {
        &self.judged.result.cases
    }
}

/// Analyses the joint of a spec: mesh, lower and upper bounds of each load case, checks by code and
/// verdict. It starts the mesher as a process that works in a temporary folder, leaves no file and
/// prints nothing. `progress` gets every line of the log, from any thread. The run ends early at
/// the limits of `limits` or at `time_limit` of the spec, whichever comes first; what is certified
/// until then is in the result.
///
/// It needs the mesher and takes minutes:
///
/// ```no_run
/// use bracket::{Limits, SpecInput};
/// use std::path::Path;
///
/// let spec = SpecInput::read(Path::new("examples/one_sided_stiffened/joint.yaml"))?;
/// let ran = bracket::run(&spec, &Limits::default(), |line| eprintln!("{line}"))?;
/// for case in ran.cases() {
///     println!("{}: {:?} to {:?}", case.name, case.lower, case.upper);
/// }
/// # Ok::<(), bracket::diag::Diagnostics>(())
/// ```
pub fn run(
    spec: &SpecInput,
    limits: &Limits,
    progress: impl Fn(&str) + Send + Sync + 'static,
) -> Result<Ran, Diagnostics> {
    let input = spec.open()?;
    let log = Arc::new(Log::to(progress));
    let run = SpecRun::new(&spec.overrides, input, limits, &log)?;
    let scratch = tempfile::tempdir().map_err(|e| {
        Diagnostic::environment("run/scratch", format!("no temporary folder for the mesher: {e}"))
            .help("set TMPDIR to a folder in which files can be written")
    })?;
    let left = scratch.path().to_path_buf();
    limits.interrupt.begin(&log, WHEN_INTERRUPTED, move || _ = std::fs::remove_dir_all(&left));
    let ran = run.end(scratch.path(), &mut NoFiles, &log);
    limits.interrupt.pause();
    ran
}

/// A spec that is ready to be analysed.
pub struct SpecRun<'s> {
    overrides: &'s Overrides,
    /// The spec with its joint.
    pub input: SpecFile,
    kinds: Vec<AnalysisKind>,
    checks: HandChecks,
    demands: Vec<GivenActions>,
    limits: Limits,
    /// The mesher, or why it did not answer in time; `None` if there is nothing to analyse.
    mesher: Option<Result<Mesher, Diagnostics>>,
}

impl<'s> SpecRun<'s> {
    /// Checks a spec before its analysis, and looks for the mesher.
    pub fn new(
        overrides: &'s Overrides,
        input: SpecFile,
        limits: &Limits,
        log: &Arc<Log>,
    ) -> Result<Self, Diagnostics> {
        overrides.extent.check()?;
        let kinds = match overrides.kind {
            Some(kind) => input.kinds_for(kind),
            None => analysis_kinds(&input)?,
        };
        check_input(&input, &kinds)?;
        let checks = spec_checks(&input);
        let limits = limits.within(input.spec.value.analysis.time_limit.map(|t| t.0));
        let demands = demands(&input.spec.value.loads);
        let mut run = Self { overrides, input, kinds, checks, demands, limits, mesher: None };
        if !asked_cases(&run.input, &run.kinds, run.polygon()).is_empty() {
            run.mesher = match find_mesher(&run.limits.interrupt, run.limits.time, log) {
                Err(faults) if !run.out_of_time(&faults, log) => return Err(faults),
                mesher => Some(mesher),
            };
        }
        Ok(run)
    }

    /// True if nothing acts in any load case.
    pub fn is_idle(&self) -> bool {
        self.mesher.is_none()
    }

    /// The polygon to compute; a run without limit analysis has none.
    fn polygon(&self) -> Option<&PolygonSpec> {
        self.input.spec.value.polygon.as_ref().filter(|_| self.overrides.allow_limit())
    }

    /// True if the time of the run ended before there was a mesh, and the checks of the code have a
    /// verdict without it.
    fn out_of_time(&self, faults: &Diagnostics, log: &Log) -> bool {
        let over = self.limits.time.is_some_and(|t| log.seconds() >= t);
        !self.demands.is_empty() && over && OUT_OF_TIME.contains(&faults.first().code)
    }

    /// Meshes the joint below `place`, solves the cases and judges them.
    pub fn end(
        mut self,
        place: &Path,
        sink: &mut dyn RunSink,
        log: &Arc<Log>,
    ) -> Result<Ran, Diagnostics> {
        let (solved, mesher) = match self.mesher.take() {
            None => {
                log.line("nothing acts in any load case: there is nothing to analyse");
                (unanalysed(&self.input, &self.checks, 1)?, None)
            }
            Some(mesher) => {
                self.input.catalog.warnings().iter().for_each(|w| log.line(catalog_warning(w)));
                self.report_checks(log);
                self.analyse(mesher, place, sink, log)?
            }
        };
        let facts = RouteFacts::of(&self.input.joint);
        let judged = solved.judge(&self.checks, Some(&facts), &self.demands);
        Ok(Ran { input: self.input, checks: self.checks, judged, mesher })
    }

    /// Meshes the joint and solves the cases. Returns the version of the mesher too.
    fn analyse(
        &self,
        mesher: Result<Mesher, Diagnostics>,
        place: &Path,
        sink: &mut dyn RunSink,
        log: &Arc<Log>,
    ) -> Result<(Solved, Option<String>), Diagnostics> {
        let (input, limits) = (&self.input, &self.limits);
        let start = Instant::now();
        let asked_mesh = mesher.and_then(|mesher| {
            let (extent, flag) = (self.overrides.extent, &limits.interrupt);
            let options = mesh_options(extent, input, &self.kinds, &mesher, flag, place);
            match mesh(&options, input, log) {
                Err(faults) if self.out_of_time(&faults, log) => clean(&options).and(Err(faults)),
                meshed => Ok((meshed?, options)),
            }
        });
        let (meshed, options) = match asked_mesh {
            Err(faults) if self.out_of_time(&faults, log) => {
                return Ok((self.unmeshed(&faults)?, None));
            }
            found => found?,
        };
        let mesh_seconds = start.elapsed().as_secs_f64();
        sink.meshed(input, &meshed)?;
        let solved = self.solve_on(&meshed, &options, mesh_seconds, sink, log)?;
        Ok((solved, Some(meshed.mesher)))
    }

    /// Solves the cases on the mesh of the joint and on those that follow from it.
    fn solve_on(
        &self,
        meshed: &JointMesh,
        options: &MeshOptions,
        mesh_seconds: f64,
        sink: &mut dyn RunSink,
        log: &Arc<Log>,
    ) -> Result<Solved, Diagnostics> {
        let (input, limits, kinds) = (&self.input, &self.limits, &self.kinds);
        let place = |path: &str| input.spec.index.place(path);
        if input.covers(kinds) {
            let asked = asked_cases(input, kinds, None);
            let file = |a: &AskedCase| a.model_file(input, &meshed.mesh, &meshed.symmetry_used);
            let by_code = |case: &str| {
                let of = self.checks.checks.iter().filter(|c| c.case.as_deref() == Some(case));
                of.filter_map(|c| c.utilisation).fold(0.0, f64::max)
            };
            let wanted: Vec<Wanted> = asked
                .iter()
                .map(|a| Wanted {
                    name: a.of.case.clone(),
                    file: file(a),
                    by_code: by_code(&a.of.case),
                })
                .collect();
            limits.interrupt.check("meshing")?;
            let setup = self.setup(meshed, wanted.iter().map(|w| &w.file))?;
            let make = |name: &str, file: ModelFile, first: bool| {
                let asked = AskedCase::limit(input, name);
                let mut cases = [case(input, meshed, (asked, file), first, mesh_seconds)?];
                self.give_remesh(&mut cases, (meshed, options), &place, log);
                let [case] = cases;
                Ok(case)
            };
            return solve_combinations(&wanted, &make, &setup, (limits, log), sink);
        }
        let polygon = self.polygon();
        let mut cases = cases(input, meshed, kinds, polygon, mesh_seconds, &limits.interrupt)?;
        self.give_remesh(&mut cases, (meshed, options), &place, log);
        limits.interrupt.check("meshing")?;
        let setup = self.setup(meshed, cases.iter().map(|c| &c.model_file.1))?;
        solve(cases, &setup, limits, sink, log)
    }

    /// Lets the cases make further meshes, if the run may have some.
    fn give_remesh<'a>(
        &'a self,
        cases: &mut [Case<'a>],
        (meshed, options): (&JointMesh, &MeshOptions),
        place: Places<'a>,
        log: &Log,
    ) {
        if self.max_passes() > 1 {
            let interrupt = &self.limits.interrupt;
            give_remesh(cases, &self.input, options, meshed, place, (interrupt, log));
        }
    }

    /// Meshes of a case at most.
    fn max_passes(&self) -> u32 {
        self.overrides.max_passes.unwrap_or(self.input.spec.value.analysis.max_passes)
    }

    /// What the cases with these model files on the first mesh share.
    fn setup<'f>(
        &self,
        meshed: &JointMesh,
        files: impl Iterator<Item = &'f ModelFile>,
    ) -> Result<RunSetup, Diagnostics> {
        let (input, asked) = (&self.input, &self.input.spec.value.analysis);
        let models = files.map(yaml::to_string).collect::<Result<Vec<_>, _>>()?;
        Ok(RunSetup {
            input_hash: spec_hash(input, &self.kinds, self.overrides.extent, &models),
            warnings: self.checks.notes.clone(),
            mirror: meshed.symmetry_used.iter().map(|p| p.axis).collect(),
            bolts: input.joint.bolts.clone(),
            evidence: input
                .elastic_bolts(AnalysisKind::Elastoplastic)
                .then(|| EvidencePlan::new(&input.joint, &meshed.symmetry_used)),
            load_steps: asked.load_steps.clone(),
            decide: input.decide,
            polygon: self.polygon().cloned(),
            refinement: Refinement {
                adapt: Some(plan::Limits {
                    target_gap: asked.target_gap,
                    max_passes: self.max_passes(),
                    max_macro_tets: asked.max_macro_tets,
                }),
                finer: "a smaller `--size-factor` or `analysis.mesh.size`",
                coarser: "a coarser mesh (`--size-factor` above 1, or a larger \
                          `analysis.mesh.size`)",
            },
        })
    }

    /// A run whose time ended before there was a mesh. The checks of the code still have a verdict.
    fn unmeshed(&self, faults: &Diagnostics) -> Result<Solved, Diagnostics> {
        let symmetry = Scene::new(&self.input.joint.assembly, self.overrides.extent.full).copies();
        let mut solved = unanalysed(&self.input, &self.checks, symmetry)?;
        let result = &mut solved.result;
        let asked = asked_cases(&self.input, &self.kinds, self.polygon());
        result.asked = asked.into_iter().map(|c| c.of.case).collect();
        result.warnings.push(not_analysed(&result.asked));
        result.warnings.push(faults.first().message.clone().into());
        Ok(solved)
    }

    /// Reports the hand checks before meshing starts: faults of the detailing, and the verdict by
    /// code alone.
    fn report_checks(&self, log: &Log) {
        report_detailing(&self.checks.checks, log);
        if self.demands.is_empty() {
            return;
        }
        let (judgement, _) = by_code(&mut self.checks.clone(), &self.demands);
        log.line(format!("by code alone: {}: {}", judgement.verdict.words(), judgement.reason));
    }
}
