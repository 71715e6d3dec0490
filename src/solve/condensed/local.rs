//! Unknowns eliminated element by element, in batches of equal groups laid out for vector instructions.
//!
//! A group of m unknowns with k neighbours is a dense panel, `(m + k) × m`: its block H on top, its couplings below. Eight
//! groups of one shape lie interleaved, entry by entry, so that every operation runs on the eight at once. Eliminated are
//! the stages from the highest down; what a group leaves, `−B H⁻¹ Bᵀ`, goes to panels of lower stages or to the sparse
//! factor. Maximised groups have H negative definite and leave `+`.

use crate::model::program::SymmetricCsc;
use crate::solve::sparse::{LinearError, Locator, SparseCholesky};
use rayon::prelude::*;

/// Groups side by side in a batch.
const LANES: usize = 8;
/// Batches whose products are made in parallel before they are added one after the other.
const ROUND: usize = 32;
/// No unknown, no place.
const NONE: u32 = u32::MAX;

type Lane = [f64; LANES];

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
                    .map(|(batch, panel)| kernels::eliminate(panel, batch.m, batch.height(), batch.sign))
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
                kernels::forward(panel, batch.m, batch.height(), &mut work);
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
                kernels::backward(panel, batch.m, batch.height(), &mut work);
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

/// Dense operations on panels of eight groups at once.
mod kernels {
    use super::{LANES, Lane};

    /// Column `c` of the panel, from row `from` on.
    fn column(panel: &[Lane], height: usize, c: usize) -> &[Lane] {
        &panel[c * height..(c + 1) * height]
    }

    /// Cholesky of the leading m columns (of −H for sign −1), rows below solved; returns the products `X Xᵀ`, lower
    /// triangle by columns. `None` where a pivot is not positive.
    pub fn eliminate(panel: &mut [Lane], m: usize, height: usize, sign: f64) -> Option<Vec<Lane>> {
        if sign < 0.0 {
            for c in 0..m {
                panel[c * height..c * height + m].as_flattened_mut().iter_mut().for_each(|v| *v = -*v);
            }
        }
        let k = height - m;
        let mut products = vec![[0.0; LANES]; k * (k + 1) / 2];
        let positive = pulp::Arch::new().dispatch(
            #[inline(always)]
            || {
                for c in 0..m {
                    let (done, own) = panel.split_at_mut(c * height);
                    let own = &mut own[..height];
                    // four rows at a time stay in registers while the columns before are subtracted
                    let mut r = c;
                    while r < height {
                        let rows = (height - r).min(4);
                        if rows == 4 {
                            let mut sums = [own[r], own[r + 1], own[r + 2], own[r + 3]];
                            for j in 0..c {
                                let before = column(done, height, j);
                                let factor = before[c];
                                for (q, sum) in sums.iter_mut().enumerate() {
                                    for l in 0..LANES {
                                        sum[l] -= before[r + q][l] * factor[l];
                                    }
                                }
                            }
                            own[r..r + 4].copy_from_slice(&sums);
                        } else {
                            for q in r..height {
                                let mut sum = own[q];
                                for j in 0..c {
                                    let before = column(done, height, j);
                                    for l in 0..LANES {
                                        sum[l] -= before[q][l] * before[c][l];
                                    }
                                }
                                own[q] = sum;
                            }
                        }
                        r += rows;
                    }
                    let mut inverse = [0.0; LANES];
                    for l in 0..LANES {
                        if !(own[c][l] > 0.0) {
                            return false;
                        }
                        inverse[l] = own[c][l].sqrt().recip();
                    }
                    for row in &mut own[c..] {
                        for l in 0..LANES {
                            row[l] *= inverse[l];
                        }
                    }
                }
                let mut at = 0;
                for b in m..height {
                    let mut a = b;
                    while a < height {
                        let rows = (height - a).min(4);
                        let mut sums = [[0.0; LANES]; 4];
                        for j in 0..m {
                            let x = column(panel, height, j);
                            let factor = x[b];
                            for (q, sum) in sums.iter_mut().enumerate().take(rows) {
                                for l in 0..LANES {
                                    sum[l] += x[a + q][l] * factor[l];
                                }
                            }
                        }
                        products[at..at + rows].copy_from_slice(&sums[..rows]);
                        at += rows;
                        a += rows;
                    }
                }
                true
            },
        );
        positive.then_some(products)
    }

    /// `x ← L⁻¹ x` on top, `x ← −X (L⁻¹ x)` below.
    pub fn forward(panel: &[Lane], m: usize, height: usize, x: &mut [Lane]) {
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || {
                for c in 0..m {
                    let own = column(panel, height, c);
                    let mut y = x[c];
                    for l in 0..LANES {
                        y[l] /= own[c][l];
                    }
                    x[c] = y;
                    for r in c + 1..height {
                        for l in 0..LANES {
                            x[r][l] -= own[r][l] * y[l];
                        }
                    }
                }
            },
        );
    }

    /// `x ← L⁻ᵀ (x − Xᵀ x_below)` on top.
    pub fn backward(panel: &[Lane], m: usize, height: usize, x: &mut [Lane]) {
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || {
                for c in (0..m).rev() {
                    let own = column(panel, height, c);
                    let mut y = x[c];
                    for r in c + 1..height {
                        for l in 0..LANES {
                            y[l] -= own[r][l] * x[r][l];
                        }
                    }
                    for l in 0..LANES {
                        y[l] /= own[c][l];
                    }
                    x[c] = y;
                }
            },
        );
    }
}
