//! Forces of the column beside a joint that the checks take for all of its load cases.

use super::end_loads::EndLoads;
use bracket_joint::spec::loads::{Action, LoadSpec};

/// Relative part of a value that is rounding and is not rounded up.
const ROUNDING: f64 = 1e-12;

/// The least favourable forces of the column, over all load cases of the ultimate limit state and
/// both of its members.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnForces {
    /// Axial force of largest size, tension positive; a compression if any load case compresses
    /// the column \[N\].
    pub axial: f64,
    /// Largest moment about the strong axis at the node, no sign \[N mm\].
    pub moment: f64,
    /// Largest shear force along the web, no sign \[N\].
    pub shear: f64,
}

impl ColumnForces {
    /// The forces of a joint; `None` without a member of the column or without a load case of the
    /// ultimate limit state.
    pub fn of(loads: &EndLoads) -> Option<Self> {
        let all = || {
            let members = loads.below.iter().chain(&loads.above);
            members.flatten().filter(|l| l.state.is_ultimate())
        };
        all().next()?;
        let most = |a: Action| all().map(|l| value(l, a).abs()).fold(0.0, f64::max);
        let sign = if all().any(|l| value(l, Action::N) < 0.0) { -1.0 } else { 1.0 };
        let (axial, moment, shear) = (most(Action::N), most(Action::My), most(Action::Vz));
        Some(Self { axial: sign * axial + 0.0, moment, shear })
    }

    /// The values of the spec: paths below the column, with units. Sizes are rounded up to 1 N and
    /// 1 N m.
    pub fn values(&self) -> [(&'static str, String); 2] {
        let up = |x: f64| (x.abs() * (1.0 - ROUNDING)).ceil().copysign(x);
        let (axial, moment) = (up(self.axial) / 1e3, up(self.moment / 1e3) / 1e3);
        [("N_Ed", format!("{axial:.3} kN")), ("M_Ed", format!("{moment:.3} kN m"))]
    }
}

/// The value of an action \[N, N mm\]; an action that is not given is zero.
pub fn value(load: &LoadSpec, action: Action) -> f64 {
    load.value(action).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_joint::spec::loads::LimitState;

    fn load(n: f64, my: f64) -> LoadSpec {
        let mut load = LoadSpec { name: "A".into(), ..LoadSpec::default() };
        load.set(Action::N, n);
        load.set(Action::My, my);
        load
    }

    #[test]
    fn the_least_favourable_of_all_load_cases() {
        let below = vec![load(-100_000.2, 1.0), load(40e3, -3e6)];
        let above = vec![load(250e3, 2e6), load(-5e3, 0.0)];
        let loads = EndLoads { below: Some(below), above: Some(above), ..EndLoads::default() };
        let forces = ColumnForces::of(&loads).expect("forces");
        assert_eq!((forces.axial, forces.moment), (-250e3, 3e6));
        let [axial, moment] = forces.values();
        assert_eq!((axial.1.as_str(), moment.1.as_str()), ("-250.000 kN", "3.000 kN m"));
        let one = |n: f64| ColumnForces { axial: n, moment: 1000.5, shear: 0.0 };
        assert_eq!(one(-100_000.2).values()[0].1, "-100.001 kN");
        assert_eq!(one(-100_000.0).values()[1].1, "0.002 kN m");
    }

    #[test]
    fn only_the_ultimate_limit_state_counts() {
        let mut sls = load(-900e3, 9e6);
        sls.state = LimitState::Serviceability;
        let loads = |l: Vec<LoadSpec>| EndLoads { below: Some(l), ..EndLoads::default() };
        assert_eq!(ColumnForces::of(&loads(vec![sls.clone()])), None);
        let forces = ColumnForces::of(&loads(vec![sls, load(20e3, 0.0)])).expect("forces");
        assert_eq!((forces.axial, forces.moment), (20e3, 0.0));
        assert_eq!(ColumnForces::of(&EndLoads::default()), None);
    }
}
