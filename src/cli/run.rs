//! `bracket run`: connection spec → geometry → mesh → dual analyses → bracket and report.

use super::analyse::quality_table;
use super::spec_file::{self, CatalogOptions, SpecFile};
use super::{CommandResult, Common};
use crate::assembly::assembly::PartRole;
use crate::checks::check::number;
use crate::checks::end_plate::{grip, moment_axial, stocked_length};
use crate::checks::{Analysed, HandChecks, Status, Topic, hand_checks, judge};
use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::case::{
    AnalysisOptions, Case, RunContext, WHEN_INTERRUPTED, catalogue_row, file_stem, finish, stem_of,
    use_threads,
};
use crate::driver::interrupt::Interrupt;
use crate::driver::remesh::{self, ByMap};
use crate::mesh::gmsh::Mesher;
use crate::mesh::joint::{JointMesh, MeshOptions, mesh_joint};
use crate::mesh::msh_write;
use crate::model::from_joint;
use crate::model::resolve::resolve;
use crate::refine::plan;
use crate::report::console::log::Log;
use crate::report::draw::{drawing, moment_axial};
use crate::report::markdown::page::{CatalogueRow, PictureRef, ResolvedValue};
use crate::report::markdown::schedule;
use crate::result::data::input_hash;
use crate::result::demand::{ActionValue, EndAction};
use crate::result::folder::ResultFolder;
use crate::spec::analysis::AnalysisKind;
use crate::spec::connection::ConnectionSpec;
use crate::spec::loads::LoadSpec;
use crate::spec::polygon::PolygonSpec;
use crate::spec::yaml;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Connection spec → geometry → mesh → dual analyses → bracket and report.
#[derive(Debug, clap::Args)]
pub struct RunArgs {
    /// Connection spec (`bracket new TEMPLATE` writes a starter).
    #[arg(value_name = "SPEC")]
    pub spec: PathBuf,
    /// Analyse the whole joint, even if it is symmetric.
    #[arg(long)]
    pub full: bool,
    /// Multiplies all element sizes: 0.5 gives about five times the elements.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    pub size_factor: f64,
    /// Kind of analysis, in place of `analysis.kind`.
    #[arg(long, value_enum)]
    pub kind: Option<AnalysisKind>,
    /// Meshes at most, in place of `analysis.max_passes`: 1 is a quick look.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=50))]
    pub max_passes: Option<u32>,
    /// Catalogue of the user's own.
    #[command(flatten)]
    pub catalog: CatalogOptions,
    /// Options of the analysis.
    #[command(flatten)]
    pub options: AnalysisOptions,
}

impl clap::ValueEnum for AnalysisKind {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Elastic, Self::Elastoplastic, Self::Limit]
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        let help = match self {
            Self::Elastic => "Energy and displacement of the elastic joint",
            Self::Elastoplastic => {
                "Energy of the elastic, perfectly plastic joint under the given load"
            }
            Self::Limit => "Load at collapse",
        };
        Some(clap::builder::PossibleValue::new(self.word()).help(help))
    }
}

