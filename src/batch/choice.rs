//! The choice of a sweep: in each group of joints the one of least cost that holds.
//!
//! The checks of the code leave some joints as candidates. From the cheapest upward each is
//! accepted by its checks or analysed, until one holds; the dearer ones are not meshed.

use super::analysing::wanted;
use super::case::Case;
use super::expansion::typed;
use super::plan::Plan;
use super::row::{Outcome, Record};
use super::screen::{Kit, screen};
use super::sweep::Choose;
use crate::assembly::names;
use crate::diag::Diagnostic;
use crate::spec::expr::{Expr, Value};
use crate::units::Dim;
use std::collections::HashMap;

/// Names of [`Choose::least`] that come from the record of a case.
const MASS: &str = "mass";
/// See [`MASS`].
const BOLTS: &str = "bolts";

/// Cases among which one with sound input is looked for, to check the expression.
const SOUND: usize = 100;

/// Joints of which one is chosen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Group {
    /// The values that its joints share, or the name of the row of the table.
    pub name: String,
    /// Their positions in the plan.
    pub cases: Vec<usize>,
}

/// A joint that can be chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Position in the plan.
    pub case: usize,
    /// Its cost.
    pub cost: f64,
    /// Whether only an analysis decides it; otherwise its checks accept it.
    pub analyse: bool,
}

/// The groups of a plan, in the order of their first cases.
pub fn groups(plan: &Plan, choose: &Choose) -> Vec<Group> {
    let mut out: Vec<Group> = Vec::new();
    let mut known: HashMap<String, usize> = HashMap::new();
    for (i, case) in plan.cases.iter().enumerate() {
        let name = group_name(plan, case, choose);
        let at = *known.entry(name.clone()).or_insert_with(|| {
            out.push(Group { name, cases: Vec::new() });
            out.len() - 1
        });
        out[at].cases.push(i);
    }
    out
}

/// The group of a case.
fn group_name(plan: &Plan, case: &Case, choose: &Choose) -> String {
    let expansion = &plan.header.expansion;
    match &choose.per {
        Some(paths) => {
            let values = expansion.values(case.index);
            let of = |p: &String| values.iter().find(|(q, _)| q == p).map(|(_, v)| v.as_str());
            paths.iter().filter_map(of).collect::<Vec<_>>().join(" ")
        }
        None => expansion.row_name(case.index).unwrap_or_default(),
    }
}

/// The joints of a group that can be chosen, the cheapest first; equal costs keep the order of the
/// plan. `checked` holds the records of the checks by position in the plan; a case without one is
/// left out.
pub fn candidates(
    group: &Group,
    plan: &Plan,
    kit: &Kit,
    choose: &Choose,
    checked: &[Option<Record>],
) -> Vec<Candidate> {
    let mut out = Vec::new();
    for &case in &group.cases {
        let Some(record) = &checked[case] else { continue };
        let analyse = plan.header.then.is_some_and(|then| wanted(then.limit, record));
        if analyse || record.outcome == Outcome::Ok {
            // a joint whose cost is not known, such as one with bolts longer than stocked, is last
            let cost = cost(&choose.least, &plan.cases[case], plan, kit, record);
            out.push(Candidate { case, cost: cost.unwrap_or(f64::INFINITY), analyse });
        }
    }
    // a stable sort
    out.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    out
}

