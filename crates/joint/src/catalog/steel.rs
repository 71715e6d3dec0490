//! Structural steels with their thickness bands.

use super::error::CatalogError;
use super::name::steel_key;
use super::source::Source;
use super::table::{Columns, Entry, RawTable};
use crate::spec::code::FySource;
use serde::Serialize;
use std::ops::RangeInclusive;

/// Yield strengths of structural steels \[MPa\].
const YIELD: RangeInclusive<f64> = 100.0..=1300.0;
const FY: &str = "the yield strength of a structural steel in MPa";
/// Ultimate strengths of structural steels \[MPa\].
const ULTIMATE: RangeInclusive<f64> = 200.0..=1700.0;
const FU: &str = "the ultimate strength of a structural steel in MPa";

/// Nominal strength for one range of thickness, `over < t ≤ up_to`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Band {
    /// Lower end, excluded \[mm\].
    pub over: f64,
    /// Upper end, included \[mm\].
    pub up_to: f64,
    /// Yield strength \[MPa\].
    pub fy: f64,
    /// Ultimate strength \[MPa\].
    pub fu: f64,
}

/// A steel grade of one product standard.
///
/// # Source
/// EN 1993-1-1:2005 Table 3.1; β_w EN 1993-1-8:2005 Table 4.1; product bands EN 10025-2, -3, -4.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Steel {
    /// Product standard, for example `EN 10025-2`.
    pub standard: String,
    /// Grade, for example `S235`.
    pub grade: String,
    /// Young's modulus \[MPa\].
    pub e: f64,
    /// Poisson's ratio \[-\].
    pub nu: f64,
    /// Density \[kg/m³\].
    pub density: f64,
    /// Correlation factor of fillet welds β_w \[-\]; absent if Table 4.1 does not list the grade.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub beta_w: Option<f64>,
    /// Thickness bands of Table 3.1, ascending.
    pub bands: Vec<Band>,
    /// Thickness bands of the product standard, ascending; empty if the catalogue has none.
    pub product_bands: Vec<Band>,
    /// How the product bands were obtained: `read` or `unverified`. Absent if there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub product_basis: Option<String>,
    /// File and line of the row.
    pub source: Source,
}

impl Steel {
    pub(super) const COLUMNS: Columns = Columns {
        kind: "steels",
        needed: &[
            "standard",
            "grade",
            "fy_t_le_40_MPa",
            "fu_t_le_40_MPa",
            "fy_t_40_to_80_MPa",
            "fu_t_40_to_80_MPa",
            "E_MPa",
            "nu",
            "density_kg_per_m3",
            "beta_w",
        ],
        optional: &[],
    };

    pub(super) const BAND_COLUMNS: Columns = Columns {
        kind: "product-standard bands",
        needed: &[
            "standard",
            "grade",
            "t_over_mm",
            "t_up_to_mm",
            "ReH_min_MPa",
            "Rm_min_MPa",
            "basis",
        ],
        optional: &[],
    };

    /// Nominal yield strength \[MPa\] from Table 3.1, for a thickness \[mm\].
    pub fn fy(&self, thickness: f64) -> Result<f64, CatalogError> {
        self.fy_by(FySource::Table31, thickness)
    }

    /// Nominal ultimate strength \[MPa\] from Table 3.1, for a thickness \[mm\].
    pub fn fu(&self, thickness: f64) -> Result<f64, CatalogError> {
        self.fu_by(FySource::Table31, thickness)
    }

    /// Nominal yield strength \[MPa\] from the selected table, for a thickness \[mm\].
    pub fn fy_by(&self, source: FySource, thickness: f64) -> Result<f64, CatalogError> {
        self.band("fy", source, thickness).map(|b| b.fy)
    }

    /// Nominal ultimate strength \[MPa\] from the selected table, for a thickness \[mm\].
    pub fn fu_by(&self, source: FySource, thickness: f64) -> Result<f64, CatalogError> {
        self.band("fu", source, thickness).map(|b| b.fu)
    }

    fn band(
        &self,
        quantity: &'static str,
        source: FySource,
        thickness: f64,
    ) -> Result<Band, CatalogError> {
        let (bands, table) = match source {
            FySource::Table31 => (&self.bands, "EN 1993-1-1 Table 3.1"),
            FySource::ProductStandard => (&self.product_bands, "the product standard"),
        };
        let limit =
            bands.last().ok_or_else(|| CatalogError::NoProductBands { grade: self.name() })?.up_to;
        bands.iter().find(|b| b.over < thickness && thickness <= b.up_to).copied().ok_or_else(
            || CatalogError::Thickness { quantity, grade: self.name(), table, thickness, limit },
        )
    }

