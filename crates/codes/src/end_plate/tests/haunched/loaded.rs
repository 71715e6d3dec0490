//! Haunched beams under loads, by hand.

use super::random::{Random, haunched, of_ipe300};
use super::{plain, same};
use crate::check::{Check, CheckId, Status};
use crate::end_plate::component_joint::component_joint;
use crate::end_plate::hand_checks;
use crate::subject::Part;
use bracket_joint::assembly::EndPlate;
use bracket_joint::catalog::Catalog;
use std::f64::consts::SQRT_2;

/// The check of a load case with an id at a part.
fn find(e: &EndPlate, id: CheckId, part: Part) -> Option<Check> {
    let of = |c: &Check| {
        c.id() == id && c.case.is_some() && c.subject.to_string().contains(part.words())
    };
    hand_checks(e).checks.into_iter().find(of)
}

/// The forces at the tip of the haunch, what its flange brings into the web of the beam and along
/// its seam, for random joints under loads, from the statics of the piece between plate and tip.
#[test]
fn the_tip_of_a_haunch_is_in_equilibrium_with_the_plate() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let load = "{name: A, end: beam_right, at: bolt_plane, My: 60 kN m, Vz: -80 kN, N: -40 kN}";
    let (base, mut n, mut seen, mut worst) = (plain(load), Random(11), 0, 0.0);
    for _ in 0..60 {
        let e = haunched(&base, &catalog, &mut n);
        let Some((r, h)) = e.rafter.as_deref().and_then(|r| Some((r, r.haunch.as_ref()?))) else {
            continue;
        };
        let out = hand_checks(&e);
        let at = |id: CheckId, part: Part| {
            let of = |c: &&crate::check::Check| {
                c.id() == id && c.case.is_some() && c.subject.to_string().contains(part.words())
            };
            out.checks.iter().find(of)
        };
        // the point on the axis of the beam at the tip: from the lower face of the beam at the
        // plate along it, then half of the depth across
        let (s, c) = r.slope.sin_cos();
        let start = r.depth / 2.0 - e.beam.h / c;
        let x = h.length * c - e.beam.h / 2.0 * s;
        let z = start + h.length * s + e.beam.h / 2.0 * c;
        let (n_ed, v_ed, m_ed) = (-40e3, -80e3, 60e6);
        let tip = |id| at(id, Part::HaunchTip).and_then(|c| c.demand).unwrap_or(f64::NAN);
        same("N", tip(CheckId::BeamAxial), (n_ed * c + v_ed * s).abs(), &mut worst);
        same("V", tip(CheckId::BeamShear), (v_ed * c - n_ed * s).abs(), &mut worst);
        if let Some(moment) = at(CheckId::BeamMoment, Part::HaunchTip).and_then(|c| c.demand) {
            same("M", moment, (m_ed + v_ed * x - n_ed * z).abs(), &mut worst);
        }
        let Some(web) = at(CheckId::HaunchTipWeb, Part::HaunchTip) else { continue };
        let seam = at(CheckId::HaunchWebShear, Part::HaunchWeb).expect("a seam");
        // both come from one force along the haunch flange
        let across = web.demand.unwrap_or(f64::NAN) / h.angle.sin();
        let along = seam.demand.unwrap_or(f64::NAN) * h.length / h.angle.cos();
        same("F_h", across, along, &mut worst);
        // no less than the moment on the lever arm of the flanges asks for
        let lever = component_joint(&e, 1.0).beam.lever();
        let least = 0.5 * m_ed / lever / (r.slope + h.angle).cos();
        assert!(across > least, "F_h = {across}");
        seen += 1;
    }
    println!("{seen} haunches, largest difference {worst:.1e}");
    assert!(seen >= 20, "{seen}");
}

/// Fillet welds of inclined flanges take F/cos by the directional method with their sharper
/// angle ψ = 90° − θ: σ⊥ = F sin(ψ/2)/a, τ⊥ = F cos(ψ/2)/a. By hand for IPE300 at 6° with a haunch
/// as deep again, z_f between the middles of the flanges along the plate.
#[test]
fn clause_4_5_3_2_welds_of_inclined_flanges() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let load = "{name: A, end: beam_right, at: bolt_plane, My: 60 kN m, Vz: -80 kN}";
    let e = of_ipe300(&plain(load), &catalog);
    let (r, alpha) = (e.rafter.as_deref().expect("a rafter"), 6f64.to_radians());
    let theta = r.haunch.as_ref().expect("a haunch").angle;
    let lever = r.depth - 0.5 * (10.7 / alpha.cos() + 10.7 / (alpha + theta).cos());
    let strength = |angle: f64| {
        let half = 0.5 * (std::f64::consts::FRAC_PI_2 - angle);
        let equivalent = (half.sin().powi(2) + 3.0 * half.cos().powi(2)).sqrt();
        6.0 * 360.0 / (equivalent * 0.8 * 1.25)
    };
    // ends return round the tips: two legs less; the haunch has no root fillets
    let ends = 2.0 * SQRT_2 * 6.0;
    for (part, angle, length) in [
        (Part::BeamFlange, alpha, 300.0 - 7.1 - 30.0 - ends),
        (Part::HaunchFlange, alpha + theta, 300.0 - 7.1 - ends),
    ] {
        let weld = find(&e, CheckId::WeldAcross, part).expect("a weld");
        let want = 60e6 / lever / angle.cos() / length / strength(angle);
        same("flange weld", weld.utilisation.unwrap_or(f64::NAN), want, &mut 0.0);
    }
    // a downward force and tension at the top: the inclined haunch flange relieves the web, which
    // keeps all of Vz; against the moment it adds M/z (tan(α + θ) − tan α)
    let shear = |e: &EndPlate| {
        find(e, CheckId::BeamShear, Part::HaunchedBeam).and_then(|c| c.demand).unwrap_or(f64::NAN)
    };
    same("V", shear(&e), 80e3, &mut 0.0);
    let lifted = of_ipe300(&plain(&load.replace("-80", "80")), &catalog);
    let added = 60e6 / lever * ((alpha + theta).tan() - alpha.tan());
    same("V", shear(&lifted), 80e3 + added, &mut 0.0);
}

