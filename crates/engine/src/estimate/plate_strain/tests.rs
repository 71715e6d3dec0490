use super::*;
use crate::certify::plastic_field::length;
use crate::estimate::fixtures::{apart, block, field, steel, turn, turned};
use crate::estimate::plate::Zone;
use bracket_base::math::vec3::{add, cross, mul};
use std::f64::consts::FRAC_PI_2;

const FY: f64 = 235.0;
const TWO_MU: f64 = 210_000.0 / 1.3;
const T: f64 = 12.0;
const SIZE: V3 = [60.0, 42.0, T];
const IDENTITY: M3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// A plate of [`SIZE`], turned by `r`.
fn plate(r: M3) -> Plate {
    let axes = [0, 1, 2].map(|k| [r[0][k], r[1][k], r[2][k]]);
    let extent = SIZE.map(|s| [0.0, s]);
    Plate { body: 0, axes, extent, mirrored: [false; 3], excluded: Vec::new() }
}

fn mesh(count: [i32; 3], r: M3) -> AnalysisModel {
    steel(block(count, SIZE, |x| mul(&r, x)), FY)
}

fn value(peak: Option<Peak>) -> f64 {
    peak.expect("a prism").value
}

/// Strains of the plate with displacement `u` in its own axes.
fn strains(count: [i32; 3], r: M3, split: bool, u: impl Fn(V3) -> V3 + Sync) -> PlateStrain {
    let m = mesh(count, r);
    plate_strains(&m, &field(&m, split, turned(r, u)), &[plate(r)])[0]
}

/// A uniform strain has its principal values in every orientation of the plate.
#[test]
fn uniform_strain_has_its_principal_values() {
    let e: M3 = [[0.03, 0.011, 0.004], [0.011, -0.01, 0.007], [0.004, 0.007, 0.02]];
    let in_plane = 0.01 + 0.02f64.hypot(0.011);
    let in_space = largest(&e);
    for r in [IDENTITY, turn()] {
        for split in [false, true] {
            let s = strains([5, 3, 2], r, split, |x| mul(&e, x));
            assert!((value(s.membrane) - in_plane).abs() < 1e-13, "{s:?} {in_plane}");
            assert!((value(s.tensile) - in_space).abs() < 1e-13, "{s:?} {in_space}");
            let dev = length(&bracket_base::math::mandel::deviator(&symmetric_part(&e)));
            let plastic = (2.0f64 / 3.0).sqrt() * dev - 2.0 / 3.0 * FY / TWO_MU;
            assert!((value(s.surface) - plastic).abs() < 1e-13, "{s:?} {plastic}");
        }
    }
    assert!(in_space > in_plane);
}

/// Bent to κ the plate has no membrane strain, and in the outer quarter, which yields throughout,
/// the equivalent plastic strain (2/3) (κ 3t/8 − f_y/2G).
#[test]
fn pure_bending_has_plastic_strain_at_the_surfaces_only() {
    let kappa = 0.02 / (0.5 * T);
    let u = |x: V3| {
        let z = x[2] - 0.5 * T;
        [kappa * x[0] * z, 0.0, -0.5 * kappa * x[0] * x[0]]
    };
    let want = 2.0 / 3.0 * (kappa * 0.375 * T - FY / TWO_MU);
    for (r, split) in [(IDENTITY, false), (turn(), false), (IDENTITY, true)] {
        let s = strains([5, 3, 4], r, split, u);
        assert!(value(s.membrane).abs() < 1e-13, "{s:?}");
        assert!((value(s.surface) - want).abs() < 1e-12, "{s:?} {want}");
    }
}

