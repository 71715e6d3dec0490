//! The static program: super-elements condensed to displacements of their faces, traction cones at
//! face vertices.
//!
//! `min ½ vᵀKv − fᵀv` over face displacements v, the multipliers of traction equilibrium. Its
//! optimal value is −Π_c of a statically admissible stress field, a lower bound of the exact
//! potential energy. The cones at the vertices of contact faces
//! ([`crate::programs::contact::static_contact`]) bound mass-weighted jumps.

use crate::elements::hencky_static;
use crate::elements::super_element::{PARAMETERS, SuperElement, TRACTIONS};
use crate::mesh::TetMesh;
use crate::mesh::numbering::FaceNumbering;
use crate::model::ModelError;
use crate::model::analysis::{AnalysisModel, BoundaryFace, FacePair, GroundContact};
use crate::model::loads::Loads;
use crate::programs::assemble::assemble;
use crate::programs::conic::{ConicProgram, Csr};
use crate::programs::constraints::{FacePoints, hold, working_live_loads};
use crate::programs::contact::cone::{self, Closing};
use crate::programs::contact::elastic_ground;
use crate::programs::contact::static_contact::ContactVertex;
use crate::programs::contact::static_contact::contact_vertices;
use crate::programs::contact_modes::{ContactMode, contact_modes};
use crate::programs::dofs::DofMap;
use crate::programs::loads::static_forces;
use crate::programs::rigid_motions::{self, RigidMotions, RigidPieces};
use crate::programs::super_elements::SuperElements;
use crate::programs::symmetric_sum::plus_entries;
use crate::programs::tied_points::TiedPoints;
use crate::programs::weld_face::{self, Jump};
use crate::programs::yielding_elements::append;
use crate::programs::{cuts, free_modes};
use bracket_base::math::vec3::V3;
use rayon::prelude::*;

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
    /// First own unknown of each element, then of each weld face; own unknowns follow those of the
    /// faces. Empty without plasticity and welds.
    pub own: Vec<usize>,
    /// The mass-weighted jumps at the vertices of every weld face as rows on the unknowns of the
    /// faces, three rows each.
    pub welds: Csr,
    /// Loads on the program's unknowns, which tractions must balance; without the relaxation of
    /// body forces \[N\].
    pub loads: Vec<f64>,
    /// Unknowns held against free rigid motions.
    pub pinned: Vec<usize>,
    /// Yield radius of each tet in the program, reduced by `room` \[MPa\]; `None`: it stays
    /// elastic.
    radii: Vec<Option<f64>>,
}

/// Kind of static program.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// No body yields, and no ground crushes.
    Elastic,
    /// Elastic, perfectly plastic.
    Plastic,
    /// Rigid-plastic: nothing is elastic.
    Limit,
}

/// The unknowns with what decides on them. `limit`: bodies without a yield strength are rigid.
fn numbering(
    model: &AnalysisModel,
    faces: &FaceNumbering,
    limit: bool,
) -> Result<(RigidPieces, DofMap, Vec<RigidMotions>), ModelError> {
    let pieces = if limit { RigidPieces::unyielding(model) } else { RigidPieces::default() };
    let points = Points { mesh: &model.mesh, faces };
    let tied = TiedPoints::new(model, &points, false);
    let (map, rigid) = rigid_motions::number_unknowns(model, &points, &pieces, &[], &tied, limit)?;
    Ok((pieces, map, rigid))
}

impl<'a> Static<'a> {
    /// Number of the unknowns that elements share, see [`crate::programs::Kinematic::unknowns`].
    pub fn unknowns(model: &AnalysisModel, limit: bool) -> Result<usize, ModelError> {
        let shared = numbering(model, &FaceNumbering::new(&model.mesh), limit)?.1.n;
        let gives_way =
            |g: &&GroundContact| if limit { g.strength.is_some() } else { g.stiffness.is_some() };
        let ground = model.ground.iter().filter(gives_way);
        Ok(shared + 3 * ground.map(|g| g.faces.len()).sum::<usize>())
    }

    /// Builds the elastic program: no body yields.
    pub fn new(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Self::build(model, vec![None; model.mesh.tets.len()], Kind::Elastic)
    }

    /// Builds the elastic, perfectly plastic program (Hencky). In bodies with a yield strength the
    /// stress parameters stay unknowns (maximised over), and every point of their linear stress
    /// satisfies von Mises. The other bodies are condensed as in the elastic program.
    pub fn with_plasticity(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Self::build(model, radii_of_tets(model), Kind::Plastic)
    }

