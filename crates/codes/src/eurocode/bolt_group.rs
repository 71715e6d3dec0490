//! Elastic distribution of a force and a moment in the plane of a bolt group.

use crate::check::largest;
use crate::formula::{Formula, Number, Traced};
use crate::unit::Unit;

/// Bolts of a rectangular pattern in one plane.
#[derive(Clone, Debug, PartialEq)]
pub struct BoltGroup {
    /// x and z of the bolts from the centre of the group \[mm\].
    bolts: Vec<[f64; 2]>,
}

/// Forces on the most loaded bolt, with their formulas.
#[derive(Clone, Debug, PartialEq)]
pub struct BoltForce {
    /// F_x, along the beam, either sign \[N\].
    pub along: Formula,
    /// F_z, upwards, either sign \[N\].
    pub upwards: Formula,
}

/// A component of the force on a bolt, `F/n ± M c/I_p`; `lever` c is its distance from the centre
/// across the component, `polar` I_p = Σ(x² + z²).
///
/// # Source
/// EN 1993-1-8:2005 3.12(1): elastic linear distribution.
pub fn component<N: Number>(force: N, count: N, moment: N, lever: N, polar: N) -> N {
    force / count + moment * lever / polar
}

impl BoltGroup {
    /// The bolts at every x of `columns` and every z of `rows` \[mm\].
    pub fn new(columns: &[f64], rows: &[f64]) -> Self {
        let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len().max(1) as f64;
        let [x, z] = [mean(columns), mean(rows)];
        let row = |&at: &f64| columns.iter().map(move |&c| [c - x, at - z]);
        Self { bolts: rows.iter().flat_map(row).collect() }
    }

    /// How many there are.
    pub fn count(&self) -> f64 {
        self.bolts.len() as f64
    }

    /// I_p = Σ(x² + z²) \[mm²\].
    pub fn polar(&self) -> f64 {
        self.bolts.iter().map(|[x, z]| x * x + z * z).sum()
    }

    /// Extent of the group in the direction of a force `[x, z]`, between its end bolts \[mm\].
    pub fn extent(&self, [fx, fz]: [f64; 2]) -> f64 {
        let size = fx.hypot(fz);
        let spread = |k: usize| {
            let of = || self.bolts.iter().map(|b| b[k]);
            of().fold(0.0, f64::max) - of().fold(0.0, f64::min)
        };
        match size > 0.0 {
            true => (fx.abs() * spread(0) + fz.abs() * spread(1)) / size,
            false => spread(1),
        }
    }

    /// The forces on the bolt for which `measure` of `[F_x, F_z]` \[N\] is largest, the first of
    /// equal ones: under N along the beam and V upwards through the centre \[N\], and a moment that
    /// pulls at the top \[N mm\].
    ///
    /// `F_x = N/n + M z/I_p` and `F_z = V/n − M x/I_p`. One bolt alone carries no moment: its
    /// forces are then no numbers.
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.12(1).
    pub fn most_loaded(
        &self,
        [n, v, m]: [f64; 3],
        measure: impl Fn([f64; 2]) -> f64,
    ) -> Option<BoltForce> {
        let of = |b: &[f64; 2]| self.on_bolt([n, v, m], *b).map(|f| f.value());
        if !self.polar().is_normal() && m != 0.0 {
            let [along, upwards] = self.on_bolt([f64::NAN, f64::NAN, m], [0.0, 0.0]);
            return Some(BoltForce::new(along, upwards));
        }
        let worst = largest(&self.bolts, |b| measure(of(b)))?;
        let [along, upwards] = self.on_bolt([n, v, m], *worst);
        Some(BoltForce::new(along, upwards))
    }

    /// F_x and F_z of the bolt at `[x, z]` from the centre.
    fn on_bolt(&self, [n, v, m]: [f64; 3], [x, z]: [f64; 2]) -> [Traced; 2] {
        let count = || Traced::number("n", self.count());
        let one = |name: &'static str, force: f64, lever: (&'static str, f64)| {
            let force = Traced::force(name, force);
            if m == 0.0 || lever.1 == 0.0 {
                return force / count();
            }
            let moment = Traced::symbol("M", m, Unit::Moment);
            let polar = Traced::area("I_p", self.polar());
            component(force, count(), moment, Traced::length(lever.0, lever.1), polar)
        };
        [one("N", n, ("z", z)), one("V", v, ("-x", -x))]
    }
}

impl BoltForce {
    fn new(along: Traced, upwards: Traced) -> Self {
        Self {
            along: Formula::new("F_x", along, Unit::Force),
            upwards: Formula::new("F_z", upwards, Unit::Force),
        }
    }

    /// F_v,Ed, the resultant \[N\].
    pub fn resultant(&self) -> Formula {
        let sum = self.along.traced().powi(2) + self.upwards.traced().powi(2);
        Formula::new("F_v,Ed", sum.sqrt(), Unit::Force)
    }
}
