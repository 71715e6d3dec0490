//! Admissibility of the fields at random points inside elements and on faces.

use crate::certify::faces::{
    ContactFace, InterfaceFace, WeldFace, contact_faces, roles, tie_faces, weld_faces,
};
use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::slip::slip_faces;
use crate::certify::tractions::{contact_tractions, stress_at};
use crate::certify::velocity_field::VelocityField;
use crate::certify::velocity_field::pieces;
use crate::certify::welds;
use crate::elements::geometry::gradients;
use crate::elements::space::Tet10Space;
use crate::elements::tet10;
use crate::mesh::numbering::FaceNumbering;
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use crate::model::analysis::{BoundaryFace, FacePair};
use crate::model::loads::Loads;
use crate::model::opening::bernstein_at;
use bracket_base::math::mandel::{self, Mandel};
use bracket_base::math::quadrature::triangle_p2;
use bracket_base::math::vec3::{self, V3};

/// Largest relative violations found at random points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sampled {
    /// Traction jump across faces of the mesh / largest stress of the field.
    pub traction_jump: f64,
    /// Violation of a friction cone by the stress / largest stress of the field.
    pub traction_cone: f64,
    /// Largest traction of a weld over its strength.
    pub weld: f64,
    /// Violation of the contact law by the displacement / largest displacement of the field.
    pub gap_cone: f64,
}

/// A small deterministic generator (xorshift64*): the same points on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn index(&mut self, n: usize) -> usize {
        ((self.next() * n as f64) as usize).min(n - 1)
    }
    /// Uniform barycentric coordinates of a triangle.
    fn barycentric(&mut self) -> [f64; 3] {
        let (a, b) = (self.next().sqrt(), self.next());
        [1.0 - a, a * (1.0 - b), a * b]
    }
    /// Uniform barycentric coordinates of a tetrahedron.
    fn tetrahedron(&mut self) -> [f64; 4] {
        let a = self.next().cbrt();
        let [x, y, z] = self.barycentric();
        [1.0 - a, a * x, a * y, a * z]
    }
}

fn relative(a: f64, scale: f64) -> f64 {
    if scale > 0.0 { a / scale } else { a }
}

fn at(v: &[V3; 3], l: [f64; 3]) -> V3 {
    std::array::from_fn(|d| (0..3).map(|i| l[i] * v[i][d]).sum())
}

/// Largest violations of a stress field of limit analysis at random points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SampledLower {
    /// Traction jump across faces of the mesh / largest stress of the field.
    pub traction_jump: f64,
    /// Violation of a friction cone by the stress / largest stress of the field.
    pub traction_cone: f64,
    /// Largest ‖dev σ‖ / (√(2/3) f_y), traction of a weld or pressure on crushing ground over the
    /// strength.
    pub utilisation: f64,
}

/// Largest relative violations of velocities of limit analysis at random points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SampledUpper {
    /// |tr ε| h in bodies that yield, ‖ε‖ h in the others / largest velocity of the field.
    pub strain: f64,
    /// Violation of the contact law, gaps closed / largest velocity of the field.
    pub gap_cone: f64,
    /// Normal velocity on held faces along which bodies may slip, normal jump at ties / largest
    /// velocity of the field.
    pub held: f64,
}

const SEED: u64 = 0x9e37_79b9_7f4a_7c15;

/// Checks fields at `points` random points of each kind.
pub fn sample(
    model: &AnalysisModel,
    displacement: Option<&DisplacementField>,
    stress: Option<&StressField>,
    points: usize,
) -> Sampled {
    let mut random = Random(SEED);
    let mut out = Sampled::default();
    if let Some(s) = stress {
        let stress = largest_stress(s);
        out.traction_jump = relative(jumps(model, s, points, &mut random), stress);
        out.traction_cone =
            relative(traction_cones(model, s, Loads::ALL, points, &mut random), stress);
        out.weld = welds(model, s, points, &mut random);
    }
    if let Some(u) = displacement {
        out.gap_cone = relative(gap_cones(model, u, true, points, &mut random), largest_length(u));
    }
    out
}

/// Checks at `points` random points of each kind a stress field in equilibrium with
/// `factor · live + dead`.
pub fn sample_lower(
    model: &AnalysisModel,
    s: &StressField,
    factor: f64,
    points: usize,
) -> SampledLower {
    let mut random = Random(SEED);
    let stress = largest_stress(s);
    let traction_jump = relative(jumps(model, s, points, &mut random), stress);
    let traction_cone =
        relative(traction_cones(model, s, Loads::at(factor), points, &mut random), stress);
    let radii = model.yield_radii();
    let mut utilisation = welds(model, s, points, &mut random).max(crushing(
        model,
        s,
        Loads::at(factor),
        points,
        &mut random,
    ));
    for _ in 0..points {
        let e = random.index(s.points.len());
        let stress = inside(&s.points[e][random.index(4)], random.tetrahedron());
        let Some(radius) = radii[model.mesh.tet_body[e] as usize] else { continue };
        let norm = mandel::deviator(&stress).iter().map(|x| x * x).sum::<f64>().sqrt();
        utilisation = utilisation.max(norm / radius);
    }
    SampledLower { traction_jump, traction_cone, utilisation }
}