/// Runs `bracket run`.
pub fn run(args: &RunArgs, common: &Common) -> CommandResult {
    if !(args.size_factor.is_finite() && (0.05..=20.0).contains(&args.size_factor)) {
        let text = format!("--size-factor is {}, it must be between 0.05 and 20", args.size_factor);
        let help = "1 is the usual size; 0.7 takes about twice the elements, 1.4 half of them";
        return Err(Diagnostic::input("cli/value", text).help(help).into());
    }
    let mut limits = args.options.limits()?;
    use_threads(common)?;
    let input = spec_file::read(&args.spec, args.catalog.folder())?;
    let kinds = match args.kind {
        Some(kind) => vec![kind],
        None => analysis_kinds(&input)?,
    };
    check_names(&input, &kinds)?;
    check_preload(&input, &kinds)?;
    check_sizes(&input)?;
    let mut checks = input.joint.end_plate.as_ref().map(hand_checks).unwrap_or_default();
    checks.notes.extend(input.joint.notes.iter().cloned());
    let mesher = Mesher::find()?;
    limits.time = input.spec.value.analysis.time_limit.map(|t| t.0);
    let log = Arc::new(Log::new(common.quiet));
    let folder = ResultFolder::begin(&args.options.folder(&args.spec))?;
    limits.interrupt.begin(&log, WHEN_INTERRUPTED, folder.give_up());
    input.catalog.warnings().iter().for_each(|w| log.line(spec_file::catalog_warning(w)));
    tell(&checks, demanded_cases(&input), &log);
    let start = Instant::now();
    let options = mesh_options(
        args.full,
        args.size_factor,
        &input,
        &mesher,
        &limits.interrupt,
        folder.path(),
    );
    let meshed = mesh(&options, &input, &log)?;
    let mesh_seconds = start.elapsed().as_secs_f64();
    let mesh_file = folder.path().join("mesh.msh");
    msh_write::write(&meshed.mesh, &mesh_file)?;
    if args.options.keep {
        let text = serde_json::to_string_pretty(&input.joint).map_err(|e| {
            Diagnostic::environment("cli/keep", format!("the assembly cannot be written: {e}"))
        })?;
        folder.write("joint.json", text.as_bytes())?;
        folder.write("joint.geo", meshed.geo.as_bytes())?;
    }
    let place = |path: &str| input.spec.index.place(path);
    // a quick look that leaves out collapse leaves out the polygon
    let polygon = input
        .spec
        .value
        .polygon
        .as_ref()
        .filter(|_| matches!(args.kind, None | Some(AnalysisKind::Limit)));
    let mut cases = cases(&input, &meshed, &kinds, polygon, mesh_seconds)?;
    let asked = &input.spec.value.analysis;
    let max_passes = args.max_passes.unwrap_or(asked.max_passes);
    if max_passes > 1 {
        // the directions of a polygon share the first mesh
        for case in cases.iter_mut().filter(|c| c.direction.is_none()) {
            let kind = (case.name.clone(), case.model.analysis);
            let by_map = ByMap::new(
                &input.joint.assembly,
                options.clone(),
                kind,
                &place,
                meshed.mesh.clone(),
            );
            case.remesh = Some(Box::new(by_map.estimating(case.model.coulomb_estimate)));
        }
    }
    limits.interrupt.check("meshing")?;
    let mut context = run_context(&args.spec, &input, checks)?;
    context.project.push(("mesher".into(), format!("gmsh {}", meshed.mesher)));
    // the models hold what the catalogue and the template gave, the script what the mesher was told
    let mut pieces: Vec<(&str, &[u8])> =
        vec![("spec", input.text.as_bytes()), ("geo", meshed.geo.as_bytes())];
    let models =
        cases.iter().map(|c| yaml::to_string(&c.model_file.1)).collect::<Result<Vec<_>, _>>()?;
    pieces.extend(models.iter().map(|m| ("model", m.as_bytes())));
    let own = own_rows(&context);
    if !own.is_empty() {
        pieces.push(("catalogue", own.as_bytes()));
    }
    context.input_hash = input_hash(&pieces);
    context.mesh_quality = quality_table(&meshed.quality);
    context.mirror = meshed.symmetry_used.iter().map(|p| p.axis).collect();
    context.adapt = Some(plan::Limits {
        target_gap: asked.target_gap,
        max_passes,
        max_macro_tets: asked.max_macro_tets,
    });
    context.polygon = polygon.cloned();
    finish(cases, context, &limits, folder, log, common)
}

/// What a report says of a spec, without meshes.
pub fn run_context(
    path: &Path,
    input: &SpecFile,
    checks: HandChecks,
) -> Result<RunContext, Diagnostics> {
    let project = &input.spec.value.project;
    let title = project.title.clone().filter(|t| !t.trim().is_empty());
    let stem =
        || path.file_stem().map_or_else(|| "joint".into(), |s| s.to_string_lossy().into_owned());
    let mut block = vec![("title".to_string(), title.unwrap_or_else(stem))];
    for (name, value) in [
        ("number", &project.number),
        ("author", &project.author),
        ("checker", &project.checker),
        ("date", &project.date),
        ("revision", &project.revision),
    ] {
        block.extend(value.clone().map(|v| (name.to_string(), v)));
    }
    let end_plate = input.joint.end_plate.as_ref();
    Ok(RunContext {
        project: block,
        input_name: path.file_name().map_or_else(String::new, |s| s.to_string_lossy().into_owned()),
        input_text: input.text.clone(),
        input_read: yaml::to_string(&as_read(input))?,
        resolved: resolved_values(input),
        catalogue_rows: catalogue_rows(input),
        finer: "`--size-factor` below 1, or a smaller `analysis.mesh.size`",
        coarser: "a coarser mesh (`--size-factor` above 1, or a larger `analysis.mesh.size`)",
        checks,
        drawings: drawings(input),
        schedule: end_plate.map_or_else(Default::default, |e| {
            schedule::schedule(e, plates(input), stocked_length(e), grip(e))
        }),
        bolts: input.joint.bolts.clone(),
        ..RunContext::default()
    })
}

