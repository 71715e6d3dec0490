//! Forces and moments at member ends. A load in the member's own axes becomes a force and a moment
//! in global axes, and the actions on the bolt plane.

use super::assembly::{Action as Acting, FaceLoad, FaceRule};
use super::error::AssemblyError;
use super::evaluate::{entry_fault, identifier, rectangle, within};
use super::member_ends::{End, Moved, face_axes, member_axes, parts};
use super::small_actions::SmallActions;
use super::template::Template;
use crate::spec::loads::{ActionPoint, LimitState, LoadSpec};
use bracket_base::diag::did_you_mean;
use bracket_base::math::vec3::{self, V3};
use serde::Serialize;

/// Loads on the end section, without those that are neglected: one entry for the part that the
/// load factor multiplies and one for the part that it does not. Adds the end section to the named
/// faces.
pub(super) fn on_end(
    load: &LoadSpec,
    i: usize,
    (template, small): (&Template, &SmallActions),
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
    let Some(position) = end.point(point)? else {
        let known: Vec<&str> = end.entry.points.keys().map(|p: &ActionPoint| p.word()).collect();
        let problem = format!("the member end `{name}` has no point `{}`", point.word());
        return Err(AssemblyError::Unknown {
            path: format!("{}.at", load.path(i)),
            problem,
            known: known.join(", "),
        });
    };
    let axes = member_axes(at, end)?;
    let face = identifier(at, name.to_uppercase())?;
    if !faces.iter().any(|f| f.name == face) {
        let surface = rectangle(at, &end.scope, &end.entry.face)?;
        let part = within(at, end.scope.text(&end.entry.part))?;
        faces.push(FaceRule { name: face.clone(), part, surface, imprint: false });
    }
    let own = Moved { at: position, parts: parts(load) };
    let kept = match small.mask(load, name) {
        Some(mask) => end.to_plane(load)?.unwrap_or(own).without(&mask),
        None => own,
    };
    let global = |v: V3| (0..3).fold([0.0; 3], |sum, k| vec3::along(sum, v[k], axes[k]));
    let acts = |[force, moment]: &[V3; 2]| force.iter().chain(moment).any(|v| *v != 0.0);
    Ok([false, true]
        .into_iter()
        .zip(kept.parts)
        .filter(|(_, part)| acts(part))
        .map(|(dead, [force, moment])| FaceLoad {
            face: face.clone(),
            case: load.name.clone(),
            action: Acting::Resultant { at: kept.at, force: global(force), moment: global(moment) },
            dead,
        })
        .collect())
}

/// Actions of a load case on the bolt plane of a member end, in the axes of its face: x′ out of the
/// joint, y′ across, z′ up along the depth of the section. They are those of the member unless it
/// slopes.
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
    /// Height of the bolt plane's point above the node along z′ \[mm\]; not 0 where the depth at
    /// the plate reaches below the axis of the beam by a haunch.
    #[serde(skip_serializing_if = "is_level")]
    pub above_node: f64,
}

/// Whether a height above the node is none.
fn is_level(height: &f64) -> bool {
    *height == 0.0
}

impl PlaneActions {
    /// Forces and moments under the load factor `factor`.
    pub fn at(&self, factor: f64) -> [V3; 2] {
        [0, 1].map(|i| vec3::along(self.dead[i], factor, self.live[i]))
    }

    /// My at the node under load factor 1 \[N mm\]: `My − d Vz + h N`, h the height of the plane
    /// above the node.
    pub fn moment_at_node(&self) -> f64 {
        let [force, moment] = self.at(1.0);
        moment[1] - self.from_node * force[2] + self.above_node * force[0]
    }
}

/// The actions of every load case on the bolt planes of the member ends named in `wanted`, without
/// those that are neglected and without ends on which nothing acts. The load directions of a
/// polygon are left out because they are not a demand.
pub(super) fn on_planes(
    loads: &[LoadSpec],
    small: &SmallActions,
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
        let axes = face_axes(at, end)?;
        // the normal of the face lies along a global axis
        let outward = axes[0].iter().sum::<f64>().signum();
        let slope = end.slope()?;
        let node = end.entry.points.get(&ActionPoint::Node);
        let from_node = match node {
            Some(p) => vec3::sub(plane, within(at, end.scope.point(p))?),
            None => [0.0; 3],
        };
        let [from_node, above_node] = [axes[0], axes[2]].map(|axis| vec3::dot(from_node, axis));
        for load in loads.iter().filter(|l| !l.of_polygon && l.end.as_deref() == Some(&end.name)) {
            // check() has rejected a load without a point, and on_end() a point that the end does
            // not have
            let Some(mut moved) = end.to_plane(load)? else { continue };
            if let Some(mask) = small.mask(load, &end.name) {
                moved = moved.without(&mask);
            }
            let [live, dead] = moved.on_face(slope).parts;
            if [live, dead].as_flattened().as_flattened().iter().all(|v| *v == 0.0) {
                continue;
            }
            let (case, end) = (load.name.clone(), end.name.clone());
            let state = load.state;
            out.push(PlaneActions { case, end, live, dead, state, outward, from_node, above_node });
        }
    }
    out.sort_by_key(|a| loads.iter().position(|l| l.name == a.case));
    Ok(out)
}

#[cfg(test)]
mod tests;
