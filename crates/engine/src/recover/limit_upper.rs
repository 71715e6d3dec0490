//! Projection of approximate velocities to a strict upper bound of the load factor.
//!
//! The projection adds the change d of least elastic energy after which velocities keep the volume
//! of all bodies that yield and leave rigid bodies without strain: `min ½ dᵀK̃ d` with
//! `C (u + d) = 0`. K̃ is the elastic stiffness, with springs across contacts and welds and along
//! slip faces and ties; C holds the weighted equations: one volume row per split element, four
//! per plain one, the strain of rigid bodies. With `S = K̃ + γ CᵀC` (augmented Lagrangian) the
//! multipliers y solve `C S⁻¹Cᵀ y = C u`. That matrix is nearly a multiple of the identity, so that
//! conjugate gradients need few steps; `d = −S⁻¹Cᵀ y`. The same system opens contacts that remain
//! violated, by flows that keep the volume.

use crate::certify::fields::DisplacementField;
use crate::certify::limit_certificate::{UpperCertificate, certify_upper};
use crate::certify::load_factor::UpperFactor;
use crate::certify::velocity_field::VelocityField;
use crate::elements::hencky_kinematic::Flow;
use crate::elements::{split_flow, tet10};
use crate::model::loads::Loads;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::Kinematic;
use crate::programs::assemble::assemble;
use crate::programs::conic::cone_margin;
use crate::programs::rigid_motions::nearest_unknowns;
use crate::recover::elastic::{RecoverError, plus_rows};
use crate::recover::force_sets::{cone_ranges, into_cone};
use crate::solve::sparse::{Patterns, SparseCholesky};
use bracket_base::display_text;
use bracket_base::math::Sum;
use bracket_base::math::mandel::Mandel;
use bracket_base::say;
use bracket_base::words::Text;
use rayon::prelude::*;

/// Weight γ of the equations against the stiffness.
const AUGMENTED: f64 = 1e6;
/// Weight of the springs across contacts and welds and along slip faces and ties, in mean diagonal
/// entries of the stiffness.
const SPRING: f64 = 1e4;
/// Stiffness against the motion of a rigid body, relative to its own elastic stiffness: small but
/// not zero.
const RIGID_MOTION: f64 = 1e-6;
/// Margin in contact cones, relative to the largest velocity; larger than the rounding of nodal
/// velocities.
const MARGIN: f64 = 1e-13;
/// Power of the live loads, relative to that of the given velocities, below which these velocities
/// were no mechanism.
const LEAST_POWER: f64 = 1e-6;
/// Largest number of runs of conjugate gradients.
const STAGES: usize = 6;
/// Largest number of steps in a run.
const STEPS: usize = 200;
/// Reduction of the residual of the equations in a run.
const REDUCTION: f64 = 1e-10;
/// Largest number of steps that open violated contacts one by one.
const OPENINGS: usize = 20;

/// Velocities and their certificate.
#[derive(Clone, Debug, PartialEq)]
pub struct Upper {
    /// The velocities.
    pub field: VelocityField,
    /// Its certificate.
    pub certificate: UpperCertificate,
}

/// Reason why velocities prove no load factor.
#[derive(Clone, Debug)]
pub enum UpperError {
    /// The projection failed.
    Recover(RecoverError),
    /// The live loads do no work.
    NoPower {
        /// Power on the projected velocities.
        power: f64,
        /// Power on the given velocities.
        before: f64,
    },
}

impl UpperError {
    /// The reason in words.
    pub fn text(&self) -> Text {
        match self {
            UpperError::Recover(e) => e.text(),
            UpperError::NoPower { power, before } => say!(
                "the live loads do no work on the velocities that keep the volume: their power is \
                 {} of {} N mm",
                format!("{power:.3e}"),
                format!("{before:.3e}")
            ),
        }
    }
}

display_text!(UpperError);

impl std::error::Error for UpperError {}

impl From<RecoverError> for UpperError {
    fn from(e: RecoverError) -> Self {
        UpperError::Recover(e)
    }
}

