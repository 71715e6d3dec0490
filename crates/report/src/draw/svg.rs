//! Line drawings as SVG text: strokes, arrows, texts that do not overlap, chains of dimensions.

use crate::document::picture::PictureRef;
use crate::escaped::escaped;
use crate::lettering::{LETTERS, width};
use bracket_base::words::{Gap, Text};
use std::fmt::Write;

/// Least distance of two lines of text \[pixels\].
pub(crate) const LINE: f64 = 16.0;
const TICK: f64 = 4.0;

/// Colour and width of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Pen {
    /// No stroke.
    None,
    /// Edges of parts.
    Edge,
    /// Hidden edges.
    Hidden,
    /// Dimensions and leaders.
    Thin,
    /// Forces and moments.
    Action,
}

impl Pen {
    fn attributes(self) -> &'static str {
        match self {
            Pen::None => "stroke=\"none\"",
            Pen::Edge => "stroke=\"#1e1e1e\" stroke-width=\"1.5\"",
            Pen::Hidden => "stroke=\"#6e6e6e\" stroke-width=\"1\" stroke-dasharray=\"5 3\"",
            Pen::Thin => "stroke=\"#5a5a5a\" stroke-width=\"0.7\"",
            Pen::Action => "stroke=\"#c03a00\" stroke-width=\"2\"",
        }
    }
}

/// Position of a text relative to its point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Anchor {
    /// Right of the point.
    Start,
    /// Centred on the point.
    Middle,
    /// Left of the point.
    End,
}

/// A finished drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Svg {
    /// The text of the file, in English.
    pub file: String,
    /// The texts in it, so that their data are kept beside the file.
    pub texts: Vec<Text>,
}

impl Svg {
    /// The drawing as a picture of a report, with the text of its file.
    pub fn picture(
        self,
        file: impl Into<String>,
        caption: impl Into<Text>,
    ) -> (PictureRef, String) {
        let (file, caption) = (file.into(), caption.into());
        (PictureRef { file, caption, texts: self.texts }, self.file)
    }
}

/// A drawing in progress; y points down, as in SVG \[pixels\].
#[derive(Clone, Debug, Default)]
pub(crate) struct Drawing {
    body: String,
    /// The texts that are no plain messages.
    texts: Vec<Text>,
    /// Boxes of the texts: left, top, right, bottom.
    pub labels: Vec<[f64; 4]>,
    size: [f64; 2],
}

impl Drawing {
    fn reach(&mut self, x: f64, y: f64) {
        self.size = [self.size[0].max(x), self.size[1].max(y)];
    }

    /// A straight stroke.
    pub fn line(&mut self, pen: Pen, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
        self.reach(x1.max(x2), y1.max(y2));
        // writing to a String cannot fail
        let _ = writeln!(
            self.body,
            "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" {}/>",
            pen.attributes()
        );
    }

    /// A rectangle between two corners.
    pub fn rectangle(&mut self, pen: Pen, fill: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
        self.reach(x1.max(x2), y1.max(y2));
        let (x, y, w, h) = (x1.min(x2), y1.min(y2), (x2 - x1).abs(), (y2 - y1).abs());
        let _ = writeln!(
            self.body,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{w:.1}\" height=\"{h:.1}\" fill=\"{fill}\" \
             {}/>",
            pen.attributes()
        );
    }

    /// A closed outline.
    pub fn polygon(&mut self, pen: Pen, fill: &str, points: &[[f64; 2]]) {
        points.iter().for_each(|p| self.reach(p[0], p[1]));
        let text: Vec<String> = points.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(
            self.body,
            "<polygon points=\"{}\" fill=\"{fill}\" {}/>",
            text.join(" "),
            pen.attributes()
        );
    }

    /// A circle.
    pub fn circle(&mut self, pen: Pen, fill: &str, [x, y]: [f64; 2], radius: f64) {
        self.reach(x + radius, y + radius);
        let _ = writeln!(
            self.body,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\" fill=\"{fill}\" {}/>",
            pen.attributes()
        );
    }

