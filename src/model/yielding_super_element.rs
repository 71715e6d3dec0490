//! The static super-element that yields: von Mises at the 16 points where its linear stress has its extremes.
//!
//! Stress is linear in each of the 4 subtets and the yield set convex, so `‖dev σ‖ ≤ √(2/3) f_y` at their vertices holds
//! everywhere. As a saddle: minimise over face displacements v and multipliers `λ_i ∈ K⁶`, maximise over the stress
//! parameters σ, of `vᵀ(T σ − f) + Σ_i λ_iᵀ (h_i + B_i σ) − ½ σᵀ F σ`, with `h_i + B_i σ = (√(2/3) f_y, dev σ at point i)`.
//!
//! # Sign
//! Stationarity in σ is compatibility, `Tᵀv + Σ_i B_iᵀ λ_i = F σ`: the deviatoric part of λ_i points against the plastic
//! flow. The multiplier z of `λ_i ∈ K⁶` is `h_i + B_i σ`, the yield condition of the stress. Without flow (λ = 0) the
//! parameters are `F⁻¹Tᵀv` and the program is the elastic one, `T F⁻¹ Tᵀ` its stiffness. A body force adds its particular
//! stress σ_p: tractions on v, `dev σ_p` in h, and `−N_eᵀ∫C⁻¹σ_p` on the parameters.

use super::element_unknowns::{ElementUnknown, ElementUnknowns, YIELD_ROWS};
use super::super_element::{PARAMETERS, SuperElement, TRACTIONS};
use crate::math::mandel::deviator;

/// Points of an element where its yield condition is imposed: 4 in each subtet.
pub const YIELD_POINTS: usize = 16;

/// The element's own unknowns: a λ of 6 for each point (stage 2; point `4 k + p` is point p of subtet k), then the 30 stress
/// parameters (stage 1, maximised). `dofs` are its full face displacements, `radius` is √(2/3) f_y \[MPa\].
pub fn unknowns(element: &SuperElement, dofs: &[usize; TRACTIONS], radius: f64) -> ElementUnknowns {
    let particular = element.particular();
    let mut out = ElementUnknowns::default();
    let mut columns = Vec::with_capacity(YIELD_POINTS);
    for point in 0..YIELD_POINTS {
        let (k, p) = (point / 4, point % 4);
        columns.push(element.stress_columns(k, p).map(|s| deviator(&s)));
        out.cones.push(out.unknowns.len());
        let h = std::iter::once(radius).chain(deviator(&particular[k][p]));
        out.unknowns.extend(h.map(|q| ElementUnknown { stage: 2, q, ..ElementUnknown::default() }));
    }
    let (t, f) = (element.traction_matrix(), element.flexibility());
    for a in 0..PARAMETERS {
        let mut own: Vec<(usize, f64)> = Vec::with_capacity(5 * YIELD_POINTS + a + 1);
        for (point, column) in columns.iter().enumerate() {
            own.extend((0..5).map(|i| (YIELD_ROWS * point + 1 + i, column[a][i])).filter(|term| term.1 != 0.0));
        }
        own.extend((0..=a).map(|b| (YIELD_ROWS * YIELD_POINTS + b, -f[a][b])));
        out.unknowns.push(ElementUnknown {
            stage: 1,
            maximised: true,
            q: -element.particular_flexibility()[a],
            shared: dofs.iter().enumerate().map(|(i, &d)| (d, t[i][a])).collect(),
            own,
        });
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dense::Cholesky;
    use crate::math::mandel::{Isotropic, yield_radius};

    /// Eliminating the parameters with all λ at zero leaves the elastic element: its stiffness, the linear and the
    /// constant term of its body force. The yield condition is that of its stress.
    #[test]
    fn without_flow_it_is_the_elastic_element() {
        let corners = [[0.1, 0.0, 0.2], [2.0, 0.3, 0.0], [0.2, 1.7, -0.1], [0.3, 0.4, 2.2]];
        let material = Isotropic::new(210.0, 0.3);
        let element = SuperElement::new(corners, material, Some(([0.3, -0.2, 0.5], [0.1, 0.4, -2.0]))).expect("good");
        let own = unknowns(&element, &std::array::from_fn(|i| i), yield_radius(0.235));
        assert_eq!(own.unknowns.len(), YIELD_POINTS * YIELD_ROWS + PARAMETERS);
        let parameters = &own.unknowns[YIELD_POINTS * YIELD_ROWS..];
        let mut f = Box::new([[0.0; PARAMETERS]; PARAMETERS]);
        let mut t = [[0.0; TRACTIONS]; PARAMETERS];
        for (a, unknown) in parameters.iter().enumerate() {
            for &(row, x) in unknown.own.iter().filter(|x| x.0 >= YIELD_POINTS * YIELD_ROWS) {
                f[a][row - YIELD_POINTS * YIELD_ROWS] = -x;
                f[row - YIELD_POINTS * YIELD_ROWS][a] = -x;
            }
            unknown.shared.iter().for_each(|&(d, x)| t[a][d] = x);
        }
        let q: [f64; PARAMETERS] = std::array::from_fn(|a| parameters[a].q);
        let factor = Cholesky::new(f).expect("positive definite");
        // max over σ of σ·(Tᵀv + q) − ½ σ·Fσ
        let stiffness = element.stiffness();
        let largest = stiffness.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        for i in 0..TRACTIONS {
            let mut x: [f64; PARAMETERS] = std::array::from_fn(|a| t[a][i]);
            factor.solve(&mut x);
            for j in 0..TRACTIONS {
                let k: f64 = (0..PARAMETERS).map(|a| x[a] * t[a][j]).sum();
                assert!((k - stiffness[i][j]).abs() < 1e-11 * largest, "{i} {j}: {k} {}", stiffness[i][j]);
            }
        }
        let (linear, constant) = element.body_terms();
        let (tractions, c) = element.particular_terms();
        let mut x = q;
        factor.solve(&mut x);
        for j in 0..TRACTIONS {
            let more: f64 = (0..PARAMETERS).map(|a| x[a] * t[a][j]).sum();
            assert!((tractions[j] + more - linear[j]).abs() < 1e-11, "{j}");
        }
        let more: f64 = 0.5 * q.iter().zip(&x).map(|(a, b)| a * b).sum::<f64>();
        assert!((c + more - constant).abs() < 1e-11 * constant.abs(), "{c} {more} {constant}");

        let sigma: [f64; PARAMETERS] = std::array::from_fn(|a| (a as f64 * 0.7).sin());
        let stress = element.stress(&sigma);
        for point in 0..YIELD_POINTS {
            for i in 0..YIELD_ROWS {
                let row = YIELD_ROWS * point + i;
                let column = |u: &ElementUnknown| u.own.iter().filter(|t| t.0 == row).map(|t| t.1).sum::<f64>();
                let got: f64 =
                    own.unknowns[row].q + parameters.iter().zip(&sigma).map(|(u, s)| s * column(u)).sum::<f64>();
                let want = match i {
                    0 => yield_radius(0.235),
                    _ => deviator(&stress[point / 4][point % 4])[i - 1],
                };
                assert!((got - want).abs() < 1e-12, "point {point} row {i}: {got} {want}");
            }
        }
    }
}
