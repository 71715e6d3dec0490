//! Drawings of an end plate joint: side view and front view with dimensions, and a sketch of the
//! actions with their signs.
//!
//! They show the input of the hand checks (`assembly::EndPlate`), so that the reader sees a wrong
//! value of a spec, and the bolts and further plates of the geometry (`assembly::Content`).

use crate::draw::rafter_drawing;
use crate::draw::scale::Scale;
use crate::draw::svg::{Anchor, Drawing, LINE, Pen, Svg};
use crate::draw::weld_symbol::{Sides, weld_symbol};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::check::{Unit, number as n};
use bracket_codes::end_plate::{PartItem, PartSize, parts_list};
use bracket_joint::assembly::content::PieceKind;
use bracket_joint::assembly::{Content, EndPlate, PlaneActions};

/// Height of the joint on the page \[pixels\].
const HEIGHT: f64 = 380.0;
/// Largest width of a view \[pixels\].
const WIDTH: f64 = 420.0;
const STEEL: &str = "#eef1f4";
const BOLT: &str = "#c9d3dc";
const FURTHER: &str = "#f3e3c3";
const MARGIN: f64 = 24.0;
/// Width of a column from which a weld symbol has room in its panel \[pixels\].
const WELD_ROOM: f64 = 75.0;
/// Load cases whose values the sketch of the actions gives.
const MOST_VALUES: usize = 6;

/// Side view and front view of a joint with what it is made of. `length` is the nominal length of
/// the bolts, if a suitable length is stocked.
pub fn views(e: &EndPlate, joint: &Content, length: Option<f64>) -> Svg {
    sheet(e, joint, length).finish("Joint, side view and front view of the end plate")
}

/// Actions at the member ends with their positive senses, and their values.
pub fn actions(e: &EndPlate) -> Svg {
    loads(e).finish("Actions at the member ends, positive senses")
}

/// Upper and lower end of the drawing \[mm\]: the column continues beyond the plate.
fn extent(e: &EndPlate) -> [f64; 2] {
    let half = 0.5 * e.depth();
    let beyond = if e.column.is_some() { 0.22 * e.beam.h } else { 0.0 };
    let [top, bottom] = rafter_drawing::far_end(e);
    [e.bottom.min(-half).min(bottom) - beyond, e.top.max(half).max(top) + beyond]
}

fn sheet(e: &EndPlate, joint: &Content, length: Option<f64>) -> Drawing {
    let mut d = Drawing::default();
    let [low, high] = extent(e);
    let stub = rafter_drawing::stub(e);
    let depth = e.column.as_ref().map_or(0.0, |c| c.section.h);
    // a splice has both plates, a column one or two
    let both = e.column.is_none() || joint.end_plates() > 1;
    let right = 0.5 * depth + e.thickness + stub;
    let left = if both { right } else { 0.5 * depth };
    let k = (HEIGHT / (high - low)).min(WIDTH / (left + right));
    let top = MARGIN + 1.5 * LINE;
    let side = Scale { k, origin: [MARGIN + 40.0 + k * left, top + k * high] };
    d.text([side.origin[0], MARGIN], Anchor::Middle, "side view");
    side_view(&mut d, e, joint, &side, both, [low, high]);
    let wide = e.width.max(e.column.as_ref().map_or(0.0, |c| c.section.b));
    let centre = side.origin[0] + k * right + 150.0 + 0.5 * k * wide;
    let front = Scale { k, origin: [centre, side.origin[1]] };
    d.text([centre, MARGIN], Anchor::Middle, "end plate, seen from the beam");
    front_view(&mut d, e, joint, &front, [low, high]);
    let below = side.at(0.0, low)[1] + 5.5 * LINE;
    for (i, text) in legend(e, joint, both, length).into_iter().enumerate() {
        d.text([MARGIN, below + LINE * i as f64], Anchor::Start, text);
    }
    d
}

