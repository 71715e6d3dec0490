//! A stress field in equilibrium, drawn inside the yield surface: the field of a strict lower bound
//! of the load factor.
//!
//! The field is drawn towards a field of the dead loads alone, strictly inside, until every point
//! is inside: `c σ + (1 − c) σ_d` is in equilibrium with `c factor · live + dead`. Without dead
//! loads σ_d is zero.

use crate::certify::faces::{contact_faces, roles, weld_faces};
use crate::certify::fields::StressField;
use crate::certify::limit_certificate::{LowerCertificate, certify_lower, utilisation};
use crate::certify::measures::{largest, largest_of_each};
use crate::certify::tolerance::TOLERANCE;
use crate::certify::tractions::contact_tractions;
use crate::certify::welds;
use crate::certify::{crushing, cut_limits};
use crate::elements::super_element::PointStress;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use crate::recover::elastic::RecoverError;
use bracket_base::display_text;
use bracket_base::math::mandel::{self, Mandel, deviator};
use bracket_base::math::vec3::{self, V3};
use bracket_base::say;
use bracket_base::words::Text;

/// Largest violation of a friction cone by a field of the dead loads, relative to the largest
/// traction, that rounding explains.
const ROUNDING: f64 = 1e-12;
/// The same while two fields are mixed, relative to the largest stress (measured: 1.5e-12 beside
/// rigid bodies). The allowance of the certificate covers it.
const ROUNDING_OF_MIXED: f64 = 1e-11;

/// A stress field and its certificate.
#[derive(Clone, Debug, PartialEq)]
pub struct Lower {
    /// The field.
    pub field: StressField,
    /// Its certificate.
    pub certificate: LowerCertificate,
}

/// Reason why a stress field proves no load factor.
#[derive(Clone, Debug)]
pub enum LowerError {
    /// The projection failed.
    Recover(RecoverError),
    /// Dead loads act, and no field of the dead loads alone is given.
    NoDeadField,
    /// The field of the dead loads is not strictly admissible.
    DeadField {
        /// The violated condition.
        what: Text,
    },
    /// The field is not in equilibrium to rounding.
    Unbalanced {
        /// Largest relative residual.
        residual: f64,
    },
}

impl LowerError {
    /// The reason in words.
    pub fn text(&self) -> Text {
        match self {
            LowerError::Recover(e) => e.text(),
            LowerError::NoDeadField => {
                "with dead loads a lower bound needs a stress field of the dead loads alone, and \
                 none is given"
                    .into()
            }
            LowerError::DeadField { what } => say!(
                "the stress field of the dead loads alone is not strictly admissible ({}): \
                 without the live loads the structure may not stand",
                what
            ),
            LowerError::Unbalanced { residual } => say!(
                "the stress field cannot be brought into equilibrium: a residual of {} is left, \
                 the limit is {}",
                format!("{residual:.1e}"),
                format!("{TOLERANCE:.0e}")
            ),
        }
    }
}

display_text!(LowerError);

impl std::error::Error for LowerError {}

impl From<RecoverError> for LowerError {
    fn from(e: RecoverError) -> Self {
        LowerError::Recover(e)
    }
}

/// Refuses a field of the dead loads that is not strictly admissible.
pub(crate) fn check_dead(model: &AnalysisModel, field: &StressField) -> Result<(), LowerError> {
    let c = certify_lower(model, field, 0.0);
    let residual = c.equilibrium.max(c.traction_jump);
    let used = c.worst();
    let (balanced, below_yield) = (residual <= TOLERANCE, used + c.cover < 1.0);
    let what = match c.contact {
        _ if !balanced => say!("equilibrium is missed by {}", format!("{residual:.1e}")),
        _ if !below_yield && c.resultant == Some(used) => {
            say!("{} times a resultant limit", format!("{used:.4}"))
        }
        _ if !below_yield && c.ground == Some(used) => {
            say!("{} times the strength of the ground", format!("{used:.4}"))
        }
        _ if !below_yield && used > c.utilisation => {
            say!("{} times the strength of a weld", format!("{used:.4}"))
        }
        _ if !below_yield => {
            let part = c.limiting_part.map_or(String::new(), |p| model.parts[p as usize].clone());
            let times = format!("{:.4}", c.utilisation);
            say!("{} times the yield strength in part {}", times, part)
        }
        Some(violation) if violation > ROUNDING => {
            say!("a friction cone is violated by {}", format!("{violation:.1e}"))
        }
        _ => return Ok(()),
    };
    Err(LowerError::DeadField { what })
}

/// `c a + (1 − c) b`.
fn mixed(a: &StressField, b: Option<&StressField>, c: f64) -> StressField {
    let mix = |e: usize, k: usize, p: usize| -> Mandel {
        std::array::from_fn(|i| {
            c * a.points[e][k][p][i] + b.map_or(0.0, |b| (1.0 - c) * b.points[e][k][p][i])
        })
    };
    let tet = |e| -> PointStress { std::array::from_fn(|k| std::array::from_fn(|p| mix(e, k, p))) };
    StressField { points: (0..a.points.len()).map(tet).collect() }
}

