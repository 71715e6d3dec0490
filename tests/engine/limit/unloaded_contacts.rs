//! Contacts that carry no force, and parts that only contact holds: the lower bound is strict in
//! every kind of analysis, or the reason is true.
//!
//! ```text
//!        [ HIGH ]        BASE is held and loaded; LOW and HIGH lie on it
//!        [ LOW  ]        without load. No equilibrium presses them, so that
//!   F →  [ BASE ]        BASE alone gives the bounds.
//!        ////////
//! ```

use crate::common::grid::name;
use crate::common::limit::{run as limit, strict as strict_factors};
use crate::common::plastic::{plastic_model, run as plastic, strict_pass};
use crate::common::solved::{self, Solved};
use crate::common::yielding::MATERIALS;
use crate::common::{Block, beside, mapped, renamed};
use bracket::certify::sampling::sample_lower;
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;

/// Friction of contacts in the model file.
const LAWS: [&str; 3] = ["mu: 0", "mu: 0.3, friction: associated", "mu: 0.3, friction: coulomb"];
/// Parts of a stack, from below, each of this height \[mm\].
const PARTS: [&str; 3] = ["BASE", "LOW", "HIGH"];
const HEIGHT: f64 = 6.0;

/// The lowest `parts` of the stack; `LOADED` is a side of the base, `TOP` that of the highest part.
fn stack(parts: usize) -> TetMesh {
    let size = [10.0, 8.0, HEIGHT * parts as f64];
    let shape = Block { cells: [2, 2, 2 * parts], min: [0.0; 3], max: size, jitter: 0.15, seed: 3 };
    let mut mesh = shape.mesh(
        &PARTS[..parts],
        |c| (c[2] / HEIGHT) as usize,
        |d, x| d == 2 && (x / HEIGHT - (x / HEIGHT).round()).abs() < 1e-9,
    );
    name(&mut mesh, "LOADED", "BASE", |x| x[0] == size[0]);
    name(&mut mesh, "TOP", PARTS[parts - 1], |x| x[2] == size[2]);
    mesh
}

/// Bodies, contacts and support of the stack in the model file.
fn held(parts: usize, law: &str) -> String {
    let bodies: Vec<String> = PARTS[..parts].iter().map(|p| format!("{p}: s")).collect();
    let pairs: String = PARTS[..parts]
        .windows(2)
        .map(|p| format!("- {{between: [{}, {}], law: contact, {law}}}\n", p[0], p[1]))
        .collect();
    let interfaces = if parts > 1 { format!("interfaces:\n{pairs}") } else { String::new() };
    let bodies = bodies.join(", ");
    format!("bodies: {{{bodies}}}\n{interfaces}supports:\n- {{face: Z0, fix: [x, y, z]}}\n")
}

/// The stack with a load on its base.
fn pushed(parts: usize, law: &str) -> String {
    format!("{}loads:\n- {{face: LOADED, traction: [-60, 5, 20]}}\n", held(parts, law))
}

fn elastic_run(yaml: &str, mesh: TetMesh) -> Solved {
    solved::solve(&format!("{MATERIALS}{yaml}"), mesh)
}

fn limit_model(yaml: &str, mesh: TetMesh) -> AnalysisModel {
    match solved::resolve_as("limit", &format!("{MATERIALS}{yaml}"), mesh) {
        Ok(model) => model,
        Err(e) => panic!("{e:?}"),
    }
}

/// All parts of the stack but the base are free of stress in the field of the lower bound.
fn without_stress(model: &AnalysisModel, stress: &bracket::certify::fields::StressField) {
    let size =
        |e: usize| stress.points[e].iter().flatten().flatten().fold(0.0f64, |m, s| m.max(s.abs()));
    let largest = |base: bool| {
        let tets = (0..model.mesh.tets.len()).filter(|e| (model.mesh.tet_body[*e] == 0) == base);
        tets.map(size).fold(0.0, f64::max)
    };
    assert!(largest(false) <= 1e-9 * largest(true), "{} of {}", largest(false), largest(true));
}

#[test]
fn elastic_parts_that_touch_a_loaded_one() {
    let alone = elastic_run(&pushed(1, ""), stack(1)).strict("base alone");
    for parts in [2, 3] {
        for law in LAWS {
            let solved = elastic_run(&pushed(parts, law), stack(parts));
            let name = format!("{parts} parts, {law}");
            let [low, up] = solved.strict(&name);
            assert!(low <= up, "{name}");
            let exact = |a: f64, b: f64| (a / b - 1.0).abs() < 0.05;
            assert!(exact(low, alone[0]) && exact(up, alone[1]), "{name}: {alone:?}");
            without_stress(&solved.model, solved.pass.stress.as_ref().unwrap());
        }
    }
}

#[test]
fn plastic_parts_that_touch_a_loaded_one() {
    for parts in [2, 3] {
        for law in LAWS {
            // three quarters of the load that the base carries on this mesh
            let yaml = pushed(parts, law).replace("[-60, 5, 20]", "[-90, 7.5, 30]");
            let model = plastic_model(&yaml, stack(parts));
            let pass = plastic(&model);
            let mut model = model;
            model.shift = pass.shift.clone();
            let [low, up] = strict_pass(&format!("{parts} parts, {law}"), &model, &pass);
            assert!(low <= up);
        }
    }
}

