//! Forecast of the cost of a solve.

use super::sparse::SparseCholesky;
use super::sparse::dense::dense_rate;

/// Number of iterations that a forecast assumes.
const TYPICAL_ITERATIONS: f64 = 20.0;
/// The same with contact and yield conditions under given loads: 30 to 33 in the kinematic program
/// of a joint at 0.5 to 0.95 of its strength, 50 to 66 in the static one.
const CONTACT_AND_YIELD_ITERATIONS: f64 = 40.0;
/// Number of solves in an iteration.
const SOLVES: f64 = 4.0;
/// Number of solves in an iteration of limit analysis.
const LIMIT_SOLVES: f64 = 8.0;
/// Cost of all passes over one row of a yield condition in an iteration, as operations at the dense
/// rate: 0.5 µs at 40 GFLOP/s, measured on both programs of two joints.
const ROW_WORK: f64 = 2e4;

/// Forecast of one solve by the condensed method.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forecast {
    /// Unknowns that reach the sparse factor.
    pub unknowns: usize,
    /// Nonzeros of the factor.
    pub factor_entries: usize,
    /// Floating-point operations of one factorisation.
    pub factor_flops: f64,
    /// Memory at the peak of the solve, on top of the program itself \[bytes\].
    pub bytes: u64,
    /// Wall time on one thread \[s\], for a typical number of iterations.
    pub seconds: f64,
}

impl Forecast {
    /// Memory \[GiB\].
    pub fn gib(&self) -> f64 {
        self.bytes as f64 / f64::from(1u32 << 30)
    }

    /// Cost of factoring and solving once.
    pub(crate) fn of_factor(factor: &SparseCholesky) -> Self {
        let (entries, flops) = (factor.nonzeros(), factor.flops());
        Self {
            unknowns: factor.unknowns(),
            factor_entries: entries,
            factor_flops: flops,
            bytes: (factor.bytes() + 8 * 6 * factor.unknowns()) as u64,
            seconds: Self::iteration(flops, entries, SOLVES),
        }
    }

    /// Time of all iterations \[s\], for `flops` per factorisation, `entries` of the factor and
    /// so many rows of contact and of yield conditions; limit analysis corrects and refines
    /// directions more often.
    pub(crate) fn all_iterations(
        flops: f64,
        entries: usize,
        [contact, rows]: [usize; 2],
        limit: bool,
    ) -> f64 {
        let solves = if limit { LIMIT_SOLVES } else { SOLVES };
        let iterations = match (limit, contact, rows) {
            (false, 1.., 1..) => CONTACT_AND_YIELD_ITERATIONS,
            _ => TYPICAL_ITERATIONS,
        };
        iterations
            * (Self::iteration(flops, entries, solves) + ROW_WORK * rows as f64 / dense_rate())
    }

    /// One factor and some solves at this machine's measured rate.
    fn iteration(flops: f64, entries: usize, solves: f64) -> f64 {
        // fraction of the dense rate that sparse factorisations reach, and bytes per second at
        // which each solve reads the factor twice: both measured, see benches/README.md
        let (efficiency, reading) = (0.75, 1e10);
        flops / (efficiency * dense_rate()) + solves * 2.0 * 8.0 * entries as f64 / reading
    }
}

/// Measured times of the steps of a solve.
#[derive(Clone, Copy, Debug)]
pub struct Yardstick {
    /// One factorisation \[s\].
    pub factor: f64,
    /// One solve \[s\].
    pub solve: f64,
}

/// Available memory of the machine \[bytes\]; `None` where the system does not report it.
///
/// This is the smaller of the kernel's available memory and the rest of a control group's limit.
pub fn available_memory() -> Option<u64> {
    let info = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = info.lines().find(|l| l.starts_with("MemAvailable:"))?;
    let available = line.split_whitespace().nth(1)?.parse::<u64>().ok()? * 1024;
    let number = |path: &str| std::fs::read_to_string(path).ok()?.trim().parse::<u64>().ok();
    let group = number("/sys/fs/cgroup/memory.max")
        .map(|limit| limit.saturating_sub(number("/sys/fs/cgroup/memory.current").unwrap_or(0)));
    Some(group.map_or(available, |g| g.min(available)))
}
