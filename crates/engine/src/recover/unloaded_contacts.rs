//! Contacts that no equilibrium can load.
//!
//! Forces z in the cones balance the loads on the rigid motions m that only contact resists,
//! `A z = b` with a row `mᵀGᵀ` for each. A combination c of the motions that no contact resists,
//! `Aᵀc ∈ K`, and on which the loads do no work, `c·b = 0`, gives `z·Aᵀc = 0`, a sum of terms that
//! are not negative: every term is zero. Where c opens a contact, `Aᵀc` inside its cone, the force
//! is therefore zero in every equilibrium (a reduction of the cone to a face). If the loads work on
//! such a motion, `c·b < 0`, there is no equilibrium at all. Both motions are found by a conic
//! program with one unknown per motion; what they say is used only where a certificate confirms it.

use crate::programs::conic::{Cone, ConicProgram, Csr, cone_margin};
use crate::recover::force_sets::Within;
use crate::solve::SolveOptions;
use crate::solve::feasibility;
use bracket_base::math::dense::{Mat, null_space};

/// Opening of a contact over the largest opening from which on it counts as open; the program is
/// solved to 1e-8.
const OPEN: f64 = 1e-5;
/// Largest number of reductions.
const REDUCTIONS: usize = 20;
/// Work below this part of the loads' is rounding.
const ROUNDING: f64 = 1e-11;

/// The motions, as combinations of the given rows.
pub(crate) struct Motions<'a> {
    sets: &'a [Within],
    rows: &'a [Vec<f64>],
    needed: &'a [f64],
    /// Number of rows of contacts and welds; a load factor follows them.
    tractions: usize,
    /// Work that counts as none \[N mm\].
    nothing: f64,
    /// Combinations that strain no weld.
    basis: Vec<Vec<f64>>,
}

impl<'a> Motions<'a> {
    /// `rows`: work of the forces in `sets` on each motion; those from `tractions` on belong to the
    /// load factor. `needed`: work that must be balanced. `pressure`: size of the loads \[MPa\].
    pub fn new(
        sets: &'a [Within],
        rows: &'a [Vec<f64>],
        needed: &'a [f64],
        tractions: usize,
        pressure: f64,
    ) -> Self {
        let reach = rows.iter().map(|r| r[..tractions].iter().map(|x| x.abs()).sum::<f64>());
        let nothing = ROUNDING * pressure * reach.fold(0.0, f64::max);
        let n = rows.len();
        let mut strain = Mat::<f64>::zeros(n, n);
        for set in sets.iter().filter(|s| matches!(s, Within::Ball { .. })) {
            let (start, dim) = set.range();
            for r in start..start + dim {
                for i in 0..n {
                    (0..n).for_each(|j| strain[(i, j)] += rows[i][r] * rows[j][r]);
                }
            }
        }
        Self { sets, rows, needed, tractions, nothing, basis: null_space(&strain, 1e-12) }
    }

    /// The sets whose force is zero in every equilibrium.
    pub fn unloaded(&self) -> Vec<bool> {
        let work = self.work_of_forces(&self.without_work());
        let mut zero = vec![false; self.sets.len()];
        for _ in 0..REDUCTIONS {
            let (mut program, cones) = self.program(&work, &zero);
            // towards the opening of all contacts alike
            let starts = program.cone_starts();
            program.q = vec![0.0; work.len()];
            for r in starts.iter().zip(&cones).filter(|(_, s)| s.is_some()).map(|(r, _)| *r) {
                program.g.row(r).for_each(|(k, a)| program.q[k] -= a);
            }
            let Some(c) = direction(&program) else { break };
            let slack = program.g.mul(&c);
            let largest = slack.iter().fold(0.0f64, |m, s| m.max(s.abs()));
            let mut more = false;
            for ((start, cone), set) in starts.into_iter().zip(&program.cones).zip(cones) {
                let open = cone_margin(&slack[start..start + cone.dim()]) > OPEN * largest;
                if let Some(set) = set.filter(|_| open) {
                    zero[set] = true;
                    more = true;
                }
            }
            if !more {
                break;
            }
        }
        zero
    }

