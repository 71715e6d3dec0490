//! Rigid motions of the parts that nothing resists.
//!
//! Unknowns: for each part, and for each rigid face, the displacement of a reference point and the
//! rotation times the size of the model, so that all columns have one unit. Rows: supports, held
//! motions and followed components of rigid faces, contacts, welds. A frictionless contact resists
//! relative motion in its normal direction, contacts with friction and welds in every direction.
//! The rows between the same two unknown motions are compressed to six by a running QR
//! factorisation, which does not square the condition number.

use crate::mesh::merge::diagonal;
use crate::mesh::topology::face_nodes;
use crate::model::analysis::{AnalysisModel, BoundaryFace, FreeMode, Traction};
use bracket_base::diag::Diagnostic;
use bracket_base::math::dense::{Mat, right_singular_vectors};
use bracket_base::math::rigid_motion::rigid_displacement;
use bracket_base::math::vec3::{V3, cross, dot, norm, sub, unit};
use bracket_base::say;
use bracket_base::words::Text;
use std::collections::BTreeMap;

/// Singular values below this times the largest count as zero. Faces with coordinates of seven
/// digits are plane to 1e-7; a support of a thousandth of the size of the model still gives a
/// singular value of 1e-3.
const HOLDS: f64 = 1e-6;
/// A load does work on a motion when the work exceeds this times the sum of the load magnitudes.
const WORKS: f64 = 1e-9;

/// QR factor of any number of rows with six columns, updated row by row.
#[derive(Clone, Default)]
struct RunningQr {
    r: [[f64; 6]; 6],
    rows: usize,
}

impl RunningQr {
    fn push(&mut self, mut row: [f64; 6]) {
        self.rows += 1;
        for k in 0..6 {
            let (a, b) = (self.r[k][k], row[k]);
            let h = a.hypot(b);
            if h == 0.0 || b == 0.0 {
                continue;
            }
            let (c, s) = (a / h, b / h);
            for j in k..6 {
                let (p, q) = (self.r[k][j], row[j]);
                self.r[k][j] = c * p + s * q;
                row[j] = c * q - s * p;
            }
        }
    }
}

/// The rows of one relative motion: column block A (absent: the ground) and B.
type Groups = BTreeMap<(Option<usize>, usize), RunningQr>;

struct Frame {
    /// Centre of the model \[mm\].
    centre: V3,
    /// Half the diagonal of its box \[mm\].
    size: f64,
    /// Reference point of each block: centroids of the parts, then `at` of the rigid faces \[mm\].
    reference: Vec<V3>,
    parts: usize,
}

impl Frame {
    fn new(model: &AnalysisModel) -> Self {
        let mesh = &model.mesh;
        let mut sums = vec![([0.0; 3], 0.0); model.parts.len()];
        for e in 0..mesh.tets.len() {
            let (v, x) = (mesh.volume(e), mesh.corners(e));
            let sum = &mut sums[model.tet_part[e] as usize];
            sum.1 += v;
            (0..3).for_each(|k| sum.0[k] += v * 0.25 * (x[0][k] + x[1][k] + x[2][k] + x[3][k]));
        }
        let mut reference: Vec<V3> = sums.iter().map(|(s, v)| s.map(|c| c / v)).collect();
        reference.extend(model.rigid.iter().map(|r| r.at));
        let all = sums
            .iter()
            .fold(([0.0; 3], 0.0), |(s, v), (t, w)| ([0, 1, 2].map(|k| s[k] + t[k]), v + w));
        Self {
            centre: all.0.map(|c: f64| c / all.1),
            size: 0.5 * diagonal(&mesh.nodes),
            reference,
            parts: model.parts.len(),
        }
    }

    /// The row `d · u(x)` for a motion about the centre.
    fn row(&self, x: V3, d: V3) -> [f64; 6] {
        let m = cross(sub(x, self.centre), d).map(|c| c / self.size);
        [d[0], d[1], d[2], m[0], m[1], m[2]]
    }

    /// A row for a motion about the centre, rewritten for the motion about the reference point of
    /// `block`.
    fn about_reference(&self, row: &[f64; 6], block: usize) -> [f64; 6] {
        let a = [row[0], row[1], row[2]];
        let m = cross(sub(self.centre, self.reference[block]), a).map(|c| c / self.size);
        [a[0], a[1], a[2], row[3] + m[0], row[4] + m[1], row[5] + m[2]]
    }
}

