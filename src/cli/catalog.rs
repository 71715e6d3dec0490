//! `bracket catalog`.

mod row;

use super::common::{CommandResult, Common, Format};
use crate::driver::spec_file::catalog_warning;
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus, did_you_mean, in_line};
use bracket_joint::catalog::{
    BoltSize, Catalog, CatalogError, IProfile, NationalAnnex, Section, ShapedProfile, Steel,
};
use bracket_report::console::out;
use clap::{Subcommand, ValueEnum};
use serde::Serialize;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// List and show catalogue data.
#[derive(Debug, clap::Args)]
pub struct CatalogArgs {
    /// What to do; nothing: the kinds and how many rows each has.
    #[command(subcommand)]
    pub action: Option<Action>,
    /// Add the tables of your own folder to the built-in ones.
    #[arg(long, global = true, value_name = "DIR")]
    pub dir: Option<PathBuf>,
}

/// The actions of `bracket catalog`.
#[derive(Debug, Subcommand)]
pub enum Action {
    /// List one kind, a row per line.
    List {
        /// The kind of rows.
        kind: Kind,
        /// Profiles only: one series, for example HEB or UB.
        #[arg(long)]
        series: Option<String>,
    },
    /// Show every value of one row and where it comes from.
    Show {
        /// The name, in any usual spelling: `HE 200 B`, `HR M20`, `8.8`, `S355`, `gamma_M2`.
        #[arg(required = true)]
        name: Vec<String>,
    },
}

/// Kinds of rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Rolled I and H sections.
    Profiles,
    /// Angles, channels and hollow sections, for templates of your own.
    Sections,
    /// Bolt sizes with head, nut, washer and holes.
    Bolts,
    /// Strengths of bolts.
    BoltGrades,
    /// Structural steels.
    Steels,
    /// Friction classes.
    Friction,
    /// Partial factors.
    Factors,
    /// National annexes with their partial factors.
    Annexes,
}

/// Runs `bracket catalog`.
pub fn run(args: &CatalogArgs, common: &Common) -> CommandResult {
    let catalog = match &args.dir {
        Some(dir) => Catalog::with_dir(dir),
        None => Catalog::builtin(),
    }
    .map_err(Diagnostic::from)?;
    for w in catalog.warnings() {
        out::remark(&catalog_warning(w));
    }
    match &args.action {
        None => kinds(&catalog, common)?,
        Some(Action::List { kind, series }) => list(&catalog, *kind, series.as_deref(), common)?,
        Some(Action::Show { name }) => show(&catalog, &name.join(" "), common)?,
    }
    Ok(ExitStatus::Ok)
}

fn kinds(catalog: &Catalog, common: &Common) -> Result<(), Diagnostics> {
    let rows: Vec<(Kind, usize)> = vec![
        (Kind::Profiles, catalog.profiles().len()),
        (Kind::Sections, catalog.shaped().len()),
        (Kind::Bolts, catalog.bolts().len()),
        (Kind::BoltGrades, catalog.bolt_grades().len()),
        (Kind::Steels, catalog.steels().len()),
        (Kind::Friction, catalog.friction_classes().len()),
        (Kind::Factors, catalog.partial_factors().len()),
        (Kind::Annexes, catalog.annexes().len()),
    ];
    let name =
        |k: &Kind| k.to_possible_value().map_or_else(String::new, |v| v.get_name().to_owned());
    match common.format {
        Format::Json => {
            let map: serde_json::Map<String, Value> =
                rows.iter().map(|(k, n)| (name(k), json!(n))).collect();
            out::json(&map)
        }
        Format::Text => {
            let rows: Vec<Vec<String>> =
                rows.iter().map(|(k, n)| vec![name(k), n.to_string()]).collect();
            out::text(&out::columns(&["kind", "rows"], &rows))
        }
    }
}

