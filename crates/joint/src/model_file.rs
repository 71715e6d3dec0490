//! The `MODEL.yaml` of a meshed joint: bodies, materials, interfaces, supports, symmetry and loads,
//! by the names in the mesh.

mod bolt_entries;
mod materials;

use crate::assembly::Assembly;
use crate::assembly::assembly::{
    Action, BoltPreload, FaceLoad, Part, PartRole, SymmetryPlane, WeldRule,
};
use crate::meshing::naming::symmetry_face;
use crate::strength::DesignStrengths;
use bracket_engine::mesh::TetMesh;
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::file::{
    Axis, Bounds, Gap, InterfaceEntry, Law, LinearTraction, LoadEntry, ModelFile, Motion, Nodes,
    PreloadEntry, RigidEntry, SupportEntry,
};

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];
const MOTIONS: [Motion; 6] =
    [Motion::Ux, Motion::Uy, Motion::Uz, Motion::Rx, Motion::Ry, Motion::Rz];

/// Names of the load cases, in the order of their first load.
pub fn cases(assembly: &Assembly) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for load in &assembly.loads {
        if !out.contains(&load.case) {
            out.push(load.case.clone());
        }
    }
    out
}

/// What is analysed of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// The load case.
    pub case: String,
    /// The kind of analysis.
    pub kind: AnalysisKind,
    /// Whether the bolts stay elastic although other parts yield. Their stiffness is then that of
    /// the stress area.
    pub elastic_bolts: bool,
    /// Whether the bolts are tightened.
    pub preload: bool,
}

impl Asked {
    /// A load case under a kind of analysis in which all parts yield that can.
    pub fn new(case: impl Into<String>, kind: AnalysisKind) -> Self {
        Self { case: case.into(), kind, elastic_bolts: false, preload: true }
    }
}

/// The model of one load case on a joint's mesh.
///
/// Rules about parts and faces that `mesh` does not contain (beyond a symmetry plane) are left out.
/// `mesh_name` is the path of the mesh file relative to the model file. Forces and moments become
/// actions on rigid faces, free in all motions that the symmetry planes through them permit. A
/// preloaded bolt that a symmetry plane halves has half its preload. In limit analysis the
/// resistances of the bolts are limits of the forces in the sections of their shanks. There is no
/// entry for adaptation. A material or weld without an entry in `strengths` gets none in the model,
/// which the engine then refuses.
pub fn model_file(
    assembly: &Assembly,
    strengths: &DesignStrengths,
    mesh: &TetMesh,
    symmetry_used: &[SymmetryPlane],
    mesh_name: &str,
    asked: &Asked,
) -> ModelFile {
    let (case, analysis) = (&asked.case, asked.kind);
    let has_body = |name: &String| mesh.bodies.contains(name);
    let has_face = |name: &str| mesh.faces_named(name).is_some();
    let kept: Vec<_> = assembly.parts.iter().filter(|p| has_body(&p.name)).collect();
    let limited = match analysis {
        AnalysisKind::Limit => bolt_entries::limits(assembly, strengths, mesh, symmetry_used),
        _ => bolt_entries::Limits::default(),
    };
    let stay_elastic = |part: &Part| asked.elastic_bolts && part.role == PartRole::Bolt;
    let (materials, bodies) =
        materials::materials(assembly, &kept, (strengths, &limited.shanks), stay_elastic);
    let contacts =
        assembly.interfaces.iter().filter(|rule| rule.between.iter().all(has_body)).map(|rule| {
            InterfaceEntry {
                between: Some(rule.between.clone()),
                face: rule.surface.as_ref().map(|(name, _)| name.clone()),
                law: Law::Contact,
                mu: Some(rule.mu),
                gap: Some(Gap::Constant(rule.gap)),
                friction: Some(rule.friction),
                throat: None,
                thickness: None,
                strength: None,
                strength_traction: None,
            }
        });
    let interfaces = contacts.chain(weld_entries(assembly, strengths, mesh, analysis)).collect();
    let support = |face: &str, fix: [bool; 3]| SupportEntry {
        face: face.to_string(),
        fix: (0..3).filter(|&k| fix[k]).map(|k| AXES[k]).collect(),
        ..SupportEntry::default()
    };
    // without friction: it would need the pressure that the certificate of Coulomb's law lacks
    let limit = analysis == AnalysisKind::Limit;
    let ground = |face: &str| {
        let bearing = strengths.ground.get(face);
        SupportEntry {
            face: face.to_string(),
            law: Some(Law::Contact),
            mu: Some(0.0),
            strength: bearing.filter(|_| limit).map(|b| b.strength.mpa()),
            stiffness: bearing.filter(|_| !limit).and_then(|b| b.stiffness),
            ..SupportEntry::default()
        }
    };
    let mut supports: Vec<SupportEntry> = assembly
        .supports
        .iter()
        .filter(|s| has_face(&s.face))
        .map(|s| match s.ground {
            Some(_) => ground(&s.face),
            None => support(&s.face, s.fix),
        })
        .collect();
    for plane in symmetry_used {
        let face = symmetry_face(plane.axis);
        if has_face(face) {
            supports.push(support(face, std::array::from_fn(|k| k == plane.axis)));
        }
    }
    let here: Vec<&FaceLoad> =
        assembly.loads.iter().filter(|l| l.case == *case && has_face(&l.face)).collect();
    let loads = |dead: bool| -> Vec<LoadEntry> {
        let entry = |l: &&FaceLoad| match l.action {
            Action::Traction(t) => Some(LoadEntry {
                face: Some(l.face.clone()),
                traction: Some(t),
                ..LoadEntry::default()
            }),
            Action::Linear { traction0, gradient } => Some(LoadEntry {
                face: Some(l.face.clone()),
                linear: Some(LinearTraction { traction0, gradient }),
                ..LoadEntry::default()
            }),
            Action::Resultant { .. } => None,
        };
        here.iter().filter(|l| l.dead == dead).filter_map(entry).collect()
    };
    ModelFile {
        mesh: mesh_name.to_string(),
        nodes: Nodes::Shared,
        analysis,
        bounds: Bounds::Both,
        coulomb_estimate: false,
        materials,
        bodies,
        interfaces,
        supports,
        rigid: rigid_entries(assembly, &here, symmetry_used),
        loads: loads(false),
        dead: loads(true),
        preload: match asked.preload {
            true => preload_entries(assembly, mesh, symmetry_used),
            false => Vec::new(),
        },
        cuts: limited.cuts,
        resultant_limits: limited.limits,
        adapt: None,
        symmetry: 1 << symmetry_used.len(),
    }
}

