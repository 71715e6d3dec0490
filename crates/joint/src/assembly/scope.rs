//! Names and their values during evaluation of a template: profiles, bolts, parameters,
//! definitions, loop variables.

mod causes;
mod range;
mod settle;

use super::error::AssemblyError;
use super::template::{Default, Loop, Parameter, ParameterKind, Template};
use crate::spec::expr::{Expr, ExprError, Value};
use bracket_base::diag::{AtLeastOne, did_you_mean};
use bracket_base::units::Dim;
use bracket_base::words::{Gap, Text};
use causes::causes;
use range::Range;
use settle::{Pending, Values, settle};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A parameter's value and its origin, as printed in the report.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Resolved {
    /// Name.
    pub name: String,
    /// Value with its unit.
    pub value: Text,
    /// True if the spec gives the value, false if it is the template's default.
    pub given: bool,
    /// The template's default expression; `None` if the spec must give a value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub default: Option<String>,
    /// Allowed range in words, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range: Option<String>,
    /// Description of the parameter.
    pub about: String,
    /// Origin of the value, where `given` and `default` do not describe it fully.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Text>,
}

/// Smallest and largest value of a parameter in internal units, and the range in words.
type Limits = (Option<f64>, Option<f64>, Option<String>);

/// Most turns of nested loops, each of which is a scope in memory.
const MOST_TURNS: usize = 100_000;

/// A loop variable in one pass of its loop.
#[derive(Clone, Debug)]
struct Turn {
    name: String,
    value: Value,
    label: String,
    index: usize,
}

/// All names of one evaluation.
#[derive(Clone, Debug, std::default::Default)]
pub struct Scope {
    /// Shared by the scopes of the turns of a loop.
    values: Arc<BTreeMap<String, Value>>,
    lists: Arc<BTreeMap<String, usize>>,
    turns: Vec<Turn>,
}

/// A parameter's value from the spec, in internal units.
#[derive(Clone, Debug, PartialEq)]
pub enum Given {
    /// One value.
    One(Value),
    /// A list of lengths \[mm\].
    Many(Vec<f64>),
}

impl Scope {
    /// Sets a name.
    pub fn set(&mut self, name: impl Into<String>, value: Value) {
        Arc::make_mut(&mut self.values).insert(name.into(), value);
    }

    /// The value of a name.
    pub fn get(&self, name: &str) -> Result<Value, String> {
        for turn in self.turns.iter().rev() {
            if turn.name == name {
                return Ok(turn.value);
            }
            if name.strip_suffix(".n") == Some(&turn.name) {
                return Ok(Value::number(turn.index as f64 + 1.0));
            }
        }
        if let Some(v) = self.values.get(name) {
            return Ok(*v);
        }
        if self.lists.contains_key(name) {
            return Err(format!(
                "`{name}` is a list: write `{name}.1` for its first entry, or loop over it"
            ));
        }
        let known = self
            .values
            .keys()
            .map(String::as_str)
            .chain(self.turns.iter().map(|t| t.name.as_str()));
        Err(format!("unknown name `{name}`{}", did_you_mean(name, known)))
    }

    /// A length \[mm\].
    pub fn length(&self, e: &Expr) -> Result<f64, ExprError> {
        e.eval_as(Dim::LENGTH, &mut |n| self.get(n))
    }

    /// An angle \[rad\].
    pub fn angle(&self, e: &Expr) -> Result<f64, ExprError> {
        e.eval_as(Dim::ANGLE, &mut |n| self.get(n))
    }

    /// A pure number.
    pub fn number(&self, e: &Expr) -> Result<f64, ExprError> {
        e.eval_as(Dim::NONE, &mut |n| self.get(n))
    }

    /// A truth value.
    pub fn truth(&self, e: &Expr) -> Result<bool, ExprError> {
        e.eval_truth(&mut |n| self.get(n))
    }

