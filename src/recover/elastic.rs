//! From a solver's unknowns to fields that are admissible to rounding.
//!
//! A conic solver satisfies its constraints to its tolerance. The displacement is opened by the
//! last violation along a field that opens every contact; the stress is projected: contact
//! tractions (strictly inside their cones) are first brought into balance with the loads part by
//! part, then the bodies are solved for exact equilibrium with them.

use crate::certify::fields::{DisplacementField, StressField};
use crate::elements::super_element::PARAMETERS;
use crate::math::dense::pseudo_solve;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::conic::{ConicProgram, Csr, SymmetricCsc, cone_margin};
use crate::programs::constraints::{self, hold};
use crate::programs::dofs::DofMap;
use crate::programs::kinematic::Kinematic;
use crate::programs::static_form::Static;
use crate::programs::super_elements::SuperElements;
use crate::recover::restore_equilibrium::settle;
use crate::solve::Solution;
use crate::solve::sparse::{LinearError, Patterns, SparseCholesky};
use faer::Mat;
use rayon::prelude::*;

/// How far inside its strength the traction of a weld is put, relative to it.
const INSIDE: f64 = 1e-9;
/// What rounding may use up of that.
const ROOM: f64 = 1e-11;

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
    /// The fixed point for Coulomb friction was not found.
    #[error(
        "the fixed point for Coulomb friction did not converge: after {solves} solves the slips \
         still change by {change:.1e} of the largest; `friction: associated` needs none"
    )]
    NotConverged {
        /// Problems solved.
        solves: usize,
        /// Largest change of the last of them.
        change: f64,
    },
    /// A field that proves no load factor, in words.
    #[error("{0}")]
    Factor(String),
}

/// The displacement field of a kinematic solution, contacts opened where the solver left them
/// violated.
///
/// `model` is the one the program was made from; `patterns` here and below: what is known of the
/// mesh's matrices.
pub fn displacement(
    model: &AnalysisModel,
    kinematic: &Kinematic,
    solution: &Solution,
    patterns: &Patterns,
) -> Result<DisplacementField, RecoverError> {
    displacement_at(model, kinematic, &kinematic.program.h, solution, patterns)
}

/// The same for a solution with other offsets of the rows than the program's own.
pub fn displacement_at(
    model: &AnalysisModel,
    kinematic: &Kinematic,
    offsets: &[f64],
    solution: &Solution,
    patterns: &Patterns,
) -> Result<DisplacementField, RecoverError> {
    opened(model, kinematic, offsets, solution.x.clone(), patterns)
}

/// The displacement field of an elastic program's unknowns `x`, at least those that elements share,
/// contacts opened where they are violated.
pub(crate) fn opened(
    model: &AnalysisModel,
    kinematic: &Kinematic,
    offsets: &[f64],
    mut x: Vec<f64>,
    patterns: &Patterns,
) -> Result<DisplacementField, RecoverError> {
    kinematic.map.keep_frozen(&mut x);
    let program = &kinematic.program;
    let welds = (!model.welds.is_empty()).then(|| kinematic.weld_rows(model));
    for _ in 0..3 {
        let slack: Vec<f64> = program.g.mul(&x).iter().zip(offsets).map(|(a, b)| a + b).collect();
        let violation = smallest_margin(program, &slack);
        if violation >= 0.0 {
            break;
        }
        let opening = opening_field(program, welds.as_ref(), &kinematic.map.block, patterns)?;
        let gain = smallest_margin(program, &program.g.mul(&opening));
        if gain <= 0.0 {
            break;
        }
        let step = -1.1 * violation / gain;
        x.iter_mut().zip(&opening).for_each(|(x, w)| *x += step * w);
    }
    Ok(DisplacementField { u: kinematic.nodal(&x) })
}

/// Smallest margin of the contact cones in the rows `s` \[mm\].
pub(crate) fn smallest_margin(program: &ConicProgram, s: &[f64]) -> f64 {
    let cones = cone_ranges(program).into_iter();
    cones.map(|(at, dim)| cone_margin(&s[at..at + dim])).fold(f64::INFINITY, f64::min)
}

