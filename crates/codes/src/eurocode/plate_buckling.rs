//! Stability by reduced stress: EN 1993-1-5:2006 section 10.

use super::column_curve::{CURVE_C, PLATEAU, chi, phi};

/// Reduction factor ρ ≤ 1 of a structure whose loads yield it at `ultimate` times (α_ult,k) and
/// make it buckle elastically at `critical` times (α_cr), both positive.
///
/// `λ̄ = √(α_ult,k/α_cr)`; ρ is that of column curve c, the least of the curves for plates held on
/// three edges or more, for a free edge and for a member that moves. `ρ α_ult,k` grows with both
/// factors, so that lower bounds of them err to the safe side.
///
/// # Source
/// EN 1993-1-5:2006 10 (3), (4), formula 10.2; EN 1993-1-1:2005 6.3.1.2, formula 6.49.
pub fn reduction(ultimate: f64, critical: f64) -> f64 {
    // without a critical factor nothing is shown, and no number must come out of it
    if !(ultimate > 0.0 && critical > 0.0) {
        return 0.0;
    }
    let slenderness = (ultimate / critical).sqrt();
    if slenderness <= PLATEAU {
        return 1.0;
    }
    chi(phi(CURVE_C, slenderness), slenderness)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A published hand example of a gusset: curve c, λ̄ = 0.787, χ = 0.671 (SCI P358 A.5). No
    /// reduction of stocky structures, the Euler curve far out, and more of either factor never
    /// gives less.
    #[test]
    fn the_reduction_is_that_of_curve_c() {
        // both numbers are rounded
        assert!((reduction(0.787_f64.powi(2), 1.0) - 0.671).abs() < 1e-3);
        assert!((reduction(1.0, 25.0) - 1.0).abs() < 1e-12);
        for nothing in [0.0, -1.0, f64::NAN] {
            assert_eq!([reduction(1.0, nothing), reduction(nothing, 1.0)], [0.0; 2]);
        }
        let slender = reduction(400.0, 1.0);
        assert!(slender < 1.0 / 400.0 && slender > 0.95 / 400.0, "{slender}");
        let carried = |u: f64, c: f64| u * reduction(u, c);
        for i in 1..60 {
            for j in 1..60 {
                let (u, c) = (0.1 * f64::from(i), 0.3 * f64::from(j));
                assert!(
                    carried(u * 1.05, c) >= carried(u, c) && carried(u, c * 1.05) >= carried(u, c)
                );
            }
        }
    }
}
