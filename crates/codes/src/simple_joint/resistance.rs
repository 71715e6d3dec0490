//! A resistance to the shear force of a joint, with or without a demand.

use crate::check::{Check, Status, Topic};
use crate::subject::Subject;
use crate::worked::Worked;

/// A resistance to the vertical shear force \[N\].
pub(super) struct Resistance {
    /// Its value.
    pub worked: Worked,
    /// Topic of the check.
    pub topic: Topic,
    /// What resists.
    pub subject: Subject,
    /// Whether a limit analysis of the same case determines this strength as well.
    pub plastic: bool,
}

impl Resistance {
    /// A resistance of a section or of a block.
    pub fn of_member(worked: Worked, subject: impl Into<Subject>) -> Self {
        Self { worked, topic: Topic::Member, subject: subject.into(), plastic: false }
    }

    /// The resistance as one that a limit analysis determines as well.
    pub fn plastic(self) -> Self {
        Self { plastic: true, ..self }
    }

    /// The resistance without a demand.
    pub fn information(self) -> Check {
        self.worked.information(self.topic, self.subject)
    }

    /// The resistance against a demand ≥ 0 \[N\] at a member end.
    pub fn against(self, end: &str, demand: f64) -> Check {
        let subject = Subject::end(end).and(self.subject);
        let check = self.worked.against(self.topic, subject, demand, Status::Failed);
        if self.plastic { check.of_strength() } else { check }
    }
}
