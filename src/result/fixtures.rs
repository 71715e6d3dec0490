//! An entry for tests, which change it as they need.

use crate::result::case_result::CaseResult;
use crate::result::certificate::Certificate;
use crate::result::quantity::{FrictionModel, Quantity, Upper};
use crate::spec::analysis::AnalysisKind;

/// A certified elastic case.
pub(crate) fn case() -> CaseResult {
    CaseResult {
        name: "TOP".into(),
        analysis: AnalysisKind::Elastic,
        quantity: Quantity::PotentialEnergy,
        problem: FrictionModel::Associated,
        lower: Some(-334201.713),
        upper: Some(Upper::Finite(-318891.744)),
        gap: Some(0.0458),
        utilisation: None,
        demand: None,
        frictionless: None,
        associated: None,
        coulomb_estimate: None,
        preload: vec![],
        fixed_point: None,
        load: None,
        load_displacement: None,
        load_displacement_at_least: None,
        static_forces: None,
        joint_stiffness: None,
        certificate: Some(Certificate {
            strict: true,
            equilibrium: Some(3e-13),
            ..Default::default()
        }),
        history: vec![],
        dissipation: vec![],
        yielding: vec![],
        limiting_part: None,
        welds: vec![],
        peak_contact_pressure: None,
        warnings: vec![],
    }
}
