//! The size of the loads as a traction.

use crate::certify::measures::largest;
use crate::model::AnalysisModel;
use crate::model::loads::{Loads, face_corners};
use bracket_base::math::vec3;

/// The largest traction that the loads cause where they act \[MPa\]: that of surface loads, actions
/// on rigid faces per area and reach, forces per volume times the size of the model.
pub(crate) fn largest_traction(model: &AnalysisModel, loads: Loads) -> f64 {
    let mut traction = 0.0f64;
    for load in &model.surface_loads {
        let share = loads.share(load.dead).abs();
        for f in load.faces.iter().filter(|_| share > 0.0) {
            let corners = face_corners(&model.mesh, f);
            let n = vec3::unit(vec3::area_vector(&corners));
            traction = traction.max(share * largest(corners.map(|x| vec3::norm(load.at(x, n)))));
        }
    }
    for r in &model.rigid {
        let corners = r.faces.iter().map(|f| face_corners(&model.mesh, f));
        let (area, reach) = corners.fold((0.0, 0.0f64), |(area, reach), c| {
            let far = largest(c.map(|x| vec3::norm(vec3::sub(x, r.at))));
            (area + vec3::norm(vec3::area_vector(&c)), reach.max(far))
        });
        let [x, y, z, mx, my, mz] = loads.action(r);
        let per = [vec3::norm([x, y, z]) / area, vec3::norm([mx, my, mz]) / (area * reach)];
        traction = traction.max(largest(per));
    }
    let force = largest(model.body_forces(loads).into_iter().map(vec3::norm));
    if force > 0.0 {
        let nodes = &model.mesh.nodes;
        let size = largest(nodes.iter().map(|x| vec3::norm(vec3::sub(*x, nodes[0]))));
        traction = traction.max(force * size);
    }
    traction
}
