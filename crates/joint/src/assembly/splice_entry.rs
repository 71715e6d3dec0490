//! The `hand_checks` of a splice with cover plates, with their values.

use super::actions::PlaneActions;
use super::builder::Context;
use super::code_values::CodeValues;
use super::cover_splice::{CoverPlate, CoverSplice, InnerCovers, SpliceUse, SplicedMember};
use super::end_plate::unseen;
use super::error::AssemblyError;
use super::expected_parts::{
    Expected, ExpectedBolt, ExpectedMember, ExpectedPlate, Flanges, between,
};
use super::family_values::Values;
use super::member_ends::Frame;
use super::template::CoverSpliceEntry;
use crate::spec::expr::Expr;

/// The values of the template's `hand_checks`.
pub(super) fn cover_splice(
    context: &Context<'_>,
    entry: &CoverSpliceEntry,
    code: &CodeValues,
    actions: Vec<PlaneActions>,
) -> Result<CoverSplice, AssemblyError> {
    let (values, spec) = (Values(context), context.spec);
    let role = std::slice::from_ref(&entry.beam);
    let section = values.profile("beam", &entry.beam)?;
    let (bolt, grade) = values.bolts("flange_columns")?;
    let member = SplicedMember {
        flange_steel: values.steel(role, section.tf)?,
        web_steel: values.steel(role, section.tw)?,
        section,
        axis: 0.0,
        packs: [0.0; 2],
        inner_packs: 0.0,
        web_packs: 0.0,
    };
    let plate = |key: &str, [thickness, width]: &[Expr; 2], half: (&str, &Expr)| {
        let thickness = values.positive(key, thickness)?;
        Ok(CoverPlate {
            thickness,
            width: values.positive(key, width)?,
            length: 2.0 * values.positive(half.0, half.1)?,
            steel: values.steel(&entry.steel, thickness)?,
        })
    };
    let half = ("flange_cover", &entry.flange_cover);
    let inner = match &entry.inner {
        Some(sizes) if values.or_none("inner", Some(&sizes[0]))? > 0.0 => {
            let plate = plate("inner", sizes, half)?;
            let from = 0.5 * member.section.b - plate.width;
            Some(InnerCovers { plate, from })
        }
        _ => None,
    };
    let outer = plate("outer", &entry.outer, half)?;
    let web = plate("web", &entry.web, ("web_cover", &entry.web_cover))?;
    let below = inner.as_ref().map_or(0.0, |i: &InnerCovers| i.plate.thickness);
    Ok(CoverSplice {
        used: SpliceUse::Beam,
        left: member.clone(),
        gap: values.positive("gap", &entry.gap)?,
        flange_grip: outer.thickness + member.section.tf + below,
        web_grip: member.section.tw + 2.0 * web.thickness,
        outer,
        inner,
        web,
        web_middle: 0.0,
        flange_rows: values.list("flange_columns", &entry.flange_columns)?,
        gauges: vec![values.positive("gauge", &entry.gauge)?],
        web_rows: values.list("web_rows", &entry.web_rows)?,
        web_columns: values.rising("web_columns", &entry.web_columns)?,
        hole: values.hole(&entry.hole, &bolt)?,
        not_checked: Vec::new(),
        actions,
        preload: context.inputs.preload,
        category: spec.bolts.as_ref().and_then(|b| b.category),
        mu: context.inputs.mu,
        unseen: unseen(spec, &entry.ends, None, context.small),
        annex: code.annex.clone(),
        fy_source: spec.code.fy_source,
        factors: code.factors,
        right: member,
        bolt,
        grade,
    })
}

/// What the checks know of the geometry; `frame` has its origin in the middle of the gap.
pub(super) fn expected(e: &CoverSplice, entry: &CoverSpliceEntry, frame: &Frame) -> Expected {
    let (a, d) = (frame.along, frame.depth);
    let across = 3 - a - d;
    let at = |x: f64, y: f64, z: f64| {
        let mut p = frame.origin;
        (p[a], p[across], p[d]) = (p[a] + x, p[across] + y, p[d] + z);
        p
    };
    let s = &e.right.section;
    let (top, inside, web) = (0.5 * s.h, 0.5 * s.h - s.tf, 0.5 * s.tw);
    let mut out = Expected { throats: vec![0.0], ..Expected::default() };
    let mut plate = |label, p, q| out.plates.push(ExpectedPlate { label, extent: between(p, q) });
    for side in [1.0, -1.0] {
        let (outer, half) = (&e.outer, 0.5 * e.outer.length);
        let z = side * top;
        plate(
            "flange cover",
            at(-half, -0.5 * outer.width, z),
            at(half, 0.5 * outer.width, z + side * outer.thickness),
        );
        for y in [1.0, -1.0] {
            let Some(inner) = &e.inner else { continue };
            let (z, edge) = (side * inside, y * (inner.from + inner.plate.width));
            plate(
                "inner flange cover",
                at(-half, y * inner.from, z),
                at(half, edge, z - side * inner.plate.thickness),
            );
        }
        let (half, high) = (0.5 * e.web.length, 0.5 * e.web.width);
        plate(
            "web cover",
            at(-half, side * web, -high),
            at(half, side * (web + e.web.thickness), high),
        );
    }
    let through = |inner: &InnerCovers| inner.plate.thickness;
    let of_flange: Vec<f64> =
        [e.outer.thickness, s.tf].into_iter().chain(e.inner.as_ref().map(through)).collect();
    let of_web = vec![e.web.thickness, s.tw, e.web.thickness];
    for side in [1.0, -1.0] {
        for (x, level) in e.flange_rows.iter().flat_map(|x| [(x, 1.0), (x, -1.0)]) {
            out.bolts.extend(e.flange_columns().into_iter().map(|y| ExpectedBolt {
                axis: d,
                at: at(side * x, y, level * top),
                plies: of_flange.clone(),
            }));
        }
        for x in &e.web_columns {
            out.bolts.extend(e.web_rows.iter().map(|z| ExpectedBolt {
                axis: across,
                at: at(side * x, 0.0, *z),
                plies: of_web.clone(),
            }));
        }
        let start = frame.origin[a] + side * 0.5 * e.gap;
        let flanges = Flanges { depth: d, web: start, starts: [(1.0, start), (-1.0, start)] };
        out.members.push(ExpectedMember { role: entry.beam.clone(), flanges: Some(flanges) });
    }
    out
}