/// Draws a field in equilibrium with `factor · live + dead` towards that of the dead loads until it
/// is admissible.
pub fn draw_inside(
    model: &AnalysisModel,
    field: StressField,
    factor: f64,
    dead: Option<&StressField>,
) -> Result<Lower, LowerError> {
    if let Some(dead) = dead {
        check_dead(model, dead)?;
    }
    let before = certify_lower(model, &field, factor);
    let residual = before.equilibrium.max(before.traction_jump);
    let balanced = residual <= TOLERANCE;
    if !balanced {
        return Err(LowerError::Unbalanced { residual });
    }
    let mut room = 1.0 - 2.0 * before.cover - 1e-12;
    let mut result = None;
    for _ in 0..3 {
        let c = part_inside(model, &field, factor, dead, room);
        // unchanged when it is inside already
        let drawn = if c < 1.0 { mixed(&field, dead, c) } else { field.clone() };
        let certificate =
            LowerCertificate { scaled_by: c, ..certify_lower(model, &drawn, c * factor) };
        let over = certificate.worst() + certificate.cover - 1.0;
        let done = over <= 0.0;
        result = Some(Lower { field: drawn, certificate });
        if done {
            break;
        }
        room -= 2.0 * over;
    }
    result.ok_or(LowerError::Unbalanced { residual })
}

/// The largest c ≤ 1 at which `c field + (1 − c) dead` is within `room` times the yield surface
/// and, with dead loads, inside the friction cones.
fn part_inside(
    model: &AnalysisModel,
    field: &StressField,
    factor: f64,
    dead: Option<&StressField>,
    room: f64,
) -> f64 {
    let radii = model.yield_radii();
    let Some(dead) = dead else {
        let welds = largest_of_each(&welds::utilisations(model, field)).unwrap_or(0.0);
        let limits = largest_of_each(&cut_limits::utilisations(model, field)).unwrap_or(0.0);
        let ground = crushing::utilisations(model, field, Loads::at(factor));
        let ground = largest_of_each(&ground).unwrap_or(0.0);
        let worst = utilisation(model, field).0.max(welds).max(limits).max(ground);
        return if worst > room { room / worst } else { 1.0 };
    };
    let mut c = 1.0f64;
    for (e, (s, d)) in field.points.iter().zip(&dead.points).enumerate() {
        let Some(radius) = radii[model.mesh.tet_body[e] as usize] else { continue };
        for (s, d) in s.iter().flatten().zip(d.iter().flatten()) {
            let (s, d) = (deviator(s), deviator(d));
            let slack = |c: f64| {
                let norm =
                    (0..5).map(|i| (c * s[i] + (1.0 - c) * d[i]).powi(2)).sum::<f64>().sqrt();
                room * radius - norm
            };
            c = largest_part(c, slack);
        }
    }
    for f in weld_faces(model) {
        let (t, d) =
            (contact_tractions(model, field, &f, None), contact_tractions(model, dead, &f, None));
        for (t, d) in t.iter().zip(&d) {
            let slack = |c: f64| {
                let mixed = vec3::add(vec3::scale(c, *t), vec3::scale(1.0 - c, *d));
                room * f.law.strength - vec3::norm(mixed)
            };
            c = largest_part(c, slack);
        }
    }
    let (r, d) = (cut_limits::resultants(model, field), cut_limits::resultants(model, dead));
    for limit in &model.resultant_limits {
        let (r, d) = (limit.resultant(&r), limit.resultant(&d));
        let slack = |c: f64| {
            let mixed = vec3::add(vec3::scale(c, r), vec3::scale(1.0 - c, d));
            room * limit.at_most - limit.value_of(mixed)
        };
        c = largest_part(c, slack);
    }
    let (here, there) = ((field, Loads::at(factor)), (dead, Loads::DEAD));
    for (strength, [p, d]) in crushing::pressure_pairs(model, here, there) {
        c = largest_part(c, |c| room * strength - (c * p + (1.0 - c) * d));
    }
    let (here, there) = (roles(model, Loads::at(factor)), roles(model, Loads::DEAD));
    let contacts = contact_faces(model);
    let pairs: Vec<([V3; 3], [V3; 3])> = contacts
        .iter()
        .map(|f| {
            let key = (f.a.tet, f.a.local);
            (
                contact_tractions(model, field, f, here.get(&key)),
                contact_tractions(model, dead, f, there.get(&key)),
            )
        })
        .collect();
    // a traction is rounded like the stress that it comes from
    let stresses = [field, dead].into_iter().flat_map(|s| s.points.iter().flatten().flatten());
    let rounding = ROUNDING_OF_MIXED * largest(stresses.map(mandel::norm));
    for (f, (r, d)) in contacts.iter().zip(&pairs) {
        let (n, _) = f.normal(model);
        for (r, d) in r.iter().zip(d) {
            let slack = |c: f64| {
                let x = vec3::add(vec3::scale(c, *r), vec3::scale(1.0 - c, *d));
                let pressure = vec3::dot(x, n);
                let shear = vec3::norm(vec3::sub(x, vec3::scale(pressure, n)));
                // a frictionless contact carries no shear
                let cone =
                    if f.law.mu > 0.0 { f.law.mu * pressure - shear } else { pressure.min(-shear) };
                cone + rounding
            };
            c = largest_part(c, slack);
        }
    }
    c
}

/// The largest part up to `c` with slack ≥ 0, for a concave slack that is ≥ 0 at 0.
fn largest_part(c: f64, slack: impl Fn(f64) -> f64) -> f64 {
    if slack(c) >= 0.0 {
        return c;
    }
    let (mut low, mut high) = (0.0, c);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if !(middle > low && middle < high) {
            break;
        }
        if slack(middle) >= 0.0 { low = middle } else { high = middle }
    }
    low
}
