//! The buckling modes of the loads, for the route of analysis.

use super::evidence::{EvidencePlan, Side};
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::route::{CriticalFactors, CriticalMode, LARGEST_CRITICAL};
use bracket_engine::certify::fields::{DisplacementField, StressField};
use bracket_engine::elements::space::Tet10Space;
use bracket_engine::estimate::buckling::{BucklingOptions, buckling};
use bracket_engine::estimate::refined::refined;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::resolve::{MirrorPlane, parities};
use bracket_joint::assembly::assembly::SymmetryPlane;
use bracket_joint::meshing::naming::symmetry_face;

/// Number of critical factors that are kept.
const MODES: usize = 3;
/// Most tets of a mesh that is made twice as fine for the critical factors.
const LARGEST: usize = 50_000;

/// The lowest buckling modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Buckled {
    /// Their factors on the mesh of the fields and on the one twice as fine.
    pub factors: CriticalFactors,
    /// The modes of the finer mesh at the vertices and mid-sides of the mesh of the fields. The
    /// longest displacement of each is about 1.
    pub shapes: Vec<DisplacementField>,
}

impl EvidencePlan {
    /// The lowest modes on the mesh of both fields and on one twice as fine, or why they are not
    /// known.
    pub fn critical(&self, upper: Side<'_>, lower: Side<'_>) -> Result<Buckled, Text> {
        let (Some(displacement), Some(stress)) = (upper.displacement(), lower.pass.stress.as_ref())
        else {
            return Err("one of the two bounds has no field".into());
        };
        let model = lower.model;
        if model.mesh != upper.model.mesh {
            return Err("the two bounds are on different meshes".into());
        }
        let tets = model.mesh.tets.len();
        if tets > LARGEST {
            return Err(say!(
                "the mesh has {} tetrahedra, and at most {} can be made twice as fine",
                tets,
                LARGEST
            ));
        }
        let coarse = self.modes(model, displacement, stress, 0)?;
        let finer = refined(model, displacement, stress);
        // the vertices of the finer mesh are the nodes of the coarse one
        let nodes = finer.model.mesh.nodes.len();
        let fine = self.modes(&finer.model, &finer.displacement, &finer.stress, nodes)?;
        let (fine, shapes) = fine.into_iter().unzip();
        let coarse = coarse.into_iter().map(|(mode, _)| mode).collect();
        Ok(Buckled { factors: CriticalFactors { coarse, fine }, shapes })
    }

    /// The lowest modes that are symmetric or antisymmetric to each plane, with the displacements
    /// of the first `kept` nodes.
    fn modes(
        &self,
        model: &AnalysisModel,
        displacement: &DisplacementField,
        stress: &StressField,
        kept: usize,
    ) -> Result<Vec<(CriticalMode, DisplacementField)>, Text> {
        let plane =
            |p: &SymmetryPlane| MirrorPlane { support: symmetry_face(p.axis), axis: p.axis };
        let planes: Vec<MirrorPlane<'_>> = self.symmetry.iter().map(plane).collect();
        let options = BucklingOptions {
            modes: MODES,
            largest: LARGEST_CRITICAL,
            ..BucklingOptions::default()
        };
        let space = Tet10Space::new(&model.mesh);
        let mut out = Vec::new();
        let models = parities(model, &planes).map_err(|e| e.text())?;
        for (parity, of_parity) in models.iter().enumerate() {
            let found =
                buckling(of_parity, displacement, stress, &options).map_err(|e| e.text())?;
            let odd = planes.iter().enumerate().filter(|(i, _)| parity >> i & 1 == 1);
            let antisymmetric: Vec<usize> = odd.map(|(_, p)| p.axis).collect();
            out.extend(found.modes.into_iter().map(|mut m| {
                let largest = |of: &mut dyn Iterator<Item = f64>| {
                    of.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default()
                };
                let (body, share) = largest(&mut m.share_by_body.iter().copied());
                let (most, _) = largest(&mut m.shape.iter().map(|v| vec3::norm(*v)));
                let part = model.mesh.bodies.get(body).cloned().unwrap_or_default();
                let (at, antisymmetric) = (space.nodes[most], antisymmetric.clone());
                m.shape.truncate(kept);
                m.shape.shrink_to_fit();
                let mode = CriticalMode { factor: m.factor, part, share, at, antisymmetric };
                (mode, DisplacementField { u: m.shape })
            }));
        }
        out.sort_by(|a, b| a.0.factor.total_cmp(&b.0.factor));
        out.truncate(MODES);
        Ok(out)
    }
}
