//! A sloping beam with or without a haunch, as the hand checks of an end plate see it.

use super::builder::Context;
use super::error::AssemblyError;
use super::family_values::Values;
use super::template::{HaunchEntry, RafterEntry};
use crate::spec::expr::Expr;
use crate::strength::Strength;
use serde::Serialize;
use std::f64::consts::FRAC_PI_4;

/// A beam whose axis may slope against the normal of its end plate. Lengths in mm, angles in rad.
///
/// z of the checks is measured from the middle of the depth at the plate, and the actions on the
/// plate act there: N normal to the plate, Vz along it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rafter {
    /// Angle of the beam's axis with the normal of the plate; positive: the beam rises out of the
    /// joint.
    pub slope: f64,
    /// Depth at the plate, along it, between the outer faces of the upper flange of the beam and of
    /// the lower flange, which is that of the haunch where there is one.
    pub depth: f64,
    /// The haunch below the beam.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub haunch: Option<Haunch>,
}

/// A haunch of a web and a flange below the beam. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Haunch {
    /// Length from the plate to the tip, along the lower flange of the beam.
    pub length: f64,
    /// Angle between the haunch flange and the beam's axis \[rad\].
    pub angle: f64,
    /// Thickness of the haunch flange.
    pub flange: f64,
    /// Width of the haunch flange.
    pub width: f64,
    /// Thickness of the haunch web.
    pub web: f64,
    /// Steel of the haunch at the thickness of its flange.
    pub steel: Strength,
    /// Throat of the fillet welds on both sides of the haunch web to the flange of the beam; 0:
    /// butt welds.
    pub seam_throat: f64,
    /// Thickness of the stiffeners on both sides of the beam's web at the tip; 0: none.
    pub stiffener: f64,
}

impl Rafter {
    /// Angle of the lower flange at the plate with the normal of the plate \[rad\]; positive: it
    /// rises out of the joint.
    pub fn lower_slope(&self) -> f64 {
        self.slope + self.haunch.as_ref().map_or(0.0, |h| h.angle)
    }
}

/// The values of a template's entry.
pub(super) fn rafter(context: &Context<'_>, entry: &RafterEntry) -> Result<Rafter, AssemblyError> {
    let v = Values(context);
    let angle = |key: &str, e: &Expr| -> Result<f64, AssemblyError> {
        let angle = v.angle(key, e)?;
        match angle.abs() < FRAC_PI_4 {
            true => Ok(angle),
            false => {
                Err(v.wrong(key, format!("{} deg; it must be below 45 deg", angle.to_degrees())))
            }
        }
    };
    let haunch = |h: &HaunchEntry| -> Result<Haunch, AssemblyError> {
        let flange = v.positive("rafter.haunch.flange", &h.flange)?;
        Ok(Haunch {
            length: v.positive("rafter.haunch.length", &h.length)?,
            angle: angle("rafter.haunch.angle", &h.angle)?,
            flange,
            width: v.positive("rafter.haunch.width", &h.width)?,
            web: v.positive("rafter.haunch.web", &h.web)?,
            steel: context.inputs.strength(context.spec, &h.steel, flange)?,
            seam_throat: v.or_none("rafter.haunch.seam_throat", h.seam_throat.as_ref())?,
            stiffener: v.or_none("rafter.haunch.stiffener", h.stiffener.as_ref())?,
        })
    };
    let there =
        |h: &&HaunchEntry| h.when.as_ref().map_or(Ok(true), |w| v.truth("rafter.haunch.when", w));
    let wanted = entry.haunch.as_ref().map(|h| there(&h)).transpose()?.unwrap_or(false);
    Ok(Rafter {
        slope: angle("rafter.slope", &entry.slope)?,
        depth: v.positive("rafter.depth", &entry.depth)?,
        haunch: entry.haunch.as_ref().filter(|_| wanted).map(haunch).transpose()?,
    })
}
