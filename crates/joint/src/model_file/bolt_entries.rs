//! The resistances of the bolts as limits of the forces in the sections of their shanks.

use crate::assembly::Assembly;
use crate::assembly::assembly::{Grip, Ply, Section, SymmetryPlane};
use crate::assembly::axes::{across, unit};
use crate::strength::{BoltLimits, DesignStrengths};
use bracket_engine::mesh::TetMesh;
use bracket_engine::model::file::{CutEntry, ResultantLimitEntry};
use std::collections::BTreeMap;

const NAMES: [&str; 3] = ["x", "y", "z"];

/// Cuts and limits of the meshed bolts.
#[derive(Default)]
pub(super) struct Limits {
    pub cuts: Vec<CutEntry>,
    pub limits: Vec<ResultantLimitEntry>,
    /// Yield strength of the shanks that are limited, by the name of their part \[MPa\].
    pub shanks: BTreeMap<String, f64>,
}

/// The limits of all meshed bolts with two plies or more. A symmetry plane that halves a bolt
/// halves its resistances, and there is no force across the plane in the whole bolt.
pub(super) fn limits(
    assembly: &Assembly,
    strengths: &DesignStrengths,
    mesh: &TetMesh,
    symmetry_used: &[SymmetryPlane],
) -> Limits {
    let mut out = Limits::default();
    let bolts = assembly.grips.iter().filter(|g| mesh.bodies.contains(&g.part));
    for grip in bolts {
        let Some(bolt) = strengths.bolts.get(&grip.part) else { continue };
        let sections = assembly.sections.iter().filter(|s| s.part == grip.part);
        let sections: Vec<&Section> = sections.collect();
        let Some(first) = sections.first() else { continue };
        let (halving, share) = first.surface.halved_by(symmetry_used);
        Bolt { grip, sections, bolt, share, halving }.add(&mut out);
        out.shanks.insert(grip.part.clone(), bolt.shank.mpa());
    }
    out
}

/// A bolt, the share of it that is meshed and the axes across which it is halved.
struct Bolt<'a> {
    grip: &'a Grip,
    sections: Vec<&'a Section>,
    bolt: &'a BoltLimits,
    share: f64,
    halving: Vec<usize>,
}

