//! The steps of the route in their order.

use super::bolts::bolts;
use super::detailing::detailing;
use super::evidence::{CriticalFactors, Evidence};
use super::facts::RouteFacts;
use super::scope::scope;
use super::stability::stability;
use super::step::{RouteStep, RouteUse, StepId, StepState};
use super::strain::strain;
use super::welds::welds;
use crate::unit::Unit;
use bracket_base::say;
use bracket_base::words::Text;

/// What the analyses of a load case have found.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a> {
    /// Strict lower bound of the load factor of limit analysis, without friction.
    pub lower: Option<f64>,
    /// Number of copies of the meshed part that make the joint.
    pub copies: usize,
    /// Estimates of elastoplastic analysis with elastic bolts, mesh after mesh.
    pub meshes: &'a [Evidence],
    /// Critical factors of the last of them.
    pub critical: Option<&'a CriticalFactors>,
    /// Why they are not known.
    pub critical_unknown: Option<&'a Text>,
}

const STRENGTH: &str = "EN 1993-1-8:2005 2.5(1) a, b; lower bound theorem of limit analysis";

/// The steps for a load case, those that need no analysis first.
pub fn steps(facts: &RouteFacts, found: Found<'_>) -> Vec<RouteStep> {
    let mut out = vec![scope(facts), detailing(facts), strength(facts, found.lower)];
    let Some(last) = found.meshes.last() else {
        let source = "EN 1993-1-8:2005 2.5(1) c, d";
        let next = "an elastoplastic analysis with elastic bolts (`decide: true`)";
        let finding = "there is no elastoplastic analysis with elastic bolts";
        out.push(RouteStep::open(StepId::Bolts, finding.into(), source, next));
        return out;
    };
    out.push(bolts(facts, found.meshes, found.copies));
    out.push(strain(found.meshes));
    out.push(stability(facts, found.critical, found.critical_unknown, found.lower));
    out.push(welds(facts, last, found.copies));
    out
}

/// What the estimates of a load case ask of the next mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NextMesh {
    /// Nothing: bolts and strains hold.
    None,
    /// Nothing: a value is above its limit whichever of its two fields or meshes is right.
    Hopeless,
    /// Strains to compare with: a coarser mesh has them too.
    Coarser,
    /// Estimates that agree better, or all of them.
    Finer,
}

/// What the estimates of these meshes, in order of their tets, ask of the next one.
pub fn next_mesh(facts: &RouteFacts, copies: usize, meshes: &[Evidence]) -> NextMesh {
    let (bolts, strain) = (bolts(facts, meshes, copies), strain(meshes));
    match () {
        _ if bolts.is_surely_exceeded() || strain.is_surely_exceeded() => NextMesh::Hopeless,
        _ if bolts.holds() && strain.holds() => NextMesh::None,
        _ if meshes.len() == 1 && bolts.is_within() => NextMesh::Coarser,
        () => NextMesh::Finer,
    }
}

/// Whether the route is complete and every step holds.
pub fn is_complete(steps: &[RouteStep]) -> bool {
    !steps.is_empty() && steps.iter().all(RouteStep::holds)
}

/// Reserve of the lower bound where no hand check covers net section and block tearing. The model
/// has them, but a ligament that is held in its plane carries up to 2/√3 of f, and holes are as
/// wide as the bolts: 0.9 f_u/γ_M2 · 2/√3 is 1.04 f_u/γ_M2, and with the least distances of Table
/// 3.3 a section between holes is up to 1.07 times as long.
const RESERVE: f64 = 1.12;

/// The lower bound that a verdict by analysis needs.
pub fn least_factor(facts: &RouteFacts) -> f64 {
    if facts.hand_checked { 1.0 } else { RESERVE }
}

/// Strength by the lower bound: the loads times it are carried.
fn strength(facts: &RouteFacts, lower: Option<f64>) -> RouteStep {
    let Some(lower) = lower.filter(|l| *l > 0.0) else {
        let finding = "there is no strict lower bound of the load factor".into();
        let next = "a limit analysis (`kind: limit`), more time (`time_limit`) or memory";
        return RouteStep::open(StepId::Strength, finding, STRENGTH, next);
    };
    let certified = crate::unit::number(down(lower));
    let what = match facts.hand_checked {
        true => say!("1/λ, λ = {} certified", certified),
        false => say!(
            "{}/λ, λ = {} certified, with a reserve for net section and block tearing",
            crate::unit::number(RESERVE),
            certified
        ),
    };
    let row = RouteUse {
        what,
        value: least_factor(facts) / lower,
        spread: None,
        limit: 1.0,
        unit: Unit::Number,
        source: STRENGTH.into(),
    };
    let next = "less load, or narrower bounds by more meshes or time (`max_passes`, `time_limit`)";
    RouteStep::of_uses(StepId::Strength, StepState::Proved, vec![row], STRENGTH, next)
}

/// A lower bound cut to three decimals.
fn down(lower: f64) -> f64 {
    (1e3 * lower).floor() / 1e3
}
