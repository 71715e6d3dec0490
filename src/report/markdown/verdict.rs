//! The box at the top of a report: the verdicts by code and by analysis, and the joint verdict with
//! its reason.

use crate::checks::Judgement;
use crate::checks::verdict::Verdict;
use crate::report::markdown::markup::{inline, paragraph, strings, table};
use crate::report::markdown::report_data::Table;
use crate::result::result_file::ResultFile;

/// The verdict and its basis.
pub(crate) fn verdict(page: &mut String, result: &ResultFile) {
    let Some(j) = &result.judgement else {
        match result.verdict {
            Verdict::NotOk => {
                paragraph(page, "Verdict: **NOT OK**: a check that needs no load fails.")
            }
            _ => paragraph(
                page,
                "No verdict: no load is a demand on the joint (only actions at member ends are).",
            ),
        }
        return;
    };
    paragraph(page, &format!("Verdict: **{}**. {}.", j.verdict.words(), inline(&j.reason)));
    let columns = strings(["verdict", "", "stands on"]);
    table(page, &Table { columns, rows: rows(j) });
}

fn rows(j: &Judgement) -> Vec<Vec<String>> {
    let row = |(name, verdict, on): (&str, Verdict, &str)| {
        vec![name.to_owned(), verdict.words().into(), on.to_owned()]
    };
    let all = ("**joint**", j.verdict, "the worse of the two");
    parts(j).into_iter().chain([all]).map(row).collect()
}

/// The verdicts by code and by analysis: name, verdict, and what it stands on.
pub(crate) fn parts(j: &Judgement) -> [(&'static str, Verdict, &'static str); 2] {
    let code = "binding checks of EN 1993; strength by the component method where no limit \
                analysis decides";
    let analysis = match j.by_analysis {
        Verdict::None => "no analysis of the resistance was run",
        _ => "strict bounds of limit analysis, the lower one without friction",
    };
    [("by code", j.by_code, code), ("by analysis", j.by_analysis, analysis)]
}
