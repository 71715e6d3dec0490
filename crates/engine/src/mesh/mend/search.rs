//! Search for the changes that mend a tet: one, or a few in a row.

use super::draft::{Change, Draft, Undo};
use super::edges::{collapse, nearest, split};
use super::flips::{edge_removal, face_removal};
use super::moves::best_move;
use crate::mesh::tet::EDGES;

/// Changes in a row at most.
const LONGEST: usize = 3;

/// Changes that are followed up in rows of two and of three, the best first.
const WIDTH: [usize; LONGEST + 1] = [0, 0, 24, 6];

/// Factor by which the worst angle must rise; less may be rounding and is not worth a change.
const GAIN: f64 = 1.01;

/// The best changes found so far, and the worst shape that they leave.
struct Best {
    worst: f64,
    changes: Vec<Change>,
}

/// A search from a mesh as it is now.
struct Search<'d, 'p> {
    draft: &'d mut Draft<'p>,
    /// Number of the first tet that the search makes.
    first: usize,
    /// Changes made on the way, with the worst shape of the tets that have gone.
    made: Vec<(Change, f64)>,
    best: Option<Best>,
    /// Changes in a row.
    length: usize,
    enough: f64,
}

/// Improves the worst shape of a tet and of those that must change with it. Takes a single change
/// if it reaches the shape `enough`, else the best row of changes; longer rows are tried until they
/// reach `least`. Returns whether it found any.
pub fn improve(draft: &mut Draft, tet: u32, least: f64, enough: f64) -> bool {
    let first = draft.tets.len();
    let mut search = Search { draft, first, made: Vec::new(), best: None, length: 0, enough };
    for length in 1..=LONGEST {
        search.length = length;
        search.descend(tet, length);
        let wanted = if length == 1 { enough } else { least };
        if search.best.as_ref().is_some_and(|b| b.worst >= wanted) {
            break;
        }
    }
    let Some(best) = search.best else { return false };
    for change in best.changes {
        draft.make(change);
    }
    true
}

impl Search<'_, '_> {
    /// Tries changes of a tet, and up to `left − 1` further ones of the worst tet that they leave.
    fn descend(&mut self, tet: u32, left: usize) {
        // a step on the way may leave flat tets, the last one may not
        let rough = left > 1;
        let mut options: Vec<(f64, Change)> = Vec::new();
        for change in candidates(self.draft, tet, rough) {
            if let Some(worst) = self.draft.judge(&change, rough)
                && self.draft.conforms(&change)
            {
                options.push((worst, change));
            }
        }
        options.sort_by(|a, b| b.0.total_cmp(&a.0));
        if rough {
            options.truncate(WIDTH[self.length]);
        }
        for (_, change) in options {
            let undo = self.draft.make(change.clone());
            let before = self.made.last().map_or(f64::INFINITY, |(_, worst)| *worst);
            self.made.push((change, before.min(self.worst_gone(&undo))));
            let worst = self.note();
            if left > 1
                && let Some((own, next)) = worst
                && own < self.enough
            {
                self.descend(next, left - 1);
            }
            self.made.pop();
            self.draft.undo(undo);
        }
    }

    /// The worst shape of the tets older than the search that a change removed.
    fn worst_gone(&self, undo: &Undo) -> f64 {
        let old = undo.gone().iter().filter(|e| (**e as usize) < self.first);
        old.map(|e| self.draft.shape[*e as usize]).fold(f64::INFINITY, f64::min)
    }

    /// Notes the changes made if they are the best so far; returns the worst new tet.
    fn note(&mut self) -> Option<(f64, u32)> {
        let new = (self.first..self.draft.tets.len()).filter(|e| self.draft.alive[*e]);
        let worst = new
            .map(|e| (self.draft.shape[e], e as u32))
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let after = worst.map_or(f64::INFINITY, |(own, _)| own);
        let before = self.made.last().map_or(f64::INFINITY, |(_, gone)| *gone);
        let so_far = self.best.as_ref().map_or(0.0, |b| b.worst);
        if after > so_far && after > GAIN * before {
            let changes = self.made.iter().map(|(change, _)| change.clone()).collect();
            self.best = Some(Best { worst: after, changes });
        }
        worst
    }
}

/// The changes of a tet; splits only if `splitting`, because a split alone improves no shape.
fn candidates(d: &Draft, e: u32, splitting: bool) -> Vec<Change> {
    let tet = d.tets[e as usize];
    let pairs = EDGES.map(|edge| edge.map(|v| tet[v]));
    let mut all: Vec<Change> = Vec::new();
    all.extend(pairs.iter().filter_map(|[a, b]| edge_removal(d, *a, *b)));
    all.extend((0..4u8).filter_map(|local| face_removal(d, e, local)));
    all.extend(tet.iter().filter_map(|n| best_move(d, *n)));
    for [a, b] in pairs {
        all.extend([[a, b], [b, a]].into_iter().filter_map(|[from, to]| collapse(d, from, to)));
    }
    if splitting {
        for [a, b] in pairs {
            let other: Vec<u32> = tet.into_iter().filter(|n| ![a, b].contains(n)).collect();
            let at = nearest(d, [a, b], [other[0], other[1]]);
            all.push(split(d, a, b, at));
            if (at - 0.5).abs() > 0.1 {
                all.push(split(d, a, b, 0.5));
            }
        }
    }
    all
}
