//! Recovery of fields that are admissible to rounding from the unknowns of a solver.
//!
//! A conic solver satisfies its constraints to its tolerance only. The violation that remains in
//! the displacement is removed along a field that opens every contact. The stress is projected:
//! contact tractions, strictly inside their cones, are brought into balance with the loads part by
//! part, and an elastic solution brings the bodies into equilibrium with them to rounding.

use crate::certify::fields::{DisplacementField, StressField};
use crate::elements::super_element::PARAMETERS;
use crate::model::loads::Loads;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::conic::{ConicProgram, Csr, SymmetricCsc, cone_margin};
use crate::programs::constraints;
use crate::programs::constraints::hold;
use crate::programs::contact_modes::ContactMode;
use crate::programs::dofs::DofMap;
use crate::programs::kinematic::Kinematic;
use crate::programs::static_form::Static;
use crate::programs::super_elements::SuperElements;
use crate::programs::symmetric_sum::plus_entries;
use crate::recover::force_sets::{Within, cone_ranges};
use crate::recover::interface_balance::{InterfaceBalance, absolute_work};
use crate::recover::load_tractions::largest_traction;
use crate::recover::moving_parts::rigid_mechanism;
use crate::recover::restore_equilibrium::restore_equilibrium;
use crate::solve::Solution;
use crate::solve::sparse::{LinearError, Patterns, SparseCholesky};
use bracket_base::display_text;
use bracket_base::say;
use bracket_base::words::Text;
use rayon::prelude::*;

/// Margin of the traction of a weld below its strength, relative to the strength.
const INSIDE: f64 = 1e-9;

/// Reason why a field could not be recovered.
#[derive(Clone, Debug)]
pub enum RecoverError {
    /// The linear system failed.
    Linear(LinearError),
    /// An element failed.
    Model(ModelError),
    /// No contact forces balance the loads; the motion that they drive, in words.
    NoEquilibrium(Text),
    /// Contact forces in balance with the loads were not found; the parts that only contact holds.
    Unbalanced(String),
    /// The fixed point for Coulomb friction was not found.
    NotConverged {
        /// Number of solves.
        solves: usize,
        /// Largest relative change of the slips in the last solve.
        change: f64,
    },
    /// A field proves no load factor; the reason in words.
    Factor(Text),
}

impl RecoverError {
    /// The reason in words.
    pub fn text(&self) -> Text {
        match self {
            RecoverError::Linear(e) => e.text(),
            RecoverError::Model(e) => e.text(),
            RecoverError::NoEquilibrium(motion) => say!(
                "no contact forces that press and stay within friction can carry the loads: {}",
                motion
            ),
            RecoverError::Unbalanced(parts) => say!(
                "contact forces in balance with the loads were not found near those of the \
                 solver (only contact holds part(s) {}): some are as small as its error",
                parts
            ),
            RecoverError::NotConverged { solves, change } => say!(
                "the fixed point for Coulomb friction did not converge: after {} solves the slips \
                 still change by {} of the largest; `friction: associated` needs no fixed point",
                *solves,
                format!("{change:.1e}")
            ),
            RecoverError::Factor(why) => why.clone(),
        }
    }
}

display_text!(RecoverError);

impl std::error::Error for RecoverError {}

impl From<LinearError> for RecoverError {
    fn from(e: LinearError) -> Self {
        RecoverError::Linear(e)
    }
}

impl From<ModelError> for RecoverError {
    fn from(e: ModelError) -> Self {
        RecoverError::Model(e)
    }
}

/// The displacement field of a kinematic solution, contacts opened where the solver left them
/// violated.
///
/// `model` is the model of the program; `patterns`, here and below, holds the known orderings of
/// the matrices of its mesh.
pub fn displacement(
    model: &AnalysisModel,
    kinematic: &Kinematic,
    solution: &Solution,
    patterns: &Patterns,
) -> Result<DisplacementField, RecoverError> {
    displacement_at(model, kinematic, &kinematic.program.h, solution, patterns)
}

/// The same for a solution whose row offsets differ from those of the program.
pub fn displacement_at(
    model: &AnalysisModel,
    kinematic: &Kinematic,
    offsets: &[f64],
    solution: &Solution,
    patterns: &Patterns,
) -> Result<DisplacementField, RecoverError> {
    opened(model, kinematic, offsets, solution.x.clone(), patterns)
}

/// The displacement field of the unknowns `x` of an elastic program (at least those that elements
/// share), contacts opened where they are violated.
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

/// Smallest margin of the contact cones at the row values `s` \[mm\].
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
    plus_entries(p, extra)
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

