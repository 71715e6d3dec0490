//! Bolt sizes (with head, nut, washer and hole) and bolt grades.

use super::error::CatalogError;
use super::name::bolt_grade_key;
use super::source::Source;
use super::table::{Columns, Entry, RawTable};
use bracket_base::units::limits;
use serde::Serialize;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// Name of the system of plain hexagon bolts, nuts and washers.
pub const PLAIN_SYSTEM: &str = "ISO 4014";

/// A bolt assembly of one size. All lengths are in mm.
///
/// # Source
/// Plain bolts: thread ISO 261 / ISO 898-1, head ISO 4014, nut ISO 4032, washer ISO 7089, holes EN
/// 1090-2 Table 11. Preloaded systems: head and nut EN 14399-3 (HR) or EN 14399-4 (HV), washer EN
/// 14399-6; thread and holes as for plain bolts.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoltSize {
    /// System: `ISO 4014` (plain), `HR` or `HV`.
    pub system: String,
    /// Size, for example `M18`.
    pub size: String,
    /// Standard of the head and the nut.
    pub standard: String,
    /// Whether engineers normally specify this size.
    pub preferred: bool,
    /// Nominal diameter of the shank \[mm\].
    pub d: f64,
    /// Pitch of the coarse thread \[mm\].
    pub pitch: f64,
    /// Gross area of the shank as tabulated, π d²/4 \[mm²\].
    pub area: f64,
    /// Tensile stress area of the thread \[mm²\].
    pub stress_area: f64,
    /// Diameter of a normal round hole \[mm\].
    pub hole_normal: f64,
    /// Diameter of an oversize round hole \[mm\].
    pub hole_oversize: f64,
    /// Overall length of a short slot \[mm\].
    pub slot_short: f64,
    /// Overall length of a long slot \[mm\].
    pub slot_long: f64,
    /// Width across flats of the head \[mm\].
    pub head_width: f64,
    /// Least width across corners of the head \[mm\].
    pub head_corners: f64,
    /// Height of the head \[mm\].
    pub head_height: f64,
    /// Length of the thread of bolts up to 125 mm long \[mm\].
    pub thread_length: f64,
    /// Width across flats of the nut \[mm\].
    pub nut_width: f64,
    /// Height of the nut \[mm\].
    pub nut_height: f64,
    /// Inner diameter of the washer \[mm\].
    pub washer_inner: f64,
    /// Outer diameter of the washer \[mm\].
    pub washer_outer: f64,
    /// Thickness of the washer \[mm\].
    pub washer_thickness: f64,
    /// File and line of the row.
    pub source: Source,
}

impl BoltSize {
    pub(super) const COLUMNS: Columns = Columns {
        kind: "bolts",
        needed: &[
            "size",
            "preferred",
            "d_mm",
            "pitch_mm",
            "A_mm2",
            "As_mm2",
            "d0_normal_mm",
            "d0_oversize_mm",
            "slot_short_length_mm",
            "slot_long_length_mm",
            "head_s_mm",
            "head_e_min_mm",
            "head_k_mm",
            "thread_b_mm",
            "nut_s_mm",
            "nut_m_mm",
            "washer_d1_mm",
            "washer_d2_mm",
            "washer_t_mm",
        ],
        optional: &[],
    };

    pub(super) const PRELOADED_COLUMNS: Columns = Columns {
        kind: "preloaded bolts",
        needed: &[
            "system",
            "standard",
            "size",
            "d_mm",
            "head_s_mm",
            "head_e_min_mm",
            "head_k_nom_mm",
            "thread_b_mm",
            "nut_s_mm",
            "nut_m_mm",
            "washer_d1_min_mm",
            "washer_d2_max_mm",
            "washer_h_nom_mm",
            "washer_standard",
        ],
        optional: &[],
    };