/// The strict upper bound near approximate velocities; see [`certify_upper`] for `subdivisions`;
/// `patterns` holds the known orderings of the matrices of the mesh.
pub fn project(
    model: &AnalysisModel,
    field: &VelocityField,
    subdivisions: u32,
    patterns: &Patterns,
) -> Result<Upper, UpperError> {
    let kinematic = Kinematic::around_rigid_bodies(model).map_err(RecoverError::from)?;
    let projector = Projector::new(model, &kinematic, field.flow, patterns)?;
    let live = kinematic.limit_forces(model, field.flow, Loads::LIVE);
    let power_on = |x: &[f64]| Sum::of(live.iter().zip(x).map(|(f, u)| f * u));
    let mut x = nearest_unknowns(&kinematic.map, &kinematic.rigid, |i| field.nodes.u[i / 3][i % 3]);
    x[kinematic.map.limit_motions()]
        .iter_mut()
        .zip(&field.limit_motions)
        .for_each(|(x, m)| *x = *m);
    let before = power_on(&x);
    projector.keep_volume(&mut x);
    let power = power_on(&x);
    let opened = projector.opened(x);
    let certified = opened.iter().filter(|x| power_on(x) > LEAST_POWER * before.abs()).map(|x| {
        let u = kinematic.nodal(x);
        let limit_motions = kinematic.limit_motions(x);
        let field =
            VelocityField { nodes: DisplacementField { u }, flow: field.flow, limit_motions };
        let certificate = certify_upper(model, &field, subdivisions);
        Upper { field, certificate }
    });
    let rank = |u: &Upper| {
        let bound = UpperFactor::new(u.certificate.clone());
        (!bound.is_strict(), bound.value())
    };
    let best = certified.min_by(|a, b| {
        let ((a_loose, a), (b_loose, b)) = (rank(a), rank(b));
        a_loose.cmp(&b_loose).then(a.total_cmp(&b))
    });
    best.ok_or(UpperError::NoPower { power, before })
}

/// The projection of least change.
struct Projector<'a> {
    model: &'a AnalysisModel,
    kinematic: &'a Kinematic,
    split: bool,
    yields: Vec<bool>,
    /// Young's modulus of each body: the weight κ of its equations \[MPa\].
    weight: Vec<f64>,
    /// Factor of S.
    factor: SparseCholesky,
    /// Stiffness of the springs across contacts.
    spring: f64,
}

impl<'a> Projector<'a> {
    fn new(
        model: &'a AnalysisModel,
        kinematic: &'a Kinematic,
        flow: Flow,
        patterns: &Patterns,
    ) -> Result<Self, RecoverError> {
        let yields: Vec<bool> = model.yield_radii().iter().map(Option::is_some).collect();
        let weight: Vec<f64> =
            model.body_material.iter().map(|m| model.materials[*m as usize].e).collect();
        let split = flow == Flow::Split;
        let tets = model.mesh.tets.len();
        let mut system = assemble::<30, ModelError>(
            tets,
            &kinematic.map,
            |e| dofs(model, kinematic, e),
            |e| {
                let mut gram = Box::new([[0.0; 30]; 30]);
                for row in equations(model, &yields, &weight, split, e) {
                    for i in 0..30 {
                        (0..30).for_each(|j| gram[i][j] += AUGMENTED * row[i] * row[j]);
                    }
                }
                Ok(gram)
            },
        )?;
        let p = &kinematic.program.p;
        // both are assembled over all tets, so that their patterns are equal
        debug_assert_eq!(p.row_idx, system.row_idx);
        system.values.iter_mut().zip(&p.values).for_each(|(a, b)| *a += b);
        let mean = |d: &[f64]| d.iter().sum::<f64>() / d.len().max(1) as f64;
        // where all bodies are rigid the elastic stiffness is zero; that of their motions is used
        let stiffness = &kinematic.program.stiffness;
        let elastic = mean(&p.diagonal());
        let spring = SPRING * if elastic > 0.0 { elastic } else { mean(stiffness) };
        let mut system = plus_rows(&system, &kinematic.program.g, |_| spring);
        if !model.welds.is_empty() {
            system = plus_rows(&system, &kinematic.weld_rows(model), |_| spring);
        }
        if !(kinematic.slips.is_empty() && model.ties.is_empty()) {
            system = plus_rows(&system, &kinematic.slip_rows(model), |_| spring);
        }
        if !stiffness.is_empty() {
            let motions = kinematic.map.plain..kinematic.map.n;
            motions.for_each(|k| system.add_diagonal(k, RIGID_MOTION * stiffness[k]));
        }
        let factor = SparseCholesky::new(&system, &kinematic.map.block, patterns)?;
        Ok(Self { model, kinematic, split, yields, weight, factor, spring })
    }

