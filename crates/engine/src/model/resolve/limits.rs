//! Additional requirements of limit analysis: something that gives way, a load to increase, no live
//! force per volume.

use super::faults::Faults;
use super::names::Scene;
use crate::mesh::TetMesh;
use crate::model::AnalysisKind;
use crate::model::FrictionLaw;
use crate::model::file::{Law, LoadEntry, ModelFile};
use bracket_base::say;
use bracket_base::words::Text;

/// Checks a file whose `analysis` is `limit`; every other passes.
pub(super) fn check(
    file: &ModelFile,
    scene: &Scene<'_>,
    faults: &mut Faults<'_>,
    notes: &mut Vec<Text>,
) {
    check_estimate(file, faults);
    if file.analysis != AnalysisKind::Limit {
        return;
    }
    let rigid = rigid_bodies(file, scene.mesh);
    let contact = |law: &Option<Law>| *law == Some(Law::Contact);
    let slips = file.interfaces.iter().any(|i| i.law != Law::Tied)
        || file.supports.iter().any(|s| contact(&s.law));
    match &rigid[..] {
        [] => {}
        all if all.len() == scene.mesh.bodies.len() && !slips => {
            let m = "no body has a yield strength and no interface can open or slip: nothing can \
                     collapse";
            let help = "give the material of the bodies that can yield an `fy`; bodies without \
                        one are rigid";
            faults.add("model/never-yields", "materials", m, help);
        }
        [one] => {
            notes.push(say!("limit analysis: the body without `fy` is rigid: {}", one.to_string()));
        }
        some => {
            notes.push(say!("limit analysis: bodies without `fy` are rigid: {}", some.join(", ")));
        }
    }
    for (i, load) in file.loads.iter().enumerate() {
        if let Some(body) = &load.body {
            let m = format!(
                "a force in the body `{body}` carries the load factor, which limit analysis \
                 cannot increase"
            );
            let help = "write it under `dead`, where it is not multiplied, or load a face instead";
            faults.add("model/live-body-force", &format!("loads[{i}]"), m, help);
        }
    }
    let rigid = file.rigid.iter().any(|r| r.force.iter().chain(&r.moment).any(|x| *x != 0.0));
    if !rigid && !file.loads.iter().any(acts) {
        let m = "no load carries the load factor: there is nothing for limit analysis to increase";
        let help =
            "write the load to be increased under `loads`; loads under `dead` are not increased";
        faults.add("model/no-live-load", "loads", m, help);
    }
}

/// An estimate under Coulomb's law needs limit analysis and a contact with that law.
fn check_estimate(file: &ModelFile, faults: &mut Faults<'_>) {
    if !file.coulomb_estimate {
        return;
    }
    let coulomb = |mu: Option<f64>, friction: Option<FrictionLaw>| {
        mu.is_some_and(|mu| mu > 0.0) && friction == Some(FrictionLaw::Coulomb)
    };
    let any = file.interfaces.iter().any(|i| coulomb(i.mu, i.friction))
        || file.supports.iter().any(|s| coulomb(s.mu, s.friction));
    let (m, help) = match file.analysis {
        AnalysisKind::Elastic | AnalysisKind::Elastoplastic => (
            format!(
                "`coulomb_estimate` with `analysis: {}`: it estimates the load factor of limit \
                 analysis",
                file.analysis.word()
            ),
            "leave it out: the other kinds of analysis apply Coulomb's law directly",
        ),
        AnalysisKind::Limit if !any => (
            "`coulomb_estimate`, but no contact has `friction: coulomb` and a `mu` above 0"
                .to_owned(),
            "give the contact `friction: coulomb`, or leave `coulomb_estimate` out",
        ),
        AnalysisKind::Limit => return,
    };
    faults.add("model/value", "coulomb_estimate", m, help);
}

/// The bodies whose material has no yield strength, in the order of the mesh.
fn rigid_bodies<'a>(file: &ModelFile, mesh: &'a TetMesh) -> Vec<&'a str> {
    let material = |body: &str| file.bodies.get(body).and_then(|m| file.materials.get(m));
    mesh.bodies
        .iter()
        .map(String::as_str)
        .filter(|b| material(b).is_some_and(|m| m.fy.is_none()))
        .collect()
}

/// True when a load is not zero.
fn acts(load: &LoadEntry) -> bool {
    let vector = |v: &Option<[f64; 3]>| v.iter().flatten().any(|x| *x != 0.0);
    let linear = load.linear.as_ref();
    vector(&load.traction)
        || vector(&load.force)
        || load.pressure.is_some_and(|p| p != 0.0)
        || linear.is_some_and(|l| {
            l.traction0.iter().chain(l.gradient.iter().flatten()).any(|x| *x != 0.0)
        })
}