    /// Builds the same program with the yield condition only in tets for which `yields` is true,
    /// every yield radius multiplied by `1 − room`. The stress of an interior-point method moves
    /// when it is brought into equilibrium to rounding; with that room it stays admissible.
    ///
    /// The other tets stay elastic: the result is a lower bound only if their stress turns out to
    /// be admissible.
    pub fn with_plasticity_in(
        model: &'a AnalysisModel,
        yields: &[bool],
        room: f64,
    ) -> Result<Self, ModelError> {
        let of = |(radius, yields): (Option<f64>, &bool)| {
            radius.filter(|_| *yields).map(|r| (1.0 - room) * r)
        };
        Self::build(
            model,
            radii_of_tets(model).into_iter().zip(yields).map(of).collect(),
            Kind::Plastic,
        )
    }

    /// Builds the program of limit analysis: the largest load factor whose loads, together with the
    /// dead loads, some stress within the yield strength balances. Bodies without a yield strength
    /// are rigid: they have no stress parameters, and the forces on each are balanced as a whole.
    /// Initial gaps count as closed.
    pub fn limit(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        model.check_limit_analysis()?;
        Self::build(model, radii_of_tets(model), Kind::Limit)
    }

    /// `radii`: radius of the yield surface of each tet.
    fn build(
        model: &'a AnalysisModel,
        radii: Vec<Option<f64>>,
        kind: Kind,
    ) -> Result<Self, ModelError> {
        let limit = kind == Kind::Limit;
        let counted = if limit { Loads::DEAD } else { Loads::ALL };
        let elements = SuperElements::new(model).under(counted);
        let (pieces, mut map, rigid) = numbering(model, &elements.faces, limit)?;
        let radius = |e: usize| radii[e];
        let elastic: Vec<usize> =
            (0..model.mesh.tets.len()).filter(|&e| !limit && radius(e).is_none()).collect();
        let yields = elastic.len() < model.mesh.tets.len();
        let mut contacts = contact_vertices(&elements);
        // the elastic, perfectly plastic program also corrects stresses of limit analysis
        let part = |c: &Closing| kind == Kind::Plastic || c.is_part(limit);
        contacts.iter_mut().for_each(|v| v.closing = v.closing.filter(part));
        map.append_closings(contacts.iter().filter(|v| v.closing.is_some()).count());
        let mut p = assemble::<TRACTIONS, ModelError>(
            elastic.len(),
            &map,
            |i| elements.dofs(elastic[i]),
            |i| Ok(elements.element(elastic[i])?.stiffness()),
        )?;
        let ground = elastic_ground::static_entries(model, &contacts, map.closings());
        if !ground.is_empty() {
            p = plus_entries(&p, ground);
        }
        let mut loads = static_forces(&elements, &map, &rigid, counted);
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
        let pinned = free_modes::static_pins(&elements, &map, &rigid, &pieces);
        let weld_faces: Vec<(f64, Vec<Jump>)> = model
            .weld_faces()
            .map(|(strength, f)| (strength, weld_face::static_jumps(&elements, f)))
            .collect();
        let stiffness = if yields {
            elastic_diagonal(&elements, &map)?
        } else if !weld_faces.is_empty() || !map.closings().is_empty() {
            p.diagonal()
        } else {
            Vec::new()
        };
        hold(&mut p, &pinned, &stiffness);
        let mut program = ConicProgram { p, q, c, stiffness, ..ConicProgram::default() };
        program.g.ncols = map.n;
        let mut vertices = Vec::new();
        let (mut closings, mut next) = (Vec::new(), map.closings());
        for mut v in contacts {
            if limit {
                v.gap = 0.0;
            }
            let (row, closing) = (program.g.nrows(), v.closing.and_then(|_| next.next()));
            let moves = v.push_cone(&mut program, &map, closing);
            closings.extend(v.closing.map(|c| (moves.then_some(row), c)));
            if moves {
                vertices.push(v);
            }
        }
        cuts::append_limits(model, &map, &mut program);
        cone::append_closings(&mut program, &map, &closings);
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
            // the constant is elastic energy of body forces, which limit analysis does not have
            program.c = 0.0;
            program.add_load_factor(working_live_loads(static_forces(
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

/// Diagonal of the elastic stiffness of all elements; P has no entries of yielding ones.
fn elastic_diagonal(elements: &SuperElements, map: &DofMap) -> Result<Vec<f64>, ModelError> {
    let diagonals: Vec<[f64; TRACTIONS]> = (0..elements.model().mesh.tets.len())
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
    /// Stress parameters of every element from the unknowns of a program, as
    /// [`SuperElement::stress`] takes them; zero in bodies that never yield.
    pub fn parameters(&self, x: &[f64]) -> Result<Vec<[f64; PARAMETERS]>, ModelError> {
        (0..self.elements.model().mesh.tets.len())
            .into_par_iter()
            .map(|e| {
                Ok(self
                    .own_parameters(e, &self.elements.element(e)?, x)
                    .unwrap_or([0.0; PARAMETERS]))
            })
            .collect()
    }

    /// Stress parameters of every element from the unknowns of an elastic, perfectly plastic
    /// program: own unknowns of yielding elements, for elastic ones computed from the displacements
    /// of their faces.
    pub fn all_parameters(&self, x: &[f64]) -> Result<Vec<[f64; PARAMETERS]>, ModelError> {
        let v = self.map.expand(x);
        (0..self.elements.model().mesh.tets.len())
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

    /// Surface loads and actions of rigid faces on the unknowns of the faces \[N\]. The tractions
    /// of the elements, those of particular stresses included, must balance them.
    pub fn forces(&self, loads: Loads) -> Vec<f64> {
        static_forces(&self.elements, &self.map, &self.rigid, loads)
    }

    /// Mass-weighted tractions of the particular stresses of body forces on the unknowns of the
    /// faces \[N\].
    pub fn particular_forces(&self, loads: Loads) -> Result<Vec<f64>, ModelError> {
        let elements = SuperElements::new(self.elements.model()).under(loads);
        let mut full = vec![0.0; self.map.full()];
        if elements.has_body_forces() {
            for e in 0..elements.model().mesh.tets.len() {
                let (tractions, _) = elements.element(e)?.particular_terms();
                elements.dofs(e).into_iter().zip(tractions).for_each(|(d, x)| full[d] += x);
            }
        }
        Ok(self.map.reduce(&full))
    }

    /// Tractions `σ n` of side A at the vertices of every weld face, from the program's unknowns,
    /// three components each \[MPa\].
    pub fn weld_tractions(&self, x: &[f64]) -> Vec<f64> {
        let model = self.elements.model();
        let first = model.mesh.tets.len();
        let own = |face: usize| {
            self.own.get(first + face..first + face + 2).map_or(&[][..], |own| &x[own[0]..own[1]])
        };
        let faces = model.weld_faces().enumerate();
        faces.flat_map(|(i, (strength, _))| weld_face::tractions(strength, 3, own(i))).collect()
    }

    /// Multipliers of every contact vertex of the model from those of this program. Vertices where
    /// nothing can move have no cone in the program; their multipliers are zero.
    pub fn spread_contact(&self, z: &[f64]) -> Vec<f64> {
        let mut rest = z;
        let mut own = self.vertices.iter().peekable();
        let all = contact_vertices(&self.elements).into_iter().flat_map(|v| {
            let dim = cone::rows(v.mu);
            if own.next_if(|o| o.is_at(&v)).is_none() {
                return vec![0.0; dim];
            }
            let (mine, others) = rest.split_at(dim.min(rest.len()));
            rest = others;
            mine.to_vec()
        });
        all.collect()
    }

    /// Multipliers of this program's contact cones from those of every contact vertex of the model
    /// (the inverse of [`Self::spread_contact`]).
    pub fn gather_contact(&self, all: &[f64]) -> Vec<f64> {
        let mut rest = all;
        let mut own = self.vertices.iter().peekable();
        let mut out = Vec::with_capacity(self.program.g.nrows());
        for v in contact_vertices(&self.elements) {
            let (here, others) = rest.split_at(cone::rows(v.mu).min(rest.len()));
            rest = others;
            if own.next_if(|o| o.is_at(&v)).is_some() {
                out.extend_from_slice(here);
            }
        }
        out
    }

    /// Unknowns of a displacement that closes the frozen cuts with little strain, as in the
    /// kinematic program. Empty without frozen cuts.
    pub fn closed(&self) -> Vec<f64> {
        let (model, faces) = (self.elements.model(), &self.elements.faces);
        let of_face = |(f, nodes): (usize, &[u32; 3])| {
            let tet = faces.tets[f].0 as usize;
            nodes.map(|n| (tet, model.mesh.nodes[n as usize]))
        };
        cuts::spread(model, &self.map, faces.nodes.iter().enumerate().flat_map(of_face))
    }

    /// The rigid motions that only contact resists. Along them the stiffness is zero, so contact
    /// forces must balance the loads.
    pub fn contact_modes(&self) -> Vec<ContactMode> {
        let (model, faces) = (self.elements.model(), &self.elements.faces);
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
