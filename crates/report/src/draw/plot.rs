//! A plot with two logarithmic axes, as a picture and as SVG text, both drawn from the same
//! strokes.

use crate::draw::canvas::{Canvas, Picture, Rgb};
use crate::draw::lettering::text_width;
use crate::draw::svg::Svg;
use crate::escaped::escaped;
use crate::words::Words;
use bracket_base::words::Text;
use std::fmt::Write;

/// Size \[pixels\].
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 500.0;
/// Edges of the frame: left, top, right, bottom \[pixels\].
const FRAME: [f64; 4] = [80.0, 44.0, 740.0, 440.0];
/// Height of capitals \[pixels\].
const LETTERS: f64 = 10.0;

const PAPER: Rgb = [255.0; 3];
const INK: Rgb = [30.0; 3];
const GRID: Rgb = [222.0; 3];
/// Colours that remain distinct in grey and for colour-blind readers (Okabe and Ito).
const COLOURS: [Rgb; 6] = [
    [0.0, 114.0, 178.0],
    [213.0, 94.0, 0.0],
    [0.0, 158.0, 115.0],
    [204.0, 121.0, 167.0],
    [86.0, 180.0, 233.0],
    [120.0, 120.0, 0.0],
];

/// Points of one series, joined by lines in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name in the legend.
    pub name: Text,
    /// Abscissa and ordinate, both positive; other points are left out.
    pub points: Vec<[f64; 2]>,
}

/// The content of a plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Title.
    pub title: Text,
    /// Quantity on the abscissa, with its unit.
    pub x: Text,
    /// Quantity on the ordinate, with its unit; written above the axis.
    pub y: Text,
    /// The series.
    pub series: Vec<Series>,
    /// A level of the ordinate to mark, and its name.
    pub level: Option<(f64, Text)>,
}

/// A stroke or a text of the drawing.
enum Mark {
    Line {
        from: [f64; 2],
        to: [f64; 2],
        half: f64,
        colour: Rgb,
    },
    Dot {
        at: [f64; 2],
        colour: Rgb,
    },
    /// Left end of the baseline.
    Text {
        at: [f64; 2],
        text: String,
        colour: Rgb,
    },
}

/// A logarithmic axis from `low` to `high`, with marks at one, two and five in each decade.
struct Axis {
    low: f64,
    high: f64,
}

impl Axis {
    /// The axis around the values, with a margin.
    fn around(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values.fold((f64::INFINITY, 0.0f64), |(l, h), v| (l.min(v), h.max(v)));
        if !(low > 0.0 && high > 0.0) {
            return Self { low: 1.0, high: 10.0 };
        }
        let margin = (high / low).powf(0.08).max(1.25);
        Self { low: low / margin, high: high * margin }
    }

    /// Position on the axis, from 0 at the low end to 1 at the high end.
    fn share(&self, value: f64) -> f64 {
        (value / self.low).ln() / (self.high / self.low).ln()
    }

    fn marks(&self) -> Vec<f64> {
        let decades = self.low.log10().floor() as i32..=self.high.log10().ceil() as i32;
        let all = decades.flat_map(|d| [1.0, 2.0, 5.0].map(|m| m * 10f64.powi(d)));
        let inside: Vec<f64> = all.filter(|v| (self.low..=self.high).contains(v)).collect();
        // over many decades the powers of ten are sufficient
        let many = inside.len() > 10;
        inside
            .into_iter()
            .filter(|v| !many || (v.log10() - v.log10().round()).abs() < 1e-9)
            .collect()
    }
}

/// Short label of a mark: `0.02`, `500`, `20k`.
fn label(value: f64) -> String {
    match value {
        v if v >= 0.9995e6 => format!("{}M", short(v / 1e6)),
        v if v >= 9.995e3 => format!("{}k", short(v / 1e3)),
        v => short(v),
    }
}

fn short(v: f64) -> String {
    let places = (-(v.log10().floor())).clamp(0.0, 6.0) as usize;
    format!("{v:.places$}")
}

impl Plot {
    /// The texts of the plot.
    fn texts(&self) -> Vec<Text> {
        let level = self.level.iter().map(|(_, name)| name);
        let series = self.series.iter().map(|s| &s.name);
        [&self.title, &self.x, &self.y].into_iter().chain(series).chain(level).cloned().collect()
    }

