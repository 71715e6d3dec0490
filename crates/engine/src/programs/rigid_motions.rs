//! Rigid motions: of rigid faces and, in limit analysis, of bodies without a yield strength.
//!
//! Rigid faces and rigid bodies that share points of a program must have equal displacements there,
//! and their components held by supports are zero. The common motions of such a group are the null
//! space of these conditions; each of them is one unknown of the program.

use crate::mesh::numbering::FaceNumbering;
use crate::model::ModelError;
use crate::model::analysis::{AnalysisModel, Preload};
use crate::model::loads::Loads;
use crate::model::resultant_limit::ResultantLimit;
use crate::programs::constraints::FacePoints;
use crate::programs::cuts;
use crate::programs::dofs::DofMap;
use crate::programs::slip_face::{HeldPoints, SlipFace};
use crate::programs::tied_points::TiedPoints;
use bracket_base::math::dense::{Mat, null_space, pseudo_solve};
use bracket_base::math::rigid_motion::rigid_displacement;
use bracket_base::math::vec3::{self, V3};
use std::collections::BTreeMap;

/// Displacements of unit motions below this are rounding of the null space and count as zero.
const AT_REST: f64 = 1e-14;

/// Motions of a group of rigid faces and bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidMotions {
    /// First unknown.
    pub first: usize,
    /// Number of unknowns.
    pub count: usize,
    /// The rigid faces of the group: position in the model, and the motion
    /// `[ux, uy, uz, rx, ry, rz]` about the face's own reference point for each unknown at unit
    /// value.
    pub faces: Vec<(usize, Vec<[f64; 6]>)>,
}

/// Connected pieces of the bodies that never yield (joined through faces); each moves as a rigid
/// body.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RigidPieces {
    /// Piece of each tet; empty: no body is rigid.
    of_tet: Vec<Option<usize>>,
    /// Number of pieces.
    count: usize,
}

impl RigidPieces {
    /// The pieces of the bodies without a yield strength.
    pub fn unyielding(model: &AnalysisModel) -> Self {
        let radii = model.yield_radii();
        if radii.iter().all(Option::is_some) {
            return Self::default();
        }
        let mesh = &model.mesh;
        let rigid = |e: usize| radii[mesh.tet_body[e] as usize].is_none();
        let faces = FaceNumbering::new(mesh);
        let mut out = Self { of_tet: vec![None; mesh.tets.len()], count: 0 };
        for seed in 0..mesh.tets.len() {
            if !rigid(seed) || out.of_tet[seed].is_some() {
                continue;
            }
            let mut front = vec![seed];
            out.of_tet[seed] = Some(out.count);
            while let Some(e) = front.pop() {
                for face in faces.of_tet[e] {
                    let (a, b) = faces.tets[face as usize];
                    for next in [Some(a), b].into_iter().flatten().map(|t| t as usize) {
                        if rigid(next) && out.of_tet[next].is_none() {
                            out.of_tet[next] = Some(out.count);
                            front.push(next);
                        }
                    }
                }
            }
            out.count += 1;
        }
        out
    }

    /// True when the tet belongs to a rigid piece.
    pub fn contains(&self, tet: usize) -> bool {
        self.of_tet.get(tet).is_some_and(Option::is_some)
    }

    /// True when there is no rigid piece.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }
}

/// A rigid face or piece: a reference point, and its free motions without the others. Rotations are
/// scaled so that the largest displacement equals that of a unit translation.
struct Mover {
    at: V3,
    motions: Vec<[f64; 6]>,
}

impl Mover {
    fn new(at: V3, free: [bool; 6], points: impl Iterator<Item = V3>) -> Self {
        let reach = points.map(|x| vec3::norm(vec3::sub(x, at))).fold(0.0, f64::max).max(1e-12);
        let unit = |m: usize| {
            let mut v = [0.0; 6];
            v[m] = if m < 3 { 1.0 } else { 1.0 / reach };
            v
        };
        Self { at, motions: (0..6).filter(|&m| free[m]).map(unit).collect() }
    }

    /// Displacement component `d` at `x` in each of its motions.
    fn row(&self, x: V3, d: usize) -> Vec<f64> {
        self.motions.iter().map(|m| rigid_displacement(m, self.at, x)[d]).collect()
    }
}