fn list(
    catalog: &Catalog,
    kind: Kind,
    series: Option<&str>,
    common: &Common,
) -> Result<(), Diagnostics> {
    if let Some(series) = series.filter(|_| kind != Kind::Profiles) {
        return Err(Diagnostic::input(
            "cli/series",
            format!("`--series {series}` narrows profiles only"),
        )
        .help("leave `--series` out, or list profiles")
        .into());
    }
    match kind {
        Kind::Profiles => {
            let rows = chosen(catalog, series)?;
            let cells = |p: &&IProfile| {
                let mut cells = vec![p.name.clone(), p.series.clone()];
                cells.extend(
                    [p.h, p.b, p.tw, p.tf, p.r, p.mass, p.area, p.i_y, p.i_z, p.w_pl_y]
                        .map(|v| v.to_string()),
                );
                cells
            };
            let head = [
                "name",
                "series",
                "h mm",
                "b mm",
                "tw mm",
                "tf mm",
                "r mm",
                "kg/m",
                "A cm2",
                "Iy cm4",
                "Iz cm4",
                "Wpl,y cm3",
            ];
            table(&rows, &head, cells, common)
        }
        Kind::Sections => {
            let cells = |p: &ShapedProfile| {
                let section = Section::Shaped(p);
                let mut cells = vec![p.name.clone(), section.kind().noun().to_owned()];
                let [h, b, tw, tf, r, ..] = section.dimensions().map(|(_, v)| v);
                cells.extend([h, b, tw, tf, r].map(|v| v.to_string()));
                cells.extend([p.mass, p.area].map(row::hundredths));
                cells.push(p.w_pl_y.map_or_else(|| "-".to_owned(), row::hundredths));
                cells.push(p.standard.clone());
                cells
            };
            let head = [
                "name",
                "kind",
                "h mm",
                "b mm",
                "tw mm",
                "tf mm",
                "r mm",
                "kg/m",
                "A cm2",
                "Wpl,y cm3",
                "standard",
            ];
            table(catalog.shaped(), &head, cells, common)
        }
        Kind::Bolts => {
            let cells = |b: &BoltSize| {
                let mut cells = vec![if b.system == bracket_joint::catalog::PLAIN_SYSTEM {
                    b.size.clone()
                } else {
                    format!("{} {}", b.system, b.size)
                }];
                let numbers = [
                    b.d,
                    b.pitch,
                    b.stress_area,
                    b.hole_normal,
                    b.hole_oversize,
                    b.head_width,
                    b.head_height,
                    b.nut_width,
                    b.nut_height,
                    b.washer_outer,
                    b.washer_thickness,
                ];
                cells.extend(numbers.map(|v| v.to_string()));
                cells.push(b.standard.clone());
                cells
            };
            let head = [
                "name",
                "d mm",
                "pitch mm",
                "As mm2",
                "hole mm",
                "oversize mm",
                "head s mm",
                "head k mm",
                "nut s mm",
                "nut m mm",
                "washer mm",
                "washer t mm",
                "standard",
            ];
            table(catalog.bolts(), &head, cells, common)
        }
        Kind::BoltGrades => table(
            catalog.bolt_grades(),
            &["grade", "fyb MPa", "fub MPa", "alpha_v thread", "alpha_v shank", "preloadable"],
            |g| {
                let mut cells = vec![g.grade.clone()];
                cells.extend(
                    [g.fyb, g.fub, g.alpha_v_thread, g.alpha_v_shank].map(|v| v.to_string()),
                );
                cells.push(if g.preloadable { "yes" } else { "no" }.to_owned());
                cells
            },
            common,
        ),
        Kind::Steels => {
            let cells = |s: &Steel| {
                let band = |i: usize| {
                    s.bands.get(i).map_or(["-".to_owned(), "-".to_owned()], |b| {
                        [b.fy, b.fu].map(|v| v.to_string())
                    })
                };
                let mut cells = vec![s.grade.clone(), s.standard.clone()];
                cells.extend(band(0).into_iter().chain(band(1)));
                cells.push(s.e.to_string());
                cells.push(s.nu.to_string());
                cells.push(s.beta_w.map_or_else(|| "-".to_owned(), |b| b.to_string()));
                cells
            };
            let head = [
                "grade",
                "standard",
                "fy t<=40 MPa",
                "fu t<=40 MPa",
                "fy t<=80 MPa",
                "fu t<=80 MPa",
                "E MPa",
                "nu",
                "beta_w",
            ];
            table(catalog.steels(), &head, cells, common)
        }
        Kind::Friction => table(
            catalog.friction_classes(),
            &["class", "mu", "surface treatment"],
            |f| vec![f.class.clone(), f.mu.to_string(), f.treatment.clone()],
            common,
        ),
        Kind::Factors => table(
            catalog.partial_factors(),
            &["factor", "recommended", "standard", "applies to"],
            |f| {
                vec![
                    f.factor.clone(),
                    f.value.to_string(),
                    f.standard.clone(),
                    f.applies_to.clone(),
                ]
            },
            common,
        ),
        Kind::Annexes => {
            let cells = |a: &NationalAnnex| {
                let factors =
                    [a.gamma_m0, a.gamma_m1, a.gamma_m2, a.gamma_m3, a.gamma_m3_ser, a.gamma_m7];
                let mut cells = vec![a.annex.clone(), a.country.clone()];
                cells.extend(factors.map(|g| g.map_or_else(|| "-".to_owned(), |g| g.to_string())));
                cells.extend([a.basis.clone(), a.standard.clone()]);
                cells
            };
            let head = [
                "annex",
                "country",
                "gamma_M0",
                "gamma_M1",
                "gamma_M2",
                "gamma_M3",
                "gamma_M3_ser",
                "gamma_M7",
                "basis",
                "standard",
            ];
            table(catalog.annexes(), &head, cells, common)
        }
    }
}

