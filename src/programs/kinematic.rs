//! The kinematic program: 10-node tetrahedra, contact cones at the Bernstein coefficients of gap
//! and slip.
//!
//! `min Π_p(u)`: an upper bound of the exact potential energy for every admissible u. Gap and slip
//! are quadratic on a face; a quadratic polynomial lies in a convex cone wherever its six Bernstein
//! coefficients do, so the contact law holds at every point of the interface, not only at nodes.

use crate::elements::batch::Rule;
use crate::elements::hencky_kinematic::{Flow, YieldingTet10};
use crate::elements::space::{FACE_EDGES, Tet10Space};
use crate::elements::{split_flow, split_tet10, tet10};
use crate::math::quadrature::{TRIANGLE_4, triangle_p2};
use crate::math::rigid_motion::rigid_displacement;
use crate::math::vec3::{self, V3};
use crate::model::ModelError;
use crate::model::analysis::{AnalysisModel, BoundaryFace, FacePair};
use crate::model::loads::{Loads, face_corners, face_nodes};
use crate::model::opening::{Bernstein, ConeShift};
use crate::programs::assemble::assemble;
use crate::programs::conic::{Cone, ConicProgram, Csr};
use crate::programs::constraints::{self, FacePoints};
use crate::programs::contact_modes::{ContactMode, contact_modes};
use crate::programs::dofs::DofMap;
use crate::programs::rigid_motions::{self, RigidMotions, RigidPieces};
use crate::programs::yielding_elements::append;
use crate::programs::{cuts, weld_face};
use std::collections::{BTreeMap, BTreeSet};

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

/// A Bernstein coefficient of the gap on an interface: a vertex, or an edge with its two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlPoint {
    /// Which contact it belongs to: interfaces first, then contacts with the ground.
    pub contact: usize,
    /// Unit normal out of side A.
    pub normal: V3,
    /// Friction coefficient.
    pub mu: f64,
    /// Coefficient of the initial gap, and of the shift where there is one \[mm\].
    pub gap: f64,
    /// Nodes on side A: vertex, or mid-side and ends.
    pub a: [usize; 3],
    /// Nodes on side B; `None`: rigid ground.
    pub b: Option<[usize; 3]>,
    /// An edge: the coefficient is `2 u_mid − ½ (u_i + u_j)`.
    pub edge: bool,
}

impl ControlPoint {
    /// Node weights of the coefficient.
    pub fn weights(&self) -> &'static [f64] {
        if self.edge { &[2.0, -0.5, -0.5] } else { &[1.0] }
    }

    /// Its identity: contact, nodes on both sides and the normal, rounded so that faces of one
    /// plane share it.
    fn key(&self) -> (usize, usize, usize, [i64; 3]) {
        // faces of one plane agree to rounding; faces that bend by more keep a cone each, or a
        // bound would not be one
        let rounded = self.normal.map(|x| (x * 1e12).round() as i64);
        (self.contact, self.a[0], self.b.map_or(usize::MAX, |b| b[0]), rounded)
    }

    /// The coefficient of the slip of nodal displacements, its size \[mm\].
    pub fn slip(&self, u: &[V3]) -> f64 {
        let jump = self.jump(u);
        vec3::norm(vec3::sub(jump, vec3::scale(vec3::dot(jump, self.normal), self.normal)))
    }

    /// The coefficient of the jump `u_B − u_A` of nodal displacements.
    pub fn jump(&self, u: &[V3]) -> V3 {
        let side = |n: &[usize; 3]| {
            self.weights()
                .iter()
                .zip(n)
                .fold([0.0; 3], |s, (&w, &i)| vec3::add(s, vec3::scale(w, u[i])))
        };
        vec3::sub(self.b.as_ref().map_or([0.0; 3], &side), side(&self.a))
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
    /// The control point of each contact cone; the cones of yielding elements follow.
    pub points: Vec<ControlPoint>,
    /// Where the unknowns of each element's own start, after those that elements share, and of each
    /// weld face behind them; empty without plasticity and welds.
    pub own: Vec<usize>,
    /// Tets whose element flows and is split; empty without plasticity.
    pub split: Vec<bool>,
}

/// Which program.
#[derive(Clone, Copy)]
enum Kind<'f> {
    Elastic,
    /// Elastic, except that bodies without a yield strength are rigid.
    AroundRigidBodies,
    /// What each tet is made of, where it may flow.
    Hencky(&'f [Option<Flow>]),
    Limit(Flow),
}

