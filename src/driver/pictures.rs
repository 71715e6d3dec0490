//! Pictures of a case: mesh, deformed shape or mechanism, contact pressures, convergence.

use crate::analysis::dispatch::AnalysisPass;
use crate::analysis::limit;
use crate::certify::fields::StressField;
use crate::certify::limit_certificate::dissipation_densities;
use crate::diag::{Diagnostic, Diagnostics};
use crate::math::vec3::{self, V3};
use crate::model::AnalysisModel;
use crate::report::draw::Picture;
use crate::report::draw::contact_map::contact_map;
use crate::report::draw::plot::{Plot, Series};
use crate::report::draw::raster::{Deformed, Field, PictureOptions, draw};
use crate::report::figures::{self, Rounding};
use crate::report::markdown::report_data::PictureRef;
use crate::result::file_names::file_stem;
use crate::result::folder::ResultFolder;
use crate::result::forces::StaticForces;
use crate::result::result_file::CaseResult;
use crate::result::result_file::HistoryRow;

fn png(picture: &Picture) -> Result<Vec<u8>, Diagnostics> {
    picture.to_png().map_err(|e| {
        Diagnostic::environment("report/picture", format!("the picture cannot be encoded: {e}"))
            .into()
    })
}

/// The mesh.
pub fn mesh_picture(
    model: &AnalysisModel,
    mirror: &[usize],
    folder: &ResultFolder,
) -> Result<PictureRef, Diagnostics> {
    let picture = draw(&model.mesh, &PictureOptions { mirror, ..PictureOptions::default() });
    folder.write("mesh.png", &png(&picture)?)?;
    let copies = if mirror.is_empty() { "" } else { ", completed by symmetry" };
    Ok(PictureRef {
        file: "mesh.png".into(),
        caption: format!("Mesh of {} tetrahedra{copies}", model.mesh.tets.len()),
    })
}

/// The contact pressures of a stress field that carries `factor` times the load, one picture for
/// each pair of parts.
pub fn contact_pictures(
    model: &AnalysisModel,
    (stress, factor): (&StressField, f64),
    forces: &StaticForces,
    mirror: &[usize],
    (name, stem): (&str, &str),
    folder: &ResultFolder,
) -> Result<Vec<PictureRef>, Diagnostics> {
    let mut out = Vec::new();
    for pair in &forces.contacts {
        let Some(map) = contact_map(model, stress, pair, mirror) else { continue };
        let file = format!("contact_{stem}_{}.svg", file_stem(&pair.between.join("_")));
        folder.write(&file, map.as_bytes())?;
        let (between, factor) =
            (pair.between.join(" on "), figures::significant(factor, 4, Rounding::Down));
        let caption = format!("Case {name}: contact pressure of {between} at load factor {factor}");
        out.push(PictureRef { file, caption });
    }
    Ok(out)
}

/// The gap against the size of the mesh, if there was more than one mesh.
pub fn convergence(
    entry: &CaseResult,
    target: Option<f64>,
    stem: &str,
    folder: &ResultFolder,
) -> Result<Option<PictureRef>, Diagnostics> {
    // meshes of one bound alternate: the size is that of the largest mesh so far
    let mut largest = 0;
    let row = |h: &HistoryRow| {
        largest = largest.max(h.macro_tets);
        Some([largest as f64, 100.0 * h.so_far.map_or(h.gap, |b| b.gap)?])
    };
    let points: Vec<[f64; 2]> = entry.history.iter().filter_map(row).collect();
    if points.len() < 2 {
        return Ok(None);
    }
    let plot = Plot {
        title: format!("{}: gap between the bounds, mesh after mesh", entry.name),
        x: "macro tets".into(),
        y: "gap [%]".into(),
        series: vec![Series { name: "adaptive".into(), points }],
        level: target.map(|t| (100.0 * t, "target".into())),
    };
    let file = format!("convergence_{stem}.png");
    folder.write(&file, &png(&plot.picture())?)?;
    Ok(Some(PictureRef {
        file,
        caption: format!("Case {}: gap against the size of the mesh", entry.name),
    }))
}

/// Share of the bodies in the dissipation of a mechanism; the rest is dissipated in the welds and
/// by slip on supports. `None` if nothing dissipates.
fn share_of_bodies(pass: &AnalysisPass) -> Option<f64> {
    let AnalysisPass::Factor(pass) = pass else { return None };
    let c = pass.upper.as_ref()?.certificate();
    let [bodies, welds, supports] =
        [&c.dissipation, &c.welds, &c.supports].map(|d| d.iter().sum::<f64>());
    let total = bodies + welds + supports;
    (total > 0.0).then(|| bodies / total)
}

