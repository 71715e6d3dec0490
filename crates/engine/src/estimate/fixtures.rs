//! Blocks with a given displacement, for tests.

use crate::certify::plastic_field::{InnerNodes, with_plastic_strain};
use crate::certify::{DisplacementField, PlasticField};
use crate::elements::space::Tet10Space;
use crate::mesh::NamedFaces;
use crate::mesh::TetMesh;
use crate::mesh::fixtures::{EDGE, cubes};
use crate::mesh::topology::{FaceTable, face_nodes};
use crate::model::AnalysisModel;
use crate::model::file::ModelFile;
use crate::model::resolve::resolve;
use bracket_base::math::vec3::{M3, V3, add, mul, mul_t, norm, scale, sub};
use bracket_base::yaml;
use std::path::Path;

/// A turn about no special axis.
pub fn turn() -> M3 {
    // from the unit quaternion (2, 1, 3, 1)/√15
    let q = [2.0, 1.0, 3.0, 1.0].map(|x: f64| x / 15f64.sqrt());
    let [w, x, y, z] = q;
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// A block of `count` cubes with the lowest corner in the origin, stretched to `size` \[mm\] and
/// mapped by `place`, of one body.
pub fn block(count: [i32; 3], size: V3, place: impl Fn(V3) -> V3) -> TetMesh {
    let mut cells = Vec::new();
    for i in 0..count[0] {
        for j in 0..count[1] {
            cells.extend((0..count[2]).map(|k| ([i, j, k], "A")));
        }
    }
    let mut mesh = cubes(&cells);
    for x in &mut mesh.nodes {
        let stretched = std::array::from_fn(|d| x[d] / (EDGE * f64::from(count[d])) * size[d]);
        *x = place(stretched);
    }
    mesh
}

/// The model of a file with a mesh.
pub fn model(mesh: TetMesh, text: &str) -> AnalysisModel {
    let parsed = yaml::parse::<ModelFile>(text, Path::new("model.yaml")).expect("sound YAML");
    resolve(&parsed.value, mesh, &|path| parsed.index.place(path)).expect("a sound model")
}

/// Steel in one body that is held at all of its outer faces.
pub fn steel(mut mesh: TetMesh, fy: f64) -> AnalysisModel {
    let table = FaceTable::new(&mesh.tets);
    let outer = table.faces().filter(|owners| owners.len() == 1);
    let nodes = outer.map(|o| face_nodes(&mesh.tets[o[0].tet as usize], o[0].local));
    let held = NamedFaces { name: "HELD".into(), triangles: nodes.collect() };
    mesh.faces.push(held);
    let text = format!(
        "mesh: m.msh\nanalysis: elastic\nmaterials: {{s: {{E: 210000, nu: 0.3, fy: {fy}}}}}\n\
         bodies: {{A: s}}\nsupports: [{{face: HELD, fix: [x, y, z]}}]\n"
    );
    model(mesh, &text)
}

/// The field with the given displacement at all nodes and the plastic strain of least energy; in
/// split tets if asked for.
pub fn field(model: &AnalysisModel, split: bool, u: impl Fn(V3) -> V3 + Sync) -> PlasticField {
    let space = Tet10Space::new(&model.mesh);
    let nodes = DisplacementField { u: space.nodes.iter().map(|x| u(*x)).collect() };
    let inner = |e: usize| -> Option<InnerNodes> {
        let corners = model.mesh.corners(e);
        let centre = scale(0.25, corners.into_iter().fold([0.0; 3], add));
        let middle = |v: usize| u(scale(0.5, add(corners[v], centre)));
        split.then(|| [u(centre), middle(0), middle(1), middle(2), middle(3)])
    };
    with_plastic_strain(model, nodes, inner)
}

/// The displacement `u` of a block in its own axes, of the block turned by `r`.
pub fn turned(r: M3, u: impl Fn(V3) -> V3) -> impl Fn(V3) -> V3 {
    move |x| mul(&r, u(mul_t(&r, x)))
}

/// Distance of two points \[mm\].
pub fn apart(a: V3, b: V3) -> f64 {
    norm(sub(a, b))
}