/// Contact tractions of a solution (multipliers of the contact cones), followed by weld tractions.
pub(crate) fn interface_tractions(statics: &Static, solution: &Solution) -> Vec<f64> {
    let mut found = solution.z[..statics.program.g.nrows()].to_vec();
    found.extend(statics.weld_tractions(&solution.x));
    found
}

/// The stress field in equilibrium to rounding that is nearest, in elastic energy, to the given
/// parameters. `tractions` are those of contacts and welds as in [`interface_tractions`]; `statics`
/// is the elastic program.
pub(crate) fn balanced_stress(
    statics: &Static,
    tractions: Vec<f64>,
    mut parameters: Vec<[f64; PARAMETERS]>,
    patterns: &Patterns,
) -> Result<StressField, RecoverError> {
    let modes = statics.contact_modes();
    let (z, t) = balanced_tractions(statics, tractions, &modes)?;
    let mut p = statics.program.p.clone();
    // the program constrains the free motions among them already; a second constraint of the same
    // motion would carry force
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

/// Corrects the stress parameters by elastic solutions for the forces left unbalanced between `rhs`
/// and the tractions of the elements, until these forces stop falling.
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
        // the tension of a frozen cut is given and is not balanced
        map.frozen.iter().for_each(|&(k, _)| residual[k] = 0.0);
        // the closings of elastic ground follow from its tractions
        residual[map.closings()].fill(0.0);
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
    restore_equilibrium(elements.model(), elements.body_forces(), &mut points);
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

/// Sets that interface tractions must stay in: the cones of contact tractions up to the strength of
/// ground that crushes, then the strengths of welds.
pub(crate) fn interface_sets(statics: &Static) -> Vec<Within> {
    let model = statics.elements.model();
    // the cones of contact vertices come first
    let mut strengths = statics.vertices.iter().map(|v| model.crushing_strength(v.contact));
    let mut sets: Vec<Within> = cone_ranges(&statics.program)
        .into_iter()
        .map(|(start, dim)| {
            let most = strengths.next().flatten().unwrap_or(f64::INFINITY);
            Within::Cone { start, dim, most }
        })
        .collect();
    let first = statics.program.g.nrows();
    let strengths = model.weld_faces().flat_map(|(strength, _)| [strength; 3]);
    sets.extend(
        strengths.enumerate().map(|(i, radius)| Within::Ball { start: first + 3 * i, radius }),
    );
    sets
}

/// Contact and weld tractions, corrected so that they balance the loads on every rigid motion that
/// only they resist.
fn balanced_tractions(
    statics: &Static,
    mut found: Vec<f64>,
    modes: &[ContactMode],
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
    let terms: Vec<f64> = modes.iter().map(|m| absolute_work(&m.unknowns, &program.q)).collect();
    let model = statics.elements.model();
    let balance = InterfaceBalance {
        sets: &sets,
        rows: &rows,
        needed: &needed,
        terms: &terms,
        // tractions of an interior-point method lie inside their cones
        margins: &[0.0],
        pressure: largest_traction(model, Loads::ALL),
    };
    match balance.find(&found, None) {
        Ok((z, _)) => Ok(apart(z)),
        Err(none) => Err(unbalanced(model, modes, none.driven.as_deref())),
    }
}

/// Why the forces on parts that only contact holds could not be balanced; `driven`: combination of
/// the motions that the loads drive.
pub(crate) fn unbalanced(
    model: &AnalysisModel,
    modes: &[ContactMode],
    driven: Option<&[f64]>,
) -> RecoverError {
    let parts = 0..model.parts.len();
    if let Some(c) = driven {
        let motion = |p: usize| -> [f64; 6] {
            std::array::from_fn(|d| modes.iter().zip(c).map(|(m, c)| c * m.parts[p][d]).sum())
        };
        let motions: Vec<[f64; 6]> = parts.map(motion).collect();
        return RecoverError::NoEquilibrium(rigid_mechanism(model, &motions));
    }
    let size = |m: &ContactMode, p: usize| m.parts[p].iter().fold(0.0f64, |s, x| s.max(x.abs()));
    let largest = |m: &ContactMode| (0..m.parts.len()).map(|p| size(m, p)).fold(0.0, f64::max);
    let held = parts.filter(|p| modes.iter().any(|m| size(m, *p) > 1e-6 * largest(m)));
    let names: Vec<&str> = held.map(|p| model.parts[p].as_str()).collect();
    RecoverError::Unbalanced(names.join(", "))
}
