use super::*;

fn balance_of<'a>(
    sets: &'a [Within],
    rows: &'a [Vec<f64>],
    needed: &'a [f64],
) -> InterfaceBalance<'a> {
    InterfaceBalance { sets, rows, needed, margins: &[0.0], terms: &[2.0; 8], pressure: 1.0 }
}

/// Every force lands inside its cone or ball, forces inside stay as they are, and no nearer
/// force inside exists (compared with random ones).
#[test]
fn nearest_forces_inside() {
    let sets = [
        Within::Cone { start: 0, dim: 3, most: f64::INFINITY },
        Within::Cone { start: 3, dim: 1, most: f64::INFINITY },
        Within::Ball { start: 4, radius: 0.5 },
    ];
    let balance = balance_of(&sets, &[], &[]);
    let inside = |z: &[f64], margin, least| balance.inside(z, &[false; 3], margin, least);
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
        let got = inside(&z, 1e-3, 0.0);
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
        assert_eq!(inside(&z, 1e-3, 2.0)[..4], [0.0; 4]);
    }
}

/// Half-lines, one for each force.
fn springs(n: usize) -> Vec<Within> {
    (0..n).map(|start| Within::Cone { start, dim: 1, most: f64::INFINITY }).collect()
}

fn work(row: &[f64], z: &[f64]) -> f64 {
    row.iter().zip(z).map(|(a, z)| a * z).sum()
}

/// Two plates one upon the other. The upper one carries 2 N, and a third plate that nothing loads
/// lies beside them on a noise of 1e-3 N, which no cut-off of the largest force removes: its forces
/// are zero because the plate can be lifted.
#[test]
fn contacts_that_can_be_opened_carry_nothing() {
    let sets = springs(6);
    let rows = vec![
        // lift of the two plates, of the upper one, of the third, and its tilt
        vec![1.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        vec![0.0, 0.0, 1.0, 1.0, 0.0, 0.0],
        vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0],
        vec![0.0, 0.0, 0.0, 0.0, 1.0, -1.0],
    ];
    let needed = [2.0, 2.0, 0.0, 0.0];
    let noisy = [1.01, 0.98, 1.0, 1.0, 4e-2, 1e-2];
    let balance = balance_of(&sets, &rows, &needed);
    let motions = Motions::new(&sets, &rows, &needed, 6, 1.0);
    assert_eq!(motions.unloaded(), [false, false, false, false, true, true]);
    let Ok((z, None)) = balance.find(&noisy, None) else { panic!("a balance exists") };
    assert_eq!(z[4..], [0.0, 0.0]);
    rows.iter().zip(needed).for_each(|(row, n)| assert!((work(row, &z) - n).abs() < 1e-14));
}

/// A plate between two walls can be pressed by both at once: neither contact is without force for
/// certain, and the forces that the solver found stay.
#[test]
fn contacts_that_exclude_each_others_opening_may_press() {
    let sets = springs(2);
    let rows = vec![vec![1.0, -1.0]];
    let needed = [0.0];
    assert_eq!(Motions::new(&sets, &rows, &needed, 2, 1.0).unloaded(), [false, false]);
    let found = balance_of(&sets, &rows, &needed).find(&[3.0, 3.1], None);
    let Ok((z, None)) = found else { panic!("a balance exists") };
    assert!(z[0] > 3.0 && z[0] < 3.1 && (z[0] - z[1]).abs() < 1e-14, "{z:?}");
}

/// A pull away from the contact: there is no balance, and the motion is named.
#[test]
fn loads_that_open_a_contact_have_no_balance() {
    let sets = springs(3);
    let rows = vec![vec![1.0, 1.0, 0.0], vec![0.0, 0.0, 1.0]];
    let needed = [-1.0, 1.0];
    let found = balance_of(&sets, &rows, &needed).find(&[1e-6, 1e-6, 1.0], None);
    let Err(NoBalance { driven: Some(c), .. }) = found else { panic!("no balance exists") };
    assert!(c[0] > 0.0 && c[1].abs() < 1e-6 * c[0], "{c:?}");
}

/// Friction: a block that nothing loads, on a corner of three cones.
#[test]
fn unloaded_friction_cones() {
    let sets: Vec<Within> =
        (0..3).map(|i| Within::Cone { start: 3 * i, dim: 3, most: f64::INFINITY }).collect();
    let mu = 0.3;
    let at = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    // lift, two shifts, two tilts, turn
    let row =
        |f: &dyn Fn([f64; 2]) -> [f64; 3]| -> Vec<f64> { at.iter().flat_map(|x| f(*x)).collect() };
    let rows = vec![
        row(&|_| [1.0, 0.0, 0.0]),
        row(&|_| [0.0, mu, 0.0]),
        row(&|_| [0.0, 0.0, mu]),
        row(&|x| [x[0], 0.0, 0.0]),
        row(&|x| [x[1], 0.0, 0.0]),
        row(&|x| [0.0, -mu * x[1], mu * x[0]]),
    ];
    let needed = [0.0; 6];
    let motions = Motions::new(&sets, &rows, &needed, 9, 1.0);
    assert_eq!(motions.unloaded(), [true; 3]);
    assert_eq!(motions.driven(), None);
}
