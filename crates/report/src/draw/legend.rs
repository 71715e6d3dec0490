//! Texts of a picture: the colour legend, and the strip below the shape with axes, scale bar and
//! names.

use crate::draw::canvas::Canvas;
use crate::draw::canvas::SAMPLES;
use crate::draw::lettering::text_width;
use crate::draw::options::{Field, Mark, PictureOptions};
use crate::draw::palette::{BACKGROUND, BODY_COLOURS, Bands, Groups, INK, nice};
use crate::draw::view::{LEGEND, LETTER, MARGIN, View};

/// Height of the capitals of body names \[pixels\]: there may be ten of them in a line.
const NAME: f64 = 14.0;

/// The colour legend of a field with a line below it, from the picture's top to `bottom`.
pub(super) fn legend(
    canvas: &mut Canvas,
    bands: &Bands,
    (field, note): (Field, Option<&str>),
    [left, bottom]: [f64; 2],
) {
    let mut y = MARGIN + LETTER;
    let mut title = |canvas: &mut Canvas, text: &str| {
        let size = LETTER.min(LETTER * (LEGEND - 32.0) / text_width(text, LETTER).max(1.0));
        canvas.text(text, left, y, size, INK);
        y += 1.7 * LETTER;
    };
    title(canvas, field.name);
    if !field.unit.is_empty() {
        title(canvas, &format!("[{}]", field.unit));
    }
    let foot = if note.is_some() { 5.5 } else { 4.0 } * LETTER;
    let height = ((bottom - y - foot) / bands.count as f64).clamp(8.0, 44.0);
    let top = y;
    let label_every = (1.6 * LETTER / height).ceil().max(1.0) as usize;
    for i in 0..bands.count {
        // high values at the top
        let box_top = top + (bands.count - 1 - i) as f64 * height;
        canvas.rectangle([left, box_top], [left + 34.0, box_top + height], bands.colour(i));
        canvas.frame([left, box_top], [left + 34.0, box_top + height], INK);
    }
    for i in (0..=bands.count).step_by(label_every) {
        let at = top + (bands.count - i) as f64 * height;
        canvas.line([left + 34.0, at], [left + 40.0, at], 0.6, INK);
        // the last colour is also that of larger values
        let more = if i == bands.count && bands.exceeded() { "+" } else { "" };
        let label = bands.label(i) + more;
        canvas.text(&label, left + 46.0, at + LETTER / 2.0 - 1.0, LETTER * 0.9, INK);
    }
    if bands.extremes[0].is_finite() {
        let foot = top + bands.count as f64 * height + 2.0 * LETTER;
        let [low, high] = bands.extremes;
        // rounding errors of a field that is zero there
        let low = if low.abs() < 1e-6 * high.abs() { 0.0 } else { low };
        canvas.text(&format!("min {}", four_digits(low)), left, foot, LETTER * 0.8, INK);
        canvas.text(
            &format!("max {}", four_digits(high)),
            left,
            foot + 1.5 * LETTER,
            LETTER * 0.8,
            INK,
        );
        if let Some(note) = note {
            canvas.text(note, left, foot + 3.0 * LETTER, LETTER * 0.8, INK);
        }
    }
}

/// Radius of the ring around a marked point, and length of the line to its text \[pixels\].
const RING: f64 = 11.0;
const LEADER: f64 = 60.0;

