//! The kinematic program: 10-node tetrahedra, contact cones at the Bernstein coefficients of gap
//! and slip.
//!
//! `min Π_p(u)`: an upper bound of the exact potential energy for every admissible u. The cones at
//! the control points ([`crate::programs::contact::kinematic_contact`]) enforce the contact law at
//! every point of the interface, not only at nodes.

use crate::elements::hencky_kinematic::{Flow, YieldingTet10};
use crate::elements::space::Tet10Space;
use crate::elements::tet10;
use crate::elements::yielding_element::Rule;
use crate::model::ModelError;
use crate::model::analysis::{AnalysisModel, BoundaryFace, FacePair};
use crate::model::loads::{Loads, face_nodes};
use crate::model::opening::ConeShift;
use crate::programs::assemble::assemble;
use crate::programs::conic::{ConicProgram, Csr};
use crate::programs::constraints::{FacePoints, hold, working_live_loads};
use crate::programs::contact::cone;
use crate::programs::contact::elastic_ground;
use crate::programs::contact::kinematic_contact::ControlPoint;
use crate::programs::contact::kinematic_contact::control_points;
use crate::programs::contact::kinematic_contact::points_of_faces;
use crate::programs::contact_modes::{ContactMode, contact_modes_of_nodes};
use crate::programs::dofs::DofMap;
use crate::programs::loads::{BodyForceNodes, kinematic_forces};
use crate::programs::rigid_motions::{self, RigidMotions, RigidPieces};
use crate::programs::slip_face::{SlipFace, slip_faces};
use crate::programs::symmetric_sum::plus_entries;
use crate::programs::tied_points::{self, TiedPoints};
use crate::programs::yielding_elements::append;
use crate::programs::{cuts, free_modes, weld_face};
use bracket_base::math::vec3::V3;
use std::collections::BTreeMap;

/// Number of tets up to which limit analysis uses the finer of two rules.
///
/// Gauss's rule may miss the best mechanism of few tets by 4e-5 (a bent beam) to 5e-4 (a hinge two
/// tets wide). On meshes of joints it gives bounds 1e-3 lower than the finer rule, in half the time
/// and memory.
const FINE_RULE: usize = 4_000;

struct Points<'a> {
    model: &'a AnalysisModel,
    space: &'a Tet10Space,
}

impl FacePoints for Points<'_> {
    fn points(&self, face: &BoundaryFace) -> Vec<usize> {
        self.space.triangle(face_nodes(&self.model.mesh, face)).to_vec()
    }
    fn tet_points(&self, tet: usize) -> Vec<usize> {
        self.space.tet(&self.model.mesh, tet).to_vec()
    }
    fn pairs(&self, face: &FacePair) -> Vec<[usize; 2]> {
        let (a, b) = (self.space.triangle(face.nodes_a), self.space.triangle(face.nodes_b));
        a.into_iter().zip(b).map(|(a, b)| [a, b]).collect()
    }
    fn position(&self, point: usize) -> V3 {
        self.space.nodes[point]
    }
    fn count(&self) -> usize {
        self.space.nodes.len()
    }
    fn block(&self, point: usize) -> u32 {
        point as u32
    }
}

/// The kinematic program of a model.
#[derive(Clone, Debug)]
pub struct Kinematic {
    /// Its conic program.
    pub program: ConicProgram,
    /// Its displacement space.
    pub space: Tet10Space,
    /// Full displacements from the program's unknowns.
    pub map: DofMap,
    /// Unknowns of the rigid faces and bodies.
    pub rigid: Vec<RigidMotions>,
    /// The held faces on which bodies may slip, in limit analysis.
    pub slips: Vec<SlipFace>,
    /// The points on ties, along which bodies may slip in limit analysis.
    tied: TiedPoints,
    /// The control point of each contact cone; the cones of yielding elements follow.
    pub points: Vec<ControlPoint>,
    /// First own unknown of each element, then of each weld face, slip face and tie face; own
    /// unknowns follow those that elements share. Empty without plasticity and welds.
    pub own: Vec<usize>,
    /// True for tets whose element yields and is split; empty without plasticity.
    pub split: Vec<bool>,
}

/// Kind of kinematic program.
#[derive(Clone, Copy)]
enum Kind<'f> {
    Elastic,
    /// Elastic, except that bodies without a yield strength are rigid.
    AroundRigidBodies,
    /// Elastic, perfectly plastic; element of each tet, `None` where it stays elastic.
    Hencky(&'f [Option<Flow>]),
    /// Rigid-plastic.
    Limit(Flow),
}

