//! Resistance of a base to compression: on its whole effective area, and under one flange.

use super::effective_area::{IArea, frame, ring};
use crate::check::{CheckId, Unit};
use crate::error::CheckError;
use crate::eurocode::concrete::{additional_width, bearing_strength};
use crate::eurocode::section::CrossSection;
use crate::formula::{Derivation, Formula, Number, Traced};
use crate::worked::Worked;
use bracket_joint::assembly::{BaseSection, ColumnBase};
use bracket_joint::catalog::IProfile;
use std::f64::consts::PI;
use std::ops::Deref;

/// A base whose column has an I section, which the rules of 6.2.8 are for.
#[derive(Clone, Copy)]
pub(super) struct IBase<'a> {
    /// The base.
    pub base: &'a ColumnBase,
    /// The section of its column.
    pub profile: &'a IProfile,
}

impl<'a> IBase<'a> {
    /// The base with its section; `None` for a hollow section.
    pub fn of(base: &'a ColumnBase) -> Option<Self> {
        match &base.section {
            BaseSection::I(profile) => Some(Self { base, profile }),
            BaseSection::Rectangular { .. } | BaseSection::Circular { .. } => None,
        }
    }
}

impl Deref for IBase<'_> {
    type Target = ColumnBase;

    fn deref(&self) -> &ColumnBase {
        self.base
    }
}

/// The column as a cross-section, with the steel at the thickness of its flange.
pub(super) fn cross_section(e: &IBase<'_>) -> CrossSection {
    let fy = e.flange_steel.fy;
    CrossSection { section: e.profile.into(), fy, gamma_m0: e.factors.gamma_m0 }
}

/// Distance of the centre of compression under a flange from the axis of the column \[mm\].
///
/// # Source
/// EN 1993-1-8:2005 6.2.8.1(2), Figure 6.18.
pub(super) fn z_c(e: &IBase<'_>) -> f64 {
    let p = e.profile;
    0.5 * (p.h - p.tf)
}

/// f_jd and c.
struct Bearing {
    f_jd: Worked,
    c: Formula,
}

impl Bearing {
    fn new(e: &ColumnBase) -> Self {
        let f_jd = bearing_strength(&e.foundation, e.concrete);
        let t = Traced::length("t", e.thickness);
        let f_y = Traced::stress("f_y", e.plate_steel.fy.mpa());
        let gamma = Traced::number("γ_M0", e.factors.gamma_m0);
        let c = additional_width(t, f_y, f_jd.traced(), gamma);
        Self { f_jd, c: Formula::new("c", c, Unit::Length) }
    }

    /// f_jd, then c.
    fn derivation(&self) -> Derivation {
        self.f_jd.derivation.clone().then(self.c.clone())
    }

    /// The area on a plate whose edge has this distance from the axis of the column.
    fn area(&self, e: &IBase<'_>, edge: f64) -> IArea {
        let p = e.profile;
        let (width, c) = (e.plate[1], self.c.value);
        IArea { section: [p.h, p.b, p.tw, p.tf], edge, width, c }
    }
}

fn named([l, b]: [f64; 2], names: [&'static str; 2]) -> Traced {
    Traced::length(names[0], l) * Traced::length(names[1], b)
}

/// The area on which the whole section presses. On an eccentric plate it is that of the narrower
/// side on both sides, so that its centre lies in the axis of the column.
fn effective_area(e: &ColumnBase, bearing: &Bearing) -> Traced {
    let edge = e.to_edge(1.0).min(e.to_edge(-1.0));
    let (plate, c) = ([2.0 * edge, e.plate[1]], bearing.c.value);
    match &e.section {
        BaseSection::I(profile) => {
            let area = bearing.area(&IBase { base: e, profile }, edge);
            let flanges = Traced::from(2.0) * named(area.flange(), ["l_f", "b_f"]);
            match area.web() {
                [length, _] if length > 0.0 => flanges + named(area.web(), ["l_w", "b_w"]),
                _ => flanges,
            }
        }
        BaseSection::Circular { d, t } => {
            let [outer, inner] = ring(*d, *t, plate, c);
            let square = |name, d| Traced::length(name, d).powi(2);
            Traced::number("π", PI) * (square("d_o", outer) - square("d_i", inner))
                / Traced::from(4.0)
        }
        BaseSection::Rectangular { size, t, .. } => {
            let [outer, inner] = frame(*size, *t, plate, c);
            named(outer, ["l_o", "b_o"]) - named(inner, ["l_i", "b_i"])
        }
    }
}

/// The same area \[mm²\].
pub(super) fn whole_area(e: &ColumnBase) -> f64 {
    effective_area(e, &Bearing::new(e)).value()
}

/// N_j,Rd under axial compression alone \[N\].
///
/// # Source
/// EN 1993-1-8:2005 6.2.8.2(1), 6.2.5.
pub(super) fn whole(e: &ColumnBase) -> Worked {
    let bearing = Bearing::new(e);
    let a_eff = Formula::new("A_eff", effective_area(e, &bearing), Unit::Area);
    let value = bearing.f_jd.traced() * a_eff.traced();
    let (clause, id) = ("EN 1993-1-8:2005 6.2.8.2, 6.2.5", CheckId::BaseCompression);
    let (c, area) = (bearing.c.value, a_eff.value);
    Worked::of(clause, id, "N_j,Rd", value, Unit::Force)
        .after(bearing.derivation().then(a_eff))
        .with("f_jd", bearing.f_jd.value, Unit::Stress)
        .with("c", c, Unit::Length)
        .with("A_eff", area, Unit::Area)
}

/// Area under the flange on a side \[mm²\].
pub(super) fn flange_area(e: &IBase<'_>, side: f64) -> f64 {
    let [l, b] = Bearing::new(e).area(e, e.to_edge(side)).flange();
    l * b
}

/// F_C,Rd under the flange on a side, beside the shear force `shear` in the column \[N\]; an error
/// for a column of class 4.
///
/// # Source
/// EN 1993-1-8:2005 6.2.8.3(3): the smaller of the concrete under the flange (6.2.6.9) and the
/// flange and web of the column in compression (6.2.6.7, M_c,Rd/(h − t_f)). The area under the web
/// is left out, 6.2.8.1(3).
pub(super) fn under_flange(
    e: &IBase<'_>,
    side: f64,
    shear: f64,
) -> Result<Worked, Box<CheckError>> {
    let bearing = Bearing::new(e);
    let area = named(bearing.area(e, e.to_edge(side)).flange(), ["l_eff", "b_eff"]);
    let concrete = Formula::new("F_C,pl,Rd", bearing.f_jd.traced() * area, Unit::Force);
    let moment = cross_section(e).bending_6_2_10(shear, 0.0).map_err(Box::new)?.value;
    let p = e.profile;
    let arm = Traced::length("h", p.h) - Traced::length("t_f", p.tf);
    let column = Traced::symbol("M_c,Rd", moment, Unit::Moment) / arm;
    let column = Formula::new("F_c,fc,Rd", column, Unit::Force);
    let value = concrete.traced().min(column.traced());
    let (clause, id) =
        ("EN 1993-1-8:2005 6.2.8.3, 6.2.6.9, 6.2.6.7", CheckId::BaseFlangeCompression);
    Ok(Worked::of(clause, id, "F_C,Rd", value, Unit::Force)
        .after(bearing.derivation().then(concrete).then(column)))
}
