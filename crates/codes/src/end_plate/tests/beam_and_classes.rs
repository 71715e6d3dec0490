//! The beam's own cross-section, the classes of the joint, tying.

use super::fixture::{ONE, checks, find, joint, loaded, near, notes, used};
use crate::check::Status;

/// IPE300 S235: A_v = 5381 − 2 · 150 · 10.7 + (7.1 + 30) · 10.7 = 2568 mm², 348.4 kN; M_pl =
/// 628.4e3 · 235 = 147.7 kN m. At 300 kN ρ = (600/348.4 − 1)² = 0.5215 and (628.4e3 − 0.5215 ·
/// 1978²/28.4) · 235 = 130.8 kN m; at 500 kN of 1264.5 kN n = 0.3954, a = 0.4035 and 147.7 ·
/// 0.6046/0.7983 = 111.8 kN m.
#[test]
fn en_1993_1_1_6_2_the_beam_at_the_joint() {
    let of = |load: &str| loaded(&ONE.replace("My: 40 kN m", load));
    let shear = |load: &str| find(&of(load), "beam_right, beam", "shear of the beam").clone();
    let moment = |load: &str| {
        find(&of(load), "beam_right, beam", "moment of the beam with its shear and axial force")
            .clone()
    };
    near(shear("My: 40 kN m, Vz: -100 kN").resistance.unwrap_or(f64::NAN), 348.4e3, 1e-3);
    near(used(&shear("My: 40 kN m, Vz: -100 kN")), 100.0 / 348.4, 1e-3);
    assert_eq!(shear("Vz: -350 kN").status, Status::Failed);
    for (load, want) in [
        ("My: 40 kN m, Vz: -100 kN", 147.7e6),
        ("My: 40 kN m, Vz: -300 kN", 130.8e6),
        ("My: 40 kN m, N: 500 kN", 111.8e6),
        ("My: -40 kN m, N: -500 kN", 111.8e6),
        ("My: 40 kN m, N: 250 kN", 147.7e6),
    ] {
        near(moment(load).resistance.unwrap_or(f64::NAN), want, 1e-3);
    }
    near(used(&moment("My: 200 kN m")), 200.0 / 147.7, 1e-3);
    let axial =
        find(&of("N: 1300 kN, My: 1 kN m"), "beam_right, beam", "axial force of the beam").clone();
    near(used(&axial), 1300.0 / 1264.5, 1e-3);
    // more shear or axial force never leaves more
    let mut last = f64::INFINITY;
    for i in 0..80 {
        let left = moment(&format!("My: 10 kN m, Vz: -{} kN, N: {} kN", 5 * i, 20 * i))
            .resistance
            .unwrap_or(f64::NAN);
        assert!(left <= last * (1.0 + 1e-12), "{i}: {left} {last}");
        last = left;
    }
    // the beam is checked where the component method does not cover the joint
    let rows = joint("", &ONE.replace("My: 40", "My: -40"))
        .replace("rows: [-90, 90, 190]", "rows: [-260, -190, 90]");
    let h = checks(&rows.replace("thickness: 15", "thickness: 15, z: [-300, 230]"));
    assert!(notes(&h).iter().any(|n| n.contains("two rows or more")), "{:?}", h.notes);
    find(&h, "beam_right, beam", "moment of the beam with its shear and axial force");
}

