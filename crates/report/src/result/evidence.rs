//! Estimates for the route of analysis, from the fields of elastoplastic analysis with elastic
//! bolts on one mesh.

use super::weld_bands::weld_bands;
use bracket_codes::route::{
    BoltSections, Evidence, NextMesh, PlateStrain, RouteFacts, SectionForce, WeldForce, WeldForces,
    least_factor, next_mesh,
};
use bracket_engine::analysis::energy_pass::EnergyPass;
use bracket_engine::certify::fields::{DisplacementField, StressField};
use bracket_engine::elements::space::Tet10Space;
use bracket_engine::estimate::plate_strain::{membrane_at_nodes, plate_strains};
use bracket_engine::estimate::section_forces::SectionPlane;
use bracket_engine::estimate::weld_forces::{WeldBand, line_forces};
use bracket_engine::model::AnalysisModel;
use bracket_joint::assembly::Joint;
use bracket_joint::assembly::assembly::{Section, Surface, SymmetryPlane, WeldRule};
use bracket_joint::assembly::sheets::{Sheet, sheets};

/// What is measured in the fields of a joint.
#[derive(Clone, Debug)]
pub struct EvidencePlan {
    /// The sections of the bolts, each with the direction from head to nut along its normal axis.
    sections: Vec<(Section, f64)>,
    /// Plates, flanges and webs.
    sheets: Vec<Sheet>,
    /// The fillet welds.
    welds: Vec<WeldRule>,
    /// The planes of symmetry in use.
    pub(super) symmetry: Vec<SymmetryPlane>,
    /// The resistances that the estimates are compared with.
    facts: RouteFacts,
}

/// A pass with its model.
#[derive(Clone, Copy, Debug)]
pub struct Side<'a> {
    /// The model.
    pub model: &'a AnalysisModel,
    /// Its fields.
    pub pass: &'a EnergyPass,
}

impl<'a> Side<'a> {
    /// Its displacements.
    pub(super) fn displacement(self) -> Option<&'a DisplacementField> {
        self.pass.plastic.as_ref().map(|p| &p.nodes).or(self.pass.displacement.as_ref())
    }
}

/// The plane of a section in the mesh of a model; `None` if the bolt is not meshed.
fn section_plane(section: &Section, model: &AnalysisModel) -> Option<SectionPlane> {
    let body = model.mesh.bodies.iter().position(|b| *b == section.part)?;
    let Surface::Plane { axis, at, .. } = section.surface else { return None };
    Some(SectionPlane { body: u32::try_from(body).ok()?, axis, at })
}

impl EvidencePlan {
    /// What is measured in a joint whose mesh uses these planes of symmetry.
    pub fn new(joint: &Joint, symmetry: &[SymmetryPlane]) -> Self {
        let assembly = &joint.assembly;
        let sections = assembly.sections.iter().filter_map(|s| {
            let grip = assembly.grips.iter().find(|g| g.part == s.part)?;
            Some((s.clone(), grip.axis.iter().sum::<f64>().signum()))
        });
        Self {
            sections: sections.collect(),
            sheets: sheets(&joint.content, assembly),
            welds: assembly.welds.clone(),
            symmetry: symmetry.to_vec(),
            facts: RouteFacts::of(joint),
        }
    }

    /// The lower bound of the load factor that a verdict by analysis needs.
    pub fn least_factor(&self) -> f64 {
        least_factor(&self.facts)
    }

    /// What the estimates of these meshes, in order of their tets, ask of the next one.
    pub fn next_mesh(&self, meshes: &[Evidence]) -> NextMesh {
        next_mesh(&self.facts, 1 << self.symmetry.len(), meshes)
    }

    /// The estimates from the displacement of one pass and the stress of another, or of the same.
    pub fn measure(&self, upper: Side<'_>, lower: Side<'_>) -> Evidence {
        Evidence {
            tets: upper.model.mesh.tets.len(),
            bolts: self.bolts(upper, lower),
            plates: self.plates(upper),
            welds: self.welds(lower.model, lower.pass.stress.as_ref()),
        }
    }

