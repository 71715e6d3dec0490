//! Contact pressure between two parts: the contact faces on a plane, coloured by the pressure of
//! the static field.

use crate::draw::svg::{Anchor, Drawing, LINE, Pen, Svg};
use crate::figures::{Rounding, significant};
use crate::result::forces::ContactForce;
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::certify::faces::contact_faces;
use bracket_engine::certify::fields::StressField;
use bracket_engine::certify::tractions::contact_tractions;
use bracket_engine::model::AnalysisModel;

/// Largest sides of the map \[pixels\].
const SIDES: [f64; 2] = [420.0, 320.0];
const MARGIN: f64 = 24.0;
/// Number of faces up to which their edges are drawn.
const MOST_LINED: usize = 600;
/// Fraction of the largest pressure below which a face counts as open.
const OPEN: f64 = 0.02;
/// Names of the axes.
pub const AXES: [&str; 3] = ["x", "y", "z"];
const NOTHING: &str = "#eef1f4";
const BANDS: [&str; 5] = ["#fde0c5", "#f8b58b", "#f2855d", "#e34f38", "#a50f15"];

/// A face on its plane: corners \[mm\] and mean pressure \[MPa\].
type Patch = ([[f64; 2]; 3], f64);

/// The map of the contact between two parts, completed by reflection in the planes of symmetry with
/// the normals `mirror`. `None` if there is no pressure, or if the faces do not lie on one plane
/// normal to an axis.
pub fn contact_map(
    model: &AnalysisModel,
    stress: &StressField,
    pair: &ContactForce,
    mirror: &[usize],
) -> Option<Svg> {
    let body = |tet: u32| model.mesh.bodies.get(model.mesh.tet_body[tet as usize] as usize);
    let mut plane: Option<(usize, f64)> = None;
    let mut patches: Vec<Patch> = Vec::new();
    for face in contact_faces(model) {
        let sides = [body(face.a.tet), face.b.and_then(|(b, _)| body(b.tet))];
        if !sides.iter().zip(&pair.between).all(|(s, name)| *s == Some(name)) {
            continue;
        }
        let (n, _) = face.normal(model);
        let corners = face.corners(model);
        let axis = (0..3).find(|&k| n[k].abs() > 1.0 - 1e-9)?;
        let here = (axis, corners[0][axis]);
        let (first, at) = *plane.get_or_insert(here);
        if first != axis || (at - here.1).abs() > 1e-6 {
            return None;
        }
        let pressure = contact_tractions(model, stress, &face, None)
            .map(|r| vec3::dot(r, n))
            .iter()
            .sum::<f64>()
            / 3.0;
        let [u, v] = page_axes(axis);
        patches.push((corners.map(|x| [x[u], x[v]]), pressure));
    }
    let (axis, _) = plane?;
    let peak = patches.iter().map(|p| p.1).fold(0.0, f64::max);
    if peak <= 0.0 {
        return None;
    }
    let [u, v] = page_axes(axis);
    for (page, _) in [u, v].into_iter().enumerate().filter(|(_, k)| mirror.contains(k)) {
        let copies: Vec<Patch> = patches
            .iter()
            .map(|(corners, pressure)| {
                let turned = corners.map(|mut c| {
                    c[page] = -c[page];
                    c
                });
                (turned, *pressure)
            })
            .collect();
        patches.extend(copies);
    }
    Some(draw(&patches, peak, [u, v], pair))
}

/// The axes that point right and up on the page, for a plane normal to `axis`. z points up where
/// possible.
fn page_axes(axis: usize) -> [usize; 2] {
    match axis {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    }
}

/// Colour of a pressure.
fn colour(pressure: f64, peak: f64) -> &'static str {
    let part = pressure / peak;
    if part < OPEN {
        return NOTHING;
    }
    // the largest pressure belongs to the last band
    BANDS[((part * BANDS.len() as f64) as usize).min(BANDS.len() - 1)]
}

