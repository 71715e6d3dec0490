//! Geometry of a tetrahedron with straight edges: centroid, gradients, Jacobian.

use bracket_base::math::vec3::{self, M3, V3};

/// Centroid of a tetrahedron.
pub fn centroid(x: &[V3; 4]) -> V3 {
    std::array::from_fn(|d| 0.25 * (x[0][d] + x[1][d] + x[2][d] + x[3][d]))
}

/// Gradients of the four linear shape functions of a tetrahedron.
pub fn gradients(x: &[V3; 4]) -> [V3; 4] {
    let (_, inv, _) = jacobian(x);
    // rows of the inverse are the gradients of the barycentric coordinates 1, 2, 3
    let g0 = std::array::from_fn(|d| -(inv[0][d] + inv[1][d] + inv[2][d]));
    [g0, inv[0], inv[1], inv[2]]
}

/// `J = [x₁−x₀, x₂−x₀, x₃−x₀]` (columns), its inverse and its determinant (6 × volume).
pub fn jacobian(x: &[V3; 4]) -> (M3, M3, f64) {
    let e: [V3; 3] = std::array::from_fn(|c| vec3::sub(x[c + 1], x[0]));
    let j: M3 = std::array::from_fn(|r| std::array::from_fn(|c| e[c][r]));
    let det = vec3::det(&j);
    (j, vec3::inverse(&j, det), det)
}
