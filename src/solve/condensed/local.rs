//! Unknowns eliminated element by element, in batches of equal groups laid out for vector instructions.
//!
//! A group of m unknowns with k neighbours is a dense panel, `(m + k) × m`: its block H on top, its couplings below. Eight
//! groups of one shape lie interleaved, entry by entry, so that every operation runs on the eight at once. Eliminated are
//! the stages from the highest down; what a group leaves, `−B H⁻¹ Bᵀ`, goes to panels of lower stages or to the sparse
//! factor. Maximised groups have H negative definite and leave `+`.

use super::panel::{self, LANES, Lane};
use crate::model::program::SymmetricCsc;
use crate::solve::sparse::{LinearError, Locator, SparseCholesky};
use rayon::prelude::*;

/// Batches whose products are made in parallel before they are added one after the other.
const ROUND: usize = 32;
/// No unknown, no place.
const NONE: u32 = u32::MAX;

/// Groups of one stage and one shape, side by side.
struct Batch {
    stage: u8,
    /// +1, or −1 for maximised unknowns.
    sign: f64,
    /// Unknowns of a group.
    m: usize,
    /// Neighbours of a group.
    k: usize,
    /// Unknowns of the groups, then their neighbours: entry i of lane l at `i LANES + l`; `NONE` in unused lanes.
    members: Vec<u32>,
    /// Place of each product (a ≥ b, packed by columns b) of each lane.
    places: Vec<u32>,
    /// Start of its panels, in lanes.
    start: usize,
}

impl Batch {
    fn height(&self) -> usize {
        self.m + self.k
    }

    fn products(&self) -> usize {
        self.k * (self.k + 1) / 2
    }

    fn len(&self) -> usize {
        self.height() * self.m
    }
}

/// All local elimination of a program.
#[derive(Default)]
pub struct Local {
    batches: Vec<Batch>,
    panels: Vec<Lane>,
    /// Number of each unknown among those that stay; `NONE` for the eliminated.
    kept: Vec<u32>,
    /// The unknowns that stay.
    stay: Vec<u32>,
    /// Batch and lane of each eliminated unknown, and its number in its group.
    home: Vec<(u32, u32, u32)>,
    /// Length of the sparse factor's storage; places from there on are panels.
    offset: usize,
}

/// Where entries of the matrix are added: the sparse factor's storage, or a panel.
pub struct Store<'a> {
    factor: &'a mut [f64],
    panels: &'a mut [Lane],
}

impl Store<'_> {
    /// Adds to an entry.
    pub fn add(&mut self, place: u32, value: f64) {
        let at = place as usize;
        if at < self.factor.len() {
            self.factor[at] += value;
        } else {
            self.panels.as_flattened_mut()[at - self.factor.len()] += value;
        }
    }
}

impl Local {
    /// Finds the groups in the `pattern` of the whole matrix; returns the pattern and the blocks of what stays.
    pub fn new(
        pattern: SymmetricCsc,
        stage: &[u8],
        maximised: &[bool],
        block: &[u32],
    ) -> Result<(Self, SymmetricCsc, Vec<u32>), LinearError> {
        let last = stage.iter().copied().max().unwrap_or(0);
        if last == 0 {
            if maximised.contains(&true) {
                return Err(LinearError::Setup("a maximised unknown must be eliminated locally".into()));
            }
            return Ok((Self::default(), pattern, block.to_vec()));
        }
        let n = pattern.n;
        // neighbours of the same and of lower stages, of every unknown that is eliminated
        let mut near: Vec<Vec<u32>> = vec![Vec::new(); n];
        for c in 0..n {
            for &r in &pattern.row_idx[pattern.col_ptr[c]..pattern.col_ptr[c + 1]] {
                let (sr, sc) = (stage[r as usize], stage[c]);
                if sr > 0 && sr >= sc && r as usize != c {
                    near[r as usize].push(c as u32);
                }
                if sc > 0 && sc >= sr && r as usize != c {
                    near[c].push(r);
                }
            }
        }
        let mut local = Self { home: vec![(NONE, 0, 0); n], kept: vec![NONE; n], ..Self::default() };
        for (i, _) in stage.iter().enumerate().filter(|(_, s)| **s == 0) {
            local.kept[i] = local.stay.len() as u32;
            local.stay.push(i as u32);
        }
        let mut groups: Vec<Group> = Vec::new();
        for t in (1..=last).rev() {
            groups.extend(groups_of(t, stage, maximised, &mut near)?);
        }
        let reduced = local.reduced_pattern(&pattern, &groups);
        local.batch(groups);
        let block = local.stay.iter().map(|&i| block[i as usize]).collect();
        Ok((local, reduced, block))
    }

    /// True when nothing is eliminated here.
    pub fn is_empty(&self) -> bool {
        self.batches.is_empty()
    }

