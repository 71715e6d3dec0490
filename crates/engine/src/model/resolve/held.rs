//! Reads supports, contacts with rigid ground, and rigid faces.

use super::claims::Claims;
use super::faults::Faults;
use super::interfaces::{check_gap, contact_law};
use super::names::Scene;
use crate::mesh::topology::face_nodes;
use crate::model::AnalysisKind;
use crate::model::analysis::{BoundaryFace, GroundContact, RigidFace, Support};
use crate::model::file::{Axis, Law, ModelFile, SupportEntry};
use bracket_base::math::rigid_motion::rigid_displacement;
use bracket_base::say;
use bracket_base::words::Text;
use std::collections::BTreeMap;

const AXES: [&str; 3] = ["x", "y", "z"];
const MOTIONS: [&str; 6] = ["ux", "uy", "uz", "rx", "ry", "rz"];

/// Marks the listed axes; an axis listed twice is a fault.
fn axes(list: &[Axis], path: &str, faults: &mut Faults<'_>) -> [bool; 3] {
    let mut marked = [false; 3];
    for a in list {
        if std::mem::replace(&mut marked[*a as usize], true) {
            let m = format!("`{}` is listed twice", AXES[*a as usize]);
            faults.add("model/value", path, m, "name each axis once");
        }
    }
    marked
}

/// Reads `supports`.
pub(super) fn supports(
    file: &ModelFile,
    scene: &Scene<'_>,
    claims: &Claims,
    faults: &mut Faults<'_>,
    notes: &mut Vec<Text>,
) -> (Vec<Support>, Vec<GroundContact>) {
    let (mut supports, mut ground) = (Vec::new(), Vec::new());
    for (i, entry) in file.supports.iter().enumerate() {
        let path = format!("supports[{i}]");
        let name = entry.face.clone();
        let faces = scene.outer_faces(&name, &format!("{path}.face"), claims, faults);
        match (entry.law, entry.fix.is_empty()) {
            (None, false) => {
                let of_ground = [entry.mu.is_some(), entry.gap.is_some(), entry.friction.is_some()];
                let gives_way = entry.strength.or(entry.stiffness).is_some();
                if of_ground.contains(&true) || gives_way {
                    let m = format!(
                        "`mu`, `gap`, `friction`, `strength` and `stiffness` have no effect on the \
                         fixed face `{name}`"
                    );
                    faults.add(
                        "model/support",
                        &path,
                        m,
                        "remove them, or replace `fix` by `law: contact`",
                    );
                }
                let fix = axes(&entry.fix, &format!("{path}.fix"), faults);
                supports.push(Support { name, fix, faces });
            }
            (Some(Law::Contact), true) => {
                if let Some(law) =
                    contact_law(entry.mu, &entry.gap, entry.friction, &path, faults, notes)
                {
                    let nodes =
                        faces.iter().map(|f| face_nodes(&scene.mesh.tets[f.tet as usize], f.local));
                    check_gap(&law.gap, &name, &path, scene, nodes, faults);
                    let [strength, stiffness] =
                        giving_way(entry, &path, file.analysis, faults, notes);
                    ground.push(GroundContact { name, law, strength, stiffness, faces });
                }
            }
            (Some(Law::Contact), false) | (None, true) => {
                let m = format!("the support `{name}` needs either `fix` or `law: contact`");
                faults.add(
                    "model/support",
                    &path,
                    m,
                    "write `fix: [x, y, z]`, or `law: contact` with `mu` for rigid ground",
                );
            }
            (Some(_), _) => {
                let m = format!("the support `{name}` has a law other than contact");
                faults.add(
                    "model/support",
                    &format!("{path}.law"),
                    m,
                    "write `law: contact`, or `fix: [x, y, z]` to hold the face",
                );
            }
        }
    }
    (supports, ground)
}

