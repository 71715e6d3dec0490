//! Attempts at a mesh: with the usual algorithm first, then with others, then with slightly
//! different element sizes.

use bracket_base::diag::Diagnostics;
use bracket_engine::mesh::mend::FLAT;
use bracket_engine::mesh::mesher_error::MesherError;
use std::path::Path;
use std::time::{Duration, Instant};

/// File of the mesher's log.
pub(super) const LOG: &str = "gmsh.log";

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

/// Codes of errors of the mesher that another attempt may cure, and their words. The mesher's own
/// errors count only once it meshes: those of the geometry come again each time.
const CURABLE: [(&str, &str); 4] = [
    ("mesh/flat", "a tet was all but flat"),
    ("mesh/folded", "tets overlapped"),
    ("mesher/crashed", "the mesher crashed"),
    ("mesher/failed", "the mesher failed"),
];

/// The line of the mesher's log with which meshing begins.
const MESHING: &str = "Meshing 1D";

/// One attempt: the lines added to the script, the time left, the progress.
type Attempt<'a, M> =
    dyn FnMut(&str, Duration, &mut dyn FnMut(&str)) -> Result<M, Diagnostics> + 'a;

/// Where the attempts are made.
pub(super) struct Place<'a> {
    /// Folder of the mesher's log.
    pub folder: &'a Path,
    /// Begin of the first attempt.
    pub started: Instant,
    /// Time for all attempts.
    pub limit: Duration,
}

/// The first mesh without flat tets, or the best of all attempts; `worst` gives the smallest
/// dihedral angle of a mesh \[degrees\]. A fault of a later attempt does not discard the mesh of an
/// earlier one, unless the user interrupts.
pub(super) fn best<M>(
    place: &Place,
    progress: &mut dyn FnMut(&str),
    worst: impl Fn(&M) -> f64,
    attempt: &mut Attempt<M>,
) -> Result<M, Diagnostics> {
    let mut best: Option<M> = None;
    let mut first_fault: Option<Diagnostics> = None;
    let mut why = "";
    for (extra, how) in ATTEMPTS {
        progress(&if how.is_empty() {
            "meshing".to_string()
        } else {
            format!("meshing again {how}: {why}")
        });
        let left = place.limit.saturating_sub(place.started.elapsed());
        match attempt(extra, left, progress) {
            Ok(found) => {
                let angle = worst(&found);
                if best.as_ref().is_none_or(|b| worst(b) < angle) {
                    best = Some(found);
                }
                if angle >= FLAT {
                    break;
                }
                why = "a tet was all but flat";
            }
            Err(faults) if faults.iter().any(|d| d.code == INTERRUPTED) => return Err(faults),
            Err(faults) => match curable(&faults, place.folder) {
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
fn curable(faults: &Diagnostics, folder: &Path) -> Option<&'static str> {
    let words = |code: &str| CURABLE.iter().find(|(c, _)| *c == code).map(|(_, words)| *words);
    let meshing = || {
        let log = std::fs::read(folder.join(LOG)).unwrap_or_default();
        String::from_utf8_lossy(&log).contains(MESHING)
    };
    if faults.iter().any(|d| d.code == "mesher/failed") && !meshing() {
        return None;
    }
    let mut all = faults.iter().map(|d| words(d.code));
    let first = all.next()??;
    all.all(|w| w.is_some()).then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_base::diag::Diagnostic;

    /// Runs attempts with these outcomes: smallest angles or errors. Returns the answer (an angle
    /// or a code), the number of attempts, and the progress.
    fn run(outcomes: &[Result<f64, MesherError>]) -> (Result<f64, &'static str>, usize, String) {
        let dir = tempfile::tempdir().expect("temporary folder");
        let limit = Duration::from_secs(60);
        let place = Place { folder: dir.path(), started: Instant::now(), limit };
        let (mut count, mut lines) = (0, Vec::new());
        let answer = best(
            &place,
            &mut |line| lines.push(line.to_string()),
            |angle| *angle,
            &mut |extra, _, _| {
                count += 1;
                assert_eq!(extra.is_empty(), count == 1, "{extra}");
                match &outcomes[(count - 1).min(outcomes.len() - 1)] {
                    Ok(worst) => Ok(*worst),
                    Err(MesherError::Crashed { signal }) => {
                        Err(MesherError::Crashed { signal: *signal }.into())
                    }
                    Err(MesherError::Interrupted { seconds }) => {
                        Err(MesherError::Interrupted { seconds: *seconds }.into())
                    }
                    Err(_) => Err(MesherError::TimeLimit { seconds: 1.0 }.into()),
                }
            },
        );
        let code = |faults: Diagnostics| faults.iter().map(|d: &Diagnostic| d.code).next();
        let answer = answer.map_err(|f| code(f).unwrap_or_default());
        (answer, count, lines.join("\n"))
    }

    #[test]
    fn a_fault_of_a_later_attempt_keeps_the_earlier_mesh() {
        let time = || Err(MesherError::TimeLimit { seconds: 1.0 });
        let crash = || Err(MesherError::Crashed { signal: 11 });
        assert_eq!(run(&[Ok(0.3), time()]).0, Ok(0.3));
        assert_eq!(run(&[Ok(0.3), time()]).1, 2);
        assert_eq!(run(&[Ok(0.3), crash(), Ok(0.2), crash()]).0, Ok(0.3));
        assert_eq!(run(&[Ok(0.3), crash(), Ok(0.4), Ok(3.0)]), {
            let lines = "meshing\nmeshing again by Delaunay's algorithm: a tet was all but flat\n\
                         meshing again by an advancing front: the mesher crashed\n\
                         meshing again with sizes times 0.97: a tet was all but flat";
            (Ok(3.0), 4, lines.to_string())
        });
        // without a mesh the fault counts
        assert_eq!(run(&[time()]).0, Err("mesher/time"));
        assert_eq!(run(&[crash(), time()]).0, Err("mesher/time"));
    }

    #[test]
    fn an_interruption_counts_even_with_a_mesh() {
        let stop = Err(MesherError::Interrupted { seconds: 1.0 });
        assert_eq!(run(&[Ok(0.3), stop]).0, Err("mesher/interrupted"));
    }

    #[test]
    fn a_crash_is_named_and_other_ways_are_tried() {
        let (answer, count, lines) = run(&[Err(MesherError::Crashed { signal: 6 })]);
        assert_eq!((answer, count), (Err("mesher/crashed"), ATTEMPTS.len()));
        assert!(lines.contains("the mesher crashed") && !lines.contains("flat"), "{lines}");
    }
}
