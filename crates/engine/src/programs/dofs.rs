//! Map between the full unknowns of the elements and the unknowns of the program: held, free, or
//! moving with a rigid face.

use crate::elements::columns::Columns;
use crate::elements::yielding_element::NONE;
use std::ops::Range;

/// Each full unknown as a linear combination of the program's unknowns; an empty combination is
/// held at zero.
#[derive(Clone, Debug, Default)]
pub struct DofMap {
    start: Vec<usize>,
    terms: Vec<(u32, f64)>,
    /// Number of the program's unknowns.
    pub n: usize,
    /// The first `plain` unknowns are full unknowns, of one point or of the points of a tie; then
    /// come motions of rigid faces.
    pub plain: usize,
    /// Number of closures of preloaded cuts; they follow the motions of rigid faces.
    pub closures: usize,
    /// Number of unknowns of the motions of resultant limits; they follow the closures.
    pub motions: usize,
    /// Number of closings of ground that gives way; they are the last unknowns.
    closing_count: usize,
    /// Prescribed closures: unknown and value \[mm\].
    pub frozen: Vec<(usize, f64)>,
    /// Block (node, face or rigid motion) of each unknown, for fill-reducing orderings.
    pub block: Vec<u32>,
}

impl DofMap {
    /// Builds the map from the combination of each full unknown.
    pub fn new(combinations: Vec<Vec<(u32, f64)>>, plain: usize, block: Vec<u32>) -> Self {
        let mut start = Vec::with_capacity(combinations.len() + 1);
        let mut terms = Vec::with_capacity(combinations.len());
        start.push(0);
        for c in combinations {
            terms.extend(c);
            start.push(terms.len());
        }
        Self { start, terms, n: block.len(), plain, block, ..Self::default() }
    }

    /// The combination of full unknown `i`.
    pub fn terms(&self, i: usize) -> &[(u32, f64)] {
        &self.terms[self.start[i]..self.start[i + 1]]
    }

    /// The program's unknown equal to full unknown `i`, if there is one.
    pub fn own(&self, i: usize) -> Option<usize> {
        match self.terms(i) {
            [(k, c)] if (*k as usize) < self.plain && *c == 1.0 => Some(*k as usize),
            _ => None,
        }
    }

    /// Number of motions of rigid faces.
    pub fn rigid(&self) -> usize {
        self.n - self.plain - self.closures - self.motions - self.closing_count
    }

    /// The unknowns of the motions of resultant limits.
    pub fn limit_motions(&self) -> Range<usize> {
        let end = self.closings().start;
        end - self.motions..end
    }

    /// Appends the closings of the ground, each a block of its own.
    pub fn append_closings(&mut self, count: usize) {
        let first = self.block.iter().max().map_or(0, |b| b + 1);
        self.block.extend(first..first + count as u32);
        self.n += count;
        self.closing_count = count;
    }

    /// The unknowns of the closings of the ground.
    pub fn closings(&self) -> Range<usize> {
        self.n - self.closing_count..self.n
    }

    /// True when full unknown `i` follows others: across a preloaded cut, or along an oblique face
    /// on which a body slips.
    pub fn follows(&self, i: usize) -> bool {
        self.own(i).is_none() && self.terms(i).iter().any(|(k, _)| (*k as usize) < self.plain)
    }

    /// Overwrites the prescribed closures in a solution with their exact values.
    pub fn keep_frozen(&self, x: &mut [f64]) {
        self.frozen.iter().for_each(|&(k, value)| x[k] = value);
    }

    /// Number of full unknowns.
    pub fn full(&self) -> usize {
        self.start.len() - 1
    }

    /// Full values of the program's unknowns `x`.
    pub fn expand(&self, x: &[f64]) -> Vec<f64> {
        (0..self.full())
            .map(|i| self.terms(i).iter().map(|&(k, c)| c * x[k as usize]).sum())
            .collect()
    }

