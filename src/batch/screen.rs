//! The checks of the code for one case, in the process: no mesh, no files.

use super::case::Case;
use super::expansion::{Expansion, typed};
use super::row::{LoadRow, Outcome, Record};
use crate::driver::demands::demands;
use crate::driver::judge::by_code;
use crate::driver::spec_checks::check_loads;
use bracket_base::diag::Diagnostic;
use bracket_base::yaml::{Parsed, PlaceIndex};
use bracket_codes::design_code::build_from;
use bracket_codes::end_plate::{parts_list, total_mass};
use bracket_codes::verdict::Verdict;
use bracket_codes::{Analysed, Comparison, HandChecks, joint_checks, judge};
use bracket_joint::assembly::assembly::PartRole;
use bracket_joint::assembly::{Joint, LoadedTemplate, given_names};
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::connection::ConnectionSpec;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What the cases of a sweep share: catalogue and templates, each read once.
pub struct Kit {
    /// Folder from which the paths of the spec are resolved.
    pub folder: PathBuf,
    /// File of the base spec, for messages.
    pub file: PathBuf,
    /// The catalogue.
    pub catalog: Catalog,
    /// The templates by the name in the spec.
    pub templates: BTreeMap<String, Result<LoadedTemplate, Box<Diagnostic>>>,
}

impl Kit {
    /// A kit that knows the templates of `names`.
    pub fn new(folder: &Path, file: &Path, catalog: Catalog, names: Vec<ConnectionSpec>) -> Self {
        let templates = names
            .into_iter()
            .map(|value| {
                let name = value.template.clone();
                let parsed = Parsed { value, index: PlaceIndex::new(file) };
                (name, LoadedTemplate::of(&parsed, folder).map_err(|f| f.into_first().into()))
            })
            .collect();
        Self { folder: folder.into(), file: file.into(), catalog, templates }
    }

    /// The template of a spec.
    pub fn template(&self, spec: &ConnectionSpec) -> Result<&LoadedTemplate, Box<Diagnostic>> {
        match self.templates.get(&spec.template) {
            Some(Ok(template)) => Ok(template),
            Some(Err(d)) => Err(d.clone()),
            None => Err(Box::new(Diagnostic::input(
                "sweep/template",
                format!("the template `{}` was not read", spec.template),
            ))),
        }
    }

    /// The spec of a combination.
    pub fn spec(&self, expansion: &Expansion, index: u64) -> Result<Value, Box<Diagnostic>> {
        let path_fault = |e| Diagnostic::input("sweep/path", e);
        let mut spec = expansion.varied(index).map_err(path_fault)?;
        if expansion.derived.is_empty() {
            return Ok(spec);
        }
        let typed = typed(&spec, &self.file)?;
        let scope = given_names(&typed, self.template(&typed)?, &self.catalog)
            .map_err(|faults| Diagnostic::from(faults.into_first()))?;
        for derived in &expansion.derived {
            derived.set(&mut spec, &scope).map_err(|e| {
                let help = "`set` knows `role.h` and other dimensions of the members, `bolt.d` and \
                            other sizes of the bolt, and the values that the spec gives";
                Diagnostic::input("sweep/set", e).help(help)
            })?;
        }
        Ok(spec)
    }

    /// The joint of a case.
    pub fn joint(&self, spec: ConnectionSpec) -> Result<(Joint, ConnectionSpec), Box<Diagnostic>> {
        let template = self.template(&spec)?;
        let parsed = Parsed { value: spec, index: PlaceIndex::new(&self.file) };
        if let Some(polygon) = &parsed.value.polygon
            && let Err(faults) = polygon.loads(&parsed.value.loads)
        {
            let fault = faults.into_first();
            let d = Diagnostic::input("spec/value", fault.problem).help(fault.help);
            return Err(d.path(fault.path).into());
        }
        check_loads(&parsed, &[]).map_err(|f| f.into_first())?;
        let joint = build_from(&parsed, template, &self.catalog).map_err(|f| f.into_first())?;
        Ok((joint, parsed.value))
    }
}

