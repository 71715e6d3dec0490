//! The bolts of a web as an elastic group: equal stiffness, rigid plates.

use crate::check::{Unit, largest};
use crate::formula::{Formula, Number, Traced};
use bracket_joint::assembly::CoverSplice;

/// The bolts of a web on one side of the splice axis. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WebGroup {
    /// Position of each bolt from the centre, `[x, z]`.
    bolts: Vec<[f64; 2]>,
    /// Centre `[x, z]`: x from the splice axis, z from the axis of the actions.
    pub centre: [f64; 2],
}

/// Forces of bolts under the forces of a web \[N\], without signs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BoltForces {
    /// The largest along the member.
    pub along: Formula,
    /// The largest across it.
    pub across: Formula,
    /// The largest resultant, with its components.
    pub resultant: [Formula; 3],
}

impl WebGroup {
    /// The group; `None` with fewer than two bolts, which carry no moment.
    pub fn new(e: &CoverSplice) -> Option<Self> {
        let at = |x: &f64| e.web_rows.iter().map(|z| [*x, *z]).collect::<Vec<_>>();
        let places: Vec<[f64; 2]> = e.web_columns.iter().flat_map(at).collect();
        let count = places.len() as f64;
        let centre = [0, 1].map(|k| places.iter().map(|p| p[k]).sum::<f64>() / count);
        let bolts = places.iter().map(|p| [p[0] - centre[0], p[1] - centre[1]]).collect();
        (places.len() > 1).then_some(Self { bolts, centre })
    }

    /// Σ r² about the centre \[mm²\].
    pub fn polar(&self) -> f64 {
        self.bolts.iter().map(|[x, z]| x * x + z * z).sum()
    }

    /// Forces of the bolts under an axial force at the centre \[N\], tension positive, a shear
    /// force \[N\] without sign, and a moment about the centre \[N mm\], tension at the top
    /// positive. The moment turns the bolts the way of the shear force, on the safe side where the
    /// columns are not symmetric.
    ///
    /// `F_x = N/n + M z/Σr²`, `F_z = V/n + M x/Σr²`.
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.12(1), linear distribution.
    pub fn forces(&self, [axial, shear, moment]: [&Formula; 3]) -> BoltForces {
        let count = || Traced::number("n_b", self.bolts.len() as f64);
        let polar = || Traced::area("Σr²", self.polar());
        let each = self.bolts.iter().map(|[x, z]| {
            let turn = moment.traced() * Traced::length("z", *z) / polar();
            let along = (axial.traced() / count() + turn).abs();
            let turn = moment.traced().abs() * Traced::length("x", x.abs()) / polar();
            let across = shear.traced() / count() + turn;
            let along = Formula::new("F_x,Ed", along, Unit::Force);
            let across = Formula::new("F_z,Ed", across, Unit::Force);
            let both = (along.traced().powi(2) + across.traced().powi(2)).sqrt();
            [along, across, Formula::new("F_v,Ed", both, Unit::Force)]
        });
        let each: Vec<[Formula; 3]> = each.collect();
        let worse = |a, b, k: usize| largest([a, b], |f: &&[Formula; 3]| f[k].value).unwrap_or(a);
        let most = |k: usize| each.iter().skip(1).fold(&each[0], |a, b| worse(a, b, k)).clone();
        let [along, across, resultant] = [0, 1, 2].map(most);
        BoltForces { along: along[0].clone(), across: across[1].clone(), resultant }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formula(value: f64) -> Formula {
        Formula::new("", Traced::from(value), Unit::Force)
    }

    /// By hand: 3 rows at 120 mm and 2 columns at 85 mm, Σr² = 4 · 120² + 6 · 42.5² = 68 437.5.
    #[test]
    fn a_corner_bolt_has_the_vector_sum() {
        let at = |x: f64| [-120.0, 0.0, 120.0].map(|z| [x, z]);
        let bolts = [at(-42.5), at(42.5)].concat();
        let group = WebGroup { bolts, centre: [117.5, 0.0] };
        assert!((group.polar() - 68_437.5).abs() < 1e-9);
        let [n, v, m] = [60e3, 150e3, 50e6].map(formula);
        let forces = group.forces([&n, &v, &m]);
        let x = 10e3 + 50e6 * 120.0 / 68_437.5;
        let z = 25e3 + 50e6 * 42.5 / 68_437.5;
        let got = [&forces.along, &forces.across, &forces.resultant[2]].map(|f| f.value);
        for (got, want) in got.into_iter().zip([x, z, f64::hypot(x, z)]) {
            assert!((got - want).abs() < 1e-6, "{got} is not {want}");
        }
        // N in compression acts on the other corner with the same size
        let [push, back] = [-60e3, -50e6].map(formula);
        assert_eq!(group.forces([&push, &v, &m]).along.value, forces.along.value);
        assert_eq!(group.forces([&n, &v, &back]).along.value, forces.along.value);
    }
}
