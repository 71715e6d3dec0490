//! Pictures of a case: mesh, deformed shape, contact pressures, convergence.

use crate::driver::passes::Kept;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::math::vec3::{self, V3};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::certify::fields::StressField;
use bracket_engine::model::AnalysisModel;
use bracket_report::document::picture::PictureRef;
use bracket_report::draw::Picture;
use bracket_report::draw::contact_map::{contact_map, ground_map};
use bracket_report::draw::enlarged::enlargement;
use bracket_report::draw::plot::{Plot, Series};
use bracket_report::draw::raster::{
    Colours, Deformed, Field, PictureOptions, completed, draw, draw_surface,
};
use bracket_report::draw::svg::Svg;
use bracket_report::figures::{self, Rounding};
use bracket_report::result::file_names::file_stem;
use bracket_report::result::folder::ResultFolder;
use bracket_report::result::forces::StaticForces;
use bracket_report::result::result_file::CaseResult;
use bracket_report::result::result_file::HistoryRow;
use bracket_report::words::Words;

pub(crate) fn png(picture: &Picture) -> Result<Vec<u8>, Diagnostics> {
    picture.to_png().map_err(|e| {
        Diagnostic::environment("report/picture", format!("the picture cannot be encoded: {e}"))
            .into()
    })
}

/// Views of the mesh: file, direction to the eye (`None`: from slightly above), and words. The
/// first view has the lines of the mesh.
const VIEWS: [(&str, Option<V3>, &str); 3] = [
    ("mesh.png", None, ""),
    ("mesh_front.png", Some([0.0, -1.0, 0.0]), ", seen along y"),
    ("mesh_side.png", Some([1.0, 0.0, 0.0]), ", seen along x"),
];

/// The mesh from slightly above, from the front and from the side.
pub fn mesh_pictures(
    model: &AnalysisModel,
    mirror: &[usize],
    folder: &ResultFolder,
) -> Result<Vec<PictureRef>, Diagnostics> {
    let copies = if mirror.is_empty() { "" } else { ", completed by symmetry" };
    let surface = completed(&model.mesh, mirror);
    let one = |(file, eye, seen): (&str, Option<V3>, &'static str)| {
        let mesh_lines = eye.is_none();
        let options = PictureOptions { eye, mesh_lines, ..PictureOptions::default() };
        folder.write(file, &png(&draw_surface(surface.clone(), &options))?)?;
        let caption = say!("Mesh of {} tetrahedra{}{}", model.mesh.tets.len(), copies, seen);
        Ok(PictureRef { file: file.into(), caption, ..PictureRef::default() })
    };
    VIEWS.into_iter().map(one).collect()
}

/// The contact pressures of a stress field that carries `factor` times the load, one picture for
/// each pair of parts and one of ground that crushes.
pub fn contact_pictures(
    model: &AnalysisModel,
    (stress, factor): (&StressField, f64),
    forces: Option<&StaticForces>,
    mirror: &[usize],
    (name, stem): (&str, &str),
    folder: &ResultFolder,
) -> Result<Vec<PictureRef>, Diagnostics> {
    let mut out = Vec::new();
    let shown = figures::significant(factor, 4, Rounding::Down);
    let mut add = |map: Svg, file: String, caption: Text| -> Result<(), Diagnostics> {
        let (picture, text) = map.picture(file, caption);
        folder.write(&picture.file, text.as_bytes())?;
        out.push(picture);
        Ok(())
    };
    for pair in forces.iter().flat_map(|f| &f.contacts) {
        let Some(map) = contact_map(model, stress, pair, mirror) else { continue };
        let file = format!("contact_{stem}_{}.svg", file_stem(&pair.between.join("_")));
        let [a, b] = &pair.between;
        let caption = say!(
            "Case {}: contact pressure of {} on {} at load factor {}, means of the faces",
            name.to_owned(),
            a,
            b,
            shown.clone()
        );
        add(map, file, caption)?;
    }
    if let Some(map) = ground_map(model, stress, mirror) {
        let caption = say!(
            "Case {}: pressure on the ground at load factor {}, means of the faces",
            name.to_owned(),
            shown
        );
        add(map, format!("ground_{stem}.svg"), caption)?;
    }
    Ok(out)
}

/// The gap against the size of the mesh, if there was more than one mesh.
pub fn convergence(
    entry: &CaseResult,
    target: Option<f64>,
    (stem, words): (&str, &Words),
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
        title: say!("{}: gap between the bounds, mesh after mesh", &entry.name),
        x: "macro tets".into(),
        y: "gap [%]".into(),
        series: vec![Series { name: "adaptive".into(), points }],
        level: target.map(|t| (100.0 * t, "target".into())),
    };
    let file = format!("convergence_{stem}.png");
    folder.write(&file, &png(&plot.picture(words))?)?;
    Ok(Some(PictureRef {
        file,
        caption: say!("Case {}: gap against the size of the mesh", &entry.name),
        ..PictureRef::default()
    }))
}

/// The deformed shape coloured by the size of the displacement.
pub fn deformed_picture(
    Kept { outcome, model, .. }: &Kept,
    (name, stem): (&str, &str),
    (mirror, words): (&[usize], &Words),
    folder: &ResultFolder,
) -> Result<Option<PictureRef>, Diagnostics> {
    let AnalysisPass::Energy(pass) = outcome else { return Ok(None) };
    let Some(u) = &pass.displacement else { return Ok(None) };
    let mesh = &model.mesh;
    let vertices = &u.u[..mesh.nodes.len()];
    let size: Vec<f64> = vertices.iter().map(|x| vec3::norm(*x)).collect();
    let Some(factor) = enlargement(&mesh.nodes, &size, VISIBLE) else { return Ok(None) };
    let field = Field {
        name: &words.say(&"displacement".into()),
        unit: "mm",
        values: &size,
        range: None,
        colours: Colours::Spectrum,
    };
    let options = PictureOptions {
        mirror,
        mesh_lines: false,
        field: Some(field),
        deformed: Some(Deformed {
            displacement: vertices,
            factor,
            caption: &words.say(&say!("displacements × {}", factor.to_string())),
        }),
        ..PictureOptions::default()
    };
    let file = format!("deformed_{stem}.png");
    folder.write(&file, &png(&draw(mesh, &options))?)?;
    let caption =
        say!("Case {}: deformed shape, {} times enlarged", name.to_owned(), factor.to_string());
    Ok(Some(PictureRef { file, caption, ..PictureRef::default() }))
}

/// Largest displacement of a drawn elastic shape, over the size of the shape.
const VISIBLE: f64 = 0.05;
