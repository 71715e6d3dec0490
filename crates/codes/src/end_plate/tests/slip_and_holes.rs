//! Preloaded bolts, their categories and holes.

use super::fixture::{ONE, bolted, checks, find, joint, near};
use crate::check::{CheckId, Status};
use crate::end_plate::HandChecks;

/// Six preloaded bolts: F_s,Rd = μ F_p,C/γ_M3 each; an axial tension reduces it by 0.8 of its
/// share, a moment by nothing (3.9.2(3)). Exceeding it is a warning, because the spec does not
/// require slip to be prevented. Without preload or friction there is no such check.
#[test]
fn clause_3_9_slip_of_preloaded_bolts() {
    let title = "slip of the preloaded bolts at the ultimate limit state (category C)";
    let h = |preload: &str, mu: &str, load: &str| {
        let text = joint("", &format!("{{name: A, end: beam_right, at: bolt_plane, {load}}}"));
        checks(&format!(
            "{}friction: {{mu: {mu}}}\n",
            text.replace("\"8.8\",", &format!("\"8.8\", preload: {preload},"))
        ))
    };
    let force = 0.7 * 800.0 * 245.0;
    for (said, load, clamp, shear) in [
        ("0.7", "Vz: -100 kN", force, 100e3),
        ("0.7", "Vz: -100 kN, My: 40 kN m", force, 100e3),
        ("0.7", "Vz: -100 kN, N: 60 kN", force - 0.8 * 10e3, 100e3),
        ("0.7", "Vz: -100 kN, N: -60 kN", force, 100e3),
        ("50 kN", "Vz: -60 kN, Vy: 80 kN", 50e3, 100e3),
    ] {
        let found = h(said, "0.2", load);
        let slip = find(&found, "beam_right", title);
        let (want, used) = (0.2 * clamp / 1.25, slip.utilisation.unwrap_or(f64::NAN));
        assert!(
            (slip.resistance.unwrap_or(f64::NAN) / want - 1.0).abs() < 1e-12,
            "{load}: {slip:#?}"
        );
        assert!((used / (shear / 6.0 / want) - 1.0).abs() < 1e-12, "{load}: {slip:#?}");
        assert_eq!(slip.status, if used > 1.0 { Status::Warning } else { Status::Ok }, "{load}");
    }
    for (said, mu) in [("none", "0.2"), ("0.7", "0")] {
        assert!(h(said, mu, "Vz: -100 kN").checks.iter().all(|c| c.id().title() != title));
    }
}

/// F_p,C = 0.7 · 800 · 245 = 137.2 kN, six bolts with μ = 0.2: 6 · 27.44/1.25 = 131.7 kN at the
/// ultimate limit state (category C), 6 · 27.44/1.1 = 149.7 kN at serviceability (category B).
#[test]
fn clause_3_4_categories_b_and_c_bind_in_their_limit_state() {
    let ultimate = "slip of the preloaded bolts at the ultimate limit state (category C)";
    let service = "slip of the preloaded bolts at serviceability (category B)";
    let of = |category: &str, state: &str, v: f64| {
        let load =
            format!("{{name: A, end: beam_right, at: bolt_plane, state: {state}, Vz: -{v} kN}}");
        checks(&bolted(&format!("size: HR M20, grade: \"8.8\", preload: 0.7{category}"), "", &load))
    };
    let has =
        |h: &HandChecks, title: &str| h.checks.iter().find(|c| c.id().title() == title).cloned();
    let (b, c) = (", category: B", ", category: C");
    for (category, state, title, fails, limit) in [
        (c, "ULS", ultimate, true, 131.7),
        (b, "SLS", service, true, 149.7),
        ("", "ULS", ultimate, false, 131.7),
        ("", "SLS", service, false, 149.7),
    ] {
        let (below, above) = (of(category, state, limit - 0.1), of(category, state, limit + 0.1));
        assert_eq!(has(&below, title).expect(title).status, Status::Ok, "{category} {state}");
        let want = if fails { Status::Failed } else { Status::Warning };
        assert_eq!(has(&above, title).expect(title).status, want, "{category} {state}");
        assert_eq!(above.failed(), fails);
    }
    for category in [b, ", category: A", ", category: D", ", category: E"] {
        assert!(has(&of(category, "ULS", 100.0), ultimate).is_none(), "{category}");
    }
    assert!(has(&of(c, "SLS", 100.0), service).is_none());
    // nothing else is checked at serviceability, even for loads that bolts and beam cannot carry
    let h = of(c, "SLS", 4000.0);
    assert!(!h.failed() && h.checks.iter().all(|c| c.case.is_none()), "{:#?}", h.checks);
    // without a load case at serviceability category B is not checked, which is reported
    let words = "category B: no load case has";
    assert!(
        of(b, "ULS", 1.0)
            .checks
            .iter()
            .any(|c| c.id().title().starts_with(words) && c.status == Status::Undecided)
    );
    assert!(of(b, "SLS", 1.0).checks.iter().all(|c| !c.id().title().starts_with(words)));
    // without friction nothing prevents slip
    let load = "{name: A, end: beam_right, at: bolt_plane, Vz: -1 kN}";
    let text = bolted("size: HR M20, grade: \"8.8\", preload: 0.7, category: C", "", load);
    assert!(checks(&text.replace("mu: 0.2", "mu: 0")).failed());
    // 160 kN is more than F_p,C
    let h = checks(&text.replace("preload: 0.7", "preload: 150 kN"));
    assert_eq!(
        find(&h, "M20 8.8", "preload of the slip resistance, no more than F_p,C").status,
        Status::Failed
    );
}