/// The six control points of every contact face, interfaces first; neighbours in one plane repeat
/// each other's.
fn points_of_faces(model: &AnalysisModel, space: &Tet10Space) -> Vec<[ControlPoint; 6]> {
    let interfaces = model.interfaces.iter().enumerate().flat_map(|(contact, interface)| {
        interface.faces.iter().map(move |f| {
            let corners = f.nodes_a.map(|n| model.mesh.nodes[n as usize]);
            (contact, corners, space.triangle(f.nodes_a), Some(space.triangle(f.nodes_b)))
        })
    });
    let ground = (model.interfaces.len()..).zip(&model.ground).flat_map(|(contact, ground)| {
        ground.faces.iter().map(move |f| {
            let a = space.triangle(face_nodes(&model.mesh, f));
            (contact, face_corners(&model.mesh, f), a, None)
        })
    });
    interfaces
        .chain(ground)
        .enumerate()
        .map(|(face, (contact, corners, a, b))| {
            let law = model.contact_law(contact);
            points_of_face(contact, law.mu, model.opening(face, law, &corners), &corners, a, b)
        })
        .collect()
}

/// Every distinct control point of the model's contacts.
pub fn control_points(model: &AnalysisModel, space: &Tet10Space) -> Vec<ControlPoint> {
    let mut seen = BTreeSet::new();
    points_of_faces(model, space).into_iter().flatten().filter(|p| seen.insert(p.key())).collect()
}

fn points_of_face(
    contact: usize,
    mu: f64,
    opening: Bernstein,
    corners: &[V3; 3],
    a: [usize; 6],
    b: Option<[usize; 6]>,
) -> [ControlPoint; 6] {
    let area = vec3::area_vector(corners);
    let normal = vec3::scale(1.0 / vec3::norm(area), area);
    std::array::from_fn(|i| {
        // a vertex stands for itself, an edge for its mid-side node and its two ends
        let picked = if i < 3 { [i; 3] } else { [i, FACE_EDGES[i - 3][0], FACE_EDGES[i - 3][1]] };
        let pick = |n: [usize; 6]| picked.map(|k| n[k]);
        ControlPoint {
            contact,
            normal,
            mu,
            gap: opening[i],
            a: pick(a),
            b: b.map(pick),
            edge: i >= 3,
        }
    })
}

/// What a body force does to the nodes of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Inside {
    /// A plain element.
    Plain,
    /// A split element whose inner nodes bear their own part.
    Split,
    /// A split element whose inner nodes follow the outer ones at constant divergence.
    Flow,
}

/// What the element of each tet is.
type InsideOf<'a> = &'a dyn Fn(usize) -> Inside;

/// Nodal forces of the loads \[N\]; `inside` tells what each element is.
fn nodal_forces(
    model: &AnalysisModel,
    space: &Tet10Space,
    inside: InsideOf,
    loads: Loads,
) -> Vec<f64> {
    let mut f = vec![0.0; 3 * space.nodes.len()];
    let body = model.body_forces(loads);
    if body.iter().any(|b| *b != [0.0; 3]) {
        let (plain, split) = (tet10::shape_integrals(), split_tet10::shape_integrals());
        for e in 0..model.mesh.tets.len() {
            let of = model.mesh.tet_body[e] as usize;
            let (b, v) = (body[of], model.mesh.volume(e));
            let forces: [f64; 30] = match inside(e) {
                Inside::Plain => std::array::from_fn(|i| plain[i / 3] * v * b[i % 3]),
                Inside::Split => std::array::from_fn(|i| split[i / 3] * v * b[i % 3]),
                Inside::Flow => split_flow::body_forces(&model.mesh.corners(e), v, b),
            };
            for (n, force) in space.tet(&model.mesh, e).into_iter().zip(forces.chunks_exact(3)) {
                (0..3).for_each(|d| f[3 * n + d] += force[d]);
            }
        }
    }
    for load in model.surface_loads.iter().filter(|l| loads.share(l.dead) != 0.0) {
        let share = loads.share(load.dead);
        for face in &load.faces {
            let corners = face_corners(&model.mesh, face);
            let nodes = space.triangle(face_nodes(&model.mesh, face));
            let area = vec3::area_vector(&corners);
            let size = vec3::norm(area);
            let normal = vec3::scale(1.0 / size, area);
            for (l, w) in TRIANGLE_4 {
                let x = std::array::from_fn(|d| (0..3).map(|i| l[i] * corners[i][d]).sum());
                let t = vec3::scale(share, load.at(x, normal));
                for (n, s) in nodes.iter().zip(triangle_p2(l)) {
                    (0..3).for_each(|d| f[3 * n + d] += w * size * s * t[d]);
                }
            }
        }
    }
    f
}

