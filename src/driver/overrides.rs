//! What a caller sets in place of the `analysis` of a spec.

use crate::driver::meshing::Extent;
use bracket_engine::model::AnalysisKind;
use bracket_report::markdown::report_data::ResolvedValue;

/// Name of the kind of analysis among the values that the report resolves.
pub const KIND: &str = "analysis.kind";
/// Name of the factor on the element sizes among them.
pub const SIZE_FACTOR: &str = "mesh size factor";
/// Origin of what an option of the command line sets.
pub const COMMAND_LINE: &str = "command line";

/// What a caller sets in place of the `analysis` of a spec.
#[derive(Clone, Copy, Debug, Default)]
pub struct Overrides {
    /// Part of the joint that is meshed, and fineness of the mesh.
    pub extent: Extent,
    /// Kind of analysis, in place of `analysis.kind`.
    pub kind: Option<AnalysisKind>,
    /// Largest number of meshes, in place of `analysis.max_passes`.
    pub max_passes: Option<u32>,
}

impl Overrides {
    /// True if limit analysis may be among the kinds of analysis.
    pub fn allow_limit(&self) -> bool {
        matches!(self.kind, None | Some(AnalysisKind::Limit))
    }

    /// The values that are set, as the report lists them.
    pub fn resolved(&self) -> Vec<ResolvedValue> {
        let factor = Some(self.extent.size_factor).filter(|f| *f != 1.0);
        [
            (KIND, self.kind.map(|k| k.word().into())),
            ("analysis.max_passes", self.max_passes.map(|n| n.to_string().into())),
            (SIZE_FACTOR, factor.map(|f| f.to_string().into())),
        ]
        .into_iter()
        .filter_map(|(name, value)| {
            let (name, origin) = (name.into(), COMMAND_LINE.into());
            Some(ResolvedValue { name, value: value?, unit: String::new(), origin })
        })
        .collect()
    }
}
