//! The log of a run: lines on standard error, progress bars on a terminal, and `log.txt`.

use crate::console::pace::{Pace, about};
use bracket_base::diag::{in_line, visible};
use bracket_engine::analysis::program::Program;
use bracket_engine::solve::Iteration;
use indicatif::{MultiProgress, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::collections::BTreeMap;
use std::fmt;
use std::io::{IsTerminal, Write};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Length of a program's bar.
const WHOLE: u64 = 1000;

/// Program, bar, time left, iteration.
const TEMPLATE: &str = "{prefix:9} [{bar:8}] {left:>17}  {wide_msg}";

/// Interval at which a bar is redrawn.
const TICK: Duration = Duration::from_millis(250);

/// Collects the log of a run and shows it on standard error.
#[derive(Debug)]
pub struct Log {
    start: Instant,
    quiet: bool,
    /// Gets every line.
    listener: Option<Listener>,
    lines: Mutex<String>,
    bars: MultiProgress,
    /// The current step.
    stage: ProgressBar,
    programs: Mutex<BTreeMap<Program, Bar>>,
    /// Whether there is a terminal to draw on.
    drawn: bool,
}

/// A function that gets the lines of a log.
struct Listener(Box<dyn Fn(&str) + Send + Sync>);

impl fmt::Debug for Listener {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Listener")
    }
}

/// A program's bar and its pace.
#[derive(Debug)]
struct Bar {
    bar: ProgressBar,
    pace: Arc<Mutex<Timed>>,
}

/// A pace and the time of its last update.
#[derive(Debug)]
struct Timed {
    pace: Pace,
    updated: Instant,
}

fn held<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Log {
    /// A log that shows its lines on standard error unless `quiet`. Bars are shown only on a
    /// terminal.
    pub fn new(quiet: bool) -> Self {
        let drawn = !quiet && std::io::stderr().is_terminal();
        let target =
            if drawn { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bars = MultiProgress::with_draw_target(target);
        let stage = bars.add(ProgressBar::new_spinner());
        if drawn {
            stage.enable_steady_tick(TICK);
        }
        Self {
            start: Instant::now(),
            quiet,
            listener: None,
            lines: Mutex::default(),
            bars,
            stage,
            programs: Mutex::default(),
            drawn,
        }
    }

    /// A log that hands every line to `listener` and shows nothing.
    pub fn to(listener: impl Fn(&str) + Send + Sync + 'static) -> Self {
        let mut log = Self::new(true);
        log.listener = Some(Listener(Box::new(listener)));
        log
    }

    /// Logs a line; shows it unless quiet.
    pub fn line(&self, text: impl AsRef<str>) {
        // a line end within a name must not look like a line of the program
        let line = in_line(text.as_ref());
        self.keep(&line);
        self.say(line);
    }

    /// Shows a line that is in `log.txt` already.
    pub fn say(&self, text: impl AsRef<str>) {
        if !self.quiet {
            // the run continues if the terminal is gone
            self.bars.suspend(|| _ = writeln!(std::io::stderr(), "{}", visible(text.as_ref())));
        }
    }

    /// Logs a line for `log.txt` only.
    pub fn detail(&self, text: impl AsRef<str>) {
        self.keep(text.as_ref());
    }

    /// Logs the current step and shows it beside the spinner until the next step.
    pub fn stage(&self, text: impl Into<String>) {
        let text = text.into();
        self.keep(&text);
        self.stage.set_message(visible(&text));
    }

    /// Marks the begin of a program's solve. On a terminal the solve gets a bar.
    pub fn begin(&self, program: Program, pace: Pace) {
        if !self.drawn {
            return;
        }
        let pace = Arc::new(Mutex::new(Timed { pace, updated: Instant::now() }));
        let bar = self.bars.add(ProgressBar::new(WHOLE));
        bar.set_style(style(pace.clone()));
        bar.set_prefix(program.name());
        bar.enable_steady_tick(TICK);
        if let Some(old) = held(&self.programs).insert(program, Bar { bar, pace }) {
            old.bar.finish_and_clear();
        }
    }

    /// Shows the next iteration of a program, with the words beside its bar.
    pub fn iteration(&self, program: Program, i: &Iteration, words: &str) {
        let programs = held(&self.programs);
        let Some(Bar { bar, pace }) = programs.get(&program) else { return };
        let mut timed = held(pace);
        timed.pace.add(i);
        timed.updated = Instant::now();
        let share = timed.pace.share();
        // drawing locks the pace again
        drop(timed);
        bar.set_position((share * WHOLE as f64) as u64);
        bar.set_message(words.to_string());
    }

    /// Marks the end of a program's solve and removes its bar.
    pub fn end(&self, program: Program) {
        if let Some(Bar { bar, .. }) = held(&self.programs).remove(&program) {
            bar.finish_and_clear();
        }
    }

    /// Seconds since the run began.
    pub fn seconds(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// The text of `log.txt`: each line begins with the seconds since the start.
    pub fn text(&self) -> String {
        held(&self.lines).clone()
    }

    fn keep(&self, text: &str) {
        let seconds = self.start.elapsed().as_secs_f64();
        let mut lines = held(&self.lines);
        for line in visible(text).lines() {
            lines.push_str(&format!("[{seconds:9.3} s] {line}\n"));
            if let Some(Listener(listener)) = &self.listener {
                listener(line);
            }
        }
    }
}

/// The bar of a program. The time left counts down between iterations.
fn style(pace: Arc<Mutex<Timed>>) -> ProgressStyle {
    let left = move |_: &ProgressState, out: &mut dyn fmt::Write| {
        let timed = held(&pace);
        let left =
            timed.pace.left().map(|left| (left - timed.updated.elapsed().as_secs_f64()).max(1.0));
        let _ = out.write_str(&left.map_or(String::new(), |left| format!("{} left", about(left))));
    };
    ProgressStyle::with_template(TEMPLATE)
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .with_key("left", left)
}

impl Drop for Log {
    fn drop(&mut self) {
        held(&self.programs).values().for_each(|b| b.bar.finish_and_clear());
        self.stage.finish_and_clear();
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
        let said: Vec<_> =
            text.lines().filter_map(|l| l.split_once(" s] ")).map(|(_, t)| t).collect();
        assert_eq!(said, ["mesh", "9 000 tets", "second line", "done"]);
        assert!(text.starts_with('['));
    }

    #[test]
    fn the_bar_s_template_is_sound() {
        assert!(ProgressStyle::with_template(TEMPLATE).is_ok());
    }
}
