//! Drawing of a column base: elevation and plan with column, plate, anchors, grout and concrete.
//!
//! x is measured from the axis of the column along the depth of its section, y across, z up from
//! the underside of the plate. A block that reaches far beyond the plate is cut off.

use crate::draw::parts_drawing::{BOLT, PLATE, STEEL, legend};
use crate::draw::svg::{Anchor, Drawing, LINE, Pen, Svg};
use crate::draw::weld_symbol::{Sides, weld_symbol};
use bracket_base::say;
use bracket_codes::check::number as n;
use bracket_joint::assembly::extent::Extent;
use bracket_joint::assembly::{BaseSection, ColumnBase, Content};

/// Largest height and width of a view on the page \[pixels\].
const SIZE: [f64; 2] = [400.0, 400.0];
const MARGIN: f64 = 24.0;
const CONCRETE: &str = "#f1f0ec";
const GROUT: &str = "#dedbd2";
/// Length of the block beyond the plate, and of the column above it, at which the drawing is cut
/// off, over the length of the plate.
const SHOWN: f64 = 0.35;

/// The views.
pub fn views(e: &ColumnBase, joint: &Content) -> Svg {
    sheet(e, joint).finish("Column base, elevation and plan")
}

fn sheet(e: &ColumnBase, joint: &Content) -> Drawing {
    let mut d = Drawing::default();
    let top = MARGIN + 1.5 * LINE;
    let base = Base::new(e, joint);
    // the height of ribs stands to the left
    let left = if base.ribs.is_empty() { MARGIN } else { MARGIN + 50.0 };
    let (elevation, plan) = base.scales([left, top], 130.0);
    for (view, title) in [(&elevation, "elevation"), (&plan, "plan")] {
        let [left, right] = [0, 1].map(|k| view.point([view.wide[k], 0.0])[0]);
        d.text([0.5 * (left + right), MARGIN], Anchor::Middle, title);
    }
    let low = base.elevation(&mut d, &elevation).max(base.plan(&mut d, &plan));
    let mut lines = legend(joint);
    let f = &e.foundation;
    let [long, wide] = base.block.map(|[from, to]| n(to - from));
    let at = lines.len().saturating_sub(1);
    lines.insert(
        at,
        say!(
            "concrete block {} × {} × {}, f_ck = {} MPa; grout {}, {} MPa",
            long,
            wide,
            n(f.depth),
            n(f.f_ck.mpa()),
            n(f.grout),
            n(f.grout_strength.mpa())
        ),
    );
    for (i, text) in lines.into_iter().enumerate() {
        d.text([MARGIN, low + LINE * (i as f64 + 1.0)], Anchor::Start, text);
    }
    d
}

/// A view: the ranges across and up, and the scale.
struct View {
    wide: [f64; 2],
    high: [f64; 2],
    scale: f64,
    corner: [f64; 2],
}

impl View {
    fn new(wide: [f64; 2], high: [f64; 2], corner: [f64; 2]) -> Self {
        let scale = (SIZE[0] / (high[1] - high[0])).min(SIZE[1] / (wide[1] - wide[0]));
        Self { wide, high, scale, corner }
    }

    /// Page coordinates of a point.
    fn point(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        let [left, top] = self.corner;
        [left + self.scale * (x - self.wide[0]), top + self.scale * (self.high[1] - z)]
    }

    /// A rectangle, cut at the edges of the view; edges of it there are not drawn over.
    fn rectangle(&self, d: &mut Drawing, pen: Pen, fill: &str, x: [f64; 2], z: [f64; 2]) {
        let within = |v: f64, [a, b]: [f64; 2]| v.clamp(a, b);
        let (x, z) = (x.map(|v| within(v, self.wide)), z.map(|v| within(v, self.high)));
        d.rectangle(pen, fill, self.point([x[0], z[0]]), self.point([x[1], z[1]]));
    }

    fn line(&self, d: &mut Drawing, pen: Pen, from: [f64; 2], to: [f64; 2]) {
        d.line(pen, self.point(from), self.point(to));
    }

