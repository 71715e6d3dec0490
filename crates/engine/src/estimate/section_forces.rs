//! Forces in a plane section of a body, from the stress of the lower bound and from the
//! displacement of the upper one.

use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::tractions::face_stress;
use crate::elements::space::Tet10Space;
use crate::elements::tet10::{strain_columns, vertex_strains};
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use bracket_base::math::mandel::{self, Isotropic, Mandel};
use bracket_base::math::quadrature::tetrahedron_mass;
use bracket_base::math::vec3::{self, V3};

/// Distance from the plane within which a vertex lies on it \[mm\].
const ON_PLANE: f64 = 1e-6;

/// A plane across a body on which its mesh has element faces, perpendicular to a coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionPlane {
    /// The body.
    pub body: u32,
    /// Normal axis, 0 = x, 1 = y, 2 = z.
    pub axis: usize,
    /// Coordinate of the plane \[mm\].
    pub at: f64,
}

/// On which side of the plane a tet with a face on it lies, and the local number of that face.
type Adjacent = (usize, usize, f64);

impl SectionPlane {
    /// Force of the part with larger coordinates on the other one \[N\], exact for the stress:
    /// tractions are linear on a face and equal on both of its sides. `None` where the mesh has no
    /// face of the body on the plane.
    pub fn of_stress(&self, model: &AnalysisModel, field: &StressField) -> Option<V3> {
        let below = self.adjacent(model).into_iter().filter(|a| a.2 < 0.0);
        let forces = below.map(|(tet, local, _)| {
            let corners = FACES[local].map(|i| model.mesh.corners(tet)[i]);
            let area = vec3::area_vector(&corners);
            let each = face_stress(field, tet, local).map(|s| mandel::traction(&s, area));
            vec3::scale(1.0 / 3.0, each.into_iter().fold([0.0; 3], vec3::add))
        });
        forces.reduce(vec3::add)
    }

    /// The same from the elastic stress of a displacement field \[N\]: the nodal forces on the
    /// plane, as the mean of its two sides. They differ by the contact forces on the rim of the
    /// plane, which belong to either. The error is of the order of that of an energy, not of that
    /// of a stress. `None` where the body may yield or has no face on the plane.
    pub fn of_displacement(
        &self,
        model: &AnalysisModel,
        space: &Tet10Space,
        field: &DisplacementField,
    ) -> Option<V3> {
        let material = &model.materials[model.body_material[self.body as usize] as usize];
        if material.fy.is_some() {
            return None;
        }
        let stiffness = Isotropic::new(material.e, material.nu);
        let on_plane = |x: V3| (x[self.axis] - self.at).abs() <= ON_PLANE;
        let mut sum = [0.0; 3];
        let mut met = false;
        for (tet, side) in self.touching(model) {
            let nodes = space.tet(&model.mesh, tet);
            let forces = nodal_forces(model, tet, &stiffness, &nodes.map(|n| field.u[n]));
            for (node, force) in nodes.into_iter().zip(forces) {
                if on_plane(space.nodes[node]) {
                    met = true;
                    sum = vec3::add(sum, vec3::scale(-0.5 * side, force));
                }
            }
        }
        met.then_some(sum)
    }

    /// The tets of the body with a vertex on the plane, each with its side: −1 or +1.
    fn touching<'a>(&'a self, model: &'a AnalysisModel) -> impl Iterator<Item = (usize, f64)> + 'a {
        let of_body = (0..model.mesh.tets.len()).filter(|&e| model.mesh.tet_body[e] == self.body);
        of_body.filter_map(|e| {
            let away = model.mesh.corners(e).map(|x| x[self.axis] - self.at);
            let on = away.iter().any(|d| d.abs() <= ON_PLANE);
            on.then(|| (e, away.into_iter().fold(0.0, |s: f64, d| s + d).signum()))
        })
    }