    /// An arrow that ends at `to`.
    pub fn arrow(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.line(Pen::Action, from, to);
        self.head(to, [to[0] - from[0], to[1] - from[1]]);
    }

    /// A thin line with a small arrow that ends at `to`.
    pub fn leader(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.line(Pen::Thin, from, to);
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = dx.hypot(dy).max(f64::MIN_POSITIVE);
        let [dx, dy] = [dx / length, dy / length];
        let at = |side: f64| [to[0] - 7.0 * dx - side * dy, to[1] - 7.0 * dy + side * dx];
        self.polygon(Pen::Thin, "#5a5a5a", &[to, at(2.5), at(-2.5)]);
    }

    fn head(&mut self, tip: [f64; 2], direction: [f64; 2]) {
        let length = direction[0].hypot(direction[1]).max(f64::MIN_POSITIVE);
        let [dx, dy] = direction.map(|c| c / length);
        let at =
            |back: f64, side: f64| [tip[0] - back * dx - side * dy, tip[1] - back * dy + side * dx];
        self.polygon(Pen::Action, "#c03a00", &[tip, at(9.0, 4.0), at(9.0, -4.0)]);
    }

    /// A moment about `centre`: three quarters of a circle with an arrow, clockwise on the page if
    /// `clockwise`.
    pub fn turn(&mut self, [x, y]: [f64; 2], radius: f64, clockwise: bool) {
        self.reach(x + radius, y + radius);
        let side = if clockwise { 1.0 } else { -1.0 };
        // the arc starts below the centre, on the side away from the arrow, and runs over the top
        // to the other side
        let angle = 0.75 * std::f64::consts::PI;
        let at = |a: f64| [x + side * radius * a.sin(), y - radius * a.cos()];
        let (from, to) = (at(-angle), at(angle));
        let _ = writeln!(
            self.body,
            "<path d=\"M {:.1} {:.1} A {radius:.1} {radius:.1} 0 1 {} {:.1} {:.1}\" fill=\"none\" \
             {}/>",
            from[0],
            from[1],
            u8::from(clockwise),
            to[0],
            to[1],
            Pen::Action.attributes()
        );
        self.head(to, [side * angle.cos(), angle.sin()]);
    }

    /// A text, vertically centred on the point.
    pub fn text(&mut self, [x, y]: [f64; 2], anchor: Anchor, text: impl Into<Text>) {
        let text = text.into();
        let english = text.to_string();
        let width = width(&english);
        let (name, left) = match anchor {
            Anchor::Start => ("start", x),
            Anchor::Middle => ("middle", x - 0.5 * width),
            Anchor::End => ("end", x - width),
        };
        self.labels.push([left, y - 0.5 * LETTERS, left + width, y + 0.5 * LETTERS]);
        self.reach(left + width, y + LETTERS);
        let english = escaped(&english);
        let base = y + 0.36 * LETTERS;
        let _ = writeln!(
            self.body,
            "<text x=\"{x:.1}\" y=\"{base:.1}\" text-anchor=\"{name}\">{english}</text>"
        );
        self.keep(text);
    }

    /// Keeps a text whose data its English sentence does not give. A number is no message.
    fn keep(&mut self, text: Text) {
        let number = |g: &Gap| matches!(g, Gap::Given(t) if !t.contains(char::is_alphabetic));
        let plain = text.gaps.is_empty() || text.id == "{}" && text.gaps.iter().all(number);
        let same = |t: &Text| t.id == text.id && t.gaps == text.gaps;
        if !plain && !self.texts.iter().any(same) {
            self.texts.push(text);
        }
    }

