//! Welds of the beam: under the actions, beside the rows in tension, and the strength they need so
//! as not to limit the joint.

use super::member_end::LoadedEnd;
use super::sense::Sense;
use super::welded_steel;
use crate::assembly::{EndPlate, PlaneActions};
use crate::checks::check::{Check, Status, Topic, Unit, largest, number as n, within};
use crate::checks::component_method::Assessment;
use crate::checks::eurocode::welds::{
    across_and_along, directional, full_strength_throat, least_size, simplified, transverse,
};
use crate::checks::worked::Worked;
use std::f64::consts::SQRT_2;

/// Throats of double fillet welds that are as strong as flange and web of the beam.
pub(super) fn full_strength_throats(e: &EndPlate) -> Vec<Check> {
    let Some(steel) = welded_steel::of_the_beam(e) else { return Vec::new() };
    [("beam flange", e.beam.tf), ("beam web", e.beam.tw)]
        .into_iter()
        .map(|(part, t)| {
            full_strength_throat(t, e.beam_steel.fy, e.factors.gamma_m0, &steel)
                .information(Topic::Welds, part)
        })
        .collect()
}

/// Fillet welds under the actions of a load case: those of the flanges take moment and axial force,
/// those of the web the shear force.
pub(super) fn under_load(e: &EndPlate, a: &PlaneActions) -> Vec<Check> {
    let (b, mut out) = (&e.beam, Vec::new());
    let Some(steel) = welded_steel::of_the_beam(e) else { return out };
    let [[axial, vy, vz], [_, my, _]] = a.at(1.0);
    if e.flange_throat > 0.0 {
        let subject = format!("{}, beam flange", a.end);
        let length = flange_run(e);
        let force = my.abs() / (b.h - b.tf) + 0.5 * axial.max(0.0);
        let mut worked = simplified(e.flange_throat, &steel).with("l_eff", length, Unit::Length);
        worked.formula = format!(
            "F_w,Ed = (|My|/(h − t_f) + N/2)/l_eff = ({} + {})/{}; {}",
            Unit::Force.show(my.abs() / (b.h - b.tf)),
            Unit::Force.show(0.5 * axial.max(0.0)),
            Unit::Length.show(length),
            worked.formula
        );
        out.push(worked.against(Topic::Welds, subject.clone(), force / length, Status::Failed));
        out.extend(least_size(&subject, e.flange_throat, b.b - 2.0 * e.flange_throat));
    }
    if e.web_throat > 0.0 {
        let subject = format!("{}, beam web", a.end);
        let length = web_run(e);
        let force = vz.hypot(vy);
        let mut worked = simplified(e.web_throat, &steel).with("l_eff", length, Unit::Length);
        worked.formula = format!(
            "F_w,Ed = V/(2 l_eff) = {}/(2 · {}); {}",
            Unit::Force.show(force),
            Unit::Length.show(length),
            worked.formula
        );
        out.push(worked.against(
            Topic::Welds,
            subject.clone(),
            0.5 * force / length,
            Status::Failed,
        ));
        out.extend(least_size(&subject, e.web_throat, length));
    }
    out
}

/// A stretch of the welds of the beam web, and the rows whose force it takes.
struct Stretch {
    /// Rows from the tension side.
    first: usize,
    last: usize,
    /// b_eff of the beam web, that of the T-stub of the end plate, at most the length of the welds
    /// of the web \[mm\].
    width: f64,
}

/// Stretches of the welds of the web that take the force of rows: of every row alone and of every
/// group between the flanges. A row outside the flange acts on the flange.
fn stretches(a: &Assessment, run: f64) -> Vec<Stretch> {
    let mut out = Vec::new();
    for (last, row) in a.rows.iter().enumerate() {
        let alone = row.alone.iter().map(|c| (last, c));
        let all = alone.chain(row.groups.iter().map(|g| (g.first, &g.component)));
        let web = all.filter(|(_, c)| c.name == "beam web");
        out.extend(web.filter_map(|(first, c)| {
            Some(Stretch { first, last, width: c.worked.step("b_eff")?.min(run) })
        }));
    }
    out
}

/// Effective length of each of the two welds of the beam web \[mm\].
fn web_run(e: &EndPlate) -> f64 {
    e.beam.h - 2.0 * (e.beam.tf + e.beam.r) - 2.0 * e.web_throat
}

