//! Pictures of limit analysis: the mechanism of the upper bound and the zones that limit the lower
//! bound, each on the mesh of its own pass, cut open where most of it happens.

use crate::driver::passes::Kept;
use crate::driver::pictures::png;
use bracket_base::diag::Diagnostics;
use bracket_base::math::vec3::{self, V3};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::analysis::limit::{LimitPass, SUBDIVISIONS};
use bracket_engine::certify::limit_certificate::dissipation_densities;
use bracket_engine::certify::velocity_field::VelocityField;
use bracket_engine::mesh::TetMesh;
use bracket_engine::model::AnalysisModel;
use bracket_report::document::picture::PictureRef;
use bracket_report::draw::enlarged::{MARKED, enlargement, is_small};
use bracket_report::draw::raster::{Colours, Deformed, Field, PictureOptions, draw};
use bracket_report::draw::section::{Plane, Section};
use bracket_report::draw::whole::Whole;
use bracket_report::result::folder::ResultFolder;
use bracket_report::words::Words;

/// Share of the dissipation below which the bodies count as rigid compared with welds and
/// supports.
const LITTLE: f64 = 1e-3;
/// Part of the whole in the densest places, at whose least density the colours end.
const BRIGHT: f64 = 0.5;
/// Largest displacement of a drawn mechanism, over the size of the shape.
const EXAGGERATED: f64 = 0.08;
/// Slices of the shape in which the place of the cut is sought.
const SLICES: usize = 40;
/// Largest number of places that a caption names, and the least share of a named place.
const NAMED: (usize, f64) = (3, 0.05);

/// Pictures of a load factor: mechanism and limiting zones, as far as they are known.
pub fn collapse_pictures(
    (upper, lower): (&Kept, &Kept),
    (name, stem): (&str, &str),
    (mirror, words): (&[usize], &Words),
    folder: &ResultFolder,
) -> Result<Vec<PictureRef>, Diagnostics> {
    let mut out = Vec::new();
    let AnalysisPass::Factor(pass) = &upper.outcome else { return Ok(out) };
    let velocity = pass.velocity.as_ref().or(pass.free.as_ref().map(|f| &f.field));
    // both pictures are seen from the same side
    let axis = match velocity {
        Some(v) => quiet_axis(&v.nodes.u[..upper.model.mesh.nodes.len()]),
        None => 1,
    };
    let mut add =
        |(kind, enlarged): (&str, &'static str), drawn: Drawn| -> Result<(), Diagnostics> {
            let Some(drawn) = drawn else { return Ok(()) };
            let (pictures, caption) = drawn?;
            let captions = [caption, say!("Case {}: {}", name.to_owned(), enlarged)];
            let files = [format!("{kind}_{stem}.png"), format!("zone_{kind}_{stem}.png")];
            for ((file, bytes), caption) in files.into_iter().zip(pictures).zip(captions) {
                folder.write(&file, &bytes)?;
                out.push(PictureRef { file, caption, ..PictureRef::default() });
            }
            Ok(())
        };
    if let Some(v) = velocity {
        add(
            ("mechanism", "the mechanism, enlarged"),
            mechanism(pass, v, (&upper.model, mirror, axis), (name, words)),
        )?;
    }
    if let Some(share) = lower.outcome.yield_multiplier_share() {
        add(
            ("limiting", "the limiting zones, enlarged"),
            limiting(share, (&lower.model, mirror, axis), (name, words)),
        )?;
    }
    Ok(out)
}

/// The bytes of a picture, those of its enlarged zone if it is small, and the caption; `None`:
/// there is nothing to draw.
type Drawn = Option<Result<(Vec<Vec<u8>>, Text), Diagnostics>>;