fn side_view(
    d: &mut Drawing,
    e: &EndPlate,
    joint: &Content,
    s: &Scale,
    both: bool,
    [low, high]: [f64; 2],
) {
    let half = 0.5 * e.depth();
    let levels = e.flange_levels();
    let face = e.column.as_ref().map_or(0.0, |c| 0.5 * c.section.h);
    if let Some(c) = &e.column {
        let (h, tf) = (face, c.section.tf);
        // it ends in the drawing, or continues beyond it
        let ends = [c.below.map(|z| -z), c.above];
        let inside = ends.map(|z| z.filter(|z| low < *z && *z < high));
        let [foot, head] = [inside[0].unwrap_or(low), inside[1].unwrap_or(high)];
        d.rectangle(Pen::None, STEEL, s.at(-h, foot), s.at(h, head));
        for x in [-h, -h + tf, h - tf, h] {
            d.line(Pen::Edge, s.at(x, foot), s.at(x, head));
        }
        if c.doubler > 0.0 {
            let inner = h - tf - c.section.r;
            d.rectangle(Pen::Hidden, "none", s.at(-inner, e.bottom), s.at(inner, e.top));
        }
        if c.stiffener > 0.0 {
            for z in levels {
                let t = 0.5 * c.stiffener;
                d.rectangle(Pen::Edge, BOLT, s.at(-h + tf, z - t), s.at(h - tf, z + t));
            }
        }
        for (z, ends) in [(foot, inside[0]), (head, inside[1])] {
            match ends {
                Some(_) => d.line(Pen::Edge, s.at(-h, z), s.at(h, z)),
                None => break_line(d, s.at(-h, z), s.at(h, z)),
            }
        }
    }
    let sides: &[f64] = if both { &[1.0, -1.0] } else { &[1.0] };
    let stub = rafter_drawing::stub(e);
    let [top, bottom] = rafter_drawing::far_end(e);
    for &side in sides {
        let (start, end) = (side * (face + e.thickness), side * (face + e.thickness + stub));
        d.rectangle(Pen::Edge, STEEL, s.at(side * face, e.bottom), s.at(start, e.top));
        if e.rafter.is_some() {
            let x = [start.min(end), start.max(end)];
            let window = [x, [-e.width, e.width], [low, high]];
            rafter_drawing::side_view(d, s, joint, &window, [STEEL, BOLT]);
        } else {
            d.rectangle(Pen::None, STEEL, s.at(start, -half), s.at(end, half));
            for z in [half, half - e.beam.tf, -half + e.beam.tf, -half] {
                d.line(Pen::Edge, s.at(start, z), s.at(end, z));
            }
        }
        break_line(d, s.at(end, bottom), s.at(end, top));
    }
    let welds = e.column.as_ref().filter(|c| c.stiffener > 0.0 && 2.0 * face * s.k > WELD_ROOM);
    if let Some(c) = welds {
        // inside the panel, to the end of the lower stiffener on the side of the beam
        let end = [face - c.section.tf, levels[0] + 0.5 * c.stiffener];
        let [x, _] = s.at(-face + c.section.tf, 0.0);
        weld_symbol(
            d,
            s.at(end[0], end[1]),
            [x + 6.0, s.at(0.0, -0.4 * half)[1]],
            c.stiffener_throat,
            Sides::Both,
        );
    }
    let [start, end] = [0.0, stub].map(|x| face + e.thickness + x);
    let place = s.at(start + 0.32 * (end - start), 0.0);
    let at = [place[0], s.at(0.0, high)[1]];
    weld_symbol(d, s.at(start, half), at, e.flange_throat, Sides::Both);
    weld_symbol(d, s.at(start, 0.1 * half), place, e.web_throat, Sides::Both);
    let reach = face + e.thickness + stub;
    let [from, to] = [if both { -reach } else { -face }, reach];
    further(d, s, joint, 0, [from, to], [low, high]);
    // drawn last, over the parts that they pass through
    let mut drawn: Vec<[f64; 3]> = Vec::new();
    for b in joint.fasteners.iter().filter(|b| b.axis == 0) {
        let place = [b.head[0], b.head[0] + b.toward * b.grip(), b.head[2]];
        if !drawn.contains(&place) {
            drawn.push(place);
            bolt(d, e, s, b.toward, [place[0], place[1]], place[2]);
        }
    }
    // below: column and plate, or both plates
    let from = s.at(0.0, low)[1];
    let (points, show) = match &e.column {
        Some(c) => (vec![-face, face, face + e.thickness], vec![n(c.section.h), n(e.thickness)]),
        None => (vec![-e.thickness, 0.0, e.thickness], vec![n(e.thickness); 2]),
    };
    let xs: Vec<f64> = points.iter().map(|x| s.at(*x, 0.0)[0]).collect();
    d.horizontal_chain(from + 22.0, from, &xs, &show);
    let [x, _] = s.at(face + e.thickness + stub, 0.0);
    let ys = [bottom, top].map(|z| s.at(0.0, z)[1]);
    d.vertical_chain(x + 22.0, true, x, &ys, &[n(top - bottom)]);
}

