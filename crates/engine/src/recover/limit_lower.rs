//! Projection of an approximate stress field to a strict lower bound of the load factor.
//!
//! The field of a solver violates equilibrium, yield surface and friction cones by its tolerance.
//! Three steps correct it, without the solver:
//!
//! 1. contact tractions are moved inside their cones and brought into balance with
//!    `factor · live + dead` part by part. The factor is an unknown of this balance: where every
//!    contact slips, friction itself is the limit.
//! 2. one refined elastic solution carries the forces that the stress leaves unbalanced. Rigid
//!    bodies, which a solver may leave without stress, are so much stiffer that they carry the
//!    loads acting on them.
//! 3. the field is drawn inside the yield surface, see [`crate::recover::draw_inside`].

use crate::certify::fields::StressField;
use crate::certify::limit_certificate::{LowerCertificate, certify_lower};
use crate::elements::super_element::PARAMETERS;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use crate::programs::constraints::hold;
use crate::programs::contact_modes::ContactMode;
use crate::programs::super_elements::SuperElements;
use crate::programs::{Static, constraints};
use crate::recover::draw_inside::check_dead;
pub use crate::recover::draw_inside::{Lower, LowerError, draw_inside};
use crate::recover::elastic::{
    RecoverError, add_interface_forces, balance_elements, interface_sets, interface_work,
    stress_field, unbalanced,
};
use crate::recover::interface_balance::{Forces, InterfaceBalance, absolute_work};
use crate::recover::load_tractions::largest_traction;
use crate::solve::sparse::{Patterns, SparseCholesky};
use bracket_base::math::Sum;

/// Factor on the stiffness of bodies that never yield.
const RIGID: f64 = 1e8;
/// Margins of contact tractions inside their cones, relative to the pressure; the first with which
/// a balance is found is used.
const INSIDE: [f64; 7] = [1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4];
/// Work of forces on a motion, over that with all of them along its largest displacement, below
/// which it is rounding.
const ROUNDING: f64 = 1e-12;
/// Live tractions over the yield radius below which they count as zero.
const NOTHING: f64 = 1e-6;

/// Stress and tractions of a solver of the static limit program, admissible to its tolerance.
#[derive(Clone, Copy, Debug)]
pub struct ApproximateStress<'a> {
    /// Parameters of every super-element, as
    /// [`crate::elements::super_element::SuperElement::stress`] takes them under
    /// `factor · live + dead`; those of bodies that never yield may be zero.
    pub parameters: &'a [[f64; PARAMETERS]],
    /// Multipliers of every contact vertex of the model, see [`Static::spread_contact`] \[MPa\].
    pub contact: &'a [f64],
    /// Tractions of side A at the vertices of every weld face, see [`Static::weld_tractions`]
    /// \[MPa\]; empty without welds.
    pub welds: &'a [f64],
    /// Load factor.
    pub factor: f64,
}

/// The strict lower bound near an approximate field.
///
/// `dead`: a field in equilibrium with the dead loads alone, strictly admissible (see
/// [`dead_field`]); needed with dead loads. `patterns`, here and below, holds the known orderings
/// of the matrices of the mesh.
pub fn project(
    model: &AnalysisModel,
    approximate: &ApproximateStress,
    dead: Option<&StressField>,
    patterns: &Patterns,
) -> Result<Lower, LowerError> {
    let dead =
        if model.has_dead_loads() { Some(dead.ok_or(LowerError::NoDeadField)?) } else { None };
    let found = equilibrium(model, approximate, dead.is_some(), patterns)
        .and_then(|(field, factor)| draw_inside(model, field, factor, dead));
    match found {
        // no stress of this mesh carries the live loads: zero stress at zero load is a bound
        Ok(lower) if dead.is_none() && lower.certificate.factor <= 0.0 => Ok(at_rest(model)),
        Err(_) if dead.is_none() && is_nothing(model, approximate.factor) => Ok(at_rest(model)),
        found => found,
    }
}

/// Zero stress at zero load.
fn at_rest(model: &AnalysisModel) -> Lower {
    let field = StressField::none(model.mesh.tets.len());
    let certificate = LowerCertificate { scaled_by: 1.0, ..certify_lower(model, &field, 0.0) };
    Lower { field, certificate }
}

/// True when the live loads at the factor are negligible beside the strength. A structure of any
/// slenderness that a mesh can represent collapses under so small a load only if it carries no load
/// at all.
fn is_nothing(model: &AnalysisModel, factor: f64) -> bool {
    let traction = largest_traction(model, Loads::LIVE);
    let weakest = model.yield_radii().into_iter().flatten().fold(f64::INFINITY, f64::min);
    let bodies = model.body_loads.iter().any(|l| !l.dead);
    weakest.is_finite() && !bodies && factor.abs() * traction < NOTHING * weakest
}

/// A strictly admissible field of the dead loads alone, near an approximate one whose factor is
/// zero.
pub fn dead_field(
    model: &AnalysisModel,
    approximate: &ApproximateStress,
    patterns: &Patterns,
) -> Result<StressField, LowerError> {
    let (field, _) =
        equilibrium(model, &ApproximateStress { factor: 0.0, ..*approximate }, false, patterns)?;
    check_dead(model, &field)?;
    Ok(field)
}

