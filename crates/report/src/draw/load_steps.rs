//! The load steps of a case: load against the rotation of the loaded end, or against its
//! displacement where nothing turns.

use crate::document::picture::PictureRef;
use crate::draw::axes::Axes;
use crate::draw::svg::{Anchor, Drawing, LINE, Pen};
use crate::result::case_result::CaseResult;
use crate::result::load_step::LoadStep;
use crate::result::quantity::LoadSize;
use bracket_base::say;
use bracket_base::words::Text;

/// Rotation below which a loaded end counts as not turned \[rad\].
const STILL: f64 = 1e-9;
const POINT: &str = "#8a5a00";

/// The drawing with the text of its file; `None` with fewer than two steps that move.
pub fn drawing(case: &CaseResult, stem: &str) -> Option<(PictureRef, String)> {
    let steps = &case.load_steps;
    let turns = steps.iter().filter_map(LoadStep::turn).any(|t| t > STILL);
    let moved = |s: &LoadStep| if turns { s.turn() } else { s.displacement() };
    let scale = if turns { 1e3 } else { 1.0 };
    let loaded = |s: &LoadStep| match s.load {
        Some(LoadSize::Force(v)) => 1e-3 * v,
        Some(LoadSize::Moment(v)) => 1e-6 * v,
        None => s.factor,
    };
    let points: Vec<[f64; 2]> =
        steps.iter().filter_map(|s| Some([scale * moved(s)?, loaded(s)])).collect();
    if points.len() < 2 {
        return None;
    }
    // a bound is of the motion of the load: a rotation for a moment, a displacement for a force
    let same = |s: &&LoadStep| matches!(s.load, Some(LoadSize::Moment(_))) == turns;
    let bounds: Vec<([f64; 2], f64)> = steps
        .iter()
        .filter(same)
        .filter_map(|s| {
            let ends = [s.load_displacement_at_least?, s.load_displacement_at_most?];
            Some((ends.map(|x| scale * x), loaded(s)))
        })
        .collect();
    let ends = bounds.iter().map(|([_, most], load)| [*most, *load]);
    let largest = points
        .iter()
        .copied()
        .chain(ends)
        .fold([0.0f64; 2], |r, p| [r[0].max(p[0]), r[1].max(p[1])]);
    let axes = Axes::quadrant(largest);
    let mut d = Drawing::default();
    for ([least, most], load) in &bounds {
        d.line(Pen::Thin, axes.at([least.max(0.0), *load]), axes.at([*most, *load]));
    }
    let mut path = vec![axes.at([0.0; 2])];
    path.extend(points.iter().map(|p| axes.at(*p)));
    path.windows(2).for_each(|w| d.line(Pen::Edge, w[0], w[1]));
    points.iter().for_each(|p| d.circle(Pen::Edge, POINT, axes.at(*p), 3.0));
    let across = match turns {
        true => "rotation of the loaded end [mrad]",
        false => "displacement of the loaded end [mm]",
    };
    let upwards = match steps.iter().find_map(|s| s.load) {
        Some(LoadSize::Force(_)) => "force [kN]",
        Some(LoadSize::Moment(_)) => "moment [kN m]",
        None => "load factor",
    };
    let [left, top] = axes.draw(&mut d, [across.into(), upwards.into()]);
    let mut legend: Vec<(Text, Pen)> =
        vec![("field of the upper bound, an estimate".into(), Pen::Edge)];
    if !bounds.is_empty() {
        legend.push(("bracket from the energies of the steps".into(), Pen::Thin));
    }
    for (i, (text, pen)) in legend.into_iter().enumerate() {
        let y = top + (2.0 + 1.5 * i as f64) * LINE;
        d.line(pen, [left, y + 6.0], [left + 22.0, y + 6.0]);
        d.text([left + 30.0, y + 6.0], Anchor::Start, text);
    }
    let title = say!("Load steps of {}", &case.name);
    Some(d.finish(title.clone()).picture(format!("load_steps_{stem}.svg"), title))
}
