//! Coulomb's law in limit analysis: compares the result of the fixed point with load factors in
//! closed form and with its bounds.

use super::random::assembly;
use crate::common::limit::run;
use crate::common::yielding::model;
use crate::common::{Block, solved};
use bracket::analysis::limit::CoulombEstimate;
use bracket::analysis::limit::LimitPass;
use bracket::elements::hencky_kinematic::Flow;
use bracket::model::AnalysisModel;
use bracket::model::FrictionLaw;
use bracket::programs::Kinematic;
use bracket::solve::{Patterns, SolveOptions, StopRules, condensed};

/// The model under Coulomb's law, with an estimate of its load factor.
fn under_coulomb(mut m: AnalysisModel) -> AnalysisModel {
    m.interfaces.iter_mut().for_each(|i| i.law.friction = FrictionLaw::Coulomb);
    m.ground.iter_mut().for_each(|g| g.law.friction = FrictionLaw::Coulomb);
    m.coulomb_estimate = true;
    m
}

/// λ_low(μ = 0), the estimate and λ_up(associated).
fn three(name: &str, m: &AnalysisModel) -> (LimitPass, [f64; 3]) {
    let pass = run(m);
    let CoulombEstimate { factor, run, iterations, trouble, .. } =
        pass.coulomb_estimate.clone().unwrap();
    let up = pass.upper.as_ref().unwrap().value();
    let low = pass.frictionless.as_ref().map_or(0.0, |l| l.value());
    println!(
        "{name}: {low:.6} ≤ {factor:?} ≤ {up:.6}, {iterations} iterations, {run:?}, {trouble:?}"
    );
    (pass.clone(), [low, factor.unwrap_or(f64::NAN), up])
}

/// A block in a groove is pulled along it. Dead pressures press it on the two walls.
///
/// ```text
///      \ ◇ /      N_x, N_y on the walls; drawn out of the page
///       \/
/// ```
///
/// The walls are at right angles. Without dilation the block slides along the groove, so all
/// friction acts along it and `H = μ (N_x + N_y)`. Associated slip leaves both walls. With the
/// velocity v along the groove the block leaves each wall by `u ≥ μ √(u² + v²)`, so
/// `H = μ/√(1 − μ²) (N_x + N_y)`, a quarter more at μ = 0.6.
fn groove(mu: f64, pressures: [f64; 2], material: &str, cells: [usize; 3]) -> AnalysisModel {
    let mesh = Block::new(cells, [10.0, 10.0, 30.0]).jittered(3).mesh(&["B"], |_| 0, |_, _| false);
    let [px, py] = pressures;
    under_coulomb(model(
        &format!(
            "bodies: {{B: {material}}}\nsupports:\n- {{face: X0, law: contact, mu: {mu:?}, \
             friction: coulomb}}\n- {{face: Y0, law: contact, mu: {mu:?}, friction: \
             coulomb}}\ndead:\n- {{face: X1, traction: [{:?}, 0, 0]}}\n- {{face: Y1, traction: \
             [0, {:?}, 0]}}\nloads:\n- {{face: Z1, traction: [0, 0, 1]}}\n",
            -px, -py
        ),
        mesh,
    ))
}

#[test]
fn block_in_a_groove() {
    for (mu, p, material, cells) in [
        (0.6, [1.0, 1.0], "r", [1, 1, 2]),
        (0.3, [1.0, 0.5], "r", [2, 2, 2]),
        (0.6, [1.0, 0.7], "s", [2, 2, 3]),
    ] {
        let name = format!("groove, μ {mu}, material {material}");
        let (_, [_, estimate, up]) = three(&name, &groove(mu, p, material, cells));
        // walls of 10 × 30, an end of 10 × 10
        let coulomb = mu * 3.0 * (p[0] + p[1]);
        let associated = coulomb / (1.0 - mu * mu).sqrt();
        assert!((up / associated - 1.0).abs() < 1e-3, "{name}: {up} against {associated}");
        assert!((estimate / coulomb - 1.0).abs() < 2e-3, "{name}: {estimate} against {coulomb}");
    }
}

/// A block on a plane is pushed under a dead pressure. The normal force is known, so `H = μ N`
/// holds with and without dilation.
#[test]
fn pushed_block() {
    let mesh =
        Block::new([2, 2, 1], [30.0, 20.0, 10.0]).jittered(5).mesh(&["B"], |_| 0, |_, _| false);
    let m = under_coulomb(model(
        "bodies: {B: s}\nsupports:\n- {face: Z0, law: contact, mu: 0.4, friction: \
         coulomb}\ndead:\n- {face: Z1, traction: [0, 0, -5]}\nloads:\n- {face: X0, traction: [1, \
         0, 0]}\n",
        mesh,
    ));
    let (_, [_, estimate, up]) = three("pushed block", &m);
    let exact = 0.4 * 5.0 * 600.0 / 200.0;
    assert!(
        (estimate / exact - 1.0).abs() < 2e-3 && (up / exact - 1.0).abs() < 1e-3,
        "{estimate} and {up}, {exact}"
    );
}

