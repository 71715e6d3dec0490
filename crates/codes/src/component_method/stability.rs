//! Components of a joint that may buckle before they yield.

use super::beam;
use super::column_web::{self, ShearPanel};
use super::compressed_zone::CompressedZone;
use super::joint::EndPlateJoint;
use super::rows::Rows;
use crate::check::{Unit, within};
use crate::eurocode::section::{Class, epsilon};
use crate::formula::{Derivation, Formula, Line, Number, Relation, Traced};
use bracket_joint::assembly::Way;

/// A component whose resistance, or whose coverage by the code, depends on buckling.
#[derive(Clone, Debug, PartialEq)]
pub struct Stability {
    /// The component that may buckle, with its slenderness and the limit that it exceeds.
    pub why: Derivation,
    /// Clause.
    pub clause: &'static str,
    /// True: the resistance of the component contains the reduction, so the component method covers
    /// it. False: the code gives no design resistance, and the component method alone cannot
    /// conclude OK.
    pub covered: bool,
    /// What would remove the doubt.
    pub step: &'static str,
}

/// What keeps a column web from buckling under a flange.
const STIFFER_WEB: &str = "a column with a thicker web, or thicker stiffeners";

/// The components that may buckle before they yield.
pub(super) fn stability(
    joint: &EndPlateJoint,
    rows: &Rows<'_>,
    panel: Option<&ShearPanel>,
) -> Vec<Stability> {
    let mut out = Vec::new();
    if let Some(c) = &joint.column {
        let zone = CompressedZone::new(joint, c, Way::Down, rows.shear_area());
        let web = zone.web;
        if c.stiffener == 0.0 && web.buckling() < 1.0 {
            out.push(Stability {
                why: web.buckles("the column web buckles under the compressed flange"),
                clause: "EN 1993-1-8:2005 6.2.6.2",
                covered: true,
                step: STIFFER_WEB,
            });
        }
        let of_cross = zone.resistance();
        if let Some(chi) = of_cross.step("χ").filter(|chi| *chi < 1.0) {
            let words = "the stiffened column web buckles under the compressed flange";
            let chi = Formula::new("χ", Traced::number("χ", chi), Unit::Number);
            out.push(Stability {
                why: Derivation::from(words).then(chi),
                clause: "EN 1993-1-8:2005 6.2.6.2(4)",
                covered: true,
                step: STIFFER_WEB,
            });
        }
        let outstand = 0.5 * (c.section.b - c.section.tw);
        let limit = || Traced::from(column_web::STIFFENER_SLENDERNESS) * eps(c.fy);
        if c.stiffener > 0.0 && !within(outstand, limit().value() * c.stiffener) {
            let words = "the stiffeners of the column buckle about their weld";
            let ratio = exceeds("c/t_s", outstand / c.stiffener, limit());
            out.push(Stability {
                why: Derivation::from(words).then(ratio),
                clause: "EN 1993-1-5:2006 9.2.1(8)",
                covered: false,
                step: "thicker stiffeners",
            });
        }
        if let Some(panel) = panel.filter(|p| p.slender()) {
            let limit = Traced::from(column_web::SHEAR_SLENDERNESS) * eps(c.fy);
            let ratio = exceeds("d_c/t_w", panel.slenderness().0, limit);
            out.push(Stability {
                why: Derivation::from("the column web panel is too slender in shear").then(ratio),
                clause: "EN 1993-1-8:2005 6.2.6.1(1)",
                covered: false,
                step: "a web doubler or a column with a thicker web",
            });
        }
    }
    if beam::end_class(&joint.beam) == Class::Slender {
        let why = "the beam is of class 4 in bending: its compressed flange or web buckles before \
                   it yields"
            .into();
        out.push(Stability {
            why,
            clause: "EN 1993-1-1:2005 5.5.2",
            covered: false,
            step: "a beam of class 1 to 3",
        });
    }
    out
}

/// A slenderness that exceeds its limit.
fn exceeds(symbol: &'static str, value: f64, limit: Traced) -> Line {
    Line::comparison(symbol, value, Relation::Above, limit, Unit::Number)
}

/// ε of a yield strength.
fn eps(fy: f64) -> Traced {
    Traced::number("ε", epsilon(fy))
}