    /// Memory \[bytes\].
    pub fn bytes(&self) -> usize {
        let batch = |b: &Batch| b.len() * LANES * 8 + 4 * (b.members.len() + b.products() * LANES);
        self.batches.iter().map(batch).sum::<usize>() + 16 * self.home.len()
    }

    /// Floating-point operations of one elimination.
    pub fn flops(&self) -> f64 {
        let one = |b: &Batch| {
            let (m, k) = (b.m as f64, b.k as f64);
            LANES as f64 * (m * m * m / 3.0 + m * m * k + m * k * k)
        };
        self.batches.iter().map(one).sum()
    }

    fn reduced_pattern(&self, pattern: &SymmetricCsc, groups: &[Group]) -> SymmetricCsc {
        let mut columns: Vec<Vec<u32>> = vec![Vec::new(); self.stay.len()];
        for (c, &old) in self.stay.iter().enumerate() {
            let rows = &pattern.row_idx[pattern.col_ptr[old as usize]..pattern.col_ptr[old as usize + 1]];
            columns[c].extend(rows.iter().map(|&r| self.kept[r as usize]).filter(|&r| r != NONE));
        }
        for group in groups {
            let near: Vec<u32> = group.near.iter().map(|&i| self.kept[i as usize]).filter(|&i| i != NONE).collect();
            for (j, &c) in near.iter().enumerate() {
                columns[c as usize].extend_from_slice(&near[..=j]);
            }
        }
        let mut out = SymmetricCsc { n: columns.len(), col_ptr: vec![0], ..SymmetricCsc::default() };
        for mut rows in columns {
            rows.sort_unstable();
            rows.dedup();
            out.row_idx.extend_from_slice(&rows);
            out.col_ptr.push(out.row_idx.len());
        }
        out
    }

    /// Lays groups of one stage and shape side by side.
    fn batch(&mut self, mut groups: Vec<Group>) {
        groups.sort_by_key(|g| (std::cmp::Reverse(g.stage), g.maximised, g.members.len(), g.near.len()));
        let shape = |g: &Group| (g.stage, g.maximised, g.members.len(), g.near.len());
        let mut start = 0;
        for same in groups.chunk_by(|a, b| shape(a) == shape(b)) {
            for lanes in same.chunks(LANES) {
                let (stage, maximised, m, k) = shape(&lanes[0]);
                let mut members = vec![NONE; (m + k) * LANES];
                for (l, group) in lanes.iter().enumerate() {
                    for (i, &unknown) in group.members.iter().chain(&group.near).enumerate() {
                        members[i * LANES + l] = unknown;
                        if i < m {
                            self.home[unknown as usize] = (self.batches.len() as u32, l as u32, i as u32);
                        }
                    }
                }
                let sign = if maximised { -1.0 } else { 1.0 };
                let batch = Batch { stage, sign, m, k, members, places: Vec::new(), start };
                start += batch.len();
                self.batches.push(batch);
            }
        }
    }

    /// Looks up where every product goes, once the sparse factor is laid out.
    pub fn locate(&mut self, factor: &SparseCholesky) {
        self.offset = factor.len();
        let mut locator = factor.locator();
        let mut all = Vec::with_capacity(self.batches.len());
        for batch in &self.batches {
            let mut places = Vec::with_capacity(batch.products() * LANES);
            for b in batch.m..batch.height() {
                for a in b..batch.height() {
                    for l in 0..LANES {
                        let (i, j) = (batch.members[a * LANES + l], batch.members[b * LANES + l]);
                        places.push(if i == NONE { NONE } else { self.place(&mut locator, i, j) });
                    }
                }
            }
            all.push(places);
        }
        self.batches.iter_mut().zip(all).for_each(|(batch, places)| batch.places = places);
    }

    /// Place of the entry of two unknowns.
    pub fn place(&self, locator: &mut Locator<'_>, i: u32, j: u32) -> u32 {
        if self.is_empty() {
            return locator.place(i, j);
        }
        let (a, b) = (self.kept[i as usize], self.kept[j as usize]);
        if a != NONE && b != NONE {
            return locator.place(a, b);
        }
        let of = |i: u32| self.home[i as usize];
        let (hi, hj) = (of(i), of(j));
        // batches are in the order of elimination: the entry belongs to the unknown that goes first
        let (first, other, other_home) = if hi.0 <= hj.0 { (hi, j, hj) } else { (hj, i, hi) };
        let batch = &self.batches[first.0 as usize];
        let same = (first.0, first.1) == (other_home.0, other_home.1);
        let (column, row) = if same {
            (first.2.min(other_home.2) as usize, first.2.max(other_home.2) as usize)
        } else {
            let is_other = |&r: &usize| batch.members[r * LANES + first.1 as usize] == other;
            (first.2 as usize, (batch.m..batch.height()).find(is_other).unwrap_or(0))
        };
        (self.offset + (batch.start + column * batch.height() + row) * LANES + first.1 as usize) as u32
    }

