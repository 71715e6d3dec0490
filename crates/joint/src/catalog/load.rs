//! Builds a [`Catalog`] from the built-in tables and from a folder of the user's tables.

use super::bolt::{BoltGrade, BoltSize};
use super::error::CatalogError;
use super::factor::{FrictionClass, NationalAnnex, PartialFactor};
use super::profile::{COARSE_TOLERANCE, IProfile, PROPERTY_TOLERANCE};
use super::shaped::ShapedProfile;
use super::steel::Steel;
use super::table::{Entry, Named, RawTable};
use super::{Catalog, Provenance};
use bracket_base::diag::Diagnostic;
use bracket_base::text_file;
use std::path::Path;

/// The tables compiled into the program.
const BUILTIN: [(&str, &str); 17] = [
    ("catalogs/profiles_i.csv", include_str!("../../../../catalogs/profiles_i.csv")),
    ("catalogs/profiles_i_other.csv", include_str!("../../../../catalogs/profiles_i_other.csv")),
    ("catalogs/profiles_w_aisc.csv", include_str!("../../../../catalogs/profiles_w_aisc.csv")),
    ("catalogs/profiles_l.csv", include_str!("../../../../catalogs/profiles_l.csv")),
    ("catalogs/profiles_u.csv", include_str!("../../../../catalogs/profiles_u.csv")),
    ("catalogs/profiles_hollow.csv", include_str!("../../../../catalogs/profiles_hollow.csv")),
    ("catalogs/profiles_chs.csv", include_str!("../../../../catalogs/profiles_chs.csv")),
    ("catalogs/bolts.csv", include_str!("../../../../catalogs/bolts.csv")),
    ("catalogs/bolts_preloaded.csv", include_str!("../../../../catalogs/bolts_preloaded.csv")),
    ("catalogs/bolt_grades.csv", include_str!("../../../../catalogs/bolt_grades.csv")),
    ("catalogs/bolt_grades_astm.csv", include_str!("../../../../catalogs/bolt_grades_astm.csv")),
    ("catalogs/steel_grades.csv", include_str!("../../../../catalogs/steel_grades.csv")),
    ("catalogs/steel_grades_astm.csv", include_str!("../../../../catalogs/steel_grades_astm.csv")),
    (
        "catalogs/steel_grades_product.csv",
        include_str!("../../../../catalogs/steel_grades_product.csv"),
    ),
    ("catalogs/friction_classes.csv", include_str!("../../../../catalogs/friction_classes.csv")),
    ("catalogs/partial_factors.csv", include_str!("../../../../catalogs/partial_factors.csv")),
    ("catalogs/national_annexes.csv", include_str!("../../../../catalogs/national_annexes.csv")),
];

/// The file that documents the source of each built-in table. The program reads its table of files,
/// so that the sources are written down only once.
const README: &str = include_str!("../../../../catalogs/README.md");

/// Kind of a table, recognised by its columns. Tables are read in this order: sizes before the
/// assemblies that refer to them, grades before the bands that refer to them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Profiles,
    Bolts,
    BoltsPreloaded,
    BoltGrades,
    Steels,
    SteelBands,
    Friction,
    Factors,
    Annexes,
    Shaped,
}

fn kind(table: &RawTable) -> Option<Kind> {
    let any = |columns: &[&str]| columns.iter().any(|c| table.has(c));
    let all = |columns: &[&str]| columns.iter().all(|c| table.has(c));
    Some(
        if any(&["ro_mm", "tan_alpha", "flange_slope_percent"]) || all(&["name", "d_mm", "t_mm"]) {
            Kind::Shaped
        } else if all(&["tw_mm", "tf_mm"]) || all(&["name", "h_mm", "b_mm"]) {
            Kind::Profiles
        } else if any(&["fyb_MPa", "fub_MPa"]) {
            Kind::BoltGrades
        } else if all(&["system", "size"]) {
            Kind::BoltsPreloaded
        } else if all(&["size", "d_mm"]) {
            Kind::Bolts
        } else if any(&["t_over_mm", "t_up_to_mm"]) {
            Kind::SteelBands
        } else if any(&["fy_t_le_40_MPa", "beta_w"]) {
            Kind::Steels
        } else if any(&["slip_factor_mu"]) {
            Kind::Friction
        } else if any(&["recommended_value"]) {
            Kind::Factors
        } else if any(&["annex"]) {
            Kind::Annexes
        } else {
            return None;
        },
    )
}

impl Catalog {
    /// The catalogue shipped with the program (the tables of `catalogs/`).
    pub fn builtin() -> Result<Self, CatalogError> {
        let mut catalog = Self::default();
        let tables = BUILTIN
            .iter()
            .map(|(file, text)| RawTable::parse(file, text))
            .collect::<Result<Vec<_>, _>>()?;
        catalog.add_tables(tables)?;
        for (file, _) in BUILTIN {
            catalog.provenance.insert(file.to_owned(), builtin_provenance(file));
        }
        Ok(catalog)
    }

    /// The built-in catalogue together with the tables of a folder.
    pub fn with_dir(path: &Path) -> Result<Self, CatalogError> {
        let mut catalog = Self::builtin()?;
        catalog.merge(path)?;
        Ok(catalog)
    }

    /// A catalogue that contains only the tables of a folder.
    pub fn load_dir(path: &Path) -> Result<Self, CatalogError> {
        let mut catalog = Self::default();
        catalog.merge(path)?;
        Ok(catalog)
    }

