//! The beam's own cross-section under the actions at the joint.

use crate::check::{Check, Status, Topic, Unit, number as n, within};
use crate::eurocode::i_section::Section;
use crate::eurocode::section::{Class, CrossSection, Slenderness, shear_reduction};
use crate::eurocode::yielding::{plastic_shear, yield_strength};
use crate::worked::Worked;
use bracket_joint::assembly::{EndPlate, PlaneActions};

/// Shear, axial force and moment of the beam at the bolt plane. They bind: a beam that cannot carry
/// these forces cannot load the joint with them.
///
/// # Source
/// EN 1993-1-1:2005 6.2.
pub(super) fn beam(e: &EndPlate, a: &PlaneActions) -> Vec<Check> {
    let [[axial, vy, vz], [torsion, my, mz]] = a.at(1.0);
    let beam = CrossSection {
        section: (&e.beam).into(),
        fy: e.beam_steel.fy,
        gamma_m0: e.factors.gamma_m0,
    };
    let subject = format!("{}, beam", a.end);
    let against = |worked: Worked, demand: f64| {
        worked.against(Topic::Member, subject.clone(), demand.abs(), Status::Failed)
    };
    let mut out = Vec::new();
    if vz != 0.0 {
        out.push(against(beam.shear(), vz));
        let (slenderness, limit) = beam.web_slenderness();
        if !within(slenderness, limit) {
            let worked = beam.shear_buckling(e.factors.gamma_m1);
            out.push(worked.against(Topic::Stability, subject.clone(), vz.abs(), Status::Failed));
        }
    }
    if vy != 0.0 {
        out.push(against(beam.shear_across(), vy));
    }
    if axial != 0.0 {
        out.push(against(beam.axial(), axial));
    }
    if torsion != 0.0 {
        out.extend(twisted(&beam, e.beam.torsion_constant(), torsion, [vy, vz], &subject));
    }
    // compression alone can be too much for a slender web
    if my != 0.0 || mz != 0.0 || axial < 0.0 {
        match beam.bending_6_2_10(vz, axial) {
            Ok(mut worked) => {
                let across = beside_shear_across(&beam, vy);
                if across < 1.0 {
                    worked.value *= across;
                    worked.formula += &format!(
                        "; times 1 − ρ = {} for Vy along the flanges: {}",
                        n(across),
                        Unit::Moment.show(worked.value)
                    );
                }
                if mz != 0.0 {
                    let weak = WeakAxis::new(e, &beam, axial, across);
                    out.push(weak.beside(&worked, [my, mz]).utilised(
                        Topic::Member,
                        subject.clone(),
                        Status::Failed,
                    ));
                }
                let mut check = against(worked, my);
                // a shear force beyond V_pl,Rd leaves no moment; its own check fails with a number
                if check.utilisation.is_none() && !within(vz.abs(), beam.shear().value) {
                    check.status = Status::Undecided;
                    check = check.decided_by("a beam with more shear resistance");
                }
                out.push(check);
            }
            // class 4
            Err(fault) => {
                let (clause, title) =
                    ("EN 1993-1-1:2005 5.5.2", "moment of the beam with its shear and axial force");
                out.push(Check::undecided(
                    Topic::Member,
                    subject,
                    clause,
                    title,
                    fault.to_string(),
                    fault.step(),
                ));
            }
        }
    }
    out
}

/// What a shear force along the flanges leaves of their strength, 1 − ρ, not below 0.
///
/// # Source
/// EN 1993-1-1:2005 6.2.8(3).
fn beside_shear_across(beam: &CrossSection, vy: f64) -> f64 {
    1.0 - shear_reduction(vy.abs() / beam.shear_across().value).min(1.0)
}

/// Bending about both axes.
struct WeakAxis {
    /// Resistance to bending about the weak axis beside the axial force \[N mm\].
    resistance: f64,
    /// Exponents of the moments about the strong and the weak axis.
    exponents: [f64; 2],
    clause: &'static str,
}

impl WeakAxis {
    /// The weak axis of the beam beside an axial force; `across` is what shear along the flanges
    /// leaves.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.9.1(5) and (6) in classes 1 and 2, α = 2, β = 5 n ≥ 1; 6.2.9.2 in class
    /// 3: the stresses add.
    fn new(e: &EndPlate, beam: &CrossSection, axial: f64, across: f64) -> Self {
        let (s, fyd) = (&beam.section, yield_strength(beam.fy, beam.gamma_m0).mpa());
        let part = axial.abs() / beam.axial().value;
        let class = Slenderness::new(s, s.r).class(s, beam.fy.mpa(), (-axial).max(0.0));
        if class == Class::Plastic {
            let a = ((s.area - 2.0 * s.b * s.tf) / s.area).min(0.5);
            let left = if part > a { 1.0 - ((part - a) / (1.0 - a)).powi(2) } else { 1.0 };
            let resistance = 1e3 * e.beam.w_pl_z * fyd * left.max(0.0) * across;
            let exponents = [2.0, (5.0 * part).max(1.0)];
            return Self { resistance, exponents, clause: "EN 1993-1-1:2005 6.2.9.1(6)" };
        }
        let resistance = 1e3 * e.beam.w_el_z * fyd * (1.0 - part).max(0.0) * across;
        Self { resistance, exponents: [1.0; 2], clause: "EN 1993-1-1:2005 6.2.9.2" }
    }

