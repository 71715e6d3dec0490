//! Certificate of a load factor without limit: a stress field in equilibrium with the live loads
//! alone that comes nowhere nearer to yield.
//!
//! Let a field be in equilibrium with the live loads alone, with its contact tractions inside their
//! cones, a zero deviator in every body that yields, and no traction in any weld of finite
//! strength. Any multiple of it may then be added to an admissible field of the dead loads: the
//! yield condition does not change and friction cones are convex. So every load factor can be
//! carried, also under Coulomb's law, because such a field presses contacts without shear.

use crate::certify::certificate::certify_stress;
use crate::certify::faces::{roles, weld_faces};
use crate::certify::fields::StressField;
use crate::certify::limit_certificate::{LowerCertificate, certify_lower};
use crate::certify::load_factor::LowerFactor;
use crate::certify::measures::{largest, ratio};
use crate::certify::tolerance::TOLERANCE;
use crate::certify::tractions::contact_tractions;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use bracket_base::math::mandel::{self, deviator};
use bracket_base::math::vec3;

/// Certificate of a field that carries the live loads alone: with strict residuals the load factor
/// has no limit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UnlimitedCertificate {
    /// max |div σ + b| h / max |σ|, b the live body force.
    pub equilibrium: f64,
    /// max |Δt| / max |t|, see [`crate::certify::certificate::StaticCertificate::traction_jump`].
    pub traction_jump: f64,
    /// Largest violation of a friction cone / max(|r|, |t|); `None` without contact.
    pub contact: Option<f64>,
    /// max ‖dev σ‖ / max |σ| in bodies that yield.
    pub deviator: f64,
    /// max |t| / max |σ| over welds of finite strength, which must carry nothing; `None` without
    /// welds.
    pub weld: Option<f64>,
    /// Certificate of the field of the dead loads alone; `None` without dead loads or without such
    /// a field.
    pub dead: Option<LowerCertificate>,
    /// True for dead loads without a field, and with resultant limits: nothing is proved.
    pub unproved: bool,
}

impl UnlimitedCertificate {
    /// True when every residual is within [`TOLERANCE`] and the dead loads are carried.
    pub fn is_strict(&self) -> bool {
        let residuals = [
            Some(self.equilibrium),
            Some(self.traction_jump),
            self.contact,
            Some(self.deviator),
            self.weld,
        ];
        let dead = self.dead.as_ref().is_none_or(|d| LowerFactor::new(d.clone()).is_strict());
        residuals.into_iter().flatten().all(|r| r <= TOLERANCE) && dead && !self.unproved
    }
}

/// A load factor without limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Unlimited {
    /// A field in equilibrium with the live loads alone.
    pub field: StressField,
    /// A field of the dead loads alone; `None` without dead loads.
    pub dead: Option<StressField>,
    /// Their certificate.
    pub certificate: UnlimitedCertificate,
}

/// Certifies a field that carries the live loads alone, and one of the dead loads where there are
/// any.
pub fn certify_unlimited(
    model: &AnalysisModel,
    field: &StressField,
    dead: Option<&StressField>,
) -> UnlimitedCertificate {
    let base = certify_stress(model, field, Loads::LIVE);
    let size = largest(field.points.iter().flatten().flatten().map(mandel::norm));
    let yields: Vec<bool> = model.yield_radii().iter().map(Option::is_some).collect();
    let of_tets =
        field.points.iter().zip(&model.mesh.tet_body).filter(|(_, body)| yields[**body as usize]);
    let shear = largest(
        of_tets
            .flat_map(|(s, _)| s.iter().flatten())
            .map(|s| deviator(s).iter().map(|x| x * x).sum()),
    );
    let finite = field.points.iter().flatten().flatten().flatten().all(|x| x.is_finite());
    let loaded = model.has_dead_loads();
    let roles = roles(model, Loads::LIVE);
    UnlimitedCertificate {
        equilibrium: if finite { base.equilibrium } else { f64::NAN },
        traction_jump: base.traction_jump,
        contact: base.contact,
        deviator: ratio(shear.sqrt(), size),
        weld: (!model.welds.is_empty()).then(|| {
            let tractions = weld_faces(model).into_iter().flat_map(|f| {
                let role = roles.get(&(f.a.tet, f.a.local));
                contact_tractions(model, field, &f, role).map(vec3::norm)
            });
            ratio(largest(tractions), size)
        }),
        dead: dead.filter(|_| loaded).map(|d| certify_lower(model, d, 0.0)),
        unproved: loaded && dead.is_none()
            || !model.resultant_limits.is_empty()
            || model.has_crushing_ground(),
    }
}