    /// A motion, as a combination of the rows, that no contact resists and on which the loads work;
    /// `None`: none was found.
    pub fn driven(&self) -> Option<Vec<f64>> {
        let work = self.work_of_forces(&self.basis);
        let (mut program, _) = self.program(&work, &vec![false; self.sets.len()]);
        program.q = self.basis.iter().map(|b| self.work(b)).collect();
        if program.q.iter().all(|q| q.abs() <= self.nothing) {
            return None;
        }
        let c = direction(&program)?;
        Some(combined(&self.basis, &c))
    }

    /// Work that is needed on a combination \[N mm\]; negative: the loads drive it.
    fn work(&self, c: &[f64]) -> f64 {
        c.iter().zip(self.needed).map(|(c, b)| c * b).sum()
    }

    /// The combinations on which the loads do no work.
    fn without_work(&self) -> Vec<Vec<f64>> {
        let work: Vec<f64> = self.basis.iter().map(|b| self.work(b)).collect();
        if work.iter().all(|w| w.abs() <= self.nothing) {
            return self.basis.clone();
        }
        let n = work.len();
        let square = Mat::from_fn(n, n, |i, j| work[i] * work[j]);
        null_space(&square, 1e-12).iter().map(|c| combined(&self.basis, c)).collect()
    }

    /// Work of each force on each of the combinations.
    fn work_of_forces(&self, basis: &[Vec<f64>]) -> Vec<Vec<f64>> {
        basis.iter().map(|c| combined(self.rows, c)).collect()
    }

    /// The cones of the forces that are not zero, over combinations on which the forces do the
    /// given work, and the set of each cone; the load factor, whose work must not be negative, has
    /// none.
    fn program(&self, work: &[Vec<f64>], zero: &[bool]) -> (ConicProgram, Vec<Option<usize>>) {
        let mut program = ConicProgram::default();
        program.p.n = work.len();
        program.g.ncols = work.len();
        let mut cones = Vec::new();
        let mut blocks: Vec<Vec<Vec<f64>>> = Vec::new();
        for (i, set) in self.sets.iter().enumerate().filter(|(i, _)| !zero[*i]) {
            let Within::Cone { start, dim, .. } = *set else { continue };
            let factor = start >= self.tractions;
            let rows: Vec<Vec<f64>> =
                (start..start + dim).map(|r| work.iter().map(|w| w[r]).collect()).collect();
            if factor && rows.iter().flatten().all(|a| a.abs() <= self.nothing) {
                continue;
            }
            blocks.push(rows);
            program.cones.push(if dim == 1 { Cone::NonNegative } else { Cone::SecondOrder(dim) });
            cones.push((!factor).then_some(i));
        }
        // all contacts by one factor, and the load factor by its own
        let largest = |contacts: bool| {
            let of = blocks.iter().zip(&cones).filter(|(_, set)| set.is_some() == contacts);
            of.flat_map(|(b, _)| b.iter().flatten()).fold(0.0f64, |m, a| m.max(a.abs()))
        };
        let scale = [largest(false), largest(true)].map(|m| if m > 0.0 { 1.0 / m } else { 1.0 });
        for (rows, set) in blocks.iter().zip(&cones) {
            rows.iter().for_each(|r| push(&mut program.g, r, scale[usize::from(set.is_some())]));
        }
        program.h = vec![0.0; program.g.nrows()];
        (program, cones)
    }
}

fn push(g: &mut Csr, row: &[f64], scale: f64) {
    let entries: Vec<(u32, f64)> =
        row.iter().enumerate().map(|(c, a)| (c as u32, scale * a)).collect();
    g.push_row(&entries);
}

/// The nearest point to −q of the combinations in the cones; `None` where it is zero.
fn direction(program: &ConicProgram) -> Option<Vec<f64>> {
    if program.cones.is_empty() {
        return None;
    }
    let n = program.p.n;
    let unit: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    feasibility::direction(program, &unit, &SolveOptions::default())
}

fn combined(basis: &[Vec<f64>], c: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; basis.first().map_or(0, Vec::len)];
    for (b, c) in basis.iter().zip(c) {
        sum.iter_mut().zip(b).for_each(|(s, b)| *s += c * b);
    }
    sum
}
