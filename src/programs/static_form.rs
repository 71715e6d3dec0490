//! The static program: super-elements condensed to displacements of their faces, traction cones at
//! face vertices.
//!
//! `min ½ vᵀKv − fᵀv` over face displacements v, the multipliers of traction equilibrium; its
//! optimal value is −Π_c of a statically admissible stress field, a lower bound of the exact
//! potential energy. Cones bound the mass-weighted jumps `Σ_b M_ab (v_B − v_A)_b + ∫ φ_a g₀ n`,
//! conjugate to the traction at face vertex a.

use crate::elements::batch::{NONE, YIELD_ROWS};
use crate::elements::hencky_static;
use crate::elements::super_element::{self, PARAMETERS, SuperElement, TRACTIONS};
use crate::math::mandel::Isotropic;
use crate::math::quadrature::{TRIANGLE_4, triangle_mass};
use crate::math::rigid_motion::rigid_displacement;
use crate::math::vec3::{self, V3};
use crate::mesh::TetMesh;
use crate::mesh::numbering::FaceNumbering;
use crate::model::ModelError;
use crate::model::analysis::{AnalysisModel, BoundaryFace, ContactLaw, FacePair};
use crate::model::loads::{Loads, face_corners};
use crate::model::opening::bernstein_at;
use crate::programs::assemble::assemble;
use crate::programs::conic::{ConicProgram, Csr};
use crate::programs::constraints::{self, FacePoints};
use crate::programs::contact_modes::{ContactMode, contact_modes};
use crate::programs::cuts;
use crate::programs::dofs::DofMap;
use crate::programs::kinematic::{hold, push_rows};
use crate::programs::rigid_motions::{self, RigidMotions, RigidPieces};
use crate::programs::weld_face::{self, Jump};
use crate::programs::yielding_elements::append;
use rayon::prelude::*;

/// Geometry shared by the static program and the recovery of its stresses.
pub struct SuperElements<'a> {
    model: &'a AnalysisModel,
    /// The faces, each with 9 displacement unknowns (3 vertices in increasing node order × 3
    /// components).
    pub faces: FaceNumbering,
    materials: Vec<Isotropic>,
    body: Vec<V3>,
    origin: V3,
}

impl<'a> SuperElements<'a> {
    /// Numbers the faces of the model's mesh.
    pub fn new(model: &'a AnalysisModel) -> Self {
        // the particular stress of a body force vanishes at the mesh's first node: small numbers,
        // any origin of axes
        let origin = model.mesh.nodes.first().copied().unwrap_or_default();
        Self {
            model,
            faces: FaceNumbering::new(&model.mesh),
            materials: model.stiffnesses(),
            body: model.body_forces(Loads::ALL),
            origin,
        }
    }

    /// The same elements under other loads: their particular stress is that of the body forces
    /// among `loads`.
    pub fn under(self, loads: Loads) -> Self {
        Self { body: self.model.body_forces(loads), ..self }
    }

    /// Force per volume of each body \[N/mm³\].
    pub fn body_forces(&self) -> &[V3] {
        &self.body
    }

    /// True when some body bears a force.
    fn has_body_forces(&self) -> bool {
        self.body.iter().any(|b| *b != [0.0; 3])
    }

    /// The element of tet `e`.
    pub fn element(&self, e: usize) -> Result<SuperElement, ModelError> {
        let corners = self.model.mesh.corners(e);
        let body = self.model.mesh.tet_body[e] as usize;
        let force = self.body[body];
        let force = (force != [0.0; 3]).then_some((force, self.origin));
        SuperElement::new(corners, self.materials[body], force).ok_or_else(|| {
            let c = super_element::centroid(&corners);
            ModelError::FlatTet { tet: e, x: c[0], y: c[1], z: c[2] }
        })
    }

    /// Full unknowns of tet `e` in the element's order.
    pub fn dofs(&self, e: usize) -> [usize; TRACTIONS] {
        let mut d = [0; TRACTIONS];
        for k in 0..4 {
            let at = self.faces.positions(&self.model.mesh, e, k);
            for p in 0..3 {
                for c in 0..3 {
                    d[9 * k + 3 * p + c] = 9 * self.faces.of_tet[e][k] as usize + 3 * at[p] + c;
                }
            }
        }
        d
    }