/// A ring around a point of the shape, and a text in a box beside it, left of `right`.
pub(super) fn mark(canvas: &mut Canvas, view: &View, marked: Mark, right: f64) {
    let [x, y, _] = view.sample(marked.at).map(|x| x / SAMPLES as f64);
    let corner = |i: u32| {
        let angle = f64::from(i) * std::f64::consts::PI / 12.0;
        [x + RING * angle.cos(), y + RING * angle.sin()]
    };
    for (half, ink) in [(2.6, BACKGROUND), (1.2, INK)] {
        (0..24).for_each(|i| canvas.line(corner(i), corner(i + 1), half, ink));
    }
    let (width, height) = (text_width(marked.text, LETTER) + 16.0, LETTER + 14.0);
    // to the side and height on which there is room
    let aside = if x + RING + LEADER + width < right { 1.0 } else { -1.0 };
    let upwards = if y > RING + LEADER + height { -1.0 } else { 1.0 };
    let diagonal = std::f64::consts::FRAC_1_SQRT_2;
    let from = [x + aside * RING * diagonal, y + upwards * RING * diagonal];
    let to = [x + aside * LEADER, y + upwards * LEADER];
    canvas.line(from, to, 1.2, INK);
    let left = if aside > 0.0 { to[0] } else { to[0] - width };
    let [top, low] = [to[1] - 0.5 * height, to[1] + 0.5 * height];
    canvas.rectangle([left, top], [left + width, low], BACKGROUND);
    canvas.frame([left, top], [left + width, low], INK);
    canvas.text(marked.text, left + 8.0, to[1] + 0.5 * LETTER, LETTER, INK);
}

fn four_digits(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e6).contains(&x.abs()) {
        return format!("{x:.3e}");
    }
    let decimals = (3 - x.abs().log10().floor() as i32).max(0) as usize;
    format!("{x:.decimals$}")
}

/// Scale bar, names of the bodies, magnification and axes below the shape.
pub(super) fn strip(canvas: &mut Canvas, view: &View, groups: &Groups, options: &PictureOptions) {
    let base = view.strip_top + 46.0;
    let mut x = axes(canvas, view, [MARGIN + 36.0, view.strip_top + 42.0]) + 28.0;
    let length = nice(110.0 / view.scale);
    let end = x + length * view.scale;
    canvas.line([x, base], [end, base], 1.4, INK);
    for at in [x, end] {
        canvas.line([at, base - 6.0], [at, base + 6.0], 1.0, INK);
    }
    let text = format!("{} mm", four_digits_plain(length));
    canvas.text(&text, 0.5 * (x + end) - 0.5 * text_width(&text, LETTER), base - 10.0, LETTER, INK);
    x = end + 40.0;
    if let Some(deformed) = options.deformed {
        canvas.text(deformed.caption, x, base, LETTER, INK);
        x += text_width(deformed.caption, LETTER) + 36.0;
    }
    if options.field.is_none() {
        for (i, name) in groups.names.iter().enumerate() {
            let width = 24.0 + text_width(name, NAME);
            if x + width > view.width as f64 - MARGIN {
                break;
            }
            canvas.rectangle(
                [x, base - NAME],
                [x + 16.0, base + 2.0],
                BODY_COLOURS[i % BODY_COLOURS.len()],
            );
            canvas.frame([x, base - NAME], [x + 16.0, base + 2.0], INK);
            canvas.text(name, x + 24.0, base, NAME, INK);
            x += width + 28.0;
        }
    }
}

fn four_digits_plain(x: f64) -> String {
    let text = four_digits(x);
    if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text
    }
}

/// The three axes in the view; returns their right end.
fn axes(canvas: &mut Canvas, view: &View, at: [f64; 2]) -> f64 {
    let directions = [0, 1, 2].map(|k| [30.0 * view.right[k], -30.0 * view.up[k]]);
    for (direction, name) in directions.iter().zip(["x", "y", "z"]) {
        let length = direction[0].hypot(direction[1]);
        let tip = [at[0] + direction[0], at[1] + direction[1]];
        canvas.line(at, tip, 1.0, INK);
        if length < 6.0 {
            continue;
        }
        let along = direction.map(|c| c / length);
        for side in [-1.0, 1.0] {
            let back = [
                tip[0] - 7.0 * along[0] - side * 3.0 * along[1],
                tip[1] - 7.0 * along[1] + side * 3.0 * along[0],
            ];
            canvas.line(tip, back, 1.0, INK);
        }
        let letter = [tip[0] + 11.0 * along[0] - 3.5, tip[1] + 11.0 * along[1] + 4.0];
        canvas.text(name, letter[0], letter[1], 11.0, INK);
    }
    at[0] + 46.0
}