/// The unknowns of a program with what decides on them.
pub(super) struct Numbering {
    pub(super) pieces: RigidPieces,
    slips: Vec<SlipFace>,
    tied: TiedPoints,
    pub(super) map: DofMap,
    pub(super) rigid: Vec<RigidMotions>,
}

/// Numbers the unknowns. `slipping`: bodies without a yield strength are rigid and may slip on held
/// faces and along ties.
pub(super) fn numbering(
    model: &AnalysisModel,
    space: &Tet10Space,
    slipping: bool,
) -> Result<Numbering, ModelError> {
    let pieces = if slipping { RigidPieces::unyielding(model) } else { RigidPieces::default() };
    let slips = if slipping { slip_faces(model) } else { Vec::new() };
    let points = Points { model, space };
    let tied = TiedPoints::new(model, &points, slipping);
    let (map, rigid) =
        rigid_motions::number_unknowns(model, &points, &pieces, &slips, &tied, slipping)?;
    Ok(Numbering { pieces, slips, tied, map, rigid })
}

impl Kinematic {
    /// Number of unknowns that the elements share and of closings of the ground, of the program of
    /// limit analysis or of one of the others. No matrix is assembled.
    pub fn unknowns(model: &AnalysisModel, limit: bool) -> Result<usize, ModelError> {
        let space = Tet10Space::new(&model.mesh);
        let shared = numbering(model, &space, limit)?.map.n;
        let closing = |p: &ControlPoint| p.closing.is_some_and(|c| c.is_part(limit));
        Ok(shared + control_points(model, &space).iter().filter(|p| closing(p)).count())
    }

    /// Builds the elastic program: no body yields.
    pub fn new(model: &AnalysisModel) -> Result<Self, ModelError> {
        Self::build(model, Kind::Elastic)
    }

    /// Builds the elastic, perfectly plastic program (Hencky): bodies with a yield strength consist
    /// of elements that yield, the others stay elastic.
    pub fn with_plasticity(model: &AnalysisModel, flow: Flow) -> Result<Self, ModelError> {
        Self::build(model, Kind::Hencky(&vec![Some(flow); model.mesh.tets.len()]))
    }

    /// Builds the same program with plastic strain only in tets for which `flow` names an element;
    /// the other tets are plain and elastic, whatever their strength. The result is still an upper
    /// bound: the minimum is taken over fewer fields.
    pub fn with_plasticity_in(
        model: &AnalysisModel,
        flow: &[Option<Flow>],
    ) -> Result<Self, ModelError> {
        Self::build(model, Kind::Hencky(flow))
    }

    /// Builds the program of limit analysis: the least dissipation at unit power of the live loads,
    /// less the power of the dead loads. Bodies without a yield strength are rigid. Initial gaps
    /// count as closed.
    pub fn limit(model: &AnalysisModel, flow: Flow) -> Result<Self, ModelError> {
        model.check_limit_analysis()?;
        Self::build(model, Kind::Limit(flow))
    }

    /// Builds the elastic program in which bodies without a yield strength are rigid. Its energy
    /// norm measures the distance between velocity fields of limit analysis.
    pub fn around_rigid_bodies(model: &AnalysisModel) -> Result<Self, ModelError> {
        Self::build(model, Kind::AroundRigidBodies)
    }

