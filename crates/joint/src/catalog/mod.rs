//! Data of sections, bolts and steels, each with its source. The data come from the tables of
//! `catalogs/` and from the user's tables.
//!
//! ```
//! use bracket_joint::catalog::Catalog;
//! let catalog = Catalog::builtin()?;
//! assert_eq!(catalog.profile("HE 200 B")?.h, 200.0); // mm
//! assert_eq!(catalog.bolt("M18")?.hole_normal, 20.0); // mm
//! assert_eq!(catalog.steel("S235")?.fy(15.0)?, 235.0); // MPa, Table 3.1 at t = 15 mm
//! # Ok::<(), bracket_joint::catalog::CatalogError>(())
//! ```

mod bolt;
mod error;
mod factor;
mod load;
mod name;
mod profile;
mod shaped;
mod source;
mod steel;
mod table;

pub use bolt::{BoltGrade, BoltSize, PLAIN_SYSTEM};
pub use error::CatalogError;
pub use factor::{FrictionClass, NationalAnnex, PartialFactor};
pub use profile::{IProfile, PROPERTY_TOLERANCE};
pub use shaped::{Section, SectionKind, Shape, ShapedProfile};
pub use source::Source;
pub use steel::{Band, Steel};

use bracket_base::diag::Diagnostic;
use bracket_base::words::Text;
use serde::Serialize;
use std::collections::BTreeMap;
use table::{Entry, Named};

/// Source of the numbers of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Provenance {
    /// Standard or edition that the values belong to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard: Option<Text>,
    /// Publication or file that the values were read from.
    pub read_from: String,
    /// How the values were checked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cross_check: Option<String>,
}

/// All tables, with look-up by name. The usual spellings of a name are accepted: `HE 200 B`,
/// `HEB200`, `533x210x92 UB`.
#[derive(Clone, Debug, Default)]
pub struct Catalog {
    profiles: Named<IProfile>,
    shaped: Named<ShapedProfile>,
    bolts: Named<BoltSize>,
    bolt_grades: Named<BoltGrade>,
    steels: Named<Steel>,
    friction: Named<FrictionClass>,
    factors: Named<PartialFactor>,
    annexes: Named<NationalAnnex>,
    provenance: BTreeMap<String, Provenance>,
    warnings: Vec<Diagnostic>,
    own_tables: Vec<(String, String)>,
}

impl Catalog {
    /// The user's tables that were added, as file name and text.
    pub fn own_tables(&self) -> &[(String, String)] {
        &self.own_tables
    }

    /// The bolt of this size: `M18` is the plain hexagon bolt, `HR M20` and `HV M20` belong to the
    /// preloaded systems.
    pub fn bolt(&self, name: &str) -> Result<&BoltSize, CatalogError> {
        self.bolts.get(name)
    }

    /// The bolt grade, for example `8.8`.
    pub fn bolt_grade(&self, name: &str) -> Result<&BoltGrade, CatalogError> {
        self.bolt_grades.get(name)
    }

    /// The rolled I or H section with this name.
    pub fn profile(&self, name: &str) -> Result<&IProfile, CatalogError> {
        self.profiles.get(name).map_err(|fault| match fault {
            CatalogError::Unknown { noun, kind, name, .. }
                if self::name::is_no_i_section(&name) =>
            {
                let hint = ": this member takes I and H sections, hot rolled".into();
                CatalogError::Unknown { noun, kind, name, hint }
            }
            other => other,
        })
    }

