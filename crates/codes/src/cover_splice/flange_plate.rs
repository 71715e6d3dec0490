//! The plates of a flange splice as sections across the force: the flange and its covers.

use super::distances::{ends, span};
use super::side::{Side, flange_part};
use crate::eurocode::block_tearing::Blocks;
use crate::eurocode::net_section::NetSection;
use crate::formula::Traced;
use crate::subject::Part;
use bracket_joint::assembly::{CoverSplice, Way};
use bracket_joint::strength::Strength;

/// A plate, or a pair of plates alike, that carries the force of a flange. Lengths in mm.
#[derive(Clone, Debug)]
pub(super) struct FlangePlate<'a> {
    /// What it is.
    pub part: Part,
    /// How many there are.
    pub count: f64,
    /// Width of each.
    pub width: f64,
    /// Thickness.
    pub thickness: f64,
    /// Its steel.
    pub steel: &'a Strength,
    /// Share of the force of the flange that it carries.
    pub share: f64,
    /// Net lengths in tension and in shear of the blocks that the bolts can tear out of all
    /// plates together, with their number.
    pub blocks: Vec<[f64; 3]>,
}

impl FlangePlate<'_> {
    /// Its section across the force.
    pub fn section(&self, e: &CoverSplice) -> NetSection<'_> {
        let mut gross = Traced::length("b", self.width) * Traced::length("t", self.thickness);
        if self.count > 1.0 {
            gross = Traced::from(self.count) * gross;
        }
        let holes = Traced::number("n_h", 2.0 * e.gauges.len() as f64);
        NetSection {
            gross,
            holes: holes * Traced::length("d0", e.hole) * Traced::length("t", self.thickness),
            steel: self.steel,
            gamma_m0: e.factors.gamma_m0,
            gamma_m2: e.factors.gamma_m2,
        }
    }

    /// The blocks that its bolts can tear out.
    pub fn torn(&self) -> impl Iterator<Item = Blocks> {
        self.blocks.iter().map(|[tension, shear, count]| Blocks {
            count: *count,
            tension: *tension,
            shear: *shear,
            thickness: self.thickness,
            fy: self.steel.fy.mpa(),
            fu: self.steel.fu.mpa(),
        })
    }

    /// Whether it is a cover.
    pub fn is_cover(&self) -> bool {
        matches!(self.part, Part::OuterCover | Part::InnerCovers)
    }
}

/// The plates of a flange splice. Each shear plane of a bolt takes the same force, so that the
/// outer cover and the inner pair carry one half each.
///
/// # Source
/// Blocks: EN 1993-1-8:2005 3.10.2, Figure 3.8. They hold all bolts of one side: between the
/// outermost columns, or outside the innermost ones; the web holds the middle of a flange.
pub(super) fn plates<'a>(e: &'a CoverSplice, side: &Side<'a>, flange: Way) -> Vec<FlangePlate<'a>> {
    let [first, last] = ends(&e.flange_rows);
    let (rows, pairs, d0) = (e.flange_rows.len() as f64, e.gauges.len() as f64, e.hole);
    let [inner, outer] = ends(&e.gauges);
    // one line of holes from the end that the tension tears
    let line = |end: f64| end + span(&e.flange_rows) - (rows - 0.5) * d0;
    let outside =
        |width: f64, end: f64| [0.5 * (width - inner) - (pairs - 0.5) * d0, line(end), 2.0];
    let between = |end: f64| [outer - (2.0 * pairs - 1.0) * d0, 2.0 * line(end), 1.0];
    let (cover, share) = (&e.outer, 1.0 / f64::from(e.flange_planes()));
    let end = 0.5 * cover.length - last;
    let (b, to_gap) = (side.section.b, first - 0.5 * e.gap);
    let mut out = vec![
        FlangePlate {
            part: flange_part(flange),
            count: 1.0,
            width: b,
            thickness: side.section.tf,
            steel: &side.member.flange_steel,
            share: 1.0,
            blocks: vec![outside(b, to_gap)],
        },
        FlangePlate {
            part: Part::OuterCover,
            count: 1.0,
            width: cover.width,
            thickness: cover.thickness,
            steel: &cover.steel,
            share,
            blocks: vec![between(end), outside(cover.width, end)],
        },
    ];
    out.extend(e.inner.as_ref().map(|pair| {
        let (plate, from) = (&pair.plate, pair.from);
        let end = 0.5 * plate.length - last;
        let to_edge = |width: f64| [width - (pairs - 0.5) * d0, line(end), 2.0];
        let outward = to_edge(from + plate.width - 0.5 * inner);
        let mut blocks = vec![outward, to_edge(0.5 * outer - from)];
        if pairs > 1.0 {
            blocks.push([0.5 * (outer - inner) - (pairs - 1.0) * d0, 2.0 * line(end), 2.0]);
        }
        FlangePlate {
            part: Part::InnerCovers,
            count: 2.0,
            width: plate.width,
            thickness: plate.thickness,
            steel: &plate.steel,
            share,
            blocks,
        }
    }));
    out
}
