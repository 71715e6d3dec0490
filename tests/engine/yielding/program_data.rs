//! The properties of a program that a solver relies on: every unknown is in its place, blocks are
//! definite, and elastic programs are unchanged.

use crate::common::Block;
use crate::common::yielding::{FORMS, Form, block, model};
use bracket::elements::hencky_kinematic::Flow;
use bracket::elements::yielding_element::NONE;
use bracket::programs::conic::SymmetricCsc;
use bracket::programs::explicit::Explicit;
use bracket::programs::{Kinematic, Static};
use faer::Mat;

/// Every element has its own unknowns and yield points. None occurs twice and none is missing. The
/// program is valid when it is written out.
#[test]
fn every_unknown_has_its_place() {
    let model = block(2, 1.0);
    for form in FORMS {
        let (own, points) = match form {
            Form::Plain => (20, 4),
            Form::Split => (80 + 15, 16),
            Form::Static => (30, 16),
        };
        let built = form.build(&model);
        let program = &built.program;
        let mut seen = vec![false; program.unknowns()];
        let mut rows = vec![false; program.h.len()];
        for batch in program.elements.batches.iter() {
            for (o, r) in batch.own.iter().zip(&batch.rows).filter(|(o, _)| **o != NONE) {
                let e = built.own.binary_search(&(*o as usize)).unwrap();
                assert_eq!(built.own[e + 1] - built.own[e], own, "{form:?}");
                seen[*o as usize..][..own]
                    .iter_mut()
                    .for_each(|s| assert!(!std::mem::replace(s, true)));
                rows[*r as usize..][..6 * points]
                    .iter_mut()
                    .for_each(|s| assert!(!std::mem::replace(s, true)));
            }
        }
        assert!(
            seen[program.shared()..].iter().all(|s| *s)
                && rows[program.g.nrows()..].iter().all(|s| *s),
            "{form:?}"
        );
        well_formed(&Explicit::new(program));
    }
}

/// Checks that columns are sorted, only the upper triangle is stored with every diagonal entry, and
/// sizes agree. No cone contains a maximised unknown.
fn well_formed(program: &Explicit) {
    let p = &program.p;
    assert_eq!(p.col_ptr.len(), p.n + 1);
    for c in 0..p.n {
        let rows = &p.row_idx[p.col_ptr[c]..p.col_ptr[c + 1]];
        assert!(rows.windows(2).all(|w| w[0] < w[1]), "column {c}");
        assert_eq!(rows.last(), Some(&(c as u32)));
    }
    assert_eq!((program.q.len(), program.maximised.len()), (p.n, p.n));
    assert_eq!(program.g.ncols, p.n);
    assert_eq!(program.g.nrows(), program.h.len());
    assert_eq!(program.h.len(), program.cones.iter().map(|c| c.dim()).sum::<usize>());
    assert!(
        (0..program.g.nrows()).all(|r| program.g.row(r).all(|(c, _)| !program.is_maximised(c)))
    );
}

/// Products of the program in element form and written out agree, scaled or not. So do products
/// with rows and their transposes.
#[test]
fn written_out_is_the_same() {
    let model = block(1, 1.0);
    for form in FORMS {
        let mut program = form.build(&model).program;
        for scaled in [false, true] {
            if scaled {
                program.elements.scale =
                    (0..program.unknowns()).map(|i| 1.0 + 0.3 * (i as f64).sin()).collect();
            }
            let explicit = Explicit::new(&program);
            let n = program.unknowns();
            let x: Vec<f64> = (0..explicit.p.n).map(|i| (1.7 * i as f64).cos()).collect();
            let (own, multipliers) = x.split_at(n);
            let z: Vec<f64> = vec![0.0; program.g.nrows()]
                .into_iter()
                .chain(multipliers.iter().copied())
                .collect();
            let [mut rows] = program.quadratic([own]);
            // maximised rows contain the multipliers of their points
            rows.iter_mut().zip(program.rows_transposed(&z)).for_each(|(r, g)| *r -= g);
            let written = explicit.p.mul(&x);
            let largest = rows.iter().fold(0.0f64, |m, r| m.max(r.abs()));
            assert!(
                rows.iter().zip(&written).all(|(a, b)| (a - b).abs() < 1e-12 * largest),
                "{form:?} {scaled}"
            );
            let points = program.rows(own);
            let behind = &written[n..];
            assert!(
                points[program.g.nrows()..].iter().zip(behind).all(|(a, b)| (a - b).abs() < 1e-12),
                "{form:?}"
            );
        }
    }
}