fn vertices(model: &AnalysisModel, f: &BoundaryFace) -> [V3; 3] {
    face_nodes(&model.mesh.tets[f.tet as usize], f.local).map(|n| model.mesh.nodes[n as usize])
}

/// Outward normal times twice the area.
fn area_normal(x: &[V3; 3]) -> V3 {
    cross(sub(x[1], x[0]), sub(x[2], x[0]))
}

const UNIT: [V3; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Directions in which a contact resists relative motion.
fn contact_directions(mu: f64, x: &[V3; 3]) -> Vec<V3> {
    if mu > 0.0 {
        return UNIT.to_vec();
    }
    vec![unit(area_normal(x))]
}

fn constraint_groups(model: &AnalysisModel, frame: &Frame) -> Groups {
    let mut groups = Groups::new();
    let part = |f: &BoundaryFace| model.tet_part[f.tet as usize] as usize;
    let mut add = |a: Option<usize>, b: usize, x: &[V3; 3], directions: &[V3]| {
        let qr = groups.entry((a, b)).or_default();
        for d in directions {
            x.iter().for_each(|x| qr.push(frame.row(*x, *d)));
        }
    };
    let marked = |on: &[bool; 3]| (0..3).filter(|c| on[*c]).map(|c| UNIT[c]).collect::<Vec<_>>();
    for s in &model.supports {
        s.faces.iter().for_each(|f| add(None, part(f), &vertices(model, f), &marked(&s.fix)));
    }
    for g in &model.ground {
        for f in &g.faces {
            let x = vertices(model, f);
            add(None, part(f), &x, &contact_directions(g.law.mu, &x));
        }
    }
    let contacts =
        model.interfaces.iter().flat_map(|i| i.faces.iter().map(|f| (f, Some(i.law.mu))));
    let welds = model.welds.iter().flat_map(|w| w.faces.iter().map(|f| (f, None)));
    for (f, mu) in contacts.chain(welds) {
        let (a, b) = (part(&f.a), part(&f.b));
        // an interface inside one part adds no constraint between parts
        if a != b {
            let x = vertices(model, &f.a);
            let held = mu.map_or(UNIT.to_vec(), |mu| contact_directions(mu, &x));
            add(Some(a.min(b)), a.max(b), &x, &held);
        }
    }
    for (i, r) in model.rigid.iter().enumerate() {
        let block = frame.parts + i;
        r.faces
            .iter()
            .for_each(|f| add(Some(part(f)), block, &vertices(model, f), &marked(&r.components)));
    }
    groups
}

/// Dense rows over all blocks.
fn rows(model: &AnalysisModel, frame: &Frame) -> Vec<Vec<f64>> {
    let n = 6 * frame.reference.len();
    let mut all = Vec::new();
    for ((a, b), qr) in constraint_groups(model, frame) {
        let scale = 1.0 / (qr.rows as f64).sqrt();
        for r in &qr.r {
            let mut row = vec![0.0; n];
            for (block, sign) in [(Some(b), scale), (a, -scale)] {
                if let Some(block) = block {
                    let r = frame.about_reference(r, block);
                    (0..6).for_each(|k| row[6 * block + k] = sign * r[k]);
                }
            }
            all.push(row);
        }
    }
    for (i, r) in model.rigid.iter().enumerate() {
        for k in (0..6).filter(|k| !r.free[*k]) {
            let mut row = vec![0.0; n];
            row[6 * (frame.parts + i) + k] = 1.0;
            all.push(row);
        }
    }
    all
}

/// Orthonormal basis of the motions that no row resists.
fn null_space(rows: &[Vec<f64>], n: usize) -> Result<Vec<Vec<f64>>, LooseParts> {
    // padded to at least n rows, so that the decomposition returns all n right singular vectors
    let a = Mat::<f64>::from_fn(rows.len().max(n), n, |i, j| rows.get(i).map_or(0.0, |r| r[j]));
    let (s, v) = right_singular_vectors(&a).map_err(|e| LooseParts::NotFound(format!("{e:?}")))?;
    let largest = s.iter().copied().fold(0.0, f64::max);
    let null = (0..n).filter(|j| s[*j] <= HOLDS * largest);
    Ok(null.map(|j| (0..n).map(|i| v[(i, j)]).collect()).collect())
}

/// Brings a basis to reduced echelon form over its first `columns` columns, so that each motion
/// moves few parts.
fn reduce(basis: &mut [Vec<f64>], columns: usize) {
    for k in 0..basis.len() {
        let mut best = (k, 0, 0.0);
        for (i, row) in basis.iter().enumerate().skip(k) {
            for (j, v) in row[..columns].iter().enumerate() {
                // the first of nearly equal entries, so that the result is reproducible
                if v.abs() > best.2 * (1.0 + 1e-6) {
                    best = (i, j, v.abs());
                }
            }
        }
        let (i, j, size) = best;
        if size == 0.0 {
            return;
        }
        basis.swap(k, i);
        let pivot = basis[k][j];
        basis[k].iter_mut().for_each(|v| *v /= pivot);
        let row = basis[k].clone();
        for (i, other) in basis.iter_mut().enumerate() {
            if i != k {
                let f = other[j];
                other.iter_mut().zip(&row).for_each(|(v, r)| *v -= f * r);
            }
        }
    }
    basis.iter_mut().flatten().filter(|v| v.abs() < 1e-9).for_each(|v| *v = 0.0);
}

/// Generalised loads on the blocks, and the sum of the magnitudes of their contributions.
fn loads(model: &AnalysisModel, frame: &Frame) -> (Vec<f64>, f64) {
    let mut f = vec![0.0; 6 * frame.reference.len()];
    let mut magnitude = 0.0;
    let mut add = |block: usize, x: V3, force: V3| {
        let r = sub(x, frame.reference[block]);
        let m = cross(r, force);
        for k in 0..3 {
            f[6 * block + k] += force[k];
            f[6 * block + 3 + k] += m[k] / frame.size;
        }
        magnitude += norm(force);
    };
    for load in &model.surface_loads {
        for face in &load.faces {
            let block = model.tet_part[face.tet as usize] as usize;
            let x = vertices(model, face);
            let n = area_normal(&x);
            // three mid-edge points: exact for the moment of a linear traction
            for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                let p = [0, 1, 2].map(|k| 0.5 * (x[i][k] + x[j][k]));
                let force = match &load.traction {
                    Traction::Pressure(q) => n.map(|c| -q * c / 6.0),
                    Traction::Linear { traction0, gradient } => {
                        [0, 1, 2].map(|k| (traction0[k] + dot(gradient[k], p)) * norm(n) / 6.0)
                    }
                };
                add(block, p, force);
            }
        }
    }
    for load in &model.body_loads {
        for e in (0..model.mesh.tets.len()).filter(|e| model.mesh.tet_body[*e] == load.body) {
            let (v, x) = (model.mesh.volume(e), model.mesh.corners(e));
            let p = [0, 1, 2].map(|k| 0.25 * (x[0][k] + x[1][k] + x[2][k] + x[3][k]));
            add(model.tet_part[e] as usize, p, load.force.map(|c| c * v));
        }
    }
    for (i, r) in model.rigid.iter().enumerate() {
        for action in [&r.action, &r.dead_action] {
            for k in 0..6 {
                let scale = if k < 3 { 1.0 } else { 1.0 / frame.size };
                f[6 * (frame.parts + i) + k] += action[k] * scale;
                magnitude += (action[k] * scale).abs();
            }
        }
    }
    (f, magnitude)
}

