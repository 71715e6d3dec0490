//! Slip along held faces: bodies whose limit load is that of slip on a support, and what the
//! certificate of such velocities requires. k = f_y/√3 is the largest traction along a face.

use super::random::assembly;
use crate::common::grid::{Grid, even, joined, name};
use crate::common::limit::sharp_factors;
use crate::common::plane_strain::{K, PLANE_STRAIN, slice};
use crate::common::yielding::{FY, model};
use crate::common::{Block, mapped, oracle, points};
use bracket::analysis::event::silent;
use bracket::analysis::limit::{self, LimitPass, velocity};
use bracket::analysis::pass::PassOptions;
use bracket::certify::UpperFactor;
use bracket::certify::fields::DisplacementField;
use bracket::certify::limit_certificate::certify_upper;
use bracket::certify::slip::slip_faces;
use bracket::elements::hencky_kinematic::Flow;
use bracket::elements::space::Tet10Space;
use bracket::math::quadrature::triangle_p2;
use bracket::math::vec3::{self, V3};
use bracket::mesh::tet::FACES;
use bracket::model::AnalysisModel;
use bracket::model::analysis::{RigidFace, Support, SurfaceLoad};
use bracket::programs::Kinematic;
use bracket::solve::{SolveOptions, StopRules};

/// Turns a point or vector by `angle` about y.
fn about_y(angle: f64, x: V3) -> V3 {
    let (s, c) = angle.sin_cos();
    [c * x[0] + s * x[2], x[1], -s * x[0] + c * x[2]]
}

/// A block in plane strain whose bottom is held on a footprint 15 mm wide. A rigid plate on top
/// pushes it down and sideways without turning, H = 0.4 V; the load at factor 1 is a pressure of 1
/// on the footprint. Everything is turned by `angle` about y. `glued`: the footprint is a rigid
/// face at rest, along which nothing slips.
///
/// ```text
///   ↓→  rigid plate
///  +---------------------+
///  |                     |
///  +------+=======+------+
///            15      held
/// ```
fn footprint(angle: f64, glued: bool) -> AnalysisModel {
    let x = joined(&[even(-22.5, -7.5, 2), even(-7.5, 7.5, 4), even(7.5, 22.5, 2)]);
    let mut mesh = slice(x, even(0.0, 15.0, 3), 5.0, |axis, c| axis == 0 && c.abs() == 7.5);
    name(&mut mesh, "FOOT", "B", |p| p[2] == 0.0 && p[0].abs() <= 7.5);
    name(&mut mesh, "TOP", "B", |p| p[2] == 15.0);
    mesh.nodes.iter_mut().for_each(|p| *p = about_y(angle, *p));
    let force = about_y(angle, [0.4 * 75.0, 0.0, -75.0]);
    let (held, still) = if glued {
        ("", "- {face: FOOT, components: [x, z], free: [], at: [0, 0, 0]}\n")
    } else {
        ("- {face: FOOT, fix: [x, z]}\n", "")
    };
    model(
        &format!(
            "bodies: {{B: s}}\nsupports:\n{PLANE_STRAIN}{held}rigid:\n{still}- {{face: TOP, \
             components: [x, z], free: [ux, uz], at: [0, 0, 0], force: {force:?}}}\n"
        ),
        mesh,
    )
}

/// Slip on the whole footprint bounds V by k/0.4, 339.2 MPa; the half-space under such a load
/// carries more (2.57 k), so that no other mechanism is weaker. The bound is the same whatever the
/// direction of the normal, and far below that of velocities at rest on the footprint.
#[test]
fn block_on_a_fixed_footprint() {
    let exact = K / 0.4;
    for angle in [0.0, 0.5, 2.2] {
        let [low, up] = sharp_factors(&format!("footprint, {angle} rad"), &footprint(angle, false));
        assert!(up >= exact * (1.0 - 1e-9) && up <= exact * (1.0 + 1e-6), "{}", up / exact);
        assert!(low <= exact, "{}", low / exact);
    }
    let [low, glued] = sharp_factors("footprint, at rest", &footprint(0.0, true));
    assert!(low <= exact && glued > 1.15 * exact, "{}", glued / exact);
}

