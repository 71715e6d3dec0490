//! Symbolic factor: permutation, supernodes, their rows and their updates; made once per pattern.
//!
//! It is found on the graph of blocks (nodes or faces), about ten times smaller than the matrix,
//! and then expanded.

use super::ordering::BlockGraph;
use super::pattern::Pattern;

/// Pairs (columns, fraction): supernodes are merged up to this number of columns when at most this
/// fraction of the merged block is zeros.
const RELAX: [(usize, f64); 4] = [(12, 0.9), (32, 0.3), (96, 0.12), (usize::MAX, 0.04)];

/// Layout of the factor of a matrix pattern.
pub struct Symbolic {
    /// Number of unknowns.
    pub n: usize,
    /// New position → old unknown.
    pub order: Vec<u32>,
    /// Old unknown → new position.
    pub position: Vec<u32>,
    /// First column of each supernode, and n.
    pub begin: Vec<u32>,
    /// Start of each supernode's rows below its own columns.
    pub row_start: Vec<usize>,
    /// Those rows, increasing within a supernode.
    pub rows: Vec<u32>,
    /// Start of each supernode's dense block, (columns + rows) × columns by columns, among the
    /// values.
    pub value_start: Vec<usize>,
    /// Parent of each supernode; `u32::MAX` for a root. Supernodes are in postorder.
    pub parent: Vec<u32>,
    /// First supernode of the subtree of each.
    pub first_descendant: Vec<u32>,
    /// Start of each supernode's updates.
    pub update_start: Vec<usize>,
    /// The supernodes that update each, in increasing order.
    pub updates: Vec<Update>,
    /// Floating-point operations of each supernode: its own factor and its updates of others.
    pub flops: Vec<f64>,
}

/// Rows of supernode `from` that lie among the columns of the one it updates.
#[derive(Clone, Copy, Debug)]
pub struct Update {
    /// The updating supernode.
    pub from: u32,
    /// First of those rows, counted in its rows.
    pub first: u32,
    /// Their number.
    pub count: u32,
}

/// A supernode while the tree is being built, on blocks.
struct Node {
    columns: Vec<u32>,
    /// Blocks below, increasing in the first ordering.
    below: Vec<u32>,
    zeros: f64,
}

impl Symbolic {
    /// Orders a pattern and lays out the factor of its matrices.
    pub fn new(pattern: &Pattern) -> Self {
        let Pattern { block, graph } = pattern;
        let blocks = graph.blocks();
        let mut weight = vec![0usize; blocks];
        block.iter().for_each(|&b| weight[b as usize] += 1);
        let order = postordered(graph, graph.nested_dissection());
        let (nodes, parent) = supernodes(graph, &order, &weight);
        let (nodes, parent) = merge(nodes, parent, &weight, &order);
        Self::expand(block, blocks, &order, nodes, &parent)
    }

    /// Number of supernodes.
    pub fn supernodes(&self) -> usize {
        self.begin.len() - 1
    }

    /// Columns of supernode `s`.
    pub fn columns(&self, s: usize) -> usize {
        (self.begin[s + 1] - self.begin[s]) as usize
    }

    /// Rows of supernode `s` below its columns.
    pub fn rows_of(&self, s: usize) -> &[u32] {
        &self.rows[self.row_start[s]..self.row_start[s + 1]]
    }

    /// Rows of its dense block: its columns and the rows below.
    pub fn height(&self, s: usize) -> usize {
        self.columns(s) + self.row_start[s + 1] - self.row_start[s]
    }

    /// Its updates.
    pub fn updates_of(&self, s: usize) -> &[Update] {
        &self.updates[self.update_start[s]..self.update_start[s + 1]]
    }

    /// Number of stored values, unused upper triangles of the diagonal blocks included.
    pub fn storage(&self) -> usize {
        self.value_start[self.supernodes()]
    }

    /// Nonzeros of the factor.
    pub fn nonzeros(&self) -> usize {
        (0..self.supernodes())
            .map(|s| self.columns(s) * (2 * self.height(s) - self.columns(s) + 1) / 2)
            .sum()
    }