    /// The edges of a rectangle that lie inside the view.
    fn inner_edges(&self, d: &mut Drawing, x: [f64; 2], z: [f64; 2]) {
        let inside = |v: f64, [a, b]: [f64; 2]| v > a + 1e-6 && v < b - 1e-6;
        let cut = |v: [f64; 2], [a, b]: [f64; 2]| v.map(|v| v.clamp(a, b));
        let (cx, cz) = (cut(x, self.wide), cut(z, self.high));
        for side in x.into_iter().filter(|v| inside(*v, self.wide)) {
            self.line(d, Pen::Edge, [side, cz[0]], [side, cz[1]]);
        }
        for side in z.into_iter().filter(|v| inside(*v, self.high)) {
            self.line(d, Pen::Edge, [cx[0], side], [cx[1], side]);
        }
    }

    fn chain_below(&self, d: &mut Drawing, below: f64, xs: &[f64]) {
        let pages: Vec<f64> = xs.iter().map(|x| self.point([*x, 0.0])[0]).collect();
        let show: Vec<String> = xs.windows(2).map(|w| n(w[1] - w[0])).collect();
        let from = self.point([0.0, self.high[0]])[1];
        d.horizontal_chain(from + below, from + below - 16.0, &pages, &show);
    }

    fn chain_right(&self, d: &mut Drawing, zs: &[f64]) {
        let pages: Vec<f64> = zs.iter().map(|z| self.point([0.0, *z])[1]).collect();
        let show: Vec<String> = zs.windows(2).map(|w| n(w[1] - w[0])).collect();
        let from = self.point([self.wide[1], 0.0])[0];
        d.vertical_chain(from + 22.0, true, from, &pages, &show);
    }
}

/// A rib beside the column \[mm\].
struct Rib {
    /// Outline in the elevation.
    outline: Vec<[f64; 2]>,
    /// The box round it.
    extent: Extent,
}

/// A base with what its drawing needs beside the data of the checks \[mm\].
struct Base<'a> {
    e: &'a ColumnBase,
    /// Depth and width of the section.
    section: [f64; 2],
    /// Length of the anchors below the plate.
    anchor: f64,
    /// Ribs on either side.
    ribs: Vec<Rib>,
    /// The plate along x and along y.
    plate: [[f64; 2]; 2],
    /// The block along x and along y.
    block: [[f64; 2]; 2],
}

impl<'a> Base<'a> {
    fn new(e: &'a ColumnBase, joint: &Content) -> Self {
        let section = match &e.section {
            BaseSection::I(p) => [p.h, p.b],
            BaseSection::Rectangular { size, .. } => *size,
            BaseSection::Circular { d, .. } => [*d; 2],
        };
        let lengths = joint.fasteners.iter().filter_map(|b| b.anchor);
        let half = 0.5 * e.plate[1];
        let plate = [[-e.to_edge(-1.0), e.to_edge(1.0)], [-half, half]];
        // edges stand in the order of the joint's axes, plates as the checks have them
        let f = &e.foundation;
        let edge = if f.plate == e.plate { f.edge } else { [f.edge[1], f.edge[0]] };
        let block = [0, 1].map(|k| [plate[k][0] - edge[k][0], plate[k][1] + edge[k][1]]);
        // an outline across y has its corners as (z, x)
        let upright = |[z, x]: &[f64; 2]| [*x, *z];
        let ribs = joint.pieces.iter().filter_map(|p| match &p.outline {
            Some((1, outline)) => {
                Some(Rib { outline: outline.iter().map(upright).collect(), extent: p.extent })
            }
            _ => None,
        });
        let anchor = lengths.fold(0.0, f64::max);
        Self { e, section, anchor, ribs: ribs.collect(), plate, block }
    }

