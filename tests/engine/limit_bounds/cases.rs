//! Limit states with a linear stress and a mechanism that both elements represent exactly on any
//! mesh.
//!
//! ```text
//!   bar                 cube            box, lid rigid     pressed by
//!                        t→             t→ [======]        rigid block
//!  |[=======]→ N      t↑[   ]↑t        t↑[       ]↑t     |[=====|▓▓▓]← N
//!                        ←t             ///////////        μ = 0
//!
//!   sliding under dead N    sliding under own
//!         N, t              weight (ground)
//!      v→v→v→v                  →→→→
//!    t↓[ block ]↑t             [ block ]
//!      [ base  ]               ~~~~~~~~~
//!      /////////
//! ```
//! N = f_y A; t = k = f_y/√3; T = μN. Shear on the side faces keeps the stress uniform (or linear,
//! under body forces), so that the limit state is exact. This shear is normal to the slip plane on
//! both sides, so it does no work.

use crate::common::yielding::{FY, model};
use crate::common::{Block, Random, solved};
use bracket::elements::super_element::{PARAMETERS, SuperElement};
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;
use bracket::model::loads::Loads;
use bracket::programs::Static;
use bracket::programs::super_elements::SuperElements;

pub const SEEDS: [u64; 3] = [1, 7, 42];
/// Relative size of the noise added to exact fields.
pub const NOISE: f64 = 1e-5;

type V3 = [f64; 3];

/// A model with its limit state: stress as a Mandel vector and velocities, each by body and
/// position.
pub struct Case {
    pub name: &'static str,
    pub model: AnalysisModel,
    pub factor: f64,
    pub stress: fn(usize, V3) -> [f64; 6],
    /// Stress under the dead loads alone.
    pub dead: Option<fn(usize, V3) -> [f64; 6]>,
    pub velocity: fn(usize, V3) -> V3,
}

const K: f64 = FY / 1.732_050_807_568_877_2;
const R2: f64 = std::f64::consts::SQRT_2;

fn block(cells: [usize; 3], min: V3, max: V3, seed: u64) -> Block {
    Block { cells, min, max, jitter: 0.2, seed }
}

fn one(seed: u64) -> TetMesh {
    block([3, 2, 2], [0.0; 3], [30.0, 10.0, 12.0], seed).mesh(&["A"], |_| 0, |_, _| false)
}

/// Two bodies, the second beyond the plane `x[axis] = at`.
fn two(block: &Block, axis: usize, at: f64) -> TetMesh {
    block.mesh(
        &["A", "B"],
        |c| usize::from(c[axis] > at),
        |d, x| d == axis && (x - at).abs() < 1e-9,
    )
}

pub fn bar(seed: u64) -> Case {
    Case {
        name: "bar",
        model: model(
            "bodies: {A: s}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: \
             Z0, fix: [z]}\nloads:\n- {face: X1, traction: [100, 0, 0]}\n",
            one(seed),
        ),
        factor: FY / 100.0,
        stress: |_, _| [FY, 0.0, 0.0, 0.0, 0.0, 0.0],
        dead: None,
        velocity: |_, x| [x[0], -0.5 * x[1], -0.5 * x[2]],
    }
}