/// Largest violation at `points` random points of each kind by a stress field that carries the live
/// loads alone, over its largest stress: traction jumps, friction cones, deviators in bodies that
/// yield.
pub fn sample_live(model: &AnalysisModel, s: &StressField, points: usize) -> f64 {
    let mut random = Random(SEED);
    let jump = jumps(model, s, points, &mut random);
    let cone = traction_cones(model, s, Loads::LIVE, points, &mut random);
    let radii = model.yield_radii();
    let mut deviator = 0.0f64;
    for _ in 0..points {
        let e = random.index(s.points.len());
        let stress = inside(&s.points[e][random.index(4)], random.tetrahedron());
        if radii[model.mesh.tet_body[e] as usize].is_some() {
            deviator =
                deviator.max(mandel::deviator(&stress).iter().map(|x| x * x).sum::<f64>().sqrt());
        }
    }
    relative(jump.max(cone).max(deviator), largest_stress(s))
}

/// A linear stress inside its subtet.
fn inside(at: &[Mandel; 4], l: [f64; 4]) -> Mandel {
    std::array::from_fn(|i| (0..4).map(|p| l[p] * at[p][i]).sum())
}

/// Checks velocities at `points` random points of each kind.
pub fn sample_upper(model: &AnalysisModel, field: &VelocityField, points: usize) -> SampledUpper {
    let mut random = Random(SEED);
    let scale = largest_length(&field.nodes);
    let gap_cone = relative(gap_cones(model, &field.nodes, false, points, &mut random), scale);
    let space = Tet10Space::new(&model.mesh);
    let radii = model.yield_radii();
    let mut strain = 0.0f64;
    for _ in 0..points {
        let e = random.index(model.mesh.tets.len());
        let yields = radii[model.mesh.tet_body[e] as usize].is_some();
        let all = pieces(model, &space, field, yields, e);
        let p = &all[random.index(all.len())];
        let eps = tet10::strain(&gradients(&p.corners), random.tetrahedron(), &p.velocities);
        let size = if yields { (eps[0] + eps[1] + eps[2]).abs() } else { mandel::norm(&eps) };
        strain = strain.max(size * model.mesh.volume(e).cbrt());
    }
    let slips = slip_faces(model);
    let mut held = 0.0f64;
    for _ in 0..points * usize::from(!slips.is_empty()) {
        let f = &slips[random.index(slips.len())];
        let shape = triangle_p2(random.barycentric());
        let nodes = space.triangle(f.nodes);
        let v = (0..6).fold([0.0; 3], |v, i| vec3::along(v, shape[i], field.nodes.u[nodes[i]]));
        held = held.max(f.across(v).abs());
    }
    let ties = tie_faces(model);
    for _ in 0..points * usize::from(!ties.is_empty()) {
        let f = &ties[random.index(ties.len())];
        let shape = triangle_p2(random.barycentric());
        let jumps = welds::jumps(&space, f, &field.nodes.u);
        let v = (0..6).fold([0.0; 3], |v, i| vec3::along(v, shape[i], jumps[i]));
        held = held.max(vec3::dot(f.normal(model).0, v).abs());
    }
    SampledUpper { strain: relative(strain, scale), gap_cone, held: relative(held, scale) }
}

fn largest_stress(s: &StressField) -> f64 {
    s.points.iter().flatten().flatten().map(mandel::norm).fold(0.0, f64::max)
}

fn largest_length(u: &DisplacementField) -> f64 {
    u.u.iter().map(|x| vec3::norm(*x)).fold(0.0, f64::max)
}