/// A bolt in the side view with the bearing faces of head and nut. `toward` is the sign of the way
/// from head to nut.
fn bolt(d: &mut Drawing, e: &EndPlate, s: &Scale, toward: f64, [head, nut]: [f64; 2], z: f64) {
    let b = &e.bolt;
    let mut piece = |x: [f64; 2], half: f64| {
        d.rectangle(Pen::Edge, BOLT, s.at(x[0], z - half), s.at(x[1], z + half));
    };
    piece([head, nut], 0.5 * b.d);
    piece([head - toward * b.head_height, head], 0.5 * b.head_width);
    piece([nut, nut + toward * b.nut_height], 0.5 * b.nut_width);
}

/// The plates that the hand checks do not know, as far as they lie in the drawing: `across` is the
/// axis that is horizontal on the page, `wide` its interval.
fn further(
    d: &mut Drawing,
    s: &Scale,
    joint: &Content,
    across: usize,
    wide: [f64; 2],
    high: [f64; 2],
) {
    let within = |x: [f64; 2], limits: [f64; 2]| {
        let cut = [x[0].max(limits[0]), x[1].min(limits[1])];
        (cut[0] < cut[1]).then_some(cut)
    };
    for p in joint.pieces.iter().filter(|p| p.kind == PieceKind::Other) {
        let e = p.bounds();
        if let (Some(x), Some(z)) = (within(e[across], wide), within(e[2], high)) {
            d.rectangle(Pen::Edge, FURTHER, s.at(x[0], z[0]), s.at(x[1], z[1]));
        }
    }
}

/// The end of a member that continues: a line with a zigzag in its middle.
fn break_line(d: &mut Drawing, a: [f64; 2], b: [f64; 2]) {
    let at = |t: f64, off: f64| {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy).max(1.0);
        [a[0] + t * dx - off * dy / length, a[1] + t * dy + off * dx / length]
    };
    let path =
        [at(0.0, 0.0), at(0.44, 0.0), at(0.48, 5.0), at(0.52, -5.0), at(0.56, 0.0), at(1.0, 0.0)];
    path.windows(2).for_each(|w| d.line(Pen::Edge, w[0], w[1]));
}

fn front_view(d: &mut Drawing, e: &EndPlate, joint: &Content, s: &Scale, [low, high]: [f64; 2]) {
    let (half, b) = (0.5 * e.depth(), &e.beam);
    if let Some(c) = &e.column {
        for y in [-0.5, 0.5].map(|y| y * c.section.b) {
            d.line(Pen::Hidden, s.at(y, low), s.at(y, high));
        }
    }
    let w = 0.5 * e.width;
    d.rectangle(Pen::Edge, STEEL, s.at(-w, e.bottom), s.at(w, e.top));
    let flanges = e.flanges();
    let haunch = e.rafter.as_ref().and_then(|r| r.haunch.as_ref());
    // the haunch is below the lower flange of the beam
    let [width, web] = haunch.map_or([b.b, b.tw], |h| [h.width, h.web]);
    for (i, [from, to]) in flanges.iter().enumerate().rev() {
        let half = 0.5 * if i == 0 { width } else { b.b };
        d.rectangle(Pen::Edge, BOLT, s.at(-half, *from), s.at(half, *to));
    }
    for (i, pair) in flanges.windows(2).enumerate() {
        let half = 0.5 * if i == 0 { web } else { b.tw };
        d.rectangle(Pen::Edge, BOLT, s.at(-half, pair[0][1]), s.at(half, pair[1][0]));
    }
    if e.rib > 0.0 {
        d.rectangle(Pen::Edge, BOLT, s.at(-0.5 * e.rib, half), s.at(0.5 * e.rib, e.top));
    }
    // those in front of the end plate
    let face = e.column.as_ref().map_or(0.0, |c| 0.5 * c.section.h);
    let mut front = joint.clone();
    front.pieces.retain(|p| p.bounds()[0][1] > face + e.thickness);
    further(d, s, &front, 1, [-2.0 * w, 2.0 * w], [low, high]);
    for &z in &e.rows {
        for y in e.columns() {
            // a hexagon with two vertical sides
            let r = 0.5 * e.bolt.head_corners;
            let corners: Vec<[f64; 2]> = (0..6)
                .map(|i| std::f64::consts::FRAC_PI_3 * (f64::from(i) + 0.5))
                .map(|a| s.at(y + r * a.cos(), z + r * a.sin()))
                .collect();
            d.polygon(Pen::Edge, "#ffffff", &corners);
            d.circle(Pen::Edge, BOLT, s.at(y, z), 0.5 * s.k * e.bolt.d);
            let reach = 1.5 * r;
            d.line(Pen::Thin, s.at(y - reach, z), s.at(y + reach, z));
            d.line(Pen::Thin, s.at(y, z - reach), s.at(y, z + reach));
        }
    }
    // right: ends and rows, then the total; left: the flanges of the beam
    let wide = w.max(e.column.as_ref().map_or(0.0, |c| 0.5 * c.section.b));
    let [right, left] = [s.at(wide, 0.0)[0], s.at(-wide, 0.0)[0]];
    let mut rows = e.rows.clone();
    rows.sort_by(f64::total_cmp);
    let points: Vec<f64> = [e.bottom].into_iter().chain(rows).chain([e.top]).collect();
    let chain = |points: &[f64]| -> (Vec<f64>, Vec<String>) {
        let show = points.windows(2).map(|w| n(w[1] - w[0])).collect();
        (points.iter().map(|z| s.at(0.0, *z)[1]).collect(), show)
    };
    let (ys, show) = chain(&points);
    d.vertical_chain(right + 22.0, true, right, &ys, &show);
    let (ys, show) = chain(&[e.bottom, e.top]);
    d.vertical_chain(right + 74.0, true, right + 60.0, &ys, &show);
    let underside = haunch.map(|_| flanges[1][0]);
    let points: Vec<f64> =
        [e.bottom, -half].into_iter().chain(underside).chain([half, e.top]).collect();
    let (ys, show) = chain(&points);
    d.vertical_chain(left - 22.0, false, left, &ys, &show);
    // below: edges and gauge, then the total
    let from = s.at(0.0, low)[1];
    let ys: Vec<f64> = [-w].into_iter().chain(e.columns()).chain([w]).collect();
    let show: Vec<String> = ys.windows(2).map(|w| n(w[1] - w[0])).collect();
    let xs: Vec<f64> = ys.iter().map(|y| s.at(*y, 0.0)[0]).collect();
    d.horizontal_chain(from + 16.0, from, &xs, &show);
    d.horizontal_chain(from + 52.0, from + 46.0, &[xs[0], xs[xs.len() - 1]], &[n(e.width)]);
}

