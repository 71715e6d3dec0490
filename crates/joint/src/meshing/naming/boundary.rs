//! Comparison of the surface of every body in the mesh with its solid, triangle by triangle.
//!
//! Volumes and areas alone cannot tell two solids apart, for example two I sections with the same
//! height, width and area.

use super::triangles::{corners, nodes_of};
use crate::geometry::line::Line;
use crate::geometry::scene::{Body, Scene};
use bracket_base::math::vec3::{V3, add, cross, norm, scale, sub};
use bracket_engine::mesh::TetMesh;
use bracket_engine::mesh::topology::FaceTable;

/// Largest distance of a triangle from the surface of its solid \[mm\]: far above the rounding of a
/// mesher and of a mended mesh, far below any dimension that changes a result.
const OFF: f64 = 0.01;

/// Weights of the corners at the points of a triangle that are tried. A line through one of them
/// may run along the seam of two prisms of a solid, which has no inside there.
const POINTS: [[f64; 3]; 4] =
    [[1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0], [0.61, 0.23, 0.16], [0.17, 0.59, 0.24], [0.25, 0.13, 0.62]];

/// A sentence for every body with a triangle that does not lie on the surface of its solid. The
/// bodies of the mesh are those of the scene, in its order.
pub fn boundary_differences(mesh: &TetMesh, scene: &Scene) -> Vec<String> {
    let table = FaceTable::new(&mesh.tets);
    let mut off: Vec<Option<V3>> = vec![None; scene.bodies.len()];
    for rows in table.faces() {
        let body = |i: usize| mesh.tet_body[rows[i].tet as usize];
        if rows.len() == 2 && body(0) == body(1) {
            continue;
        }
        for (i, row) in rows.iter().enumerate() {
            let at = body(i) as usize;
            let triangle = corners(mesh, nodes_of(mesh, row));
            if off[at].is_none() && !on_solid(&scene.bodies[at], &triangle) {
                off[at] = Some(weighted(&triangle, &POINTS[0]));
            }
        }
    }
    let sentence = |(body, at): (&Body, &Option<V3>)| {
        let [x, y, z] = (*at)?;
        Some(format!(
            "the {} ({}) of the mesh has a surface at x = {x:.1}, y = {y:.1}, z = {z:.1} mm, more \
             than {OFF} mm beside that of its dimensions",
            body.part.label, body.part.name
        ))
    };
    scene.bodies.iter().zip(&off).filter_map(sentence).collect()
}

/// True if the solid begins or ends at the triangle: on the line along its normal through one of
/// its points.
fn on_solid(body: &Body, triangle: &[V3; 3]) -> bool {
    let normal = cross(sub(triangle[1], triangle[0]), sub(triangle[2], triangle[0]));
    let length = norm(normal);
    if length == 0.0 {
        return true;
    }
    let direction = scale(1.0 / length, normal);
    POINTS.iter().any(|weights| {
        let line = Line { start: weighted(triangle, weights), direction };
        body.stretches(&line).iter().flatten().any(|t| t.abs() <= OFF)
    })
}

fn weighted(triangle: &[V3; 3], weights: &[f64; 3]) -> V3 {
    triangle.iter().zip(weights).fold([0.0; 3], |sum, (x, w)| add(sum, scale(*w, *x)))
}
