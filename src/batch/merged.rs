//! The records of all cases of a sweep, in the order of the plan.

use super::analysing::wanted;
use super::plan::Plan;
use super::row::Record;
use super::sweep_folder::SweepFolder;
use crate::diag::Diagnostic;
use std::collections::BTreeMap;

/// The record of each case of a plan; `None` where it is not finished.
///
/// A case with finite elements has the record of its process; where none are asked for, that of
/// its checks.
pub fn records(folder: &SweepFolder, plan: &Plan) -> Result<Vec<Option<Record>>, Box<Diagnostic>> {
    let mut out: Vec<Option<Record>> = Vec::with_capacity(plan.cases.len());
    let checks = plan.header.first.is_some();
    let mut analysed: BTreeMap<&str, Option<Record>> = BTreeMap::new();
    let elements = plan.header.meshes();
    for run in folder.runs(&plan.cases) {
        let checked = if checks { folder.checked(run)? } else { None };
        for (i, case) in run.iter().enumerate() {
            let found = if elements {
                if !analysed.contains_key(case.key.as_str()) {
                    analysed.insert(&case.key, folder.analysed(&case.key)?);
                }
                analysed[case.key.as_str()].clone()
            } else {
                None
            };
            // the checks of a case that waits for finite elements are no answer yet
            let waits = |r: &Record| plan.header.then.is_some_and(|then| wanted(then.limit, r));
            let alone = checked.as_ref().map(|c| &c[i]).filter(|r| !waits(r));
            out.push(found.or_else(|| alone.cloned()));
        }
    }
    Ok(out)
}