    /// Reads a table of grades.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::COLUMNS)?;
        let mut steels = Vec::new();
        for row in table.rows() {
            let fy = |column| row.within(column, YIELD, FY);
            let fu = |column| row.within(column, ULTIMATE, FU);
            let mut bands = vec![Band {
                over: 0.0,
                up_to: 40.0,
                fy: fy("fy_t_le_40_MPa")?,
                fu: fu("fu_t_le_40_MPa")?,
            }];
            let thick = (
                row.within_or_empty("fy_t_40_to_80_MPa", YIELD, FY)?,
                row.within_or_empty("fu_t_40_to_80_MPa", ULTIMATE, FU)?,
            );
            match thick {
                (Some(fy), Some(fu)) => bands.push(Band { over: 40.0, up_to: 80.0, fy, fu }),
                (None, None) => {}
                (None, _) => {
                    return Err(
                        row.fault("fy_t_40_to_80_MPa", "the cell is empty while fu is given")
                    );
                }
                (_, None) => {
                    return Err(
                        row.fault("fu_t_40_to_80_MPa", "the cell is empty while fy is given")
                    );
                }
            }
            if let Some(b) = bands.iter().find(|b| b.fu < b.fy) {
                return Err(
                    row.fault("fu_t_le_40_MPa", format!("fu = {} is below fy = {}", b.fu, b.fy))
                );
            }
            if let [thin, thick] = bands[..]
                && thick.fy > thin.fy
            {
                let problem =
                    format!("{} is more than that of thinner parts, {}", thick.fy, thin.fy);
                return Err(row.fault("fy_t_40_to_80_MPa", problem));
            }
            steels.push(Self {
                standard: row.text("standard")?,
                grade: row.text("grade")?,
                e: row.within("E_MPa", 150e3..=230e3, "Young's modulus of steel in MPa")?,
                nu: row.within("nu", 0.2..=0.4, "Poisson's ratio of steel")?,
                density: row.within(
                    "density_kg_per_m3",
                    7e3..=8.5e3,
                    "the density of steel in kg/m³",
                )?,
                beta_w: row.within_or_empty("beta_w", 0.7..=1.2, "β_w of fillet welds")?,
                bands,
                product_bands: Vec::new(),
                product_basis: None,
                source: row.source(),
            });
        }
        Ok(steels)
    }

    /// Reads a table of product-standard bands and adds each band to the grade that `find` returns.
    pub(super) fn read_bands(
        table: &RawTable,
        mut add: impl FnMut(&str, Band, String) -> Option<Result<(), String>>,
    ) -> Result<(), CatalogError> {
        table.check(Self::BAND_COLUMNS)?;
        for row in table.rows() {
            let name = format!("{} {}", row.text("standard")?, row.text("grade")?);
            let band = Band {
                over: row.not_negative("t_over_mm")?,
                up_to: row.positive("t_up_to_mm")?,
                fy: row.within("ReH_min_MPa", YIELD, FY)?,
                fu: row.within("Rm_min_MPa", ULTIMATE, FU)?,
            };
            if band.up_to <= band.over {
                return Err(row.fault(
                    "t_up_to_mm",
                    format!("{} must exceed t_over = {}", band.up_to, band.over),
                ));
            }
            match add(&name, band, row.text("basis")?) {
                None => {
                    return Err(row.fault("grade", format!("`{name}` is in no table of steels")));
                }
                Some(Err(problem)) => return Err(row.fault("t_over_mm", problem)),
                Some(Ok(())) => {}
            }
        }
        Ok(())
    }

    /// Adds the next product band. It must start where the previous one ends, without gap or
    /// overlap.
    pub(super) fn push_band(&mut self, band: Band, basis: String) -> Result<(), String> {
        let end = self.product_bands.last().map_or(0.0, |b| b.up_to);
        if band.over != end {
            return Err(format!(
                "{} does not continue the band before, which ends at {end} mm",
                band.over
            ));
        }
        if self.product_bands.last().is_some_and(|b| band.fy > b.fy) {
            return Err(format!("fy = {} is more than that of thinner parts", band.fy));
        }
        self.product_bands.push(band);
        self.product_basis = Some(basis);
        Ok(())
    }
}

impl Entry for Steel {
    const NOUN: &'static str = "steel";
    const KIND: &'static str = "steels";
    fn name(&self) -> String {
        format!("{} {}", self.standard, self.grade)
    }
    fn key(name: &str) -> String {
        steel_key(name)
    }
    fn source(&self) -> &Source {
        &self.source
    }
}
