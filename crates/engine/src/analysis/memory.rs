//! Memory available for solves, and which programs start: together or one after the other.

use crate::solve::forecast::available_memory;
use std::sync::Arc;

/// Fraction of the memory kept for what a forecast omits: fields, certificates and files after the
/// solve, losses of the allocator.
const RESERVE: f64 = 0.05;

/// Memory always left to the machine \[bytes\]. Below it the kernel evicts programs and files in
/// use, and everything on the machine, including this run, slows down or is killed.
const LEAST_RESERVE: u64 = 256 << 20;

/// Source of the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// The memory that the machine (or its container) still has.
    Machine,
    /// The limit of the user for the whole process \[bytes\].
    Asked(u64),
}

/// Memory still available for solves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    /// Size \[bytes\], without the reserve.
    pub bytes: u64,
    /// Source of the limit.
    pub limit: Limit,
}

/// Callback that returns the available memory before solves start; `None`: unknown.
pub type RoomSource = Arc<dyn Fn() -> Option<Room> + Send + Sync>;

/// The memory available now; `asked`: the limit of the user for the whole process \[bytes\]. `None`
/// where neither the system nor the user gives a number.
pub fn room(asked: Option<u64>) -> Option<Room> {
    room_of(available_memory(), asked, resident())
}

fn room_of(available: Option<u64>, asked: Option<u64>, resident: u64) -> Option<Room> {
    let part = |bytes: u64| (RESERVE * bytes as f64) as u64;
    let machine = available.map(|a| Room {
        bytes: a.saturating_sub(part(a).max(LEAST_RESERVE)),
        limit: Limit::Machine,
    });
    // exceeding the limit of the user kills no process: the fraction for omitted memory is enough
    let asked = asked.map(|l| Room {
        bytes: l.saturating_sub(part(l)).saturating_sub(resident),
        limit: Limit::Asked(l),
    });
    match (machine, asked) {
        (Some(m), Some(a)) => Some(if a.bytes < m.bytes { a } else { m }),
        (m, a) => m.or(a),
    }
}

/// The programs that start, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Whether each program may start.
    pub starts: Vec<bool>,
    /// All programs that start fit side by side.
    pub together: bool,
}

/// Plans programs with the given memory needs \[bytes\] for an available memory `room` \[bytes\].
/// Each program that fits alone starts.
pub fn plan(needs: &[u64], room: u64) -> Plan {
    let starts: Vec<bool> = needs.iter().map(|n| *n <= room).collect();
    let sum = needs
        .iter()
        .zip(&starts)
        .filter(|(_, s)| **s)
        .fold(0u64, |sum, (n, _)| sum.saturating_add(*n));
    Plan { starts, together: sum <= room }
}

/// An entry of the status of this process \[bytes\]; `None` where the system does not report it.
fn own(key: &str) -> Option<u64> {
    status_of("self", key)
}

/// An entry of `/proc/PROCESS/status` \[bytes\]; `None` where the system has no such file.
fn status_of(process: &str, key: &str) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let kib: u64 =
        status.lines().find(|l| l.starts_with(key))?.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib * 1024)
}

/// Resident memory of this process \[bytes\]; 0 where the system does not report it.
fn resident() -> u64 {
    own("VmRSS:").unwrap_or(0)
}

/// Resident memory of another process \[bytes\]; 0 where the system does not report it.
pub fn resident_of(pid: u32) -> u64 {
    status_of(&pid.to_string(), "VmRSS:").unwrap_or(0)
}

/// Restarts the measurement of [`peak_memory_mib`], where the system can (Linux).
pub fn forget_peak() {
    // where this fails, the peak stays that of the whole process
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}

/// Peak resident memory of this process so far \[MiB\]; `None` where the system does not report it.
pub fn peak_memory_mib() -> Option<u64> {
    own("VmHWM:").map(|b| b >> 20)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GIB: u64 = 1 << 30;

    #[test]
    fn what_fits_together_in_turn_alone_and_not_at_all() {
        let of = |a, b, room| plan(&[a, b], room);
        assert_eq!(of(3, 4, 7), Plan { starts: vec![true, true], together: true });
        assert_eq!(of(3, 4, 6), Plan { starts: vec![true, true], together: false });
        assert_eq!(of(3, 4, 4), Plan { starts: vec![true, true], together: false });
        // a single program waits for no other
        assert_eq!(of(3, 4, 3), Plan { starts: vec![true, false], together: true });
        assert_eq!(of(4, 3, 3), Plan { starts: vec![false, true], together: true });
        assert_eq!(of(3, 4, 2), Plan { starts: vec![false, false], together: true });
        assert_eq!(
            plan(&[u64::MAX, u64::MAX], u64::MAX),
            Plan { starts: vec![true, true], together: true }
        );
        assert_eq!(plan(&[], 0), Plan { starts: vec![], together: true });
    }

    #[test]
    fn the_tighter_limit_rules_and_each_keeps_its_reserve() {
        let machine = |bytes| Some(Room { bytes, limit: Limit::Machine });
        let asked = |bytes, limit| Some(Room { bytes, limit: Limit::Asked(limit) });
        assert_eq!(room_of(Some(GIB), None, 0), machine(GIB - (256 << 20)));
        assert_eq!(room_of(Some(100 * GIB), None, 0), machine(95 * GIB));
        assert_eq!(room_of(Some(100 << 20), None, 0), machine(0));
        // the resident memory counts against the limit of the user, not against the memory that the
        // machine still has
        assert_eq!(room_of(Some(100 * GIB), Some(20 * GIB), 4 * GIB), asked(15 * GIB, 20 * GIB));
        assert_eq!(
            room_of(Some(10 * GIB), Some(20 * GIB), 4 * GIB),
            machine((9.5 * GIB as f64) as u64)
        );
        assert_eq!(room_of(Some(100 * GIB), Some(GIB), 4 * GIB), asked(0, GIB));
        assert_eq!(room_of(None, Some(20 * GIB), 0), asked(19 * GIB, 20 * GIB));
        assert_eq!(room_of(None, None, 5), None);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn the_system_reports_the_resident_memory() {
        let ballast = vec![1u8; 64 << 20];
        assert!(resident() > ballast.iter().map(|b| u64::from(*b)).sum());
        assert!(peak_memory_mib() > Some(64));
    }
}
