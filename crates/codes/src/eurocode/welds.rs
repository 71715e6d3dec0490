//! Fillet welds: EN 1993-1-8:2005 4.5.

use crate::check::{Check, CheckId, Status, Topic, within};
use crate::formula::{Derivation, Formula, Number, Traced};
use crate::subject::Part;
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::spec::welds::WeldEnds;
use bracket_joint::strength::{Design, Nominal, Strength, WeldSteel};

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
    let n = Traced::from;
    let across = Traced::stress("σ⊥", stress.sigma_perp);
    let in_throat = Traced::stress("τ⊥", stress.tau_perp).powi(2)
        + Traced::stress("τ∥", stress.tau_par).powi(2);
    let equivalent = (across.clone().powi(2) + n(3.0) * in_throat).sqrt();
    let equivalent = equivalent.named("σ_eq", Unit::Stress);
    let allowed = steel.f_u() / (steel.beta_w() * steel.gamma_m2());
    let normal = n(0.9) * steel.f_u() / steel.gamma_m2();
    let numbers = [equivalent.value(), allowed.value(), normal.value()];
    let value = (equivalent.clone() / allowed).max(across.abs() / normal);
    let worked = Worked::of(
        "EN 1993-1-8:2005 4.5.3.2(6)",
        CheckId::WeldDirectional,
        "",
        value,
        Unit::Number,
    )
    .after(Formula::new("σ_eq", equivalent, Unit::Stress));
    let symbols = ["σ_eq", "f_u/(β_w γ_M2)", "0.9 f_u/γ_M2"];
    let steps = symbols.into_iter().zip(numbers);
    steps.fold(worked, |w, (symbol, value)| w.with(symbol, value, Unit::Stress))
}

/// Forces per length of the joint of a plate with a fillet weld on either side of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairForce {
    /// n, along the plate and normal to what it stands on, either sign \[N/mm\].
    pub normal: f64,
    /// q, across the welds, normal to the plate, either sign \[N/mm\].
    pub across: f64,
    /// l, along the welds, either sign \[N/mm\].
    pub along: f64,
    /// m, a couple about the line of the welds, either sign \[N mm/mm\].
    pub couple: f64,
}

/// Stresses σ⊥, τ⊥ and τ∥ on the throat of one fillet weld \[MPa\], from its force per length
/// normal to the surface that a plate stands on, across and along \[N/mm\].
///
/// `σ⊥ = (n + q)/(√2 a)`, `τ⊥ = (n − q)/(√2 a)`, `τ∥ = l/a`, n in tension positive, q positive
/// where it pulls the plate away from this weld; the throat is at 45° to both plates.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(4) and (5), Figure 4.5: the stresses on the section of the throat.
pub fn throat_stresses<N: Number>([n, q, l]: [N; 3], throat: N) -> [N; 3] {
    let across = N::from(2.0).sqrt() * throat.clone();
    [(n.clone() + q.clone()) / across.clone(), (n - q) / across, l / throat]
}

/// Force per length of the more loaded weld of a pair normal to the surface that the plate stands
/// on, `n/2 + m/t` of n and m ≥ 0; `thickness` t is the lever arm of the couple.
fn more_loaded<N: Number>(normal: N, couple: N, thickness: N) -> N {
    normal / N::from(2.0) + couple / thickness
}

/// Utilisation of the fillet welds on both sides of a plate by the directional method, to be at
/// most 1; `thickness` t of the plate and `throat` a of each weld \[mm\].
///
/// Each weld takes n/2 ± m/t, q/2 and l/2. The largest value of all signs is taken: q pulls the
/// plate away from one weld and pushes it on the other, and which of them has more of n is open.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(6) with the stresses of [`throat_stresses`]; the couple of two parallel
/// forces at the faces of the plate is this program's. Throats lie beyond the faces, so that the
/// real lever arm is larger.
pub fn directional_pair(
    force: &PairForce,
    thickness: f64,
    throat: f64,
    steel: &WeldedSteel,
) -> Worked {
    let line =
        |name: &'static str, value: f64| Traced::symbol(name, value.abs(), Unit::ForcePerLength);
    let (t, a) = (Traced::length("t", thickness), Traced::length("a", throat));
    let couple = Traced::force("m", force.couple.abs());
    let normal = more_loaded(line("n", force.normal), couple, t);
    let normal = Formula::new("n_w", normal, Unit::ForcePerLength);
    let across = line("q", force.across) / Traced::from(2.0);
    let across = Formula::new("q_w", across, Unit::ForcePerLength);
    let along = line("l", force.along) / Traced::from(2.0);
    let of = |q: Traced| {
        let stresses = throat_stresses([normal.traced(), q, along.clone()], a.clone());
        let [sigma_perp, tau_perp, tau_par] = stresses.clone().map(|s| s.value());
        let worked = directional(&ThroatStress { sigma_perp, tau_perp, tau_par }, steel);
        let lines = ["σ⊥", "τ⊥", "τ∥"].into_iter().zip(stresses);
        let lines = lines.map(|(symbol, s)| Formula::new(symbol, s, Unit::Stress).into());
        let forces = [&normal, &across].map(|f| f.clone().into());
        worked.after(Derivation { lines: forces.into_iter().chain(lines).collect() })
    };
    let [opens, closes] = [of(across.traced()), of(-across.traced())];
    if closes.value > opens.value { closes } else { opens }
}

