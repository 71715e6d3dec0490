//! M–N diagrams of an end plate, for the report. No check needs them, and they cost more time than
//! all checks.

use super::comparison::Method;
use super::component_joint::component_joint;
use super::sense::senses;
use super::transformation::beta;
use crate::check::within;
use crate::component_method::equilibrium::SMALL_AXIAL;
use crate::component_method::{Equilibrium, assess};
use crate::subject::Sense;
use bracket_joint::assembly::{EndPlate, PlaneActions};

/// Points of a curve.
const POINTS: usize = 72;

/// Values of β up to which each has a diagram.
const EACH: usize = 2;

/// Resistance of a joint to moment and axial force together, by the component method.
#[derive(Clone, Debug, PartialEq)]
pub struct MomentAxial {
    /// The curve of one β; of load cases with many β those of the smallest and of the largest.
    pub curves: Vec<Curve>,
    /// Axial force up to which its effect on the moment resistance is neglected \[N\]; `None`:
    /// it never is.
    pub small: Option<f64>,
    /// The load cases of the diagram.
    pub demands: Vec<Point>,
}

/// The resistance for one β.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// β of the moments on both sides, which reduces the resistance of the column web.
    pub beta: f64,
    /// The interaction curve: N and M \[N, N mm\], positive for tension and for tension at the top.
    pub border: Vec<[f64; 2]>,
    /// M_j,Rd for tension at the top and for tension at the bottom \[N mm\], where it limits the
    /// moment also under compression; 0 where the tables do not cover the sense.
    pub resistance: Option<[f64; 2]>,
}

/// A load case at a member end.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Its name.
    pub case: String,
    /// N and M at the bolt plane \[N, N mm\].
    pub at: [f64; 2],
    /// Utilisation of the joint under both by 6.2.7.1, with the case's own β; infinite where
    /// nothing of them is carried.
    pub utilisation: f64,
}

/// The joint for one β.
struct Resistance {
    beta: f64,
    moments: [f64; 2],
    equilibrium: Equilibrium,
}

impl Resistance {
    fn new(e: &EndPlate, beta: f64) -> Option<Self> {
        let plain = component_joint(e, beta);
        let equilibrium = Equilibrium::new(&plain).ok()?;
        let moments =
            [assess(&plain), assess(&plain.mirrored())].map(|a| a.map_or(0.0, |a| a.moment.value));
        Some(Self { beta, moments, equilibrium })
    }

    fn curve(&self) -> Curve {
        let Self { beta, moments: resistance, .. } = *self;
        let border = self.equilibrium.diagram(resistance[0].max(resistance[1]), POINTS);
        Curve { beta, border, resistance: Some(resistance) }
    }

    /// The load case of actions with this β.
    fn point(&self, e: &EndPlate, a: &PlaneActions) -> Point {
        let at = a.at(1.0);
        let (axial, moment) = (at[0][0], at[1][1]);
        let (sense, moment_resistance) = match moment < 0.0 {
            true => (Sense::Bottom, self.moments[1]),
            false => (Sense::Top, self.moments[0]),
        };
        let equilibrium = Some(self.equilibrium.clone());
        let method = Method { moment: moment_resistance, equilibrium, beta: self.beta, sense };
        let utilisation = method.share(at).map_or(f64::INFINITY, |w| w.value);
        Point { case: e.case_name(a), at: [axial, moment], utilisation }
    }
}

/// A diagram for every β of the load cases, or one for all of them where they have many; none where
/// the tables do not cover the joint.
pub fn moment_axial(e: &EndPlate) -> Vec<MomentAxial> {
    let mut betas: Vec<f64> = e.actions.iter().map(|a| beta(e, a)).collect();
    if betas.is_empty() {
        betas.extend(senses(e).first().map(|s| s.1));
    }
    betas.sort_by(f64::total_cmp);
    betas.dedup();
    let found: Vec<Resistance> =
        betas.into_iter().filter_map(|beta| Resistance::new(e, beta)).collect();
    let of = |r: &Resistance| -> Vec<Point> {
        let here = e.actions.iter().filter(|a| beta(e, a) == r.beta);
        here.map(|a| r.point(e, a)).collect()
    };
    let diagram = |r: &Resistance, curves: Vec<Curve>, demands: Vec<Point>| MomentAxial {
        curves,
        small: Some(SMALL_AXIAL * r.equilibrium.plastic),
        demands,
    };
    match (found.first(), found.last()) {
        (Some(first), Some(last)) if found.len() > EACH => {
            let curves = [first, last].map(Resistance::curve);
            vec![diagram(first, curves.into(), found.iter().flat_map(of).collect())]
        }
        _ => found.iter().map(|r| diagram(r, vec![r.curve()], of(r))).collect(),
    }
}

impl Point {
    /// True if the joint carries both actions by the component method.
    pub fn is_carried(&self) -> bool {
        within(self.utilisation, 1.0)
    }
}
