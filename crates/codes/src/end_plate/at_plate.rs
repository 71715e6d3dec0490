//! The beam where it meets the end plate: its flanges, its section and what the actions on the
//! plate put into it, with the slope and the haunch of a rafter.

use crate::component_method::joint::Beam;
use crate::component_method::sloped_end::{EndFlange, HaunchedEnd, SlopedEnd};
use crate::subject::Part;
use bracket_joint::assembly::{EndPlate, Haunch, Rafter, Way};
use bracket_joint::catalog::IProfile;
use bracket_joint::strength::Strength;
use std::borrow::Cow;

/// A flange at the plate. Lengths in mm.
pub(super) struct PlateFlange<'a> {
    /// The part.
    pub part: Part,
    /// Width.
    pub width: f64,
    /// Thickness across the flange.
    pub thickness: f64,
    /// Web between its outstands.
    pub web: f64,
    /// Root radius beside that web.
    pub root: f64,
    /// Angle with the normal of the plate \[rad\].
    pub slope: f64,
    /// Steel.
    pub steel: &'a Strength,
}

impl PlateFlange<'_> {
    /// Whether the flange is normal to the plate, so that its welds stand at right angles.
    pub fn is_normal(&self) -> bool {
        self.slope == 0.0
    }
}

/// The rafter whose slope, depth or haunch makes it another thing than a beam normal to the plate.
pub(super) fn rafter(e: &EndPlate) -> Option<&Rafter> {
    let differs = |r: &&Rafter| r.slope != 0.0 || r.haunch.is_some() || r.depth != e.beam.h;
    e.rafter.as_deref().filter(differs)
}

/// The haunch of the rafter.
pub(super) fn haunch(e: &EndPlate) -> Option<&Haunch> {
    rafter(e)?.haunch.as_ref()
}

/// A flange of the beam at the plate: below that of the haunch where there is one.
pub(super) fn flange(e: &EndPlate, way: Way) -> PlateFlange<'_> {
    let slope = rafter(e).map_or(0.0, |r| r.slope);
    match haunch(e).filter(|_| way == Way::Down) {
        Some(h) => PlateFlange {
            part: Part::HaunchFlange,
            width: h.width,
            thickness: h.flange,
            web: h.web,
            root: 0.0,
            slope: slope + h.angle,
            steel: &h.steel,
        },
        None => PlateFlange {
            part: Part::BeamFlange,
            width: e.beam.b,
            thickness: e.beam.tf,
            web: e.beam.tw,
            root: e.beam.r,
            slope,
            steel: &e.beam_steel,
        },
    }
}

/// The flanges at the plate that differ from each other.
pub(super) fn flanges(e: &EndPlate) -> Vec<PlateFlange<'_>> {
    let ways = if haunch(e).is_some() { &[Way::Up, Way::Down][..] } else { &[Way::Up] };
    ways.iter().map(|way| flange(e, *way)).collect()
}

/// Thickness of the thinner and of the thicker web at the plate \[mm\].
pub(super) fn webs(e: &EndPlate) -> [f64; 2] {
    let (own, other) = (e.beam.tw, haunch(e).map_or(e.beam.tw, |h| h.web));
    [own.min(other), own.max(other)]
}

/// The steel at the plate with the lower yield strength.
pub(super) fn steel(e: &EndPlate) -> &Strength {
    match haunch(e) {
        Some(h) if h.steel.fy < e.beam_steel.fy => &h.steel,
        _ => &e.beam_steel,
    }
}

/// z of the lower and the upper face of the beam's own lower flange at the plate above a haunch
/// \[mm\].
pub(super) fn inner_flange(e: &EndPlate) -> Option<[f64; 2]> {
    haunch(e)?;
    let (r, b) = (rafter(e)?, &e.beam);
    let face = |below: f64| 0.5 * r.depth - below / r.slope.cos();
    Some([face(b.h), face(b.h - b.tf)])
}

