use super::*;
use crate::elements::super_element::SuperElement;
use crate::estimate::fixtures::model;
use crate::mesh::fixtures::{cubes, name};
use bracket_base::math::mandel::{Mandel, traction};
use bracket_base::math::vec3::{add, scale, sub};

/// A web A, 60 long (x), 8 thick (y), on a flange B; the weld is at z = 10.
const THICKNESS: f64 = 8.0;

fn mesh() -> TetMesh {
    let cells: Vec<([i32; 3], &str)> = (0..6)
        .flat_map(|i| [([i, 0, 1], "A"), ([i, 1, 1], "A"), ([i, 0, 0], "B"), ([i, 1, 0], "B")])
        .collect();
    let mut mesh = cubes(&cells);
    for x in &mut mesh.nodes {
        x[1] *= THICKNESS / 20.0;
    }
    name(&mut mesh, "W", |x| x[2] == 10.0);
    name(&mut mesh, "HELD", |x| x[2] == 0.0);
    mesh
}

fn welded() -> AnalysisModel {
    let text = "mesh: m.msh\nanalysis: elastic\nmaterials: {s: {E: 210000, nu: 0.3}}\n\
                bodies: {A: s, B: s}\n\
                interfaces: [{between: [A, B], law: weld, face: W, strength_traction: 100}]\n\
                supports: [{face: HELD, fix: [x, y, z]}]\n";
    model(mesh(), text)
}

fn stress(model: &AnalysisModel, at: impl Fn(V3) -> Mandel) -> StressField {
    let of = |e: usize| SuperElement::points(&model.mesh.corners(e)).map(|t| t.map(&at));
    StressField { points: (0..model.mesh.tets.len()).map(of).collect() }
}

fn band(model: &AnalysisModel, length: f64) -> WeldBand {
    WeldBand {
        faces: model.welds[0].faces.clone(),
        along: [1.0, 0.0, 0.0],
        length,
        mirrored_along: false,
        mirrored_across: false,
    }
}

fn near(got: f64, want: f64) {
    assert!((got - want).abs() <= 1e-12 * want.abs().max(1.0), "{got} {want}");
}

/// σ_z = 20, τ_yz = 5, τ_xz = −3 MPa on 8 mm. The normal out of A is −z, so `across` is −y: A is
/// pulled down, that is tension, and toward −y by 5 and toward +x by 3 MPa.
#[test]
fn constant_tractions() {
    let m = welded();
    let r2 = 2f64.sqrt();
    let field = stress(&m, |_| [7.0, -4.0, 20.0, r2 * 5.0, r2 * -3.0, r2 * 2.0]);
    let segments = &line_forces(&m, &field, &[band(&m, 20.0)])[0];
    let spans: Vec<[f64; 2]> = segments.iter().map(|s| s.span).collect();
    assert_eq!(spans, [[0.0, 20.0], [10.0, 30.0], [20.0, 40.0], [30.0, 50.0], [40.0, 60.0]]);
    for s in segments {
        near(s.normal, 160.0);
        near(s.across, 40.0);
        near(s.along, 24.0);
        near(s.couple, 0.0);
    }
    // the bodies share their nodes: the same by name
    let tied = tied_faces(&mesh(), "W", 0);
    assert_eq!(tied.len(), m.welds[0].faces.len());
    let text = "mesh: m.msh\nanalysis: elastic\nmaterials: {s: {E: 210000, nu: 0.3}}\n\
                bodies: {A: s, B: s}\nsupports: [{face: HELD, fix: [x, y, z]}]\n";
    let one = model(mesh(), text);
    let field = stress(&one, |_| [7.0, -4.0, 20.0, r2 * 5.0, r2 * -3.0, r2 * 2.0]);
    let same = &line_forces(&one, &field, &[WeldBand { faces: tied, ..band(&m, 20.0) }])[0];
    assert_eq!(same, segments);
    let none = WeldBand { faces: tied_faces(&mesh(), "?", 0), ..band(&m, 20.0) };
    assert!(line_forces(&one, &field, &[none])[0].is_empty());
}

