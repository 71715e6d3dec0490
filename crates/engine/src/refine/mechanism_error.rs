//! Where a mesh resolves a mechanism badly.
//!
//! Dissipation alone is no measure: a bolt that stretches evenly dissipates much and is exact on
//! any mesh. What a finer mesh changes is the strain rate, so the measure is the difference between
//! the strain rate of a tet and its average over the tets around each vertex, in units of
//! dissipation: `√2 k V ¼ Σ_v ‖dev(ε_v − ε̄_v)‖`.
//!
//! # Source
//! Recovery of gradients after Zienkiewicz and Zhu (1987), in the norm of the dissipation.

use crate::certify::velocity_field::VelocityField;
use crate::elements::geometry::gradients;
use crate::elements::space::Tet10Space;
use crate::elements::tet10;
use crate::model::AnalysisModel;
use bracket_base::math::mandel::{self, Mandel, symmetric_part};
use bracket_base::math::vec3::V3;

/// The deviator of a tensor.
fn deviator(mut t: Mandel) -> Mandel {
    let mean = (t[0] + t[1] + t[2]) / 3.0;
    t[..3].iter_mut().for_each(|x| *x -= mean);
    t
}

/// The measure of each tet for the mechanism of a kinematic program \[N mm per unit of time\]; zero
/// in rigid bodies.
pub fn of_tets(model: &AnalysisModel, field: &VelocityField) -> Vec<f64> {
    let mesh = &model.mesh;
    let space = Tet10Space::new(mesh);
    differences(model, |e| {
        let nodes = space.tet(mesh, e).map(|n| field.nodes.u[n]);
        tet10::vertex_strains(&mesh.corners(e), &nodes)
    })
}

/// The same for the mechanism of a static program, given by the velocities of the vertices. Its
/// unit is that of the velocities, whose scale has no meaning.
pub fn of_vertices(model: &AnalysisModel, velocities: &[V3]) -> Vec<f64> {
    let mesh = &model.mesh;
    differences(model, |e| {
        let (g, u) = (gradients(&mesh.corners(e)), mesh.tets[e].map(|n| velocities[n as usize]));
        let gradient =
            [0, 1, 2].map(|c| [0, 1, 2].map(|d| (0..4).map(|i| u[i][c] * g[i][d]).sum()));
        [symmetric_part(&gradient); 4]
    })
}

/// The measure from the strain rates at the vertices of each tet.
fn differences(model: &AnalysisModel, strains: impl Fn(usize) -> [Mandel; 4]) -> Vec<f64> {
    let mesh = &model.mesh;
    let radii = model.yield_radii();
    let strains: Vec<[Mandel; 4]> =
        (0..mesh.tets.len()).map(|e| strains(e).map(deviator)).collect();
    // rigid bodies do not count where they share nodes with others
    let flows = |e: usize| radii[mesh.tet_body[e] as usize].is_some();
    let mut mean = vec![[0.0; 6]; mesh.nodes.len()];
    let mut weight = vec![0.0; mesh.nodes.len()];
    for e in (0..mesh.tets.len()).filter(|&e| flows(e)) {
        let volume = mesh.volume(e);
        for (n, strain) in mesh.tets[e].iter().zip(&strains[e]) {
            (0..6).for_each(|c| mean[*n as usize][c] += volume * strain[c]);
            weight[*n as usize] += volume;
        }
    }
    (0..mesh.tets.len())
        .map(|e| {
            let Some(radius) = radii[mesh.tet_body[e] as usize] else { return 0.0 };
            let sum: f64 = mesh.tets[e]
                .iter()
                .zip(&strains[e])
                .map(|(n, strain)| {
                    let n = *n as usize;
                    let difference: Mandel =
                        std::array::from_fn(|c| strain[c] - mean[n][c] / weight[n]);
                    mandel::norm(&difference)
                })
                .sum();
            0.25 * radius * mesh.volume(e) * sum
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::fixtures::cubes;
    use crate::mesh::{NamedFaces, topology};
    use crate::model::file::ModelFile;
    use crate::model::resolve::resolve;
    use bracket_base::yaml;
    use std::path::Path;

    /// A bar of 10 cubes along x, held at all outer faces.
    fn bar() -> AnalysisModel {
        let cells: Vec<_> = (0..10).map(|i| ([i, 0, 0], "A")).collect();
        let mut mesh = cubes(&cells);
        let table = topology::FaceTable::new(&mesh.tets);
        let outer = table.faces().filter(|rows| rows.len() == 1);
        let triangles = outer.map(|rows| rows[0].key).collect();
        mesh.faces.push(NamedFaces { name: "HELD".into(), triangles });
        let text = "mesh: m.msh\nanalysis: elastic\nmaterials: {s: {E: 210000, nu: 0.3, fy: \
                    235}}\nbodies: {A: s}\nsupports: [{face: HELD, fix: [x, y, z]}]\n";
        let parsed = yaml::parse::<ModelFile>(text, Path::new("model.yaml")).expect("YAML");
        resolve(&parsed.value, mesh, &|path| parsed.index.place(path)).expect("a sound model")
    }

    /// An even strain rate has no error on any mesh. One that ends in a plane has it there and not
    /// two cubes away.
    #[test]
    fn where_the_strain_rate_changes() {
        let model = bar();
        let shear = |end: f64| -> Vec<V3> {
            model.mesh.nodes.iter().map(|x| [0.0, 1e-3 * x[0].min(end), 0.0]).collect()
        };
        assert!(of_vertices(&model, &shear(1e9)).iter().all(|e| *e < 1e-9));
        let errors = of_vertices(&model, &shear(50.0));
        let middle = |e: usize| model.mesh.corners(e).iter().map(|x| 0.25 * x[0]).sum::<f64>();
        for (e, error) in errors.iter().enumerate() {
            let away = (middle(e) - 50.0).abs();
            assert!(away < 20.0 || *error < 1e-9, "{away} {error}");
        }
        assert!(errors.iter().sum::<f64>() > 0.1, "{errors:?}");
    }
}
