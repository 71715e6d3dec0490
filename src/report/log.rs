//! What a run says while it works: lines on the terminal, a spinner where there is one to look at, and `log.txt`.

use indicatif::{ProgressBar, ProgressDrawTarget};
use std::io::IsTerminal;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Collects the log of a run and shows it on standard error.
#[derive(Debug)]
pub struct Log {
    start: Instant,
    quiet: bool,
    lines: Mutex<String>,
    bar: ProgressBar,
}

impl Log {
    /// A log that shows its lines on standard error unless `quiet`, with a spinner only on a terminal.
    pub fn new(quiet: bool) -> Self {
        let bar = if quiet || !std::io::stderr().is_terminal() {
            ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden())
        } else {
            let bar = ProgressBar::new_spinner();
            bar.enable_steady_tick(Duration::from_millis(120));
            bar
        };
        Self { start: Instant::now(), quiet, lines: Mutex::default(), bar }
    }

    /// Notes a line that is done with: it is kept, and shown unless quiet.
    pub fn line(&self, text: impl AsRef<str>) {
        self.keep(text.as_ref());
        if !self.quiet {
            self.bar.suspend(|| eprintln!("{}", text.as_ref()));
        }
    }

    /// Notes a line that only `log.txt` wants.
    pub fn detail(&self, text: impl AsRef<str>) {
        self.keep(text.as_ref());
    }

    /// Says what is being done now; shown beside the spinner until the next stage.
    pub fn stage(&self, text: impl Into<String>) {
        let text = text.into();
        self.keep(&text);
        self.bar.set_message(text);
    }

    /// Seconds since the run began.
    pub fn seconds(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// The text of `log.txt`: seconds since the start before each line.
    pub fn text(&self) -> String {
        self.lines.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn keep(&self, text: &str) {
        let seconds = self.start.elapsed().as_secs_f64();
        let mut lines = self.lines.lock().unwrap_or_else(PoisonError::into_inner);
        for line in text.lines() {
            lines.push_str(&format!("[{seconds:9.3} s] {line}\n"));
        }
    }
}

impl Drop for Log {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_every_line_in_order_with_its_time() {
        let log = Log::new(true);
        log.stage("mesh");
        log.detail("9 000 tets\nsecond line");
        log.line("done");
        let text = log.text();
        let said: Vec<_> = text.lines().filter_map(|l| l.split_once(" s] ")).map(|(_, t)| t).collect();
        assert_eq!(said, ["mesh", "9 000 tets", "second line", "done"]);
        assert!(text.starts_with('['));
    }
}
