//! The derived results that `verify` recomputes from the confirmed fields, in addition to the
//! bounds: the capacity polygon, the stiffness of the joint and the forces of the static field.

use super::json_difference::first_difference;
use crate::result::case_result::CaseResult;
use crate::result::demand::ActionValue;
use crate::result::evidence::EvidencePlan;
use crate::result::forces::{ContactForce, StaticForces, static_forces};
use crate::result::polygon::{CapacityPolygon, Point};
use crate::result::quantity::LoadSize;
use bracket_base::math::convex::HalfPlane;
use bracket_engine::certify::UpperFactor;
use bracket_engine::certify::fields::StressField;
use bracket_engine::certify::half_space::{Actions, Axes, HalfSpace, live_actions};
use bracket_engine::certify::velocity_field::VelocityField;
use bracket_engine::model::AnalysisModel;
use bracket_joint::assembly::BoltLine;
use serde_json::json;

/// Relative difference allowed between a claimed and a recomputed number.
const SAME: f64 = 1e-9;

/// What the input gives about the joint of a result: a model file has no bolts and no mirror.
#[derive(Clone, Debug, Default)]
pub struct Reference {
    /// The bolts whose forces the result lists.
    pub bolts: Vec<BoltLine>,
    /// Axes of the planes of symmetry in use; the planes pass through the origin.
    pub mirror: Vec<usize>,
    /// What is measured in elastoplastic analysis with elastic bolts.
    pub evidence: Option<EvidencePlan>,
    /// The load steps that elastoplastic analysis is asked for.
    pub load_steps: Vec<f64>,
    /// The actions of the load cases whose bounds come from analyses of others.
    pub actions: Vec<(String, Actions)>,
}

/// The results that the files of a case prove.
pub struct Proved {
    /// The entry recomputed from the fields.
    pub entry: CaseResult,
    /// The model of the upper bound, with the forces and moments of the case.
    pub model: AnalysisModel,
    /// The velocities of the upper bound of a load factor, and the bound they prove.
    pub mechanism: Option<(VelocityField, UpperFactor)>,
    /// The stress of the lower bound, on its model, and the load factor it carries.
    pub stress: Option<(AnalysisModel, StressField, f64)>,
}

fn near(a: f64, b: f64) -> bool {
    // infinities and NaN never agree
    (a - b).abs() <= SAME * a.abs().max(b.abs())
}

/// True if a claimed bound is the found one, or both are absent.
pub(super) fn same_bound(claimed: Option<f64>, found: Option<f64>) -> bool {
    match (claimed, found) {
        (Some(c), Some(f)) => near(c, f) || c == f,
        (c, f) => c.is_none() && f.is_none(),
    }
}

/// True if two numbers are equal up to the rounding error of numbers as large as `size`.
fn near_beside(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= SAME * size
}

/// Compares a claimed polygon with the bounds and half planes of the proved cases. Returns a
/// sentence for each difference.
pub fn polygon_differences(claimed: &CapacityPolygon, proved: &[Proved]) -> Vec<String> {
    let of_case = |name: &str| proved.iter().find(|p| p.entry.name == name);
    let along = |direction: [f64; 2]| {
        let point = claimed.points.iter().find(|p| p.direction == direction)?;
        of_case(&point.case)
    };
    let (Some(first), Some(second)) = (along([1.0, 0.0]), along([0.0, 1.0])) else {
        return vec!["polygon: the cases of its two axes are not among its points".into()];
    };
    let axes: Axes = [first, second].map(|p| live_actions(&p.model));
    let mut out = Vec::new();
    for (axis, case) in claimed.axes.iter().zip([first, second]) {
        let same = match (axis.unit, case.entry.load) {
            (ActionValue::Force(unit), Some(LoadSize::Force(load)))
            | (ActionValue::Moment(unit), Some(LoadSize::Moment(load))) => near(unit.abs(), load),
            // several components act at the reference point: the model has no separate value for
            // each of them
            (_, None) => true,
            _ => false,
        };
        if !same {
            out.push(format!(
                "polygon: the unit of {} is not the load of {}",
                axis.action, case.entry.name
            ));
        }
    }
    for point in &claimed.points {
        let differs = match of_case(&point.case) {
            None => Some("there is no such case"),
            Some(case) => point_difference(point, case, &axes),
        };
        out.extend(differs.map(|what| format!("polygon, {}: {what}", point.case)));
    }
    if out.is_empty() {
        out.extend(hull_differences(claimed));
    }
    out
}

/// The first difference of a point of a polygon.
fn point_difference(point: &Point, case: &Proved, axes: &Axes) -> Option<&'static str> {
    let [a, b] = point.direction;
    let actions = case.model.rigid.iter().map(|r| r.action);
    let size = axes.iter().flatten().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    let fits = axes.iter().all(|axis| axis.len() == case.model.rigid.len());
    let turned = |(k, action): (usize, [f64; 6])| {
        (0..6).any(|i| !near_beside(action[i], a * axes[0][k][i] + b * axes[1][k][i], size))
    };
    if !fits || actions.enumerate().any(turned) {
        return Some("its model is not loaded in its direction");
    }
    let (lower, upper) = case.entry.safe_bounds();
    if !same_bound(point.lower, lower) || !same_bound(point.upper, upper) {
        return Some("lower or upper is not the bound of its case");
    }
    let proves = |(velocity, bound): &(VelocityField, UpperFactor)| {
        HalfSpace::new(&case.model, velocity, bound)?.half_plane(axes, point.direction)
    };
    match (point.half_plane, case.mechanism.as_ref().and_then(proves)) {
        (Some(claimed), Some(found)) if same_plane(&claimed, &found) => None,
        (None, None) => None,
        (Some(_), None) => Some("the stored mechanism bounds no half plane"),
        (_, Some(_)) => Some("half_plane is not what the mechanism bounds"),
    }
}

