//! The folder of a sweep: the plan, the records of finished work, and the tables.
//!
//! ```text
//! DIR/plan.json            what a run needs besides the cases
//! DIR/cases.jsonl          a case a line
//! DIR/checks/HASH.jsonl    records of the checks of a run of cases; HASH of their keys
//! DIR/records/KEY.json     record of a case with finite elements
//! DIR/cases/KEY/           its result folder
//! DIR/results.csv, …       the tables
//! ```
//!
//! Every file is written aside and renamed. There are no locks: two processes that do the same work
//! write the same file, and one of the two stays.

use super::case::Case;
use super::plan::{Header, Plan, SCHEMA};
use super::row::Record;
use bracket_base::diag::{Diagnostic, Diagnostics};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

/// File that makes a folder the folder of a sweep.
const PLAN: &str = "plan.json";

/// The cases of the plan.
const CASES: &str = "cases.jsonl";

/// What a folder may hold before its plan is complete.
const OURS: [&str; 6] = [PLAN, CASES, "checks", "records", "cases", "work"];

/// Most cases whose records share a file.
const RUN_OF_CASES: usize = 512;

/// Number of files into which the records of a small sweep are divided, so that shards can share
/// it.
const PIECES: usize = 4096;

/// The folder of a sweep.
#[derive(Clone, Debug)]
pub struct SweepFolder {
    path: PathBuf,
}

/// A fault of the file system.
fn io(action: &str, path: &Path, e: std::io::Error) -> Box<Diagnostic> {
    let code = match e.kind() {
        std::io::ErrorKind::StorageFull | std::io::ErrorKind::QuotaExceeded => "sweep/disk-full",
        _ => "sweep/io",
    };
    Diagnostic::environment(code, format!("cannot {action} `{}`: {e}", path.display()))
        .file(path)
        .help("what is finished stays; free the disk or the folder and run the same command again")
        .into()
}

/// A word that no other process has, on whatever machine.
pub fn unique() -> String {
    let time = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    let pid = std::process::id();
    let seed = format!("{pid} {} {:?}", time.as_nanos(), std::thread::current().id());
    blake3::hash(seed.as_bytes()).to_hex()[..12].to_string()
}

/// Writes a file aside and renames it.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Box<Diagnostic>> {
    if let Some(parent) = path.parent() {
        fs::create_dir_all(parent).map_err(|e| io("make", parent, e))?;
    }
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    // the name is of this process, so that two at once do not write into one file
    name.push(format!(".{}.part", unique()));
    let part = path.with_file_name(name);
    let written = fs::File::create(&part)
        .and_then(|mut f| f.write_all(bytes))
        .and_then(|()| fs::rename(&part, path));
    written.map_err(|e| {
        let _ = fs::remove_file(&part);
        io("write", path, e)
    })
}

/// Copies a folder with all that is in it.
pub fn copy_folder(from: &Path, to: &Path) -> Result<(), Box<Diagnostic>> {
    fs::create_dir_all(to).map_err(|e| io("make", to, e))?;
    for entry in fs::read_dir(from).map_err(|e| io("read", from, e))? {
        let entry = entry.map_err(|e| io("read", from, e))?;
        let (source, target) = (entry.path(), to.join(entry.file_name()));
        if source.is_dir() {
            copy_folder(&source, &target)?;
        } else {
            fs::copy(&source, &target).map_err(|e| io("write", &target, e))?;
        }
    }
    Ok(())
}

/// Hash of a text.
fn hash(text: &str) -> String {
    blake3::hash(text.as_bytes()).to_hex().to_string()
}

/// Values as JSON, one a line.
fn lines<T: Serialize>(values: &[T]) -> Result<String, Box<Diagnostic>> {
    let mut out = String::new();
    for v in values {
        let line = serde_json::to_string(v).map_err(|e| {
            Diagnostic::environment("sweep/write", format!("a record cannot be written: {e}"))
        })?;
        out.push_str(&line);
        out.push('\n');
    }
    Ok(out)
}

/// Reads values of JSON lines.
fn parse_lines<T: DeserializeOwned>(text: &str, file: &Path) -> Result<Vec<T>, Box<Diagnostic>> {
    let lines = text.lines().enumerate().filter(|(_, l)| !l.is_empty());
    lines
        .map(|(i, line)| {
            serde_json::from_str(line).map_err(|e| {
                Diagnostic::input("sweep/damaged", format!("the file is damaged: {e}"))
                    .file(file)
                    .at(i + 1, 1)
                    .help("remove the file and run again: what it held is computed anew")
                    .into()
            })
        })
        .collect()
}