/// Loads and actions of rigid faces on the program's shared unknowns \[N\].
fn shared_forces(
    model: &AnalysisModel,
    space: &Tet10Space,
    map: &DofMap,
    rigid: &[RigidMotions],
    inside: InsideOf,
    loads: Loads,
) -> Vec<f64> {
    let mut f = map.reduce(&nodal_forces(model, space, inside, loads));
    rigid_motions::add_rigid_actions(model, rigid, loads, &mut f);
    f
}

impl Kinematic {
    /// Builds the elastic program: no body yields.
    pub fn new(model: &AnalysisModel) -> Result<Self, ModelError> {
        Self::build(model, Kind::Elastic)
    }

    /// Builds the elastic, perfectly plastic program (Hencky): bodies with a yield strength are
    /// made of elements that yield, the others stay elastic.
    pub fn with_plasticity(model: &AnalysisModel, flow: Flow) -> Result<Self, ModelError> {
        Self::build(model, Kind::Hencky(&vec![Some(flow); model.mesh.tets.len()]))
    }

    /// The same with flow only where `flow` names an element for a tet; the other tets are plain
    /// and stay elastic, whatever their strength. Still an upper bound: to flow less is to choose
    /// among fewer fields.
    pub fn with_plasticity_in(
        model: &AnalysisModel,
        flow: &[Option<Flow>],
    ) -> Result<Self, ModelError> {
        Self::build(model, Kind::Hencky(flow))
    }

    /// Builds the program of limit analysis: the least dissipation at unit power of the live loads,
    /// less the power of the dead ones. Bodies without a yield strength are rigid; initial gaps
    /// count as closed.
    pub fn limit(model: &AnalysisModel, flow: Flow) -> Result<Self, ModelError> {
        model.check_limit_analysis()?;
        Self::build(model, Kind::Limit(flow))
    }

    /// Builds the elastic program in which bodies without a yield strength are rigid: a measure of
    /// how far velocities of limit analysis are apart.
    pub fn around_rigid_bodies(model: &AnalysisModel) -> Result<Self, ModelError> {
        Self::build(model, Kind::AroundRigidBodies)
    }

