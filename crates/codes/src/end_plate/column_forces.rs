//! Forces of the column beside the joint: those of the spec, and what the equilibrium of the node
//! says about them.
//!
//! Where the column ends on one side of the beam, the column on the other side carries everything
//! that the beams bring. Where it continues both ways, the two columns share it in a proportion
//! that the joint does not know: one of them has at least half of the moment.

use crate::check::{CheckId, Unit, balance, within};
use crate::formula::{Derivation, Formula, Number, Traced};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{ColumnSide, EndPlate, PlaneActions};

/// A given moment that lacks no more than this part of what equilibrium asks for is rounded.
const ROUNDED: f64 = 0.01;

/// The one column at a corner of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Corner {
    /// The column stands below the beam.
    Below,
    /// The column stands above the beam.
    Above,
}

/// Forces of the one column at a corner, by equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
struct CornerForces {
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
    fn new(e: &EndPlate, c: &ColumnSide, case: &str) -> Option<Self> {
        let corner = corner(c)?;
        let lift = balance(of_case(e, case).map(|a| a.at(1.0)[0][2]));
        let (push, at_node) = (horizontal(of_case(e, case)), node_moment(e, case));
        // the column below is pressed by what weighs on the node, the one above pulled
        let half = 0.5 * e.depth();
        // the outer face of the beam's flange beyond the node, the farther one of several beams
        let beyond = |side: f64| {
            let faces = of_case(e, case).map(|a| half + side * a.above_node);
            faces.reduce(f64::max).unwrap_or(half)
        };
        let (axial, lever) = match corner {
            Corner::Below => (lift, beyond(-1.0)),
            Corner::Above => (-lift, -beyond(1.0)),
        };
        let moment = at_node.abs().max((at_node + lever * push).abs());
        Some(Self { axial, moment, at_node: at_node.abs(), shear: push.abs() })
    }
}

/// What is known of the moment of the column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Moment {
    /// By equilibrium, or given in agreement with it.
    Known,
    /// Not given: equilibrium gives the least value.
    NotGiven {
        /// The whole moment of the node \[N mm\].
        most: f64,
    },
    /// The given moment is less than equilibrium allows.
    Contradicts,
}

/// Forces of the column beside the joint in a load case, with where they come from.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ColumnForces {
    /// Axial force, tension positive \[N\].
    pub axial: f64,
    /// Moment about the strong axis: the known one, or the least that equilibrium allows \[N mm\].
    pub moment: f64,
    /// What is known of it.
    pub known: Moment,
    /// Shear force along the web \[N\].
    pub shear: f64,
    /// Where they come from, in words.
    pub from: Text,
}

impl ColumnForces {
    /// Forces of the spec, which belong to no load case; `None` if it gives neither N_Ed nor M_Ed.
    pub fn given(c: &ColumnSide) -> Option<Self> {
        let from = match (c.axial.is_some(), c.moment.is_some()) {
            (false, false) => return None,
            (true, false) => "N_Ed of the spec, no load case gives a moment",
            (false, true) => "M_Ed of the spec, which gives no N_Ed: taken as 0",
            (true, true) => "N_Ed and M_Ed of the spec",
        };
        let (axial, moment) = (c.axial.unwrap_or(0.0), c.moment.unwrap_or(0.0).abs());
        let (known, shear) = (Moment::Known, c.shear.abs());
        Some(Self { axial, moment, known, shear, from: from.into() })
    }

    /// Forces under a load case.
    pub fn of_case(e: &EndPlate, c: &ColumnSide, case: &str) -> Self {
        match CornerForces::new(e, c, case) {
            Some(corner) => Self::at_corner(c, &corner),
            None => Self::continuing(e, c, case),
        }
    }

