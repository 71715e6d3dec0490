//! Allocation of the vectors of an iteration, which each iteration creates anew.
//!
//! glibc returns every large vector to the system and requests it again. The system then clears
//! each page, which took a sixth of the processor time of a limit analysis. So vectors up to the
//! size below stay with the process; the factor, which is larger and lives long, still has its own
//! pages.

/// Size below which the memory of vectors is kept \[bytes\].
#[cfg(all(target_os = "linux", target_env = "gnu"))]
const KEPT: libc::c_int = 128 << 20;

/// Makes the allocator keep the memory of released vectors for the next ones.
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

/// Returns the kept memory to the system, before the next program measures the available memory.
pub fn give_back() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    // SAFETY: releases only memory that is not allocated
    unsafe {
        libc::malloc_trim(0);
    }
}
