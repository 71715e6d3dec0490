//! Models of bodies that yield, for tests and benchmarks of the elastic, perfectly plastic
//! programs.

use super::{Block, solved};
use bracket::elements::hencky_kinematic::Flow;
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;
use bracket::programs::conic::ConicProgram;
use bracket::programs::{Kinematic, Static};
use bracket::solve::Solution;

/// Steel that yields: E \[MPa\], ν, f_y \[MPa\].
pub const E: f64 = 210_000.0;
pub const NU: f64 = 0.3;
pub const FY: f64 = 235.0;

/// Materials of the YAML: `s` yields, `r` never yields.
pub const MATERIALS: &str =
    "materials: {s: {E: 210000, nu: 0.3, fy: 235}, r: {E: 210000, nu: 0.3}}\n";

/// A model from YAML without `mesh`, `analysis` and `materials`.
pub fn model(yaml: &str, mesh: TetMesh) -> AnalysisModel {
    match solved::resolve(&format!("{MATERIALS}{yaml}"), mesh) {
        Ok(model) => model,
        Err(e) => panic!("{e:?}"),
    }
}

/// A cube of 100 mm with `n` cells along a side (6 tets each, inner nodes jittered). It is clamped
/// at the bottom and pressed and sheared at the top.
///
/// Measured on 5 cells, the static program carries 1.1 times this load and not 1.15 times. On 4
/// cells, the split kinematic program carries 1.2 times and hardly 1.3 times this load. `factor` 1
/// is therefore about 80 % of the limit load. 12 cells make 10 368 tets, 18 cells make 34 992.
///
/// ```text
///      p, t
///    ↓→↓→↓→↓
///   +-------+
///   |       |    p = 0.63 f_y, t = p/4
///   +-------+
///   /////////
/// ```
pub fn block(n: usize, factor: f64) -> AnalysisModel {
    let mesh = Block::new([n; 3], [100.0; 3]).jittered(1).mesh(&["B"], |_| 0, |_, _| false);
    let p = 0.63 * FY * factor;
    let t = 0.25 * p;
    let support = "bodies: {B: s}\nsupports:\n- {face: Z0, fix: [x, y, z]}\n";
    model(&format!("{support}loads:\n- {{face: Z1, traction: [{t:?}, 0, {:?}]}}\n", -p), mesh)
}

/// A plate of 200 × 200 × 20 mm with a mesh plane at mid-thickness and `n` × `n` cells in two
/// layers (four layers from 36 cells on). It is clamped on one side. A transverse force acts on the
/// opposite side: f_y h²/4 over the span, the load that a beam would carry.
///
/// Measured on 5 cells, the static program carries 1.12 times this load and not 1.16 times. A wide
/// clamped plate without free sides carries 2/√3 times this load. `factor` 1 is therefore between
/// 80 and 90 % of the limit load. 29 cells make 10 092 tets, 37 cells make 32 856.
pub fn plate(n: usize, factor: f64) -> AnalysisModel {
    let flat = |axis: usize, x: f64| axis == 2 && (x - 10.0).abs() < 1e-9;
    let layers = if n < 36 { 2 } else { 4 };
    let mesh =
        Block::new([n, n, layers], [200.0, 200.0, 20.0]).jittered(1).mesh(&["B"], |_| 0, flat);
    let t = FY * 20.0 / (4.0 * 200.0) * factor;
    let support = "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x, y, z]}\n";
    model(&format!("{support}loads:\n- {{face: X1, traction: [0, 0, {:?}]}}\n", -t), mesh)
}

/// One of the three programs of a model that yields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    Plain,
    Split,
    Static,
}

pub const FORMS: [Form; 3] = [Form::Plain, Form::Split, Form::Static];

/// A program, the block of each shared unknown, and the position where the own unknowns of each
/// element start.
pub struct Built {
    pub program: ConicProgram,
    pub block: Vec<u32>,
    pub own: Vec<usize>,
}

impl Form {
    pub fn build(self, model: &AnalysisModel) -> Built {
        let kinematic = |flow| {
            let k = Kinematic::with_plasticity(model, flow).unwrap();
            Built { program: k.program, block: k.map.block, own: k.own }
        };
        match self {
            Form::Plain => kinematic(Flow::Plain),
            Form::Split => kinematic(Flow::Split),
            Form::Static => {
                let s = Static::with_plasticity(model).unwrap();
                Built { program: s.program, block: s.map.block, own: s.own }
            }
        }
    }
}

impl Built {
    /// Share of the elements with own unknowns that flow: their plastic strain, or its multiplier
    /// over the volume of the element, exceeds 1 % of the strain at yield.
    pub fn flowing(&self, model: &AnalysisModel, solution: &Solution) -> f64 {
        let least = 0.01 * FY / E;
        let radius = bracket::math::mandel::yield_radius(FY);
        let elements: Vec<usize> =
            (0..model.mesh.tets.len()).filter(|&e| self.own[e + 1] > self.own[e]).collect();
        let points = &solution.z[self.program.g.nrows()..];
        let per_element = points.len() / elements.len();
        let flows = |e: usize, z: &[f64]| {
            // a multiplier is plastic strain times yield radius times volume (in the static
            // program, times the share of the volume at a point)
            let largest = z.chunks_exact(6).fold(0.0f64, |m, z| m.max(z[0]));
            largest * (per_element / 6) as f64 / (radius * model.mesh.volume(e)) > least
        };
        let count = elements
            .iter()
            .zip(points.chunks_exact(per_element))
            .filter(|(e, z)| flows(**e, z))
            .count();
        count as f64 / elements.len() as f64
    }
}
