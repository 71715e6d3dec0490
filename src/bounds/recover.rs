//! From a solver's unknowns to fields that are admissible to rounding.
//!
//! A conic solver satisfies its constraints to its tolerance. The displacement is opened by the last violation along a
//! field that opens every contact; the stress is projected: contact tractions (strictly inside their cones) are first
//! brought into balance with the loads part by part, then the bodies are solved for exact equilibrium with them.

use super::fields::{DisplacementField, StressField};
use super::settle::settle;
use crate::math::dense::pseudo_solve;
use crate::model::dofs::DofMap;
use crate::model::holds::{self, ModelError};
use crate::model::kinematic::{Kinematic, hold};
use crate::model::program::{ConicProgram, Csr, SymmetricCsc, cone_margin};
use crate::model::static_form::{Static, SuperElements};
use crate::model::super_element::PARAMETERS;
use crate::solve::Solution;
use crate::solve::sparse::{LinearError, SparseCholesky};
use faer::Mat;
use rayon::prelude::*;

/// Why a field could not be recovered.
#[derive(Clone, Debug, thiserror::Error)]
pub enum RecoverError {
    /// The linear system failed.
    #[error(transparent)]
    Linear(#[from] LinearError),
    /// An element failed.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Contact forces could not be balanced inside their cones.
    #[error("the contact forces of part(s) {0} cannot be balanced inside their friction cones")]
    Unbalanced(String),
    /// A field that proves no load factor, in words.
    #[error("{0}")]
    Factor(String),
}

/// The displacement field of a kinematic solution, contacts opened where the solver left them violated.
pub fn displacement(kinematic: &Kinematic, solution: &Solution) -> Result<DisplacementField, RecoverError> {
    let mut x = solution.x.clone();
    let program = &kinematic.program;
    for _ in 0..3 {
        let violation = smallest_margin(program, &program.slack(&x));
        if violation >= 0.0 {
            break;
        }
        let opening = opening_field(program, &kinematic.map.block)?;
        let gain = smallest_margin(program, &program.g.mul(&opening));
        if gain <= 0.0 {
            break;
        }
        let step = -1.1 * violation / gain;
        x.iter_mut().zip(&opening).for_each(|(x, w)| *x += step * w);
    }
    let full = kinematic.map.expand(&x);
    Ok(DisplacementField { u: full.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect() })
}

/// Smallest cone margin of the rows `s` \[mm\].
fn smallest_margin(program: &ConicProgram, s: &[f64]) -> f64 {
    let starts = program.cone_starts().into_iter();
    starts.zip(&program.cones).map(|(at, c)| cone_margin(&s[at..at + c.dim()])).fold(f64::INFINITY, f64::min)
}

/// A displacement that opens every contact by about 1 mm with little slip: least squares on the gaps, regularised by
/// the stiffness.
fn opening_field(program: &ConicProgram, block: &[u32]) -> Result<Vec<f64>, RecoverError> {
    let diagonal = program.p.diagonal();
    let weight = 1e4 * diagonal.iter().sum::<f64>() / diagonal.len().max(1) as f64;
    let system = plus_rows(&program.p, &program.g, |_| weight);
    let mut target = vec![0.0; program.h.len()];
    program.cone_starts().into_iter().for_each(|r| target[r] = weight);
    let factor = SparseCholesky::new(&system, block)?;
    Ok(factor.solve(&program.g.mul_transpose(&target)))
}

/// `P + GᵀWG` with a weight for each row.
pub(super) fn plus_rows(p: &SymmetricCsc, g: &Csr, weight: impl Fn(usize) -> f64) -> SymmetricCsc {
    let mut extra: Vec<(usize, u32, f64)> = Vec::new();
    for r in 0..g.nrows() {
        let row: Vec<(usize, f64)> = g.row(r).collect();
        let w = weight(r);
        for &(i, a) in &row {
            extra.extend(row.iter().filter(|(j, _)| i <= *j).map(|&(j, b)| (j, i as u32, w * a * b)));
        }
    }
    extra.sort_unstable_by_key(|e| (e.0, e.1));
    let mut out = SymmetricCsc { n: p.n, col_ptr: vec![0], ..SymmetricCsc::default() };
    let mut next = extra.into_iter().peekable();
    for c in 0..p.n {
        let mut k = p.col_ptr[c];
        loop {
            let row_p = (k < p.col_ptr[c + 1]).then(|| p.row_idx[k]);
            let row_e = next.peek().filter(|e| e.0 == c).map(|e| e.1);
            let Some(r) = [row_p, row_e].into_iter().flatten().min() else { break };
            let mut v = 0.0;
            if row_p == Some(r) {
                v += p.values[k];
                k += 1;
            }
            while next.peek().is_some_and(|e| e.0 == c && e.1 == r) {
                v += next.next().map_or(0.0, |e| e.2);
            }
            out.row_idx.push(r);
            out.values.push(v);
        }
        out.col_ptr.push(out.row_idx.len());
    }
    out
}

/// The stress field of a static solution, in equilibrium to rounding.
pub fn stress(statics: &Static, solution: &Solution) -> Result<StressField, RecoverError> {
    let modes = statics.contact_modes();
    let z = balanced_tractions(statics, solution, &modes)?;
    let mut p = statics.program.p.clone();
    // the free motions among them are held by the program already: one hold per motion, or the holds would carry force
    hold(&mut p, &holds::pins(modes.into_iter().map(|m| m.unknowns).collect(), &statics.pinned), &[]);
    let factor = SparseCholesky::new(&p, &statics.map.block)?;
    let mut rhs = statics.loads.clone();
    if !z.is_empty() {
        statics.program.g.mul_transpose(&z).iter().zip(&mut rhs).for_each(|(a, b)| *b += a);
    }
    let mut parameters = vec![[0.0; PARAMETERS]; statics.elements.model().mesh.tets.len()];
    add_parameters(&statics.elements, &statics.map, &solution.x, true, &mut parameters)?;
    balance_elements(&statics.elements, &statics.map, &factor, &rhs, &mut parameters)?;
    Ok(stress_field(&statics.elements, &parameters)?)
}

/// Corrects the stress parameters by elastic solutions for the forces that `rhs` and the elements' tractions leave
/// unbalanced, until these stop falling.
pub(super) fn balance_elements(
    elements: &SuperElements,
    map: &DofMap,
    factor: &SparseCholesky,
    rhs: &[f64],
    parameters: &mut [[f64; PARAMETERS]],
) -> Result<(), ModelError> {
    let mut last = f64::INFINITY;
    for _ in 0..8 {
        let t = tractions(elements, map, parameters)?;
        let residual: Vec<f64> = rhs.iter().zip(&t).map(|(a, b)| a - b).collect();
        let size = residual.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        if size == 0.0 || size > 0.3 * last {
            break;
        }
        last = size;
        add_parameters(elements, map, &factor.solve(&residual), false, parameters)?;
    }
    Ok(())
}

/// The stress of the elements' parameters.
pub(super) fn stress_field(
    elements: &SuperElements,
    parameters: &[[f64; PARAMETERS]],
) -> Result<StressField, ModelError> {
    let mut points = parameters
        .par_iter()
        .enumerate()
        .map(|(e, a)| Ok(elements.element(e)?.stress(a)))
        .collect::<Result<Vec<_>, ModelError>>()?;
    settle(elements.model(), elements.body_forces(), &mut points);
    Ok(StressField { points })
}

/// Adds the stress parameters of face displacements.
fn add_parameters(
    elements: &SuperElements,
    map: &DofMap,
    x: &[f64],
    particular: bool,
    parameters: &mut [[f64; PARAMETERS]],
) -> Result<(), ModelError> {
    let v = map.expand(x);
    parameters.par_iter_mut().enumerate().try_for_each(|(e, a)| {
        let local = elements.dofs(e).map(|d| v[d]);
        let more = elements.element(e)?.parameters(&local, particular);
        a.iter_mut().zip(more).for_each(|(a, b)| *a += b);
        Ok(())
    })
}

/// Mass-weighted tractions of all elements on the program's unknowns.
fn tractions(elements: &SuperElements, map: &DofMap, parameters: &[[f64; PARAMETERS]]) -> Result<Vec<f64>, ModelError> {
    let local: Vec<[f64; 36]> = parameters
        .par_iter()
        .enumerate()
        .map(|(e, a)| Ok(elements.element(e)?.tractions(a)))
        .collect::<Result<_, ModelError>>()?;
    let mut full = vec![0.0; map.full()];
    for (e, t) in local.iter().enumerate() {
        for (d, x) in elements.dofs(e).into_iter().zip(t) {
            full[d] += x;
        }
    }
    Ok(map.reduce(&full))
}

/// The contact tractions, corrected so that they balance the loads on every rigid motion only contact resists.
///
/// A contact whose force is lost in the solver's noise may have to carry none at all (a loose part that nothing loads):
/// such forces are dropped when the balance cannot be found with them.
fn balanced_tractions(
    statics: &Static,
    solution: &Solution,
    modes: &[crate::model::contact_modes::ContactMode],
) -> Result<Vec<f64>, RecoverError> {
    let program = &statics.program;
    if modes.is_empty() || solution.z.is_empty() {
        return Ok(solution.z.clone());
    }
    let rows: Vec<Vec<f64>> = modes.iter().map(|m| program.g.mul(&m.unknowns)).collect();
    let needed: Vec<f64> = modes.iter().map(|m| m.unknowns.iter().zip(&program.q).map(|(a, b)| a * b).sum()).collect();
    let noise = 1e-7 * solution.z.iter().fold(0.0f64, |m, z| m.max(z.abs()));
    for least in [0.0, noise] {
        let mut z = solution.z.clone();
        for (start, cone) in program.cone_starts().into_iter().zip(&program.cones) {
            let force = &mut z[start..start + cone.dim()];
            if force[0] < least {
                force.fill(0.0);
            }
        }
        if balance(&cone_ranges(program), &rows, &needed, &mut z) {
            return Ok(z);
        }
    }
    Err(RecoverError::Unbalanced(statics.elements.model().parts.join(", ")))
}

/// First row and number of rows of each cone.
pub(super) fn cone_ranges(program: &ConicProgram) -> Vec<(usize, usize)> {
    program.cone_starts().into_iter().zip(&program.cones).map(|(s, c)| (s, c.dim())).collect()
}

/// Moves `s` to the nearest point of the cone `‖s₁…‖ ≤ slope s₀`.
pub(super) fn into_cone(s: &mut [f64], slope: f64) {
    let (n, t) = (s[0], s[1..].iter().map(|x| x * x).sum::<f64>().sqrt());
    if n <= -slope * t {
        s.fill(0.0);
    } else if t > slope * n {
        s[0] = (n + slope * t) / (1.0 + slope * slope);
        // a hair less than the slope: the root above is rounded
        let shorter = slope * (1.0 - 1e-15) * s[0] / t;
        s[1..].iter_mut().for_each(|x| *x *= shorter);
    }
}

/// Corrects `z` by the smallest change, measured in each cone's own (Dikin) metric, that makes `rows · z = needed`; true
/// when every force is still in its cone.
///
/// The inverse Hessian of a cone's barrier, `z zᵀ − ½ det(z) J` (z² on the half-line), lets a force near the cone's
/// surface grow or shrink freely along itself but hardly leave; a change of length below 1 stays inside.
pub(super) fn balance(cones: &[(usize, usize)], rows: &[Vec<f64>], needed: &[f64], z: &mut [f64]) -> bool {
    let n = rows.len();
    for _ in 0..3 {
        let weighted: Vec<Vec<f64>> = rows
            .iter()
            .map(|row| {
                let mut w = vec![0.0; z.len()];
                for &(s, d) in cones {
                    let (z, r) = (&z[s..s + d], &row[s..s + d]);
                    let along: f64 = z.iter().zip(r).map(|(a, b)| a * b).sum();
                    let half_det =
                        if d == 1 { 0.0 } else { 0.5 * cone_margin(z).max(0.0) * (2.0 * z[0] - cone_margin(z)) };
                    for i in 0..d {
                        let j = if i == 0 { 1.0 } else { -1.0 };
                        w[s + i] = z[i] * along - half_det * j * r[i];
                    }
                }
                w
            })
            .collect();
        let dot = |a: &[f64], b: &[f64]| crate::math::Sum::of(a.iter().zip(b).map(|(a, b)| a * b));
        let gram = Mat::from_fn(n, n, |i, j| dot(&rows[i], &weighted[j]));
        let missing = Mat::from_fn(n, 1, |i, _| needed[i] - dot(&rows[i], z));
        // modes that no contact touches have a zero row here; the pseudo-inverse leaves them alone
        let multipliers = pseudo_solve(&gram, &missing);
        for r in 0..z.len() {
            z[r] += (0..n).map(|i| weighted[i][r] * multipliers[(i, 0)]).sum::<f64>();
        }
    }
    cones.iter().all(|&(s, d)| cone_margin(&z[s..s + d]) >= 0.0)
}
