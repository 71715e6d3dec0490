//! The capacity polygon, from the passes of its directions.

use crate::driver::case::Case;
use crate::driver::passes::Kept;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::certify::UpperFactor;
use bracket_engine::certify::half_plane::Axes;
use bracket_engine::certify::half_plane::half_plane;
use bracket_joint::spec::polygon::PolygonSpec;
use bracket_report::result::demand::ActionValue;
use bracket_report::result::polygon::{Axis, CapacityPolygon, Point};
use bracket_report::result::result_file::CaseResult;
use bracket_report::result::result_file::Upper;

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
            Some(case.model.rigid.iter().map(|r| r.action).collect())
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
        let AnalysisPass::Factor(pass) = &best.outcome else { return };
        let free = pass.free.as_ref().map(|f| (&f.field, UpperFactor::new(f.certificate.clone())));
        let mechanism = pass.velocity.as_ref().zip(pass.upper.clone()).or(free);
        let bound = mechanism.filter(|_| matches!(entry.upper, Some(Upper::Finite(_))));
        let half_plane =
            bound.and_then(|(v, bound)| half_plane(&best.model, v, &bound, &self.axes, direction));
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
