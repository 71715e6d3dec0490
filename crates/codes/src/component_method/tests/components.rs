//! Each formula of the component method by itself, named after its clause or table.

use super::near;
use crate::component_method::column_web::{self, CompressedWeb, ShearPanel};
use crate::component_method::compressed_zone::{CompressedZone, StiffenerPair, compressed_width};
use crate::component_method::reference_cases::{beam, column, one_sided};
use crate::component_method::stiffness::{self, Joins};
use crate::component_method::t_stub::{Mode, Prying, Resistance, TStub, prying};
use crate::component_method::{assess, beam as beam_method, effective_lengths as lengths};
use crate::eurocode::i_section::Section;
use crate::eurocode::section::Class;
use crate::eurocode::yielding::plastic_shear;
use bracket_joint::assembly::Way;
use std::f64::consts::PI;

const STUB: TStub = TStub {
    m: 40.0,
    n: 50.0,
    thickness: 20.0,
    fy: 235.0,
    length1: 200.0,
    length2: 220.0,
    bolts: 400e3,
    gamma_m0: 1.0,
    prying: Prying::Develops,
    washer_quarter: None,
};

/// Resistance of a mode \[N\]; infinite where the mode does not exist.
fn mode(r: &Resistance, name: &str) -> f64 {
    r.worked.step(name).unwrap_or(f64::INFINITY)
}

#[test]
fn table_6_2_modes_of_the_t_stub() {
    let (mpl1, mpl2) = (0.25 * 200.0 * 400.0 * 235.0, 0.25 * 220.0 * 400.0 * 235.0);
    let r = STUB.resistance();
    near(mode(&r, "mode 1"), 4.0 * mpl1 / 40.0);
    near(mode(&r, "mode 2"), (2.0 * mpl2 + 50.0 * 400e3) / 90.0);
    near(mode(&r, "mode 3"), 400e3);
    assert_eq!((r.mode, r.worked.value), (Mode::FlangeAndBolts, mode(&r, "mode 2")));
    // thin flange: mode 1; thick one: mode 3
    assert_eq!(TStub { thickness: 8.0, ..STUB }.resistance().mode, Mode::Flange);
    assert_eq!(TStub { thickness: 60.0, ..STUB }.resistance().mode, Mode::Bolts);
    // without prying 2 M_pl,1/m takes the place of both
    let lifted = TStub { prying: Prying::Absent, ..STUB }.resistance();
    near(mode(&lifted, "mode 1-2"), 2.0 * mpl1 / 40.0);
    assert_eq!((lifted.mode, mode(&lifted, "mode 2")), (Mode::FlangeWithoutPrying, f64::INFINITY));
    // 6.2.6.11(2): the plate of a base gains nothing by prying, its anchors carry it
    let base = TStub { prying: Prying::BoltsOnly, ..STUB }.resistance();
    near(base.worked.value, 2.0 * mpl1 / 40.0);
    near(base.bolts, 2.0 * mpl1 / 40.0 * (1.0 + 40.0 / 100.0));
    let thick = TStub { thickness: 40.0, prying: Prying::BoltsOnly, ..STUB }.resistance();
    near(thick.worked.value, mode(&thick, "mode 2").min(400e3));
}

/// With e_w = 0 the alternative method is the first one; with a washer it gives more, never more
/// than mode 2 allows.
#[test]
fn table_6_2_alternative_method_of_mode_1() {
    let thin = TStub { thickness: 10.0, ..STUB };
    let first = mode(&thin.resistance(), "mode 1");
    let without = TStub { washer_quarter: Some(0.0), ..thin }.resistance();
    near(mode(&without, "mode 1"), first);
    let mpl = 0.25 * 200.0 * 100.0 * 235.0;
    let other = TStub { washer_quarter: Some(9.25), ..thin }.resistance();
    near(
        mode(&other, "mode 1"),
        (8.0 * 50.0 - 2.0 * 9.25) * mpl / (2.0 * 40.0 * 50.0 - 9.25 * 90.0),
    );
    assert!(mode(&other, "mode 1") > first);
}

#[test]
fn table_6_2_limit_of_prying() {
    // L_b* = 8.8 · 40³ · 157/(200 · 20³) = 55.264 mm
    let of = |length| prying(length, 40.0, 157.0, 1, 200.0, 20.0);
    assert_eq!((of(55.26), of(55.27)), (Prying::Develops, Prying::Absent));
    assert_eq!(prying(110.5, 40.0, 157.0, 2, 200.0, 20.0), Prying::Develops, "two rows");
}