/// The bar with an additional dead tension of 100 MPa.
pub fn bar_under_dead_load(seed: u64) -> Case {
    let mut case = bar(seed);
    case.name = "bar under dead load";
    let mut dead = case.model.surface_loads[0].clone();
    dead.dead = true;
    case.model.surface_loads.push(dead);
    case.factor = FY / 100.0 - 1.0;
    case.dead = Some(|_, _| [100.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    case
}

/// The bar pulled through a rigid face that may rotate.
pub fn bar_with_rigid_end(seed: u64) -> Case {
    let mut case = bar(seed);
    case.name = "bar with rigid end";
    case.model = model(
        "bodies: {A: s}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, \
         fix: [z]}\nrigid:\n- {face: X1, components: [x], free: [ux, ry, rz], at: [30, 5, 6], \
         force: [12000, 0, 0]}\n",
        one(seed),
    );
    case
}

pub fn cube(seed: u64) -> Case {
    Case {
        name: "cube",
        model: model(
            "bodies: {A: s}\nloads:\n- {face: X1, traction: [0, 10, 0]}\n- {face: X0, traction: \
             [0, -10, 0]}\n- {face: Y1, traction: [10, 0, 0]}\n- {face: Y0, traction: [-10, 0, \
             0]}\n",
            one(seed),
        ),
        factor: K / 10.0,
        stress: |_, _| [0.0, 0.0, 0.0, 0.0, 0.0, R2 * K],
        dead: None,
        velocity: |_, x| [x[1], 0.0, 0.0],
    }
}

/// A sheared box. Its lid is a rigid body tied to it.
pub fn lid(seed: u64) -> Case {
    let mesh = two(&block([3, 3, 2], [0.0; 3], [30.0, 15.0, 12.0], seed), 1, 10.0);
    Case {
        name: "lid",
        model: model(
            "bodies: {A: s, B: r}\nsupports:\n- {face: Y0, fix: [x, y, z]}\nloads:\n- {face: X1, \
             traction: [0, 10, 0]}\n- {face: X0, traction: [0, -10, 0]}\n- {face: Y1, traction: \
             [10, 0, 0]}\n",
            mesh,
        ),
        factor: K / 10.0,
        stress: |_, _| [0.0, 0.0, 0.0, 0.0, 0.0, R2 * K],
        dead: None,
        velocity: |_, x| [x[1].min(10.0), 0.0, 0.0],
    }
}

/// A bar pressed by a rigid block through a frictionless contact.
pub fn pressed(seed: u64) -> Case {
    let mesh = two(&block([4, 2, 2], [0.0; 3], [40.0, 10.0, 12.0], seed), 0, 20.0);
    Case {
        name: "pressed",
        model: model(
            "bodies: {A: s, B: r}\ninterfaces:\n- {between: [A, B], law: contact, mu: \
             0}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, fix: \
             [z]}\nloads:\n- {face: X1, traction: [-100, 0, 0]}\n",
            mesh,
        ),
        factor: FY / 100.0,
        stress: |_, _| [-FY, 0.0, 0.0, 0.0, 0.0, 0.0],
        dead: None,
        velocity: |body, x| {
            if body == 0 { [-x[0], 0.5 * x[1], 0.5 * x[2]] } else { [-20.0, 0.0, 0.0] }
        },
    }
}

/// B5: a rigid block on a base is pressed by a dead load and pushed. The base stays below yield.
pub fn sliding(seed: u64) -> Case {
    let mesh = two(&block([4, 2, 3], [0.0, 0.0, -5.0], [20.0, 8.0, 10.0], seed), 2, 0.0);
    Case {
        name: "sliding",
        model: model(
            "bodies: {A: s, B: r}\ninterfaces:\n- {between: [A, B], law: contact, mu: 0.3, \
             friction: associated}\nsupports:\n- {face: Z0, fix: [x, y, z]}\ndead:\n- {face: Z1, \
             traction: [0, 0, -100]}\nloads:\n- {face: Z1, traction: [10, 0, 0]}\n- {face: X1, \
             traction: [0, 0, 10]}\n- {face: X0, traction: [0, 0, -10]}\n",
            mesh,
        ),
        factor: 3.0,
        stress: |_, _| [0.0, 0.0, -100.0, 0.0, R2 * 30.0, 0.0],
        dead: Some(|_, _| [0.0, 0.0, -100.0, 0.0, 0.0, 0.0]),
        velocity: |body, _| if body == 1 { [1.0, 0.0, 0.3] } else { [0.0; 3] },
    }
}

/// A block on rigid ground has a dead weight of 0.5 N/mm³. It is pushed by a live body force of 0.1
/// N/mm³ and the shear that keeps its stress linear: T/N = 0.2 λ = μ. Its stress of 5.6 MPa is near
/// its strength of 6 MPa: in a stronger block at rest, noise would dissipate more than the friction
/// term allows.
pub fn own_weight(seed: u64) -> Case {
    let mesh =
        block([4, 2, 2], [0.0; 3], [20.0, 8.0, 10.0], seed).mesh(&["A"], |_| 0, |_, _| false);
    Case {
        name: "own weight",
        model: solved::resolve(
            "materials: {w: {E: 210000, nu: 0.3, fy: 6}}\nbodies: {A: w}\nsupports:\n- {face: Z0, \
             law: contact, mu: 0.3, friction: associated}\ndead:\n- {body: A, force: [0, 0, \
             -0.5]}\nloads:\n- {body: A, force: [0.1, 0, 0]}\n- {face: X1, linear: {traction0: \
             [0, 0, 1], gradient: [[0, 0, 0], [0, 0, 0], [0, 0, -0.1]]}}\n- {face: X0, linear: \
             {traction0: [0, 0, -1], gradient: [[0, 0, 0], [0, 0, 0], [0, 0, 0.1]]}}\n",
            mesh,
        )
        .unwrap(),
        factor: 1.5,
        stress: |_, x| [0.0, 0.0, -0.5 * (10.0 - x[2]), 0.0, R2 * 0.15 * (10.0 - x[2]), 0.0],
        dead: Some(|_, x| [0.0, 0.0, -0.5 * (10.0 - x[2]), 0.0, 0.0, 0.0]),
        velocity: |_, _| [1.0, 0.0, 0.3],
    }
}

pub fn all(seed: u64) -> Vec<Case> {
    let makers =
        [bar, bar_under_dead_load, bar_with_rigid_end, cube, lid, pressed, sliding, own_weight];
    makers.into_iter().map(|make| make(seed)).collect()
}

/// The fields that a solver of the static program would return: exact except for noise.
pub struct Approximate {
    pub parameters: Vec<[f64; PARAMETERS]>,
    pub contact: Vec<f64>,
    pub factor: f64,
}

impl Case {
    /// The exact stress at `factor` with relative noise. `bare` sets the stress to zero in bodies
    /// that never yield.
    pub fn static_field(
        &self,
        factor: f64,
        noise: f64,
        bare: bool,
        random: &mut Random,
    ) -> Approximate {
        self.static_field_of(self.stress, factor, noise, bare, random)
    }

    pub fn static_field_of(
        &self,
        stress: fn(usize, V3) -> [f64; 6],
        factor: f64,
        noise: f64,
        bare: bool,
        random: &mut Random,
    ) -> Approximate {
        let model = &self.model;
        let radii = model.yield_radii();
        let elements = SuperElements::new(model).under(Loads::at(factor));
        let mut parameters: Vec<[f64; PARAMETERS]> = (0..model.mesh.tets.len())
            .map(|e| {
                let body = model.mesh.tet_body[e] as usize;
                fit(&elements.element(e).unwrap(), &model.mesh.corners(e), |x| stress(body, x))
            })
            .collect();
        let largest = parameters.iter().flatten().fold(0.0f64, |m, a| m.max(a.abs()));
        for (e, a) in parameters.iter_mut().enumerate() {
            a.iter_mut().for_each(|a| *a += noise * largest * (2.0 * random.unit() - 1.0));
            if bare && radii[model.mesh.tet_body[e] as usize].is_none() {
                *a = [0.0; PARAMETERS];
            }
        }
        // multipliers: pressure, then shear over μ along the tangents of the rows
        let statics = Static::new(model).unwrap();
        let mut contact = Vec::new();
        for v in &statics.vertices {
            let at = v.a[v.index];
            let node = statics.elements.faces.nodes[at / 9][at % 9 / 3];
            let x = model.mesh.nodes[node as usize];
            let body = model.mesh.tet_body[statics.elements.faces.tets[at / 9].0 as usize] as usize;
            let t = traction(&stress(body, x), v.normal).map(|t| -t);
            let along = |d: V3| (0..3).map(|i| d[i] * t[i]).sum::<f64>();
            let (t1, t2) = bracket::math::vec3::tangents(v.normal);
            contact.push(along(v.normal));
            if v.mu > 0.0 {
                contact.extend([along(t1) / v.mu, along(t2) / v.mu]);
            }
        }
        let largest = contact.iter().fold(0.0f64, |m, a| m.max(a.abs()));
        contact.iter_mut().for_each(|a| *a += noise * largest * (2.0 * random.unit() - 1.0));
        let factor = factor * (1.0 + noise * (2.0 * random.unit() - 1.0));
        Approximate { parameters, contact, factor }
    }

    /// The exact velocities with relative noise.
    pub fn velocities(&self, noise: f64, random: &mut Random) -> Vec<V3> {
        let space = bracket::elements::space::Tet10Space::new(&self.model.mesh);
        let mut body = vec![0; space.nodes.len()];
        for e in 0..self.model.mesh.tets.len() {
            space
                .tet(&self.model.mesh, e)
                .iter()
                .for_each(|&n| body[n] = self.model.mesh.tet_body[e] as usize);
        }
        let mut u: Vec<V3> =
            space.nodes.iter().zip(body).map(|(x, b)| (self.velocity)(b, *x)).collect();
        let largest = u.iter().flatten().fold(0.0f64, |m, a| m.max(a.abs()));
        u.iter_mut().flatten().for_each(|a| *a += noise * largest * (2.0 * random.unit() - 1.0));
        u
    }

    /// The model with its live loads multiplied and without the distinction of live and dead loads,
    /// for checks without a load factor.
    pub fn loaded(&self, factor: f64) -> AnalysisModel {
        use bracket::model::analysis::Traction;
        let mut m = self.model.clone();
        for l in m.surface_loads.iter_mut().filter(|l| !l.dead) {
            l.traction = match l.traction {
                Traction::Pressure(p) => Traction::Pressure(factor * p),
                Traction::Linear { traction0, gradient } => Traction::Linear {
                    traction0: traction0.map(|x| factor * x),
                    gradient: gradient.map(|r| r.map(|x| factor * x)),
                },
            };
        }
        m.body_loads
            .iter_mut()
            .filter(|l| !l.dead)
            .for_each(|l| l.force = l.force.map(|x| factor * x));
        m.rigid.iter_mut().for_each(|r| r.action = r.action.map(|x| factor * x));
        m
    }
}

fn traction(s: &[f64; 6], n: V3) -> V3 {
    let (yz, xz, xy) = (s[3] / R2, s[4] / R2, s[5] / R2);
    [
        s[0] * n[0] + xy * n[1] + xz * n[2],
        xy * n[0] + s[1] * n[1] + yz * n[2],
        xz * n[0] + yz * n[1] + s[2] * n[2],
    ]
}

/// The parameters that give this stress, by least squares over the 96 values of the element.
fn fit(
    element: &SuperElement,
    corners: &[V3; 4],
    stress: impl Fn(V3) -> [f64; 6],
) -> [f64; PARAMETERS] {
    use faer::prelude::SolveLstsq;
    let points = SuperElement::points(corners);
    let particular = element.particular();
    let mut a = faer::Mat::<f64>::zeros(96, PARAMETERS);
    let mut b = faer::Mat::<f64>::zeros(96, 1);
    for k in 0..4 {
        for p in 0..4 {
            let (columns, want) = (element.stress_columns(k, p), stress(points[k][p]));
            for c in 0..6 {
                let row = 24 * k + 6 * p + c;
                (0..PARAMETERS).for_each(|i| a[(row, i)] = columns[i][c]);
                b[(row, 0)] = want[c] - particular[k][p][c];
            }
        }
    }
    let qr = a.qr();
    let x = qr.solve_lstsq(&b);
    let miss = &b - &a * &x;
    let size = (0..96).map(|r| miss[(r, 0)].abs()).fold(0.0, f64::max);
    assert!(
        size < 1e-9 * (0..96).map(|r| b[(r, 0)].abs()).fold(1.0, f64::max),
        "the element does not hold it: {size}"
    );
    std::array::from_fn(|i| x[(i, 0)])
}
