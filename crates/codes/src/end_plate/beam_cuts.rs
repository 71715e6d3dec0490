//! Cross-sections of the beam that its own checks cut, with the forces on them: at the plate, and
//! at the tip of a haunch.

use super::at_plate;
use crate::component_method::beam::EQUIVALENT;
use crate::formula::{Derivation, Formula, Traced};
use crate::subject::Part;
use crate::unit::Unit;
use bracket_joint::assembly::{EndPlate, PlaneActions, Rafter};
use bracket_joint::catalog::IProfile;
use bracket_joint::strength::Nominal;
use std::borrow::Cow;

/// A cross-section with its forces.
pub(super) struct Cut<'a> {
    /// Where it is.
    pub part: Part,
    /// Its section.
    pub profile: Cow<'a, IProfile>,
    /// Its yield strength.
    pub fy: Nominal,
    /// N, Vy, Vz \[N\] and T, My, Mz \[N mm\] in the axes of the section.
    pub at: [[f64; 3]; 2],
    /// Where section and forces come from.
    pub words: Derivation,
}

/// The cross-sections under the actions on the plate: one of a beam without a haunch.
pub(super) fn cuts<'a>(e: &'a EndPlate, a: &PlaneActions) -> Vec<Cut<'a>> {
    let at = a.at(1.0);
    let own = |part, at, words| {
        let (profile, fy) = (Cow::Borrowed(&e.beam), e.beam_steel.fy);
        Cut { part, profile, fy, at, words }
    };
    let Some(r) = at_plate::rafter(e) else {
        return vec![own(Part::Beam, at, Derivation::default())];
    };
    let tip = at_section(e, r, at);
    if r.haunch.is_none() {
        return vec![own(Part::Beam, tip.0, tip.1)];
    }
    let [[axial, vy, _], moments] = at;
    let plate = Cut {
        part: Part::HaunchedBeam,
        profile: at_plate::section(e),
        fy: at_plate::steel(e).fy,
        at: [[axial, vy, at_plate::web_shear(e, at)], moments],
        words: Derivation::from(EQUIVALENT)
            .then("V_Ed with what inclined flanges add to the web, nothing that they relieve"),
    };
    vec![plate, own(Part::HaunchTip, tip.0, tip.1)]
}

/// Forces on the section of the beam where its haunch ends, or at the plate without one, in the
/// axes of the beam; torsion and weak-axis moment are added up by their sizes.
///
/// # Source
/// Equilibrium of the piece between the plate and the section, on which no further load acts.
fn at_section(e: &EndPlate, r: &Rafter, at: [[f64; 3]; 2]) -> ([[f64; 3]; 2], Derivation) {
    let [[axial, vy, vz], [torsion, my, mz]] = at;
    let (sin, cos) = r.slope.sin_cos();
    let [x, z] = point(e, r);
    let force = |symbol: &'static str, value| Traced::force(symbol, value);
    let (n, v) = (force("N", axial), force("V_z", vz));
    let [s, c] = [("sin α", sin), ("cos α", cos)].map(|(name, of)| Traced::number(name, of));
    let along = n.clone() * c.clone() + v.clone() * s.clone();
    let across = v.clone() * c - n.clone() * s;
    let moment = Traced::symbol("M_y", my, Unit::Moment) + v * Traced::length("x", x)
        - n * Traced::length("z", z);
    let along = Formula::new("N_Ed", along, Unit::Force);
    let across = Formula::new("V_Ed", across, Unit::Force);
    let moment = Formula::new("M_Ed", moment, Unit::Moment);
    let (t, weak) = (torsion.abs() + (vy * z).abs(), mz.abs() + (vy * x).abs());
    let forces = [along.value, vy, across.value];
    let moments = [t * cos + weak * sin.abs(), moment.value, weak * cos + t * sin.abs()];
    let words = "N, V_z and M_y act at the plate; the section lies x from it and z above the \
                 middle of its depth, with no load between them";
    ([forces, moments], Derivation::from(words).then(along).then(across).then(moment))
}

/// Where the axis of the beam meets the section at the tip of the haunch, or the plate without one:
/// distance from the plate and z from the middle of the depth \[mm\].
pub(super) fn point(e: &EndPlate, r: &Rafter) -> [f64; 2] {
    let ((sin, cos), half) = (r.slope.sin_cos(), 0.5 * e.beam.h);
    match &r.haunch {
        None => [0.0, 0.5 * r.depth - half / cos],
        Some(h) => {
            // along the lower face of the beam, then half of its depth across
            let face = 0.5 * r.depth - e.beam.h / cos;
            [h.length * cos - half * sin, face + h.length * sin + half * cos]
        }
    }
}