    /// Reads a table of plain bolts.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::COLUMNS)?;
        let mut bolts = Vec::new();
        for row in table.rows() {
            let bolt = Self {
                system: PLAIN_SYSTEM.to_owned(),
                size: row.text("size")?,
                standard: "ISO 4014 / ISO 4032 / ISO 7089".to_owned(),
                preferred: row.flag("preferred")?,
                d: row.within("d_mm", 4.0..=150.0, "the diameter of a bolt in mm")?,
                pitch: row.positive("pitch_mm")?,
                area: row.positive("A_mm2")?,
                stress_area: row.positive("As_mm2")?,
                hole_normal: row.positive("d0_normal_mm")?,
                hole_oversize: row.positive("d0_oversize_mm")?,
                slot_short: row.positive("slot_short_length_mm")?,
                slot_long: row.positive("slot_long_length_mm")?,
                head_width: row.positive("head_s_mm")?,
                head_corners: row.positive("head_e_min_mm")?,
                head_height: row.positive("head_k_mm")?,
                thread_length: row.positive("thread_b_mm")?,
                nut_width: row.positive("nut_s_mm")?,
                nut_height: row.positive("nut_m_mm")?,
                washer_inner: row.positive("washer_d1_mm")?,
                washer_outer: row.positive("washer_d2_mm")?,
                washer_thickness: row.positive("washer_t_mm")?,
                source: row.source(),
            };
            bolt.check().map_err(|(column, problem)| row.fault(column, problem))?;
            bolts.push(bolt);
        }
        Ok(bolts)
    }

    /// Reads a table of preloaded assemblies. Thread and holes are taken from the plain bolt of the
    /// same size.
    pub(super) fn read_preloaded<'a>(
        table: &RawTable,
        plain: impl Fn(&str) -> Option<&'a Self>,
    ) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::PRELOADED_COLUMNS)?;
        let mut bolts = Vec::new();
        for row in table.rows() {
            let size = row.text("size")?;
            let base = plain(&size).ok_or_else(|| {
                row.fault(
                    "size",
                    format!("`{size}` has no row in the table of plain bolts (thread, holes)"),
                )
            })?;
            if row.positive("d_mm")? != base.d {
                return Err(
                    row.fault("d_mm", format!("differs from {} mm of the plain {size}", base.d))
                );
            }
            let bolt = Self {
                system: row.text("system")?,
                standard: format!("{} / {}", row.text("standard")?, row.text("washer_standard")?),
                head_width: row.positive("head_s_mm")?,
                head_corners: row.positive("head_e_min_mm")?,
                head_height: row.positive("head_k_nom_mm")?,
                thread_length: row.positive("thread_b_mm")?,
                nut_width: row.positive("nut_s_mm")?,
                nut_height: row.positive("nut_m_mm")?,
                washer_inner: row.positive("washer_d1_min_mm")?,
                washer_outer: row.positive("washer_d2_max_mm")?,
                washer_thickness: row.positive("washer_h_nom_mm")?,
                source: row.source(),
                ..base.clone()
            };
            bolt.check().map_err(|(column, problem)| row.fault(column, problem))?;
            bolts.push(bolt);
        }
        Ok(bolts)
    }

    /// Refuses impossible sizes: a hole smaller than the shank, a head that passes through its
    /// hole, areas that contradict the diameter.
    fn check(&self) -> Result<(), (&'static str, String)> {
        let less = |column, a: f64, what: &str, b: f64| {
            if a < b { Ok(()) } else { Err((column, format!("{what} {b} must exceed {a}"))) }
        };
        less("d0_normal_mm", self.d, "the hole", self.hole_normal)?;
        less("d0_oversize_mm", self.hole_normal, "the oversize hole", self.hole_oversize)?;
        less("head_s_mm", self.hole_normal, "the head", self.head_width)?;
        less("nut_s_mm", self.hole_normal, "the nut", self.nut_width)?;
        less("washer_d2", self.washer_inner, "the washer's outer diameter", self.washer_outer)?;
        less("As_mm2", self.stress_area, "the gross area", self.area)?;
        let shank = 0.25 * PI * self.d * self.d;
        let near = |column, value: f64, least: f64, most: f64| match value {
            v if limits::within(v, &(least * shank..=most * shank)) => Ok(()),
            v => Err((
                column,
                format!(
                    "{v} contradicts d = {} mm and its pitch {} mm: it lies between {:.1} and \
                     {:.1}",
                    self.d,
                    self.pitch,
                    least * shank,
                    most * shank
                ),
            )),
        };
        near("A_mm2", self.area, 0.95, 1.05)?;
        // the stress area of an ISO thread, ISO 898-1: π/4 (d − 0.9382 P)²
        let thread = (1.0 - 0.9382 * self.pitch / self.d).max(0.0).powi(2);
        near("As_mm2", self.stress_area, 0.95 * thread, 1.05 * thread)?;
        let wide = |column, value: f64, what: &str| {
            let most = 4.0 * self.d;
            let known = limits::at_most(value, most);
            let problem = || format!("{value}; {what} of d = {} mm is at most {most}", self.d);
            if known { Ok(()) } else { Err((column, problem())) }
        };
        wide("d0_oversize_mm", self.hole_oversize, "the hole for a bolt")?;
        wide("head_s_mm", self.head_width, "the head of a bolt")?;
        wide("nut_s_mm", self.nut_width, "the nut of a bolt")?;
        wide("washer_d2_mm", self.washer_outer, "the washer of a bolt")
    }
}

