//! Reduction of a compressed member by the column curves: EN 1993-1-1:2005 6.3.1.

use crate::formula::Number;

/// Imperfection factor of curve c, EN 1993-1-1:2005 Table 6.1: solid sections, Table 6.2.
pub const CURVE_C: f64 = 0.49;
/// Slenderness up to which a column curve reduces nothing, 6.3.1.2(4).
pub const PLATEAU: f64 = 0.2;

/// λ_1 = π √(E/f_y); `e` and `fy` in MPa.
///
/// # Source
/// EN 1993-1-1:2005 6.3.1.3(1).
pub fn lambda_1<N: Number>(e: N, fy: N) -> N {
    N::from(std::f64::consts::PI) * (e / fy).sqrt()
}

/// Φ of a slenderness λ̄ with an imperfection factor α.
///
/// # Source
/// EN 1993-1-1:2005 6.3.1.2(1).
pub fn phi<N: Number>(alpha: N, slenderness: N) -> N {
    let n = N::from;
    let square = slenderness.clone() * slenderness.clone();
    n(0.5) * (n(1.0) + alpha * (slenderness - n(PLATEAU)) + square)
}

/// Reduction factor χ ≤ 1 beyond the plateau, `1/(Φ + √(Φ² − λ̄²))`.
///
/// # Source
/// EN 1993-1-1:2005 6.3.1.2(1), formula 6.49.
pub fn chi<N: Number>(phi: N, slenderness: N) -> N {
    let n = N::from;
    let square = slenderness.clone() * slenderness;
    (n(1.0) / (phi.clone() + (phi.clone() * phi - square).sqrt())).min(n(1.0))
}
