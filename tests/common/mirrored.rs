//! Six tets a cell of a structured grid, mirrored from cell to cell.
//!
//! A cell is cut along the paths from one corner to the opposite one. Neighbouring cells are mirror
//! images of each other, so their common face has one diagonal. In every grid plane the diagonals
//! form straight lines at 45° (of the cells) in both directions:
//!
//! ```text
//!   +---+---+---+---+
//!   | \ | / | \ | / |
//!   +---o---+---o---+    o: even nodes, counted from the phase
//!   | / | \ | / | \ |
//!   +---+---+---+---+
//! ```
//! A plate turns about a line of its middle plane without further dissipation if such diagonals
//! join that line with both of its surfaces. All diagonals of equal direction would obstruct it.

/// The corners of the six tets of the cell at `at`, as nodes of the grid. Their volumes are
/// positive. The paths start at the corner whose indices are even, counted from `phase`.
pub fn tets(at: [usize; 3], phase: [usize; 3]) -> [[[usize; 3]; 4]; 6] {
    let start: [usize; 3] = std::array::from_fn(|d| (at[d] + phase[d]) % 2);
    let mirrored = start.iter().sum::<usize>() % 2 == 1;
    [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]].map(|path| {
        let mut node: [usize; 3] = std::array::from_fn(|d| at[d] + start[d]);
        let mut tet = [node; 4];
        for (n, d) in path.into_iter().enumerate() {
            node[d] = at[d] + 1 - start[d];
            tet[n + 1] = node;
        }
        let odd = [[0, 2, 1], [2, 1, 0], [1, 0, 2]].contains(&path);
        if odd != mirrored {
            tet.swap(1, 2);
        }
        tet
    })
}