/// Why the rigid motions of a model let no program run.
#[derive(Clone, Debug)]
pub enum LooseParts {
    /// The loads do work on these motions, and nothing resists them.
    Driven(Vec<Text>),
    /// The search for the motions did not converge, for this reason.
    NotFound(String),
}

impl LooseParts {
    /// The reason in words.
    pub fn text(&self) -> Text {
        match self {
            LooseParts::Driven(motions) => say!(
                "{}; nothing resists this motion and the loads do work on it",
                Text::joined("; ", motions.clone())
            ),
            LooseParts::NotFound(why) => {
                say!("the search for loose parts did not converge: {}", why)
            }
        }
    }
}

impl From<LooseParts> for Diagnostic {
    fn from(e: LooseParts) -> Self {
        let message = e.text().to_string();
        match e {
            LooseParts::Driven(_) => Diagnostic::input("model/loose-part", message).help(
                "add a support, a tie or a contact that holds it; parts that only touch in a line \
                 or a point, or whose meshes do not share faces, are not connected",
            ),
            LooseParts::NotFound(_) => Diagnostic::undecided("model/rank-test", message)
                .help("scale the model to mm and check its coordinates"),
        }
    }
}

/// The rigid motions that nothing resists; an error that names the parts if a load does work on
/// one.
pub(super) fn free_modes(model: &AnalysisModel) -> Result<Vec<FreeMode>, LooseParts> {
    let frame = Frame::new(model);
    let n = 6 * frame.reference.len();
    let mut basis = null_space(&rows(model, &frame), n)?;
    reduce(&mut basis, 6 * frame.parts);
    let (f, magnitude) = loads(model, &frame);
    let mut modes = Vec::new();
    let mut driven = Vec::new();
    for motion in &basis {
        let largest = motion.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let work: f64 = motion.iter().zip(&f).map(|(u, f)| u * f).sum();
        let mode = FreeMode {
            motions: (0..frame.parts)
                .map(|p| {
                    let theta = [3, 4, 5].map(|k| motion[6 * p + k] / frame.size);
                    let t = cross(theta, frame.reference[p]);
                    let u = [0, 1, 2].map(|k| motion[6 * p + k] - t[k]);
                    [u[0], u[1], u[2], theta[0], theta[1], theta[2]]
                })
                .collect(),
        };
        if work.abs() > WORKS * magnitude * largest {
            driven.push(in_words(model, &mode));
        }
        modes.push(mode);
    }
    if driven.is_empty() { Ok(modes) } else { Err(LooseParts::Driven(driven)) }
}