/// Reads `strength` and `stiffness` of a contact with the ground. The strength counts in limit
/// analysis, the stiffness in the others.
fn giving_way(
    entry: &SupportEntry,
    path: &str,
    analysis: AnalysisKind,
    faults: &mut Faults<'_>,
    notes: &mut Vec<Text>,
) -> [Option<f64>; 2] {
    let positive = |value: Option<f64>| value.filter(|v| v.is_finite() && *v > 0.0);
    let (strength, stiffness) = (positive(entry.strength), positive(entry.stiffness));
    if let (Some(x), None) = (entry.strength, strength) {
        let m = format!("the strength of the ground under `{}` is {x} MPa", entry.face);
        let next = "write the pressure at which the ground crushes, > 0 MPa, or remove `strength` \
                    for rigid ground";
        faults.add("model/support", &format!("{path}.strength"), m, next);
    }
    if let (Some(x), None) = (entry.stiffness, stiffness) {
        let m = format!("the stiffness of the ground under `{}` is {x} N/mm³", entry.face);
        let next = "write the pressure per millimetre of settlement, > 0 N/mm³, or remove \
                    `stiffness` for rigid ground";
        faults.add("model/support", &format!("{path}.stiffness"), m, next);
    }
    if analysis == AnalysisKind::Limit {
        return [strength, None];
    }
    if strength.is_some() && stiffness.is_none() {
        notes.push(say!(
            "the ground under {} is rigid here: its strength counts in limit analysis only",
            entry.face.clone()
        ));
    }
    [None, stiffness]
}

/// Reads `rigid`.
pub(super) fn rigid_faces(
    file: &ModelFile,
    scene: &Scene<'_>,
    claims: &Claims,
    faults: &mut Faults<'_>,
) -> Vec<RigidFace> {
    let mut all = Vec::new();
    for (i, entry) in file.rigid.iter().enumerate() {
        let path = format!("rigid[{i}]");
        let name = entry.face.clone();
        let faces = scene.outer_faces(&name, &format!("{path}.face"), claims, faults);
        let components = axes(&entry.components, &format!("{path}.components"), faults);
        if entry.components.is_empty() {
            let m = format!("the rigid face `{name}` has no components");
            faults.add(
                "model/rigid",
                &format!("{path}.components"),
                m,
                "write `components: [x, y, z]`",
            );
        }
        let mut free = [false; 6];
        for m in &entry.free {
            if std::mem::replace(&mut free[*m as usize], true) {
                let m = format!("`{}` is listed twice", MOTIONS[*m as usize]);
                faults.add("model/value", &format!("{path}.free"), m, "name each motion once");
            }
        }
        let (action, dead_action) = (entry.action(), entry.dead_action());
        let finite = action.iter().chain(&dead_action).chain(&entry.at).all(|v| v.is_finite());
        if !finite {
            let m = format!("a number of the rigid face `{name}` is not finite");
            faults.add("model/value", &path, m, "write finite numbers");
        }
        for k in 0..6 {
            if !free[k] && (action[k] != 0.0 || dead_action[k] != 0.0) {
                let key = if action[k] != 0.0 { "" } else { "dead_" };
                let key = format!("{key}{}", if k < 3 { "force" } else { "moment" });
                let m = format!(
                    "the rigid face `{name}` carries a {} in a motion that is held: `{}`",
                    &key, MOTIONS[k]
                );
                let help = format!("add `{}` to `free`, or set the value to 0", MOTIONS[k]);
                faults.add("model/rigid", &format!("{path}.{key}[{}]", k % 3), m, help);
            }
        }
        if finite && !faces.is_empty() && !entry.components.is_empty() {
            check_independent(&name, components, free, entry.at, &faces, scene, &path, faults);
        }
        all.push(RigidFace { name, components, free, at: entry.at, action, dead_action, faces });
    }
    all
}