/// The cost of a case.
fn cost(
    least: &Expr,
    case: &Case,
    plan: &Plan,
    kit: &Kit,
    record: &Record,
) -> Result<f64, Box<Diagnostic>> {
    let own = |name: &str| match name {
        MASS => Some(record.mass.ok_or("the mass of this joint is not known")),
        BOLTS => Some(record.bolts.map(f64::from).ok_or("the number of bolts is not known")),
        _ => None,
    };
    let others = least.names().into_iter().any(|n| n != MASS && n != BOLTS);
    let scope = match others {
        true => {
            let spec = typed(&kit.spec(&plan.header.expansion, case.index)?, &kit.file)?;
            let scope = names(&spec, kit.template(&spec)?, &kit.catalog);
            Some(scope.map_err(|faults| Diagnostic::from(faults.into_first()))?)
        }
        false => None,
    };
    let mut lookup = |name: &str| match (own(name), &scope) {
        (Some(value), _) => value.map(Value::number).map_err(str::to_owned),
        (None, Some(scope)) => scope.get(name),
        (None, None) => Err(format!("unknown name `{name}`")),
    };
    let cost = least.eval_as(Dim::NONE, &mut lookup).map_err(|e| {
        Diagnostic::input("sweep/choose", format!("`choose.least` of `{}`: {e}", case.name))
            .path("choose.least")
            .help(
                "a cost is a number of `mass` (kg), `bolts` and the names of the template; a \
                 length becomes a number by division: `plate.thickness / 1 mm`",
            )
    })?;
    Ok(cost)
}

/// What became of a group.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// The group.
    pub group: String,
    /// Number of its joints.
    pub joints: usize,
    /// Its candidates, the cheapest first.
    pub candidates: Vec<Candidate>,
    /// Position of the chosen one among the candidates.
    pub chosen: Option<usize>,
    /// Candidates that are cheaper than the chosen one and neither hold nor fail for certain.
    pub undecided: usize,
    /// Candidates that were analysed.
    pub analysed: usize,
    /// Whether a candidate still waits for its analysis.
    pub open: bool,
}

impl Decision {
    /// Decides a group. `analysed` returns the record of a case with finite elements.
    pub fn new<'a>(
        group: &Group,
        candidates: Vec<Candidate>,
        analysed: impl Fn(usize) -> Option<&'a Record>,
        complete: bool,
    ) -> Self {
        let mut out = Self {
            group: group.name.clone(),
            joints: group.cases.len(),
            analysed: candidates.iter().filter(|c| c.analyse && analysed(c.case).is_some()).count(),
            candidates,
            chosen: None,
            undecided: 0,
            open: !complete,
        };
        if out.open {
            return out;
        }
        for (i, c) in out.candidates.iter().enumerate() {
            let outcome = match c.analyse {
                true => analysed(c.case).map(|r| r.outcome),
                false => Some(Outcome::Ok),
            };
            match outcome {
                Some(Outcome::Ok) => {
                    out.chosen = Some(i);
                    break;
                }
                Some(Outcome::NotOk) => {}
                Some(_) => out.undecided += 1,
                None => {
                    out.open = true;
                    break;
                }
            }
        }
        out
    }

    /// The chosen candidate.
    pub fn choice(&self) -> Option<Candidate> {
        self.chosen.map(|i| self.candidates[i])
    }

    /// The candidates behind the chosen one: none of them needs an analysis.
    pub fn dearer(&self) -> &[Candidate] {
        self.chosen.map_or(&[], |i| &self.candidates[i + 1..])
    }

    /// The outcome of the group: ok if one is chosen, not ok if no joint holds for certain.
    pub fn outcome(&self) -> Outcome {
        match self.chosen {
            Some(_) => Outcome::Ok,
            None if self.open || self.undecided > 0 => Outcome::Undecided,
            None => Outcome::NotOk,
        }
    }
}

/// Refuses a cost that the first case with sound input does not have: of an unknown name, or the
/// mass where the template has no parts list.
pub fn check(plan: &Plan, kit: &Kit, choose: &Choose) -> Result<(), Box<Diagnostic>> {
    let screened = |case: &Case| screen(case, &plan.header.expansion, kit);
    let sound = |(_, record): &(&Case, Record)| record.outcome != Outcome::BadInput;
    let cases = plan.cases.iter().take(SOUND);
    match cases.map(|c| (c, screened(c))).find(sound) {
        Some((case, record)) => cost(&choose.least, case, plan, kit, &record).map(drop),
        None => Ok(()),
    }
}