    /// Both views, the second to the right of the first.
    fn scales(&self, corner: [f64; 2], apart: f64) -> (View, View) {
        let e = self.e;
        let margin = SHOWN * e.plate[0].max(e.plate[1]);
        let shown = |k: usize| {
            let [[a, b], [p, q]] = [self.block[k], self.plate[k]];
            // beyond the edge of a block there is a little ground to see it
            [(a - 0.1 * margin).max(p - margin), (b + 0.1 * margin).min(q + margin)]
        };
        let bottom = -(e.foundation.grout + e.foundation.depth);
        let low = (bottom - 0.1 * margin).max(-self.anchor - margin);
        let ribs = self.ribs.iter().map(|rib| rib.extent[2][1]);
        let high = ribs.fold(e.thickness + margin, f64::max) + SHOWN * margin;
        let elevation = View::new(shown(0), [low, high], corner);
        let left = elevation.point([elevation.wide[1], 0.0])[0] + apart;
        let plan = View::new(shown(0), shown(1), [left, corner[1]]);
        (elevation, plan)
    }

    /// Draws the elevation; returns the lowest point on the page.
    fn elevation(&self, d: &mut Drawing, v: &View) -> f64 {
        let (e, [h, _]) = (self.e, self.section);
        let f = &e.foundation;
        let block = [-(f.grout + f.depth), -f.grout];
        v.rectangle(d, Pen::None, CONCRETE, self.block[0], block);
        v.inner_edges(d, self.block[0], block);
        if f.grout > 0.0 {
            v.rectangle(d, Pen::Edge, GROUT, self.plate[0], [-f.grout, 0.0]);
        }
        let (t, top) = (e.thickness, v.high[1]);
        v.rectangle(d, Pen::None, STEEL, [-0.5 * h, 0.5 * h], [t, top]);
        let wall = match &e.section {
            BaseSection::I(p) => p.tf,
            BaseSection::Rectangular { t, .. } | BaseSection::Circular { t, .. } => *t,
        };
        let inner = if matches!(e.section, BaseSection::I(_)) { Pen::Edge } else { Pen::Hidden };
        for side in [-1.0, 1.0] {
            for (x, pen) in [(0.5 * h, Pen::Edge), (0.5 * h - wall, inner)] {
                v.line(d, pen, [side * x, t], [side * x, top]);
            }
        }
        for rib in &self.ribs {
            let corners: Vec<[f64; 2]> = rib.outline.iter().map(|p| v.point(*p)).collect();
            d.polygon(Pen::Edge, PLATE, &corners);
        }
        for row in &e.rows {
            let half = 0.5 * e.bolt.d;
            let nut = t + e.bolt.washer_thickness + e.bolt.nut_height;
            v.rectangle(d, Pen::Edge, BOLT, [row - half, row + half], [-self.anchor, nut + half]);
            // it goes on: its anchorage is not Bracket's
            let beyond = [row - 2.0 * half, row + 2.0 * half];
            for low in [0.0, 0.5 * half] {
                let ends = [-self.anchor - low - half, -self.anchor - low + half];
                v.line(d, Pen::Edge, [beyond[0], ends[0]], [beyond[1], ends[1]]);
            }
        }
        v.rectangle(d, Pen::Edge, PLATE, self.plate[0], [0.0, t]);
        for row in &e.rows {
            let [half, washer] = [0.5 * e.bolt.nut_width, 0.5 * e.bolt.washer_outer];
            let seat = t + e.bolt.washer_thickness;
            v.rectangle(d, Pen::Edge, BOLT, [row - washer, row + washer], [t, seat]);
            v.rectangle(
                d,
                Pen::Edge,
                BOLT,
                [row - half, row + half],
                [seat, seat + e.bolt.nut_height],
            );
        }
        v.line(d, Pen::Thin, [0.0, v.high[0]], [0.0, top]);
        let corner = v.point([0.5 * h, t]);
        let sides = match e.section {
            BaseSection::I(_) => Sides::Both,
            BaseSection::Rectangular { .. } | BaseSection::Circular { .. } => Sides::Arrow,
        };
        weld_symbol(d, corner, [corner[0] + 34.0, corner[1] - 70.0], e.flange_throat, sides);
        let mut xs = e.rows.clone();
        xs.extend(self.plate[0]);
        xs.sort_by(f64::total_cmp);
        v.chain_below(d, 16.0, &xs);
        v.chain_below(d, 16.0 + 2.5 * LINE, &self.plate[0]);
        let mut zs = vec![0.0, t];
        if f.grout > 0.0 {
            zs.insert(0, -f.grout);
        }
        v.chain_right(d, &zs);
        // of the rib on the left: the symbol of the weld stands on the right
        if let Some(rib) = self.ribs.last() {
            let [x, _, z] = rib.extent;
            let ([left, low], [_, high]) = (v.point([v.wide[0], t]), v.point([0.0, z[1]]));
            d.vertical_chain(left - 14.0, false, left, &[low, high], &[n(z[1] - t)]);
            let ends = x.map(|x| v.point([x, 0.0])[0]);
            d.horizontal_chain(high - 20.0, high - 3.0, &ends, &[n(x[1] - x[0])]);
        }
        v.point([0.0, v.high[0]])[1] + 16.0 + 4.5 * LINE
    }