/// Every free motion must move the face in its components, and differently from the other free
/// motions.
fn check_independent(
    name: &str,
    components: [bool; 3],
    free: [bool; 6],
    at: [f64; 3],
    faces: &[BoundaryFace],
    scene: &Scene<'_>,
    path: &str,
    faults: &mut Faults<'_>,
) {
    let mut nodes: Vec<u32> =
        faces.iter().flat_map(|f| face_nodes(&scene.mesh.tets[f.tet as usize], f.local)).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let points: Vec<[f64; 3]> =
        nodes.iter().map(|n| [0, 1, 2].map(|k| scene.mesh.nodes[*n as usize][k] - at[k])).collect();
    let arm = points.iter().flatten().fold(0.0_f64, |m, c| m.max(c.abs())).max(f64::MIN_POSITIVE);
    // Gram–Schmidt over the displacement of the whole face in each free motion, rotations scaled by
    // the arm
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for k in (0..6).filter(|k| free[*k]) {
        let mut v: Vec<f64> = points
            .iter()
            .flat_map(|r| {
                let mut motion = [0.0; 6];
                motion[k] = if k < 3 { 1.0 } else { 1.0 / arm };
                let u = rigid_displacement(&motion, [0.0; 3], *r);
                (0..3).filter(|c| components[*c]).map(move |c| u[c])
            })
            .collect();
        let norm = |v: &[f64]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
        let before = (points.len() as f64).sqrt();
        for _ in 0..2 {
            for b in &basis {
                let s: f64 = b.iter().zip(&v).map(|(p, q)| p * q).sum();
                v.iter_mut().zip(b).for_each(|(c, b)| *c -= s * b);
            }
        }
        let left = norm(&v);
        if left < 1e-8 * before {
            let parts: Vec<&str> = (0..3).filter(|c| components[*c]).map(|c| AXES[c]).collect();
            let m = format!(
                "the free motion `{}` of the rigid face `{name}` is not independent of its other \
                 free motions in [{}]",
                MOTIONS[k],
                parts.join(", ")
            );
            let help = "remove it from `free`, or add the component it moves";
            faults.add("model/rigid", &format!("{path}.free"), m, help);
            return;
        }
        v.iter_mut().for_each(|c| *c /= left);
        basis.push(v);
    }
}

/// Constraint on a component of a face: its kind in words, and the name of the support or face.
type Holder<'a> = Option<(&'a str, &'a str)>;

/// Checks that no component of a face is constrained twice: by a support, a rigid face or a contact
/// with the ground.
pub(super) fn check_twice(
    file: &ModelFile,
    supports: &[Support],
    ground: &[GroundContact],
    rigid: &[RigidFace],
    faults: &mut Faults<'_>,
) {
    // the first constraint on each component, by tet face
    let mut held: BTreeMap<(u32, u8), [Holder<'_>; 3]> = BTreeMap::new();
    for s in supports {
        for f in &s.faces {
            let h = held.entry((f.tet, f.local)).or_default();
            (0..3)
                .filter(|c| s.fix[*c])
                .for_each(|c| h[c] = Some(("fixed by the support", &s.name)));
        }
    }
    let later = rigid
        .iter()
        .map(|r| ("rigid", &r.name, r.components, &r.faces))
        .chain(ground.iter().map(|g| ("in contact with the ground", &g.name, [true; 3], &g.faces)));
    for (what, name, components, faces) in later {
        let mut clash = None;
        for f in faces {
            let h = held.entry((f.tet, f.local)).or_default();
            for c in (0..3).filter(|c| components[*c]) {
                let kind = if what == "rigid" {
                    "moved by the rigid face"
                } else {
                    "held by the ground contact"
                };
                if let Some(first) = h[c].replace((kind, name)) {
                    clash = clash.or(Some((c, first)));
                }
            }
        }
        if let Some((c, (kind, first))) = clash {
            let list = if what == "rigid" {
                file.rigid.iter().position(|r| r.face == *name).map(|i| format!("rigid[{i}]"))
            } else {
                file.supports
                    .iter()
                    .position(|s| s.face == *name && s.law.is_some())
                    .map(|i| format!("supports[{i}]"))
            };
            let m = format!(
                "component {} of the face `{name}` is {what} and also {kind} `{first}`",
                AXES[c]
            );
            faults.add(
                "model/held-twice",
                &list.unwrap_or_default(),
                m,
                "leave the component out of one of the two",
            );
        }
    }
}
