//! The two fields as `.vtu` files: written for ParaView, read back exactly for `bracket verify`.

use crate::result::fields::vtu::{
    Array, QUADRATIC_TETRA, QUADRATIC_TRIANGLE, TETRA, VtuError, VtuGrid,
};
use bracket_base::math::mandel::{self, Mandel};
use bracket_base::math::vec3;
use bracket_engine::analysis::limit;
use bracket_engine::certify::faces::{ContactFace, contact_faces};
use bracket_engine::certify::fields::{DisplacementField, StressField};
use bracket_engine::certify::velocity_field::VelocityField;
use bracket_engine::elements::space::{FACE_EDGES, Tet10Space};
use bracket_engine::elements::super_element::SuperElement;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::opening::ConeShift;

/// Name of the displacement array \[mm\].
pub(crate) const DISPLACEMENT: &str = "displacement";
/// Name of the array of velocities \[mm per unit of time\].
const VELOCITY: &str = "velocity";
/// Name of the load factor that a stress field balances.
const FACTOR: &str = "load_factor";
/// Motions of the resultant limits, limit by limit.
const LIMIT_MOTIONS: &str = "limit_motions";
/// Name of the stress array, Mandel form `[xx, yy, zz, √2 yz, √2 xz, √2 xy]` \[MPa\].
const STRESS: &str = "stress_mandel";

/// Name of the array of Bernstein coefficients of the shift of contact cones on each face: of the
/// vertices, then of the edges \[mm\].
const SHIFT: &str = "shift_bernstein";

