//! A sloping rafter with its haunch in the drawing of an end plate.

use crate::draw::scale::Scale;
use crate::draw::svg::{Drawing, Pen};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::check::number as n;
use bracket_joint::assembly::content::{Extent, PieceKind};
use bracket_joint::assembly::{Content, EndPlate};

/// Length of the rafter beyond the end plate in the side view \[mm\].
pub fn stub(e: &EndPlate) -> f64 {
    let haunch = e.rafter.as_ref().and_then(|r| Some((r, r.haunch.as_ref()?)));
    let reach = haunch.map_or(0.0, |(r, h)| h.length * r.slope.cos());
    reach + 0.8 * e.beam.h
}

/// Height above the middle of the depth at which the rafter leaves the side view \[mm\], its upper
/// and its lower edge.
pub fn far_end(e: &EndPlate) -> [f64; 2] {
    let Some(r) = &e.rafter else { return [0.5 * e.beam.h, -0.5 * e.beam.h] };
    let top = 0.5 * r.depth + stub(e) * r.slope.tan();
    [top, top - e.beam.h / r.slope.cos()]
}

/// The side view of rafter and haunch as the geometry has them, as far as `window` reaches; `fills`
/// are those of webs and of flanges.
pub fn side_view(d: &mut Drawing, s: &Scale, joint: &Content, window: &Extent, fills: [&str; 2]) {
    let [web, flange] = fills;
    let members = joint.members.iter().filter(|m| m.turn.is_some());
    let pieces = joint.pieces.iter().filter(|p| p.kind == PieceKind::Haunch);
    let outlined = pieces.clone().filter(|p| p.outline.is_some()).flat_map(|p| p.solids());
    // flanges lie over webs
    let mut solids: Vec<_> = members.flat_map(|m| m.solids()).map(|b| (b, web)).collect();
    solids.extend(outlined.map(|b| (b, web)));
    solids.extend(
        pieces.filter(|p| p.outline.is_none()).flat_map(|p| p.solids()).map(|b| (b, flange)),
    );
    for (block, fill) in solids {
        if let Some(cut) = block.within(window).filter(|b| b.axis == 1) {
            // the axes after y are z and x
            let corners: Vec<[f64; 2]> = cut.polygon.iter().map(|p| s.at(p[1], p[0])).collect();
            d.polygon(Pen::Edge, fill, &corners);
        }
    }
}

/// Slope and haunch in words.
pub fn legend(e: &EndPlate) -> Vec<Text> {
    let Some(r) = &e.rafter else { return Vec::new() };
    let degrees = |angle: f64| n((angle.to_degrees() * 100.0).round() / 100.0);
    let mut out = vec![match r.slope < 0.0 {
        false => say!("slope of the rafter {}°", degrees(r.slope)),
        true => say!("slope of the rafter {}°, falling from the joint", degrees(-r.slope)),
    }];
    if let Some(h) = &r.haunch {
        out.push(say!(
            "haunch {} long, depth at the plate with the rafter {}, flange {} at {}° to the \
             rafter, \
             web {}",
            n(h.length),
            n(r.depth),
            format!("{} × {}", n(h.flange), n(h.width)),
            degrees(h.angle),
            n(h.web)
        ));
    }
    out
}
