//! Every rule of a base a second time, with formulas written from the code for 200 random bases.
//! EN 1993-1-8:2005 numbers stand beside each; γ_M0 = 1, γ_M2 = 1.25, γ_c = 1.5, S235, M20 8.8.

use super::fixture::{actions, base};
use super::second::Numbers;
use crate::check::{Check, CheckId};
use crate::column_base::base_checks;
use bracket_joint::assembly::{BaseSection, ColumnBase};
use bracket_joint::strength::Nominal;
use std::f64::consts::PI;

const FY: f64 = 235.0;
const FU: f64 = 360.0;
const E: f64 = 210_000.0;
const AS: f64 = 245.0;
const FUB: f64 = 800.0;
const GAMMA_M2: f64 = 1.25;

/// I section: h, b, t_w, t_f, r, A, I_y, W_pl.
struct Section {
    h: f64,
    b: f64,
    tw: f64,
    tf: f64,
    r: f64,
    area: f64,
    inertia: f64,
    plastic: f64,
}

fn section(e: &ColumnBase) -> Section {
    let BaseSection::I(p) = &e.section else { panic!("{:?}", e.section) };
    Section {
        h: p.h,
        b: p.b,
        tw: p.tw,
        tf: p.tf,
        r: p.r,
        area: 100.0 * p.area,
        inertia: 1e4 * p.i_y,
        plastic: 1e3 * p.w_pl_y,
    }
}

fn random(r: &mut Numbers) -> ColumnBase {
    let mut e = base();
    e.thickness = r.within(12.0, 45.0);
    e.plate = [r.within(340.0, 500.0), r.within(290.0, 420.0)];
    e.offset = r.within(-10.0, 10.0);
    e.rows = vec![-r.within(118.0, 140.0), r.within(118.0, 140.0)];
    let half = r.within(40.0, 110.0);
    e.across = vec![-half, half];
    e.elastic_length = r.within(60.0, 600.0);
    e.flange_throat = r.within(4.0, 9.0);
    e.web_throat = r.within(3.0, 6.0);
    e.foundation.plate = e.plate;
    e.foundation.f_ck = Nominal::new(r.within(12.0, 40.0));
    e.foundation.grout_strength = e.foundation.f_ck;
    e.foundation.edge = [[r.within(0.0, 500.0), r.within(0.0, 500.0)], [r.within(0.0, 500.0); 2]];
    e.foundation.depth = r.within(250.0, 1500.0);
    e
}

/// 6.2.5(7) with β_j = 2/3: the load spreads into the block, at most three times the plate.
fn f_jd(e: &ColumnBase) -> f64 {
    let [length, width] = e.plate;
    let [near, far] = [e.foundation.edge[0], e.foundation.edge[1]].map(|s| s[0].min(s[1]));
    let k = [
        1.0 + e.foundation.depth / length.max(width),
        1.0 + 2.0 * near / length,
        1.0 + 2.0 * far / width,
        3.0,
    ];
    2.0 / 3.0 * k.into_iter().fold(f64::INFINITY, f64::min) * e.foundation.f_ck.mpa() / 1.5
}

/// Distance from the column's axis to the edge of the plate at positive (1) or negative (−1) x.
fn edge(e: &ColumnBase, side: f64) -> f64 {
    e.plate[0] / 2.0 + side * e.offset
}

/// F_C,Rd: 6.2.6.9 with the area within c of the flange, 6.2.6.7 with M_pl,Rd. HE200B of S235 is of
/// class 1.
fn compression(e: &ColumnBase, side: f64) -> (f64, f64) {
    let s = section(e);
    let c = e.thickness * (FY / (3.0 * f_jd(e))).sqrt();
    let outer = edge(e, side).min(s.h / 2.0 + c);
    let inner = (s.h / 2.0 - s.tf - c).max(0.0);
    let area = (outer - inner) * e.plate[1].min(s.b + 2.0 * c);
    ((f_jd(e) * area).min(s.plastic * FY / (s.h - s.tf)), area)
}

/// m, ℓ_eff,1, prying (Table 6.2, L_b ≤ L_b*) and F_T,Rd of the row (Table 6.6, Table 6.2; the
/// plate without prying, the anchors with it, 6.2.6.11(2)).
fn tension(e: &ColumnBase, side: f64) -> (f64, f64, bool, f64) {
    let s = section(e);
    let row = if side > 0.0 { e.rows[1] } else { -e.rows[0] };
    let m = row - s.h / 2.0 - 0.8 * 2f64.sqrt() * e.flange_throat;
    let (ex, w, b) = (edge(e, side) - row, 2.0 * e.across[1], e.plate[1]);
    let ey = (b - w) / 2.0;
    let round = [2.0 * PI * m, PI * m + w, PI * m + 2.0 * ey];
    let straight =
        [4.0 * m + 1.25 * ex, ey + 2.0 * m + 0.625 * ex, b / 2.0, w / 2.0 + 2.0 * m + 0.625 * ex];
    let least = |of: &[f64]| of.iter().copied().fold(f64::INFINITY, f64::min);
    let l2 = least(&straight);
    let l1 = least(&round).min(l2);
    let t3 = e.thickness.powi(3);
    let pries = e.elastic_length <= 8.8 * m.powi(3) * AS / (l1 * t3);
    let moment = |l: f64| 0.25 * l * e.thickness * e.thickness * FY;
    let (n, bolts) = (ex.min(1.25 * m), 2.0 * 0.9 * FUB * AS / GAMMA_M2);
    let plate = match pries {
        true => (2.0 * moment(l1) / m).min((2.0 * moment(l2) + n * bolts) / (m + n)),
        false => 2.0 * moment(l1) / m,
    };
    (m, l1, pries, plate.min(bolts).min(s.b * s.tf * FY))
}

