//! Appends the elements that yield to a program.

use super::batch::{Batch, NONE, Placed, Shape, YIELD_ROWS, YieldingElement};
use super::dofs::DofMap;
use super::program::{Cone, ConicProgram, Elements};
use crate::math::wide::LANES;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Elements that exist beside the program at the same time.
const AT_A_TIME: usize = 512;

/// Full unknowns of an element in the program's unknowns.
pub struct Columns {
    /// The program's unknowns; `NONE`: held.
    pub unknowns: Vec<u32>,
    /// For each full unknown its terms: position in `unknowns`, factor. `None`: full unknowns and columns are the same.
    terms: Option<Vec<Vec<(usize, f64)>>>,
}

impl Columns {
    /// The columns of an element with the given full unknowns.
    pub fn new(map: &DofMap, dofs: &[usize]) -> Self {
        // motions of rigid faces move several full unknowns at once
        let single = |d: &usize| map.terms(*d).is_empty() || map.own(*d).is_some();
        if dofs.iter().all(single) {
            let unknown = |d: &usize| map.terms(*d).first().map_or(NONE, |t| t.0);
            return Self { unknowns: dofs.iter().map(unknown).collect(), terms: None };
        }
        let mut unknowns: Vec<u32> = dofs.iter().flat_map(|d| map.terms(*d)).map(|t| t.0).collect();
        unknowns.sort_unstable();
        unknowns.dedup();
        let place = |u: u32| unknowns.partition_point(|v| *v < u);
        let terms = dofs.iter().map(|d| map.terms(*d).iter().map(|&(u, c)| (place(u), c)).collect()).collect();
        Self { unknowns, terms: Some(terms) }
    }

    /// A row on the full unknowns, in the columns.
    pub fn row(&self, full: &[f64]) -> Vec<f64> {
        let Some(terms) = &self.terms else { return full.to_vec() };
        let mut out = vec![0.0; self.unknowns.len()];
        for (value, terms) in full.iter().zip(terms) {
            terms.iter().for_each(|&(at, c)| out[at] += c * value);
        }
        out
    }
}

/// Appends the elements' own unknowns and yield points to a program, `None` for an element that does not yield; returns
/// where each element's unknowns start: those of element `e` are `first[e]..first[e + 1]`.
pub fn append<E: Send>(
    program: &mut ConicProgram,
    elements: usize,
    element: impl Fn(usize) -> Result<Option<YieldingElement>, E> + Sync,
) -> Result<Vec<usize>, E> {
    let mut first = vec![program.q.len()];
    let mut waiting: BTreeMap<(Shape, usize), Vec<Placed>> = BTreeMap::new();
    let mut batches = Vec::new();
    let mut start = 0;
    while start < elements {
        let end = (start + AT_A_TIME).min(elements);
        let some: Vec<Option<YieldingElement>> =
            (start..end).into_par_iter().map(&element).collect::<Result<_, E>>()?;
        for element in some {
            if let Some(element) = element {
                let (own, row) = (program.q.len() as u32, program.h.len() as u32);
                program.q.extend(&element.q);
                program.stiffness.resize(own as usize + element.shape.parameters(), 1.0);
                program.stiffness.extend(&element.inner_stiffness);
                program.h.extend(&element.h);
                program.cones.extend((0..element.shape.points()).map(|_| Cone::SecondOrder(YIELD_ROWS)));
                let same = waiting.entry((element.shape, element.columns.len())).or_default();
                same.push((element, own, row));
                if same.len() == LANES {
                    batches.push(Batch::new(same));
                    same.clear();
                }
            }
            first.push(program.q.len());
        }
        start = end;
    }
    batches.extend(waiting.values().filter(|same| !same.is_empty()).map(|same| Batch::new(same)));
    program.elements = Elements { batches: Arc::new(batches), scale: Vec::new() };
    Ok(first)
}
