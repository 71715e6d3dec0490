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

/// What the members at a node leave in one load case.
#[derive(Clone, Debug, PartialEq)]
pub struct OfCase {
    /// The load case.
    pub case: String,
    /// Vertical force, as in [`Residuals`] \[N\].
    pub vertical: Sum,
    /// Moment about the node \[N mm\]; its sign turns with the z axis of the column.
    pub moment: Option<Sum>,
}

/// A remainder and the largest part of its sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sum {
    /// The remainder \[N, N mm\].
    pub value: f64,
    /// Largest part of the sum \[N, N mm\].
    pub scale: f64,
}

impl Sum {
    fn of(parts: impl Iterator<Item = f64> + Clone) -> Self {
        let scale = parts.clone().fold(0.0, |m: f64, p| m.max(p.abs()));
        let sum: f64 = parts.sum();
        let value = if sum.abs() <= ROUNDING * scale { 0.0 } else { sum };
        Self { value, scale }
    }
}

/// The worst of the remainders, the first of equal ones.
fn worst<'a>(sums: impl Iterator<Item = (Sum, &'a str)>) -> Option<Residual> {
    let of = |(sum, case): (Sum, &str)| Residual {
        value: sum.value,
        scale: sum.scale,
        case: case.to_owned(),
    };
    sums.fold(None, |worst: Option<(Sum, &str)>, r| match worst {
        Some(w) if w.0.value.abs() >= r.0.value.abs() => Some(w),
        _ => Some(r),
    })
    .map(of)
}

impl Residuals {
    /// The worst of all load cases.
    pub fn worst(cases: &[OfCase]) -> Option<Self> {
        let vertical = worst(cases.iter().map(|c| (c.vertical, c.case.as_str())))?;
        let moments: Option<Vec<_>> =
            cases.iter().map(|c| Some((c.moment?, c.case.as_str()))).collect();
        let moment = moments.and_then(|m| worst(m.into_iter()));
        let moment = moment.map(|m| Residual { value: m.value.abs(), ..m });
        Some(Self { vertical, moment })
    }
}

/// The remainders at a node in each load case; `None` without a member of the column. `ends`: for
/// each member end the point at which its actions act, and +1 or −1 for the side of the column it
/// is on.
///
/// The tables do not say to which side the z axis of the column points. It points to one side in
/// all load cases, to the one that leaves less.
pub fn of_cases(loads: &EndLoads, ends: &[(ActionPoint, Option<f64>)]) -> Option<Vec<OfCase>> {
    if loads.below.is_none() && loads.above.is_none() {
        return None;
    }
    let of_column = |i: usize, action: Action| {
        let of = |l: &Option<Vec<_>>| l.as_ref().map_or(0.0, |l| value(&l[i], action));
        [of(&loads.below), of(&loads.above)]
    };
    let cases = 0..loads.cases();
    let vertical = |i: usize| {
        let [below, above] = of_column(i, Action::N);
        let beams = loads.ends.iter().map(|e| value(&e[i], Action::Vz));
        Sum::of(beams.chain([above, -below]))
    };
    let sides: Option<Vec<f64>> =
        ends.iter().map(|(at, side)| side.filter(|_| *at == ActionPoint::Node)).collect();
    let moments = sides.map(|sides| {
        let with = |sign: f64| -> Vec<Sum> {
            let of = |i: usize| {
                let [below, above] = of_column(i, Action::My);
                let beams = loads.ends.iter().zip(&sides);
                let beams = beams.map(|(e, side)| side * value(&e[i], Action::My));
                Sum::of(beams.chain([sign * below, -sign * above]))
            };
            cases.clone().map(of).collect()
        };
        let most = |s: &[Sum]| s.iter().fold(0.0, |m: f64, s| m.max(s.value.abs()));
        let (one, other) = (with(1.0), with(-1.0));
        if most(&other) < most(&one) { other } else { one }
    });
    let of = |i: usize| OfCase {
        case: loads.ends[0][i].name.clone(),
        vertical: vertical(i),
        moment: moments.as_ref().map(|m| m[i]),
    };
    Some(cases.clone().map(of).collect())
}

/// The largest moment that the beams bring to the node in the ultimate limit state \[N mm\]; `None`
/// where one does not act at the node, or its side is not known.
pub fn brought_by_beams(loads: &EndLoads, ends: &[(ActionPoint, Option<f64>)]) -> Option<Residual> {
    let sides: Option<Vec<f64>> =
        ends.iter().map(|(at, side)| side.filter(|_| *at == ActionPoint::Node)).collect();
    let sides = sides?;
    let ultimate = (0..loads.cases()).filter(|i| loads.ends[0][*i].state.is_ultimate());
    worst(ultimate.map(|i| {
        let beams = loads.ends.iter().zip(&sides);
        let beams = beams.map(|(e, side)| side * value(&e[i], Action::My));
        (Sum::of(beams), loads.ends[0][i].name.as_str())
    }))
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

    fn residuals(loads: &EndLoads, ends: &[(ActionPoint, Option<f64>)]) -> Option<Residuals> {
        Residuals::worst(&of_cases(loads, ends)?)
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

    /// The beams bring 15 − 8 kN m in A, and less in B.
    #[test]
    fn what_the_beams_bring() {
        let found = brought_by_beams(&node(0.0, 1.0), &ENDS).expect("known sides");
        assert_eq!((found.value, found.case.as_str()), (7e6, "A"));
        assert_eq!(brought_by_beams(&node(0.0, 1.0), &[(ActionPoint::Node, None); 2]), None);
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