/// The end of the beam at the plate, without a shear force.
pub(super) fn beam(e: &EndPlate) -> Beam {
    Beam {
        section: section(e).as_ref().into(),
        fy: steel(e).fy.mpa(),
        flange_throat: e.flange_throat,
        web_throat: e.web_throat,
        shear: 0.0,
        sloped: sloped_end(e),
    }
}

/// Slope and haunch for the component method.
fn sloped_end(e: &EndPlate) -> Option<SlopedEnd> {
    let r = rafter(e)?;
    let [upper, lower] = [Way::Up, Way::Down].map(|way| flange(e, way));
    let outstand = |f: &PlateFlange<'_>| (0.5 * (f.width - f.web) - f.root) / f.thickness;
    let end =
        |f: &PlateFlange<'_>| EndFlange { thickness: f.thickness, width: f.width, slope: f.slope };
    let haunch = inner_flange(e).map(|inner_flange| HaunchedEnd {
        inner_flange,
        panel: panel(e, inner_flange, end(&lower).along()),
        outstand: outstand(&upper).max(outstand(&lower)),
        area: 1e2 * e.beam.area,
    });
    Some(SlopedEnd { depth: r.depth, upper: end(&upper), lower: end(&lower), haunch })
}

/// The larger clear depth of the two webs: of the beam across its axis, of the haunch along the
/// plate \[mm\].
fn panel(e: &EndPlate, [inner, _]: [f64; 2], lower: f64) -> f64 {
    let own = e.beam.h - 2.0 * (e.beam.tf + e.beam.r);
    own.max(inner - lower + 0.5 * e.depth())
}

/// The section of the beam at the plate: its own, or the equivalent one of a haunched beam.
pub(super) fn section(e: &EndPlate) -> Cow<'_, IProfile> {
    let Some(r) = rafter(e).filter(|r| r.haunch.is_some()) else { return Cow::Borrowed(&e.beam) };
    let [upper, lower] = [Way::Up, Way::Down].map(|way| flange(e, way));
    let normal = |f: &PlateFlange<'_>| f.thickness * f.slope.cos();
    let along = |f: &PlateFlange<'_>| f.thickness / f.slope.cos();
    let tf = normal(&upper).min(normal(&lower));
    // the lever arm of the flanges is the real one
    let h = r.depth - 0.5 * (along(&upper) + along(&lower)) + tf;
    let (b, [tw, _]) = (upper.width.min(lower.width), webs(e));
    let outline = IProfile { h, b, tw, tf, r: 0.0, r_detailing: None, i_t: None, ..e.beam.clone() };
    let (i_y, i_z) = (outline.outline_i_y(), outline.outline_i_z());
    Cow::Owned(IProfile {
        area: 1e-2 * outline.outline_area(),
        i_y: 1e-4 * i_y,
        i_z: 1e-4 * i_z,
        w_el_y: 1e-3 * i_y / (0.5 * h),
        w_pl_y: 1e-3 * outline.outline_w_pl_y(),
        w_el_z: 1e-3 * i_z / (0.5 * b),
        w_pl_z: 1e-3 * outline.outline_w_pl_z(),
        ..outline
    })
}

/// Shear force of the web at the plate, no less than Vz: inclined flanges add their part along the
/// plate where it acts with Vz, and relieve nothing \[N\]. Sloped flanges carry M/z ± N/2 normal to
/// the plate, and that times the tangent of their slope along it.
pub(super) fn web_shear(e: &EndPlate, [[axial, _, vz], [_, my, _]]: [[f64; 3]; 2]) -> f64 {
    let Some(r) = rafter(e) else { return vz.abs() };
    let (upper, lower) = (r.slope.tan(), r.lower_slope().tan());
    let bending = my / beam(e).lever();
    let flanges = bending * (upper - lower) + 0.5 * axial * (upper + lower);
    vz.abs().max((vz - flanges).abs())
}
