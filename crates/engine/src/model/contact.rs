//! Contacts of a model: their laws, friction, and opening.

use super::analysis::{AnalysisModel, ContactLaw};
use super::opening::Bernstein;
use crate::model::FrictionLaw;
use bracket_base::math::vec3::V3;

impl ContactLaw {
    /// True for friction by Coulomb's law, where slip causes no dilation.
    pub fn is_coulomb(&self) -> bool {
        self.mu > 0.0 && self.friction == FrictionLaw::Coulomb
    }
}

impl AnalysisModel {
    /// The laws of all contacts: interfaces first, then contacts with the ground.
    fn contact_laws(&self) -> impl Iterator<Item = &ContactLaw> {
        self.interfaces.iter().map(|i| &i.law).chain(self.ground.iter().map(|g| &g.law))
    }

    /// The law of a contact: interfaces first, then contacts with the ground.
    pub fn contact_law(&self, contact: usize) -> &ContactLaw {
        match self.interfaces.get(contact) {
            Some(i) => &i.law,
            None => &self.ground[contact - self.interfaces.len()].law,
        }
    }

    /// Pressure at which the ground of a contact crushes \[MPa\]; `None`: between bodies and on
    /// ground that never crushes.
    pub fn crushing_strength(&self, contact: usize) -> Option<f64> {
        self.ground.get(contact.checked_sub(self.interfaces.len())?)?.strength
    }

    /// Stiffness of the elastic ground of a contact \[N/mm³\]; `None`: between bodies, on rigid
    /// ground and on ground that crushes.
    pub fn ground_stiffness(&self, contact: usize) -> Option<f64> {
        self.ground.get(contact.checked_sub(self.interfaces.len())?)?.stiffness
    }

    /// True when the ground of some contact crushes.
    pub fn has_crushing_ground(&self) -> bool {
        self.ground.iter().any(|g| g.strength.is_some())
    }

    /// The model with ground that never crushes.
    pub fn on_rigid_ground(&self) -> Self {
        let mut rigid = self.clone();
        rigid.ground.iter_mut().for_each(|g| g.strength = None);
        rigid
    }

    /// Coefficients of initial gap plus shift of contact face `face` (interfaces first) \[mm\].
    pub fn opening(&self, face: usize, law: &ContactLaw, corners: &[V3; 3]) -> Bernstein {
        let gap = law.gap.bernstein(corners);
        let shift = self.shift.faces.get(face).copied().unwrap_or_default();
        std::array::from_fn(|i| gap[i] + shift[i])
    }

    /// True when some contact has friction.
    pub fn has_friction(&self) -> bool {
        self.contact_laws().any(|law| law.mu > 0.0)
    }

    /// True when some contact has friction by Coulomb's law.
    pub fn has_coulomb_friction(&self) -> bool {
        self.contact_laws().any(ContactLaw::is_coulomb)
    }

    /// The model with every contact frictionless.
    pub fn without_friction(&self) -> Self {
        let mut smooth = self.clone();
        smooth.interfaces.iter_mut().for_each(|i| i.law.mu = 0.0);
        smooth.ground.iter_mut().for_each(|g| g.law.mu = 0.0);
        smooth
    }
}
