//! B12 with a sleeve that yields: an elastic, preloaded bolt (area 1) clamps a sleeve (area 4).
//!
//! ```text
//!        F (±)                    both tops follow one rigid plate, free along z only
//!    =============  rigid
//!    [s] [b] [s]                  bolt held to the ground, sleeve only standing on it
//!    ///-///-///                  ν = 0: prisms of constant stress
//! ```
//! The elastic tightening gives the closure δ = F_p (L/E)(1 + 1/4). Under F the top moves by u, the
//! bolt carries T = k_b (u + δ), and the sleeve N = k_s min(u, 0), no more than its yield force in
//! compression: T = F − N. `Π(u) = ½ k_b (u + δ)² + W(u) − F u` with the energy W of the sleeve,
//! whose plastic part is the dissipation f_y A |u_p|.
//!
//! The energies are compared for the closure of the pass, which is that of the solver to 1e-7.
//! Tolerance 1e-6 relative as in the other elastic, perfectly plastic cases; forces 1e-5 F_p.

use crate::common::bolt_in_sleeve::{L, mesh};
use crate::common::plastic::strict_pass;
use crate::common::solved::resolve_as;
use bracket::analysis::energy_pass::EnergyPass;
use bracket::analysis::event::silent;
use bracket::analysis::pass::PassOptions;
use bracket::analysis::{elastic, hencky};
use bracket::certify::plastic_certificate::{body_states, certify_plastic_motion};
use bracket::model::{AnalysisKind, AnalysisModel};

const E: f64 = 200_000.0;
const FP: f64 = 800.0;
const KB: f64 = E / L;
/// Yield strength of the sleeve: 1.5 times its stress after tightening \[MPa\].
const FY: f64 = 300.0;
/// Area of the sleeve over that of the bolt.
const SLEEVE: f64 = 4.0;

