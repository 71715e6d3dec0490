use super::cholesky::SparseCholesky;
use super::error::LinearError;
use super::patterns::{MOST, Patterns};
use crate::programs::conic::SymmetricCsc;

/// Laplacian of a grid of nodes with three unknowns each, shifted to be definite; blocks are
/// the nodes.
fn grid(m: usize) -> (SymmetricCsc, Vec<u32>) {
    let node = |i: usize, j: usize, k: usize| (i * m + j) * m + k;
    let mut columns: Vec<Vec<(u32, f64)>> = vec![Vec::new(); 3 * m * m * m];
    for i in 0..m {
        for j in 0..m {
            for k in 0..m {
                let here = node(i, j, k);
                for d in 0..3 {
                    let column = 3 * here + d;
                    let before = [
                        (i > 0, i.wrapping_sub(1), j, k),
                        (j > 0, i, j.wrapping_sub(1), k),
                        (k > 0, i, j, k.wrapping_sub(1)),
                    ];
                    for (inside, a, b, c) in before {
                        if inside {
                            let other = node(a, b, c);
                            (0..3).for_each(|e| {
                                columns[column].push((
                                    (3 * other + e) as u32,
                                    if d == e { -1.0 } else { -0.2 },
                                ))
                            });
                        }
                    }
                    (0..d).for_each(|e| columns[column].push(((3 * here + e) as u32, 0.3)));
                    columns[column].push((column as u32, 8.0 + 0.01 * column as f64));
                    columns[column].sort_unstable_by_key(|e| e.0);
                }
            }
        }
    }
    let mut a = SymmetricCsc { n: columns.len(), col_ptr: vec![0], ..SymmetricCsc::default() };
    for column in columns {
        column.iter().for_each(|&(r, v)| {
            a.row_idx.push(r);
            a.values.push(v);
        });
        a.col_ptr.push(a.row_idx.len());
    }
    let block = (0..a.n as u32).map(|i| i / 3).collect();
    (a, block)
}

#[test]
fn solves_several_sides_to_rounding() {
    let (a, block) = grid(13);
    let factor =
        SparseCholesky::new(&a, &block, &Patterns::default()).expect("the matrix is definite");
    let sides: [Vec<f64>; 2] =
        std::array::from_fn(|k| (0..a.n).map(|i| ((7 * i + k) % 11) as f64 - 5.0).collect());
    let x = factor.solve_all([&sides[0], &sides[1]]);
    for (x, b) in x.iter().zip(&sides) {
        let ax = a.mul(x);
        let error = ax.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(error < 1e-12, "{error:e}");
        // one side alone goes through other kernels, to the same answer
        let alone = factor.solve(b);
        let off = alone.iter().zip(x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-13, "{off:e}");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let (a, block) = grid(14);
    let factors: Vec<Vec<f64>> = [1, 2, 3]
        .map(|threads| {
            let pool =
                rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| {
                SparseCholesky::new(&a, &block, &Patterns::default())
                    .expect("the matrix is definite")
                    .solve(&vec![1.0; a.n])
            })
        })
        .into();
    assert!(
        factors.windows(2).all(|w| w[0].iter().zip(&w[1]).all(|(a, b)| a.to_bits() == b.to_bits()))
    );
}

#[test]
fn an_indefinite_matrix_is_refused() {
    let (mut a, block) = grid(4);
    a.add_diagonal(50, -20.0);
    assert!(matches!(
        SparseCholesky::new(&a, &block, &Patterns::default()),
        Err(LinearError::Singular)
    ));
}

#[test]
fn a_node_joined_to_all_others_is_eliminated_last() {
    let (a, block) = grid(10);
    // one more block, joined to every node
    let mut b = SymmetricCsc { n: a.n + 1, ..a.clone() };
    b.row_idx.extend(0..=a.n as u32);
    b.values.extend(std::iter::repeat_n(0.001, a.n).chain([10.0]));
    b.col_ptr.push(b.row_idx.len());
    let blocks: Vec<u32> = block.iter().copied().chain([block[a.n - 1] + 1]).collect();
    let plain = SparseCholesky::symbolic(&a, &block, &Patterns::default()).expect("laid out");
    let bordered = SparseCholesky::symbolic(&b, &blocks, &Patterns::default()).expect("laid out");
    // a border costs one row
    assert!(bordered.nonzeros() < plain.nonzeros() + plain.nonzeros() / 20 + 2 * b.n);
    assert_eq!(bordered.layout.symbolic.order.last(), Some(&(a.n as u32)));
}