    /// Lays out the merged supernodes in postorder and expands blocks to unknowns.
    fn expand(
        block: &[u32],
        blocks: usize,
        order: &[usize],
        nodes: Vec<Node>,
        parent: &[u32],
    ) -> Self {
        let n = block.len();
        let mut members: Vec<Vec<u32>> = vec![Vec::new(); blocks];
        block.iter().enumerate().for_each(|(i, &b)| members[b as usize].push(i as u32));
        let post = postorder(parent);
        let mut new_index = vec![0u32; parent.len()];
        post.iter().enumerate().for_each(|(k, &s)| new_index[s as usize] = k as u32);
        let mut out = Self {
            n,
            order: Vec::with_capacity(n),
            position: vec![0; n],
            begin: vec![0],
            row_start: vec![0],
            rows: Vec::new(),
            value_start: vec![0],
            parent: Vec::with_capacity(post.len()),
            first_descendant: (0..post.len() as u32).collect(),
            update_start: Vec::new(),
            updates: Vec::new(),
            flops: Vec::with_capacity(post.len()),
        };
        let mut first_position = vec![0u32; blocks];
        for &s in &post {
            for &b in &nodes[s as usize].columns {
                let b = order[b as usize];
                first_position[b] = out.order.len() as u32;
                out.order.extend(&members[b]);
            }
            out.begin.push(out.order.len() as u32);
            let p = parent[s as usize];
            out.parent.push(if p == u32::MAX { p } else { new_index[p as usize] });
        }
        out.order
            .iter()
            .enumerate()
            .for_each(|(new, &old)| out.position[old as usize] = new as u32);
        for (k, &s) in post.iter().enumerate() {
            let from = out.rows.len();
            for &b in &nodes[s as usize].below {
                let b = order[b as usize];
                let at = first_position[b];
                out.rows.extend(at..at + members[b].len() as u32);
            }
            out.rows[from..].sort_unstable();
            out.row_start.push(out.rows.len());
            let (c, m) = (out.columns(k), out.rows.len() - from);
            out.value_start.push(out.value_start[k] + (c + m) * c);
            let (c, m) = (c as f64, m as f64);
            out.flops.push(c * c * c / 3.0 + c * c * m + c * m * m);
            let p = out.parent[k];
            if p != u32::MAX {
                let first = out.first_descendant[k];
                let of_parent = &mut out.first_descendant[p as usize];
                *of_parent = first.min(*of_parent);
            }
        }
        out.list_updates();
        out
    }

    fn list_updates(&mut self) {
        let count = self.supernodes();
        let mut owner = vec![0u32; self.n];
        for s in 0..count {
            owner[self.begin[s] as usize..self.begin[s + 1] as usize].fill(s as u32);
        }
        // runs of rows with one owner
        let runs = |s: usize| {
            let rows = self.rows_of(s);
            let owner = &owner;
            let mut at = 0;
            std::iter::from_fn(move || {
                let first = at;
                let to = owner[*rows.get(first)? as usize];
                at += rows[first..].partition_point(|&r| owner[r as usize] == to);
                Some((
                    to as usize,
                    Update { from: s as u32, first: first as u32, count: (at - first) as u32 },
                ))
            })
        };
        let mut starts = vec![0usize; count + 1];
        (0..count).for_each(|s| runs(s).for_each(|(to, _)| starts[to + 1] += 1));
        for s in 0..count {
            starts[s + 1] += starts[s];
        }
        let mut next = starts.clone();
        let mut updates = vec![Update { from: 0, first: 0, count: 0 }; starts[count]];
        for s in 0..count {
            for (to, update) in runs(s) {
                updates[next[to]] = update;
                next[to] += 1;
            }
        }
        self.update_start = starts;
        self.updates = updates;
    }
}

/// An equivalent order in which every subtree of the elimination tree is contiguous.
fn postordered(graph: &BlockGraph, order: Vec<usize>) -> Vec<usize> {
    let post = postorder(&elimination_tree(graph, &order));
    post.into_iter().map(|k| order[k as usize]).collect()
}

/// Parent of each position; Liu's algorithm with path compression.
fn elimination_tree(graph: &BlockGraph, order: &[usize]) -> Vec<u32> {
    let position = inverse(order);
    let mut parent = vec![u32::MAX; order.len()];
    let mut ancestor = vec![u32::MAX; order.len()];
    for (j, &b) in order.iter().enumerate() {
        for &o in graph.of(b) {
            let mut i = position[o as usize];
            while i < j {
                let next = std::mem::replace(&mut ancestor[i], j as u32);
                if next == u32::MAX {
                    parent[i] = j as u32;
                    break;
                }
                if next as usize == j {
                    break;
                }
                i = next as usize;
            }
        }
    }
    parent
}

fn inverse(order: &[usize]) -> Vec<usize> {
    let mut position = vec![0; order.len()];
    order.iter().enumerate().for_each(|(new, &old)| position[old] = new);
    position
}

/// Children before parents, every subtree contiguous, children in increasing order.
fn postorder(parent: &[u32]) -> Vec<u32> {
    let n = parent.len();
    let (mut head, mut next) = (vec![u32::MAX; n], vec![u32::MAX; n]);
    for k in (0..n).rev() {
        let p = parent[k];
        if p != u32::MAX {
            next[k] = std::mem::replace(&mut head[p as usize], k as u32);
        }
    }
    let mut out = Vec::with_capacity(n);
    let mut stack: Vec<u32> = Vec::new();
    for root in (0..n).filter(|&k| parent[k] == u32::MAX) {
        stack.push(root as u32);
        while let Some(&k) = stack.last() {
            let child = head[k as usize];
            if child == u32::MAX {
                out.push(k);
                stack.pop();
            } else {
                // each child is taken from its list once
                head[k as usize] = next[child as usize];
                stack.push(child);
            }
        }
    }
    out
}