    /// Part a face belongs to.
    pub fn part(&self, face: usize) -> usize {
        self.model.tet_part[self.faces.tets[face].0 as usize] as usize
    }

    /// The model the elements belong to.
    pub fn model(&self) -> &AnalysisModel {
        self.model
    }

    /// First full unknown of each vertex of a triangle that is local face `face.local` of
    /// `face.tet`; `nodes` gives the order.
    pub fn vertex_dofs(&self, face: &BoundaryFace, nodes: [u32; 3]) -> [usize; 3] {
        let f = self.faces.of_tet[face.tet as usize][face.local as usize] as usize;
        nodes.map(|n| {
            9 * f
                + 3 * self.faces.nodes[f]
                    .iter()
                    .position(|m| *m == n)
                    .expect("the nodes are those of the face")
        })
    }
}

struct Points<'a> {
    mesh: &'a TetMesh,
    faces: &'a FaceNumbering,
}

impl FacePoints for Points<'_> {
    fn points(&self, face: &BoundaryFace) -> Vec<usize> {
        let f = self.faces.of_tet[face.tet as usize][face.local as usize] as usize;
        vec![3 * f, 3 * f + 1, 3 * f + 2]
    }
    fn tet_points(&self, tet: usize) -> Vec<usize> {
        self.faces.of_tet[tet].iter().flat_map(|&f| [0, 1, 2].map(|p| 3 * f as usize + p)).collect()
    }
    fn pairs(&self, face: &FacePair) -> Vec<[usize; 2]> {
        let side = |face: &BoundaryFace, nodes: [u32; 3]| {
            let f = self.faces.of_tet[face.tet as usize][face.local as usize] as usize;
            let at = |n: u32| self.faces.nodes[f].iter().position(|m| *m == n);
            nodes.map(|n| 3 * f + at(n).expect("the nodes are those of the face"))
        };
        side(&face.a, face.nodes_a)
            .into_iter()
            .zip(side(&face.b, face.nodes_b))
            .map(|(a, b)| [a, b])
            .collect()
    }
    fn position(&self, point: usize) -> V3 {
        self.mesh.nodes[self.faces.nodes[point / 3][point % 3] as usize]
    }
    fn count(&self) -> usize {
        3 * self.faces.nodes.len()
    }
    fn block(&self, point: usize) -> u32 {
        (point / 3) as u32
    }
}

/// A vertex of a contact face: where one traction cone sits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactVertex {
    /// Which contact it belongs to: interfaces first, then contacts with the ground.
    pub contact: usize,
    /// Unit normal out of side A.
    pub normal: V3,
    /// Friction coefficient.
    pub mu: f64,
    /// First full unknown of each vertex on side A; this cone's vertex is `index`.
    pub a: [usize; 3],
    /// The same on side B; `None`: rigid ground.
    pub b: Option<[usize; 3]>,
    /// Which vertex of the face.
    pub index: usize,
    /// Area of the face \[mm²\].
    pub area: f64,
    /// `∫ φ_a (g₀ + s)`, s the shift where there is one \[mm³\].
    pub gap: f64,
}

impl ContactVertex {
    /// True when it is the same vertex of the same face.
    fn is_at(&self, other: &Self) -> bool {
        (self.contact, self.a, self.index) == (other.contact, other.a, other.index)
    }
}

/// Rows of a contact cone.
fn contact_rows(mu: f64) -> usize {
    if mu > 0.0 { 3 } else { 1 }
}