/// Movers of each component of a point: rigid faces by their position in the model, then pieces.
type Claims = BTreeMap<(usize, usize), Vec<usize>>;
/// One entry of [`Claims`].
type Claim<'a> = ((usize, usize), &'a [usize]);

fn claims(
    model: &AnalysisModel,
    points: &impl FacePoints,
    pieces: &RigidPieces,
    tied: &TiedPoints,
) -> Result<Claims, ModelError> {
    let mut claims = Claims::new();
    for (r, rigid) in model.rigid.iter().enumerate() {
        for p in rigid.faces.iter().flat_map(|f| points.points(f)) {
            for d in (0..3).filter(|&d| rigid.components[d]) {
                let owners = claims.entry((tied.first(p, d), d)).or_default();
                if let Some(other) = owners.iter().find(|o| **o != r) {
                    return Err(ModelError::RigidFacesTouch(
                        model.rigid[*other].name.clone(),
                        rigid.name.clone(),
                        ["x", "y", "z"][d],
                    ));
                }
                if owners.is_empty() {
                    owners.push(r);
                }
            }
        }
    }
    for (e, piece) in pieces.of_tet.iter().enumerate() {
        let Some(piece) = piece.map(|p| model.rigid.len() + p) else { continue };
        for p in points.tet_points(e) {
            for d in 0..3 {
                let owners = claims.entry((tied.first(p, d), d)).or_default();
                if !owners.contains(&piece) {
                    owners.push(piece);
                }
            }
        }
    }
    Ok(claims)
}

/// The rigid faces and pieces, in the order of [`Claims`].
fn movers(
    model: &AnalysisModel,
    points: &impl FacePoints,
    pieces: &RigidPieces,
    claims: &Claims,
) -> Vec<Mover> {
    let mut mine: Vec<Vec<V3>> = vec![Vec::new(); model.rigid.len() + pieces.count];
    for ((p, _), owners) in claims {
        owners.iter().for_each(|&o| mine[o].push(points.position(*p)));
    }
    mine.into_iter()
        .enumerate()
        .map(|(o, mine)| match model.rigid.get(o) {
            Some(r) => Mover::new(r.at, r.free, mine.into_iter()),
            None => {
                let sum = mine.iter().fold([0.0; 3], |s, x| vec3::add(s, *x));
                let centre = vec3::scale(1.0 / mine.len().max(1) as f64, sum);
                Mover::new(centre, [true; 6], mine.into_iter())
            }
        })
        .collect()
}