    /// Moments about both axes beside the resistance about the strong axis, to be at most 1.
    fn beside(&self, strong: &Worked, [my, mz]: [f64; 2]) -> Worked {
        let [alpha, beta] = self.exponents;
        let part = |moment: f64, resistance: f64, power: f64| match resistance > 0.0 {
            true => (moment.abs() / resistance).powf(power),
            false if moment == 0.0 => 0.0,
            false => f64::INFINITY,
        };
        let value = part(my, strong.value, alpha) + part(mz, self.resistance, beta);
        let show = |x: f64| Unit::Moment.show(x);
        let formula = format!(
            "(My/M_N,y,Rd)^{} + (Mz/M_N,z,Rd)^{} = ({}/{})^{} + ({}/{})^{}",
            n(alpha),
            n(beta),
            show(my.abs()),
            show(strong.value),
            n(alpha),
            show(mz.abs()),
            show(self.resistance),
            n(beta)
        );
        let title = "bending of the beam about both axes";
        Worked::new(self.clause, title, value, Unit::Number, formula)
    }
}

/// Torsion of the beam by St. Venant alone, and its shear forces beside it. The restraint of
/// warping at the end plate brings normal stresses that are not in these checks and may carry part
/// of the torsion; what exceeds them is therefore undecided.
///
/// # Source
/// EN 1993-1-1:2005 6.2.7(5), (6) and (9), formula 6.26: τ_t = T t/I_t of the thicker plate,
/// `V_pl,T,Rd = √(1 − τ_t/(1.25 (f_y/√3)/γ_M0)) V_pl,Rd`.
fn twisted(
    beam: &CrossSection,
    torsion_constant: f64,
    torsion: f64,
    [vy, vz]: [f64; 2],
    subject: &str,
) -> Vec<Check> {
    let (s, shear) = (&beam.section, plastic_shear(1.0, beam.fy, beam.gamma_m0));
    let thickest = s.tf.max(s.tw);
    let formula = format!(
        "T_Rd = I_t/t (f_y/√3)/γ_M0 = {}/{} · {}; St. Venant alone: the restraint of warping at \
         the end plate is not counted",
        n(torsion_constant),
        n(thickest),
        n(shear)
    );
    let (clause, title) = ("EN 1993-1-1:2005 6.2.7(5), (6)", "torsion of the beam");
    let resistance = torsion_constant / thickest * shear;
    let worked = Worked::new(clause, title, resistance, Unit::Moment, formula);
    let undecided = |worked: Worked, demand: f64| {
        let step = "less torsion, a beam with a larger I_t, or a check of the torsion with \
                    warping by another method";
        worked.against(Topic::Member, subject, demand.abs(), Status::Undecided).decided_by(step)
    };
    let mut out = vec![undecided(worked, torsion)];
    let stress = torsion.abs() * thickest / torsion_constant;
    let left = (1.0 - stress / (1.25 * shear)).max(0.0).sqrt();
    for (mut worked, title, force) in [
        (beam.shear(), "shear of the beam beside torsion", vz),
        (beam.shear_across(), "shear of the beam along its flanges beside torsion", vy),
    ] {
        if force == 0.0 {
            continue;
        }
        worked.value *= left;
        worked.formula = format!(
            "V_pl,T,Rd = √(1 − τ_t/(1.25 (f_y/√3)/γ_M0)) V_pl,Rd = √(1 − {}/(1.25 · {})) V_pl,Rd = \
             {}; {}",
            n(stress),
            n(shear),
            Unit::Force.show(worked.value),
            worked.formula
        );
        (worked.clause, worked.title) = ("EN 1993-1-1:2005 6.2.7(9)", title);
        out.push(undecided(worked, force));
    }
    out
}

/// Note on actions that exceed the resistance of the beam itself: most likely a wrong number or
/// unit.
pub(super) fn beyond_the_beam(e: &EndPlate, a: &PlaneActions) -> Option<String> {
    let [[axial, vy, vz], [_, my, _]] = a.at(1.0);
    let section = Section::from(&e.beam);
    let fyd = yield_strength(e.beam_steel.fy, e.factors.gamma_m0).mpa();
    let moment = (my.abs(), section.w_pl * fyd, "My", "M_pl,Rd", Unit::Moment);
    let normal = (axial.abs(), section.area * fyd, "N", "N_pl,Rd", Unit::Force);
    let shear = (
        vy.hypot(vz),
        plastic_shear(section.shear_area(), e.beam_steel.fy, e.factors.gamma_m0),
        "V",
        "V_pl,Rd",
        Unit::Force,
    );
    let worst =
        [moment, normal, shear].into_iter().max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)))?;
    let (demand, capacity, action, resistance, unit) = worst;
    (!within(demand, capacity)).then(|| {
        format!(
            "{action} = {} is {} times {resistance} = {} of the beam {}: check the number and its \
             unit",
            unit.show(demand),
            n(demand / capacity),
            unit.show(capacity),
            e.beam.name
        )
    })
}
