//! The check or the bound that decides a verdict.

use crate::check::Check;
use bracket_base::math::figures::{Rounding, utilisation};
use bracket_base::say;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// Check or bound that decides a verdict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Governing {
    /// The load case; absent for a check that needs no load.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub case: Option<String>,
    /// Check and place, in words.
    pub what: Text,
    /// Clause, or `limit analysis`.
    pub clause: Text,
    /// Demand over resistance, lower and upper bound; both equal for a hand check, absent where
    /// there is no number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<[f64; 2]>,
}

impl Governing {
    /// A check that governs.
    pub(super) fn by_check(c: &Check) -> Self {
        Self {
            case: c.case.clone(),
            what: say!("{}, {}", c.title.text(), c.subject.text()),
            clause: c.clause.clone(),
            utilisation: c.utilisation.map(|u| [u, u]),
        }
    }

    /// The governing check with its utilisation and clause.
    pub fn words(&self) -> Text {
        let (what, clause) = (&self.what, &self.clause);
        match self.utilisation {
            Some([l, u]) if l == u => {
                say!("{}, utilisation {} ({})", what, utilisation(u, Rounding::Nearest), clause)
            }
            Some([l, u]) => {
                let (l, u) = (utilisation(l, Rounding::Down), utilisation(u, Rounding::Up));
                say!("{}, utilisation {} … {} ({})", what, l, u, clause)
            }
            None => say!("{} ({})", what, clause),
        }
    }
}