/// Rows that are not the program's own: what of them only the hand checks read stands in no model.
fn own_rows(context: &RunContext) -> String {
    context
        .catalogue_rows
        .iter()
        .filter(|r| r.own)
        .map(|r| format!("{}: {:?}\n", r.name, r.values))
        .collect()
}

/// The spec without the loads that only its polygon made.
fn as_read(input: &SpecFile) -> ConnectionSpec {
    let mut spec = input.spec.value.clone();
    spec.loads.retain(|l| !l.of_polygon);
    spec
}

/// End plates of the joint.
fn plates(input: &SpecFile) -> usize {
    input.joint.assembly.parts.iter().filter(|p| p.role == PartRole::Plate).count()
}

/// Drawings of what the hand checks see, and of the actions at the member ends.
fn drawings(input: &SpecFile) -> Vec<(PictureRef, String)> {
    let Some(e) = &input.joint.end_plate else { return Vec::new() };
    let picture = |file: &str, caption: &str, text| {
        (PictureRef { file: file.into(), caption: caption.into() }, text)
    };
    let views = drawing::views(e, plates(input), stocked_length(e));
    let mut out =
        vec![picture("drawing.svg", "Side view of the joint, front view of the end plate", views)];
    for (i, diagram) in moment_axial(e).iter().enumerate() {
        let file =
            if i == 0 { "moment_axial.svg".into() } else { format!("moment_axial_{}.svg", i + 1) };
        let beta = if e.column.is_some() {
            format!(", β = {}", number(diagram.beta))
        } else {
            String::new()
        };
        let caption =
            format!("Moment and axial force that the joint carries by the component method{beta}");
        out.push(picture(&file, &caption, moment_axial::drawing(diagram)));
    }
    if !e.actions.is_empty() {
        let caption =
            "Actions at the member ends with their positive senses, values at the bolt plane";
        out.push(picture("actions.svg", caption, drawing::actions(e)));
    }
    out
}

/// The load cases with actions at member ends: each is a demand.
pub fn demanded_cases(input: &SpecFile) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for load in input.spec.value.loads.iter().filter(|l| !l.of_polygon && l.end.is_some()) {
        if !out.contains(&load.name) {
            out.push(load.name.clone());
        }
    }
    out
}

/// What the code says, before anything is meshed: faults of the detailing, and the verdict by code
/// alone.
fn tell(hand: &HandChecks, cases: Vec<String>, log: &Log) {
    for c in hand.checks.iter().filter(|c| c.topic == Topic::Detailing) {
        match c.status {
            Status::Failed => log.line(format!("check failed: {}", c.sentence())),
            Status::Warning => log.line(format!("detailing: {}", c.sentence())),
            Status::Ok | Status::Information | Status::Undecided => {}
        }
    }
    if cases.is_empty() {
        return;
    }
    let alone: Vec<Analysed> = cases.into_iter().map(Analysed::not).collect();
    let (judgement, _) = judge(&mut hand.clone(), &alone);
    log.line(format!("by code alone: {}: {}", judgement.verdict.words(), judgement.reason));
}

/// The kinds of analysis asked for, if this version has them.
pub fn analysis_kinds(input: &SpecFile) -> Result<Vec<AnalysisKind>, Diagnostics> {
    let place = |path: &str| input.spec.index.place(path);
    let kinds = &input.spec.value.analysis.kind.0;
    let mut wanted = Vec::new();
    for &kind in kinds {
        if wanted.contains(&kind) {
            let mut d =
                Diagnostic::input("spec/value", "`analysis.kind` names the same kind twice")
                    .help("name each kind once: `kind: [elastic, limit]`");
            d.place = place("analysis.kind");
            return Err(d.into());
        }
        wanted.push(kind);
    }
    Ok(wanted)
}

/// Preload and bodies that yield are not analysed together yet: told before the mesher starts.
pub fn check_preload(input: &SpecFile, kinds: &[AnalysisKind]) -> Result<(), Diagnostics> {
    if input.joint.assembly.preloads.is_empty() || !kinds.contains(&AnalysisKind::Elastoplastic) {
        return Ok(());
    }
    let message =
        "preload in an elastic, perfectly plastic analysis is not available yet in this version";
    let help = "take `kind: elastic`, where the preload acts, or `limit`, where it drops out; or \
                `preload: none`";
    let mut d = Diagnostic::input("model/unavailable", message).help(help);
    d.place = input.spec.index.place("bolts.preload");
    Err(d.into())
}

