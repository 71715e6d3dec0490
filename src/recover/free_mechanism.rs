//! Collapse at zero load: a mechanism that moves every part rigidly and costs nothing.
//!
//! Parts that only contact holds can lift off, or slide and dilate with associated friction,
//! without dissipation. Where the live loads work on such a motion and the dead ones do not work
//! against it, `λ_up = (0 − dead power)/live power ≤ 0`. Rigid motions are the only ones without
//! strain, so that the search has a handful of unknowns; the certificate is that of an upper bound
//! with every body rigid, and asks nobody how the motion was found.

use crate::certify::certificate::{largest, ratio};
use crate::certify::faces::weld_faces;
use crate::certify::factor::UpperFactor;
use crate::certify::fields::DisplacementField;
use crate::certify::flow::VelocityField;
use crate::certify::limit_certificate::{UpperCertificate, certify_upper};
use crate::certify::welds::jumps;
use crate::elements::hencky_kinematic::Flow;
use crate::elements::space::Tet10Space;
use crate::math::dense::null_space;
use crate::math::vec3;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use crate::programs::Kinematic;
use crate::programs::conic::{Cone, ConicProgram, Csr, cone_margin};
use crate::recover::elastic::RecoverError;
use crate::solve::{SolveOptions, collapse};
use faer::Mat;

/// A cone whose slack is smaller than this, over the largest slack, is closed.
const CLOSED: f64 = 1e-6;
/// Attempts at opening cones that the small program left violated.
const OPENINGS: usize = 20;
/// Power of the dead loads against the motion, over that of the live ones, that rounding explains.
const ROUNDING: f64 = 1e-12;

/// A mechanism at zero load.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMechanism {
    /// Its velocities.
    pub field: VelocityField,
    /// What they prove, every body rigid.
    pub certificate: UpperCertificate,
}

/// Certifies velocities as a mechanism at zero load: an upper bound with every body and every weld
/// rigid, nothing dissipates. A weld's jump over the largest velocity counts among the strains of
/// rigid bodies.
pub fn certify_free(model: &AnalysisModel, field: &VelocityField) -> UpperCertificate {
    let mut rigid = model.clone();
    rigid.materials.iter_mut().for_each(|m| m.fy = None);
    rigid.welds.clear();
    let mut certificate = certify_upper(&rigid, field, 0);
    let u = &field.nodes.u;
    let space = Tet10Space::new(&model.mesh);
    let jumps = weld_faces(model).into_iter().flat_map(|f| jumps(&space, &f, u).map(vec3::norm));
    let jump = ratio(largest(jumps), largest(u.iter().map(|x| vec3::norm(*x))));
    certificate.rigid = certificate.rigid.max(jump);
    certificate
}

/// True when the certificate proves that no positive load factor can be carried.
pub fn is_free(certificate: &UpperCertificate) -> bool {
    let strict = UpperFactor::new(certificate.clone()).is_strict();
    strict && certificate.dead_power >= -ROUNDING * certificate.live_power
}

/// A mechanism at zero load; `None` where there is none, or none that can be certified.
pub fn find(model: &AnalysisModel) -> Result<Option<FreeMechanism>, RecoverError> {
    if model.interfaces.is_empty() && model.ground.is_empty() {
        return Ok(None);
    }
    let kinematic = Kinematic::new(model)?;
    let mut modes: Vec<Vec<f64>> =
        kinematic.contact_modes(model).into_iter().map(|m| m.unknowns).collect();
    if !model.welds.is_empty() {
        modes = without_jumps(&kinematic.weld_rows(model), &modes);
    }
    if modes.is_empty() {
        return Ok(None);
    }
    let forces = |loads| kinematic.limit_forces(model, Flow::Split, loads);
    let mut program = ConicProgram { g: kinematic.program.g.clone(), ..ConicProgram::default() };
    // behind the contacts stand the cones of welds, which the motions leave alone
    let (starts, rows) = (kinematic.program.cone_starts(), program.g.nrows());
    program.cones = kinematic.program.cones[..starts.partition_point(|s| *s < rows)].to_vec();
    program.p.n = kinematic.map.n;
    program.q = forces(Loads::LIVE).iter().map(|f| -f).collect();
    if model.has_dead_loads() {
        // the dead loads must not hold it: one more cone
        let dead = forces(Loads::DEAD);
        let size = dead.iter().fold(0.0f64, |m, f| m.max(f.abs())).max(f64::MIN_POSITIVE);
        let row: Vec<(u32, f64)> = dead
            .iter()
            .enumerate()
            .filter(|(_, f)| **f != 0.0)
            .map(|(i, f)| (i as u32, f / size))
            .collect();
        program.g.push_row(&row);
        program.cones.push(Cone::NonNegative);
    }
    program.h = vec![0.0; program.g.nrows()];
    let Some(x) = collapse::direction(&program, &modes, &SolveOptions::default()) else {
        return Ok(None);
    };
    let x = settled(&program, &modes, &x);
    let u = kinematic.nodal(&x);
    let field = VelocityField { nodes: DisplacementField { u }, flow: Flow::Split };
    let certificate = certify_free(model, &field);
    Ok(is_free(&certificate).then_some(FreeMechanism { field, certificate }))
}

