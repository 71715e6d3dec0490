//! Fillet welds: EN 1993-1-8:2005 4.5.

use super::yielding::plastic;
use crate::check::{Check, Status, Topic, Unit, number as n, within};
use crate::worked::Worked;
use bracket_joint::strength::{Design, Nominal, WeldSteel};

/// Least throat of a fillet weld \[mm\], EN 1993-1-8:2005 4.5.2(2).
pub const LEAST_THROAT: f64 = 3.0;

/// Strength of the weaker part joined, and its correlation factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeldedSteel {
    /// Ultimate strength of the weaker part.
    pub fu: Nominal,
    /// β_w, Table 4.1.
    pub beta_w: f64,
    /// γ_M2.
    pub gamma_m2: f64,
}

/// Stresses on the throat section of a fillet weld \[MPa\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThroatStress {
    /// Normal to the throat.
    pub sigma_perp: f64,
    /// Shear in the throat, across the weld.
    pub tau_perp: f64,
    /// Shear in the throat, along the weld.
    pub tau_par: f64,
}

/// Utilisation of a fillet weld by the directional method, to be at most 1.
///
/// `√(σ⊥² + 3 (τ⊥² + τ∥²)) ≤ f_u/(β_w γ_M2)` and `σ⊥ ≤ 0.9 f_u/γ_M2`.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(6), formula 4.1.
pub fn directional(stress: &ThroatStress, steel: &WeldedSteel) -> Worked {
    let s = stress;
    let equivalent = (s.sigma_perp.powi(2) + 3.0 * (s.tau_perp.powi(2) + s.tau_par.powi(2))).sqrt();
    let allowed = steel.fu.mpa() / (steel.beta_w * steel.gamma_m2);
    let normal = 0.9 * steel.fu.mpa() / steel.gamma_m2;
    let value = (equivalent / allowed).max(s.sigma_perp.abs() / normal);
    let formula = format!(
        "max(√(σ⊥² + 3 (τ⊥² + τ∥²)) β_w γ_M2/f_u, σ⊥ γ_M2/(0.9 f_u)) = max({}/{}, {}/{})",
        n(equivalent),
        n(allowed),
        n(s.sigma_perp.abs()),
        n(normal)
    );
    Worked::new("EN 1993-1-8:2005 4.5.3.2(6)", DIRECTIONAL, value, Unit::Number, formula)
        .with("σ_eq", equivalent, Unit::Stress)
        .with("f_u/(β_w γ_M2)", allowed, Unit::Stress)
        .with("0.9 f_u/γ_M2", normal, Unit::Stress)
}

/// Stresses of the two fillet welds of a plate under a force across the plate's end, `length` of
/// each weld under it, and a shear stress along them \[N, mm, MPa\].
///
/// `σ⊥ = τ⊥ = F/(2 √2 a l)`: the throats are at 45° to the force.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(4) and (5), Figure 4.5.
pub fn across_and_along(force: f64, length: f64, throat: f64, tau_par: f64) -> ThroatStress {
    let across = force / (2.0 * 2f64.sqrt() * throat * length);
    ThroatStress { sigma_perp: across, tau_perp: across, tau_par }
}

/// Design resistance of a fillet weld per length by the simplified method, `a f_vw,d` \[N/mm\];
/// `throat` a \[mm\].
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.3(2) and (3), formulas 4.3 and 4.4.
fn shear(throat: f64, steel: &WeldedSteel) -> f64 {
    throat * steel.fu.mpa() / (3f64.sqrt() * steel.beta_w * steel.gamma_m2)
}

/// Design shear strength of a fillet weld on its throat, `f_vw,d = f_u/(√3 β_w γ_M2)`.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.3(3), formula 4.4.
pub fn shear_strength(steel: &WeldSteel, gamma_m2: f64) -> Design {
    let WeldSteel { fu, beta_w } = *steel;
    Design::new(shear(1.0, &WeldedSteel { fu, beta_w, gamma_m2 }))
}

/// Design resistance of a fillet weld per length by the simplified method \[N/mm\]; `throat` a
/// \[mm\].
///
/// `F_w,Rd = a f_u/(√3 β_w γ_M2)`.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.3(2) and (3), formulas 4.3 and 4.4.
pub fn simplified(throat: f64, steel: &WeldedSteel) -> Worked {
    let value = shear(throat, steel);
    let formula = format!(
        "F_w,Rd = a f_u/(√3 β_w γ_M2) = {} · {}/(√3 · {} · {})",
        n(throat),
        n(steel.fu.mpa()),
        n(steel.beta_w),
        n(steel.gamma_m2)
    );
    Worked::new("EN 1993-1-8:2005 4.5.3.3", SIMPLIFIED, value, Unit::ForcePerLength, formula)
}

/// Design resistance of a fillet weld per length under a force across it by the directional method
/// \[N/mm\]; `throat` a \[mm\].
///
/// σ⊥ = τ⊥ = F/(√2 a), so that `F_w,Rd = a f_u/(√2 β_w γ_M2)`, √(3/2) times the value of the
/// simplified method.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(6); σ⊥ ≤ 0.9 f_u/γ_M2 never decides, because β_w ≥ 0.56.
pub fn transverse(throat: f64, steel: &WeldedSteel) -> Worked {
    let value = throat * steel.fu.mpa() / (2f64.sqrt() * steel.beta_w * steel.gamma_m2);
    let formula = format!(
        "F_w,Rd = a f_u/(√2 β_w γ_M2) = {} · {}/(√2 · {} · {})",
        n(throat),
        n(steel.fu.mpa()),
        n(steel.beta_w),
        n(steel.gamma_m2)
    );
    let title = "fillet weld across the force, directional method";
    Worked::new("EN 1993-1-8:2005 4.5.3.2(6)", title, value, Unit::ForcePerLength, formula)
}

