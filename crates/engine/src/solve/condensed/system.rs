//! The condensed matrix `P + Gᵀ W⁻² G` of every iteration: one fixed pattern, one ordering, one
//! symbolic factor.
//!
//! Elements that yield are eliminated one by one ([`super::elements`]); only shared unknowns reach
//! the sparse factor. Every entry has its place in the storage of the factor, so that no second
//! matrix is assembled.

use super::cones::{Cones, Scaling};
use super::elements::{ElementSystem, UNSCALED, union};
use super::scaled_program::ScaledProgram;
use super::vectors::{dot, vector};
use super::yield_points::SCALING;
use crate::elements::yielding_element::YIELD_ROWS;
use crate::programs::conic::ConicProgram;
use crate::solve::condensed::static_condensation::Side;
use crate::solve::forecast::Forecast;
use crate::solve::sparse::{LinearError, Patterns, SparseCholesky};

/// Proximal term of the static program's elements, relative to the median and to the mean of their
/// own stiffness. With 1e-8 of the median, forces of joints with contact are lost in rounding and
/// the iteration does not end; 1e-6 to 1e-4 need about the same number of iterations.
const PROXIMAL: (f64, f64) = (1e-6, 1e-12);
/// The same for the kinematic program, whose pressures have no other term. On the paper's joint
/// 1e-6 of the median needs a refinement for nearly every solve, 1e-5 for one in three (10.8 s for
/// 15.5 s). With 1e-4 (8.7 s) the upper bound of a strip with a hinge stops 0.8 % high.
const PROXIMAL_FLOW: (f64, f64) = (1e-5, 1e-12);
/// Increase of the term for a second attempt.
const RAISED: f64 = 10.0;

/// Columns of the rows of one cone and the places of its products.
struct ConeMap {
    /// Distinct columns of the cone's rows.
    columns: Vec<u32>,
    /// Its rows as a dense block, `rows × columns`.
    rows: Vec<f64>,
    /// Place of entry (i ≤ j by column), packed by columns.
    places: Vec<u32>,
}

/// The matrix, its factor and its fixed data.
pub struct CondensedSystem {
    /// Place of each entry of P.
    place: Vec<u32>,
    cones: Vec<ConeMap>,
    elements: ElementSystem,
    factor: SparseCholesky,
    border: Option<Border>,
}

/// One solution of Newton's system.
#[derive(Default)]
pub struct Solved {
    /// Unknowns.
    pub x: Vec<f64>,
    /// Multipliers.
    pub z: Vec<f64>,
    /// Errors of the stationarity rows; empty unless requested.
    pub error: Vec<f64>,
}

/// The load factor: a dense row, kept out of the sparse factor by its Schur complement.
struct Border {
    /// `K⁻¹ f` of the live loads f.
    solution: Vec<f64>,
    /// `fᵀ K⁻¹ f`.
    compliance: f64,
}

impl CondensedSystem {
    /// Lays out the pattern, the elimination and the symbolic factor of a scaled program.
    ///
    /// `block` gives the block of each shared unknown.
    pub fn new(
        program: &ConicProgram,
        cones: &Cones,
        block: &[u32],
        patterns: &Patterns,
    ) -> Result<Self, LinearError> {
        let (p, g) = (&program.p, &program.g);
        let contacts = &cones.blocks[..cones.blocks.partition_point(|b| b.0 < g.nrows())];
        let columns: Vec<Vec<u32>> = contacts
            .iter()
            .map(|&(s, d)| {
                let mut c: Vec<u32> =
                    (s..s + d).flat_map(|r| g.row(r).map(|(c, _)| c as u32)).collect();
                c.sort_unstable();
                c.dedup();
                c
            })
            .collect();
        let elements = ElementSystem::new(program);
        let factor = SparseCholesky::symbolic(&union(p, &columns, &elements), block, patterns)?;
        let mut system =
            Self { place: Vec::new(), cones: Vec::new(), elements, factor, border: None };
        let mut locator = system.factor.locator();
        system.elements.locate(&mut locator);
        let mut place = |i: u32, j: u32| locator.place(i, j);
        let mut places = Vec::with_capacity(p.values.len());
        for c in 0..p.n {
            places.extend(
                p.row_idx[p.col_ptr[c]..p.col_ptr[c + 1]].iter().map(|&r| place(r, c as u32)),
            );
        }
        let cones = columns.into_iter().zip(contacts).map(|(columns, &(s, d))| {
            let m = columns.len();
            let mut rows = vec![0.0; d * m];
            for r in 0..d {
                for (c, v) in g.row(s + r) {
                    if let Ok(k) = columns.binary_search(&(c as u32)) {
                        rows[r * m + k] += v;
                    }
                }
            }
            let places = (0..m)
                .flat_map(|j| (0..=j).map(move |i| (i, j)))
                .map(|(i, j)| place(columns[i], columns[j]));
            let places = places.collect();
            ConeMap { columns, rows, places }
        });
        let cones: Vec<ConeMap> = cones.collect();
        (system.place, system.cones) = (places, cones);
        Ok(system)
    }

