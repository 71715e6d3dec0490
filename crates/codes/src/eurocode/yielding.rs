//! Yielding of steel: design strengths, and resistances in proportion to them.

use crate::formula::Number;
use bracket_base::math::vec3::V3;
use bracket_joint::catalog::IProfile;
use bracket_joint::strength::{Design, Nominal};

/// Greatest nominal f_y \[MPa\], EN 1993-1-8:2005 1.1(1): S235 to S460.
pub const STRONGEST: f64 = 460.0;

/// Plastic resistance `S f_y/γ_M`: of an area \[mm²\] in N, of a section modulus \[mm³\] in N mm.
///
/// # Source
/// EN 1993-1-1:2005 6.2.3(2), 6.2.4(2), 6.2.5(2).
pub fn plastic<N: Number>(measure: N, fy: N, gamma: N) -> N {
    measure * fy / gamma
}

/// Design yield strength `f_y/γ_M0`.
///
/// # Source
/// EN 1993-1-1:2005 6.1(1).
pub fn yield_strength(fy: Nominal, gamma_m0: f64) -> Design {
    Design::new(plastic(1.0, fy.mpa(), gamma_m0))
}

/// Design strength of a part with holes in analyses that do not reduce its net section by a check:
/// the lesser of `f_y/γ_M0` and `0.9 f_u/γ_M2`.
///
/// # Source
/// EN 1993-1-1:2005 6.2.3(2), as strengths in place of forces.
pub fn net_strength(fyd: Design, fu: Nominal, gamma_m2: f64) -> Design {
    Design::new(fyd.mpa().min(plastic(0.9, fu.mpa(), gamma_m2)))
}

/// Shear that yields by von Mises where `tension` yields in tension: `tension/(√3 γ_M)`, in the
/// unit of `tension`.
///
/// # Source
/// EN 1993-1-1:2005 6.2.1(5) and 6.2.6(2).
pub fn in_shear<N: Number>(tension: N, gamma: N) -> N {
    tension / (N::from(3.0).sqrt() * gamma)
}

/// Plastic shear resistance \[N\] of a shear area A_v \[mm²\], `V_pl,Rd = A_v f_y/(√3 γ_M0)`.
///
/// # Source
/// EN 1993-1-1:2005 6.2.6(2), formula 6.18.
pub fn plastic_shear<N: Number>(shear_area: N, fy: N, gamma_m0: N) -> N {
    in_shear(shear_area * fy, gamma_m0)
}

/// Plastic resistances of a section to each action alone: to N, Vy, Vz \[N\] and T, My, Mz
/// \[N mm\]; `fyd` = f_y/γ_M0.
///
/// # Source
/// EN 1993-1-1:2005 6.2.3, 6.2.5, 6.2.6, 6.2.7: A f_y, A_v f_y/√3, W_pl f_y; torsion by St. Venant
/// at first yield of the flange, I_t/t_f · f_y/√3. A_v across the web is A − h_w t_w, along it
/// h_w t_w.
pub fn each_action_alone(p: &IProfile, fyd: Design) -> [V3; 2] {
    let (area, web) = (1e2 * p.area, (p.h - 2.0 * p.tf) * p.tw);
    let design = fyd.mpa();
    let shear = in_shear(design, 1.0);
    [
        [area * design, (area - web) * shear, web * shear],
        [
            p.torsion_constant() / p.tf.max(p.tw) * shear,
            1e3 * p.w_pl_y * design,
            1e3 * p.w_pl_z * design,
        ],
    ]
}
