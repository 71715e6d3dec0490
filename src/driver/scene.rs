//! The fields of a case for the 3-D view: motion of the kinematic program, stress and contact
//! pressure of the static one, each on the mesh of its own pass.

use crate::driver::collapse_pictures::{at_nodes, limiting_densities};
use crate::driver::passes::Kept;
use bracket_base::math::mandel;
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::analysis::limit::SUBDIVISIONS;
use bracket_engine::certify::faces::contact_faces;
use bracket_engine::certify::fields::StressField;
use bracket_engine::certify::limit_certificate::dissipation_densities;
use bracket_engine::certify::tractions::contact_tractions;
use bracket_engine::mesh::tet::FACES;
use bracket_engine::model::AnalysisModel;
use bracket_report::draw::options::Colours;
use bracket_report::figures::{Rounding, significant};
use bracket_report::page::scene::{Field, Scene, Values};

/// Adds the fields of a case: `upper` has the best kinematic field, `stress` is that of the lower
/// bound with its load factor, on the mesh of `lower`.
pub fn add_case(
    scene: &mut Scene,
    case: &str,
    upper: &Kept,
    lower: &Kept,
    stress: Option<(&StressField, f64)>,
) {
    let mut add = |model: &AnalysisModel, fields: Vec<Field<'_>>| {
        if fields.is_empty() {
            return;
        }
        let strength = |m: &u32| model.materials[*m as usize].fy;
        let strengths: Vec<Option<f64>> = model.body_material.iter().map(strength).collect();
        scene.add(case, &model.mesh, &strengths, fields);
    };
    add(&upper.model, kinematic(upper));
    add(&lower.model, statics(lower, stress));
}

fn kinematic(pass: &Kept) -> Vec<Field<'_>> {
    let model = &pass.model;
    let nodes = model.mesh.nodes.len();
    let field = |title: &'static str, unit, values, colours, motion| Field {
        title: title.into(),
        unit,
        values,
        colours,
        shown: None,
        motion,
    };
    match &pass.outcome {
        AnalysisPass::Energy(p) => {
            let motion = p.displacement.as_ref().map(|u| &u.u[..nodes]);
            let of = |m| field("displacement", "mm", Values::Motion, Colours::Spectrum, Some(m));
            motion.map(of).into_iter().collect()
        }
        AnalysisPass::Factor(p) => {
            let velocity = p.velocity.as_ref().or(p.free.as_ref().map(|f| &f.field));
            let Some(v) = velocity else { return Vec::new() };
            let densities = dissipation_densities(model, v, SUBDIVISIONS);
            let values = Values::Nodes(at_nodes(&model.mesh, &densities));
            let title = "mechanism of the upper bound, relative dissipation";
            let mut field = field(title, "", values, Colours::Fire, Some(&v.nodes.u[..nodes]));
            field.shown = Some([0.0, 1.0]);
            vec![field]
        }
    }
}

fn statics<'a>(pass: &'a Kept, stress: Option<(&StressField, f64)>) -> Vec<Field<'a>> {
    let model = &pass.model;
    let mut fields = Vec::new();
    let mut add = |title: Text, unit, values, colours, shown| {
        fields.push(Field { title, unit, values, colours, shown, motion: None });
    };
    if let Some((stress, factor)) = stress {
        let at = match &pass.outcome {
            AnalysisPass::Energy(_) => None,
            AnalysisPass::Factor(_) => Some(significant(factor, 4, Rounding::Down)),
        };
        let corners = Values::Corners(von_mises(stress));
        let title = match &at {
            None => "von Mises stress".into(),
            Some(at) => say!("von Mises stress at load factor {}", at),
        };
        add(title, "MPa", corners, Colours::Spectrum, None);
        let faces = pressures(model, stress);
        if faces.iter().any(|f| f.1.iter().any(|p| *p > 0.0)) {
            let title = match &at {
                None => "contact pressure".into(),
                Some(at) => say!("contact pressure at load factor {}", at),
            };
            add(title, "MPa", Values::Faces(faces), Colours::Fire, None);
        }
    }
    if let Some(share) =
        pass.outcome.yield_multiplier_share().filter(|s| s.iter().any(|x| *x > 0.0))
    {
        let densities = limiting_densities(&model.mesh, share);
        let values = Values::Nodes(at_nodes(&model.mesh, &densities));
        let title = "zones that limit the lower bound, relative";
        add(title.into(), "", values, Colours::Violet, Some([0.0, 1.0]));
    }
    fields
}

/// The largest von Mises stress of the subtets at each corner of each tet \[MPa\].
fn von_mises(stress: &StressField) -> Vec<f64> {
    let of_tet = |subtets: &[[mandel::Mandel; 4]; 4]| {
        let mut corners = [0.0f64; 4];
        for (subtet, face) in subtets.iter().zip(FACES) {
            for (s, corner) in subtet.iter().zip(face) {
                corners[corner] = corners[corner].max(mandel::von_mises(s));
            }
        }
        corners
    };
    stress.points.iter().flat_map(of_tet).collect()
}

/// Contact faces with the pressure at their vertices \[MPa\].
fn pressures(model: &AnalysisModel, stress: &StressField) -> Vec<([u32; 3], [f64; 3])> {
    let of = |face: bracket_engine::certify::faces::ContactFace<'_>| {
        let (n, _) = face.normal(model);
        let traction = contact_tractions(model, stress, &face, None);
        (face.nodes_a, traction.map(|r| vec3::dot(r, n)))
    };
    contact_faces(model).into_iter().map(of).collect()
}