/// The combinations of motions that leave the given rows zero: those that strain no weld.
fn without_jumps(rows: &Csr, modes: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let jumps: Vec<Vec<f64>> = modes.iter().map(|m| rows.mul(m)).collect();
    let n = modes.len();
    let gram =
        Mat::from_fn(n, n, |i, j| jumps[i].iter().zip(&jumps[j]).map(|(a, b)| a * b).sum::<f64>());
    let combine = |c: Vec<f64>| -> Vec<f64> {
        let mut x = vec![0.0; modes[0].len()];
        for (mode, c) in modes.iter().zip(c) {
            x.iter_mut().zip(mode).for_each(|(x, m)| *x += c * m);
        }
        x
    };
    null_space(&gram, 1e-12).into_iter().map(combine).collect()
}

/// The motion with its closed cones closed to rounding and the others not violated: the small
/// program is solved to its tolerance only.
fn settled(program: &ConicProgram, modes: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
    let n = modes.len();
    let combine = |c: &[f64]| -> Vec<f64> {
        let mut x = vec![0.0; x.len()];
        for (mode, c) in modes.iter().zip(c) {
            x.iter_mut().zip(mode).for_each(|(x, m)| *x += c * m);
        }
        x
    };
    let columns: Vec<Vec<f64>> = modes.iter().map(|m| program.g.mul(m)).collect();
    let slacks = |c: &[f64]| -> Vec<f64> {
        (0..program.g.nrows()).map(|r| (0..n).map(|k| columns[k][r] * c[k]).sum()).collect()
    };
    // the motion in its modes
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let gram = Mat::from_fn(n, n, |i, j| dot(&modes[i], &modes[j]));
    let rhs = Mat::from_fn(n, 1, |i, _| dot(&modes[i], x));
    let found = crate::math::dense::pseudo_solve(&gram, &rhs);
    let mut c: Vec<f64> = (0..n).map(|i| found[(i, 0)]).collect();
    let s = slacks(&c);
    let size = s.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let ranges = crate::recover::elastic::cone_ranges(program);
    let size_of =
        |(at, d): (usize, usize)| s[at..at + d].iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let (closed, open): (Vec<_>, Vec<_>) =
        ranges.into_iter().partition(|r| size_of(*r) <= CLOSED * size);
    let mut held = Mat::<f64>::zeros(n, n);
    for r in closed.iter().flat_map(|&(at, d)| at..at + d) {
        for i in 0..n {
            (0..n).for_each(|j| held[(i, j)] += columns[i][r] * columns[j][r]);
        }
    }
    let free = if closed.is_empty() {
        (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect()
    } else {
        null_space(&held, 1e-12)
    };
    let mut projected = vec![0.0; n];
    for v in &free {
        let along = dot(v, &c);
        projected.iter_mut().zip(v).for_each(|(o, v)| *o += along * v);
    }
    c = projected;
    for _ in 0..OPENINGS {
        let s = slacks(&c);
        let margin = |s: &[f64], &(at, d): &(usize, usize)| cone_margin(&s[at..at + d]);
        let worst = open.iter().map(|r| margin(&s, r)).fold(0.0, f64::min);
        if worst >= 0.0 {
            break;
        }
        // the free motion that comes nearest to opening all that is about to close, alike
        let near: Vec<_> = open.iter().filter(|r| margin(&s, r) <= CLOSED * size).collect();
        let m = free.len();
        let rows: Vec<Vec<f64>> = free.iter().map(|v| slacks(v)).collect();
        let over =
            |f: &dyn Fn(usize) -> f64| near.iter().flat_map(|r| r.0..r.0 + r.1).map(f).sum::<f64>();
        let gram = Mat::from_fn(m, m, |i, j| over(&|r| rows[i][r] * rows[j][r]));
        let rhs = Mat::from_fn(m, 1, |i, _| near.iter().map(|r| rows[i][r.0]).sum::<f64>());
        let y = crate::math::dense::pseudo_solve(&gram, &rhs);
        let mut w = vec![0.0; n];
        for (i, v) in free.iter().enumerate() {
            w.iter_mut().zip(v).for_each(|(w, v)| *w += y[(i, 0)] * v);
        }
        let opened = slacks(&w);
        let gain = near.iter().map(|r| margin(&opened, r)).fold(f64::INFINITY, f64::min);
        let step = -1.1 * worst / gain;
        if gain <= 0.0 || !step.is_finite() {
            break;
        }
        c.iter_mut().zip(&w).for_each(|(c, w)| *c += step * w);
    }
    combine(&c)
}
