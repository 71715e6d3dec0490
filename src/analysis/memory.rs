//! Does it fit? The memory a run may take, and which programs start, together or in turn.

use crate::solve::forecast::available_memory;
use std::sync::Arc;

/// What a forecast leaves out: fields, certificates and files after the solve, the allocator's own
/// losses.
const RESERVE: f64 = 0.05;

/// At least so much is left to the machine \[bytes\]: below that the kernel starts to throw out
/// programs and files in use, and everything on the machine, this run included, slows down or dies.
const LEAST_RESERVE: u64 = 256 << 20;

/// Who sets the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// What the machine (or its container) can still give.
    Machine,
    /// What the user allows this process in all \[bytes\].
    Asked(u64),
}

/// Memory that solves may still take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    /// How much \[bytes\], the reserve taken off.
    pub bytes: u64,
    /// Who sets it.
    pub limit: Limit,
}

/// Asked for the room whenever solves are about to start; `None`: nobody can tell.
pub type RoomSource = Arc<dyn Fn() -> Option<Room> + Send + Sync>;

/// The room there is now; `asked`: what the process may use in all \[bytes\]. `None` where neither
/// the system nor the user tells.
pub fn room(asked: Option<u64>) -> Option<Room> {
    room_of(available_memory(), asked, resident())
}

fn room_of(available: Option<u64>, asked: Option<u64>, resident: u64) -> Option<Room> {
    let part = |bytes: u64| (RESERVE * bytes as f64) as u64;
    let machine = available.map(|a| Room {
        bytes: a.saturating_sub(part(a).max(LEAST_RESERVE)),
        limit: Limit::Machine,
    });
    // breaking a wish kills nobody: the part that forecasts leave out is reserve enough
    let asked = asked.map(|l| Room {
        bytes: l.saturating_sub(part(l)).saturating_sub(resident),
        limit: Limit::Asked(l),
    });
    match (machine, asked) {
        (Some(m), Some(a)) => Some(if a.bytes < m.bytes { a } else { m }),
        (m, a) => m.or(a),
    }
}

/// Which programs start, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Whether each program may start.
    pub starts: Vec<bool>,
    /// All that start fit side by side.
    pub together: bool,
}

/// Plans programs that need so much memory each \[bytes\] for a room \[bytes\]; what fits alone
/// starts.
pub fn plan(needs: &[u64], room: u64) -> Plan {
    let starts: Vec<bool> = needs.iter().map(|n| *n <= room).collect();
    let sum = needs
        .iter()
        .zip(&starts)
        .filter(|(_, s)| **s)
        .fold(0u64, |sum, (n, _)| sum.saturating_add(*n));
    Plan { starts, together: sum <= room }
}

/// A line of `/proc/self/status` \[bytes\]; `None` where the system has no such file.
fn own(key: &str) -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let kib: u64 =
        status.lines().find(|l| l.starts_with(key))?.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib * 1024)
}

/// Memory this process holds \[bytes\]; 0 where the system does not tell.
fn resident() -> u64 {
    own("VmRSS:").unwrap_or(0)
}

/// Makes [`peak_memory_mib`] count from now on, where the system can (Linux).
pub fn forget_peak() {
    // where it cannot, the peak stays that of the whole process
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}

/// Peak resident memory of this process so far \[MiB\]; `None` where the system does not tell.
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
        // one alone needs no turn
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
        // what the process holds already counts against the user's limit, not against what the
        // machine has left
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
    fn the_system_tells_what_this_process_holds() {
        let ballast = vec![1u8; 64 << 20];
        assert!(resident() > ballast.iter().map(|b| u64::from(*b)).sum());
        assert!(peak_memory_mib() > Some(64));
    }
}
