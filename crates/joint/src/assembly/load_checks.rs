//! Faults of loads at member ends that can be found without the dimensions of the joint.

use super::error::AssemblyError;
use super::template::Template;
use super::template_file::SHIPPED;
use crate::spec::loads::LoadSpec;

/// True if the load names a member end rather than a section.
pub(super) fn is_at_an_end(load: &LoadSpec) -> bool {
    load.end.is_some() || load.at.is_some() || !load.actions().is_empty() || !load.factor.is_empty()
}

/// Faults of a load at a member end that can be found without the dimensions of the joint.
pub(super) fn check(
    loads: &[LoadSpec],
    i: usize,
    template: &Template,
    faults: &mut Vec<AssemblyError>,
) {
    let load = &loads[i];
    let mut value = |key: &str, problem: String, help: &str| {
        let path = if key.is_empty() { load.path(i) } else { format!("{}.{key}", load.path(i)) };
        faults.push(AssemblyError::Value { path, problem, help: help.into() });
    };
    if template.ends.is_empty() {
        let problem = format!(
            "template `{}` has no member ends that forces and moments could act on",
            template.name
        );
        let with: Vec<String> = SHIPPED
            .iter()
            .filter(|(_, t)| t.contains("\nends:"))
            .map(|(n, _)| format!("`{n}`"))
            .collect();
        let help = format!(
            "load a section by `pressure` or `traction`, or take a template with member ends: {}",
            with.join(", ")
        );
        value("", problem, &help);
        return;
    }
    if load.section.is_some() || load.pressure.is_some() || load.traction.is_some() {
        let problem = "the load mixes a section under traction with forces and moments at a \
                       member end"
            .to_owned();
        value("", problem, "write two loads with the same `name`: they act together");
    }
    if load.end.is_none() {
        let help = "add `end: …`; `bracket templates NAME` lists the member ends";
        value("", "the forces and moments do not say which member end they act on".into(), help);
    }
    if load.at.is_none() {
        let help = "add `at: node`, `at: column_face` or `at: bolt_plane`: the lever arm of the \
                    shear force hangs on it";
        value("", "the load does not say where its forces and moments act".into(), help);
    }
    if load.actions().is_empty() {
        value(
            "",
            "the load has no forces or moments".into(),
            "give at least one of N, Vy, Vz, T, My, Mz, for example `My: 80 kN m`",
        );
    }
    if load.dead && !load.factor.is_empty() {
        value(
            "factor",
            "`dead: true` says that no action carries the load factor".into(),
            "keep one of `dead` and `factor`",
        );
    }
    for (k, a) in load.factor.iter().enumerate() {
        if load.factor[..k].contains(a) {
            value("factor", format!("`{}` stands twice", a.word()), "name each action once");
        } else if !load.actions().iter().any(|(given, _)| given == a) {
            value(
                "factor",
                format!("`{}` carries the load factor but is not given", a.word()),
                "give it a value, or leave it out of `factor`",
            );
        }
    }
    let twice =
        loads[..i].iter().any(|o| o.name == load.name && o.end.is_some() && o.end == load.end);
    if let (true, Some(end)) = (twice, &load.end) {
        value(
            "end",
            format!("load case `{}` already loads `{end}`", load.name),
            "give it another name, or join the two loads",
        );
    }
}