    /// `C x` and its rounding, `2ε |C| |x|`.
    fn values(&self, x: &[f64]) -> (Vec<f64>, f64) {
        let u = self.kinematic.map.expand(x);
        let both: Vec<(f64, f64)> = (0..self.model.mesh.tets.len())
            .into_par_iter()
            .flat_map_iter(|e| {
                let local = dofs(self.model, self.kinematic, e).map(|d| u[d]);
                let rows = equations(self.model, &self.yields, &self.weight, self.split, e);
                rows.into_iter().map(move |row| {
                    let terms = row.iter().zip(&local).map(|(a, b)| a * b);
                    terms.fold((0.0, 0.0), |(sum, size), t| (sum + t, size + t.abs()))
                })
            })
            .collect();
        let rounding = 2.0 * f64::EPSILON * both.iter().map(|b| b.1 * b.1).sum::<f64>().sqrt();
        (both.into_iter().map(|b| b.0).collect(), rounding)
    }

    /// `Cᵀ y`.
    fn transposed(&self, y: &[f64]) -> Vec<f64> {
        let mut full = vec![0.0; self.kinematic.map.full()];
        let mut at = 0;
        for e in 0..self.model.mesh.tets.len() {
            let local = dofs(self.model, self.kinematic, e);
            for row in equations(self.model, &self.yields, &self.weight, self.split, e) {
                for (d, r) in local.iter().zip(&row) {
                    full[*d] += y[at] * r;
                }
                at += 1;
            }
        }
        self.kinematic.map.reduce(&full)
    }

    /// Adds the least change that makes `C x` vanish to rounding.
    fn keep_volume(&self, x: &mut [f64]) {
        let square = |v: &[f64]| Sum::of(v.iter().map(|x| x * x));
        let (mut r, mut rounding) = self.values(x);
        let mut rr = square(&r);
        for _ in 0..STAGES {
            // no flow removes rounding: the system for it has no solution
            if rr.sqrt() <= rounding {
                return;
            }
            let (first, wanted) = (rr, (REDUCTION * REDUCTION * rr).max(rounding * rounding));
            let mut new = x.to_vec();
            let mut p = r.clone();
            for _ in 0..STEPS {
                let t = self.factor.solve(&self.transposed(&p));
                let (q, _) = self.values(&t);
                let curvature = Sum::of(p.iter().zip(&q).map(|(a, b)| a * b));
                let step = rr / curvature;
                if curvature <= 0.0 || !step.is_finite() {
                    break;
                }
                new.iter_mut().zip(&t).for_each(|(x, t)| *x -= step * t);
                r.iter_mut().zip(&q).for_each(|(r, q)| *r -= step * q);
                let next = square(&r);
                if next <= wanted {
                    break;
                }
                p.iter_mut().zip(&r).for_each(|(p, r)| *p = r + next / rr * *p);
                rr = next;
            }
            (r, rounding) = self.values(&new);
            rr = square(&r);
            if rr >= first {
                return;
            }
            x.copy_from_slice(&new);
            if rr > 0.1 * first {
                return;
            }
        }
    }

