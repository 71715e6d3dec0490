//! The `hand_checks` of a simple joint with their values.

use super::actions::PlaneActions;
use super::builder::Context;
use super::code_values::CodeValues;
use super::content::Content;
use super::end_plate::unseen;
use super::error::AssemblyError;
use super::expected_parts::{
    Expected, ExpectedBolt, ExpectedMember, ExpectedPlate, Flanges, between, same_extent,
};
use super::family_values::Values;
use super::member_ends::Frame;
use super::simple_joint::{Notch, SimpleJoint, SimpleKind, Support, SupportElement};
use super::template::{PlateKind, SimpleJointEntry};
use crate::spec::expr::Expr;

/// The values of the template's `hand_checks`.
pub(super) fn simple_joint(
    context: &Context<'_>,
    entry: &SimpleJointEntry,
    code: &CodeValues,
    actions: Vec<PlaneActions>,
) -> Result<SimpleJoint, AssemblyError> {
    let (values, spec) = (Values(context), context.spec);
    let role = |r: &String| std::slice::from_ref(r).to_vec();
    let section = values.profile("support", &entry.support)?;
    let on_web = entry.to_web.as_ref().map_or(Ok(false), |e| values.truth("to_web", e))?;
    let element = match (entry.support_is_beam, on_web) {
        (true, _) => SupportElement::BeamWeb,
        (false, true) => SupportElement::ColumnWeb,
        (false, false) => SupportElement::ColumnFlange,
    };
    let thickness = if element == SupportElement::ColumnFlange { section.tf } else { section.tw };
    let support =
        Support { element, steel: values.steel(&role(&entry.support), thickness)?, section };
    let beam = values.profile("beam", &entry.beam)?;
    let (bolt, grade) = values.bolts("rows")?;
    let mut rows = values.list("rows", &entry.rows)?;
    rows.reverse();
    let plate = values.positive("thickness", &entry.thickness)?;
    let (bottom, top) =
        (values.length("bottom", &entry.bottom)?, values.length("top", &entry.top)?);
    if bottom >= top {
        let problem = format!("the upper edge {top} mm is not above the lower edge {bottom} mm");
        return Err(values.wrong("top", problem));
    }
    let notch = |key: &str, e: &Option<[Expr; 2]>| -> Result<Notch, AssemblyError> {
        let of = |k: usize| values.or_none(key, e.as_ref().map(|e| &e[k]));
        Ok(Notch { length: of(0)?, depth: of(1)? })
    };
    let (kind, other) = match entry.kind {
        PlateKind::FinPlate => (SimpleKind::FinPlate, beam.tw),
        PlateKind::HeaderPlate => (SimpleKind::HeaderPlate, support.thickness()),
    };
    Ok(SimpleJoint {
        kind,
        beam_steel: values.steel(&role(&entry.beam), beam.tw)?,
        plate_steel: values.steel(&entry.steel, plate)?,
        thickness: plate,
        width: values.positive("width", &entry.width)?,
        bottom,
        top,
        rows,
        columns: values.rising("columns", &entry.columns)?,
        hole: values.hole(&entry.hole, &bolt)?,
        beam_start: values.positive("beam_start", &entry.beam_start)?,
        notches: [
            notch("upper_notch", &entry.upper_notch)?,
            notch("lower_notch", &entry.lower_notch)?,
        ],
        throat: values.or_none("throat", entry.throat.as_ref())?,
        grip: plate + other,
        not_checked: Vec::new(),
        actions,
        preload: context.inputs.preload,
        category: spec.bolts.as_ref().and_then(|b| b.category),
        mu: context.inputs.mu,
        unseen: unseen(spec, &entry.ends, None, context.small),
        welds: spec.welds,
        annex: code.annex.clone(),
        fy_source: spec.code.fy_source,
        factors: code.factors,
        support,
        beam,
        bolt,
        grade,
    })
}

/// What the checks know of the geometry at a member end.
pub(super) fn expected(
    e: &SimpleJoint,
    entry: &SimpleJointEntry,
    frame: &Frame,
    content: &Content,
) -> Expected {
    let (a, d) = (frame.along, frame.depth);
    let across = 3 - a - d;
    let face = frame.origin[a] - frame.outward * e.centre();
    let x = |from_face: f64| face + frame.outward * from_face;
    let at = |x: f64, y: f64, z: f64| {
        let mut p = frame.origin;
        (p[a], p[across], p[d]) = (x, p[across] + y, p[d] + z);
        p
    };
    let fin = e.kind == SimpleKind::FinPlate;
    let half = 0.5 * e.beam.tw;
    // a fin plate lies on either side of the web
    let on = |side: f64| match fin {
        true => between(
            at(face, side * half, e.bottom),
            at(x(e.width), side * (half + e.thickness), e.top),
        ),
        false => {
            between(at(face, -0.5 * e.width, e.bottom), at(x(e.thickness), 0.5 * e.width, e.top))
        }
    };
    let is = |side: &f64| content.pieces.iter().any(|p| same_extent(&p.extent, &on(*side)));
    let side = [1.0, -1.0].into_iter().find(is).unwrap_or(1.0);
    let (label, support) = match fin {
        true => ("fin plate", e.beam.tw),
        false => ("header plate", e.support.thickness()),
    };
    let bolt = |column: f64, z: f64| match fin {
        true => ExpectedBolt {
            axis: across,
            at: at(x(column), side * half, z),
            plies: vec![e.thickness, support],
        },
        false => {
            ExpectedBolt { axis: a, at: at(face, column, z), plies: vec![e.thickness, support] }
        }
    };
    let start = |i: usize| x(e.beam_start + e.notches[i].length);
    let flanges =
        Flanges { depth: d, web: x(e.beam_start), starts: [(1.0, start(0)), (-1.0, start(1))] };
    Expected {
        bolts: e.rows.iter().flat_map(|z| e.columns.iter().map(move |c| bolt(*c, *z))).collect(),
        plates: vec![ExpectedPlate { label, extent: on(side) }],
        members: vec![
            ExpectedMember { role: entry.beam.clone(), flanges: Some(flanges) },
            ExpectedMember { role: entry.support.clone(), flanges: None },
        ],
        throats: vec![e.throat],
    }
}
