//! The ends of members that forces and moments act on, with their axes and points.

use super::error::AssemblyError;
use super::evaluate::{entry_fault, within};
use super::scope::Scope;
use super::template::{EndEntry, Template};
use crate::spec::loads::{ActionPoint, LoadSpec};
use bracket_base::math::vec3::{self, V3};

/// Components of a force and a moment that are neglected.
pub(super) type Mask = [[bool; 3]; 2];

/// A member end of the template, for one pass of its loops.
pub(super) struct End<'a> {
    /// Its name, as loads say it.
    pub name: String,
    /// Its entry in the template.
    pub entry: &'a EndEntry,
    /// The values of the pass.
    pub scope: Scope,
}

/// Forces and moments of a load about a point, in the member's own axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moved {
    /// The point in global axes \[mm\].
    pub at: V3,
    /// Force and moment \[N, N mm\]: what the load factor multiplies, and what it does not.
    pub parts: [[V3; 2]; 2],
}

impl End<'_> {
    /// Name of the part that ends here.
    pub fn part(&self) -> Result<String, AssemblyError> {
        within(&self.entry.name, self.scope.text(&self.entry.part))
    }

    /// Angle by which the member rises against the normal of its face \[rad\].
    pub fn slope(&self) -> Result<f64, AssemblyError> {
        let slope = self.entry.slope.as_ref();
        slope.map_or(Ok(0.0), |e| within(&self.entry.name, self.scope.angle(e)))
    }

    /// A point of the end in global axes \[mm\]; `None` if it has no such point.
    pub fn point(&self, point: ActionPoint) -> Result<Option<V3>, AssemblyError> {
        let found = self.entry.points.get(&point);
        found.map(|p| within(&self.entry.name, self.scope.point(p))).transpose()
    }

    /// The load about the bolt plane, or about its own point where the end has no bolt plane;
    /// `None` for a load without a point that the end has.
    pub fn to_plane(&self, load: &LoadSpec) -> Result<Option<Moved>, AssemblyError> {
        let Some(given) = load.at.map_or(Ok(None), |at| self.point(at))? else { return Ok(None) };
        let plane = self.point(ActionPoint::BoltPlane)?.unwrap_or(given);
        let axes = member_axes(&self.entry.name, self)?;
        let arm = axes.map(|a| vec3::dot(vec3::sub(given, plane), a));
        let about = |[f, m]: [V3; 2]| [f, vec3::along(m, 1.0, vec3::cross(arm, f))];
        Ok(Some(Moved { at: plane, parts: parts(load).map(about) }))
    }
}

impl Moved {
    /// The components along the axes of the face instead of those of a member with this slope
    /// \[rad\].
    pub fn on_face(mut self, slope: f64) -> Self {
        let (sin, cos) = slope.sin_cos();
        for vector in self.parts.as_flattened_mut() {
            let [x, y, z] = *vector;
            *vector = [cos * x - sin * z, y, sin * x + cos * z];
        }
        self
    }

    /// Without the components of a mask.
    pub fn without(mut self, mask: &Mask) -> Self {
        for part in &mut self.parts {
            for (vector, mask) in part.iter_mut().zip(mask) {
                for (component, _) in vector.iter_mut().zip(mask).filter(|(_, small)| **small) {
                    *component = 0.0;
                }
            }
        }
        self
    }
}

/// Force and moment of a load in the member's own axes: what the load factor multiplies, and what
/// it does not.
pub(super) fn parts(load: &LoadSpec) -> [[V3; 2]; 2] {
    let mut parts = [[[0.0; 3]; 2]; 2];
    for (action, size) in load.actions() {
        let (axis, is_moment) = action.direction();
        parts[usize::from(!load.multiplies(action))][usize::from(is_moment)][axis] += size;
    }
    parts
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
    /// 1 where the member runs out of the joint along its axis, −1 where it runs against it.
    pub outward: f64,
}

/// The frames of the member ends named in `wanted`.
pub(super) fn frames(ends: &[End<'_>], wanted: &[String]) -> Result<Vec<Frame>, AssemblyError> {
    let of = |end: &End<'_>| {
        let at = end.entry.name.as_str();
        let plane = end.entry.points.get(&ActionPoint::BoltPlane)?;
        let (along, depth) = (end.entry.face.axis.index(), end.entry.depth.index());
        let outward = within(at, end.scope.number(&end.entry.outward));
        let origin = within(at, end.scope.point(plane));
        let frame = |origin, outward| Frame { origin, along, depth, outward };
        Some(origin.and_then(|origin| outward.map(|outward| frame(origin, outward))))
    };
    ends.iter().filter(|e| wanted.contains(&e.name)).filter_map(of).collect()
}

/// The member's own axes x′, y′, z′ in global ones.
pub(super) fn member_axes(at: &str, end: &End<'_>) -> Result<[V3; 3], AssemblyError> {
    let [x, y, z] = face_axes(at, end)?;
    let (sin, cos) = end.slope()?.sin_cos();
    let both = |a: f64, v: V3, b: f64, w: V3| vec3::along(v.map(|c| a * c), b, w);
    Ok([both(cos, x, sin, z), y, both(cos, z, -sin, x)])
}

/// The axes of the end's face in global ones: its normal out of the joint, across, along the depth.
/// Without a slope they are those of the member.
pub(super) fn face_axes(at: &str, end: &End<'_>) -> Result<[V3; 3], AssemblyError> {
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
