//! Contact with ground that crushes at a pressure: plates on concrete, against closed forms.

use crate::common::limit::{factors_of, run, sharp_factors};
use crate::common::yielding::{FY, MATERIALS};
use crate::common::{Block, Random, solved};
use bracket::certify::fields::DisplacementField;
use bracket::certify::limit_certificate::{certify_lower, certify_upper};
use bracket::certify::velocity_field::VelocityField;
use bracket::elements::hencky_kinematic::Flow;
use bracket::elements::space::Tet10Space;
use bracket::model::AnalysisModel;

/// Strength of the ground \[MPa\].
const F: f64 = 12.0;
/// Length, width and thickness of the plate \[mm\].
const PLATE: [f64; 3] = [200.0, 100.0, 20.0];

/// A plate of `n` cells along its length on ground that crushes; `material`: `r` rigid, `s` steel.
///
/// ```text
///          |← e →|
///          .     ↓ N
///   [▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓]
///          ↑↑↑↑↑↑↑↑↑↑↑  f
/// ```
fn plate(n: usize, material: &str, ground: &str, rest: &str) -> AnalysisModel {
    let mesh = Block::new([n, 2, 1], PLATE).mesh(&["P"], |_| 0, |_, _| true);
    let yaml = format!(
        "{MATERIALS}bodies: {{P: {material}}}\nsupports:\n- {{face: Z0, law: contact, {ground}}}\n\
         {rest}"
    );
    match solved::resolve_as("limit", &yaml, mesh) {
        Ok(model) => model,
        Err(e) => panic!("{e:?}"),
    }
}

/// A force of 1 N down on a rigid plate at `e` from its middle.
fn pressed_at(n: usize, mu: f64, e: f64) -> AnalysisModel {
    let [length, width, thick] = PLATE;
    plate(
        n,
        "r",
        &format!("mu: {mu:?}, strength: {F}"),
        &format!(
            "rigid:\n- {{face: Z1, components: [x, y, z], free: [ux, uy, uz, rx, ry, rz], at: \
             [{:?}, {:?}, {thick:?}], force: [0, 0, -1]}}\n",
            0.5 * length + e,
            0.5 * width
        ),
    )
}

/// Asserts that a bracket holds the exact value and is no wider than `width`.
fn holds(name: &str, [low, up]: [f64; 2], exact: f64, width: f64) {
    assert!(
        low <= exact * (1.0 + 1e-9) && up >= exact * (1.0 - 1e-9),
        "{name}: [{low}, {up}] misses {exact}"
    );
    assert!((up - low) / exact <= width, "{name}: [{low}, {up}] around {exact}");
}

/// N_max = f B (L − 2 e): the plate turns about a line at L − 2e from its pressed edge. The bracket
/// is exact where that line is one of the mesh, and narrow elsewhere.
#[test]
fn eccentric_force() {
    let [length, width, _] = PLATE;
    for (e, n, wide) in [(0.0, 4, 1e-6), (30.0, 10, 1e-6), (33.0, 20, 1e-2), (71.3, 20, 1e-2)] {
        let exact = F * width * (length - 2.0 * e);
        let name = format!("e = {e}");
        let got = sharp_factors(&name, &pressed_at(n, 0.0, e)).map(|x| x * FY);
        holds(&name, got, exact, wide);
    }
}

/// An anchor that yields at T on the other side: N + T = f B x, N e = f B x (L − x)/2 + T (a − L/2)
/// with the distance a of the anchor from the pressed edge.
#[test]
fn eccentric_force_with_an_anchor() {
    let [length, width, thick] = PLATE;
    let (t, a) = (60e3, 170.0);
    for e in [40.0, 90.0, 300.0] {
        // (f B x − T) e = f B x (L − x)/2 + T (a − L/2)
        let fb = F * width;
        let (b, c) = (fb * (e - 0.5 * length), -t * (e + a - 0.5 * length));
        let x = (-b + (b * b - 2.0 * fb * c).sqrt()) / fb;
        let exact = fb * x - t;
        let m = plate(
            20,
            "r",
            &format!("mu: 0, strength: {F}"),
            &format!(
                "rigid:\n- {{face: Z1, components: [x, y, z], free: [ux, uy, uz, rx, ry, rz], at: \
                 [{:?}, {:?}, {thick:?}], force: [0, 0, -1], dead_force: [0, 0, -{t:?}], \
                 dead_moment: [0, {:?}, 0]}}\n",
                0.5 * length + e,
                0.5 * width,
                t * (length - a - 0.5 * length - e)
            ),
        );
        let name = format!("anchor, e = {e}");
        holds(&name, sharp_factors(&name, &m).map(|x| x * FY), exact, 1e-2);
    }
}

/// A steel plate under an even pressure carries the strength of the ground, whatever it is beside a
/// dead pressure; with strong ground it yields nowhere, and the plate still has that limit.
#[test]
fn even_pressure() {
    for (dead, left) in [(0.0, F), (5.0, F - 5.0)] {
        let loads = format!(
            "loads:\n- {{face: Z1, traction: [0, 0, -1]}}\ndead:\n- {{face: Z1, traction: [0, 0, \
             -{dead:?}]}}\n"
        );
        let m = plate(6, "s", &format!("mu: 0, strength: {F}"), &loads);
        let name = format!("dead {dead}");
        holds(&name, sharp_factors(&name, &m).map(|x| x * FY), left, 1e-5);
    }
}