/// The static program of a model.
pub struct Static<'a> {
    /// Its conic program.
    pub program: ConicProgram,
    /// Its elements.
    pub elements: SuperElements<'a>,
    /// Full face displacements from the program's unknowns.
    pub map: DofMap,
    /// Unknowns of the rigid faces and bodies.
    pub rigid: Vec<RigidMotions>,
    /// The face vertex of each contact cone; the cones of yielding elements follow.
    pub vertices: Vec<ContactVertex>,
    /// Where the unknowns of each element's own start, after those of the faces, and of each weld
    /// face behind them; empty without plasticity and welds.
    pub own: Vec<usize>,
    /// The mass-weighted jumps at the vertices of every weld face, three rows each, on the unknowns
    /// of the faces.
    pub welds: Csr,
    /// Loads on the program's unknowns, without the relaxation of body forces \[N\]: what tractions
    /// must balance.
    pub loads: Vec<f64>,
    /// Unknowns held against free rigid motions.
    pub pinned: Vec<usize>,
    /// Radius of the yield surface of each tet as the program has it \[MPa\]; `None`: it stays
    /// elastic.
    radii: Vec<Option<f64>>,
}

fn contact_vertices(elements: &SuperElements) -> Vec<ContactVertex> {
    let model = elements.model;
    let mut out = Vec::new();
    let mut number = 0;
    let mut face = |contact: usize,
                    law: &ContactLaw,
                    corners: &[V3; 3],
                    a: [usize; 3],
                    b: Option<[usize; 3]>| {
        let vector = vec3::area_vector(corners);
        let area = vec3::norm(vector);
        let opening = model.opening(number, law, corners);
        number += 1;
        for index in 0..3 {
            let gap = TRIANGLE_4
                .iter()
                .map(|(l, w)| w * area * l[index] * bernstein_at(&opening, *l))
                .sum();
            let normal = vec3::scale(1.0 / area, vector);
            out.push(ContactVertex { contact, normal, mu: law.mu, a, b, index, area, gap });
        }
    };
    for (contact, interface) in model.interfaces.iter().enumerate() {
        for f in &interface.faces {
            let corners = f.nodes_a.map(|n| model.mesh.nodes[n as usize]);
            let b = elements.vertex_dofs(&f.b, f.nodes_b);
            face(contact, &interface.law, &corners, elements.vertex_dofs(&f.a, f.nodes_a), Some(b));
        }
    }
    for (contact, ground) in (model.interfaces.len()..).zip(&model.ground) {
        for f in &ground.faces {
            let nodes = crate::model::loads::face_nodes(&model.mesh, f);
            face(
                contact,
                &ground.law,
                &face_corners(&model.mesh, f),
                elements.vertex_dofs(f, nodes),
                None,
            );
        }
    }
    out
}

/// Mass-weighted surface loads on the full unknowns \[N\].
fn face_forces(elements: &SuperElements, loads: Loads) -> Vec<f64> {
    let model = elements.model;
    let mut f = vec![0.0; 9 * elements.faces.nodes.len()];
    for load in model.surface_loads.iter().filter(|l| loads.share(l.dead) != 0.0) {
        let share = loads.share(load.dead);
        for face in &load.faces {
            let corners = face_corners(&model.mesh, face);
            let dofs =
                elements.vertex_dofs(face, crate::model::loads::face_nodes(&model.mesh, face));
            let vector = vec3::area_vector(&corners);
            let area = vec3::norm(vector);
            let normal = vec3::scale(1.0 / area, vector);
            let t = corners.map(|x| vec3::scale(share, load.at(x, normal)));
            for a in 0..3 {
                for b in 0..3 {
                    (0..3).for_each(|d| f[dofs[a] + d] += triangle_mass(a, b) * area * t[b][d]);
                }
            }
        }
    }
    f
}

/// Surface loads and actions of rigid faces on the program's unknowns \[N\].
fn forces(
    elements: &SuperElements,
    map: &DofMap,
    rigid: &[RigidMotions],
    loads: Loads,
) -> Vec<f64> {
    let mut f = map.reduce(&face_forces(elements, loads));
    rigid_motions::add_rigid_actions(elements.model, rigid, loads, &mut f);
    f
}

impl<'a> Static<'a> {
    /// Builds the elastic program: no body yields.
    pub fn new(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Self::build(model, vec![None; model.mesh.tets.len()], false)
    }

