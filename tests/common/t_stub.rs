//! Limit loads of T-stubs and the share of the dissipation in their bolts.

use super::limit::{run, strict};
use super::yielding::FY;
use bracket::analysis::limit::{LimitPass, SUBDIVISIONS};
use bracket::certify::limit_certificate::dissipation_densities;
use bracket::model::AnalysisModel;

/// Share of the dissipation in bodies whose name starts with BOLT.
fn bolt_share(m: &AnalysisModel, pass: &LimitPass) -> f64 {
    let d = dissipation_densities(m, pass.velocity.as_ref().unwrap(), SUBDIVISIONS);
    let all: Vec<f64> = d.iter().enumerate().map(|(e, d)| d * m.mesh.volume(e)).collect();
    let is_bolt = |e: usize| m.mesh.bodies[m.mesh.tet_body[e] as usize].starts_with("BOLT");
    let bolts: f64 = all.iter().enumerate().filter(|(e, _)| is_bolt(*e)).map(|(_, d)| d).sum();
    bolts / all.iter().sum::<f64>()
}

/// Both bounds of the force \[kN\] and the share of the dissipation in the bolts. The loads add up
/// to `force` \[N\] at load factor 1.
pub fn forces(title: &str, m: &AnalysisModel, force: f64) -> ([f64; 2], f64) {
    let start = std::time::Instant::now();
    let pass = run(m);
    println!("{title}: {:.0} s", start.elapsed().as_secs_f64());
    let f = strict(&format!("{title}, {} tets", m.mesh.tets.len()), m, &pass)
        .map(|f| f * FY * force * 1e-3);
    let share = bolt_share(m, &pass);
    println!(
        "{title}: [{:.1}, {:.1}] kN, bolts {:.1} % of the dissipation",
        f[0],
        f[1],
        100.0 * share
    );
    (f, share)
}
