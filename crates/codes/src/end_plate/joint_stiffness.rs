//! Initial stiffness of a joint from the bracket of the rotation in an elastic analysis, and its
//! class by stiffness.

use super::at_plate;
use super::column_flexibility::column_flexibility;
use crate::classification::{StiffnessClass, stiffness_limits};
use crate::component_method::Assessment;
use crate::subject::Frame;
use bracket_joint::assembly::{EndPlate, PlaneActions};
use serde::{Deserialize, Serialize};

/// Actions below this fraction of the moment (forces times the depth of the beam) are rounding.
const ROUNDING: f64 = 1e-9;

/// A load case that consists of one moment My at a member end, or of equal moments at the ends of
/// two beams that balance at a column. The rotation of the loaded section is then φ = −2Π/M, and
/// the bounds of the potential energy Π bracket it.
#[derive(Clone, Debug, PartialEq)]
pub struct PureMoment {
    /// Load case.
    pub case: String,
    /// Member end.
    pub end: String,
    /// |My| \[N mm\].
    pub moment: f64,
    /// M L/(E I_b) of the beam between the loaded section and the plates \[rad\]: Euler–Bernoulli;
    /// a moment alone causes no shear deformation.
    pub beam_rotation: f64,
    /// E I_b of the beam \[N mm²\].
    pub flexural: f64,
    /// System length of the beam \[mm\], where it is known.
    pub system_length: Option<f64>,
    /// Whether the joint is between a beam and a column, so that the boundaries of 5.2.2.5 apply.
    pub column: bool,
    /// Rotation of the column between its supports by beam theory, without the shear strain of its
    /// web panel under the moment \[rad\]: 0 where the moment does not bend the column, negative
    /// where the column relieves its panel by more than it bends. `None`: not known.
    pub column_rotation: Option<f64>,
    /// S_j,ini of the component method \[N mm/rad\].
    pub component_method: f64,
}

impl PureMoment {
    /// The load case at a member end; `None` unless it is a moment alone and the template states
    /// the length of beam that bends. A haunched beam has no one stiffness over that length.
    pub(super) fn new(
        e: &EndPlate,
        a: &PlaneActions,
        beta: f64,
        assessment: &Assessment,
    ) -> Option<Self> {
        let [[n, vy, vz], [torsion, my, mz]] = a.live;
        let small = ROUNDING * my.abs();
        let others = [n, vy, vz].map(|f| f * e.depth()).into_iter().chain([torsion, mz]);
        let dead = a.dead.iter().flatten().any(|x| *x != 0.0);
        if my == 0.0
            || dead
            || others.into_iter().any(|x| x.abs() > small)
            || e.bending_length <= 0.0
            || at_plate::haunch(e).is_some()
        {
            return None;
        }
        // cm⁴ → mm⁴
        let flexural = e.beam_steel.e * 1e4 * e.beam.i_y;
        Some(Self {
            case: a.case.clone(),
            end: a.end.clone(),
            moment: my.abs(),
            beam_rotation: my.abs() * e.bending_length / flexural,
            flexural,
            system_length: e.system_length,
            column: e.column.is_some(),
            column_rotation: match beta {
                0.0 => Some(0.0),
                _ => column_flexibility(e).map(|flexibility| my.abs() * flexibility),
            },
            component_method: assessment.stiffness.initial.value,
        })
    }
}

/// Bracket of S_j,ini. The rotation of the joint is that of the loaded section less those of the
/// members, beam and column. It contains the deformation of plates, bolts, contact, column web and
/// flanges, the components of EN 1993-1-8:2005 6.3.1(1).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JointStiffness {
    /// Member ends, each under the moment.
    pub ends: Vec<String>,
    /// The moment \[N mm\].
    pub moment: f64,
    /// Bracket of the rotation of the loaded section \[rad\].
    pub rotation: [f64; 2],
    /// M L/(E I_b) of the beam, subtracted from it \[rad\].
    pub beam_rotation: f64,
    /// Rotation of the column by beam theory, subtracted from it \[rad\]; 0 where the moment does
    /// not bend the column. Negative where supports near the joint let the shear force of the
    /// column relieve its web panel by more than the column bends.
    pub column_rotation: f64,
    /// Lower bound of S_j,ini \[N mm/rad\].
    pub lower: f64,
    /// Upper bound of S_j,ini \[N mm/rad\]; absent where the least rotation is at most that
    /// of the members.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// S_j,ini of the component method \[N mm/rad\].
    pub component_method: f64,
    /// Class by stiffness from the bracket, for braced frames and for others; empty in a splice.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub classes: Vec<FrameClass>,
}