/// Friction counts with the pressure that the ground carries: V ≤ μ N with a dead N, and an
/// inclined force crushes the ground where V < μ N.
#[test]
fn friction() {
    let [length, width, _] = PLATE;
    let ground = format!("mu: 0.4, strength: {F}");
    let at = format!("at: [{:?}, {:?}, 0]", 0.5 * length, 0.5 * width);
    let face = "face: Z1, components: [x, y, z], free: [ux, uy, uz, rx, ry, rz]";
    let n = 0.7 * F * length * width;
    let slide =
        format!("rigid:\n- {{{face}, {at}, force: [1, 0, 0], dead_force: [0, 0, -{n:?}]}}\n");
    let m = plate(6, "r", &ground, &slide);
    holds("slide", sharp_factors("slide", &m).map(|x| x * FY), 0.4 * n, 1e-5);
    let inclined = format!("rigid:\n- {{{face}, {at}, force: [0.3, 0, -1]}}\n");
    let m = plate(6, "r", &ground, &inclined);
    holds("inclined", sharp_factors("inclined", &m).map(|x| x * FY), F * length * width, 1e-5);
}

/// A load that lifts the plate has the factor zero; no strength of the ground helps.
#[test]
fn lifting() {
    let m = plate(
        4,
        "s",
        &format!("mu: 0, strength: {F}"),
        "loads:\n- {face: Z1, traction: [0, 0, 1]}\n",
    );
    let pass = run(&m);
    assert!(pass.free.is_some(), "{pass:?}");
    let pressed = plate(
        4,
        "s",
        &format!("mu: 0, strength: {F}"),
        "loads:\n- {face: Z1, traction: [0, 0, -1]}\n",
    );
    assert!(run(&pressed).unlimited.is_none());
    let rigid = plate(4, "s", "mu: 0", "loads:\n- {face: Z1, traction: [0, 0, -1]}\n");
    holds("rigid ground", sharp_factors("rigid ground", &rigid), 1.0, 1e-5);
}

/// The certificates see what the ground carries and dissipates: weaker ground is overloaded by the
/// stored stress, and a plate that sinks evenly dissipates f times the area.
#[test]
fn certificates() {
    let m = pressed_at(10, 0.0, 30.0);
    let pass = run(&m);
    factors_of("certificates", &m, &pass);
    let (stress, bracket) = (pass.stress.as_ref().unwrap(), pass.bracket.as_ref().unwrap());
    let factor = bracket.lower().certificate().factor;
    let used = certify_lower(&m, stress, factor).ground.unwrap();
    assert!(used <= 1.0 && used > 0.999, "{used}");
    let mut weaker = m.clone();
    weaker.ground[0].strength = Some(0.9 * F);
    let over = certify_lower(&weaker, stress, factor);
    assert!((over.ground.unwrap() - used / 0.9).abs() < 1e-12 && over.worst() > 1.0, "{over:?}");

    let [length, width, _] = PLATE;
    let nodes = Tet10Space::new(&m.mesh).nodes.len();
    let moved = |u: [f64; 3]| {
        let nodes = DisplacementField { u: vec![u; nodes] };
        certify_upper(&m, &VelocityField { nodes, flow: Flow::Split, limit_motions: Vec::new() }, 1)
    };
    let sinks = moved([0.0, 0.0, -2.0]);
    let all = 2.0 * F * length * width;
    assert!((sinks.ground[0] / all - 1.0).abs() < 1e-12, "{sinks:?}");
    assert!((sinks.factor / (0.5 * all) - 1.0).abs() < 1e-12, "{sinks:?}");
    assert_eq!(sinks.contact, None);
    assert_eq!(moved([0.0, 0.0, 2.0]).ground, [0.0]);
}

/// The dissipation bounds the integral of the closing over random quadratic velocities.
#[test]
fn dissipation_is_an_upper_bound() {
    let m = plate(
        3,
        "s",
        &format!("mu: 0, strength: {F}"),
        "loads:\n- {face: Z1, traction: [0, 0, -1]}\n",
    );
    let space = Tet10Space::new(&m.mesh);
    let mut numbers = Random::new(7);
    for _ in 0..20 {
        let c: [f64; 6] = std::array::from_fn(|_| 2.0 * numbers.unit() - 1.0);
        let [length, width, _] = PLATE;
        let w = |x: f64, y: f64| {
            let (x, y) = (x / length, y / width);
            c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y
        };
        let u = space.nodes.iter().map(|x| [0.0, 0.0, w(x[0], x[1])]).collect();
        let field = VelocityField {
            nodes: DisplacementField { u },
            flow: Flow::Split,
            limit_motions: Vec::new(),
        };
        let got = certify_upper(&m, &field, 0).ground[0];
        // midpoint rule
        let n = 400;
        let step = |i: usize, all: f64| (i as f64 + 0.5) * all / n as f64;
        let cells = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let closing: f64 = cells.map(|(i, j)| (-w(step(i, length), step(j, width))).max(0.0)).sum();
        let integral = F * closing * length * width / (n * n) as f64;
        assert!(got >= integral * (1.0 - 1e-4), "{got} < {integral}");
        assert!(got <= 1.1 * integral + 0.01 * F * length * width, "{got} ≫ {integral}");
    }
}