/// `part COLUMN can move along z`.
pub(super) fn in_words(model: &AnalysisModel, mode: &FreeMode) -> Text {
    let frame = Frame::new(model);
    let at = |p: usize| rigid_displacement(&mode.motions[p], [0.0; 3], frame.reference[p]);
    let spin = |p: usize| [3, 4, 5].map(|k| mode.motions[p][k]);
    let moves = |p: usize| norm(at(p)) + frame.size * norm(spin(p));
    let largest = (0..frame.parts).map(moves).fold(0.0, f64::max);
    let mut said: Vec<(Text, Vec<&str>)> = Vec::new();
    for p in (0..frame.parts).filter(|p| moves(*p) > 1e-6 * largest) {
        let (u, theta) = (at(p), spin(p));
        let turn = norm(theta);
        let words = if turn * frame.size < 1e-6 * largest {
            say!("move along {}", direction(u))
        } else {
            // the point of the axis nearest the centre of the model, the same for parts that turn
            // together
            let t = cross(theta, rigid_displacement(&mode.motions[p], [0.0; 3], frame.centre));
            let axis = [0, 1, 2].map(|k| round(frame.centre[k] + t[k] / (turn * turn), frame.size));
            let [x, y, z] = axis;
            let at = format!("({x}, {y}, {z})");
            let line = say!("turn about {} through {}", direction(theta), at);
            let along = dot(u, theta) / turn;
            if along.abs() > 1e-6 * largest { say!("{} while moving along it", line) } else { line }
        };
        match said.iter_mut().find(|(w, _)| *w == words) {
            Some((_, parts)) => parts.push(&model.parts[p]),
            None => said.push((words, vec![&model.parts[p]])),
        }
    }
    let can = said.iter().map(|(words, parts)| match parts[..] {
        [one] => say!("part {} can {}", one.to_owned(), words),
        _ => say!("parts {} can {} together", parts.join(", "), words),
    });
    Text::joined(", ", can)
}

/// `x`, or the components of a skew direction.
fn direction(d: V3) -> String {
    let d = unit(d);
    match (0..3).find(|k| d[*k].abs() > 1.0 - 1e-6) {
        Some(k) => ["x", "y", "z"][k].to_string(),
        None => format!("({:.3}, {:.3}, {:.3})", d[0] + 0.0, d[1] + 0.0, d[2] + 0.0),
    }
}

/// A coordinate to a thousandth of the size, without `-0`.
fn round(c: f64, size: f64) -> f64 {
    let digits = 10f64.powf(3.0 - size.log10().ceil());
    (c * digits).round() / digits + 0.0
}
