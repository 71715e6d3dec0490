//! The data of a bolted cover-plate splice for the hand checks: two members of I sections, end to
//! end, joined by cover plates on their flanges and on both sides of their webs.

use super::actions::PlaneActions;
use super::content::NotChecked;
use super::end_plate::UnseenLoad;
use crate::catalog::{BoltGrade, BoltSize, IProfile};
use crate::spec::code::{FySource, PartialFactors};
use crate::spec::connection::BoltCategory;
use crate::strength::Strength;
use serde::Serialize;

/// What the spliced members are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SpliceUse {
    /// Beams.
    Beam,
    /// Columns.
    Column {
        /// True if their ends are prepared for full contact in bearing, which then transfers
        /// compression.
        contact: bool,
    },
}

/// One of the two members. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SplicedMember {
    /// Its section.
    pub section: IProfile,
    /// Its steel at the thickness of its flange.
    pub flange_steel: Strength,
    /// Its steel at the thickness of its web.
    pub web_steel: Strength,
    /// z of its axis from the axis in which the actions act; not 0 where two depths are flush at
    /// one flange.
    pub axis: f64,
    /// Thickness of the packs between the outer cover and the upper flange, and the lower flange;
    /// 0: no packs.
    pub packs: [f64; 2],
    /// Thickness of the packs between a flange and its inner covers; 0: no packs.
    pub inner_packs: f64,
    /// Thickness of the packs on each side of the web; 0: no packs.
    pub web_packs: f64,
}

/// A cover plate. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CoverPlate {
    /// Thickness.
    pub thickness: f64,
    /// Size across the members: the width of a cover of a flange, the height of a cover of a web.
    pub width: f64,
    /// Length along the members; the cover reaches as far to either side of the splice.
    pub length: f64,
    /// Its steel.
    pub steel: Strength,
}

/// A pair of covers inside a flange, one on each side of the web.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InnerCovers {
    /// Each of the two covers.
    pub plate: CoverPlate,
    /// Distance of their inner edges from the middle of the web \[mm\].
    pub from: f64,
}

/// A bolted cover-plate splice, the same on both sides of the gap and at both flanges, but for
/// packs. Lengths in mm; x is measured from the splice axis (the middle of the gap) along a member,
/// z from the axis in which the actions act, positive upwards.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CoverSplice {
    /// What the members are.
    pub used: SpliceUse,
    /// The member before the splice axis.
    pub left: SplicedMember,
    /// The member behind it.
    pub right: SplicedMember,
    /// Distance between the ends of the members.
    pub gap: f64,
    /// The cover outside each flange.
    pub outer: CoverPlate,
    /// The covers inside each flange, if there are any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inner: Option<InnerCovers>,
    /// Each of the two covers of the web.
    pub web: CoverPlate,
    /// z of the middle of the web covers.
    pub web_middle: f64,
    /// x of the bolt rows of a flange, rising; the same on either side of the splice axis.
    pub flange_rows: Vec<f64>,
    /// Distances between the bolts of each pair of columns of a flange, rising: one for two bolts
    /// in a row, two for four.
    pub gauges: Vec<f64>,
    /// z of the bolt rows of the web, rising.
    pub web_rows: Vec<f64>,
    /// x of the bolt columns of the web, rising; the same on either side of the splice axis.
    pub web_columns: Vec<f64>,
    /// Size of the bolts.
    pub bolt: BoltSize,
    /// Grade of the bolts.
    pub grade: BoltGrade,
    /// Diameter of the holes.
    pub hole: f64,
    /// Thickness that the bolts of the flanges clamp; the largest, if they differ.
    pub flange_grip: f64,
    /// Thickness that the bolts of the webs clamp; the largest, if they differ.
    pub web_grip: f64,
    /// What the geometry has and the checks do not cover.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_checked: Vec<NotChecked>,
    /// Actions at the splice axis: one entry per load case and member end.
    pub actions: Vec<PlaneActions>,
    /// Preload of a bolt \[N\]; `None`: the bolts are not preloaded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub preload: Option<f64>,
    /// Category of the bolts, if the spec gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub category: Option<BoltCategory>,
    /// Friction coefficient of the contact surfaces.
    pub mu: f64,
    /// Loads that the checks leave out.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unseen: Vec<UnseenLoad>,
    /// National annex, as the catalogue names it; `None`: the recommended values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub annex: Option<String>,
    /// Table that the yield strengths come from.
    pub fy_source: FySource,
    /// Partial factors of the design code.
    #[serde(flatten)]
    pub factors: PartialFactors,
}

impl CoverSplice {
    /// y of every column of bolts of a flange, rising \[mm\].
    pub fn flange_columns(&self) -> Vec<f64> {
        let mut out: Vec<f64> = self.gauges.iter().flat_map(|g| [-0.5 * g, 0.5 * g]).collect();
        out.sort_by(f64::total_cmp);
        out
    }

    /// Number of bolts of one flange on one side of the splice axis.
    pub fn flange_bolts(&self) -> usize {
        2 * self.gauges.len() * self.flange_rows.len()
    }

    /// Number of bolts of the web on one side of the splice axis.
    pub fn web_bolts(&self) -> usize {
        self.web_rows.len() * self.web_columns.len()
    }

    /// Planes in which a bolt of a flange is sheared: 1, or 2 with covers inside the flange.
    pub fn flange_planes(&self) -> u32 {
        1 + u32::from(self.inner.is_some())
    }

    /// Name of a load case: with the member end where actions stand at several ends.
    pub fn case_name(&self, a: &PlaneActions) -> String {
        match self.actions.iter().any(|other| other.end != a.end) {
            true => format!("{}, {}", a.case, a.end),
            false => a.case.clone(),
        }
    }
}