/// The class of a joint by stiffness, as far as its bracket determines it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FrameClass {
    /// Kind of frame.
    pub frame: Frame,
    /// Beams of at least this system length make the joint rigid, whatever its stiffness within the
    /// bracket \[mm\].
    pub rigid_from: f64,
    /// Shorter beams certainly make it semi-rigid or pinned \[mm\]; absent without an upper bound
    /// of the stiffness.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub not_rigid_below: Option<f64>,
    /// Up to this system length it is nominally pinned \[mm\]; absent without an upper bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pinned_to: Option<f64>,
    /// Classes of the lower and of the upper end of the bracket at the system length of the beam;
    /// if they differ, the class is undecided.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub class: Option<[StiffnessClass; 2]>,
}

impl JointStiffness {
    /// From the bracket of the loaded sections' rotation \[rad\] under `total`, the sum of the
    /// moments \[N mm\]; `None` where the rotation of the column is not known, and where the load
    /// of the analysis is anything else than these moments, equal and at one end or two.
    pub fn new(case: &[&PureMoment], total: f64, rotation: [f64; 2]) -> Option<Self> {
        let first = *case.first()?;
        let sum: f64 = case.iter().map(|m| m.moment).sum();
        let alike = case.iter().all(|m| (m.moment / first.moment - 1.0).abs() <= 1e-9);
        // two moments bracket the mean of two rotations, which are equal where the moments balance
        let column = first.column_rotation?;
        let balanced = case.len() == 1 || case.iter().all(|m| m.column_rotation == Some(0.0));
        let members = first.beam_rotation + column;
        if !alike || !balanced || (total / sum - 1.0).abs() > 1e-6 || rotation[1] <= members {
            return None;
        }
        let [low, high] = rotation.map(|phi| phi - members);
        let lower = first.moment / high;
        let upper = (low > 0.0).then(|| first.moment / low);
        let frames = [Frame::Braced, Frame::Unbraced].into_iter().filter(|_| first.column);
        Some(Self {
            ends: case.iter().map(|m| m.end.clone()).collect(),
            moment: first.moment,
            rotation,
            beam_rotation: first.beam_rotation,
            column_rotation: column,
            lower,
            upper,
            component_method: first.component_method,
            classes: frames.map(|frame| FrameClass::new(frame, first, lower, upper)).collect(),
        })
    }
}

impl JointStiffness {
    /// The same joint under a recomputed `total` and a recomputed bracket of the rotation. Values
    /// that do not come from the analysis stay as reported: rotations of the members, flexural
    /// stiffness of the beam, and the component method. The class at the beam's own length is left
    /// out, because the result does not contain that length.
    pub fn again(&self, total: f64, rotation: [f64; 2]) -> Option<Self> {
        let flexural =
            self.classes.first().map_or(1.0, |c| c.rigid_from * self.lower / c.frame.factor());
        let each = self.ends.iter().map(|end| PureMoment {
            case: String::new(),
            end: end.clone(),
            moment: self.moment,
            beam_rotation: self.beam_rotation,
            flexural,
            system_length: None,
            column: !self.classes.is_empty(),
            column_rotation: Some(self.column_rotation),
            component_method: self.component_method,
        });
        let each: Vec<PureMoment> = each.collect();
        Self::new(&each.iter().collect::<Vec<_>>(), total, rotation)
    }