    /// The section with this name, of any kind.
    pub fn section(&self, name: &str) -> Result<Section<'_>, CatalogError> {
        if let Some(p) = self.shaped.find(name) {
            return Ok(Section::Shaped(p));
        }
        match self.profiles.get(name) {
            Ok(p) => Ok(Section::I(p)),
            Err(_) if self::name::is_no_i_section(name) => Err(self.shaped.unknown(name)),
            Err(e) => Err(e),
        }
    }

    /// The angle, channel or hollow section with this name.
    pub fn shaped_section(&self, name: &str) -> Result<&ShapedProfile, CatalogError> {
        self.shaped.get(name)
    }

    /// All angles, channels and hollow sections, in the order of the files.
    pub fn shaped(&self) -> &[ShapedProfile] {
        self.shaped.rows()
    }

    /// The steel, by grade (`S235`, `S355 J2+N`). If several standards contain the grade, `name`
    /// must give standard and grade (`EN 10210-1 S355H`).
    pub fn steel(&self, name: &str) -> Result<&Steel, CatalogError> {
        if let Some(steel) = self.steels.find(name) {
            return Ok(steel);
        }
        let key = Steel::key(name);
        let same: Vec<&Steel> =
            self.steels.rows().iter().filter(|s| Steel::key(&s.grade) == key).collect();
        match same[..] {
            [one] => Ok(one),
            [] => {
                let grades = self.steels.rows().iter().map(|s| s.grade.as_str());
                let hint = bracket_base::diag::did_you_mean(&key, grades);
                Err(CatalogError::Unknown {
                    noun: Steel::NOUN,
                    kind: Steel::KIND,
                    name: name.to_owned(),
                    hint,
                })
            }
            _ => Err(CatalogError::Ambiguous {
                name: name.to_owned(),
                choices: same.iter().map(|s| Entry::name(*s)).collect(),
            }),
        }
    }

    /// The friction class `A` … `D`.
    pub fn friction_class(&self, name: &str) -> Result<&FrictionClass, CatalogError> {
        self.friction.get(name)
    }

    /// The partial factor, for example `gamma_M0`, with its recommended value.
    pub fn partial_factor(&self, name: &str) -> Result<&PartialFactor, CatalogError> {
        self.factors.get(name)
    }

    /// The national annex by its short name or its country: `DE`, `Germany`. `recommended` is the
    /// code without a national annex.
    pub fn annex(&self, name: &str) -> Result<&NationalAnnex, CatalogError> {
        let country =
            || self.annexes().iter().find(|a| name::normalise(&a.country) == name::normalise(name));
        let unknown = || match self.annexes.unknown(name) {
            CatalogError::Unknown { noun, kind, name, hint } => {
                let known: Vec<&str> = self.annexes().iter().map(|a| a.annex.as_str()).collect();
                let hint = format!("{hint} (known: {})", known.join(", "));
                CatalogError::Unknown { noun, kind, name, hint }
            }
            other => other,
        };
        self.annexes.find(name).or_else(country).ok_or_else(unknown)
    }

    /// All sections, in the order of the files.
    pub fn profiles(&self) -> &[IProfile] {
        self.profiles.rows()
    }

    /// All bolt sizes, plain ones first.
    pub fn bolts(&self) -> &[BoltSize] {
        self.bolts.rows()
    }

    /// All bolt grades.
    pub fn bolt_grades(&self) -> &[BoltGrade] {
        self.bolt_grades.rows()
    }

    /// All steels.
    pub fn steels(&self) -> &[Steel] {
        self.steels.rows()
    }

    /// All friction classes.
    pub fn friction_classes(&self) -> &[FrictionClass] {
        self.friction.rows()
    }

    /// All partial factors.
    pub fn partial_factors(&self) -> &[PartialFactor] {
        self.factors.rows()
    }

    /// All national annexes.
    pub fn annexes(&self) -> &[NationalAnnex] {
        self.annexes.rows()
    }

    /// Source of the numbers of a file. `None` if the user's table has no `# source:` line.
    pub fn provenance(&self, file: &str) -> Option<&Provenance> {
        self.provenance.get(file)
    }

    /// Warnings about the user's tables: section properties that do not match the dimensions, and
    /// tables that were skipped.
    pub fn warnings(&self) -> &[Diagnostic] {
        &self.warnings
    }
}

#[cfg(test)]
mod tests;
