//! Concrete and grout, detailing, and what lies outside the range of the rules.

use crate::check::{Check, CheckId, Topic};
use crate::end_plate::{Piece, beyond, not_checked, of_any_joint, unseen_loads};
use crate::eurocode::concrete::{bearing_strength, grout_fault};
use crate::eurocode::spacing::{Pattern, pattern_checks};
use crate::subject::Part;
use bracket_joint::assembly::{BaseSection, ColumnBase};
use bracket_joint::strength::Strength;

/// All of them.
pub(super) fn checks(e: &ColumnBase) -> Vec<Check> {
    let (topic, concrete) = (Topic::ComponentMethod, Part::Concrete);
    let f_jd = bearing_strength(&e.foundation, e.concrete);
    let mut out = vec![f_jd.information(topic, concrete)];
    out.extend(grout_fault(&e.foundation).map(|why| {
        let (clause, id) = ("EN 1993-1-8:2005 6.2.5(7)", CheckId::BaseGrout);
        let step = "grout of at least 0.2 f_ck, no thicker than 0.2 times the smaller width of \
                    the plate; above 50 mm as strong as the concrete";
        Check::undecided(topic, concrete, clause, id, why, step)
    }));
    // the greatest distances keep plies together against buckling and corrosion: here is no second
    // ply
    let exposed = [
        CheckId::EndDistanceExposed,
        CheckId::EdgeDistanceExposed,
        CheckId::PitchOfRowsExposed,
        CheckId::GaugeOfColumnsExposed,
    ];
    let distances = pattern_checks(Part::BasePlate, &pattern(e));
    out.extend(distances.into_iter().filter(|c| !exposed.contains(&c.id())));
    let piece = |part, thickness, steel| Piece { part, thickness, steel, welded: true };
    let of_column = column(e);
    let plate = piece(Part::BasePlate, e.thickness, &e.plate_steel);
    let pieces = of_column.iter().map(|(part, t, steel, _)| piece(*part, *t, steel));
    let parts: Vec<Piece<'_>> = std::iter::once(plate).chain(pieces).collect();
    // the holes count where the anchors bear in them
    let hole = if e.shear.anchors { e.hole } else { e.bolt.d };
    out.extend(beyond(&parts, &e.bolt, &e.grade, hole));
    let seam = |(part, t, _, throat): &Walls<'_>| (*part, *throat, e.thickness.max(*t));
    let welds: Vec<_> = of_column.iter().map(seam).filter(|(_, a, _)| *a > 0.0).collect();
    out.extend(of_any_joint(e.annex.as_deref(), e.fy_source, &e.grade, &welds));
    out.extend(unseen_loads(&e.unseen));
    out.extend(not_checked(&e.not_checked));
    out
}

/// Walls of the column: thickness, steel and throat of their welds.
type Walls<'a> = (Part, f64, &'a Strength, f64);

/// The walls of the column.
fn column(e: &ColumnBase) -> Vec<Walls<'_>> {
    match &e.section {
        BaseSection::I(p) => vec![
            (Part::ColumnFlange, p.tf, &e.flange_steel, e.flange_throat),
            (Part::ColumnWeb, p.tw, &e.web_steel, e.web_throat),
        ],
        BaseSection::Rectangular { t, .. } | BaseSection::Circular { t, .. } => {
            vec![(Part::ColumnWall, *t, &e.flange_steel, e.flange_throat)]
        }
    }
}

/// Distances of the anchors in the plate.
fn pattern(e: &ColumnBase) -> Pattern {
    let steps = |of: &[f64]| {
        let each = || of.windows(2).map(|w| w[1] - w[0]);
        let most = each().fold(0.0, f64::max);
        (most > 0.0).then(|| [each().fold(f64::INFINITY, f64::min), most])
    };
    let half = 0.5 * e.plate[1];
    let ends = e.rows.iter().map(|x| (e.to_edge(1.0) - x).min(e.to_edge(-1.0) + x));
    let edges = e.across.iter().map(|y| (half - y).min(half + y));
    Pattern {
        d0: e.hole,
        thickness: e.thickness,
        e1: ends.reduce(f64::min),
        e2: edges.reduce(f64::min),
        p1: steps(&e.rows),
        p2: steps(&e.across).map(|[least, _]| least),
    }
}
