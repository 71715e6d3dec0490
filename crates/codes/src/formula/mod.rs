//! Formulas that print themselves.
//!
//! A clause is a function that is generic over its [`Number`]. With `f64` it computes. With
//! [`Traced`] it also records what it does, so that the [`Formula`] of a check is printed from the
//! very operations that gave its value: with symbols, with numbers, or as a tree for fractions.
//!
//! ```
//! use bracket_codes::Unit;
//! use bracket_codes::formula::{Formula, Number, Traced};
//!
//! /// `F_p,C = 0.7 f_ub A_s` \[N\], EN 1993-1-8:2005 3.9.1(2).
//! fn preload<N: Number>(f_ub: N, a_s: N) -> N {
//!     N::from(0.7) * f_ub * a_s
//! }
//!
//! let force = preload(800.0, 245.0);
//! let [f_ub, a_s] = [("f_ub", 800.0, Unit::Stress), ("A_s", 245.0, Unit::Area)].map(Traced::from);
//! let formula = Formula::new("F_p,C", preload(f_ub, a_s), Unit::Force);
//! assert_eq!(formula.value, force);
//! assert_eq!(formula.text(), "F_p,C = 0.7 f_ub A_s = 0.7 · 800 · 245 = 137.2 kN");
//! ```

mod derivation;
mod number;
mod print;
mod term;
mod traced;

pub(crate) use derivation::text_of;
pub use derivation::{Derivation, Formula, Line, Relation};
pub use number::Number;
pub use print::{Part, Run, Style};
pub use term::Term;
pub use traced::Traced;

#[cfg(test)]
mod tests;
