//! Moment and axial force together: the plastic equilibrium of rows in tension and flanges in
//! compression.
//!
//! By 6.2.7.1(2) an axial force of up to 5 % of N_pl,Rd is neglected. Beyond it each row, the two
//! flanges and the web of the beam have a resistance, and the largest factor on M and N together is
//! the solution of a linear program. Its row forces are in equilibrium with M and N.

use super::assembly::{assess, elastic_limit};
use super::beam;
use super::compressed_zone::{CompressedZone, beyond, compressed_width, zone};
use super::joint::{Column, EndPlateJoint};
use super::rows::{Component, Rows};
use crate::check::within;
use crate::error::CheckError;
use crate::formula::Derivation;
use bracket_joint::assembly::Way;
use microlp::{ComparisonOp, OptimizationDirection, Problem, Solution, Variable};

/// Fraction of the plastic axial force of the beam up to which its effect is neglected.
///
/// # Source
/// EN 1993-1-8:2005 6.2.7.1(2).
pub const SMALL_AXIAL: f64 = 0.05;

/// The linear programs are in kN and m, so that their numbers are near 1.
const KILO: f64 = 1e-3;

/// The flanges, as pairs of this module name them.
const WAYS: [Way; 2] = [Way::Up, Way::Down];

/// A row and its force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowPull {
    /// z from the beam's axis \[mm\].
    pub z: f64,
    /// Tension of the row \[N\].
    pub force: f64,
    /// Tension of one of its two bolts, prying included \[N\].
    pub bolt: f64,
}

/// The largest multiple of an axial force and a moment that the components can carry.
#[derive(Clone, Debug, PartialEq)]
pub struct Carried {
    /// The multiple.
    pub factor: f64,
    /// Rows in tension at that multiple; rows that are not listed have no force.
    pub rows: Vec<RowPull>,
    /// Compression of the upper flange, the web and the lower flange at that multiple \[N\].
    pub compression: [f64; 3],
}

/// Rows in tension together, and the parts that may be in compression beside them. z is in the axes
/// of the joint that the set was made from.
#[derive(Clone, Debug)]
struct RowSet {
    /// −1 for a set made from the mirrored joint, otherwise 1.
    sign: f64,
    z: Vec<f64>,
    /// Bolt force over half of the row's force.
    prying: Vec<f64>,
    /// Resistance of the rows `first..=last` together \[N\].
    limits: Vec<(usize, usize, f64)>,
    /// Largest force of a row by 6.2.7.2(9) \[N\].
    elastic: Vec<f64>,
    compression: Option<Compression>,
    /// V_wp,Rd/β \[N\].
    panel: Option<f64>,
}

/// Compressed parts of the beam's end.
#[derive(Clone, Copy, Debug)]
struct Compression {
    /// Resistance of either flange \[N\].
    flange: f64,
    /// Of the web between them \[N\].
    web: f64,
    /// Of all together \[N\].
    total: f64,
    /// z of the middles of the upper and the lower flange \[mm\].
    middles: [f64; 2],
}

/// Rule of 6.2.7.2 that the rows of a program follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Rule {
    /// All components yield.
    Plastic,
    /// Paragraph 9 as well: rows below one that is near the resistance of its bolts stay elastic.
    NearlyBolts,
}

/// Resistance of a joint to moment and axial force together.
#[derive(Clone, Debug)]
pub struct Equilibrium {
    sets: Vec<RowSet>,
    /// N_pl,Rd of the beam \[N\].
    pub plastic: f64,
    /// z of the middles of the upper and the lower flange of the beam \[mm\].
    pub middles: [f64; 2],
    /// N_j,Rd of tension, without moment \[N\].
    pub tension: f64,
    /// N_j,Rd of compression, without moment \[N\].
    pub compression: f64,
    /// Reason why the column web may buckle under compression over the depth of the beam, which
    /// N_j,Rd includes; `None` where it does not buckle.
    pub buckles: Option<Derivation>,
}

