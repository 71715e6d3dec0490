//! Plan of the next mesh: convergence rates ([`rates`]), optimal mesh densities ([`optimum`]) and
//! the decision whether to refine, and how far ([`plan`]). In limit analysis each bound has meshes of
//! its own ([`track`]).

pub mod mechanism_error;
pub mod optimum;
pub mod plan;
pub mod rates;
pub mod track;
