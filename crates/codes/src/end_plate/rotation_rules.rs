//! Rotation capacity of a joint: whether its rows may reach their plastic forces side by side, as
//! limit analysis assumes.

use super::clamped_plates::clamped;
use super::national_annex;
use crate::check::{Check, Status, within};
use crate::component_method::equilibrium::SMALL_AXIAL;
use crate::ductility::{Clamped, plastic_distribution, rotation_capacity};
use crate::eurocode::yielding::plastic;
use crate::formula::{Derivation, Line, Number, Relation, Traced};
use crate::subject::{Part, Sense};
use crate::unit::Unit;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::EndPlate;

/// Grades covered by the rules of rotation capacity, EN 1993-1-8:2005 6.4.2(1).
const EN_6_4_2_STEELS: [&str; 3] = ["S235", "S275", "S355"];

/// Parts that limit a joint in one sense of bending.
pub(super) struct SenseLimits {
    /// Sense of bending.
    pub sense: Sense,
    /// Parts whose bending limits a row: end plate, column flange.
    pub bending: Vec<Part>,
    /// Whether the column web panel limits the joint and can rotate (6.4.2(1)).
    pub panel_turns: bool,
}

/// The rules for one part, by its dimensions alone.
struct PartRules {
    /// End plate or column flange.
    part: Part,
    /// EN 1993-1-8 6.4.2(2).
    by_code: Check,
    /// NA.2.7 of the UK annex; `None` with any other annex.
    by_annex: Option<Check>,
}

/// The rules of rotation capacity for end plate and column flange: one that holds makes the joint
/// ductile. That of the UK annex applies with this annex alone. Those of 6.4.2 apply to S235, S275
/// and S355, to axial forces up to 5 % of N_pl,Rd (6.4.2(1)) and to a part whose bending limits a
/// row (6.4.2(2)).
pub(super) struct RotationRules {
    parts: Vec<PartRules>,
    /// Reason why 6.4.2 does not cover the joint; `None` where it does.
    not_covered: Option<Derivation>,
}

impl RotationRules {
    /// The rules for an end plate.
    pub fn new(e: &EndPlate) -> Self {
        let rules = |(part, c): (Part, Clamped)| PartRules {
            part,
            by_code: rotation_capacity(part, &c),
            by_annex: national_annex::is_uk(e).then(|| plastic_distribution(part, &c)),
        };
        Self { parts: clamped(e).map(rules).collect(), not_covered: not_covered(e) }
    }

    /// Whether a rule holds where the bending of these parts limits a row.
    fn hold(&self, bending: &[Part]) -> bool {
        self.parts.iter().any(|p| {
            let by_code = self.not_covered.is_none() && bending.contains(&p.part);
            let by_annex = p.by_annex.as_ref().is_some_and(|c| c.status == Status::Ok);
            (by_code && p.by_code.status == Status::Ok) || by_annex
        })
    }

    /// Whether the joint is ductile in every sense of bending that the load cases have, in both
    /// where there are none.
    pub fn ductile(&self, e: &EndPlate, limits: &[SenseLimits]) -> bool {
        let ductile = |sense: Sense| {
            let each: Vec<_> = limits.iter().filter(|l| l.sense == sense).collect();
            if each.is_empty() {
                self.hold(&[])
            } else {
                each.iter().all(|l| l.panel_turns || self.hold(&l.bending))
            }
        };
        if e.actions.is_empty() {
            return [Sense::Top, Sense::Bottom].into_iter().all(ductile);
        }
        e.actions.iter().map(|a| Sense::of_moment(a.at(1.0)[1][1])).all(ductile)
    }

    /// The rules as checks. A rule of 6.4.2 that does not apply is a warning with the reason.
    pub fn checks(&self, limits: &[SenseLimits]) -> Vec<Check> {
        let bends = |part: Part| limits.iter().any(|l| l.bending.contains(&part));
        let rules = |p: &PartRules| {
            let mut by_code = p.by_code.clone();
            let no_row = || {
                let words = || say!("bending of the {} limits no row", p.part.words()).into();
                (!bends(p.part)).then(words)
            };
            if let Some(why) = self.not_covered.clone().or_else(no_row) {
                by_code.derivation = by_code.derivation.followed_by(why);
                by_code.status = Status::Warning;
            }
            [by_code].into_iter().chain(p.by_annex.clone())
        };
        self.parts.iter().flat_map(rules).collect()
    }

    /// Reason why the lower bound of a limit analysis decides nothing, with the numbers of the
    /// rules that do not hold.
    pub fn brittle(&self, limits: &[SenseLimits]) -> Text {
        let rules = self.checks(limits);
        let each =
            rules.iter().map(|c| say!("{}: {} ({})", c.subject.text(), c.formula(), &c.clause));
        say!(
            "no rule of rotation capacity holds, so that bolts may break before the rows have \
             yielded as limit analysis takes them to: {}; plastic global analysis may not rely on \
             the rotation of the joint (6.4); the component method needs no such rule, because \
             its rows below one with more than 1.9 F_t,Rd grow with their lever arms \
             (6.2.7.2(9))",
            Text::joined("; ", each)
        )
    }
}

/// Reason why 6.4.2 does not cover the joint: its steels or its axial force.
fn not_covered(e: &EndPlate) -> Option<Derivation> {
    let plastic = plastic(1e2 * e.beam.area, e.beam_steel.fy.mpa(), e.factors.gamma_m0);
    let most = Traced::from(SMALL_AXIAL) * Traced::force("N_pl,Rd", plastic);
    let axial = e.actions.iter().map(|a| a.at(1.0)[0][0].abs()).fold(0.0, f64::max);
    let steels = [Some(&e.plate_steel), Some(&e.beam_steel), e.column.as_ref().map(|c| &c.steel)];
    let covered = |grade: &str| EN_6_4_2_STEELS.iter().any(|g| grade.starts_with(g));
    match steels.into_iter().flatten().find(|s| !covered(&s.grade)) {
        Some(steel) => Some(say!("6.4.2 does not cover {}", &steel.grade).into()),
        None if within(axial, most.value()) => None,
        None => {
            let beyond = Line::comparison("N_Ed", axial, Relation::Above, most, Unit::Force);
            Some(Derivation::from("6.4.2 does not cover the axial force").then(beyond))
        }
    }
}
