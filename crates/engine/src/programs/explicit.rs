//! A program with all elements assembled into one sparse matrix and one matrix of rows, for solvers
//! that do not support elements.
//!
//! The cones of yield points contain maximised unknowns. In the explicit form their multipliers
//! λ ∈ K⁶ become unknowns after all others, coupled to the parameters by `B`, with `h` as their
//! linear term; the multiplier of `λ ∈ K⁶` is then `h + B σ`.

use crate::elements::yielding_element::{NONE, Shape, VERTEX_VALUES, YIELD_ROWS};
use crate::programs::conic::{Cone, ConicProgram, Csr, SymmetricCsc};
use bracket_base::math::wide::LANES;

/// `½ xᵀPx + qᵀx`, minimised over some unknowns and maximised over the others; the cones contain
/// minimised unknowns only.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Explicit {
    /// The matrix of the saddle, `[P E; Eᵀ −F]`, every diagonal entry stored.
    pub p: SymmetricCsc,
    /// Linear term.
    pub q: Vec<f64>,
    /// Rows of the cones.
    pub g: Csr,
    /// Offsets of the rows.
    pub h: Vec<f64>,
    /// The cones.
    pub cones: Vec<Cone>,
    /// True for unknowns maximised over.
    pub maximised: Vec<bool>,
    /// Number of unknowns of the original program; the multipliers of its yield points follow.
    pub unknowns: usize,
    /// Number of rows of the contact cones of the original program; the rows of those multipliers
    /// follow.
    pub rows: usize,
}

impl Explicit {
    /// The explicit form of a program.
    pub fn new(program: &ConicProgram) -> Self {
        let (unknowns, rows) = (program.unknowns(), program.g.nrows());
        let n = unknowns + program.h.len() - rows;
        let mut columns: Vec<Vec<(u32, f64)>> = vec![Vec::new(); n];
        let p = &program.p;
        for (c, column) in columns.iter_mut().enumerate().take(p.n) {
            let range = p.col_ptr[c]..p.col_ptr[c + 1];
            column.extend(
                p.row_idx[range.clone()].iter().copied().zip(p.values[range].iter().copied()),
            );
        }
        let mut add = |i: usize, j: usize, v: f64| {
            if v != 0.0 {
                columns[i.max(j)].push((i.min(j) as u32, v));
            }
        };
        elements(program, &mut add);
        if let Some(last) = unknowns.checked_sub(1) {
            program.live.iter().enumerate().for_each(|(i, f)| add(i, last, -f));
        }
        let mut out = SymmetricCsc { n, col_ptr: vec![0], ..SymmetricCsc::default() };
        for (c, mut column) in columns.into_iter().enumerate() {
            column.push((c as u32, 0.0));
            column.sort_unstable_by_key(|e| e.0);
            for same in column.chunk_by(|a, b| a.0 == b.0) {
                out.row_idx.push(same[0].0);
                out.values.push(same.iter().map(|e| e.1).sum());
            }
            out.col_ptr.push(out.row_idx.len());
        }
        let mut g = program.g.clone();
        g.ncols = n;
        (unknowns..n).for_each(|i| g.push_row(&[(i as u32, 1.0)]));
        let (contact, points) = program.h.split_at(rows);
        let mut maximised = program.maximised();
        maximised.resize(n, false);
        Self {
            p: out,
            q: program.q.iter().chain(points).copied().collect(),
            g,
            h: contact.iter().copied().chain(points.iter().map(|_| 0.0)).collect(),
            cones: program.cones.clone(),
            maximised,
            unknowns,
            rows,
        }
    }

    /// True when unknown `i` is maximised over.
    pub fn is_maximised(&self, i: usize) -> bool {
        self.maximised.get(i).copied().unwrap_or(false)
    }
}

/// Adds the entries of the elements to P.
fn elements(program: &ConicProgram, add: &mut impl FnMut(usize, usize, f64)) {
    let scale = &program.elements.scale;
    let (unknowns, first_row) = (program.unknowns(), program.g.nrows());
    for batch in program.elements.batches.iter() {
        let [strain, _, volume, inner_part] = batch.parts();
        let (parameters, inner) = (batch.shape.parameters(), batch.shape.inner());
        for lane in (0..LANES).filter(|&l| batch.own[l] != NONE) {
            let own = batch.own[lane] as usize;
            // unknown and scale of a displacement of the element; `None` where it is held
            let moved = |i: usize| {
                let at = match i.checked_sub(inner) {
                    None => (own + parameters + i) as u32,
                    Some(i) => batch.columns[i][lane],
                };
                (at != NONE)
                    .then(|| (at as usize, if scale.is_empty() { 1.0 } else { scale[at as usize] }))
            };
            let all = batch.displacements();
            for i in 0..all {
                let Some((at, s)) = moved(i) else { continue };
                match batch.shape {
                    Shape::Stress => (0..parameters)
                        .for_each(|a| add(at, own + a, s * strain[a * all + i][lane])),
                    Shape::Flow { subtets, rule, pressures, .. } => {
                        let mut a = 0;
                        for subtet in 0..subtets {
                            for weights in rule.points() {
                                for d in 0..5 {
                                    let value = |v: usize| {
                                        strain[(subtet * VERTEX_VALUES + 5 * v + d) * all + i][lane]
                                    };
                                    add(
                                        at,
                                        own + a,
                                        s * (0..4).map(|v| weights[v] * value(v)).sum::<f64>(),
                                    );
                                    a += 1;
                                }
                            }
                        }
                        if i >= inner {
                            let row = |p: usize| volume[p * batch.shared() + i - inner][lane];
                            (0..pressures).for_each(|p| add(at, own + a + p, s * row(p)));
                        }
                    }
                }
                for c in 0..inner {
                    let Some((column, t)) = moved(c) else { continue };
                    // the inner block is stored whole
                    if i >= inner || i <= c {
                        add(at, column, s * t * inner_part[c * all + i][lane]);
                    }
                }
            }
            for c in 0..parameters {
                (0..=c).for_each(|r| add(own + r, own + c, -batch.flexibility_of(lane, r, c)));
            }
            let first = unknowns + batch.rows[lane] as usize - first_row;
            for point in 0..batch.shape.points() {
                for d in 0..5 {
                    let multiplier = first + YIELD_ROWS * point + 1 + d;
                    match batch.shape {
                        Shape::Stress => (0..parameters).for_each(|a| {
                            add(multiplier, own + a, volume[(5 * point + d) * 30 + a][lane])
                        }),
                        Shape::Flow { .. } => add(multiplier, own + 5 * point + d, 1.0),
                    }
                }
            }
        }
    }
}