    /// Forces on the program's unknowns from forces on the full ones (the transpose of
    /// [`Self::expand`]).
    pub fn reduce(&self, f: &[f64]) -> Vec<f64> {
        let mut r = vec![0.0; self.n];
        for (i, &fi) in f.iter().enumerate() {
            for &(k, c) in self.terms(i) {
                r[k as usize] += c * fi;
            }
        }
        r
    }

    /// Diagonal of the stiffness on the program's unknowns from a diagonal stiffness on the full
    /// unknowns.
    pub fn reduce_diagonal(&self, d: &[f64]) -> Vec<f64> {
        let mut r = vec![0.0; self.n];
        for (i, &di) in d.iter().enumerate() {
            self.terms(i).iter().for_each(|&(k, c)| r[k as usize] += c * c * di);
        }
        r
    }

    /// The columns of an element with the given full unknowns, each unknown once.
    pub fn columns(&self, dofs: &[usize]) -> Columns {
        // motions of rigid faces move several full unknowns at once; both sides of a tie share one
        let single = |d: &usize| self.terms(*d).is_empty() || self.own(*d).is_some();
        if dofs.iter().all(single) {
            let unknown = |d: &usize| self.terms(*d).first().map_or(NONE, |t| t.0);
            let unknowns: Vec<u32> = dofs.iter().map(unknown).collect();
            let mut sorted: Vec<u32> = unknowns.iter().copied().filter(|u| *u != NONE).collect();
            sorted.sort_unstable();
            if sorted.windows(2).all(|w| w[0] != w[1]) {
                return Columns { unknowns, terms: None };
            }
        }
        let mut unknowns: Vec<u32> =
            dofs.iter().flat_map(|d| self.terms(*d)).map(|t| t.0).collect();
        unknowns.sort_unstable();
        unknowns.dedup();
        let place = |u: u32| unknowns.partition_point(|v| *v < u);
        let terms = dofs
            .iter()
            .map(|d| self.terms(*d).iter().map(|&(u, c)| (place(u), c)).collect())
            .collect();
        Columns { unknowns, terms: Some(terms) }
    }

    /// A row `Σ wᵢ uᵢ` of full unknowns in the program's unknowns, columns increasing, cancelled
    /// terms dropped.
    pub fn row(&self, full: &[(usize, f64)]) -> Vec<(u32, f64)> {
        let mut row: Vec<(u32, f64)> = full
            .iter()
            .flat_map(|&(i, w)| self.terms(i).iter().map(move |&(k, c)| (k, c * w)))
            .collect();
        row.sort_unstable_by_key(|t| t.0);
        let largest = row.iter().map(|t| t.1.abs()).fold(0.0, f64::max);
        let mut merged: Vec<(u32, f64)> = Vec::with_capacity(row.len());
        for (k, w) in row {
            match merged.last_mut() {
                Some(last) if last.0 == k => last.1 += w,
                _ => merged.push((k, w)),
            }
        }
        merged.retain(|t| t.1.abs() > 1e-13 * largest);
        merged
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two full unknowns that are one, as on both sides of a tie, are one column: their forces on
    /// it cancel.
    #[test]
    fn a_shared_unknown_is_one_column() {
        let combinations = vec![vec![(0, 1.0)], vec![(0, 1.0)], vec![(1, 1.0)], vec![]];
        let columns = DofMap::new(combinations, 2, vec![0, 1]).columns(&[0, 1, 2, 3]);
        assert_eq!(columns.unknowns, [0, 1]);
        assert_eq!(columns.row(&[2.0, -2.0, 5.0, 7.0]), [0.0, 5.0]);
        let apart = vec![vec![(0, 1.0)], vec![(1, 1.0)], vec![]];
        let columns = DofMap::new(apart, 2, vec![0, 1]).columns(&[0, 1, 2]);
        assert_eq!(columns.unknowns, [0, 1, NONE]);
    }
}
