//! A job array for Slurm: every task runs a shard of the sweep, a last job merges.

use super::sweep_folder::SweepFolder;
use bracket_base::diag::{Diagnostic, Diagnostics};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Work of a task \[s\]: long against the start of a task, short against a day's queue.
const TASK: f64 = 3600.0;

/// Most tasks of an array: the usual limit of controllers (`MaxArraySize`).
const MOST: usize = 1000;

/// Time asked for over the forecast.
const MARGIN: f64 = 2.0;

/// What a task of the array needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// Number of tasks.
    pub tasks: usize,
    /// Processors of a task.
    pub processors: u32,
    /// Memory of a task \[MiB\].
    pub memory: u64,
    /// Wall time of a task \[min\].
    pub minutes: u64,
    /// Folder of results that several sweeps share.
    pub cache: Option<PathBuf>,
}

/// Memory of a task beside that of its case \[MiB\]: the process that starts the cases.
const BESIDE: u64 = 512;

impl Array {
    /// The array for cases of these times \[s\]; `longest`: wall time after which a case is ended
    /// \[s\].
    pub fn new(
        seconds: &[f64],
        longest: f64,
        tasks: Option<usize>,
        memory: u64,
        threads: u32,
    ) -> Self {
        let total: f64 = seconds.iter().sum();
        let fit = ((total / TASK).ceil() as usize).clamp(1, MOST);
        let tasks = tasks.unwrap_or(fit).clamp(1, seconds.len().max(1));
        // no task is shorter than its longest part
        let each = seconds.iter().copied().fold(total / tasks as f64, f64::max);
        let minutes = ((MARGIN * each + longest) / 60.0).ceil().max(5.0) as u64;
        let memory = (memory >> 20) + BESIDE;
        Self { tasks, processors: threads, memory, minutes, cache: None }
    }

    /// The script for `sbatch`.
    pub fn script(&self, program: &Path, folder: &Path) -> String {
        let Self { tasks, processors, memory, minutes, .. } = self;
        let cache = self.cache.as_deref().map(|c| format!(" --cache {}", quoted(c)));
        let cache = cache.unwrap_or_default();
        let (program, dir) = (quoted(program), quoted(folder));
        let name = folder.file_name().unwrap_or_default().to_string_lossy();
        let name: String =
            name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        format!(
            "#!/bin/sh\n\
             #SBATCH --job-name=bracket_{name}\n\
             #SBATCH --array=1-{tasks}\n\
             #SBATCH --cpus-per-task={processors}\n\
             #SBATCH --mem={memory}M\n\
             #SBATCH --time={minutes}\n\
             #SBATCH --requeue\n\
             #SBATCH --open-mode=append\n\
             #SBATCH --signal=B:TERM@60\n\
             # a task that is requeued continues: finished cases stay\n\
             {program} batch run {dir} --shard auto/{tasks} --jobs 1 --threads \
             {processors}{cache} &\n\
             task=$!\n\
             trap 'kill -TERM $task' TERM\n\
             wait $task || wait $task\n"
        )
    }

    /// The script of the job that merges after the array.
    pub fn merge_script(program: &Path, folder: &Path) -> String {
        let (program, dir) = (quoted(program), quoted(folder));
        format!(
            "#!/bin/sh\n\
             #SBATCH --job-name=bracket_merge\n\
             #SBATCH --time=60\n\
             {program} batch merge {dir}\n"
        )
    }
}

/// A path as a word of the shell.
fn quoted(path: &Path) -> String {
    format!("'{}'", path.to_string_lossy().replace('\'', "'\\''"))
}

/// Hands a script to `sbatch`; returns the number of the job.
fn sbatch(script: &str, options: &[String], folder: &Path) -> Result<String, Box<Diagnostic>> {
    let fault = |why: String| {
        let message = format!("sbatch did not take the job: {why}");
        let help = "`bracket batch slurm DIR` without --submit prints the script";
        Box::new(Diagnostic::environment("sweep/sbatch", message).help(help))
    };
    let mut child = Command::new("sbatch")
        .arg("--parsable")
        .args(options)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| fault(e.to_string()))?;
    if let Some(mut input) = child.stdin.take() {
        input.write_all(script.as_bytes()).map_err(|e| fault(e.to_string()))?;
    }
    let out = child.wait_with_output().map_err(|e| fault(e.to_string()))?;
    if !out.status.success() {
        return Err(fault(String::from_utf8_lossy(&out.stderr).trim().to_string()));
    }
    let text = String::from_utf8_lossy(&out.stdout);
    Ok(text.trim().split(';').next().unwrap_or_default().to_string())
}

/// Submits the array and the job that merges after it, whatever becomes of the tasks. Returns the
/// numbers of both jobs.
pub fn submit(
    array: &Array,
    program: &Path,
    folder: &SweepFolder,
) -> Result<[String; 2], Diagnostics> {
    let dir = std::path::absolute(folder.path()).unwrap_or_else(|_| folder.path().to_path_buf());
    let first = sbatch(&array.script(program, &dir), &[], &dir)?;
    let after = [format!("--dependency=afterany:{first}")];
    let last = sbatch(&Array::merge_script(program, &dir), &after, &dir)?;
    Ok([first, last])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tasks_follow_the_forecast() {
        let array = |n: usize, s: f64| Array::new(&vec![s; n], 600.0, None, 4 << 30, 2);
        // 40 cases of 10 minutes are 6.7 hours: seven tasks of an hour
        assert_eq!(array(40, 600.0).tasks, 7);
        assert_eq!(array(3, 1.0).tasks, 1);
        assert_eq!(array(100_000, 600.0).tasks, MOST);
        assert!(array(40, 600.0).minutes >= 2 * 57 + 10);
        assert_eq!(Array::new(&[1.0; 3], 60.0, Some(20), 1 << 30, 1).tasks, 3);
    }

    #[test]
    fn paths_with_blanks_and_quotes() {
        let array = Array::new(&[600.0; 12], 600.0, Some(4), 4 << 30, 2);
        let script = array.script(Path::new("/opt/bracket"), Path::new("/data/a b/it's"));
        assert!(script.contains("batch run '/data/a b/it'\\''s' --shard auto/4"), "{script}");
        assert!(script.contains("--array=1-4") && script.contains("--mem=4608M"), "{script}");
    }
}
