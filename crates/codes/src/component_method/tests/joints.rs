//! Whole joints: groups of rows, moment and axial force, splices, and inputs that must be refused.

use super::near;
use crate::CheckError;
use crate::component_method::joint::EndPlateJoint;
use crate::component_method::reference_cases::{column, one_sided};
use crate::component_method::t_stub::{Prying, TStub};
use crate::component_method::{Assessment, Equilibrium, assess, effective_lengths as lengths};
use std::f64::consts::PI;

/// 6.2.7.2(9): where the first row is as strong as its bolts, the rows below get their share by
/// lever arms alone.
#[test]
fn clause_6_2_7_2_9_limits_rows_below_strong_ones() {
    let mut joint = one_sided();
    joint.beta = 0.0;
    joint.column = Some(column("HEM300", 275.0));
    (joint.plate.thickness, joint.plate.width, joint.bolts.gauge) = (60.0, 200.0, 100.0);
    let a = assess(&joint).expect("covered");
    near(a.rows[0].force, 2.0 * joint.bolts.tension);
    for r in 1..a.rows.len() {
        assert!(a.rows[r].elastic);
        near(a.rows[r].grouped, a.rows[0].grouped * a.rows[r].lever / a.rows[0].lever);
    }
}

/// Stiffeners in the column part the rows into groups and stiffen the web: nothing gets weaker, k2
/// is infinite.
#[test]
fn clause_6_2_6_4_2_stiffened_column_flange() {
    let plain = assess(&one_sided()).expect("covered");
    let mut joint = one_sided();
    joint.column.as_mut().expect("a column").stiffener = 10.0;
    let stiff = assess(&joint).expect("covered");
    assert!(stiff.rows[1].groups.is_empty(), "stiffener and flange lie between rows 1 and 2");
    assert!(
        stiff.rows[2].groups.iter().all(|g| g.first == 1)
            && plain.rows[2].groups.iter().any(|g| g.first == 0)
    );
    assert!(stiff.stiffness.compression.is_none() && plain.stiffness.compression.is_some());
    assert!(
        stiff.moment.value > plain.moment.value
            && stiff.stiffness.initial.value > plain.stiffness.initial.value
    );
}

/// A splice of four rows, two beside either flange and mirror images of each other: in tension
/// without moment every row reaches its resistance alone or in its group, by hand with the tables;
/// in compression the splice carries N_pl,Rd; the curve is continuous at the axis.
#[test]
fn clause_6_2_7_1_plastic_equilibrium_of_moment_and_axial_force() {
    let mut joint = one_sided();
    (joint.column, joint.beta) = (None, 0.0);
    joint.plate.bottom = -joint.plate.top;
    joint.bolts.rows = vec![162.0, 90.0, -90.0, -162.0];
    joint.bolts.always_prying = true;
    let a = assess(&joint).expect("covered");
    let e = Equilibrium::new(&joint).expect("covered");
    // the two rows between the flanges: alone beside a flange each, or in a group whose ends are
    // beside a flange each
    let [outer, inner] = [0, 1].map(|r| a.rows[r].single);
    let (m, edge) = (0.5 * (71.0 - 6.6) - 0.8 * 2f64.sqrt() * 4.0, 0.5 * (135.0 - 71.0));
    let alpha = lengths::alpha(m, edge, 135.0 - 10.2 - 90.0 - 0.8 * 2f64.sqrt() * 6.0);
    let ends = 2.0 * (0.5 * 180.0 + alpha * m - (2.0 * m + 0.625 * edge));
    let lengths = ends.min(2.0 * (PI * m + 180.0));
    let stub = TStub {
        m,
        n: edge.min(1.25 * m),
        thickness: 13.0,
        fy: 275.0,
        length1: lengths,
        length2: ends,
        bolts: 4.0 * joint.bolts.tension,
        gamma_m0: 1.0,
        prying: Prying::Develops,
        washer_quarter: None,
    };
    let group = stub.resistance().worked.value.min(lengths * 6.6 * 275.0);
    near(e.tension, 2.0 * outer + group.min(2.0 * inner));
    near(e.compression, joint.beam.section.area * 275.0);
    // no moment: equal forces on both sides; no axial force: the moment resistance, or more without
    // its rule of the bolts
    let pulled = e.at(e.tension, 0.0).expect("a force acts");
    assert!(
        pulled.factor <= 1.0 + 1e-9
            && pulled.rows.iter().map(|r| r.force * r.z).sum::<f64>().abs() < 1.0
    );
    let bent = e.at(0.0, a.moment.value).expect("a moment acts");
    assert!((bent.factor - 1.0).abs() < 1e-6, "{}", bent.factor);
    // equilibrium with what acts, and an interaction curve that each ray crosses once
    for (n, m) in [(300e3, 40e6), (-800e3, 30e6), (100e3, -20e6), (-50e3, 60e6)] {
        let c = e.at(n, m).expect("they act");
        let pull: f64 = c.rows.iter().map(|r| r.force).sum();
        let push: f64 = c.compression.iter().sum();
        assert!((pull - push - c.factor * n).abs() < 1.0, "{n} {m}: {c:?}");
        let lever = 0.5 * (270.0 - 10.2);
        let turn = c.rows.iter().map(|r| r.force * r.z).sum::<f64>()
            + (c.compression[2] - c.compression[0]) * lever;
        assert!((turn - c.factor * m).abs() < 1e3, "{n} {m}: {turn}");
        let half = e.at(2.0 * n, 2.0 * m).expect("they act").factor;
        assert!((2.0 * half / c.factor - 1.0).abs() < 1e-6);
    }
    // the diagram of a symmetric joint is symmetric
    let diagram = e.diagram(a.moment.value, 16);
    assert_eq!(diagram.len(), 16);
    for i in 1..8 {
        let (up, down) = (diagram[i], diagram[16 - i]);
        assert!((up[0] - down[0]).abs() < 1.0 && (up[1] + down[1]).abs() < 1e3, "{up:?} {down:?}");
    }
}

