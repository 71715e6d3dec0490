//! Displacements with plastic strain (Hencky) as plain data, and the tets on which they are
//! quadratic and linear.
//!
//! The plastic strain is linear in a plain tet, or in each of the four subtets of a split one, and
//! stored by its five deviatoric components, so that it keeps the volume. Any such field is
//! admissible. The best one for a displacement is computed tet by tet ([`plastic_strain`]), without
//! a solver.

use crate::certify::fields::DisplacementField;
use crate::elements::space::Tet10Space;
use crate::elements::{split_tet10, tet10};
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use bracket_base::math::mandel::{DEVIATORIC, Mandel, deviator};
use bracket_base::math::quadrature::tetrahedron_mass;
use bracket_base::math::vec3::{self, V3};
use rayon::prelude::*;

/// A deviator in the basis [`DEVIATORIC`].
pub type Deviator = [f64; 5];
/// Plastic strain at the four vertices of a (sub)tet.
pub type VertexFlow = [Deviator; 4];
/// Displacements of the nodes inside a split tet, numbered from 10 in [`split_tet10`] \[mm\].
pub type InnerNodes = [V3; split_tet10::NODES - split_tet10::OUTER];

/// Kind of element of a tet, and its plastic strain.
#[derive(Clone, Debug, PartialEq)]
pub enum PlasticTet {
    /// A plain 10-node tetrahedron without plastic strain.
    Elastic,
    /// A plain 10-node tetrahedron.
    Plain(Box<VertexFlow>),
    /// Split at its centroid.
    Split {
        /// Displacements inside \[mm\].
        inner: Box<InnerNodes>,
        /// Plastic strain in each subtet.
        plastic: Box<[VertexFlow; 4]>,
    },
}

/// Displacements of vertices and mid-side nodes, and the state of every tet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlasticField {
    /// The displacement of each node \[mm\].
    pub nodes: DisplacementField,
    /// The tets.
    pub tets: Vec<PlasticTet>,
}

/// A tet in which the displacement is quadratic and the plastic strain linear: a plain element or a
/// subtet of a split one.
pub struct PlasticPiece {
    /// Corners \[mm\].
    pub corners: [V3; 4],
    /// Volume \[mm³\].
    pub volume: f64,
    /// Displacements: vertices, then mid-sides \[mm\].
    pub displacements: [V3; 10],
    /// Plastic strain at the vertices.
    pub plastic: VertexFlow,
}

/// The tensor with the given deviatoric components.
pub fn tensor(d: &Deviator) -> Mandel {
    std::array::from_fn(|i| (0..5).map(|a| d[a] * DEVIATORIC[a][i]).sum())
}

