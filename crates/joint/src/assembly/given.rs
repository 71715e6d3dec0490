//! Values that a spec gives for the parameters of its template.

use super::error::{AssemblyError, known_names, unknown_in};
use super::scope::{Given, path_of};
use super::template::{Parameter, ParameterKind, Template};
use crate::spec::connection::{ConnectionSpec, ParameterValue};
use crate::spec::expr::Value;
use bracket_base::diag::did_you_mean;
use bracket_base::units::{self, Length};
use std::collections::BTreeMap;

/// Parameters that a spec holds beside `parameters`.
const BESIDE: [&str; 5] =
    ["bolts.gauge", "bolts.rows", "plate.thickness", "plate.width", "plate.z"];

/// The values that the spec gives for the template's parameters, by name.
pub(super) fn given(
    spec: &ConnectionSpec,
    template: &Template,
    faults: &mut Vec<AssemblyError>,
) -> BTreeMap<String, Given> {
    let one = |l: Length| Given::One(Value::length(l.0));
    let many = |l: &[Length]| Given::Many(l.iter().map(|x| x.0).collect());
    for p in template.parameters.iter().filter(|p| p.name.contains('.')) {
        if !BESIDE.contains(&p.name.as_str()) {
            let problem = format!(
                "a spec has no `{}`: with a point there are {}; give the parameter a name without \
                 one",
                p.name,
                BESIDE.join(", ")
            );
            faults.push(AssemblyError::TemplateEntry { at: p.name.clone(), problem });
        }
    }
    let mut out = BTreeMap::new();
    if let Some(p) = &spec.plate {
        out.extend(p.thickness.map(|v| ("plate.thickness".to_owned(), one(v))));
        out.extend(p.width.map(|v| ("plate.width".to_owned(), one(v))));
        out.extend(p.z.as_ref().map(|v| ("plate.z".to_owned(), many(v))));
    }
    if let Some(b) = &spec.bolts {
        out.extend(b.gauge.map(|v| ("bolts.gauge".to_owned(), one(v))));
        out.extend(b.rows.as_ref().map(|v| ("bolts.rows".to_owned(), many(v))));
    }
    let find = |name: &str| template.parameters.iter().find(|p| p.name == name);
    for (name, value) in &spec.parameters {
        match find(name).filter(|p| path_of(&p.name).starts_with("parameters.")) {
            Some(p) => match parameter(p, value) {
                Ok(v) => drop(out.insert(name.clone(), v)),
                Err((problem, help)) => {
                    faults.push(AssemblyError::Value {
                        path: format!("parameters.{name}"),
                        problem,
                        help,
                    });
                }
            },
            None => {
                let names = || {
                    template.parameters.iter().map(|p| p.name.as_str()).filter(|n| !n.contains('.'))
                };
                let path = format!("parameters.{name}");
                faults.push(unknown_in(
                    &template.name,
                    path,
                    "parameter",
                    name,
                    did_you_mean(name, names()),
                    known_names(names()),
                ));
            }
        }
    }
    for name in out.keys().filter(|n| find(n).is_none()) {
        let names = || template.parameters.iter().map(|p| p.name.as_str());
        faults.push(unknown_in(
            &template.name,
            path_of(name),
            "parameter",
            name,
            did_you_mean(name, names()),
            known_names(names()),
        ));
    }
    for (name, value) in &out {
        let (Some(Parameter { count: Some(n), .. }), Given::Many(list)) = (find(name), value)
        else {
            continue;
        };
        if list.len() != *n {
            let problem = format!("{} values are given, {n} are wanted", list.len());
            let help = find(name).map_or_else(String::new, |p| p.about.clone());
            faults.push(AssemblyError::Value { path: path_of(name), problem, help });
        }
    }
    for (name, value) in &out {
        if matches!(value, Given::Many(list) if list.is_empty()) {
            let help = find(name).map_or_else(String::new, |p| p.about.clone());
            faults.push(AssemblyError::Value {
                path: path_of(name),
                problem: "the list is empty".into(),
                help: format!("give at least one value: {help}"),
            });
        }
    }
    out
}

fn parameter(p: &Parameter, value: &ParameterValue) -> Result<Given, (String, String)> {
    let wanted = match p.kind {
        ParameterKind::Length => "write a length: mm, cm, m, in, or a bare number for mm",
        ParameterKind::Number => "write a plain number",
        ParameterKind::Angle => "write an angle: 6 deg, 0.1 rad",
        ParameterKind::Flag => "write true or false",
        ParameterKind::Lengths => "write a list of lengths: [-100 mm, 100 mm]",
    };
    let quantity = |r: Result<f64, units::UnitError>, of: fn(f64) -> Value| {
        r.map(|v| Given::One(of(v))).map_err(|e| (e.to_string(), wanted.to_owned()))
    };
    match (p.kind, value) {
        (ParameterKind::Length, ParameterValue::Number(x)) => {
            quantity(units::bare(*x, units::Kind::Length), Value::length)
        }
        (ParameterKind::Length, ParameterValue::Text(t)) => {
            quantity(units::parse(t, units::Kind::Length), Value::length)
        }
        (ParameterKind::Angle, ParameterValue::Number(x)) => {
            quantity(units::bare(*x, units::Kind::Angle), Value::angle)
        }
        (ParameterKind::Angle, ParameterValue::Text(t)) => {
            quantity(units::parse(t, units::Kind::Angle), Value::angle)
        }
        (ParameterKind::Number, ParameterValue::Number(x)) => Ok(Given::One(Value::number(*x))),
        (ParameterKind::Flag, ParameterValue::Flag(f)) => Ok(Given::One(Value::Truth(*f))),
        (ParameterKind::Lengths, ParameterValue::List(l)) => {
            Ok(Given::Many(l.iter().map(|x| x.0).collect()))
        }
        _ => Err((format!("the value does not fit: {}", p.about), wanted.to_owned())),
    }
}
