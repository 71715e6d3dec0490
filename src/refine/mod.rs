//! Plan of the next mesh: convergence rates ([`rates`]), optimal mesh densities ([`optimum`]),
//! the directions of the elements ([`directions`], [`metric`]) and the decision whether to refine, and how far ([`plan`]).

pub mod directions;
pub mod metric;
pub mod optimum;
pub mod plan;
pub mod rates;
