//! The two fields of an analysis as plain data, which is certified, stored and drawn.

use crate::elements::super_element::PointStress;
use bracket_base::math::vec3::V3;

/// Displacements of vertices and mid-side nodes, in the order of
/// [`crate::elements::space::Tet10Space`] \[mm\].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DisplacementField {
    /// Displacement of each node.
    pub u: Vec<V3>,
}

/// Stress at the points of each macro tet's four subtets, Mandel form \[MPa\].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StressField {
    /// Stress of each macro tet, `[subtet][point]` as in [`crate::elements::super_element`].
    pub points: Vec<PointStress>,
}

impl StressField {
    /// Zero stress.
    pub fn none(tets: usize) -> Self {
        Self { points: vec![[[[0.0; 6]; 4]; 4]; tets] }
    }
}