/// Reason why a field file does not fit its model.
#[derive(Debug, thiserror::Error)]
pub enum FieldFileError {
    /// The file itself is faulty.
    #[error(transparent)]
    Vtu(#[from] VtuError),
    /// An array is missing.
    #[error("the field file has no array `{0}` of the right size")]
    Missing(&'static str),
    /// The points are not those of the mesh.
    #[error("point {point} of the field file is not where the mesh has it")]
    OtherMesh {
        /// Index of the first point that differs.
        point: usize,
    },
}

impl From<FieldFileError> for bracket_base::diag::Diagnostic {
    fn from(e: FieldFileError) -> Self {
        match e {
            FieldFileError::Vtu(e) => e.into(),
            other => bracket_base::diag::Diagnostic::input("verify/fields", other.to_string())
                .help(
                    "name a finished result folder whose files are unchanged, or run the analysis \
                 again",
                ),
        }
    }
}

pub(crate) fn array(name: &str, components: usize, values: Vec<f64>) -> Array {
    (name.into(), components, values)
}

fn bodies(model: &AnalysisModel, per_tet: usize) -> Array {
    let values = model.mesh.tet_body.iter().flat_map(|&b| vec![f64::from(b); per_tet]).collect();
    array("body", 1, values)
}

/// The displacement field on quadratic tets, with each element's contribution to the gap if known.
pub fn displacement_grid(
    model: &AnalysisModel,
    field: &DisplacementField,
    contributions: Option<&[f64]>,
) -> VtuGrid {
    let space = Tet10Space::new(&model.mesh);
    let cells = (0..model.mesh.tets.len())
        .flat_map(|e| space.tet(&model.mesh, e).map(|n| n as u32))
        .collect();
    let mut cell_data = vec![bodies(model, 1)];
    cell_data.extend(contributions.map(|c| array("gap_contribution_N_mm", 1, c.to_vec())));
    VtuGrid {
        points: space.nodes,
        cells,
        cell_type: QUADRATIC_TETRA,
        point_data: vec![array(DISPLACEMENT, 3, field.u.iter().flatten().copied().collect())],
        cell_data,
        field_data: vec![],
    }
}

/// The stress field on the four subtets of every tet. Each subtet has its own points, because
/// stress jumps between subtets.
pub fn stress_grid(model: &AnalysisModel, field: &StressField) -> VtuGrid {
    let points: Vec<[f64; 3]> = (0..model.mesh.tets.len())
        .flat_map(|e| SuperElement::points(&model.mesh.corners(e)).into_iter().flatten())
        .collect();
    let stress: Vec<Mandel> = field.points.iter().flatten().flatten().copied().collect();
    let von_mises = stress.iter().map(mandel::von_mises).collect();
    VtuGrid {
        cells: (0..points.len() as u32).collect(),
        points,
        cell_type: TETRA,
        point_data: vec![
            array(STRESS, 6, stress.into_iter().flatten().collect()),
            array("von_mises_MPa", 1, von_mises),
        ],
        cell_data: vec![bodies(model, 4)],
        field_data: vec![],
    }
}

/// The velocities of a mechanism on quadratic tets, with the dissipation per volume of each \[N
/// mm/mm³ per unit of time\].
pub fn velocity_grid(model: &AnalysisModel, field: &VelocityField, densities: Vec<f64>) -> VtuGrid {
    let mut grid = displacement_grid(model, &field.nodes, None);
    grid.point_data[0].0 = VELOCITY.into();
    grid.cell_data.push(array("dissipation_density", 1, densities));
    if !field.limit_motions.is_empty() {
        grid.field_data.push(array(LIMIT_MOTIONS, 1, field.limit_motions.clone()));
    }
    grid
}

/// A stress field with the largest utilisation `‖dev σ‖/(√(2/3) f_y)` of each subtet.
pub fn yielding_stress_grid(model: &AnalysisModel, field: &StressField) -> VtuGrid {
    let mut grid = stress_grid(model, field);
    let radii = model.yield_radii();
    let norm = |s: &Mandel| mandel::deviator(s).iter().map(|x| x * x).sum::<f64>().sqrt();
    let of_tets = field.points.iter().zip(&model.mesh.tet_body);
    let values = of_tets.flat_map(|(subtets, &body)| {
        let radius = radii[body as usize].unwrap_or(f64::INFINITY);
        subtets
            .iter()
            .map(move |s| s.iter().map(norm).fold(0.0, f64::max) / radius)
            .collect::<Vec<_>>()
    });
    grid.cell_data.push(array("utilisation", 1, values.collect()));
    grid
}

/// A stress field at a lower bound of the load factor, with the factor it balances.
pub fn lower_grid(model: &AnalysisModel, field: &StressField, factor: f64) -> VtuGrid {
    let mut grid = yielding_stress_grid(model, field);
    grid.field_data.push(array(FACTOR, 1, vec![factor]));
    grid
}

/// The shift of the contact cones on the contact faces, quadratic triangles in the order of the
/// faces; vertices in outward order of side A.
pub fn shift_grid(model: &AnalysisModel, shift: &ConeShift) -> VtuGrid {
    let mut values = Vec::new();
    for c in &shift.faces {
        values.extend(&c[..3]);
        values.extend(
            FACE_EDGES
                .iter()
                .zip(&c[3..])
                .map(|([p, q], edge)| 0.25 * (c[*p] + c[*q]) + 0.5 * edge),
        );
    }
    let points = shift_points(model);
    VtuGrid {
        cells: (0..points.len() as u32).collect(),
        points,
        cell_type: QUADRATIC_TRIANGLE,
        point_data: vec![array("shift", 1, values)],
        cell_data: vec![array(SHIFT, 6, shift.faces.iter().flatten().copied().collect())],
        field_data: vec![],
    }
}

/// Vertices and mid-sides of every contact face \[mm\].
fn shift_points(model: &AnalysisModel) -> Vec<[f64; 3]> {
    let of_face = |f: ContactFace<'_>| {
        let x = f.corners(model);
        let middles = FACE_EDGES.map(|[p, q]| vec3::scale(0.5, vec3::add(x[p], x[q])));
        x.into_iter().chain(middles)
    };
    contact_faces(model).into_iter().flat_map(of_face).collect()
}

/// Reads a shift of contact cones and checks that it belongs to the model's contact faces.
pub fn read_shift(model: &AnalysisModel, bytes: &[u8]) -> Result<ConeShift, FieldFileError> {
    let grid = VtuGrid::from_bytes(bytes)?;
    let wanted = shift_points(model);
    check_points(&grid.points, &wanted)?;
    let a = grid.cell_array(SHIFT).ok_or(FieldFileError::Missing(SHIFT))?;
    if a.1 != 6 || a.2.len() != wanted.len() {
        return Err(FieldFileError::Missing(SHIFT));
    }
    Ok(ConeShift { faces: a.2.chunks_exact(6).map(|c| std::array::from_fn(|i| c[i])).collect() })
}

pub(crate) fn check_points(found: &[[f64; 3]], wanted: &[[f64; 3]]) -> Result<(), FieldFileError> {
    let point = if found.len() != wanted.len() {
        Some(found.len().min(wanted.len()))
    } else {
        found.iter().zip(wanted).position(|(a, b)| a != b)
    };
    point.map_or(Ok(()), |point| Err(FieldFileError::OtherMesh { point }))
}

/// Reads velocities of limit analysis and checks that they belong to the model's mesh.
pub fn read_velocity(model: &AnalysisModel, bytes: &[u8]) -> Result<VelocityField, FieldFileError> {
    let grid = VtuGrid::from_bytes(bytes)?;
    let motions = grid.field_array(LIMIT_MOTIONS).map(|a| a.2.clone()).unwrap_or_default();
    let field = limit::velocity(vectors_of(model, &grid, VELOCITY)?);
    Ok(VelocityField { limit_motions: motions, ..field })
}

/// Reads a displacement field and checks that it belongs to the model's mesh.
pub fn read_displacement(
    model: &AnalysisModel,
    bytes: &[u8],
) -> Result<DisplacementField, FieldFileError> {
    vectors_of(model, &VtuGrid::from_bytes(bytes)?, DISPLACEMENT)
}

pub(crate) fn vectors_of(
    model: &AnalysisModel,
    grid: &VtuGrid,
    name: &'static str,
) -> Result<DisplacementField, FieldFileError> {
    check_points(&grid.points, &Tet10Space::new(&model.mesh).nodes)?;
    let a = grid.point_array(name).ok_or(FieldFileError::Missing(name))?;
    if a.1 != 3 || a.2.len() != 3 * grid.points.len() {
        return Err(FieldFileError::Missing(name));
    }
    Ok(DisplacementField { u: a.2.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect() })
}

/// Reads a stress field with the load factor it balances and checks that it belongs to the model's
/// mesh.
pub fn read_lower(
    model: &AnalysisModel,
    bytes: &[u8],
) -> Result<(StressField, f64), FieldFileError> {
    let grid = VtuGrid::from_bytes(bytes)?;
    let factor = grid
        .field_array(FACTOR)
        .and_then(|a| a.2.first())
        .ok_or(FieldFileError::Missing(FACTOR))?;
    Ok((stress_of(model, &grid)?, *factor))
}

/// Reads a stress field and checks that it belongs to the model's mesh.
pub fn read_stress(model: &AnalysisModel, bytes: &[u8]) -> Result<StressField, FieldFileError> {
    stress_of(model, &VtuGrid::from_bytes(bytes)?)
}

fn stress_of(model: &AnalysisModel, grid: &VtuGrid) -> Result<StressField, FieldFileError> {
    let wanted: Vec<[f64; 3]> = (0..model.mesh.tets.len())
        .flat_map(|e| SuperElement::points(&model.mesh.corners(e)).into_iter().flatten())
        .collect();
    check_points(&grid.points, &wanted)?;
    let a = grid.point_array(STRESS).ok_or(FieldFileError::Missing(STRESS))?;
    if a.1 != 6 || a.2.len() != 96 * model.mesh.tets.len() {
        return Err(FieldFileError::Missing(STRESS));
    }
    let points =
        a.2.chunks_exact(96)
            .map(|c| {
                std::array::from_fn(|k| {
                    std::array::from_fn(|p| std::array::from_fn(|i| c[24 * k + 6 * p + i]))
                })
            })
            .collect();
    Ok(StressField { points })
}