/// Names and sizes of the parts.
fn legend(e: &EndPlate, joint: &Content, both: bool, length: Option<f64>) -> Vec<Text> {
    let mut out = Vec::new();
    if let Some(c) = &e.column {
        out.push(say!("column {} {}", &c.section.name, &c.steel.grade));
    }
    let (beam, steel) = (&e.beam.name, &e.beam_steel.grade);
    let size = [e.thickness, e.width, e.top - e.bottom].map(n).join(" × ");
    let plate = &e.plate_steel.grade;
    out.extend(match both {
        true => [say!("beams {} {}", beam, steel), say!("2 end plates {} {}", size, plate)],
        false => [say!("beam {} {}", beam, steel), say!("end plate {} {}", size, plate)],
    });
    out.extend(rafter_drawing::legend(e));
    let long = length.map_or(String::new(), |l| format!(" × {}", n(l)));
    let count = joint.fasteners.len();
    out.push(say!(
        "{} bolts {} {}, holes of {} mm",
        count,
        format!("{}{long}", e.bolt.size),
        &e.grade.grade,
        n(e.hole)
    ));
    if let Some(c) = &e.column {
        if c.stiffener > 0.0 {
            let clip = c.stiffener_clip;
            let s = &c.section;
            let size = [c.stiffener, 0.5 * (s.b - s.tw), s.h - 2.0 * s.tf].map(n).join(" × ");
            out.push(match clip > 0.0 {
                true => say!(
                    "stiffeners {}, corners cut by {} mm, on both sides of the column web",
                    size,
                    n(clip)
                ),
                false => say!("stiffeners {}, on both sides of the column web", size),
            });
        }
        if c.doubler > 0.0 {
            out.push(say!("web doubler of {} mm on one side (dashed)", n(c.doubler)));
        }
    }
    if e.rib > 0.0 {
        out.push(say!("rib of {} mm on the upper flange (front view)", n(e.rib)));
    }
    out.extend(further_legend(joint));
    let weld =
        |a: f64| if a > 0.0 { say!("fillet a = {}", n(a)) } else { "full penetration".into() };
    out.push(say!("welds: flanges {}, web {}", weld(e.flange_throat), weld(e.web_throat)));
    if let Some(c) = e.column.as_ref().filter(|c| c.stiffener > 0.0) {
        out.push(say!("welds of the stiffeners: {}", weld(c.stiffener_throat)));
    }
    out.push(match e.rafter {
        None => "dimensions in mm; z from the beam's axis, up".into(),
        Some(_) => "dimensions in mm; z from the middle of the depth at the end plate, up".into(),
    });
    out
}

