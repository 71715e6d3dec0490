//! The end of every command that judges a spec: it judges the result, writes the folder, and
//! chooses the exit status.

use crate::driver::context::RunContext;
use crate::driver::interrupt::Interrupt;
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus, in_line};
use bracket_codes::verdict::Verdict;
use bracket_codes::{Analysed, HandChecks, judge};
use bracket_engine::model::AnalysisKind;
use bracket_report::console::answer::answer;
use bracket_report::console::log::Log;
use bracket_report::draw::moment_rotation;
use bracket_report::markdown::compose::report_markdown;
use bracket_report::markdown::report_data::ModelTraits;
use bracket_report::markdown::report_data::PictureRef;
use bracket_report::markdown::report_data::{GivenActions, REPORT_DATA_FILE, ReportData};
use bracket_report::page::scene::Scene;
use bracket_report::page::{self, PAGE_FILE};
use bracket_report::printed;
use bracket_report::result::folder::ResultFolder;
use bracket_report::result::result_file::CaseResult;
use bracket_report::result::result_file::HistoryRow;
use bracket_report::result::result_file::ResultFile;
use bracket_report::sheet::build::sheet;
use bracket_report::sheet::head::Paper;
use bracket_report::sheet::{Extent, PDF_FILE};

/// The data that the analyses of a run leave. The default describes a run without analyses.
#[derive(Default)]
pub struct Analyses {
    /// The user's request to stop.
    pub interrupt: Interrupt,
    /// Pictures in the folder.
    pub pictures: Vec<PictureRef>,
    /// Meshes and fields for the 3-D view.
    pub scene: Scene,
    /// Properties of the models.
    pub traits: ModelTraits,
    /// Decisions and remarks of the reader of the model file.
    pub notes: Vec<String>,
}

/// A completed run.
pub struct Finished {
    /// Exit status of the process.
    pub status: ExitStatus,
    /// The result with its verdict.
    pub result: ResultFile,
    /// True if the folder was written. False if an interrupt left nothing certified; an older
    /// result then stays in place.
    pub written: bool,
}

/// Judges the result, writes result and report, and logs the answer.
pub fn finish(
    mut result: ResultFile,
    mut context: RunContext,
    analyses: Analyses,
    folder: ResultFolder,
    log: &Log,
) -> Result<Finished, Diagnostics> {
    judge_result(&mut result, &mut context.checks, &context.input.demands);
    let interrupt = analyses.interrupt.clone();
    let result = write(result, context, analyses, &folder, log)?;
    // a request while the report was written counts too
    let interrupted = interrupt.asked();
    let status = if interrupted { ExitStatus::Undecided } else { exit_status(&result) };
    result.cases.iter().flat_map(answer).for_each(|line| log.line(line));
    result.warnings.iter().for_each(|w| log.line(format!("warning: {w}")));
    let bare = result.cases.iter().all(|c| c.lower.is_none() && c.upper.is_none());
    if interrupted && bare && folder.target().exists() {
        log.line(format!(
            "interrupted before anything was certified: {} stays as it was",
            folder.target().display()
        ));
        return Ok(Finished { status: ExitStatus::Undecided, result, written: false });
    }
    // the file contains the last lines too; the terminal shows them once the folder is complete
    let path = folder.target().join("report.md");
    let last = [
        format!("result: {}", path.display()),
        in_line(&verdict_line(&result, status, interrupted)),
    ];
    last.iter().for_each(|line| log.detail(line));
    folder.write("log.txt", log.text().as_bytes())?;
    folder.finish()?;
    last.iter().for_each(|line| log.say(line));
    Ok(Finished { status, result, written: true })
}

/// Writes drawings, `result.json` and the report; returns the result.
fn write(
    result: ResultFile,
    context: RunContext,
    analyses: Analyses,
    folder: &ResultFolder,
    log: &Log,
) -> Result<ResultFile, Diagnostics> {
    let json = result.to_json().map_err(Diagnostic::from)?;
    for (name, text) in &context.files {
        folder.write(name, text.as_bytes())?;
    }
    let mut input = context.input;
    if let Some((drawing, text)) = moment_rotation::drawing(&result, &context.rotation) {
        folder.write(&drawing.file, text.as_bytes())?;
        input.drawings.push(drawing);
    }
    let data = ReportData {
        input,
        result,
        pictures: analyses.pictures,
        mesh_quality: context.mesh_quality,
        model: analyses.traits,
        assumptions: Vec::new(),
        notes: analyses.notes,
    };
    folder.write("result.json", json.as_bytes())?;
    folder.write(REPORT_DATA_FILE, data.to_json()?.as_bytes())?;
    let words = data.words();
    // page and PDF translate a drawing when they are made; report.md links to a file
    for picture in data.input.drawings.iter().chain(&data.pictures) {
        let Some(name) = words.file(&picture.file) else { continue };
        if let Some(bytes) = printed::picture(folder.path(), &picture.file, &words) {
            folder.write(&name, &bytes)?;
        }
    }
    let report = report_markdown(&data, &words);
    folder.write("report.md", report.as_bytes())?;
    let mut scene = analyses.scene;
    scene.add_facts(&data.result);
    scene.translate(&words);
    let picture = |name: &str| printed::picture(folder.path(), name, &words);
    let full = sheet(&data, &words, Extent::Full, Paper::A4);
    let html = page::page(&full, &scene, &words, picture)?;
    folder.write(PAGE_FILE, html.as_bytes())?;
    // the bounds do not depend on it: a report that cannot be set is no reason to lose them
    if cfg!(feature = "pdf") {
        match printed::pdf(&data, &words, folder.path(), Extent::Short, Paper::A4) {
            Ok(bytes) => folder.write(PDF_FILE, &bytes)?,
            Err(fault) => log.line(format!("warning: {}", fault.message)),
        }
    }
    Ok(data.result)
}