/// The stretch of the welds of the beam web with the largest utilisation, under row forces \[N\]
/// and a shear force over the whole web \[N\].
fn web_welds(
    e: &EndPlate,
    a: &Assessment,
    force: impl Fn(usize) -> f64,
    shear: f64,
) -> Option<(Stretch, Worked)> {
    let (throat, run) = (e.web_throat, web_run(e));
    let steel = welded_steel::of_the_beam(e).filter(|_| throat > 0.0 && run > 0.0)?;
    let parallel = shear / (2.0 * throat * run);
    let each = stretches(a, run).into_iter().map(|s| {
        let pull: f64 = (s.first..=s.last).map(&force).sum();
        let mut worked = directional(&across_and_along(pull, s.width, throat, parallel), &steel);
        worked.formula = format!(
            "σ⊥ = τ⊥ = F/(2 √2 a b_eff) = {}/(2 √2 · {} · {}), τ∥ = V/(2 a l_eff) = {}/(2 · {} · \
             {}); {}",
            Unit::Force.show(pull),
            n(throat),
            n(s.width),
            Unit::Force.show(shear),
            n(throat),
            n(run),
            worked.formula
        );
        (s, worked)
    });
    largest(each, |(_, worked)| worked.value)
}

/// The welds of the beam web beside the rows in tension: they carry the force of a row into the web
/// and their share of the shear force at the same time. The stretch with the largest utilisation.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2, 6.2.6.8 for the length of web per row; SCI P398 uses the same
/// length.
pub(super) fn tension_zone(loaded: &LoadedEnd<'_>) -> Option<Check> {
    let (e, assessment) = (loaded.end.e, &loaded.end.assessment);
    let [_, vy, vz] = loaded.end.a.at(1.0)[0];
    let (stretch, mut worked) = web_welds(e, assessment, |r| loaded.row_force(r), vy.hypot(vz))?;
    worked.title = "web weld beside the rows in tension, directional method";
    let place = loaded.place(&format!("beam web, {}", loaded.rows(stretch.first, stretch.last)));
    Some(worked.utilised(Topic::Welds, place, Status::Failed))
}

/// Clause of the rule that welds do not limit a joint.
const NOT_THE_WEAKEST: &str = "EN 1993-1-8:2005 6.2.3(4)";
/// Factors α on M_j,Rd where a plastic hinge rotates in the joint: with bracing, without.
const OVERSTRENGTH: [(f64, &str); 2] = [(1.4, "braced frame"), (1.7, "other frames")];
/// M_j,Rd/M_pl,Rd of the beam from which the plastic hinge forms in the beam, 6.4.1(1).
const HINGE_IN_BEAM: f64 = 1.2;

/// Resistance of the welds of a flange across it.
struct FlangeWelds {
    /// F_Rd \[N\].
    worked: Worked,
    /// b t_f f_y/γ_M0, the largest force of the flange \[N\].
    flange: f64,
}

/// Resistance by the directional method, `a l_eff f_u/(√2 β_w γ_M2)`. Welds as strong as the
/// thickness of the flange carry the whole flange.
fn flange_welds(e: &EndPlate) -> Option<FlangeWelds> {
    let (b, a) = (&e.beam, e.flange_throat);
    let flange = b.b * b.tf * e.beam_steel.fy / e.factors.gamma_m0;
    let steel = welded_steel::of_the_beam(e)?;
    let full = full_strength_throat(b.tf, e.beam_steel.fy, e.factors.gamma_m0, &steel);
    let length = flange_run(e);
    let each = transverse(a, &steel);
    let along = each.value * length;
    let (value, formula) = if within(full.value, a) && flange > along {
        (
            flange,
            format!("a = {} mm ≥ {} of full strength; F_Rd = b t_f f_y/γ_M0", n(a), full.formula),
        )
    } else {
        (
            along,
            format!("{}; F_Rd = F_w,Rd l_eff = {} · {}", each.formula, n(each.value), n(length)),
        )
    };
    Some(FlangeWelds {
        worked: Worked::new(NOT_THE_WEAKEST, "", value, Unit::Force, formula),
        flange,
    })
}

/// Effective length of the welds of one flange, outside along its width, inside up to the root
/// fillets \[mm\].
fn flange_run(e: &EndPlate) -> f64 {
    2.0 * e.beam.b - e.beam.tw - 2.0 * e.beam.r - 2.0 * SQRT_2 * e.flange_throat
}

