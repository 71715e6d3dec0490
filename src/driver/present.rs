//! The end of every command that judges a spec: it writes the folder, and chooses the exit status.

use crate::driver::context::RunContext;
use crate::driver::interrupt::Interrupt;
use crate::driver::judge::Judged;
use crate::driver::printing;
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus, in_line};
use bracket_base::say;
use bracket_base::words::Collected;
use bracket_report::console::answer::answer;
use bracket_report::console::log::Log;
use bracket_report::document::picture::PictureRef;
use bracket_report::document::table::Table;
use bracket_report::draw::{moment_rotation, polygon};
use bracket_report::markdown::compose::report_markdown;
use bracket_report::markdown::report_data::{REPORT_DATA_FILE, ReportData};
use bracket_report::page::scene::Scene;
use bracket_report::page::{self, PAGE_FILE};
use bracket_report::pdf;
use bracket_report::printed;
use bracket_report::result::case_result::CaseResult;
use bracket_report::result::folder::ResultFolder;
use bracket_report::result::judged_case::{CASES_FILE, cases_csv};
use bracket_report::result::result_file::ResultFile;
use bracket_report::sheet::build::sheet;
use bracket_report::sheet::head::Paper;
use bracket_report::sheet::{Extent, PDF_FILE};

/// What the reports show of the cases of a run. The default is that of a run without analyses.
#[derive(Default)]
pub struct Drawn {
    /// Pictures in the folder.
    pub pictures: Vec<PictureRef>,
    /// Meshes and fields for the 3-D view.
    pub scene: Scene,
    /// Quality of the mesh.
    pub mesh_quality: Table,
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

/// Writes result and report, and logs the answer.
pub fn present(
    judged: Judged,
    context: RunContext,
    mut drawn: Drawn,
    interrupt: &Interrupt,
    folder: ResultFolder,
    log: &Log,
) -> Result<Finished, Diagnostics> {
    let status = judged.status();
    if let Some(polygon) = &judged.result.polygon {
        let [a, b] = polygon.axes.each_ref().map(|a| &a.action);
        let caption = say!("Capacity in {} and {}", a, b);
        let (picture, text) = polygon::drawing(polygon, context.axial_moment.as_deref())
            .picture("polygon.svg", caption);
        folder.write(&picture.file, text.as_bytes())?;
        drawn.pictures.insert(0, picture);
    }
    let result = write(judged, context, drawn, &folder, log)?;
    // a request while the report was written counts too
    let interrupted = interrupt.asked();
    let status = if interrupted { ExitStatus::Undecided } else { status };
    let analysed = |c: &&CaseResult| c.proved_by.is_none();
    result.cases.iter().filter(analysed).flat_map(answer).for_each(|line| log.line(line));
    let others = result.cases.iter().filter(|c| c.proved_by.is_some()).count();
    if others > 0 {
        log.line(format!("{others} load cases are bounded by these analyses: {CASES_FILE}"));
    }
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
    judged: Judged,
    context: RunContext,
    drawn: Drawn,
    folder: &ResultFolder,
    log: &Log,
) -> Result<ResultFile, Diagnostics> {
    let Judged { result, models } = judged;
    let json = result.to_json().map_err(Diagnostic::from)?;
    for (name, text) in &context.files {
        folder.write(name, text.as_bytes())?;
    }
    let mut input = context.input;
    if let Some((drawing, text)) = moment_rotation::drawing(&result, &context.rotation) {
        folder.write(&drawing.file, text.as_bytes())?;
        input.drawings.push(drawing);
    }
    let mut data = ReportData {
        input,
        result,
        pictures: drawn.pictures,
        mesh_quality: drawn.mesh_quality,
        model: models.traits,
        assumptions: Vec::new(),
        notes: models.notes,
        words: Collected::new(),
    };
    folder.write("result.json", json.as_bytes())?;
    if !data.result.load_cases.is_empty() {
        let given = data.input.demands.iter().map(|d| (d.case.as_str(), d.actions.as_slice()));
        let table = cases_csv(&data.result.load_cases, &given.collect::<Vec<_>>());
        folder.write(CASES_FILE, table.as_bytes())?;
    }
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
    let mut scene = drawn.scene;
    scene.add_facts(&data.result);
    let picture = |name: &str| printed::picture(folder.path(), name, &words);
    let full = sheet(&data, &words, Extent::Full, Paper::A4);
    let html = page::page(&full, &scene, &words, picture)?;
    folder.write(PAGE_FILE, html.as_bytes())?;
    // the bounds do not depend on it: a report that cannot be set is no reason to lose them
    if cfg!(feature = "pdf") {
        let printout = pdf::report(&data, &words, folder.path(), Extent::Short, Paper::A4);
        match printout.and_then(printing::pdf) {
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
