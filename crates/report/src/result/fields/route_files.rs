//! The fields of the route of analysis as `.vtu` files: membrane strain of the plates and buckling
//! modes. Pictures can be made again from them.

use crate::result::fields::field_files::{
    FieldFileError, array, check_points, displacement_grid, vectors_of,
};
use crate::result::fields::vtu::{TETRA, VtuGrid};
use bracket_codes::route::CriticalMode;
use bracket_engine::certify::fields::DisplacementField;
use bracket_engine::model::AnalysisModel;

/// Name of the array of membrane strains, fractions.
const STRAIN: &str = "membrane_strain";
/// Names of the arrays of modes; as many are kept.
const MODES: [&str; 3] = ["mode_1", "mode_2", "mode_3"];
/// Name of the array of their critical factors on the finer mesh.
const FACTORS: &str = "critical_factor";

/// The membrane strain at the vertices of the mesh; NaN where no plate is.
pub fn strain_grid(model: &AnalysisModel, strains: &[f64]) -> VtuGrid {
    let mesh = &model.mesh;
    let bodies = mesh.tet_body.iter().map(|b| f64::from(*b)).collect();
    VtuGrid {
        points: mesh.nodes.clone(),
        cells: mesh.tets.iter().flatten().copied().collect(),
        cell_type: TETRA,
        point_data: vec![array(STRAIN, 1, strains.to_vec())],
        cell_data: vec![array("body", 1, bodies)],
        field_data: vec![],
    }
}

/// Reads the membrane strain and checks that it belongs to the model's mesh.
pub fn read_strains(model: &AnalysisModel, bytes: &[u8]) -> Result<Vec<f64>, FieldFileError> {
    let grid = VtuGrid::from_bytes(bytes)?;
    check_points(&grid.points, &model.mesh.nodes)?;
    match grid.point_array(STRAIN) {
        Some(a) if a.1 == 1 => Ok(a.2.clone()),
        _ => Err(FieldFileError::Missing(STRAIN)),
    }
}

/// The buckling modes on quadratic tets, with their critical factors; `None` without modes.
pub fn modes_grid(
    model: &AnalysisModel,
    shapes: &[DisplacementField],
    modes: &[CriticalMode],
) -> Option<VtuGrid> {
    let mut grid = displacement_grid(model, shapes.first()?, None);
    let of = |(name, shape): (&&str, &DisplacementField)| {
        array(name, 3, shape.u.iter().flatten().copied().collect())
    };
    grid.point_data = MODES.iter().zip(shapes).map(of).collect();
    grid.field_data = vec![array(FACTORS, 1, modes.iter().map(|m| m.factor).collect())];
    Some(grid)
}

/// Reads the buckling modes and checks that they belong to the model's mesh.
pub fn read_modes(
    model: &AnalysisModel,
    bytes: &[u8],
) -> Result<Vec<DisplacementField>, FieldFileError> {
    let grid = VtuGrid::from_bytes(bytes)?;
    let kept = MODES.into_iter().filter(|name| grid.point_array(name).is_some());
    kept.map(|name| vectors_of(model, &grid, name)).collect()
}