/// Force per length of a fillet weld between a plate and the part that it stands on \[N/mm\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineForce {
    /// Across the weld, in the plane of the plate or normal to it; ≥ 0.
    pub across: f64,
    /// Along the weld; ≥ 0.
    pub along: f64,
}

impl LineForce {
    /// F_w,Ed, the resultant \[N/mm\].
    pub fn resultant(self) -> f64 {
        self.across.hypot(self.along)
    }
}

/// Title of a fillet weld that the simplified method decides.
pub const SIMPLIFIED: &str = "fillet weld, simplified method";
/// Title of a fillet weld that the directional method decides, because the simplified one fails.
pub const DIRECTIONAL: &str = "fillet weld, directional method";

/// Design resistance of a fillet weld per length against the resultant of a force \[N/mm\], by
/// either method: the simplified one where it suffices, else the directional one. The formula has
/// both.
///
/// `F_w,Rd = F_w,Ed a f_u/(β_w γ_M2)/√(2 F_⊥² + 3 F_∥²)` by the directional method, with σ⊥ = τ⊥ =
/// F_⊥/(√2 a) and τ∥ = F_∥/a.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.1(1): the method of 4.5.3.2 or that of 4.5.3.3 may be used.
pub fn either_method(force: LineForce, throat: f64, steel: &WeldedSteel) -> Worked {
    let (plain, resultant) = (simplified(throat, steel), force.resultant());
    let by_direction = if force.along == 0.0 {
        transverse(throat, steel)
    } else {
        let across = force.across / (2f64.sqrt() * throat);
        let stress =
            ThroatStress { sigma_perp: across, tau_perp: across, tau_par: force.along / throat };
        let value = resultant / directional(&stress, steel).value;
        let formula = format!(
            "F_w,Rd = F_w,Ed a f_u/(β_w γ_M2 √(2 F_⊥² + 3 F_∥²)) = {} · {} · {}/({} · {} · √(2 · \
             {}² + 3 · {}²))",
            n(resultant),
            n(throat),
            n(steel.fu.mpa()),
            n(steel.beta_w),
            n(steel.gamma_m2),
            n(force.across),
            n(force.along)
        );
        Worked::new("", "", value, Unit::ForcePerLength, formula)
    };
    let (title, value, clause) = if within(resultant, plain.value) {
        (SIMPLIFIED, plain.value, "EN 1993-1-8:2005 4.5.3.3")
    } else {
        (DIRECTIONAL, by_direction.value, "EN 1993-1-8:2005 4.5.3.2(6)")
    };
    let formula = format!("{} (4.5.3.3); {} (4.5.3.2)", plain.formula, by_direction.formula);
    Worked { clause, title, formula, steps: Vec::new(), value, unit: Unit::ForcePerLength }
        .with("F_w,Rd, 4.5.3.3", plain.value, Unit::ForcePerLength)
        .with("F_w,Rd, 4.5.3.2", by_direction.value, Unit::ForcePerLength)
}

/// Throat of each of two fillet welds that are as strong as the plate between them in tension
/// \[mm\].
///
/// Each weld takes half of `t f_y/γ_M0` across its length, σ⊥ = τ⊥, so that
/// `a ≥ t (f_y/γ_M0) β_w γ_M2/(√2 f_u)`.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(6) with the stresses of a double fillet under transverse tension.
pub fn full_strength_throat(
    thickness: f64,
    fy: Nominal,
    gamma_m0: f64,
    steel: &WeldedSteel,
) -> Worked {
    let value = plastic(thickness, fy, gamma_m0) * steel.beta_w * steel.gamma_m2
        / (2f64.sqrt() * steel.fu.mpa());
    let formula = format!(
        "a = t (f_y/γ_M0) β_w γ_M2/(√2 f_u) = {} · {}/{} · {} · {}/(√2 · {})",
        n(thickness),
        n(fy.mpa()),
        n(gamma_m0),
        n(steel.beta_w),
        n(steel.gamma_m2),
        n(steel.fu.mpa())
    );
    Worked::new(
        "EN 1993-1-8:2005 4.5.3.2(6)",
        "throat of a double fillet weld of full strength",
        value,
        Unit::Length,
        formula,
    )
}

/// Least throat and least effective length of a fillet weld.
///
/// # Source
/// EN 1993-1-8:2005 4.5.2(2): a ≥ 3 mm; 4.5.1(2): l_eff ≥ max(30 mm, 6 a).
pub fn least_size(subject: &str, throat: f64, effective_length: f64) -> [Check; 2] {
    let topic = Topic::Welds;
    [
        Check::at_least(
            (topic, subject),
            ("EN 1993-1-8:2005 4.5.2(2)", "least throat"),
            "a",
            (LEAST_THROAT, "3 mm"),
            throat,
            Status::Failed,
        ),
        Check::at_least(
            (topic, subject),
            ("EN 1993-1-8:2005 4.5.1(2)", "least effective length"),
            "l_eff",
            ((6.0 * throat).max(30.0), "max(30 mm, 6 a)"),
            effective_length,
            Status::Failed,
        ),
    ]
}
