//! Every printed formula against the value of its check, by a reader of formulas that knows nothing
//! of how they were made.

#[path = "../../../crates/codes/src/formula/tests/evaluator.rs"]
mod evaluator;

use bracket::checks::Check;
use bracket::checks::formula::{Formula, Style};
use evaluator::evaluate;
use std::collections::BTreeSet;

/// Formulas that were compared.
#[derive(Default)]
pub struct Compared {
    /// Their clauses with what they give.
    pub clauses: BTreeSet<String>,
}

impl Compared {
    /// Compares the formulas of a check.
    pub fn check(&mut self, check: &Check, text: &str) {
        for formula in check.derivation.formulas().filter(|f| f.value.is_finite()) {
            let fault = difference(formula);
            assert!(fault.is_none(), "{}: {check:#?}\n{text}", fault.unwrap_or_default());
            self.clauses.insert(format!("{} {}", check.clause, formula.symbol));
        }
    }
}

/// Where a formula as printed, with all digits or with symbols, does not give its value to 1e-12.
fn difference(formula: &Formula) -> Option<String> {
    let symbols: Vec<(String, f64)> = formula
        .term
        .symbols()
        .into_iter()
        .map(|(name, value, _)| (name.to_string(), value))
        .collect();
    let symbols: Vec<(&str, f64)> =
        symbols.iter().map(|(name, value)| (&name[..], *value)).collect();
    let exact = (formula.term.print(Style::Exact), &[][..]);
    let by_symbols = (formula.term.print(Style::Symbols), &symbols[..]);
    // the symbols of a sum over rows are those of its first row
    let both = if by_symbols.0.contains("Σ ") { vec![exact] } else { vec![exact, by_symbols] };
    both.into_iter().find_map(|(text, known)| {
        let read = match evaluate(&text, known) {
            Ok(read) => read,
            Err(fault) => return Some(format!("{text}: {fault}")),
        };
        // a difference of two large numbers has their rounding
        let size = formula.value.abs().max(1e-9);
        ((read - formula.value).abs() > 1e-12 * size)
            .then(|| format!("{text} is {read}, not {}", formula.value))
    })
}
