//! Target element sizes as gmsh fields.
//!
//! Near a plate or bolt the size is that of the part, and it grows with the distance from the part.
//! In a member the size is that of the part near the joint, and it grows along the span up to a
//! limit. At the imprinted footprints of loads and supports, whose edges concentrate stress, it is
//! a fraction of the footprint's width. For limit analysis it is half the thickness where plates
//! turn about hinges. Only box and formula fields are used, because gmsh 4.8 supports them too.

use super::flat::Bounds;
use super::footprint::{Rectangle, footprints};
use super::hinges;
use super::scene::Scene;
use crate::assembly::assembly::PartRole;
use bracket_base::math::vec3::V3;
use std::fmt::Write;

/// Rule for the variation of the target sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeRule {
    /// Factor on every part's size.
    pub factor: f64,
    /// Growth of the size per mm of distance from a plate or bolt.
    pub growth: f64,
    /// Growth of a member's size per mm of distance from the joint.
    pub span_growth: f64,
    /// Number of elements across the shorter side of an imprinted footprint (at factor 1).
    pub across_footprint: f64,
    /// Largest size in a member's span, as a multiple of its size at the joint.
    pub span_limit: f64,
    /// Largest size between pulled bolts and toes, over the thickness of the plate
    /// ([`super::hinges`]), and twice the sizes elsewhere; `None`: the size of the part.
    pub at_hinges: Option<f64>,
}

/// Value of [`SizeRule::at_hinges`] in limit analysis. Below it the lower bound gains nothing
/// further (docs/theory.md, section 15).
pub const HALF_THICKNESS: f64 = 0.5;

impl Default for SizeRule {
    fn default() -> Self {
        SizeRule {
            factor: 1.0,
            growth: 0.5,
            across_footprint: 2.0,
            span_growth: 0.1,
            span_limit: 2.0,
            at_hinges: None,
        }
    }
}

/// Factor on all sizes of a joint with hinges: most elements stand at the hinges, and later meshes
/// are finer where the first one shows plastic flow.
const BESIDE_HINGES: f64 = 2.0;

/// A size above that of every field \[mm\].
const FREE: f64 = 1e6;

/// Distance over which a box field grows \[mm\]; beyond it the members' sizes govern.
const REACH: f64 = 1000.0;

/// The script lines that define the fields and use their minimum as the background field.
pub fn fields(scene: &Scene, rule: &SizeRule) -> String {
    let zones = rule.at_hinges.map_or_else(Vec::new, |_| hinges::zones(scene));
    let coarse = SizeRule { factor: BESIDE_HINGES * rule.factor, ..*rule };
    let rule = if zones.is_empty() { rule } else { &coarse };
    let mut out = String::new();
    let mut id = 0;
    let mut chosen: Vec<String> = Vec::new();
    let joint = scene
        .bodies
        .iter()
        .filter(|b| b.part.role != PartRole::Member)
        .map(|b| b.bounds)
        .reduce(Bounds::union);
    let mut coarsest = 0.0f64;
    for body in &scene.bodies {
        let size = (body.part.size * rule.factor).min(widest(&body.whole));
        match (body.part.role, joint) {
            (PartRole::Member, Some(joint)) => {
                let limit = size * rule.span_limit;
                let d = distance(&joint);
                let (g, rise) = (rule.span_growth, limit - size);
                // min(g D, rise), written with an absolute value
                let formula = format!("{size} + 0.5*({g}*{d} + {rise} - Fabs({g}*{d} - {rise}))");
                let _ = writeln!(
                    out,
                    "Field[{}] = MathEval; Field[{}].F = \"{formula}\";",
                    id + 1,
                    id + 1
                );
                let (lo, hi) = (body.bounds.min, body.bounds.max);
                box_field(
                    &mut out,
                    id + 2,
                    0.0,
                    FREE,
                    lo.map(|c| c - 1e-3),
                    hi.map(|c| c + 1e-3),
                    0.0,
                );
                let _ = writeln!(
                    out,
                    "Field[{}] = Max; Field[{}].FieldsList = {{{}, {}}};",
                    id + 3,
                    id + 3,
                    id + 1,
                    id + 2
                );
                chosen.push((id + 3).to_string());
                id += 3;
                coarsest = coarsest.max(limit);
            }
            _ => {
                let outside = size + rule.growth * REACH;
                box_field(&mut out, id + 1, size, outside, body.bounds.min, body.bounds.max, REACH);
                chosen.push((id + 1).to_string());
                id += 1;
                coarsest = coarsest.max(size);
            }
        }
    }
    for footprint in footprints(scene) {
        // elements larger than the footprint have no meaning, and the mesher fails on them
        let size = footprint.width() * (rule.factor / rule.across_footprint).min(1.0);
        let Rectangle { axis, at, min, max } = footprint;
        let (mut lo, mut hi) = (min, max);
        lo[axis] = at;
        hi[axis] = at;
        id += 1;
        box_field(&mut out, id, size, size + rule.growth * REACH, lo, hi, REACH);
        chosen.push(id.to_string());
    }
    if let Some(share) = rule.at_hinges {
        for zone in zones {
            let size = share * zone.thickness * rule.factor;
            id += 1;
            box_field(&mut out, id, size, size + rule.growth * REACH, zone.min, zone.max, REACH);
            chosen.push(id.to_string());
        }
    }
    id += 1;
    let _ = writeln!(out, "Field[{id}] = Min; Field[{id}].FieldsList = {{{}}};", chosen.join(", "));
    let _ = writeln!(out, "Background Field = {id};");
    let _ = writeln!(out, "Mesh.MeshSizeMin = 0;");
    let _ = writeln!(out, "Mesh.MeshSizeMax = {coarsest};");
    out
}

/// Largest element size of a part \[mm\]: twice its middle dimension, the width of a plate or the
/// head of a bolt. Larger sizes change nothing, and the mesher crashes on much larger ones.
fn widest(whole: &Bounds) -> f64 {
    let mut sides: [f64; 3] = std::array::from_fn(|k| whole.max[k] - whole.min[k]);
    sides.sort_by(f64::total_cmp);
    2.0 * sides[1]
}

fn box_field(out: &mut String, id: usize, inside: f64, outside: f64, min: V3, max: V3, reach: f64) {
    let _ = writeln!(
        out,
        "Field[{id}] = Box; Field[{id}].VIn = {inside}; Field[{id}].VOut = {outside};"
    );
    for (k, axis) in ["X", "Y", "Z"].iter().enumerate() {
        let _ = writeln!(
            out,
            "Field[{id}].{axis}Min = {}; Field[{id}].{axis}Max = {};",
            min[k], max[k]
        );
    }
    let _ = writeln!(out, "Field[{id}].Thickness = {reach};");
}

/// Formula for the distance from a box.
fn distance(b: &Bounds) -> String {
    let part = |k: usize, name: &str| {
        let (c, h) = (0.5 * (b.min[k] + b.max[k]), 0.5 * (b.max[k] - b.min[k]));
        // max(|x − c| − h, 0)
        format!("((Fabs({name} - ({c})) - {h} + Fabs(Fabs({name} - ({c})) - {h}))*0.5)^2")
    };
    format!("Sqrt({} + {} + {})", part(0, "x"), part(1, "y"), part(2, "z"))
}