    /// The lengths of a list parameter \[mm\] in their order; the error states why there is no such
    /// list.
    pub fn list(&self, name: &str) -> Result<Vec<f64>, String> {
        let length = |v: Value| match v {
            Value::Quantity(q) if q.dim == Dim::LENGTH => Ok(q.value),
            other => Err(format!("`{name}` holds {other}, which is no length")),
        };
        self.entries(name)?.into_iter().map(length).collect()
    }

    /// The entries of a list parameter.
    fn entries(&self, name: &str) -> Result<Vec<Value>, String> {
        let n = *self.lists.get(name).ok_or_else(|| {
            let hint = did_you_mean(name, self.lists.keys().map(String::as_str));
            format!("`{name}` is not a list parameter{hint}")
        })?;
        (1..=n).map(|i| self.get(&format!("{name}.{i}"))).collect()
    }

    /// An interval \[mm\], lower end first.
    pub fn interval(&self, e: &[Expr; 2]) -> Result<[f64; 2], ExprError> {
        let (a, b) = (self.length(&e[0])?, self.length(&e[1])?);
        Ok([a.min(b), a.max(b)])
    }

    /// A point \[mm\].
    pub fn point(&self, e: &[Expr; 3]) -> Result<[f64; 3], ExprError> {
        Ok([self.length(&e[0])?, self.length(&e[1])?, self.length(&e[2])?])
    }

    /// Replaces `{expr}`, `{#loop}` (label) and `{@loop}` (index from 0) in a text.
    pub fn text(&self, pattern: &str) -> Result<String, ExprError> {
        self.words(pattern).map(|words| words.to_string())
    }

    /// The same as a text for a person; what is replaced is given.
    pub fn words(&self, pattern: &str) -> Result<Text, ExprError> {
        let fault = |message: String| ExprError {
            message,
            text: pattern.to_owned(),
            span: 0..pattern.len(),
        };
        let (mut id, mut gaps) = (String::new(), Vec::new());
        let mut rest = pattern;
        while let Some(open) = rest.find('{') {
            id.push_str(&rest[..open]);
            id.push_str("{}");
            let tail = &rest[open + 1..];
            let close = tail.find('}').ok_or_else(|| fault("`{` without `}`".into()))?;
            let inner = tail[..close].trim();
            gaps.push(Gap::Given(match inner.strip_prefix(['#', '@']) {
                Some(name) => {
                    let turn = self.turns.iter().rev().find(|t| t.name == name);
                    let turn =
                        turn.ok_or_else(|| fault(format!("`{name}` is no loop variable here")))?;
                    if inner.starts_with('#') { turn.label.clone() } else { turn.index.to_string() }
                }
                None => Expr::parse(inner)?.eval(&mut |n| self.get(n))?.to_string(),
            }));
            rest = &tail[close + 1..];
        }
        id.push_str(rest);
        Ok(Text { id: id.into(), gaps })
    }

    /// One scope for each pass of the nested loops for which `when` holds.
    pub fn turns(&self, loops: &[Loop], when: Option<&Expr>) -> Result<Vec<Scope>, ExprError> {
        let mut scopes = vec![self.clone()];
        for l in loops {
            let mut next = Vec::new();
            for scope in scopes {
                let values = scope.loop_values(l)?;
                if next.len() + values.len() > MOST_TURNS {
                    let message = format!("more than {MOST_TURNS} turns of nested loops");
                    return Err(ExprError { message, text: l.each.clone(), span: 0..l.each.len() });
                }
                for (index, value) in values.into_iter().enumerate() {
                    let label =
                        l.labels.get(index).cloned().unwrap_or_else(|| (index + 1).to_string());
                    let mut s = scope.clone();
                    s.turns.push(Turn { name: l.each.clone(), value, label, index });
                    next.push(s);
                }
            }
            scopes = next;
        }
        match when {
            None => Ok(scopes),
            Some(w) => {
                let mut kept = Vec::new();
                for s in scopes {
                    if s.truth(w)? {
                        kept.push(s);
                    }
                }
                Ok(kept)
            }
        }
    }

