//! Changes that must not affect the bounds of a bolted joint: mirror image, rotated axes, shifted
//! origin, order of bolts and bodies. Changes that scale the bounds by a known factor.
//!
//! ```text
//!            N ↑ ⟳ My → Vz
//!          |   |           a pair of T-stubs with one bolt on either side of the web, pulled,
//!      [H] |   | [H]       sheared and bent: it is symmetric in its length only, and every
//!     +-----------+        support, contact and load has a direction that must follow
//!     +-----------+
//! ```
//!
//! Each change is applied to model file and mesh. The two programs then differ only in the numbers
//! in them. The bounds must therefore agree to the tolerance of the solver (1e-8 of the energy in
//! elastic analysis, 1e-4 of the load factor in limit analysis), not only to the gap.

use crate::built::{bounds, joint, model};
use bracket::mesh::TetMesh;
use bracket::model::AnalysisKind;
use bracket::model::file::{Axis, ModelFile, Motion};

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];
const MOTIONS: [Motion; 6] =
    [Motion::Ux, Motion::Uy, Motion::Uz, Motion::Rx, Motion::Ry, Motion::Rz];

/// Twice the relative gap of the solver, because each of the two solves has its own gap. The first
/// is for energies, the second for load factors.
const TOLERANCE: [f64; 2] = [2e-8, 2e-4];

fn spec(loads: &str, mu: f64) -> String {
    format!(
        "template: t_stub\nmembers: {{tee: {{profile: IPE300, steel: S235}}}}\nbolts: {{size: \
         M16, grade: \"8.8\", gauge: 100, rows: [0]}}\nparameters: {{length: 60, welded: true, \
         flange_thickness: 20, flange_width: 160, web_thickness: 12, web_height: 30}}\nfriction: \
         {{mu: {mu}, law: associated}}\nloads: [{{name: ULS1, end: top, at: bolt_plane, \
         {loads}}}]\n"
    )
}

type M3 = [[f64; 3]; 3];

fn apply(r: &M3, x: [f64; 3]) -> [f64; 3] {
    r.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2])
}

fn determinant(r: &M3) -> f64 {
    let minor = |i: usize, j: usize| r[1][i] * r[2][j] - r[1][j] * r[2][i];
    r[0][0] * minor(1, 2) - r[0][1] * minor(0, 2) + r[0][2] * minor(0, 1)
}

/// The model and its mesh after x → r x + d, with r orthogonal. Moments transform as axial vectors.
/// Supports and motions by component need an r that only exchanges axes and signs, unless they name
/// all three components.
fn moved(file: &ModelFile, mesh: &TetMesh, r: &M3, d: [f64; 3]) -> (ModelFile, TetMesh) {
    let (mut file, mut mesh) = (file.clone(), mesh.clone());
    let det = determinant(r);
    let point = |x: [f64; 3]| -> [f64; 3] {
        let y = apply(r, x);
        [0, 1, 2].map(|k| y[k] + d[k])
    };
    for x in &mut mesh.nodes {
        *x = point(*x);
    }
    if det < 0.0 {
        mesh.tets.iter_mut().for_each(|t| t.swap(0, 1));
    }
    let image = |k: usize| -> usize {
        (0..3)
            .find(|&i| (r[i][k].abs() - 1.0).abs() < 1e-12)
            .expect("a turn that takes axes to axes")
    };
    for s in file.supports.iter_mut().filter(|s| s.fix.len() < 3) {
        s.fix =
            s.fix.iter().map(|a| AXES[image(AXES.iter().position(|b| b == a).unwrap())]).collect();
    }
    for e in &mut file.rigid {
        e.at = point(e.at);
        [e.force, e.dead_force] = [e.force, e.dead_force].map(|f| apply(r, f));
        [e.moment, e.dead_moment] = [e.moment, e.dead_moment].map(|m| apply(r, m).map(|x| det * x));
        assert_eq!(e.components.len(), 3);
        if e.free.len() < 6 {
            let of = |m: &Motion| MOTIONS.iter().position(|n| n == m).unwrap();
            e.free = e.free.iter().map(|m| MOTIONS[image(of(m) % 3) + of(m) / 3 * 3]).collect();
        }
    }
    file.cuts.iter_mut().for_each(|c| c.axis = apply(r, c.axis));
    for limit in &mut file.resultant_limits {
        limit.along = apply(r, limit.along);
        limit.across.iter_mut().for_each(|row| *row = apply(r, *row));
    }
    assert!(file.loads.is_empty() && file.dead.is_empty(), "only member ends are turned here");
    (file, mesh)
}

/// The same model with bodies, tets, nodes and interfaces in another order. The sides of each
/// interface are exchanged.
fn reordered(file: &ModelFile, mesh: &TetMesh) -> (ModelFile, TetMesh) {
    let (mut file, mut mesh) = (file.clone(), mesh.clone());
    let (n, b) = (mesh.nodes.len() as u32, mesh.bodies.len() as u32);
    mesh.nodes.reverse();
    mesh.bodies.reverse();
    mesh.tets.reverse();
    mesh.tet_body.reverse();
    mesh.tet_body.iter_mut().for_each(|k| *k = b - 1 - *k);
    // each tet is rotated about one corner, so that its first vertex changes too
    mesh.tets.iter_mut().for_each(|t| *t = [t[1], t[2], t[0], t[3]].map(|v| n - 1 - v));
    mesh.faces.reverse();
    mesh.faces.iter_mut().flat_map(|f| &mut f.triangles).for_each(|t| *t = t.map(|v| n - 1 - v));
    file.cuts.reverse();
    file.resultant_limits.reverse();
    file.interfaces.reverse();
    for i in &mut file.interfaces {
        i.between = i.between.take().map(|[a, b]| [b, a]);
    }
    (file, mesh)
}