/// Velocities of a mechanism on a held V-shaped ridge: it slips along the ridge.
///
/// ```text
///  ⊙ traction along y
///  +---------------------+
///  |                     |
///  |          /\         |
///  +---------/  \--------+
///         held 2 × 5      ends of the prism hold x and z
/// ```
fn ridge(cells: usize, pull: &str) -> AnalysisModel {
    let x = joined(&[even(-12.0, -4.0, 2), even(-4.0, 4.0, 2), even(4.0, 12.0, 2)]);
    let planes = [x, even(0.0, 5.0, 1), even(0.0, 10.0, cells)];
    let grid = Grid::new(planes).jittered(0.15, 2);
    let mut mesh = grid.mesh(&["B"], |_| Some(0), |axis, c| axis == 0 && c.abs() <= 4.0);
    name(&mut mesh, "END0", "B", |p| p[1] == 0.0);
    name(&mut mesh, "END1", "B", |p| p[1] == 5.0);
    name(&mut mesh, "TOP", "B", |p| p[2] == 10.0);
    name(&mut mesh, "RIDGE", "B", |p| p[2] == 0.0 && p[0].abs() <= 4.0);
    for p in &mut mesh.nodes {
        p[2] += (1.0 - 0.1 * p[2]) * (3.0 - 0.75 * p[0].abs()).max(0.0);
    }
    model(
        &format!(
            "bodies: {{B: s}}\nsupports:\n- {{face: END0, fix: [x, z]}}\n- {{face: END1, fix: [x, \
             z]}}\n- {{face: RIDGE, fix: [x, \
             y, z]}}\nloads:\n- {{face: TOP, traction: {pull}}}\n"
        ),
        mesh,
    )
}

/// Pulled along the ridge, the block slips on both faces at once, 24 λ = 2 · 5 k. No cut through
/// the block around the ridge is shorter (the ridge is convex), so this is the exact antiplane
/// limit.
#[test]
fn block_on_a_ridge() {
    let exact = K * 10.0 / 24.0;
    for cells in [2, 4] {
        let [low, up] = sharp_factors("ridge", &ridge(cells, "[0, 1, 0]"));
        assert!(up >= exact * (1.0 - 1e-9) && up <= exact * (1.0 + 1e-6), "{}", up / exact);
        assert!(low <= exact, "{}", low / exact);
    }
}

/// A clamped cube, pressed and sheared at the top, turned by a rotation that takes no axis to
/// another.
fn turned_cube(turn: impl Fn(V3) -> V3) -> AnalysisModel {
    let mut mesh = Block::new([2; 3], [10.0; 3]).jittered(5).mesh(&["B"], |_| 0, |_, _| false);
    mesh.nodes.iter_mut().for_each(|p| *p = turn(*p));
    let t = turn([0.2, 0.3, -1.0]);
    let rest = "bodies: {B: s}\nsupports:\n- {face: Z0, fix: [x, y, z]}\nloads:\n";
    model(&format!("{rest}- {{face: Z1, traction: {t:?}}}\n"), mesh)
}

/// The bounds do not depend on the direction of the held face.
#[test]
fn any_normal() {
    let about_z = |angle: f64, x: V3| {
        let [b, a, c] = about_y(angle, [x[1], x[2], x[0]]);
        [c, b, a]
    };
    let straight = sharp_factors("cube", &turned_cube(|x| x));
    let turned = sharp_factors("turned cube", &turned_cube(|x| about_z(0.4, about_y(0.7, x))));
    for (a, b) in straight.iter().zip(turned) {
        assert!((a / b - 1.0).abs() < 2e-6, "{straight:?} {turned:?}");
    }
}

