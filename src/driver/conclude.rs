//! What every command that judges a spec ends with: verdict, files of the result folder, last
//! words, exit code.

use crate::checks::verdict::Verdict;
use crate::checks::{Analysed, judge};
use crate::cli::{Common, Format};
use crate::diag::Diagnostic;
use crate::driver::case::RunContext;
use crate::report::console::answer::answer;
use crate::report::console::log::Log;
use crate::report::console::out;
use crate::report::html;
use crate::report::markdown::compose::report_markdown;
use crate::report::markdown::page::{ModelTraits, PictureRef, ReportData};
use crate::result::data::{CaseResult, HistoryRow, ResultFile};
use crate::result::folder::ResultFolder;
use crate::spec::analysis::AnalysisKind;

/// What the analyses of a run left behind.
pub struct Analyses {
    /// The load cases with a demand, each with the kinds of analysis asked for.
    pub demanded: Vec<(String, Vec<AnalysisKind>)>,
    /// Every case was analysed.
    pub complete: bool,
    /// The user ended the run.
    pub interrupted: bool,
    /// Pictures in the folder.
    pub pictures: Vec<PictureRef>,
    /// What the model holds.
    pub traits: ModelTraits,
    /// What the reader of the model decided or noticed.
    pub notes: Vec<String>,
}

/// Judges, writes result and report, prints the answer; returns the exit code.
pub fn conclude(
    mut result: ResultFile,
    mut context: RunContext,
    analyses: Analyses,
    folder: ResultFolder,
    log: &Log,
    common: &Common,
) -> crate::driver::CommandResult {
    judged(&mut result, &mut context, &analyses);
    let code = exit_code(&result, analyses.complete);
    let json = result.to_json().map_err(Diagnostic::from)?;
    for (drawing, text) in &context.drawings {
        folder.write(&drawing.file, text.as_bytes())?;
    }
    let data = ReportData {
        project: context.project,
        result,
        input_name: context.input_name,
        input_text: context.input_text,
        input_read: context.input_read,
        resolved: context.resolved,
        catalogue_rows: context.catalogue_rows,
        drawings: context.drawings.into_iter().map(|d| d.0).collect(),
        schedule: context.schedule,
        pictures: analyses.pictures,
        mesh_quality: context.mesh_quality,
        model: analyses.traits,
        assumptions: Vec::new(),
        notes: analyses.notes,
    };
    folder.write("result.json", json.as_bytes())?;
    let report = report_markdown(&data);
    folder.write("report.md", report.as_bytes())?;
    html::write(&folder, &report)?;
    let result = &data.result;
    for c in &result.cases {
        log.line(answer(c));
    }
    result.warnings.iter().for_each(|w| log.line(format!("warning: {w}")));
    let bare = result.cases.iter().all(|c| c.lower.is_none() && c.upper.is_none());
    if analyses.interrupted && bare && folder.target().exists() {
        log.line(format!(
            "interrupted before anything was certified: {} stays as it was",
            folder.target().display()
        ));
        return Ok(3);
    }
    let last = match &result.judgement {
        Some(judgement) => judgement.line(code),
        None => {
            let meaning = match code {
                1 => "a check that needs no load fails",
                3 => "no certificate within the limits",
                _ if result.cases.is_empty() => "there was nothing to judge",
                _ => "certified",
            };
            format!(
                "verdict: {} (no load is a demand); exit code {code}: {meaning}",
                result.verdict.words()
            )
        }
    };
    // the file holds the last words as well, the terminal gets them once the folder is whole
    let words = [format!("result: {}", folder.target().join("report.md").display()), last];
    words.iter().for_each(|w| log.detail(w));
    folder.write("log.txt", log.text().as_bytes())?;
    folder.finish()?;
    words.iter().for_each(|w| log.say(w));
    if common.format == Format::Json {
        out::text(&json)?;
    }
    Ok(code)
}

/// The verdicts of all load cases with a demand; the checks end as the analyses leave them.
fn judged(result: &mut ResultFile, context: &mut RunContext, analyses: &Analyses) {
    let of_case = |(case, kinds): &(String, Vec<AnalysisKind>)| {
        let entries = || result.cases.iter().filter(|c| c.name == *case);
        let limit = entries().find(|c| c.analysis == AnalysisKind::Limit);
        let by_analysis =
            |c: &CaseResult| c.demand.as_ref().map_or(Verdict::None, |d| d.by_analysis);
        // a bracket of the resistance decides; without one, an analysis that failed leaves the case
        // open
        let verdict = match limit {
            Some(c) => by_analysis(c),
            None if entries().count() < kinds.len() => Verdict::Undecided,
            None => Verdict::worst(entries().map(by_analysis)),
        };
        let brittle = limit.and_then(|c| c.demand.as_ref()).is_some_and(|d| d.brittle.is_some());
        Analysed {
            case: case.clone(),
            verdict,
            utilisation: limit.and_then(|c| c.utilisation),
            brittle,
        }
    };
    let analysed: Vec<Analysed> = analyses.demanded.iter().map(of_case).collect();
    if analysed.is_empty() {
        result.verdict = if context.checks.failed() { Verdict::NotOk } else { Verdict::None };
    } else {
        let (judgement, each) = judge(&mut context.checks, &analysed);
        for (a, j) in analysed.iter().zip(&each) {
            let demands = result
                .cases
                .iter_mut()
                .filter(|c| c.name == a.case)
                .filter_map(|c| c.demand.as_mut());
            demands.for_each(|d| d.judged(j));
        }
        result.verdict = judgement.verdict;
        result.judgement = Some(judgement);
    }
    result.checks.clone_from(&context.checks.checks);
}

/// The exit code that fits the verdict; without a demand it says whether the analyses are
/// certified.
fn exit_code(result: &ResultFile, complete: bool) -> u8 {
    let certified = result.cases.iter().all(certified);
    match result.verdict {
        Verdict::NotOk => 1,
        Verdict::Undecided => 3,
        Verdict::Ok => 0,
        Verdict::None if complete && certified => 0,
        Verdict::None => 3,
    }
}

/// Every program that ran gave its bound, on one mesh or another, with a certificate; where none
/// had to run, there is one.
pub fn certified(c: &CaseResult) -> bool {
    let ran = |program: fn(&HistoryRow) -> bool| c.history.iter().any(program);
    let given = |ran: bool, bound: bool| bound || !ran;
    c.certificate.is_some_and(|x| x.strict)
        && (c.upper.is_some() || c.lower.is_some())
        && given(ran(|h| h.kinematic.is_some()), c.upper.is_some())
        && given(ran(|h| h.static_.is_some()), c.lower.is_some())
}