impl Bolt<'_> {
    fn add(&self, out: &mut Limits) {
        let Grip { part, axis, .. } = self.grip;
        for (i, section) in self.sections.iter().enumerate() {
            out.cuts.push(CutEntry { body: part.clone(), cut: section.name.clone(), axis: *axis });
            self.in_section(out, i);
        }
        for (i, resistances) in self.bolt.bearing.iter().enumerate() {
            if let Some(resistances) = resistances {
                self.in_bearing(out, i, *resistances);
            }
        }
    }

    /// The axes across the bolt that no symmetry plane holds, each with its number.
    fn open(&self) -> impl Iterator<Item = (usize, usize)> {
        let along = (0..3).find(|&k| self.grip.axis[k] != 0.0).unwrap_or(0);
        across(along).into_iter().enumerate().filter(|(_, k)| !self.halving.contains(k))
    }

    /// Unit vectors of the open axes.
    fn open_directions(&self) -> Vec<[f64; 3]> {
        self.open().map(|(_, k)| unit(k)).collect()
    }

    fn limit(&self, out: &mut Limits, name: String, cuts: [&[&Section]; 2], set: Set) {
        let [cuts, minus] = cuts.map(|c| c.iter().map(|s| s.name.clone()).collect());
        let Set { along, across, at_most } = set;
        let at_most = self.share * at_most;
        out.limits.push(ResultantLimitEntry { name, cuts, minus, along, across, at_most });
    }

    /// Tension, shear, and both together in a section between two plies. All of the tension passes
    /// on through the head or the nut to the outer ply, which must not be punched.
    fn in_section(&self, out: &mut Limits, i: usize) {
        let Self { grip, sections, bolt, .. } = self;
        let here = [&sections[i..=i], &[]];
        let outer = [(i == 0, bolt.punching[0]), (i + 1 == sections.len(), bolt.punching[1])];
        let punching = outer.iter().filter(|o| o.0).fold(f64::INFINITY, |least, o| least.min(o.1));
        let pull = if punching < bolt.tension { "punching" } else { "tension" };
        let name = |what: &str| format!("{} in shear plane {}: {what}", grip.part, i + 1);
        let tension = punching.min(bolt.tension);
        self.limit(out, name(pull), here, Set::along(grip.axis, tension));
        let ratio = bolt.shear / (bolt.interaction * bolt.tension);
        let across = self.open_directions();
        if !across.is_empty() {
            let shear = |along| Set { along, across: across.clone(), at_most: bolt.shear };
            self.limit(out, name("shear"), here, shear([0.0; 3]));
            let both = shear(grip.axis.map(|a| ratio * a));
            self.limit(out, name("tension and shear"), here, both);
        }
    }

    /// Bearing of a ply by direction. The ply takes what passes through the section on the side of
    /// the nut less what passes on the side of the head; an outer ply also takes what its head or
    /// nut transfers. Where it has one section only, a resistance above that in shear is not
    /// needed.
    fn in_bearing(&self, out: &mut Limits, i: usize, resistances: [[f64; 2]; 2]) {
        let sections = &self.sections;
        // an anchor has a section before its first ply too
        let next = i + (sections.len() + 1).saturating_sub(self.grip.plies.len());
        let after = &sections[next.min(sections.len())..(next + 1).min(sections.len())];
        let before = if next > 0 { &sections[next - 1..next] } else { &[] };
        let outer = after.is_empty() || before.is_empty();
        let Ply { part: ply, room, .. } = &self.grip.plies[i];
        let cuts = if after.is_empty() { [before, after] } else { [after, before] };
        if room.is_some_and(|r| r.oblique) {
            // the least of all directions, for the resultant
            let least = resistances.as_flattened().iter().copied().fold(f64::INFINITY, f64::min);
            let across = self.open_directions();
            let needed = !outer || least < self.bolt.shear;
            if needed && !across.is_empty() {
                let name = format!("{} in bearing on {ply}", self.grip.part);
                let set = Set { along: [0.0; 3], across, at_most: least };
                self.limit(out, name, cuts, set);
            }
            return;
        }
        for (slot, k) in self.open() {
            for (sign, resistance) in [-1.0, 1.0].into_iter().zip(resistances[slot]) {
                if outer && resistance >= self.bolt.shear {
                    continue;
                }
                let way = if sign < 0.0 { "-" } else { "+" };
                let name =
                    format!("{} in bearing on {ply} toward {way}{}", self.grip.part, NAMES[k]);
                let mut along = [0.0; 3];
                along[k] = if after.is_empty() { -sign } else { sign };
                self.limit(out, name, cuts, Set::along(along, resistance));
            }
        }
    }
}

/// `along · R + ‖across R‖ ≤ at_most` of the whole bolt.
struct Set {
    along: [f64; 3],
    across: Vec<[f64; 3]>,
    at_most: f64,
}