/// Supernodes of blocks with the same structure below, in a postordered order, and their parents.
fn supernodes(graph: &BlockGraph, order: &[usize], weight: &[usize]) -> (Vec<Node>, Vec<u32>) {
    let n = order.len();
    let position = inverse(order);
    let parent = elimination_tree(graph, order);
    let mut nodes: Vec<Node> = Vec::new();
    let mut node_of = vec![u32::MAX; n];
    let mut children: Vec<Vec<u32>> = vec![Vec::new(); n];
    let mut mark = vec![u32::MAX; n];
    let size = |list: &[u32]| list.iter().map(|&k| weight[order[k as usize]]).sum::<usize>();
    for j in 0..n {
        let mut below: Vec<u32> = Vec::new();
        mark[j] = j as u32;
        let mut add = |k: u32| {
            if k as usize > j && mark[k as usize] != j as u32 {
                mark[k as usize] = j as u32;
                below.push(k);
            }
        };
        graph.of(order[j]).iter().for_each(|&o| add(position[o as usize] as u32));
        for &c in &children[j] {
            nodes[c as usize].below.iter().for_each(|&k| add(k));
        }
        below.sort_unstable();
        // a child whose structure equals this block and the blocks below it absorbs the block
        let same = children[j].iter().copied().find(|&c| {
            let node = &nodes[c as usize];
            node.columns.last().is_some_and(|&l| l as usize + 1 == j)
                && node.below.len() == below.len() + 1
        });
        let s = match same {
            Some(c) if size(&nodes[c as usize].below) == size(&below) + weight[order[j]] => {
                let node = &mut nodes[c as usize];
                node.columns.push(j as u32);
                node.below = below;
                c
            }
            _ => {
                nodes.push(Node { columns: vec![j as u32], below, zeros: 0.0 });
                nodes.len() as u32 - 1
            }
        };
        node_of[j] = s;
        // registered with the parent; when the parent joins this supernode, with its parent again
        if parent[j] != u32::MAX {
            children[parent[j] as usize].push(s);
        }
        children[j] = Vec::new();
    }
    let parents = nodes
        .iter()
        .map(|node| {
            let last = node.columns.last().map_or(u32::MAX, |&l| parent[l as usize]);
            if last == u32::MAX { u32::MAX } else { node_of[last as usize] }
        })
        .collect();
    (nodes, parents)
}

/// Merges supernodes with their parents where that adds few zeros: larger dense blocks, fewer of
/// them.
fn merge(
    mut nodes: Vec<Node>,
    mut parent: Vec<u32>,
    weight: &[usize],
    order: &[usize],
) -> (Vec<Node>, Vec<u32>) {
    let n = nodes.len();
    let size = |list: &[u32]| list.iter().map(|&k| weight[order[k as usize]]).sum::<usize>();
    let mut width: Vec<usize> = nodes.iter().map(|n| size(&n.columns)).collect();
    let degree: Vec<usize> = nodes.iter().map(|n| size(&n.below)).collect();
    let mut children: Vec<Vec<u32>> = vec![Vec::new(); n];
    let mut gone = vec![false; n];
    // a parent comes after its children; merged children pass their own children on
    let mut by_last: Vec<usize> = (0..n).collect();
    by_last.sort_by_key(|&s| nodes[s].columns.last().copied());
    for &p in &by_last {
        loop {
            let cost = |c: usize| {
                let total = width[c] + width[p];
                let zeros = nodes[c].zeros
                    + nodes[p].zeros
                    + (width[c] * (width[p] + degree[p] - degree[c])) as f64;
                let entries = (total * (total + 1) / 2 + total * degree[p]) as f64;
                let allowed = RELAX
                    .iter()
                    .any(|&(columns, part)| total <= columns && zeros <= part * entries);
                allowed.then_some((zeros, c))
            };
            let best = children[p]
                .iter()
                .filter_map(|&c| cost(c as usize))
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let Some((zeros, c)) = best else { break };
            gone[c] = true;
            let mut columns = std::mem::take(&mut nodes[c].columns);
            columns.append(&mut nodes[p].columns);
            nodes[p].columns = columns;
            nodes[p].zeros = zeros;
            width[p] += width[c];
            let handed = std::mem::take(&mut children[c]);
            children[p].retain(|&o| o as usize != c);
            for o in handed {
                parent[o as usize] = p as u32;
                children[p].push(o);
            }
        }
        if parent[p] != u32::MAX {
            let up = parent[p] as usize;
            children[up].push(p as u32);
        }
    }
    let mut place = vec![u32::MAX; n];
    let mut kept = Vec::with_capacity(n);
    for s in 0..n {
        if !gone[s] {
            place[s] = kept.len() as u32;
            kept.push(s);
        }
    }
    let parents = kept
        .iter()
        .map(|&s| if parent[s] == u32::MAX { u32::MAX } else { place[parent[s] as usize] })
        .collect();
    let mut nodes: Vec<Option<Node>> = nodes.into_iter().map(Some).collect();
    let kept = kept.into_iter().filter_map(|s| nodes[s].take()).collect();
    (kept, parents)
}
