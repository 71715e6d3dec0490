//! A tree of axis-parallel boxes, which finds those close to another box without looking at all.

use super::flat::Bounds;

/// Boxes of a leaf.
const LEAF: usize = 4;

/// A binary tree of boxes.
#[derive(Clone, Debug)]
pub struct Boxes {
    boxes: Vec<Bounds>,
    /// Numbers of the boxes; every node of the tree has a range of them.
    order: Vec<usize>,
    root: Option<Node>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: Bounds,
    /// Range of `order`.
    range: [usize; 2],
    /// Absent in a leaf.
    halves: Option<Box<[Node; 2]>>,
}

impl Boxes {
    /// The tree of the boxes.
    pub fn new(boxes: Vec<Bounds>) -> Self {
        let mut order: Vec<usize> = (0..boxes.len()).collect();
        let root = node(&boxes, &mut order, 0);
        Self { boxes, order, root }
    }

    /// Numbers of the boxes that are closer than `margin` \[mm\] to `of`, in increasing order.
    pub fn near(&self, of: &Bounds, margin: f64) -> Vec<usize> {
        let mut found = Vec::new();
        let mut open: Vec<&Node> = self.root.iter().collect();
        while let Some(node) = open.pop() {
            if !node.bounds.near(of, margin) {
                continue;
            }
            match &node.halves {
                Some(halves) => open.extend(halves.iter()),
                None => {
                    let numbers = self.order[node.range[0]..node.range[1]].iter().copied();
                    found.extend(numbers.filter(|i| self.boxes[*i].near(of, margin)));
                }
            }
        }
        found.sort_unstable();
        found
    }
}

/// The tree of the boxes `order`, which begin at `first` in the order of the whole tree. It splits
/// them at the median of their centres along the longest side.
fn node(boxes: &[Bounds], order: &mut [usize], first: usize) -> Option<Node> {
    let bounds = order.iter().map(|i| boxes[*i]).reduce(Bounds::union)?;
    let range = [first, first + order.len()];
    if order.len() <= LEAF {
        return Some(Node { bounds, range, halves: None });
    }
    let length = |k: &usize| bounds.max[*k] - bounds.min[*k];
    let axis = (0..3).max_by(|i, j| length(i).total_cmp(&length(j))).unwrap_or(0);
    let centre = |i: usize| boxes[i].min[axis] + boxes[i].max[axis];
    order.sort_by(|i, j| centre(*i).total_cmp(&centre(*j)).then(i.cmp(j)));
    let middle = order.len() / 2;
    let (low, high) = order.split_at_mut(middle);
    let halves = [node(boxes, low, first)?, node(boxes, high, first + middle)?];
    Some(Node { bounds, range, halves: Some(Box::new(halves)) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tree_finds_what_a_look_at_all_boxes_finds() {
        let at = |i: usize| {
            let f = |a: f64| 100.0 * (a * i as f64).fract();
            let min = [f(0.7548), f(0.5698), f(0.3247)];
            Bounds { min, max: min.map(|x| x + 3.0 + (i % 5) as f64) }
        };
        let boxes: Vec<Bounds> = (0..200).map(at).collect();
        let tree = Boxes::new(boxes.clone());
        let mut all = 0;
        for of in &boxes {
            let slow: Vec<usize> = (0..boxes.len()).filter(|i| boxes[*i].near(of, 1.5)).collect();
            assert_eq!(tree.near(of, 1.5), slow);
            all += slow.len();
        }
        assert!(all > 250, "{all} pairs, more than each box with itself");
        assert!(Boxes::new(Vec::new()).near(&boxes[0], 1e9).is_empty());
    }
}