/// The model of `share` of the structure under `force` on the whole of it; the yield strength `fy`
/// is that of the sleeve.
fn model(share: f64, force: f64, preload: Option<f64>, fy: f64, seed: u64) -> AnalysisModel {
    let (live, copies) = (share * force, (1.0 / share) as u32);
    // the axis may point either way
    let axis = if seed.is_multiple_of(2) { "[0, 0, 1]" } else { "[0, 0, -1]" };
    let bolts = preload.map_or(String::new(), |f| {
        let f = share * f;
        format!("preload:\n- {{body: BOLT, cut: CUT, axis: {axis}, force: {f:?}}}\n")
    });
    let yaml = format!(
        "symmetry: {copies}\nmaterials: {{e: {{E: 200000, nu: 0}}, y: {{E: 200000, nu: 0, fy: \
         {fy:?}}}}}\nbodies: {{BOLT: e, SLEEVE: y}}\nsupports:\n- {{face: BOLT_END, fix: [z]}}\n- \
         {{face: SLEEVE_END, law: contact, mu: 0}}\n- {{face: BX, fix: [x]}}\n- {{face: SX, fix: \
         [x]}}\n- {{face: Y0, fix: [y]}}\nrigid:\n- {{face: Z1, components: [z], free: [uz], \
         force: [0, 0, {live:?}]}}\n{bolts}"
    );
    resolve_as("elastoplastic", &yaml, mesh(share, seed)).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The pass, and its model with the closures of the pass.
fn run(mut model: AnalysisModel) -> (AnalysisModel, EnergyPass) {
    let pass = hencky::run(&model, &PassOptions::default(), &silent()).unwrap();
    close(&mut model, &pass);
    (model, pass)
}

fn close(model: &mut AnalysisModel, pass: &EnergyPass) {
    model.preload.iter_mut().zip(&pass.preload).for_each(|(p, t)| p.closure = Some(t.closure));
}

/// Energy and tension of the whole bolt under `force` with this closure of its cut.
fn closed_form(force: f64, closure: f64) -> [f64; 2] {
    let (ks, most) = (SLEEVE * KB, FY * SLEEVE);
    let elastic = (force - KB * closure) / (KB + ks);
    // open, elastic, or at its yield force
    let u = if elastic > 0.0 {
        force / KB - closure
    } else if -ks * elastic <= most {
        elastic
    } else {
        (force + most) / KB - closure
    };
    let sleeve = match -ks * u {
        n if n <= 0.0 => 0.0,
        n if n <= most => 0.5 * ks * u * u,
        n => 0.5 * most * most / ks + most * (n - most) / ks,
    };
    [0.5 * KB * (u + closure).powi(2) + sleeve - force * u, KB * (u + closure)]
}

#[test]
fn the_bolt_takes_a_fifth_of_a_pull_and_the_sleeve_yields_under_a_push() {
    for (share, seed) in [(1.0, 1), (1.0, 8), (0.5, 42)] {
        // −2 F_p: the sleeve would carry 2240 N of the 1200 N at which it yields
        for factor in [0.0, 0.5, 1.2, 1.3, 2.0, -0.4, -1.0, -2.0] {
            let force = factor * FP;
            let name = format!("share {share}, F = {factor} F_p");
            let (model, pass) = run(model(share, force, Some(FP), FY, seed));
            let bolt = &pass.preload[0];
            assert!((bolt.closure * KB / (1.25 * FP) - 1.0).abs() < 1e-7, "{name}: {bolt:?}");
            let [energy, tension] = closed_form(force, bolt.closure);
            let scale = energy.abs().max(0.5 * FP * FP / KB);
            let [low, up] = strict_pass(&name, &model, &pass);
            for bound in [low, up] {
                assert!((bound - energy).abs() < 1e-6 * scale, "{name}: {bound} of {energy}");
            }
            let rounding = 1e-11 * scale;
            assert!(low <= energy + rounding && up >= energy - rounding, "{name}");
            let found = bolt.tension.unwrap() / share;
            assert!((found - tension).abs() < 1e-5 * FP, "{name}: {found} against {tension}");
            let sleeve = body_states(&model, pass.plastic.as_ref(), None)[1].unwrap();
            let flowing = f64::from(u8::from(factor <= -1.0));
            assert!((sleeve.flowing - flowing).abs() < 1e-9, "{name}: {sleeve:?}");
        }
    }
}

/// Where nothing reaches yield, the elastic analysis has the same energy; so has a bolt of hardly
/// any preload beside one of none.
#[test]
fn far_below_yield_it_is_the_elastic_analysis_and_without_preload_the_plain_one() {
    for force in [400.0, -900.0, 1700.0] {
        let strong = model(1.0, force, Some(FP), 1e5, 3);
        let elastic = AnalysisModel { analysis: AnalysisKind::Elastic, ..strong.clone() };
        let linear = elastic::run(&elastic, &PassOptions::default(), &silent()).unwrap();
        let (closed, pass) = run(strong);
        let bounds = strict_pass("strong", &closed, &pass);
        let b = linear.bracket.as_ref().unwrap();
        for (found, want) in bounds.into_iter().zip([b.lower().value(), b.upper().value()]) {
            assert!((found - want).abs() < 1e-7 * want.abs(), "{force}: {found} against {want}");
        }
        assert_eq!(pass.preload[0].closure, linear.preload[0].closure, "{force}");

        let [none, hardly] = [None, Some(1e-6)].map(|preload| {
            let (closed, pass) = run(model(1.0, force, preload, FY, 3));
            strict_pass("hardly any preload", &closed, &pass)
        });
        for (a, b) in none.into_iter().zip(hardly) {
            assert!((a - b).abs() < 1e-6 * a.abs(), "{force}: {a} against {b}");
        }
    }
}

/// The fields of one closure are not admissible for another: no bound of a forged closure is
/// strict.
#[test]
fn the_fields_of_one_closure_prove_nothing_for_another() {
    let (mut model, pass) = run(model(1.0, -2.0 * FP, Some(FP), FY, 1));
    let field = pass.plastic.as_ref().unwrap();
    assert!(certify_plastic_motion(&model, field).compatibility < 1e-12);
    model.preload[0].closure = model.preload[0].closure.map(|c| 1.001 * c);
    assert!(certify_plastic_motion(&model, field).compatibility > 1e-5);
}
