//! Checks admissibility at random points, with formulas written anew from the definitions. It uses
//! no code of the programs, the recovery or the certificate, only the stored values of the two
//! fields.
//!
//! Static field: `div σ + b = 0` in random subtets. Random faces between subtets and between tets
//! have the same traction on both sides. Free components carry the loads. At random points of
//! contacts `‖r_T‖ ≤ μ r_N`, with the same r on both sides.
//!
//! Kinematic field: `g_N + g₀ ≥ μ ‖g_T‖` at random points of contacts. The held components are zero
//! on supports.
//!
//! The tolerances allow only rounding: 1e-9 of the largest stress (equality after projection) and
//! 1e-12 of the largest displacement. No point is excepted.

use super::Random;
use bracket::certify::fields::{DisplacementField, StressField};
use bracket::mesh::tet::{EDGES, FACES};
use bracket::model::AnalysisModel;
use bracket::model::analysis::{BoundaryFace, Traction};
use std::collections::BTreeMap;

type V3 = [f64; 3];
const POINTS: usize = 1000;

fn sub(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
fn norm(a: V3) -> f64 {
    dot(a, a).sqrt()
}
fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
fn unit(a: V3) -> V3 {
    let n = norm(a);
    a.map(|x| x / n)
}
fn combine(x: &[V3], l: &[f64]) -> V3 {
    std::array::from_fn(|d| x.iter().zip(l).map(|(x, l)| l * x[d]).sum())
}

/// Full matrix of a Mandel vector.
fn matrix(s: &[f64; 6]) -> [V3; 3] {
    let r = std::f64::consts::FRAC_1_SQRT_2;
    let (yz, xz, xy) = (s[3] * r, s[4] * r, s[5] * r);
    [[s[0], xy, xz], [xy, s[1], yz], [xz, yz, s[2]]]
}
fn apply(m: &[V3; 3], n: V3) -> V3 {
    [dot(m[0], n), dot(m[1], n), dot(m[2], n)]
}

struct Fields<'a> {
    model: &'a AnalysisModel,
    stress: &'a StressField,
    u: &'a DisplacementField,
    /// Mid-side node of each edge.
    middle: BTreeMap<[u32; 2], usize>,
}

impl<'a> Fields<'a> {
    fn corners(&self, e: usize) -> [V3; 4] {
        self.model.mesh.tets[e].map(|n| self.model.mesh.nodes[n as usize])
    }

    /// The corners of subtet `k` of tet `e` and the stress at each.
    fn subtet(&self, e: usize, k: usize) -> ([V3; 4], [[V3; 3]; 4]) {
        let x = self.corners(e);
        let centre = combine(&x, &[0.25; 4]);
        let f = FACES[k];
        (
            [x[f[0]], x[f[1]], x[f[2]], centre],
            std::array::from_fn(|p| matrix(&self.stress.points[e][k][p])),
        )
    }

