//! Properties of the checks of random splices: signs, symmetry, monotony.

use super::random::random;
use crate::check::{Check, CheckId, Status};
use crate::cover_splice::splice_checks;
use bracket_joint::assembly::{CoverSplice, SpliceUse};
use bracket_joint::spec::loads::LimitState;
use std::collections::BTreeMap;

/// Demand and resistance of every check of a load case that has both.
type Table = BTreeMap<(String, CheckId), [f64; 2]>;

fn table(e: &CoverSplice, rename: impl Fn(String) -> String) -> Table {
    let numbers = |c: &Check| {
        let key = (rename(c.subject.to_string()), c.id());
        Some((key, [c.demand?, c.resistance?]))
    };
    let all = splice_checks(e).checks;
    all.iter().filter(|c| c.case.is_some()).filter_map(numbers).collect()
}

fn same(a: &Table, b: &Table) {
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (key, x) in a {
        let y = &b[key];
        let close = |k: usize| (x[k] - y[k]).abs() <= 1e-9 * x[k].abs().max(y[k].abs());
        assert!(close(0) && close(1), "{key:?}: {x:?} is not {y:?}");
    }
}

/// A splice with both members on one axis.
fn centred(seed: u64) -> CoverSplice {
    let mut e = random(seed);
    e.left.axis = 0.0;
    e.right.axis = 0.0;
    e
}

/// Turned upside down: packs, rows and the sense of the moment.
fn turned(e: &CoverSplice) -> CoverSplice {
    let mut t = e.clone();
    for m in [&mut t.left, &mut t.right] {
        m.packs.reverse();
        m.axis = -m.axis;
    }
    t.web_rows = e.web_rows.iter().rev().map(|z| -z).collect();
    t.web_middle = -e.web_middle;
    for a in &mut t.actions {
        a.live[1][1] = -a.live[1][1];
    }
    t
}

#[test]
fn a_splice_turned_upside_down_swaps_its_flanges() {
    let swap = |s: String| {
        let s = s.replace("upper flange", "?").replace("lower flange", "upper flange");
        s.replace('?', "lower flange")
    };
    for seed in 1..=120 {
        let e = random(seed);
        same(&table(&e, |s| s), &table(&turned(&e), swap));
    }
}

#[test]
fn the_sign_of_the_shear_force_and_the_side_of_the_splice_do_not_matter() {
    for seed in 1..=120 {
        let e = random(seed);
        let mut back = e.clone();
        back.actions[0].live[0][2] *= -1.0;
        same(&table(&e, |s| s), &table(&back, |s| s));
        let mut other = e.clone();
        std::mem::swap(&mut other.left, &mut other.right);
        let swap = |s: String| {
            let s = s.replace("left member", "?").replace("right member", "left member");
            s.replace('?', "right member")
        };
        same(&table(&e, |s| s), &table(&other, swap));
    }
}

/// N reversed with My: what was pulled is pushed with the same force, and the bolts feel the same.
#[test]
fn reversed_actions_press_what_they_pulled() {
    let mut compared = 0;
    for seed in 1..=120 {
        let mut e = centred(seed);
        e.used = SpliceUse::Beam;
        let mut back = e.clone();
        for load in back.actions[0].live.iter_mut().flatten() {
            *load = -*load;
        }
        let (a, b) = (table(&e, |s| s), table(&back, |s| s));
        for ((part, id), [force, _]) in &a {
            let reversed = match id {
                CheckId::FlangeTension => CheckId::FlangeCompression,
                CheckId::FlangeCompression => CheckId::FlangeTension,
                CheckId::SpliceBoltShear | CheckId::SlipUltimate => *id,
                _ => continue,
            };
            let [other, _] = b[&(part.clone(), reversed)];
            assert!((force / other - 1.0).abs() < 1e-9, "{part} {id:?}: {force} {other}");
            compared += 1;
        }
    }
    assert!(compared > 400, "{compared}");
}

/// Worst utilisation of each check by id.
fn worst(e: &CoverSplice) -> BTreeMap<CheckId, f64> {
    let mut out = BTreeMap::new();
    for ((_, id), [demand, resistance]) in table(e, |s| s) {
        let used = if resistance > 0.0 { demand / resistance } else { f64::INFINITY };
        let most = out.entry(id).or_insert(used);
        *most = used.max(*most);
    }
    out
}

/// No check of the first is worse than in the second.
fn no_worse(e: &CoverSplice, than: &CoverSplice, ids: &[CheckId]) {
    let (a, b) = (worst(e), worst(than));
    for id in ids {
        let (Some(x), Some(y)) = (a.get(id), b.get(id)) else { continue };
        assert!(*x <= y * (1.0 + 1e-9), "{id:?}: {x} is more than {y}");
    }
}

const COVERS: [CheckId; 8] = [
    CheckId::CoverTension,
    CheckId::CoverCompression,
    CheckId::BearingResistance,
    CheckId::BearingAcross,
    CheckId::WebCoverShear,
    CheckId::WebCoverBending,
    CheckId::WebCoverBuckling,
    CheckId::WebCoverNetBending,
];

#[test]
fn thicker_covers_stronger_steel_and_less_load_never_harm() {
    for seed in 1..=120 {
        let mut e = random(seed);
        // the least moment acts in either sense, a larger one of its own in one
        if e.used == (SpliceUse::Column { contact: false }) {
            e.used = SpliceUse::Beam;
        }
        let mut thick = e.clone();
        thick.outer.thickness *= 1.2;
        thick.web.thickness *= 1.2;
        if let Some(inner) = &mut thick.inner {
            inner.plate.thickness *= 1.2;
        }
        no_worse(&thick, &e, &COVERS);
        let mut more = e.clone();
        for load in more.actions[0].live.iter_mut().flatten() {
            *load *= 1.3;
        }
        let all: Vec<CheckId> = worst(&e).into_keys().collect();
        no_worse(&e, &more, &all);
        let mut packed = e.clone();
        packed.left.packs = packed.left.packs.map(|t| t + 15.0);
        packed.left.web_packs += 15.0;
        no_worse(&e, &packed, &all);
        let (a, b) = (worst(&e), worst(&packed));
        let shear = |t: &BTreeMap<CheckId, f64>| t.get(&CheckId::SpliceBoltShear).copied();
        if e.left == e.right {
            assert!(shear(&a) < shear(&b) || shear(&a).is_none(), "packs reduce the shear");
        }
    }
}

/// At serviceability only slip is checked.
#[test]
fn serviceability_has_slip_alone() {
    for seed in 1..=60 {
        let mut e = random(seed);
        e.category = None;
        e.actions[0].state = LimitState::Serviceability;
        let found = splice_checks(&e);
        assert_eq!(found.serviceability, ["A"]);
        let loaded = found.checks.iter().filter(|c| c.case.is_some());
        let ids: Vec<CheckId> = loaded.clone().map(Check::id).collect();
        assert!(ids.iter().all(|id| *id == CheckId::SlipServiceability), "{ids:?}");
        assert!(loaded.clone().all(|c| c.status != Status::Failed), "no category: only a warning");
    }
}