/// Meaning of the exit code after an interrupt. The verdict beside it is that of the work so far.
pub const INTERRUPTED: &str = "interrupted";

/// The verdict with the exit code and its meaning: the last line of the log.
fn verdict_line(result: &ResultFile, status: ExitStatus, interrupted: bool) -> String {
    let code = status.code();
    let interrupted = interrupted.then_some(INTERRUPTED);
    if let Some(judgement) = &result.judgement {
        return judgement.line(code, interrupted);
    }
    let meaning = interrupted.unwrap_or(match status {
        ExitStatus::NotOk => "a check that needs no load fails",
        ExitStatus::Undecided => "no certificate within the limits",
        _ if result.cases.is_empty() => "there was nothing to judge",
        _ => "certified",
    });
    format!(
        "verdict: {} (no load is a demand); exit code {code}: {meaning}",
        result.verdict.words()
    )
}

/// The load cases with a demand. If there are analyses, the cases are in the order of the analyses;
/// those in which nothing acts have none and stand behind.
fn demanded(demands: &[GivenActions], asked: &[String]) -> Vec<String> {
    let demanded = demands.iter().map(|d| &d.case);
    if asked.is_empty() {
        return demanded.cloned().collect();
    }
    let mut out: Vec<String> = Vec::new();
    for case in asked.iter().filter(|a| demanded.clone().any(|d| d == *a)) {
        if !out.contains(case) {
            out.push(case.clone());
        }
    }
    out.extend(demanded.filter(|d| !asked.contains(d)).cloned());
    out
}

/// Judges all load cases with a demand: sets their verdicts, and completes the checks by the
/// findings of the analyses. Only limit analysis brackets a resistance.
pub fn judge_result(result: &mut ResultFile, checks: &mut HandChecks, demands: &[GivenActions]) {
    let of_case = |case: &String| {
        let entries = || result.cases.iter().filter(|c| c.name == *case);
        let limit = entries().find(|c| c.analysis == AnalysisKind::Limit);
        let verdict =
            limit.and_then(|c| c.demand.as_ref()).map_or(Verdict::None, |d| d.by_analysis);
        let asked = result.asked.iter().filter(|a| *a == case).count();
        let missing = match limit {
            Some(c) => c.lacking().filter(|_| verdict == Verdict::Undecided),
            None => (entries().count() < asked).then(|| "its analysis was not run".to_owned()),
        };
        // only the absence of a rule keeps a lower bound above the load from deciding
        let carried = |c: &CaseResult| c.is_strict() && c.factor_bounds().0 >= Some(1.0);
        let no_rule = |c: &CaseResult| c.demand.as_ref().is_some_and(|d| d.brittle.is_some());
        let brittle = limit.is_some_and(|c| carried(c) && no_rule(c));
        Analysed {
            case: case.clone(),
            verdict,
            utilisation: limit.and_then(|c| c.utilisation),
            brittle,
            no_rule: limit.is_some_and(no_rule),
            missing,
        }
    };
    let analysed: Vec<Analysed> = demanded(demands, &result.asked).iter().map(of_case).collect();
    if analysed.is_empty() {
        result.verdict = if checks.failed() { Verdict::NotOk } else { Verdict::None };
    } else {
        let (judgement, each) = judge(checks, &analysed);
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
    result.checks.clone_from(&checks.checks);
    result.neglected.clone_from(&checks.neglected);
    result.component_method.clone_from(&checks.methods);
}

/// The exit status for the verdict. Without a demand it states whether all analyses are certified.
fn exit_status(result: &ResultFile) -> ExitStatus {
    let complete = result.asked.is_empty() || result.cases.len() == result.asked.len();
    match result.verdict {
        Verdict::NotOk => ExitStatus::NotOk,
        Verdict::Undecided => ExitStatus::Undecided,
        Verdict::Ok => ExitStatus::Ok,
        Verdict::None if complete && result.cases.iter().all(certified) => ExitStatus::Ok,
        Verdict::None => ExitStatus::Undecided,
    }
}

/// True if every program that ran gave its bound on some mesh, with a strict certificate, and there
/// is at least one bound.
pub fn certified(c: &CaseResult) -> bool {
    let ran = |program: fn(&HistoryRow) -> bool| c.history.iter().any(program);
    let given = |ran: bool, bound: bool| bound || !ran;
    c.certificate.is_some_and(|x| x.strict)
        && (c.upper.is_some() || c.lower.is_some())
        && given(ran(|h| h.kinematic.is_some()), c.upper.is_some())
        && given(ran(|h| h.static_.is_some()), c.lower.is_some())
}