/// The largest value at the nodes is the largest mean, on coarse meshes too, and nodes off the
/// plate have none.
#[test]
fn the_nodes_have_the_largest_mean() {
    for count in [[12, 8, 2], [2, 2, 1]] {
        let m = mesh(count, turn());
        let f = field(&m, false, turned(turn(), |x| [0.5e-3 * x[0] * x[0], 0.0, 0.0]));
        let half = Plate { extent: [[0.0, 30.0], [0.0, SIZE[1]], [0.0, T]], ..plate(turn()) };
        let at = membrane_at_nodes(&m, &f, std::slice::from_ref(&half));
        let largest = at.iter().copied().filter(|v| !v.is_nan()).fold(0.0, f64::max);
        assert_eq!(largest, value(plate_strains(&m, &f, &[half])[0].membrane));
        let off = |x: &V3| plate(turn()).coordinates(*x)[0] > 30.0 + 1e-6;
        let nodes = || m.mesh.nodes.iter().zip(&at);
        assert!(nodes().filter(|(x, _)| off(x)).all(|(_, v)| v.is_nan()), "{count:?}");
        let fine = count[0] == 12;
        assert!(!fine || nodes().filter(|(x, _)| !off(x)).all(|(_, v)| !v.is_nan()));
    }
}

/// Under a linear strain the mean of a prism is the value at its middle; the largest one is at the
/// end of the plate.
#[test]
fn linear_strain_has_its_value_at_the_middle_of_the_prism() {
    let g = 1e-3;
    for r in [IDENTITY, turn()] {
        let s = strains([7, 2, 1], r, false, |x| [0.5 * g * x[0] * x[0], 0.0, 0.0]);
        let peak = s.membrane.expect("a prism");
        assert!((peak.value - g * (SIZE[0] - 0.5 * T)).abs() < 1e-13, "{peak:?}");
        let along = plate(r).coordinates(peak.at);
        assert!((along[0] - 54.0).abs() < 1e-9 && (along[2] - 6.0).abs() < 1e-9, "{along:?}");
    }
}

#[test]
fn rigid_motion_has_no_strain() {
    let u = |x: V3| add([3.0, -2.0, 1.0], cross([0.02, -0.03, 0.05], x));
    for split in [false, true] {
        let s = strains([4, 3, 2], turn(), split, u);
        assert!(value(s.membrane).abs() < 1e-12 && value(s.tensile).abs() < 1e-12, "{s:?}");
        assert_eq!(value(s.surface), 0.0);
    }
}

/// A smooth displacement, which no mesh holds exactly, on meshes of t/2 and t/4.
#[test]
fn finer_mesh_changes_the_means_little() {
    let u = |x: V3| {
        let (a, b) = (FRAC_PI_2 * x[0] / 40.0, FRAC_PI_2 * x[1] / 30.0);
        let z = x[2] - 0.5 * T;
        [0.9 * a.sin() * b.cos(), 0.3 * a.cos() * b.sin(), 0.02 * z * (2.0 * a).sin()]
    };
    let coarse = strains([10, 7, 2], IDENTITY, false, u);
    let fine = strains([20, 14, 4], IDENTITY, false, u);
    for (name, a, b) in [
        ("membrane", coarse.membrane, fine.membrane),
        ("tensile", coarse.tensile, fine.tensile),
        ("surface", coarse.surface, fine.surface),
    ] {
        let change = value(a) / value(b) - 1.0;
        println!("{name}: {} {} {change:.1e}", value(a), value(b));
        assert!(change.abs() < 0.01, "{name} {change}");
    }
}

