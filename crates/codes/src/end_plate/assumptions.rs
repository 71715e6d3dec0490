//! Assumptions of the checks where the spec gives no value, and input that the code does not cover.

use super::at_plate;
use super::column_forces::{ColumnForces, corner};
use crate::check::{Binding, Check, CheckId, Status, Topic, Unit};
use crate::subject::{Part, Place};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{EndPlate, NotChecked, UnseenLoad};
use bracket_joint::strength::Strength;

/// Loads that the checks leave out.
pub(crate) fn unseen_loads(unseen: &[UnseenLoad]) -> Vec<Check> {
    let check = |l: &UnseenLoad| {
        let (clause, id) = ("EN 1993-1-8:2005 6.2", CheckId::LoadsNotHeld);
        let topic = Topic::ComponentMethod;
        let (why, step) = (l.why.clone(), l.step.clone());
        Check::undecided(topic, Part::Joint, clause, id, why, step)
            .without_method()
            .of_case(&l.case)
    };
    unseen.iter().map(check).collect()
}

/// Parts of the geometry that the checks leave out, and parts that they count and the geometry
/// lacks.
pub(crate) fn not_checked(parts: &[NotChecked]) -> Vec<Check> {
    let check = |n: &NotChecked| {
        let (topic, id) = (Topic::Member, CheckId::NotChecked);
        let (label, clause) = (Place::Named(n.label.clone()), "EN 1993-1-8:2005 2.4");
        let why = n.why.clone();
        let check = match n.binds {
            true => Check::undecided(topic, label, clause, id, why, n.step.clone()),
            false => {
                let noted = Check::assumption(topic, label, clause, id, why);
                Check { status: Status::Warning, ..noted }
            }
        };
        check.naming(Text::joined(", ", n.parts.clone()))
    };
    parts.iter().map(check).collect()
}

/// Fillet welds of steels for which Table 4.1 has no β_w: the code gives them no strength.
pub(super) fn no_weld_strength(e: &EndPlate) -> Vec<Check> {
    let column = e
        .column
        .as_ref()
        .map(|c| (c.stiffener_throat.max(c.doubler_throat), &c.steel, Part::Column));
    let beam = e.beam_steel.weaker(&e.plate_steel);
    let beam = (e.flange_throat.max(e.web_throat).max(e.rib_throat), beam, Part::BeamAndEndPlate);
    let haunch = at_plate::haunch(e).map(|h| {
        let throat = h.seam_throat.max(e.flange_throat).max(e.web_throat);
        (throat, e.beam_steel.weaker(&h.steel), Part::Haunch)
    });
    let without = column
        .into_iter()
        .chain([beam])
        .chain(haunch)
        .filter(|(throat, steel, _)| *throat > 0.0 && steel.beta_w.is_none());
    without.map(|(_, steel, part)| without_strength(part, steel)).collect()
}

/// The check of the fillet welds of a part of a steel without β_w.
pub(crate) fn without_strength(part: Part, steel: &Strength) -> Check {
    let (clause, id) = ("EN 1993-1-8:2005 Table 4.1", CheckId::WeldStrength);
    let why = say!(
        "Table 4.1 has no β_w for {}: its fillet welds have no strength by this code",
        &steel.grade
    );
    let step = "butt welds, or a row with β_w in a table of your own (`catalog`)";
    Check::undecided(Topic::Welds, part, clause, id, why, step)
}

/// Ids of the checks of bolts under load.
const OF_BOLTS: [CheckId; 6] = [
    CheckId::BoltGroupShear,
    CheckId::BoltTension,
    CheckId::BoltShearAndTension,
    CheckId::BearingResistance,
    CheckId::BearingAcross,
    CheckId::PunchingResistance,
];

/// In rows of four bolts a check that counts the inner two alone proves strength where it holds; it
/// disproves nothing where it fails, because the outer two carry as well: then the code has no
/// method.
pub(super) fn by_inner_bolts(check: &mut Check) {
    let of_bolts = check.case.is_some() && OF_BOLTS.contains(&check.id());
    if check.status != Status::Failed || !(of_bolts || check.binding == Binding::Strength) {
        return;
    }
    check.status = Status::Undecided;
    let step = "two bolts in a row that carry the load alone: the check counts the inner two";
    *check = check.clone().decided_by(step).without_method();
}

/// Assumptions of the component method where the spec gives no value.
pub(super) fn assumptions(e: &EndPlate) -> Vec<Check> {
    let topic = Topic::ComponentMethod;
    let (clause, id) = ("EN 1993-1-8:2005 Table 6.2", CheckId::PryingForces);
    let rule = match e.always_prying {
        true => {
            "they are taken to develop in every T-stub, whatever the length of the bolts \
             (code.prying: always)"
        }
        false => {
            "they develop where L_b ≤ L_b* = 8.8 m³ A_s n_b/(Σℓ_eff,1 t_f³); code.prying: always \
             takes them to develop everywhere"
        }
    };
    let mut out = vec![Check::assumption(topic, Part::TStubs, clause, id, rule)];
    if e.outer_gauge > 0.0 {
        let (clause, id) = ("EN 1993-1-8:2005 6.2.4", CheckId::FourBolts);
        let words = "the code has no rule of its own: the checks count the inner two of every row \
                     alone, in tension, shear and slip, on the safe side; the analysis has all \
                     four";
        out.push(Check::assumption(topic, Part::Bolts, clause, id, words));
    }
    let Some(c) = &e.column else { return out };
    let (clause, id) = ("EN 1993-1-8:2005 6.2.6.2(2)", CheckId::WebLongitudinal);
    let words: Text = match ColumnForces::given(c) {
        _ if corner(c).is_some() => {
            "σ_com,Ed from the equilibrium of the node with one column, in each load case".into()
        }
        Some(f) if c.moment.is_some() => {
            let stress = Unit::Stress.show(f.longitudinal(c));
            say!("σ_com,Ed = {} from N_Ed and M_Ed of the column", stress)
        }
        Some(_) => {
            "σ_com,Ed from N_Ed of the column and the whole moment of the node, in each load case"
                .into()
        }
        None => "assumed: σ_com,Ed ≤ 0.7 f_y, k_wc = 1; members.column.N_Ed and M_Ed say more \
                 (k_wc falls to 0.7 at f_y)"
            .into(),
    };
    out.push(Check::assumption(topic, Part::ColumnWeb, clause, id, words));
    out
}
