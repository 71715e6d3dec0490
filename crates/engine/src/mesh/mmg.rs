//! Runs the remesher Mmg (`mmg3d`) as a separate process: a mesh and a metric in, a mesh of the
//! same polyhedron out.
//!
//! # Source
//! Dapogny, Dobrzynski and Frey, Three-dimensional adaptive domain remeshing, implicit domain
//! meshing, and applications to free and moving boundary problems, JCP 262 (2014).

use super::TetMesh;
use super::medit::{self, mesh_text, metric_text};
use super::mesher_command::find_mmg;
use super::mesher_error::MesherError;
use super::msh_write::write_whole;
use super::polyhedron::Polyhedron;
use super::process::{Until, answer, run_logged};
use super::restore::restore;
use bracket_base::math::mandel::Mandel;
use std::ffi::OsString;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// The remesher: its command as a list of words, and its version.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remesher {
    /// Program and first arguments.
    pub command: Vec<OsString>,
    /// For example `5.8.0`.
    pub version: String,
}

/// Options of every run. All ridges are given, so none are detected (`-nr`). The gradation is that
/// of the metric (`-hgrad -1`: none of Mmg's own). Tets with four nodes on the surface are no fault
/// (`-nofem`): splitting them makes many times the wanted elements in thin walls.
const OPTIONS: [&str; 6] = ["-nr", "-nofem", "-hgrad", "-1", "-v", "1"];

/// Dihedral angle below which a tet of the meshes of Mmg is mended \[degrees\].
pub const MENDED: f64 = 1.5;

impl Remesher {
    /// Searches for Mmg (environment variable, project-local venv, PATH) and asks for its version.
    pub fn find() -> Result<Self, MesherError> {
        Self::find_until(Until::default())
    }

    /// The same within limits.
    pub fn find_until(until: Until) -> Result<Self, MesherError> {
        Self::asked(find_mmg()?, until)
    }

    /// Uses the given command, after asking for its version.
    pub fn with_command(command: Vec<OsString>) -> Result<Self, MesherError> {
        Self::asked(command, Until::default())
    }

    fn asked(command: Vec<OsString>, until: Until) -> Result<Self, MesherError> {
        let text = answer(&command, "-h", until)?;
        let version = text
            .lines()
            .find_map(|l| l.split_once("MMG3D, Release ")?.1.split_whitespace().next())
            .map(str::to_string)
            .ok_or_else(|| MesherError::no_version(&command, "-h", &text))?;
        Ok(Self { command, version })
    }

    /// Remeshes so that edges have the length 1 in the metric (one tensor at each node \[1/mm²\]).
    /// The new mesh fills the same polyhedron `p`. Works in the folder `dir`.
    pub fn remesh(
        &self,
        mesh: &TetMesh,
        p: &Polyhedron,
        metric: &[Mandel],
        dir: &Path,
        limit: Duration,
        interrupt: Option<&AtomicBool>,
    ) -> Result<TetMesh, MesherError> {
        std::fs::create_dir_all(dir).map_err(|e| MesherError::write(dir, e))?;
        write_whole(&dir.join("in.mesh"), &mesh_text(&mesh.nodes, &mesh.tets, p))?;
        write_whole(&dir.join("in.sol"), &metric_text(metric))?;
        let out = dir.join("out.mesh");
        let _ = std::fs::remove_file(&out);
        let mut arguments = OPTIONS.to_vec();
        arguments.extend(["-in", "in.mesh", "-sol", "in.sol", "-out", "out.mesh"]);
        let (status, log) =
            run_logged(&self.command, &arguments, dir, "mmg.log", limit, interrupt)?;
        if !status.success() {
            let errors: Vec<String> = log
                .lines()
                .filter(|l| l.contains("Error") || l.contains("ERROR"))
                .map(|l| l.trim().trim_start_matches(['#', ' ']).to_string())
                .collect();
            return Err(MesherError::failed(status, &errors, &log));
        }
        let bad = |why: String| MesherError::NoOutput { what: "mesh", why };
        let text = std::fs::read_to_string(&out).map_err(|_| bad("it is absent".into()))?;
        let made = medit::parse(&text).map_err(bad)?;
        restore(mesh, p, made).map_err(|why| MesherError::OtherBody { why })
    }
}

#[cfg(test)]
mod tests;