/// A square bar twisted between a held end and a rigid one. Every field of the plastic torsion of a
/// prism, T = k a³/3 (Nádai's sand heap), is admissible; a turn of the whole bar on its held face
/// costs k ∫ r dA = 0.38260 k a³.
#[test]
fn twisted_bar() {
    let shape = Block {
        cells: [4, 4, 2],
        min: [-5.0, -5.0, 0.0],
        max: [5.0, 5.0, 6.0],
        jitter: 0.15,
        seed: 6,
    };
    let mesh = shape.mesh(&["B"], |_| 0, |_, _| false);
    let m = model(
        "bodies: {B: s}\nsupports:\n- {face: Z0, fix: [x, y, z]}\nrigid:\n- {face: Z1, \
         components: [x, y], free: [rz], at: [0, 0, 0], moment: [0, 0, 1000]}\n",
        mesh,
    );
    let [low, up] = sharp_factors("torsion", &m);
    assert!(low <= 0.38260 * K && up >= K / 3.0, "[{low}, {up}]");
    // the six coefficients of a face overestimate the norm of a turn a little
    assert!(up <= 0.38260 * K * 1.02, "{}", up / K);
}

/// The same model with the clamped foot at rest: a rigid face without motions, where nothing slips.
fn at_rest(m: &AnalysisModel) -> AnalysisModel {
    let mut m = m.clone();
    let (clamped, others) = m.supports.into_iter().partition(|s| s.fix == [true; 3]);
    m.supports = others;
    m.rigid = clamped
        .into_iter()
        .map(|s| RigidFace {
            name: s.name,
            components: [true; 3],
            free: [false; 6],
            at: [0.0; 3],
            action: [0.0; 6],
            dead_action: [0.0; 6],
            faces: s.faces,
        })
        .collect();
    m
}

/// Random assemblies on a clamped foot. With slip the upper bound is at most that at rest on the
/// same mesh, and at least the lower bound. At random points of the foot the normal velocity is
/// zero; the mean of k‖v_T‖ there is at most the dissipation of the certificate and near it.
#[test]
fn random_assemblies_slip() {
    let (mut compared, mut lower, mut slipped) = (0, 0, 0);
    for seed in 0..16 {
        let Some(m) = assembly(seed).filter(|m| m.supports.iter().any(|s| s.fix == [true; 3]))
        else {
            continue;
        };
        let solve = SolveOptions::default().with(StopRules::to_limit_gap(1e-7));
        let options = PassOptions { solve, ..PassOptions::default() };
        let pass = |m: &AnalysisModel| limit::run(m, &options, &silent()).unwrap();
        let [slip, rest] = [pass(&m), pass(&at_rest(&m))];
        let (Some(s), Some(r)) = (&slip.upper, &rest.upper) else { continue };
        assert!(s.is_strict() && r.is_strict(), "seed {seed}");
        let (s, r) = (s.value(), r.value());
        println!("seed {seed}: {s:.8} with slip, {r:.8} at rest");
        assert!(s <= r + 1e-5 * r.abs(), "seed {seed}: {s} {r}");
        lower += usize::from(s < 0.999 * r);
        compared += 1;
        // the two lower bounds belong to one problem
        for low in [&slip.lower, &rest.lower].into_iter().flatten().filter(|l| l.is_strict()) {
            assert!(low.value() <= s + 1e-9 * s.abs(), "seed {seed}: {} {s}", low.value());
        }
        slipped += usize::from(points_of_the_foot(&m, &slip));
    }
    println!("{compared} compared, {lower} lower with slip, {slipped} feet sampled");
    assert!(compared >= 6 && lower >= 2 && slipped >= 2);
}

