//! What the folder of a run shows of its input: facts of the reports, and files made of the input
//! alone.

use bracket_report::draw::moment_rotation;
use bracket_report::markdown::report_data::InputFacts;

/// The input of a run as its folder presents it.
#[derive(Clone, Debug, Default)]
pub struct RunContext {
    /// What the reports say of the input.
    pub input: InputFacts,
    /// Files made from the input alone, name and text: drawings, and the end plate as DXF.
    pub files: Vec<(String, String)>,
    /// What the diagram of moment and rotation shows beside the resistance.
    pub rotation: moment_rotation::Frame,
    /// What the capacity polygon of N and My shows of the code: corners N, My \[N, N mm\].
    pub axial_moment: Option<Vec<[f64; 2]>>,
}
