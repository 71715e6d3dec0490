//! Scales that make a program's numbers dimensionless before a solver sees them.

use crate::model::program::{ConicProgram, SymmetricCsc};

/// Scales of a program: `x_i = size·columns_i·x̂_i`, `z = size·rows·ẑ`.
pub struct Scales {
    /// Scale of each unknown.
    columns: Vec<f64>,
    /// Size of the answer.
    size: f64,
    /// Scale of each row.
    rows: Vec<f64>,
}

impl Scales {
    /// Chooses the scales.
    pub fn new(program: &ConicProgram) -> Self {
        // every unknown is measured in the give of its own stiffness: soft parts on hard ones are no trouble
        let stiffness = stiffness(program);
        let least = least(program, &stiffness);
        let columns: Vec<f64> = stiffness.iter().zip(least).map(|(d, l)| d.max(l).sqrt().recip()).collect();
        let load = program.q.iter().zip(&columns).fold(0.0f64, |m, (q, c)| m.max((q * c).abs()));
        let mut rows = vec![1.0; program.h.len()];
        for (start, cone) in program.cone_starts().into_iter().zip(&program.cones) {
            let range = start..start + cone.dim();
            let largest = range
                .clone()
                .flat_map(|r| program.g.row(r))
                .map(|(c, v)| (v * columns[c]).abs())
                .fold(0.0f64, f64::max);
            rows[range].fill(if largest > 0.0 { 1.0 / largest } else { 1.0 });
        }
        let offset = program.h.iter().zip(&rows).map(|(h, s)| (h * s).abs()).fold(0.0f64, f64::max);
        // the scaled loads are 1, or the largest gap is when nothing is loaded
        let size = if load > 0.0 {
            load
        } else if offset > 0.0 {
            offset
        } else {
            1.0
        };
        Self { columns, size, rows }
    }

    /// The scaled program: unit stiffness of every unknown, unit largest load, unit largest entry in the rows of each cone.
    pub fn apply(&self, program: &ConicProgram) -> ConicProgram {
        let mut p = program.p.clone();
        for c in 0..p.n {
            for k in p.col_ptr[c]..p.col_ptr[c + 1] {
                p.values[k] *= self.columns[c] * self.columns[p.row_idx[k] as usize];
            }
        }
        let mut g = program.g.clone();
        for r in 0..program.h.len() {
            for k in g.row_ptr[r]..g.row_ptr[r + 1] {
                g.values[k] *= self.rows[r] * self.columns[g.col_idx[k]];
            }
        }
        ConicProgram {
            p,
            q: program.q.iter().zip(&self.columns).map(|(v, c)| v * c / self.size).collect(),
            c: 0.0,
            g,
            h: program.h.iter().zip(&self.rows).map(|(h, r)| h * r / self.size).collect(),
            cones: program.cones.clone(),
            stage: program.stage.clone(),
            maximised: program.maximised.clone(),
        }
    }

    /// Unknowns in the program's units.
    pub fn unscale_x(&self, x: &[f64]) -> Vec<f64> {
        x.iter().zip(&self.columns).map(|(x, c)| x * c * self.size).collect()
    }

    /// Multipliers in the program's units.
    pub fn unscale_z(&self, z: &[f64]) -> Vec<f64> {
        z.iter().zip(&self.rows).map(|(z, r)| z * r * self.size).collect()
    }
}

/// Stiffness that measures each unknown: its diagonal entry, and what the unknowns maximised over that it meets add when
/// they are eliminated one by one (`Σ_j E_ji² / F_jj`).
///
/// The unknowns of a cone that is eliminated with its element share one measure, the stiffest: the bound of a norm has
/// no stiffness of its own, and one scale leaves its cone a cone with unit rows.
fn stiffness(program: &ConicProgram) -> Vec<f64> {
    let p = &program.p;
    let mut d = p.diagonal();
    if program.stage.is_empty() && program.maximised.is_empty() {
        return d;
    }
    d.iter_mut().enumerate().filter(|(i, _)| program.is_maximised(*i)).for_each(|(_, d)| *d = d.abs());
    let more = met(p, &d, |own, other| !program.is_maximised(own) && program.is_maximised(other));
    d.iter_mut().zip(&more).for_each(|(d, m)| *d += m);
    // multipliers without a term of their own are measured by what they hold
    let held = met(p, &d, |own, other| program.is_maximised(own) && !program.is_maximised(other));
    d.iter_mut().zip(&held).filter(|(d, _)| **d == 0.0).for_each(|(d, h)| *d = *h);
    for (start, cone) in program.cone_starts().into_iter().zip(&program.cones) {
        let unknowns: Vec<usize> = (start..start + cone.dim()).flat_map(|r| program.g.row(r).map(|(c, _)| c)).collect();
        if unknowns.iter().all(|&i| program.stage_of(i) > 0) {
            let stiffest = unknowns.iter().map(|&i| d[i]).fold(0.0, f64::max);
            unknowns.iter().for_each(|&i| d[i] = stiffest);
        }
    }
    d
}