    /// The stress of subtet `k` of tet `e` at a point, from its linear field.
    fn at(&self, e: usize, k: usize, x: V3) -> [V3; 3] {
        let (c, s) = self.subtet(e, k);
        let volume = |a: &[V3; 4]| dot(cross(sub(a[1], a[0]), sub(a[2], a[0])), sub(a[3], a[0]));
        let all = volume(&c);
        let l: [f64; 4] = std::array::from_fn(|i| {
            let mut a = c;
            a[i] = x;
            volume(&a) / all
        });
        std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|p| l[p] * s[p][i][j]).sum()))
    }

    fn face(&self, f: &BoundaryFace) -> [u32; 3] {
        FACES[f.local as usize].map(|i| self.model.mesh.tets[f.tet as usize][i])
    }

    fn positions(&self, nodes: [u32; 3]) -> [V3; 3] {
        nodes.map(|n| self.model.mesh.nodes[n as usize])
    }

    /// Displacement of the face with the given vertices at barycentric `l`. It is quadratic and
    /// computed from vertices and mid-side nodes.
    fn displacement(&self, nodes: [u32; 3], l: [f64; 3]) -> V3 {
        let mut u = [0.0; 3];
        let mut add = |node: usize, w: f64| (0..3).for_each(|d| u[d] += w * self.u.u[node][d]);
        for i in 0..3 {
            add(nodes[i] as usize, l[i] * (2.0 * l[i] - 1.0));
            let j = (i + 1) % 3;
            let (a, b) = (nodes[i].min(nodes[j]), nodes[i].max(nodes[j]));
            add(self.middle[&[a, b]], 4.0 * l[i] * l[j]);
        }
        u
    }

    /// Traction on a boundary face at a point, from the stress of its own tet and the outward
    /// normal.
    fn traction(&self, f: &BoundaryFace, x: V3, n: V3) -> V3 {
        apply(&self.at(f.tet as usize, f.local as usize, x), n)
    }

    fn load(&self, f: &BoundaryFace, x: V3, n: V3) -> V3 {
        let mut t = [0.0; 3];
        for load in self.model.surface_loads.iter().filter(|l| l.faces.contains(f)) {
            let more = match &load.traction {
                Traction::Pressure(p) => n.map(|c| -p * c),
                Traction::Linear { traction0, gradient } => {
                    std::array::from_fn(|i| traction0[i] + dot(gradient[i], x))
                }
            };
            (0..3).for_each(|d| t[d] += more[d]);
        }
        t
    }
}

fn outward(x: &[V3; 3]) -> V3 {
    unit(cross(sub(x[1], x[0]), sub(x[2], x[0])))
}

/// Panics at the first random point where one of the two fields is not admissible.
pub fn check(name: &str, model: &AnalysisModel, stress: &StressField, u: &DisplacementField) {
    // the space's numbering of mid-side nodes is the file format of the field, not a computation
    let space = bracket::elements::space::Tet10Space::new(&model.mesh);
    let mut middle = BTreeMap::new();
    for (e, t) in model.mesh.tets.iter().enumerate() {
        let nodes = space.tet(&model.mesh, e);
        for (i, [a, b]) in EDGES.into_iter().enumerate() {
            middle.insert([t[a].min(t[b]), t[a].max(t[b])], nodes[4 + i]);
        }
    }
    let fields = Fields { model, stress, u, middle };
    let mut random = Random::new(2024);
    let largest = stress
        .points
        .iter()
        .flatten()
        .flatten()
        .flatten()
        .fold(0.0f64, |m, s| m.max(s.abs()))
        .max(f64::MIN_POSITIVE);
    let tolerance = 1e-9 * largest;
    volume(name, &fields, &mut random, tolerance);
    inner_faces(name, &fields, &mut random, tolerance);
    contacts(name, &fields, &mut random, tolerance);
    welds(name, &fields, &mut random, tolerance);
    cuts(name, &fields, &mut random, tolerance);
    supports(name, &fields, &mut random);
}

fn welds(name: &str, f: &Fields, random: &mut Random, tolerance: f64) {
    let all: Vec<_> =
        f.model.welds.iter().flat_map(|w| w.faces.iter().map(move |p| (w, p))).collect();
    for _ in 0..POINTS * usize::from(!all.is_empty()) {
        let (weld, p) = all[random.below(all.len())];
        let x = f.positions(p.nodes_a);
        let (at, n) = (combine(&x, &random.simplex::<3>()), outward(&x));
        let (a, b) = (f.traction(&p.a, at, n), f.traction(&p.b, at, n));
        assert!(
            norm(sub(a, b)) <= tolerance,
            "{name}: {a:?} on one side of a weld, {b:?} on the other at {at:?}"
        );
        assert!(
            norm(a) <= weld.strength + tolerance,
            "{name}: {a:?} in a weld of {} at {at:?}",
            weld.strength
        );
    }
}

