//! Energy rates on a smooth solution: longitudinal shear of an equilateral triangular prism under
//! its weight.
//!
//! ```text
//!         /\        lateral faces held along z, ends held in x and y (free along z),
//!        /  \       body force b along z:  G Δw = −b,  w = 0 on the sides
//!       /____\  a
//! ```
//! Source: A. J. C. B. de Saint-Venant, De la torsion des prismes (1855): the warping problem ∇²ψ =
//! −2, ψ = 0 on the sides, has the cubic solution ψ ∝ l₁ l₂ l₃ with torsion constant J = 2∫ψ = √3
//! a⁴ / 80. Here w = (b / 2G) ψ, so Π = −½ b ∫ w L = −√3 a⁴ b² L / (640 G).
//!
//! Expected: the strain is quadratic and both elements have linear strain or stress. The error of
//! each energy therefore falls as h⁴, and so does the gap. The measured rates over two refinements
//! must lie between 3.5 and 4.6: the meshes are structured and of one family, but the coarsest one
//! has only 3 segments.

use crate::common::prism::Prism;
use crate::common::solved::solve;

#[test]
fn gap_and_both_errors_fall_with_the_fourth_power() {
    let (a, length, b, e, nu) = (10.0f64, 5.0, 3.0, 1000.0, 0.25);
    let g = e / (2.0 * (1.0 + nu));
    let exact = -(3f64.sqrt()) * a.powi(4) * b * b * length / (640.0 * g);
    let corners = [[0.0, 0.0], [a, 0.0], [0.5 * a, 0.5 * 3f64.sqrt() * a]];
    let yaml = format!(
        "materials: {{s: {{E: {e:?}, nu: {nu}}}}}\nbodies: {{B: s}}\nsupports:\n- {{face: S0, \
         fix: [z]}}\n- {{face: S1, fix: [z]}}\n- {{face: S2, fix: [z]}}\n- {{face: BOTTOM, fix: \
         [x, y]}}\n- {{face: TOP, fix: [x, y]}}\nloads:\n- {{body: B, force: [0, 0, {b:?}]}}\n"
    );
    let errors: Vec<[f64; 3]> = [1, 2, 4]
        .map(|k| {
            let mesh = Prism { n: 3 * k, layers: k }.mesh(|l, t| {
                let at = |d: usize| (0..3).map(|i| l[i] * corners[i][d]).sum::<f64>();
                [at(0), at(1), t * length]
            });
            let [lower, upper] = solve(&yaml, mesh).contains("triangle", exact);
            [
                (upper - lower) / exact.abs(),
                (exact - lower) / exact.abs(),
                (upper - exact) / exact.abs(),
            ]
        })
        .to_vec();
    for (what, i) in [("gap", 0), ("lower", 1), ("upper", 2)] {
        for pair in errors.windows(2) {
            let rate = (pair[0][i] / pair[1][i]).log2();
            println!("{what}: {:.4e} -> {:.4e}, rate {rate:.3}", pair[0][i], pair[1][i]);
            assert!((3.5..=4.6).contains(&rate), "{what}: rate {rate}");
        }
    }
}