fn same_plane(a: &HalfPlane, b: &HalfPlane) -> bool {
    let size = b.normal[0].hypot(b.normal[1]);
    let offset = near(a.offset, b.offset) || a.offset == b.offset;
    (0..2).all(|k| near_beside(a.normal[k], b.normal[k], size)) && offset
}

/// Compares the claimed hulls with those of the confirmed points.
fn hull_differences(claimed: &CapacityPolygon) -> Vec<String> {
    let names = [claimed.end.clone(), claimed.at.clone()];
    let found = CapacityPolygon::new(names, claimed.axes.clone(), claimed.points.clone());
    let units = claimed.axes.each_ref().map(|a| a.unit.value().abs());
    let same = |a: &[[f64; 2]], b: &[[f64; 2]]| {
        let largest =
            b.iter().fold(1.0f64, |m, c| m.max(c[0].abs() / units[0]).max(c[1].abs() / units[1]));
        let corner = |(a, b): (&[f64; 2], &[f64; 2])| {
            (0..2).all(|k| near_beside(a[k], b[k], largest * units[k]))
        };
        a.len() == b.len() && a.iter().zip(b).all(corner)
    };
    let agree = [
        ("inner is not the hull of the lower points", same(&claimed.inner, &found.inner)),
        ("outer is not the intersection of the half planes", same(&claimed.outer, &found.outer)),
        (
            "outer_bounded does not agree with the half planes",
            claimed.outer_bounded == found.outer_bounded,
        ),
    ];
    agree
        .into_iter()
        .filter(|(_, agrees)| !agrees)
        .map(|(what, _)| format!("polygon: {what}"))
        .collect()
}

/// Compares the claimed stiffness of the joint and the claimed forces with the bracket and the
/// stress of the lower bound.
pub fn case_differences(
    claimed: &CaseResult,
    proved: &Proved,
    reference: &Reference,
) -> Vec<String> {
    let stiffness = stiffness_difference(claimed, &proved.entry);
    stiffness
        .into_iter()
        .chain(force_differences(claimed, proved, reference))
        .map(|what| format!("{}: {what}", claimed.name))
        .collect()
}

/// The stiffness from the confirmed bracket of the rotation. The beam's own rotation and the
/// component method are taken from the claim: the fields do not contain them.
fn stiffness_difference(claimed: &CaseResult, found: &CaseResult) -> Option<String> {
    let given = claimed.joint_stiffness.as_ref()?;
    let (Some(LoadSize::Moment(total)), Some(rotation)) = (found.load, found.load_displacement)
    else {
        return Some(
            "joint_stiffness is given, but the load is not a moment whose rotation is bracketed"
                .into(),
        );
    };
    let again = given.again(total, rotation);
    let same = again.is_some_and(|a| a.agrees(given, near));
    (!same).then(|| "joint_stiffness is not what the bracket of the rotation gives".into())
}

/// Forces of bolts and between parts, from the stress of the lower bound.
fn force_differences(
    claimed: &CaseResult,
    proved: &Proved,
    Reference { bolts: lines, mirror, .. }: &Reference,
) -> Vec<String> {
    let carried = proved.stress.as_ref().filter(|_| !lines.is_empty());
    let (given, (model, stress, factor)) = match (&claimed.static_forces, carried) {
        (None, None) => return Vec::new(),
        (None, Some(_)) => return vec!["static_forces are missing".into()],
        (Some(_), None) => {
            let why = "static_forces are given without bolts or the stress of a lower bound";
            return vec![why.into()];
        }
        (Some(given), Some(carried)) => (given, carried),
    };
    let mut out = Vec::new();
    if !near(given.load_factor, *factor) {
        out.push("static_forces: the load factor is not that of the stress".to_owned());
    }
    let found = static_forces(model, stress, *factor, lines, mirror);
    let sizes = found
        .bolts
        .iter()
        .flat_map(|b| [b.tension, b.shear])
        .chain(found.contacts.iter().map(|c| c.compression));
    let size = sizes.fold(0.0f64, |m, f| m.max(f.abs()));
    let force = |a: f64, b: f64| near_beside(a, b, size);
    let names = |of: &StaticForces| of.bolts.iter().map(|b| b.bolt.clone()).collect::<Vec<_>>();
    if names(given) != names(&found) {
        out.push("static_forces: the bolts are not those of the input".into());
        return out;
    }
    for (b, f) in given.bolts.iter().zip(&found.bolts) {
        if !force(f.tension, b.tension) || !force(f.shear, b.shear) {
            out.push(format!("the forces of bolt {} are not those of the stress", b.bolt));
        }
        let place = format!("static_forces: the place of bolt {}", b.bolt);
        out.extend(first_difference(&json!(b.place), &json!(f.place), &place));
    }
    let reach = model.mesh.nodes.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    let same = |a: &ContactForce, b: &ContactForce| {
        let centre = (0..3).all(|k| (a.centre[k] - b.centre[k]).abs() <= SAME * reach);
        a.between == b.between && force(a.compression, b.compression) && centre
    };
    let contacts = given.contacts.len() == found.contacts.len();
    if !contacts || !given.contacts.iter().zip(&found.contacts).all(|(a, b)| same(a, b)) {
        out.push("the compression between the parts is not that of the stress".into());
    }
    out
}
