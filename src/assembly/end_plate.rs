//! What the hand checks of a code see of a bolted end plate: the template's `hand_checks` with its values.

use super::error::AssemblyError;
use super::inputs::Inputs;
use super::scope::Scope;
use super::template::Template;
use crate::catalog::{BoltGrade, BoltSize, IProfile};
use crate::spec::connection::ConnectionSpec;
use crate::spec::expr::{Expr, ExprError};
use serde::{Deserialize, Serialize};

/// The entry of a template: which of its names are what the code means. Lengths unless said.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EndPlateEntry {
    /// Member role of the column.
    pub column: String,
    /// Member role of the beam.
    pub beam: String,
    /// Whose steel the plate has: the first of these that the spec gives (`plate` or a member role).
    pub steel: Vec<String>,
    /// Thickness of the plate.
    pub thickness: Expr,
    /// Width of the plate.
    pub width: Expr,
    /// Lower edge of the plate, from the beam's axis.
    pub bottom: Expr,
    /// Upper edge of the plate, from the beam's axis.
    pub top: Expr,
    /// Distance of the two columns of bolts.
    pub gauge: Expr,
    /// The list parameter that holds the rows, from the beam's axis.
    pub rows: String,
    /// Diameter of the holes.
    pub hole: Expr,
    /// From the beam's axis to the upper end of the column.
    pub column_above: Expr,
    /// From the beam's axis to the lower end of the column.
    pub column_below: Expr,
    /// Thickness of the stiffeners of the column level with both beam flanges; zero for none.
    pub stiffener: Expr,
    /// Throat of the fillet welds of the beam's flanges; absent: butt welds.
    pub flange_throat: Option<Expr>,
    /// Throat of the fillet welds of the beam's web; absent: butt welds.
    pub web_throat: Option<Expr>,
    /// β of EN 1993-1-8 5.3(7), a number: 0 equal and opposite moments on both sides, 1 a beam on one side alone.
    pub beta: Expr,
}

/// Nominal strengths of a steel at the thickness it is used in.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Strength {
    /// Grade.
    pub grade: String,
    /// Yield strength \[MPa\].
    pub fy: f64,
    /// Ultimate strength \[MPa\].
    pub fu: f64,
    /// Young's modulus \[MPa\].
    pub e: f64,
    /// β_w of fillet welds, where the code has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub beta_w: Option<f64>,
}

/// A bolted end plate between a beam and the flange of a column. Lengths in mm, z from the beam's axis, up positive.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EndPlate {
    /// Section of the column.
    pub column: IProfile,
    /// Section of the beam.
    pub beam: IProfile,
    /// Steel of the column at the thickness of its flange.
    pub column_steel: Strength,
    /// Steel of the beam at the thickness of its flange.
    pub beam_steel: Strength,
    /// Steel of the plate.
    pub plate_steel: Strength,
    /// Bolts.
    pub bolt: BoltSize,
    /// Their grade.
    pub grade: BoltGrade,
    /// Thickness of the plate.
    pub thickness: f64,
    /// Width of the plate.
    pub width: f64,
    /// Lower edge of the plate.
    pub bottom: f64,
    /// Upper edge of the plate.
    pub top: f64,
    /// Distance of the two columns of bolts.
    pub gauge: f64,
    /// Rows, in the order of the spec.
    pub rows: Vec<f64>,
    /// Diameter of the holes.
    pub hole: f64,
    /// From the beam's axis to the upper end of the column.
    pub column_above: f64,
    /// From the beam's axis to the lower end of the column.
    pub column_below: f64,
    /// Thickness of the stiffeners of the column; 0 for none.
    pub stiffener: f64,
    /// Throat of the welds of the beam's flanges; 0 for butt welds.
    pub flange_throat: f64,
    /// Throat of the welds of the beam's web; 0 for butt welds.
    pub web_throat: f64,
    /// β.
    pub beta: f64,
    /// γ_M0.
    pub gamma_m0: f64,
    /// γ_M1.
    pub gamma_m1: f64,
    /// γ_M2.
    pub gamma_m2: f64,
}

/// The values of a template's `hand_checks`, if it has them.
pub fn end_plate(
    spec: &ConnectionSpec,
    template: &Template,
    inputs: &Inputs<'_>,
    scope: &Scope,
) -> Result<Option<EndPlate>, AssemblyError> {
    let Some(entry) = &template.hand_checks else { return Ok(None) };
    let wrong = |key: &str, problem: String| AssemblyError::TemplateEntry { at: format!("hand_checks.{key}"), problem };
    let named = |key: &str, result: Result<f64, ExprError>| {
        result.map_err(|cause| AssemblyError::Template { at: format!("hand_checks.{key}"), cause })
    };
    // every length, with the least it may be
    let length = |key: &'static str, e: &Expr, least: Option<f64>| {
        let value = named(key, scope.length(e))?;
        match least {
            Some(least) if value < least => {
                let limit = if least == f64::MIN_POSITIVE { "above 0".into() } else { format!("at least {least} mm") };
                Err(wrong(key, format!("{value} mm; it must be {limit}")))
            }
            _ => Ok(value),
        }
    };
    let (positive, some) = (Some(f64::MIN_POSITIVE), Some(0.0));
    let profile = |key: &str, role: &str| {
        let found = inputs.profile(role);
        found.cloned().ok_or_else(|| wrong(key, format!("there is no member `{role}`")))
    };
    let (column, beam) = (profile("column", &entry.column)?, profile("beam", &entry.beam)?);
    let Some((bolt, grade)) = inputs.bolt else {
        return Err(wrong("rows", "the template has no `bolts`".into()));
    };
    let rows = scope.list(&entry.rows).map_err(|problem| wrong("rows", problem))?;
    let thickness = length("thickness", &entry.thickness, positive)?;
    let throat = |key, e: &Option<Expr>| e.as_ref().map_or(Ok(0.0), |e| length(key, e, some));
    let beta = named("beta", scope.number(&entry.beta))?;
    if !(0.0..=2.0).contains(&beta) {
        return Err(wrong("beta", format!("{beta} does not lie between 0 and 2")));
    }
    let (bottom, top) = (length("bottom", &entry.bottom, None)?, length("top", &entry.top, None)?);
    if bottom >= top {
        return Err(wrong("top", format!("the upper edge {top} mm is not above the lower edge {bottom} mm")));
    }
    let role = |r: &String| std::slice::from_ref(r).to_vec();
    let [gamma_m0, gamma_m1, gamma_m2] = inputs.partial_factors();
    Ok(Some(EndPlate {
        column_steel: inputs.strength(spec, &role(&entry.column), column.tf)?,
        beam_steel: inputs.strength(spec, &role(&entry.beam), beam.tf)?,
        plate_steel: inputs.strength(spec, &entry.steel, thickness)?,
        column,
        beam,
        bolt: bolt.clone(),
        grade: grade.clone(),
        thickness,
        width: length("width", &entry.width, positive)?,
        bottom,
        top,
        gauge: length("gauge", &entry.gauge, positive)?,
        rows,
        hole: length("hole", &entry.hole, Some(bolt.d))?,
        column_above: length("column_above", &entry.column_above, positive)?,
        column_below: length("column_below", &entry.column_below, positive)?,
        stiffener: length("stiffener", &entry.stiffener, some)?,
        flange_throat: throat("flange_throat", &entry.flange_throat)?,
        web_throat: throat("web_throat", &entry.web_throat)?,
        beta,
        gamma_m0,
        gamma_m1,
        gamma_m2,
    }))
}
