//! What a solver may rely on: small groups in every stage, definite blocks, elastic programs untouched.

use crate::common::Block;
use crate::common::yielding::{FORMS, Form, block, model};
use bracket::model::program::{ConicProgram, SymmetricCsc};
use bracket::model::{Flow, Kinematic, Static};
use faer::Mat;

/// The groups of unknowns of each stage above 0: unknowns of one stage that P or a cone joins.
fn groups(program: &ConicProgram, stage: u8) -> Vec<Vec<usize>> {
    let mut leader: Vec<usize> = (0..program.p.n).collect();
    fn find(leader: &mut [usize], mut i: usize) -> usize {
        while leader[i] != i {
            leader[i] = leader[leader[i]];
            i = leader[i];
        }
        i
    }
    let mut join = |a: usize, b: usize| {
        if program.stage[a] == stage && program.stage[b] == stage {
            let (a, b) = (find(&mut leader, a), find(&mut leader, b));
            leader[a.max(b)] = a.min(b);
        }
    };
    let p = &program.p;
    for c in 0..p.n {
        (p.col_ptr[c]..p.col_ptr[c + 1]).filter(|&k| p.values[k] != 0.0).for_each(|k| join(p.row_idx[k] as usize, c));
    }
    for (start, cone) in program.cone_starts().into_iter().zip(&program.cones) {
        let columns: Vec<usize> = (start..start + cone.dim()).flat_map(|r| program.g.row(r).map(|t| t.0)).collect();
        columns.iter().for_each(|&c| join(columns[0], c));
    }
    let mut members = std::collections::BTreeMap::<usize, Vec<usize>>::new();
    for i in (0..p.n).filter(|&i| program.stage[i] == stage) {
        members.entry(find(&mut leader, i)).or_default().push(i);
    }
    members.into_values().collect()
}

/// Every group lies in one element, has the size its element promises, and no unknown is missed.
#[test]
fn groups_are_small() {
    let model = block(2, 1.0);
    let tets = model.mesh.tets.len();
    for form in FORMS {
        // (stage, groups per element, size)
        let stages: &[(u8, usize, usize)] = match form {
            Form::Plain => &[(1, 1, 24)],
            Form::Split => &[(2, 4, 24), (1, 1, 15)],
            Form::Static => &[(2, 16, 6), (1, 1, 30)],
        };
        let built = form.build(&model);
        let program = &built.program;
        let shared = built.block.len();
        assert!(program.stage[..shared].iter().all(|s| *s == 0) && program.stage[shared..].iter().all(|s| *s > 0));
        let mut counted = shared;
        for &(stage, count, size) in stages {
            let groups = groups(program, stage);
            assert_eq!(groups.len(), count * tets, "{form:?} stage {stage}");
            for g in &groups {
                assert_eq!(g.len(), size, "{form:?} stage {stage}");
                let e = built.own.partition_point(|first| *first <= g[0]) - 1;
                assert!(g.iter().all(|i| (built.own[e]..built.own[e + 1]).contains(i)), "{form:?}: {g:?}");
                counted += g.len();
            }
        }
        assert_eq!(counted, program.p.n);
        // no cone touches an unknown that is maximised over, and each keeps to one stage
        for (start, cone) in program.cone_starts().into_iter().zip(&program.cones) {
            let columns: Vec<usize> = (start..start + cone.dim()).flat_map(|r| program.g.row(r).map(|t| t.0)).collect();
            assert!(columns.iter().all(|&c| !program.is_maximised(c) && program.stage[c] == program.stage[columns[0]]));
        }
        well_formed(program);
    }
}

