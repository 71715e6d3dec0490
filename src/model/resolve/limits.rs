//! What limit analysis asks of a model beyond the rest: bodies that yield, a load to increase, no live force per volume.

use super::Faults;
use super::names::Scene;
use crate::model::file::{AnalysisKind, LoadEntry, ModelFile};

/// Checks a file whose `analysis` is `limit`; every other passes.
pub(super) fn check(file: &ModelFile, scene: &Scene<'_>, faults: &mut Faults<'_>) {
    if file.analysis != AnalysisKind::Limit {
        return;
    }
    for (name, material) in &file.materials {
        let of_it = |body: &&String| file.bodies.get(*body) == Some(name);
        if let (None, Some(body)) = (material.fy, scene.mesh.bodies.iter().find(of_it)) {
            let m = format!("body `{body}` has no yield strength: in limit analysis every body must be able to yield");
            let help = format!("give its material `{name}` an `fy`; where nothing shall yield, a high one");
            faults.add("model/never-yields", &format!("materials.{name}"), m, help);
        }
    }
    for (i, load) in file.loads.iter().enumerate() {
        if let Some(body) = &load.body {
            let m =
                format!("a force in the body `{body}` carries the load factor, which limit analysis cannot increase");
            let help = "write it under `dead`, where it is not multiplied, or load a face instead";
            faults.add("model/live-body-force", &format!("loads[{i}]"), m, help);
        }
    }
    let rigid = file.rigid.iter().any(|r| r.force.iter().chain(&r.moment).any(|x| *x != 0.0));
    if !rigid && !file.loads.iter().any(acts) {
        let m = "no load carries the load factor: there is nothing for limit analysis to increase";
        let help = "write the load to be increased under `loads`; what stands under `dead` stays as it is";
        faults.add("model/no-live-load", "loads", m, help);
    }
}

/// Whether a load is more than zero.
fn acts(load: &LoadEntry) -> bool {
    let vector = |v: &Option<[f64; 3]>| v.iter().flatten().any(|x| *x != 0.0);
    let linear = load.linear.as_ref();
    vector(&load.traction)
        || vector(&load.force)
        || load.pressure.is_some_and(|p| p != 0.0)
        || linear.is_some_and(|l| l.traction0.iter().chain(l.gradient.iter().flatten()).any(|x| *x != 0.0))
}