/// Values for which the formulas have no meaning are refused by name.
#[test]
fn wrong_joints_are_refused_by_quantity() {
    type Change = fn(&mut EndPlateJoint);
    let wrong: [(&str, Change); 16] = [
        ("thickness of the plate", |j| j.plate.thickness = 0.0),
        ("width of the plate", |j| j.plate.width = f64::NAN),
        ("gauge of the bolts", |j| j.bolts.gauge = 150.0),
        ("number of rows", |j| j.bolts.rows.clear()),
        ("row of bolts", |j| j.bolts.rows[0] = 400.0),
        ("the same row stands twice", |j| j.bolts.rows[1] = j.bolts.rows[0]),
        ("tension resistance of a bolt", |j| j.bolts.tension = -1.0),
        ("beta", |j| j.beta = 2.5),
        ("gamma_M0", |j| j.gamma_m0 = f64::INFINITY),
        ("weld of the beam flange", |j| j.beam.flange_throat = -4.0),
        ("upper edge of the plate", |j| j.plate.top = 100.0),
        ("lower edge of the plate", |j| j.plate.bottom = 0.0),
        ("clear depth of the column web", |j| {
            j.column.as_mut().expect("a column").section.root = 70.0
        }),
        ("longitudinal stress", |j| j.column.as_mut().expect("a column").longitudinal = 300.0),
        ("it must lie on the column", |j| j.column.as_mut().expect("a column").above = Some(150.0)),
        ("yield strength of the beam", |j| j.beam.fy = 0.0),
    ];
    for (words, change) in wrong {
        let mut joint = one_sided();
        change(&mut joint);
        match assess(&joint) {
            Err(e @ CheckError::OutOfRange { .. }) => {
                assert!(e.to_string().contains(words), "{words}: {e}")
            }
            other => panic!("{words}: {other:?}"),
        }
    }
    let beyond: [(&str, Change); 5] = [
        ("outside the tension flange", |j| j.bolts.rows.push(175.0)),
        ("stands on the beam flange", |j| j.bolts.rows[1] = 128.0),
        ("root or weld of the column web", |j| j.bolts.gauge = 20.0),
        ("no row of bolts", |j| j.bolts.rows = vec![-140.0]),
        ("stands on a stiffener", |j| {
            j.column.as_mut().expect("a column").stiffener = 60.0;
            j.bolts.rows[0] = 155.0;
        }),
    ];
    for (words, change) in beyond {
        let mut joint = one_sided();
        change(&mut joint);
        match assess(&joint) {
            Err(e @ CheckError::NotCovered { .. }) => {
                assert!(e.to_string().contains(words), "{words}: {e}")
            }
            other => panic!("{words}: {other:?}"),
        }
    }
}

/// A splice is a joint to a column that nothing bends: the same rows and moment as with a column so
/// thick that plate and beam decide everywhere, and half of its flexibility in the plates.
#[test]
fn clause_6_2_7_splice_without_a_column() {
    let mut stiff = one_sided();
    stiff.beta = 0.0;
    stiff.bolts.always_prying = true;
    let column = stiff.column.as_mut().expect("a column");
    column.fy = 460.0;
    column.section.tf = 60.0;
    column.section.tw = 60.0;
    column.section.h = 400.0;
    column.section.b = 400.0;
    stiff.bolts.gauge = 100.0;
    stiff.plate.width = 170.0;
    let mut splice = stiff.clone();
    splice.column = None;
    let (with, without) = (assess(&stiff).expect("covered"), assess(&splice).expect("covered"));
    let forces = |a: &Assessment| a.rows.iter().map(|r| r.force).collect::<Vec<_>>();
    for (a, b) in forces(&with).into_iter().zip(forces(&without)) {
        near(a, b);
    }
    near(with.moment.value, without.moment.value);
    assert!(
        without.panel.is_none()
            && without.stiffness.panel.is_none()
            && without.stiffness.compression.is_none()
    );
    for (a, b) in with.stiffness.rows.iter().zip(&without.stiffness.rows) {
        near(a.plate, b.plate);
        near(1.0 / b.effective, 2.0 / b.plate + 1.0 / b.bolts);
        assert!(b.web.is_none() && b.flange.is_none() && a.web.is_some());
    }
}
