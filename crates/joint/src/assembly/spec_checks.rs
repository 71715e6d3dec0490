//! Faults of a spec that can be found before any expression of the template is evaluated: ranges of
//! numbers, loads, forces of the column, categories of the bolts.

use super::error::{AssemblyError, known_names, unknown_in};
use super::load_checks;
use super::template::{EndEntry, Template};
use crate::spec::analysis::MeshSize;
use crate::spec::connection::{BoltCategory, ConnectionSpec, PreloadSpec};
use bracket_base::diag::did_you_mean;
use bracket_base::units::{Length, limits};
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::FrictionLaw;

/// Allowed system lengths of members \[mm\].
const SYSTEM_LENGTHS: std::ops::RangeInclusive<f64> = 100.0..=100e3;

/// Largest load step, and how many steps are analysed at most.
const LARGEST_STEP: f64 = 10.0;
const MOST_STEPS: usize = 20;

/// What the system length of a member is.
const LENGTH: &str = "give the system length with its unit: of a beam the distance between the \
                      centres of the columns, `length: 6 m`, of a column its storey height, \
                      `length: 3.5 m`";

/// The system length of a member, which is longer than the joint of it is high.
pub(super) fn system_length(
    spec: &ConnectionSpec,
    role: &str,
    (least, what): (f64, &str),
) -> Result<Option<f64>, AssemblyError> {
    let Some(Length(length)) = spec.members.get(role).and_then(|m| m.length) else {
        return Ok(None);
    };
    if length > least {
        return Ok(Some(length));
    }
    Err(AssemblyError::Value {
        path: format!("members.{role}.length"),
        problem: format!("a system length of {length} mm is not more than the {what}, {least} mm"),
        help: LENGTH.into(),
    })
}

/// Faults of the members: system lengths and forces beside the joint.
pub(super) fn members(spec: &ConnectionSpec, template: &Template, faults: &mut Vec<AssemblyError>) {
    let lengths = spec.members.iter().filter_map(|(role, m)| Some((role, m.length?.0)));
    for (role, length) in lengths.filter(|(_, l)| !limits::within(*l, &SYSTEM_LENGTHS)) {
        faults.push(AssemblyError::Value {
            path: format!("members.{role}.length"),
            problem: format!("a system length of {length} mm; allowed: from 100 mm to 100 m"),
            help: LENGTH.into(),
        });
    }
    column_forces(spec, template, faults);
}

/// All faults except those of the members; `mu` is the friction coefficient of the spec.
pub(super) fn rest(
    spec: &ConnectionSpec,
    template: &Template,
    mu: f64,
    faults: &mut Vec<AssemblyError>,
) {
    numbers(spec, faults);
    coulomb_estimate(spec, mu, faults);
    load_steps(spec, faults);
    bolt_model(spec, faults);
    loads(spec, template, faults);
    categories(spec, faults);
}

/// Forces beside the joint are used for the column only. On other members they would be ignored, so
/// they are a fault.
fn column_forces(spec: &ConnectionSpec, template: &Template, faults: &mut Vec<AssemblyError>) {
    let column = template.column();
    for (role, m) in spec.members.iter().filter(|(role, _)| Some(*role) != column) {
        let given =
            [("N_Ed", m.n_ed.is_some()), ("M_Ed", m.m_ed.is_some()), ("V_Ed", m.v_ed.is_some())];
        for (key, _) in given.into_iter().filter(|g| g.1) {
            faults.push(AssemblyError::Value {
                path: format!("members.{role}.{key}"),
                problem: format!(
                    "`{key}` is a force of the column beside the joint; `{role}` is none"
                ),
                help: "forces at the end of a beam stand under `loads`".into(),
            });
        }
    }
}

