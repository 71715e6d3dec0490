//! The order in which names get their values: each after those that its expression needs.

use super::Scope;
use crate::spec::expr::{Expr, ExprError, Value};
use crate::units::Dim;
use std::collections::{BTreeMap, BTreeSet};

/// The expressions of names without a value, and the dimension that is expected.
pub(super) type Pending<'a> = BTreeMap<String, (&'a Expr, Option<Dim>)>;

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

impl Scope {
    /// Sets a name to its value, after the names that its expression needs. A chain of definitions
    /// may be longer than a thread's stack allows calls, so the open ones are kept in a list.
    pub(super) fn settle<'p>(
        &mut self,
        name: &str,
        pending: &'p Pending<'p>,
    ) -> Result<(), ExprError> {
        let entry = |name: &str| {
            let (name, (expr, dim)) = pending.get_key_value(name)?;
            let mut needs = expr.names();
            needs.reverse();
            Some(Open { name, expr, dim: *dim, needs })
        };
        if self.values.contains_key(name) {
            return Ok(());
        }
        let Some(first) = entry(name) else { return Ok(()) };
        let mut within = BTreeSet::from([first.name]);
        let mut open = vec![first];
        while let Some(last) = open.last_mut() {
            if let Some(need) = last.needs.pop() {
                if self.values.contains_key(need) {
                    continue;
                }
                let Some(found) = entry(need) else { continue };
                if !within.insert(found.name) {
                    return Err(ring(&open, &found));
                }
                open.push(found);
                continue;
            }
            let value = match last.dim {
                Some(Dim::LENGTH) => Value::length(self.length(last.expr)?),
                _ => last.expr.eval(&mut |n| self.get(n))?,
            };
            let name = last.name;
            self.set(name, value);
            within.remove(name);
            open.pop();
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::template::Loop;

    fn settled(texts: &[(String, String)], name: &str) -> Result<Scope, ExprError> {
        let parse = |t: &str| Expr::parse(t).expect("an expression");
        let exprs: Vec<(String, Expr)> = texts.iter().map(|(n, t)| (n.clone(), parse(t))).collect();
        let pending: Pending = exprs.iter().map(|(n, e)| (n.clone(), (e, None))).collect();
        let mut scope = Scope::default();
        scope.settle(name, &pending).map(|()| scope)
    }

    fn chain(n: usize, last: &str) -> Vec<(String, String)> {
        let next = |i: usize| if i + 1 < n { format!("n{} + 1", i + 1) } else { last.into() };
        (0..n).map(|i| (format!("n{i}"), next(i))).collect()
    }

    /// A thread's stack does not limit the length of a chain of definitions.
    #[test]
    fn a_long_chain_of_definitions_is_settled() {
        let scope = settled(&chain(100_000, "1"), "n0").expect("a value");
        assert_eq!(scope.get("n0"), Ok(Value::number(100_000.0)));
    }

    #[test]
    fn a_long_ring_is_named_by_its_begin() {
        let e = settled(&chain(100_000, "n7"), "n0").expect_err("a ring");
        assert!(e.message.starts_with("these values need each other: n7 -> n8 -> "), "{e:?}");
        assert!(e.message.ends_with("-> … -> n7") && e.message.len() < 200, "{e:?}");
        let e = settled(&chain(3, "n1"), "n0").expect_err("a ring");
        assert_eq!(e.message, "these values need each other: n1 -> n2 -> n1");
    }

    /// The limit of turns holds before any of them is in memory.
    #[test]
    fn loops_beyond_the_limit_are_refused() {
        let numbers = |n: usize| -> Vec<Expr> {
            (0..n).map(|_| Expr::parse("1").expect("a number")).collect()
        };
        let of = |name: &str, n: usize| Loop {
            each: name.into(),
            values: numbers(n),
            list: None,
            labels: Vec::new(),
        };
        let scope = Scope::default();
        let some = scope.turns(&[of("a", 300), of("b", 300)], None).expect("90 000");
        assert_eq!(some.len(), 90_000);
        for loops in [vec![of("a", 400), of("b", 400)], vec![of("a", 100_001)]] {
            let e = scope.turns(&loops, None).map(drop).expect_err("too many");
            assert!(e.message.contains("more than 100000 turns"), "{e:?}");
        }
    }
}