    fn build(model: &AnalysisModel, kind: Kind) -> Result<Self, ModelError> {
        let space = Tet10Space::new(&model.mesh);
        let slipping = matches!(kind, Kind::Limit(_) | Kind::AroundRigidBodies);
        let Numbering { pieces, slips, tied, mut map, rigid } = numbering(model, &space, slipping)?;
        let limit = matches!(kind, Kind::Limit(_));
        let mut contacts = control_points(model, &space);
        contacts.iter_mut().for_each(|p| p.closing = p.closing.filter(|c| c.is_part(limit)));
        map.append_closings(contacts.iter().filter(|p| p.closing.is_some()).count());
        let materials = model.stiffnesses();
        let radii = model.yield_radii();
        // yield radius and kind of element of each tet that may flow
        let flow_of = |e: usize| -> Option<(f64, Flow)> {
            let radius = radii[model.mesh.tet_body[e] as usize]?;
            match kind {
                Kind::Elastic | Kind::AroundRigidBodies => None,
                Kind::Hencky(flow) => flow[e].map(|f| (radius, f)),
                Kind::Limit(flow) => Some((radius, flow)),
            }
        };
        let rule = if !limit {
            Rule::Hencky
        } else if model.mesh.tets.len() <= FINE_RULE {
            Rule::TenPoints
        } else {
            Rule::Gauss
        };
        let yields = (0..model.mesh.tets.len()).any(|e| flow_of(e).is_some());
        let forces = model.body_forces(Loads::ALL);
        let dofs = |e: usize| {
            let nodes = space.tet(&model.mesh, e);
            std::array::from_fn(|i| 3 * nodes[i / 3] + i % 3)
        };
        let yielding = |e: usize| {
            let body = model.mesh.tet_body[e] as usize;
            flow_of(e).map(|(radius, flow)| YieldingTet10 {
                corners: model.mesh.corners(e),
                volume: model.mesh.volume(e),
                material: materials[body],
                radius,
                body_force: forces[body],
                split: flow == Flow::Split,
                rule,
            })
        };
        // rigid-plastic elements add nothing to P
        let assembled = if limit { 0 } else { model.mesh.tets.len() };
        let mut p = assemble::<30, ModelError>(assembled, &map, dofs, |e| {
            let body = model.mesh.tet_body[e] as usize;
            Ok(match yielding(e) {
                Some(element) => element.outer_stiffness(),
                None if pieces.contains(e) => Box::new([[0.0; 30]; 30]),
                None => {
                    tet10::stiffness(&model.mesh.corners(e), model.mesh.volume(e), &materials[body])
                }
            })
        })?;
        let ground = elastic_ground::kinematic_entries(model, &space, &contacts, map.closings());
        if !ground.is_empty() {
            p = plus_entries(&p, ground);
        }
        let split_nodes = if limit { BodyForceNodes::Flow } else { BodyForceNodes::Split };
        let force_nodes = |e: usize| match flow_of(e) {
            Some((_, Flow::Split)) => split_nodes,
            _ => BodyForceNodes::Plain,
        };
        let forces_of = |loads| kinematic_forces(model, &space, &map, &rigid, &force_nodes, loads);
        let mut f = forces_of(if limit { Loads::DEAD } else { Loads::ALL });
        cuts::add_preload(model, &map, &mut f);
        let mut stiffness = Vec::new();
        let weld_faces: Vec<(f64, &FacePair)> = match kind {
            Kind::AroundRigidBodies => Vec::new(),
            _ => model.weld_faces().collect(),
        };
        if yields || !pieces.is_empty() || !weld_faces.is_empty() {
            // the diagonal of P, plus the elastic stiffness of elements that is not in P
            stiffness = p.diagonal();
            let mut rest = vec![0.0; map.full()];
            for e in 0..model.mesh.tets.len() {
                let missing: [f64; 30] = match yielding(e) {
                    Some(element) => {
                        let (elastic, kept) =
                            (element.elastic_diagonal(), element.outer_stiffness());
                        std::array::from_fn(|i| elastic[i] - kept[i][i])
                    }
                    None if pieces.contains(e) => {
                        let body = model.mesh.tet_body[e] as usize;
                        tet10::diagonal(
                            &model.mesh.corners(e),
                            model.mesh.volume(e),
                            &materials[body],
                        )
                    }
                    None => continue,
                };
                dofs(e).into_iter().zip(missing).for_each(|(d, k)| rest[d] += k);
            }
            map.reduce_diagonal(&rest).iter().zip(&mut stiffness).for_each(|(d, s)| *s += d);
        }
        hold(&mut p, &free_modes::kinematic_pins(model, &space, &map, &rigid, &pieces), &stiffness);
        let mut program = ConicProgram {
            p,
            q: f.iter().map(|x| -x).collect(),
            stiffness,
            ..ConicProgram::default()
        };
        program.g.ncols = map.n;
        let mut points = Vec::new();
        let (mut closings, mut next) = (Vec::new(), map.closings());
        for mut point in contacts {
            if limit {
                point.gap = 0.0;
            }
            let (row, closing) = (program.g.nrows(), point.closing.and_then(|_| next.next()));
            let moves = point.push_cone(&mut program, &map, closing);
            closings.extend(point.closing.map(|c| (moves.then_some(row), c)));
            if moves {
                points.push(point);
            }
        }
        cuts::append_limits(model, &map, &mut program);
        cone::append_closings(&mut program, &map, &closings);
        map.frozen.iter().for_each(|&(k, closure)| program.freeze(k, closure));
        let (mut own, mut split) = (Vec::new(), Vec::new());
        let tets = model.mesh.tets.len();
        if yields || !weld_faces.is_empty() {
            split = (0..tets).map(|e| matches!(flow_of(e), Some((_, Flow::Split)))).collect();
            // slips have elements in limit analysis only
            let slips = if limit { &slips[..] } else { &[] };
            let ties: Vec<_> = model.tie_faces().filter(|_| limit).collect();
            let faces = tets + weld_faces.len();
            own = append(&mut program, faces + slips.len() + ties.len(), |e| {
                if let Some(tie) = e.checked_sub(faces + slips.len()) {
                    let (strength, face) = ties[tie];
                    let jumps = tied_points::jumps(model, &space, &tied, face, true);
                    return Ok(weld_face::element(&map, strength, &jumps));
                }
                if let Some(slip) = e.checked_sub(faces) {
                    let slip = &slips[slip];
                    let jumps = slip.jumps(model, &space, true);
                    return Ok(weld_face::element(&map, slip.strength, &jumps));
                }
                if let Some(weld) = e.checked_sub(tets) {
                    let (strength, face) = weld_faces[weld];
                    return Ok(weld_face::element(
                        &map,
                        strength,
                        &weld_face::kinematic_jumps(&space, face, true),
                    ));
                }
                let columns = || map.columns(&dofs(e));
                Ok::<_, ModelError>(yielding(e).map(|element| element.element(&columns())))
            })?;
        }
        if limit {
            program.add_load_factor(working_live_loads(forces_of(Loads::LIVE))?);
        }
        Ok(Self { program, space, map, rigid, slips, tied, points, own, split })
    }
}

