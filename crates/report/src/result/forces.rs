//! Forces of bolts and between parts, from the stress of the lower bound.

use bracket_base::math::vec3::{self, V3};
use bracket_engine::certify::fields::StressField;
use bracket_engine::certify::resultants::contact_resultants;
use bracket_engine::model::AnalysisModel;
use bracket_joint::assembly::BoltLine;
use serde::{Deserialize, Serialize};

/// Distance below which a coordinate lies on a plane of symmetry \[mm\].
pub(crate) const ON_PLANE: f64 = 1e-6;

/// Forces in equilibrium with the loads times `load_factor`. In elastic analysis they are estimates
/// of the forces of the bolts. In limit analysis they are one of the possible plastic
/// distributions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StaticForces {
    /// The load factor they belong to.
    pub load_factor: f64,
    /// Bolts of the meshed part. If a plane of symmetry halves a bolt, the forces are those of the
    /// whole bolt.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bolts: Vec<BoltForce>,
    /// Compression between the parts, except at contacts with bolts. If a plane of symmetry cuts a
    /// contact, the force is that of the whole contact.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<ContactForce>,
}

/// Force of a bolt, from the contact under its nut.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoltForce {
    /// Name of the bolt.
    pub bolt: String,
    /// Tension, prying included \[N\].
    pub tension: f64,
    /// Shear \[N\].
    pub shear: f64,
    /// Position of the bolt.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place: Option<BoltPlace>,
}

/// Position of a bolt and the part from whose stress its force is computed. With these data the
/// force can be recomputed from the field.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoltPlace {
    /// The part under its nut.
    pub under: String,
    /// Unit vector from head to nut.
    pub axis: [f64; 3],
    /// Centre of the head's bearing face \[mm\].
    pub position: [f64; 3],
}

/// Compression between two parts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ContactForce {
    /// The two parts.
    pub between: [String; 2],
    /// ∫ r_N dA \[N\].
    pub compression: f64,
    /// Centre of pressure \[mm\]; 0 across the planes of symmetry that cut the contact.
    pub centre: [f64; 3],
}

/// The forces of a stress field. `mirror` contains the axes of the planes of symmetry, which pass
/// through the origin.
pub fn static_forces(
    model: &AnalysisModel,
    stress: &StressField,
    load_factor: f64,
    lines: &[BoltLine],
    mirror: &[usize],
) -> StaticForces {
    let bodies = &model.mesh.bodies;
    let found = contact_resultants(model, stress);
    let force_on = |bolt: &str, part: &str| -> Option<V3> {
        found.iter().find_map(|c| {
            let (a, b) = (bodies.get(c.between.0 as usize)?, bodies.get(c.between.1? as usize)?);
            match () {
                () if a == bolt && b == part => Some(c.force),
                () if a == part && b == bolt => Some(vec3::scale(-1.0, c.force)),
                () => None,
            }
        })
    };
    let bolts = lines.iter().filter_map(|line| {
        let mut force = force_on(&line.part, &line.last)?;
        for &k in mirror {
            if line.axis[k] == 0.0 && line.position[k].abs() < ON_PLANE {
                // the other half: components in the plane are doubled, those across it cancel
                force = vec3::scale(2.0, force);
                force[k] = 0.0;
            }
        }
        let tension = vec3::dot(force, line.axis);
        let shear = vec3::norm(vec3::along(force, -tension, line.axis));
        let place =
            BoltPlace { under: line.last.clone(), axis: line.axis, position: line.position };
        Some(BoltForce { bolt: line.part.clone(), tension, shear, place: Some(place) })
    });
    let is_bolt = |name: &String| lines.iter().any(|l| l.part == *name);
    let contacts = found.iter().filter_map(|c| {
        let (a, b) = (bodies.get(c.between.0 as usize)?, bodies.get(c.between.1? as usize)?);
        let mut centre = c.centre.filter(|_| !is_bolt(a) && !is_bolt(b))?;
        let mut compression = c.compression;
        for &k in mirror {
            let ends = c.extent.map(|x| x[k].abs());
            if ends[0].min(ends[1]) < ON_PLANE && ends[0].max(ends[1]) > ON_PLANE {
                // the other half of the contact
                compression *= 2.0;
                centre[k] = 0.0;
            }
        }
        Some(ContactForce { between: [a.clone(), b.clone()], compression, centre })
    });
    StaticForces { load_factor, bolts: bolts.collect(), contacts: contacts.collect() }
}
