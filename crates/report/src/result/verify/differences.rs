//! Compares the values that a result derives from its bounds with recomputed ones.

use super::history::near_gap;
use crate::result::interface_use::ResultantUse;
use crate::result::quantity::LoadSize;
use crate::result::result_file::CaseResult;
use crate::result::result_file::RawBracket;
use crate::result::result_file::Upper;
use bracket_base::math::vec3;

/// Sentences for the derived values that do not agree.
pub fn derived_differences(claimed: &CaseResult, found: &CaseResult) -> Vec<String> {
    let near = |a: Option<f64>, b: Option<f64>| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) + 1e-12,
        (a, b) => a.is_none() && b.is_none(),
    };
    let end = |c: &CaseResult, i: usize| c.load_displacement.map(|d| d[i]);
    let strict = |c: &CaseResult| c.certificate.is_some_and(|x| x.strict);
    let unbounded = |c: &CaseResult| matches!(c.upper, Some(Upper::Unbounded(_)));
    let raw = |a: Option<RawBracket>, b: Option<RawBracket>| {
        let numbers =
            |r: Option<RawBracket>| (r.and_then(|r| r.lower), r.and_then(|r| r.upper?.finite()));
        let unbounded =
            |r: Option<RawBracket>| matches!(r.and_then(|r| r.upper), Some(Upper::Unbounded(_)));
        let ((al, au), (bl, bu)) = (numbers(a), numbers(b));
        let present = a.is_some() == b.is_some() && unbounded(a) == unbounded(b);
        present && near(al, bl) && near(au, bu)
    };
    let bolts = claimed.preload.iter().zip(&found.preload);
    let preload = claimed.preload.len() == found.preload.len()
        && bolts.into_iter().all(|(a, b)| {
            let same = (&a.body, &a.cut, a.halved) == (&b.body, &b.cut, b.halved);
            same && a.force == b.force && a.closure == b.closure && near(a.tension, b.tension)
        });
    let shares = |of: fn(&CaseResult) -> Vec<(&str, f64)>| {
        let (a, b) = (of(claimed), of(found));
        a.len() == b.len()
            && a.iter().zip(&b).all(|(a, b)| a.0 == b.0 && near(Some(a.1), Some(b.1)))
    };
    let welds = claimed.welds.len() == found.welds.len()
        && claimed.welds.iter().zip(&found.welds).all(|(a, b)| {
            a.weld == b.weld
                && near(a.throat_strength, b.throat_strength)
                && near(a.utilisation, b.utilisation)
                && near(a.mean_utilisation, b.mean_utilisation)
                && near(a.share, b.share)
                && near(a.work, b.work)
        });
    let force = |u: &ResultantUse, d: usize| u.force.map(|f| f[d] / u.at_most);
    // components far below the limit are rounding of the others
    let like = |a: Option<f64>, b: Option<f64>| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) + 1e-12,
        (a, b) => a.is_none() && b.is_none(),
    };
    let crushing = claimed.crushing.len() == found.crushing.len()
        && claimed.crushing.iter().zip(&found.crushing).all(|(a, b)| {
            (&a.ground, a.strength) == (&b.ground, b.strength)
                && like(a.utilisation, b.utilisation)
                && like(a.share, b.share)
        });
    let resultants = claimed.resultants.len() == found.resultants.len()
        && claimed.resultants.iter().zip(&found.resultants).all(|(a, b)| {
            (&a.limit, a.at_most) == (&b.limit, b.at_most)
                && (0..3).all(|d| like(force(a, d), force(b, d)))
                && like(a.utilisation, b.utilisation)
                && like(a.share, b.share)
        });
    let yielding = claimed.yielding.len() == found.yielding.len()
        && claimed.yielding.iter().zip(&found.yielding).all(|(a, b)| {
            a.part == b.part
                && near(a.utilisation, b.utilisation)
                && near(a.yielded, b.yielded)
                && near(a.dissipation, b.dissipation)
                && near(a.plastic_strain, b.plastic_strain)
                && a.strain_at.is_some() == b.strain_at.is_some()
                && (0..3).all(|i| near(a.strain_at.map(|x| x[i]), b.strain_at.map(|x| x[i])))
        });
    // a component that vanishes is rounding noise of the others
    let close = |a: [f64; 3], b: [f64; 3]| vec3::norm(vec3::sub(a, b)) <= 1e-9 * vec3::norm(b);
    let moves = claimed.face_motions.len() == found.face_motions.len()
        && claimed.face_motions.iter().zip(&found.face_motions).all(|(a, b)| {
            a.face == b.face
                && close(a.displacement, b.displacement)
                && close(a.rotation, b.rotation)
        });
    let size = |c: &CaseResult| c.load.map(LoadSize::value);
    let unit = |c: &CaseResult| c.load.map(LoadSize::unit);
    let load = unit(claimed) == unit(found) && near(size(claimed), size(found));
    let peak = |c: &CaseResult| c.peak_contact_pressure.unwrap_or_default();
    let (a, b) = (peak(claimed), peak(found));
    let pressure = near(a.kinematic, b.kinematic) && near(a.static_, b.static_);
    let bounds = claimed.lower.is_some() == found.lower.is_some()
        && claimed.upper.is_some() == found.upper.is_some()
        && unbounded(claimed) == unbounded(found);
    let agree = [
        ("the presence of lower or upper", bounds),
        ("gap", near_gap(claimed.gap, found.gap)),
        ("load", load),
        ("load_displacement", (0..2).all(|i| near(end(claimed, i), end(found, i)))),
        ("problem", claimed.problem == found.problem),
        ("analysis", claimed.analysis == found.analysis),
        ("quantity", claimed.quantity == found.quantity),
        ("frictionless", raw(claimed.frictionless, found.frictionless)),
        ("associated", raw(claimed.associated, found.associated)),
        ("preload", preload),
        ("dissipation", shares(dissipation)),
        ("welds", welds),
        ("support_slip", shares(support_slip)),
        ("tie_slip", shares(tie_slip)),
        ("crushing", crushing),
        ("resultants", resultants),
        (
            "load_displacement_at_least",
            near(claimed.load_displacement_at_least, found.load_displacement_at_least),
        ),
        ("yielding", yielding),
        ("face_motions", moves),
        ("limiting_part", claimed.limiting_part == found.limiting_part),
        ("certificate.strict", strict(claimed) == strict(found)),
        ("certificate", residuals(claimed, found)),
        ("peak_contact_pressure", pressure),
    ];
    agree
        .into_iter()
        .filter(|(_, agrees)| !agrees)
        .map(|(what, _)| format!("{}: {what} is not what the fields give", claimed.name))
        .collect()
}

/// True if the residuals agree up to the rounding errors of their computation.
fn residuals(claimed: &CaseResult, found: &CaseResult) -> bool {
    let of = |c: &CaseResult| c.certificate.map_or([None; 6], |x| x.residuals().map(|r| r.2));
    let near = |(a, b): (Option<f64>, Option<f64>)| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) + 1e-13,
        (a, b) => a.is_none() && b.is_none(),
    };
    of(claimed).into_iter().zip(of(found)).all(near)
}

/// Bodies with their shares in the dissipation.
fn dissipation(c: &CaseResult) -> Vec<(&str, f64)> {
    c.dissipation.iter().map(|p| (p.part.as_str(), p.share)).collect()
}

/// Supports with theirs.
fn support_slip(c: &CaseResult) -> Vec<(&str, f64)> {
    c.support_slip.iter().map(|s| (s.support.as_str(), s.share)).collect()
}

/// Ties with theirs.
fn tie_slip(c: &CaseResult) -> Vec<(&str, f64)> {
    c.tie_slip.iter().map(|s| (s.tie.as_str(), s.share)).collect()
}
