//! The order in which names get their values: each after those that its expression needs.

use crate::spec::expr::{Expr, ExprError};
use bracket_base::units::Dim;
use std::collections::{BTreeMap, BTreeSet};

/// The expressions of names without a value, and the dimension that is expected.
pub(super) type Pending<'a> = BTreeMap<String, (&'a Expr, Option<Dim>)>;

/// Names with values.
pub(super) trait Values {
    /// True if the name has a value.
    fn known(&self, name: &str) -> bool;

    /// Gives the name the value of its expression, all of whose names are known or unknown to the
    /// template.
    fn give(&mut self, name: &str, expr: &Expr, dim: Option<Dim>) -> Result<(), ExprError>;
}

/// A name that waits for the values of others.
struct Open<'p> {
    name: &'p str,
    expr: &'p Expr,
    dim: Option<Dim>,
    /// Names of its expression that have not been looked at, last one first.
    needs: Vec<&'p str>,
}

/// Names of a ring that are listed.
const SHOWN_OF_RING: usize = 12;

/// The error of values that need each other: `again` is open already.
fn ring(open: &[Open], again: &Open) -> ExprError {
    let from = open.iter().position(|o| o.name == again.name).unwrap_or(0);
    let mut ring: Vec<&str> = open[from..].iter().map(|o| o.name).collect();
    if ring.len() > SHOWN_OF_RING {
        ring.truncate(SHOWN_OF_RING);
        ring.push("…");
    }
    ring.push(again.name);
    let text = again.expr.text().to_owned();
    let message = format!("these values need each other: {}", ring.join(" -> "));
    ExprError { message, span: 0..text.len(), text }
}

/// Gives a name its value, after the names that its expression needs. A chain of definitions may be
/// longer than a thread's stack allows calls, so the open ones are kept in a list.
pub(super) fn settle<'p>(
    name: &str,
    pending: &'p Pending<'p>,
    values: &mut impl Values,
) -> Result<(), ExprError> {
    let entry = |name: &str| {
        let (name, (expr, dim)) = pending.get_key_value(name)?;
        let mut needs = expr.names();
        needs.reverse();
        Some(Open { name, expr, dim: *dim, needs })
    };
    if values.known(name) {
        return Ok(());
    }
    let Some(first) = entry(name) else { return Ok(()) };
    let mut within = BTreeSet::from([first.name]);
    let mut open = vec![first];
    while let Some(last) = open.last_mut() {
        if let Some(need) = last.needs.pop() {
            if values.known(need) {
                continue;
            }
            let Some(found) = entry(need) else { continue };
            if !within.insert(found.name) {
                return Err(ring(&open, &found));
            }
            open.push(found);
            continue;
        }
        values.give(last.name, last.expr, last.dim)?;
        within.remove(last.name);
        open.pop();
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::expr::Value;

    impl Values for BTreeMap<String, Value> {
        fn known(&self, name: &str) -> bool {
            self.contains_key(name)
        }

        fn give(&mut self, name: &str, expr: &Expr, _: Option<Dim>) -> Result<(), ExprError> {
            let value = expr.eval(&mut |n| self.get(n).copied().ok_or("no value".into()))?;
            self.insert(name.into(), value);
            Ok(())
        }
    }

    fn settled(texts: &[(String, String)]) -> Result<BTreeMap<String, Value>, ExprError> {
        let parse = |t: &str| Expr::parse(t).expect("an expression");
        let exprs: Vec<(String, Expr)> = texts.iter().map(|(n, t)| (n.clone(), parse(t))).collect();
        let pending: Pending = exprs.iter().map(|(n, e)| (n.clone(), (e, None))).collect();
        let mut values = BTreeMap::new();
        settle("n0", &pending, &mut values).map(|()| values)
    }

    fn chain(n: usize, last: &str) -> Vec<(String, String)> {
        let next = |i: usize| if i + 1 < n { format!("n{} + 1", i + 1) } else { last.into() };
        (0..n).map(|i| (format!("n{i}"), next(i))).collect()
    }

    /// A thread's stack does not limit the length of a chain of definitions.
    #[test]
    fn a_long_chain_of_definitions_is_settled() {
        let values = settled(&chain(100_000, "1")).expect("values");
        assert_eq!(values["n0"], Value::number(100_000.0));
    }

    #[test]
    fn a_long_ring_is_named_by_its_begin() {
        let e = settled(&chain(100_000, "n7")).expect_err("a ring");
        assert!(e.message.starts_with("these values need each other: n7 -> n8 -> "), "{e:?}");
        assert!(e.message.ends_with("-> … -> n7") && e.message.len() < 200, "{e:?}");
        let e = settled(&chain(3, "n1")).expect_err("a ring");
        assert_eq!(e.message, "these values need each other: n1 -> n2 -> n1");
    }
}