    /// The forces in the sections of the meshed bolts, of whole bolts.
    pub fn bolts(&self, upper: Side<'_>, lower: Side<'_>) -> Vec<BoltSections> {
        let space = Tet10Space::new(&upper.model.mesh);
        let mut out: Vec<BoltSections> = Vec::new();
        for (section, toward) in &self.sections {
            let (halved, share) = section.surface.halved_by(&self.symmetry);
            let whole = |force: [f64; 3]| -> [f64; 3] {
                let of = |k: usize| match halved.contains(&k) {
                    true => 0.0,
                    false => toward * force[k] / share,
                };
                std::array::from_fn(of)
            };
            let plane = |side: Side<'_>| section_plane(section, side.model);
            let (Some(above), Some(below)) = (plane(upper), plane(lower)) else { continue };
            let stress = lower.pass.stress.as_ref();
            let by_stress = stress.and_then(|s| below.of_stress(lower.model, s)).map(whole);
            let moved = upper.displacement();
            let by_displacement =
                moved.and_then(|u| above.of_displacement(upper.model, &space, u)).map(whole);
            let force = SectionForce { by_stress, by_displacement };
            match out.last_mut().filter(|b| b.bolt == section.part) {
                Some(bolt) => bolt.sections.push(force),
                None => {
                    let (bolt, sections) = (section.part.clone(), vec![force]);
                    out.push(BoltSections { bolt, sections });
                }
            }
        }
        out
    }

    /// Mean strains of the meshed plates.
    fn plates(&self, Side { model, pass }: Side<'_>) -> Vec<PlateStrain> {
        let Some(field) = &pass.plastic else { return Vec::new() };
        let meshed = self
            .sheets
            .iter()
            .filter_map(|sheet| Some((sheet, sheet.plate(&model.mesh, &self.symmetry)?)));
        let (sheets, plates): (Vec<&Sheet>, Vec<_>) = meshed.unzip();
        let found = plate_strains(model, field, &plates);
        let of =
            |(sheet, strain): (&Sheet, bracket_engine::estimate::plate_strain::PlateStrain)| {
                let (membrane, surface) = (strain.membrane?, strain.surface?);
                Some(PlateStrain {
                    part: sheet.part.clone(),
                    thickness: sheet.thickness(),
                    membrane: membrane.value,
                    membrane_at: membrane.at,
                    surface: surface.value,
                    surface_at: surface.at,
                })
            };
        sheets.into_iter().zip(found).filter_map(of).collect()
    }

    /// The largest membrane strain of the prisms around each vertex of the mesh, a fraction; NaN
    /// where no plate is, or no mean is taken. `None` without a field with plastic strain.
    pub fn strains(&self, Side { model, pass }: Side<'_>) -> Option<Vec<f64>> {
        let field = pass.plastic.as_ref()?;
        let plates: Vec<_> = self
            .sheets
            .iter()
            .filter_map(|sheet| sheet.plate(&model.mesh, &self.symmetry))
            .collect();
        Some(membrane_at_nodes(model, field, &plates))
    }

    /// The lines of force of the meshed welds.
    fn welds(&self, model: &AnalysisModel, stress: Option<&StressField>) -> Vec<WeldForces> {
        let Some(stress) = stress else { return Vec::new() };
        let bands = self.welds.iter().filter_map(|rule| {
            let meshed = model.welds.iter().find(|w| w.name == rule.name)?;
            Some((rule, weld_bands(rule, &meshed.faces, &model.mesh.nodes, &self.symmetry)))
        });
        let of = |(rule, bands): (&WeldRule, Vec<WeldBand>)| WeldForces {
            weld: rule.name.clone(),
            segments: line_forces(model, stress, &bands)
                .into_iter()
                .flatten()
                .map(|s: bracket_engine::estimate::weld_forces::Segment| WeldForce {
                    from_to: s.span,
                    normal: s.normal,
                    across: s.across,
                    along: s.along,
                    couple: s.couple,
                })
                .collect(),
        };
        bands.map(of).collect()
    }
}