/// Tension at the bottom pulls the web and bends the flange of the beam at the tip. The force is
/// `M/z_f sin θ/cos(α + θ)`; the web has `ω b_eff t_w f_y`, b_eff = t_h + 5 (t_f + r), the flange
/// `b_eff t_h f_y`, b_eff = t_w + 2 r + 7 t_f, no more than the flange is wide.
#[test]
fn clause_6_2_6_3_the_tip_of_a_haunch_in_tension() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let load = "{name: A, end: beam_right, at: bolt_plane, My: -60 kN m, Vz: 40 kN}";
    let e = of_ipe300(&plain(load), &catalog);
    let (r, alpha) = (e.rafter.as_deref().expect("a rafter"), 6f64.to_radians());
    let theta = r.haunch.as_ref().expect("a haunch").angle;
    let lever = r.depth - 0.5 * (10.7 / alpha.cos() + 10.7 / (alpha + theta).cos());
    let force = 60e6 / lever / (alpha + theta).cos() * theta.sin();
    let web = find(&e, CheckId::HaunchTipWeb, Part::HaunchTip).expect("a check");
    let width = 10.7 + 5.0 * 25.7;
    let area: f64 = 5381.0 - 2.0 * 150.0 * 10.7 + (7.1 + 30.0) * 10.7;
    let omega = 1.0 / (1.0 + 1.3 * (width * 7.1 / area) * (width * 7.1 / area)).sqrt();
    let resistance = omega * width * 7.1 * 235.0;
    assert!((web.demand.unwrap_or(f64::NAN) / force - 1.0).abs() < 1e-9, "{web:#?}");
    // the area of the table is rounded to 0.1 cm²
    assert!((web.resistance.unwrap_or(f64::NAN) / resistance - 1.0).abs() < 1e-3, "{web:#?}");
    let flange = find(&e, CheckId::HaunchTipFlange, Part::HaunchTip).expect("a check");
    let width = 7.1 + 2.0 * 15.0 + 7.0 * 10.7;
    let want = width * 10.7 * 235.0;
    same("flange", flange.resistance.unwrap_or(f64::NAN), want, &mut 0.0);
}

/// A flange at more than 30° to the normal of the plate has no fillet welds by 4.3.2.1; stiffeners
/// at the tip make its web stronger, and slender ones leave it undecided.
#[test]
fn steep_flanges_and_stiffeners_at_the_tip() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let load = "{name: A, end: beam_right, at: bolt_plane, My: 60 kN m, Vz: -80 kN}";
    let e = of_ipe300(&plain(load), &catalog);
    let changed = |change: &dyn Fn(&mut bracket_joint::assembly::Haunch)| {
        let mut other = e.clone();
        change(other.rafter.as_mut().and_then(|r| r.haunch.as_mut()).expect("a haunch"));
        other
    };
    let steep = changed(&|h| h.angle = 25f64.to_radians());
    let open = hand_checks(&steep).checks.into_iter().find(|c| c.id() == CheckId::InclinedFillet);
    assert_eq!(open.map(|c| c.status), Some(Status::Undecided));
    assert!(hand_checks(&e).checks.iter().all(|c| c.id() != CheckId::InclinedFillet));
    let of = |e: &EndPlate, part| find(e, CheckId::HaunchTipWeb, part);
    let bare = of(&e, Part::HaunchTip).and_then(|c| c.resistance).expect("a web");
    let stiff = changed(&|h| h.stiffener = 10.0);
    assert!(of(&stiff, Part::HaunchTip).and_then(|c| c.resistance).expect("a web") > bare);
    assert!(of(&stiff, Part::HaunchStiffener).is_none());
    let slender = of(&changed(&|h| h.stiffener = 5.0), Part::HaunchStiffener);
    assert_eq!(slender.map(|c| c.status), Some(Status::Undecided));
}