    /// The tets with a face on the plane.
    fn adjacent(&self, model: &AnalysisModel) -> Vec<Adjacent> {
        let with_face = self.touching(model).filter_map(|(e, side)| {
            let corners = model.mesh.corners(e);
            let on = |i: usize| (corners[i][self.axis] - self.at).abs() <= ON_PLANE;
            let local = (0..4).find(|&k| FACES[k].iter().all(|&i| on(i)))?;
            Some((e, local, side))
        });
        with_face.collect()
    }
}

/// Forces of an element at its ten nodes, `∫ σ ∇N_i` \[N\].
fn nodal_forces(
    model: &AnalysisModel,
    tet: usize,
    stiffness: &Isotropic,
    u: &[V3; 10],
) -> [V3; 10] {
    let corners = model.mesh.corners(tet);
    let stress = vertex_strains(&corners, u).map(|e| stiffness.stress(&e));
    let volume = model.mesh.volume(tet);
    let moments: [Mandel; 4] = std::array::from_fn(|w| {
        std::array::from_fn(|i| {
            (0..4).map(|v| volume * tetrahedron_mass(v, w) * stress[v][i]).sum()
        })
    });
    let columns = strain_columns(&corners);
    std::array::from_fn(|node| {
        std::array::from_fn(|d| {
            (0..4).map(|w| mandel::dot(&moments[w], &columns[w][3 * node + d])).sum()
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::dispatch::AnalysisPass;
    use crate::analysis::event::Progress;
    use crate::analysis::pass::PassOptions;
    use crate::mesh::fixtures::{cubes, name};
    use crate::model::file::ModelFile;
    use crate::model::resolve::resolve;
    use bracket_base::yaml;
    use std::path::Path;
    use std::sync::Arc;

    const BAR: &str = "mesh: m.msh
analysis: elastic
materials: {steel: {E: 210000, nu: 0.3}}
bodies: {BAR: steel}
supports:
  - {face: LEFT, fix: [x, y, z]}
loads:
  - {face: RIGHT, traction: [3, -1, 2]}
";

    /// In a bar the force in a section is that of the load, in both fields, although neither is
    /// exact. Off the planes of the mesh there is none, and a body that may yield has none by its
    /// displacements.
    #[test]
    fn both_fields_carry_the_load_through_a_section() {
        let mut mesh = cubes(&[([0, 0, 0], "BAR"), ([1, 0, 0], "BAR"), ([2, 0, 0], "BAR")]);
        name(&mut mesh, "LEFT", |x| x[0] == 0.0);
        name(&mut mesh, "RIGHT", |x| x[0] == 30.0);
        let parsed = yaml::parse::<ModelFile>(BAR, Path::new("m.yaml")).expect("sound");
        let mut model = resolve(&parsed.value, mesh, &|p| parsed.index.place(p)).expect("sound");
        let silent: Progress = Arc::new(|_, _| ());
        let pass = AnalysisPass::run(&model, &PassOptions::default(), &silent).expect("runs");
        let AnalysisPass::Energy(pass) = pass else { panic!("an energy") };
        let (u, stress) = (pass.displacement.expect("optimal"), pass.stress.expect("optimal"));
        let space = Tet10Space::new(&model.mesh);
        let section = |at| SectionPlane { body: 0, axis: 0, at };
        for at in [10.0, 20.0] {
            let by_stress = section(at).of_stress(&model, &stress).expect("a face");
            let by_motion = section(at).of_displacement(&model, &space, &u).expect("a face");
            for found in [by_stress, by_motion] {
                let error = vec3::norm(vec3::sub(found, [300.0, -100.0, 200.0]));
                assert!(error < 1e-6, "{at}: {found:?}");
            }
        }
        assert_eq!(section(15.0).of_stress(&model, &stress), None);
        assert_eq!(section(15.0).of_displacement(&model, &space, &u), None);
        model.materials[0].fy = Some(235.0);
        assert_eq!(section(10.0).of_displacement(&model, &space, &u), None);
    }
}