    /// A name of the user beside a point, on white, where it covers no other text. Without such a
    /// place the point stays without its name.
    pub fn name(&mut self, [x, y]: [f64; 2], name: &str) {
        let (wide, half) = (width(name), 0.5 * LETTERS);
        let beside = [x + 7.0, x - 7.0 - wide];
        let levels =
            [-7.0, 7.0]
                .into_iter()
                .chain((1..5).flat_map(|line| {
                    [-1.0, 1.0].map(|side| side * (7.0 + LINE * f64::from(line)))
                }));
        let places = levels.flat_map(|dy| beside.map(|left| [left, y + dy]));
        let free = |[left, y]: &[f64; 2]| {
            let mine = [left - 1.0, y - half, left + wide + 1.0, y + half];
            let apart = |b: &[f64; 4]| {
                mine[0] >= b[2] || b[0] >= mine[2] || mine[1] >= b[3] || b[1] >= mine[3]
            };
            self.labels.iter().all(apart)
        };
        let Some([left, y]) = places.into_iter().find(free) else { return };
        // lines pass behind the name
        let right = left + wide + 1.0;
        self.rectangle(Pen::None, "#ffffff", [left - 1.0, y - half], [right, y + half]);
        self.text([left, y], Anchor::Start, Text::given(name));
    }

    /// A vertical chain of dimensions at `x`. `ys` are the y of the points from the bottom, `from`
    /// is the x of the line they come from. The texts are placed to the `right` or to the left of
    /// the chain and do not overlap. `show` contains the text between each two neighbours.
    pub fn vertical_chain(&mut self, x: f64, right: bool, from: f64, ys: &[f64], show: &[String]) {
        let side = if right { 1.0 } else { -1.0 };
        for y in ys {
            self.line(Pen::Thin, [from + side * 3.0, *y], [x + side * TICK, *y]);
            self.line(Pen::Thin, [x - TICK, y + TICK], [x + TICK, y - TICK]);
        }
        if let (Some(first), Some(last)) = (ys.first(), ys.last()) {
            self.line(Pen::Thin, [x, *first], [x, *last]);
        }
        let wanted: Vec<f64> = ys.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
        let anchor = if right { Anchor::Start } else { Anchor::End };
        for (y, text) in apart(&wanted, LINE).into_iter().zip(show) {
            self.text([x + side * 8.0, y], anchor, Text::given(text));
        }
    }

    /// A horizontal chain of dimensions at `y`, from the left, below the line `from`. A text that
    /// is too wide for its interval is placed one line lower.
    pub fn horizontal_chain(&mut self, y: f64, from: f64, xs: &[f64], show: &[String]) {
        for x in xs {
            self.line(Pen::Thin, [*x, from + 3.0], [*x, y + TICK]);
            self.line(Pen::Thin, [x - TICK, y + TICK], [x + TICK, y - TICK]);
        }
        if let (Some(first), Some(last)) = (xs.first(), xs.last()) {
            self.line(Pen::Thin, [*first, y], [*last, y]);
        }
        let mut taken: Vec<f64> = Vec::new();
        for (w, text) in xs.windows(2).zip(show) {
            let (middle, half) = (0.5 * (w[0] + w[1]), 0.5 * width(text) + 3.0);
            // the first text line below the chain in which the previous text has ended
            let line = taken.iter().position(|end| *end <= middle - half).unwrap_or(taken.len());
            if line == taken.len() {
                taken.push(0.0);
            }
            taken[line] = middle + half;
            self.text([middle, y + 12.0 + LINE * line as f64], Anchor::Middle, Text::given(text));
        }
    }

    /// The finished drawing.
    pub fn finish(mut self, title: impl Into<Text>) -> Svg {
        let [width, height] = self.size.map(|s| (s + 16.0).ceil());
        let title = title.into();
        let english = escaped(&title.to_string());
        self.keep(title);
        let file = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"{LETTERS}\" \
             fill=\"#1e1e1e\">\n<title>{english}</title>\n<rect width=\"{width}\" \
             height=\"{height}\" fill=\"#ffffff\"/>\n{}</svg>\n",
            self.body
        );
        Svg { file, texts: self.texts }
    }
}

