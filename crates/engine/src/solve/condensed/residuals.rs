//! Residuals of the homogeneous embedding, and certificates that the program is unbounded or
//! infeasible.

use super::point::Point;
use super::scaled_program::ScaledProgram;
use super::settings::Settings;
use super::vectors::{dot, largest, vector};
use crate::solve::status::SolveStatus;
use crate::solve::stop_rules::StopRules;

/// Residuals of the embedding at a point, and the numbers of the stopping rules.
pub struct Residuals {
    /// Stationarity rows: `Px − Gᵀz + qτ`.
    pub f1: Vec<f64>,
    /// Rows of the cones: `s − Gx − hτ`.
    pub f2: Vec<f64>,
    /// Scalar row: `xᵀPx/τ + qᵀx + hᵀz + κ`.
    pub f3: f64,
    /// `P x`.
    pub px: Vec<f64>,
    /// Diagonal blocks of P times x.
    pub diagonal: Vec<f64>,
    /// `xᵀ P x`, maximised entries of opposite sign.
    pub xpx: f64,
    /// Linear terms of the scalar row: `qᵀx + bᵀy`.
    pub cx: f64,
    /// `hᵀ z`.
    pub hz: f64,
    /// Relative duality gap.
    pub gap: f64,
    /// Relative residual of the stationarity rows.
    pub dual: f64,
    /// Relative residual of the rows of the cones.
    pub primal: f64,
}

/// Residuals at a point; `reference`: load factor at first yield, below a fraction of which a load
/// factor counts as zero; 0 without one.
pub fn residuals(
    problem: &ScaledProgram,
    settings: &Settings,
    p: &Point,
    reference: f64,
) -> Residuals {
    let (q, h) = (&problem.program.q, &problem.program.h);
    let diagonal = problem.program.quadratic_diagonal(&p.x);
    let mut px = diagonal.clone();
    problem.program.add_coupling(&p.x, &mut px);
    let gz = problem.program.rows_transposed(&p.z);
    let gx = problem.program.rows(&p.x);
    let n = p.x.len();
    let f1 = vector(n, |i| px[i] - gz[i] + q[i] * p.tau);
    let f2 = vector(p.s.len(), |r| p.s[r] - gx[r] - h[r] * p.tau);
    let (xpx, cx, hz) = (problem.signed_dot(&p.x, &px), problem.signed_dot(q, &p.x), dot(h, &p.z));
    let t = p.tau;
    // the maximiser's share: its linear terms, and the yield points
    let by = if problem.saddle { -dot(&problem.part(q, true), &p.x) } else { 0.0 };
    let yielding = dot(&h[problem.points..], &p.z[problem.points..]);
    let po = 0.5 * xpx / (t * t) + (cx - by + yielding) / t;
    let dual_objective = -0.5 * xpx / (t * t) - (hz - yielding + by) / t;
    let floor = settings.nothing * reference;
    let least = floor * q.last().map_or(0.0, |q| q.abs());
    let gap =
        (po - dual_objective).abs() / po.abs().min(dual_objective.abs()).max(least).max(1e-300);
    let sizes = [q, &px, &gz].map(|v| problem.largest_of_kinds(v));
    let off = problem.largest_of_kinds(&f1);
    let live = problem.live_force(&p.x);
    let least = floor * largest(&problem.program.live);
    let scale = |k: usize| {
        sizes[0][k].max(sizes[1][k] / t).max(sizes[2][k] / t).max(live / t).max(least).max(1e-300)
    };
    // closed contacts have neither slack nor gap; rows are of unit size, so that the unknowns are a
    // measure too
    let primal_scale = largest(&problem.program.h).max(largest(&p.s) / t).max(largest(&p.x) / t);
    Residuals {
        dual: (off[0] / (t * scale(0))).max(off[1] / (t * scale(1))),
        primal: largest(&f2) / (t * primal_scale.max(1e-300)),
        f3: xpx / t + cx + hz + p.kappa,
        f1,
        f2,
        px,
        diagonal,
        xpx,
        cx,
        hz,
        gap,
    }
}

/// The certificate that a point contains, unbounded or infeasible, if any.
pub fn certificate(
    problem: &ScaledProgram,
    stop: &StopRules,
    p: &Point,
    r: &Residuals,
) -> Option<SolveStatus> {
    if r.cx + r.hz + r.xpx / p.tau >= 0.0 {
        return None;
    }
    let tolerance = stop.residual.min(stop.certain);
    let (looser, decided) = stop.decided;
    let tolerance = if p.kappa > decided * p.tau { looser * tolerance } else { tolerance };
    let (q, h) = (&problem.program.q, &problem.program.h);
    // G x − s without the τ term, for the cones of one side
    let off = |points: bool| {
        let rows = if points { problem.points..h.len() } else { 0..problem.points };
        rows.fold(0.0, |m: f64, i| m.max((r.f2[i] + h[i] * p.tau).abs()))
    };
    // stationarity rows with one side's unknowns and the other side's multipliers, without the τ
    // term
    let stationarity = |maximised: bool| {
        if !problem.saddle && !maximised {
            return largest(&r.px);
        }
        let mut rows = problem.program.rows_transposed(&problem.rows_part(&p.z, !maximised));
        if problem.saddle {
            let [px] = problem.program.quadratic([&problem.part(&p.x, maximised)]);
            rows.iter_mut().zip(&px).for_each(|(o, v)| *o -= v);
        }
        largest(&rows)
    };
    let falls =
        dot(q, &problem.part(&p.x, false)) + dot(&h[problem.points..], &p.z[problem.points..]);
    if falls < 0.0 {
        let unit = -falls / largest(q).max(1e-300);
        if stationarity(false) <= tolerance * -falls
            && off(false) <= tolerance * unit.max(largest(&p.s))
        {
            return Some(SolveStatus::Unbounded);
        }
    }
    let works =
        dot(&h[..problem.points], &p.z[..problem.points]) - dot(q, &problem.part(&p.x, true));
    if works < 0.0 && stationarity(true) <= tolerance * -works {
        let unit = -works / largest(q).max(1e-300);
        if off(true) <= tolerance * unit.max(largest(&p.s)) {
            return Some(SolveStatus::Infeasible);
        }
    }
    None
}