/// The plates that the hand checks do not know.
fn further_legend(joint: &Content) -> Vec<Text> {
    let mut further = joint.clone();
    further.fasteners.clear();
    further.pieces.retain(|p| p.kind == PieceKind::Other);
    let line = |i: PartItem| {
        let PartSize::Plate(sizes) = i.size else { return None };
        let sizes = sizes.map(n).join(" × ");
        Some(say!("{} × {} {} {} (not in the checks)", i.count, &i.part, sizes, &i.steel))
    };
    parts_list(&further).into_iter().filter_map(line).collect()
}

/// The joint as lines, an arrow for every positive action, and the values of the load cases.
fn loads(e: &EndPlate) -> Drawing {
    let mut d = Drawing::default();
    let ends: Vec<(&str, f64)> = e.actions.iter().fold(Vec::new(), |mut ends, a| {
        let end = (a.end.as_str(), a.outward);
        if !ends.contains(&end) {
            ends.push(end);
        }
        ends
    });
    let [x, y] = [330.0, 150.0];
    let face = if e.column.is_some() { 26.0 } else { 0.0 };
    if e.column.is_some() {
        d.rectangle(Pen::Edge, STEEL, [x - face, y - 95.0], [x + face, y + 95.0]);
        d.text([x, y + 112.0], Anchor::Middle, "column");
    }
    let left_too = ends.iter().any(|(_, outward)| *outward < 0.0) || e.column.is_none();
    let sides: &[f64] = if left_too { &[1.0, -1.0] } else { &[1.0] };
    for &side in sides {
        let (plane, end) = (x + side * face, x + side * 190.0);
        d.rectangle(Pen::Edge, STEEL, [plane, y - 22.0], [end, y + 22.0]);
        let here = |(_, outward): &&(&str, f64)| *outward == side || ends.len() == 1 && side > 0.0;
        let Some((end_name, _)) = ends.iter().find(here) else {
            continue;
        };
        d.text([x + side * 110.0, y + 38.0], Anchor::Middle, Text::given(*end_name));
        d.line(Pen::Hidden, [plane, y - 70.0], [plane, y + 70.0]);
        // tension, lift, and the moment that pulls the top
        d.arrow([end, y], [end + side * 46.0, y]);
        d.arrow([end, y - 26.0], [end, y - 70.0]);
        d.turn([end, y], 34.0, side > 0.0);
        let anchor = if side > 0.0 { Anchor::Start } else { Anchor::End };
        d.text([end + side * 52.0, y], anchor, "N, x′");
        d.text([end + side * 6.0, y - 78.0], anchor, "Vz, z′");
        d.text([end + side * 34.0, y - 34.0], anchor, "My");
    }
    let plane =
        if e.column.is_some() { "bolt planes = column faces" } else { "bolt plane (dashed)" };
    d.text([x, y - 112.0], Anchor::Middle, plane);
    let signs = "Positive as drawn: N pulls, Vz lifts, My gives tension at the top; y′ = z′ × x′. \
                 Values at the bolt plane, load factor 1:";
    // the table of actions has those of all cases
    let values = e.actions.iter().take(MOST_VALUES).map(value);
    let more = e.actions.len().saturating_sub(MOST_VALUES);
    let rest = (more > 0).then(|| say!("and {} more, see the table of actions", more));
    let values = values.chain(rest);
    for (i, text) in std::iter::once(signs.into()).chain(values).enumerate() {
        d.text([MARGIN, y + 140.0 + LINE * i as f64], Anchor::Start, text);
    }
    d
}

fn value(a: &PlaneActions) -> Text {
    let [force, moment] = a.at(1.0);
    let names = ["N", "Vy", "Vz", "T", "My", "Mz"];
    let units = [Unit::Force, Unit::Force, Unit::Force, Unit::Moment, Unit::Moment, Unit::Moment];
    let all = names.into_iter().zip(units).zip(force.into_iter().chain(moment));
    let values: Vec<String> = all
        .filter(|((name, _), v)| *v != 0.0 || ["N", "Vz", "My"].contains(name))
        .map(|((name, unit), v)| format!("{name} = {}", unit.show(v).replace('-', "−")))
        .collect();
    let values = values.join(", ");
    match a.dead.iter().flatten().any(|v| *v != 0.0) {
        true => say!("{}, {}: {} (a part of it fixed)", &a.case, &a.end, values),
        false => Text::given(format!("{}, {}: {values}", a.case, a.end)),
    }
}

#[cfg(test)]
mod tests;
