//! The box at the top of a report: the verdicts by code and by analysis, and the joint verdict with
//! its reason.

use crate::checks::verdict::Verdict;
use crate::checks::{Judgement, Status, Topic};
use crate::report::markdown::markup::{bold, inline, paragraph, strings, table};
use crate::report::markdown::report_data::Table;
use crate::report::summary::{EXCEEDED, LIMIT_ANALYSIS, SummaryRow, summary_rows};
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
    table(page, &Table { columns, rows: rows(j, result) });
    if let Some(step) = next_step(result) {
        paragraph(page, &format!("Next step: {step}."));
    }
}

fn rows(j: &Judgement, result: &ResultFile) -> Vec<Vec<String>> {
    let row =
        |(name, verdict, on): (String, Verdict, String)| vec![name, verdict.words().into(), on];
    let all = (bold("joint"), j.verdict, "the worse of the two".into());
    let parts = parts(j, result).map(|(name, verdict, on)| (name.to_owned(), verdict, on));
    parts.into_iter().chain([all]).map(row).collect()
}

/// The verdicts by code and by analysis: name, verdict, and what it stands on.
pub(crate) fn parts(j: &Judgement, result: &ResultFile) -> [(&'static str, Verdict, String); 2] {
    let mut code = "binding checks of EN 1993; strength by the component method where no limit \
                    analysis decides"
        .to_string();
    let binds = |r: &&SummaryRow| r.clause != LIMIT_ANALYSIS && r.governs_by.is_some();
    let by = |r: &SummaryRow| r.governs_by.unwrap_or(0.0);
    let rows = summary_rows(result);
    let worst = rows.iter().filter(binds).reduce(|a, b| if by(b) > by(a) { b } else { a });
    if let Some(r) = worst.filter(|r| by(r).is_finite()) {
        code += &format!("; largest utilisation {}, {}", r.utilisation, r.check);
    }
    let beside = rows.iter().filter(|r| r.status == EXCEEDED);
    if let Some(r) = beside.max_by(|a, b| a.size.total_cmp(&b.size)) {
        code += &format!(
            "; beside the limit analysis, for information: the component method is exceeded, \
             utilisation {}",
            r.utilisation
        );
    }
    let mut analysis = match j.by_analysis {
        Verdict::None => "no analysis of the resistance was run",
        _ => "strict bounds of limit analysis, the lower one without friction",
    }
    .to_string();
    let bracket = rows.iter().filter(|r| r.clause == LIMIT_ANALYSIS && r.governs_by.is_some());
    if let Some(r) = bracket.reduce(|a, b| if by(b) > by(a) { b } else { a }) {
        analysis += &format!("; utilisation {}", r.utilisation);
    }
    [("by code", j.by_code, code), ("by analysis", j.by_analysis, analysis)]
}

/// What brings the user further; `None` where nothing is left to do.
pub(crate) fn next_step(result: &ResultFile) -> Option<&'static str> {
    let j = result.judgement.as_ref()?;
    let no_rule = || {
        let mut demands = result.cases.iter().filter_map(|c| c.demand.as_ref());
        demands.any(|d| d.by_analysis == Verdict::Undecided && d.brittle.is_some())
    };
    let fails_only_by_method = || {
        let mut failed = result.checks.iter().filter(|c| c.status == Status::Failed);
        failed.all(|c| c.topic == Topic::ComponentMethod)
    };
    Some(match (j.verdict, j.by_code, j.by_analysis) {
        (Verdict::NotOk, _, Verdict::Undecided) if fails_only_by_method() => {
            "narrow the bounds by a finer mesh, more meshes or time, because the component method \
             is information where they decide and no part can buckle; or strengthen what governs"
        }
        (Verdict::NotOk, ..) => "strengthen what governs, or reduce its load",
        (Verdict::Undecided, Verdict::Undecided, _) => {
            "see the undecided check: it says what its clause does not cover"
        }
        (Verdict::Undecided, _, Verdict::Undecided) if no_rule() => {
            "make the plate thinner or the bolts stronger until a rule of rotation capacity \
             holds, or leave out limit analysis: `kind: elastic`, and the component method decides"
        }
        (Verdict::Undecided, _, Verdict::Undecided) => {
            "narrow the bounds: more meshes or time (`max_passes`, `time_limit`), or a finer mesh \
             (a smaller `--size-factor`)"
        }
        (Verdict::Undecided, ..) => "run a limit analysis (`kind: limit`)",
        _ => return None,
    })
}
