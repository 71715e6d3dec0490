//! The route of analysis: what shows that a joint carries its loads where the code has no method.
//!
//! A strict lower bound of limit analysis proves equilibrium and strength (EN 1993-1-8:2005 2.5(1)
//! a, b). The other steps show that the joint can reach this distribution (c, d): bolts that stay
//! elastic carry their forces, plates strain little, nothing buckles, welds carry their lines of
//! force. The route is complete when every step holds; a step without its numbers is open, and says
//! what supplies them.

mod bolts;
mod detailing;
mod evidence;
mod facts;
mod scope;
mod stability;
mod step;
mod steps;
mod strain;
mod welds;

pub use evidence::{
    BoltSections, CriticalFactors, CriticalMode, Evidence, PlateStrain, SectionForce, WeldForce,
    WeldForces,
};
pub use facts::{RouteFacts, WeldFacts};
pub use stability::LARGEST_CRITICAL;
pub use step::{RouteStep, RouteUse, StepId, StepState};
pub use steps::{Found, NextMesh, is_complete, least_factor, next_mesh, steps};
pub use strain::LARGEST_STRAIN;

#[cfg(test)]
mod tests;