    fn loop_values(&self, l: &Loop) -> Result<Vec<Value>, ExprError> {
        let fault =
            |message: String| ExprError { message, text: l.each.clone(), span: 0..l.each.len() };
        match &l.list {
            Some(_) if !l.values.is_empty() => {
                Err(fault("a loop has `values` or `list`, not both".into()))
            }
            Some(list) => self.entries(list).map_err(fault),
            None => l.values.iter().map(|e| e.eval(&mut |n| self.get(n))).collect(),
        }
    }

    /// Resolves all parameters and definitions of a template: values from the spec, else the
    /// defaults.
    ///
    /// The order of the definitions does not matter. A cycle of defaults is an error that lists the
    /// cycle. Ranges are checked after all values are known.
    pub fn resolve(
        &mut self,
        template: &Template,
        given: &BTreeMap<String, Given>,
    ) -> Result<Vec<Resolved>, AtLeastOne<AssemblyError>> {
        let mut faults = Vec::new();
        for p in template
            .parameters
            .iter()
            .filter(|p| p.default.is_none() && !given.contains_key(&p.name))
        {
            faults.push(AssemblyError::Missing { path: path_of(&p.name), about: p.about.clone() });
        }
        AtLeastOne::refuse(std::mem::take(&mut faults))?;
        for p in &template.parameters {
            if let Some(g) = given.get(&p.name) {
                self.take(&p.name, g);
            }
        }
        // lengths of lists are known before any value, so that loops and `name.1` work in any order
        for p in &template.parameters {
            if let (false, Some(Default::Many(list))) = (given.contains_key(&p.name), &p.default) {
                Arc::make_mut(&mut self.lists).insert(p.name.clone(), list.len());
            }
        }
        let mut pending = Pending::new();
        for p in template.parameters.iter().filter(|p| !given.contains_key(&p.name)) {
            match &p.default {
                Some(Default::One(e)) => drop(pending.insert(p.name.clone(), (e, dim_of(p)))),
                Some(Default::Many(list)) => {
                    for (i, e) in list.iter().enumerate() {
                        pending.insert(format!("{}.{}", p.name, i + 1), (e, dim_of(p)));
                    }
                }
                None => {}
            }
        }
        for d in &template.define {
            pending.insert(d.name.clone(), (&d.value, None));
        }
        let names: Vec<String> = pending.keys().cloned().collect();
        for name in names {
            if let Err(e) = settle(&name, &pending, self) {
                return Err(AssemblyError::Template { at: name, cause: e }.into());
            }
        }
        let mut out = Vec::new();
        for p in &template.parameters {
            let range = match self.limits(p) {
                Ok((min, max, words)) => {
                    let range = Range { min, max, words: words.as_deref().unwrap_or_default() };
                    self.check_range(p, &range, template, given, &mut faults);
                    words
                }
                Err(cause) => {
                    faults.push(AssemblyError::Template { at: p.name.clone(), cause });
                    None
                }
            };
            let value = self.shown(&p.name);
            let default = p.default.as_ref().map(Default::text);
            let given = given.contains_key(&p.name);
            let (name, about) = (p.name.clone(), p.about.clone());
            out.push(Resolved { name, value, given, default, range, about, origin: None });
        }
        AtLeastOne::refuse(faults)?;
        Ok(out)
    }

    /// The value of a parameter as text.
    fn shown(&self, parameter: &str) -> Text {
        let show = |name: &str| self.get(name).map_or_else(Text::given, |v| v.text());
        match self.lists.get(parameter) {
            None => show(parameter),
            Some(n) => {
                let each = (1..=*n).map(|i| show(&format!("{parameter}.{i}")));
                Text::given(format!("[{}]", Text::joined(", ", each)))
            }
        }
    }

    pub(super) fn take(&mut self, name: &str, given: &Given) {
        match given {
            Given::One(v) => self.set(name, *v),
            Given::Many(list) => {
                for (i, v) in list.iter().enumerate() {
                    self.set(format!("{name}.{}", i + 1), Value::length(*v));
                }
                Arc::make_mut(&mut self.lists).insert(name.to_owned(), list.len());
            }
        }
    }