/// Load cases become names of files: they must have one, and a different one each.
pub fn check_names(input: &SpecFile, kinds: &[AnalysisKind]) -> Result<(), Diagnostics> {
    let loads = &input.spec.value.loads;
    let stems = |name: &str| -> Vec<String> {
        kinds.iter().enumerate().map(|(k, kind)| stem_of(name, *kind, k > 0)).collect()
    };
    for (i, load) in loads.iter().enumerate() {
        let (stem, mine) = (file_stem(&load.name), stems(&load.name));
        let clash =
            |o: &&LoadSpec| o.name != load.name && stems(&o.name).iter().any(|s| mine.contains(s));
        let other = loads[..i].iter().find(clash);
        let message = match other {
            Some(o) => format!(
                "the load cases `{}` and `{}` would write the same files `{stem}_…`",
                o.name, load.name
            ),
            None if stem.is_empty() => "the name of a load case is empty".to_string(),
            None => continue,
        };
        let mut d = Diagnostic::input("spec/value", message)
            .help("give each load case a name of letters and digits");
        d.place = input.spec.index.place(&format!("loads[{i}].name"));
        return Err(d.into());
    }
    Ok(())
}

/// A case without load has nothing to answer, one of 1e300 MPa no number that a computer holds:
/// both are told before the mesher starts.
pub fn check_sizes(input: &SpecFile) -> Result<(), Diagnostics> {
    let refuse = |path: String, code, message: String, help: &str| {
        let mut d = Diagnostic::input(code, message).help(help);
        d.place = input.spec.index.place(&path);
        Err(d.into())
    };
    let loads = &input.spec.value.loads;
    for (i, load) in loads.iter().enumerate() {
        for Quantity { key, value, unit, sizes } in quantities(load) {
            let size = value.abs();
            if size != 0.0 && !sizes.contains(&size) {
                let [least, most] = [sizes.start(), sizes.end()].map(|s| format!("{s:e} {unit}"));
                let message = format!(
                    "`loads[{i}].{key}` is {value:e} {unit}; allowed: zero, or a size from \
                     {least} to {most}"
                );
                return refuse(
                    format!("loads[{i}].{key}"),
                    "spec/range",
                    message,
                    "check the number and its unit",
                );
            }
        }
        let mut case = loads.iter().filter(|l| l.name == load.name).flat_map(quantities);
        if case.all(|q| q.value == 0.0) {
            let message =
                format!("nothing acts in the load case `{}`: every load is zero", load.name);
            return refuse(
                format!("loads[{i}]"),
                "model/no-load",
                message,
                "give a load that is not zero",
            );
        }
    }
    Ok(())
}

/// A number of a load, and the sizes of it that make sense: energies go with their square, twice
/// their exponent must be a number.
struct Quantity {
    key: &'static str,
    value: f64,
    unit: &'static str,
    sizes: std::ops::RangeInclusive<f64>,
}

/// The numbers of a load.
fn quantities(load: &LoadSpec) -> Vec<Quantity> {
    let stress = |key, value| Quantity { key, value, unit: "MPa", sizes: 1e-9..=1e9 };
    let mut out: Vec<Quantity> = load.pressure.iter().map(|p| stress("pressure", p.0)).collect();
    out.extend(load.traction.into_iter().flatten().map(|t| stress("traction", t.0)));
    out.extend(load.actions().into_iter().map(|(action, value)| match action.direction() {
        (_, false) => Quantity { key: action.word(), value, unit: "N", sizes: 1e-6..=1e12 },
        (_, true) => Quantity { key: action.word(), value, unit: "N mm", sizes: 1e-6..=1e15 },
    }));
    out
}

/// How the mesher is asked; it works in a folder of its own below `folder`.
pub fn mesh_options(
    full: bool,
    size_factor: f64,
    input: &SpecFile,
    mesher: &Mesher,
    interrupt: &Interrupt,
    folder: &Path,
) -> MeshOptions {
    let mut options = MeshOptions::new(folder.join("mesher"));
    options.full = full;
    options.layers = input.spec.value.analysis.mesh.layers;
    options.sizes.factor = size_factor;
    options.mesher = Some(mesher.clone());
    options.interrupt = Some(interrupt.flag());
    if let Some(limit) = input.spec.value.analysis.time_limit {
        options.time_limit = Duration::from_secs_f64(limit.0.min(600.0));
    }
    options
}