    /// Forecast of a solve of the program with this system.
    pub fn forecast(&self, program: &ConicProgram) -> Forecast {
        let (entries, flops) =
            (self.factor.nonzeros(), self.factor.flops() + self.elements.flops());
        let cones: usize = self
            .cones
            .iter()
            .map(|c| 4 * c.columns.len() + 8 * c.rows.len() + 4 * c.places.len())
            .sum();
        // the iterates, directions and right-hand sides of the method
        let vectors = 8
            * (30 * program.shared()
                + 15 * (program.unknowns() - program.shared())
                + 20 * program.h.len());
        let bytes =
            self.factor.bytes() + self.elements.bytes() + 16 * self.place.len() + cones + vectors;
        let yielding = program.h.len() - program.g.nrows();
        let limit = !program.live.is_empty();
        Forecast {
            unknowns: self.factor.unknowns(),
            factor_entries: entries,
            factor_flops: flops,
            bytes: bytes as u64,
            seconds: Forecast::all_iterations(flops, entries, [program.g.nrows(), yielding], limit),
        }
    }

    /// Operations of a factorisation for each nonzero of the factor.
    pub fn flops_per_entry(&self) -> f64 {
        self.factor.flops() / self.factor.nonzeros().max(1) as f64
    }

    /// Errors of the stationarity rows of a solution: `r₁ − P x + Gᵀ z`, with the proximal terms of
    /// the factor.
    pub fn stationarity_error(
        &self,
        problem: &ScaledProgram,
        r1: &[f64],
        x: &[f64],
        z: &[f64],
    ) -> Vec<f64> {
        let program = &problem.program;
        let [px] = program.quadratic([x]);
        let gz = program.rows_transposed(z);
        let mut error = vector(r1.len(), |i| r1[i] - px[i] + gz[i]);
        if self.elements.proximal > 0.0 {
            let factor = program.unknowns() - usize::from(!program.live.is_empty());
            for i in (program.shared()..factor).filter(|&i| problem.maximised[i]) {
                error[i] += self.elements.proximal * x[i];
            }
        }
        error
    }

    /// Factors the matrix with unit scaling, for the starting point.
    pub fn factor_start(&mut self, problem: &ScaledProgram) -> Result<(), LinearError> {
        let unit = |k: usize, w: &mut [[f64; 6]; 6]| {
            (0..problem.cones.blocks[k].1).for_each(|i| w[i][i] = 1.0)
        };
        let points = |_| UNSCALED;
        self.choose_proximal(problem, &points);
        self.refactor(problem, unit, points, 0.0)
    }

    /// Factors `P + Gᵀ W⁻² G`, its diagonal raised by the fraction `raise`.
    pub fn factor(
        &mut self,
        problem: &ScaledProgram,
        scaling: &Scaling,
        raise: f64,
    ) -> Result<(), LinearError> {
        let cones = &problem.cones;
        let first = self.cones.len();
        let start = problem.program.g.nrows();
        let points = |row: usize| scaling.of_point(cones, first + (row - start) / YIELD_ROWS);
        self.refactor(problem, |k, w| scaling.inverse_square(cones, k, w), points, raise)
    }

    /// Chooses the proximal term of rigid-plastic elements, once.
    fn choose_proximal(
        &mut self,
        problem: &ScaledProgram,
        points: &(impl Fn(usize) -> [f64; SCALING] + Sync),
    ) {
        if !problem.program.live.is_empty() && self.elements.proximal == 0.0 {
            let (median, mean) = self.elements.own_stiffness(points);
            let (of_median, of_mean) =
                if self.elements.have_pressures() { PROXIMAL_FLOW } else { PROXIMAL };
            self.elements.proximal = (of_median * median).max(of_mean * mean);
        }
    }

    /// Raises the proximal term after a numerical error; false where there is none.
    pub fn raise_proximal(&mut self) -> bool {
        self.elements.proximal *= RAISED;
        self.elements.proximal > 0.0
    }

