//! Search for collapse at zero load: a mechanism that moves every part rigidly, see
//! [`crate::certify::free_mechanism`].
//!
//! Rigid motions are the only motions without strain, so that the search has few unknowns.

use crate::certify::fields::DisplacementField;
use crate::certify::free_mechanism::{FreeMechanism, certify_free, is_free};
use crate::certify::velocity_field::VelocityField;
use crate::elements::hencky_kinematic::Flow;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use crate::programs::Kinematic;
use crate::programs::conic::{Cone, ConicProgram, Csr, cone_margin};
use crate::recover::elastic::RecoverError;
use crate::recover::force_sets::cone_ranges;
use crate::solve::SolveOptions;
use crate::solve::feasibility;
use bracket_base::math::dense::{Mat, null_space, pseudo_solve};

/// A cone whose slack is smaller than this, over the largest slack, is closed.
const CLOSED: f64 = 1e-6;
/// Largest number of steps that open cones which the small program left violated.
const OPENINGS: usize = 20;
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
    // the cones of welds follow those of contacts; the motions do not strain welds
    let (starts, rows) = (kinematic.program.cone_starts(), program.g.nrows());
    program.cones = kinematic.program.cones[..starts.partition_point(|s| *s < rows)].to_vec();
    program.p.n = kinematic.map.n;
    program.q = forces(Loads::LIVE).iter().map(|f| -f).collect();
    if model.has_dead_loads() {
        // one more cone: the dead loads must do no work against the motion
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
    let Some(x) = feasibility::direction(&program, &modes, &SolveOptions::default()) else {
        return Ok(None);
    };
    let x = cleaned(&program, &modes, &x);
    let u = kinematic.nodal(&x);
    // no cut opens: that costs
    let field = VelocityField {
        nodes: DisplacementField { u },
        flow: Flow::Split,
        limit_motions: vec![0.0; model.limit_motions()],
    };
    let certificate = certify_free(model, &field);
    Ok(is_free(&certificate).then_some(FreeMechanism { field, certificate }))
}

/// The combinations of motions for which the given rows are zero: those that strain no weld.
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

/// The motion with its closed cones closed to rounding and no other cone violated; the small
/// program is solved to its tolerance only.
fn cleaned(program: &ConicProgram, modes: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
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
    // coefficients of the motion in the modes
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let gram = Mat::from_fn(n, n, |i, j| dot(&modes[i], &modes[j]));
    let rhs = Mat::from_fn(n, 1, |i, _| dot(&modes[i], x));
    let found = pseudo_solve(&gram, &rhs);
    let mut c: Vec<f64> = (0..n).map(|i| found[(i, 0)]).collect();
    let s = slacks(&c);
    let size = s.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let ranges = cone_ranges(program);
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
        // the free motion nearest to an equal opening of all cones that are about to close
        let near: Vec<_> = open.iter().filter(|r| margin(&s, r) <= CLOSED * size).collect();
        let m = free.len();
        let rows: Vec<Vec<f64>> = free.iter().map(|v| slacks(v)).collect();
        let over =
            |f: &dyn Fn(usize) -> f64| near.iter().flat_map(|r| r.0..r.0 + r.1).map(f).sum::<f64>();
        let gram = Mat::from_fn(m, m, |i, j| over(&|r| rows[i][r] * rows[j][r]));
        let rhs = Mat::from_fn(m, 1, |i, _| near.iter().map(|r| rows[i][r.0]).sum::<f64>());
        let y = pseudo_solve(&gram, &rhs);
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