/// Positions in the order of `wanted`, as close to it as a distance of `least` between neighbours
/// allows.
fn apart(wanted: &[f64], least: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|a, b| wanted[*a].total_cmp(&wanted[*b]));
    let mut at = wanted.to_vec();
    // clusters of touching texts, each centred on the mean of the wanted positions of its members
    let mut clusters: Vec<Vec<usize>> = Vec::new();
    for i in order {
        clusters.push(vec![i]);
        while let [.., a, b] = clusters.as_slice() {
            let place = |c: &Vec<usize>| {
                let mean = c.iter().map(|i| wanted[*i]).sum::<f64>() / c.len() as f64;
                let half = 0.5 * least * (c.len() - 1) as f64;
                [mean - half, mean + half]
            };
            if place(b)[0] - place(a)[1] >= least {
                break;
            }
            let joined = [a.as_slice(), b.as_slice()].concat();
            clusters.truncate(clusters.len() - 2);
            clusters.push(joined);
        }
    }
    for c in clusters {
        let mean = c.iter().map(|i| wanted[*i]).sum::<f64>() / c.len() as f64;
        for (k, i) in c.iter().enumerate() {
            at[*i] = mean + least * (k as f64 - 0.5 * (c.len() - 1) as f64);
        }
    }
    at
}

/// Pairs of texts that overlap.
#[cfg(test)]
pub(crate) fn overlaps(labels: &[[f64; 4]]) -> usize {
    let touch =
        |a: &[f64; 4], b: &[f64; 4]| a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
    (0..labels.len()).map(|i| labels[..i].iter().filter(|b| touch(&labels[i], b)).count()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_make_room_for_each_other() {
        assert_eq!(apart(&[0.0, 100.0, 200.0], 16.0), [0.0, 100.0, 200.0]);
        assert_eq!(apart(&[10.0, 10.0], 16.0), [2.0, 18.0]);
        // from the bottom, as in the chain; the third text joins the cluster of the first two
        let found = apart(&[30.0, 20.0, 10.0, -100.0], 16.0);
        assert_eq!(found, [36.0, 20.0, 4.0, -100.0]);
        let mut d = Drawing::default();
        let ys: Vec<f64> = (0..8).map(|i| 300.0 - 5.0 * f64::from(i)).collect();
        d.vertical_chain(100.0, true, 80.0, &ys, &vec!["12.5".to_string(); 7]);
        d.horizontal_chain(
            320.0,
            310.0,
            &[0.0, 10.0, 14.0, 90.0],
            &["1000".into(), "5".into(), "77".into()],
        );
        assert_eq!(overlaps(&d.labels), 0, "{:?}", d.labels);
        assert_eq!(
            overlaps(&[[0.0, 0.0, 2.0, 2.0], [1.0, 1.0, 3.0, 3.0], [5.0, 5.0, 6.0, 6.0]]),
            1
        );
    }

    /// Many points close together: no name covers another one, and the first ones have theirs.
    #[test]
    fn names_of_points_do_not_overlap() {
        let mut d = Drawing::default();
        (0..29).for_each(|i| d.name([200.0 + f64::from(i % 5), 200.0], &format!("ULS{i}")));
        assert_eq!(overlaps(&d.labels), 0, "{:?}", d.labels);
        assert!(d.labels.len() > 10, "{}", d.labels.len());
    }

    #[test]
    fn the_file_is_well_formed_and_escapes_its_texts() {
        let mut d = Drawing::default();
        d.text([10.0, 10.0], Anchor::Start, "a < b & c");
        d.arrow([0.0, 0.0], [40.0, 0.0]);
        d.turn([60.0, 60.0], 20.0, true);
        let text = d.finish("t & t").file;
        assert!(
            text.contains("a &lt; b &amp; c") && text.contains("<title>t &amp; t</title>"),
            "{text}"
        );
        assert_eq!(text.matches('<').count(), text.matches('>').count());
        assert!(text.starts_with("<svg ") && text.ends_with("</svg>\n"));
    }
}