impl Equilibrium {
    /// The resistance of a joint; rows that no table of effective lengths covers are an error.
    pub fn new(joint: &EndPlateJoint) -> Result<Self, CheckError> {
        let (upper, lower) = (RowSet::bent(joint, 1.0), RowSet::bent(&joint.mirrored(), -1.0));
        // one sense is enough: the other may have no row in tension
        let sets = match (upper, lower) {
            (Err(e), Err(_)) => return Err(e),
            (a, b) => {
                let panel = a.as_ref().or(b.as_ref()).ok().and_then(|s| s.panel);
                a.into_iter().chain(b).chain(RowSet::pulled(joint, panel)).collect()
            }
        };
        let beam = &joint.beam;
        let plastic = beam.axial_area() * beam.fy / joint.gamma_m0;
        let buckles = joint.column.as_ref().and_then(|c| Compression::buckles(joint, c));
        let middles = WAYS.map(|flange| beam.middle(flange));
        let mut out = Self { sets, plastic, middles, tension: 0.0, compression: 0.0, buckles };
        let alone = |n: f64| out.carried(n, 0.0, Rule::Plastic).map_or(0.0, |c| c.factor * n.abs());
        (out.tension, out.compression) = (alone(plastic), alone(-plastic));
        Ok(out)
    }

    /// The largest multiple of an axial force (tension positive) and a moment (tension at the top
    /// positive) \[N, N mm\]; `None` where both are zero.
    pub fn at(&self, axial: f64, moment: f64) -> Option<Carried> {
        self.carried(axial, moment, Rule::NearlyBolts)
    }

    /// Whether an axial force is small enough to be neglected beside a moment.
    pub fn small(&self, axial: f64) -> bool {
        within(axial.abs(), SMALL_AXIAL * self.plastic)
    }

    /// The interaction curve: `count` points (N, M) in the order of their angle, measured with N
    /// and M as fractions of their largest values \[N, N mm\].
    pub fn diagram(&self, moment: f64, count: usize) -> Vec<[f64; 2]> {
        let axial = self.tension.max(self.compression);
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / count as f64;
        let point = |i: usize| {
            let direction = [axial * angle(i).cos(), moment * angle(i).sin()];
            let factor = self.at(direction[0], direction[1])?.factor;
            Some(direction.map(|x| factor * x))
        };
        (0..count).filter_map(point).collect()
    }

    fn carried(&self, axial: f64, moment: f64, rule: Rule) -> Option<Carried> {
        if axial == 0.0 && moment == 0.0 {
            return None;
        }
        let most = if axial == 0.0 { f64::INFINITY } else { self.plastic / axial.abs() };
        let each = self.sets.iter().filter_map(|s| s.solve(axial, moment, most, rule));
        each.reduce(|a, b| if b.factor > a.factor { b } else { a })
    }
}

impl RowSet {
    /// The joint bent with tension at the top: resistances of each row and group by the component
    /// method.
    fn bent(joint: &EndPlateJoint, sign: f64) -> Result<Self, CheckError> {
        let found = assess(joint)?;
        let shear_area = Rows::new(joint)?.shear_area();
        let compression = Some(Compression::new(joint, found.beam_moment.value, shear_area));
        let sheared = found.panel.as_ref().filter(|_| joint.beta > 0.0);
        let panel = sheared.map(|p| p.value / joint.beta);
        let elastic = found.rows.iter().enumerate().map(|(r, row)| {
            elastic_limit(joint, &found.rows[..r], row.lever).map_or(f64::INFINITY, |l| l.0)
        });
        let elastic = elastic.collect();
        let mut limits = Vec::new();
        for (r, row) in found.rows.iter().enumerate() {
            limits.push((r, r, row.single.max(0.0)));
            // the lengths of a group of very close rows can turn negative: no resistance
            limits
                .extend(row.groups.iter().map(|g| (g.first, r, g.component.worked.value.max(0.0))));
        }
        let prying = found.rows.iter().map(|row| prying(&row.alone)).collect();
        let z = found.rows.iter().map(|r| r.z).collect();
        Ok(Self { sign, z, prying, limits: tightest(limits), elastic, compression, panel })
    }

