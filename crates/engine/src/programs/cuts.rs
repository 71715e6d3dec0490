//! Cuts: the points on side B follow those on side A, displaced by the closures of preloaded bolts
//! or by the motions of resultant limits.
//!
//! While nothing else moves, a prescribed closure strains only the elements at the cut. Their
//! energy is then that of the whole joint times the ratio of shank length to element length, and a
//! solver that starts there stalls. Therefore solvers measure the unknowns from a displacement that
//! spreads the closure along the body of the bolt.

use crate::model::ModelError;
use crate::model::analysis::{AnalysisModel, FacePair};
use crate::programs::conic::{Cone, ConicProgram};
use crate::programs::constraints::FacePoints;
use crate::programs::dofs::DofMap;
use bracket_base::math::vec3::{self, V3};
use std::collections::{BTreeMap, BTreeSet};

/// Components of an axis below this are zero.
const ACROSS: f64 = 1e-9;

/// Points on side B of the cuts, each with its cut and the point on side A that it follows. The
/// cuts of preloaded bolts come first, then those whose resultants are limited.
pub type Followers = BTreeMap<usize, (usize, usize)>;

/// A cut: its name, its faces and the direction in which preload draws its sides together.
struct Faces<'a> {
    name: &'a str,
    faces: &'a [FacePair],
    drawn: Option<V3>,
}

fn cuts(model: &AnalysisModel) -> impl Iterator<Item = Faces<'_>> {
    let preloaded = model.preload.iter().map(|bolt| Faces {
        name: &bolt.cut,
        faces: &bolt.faces,
        drawn: Some(bolt.axis),
    });
    let limited =
        model.cuts.iter().map(|cut| Faces { name: &cut.name, faces: &cut.faces, drawn: None });
    preloaded.chain(limited)
}

/// The points on side B that follow points on side A. Components held on one side are held on the
/// other. An error where this would fix the closure, or where the points also belong to a rigid
/// face, a weld, a tie or another cut.
pub fn followers(
    model: &AnalysisModel,
    points: &impl FacePoints,
    fixed: &mut [[bool; 3]],
    moved: impl Fn(usize) -> bool,
    tied: impl Fn(usize) -> bool,
) -> Result<Followers, ModelError> {
    let mut out = Followers::new();
    let mut leaders: BTreeMap<usize, usize> = BTreeMap::new();
    let welds = model.welds.iter().flat_map(|w| &w.faces);
    let welded: BTreeSet<usize> = match cuts(model).all(|cut| cut.faces.is_empty()) {
        true => BTreeSet::new(),
        false => welds.flat_map(|f| points.pairs(f)).flatten().collect(),
    };
    for (i, cut) in cuts(model).enumerate() {
        let held = |holder| ModelError::CutHeld { holder, cut: cut.name.to_owned() };
        for [a, b] in cut.faces.iter().flat_map(|f| points.pairs(f)) {
            let other = |taken: Option<(usize, usize)>| taken.is_some_and(|t| t != (i, a));
            if other(out.insert(b, (i, a))) || leaders.insert(a, i).is_some_and(|j| j != i) {
                return Err(held("another cut"));
            }
            if moved(a) || moved(b) {
                return Err(held("a rigid face"));
            }
            if welded.contains(&b) {
                return Err(held("a weld"));
            }
            if tied(a) || tied(b) {
                return Err(held("a tie"));
            }
            for d in 0..3 {
                let both = fixed[a][d] || fixed[b][d];
                if both && cut.drawn.is_some_and(|axis| axis[d].abs() > ACROSS) {
                    return Err(held("a support"));
                }
                (fixed[a][d], fixed[b][d]) = (both, both);
            }
        }
    }
    let leads = |cut: &Faces<'_>| {
        let mut far = cut.faces.iter().flat_map(|f| points.pairs(f)).map(|[_, b]| b);
        far.any(|b| leaders.contains_key(&b))
    };
    match cuts(model).find(leads) {
        Some(cut) => Err(ModelError::CutHeld { holder: "another cut", cut: cut.name.to_owned() }),
        None => Ok(out),
    }
}

/// Sets the combinations of the followers. At the cut of a preloaded bolt `u_B = u_A − δ a`; the
/// closures δ are the unknowns from `closures` on, one for each bolt. At a cut whose resultant is
/// limited `u_B = u_A + δ`, δ by the motions of the limits, which are the unknowns from `motions`
/// on; without `motions` the cut stays closed.
pub fn follow(
    model: &AnalysisModel,
    followers: &Followers,
    [closures, motions]: [Option<usize>; 2],
    combinations: &mut [Vec<(u32, f64)>],
) {
    let jumps = jumps(model, motions);
    for (&b, &(cut, a)) in followers {
        for d in 0..3 {
            let mut terms = combinations[3 * a + d].clone();
            match (model.preload.get(cut), closures) {
                (Some(bolt), Some(first)) if bolt.axis[d].abs() > ACROSS => {
                    terms.push(((first + cut) as u32, -bolt.axis[d]));
                }
                (Some(_), _) => {}
                (None, _) => {
                    let of_motion = |(k, row): &(usize, V3)| (*k as u32, row[d]);
                    let jump = jumps[cut - model.preload.len()].iter().map(of_motion);
                    terms.extend(jump.filter(|(_, w)| *w != 0.0));
                }
            }
            combinations[3 * b + d] = terms;
        }
    }
}