/// 2 M_pl,1/m of the row.
fn plate_alone(e: &ColumnBase, side: f64) -> f64 {
    let (m, l1, ..) = tension(e, side);
    0.5 * l1 * e.thickness * e.thickness * FY / m
}

/// Table 6.7: M_j,Rd at the eccentricity e = M/N, for M > 0 with tension on the side `side`.
fn resistance(e: &ColumnBase, axial: f64, moment: f64, side: f64) -> f64 {
    let s = section(e);
    let z_c = (s.h - s.tf) / 2.0;
    let [near, far] = [side, -side].map(|k| {
        let z = if k > 0.0 { e.rows[1] } else { -e.rows[0] };
        (z, tension(e, k).3, compression(e, k).0)
    });
    let ecc = moment.abs() / axial;
    match () {
        // both sides in tension
        () if axial > 0.0 && ecc <= near.0 => {
            let z = near.0 + far.0;
            let left = near.1 * z / (far.0 / ecc + 1.0);
            // no force is left on the far side where the moment lifts it altogether
            if ecc == near.0 { left } else { left.min(far.1 * z / (near.0 / ecc - 1.0)) }
        }
        // both sides in compression
        () if axial < 0.0 && ecc >= -z_c => f64::NAN,
        () if axial < 0.0 && -ecc <= z_c => {
            let z = 2.0 * z_c;
            (near.2 * z / (z_c / -ecc - 1.0)).min(far.2 * z / (z_c / -ecc + 1.0))
        }
        // tension on the near side, compression on the far one
        () => {
            let z = near.0 + z_c;
            let pull = near.1 * z / (z_c / ecc + 1.0);
            let push = -far.2 * z / (near.0 / ecc - 1.0);
            pull.min(push)
        }
    }
}

/// Utilisation of the welds of a flange, which takes M and its part of N (4.5.3.2(6)).
fn flange_weld(e: &ColumnBase, axial: f64, moment: f64) -> f64 {
    let s = section(e);
    let force = moment.abs() / (s.h - s.tf) + axial.abs() * s.b * s.tf / s.area;
    let normal = force / (s.b - s.tw / 2.0 - s.r) / 2.0 / (2f64.sqrt() * e.flange_throat);
    (2.0 * normal / (FU / (0.8 * GAMMA_M2))).max(normal / (0.9 * FU / GAMMA_M2))
}