impl Entry for BoltSize {
    const NOUN: &'static str = "bolt";
    const KIND: &'static str = "bolts";
    const SIZED: bool = true;
    fn name(&self) -> String {
        if self.system == PLAIN_SYSTEM {
            self.size.clone()
        } else {
            format!("{} {}", self.system, self.size)
        }
    }
    fn source(&self) -> &Source {
        &self.source
    }
}

/// Strength of a bolt grade.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.1 (nominal strengths), Table 3.4 (α_v).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoltGrade {
    /// Grade, for example `8.8`.
    pub grade: String,
    /// Nominal yield strength \[MPa\].
    pub fyb: f64,
    /// Nominal ultimate strength \[MPa\].
    pub fub: f64,
    /// Shear factor α_v with the thread in the shear plane \[-\].
    pub alpha_v_thread: f64,
    /// Shear factor α_v with the shank in the shear plane \[-\].
    pub alpha_v_shank: f64,
    /// Whether bolts of this grade may be preloaded.
    pub preloadable: bool,
    /// Standard of the bolts, given where EN 1993-1-8 does not name it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard: Option<String>,
    /// File and line of the row.
    pub source: Source,
}

/// Shear factors of bolts; EN 1993-1-8 has 0.5 and 0.6.
const ALPHA_V: RangeInclusive<f64> = 0.3..=0.7;
const SHEAR: &str = "the shear factor α_v of a bolt";

impl BoltGrade {
    pub(super) const COLUMNS: Columns = Columns {
        kind: "bolt grades",
        needed: &[
            "grade",
            "fyb_MPa",
            "fub_MPa",
            "alpha_v_threads_in_shear_plane",
            "alpha_v_shank_in_shear_plane",
            "preloadable",
        ],
        optional: &["standard"],
    };

    /// Reads a table of bolt grades.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::COLUMNS)?;
        let mut grades = Vec::new();
        for row in table.rows() {
            let grade = Self {
                grade: row.text("grade")?,
                fyb: row.within(
                    "fyb_MPa",
                    150.0..=1500.0,
                    "the yield strength of a bolt in MPa",
                )?,
                fub: row.within(
                    "fub_MPa",
                    250.0..=1700.0,
                    "the ultimate strength of a bolt in MPa",
                )?,
                alpha_v_thread: row.within("alpha_v_threads_in_shear_plane", ALPHA_V, SHEAR)?,
                alpha_v_shank: row.within("alpha_v_shank_in_shear_plane", ALPHA_V, SHEAR)?,
                preloadable: row.flag("preloadable")?,
                standard: row.text_or_empty("standard"),
                source: row.source(),
            };
            if grade.fub < grade.fyb {
                return Err(
                    row.fault("fub_MPa", format!("{} is below fyb = {}", grade.fub, grade.fyb))
                );
            }
            grades.push(grade);
        }
        Ok(grades)
    }
}

impl Entry for BoltGrade {
    const NOUN: &'static str = "bolt grade";
    const KIND: &'static str = "bolt-grades";
    fn name(&self) -> String {
        self.grade.clone()
    }
    fn key(name: &str) -> String {
        bolt_grade_key(name)
    }
    fn source(&self) -> &Source {
        &self.source
    }
}