/// Checks a case.
pub fn screen(case: &Case, expansion: &Expansion, kit: &Kit) -> Record {
    let spec = kit.spec(expansion, case.index);
    let joint = spec.and_then(|s| typed(&s, &kit.file)).and_then(|spec| kit.joint(spec));
    match joint {
        Ok((joint, spec)) => record(&case.key, &joint, &spec),
        Err(d) => Record::without_result(&case.key, Outcome::BadInput, sentence(&d)),
    }
}

/// A fault of a case in one line: the path and the message.
fn sentence(d: &Diagnostic) -> String {
    match d.place.path.as_deref().filter(|p| !d.message.contains(*p)) {
        Some(path) => format!("{path}: {}", d.message),
        None => d.message.clone(),
    }
}

fn record(key: &str, joint: &Joint, spec: &ConnectionSpec) -> Record {
    let mut checks = joint_checks(joint);
    let demands = demands(&spec.loads);
    // beside a limit analysis that carries the load, the strength part of the component method is
    // information: what fails even then is final
    let carried: Vec<Analysed> = demands
        .iter()
        .map(|d| Analysed { verdict: Verdict::Ok, ..Analysed::not(&d.case) })
        .collect();
    let (best, _) = judge(&mut checks.clone(), &carried);
    let (all, each) = by_code(&mut checks, &demands);
    let rows = demands.iter().zip(each).map(|(demand, j)| {
        let method = method(&checks, &demand.case);
        let actions = actions(joint, &checks, &demand.case);
        let reason = LoadRow::reason(&j);
        LoadRow {
            case: demand.case.clone(),
            verdict: j.verdict,
            route: j.route,
            by_code: j.by_code,
            by_analysis: Verdict::None,
            lower: None,
            upper: None,
            brittle: checks.brittle.is_some(),
            governing: j.governing,
            moment_resistance: method.0,
            component_factor: method.1,
            component_stiffness: method.2,
            end: actions.as_ref().map(|(end, _)| end.clone()),
            actions: actions.map(|(_, a)| a),
            reason,
        }
    });
    let rows = rows.collect();
    let failed = checks.failed() && demands.is_empty();
    let outcome = if failed { Outcome::NotOk } else { Outcome::of(all.verdict) };
    let cause = demands.is_empty().then(|| "no load is a demand".to_string());
    let bolts = joint.assembly.parts.iter().filter(|p| p.role == PartRole::Bolt).count() as u32;
    Record {
        key: key.into(),
        outcome,
        cause,
        mass: mass(joint),
        bolts: Some(bolts),
        seconds: None,
        rejected: best.verdict == Verdict::NotOk,
        result: false,
        loads: rows,
    }
}

/// M_j,Rd, load factor and S_j,ini of the component method in a load case: of the member end that
/// reaches its resistance first.
fn method(checks: &HandChecks, case: &str) -> (Option<f64>, Option<f64>, Option<f64>) {
    let first = first_end(checks.comparisons().filter(|c| c.case == case));
    let stiffness = checks.moments().find(|m| m.case == case).map(|m| m.component_method);
    (first.map(|c| c.resistance), first.and_then(|c| c.factor), stiffness)
}

/// The member end that reaches its resistance first, with its N, Vz and My at the bolt plane.
fn actions(joint: &Joint, checks: &HandChecks, case: &str) -> Option<(String, [f64; 3])> {
    let end = first_end(checks.comparisons().filter(|c| c.case == case)).map(|c| &c.end);
    let plane = joint.facts.as_ref()?.actions();
    let mine =
        |of_end: bool| plane.iter().find(|a| a.case == case && (!of_end || Some(&a.end) == end));
    let found = mine(end.is_some())?;
    let [[n, _, vz], [_, my, _]] = found.at(1.0);
    Some((found.end.clone(), [n, vz, my]))
}

/// Of the member ends of a load case the one that reaches its resistance first.
pub fn first_end<'a>(ends: impl Iterator<Item = &'a Comparison>) -> Option<&'a Comparison> {
    let factor = |c: &Comparison| c.factor.unwrap_or(f64::INFINITY);
    ends.min_by(|a, b| factor(a).total_cmp(&factor(b)))
}

/// Mass of the end plates, stiffeners and bolts \[kg\], as the report lists them. `None` for a
/// template without an end plate.
fn mass(joint: &Joint) -> Option<f64> {
    joint.facts.as_ref()?;
    total_mass(&parts_list(&joint.content))
}