    /// The one column at a corner: the larger of what equilibrium says and what the spec gives.
    fn at_corner(c: &ColumnSide, corner: &CornerForces) -> Self {
        let at_node = Unit::Moment.show(corner.at_node);
        let node = say!("equilibrium of the node with one column, M = {} at the node", at_node);
        let mut from = vec![node];
        let mut larger = |name: &'static str, given: Option<f64>, found: f64| match given {
            Some(given) if !within(given.abs(), found.abs()) => {
                from.push(say!("{} of the spec", name));
                given
            }
            _ => found,
        };
        let axial = larger("N_Ed", c.axial, corner.axial);
        let moment = larger("M_Ed", c.moment.map(f64::abs), corner.moment);
        let shear = larger("V_Ed", Some(c.shear.abs()), corner.shear);
        Self { axial, moment, known: Moment::Known, shear, from: Text::joined(", ", from) }
    }

    /// The columns above and below: together they have the moment of the node, so that the larger
    /// one is at least half of it.
    fn continuing(e: &EndPlate, c: &ColumnSide, case: &str) -> Self {
        // a stub that ends both ways has nothing beside the joint
        let bring = |whole: f64| if columns(c) == 2 { whole } else { 0.0 };
        let node = bring(node_moment(e, case).abs());
        let least = 0.5 * node;
        let (known, words): (_, Text) = match c.moment.map(f64::abs) {
            Some(given) if within((1.0 - ROUNDED) * least, given) => {
                (Moment::Known, "M_Ed of the spec".into())
            }
            Some(given) => {
                let words = say!(
                    "M_Ed = {} of the spec is less than half of the moment {} at the node, M ≥ {} \
                     in the column above or below",
                    Unit::Moment.show(given),
                    Unit::Moment.show(node),
                    Unit::Moment.show(least)
                );
                (Moment::Contradicts, words)
            }
            // without a moment at the node nothing is missing
            None if node == 0.0 => (Moment::Known, "M = 0 at the node".into()),
            None => {
                let words = say!(
                    "the spec gives no M_Ed: half of the moment {} at the node is the least that \
                     the column above or below has",
                    Unit::Moment.show(node)
                );
                (Moment::NotGiven { most: node }, words)
            }
        };
        // the two columns differ by what weighs on the node
        // V_Ed is the mean of the columns above and below, the push of the beams their difference
        let push = bring(horizontal(of_case(e, case)).abs());
        let pressed = 0.5 * bring(balance(of_case(e, case).map(|a| a.at(1.0)[0][2])));
        let (axial, of_axial): (_, Text) = match c.axial {
            Some(given) if within(pressed.abs(), given.abs()) => (given, "N_Ed of the spec".into()),
            _ => {
                let least = Unit::Force.show(pressed);
                (pressed, say!("N = {} is half of what the beams bring, the least", least))
            }
        };
        Self {
            axial,
            moment: c.moment.map_or(0.0, f64::abs).max(least),
            known,
            shear: c.shear.abs() + 0.5 * push,
            from: say!("{}, {}", of_axial, words),
        }
    }

    /// Largest longitudinal compressive stress at the root of the web, at most f_y \[MPa\]:
    /// `σ = −N/A + |M| (h/2 − t_f − r)/I_y`, with the whole moment of the node where M_Ed is not
    /// known.
    pub fn longitudinal(&self, c: &ColumnSide) -> f64 {
        let s = &c.section;
        let root = 0.5 * s.h - s.tf - s.r;
        let moment = match self.known {
            Moment::NotGiven { most } => most,
            Moment::Known => self.moment,
            // half of the moment of the node is the least, `moment`
            Moment::Contradicts => 2.0 * self.moment,
        };
        // the tables give cm² and cm⁴
        let stress = -self.axial / (1e2 * s.area) + moment * root / (1e4 * s.i_y);
        stress.clamp(0.0, c.steel.fy.mpa())
    }
}

/// What the beams leave at a node whose column ends above and below: horizontal and vertical force
/// \[N\], moment \[N mm\]; `None` where they balance or the column continues.
pub(super) fn unsupported(e: &EndPlate, c: &ColumnSide, case: &str) -> Option<[f64; 3]> {
    let lift = balance(of_case(e, case).map(|a| a.at(1.0)[0][2]));
    let left = [horizontal(of_case(e, case)), lift, node_moment(e, case)];
    Some(left).filter(|left| columns(c) == 0 && left.iter().any(|x| *x != 0.0))
}

