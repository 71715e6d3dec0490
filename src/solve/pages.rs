//! What the allocator does with the vectors of an iteration, which are made anew in each.
//!
//! glibc hands every large vector back to the system and asks for it again: the system clears each
//! page, a sixth of the processor time of a limit analysis. Vectors up to the size below stay with
//! the process; the factor, which is larger and lives long, still comes in pages of its own.

/// Vectors below this size are kept \[bytes\].
#[cfg(all(target_os = "linux", target_env = "gnu"))]
const KEPT: libc::c_int = 128 << 20;

/// Keeps the memory of vectors that are done with, for the next ones.
pub fn keep() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    {
        static ONCE: std::sync::Once = std::sync::Once::new();
        // SAFETY: the calls set parameters of the allocator; memory handed out before stays valid
        ONCE.call_once(|| unsafe {
            libc::mallopt(libc::M_MMAP_THRESHOLD, KEPT);
            libc::mallopt(libc::M_TRIM_THRESHOLD, libc::c_int::MAX);
        });
    }
}

/// Hands what is kept back to the system: the next program asks how much memory there is.
pub fn give_back() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    // SAFETY: releases memory that nobody holds
    unsafe {
        libc::malloc_trim(0);
    }
}
