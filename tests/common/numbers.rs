//! Reproducible pseudorandom numbers for tests that try many inputs.
#![allow(dead_code)]

/// Reproducible pseudorandom numbers: a linear congruential generator with the multiplier of MMIX.
pub struct Numbers(pub u64);

impl Numbers {
    /// Between 0 and 1.
    pub fn unit(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[((self.unit() * all.len() as f64) as usize).min(all.len() - 1)]
    }

    pub fn chance(&mut self, part: f64) -> bool {
        self.unit() < part
    }
}
