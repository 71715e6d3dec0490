//! Forces of the column that follow from the equilibrium of the node.
//!
//! Where the column ends on one side of the beam, the column on the other side carries everything
//! that the beams bring. Where it continues both ways, the two columns share it in a proportion
//! that the joint does not know.

use crate::assembly::{ColumnSide, EndPlate, PlaneActions};
use crate::checks::check::{Unit, balance, number as n};

/// The one column at a corner of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Corner {
    /// The column stands below the beam.
    Below,
    /// The column stands above the beam.
    Above,
}

/// Forces of the one column at a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CornerForces {
    /// Axial force, tension positive \[N\].
    pub axial: f64,
    /// Largest moment about the strong axis: at the node, or level with the beam flange beyond it
    /// \[N mm\].
    pub moment: f64,
    /// Moment at the node \[N mm\].
    pub at_node: f64,
    /// Shear force \[N\].
    pub shear: f64,
}

/// How many columns meet at the joint.
pub(super) fn columns(c: &ColumnSide) -> u32 {
    2 - u32::from(c.above.is_some()) - u32::from(c.below.is_some())
}

/// The side of the one column; `None` where the column continues both ways, or neither.
pub(super) fn corner(c: &ColumnSide) -> Option<Corner> {
    match (c.above, c.below) {
        (Some(_), None) => Some(Corner::Below),
        (None, Some(_)) => Some(Corner::Above),
        _ => None,
    }
}

/// Horizontal force of the beams on the node along +x \[N\].
fn horizontal<'a>(actions: impl Iterator<Item = &'a PlaneActions>) -> f64 {
    balance(actions.map(|a| a.outward * a.at(1.0)[0][0]))
}

/// The actions of one load case.
pub(super) fn of_case<'a>(
    e: &'a EndPlate,
    case: &'a str,
) -> impl Iterator<Item = &'a PlaneActions> {
    e.actions.iter().filter(move |a| a.case == case)
}

/// Moment of all beams about the node, right-handed about +y \[N mm\].
pub(super) fn node_moment(e: &EndPlate, case: &str) -> f64 {
    balance(of_case(e, case).map(|a| a.outward * a.moment_at_node()))
}

impl CornerForces {
    /// Forces of the column at a corner under a load case; `None` without a corner.
    pub fn new(e: &EndPlate, case: &str) -> Option<Self> {
        let corner = corner(e.column.as_ref()?)?;
        let lift = balance(of_case(e, case).map(|a| a.at(1.0)[0][2]));
        let (push, at_node) = (horizontal(of_case(e, case)), node_moment(e, case));
        // the column below is pressed by what weighs on the node, the one above pulled
        let (axial, lever) = match corner {
            Corner::Below => (lift, 0.5 * e.beam.h),
            Corner::Above => (-lift, -0.5 * e.beam.h),
        };
        let moment = at_node.abs().max((at_node + lever * push).abs());
        Some(Self { axial, moment, at_node: at_node.abs(), shear: push.abs() })
    }
}

/// What the shear forces of the column take off that of the web panel, in the sense of a positive
/// moment of a beam along +x.
struct PanelRelief {
    /// (V_c1 − V_c2)/2 \[N\].
    value: f64,
    /// Title of the check of the panel, with where the column's shear comes from.
    title: &'static str,
}

impl CornerForces {
    /// Largest longitudinal compressive stress at the root of the web, at most f_y \[MPa\].
    pub fn longitudinal(&self, c: &ColumnSide) -> f64 {
        let s = &c.section;
        let root = 0.5 * s.h - s.tf - s.r;
        // the tables give cm² and cm⁴
        let stress = -self.axial / (1e2 * s.area) + self.moment * root / (1e4 * s.i_y);
        stress.clamp(0.0, c.steel.fy)
    }
}

/// Reduction of the shear force of the panel: from the spec, else from the one column at a corner,
/// else zero.
///
/// # Source
/// EN 1993-1-8:2005 5.3(3).
fn panel_relief(e: &EndPlate, case: &str) -> PanelRelief {
    const GIVEN: &str = "column web panel in shear";
    const NOT_GIVEN: &str = "column web panel in shear (column shear not given, V_Ed = 0)";
    const NODE: &str = "column web panel in shear (column shear by equilibrium of the node)";
    let half = 0.5 * horizontal(of_case(e, case));
    let (value, title) = match e.column.as_ref().map(|c| (c.shear, corner(c))) {
        Some((given, _)) if given != 0.0 => (given, GIVEN),
        // the cut through the panel has the upper flanges of the beams on its free side
        Some((_, Some(Corner::Below))) => (-half, NODE),
        Some((_, Some(Corner::Above))) => (half, NODE),
        _ => (0.0, NOT_GIVEN),
    };
    PanelRelief { value, title }
}

/// Shear force of the web panel at a member end.
pub(super) struct PanelShear {
    /// |V_wp,Ed| \[N\].
    pub demand: f64,
    /// Its formula with its numbers.
    pub formula: String,
    /// Title of the check of the panel, with where the column's shear comes from.
    pub title: &'static str,
}

impl PanelShear {
    /// The shear force of the panel, `lever` z_eq of the joint \[mm\], `other` the sum of My of the
    /// other ends \[N mm\].
    ///
    /// # Source
    /// EN 1993-1-8:2005 5.3(3), formula 5.3.
    pub fn new(e: &EndPlate, a: &PlaneActions, other: f64, lever: f64) -> Self {
        let own = a.at(1.0)[1][1];
        let PanelRelief { value: relief, title } = panel_relief(e, &a.case);
        // V_Ed is positive against the shear of a positive moment at an end along +x
        let demand = (a.outward * (own - other) / lever - relief).abs();
        let none = relief == 0.0;
        let formula = format!(
            "V_wp,Ed = |(M_b1 − M_b2)/z_eq{}| = |({} − {})/{}{}| = {}",
            if none { "" } else { " − (V_c1 − V_c2)/2" },
            Unit::Moment.show(own),
            Unit::Moment.show(other),
            Unit::Length.show(lever),
            if none { String::new() } else { minus(a.outward * relief) },
            Unit::Force.show(demand)
        );
        Self { demand, formula, title }
    }
}

/// ` − x` with the sign of x.
fn minus(force: f64) -> String {
    let sign = if force < 0.0 { "+" } else { "−" };
    format!(" {sign} {} kN", n(1e-3 * force.abs()))
}
