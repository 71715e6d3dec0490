//! Whether the forces of the members at a node balance.
//!
//! Loads at the node itself are in no table of members, so that a remainder is no fault: it is the
//! load at the node.

use super::column_forces::value;
use super::end_loads::EndLoads;
use bracket_joint::spec::loads::{Action, ActionPoint};

/// What is left of a sum, in the load case in which most is left.
#[derive(Clone, Debug, PartialEq)]
pub struct Residual {
    /// The remainder \[N, N mm\].
    pub value: f64,
    /// Largest part of the sum in that load case, to judge the remainder by \[N, N mm\].
    pub scale: f64,
    /// The load case.
    pub case: String,
}

/// What the members at a node leave.
#[derive(Clone, Debug, PartialEq)]
pub struct Residuals {
    /// Vertical force of the members on the node, up positive: the load at the node, down positive.
    pub vertical: Residual,
    /// Moment of the members about the node in the plane of the joint, no sign; `None` where a
    /// moment does not act at the node, or the template does not say on which side an end is.
    pub moment: Option<Residual>,
}

/// Relative size of a remainder that is rounding.
const ROUNDING: f64 = 1e-9;

impl Residual {
    fn worst(parts: impl Iterator<Item = (Vec<f64>, String)>) -> Option<Self> {
        let of = |(parts, case): (Vec<f64>, String)| {
            let scale = parts.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
            let sum: f64 = parts.iter().sum();
            let value = if sum.abs() <= ROUNDING * scale { 0.0 } else { sum };
            Self { value, scale, case }
        };
        // the first of equal ones
        parts.map(of).fold(None, |worst: Option<Self>, r| match worst {
            Some(w) if w.value.abs() >= r.value.abs() => Some(w),
            _ => Some(r),
        })
    }
}

/// The remainders at a node; `None` without a member of the column. `ends`: for each member end
/// the point at which its actions act, and +1 or −1 for the side of the column it is on.
///
/// The tables do not say to which side the z axis of the column points. It points to one side in
/// all load cases, to the one that leaves less.
pub fn residuals(loads: &EndLoads, ends: &[(ActionPoint, Option<f64>)]) -> Option<Residuals> {
    if loads.below.is_none() && loads.above.is_none() {
        return None;
    }
    let cases = || (0..loads.cases()).map(|i| (i, loads.ends[0][i].name.clone()));
    let of_column = |i: usize, action: Action| {
        let of = |l: &Option<Vec<_>>| l.as_ref().map_or(0.0, |l| value(&l[i], action));
        [of(&loads.below), of(&loads.above)]
    };
    let vertical = cases().map(|(i, case)| {
        let [below, above] = of_column(i, Action::N);
        let beams = loads.ends.iter().map(|e| value(&e[i], Action::Vz));
        (beams.chain([above, -below]).collect(), case)
    });
    let sides: Option<Vec<f64>> =
        ends.iter().map(|(at, side)| side.filter(|_| *at == ActionPoint::Node)).collect();
    let moment = sides.and_then(|sides| {
        let with = |sign: f64| {
            let parts = cases().map(|(i, case)| {
                let [below, above] = of_column(i, Action::My);
                let beams = loads.ends.iter().zip(&sides);
                let beams = beams.map(|(e, side)| side * value(&e[i], Action::My));
                (beams.chain([sign * below, -sign * above]).collect(), case)
            });
            Residual::worst(parts)
        };
        let (one, other) = (with(1.0)?, with(-1.0)?);
        let less = if other.value.abs() < one.value.abs() { other } else { one };
        Some(Residual { value: less.value.abs(), ..less })
    });
    Some(Residuals { vertical: Residual::worst(vertical)?, moment })
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_joint::spec::loads::LoadSpec;

    fn case(name: &str, [n, vz, my]: [f64; 3]) -> LoadSpec {
        let mut load = LoadSpec { name: name.into(), ..LoadSpec::default() };
        load.set(Action::N, n);
        load.set(Action::Vz, vz);
        load.set(Action::My, my);
        load
    }

    /// Two beams with 30 and 20 kN, the column above with −100 kN; the node has a moment of 7 kN m,
    /// 4 of which are above and 3 below.
    fn node(below: f64, sign: f64) -> EndLoads {
        let of = |v: [f64; 3]| vec![case("A", v), case("B", v.map(|x| -0.5 * x))];
        EndLoads {
            ends: vec![of([0.0, -30e3, 15e6]), of([0.0, -20e3, 8e6])],
            below: Some(of([below, 0.0, -3e6 * sign])),
            above: Some(of([-100e3, 0.0, 4e6 * sign])),
        }
    }

    const ENDS: [(ActionPoint, Option<f64>); 2] =
        [(ActionPoint::Node, Some(1.0)), (ActionPoint::Node, Some(-1.0))];

    #[test]
    fn a_node_in_equilibrium_leaves_nothing() {
        for sign in [1.0, -1.0] {
            let found = residuals(&node(-150e3, sign), &ENDS).expect("columns");
            assert_eq!(found.vertical.value, 0.0);
            assert_eq!(found.moment.expect("at the node").value, 0.0);
        }
    }

    #[test]
    fn a_load_at_the_node_is_what_is_left() {
        let mut loads = node(-162e3, 1.0);
        let found = residuals(&loads, &ENDS).expect("columns");
        assert_eq!((found.vertical.value, found.vertical.case.as_str()), (12e3, "A"));
        loads.below.as_mut().expect("a column")[1].set(Action::My, 0.0);
        let moment = residuals(&loads, &ENDS).expect("columns").moment.expect("at the node");
        assert_eq!((moment.value, moment.case.as_str()), (1.5e6, "B"));
    }

    #[test]
    fn what_is_not_known_is_left_out() {
        let alone = EndLoads { below: None, above: None, ..node(0.0, 1.0) };
        assert_eq!(residuals(&alone, &ENDS), None);
        for other in [(ActionPoint::ColumnFace, Some(1.0)), (ActionPoint::Node, None)] {
            let found = residuals(&node(-150e3, 1.0), &[ENDS[0], other]).expect("columns");
            assert_eq!((found.moment, found.vertical.value), (None, 0.0));
        }
    }
}