/// Largest value of a function of the traction at `points` random points of faces, at least zero.
fn worst_traction<L>(
    faces: &[InterfaceFace<'_, L>],
    tractions: impl Fn(&InterfaceFace<'_, L>) -> [V3; 3],
    (points, random): (usize, &mut Random),
    of: impl Fn(&InterfaceFace<'_, L>, V3) -> f64,
) -> f64 {
    let mut worst = 0.0f64;
    for _ in 0..points * usize::from(!faces.is_empty()) {
        let f = &faces[random.index(faces.len())];
        worst = worst.max(of(f, at(&tractions(f), random.barycentric())));
    }
    worst
}

/// Largest violation of a friction cone \[MPa\].
fn traction_cones(
    model: &AnalysisModel,
    s: &StressField,
    loads: Loads,
    points: usize,
    random: &mut Random,
) -> f64 {
    let roles = roles(model, loads);
    let tractions =
        |f: &ContactFace<'_>| contact_tractions(model, s, f, roles.get(&(f.a.tet, f.a.local)));
    worst_traction(&contact_faces(model), tractions, (points, random), |f, r| {
        let (n, _) = f.normal(model);
        let rn = vec3::dot(r, n);
        let rt = vec3::norm(vec3::sub(r, vec3::scale(rn, n)));
        (rt - f.law.mu * rn).max(-rn)
    })
}

/// Largest traction of a weld over its strength.
fn welds(model: &AnalysisModel, s: &StressField, points: usize, random: &mut Random) -> f64 {
    let tractions = |f: &WeldFace<'_>| contact_tractions(model, s, f, None);
    worst_traction(&weld_faces(model), tractions, (points, random), |f, t| {
        vec3::norm(t) / f.law.strength
    })
}

/// Largest pressure on crushing ground over its strength.
fn crushing(
    model: &AnalysisModel,
    s: &StressField,
    loads: Loads,
    points: usize,
    random: &mut Random,
) -> f64 {
    let mut contacts = contact_faces(model);
    contacts.retain(|f| model.crushing_strength(f.of).is_some());
    let roles = roles(model, loads);
    let tractions =
        |f: &ContactFace<'_>| contact_tractions(model, s, f, roles.get(&(f.a.tet, f.a.local)));
    worst_traction(&contacts, tractions, (points, random), |f, r| {
        let pressure = vec3::dot(r, f.normal(model).0);
        model.crushing_strength(f.of).map_or(0.0, |strength| pressure / strength)
    })
}

/// Largest violation of the contact law, none on ground that gives way \[mm\]. With `initial`
/// initial gaps and shifts count, without it gaps count as closed.
fn gap_cones(
    model: &AnalysisModel,
    u: &DisplacementField,
    initial: bool,
    points: usize,
    random: &mut Random,
) -> f64 {
    let mut contacts = contact_faces(model);
    let rigid = |of| model.crushing_strength(of).or(model.ground_stiffness(of)).is_none();
    contacts.retain(|f| rigid(f.of));
    let space = Tet10Space::new(&model.mesh);
    let mut worst = 0.0f64;
    for _ in 0..points * usize::from(!contacts.is_empty()) {
        let f = &contacts[random.index(contacts.len())];
        let l = random.barycentric();
        let shape = triangle_p2(l);
        let a = space.triangle(f.nodes_a).map(|n| u.u[n]);
        let b = f.b.map_or([[0.0; 3]; 6], |(_, nodes)| space.triangle(nodes).map(|n| u.u[n]));
        let g = (0..6)
            .fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], vec3::sub(b[i], a[i]))));
        let (n, _) = f.normal(model);
        let gn = vec3::dot(g, n);
        let gt = vec3::norm(vec3::sub(g, vec3::scale(gn, n)));
        let gap = if initial { bernstein_at(&f.opening(model), l) } else { 0.0 };
        worst = worst.max(f.law.mu * gt - gn - gap);
    }
    worst
}

fn jumps(model: &AnalysisModel, s: &StressField, points: usize, random: &mut Random) -> f64 {
    let mesh = &model.mesh;
    let faces = FaceNumbering::new(mesh);
    let mut worst = 0.0f64;
    let cuts: Vec<&FacePair> = model.cut_faces().collect();
    for _ in 0..points * usize::from(!cuts.is_empty()) {
        let f = cuts[random.index(cuts.len())];
        let corners = f.nodes_a.map(|n| mesh.nodes[n as usize]);
        let area = vec3::area_vector(&corners);
        let n = vec3::scale(1.0 / vec3::norm(area), area);
        let l = random.barycentric();
        let side = |face: &BoundaryFace, nodes: [u32; 3]| {
            at(
                &stress_at(model, s, (face.tet, face.local), nodes)
                    .map(|s| mandel::traction(&s, n)),
                l,
            )
        };
        worst = worst.max(vec3::norm(vec3::sub(side(&f.a, f.nodes_a), side(&f.b, f.nodes_b))));
    }
    for _ in 0..points {
        let f = random.index(faces.nodes.len());
        let (a, Some(b)) = faces.tets[f] else { continue };
        let nodes = faces.nodes[f];
        let corners = nodes.map(|n| mesh.nodes[n as usize]);
        let area = vec3::area_vector(&corners);
        let n = vec3::scale(1.0 / vec3::norm(area), area);
        let l = random.barycentric();
        let side = |e: u32| {
            let e = e as usize;
            let k =
                (0..4).find(|&k| faces.of_tet[e][k] as usize == f).expect("the tet owns the face");
            let t = nodes.map(|m| {
                let p = FACES[k]
                    .iter()
                    .position(|&i| mesh.tets[e][i] == m)
                    .expect("the node is on the face");
                mandel::traction(&s.points[e][k][p], n)
            });
            at(&t, l)
        };
        let (ta, tb) = (side(a), side(b));
        worst = worst.max(vec3::norm(vec3::sub(ta, tb)));
    }
    worst
}