/// Bolt forces with prying: mode 1 by equilibrium of the flange about its hinges, mode 2 at F_t,Rd,
/// without prying none.
#[test]
fn table_6_2_bolt_forces_with_prying() {
    let stub = |length: f64, prying| TStub {
        m: 40.0,
        n: 50.0,
        thickness: 10.0,
        fy: 235.0,
        length1: length,
        length2: length,
        bolts: 282e3,
        gamma_m0: 1.0,
        prying,
        washer_quarter: None,
    };
    let plastic = 0.25 * 200.0 * 100.0 * 235.0;
    let one = stub(200.0, Prying::Develops).resistance();
    assert_eq!(one.mode, Mode::Flange);
    // on either side the bolt takes half of the tension and the prying force M_pl/n
    near(one.bolts, 4.0 * plastic / 40.0 + 2.0 * plastic / 50.0);
    let two = stub(800.0, Prying::Develops).resistance();
    assert_eq!((two.mode, two.bolts), (Mode::FlangeAndBolts, 282e3));
    let free = stub(200.0, Prying::Absent).resistance();
    near(free.bolts, free.worked.value);
}

#[test]
fn tables_6_4_to_6_6_effective_lengths() {
    let (m, e, e1, p, a) = (30.0, 60.0, 40.0, 80.0, 6.0);
    let check = |l: lengths::Lengths, cp: f64, nc: f64| {
        near(l.circular, cp);
        near(l.straight, nc);
        near(l.mode1(), cp.min(nc));
        near(l.mode2(), nc);
    };
    check(lengths::inner(m, e), 2.0 * PI * m, 4.0 * m + 1.25 * e);
    check(lengths::end(m, e, e1), PI * m + 2.0 * e1, 2.0 * m + 0.625 * e + e1);
    check(lengths::end(m, e, 1e6), 2.0 * PI * m, 4.0 * m + 1.25 * e);
    check(lengths::beside_stiffener(m, a), 2.0 * PI * m, a * m);
    check(
        lengths::end_beside_stiffener(m, e, e1, a),
        PI * m + 2.0 * e1,
        e1 + a * m - 2.0 * m - 0.625 * e,
    );
    check(lengths::end_beside_stiffener(m, e, 1e6, a), 2.0 * PI * m, a * m);
    check(lengths::inner_of_group(p, p), 2.0 * p, p);
    check(lengths::inner_of_group(60.0, 100.0), 160.0, 80.0);
    check(lengths::end_of_group(m, e, p, None), PI * m + p, 2.0 * m + 0.625 * e + 0.5 * p);
    check(lengths::end_of_group(m, e, p, Some(e1)), 2.0 * e1 + p, e1 + 0.5 * p);
    check(
        lengths::beside_stiffener_of_group(m, e, p, a),
        PI * m + p,
        0.5 * p + a * m - 2.0 * m - 0.625 * e,
    );
    // each of the terms of the row outside the flange can decide
    check(lengths::outside_flange(m, 20.0, 200.0, 200.0, 900.0), 2.0 * PI * m, 4.0 * m + 25.0);
    check(lengths::outside_flange(m, 90.0, 20.0, 900.0, 900.0), PI * m + 40.0, 20.0 + 60.0 + 56.25);
    check(lengths::outside_flange(m, 90.0, 200.0, 60.0, 900.0), PI * m + 60.0, 30.0 + 60.0 + 56.25);
    check(lengths::outside_flange(m, 90.0, 200.0, 200.0, 150.0), 2.0 * PI * m, 75.0);
}