#[test]
fn load_factors_with_parts_that_touch_a_loaded_one() {
    let model = limit_model(&pushed(1, ""), stack(1));
    let alone = strict_factors("base alone", &model, &limit(&model));
    for parts in [2, 3] {
        for law in LAWS {
            let name = format!("{parts} parts, {law}");
            let model = limit_model(&pushed(parts, law), stack(parts));
            let pass = limit(&model);
            let bounds = strict_factors(&name, &model, &pass);
            assert!(bounds.iter().zip(alone).all(|(a, b)| (a / b - 1.0).abs() < 0.05), "{name}");
            if law != LAWS[0] {
                let smooth = pass.frictionless.as_ref().expect("a bound without friction");
                assert!(smooth.is_strict() && smooth.value() <= pass.upper.unwrap().value());
            }
            let factor = pass.lower.as_ref().unwrap().certificate().factor;
            let s = sample_lower(&model, pass.stress.as_ref().unwrap(), factor, 300);
            assert!(s.traction_jump < 1e-9 && s.traction_cone < 1e-9, "{name}: {s:?}");
        }
    }
}

/// Two blocks on the ground, one of them pressed or neither.
#[test]
fn ground_without_pressure() {
    let idle = Block::new([2, 2, 2], [10.0; 3]).jittered(4).mesh(&["IDLE"], |_| 0, |_, _| false);
    let busy = Block::new([2, 2, 2], [10.0; 3]).jittered(6).mesh(&["BUSY"], |_| 0, |_, _| false);
    let busy = mapped(renamed(busy, "Z1", "TOP"), |x| [x[0] + 20.0, x[1], x[2]]);
    for pressure in [100.0f64, 0.0] {
        for law in LAWS {
            let yaml = format!(
                "bodies: {{IDLE: s, BUSY: s}}\nsupports:\n- {{face: Z0, law: contact, \
                 {law}}}\nloads:\n- {{face: TOP, pressure: {pressure:?}}}\n"
            );
            let solved = elastic_run(&yaml, beside(idle.clone(), busy.clone()));
            let name = format!("pressure {pressure}, {law}");
            let [low, up] = solved.strict(&name);
            // −½ p² V/E; friction holds the pressed face against widening
            let free = -0.5 * pressure * pressure * 1000.0 / 210_000.0;
            let held = if law == LAWS[0] { 1e-6 } else { 0.1 * free.abs() + 1e-9 };
            assert!(low <= up && low > free - 1e-6 && up < free + held, "[{low}, {up}], {free}");
        }
    }
}

/// A block in a corner of three walls without friction, pressed on all of them, and one upon it.
#[test]
fn pressed_on_contacts_without_friction() {
    let mesh = stack(2);
    let walls = "bodies: {BASE: s, LOW: s}\ninterfaces:\n- {between: [BASE, LOW], law: contact, \
                 mu: 0}\nsupports:\n- {face: X0, law: contact, mu: 0}\n- {face: Y0, law: contact, \
                 mu: 0}\n- {face: Z0, law: contact, mu: 0}\nloads:\n- {face: TOP, pressure: \
                 60}\n- {face: X1, pressure: 30}\n- {face: Y1, pressure: 30}\n";
    // uniform stress: −½ σ:C⁻¹:σ per volume
    let (p, q) = (60.0, 30.0);
    let density = 0.5 / 210_000.0 * (p * p + 2.0 * q * q - 0.6 * (2.0 * p * q + q * q));
    elastic_run(walls, mesh.clone()).exact("corner", -density * 80.0 * 2.0 * HEIGHT, 1e-6);
    let model = plastic_model(walls, mesh.clone());
    strict_pass("corner", &model, &plastic(&model));
    // von Mises: the axial stress differs by λ (p − q)
    let model = limit_model(walls, mesh);
    let bounds = strict_factors("corner", &model, &limit(&model));
    assert!(bounds.iter().all(|b| (b * (p - q) - 1.0).abs() < 1e-3), "{bounds:?}");
}

/// A pull lifts the upper part: the reason is its motion.
#[test]
fn no_equilibrium_names_the_part_and_its_motion() {
    for law in LAWS {
        let lifted = format!("{}loads:\n- {{face: TOP, pressure: -5}}\n", held(2, law));
        elastic_run(&lifted, stack(2)).no_equilibrium(law, "part LOW moves along +z");
        let dead = format!(
            "{}dead:\n- {{face: TOP, pressure: -5}}\nloads:\n- {{face: LOADED, pressure: 20}}\n",
            held(2, law)
        );
        let model = limit_model(&dead, stack(2));
        let pass = limit(&model);
        assert!(pass.lower.is_none() && pass.bracket.is_none());
        let statics = pass.statics.as_ref().expect("asked for");
        println!("{law}: {:?} {:?} {:?}", statics.status, statics.mechanism, statics.trouble);
        assert!(!statics.status.is_solution());
        if let Some(reason) = statics.mechanism.as_ref().or(statics.trouble.as_ref()) {
            // with friction many motions open the contact, along and across it
            let motion = if law == LAWS[0] { "part LOW moves along +z" } else { "part LOW moves" };
            assert!(reason.to_string().contains(motion), "{reason}");
        }
    }
}
