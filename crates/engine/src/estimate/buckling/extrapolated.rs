//! A critical factor from those of two meshes.

/// Order of the error of a critical factor in the element size, assumed.
///
/// Quadratic elements reach 4 for smooth modes. Notches, clamped edges and rims of contact zones
/// lower it to between 1 and 2. A smaller order than the true one extrapolates to a lower factor.
const ORDER: i32 = 2;
/// Share of the extrapolated factor that counts.
const SHARE: f64 = 0.95;

/// The critical factor to use in design from those of a coarse and a fine mesh, the elements of the
/// coarse one `ratio_h` > 1 times as large.
///
/// The factor of conforming elements is an upper bound of the exact one and falls with refinement.
/// Richardson's extrapolation of the two with an error of order 2 is an estimate from below or
/// close by; 0.95 of it is returned. It never exceeds 0.95 times either factor, and it is not
/// negative. Where the factor does not fall, as when the contact state changes, nothing is
/// extrapolated.
pub fn conservative(coarse: f64, fine: f64, ratio_h: f64) -> f64 {
    if !(ratio_h > 1.0 && coarse > fine) {
        return SHARE * coarse.min(fine);
    }
    let error = (coarse - fine) / (ratio_h.powi(ORDER) - 1.0);
    SHARE * (fine - error).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_never_exceeds_a_share_of_the_smaller_factor() {
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        // exact for an error of order 2
        assert!(near(conservative(4.0 + 0.4, 4.0 + 0.1, 2.0), 0.95 * 4.0));
        assert!(near(conservative(4.0, 4.0, 2.0), 0.95 * 4.0));
        assert!(near(conservative(3.0, 4.0, 2.0), 0.95 * 3.0));
        // a useless ratio, a useless pair
        assert!(near(conservative(4.2, 4.0, 1.0), 0.95 * 4.0));
        assert_eq!(conservative(100.0, 4.0, 1.1), 0.0);
        for (coarse, fine, ratio) in [(5.0, 4.0, 1.5), (4.0, 5.0, 3.0), (9.0, 1.0, 2.0)] {
            let c = conservative(coarse, fine, ratio);
            assert!((0.0..=0.95 * coarse.min(fine)).contains(&c));
        }
    }
}
