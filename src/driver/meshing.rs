//! The mesh of a spec's joint.

use crate::driver::interrupt::Interrupt;
use crate::driver::spec_file::SpecFile;
use bracket_base::diag::{Diagnostic, Diagnostics, number};
use bracket_base::words::Text;
use bracket_engine::mesh::gmsh::{Mesher, Until};
use bracket_engine::mesh::quality::BodyQuality;
use bracket_engine::model::AnalysisKind;
use bracket_joint::geometry::size::{HALF_THICKNESS, SizeRule};
use bracket_joint::meshing::joint::{JointMesh, MeshOptions, mesh_joint};
use bracket_joint::spec::analysis::{MeshSize, MeshSpec};
use bracket_report::console::log::Log;
use bracket_report::document::table::Table;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

/// Part of the joint that is meshed, and fineness of the mesh.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// The whole joint, even if it is symmetric.
    pub full: bool,
    /// Multiplies all element sizes.
    pub size_factor: f64,
}

impl Default for Extent {
    fn default() -> Self {
        Self { full: false, size_factor: 1.0 }
    }
}

impl Extent {
    /// Refuses size factors out of range.
    pub fn check(&self) -> Result<(), Diagnostics> {
        let factor = self.size_factor;
        if factor.is_finite() && (0.05..=20.0).contains(&factor) {
            return Ok(());
        }
        let text = format!("--size-factor is {}, it must be between 0.05 and 20", number(factor));
        let help = "1 is the usual size; 0.7 takes about twice the elements, 1.4 half of them";
        Err(Diagnostic::input("cli/value", text).help(help).into())
    }
}

/// The element sizes for these kinds of analysis, times `size_factor`. An analysis with yield
/// conditions starts with few elements, most of them where plates turn about hinges, unless the
/// spec gives one size for all parts.
pub fn sizes(asked: &MeshSpec, kinds: &[AnalysisKind], size_factor: f64) -> SizeRule {
    let even = SizeRule { factor: size_factor, ..SizeRule::default() };
    let elastic = kinds.is_empty() || kinds.contains(&AnalysisKind::Elastic);
    if !elastic && asked.size == MeshSize::Auto {
        SizeRule { at_hinges: Some(HALF_THICKNESS), ..even }
    } else {
        even
    }
}

/// Searches for the mesher and asks for its version. A signal or the time limit of the run \[s\]
/// ends the question, and the process that was asked.
pub fn find_mesher(
    interrupt: &Interrupt,
    limit: Option<f64>,
    log: &Arc<Log>,
) -> Result<Mesher, Diagnostics> {
    interrupt.begin(log, "the mesher stops now", || {});
    let (flag, limit) = (interrupt.flag(), limit.map(|t| Duration::from_secs_f64(t.min(600.0))));
    let found = Mesher::find_until(Until { limit, interrupt: Some(&flag) });
    interrupt.pause();
    interrupt.check("looking for the mesher")?;
    Ok(found?)
}

/// The options of the mesher, which works in its own folder below `folder`.
pub fn mesh_options(
    Extent { full, size_factor }: Extent,
    input: &SpecFile,
    kinds: &[AnalysisKind],
    mesher: &Mesher,
    interrupt: &Interrupt,
    folder: &Path,
) -> MeshOptions {
    let mut options = MeshOptions::new(folder.join("mesher"));
    options.full = full;
    let asked = &input.spec.value.analysis.mesh;
    options.layers = asked.layers;
    options.sizes = sizes(asked, kinds, size_factor);
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
    clean(options)?;
    Ok(meshed)
}

/// Removes the mesher's working folder. Script and log are needed only if the mesher fails, and
/// then the message quotes them.
pub fn clean(options: &MeshOptions) -> Result<(), Diagnostics> {
    let dir = &options.work_dir;
    match std::fs::remove_dir_all(dir) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(Diagnostic::environment(
            "run/clean",
            format!("`{}` cannot be removed: {e}", dir.display()),
        )
        .into()),
        _ => Ok(()),
    }
}

/// The mesh quality as a table of the report. Mended tets have a column if there are any.
pub fn quality_table(rows: &[BodyQuality]) -> Table {
    let mending = rows.iter().any(|r| r.mended > 0);
    let columns = [
        "body",
        "tets",
        "volume [mm³]",
        "worst dihedral angle [°]",
        "median [°]",
        "worst aspect ratio",
        "one-layer tets",
    ];
    let columns =
        columns.into_iter().chain(mending.then_some("mended flat tets")).map(Text::from).collect();
    let rows = rows
        .iter()
        .map(|r| {
            let mut row = vec![
                r.body.clone(),
                r.tets.to_string(),
                format!("{:.0}", r.volume),
                format!("{:.1}", r.worst_dihedral),
                format!("{:.1}", r.median_dihedral),
                format!("{:.1}", r.worst_aspect),
                format!("{:.0} %", 100.0 * r.surface_only),
            ];
            row.extend(mending.then(|| r.mended.to_string()));
            row.into_iter().map(Text::given).collect()
        })
        .collect();
    Table { columns, rows }
}