/// Numbers the unknowns of a program: three per point, less the held ones, plus the motions of
/// rigid faces and pieces, plus the closures of preloaded cuts, plus the motions of resultant
/// limits if there are `limits`. Supports hold only the normal direction of `slips`; `tied` points
/// share unknowns.
pub fn number_unknowns(
    model: &AnalysisModel,
    points: &impl FacePoints,
    pieces: &RigidPieces,
    slips: &[SlipFace],
    tied: &TiedPoints,
    limits: bool,
) -> Result<(DofMap, Vec<RigidMotions>), ModelError> {
    let claims = claims(model, points, pieces, tied)?;
    let moved = |p| (0..3).any(|d| claims.contains_key(&(tied.first(p, d), d)));
    let glued = |p| moved(p) || tied.contains(p);
    let HeldPoints { mut fixed, oblique } = HeldPoints::new(model, points, slips, glued);
    for p in (0..points.count()).filter(|p| tied.contains(*p)) {
        (0..3).for_each(|d| fixed[tied.first(p, d)][d] |= fixed[p][d]);
    }
    let followers = cuts::followers(model, points, &mut fixed, moved, |p| tied.contains(p))?;
    let mut combinations: Vec<Vec<(u32, f64)>> = vec![Vec::new(); 3 * points.count()];
    let mut block = Vec::new();
    for p in (0..points.count()).filter(|p| !followers.contains_key(p)) {
        let oblique = oblique.get(&p);
        for d in (0..3).filter(|&d| tied.first(p, d) == p) {
            let free = !fixed[p][d] && !claims.contains_key(&(p, d));
            if free && oblique.is_none_or(|v| v[d][d] == 1.0) {
                let k = block.len() as u32;
                block.push(points.block(p));
                for i in 0..3 {
                    let w = oblique.map_or(if i == d { 1.0 } else { 0.0 }, |v| v[i][d]);
                    if w != 0.0 {
                        combinations[3 * p + i].push((k, w));
                    }
                }
            }
        }
    }
    let plain = block.len();
    let rigid_block = (0..points.count()).map(|p| points.block(p) + 1).max().unwrap_or(0);
    let movers = movers(model, points, pieces, &claims);
    let group_of = groups(movers.len(), &claims);
    let groups = group_of.iter().map(|g| g + 1).max().unwrap_or(0);
    let mut of_group: Vec<Vec<Claim<'_>>> = vec![Vec::new(); groups];
    claims.iter().for_each(|(at, owners)| of_group[group_of[owners[0]]].push((*at, owners)));
    let mut out = Vec::with_capacity(groups);
    for (g, claims) in of_group.iter().enumerate() {
        let members: Vec<usize> = (0..movers.len()).filter(|&o| group_of[o] == g).collect();
        let basis = common_motions(&members, &movers, claims, points, &fixed);
        let first = block.len();
        let count = basis.first().map_or(0, Vec::len);
        for &((p, d), owners) in claims.iter().filter(|&&((p, d), _)| !fixed[p][d]) {
            let at = members.iter().position(|m| *m == owners[0]).unwrap_or(0);
            for (k, motion) in basis[at].iter().enumerate() {
                let w = rigid_displacement(motion, movers[owners[0]].at, points.position(p))[d];
                if w.abs() > AT_REST {
                    combinations[3 * p + d].push(((first + k) as u32, w));
                }
            }
        }
        block.extend(std::iter::repeat_n(rigid_block + g as u32, count));
        let faces = members.iter().zip(basis).filter(|(o, _)| **o < model.rigid.len());
        out.push(RigidMotions { first, count, faces: faces.map(|(o, b)| (*o, b)).collect() });
    }
    // the cuts of preloaded bolts have no faces in limit analysis, so there are no closures
    let tightened = model.preload.iter().any(|bolt| !bolt.faces.is_empty());
    let closures = if tightened { model.preload.len() } else { 0 };
    let motions = if limits { model.limit_motions() } else { 0 };
    let first = block.len();
    let begin = [tightened.then_some(first), limits.then_some(first + closures)];
    cuts::follow(model, &followers, begin, &mut combinations);
    for p in (0..points.count()).filter(|p| tied.contains(*p)) {
        for d in (0..3).filter(|&d| tied.first(p, d) != p) {
            combinations[3 * p + d] = combinations[3 * tied.first(p, d) + d].clone();
        }
    }
    block.extend((0..closures).map(|i| rigid_block + (groups + i) as u32));
    let limited = model.resultant_limits.iter().enumerate().filter(|_| limits);
    let block_of = |(i, limit): (usize, &ResultantLimit)| {
        std::iter::repeat_n(rigid_block + (groups + closures + i) as u32, limit.motions())
    };
    block.extend(limited.flat_map(block_of));
    let mut map = DofMap::new(combinations, plain, block);
    (map.closures, map.motions) = (closures, motions);
    let given = |(i, bolt): (usize, &Preload)| bolt.closure.map(|value| (first + i, value));
    map.frozen = model.preload.iter().take(closures).enumerate().filter_map(given).collect();
    Ok((map, out))
}

/// Groups of movers that share points, numbered by their first member.
fn groups(movers: usize, claims: &Claims) -> Vec<usize> {
    let mut root: Vec<usize> = (0..movers).collect();
    fn find(root: &[usize], mut i: usize) -> usize {
        while root[i] != i {
            i = root[i];
        }
        i
    }
    for owners in claims.values() {
        for pair in owners.windows(2) {
            let (a, b) = (find(&root, pair[0]), find(&root, pair[1]));
            root[a.max(b)] = a.min(b);
        }
    }
    let mut number = BTreeMap::new();
    (0..movers)
        .map(|i| {
            let next = number.len();
            *number.entry(find(&root, i)).or_insert(next)
        })
        .collect()
}

