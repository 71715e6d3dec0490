//! What `bracket run` and `bracket analyse` share: pass, result folder, report, last words.

use crate::analysis::engine::{self, PassOptions, Refusal};
use crate::analysis::memory::{Limit, room};
use crate::analysis::program_run::Program;
use crate::assembly::BoltLine;
use crate::certify::faces::contact_faces;
use crate::checks::HandChecks;
use crate::checks::verdict::{self, Verdict};
use crate::cli::Common;
use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::adaptive::{self, Adapted, Kept, Share};
use crate::driver::analysis_pass::AnalysisPass;
use crate::driver::conclude::{Analyses, certified, conclude};
use crate::driver::interrupt::Interrupt;
use crate::driver::memory_limit;
use crate::driver::polygon::Directions;
use crate::driver::remesh::Remesh;
use crate::mesh::msh_write;
use crate::model::AnalysisModel;
use crate::model::analysis::Traction;
use crate::model::file::ModelFile;
use crate::refine::plan;
use crate::report::console::log::Log;
use crate::report::console::progress;
use crate::report::draw::contact_map::contact_map;
use crate::report::draw::plot::{Plot, Series};
use crate::report::draw::polygon;
use crate::report::draw::raster::{PictureOptions, draw};
use crate::report::figures::{self, Rounding};
use crate::report::markdown::page::{CatalogueRow, ModelTraits, PictureRef, ResolvedValue, Table};
use crate::result::data::{CaseResult, HistoryRow, Quantity, ResultFile};
use crate::result::demand::{Demand, EndAction};
use crate::result::folder::ResultFolder;
use crate::result::forces::static_forces;
use crate::result::preload::mark_halved;
use crate::result::refusal::refusal_words;
use crate::result::stiffness::joint_stiffness;
use crate::solve::{Patterns, SolveOptions, Solver};
use crate::spec::analysis::AnalysisKind;
use crate::spec::polygon::PolygonSpec;
use crate::spec::yaml;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Which solver solves the conic programs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum SolverChoice {
    /// The condensed interior-point method: one sparse factor per iteration.
    #[default]
    Condensed,
    /// Clarabel, a general interior-point solver.
    Clarabel,
}

/// Options of an analysis.
#[derive(Clone, Debug, clap::Args)]
pub struct AnalysisOptions {
    /// Folder for the result (default: named after the input, beside it).
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Solver of the conic programs.
    #[arg(long, value_enum, default_value = "condensed")]
    pub solver: SolverChoice,
    /// Memory the run may use in all, for example 8GiB (default: what the machine has left).
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    pub memory_limit: Option<String>,
    /// Also keep the plain data that crosses each stage.
    #[arg(long)]
    pub keep: bool,
}

impl AnalysisOptions {
    /// The result folder for an input file.
    pub fn folder(&self, input: &Path) -> PathBuf {
        self.out.clone().unwrap_or_else(|| input.with_extension(""))
    }

    /// The limits of a run, as far as the options set them; a wrong option is refused. To be called
    /// before any thread starts: from here on the user's interrupts are heard.
    pub fn limits(&self) -> Result<Limits, Diagnostics> {
        let memory = self.memory_limit.as_deref().map(memory_limit::parse).transpose()?;
        Ok(Limits { solver: self.solver, time: None, memory, interrupt: Interrupt::watch()? })
    }
}

/// What the first Ctrl-C leads to.
pub const WHEN_INTERRUPTED: &str =
    "the mesher ends now, solves at their next iteration, and what is certified is written";

/// How a run is solved, and when it ends early.
pub struct Limits {
    /// The solver asked for.
    pub solver: SolverChoice,
    /// Wall time the run may take \[s\].
    pub time: Option<f64>,
    /// Memory the process may use \[bytes\].
    pub memory: Option<u64>,
    /// The user's wish to stop.
    pub interrupt: Interrupt,
}

/// Sets the number of threads, once.
pub fn use_threads(common: &Common) -> Result<(), Diagnostics> {
    let Some(n) = common.threads else { return Ok(()) };
    if !(1..=1024).contains(&n) {
        let d = Diagnostic::input(
            "cli/value",
            format!("--threads is {n}, it must be between 1 and 1024"),
        );
        return Err(d.help("leave the option out to use every processor").into());
    }
    // a second call in one process (tests) keeps the first pool
    let _ = rayon::ThreadPoolBuilder::new().num_threads(n).build_global();
    Ok(())
}

