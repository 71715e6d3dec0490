//! Reads loads on faces and bodies.

use super::claims::Claims;
use super::faults::Faults;
use super::names::Scene;
use crate::model::analysis::{BodyLoad, SurfaceLoad, Traction};
use crate::model::file::{LoadEntry, ModelFile};

/// Reads `loads` and `dead`.
pub(super) fn loads(
    file: &ModelFile,
    scene: &Scene<'_>,
    claims: &Claims,
    faults: &mut Faults<'_>,
) -> (Vec<SurfaceLoad>, Vec<BodyLoad>) {
    let (mut surface, mut body) = (Vec::new(), Vec::new());
    for (list, entries, dead) in [("loads", &file.loads, false), ("dead", &file.dead, true)] {
        for (i, entry) in entries.iter().enumerate() {
            let path = format!("{list}[{i}]");
            match (&entry.face, &entry.body) {
                (Some(face), None) => {
                    let faces = scene.outer_faces(face, &format!("{path}.face"), claims, faults);
                    if let Some(traction) = traction(entry, face, &path, faults) {
                        surface.push(SurfaceLoad { name: face.clone(), dead, traction, faces });
                    }
                }
                (None, Some(name)) => {
                    let at = format!("{path}.body");
                    // if a body is named ALL, the load acts on that body only
                    let bodies = if name == "ALL" && !scene.mesh.bodies.contains(name) {
                        (0..scene.mesh.bodies.len() as u32).collect()
                    } else {
                        scene.body(name, &at, faults).into_iter().collect::<Vec<_>>()
                    };
                    if let Some(force) = body_force(entry, name, &path, faults) {
                        body.extend(bodies.into_iter().map(|body| BodyLoad { body, dead, force }));
                    }
                }
                _ => {
                    let m = "a load acts on a `face` or on a `body`, on exactly one of them";
                    faults.add(
                        "model/load",
                        &path,
                        m,
                        "write `face: NAME` or `body: NAME` (or `body: ALL`)",
                    );
                }
            }
        }
    }
    (surface, body)
}

fn traction(
    entry: &LoadEntry,
    face: &str,
    path: &str,
    faults: &mut Faults<'_>,
) -> Option<Traction> {
    let given = [entry.traction.is_some(), entry.pressure.is_some(), entry.linear.is_some()];
    if given.iter().filter(|g| **g).count() != 1 || entry.force.is_some() {
        let m = format!(
            "the load on the face `{face}` needs exactly one of `traction`, `pressure`, `linear`"
        );
        let help = "a face takes a traction in MPa: divide a force by the area; `force` (N/mm³) \
                    belongs to a body";
        faults.add("model/load", path, m, help);
        return None;
    }
    let traction = if let Some(t) = entry.traction {
        Traction::Linear { traction0: t, gradient: [[0.0; 3]; 3] }
    } else if let Some(p) = entry.pressure {
        Traction::Pressure(p)
    } else {
        let l = entry.linear.as_ref()?;
        Traction::Linear { traction0: l.traction0, gradient: l.gradient }
    };
    let finite = match &traction {
        Traction::Pressure(p) => p.is_finite(),
        Traction::Linear { traction0, gradient } => {
            traction0.iter().chain(gradient.iter().flatten()).all(|v| v.is_finite())
        }
    };
    if !finite {
        faults.add(
            "model/value",
            path,
            format!("the load on `{face}` is not finite"),
            "write finite numbers",
        );
        return None;
    }
    Some(traction)
}

fn body_force(
    entry: &LoadEntry,
    body: &str,
    path: &str,
    faults: &mut Faults<'_>,
) -> Option<[f64; 3]> {
    let other = entry.traction.is_some() || entry.pressure.is_some() || entry.linear.is_some();
    match entry.force {
        Some(f) if !other && f.iter().all(|v| v.is_finite()) => Some(f),
        Some(_) if !other => {
            faults.add(
                "model/value",
                path,
                format!("the force on `{body}` is not finite"),
                "write finite numbers",
            );
            None
        }
        _ => {
            let m = format!("the load on the body `{body}` needs `force`, and nothing else");
            faults.add("model/load", path, m, "write `force: [fx, fy, fz]` in N/mm³");
            None
        }
    }
}