fn volume(name: &str, f: &Fields, random: &mut Random, tolerance: f64) {
    for _ in 0..POINTS {
        let e = random.below(f.model.mesh.tets.len());
        let k = random.below(4);
        let (c, s) = f.subtet(e, k);
        // gradients of the barycentric coordinates from the inverse of the edge matrix
        let d = [sub(c[1], c[0]), sub(c[2], c[0]), sub(c[3], c[0])];
        let six = dot(cross(d[0], d[1]), d[2]);
        let g =
            [cross(d[1], d[2]), cross(d[2], d[0]), cross(d[0], d[1])].map(|x| x.map(|c| c / six));
        let mut div = [0.0; 3];
        for b in f.model.body_loads.iter().filter(|b| b.body == f.model.mesh.tet_body[e]) {
            (0..3).for_each(|i| div[i] += b.force[i]);
        }
        for p in 0..3 {
            let t = apply(&s[p + 1], g[p]);
            let o = apply(&s[0], g[p]);
            (0..3).for_each(|i| div[i] += t[i] - o[i]);
        }
        let h = (six / 6.0 * 4.0).cbrt();
        assert!(norm(div) * h <= tolerance, "{name}: div σ + b = {div:?} in tet {e} subtet {k}");
    }
}

fn inner_faces(name: &str, f: &Fields, random: &mut Random, tolerance: f64) {
    let mesh = &f.model.mesh;
    let mut owners: BTreeMap<[u32; 3], Vec<(usize, usize)>> = BTreeMap::new();
    for (e, t) in mesh.tets.iter().enumerate() {
        for k in 0..4 {
            let mut v = FACES[k].map(|i| t[i]);
            v.sort_unstable();
            owners.entry(v).or_default().push((e, k));
        }
    }
    let inner: Vec<_> = owners.iter().filter(|(_, o)| o.len() == 2).collect();
    for _ in 0..POINTS {
        if inner.is_empty() {
            break;
        }
        let (nodes, o) = inner[random.below(inner.len())];
        let x = f.positions(*nodes);
        let (at, n) = (combine(&x, &random.simplex::<3>()), outward(&x));
        let [a, b] = [o[0], o[1]].map(|(e, k)| apply(&f.at(e, k, at), n));
        assert!(
            norm(sub(a, b)) <= tolerance,
            "{name}: traction {a:?} against {b:?} across {nodes:?} at {at:?}"
        );
    }
    for _ in 0..POINTS {
        let e = random.below(mesh.tets.len());
        let (k, l) = (random.below(4), random.below(4));
        if k == l {
            continue;
        }
        let c = f.corners(e);
        let v: Vec<usize> = (0..4).filter(|&m| m != k && m != l).collect();
        let x = [c[v[0]], c[v[1]], combine(&c, &[0.25; 4])];
        let (at, n) = (combine(&x, &random.simplex::<3>()), outward(&x));
        let [a, b] = [k, l].map(|k| apply(&f.at(e, k, at), n));
        assert!(
            norm(sub(a, b)) <= tolerance,
            "{name}: traction {a:?} against {b:?} inside tet {e} at {at:?}"
        );
    }
    // outer faces: faces that are not held, moved or in contact carry exactly their load
    let outer: Vec<BoundaryFace> = owners
        .values()
        .filter(|o| o.len() == 1)
        .map(|o| BoundaryFace { tet: o[0].0 as u32, local: o[0].1 as u8 })
        .collect();
    let mut held: BTreeMap<(u32, u8), [bool; 3]> = BTreeMap::new();
    let mut hold = |b: &BoundaryFace, c: [bool; 3]| {
        let h = held.entry((b.tet, b.local)).or_default();
        (0..3).for_each(|d| h[d] |= c[d]);
    };
    f.model.supports.iter().for_each(|s| s.faces.iter().for_each(|b| hold(b, s.fix)));
    f.model.rigid.iter().for_each(|s| s.faces.iter().for_each(|b| hold(b, s.components)));
    f.model.ground.iter().for_each(|s| s.faces.iter().for_each(|b| hold(b, [true; 3])));
    let contacts = f.model.interfaces.iter().flat_map(|s| &s.faces);
    contacts.chain(f.model.welds.iter().flat_map(|w| &w.faces)).for_each(|p| {
        hold(&p.a, [true; 3]);
        hold(&p.b, [true; 3]);
    });
    f.model.preload.iter().flat_map(|p| &p.faces).for_each(|p| {
        hold(&p.a, [true; 3]);
        hold(&p.b, [true; 3]);
    });
    for _ in 0..POINTS {
        let b = &outer[random.below(outer.len())];
        let x = f.positions(f.face(b));
        let (at, n) = (combine(&x, &random.simplex::<3>()), outward(&x));
        let d = sub(f.traction(b, at, n), f.load(b, at, n));
        let h = held.get(&(b.tet, b.local)).copied().unwrap_or_default();
        for c in (0..3).filter(|&c| !h[c]) {
            assert!(
                d[c].abs() <= tolerance,
                "{name}: unasked traction {d:?} on a free face at {at:?}"
            );
        }
    }
}

