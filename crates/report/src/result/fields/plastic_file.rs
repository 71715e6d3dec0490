//! Displacements with plastic strain as a `.vtu` file: written for ParaView, read back exactly for
//! `bracket verify`.
//!
//! A plain tet is one quadratic cell. A split tet is four quadratic cells with five additional
//! points inside, so that the drawn field is the field itself. The plastic strain jumps between
//! cells: each cell has the five deviatoric components at its four vertices.

use crate::result::fields::field_files::{DISPLACEMENT, FieldFileError, array, check_points};
use crate::result::fields::vtu::{QUADRATIC_TETRA, VtuGrid};
use bracket_base::math::vec3::{self, V3};
use bracket_engine::certify::fields::DisplacementField;
use bracket_engine::certify::plastic_field::{
    Deviator, PlasticField, PlasticTet, VertexFlow, length,
};
use bracket_engine::elements::geometry::centroid;
use bracket_engine::elements::space::Tet10Space;
use bracket_engine::elements::split_tet10::{NODES, OUTER, subtet_nodes};
use bracket_engine::model::AnalysisModel;

/// Name of the array of plastic strain: at each vertex the components in the basis
/// [`bracket_base::math::mandel::DEVIATORIC`].
const PLASTIC: &str = "plastic_strain_deviators";
/// Name of the array with the tet of the mesh that each cell belongs to.
const TET: &str = "tet";
/// Nodes inside a split tet.
const INNER: usize = NODES - OUTER;

/// Points and cells; `split` states which tets are split.
fn layout(model: &AnalysisModel, split: &[bool]) -> (Vec<V3>, Vec<u32>) {
    let space = Tet10Space::new(&model.mesh);
    let mut points = space.nodes.clone();
    let mut cells = Vec::new();
    for (e, split) in split.iter().enumerate() {
        let outer = space.tet(&model.mesh, e);
        if !split {
            cells.extend(outer.map(|n| n as u32));
            continue;
        }
        let (first, corners) = (points.len(), model.mesh.corners(e));
        let centre = centroid(&corners);
        points.push(centre);
        points.extend(corners.map(|x| vec3::scale(0.5, vec3::add(x, centre))));
        let node = |n: usize| if n < OUTER { outer[n] } else { first + n - OUTER };
        (0..4).for_each(|k| cells.extend(subtet_nodes(k).map(|n| node(n) as u32)));
    }
    (points, cells)
}

/// The field on quadratic tets, with the contribution to the gap of each, if known, and the
/// equivalent plastic strain `√(2/3) ‖p‖` where it is largest in each.
pub fn plastic_grid(
    model: &AnalysisModel,
    field: &PlasticField,
    contributions: Option<&[f64]>,
) -> VtuGrid {
    let split: Vec<bool> =
        field.tets.iter().map(|t| matches!(t, PlasticTet::Split { .. })).collect();
    let (points, cells) = layout(model, &split);
    let mut u: Vec<f64> = field.nodes.u.iter().flatten().copied().collect();
    let mut plastic: Vec<f64> = Vec::new();
    let (mut tets, mut bodies, mut shares) = (Vec::new(), Vec::new(), Vec::new());
    for (e, tet) in field.tets.iter().enumerate() {
        let of_tet: &[VertexFlow] = match tet {
            PlasticTet::Elastic => &[[[0.0; 5]; 4]],
            PlasticTet::Plain(p) => std::slice::from_ref(p),
            PlasticTet::Split { inner, plastic } => {
                u.extend(inner.iter().flatten());
                &plastic[..]
            }
        };
        plastic.extend(of_tet.iter().flatten().flatten());
        for _ in of_tet {
            tets.push(e as f64);
            bodies.push(f64::from(model.mesh.tet_body[e]));
            // the cells of a tet are equal parts of it
            shares.extend(contributions.map(|c| c[e] / of_tet.len() as f64));
        }
    }
    let largest =
        |cell: &[f64]| cell.chunks_exact(5).map(|d| length(&deviator(d))).fold(0.0, f64::max);
    let equivalent =
        plastic.chunks_exact(20).map(|cell| (2.0f64 / 3.0).sqrt() * largest(cell)).collect();
    let mut cell_data =
        vec![array("body", 1, bodies), array(TET, 1, tets), array(PLASTIC, 20, plastic)];
    cell_data.push(array("equivalent_plastic_strain", 1, equivalent));
    if contributions.is_some() {
        cell_data.push(array("gap_contribution_N_mm", 1, shares));
    }
    VtuGrid {
        points,
        cells,
        cell_type: QUADRATIC_TETRA,
        point_data: vec![array(DISPLACEMENT, 3, u)],
        cell_data,
        field_data: vec![],
    }
}

fn deviator(d: &[f64]) -> Deviator {
    std::array::from_fn(|a| d[a])
}

/// Reads a field and checks that it belongs to the model's mesh.
pub fn read_plastic(model: &AnalysisModel, bytes: &[u8]) -> Result<PlasticField, FieldFileError> {
    let grid = VtuGrid::from_bytes(bytes)?;
    let of_cells = |name: &'static str, components: usize| {
        let found = grid.cell_array(name).filter(|a| a.1 == components);
        found.map(|a| &a.2[..]).ok_or(FieldFileError::Missing(name))
    };
    let (tets, plastic) = (of_cells(TET, 1)?, of_cells(PLASTIC, 20)?);
    // one cell or four, in the order of the tets
    let mut counts = vec![0usize; model.mesh.tets.len()];
    for t in tets {
        *counts.get_mut(*t as usize).ok_or(FieldFileError::Missing(TET))? += 1;
    }
    let ordered =
        tets.windows(2).all(|t| t[0] <= t[1]) && counts.iter().all(|c| *c == 1 || *c == 4);
    if !ordered {
        return Err(FieldFileError::Missing(TET));
    }
    let split: Vec<bool> = counts.iter().map(|c| *c == 4).collect();
    let (points, cells) = layout(model, &split);
    check_points(&grid.points, &points)?;
    if grid.cells != cells {
        return Err(FieldFileError::Missing(TET));
    }
    let u = grid
        .point_array(DISPLACEMENT)
        .filter(|a| a.1 == 3)
        .ok_or(FieldFileError::Missing(DISPLACEMENT))?;
    let mut u: Vec<V3> = u.2.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    let mut inner = u.split_off(Tet10Space::new(&model.mesh).nodes.len()).into_iter();
    let mut flows = plastic
        .chunks_exact(20)
        .map(|c| -> VertexFlow { std::array::from_fn(|v| deviator(&c[5 * v..])) });
    let mut next = || flows.next().unwrap_or_default();
    let tets = split
        .into_iter()
        .map(|split| {
            if split {
                let inner: [V3; INNER] = std::array::from_fn(|_| inner.next().unwrap_or_default());
                let plastic = std::array::from_fn(|_| next());
                return PlasticTet::Split { inner: Box::new(inner), plastic: Box::new(plastic) };
            }
            let plastic = next();
            if plastic == [[0.0; 5]; 4] {
                PlasticTet::Elastic
            } else {
                PlasticTet::Plain(Box::new(plastic))
            }
        })
        .collect();
    Ok(PlasticField { nodes: DisplacementField { u }, tets })
}