/// α: by a search over the figure's curves, at the borders, and far from the stiffener, where it is
/// none.
#[test]
fn figure_6_11_alpha() {
    // a second way: the α among fine steps whose curve passes nearest to the point
    let searched = |m: f64, e: f64, m2: f64| {
        let (x, y) = (m / (m + e), m2 / (m + e));
        let distance = |a: f64| {
            let first = 1.25 / (a - 2.75);
            let second = a * first / 2.0;
            let bend = ((second - y) / second).max(0.0).powf(0.185 * a.powf(1.785));
            (first + (1.0 - first) * if y < second { bend } else { 0.0 } - x).abs()
        };
        let steps = (0..=400_000).map(|i| 4.0 + f64::from(i) * 1e-5);
        steps.min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap_or_default()
    };
    for (m, e, m2) in
        [(27.67, 32.0, 18.61), (33.4, 75.0, 40.0), (40.0, 40.0, 10.0), (30.0, 50.0, 5.0)]
    {
        let got = lengths::alpha(m, e, m2);
        assert!((got - searched(m, e, m2)).abs() < 2e-5, "{got} is not {}", searched(m, e, m2));
    }
    // beyond the last curve of the figure, 4.45 at m/(m + e) = 1.25/1.7, a narrow edge has no more
    // than without a stiffener: α m = 4 m + 1.25 e
    near(lengths::alpha(90.0, 10.0, 900.0), 4.0 + 1.25 * 10.0 / 90.0);
    near(lengths::alpha(50.0, 12.0, 200.0), 4.0 + 1.25 * 12.0 / 50.0);
    near(lengths::alpha(1.25, 0.45, 9.0), 4.45);
    assert_eq!(lengths::alpha(10.0, 90.0, 10.0), 8.0, "a row close to the web");
    for (m, e) in [(30.0, 50.0), (40.0, 60.0), (25.0, 60.0)] {
        near(lengths::alpha(m, e, 1e3) * m, 4.0 * m + 1.25 * e);
    }
    // nearer to the stiffener the row carries more
    let near_by: Vec<f64> =
        [60.0, 40.0, 20.0, 10.0].map(|m2| lengths::alpha(35.0, 45.0, m2)).to_vec();
    assert!(near_by.windows(2).all(|w| w[0] <= w[1]), "{near_by:?}");
}

#[test]
fn table_6_3_interaction_with_shear() {
    let (b, t, a) = (200.0, 10.0, 2500.0);
    let ratio: f64 = 0.64;
    let (one, two) = (1.0 / (1.0 + 1.3 * ratio).sqrt(), 1.0 / (1.0 + 5.2 * ratio).sqrt());
    for (beta, omega) in
        [(0.0, 1.0), (0.5, 1.0), (0.75, one + 0.5 * (1.0 - one)), (1.0, one), (2.0, two)]
    {
        near(column_web::shear_interaction(beta, b, t, a), omega);
    }
    near(column_web::shear_interaction(1.5, b, t, a), 0.5 * (one + two));
    near(column_web::shear_interaction(0.5 + 1e-12, b, t, a), 1.0);
}

#[test]
fn clause_6_2_6_1_web_panel_in_shear() {
    // HEB 140: A_vc = 4296 − 2 · 140 · 12 + (7 + 24) 12 = 1308 mm²
    let mut heb = column("HEB140", 275.0);
    (heb.section.area, heb.section.r) = (4296.0, 12.0);
    let area = column_web::shear_area(&heb);
    near(area, 1308.0);
    (heb.doublers, heb.doubler_width) = (1, 92.0);
    near(column_web::shear_area(&heb), 1308.0 + 644.0);
    let panel = |slender: f64| ShearPanel {
        area,
        fy: 275.0,
        clear_depth: slender * 7.0,
        web_depth: slender * 7.0 + 24.0,
        web: 7.0,
        stiffeners: 0.0,
        gamma_m0: 1.0,
        gamma_m1: 1.1,
    };
    near(panel(60.0).resistance().value, 0.9 * 275.0 * 1308.0 / 3f64.sqrt());
    // 69 ε = 63.8
    assert!(!panel(63.0).slender() && panel(64.0).slender());
    // h_w = 120 · 7 + 24 = 864 mm, λ̄_w = 864/(86.4 · 7 · 0.92442) = 1.54538, χ_w = 0.83/λ̄_w =
    // 0.53708: the web of a panel with a large A_vc buckles at 0.9 · 0.53708 · 864 · 7 · 275/(√3 ·
    // 1.1)
    let slender = ShearPanel { area: 9000.0, ..panel(120.0) }.resistance();
    assert!((slender.value / 421_970.0 - 1.0).abs() < 1e-4, "{}", slender.value);
    assert!(slender.clause.contains("1993-1-5") && panel(120.0).resistance().value < slender.value);
    near(column_web::stiffened_panel(10.0, 20.0, 2.0), 20.0);
    near(column_web::stiffened_panel(10.0, 4.0, 2.0), 14.0);
    let stiffened = ShearPanel { stiffeners: 1e4, ..panel(13.0) }.resistance().value;
    near(stiffened - panel(13.0).resistance().value, 1e4);
}

const WEB: CompressedWeb = CompressedWeb {
    effective_width: 250.0,
    web: 10.0,
    clear_depth: 200.0,
    fy: 235.0,
    young: 210_000.0,
    omega: 1.0,
    longitudinal: 0.0,
    gamma_m0: 1.0,
    gamma_m1: 1.1,
};