fn contacts(name: &str, f: &Fields, random: &mut Random, tolerance: f64) {
    let pairs = f
        .model
        .interfaces
        .iter()
        .flat_map(|i| i.faces.iter().map(move |p| (&i.law, p.a, p.nodes_a, Some(p), false)));
    let ground = f
        .model
        .ground
        .iter()
        .flat_map(|g| g.faces.iter().map(move |b| (g, *b)))
        .map(|(g, b)| (&g.law, b, f.face(&b), None, g.stiffness.is_some()));
    let all: Vec<_> = pairs.chain(ground).collect();
    if all.is_empty() {
        return;
    }
    let size = f.u.u.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    for _ in 0..POINTS {
        let index = random.below(all.len());
        let (law, a, nodes, pair, gives_way) = &all[index];
        let x = f.positions(*nodes);
        let l = random.simplex::<3>();
        let (at, n) = (combine(&x, &l), outward(&x));
        let r = sub(f.load(a, at, n), f.traction(a, at, n));
        let rn = dot(r, n);
        let rt = norm(sub(r, n.map(|c| rn * c)));
        assert!(
            rn >= -tolerance && rt <= law.mu * rn + tolerance,
            "{name}: r_N {rn:e}, r_T {rt:e} at {at:?}"
        );
        let mut g = f.displacement(*nodes, l).map(|c| -c);
        if let Some(p) = pair {
            let back = n.map(|c| -c);
            let rb = sub(f.traction(&p.b, at, back), f.load(&p.b, at, back));
            assert!(
                norm(sub(r, rb)) <= tolerance,
                "{name}: {r:?} on one side, {rb:?} on the other at {at:?}"
            );
            let ub = f.displacement(p.nodes_b, l);
            (0..3).for_each(|d| g[d] += ub[d]);
        }
        // the shift of the cone, computed from its Bernstein coefficients
        let s = f.model.shift.faces.get(index).copied().unwrap_or_default();
        let shift = s[0] * l[0] * l[0]
            + s[1] * l[1] * l[1]
            + s[2] * l[2] * l[2]
            + 2.0 * (s[3] * l[0] * l[1] + s[4] * l[1] * l[2] + s[5] * l[0] * l[2]);
        let g0 = law.gap.at(at) + shift;
        let gn = dot(g, n);
        let gt = norm(sub(g, n.map(|c| gn * c)));
        let slack = 1e-12 * size.max(g0.abs());
        assert!(
            *gives_way || gn + g0 >= law.mu * gt - slack,
            "{name}: g_N + g₀ = {:e}, μ g_T = {:e} at {at:?}",
            gn + g0,
            law.mu * gt
        );
    }
}

