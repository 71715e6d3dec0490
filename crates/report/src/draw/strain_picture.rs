//! Pictures of the membrane strain of the plates, with the place of the largest value.

use crate::document::picture::PictureRef;
use crate::draw::canvas::Picture;
use crate::draw::raster::{Colours, Field, Mark, PictureOptions, completed, draw_surface};
use crate::draw::sight::sight;
use crate::draw::surface::Surface;
use crate::figures::{Rounding, significant};
use crate::result::case_result::CaseResult;
use crate::words::Words;
use bracket_base::math::vec3::{norm, sub};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::route::{LARGEST_STRAIN, PlateStrain};
use bracket_engine::mesh::TetMesh;

/// Strains that differ by less than this part are the same.
const SAME: f64 = 1e-9;

/// A strain in percent.
pub(crate) fn percent(strain: f64) -> String {
    significant(100.0 * strain, 3, Rounding::Nearest)
}

/// The membrane strain of a case at the vertices of a mesh, see
/// [`crate::result::evidence::EvidencePlan::strains`]: the whole joint, and the part with the
/// largest value alone, each from a side on which that value is seen. None without plates.
pub fn strain_pictures(
    mesh: &TetMesh,
    strains: &[f64],
    case: &CaseResult,
    (stem, mirror, words): (&str, &[usize], &Words),
) -> Vec<(PictureRef, Picture)> {
    let plates = case.evidence.iter().flat_map(|e| &e.plates);
    let Some(peak) = plates.max_by(|a, b| a.membrane.total_cmp(&b.membrane)) else {
        return Vec::new();
    };
    let values: Vec<f64> = strains.iter().map(|s| 100.0 * s).collect();
    let scene = Scene { mesh, values: &values, peak, words };
    let [x, y, z] = peak.membrane_at.map(|x| significant(x, 3, Rounding::Nearest));
    let place = say!("x = {}, y = {}, z = {} mm", x, y, z);
    let largest = [peak.membrane, LARGEST_STRAIN].map(percent);
    let [value, limit] = largest;
    let caption = say!(
        "Case {}: membrane strain of the plates, the largest principal strain as the mean over \
         prisms of the plate's thickness. The largest value is {} % in {} at {}; {} % are allowed \
         (EN 1993-1-5 C.8). No mean is taken where the parts are grey. Mesh of {} tetrahedra",
        &case.name,
        value,
        &peak.part,
        place,
        limit,
        mesh.tets.len()
    );
    let alone = say!("Case {}: membrane strain of {} alone", &case.name, &peak.part);
    let surface = completed(mesh, mirror);
    let body = mesh.bodies.iter().position(|b| *b == peak.part).and_then(|b| u32::try_from(b).ok());
    let part = body.map(|body| completed(&only(mesh, body), mirror));
    let pictures = [
        (format!("strain_{stem}.png"), caption, Some(surface)),
        (format!("part_strain_{stem}.png"), alone, part),
    ];
    let drawn = pictures.into_iter().filter_map(|(file, caption, surface)| {
        let picture = scene.draw(surface?);
        Some((PictureRef { file, caption, ..PictureRef::default() }, picture))
    });
    drawn.collect()
}

/// The tets of one body.
fn only(mesh: &TetMesh, body: u32) -> TetMesh {
    let own = mesh.tets.iter().zip(&mesh.tet_body).filter(|(_, b)| **b == body);
    let tets: Vec<[u32; 4]> = own.map(|(tet, _)| *tet).collect();
    TetMesh {
        nodes: mesh.nodes.clone(),
        tet_body: vec![body; tets.len()],
        tets,
        bodies: mesh.bodies.clone(),
        ..TetMesh::default()
    }
}

struct Scene<'a> {
    mesh: &'a TetMesh,
    /// Strains at the vertices \[%\].
    values: &'a [f64],
    peak: &'a PlateStrain,
    words: &'a Words,
}

impl Scene<'_> {
    fn draw(&self, surface: Surface) -> Picture {
        let Self { mesh, values, peak, words } = *self;
        let node = |n: u32| surface.origin[n as usize] as usize;
        let largest = values.iter().copied().filter(|v| !v.is_nan()).fold(0.0, f64::max);
        let apart = |n: u32| norm(sub(mesh.nodes[node(n)], peak.membrane_at));
        let mut places: Vec<u32> = surface.triangles.iter().flat_map(|t| t.nodes).collect();
        places.sort_unstable();
        places.dedup();
        // the middle of the prism is half a thickness below the surface
        places.retain(|n| {
            values[node(*n)] >= (1.0 - SAME) * largest && apart(*n) <= 2.0 * peak.thickness
        });
        let sight = sight(&surface, &places);
        let nearest = sight.seen.iter().min_by(|a, b| apart(**a).total_cmp(&apart(**b)));
        let limit = 100.0 * LARGEST_STRAIN;
        let said = |text: Text| words.say(&text);
        let unit = say!("{} %", percent(peak.membrane)).to_string();
        let note = said(say!("limit {} %", percent(LARGEST_STRAIN)));
        let field = Field {
            name: &said("membrane strain".into()),
            unit: "%",
            values,
            range: Some([0.0, largest.min(limit)]),
            colours: Colours::Spectrum,
        };
        let mark = nearest.map(|n| Mark { at: surface.points[*n as usize], text: &unit });
        let options = PictureOptions {
            eye: Some(sight.eye),
            field: Some(field),
            mesh_lines: false,
            mark,
            note: Some(&note),
            ..PictureOptions::default()
        };
        draw_surface(surface.clone(), &options)
    }
}
