//! Entries and a capacity polygon for tests, which change them as they need.

use crate::result::case_result::CaseResult;
use crate::result::certificate::Certificate;
use crate::result::demand::ActionValue;
use crate::result::polygon::{Axis, CapacityPolygon, Point};
use crate::result::quantity::{FrictionModel, Quantity, Upper};
use bracket_base::math::convex::HalfPlane;
use bracket_engine::model::AnalysisKind;

/// A certified elastic case.
pub(crate) fn case() -> CaseResult {
    CaseResult {
        lower: Some(-334201.713),
        upper: Some(Upper::Finite(-318891.744)),
        gap: Some(0.0458),
        certificate: Some(Certificate {
            strict: true,
            equilibrium: Some(3e-13),
            ..Default::default()
        }),
        ..CaseResult::empty(
            "TOP",
            AnalysisKind::Elastic,
            (Quantity::PotentialEnergy, FrictionModel::Associated),
        )
    }
}

/// A limit-analysis case with these bounds.
pub(crate) fn limit_case(lower: Option<f64>, upper: Option<f64>) -> CaseResult {
    let mut case = case();
    case.quantity = Quantity::LoadFactor;
    (case.problem, case.lower, case.upper) =
        (FrictionModel::Frictionless, lower, upper.map(Upper::Finite));
    case
}

/// Four directions of a structure that carries the square |x| ≤ 1, |y| ≤ 1 exactly.
pub(crate) fn square(bounds: bool) -> CapacityPolygon {
    let axes = [
        Axis { action: "My".into(), unit: ActionValue::Moment(1e8) },
        Axis { action: "N".into(), unit: ActionValue::Force(2e5) },
    ];
    let points = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].into_iter().enumerate().map(
        |(k, direction)| Point {
            case: format!("polygon_{}", 90 * k),
            direction,
            lower: Some(0.9),
            upper: Some(1.1),
            half_plane: (bounds || k != 2).then_some(HalfPlane { normal: direction, offset: 1.1 }),
        },
    );
    CapacityPolygon::new(["beam_right".into(), "column_face".into()], axes, points.collect())
}