    /// Whether two of them agree, apart from the class at the beam's own length; `near` decides
    /// whether two numbers are equal.
    pub fn agrees(&self, other: &Self, near: impl Fn(f64, f64) -> bool) -> bool {
        let open = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => near(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        let class = |(a, b): (&FrameClass, &FrameClass)| {
            a.frame == b.frame
                && near(a.rigid_from, b.rigid_from)
                && open(a.not_rigid_below, b.not_rigid_below)
                && open(a.pinned_to, b.pinned_to)
        };
        self.ends == other.ends
            && near(self.moment, other.moment)
            && (0..2).all(|i| near(self.rotation[i], other.rotation[i]))
            && near(self.lower, other.lower)
            && open(self.upper, other.upper)
            && self.classes.len() == other.classes.len()
            && self.classes.iter().zip(&other.classes).all(class)
    }
}

impl FrameClass {
    /// Lengths at which E I_b/L_b meets the boundaries of 5.2.2.5(1), and the class at the beam's
    /// own length.
    fn new(frame: Frame, m: &PureMoment, lower: f64, upper: Option<f64>) -> Self {
        let class = m.system_length.map(|length| {
            let limits = stiffness_limits(frame, false, m.flexural, 1.0, length);
            [limits.class(lower), limits.class(upper.unwrap_or(f64::INFINITY))]
        });
        Self {
            frame,
            rigid_from: frame.factor() * m.flexural / lower,
            not_rigid_below: upper.map(|s| frame.factor() * m.flexural / s),
            pinned_to: upper.map(|s| 0.5 * m.flexural / s),
            class,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// E I = 1e12 N mm², 1 kN m, rotations of 0.6 mrad of the beam and 0.4 mrad of the column.
    fn moment(end: &str) -> PureMoment {
        PureMoment {
            case: "A".into(),
            end: end.into(),
            moment: 1e6,
            beam_rotation: 0.6e-3,
            flexural: 1e12,
            system_length: Some(5000.0),
            column: true,
            column_rotation: Some(0.4e-3),
            component_method: 2e8,
        }
    }

    /// φ between 3 and 6 mrad, 1 of them the members': S between 1/5 and 1/2 kN m/mrad. With
    /// E I/L = 0.2 kN m/mrad the boundaries are 0.1 and 1.6 (braced) or 5 (other frames), so that
    /// the joint is semi-rigid; where a boundary lies inside the bracket the class is open.
    #[test]
    fn the_members_are_taken_out_and_the_class_is_three_valued() {
        let s = JointStiffness::new(&[&moment("r")], 1e6, [3e-3, 6e-3]).expect("one moment");
        assert!(
            (s.lower / 2e8 - 1.0).abs() < 1e-12
                && s.upper.is_some_and(|u| (u / 5e8 - 1.0).abs() < 1e-12),
            "{s:?}"
        );
        assert_eq!(s.classes[0].class, Some([StiffnessClass::SemiRigid; 2]));
        // k_b E I/S: 8 and 25 times 1e12/2e8, 0.5 times 1e12/5e8
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
        assert!(
            near(s.classes[0].rigid_from, 40e3) && near(s.classes[1].rigid_from, 125e3),
            "{s:?}"
        );
        assert!(s.classes[0].pinned_to.is_some_and(|l| near(l, 1000.0)), "{s:?}");
        assert!(s.classes[0].not_rigid_below.is_some_and(|l| near(l, 16e3)), "{s:?}");
        let at = |length| {
            let m = PureMoment { system_length: Some(length), ..moment("r") };
            JointStiffness::new(&[&m], 1e6, [3e-3, 6e-3]).expect("one moment").classes[0].class
        };
        assert_eq!(at(41e3), Some([StiffnessClass::Rigid; 2]));
        assert_eq!(at(30e3), Some([StiffnessClass::SemiRigid, StiffnessClass::Rigid]));
        assert_eq!(at(990.0), Some([StiffnessClass::NominallyPinned; 2]));
        assert_eq!(at(2000.0), Some([StiffnessClass::NominallyPinned, StiffnessClass::SemiRigid]));
    }

    /// A result is reproduced from its own moment and rotation; a change of any of its numbers is
    /// detected.
    #[test]
    fn a_stiffness_is_found_again_and_every_change_is_seen() {
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(b.abs());
        let phi = [3e-3, 6e-3];
        let reported = JointStiffness::new(&[&moment("r")], 1e6, phi).expect("one moment");
        let found = |s: &JointStiffness| s.again(1e6, phi).is_some_and(|a| a.agrees(s, close));
        assert!(found(&reported));
        let more = |x: &mut f64| *x *= 1.001;
        type Change<'a> = &'a dyn Fn(&mut JointStiffness);
        let changes: [Change<'_>; 13] = [
            &|s| more(&mut s.moment),
            &|s| more(&mut s.rotation[0]),
            &|s| more(&mut s.rotation[1]),
            &|s| more(&mut s.beam_rotation),
            &|s| more(&mut s.column_rotation),
            &|s| more(&mut s.lower),
            &|s| s.upper.iter_mut().for_each(more),
            &|s| s.upper = None,
            &|s| more(&mut s.classes[0].rigid_from),
            &|s| more(&mut s.classes[1].rigid_from),
            &|s| s.classes[0].not_rigid_below.iter_mut().for_each(more),
            &|s| s.classes[1].pinned_to.iter_mut().for_each(more),
            &|s| s.classes.truncate(1),
        ];
        for (i, change) in changes.iter().enumerate() {
            let mut other = reported.clone();
            change(&mut other);
            assert!(!found(&other), "change {i}: {other:?}");
        }
        assert!(
            !reported.again(1e6, [3e-3, 6.001e-3]).is_some_and(|a| a.agrees(&reported, close)),
            "another bracket"
        );
        assert!(reported.again(2e6, phi).is_none(), "another load");
    }

    /// A bracket of the rotation that includes the members' rotation gives no upper bound of the
    /// stiffness; a bracket below it gives no stiffness.
    #[test]
    fn a_stiff_joint_may_have_no_upper_bound() {
        let s = JointStiffness::new(&[&moment("r")], 1e6, [0.9e-3, 3e-3]).expect("one moment");
        assert!(s.upper.is_none() && (s.lower / 5e8 - 1.0).abs() < 1e-12);
        assert_eq!(s.classes[0].class, Some([StiffnessClass::SemiRigid, StiffnessClass::Rigid]));
        assert!(s.classes[0].pinned_to.is_none() && s.classes[0].not_rigid_below.is_none());
        assert!(JointStiffness::new(&[&moment("r")], 1e6, [0.5e-3, 0.9e-3]).is_none());
    }

    /// The load must consist of these moments and nothing else; two of them only where they are
    /// equal and balance.
    #[test]
    fn other_loads_give_no_stiffness() {
        let (right, left) = (moment("r"), moment("l"));
        let phi = [3e-3, 6e-3];
        assert!(JointStiffness::new(&[&right], 1.1e6, phi).is_none());
        assert!(JointStiffness::new(&[&right, &left], 2e6, phi).is_none(), "they bend the column");
        let [right, left] = [right, left].map(|m| PureMoment { column_rotation: Some(0.0), ..m });
        assert!(JointStiffness::new(&[&right, &left], 2e6, phi).is_some());
        let more = PureMoment { moment: 1.5e6, ..left };
        assert!(JointStiffness::new(&[&right, &more], 2.5e6, phi).is_none());
        assert!(JointStiffness::new(&[], 1e6, phi).is_none());
    }

    /// A column that is not known as a beam cannot be taken out: no stiffness and no class. One
    /// that relieves its panel makes the joint softer than the whole.
    #[test]
    fn the_rotation_of_the_column_must_be_known() {
        let of = |column_rotation| {
            let m = PureMoment { column_rotation, ..moment("r") };
            JointStiffness::new(&[&m], 1e6, [3e-3, 6e-3])
        };
        assert_eq!(of(None), None);
        // 1 kN m over 6 − 0.6 + 0.6 mrad
        let lower = of(Some(-0.6e-3)).expect("known").lower;
        assert!((lower * 6e-3 / 1e6 - 1.0).abs() < 1e-12, "{lower}");
    }
}