    /// The storage of panels, cleared, beside the cleared storage of the sparse factor.
    pub fn store<'a>(&'a mut self, factor: &'a mut [f64]) -> Store<'a> {
        let len = self.batches.last().map_or(0, |b| b.start + b.len());
        self.panels.clear();
        self.panels.resize(len, [0.0; LANES]);
        for batch in &self.batches {
            for l in (0..LANES).filter(|&l| batch.members[l] == NONE) {
                (0..batch.m).for_each(|i| self.panels[batch.start + i * batch.height() + i][l] = batch.sign);
            }
        }
        Store { factor, panels: &mut self.panels }
    }

    /// Eliminates all groups; what they leave is added to the sparse factor's storage.
    pub fn eliminate(&mut self, factor: &mut [f64]) -> Result<(), LinearError> {
        let Self { batches, panels, .. } = self;
        for stage in batches.chunk_by(|a, b| a.stage == b.stage) {
            for round in stage.chunks(ROUND) {
                let from = round[0].start;
                let (end, last) = (round[round.len() - 1].start, &round[round.len() - 1]);
                let mut rest = &mut panels[from..end + last.len()];
                let mut parts = Vec::with_capacity(round.len());
                for batch in round {
                    let (panel, after) = std::mem::take(&mut rest).split_at_mut(batch.len());
                    parts.push((batch, panel));
                    rest = after;
                }
                let products: Option<Vec<Vec<Lane>>> = parts
                    .into_par_iter()
                    .map(|(batch, panel)| panel::eliminate(panel, batch.m, batch.height(), batch.sign))
                    .collect();
                let products = products.ok_or(LinearError::Singular)?;
                let mut store = Store { factor: &mut *factor, panels: &mut *panels };
                for (batch, products) in round.iter().zip(&products) {
                    for (&place, value) in batch.places.iter().zip(products.as_flattened()) {
                        if place != NONE {
                            store.add(place, -batch.sign * value);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Carries right-hand sides to the unknowns that stay; the second part is needed to come back.
    pub fn condense<const SIDES: usize>(&self, b: [&[f64]; SIDES]) -> ([Vec<f64>; SIDES], [Vec<f64>; SIDES]) {
        let mut full = b.map(<[f64]>::to_vec);
        let mut work = Vec::new();
        for batch in &self.batches {
            let panel = &self.panels[batch.start..batch.start + batch.len()];
            for side in &mut full {
                batch.gather(side, &mut work, batch.m);
                work.resize(batch.height(), [0.0; LANES]);
                panel::forward(panel, batch.m, batch.height(), &mut work);
                for (i, lanes) in work.iter().enumerate() {
                    for (l, &v) in lanes.iter().enumerate() {
                        let unknown = batch.members[i * LANES + l];
                        if unknown == NONE {
                        } else if i < batch.m {
                            side[unknown as usize] = v;
                        } else {
                            side[unknown as usize] += batch.sign * v;
                        }
                    }
                }
            }
        }
        let condensed = std::array::from_fn(|k| self.stay.iter().map(|&i| full[k][i as usize]).collect());
        (condensed, full)
    }

    /// All unknowns from those that stay.
    pub fn expand<const SIDES: usize>(&self, x: [Vec<f64>; SIDES], mut kept: [Vec<f64>; SIDES]) -> [Vec<f64>; SIDES] {
        let mut work = Vec::new();
        for (full, x) in kept.iter_mut().zip(&x) {
            self.stay.iter().zip(x).for_each(|(&i, v)| full[i as usize] = *v);
        }
        for batch in self.batches.iter().rev() {
            let panel = &self.panels[batch.start..batch.start + batch.len()];
            for full in &mut kept {
                batch.gather(full, &mut work, batch.height());
                panel::backward(panel, batch.m, batch.height(), &mut work);
                for (i, lanes) in work[..batch.m].iter().enumerate() {
                    for (l, &v) in lanes.iter().enumerate() {
                        let unknown = batch.members[i * LANES + l];
                        if unknown != NONE {
                            full[unknown as usize] = batch.sign * v;
                        }
                    }
                }
            }
        }
        kept
    }
}

impl Batch {
    fn gather(&self, from: &[f64], work: &mut Vec<Lane>, count: usize) {
        work.clear();
        work.extend(self.members[..count * LANES].chunks_exact(LANES).map(|unknowns| {
            std::array::from_fn(|l| if unknowns[l] == NONE { 0.0 } else { from[unknowns[l] as usize] })
        }));
    }
}

/// A group of unknowns and their neighbours of lower stages.
struct Group {
    stage: u8,
    maximised: bool,
    members: Vec<u32>,
    near: Vec<u32>,
}

/// Groups of stage `t`: what its unknowns' couplings join; their neighbours are joined to each other in `near`.
fn groups_of(t: u8, stage: &[u8], maximised: &[bool], near: &mut [Vec<u32>]) -> Result<Vec<Group>, LinearError> {
    let mut seen = vec![false; stage.len()];
    let mut groups = Vec::new();
    for i in 0..stage.len() {
        if stage[i] != t || seen[i] {
            continue;
        }
        seen[i] = true;
        let (mut members, mut around) = (vec![i as u32], Vec::new());
        let mut at = 0;
        while at < members.len() {
            for &o in &near[members[at] as usize] {
                if stage[o as usize] < t {
                    around.push(o);
                } else if !std::mem::replace(&mut seen[o as usize], true) {
                    members.push(o);
                }
            }
            at += 1;
        }
        members.sort_unstable();
        around.sort_unstable();
        around.dedup();
        let is_maximised = |i: u32| maximised.get(i as usize).copied().unwrap_or(false);
        let sign = is_maximised(members[0]);
        if members.iter().any(|&i| is_maximised(i) != sign) {
            return Err(LinearError::Setup("a group of local unknowns is minimised and maximised over at once".into()));
        }
        groups.push(Group { stage: t, maximised: sign, members, near: around });
    }
    for group in &groups {
        for &a in group.near.iter().filter(|&&a| stage[a as usize] > 0) {
            let list = &mut near[a as usize];
            list.extend(group.near.iter().filter(|&&b| b != a && stage[b as usize] <= stage[a as usize]));
            list.sort_unstable();
            list.dedup();
        }
    }
    Ok(groups)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::program::Csr;
    use crate::solve::condensed::cones::Cones;
    use crate::solve::condensed::system::CondensedSystem;

    /// A chain of shared unknowns; between two of them hangs a group of stage 1, and on it one of stage 2.
    fn chain(links: usize, maximised: bool) -> (SymmetricCsc, Vec<u8>, Vec<bool>) {
        let shared = links + 1;
        let n = shared + 5 * links;
        let mut dense = vec![vec![0.0; n]; n];
        let mut stage = vec![0u8; n];
        let mut negative = vec![false; n];
        for i in 0..shared {
            dense[i][i] = 4.0 + i as f64 / 10.0;
        }
        for l in 0..links {
            let first = shared + 5 * l;
            for i in 0..5 {
                let at = first + i;
                stage[at] = if i < 3 { 1 } else { 2 };
                negative[at] = maximised && i < 3;
                dense[at][at] = if negative[at] { -3.0 - l as f64 / 7.0 } else { 3.0 + l as f64 / 5.0 };
            }
            let mut join = |a: usize, b: usize, v: f64| {
                dense[a.min(b)][a.max(b)] = v;
            };
            join(first, first + 1, 0.5);
            join(first + 1, first + 2, -0.4);
            join(first + 3, first + 4, 0.7);
            join(first + 3, first + 1, 0.3);
            join(first + 4, first + 2, 0.6);
            join(first, l, 0.8);
            join(first + 2, l + 1, -0.9);
            join(first + 4, l, 0.2);
        }
        let mut p = SymmetricCsc { n, col_ptr: vec![0], ..SymmetricCsc::default() };
        for c in 0..n {
            for r in (0..=c).filter(|&r| dense[r][c] != 0.0) {
                p.row_idx.push(r as u32);
                p.values.push(dense[r][c]);
            }
            p.col_ptr.push(p.row_idx.len());
        }
        (p, stage, negative)
    }

    #[test]
    fn local_and_sparse_elimination_together_solve_the_whole() {
        for maximised in [false, true] {
            // one batch full, one with unused lanes
            let (p, stage, negative) = chain(11, maximised);
            let g = Csr { ncols: p.n, ..Csr::default() };
            let cones = Cones::new(&[]);
            let block: Vec<u32> = (0..p.n as u32).collect();
            let mut system =
                CondensedSystem::new(p.clone(), &g, &cones, &stage, &negative, &block).expect("the groups are small");
            assert_eq!(system.forecast().unknowns, 12);
            system.factor_start(&cones).expect("definite once the groups are gone");
            let b: Vec<f64> = (0..p.n).map(|i| ((3 * i) % 7) as f64 - 3.0).collect();
            let [x] = system.solve([&b]);
            let error = p.mul(&x).iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(error < 1e-13, "maximised {maximised}: {error:e}");
        }
    }

    #[test]
    fn a_group_of_both_kinds_is_refused() {
        let (p, stage, mut negative) = chain(3, true);
        negative[4] = !negative[4];
        let g = Csr { ncols: p.n, ..Csr::default() };
        let block: Vec<u32> = (0..p.n as u32).collect();
        assert!(CondensedSystem::new(p, &g, &Cones::new(&[]), &stage, &negative, &block).is_err());
    }
}