/// σ_z = 2 + 0.5 x + 3 (y − 4), τ_xz = 0.1 x: n = 8 (2 + 0.5 x̄), l = −0.8 x̄ at the middle of a
/// piece. The couple about the middle line: 3 t³/12 = 128, with tension on the side of +y, which
/// `across` does not point to. Pieces of 25 end between the nodes.
#[test]
fn linear_tractions_and_couple() {
    let m = welded();
    let field = stress(&m, |x| {
        let mut s = [0.0; 6];
        s[2] = 2.0 + 0.5 * x[0] + 3.0 * (x[1] - 4.0);
        s[4] = 2f64.sqrt() * 0.1 * x[0];
        s
    });
    for length in [15.0, 25.0, 60.0, 100.0] {
        let segments = &line_forces(&m, &field, &[band(&m, length)])[0];
        assert_eq!(
            segments.len(),
            if length < 20.0 {
                7
            } else if length < 30.0 {
                4
            } else {
                1
            }
        );
        for s in segments {
            let middle = 0.5 * (s.span[0] + s.span[1]);
            near(s.normal, THICKNESS * (2.0 + 0.5 * middle));
            near(s.along, -0.8 * middle);
            near(s.across, 0.0);
            near(s.couple, -128.0);
        }
    }
}

/// Pieces side by side sum to the resultant of all faces, for a stress with no symmetry.
#[test]
fn pieces_sum_to_the_resultant() {
    let m = welded();
    let field = stress(&m, |x| {
        std::array::from_fn(|c| (c as f64 - 2.0) * x[0] + (1.5 * c as f64) * x[1] - 7.0 + x[2])
    });
    let weld = band(&m, 15.0);
    let mut total = [0.0; 3];
    for face in &weld.faces {
        let face = side_a(face);
        let (n, area) = face.normal(&m);
        let at = |x: V3| -> Mandel {
            std::array::from_fn(|c| (c as f64 - 2.0) * x[0] + (1.5 * c as f64) * x[1] - 7.0 + x[2])
        };
        let centre = scale(1.0 / 3.0, face.corners(&m).into_iter().fold([0.0; 3], add));
        total = add(total, scale(area, traction(&at(centre), n)));
    }
    let segments = &line_forces(&m, &field, &[weld])[0];
    let mut sum = [0.0; 3];
    // normal out of A −z, across −y, along x
    for s in segments.iter().step_by(2) {
        let length = s.span[1] - s.span[0];
        sum = add(sum, scale(length, [s.along, -s.across, -s.normal]));
    }
    let off = sub(sum, total);
    assert!(off.iter().all(|x| x.abs() < 1e-9 * 1e4), "{sum:?} {total:?}");
}

/// The half of a weld at x > 0 and y > 0 of a symmetric stress gives what the whole gives.
#[test]
fn planes_of_symmetry_complete_the_weld() {
    let symmetric = |x: V3| {
        let mut s = [0.0; 6];
        s[2] = 10.0 - x[0] + x[1];
        s[4] = 2f64.sqrt() * 0.3 * x[0];
        s
    };
    let m = welded();
    let field = stress(&m, symmetric);
    let half = WeldBand { mirrored_along: true, mirrored_across: true, ..band(&m, 20.0) };
    let segments = &line_forces(&m, &field, &[half])[0];
    assert_eq!(segments[0].span, [-10.0, 10.0]);
    // 2 · 8 (10 − |x| + 4) with a mean |x| of 5
    near(segments[0].normal, 144.0);
    near(segments[0].along, 0.0);
    near(segments[1].normal, 64.0);
    near(segments[1].along, -2.0 * 8.0 * 3.0);
    assert!(segments.iter().all(|s| s.across == 0.0 && s.couple == 0.0));
}