impl Set {
    fn along(along: [f64; 3], at_most: f64) -> Self {
        Self { along, across: Vec::new(), at_most }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::assembly::{Room, Surface};
    use crate::catalog::Catalog;
    use crate::geometry::fixtures::lap_joint;
    use crate::model_file::{Asked, model_file};
    use crate::strength::{Design, Nominal};
    use bracket_engine::mesh::NamedFaces;
    use bracket_engine::model::AnalysisKind;
    use bracket_engine::model::file::ModelFile;

    /// The lap with the grip of its bolt: head above, nut below.
    fn gripped() -> Assembly {
        let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
        let plane = |at: f64| Surface::Plane {
            axis: 2,
            at,
            min: [-15.0, -15.0, at],
            max: [15.0, 15.0, at],
        };
        let ply = |part: &str| Ply {
            part: part.into(),
            thickness: 10.0,
            fu: Nominal::new(360.0),
            room: None,
        };
        let mut joint = lap_joint();
        joint.grips = vec![Grip {
            part: "BOLT".into(),
            axis: [0.0, 0.0, -1.0],
            size: catalog.bolt("M16").expect("listed").clone(),
            grade: catalog.bolt_grade("8.8").expect("listed").clone(),
            hole: 18.0,
            extent: 0.0,
            anchored: false,
            plies: vec![ply("UPPER"), ply("LOWER")],
        }];
        joint.sections = vec![Section {
            part: "BOLT".into(),
            name: "SECTION_BOLT_1".into(),
            surface: plane(0.0),
        }];
        joint
    }

    fn model(
        joint: &Assembly,
        strengths: &DesignStrengths,
        axes: &[usize],
        kind: AnalysisKind,
    ) -> ModelFile {
        let faces = ["SECTION_BOLT_1", "BASE", "PULL"].into_iter().map(String::from);
        let mesh = TetMesh {
            bodies: ["UPPER", "LOWER", "BOLT"].map(String::from).to_vec(),
            faces: faces.map(|name| NamedFaces { name, triangles: vec![] }).collect(),
            ..TetMesh::default()
        };
        let planes: Vec<SymmetryPlane> = axes.iter().map(|&axis| SymmetryPlane { axis }).collect();
        model_file(joint, strengths, &mesh, &planes, "mesh.msh", &Asked::new("PULL", kind))
    }

    /// The shear plane with punching, and bearing of either ply by direction; half of it where a
    /// plane of symmetry halves the bolt, without the forces across the plane. Nothing outside
    /// limit analysis, and nothing without resistances.
    #[test]
    fn the_sections_of_a_bolt_have_its_resistances() {
        let joint = gripped();
        let bolt = BoltLimits {
            shank: Design::new(500.0),
            tension: 100e3,
            shear: 70e3,
            interaction: 1.4,
            punching: [110e3, 90e3],
            bearing: vec![Some([[1e3, 80e3], [3e3, 4e3]]), Some([[5e3, 6e3], [80e3, 80e3]])],
        };
        let known = DesignStrengths {
            bolts: [("BOLT".to_string(), bolt)].into(),
            materials: joint.materials.keys().map(|k| (k.clone(), None)).collect(),
            ..DesignStrengths::default()
        };
        let whole = model(&joint, &known, &[], AnalysisKind::Limit);
        assert_eq!(whole.cuts.len(), 1);
        let key = &joint.parts.iter().find(|p| p.name == "BOLT").expect("a bolt").material;
        assert_eq!(whole.materials[key].fy, Some(500.0));
        let told = |m: &ModelFile| -> Vec<(String, [f64; 3], usize, f64)> {
            let limits = m.resultant_limits.iter();
            limits.map(|l| (l.name.clone(), l.along, l.across.len(), l.at_most)).collect()
        };
        let entry =
            |name: &str, along, across, at_most| (format!("BOLT {name}"), along, across, at_most);
        let down = [0.0, 0.0, -1.0];
        let bearing = |ply: &str, way: &str| format!("in bearing on {ply} toward {way}");
        // none where a ply carries more than the bolt in shear; the force on the lower ply is
        // opposite to that on the section
        let want = [
            entry("in shear plane 1: punching", down, 0, 90e3),
            entry("in shear plane 1: shear", [0.0; 3], 2, 70e3),
            entry("in shear plane 1: tension and shear", [0.0, 0.0, -0.5], 2, 70e3),
            entry(&bearing("UPPER", "-x"), [-1.0, 0.0, 0.0], 0, 1e3),
            entry(&bearing("UPPER", "-y"), [0.0, -1.0, 0.0], 0, 3e3),
            entry(&bearing("UPPER", "+y"), [0.0, 1.0, 0.0], 0, 4e3),
            entry(&bearing("LOWER", "-x"), [1.0, 0.0, 0.0], 0, 5e3),
            entry(&bearing("LOWER", "+x"), [-1.0, 0.0, 0.0], 0, 6e3),
        ];
        assert_eq!(told(&whole), want);
        let section = ["SECTION_BOLT_1".to_string()];
        assert!(whole.resultant_limits.iter().all(|l| l.cuts == section && l.minus.is_empty()));
        let half = model(&joint, &known, &[1], AnalysisKind::Limit);
        let halved: Vec<_> = want
            .into_iter()
            .filter(|(name, ..)| !name.ends_with('y'))
            .map(|(name, along, across, most)| (name, along, across / 2, most / 2.0))
            .collect();
        assert_eq!(told(&half), halved);
        // a turned ply: the least resistance, for the resultant
        let mut turned = joint.clone();
        let (edge, pitch) = ([[30.0; 2]; 2], [[60.0; 2]; 2]);
        turned.grips[0].plies[0].room = Some(Room { edge, pitch, oblique: true });
        let oblique = told(&model(&turned, &known, &[], AnalysisKind::Limit));
        let upper: Vec<_> = oblique.iter().filter(|l| l.0.contains("UPPER")).collect();
        assert_eq!(upper, [&entry("in bearing on UPPER", [0.0; 3], 2, 1e3)]);
        let elastic = model(&joint, &known, &[], AnalysisKind::Elastic);
        assert!(elastic.cuts.is_empty() && elastic.resultant_limits.is_empty());
        let none = model(&joint, &DesignStrengths::default(), &[], AnalysisKind::Limit);
        assert!(none.cuts.is_empty() && none.resultant_limits.is_empty());
    }
}
