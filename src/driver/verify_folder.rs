//! The verification of a result folder: its digests, the bounds from their fields, and what follows
//! from the spec.

use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::verify_spec::{Again, judged_again};
use crate::report::markdown::report_data::ReportData;
use crate::result::digests::{DIGESTS_FILE, Digests};
use crate::result::result_file::{RESULT_FILE, ResultFile};
use crate::result::verify::{self, Finding};
use std::path::Path;

/// Numbers of a result that no file of it proves.
const RECORDED: &str = "seconds, memory and iterations of `history`, `coulomb_estimate`, \
                        `fixed_point`, `warnings`, `input_hash`";

/// The outcome of the verification of a folder.
pub struct Verified {
    /// Every claimed bound.
    pub bounds: Vec<Finding>,
    /// Sentences for the other claims that are refuted.
    pub refuted: Vec<String>,
    /// What was computed again and agrees, unless a sentence of `refuted` says otherwise.
    pub recomputed: Vec<String>,
    /// What stands in the result as the run wrote it: only the digests show that nobody has changed
    /// it since.
    pub recorded: Vec<String>,
}

impl Verified {
    /// True if every claim is confirmed.
    pub fn confirmed(&self) -> bool {
        self.bounds.iter().all(|f| f.confirmed) && self.refuted.is_empty()
    }
}

/// Verifies the result in a folder.
pub fn verify_folder(folder: &Path) -> Result<Verified, Diagnostics> {
    let verification = verify::verify(folder)?;
    let (bounds, mut refuted) = (verification.findings, verification.refuted);
    let mut recomputed = Vec::new();
    if !bounds.is_empty() {
        recomputed.push("the bounds and what follows from their fields".into());
    }
    let mut recorded = vec![RECORDED.into()];
    match Digests::read(folder) {
        Ok(Some(digests)) => {
            refuted.extend(digests.differences(folder));
            if !digests.lists(RESULT_FILE) {
                refuted.push(format!("{DIGESTS_FILE} does not list {RESULT_FILE}"));
            }
        }
        Ok(None) => refuted.push(format!(
            "{DIGESTS_FILE} is missing: nothing shows that the recorded values are those of the run"
        )),
        Err(e) => refuted.push(format!("{DIGESTS_FILE} cannot be read: {e}")),
    }
    let text = verify::read(&folder.join(RESULT_FILE))?;
    let result =
        ResultFile::from_json(&String::from_utf8_lossy(&text)).map_err(Diagnostic::from)?;
    let asked_for = result.cases.iter().zip(&result.asked).all(|(c, asked)| c.name == *asked);
    if !asked_for || result.cases.len() > result.asked.len() {
        refuted.push("`cases` are not those of `asked`".into());
    }
    if result.asked.is_empty() && folder.join("model.yaml").exists() {
        refuted.push("there is a model, and `asked` names no analysis".into());
    }
    match ReportData::read(folder).map(|data| judged_again(folder, &result, &data)) {
        Ok(Again::Recomputed { what, differences }) => {
            refuted.extend(differences);
            recomputed.push(what.into());
        }
        Ok(Again::Recorded { what }) => recorded.push(what),
        Err(faults) => recorded
            .push(format!("`checks`, demands and verdicts ({})", faults.into_first().message)),
    }
    Ok(Verified { bounds, refuted, recomputed, recorded })
}