#[test]
fn clause_6_2_6_2_column_web_in_compression() {
    // t_fb = 10, a_p = 5, t_fc + s = 27, t_p = 20
    let mut joint = one_sided();
    let c = joint.column.as_mut().expect("a column");
    (c.section.tf, c.section.root) = (15.0, 12.0);
    let column = *c;
    (joint.beam.section.tf, joint.beam.flange_throat, joint.plate.thickness) = (10.0, 5.0, 20.0);
    let mut width = |overhang: f64| {
        joint.plate.bottom = -0.5 * joint.beam.section.h - overhang;
        compressed_width(&joint, &column, Way::Down)
    };
    near(width(100.0), 10.0 + 200f64.sqrt() + 135.0 + 40.0);
    // a plate that ends with the weld spreads on one side alone
    near(width(0.0), 10.0 + 200f64.sqrt() + 135.0 + 20.0);
    let lambda = 0.932 * (250.0 * 200.0 * 235.0 / (210_000.0 * 100.0f64)).sqrt();
    near(WEB.slenderness(), lambda);
    assert!(lambda < 0.72);
    near(WEB.buckling(), 1.0);
    near(WEB.resistance().value, 250.0 * 10.0 * 235.0 / 1.1);
    let slender = CompressedWeb { web: 6.0, ..WEB };
    let l = slender.slenderness();
    near(slender.buckling(), (l - 0.2) / (l * l));
    near(slender.resistance().value, slender.buckling() * 250.0 * 6.0 * 235.0 / 1.1);
    assert!(slender.resistance().formula().to_string().contains('ρ'));
    // a longitudinal stress above 0.7 f_y
    let pressed = CompressedWeb { longitudinal: 0.9 * 235.0, ..WEB };
    near(pressed.longitudinal_factor(), 0.8);
    near(pressed.resistance().value, 0.8 * WEB.resistance().value);
    near(CompressedWeb { longitudinal: 0.7 * 235.0, ..WEB }.longitudinal_factor(), 1.0);
    near(CompressedWeb { omega: 0.7, ..WEB }.resistance().value, 0.7 * WEB.resistance().value);
    for (plates, factor) in [(0, 1.0), (1, 1.5), (2, 2.0), (3, 2.0)] {
        near(column_web::compressed_thickness(10.0, plates), 10.0 * factor);
    }
}

#[test]
fn en_1993_1_5_9_4_stiffened_web_in_compression() {
    // 95 × 15 mm on both sides: the cross is stocky, λ̄ ≤ 0.2, and carries its plastic force
    let area = 2.0 * 95.0 * 15.0 + (300.0 + 15.0) * 10.0;
    let pair = |outstand, thickness| StiffenerPair { outstand, thickness, beside: [900.0; 2] };
    near(WEB.stiffened(&pair(95.0, 15.0)).value, area * 235.0);
    // a token of a stiffener is worth no more than the web without it
    let token = CompressedZone { web: WEB, stiffeners: Some(pair(1.0, 0.1)) };
    near(
        token.resistance().value,
        WEB.resistance().value.max(WEB.stiffened(&pair(1.0, 0.1)).value),
    );
    // 15 ε t_w = 150 mm counts only where there is web: 6 mm up to the end of the column, 100 mm to
    // half of the way to the other pair
    for (beside, web) in [([6.0, 900.0], 156.0), ([6.0, 100.0], 106.0), ([0.0, 900.0], 150.0)] {
        let area = 2.0 * 95.0 * 15.0 + (web + 15.0) * 10.0;
        let pair = StiffenerPair { beside, ..pair(95.0, 15.0) };
        near(WEB.stiffened(&pair).value, area * 235.0);
    }
    // a tall slender one buckles
    let tall = CompressedWeb { clear_depth: 1500.0, effective_width: 60.0, web: 8.0, ..WEB };
    let stiff = tall.stiffened(&pair(60.0, 6.0));
    let chi = stiff.steps.iter().find(|s| s.symbol == "χ").map_or(f64::NAN, |s| s.value);
    assert!(chi > 0.5 && chi < 1.0, "{chi}");
}

#[test]
fn clause_6_2_6_3_column_web_in_tension() {
    near(column_web::tension(180.0, 9.0, 235.0, 0.8, 1.0).value, 0.8 * 180.0 * 9.0 * 235.0);
    for (plates, fy, factor) in [(0, 235.0, 1.0), (1, 355.0, 1.4), (2, 355.0, 1.4), (1, 460.0, 1.3)]
    {
        near(column_web::tension_thickness(9.0, plates, fy), 9.0 * factor);
    }
}