    fn marks(&self, words: &Words) -> Vec<Mark> {
        let good = |p: &&[f64; 2]| p.iter().all(|v| *v > 0.0 && v.is_finite());
        let points = || self.series.iter().flat_map(|s| s.points.iter().filter(good));
        let level = self.level.iter().map(|(v, _)| *v);
        let axes = [
            Axis::around(points().map(|p| p[0])),
            Axis::around(points().map(|p| p[1]).chain(level)),
        ];
        let [left, top, right, bottom] = FRAME;
        let place = |p: [f64; 2]| {
            let [x, y] = [axes[0].share(p[0]), axes[1].share(p[1])];
            [left + x * (right - left), bottom - y * (bottom - top)]
        };
        let mut marks = Vec::new();
        let line = |from, to, half, colour| Mark::Line { from, to, half, colour };
        let text = |at, text: &str, colour| Mark::Text { at, text: text.into(), colour };
        for v in axes[0].marks() {
            let [x, _] = place([v, axes[1].low]);
            marks.push(line([x, top], [x, bottom], 0.4, GRID));
            let name = label(v);
            marks.push(text([x - 0.5 * text_width(&name, LETTERS), bottom + 18.0], &name, INK));
        }
        for v in axes[1].marks() {
            let [_, y] = place([axes[0].low, v]);
            marks.push(line([left, y], [right, y], 0.4, GRID));
            let name = label(v);
            marks.push(text(
                [left - 8.0 - text_width(&name, LETTERS), y + 0.5 * LETTERS],
                &name,
                INK,
            ));
        }
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        (0..4).for_each(|i| marks.push(line(corners[i], corners[(i + 1) % 4], 0.5, INK)));
        if let Some((v, name)) = &self.level {
            let [_, y] = place([axes[0].low, *v]);
            let dashes = ((right - left) / 12.0) as usize;
            for i in 0..dashes {
                let x = left + 12.0 * i as f64;
                marks.push(line([x, y], [x + 6.0, y], 0.6, INK));
            }
            marks.push(text([left + 6.0, y - 5.0], &words.say(name), INK));
        }
        for (i, s) in self.series.iter().enumerate() {
            let colour = COLOURS[i % COLOURS.len()];
            let places: Vec<[f64; 2]> = s.points.iter().filter(good).map(|p| place(*p)).collect();
            marks.extend(places.windows(2).map(|p| line(p[0], p[1], 0.9, colour)));
            marks.extend(places.iter().map(|p| Mark::Dot { at: *p, colour }));
            // curves that fall from left to right leave the top right corner free
            let name = words.say(&s.name);
            let at = [right - 14.0 - text_width(&name, LETTERS), top + 20.0 + 18.0 * i as f64];
            marks.push(line(
                [at[0] - 30.0, at[1] - 0.5 * LETTERS],
                [at[0] - 10.0, at[1] - 0.5 * LETTERS],
                0.9,
                colour,
            ));
            marks.push(Mark::Dot { at: [at[0] - 20.0, at[1] - 0.5 * LETTERS], colour });
            marks.push(text(at, &name, INK));
        }
        marks.push(text([left, 22.0], &words.say(&self.title), INK));
        marks.push(text([10.0, top - 8.0], &words.say(&self.y), INK));
        let x = words.say(&self.x);
        let middle = 0.5 * (left + right - text_width(&x, LETTERS));
        marks.push(text([middle, HEIGHT - 14.0], &x, INK));
        marks
    }

    /// As a picture with its texts in `words`.
    pub fn picture(&self, words: &Words) -> Picture {
        let mut canvas = Canvas::new(WIDTH as usize, HEIGHT as usize, PAPER);
        for mark in self.marks(words) {
            match mark {
                Mark::Line { from, to, half, colour } => canvas.line(from, to, half, colour),
                Mark::Dot { at, colour } => canvas.line(at, at, 3.2, colour),
                Mark::Text { at, text, colour } => {
                    canvas.text(&text, at[0], at[1], LETTERS, colour)
                }
            }
        }
        canvas.finish()
    }

    /// As a drawing.
    pub fn svg(&self) -> Svg {
        let hex = |c: Rgb| format!("#{:02x}{:02x}{:02x}", c[0] as u8, c[1] as u8, c[2] as u8);
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
             viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"13\">\n<rect \
             width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#ffffff\"/>\n"
        );
        for mark in self.marks(&Words::default()) {
            // writing to a String cannot fail
            let _ = match mark {
                Mark::Line { from: [x1, y1], to: [x2, y2], half, colour } => writeln!(
                    out,
                    "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" \
                     stroke=\"{}\" stroke-width=\"{}\"/>",
                    hex(colour),
                    2.0 * half
                ),
                Mark::Dot { at: [x, y], colour } => {
                    writeln!(
                        out,
                        "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.5\" fill=\"{}\"/>",
                        hex(colour)
                    )
                }
                Mark::Text { at: [x, y], text, colour } => {
                    let text = escaped(&text);
                    writeln!(
                        out,
                        "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{}\">{text}</text>",
                        hex(colour)
                    )
                }
            };
        }
        out.push_str("</svg>\n");
        Svg { file: out, texts: self.texts() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot() -> Plot {
        Plot {
            title: "gap".into(),
            x: "tets".into(),
            y: "gap [%]".into(),
            series: vec![
                Series {
                    name: "uniform".into(),
                    points: vec![[1e3, 4.0], [8e3, 2.0], [64e3, 1.0]],
                },
                Series {
                    name: Text::given("a<b"),
                    points: vec![[1e3, 4.0], [8e3, 0.5], [0.0, 1.0], [f64::NAN, 1.0]],
                },
            ],
            level: Some((2.0, "target".into())),
        }
    }

    /// Equal ratios have equal distances, and the marks of a decade lie at their logarithms.
    #[test]
    fn axes_are_logarithmic() {
        let axis = Axis { low: 10.0, high: 1000.0 };
        assert!(
            (axis.share(100.0) - 0.5).abs() < 1e-15
                && axis.share(10.0) == 0.0
                && axis.share(1000.0) == 1.0
        );
        assert_eq!(axis.marks(), [10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0]);
        assert_eq!([0.02, 5.0, 500.0, 2e4, 1e6].map(label), ["0.02", "5", "500", "20k", "1M"]);
        assert!(Axis::around([].into_iter()).marks().len() > 1);
    }

    /// Both forms have a dot for every valid point and for each name in the legend. Names cannot
    /// break the text. Points without a logarithm are left out.
    #[test]
    fn every_good_point_is_drawn() {
        let svg = plot().svg().file;
        assert_eq!(svg.matches("<circle").count(), 5 + 2);
        assert!(svg.contains("a&lt;b") && !svg.contains("NaN") && !svg.contains("inf"));
        let picture = plot().picture(&Words::default());
        let blue = COLOURS[0].map(|c| c as u8);
        let count = (0..picture.width * picture.height)
            .filter(|i| picture.pixel(i % picture.width, i / picture.width) == blue)
            .count();
        assert!(count > 4 * 20, "{count}");
        assert_eq!(plot().picture(&Words::default()), picture);
    }
}
