//! Appends elements that yield to a program.

use crate::elements::packed_elements::Batch;
use crate::elements::packed_elements::Placed;
use crate::elements::yielding_element::{Shape, YIELD_ROWS, YieldingElement};
use crate::programs::conic::{Cone, ConicProgram, Elements};
use bracket_base::math::wide::LANES;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Number of elements in memory at a time, besides the batches.
const AT_A_TIME: usize = 512;

/// Appends the own unknowns and yield points of elements to a program; `element` returns `None` for
/// an element that does not yield. Returns the first own unknown of each element: those of element
/// `e` are `first[e]..first[e + 1]`.
pub fn append<E: Send>(
    program: &mut ConicProgram,
    elements: usize,
    element: impl Fn(usize) -> Result<Option<YieldingElement>, E> + Sync,
) -> Result<Vec<usize>, E> {
    let mut first = vec![program.q.len()];
    let mut waiting: BTreeMap<(Shape, usize, bool), Vec<Placed>> = BTreeMap::new();
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
                program
                    .cones
                    .extend((0..element.shape.points()).map(|_| Cone::SecondOrder(YIELD_ROWS)));
                let (columns, mapped) = (element.columns.len(), !element.maps.is_empty());
                let same = waiting.entry((element.shape, columns, mapped)).or_default();
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
