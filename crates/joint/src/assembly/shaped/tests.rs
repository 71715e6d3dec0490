//! Areas and positions of sections as they are meshed.

use super::*;
use crate::assembly::block::twice_area;
use crate::catalog::{Catalog, SectionKind};
use crate::geometry::flat::FlatSolid;

fn placed(profile: &ShapedProfile, along: usize, depth: usize) -> PlacedShape<'_> {
    let (span, origin) = ([0.0, 10.0], [0.0; 3]);
    PlacedShape { profile, along, depth, span, origin, flip: [false; 3] }
}

fn area(blocks: &[Block]) -> f64 {
    blocks.iter().map(|b| 0.5 * twice_area(&b.polygon)).sum()
}

/// Twice the first moment of the part above an axis of symmetry: the plastic modulus \[mm³\].
fn plastic_modulus(blocks: &[Block]) -> f64 {
    let half = [[-1e3, 1e3], [-1e3, 1e3], [0.0, 1e3]];
    let of = |p: &[[f64; 2]]| -> f64 {
        let n = p.len();
        let edge = |i: usize| {
            let (a, b) = (p[i], p[(i + 1) % n]);
            (a[0] * b[1] - b[0] * a[1]) * (a[1] + b[1]) / 6.0
        };
        (0..n).map(edge).sum()
    };
    2.0 * blocks.iter().filter_map(|b| b.within(&half)).map(|b| of(&b.polygon)).sum::<f64>()
}

/// Every row of the catalogue as it is meshed: area and plastic modulus within 1 % of the table,
/// the tables round small sizes to three figures.
#[test]
fn meshed_sections_have_the_area_and_the_modulus_of_the_catalogue() {
    let catalog = Catalog::builtin().expect("sound");
    let mut kinds = Vec::new();
    let mut worst = [0.0f64; 2];
    for p in catalog.shaped() {
        let blocks = placed(p, 0, 2).blocks();
        assert!(blocks.iter().all(|b| twice_area(&b.polygon) > 0.0), "{}", p.name);
        let ratio = area(&blocks) / (1e2 * p.area) - 1.0;
        worst[0] = worst[0].max(ratio.abs());
        assert!(ratio.abs() < 0.01, "{}: A {ratio}", p.name);
        if let Some(w) = p.w_pl_y {
            let ratio = plastic_modulus(&blocks) / (1e3 * w) - 1.0;
            worst[1] = worst[1].max(ratio.abs());
            assert!(ratio.abs() < 0.01, "{}: W_pl {ratio}", p.name);
        }
        kinds.push(p.kind());
    }
    println!("largest differences of A and W_pl: {worst:?}");
    for (kind, least) in [
        (SectionKind::Angle, 81),
        (SectionKind::Channel, 32),
        (SectionKind::Rhs, 370),
        (SectionKind::Chs, 55),
    ] {
        assert_eq!(kinds.iter().filter(|k| **k == kind).count(), least, "{kind:?}");
    }
}

/// A manufacturer's table has A = 40.3 cm² and W_pl = 206 cm³.
#[test]
fn a_tube_has_the_values_of_its_formulas() {
    let catalog = Catalog::builtin().expect("sound");
    let p = catalog.shaped().iter().find(|p| p.name == "CHS168.3x8").expect("catalogued");
    assert!((p.area - 40.3).abs() < 0.05 && p.w_pl_y.is_some_and(|w| (w - 206.0).abs() < 0.5));
    let exact = PI * 8.0 * 160.3;
    assert!((area(&placed(p, 1, 2).blocks()) / exact - 1.0).abs() < 1e-8);
}

/// The legs point to where the axes point, or the other way, whatever the axis of the member is.
#[test]
fn legs_point_where_the_entry_says() {
    let catalog = Catalog::builtin().expect("sound");
    let p = catalog.shaped().iter().find(|p| p.name == "L100x75x8").expect("catalogued");
    for (along, depth) in [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)] {
        let width = 3 - along - depth;
        for flip in [[false; 3], [true, false, false], [false, true, true], [true; 3]] {
            let l = PlacedShape { flip, ..placed(p, along, depth) };
            let b = FlatSolid::from_solid(&l.solid()).bounds();
            let ends = |k: usize, size: f64| if flip[k] { [-size, 0.0] } else { [0.0, size] };
            for (k, [low, high]) in
                [(along, [0.0, 10.0]), (depth, ends(depth, 100.0)), (width, ends(width, 75.0))]
            {
                assert!((b.min[k] - low).abs() < 1e-9 && (b.max[k] - high).abs() < 1e-9);
            }
            assert!((area(&l.blocks()) / (1e2 * p.area) - 1.0).abs() < 0.01);
            let walls = l.walls();
            let all = walls.flanges.iter().chain(&walls.webs);
            let sum: f64 = all.map(|e| (0..3).map(|k| e[k][1] - e[k][0]).product::<f64>()).sum();
            assert!((sum - 10.0 * 8.0 * (100.0 + 75.0 - 8.0)).abs() < 1e-6, "{sum}");
        }
    }
}