fn draw(patches: &[Patch], peak: f64, [u, v]: [usize; 2], pair: &ContactForce) -> Svg {
    let all = || patches.iter().flat_map(|p| p.0);
    let low = all().fold([f64::MAX; 2], |l, c| [l[0].min(c[0]), l[1].min(c[1])]);
    let high = all().fold([f64::MIN; 2], |h, c| [h[0].max(c[0]), h[1].max(c[1])]);
    let scale = (SIDES[0] / (high[0] - low[0])).min(SIDES[1] / (high[1] - low[1]));
    let at =
        |c: [f64; 2]| [MARGIN + LINE + scale * (c[0] - low[0]), MARGIN + scale * (high[1] - c[1])];
    let mut d = Drawing::default();
    // the lines of a fine mesh would hide the colours
    let pen = if patches.len() > MOST_LINED { Pen::None } else { Pen::Thin };
    for (corners, pressure) in patches {
        d.polygon(pen, colour(*pressure, peak), &corners.map(at));
    }
    let [right, bottom] = at([high[0], low[1]]);
    // axes, with the extent of the faces
    let mm = |x: f64| significant(x, 4, Rounding::Nearest);
    d.text(
        [MARGIN + LINE, bottom + LINE],
        Anchor::Start,
        Text::given(format!("{} = {} mm", AXES[u], mm(low[0]))),
    );
    d.text([right, bottom + LINE], Anchor::End, Text::given(format!("{} mm", mm(high[0]))));
    let legend = right + 2.0 * MARGIN;
    d.text(
        [legend, MARGIN + 10.0],
        Anchor::Start,
        say!("{} from {} to {} mm", AXES[v].to_owned(), mm(low[1]), mm(high[1])),
    );
    d.text(
        [legend, MARGIN + 10.0 + 2.0 * LINE],
        Anchor::Start,
        "pressure [MPa], means of the faces",
    );
    let step = peak / BANDS.len() as f64;
    let show = |p: f64| significant(p, 3, Rounding::Nearest);
    for (i, fill) in BANDS.iter().enumerate().rev() {
        let top = MARGIN + 10.0 + (BANDS.len() - i + 2) as f64 * 1.25 * LINE;
        d.rectangle(Pen::Thin, fill, [legend, top], [legend + 22.0, top + LINE]);
        let from = if i == 0 { OPEN * peak } else { i as f64 * step };
        let range = format!("{} … {}", show(from), show((i + 1) as f64 * step));
        d.text([legend + 30.0, top + 12.0], Anchor::Start, Text::given(range));
    }
    let top = MARGIN + 10.0 + (BANDS.len() + 3) as f64 * 1.25 * LINE;
    d.rectangle(Pen::Thin, NOTHING, [legend, top], [legend + 22.0, top + LINE]);
    d.text([legend + 30.0, top + 12.0], Anchor::Start, "open, or next to nothing");
    let [a, b] = &pair.between;
    d.finish(say!("Contact pressure, {} on {}", a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every band has its colour, open faces have none, and the map shows its peak and its sides.
    #[test]
    fn bands_cover_the_pressures() {
        let found: Vec<&str> =
            [0.0, 0.5, 10.0, 30.0, 50.0, 70.0, 99.0, 100.0].map(|p| colour(p, 100.0)).to_vec();
        assert_eq!(found[..2], [NOTHING; 2]);
        assert_eq!(found[2..7], BANDS);
        assert_eq!(found[7], BANDS[4]);
        let pair =
            ContactForce { between: ["P".into(), "C".into()], compression: 1.0, centre: [0.0; 3] };
        let patches = [
            ([[0.0, 0.0], [40.0, 0.0], [0.0, 80.0]], 100.0),
            ([[40.0, 0.0], [40.0, 80.0], [0.0, 80.0]], 0.0),
        ];
        let svg = draw(&patches, 100.0, page_axes(0), &pair).file;
        for part in
            ["P on C", "80.0 … 100", "2.00 … 20.0", "y = 0 mm", "z from 0 to 80.00 mm", BANDS[4]]
        {
            assert!(svg.contains(part), "{part}: {svg}");
        }
        assert_eq!(svg.matches("<polygon").count(), 2);
    }
}