    /// Smallest and largest value of a parameter, and the range in words.
    fn limits(&self, p: &Parameter) -> Result<Limits, ExprError> {
        let dim = dim_of(p).unwrap_or(Dim::NONE);
        let limit =
            |e: &Option<Expr>| e.as_ref().map(|e| e.eval_as(dim, &mut |n| self.get(n))).transpose();
        let (min, max) = (limit(&p.min)?, limit(&p.max)?);
        let words = match (min, max) {
            (Some(a), Some(b)) => Some(format!("{} to {}", show(a, dim), show(b, dim))),
            (Some(a), None) => Some(format!("at least {}", show(a, dim))),
            (None, Some(b)) => Some(format!("at most {}", show(b, dim))),
            (None, None) => None,
        };
        Ok((min, max, words))
    }

    fn check_range(
        &self,
        p: &Parameter,
        range: &Range<'_>,
        template: &Template,
        given: &BTreeMap<String, Given>,
        faults: &mut Vec<AssemblyError>,
    ) {
        let mut check = |name: String, path: String| {
            let Ok(Value::Quantity(q)) = self.get(&name) else { return };
            if range.holds(q.value) {
                return;
            }
            let (name, value) = (p.name.clone(), show(q.value, q.dim));
            let bound = if range.min.is_some_and(|m| q.value < m) { &p.min } else { &p.max };
            // a bound that depends on other values says so
            let named = |e: &&Expr| e.eval(&mut |n| Err(n.to_owned())).is_err();
            let bound = bound.as_ref().filter(named).map(|e| format!("; `{}` sets it", e.text()));
            let range = format!("{}{}", range.words, bound.unwrap_or_default());
            faults.push(match (&p.default, given.contains_key(&p.name)) {
                (Some(default), false) => {
                    let causes = causes(template, p, &|name| given.contains_key(name));
                    let words: Vec<String> = causes
                        .iter()
                        .map(|c| format!("`{}` is {}", path_of(c), self.shown(c)))
                        .collect();
                    let because = match words.is_empty() {
                        true => String::new(),
                        false => format!(" ({})", words.join(", ")),
                    };
                    let (own, path) = (path.clone(), causes.first().map_or(path, |c| path_of(c)));
                    let problem = format!(
                        "`{name}` is {value} by its default `{}`; allowed: {range}{because}",
                        default.text()
                    );
                    AssemblyError::DefaultOutOfRange { path, own, problem, range }
                }
                _ => AssemblyError::OutOfRange { path, name, value, range },
            });
        };
        let path = path_of(&p.name);
        match self.lists.get(&p.name) {
            None => check(p.name.clone(), path),
            Some(n) => {
                (0..*n).for_each(|i| check(format!("{}.{}", p.name, i + 1), format!("{path}[{i}]")))
            }
        }
    }
}

impl Values for Scope {
    fn known(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    fn give(&mut self, name: &str, expr: &Expr, dim: Option<Dim>) -> Result<(), ExprError> {
        let value = match dim {
            Some(Dim::LENGTH) => Value::length(self.length(expr)?),
            Some(Dim::ANGLE) => Value::angle(self.angle(expr)?),
            _ => expr.eval(&mut |n| self.get(n))?,
        };
        self.set(name, value);
        Ok(())
    }
}

/// A value in internal units as text with its unit.
fn show(value: f64, dim: Dim) -> String {
    Value::Quantity(bracket_base::units::Quantity { value, dim }).to_string()
}

/// Path of a parameter in the spec: `plate.*` and `bolts.*` are keys of the spec itself, all other
/// parameters are under `parameters`.
pub fn path_of(parameter: &str) -> String {
    if parameter.starts_with("plate.") || parameter.starts_with("bolts.") {
        parameter.to_owned()
    } else {
        format!("parameters.{parameter}")
    }
}

fn dim_of(p: &Parameter) -> Option<Dim> {
    match p.kind {
        ParameterKind::Length | ParameterKind::Lengths => Some(Dim::LENGTH),
        ParameterKind::Number => Some(Dim::NONE),
        ParameterKind::Angle => Some(Dim::ANGLE),
        ParameterKind::Flag => None,
    }
}

#[cfg(test)]
mod tests;
