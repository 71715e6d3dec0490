//! The analysis of a model file on the user's own mesh.

use crate::driver::by_metric::{ByMetric, Tools};
use crate::driver::case::Case;
use crate::driver::context::RunContext;
use crate::driver::input_hash::model_hash;
use crate::driver::limits::{Limits, WHEN_INTERRUPTED};
use crate::driver::meshing::quality_table;
use crate::driver::present::{Finished, present};
use crate::driver::remesh::{ByBisection, Places, Remesh, remesher};
use crate::driver::run_files::RunFiles;
use crate::driver::setup::{Refinement, RunSetup};
use crate::driver::solve::solve;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::text_file;
use bracket_base::yaml;
use bracket_codes::HandChecks;
use bracket_engine::mesh::{TetMesh, merge, msh, quality};
use bracket_engine::model::file::{ModelFile, Nodes};
use bracket_engine::model::resolve::load_model;
use bracket_engine::refine::plan;
use bracket_joint::spec::analysis::AnalysisSpec;
use bracket_report::console::log::Log;
use bracket_report::markdown::report_data::InputFacts;
use bracket_report::result::file_names::file_stem;
use bracket_report::result::folder::ResultFolder;
use std::path::Path;
use std::rc::Rc;
use std::sync::Arc;

/// The mesh of an adaptive analysis as it was given, in the result folder.
pub const GIVEN_MESH: &str = "input/mesh.msh";

/// Analyses a model file and writes its result into `folder`; `quiet`: show nothing on standard
/// error.
pub fn analyse_model(
    path: &Path,
    folder: &Path,
    limits: Limits,
    quiet: bool,
) -> Result<Finished, Diagnostics> {
    let unread = |path: &Path, e: std::io::Error| {
        Diagnostic::input("model/read", format!("`{}` cannot be read: {e}", path.display()))
            .file(path)
    };
    let model = load_model(path).map_err(|faults| {
        let text = text_file::read(path, |e| unread(path, e)).unwrap_or_default();
        if yaml::top_level(&text, &["template", "loads"]) {
            let hint = "this looks like a connection spec: `bracket run` reads it";
            return faults.into_first().help(hint).into();
        }
        faults
    })?;
    let text = text_file::read(path, |e| unread(path, e))?;
    let parsed = yaml::parse::<ModelFile>(&text, path)?;
    let mut file = parsed.value;
    let mesh_path = path.parent().unwrap_or(Path::new("")).join(&file.mesh);
    let mesh_bytes = text_file::bytes(&mesh_path).map_err(|e| unread(&mesh_path, e))?;
    let log = Arc::new(Log::new(quiet));
    let folder = ResultFolder::begin(folder)?;
    limits.interrupt.begin(&log, WHEN_INTERRUPTED, folder.give_up());
    folder.write("mesh.msh", &mesh_bytes)?;
    if file.adapt.is_some() {
        // the best bounds may be on other meshes: `verify` compares those with the given one
        folder.write(GIVEN_MESH, &mesh_bytes)?;
    }
    let input_read = yaml::to_string(&file)?;
    file.mesh = "mesh.msh".into();
    let stem =
        path.file_stem().map_or_else(|| "model".into(), |s| s.to_string_lossy().into_owned());
    let name = if stem == "model" { folder_name(path).unwrap_or(stem) } else { stem };
    // the defaults of a model file are those of a spec
    let defaults = AnalysisSpec::default();
    let setup = RunSetup {
        input_hash: model_hash(&text, &mesh_bytes),
        refinement: Refinement {
            adapt: file.adapt.as_ref().map(|a| plan::Limits {
                target_gap: a.target_gap,
                max_passes: a.max_passes.unwrap_or(defaults.max_passes),
                max_macro_tets: a.max_macro_tets.unwrap_or(defaults.max_macro_tets),
            }),
            finer: "a finer mesh file",
            coarser: "a coarser mesh file",
        },
        ..RunSetup::default()
    };
    let context = RunContext {
        input: InputFacts {
            project: vec![("title".into(), name.clone())],
            name: path.file_name().map_or_else(String::new, |s| s.to_string_lossy().into_owned()),
            text,
            read: input_read,
            ..InputFacts::default()
        },
        ..RunContext::default()
    };
    let place = |path: &str| parsed.index.place(path);
    let remesh = match &file.adapt {
        Some(_) => {
            let mut mesh = msh::read(&mesh_path)?;
            if file.nodes == Nodes::Split {
                merge::merge_coincident(&mut mesh)?;
            }
            Some(remesh_model(&file, &place, mesh, folder.path(), &limits, &log))
        }
        None => None,
    };
    let mesh_quality = quality_table(&quality::table(&model.mesh));
    let case = Case {
        name: file_stem(&name),
        model,
        model_file: ("model.yaml".into(), file.clone()),
        remesh,
        mesh_seconds: None,
        direction: None,
    };
    let mut files = RunFiles::new(&folder, context.input.language, &limits.interrupt);
    files.mesh_quality = mesh_quality;
    let solved = solve(vec![case], &setup, &limits, &mut files, &log)?;
    let drawn = files.drawn();
    // a model file has no checks and no demand
    let judged = solved.judge(&HandChecks::default(), None, &[]);
    present(judged, context, drawn, &limits.interrupt, folder, &log)
}

/// Least number of tets of a mesh that Mmg adapts. A smaller mesh is mostly surface, and Mmg misses
/// the wanted count by a sixth and more; bisection meets it.
const LEAST_FOR_METRIC: usize = 1000;

/// Makes further meshes of a model file: with Mmg, or by bisection without it and of small meshes.
/// `mesh`: with nodes that bodies share.
pub fn remesh_model<'a>(
    file: &ModelFile,
    place: Places<'a>,
    mesh: TetMesh,
    folder: &Path,
    limits: &Limits,
    log: &Log,
) -> Box<dyn Remesh<'a> + 'a> {
    let own = file.clone();
    let bisect =
        move |mesh| Box::new(ByBisection::new(&own, place, mesh)) as Box<dyn Remesh<'a> + 'a>;
    let large = mesh.tets.len() >= LEAST_FOR_METRIC;
    let otherwise = "bisection";
    let found = large.then(|| remesher(otherwise, &limits.interrupt, log)).flatten();
    let Some(remesher) = found else { return bisect(mesh) };
    let tools = Tools {
        remesher,
        dir: folder.join("mesher"),
        interrupt: limits.interrupt.flag(),
        fallback: Rc::new(bisect),
        otherwise,
    };
    Box::new(ByMetric::new(tools, file, place, mesh))
}

/// Name of the folder a file lies in.
fn folder_name(path: &Path) -> Option<String> {
    let full = path.canonicalize().ok()?;
    Some(full.parent()?.file_name()?.to_string_lossy().into_owned())
}
