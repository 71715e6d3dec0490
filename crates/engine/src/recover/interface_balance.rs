//! Tractions of contacts and welds in balance with the loads, near those of a solver.
//!
//! The balance of [`force_sets`](crate::recover::force_sets) moves forces within the insides of
//! their cones. Where a contact carries nothing, the only admissible force is zero, on the boundary
//! of its cone, and the solver leaves a small positive one there: no balance inside the cones
//! exists. Such forces are set to zero, found by their size (a ladder of cut-offs, the smallest
//! with which a balance is found) or by the motions that the contacts permit
//! (`unloaded_contacts`). Whatever is dropped, the certificate of the field decides.

use crate::recover::force_sets::{Within, balance};
use crate::recover::unloaded_contacts::Motions;
use bracket_base::math::Sum;

/// Pressure over the largest one below which it may be noise of the solver.
const NOISE: f64 = 1e-7;
/// Further cut-offs, over the largest of the loads and of the forces. Where both pressure and gap
/// vanish, a solver with a relative gap of 1e-8 leaves about 1e-4.
const CUT_OFFS: [f64; 7] = [1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3];
/// Work left open that counts as rounding, over the work of the forces and of the loads' size.
const ROUNDING: f64 = 1e-12;
/// Work left open of a rough balance, over what is balanced: the elastic corrections that follow
/// take it up, or the certificate refuses the field.
const ROUGH: f64 = 1e-6;

/// Forces in sets, and the work that they must do.
pub(crate) struct InterfaceBalance<'a> {
    /// The sets of the tractions.
    pub sets: &'a [Within],
    /// Work of the tractions on each motion; in limit analysis with one more entry for the load
    /// factor.
    pub rows: &'a [Vec<f64>],
    /// Work needed on each motion \[N mm\].
    pub needed: &'a [f64],
    /// Margins in cones and balls, relative to the pressure and to the strength; the first with
    /// which a balance is found is used.
    pub margins: &'a [f64],
    /// The [`absolute_work`] of the loads on each motion.
    pub terms: &'a [f64],
    /// Size of the loads \[MPa\].
    pub pressure: f64,
}

/// Tractions and load factor.
pub(crate) type Forces = (Vec<f64>, Option<f64>);

/// Why no balance was found.
pub(crate) struct NoBalance {
    /// The forces of the first attempt, some of them outside their sets.
    pub nearest: Option<Forces>,
    /// A combination of the motions that the loads drive and that no contact resists; `None`: a
    /// balance may exist.
    pub driven: Option<Vec<f64>>,
}

/// The attempts so far.
#[derive(Default)]
struct Attempts {
    /// The first one inside the sets whose balance is rough.
    rough: Option<Forces>,
    /// The first one outside.
    outside: Option<Forces>,
}

impl InterfaceBalance<'_> {
    /// Balanced tractions near `found`, and the load factor of the balance near `factor`.
    pub fn find(&self, found: &[f64], factor: Option<f64>) -> Result<Forces, NoBalance> {
        let mut attempts = Attempts::default();
        let all = vec![false; self.sets.len()];
        if let Some(forces) = self.by_size(&all, found, factor, &mut attempts) {
            return Ok(forces);
        }
        let mut sets = self.sets.to_vec();
        sets.extend(factor.map(|_| factor_set(found.len())));
        let motions = Motions::new(&sets, self.rows, self.needed, found.len(), self.pressure);
        let zero = motions.unloaded();
        if zero.contains(&true)
            && let Some(forces) = self.by_size(&zero, found, factor, &mut attempts)
        {
            return Ok(forces);
        }
        match attempts {
            Attempts { rough: Some(forces), .. } => Ok(forces),
            Attempts { outside, .. } => {
                Err(NoBalance { nearest: outside, driven: motions.driven() })
            }
        }
    }

    /// A balance without the forces of the sets `zero`, with the smallest cut-off that permits one.
    fn by_size(
        &self,
        zero: &[bool],
        found: &[f64],
        factor: Option<f64>,
        attempts: &mut Attempts,
    ) -> Option<Forces> {
        let largest = found.iter().fold(0.0f64, |m, z| m.max(z.abs()));
        let usual = self.margins.iter().flat_map(|m| [0.0, NOISE * largest].map(|l| (*m, l)));
        let size = largest.max(self.pressure);
        let first = self.margins.first().copied().unwrap_or(0.0);
        let ladder = CUT_OFFS.iter().map(|part| (first, part * size));
        usual.chain(ladder).find_map(|(margin, least)| {
            let z = self.inside(found, zero, margin, least);
            self.attempt(z, factor, attempts)
        })
    }

    /// The nearest forces inside the sets with a margin. Those of the sets `zero`, and those with
    /// less pressure than `least`, become zero.
    fn inside(&self, found: &[f64], zero: &[bool], margin: f64, least: f64) -> Vec<f64> {
        let mut z = found.to_vec();
        for (set, zero) in self.sets.iter().zip(zero) {
            if let Within::Cone { start, dim, .. } = *set {
                let force = &mut z[start..start + dim];
                if *zero || (least > 0.0 && force[0] < least) {
                    force.fill(0.0);
                }
            }
            set.move_in(&mut z, margin);
        }
        z
    }

    /// Balances the forces; `None` where one of them leaves its set or the balance is rough.
    fn attempt(
        &self,
        mut z: Vec<f64>,
        factor: Option<f64>,
        attempts: &mut Attempts,
    ) -> Option<Forces> {
        let mut sets = self.sets.to_vec();
        // the load factor is one more force, on a half-line
        sets.extend(factor.map(|_| factor_set(z.len())));
        z.extend(factor);
        let inside = balance(&sets, self.rows, self.needed, &mut z);
        let balanced = |part: f64| inside && self.is_balanced(&z, part);
        let (balanced, rough) = (balanced(ROUNDING), balanced(ROUGH));
        let factor = factor.and_then(|_| z.pop());
        if balanced {
            return Some((z, factor));
        }
        let kept = if rough { &mut attempts.rough } else { &mut attempts.outside };
        if kept.is_none() && factor.is_none_or(f64::is_finite) {
            *kept = Some((z, factor));
        }
        None
    }

    /// True when the work left open is at most this part of what is balanced.
    fn is_balanced(&self, z: &[f64], part: f64) -> bool {
        self.rows.iter().zip(self.needed).zip(self.terms).all(|((row, needed), of_loads)| {
            let terms = || row.iter().zip(z).map(|(a, z)| a * z);
            let open = Sum::of(terms().chain([-needed]));
            let size = terms().map(f64::abs).sum::<f64>() + of_loads;
            let loads = self.pressure * row.iter().map(|a| a.abs()).sum::<f64>();
            open.abs() <= part * (size + loads)
        })
    }
}

/// Sum of the absolute terms of a work \[N mm\]: the size that its rounding is measured against.
pub(crate) fn absolute_work(motion: &[f64], forces: &[f64]) -> f64 {
    motion.iter().zip(forces).map(|(a, b)| (a * b).abs()).sum()
}

fn factor_set(start: usize) -> Within {
    Within::Cone { start, dim: 1, most: f64::INFINITY }
}

#[cfg(test)]
mod tests;