/// One load case ready to be analysed.
pub struct Case<'a> {
    /// Name, used in file names.
    pub name: String,
    /// The model.
    pub model: AnalysisModel,
    /// Its `MODEL.yaml`, written into the folder under this name.
    pub model_file: (String, ModelFile),
    /// What makes its further meshes; `None`: there are none.
    pub remesh: Option<Box<dyn Remesh + 'a>>,
    /// Seconds the mesh took, where this run made it.
    pub mesh_seconds: Option<f64>,
    /// Of a direction of the spec's polygon: both actions in their units.
    pub direction: Option<[f64; 2]>,
    /// The forces and moments that the loads demand of a joint; `None`: the loads are a model's,
    /// there is no demand.
    pub demand: Option<Vec<EndAction>>,
}

/// What the report says about the input.
#[derive(Clone, Debug, Default)]
pub struct RunContext {
    /// Title block.
    pub project: Vec<(String, String)>,
    /// Name of the input file.
    pub input_name: String,
    /// Its text.
    pub input_text: String,
    /// What was read from it, as YAML.
    pub input_read: String,
    /// Hash of everything the result depends on.
    pub input_hash: String,
    /// Resolved values.
    pub resolved: Vec<ResolvedValue>,
    /// Catalogue rows.
    pub catalogue_rows: Vec<CatalogueRow>,
    /// Mesh quality.
    pub mesh_quality: Table,
    /// Symmetry planes used (axes).
    pub mirror: Vec<usize>,
    /// Where adaptation ends; `None`: one mesh, and no gap is asked for.
    pub adapt: Option<plan::Limits>,
    /// How the user gets a finer mesh.
    pub finer: &'static str,
    /// How the user gets a coarser one.
    pub coarser: &'static str,
    /// Hand checks of the code.
    pub checks: HandChecks,
    /// Drawings as SVG text, with file name and caption.
    pub drawings: Vec<(PictureRef, String)>,
    /// Bolts and plates.
    pub schedule: Table,
    /// Where the bolts lie.
    pub bolts: Vec<BoltLine>,
    /// The polygon asked for.
    pub polygon: Option<PolygonSpec>,
}

/// The file name of an entry of a result: that of its case, with the kind of analysis where an
/// earlier entry has the same case.
pub fn entry_stem(earlier: &[CaseResult], entry: &CaseResult) -> String {
    stem_of(&entry.name, entry.analysis, earlier.iter().any(|c| c.name == entry.name))
}

/// The file name of a case; `again`: it was analysed in another way before.
pub fn stem_of(case: &str, analysis: AnalysisKind, again: bool) -> String {
    if again { format!("{}_{}", file_stem(case), analysis.word()) } else { file_stem(case) }
}

