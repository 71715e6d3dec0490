//! Pictures of the membrane strain of the plates, with the place of the largest value.

use crate::document::picture::PictureRef;
use crate::draw::canvas::Picture;
use crate::draw::raster::{Colours, Field, Mark, PictureOptions, completed, draw_surface};
use crate::draw::sight::sight;
use crate::draw::surface::Surface;
use crate::figures::{Rounding, percent, significant};
use crate::result::case_result::CaseResult;
use crate::words::Words;
use bracket_base::math::vec3::{norm, sub};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::route::{LARGEST_STRAIN, PlateStrain};
use bracket_codes::unit::number;
use bracket_engine::mesh::TetMesh;

/// Strains that differ by less than this part are the same.
const SAME: f64 = 1e-9;

/// The membrane strain of a case at the vertices of a mesh, see
/// [`crate::result::evidence::EvidencePlan::strains`]: the joint from a side on which the largest
/// value is seen and, where there is none, also the part with that value alone. None without
/// plates.
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
    let [value, limit] = [percent(peak.membrane), number(100.0 * LARGEST_STRAIN)];
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
    let picture = |file: String, caption| PictureRef { file, caption, ..PictureRef::default() };
    let (drawn, seen) = scene.draw(completed(mesh, mirror));
    let mut out = vec![(picture(format!("strain_{stem}.png"), caption), drawn)];
    let body = mesh.bodies.iter().position(|b| *b == peak.part).and_then(|b| u32::try_from(b).ok());
    if let Some(body) = body.filter(|_| !seen) {
        let (drawn, _) = scene.draw(completed(&only(mesh, body), mirror));
        out.push((picture(format!("part_strain_{stem}.png"), alone), drawn));
    }
    out
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
    /// The picture, and whether the largest value is seen and marked in it.
    fn draw(&self, surface: Surface) -> (Picture, bool) {
        let Self { mesh, values, peak, words } = *self;
        let node = |n: u32| surface.origin[n as usize] as usize;
        let largest = values.iter().copied().filter(|v| !v.is_nan()).fold(0.0, f64::max);
        let apart = |n: u32| norm(sub(mesh.nodes[node(n)], peak.membrane_at));
        let mut places: Vec<u32> = surface.triangles.iter().flat_map(|t| t.nodes).collect();
        places.sort_unstable();
        places.dedup();
        places.retain(|n| values[node(*n)] >= (1.0 - SAME) * largest);
        let sight = sight(&surface, &places);
        let nearest = sight.seen.iter().min_by(|a, b| apart(**a).total_cmp(&apart(**b)));
        let limit = 100.0 * LARGEST_STRAIN;
        let said = |text: Text| words.say(&text);
        let value = format!("{} %", percent(peak.membrane));
        let note = said(say!("limit {} %", number(limit)));
        let field = Field {
            name: &said("membrane strain".into()),
            unit: "%",
            values,
            range: Some([0.0, largest.min(limit)]),
            colours: Colours::Spectrum,
        };
        let mark = nearest.map(|n| Mark { at: surface.points[*n as usize], text: &value });
        let options = PictureOptions {
            eye: Some(sight.eye),
            field: Some(field),
            mesh_lines: false,
            mark,
            note: Some(&note),
            ..PictureOptions::default()
        };
        (draw_surface(surface.clone(), &options), mark.is_some())
    }
}
