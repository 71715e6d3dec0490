use super::*;

/// Every force lands inside its cone or ball, forces inside stay as they are, and no nearer
/// force inside exists (compared with random ones).
#[test]
fn nearest_forces_inside() {
    let sets = [
        Within::Cone { start: 0, dim: 3 },
        Within::Cone { start: 3, dim: 1 },
        Within::Ball { start: 4, radius: 0.5 },
    ];
    let mut seed = 1u64;
    let mut random = || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        2.0 * ((seed >> 11) as f64 / (1u64 << 53) as f64) - 1.0
    };
    let shear = |z: &[f64]| z[1].hypot(z[2]);
    for _ in 0..100 {
        let z: Vec<f64> = (0..7).map(|_| random()).collect();
        let got = inside(&sets, &z, 1e-3, 0.0);
        let length = |z: &[f64]| z[4].hypot(z[5]).hypot(z[6]);
        let (before, after) = (length(&z), length(&got));
        assert!((after - before.min(0.999 * 0.5)).abs() < 1e-15, "{before} {after}");
        (4..7).for_each(|i| assert!((got[i] * before - z[i] * after).abs() < 1e-15));
        assert!(
            got[0] >= 0.0 && shear(&got) <= 0.999 * got[0] && got[3] == z[3].max(0.0),
            "{z:?} {got:?}"
        );
        if shear(&z) <= 0.999 * z[0] {
            assert_eq!(got[..3], z[..3]);
        }
        let distance = |x: &[f64]| (0..3).map(|i| (x[i] - z[i]).powi(2)).sum::<f64>();
        for _ in 0..100 {
            let mut other = [random(), random(), random()];
            other[0] = other[0].abs() + other[1].hypot(other[2]) / 0.999;
            assert!(distance(&got) <= distance(&other) + 1e-12, "{z:?} {got:?} {other:?}");
        }
        assert_eq!(inside(&sets, &z, 1e-3, 2.0)[..4], [0.0; 4]);
    }
}
