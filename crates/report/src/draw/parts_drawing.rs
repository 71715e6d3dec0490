//! Drawing of a joint of any template: two views of its members, plates and bolts with the main
//! dimensions. It shows the geometry alone.

use crate::draw::svg::{Anchor, Drawing, LINE, Pen, Svg};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::check::number as n;
use bracket_codes::end_plate::{PartSize, parts_list};
use bracket_joint::assembly::Content;
use bracket_joint::assembly::block::Block;
use bracket_joint::assembly::content::{Extent, union};

/// Largest height and width of a view on the page \[pixels\].
const SIZE: [f64; 2] = [360.0, 380.0];
const MARGIN: f64 = 24.0;
pub(super) const STEEL: &str = "#eef1f4";
pub(super) const PLATE: &str = "#dfe5ea";
pub(super) const BOLT: &str = "#c9d3dc";
const AXES: [&str; 3] = ["x", "y", "z"];

/// The views.
pub fn views(joint: &Content) -> Svg {
    sheet(joint).finish("Joint, two views")
}

fn sheet(joint: &Content) -> Drawing {
    let mut d = Drawing::default();
    let Some(window) = window(joint) else { return d };
    let top = MARGIN + 1.5 * LINE;
    let mut left = MARGIN + 40.0;
    let mut low: f64 = top;
    // seen along y, then along x; z is up in both
    for (across, sight) in [(0, 1), (1, 0)] {
        let view = View::new(&window, across, sight, [left, top]);
        let title = say!("seen along {}", AXES[sight].to_owned());
        d.text([0.5 * (view.at(0)[0] + view.at(0)[1]), MARGIN], Anchor::Middle, title);
        view.solids(&mut d, joint, &window);
        low = low.max(view.dimensions(&mut d, joint));
        left = view.at(0)[1] + 130.0;
    }
    for (i, text) in legend(joint).into_iter().enumerate() {
        d.text([MARGIN, low + LINE * (i as f64 + 1.0)], Anchor::Start, text);
    }
    d
}

/// What the drawing shows: bolts and plates, and of the members as much beyond them as their
/// sections are high. `None` for a joint without solids.
fn window(joint: &Content) -> Option<Extent> {
    let all = |extents: &mut dyn Iterator<Item = Extent>| extents.reduce(union);
    let members = all(&mut joint.members.iter().map(|m| m.bounds()));
    let pieces = joint.pieces.iter().map(|p| p.bounds());
    let bolts = joint.fasteners.iter().map(|b| {
        let mut e = b.head.map(|x| [x, x]);
        let nut = b.head[b.axis] + b.toward * b.grip();
        let start = b.head[b.axis] - b.toward * b.anchor.unwrap_or(0.0);
        e[b.axis] = [start.min(nut), start.max(nut)];
        e
    });
    let near = all(&mut pieces.chain(bolts));
    let depth = joint.members.iter().flat_map(|m| {
        let e = m.extent();
        (0..3).filter(move |k| *k != m.along).map(move |k| e[k][1] - e[k][0])
    });
    let depth = depth.fold(0.0, f64::max);
    match (near, members) {
        (Some(near), Some(members)) => {
            let whole = union(near, members);
            Some(std::array::from_fn(|k| {
                [whole[k][0].max(near[k][0] - depth), whole[k][1].min(near[k][1] + depth)]
            }))
        }
        (near, members) => near.or(members),
    }
}

/// A view: the axis that is horizontal on the page, the one that is looked along, the scale.
struct View {
    across: usize,
    sight: usize,
    scale: f64,
    /// Page coordinates of the upper left corner.
    corner: [f64; 2],
    wide: [f64; 2],
    high: [f64; 2],
}

impl View {
    fn new(window: &Extent, across: usize, sight: usize, corner: [f64; 2]) -> Self {
        let (wide, high) = (window[across], window[2]);
        let scale = (SIZE[0] / (high[1] - high[0])).min(SIZE[1] / (wide[1] - wide[0]));
        Self { across, sight, scale, corner, wide, high }
    }

    /// Page coordinates of a point.
    fn point(&self, x: f64, z: f64) -> [f64; 2] {
        [
            self.corner[0] + self.scale * (x - self.wide[0]),
            self.corner[1] + self.scale * (self.high[1] - z),
        ]
    }

