//! `bracket analyse`: the engine on a mesh the user brings.

use super::{CommandResult, Common, spec_file};
use crate::checks::HandChecks;
use crate::diag::Diagnostic;
use crate::driver::case::{
    AnalysisOptions, Case, RunContext, WHEN_INTERRUPTED, file_stem, finish, use_threads,
};
use crate::driver::remesh::{ByBisection, Remesh};
use crate::mesh::{merge, msh, quality};
use crate::model::file::{ModelFile, Nodes};
use crate::model::resolve::load_model;
use crate::refine::plan;
use crate::report::console::log::Log;
use crate::report::markdown::page::Table;
use crate::result::data::input_hash;
use crate::result::folder::ResultFolder;
use crate::spec::analysis::AnalysisSpec;
use crate::spec::yaml;
use crate::text_file;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The same engine on a mesh you bring.
#[derive(Debug, clap::Args)]
pub struct AnalyseArgs {
    /// Model file (`bracket schema model` describes it).
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// Options of the analysis.
    #[command(flatten)]
    pub options: AnalysisOptions,
}

/// Runs `bracket analyse`.
pub fn run(args: &AnalyseArgs, common: &Common) -> CommandResult {
    let limits = args.options.limits()?;
    use_threads(common)?;
    let unread = |path: &Path, e: std::io::Error| {
        Diagnostic::input("model/read", format!("`{}` cannot be read: {e}", path.display()))
            .file(path)
    };
    let model = load_model(&args.model).map_err(|faults| {
        let text = text_file::read(&args.model, |e| unread(&args.model, e)).unwrap_or_default();
        if spec_file::top_level(&text, "template") && spec_file::top_level(&text, "loads") {
            let hint = "this looks like a connection spec: `bracket run` reads it";
            return faults.into_first().help(hint).into();
        }
        faults
    })?;
    let text = text_file::read(&args.model, |e| unread(&args.model, e))?;
    let parsed = yaml::parse::<ModelFile>(&text, &args.model)?;
    let mut file = parsed.value;
    let mesh_path = args.model.parent().unwrap_or(Path::new("")).join(&file.mesh);
    let mesh_bytes = std::fs::read(&mesh_path).map_err(|e| unread(&mesh_path, e))?;
    let log = Arc::new(Log::new(common.quiet));
    let folder = ResultFolder::begin(&args.options.folder(&args.model))?;
    limits.interrupt.begin(&log, WHEN_INTERRUPTED, folder.give_up());
    folder.write("mesh.msh", &mesh_bytes)?;
    let input_read = yaml::to_string(&file)?;
    file.mesh = "mesh.msh".into();
    let stem =
        args.model.file_stem().map_or_else(|| "model".into(), |s| s.to_string_lossy().into_owned());
    let name = if stem == "model" { folder_name(&args.model).unwrap_or(stem) } else { stem };
    // a model file says nothing else than a spec where both are silent
    let defaults = AnalysisSpec::default();
    let context = RunContext {
        project: vec![("title".into(), name.clone())],
        input_name: args
            .model
            .file_name()
            .map_or_else(String::new, |s| s.to_string_lossy().into_owned()),
        input_hash: input_hash(&[("model", text.as_bytes()), ("mesh", &mesh_bytes)]),
        input_text: text,
        input_read,
        resolved: Vec::new(),
        catalogue_rows: Vec::new(),
        mesh_quality: quality_table(&quality::table(&model.mesh)),
        mirror: Vec::new(),
        adapt: file.adapt.as_ref().map(|a| plan::Limits {
            target_gap: a.target_gap,
            max_passes: a.max_passes.unwrap_or(defaults.max_passes),
            max_macro_tets: a.max_macro_tets.unwrap_or(defaults.max_macro_tets),
        }),
        finer: "a finer mesh file",
        coarser: "a coarser mesh file",
        checks: HandChecks::default(),
        drawings: Vec::new(),
        schedule: Table::default(),
        bolts: Vec::new(),
        polygon: None,
    };
    let place = |path: &str| parsed.index.place(path);
    let remesh = match &file.adapt {
        Some(_) => {
            let mut mesh = msh::read(&mesh_path)?;
            if file.nodes == Nodes::Split {
                merge::merge_coincident(&mut mesh)?;
            }
            Some(Box::new(ByBisection::new(&file, &place, mesh)) as Box<dyn Remesh>)
        }
        None => None,
    };
    let case = Case {
        name: file_stem(&name),
        model,
        model_file: ("model.yaml".into(), file.clone()),
        remesh,
        mesh_seconds: None,
        direction: None,
        demand: None,
    };
    finish(vec![case], context, &limits, folder, log, common)
}

/// Name of the folder a file lies in.
fn folder_name(path: &Path) -> Option<String> {
    let full = path.canonicalize().ok()?;
    Some(full.parent()?.file_name()?.to_string_lossy().into_owned())
}

/// The mesh quality as the report's table.
pub fn quality_table(rows: &[quality::BodyQuality]) -> Table {
    let columns = [
        "body",
        "tets",
        "volume [mm³]",
        "worst dihedral angle [°]",
        "median [°]",
        "worst aspect ratio",
        "one-layer tets",
    ];
    let rows = rows
        .iter()
        .map(|r| {
            vec![
                r.body.clone(),
                r.tets.to_string(),
                format!("{:.0}", r.volume),
                format!("{:.1}", r.worst_dihedral),
                format!("{:.1}", r.median_dihedral),
                format!("{:.1}", r.worst_aspect),
                format!("{:.0} %", 100.0 * r.surface_only),
            ]
        })
        .collect();
    Table { columns: columns.map(String::from).to_vec(), rows }
}