    fn build(model: &AnalysisModel, kind: Kind) -> Result<Self, ModelError> {
        let space = Tet10Space::new(&model.mesh);
        let pieces = match kind {
            Kind::Limit(_) | Kind::AroundRigidBodies => RigidPieces::unyielding(model),
            Kind::Elastic | Kind::Hencky(_) => RigidPieces::default(),
        };
        let (map, rigid) =
            rigid_motions::number_unknowns(model, &Points { model, space: &space }, &pieces)?;
        let materials = model.stiffnesses();
        let radii = model.yield_radii();
        // radius of the yield surface and kind of the element of a tet that may flow
        let flow_of = |e: usize| -> Option<(f64, Flow)> {
            let radius = radii[model.mesh.tet_body[e] as usize]?;
            match kind {
                Kind::Elastic | Kind::AroundRigidBodies => None,
                Kind::Hencky(flow) => flow[e].map(|f| (radius, f)),
                Kind::Limit(flow) => Some((radius, flow)),
            }
        };
        let limit = matches!(kind, Kind::Limit(_));
        let yields = (0..model.mesh.tets.len()).any(|e| flow_of(e).is_some());
        let forces = model.body_forces(Loads::ALL);
        let dofs = |e: usize| {
            let nodes = space.tet(&model.mesh, e);
            std::array::from_fn(|i| 3 * nodes[i / 3] + i % 3)
        };
        // the element of a body that yields
        let flowing = |e: usize| {
            let body = model.mesh.tet_body[e] as usize;
            flow_of(e).map(|(radius, flow)| YieldingTet10 {
                corners: model.mesh.corners(e),
                volume: model.mesh.volume(e),
                material: materials[body],
                radius,
                body_force: forces[body],
                split: flow == Flow::Split,
                rule: if limit { Rule::TenPoints } else { Rule::Hencky },
            })
        };
        // rigid-plastic elements leave nothing in P
        let assembled = if limit { 0 } else { model.mesh.tets.len() };
        let mut p = assemble::<30, ModelError>(assembled, &map, dofs, |e| {
            let body = model.mesh.tet_body[e] as usize;
            Ok(match flowing(e) {
                Some(element) => element.outer_stiffness(),
                None if pieces.contains(e) => Box::new([[0.0; 30]; 30]),
                None => {
                    tet10::stiffness(&model.mesh.corners(e), model.mesh.volume(e), &materials[body])
                }
            })
        })?;
        let splits = if limit { Inside::Flow } else { Inside::Split };
        let inside = |e: usize| match flow_of(e) {
            Some((_, Flow::Split)) => splits,
            _ => Inside::Plain,
        };
        let forces_of = |loads| shared_forces(model, &space, &map, &rigid, &inside, loads);
        let mut f = forces_of(if limit { Loads::DEAD } else { Loads::ALL });
        cuts::add_preload(model, &map, &mut f);
        let mut stiffness = Vec::new();
        let weld_faces: Vec<(f64, &FacePair)> = match kind {
            Kind::AroundRigidBodies => Vec::new(),
            _ => model.weld_faces().collect(),
        };
        if yields || !pieces.is_empty() || !weld_faces.is_empty() {
            stiffness = p.diagonal();
            let mut beside = vec![0.0; map.full()];
            for e in 0..model.mesh.tets.len() {
                let missing: [f64; 30] = match flowing(e) {
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
                dofs(e).into_iter().zip(missing).for_each(|(d, k)| beside[d] += k);
            }
            map.reduce_diagonal(&beside).iter().zip(&mut stiffness).for_each(|(d, s)| *s += d);
        }
        hold(&mut p, &free_mode_pins(model, &space, &map, &rigid, &pieces), &stiffness);
        let mut program = ConicProgram {
            p,
            q: f.iter().map(|x| -x).collect(),
            stiffness,
            ..ConicProgram::default()
        };
        program.g.ncols = map.n;
        let mut points = Vec::new();
        for mut point in control_points(model, &space) {
            if limit {
                point.gap = 0.0;
            }
            if push_cone(&mut program, &map, &point) {
                points.push(point);
            }
        }
        map.frozen.iter().for_each(|&(k, closure)| program.freeze(k, closure));
        let (mut own, mut split) = (Vec::new(), Vec::new());
        let tets = model.mesh.tets.len();
        if yields || !weld_faces.is_empty() {
            split = (0..tets).map(|e| matches!(flow_of(e), Some((_, Flow::Split)))).collect();
            own = append(&mut program, tets + weld_faces.len(), |e| {
                if let Some(weld) = e.checked_sub(tets) {
                    let (strength, face) = weld_faces[weld];
                    return Ok(weld_face::element(
                        &map,
                        strength,
                        &weld_face::kinematic_jumps(&space, face, true),
                    ));
                }
                let columns = || map.columns(&dofs(e));
                Ok::<_, ModelError>(flowing(e).map(|element| element.element(&columns())))
            })?;
        }
        if limit {
            program.add_load_factor(constraints::that_work(forces_of(Loads::LIVE))?);
        }
        Ok(Self { program, space, map, rigid, points, own, split })
    }
}

impl Kinematic {
    /// Displacements (velocities in limit analysis) of the nodes from the program's unknowns.
    pub fn nodal(&self, x: &[f64]) -> Vec<V3> {
        self.map.expand(x).chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect()
    }

    /// The Bernstein coefficients of the jump on every weld face, three rows each, on the unknowns
    /// that elements share.
    pub fn weld_rows(&self, model: &AnalysisModel) -> Csr {
        let faces = model.weld_faces();
        weld_face::rows(
            &self.map,
            faces.flat_map(|(_, f)| weld_face::kinematic_jumps(&self.space, f, false)),
        )
    }

    /// Loads on the unknowns that elements share, in limit analysis: their product with velocities
    /// is the power \[N\].
    ///
    /// Bodies with a yield strength are made of `flow` elements, the inner velocities of split ones
    /// as in [`split_flow`].
    pub fn limit_forces(&self, model: &AnalysisModel, flow: Flow, loads: Loads) -> Vec<f64> {
        let radii = model.yield_radii();
        let inside = |e: usize| match (radii[model.mesh.tet_body[e] as usize], flow) {
            (Some(_), Flow::Split) => Inside::Flow,
            _ => Inside::Plain,
        };
        shared_forces(model, &self.space, &self.map, &self.rigid, &inside, loads)
    }

    /// The shift with the given values at the control points, face by face; points that cannot move
    /// have none.
    pub fn cone_shift(&self, model: &AnalysisModel, values: &[f64]) -> ConeShift {
        let of: BTreeMap<_, f64> =
            self.points.iter().zip(values).map(|(p, s)| (p.key(), *s)).collect();
        let value = |p: ControlPoint| of.get(&p.key()).copied().unwrap_or(0.0);
        ConeShift {
            faces: points_of_faces(model, &self.space).into_iter().map(|f| f.map(value)).collect(),
        }
    }

