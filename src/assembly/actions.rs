//! Forces and moments at member ends. A load in the member's own axes becomes a force and a moment
//! in global axes, and the actions on the bolt plane.

use super::assembly::{Action as Acting, FaceLoad, FaceRule};
use super::error::AssemblyError;
use super::evaluate::{entry_fault, identifier, rectangle, within};
use super::scope::Scope;
use super::template::{EndEntry, Template};
use super::template_file::SHIPPED;
use crate::diag::did_you_mean;
use crate::math::vec3::{self, V3};
use crate::spec::loads::{ActionPoint, LimitState, LoadSpec};
use serde::Serialize;

/// A member end of the template, for one pass of its loops.
pub(super) struct End<'a> {
    name: String,
    entry: &'a EndEntry,
    scope: Scope,
}

/// All member ends of a joint.
pub(super) fn ends<'a>(
    template: &'a Template,
    scope: &Scope,
) -> Result<Vec<End<'a>>, AssemblyError> {
    let mut out = Vec::new();
    for entry in &template.ends {
        let at = entry.name.as_str();
        for scope in within(at, scope.turns(&entry.each, entry.when.as_ref()))? {
            out.push(End { name: within(at, scope.text(at))?, entry, scope });
        }
    }
    Ok(out)
}

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

/// Loads on the end section: one entry for the part that the load factor multiplies and one for the
/// part that it does not. Adds the end section to the named faces.
pub(super) fn on_end(
    load: &LoadSpec,
    i: usize,
    template: &Template,
    ends: &[End<'_>],
    faces: &mut Vec<FaceRule>,
) -> Result<Vec<FaceLoad>, AssemblyError> {
    // check() has rejected a load without these two
    let (Some(name), Some(point)) = (&load.end, load.at) else { return Ok(Vec::new()) };
    let Some(end) = ends.iter().find(|e| e.name == *name) else {
        let known: Vec<&str> = ends.iter().map(|e| e.name.as_str()).collect();
        let only =
            template.ends.iter().find(|e| e.names().contains(name)).and_then(|e| e.when.as_ref());
        let hint = match only {
            Some(when) => {
                format!(": template `{}` has it only where `{}`", template.name, when.text())
            }
            None => did_you_mean(name, known.iter().copied()),
        };
        let problem = format!("the joint has no member end `{name}`{hint}");
        return Err(AssemblyError::Unknown {
            path: format!("{}.end", load.path(i)),
            problem,
            known: known.join(", "),
        });
    };
    let at = end.entry.name.as_str();
    let Some(position) = end.entry.points.get(&point) else {
        let known: Vec<&str> = end.entry.points.keys().map(|p: &ActionPoint| p.word()).collect();
        let problem = format!("the member end `{name}` has no point `{}`", point.word());
        return Err(AssemblyError::Unknown {
            path: format!("{}.at", load.path(i)),
            problem,
            known: known.join(", "),
        });
    };
    let position = within(at, end.scope.point(position))?;
    let axes = member_axes(at, end)?;
    let face = identifier(at, name.to_uppercase())?;
    if !faces.iter().any(|f| f.name == face) {
        let surface = rectangle(at, &end.scope, &end.entry.face)?;
        let part = within(at, end.scope.text(&end.entry.part))?;
        faces.push(FaceRule { name: face.clone(), part, surface, imprint: false });
    }
    let mut sums = [(false, [[0.0; 3]; 2]), (true, [[0.0; 3]; 2])];
    for (action, size) in load.actions() {
        let dead = !load.multiplies(action);
        let (axis, is_moment) = action.direction();
        let sum = &mut sums[usize::from(dead)].1[usize::from(is_moment)];
        *sum = vec3::along(*sum, size, axes[axis]);
    }
    let acts = |[force, moment]: &[V3; 2]| force.iter().chain(moment).any(|v| *v != 0.0);
    Ok(sums
        .into_iter()
        .filter(|(_, sum)| acts(sum))
        .map(|(dead, [force, moment])| FaceLoad {
            face: face.clone(),
            case: load.name.clone(),
            action: Acting::Resultant { at: position, force, moment },
            dead,
        })
        .collect())
}

/// Actions of a load case on the bolt plane of a member end, in the member's own axes: x′ out of
/// the joint, y′ across, z′ up along the depth of the section.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlaneActions {
    /// Load case.
    pub case: String,
    /// Member end.
    pub end: String,
    /// N, Vy, Vz \[N\] and T, My, Mz \[N mm\] that the load factor multiplies. A positive My, about
    /// y′, puts the top of the section in tension.
    pub live: [V3; 2],
    /// The same components, for the part that the load factor does not multiply.
    pub dead: [V3; 2],
    /// Limit state.
    pub state: LimitState,
    /// Sign of x′ along the global axis of the member: 1 for a right beam, −1 for a left one.
    pub outward: f64,
    /// Distance from the node to the bolt plane along x′ \[mm\]; 0 where the template has no node.
    pub from_node: f64,
}

