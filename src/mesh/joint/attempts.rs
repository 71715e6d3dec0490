//! Attempts at a mesh: with the usual algorithm first, then with others, then with slightly
//! different element sizes.

use super::{JointMesh, MeshOptions};
use crate::diag::Diagnostics;
use crate::mesh::mend::FLAT;
use crate::mesh::mesher_error::MesherError;
use std::time::{Duration, Instant};

/// What is added to the script in each attempt, and how the progress names it. A sliver that cannot
/// be mended, and a crash, come from the way in which the mesher inserts points one after another;
/// another algorithm or size goes another way.
const ATTEMPTS: [(&str, &str); 6] = [
    ("", ""),
    ("Mesh.Algorithm3D = 1;\nMesh.OptimizeNetgen = 1;\n", "by Delaunay's algorithm"),
    ("Mesh.Algorithm3D = 4;\nMesh.OptimizeNetgen = 1;\n", "by an advancing front"),
    ("Mesh.MeshSizeFactor = 0.97;\n", "with sizes times 0.97"),
    ("Mesh.MeshSizeFactor = 0.94;\n", "with sizes times 0.94"),
    ("Mesh.MeshSizeFactor = 1.03;\n", "with sizes times 1.03"),
];

/// Codes of errors of the mesher that another attempt may cure, and their words.
const CURABLE: [(&str, &str); 4] = [
    ("mesh/flat", "a tet was all but flat"),
    ("mesh/folded", "tets overlapped"),
    ("mesher/crashed", "the mesher crashed"),
    ("mesher/failed-to-mesh", "the mesher failed"),
];

/// One attempt: the lines added to the script, the time left, the progress.
type Attempt<'a> =
    dyn FnMut(&str, Duration, &mut dyn FnMut(&str)) -> Result<JointMesh, Diagnostics> + 'a;

/// The first mesh without flat tets, or the best of all attempts. A fault of a later attempt does
/// not discard the mesh of an earlier one, unless the user interrupts.
pub(super) fn best(
    options: &MeshOptions,
    started: Instant,
    progress: &mut dyn FnMut(&str),
    attempt: &mut Attempt,
) -> Result<JointMesh, Diagnostics> {
    let mut best: Option<JointMesh> = None;
    let mut first_fault: Option<Diagnostics> = None;
    let mut why = "";
    for (extra, how) in ATTEMPTS {
        progress(&if how.is_empty() {
            "meshing".to_string()
        } else {
            format!("meshing again {how}: {why}")
        });
        let left = options.time_limit.saturating_sub(started.elapsed());
        match attempt(extra, left, progress) {
            Ok(found) => {
                let found = JointMesh { seconds: started.elapsed().as_secs_f64(), ..found };
                let worst = found.worst_dihedral();
                if best.as_ref().is_none_or(|b| b.worst_dihedral() < worst) {
                    best = Some(found);
                }
                if worst >= FLAT {
                    break;
                }
                why = "a tet was all but flat";
            }
            Err(faults) if faults.iter().any(|d| d.code == INTERRUPTED) => return Err(faults),
            Err(faults) => match curable(&faults) {
                Some(words) => {
                    why = words;
                    first_fault.get_or_insert(faults);
                }
                None if best.is_some() => break,
                None => return Err(faults),
            },
        }
    }
    match (best, first_fault) {
        (Some(best), _) => Ok(best),
        (None, Some(faults)) => Err(faults),
        // an attempt gives a mesh or a fault
        (None, None) => {
            let why = "there was no attempt".into();
            Err(MesherError::NoOutput { what: "mesh", why }.into())
        }
    }
}

/// Code of an interruption by the user.
const INTERRUPTED: &str = "mesher/interrupted";

/// The words for faults that another attempt may cure; `None` for others.
fn curable(faults: &Diagnostics) -> Option<&'static str> {
    let words = |code: &str| CURABLE.iter().find(|(c, _)| *c == code).map(|(_, words)| *words);
    let mut all = faults.iter().map(|d| words(d.code));
    let first = all.next()??;
    all.all(|w| w.is_some()).then_some(first)
}