    /// Builds the elastic, perfectly plastic program (Hencky): in bodies with a yield strength the
    /// stress parameters stay unknowns (maximised over) and every point of their linear stress
    /// satisfies von Mises; the others are condensed as in the elastic program.
    pub fn with_plasticity(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Self::build(model, radii_of_tets(model), false)
    }

    /// The same with the yield condition only where `yields` says so, every radius `1 − room` of
    /// its own: the stress of an interior-point method, brought into equilibrium to rounding, has
    /// that room to stay inside.
    ///
    /// The other tets stay elastic: a lower bound follows only where their stress is found
    /// admissible all the same.
    pub fn with_plasticity_in(
        model: &'a AnalysisModel,
        yields: &[bool],
        room: f64,
    ) -> Result<Self, ModelError> {
        let of = |(radius, yields): (Option<f64>, &bool)| {
            radius.filter(|_| *yields).map(|r| (1.0 - room) * r)
        };
        Self::build(model, radii_of_tets(model).into_iter().zip(yields).map(of).collect(), false)
    }

    /// Builds the program of limit analysis: the largest load factor whose loads, with the dead
    /// ones, some stress within the yield strength balances. Bodies without a yield strength are
    /// rigid: their stress is left out, what acts on them is balanced as a whole. Initial gaps
    /// count as closed.
    pub fn limit(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        model.check_limit_analysis()?;
        Self::build(model, radii_of_tets(model), true)
    }

    /// `radii`: radius of the yield surface of each tet; `limit`: nothing is elastic.
    fn build(
        model: &'a AnalysisModel,
        radii: Vec<Option<f64>>,
        limit: bool,
    ) -> Result<Self, ModelError> {
        let counted = if limit { Loads::DEAD } else { Loads::ALL };
        let elements = SuperElements::new(model).under(counted);
        let pieces = if limit { RigidPieces::unyielding(model) } else { RigidPieces::default() };
        let points = Points { mesh: &model.mesh, faces: &elements.faces };
        let (map, rigid) = rigid_motions::number_unknowns(model, &points, &pieces)?;
        let radius = |e: usize| radii[e];
        let elastic: Vec<usize> =
            (0..model.mesh.tets.len()).filter(|&e| !limit && radius(e).is_none()).collect();
        let mut p = assemble::<TRACTIONS, ModelError>(
            elastic.len(),
            &map,
            |i| elements.dofs(elastic[i]),
            |i| Ok(elements.element(elastic[i])?.stiffness()),
        )?;
        let mut loads = forces(&elements, &map, &rigid, counted);
        cuts::add_preload(model, &map, &mut loads);
        let mut q: Vec<f64> = loads.iter().map(|x| -x).collect();
        let mut c = 0.0;
        if elements.has_body_forces() {
            let terms: Vec<([f64; TRACTIONS], f64)> = (0..model.mesh.tets.len())
                .into_par_iter()
                .map(|e| {
                    let element = elements.element(e)?;
                    let dense = limit || radius(e).is_some();
                    Ok(if dense { element.particular_terms() } else { element.body_terms() })
                })
                .collect::<Result<_, ModelError>>()?;
            let mut full = vec![0.0; map.full()];
            for (e, (linear, constant)) in terms.iter().enumerate() {
                c += constant;
                for (d, x) in elements.dofs(e).into_iter().zip(linear) {
                    full[d] += x;
                }
            }
            map.reduce(&full).iter().zip(&mut q).for_each(|(x, q)| *q += x);
        }
        let pinned = pinned(&elements, &map, &rigid, &pieces);
        let yields = elastic.len() < model.mesh.tets.len();
        let weld_faces: Vec<(f64, Vec<Jump>)> = model
            .weld_faces()
            .map(|(strength, f)| (strength, weld_face::static_jumps(&elements, f)))
            .collect();
        let stiffness = match (yields, weld_faces.is_empty()) {
            (true, _) => elastic_diagonal(&elements, &map)?,
            (false, false) => p.diagonal(),
            (false, true) => Vec::new(),
        };
        hold(&mut p, &pinned, &stiffness);
        let mut program = ConicProgram { p, q, c, stiffness, ..ConicProgram::default() };
        program.g.ncols = map.n;
        let mut vertices = Vec::new();
        for mut v in contact_vertices(&elements) {
            if limit {
                v.gap = 0.0;
            }
            if push_cone(&mut program, &map, &v) {
                vertices.push(v);
            }
        }
        map.frozen.iter().for_each(|&(k, closure)| program.freeze(k, closure));
        let mut own = Vec::new();
        let tets = model.mesh.tets.len();
        if yields || !weld_faces.is_empty() {
            own = append(&mut program, tets + weld_faces.len(), |e| {
                if let Some(weld) = e.checked_sub(tets) {
                    let (strength, jumps) = &weld_faces[weld];
                    return Ok(weld_face::element(&map, *strength, jumps));
                }
                let Some(radius) = radius(e) else { return Ok(None) };
                let columns = map.columns(&elements.dofs(e));
                Ok::<_, ModelError>(Some(hencky_static::element(
                    &elements.element(e)?,
                    &columns,
                    radius,
                    !limit,
                )))
            })?;
        }
        if limit {
            // the constant belongs to the elastic energy of body forces
            program.c = 0.0;
            program.add_load_factor(constraints::that_work(forces(
                &elements,
                &map,
                &rigid,
                Loads::LIVE,
            ))?);
        }
        let welds = weld_face::rows(&map, weld_faces.into_iter().flat_map(|f| f.1));
        Ok(Self { program, elements, map, rigid, vertices, loads, pinned, own, welds, radii })
    }
}

