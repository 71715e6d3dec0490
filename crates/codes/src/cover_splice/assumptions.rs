//! What the checks of a splice take for granted, and what lies outside the range of the rules.

use crate::check::{Check, CheckId, Topic};
use crate::end_plate::{Piece, beyond};
use crate::formula::Derivation;
use crate::subject::Part;
use bracket_joint::assembly::{CoverSplice, SplicedMember};

/// How the parts share the actions.
pub(super) fn assumptions(e: &CoverSplice) -> Vec<Check> {
    let (clause, id) = ("EN 1993-1-8:2005 6.2.7.1(16), 3.12", CheckId::SpliceShares);
    let shares = "flanges and web take their elastic shares of N and My, the web takes Vz with its \
                  moment about the centre of its bolts; nothing is shed from the web to the \
                  flanges";
    let planes = "every shear plane of a bolt takes the same force, so that the outer cover and \
                  the inner covers of a flange carry one half each; the distance of the covers \
                  from the flange is left out";
    let mut words = Derivation::from(shares);
    if e.inner.is_some() {
        words = words.then(planes);
    }
    if e.left != e.right {
        words = words.then(
            "the members differ: bolts and covers are checked under the shares of either member",
        );
    }
    vec![Check::assumption(Topic::Bolts, Part::Joint, clause, id, words)]
}

/// Steels, thicknesses, bolts and holes outside the range of the rules.
pub(super) fn outside_range(e: &CoverSplice) -> Vec<Check> {
    let piece = |part, thickness, steel| Piece { part, thickness, steel, welded: false };
    let member = |m: &'_ SplicedMember| [m.section.tf, m.section.tw];
    let mut parts = vec![
        piece(Part::OuterCover, e.outer.thickness, &e.outer.steel),
        piece(Part::WebCovers, e.web.thickness, &e.web.steel),
    ];
    parts.extend(
        e.inner.as_ref().map(|i| piece(Part::InnerCovers, i.plate.thickness, &i.plate.steel)),
    );
    let mut members = vec![&e.left];
    if e.left != e.right {
        members.push(&e.right);
    }
    for m in members {
        let [tf, tw] = member(m);
        parts.push(piece(Part::SplicedFlange, tf, &m.flange_steel));
        parts.push(piece(Part::SplicedWeb, tw, &m.web_steel));
    }
    beyond(&parts, &e.bolt, &e.grade, e.hole)
}
