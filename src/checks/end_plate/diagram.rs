//! M–N diagrams of an end plate, for the report: not needed for any check, and dearer than all of
//! them.

use super::{EndPlate, joint, loaded, senses};
use crate::checks::component_method::equilibrium::SMALL_AXIAL;
use crate::checks::component_method::{Equilibrium, assess};

/// Points of a border.
const POINTS: usize = 72;

/// What a joint carries of moment and axial force by the component method.
#[derive(Clone, Debug, PartialEq)]
pub struct MomentAxial {
    /// β of the moments on both sides, on which the column web hangs.
    pub beta: f64,
    /// The border: N and M \[N, N mm\], tension and tension at the top positive.
    pub border: Vec<[f64; 2]>,
    /// M_j,Rd of tension at the top and of tension at the bottom \[N mm\]: the most that counts; 0
    /// where the tables do not cover it.
    pub resistance: [f64; 2],
    /// Axial force that is left out beside a moment \[N\].
    pub small: f64,
    /// Load cases of this β, by name: N and M at the bolt plane.
    pub demands: Vec<(String, [f64; 2])>,
}

/// A diagram for every β of the load cases; where the tables do not cover the joint, none.
pub fn moment_axial(e: &EndPlate) -> Vec<MomentAxial> {
    let mut betas: Vec<f64> = e.actions.iter().map(|a| loaded::beta(e, a)).collect();
    if betas.is_empty() {
        betas.extend(senses(e).first().map(|s| s.1));
    }
    betas.sort_by(f64::total_cmp);
    betas.dedup();
    let several = e.actions.iter().any(|a| a.end != e.actions[0].end);
    let diagram = |beta: f64| {
        let plain = joint(e, beta);
        let equilibrium = Equilibrium::new(&plain).ok()?;
        let resistance =
            [assess(&plain), assess(&plain.mirrored())].map(|a| a.map_or(0.0, |a| a.moment.value));
        let moment = resistance[0].max(resistance[1]);
        let of_beta = e.actions.iter().filter(|a| loaded::beta(e, a) == beta);
        let demands = of_beta.map(|a| {
            let [force, turn] = a.at(1.0);
            let name = if several { format!("{}, {}", a.case, a.end) } else { a.case.clone() };
            (name, [force[0], turn[1]])
        });
        let small = SMALL_AXIAL * equilibrium.plastic;
        let border = equilibrium.diagram(moment, POINTS);
        Some(MomentAxial { beta, border, resistance, small, demands: demands.collect() })
    };
    betas.into_iter().filter_map(diagram).collect()
}
