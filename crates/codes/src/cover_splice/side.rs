//! One of the two members of a splice, and one of its flanges.

use crate::eurocode::i_section::Section;
use crate::eurocode::section::CrossSection;
use crate::subject::{Part, Subject};
use bracket_joint::assembly::{CoverSplice, SplicedMember, Way};

/// Both flanges.
pub(super) const FLANGES: [Way; 2] = [Way::Up, Way::Down];

/// A member of a splice as the checks see it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side<'a> {
    /// The member.
    pub member: &'a SplicedMember,
    /// Its section.
    pub section: Section,
    /// Which one it is; `None` where both are the same.
    named: Option<Part>,
}

/// The members that differ: both, or one for both.
pub(super) fn sides(e: &CoverSplice) -> Vec<Side<'_>> {
    let side = |member, named| Side { member, section: (&member.section).into(), named };
    match e.left == e.right {
        true => vec![side(&e.left, None)],
        false => {
            vec![side(&e.left, Some(Part::LeftMember)), side(&e.right, Some(Part::RightMember))]
        }
    }
}

impl Side<'_> {
    /// The subject with the member, where it needs a name, and a part of it.
    pub fn of(&self, subject: Subject, part: Part) -> Subject {
        let subject = match self.named {
            Some(member) => subject.and(member),
            None => subject,
        };
        subject.and(part)
    }

    /// The subject with the member itself.
    pub fn member(&self, subject: Subject, all: Part) -> Subject {
        subject.and(self.named.unwrap_or(all))
    }

    /// Its cross-section with the steel of its flange.
    pub fn cross_section(&self, gamma_m0: f64) -> CrossSection {
        CrossSection { section: self.section, fy: self.member.flange_steel.fy, gamma_m0 }
    }

    /// Thickness of the thicker pack at a shear plane of the bolts of a flange \[mm\].
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.6.1(13).
    pub fn pack(&self, flange: Way) -> f64 {
        let [up, down] = self.member.packs;
        let outer = if flange == Way::Up { up } else { down };
        outer.max(self.member.inner_packs)
    }
}

/// A flange as a part.
pub(super) fn flange_part(flange: Way) -> Part {
    match flange {
        Way::Up => Part::UpperFlange,
        Way::Down => Part::LowerFlange,
    }
}