    /// Page coordinates of the ends along the width (0) or the height (1).
    fn at(&self, k: usize) -> [f64; 2] {
        let [a, b] =
            [self.point(self.wide[0], self.high[1]), self.point(self.wide[1], self.high[0])];
        [a[k], b[k]]
    }

    /// Members, plates and bolts, the farthest first; the outlines of plates over them.
    fn solids(&self, d: &mut Drawing, joint: &Content, window: &Extent) {
        let blocks = joint.members.iter().flat_map(|m| m.solids().into_iter().map(|b| (b, STEEL)));
        let plates = || joint.pieces.iter().flat_map(|p| p.solids());
        let mut solids: Vec<(Block, &str)> = blocks.chain(plates().map(|b| (b, PLATE))).collect();
        let near = |b: &Block| b.bounds()[self.sight][0];
        solids.sort_by(|a, b| near(&b.0).total_cmp(&near(&a.0)));
        for (block, fill) in solids {
            if let Some(cut) = block.within(window) {
                self.outline(d, Pen::Edge, fill, &cut);
            }
        }
        // plates that others hide
        plates().for_each(|block| self.outline(d, Pen::Hidden, "none", &block));
        let Some((size, _)) = &joint.bolt else { return };
        for b in &joint.fasteners {
            let [x, z] = [b.head[self.across], b.head[2]];
            if b.axis == self.sight {
                let centre = self.point(x, z);
                d.circle(Pen::Edge, BOLT, centre, 0.5 * self.scale * size.head_width);
                d.circle(Pen::Edge, "#ffffff", centre, 0.5 * self.scale * size.d);
                continue;
            }
            let nut = b.toward * b.grip();
            let (head, width) = match b.anchor {
                Some(length) => (length, size.d),
                None => (size.head_height, size.head_width),
            };
            for (from, to, width) in [
                (0.0, nut, size.d),
                (-b.toward * head, 0.0, width),
                (nut, nut + b.toward * size.nut_height, size.nut_width),
            ] {
                let half = 0.5 * width;
                let [p, q] = match b.axis == 2 {
                    true => [self.point(x - half, z + from), self.point(x + half, z + to)],
                    false => [self.point(x + from, z - half), self.point(x + to, z + half)],
                };
                d.rectangle(Pen::Edge, BOLT, p, q);
            }
        }
    }

    /// The outline of a block in the view.
    fn outline(&self, d: &mut Drawing, pen: Pen, fill: &str, block: &Block) {
        let e = block.bounds();
        if block.axis == self.sight && !block.is_box() {
            // the polygon's coordinates are those of the next two axes
            let turned = (block.axis + 1) % 3 != self.across;
            let place = |p: &[f64; 2]| {
                let [x, z] = if turned { [p[1], p[0]] } else { *p };
                self.point(x, z)
            };
            let corners: Vec<[f64; 2]> = block.polygon.iter().map(place).collect();
            d.polygon(pen, fill, &corners);
        } else {
            let [x, z] = [e[self.across], e[2]];
            d.rectangle(pen, fill, self.point(x[0], z[0]), self.point(x[1], z[1]));
        }
    }

    /// Ends of the view and places of the bolts: below and on the right. Returns the lowest point
    /// on the page.
    fn dimensions(&self, d: &mut Drawing, joint: &Content) -> f64 {
        let places = |k: usize, ends: [f64; 2]| {
            let inside = |x: &f64| *x > ends[0] && *x < ends[1];
            let bolts = joint.fasteners.iter().filter(|b| b.axis != k).map(|b| b.head[k]);
            let mut all: Vec<f64> = bolts.filter(inside).chain(ends).collect();
            all.sort_by(f64::total_cmp);
            all.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
            let show: Vec<String> = all.windows(2).map(|w| n(w[1] - w[0])).collect();
            (all, show)
        };
        let (xs, show) = places(self.across, self.wide);
        let [right, bottom] = [self.at(0)[1], self.at(1)[1]];
        let pages: Vec<f64> = xs.iter().map(|x| self.point(*x, 0.0)[0]).collect();
        d.horizontal_chain(bottom + 16.0, bottom, &pages, &show);
        let mut low = bottom + 16.0 + LINE * 3.0;
        if show.len() > 1 {
            let ends = [pages[0], pages[pages.len() - 1]];
            let from = bottom + 16.0 + LINE * 2.5;
            let total = [n(self.wide[1] - self.wide[0])];
            d.horizontal_chain(from + 10.0, from, &ends, &total);
            low = from + 10.0 + LINE * 2.0;
        }
        let (zs, show) = places(2, self.high);
        let pages: Vec<f64> = zs.iter().map(|z| self.point(0.0, *z)[1]).collect();
        d.vertical_chain(right + 22.0, true, right, &pages, &show);
        low
    }
}