/// The model with stiff bodies in place of those that never yield, so that they carry the loads
/// acting on them.
fn stiffened(model: &AnalysisModel) -> AnalysisModel {
    let mut stiff = model.clone();
    let yields: Vec<bool> = model.yield_radii().iter().map(Option::is_some).collect();
    if yields.iter().all(|y| *y) || yields.iter().all(|y| !*y) {
        return stiff;
    }
    for (material, yields) in stiff.body_material.iter_mut().zip(yields) {
        if !yields {
            let mut m = stiff.materials[*material as usize].clone();
            m.e *= RIGID;
            *material = stiff.materials.len() as u32;
            stiff.materials.push(m);
        }
    }
    stiff
}

/// The field in equilibrium to rounding nearest to the approximate one, and its factor. With
/// `lenient` contact tractions may stay outside their cones.
fn equilibrium(
    model: &AnalysisModel,
    approximate: &ApproximateStress,
    lenient: bool,
    patterns: &Patterns,
) -> Result<(StressField, f64), LowerError> {
    let stiff = stiffened(model);
    let statics = Static::new(&stiff).map_err(RecoverError::from)?;
    let modes = statics.contact_modes();
    let (mut z, factor) = balanced(&statics, approximate, &modes, lenient)?;
    let welds = z.split_off(statics.program.g.nrows());
    let loads = Loads::at(factor);
    let mut p = statics.program.p.clone();
    let motions = modes.into_iter().map(|m| m.unknowns).collect();
    hold(&mut p, &constraints::pins(motions, &statics.pinned), &[]);
    let cholesky =
        SparseCholesky::new(&p, &statics.map.block, patterns).map_err(RecoverError::from)?;
    let mut rhs = statics.forces(loads);
    add_interface_forces(&statics, &z, &welds, &mut rhs);
    let elements = SuperElements::new(&stiff).under(loads);
    let mut parameters = approximate.parameters.to_vec();
    balance_elements(&elements, &statics.map, &cholesky, &rhs, &mut parameters)
        .map_err(RecoverError::from)?;
    let field = stress_field(&elements, &parameters).map_err(RecoverError::from)?;
    Ok((field, factor))
}

/// Tractions of contacts inside their cones and of welds within their strength, in balance with the
/// loads on every rigid motion that only they resist; and the load factor of this balance.
fn balanced(
    statics: &Static,
    approximate: &ApproximateStress,
    modes: &[ContactMode],
    lenient: bool,
) -> Result<(Vec<f64>, f64), RecoverError> {
    let factor = approximate.factor;
    let model = statics.elements.model();
    let sets = interface_sets(statics);
    let mut tractions = statics.gather_contact(approximate.contact);
    tractions.extend_from_slice(approximate.welds);
    if modes.is_empty() || sets.is_empty() {
        for set in &sets {
            set.move_in(&mut tractions, INSIDE[0]);
        }
        return Ok((tractions, factor));
    }
    let dot = |a: &[f64], b: &[f64]| Sum::of(a.iter().zip(b).map(|(a, b)| a * b));
    let forces = |loads: Loads| -> Result<Vec<f64>, RecoverError> {
        let (f, p) = (statics.forces(loads), statics.particular_forces(loads)?);
        Ok(f.iter().zip(&p).map(|(a, b)| a - b).collect())
    };
    let (live, dead) = (forces(Loads::LIVE)?, forces(Loads::DEAD)?);
    // rounding in place of no work would tie the load factor to forces that are zero; a motion
    // along the axes has rounding in its other components
    let work = |motion: &[f64], forces: &[f64]| {
        let work = dot(motion, forces);
        let largest = motion.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let all = largest * forces.iter().map(|f| f.abs()).sum::<f64>();
        if work.abs() > ROUNDING * all { work } else { 0.0 }
    };
    // the load factor is one more force, on a half-line
    let rows: Vec<Vec<f64>> = modes
        .iter()
        .map(|m| {
            let mut row = interface_work(statics, &m.unknowns);
            row.push(work(&m.unknowns, &live));
            row
        })
        .collect();
    let needed: Vec<f64> = modes.iter().map(|m| -work(&m.unknowns, &dead)).collect();
    let terms_of =
        |motion: &[f64]| absolute_work(motion, &dead) + factor.abs() * absolute_work(motion, &live);
    let terms: Vec<f64> = modes.iter().map(|m| terms_of(&m.unknowns)).collect();
    let balance = InterfaceBalance {
        sets: &sets,
        rows: &rows,
        needed: &needed,
        terms: &terms,
        margins: &INSIDE,
        pressure: largest_traction(model, Loads::at(factor)),
    };
    let with_factor = |(z, balanced): Forces| (z, balanced.unwrap_or(factor));
    balance.find(&tractions, Some(factor)).map(with_factor).or_else(|none| match none.nearest {
        Some(found) if lenient => Ok(with_factor(found)),
        _ => Err(unbalanced(model, modes, none.driven.as_deref())),
    })
}
