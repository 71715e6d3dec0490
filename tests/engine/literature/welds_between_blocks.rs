//! Welds of finite strength between elastic blocks: rigid, perfectly plastic bonds with known
//! energies.
//!
//! Two bars of 10 mm × 12 mm² (ν = 0) meet at x = 10; t is the traction of the weld between them, S
//! its strength.
//!
//! ```text
//!  pulled                        between walls, B under a force b per volume
//!  |[ A ]:[ B ]→ p               |[ A ]:[ B → b ]|
//! ```
//!
//! Pulled: t = p; as if tied below S, no equilibrium above. Between walls: tied, t = b L/4; above S
//! the weld yields, t = S, and the wall behind B carries the rest of b. The fields are linear and
//! quadratic in x, so both programs are exact. Tolerance 1e-6, that of the solver's gap.

use crate::common::Block;
use crate::common::solved::{Solved, resolve, solve};
use bracket::mesh::TetMesh;
use bracket::solve::SolveStatus;

const E: f64 = 210_000.0;
const L: f64 = 10.0;
const AREA: f64 = 12.0;

fn bars(seed: u64) -> TetMesh {
    let shape =
        Block { cells: [4, 2, 2], min: [0.0; 3], max: [2.0 * L, 3.0, 4.0], jitter: 0.2, seed };
    shape.mesh(&["A", "B"], |c| usize::from(c[0] > L), |d, x| d == 0 && (x - L).abs() < 1e-9)
}

fn yaml(strength: f64, rest: &str) -> String {
    format!(
        "materials: {{m: {{E: 210000, nu: 0}}}}\nbodies: {{A: m, B: m}}\ninterfaces:\n- \
         {{between: [A, B], law: weld, strength_traction: {strength:?}}}\n{rest}"
    )
}

fn pulled(p: f64, strength: f64, seed: u64) -> Solved {
    let held = "supports:\n- {face: X0, fix: [x, y, z]}\n";
    solve(
        &yaml(strength, &format!("{held}loads:\n- {{face: X1, traction: [{p:?}, 0, 0]}}\n")),
        bars(seed),
    )
}

#[test]
fn pulled_below_the_strength() {
    for seed in [1, 2, 3] {
        let p = 100.0;
        let tied = -0.5 * p * p * 2.0 * L * AREA / E;
        let solved = pulled(p, 101.0, seed);
        solved.exact("weld, pulled", tied, 1e-6);
        let used = solved.pass.lower.as_ref().unwrap().certificate().weld.unwrap();
        // the error of a field is the square root of the gap (1e-8) of its energy
        assert!((used - 100.0 / 101.0).abs() < 1e-4, "{used}");
    }
}

#[test]
fn pulled_beyond_the_strength() {
    let solved = pulled(100.0, 99.0, 1);
    assert!(solved.pass.bracket.is_none());
    for r in [solved.pass.kinematic.as_ref().unwrap(), solved.pass.statics.as_ref().unwrap()] {
        println!("{:?} after {}: {:?}", r.status, r.iterations, r.mechanism);
        assert_eq!(r.status, SolveStatus::Unbounded);
        assert!(
            r.mechanism.as_ref().is_some_and(|m| m.to_string().contains("part B moves along +x")),
            "{:?}",
            r.mechanism
        );
    }
}

/// Energy between walls with the traction t in the weld and the jump g across it.
fn between_walls(b: f64, t: f64, g: f64) -> f64 {
    let strain = 0.5 * AREA / E * (t * t * L + t * t * L - t * b * L * L + b * b * L.powi(3) / 3.0);
    let work = -AREA * b / E * (0.5 * t * L * L - b * L.powi(3) / 3.0);
    strain + t * AREA * g - work
}

#[test]
fn between_walls_tied_and_giving_way() {
    let b = 8.0;
    let held = "supports:\n- {face: X0, fix: [x, y, z]}\n- {face: X1, fix: [x, y, z]}\n";
    for (strength, seed) in [(30.0, 1), (15.0, 2), (5.0, 3)] {
        let rest = format!("{held}loads:\n- {{body: B, force: [{b:?}, 0, 0]}}\n");
        let solved = solve(&yaml(strength, &rest), bars(seed));
        let t = f64::min(strength, 0.25 * b * L);
        let jump = (0.5 * b * L * L - 2.0 * t * L) / E;
        solved.exact("weld between walls", between_walls(b, t, jump), 1e-6);
        let work = solved.pass.upper.as_ref().unwrap().certificate().welds[0];
        let want = t * AREA * jump;
        assert!((work - want).abs() < 1e-5 * (t * AREA * L * b * L / E), "{work} against {want}");
        // the weld dissipates, so the energy does not give the displacement of the load
        assert!(solved.pass.lower.as_ref().unwrap().certificate().weld.unwrap() <= 1.0);
    }
}