/// A file name made of a case's name, short enough for every file system.
pub fn file_stem(case: &str) -> String {
    case.chars()
        .take(100)
        .map(|c| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' })
        .collect()
}

/// Without any load the answer is zero and there is nothing to bracket: most likely a load was
/// forgotten.
fn refuse_idle(case: &Case) -> Result<(), Diagnostics> {
    let m = &case.model;
    let acts = m.surface_loads.iter().any(|l| match l.traction {
        Traction::Pressure(p) => p != 0.0,
        Traction::Linear { traction0, gradient } => {
            traction0 != [0.0; 3] || gradient != [[0.0; 3]; 3]
        }
    }) || m.body_loads.iter().any(|l| l.force != [0.0; 3])
        || m.rigid.iter().any(|r| r.action.iter().chain(&r.dead_action).any(|a| *a != 0.0))
        || m.has_preload();
    if acts {
        return Ok(());
    }
    Err(Diagnostic::input(
        "model/no-load",
        format!("nothing acts on the model of `{}`: every load is zero", case.name),
    )
    .path("loads")
    .help("give a load that is not zero")
    .into())
}

/// Analyses the cases, writes fields, result and report, prints the answer; returns the exit code.
pub fn finish(
    cases: Vec<Case>,
    context: RunContext,
    limits: &Limits,
    folder: ResultFolder,
    log: Arc<Log>,
    common: &Common,
) -> crate::driver::CommandResult {
    cases.iter().try_for_each(refuse_idle)?;
    let symmetry = cases.first().map_or(1, |c| c.model.symmetry);
    let mut context = context;
    let mut result = ResultFile::new(context.input_hash.clone(), symmetry, Verdict::None);
    let demanded = demanded(&cases);
    result.warnings.clone_from(&context.checks.notes);
    let mut pictures = Vec::new();
    let mut traits = ModelTraits { facets: true, symmetry: symmetry > 1, ..ModelTraits::default() };
    let mut notes: Vec<String> = Vec::new();
    let names: Vec<String> = cases.iter().map(|c| c.name.clone()).collect();
    let stems = stems(&cases);
    let mut directions = Directions::among(&cases, context.polygon.as_ref());
    // the first mesh is the same for all cases
    let patterns = Patterns::default();
    for (i, case) in cases.into_iter().enumerate() {
        if limits.interrupt.asked() && i > 0 {
            result
                .warnings
                .push(format!("interrupted: not analysed were {}", names[i..].join(", ")));
            break;
        }
        let contacts = contact_faces(&case.model);
        traits.contact |= !contacts.is_empty();
        traits.friction |= case.model.has_friction();
        traits.coulomb |= case.model.has_coulomb();
        traits.preload |= case.model.has_preload();
        traits.initial_gap |= contacts.iter().any(|f| !f.law.gap.is_zero());
        for note in &case.model.notes {
            if !notes.contains(note) {
                notes.push(note.clone());
            }
        }
        drop(contacts);
        let (file_name, file) = case.model_file.clone();
        let (demand, direction) = (case.demand.clone(), case.direction);
        let now = log.seconds();
        let until = limits
            .time
            .map_or(f64::INFINITY, |t| now + (t - now).max(0.0) / (names.len() - i) as f64);
        let Adapted { mut entry, upper, lower } = adaptive::analyse(
            case,
            i == 0,
            &Share { until, patterns: &patterns },
            &context,
            limits,
            &log,
        )?;
        let refused = |k: &Kept| k.outcome.runs().iter().any(|(_, run)| run.refusal.is_some());
        if refused(&upper) {
            entry.warnings.push(format!(
                "both bounds need {}, or more memory; `bounds` in a model file asks for one of \
                 them alone",
                context.coarser
            ));
        }
        if entry.quantity == Quantity::LoadFactor {
            let (lower, upper) = entry.safe_bounds();
            entry.utilisation = verdict::utilisation(lower, upper);
        }
        if let Some(actions) = demand.filter(|d| !d.is_empty()) {
            entry.demand = Some(Demand::new(&entry, certified(&entry), actions, &context.checks));
        }
        let best = lower.as_ref().unwrap_or(&upper);
        mark_halved(&mut entry.preload, &best.model, &context.mirror);
        let mut maps = Vec::new();
        if let Some((stress, factor)) =
            best.outcome.stress(&entry).filter(|_| !context.bolts.is_empty())
        {
            let forces =
                static_forces(&best.model, stress, factor, &context.bolts, &context.mirror);
            for pair in &forces.contacts {
                let Some(map) = contact_map(&best.model, stress, pair, &context.mirror) else {
                    continue;
                };
                let file =
                    format!("contact_{}_{}.svg", stems[i], file_stem(&pair.between.join("_")));
                folder.write(&file, map.as_bytes())?;
                let (between, factor) =
                    (pair.between.join(" on "), figures::significant(factor, 4, Rounding::Down));
                maps.push(PictureRef {
                    file,
                    caption: format!(
                        "Case {}: contact pressure of {between} at load factor {factor}",
                        names[i]
                    ),
                });
            }
            entry.static_forces = Some(forces);
        }
        entry.joint_stiffness = joint_stiffness(&entry, &context.checks.moments);
        let stem = &stems[i];
        if pictures.is_empty() {
            pictures.push(mesh_picture(&upper.model, &context.mirror, &folder)?);
            if let Some((_, _, quality)) = &upper.made {
                context.mesh_quality = quality.clone();
            }
        }
        let mesh_name =
            if names.len() == 1 { "mesh.msh".into() } else { format!("mesh_{stem}.msh") };
        write_model(&upper, &file, ["", &file_name, &mesh_name], &folder)?;
        upper.outcome.write_fields(&upper.model, stem, &folder, [true, lower.is_none()])?;
        if let Some(lower) = &lower {
            // the better lower bound is of another mesh: its model stands beside its field
            let [model, mesh] = ["yaml", "msh"].map(|kind| format!("{stem}_static.{kind}"));
            write_model(lower, &file, ["fields/", &model, &mesh], &folder)?;
            lower.outcome.write_fields(&lower.model, stem, &folder, [false, true])?;
        }
        pictures.extend(upper.outcome.picture(
            &names[i],
            &upper.model,
            &context.mirror,
            stem,
            &folder,
        )?);
        pictures.append(&mut maps);
        pictures.extend(convergence(&entry, context.adapt.map(|a| a.target_gap), stem, &folder)?);
        if let (Some(directions), Some(direction)) = (&mut directions, direction) {
            directions.add(direction, &entry, &upper);
        }
        result.cases.push(entry);
    }
    result.polygon = directions.and_then(Directions::polygon);
    if let Some(polygon) = &result.polygon {
        folder.write("polygon.svg", polygon::drawing(polygon).as_bytes())?;
        let [a, b] = polygon.axes.each_ref().map(|a| a.action.as_str());
        pictures.insert(
            0,
            PictureRef { file: "polygon.svg".into(), caption: format!("Capacity in {a} and {b}") },
        );
    }
    let complete = result.cases.len() == names.len();
    let interrupted = limits.interrupt.asked();
    let analyses = Analyses { demanded, complete, interrupted, pictures, traits, notes };
    conclude(result, context, analyses, folder, &log, common)
}

/// The load cases that demand something of the joint, with the kinds of analysis asked for.
fn demanded(cases: &[Case]) -> Vec<(String, Vec<AnalysisKind>)> {
    let mut out: Vec<(String, Vec<AnalysisKind>)> = Vec::new();
    for c in cases.iter().filter(|c| c.demand.as_ref().is_some_and(|d| !d.is_empty())) {
        match out.iter_mut().find(|(name, _)| *name == c.name) {
            Some((_, kinds)) => kinds.push(c.model.analysis),
            None => out.push((c.name.clone(), vec![c.model.analysis])),
        }
    }
    out
}

/// The file names of the cases: with the kind of analysis where an earlier case has the same name.
fn stems(cases: &[Case]) -> Vec<String> {
    let again = |i: usize| cases[..i].iter().any(|c| c.name == cases[i].name);
    cases.iter().enumerate().map(|(i, c)| stem_of(&c.name, c.model.analysis, again(i))).collect()
}

/// Writes the model file of a pass, and its mesh where it is not the first one, which stands in the
/// folder already.
fn write_model(
    pass: &Kept,
    first: &ModelFile,
    [place, file, mesh]: [&str; 3],
    folder: &ResultFolder,
) -> Result<(), Diagnostics> {
    let text = match &pass.made {
        Some((tets, model, _)) => {
            folder.write(&format!("{place}{mesh}"), msh_write::text(tets).as_bytes())?;
            yaml::to_string(&ModelFile { mesh: mesh.into(), ..model.clone() })?
        }
        // beside the fields the first mesh is one step up
        None if place.is_empty() => yaml::to_string(first)?,
        None => {
            yaml::to_string(&ModelFile { mesh: format!("../{}", first.mesh), ..first.clone() })?
        }
    };
    Ok(folder.write(&format!("{place}{file}"), text.as_bytes())?)
}

/// No program of a case fits into the memory.
pub fn too_large(name: &str, pass: &AnalysisPass, context: &RunContext) -> Diagnostic {
    let refused: Vec<(Program, Refusal)> =
        pass.runs().into_iter().filter_map(|(p, run)| Some((p, run.refusal?))).collect();
    let each =
        refused.iter().map(|(p, r)| format!("the {} program {}", p.name(), refusal_words(r)));
    let message =
        format!("`{name}` does not fit into the memory: {}", each.collect::<Vec<_>>().join("; "));
    let asked = refused.iter().any(|(_, r)| r.room.limit != Limit::Machine);
    let larger = if asked { ", a larger --memory-limit" } else { "" };
    Diagnostic::environment("run/memory", message).help(format!(
        "use {}{larger} or a machine with more memory; nothing was written",
        context.coarser
    ))
}

/// Runs both programs of a case on one mesh; `until`: seconds on the log's clock at which solves
/// end, `patterns`: what earlier passes on that mesh have found.
pub fn run_pass(
    name: &str,
    model: &AnalysisModel,
    until: f64,
    patterns: &Patterns,
    limits: &Limits,
    log: &Arc<Log>,
) -> Result<AnalysisPass, Diagnostics> {
    // one load case may be analysed in several ways
    let kind = match model.analysis {
        AnalysisKind::Limit => " (limit)",
        AnalysisKind::Elastoplastic => " (elastoplastic)",
        AnalysisKind::Elastic => "",
    };
    let name = format!("{name}{kind}");
    log.line(format!(
        "{}: {} tets, {} contact faces, {} part{}",
        name,
        model.mesh.tets.len(),
        contact_faces(model).len(),
        model.parts.len(),
        if model.parts.len() == 1 { "" } else { "s" }
    ));
    let solver = match limits.solver {
        SolverChoice::Condensed => Solver::Condensed,
        SolverChoice::Clarabel => Solver::Clarabel,
    };
    // what is left of the time asked for; a solve that cannot finish in it ends with status
    // `time limit`
    let left = (limits.time.unwrap_or(f64::INFINITY).min(until) - log.seconds()).max(0.0);
    let interrupt = Some(limits.interrupt.flag());
    let patterns = patterns.clone();
    let solve =
        SolveOptions { solver, time_limit: left, interrupt, patterns, ..SolveOptions::default() };
    let (told, name, tolerance) = (log.clone(), name, AnalysisPass::tolerance(model, &solve));
    let progress: engine::Progress =
        Arc::new(move |program, event| progress::note(&told, &name, tolerance, program, event));
    let memory = limits.memory;
    let options = PassOptions { solve, room: Arc::new(move || room(memory)) };
    AnalysisPass::run(model, &options, &progress).map_err(|e| Diagnostic::from(e).into())
}

pub(crate) fn png(picture: &crate::report::draw::Picture) -> Result<Vec<u8>, Diagnostics> {
    picture.to_png().map_err(|e| {
        Diagnostic::environment("report/picture", format!("the picture cannot be encoded: {e}"))
            .into()
    })
}

fn mesh_picture(
    model: &AnalysisModel,
    mirror: &[usize],
    folder: &ResultFolder,
) -> Result<PictureRef, Diagnostics> {
    let picture = draw(&model.mesh, &PictureOptions { mirror, ..PictureOptions::default() });
    folder.write("mesh.png", &png(&picture)?)?;
    let copies = if mirror.is_empty() { "" } else { ", completed by symmetry" };
    Ok(PictureRef {
        file: "mesh.png".into(),
        caption: format!("Mesh of {} tetrahedra{copies}", model.mesh.tets.len()),
    })
}

/// The gap against the size of the mesh, where there was more than one.
fn convergence(
    entry: &CaseResult,
    target: Option<f64>,
    stem: &str,
    folder: &ResultFolder,
) -> Result<Option<PictureRef>, Diagnostics> {
    let row = |h: &HistoryRow| Some([h.macro_tets as f64, 100.0 * h.gap?]);
    let points: Vec<[f64; 2]> = entry.history.iter().filter_map(row).collect();
    if points.len() < 2 {
        return Ok(None);
    }
    let plot = Plot {
        title: format!("{}: gap between the bounds, mesh after mesh", entry.name),
        x: "macro tets".into(),
        y: "gap [%]".into(),
        series: vec![Series { name: "adaptive".into(), points }],
        level: target.map(|t| (100.0 * t, "target".into())),
    };
    let file = format!("convergence_{stem}.png");
    folder.write(&file, &png(&plot.picture())?)?;
    Ok(Some(PictureRef {
        file,
        caption: format!("Case {}: gap against the size of the mesh", entry.name),
    }))
}

/// Values of a catalogue row as the report shows them.
pub fn catalogue_row(
    kind: &str,
    name: &str,
    row: serde_json::Value,
    source: String,
) -> CatalogueRow {
    let values = row.as_object().map_or(Vec::new(), |fields| {
        fields
            .iter()
            .filter(|(key, _)| {
                !["name", "size", "grade", "source", "series", "standard"].contains(&key.as_str())
            })
            .filter_map(|(key, v)| match v {
                serde_json::Value::Number(n) => Some((key.clone(), n.to_string())),
                serde_json::Value::String(s) => Some((key.clone(), s.clone())),
                serde_json::Value::Bool(b) => {
                    Some((key.clone(), if *b { "yes" } else { "no" }.into()))
                }
                _ => None,
            })
            .collect()
    });
    CatalogueRow { kind: kind.into(), name: name.into(), source, values, own: false }
}
