//! `bracket mesh`: geometry and mesh of a connection, without any analysis.

use super::catalog_options::CatalogOptions;
use super::common::{CommandResult, Common, Format};
use crate::driver::interrupt::Interrupt;
use crate::driver::meshing;
use crate::driver::spec_file;
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus, number};
use bracket_base::text_file;
use bracket_engine::mesh::{msh_write, quality};
use bracket_joint::assembly::Assembly;
use bracket_joint::geometry::size::SizeRule;
use bracket_joint::meshing::joint::{JointMesh, MeshOptions, mesh_joint, write_step};
use bracket_report::console::log::Log;
use bracket_report::console::out;
use bracket_report::result::folder::{Content, ResultFolder};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

/// The file that marks a folder as written by `bracket mesh`.
const MARK: &str = "quality.json";

/// Geometry and mesh only.
#[derive(Debug, clap::Args)]
pub struct MeshArgs {
    /// Connection spec; or an assembly as JSON, as `--keep` writes it.
    #[arg(value_name = "SPEC")]
    pub spec: PathBuf,
    /// Folder for the files (default: named after the spec).
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Mesh the whole joint, even if it is symmetric.
    #[arg(long)]
    pub full: bool,
    /// Do not cut plates, flanges, webs and stiffeners at mid-thickness.
    #[arg(long)]
    pub no_layers: bool,
    /// Multiplies all element sizes.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    pub size_factor: f64,
    /// Seconds the mesher may take.
    #[arg(long, value_name = "SECONDS", default_value_t = 600.0)]
    pub time_limit: f64,
    /// Catalogue of the user's own.
    #[command(flatten)]
    pub catalog: CatalogOptions,
    /// Leave out the STEP file.
    #[arg(long)]
    pub no_step: bool,
}

/// Runs `bracket mesh`.
pub fn run(args: &MeshArgs, common: &Common) -> CommandResult {
    for (name, value) in [("--size-factor", args.size_factor), ("--time-limit", args.time_limit)] {
        if !(value.is_finite() && value > 0.0 && value < 1e9) {
            let d = Diagnostic::input(
                "cli/value",
                format!("{name} is {}, it must be above 0 and below 1e9", number(value)),
            );
            return Err(d
                .help("leave the option out for its usual value: `bracket mesh --help`")
                .into());
        }
    }
    let interrupt = Interrupt::watch()?;
    let (assembly, layers, sizes, warnings) = load(args)?;
    let out = args.out.clone().unwrap_or_else(|| args.spec.with_extension(""));
    let log = Arc::new(Log::new(common.quiet));
    let mesher = meshing::find_mesher(&interrupt, Some(args.time_limit), &log)?;
    let content = Content::Files { mark: MARK, command: "mesh" };
    let folder = ResultFolder::begin_with(&out, content)?;
    warnings.iter().for_each(|w| log.line(w));
    interrupt.begin(&log, "the mesher is stopped", folder.give_up());
    let mut options = MeshOptions::new(folder.path());
    options.full = args.full;
    options.layers = layers && !args.no_layers;
    options.sizes = sizes;
    options.time_limit = Duration::from_secs_f64(args.time_limit);
    options.mesher = Some(mesher);
    options.interrupt = Some(interrupt.flag());
    let mut progress = |stage: &str| log.line(stage);
    let joint = mesh_joint(&assembly, &options, &mut progress)?;
    msh_write::write(&joint.mesh, &folder.path().join("mesh.msh"))?;
    if !args.no_step {
        progress("writing STEP");
        write_step(&assembly, &options, &folder.path().join("joint.step"))?;
    }
    let table = quality::text(&joint.quality);
    let json = serde_json::to_string_pretty(&summary(&joint))
        .expect("plain numbers and strings serialise");
    msh_write::write_whole(&folder.path().join("quality.txt"), &table)?;
    msh_write::write_whole(&folder.path().join(MARK), &format!("{json}\n"))?;
    interrupt.check("meshing")?;
    folder.finish()?;
    match common.format {
        Format::Text => out::text(&format!(
            "{}: {} tets, {} nodes, 1/{} of the joint\n{table}\n",
            out.display(),
            joint.mesh.tets.len(),
            joint.mesh.nodes.len(),
            joint.copies
        ))?,
        Format::Json => out::data(&format!("{json}\n"))?,
    }
    Ok(ExitStatus::Ok)
}

/// The content of `quality.json`. It contains no times, so that two runs write the same bytes.
fn summary(joint: &JointMesh) -> serde_json::Value {
    serde_json::json!({
        "schema": 1,
        "macro_tets": joint.mesh.tets.len(),
        "nodes": joint.mesh.nodes.len(),
        "symmetry": joint.copies,
        "mesher": joint.mesher,
        "quality": joint.quality,
        "checks": joint.checks,
    })
}

/// The assembly, whether the spec requests mid-thickness layers, the element sizes, and the
/// warnings of the catalogue.
fn load(args: &MeshArgs) -> Result<(Assembly, bool, SizeRule, Vec<String>), Diagnostics> {
    let (path, catalog) = (args.spec.as_path(), &args.catalog);
    if path.extension().is_none_or(|e| e != "json") {
        let file = spec_file::read(path, catalog.folder())?;
        let warnings = file.catalog.warnings().iter().map(spec_file::catalog_warning).collect();
        let analysis = &file.spec.value.analysis;
        let sizes = meshing::sizes(&analysis.mesh, &file.kinds(), args.size_factor);
        return Ok((file.joint.assembly, analysis.mesh.layers, sizes, warnings));
    }
    if let Some(dir) = catalog.folder() {
        let text = format!(
            "`--catalog {}` has no use: an assembly takes nothing from the catalogue",
            dir.display()
        );
        return Err(Diagnostic::input("cli/catalog", text)
            .help("leave the option out, or give the spec")
            .into());
    }
    let text = text_file::read(path, |e| {
        Diagnostic::input("assembly/read", format!("the assembly cannot be read: {e}"))
            .file(path)
            .help("check the path")
    })?;
    let sizes = SizeRule { factor: args.size_factor, ..SizeRule::default() };
    serde_json::from_str(&text).map(|a| (a, true, sizes, Vec::new())).map_err(|e| {
        Diagnostic::input("assembly/parse", format!("this is not an assembly: {e}"))
            .file(path)
            .at(e.line(), e.column())
            .help(
                "give a connection spec (YAML), or the assembly as `bracket run --keep` writes it",
            )
            .into()
    })
}
