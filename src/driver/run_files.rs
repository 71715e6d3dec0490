//! The files that a run writes while it solves: mesh, models, fields and pictures of its cases.

use crate::driver::case_files::{write_fields, write_passes, write_route};
use crate::driver::collapse_pictures::collapse_pictures;
use crate::driver::interrupt::Interrupt;
use crate::driver::meshing::quality_table;
use crate::driver::pass_entry::lower_stress;
use crate::driver::passes::Kept;
use crate::driver::pictures::{
    contact_pictures, convergence, deformed_picture, mesh_pictures, png,
};
use crate::driver::present::Drawn;
use crate::driver::scene::add_case;
use crate::driver::setup::RunSetup;
use crate::driver::solved::{RunSink, SolvedCase};
use crate::driver::spec_file::SpecFile;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::mesh::msh_write;
use bracket_engine::model::AnalysisModel;
use bracket_joint::meshing::joint::JointMesh;
use bracket_joint::spec::connection::Language;
use bracket_report::document::picture::PictureRef;
use bracket_report::document::table::Table;
use bracket_report::draw::load_steps;
use bracket_report::draw::mode_picture::mode_pictures;
use bracket_report::draw::strain_picture::strain_pictures;
use bracket_report::page::scene::Scene;
use bracket_report::result::evidence::Side;
use bracket_report::result::file_names::step_suffix;
use bracket_report::result::folder::ResultFolder;
use bracket_report::words::Words;

/// Writes into a result folder what a run hands over, and collects what the reports show of it.
pub struct RunFiles<'a> {
    folder: &'a ResultFolder,
    /// The words of the pictures, for texts without names of the user.
    words: Words,
    /// Once it is asked for, no further picture is drawn.
    interrupt: &'a Interrupt,
    /// Also write the assembly and the mesher's script.
    pub keep: bool,
    /// Quality of the mesh that the pictures show; until then that of the first mesh.
    pub mesh_quality: Table,
    pictures: Vec<PictureRef>,
    scene: Option<Scene>,
}

impl<'a> RunFiles<'a> {
    /// The files of a run that has not begun.
    pub fn new(folder: &'a ResultFolder, language: Language, interrupt: &'a Interrupt) -> Self {
        Self {
            folder,
            words: Words::new(language),
            interrupt,
            keep: false,
            mesh_quality: Table::default(),
            pictures: Vec::new(),
            scene: None,
        }
    }

    /// What the reports show of the cases.
    pub fn drawn(self) -> Drawn {
        let Self { pictures, scene, mesh_quality, .. } = self;
        Drawn { pictures, scene: scene.unwrap_or_default(), mesh_quality }
    }
}

impl RunSink for RunFiles<'_> {
    fn meshed(&mut self, input: &SpecFile, mesh: &JointMesh) -> Result<(), Diagnostics> {
        msh_write::write(&mesh.mesh, &self.folder.path().join("mesh.msh"))?;
        if self.keep {
            keep(input, mesh, self.folder)?;
        }
        self.mesh_quality = quality_table(&mesh.quality);
        Ok(())
    }

    fn step(
        &mut self,
        (stem, number): (&str, usize),
        model: &AnalysisModel,
        pass: &AnalysisPass,
    ) -> Result<(), Diagnostics> {
        let suffix = step_suffix(number);
        write_fields((pass, model), (stem, &suffix), self.folder, [true, true, false])
    }

    fn solved(&mut self, case: &SolvedCase<'_>, setup: &RunSetup) -> Result<(), Diagnostics> {
        let SolvedCase { adapted, stem, model_file: (model_name, first), alone, modes } = *case;
        let (entry, upper, folder) = (&adapted.entry, &adapted.upper, self.folder);
        // the first mesh is `mesh.msh`; it stays where something else needs it
        let only = alone && !adapted.keeps_first_mesh();
        let mesh_name = if only { "mesh.msh".into() } else { format!("mesh_{stem}.msh") };
        write_passes(adapted, first, [model_name, &mesh_name], stem, folder)?;
        let best = adapted.lower.as_ref().unwrap_or(upper);
        let stress = lower_stress(&best.outcome, entry);
        let (names, mirror) = ((entry.name.as_str(), stem), setup.mirror.as_slice());
        let forces = entry.static_forces.as_ref();
        let maps = match stress {
            Some(stress) => contact_pictures(&best.model, stress, forces, mirror, names, folder)?,
            None => Vec::new(),
        };
        let strains = entry.evidence.as_ref().and_then(|_| strains_of(upper, setup));
        write_route(&upper.model, (strains.as_deref(), modes), (entry, stem), folder)?;
        let pictures = &mut self.pictures;
        if let Some((_, _, quality)) = &upper.made
            && pictures.is_empty()
        {
            self.mesh_quality = quality.clone();
        }
        let scene = self.scene.get_or_insert_with(|| Scene::new(mirror));
        // they take seconds on large meshes, and none of them is part of a certificate
        if !self.interrupt.asked() {
            if pictures.is_empty() {
                pictures.extend(mesh_pictures(&upper.model, mirror, folder)?);
            }
            pictures.extend(collapse_pictures(
                (upper, best),
                names,
                (mirror, &self.words),
                folder,
            )?);
            add_case(scene, &entry.name, upper, best, stress);
        }
        if !self.interrupt.asked() {
            pictures.extend(deformed_picture(upper, names, (mirror, &self.words), folder)?);
        }
        if !self.interrupt.asked() {
            let (mesh, how) = (&upper.model.mesh, (stem, mirror, &self.words));
            let strain = strains.map_or_else(Vec::new, |s| strain_pictures(mesh, &s, entry, how));
            for (picture, drawn) in strain.into_iter().chain(mode_pictures(mesh, modes, entry, how))
            {
                folder.write(&picture.file, &png(&drawn)?)?;
                pictures.push(picture);
            }
        }
        pictures.extend(maps);
        if let Some((picture, text)) = load_steps::drawing(entry, stem) {
            folder.write(&picture.file, text.as_bytes())?;
            pictures.push(picture);
        }
        let target = setup.refinement.adapt.map(|a| a.target_gap);
        pictures.extend(convergence(entry, target, (stem, &self.words), folder)?);
        Ok(())
    }
}

/// The membrane strain at the vertices of a pass, where the route of analysis asks for it.
fn strains_of(Kept { outcome, model, .. }: &Kept, setup: &RunSetup) -> Option<Vec<f64>> {
    let AnalysisPass::Energy(pass) = outcome else { return None };
    setup.evidence.as_ref()?.strains(Side { model, pass })
}

/// Writes the data that pass between the stages: the assembly and the mesher's script.
fn keep(input: &SpecFile, meshed: &JointMesh, folder: &ResultFolder) -> Result<(), Diagnostics> {
    let text = serde_json::to_string_pretty(&input.joint).map_err(|e| {
        Diagnostic::environment("cli/keep", format!("the assembly cannot be written: {e}"))
    })?;
    folder.write("joint.json", text.as_bytes())?;
    folder.write("joint.geo", meshed.geo.as_bytes())?;
    Ok(())
}
