//! The types of `SWEEP.yaml` (docs/contract.md): which joints, what is asked of each, and what is
//! printed.

use crate::driver::memory_limit;
use bracket_base::diag::Diagnostics;
use bracket_base::units::Seconds;
use bracket_joint::spec::expr::Expr;
use bracket_joint::spec::loads::Action;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::path::PathBuf;

/// A whole `SWEEP.yaml`. Every case is the base spec with some values replaced.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sweep {
    /// The spec that every case starts from: its path relative to this file, or the spec itself.
    #[schemars(with = "Base")]
    pub base: Value,
    /// Values of paths of the spec; all combinations are cases. A key is a path such as
    /// `plate.thickness`, or several paths with commas, whose values change together. A value is a
    /// list, a range `{from: 10, to: 25, step: 5}` or a range of profiles `IPE200..IPE400`.
    #[serde(default)]
    pub axes: Map<String, Value>,
    /// CSV file with one joint a row, relative to this file. Its columns are paths of the spec, and
    /// `name`.
    #[serde(default)]
    pub table: Option<PathBuf>,
    /// Values that follow from others: a path with an expression, or with a list of expressions, of
    /// the names of the template that do not depend on parameters (`beam.h`, `bolt.d`) and of
    /// values of the spec (`plate.thickness`).
    #[serde(default)]
    pub set: Map<String, Value>,
    /// Conditions on the names of the template (`plate.thickness >= bolt.d / 2`); a combination
    /// that breaks one is left out.
    #[serde(default, rename = "where")]
    pub conditions: Vec<Expr>,
    /// What every case gets before any mesh.
    #[serde(default)]
    pub first: Option<First>,
    /// Which cases get finite elements after the checks.
    #[serde(default)]
    pub then: Option<Then>,
    /// Which joint of each group is chosen. Finite elements then begin with the joint of least cost
    /// and end with the first that holds.
    #[serde(default)]
    pub choose: Option<Choose>,
    /// Conditions on the outcome of the sweep: `ok`, `not_ok`, `undecided`, `bad_input`, `failed`,
    /// `timed_out` and `cases` are the numbers of cases, `groups` and `chosen` those of the groups
    /// of `choose`. The exit code is 1 if one does not hold.
    #[serde(default)]
    pub expect: Vec<Expr>,
    /// Capacity tables.
    #[serde(default)]
    pub tables: Vec<CapacityTable>,
    /// Limits of one case with finite elements.
    #[serde(default)]
    pub limits: CaseLimits,
}

/// Schema of [`Sweep::base`] only.
#[derive(JsonSchema)]
#[serde(untagged)]
#[allow(dead_code)]
enum Base {
    /// Path of a spec.
    Path(PathBuf),
    /// A spec.
    Spec(Map<String, Value>),
}

/// What every case gets first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum First {
    /// The checks of the code, in the process, without any mesh.
    Checks,
}

/// What follows the checks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Then {
    /// The cases that get limit analysis.
    pub limit: Who,
}

/// Whether cases are meshed: all where no checks come first, some where analyses follow them.
pub fn meshes(first: Option<First>, then: Option<Then>) -> bool {
    first.is_none() || then.is_some()
}

/// Which cases get finite elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Who {
    /// Those whose verdict a limit analysis can change: the checks leave them undecided, or only
    /// the component method rejects them.
    Undecided,
    /// Those and the ones that the checks accept: all that no other check rejects.
    Passing,
    /// All whose input is sound.
    All,
}

/// Which joint of each group is chosen: of those that hold, the one of least cost.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Choose {
    /// The cost: `mass` \[kg\] of plates, stiffeners and bolts, `bolts` (their number), or an
    /// expression of the two and of the names of the template: `3 * mass + 5 * bolts`.
    pub least: Expr,
    /// Which joints can be chosen.
    #[serde(default)]
    pub among: Among,
    /// Paths of `axes` or of the table: joints with equal values there are a group. Left out: each
    /// row of the table is a group; without a table the whole sweep is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub per: Option<Vec<String>>,
}

/// Which joints can be chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Among {
    /// Those with the verdict OK.
    #[default]
    Ok,
}

/// A table of capacities: a family of joints over two paths of the spec.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CapacityTable {
    /// Heading.
    pub title: String,
    /// Path whose values head the rows.
    pub rows: String,
    /// Path whose values head the columns.
    pub columns: String,
    /// Action whose capacity is printed.
    pub action: Action,
    /// Values that other paths must have for a case to be in the table: `{bolts.size: M20}`. Where
    /// several cases share a cell, the least capacity is printed.
    #[serde(default, skip_serializing_if = "Map::is_empty")]
    pub only: Map<String, Value>,
    /// Load case; left out: the first one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub case: Option<String>,
}

/// Limits of one case with finite elements.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CaseLimits {
    /// Wall time after which the case is ended. Left out: twice the time limit of its analysis and
    /// five minutes more.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time: Option<Seconds>,
    /// Memory of the process, for example `8GiB`. Left out: an equal share of the machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub memory: Option<String>,
    /// Threads of a case. Left out: one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub threads: Option<u32>,
}

impl CaseLimits {
    /// Threads of a case.
    pub fn threads(&self) -> u32 {
        self.threads.unwrap_or(1)
    }

    /// Memory of a case \[bytes\]; `usual` where the user gives none.
    pub fn memory(&self, usual: u64) -> Result<u64, Diagnostics> {
        self.memory.as_deref().map_or(Ok(usual), memory_limit::parse)
    }
}