/// A ring of blocks of the given sizes, each coupled with the next; `couplings` joins more of
/// them.
fn ring(sizes: &[usize], couplings: &[(u32, u32)]) -> (SymmetricCsc, Vec<u32>) {
    let block: Vec<u32> = sizes.iter().enumerate().flat_map(|(b, &n)| vec![b as u32; n]).collect();
    let last = sizes.len() as u32 - 1;
    let joined = |i: u32, j: u32| {
        let (a, b) = (i.min(j), i.max(j));
        a + 1 >= b || (a, b) == (0, last) || couplings.contains(&(a, b))
    };
    let mut a = SymmetricCsc { n: block.len(), col_ptr: vec![0], ..SymmetricCsc::default() };
    for c in 0..block.len() {
        for r in 0..=c {
            if joined(block[r], block[c]) {
                a.row_idx.push(r as u32);
                a.values.push(if r == c { 50.0 + c as f64 } else { -1.0 / (1 + r + c) as f64 });
            }
        }
        a.col_ptr.push(a.row_idx.len());
    }
    (a, block)
}

#[test]
fn equal_patterns_are_laid_out_once_and_give_the_same_bits() {
    let (a, block) = ring(&[3; 40], &[]);
    let mut b = a.clone();
    b.values.iter_mut().for_each(|v| *v *= 2.0);
    let patterns = Patterns::default();
    let rhs: Vec<f64> = (0..a.n).map(|i| (i % 7) as f64 - 3.0).collect();
    let solved = |a: &SymmetricCsc, patterns: &Patterns| {
        let mut factor = SparseCholesky::symbolic(a, &block, patterns).expect("laid out");
        factor.refactor(a).expect("the matrix is definite");
        factor.solve(&rhs)
    };
    let [first, second] = [&a, &b].map(|a| solved(a, &patterns));
    assert_eq!(patterns.count(), (1, 1));
    assert_eq!(first, solved(&a, &Patterns::default()));
    assert_eq!(second, solved(&b, &Patterns::default()));
}

#[test]
fn patterns_that_differ_anywhere_have_layouts_of_their_own() {
    let patterns = Patterns::default();
    let mut sizes = [3; 20];
    let (a, block) = ring(&sizes, &[]);
    patterns.layout(&a, &block);
    let (joined, same) = ring(&sizes, &[(4, 11)]);
    patterns.layout(&joined, &same);
    sizes[7] = 2;
    let (smaller, of_it) = ring(&sizes, &[]);
    patterns.layout(&smaller, &of_it);
    assert_eq!(patterns.count(), (3, 0));
    // gaps in the numbers of blocks make no difference
    let gaps: Vec<u32> = block.iter().map(|b| 5 * b + 2).collect();
    patterns.layout(&a, &gaps);
    assert_eq!(patterns.count(), (3, 1));
}

#[test]
fn the_store_stays_small_and_drops_the_layout_not_used_for_longest() {
    let patterns = Patterns::default();
    let of = |k: u32| ring(&[2; 30], &[(3, 5 + k)]);
    let layout = |k: u32| {
        let (a, block) = of(k);
        drop(patterns.layout(&a, &block));
    };
    layout(0);
    layout(1);
    for k in 2..2 + MOST as u32 {
        // kept by its use
        layout(0);
        layout(k);
    }
    assert_eq!(patterns.count(), (MOST, MOST));
    layout(0);
    assert_eq!(patterns.count(), (MOST, MOST + 1));
    layout(1);
    assert_eq!(patterns.count(), (MOST, MOST + 1), "it was dropped");
}
