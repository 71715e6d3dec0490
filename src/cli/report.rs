//! `bracket report`: the printed report of a finished result.

use super::common::{CommandResult, Common, Format};
use crate::driver::interrupt::Interrupt;
use crate::driver::printing;
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus};
use bracket_joint::spec::connection::Language;
use bracket_report::console::log::Log;
use bracket_report::console::out;
use bracket_report::markdown::report_data::{REPORT_DATA_FILE, ReportData};
use bracket_report::pdf;
use bracket_report::printed;
use bracket_report::result::digests::{DIGESTS_FILE, Digests};
use bracket_report::result::result_file::RESULT_FILE;
use bracket_report::sheet::head::Paper;
use bracket_report::sheet::{Extent, PDF_FILE};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Print the report of a finished result as PDF.
#[derive(Debug, clap::Args)]
pub struct ReportArgs {
    /// Result folder of `run`, `check` or `analyse`.
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Also checks with their numbers, meshes, certificate, catalogue rows and input.
    #[arg(long)]
    pub full: bool,
    /// Size of the paper.
    #[arg(long, value_enum, default_value_t)]
    pub paper: PaperArg,
    /// Language of the words; that of the spec if left out. Pictures of meshes keep theirs.
    #[arg(long, value_parser = language())]
    pub language: Option<Language>,
    /// File to write instead of `report.pdf` in the folder.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Reads the code of a language.
fn language() -> impl TypedValueParser<Value = Language> {
    let of = |code: String| Language::ALL.into_iter().find(|l| l.code() == code);
    PossibleValuesParser::new(Language::ALL.map(Language::code))
        .try_map(move |code| of(code).ok_or("no language"))
}

/// Paper on the command line.
#[derive(Clone, Copy, Debug, Default, clap::ValueEnum)]
pub enum PaperArg {
    /// 210 × 297 mm.
    #[default]
    A4,
    /// 8.5 × 11 inches.
    Letter,
}

/// Refuses a file that is no PDF: it is not a report that a new one may replace.
fn free_or_pdf(path: &Path) -> Result<(), Diagnostics> {
    let refuse = |what: &str| {
        let message = format!("`{}` {what}, and is not replaced", path.display());
        Err(Diagnostic::input("cli/report-out", message)
            .help("name a new file with --out, or an earlier report")
            .into())
    };
    // a missing folder, and a folder in place of a file, are faults of writing
    if path.is_dir() || path.symlink_metadata().is_err() {
        return Ok(());
    }
    if !path.is_file() {
        return refuse("is not a regular file");
    }
    let mut start = [0; 5];
    let read = File::open(path).and_then(|mut f| f.read_exact(&mut start));
    if read.is_ok() && start == *b"%PDF-" { Ok(()) } else { refuse("is not a PDF") }
}

/// Refuses a result that is not what a run wrote: a report would print its numbers and its verdict.
fn unchanged(folder: &Path) -> Result<(), Diagnostics> {
    let refuse = |what: String| {
        Err(Diagnostic::input("report/changed", what)
            .file(folder.join(DIGESTS_FILE))
            .help("make the result again; `bracket verify` says what it claims without proof")
            .into())
    };
    match Digests::read(folder) {
        Ok(Some(digests)) => {
            let files = [RESULT_FILE, REPORT_DATA_FILE];
            let difference = files.iter().find_map(|name| digests.difference(folder, name));
            difference.map_or(Ok(()), refuse)
        }
        Ok(None) => refuse("no list of digests says that the result is what a run wrote".into()),
        Err(e) => refuse(format!("the list of digests cannot be read: {e}")),
    }
}

/// Runs `bracket report`.
pub fn run(args: &ReportArgs, common: &Common) -> CommandResult {
    let interrupt = Interrupt::watch()?;
    let mut data = ReportData::read(&args.folder)?;
    unchanged(&args.folder)?;
    data.input.language = args.language.unwrap_or(data.input.language);
    let extent = if args.full { Extent::Full } else { Extent::Short };
    let paper = match args.paper {
        PaperArg::A4 => Paper::A4,
        PaperArg::Letter => Paper::Letter,
    };
    let path = args.out.clone().unwrap_or_else(|| args.folder.join(PDF_FILE));
    if args.out.is_some() {
        free_or_pdf(&path)?;
    }
    let words = data.words();
    let bytes = printing::pdf(pdf::report(&data, &words, &args.folder, extent, paper)?)?;
    // a moment in which a signal waits, so that no half of a file is left
    let log = Arc::new(Log::new(true));
    let part = printed::part(&path);
    interrupt.begin(&log, "the report is written", move || _ = std::fs::remove_file(&part));
    printed::write(&path, &bytes)?;
    if args.out.is_none() {
        // the printed report is a file of the result
        if let Ok(Some(mut digests)) = Digests::read(&args.folder) {
            digests.set(PDF_FILE, &bytes);
            printed::write(&args.folder.join(DIGESTS_FILE), digests.text().as_bytes())?;
        }
    }
    if interrupt.asked() {
        return Ok(ExitStatus::Undecided);
    }
    let english = words.unknown();
    match common.format {
        Format::Json => out::json(&serde_json::json!({
            "report": path, "bytes": bytes.len(), "untranslated": english
        }))?,
        Format::Text => {
            out::text(&format!("report: {}\n", path.display()))?;
            if !english.is_empty() {
                out::text(&format!("texts that stay English: {}\n", english.len()))?;
            }
        }
    }
    Ok(ExitStatus::Ok)
}