/// The fillet welds of the meshed part. They have a finite strength unless the analysis is elastic;
/// then they are tied.
fn weld_entries(
    assembly: &Assembly,
    strengths: &DesignStrengths,
    mesh: &TetMesh,
    analysis: AnalysisKind,
) -> impl Iterator<Item = InterfaceEntry> {
    let here = move |w: &&WeldRule| {
        analysis != AnalysisKind::Elastic && mesh.faces_named(&w.name).is_some()
    };
    assembly.welds.iter().filter(here).map(move |w| InterfaceEntry {
        between: Some(w.between.clone()),
        face: Some(w.name.clone()),
        law: Law::Weld,
        mu: None,
        gap: None,
        friction: None,
        throat: Some(w.throat),
        thickness: Some(w.thickness),
        strength: strengths.welds.get(&w.name).map(|s| s.mpa()),
        strength_traction: None,
    })
}

/// The preloaded bolts of the meshed part.
fn preload_entries(
    assembly: &Assembly,
    mesh: &TetMesh,
    symmetry_used: &[SymmetryPlane],
) -> Vec<PreloadEntry> {
    let kept = assembly.preloads.iter().filter(|p| mesh.bodies.contains(&p.part));
    let entry = |p: &BoltPreload| {
        let (_, share) = p.surface.halved_by(symmetry_used);
        PreloadEntry {
            body: p.part.clone(),
            cut: p.cut.clone(),
            axis: p.axis,
            force: p.force * share,
        }
    };
    kept.map(entry).collect()
}