#[test]
fn clauses_6_2_6_7_and_6_2_6_8_the_beam() {
    let ipe = beam("IPE270", 275.0, 6.0, 4.0).section;
    let moment = beam_method::bending_6_2_8(&ipe, 275.0, 0.0, 1.0).value;
    near(moment, ipe.w_pl * 275.0);
    near(beam_method::flange_compression(&ipe, moment, 275.0, 1.0).value, moment / (270.0 - 10.2));
    // deeper than 600 mm: the web gives 20 % at most
    let deep = beam("UB686x254x125", 235.0, 6.0, 4.0).section;
    let strong = beam_method::bending_6_2_8(&deep, 235.0, 0.0, 1.0).value;
    near(
        beam_method::flange_compression(&deep, strong, 235.0, 1.0).value,
        deep.b * deep.tf * 235.0 / 0.8,
    );
    near(beam_method::web_tension(150.0, 6.6, 275.0, 1.1).value, 150.0 * 6.6 * 250.0);
    // a thin flange makes class 3, a thinner one class 4
    let thin = Section { tf: 4.0, ..ipe };
    near(beam_method::bending_6_2_8(&thin, 275.0, 0.0, 1.0).value, ipe.w_el * 275.0);
    let thinner = Section { tf: 3.0, ..ipe };
    // c/t = (0.5 · (135 − 6.6) − 15)/3 = 16.4 > 14 ε = 12.94: of class 3 up to σ = 275 ·
    // (12.94/16.4)²
    assert_eq!(beam_method::class(&thinner, 275.0), Class::Slender);
    let stress = 275.0 * (14.0f64 * (235.0f64 / 275.0).sqrt() / 16.4).powi(2);
    near(beam_method::bending_6_2_8(&thinner, 275.0, 0.0, 1.0).value, ipe.w_el * stress);
}

/// V_pl,Rd of IPE 270: A_v = 4595 − 2 · 135 · 10.2 + (6.6 + 30) 10.2 = 2214.3 mm², · 275/√3 =
/// 351.57 kN. With V = 0.75 V_pl ρ = 0.25 and M_V = (484 000 − 0.25 · (249.6 · 6.6)²/(4 · 6.6)) ·
/// 275 = 126.03 kNm; up to half of V_pl the moment is whole.
#[test]
fn en_1993_1_1_6_2_8_shear_takes_from_the_moment_of_the_beam() {
    let ipe = beam("IPE270", 275.0, 6.0, 4.0).section;
    let plastic = plastic_shear(ipe.shear_area(), 275.0, 1.0);
    assert!((plastic / 351_570.0 - 1.0).abs() < 1e-3, "{plastic}");
    let at = |part: f64| beam_method::bending_6_2_8(&ipe, 275.0, part * plastic, 1.0).value;
    near(at(0.5), ipe.w_pl * 275.0);
    assert!((at(0.75) / 126.03e6 - 1.0).abs() < 1e-3, "{}", at(0.75));
    assert!(at(0.9) < at(0.75) && at(1.5) == at(1.0));
}

#[test]
fn table_6_11_stiffness_coefficients() {
    near(stiffness::panel_in_shear(1308.0, 1.0, 250.0), 0.38 * 1308.0 / 250.0);
    near(stiffness::web_across(200.0, 7.0, 92.0), 0.7 * 200.0 * 7.0 / 92.0);
    near(stiffness::flange_in_bending(120.0, 12.0, 24.0), 0.9 * 120.0 / 8.0);
    near(stiffness::bolts_in_tension(157.0, 40.0), 1.6 * 157.0 / 40.0);
    // 6.3.3.1 with one row: z_eq is its lever arm, k_eq its k_eff
    let mut joint = one_sided();
    joint.bolts.rows.truncate(1);
    let s = assess(&joint).expect("covered").stiffness;
    near(s.lever, s.rows[0].lever);
    near(s.equivalent, s.rows[0].effective);
}

#[test]
fn clause_6_3_1_and_table_6_8_stiffness_under_moment() {
    let at = |m: f64| stiffness::at_moment(1e9, m, 90e6).value;
    near(at(60e6), 1e9);
    near(at(-90e6), 1e9 / 1.5f64.powf(2.7));
    near(at(75e6), 1e9 / 1.25f64.powf(2.7));
    near(stiffness::for_elastic_analysis(1e9, Joins::BeamToColumn).value, 5e8);
    near(stiffness::for_elastic_analysis(1.2e9, Joins::Other).value, 4e8);
}
