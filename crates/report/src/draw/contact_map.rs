//! Contact pressure between two parts, or on ground that crushes: the faces on a plane, coloured by
//! the pressure of the static field.

use crate::draw::svg::{Anchor, Drawing, LINE, Pen, Svg};
use crate::figures::{Rounding, significant};
use crate::result::forces::ContactForce;
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::certify::faces::{ContactFace, contact_faces};
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

/// Fill of faces at the strength of the ground.
const CRUSHED: &str = "#3f007d";
/// Part of the strength from which a face counts as crushed.
const AT_STRENGTH: f64 = 0.99;

/// A face on its plane.
#[derive(Clone, Copy)]
struct Patch {
    /// Corners \[mm\].
    corners: [[f64; 2]; 3],
    /// Mean pressure \[MPa\].
    pressure: f64,
    /// True on ground at its strength.
    crushed: bool,
}

/// What a map shows beside its faces.
struct Shown {
    title: Text,
    /// The pressure at which the colours end \[MPa\].
    peak: f64,
    /// True on ground that crushes: the peak is its strength.
    ground: bool,
}

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
    let between = |face: &ContactFace<'_>| {
        let sides = [body(face.a.tet), face.b.and_then(|(b, _)| body(b.tet))];
        sides.iter().zip(&pair.between).all(|(s, name)| *s == Some(name))
    };
    let (axes, patches) = patches(model, stress, mirror, between)?;
    let peak = patches.iter().map(|p| p.pressure).fold(0.0, f64::max);
    let [a, b] = &pair.between;
    let title = say!("Contact pressure, {} on {}", a, b);
    (peak > 0.0).then(|| draw(&patches, axes, &Shown { title, peak, ground: false }))
}

/// The map of the pressure on ground that crushes, completed in the same way. `None` if there is no
/// such ground, or if its faces do not lie on one plane normal to an axis.
pub fn ground_map(model: &AnalysisModel, stress: &StressField, mirror: &[usize]) -> Option<Svg> {
    let crushes = |face: &ContactFace<'_>| model.crushing_strength(face.of).is_some();
    let (axes, patches) = patches(model, stress, mirror, crushes)?;
    let peak = model.ground.iter().filter_map(|g| g.strength).fold(0.0, f64::max);
    let title = "Pressure on the ground".into();
    Some(draw(&patches, axes, &Shown { title, peak, ground: true }))
}

/// The faces that are kept, with the axes of their plane on the page; `None` if they lie on more
/// than one plane, or there is none.
fn patches(
    model: &AnalysisModel,
    stress: &StressField,
    mirror: &[usize],
    keep: impl Fn(&ContactFace<'_>) -> bool,
) -> Option<([usize; 2], Vec<Patch>)> {
    let mut plane: Option<(usize, f64)> = None;
    let mut patches: Vec<Patch> = Vec::new();
    for face in contact_faces(model).into_iter().filter(|f| keep(f)) {
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
        let crushed = model.crushing_strength(face.of).is_some_and(|f| pressure >= AT_STRENGTH * f);
        patches.push(Patch { corners: corners.map(|x| [x[u], x[v]]), pressure, crushed });
    }
    let (axis, _) = plane?;
    let [u, v] = page_axes(axis);
    for (page, _) in [u, v].into_iter().enumerate().filter(|(_, k)| mirror.contains(k)) {
        let copies: Vec<Patch> = patches
            .iter()
            .map(|p| {
                let turned = p.corners.map(|mut c| {
                    c[page] = -c[page];
                    c
                });
                Patch { corners: turned, ..*p }
            })
            .collect();
        patches.extend(copies);
    }
    Some(([u, v], patches))
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

fn draw(patches: &[Patch], [u, v]: [usize; 2], shown: &Shown) -> Svg {
    let peak = shown.peak;
    let all = || patches.iter().flat_map(|p| p.corners);
    let low = all().fold([f64::MAX; 2], |l, c| [l[0].min(c[0]), l[1].min(c[1])]);
    let high = all().fold([f64::MIN; 2], |h, c| [h[0].max(c[0]), h[1].max(c[1])]);
    let scale = (SIDES[0] / (high[0] - low[0])).min(SIDES[1] / (high[1] - low[1]));
    let at =
        |c: [f64; 2]| [MARGIN + LINE + scale * (c[0] - low[0]), MARGIN + scale * (high[1] - c[1])];
    let mut d = Drawing::default();
    // the lines of a fine mesh would hide the colours
    let pen = if patches.len() > MOST_LINED { Pen::None } else { Pen::Thin };
    for p in patches {
        let fill = if p.crushed { CRUSHED } else { colour(p.pressure, peak) };
        d.polygon(pen, fill, &p.corners.map(at));
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
    if shown.ground {
        let top = top + 1.25 * LINE;
        d.rectangle(Pen::Thin, CRUSHED, [legend, top], [legend + 22.0, top + LINE]);
        d.text([legend + 30.0, top + 12.0], Anchor::Start, "crushed: at the strength");
    }
    d.finish(shown.title.clone())
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
        let patch = |corners, pressure, crushed| Patch { corners, pressure, crushed };
        let patches = [
            patch([[0.0, 0.0], [40.0, 0.0], [0.0, 80.0]], 100.0, false),
            patch([[40.0, 0.0], [40.0, 80.0], [0.0, 80.0]], 0.0, false),
        ];
        let shown = |ground| Shown { title: Text::given("P on C"), peak: 100.0, ground };
        let svg = draw(&patches, page_axes(0), &shown(false)).file;
        assert!(!svg.contains(CRUSHED), "{svg}");
        let on_ground = [patch(patches[0].corners, 99.5, true)];
        let crushed = draw(&on_ground, page_axes(2), &shown(true)).file;
        // the face and its place in the legend
        assert_eq!(crushed.matches(CRUSHED).count(), 2, "{crushed}");
        for part in
            ["P on C", "80.0 … 100", "2.00 … 20.0", "y = 0 mm", "z from 0 to 80.00 mm", BANDS[4]]
        {
            assert!(svg.contains(part), "{part}: {svg}");
        }
        assert_eq!(svg.matches("<polygon").count(), 2);
    }
}
