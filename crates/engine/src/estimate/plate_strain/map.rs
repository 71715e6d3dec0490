//! The membrane strain of plates at the nodes of a mesh, for pictures.

use super::{PIECE, largest_in_plane, prisms, sums_of};
use crate::certify::PlasticField;
use crate::elements::space::Tet10Space;
use crate::estimate::plate::Plate;
use crate::model::AnalysisModel;
use bracket_base::math::vec3::V3;
use rayon::prelude::*;

/// Nodes closer to a face of a plate or prism than this part of the thickness lie on it.
const ON_FACE: f64 = 1e-6;

/// At each vertex of the mesh the largest membrane strain of the prisms that contain it, as a
/// fraction; NaN where there is none: off the plates, and where the prisms do not count. A prism
/// without a vertex on a face of the plate stands at the one nearest to its middle, so that the
/// largest value on the faces is that of [`super::plate_strains`].
pub fn membrane_at_nodes(
    model: &AnalysisModel,
    field: &PlasticField,
    plates: &[Plate],
) -> Vec<f64> {
    let space = Tet10Space::new(&model.mesh);
    let each = plates.par_iter().map(|plate| of_plate(model, field, &space, plate));
    let mut out = vec![f64::NAN; model.mesh.nodes.len()];
    for (node, value) in each.collect::<Vec<_>>().into_iter().flatten() {
        out[node] = out[node].max(value);
    }
    out
}

/// Nodes of a plate with their values.
fn of_plate(
    model: &AnalysisModel,
    field: &PlasticField,
    space: &Tet10Space,
    plate: &Plate,
) -> Vec<(usize, f64)> {
    let Some(sums) = sums_of(model, field, space, plate, PIECE) else { return Vec::new() };
    let near = ON_FACE * plate.thickness();
    let nodes = nodes_in(model, plate, near);
    // those inside, those of the lower and those of the upper face
    let [bottom, top] = plate.extent[2];
    let on = |c: &V3, face: f64| (c[2] - face).abs() <= near;
    let lower = |c: &V3| on(c, bottom) && !plate.mirrored[2];
    let (above, rest): (Vec<_>, Vec<_>) = nodes.into_iter().partition(|(_, c)| on(c, top));
    let (below, inside): (Vec<_>, Vec<_>) = rest.into_iter().partition(|(_, c)| lower(c));
    let mut out = Vec::new();
    for prism in prisms(&sums) {
        let Some(mean) = prism.mean() else { continue };
        let value = largest_in_plane(&mean);
        let spans = [0, 1].map(|i| prism.span(i));
        let holds = |(_, c): &&(usize, V3)| {
            spans.iter().zip(c).all(|([low, high], x)| low - near <= *x && *x <= high + near)
        };
        let middle = spans.map(|[low, high]| 0.5 * (low + high));
        let apart = |(_, c): &(usize, V3)| (c[0] - middle[0]).hypot(c[1] - middle[1]);
        out.extend(inside.iter().filter(holds).map(|(n, _)| (*n, value)));
        for face in [&below, &above] {
            let first = out.len();
            out.extend(face.iter().filter(holds).map(|(n, _)| (*n, value)));
            if out.len() == first {
                let nearest = face.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
                out.extend(nearest.map(|(n, _)| (*n, value)));
            }
        }
    }
    out
}

/// The vertices of a plate with their coordinates in it.
fn nodes_in(model: &AnalysisModel, plate: &Plate, near: f64) -> Vec<(usize, V3)> {
    let mesh = &model.mesh;
    let bodies = mesh.tets.iter().zip(&mesh.tet_body);
    let own = bodies.filter(|(_, body)| **body == plate.body).flat_map(|(tet, _)| *tet);
    let mut nodes: Vec<usize> = own.map(|n| n as usize).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let placed = nodes.into_iter().map(|n| (n, plate.coordinates(mesh.nodes[n])));
    let inside = |(_, c): &(usize, V3)| {
        c.iter().zip(&plate.extent).all(|(x, [a, b])| a - near <= *x && *x <= b + near)
    };
    placed.filter(inside).collect()
}