/// The jump of each cut whose resultant is limited: unknowns of motions, each with the jump at its
/// unit value. The motions are the unknowns from `first` on, limit by limit.
fn jumps(model: &AnalysisModel, first: Option<usize>) -> Vec<Vec<(usize, V3)>> {
    let mut out = vec![Vec::new(); model.cuts.len()];
    let Some(mut next) = first else { return out };
    for limit in &model.resultant_limits {
        for row in limit.rows() {
            for &(cut, sign) in &limit.cuts {
                out[cut].push((next, vec3::scale(sign, *row)));
            }
            next += 1;
        }
    }
    out
}

/// Appends the motions of resultant limits to a program: their costs, and the cones `s ≥ ‖y‖`.
pub fn append_limits(model: &AnalysisModel, map: &DofMap, program: &mut ConicProgram) {
    if map.motions == 0 {
        return;
    }
    let mut next = map.limit_motions().start;
    for limit in &model.resultant_limits {
        program.q[next] += limit.at_most;
        let mine = next..next + limit.motions();
        // an s without `along` moves nothing and has no stiffness of its own
        if let Some(scales) = program.stiffness.get_mut(mine.clone()) {
            let largest = scales.iter().fold(0.0, |m: f64, s| m.max(*s));
            scales.iter_mut().filter(|s| **s == 0.0).for_each(|s| *s = largest);
        }
        for k in mine {
            program.g.push_row(&[(k as u32, 1.0)]);
            program.h.push(0.0);
        }
        program.cones.push(match limit.motions() {
            1 => Cone::NonNegative,
            n => Cone::SecondOrder(n),
        });
        next += limit.motions();
    }
}

/// Adds the forces of the preloads on their closures \[N\]; prescribed closures have none.
pub fn add_preload(model: &AnalysisModel, map: &DofMap, f: &mut [f64]) {
    let end = map.limit_motions().start;
    let closures = end - map.closures..end;
    for (k, bolt) in closures.zip(&model.preload).filter(|(_, bolt)| bolt.closure.is_none()) {
        f[k] += bolt.force;
    }
}

/// Unknowns of a displacement that closes the frozen cuts: each closure is spread linearly over the
/// body of its bolt, half of it on either side of the cut. Full unknowns `3 i + d` are
/// displacements of `points[i]`, each given with one of its tets. Empty without frozen cuts.
pub fn spread(
    model: &AnalysisModel,
    map: &DofMap,
    points: impl Iterator<Item = (usize, V3)>,
) -> Vec<f64> {
    if map.frozen.is_empty() {
        return Vec::new();
    }
    let mesh = &model.mesh;
    let mut x = vec![0.0; map.n];
    map.keep_frozen(&mut x);
    // of each bolt: body, axis, closure, and the positions of its start, cut and end along the axis
    let bolts: Vec<(u32, V3, f64, [f64; 3])> = model
        .preload
        .iter()
        .filter_map(|bolt| {
            let (closure, first) = (bolt.closure?, bolt.faces.first()?);
            let body = mesh.tet_body[first.a.tet as usize];
            let along = |n: &u32| vec3::dot(bolt.axis, mesh.nodes[*n as usize]);
            let nodes = mesh
                .tets
                .iter()
                .zip(&mesh.tet_body)
                .filter(|(_, b)| **b == body)
                .flat_map(|(t, _)| t);
            let (low, high) = nodes.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), n| {
                (l.min(along(n)), h.max(along(n)))
            });
            let rim: Vec<f64> =
                bolt.faces.iter().flat_map(|f| f.nodes_a.iter().map(along)).collect();
            Some((
                body,
                bolt.axis,
                closure,
                [low, rim.iter().sum::<f64>() / rim.len() as f64, high],
            ))
        })
        .collect();
    for (i, (tet, at)) in points.enumerate() {
        for (_, axis, closure, [low, cut, high]) in
            bolts.iter().filter(|b| b.0 == mesh.tet_body[tet])
        {
            let xi = vec3::dot(*axis, at);
            let centre = mesh.corners(tet).iter().map(|x| vec3::dot(*axis, *x)).sum::<f64>() / 4.0;
            let part = if centre < *cut {
                0.5 * (xi - low) / (cut - low)
            } else {
                -0.5 * (high - xi) / (high - cut)
            };
            for d in 0..3 {
                if let Some(k) = map.own(3 * i + d) {
                    x[k] += closure * part * axis[d];
                }
            }
        }
    }
    x
}
