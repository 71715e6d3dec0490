use super::*;

/// Numbers between −1 and 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        2.0 * ((self.0 >> 11) as f64 / (1u64 << 53) as f64) - 1.0
    }

    fn vector(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.next()).collect()
    }
}

fn sets() -> Vec<Within> {
    vec![
        Within::Cone { start: 0, dim: 3 },
        Within::Cone { start: 3, dim: 1 },
        Within::Ball { start: 4, radius: 0.5 },
    ]
}

/// Every force lands inside its cone or ball, forces inside stay as they are, and no nearer
/// force inside exists (compared with random ones).
#[test]
fn nearest_forces_inside() {
    let mut random = Random(1);
    let shear = |z: &[f64]| z[1].hypot(z[2]);
    for _ in 0..100 {
        let z = random.vector(7);
        let mut got = z.clone();
        sets().iter().for_each(|s| s.project(&mut got, 1e-3));
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
            let mut other = [random.next(), random.next(), random.next()];
            other[0] = other[0].abs() + other[1].hypot(other[2]) / 0.999;
            assert!(distance(&got) <= distance(&other) + 1e-12, "{z:?} {got:?} {other:?}");
        }
    }
}

/// The derivative of the projection agrees with central differences.
#[test]
fn slopes_of_the_projection() {
    let mut random = Random(5);
    for _ in 0..200 {
        let x = random.vector(7);
        for set in sets() {
            let (first, dim) = set.range();
            let slope = set.slope(&x[first..first + dim], 0.1);
            for j in 0..dim {
                let at = |h: f64| {
                    let mut x = x.clone();
                    x[first + j] += h;
                    set.project(&mut x, 0.1);
                    x
                };
                let (up, down) = (at(1e-6), at(-1e-6));
                for i in 0..dim {
                    let wanted = (up[first + i] - down[first + i]) / 2e-6;
                    // random points lie nowhere near a kink
                    assert!((slope[i][j] - wanted).abs() < 1e-6, "{set:?} {i} {j} {slope:?}");
                }
            }
        }
    }
}

fn resultants(rows: &[Vec<f64>], z: &[f64]) -> Vec<f64> {
    rows.iter().map(|r| r.iter().zip(z).map(|(a, b)| a * b).sum()).collect()
}

/// The result is inside the sets and has the resultants to rounding; its change is at an obtuse
/// angle to every other admissible force, the condition of the nearest point of a convex set. The
/// rows contain a double one, a zero one, and one of rounding.
#[test]
fn nearest_forces_with_given_resultants() {
    let mut random = Random(9);
    let mut sets = Vec::new();
    for c in 0..12 {
        sets.push(Within::Cone { start: 3 * c, dim: 3 });
    }
    (36..48).for_each(|start| sets.push(Within::Cone { start, dim: 1 }));
    (0..4).for_each(|b| sets.push(Within::Ball { start: 48 + 3 * b, radius: 0.7 }));
    let n = 60;
    let inside = |mut z: Vec<f64>| {
        sets.iter().for_each(|s| s.project(&mut z, 0.0));
        z
    };
    for _ in 0..40 {
        let mut rows: Vec<Vec<f64>> = (0..9).map(|_| random.vector(n)).collect();
        rows.push(rows[0].clone());
        rows.push(vec![0.0; n]);
        rows.push(random.vector(n).iter().map(|x| 1e-17 * x).collect());
        // forces inside the sets, so that the resultants are possible
        let known = inside(random.vector(n));
        let needed = resultants(&rows, &known);
        let near = |start: &[f64]| balanced_forces(&sets, &rows, &needed, start, 0.0);
        let start = random.vector(n);
        let z = near(&start).expect("possible");
        assert_eq!(
            z.iter().zip(inside(z.clone())).filter(|(a, b)| (**a - b).abs() > 1e-14).count(),
            0
        );
        for (a, b) in resultants(&rows, &z).iter().zip(&needed) {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
        let others = (0..5).map(|_| near(&random.vector(n)).expect("possible"));
        for other in others.collect::<Vec<_>>().iter().chain([&known]) {
            let work: f64 = (0..n).map(|i| (start[i] - z[i]) * (other[i] - z[i])).sum();
            assert!(work < 1e-9, "{work}");
        }
    }
}

/// A piece whose contacts cannot carry any force: its noise becomes zero, the forces of
/// the other piece stay.
#[test]
fn forces_that_must_be_zero() {
    let sets: Vec<Within> = (0..4)
        .map(|start| Within::Cone { start, dim: 1 })
        .chain([Within::Cone { start: 4, dim: 3 }])
        .collect();
    // the first two press on one side of a piece, the cone on the same side of another one
    let rows = [
        vec![1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        vec![0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0],
        vec![0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        vec![0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        vec![0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
    ];
    let start = [3e-7, 1e-9, 40.0, 60.0, 2e-6, 1e-6, -1e-6];
    let needed = [0.0, 100.0, 0.0, 0.0, 0.0];
    let z = balanced_forces(&sets, &rows, &needed, &start, 1e-9).expect("possible");
    assert!(z[..2].iter().chain(&z[4..]).all(|x| x.abs() < 1e-15), "{z:?}");
    assert!((z[2] - 40.0).abs() < 1e-12 && (z[3] - 60.0).abs() < 1e-12, "{z:?}");
}

/// A block that is pushed with exactly its friction: every force is on the surface of its cone, so
/// that the whole margin of 1e-9 would leave a resultant of this size open.
#[test]
fn forces_on_the_surface_of_their_cones() {
    let sets: Vec<Within> = (0..4).map(|c| Within::Cone { start: 3 * c, dim: 3 }).collect();
    let row = |k: usize| (0..12).map(|i| if i % 3 == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
    let rows = [row(0), row(1), row(2)];
    let mut random = Random(3);
    let start: Vec<f64> =
        (0..12).map(|i| [25.0, 24.9, 0.1][i % 3] + 0.05 * random.next()).collect();
    let z = balanced_forces(&sets, &rows, &[100.0, 100.0, 0.0], &start, 1e-9).expect("possible");
    for (got, needed) in resultants(&rows, &z).iter().zip([100.0, 100.0, 0.0]) {
        assert!((got - needed).abs() < 2e-10, "{got} {needed}");
    }
    assert!(z.chunks(3).all(|f| f[1].hypot(f[2]) <= f[0]), "{z:?}");
}

/// Contacts that would have to pull: the missing resultant is named.
#[test]
fn impossible_resultants() {
    let sets = [Within::Cone { start: 0, dim: 1 }, Within::Cone { start: 1, dim: 1 }];
    let rows = [vec![1.0, 0.0], vec![0.0, 1.0]];
    let open = balanced_forces(&sets, &rows, &[-1.0, 2.0], &[0.5, 0.5], 0.0).expect_err("pulled");
    assert!(open.direction[0].abs() > 0.9 && open.direction[1].abs() < 1e-9, "{open:?}");
    assert!(open.part > 0.1, "{open:?}");
}