impl PlaneActions {
    /// Forces and moments under the load factor `factor`.
    pub fn at(&self, factor: f64) -> [V3; 2] {
        [0, 1].map(|i| vec3::along(self.dead[i], factor, self.live[i]))
    }

    /// My at the node under load factor 1 \[N mm\]: `My − d Vz`.
    pub fn moment_at_node(&self) -> f64 {
        let [force, moment] = self.at(1.0);
        moment[1] - self.from_node * force[2]
    }
}

/// Position of a member end: its bolt plane, the axis of the member and the axis of its section's
/// depth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// Point where the member's axis meets the bolt plane \[mm\].
    pub origin: V3,
    /// Axis of the member, 0 = x.
    pub along: usize,
    /// Axis of the section's depth, 0 = x.
    pub depth: usize,
}

/// The frames of the member ends named in `wanted`.
pub(super) fn frames(ends: &[End<'_>], wanted: &[String]) -> Result<Vec<Frame>, AssemblyError> {
    let of = |end: &End<'_>| {
        let at = end.entry.name.as_str();
        let plane = end.entry.points.get(&ActionPoint::BoltPlane)?;
        let (along, depth) = (end.entry.face.axis.index(), end.entry.depth.index());
        Some(within(at, end.scope.point(plane)).map(|origin| Frame { origin, along, depth }))
    };
    ends.iter().filter(|e| wanted.contains(&e.name)).filter_map(of).collect()
}

/// The actions of every load case on the bolt planes of the member ends named in `wanted`. The load
/// directions of a polygon are left out because they are not a demand.
pub(super) fn on_planes(
    loads: &[LoadSpec],
    ends: &[End<'_>],
    wanted: &[String],
) -> Result<Vec<PlaneActions>, AssemblyError> {
    let mut out = Vec::new();
    for end in ends.iter().filter(|e| wanted.contains(&e.name)) {
        let at = end.entry.name.as_str();
        let Some(plane) = end.entry.points.get(&ActionPoint::BoltPlane) else {
            return entry_fault(
                at,
                "`hand_checks.ends` names it, but it has no point `bolt_plane`",
            );
        };
        let plane = within(at, end.scope.point(plane))?;
        let axes = member_axes(at, end)?;
        let own = |v: V3| axes.map(|a| vec3::dot(v, a));
        // x′ lies along a global axis
        let outward = axes[0].iter().sum::<f64>().signum();
        let node = end.entry.points.get(&ActionPoint::Node);
        let from_node = match node {
            Some(p) => own(vec3::sub(plane, within(at, end.scope.point(p))?))[0],
            None => 0.0,
        };
        for load in loads.iter().filter(|l| !l.of_polygon && l.end.as_deref() == Some(&end.name)) {
            // check() has rejected a load without a point, and on_end() a point that the end does
            // not have
            let Some(point) = load.at.and_then(|p| end.entry.points.get(&p)) else { continue };
            let arm = own(vec3::sub(within(at, end.scope.point(point))?, plane));
            let mut sums = [[[0.0; 3]; 2]; 2];
            for (action, size) in load.actions() {
                let (axis, is_moment) = action.direction();
                sums[usize::from(!load.multiplies(action))][usize::from(is_moment)][axis] += size;
            }
            let [live, dead] = sums.map(|[f, m]| [f, vec3::along(m, 1.0, vec3::cross(arm, f))]);
            let (case, end) = (load.name.clone(), end.name.clone());
            out.push(PlaneActions { case, end, live, dead, state: load.state, outward, from_node });
        }
    }
    out.sort_by_key(|a| loads.iter().position(|l| l.name == a.case));
    Ok(out)
}

/// The member's own axes x′, y′, z′ in global ones.
fn member_axes(at: &str, end: &End<'_>) -> Result<[V3; 3], AssemblyError> {
    let outward = within(at, end.scope.number(&end.entry.outward))?;
    if outward.abs() != 1.0 {
        return entry_fault(at, format!("`outward` is {outward}, not 1 or -1"));
    }
    let (along, depth) = (end.entry.face.axis.index(), end.entry.depth.index());
    if along == depth {
        return entry_fault(at, "`depth` is the axis of the member");
    }
    let (mut x, mut z) = ([0.0; 3], [0.0; 3]);
    x[along] = outward;
    z[depth] = 1.0;
    Ok([x, vec3::cross(z, x), z])
}

#[cfg(test)]
mod tests;