/// Whether the checks know something of N and M of the column: the spec gives N_Ed or M_Ed, or the
/// column ends at the joint.
pub(super) fn known(c: &ColumnSide) -> bool {
    c.axial.is_some() || c.moment.is_some() || corner(c).is_some()
}

/// What the shear forces of the column take off that of the web panel, in the sense of a positive
/// moment of a beam along +x.
struct PanelRelief {
    /// (V_c1 − V_c2)/2 \[N\].
    value: f64,
    /// Id of the check of the panel, which says where the column's shear comes from.
    id: CheckId,
}

/// Reduction of the shear force of the panel: from the spec, from the one column at a corner, else
/// zero. Where the spec contradicts equilibrium, the one with the larger `shear` of the panel.
///
/// # Source
/// EN 1993-1-8:2005 5.3(3).
fn panel_relief(e: &EndPlate, case: &str, shear: impl Fn(f64) -> f64) -> PanelRelief {
    const GIVEN: CheckId = CheckId::ColumnPanel;
    const NOT_GIVEN: CheckId = CheckId::PanelNoColumnShear;
    const NODE: CheckId = CheckId::PanelByEquilibrium;
    let half = 0.5 * horizontal(of_case(e, case));
    let column = e.column.as_ref();
    // the cut through the panel has the upper flanges of the beams on its free side
    let node = column.and_then(corner).map(|corner| match corner {
        Corner::Below => -half,
        Corner::Above => half,
    });
    let given = column.map(|c| c.shear).filter(|shear| *shear != 0.0);
    let (value, id) = match (node, given) {
        (Some(node), Some(given)) if within(shear(given), shear(node)) => (node, NODE),
        (_, Some(given)) => (given, GIVEN),
        (Some(node), None) => (node, NODE),
        (None, None) => (0.0, NOT_GIVEN),
    };
    PanelRelief { value, id }
}

/// Shear force of the web panel at a member end.
pub(super) struct PanelShear {
    /// |V_wp,Ed| \[N\].
    pub demand: f64,
    /// Its formula.
    pub derivation: Derivation,
    /// Id of the check of the panel, which says where the column's shear comes from.
    pub id: CheckId,
}

impl PanelShear {
    /// The shear force of the panel, `lever` z_eq of the joint \[mm\], `other` the sum of My of the
    /// other ends \[N mm\].
    ///
    /// # Source
    /// EN 1993-1-8:2005 5.3(3), formula 5.3.
    pub fn new(e: &EndPlate, a: &PlaneActions, other: f64, lever: f64) -> Self {
        let own = a.at(1.0)[1][1];
        // V_Ed is positive against the shear of a positive moment at an end along +x
        let difference = balance([own, -other]);
        let shear = |relief: f64| (a.outward * difference / lever - relief).abs();
        let PanelRelief { value: relief, id } = panel_relief(e, &a.case, shear);
        // moments that balance but for rounding are equal
        let other = if difference == 0.0 { own } else { other };
        let [own, other] =
            [("M_b1", own), ("M_b2", other)].map(|(s, m)| Traced::symbol(s, m, Unit::Moment));
        let moments = (own - other) / Traced::length("z_eq", lever);
        let formula = |shear: Traced| Formula::new("V_wp,Ed", shear.abs(), Unit::Force);
        let (shear, words) = if relief == 0.0 {
            (formula(moments), None)
        } else {
            let columns = Traced::force("ΔV_c", 2.0 * a.outward * relief);
            let words = "ΔV_c is V_c1 − V_c2 of 5.3(3)";
            (formula(moments - columns / Traced::from(2.0)), Some(words))
        };
        let demand = shear.value;
        let derivation = words.into_iter().fold(Derivation::from(shear), Derivation::then);
        Self { demand, derivation, id }
    }
}