    fn refactor(
        &mut self,
        problem: &ScaledProgram,
        inverse_square: impl Fn(usize, &mut [[f64; 6]; 6]),
        points: impl Fn(usize) -> [f64; SCALING] + Sync,
        raise: f64,
    ) -> Result<(), LinearError> {
        let Self { place, cones, elements, factor, .. } = self;
        let p = &problem.program.p;
        let values = factor.clear()?;
        place.iter().zip(&p.values).for_each(|(&at, &v)| values[at as usize] += v);
        for (k, cone) in cones.iter().enumerate() {
            let mut w = [[0.0; 6]; 6];
            inverse_square(k, &mut w);
            let m = cone.columns.len();
            let d = cone.rows.len() / m.max(1);
            let mut at = 0;
            for j in 0..m {
                let mut wj = [0.0; 6];
                for r in 0..d {
                    wj[r] = (0..d).map(|q| w[r][q] * cone.rows[q * m + j]).sum();
                }
                for i in 0..=j {
                    values[cone.places[at] as usize] +=
                        (0..d).map(|r| cone.rows[r * m + i] * wj[r]).sum::<f64>();
                    at += 1;
                }
            }
        }
        elements.eliminate(points, values)?;
        if raise > 0.0 {
            (0..p.n).for_each(|c| values[place[p.col_ptr[c + 1] - 1] as usize] *= 1.0 + raise);
        }
        factor.factor()?;
        let live = &problem.program.live;
        self.border = (!live.is_empty()).then(|| {
            let [solution] = self.factor.solve_all([live]);
            let compliance = dot(live, &solution);
            Border { solution, compliance }
        });
        Ok(())
    }

    /// Solves `P dx − Gᵀ dz = r₁`, `−G dx − W² dz = r₂` for a few right-hand sides, without
    /// refinement; with CHECK the errors of r₁ are returned. W must be that of the factor.
    pub fn solve<const SIDES: usize, const CHECK: bool>(
        &self,
        problem: &ScaledProgram,
        scaling: &Scaling,
        rhs: [Side<'_>; SIDES],
    ) -> [Solved; SIDES] {
        let (program, cones) = (&problem.program, &problem.cones);
        let (n, contacts) = (program.shared(), program.g.nrows());
        let mut full = rhs.map(|(r1, r2)| {
            let mut full = r1.to_vec();
            let g = program.g.mul_transpose(&scaling.apply_inverse_twice(cones, &r2[..contacts]));
            full.iter_mut().zip(&g).for_each(|(f, g)| *f -= g);
            full
        });
        self.elements.condense(rhs, &mut full);
        let shared = self.factor.solve_all(full.each_ref().map(|f| &f[..n]));
        for (mut x, full) in shared.into_iter().zip(&mut full) {
            if let (Some(border), Some(last)) = (&self.border, full.last_mut()) {
                // K v − f λ = r and −fᵀ v = r_λ
                let factor = -(*last + dot(&program.live, &x)) / border.compliance;
                x.iter_mut().zip(&border.solution).for_each(|(x, y)| *x += factor * y);
                *last = factor;
            }
            full[..n].copy_from_slice(&x);
        }
        let mut z: [Vec<f64>; SIDES] = std::array::from_fn(|k| {
            let r2 = rhs[k].1;
            let v: Vec<f64> = program.g.mul(&full[k]).iter().zip(r2).map(|(g, r)| -g - r).collect();
            let mut z = scaling.apply_inverse_twice(cones, &v);
            z.resize(r2.len(), 0.0);
            z
        });
        let mut errors = [const { Vec::new() }; SIDES];
        if CHECK {
            let px = program.p.mul_all(full.each_ref().map(|f| &f[..n]));
            for k in 0..SIDES {
                let gz = program.g.mul_transpose(&z[k][..contacts]);
                let mut error = rhs[k].0.to_vec();
                error.iter_mut().zip(&px[k]).for_each(|(e, p)| *e -= p);
                error.iter_mut().zip(&gz).for_each(|(e, g)| *e += g);
                if let (Some(&factor), Some(last), false) =
                    (full[k].last(), error.last_mut(), program.live.is_empty())
                {
                    *last += dot(&program.live, &full[k][..n]);
                    error.iter_mut().zip(&program.live).for_each(|(e, f)| *e += factor * f);
                }
                errors[k] = error;
            }
        }
        self.elements.expand::<SIDES, CHECK>(rhs, &mut full, &mut z, &mut errors);
        let mut parts = full.into_iter().zip(z).zip(errors);
        std::array::from_fn(|_| match parts.next() {
            Some(((x, z), error)) => Solved { x, z, error },
            None => Solved::default(),
        })
    }
}
