//! The box at the top of a report: the verdicts by code and by analysis, and the joint verdict with
//! its reason.

use crate::document::Doc;
use crate::document::table::{Table, bold, cells};
use crate::result::result_file::ResultFile;
use crate::summary::{RowKind, SummaryRow, summary_rows};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::verdict::{Route, Verdict};
use bracket_codes::{Binding, Judgement, Status};

/// The verdict and its basis.
pub(crate) fn verdict(doc: &mut Doc, result: &ResultFile) {
    let Some(j) = &result.judgement else {
        match result.verdict {
            Verdict::NotOk => {
                doc.paragraph("Verdict: **NOT OK**: a check that needs no load fails.")
            }
            _ => doc.paragraph(
                "No verdict: no load is a demand on the joint (only actions at member ends are).",
            ),
        }
        return;
    };
    doc.paragraph(say!("Verdict: **{}**. {}.", j.words(), &j.reason));
    let columns = Table::columns(["verdict", "", "stands on"]);
    doc.table(&Table { columns, rows: rows(j, result) });
    if let Some(step) = next_step(result) {
        doc.paragraph(say!("Next step: {}.", step));
    }
}

fn rows(j: &Judgement, result: &ResultFile) -> Vec<Vec<Text>> {
    let part =
        |(name, verdict, on): (&'static str, Verdict, Text)| cells![name, verdict.words(), on];
    let on = match (j.verdict, j.route) {
        (Verdict::Ok, Some(Route::Code)) => "the code's route, which is complete and holds",
        (Verdict::Ok, _) => "the lower bound, and the checks of what it does not know",
        (Verdict::NotOk, _) => "what fails: no route overrules it",
        (Verdict::Undecided, _) => "neither route is complete",
        (Verdict::None, _) => "no demand at the ultimate limit state",
    };
    let all = cells![bold("joint"), j.words(), on];
    parts(j, result).map(part).into_iter().chain([all]).collect()
}

/// The verdicts by code and by analysis: name, verdict, and what it stands on.
pub(crate) fn parts(j: &Judgement, result: &ResultFile) -> [(&'static str, Verdict, Text); 2] {
    let mut code = vec![Text::from(
        "binding checks of EN 1993, those of strength where no limit analysis decides",
    )];
    let binds = |r: &&SummaryRow| r.kind != RowKind::Bracket && r.governs_by.is_some();
    let by = |r: &SummaryRow| r.governs_by.unwrap_or(0.0);
    let rows = summary_rows(result);
    let worst = rows.iter().filter(binds).reduce(|a, b| if by(b) > by(a) { b } else { a });
    if let Some(r) = worst.filter(|r| by(r).is_finite()) {
        code.push(say!("largest utilisation {}, {}", &r.utilisation, &r.check));
    }
    let beside = rows.iter().filter(|r| r.kind == RowKind::Exceeded);
    if let Some(r) = beside.max_by(|a, b| a.size.total_cmp(&b.size)) {
        code.push(say!(
            "beside the limit analysis, for information: the component method is exceeded, \
             utilisation {}",
            &r.utilisation
        ));
    }
    let mut analysis = vec![Text::from(match j.by_analysis {
        Verdict::None => "no analysis of the resistance was run",
        _ => "strict bounds of limit analysis, the lower one without friction",
    })];
    let bracket = rows.iter().filter(|r| r.kind == RowKind::Bracket && r.governs_by.is_some());
    if let Some(r) = bracket.reduce(|a, b| if by(b) > by(a) { b } else { a }) {
        analysis.push(say!("utilisation {}", &r.utilisation));
    }
    let all = |of: Vec<Text>| Text::joined("; ", of);
    [("by code", j.by_code, all(code)), ("by analysis", j.by_analysis, all(analysis))]
}

/// What brings the user further; `None` where nothing is left to do, or where the reason says it.
pub(crate) fn next_step(result: &ResultFile) -> Option<&'static str> {
    let j = result.judgement.as_ref().filter(|j| j.verdict == Verdict::NotOk)?;
    let ruled = || {
        let mut demands = result.cases.iter().filter_map(|c| c.demand.as_ref());
        demands.all(|d| d.brittle.is_none())
    };
    let fails_only_by_method = || {
        let mut failed = result.checks.iter().filter(|c| c.status == Status::Failed);
        failed.all(|c| c.binding == Binding::Strength)
    };
    let narrower = j.by_analysis == Verdict::Undecided && fails_only_by_method() && ruled();
    Some(match narrower {
        true => {
            "narrow the bounds by a finer mesh, more meshes or time, because the component method \
             is information where they decide and no part can buckle; or strengthen what governs"
        }
        false => "strengthen what governs, or reduce its load",
    })
}