fn mechanism(
    pass: &LimitPass,
    v: &VelocityField,
    scene: (&AnalysisModel, &[usize], usize),
    (name, words): (&str, &Words),
) -> Drawn {
    let model = scene.0;
    let u = &v.nodes.u[..model.mesh.nodes.len()];
    let size: Vec<f64> = u.iter().map(|x| vec3::norm(*x)).collect();
    let factor = enlargement(&model.mesh.nodes, &size, EXAGGERATED)?;
    let mut densities = dissipation_densities(model, v, SUBDIVISIONS);
    let shown = match shares_of(pass) {
        Some([bodies, ..]) if bodies < LITTLE => {
            // the remaining plastic flow is rounding error and is not drawn
            densities.fill(0.0);
            "welds, slip, ground and limited forces dissipate all, the parts do not flow".into()
        }
        Some([bodies, welds, supports, ties, ground, limits]) => {
            let others = [
                (welds, "in welds"),
                (ground, "in crushed ground"),
                (supports, "by slip on supports"),
                (ties, "by slip between bodies"),
                (limits, "at limited forces"),
            ];
            say!(
                "coloured by its dissipation: {}; half of that in the bodies has a density above 1",
                by_body(model, &densities, bodies, &others)
            )
        }
        None => {
            densities.fill(0.0);
            "nothing dissipates".into()
        }
    };
    let zones = Zones { densities, title: "dissipation density", colours: Colours::Fire, words };
    let (pictures, cut) = match zones.draw(scene, Some((u, factor))) {
        Ok(drawn) => drawn,
        Err(e) => return Some(Err(e)),
    };
    let tets = model.mesh.tets.len();
    let caption = say!(
        "Case {}: mechanism of the upper bound, {}. Mesh of {} tetrahedra, deformed not to \
         scale{}; the grey lines are the edges at rest",
        name.to_owned(),
        shown,
        tets,
        cut
    );
    Some(Ok((pictures, caption)))
}

/// The share of each tet in the multipliers of the yield conditions, per volume.
pub fn limiting_densities(mesh: &TetMesh, share: &[f64]) -> Vec<f64> {
    share.iter().enumerate().map(|(e, s)| s.max(0.0) / mesh.volume(e)).collect()
}

fn limiting(
    share: &[f64],
    scene: (&AnalysisModel, &[usize], usize),
    (name, words): (&str, &Words),
) -> Drawn {
    let model = scene.0;
    if share.iter().sum::<f64>() <= 0.0 {
        return None;
    }
    let densities = limiting_densities(&model.mesh, share);
    let bodies = by_body(model, &densities, 1.0, &[]);
    let zones = Zones { densities, title: "limiting zones", colours: Colours::Violet, words };
    let (pictures, cut) = match zones.draw(scene, None) {
        Ok(drawn) => drawn,
        Err(e) => return Some(Err(e)),
    };
    let tets = model.mesh.tets.len();
    let caption = say!(
        "Case {}: zones that limit the lower bound, coloured where more strength would raise it: \
         {}; half of the gain has a density above 1. Mesh of {} tetrahedra{}",
        name.to_owned(),
        bodies,
        tets,
        cut
    );
    Some(Ok((pictures, caption)))
}

/// Shares of bodies, welds, slip on supports, slip along ties, crushed ground and resultant limits
/// in the dissipation of a mechanism; `None` if nothing dissipates.
fn shares_of(pass: &LimitPass) -> Option<[f64; 6]> {
    let c = pass.upper.as_ref()?.certificate();
    let each = [&c.dissipation, &c.welds, &c.supports, &c.ties, &c.ground, &c.resultants];
    let shares = each.map(|d| d.iter().sum::<f64>());
    let total: f64 = shares.iter().sum();
    (total > 0.0).then(|| shares.map(|d| d / total))
}