/// Checks of the keys that every spec has, so that no template has to repeat them.
fn numbers(spec: &ConnectionSpec, faults: &mut Vec<AssemblyError>) {
    let mut range = |path: &str, value: f64, ok: bool, range: &str| {
        if !ok {
            let name = path.to_owned();
            let (value, range) = (bracket_base::diag::number(value), range.to_owned());
            faults.push(AssemblyError::OutOfRange { path: path.into(), name, value, range });
        }
    };
    let a = &spec.analysis;
    let mu = spec.friction.mu.unwrap_or(0.0);
    range("friction.mu", mu, limits::within(mu, &(0.0..=2.0)), "0 to 2 (0: frictionless)");
    range(
        "analysis.target_gap",
        a.target_gap,
        a.target_gap > 0.0 && a.target_gap < 1.0,
        "between 0 and 1, a fraction: 0.05 is 5 %",
    );
    range("analysis.max_passes", f64::from(a.max_passes), a.max_passes >= 1, "at least 1");
    range("analysis.max_macro_tets", a.max_macro_tets as f64, a.max_macro_tets >= 1, "at least 1");
    let n = a.mesh.segments;
    range(
        "analysis.mesh.segments",
        f64::from(n),
        (12..=48).contains(&n) && n.is_multiple_of(2),
        "even, 12 to 48",
    );
    if let MeshSize::Fixed(Length(h)) = a.mesh.size {
        range(
            "analysis.mesh.size",
            h,
            limits::within(h, &(0.5..=1000.0)),
            "0.5 mm to 1000 mm, or `auto`",
        );
    }
    if spec.friction.mu.is_some() && spec.friction.class.is_some() {
        faults.push(AssemblyError::Value {
            path: "friction.class".into(),
            problem: "`mu` and `class` are both given".into(),
            help: "keep one of them: `class` takes mu from the catalogue".into(),
        });
    }
}

/// Load steps rise, and only elastoplastic analysis has them.
fn load_steps(spec: &ConnectionSpec, faults: &mut Vec<AssemblyError>) {
    let a = &spec.analysis;
    let Some(first) = a.load_steps.first() else { return };
    let mut fault = |path: String, problem: String| {
        faults.push(AssemblyError::Value {
            path,
            problem,
            help: "name rising factors of the demand: `load_steps: [0.25, 0.5, 0.75, 1]`".into(),
        });
    };
    let pairs = std::iter::once((0.0, *first))
        .chain(a.load_steps.windows(2).map(|w| (w[0], w[1])))
        .enumerate();
    for (i, (before, step)) in pairs {
        let number = bracket_base::diag::number;
        let (path, said) = (format!("analysis.load_steps[{i}]"), number(step));
        if !limits::within(step, &(0.0..=LARGEST_STEP)) || step == 0.0 {
            fault(path, format!("the load step {said} is not above 0 and up to {LARGEST_STEP}"));
        } else if step <= before {
            fault(
                path,
                format!("the load step {said} is not above {}, the one before", number(before)),
            );
        } else {
            continue;
        }
        // what follows a wrong step is no fault of its own
        return;
    }
    let path = || "analysis.load_steps".to_owned();
    if a.load_steps.len() > MOST_STEPS {
        let count = a.load_steps.len();
        fault(path(), format!("{count} load steps; at most {MOST_STEPS} are analysed"));
    } else if !a.kind.0.contains(&AnalysisKind::Elastoplastic) && a.decide != Some(true) {
        faults.push(AssemblyError::Value {
            path: path(),
            problem: "`load_steps` without elastoplastic analysis".into(),
            help: "add it: `kind: elastoplastic`, or a list with it".into(),
        });
    }
}

/// An estimate under Coulomb's law requires limit analysis and that law.
fn coulomb_estimate(spec: &ConnectionSpec, mu: f64, faults: &mut Vec<AssemblyError>) {
    let a = &spec.analysis;
    let (problem, help) = match () {
        _ if !a.coulomb_estimate => return,
        _ if !a.kinds(a.decide == Some(true)).contains(&AnalysisKind::Limit) => (
            "it estimates the load factor of limit analysis, which `kind` does not ask for",
            "write `kind: limit` or a list with `limit`, or leave `coulomb_estimate` out",
        ),
        _ if spec.friction.law != FrictionLaw::Coulomb => (
            "the law of friction is `associated`: there is nothing to estimate beside its bracket",
            "write `law: coulomb` under `friction`, or leave `coulomb_estimate` out",
        ),
        _ if mu == 0.0 => (
            "without friction there is nothing to estimate beside the bracket",
            "give `mu` or `class` under `friction`, or leave `coulomb_estimate` out",
        ),
        () => return,
    };
    let path = "analysis.coulomb_estimate".into();
    faults.push(AssemblyError::Value { path, problem: problem.into(), help: help.into() });
}

