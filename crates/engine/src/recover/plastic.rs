//! Recovery of fields that are admissible to rounding from the unknowns of the elastic, perfectly
//! plastic programs.
//!
//! Displacements: contacts are opened as in the elastic recovery. The plastic strain is not that of
//! the solver but the best one for these displacements, tet by tet. Stresses: contact tractions are
//! balanced, and an elastic solution brings the elements into equilibrium, as in the elastic
//! recovery. That changes the stress by the solver's tolerance, for which the program keeps room
//! below the yield surface.

use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::plastic_field::{InnerNodes, PlasticField, mean, with_plastic_strain};
use crate::elements::split_tet10::INNER_UNKNOWNS;
use crate::model::AnalysisModel;
use crate::programs::{Kinematic, Static};
use crate::recover::elastic::{
    RecoverError, balanced_stress, interface_tractions, opened, smallest_margin, stress_field,
};
use crate::solve::{Patterns, Solution};
use bracket_base::math::vec3;

/// The displacement of a solution of the kinematic program, with plastic strain wherever it lowers
/// the energy.
///
/// The cones of `model` are shifted as the rows of the program are by `offsets`; `patterns`, here
/// and below, holds the known orderings of the matrices of the mesh.
pub fn plastic_motion(
    model: &AnalysisModel,
    kinematic: &Kinematic,
    offsets: &[f64],
    solution: &Solution,
    patterns: &Patterns,
) -> Result<PlasticField, RecoverError> {
    let program = &kinematic.program;
    let mut x = solution.x[..kinematic.map.n].to_vec();
    kinematic.map.keep_frozen(&mut x);
    let given = kinematic.nodal(&x);
    let slack: Vec<f64> = program.g.mul(&x).iter().zip(offsets).map(|(a, b)| a + b).collect();
    let violated = smallest_margin(program, &slack) < 0.0;
    // the elastic program has the same shared unknowns, and a stiffness on all of them
    let nodes = match violated {
        true => {
            let elastic = Kinematic::new(model)?;
            opened(model, &elastic, &elastic.program.h, x, patterns)?
        }
        false => DisplacementField { u: given.clone() },
    };
    let inner = |e: usize| -> Option<InnerNodes> {
        let own = kinematic.own.get(e).copied()?..kinematic.own.get(e + 1).copied()?;
        // parameters of the stress come first; only split elements have inner nodes after them
        let values =
            solution.x[own].last_chunk::<INNER_UNKNOWNS>().filter(|_| kinematic.split[e])?;
        // inner nodes follow the opening of their corners
        let shift =
            mean(model.mesh.tets[e].map(|n| vec3::sub(nodes.u[n as usize], given[n as usize])));
        Some(std::array::from_fn(|i| {
            vec3::add(shift, [values[3 * i], values[3 * i + 1], values[3 * i + 2]])
        }))
    };
    let inner: Vec<Option<InnerNodes>> = (0..model.mesh.tets.len()).map(inner).collect();
    Ok(with_plastic_strain(model, nodes, |e| inner[e]))
}

/// The stress of a solution of the static program, in equilibrium to rounding.
pub fn yielding_stress(
    model: &AnalysisModel,
    statics: &Static,
    solution: &Solution,
    patterns: &Patterns,
) -> Result<StressField, RecoverError> {
    let mut x = solution.x.clone();
    statics.map.keep_frozen(&mut x);
    let parameters = statics.all_parameters(&x)?;
    balanced_stress(
        &Static::new(model)?,
        interface_tractions(statics, solution),
        parameters,
        patterns,
    )
}

/// The stress of a solution of the static program as the solver left it; it proves no bound.
pub fn approximate_stress(
    statics: &Static,
    solution: &Solution,
) -> Result<StressField, RecoverError> {
    Ok(stress_field(&statics.elements, &statics.all_parameters(&solution.x)?)?)
}
