//! Friction classes, partial factors and the national annexes that set them.

use super::error::CatalogError;
use super::source::Source;
use super::table::{Columns, Entry, RawTable};
use serde::Serialize;
use std::ops::RangeInclusive;

/// Partial factors of resistances \[-\].
const FACTORS: RangeInclusive<f64> = 0.5..=3.0;
const FACTOR: &str = "a partial factor";

/// A friction class of faying surfaces.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.7 / EN 1090-2.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FrictionClass {
    /// Class: `A` … `D`.
    pub class: String,
    /// Slip factor μ \[-\].
    pub mu: f64,
    /// The surface treatment that reaches this slip factor.
    pub treatment: String,
    /// File and line of the row.
    pub source: Source,
}

impl FrictionClass {
    pub(super) const COLUMNS: Columns = Columns {
        kind: "friction classes",
        needed: &["class", "slip_factor_mu", "surface_treatment"],
        optional: &[],
    };

    /// Reads a table of friction classes.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::COLUMNS)?;
        table
            .rows()
            .map(|row| {
                Ok(Self {
                    class: row.text("class")?,
                    mu: match row.not_negative("slip_factor_mu")? {
                        mu if mu > 1.0 => {
                            let problem = format!("{mu}; a slip factor lies between 0 and 1");
                            return Err(row.fault("slip_factor_mu", problem));
                        }
                        mu => mu,
                    },
                    treatment: row.text("surface_treatment")?,
                    source: row.source(),
                })
            })
            .collect()
    }
}

impl Entry for FrictionClass {
    const NOUN: &'static str = "friction class";
    const KIND: &'static str = "friction";
    fn name(&self) -> String {
        self.class.clone()
    }
    fn source(&self) -> &Source {
        &self.source
    }
}

/// A partial factor with its recommended value. A national annex may set another value.
///
/// # Source
/// EN 1993-1-1 6.1, EN 1993-1-8:2005 Table 2.1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PartialFactor {
    /// Name, for example `gamma_M0`.
    pub factor: String,
    /// Recommended value \[-\].
    pub value: f64,
    /// The resistance that the factor divides.
    pub applies_to: String,
    /// Standard and clause.
    pub standard: String,
    /// File and line of the row.
    pub source: Source,
}

impl PartialFactor {
    pub(super) const COLUMNS: Columns = Columns {
        kind: "partial factors",
        needed: &["factor", "recommended_value", "applies_to", "standard"],
        optional: &[],
    };

    /// Reads a table of partial factors.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::COLUMNS)?;
        table
            .rows()
            .map(|row| {
                Ok(Self {
                    factor: row.text("factor")?,
                    value: row.within("recommended_value", FACTORS, FACTOR)?,
                    applies_to: row.text("applies_to")?,
                    standard: row.text("standard")?,
                    source: row.source(),
                })
            })
            .collect()
    }
}

impl Entry for PartialFactor {
    const NOUN: &'static str = "partial factor";
    const KIND: &'static str = "factors";
    fn name(&self) -> String {
        self.factor.clone()
    }
    fn source(&self) -> &Source {
        &self.source
    }
}

/// The partial factors of a national annex. A factor missing from the row has its recommended
/// value.
///
/// # Source
/// `basis` states which values were read and which are unverified; for details see
/// `catalogs/README.md`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NationalAnnex {
    /// Name, for example `DE`.
    pub annex: String,
    /// Country.
    pub country: String,
    /// γ_M0 \[-\].
    #[serde(rename = "gamma_M0", skip_serializing_if = "Option::is_none")]
    pub gamma_m0: Option<f64>,
    /// γ_M1 \[-\].
    #[serde(rename = "gamma_M1", skip_serializing_if = "Option::is_none")]
    pub gamma_m1: Option<f64>,
    /// γ_M2 of bolts, welds and plates in bearing \[-\].
    #[serde(rename = "gamma_M2", skip_serializing_if = "Option::is_none")]
    pub gamma_m2: Option<f64>,
    /// γ_M3 \[-\].
    #[serde(rename = "gamma_M3", skip_serializing_if = "Option::is_none")]
    pub gamma_m3: Option<f64>,
    /// γ_M3,ser \[-\].
    #[serde(rename = "gamma_M3_ser", skip_serializing_if = "Option::is_none")]
    pub gamma_m3_ser: Option<f64>,
    /// γ_M7 \[-\].
    #[serde(rename = "gamma_M7", skip_serializing_if = "Option::is_none")]
    pub gamma_m7: Option<f64>,
    /// γ_c of concrete \[-\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gamma_c: Option<f64>,
    /// α_cc of concrete \[-\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha_cc: Option<f64>,
    /// How the values of concrete were obtained.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub concrete_basis: Option<String>,
    /// The national annexes that the values are taken from.
    pub standard: String,
    /// How the values were obtained.
    pub basis: String,
    /// File and line of the row.
    pub source: Source,
}

impl NationalAnnex {
    pub(super) const COLUMNS: Columns = Columns {
        kind: "national annexes",
        needed: &[
            "annex",
            "country",
            "gamma_M0",
            "gamma_M1",
            "gamma_M2",
            "gamma_M3",
            "gamma_M3_ser",
            "gamma_M7",
            "standard",
            "basis",
        ],
        optional: &["gamma_c", "alpha_cc", "concrete_basis"],
    };

    /// Reads a table of national annexes.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::COLUMNS)?;
        table
            .rows()
            .map(|row| {
                let factor = |column: &str| row.within_or_empty(column, FACTORS, FACTOR);
                Ok(Self {
                    annex: row.text("annex")?,
                    country: row.text("country")?,
                    gamma_m0: factor("gamma_M0")?,
                    gamma_m1: factor("gamma_M1")?,
                    gamma_m2: factor("gamma_M2")?,
                    gamma_m3: factor("gamma_M3")?,
                    gamma_m3_ser: factor("gamma_M3_ser")?,
                    gamma_m7: factor("gamma_M7")?,
                    gamma_c: factor("gamma_c")?,
                    alpha_cc: factor("alpha_cc")?,
                    concrete_basis: row.text_or_empty("concrete_basis"),
                    standard: row.text("standard")?,
                    basis: row.text("basis")?,
                    source: row.source(),
                })
            })
            .collect()
    }
}

impl Entry for NationalAnnex {
    const NOUN: &'static str = "national annex";
    const KIND: &'static str = "annexes";
    fn name(&self) -> String {
        self.annex.clone()
    }
    fn source(&self) -> &Source {
        &self.source
    }
}