/// Elastic bolts belong to an elastoplastic analysis.
fn bolt_model(spec: &ConnectionSpec, faults: &mut Vec<AssemblyError>) {
    let a = &spec.analysis;
    if a.bolts.is_yielding()
        || a.kinds(a.decide == Some(true)).contains(&AnalysisKind::Elastoplastic)
    {
        return;
    }
    faults.push(AssemblyError::Value {
        path: "analysis.bolts".into(),
        problem: "elastic bolts belong to an elastoplastic analysis, which `kind` does not ask for"
            .into(),
        help: "write `kind: elastoplastic` or a list with it, or leave `bolts` out; in elastic \
               analysis all bolts are elastic"
            .into(),
    });
}

/// Loads that name no section, an unknown section, or a section already loaded.
fn loads(spec: &ConnectionSpec, template: &Template, faults: &mut Vec<AssemblyError>) {
    if spec.loads.is_empty() {
        let first = |e: &EndEntry| Some((e.names().first()?.clone(), *e.point_words().first()?));
        let about = match template.ends.iter().find_map(first) {
            Some((end, at)) => format!(
                "what acts on the joint; for example `[{{name: ULS1, end: {end}, at: {at}, My: 40 \
                 kN m, Vz: -75 kN}}]`"
            ),
            None => "what acts on the joint; for example `[{name: TOP, section: column_top, \
                     pressure: 45 MPa}]`"
                .into(),
        };
        faults.push(AssemblyError::Missing { path: "loads".into(), about });
    }
    let sections = || template.sections.iter().map(|s| s.name.as_str());
    for (i, l) in spec.loads.iter().enumerate() {
        let path = l.path(i);
        // the directions of a polygon have the same faults, so only the first is reported
        if l.of_polygon && spec.loads[..i].iter().any(|o| o.of_polygon) {
            continue;
        }
        if load_checks::is_at_an_end(l) {
            load_checks::check(&spec.loads, i, template, faults);
            continue;
        }
        let mut value = |problem: String, help: &str| {
            faults.push(AssemblyError::Value { path: path.clone(), problem, help: help.into() });
        };
        match &l.section {
            None => value(
                "the load does not say where it acts".into(),
                "add `section: …`; `bracket templates NAME` lists them",
            ),
            Some(s) if !sections().any(|k| k == s) => {
                let hint = did_you_mean(s, sections());
                let at = format!("{path}.section");
                faults.push(unknown_in(
                    &template.name,
                    at,
                    "section",
                    s,
                    hint,
                    known_names(sections()),
                ));
                continue;
            }
            Some(s) => {
                if spec.loads[..i].iter().any(|o| o.section.as_ref() == Some(s) && o.name == l.name)
                {
                    value(
                        format!("load case `{}` already loads `{s}`", l.name),
                        "give it another name, or add the values",
                    );
                }
            }
        }
        if l.pressure.is_some() == l.traction.is_some() {
            faults.push(AssemblyError::Value {
                path: path.clone(),
                problem: "a load on a section has `pressure` or `traction`, one of them".into(),
                help: "write `pressure: 45 MPa` (positive pushes on the face) or `traction: [0 \
                       MPa, 0 MPa, -45 MPa]`"
                    .into(),
            });
        }
    }
}

/// Preloaded categories without a preload, and load cases with two limit states.
fn categories(spec: &ConnectionSpec, faults: &mut Vec<AssemblyError>) {
    if let Some(b) = &spec.bolts {
        let preloaded = b.preload.is_some_and(|p| p != PreloadSpec::None);
        let asks = matches!(b.category, Some(BoltCategory::B | BoltCategory::C | BoltCategory::E));
        if asks && !preloaded {
            faults.push(AssemblyError::Value {
                path: "bolts.category".into(),
                problem: "bolts of categories B, C and E are preloaded (EN 1993-1-8:2005 Table \
                          3.2), these have no `preload`"
                    .into(),
                help: "add `preload: 0.7` to `bolts`, or take category A or D".into(),
            });
        }
    }
    for (i, load) in spec.loads.iter().enumerate() {
        let Some(first) = spec.loads[..i].iter().find(|o| o.name == load.name) else { continue };
        if first.state != load.state {
            faults.push(AssemblyError::Value {
                path: format!("{}.state", load.path(i)),
                problem: format!("the loads of load case `{}` are of two limit states", load.name),
                help: "give all of them the same `state`, or this one another name".into(),
            });
        }
    }
}
