//! Plan of the next mesh: convergence rates ([`rates`]), optimal mesh densities ([`optimum`]), the
//! directions of the elements ([`directions`], [`metric`]) and the decision whether to refine, and
//! how far ([`plan`]). In limit analysis each bound has meshes of its own ([`track`]).

pub mod directions;
pub mod mechanism_error;
pub mod metric;
pub mod near_yield;
pub mod optimum;
pub mod plan;
pub mod rates;
pub mod track;
pub mod twins;
