//! What a solve will cost, told before it starts.

use super::sparse::SparseCholesky;
use std::time::Instant;

/// Iterations a forecast reckons with.
const TYPICAL_ITERATIONS: f64 = 20.0;
/// Solves of an iteration, and of one of limit analysis.
const SOLVES: f64 = 4.0;
const LIMIT_SOLVES: f64 = 10.0;
/// What all passes over a row of a yield condition take in an iteration, as operations at the dense
/// rate: 1.3 µs at 40 GFLOP/s, measured on both programs of two joints.
const ROW_WORK: f64 = 5e4;

/// Cost of one solve by the condensed method.
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

    /// Seconds of all iterations, for `flops` per factorisation, `entries` of the factor and `rows`
    /// of yield conditions; in limit analysis directions are corrected and refined more often.
    pub(crate) fn all_iterations(flops: f64, entries: usize, rows: usize, limit: bool) -> f64 {
        let solves = if limit { LIMIT_SOLVES } else { SOLVES };
        TYPICAL_ITERATIONS
            * (Self::iteration(flops, entries, solves) + ROW_WORK * rows as f64 / dense_rate())
    }

    /// One factor and some solves at this machine's measured rate.
    fn iteration(flops: f64, entries: usize, solves: f64) -> f64 {
        // part of the dense rate that sparse factorisations reach, and bytes per second at which
        // solves read the factor twice each: both measured, see benches/README.md
        let (efficiency, reading) = (0.75, 1e10);
        flops / (efficiency * dense_rate()) + solves * 2.0 * 8.0 * entries as f64 / reading
    }
}

/// Time of the pieces a solve is made of.
#[derive(Clone, Copy, Debug)]
pub struct Yardstick {
    /// One factorisation \[s\].
    pub factor: f64,
    /// One solve \[s\].
    pub solve: f64,
}

/// Floating-point operations per second of a dense Cholesky factorisation on one thread of this
/// machine.
pub fn dense_rate() -> f64 {
    static RATE: std::sync::OnceLock<f64> = std::sync::OnceLock::new();
    *RATE.get_or_init(|| {
        let n = 512;
        let mut best = f64::INFINITY;
        for _ in 0..4 {
            let mut a = faer::Mat::<f64>::from_fn(n, n, |i, j| if i == j { n as f64 } else { 1.0 });
            let start = Instant::now();
            super::sparse::dense::cholesky(a.as_mut());
            best = best.min(start.elapsed().as_secs_f64());
        }
        (n as f64).powi(3) / 3.0 / best
    })
}

/// Memory the machine can still give \[bytes\]; `None` where the system does not tell.
///
/// The smaller of what the kernel calls available and what is left of a control group's limit.
pub fn available_memory() -> Option<u64> {
    let info = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = info.lines().find(|l| l.starts_with("MemAvailable:"))?;
    let available = line.split_whitespace().nth(1)?.parse::<u64>().ok()? * 1024;
    let number = |path: &str| std::fs::read_to_string(path).ok()?.trim().parse::<u64>().ok();
    let group = number("/sys/fs/cgroup/memory.max")
        .map(|limit| limit.saturating_sub(number("/sys/fs/cgroup/memory.current").unwrap_or(0)));
    Some(group.map_or(available, |g| g.min(available)))
}