/// The sections on which forces and moments of a load case act. A symmetry plane that halves a
/// section halves its actions and leaves only the motions in the plane free.
fn rigid_entries(
    assembly: &Assembly,
    loads: &[&FaceLoad],
    symmetry_used: &[SymmetryPlane],
) -> Vec<RigidEntry> {
    let mut out: Vec<RigidEntry> = Vec::new();
    for load in loads {
        let Action::Resultant { at, force, moment } = load.action else { continue };
        let surface = assembly.faces.iter().find(|f| f.name == load.face).map(|f| f.surface);
        let halved = surface.map(|s| s.halved_by(symmetry_used));
        let (cuts, share) = halved.unwrap_or((Vec::new(), 1.0));
        let (force, moment) = (force.map(|f| share * f), moment.map(|m| share * m));
        let known = out.iter().position(|r| r.face == load.face);
        let index = known.unwrap_or_else(|| {
            let stays =
                |k: usize| cuts.iter().all(|&axis| if k < 3 { k != axis } else { k - 3 == axis });
            out.push(RigidEntry {
                face: load.face.clone(),
                components: AXES.to_vec(),
                free: MOTIONS
                    .into_iter()
                    .enumerate()
                    .filter(|(k, _)| stays(*k))
                    .map(|(_, m)| m)
                    .collect(),
                at,
                force: [0.0; 3],
                moment: [0.0; 3],
                dead_force: [0.0; 3],
                dead_moment: [0.0; 3],
            });
            out.len() - 1
        });
        let entry = &mut out[index];
        if load.dead {
            (entry.dead_force, entry.dead_moment) = (force, moment);
        } else {
            (entry.force, entry.moment) = (force, moment);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::assembly::Surface;
    use crate::geometry::fixtures::{lap_joint, paper_joint};
    use crate::strength::{Design, Nominal, WeldSteel};
    use bracket_engine::mesh::NamedFaces;

    /// A mesh with names only; `model_file` uses nothing else of it.
    fn names(bodies: &[&str], faces: &[&str]) -> TetMesh {
        TetMesh {
            bodies: bodies.iter().map(|s| s.to_string()).collect(),
            faces: faces
                .iter()
                .map(|s| NamedFaces { name: s.to_string(), triangles: vec![] })
                .collect(),
            ..TetMesh::default()
        }
    }

    /// The model of a joint whose materials do not yield.
    fn unlimited(
        joint: &Assembly,
        mesh: &TetMesh,
        planes: &[SymmetryPlane],
        case: &str,
        kind: AnalysisKind,
    ) -> ModelFile {
        let materials = joint.materials.keys().map(|name| (name.clone(), None)).collect();
        let strengths = DesignStrengths { materials, ..DesignStrengths::default() };
        model_file(joint, &strengths, mesh, planes, "mesh.msh", &Asked::new(case, kind))
    }

    /// Design strengths go into the model as they are, nominal ones never do: what has no design
    /// strength is not in the model, and the engine refuses the body.
    #[test]
    fn strengths_of_the_model_are_design_strengths() {
        let mut joint = lap_joint();
        joint.welds.push(WeldRule {
            name: "WELD".into(),
            between: ["UPPER".into(), "LOWER".into()],
            surface: Surface::Plane { axis: 2, at: 0.0, min: [0.0; 3], max: [10.0, 10.0, 0.0] },
            imprint: false,
            throat: 4.0,
            thickness: 8.0,
            length: None,
            closed: false,
            steel: WeldSteel { fu: Nominal::new(360.0), beta_w: 0.8 },
        });
        let mesh = names(&["UPPER", "LOWER", "BOLT"], &["BASE", "PULL", "WELD"]);
        let of = |strengths: &DesignStrengths| {
            let kind = AnalysisKind::Limit;
            let file =
                model_file(&joint, strengths, &mesh, &[], "mesh.msh", &Asked::new("PULL", kind));
            let weld = file.interfaces.iter().find(|i| i.law == Law::Weld).expect("a weld");
            (file.materials.get("steel").map(|m| m.fy), weld.strength)
        };
        let known = DesignStrengths {
            materials: [("steel".to_string(), Some(Design::new(213.6)))].into(),
            welds: [("WELD".to_string(), Design::new(207.8))].into(),
            ..DesignStrengths::default()
        };
        assert_eq!(of(&known), (Some(Some(213.6)), Some(207.8)));
        assert_eq!(of(&DesignStrengths::default()), (None, None));
    }

    #[test]
    fn quarter_of_the_paper_s_joint() {
        let joint = paper_joint();
        let bodies = ["COLUMN", "BOLT_RP1", "BOLT_RP2", "BOLT_RP3", "PLATE_R", "BEAM_R"];
        let faces =
            ["SHANK_RP1", "SHANK_RP2", "SHANK_RP3", "SUPPORT_R", "LOAD_TOP", "SYM_X0", "SYM_Y0"];
        let mesh = names(&bodies, &faces);
        let model = unlimited(&joint, &mesh, &joint.symmetry, "TOP", AnalysisKind::Elastic);
        assert_eq!(model.symmetry, 4);
        assert_eq!(model.bodies.len(), 6);
        // plate on column, and for each bolt: column, and plate at the shank only
        assert_eq!(model.interfaces.len(), 1 + 3 * 2);
        assert_eq!(model.interfaces[2].face.as_deref(), Some("SHANK_RP1"));
        let held: Vec<(&str, &[Axis])> =
            model.supports.iter().map(|s| (s.face.as_str(), &s.fix[..])).collect();
        assert_eq!(
            held,
            [("SUPPORT_R", &AXES[..]), ("SYM_X0", &AXES[..1]), ("SYM_Y0", &AXES[1..2])]
        );
        assert_eq!(model.loads.len(), 1);
        let yaml = serde_yaml::to_string(&model).expect("plain data");
        assert_eq!(serde_yaml::from_str::<ModelFile>(&yaml).expect("reads back"), model);
    }

    #[test]
    fn cases_are_kept_apart_and_dead_loads_go_to_dead() {
        let mut joint = lap_joint();
        let extra = |case: &str, dead| FaceLoad {
            face: "PULL".into(),
            case: case.into(),
            action: Action::Traction([0.0, 0.0, 1.0]),
            dead,
        };
        joint.loads.push(extra("LIFT", false));
        joint.loads.push(extra("PULL", true));
        assert_eq!(cases(&joint), ["PULL", "LIFT"]);
        let mesh = names(&["UPPER", "LOWER", "BOLT"], &["BASE", "PULL"]);
        let model = unlimited(&joint, &mesh, &[], "PULL", AnalysisKind::Limit);
        assert_eq!((model.loads.len(), model.dead.len(), model.symmetry), (1, 1, 1));
        let lift = unlimited(&joint, &mesh, &[], "LIFT", AnalysisKind::Limit);
        assert_eq!((lift.loads[0].traction, lift.dead.len()), (Some([0.0, 0.0, 1.0]), 0));
    }

    #[test]
    fn a_halved_bolt_carries_half_of_its_preload() {
        let mut joint = lap_joint();
        let at = |part: &str, y: f64| BoltPreload {
            part: part.into(),
            cut: format!("CUT_{part}"),
            surface: Surface::Plane {
                axis: 2,
                at: 5.0,
                min: [20.0, y - 10.0, 5.0],
                max: [40.0, y + 10.0, 5.0],
            },
            axis: [0.0, 0.0, -1.0],
            force: 80e3,
        };
        joint.preloads = vec![at("BOLT", 0.0), at("UPPER", 30.0), at("GONE", 30.0)];
        let mesh = names(&["UPPER", "LOWER", "BOLT"], &["BASE", "PULL"]);
        let forces = |axes: &[usize]| -> Vec<f64> {
            let planes: Vec<SymmetryPlane> =
                axes.iter().map(|&axis| SymmetryPlane { axis }).collect();
            let model = unlimited(&joint, &mesh, &planes, "PULL", AnalysisKind::Elastic);
            assert_eq!(
                (&model.preload[0].cut[..], model.preload[0].axis),
                ("CUT_BOLT", [0.0, 0.0, -1.0])
            );
            model.preload.iter().map(|p| p.force).collect()
        };
        // a plane across the shank halves nothing of the force
        for (axes, want) in [(&[][..], [80e3, 80e3]), (&[1], [40e3, 80e3]), (&[0, 2], [80e3, 80e3])]
        {
            assert_eq!(forces(axes), want, "{axes:?}");
        }
    }

    #[test]
    fn a_halved_section_carries_half_and_keeps_the_motions_of_its_plane() {
        let mut joint = paper_joint();
        joint.loads = [false, true]
            .map(|dead| FaceLoad {
                face: "LOAD_TOP".into(),
                case: "ULS".into(),
                action: Action::Resultant {
                    at: [0.0, 0.0, 5.0],
                    force: [0.0, 0.0, if dead { -8.0 } else { 4.0 }],
                    moment: [0.0, if dead { 0.0 } else { 16.0 }, 0.0],
                },
                dead,
            })
            .to_vec();
        let mesh = names(&["COLUMN"], &["LOAD_TOP"]);
        let of = |axes: &[usize]| {
            let planes: Vec<SymmetryPlane> =
                axes.iter().map(|&axis| SymmetryPlane { axis }).collect();
            let model = unlimited(&joint, &mesh, &planes, "ULS", AnalysisKind::Limit);
            assert_eq!((model.loads.len(), model.dead.len(), model.rigid.len()), (0, 0, 1));
            model.rigid[0].clone()
        };
        let whole = of(&[]);
        assert_eq!(
            (whole.at, whole.force, whole.moment),
            ([0.0, 0.0, 5.0], [0.0, 0.0, 4.0], [0.0, 16.0, 0.0])
        );
        assert_eq!((whole.dead_force, whole.dead_moment), ([0.0, 0.0, -8.0], [0.0; 3]));
        assert_eq!(whole.free, MOTIONS);
        let half = of(&[1]);
        assert_eq!((half.force[2], half.moment[1], half.dead_force[2]), (2.0, 8.0, -4.0));
        assert_eq!(half.free, [Motion::Ux, Motion::Uz, Motion::Ry]);
        let quarter = of(&[0, 1]);
        assert_eq!((quarter.force[2], quarter.free), (1.0, vec![Motion::Uz]));
    }
}