/// `Σ_j P_ij² / d_j` of each unknown i, over the j it meets that `counts(i, j)`.
fn met(p: &SymmetricCsc, d: &[f64], counts: impl Fn(usize, usize) -> bool) -> Vec<f64> {
    let mut sum = vec![0.0; p.n];
    for c in 0..p.n {
        for k in p.col_ptr[c]..p.col_ptr[c + 1] {
            let (r, v) = (p.row_idx[k] as usize, p.values[k]);
            if d[c] > 0.0 && counts(r, c) {
                sum[r] += v * v / d[c];
            }
            if d[r] > 0.0 && r != c && counts(c, r) {
                sum[c] += v * v / d[r];
            }
        }
    }
    sum
}

/// Smallest stiffness each unknown is taken to have: a part of the mean of its own kind, for kinds have different units.
fn least(program: &ConicProgram, stiffness: &[f64]) -> Vec<f64> {
    let kind = |i: usize| (program.stage_of(i), program.is_maximised(i));
    let mut kinds: std::collections::BTreeMap<(u8, bool), (f64, usize)> = Default::default();
    for (i, d) in stiffness.iter().enumerate() {
        let of = kinds.entry(kind(i)).or_default();
        *of = (of.0 + d, of.1 + 1);
    }
    let staged = !program.stage.is_empty() || !program.maximised.is_empty();
    let least = |(sum, count): &(f64, usize)| match *sum == 0.0 && staged {
        true => 1.0,
        false => 1e-14 * (sum / *count as f64).max(f64::MIN_POSITIVE),
    };
    (0..stiffness.len()).map(|i| kinds.get(&kind(i)).map_or(0.0, least)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::program::{Cone, Csr};

    fn diagonal(values: &[f64]) -> SymmetricCsc {
        let n = values.len();
        SymmetricCsc { n, col_ptr: (0..=n).collect(), row_idx: (0..n as u32).collect(), values: values.to_vec() }
    }

    /// One stage, nothing maximised: the diagonal alone, as small as 1e-14 of its mean.
    #[test]
    fn plain_programs_are_measured_by_their_diagonal() {
        let values = [4.0, 1e6, 0.0, 25.0];
        let program = ConicProgram { p: diagonal(&values), q: vec![1.0; 4], ..ConicProgram::default() };
        let mean = (4.0 + 1e6 + 0.0 + 25.0) / 4.0;
        let want = values.map(|d| 1.0 / f64::sqrt(d.max(1e-14 * mean)));
        assert_eq!(Scales::new(&program).columns, want);
    }

    /// x₀ is shared, (x₁, x₂) a cone of the element's, y₃ maximised with E = [3 0 2], F = 4: x₀ is measured by
    /// 1 + 9/4, both unknowns of the cone by 4/4, y by 4; the scaled cone has unit rows.
    #[test]
    fn cones_and_multipliers_have_a_measure() {
        let p = SymmetricCsc {
            n: 4,
            col_ptr: vec![0, 1, 2, 3, 6],
            row_idx: vec![0, 1, 2, 0, 2, 3],
            values: vec![1.0, 0.0, 0.0, 3.0, 2.0, -4.0],
        };
        let mut g = Csr { ncols: 4, ..Csr::default() };
        g.push_row(&[(1, 1.0)]);
        g.push_row(&[(2, 1.0)]);
        let program = ConicProgram {
            p,
            q: vec![0.0, 1.0, 0.0, 0.0],
            g,
            h: vec![0.0; 2],
            cones: vec![Cone::SecondOrder(2)],
            stage: vec![0, 2, 2, 1],
            maximised: vec![false, false, false, true],
            ..ConicProgram::default()
        };
        let scales = Scales::new(&program);
        let want = [3.25f64.sqrt().recip(), 1.0, 1.0, 0.5];
        assert!(scales.columns.iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-15), "{:?}", scales.columns);
        assert_eq!(scales.apply(&program).g.values, [1.0, 1.0]);
    }
}