/// The profiles of one series, written in any case and with or without blanks.
fn chosen<'a>(
    catalog: &'a Catalog,
    series: Option<&str>,
) -> Result<Vec<&'a IProfile>, Diagnostics> {
    let Some(series) = series else { return Ok(catalog.profiles().iter().collect()) };
    let flat = |s: &str| s.to_uppercase().replace([' ', '-'], "");
    let rows: Vec<&IProfile> =
        catalog.profiles().iter().filter(|p| flat(&p.series) == flat(series)).collect();
    if rows.is_empty() {
        let known: BTreeSet<&str> = catalog.profiles().iter().map(|p| p.series.as_str()).collect();
        let hint = did_you_mean(series, known.iter().copied());
        let known = known.into_iter().collect::<Vec<_>>().join(", ");
        return Err(Diagnostic::input(
            "catalog/unknown-series",
            format!("no profile series `{series}`{hint}"),
        )
        .help(format!("the series are: {known}"))
        .into());
    }
    Ok(rows)
}

fn table<T: Serialize>(
    rows: &[T],
    head: &[&str],
    cells: impl Fn(&T) -> Vec<String>,
    common: &Common,
) -> Result<(), Diagnostics> {
    match common.format {
        Format::Json => out::json(&rows),
        Format::Text => out::text(&out::columns(head, &rows.iter().map(cells).collect::<Vec<_>>())),
    }
}

/// Prints every row of any kind that matches the name.
fn show(catalog: &Catalog, name: &str, common: &Common) -> Result<(), Diagnostics> {
    let mut found: Vec<(&str, Value)> = Vec::new();
    let mut refused: Vec<CatalogError> = Vec::new();
    let mut take = |kind, row: Result<Value, CatalogError>| match row {
        Ok(value) => found.push((kind, value)),
        Err(error) => refused.push(error),
    };
    take("profile", catalog.profile(name).map(|r| json!(r)));
    take("section", catalog.shaped_section(name).map(|r| json!(r)));
    take("bolt", catalog.bolt(name).map(|r| json!(r)));
    take("bolt grade", catalog.bolt_grade(name).map(|r| json!(r)));
    take("steel", catalog.steel(name).map(|r| json!(r)));
    take("friction class", catalog.friction_class(name).map(|r| json!(r)));
    take("partial factor", catalog.partial_factor(name).map(|r| json!(r)));
    take("national annex", catalog.annex(name).map(|r| json!(r)));
    if found.is_empty() {
        if let Some(at) = refused.iter().position(|e| matches!(e, CatalogError::Ambiguous { .. })) {
            return Err(Diagnostic::from(refused.swap_remove(at)).into());
        }
        let close: Vec<String> = refused
            .into_iter()
            .filter_map(|e| match e {
                CatalogError::Unknown { hint, .. } if !hint.is_empty() => Some(hint),
                _ => None,
            })
            .collect();
        let proposals = close.iter().filter_map(|h| Some(h.split_once('`')?.1.split_once('`')?.0));
        let hint = did_you_mean(name, proposals);
        return Err(Diagnostic::input(
            "catalog/unknown-name",
            format!("no row of the catalogue is called `{name}`{hint}"),
        )
        .help("`bracket catalog` names the kinds, `bracket catalog list KIND` every row")
        .into());
    }
    let with_source = |row: &Value| {
        let file = row["source"]["file"].as_str().unwrap_or_default();
        catalog.provenance(file).map(|p| json!(p))
    };
    match common.format {
        Format::Json => {
            let rows: Vec<Value> = found
                .iter()
                .map(|(kind, row)| match with_source(row) {
                    Some(p) => json!({"kind": kind, "row": row, "provenance": p}),
                    None => json!({"kind": kind, "row": row}),
                })
                .collect();
            out::json(&rows)
        }
        Format::Text => {
            let mut text = String::new();
            for (kind, row) in &found {
                text += &format!("{kind}\n");
                text += &row::values(kind, row);
                let at = &row["source"];
                text += &format!(
                    "  source: {} line {}\n",
                    in_line(at["file"].as_str().unwrap_or_default()),
                    at["line"]
                );
                for (key, value) in with_source(row).iter().filter_map(Value::as_object).flatten() {
                    text += &format!(
                        "  table {}: {}\n",
                        key.replace('_', " "),
                        in_line(value.as_str().unwrap_or_default())
                    );
                }
            }
            out::text(&text)
        }
    }
}