impl SweepFolder {
    /// The folder at a path, which may be absent.
    pub fn at(path: &Path) -> Self {
        Self { path: path.into() }
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a plan. A folder with other content is refused, as is the folder of another sweep.
    pub fn write_plan(&self, plan: &Plan) -> Result<(), Diagnostics> {
        let ours = |name: &str| {
            OURS.contains(&name) || name.ends_with(".part") || name.starts_with("slurm-")
        };
        let holds = fs::read_dir(&self.path).is_ok_and(|entries| {
            entries.flatten().any(|e| !ours(&e.file_name().to_string_lossy()))
        });
        let planned = self.path.join(PLAN).is_file();
        if self.path.is_file() || (holds && !planned) {
            let message = format!(
                "`{}` exists and is not the folder of a sweep; it was left as it is",
                self.path.display()
            );
            let d = Diagnostic::input("sweep/folder", message).file(&self.path);
            return Err(d.help("choose another folder with -o, or move this one away").into());
        }
        // a plan that cannot be read is replaced; what is finished is known by its content
        if let (true, Ok(header)) = (planned, self.header())
            && header.sweep != plan.header.sweep
        {
            let message = format!(
                "`{}` is the folder of another sweep, `{}`",
                self.path.display(),
                header.sweep.display()
            );
            let d = Diagnostic::input("sweep/other-sweep", message).file(&self.path);
            return Err(d.help("choose another folder with -o").into());
        }
        let cases = lines(&plan.cases)?;
        write_whole(&self.path.join(CASES), cases.as_bytes())?;
        let header = Header { cases: hash(&cases), ..plan.header.clone() };
        let text = serde_json::to_string_pretty(&header).map_err(|e| {
            Diagnostic::environment("sweep/write", format!("the plan cannot be written: {e}"))
        })?;
        write_whole(&self.path.join(PLAN), text.as_bytes())?;
        Ok(())
    }

    fn header(&self) -> Result<Header, Box<Diagnostic>> {
        let file = self.path.join(PLAN);
        let text = fs::read_to_string(&file).map_err(|e| {
            let message = format!("`{}` is not the folder of a sweep: {e}", self.path.display());
            Diagnostic::input("sweep/no-plan", message)
                .file(&file)
                .help("`bracket batch plan SWEEP.yaml -o DIR` makes one")
        })?;
        let header: Header = serde_json::from_str(&text).map_err(|e| {
            Diagnostic::input("sweep/damaged", format!("the plan cannot be read: {e}"))
                .file(&file)
                .help("plan the sweep again; finished cases stay")
        })?;
        if header.schema != SCHEMA {
            let message = format!("the plan has schema {}, this program {SCHEMA}", header.schema);
            return Err(Diagnostic::input("sweep/schema", message)
                .file(&file)
                .help("plan the sweep again with this version")
                .into());
        }
        Ok(header)
    }

    /// Reads the plan.
    pub fn plan(&self) -> Result<Plan, Diagnostics> {
        let header = self.header()?;
        let file = self.path.join(CASES);
        let text = fs::read_to_string(&file).map_err(|e| io("read", &file, e))?;
        if hash(&text) != header.cases {
            let message =
                "the cases are not those of the plan: planning was cut off, or is under way";
            let d = Diagnostic::input("sweep/torn", message).file(&file);
            return Err(d.help("plan the sweep again; finished cases stay").into());
        }
        let cases: Vec<Case> = parse_lines(&text, &file)?;
        Ok(Plan { header, cases, remarks: Vec::new() })
    }

    /// The runs of cases whose records share a file.
    pub fn runs<'a>(&self, cases: &'a [Case]) -> Vec<&'a [Case]> {
        let length = cases.len().div_ceil(PIECES).clamp(1, RUN_OF_CASES);
        cases.chunks(length).collect()
    }

    /// The file with the records of a run of cases.
    fn checks_file(&self, run: &[Case]) -> PathBuf {
        let mut hash = blake3::Hasher::new();
        run.iter().for_each(|c| {
            hash.update(c.key.as_bytes());
        });
        let name = format!("{}.jsonl", &hash.finalize().to_hex()[..32]);
        self.path.join("checks").join(name)
    }

    /// The records of the checks of a run of cases; `None` if it is not finished.
    pub fn checked(&self, run: &[Case]) -> Result<Option<Vec<Record>>, Box<Diagnostic>> {
        let file = self.checks_file(run);
        let Ok(text) = fs::read_to_string(&file) else { return Ok(None) };
        let records: Vec<Record> = parse_lines(&text, &file)?;
        let whole =
            records.len() == run.len() && records.iter().zip(run).all(|(r, c)| r.key == c.key);
        Ok(whole.then_some(records))
    }

    /// The records of the checks of all cases; `None` where a run is not finished.
    pub fn all_checked(&self, cases: &[Case]) -> Result<Vec<Option<Record>>, Box<Diagnostic>> {
        let mut out = Vec::with_capacity(cases.len());
        for run in self.runs(cases) {
            match self.checked(run)? {
                Some(records) => out.extend(records.into_iter().map(Some)),
                None => out.extend(run.iter().map(|_| None)),
            }
        }
        Ok(out)
    }

    /// Writes the records of the checks of a run of cases.
    pub fn write_checked(&self, run: &[Case], records: &[Record]) -> Result<(), Box<Diagnostic>> {
        write_whole(&self.checks_file(run), lines(records)?.as_bytes())
    }

    /// The record of a case with finite elements; `None` if it is not finished.
    pub fn analysed(&self, key: &str) -> Result<Option<Record>, Box<Diagnostic>> {
        let file = self.path.join("records").join(format!("{key}.json"));
        let Ok(text) = fs::read_to_string(&file) else { return Ok(None) };
        Ok(parse_lines(&text, &file)?.into_iter().next())
    }

    /// Writes the record of a case with finite elements.
    pub fn write_analysed(&self, record: &Record) -> Result<(), Box<Diagnostic>> {
        let file = self.path.join("records").join(format!("{}.json", record.key));
        // equal joints in two shards: a result stays, whatever the other process met
        if !record.result && self.analysed(&record.key)?.is_some_and(|r| r.result) {
            return Ok(());
        }
        write_whole(&file, lines(std::slice::from_ref(record))?.as_bytes())
    }

    /// The result folder of a case with finite elements.
    pub fn case_folder(&self, key: &str) -> PathBuf {
        self.path.join("cases").join(key)
    }
}
