//! Hard cases of elastic, perfectly plastic analysis, with the same two blocks as in limit
//! analysis. The result is a strict bracket of the known energy, or a report that no equilibrium
//! exists.
//!
//! ```text
//!    ↓ ↓ ↓  p           two blocks one upon the other, free to widen:
//!   |  B  |             energy −p A g − p² A L / 2E, none above f_y
//!   |~~~~~| μ, gap g
//!   |  A  |
//!   ///////
//! ```

use crate::common::plastic::{run, strict, strict_pass};
use crate::common::yielding::{E, FY};
use crate::common::{Block, solved};
use bracket::mesh::TetMesh;
use bracket::model::AnalysisKind;
use bracket::model::AnalysisModel;

const SIZE: [f64; 3] = [10.0, 8.0, 12.0];

fn blocks(seed: u64) -> TetMesh {
    let shape = Block { cells: [2, 2, 4], min: [0.0; 3], max: SIZE, jitter: 0.2, seed };
    shape.mesh(&["A", "B"], |c| usize::from(c[2] > 6.0), |d, x| d == 2 && (x - 6.0).abs() < 1e-9)
}

/// Two blocks. `material` is that of the lower one; `foot` is its support.
fn pressed(material: &str, mu: f64, gap: f64, foot: &str, load: &str) -> AnalysisModel {
    let law = if mu > 0.0 { ", friction: associated" } else { "" };
    let yaml = format!(
        "materials: {{a: {material}, b: {{E: {E:?}, nu: 0.3, fy: {FY:?}}}}}\nbodies: {{A: a, B: \
         b}}\ninterfaces:\n- {{between: [A, B], law: contact, mu: {mu:?}, gap: \
         {gap:?}{law}}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: \
         [y]}}\n{foot}loads:\n- {{face: Z1, {load}}}\n"
    );
    match solved::resolve(&yaml, blocks(5)) {
        Ok(model) => AnalysisModel { analysis: AnalysisKind::Elastoplastic, ..model },
        Err(e) => panic!("{e:?}"),
    }
}

const STEEL: &str = "{E: 210000, nu: 0.3, fy: 235}";
const ROLLER: &str = "- {face: Z0, fix: [z]}\n";
const CLAMPED: &str = "- {face: Z0, fix: [x, y, z]}\n";

#[test]
fn any_friction_any_gap_and_small_loads() {
    let area = SIZE[0] * SIZE[1];
    for (mu, gap, p) in [
        (1e-3, 0.0, 0.9 * FY),
        (2.0, 0.0, 0.9 * FY),
        (0.3, 1e-6, 0.9 * FY),
        (0.3, 5.0, 0.9 * FY),
        (0.3, 0.0, 1e-9 * FY),
    ] {
        let name = format!("μ {mu}, gap {gap}, p {p}");
        let energy = -p * area * gap - p * p * area * SIZE[2] / (2.0 * E);
        for bound in strict(&name, &pressed(STEEL, mu, gap, ROLLER, &format!("pressure: {p:?}"))) {
            assert!((bound / energy - 1.0).abs() < 1e-6, "{name}: {bound} against {energy}");
        }
    }
}

/// Beyond the limit load there is no equilibrium, however large the load is.
#[test]
fn loads_that_cannot_be_carried() {
    for p in [1.01 * FY, 1e9 * FY] {
        let model = pressed(STEEL, 0.3, 0.0, ROLLER, &format!("pressure: {p:?}"));
        let pass = run(&model);
        assert!(pass.bracket.is_none() && pass.lower.is_none() && pass.upper.is_none(), "p {p}");
        assert!(
            pass.runs().any(|(_, r)| r.mechanism.is_some()),
            "p {p}: {:?} {:?}",
            pass.kinematic,
            pass.statics
        );
    }
}

/// Yield next to a clamped foot: in a material that is nearly incompressible, and below a material
/// that is a million times as stiff.
#[test]
fn extreme_materials() {
    for (name, material) in
        [("ν 0.4999", "{E: 210000, nu: 0.4999, fy: 235}"), ("soft", "{E: 0.21, nu: 0.3}")]
    {
        let model = pressed(material, 0.3, 0.0, CLAMPED, "traction: [12.0, 0.0, -200.0]");
        let pass = run(&model);
        let [low, up] = strict_pass(name, &model, &pass);
        assert!(low < up && up < 0.0, "{name}: [{low}, {up}]");
    }
}
