//! Welds of the beam beside the rows in tension, and the strength they need so as not to limit the
//! joint.

use super::at_plate;
use super::loaded_welds::{
    YIELDS, along_flange, flange_lever, flange_resistance, flange_strength, full_throat_of,
    most_of_web, web_strength, yielding_part,
};
use super::member_end::LoadedEnd;
use super::weld_lengths;
use super::welded_steel;
use crate::check::{Check, CheckId, Status, Topic, Unit, largest, within};
use crate::component_method::{Assessment, ComponentKind};
use crate::eurocode::welds::{
    ThroatStress, WeldedSteel, directional, full_strength_throat, least_size,
};
use crate::eurocode::yielding::plastic;
use crate::formula::{Derivation, Formula, Line, Number, Traced};
use crate::subject::{Frame, Part, Place, Sense, Subject};
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::EndPlate;

/// Throats of double fillet welds that are as strong as flange and web of the beam.
pub(super) fn full_strength_throats(e: &EndPlate) -> Vec<Check> {
    let Some(steel) = welded_steel::of_the_beam(e) else { return Vec::new() };
    let flanges = at_plate::flanges(e);
    let of_flange = |f| full_throat_of(e, f, &steel).information(Topic::Welds, f.part);
    let [_, web] = at_plate::webs(e);
    let of_web = full_strength_throat(web, e.beam_steel.fy, e.factors.gamma_m0, &steel);
    let of_web = of_web.information(Topic::Welds, Part::BeamWeb);
    flanges.iter().map(of_flange).chain([of_web]).collect()
}

/// Least throats and lengths of the welds of the beam, which no load changes.
pub(super) fn least_sizes(e: &EndPlate) -> Vec<Check> {
    let web = weld_lengths::web(e).value;
    let flanges = at_plate::flanges(e);
    let flanges =
        flanges.iter().map(|f| (f.part, e.flange_throat, weld_lengths::shortest_of_flange(e, f)));
    let welds = flanges.chain([(Part::BeamWeb, e.web_throat, web)]);
    let seam = at_plate::haunch(e).map(|h| {
        let length = weld_lengths::run(e, h.length, h.seam_throat).value;
        (Part::HaunchWeb, h.seam_throat, length)
    });
    let welds = welds.chain(seam);
    let fillets = welds.filter(|(_, throat, _)| *throat > 0.0);
    fillets.flat_map(|(part, throat, length)| least_size(part, throat, length)).collect()
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
        let web = all.filter(|(_, c)| c.kind == ComponentKind::BeamWeb);
        out.extend(web.filter_map(|(first, c)| {
            Some(Stretch { first, last, width: c.worked.step("b_eff")?.min(run) })
        }));
    }
    out
}

/// The stretch of the welds of the beam web with the largest utilisation, under row forces \[N\]
/// and a shear force over the whole web \[N\]. The web can bring no more than it yields with; what
/// is beyond it goes through the flange, whose welds are checked for the whole moment.
fn web_welds(
    e: &EndPlate,
    a: &Assessment,
    force: impl Fn(usize) -> f64,
    shear: f64,
) -> Option<(Stretch, Worked)> {
    let length = weld_lengths::web(e);
    let run = length.value;
    let steel = welded_steel::of_the_beam(e).filter(|_| e.web_throat > 0.0 && run > 0.0)?;
    let each = stretches(a, run).into_iter().map(|s| {
        let rows = (s.first..=s.last).map(|r| Traced::force("F_r", force(r)));
        let worked = beside_rows(e, Traced::series(rows), shear, s.width, &length, &steel);
        (s, worked)
    });
    largest(each, |(_, worked)| worked.value)
}

