//! The values of a verdict, and the verdict by strict bounds; `judgement` joins it with the checks
//! of the code.

use serde::{Deserialize, Serialize};

/// Answer to whether the demand is carried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The demand is carried.
    Ok,
    /// The demand is not carried: by an upper bound or by a check.
    NotOk,
    /// Neither is certain.
    Undecided,
    /// There is no demand to judge.
    None,
}

impl Verdict {
    /// Verdict on loads of factor 1, from strict bounds of the load factor at collapse; `None`: no
    /// strict bound.
    ///
    /// With friction, `lower` is the bound without friction: associated friction dilates, so its
    /// lower bound is not safe for a real joint (docs/theory.md; Radenkovic, Drucker).
    pub fn of(lower: Option<f64>, upper: Option<f64>) -> Self {
        match (lower, upper) {
            (Some(l), _) if l >= 1.0 => Verdict::Ok,
            (_, Some(u)) if u < 1.0 => Verdict::NotOk,
            _ => Verdict::Undecided,
        }
    }

    /// The worst verdict of several load cases; [`Verdict::None`] without any.
    pub fn worst(verdicts: impl IntoIterator<Item = Self>) -> Self {
        let rank = |v: &Verdict| match v {
            Verdict::None => 0,
            Verdict::Ok => 1,
            Verdict::Undecided => 2,
            Verdict::NotOk => 3,
        };
        verdicts.into_iter().max_by_key(rank).unwrap_or(Verdict::None)
    }

    /// The verdict as a report prints it.
    pub fn words(self) -> &'static str {
        match self {
            Verdict::Ok => "OK",
            Verdict::NotOk => "NOT OK",
            Verdict::Undecided => "UNDECIDED",
            Verdict::None => "none",
        }
    }

    /// The verdict as a report prints it, with the route that proves it.
    pub fn words_by(self, route: Option<Route>) -> &'static str {
        match (self, route) {
            (Verdict::Ok, Some(Route::Code)) => "OK — by code",
            (Verdict::Ok, Some(Route::Analysis)) => "OK — by analysis",
            _ => self.words(),
        }
    }
}

/// The route that proves a demand. Either suffices (docs/contract.md).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Route {
    /// Every check that the code asks of the joint has a method and holds, strength by the
    /// component method included.
    Code,
    /// The lower bound of limit analysis carries the load, and every check of what limit analysis
    /// does not know holds.
    Analysis,
}

/// Bracket of demand over capacity, lower first: the reciprocals of strict bounds of the load
/// factor, rounded outwards. `None` unless both bounds exist and are positive.
pub fn utilisation(lower: Option<f64>, upper: Option<f64>) -> Option<[f64; 2]> {
    let (l, u) = (lower.filter(|l| *l > 0.0)?, upper.filter(|u| *u > 0.0)?);
    Some([(1.0 / u).next_down(), (1.0 / l).next_up()])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_inside_the_bracket_decides_nothing() {
        let v = |l, u| Verdict::of(Some(l), Some(u));
        assert_eq!(
            [v(1.0, 1.1), v(0.9, 1.1), v(0.9, 1.0), v(0.8, 0.999)],
            [Verdict::Ok, Verdict::Undecided, Verdict::Undecided, Verdict::NotOk]
        );
        assert_eq!(Verdict::of(None, Some(2.0)), Verdict::Undecided);
        assert_eq!(Verdict::of(Some(2.0), None), Verdict::Ok);
        assert_eq!(Verdict::of(None, Some(0.0)), Verdict::NotOk);
        assert_eq!(Verdict::of(None, None), Verdict::Undecided);
    }

    #[test]
    fn the_worst_case_counts() {
        use Verdict::{NotOk, Ok, Undecided};
        assert_eq!(Verdict::worst([Ok, Undecided, Ok]), Undecided);
        assert_eq!(Verdict::worst([Undecided, NotOk, Ok]), NotOk);
        assert_eq!(Verdict::worst([]), Verdict::None);
    }

    #[test]
    fn utilisation_never_rounds_inwards() {
        let [low, high] = utilisation(Some(1.5), Some(3.0)).expect("both bounds");
        assert!(low < 1.0 / 3.0 && high > 1.0 / 1.5 && high - low < 0.34);
        assert_eq!(utilisation(Some(0.0), Some(3.0)), None);
        assert_eq!(utilisation(Some(1.0), None), None);
    }
}