    /// The velocities with a margin in every contact, reached by flows that keep the volume. Either
    /// violated contacts move to the nearest admissible jump and the others stay, or all contacts
    /// open alike. Which of the two dissipates less depends on the field, so both are returned; the
    /// field alone when no contact is violated.
    fn opened(&self, x: Vec<f64>) -> Vec<Vec<f64>> {
        let g = &self.kinematic.program.g;
        // ground that crushes need not open
        let points = self.kinematic.points.iter();
        let mut crushes = points.map(|p| self.model.crushing_strength(p.contact).is_some());
        let mut cones = cone_ranges(&self.kinematic.program);
        cones.retain(|_| !crushes.next().unwrap_or(false));
        let margin = |s: &[f64]| {
            cones.iter().map(|&(at, d)| cone_margin(&s[at..at + d])).fold(f64::INFINITY, f64::min)
        };
        let largest = self.kinematic.map.expand(&x).iter().fold(0.0f64, |m, u| m.max(u.abs()));
        let wanted = MARGIN * largest;
        let first = margin(&g.mul(&x));
        if first >= wanted {
            return vec![x];
        }
        // springs yield, so that jumps fall short of the target: a constant surplus is added to it
        let aim = wanted + 0.1 * (wanted - first);
        let mut one_by_one = x.clone();
        for _ in 0..OPENINGS {
            let s = g.mul(&one_by_one);
            if margin(&s) >= wanted {
                break;
            }
            let mut target = vec![0.0; s.len()];
            for &(at, d) in &cones {
                if cone_margin(&s[at..at + d]) < aim {
                    let mut inner = s[at..at + d].to_vec();
                    inner[0] -= aim;
                    into_cone(&mut inner, 1.0);
                    inner[0] += aim;
                    (0..d).for_each(|i| target[at + i] = inner[i] - s[at + i]);
                }
            }
            let w = self.opening(&target);
            one_by_one.iter_mut().zip(&w).for_each(|(x, w)| *x += w);
        }
        let mut target = vec![0.0; g.nrows()];
        cones.iter().for_each(|c| target[c.0] = 1.0);
        let w = self.opening(&target);
        let gain = margin(&g.mul(&w));
        let step = 1.1 * (wanted - first) / gain;
        if gain <= 0.0 || !step.is_finite() {
            return vec![one_by_one];
        }
        let alike = x.iter().zip(&w).map(|(x, w)| x + step * w).collect();
        vec![one_by_one, alike]
    }

    /// The flow that keeps the volume and comes nearest to the given jumps across contacts.
    fn opening(&self, target: &[f64]) -> Vec<f64> {
        let pull: Vec<f64> = target.iter().map(|t| self.spring * t).collect();
        let mut w = self.factor.solve(&self.kinematic.program.g.mul_transpose(&pull));
        self.keep_volume(&mut w);
        w
    }
}

/// The full unknowns of tet `e`.
fn dofs(model: &AnalysisModel, kinematic: &Kinematic, e: usize) -> [usize; 30] {
    let nodes = kinematic.space.tet(&model.mesh, e);
    std::array::from_fn(|i| 3 * nodes[i / 3] + i % 3)
}

/// The equations of tet `e` on its 30 velocities, weighted so that the sum of their squares
/// compares with strain energy: change of volume of a split tet, `tr ε` at the vertices of a plain
/// one, the whole strain at the vertices of a rigid one.
fn equations(
    model: &AnalysisModel,
    yields: &[bool],
    weight: &[f64],
    split: bool,
    e: usize,
) -> Vec<[f64; 30]> {
    let body = model.mesh.tet_body[e] as usize;
    let (corners, volume) = (model.mesh.corners(e), model.mesh.volume(e));
    if yields[body] && split {
        let scale = (weight[body] / volume).sqrt();
        return vec![split_flow::volume_row(&corners).map(|x| scale * x)];
    }
    let scale = (0.25 * weight[body] * volume).sqrt();
    let strains: [[Mandel; 30]; 4] = tet10::strain_columns(&corners);
    if yields[body] {
        strains.iter().map(|at| at.map(|s| scale * (s[0] + s[1] + s[2]))).collect()
    } else {
        strains.iter().flat_map(|at| (0..6).map(move |c| at.map(|s| scale * s[c]))).collect()
    }
}
