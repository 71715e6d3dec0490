//! Pictures of buckling modes.

use crate::document::picture::PictureRef;
use crate::draw::canvas::Picture;
use crate::draw::contact_map::AXES;
use crate::draw::enlarged::{MARKED, enlargement, is_small};
use crate::draw::raster::{Colours, Deformed, Field, PictureOptions, draw};
use crate::draw::sight::sight;
use crate::draw::surface::Surface;
use crate::draw::whole::Whole;
use crate::result::case_result::CaseResult;
use crate::words::Words;
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::route::{CriticalFactors, CriticalMode};
use bracket_codes::unit::number;
use bracket_engine::certify::fields::DisplacementField;
use bracket_engine::mesh::TetMesh;

/// Largest displacement of a drawn mode, over the size of the shape.
const EXAGGERATED: f64 = 0.06;
/// Share of the largest displacement from which a place should be seen.
const MOST: f64 = 0.9;

/// The buckling modes of a case, with displacements at the nodes of the 10-node tets of a mesh;
/// only those of the vertices are drawn. A half or a quarter is completed by its mirror images,
/// with the sense of an antisymmetric mode.
pub fn mode_pictures(
    mesh: &TetMesh,
    shapes: &[DisplacementField],
    case: &CaseResult,
    (stem, mirror, words): (&str, &[usize], &Words),
) -> Vec<(PictureRef, Picture)> {
    let Some(factors) = &case.critical else { return Vec::new() };
    let whole = Whole::of(mesh, mirror);
    let surface = Surface::of(&whole.mesh);
    let mut out = Vec::new();
    for (i, (shape, mode)) in shapes.iter().zip(&factors.fine).enumerate() {
        let u = whole.vectors(&shape.u[..mesh.nodes.len()], &mode.antisymmetric);
        let sizes: Vec<f64> = u.iter().map(|u| vec3::norm(*u)).collect();
        let Some(factor) = enlargement(&whole.mesh.nodes, &sizes, EXAGGERATED) else { continue };
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let values: Vec<f64> = sizes.iter().map(|s| s / largest).collect();
        let mut places: Vec<u32> = surface.triangles.iter().flat_map(|t| t.nodes).collect();
        places.sort_unstable();
        places.dedup();
        places.retain(|n| values[*n as usize] >= MOST);
        let title = title(i, mode, factors, mirror);
        let caption = words.say(&title);
        let options = PictureOptions {
            eye: Some(sight(&surface, &places).eye),
            mesh_lines: false,
            field: Some(Field {
                name: &words.say(&"displacement".into()),
                unit: &words.say(&"relative".into()),
                values: &values,
                range: Some([0.0, 1.0]),
                colours: Colours::Spectrum,
            }),
            deformed: Some(Deformed { displacement: &u, factor, caption: &caption }),
            ghost: true,
            ..PictureOptions::default()
        };
        let number = i + 1;
        let mut add = |file: String, caption: Text, options: &PictureOptions<'_>| {
            let picture = PictureRef { file, caption, ..PictureRef::default() };
            out.push((picture, draw(&whole.mesh, options)));
        };
        let caption = caption_of(&title, i, mode, case, mesh);
        add(format!("mode_{number}_{stem}.png"), caption, &options);
        if is_small(&whole.mesh.nodes, &values) {
            let caption = say!("Case {}: buckling mode {}, enlarged", &case.name, number);
            let close = PictureOptions { around: Some(MARKED), ..options.clone() };
            add(format!("zone_mode_{number}_{stem}.png"), caption, &close);
        }
    }
    out
}

/// The factor and the parity of a mode, for the line below its picture.
fn title(i: usize, mode: &CriticalMode, factors: &CriticalFactors, mirror: &[usize]) -> Text {
    let factor = Text::given(match i {
        0 => format!("α_cr = {}", number(factors.counted())),
        _ => format!("α = {}", number(mode.factor)),
    });
    let odd = mode.antisymmetric.iter().map(|axis| format!("{} = 0", AXES[*axis]));
    let parity = match odd.collect::<Vec<_>>().join(", ") {
        _ if mirror.is_empty() => Text::default(),
        none if none.is_empty() => "symmetric".into(),
        planes => say!("antisymmetric to {}", planes),
    };
    Text::joined(", ", [say!("buckling mode {}", i + 1), factor, parity])
}

fn caption_of(
    title: &Text,
    i: usize,
    mode: &CriticalMode,
    case: &CaseResult,
    mesh: &TetMesh,
) -> Text {
    let from = match (i, &case.critical) {
        (0, Some(CriticalFactors { coarse, fine })) => {
            let of =
                |modes: &[CriticalMode]| modes.first().map_or("–".into(), |m| number(m.factor));
            say!(
                " (0.95 of what follows from {} on the mesh and {} on one twice as fine)",
                of(coarse),
                of(fine)
            )
        }
        _ => " (on the mesh twice as fine, not extrapolated)".into(),
    };
    say!(
        "Case {}: {}{}. Most of its strain energy is in {}. Coloured by the displacement over its \
         largest one, not to scale; the grey lines are the edges at rest. Mesh of {} tetrahedra",
        &case.name,
        title,
        from,
        &mode.part,
        mesh.tets.len()
    )
}
