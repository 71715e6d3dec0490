//! The records of all cases of a sweep, in the order of the plan, and what was chosen.

use super::choice::{self, Decider, Decision, Group};
use super::plan::Plan;
use super::row::{Outcome, Record};
use super::screen::Kit;
use super::sweep_folder::SweepFolder;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_codes::verdict::Verdict;
use std::collections::BTreeMap;

/// What a sweep has found so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Merged {
    /// The record of each case; `None` where it is not finished.
    pub records: Vec<Option<Record>>,
    /// What the checks found; `None` where they are not made.
    pub checked: Vec<Option<Record>>,
    /// The groups of the choice.
    pub decisions: Vec<Decision>,
}

/// Reads the records of a plan.
///
/// A case with finite elements has the record of its process; where none are asked for, that of
/// its checks. `kit` is needed where a joint is chosen.
pub fn merged(folder: &SweepFolder, plan: &Plan, kit: Option<&Kit>) -> Result<Merged, Diagnostics> {
    let header = &plan.header;
    let checked = match header.first {
        Some(_) => folder.all_checked(&plan.cases)?,
        None => vec![None; plan.cases.len()],
    };
    // the records of an earlier plan may be there: only what this one asks for counts
    let asked = |i: usize| checked[i].as_ref().map_or(header.first.is_none(), |r| header.wants(r));
    let analysed = analysed(folder, plan, &asked)?;
    let decisions = decisions(plan, kit, &checked, &analysed);
    let one = |(i, found): (usize, &Option<Record>)| match found {
        Some(record) => Some(record.clone()),
        // the checks of a case that waits for finite elements are no answer yet
        None => checked[i].clone().filter(|r| !header.wants(r)),
    };
    let mut records: Vec<Option<Record>> = analysed.iter().enumerate().map(one).collect();
    for decision in &decisions {
        let Some(chosen) = decision.choice() else { continue };
        let name = &plan.cases[chosen.case].name;
        for c in decision.dearer().iter().filter(|c| c.decider == Decider::Analysis) {
            let record = &mut records[c.case];
            // an analysis that failed is not tried again either
            if let (None | Some(false), Some(checked)) =
                (record.as_ref().map(Record::is_final), &checked[c.case])
            {
                *record = Some(not_needed(checked, name));
            }
        }
    }
    Ok(Merged { records, checked, decisions })
}

/// The records of finite elements of the cases that ask for them.
fn analysed(
    folder: &SweepFolder,
    plan: &Plan,
    asked: &dyn Fn(usize) -> bool,
) -> Result<Vec<Option<Record>>, Box<Diagnostic>> {
    let mut known: BTreeMap<&str, Option<Record>> = BTreeMap::new();
    let mut out = Vec::with_capacity(plan.cases.len());
    for (i, case) in plan.cases.iter().enumerate() {
        if !asked(i) {
            out.push(None);
            continue;
        }
        if !known.contains_key(case.key.as_str()) {
            known.insert(&case.key, folder.analysed(&case.key)?);
        }
        out.push(known[case.key.as_str()].clone());
    }
    Ok(out)
}

fn decisions(
    plan: &Plan,
    kit: Option<&Kit>,
    checked: &[Option<Record>],
    analysed: &[Option<Record>],
) -> Vec<Decision> {
    let Some((choose, kit)) = plan.header.choose.as_ref().zip(kit) else { return Vec::new() };
    let one = |group: Group| {
        let candidates = choice::candidates(&group, plan, kit, choose, checked);
        Decision::new(&group, candidates, checked, analysed)
    };
    choice::groups(plan, choose).into_iter().map(one).collect()
}

/// The record of a case whose analysis the choice made unnecessary.
fn not_needed(checked: &Record, chosen: &str) -> Record {
    let mut record = checked.clone();
    record.outcome = Outcome::Undecided;
    record.cause = Some(format!("not analysed: `{chosen}` costs no more and holds"));
    record.loads.iter_mut().for_each(|l| l.verdict = Verdict::Undecided);
    record
}