    /// Adds every `.csv` file of a folder, in the order of the file names. A name that already
    /// exists is refused with both places. A section is added with a warning
    /// ([`Catalog::warnings`]) if its tabulated A or I_y differs from the recomputed one by more
    /// than 0.5 %, or another property by more than 2 %, and refused above 10 %. On an error the
    /// catalogue is left unchanged.
    pub fn merge(&mut self, path: &Path) -> Result<(), CatalogError> {
        let io = |cause| CatalogError::Io { path: path.to_owned(), cause };
        let mut files = Vec::new();
        for entry in std::fs::read_dir(path).map_err(io)? {
            let file = entry.map_err(io)?.path();
            if file.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv")) {
                files.push(file);
            }
        }
        files.sort();
        if files.is_empty() {
            return Err(CatalogError::Empty { path: path.to_owned() });
        }
        let (mut tables, mut own) = (Vec::new(), Vec::new());
        for file in files {
            let unread = |cause| CatalogError::Io { path: file.clone(), cause }.into();
            let text = text_file::read(&file, unread).map_err(CatalogError::Unread)?;
            tables.push(RawTable::parse(&file.display().to_string(), &text)?);
            let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
            own.push((name, text));
        }
        let mut next = self.clone();
        let known = next.profiles().len();
        next.add_tables(tables)?;
        let warnings: Vec<_> =
            next.profiles()[known..].iter().filter_map(property_warning).collect();
        next.warnings.extend(warnings);
        next.own_tables.extend(own);
        *self = next;
        Ok(())
    }

    fn add_tables(&mut self, tables: Vec<RawTable>) -> Result<(), CatalogError> {
        let mut sorted = Vec::new();
        for table in tables {
            let kind = kind(&table)
                .ok_or_else(|| CatalogError::UnknownTable { file: table.file().to_owned() })?;
            sorted.push((kind, table));
        }
        sorted.sort_by_key(|(kind, _)| *kind);
        for (kind, table) in &sorted {
            if let Some(text) = &table.provenance {
                let entry =
                    Provenance { standard: None, read_from: text.clone(), cross_check: None };
                self.provenance.insert(table.file().to_owned(), entry);
            }
            match kind {
                Kind::Profiles => insert_all(&mut self.profiles, IProfile::read(table)?)?,
                Kind::Bolts => insert_all(&mut self.bolts, BoltSize::read(table)?)?,
                Kind::BoltsPreloaded => {
                    let preloaded = BoltSize::read_preloaded(table, |size| self.bolts.find(size))?;
                    insert_all(&mut self.bolts, preloaded)?;
                }
                Kind::BoltGrades => insert_all(&mut self.bolt_grades, BoltGrade::read(table)?)?,
                Kind::Steels => insert_all(&mut self.steels, Steel::read(table)?)?,
                Kind::SteelBands => Steel::read_bands(table, |name, band, basis| {
                    self.steels.find_mut(name).map(|s| s.push_band(band, basis))
                })?,
                Kind::Friction => insert_all(&mut self.friction, FrictionClass::read(table)?)?,
                Kind::Factors => insert_all(&mut self.factors, PartialFactor::read(table)?)?,
                Kind::Annexes => insert_all(&mut self.annexes, NationalAnnex::read(table)?)?,
                Kind::Shaped => insert_all(&mut self.shaped, ShapedProfile::read(table)?)?,
            }
        }
        Ok(())
    }
}

fn insert_all<T: Entry>(into: &mut Named<T>, rows: Vec<T>) -> Result<(), CatalogError> {
    rows.into_iter().try_for_each(|row| into.insert(row))
}

fn property_warning(profile: &IProfile) -> Option<Diagnostic> {
    let differences = profile.properties().map(|(column, given, outline)| {
        let fine = matches!(column, "A_cm2" | "Iy_cm4");
        let limit = if fine { PROPERTY_TOLERANCE } else { COARSE_TOLERANCE };
        (column, outline / given - 1.0, limit)
    });
    let worst = differences.into_iter().filter(|(_, x, limit)| x.abs() > *limit);
    let worst = worst.max_by(|a, b| (a.1.abs() / a.2).total_cmp(&(b.1.abs() / b.2)));
    worst.map(|(column, difference, limit)| {
        let name = match column {
            "Iy_cm4" => "I_y",
            "Iz_cm4" => "I_z",
            _ => column.rsplit_once('_').map_or(column, |(name, _)| name),
        };
        let message = format!(
            "{name} recomputed from the dimensions of {} differs from the table by {:+.2} % \
             (limit {} %)",
            profile.name,
            100.0 * difference,
            100.0 * limit
        );
        Diagnostic::input("catalog/section-mismatch", message)
            .file(&profile.source.file)
            .at(profile.source.line, 1)
            .help(
                "check h, b, tw, tf, r against the source; the model uses the dimensions, the \
                 checks the table",
            )
    })
}

/// The row of a file in the table of `catalogs/README.md`.
fn builtin_provenance(file: &str) -> Provenance {
    let short = file.trim_start_matches("catalogs/");
    README
        .lines()
        .map(|line| line.split('|').map(str::trim).collect::<Vec<_>>())
        .find(|cells| cells.len() == 7 && cells[1] == short)
        .map(|cells| Provenance {
            standard: Some(cells[3].into()),
            read_from: cells[4].to_owned(),
            cross_check: Some(cells[5].to_owned()),
        })
        .expect("catalogs/README.md has a row for every built-in table (a test reads them all)")
}
