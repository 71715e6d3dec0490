//! A published splice: UB 457 x 191 x 67 of S275 (f_u 410), M 200 kNm (133 at serviceability), V
//! 150 (100) kN, N 150 (100) kN compression, M20 8.8 preloaded, μ 0.5; a report of a program that
//! follows SCI P398. Its summary is at hand, its drawings are not. The distances follow from its
//! resistances: the flange cover 180 × 12 with 6 bolts, e2 30, p2 120, e1 + 2 p1 = 220 from its net
//! section and its block; 130 across the gap from its χ; web covers 340 × 10 from their shear; 3
//! rows at 120 from their block; two columns at 75 and 160 from the splice axis from the force of
//! the corner bolt and the bending of the covers together. It has γ_M2 = 1.1 for sections and 1.25
//! for bolts, so that each is checked with its own.

use super::fixture::{find, near, numbers, open, splice};
use crate::check::CheckId;
use crate::eurocode::block_tearing::Blocks;
use bracket_joint::assembly::CoverSplice;

/// The same splice with γ_M2 of sections.
fn sections() -> CoverSplice {
    let mut e = splice();
    e.factors.gamma_m2 = 1.1;
    e
}

/// Printed values in kN, within 1 %. The report has slightly other section properties (411.9 and
/// 325.4 kN; those of the catalogue give 411.1 and 325.0).
#[test]
fn flanges_have_the_printed_forces_and_resistances() {
    let (bolts, parts) = (splice(), sections());
    let lower = |e: &CoverSplice, id, subject: &str, want: [f64; 2]| {
        let got = numbers(e, "ULS", id, subject);
        near(got[0], want[0], 0.01);
        near(got[1], want[1], 0.01);
    };
    // My > 0 pulls the upper flange, and the compression N presses both
    lower(&bolts, CheckId::SpliceBoltShear, "lower flange, flange bolts", [68.7, 94.1]);
    lower(&bolts, CheckId::CoverCompression, "lower flange, outer cover", [411.9, 576.1]);
    lower(&parts, CheckId::FlangeCompression, "lower flange", [411.9, 663.2]);
    lower(&parts, CheckId::CoverTension, "upper flange, outer cover", [325.4, 547.5]);
    lower(&parts, CheckId::FlangeTension, "upper flange", [325.4, 621.6]);
    lower(&parts, CheckId::BlockTearing, "upper flange, outer cover", [325.4, 798.7]);
    // the recomputed forces, closer
    let [pushed, _] = numbers(&bolts, "ULS", CheckId::FlangeCompression, "lower flange");
    let [pulled, _] = numbers(&bolts, "ULS", CheckId::FlangeTension, "upper flange");
    near(pushed, 411.1, 2e-4);
    near(pulled, 325.0, 2e-4);
    // slip at serviceability
    let got = numbers(&bolts, "SLS", CheckId::SlipServiceability, "lower flange, flange bolts");
    near(got[0], 45.7, 0.01);
    near(got[1], 62.4, 0.01);
}

/// The report takes N as compression in the web too, and compares the resultant with the bearing of
/// the web, 139.4 kN; the code compares its components. Two values differ by more than 1 %, for the
/// reasons given.
#[test]
fn the_web_has_the_printed_forces_and_resistances() {
    let (bolts, parts) = (splice(), sections());
    let [force, shear] = numbers(&bolts, "ULS", CheckId::SpliceBoltShear, "web bolts");
    near(force, 122.6, 0.01);
    near(shear, 2.0 * 94.1, 0.01);
    let [along, bearing] = numbers(&bolts, "ULS", CheckId::BearingResistance, "web");
    assert!(along < force, "a component is less than the resultant");
    near(bearing, 139.4, 0.01);
    near(force / bearing, 0.879, 0.01);
    let slip = numbers(&bolts, "SLS", CheckId::SlipServiceability, "web bolts");
    near(slip[0], 81.6, 0.01);
    near(slip[1], 124.7, 0.01);
    let cover = numbers(&parts, "ULS", CheckId::WebCoverShear, "web covers");
    near(cover[0], 150.0, 1e-9);
    near(cover[1], 850.1, 0.01);
    let combined = find(&parts, "ULS", CheckId::WebCoverBending, "web covers");
    near(combined.utilisation.expect("a number"), 0.554, 0.01);
    // the block of the report, 1037.0 kN, is the outer column of bolts alone with the whole of f_u:
    // e2 50, A_nt = 2 · 10 · (50 − 11), A_nv = 2 · 10 · (290 − 2.5 · 22)
    let outer =
        Blocks { count: 2.0, tension: 39.0, shear: 235.0, thickness: 10.0, fy: 275.0, fu: 410.0 };
    near(1e-3 * outer.resistance(1.0, 1.1).value, 1037.0, 1e-3);
    // that of both columns has half of f_u (3.10.2(3)): A_nt = 2 · 10 · (50 + 85 − 33)
    let block = numbers(&parts, "ULS", CheckId::BlockTearingAcross, "web covers");
    near(block[1], (0.5 * 410.0 * 2040.0 / 1.1 + 4700.0 * 275.0 / 3f64.sqrt()) * 1e-3, 1e-9);
    // its 784.6 kN of the net web follows from no area that its data give: A_v of 6.2.6(3)a less
    // three holes is 3533 mm², which gives 760.2 kN, 3 % less
    let net = numbers(&parts, "ULS", CheckId::WebNetShear, "web");
    near(net[1], 760.2, 1e-3);
    near(net[1], 784.6, 0.035);
}

#[test]
fn the_published_splice_holds_and_its_checks_say_so() {
    // p1/t = 15 of the web covers is more than 9 ε: a note of Table 3.3 that the report leaves out
    assert_eq!(open(&splice()), Vec::<String>::new());
    let check = find(&splice(), "ULS", CheckId::WebCoverBuckling, "web covers");
    assert!(check.utilisation.is_some_and(|u| u > 0.55 && u < 0.65), "{}", check.sentence());
}