/// Radius of the yield surface of each tet.
fn radii_of_tets(model: &AnalysisModel) -> Vec<Option<f64>> {
    let radii = model.yield_radii();
    model.mesh.tet_body.iter().map(|b| radii[*b as usize]).collect()
}

/// Adds the cone of one contact vertex; false when nothing of it can move.
fn push_cone(program: &mut ConicProgram, map: &DofMap, v: &ContactVertex) -> bool {
    let (t1, t2) = vec3::tangents(v.normal);
    let direction = |n: V3, factor: f64| {
        let mut full = Vec::new();
        for b in 0..3 {
            let w = factor * triangle_mass(v.index, b) * v.area;
            for d in 0..3 {
                if let Some(side) = v.b {
                    full.push((side[b] + d, w * n[d]));
                }
                full.push((v.a[b] + d, -w * n[d]));
            }
        }
        map.row(&full)
    };
    let normal = direction(v.normal, 1.0);
    let slip = [direction(t1, v.mu), direction(t2, v.mu)];
    push_rows(program, &[&normal, &slip[0], &slip[1]], v.mu, v.gap)
}

/// The motion of every part as displacements of the program's own unknowns (motions of rigid faces
/// are left at zero).
pub fn part_motions(
    elements: &SuperElements,
    map: &DofMap,
    motion_of_part: impl Fn(usize) -> [f64; 6],
) -> Vec<f64> {
    let mesh = &elements.model.mesh;
    let mut x = vec![0.0; map.n];
    for (f, nodes) in elements.faces.nodes.iter().enumerate() {
        let motion = motion_of_part(elements.part(f));
        for (p, &n) in nodes.iter().enumerate() {
            let u = rigid_displacement(&motion, [0.0; 3], mesh.nodes[n as usize]);
            for d in 0..3 {
                if let Some(k) = map.own(9 * f + 3 * p + d) {
                    x[k] = u[d];
                }
            }
        }
    }
    x
}