/// The bodies with the largest shares, and other places with theirs, as text: `60 % in PLATE, 30 %
/// in BOLT_1, 10 % in welds`. The bodies together have the share `of_bodies`.
fn by_body(
    model: &AnalysisModel,
    densities: &[f64],
    of_bodies: f64,
    others: &[(f64, &'static str)],
) -> Text {
    let mesh = &model.mesh;
    let mut sums = vec![0.0; mesh.bodies.len()];
    for (e, d) in densities.iter().enumerate() {
        sums[mesh.tet_body[e] as usize] += d * mesh.volume(e);
    }
    let total: f64 = sums.iter().sum();
    let mut places: Vec<(f64, Text)> = sums
        .iter()
        .zip(&mesh.bodies)
        .map(|(s, body)| (of_bodies * s / total, say!("in {}", body)))
        .chain(others.iter().map(|(share, place)| (*share, (*place).into())))
        .collect();
    places.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (most, least) = NAMED;
    let named = places.iter().take(most).enumerate().filter(|(i, p)| *i == 0 || p.0 >= least);
    let percent = |share: &f64| format!("{:.0}", 100.0 * share);
    Text::joined(", ", named.map(|(_, (share, place))| say!("{} % {}", percent(share), place)))
}

/// The horizontal axis along which the least moves.
fn quiet_axis(u: &[V3]) -> usize {
    let motion = [0, 1, 2].map(|k| u.iter().map(|u| u[k].abs()).sum::<f64>());
    // a mechanism in a vertical plane is seen along the normal of this plane
    let [x, y] = [motion[0], motion[1]];
    if x < y { 0 } else { 1 }
}

/// Zones of a body that a picture shows.
struct Zones<'a> {
    /// Value per volume of each tet.
    densities: Vec<f64>,
    title: &'static str,
    colours: Colours,
    words: &'a Words,
}

impl Zones<'_> {
    /// Draws the zones on the mesh, displaced if a displacement and its factor are given. Returns
    /// the picture and the words on the cut.
    fn draw(
        &self,
        (model, mirror, axis): (&AnalysisModel, &[usize], usize),
        displaced: Option<(&[V3], f64)>,
    ) -> Result<(Vec<Vec<u8>>, Text), Diagnostics> {
        let whole = Whole::of(&model.mesh, mirror);
        let values = at_nodes(&model.mesh, &self.densities);
        let mut mesh = whole.mesh.clone();
        let mut values = whole.scalars(&values);
        let mut moved = displaced.map(|(u, _)| whole.vectors(u, &[]));
        let plane = self.plane(model, axis, mirror.contains(&axis));
        let mut cut = Text::default();
        if let Some(plane) = plane {
            let section = Section::of(&whole.mesh, plane);
            if !section.mesh.tets.is_empty() {
                values = section.scalars(&values);
                moved = moved.map(|u| section.vectors(&u));
                mesh = section.mesh;
                let side = match plane.removes_above {
                    true => "the part beyond is left out",
                    false => "the part before is left out",
                };
                let at = format!("{} = {:.0} mm", ["x", "y", "z"][plane.axis], plane.at);
                cut = say!(", cut at {}, {}", at, side);
            }
        }
        let front = match plane {
            Some(plane) if plane.removes_above => 1.0,
            None if axis == 0 => 1.0,
            _ => -1.0,
        };
        let eye = view(axis, front);
        let field = Field {
            name: &self.words.say(&self.title.into()),
            unit: &self.words.say(&"relative".into()),
            values: &values,
            range: Some([0.0, 1.0]),
            colours: self.colours,
        };
        let caption = self.words.say(&"velocities, not to scale".into());
        let deformed = moved.as_ref().zip(displaced).map(|(u, (_, factor))| Deformed {
            displacement: u,
            factor,
            caption: &caption,
        });
        let options = PictureOptions {
            mesh_lines: false,
            eye: Some(eye),
            field: Some(field),
            ghost: deformed.is_some(),
            deformed,
            ..PictureOptions::default()
        };
        let mut pictures = vec![png(&draw(&mesh, &options))?];
        if is_small(&mesh.nodes, &values) {
            let close = PictureOptions { around: Some(MARKED), ..options };
            pictures.push(png(&draw(&mesh, &close))?);
        }
        Ok((pictures, cut))
    }

    /// The cut through the slice with the largest sum, seen from the side of the drawing, along x
    /// from the nearer side; `None` where nothing is to be seen or little hides it.
    fn plane(&self, model: &AnalysisModel, axis: usize, mirrored: bool) -> Option<Plane> {
        let mesh = &model.mesh;
        let at = |x: &V3| x[axis];
        let low = mesh.nodes.iter().map(at).fold(f64::INFINITY, f64::min);
        let high = mesh.nodes.iter().map(at).fold(f64::NEG_INFINITY, f64::max);
        let width = (high - low) / SLICES as f64;
        let mut slices = vec![0.0; SLICES];
        for (e, d) in self.densities.iter().enumerate() {
            let centre = mesh.corners(e).iter().map(at).sum::<f64>() / 4.0;
            slices[(((centre - low) / width) as usize).min(SLICES - 1)] += d * mesh.volume(e);
        }
        if slices.iter().sum::<f64>() <= 0.0 {
            return None;
        }
        let most = (0..SLICES).max_by(|a, b| slices[*a].total_cmp(&slices[*b]).then(b.cmp(a)))?;
        let place = low + (most as f64 + 0.5) * width;
        if axis == 1 {
            // seen as the drawing shows the joint, x to the right: from the side of negative y
            let at = if mirrored { -place.abs() } else { place };
            return Some(Plane { axis, at, removes_above: false });
        }
        let removes_above = mirrored || place >= 0.5 * (low + high);
        Some(Plane { axis, at: place, removes_above })
    }
}

