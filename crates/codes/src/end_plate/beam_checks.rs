//! The beam's own cross-section under the actions at the joint.

use super::at_plate;
use super::beam_cuts::{self, Cut};
use crate::check::{Check, CheckId, Status, Topic, Unit, number as n, within};
use crate::eurocode::i_section::Section;
use crate::eurocode::section::{Class, CrossSection, Slenderness, shear_reduction};
use crate::eurocode::yielding::{plastic_shear, yield_strength};
use crate::formula::{Derivation, Formula, Number, Traced};
use crate::subject::Subject;
use crate::worked::Worked;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{EndPlate, PlaneActions};
use bracket_joint::catalog::IProfile;
use bracket_joint::strength::Strength;

/// Shear, axial force and moment of the beam at the bolt plane, and at the tip of its haunch. They
/// bind: a beam that cannot carry these forces cannot load the joint with them.
///
/// # Source
/// EN 1993-1-1:2005 6.2.
pub(super) fn beam(e: &EndPlate, a: &PlaneActions) -> Vec<Check> {
    beam_cuts::cuts(e, a).iter().flat_map(|cut| at_cut(e, a, cut)).collect()
}

/// The checks of one cross-section.
fn at_cut(e: &EndPlate, a: &PlaneActions, cut: &Cut<'_>) -> Vec<Check> {
    let [[axial, vy, vz], [torsion, my, mz]] = cut.at;
    let beam = CrossSection {
        section: cut.profile.as_ref().into(),
        fy: cut.fy,
        gamma_m0: e.factors.gamma_m0,
    };
    let subject = Subject::end(&a.end).and(cut.part);
    let against = |worked: Worked, demand: f64| {
        let worked = worked.after(cut.words.clone());
        worked.against(Topic::Member, subject.clone(), demand.abs(), Status::Failed)
    };
    let mut out = Vec::new();
    if vz != 0.0 {
        out.push(against(beam.shear(), vz));
        let (slenderness, limit) = beam.web_slenderness();
        if !within(slenderness, limit) {
            let worked = beam.shear_buckling(e.factors.gamma_m1);
            let worked = worked.after(cut.words.clone());
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
        out.extend(twisted(&beam, cut.profile.torsion_constant(), torsion, [vy, vz], &subject));
    }
    // compression alone can be too much for a slender web
    if my != 0.0 || mz != 0.0 || axial < 0.0 {
        match beam.bending_6_2_10(vz, axial) {
            Ok(mut worked) => {
                let across = beside_shear_across(&beam, vy);
                if let Some((rho, left)) = across.clone() {
                    let reduced = worked.traced() * left;
                    worked = worked.then(rho).becomes("M_Rd,red", reduced);
                }
                if mz != 0.0 {
                    let weak = WeakAxis::new(&cut.profile, &beam, axial, across);
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
                let (clause, id) = ("EN 1993-1-1:2005 5.5.2", CheckId::BeamMoment);
                out.push(Check::undecided(
                    Topic::Member,
                    subject,
                    clause,
                    id,
                    fault.text(),
                    fault.step(),
                ));
            }
        }
    }
    out
}

/// ρ_y of a shear force along the flanges, at most 1, and what the force leaves of their strength,
/// 1 − ρ_y; `None` where it leaves all of it.
///
/// # Source
/// EN 1993-1-1:2005 6.2.8(3).
fn beside_shear_across(beam: &CrossSection, vy: f64) -> Option<(Formula, Traced)> {
    let resistance = Traced::force("V_pl,y,Rd", beam.shear_across().value);
    let rho = shear_reduction(Traced::force("V_y,Ed", vy.abs()) / resistance);
    let rho = Formula::new("ρ_y", rho.min(Traced::from(1.0)), Unit::Number);
    let left = Traced::from(1.0) - rho.traced();
    (left.value() < 1.0).then_some((rho, left))
}

/// What is left of a strength, at least 0: with the limit in its formula where it binds.
fn not_negative(left: Traced) -> Traced {
    if left.value() < 0.0 { left.max(Traced::from(0.0)) } else { left }
}

/// Bending about both axes.
struct WeakAxis {
    /// Resistance to bending about the weak axis beside the axial force \[N mm\].
    resistance: Traced,
    /// Exponents of the moments about the strong and the weak axis; `None` for 1.
    exponents: [Option<Traced>; 2],
    /// What gives these values.
    derivation: Derivation,
    clause: &'static str,
}

impl WeakAxis {
    /// The weak axis of the beam beside an axial force; `across` is what shear along the flanges
    /// leaves.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.9.1(5) and (6) in classes 1 and 2, α = 2, β = 5 n ≥ 1; 6.2.9.2 in class
    /// 3: the stresses add.
    fn new(
        profile: &IProfile,
        beam: &CrossSection,
        axial: f64,
        across: Option<(Formula, Traced)>,
    ) -> Self {
        let (s, number) = (&beam.section, Traced::from);
        let fyd = Traced::stress("f_y", beam.fy.mpa()) / Traced::number("γ_M0", beam.gamma_m0);
        let n = Traced::force("N_Ed", axial.abs()) / beam.axial().traced();
        let n = Formula::new("n", n, Unit::Number);
        let class = Slenderness::new(s, s.r).class(s, beam.fy.mpa(), (-axial).max(0.0));
        let mut derivation = Derivation::default();
        if axial != 0.0 {
            derivation = derivation.then(n.clone());
        }
        let (mut resistance, exponents, clause) = if class == Class::Plastic {
            let area = || Traced::area("A", s.area);
            let flanges = number(2.0) * Traced::length("b", s.b) * Traced::length("t_f", s.tf);
            let a = ((area() - flanges) / area()).min(number(0.5));
            let a = Formula::new("a", a, Unit::Number);
            let mut resistance = Traced::number("W_pl,z", 1e3 * profile.w_pl_z) * fyd;
            if n.value > a.value {
                let beyond = (n.traced() - a.traced()) / (number(1.0) - a.traced());
                resistance = resistance * not_negative(number(1.0) - beyond.powi(2));
                derivation = derivation.then(a);
            }
            let beta = Formula::new("β", (number(5.0) * n.traced()).max(number(1.0)), Unit::Number);
            let exponents = [Some(number(2.0)), (axial != 0.0).then(|| beta.traced())];
            if axial != 0.0 {
                derivation = derivation.then(beta);
            }
            (resistance, exponents, "EN 1993-1-1:2005 6.2.9.1(6)")
        } else {
            let mut resistance = Traced::number("W_el,z", 1e3 * profile.w_el_z) * fyd;
            if axial != 0.0 {
                resistance = resistance * not_negative(number(1.0) - n.traced());
            }
            (resistance, [None, None], "EN 1993-1-1:2005 6.2.9.2")
        };
        if let Some((rho, left)) = across {
            (derivation, resistance) = (derivation.then(rho), resistance * left);
        }
        let resistance = Formula::new("M_N,z,Rd", resistance, Unit::Moment);
        let moment = resistance.traced();
        Self { resistance: moment, exponents, derivation: derivation.then(resistance), clause }
    }

    /// Moments about both axes beside the resistance about the strong axis, to be at most 1.
    fn beside(&self, strong: &Worked, [my, mz]: [f64; 2]) -> Worked {
        let part = |moment: Traced, resistance: Traced, power: &Option<Traced>| {
            let left = match resistance.value() > 0.0 {
                true => resistance,
                false if moment.value() == 0.0 => return moment,
                // nothing is left: more than any resistance
                false => resistance.max(Traced::from(0.0)),
            };
            match power.clone() {
                Some(power) => (moment / left).powf(power),
                None => moment / left,
            }
        };
        let moment = |symbol: &'static str, value| Traced::symbol(symbol, value, Unit::Moment);
        let [alpha, beta] = &self.exponents;
        let value = part(moment("M_y,Ed", my.abs()), moment("M_N,y,Rd", strong.value), alpha)
            + part(moment("M_z,Ed", mz.abs()), self.resistance.clone(), beta);
        let id = CheckId::BeamBothAxes;
        Worked::of(self.clause, id, "", value, Unit::Number).after(self.derivation.clone())
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
    subject: &Subject,
) -> Vec<Check> {
    let s = &beam.section;
    let [f_y, gamma] =
        [("f_y", beam.fy.mpa(), Unit::Stress), ("γ_M0", beam.gamma_m0, Unit::Number)]
            .map(Traced::from);
    let shear = f_y / (Traced::from(3.0).sqrt() * gamma);
    let constant = Traced::number("I_t", torsion_constant);
    let thickest = Traced::length("t", s.tf.max(s.tw));
    let (clause, id) = ("EN 1993-1-1:2005 6.2.7(5), (6)", CheckId::BeamTorsion);
    let resistance = constant.clone() / thickest.clone() * shear.clone();
    let words = "St. Venant alone: the restraint of warping at the end plate is not counted";
    let worked = Worked::of(clause, id, "T_Rd", resistance, Unit::Moment).then(words);
    let undecided = |worked: Worked, demand: f64| {
        let step = "less torsion, or a beam with a larger I_t";
        worked
            .against(Topic::Member, subject.clone(), demand.abs(), Status::Undecided)
            .decided_by(step)
            .without_method()
    };
    let mut out = vec![undecided(worked, torsion)];
    let stress = Traced::symbol("T_Ed", torsion.abs(), Unit::Moment) * thickest / constant;
    let stress = Formula::new("τ_t", stress, Unit::Stress);
    let left = Traced::from(1.0) - stress.traced() / (Traced::from(1.25) * shear);
    let left = not_negative(left).sqrt();
    for (worked, id, force) in [
        (beam.shear(), CheckId::BeamShearTorsion, vz),
        (beam.shear_across(), CheckId::BeamShearAcrossTorsion, vy),
    ] {
        if force == 0.0 {
            continue;
        }
        let reduced = left.clone() * worked.traced();
        let mut worked = worked.then(stress.clone()).becomes("V_pl,T,Rd", reduced);
        (worked.clause, worked.id) = ("EN 1993-1-1:2005 6.2.7(9)", id);
        out.push(undecided(worked, force));
    }
    out
}

/// Note on actions that exceed the resistance of the beam itself: most likely a wrong number or
/// unit.
pub(super) fn beyond_the_beam(e: &EndPlate, a: &PlaneActions) -> Option<Text> {
    beyond_a_beam((&at_plate::section(e), at_plate::steel(e)), e.factors.gamma_m0, a)
}

/// The same for a beam with its steel.
pub(crate) fn beyond_a_beam(
    (beam, steel): (&IProfile, &Strength),
    gamma_m0: f64,
    a: &PlaneActions,
) -> Option<Text> {
    let [[axial, vy, vz], [_, my, _]] = a.at(1.0);
    let section = Section::from(beam);
    let fyd = yield_strength(steel.fy, gamma_m0).mpa();
    let moment = (my.abs(), section.w_pl * fyd, "My", "M_pl,Rd", Unit::Moment);
    let normal = (axial.abs(), section.area * fyd, "N", "N_pl,Rd", Unit::Force);
    let shear = (
        vy.hypot(vz),
        plastic_shear(section.shear_area(), steel.fy.mpa(), gamma_m0),
        "V",
        "V_pl,Rd",
        Unit::Force,
    );
    let worst =
        [moment, normal, shear].into_iter().max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)))?;
    let (demand, capacity, action, resistance, unit) = worst;
    (!within(demand, capacity)).then(|| {
        say!(
            "{} = {} is {} times {} = {} of the beam {}: check the number and its unit",
            action,
            unit.show(demand),
            n(demand / capacity),
            resistance,
            unit.show(capacity),
            &beam.name
        )
    })
}
