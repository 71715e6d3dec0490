//! An end plate as the joint of the component method.

use super::at_plate;
use super::bolt_checks::bolt_tension;
use super::clamped_plates::WASHERS;
use super::column_forces::ColumnForces;
use super::doubler::{doubler_fault, doubler_width};
use super::national_annex;
use crate::component_method::joint::{Bolts, Column, EndPlateJoint, Plate};
use crate::eurocode::bolt_length;
use bracket_joint::assembly::EndPlate;

/// The joint of the component method, with the transformation parameter β.
pub(super) fn component_joint(e: &EndPlate, beta: f64) -> EndPlateJoint {
    let column = e.column.as_ref().map(|c| {
        let counts = c.doubler > 0.0 && doubler_fault(c).is_none();
        Column {
            section: (&c.section).into(),
            fy: c.steel.fy.mpa(),
            above: c.above,
            below: c.below,
            stiffener: c.stiffener,
            stiffener_throat: c.stiffener_throat,
            doublers: u32::from(counts),
            doubler_width: if counts { doubler_width(c) } else { 0.0 },
            longitudinal: ColumnForces::given(c).map_or(0.0, |f| f.longitudinal(c)),
        }
    });
    EndPlateJoint {
        column,
        beam: at_plate::beam(e),
        plate: Plate {
            thickness: e.thickness,
            width: e.width,
            bottom: e.bottom,
            top: e.top,
            fy: e.plate_steel.fy.mpa(),
        },
        bolts: Bolts {
            gauge: e.gauge,
            rows: e.rows.clone(),
            tension: bolt_tension(e, e.factors.gamma_m2),
            stress_area: e.bolt.stress_area,
            elongation: bolt_length::elongation_length(&e.bolt, e.grip, WASHERS),
            washer: None,
            always_prying: e.always_prying,
        },
        beta,
        young: e.beam_steel.e,
        gamma_m0: e.factors.gamma_m0,
        gamma_m1: e.factors.gamma_m1,
        triangular: national_annex::triangular(e),
    }
}
