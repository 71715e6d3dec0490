//! Resistances of one bolt and of the plates that it clamps.

use super::bolt_rows::{end_distance, pitches};
use super::clamped_plates::{ClampedPlate, clamped_plates};
use super::slip_checks::hole;
use crate::assembly::EndPlate;
use crate::checks::check::{Check, Topic};
use crate::checks::eurocode::bearing::{Along, Bearing};
use crate::checks::eurocode::bolts::{shear_resistance, tension_resistance};
use crate::checks::eurocode::punching::{mean_diameter, punching_resistance};
use crate::checks::worked::Worked;

/// Bearing resistance of a plate at one bolt under a vertical force.
pub(super) fn bearing(e: &EndPlate, along: Along, plate: &ClampedPlate) -> Worked {
    let place = Bearing {
        along,
        e2: 0.5 * (plate.width - e.gauge),
        p2: e.gauge,
        hole: hole(e).0,
        d: e.bolt.d,
        d0: e.hole,
        thickness: plate.thickness,
        fu: plate.fu,
        fub: e.grade.fub,
    };
    place.resistance(e.factors.gamma_m2)
}

/// Resistances of one bolt in tension, shear, punching and bearing, as information.
pub(super) fn resistances(e: &EndPlate) -> Vec<Check> {
    let (b, g, gamma) = (&e.bolt, &e.grade, e.factors.gamma_m2);
    let subject = format!("{} {}", b.size, g.grade);
    let tension = tension_resistance(b, g, gamma);
    let shear = shear_resistance(b, g, gamma);
    let mut out = Vec::new();
    out.push(tension.information(Topic::Bolts, subject.clone()));
    out.push(shear.information(Topic::Bolts, format!("{subject}, thread in the shear plane")));
    let end = end_distance(e, e.bottom, e.top);
    for plate in clamped_plates(e) {
        out.push(
            punching_resistance(mean_diameter(b), plate.thickness, plate.fu, gamma)
                .information(Topic::Bolts, plate.name),
        );
        let at = |along, words: &str| {
            let subject = format!("{}, {words}, vertical force", plate.name);
            bearing(e, along, &plate).information(Topic::Bolts, subject)
        };
        // the ends of the column are far away
        out.extend((plate.name == "end plate").then(|| at(Along::End { e1: end }, "end bolt")));
        out.extend(pitches(e).map(|[p1, _]| at(Along::Inner { p1 }, "inner bolt")));
    }
    out
}

/// F_t,Rd of a bolt with the punching of the plates that it clamps \[N\].
pub(super) fn bolt_tension(e: &EndPlate, gamma: f64) -> f64 {
    let dm = mean_diameter(&e.bolt);
    let punching = |p: ClampedPlate| punching_resistance(dm, p.thickness, p.fu, gamma).value;
    let tension = tension_resistance(&e.bolt, &e.grade, gamma).value;
    clamped_plates(e).into_iter().map(punching).fold(tension, f64::min)
}