/// The welds of the web under the force `pull` of rows \[N\] on `width` b_eff \[mm\] of them, and a
/// shear force \[N\] over their whole length.
fn beside_rows(
    e: &EndPlate,
    pull: Traced,
    shear: f64,
    width: f64,
    length: &Formula,
    steel: &WeldedSteel,
) -> Worked {
    let line = |symbol: &'static str, of: Traced| Formula::new(symbol, of, Unit::ForcePerLength);
    let (two, a) = (Traced::from(2.0), Traced::length("a", e.web_throat));
    let b_eff = Traced::length("b_eff", width);
    let pull = Formula::new("F_Ed", pull, Unit::Force);
    let across = line("F_⊥", pull.traced() / two.clone() / b_eff.clone());
    let shear = Traced::force("V", shear) / two.clone() / length.traced();
    let along = line("F_∥", shear.clone());
    let part = yielding_part([across.traced(), along.traced()], most_of_web(e) / two.clone());
    let part = Formula::new("η", part, Unit::Number);
    let capped = 2.0 * (part.value * across.value) * width;
    let mut lines: Vec<Line> = Vec::new();
    let mut parallel = shear;
    if part.value < 1.0 {
        parallel = part.traced() * along.traced();
        // as the stress across the weld has it
        let force = part.traced() * pull.traced();
        let force = Formula { value: capped, ..Formula::new("F", force, Unit::Force) };
        let rest = Unit::Force.show(pull.value - capped);
        lines.extend([pull, across, along].map(Line::from));
        lines.extend([YIELDS.into(), part.into(), force.into()]);
        lines.push(say!("the rest, {}, goes through the flange", rest).into());
    }
    let throat = two.clone() * two.sqrt() * a.clone() * b_eff;
    let normal = Formula::new("σ⊥ = τ⊥", Traced::force("F", capped) / throat, Unit::Stress);
    let parallel = Formula::new("τ∥", parallel / a, Unit::Stress);
    let (across, along) = (normal.value, parallel.value);
    let stress = ThroatStress { sigma_perp: across, tau_perp: across, tau_par: along };
    lines.extend([normal, parallel].map(Line::from));
    directional(&stress, steel).after(Derivation { lines })
}

/// The welds of the beam web beside the rows in tension: they carry the force of a row into the web
/// and their share of the shear force at the same time. The stretch with the largest utilisation.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2, 6.2.6.8 for the length of web per row; SCI P398 uses the same
/// length.
pub(super) fn tension_zone(loaded: &LoadedEnd<'_>) -> Option<Check> {
    let (e, assessment) = (loaded.end.e, &loaded.end.assessment);
    let shear = at_plate::web_shear(e, loaded.end.a.at(1.0));
    let (stretch, mut worked) = web_welds(e, assessment, |r| loaded.row_force(r), shear)?;
    worked.id = CheckId::WebWeldBesideRows;
    let place = loaded.place(Part::BeamWeb).and(loaded.rows(stretch.first, stretch.last));
    Some(worked.utilised(Topic::Welds, place, Status::Failed))
}

/// Clause of the rule that welds do not limit a joint.
const NOT_THE_WEAKEST: &str = "EN 1993-1-8:2005 6.2.3(4)";
/// Factors α on M_j,Rd where a plastic hinge rotates in the joint: with bracing, without.
const OVERSTRENGTH: [(f64, Frame); 2] = [(1.4, Frame::Braced), (1.7, Frame::Unbraced)];
/// M_j,Rd/M_pl,Rd of the beam from which the plastic hinge forms in the beam, 6.4.1(1).
const HINGE_IN_BEAM: f64 = 1.2;

