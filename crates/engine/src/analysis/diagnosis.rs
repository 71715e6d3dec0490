//! Certificates of the solver as sentences: the parts that move away, the contacts that exclude
//! each other.

use crate::mesh::quality;
use crate::model::AnalysisModel;
use crate::programs::conic::{ConicProgram, cone_margin};
use bracket_base::say;
use bracket_base::words::Text;

/// A part or contact is named where its motion or multiplier reaches this fraction of the largest.
const NAMED: f64 = 0.05;

/// Largest `Gᵀ z` of a certificate, over the size of its terms. Solvers measure it against unknowns
/// that grow without limit in an infeasible program, so it is larger than rounding: accurate enough
/// to name the contacts, not to prove infeasibility.
const VANISHES: f64 = 1e-2;

/// Tets more than this many times as long as thick are named where a solver fails.
const LONG: f64 = 30.0;
/// Largest number of tets named.
const MOST_TETS: usize = 3;

/// The tets whose shape can explain why a solver ended without a solution: the longest ones.
/// `None` when no tet is long.
pub fn long_tets(model: &AnalysisModel) -> Option<Text> {
    let long = quality::long_tets(&model.mesh, LONG);
    let named = long.iter().take(MOST_TETS).map(|e| quality::tet_words(&model.mesh, *e));
    let worst = Text::joined("; ", named);
    match long.len() {
        0 => None,
        n if n <= MOST_TETS => Some(say!("long tets can be the cause: {}", worst)),
        n => Some(say!(
            "long tets can be the cause, {} of them are more than {} times as long as thick; the \
             longest: {}",
            n,
            LONG.to_string(),
            worst
        )),
    }
}

/// The bodies that flow along an unbounded direction of an elastic, perfectly plastic program;
/// `flow`: dissipation of each body. `None`: nothing flows.
pub fn plastic_flow(model: &AnalysisModel, flow: &[f64]) -> Option<Text> {
    let total: f64 = flow.iter().sum();
    let mut bodies: Vec<(f64, &String)> =
        flow.iter().map(|f| f / total).zip(&model.mesh.bodies).filter(|b| b.0 > NAMED).collect();
    bodies.sort_by(|a, b| b.0.total_cmp(&a.0));
    let of = |(share, name): &(f64, &String)| {
        say!("`{}` ({} % of the dissipation)", *name, format!("{:.0}", 100.0 * share))
    };
    let named: Vec<Text> = bodies.iter().map(of).collect();
    match &named[..] {
        [] => None,
        [one] => Some(say!("body {} yields without end", one)),
        [first @ .., last] => {
            let first = Text::joined(", ", first.to_vec());
            Some(say!("bodies {} and {} yield without end", first, last))
        }
    }
}

/// Name of a contact with the parts that it joins. `contact` counts interfaces first, then contacts
/// with the ground.
fn contact_name(model: &AnalysisModel, contact: usize) -> Text {
    let part = |tet: u32| &model.parts[model.tet_part[tet as usize] as usize];
    if let Some(i) = model.interfaces.get(contact) {
        let Some(f) = i.faces.first() else { return say!("`{}`", &i.name) };
        let (a, b) = (part(f.a.tet), part(f.b.tet));
        return if a == b {
            say!("`{}` (part {} against itself)", &i.name, a)
        } else {
            say!("`{}` (part {} against part {})", &i.name, a, b)
        };
    }
    let Some(g) = model.ground.get(contact - model.interfaces.len()) else {
        return say!("contact {}", contact + 1);
    };
    match g.faces.first() {
        Some(f) => say!("`{}` (part {} against the ground)", &g.name, part(f.tet)),
        None => say!("`{}`", &g.name),
    }
}

/// The contacts that no motion satisfies together, from the certificate `z` of an infeasible
/// program: `z ∈ K`, `Gᵀ z ≈ 0` and `hᵀ z < 0`, so that `zᵀ (G x + h) < 0` for every x
/// that is not huge. `None` when z is not such a certificate.
///
/// `contacts`: index of the contact that each cone belongs to.
pub fn conflict(
    model: &AnalysisModel,
    program: &ConicProgram,
    contacts: &[usize],
    z: &[f64],
) -> Option<Text> {
    if z.len() != program.h.len() || z.iter().any(|z| !z.is_finite()) {
        return None;
    }
    // the multipliers of yield points come behind; they exclude no motion
    let rows = program.g.nrows();
    let (z, h) = (&z[..rows], &program.h[..rows]);
    let largest = |v: &[f64]| v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let left = largest(&program.g.mul_transpose(z));
    let mut terms = program.g.clone();
    terms.values.iter_mut().for_each(|v| *v = v.abs());
    let terms = largest(&terms.mul_transpose(&z.iter().map(|z| z.abs()).collect::<Vec<_>>()));
    let work: f64 = h.iter().zip(z).map(|(h, z)| h * z).sum();
    let size = largest(z);
    // share of each contact: sum of the normal components of its multipliers, the largest
    // components because z ∈ K
    let mut share = vec![0.0; model.interfaces.len() + model.ground.len()];
    let mut worst = f64::INFINITY;
    for ((start, cone), &contact) in
        program.cone_starts().into_iter().zip(&program.cones).zip(contacts)
    {
        worst = worst.min(cone_margin(&z[start..start + cone.dim()]));
        *share.get_mut(contact)? += z[start].max(0.0);
    }
    if left > VANISHES * terms || work >= 0.0 || worst < -VANISHES * size {
        return None;
    }
    let most = largest(&share);
    let names: Vec<Text> = (0..share.len())
        .filter(|&c| share[c] > NAMED * most)
        .map(|c| contact_name(model, c))
        .collect();
    match &names[..] {
        [] => None,
        [one] => Some(say!(
            "the solver found no displacement on this mesh that satisfies the contact {} \
             everywhere",
            one
        )),
        [first @ .., last] => Some(say!(
            "the solver found no displacement on this mesh that satisfies the contacts {} and {} \
             together",
            Text::joined(", ", first.to_vec()),
            last
        )),
    }
}