/// A displacement that opens every contact by about 1 mm with little slip and opens no weld: least
/// squares on the gaps and on the jumps of `welds`, regularised by the stiffness.
fn opening_field(
    program: &ConicProgram,
    welds: Option<&Csr>,
    block: &[u32],
    patterns: &Patterns,
) -> Result<Vec<f64>, RecoverError> {
    let diagonal = program.p.diagonal();
    let weight = 1e4 * diagonal.iter().sum::<f64>() / diagonal.len().max(1) as f64;
    let mut system = plus_rows(&program.p, &program.g, |_| weight);
    if let Some(rows) = welds {
        system = plus_rows(&system, rows, |_| weight);
    }
    let mut target = vec![0.0; program.g.nrows()];
    cone_ranges(program).into_iter().for_each(|(at, _)| target[at] = weight);
    let factor = SparseCholesky::new(&system, block, patterns)?;
    Ok(factor.solve(&program.g.mul_transpose(&target)))
}

/// `P + GᵀWG` with a weight for each row.
pub(crate) fn plus_rows(p: &SymmetricCsc, g: &Csr, weight: impl Fn(usize) -> f64) -> SymmetricCsc {
    let mut extra: Vec<(usize, u32, f64)> = Vec::new();
    for r in 0..g.nrows() {
        let row: Vec<(usize, f64)> = g.row(r).collect();
        let w = weight(r);
        for &(i, a) in &row {
            extra.extend(
                row.iter().filter(|(j, _)| i <= *j).map(|&(j, b)| (j, i as u32, w * a * b)),
            );
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
pub fn stress(
    statics: &Static,
    solution: &Solution,
    patterns: &Patterns,
) -> Result<StressField, RecoverError> {
    let mut parameters = vec![[0.0; PARAMETERS]; statics.elements.model().mesh.tets.len()];
    let mut x = solution.x.clone();
    statics.map.keep_frozen(&mut x);
    add_parameters(&statics.elements, &statics.map, &x, true, &mut parameters)?;
    balanced_stress(statics, interface_tractions(statics, solution), parameters, patterns)
}

/// Contact tractions of a solution (multipliers of the contact cones), then those of welds.
pub(crate) fn interface_tractions(statics: &Static, solution: &Solution) -> Vec<f64> {
    let mut found = solution.z[..statics.program.g.nrows()].to_vec();
    found.extend(statics.weld_tractions(&solution.x));
    found
}

/// The stress field in equilibrium to rounding nearest, in elastic energy, to the given parameters;
/// `tractions`: those of contacts and welds as in [`interface_tractions`], `statics`: the elastic
/// program.
pub(crate) fn balanced_stress(
    statics: &Static,
    tractions: Vec<f64>,
    mut parameters: Vec<[f64; PARAMETERS]>,
    patterns: &Patterns,
) -> Result<StressField, RecoverError> {
    let modes = statics.contact_modes();
    let (z, t) = balanced_tractions(statics, tractions, &modes)?;
    let mut p = statics.program.p.clone();
    // the free motions among them are held by the program already: one hold per motion, or the
    // holds would carry force
    hold(
        &mut p,
        &constraints::pins(modes.into_iter().map(|m| m.unknowns).collect(), &statics.pinned),
        &[],
    );
    let factor = SparseCholesky::new(&p, &statics.map.block, patterns)?;
    let mut rhs = statics.loads.clone();
    add_interface_forces(statics, &z, &t, &mut rhs);
    balance_elements(&statics.elements, &statics.map, &factor, &rhs, &mut parameters)?;
    Ok(stress_field(&statics.elements, &parameters)?)
}

/// Corrects the stress parameters by elastic solutions for the forces that `rhs` and the elements'
/// tractions leave unbalanced, until these stop falling.
pub(crate) fn balance_elements(
    elements: &SuperElements,
    map: &DofMap,
    factor: &SparseCholesky,
    rhs: &[f64],
    parameters: &mut [[f64; PARAMETERS]],
) -> Result<(), ModelError> {
    let mut last = f64::INFINITY;
    for _ in 0..8 {
        let t = tractions(elements, map, parameters)?;
        let mut residual: Vec<f64> = rhs.iter().zip(&t).map(|(a, b)| a - b).collect();
        // the tension of a frozen cut balances nothing
        map.frozen.iter().for_each(|&(k, _)| residual[k] = 0.0);
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
pub(crate) fn stress_field(
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
fn tractions(
    elements: &SuperElements,
    map: &DofMap,
    parameters: &[[f64; PARAMETERS]],
) -> Result<Vec<f64>, ModelError> {
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

/// Adds the forces of contact tractions `z` (multipliers of the contact cones) and weld tractions
/// `t` on the faces.
pub(crate) fn add_interface_forces(statics: &Static, z: &[f64], t: &[f64], forces: &mut [f64]) {
    if !z.is_empty() {
        statics.program.g.mul_transpose(z).iter().zip(&mut *forces).for_each(|(a, b)| *b += a);
    }
    if !t.is_empty() {
        statics.welds.mul_transpose(t).iter().zip(forces).for_each(|(a, b)| *b -= a);
    }
}

/// The work of contact and weld tractions of unit size on a motion.
pub(crate) fn interface_work(statics: &Static, motion: &[f64]) -> Vec<f64> {
    let mut row = statics.program.g.mul(motion);
    row.extend(statics.welds.mul(motion).iter().map(|x| -x));
    row
}

/// Where interface tractions must stay: contact tractions in their cones, then those of welds
/// within their strength.
pub(crate) fn interface_sets(statics: &Static) -> Vec<Within> {
    let mut sets: Vec<Within> = cone_ranges(&statics.program)
        .into_iter()
        .map(|(start, dim)| Within::Cone { start, dim })
        .collect();
    let first = statics.program.g.nrows();
    let strengths = statics.elements.model().weld_faces().flat_map(|(strength, _)| [strength; 3]);
    sets.extend(
        strengths.enumerate().map(|(i, radius)| Within::Ball { start: first + 3 * i, radius }),
    );
    sets
}

/// Contact and weld tractions, corrected so that they balance the loads on every rigid motion only
/// they resist.
///
/// A contact whose force is lost in the solver's noise may have to carry none at all (a loose part
/// that nothing loads): such forces are dropped when the balance cannot be found with them.
fn balanced_tractions(
    statics: &Static,
    mut found: Vec<f64>,
    modes: &[crate::programs::contact_modes::ContactMode],
) -> Result<(Vec<f64>, Vec<f64>), RecoverError> {
    let program = &statics.program;
    let contacts = program.g.nrows();
    let sets = interface_sets(statics);
    sets.iter().for_each(|set| set.draw_in(&mut found, INSIDE));
    let apart = |mut z: Vec<f64>| {
        let t = z.split_off(contacts);
        (z, t)
    };
    if modes.is_empty() || found.is_empty() {
        return Ok(apart(found));
    }
    let rows: Vec<Vec<f64>> = modes.iter().map(|m| interface_work(statics, &m.unknowns)).collect();
    let needed: Vec<f64> =
        modes.iter().map(|m| m.unknowns.iter().zip(&program.q).map(|(a, b)| a * b).sum()).collect();
    let noise = 1e-7 * found.iter().fold(0.0f64, |m, z| m.max(z.abs()));
    for least in [0.0, noise] {
        let mut z = found.clone();
        for (start, dim) in cone_ranges(program) {
            let force = &mut z[start..start + dim];
            if force[0] < least {
                force.fill(0.0);
            }
        }
        if balance(&sets, &rows, &needed, &mut z) {
            return Ok(apart(z));
        }
    }
    Err(RecoverError::Unbalanced(statics.elements.model().parts.join(", ")))
}

/// First row and number of rows of each contact cone.
pub(crate) fn cone_ranges(program: &ConicProgram) -> Vec<(usize, usize)> {
    let contacts = program.g.nrows();
    let all = program.cone_starts().into_iter().zip(&program.cones);
    all.take_while(|(start, _)| *start < contacts).map(|(s, c)| (s, c.dim())).collect()
}

/// Where a force must stay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Within {
    /// The second-order cone, or the half-line, of `dim` rows from `start` on.
    Cone { start: usize, dim: usize },
    /// No longer than `radius`: three rows.
    Ball { start: usize, radius: f64 },
}

impl Within {
    /// First row and number of rows.
    pub fn range(self) -> (usize, usize) {
        match self {
            Within::Cone { start, dim } => (start, dim),
            Within::Ball { start, .. } => (start, 3),
        }
    }

    /// Shortens the force in a ball to `1 − margin` of its radius at most; leaves cones alone.
    pub fn draw_in(self, z: &mut [f64], margin: f64) {
        if let Within::Ball { start, radius } = self {
            let force = &mut z[start..start + 3];
            let (size, room) = (norm(force), (1.0 - margin) * radius);
            if size > room {
                force.iter_mut().for_each(|x| *x *= room / size);
            }
        }
    }

    /// Least distance that is left to the surface.
    fn margin(self, z: &[f64]) -> f64 {
        let (start, dim) = self.range();
        let force = &z[start..start + dim];
        match self {
            Within::Cone { .. } => cone_margin(force),
            Within::Ball { radius, .. } => (1.0 - ROOM) * radius - norm(force),
        }
    }

    /// The inverse Hessian of the set's barrier at `z` times `r`: `z zᵀ − ½ det(z) J` of a cone (z²
    /// of the half-line), `½ d (I − 2 z zᵀ/(d + 2 ‖z‖²))` with `d = radius² − ‖z‖²` of a ball.
    fn metric(self, z: &[f64], r: &[f64], out: &mut [f64]) {
        let along: f64 = z.iter().zip(r).map(|(a, b)| a * b).sum();
        match self {
            Within::Cone { dim, .. } => {
                let half_det = if dim == 1 {
                    0.0
                } else {
                    0.5 * cone_margin(z).max(0.0) * (2.0 * z[0] - cone_margin(z))
                };
                for i in 0..dim {
                    let j = if i == 0 { 1.0 } else { -1.0 };
                    out[i] = z[i] * along - half_det * j * r[i];
                }
            }
            Within::Ball { radius, .. } => {
                let size = norm(z);
                let d = ((radius - size) * (radius + size)).max(0.0);
                let taken = 2.0 * along / (d + 2.0 * size * size).max(f64::MIN_POSITIVE);
                (0..3).for_each(|i| out[i] = 0.5 * d * (r[i] - taken * z[i]));
            }
        }
    }
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Moves `s` to the nearest point of the cone `‖s₁…‖ ≤ slope s₀`.
pub(crate) fn into_cone(s: &mut [f64], slope: f64) {
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

/// Corrects `z` by the smallest change, measured in each set's own (Dikin) metric, that makes
/// `rows · z = needed`; true when every force is still in its set.
///
/// The inverse Hessian of a cone's barrier lets a force near the cone's surface grow or shrink
/// freely along itself but hardly leave; a change of length below 1 stays inside.
pub(crate) fn balance(sets: &[Within], rows: &[Vec<f64>], needed: &[f64], z: &mut [f64]) -> bool {
    let n = rows.len();
    for _ in 0..3 {
        let weighted: Vec<Vec<f64>> = rows
            .iter()
            .map(|row| {
                let mut w = vec![0.0; z.len()];
                for set in sets {
                    let (s, d) = set.range();
                    set.metric(&z[s..s + d], &row[s..s + d], &mut w[s..s + d]);
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
    sets.iter().all(|set| set.margin(z) >= 0.0)
}