/// Meshes the joint of a spec.
pub fn mesh(options: &MeshOptions, input: &SpecFile, log: &Log) -> Result<JointMesh, Diagnostics> {
    let meshed = mesh_joint(&input.joint.assembly, options, &mut |stage| log.stage(stage))?;
    let limit = input.spec.value.analysis.max_macro_tets;
    if meshed.mesh.tets.len() > limit {
        let mut d = Diagnostic::undecided(
            "run/too-large",
            format!("the mesh has {} tets, the limit is {limit}", meshed.mesh.tets.len()),
        )
        .help("raise `analysis.max_macro_tets`, or give a larger `analysis.mesh.size`");
        d.place = input.spec.index.place("analysis.max_macro_tets");
        return Err(d.into());
    }
    remesh::clean(options)?;
    Ok(meshed)
}

/// A case for each load case and kind of analysis, and one for each direction of `polygon`.
pub fn cases<'a>(
    input: &SpecFile,
    meshed: &JointMesh,
    kinds: &[AnalysisKind],
    polygon: Option<&PolygonSpec>,
    mesh_seconds: f64,
) -> Result<Vec<Case<'a>>, Diagnostics> {
    let loads = &input.spec.value.loads;
    let of_polygon = |name: &String| loads.iter().any(|l| l.of_polygon && l.name == *name);
    let directions = polygon.map_or(Vec::new(), PolygonSpec::directions);
    let names = from_joint::cases(&input.joint.assembly);
    let asked = names.iter().filter(|name| !of_polygon(name));
    let cases = asked
        .flat_map(|name| kinds.iter().enumerate().map(move |(k, kind)| (name, *kind, k > 0)))
        .chain(directions.iter().map(|d| (&d.case, AnalysisKind::Limit, false)))
        .enumerate()
        .map(|(i, (name, kind, again))| {
            let assembly = &input.joint.assembly;
            let mut file = from_joint::model_file(
                assembly,
                &meshed.mesh,
                &meshed.symmetry_used,
                "mesh.msh",
                name,
                kind,
            );
            file.symmetry = meshed.copies;
            let estimates = input.spec.value.analysis.coulomb_estimate && !of_polygon(name);
            file.coulomb_estimate = estimates && kind == AnalysisKind::Limit;
            let model = resolve(&file, meshed.mesh.clone(), &|path| input.spec.index.place(path))?;
            let file_name = if i == 0 {
                "model.yaml".into()
            } else {
                format!("model_{}.yaml", stem_of(name, kind, again))
            };
            Ok(Case {
                name: name.clone(),
                model,
                model_file: (file_name, file),
                remesh: None,
                mesh_seconds: Some(mesh_seconds),
                direction: directions.iter().find(|d| d.case == *name).map(|d| d.unit),
                demand: (!of_polygon(name)).then(|| end_actions(loads, name)),
            })
        });
    let mut cases = cases.collect::<Result<Vec<Case>, Diagnostics>>()?;
    if let Some((first, others)) = cases.split_first_mut() {
        others.iter_mut().for_each(|c| c.model.share_mesh(&first.model));
    }
    Ok(cases)
}

/// The forces and moments at member ends of a load case.
fn end_actions(loads: &[LoadSpec], case: &str) -> Vec<EndAction> {
    let mut out = Vec::new();
    for load in loads.iter().filter(|l| l.name == case) {
        let (Some(end), Some(at)) = (&load.end, load.at) else { continue };
        out.extend(load.actions().into_iter().map(|(action, value)| EndAction {
            end: end.clone(),
            at: at.word().into(),
            action: action.word().into(),
            value: ActionValue::of(action, value),
            factored: load.multiplies(action),
        }));
    }
    out
}

fn resolved_values(input: &SpecFile) -> Vec<ResolvedValue> {
    input
        .joint
        .resolved
        .iter()
        .map(|r| {
            // a list carries a unit at every entry
            let single = !r.value.starts_with('[');
            let (value, unit) =
                r.value.split_once(' ').filter(|_| single).unwrap_or((&r.value, ""));
            let origin = match (&r.default, r.given) {
                _ if r.origin.is_some() => r.origin.clone().unwrap_or_default(),
                (_, true) => "given".to_string(),
                (Some(expression), false) => format!("default `{expression}`"),
                (None, false) => "default".to_string(),
            };
            ResolvedValue { name: r.name.clone(), value: value.into(), unit: unit.into(), origin }
        })
        .collect()
}

