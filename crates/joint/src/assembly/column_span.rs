//! The column of the model between its supports, as a frame of members sees it.

use super::assembly::{Assembly, FaceRule, Surface};
use super::builder::Context;
use super::error::AssemblyError;
use super::member_ends::Frame;
use super::part::Placed;
use serde::Serialize;

/// Largest distance between the end of a member and the support that holds it \[mm\].
const SAME_PLACE: f64 = 0.1;

/// How an end of the column is held in the plane of the joint.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct EndHold {
    /// It does not move along the beam.
    pub sideways: bool,
    /// Its section does not turn.
    pub rotation: bool,
}

/// The column of the model on one side of the beam's axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ColumnArm {
    /// From the beam's axis to the end of the column \[mm\].
    pub length: f64,
    /// How that end is held.
    pub hold: EndHold,
}

/// The column of the model between its supports. Nothing else holds the joint.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ColumnSpan {
    /// Above the beam's axis.
    pub above: ColumnArm,
    /// Below it.
    pub below: ColumnArm,
}

/// The column with this role; `None` where it is not one length of profile that is held at whole
/// end sections only, with the beams on its flanges at one height.
pub(super) fn column_span(
    context: &Context<'_>,
    assembly: &Assembly,
    frames: &[Frame],
    role: &str,
) -> Result<Option<ColumnSpan>, AssemblyError> {
    let Some(first) = frames.first() else { return Ok(None) };
    let level = |f: &Frame| f.origin[f.depth];
    let alike = |f: &Frame| {
        (f.along, f.depth) == (first.along, first.depth)
            && (level(f) - level(first)).abs() <= SAME_PLACE
    };
    let mut placed = context.lengths_of(role)?;
    let (Some((part, column)), true, true) =
        (placed.pop(), placed.is_empty(), frames.iter().all(alike))
    else {
        return Ok(None);
    };
    if (column.along, column.depth) != (first.depth, first.along) {
        return Ok(None);
    }
    let mut holds = [EndHold::default(); 2];
    for support in &assembly.supports {
        let face = assembly.faces.iter().find(|f| f.name == support.face && f.part == part);
        let Some(end) = face.and_then(|f| held_end(f, &column)) else { return Ok(None) };
        holds[end].sideways |= support.fix[first.along];
        holds[end].rotation |= support.fix[column.along];
    }
    let arm = |end: usize| ColumnArm {
        length: (column.span[end] - level(first)).abs(),
        hold: holds[end],
    };
    let inside = column.span[0] < level(first) && level(first) < column.span[1];
    Ok(inside.then(|| ColumnSpan { above: arm(1), below: arm(0) }))
}

/// The end of the column (0: lower) whose whole section is the face.
fn held_end(face: &FaceRule, column: &Placed<'_>) -> Option<usize> {
    let Surface::Plane { axis, at, min, max } = &face.surface else { return None };
    let half = [(column.depth, 0.5 * column.profile.h), (column.width(), 0.5 * column.profile.b)];
    let whole = half.iter().all(|&(k, half)| {
        min[k] <= column.centre[k] - half + SAME_PLACE
            && max[k] >= column.centre[k] + half - SAME_PLACE
    });
    let end = (0..2).find(|&i| (at - column.span[i]).abs() <= SAME_PLACE);
    end.filter(|_| *axis == column.along && whole)
}