/// Eigenvalues of P for the unknowns that `pick` selects, in ascending order. Each unknown is
/// scaled by its diagonal entry.
fn eigenvalues(p: &SymmetricCsc, pick: impl Fn(usize) -> bool) -> Vec<f64> {
    let picked: Vec<usize> = (0..p.n).filter(|&i| pick(i)).collect();
    let d = p.diagonal();
    let scale = |i: usize| if d[i] == 0.0 { 1.0 } else { d[i].abs().sqrt().recip() };
    let mut m = Mat::<f64>::zeros(picked.len(), picked.len());
    for c in 0..p.n {
        for k in p.col_ptr[c]..p.col_ptr[c + 1] {
            let r = p.row_idx[k] as usize;
            if let (Ok(i), Ok(j)) = (picked.binary_search(&r), picked.binary_search(&c)) {
                let v = p.values[k] * scale(r) * scale(c);
                m[(i, j)] = v;
                m[(j, i)] = v;
            }
        }
    }
    let e = m.self_adjoint_eigen(faer::Side::Lower).unwrap();
    (0..picked.len()).map(|i| e.S().column_vector()[i]).collect()
}

/// The minimised block is positive semidefinite, the maximised one negative definite.
#[test]
fn blocks_are_definite() {
    let model = block(1, 1.0);
    for form in FORMS {
        let built = form.build(&model);
        let program = Explicit::new(&built.program);
        let minimised = eigenvalues(&program.p, |i| !program.is_maximised(i))[0];
        let maximised = eigenvalues(&program.p, |i| program.is_maximised(i));
        println!(
            "{form:?}: {minimised:e}, maximised {:e} to {:e}",
            maximised[0],
            maximised[maximised.len() - 1]
        );
        assert!(minimised > -1e-12, "{form:?}: {minimised:e}");
        assert!(maximised[maximised.len() - 1] < -1e-4, "{form:?}");
    }
}

/// Without a request for plasticity the programs equal the elastic ones entry for entry, with or
/// without a yield strength.
#[test]
fn elastic_programs_stay_as_they_are() {
    let yields = block(2, 1.0);
    let mut never = yields.clone();
    never.materials.iter_mut().for_each(|m| m.fy = None);
    let kinematic = Kinematic::new(&yields).unwrap();
    assert!(kinematic.program.elements.batches.is_empty() && kinematic.own.is_empty());
    for flow in [Flow::Plain, Flow::Split] {
        assert_eq!(Kinematic::with_plasticity(&never, flow).unwrap().program, kinematic.program);
    }
    let statics = Static::new(&yields).unwrap();
    assert_eq!(Static::with_plasticity(&never).unwrap().program, statics.program);
    assert!(statics.program.elements.batches.is_empty() && statics.own.is_empty());
}

/// Only the elements of bodies with a yield strength have unknowns of their own.
#[test]
fn elastic_bodies_stay_elastic() {
    let mesh = Block::new([2, 1, 1], [20.0, 10.0, 10.0]).mesh(
        &["A", "B"],
        |c| usize::from(c[0] > 10.0),
        |_, _| false,
    );
    let model = model(
        "bodies: {A: r, B: s}\nsupports:\n- {face: X0, fix: [x, y, z]}\nloads:\n- {face: X1, \
         traction: [1, 0, 0]}\n",
        mesh,
    );
    for (form, size) in [(Form::Plain, 20), (Form::Split, 95), (Form::Static, 30)] {
        let built = form.build(&model);
        for (e, body) in model.mesh.tet_body.iter().enumerate() {
            assert_eq!(
                built.own[e + 1] - built.own[e],
                if *body == 1 { size } else { 0 },
                "{form:?} tet {e}"
            );
        }
        well_formed(&Explicit::new(&built.program));
    }
}
