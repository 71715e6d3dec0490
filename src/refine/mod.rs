//! Plan of the next mesh: convergence rates ([`rates`]), optimal mesh densities ([`optimum`]) and
//! the decision whether to refine, and how far ([`plan`]).

pub mod optimum;
pub mod plan;
pub mod rates;