/// Design resistance of a fillet weld per length by the simplified method \[N/mm\]; `throat` a
/// \[mm\].
///
/// `F_w,Rd = a f_u/(√3 β_w γ_M2)`.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.3(2) and (3), formulas 4.3 and 4.4.
pub fn simplified(throat: f64, steel: &WeldedSteel) -> Worked {
    let value = steel.per_length(throat, 3.0);
    Worked::of(
        "EN 1993-1-8:2005 4.5.3.3",
        CheckId::WeldSimplified,
        "F_w,Rd",
        value,
        Unit::ForcePerLength,
    )
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
    let value = steel.per_length(throat, 2.0);
    let id = CheckId::WeldAcross;
    Worked::of("EN 1993-1-8:2005 4.5.3.2(6)", id, "F_w,Rd", value, Unit::ForcePerLength)
}

/// The same under a force along a plate that leans by `slope` θ \[rad\] against the normal of
/// what it stands on, with a weld on either side.
///
/// The throat halves the angle ψ between the two parts: σ⊥ = F sin(ψ/2)/a and τ⊥ = F cos(ψ/2)/a, so
/// that √(σ⊥² + 3 τ⊥²) = F √(2 + cos ψ)/a. The weld at the sharper angle, ψ = 90° − θ, decides:
/// `F_w,Rd = a f_u/(√(2 + sin θ) β_w γ_M2)`.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(6), 4.3.2.1 for 60° to 120°; σ⊥ ≤ 0.9 f_u/γ_M2 never decides there,
/// because β_w ≥ 0.61.
pub fn transverse_inclined(throat: f64, slope: f64, steel: &WeldedSteel) -> Worked {
    let value = Traced::length("a", throat) * steel.f_u()
        / (inclination(slope).sqrt() * steel.beta_w() * steel.gamma_m2());
    let id = CheckId::WeldAcross;
    Worked::of("EN 1993-1-8:2005 4.5.3.2(6)", id, "F_w,Rd", value, Unit::ForcePerLength)
}

/// 2 + sin θ of [`transverse_inclined`]; 2 at a right angle.
fn inclination(slope: f64) -> Traced {
    match slope == 0.0 {
        true => Traced::from(2.0),
        false => Traced::from(2.0) + Traced::number("sin θ", slope.abs().sin()),
    }
}

/// Design resistance of a fillet weld per length, `a f_u/(√n β_w γ_M2)` \[N/mm\]: n = 3 in shear, 2
/// under a force across the weld.
fn per_length<N: Number>(throat: N, n: f64, f_u: N, beta_w: N, gamma_m2: N) -> N {
    throat * f_u / (N::from(n).sqrt() * beta_w * gamma_m2)
}

/// Design shear strength of a fillet weld on its throat, `f_vw,d = f_u/(√3 β_w γ_M2)`.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.3(3), formula 4.4.
pub fn shear_strength(steel: &WeldSteel, gamma_m2: f64) -> Design {
    Design::new(per_length(1.0, 3.0, steel.fu.mpa(), steel.beta_w, gamma_m2))
}

impl WeldedSteel {
    /// What a steel gives its fillet welds; `None` for grades without β_w.
    pub fn of(steel: &Strength, gamma_m2: f64) -> Option<Self> {
        let WeldSteel { fu, beta_w } = steel.of_welds()?;
        Some(Self { fu, beta_w, gamma_m2 })
    }

    /// [`per_length`] of a throat.
    fn per_length(&self, throat: f64, n: f64) -> Traced {
        per_length(Traced::length("a", throat), n, self.f_u(), self.beta_w(), self.gamma_m2())
    }

    fn f_u(&self) -> Traced {
        Traced::stress("f_u", self.fu.mpa())
    }

    fn beta_w(&self) -> Traced {
        Traced::number("β_w", self.beta_w)
    }