/// Columns sorted, upper triangle, every diagonal entry stored, sizes that agree.
fn well_formed(program: &ConicProgram) {
    let p = &program.p;
    assert_eq!(p.col_ptr.len(), p.n + 1);
    for c in 0..p.n {
        let rows = &p.row_idx[p.col_ptr[c]..p.col_ptr[c + 1]];
        assert!(rows.windows(2).all(|w| w[0] < w[1]), "column {c}");
        assert_eq!(rows.last(), Some(&(c as u32)));
    }
    assert_eq!((program.q.len(), program.stage.len(), program.maximised.len()), (p.n, p.n, p.n));
    assert_eq!(program.g.ncols, p.n);
    assert_eq!(program.g.nrows(), program.h.len());
    assert_eq!(program.h.len(), program.cones.iter().map(|c| c.dim()).sum::<usize>());
}

/// Eigenvalues of P among the unknowns that `pick` selects, increasing, each unknown measured by its diagonal.
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

/// The minimised block is semidefinite, the maximised one negative definite; displacements alone are definite, and so
/// is the plastic block of the kinematic programs.
#[test]
fn blocks_are_definite() {
    let model = block(1, 1.0);
    for form in FORMS {
        let built = form.build(&model);
        let program = &built.program;
        let lowest = |pick: &dyn Fn(usize) -> bool| eigenvalues(&program.p, pick)[0];
        let minimised = lowest(&|i| !program.is_maximised(i));
        println!("{form:?}: lowest eigenvalue of the minimised block {minimised:e}");
        assert!(minimised > -1e-12, "{form:?}: {minimised:e}");
        if form == Form::Static {
            let maximised = eigenvalues(&program.p, |i| program.is_maximised(i));
            println!("{form:?}: maximised block from {:e} to {:e}", maximised[0], maximised[maximised.len() - 1]);
            assert!(maximised[maximised.len() - 1] < -1e-4, "{form:?}");
            continue;
        }
        let own_stage = program.stage.iter().copied().max().unwrap();
        let moved = lowest(&|i| program.stage[i] < own_stage);
        let strained = lowest(&|i| program.stage[i] == own_stage && program.p.diagonal()[i] != 0.0);
        println!("{form:?}: displacements {moved:e}, plastic strains {strained:e}");
        assert!(moved > 1e-4 && strained > 0.1, "{form:?}");
    }
}

/// Plasticity is asked for, or the programs are the elastic ones entry for entry, yield strength or not.
#[test]
fn elastic_programs_stay_as_they_are() {
    let yields = block(2, 1.0);
    let mut never = yields.clone();
    never.materials.iter_mut().for_each(|m| m.fy = None);
    let kinematic = Kinematic::new(&yields).unwrap();
    assert!(kinematic.program.stage.is_empty() && kinematic.program.maximised.is_empty() && kinematic.own.is_empty());
    for flow in [Flow::Plain, Flow::Split] {
        assert_eq!(Kinematic::with_plasticity(&never, flow).unwrap().program, kinematic.program);
    }
    let statics = Static::new(&yields).unwrap();
    assert_eq!(Static::with_plasticity(&never).unwrap().program, statics.program);
    assert!(statics.program.stage.is_empty() && statics.own.is_empty());
}

/// Only the elements of bodies with a yield strength have unknowns of their own.
#[test]
fn elastic_bodies_stay_elastic() {
    let mesh = Block::new([2, 1, 1], [20.0, 10.0, 10.0]).mesh(&["A", "B"], |c| usize::from(c[0] > 10.0), |_, _| false);
    let model = model(
        "bodies: {A: r, B: s}\nsupports:\n- {face: X0, fix: [x, y, z]}\nloads:\n- {face: X1, traction: [1, 0, 0]}\n",
        mesh,
    );
    for (form, size) in [(Form::Plain, 24), (Form::Split, 111), (Form::Static, 126)] {
        let built = form.build(&model);
        for (e, body) in model.mesh.tet_body.iter().enumerate() {
            assert_eq!(built.own[e + 1] - built.own[e], if *body == 1 { size } else { 0 }, "{form:?} tet {e}");
        }
        well_formed(&built.program);
    }
}