/// IPE300 of 6 m: E I_b/L_b = 210e3 · 8356e4/6000 = 2925 kN m, so 8 and 25 times it, 23.4e3 and
/// 73.1e3, and half of it, 1462 kN m/rad. HEB200 of 3 m: K_b/K_c = (8356/6000)/(5696/3000) = 0.733;
/// of 0.3 m: 0.0733, too stiff for a rigid joint in a frame that sways. M_b,pl = 147.7, M_c,pl =
/// 642.5e3 · 235 = 151 kN m. Shear and axial force change nothing.
#[test]
fn clause_5_2_classes_under_every_load_case() {
    let of = |beam: &str, column: &str, load: &str| {
        let text = joint("", &ONE.replace("My: 40 kN m", load));
        let text = text.replace("{profile: IPE300", &format!("{{{beam}profile: IPE300"));
        checks(&text.replace("{profile: HEB200", &format!("{{{column}profile: HEB200")))
    };
    for load in ["My: 40 kN m", "My: 40 kN m, Vz: -50 kN, N: -80 kN"] {
        let h = of("length: 6 m, ", "", load);
        let strength = find(&h, "beam_right, tension at the top", "class by strength");
        assert!(
            strength.case.as_deref() == Some("A")
                && strength.formula().to_string().starts_with("partial"),
            "{strength:#?}"
        );
        let joint = find(&h, "tension at the top", "moment resistance of the joint")
            .resistance
            .unwrap_or(f64::NAN);
        near(strength.resistance.unwrap_or(f64::NAN), joint / 147.7e6, 1e-3);
        let initial = find(&h, "tension at the top", "initial rotational stiffness")
            .resistance
            .unwrap_or(f64::NAN);
        for (frame, rigid) in [("braced frame", 23.4e9), ("other frames", 73.1e9)] {
            let check =
                find(&h, &format!("beam_right, tension at the top, {frame}"), "class by stiffness");
            let want = if initial >= rigid { "rigid" } else { "semi-rigid" };
            assert!(
                check.formula().to_string().starts_with(want) && initial > 1.462e9,
                "{check:#?}"
            );
        }
        let secant =
            find(&h, "beam_right, tension at the top", "rotational stiffness under the moment");
        let ratio = 40e6 / joint;
        let mu = if ratio <= 2.0 / 3.0 { 1.0 } else { (1.5 * ratio).powf(2.7) };
        near(secant.resistance.unwrap_or(f64::NAN), initial / mu, 1e-9);
    }
    let other = |column: &str| {
        let h = of("length: 60 m, ", column, "My: 40 kN m");
        let class = find(&h, "beam_right, tension at the top, other frames", "class by stiffness");
        class.formula().to_string()
    };
    assert!(other("").starts_with("rigid") && other("").contains("K_b/K_c < 0.1"), "{}", other(""));
    let long = other("length: 30 m, ");
    assert!(
        long.starts_with("rigid") && long.contains("; K_b/K_c = ") && long.contains(" = 0.733"),
        "{long}"
    );
    assert!(other("length: 3 m, ").starts_with("semi-rigid"), "{}", other("length: 3 m, "));
    let unknown = of("", "", "My: 400 kN m");
    let length =
        find(&unknown, "beam_right", "system length of the beam from which the joint is rigid");
    let initial = find(&unknown, "tension at the top", "initial rotational stiffness")
        .resistance
        .unwrap_or(f64::NAN);
    near(length.resistance.unwrap_or(f64::NAN), 8.0 * 210e3 * 8356e4 / initial, 1e-9);
    // 400 kN m are above M_j,Rd, up to which the formula of S_j holds
    let title = "rotational stiffness under the moment";
    assert!(unknown.checks.iter().all(|c| c.id().title() != title));
}

/// Plate of 40 mm on HEM200: M20 8.8 break before anything bends, 2 · 0.9 · 800 · 245/1.1 = 320.7
/// kN a row, three rows 962.2 kN. Thinner plates carry less.
#[test]
fn en_1991_1_7_a_5_tying_resistance() {
    let of = |thickness: u32, column: &str| {
        let text = joint("column_above: 2 m", ONE)
            .replace("profile: HEB200", &format!("profile: {column}"));
        let h = checks(&text.replace("thickness: 15", &format!("thickness: {thickness}")));
        let check = find(&h, "end plate", "tying resistance, without welds").clone();
        assert_eq!(check.status, Status::Information);
        check.resistance.unwrap_or(f64::NAN)
    };
    near(of(40, "HEM200"), 962.2e3, 1e-3);
    let thin = of(10, "HEB200");
    assert!(thin > 100e3 && thin < 700e3, "{thin}");
}

/// IPE300, S235: M_pl,y = 147.7, M_pl,z = 29.4 kN m, I_t = 19.75 cm⁴, t_f = 10.7 mm.
#[test]
fn clause_6_2_7_and_6_2_9_torsion_and_bending_about_both_axes() {
    let fy: f64 = 235.0;
    let of = |actions: &str| {
        loaded(&format!("{{name: A, end: beam_right, at: bolt_plane, My: 40 kN m, {actions}}}"))
    };
    let title = "bending of the beam about both axes";
    let (y, z) = (628.4e3 * fy, 125.2e3 * fy);
    let h = of("Mz: 5 kN m");
    near(used(find(&h, "beam_right, beam", title)), (40e6_f64 / y).powi(2) + 5e6 / z, 2e-3);
    // n = 0.3: β = 1.5, M_N,y = M_pl (1 − n)/(1 − a/2), a = (A − 2 b t_f)/A = 0.4035, n below a
    let h = of("Mz: -5 kN m, N: 379.4 kN");
    let reduced = y * 0.7 / (1.0 - 0.5 * 0.4035);
    near(
        used(find(&h, "beam_right, beam", title)),
        (40e6_f64 / reduced).powi(2) + (5e6_f64 / z).powf(1.5),
        3e-3,
    );
    // τ_t = T t/I_t = 27.1 MPa leaves √(1 − 27.1/169.6) = 0.917 of the shear resistance
    let h = of("T: 0.5 kN m, Vz: -100 kN");
    let twist = find(&h, "beam_right, beam", "torsion of the beam");
    let constant = 19.75e4;
    near(used(twist), 0.5e6 / (constant / 10.7 * fy / 3f64.sqrt()), 5e-3);
    let plain = find(&h, "beam_right, beam", "shear of the beam");
    let beside = find(&h, "beam_right, beam", "shear of the beam beside torsion");
    near(used(plain) / used(beside), (1.0_f64 - 27.09 / 169.6).sqrt(), 2e-3);
    assert_eq!(beside.status, Status::Ok);
    // more than St. Venant torsion carries is undecided, because warping may carry it
    let h = of("T: 5 kN m");
    assert_eq!(find(&h, "beam_right, beam", "torsion of the beam").status, Status::Undecided);
}