    fn gamma_m2(&self) -> Traced {
        Traced::number("γ_M2", self.gamma_m2)
    }
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
        let line =
            |name: &'static str, value: f64| Traced::symbol(name, value, Unit::ForcePerLength);
        let root = Traced::from(2.0) * line("F_⊥", force.across).powi(2)
            + Traced::from(3.0) * line("F_∥", force.along).powi(2);
        let of = line("F_w,Ed", resultant) * Traced::length("a", throat) * steel.f_u()
            / (steel.beta_w() * steel.gamma_m2() * root.sqrt());
        // the same as the utilisation gives, but for rounding
        let formula = Formula { value, ..Formula::new("F_w,Rd", of, Unit::ForcePerLength) };
        Worked { value, derivation: formula.into(), ..transverse(throat, steel) }
    };
    let (id, value, clause) = if within(resultant, plain.value) {
        (CheckId::WeldSimplified, plain.value, "EN 1993-1-8:2005 4.5.3.3")
    } else {
        (CheckId::WeldDirectional, by_direction.value, "EN 1993-1-8:2005 4.5.3.2(6)")
    };
    let both = [("F_w,Rd, 4.5.3.3", plain.value), ("F_w,Rd, 4.5.3.2", by_direction.value)];
    let derivation = Derivation::from("4.5.3.3:")
        .followed_by(plain.derivation)
        .then("4.5.3.2:")
        .followed_by(by_direction.derivation);
    let (steps, unit) = (Vec::new(), Unit::ForcePerLength);
    let worked = Worked { clause, id, derivation, steps, value, unit };
    both.into_iter().fold(worked, |w, (symbol, value)| w.with(symbol, value, Unit::ForcePerLength))
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
    full_strength_throat_inclined(thickness, fy, gamma_m0, (0.0, steel))
}

/// The same for a plate that leans by `slope` θ \[rad\] against the normal of what it stands on:
/// `a ≥ t (f_y/γ_M0) β_w γ_M2 √(2 + sin θ)/(2 f_u)`.
///
/// # Source
/// [`transverse_inclined`].
pub fn full_strength_throat_inclined(
    thickness: f64,
    fy: Nominal,
    gamma_m0: f64,
    (slope, steel): (f64, &WeldedSteel),
) -> Worked {
    let (t, f_y) = (Traced::length("t", thickness), Traced::stress("f_y", fy.mpa()));
    let needed = t * f_y / Traced::number("γ_M0", gamma_m0) * steel.beta_w() * steel.gamma_m2();
    let value = match slope == 0.0 {
        true => needed / (Traced::from(2.0).sqrt() * steel.f_u()),
        false => needed * inclination(slope).sqrt() / (Traced::from(2.0) * steel.f_u()),
    };
    let id = CheckId::ThroatFullStrength;
    Worked::of("EN 1993-1-8:2005 4.5.3.2(6)", id, "a", value, Unit::Length)
}

/// Effective length of a single run of a fillet weld \[mm\], `length` long, with its `throat`
/// \[mm\]; negative where the run is shorter than its ends.
///
/// # Source
/// EN 1993-1-8:2005 4.5.1(1): l − 2 a, or l where the weld is full-size up to its ends.
pub fn effective_run(ends: WeldEnds, length: f64, throat: f64) -> Formula {
    let l = Traced::length("l", length);
    let effective = match ends {
        WeldEnds::AllRound => l,
        WeldEnds::Returned | WeldEnds::Open => l - Traced::from(2.0) * Traced::length("a", throat),
    };
    Formula::new("l_eff", effective, Unit::Length)
}

/// Effective length of all fillet welds of a flange \[mm\], of its width b, the web t_w, the root
/// radius r and the throat a: outside along its width, inside up to the root fillets.
///
/// # Source
/// EN 1993-1-8:2005 4.5.1(1). A weld that is full-size round the tips has its ends at the root
/// fillets alone; each loses a leg √2 a, more than the throat that the code asks.
pub fn flange_run(ends: WeldEnds, [b, t_w, r, a]: [Traced; 4]) -> Traced {
    let n = Traced::from;
    let all = n(2.0) * b - t_w - n(2.0) * r;
    match ends {
        WeldEnds::AllRound => all,
        WeldEnds::Returned => all - n(2.0) * n(2.0).sqrt() * a,
        WeldEnds::Open => all - n(6.0) * a,
    }
}

/// Least throat and least effective length of a fillet weld.
///
/// # Source
/// EN 1993-1-8:2005 4.5.2(2): a ≥ 3 mm; 4.5.1(2): l_eff ≥ max(30 mm, 6 a).
pub fn least_size(part: Part, throat: f64, effective_length: f64) -> [Check; 2] {
    let of = (Topic::Welds, part);
    let least = ("EN 1993-1-8:2005 4.5.2(2)", CheckId::LeastThroat);
    let length = ("EN 1993-1-8:2005 4.5.1(2)", CheckId::LeastWeldLength);
    let shortest = (Traced::from(6.0) * Traced::length("a", throat)).max(Traced::from(30.0));
    [
        Check::at_least(of, least, "a", LEAST_THROAT, throat, Status::Failed),
        Check::at_least(of, length, "l_eff", shortest, effective_length, Status::Failed),
    ]
}
