//! What elastoplastic analysis with elastic bolts shows of a joint on one mesh. Every number is an
//! estimate.

use serde::{Deserialize, Serialize};

/// Estimates from the fields of one mesh.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Evidence {
    /// Number of tets of the mesh of the displacement.
    pub tets: usize,
    /// Forces in the sections of the bolts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bolts: Vec<BoltSections>,
    /// Mean strains of plates, flanges and webs; none without a displacement field.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub plates: Vec<PlateStrain>,
    /// Lines of force of the fillet welds; none without a stress field.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub welds: Vec<WeldForces>,
}

/// Forces in the sections of a bolt's shank, from head to nut.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoltSections {
    /// The bolt's part.
    pub bolt: String,
    /// The sections between its plies.
    pub sections: Vec<SectionForce>,
}

/// Force in a section of a whole bolt: that of the part toward the nut on the part toward the head
/// \[N\], global axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SectionForce {
    /// From the stress of the lower bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub by_stress: Option<[f64; 3]>,
    /// From the displacement of the upper bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub by_displacement: Option<[f64; 3]>,
}

/// Largest mean strains of a plate, flange or web, as fractions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlateStrain {
    /// Its part.
    pub part: String,
    /// Its thickness \[mm\].
    pub thickness: f64,
    /// Largest principal strain of the membrane: of the mean strain over a prism of the thickness.
    pub membrane: f64,
    /// Centre of that prism \[mm\].
    pub membrane_at: [f64; 3],
    /// Largest mean equivalent plastic strain in a quarter of the thickness at either surface.
    pub surface: f64,
    /// Centre of that layer \[mm\].
    pub surface_at: [f64; 3],
}

/// The lowest critical factors of the loads on a mesh and on the mesh with eight tets for each one;
/// rising, and none where nothing can buckle. Estimates: those of either mesh are upper bounds for
/// its stress.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CriticalFactors {
    /// On the mesh of the fields.
    pub coarse: Vec<CriticalMode>,
    /// On the mesh twice as fine.
    pub fine: Vec<CriticalMode>,
}

/// A mode of linear buckling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CriticalMode {
    /// α_cr: the load factor at which it buckles elastically.
    pub factor: f64,
    /// The part with the largest share of the strain energy.
    pub part: String,
    /// That share, a fraction.
    pub share: f64,
    /// Where it moves most \[mm\].
    pub at: [f64; 3],
    /// Normals of the planes of symmetry to which it is antisymmetric, 0 = x; it is symmetric to
    /// the others.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub antisymmetric: Vec<usize>,
}

/// Lines of force of a weld, or of the two welds on either side of a plate.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeldForces {
    /// Name of the weld.
    pub weld: String,
    /// Forces per length, averaged over short lengths.
    pub segments: Vec<WeldForce>,
}

/// Forces per length of weld, averaged over a segment.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeldForce {
    /// Start and end along the weld \[mm\].
    pub from_to: [f64; 2],
    /// Normal to the interface, tension positive \[N/mm\].
    pub normal: f64,
    /// Across the weld, in the interface \[N/mm\].
    pub across: f64,
    /// Along the weld \[N/mm\].
    pub along: f64,
    /// Couple about the line of the weld \[N mm/mm\].
    pub couple: f64,
}