    /// The whole joint in tension, `panel` as in bending; `None` where the tables do not cover its
    /// rows.
    fn pulled(joint: &EndPlateJoint, panel: Option<f64>) -> Option<Self> {
        let rows = Rows::all(joint).ok()?;
        let count = rows.count();
        let (mut limits, mut ratios) = (Vec::new(), Vec::new());
        for first in 0..count {
            for last in first..count {
                let components = rows.components(first, last);
                if first == last {
                    ratios.push(prying(&components));
                }
                limits.extend(components.iter().map(|c| (first, last, c.worked.value.max(0.0))));
            }
        }
        let (z, elastic) = (rows.z.clone(), vec![f64::INFINITY; count]);
        Some(Self {
            sign: 1.0,
            z,
            prying: ratios,
            limits: tightest(limits),
            elastic,
            compression: None,
            panel,
        })
    }

    /// The largest factor, at most `most`.
    fn solve(&self, axial: f64, moment: f64, most: f64, rule: Rule) -> Option<Carried> {
        let moment = self.sign * moment;
        let mut p = Problem::new(OptimizationDirection::Maximize);
        // scale of the load as a force, so that the factor is of order 1
        let size = axial.abs().max(moment.abs() / self.depth());
        let factor = p.add_var(1.0, (0.0, most * size * KILO));
        let rows: Vec<Variable> = (0..self.z.len())
            .map(|r| {
                let cap = if rule == Rule::NearlyBolts { self.elastic[r] } else { f64::INFINITY };
                p.add_var(0.0, (0.0, cap * KILO))
            })
            .collect();
        for &(first, last, limit) in &self.limits {
            let sum: Vec<(Variable, f64)> = rows[first..=last].iter().map(|v| (*v, 1.0)).collect();
            p.add_constraint(&sum, ComparisonOp::Le, limit * KILO);
        }
        let mut force: Vec<(Variable, f64)> = rows.iter().map(|v| (*v, 1.0)).collect();
        let mut turning: Vec<(Variable, f64)> =
            rows.iter().zip(&self.z).map(|(v, z)| (*v, z * KILO)).collect();
        let mut shear = match self.compression {
            Some(_) => force.clone(),
            None => rows.iter().zip(&self.z).map(|(v, z)| (*v, z.signum())).collect(),
        };
        let pushed = self.compression.map(|c| {
            let [upper, lower] = [0, 1].map(|_| p.add_var(0.0, (0.0, c.flange * KILO)));
            let web = p.add_var(0.0, (0.0, c.web * KILO));
            p.add_constraint(
                [(upper, 1.0), (web, 1.0), (lower, 1.0)],
                ComparisonOp::Le,
                c.total * KILO,
            );
            force.extend([upper, web, lower].map(|v| (v, -1.0)));
            turning.extend([(upper, -c.middles[0] * KILO), (lower, -c.middles[1] * KILO)]);
            // the middle of the web, where the flanges are not equal
            let middle = 0.5 * (c.middles[0] + c.middles[1]);
            turning.extend((middle != 0.0).then_some((web, -middle * KILO)));
            shear.extend([(upper, -1.0), (lower, 1.0)]);
            [upper, web, lower]
        });
        if let Some(panel) = self.panel {
            for sign in [1.0, -1.0] {
                let half: Vec<(Variable, f64)> =
                    shear.iter().map(|(v, c)| (*v, 0.5 * sign * c)).collect();
                p.add_constraint(&half, ComparisonOp::Le, panel * KILO);
            }
        }
        force.push((factor, -axial / size));
        turning.push((factor, -moment / size * KILO));
        p.add_constraint(&force, ComparisonOp::Eq, 0.0);
        p.add_constraint(&turning, ComparisonOp::Eq, 0.0);
        let solution = solved(&p)?;
        let value = |v: Variable| solution.var_value(v).max(0.0) / KILO;
        let pull = |(r, v): (usize, &Variable)| {
            let force = value(*v);
            RowPull { z: self.sign * self.z[r], force, bolt: 0.5 * force * self.prying[r] }
        };
        let mut compression = pushed.map_or([0.0; 3], |c| c.map(value));
        if self.sign < 0.0 {
            compression.reverse();
        }
        Some(Carried {
            factor: value(factor) / size,
            rows: rows.iter().enumerate().map(pull).collect(),
            compression,
        })
    }

