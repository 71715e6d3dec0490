//! How the checks of a base behave.

use super::fixture::{actions, base};
use crate::check::{Check, CheckId, Status};
use crate::column_base::base_checks;
use crate::column_base::compression::whole;
use bracket_joint::assembly::ColumnBase;
use bracket_joint::strength::Nominal;

fn under(e: &ColumnBase, of: [f64; 3]) -> Vec<Check> {
    let e = ColumnBase { actions: vec![actions(of)], ..e.clone() };
    base_checks(&e).checks
}

/// Utilisations of the forces of both sides, in rising order.
fn used(all: &[Check]) -> Vec<f64> {
    let ids = [CheckId::BaseTension, CheckId::BaseFlangeCompression];
    let mut out: Vec<f64> =
        all.iter().filter(|c| ids.contains(&c.id())).filter_map(|c| c.utilisation).collect();
    out.sort_by(f64::total_cmp);
    out
}

#[test]
fn a_mirrored_moment_has_the_same_result() {
    let mut e = base();
    e.offset = 8.0;
    let mut mirrored = e.clone();
    mirrored.offset = -8.0;
    for axial in [-300e3, -40e3, 0.0, 40e3, 150e3] {
        for moment in [5e6, 30e6] {
            let [a, b] = [
                used(&under(&e, [axial, 0.0, moment])),
                used(&under(&mirrored, [axial, 0.0, -moment])),
            ];
            assert_eq!((a.len(), &a), (2, &b), "N = {axial}");
        }
    }
}

#[test]
fn stronger_concrete_never_carries_less() {
    let mut e = base();
    let mut last = 0.0;
    for f_ck in [12.0, 16.0, 20.0, 30.0, 50.0] {
        e.foundation.f_ck = Nominal::new(f_ck);
        e.foundation.grout_strength = Nominal::new(f_ck);
        let value = whole(&e).value;
        assert!(value > last, "{value} at {f_ck}");
        last = value;
    }
}

#[test]
fn grout_that_the_code_does_not_know_is_undecided() {
    let open = |e: &ColumnBase| {
        let all = under(e, [-100e3, 0.0, 0.0]);
        all.iter().any(|c| c.id() == CheckId::BaseGrout && c.status == Status::Undecided)
    };
    let mut e = base();
    assert!(!open(&e));
    e.foundation.grout_strength = Nominal::new(2.0);
    assert!(open(&e));
    let mut e = base();
    e.foundation.grout = 70.0;
    assert!(open(&e), "thicker than 0.2 times the width");
}

#[test]
fn friction_beyond_that_of_mortar_is_noted() {
    let mut e = base();
    assert!(base_checks(&e).notes.is_empty());
    e.foundation.friction = 0.35;
    let notes: Vec<String> = base_checks(&e).notes.iter().map(ToString::to_string).collect();
    assert!(notes.len() == 1 && notes[0].contains("C_f,d = 0.35"), "{notes:?}");
}

#[test]
fn an_anchorage_that_nobody_checked_is_undecided() {
    let status = |checked: bool, of: [f64; 3]| {
        let e = ColumnBase { anchorage_checked: checked, ..base() };
        under(&e, of).iter().find(|c| c.id() == CheckId::Anchorage).map(|c| c.status)
    };
    assert_eq!(status(false, [50e3, 0.0, 0.0]), Some(Status::Undecided));
    assert_eq!(status(true, [50e3, 0.0, 0.0]), Some(Status::Information));
    assert_eq!(status(false, [-500e3, 50e3, 0.0]), None, "friction carries the shear");
    assert_eq!(status(false, [-500e3, 150e3, 0.0]), Some(Status::Undecided));
}