/// The common motions of the members of a group, by member and unknown: those that move no held
/// component and agree wherever two members share a point.
fn common_motions(
    members: &[usize],
    movers: &[Mover],
    claims: &[Claim<'_>],
    points: &impl FacePoints,
    fixed: &[[bool; 3]],
) -> Vec<Vec<[f64; 6]>> {
    let mut first = vec![0];
    members.iter().for_each(|&m| first.push(first[first.len() - 1] + movers[m].motions.len()));
    let n = first[members.len()];
    let place = |mover: usize| members.iter().position(|m| *m == mover).unwrap_or(0);
    let mut gram = Mat::<f64>::zeros(n, n);
    let mut bound = false;
    let mut add = |row: &[(usize, f64)]| {
        bound = true;
        for &(i, a) in row {
            row.iter().for_each(|&(j, b)| gram[(i, j)] += a * b);
        }
    };
    for &((p, d), owners) in claims {
        let x = points.position(p);
        let row = |o: usize, sign: f64| -> Vec<(usize, f64)> {
            let at = first[place(o)];
            movers[o].row(x, d).into_iter().enumerate().map(|(i, w)| (at + i, sign * w)).collect()
        };
        let held = if fixed[p][d] { Some(owners[0]) } else { None };
        held.into_iter().for_each(|o| add(&row(o, 1.0)));
        for &other in &owners[1..] {
            let mut difference = row(owners[0], 1.0);
            difference.extend(row(other, -1.0));
            add(&difference);
        }
    }
    let coefficients: Vec<Vec<f64>> = if bound {
        null_space(&gram, 1e-12)
    } else {
        (0..n).map(|k| (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect()).collect()
    };
    let motion = |member: usize, c: &[f64]| -> [f64; 6] {
        let own = &movers[members[member]].motions;
        std::array::from_fn(|i| c[first[member]..].iter().zip(own).map(|(w, m)| w * m[i]).sum())
    };
    (0..members.len()).map(|m| coefficients.iter().map(|c| motion(m, c)).collect()).collect()
}

/// Adds the forces of rigid faces on the program's unknowns: the work of their actions on unit
/// motions.
pub fn add_rigid_actions(
    model: &AnalysisModel,
    motions: &[RigidMotions],
    loads: Loads,
    f: &mut [f64],
) {
    for group in motions {
        for (face, basis) in &group.faces {
            let action = loads.action(&model.rigid[*face]);
            for (k, motion) in basis.iter().enumerate() {
                f[group.first + k] += (0..6).map(|i| motion[i] * action[i]).sum::<f64>();
            }
        }
    }
}

/// The program's unknowns nearest to given full values: values of held unknowns are dropped, groups
/// get the least-squares motion.
pub fn nearest_unknowns(
    map: &DofMap,
    motions: &[RigidMotions],
    full: impl Fn(usize) -> f64,
) -> Vec<f64> {
    let mut x = vec![0.0; map.n];
    let mut fits: Vec<(Mat<f64>, Mat<f64>)> =
        motions.iter().map(|r| (Mat::zeros(r.count, r.count), Mat::zeros(r.count, 1))).collect();
    for i in 0..map.full() {
        let u = full(i);
        if let Some(k) = map.own(i) {
            x[k] = u;
            continue;
        }
        let Some(&(k, _)) = map.terms(i).first().filter(|_| !map.follows(i)) else { continue };
        let group = motions.partition_point(|r| r.first + r.count <= k as usize);
        let (first, (gram, rhs)) = (motions[group].first, &mut fits[group]);
        for &(a, wa) in map.terms(i) {
            rhs[(a as usize - first, 0)] += wa * u;
            for &(b, wb) in map.terms(i) {
                gram[(a as usize - first, b as usize - first)] += wa * wb;
            }
        }
    }
    for (r, (gram, rhs)) in motions.iter().zip(&fits) {
        let motion = pseudo_solve(gram, rhs);
        (0..r.count).for_each(|k| x[r.first + k] = motion[(k, 0)]);
    }
    x
}