/// The strain falls off from a line; a disc around it is left out of a strip of the body, and
/// pieces half as large at its edge change the mean by less than a thousandth.
#[test]
fn discs_are_left_out() {
    let m = mesh([20, 7, 1], IDENTITY);
    let f = field(&m, false, |x| [0.3 * ((x[0] - 30.0) / 6.0).tanh(), 0.0, 0.0]);
    let space = Tet10Space::new(&m.mesh);
    let with = |radius: f64, piece: f64| {
        let excluded = vec![Zone::Disc { centre: [30.0, 6.0], radius }];
        let extent = [[0.0, SIZE[0]], [0.0, T], [0.0, T]];
        strain_of(&m, &f, &space, &Plate { excluded, extent, ..plate(IDENTITY) }, piece)
    };
    let whole = value(with(0.0, PIECE).membrane);
    let middle = 0.3 / 6.0 * 1f64.tanh();
    assert!((whole / middle - 1.0).abs() < 0.01, "{whole} {middle}");
    let [coarse, fine] = [PIECE, 0.5 * PIECE].map(|piece| value(with(16.0, piece).membrane));
    let change = coarse / fine - 1.0;
    println!("disc: {coarse} {fine} {change:.1e}");
    assert!(change.abs() < 1e-3 && fine < 0.25 * whole, "{change} {fine}");
    assert_eq!(with(100.0, PIECE), PlateStrain::default());
}

/// A rectangle over the steep half of the plate leaves the prisms of the rest; those that it covers
/// by more than half do not count.
#[test]
fn rectangles_are_left_out_exactly() {
    let g = 1e-3;
    let m = mesh([7, 2, 1], IDENTITY);
    let f = field(&m, false, |x| [0.5 * g * x[0] * x[0], 0.0, 0.0]);
    let excluded = vec![Zone::Rectangle { min: [33.0, -1.0], max: [99.0, 99.0] }];
    let s = plate_strains(&m, &f, &[Plate { excluded, ..plate(IDENTITY) }])[0];
    // the prism from 24 to 36 is filled to 33
    assert!((value(s.membrane) - g * 28.5).abs() < 1e-13, "{s:?}");
}

/// An eighth of a plate under a symmetric displacement gives what the whole plate gives.
#[test]
fn planes_of_symmetry_mirror_the_plate() {
    // odd across its own plane, even across the others
    let u = |[a, b, z]: V3| {
        let peak = 1.0 / (1.0 + a * a / 100.0 + b * b / 200.0);
        [0.01 * a * peak, 0.004 * b * peak, 0.02 * z * z * z / 36.0 * peak]
    };
    let strain = |count: [i32; 3], corner: V3, size: V3, mirrored: bool| {
        let m = steel(block(count, size, |x| add(x, corner)), FY);
        let extent = [0, 1, 2].map(|i| [corner[i], corner[i] + size[i]]);
        let plate = Plate { extent, mirrored: [mirrored; 3], ..plate(IDENTITY) };
        assert_eq!(plate.thickness(), T);
        plate_strains(&m, &field(&m, false, u), &[plate])[0]
    };
    let whole = strain([20, 16, 4], [-30.0, -24.0, -6.0], [60.0, 48.0, T], false);
    let part = strain([10, 8, 2], [0.0; 3], [30.0, 24.0, 6.0], true);
    let pairs = [
        (whole.membrane, part.membrane),
        (whole.tensile, part.tensile),
        (whole.surface, part.surface),
    ];
    for (a, b) in pairs.map(|(a, b)| (a.expect("a prism"), b.expect("a prism"))) {
        // the meshes are not mirror images of each other in every cube
        assert!((a.value / b.value - 1.0).abs() < 1e-3, "{a:?} {b:?}");
        assert!(apart(a.at.map(f64::abs), b.at) < 1e-9, "{a:?} {b:?}");
    }
}

#[test]
fn a_strain_that_is_not_a_number_shows() {
    let m = mesh([2, 2, 1], IDENTITY);
    let f = field(&m, false, |x| if x[0] > 50.0 { [f64::NAN; 3] } else { [0.0; 3] });
    let s = plate_strains(&m, &f, &[plate(IDENTITY)])[0];
    assert!(value(s.membrane).is_nan() && value(s.tensile).is_nan(), "{s:?}");
    let flat = Plate { extent: [[0.0, 1.0], [0.0, 1.0], [2.0, 2.0]], ..plate(IDENTITY) };
    assert_eq!(plate_strains(&m, &f, &[flat]), [PlateStrain::default()]);
}