/// Whether the welds are strong enough that another component limits M_j,Rd; and whether they carry
/// the overstrength of a plastic hinge that rotates in the joint, which is a warning, because the
/// analysis of the frame is not known. For a sense of bending that no load case has, both are
/// warnings.
///
/// # Source
/// EN 1993-1-8:2005 6.2.3(4) and (5); 4.7.1(1) for butt welds.
pub(super) fn not_the_weakest(
    e: &EndPlate,
    subject: &str,
    sense: Sense,
    a: &Assessment,
) -> Vec<Check> {
    let mine = |my: f64| my != 0.0 && Sense::of_moment(my) == sense;
    let bends = e.actions.iter().any(|x| mine(x.at(1.0)[1][1]));
    let otherwise = if bends { Status::Failed } else { Status::Warning };
    let mut out = Vec::new();
    out.extend(of_the_flange(e, subject, a, otherwise));
    if e.web_throat == 0.0 {
        let strength = e.beam.tw * e.beam_steel.fy / e.factors.gamma_m0;
        let words =
            "full penetration: as strong as the web (4.7.1), it limits no row; t_w f_y/γ_M0";
        let title = "web weld no weaker than the rows in tension";
        let worked = Worked::new(NOT_THE_WEAKEST, title, strength, Unit::ForcePerLength, words);
        out.push(worked.information(Topic::Welds, format!("beam web, {subject}")));
    }
    // every row at its resistance, without shear force
    let full = |r: usize| a.rows.get(r).map_or(0.0, |row| row.force);
    if let Some((stretch, mut worked)) = web_welds(e, a, full, 0.0) {
        worked.clause = NOT_THE_WEAKEST;
        worked.title = "web weld no weaker than the rows in tension";
        let each = a.rows.get(stretch.first..=stretch.last).unwrap_or_default().iter();
        let each: Vec<String> = each.map(|r| n(sense.z(r.z))).collect();
        let place = format!("beam web, {subject}, z = {} mm", each.join(" and "));
        out.push(worked.utilised(Topic::Welds, place, otherwise));
    }
    out
}

/// The part of [`not_the_weakest`] for the welds of the flange in tension.
fn of_the_flange(e: &EndPlate, subject: &str, a: &Assessment, otherwise: Status) -> Vec<Check> {
    let place = format!("beam flange, {subject}");
    let (joint, lever) = (a.moment.value, e.beam.h - e.beam.tf);
    if e.flange_throat == 0.0 {
        let strength = e.beam.b * e.beam.tf * e.beam_steel.fy / e.factors.gamma_m0;
        let words =
            "full penetration: as strong as the flange (4.7.1), it limits no joint; b t_f f_y/γ_M0";
        let worked = Worked::new(
            NOT_THE_WEAKEST,
            "flange weld no weaker than the joint",
            strength,
            Unit::Force,
            words,
        );
        return vec![worked.information(Topic::Welds, place)];
    }
    let Some(welds) = flange_welds(e) else { return Vec::new() };
    let check = |clause, title, (moment, words): (f64, String), otherwise| {
        let (pull, flange) = (moment / lever, welds.flange);
        let mut worked = welds.worked.clone();
        (worked.clause, worked.title) = (clause, title);
        worked.formula = format!(
            "F_Ed = min({words}/(h − t_f), b t_f f_y/γ_M0) = min({}/{}, {}) = {}; {}",
            Unit::Moment.show(moment),
            Unit::Length.show(lever),
            Unit::Force.show(flange),
            Unit::Force.show(pull.min(flange)),
            worked.formula
        );
        worked.against(Topic::Welds, place.clone(), pull.min(flange), otherwise)
    };
    let title = "flange weld no weaker than the joint";
    let mut out = vec![check(NOT_THE_WEAKEST, title, (joint, "M_j,Rd".to_owned()), otherwise)];
    let plastic = 1e3 * e.beam.w_pl_y * e.beam_steel.fy / e.factors.gamma_m0;
    // no hinge rotates in the joint where the beam yields first, or in a sense that no load case
    // has
    if within(HINGE_IN_BEAM * plastic, joint)
        || (otherwise != Status::Failed && !e.actions.is_empty())
    {
        return out;
    }
    for (alpha, frame) in OVERSTRENGTH {
        let title = "flange weld where a plastic hinge turns in the joint";
        let moment = (alpha * joint).min(plastic);
        let words = format!("min({} M_j,Rd, M_pl,Rd) ({frame})", n(alpha));
        out.push(check("EN 1993-1-8:2005 6.2.3(5)", title, (moment, words), Status::Warning));
    }
    out
}
