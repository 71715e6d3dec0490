//! Whether a simple joint turns as the pinned joint that the frame takes it for.

use super::plies::{plate, plies, web};
use crate::check::{Check, CheckId, Status, Topic, largest, within};
use crate::formula::{Number, Traced};
use crate::subject::Part;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{SimpleJoint, SimpleKind};

/// Thickness of the ply over the diameter of the bolts up to which the holes of a fin plate give
/// way before the bolts break, by the yield strength of the ply \[MPa\].
///
/// # Source
/// Steel Buildings in Europe, Part 5, 3.1, and Steelwork Building 15.2.3, Note 4: S275 and S355.
const GIVES_WAY: [(f64, f64); 2] = [(275.0, 0.5), (355.0, 0.42)];

/// The rules of rotation for one joint.
pub(super) struct RotationRules<'a> {
    e: &'a SimpleJoint,
}

impl<'a> RotationRules<'a> {
    /// The rules for a joint.
    pub fn new(e: &'a SimpleJoint) -> Self {
        Self { e }
    }

    /// The rules of thickness: one or, of a fin plate with several lines of bolts, both plies.
    ///
    /// # Source
    /// Fin plate: see [`GIVES_WAY`], SCI P358 for several lines. Header plate: `t ≤ (d/2.8)
    /// √(f_ub/f_y)` of the plate or of the support, NCCI SN014, 12.
    fn thicknesses(&self) -> Vec<Check> {
        let e = self.e;
        let d = || Traced::length("d", e.bolt.d);
        let rule = |part: Part, thickness: f64, limit: Traced, clause: &'static str| {
            let (of, what) = ((Topic::Ductility, part), (clause, CheckId::PinnedThickness));
            Check::at_most(of, what, "t", limit, thickness, Status::Warning)
        };
        let each: Vec<Check> = plies(e)
            .iter()
            .map(|ply| match e.kind {
                SimpleKind::FinPlate => {
                    let clause = "Steel Buildings in Europe 5, 3.1; SCI P358";
                    let part = GIVES_WAY.iter().find(|(fy, _)| within(ply.steel.fy.mpa(), *fy));
                    match part {
                        Some((_, part)) => {
                            rule(ply.part, ply.thickness, Traced::from(*part) * d(), clause)
                        }
                        None => no_rule(ply.part, clause),
                    }
                }
                SimpleKind::HeaderPlate => {
                    let strengths = Traced::stress("f_ub", e.grade.fub)
                        / Traced::stress("f_y", ply.steel.fy.mpa());
                    let limit = d() / Traced::from(2.8) * strengths.sqrt();
                    rule(ply.part, ply.thickness, limit, "NCCI SN014, 12")
                }
            })
            .collect();
        if e.kind == SimpleKind::FinPlate && e.columns.len() > 1 {
            return each;
        }
        // one ply that gives way suffices
        let used = |c: &Check| -c.utilisation.unwrap_or(f64::INFINITY);
        largest(each, used).into_iter().collect()
    }

    /// All rules. Not one of them binds.
    pub fn checks(&self) -> Vec<Check> {
        let e = self.e;
        let mut out = self.thicknesses();
        let (part, of) = (plate(e).part, Topic::Ductility);
        let clause = match e.kind {
            SimpleKind::FinPlate => "Steel Buildings in Europe 5, 3.1",
            SimpleKind::HeaderPlate => "Steel Buildings in Europe 5, 2.1",
        };
        let height = Traced::from(0.6) * Traced::length("h_b", e.beam.h);
        let what = (clause, CheckId::PlateHeight);
        out.push(Check::at_least((of, part), what, "h_p", height, e.height(), Status::Warning));
        if e.kind == SimpleKind::FinPlate {
            let [p, w] = [plate(e), web(e)];
            let least = [p.e1, p.e2, w.e1, w.e2].into_iter().fold(f64::INFINITY, f64::min);
            let limit = Traced::from(2.0) * Traced::length("d", e.bolt.d);
            let what = (clause, CheckId::PinnedDistances);
            out.push(Check::at_least((of, part), what, "e", limit, least, Status::Warning));
        }
        out
    }

    /// Reason why the lower bound of a limit analysis decides nothing: the bolts may break before
    /// the plies have given way. `None` where a rule of thickness holds.
    pub fn brittle(&self) -> Option<Text> {
        let rules = self.thicknesses();
        if rules.iter().all(|c| c.status == Status::Ok) {
            return None;
        }
        let each =
            rules.iter().map(|c| say!("{}: {} ({})", c.subject.text(), c.formula(), &c.clause));
        Some(say!(
            "no rule for the rotation of a pinned joint holds, so that bolts may break before the \
             plies have yielded as limit analysis takes them to: {}",
            Text::joined("; ", each)
        ))
    }
}

/// A ply of a steel that no rule covers.
fn no_rule(part: Part, clause: &'static str) -> Check {
    let why = "the rules cover steels up to S355";
    let check = Check::assumption(Topic::Ductility, part, clause, CheckId::PinnedThickness, why);
    Check { status: Status::Warning, ..check }
}