/// Size of a deviator.
pub fn length(d: &Deviator) -> f64 {
    d.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Equivalent strain `√(2/3) ‖p̄‖` of the mean plastic strain of a tet, a fraction. Its pieces are
/// equal parts of it.
pub fn mean_equivalent(pieces: &[PlasticPiece]) -> f64 {
    let mut mean = [0.0; 5];
    for d in pieces.iter().flat_map(|p| &p.plastic) {
        (0..5).for_each(|a| mean[a] += d[a] / (4 * pieces.len()) as f64);
    }
    (2.0f64 / 3.0).sqrt() * length(&mean)
}

impl PlasticField {
    /// A displacement without plastic strain on `tets` plain tets.
    pub fn elastic(nodes: DisplacementField, tets: usize) -> Self {
        Self { nodes, tets: vec![PlasticTet::Elastic; tets] }
    }

    /// The pieces of tet `e`, one or four.
    pub fn pieces(&self, model: &AnalysisModel, space: &Tet10Space, e: usize) -> Vec<PlasticPiece> {
        let (corners, volume) = (model.mesh.corners(e), model.mesh.volume(e));
        let outer = space.tet(&model.mesh, e).map(|n| self.nodes.u[n]);
        let plain = |plastic| vec![PlasticPiece { corners, volume, displacements: outer, plastic }];
        match &self.tets[e] {
            PlasticTet::Elastic => plain([[0.0; 5]; 4]),
            PlasticTet::Plain(plastic) => plain(**plastic),
            PlasticTet::Split { inner, plastic } => (0..4)
                .map(|k| PlasticPiece {
                    corners: split_tet10::subtet_corners(&corners, k),
                    volume: 0.25 * volume,
                    displacements: subtet_displacements(&outer, inner, k),
                    plastic: plastic[k],
                })
                .collect(),
        }
    }

    /// Plastic strain at the 16 points of tet `e`, numbered as those of
    /// [`crate::elements::super_element`].
    pub fn plastic_at_points(&self, e: usize) -> [VertexFlow; 4] {
        match &self.tets[e] {
            PlasticTet::Elastic => [[[0.0; 5]; 4]; 4],
            PlasticTet::Plain(p) => at_points(p),
            PlasticTet::Split { plastic, .. } => **plastic,
        }
    }
}

/// Values of a field linear in the whole tet at the points of its subtets; the last point of each
/// is the centroid.
pub(crate) fn at_points<const N: usize>(v: &[[f64; N]; 4]) -> [[[f64; N]; 4]; 4] {
    let centre = std::array::from_fn(|c| 0.25 * (v[0][c] + v[1][c] + v[2][c] + v[3][c]));
    std::array::from_fn(|k| std::array::from_fn(|p| if p < 3 { v[FACES[k][p]] } else { centre }))
}

fn subtet_displacements(outer: &[V3; 10], inner: &InnerNodes, k: usize) -> [V3; 10] {
    split_tet10::subtet_nodes(k)
        .map(|n| if n < split_tet10::OUTER { outer[n] } else { inner[n - split_tet10::OUTER] })
}

/// The plastic strain of least energy at the given strain of a (sub)tet: the minimum of
/// `½ ∫ 2G ‖dev ε − p‖² + ¼ V √(2/3) f_y Σ ‖p_i‖` over p linear between the vertices, found by
/// exact minimisation vertex after vertex.
///
/// Zero where `2G ‖dev (ε_i + Σ_j ε_j)‖/5 ≤ √(2/3) f_y` at every vertex. `two_mu` = 2G and `radius`
/// = √(2/3) f_y in MPa.
pub fn plastic_strain(strains: &[Mandel; 4], two_mu: f64, radius: f64) -> VertexFlow {
    // the system has condition number 5: about 40 sweeps reach rounding
    const SWEEPS: usize = 100;
    let e = strains.map(|s| deviator(&s));
    let mut p = [[0.0; 5]; 4];
    let stiffness = two_mu * tetrahedron_mass(0, 0);
    for _ in 0..SWEEPS {
        let mut change = 0.0f64;
        for i in 0..4 {
            let pull: Deviator = std::array::from_fn(|a| {
                let others = (0..4)
                    .filter(|&j| j != i)
                    .map(|j| tetrahedron_mass(i, j) * (e[j][a] - p[j][a]));
                two_mu * (tetrahedron_mass(i, i) * e[i][a] + others.sum::<f64>())
            });
            let size = length(&pull);
            let part =
                if size > 0.25 * radius { (1.0 - 0.25 * radius / size) / stiffness } else { 0.0 };
            let new = pull.map(|x| part * x);
            change = change.max((0..5).map(|a| (new[a] - p[i][a]).abs()).fold(0.0, f64::max));
            p[i] = new;
        }
        if change <= 1e-15 * p.iter().map(length).fold(0.0, f64::max) {
            break;
        }
    }
    p
}

/// The field of a displacement in which every tet of a body with a yield strength has the plastic
/// strain of least energy; `inner`: displacements inside, for the tets that are split.
pub fn with_plastic_strain(
    model: &AnalysisModel,
    nodes: DisplacementField,
    inner: impl Fn(usize) -> Option<InnerNodes> + Sync,
) -> PlasticField {
    let space = Tet10Space::new(&model.mesh);
    let (radii, materials) = (model.yield_radii(), model.stiffnesses());
    let tets = (0..model.mesh.tets.len())
        .into_par_iter()
        .map(|e| {
            let body = model.mesh.tet_body[e] as usize;
            let corners = model.mesh.corners(e);
            let outer = space.tet(&model.mesh, e).map(|n| nodes.u[n]);
            let Some(radius) = radii[body] else { return PlasticTet::Elastic };
            let flow = |corners: &[V3; 4], u: &[V3; 10]| {
                plastic_strain(&tet10::vertex_strains(corners, u), materials[body].two_mu, radius)
            };
            match inner(e) {
                Some(inner) => {
                    let plastic = std::array::from_fn(|k| {
                        flow(
                            &split_tet10::subtet_corners(&corners, k),
                            &subtet_displacements(&outer, &inner, k),
                        )
                    });
                    PlasticTet::Split { inner: Box::new(inner), plastic: Box::new(plastic) }
                }
                None => {
                    let plastic = flow(&corners, &outer);
                    let flows = plastic.iter().flatten().any(|x| *x != 0.0);
                    if flows { PlasticTet::Plain(Box::new(plastic)) } else { PlasticTet::Elastic }
                }
            }
        })
        .collect();
    PlasticField { nodes, tets }
}

/// Mean of displacements.
pub(crate) fn mean<const N: usize>(u: [V3; N]) -> V3 {
    vec3::scale(1.0 / N as f64, u.into_iter().fold([0.0; 3], vec3::add))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certify::dissipation::mean_norm;

    fn random(seed: &mut u64) -> f64 {
        *seed ^= *seed << 13;
        *seed ^= *seed >> 7;
        *seed ^= *seed << 17;
        (*seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }

    const TWO_MU: f64 = 160.0;
    const RADIUS: f64 = 1.3;

    /// Energy per volume of a plastic strain at strains with deviators `e`.
    fn energy(e: &VertexFlow, p: &VertexFlow) -> f64 {
        let mut sum = 0.0;
        for i in 0..4 {
            for j in 0..4 {
                let product: f64 = (0..5).map(|a| (e[i][a] - p[i][a]) * (e[j][a] - p[j][a])).sum();
                sum += 0.5 * TWO_MU * tetrahedron_mass(i, j) * product;
            }
        }
        sum + p.iter().map(|p| 0.25 * RADIUS * length(p)).sum::<f64>()
    }

    fn strains(seed: &mut u64, size: f64) -> (VertexFlow, [Mandel; 4]) {
        let e: VertexFlow = std::array::from_fn(|_| std::array::from_fn(|_| size * random(seed)));
        // a change of volume causes no plastic strain
        (e, e.map(|e| std::array::from_fn(|i| tensor(&e)[i] + if i < 3 { 0.01 } else { 0.0 })))
    }

    /// No random neighbour, near or far, has less energy; the plastic strain is zero exactly where
    /// the trial stress is below yield.
    #[test]
    fn no_other_plastic_strain_costs_less() {
        let mut seed = 77;
        let (mut flows, mut rests) = (0, 0);
        for round in 0..60 {
            let (e, s) = strains(&mut seed, [0.01, 0.03, 0.3][round % 3]);
            let p = plastic_strain(&s, TWO_MU, RADIUS);
            let best = energy(&e, &p);
            for k in 0..200 {
                let size = 10f64.powi(-(k % 8));
                let other = p.map(|p| p.map(|x| x + 0.1 * size * random(&mut seed)));
                assert!(
                    energy(&e, &other) >= best * (1.0 - 1e-13),
                    "{best} {}",
                    energy(&e, &other)
                );
            }
            let trial = (0..4).map(|i| {
                let d: Deviator =
                    std::array::from_fn(|a| (e[i][a] + e.iter().map(|e| e[a]).sum::<f64>()) / 5.0);
                TWO_MU * length(&d)
            });
            let still = trial.fold(0.0, f64::max) <= RADIUS;
            assert_eq!(still, p == [[0.0; 5]; 4]);
            if still { rests += 1 } else { flows += 1 }
        }
        assert!(flows > 10 && rests > 10, "{flows} {rests}");
    }

    /// A constant strain e beyond yield flows `e (1 − √(2/3) f_y/(2G‖e‖))`, the closed form.
    #[test]
    fn constant_strain_returns_radially() {
        let mut seed = 5;
        let one: Deviator = std::array::from_fn(|_| random(&mut seed));
        let p = plastic_strain(&[tensor(&one); 4], TWO_MU, RADIUS);
        let part = 1.0 - RADIUS / (TWO_MU * length(&one));
        for p in p {
            assert!((0..5).all(|a| (p[a] - part * one[a]).abs() < 1e-14), "{p:?}");
        }
        assert!((mean_norm(&p.map(|p| tensor(&p)), 1) - part * length(&one)).abs() < 1e-14);
    }
}
