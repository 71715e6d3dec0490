//! The static super-element that yields: von Mises at the 16 points where its linear stress has its
//! extremes.
//!
//! Stress is linear in each of the 4 subtets and the yield set is convex, so `‖dev σ‖ ≤ √(2/3) f_y`
//! at their vertices implies it everywhere. Saddle form: minimise over face displacements v and
//! maximise over the stress parameters σ the form `vᵀ(T σ − f) − ½ σᵀ F σ`, with
//! `(√(2/3) f_y, dev σ at point i) ∈ K⁶`; F = 0 in limit analysis.
//!
//! # Sign
//! Stationarity in σ is compatibility, `Tᵀv + Σ_i B_iᵀ z_i = F σ`: the deviatoric part of a
//! multiplier z_i points against the plastic flow. Without plastic flow the parameters are `F⁻¹Tᵀv`
//! and the program is the elastic one with stiffness `T F⁻¹ Tᵀ`. A body force adds its particular
//! stress σ_p: tractions on v, `dev σ_p` in the offsets of the points, and `−N_eᵀ∫C⁻¹σ_p` on the
//! parameters.

use crate::elements::columns::Columns;
use crate::elements::super_element::{PARAMETERS, SuperElement, TRACTIONS};
use crate::elements::yielding_element::{Shape, YieldingElement};
use bracket_base::math::mandel::deviator;

/// Points of an element where its yield condition is imposed: 4 in each subtet.
pub const YIELD_POINTS: usize = 16;

/// Stress parameters per unit of the program's normalised parameters, chosen so that the largest
/// entry of `dev σ` over the yield radius is 1.
pub fn parameter_unit(element: &SuperElement, radius: f64) -> f64 {
    let columns = (0..YIELD_POINTS).flat_map(|point| element.stress_columns(point / 4, point % 4));
    radius / columns.flat_map(|s| deviator(&s)).fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()))
}

/// The element with its face displacements in `columns`; `radius` is √(2/3) f_y \[MPa\], `elastic`
/// keeps its flexibility.
pub fn element(
    element: &SuperElement,
    columns: &Columns,
    radius: f64,
    elastic: bool,
) -> YieldingElement {
    let unit = parameter_unit(element, radius);
    let shape = Shape::Stress;
    let mut data = Vec::with_capacity(shape.len(columns.unknowns.len()));
    let t = element.traction_matrix();
    for a in 0..PARAMETERS {
        let column: [f64; TRACTIONS] = std::array::from_fn(|i| unit * t[i][a]);
        data.extend(columns.row(&column));
    }
    let f = element.flexibility();
    for a in 0..PARAMETERS {
        data.extend((a..PARAMETERS).map(|b| if elastic { unit * unit * f[b][a] } else { 0.0 }));
    }
    let particular = element.particular();
    let mut h = Vec::with_capacity(6 * YIELD_POINTS);
    for point in 0..YIELD_POINTS {
        let (k, p) = (point / 4, point % 4);
        let deviators = element.stress_columns(k, p).map(|s| deviator(&s));
        for i in 0..5 {
            data.extend(deviators.iter().map(|d| unit / radius * d[i]));
        }
        h.push(1.0);
        h.extend(deviator(&particular[k][p]).map(|x| x / radius));
    }
    let q = match elastic {
        true => element.particular_flexibility().iter().map(|x| -unit * x).collect(),
        false => vec![0.0; PARAMETERS],
    };
    let maps = match columns.terms {
        None => element.map_numbers(unit, radius),
        Some(_) => Vec::new(),
    };
    YieldingElement {
        shape,
        columns: columns.unknowns.clone(),
        data,
        maps,
        q,
        h,
        inner_stiffness: Vec::new(),
    }
}