/// Across a preloaded cut the traction is continuous, and the displacement jumps by the closure
/// along the axis.
fn cuts(name: &str, f: &Fields, random: &mut Random, tolerance: f64) {
    let all: Vec<_> =
        f.model.preload.iter().flat_map(|p| p.faces.iter().map(move |face| (p, face))).collect();
    let size = f.u.u.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    for _ in 0..POINTS * usize::from(!all.is_empty()) {
        let (bolt, p) = all[random.below(all.len())];
        let x = f.positions(p.nodes_a);
        let l = random.simplex::<3>();
        let (at, n) = (combine(&x, &l), outward(&x));
        assert!(dot(n, bolt.axis) > 0.0, "{name}: side A of the cut");
        let (a, b) = (f.traction(&p.a, at, n), f.traction(&p.b, at, n));
        assert!(
            norm(sub(a, b)) <= tolerance,
            "{name}: {a:?} on one side of the cut, {b:?} on the other at {at:?}"
        );
        let closure = bolt.closure.unwrap();
        let jump = sub(f.displacement(p.nodes_b, l), f.displacement(p.nodes_a, l));
        let off = norm(sub(jump, bolt.axis.map(|c| -closure * c)));
        assert!(off <= 1e-12 * size, "{name}: the cut closes by {jump:?}, off by {off:e}");
    }
}

/// Velocities of limit analysis on held faces, at random points: bodies that yield may slip along
/// a face that is held across and along it and carries no load; on other faces all held components
/// are zero. Returns the largest velocity of slip.
pub fn velocities_on_supports(name: &str, model: &AnalysisModel, v: &DisplacementField) -> f64 {
    let space = bracket::elements::space::Tet10Space::new(&model.mesh);
    let size = v.u.iter().map(|v| norm(*v)).fold(0.0, f64::max);
    let mut random = Random::new(2025);
    let mut slip = 0.0f64;
    for s in model.supports.iter().filter(|s| !s.faces.is_empty()) {
        for _ in 0..POINTS / 10 {
            let f = &s.faces[random.below(s.faces.len())];
            let vertices = FACES[f.local as usize].map(|i| model.mesh.tets[f.tet as usize][i]);
            let [a, b, c] = vertices.map(|n| model.mesh.nodes[n as usize]);
            let n = cross(sub(b, a), sub(c, a)).map(|x| x / norm(cross(sub(b, a), sub(c, a))));
            let mut held = [false; 3];
            for s in model.supports.iter().filter(|s| s.faces.contains(f)) {
                (0..3).for_each(|d| held[d] |= s.fix[d]);
            }
            let body = model.mesh.tet_body[f.tet as usize] as usize;
            let yields = model.materials[model.body_material[body] as usize].fy.is_some();
            let loaded = model.surface_loads.iter().any(|l| l.faces.contains(f));
            let across = (0..3).all(|d| held[d] || n[d].abs() < 1e-9);
            let along = held.iter().filter(|h| **h).count() > 1;
            let l = random.simplex::<3>();
            let shape = bracket::math::quadrature::triangle_p2(l);
            let nodes = space.triangle(vertices);
            let at: V3 = std::array::from_fn(|d| (0..6).map(|i| shape[i] * v.u[nodes[i]][d]).sum());
            if yields && across && along && !loaded {
                let normal = (0..3).map(|d| n[d] * at[d]).sum::<f64>();
                assert!(normal.abs() <= 1e-13 * size, "{name}: {at:?} on support {}", s.name);
                slip = slip.max(norm(at));
            } else {
                (0..3)
                    .filter(|&d| held[d])
                    .for_each(|d| assert_eq!(at[d], 0.0, "{name}: support {}", s.name));
            }
        }
    }
    slip / size
}

fn supports(name: &str, f: &Fields, random: &mut Random) {
    for s in f.model.supports.iter().filter(|s| !s.faces.is_empty()) {
        for _ in 0..POINTS / 10 {
            let nodes = f.face(&s.faces[random.below(s.faces.len())]);
            let u = f.displacement(nodes, random.simplex::<3>());
            (0..3)
                .filter(|&d| s.fix[d])
                .for_each(|d| assert_eq!(u[d], 0.0, "{name}: support {}", s.name));
        }
    }
}
