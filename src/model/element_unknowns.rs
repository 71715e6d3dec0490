//! Unknowns that belong to one element alone, appended to a program behind those that elements share.

use super::dofs::DofMap;
use super::program::{Cone, ConicProgram};
use rayon::prelude::*;

/// Elements whose unknowns exist beside the program at the same time.
const BATCH: usize = 512;

/// Rows of a von Mises cone: its axis and the five components of a deviator.
pub const YIELD_ROWS: usize = 6;

/// One unknown of an element, with its terms in the program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ElementUnknown {
    /// When it is eliminated, see [`ConicProgram::stage`].
    pub stage: u8,
    /// Maximised over.
    pub maximised: bool,
    /// Linear term.
    pub q: f64,
    /// Entries of P with full shared unknowns, see [`DofMap`].
    pub shared: Vec<(usize, f64)>,
    /// Entries of P with the element's own unknowns up to this one, positions increasing.
    pub own: Vec<(usize, f64)>,
}

/// All unknowns of one element that no other element touches.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ElementUnknowns {
    /// The unknowns in order.
    pub unknowns: Vec<ElementUnknown>,
    /// First unknown of each von Mises cone: it and the next five lie in K⁶.
    pub cones: Vec<usize>,
}

/// Appends the unknowns of the elements, `None` for an element without any, and their cones; returns where each
/// element's unknowns start: those of element `e` are `first[e]..first[e + 1]`.
pub fn append<E: Send>(
    program: &mut ConicProgram,
    map: &DofMap,
    elements: usize,
    unknowns: impl Fn(usize) -> Result<Option<ElementUnknowns>, E> + Sync,
) -> Result<Vec<usize>, E> {
    let mut first = vec![program.p.n];
    let mut start = 0;
    while start < elements {
        let end = (start + BATCH).min(elements);
        let batch: Vec<Option<ElementUnknowns>> =
            (start..end).into_par_iter().map(&unknowns).collect::<Result<_, E>>()?;
        for element in batch {
            if let Some(element) = element {
                append_element(program, map, &element);
            }
            first.push(program.p.n);
        }
        start = end;
    }
    program.g.ncols = program.p.n;
    Ok(first)
}

fn append_element(program: &mut ConicProgram, map: &DofMap, element: &ElementUnknowns) {
    let base = program.p.n;
    program.stage.resize(base, 0);
    program.maximised.resize(base, false);
    for (i, unknown) in element.unknowns.iter().enumerate() {
        // shared unknowns come first in the program: the column is sorted as it is written
        for (row, value) in map.row(&unknown.shared) {
            program.p.row_idx.push(row);
            program.p.values.push(value);
        }
        for &(row, value) in &unknown.own {
            program.p.row_idx.push((base + row) as u32);
            program.p.values.push(value);
        }
        if unknown.own.last().is_none_or(|last| last.0 != i) {
            // the diagonal is always stored
            program.p.row_idx.push((base + i) as u32);
            program.p.values.push(0.0);
        }
        program.p.col_ptr.push(program.p.row_idx.len());
        program.q.push(unknown.q);
        program.stage.push(unknown.stage);
        program.maximised.push(unknown.maximised);
    }
    program.p.n = base + element.unknowns.len();
    for &at in &element.cones {
        for i in 0..YIELD_ROWS {
            program.g.push_row(&[((base + at + i) as u32, 1.0)]);
            program.h.push(0.0);
        }
        program.cones.push(Cone::SecondOrder(YIELD_ROWS));
    }
}