    /// A displacement that closes the frozen cuts with little strain, from which a solver measures
    /// the unknowns; empty: there are none.
    pub fn closed(&self, model: &AnalysisModel) -> Vec<f64> {
        let mut tet = vec![0; self.space.nodes.len()];
        for e in 0..model.mesh.tets.len() {
            self.space.tet(&model.mesh, e).into_iter().for_each(|n| tet[n] = e);
        }
        cuts::spread(model, &self.map, tet.into_iter().zip(self.space.nodes.iter().copied()))
    }

    /// The rigid motions that only contact resists.
    pub fn contact_modes(&self, model: &AnalysisModel) -> Vec<ContactMode> {
        let part = model.node_parts();
        let points: Vec<(usize, V3)> = self
            .space
            .nodes
            .iter()
            .enumerate()
            .map(|(i, x)| (part[self.space.a_vertex(i)] as usize, *x))
            .collect();
        contact_modes(model, &self.map, &points)
    }
}

/// Adds the cone `(g_N + g₀, μ g_T) ∈ K³` (or `g_N + g₀ ≥ 0`) of a control point; false when
/// nothing of it can move.
fn push_cone(program: &mut ConicProgram, map: &DofMap, point: &ControlPoint) -> bool {
    let (t1, t2) = vec3::tangents(point.normal);
    let direction = |n: V3, factor: f64| {
        let mut full = Vec::new();
        for (i, &w) in point.weights().iter().enumerate() {
            for d in 0..3 {
                if let Some(b) = point.b {
                    full.push((3 * b[i] + d, factor * w * n[d]));
                }
                full.push((3 * point.a[i] + d, -factor * w * n[d]));
            }
        }
        map.row(&full)
    };
    let normal = direction(point.normal, 1.0);
    let slip = [direction(t1, point.mu), direction(t2, point.mu)];
    let rows = [&normal, &slip[0], &slip[1]];
    push_rows(program, &rows, point.mu, point.gap)
}

/// Adds the rows of one contact cone; false (and nothing added) when all of them are empty.
pub fn push_rows(
    program: &mut ConicProgram,
    rows: &[&Vec<(u32, f64)>; 3],
    mu: f64,
    offset: f64,
) -> bool {
    let used = if mu > 0.0 { 3 } else { 1 };
    if rows[..used].iter().all(|r| r.is_empty()) {
        return false;
    }
    for (i, row) in rows[..used].iter().enumerate() {
        program.g.push_row(row);
        program.h.push(if i == 0 { offset } else { 0.0 });
    }
    program.cones.push(if mu > 0.0 { Cone::SecondOrder(3) } else { Cone::NonNegative });
    true
}

/// Holds one vertex displacement per free rigid motion.
fn free_mode_pins(
    model: &AnalysisModel,
    space: &Tet10Space,
    map: &DofMap,
    rigid: &[RigidMotions],
    pieces: &RigidPieces,
) -> Vec<usize> {
    if model.free_modes.is_empty() {
        return Vec::new();
    }
    let part = model.node_parts();
    let motions = model
        .free_modes
        .iter()
        .map(|mode| {
            let motion = |node: usize| {
                let vertex = space.a_vertex(node);
                rigid_displacement(
                    &mode.motions[part[vertex] as usize],
                    [0.0; 3],
                    space.nodes[node],
                )
            };
            let mut x = vec![0.0; map.n];
            if !pieces.is_empty() {
                // a part may be rigid as a whole, with no unknown but its motion
                let nearest = rigid_motions::nearest_unknowns(map, rigid, |i| motion(i / 3)[i % 3]);
                x[map.plain..].copy_from_slice(&nearest[map.plain..]);
            }
            for v in 0..space.vertices {
                let u = motion(v);
                for d in 0..3 {
                    if let Some(k) = map.own(3 * v + d) {
                        x[k] = u[d];
                    }
                }
            }
            x
        })
        .collect();
    constraints::pins(motions, &[])
}

/// Stiffens the given unknowns by the mean of `stiffness` (empty: P's diagonal); their force is
/// zero, so their value becomes zero.
pub fn hold(p: &mut crate::programs::conic::SymmetricCsc, unknowns: &[usize], stiffness: &[f64]) {
    let diagonal = if stiffness.is_empty() { p.diagonal() } else { stiffness.to_vec() };
    let mean = diagonal.iter().sum::<f64>() / diagonal.len().max(1) as f64;
    unknowns.iter().for_each(|&k| p.add_diagonal(k, mean));
}