    /// Half of the distance over which forces act \[mm\].
    fn depth(&self) -> f64 {
        let rows = self.z.iter().fold(0.0, |a: f64, z| a.max(z.abs()));
        let flanges = |c: Compression| c.middles.into_iter().fold(rows, |a, z| a.max(z.abs()));
        self.compression.map_or(rows, flanges).max(1.0)
    }
}

/// The least limit of every group of rows.
fn tightest(mut limits: Vec<(usize, usize, f64)>) -> Vec<(usize, usize, f64)> {
    limits.sort_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
    limits.dedup_by_key(|l| (l.0, l.1));
    limits
}

/// Bolt force over half of a row's force, from the T-stubs of the row alone.
fn prying(alone: &[Component]) -> f64 {
    alone.iter().filter_map(|c| Some(c.bolts? / c.worked.value)).fold(1.0, f64::max)
}

/// The optimum, if the program has one.
fn solved(p: &Problem) -> Option<Solution> {
    p.solve().ok()?.into_solution().ok()
}

impl Compression {
    /// Reason why the web between the flanges buckles under compression; without stiffeners it
    /// includes the zones of the flanges. `None` where it does not buckle.
    fn buckles(joint: &EndPlateJoint, c: &Column) -> Option<Derivation> {
        let halves = WAYS.map(|flange| 0.5 * compressed_width(joint, c, flange));
        let depth = joint.beam.lever();
        let width = match c.stiffener > 0.0 {
            true => depth - (halves[0] + halves[1]),
            false => {
                let both = [0, 1].map(|i| beyond(joint, c, WAYS[i], halves[i]));
                depth + both[0] + both[1]
            }
        };
        let web = zone(joint, c, width.max(0.0), 1.0);
        let words = "the column web buckles under the compressed beam";
        (web.buckling() < 1.0).then(|| web.buckles(words))
    }

    fn new(joint: &EndPlateJoint, beam_moment: f64, shear_area: f64) -> Self {
        let b = &joint.beam;
        let (middles, depth) = (WAYS.map(|flange| b.middle(flange)), b.lever());
        let of_beam = beam::end_compression(b, beam_moment, joint.gamma_m0).value;
        let web_of_beam = (b.section.area * b.fy / joint.gamma_m0 - 2.0 * of_beam).max(0.0);
        let Some(c) = &joint.column else {
            return Self { flange: of_beam, web: web_of_beam, total: f64::INFINITY, middles };
        };
        let halves = WAYS.map(|flange| 0.5 * compressed_width(joint, c, flange));
        let bare = |width: f64| zone(joint, c, width, shear_area).resistance().value;
        // half a zone beyond either flange, as far as the column reaches
        let beyond = [0, 1].map(|i| beyond(joint, c, WAYS[i], halves[i]));
        let of_zone = |flange| CompressedZone::new(joint, c, flange, shear_area).resistance().value;
        let flange = of_zone(Way::Up).min(of_zone(Way::Down));
        let between = (depth - (halves[0] + halves[1])).max(0.0);
        let between = if between > 0.0 { bare(between) } else { 0.0 };
        // without stiffeners the two zones and the web between them buckle together
        let total =
            if c.stiffener > 0.0 { f64::INFINITY } else { bare(beyond[0] + beyond[1] + depth) };
        Self { flange: of_beam.min(flange), web: web_of_beam.min(between), total, middles }
    }
}