    /// Draws the plan; returns the lowest point on the page.
    fn plan(&self, d: &mut Drawing, v: &View) -> f64 {
        let (e, [h, b]) = (self.e, self.section);
        v.rectangle(d, Pen::None, CONCRETE, self.block[0], self.block[1]);
        v.inner_edges(d, self.block[0], self.block[1]);
        v.rectangle(d, Pen::Edge, PLATE, self.plate[0], self.plate[1]);
        self.section(d, v);
        for rib in &self.ribs {
            let [x, y, _] = rib.extent;
            v.rectangle(d, Pen::Edge, PLATE, x, y);
        }
        for (x, y) in e.rows.iter().flat_map(|x| e.across.iter().map(move |y| (*x, *y))) {
            let centre = v.point([x, y]);
            d.circle(Pen::Edge, BOLT, centre, 0.5 * v.scale * e.bolt.washer_outer);
            d.circle(Pen::Edge, "#ffffff", centre, 0.5 * v.scale * e.bolt.d);
        }
        v.line(d, Pen::Thin, [v.wide[0], 0.0], [v.wide[1], 0.0]);
        v.line(d, Pen::Thin, [0.0, v.high[0]], [0.0, v.high[1]]);
        let [p, q] = self.plate[0];
        v.chain_below(d, 16.0, &[p, -0.5 * h, 0.5 * h, q]);
        let mut ys = e.across.clone();
        ys.extend(self.plate[1]);
        ys.sort_by(f64::total_cmp);
        v.chain_right(d, &ys);
        let from = v.point([v.wide[0], 0.0])[0];
        let edges = [-0.5 * b, 0.5 * b].map(|y| v.point([0.0, y])[1]);
        d.vertical_chain(from - 14.0, false, from, &edges, &[n(b)]);
        v.point([0.0, v.high[0]])[1] + 16.0 + 2.5 * LINE
    }