/// True when the foot slips.
fn points_of_the_foot(m: &AnalysisModel, pass: &LimitPass) -> bool {
    let field = &pass.velocity.as_ref().unwrap().nodes;
    points::velocities_on_supports("foot", m, field);
    let space = Tet10Space::new(&m.mesh);
    let mut power = 0.0;
    for f in m.supports.iter().filter(|s| s.fix == [true; 3]).flat_map(|s| &s.faces) {
        let vertices = FACES[f.local as usize].map(|i| m.mesh.tets[f.tet as usize][i]);
        let area = vec3::norm(vec3::area_vector(&vertices.map(|n| m.mesh.nodes[n as usize])));
        let nodes = space.triangle(vertices);
        let speed = |l: [f64; 3]| {
            let shape = triangle_p2(l);
            let v = (0..6).fold([0.0; 3], |v, i| vec3::along(v, shape[i], field.u[nodes[i]]));
            // the foot is the plane z = 0
            v[0].hypot(v[1])
        };
        power += FY * K * area * middle_mean(24, speed);
    }
    let c = pass.upper.as_ref().unwrap().certificate();
    let certified: f64 = c.supports.iter().sum();
    // on 16 parts of each face the rule overestimates the norm by some percent where it has a zero
    assert!(power <= certified * (1.0 + 1e-3) && power >= 0.93 * certified, "{power} {certified}");
    certified > 1e-3 * c.dissipation.iter().sum::<f64>()
}

/// Mean over a triangle: the middles of its n² equal parts.
fn middle_mean(n: usize, f: impl Fn([f64; 3]) -> f64) -> f64 {
    let mut sum = 0.0;
    for i in 0..n {
        for j in 0..n - i {
            let at = |third: f64| {
                let (a, b) = ((i as f64 + third) / n as f64, (j as f64 + third) / n as f64);
                [a, b, 1.0 - a - b]
            };
            sum += f(at(1.0 / 3.0));
            if i + j + 1 < n {
                sum += f(at(2.0 / 3.0));
            }
        }
    }
    sum / (n * n) as f64
}

/// The condensed method and Clarabel find the same load factor.
#[test]
fn agrees_with_clarabel() {
    for (name, m) in [
        ("footprint", footprint(0.5, false)),
        ("ridge", ridge(2, "[0.3, 1, 0.2]")),
        ("cube", turned_cube(|x| about_y(0.3, x))),
    ] {
        let k = Kinematic::limit(&m, Flow::Split).unwrap();
        assert!(!k.slips.is_empty());
        oracle::agree(name, &k.program, &k.map.block);
    }
}

/// Velocities of a body that moves as a whole: the certificate of slip by hand.
fn moved(m: &AnalysisModel, v: V3) -> UpperFactor {
    let u = vec![v; Tet10Space::new(&m.mesh).nodes.len()];
    UpperFactor::new(certify_upper(m, &velocity(DisplacementField { u }), 1))
}