const ONE: M3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// x → y → z → x.
const CYCLE: M3 = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
const MIRROR: M3 = [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// A rotation about (1, 2, 3) by 0.7 rad (Rodrigues).
fn turn() -> M3 {
    let (s, c) = 0.7f64.sin_cos();
    let k = [1.0, 2.0, 3.0].map(|x: f64| x / 14f64.sqrt());
    let cross = [[0.0, -k[2], k[1]], [k[2], 0.0, -k[0]], [-k[1], k[0], 0.0]];
    [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| f64::from(i == j) * c + s * cross[i][j] + (1.0 - c) * k[i] * k[j])
    })
}

/// Fails unless both bounds agree within the tolerance of the kind of analysis.
fn same(name: &str, kind: AnalysisKind, a: [f64; 2], b: [f64; 2]) {
    let tolerance = TOLERANCE[usize::from(kind == AnalysisKind::Limit)];
    for k in 0..2 {
        assert!((a[k] / b[k] - 1.0).abs() <= tolerance, "{name}: {a:?} and {b:?}");
    }
}

/// Elastic analysis of the whole joint with friction: the energies do not depend on any rotation of
/// the axes, on mirror image, shift or order.
#[test]
fn energies_do_not_depend_on_axes_origin_or_order() {
    let kind = AnalysisKind::Elastic;
    let (file, mesh) =
        model(&joint(&spec("N: 30 kN, My: 0.4 kN m, Vz: 2 kN, Vy: 1 kN", 0.3)), 4.0, true, kind);
    assert_eq!(file.symmetry, 1);
    let base = bounds("as it is", &file, &mesh);
    let turned = moved(&file, &mesh, &turn(), [0.0; 3]);
    for (name, (file, mesh)) in [
        ("turned about (1, 2, 3)", turned.clone()),
        ("mirrored and turned", moved(&turned.0, &turned.1, &MIRROR, [0.0; 3])),
        ("shifted", moved(&file, &mesh, &ONE, [0.37, -4.1, 2.9])),
        ("reordered", reordered(&file, &mesh)),
    ] {
        same(name, kind, bounds(name, &file, &mesh), base);
    }
    // contact without initial gaps: twice the load gives four times the energy
    let mut twice = file.clone();
    for e in &mut twice.rigid {
        (e.force, e.moment) = (e.force.map(|f| 2.0 * f), e.moment.map(|m| 2.0 * m));
    }
    same("twice the load", kind, bounds("twice the load", &twice, &mesh).map(|x| x / 4.0), base);
}

/// Limit analysis of half the joint with a part of its load not multiplied: the load factors do not
/// depend on mirror image, exchanged axes, shift or order, nor on doubling all strengths and loads.
#[test]
fn load_factors_do_not_depend_on_axes_origin_or_order() {
    let kind = AnalysisKind::Limit;
    let (file, mesh) = model(
        &joint(&spec("N: 60 kN, My: 0.05 kN m, Vz: 1 kN, factor: [N]", 0.0)),
        4.0,
        false,
        kind,
    );
    assert_eq!(file.symmetry, 2);
    assert!(file.cuts.len() == 2 && file.resultant_limits.len() == 6, "one shear plane a bolt");
    let base = bounds("as it is", &file, &mesh);
    let (other, mirrored) =
        (moved(&file, &mesh, &CYCLE, [1.25, 0.0, -3.5]), moved(&file, &mesh, &MIRROR, [0.0; 3]));
    let strong = {
        let (mut file, mesh) = other;
        file.materials.values_mut().for_each(|m| m.fy = m.fy.map(|f| 2.0 * f));
        file.resultant_limits.iter_mut().for_each(|l| l.at_most *= 2.0);
        for e in &mut file.rigid {
            [e.force, e.dead_force, e.moment, e.dead_moment] =
                [e.force, e.dead_force, e.moment, e.dead_moment].map(|v| v.map(|x| 2.0 * x));
        }
        (file, mesh)
    };
    for (name, (file, mesh)) in [
        ("mirrored and reordered", reordered(&mirrored.0, &mirrored.1)),
        ("axes exchanged, shifted, twice the strengths, twice the loads", strong),
    ] {
        same(name, kind, bounds(name, &file, &mesh), base);
    }
}

/// A mirrored spec, or one with its rows in another order, is meshed again. The meshes of the same
/// body differ, but their brackets contain the same energy.
#[test]
fn specs_of_the_same_joint_share_its_energy() {
    let of = |rows: &str, my: &str| {
        let text = format!(
            "template: t_stub\nmembers: {{tee: {{profile: IPE300, steel: S235}}}}\nbolts: {{size: \
             M12, grade: \"8.8\", rows: {rows}}}\nparameters: {{length: 120, welded: \
             true}}\nfriction: {{mu: 0}}\nloads: [{{name: A, end: top, at: node, N: 20 kN, My: \
             {my}}}]\n"
        );
        let (file, mesh) = model(&joint(&text), 4.0, true, AnalysisKind::Elastic);
        bounds(&format!("rows {rows}, My {my}"), &file, &mesh)
    };
    let one = of("[-40, 20]", "0.2 kN m");
    for other in [of("[20, -40]", "0.2 kN m"), of("[-20, 40]", "-0.2 kN m")] {
        assert!(one[0] <= other[1] && other[0] <= one[1], "{one:?} and {other:?} share nothing");
        // the meshes are similar
        assert!(
            (one[0] / other[0] - 1.0).abs() < 0.05 && (one[1] / other[1] - 1.0).abs() < 0.05,
            "{one:?} {other:?}"
        );
    }
}