#[test]
fn every_rule_a_second_time() {
    let mut r = Numbers(44);
    let (mut sides, mut springs, mut welds, mut by_weld) = (0, 0, 0, 0);
    for i in 0..200 {
        let mut e = random(&mut r);
        let n = r.within(-900e3, 150e3);
        let m = r.within(5e6, 60e6) * if i % 2 == 0 { 1.0 } else { -1.0 };
        let v = r.within(1e3, 150e3);
        e.actions = vec![actions([n, v, m])];
        let checks = base_checks(&e).checks;
        let find = |id: CheckId| checks.iter().filter(move |c| c.id() == id);
        let near = |what: &str, check: Option<&Check>, want: f64| {
            let share = matches!(what, "weld" | "V and N");
            let got = check.and_then(|c| if share { c.utilisation } else { c.resistance });
            let got = got.unwrap_or_else(|| panic!("{what}: {check:#?}"));
            assert!((got / want - 1.0).abs() < 1e-9, "{i} {what}: {got}, not {want}: {e:#?}");
        };
        let side = m.signum();
        let z_c = (section(&e).h - section(&e).tf) / 2.0;
        let both_pressed = n < 0.0 && m.abs() <= -n * z_c;
        let want = match both_pressed {
            // Table 6.7, last rows: N = F_C,l + F_C,r
            true => {
                let [low, high] = [side, -side].map(|k| compression(&e, k).0);
                let used = ((-n * z_c - m.abs()) / (2.0 * z_c * low))
                    .max((-n * z_c + m.abs()) / (2.0 * z_c * high));
                m.abs() / used
            }
            false => resistance(&e, n, m, side),
        };
        // 6.2.3(4): no more than the welds of the flanges carry
        let welded = m.abs() / flange_weld(&e, n, m);
        by_weld += usize::from(welded < want);
        let want_with_welds = want.min(welded);
        near("M_j,Rd", find(CheckId::BaseMoment).next(), want_with_welds);
        sides += usize::from(!both_pressed);

        // 6.2.2: friction, formula 6.2 and the bearing of Table 3.4
        let friction = 0.2 * (-n).max(0.0);
        let s = section(&e);
        if v > friction {
            let steel = (0.44 - 0.0003 * 640.0) * FUB * AS / GAMMA_M2;
            let e1 = (edge(&e, 1.0) - e.rows[1]).min(edge(&e, -1.0) + e.rows[0]);
            let e2 = e.plate[1] / 2.0 - e.across[1];
            let k1 = (2.8 * e2 / 22.0 - 1.7).min(1.4 * 2.0 * e.across[1] / 22.0 - 1.7).min(2.5);
            let along = (e1 / 66.0).min((e.rows[1] - e.rows[0]) / 66.0 - 0.25).min(1.0);
            let bearing = k1 * along * FU * 20.0 * e.thickness / GAMMA_M2;
            let one = steel.min(bearing);
            near("F_v,Rd", find(CheckId::BaseShear).next(), friction + 4.0 * one);
            if !both_pressed {
                let (m_row, _, pries, pull) = tension(&e, side);
                let ft = 0.9 * FUB * AS / GAMMA_M2;
                let row = (m.abs() + n * z_c) / (z_of(&e, side) + z_c);
                // where the base fails by code, its anchors count with all that they carry
                if n <= 0.0 && m.abs() <= want {
                    // prying m/(2n) beside a yield line of the plate; by mode 2 all of F_t,Rd
                    let row_of = if side > 0.0 { e.rows[1] } else { -e.rows[0] };
                    let lever = (edge(&e, side) - row_of).min(1.25 * m_row);
                    let all = 2.0 * ft / pull;
                    let more = match pries && pull < plate_alone(&e, side) * (1.0 - 1e-12) {
                        true => all.max(1.0),
                        false if pries => all.min(1.0 + 0.5 * m_row / lever).max(1.0),
                        false => 1.0,
                    };
                    let used = (v - friction) / 4.0 / one + row * more / 2.0 / (1.4 * ft);
                    near("V and N", find(CheckId::AnchorShearAndTension).next(), used);
                }
            }
        } else {
            near("F_f,Rd", find(CheckId::BaseShear).next(), friction);
        }

        // 4.5.3.2(6): flanges take M and their part of N, the web its stresses and V
        let (limit, normal) = (FU / (0.8 * GAMMA_M2), 0.9 * FU / GAMMA_M2);
        let depth = s.h - 2.0 * s.tf - 2.0 * s.r;
        let web = (n.abs() / s.area + m.abs() * depth / (2.0 * s.inertia)) * s.tw;
        let across = web / 2.0 / (2f64.sqrt() * e.web_throat);
        let along = v / depth / (2.0 * e.web_throat);
        let used =
            |p: f64, l: f64| ((p * p + 3.0 * (p * p + l * l)).sqrt() / limit).max(p / normal);
        let found: Vec<&Check> = find(CheckId::WeldDirectional).collect();
        assert_eq!(found.len(), 2);
        for (check, want) in found.iter().zip([flange_weld(&e, n, m), used(across, along)]) {
            near("weld", Some(*check), want);
            welds += 1;
        }

        // Table 6.11 and 6.12: a bar on two springs under N and M, the rotation by Cramer's rule
        let stiff = find(CheckId::InitialStiffness).next();
        if let Some(stiff) = stiff {
            let e_c = 22_000.0 * ((e.foundation.f_ck.mpa() + 8.0) / 10.0).powf(0.3);
            let pressed = |side: f64| e_c * compression(&e, side).1.sqrt() / (1.275 * E);
            let pulled = |side: f64| {
                let (m_row, l1, pries, _) = tension(&e, side);
                let (a, b) = if pries { (0.85, 1.6) } else { (0.425, 2.0) };
                let k15 = a * l1 * e.thickness.powi(3) / m_row.powi(3);
                let k16 = b * AS / e.elastic_length;
                k15 * k16 / (k15 + k16)
            };
            let lifted = n > 0.0 && m.abs() <= n * z_of(&e, side);
            let (k1, x1) =
                if both_pressed { (pressed(side), z_c) } else { (pulled(side), z_of(&e, side)) };
            let (k2, x2) =
                if lifted { (pulled(-side), -z_of(&e, -side)) } else { (pressed(-side), -z_c) };
            let [s0, s1, s2] = [0, 1, 2].map(|i| E * (k1 * x1.powi(i) + k2 * x2.powi(i)));
            let rotation = (s0 * m.abs() - s1 * n) / (s0 * s2 - s1 * s1);
            let want = m.abs() / rotation;
            near("S_j,ini", Some(stiff), want);
            near("L_c", find(CheckId::BaseRigidLength).next(), 30.0 * E * s.inertia / want);
            springs += 1;
        }
    }
    let seen = [sides, springs, welds, by_weld];
    assert!(sides > 60 && springs > 40 && welds == 400 && by_weld > 10, "{seen:?}");
}

/// z_T of the row on a side.
fn z_of(e: &ColumnBase, side: f64) -> f64 {
    if side > 0.0 { e.rows[1] } else { -e.rows[0] }
}