fn catalogue_rows(input: &SpecFile) -> Vec<CatalogueRow> {
    let c = &input.catalog;
    let mut rows: Vec<CatalogueRow> = Vec::new();
    for (role, name) in &input.joint.catalogue {
        let (kind, row) = if role.ends_with(".profile") {
            ("profile", c.profile(name).map(|r| json!(r)))
        } else if role.ends_with("bolts.size") {
            ("bolt", c.bolt(name).map(|r| json!(r)))
        } else if role.ends_with("bolts.grade") {
            ("bolt grade", c.bolt_grade(name).map(|r| json!(r)))
        } else {
            ("steel", c.steel(name).map(|r| json!(r)))
        };
        // the same names were looked up when the joint was built
        let Ok(row) = row else { continue };
        let standard = row["standard"].as_str().unwrap_or_default();
        let file = row["source"]["file"].as_str().unwrap_or_default();
        let provenance = c.provenance(file);
        let builtin = provenance.and_then(|p| p.standard.clone());
        let own = builtin.is_none();
        let source = builtin.unwrap_or_else(|| {
            // a table of the user's own: the report names the row, so that it can be checked
            let mut words =
                vec![standard.to_string(), format!("{file} line {}", row["source"]["line"])];
            words.extend(provenance.map(|p| p.read_from.clone()));
            words.retain(|w| !w.is_empty());
            words.join("; ")
        });
        if !rows.iter().any(|r| r.kind == kind && r.name == *name) {
            rows.push(CatalogueRow { own, ..catalogue_row(kind, name, row, source) });
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_an_own_table_show_their_file_and_line() {
        let dir = tempfile::tempdir().expect("a folder");
        let table = "grade,fyb_MPa,fub_MPa,alpha_v_threads_in_shear_plane,\
                     alpha_v_shank_in_shear_plane,preloadable\nMY8.8,640,800,0.6,0.6,yes\n";
        let spec =
            include_str!("../../examples/paper_joint/joint.yaml").replace("\"8.8\"", "MY8.8");
        for (name, text) in [("g.csv", table), ("joint.yaml", &spec)] {
            std::fs::write(dir.path().join(name), text).expect("written");
        }
        let input = spec_file::read(&dir.path().join("joint.yaml"), Some(dir.path()))
            .unwrap_or_else(|e| panic!("{e:#?}"));
        let rows = catalogue_rows(&input);
        let own: Vec<&CatalogueRow> = rows.iter().filter(|r| r.own).collect();
        assert_eq!(own.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["MY8.8"]);
        assert!(own[0].source.ends_with("g.csv line 2"), "{}", own[0].source);
        assert!(
            rows.iter().any(|r| r.name == "HEB200" && r.source.starts_with("EN 10365")),
            "{rows:#?}"
        );
    }

    #[test]
    fn the_echo_is_the_spec_without_comments_and_polygon_directions_and_reads_back() {
        let dir = tempfile::tempdir().expect("a folder");
        let text = "# a comment\ntemplate: beam_to_column_end_plate\nmembers: {column: {profile: \
                    HEB200, steel: S235}, beam: {profile: IPE300, steel: S235}}\nplate: \
                    {thickness: 5/8 in}\nbolts: {size: M20, grade: '8.8', rows: [-90, 90, \
                    190]}\nloads: [{name: ULS1, end: beam_right, at: column_face, My: 80 kN m, \
                    Vz: -60.5 kN}]\npolygon: {end: beam_right, at: column_face, My: 100 kN m, N: \
                    200 kN}\nanalysis: {kind: limit}\n";
        std::fs::write(dir.path().join("joint.yaml"), text).expect("written");
        let input = spec_file::read(&dir.path().join("joint.yaml"), None)
            .unwrap_or_else(|e| panic!("{e:#?}"));
        assert!(input.spec.value.loads.len() > 1, "the polygon has directions");
        let context = yaml::to_string(&as_read(&input)).expect("YAML");
        for words in
            ["My: 80 kN m", "Vz: -60.5 kN", "thickness: 15.875 mm", "polygon:", "target_gap: 0.05"]
        {
            assert!(context.contains(words), "{words} in\n{context}");
        }
        assert!(!context.contains("comment") && context.matches("name:").count() == 1, "{context}");
        let again = yaml::parse::<ConnectionSpec>(&context, Path::new("context.yaml"))
            .unwrap_or_else(|e| panic!("{e:#?}"));
        assert_eq!(again.value, as_read(&input));
    }
}
