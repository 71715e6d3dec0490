//! Friction classes and partial factors.

use super::error::CatalogError;
use super::table::{Columns, Entry, RawTable, Source};
use serde::Serialize;

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
    /// The surface treatment that reaches it.
    pub treatment: String,
    /// Where the row stands.
    pub source: Source,
}

impl FrictionClass {
    pub(super) const COLUMNS: Columns =
        Columns { kind: "friction classes", needed: &["class", "slip_factor_mu", "surface_treatment"], optional: &[] };

    /// Reads a table.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::COLUMNS)?;
        table
            .rows()
            .map(|row| {
                Ok(Self {
                    class: row.text("class")?,
                    mu: row.not_negative("slip_factor_mu")?,
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

/// A partial factor with its recommended value; a national annex may set another.
///
/// # Source
/// EN 1993-1-1 6.1, EN 1993-1-8:2005 Table 2.1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PartialFactor {
    /// Name, for example `gamma_M0`.
    pub factor: String,
    /// Recommended value \[-\].
    pub value: f64,
    /// What it divides.
    pub applies_to: String,
    /// Standard and clause.
    pub standard: String,
    /// Where the row stands.
    pub source: Source,
}

impl PartialFactor {
    pub(super) const COLUMNS: Columns = Columns {
        kind: "partial factors",
        needed: &["factor", "recommended_value", "applies_to", "standard"],
        optional: &[],
    };

    /// Reads a table.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::COLUMNS)?;
        table
            .rows()
            .map(|row| {
                Ok(Self {
                    factor: row.text("factor")?,
                    value: row.positive("recommended_value")?,
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