impl Kinematic {
    /// Displacements (velocities in limit analysis) of the nodes from the program's unknowns.
    pub fn nodal(&self, x: &[f64]) -> Vec<V3> {
        self.map.expand(x).chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect()
    }

    /// The motions of the resultant limits from the program's unknowns, limit by limit.
    pub fn limit_motions(&self, x: &[f64]) -> Vec<f64> {
        x[self.map.limit_motions()].to_vec()
    }

    /// The Bernstein coefficients of the jump on every weld face as rows on the shared unknowns,
    /// three rows each.
    pub fn weld_rows(&self, model: &AnalysisModel) -> Csr {
        let faces = model.weld_faces();
        weld_face::rows(
            &self.map,
            faces.flat_map(|(_, f)| weld_face::kinematic_jumps(&self.space, f, false)),
        )
    }

    /// The Bernstein coefficients of the held tangential velocity on every slip face and of the
    /// tangential jump on every tie face as rows on the shared unknowns, three rows each.
    pub fn slip_rows(&self, model: &AnalysisModel) -> Csr {
        let held = self.slips.iter().flat_map(|s| s.jumps(model, &self.space, false));
        let ties = model
            .tie_faces()
            .flat_map(|(_, f)| tied_points::jumps(model, &self.space, &self.tied, f, false));
        weld_face::rows(&self.map, held.chain(ties))
    }

    /// Loads on the shared unknowns in limit analysis \[N\]; their product with velocities is the
    /// power.
    ///
    /// Bodies with a yield strength consist of `flow` elements, the inner velocities of split ones
    /// as in [`crate::elements::split_flow`].
    pub fn limit_forces(&self, model: &AnalysisModel, flow: Flow, loads: Loads) -> Vec<f64> {
        let radii = model.yield_radii();
        let force_nodes = |e: usize| match (radii[model.mesh.tet_body[e] as usize], flow) {
            (Some(_), Flow::Split) => BodyForceNodes::Flow,
            _ => BodyForceNodes::Plain,
        };
        kinematic_forces(model, &self.space, &self.map, &self.rigid, &force_nodes, loads)
    }

    /// Shift of the contact cones from the values at the control points \[mm\]; zero at points that
    /// cannot move.
    pub fn cone_shift(&self, model: &AnalysisModel, values: &[f64]) -> ConeShift {
        let of: BTreeMap<_, f64> =
            self.points.iter().zip(values).map(|(p, s)| (p.key(), *s)).collect();
        let value = |p: ControlPoint| of.get(&p.key()).copied().unwrap_or(0.0);
        ConeShift {
            faces: points_of_faces(model, &self.space).into_iter().map(|f| f.map(value)).collect(),
        }
    }

    /// Unknowns of a displacement that closes the frozen cuts with little strain. Solvers measure
    /// the unknowns from it. Empty without frozen cuts.
    pub fn closed(&self, model: &AnalysisModel) -> Vec<f64> {
        let mut tet = vec![0; self.space.nodes.len()];
        for e in 0..model.mesh.tets.len() {
            self.space.tet(&model.mesh, e).into_iter().for_each(|n| tet[n] = e);
        }
        cuts::spread(model, &self.map, tet.into_iter().zip(self.space.nodes.iter().copied()))
    }

    /// The rigid motions that only contact resists.
    pub fn contact_modes(&self, model: &AnalysisModel) -> Vec<ContactMode> {
        contact_modes_of_nodes(model, &self.space, &self.map)
    }
}
