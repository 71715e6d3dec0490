//! Ctrl-C and the termination signals of batch systems. The first signal ends the run in order, the
//! second one at once.
//!
//! The signals are blocked in every thread and awaited in one. METIS replaces signal handlers by
//! its own while it orders; blocked signals never reach a handler.

use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus};
use bracket_report::console::log::Log;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};

/// Environment variable with the number of the process that started this one, which ends when that
/// one dies: a batch sets it for its cases.
pub const END_WITH_PARENT: &str = "BRACKET_END_WITH_PARENT";

/// Clean-up before the program exits at once, so that it leaves no half-written result.
type LastWords = Box<dyn Fn() + Send>;

/// The user's request to stop.
#[derive(Clone, Default)]
pub struct Interrupt {
    flag: Arc<AtomicBool>,
    work: Arc<Mutex<Option<Work>>>,
}

/// Work in progress.
struct Work {
    /// A weak reference, because dropping the log clears the terminal at the end of the run.
    log: Weak<Log>,
    /// Effect of the first signal, for the log; `None`: it ends the program at once.
    now: Option<&'static str>,
    last_words: LastWords,
}

impl Interrupt {
    /// Watches for signals from now on. Call it before any other thread starts: threads inherit the
    /// blocked signals.
    ///
    /// Until work begins, a signal ends the program at once.
    pub fn watch() -> Result<Self, Diagnostics> {
        let interrupt = Self::default();
        interrupt.listen()?;
        Ok(interrupt)
    }

    /// Marks the begin of the work. From then on the first signal only requests the end of the work
    /// and logs its effect (`now`); the second one ends the program after `last_words`.
    pub fn begin(&self, log: &Arc<Log>, now: &'static str, last_words: impl Fn() + Send + 'static) {
        let now = Some(now);
        let work = Work { log: Arc::downgrade(log), now, last_words: Box::new(last_words) };
        *self.work.lock().unwrap_or_else(PoisonError::into_inner) = Some(work);
    }

    /// Marks the begin of work that a signal ends at once, after `last_words`.
    pub fn begin_short(&self, last_words: impl Fn() + Send + 'static) {
        let work = Work { log: Weak::new(), now: None, last_words: Box::new(last_words) };
        *self.work.lock().unwrap_or_else(PoisonError::into_inner) = Some(work);
    }

    /// Marks the end of a piece of work: until the next one begins, a signal ends the program at
    /// once.
    pub fn pause(&self) {
        *self.work.lock().unwrap_or_else(PoisonError::into_inner) = None;
    }

    /// Set once the user has asked to stop.
    pub fn flag(&self) -> Arc<AtomicBool> {
        self.flag.clone()
    }

    /// True once the user has asked to stop.
    pub fn asked(&self) -> bool {
        self.flag.load(Ordering::Relaxed)
    }

    /// Ends a run that has nothing to write yet if the user has asked to stop.
    pub fn check(&self, doing: &str) -> Result<(), Diagnostics> {
        if !self.asked() {
            return Ok(());
        }
        Err(Diagnostic::undecided(
            "cli/interrupted",
            format!("interrupted while {doing}: nothing was written"),
        )
        .help("run the same command again")
        .into())
    }

    #[cfg(not(unix))]
    fn listen(&self) -> Result<(), Diagnostics> {
        Ok(())
    }

    #[cfg(unix)]
    fn listen(&self) -> Result<(), Diagnostics> {
        use nix::sys::signal::{SigSet, Signal};
        let mut wanted = SigSet::empty();
        wanted.add(Signal::SIGINT);
        wanted.add(Signal::SIGTERM);
        // a run under nohup must outlive the terminal: it ignores the hang-up
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        if ignored(&status) >> (Signal::SIGHUP as i32 - 1) & 1 == 0 {
            wanted.add(Signal::SIGHUP);
        }
        let failed = |e: String| {
            Diagnostic::environment(
                "cli/signals",
                format!("the signals of the system cannot be watched: {e}"),
            )
            .help("run the command from a shell of its own")
        };
        #[cfg(target_os = "linux")]
        if let Ok(parent) = std::env::var(END_WITH_PARENT) {
            let signal = nix::sys::prctl::set_pdeathsig(Signal::SIGTERM);
            signal.map_err(|e| failed(e.to_string()))?;
            // the signal does not come for a process that died before it was asked for
            if nix::unistd::getppid().to_string() != parent {
                std::process::exit(ExitStatus::Undecided.code().into());
            }
        }
        wanted.thread_block().map_err(|e| failed(e.to_string()))?;
        let watcher = self.clone();
        let watch = move || {
            let mut first = None;
            // the wait never fails for a set of real signals
            while wanted.wait().is_ok() {
                watcher.heard(&mut first);
            }
        };
        std::thread::Builder::new()
            .name("signals".into())
            .spawn(watch)
            .map_err(|e| failed(e.to_string()))?;
        Ok(())
    }

    /// Handles a signal. `first` is the time of the first signal.
    #[cfg(unix)]
    fn heard(&self, first: &mut Option<std::time::Instant>) {
        /// Signals within this interval count as one, because `timeout` and some shells send a
        /// signal both to the process and to its group.
        const ECHO: std::time::Duration = std::time::Duration::from_millis(300);
        let work = self.work.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(work) = &*work else {
            end("interrupted: nothing was written\n");
        };
        let Some(now) = work.now else {
            (work.last_words)();
            end("interrupted\n");
        };
        match first {
            None => {
                *first = Some(std::time::Instant::now());
                self.flag.store(true, Ordering::Relaxed);
                if let Some(log) = work.log.upgrade() {
                    log.line(format!("interrupted: {now}; interrupt again to stop at once"));
                }
            }
            Some(at) if at.elapsed() < ECHO => {}
            Some(_) => {
                (work.last_words)();
                end("");
            }
        }
    }
}

/// Ends the program with exit code 3.
#[cfg(unix)]
fn end(words: &str) -> ! {
    // standard error may be closed
    let _ = std::io::Write::write_all(&mut std::io::stderr(), words.as_bytes());
    std::process::exit(ExitStatus::Undecided.code().into())
}

/// The mask of ignored signals in the text of `/proc/self/status`; 0 if it is missing.
#[cfg(unix)]
fn ignored(status: &str) -> u64 {
    let mask = status.lines().find_map(|l| l.strip_prefix("SigIgn:"));
    mask.and_then(|m| u64::from_str_radix(m.trim(), 16).ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(unix)]
    fn the_mask_of_ignored_signals_is_read() {
        use nix::sys::signal::Signal;
        let status = "Name:\tbracket\nSigIgn:\t0000000000001001\nSigCgt:\t0000000000000002\n";
        let mask = ignored(status);
        assert_eq!(
            (mask >> (Signal::SIGHUP as i32 - 1) & 1, mask >> (Signal::SIGINT as i32 - 1) & 1),
            (1, 0)
        );
        assert_eq!(ignored(""), 0);
    }

    #[test]
    fn a_run_without_anything_to_write_ends_with_exit_3() {
        let interrupt = Interrupt::default();
        assert!(interrupt.check("meshing").is_ok() && !interrupt.asked());
        interrupt.flag().store(true, Ordering::Relaxed);
        let e = interrupt.check("meshing").expect_err("interrupted");
        assert_eq!((e.exit_code(), e.first().code), (3, "cli/interrupted"));
        assert!(e.first().message.contains("while meshing"));
    }
}