/// One face displacement for each free rigid motion.
fn pinned(
    elements: &SuperElements,
    map: &DofMap,
    rigid: &[RigidMotions],
    pieces: &RigidPieces,
) -> Vec<usize> {
    let modes = elements.model.free_modes.iter().map(|mode| {
        let mut x = part_motions(elements, map, |part| mode.motions[part]);
        if !pieces.is_empty() {
            // a part may be rigid as a whole, with no unknown but its motion
            let nearest = rigid_motions::nearest_unknowns(map, rigid, |i| {
                let node = elements.faces.nodes[i / 9][i % 9 / 3] as usize;
                let motion = &mode.motions[elements.part(i / 9)];
                rigid_displacement(motion, [0.0; 3], elements.model.mesh.nodes[node])[i % 3]
            });
            x[map.plain..].copy_from_slice(&nearest[map.plain..]);
        }
        x
    });
    constraints::pins(modes.collect(), &[])
}

/// Diagonal of the stiffness of all elements, elastic: yielding ones have none in P.
fn elastic_diagonal(elements: &SuperElements, map: &DofMap) -> Result<Vec<f64>, ModelError> {
    let diagonals: Vec<[f64; TRACTIONS]> = (0..elements.model.mesh.tets.len())
        .into_par_iter()
        .map(|e| {
            let k = elements.element(e)?.stiffness();
            Ok(std::array::from_fn(|i| k[i][i]))
        })
        .collect::<Result<_, ModelError>>()?;
    let mut full = vec![0.0; map.full()];
    for (e, diagonal) in diagonals.iter().enumerate() {
        elements.dofs(e).into_iter().zip(diagonal).for_each(|(d, k)| full[d] += k);
    }
    Ok(map.reduce_diagonal(&full))
}

