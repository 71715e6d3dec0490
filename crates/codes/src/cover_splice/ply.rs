//! The plates that a group of bolts passes, with the distances of the bolts in them.

use super::distances::{ends, from_ends, pitch};
use super::side::{Side, flange_part};
use crate::check::{largest, within};
use crate::eurocode::bearing::{Along, Bearing, Hole};
use crate::eurocode::holes::Clearance;
use crate::formula::Number;
use crate::subject::Part;
use crate::worked::Worked;
use bracket_joint::assembly::{CoverSplice, Way};
use bracket_joint::strength::Strength;

/// Kind of the holes for bearing: small bolts with 2 mm clearance count as in oversize ones, on the
/// safe side of 3.6.1(5).
pub(super) fn hole_kind(e: &CoverSplice) -> Hole {
    match Clearance::of(&e.bolt, e.hole) {
        Clearance::Normal => Hole::Normal,
        _ => Hole::Oversize,
    }
}

/// A plate on which bolts bear in one direction. Lengths in mm; infinite where there is no such
/// distance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ply<'a> {
    /// What it is.
    pub part: Part,
    /// Thickness.
    pub thickness: f64,
    /// Its steel.
    pub steel: &'a Strength,
    /// Share of the force of a bolt that it takes: 1, or 1/2 beside another one.
    pub share: f64,
    /// End distance towards which the force may press.
    pub end: f64,
    /// Smallest pitch along the force.
    pub pitch: f64,
    /// Edge distance across the force.
    pub e2: f64,
    /// Smallest pitch across the force.
    pub p2: f64,
}

impl Ply<'_> {
    /// A bolt of it at a position along the force.
    fn at(&self, e: &CoverSplice, along: Along) -> Bearing {
        Bearing {
            along,
            e2: self.e2,
            p2: self.p2,
            hole: hole_kind(e),
            d: e.bolt.d,
            d0: e.hole,
            thickness: self.thickness,
            fu: self.steel.fu.mpa(),
            fub: e.grade.fub,
        }
    }

    /// Least bearing resistance at its bolts \[N\]; `pressed` to the end, or away from it.
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 3.4: end bolts by their end distance, inner bolts by their pitch. A
    /// bolt that presses no end and no other hole has α_d = 1.
    pub fn bearing(&self, e: &CoverSplice, pressed: bool) -> Worked {
        let at = |along| self.at(e, along).resistance(e.factors.gamma_m2);
        let end = Along::End { e1: if pressed { self.end } else { f64::INFINITY } };
        let inner = self.pitch.is_finite().then_some(Along::Inner { p1: self.pitch });
        let each = [Some(end), inner].into_iter().flatten().map(at);
        largest(each, |w| -w.value).unwrap_or_else(|| at(end))
    }

    /// [`Ply::bearing`] of a single lap joint with one row of bolts, no more than `1.5 f_u d
    /// t/γ_M2`.
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.6.1(10).
    pub fn single_lap(&self, e: &CoverSplice, pressed: bool) -> Worked {
        let worked = self.bearing(e, pressed);
        // the position along the force plays no part in it
        let anywhere = self.at(e, Along::End { e1: self.end });
        let limit = anywhere.most_of_one_row(e.factors.gamma_m2);
        if within(worked.value, limit.value()) {
            return worked;
        }
        let least = worked.traced().min(limit);
        worked.then("single lap joint with one row of bolts (3.6.1(10))").becomes("F_b,Rd", least)
    }
}

/// The plates of the bolts of a flange, along the member, under tension or compression.
pub(super) fn of_flange<'a>(
    e: &'a CoverSplice,
    side: &Side<'a>,
    flange: Way,
    tension: bool,
) -> Vec<Ply<'a>> {
    let (columns, rows) = (e.flange_columns(), &e.flange_rows);
    let [first, last] = ends(rows);
    let outermost = e.gauges.last().copied().unwrap_or(0.0);
    let (p1, share) = (pitch(rows), 1.0 / f64::from(e.flange_planes()));
    // compression presses the first bolts of a cover to those across the gap
    let in_cover = if tension { p1 } else { p1.min(2.0 * first) };
    let mut out = vec![
        Ply {
            part: Part::OuterCover,
            thickness: e.outer.thickness,
            steel: &e.outer.steel,
            share,
            end: 0.5 * e.outer.length - last,
            pitch: in_cover,
            e2: 0.5 * (e.outer.width - outermost),
            p2: pitch(&columns),
        },
        Ply {
            part: flange_part(flange),
            thickness: side.section.tf,
            steel: &side.member.flange_steel,
            share: 1.0,
            end: first - 0.5 * e.gap,
            pitch: p1,
            e2: 0.5 * (side.section.b - outermost),
            p2: pitch(&columns),
        },
    ];
    out.extend(e.inner.as_ref().map(|inner| {
        let strip: Vec<f64> = columns.iter().copied().filter(|y| *y > 0.0).collect();
        Ply {
            part: Part::InnerCovers,
            thickness: inner.plate.thickness,
            steel: &inner.plate.steel,
            share,
            end: 0.5 * inner.plate.length - last,
            pitch: in_cover,
            e2: from_ends(&strip, inner.from, inner.from + inner.plate.width),
            p2: pitch(&strip),
        }
    }));
    out
}

/// The web and one of its covers, along the member and across it.
pub(super) fn of_web<'a>(e: &'a CoverSplice, side: &Side<'a>) -> [[Ply<'a>; 2]; 2] {
    let (columns, rows) = (&e.web_columns, &e.web_rows);
    let [first, last] = ends(columns);
    let half = 0.5 * e.web.width;
    let edge = from_ends(rows, e.web_middle - half, e.web_middle + half);
    let (p_x, p_z) = (pitch(columns), pitch(rows));
    let cover = |end, pitch, e2, p2| Ply {
        part: Part::WebCovers,
        thickness: e.web.thickness,
        steel: &e.web.steel,
        share: 0.5,
        end,
        pitch,
        e2,
        p2,
    };
    let web = |end, pitch, e2, p2| Ply {
        part: Part::SplicedWeb,
        thickness: side.section.tw,
        steel: &side.member.web_steel,
        share: 1.0,
        end,
        pitch,
        e2,
        p2,
    };
    let (to_end, to_gap) = (0.5 * e.web.length - last, first - 0.5 * e.gap);
    // the flanges hold the web above and below
    let none = f64::INFINITY;
    [
        [web(to_gap, p_x, none, p_z), cover(to_end, p_x.min(2.0 * first), edge, p_z)],
        [web(none, p_z, to_gap, p_x), cover(edge, p_z, to_end, p_x)],
    ]
}
