//! Which mesh comes next.

pub mod optimum;
pub mod plan;
pub mod rates;