/// Whether the welds are strong enough that another component limits M_j,Rd; and whether they carry
/// the overstrength of a plastic hinge that rotates in the joint, which is a warning, because the
/// analysis of the frame is not known. For a sense of bending that no load case has, both are
/// warnings.
///
/// # Source
/// EN 1993-1-8:2005 6.2.3(4) and (5); 4.7.1(1) for butt welds.
pub(super) fn not_the_weakest(
    e: &EndPlate,
    subject: &Subject,
    sense: Sense,
    a: &Assessment,
) -> Vec<Check> {
    let mine = |my: f64| my != 0.0 && Sense::of_moment(my) == sense;
    let bends = e.actions.iter().any(|x| mine(x.at(1.0)[1][1]));
    let otherwise = if bends { Status::Failed } else { Status::Warning };
    let mut out = Vec::new();
    out.extend(of_the_flange(e, (subject, sense), a, otherwise));
    if e.web_throat == 0.0 {
        let words = "full penetration: as strong as the web (4.7.1), it limits no row";
        let (id, unit) = (CheckId::WebWeldNotWeakest, Unit::ForcePerLength);
        let worked = Worked::of(NOT_THE_WEAKEST, id, "F_w,Rd", web_strength(e), unit);
        let worked = worked.after(words);
        out.push(
            worked.information(Topic::Welds, Subject::from(Part::BeamWeb).and(subject.clone())),
        );
    }
    // every row at its resistance, without shear force
    let full = |r: usize| a.rows.get(r).map_or(0.0, |row| row.force);
    if let Some((stretch, mut worked)) = web_welds(e, a, full, 0.0) {
        worked.clause = NOT_THE_WEAKEST;
        worked.id = CheckId::WebWeldNotWeakest;
        let each = a.rows.get(stretch.first..=stretch.last).unwrap_or_default().iter();
        let heights = Place::Heights(each.map(|r| sense.z(r.z)).collect());
        let place = Subject::from(Part::BeamWeb).and(subject.clone()).and(heights);
        out.push(worked.utilised(Topic::Welds, place, otherwise));
    }
    out
}

/// The part of [`not_the_weakest`] for the welds of the flange in tension.
fn of_the_flange(
    e: &EndPlate,
    (subject, sense): (&Subject, Sense),
    a: &Assessment,
    otherwise: Status,
) -> Vec<Check> {
    let flange = at_plate::flange(e, sense.pulled());
    let place = Subject::from(flange.part).and(subject.clone());
    let joint = a.moment.value;
    let id = CheckId::FlangeWeldNotWeakest;
    if e.flange_throat == 0.0 {
        let words = "full penetration: as strong as the flange (4.7.1), it limits no joint";
        let worked =
            Worked::of(NOT_THE_WEAKEST, id, "F_Rd", flange_strength(e, &flange), Unit::Force)
                .after(words);
        return vec![worked.information(Topic::Welds, place)];
    }
    let Some(welds) = flange_resistance(e, &flange, NOT_THE_WEAKEST) else { return Vec::new() };
    let check = |clause, id, (moment, words): (Traced, Option<&'static str>), otherwise| {
        let pull = along_flange(&flange, moment / flange_lever(e));
        let pull = pull.min(flange_strength(e, &flange));
        let demand = pull.value();
        let before = words.into_iter().fold(Derivation::default(), Derivation::then);
        let before = before.then(Formula::new("F_Ed", pull, Unit::Force));
        let worked = Worked { clause, id, ..welds.clone().after(before) };
        worked.against(Topic::Welds, place.clone(), demand, otherwise)
    };
    let of_joint = Traced::symbol("M_j,Rd", joint, Unit::Moment);
    let mut out = vec![check(NOT_THE_WEAKEST, id, (of_joint.clone(), None), otherwise)];
    let plastic = plastic(1e3 * e.beam.w_pl_y, e.beam_steel.fy.mpa(), e.factors.gamma_m0);
    // no hinge rotates in the joint where the beam yields first, or in a sense that no load case
    // has
    // (the beam of a haunch yields at its tip, under another moment)
    let haunched = at_plate::haunch(e).is_some();
    if (!haunched && within(HINGE_IN_BEAM * plastic, joint))
        || (otherwise != Status::Failed && !e.actions.is_empty())
    {
        return out;
    }
    for (alpha, frame) in OVERSTRENGTH {
        let id = CheckId::FlangeWeldOfHinge;
        let of_beam = Traced::symbol("M_pl,Rd", plastic, Unit::Moment);
        let moment = Traced::from(alpha) * of_joint.clone();
        let moment = if haunched { moment } else { moment.min(of_beam) };
        let of = (moment, Some(frame.words()));
        out.push(check("EN 1993-1-8:2005 6.2.3(5)", id, of, Status::Warning));
    }
    out
}
