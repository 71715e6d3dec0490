//! M–N diagrams of an end plate, for the report. No check needs them, and they cost more time than
//! all checks.

use super::component_joint::component_joint;
use super::sense::senses;
use super::transformation::beta;
use crate::component_method::equilibrium::SMALL_AXIAL;
use crate::component_method::{Equilibrium, assess};
use bracket_joint::assembly::EndPlate;

/// Points of a curve.
const POINTS: usize = 72;

/// Resistance of a joint to moment and axial force together, by the component method.
#[derive(Clone, Debug, PartialEq)]
pub struct MomentAxial {
    /// β of the moments on both sides, which reduces the resistance of the column web.
    pub beta: f64,
    /// The interaction curve: N and M \[N, N mm\], positive for tension and for tension at the top.
    pub border: Vec<[f64; 2]>,
    /// M_j,Rd for tension at the top and for tension at the bottom \[N mm\], which limits the
    /// moment; 0 where the tables do not cover the sense.
    pub resistance: [f64; 2],
    /// Axial force up to which its effect on the moment resistance is neglected \[N\].
    pub small: f64,
    /// Name, and N and M at the bolt plane \[N, N mm\], of each load case with this β.
    pub demands: Vec<(String, [f64; 2])>,
}

/// A diagram for every β of the load cases; none where the tables do not cover the joint.
pub fn moment_axial(e: &EndPlate) -> Vec<MomentAxial> {
    let mut betas: Vec<f64> = e.actions.iter().map(|a| beta(e, a)).collect();
    if betas.is_empty() {
        betas.extend(senses(e).first().map(|s| s.1));
    }
    betas.sort_by(f64::total_cmp);
    betas.dedup();
    let diagram = |of: f64| {
        let plain = component_joint(e, of);
        let equilibrium = Equilibrium::new(&plain).ok()?;
        let resistance =
            [assess(&plain), assess(&plain.mirrored())].map(|a| a.map_or(0.0, |a| a.moment.value));
        let moment = resistance[0].max(resistance[1]);
        let of_beta = e.actions.iter().filter(|a| beta(e, a) == of);
        let demands = of_beta.map(|a| {
            let [force, turn] = a.at(1.0);
            (e.case_name(a), [force[0], turn[1]])
        });
        let small = SMALL_AXIAL * equilibrium.plastic;
        let border = equilibrium.diagram(moment, POINTS);
        Some(MomentAxial { beta: of, border, resistance, small, demands: demands.collect() })
    };
    betas.into_iter().filter_map(diagram).collect()
}
