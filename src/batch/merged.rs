//! The records of all cases of a sweep, in the order of the plan, and what was chosen.

use super::analysing::wanted;
use super::choice::{self, Decision};
use super::plan::Plan;
use super::row::{Outcome, Record};
use super::sweep_folder::SweepFolder;
use crate::checks::verdict::Verdict;
use crate::diag::{Diagnostic, Diagnostics};
use std::collections::BTreeMap;

/// What a sweep has found so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Merged {
    /// The record of each case; `None` where it is not finished.
    pub records: Vec<Option<Record>>,
    /// The groups of the choice.
    pub decisions: Vec<Decision>,
}

/// Reads the records of a plan.
///
/// A case with finite elements has the record of its process; where none are asked for, that of
/// its checks.
pub fn merged(folder: &SweepFolder, plan: &Plan) -> Result<Merged, Diagnostics> {
    let header = &plan.header;
    let count = plan.cases.len();
    let checked = match header.first {
        Some(_) => folder.all_checked(&plan.cases)?,
        None => vec![None; count],
    };
    let analysed = if header.meshes() { analysed(folder, plan)? } else { vec![None; count] };
    let decisions = decisions(plan, &checked, &analysed)?;
    // the checks of a case that waits for finite elements are no answer yet
    let waits = |r: &Record| header.then.is_some_and(|then| wanted(then.limit, r));
    let alone = checked.iter().map(|c| c.as_ref().filter(|r| !waits(r)));
    let mut records: Vec<Option<Record>> =
        analysed.into_iter().zip(alone).map(|(a, c)| a.or_else(|| c.cloned())).collect();
    for decision in &decisions {
        let Some(chosen) = decision.choice() else { continue };
        let name = &plan.cases[chosen.case].name;
        for c in decision.dearer().iter().filter(|c| c.analyse) {
            if let (empty @ None, Some(checked)) = (&mut records[c.case], &checked[c.case]) {
                *empty = Some(not_needed(checked, name));
            }
        }
    }
    Ok(Merged { records, decisions })
}

/// The records of finite elements.
fn analysed(folder: &SweepFolder, plan: &Plan) -> Result<Vec<Option<Record>>, Box<Diagnostic>> {
    let mut known: BTreeMap<&str, Option<Record>> = BTreeMap::new();
    let mut out = Vec::with_capacity(plan.cases.len());
    for case in &plan.cases {
        if !known.contains_key(case.key.as_str()) {
            known.insert(&case.key, folder.analysed(&case.key)?);
        }
        out.push(known[case.key.as_str()].clone());
    }
    Ok(out)
}

fn decisions(
    plan: &Plan,
    checked: &[Option<Record>],
    analysed: &[Option<Record>],
) -> Result<Vec<Decision>, Diagnostics> {
    let Some(choose) = &plan.header.choose else { return Ok(Vec::new()) };
    let kit = plan.header.kit(&plan.header.mesher)?;
    let mut out = Vec::new();
    for group in choice::groups(plan, choose) {
        let complete = group.cases.iter().all(|&i| checked[i].is_some());
        let candidates = choice::candidates(&group, plan, &kit, choose, checked);
        out.push(Decision::new(&group, candidates, |i| analysed[i].as_ref(), complete));
    }
    Ok(out)
}

/// The record of a case whose analysis the choice made unnecessary.
fn not_needed(checked: &Record, chosen: &str) -> Record {
    let mut record = checked.clone();
    record.outcome = Outcome::Undecided;
    record.cause = Some(format!("not analysed: `{chosen}` costs less and holds"));
    record.loads.iter_mut().for_each(|l| l.verdict = Verdict::Undecided);
    record
}