impl Static<'_> {
    /// What the yield conditions of each tet hold the optimum down by, from the rows' multipliers
    /// z: they are velocities, and this is their dissipation. Zero in bodies that never yield.
    ///
    /// # Units
    /// Those of the objective; in limit analysis of proportional loads, parts of the load factor
    /// that add up to it (welds apart).
    pub fn yield_shares(&self, z: &[f64]) -> Vec<f64> {
        let mut shares = vec![0.0; self.elements.model.mesh.tets.len()];
        for batch in self.program.elements.batches.iter() {
            let rows = YIELD_ROWS * batch.shape.points();
            for (own, first) in
                batch.own.into_iter().zip(batch.rows).filter(|(own, _)| *own != NONE)
            {
                // tets without unknowns of their own share their start with the next that has some;
                // welds follow the tets
                let e = self.own.partition_point(|start| *start <= own as usize) - 1;
                if let Some(share) = shares.get_mut(e) {
                    let first = first as usize;
                    *share = (first..first + rows).map(|r| self.program.h[r] * z[r]).sum();
                }
            }
        }
        shares
    }

    /// Stress parameters of every element from the unknowns of a program, as
    /// [`SuperElement::stress`] takes them; zero in bodies that never yield.
    pub fn parameters(&self, x: &[f64]) -> Result<Vec<[f64; PARAMETERS]>, ModelError> {
        (0..self.elements.model.mesh.tets.len())
            .into_par_iter()
            .map(|e| {
                Ok(self
                    .own_parameters(e, &self.elements.element(e)?, x)
                    .unwrap_or([0.0; PARAMETERS]))
            })
            .collect()
    }

    /// Stress parameters of every element from the unknowns of an elastic, perfectly plastic
    /// program: an element's own, or those that its faces' displacements strain it to.
    pub fn all_parameters(&self, x: &[f64]) -> Result<Vec<[f64; PARAMETERS]>, ModelError> {
        let v = self.map.expand(x);
        (0..self.elements.model.mesh.tets.len())
            .into_par_iter()
            .map(|e| {
                let element = self.elements.element(e)?;
                let strained = || element.parameters(&self.elements.dofs(e).map(|d| v[d]), true);
                Ok(self.own_parameters(e, &element, x).unwrap_or_else(strained))
            })
            .collect()
    }

    /// The parameters of an element that has its own unknowns.
    fn own_parameters(
        &self,
        e: usize,
        element: &SuperElement,
        x: &[f64],
    ) -> Option<[f64; PARAMETERS]> {
        let own = x.get(*self.own.get(e)?..*self.own.get(e + 1)?).filter(|own| !own.is_empty())?;
        let unit = hencky_static::parameter_unit(element, self.radii[e]?);
        Some(std::array::from_fn(|a| unit * own[a]))
    }

    /// Surface loads and actions of rigid faces on the unknowns of the faces \[N\]: what the
    /// elements' tractions, those of particular stresses included, must balance.
    pub fn forces(&self, loads: Loads) -> Vec<f64> {
        forces(&self.elements, &self.map, &self.rigid, loads)
    }

    /// Mass-weighted tractions of the particular stresses of body forces on the unknowns of the
    /// faces \[N\].
    pub fn particular_forces(&self, loads: Loads) -> Result<Vec<f64>, ModelError> {
        let elements = SuperElements::new(self.elements.model).under(loads);
        let mut full = vec![0.0; self.map.full()];
        if elements.has_body_forces() {
            for e in 0..elements.model.mesh.tets.len() {
                let (tractions, _) = elements.element(e)?.particular_terms();
                elements.dofs(e).into_iter().zip(tractions).for_each(|(d, x)| full[d] += x);
            }
        }
        Ok(self.map.reduce(&full))
    }

    /// Tractions `σ n` of side A at the vertices of every weld face, from the program's unknowns,
    /// three components each \[MPa\].
    pub fn weld_tractions(&self, x: &[f64]) -> Vec<f64> {
        let model = self.elements.model;
        let first = model.mesh.tets.len();
        let own = |face: usize| {
            self.own.get(first + face..first + face + 2).map_or(&[][..], |own| &x[own[0]..own[1]])
        };
        let faces = model.weld_faces().enumerate();
        faces.flat_map(|(i, (strength, _))| weld_face::tractions(strength, 3, own(i))).collect()
    }

    /// Multipliers of every contact vertex of the model from those of this program, which leaves
    /// out cones where nothing can move: those are zero.
    pub fn spread_contact(&self, z: &[f64]) -> Vec<f64> {
        let mut rest = z;
        let mut own = self.vertices.iter().peekable();
        let all = contact_vertices(&self.elements).into_iter().flat_map(|v| {
            let dim = contact_rows(v.mu);
            if own.next_if(|o| o.is_at(&v)).is_none() {
                return vec![0.0; dim];
            }
            let (mine, others) = rest.split_at(dim.min(rest.len()));
            rest = others;
            mine.to_vec()
        });
        all.collect()
    }

    /// The other way round: multipliers of this program's contact cones among those of every
    /// contact vertex of the model.
    pub fn gather_contact(&self, all: &[f64]) -> Vec<f64> {
        let mut rest = all;
        let mut own = self.vertices.iter().peekable();
        let mut out = Vec::with_capacity(self.program.g.nrows());
        for v in contact_vertices(&self.elements) {
            let (here, others) = rest.split_at(contact_rows(v.mu).min(rest.len()));
            rest = others;
            if own.next_if(|o| o.is_at(&v)).is_some() {
                out.extend_from_slice(here);
            }
        }
        out
    }

    /// Multipliers that close the frozen cuts with little strain, as in the kinematic program;
    /// empty: there are none.
    pub fn closed(&self) -> Vec<f64> {
        let (model, faces) = (self.elements.model, &self.elements.faces);
        let of_face = |(f, nodes): (usize, &[u32; 3])| {
            let tet = faces.tets[f].0 as usize;
            nodes.map(|n| (tet, model.mesh.nodes[n as usize]))
        };
        cuts::spread(model, &self.map, faces.nodes.iter().enumerate().flat_map(of_face))
    }

    /// The rigid motions that only contact resists: along them the stiffness is zero and contact
    /// forces must balance the loads.
    pub fn contact_modes(&self) -> Vec<ContactMode> {
        let (model, faces) = (self.elements.model, &self.elements.faces);
        let points: Vec<(usize, V3)> = faces
            .nodes
            .iter()
            .enumerate()
            .flat_map(|(f, nodes)| {
                nodes.map(|n| (self.elements.part(f), model.mesh.nodes[n as usize]))
            })
            .collect();
        contact_modes(model, &self.map, &points)
    }
}
