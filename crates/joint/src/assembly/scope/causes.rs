//! The given values that the default of a parameter and its range follow from.

use crate::assembly::template::{Parameter, Template};
use crate::spec::expr::Expr;
use std::collections::BTreeSet;

/// The parameters that the spec gives (`given`) and that the default of `parameter` follows from,
/// then those of its range, each once.
pub(super) fn causes(
    template: &Template,
    parameter: &Parameter,
    given: &dyn Fn(&str) -> bool,
) -> Vec<String> {
    let default = parameter.default.iter().flat_map(|d| d.expressions());
    let range = parameter.min.iter().chain(&parameter.max);
    let (mut seen, mut out) = (BTreeSet::new(), Vec::new());
    let mut open: Vec<&str> = default.chain(range).flat_map(Expr::names).collect();
    open.reverse();
    while let Some(name) = open.pop() {
        let known = |p: &&Parameter| {
            let entry = name.strip_prefix(&p.name).and_then(|rest| rest.strip_prefix('.'));
            name == p.name || entry.is_some_and(|n| n.bytes().all(|b| b.is_ascii_digit()))
        };
        let found = template.parameters.iter().find(known);
        let name = found.map_or(name, |p| p.name.as_str());
        if !seen.insert(name) {
            continue;
        }
        if given(name) {
            out.push(name.to_owned());
            continue;
        }
        let definition = template.define.iter().filter(|d| d.name == name).map(|d| &d.value);
        let default = found.and_then(|p| p.default.as_ref()).map_or(&[][..], |d| d.expressions());
        open.extend(definition.chain(default).flat_map(Expr::names));
    }
    out
}
