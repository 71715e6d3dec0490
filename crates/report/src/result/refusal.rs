//! The reason why a program was not started, in words.

use bracket_base::math::figures::{Rounding, significant};
use bracket_engine::analysis::memory::{Limit, Room};
use bracket_engine::analysis::program_outcome::InsufficientMemory;

/// Bytes in GiB with three digits, rounded to the safe side.
pub(crate) fn gib(bytes: u64, rounding: Rounding) -> String {
    format!("{} GiB", significant(bytes as f64 / f64::from(1u32 << 30), 3, rounding))
}

/// The available memory, and what limits it.
pub(crate) fn room_words(room: &Room) -> String {
    let bytes = gib(room.bytes, Rounding::Down);
    match room.limit {
        Limit::Machine => format!("{bytes} are available"),
        Limit::Asked(all) => {
            format!(
                "{bytes} are left of the {} that --memory-limit allows",
                gib(all, Rounding::Nearest)
            )
        }
    }
}

/// Reason why a program was not started: `needs 14.2 GiB more memory, 8.1 GiB are available`.
pub fn refusal_words(refusal: &InsufficientMemory) -> String {
    format!(
        "needs {} more memory, {}",
        gib(refusal.needed, Rounding::Up),
        room_words(&refusal.room)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const GIB: u64 = 1 << 30;

    /// Needed memory is rounded up, available memory down: a refusal never reads as if the program
    /// fitted.
    #[test]
    fn a_refusal_never_reads_as_if_it_fitted() {
        for limit in [Limit::Machine, Limit::Asked(8 * GIB)] {
            let text = refusal_words(&InsufficientMemory {
                needed: GIB + 1,
                room: Room { bytes: GIB - 1, limit },
            });
            assert!(text.starts_with("needs 1.01 GiB more memory, 0.999 GiB are"), "{text}");
            assert_eq!(
                text.contains("of the 8.00 GiB that --memory-limit allows"),
                limit != Limit::Machine,
                "{text}"
            );
        }
    }
}
