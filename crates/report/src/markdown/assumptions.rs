//! The section on assumptions and limits.

use crate::markdown::report_data::ReportData;
use crate::result::result_file::FrictionModel;
use bracket_base::words::Text;
use bracket_engine::model::AnalysisKind;

/// The assumptions, one sentence each.
pub(crate) fn assumptions(data: &ReportData) -> Vec<Text> {
    let kinds: Vec<AnalysisKind> = data.result.cases.iter().map(|c| c.analysis).collect();
    let limit = kinds.contains(&AnalysisKind::Limit);
    let model = data.model;
    let mut out: Vec<Text> = vec![
        "Small displacements: equilibrium refers to the undeformed shape. Buckling and \
         second-order effects are not covered."
            .into(),
        "Loads are static. Fatigue, fire, impact and ductility in an earthquake are not checked, \
         nor are the members away from the joint, its erection and its execution (EN 1090-2)."
            .into(),
    ];
    let bounds: [Text; 2] = [
        "The bounds hold for the mechanical model: bodies, materials, supports and loads as \
         listed above. They say nothing about how well the model represents the building."
            .into(),
        "Only the quantity named in the answer is bracketed. Local values (stresses, pressures, \
         displacements of a point) carry no guarantee."
            .into(),
    ];
    if !kinds.is_empty() {
        out.extend(bounds);
    }
    if data.input.butt_welds {
        out.push(
            "A weld without a throat in the spec counts as a full-penetration butt weld, as strong \
             as the thinner part."
                .into(),
        );
    }
    if kinds.contains(&AnalysisKind::Elastic) {
        out.push("Elastic analysis: no part yields, whatever its stress.".into());
    }
    if kinds.contains(&AnalysisKind::Elastoplastic) {
        out.push(
            "Elastic, perfectly plastic analysis (Hencky): all loads grow together from zero and \
             nothing that has yielded unloads; no hardening, no strain limit."
                .into(),
        );
    }
    if limit {
        out.push(
            "Limit analysis: rigid, perfectly plastic material with enough ductility to \
             redistribute; no strain limit is checked."
                .into(),
        );
        if model.preload || model.initial_gap {
            out.push(
                "In limit analysis preload drops out and contacts with an initial gap count as \
                 closed."
                    .into(),
            );
        }
    }
    if model.friction {
        out.push(
            "Associated friction lets sliding faces lift off each other (slip dilates). The \
             collapse load of the same joint with Coulomb friction is at least that without \
             friction and at most that with associated friction: a lower bound with associated \
             friction is not safe for a Coulomb structure, the frictionless lower bound is."
                .into(),
        );
        if model.coulomb
            && data.result.cases.iter().any(|c| c.problem == FrictionModel::ShiftedCones)
        {
            out.push(
                "Coulomb friction is reached by a fixed point over problems with shifted cones. \
                 The bounds are strict for the last of these problems; they are not bounds of \
                 Coulomb's law."
                    .into(),
            );
        }
    }
    if model.preload && kinds.iter().any(|k| *k != AnalysisKind::Limit) {
        out.push(
            "Preload: the bolts are tightened first, under the dead loads alone; then the \
             closures of their cuts are kept. The bounds are strict for the structure with these \
             closures, and they bracket its energy only."
                .into(),
        );
    }
    if model.facets {
        out.push(
            "Holes, shanks and fillets are meshed as flat facets. The meshed body is the body for \
             both programs, so the bracket is strict for it; the difference between facets and \
             true curves is not part of the gap."
                .into(),
        );
    }
    if model.symmetry {
        out.push(
            "Geometry, supports and loads are symmetric about the planes used; the solution is \
             assumed to have the same symmetry."
                .into(),
        );
    }
    out.extend(data.assumptions.iter().cloned());
    out
}