/// A weld beside a contact that opens: two blocks are pressed together on one half of their joint
/// and welded on the other. The bracket is strict and contains the energy from the bracket of a
/// finer mesh.
#[test]
fn welded_and_in_contact() {
    let at = |n: usize| {
        let shape = Block {
            cells: [2, 1, 2 * n],
            min: [0.0; 3],
            max: [20.0, 10.0, 20.0],
            jitter: 0.15,
            seed: 6,
        };
        let flat = |d: usize, x: f64| {
            (d == 2 && (x - 10.0).abs() < 1e-9) || (d == 0 && (x - 10.0).abs() < 1e-9)
        };
        let mut mesh = shape.mesh(&["A", "B"], |c| usize::from(c[2] > 10.0), flat);
        let half = crate::common::triangles_where(&mesh, |x| x[2] == 10.0 && x[0] <= 10.0);
        mesh.faces.push(bracket::mesh::NamedFaces { name: "HALF".into(), triangles: half });
        let rest = crate::common::triangles_where(&mesh, |x| x[2] == 10.0 && x[0] >= 10.0);
        mesh.faces.push(bracket::mesh::NamedFaces { name: "REST".into(), triangles: rest });
        solve(
            "materials: {m: {E: 210000, nu: 0.3}}\nbodies: {A: m, B: m}\ninterfaces:\n- {between: \
             [A, B], face: HALF, law: weld, strength_traction: 30}\n- {between: [A, B], face: \
             REST, law: contact, mu: 0.2, friction: associated}\nsupports:\n- {face: Z0, fix: [x, \
             y, z]}\nloads:\n- {face: Z1, traction: [6, 0, 2]}\n",
            mesh,
        )
        .strict("welded and in contact")
    };
    let ([low, up], [finer_low, finer_up]) = (at(1), at(2));
    assert!(low <= finer_up && finer_low <= up, "[{low}, {up}] and [{finer_low}, {finer_up}]");
}

#[test]
fn wrong_welds_are_refused() {
    let rows = [
        ("throat: 5, thickness: 8", "lacks `strength`"),
        ("throat: 5, strength: 200", "lacks `thickness`"),
        ("thickness: 8", "lacks `throat` and `strength`"),
        ("name: 3", "unknown"),
        ("throat: 0, thickness: 8, strength: 200", "`throat` of the weld is 0, it must be > 0"),
        ("throat: 5, thickness: -8, strength: 200", "`thickness` of the weld is -8"),
        ("throat: 5, thickness: 8, strength: .inf", "finite"),
        ("throat: 5, thickness: 8, strength: 200, strength_traction: 100", "either `throat`"),
        ("strength_traction: 0", "`strength_traction` of the weld is 0"),
        ("strength_traction: .nan", "finite"),
        ("strength_traction: 100, mu: 0.3", "`mu` has no meaning for `law: weld`"),
        ("strength_traction: 100, gap: 1", "`gap` has no meaning"),
        ("strength_traction: 100, friction: associated", "`friction` has no meaning"),
        ("strength_traction: 100 MPa", "a number without a unit"),
        ("throat: 1.0e200, thickness: 1.0e-200, strength: 1.0e200", "out of range"),
    ];
    let rest =
        "supports:\n- {face: X0, fix: [x, y, z]}\nloads:\n- {face: X1, traction: [1, 0, 0]}\n";
    for (weld, words) in rows {
        let text = yaml(1.0, rest).replace("strength_traction: 1.0", weld);
        let d = resolve(&text, bars(1)).expect_err(weld);
        let messages: Vec<String> =
            d.iter().map(|d| format!("{} {:?}", d.message, d.help)).collect();
        assert!(messages.iter().any(|m| m.contains(words)), "{weld}: {messages:?}");
    }
    // keys for a contact alone, and for a weld alone
    let contact = yaml(1.0, rest).replace("law: weld, ", "law: contact, mu: 0, ");
    let d = resolve(&contact, bars(1)).expect_err("contact");
    assert!(d.first().message.contains("has no meaning for `law: contact`"), "{d:?}");
}