/// Densities at the nodes, relative to the density above which lies the bright part of the
/// whole.
pub fn at_nodes(mesh: &TetMesh, densities: &[f64]) -> Vec<f64> {
    let volumes: Vec<f64> = (0..mesh.tets.len()).map(|e| mesh.volume(e)).collect();
    let mut order: Vec<usize> = (0..mesh.tets.len()).collect();
    order.sort_by(|a, b| densities[*b].total_cmp(&densities[*a]).then(a.cmp(b)));
    let total: f64 = densities.iter().zip(&volumes).map(|(d, v)| d * v).sum();
    let mut sum = 0.0;
    let mut top = 0.0;
    for e in order {
        sum += densities[e] * volumes[e];
        top = densities[e];
        if sum >= BRIGHT * total {
            break;
        }
    }
    let top = if top > 0.0 { top } else { 1.0 };
    let mut nodes = vec![(0.0, 0.0); mesh.nodes.len()];
    for (e, tet) in mesh.tets.iter().enumerate() {
        tet.iter().for_each(|&n| {
            let sum = &mut nodes[n as usize];
            *sum = (sum.0 + volumes[e] * densities[e], sum.1 + volumes[e]);
        });
    }
    let mean = |(d, v): (f64, f64)| if v > 0.0 { d / v / top } else { 0.0 };
    nodes.into_iter().map(mean).collect()
}

/// Direction to the eye: along the axis from its positive (+1) or negative (−1) side, turned a
/// little and from above.
fn view(axis: usize, front: f64) -> V3 {
    let (turn, tilt) = (24.0_f64.to_radians(), 16.0_f64.to_radians());
    let (along, aside) = (front * turn.cos() * tilt.cos(), turn.sin() * tilt.cos());
    if axis == 0 { [along, aside, tilt.sin()] } else { [aside, along, tilt.sin()] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mechanism in the plane of the joint is seen with x to the right and z up, as in the side
    /// view of the drawing.
    #[test]
    fn the_picture_is_seen_from_the_side_of_the_drawing() {
        let eye = view(1, -1.0);
        let right = vec3::cross([0.0, 0.0, 1.0], eye);
        assert!(eye[1] < 0.0 && right[0] > 0.8, "{eye:?}");
    }
}