/// A block between two plates that cannot separate: associated slip must crush it, Coulomb slip
/// need not.
#[test]
fn wedged_block() {
    let mesh =
        Block::new([3, 2, 2], [30.0, 20.0, 20.0]).jittered(5).mesh(&["B"], |_| 0, |_, _| false);
    let m = under_coulomb(model(
        "bodies: {B: s}\nsupports:\n- {face: Z0, law: contact, mu: 0.4, friction: coulomb}\n- \
         {face: Z1, law: contact, mu: 0.4, friction: coulomb}\nloads:\n- {face: X0, traction: [1, \
         0, 0]}\n",
        mesh,
    ));
    let (pass, [low, estimate, up]) = three("wedged block", &m);
    assert!(pass.slides.is_some(), "friction alone holds it");
    assert!(low <= estimate && estimate < 0.999 * up, "{low} ≤ {estimate} ≤ {up}");
}

/// Stacks of two blocks: the estimate lies between its bounds.
fn stacks(seeds: std::ops::Range<u64>) {
    let count = seeds.end - seeds.start;
    let (mut found, mut apart, mut not_reached) = (0_u64, 0, Vec::new());
    for seed in seeds {
        let Some(m) = assembly(seed).map(under_coulomb).filter(AnalysisModel::has_coulomb_friction)
        else {
            continue;
        };
        let pass = run(&m);
        let Some(estimate) = &pass.coulomb_estimate else { continue };
        let Some(factor) = estimate.factor else {
            not_reached.push(format!("seed {seed}: {estimate:?}"));
            continue;
        };
        let low = pass.frictionless.as_ref().map_or(0.0, |l| l.value());
        let up = pass.upper.as_ref().unwrap().value();
        let raw = estimate.raw.unwrap();
        // the program with associated friction itself: its result bounds that of the fixed point on
        // the same mesh
        let kinematic = Kinematic::limit(&m, Flow::Split).unwrap();
        let prepared = condensed::Prepared::new(
            &kinematic.program,
            &kinematic.map.block,
            &Patterns::default(),
        );
        let associated =
            prepared.unwrap().solve(&SolveOptions::default().with(StopRules::to_gap(1e-7)));
        assert!(associated.status.is_solution(), "seed {seed}");
        let most = *associated.x.last().unwrap();
        println!(
            "seed {seed}: {low:.5} ≤ {factor:.5} (raw {raw:.5} ≤ {most:.5}) ≤ {up:.5}, \
             {estimate:?}"
        );
        assert!(low <= factor && factor <= up, "seed {seed}: {low} {factor} {up}");
        assert!(
            low * (1.0 - 1e-3) <= raw && raw <= most * (1.0 + 1e-3),
            "seed {seed}: {low} {raw} {most}"
        );
        assert!(estimate.run.solves <= 10, "seed {seed}");
        found += 1;
        apart += usize::from(factor < 0.99 * up);
    }
    println!(
        "{found} estimates, {apart} of them more than 1 % below the upper bound; not reached: \
         {not_reached:#?}"
    );
    assert!(3 * found >= count && not_reached.len() as u64 * 10 <= found, "{not_reached:#?}");
}

#[test]
fn random_stacks() {
    stacks(0..30);
}

#[test]
#[ignore = "heavy: a minute"]
fn more_random_stacks() {
    stacks(30..90);
}

/// An estimate is computed only on request, and only for limit analysis under Coulomb's law.
#[test]
fn nothing_is_estimated_unasked() {
    let m = AnalysisModel { coulomb_estimate: false, ..groove(0.6, [1.0, 1.0], "r", [1, 1, 2]) };
    assert!(run(&m).coulomb_estimate.is_none());
    let mesh = || Block::new([2, 1, 1], [30.0, 10.0, 10.0]).mesh(&["B"], |_| 0, |_, _| false);
    let text = |friction: &str| {
        format!(
            "materials: {{s: {{E: 210000, nu: 0.3, fy: 235}}}}\ncoulomb_estimate: true\nbodies: \
             {{B: s}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\n- {{face: Z0, law: contact, \
             {friction}}}\nloads:\n- {{face: X1, traction: [0, 0, 1]}}\n"
        )
    };
    for (kind, friction, wants) in [
        ("limit", "mu: 0.3, friction: coulomb", None),
        ("elastic", "mu: 0.3, friction: coulomb", Some("`analysis: elastic`")),
        ("elastoplastic", "mu: 0.3, friction: coulomb", Some("`analysis: elastoplastic`")),
        ("limit", "mu: 0.3, friction: associated", Some("no contact has `friction: coulomb`")),
        ("limit", "mu: 0", Some("no contact has `friction: coulomb`")),
    ] {
        match (solved::resolve_as(kind, &text(friction), mesh()), wants) {
            (Ok(m), None) => assert!(m.coulomb_estimate),
            (Err(e), Some(words)) => {
                assert_eq!(e.iter().len(), 1, "{e:?}");
                assert!(e.first().message.contains(words), "{e:?}");
            }
            (other, _) => panic!("{kind}, {friction}: {:?}", other.map(|m| m.analysis)),
        }
    }
}