    /// The section of the column in the plan.
    fn section(&self, d: &mut Drawing, v: &View) {
        let [h, b] = self.section;
        match &self.e.section {
            BaseSection::I(p) => {
                let [x, y] = [0.5 * h, 0.5 * b];
                let (inner, web) = (x - p.tf, 0.5 * p.tw);
                let quarter = [[x, y], [inner, y], [inner, web]];
                let mirrored = |sx: f64, sy: f64| quarter.map(|[x, y]| [sx * x, sy * y]);
                let reversed = |sx: f64, sy: f64| {
                    let mut points = mirrored(sx, sy);
                    points.reverse();
                    points
                };
                let corners = [
                    mirrored(1.0, 1.0),
                    reversed(-1.0, 1.0),
                    mirrored(-1.0, -1.0),
                    reversed(1.0, -1.0),
                ];
                let pages: Vec<[f64; 2]> = corners.iter().flatten().map(|p| v.point(*p)).collect();
                d.polygon(Pen::Edge, STEEL, &pages);
            }
            BaseSection::Rectangular { t, .. } => {
                for (inset, fill) in [(0.0, STEEL), (*t, PLATE)] {
                    let [x, y] = [0.5 * h - inset, 0.5 * b - inset];
                    v.rectangle(d, Pen::Edge, fill, [-x, x], [-y, y]);
                }
            }
            BaseSection::Circular { t, .. } => {
                for (inset, fill) in [(0.0, STEEL), (*t, PLATE)] {
                    let radius = v.scale * (0.5 * h - inset);
                    d.circle(Pen::Edge, fill, v.point([0.0, 0.0]), radius);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::svg::overlaps;
    use bracket_base::yaml;
    use bracket_codes::design_code::build;
    use bracket_joint::assembly::Facts;
    use bracket_joint::catalog::Catalog;
    use bracket_joint::spec::ConnectionSpec;
    use std::path::Path;

    /// An eccentric base: rows, gauge, offset of the column, anchors, grout and plate have their
    /// dimensions, the block its sizes, and no text covers another.
    #[test]
    fn a_base_has_elevation_and_plan_with_its_dimensions() {
        for (profile, rows, parameters) in [
            ("HEB200", "[-140, 140]", "plate_length: 400, plate_offset: 20"),
            (
                "HEA200",
                "[-140, 140]",
                "plate_length: 400, ribs: true, rib_weld: 5, rib_height: 180",
            ),
            ("CHS219.1x8", "[-150, 150]", "plate_length: 400, concrete_edge: 0"),
            ("RHS200x100x8", "[-150, 150]", "plate_length: 400, grout_thickness: 0"),
        ] {
            let text = format!(
                "template: column_base\nmembers: {{column: {{profile: {profile}, steel: S235}}}}\n\
                 plate: {{thickness: 32, width: 360}}\nbolts: {{size: M20, grade: '8.8', rows: \
                 {rows}, gauge: 220}}\nparameters: {{{parameters}, flange_weld: 6}}\nloads: \
                 [{{name: A, end: column, at: bolt_plane, N: -100 kN}}]\n"
            );
            let spec =
                yaml::parse::<ConnectionSpec>(&text, Path::new("joint.yaml")).expect("a spec");
            let joint = build(&spec, Path::new("."), &Catalog::builtin().expect("catalogue"));
            let joint = joint.unwrap_or_else(|e| panic!("{e:#?}"));
            let Some(Facts::ColumnBase(e)) = &joint.facts else { panic!("{:?}", joint.facts) };
            let drawing = sheet(e, &joint.content);
            assert_eq!(overlaps(&drawing.labels), 0, "{profile}: {:?}", drawing.labels);
            let text = drawing.finish("t").file;
            // a rib has five corners, the weld's symbol three, the section of the column twelve
            let corners = |line: &str| line.split('"').nth(1).map_or(0, |p| p.split(' ').count());
            let polygons = text.lines().filter(|line| line.starts_with("<polygon"));
            let ribs = polygons.filter(|line| corners(line) == 5).count();
            assert_eq!(ribs, if parameters.contains("ribs") { 2 } else { 0 }, "{profile}: {text}");
            let wanted: &[&str] = match profile {
                // 400 = 40 + 280 + 80; 80 + 200 + 120 about the column; 30 of grout
                "HEB200" => &[
                    ">40<",
                    ">280<",
                    ">80<",
                    ">120<",
                    ">220<",
                    ">70<",
                    ">32<",
                    ">30<",
                    "1000 × 960 × 600",
                    "f_ck = 25 MPa",
                ],
                // the plate reaches 105 beyond the flange, a rib 10 less; its height
                "HEA200" => &[">95<", ">180<"],
                "CHS219.1x8" => &[">300<", "400 × 360 × 600"],
                _ => &[">300<", "grout 0"],
            };
            for w in wanted {
                assert!(text.contains(w), "{profile}: {w}: {text}");
            }
        }
    }
}
