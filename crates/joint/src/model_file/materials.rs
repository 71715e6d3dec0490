//! The materials of a model: the design strengths of the parts of a joint.

use crate::assembly::Assembly;
use crate::assembly::assembly::Part;
use crate::strength::DesignStrengths;
use bracket_engine::model::file::MaterialEntry;
use std::collections::BTreeMap;

/// End of the key of a steel whose parts with holes are weaker than it.
const WITH_HOLES: &str = "_WITH_HOLES";

/// End of the key of a bolt's material where the bolts stay elastic.
const ELASTIC: &str = "_ELASTIC";

/// The materials of the meshed parts, and the material of each part. A part with holes may be
/// weaker than its steel, and a bolt whose forces are limited has the yield strength of `shanks`.
/// Parts with the same key share the least of their strengths. Parts that `stay_elastic` do not
/// yield.
pub(super) fn materials(
    assembly: &Assembly,
    kept: &[&Part],
    (strengths, shanks): (&DesignStrengths, &BTreeMap<String, f64>),
    stay_elastic: impl Fn(&Part) -> bool,
) -> (BTreeMap<String, MaterialEntry>, BTreeMap<String, String>) {
    let mut materials: BTreeMap<String, MaterialEntry> = BTreeMap::new();
    let mut bodies = BTreeMap::new();
    for part in kept {
        let key = &part.material;
        let (Some(m), Some(fy)) = (assembly.materials.get(key), strengths.materials.get(key))
        else {
            bodies.insert(part.name.clone(), key.clone());
            continue;
        };
        if stay_elastic(part) {
            let key = format!("{key}{ELASTIC}");
            let e = m.e * m.strength.stiffness_share();
            materials.insert(key.clone(), MaterialEntry { e, nu: m.nu, fy: None });
            bodies.insert(part.name.clone(), key);
            continue;
        }
        let fy = shanks.get(&part.name).copied().or(fy.map(|s| s.mpa()));
        let net = strengths.perforated.get(&part.name).map(|s| s.mpa());
        let (key, fy) = match (net, fy) {
            (Some(net), Some(fy)) if net < fy => (format!("{key}{WITH_HOLES}"), Some(net)),
            _ => (key.clone(), fy),
        };
        let entry = materials.entry(key.clone()).or_insert(MaterialEntry { e: m.e, nu: m.nu, fy });
        entry.fy = [entry.fy, fy].into_iter().flatten().reduce(f64::min);
        bodies.insert(part.name.clone(), key);
    }
    (materials, bodies)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::assembly::PartRole;
    use crate::geometry::fixtures::lap_joint;
    use crate::strength::{BoltShank, Design, Nominal, NominalStrength};

    /// The materials of the lap joint of these strengths, and the material of each part.
    fn of_lap(
        joint: &Assembly,
        known: &DesignStrengths,
        stay_elastic: impl Fn(&Part) -> bool,
    ) -> impl Fn(&str) -> (f64, Option<f64>) {
        let kept: Vec<&Part> = joint.parts.iter().collect();
        let (materials, bodies) = materials(joint, &kept, (known, &BTreeMap::new()), stay_elastic);
        move |part| {
            let entry = &materials[&bodies[part]];
            (entry.e, entry.fy)
        }
    }

    /// A part with holes has a material of its own where it is weaker than its steel.
    #[test]
    fn a_part_with_holes_may_be_weaker_than_its_steel() {
        let joint = lap_joint();
        let net = [("UPPER", 300.0), ("LOWER", 400.0)];
        let known = DesignStrengths {
            materials: [("steel".to_string(), Some(Design::new(355.0)))].into(),
            perforated: net.map(|(part, f)| (part.to_string(), Design::new(f))).into(),
            ..DesignStrengths::default()
        };
        let of = of_lap(&joint, &known, |_| false);
        let fy = ["UPPER", "LOWER", "BOLT"].map(|part| of(part).1);
        assert_eq!(fy, [Some(300.0), Some(355.0), Some(355.0)]);
    }

    /// Bolts that stay elastic do not yield and have the stiffness of their stress area; the other
    /// parts of the same material keep it.
    #[test]
    fn elastic_bolts_stretch_with_their_stress_area() {
        let mut joint = lap_joint();
        let shank = BoltShank { fub: Nominal::new(800.0), stress_area: 157.0, shank_area: 201.0 };
        if let Some(m) = joint.materials.get_mut("steel") {
            m.strength = NominalStrength::Bolt(shank);
        }
        let known = DesignStrengths {
            materials: [("steel".to_string(), Some(Design::new(500.0)))].into(),
            ..DesignStrengths::default()
        };
        let of = of_lap(&joint, &known, |part| part.role == PartRole::Bolt);
        assert_eq!(of("BOLT"), (210_000.0 * (157.0 / 201.0), None));
        assert_eq!(of("UPPER"), (210_000.0, Some(500.0)));
    }
}