/// What the certificate of slip requires and costs, by hand on a cube of 10 mm that moves as a
/// whole.
#[test]
fn what_slip_costs() {
    let mesh = Block::new([1, 1, 1], [10.0; 3]).mesh(&["B"], |_| 0, |_, _| false);
    let clamped = model(
        "bodies: {B: s}\nsupports:\n- {face: Z0, fix: [x, y, z]}\nloads:\n- {face: Z1, \
         traction: [1, 2, 0]}\n",
        mesh,
    );
    let k = FY / 3.0f64.sqrt();
    // 100 mm² at 5 mm per unit of time; the load does 3 + 8 per area
    let bound = moved(&clamped, [3.0, 4.0, 0.0]);
    let c = bound.certificate();
    assert!(bound.is_strict() && (c.supports[0] / (500.0 * k) - 1.0).abs() < 1e-14, "{c:?}");
    assert!((c.factor / (5.0 / 11.0 * k) - 1.0).abs() < 1e-12 && c.dissipation[0] < 1e-9, "{c:?}");
    // a normal velocity is not admissible, whatever it costs
    assert!(!moved(&clamped, [3.0, 4.0, 1e-7]).is_strict());
    assert!(!moved(&clamped, [3.0, f64::NAN, 0.0]).is_strict());
    // only held components cost
    let mut guided = clamped.clone();
    guided.supports[0].fix = [false, true, true];
    let c = moved(&guided, [3.0, 4.0, 0.0]);
    assert!((c.certificate().supports[0] / (400.0 * k) - 1.0).abs() < 1e-14 && c.is_strict());
    // held by two supports: the first of them
    let mut both = clamped.clone();
    both.supports.push(Support { fix: [true, false, false], ..both.supports[0].clone() });
    both.supports[0].fix = [false, false, true];
    let c = moved(&both, [3.0, 4.0, 0.0]);
    assert!((c.certificate().supports[0] / (300.0 * k) - 1.0).abs() < 1e-14 && c.is_strict());
    assert_eq!(c.certificate().supports[1], 0.0);
    // held along the face only, or loaded: at rest
    let mut along = clamped.clone();
    along.supports[0].fix = [true, true, false];
    let mut loaded = clamped.clone();
    let faces = loaded.supports[0].faces.clone();
    loaded.surface_loads.push(SurfaceLoad { faces, dead: true, ..loaded.surface_loads[0].clone() });
    for m in [along, loaded] {
        assert!(
            slip_faces(&m).is_empty()
                && Kinematic::limit(&m, Flow::Split).unwrap().slips.is_empty()
        );
        let c = moved(&m, [3.0, 4.0, 0.0]);
        assert!(!c.is_strict() && c.certificate().supports.iter().all(|d| *d == 0.0));
        assert!(c.certificate().compatibility > 0.5);
    }
    let mut rigid = clamped.clone();
    rigid.materials.iter_mut().for_each(|m| m.fy = None);
    assert!(!moved(&rigid, [3.0, 4.0, 0.0]).is_strict());
    // half the strength, half the cost
    let mut weaker = clamped.clone();
    weaker.materials.iter_mut().for_each(|m| m.fy = m.fy.map(|f| 0.5 * f));
    let half = moved(&weaker, [3.0, 4.0, 0.0]).certificate().supports[0];
    assert!((half / (250.0 * k) - 1.0).abs() < 1e-14);
}

/// A quarter of a block in a round hole of twelve facets around it, held there: between two facets
/// the points are at rest, and the axial direction slips.
#[test]
fn a_facetted_hole() {
    let (n, r) = (3, 5.0);
    let shape =
        Block { cells: [n, 2, 2], min: [0.0; 3], max: [n as f64, 4.0, 6.0], jitter: 0.0, seed: 1 };
    let angle = |x: f64| 0.5 * std::f64::consts::PI * x / n as f64;
    let mesh = mapped(shape.mesh(&["B"], |_| 0, |_, _| false), |[x, y, z]| {
        let (s, c) = angle(x).sin_cos();
        [(r + y) * c, (r + y) * s, z]
    });
    // pushed along the axis: k times the area of the facets over that of the end
    let m = model(
        "bodies: {B: s}\nsupports:\n- {face: X0, fix: [y]}\n- {face: X1, fix: [x]}\n- {face: Y0, \
         fix: [x, y, z]}\nloads:\n- {face: Z1, traction: [0, 0, 1]}\n",
        mesh,
    );
    let half = 0.25 * std::f64::consts::PI / n as f64;
    let (facet, area) = (2.0 * r * half.sin() * 6.0, (81.0 - 25.0) * half.sin() * half.cos());
    let cap = K * facet / area;
    let [low, up] = sharp_factors("hole", &m);
    assert!(low <= cap && up <= cap * (1.0 + 1e-6), "[{low}, {up}] {cap}");
    assert_eq!(Kinematic::limit(&m, Flow::Split).unwrap().slips.len(), 12);
}
