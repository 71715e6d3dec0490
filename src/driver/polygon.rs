//! The capacity polygon, from the passes of its directions.

use crate::driver::case::Case;
use crate::driver::passes::Kept;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::certify::half_space::{Axes, HalfSpace, live_actions};
use bracket_engine::certify::{UpperFactor, VelocityField};
use bracket_joint::spec::polygon::PolygonSpec;
use bracket_report::result::demand::ActionValue;
use bracket_report::result::polygon::{Axis, CapacityPolygon, Point};
use bracket_report::result::result_file::CaseResult;
use bracket_report::result::result_file::Upper;

/// The mechanism of the upper bound of a load factor, and the bound that it proves.
pub fn mechanism(best: &Kept) -> Option<(&VelocityField, UpperFactor)> {
    let AnalysisPass::Factor(pass) = &best.outcome else { return None };
    let free = pass.free.as_ref().map(|f| (&f.field, UpperFactor::new(f.certificate.clone())));
    pass.velocity.as_ref().zip(pass.upper.clone()).or(free)
}

/// A polygon whose directions are being analysed.
pub struct Directions {
    spec: PolygonSpec,
    axes: Axes,
    points: Vec<Point>,
}

impl Directions {
    /// The directions among the cases to analyse; `None` if there are none.
    pub fn among(cases: &[Case], spec: Option<&PolygonSpec>) -> Option<Self> {
        let actions = |along: [f64; 2]| {
            let case = cases.iter().find(|c| c.direction == Some(along))?;
            Some(live_actions(&case.model))
        };
        // both axes are among the directions
        Some(Self {
            spec: spec?.clone(),
            axes: [actions([1.0, 0.0])?, actions([0.0, 1.0])?],
            points: Vec::new(),
        })
    }

    /// Adds the bounds of a direction.
    pub fn add(&mut self, direction: [f64; 2], entry: &CaseResult, best: &Kept) {
        let (lower, upper) = entry.safe_bounds();
        let bound = mechanism(best).filter(|_| matches!(entry.upper, Some(Upper::Finite(_))));
        let half_space = bound.and_then(|(v, bound)| HalfSpace::new(&best.model, v, &bound));
        let half_plane = half_space.and_then(|h| h.half_plane(&self.axes, direction));
        self.points.push(Point { case: entry.name.clone(), direction, lower, upper, half_plane });
    }

    /// The polygon.
    pub fn polygon(self) -> Option<CapacityPolygon> {
        let axes = self.spec.axes()?.map(|(action, size)| Axis {
            action: action.word().into(),
            unit: ActionValue::of(action, size),
        });
        Some(CapacityPolygon::new([self.spec.end, self.spec.at.word().into()], axes, self.points))
    }
}
