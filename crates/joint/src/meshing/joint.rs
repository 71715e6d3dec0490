//! Meshes a joint: writes the script, runs the mesher, mends flat tets, names bodies and faces, and
//! checks the mesh.

mod attempts;

use super::naming::{self, Checks};
use crate::assembly::Assembly;
use crate::assembly::assembly::SymmetryPlane;
use crate::geometry::Scene;
use crate::geometry::geo_script::{self, Purpose, SIZES_FILE, Sizing};
use crate::geometry::size::SizeRule;
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
use bracket_engine::mesh::gmsh::Mesher;
use bracket_engine::mesh::mesher_error::MesherError;
use bracket_engine::mesh::quality::{self, BodyQuality};
use bracket_engine::mesh::{MeshError, TetMesh, mend, msh, msh_write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Options for meshing a joint: extent, element sizes and files.
#[derive(Clone, Debug)]
pub struct MeshOptions {
    /// Mesh the whole joint, even if it is symmetric.
    pub full: bool,
    /// Cut plates, flanges, webs and stiffeners at mid-thickness.
    pub layers: bool,
    /// Element sizes; `sizes.factor` scales all of them.
    pub sizes: SizeRule,
    /// Target sizes as a gmsh view; they replace `sizes`.
    pub size_view: Option<String>,
    /// Time the mesher may take.
    pub time_limit: Duration,
    /// Folder for the script, the mesher's file and its log; created if absent.
    pub work_dir: PathBuf,
    /// The mesher; `None`: search for it.
    pub mesher: Option<Mesher>,
    /// Set by another thread to stop the mesher.
    pub interrupt: Option<Arc<AtomicBool>>,
}

impl MeshOptions {
    /// Default options: a quarter or half if the joint is symmetric, layers on, the sizes of
    /// the parts, a time limit of ten minutes.
    pub fn new(work_dir: impl Into<PathBuf>) -> Self {
        MeshOptions {
            full: false,
            layers: true,
            sizes: SizeRule::default(),
            size_view: None,
            time_limit: Duration::from_secs(600),
            work_dir: work_dir.into(),
            mesher: None,
            interrupt: None,
        }
    }
}

/// A meshed joint.
#[derive(Clone, Debug)]
pub struct JointMesh {
    /// The mesh. Bodies are in the order of the assembly and share nodes; the named faces are
    /// interfaces, loads, supports and symmetry planes.
    pub mesh: TetMesh,
    /// Quality of each body's tets.
    pub quality: Vec<BodyQuality>,
    /// Comparison of meshed and exact volumes and areas.
    pub checks: Checks,
    /// Symmetry planes in use.
    pub symmetry_used: Vec<SymmetryPlane>,
    /// Number of copies of the mesh that make the whole joint.
    pub copies: u32,
    /// The mesher's script.
    pub geo: String,
    /// Version of the mesher.
    pub mesher: String,
    /// Time spent in the mesher \[s\].
    pub mesher_seconds: f64,
    /// Total time \[s\].
    pub seconds: f64,
}

/// Meshes a joint; `progress` receives the name of each step.
pub fn mesh_joint(
    assembly: &Assembly,
    options: &MeshOptions,
    progress: &mut dyn FnMut(&str),
) -> Result<JointMesh, Diagnostics> {
    let started = Instant::now();
    progress("checking clashes and clearances");
    let interrupted = || options.interrupt.as_ref().is_some_and(|i| i.load(Ordering::Relaxed));
    let stop = || interrupted() || started.elapsed() >= options.time_limit;
    let Some(checked) = crate::geometry::proximity::check(assembly, &stop) else {
        let seconds = started.elapsed().as_secs_f64();
        return Err(if interrupted() {
            MesherError::Interrupted { seconds }.into()
        } else {
            MesherError::TimeLimit { seconds }.into()
        });
    };
    checked?;
    let scene = Scene::new(assembly, options.full);
    let sizes =
        if options.size_view.is_some() { Sizing::View } else { Sizing::Rule(options.sizes) };
    let geo = geo_script::script(&scene, Purpose::Mesh { layers: options.layers, sizes });
    let dir = &options.work_dir;
    std::fs::create_dir_all(dir).map_err(|e| MesherError::write(dir, e))?;
    if let Some(view) = &options.size_view {
        msh_write::write_whole(&dir.join(SIZES_FILE), view)?;
    }
    let mesher = mesher(options)?;
    let place = attempts::Place { folder: dir, started, limit: options.time_limit };
    attempts::best(&place, progress, JointMesh::worst_dihedral, &mut |extra, left, progress| {
        let found =
            mesh_once(&format!("{geo}{extra}"), &scene, (&mesher, left), options, progress)?;
        Ok(JointMesh { seconds: started.elapsed().as_secs_f64(), ..found })
    })
}

impl JointMesh {
    /// Smallest dihedral angle of all tets \[degrees\].
    fn worst_dihedral(&self) -> f64 {
        self.quality.iter().fold(f64::INFINITY, |least, body| least.min(body.worst_dihedral))
    }
}

/// One run of the mesher.
fn mesh_once(
    geo: &str,
    scene: &Scene,
    (mesher, time_limit): (&Mesher, Duration),
    options: &MeshOptions,
    progress: &mut dyn FnMut(&str),
) -> Result<JointMesh, Diagnostics> {
    let dir = &options.work_dir;
    msh_write::write_whole(&dir.join("joint.geo"), geo)?;
    let in_mesher = Instant::now();
    let raw = dir.join("joint_raw.msh");
    remove(&raw)?;
    mesher.run(
        &["joint.geo", "-3", "-o", "joint_raw.msh"],
        dir,
        attempts::LOG,
        time_limit,
        options.interrupt.as_deref(),
    )?;
    let mesher_seconds = in_mesher.elapsed().as_secs_f64();
    progress("naming bodies and faces");
    let mut mesh = read_output(&raw)?;
    remove(&raw)?;
    let mended = mend_flat(&mut mesh, scene, options, progress)?;
    let checks = naming::name_and_check(&mut mesh, scene)?;
    let mut quality = quality::table(&mesh);
    for (name, tets) in mended {
        quality.iter_mut().filter(|row| row.body == name).for_each(|row| row.mended = tets);
    }
    Ok(JointMesh {
        quality,
        mesh,
        checks,
        copies: scene.copies(),
        symmetry_used: scene.symmetry.clone(),
        geo: geo.into(),
        mesher: mesher.version.clone(),
        mesher_seconds,
        seconds: mesher_seconds,
    })
}

/// Mends flat tets, if there are any; returns their number in each body. The mesh stays as it is if
/// it has none that must be mended and none can be.
fn mend_flat(
    mesh: &mut TetMesh,
    scene: &Scene,
    options: &MeshOptions,
    progress: &mut dyn FnMut(&str),
) -> Result<Vec<(String, usize)>, MeshError> {
    let Some(worst) = mend::worst_flat(mesh, mend::FLAT) else { return Ok(Vec::new()) };
    naming::name_imprints(mesh, scene);
    let stop = || options.interrupt.as_ref().is_some_and(|i| i.load(Ordering::Relaxed));
    let mended = mend::mend(mesh, mend::FLAT, &stop);
    mesh.faces.clear();
    match mended {
        Ok((made, mended)) => {
            progress(&mended.words());
            *mesh = TetMesh { faces: Vec::new(), ..made };
            Ok(mesh.bodies.iter().cloned().zip(mended.of_body).collect())
        }
        Err(why) if worst <= 0.0 => Err(MeshError::NotMended { why }),
        Err(_) => Ok(Vec::new()),
    }
}

/// Writes the whole joint as a STEP file with true circles and arcs; each part is a separate solid.
pub fn write_step(
    assembly: &Assembly,
    options: &MeshOptions,
    path: &Path,
) -> Result<(), Diagnostics> {
    let dir = &options.work_dir;
    std::fs::create_dir_all(dir).map_err(|e| MesherError::write(dir, e))?;
    let scene = Scene::new(assembly, true);
    let geo = geo_script::script(&scene, Purpose::Cad);
    msh_write::write_whole(&dir.join("joint_cad.geo"), &geo)?;
    let raw = dir.join("joint_raw.step");
    remove(&raw)?;
    let log = "gmsh_step.log";
    mesher(options)?.run(
        &["joint_cad.geo", "-0", "-format", "step", "-o", "joint_raw.step"],
        dir,
        log,
        options.time_limit,
        options.interrupt.as_deref(),
    )?;
    let text = std::fs::read_to_string(&raw).unwrap_or_default();
    if !text.trim_end().ends_with("END-ISO-10303-21;") {
        let why = if text.is_empty() { "it is absent or empty" } else { "it is cut off" };
        return Err(MesherError::NoOutput { what: "STEP file", why: why.into() }.into());
    }
    msh_write::write_whole(path, &text)?;
    remove(&raw)?;
    Ok(())
}

fn mesher(options: &MeshOptions) -> Result<Mesher, MesherError> {
    match &options.mesher {
        Some(m) => Ok(m.clone()),
        None => Mesher::find(),
    }
}

fn remove(path: &Path) -> Result<(), MesherError> {
    match std::fs::remove_file(path) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(MesherError::write(path, e)),
        _ => Ok(()),
    }
}

/// Reads the mesher's file. A damaged file is here a fault of the environment, not of the input.
fn read_output(raw: &Path) -> Result<TetMesh, Diagnostics> {
    let damaged = |why: String| MesherError::NoOutput { what: "mesh", why }.into();
    match std::fs::metadata(raw) {
        Err(_) => return Err(damaged("it is absent".into())),
        Ok(m) if m.len() == 0 => return Err(damaged("it is empty".into())),
        Ok(_) => {}
    }
    msh::read_to_mend(raw).map_err(|error| match error {
        // the user did not write this file, so its line numbers would not help
        MeshError::NoTets { .. } | MeshError::Folded { .. } => {
            let mut d = Diagnostic::from(error)
                .help("try other element sizes: `--size-factor 0.9`, or `analysis.mesh.size`");
            d.place = Place::default();
            d.into()
        }
        other => damaged(other.to_string()),
    })
}

#[cfg(test)]
mod tests;