/// d0 = 24 mm for M20: bearing 0.8 · 2.5 · 1 · 360 · 20 · 15/1.25 = 172.8 kN (α_b = 1, k1 = 2.5),
/// k_s = 0.85.
#[test]
fn tables_3_4_and_3_6_oversize_holes() {
    let load = "{name: A, end: beam_right, at: bolt_plane, Vz: -100 kN}";
    let of = |more: &str| checks(&bolted("size: HR M20, grade: \"8.8\", preload: 0.7", more, load));
    let (normal, oversize) = (of("hole_clearance: 2"), of("hole_clearance: 4"));
    let bearing = |h: &HandChecks| {
        find(h, "end plate, inner bolt", "bearing resistance at a bolt")
            .resistance
            .unwrap_or(f64::NAN)
    };
    near(bearing(&normal), 216e3, 1e-9);
    near(bearing(&oversize), 172.8e3, 1e-9);
    let slip = |h: &HandChecks| {
        let title = "slip of the preloaded bolts at the ultimate limit state (category C)";
        find(h, "beam_right", title).resistance.unwrap_or(f64::NAN)
    };
    near(slip(&oversize), 0.85 * slip(&normal), 1e-9);
    assert!(
        find(&normal, "holes", "normal round holes").formula().to_string().contains("k_s = 1 ")
    );
    assert!(
        find(&oversize, "holes", "oversize round holes")
            .formula()
            .to_string()
            .contains("k_s = 0.85")
    );
    // wider than oversize: the code has no such hole, for bearing or for slip
    let wide = of("hole_clearance: 5");
    assert_eq!(find(&wide, "holes", "outside the range of the rules").status, Status::Undecided);
    assert!(wide.checks.iter().all(|c| c.id() != CheckId::BearingResistance));
    assert!(
        wide.checks.iter().all(|c| !c.id().title().starts_with("slip") || c.resistance.is_none())
    );
}

/// Preloaded bolts that are not an assembly of EN 14399 are a warning; those of the HR and HV
/// systems are not.
#[test]
fn clause_3_1_2_preloaded_bolts_are_assemblies_of_en_14399() {
    let title = "preloaded bolts are assemblies of EN 14399: take a size `HR …` or `HV …`";
    for (bolts, warned) in [
        ("size: M20, grade: \"8.8\", preload: 0.7", true),
        ("size: M20, grade: \"8.8\"", false),
        ("size: HR M20, grade: \"8.8\", preload: 0.7", false),
        ("size: HV M20, grade: \"10.9\", preload: 0.7", false),
    ] {
        let h = checks(&bolted(bolts, "", ONE));
        assert_eq!(
            h.checks.iter().any(|c| c.id().title() == title && c.status == Status::Warning),
            warned,
            "{bolts}"
        );
    }
}

/// A preloaded category needs a preload, and the loads of a case need one limit state.
#[test]
fn table_3_2_wrong_categories_and_states_are_reported() {
    let fault = |text: &str| {
        let parsed = bracket_base::yaml::parse::<bracket_joint::spec::ConnectionSpec>(
            text,
            std::path::Path::new("joint.yaml"),
        );
        let catalog =
            bracket_joint::catalog::Catalog::builtin().expect("the shipped catalogue is sound");
        let spec = parsed.unwrap_or_else(|faults| panic!("{faults:#?}"));
        crate::design_code::build(&spec, std::path::Path::new("."), &catalog)
            .expect_err(text)
            .into_first()
    };
    for category in ["B", "C", "E"] {
        let d =
            fault(&bolted(&format!("size: HR M20, grade: \"8.8\", category: {category}"), "", ONE));
        assert_eq!(d.place.path.as_deref(), Some("bolts.category"), "{d:#?}");
        assert!(d.message.contains("preload"), "{d:#?}");
    }
    let two = format!("{ONE}, {{name: A, section: column_top, pressure: 1 MPa, state: SLS}}");
    let d = fault(&joint("", &two));
    assert!(
        d.place.path.as_deref() == Some("loads[1].state") && d.message.contains("two limit states"),
        "{d:#?}"
    );
}
