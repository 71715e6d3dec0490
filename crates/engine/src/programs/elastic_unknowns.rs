//! The unknowns of the elastic kinematic program, without its loads and cones.

use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use crate::model::ModelError;
use crate::programs::contact_modes::{ContactMode, contact_modes_of_nodes};
use crate::programs::dofs::DofMap;
use crate::programs::free_modes::kinematic_pins;
use crate::programs::kinematic::{Numbering, numbering};

/// Displacement space and unknowns of a model in which no body yields.
pub struct ElasticUnknowns {
    /// The displacement space.
    pub space: Tet10Space,
    /// Full displacements from the unknowns: held components, rigid faces, ties and cuts.
    pub map: DofMap,
    /// Unknowns that hold the free rigid motions of the model, one for each.
    pub pins: Vec<usize>,
}

impl ElasticUnknowns {
    /// Numbers the unknowns of a model.
    pub fn new(model: &AnalysisModel) -> Result<Self, ModelError> {
        let space = Tet10Space::new(&model.mesh);
        let Numbering { pieces, map, rigid, .. } = numbering(model, &space, false)?;
        let pins = kinematic_pins(model, &space, &map, &rigid, &pieces);
        Ok(Self { space, map, pins })
    }

    /// The closures of preloaded cuts.
    pub fn closures(&self) -> std::ops::Range<usize> {
        let first = self.map.plain + self.map.rigid();
        first..first + self.map.closures
    }

    /// The rigid motions that no support resists, the free ones included.
    pub fn contact_modes(&self, model: &AnalysisModel) -> Vec<ContactMode> {
        contact_modes_of_nodes(model, &self.space, &self.map)
    }
}
