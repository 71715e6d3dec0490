//! Vectors and 3 × 3 matrices as plain arrays.

/// A vector of three components.
pub type V3 = [f64; 3];
/// A 3 × 3 matrix, `m[row][column]`.
pub type M3 = [[f64; 3]; 3];

/// `a + b`.
#[inline]
pub fn add(a: V3, b: V3) -> V3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// `a − b`.
#[inline]
pub fn sub(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `k a`.
#[inline]
pub fn scale(k: f64, a: V3) -> V3 {
    [k * a[0], k * a[1], k * a[2]]
}

/// `a·b`.
#[inline]
pub fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a × b`.
#[inline]
pub fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Euclidean length.
#[inline]
pub fn norm(a: V3) -> f64 {
    dot(a, a).sqrt()
}

/// `a / |a|`; zero if `a` has length zero.
#[inline]
pub fn unit(a: V3) -> V3 {
    let length = norm(a).max(f64::MIN_POSITIVE);
    a.map(|c| c / length)
}

/// `a + s b`.
#[inline]
pub fn along(a: V3, s: f64, b: V3) -> V3 {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

/// `M a`.
#[inline]
pub fn mul(m: &M3, a: V3) -> V3 {
    [dot(m[0], a), dot(m[1], a), dot(m[2], a)]
}

/// `Mᵀ a`.
#[inline]
pub fn mul_t(m: &M3, a: V3) -> V3 {
    add(add(scale(a[0], m[0]), scale(a[1], m[1])), scale(a[2], m[2]))
}

/// Determinant.
#[inline]
pub fn det(m: &M3) -> f64 {
    dot(m[0], cross(m[1], m[2]))
}

/// Inverse of a matrix with the determinant `d ≠ 0`.
#[inline]
pub fn inverse(m: &M3, d: f64) -> M3 {
    let c = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])];
    let mut inv = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            inv[i][j] = c[j][i] / d;
        }
    }
    inv
}

/// Area vector of a triangle: half the cross product of its edges, directed by the right-hand rule.
#[inline]
pub fn area_vector(p: &[V3; 3]) -> V3 {
    scale(0.5, cross(sub(p[1], p[0]), sub(p[2], p[0])))
}

/// Two unit vectors that form a right-handed orthonormal frame with the unit vector `n`.
#[inline]
pub fn tangents(n: V3) -> (V3, V3) {
    // the axis least aligned with n gives a well-conditioned frame; if two axes are equal, the
    // lower index decides
    let k = (0..3).min_by(|&a, &b| n[a].abs().total_cmp(&n[b].abs())).unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[k] = 1.0;
    let t = cross(n, axis);
    let t1 = scale(1.0 / norm(t), t);
    (t1, cross(n, t1))
}
/// The coordinate axis along which a unit vector points, in either direction; `None` if another
/// component is more than rounding.
#[inline]
pub fn axis_of(n: V3) -> Option<usize> {
    const ROUNDING: f64 = 1e-9;
    (0..3).find(|&k| (0..3).all(|d| d == k || n[d].abs() <= ROUNDING))
}