/// Members, plates and bolts in words.
pub(super) fn legend(joint: &Content) -> Vec<Text> {
    let mut out: Vec<Text> = Vec::new();
    for m in &joint.members {
        let line = say!("{}: {} {}", &m.label, &m.profile, &m.steel);
        if !out.contains(&line) {
            out.push(line);
        }
    }
    for i in parts_list(joint) {
        let size = match &i.size {
            PartSize::Plate(sizes) => Text::given(sizes.map(n).join(" × ")),
            PartSize::Anchor { size, below, .. } => {
                let below = n(*below);
                let long = say!("elastic over {} below the plate, then anchored", below);
                out.push(say!("{} × {} {} {}, {}", i.count, &i.part, size, &i.steel, long));
                continue;
            }
            PartSize::Bolt { size, length, grip } => {
                let long = length.map_or_else(String::new, |l| format!(" × {}", n(l)));
                say!("{}, grip {}", format!("{size}{long}"), n(*grip))
            }
        };
        out.push(say!("{} × {} {} {}", i.count, &i.part, size, &i.steel));
    }
    out.push("dimensions in mm".into());
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::svg::overlaps;
    use bracket_base::yaml;
    use bracket_codes::design_code::build;
    use bracket_joint::catalog::Catalog;
    use bracket_joint::spec::ConnectionSpec;
    use std::path::Path;

    fn stubs(parameters: &str) -> Content {
        let text = format!(
            "template: t_stub\nmembers: {{tee: {{profile: IPE300, steel: S235}}}}\nbolts: {{size: \
             M16, grade: '8.8', gauge: 90, rows: [-50, 50]}}\nparameters: {{length: 200, \
             {parameters}}}\nloads: [{{name: A, end: top, at: bolt_plane, N: 1 kN}}]\n"
        );
        let spec = yaml::parse::<ConnectionSpec>(&text, Path::new("joint.yaml")).expect("a spec");
        let joint = build(&spec, Path::new("."), &Catalog::builtin().expect("catalogue"));
        joint.unwrap_or_else(|e| panic!("{e:#?}")).content
    }

    /// Two stubs of IPE300 (h = 300, b = 150) with 2 × 2 bolts M16 through flanges of 10.7 mm: both
    /// views give the gauge, the rows, the length and the height of 600. The bolts need 21.4 +
    /// 2 · 3 + 14.8 + 2 = 44.2 mm.
    #[test]
    fn a_t_stub_has_two_views_with_its_dimensions() {
        let drawing = sheet(&stubs(""));
        assert_eq!(overlaps(&drawing.labels), 0, "{:?}", drawing.labels);
        let text = drawing.finish("t").file;
        for wanted in
            [">90<", ">100<", ">150<", ">200<", ">600<", "4 × bolt M16 × 45, grip 21.4 8.8"]
        {
            assert!(text.contains(wanted), "{wanted}: {text}");
        }
        // three blocks of each stub and shank, head and nut of each bolt, in two views
        assert_eq!(text.matches("<rect x").count(), 2 * (2 * 3 + 4 * 3));
    }

    #[test]
    fn welded_stubs_are_plates_in_the_drawing_and_in_the_legend() {
        let joint = stubs("welded: true, flange_thickness: 15, web_thickness: 8, web_height: 60");
        let text = sheet(&joint).finish("t").file;
        for wanted in ["15 × 150 × 200 S235", "8 × 60 × 200 S235", "grip 30"] {
            assert!(text.contains(wanted), "{wanted}: {text}");
        }
    }
}