/// The deformed shape coloured by the size of the displacement, or the mechanism coloured by its
/// dissipation.
pub fn pass_picture(
    pass: &AnalysisPass,
    name: &str,
    model: &AnalysisModel,
    mirror: &[usize],
    stem: &str,
    folder: &ResultFolder,
) -> Result<Option<PictureRef>, Diagnostics> {
    let mesh = &model.mesh;
    let (field, u) = match pass {
        AnalysisPass::Energy(p) => (None, p.displacement.as_ref()),
        AnalysisPass::Factor(p) => {
            let v = p.velocity.as_ref().or(p.free.as_ref().map(|f| &f.field));
            (v, v.map(|v| &v.nodes))
        }
    };
    let Some(u) = u else { return Ok(None) };
    let vertices = &u.u[..mesh.nodes.len()];
    let size: Vec<f64> = vertices.iter().map(|x| vec3::norm(*x)).collect();
    let Some(factor) = enlargement(&mesh.nodes, &size) else { return Ok(None) };
    let (values, range);
    let (colours, file, caption) = match field {
        None => (
            Field { name: "displacement", unit: "mm", values: &size, range: None },
            format!("deformed_{stem}.png"),
            format!("Case {}: deformed shape, {factor} times enlarged", name),
        ),
        Some(v) => {
            let mut densities = dissipation_densities(model, v, limit::SUBDIVISIONS);
            let words = match share_of_bodies(pass) {
                Some(share) if share < LITTLE => {
                    // the remaining plastic flow is rounding error and is not drawn
                    densities.fill(0.0);
                    "welds and slip on supports dissipate all, the parts do not flow"
                }
                _ => "coloured by its dissipation",
            };
            (values, range) = plastic_zones(model, &densities);
            (
                Field { name: "dissipation, relative", unit: "", values: &values, range },
                format!("mechanism_{stem}.png"),
                format!("Case {name}: mechanism of the upper bound, {words}"),
            )
        }
    };
    let deformed = Some(Deformed { displacement: vertices, factor, to_scale: field.is_none() });
    let options = PictureOptions {
        mirror,
        mesh_lines: false,
        field: Some(colours),
        deformed,
        ..PictureOptions::default()
    };
    folder.write(&file, &png(&draw(mesh, &options))?)?;
    Ok(Some(PictureRef { file, caption }))
}

/// Share of the dissipation below which the bodies count as rigid compared with their welds.
const LITTLE: f64 = 1e-3;

/// A round factor that draws the largest displacement as about a twentieth of the size of the
/// shape; `None` if nothing moves.
fn enlargement(nodes: &[V3], size: &[f64]) -> Option<f64> {
    let largest = size.iter().fold(0.0f64, |a, b| a.max(*b));
    if largest == 0.0 {
        return None;
    }
    let (lo, hi) = nodes.iter().fold(([f64::MAX; 3], [f64::MIN; 3]), |(lo, hi), x| {
        (std::array::from_fn(|d| lo[d].min(x[d])), std::array::from_fn(|d| hi[d].max(x[d])))
    });
    let wanted = 0.05 * vec3::norm(vec3::sub(hi, lo)) / largest;
    let power = 10f64.powf(wanted.log10().floor());
    Some([5.0, 2.0, 1.0].into_iter().map(|m| m * power).find(|f| *f <= wanted).unwrap_or(power))
}

/// Dissipation densities at the nodes, divided by their mean if the mechanism dissipates, and the
/// range of colours. The range ends at the largest value drawn, but at most at the mean, so that a
/// single corner with a huge density does not leave the rest dark.
fn plastic_zones(model: &AnalysisModel, densities: &[f64]) -> (Vec<f64>, Option<[f64; 2]>) {
    let mesh = &model.mesh;
    let mut nodes = vec![(0.0, 0.0); mesh.nodes.len()];
    let (mut square, mut total) = (0.0, 0.0);
    for (e, (tet, d)) in mesh.tets.iter().zip(densities).enumerate() {
        let v = mesh.volume(e);
        square += v * d * d;
        total += v * d;
        tet.iter().for_each(|&n| {
            let sum = &mut nodes[n as usize];
            *sum = (sum.0 + v * d, sum.1 + v);
        });
    }
    let mean = if total > 0.0 { square / total } else { 1.0 };
    let values: Vec<f64> =
        nodes.into_iter().map(|(d, v)| if v > 0.0 { d / v / mean } else { 0.0 }).collect();
    let largest = values.iter().fold(0.0f64, |m, x| m.max(*x));
    let top = if largest > 0.0 { largest.min(1.0) } else { 1.0 };
    (values, Some([0.0, top]))
}
