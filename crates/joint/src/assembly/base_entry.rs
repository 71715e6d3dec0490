//! The `hand_checks` of a column base, with their values.

use super::actions::PlaneActions;
use super::assembly::Assembly;
use super::builder::Context;
use super::code_values::CodeValues;
use super::column_base::{BaseSection, BaseShear, ColumnBase};
use super::end_plate::unseen;
use super::error::AssemblyError;
use super::expected_parts::{
    Expected, ExpectedBolt, ExpectedMember, ExpectedPlate, Flanges, between,
};
use super::family_values::Values;
use super::foundation::Foundation;
use super::member_ends::Frame;
use super::template::ColumnBaseEntry;
use crate::catalog::{Section, Shape};
use crate::spec::expr::Expr;

/// Depth in the concrete over which an anchor stretches, in diameters. Source: EN 1993-1-8:2005
/// Table 6.2, note on L_b.
const EMBEDDED: f64 = 8.0;

/// The values of the template's `hand_checks`.
pub(super) fn column_base(
    context: &Context<'_>,
    entry: &ColumnBaseEntry,
    code: &CodeValues,
    (assembly, frames): (&Assembly, &[Frame]),
    actions: Vec<PlaneActions>,
) -> Result<ColumnBase, AssemblyError> {
    let (values, spec) = (Values(context), context.spec);
    let [frame] = frames else {
        return Err(values.wrong("ends", format!("{} member ends; give one", frames.len())));
    };
    let role = std::slice::from_ref(&entry.column);
    let section = section(&values, &entry.column)?;
    let [flange, web] = match &section {
        BaseSection::I(p) => [p.tf, p.tw],
        BaseSection::Rectangular { t, .. } | BaseSection::Circular { t, .. } => [*t; 2],
    };
    let (bolt, grade) = values.bolts("anchors")?;
    let foundation = foundation(&values, assembly)?;
    let thickness = values.positive("thickness", &entry.thickness)?;
    let flag = |key: &str, e: &Option<Expr>| e.as_ref().map_or(Ok(false), |e| values.truth(key, e));
    let plate = along_depth(foundation.plate, frame);
    let elastic_length = match &entry.elastic_length {
        Some(e) => values.positive("elastic_length", e)?,
        None => {
            EMBEDDED * bolt.d
                + foundation.grout
                + thickness
                + bolt.washer_thickness
                + 0.5 * bolt.nut_height
        }
    };
    Ok(ColumnBase {
        flange_steel: values.steel(role, flange)?,
        web_steel: values.steel(role, web)?,
        section,
        thickness,
        plate_steel: values.steel(&entry.steel, thickness)?,
        plate,
        offset: entry.offset.as_ref().map_or(Ok(0.0), |e| values.length("offset", e))?,
        foundation,
        rows: values.list("anchors", &entry.anchors)?,
        across: values.rising("anchor_y", &entry.anchor_y)?,
        hole: values.hole(&entry.hole, &bolt)?,
        elastic_length,
        flange_throat: values.or_none("flange_throat", entry.flange_throat.as_ref())?,
        web_throat: values.or_none("web_throat", entry.web_throat.as_ref())?,
        ends: spec.welds.ends,
        shear: BaseShear {
            anchors: flag("by_anchors", &entry.by_anchors)?,
            nib: flag("nib", &entry.nib)?,
        },
        anchorage_checked: flag("anchorage_checked", &entry.anchorage_checked)?,
        not_checked: Vec::new(),
        actions,
        unseen: unseen(spec, &entry.ends, None, context.small),
        annex: code.annex.clone(),
        fy_source: spec.code.fy_source,
        factors: code.factors,
        concrete: code.factors.concrete,
        bolt,
        grade,
    })
}

/// The section of the column.
fn section(values: &Values<'_, '_>, role: &str) -> Result<BaseSection, AssemblyError> {
    match values.section("column", role)? {
        Section::I(p) => Ok(BaseSection::I(Box::new(p.clone()))),
        Section::Shaped(p) => match p.shape {
            Shape::Rhs { h, b, t, outer, inner } => {
                Ok(BaseSection::Rectangular { size: [h, b], t, radii: [outer, inner] })
            }
            Shape::Chs { d, t } => Ok(BaseSection::Circular { d, t }),
            Shape::Angle { .. } | Shape::Channel { .. } => Err(values.wrong(
                "column",
                format!("{} is {}: no check knows its base", p.name, p.kind().words()),
            )),
        },
    }
}

/// The concrete of the first support that has some.
fn foundation(values: &Values<'_, '_>, assembly: &Assembly) -> Result<Foundation, AssemblyError> {
    let found = assembly.supports.iter().find_map(|s| s.ground.clone());
    found.ok_or_else(|| {
        let problem = "no support of the template has `ground`; a column base stands on concrete";
        values.wrong("kind", problem.into())
    })
}

/// Lengths along the depth of the column and across, of lengths in the order of the joint's axes.
fn along_depth([a, b]: [f64; 2], frame: &Frame) -> [f64; 2] {
    let first = (0..3).find(|k| *k != frame.along);
    if first == Some(frame.depth) { [a, b] } else { [b, a] }
}

/// What the checks know of the geometry; `frame` has its origin on the column's axis at the
/// underside of the plate.
pub(super) fn expected(e: &ColumnBase, entry: &ColumnBaseEntry, frame: &Frame) -> Expected {
    let (a, d) = (frame.along, frame.depth);
    let across = 3 - a - d;
    let at = |x: f64, y: f64, up: f64| {
        let mut p = frame.origin;
        p[a] += frame.outward * up;
        p[across] += y;
        p[d] += x;
        p
    };
    let [half, wide] = e.plate.map(|l| 0.5 * l);
    let plate = ExpectedPlate {
        label: "base plate",
        extent: between(at(e.offset - half, -wide, 0.0), at(e.offset + half, wide, e.thickness)),
    };
    let bolt = |(x, y): (f64, f64)| ExpectedBolt {
        axis: a,
        at: at(x, y, 0.5 * e.thickness),
        plies: vec![e.thickness],
    };
    let places = e.rows.iter().flat_map(|x| e.across.iter().map(|y| (*x, *y)));
    let start = at(0.0, 0.0, e.thickness)[a];
    let flanges = matches!(e.section, BaseSection::I(_)).then(|| Flanges {
        depth: d,
        web: start,
        starts: [(1.0, start), (-1.0, start)],
    });
    Expected {
        bolts: places.map(bolt).collect(),
        plates: vec![plate],
        members: vec![ExpectedMember { role: entry.column.clone(), flanges }],
        throats: vec![e.flange_throat, e.web_throat],
    }
}
