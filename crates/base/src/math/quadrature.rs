//! Quadrature rules on triangles and tetrahedra in barycentric coordinates. The weights sum to one.

/// Six-point rule on the triangle, exact to degree 4.
///
/// # Source
/// D. A. Dunavant, High degree efficient symmetrical Gaussian quadrature rules for the triangle,
/// IJNME 21 (1985).
pub const TRIANGLE_4: [([f64; 3], f64); 6] = {
    const A: f64 = 0.445_948_490_915_965;
    const B: f64 = 0.091_576_213_509_771;
    const WA: f64 = 0.223_381_589_678_011_33;
    const WB: f64 = 0.109_951_743_655_322;
    const A1: f64 = 1.0 - 2.0 * A;
    const B1: f64 = 1.0 - 2.0 * B;
    [
        ([A1, A, A], WA),
        ([A, A1, A], WA),
        ([A, A, A1], WA),
        ([B1, B, B], WB),
        ([B, B1, B], WB),
        ([B, B, B1], WB),
    ]
};

/// Four-point rule on the tetrahedron, exact to degree 2.
pub const TETRAHEDRON_2: [([f64; 4], f64); 4] = {
    const A: f64 = 0.138_196_601_125_010_5;
    const B: f64 = 1.0 - 3.0 * A;
    [([B, A, A, A], 0.25), ([A, B, A, A], 0.25), ([A, A, B, A], 0.25), ([A, A, A, B], 0.25)]
};

/// Quadratic shape functions of a 6-node triangle at the barycentric coordinates `l`: first the
/// three vertices, then the edges 01, 12, 02.
#[inline]
pub fn triangle_p2(l: [f64; 3]) -> [f64; 6] {
    [
        l[0] * (2.0 * l[0] - 1.0),
        l[1] * (2.0 * l[1] - 1.0),
        l[2] * (2.0 * l[2] - 1.0),
        4.0 * l[0] * l[1],
        4.0 * l[1] * l[2],
        4.0 * l[0] * l[2],
    ]
}

/// Entry of the mass matrix of linear functions on a triangle of unit area: `1/12 (1 + δ_ab)`.
#[inline]
pub fn triangle_mass(a: usize, b: usize) -> f64 {
    if a == b { 1.0 / 6.0 } else { 1.0 / 12.0 }
}

/// Entry of the mass matrix of the quadratic Bernstein polynomials on a triangle of unit area: λ_i²
/// of the vertices, then 2 λ_i λ_j of the edges 01, 12, 02.
#[inline]
pub fn bernstein_mass(a: usize, b: usize) -> f64 {
    // ∫ λ₀^i λ₁^j λ₂^k = 2 i! j! k! / (i + j + k + 2)!
    const ENDS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [1, 2], [0, 2]];
    const FACTORIAL: [f64; 5] = [1.0, 1.0, 2.0, 6.0, 24.0];
    let mut powers = [0; 3];
    ENDS[a].iter().chain(&ENDS[b]).for_each(|&i| powers[i] += 1);
    let factor = |i: usize| if i < 3 { 1.0 } else { 2.0 };
    factor(a) * factor(b) * powers.iter().map(|&p| FACTORIAL[p]).product::<f64>() / 360.0
}

/// Entry of the mass matrix of linear functions on a tetrahedron of unit volume: `1/20 (1 + δ_ab)`.
#[inline]
pub fn tetrahedron_mass(a: usize, b: usize) -> f64 {
    if a == b { 0.1 } else { 0.05 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `∫ λ₀^i λ₁^j λ₂^k = 2 i! j! k! / (i + j + k + 2)!` on a triangle of unit area.
    #[test]
    fn triangle_rule_is_exact_to_degree_4() {
        let f = |n: usize| (1..=n).product::<usize>() as f64;
        for i in 0..=4 {
            for j in 0..=4 - i {
                for k in 0..=4 - i - j {
                    let exact = 2.0 * f(i) * f(j) * f(k) / f(i + j + k + 2);
                    let rule: f64 = TRIANGLE_4
                        .iter()
                        .map(|(l, w)| {
                            w * l[0].powi(i as i32) * l[1].powi(j as i32) * l[2].powi(k as i32)
                        })
                        .sum();
                    assert!((rule - exact).abs() < 1e-14, "{i}{j}{k}: {rule} {exact}");
                }
            }
        }
    }
}
