//! Rotation of the column at a joint by beam theory, as far as it is no rotation of the joint.
//!
//! ```text
//!    ┬ head           The beam brings its moment M into the column as a couple of forces M/z at
//!    │                its flanges, z apart. Along the column the moment is
//!    │                    m(s) = R s + Q − M f(s),
//!  ──┤ ← M/z          s from the head, R and Q the force and the moment of the head's support,
//!    │ panel          f rising from 0 to 1 over the panel. The shear force is R, in the panel
//!  ──┤ → M/z          R − M/z.
//!    │
//!    ┴ foot
//! ```
//!
//! R and Q make the strain energy least. The energy z (M/z)²/(2 G A_v) of the panel under M/z alone
//! is left out: it is that of the web panel in shear, a component of the joint (k1 of Table 6.11
//! with β = 1).

use super::at_plate;
use bracket_joint::assembly::EndPlate;
use bracket_joint::assembly::column_span::ColumnSpan;
use bracket_joint::catalog::IProfile;

/// Poisson's ratio of steel, EN 1993-1-1:2005 3.2.6.
const POISSON: f64 = 0.3;

/// Strips of half a web for its shear stress.
const STRIPS: u32 = 400;

/// A column between its supports, under the couple of the beam's flanges. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
struct ColumnBeam {
    span: ColumnSpan,
    /// Lever arm z of the couple.
    lever: f64,
    /// E I \[N mm²\].
    flexural: f64,
    /// G A_v of the section \[N\].
    shear: f64,
    /// G A_v of the panel, a doubler included \[N\].
    panel: f64,
}

/// Rotation of the column at the joint over the moment of the beam \[rad/(N mm)\], without the
/// shear strain of the web panel under M/z; `None` where the column is not known as a beam between
/// its supports. It is negative where supports are so near that the shear force of the column
/// relieves the panel by more than the column bends.
///
/// # Source
/// Beam theory with shear; the shear force of the column in the panel as in EN 1993-1-8:2005
/// 5.3(3).
pub(super) fn column_flexibility(e: &EndPlate) -> Option<f64> {
    let c = e.column.as_ref()?;
    let young = c.steel.e;
    let modulus = young / (2.0 * (1.0 + POISSON));
    let area = shear_area(&c.section);
    // a doubler lies on the flat of the web
    let flat = c.section.h - 2.0 * (c.section.tf + c.section.r);
    let column = ColumnBeam {
        span: c.span?,
        lever: at_plate::beam(e).lever(),
        // cm⁴ → mm⁴
        flexural: young * 1e4 * c.section.i_y,
        shear: modulus * area,
        panel: modulus * (area + c.doubler * flat),
    };
    column.flexibility()
}

/// Area A_v by which the shear force along the web bends a section: V²/(2 G A_v) is the energy per
/// length of the shear stress in web, root fillets and flanges \[mm²\].
///
/// # Source
/// Shear formula of beams: τ = V S/(I t) in the web, S the first moment beyond the cut; in the
/// flanges τ = V a y/I along their width, a their distance from the axis and y the distance from
/// their tips.
fn shear_area(p: &IProfile) -> f64 {
    let arm = 0.5 * (p.h - p.tf);
    let edge = 0.5 * p.h - p.tf;
    let outstand = 0.5 * (p.b - p.tw);
    // thickness of the web at a distance d from the flange
    let thickness = |d: f64| {
        let in_root = (p.r - d).max(0.0);
        p.tw + 2.0 * (p.r - (p.r * p.r - in_root * in_root).sqrt())
    };
    // by midpoints from the flange to the axis: moments of inertia and first moment
    let step = edge / f64::from(STRIPS);
    let (mut first, mut second, mut energy) = (p.b * p.tf * arm, 0.0, 0.0);
    for i in 0..STRIPS {
        let d = (f64::from(i) + 0.5) * step;
        let (t, z) = (thickness(d), edge - d);
        let strip = t * z * step;
        let at = first + 0.5 * strip;
        energy += at * at / t * step;
        first += strip;
        second += strip * z;
    }
    second += p.b * p.tf * (arm * arm + p.tf * p.tf / 12.0);
    // two outstands in each half
    let flange = 2.0 * p.tf * arm * arm * outstand.powi(3) / 3.0;
    let inertia = 2.0 * second;
    inertia * inertia / (2.0 * (energy + flange))
}

impl ColumnBeam {
    /// Twice the least strain energy over M², less 1/(G A z) of the panel. `None` where the
    /// supports do not hold the column, or where it ends within the panel.
    ///
    /// The energy over M² is ½ xᵀ K x + gᵀ x + ½ c with x = (R, Q)/M.
    fn flexibility(&self) -> Option<f64> {
        let Self { span, lever: z, flexural, shear, panel } = *self;
        let [head, foot] = [span.above, span.below];
        let (p, l) = (head.length - 0.5 * z, head.length + foot.length);
        let q = p + z;
        if p < 0.0 || q > l {
            return None;
        }
        let k_rr = l.powi(3) / (3.0 * flexural) + (l - z) / shear + z / panel;
        let (k_rq, k_qq) = (l * l / (2.0 * flexural), l / flexural);
        // ∫ s f, ∫ f and ∫ f²
        let g_r = -(0.5 * p * z + z * z / 3.0 + 0.5 * (l * l - q * q)) / flexural - 1.0 / panel;
        let g_q = -(0.5 * z + l - q) / flexural;
        let c = (z / 3.0 + l - q) / flexural;
        if !head.hold.sideways && !foot.hold.sideways {
            return None;
        }
        // an end that can move sideways leaves no horizontal force
        let force = head.hold.sideways && foot.hold.sideways;
        let energy = |r: f64, m: f64| {
            r * (k_rr * r + 2.0 * k_rq * m + 2.0 * g_r) + m * (k_qq * m + 2.0 * g_q) + c
        };
        let (r, m) = match (force, head.hold.rotation, foot.hold.rotation) {
            (false, false, true) => (0.0, 0.0),
            (false, true, true) => (0.0, -g_q / k_qq),
            // the foot carries no moment: R l + Q = M
            (false, true, false) => (0.0, 1.0),
            (false, false, false) => return None,
            (true, false, true) => (-g_r / k_rr, 0.0),
            (true, true, true) => {
                let det = k_rr * k_qq - k_rq * k_rq;
                ((k_rq * g_q - k_qq * g_r) / det, (k_rq * g_r - k_rr * g_q) / det)
            }
            (true, false, false) => (1.0 / l, 0.0),
            (true, true, false) => {
                // Q = M − R l
                let slope = k_rq - k_qq * l + g_r - l * g_q;
                let r = -slope / (k_rr - 2.0 * l * k_rq + l * l * k_qq);
                (r, 1.0 - r * l)
            }
        };
        Some(energy(r, m))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_joint::assembly::column_span::{ColumnArm, EndHold};
    use bracket_joint::catalog::Catalog;

    const CLAMPED: EndHold = EndHold { sideways: true, rotation: true };
    const PINNED: EndHold = EndHold { sideways: true, rotation: false };
    const FREE: EndHold = EndHold { sideways: false, rotation: false };
    const GUIDED: EndHold = EndHold { sideways: false, rotation: true };

    /// E I = 1e13 N mm²; without shear strain and with a short panel it is a bar under a couple at
    /// a point.
    fn column([a, b]: [f64; 2], [head, foot]: [EndHold; 2], z: f64, shear: f64) -> ColumnBeam {
        let span = ColumnSpan {
            above: ColumnArm { length: a, hold: head },
            below: ColumnArm { length: b, hold: foot },
        };
        ColumnBeam { span, lever: z, flexural: 1e13, shear, panel: shear }
    }

    /// Textbook rotations of a bar under a couple M at a point, a from the head and b from the
    /// foot, over M/(E I): simply supported (a³ + b³)/(3 l²); cantilever b; propped
    /// b − ¾ (l² − a²)²/l³; both ends clamped by the slope-deflection method below.
    #[test]
    fn a_couple_at_a_point_turns_a_bar_as_in_the_tables() {
        let (a, b) = (1200.0, 800.0);
        let l: f64 = a + b;
        let propped = b - 0.75 * (l * l - a * a).powi(2) / l.powi(3);
        // both parts turn with the node: 4 E I/a and 4 E I/b, less the sway of the node, u =
        // −θ (k_a − k_b)/(k_u), k = 6 E I/a², 12 E I/a³
        let (ka, kb) = (6.0 / (a * a), 6.0 / (b * b));
        let sway = 12.0 / a.powi(3) + 12.0 / b.powi(3);
        let clamped = 1.0 / (4.0 / a + 4.0 / b - (ka - kb).powi(2) / sway);
        for (holds, expected) in [
            ([PINNED, PINNED], (a.powi(3) + b.powi(3)) / (3.0 * l * l)),
            ([FREE, CLAMPED], b),
            ([CLAMPED, FREE], a),
            ([PINNED, CLAMPED], propped),
            ([CLAMPED, CLAMPED], clamped),
            ([GUIDED, CLAMPED], a * b / l),
            ([GUIDED, PINNED], a),
        ] {
            let found = column([a, b], holds, 1e-3, 1e30).flexibility().expect("held");
            assert!((found * 1e13 / expected - 1.0).abs() < 1e-5, "{holds:?} {found:e} {expected}");
            // upside down
            let [head, foot] = holds;
            let turned = column([b, a], [foot, head], 1e-3, 1e30).flexibility().expect("held");
            assert!((turned / found - 1.0).abs() < 1e-9, "{holds:?}");
        }
        for holds in [[FREE, FREE], [FREE, PINNED], [GUIDED, GUIDED], [PINNED, FREE]] {
            assert_eq!(column([a, b], holds, 1e-3, 1e30).flexibility(), None, "{holds:?}");
        }
        assert_eq!(column([100.0, b], [PINNED; 2], 300.0, 1e9).flexibility(), None);
    }

    /// Without flanges it is the rectangle, A_v = 5/6 A. For thin walls without fillets the energy
    /// has a closed form: with q = b t_f h/2 the first moment of a flange and S(z) = q + t_w
    /// (c² − z²)/2 over half of the web's depth c.
    #[test]
    fn the_shear_area_is_that_of_the_shear_formula() {
        let catalog = Catalog::builtin().expect("tables");
        let hea300 = catalog.profile("HEA300").expect("a profile");
        let bare = IProfile { b: 10.0, tw: 10.0, r: 0.0, ..hea300.clone() };
        let found = shear_area(&bare);
        assert!((found / (5.0 / 6.0 * 10.0 * bare.h) - 1.0).abs() < 0.02, "{found}");
        let p = IProfile { r: 0.0, ..hea300.clone() };
        let (c, a) = (0.5 * p.h - p.tf, 0.5 * (p.h - p.tf));
        let (q, k) = (p.b * p.tf * a, 0.5 * p.tw);
        // ∫ (q + k (c² − z²))² dz from 0 to c
        let square = q * q * c + 4.0 / 3.0 * q * k * c.powi(3) + 8.0 / 15.0 * k * k * c.powi(5);
        let tips = 2.0 * p.tf * a * a * (0.5 * (p.b - p.tw)).powi(3) / 3.0;
        let inertia = (p.b * p.h.powi(3) - (p.b - p.tw) * (2.0 * c).powi(3)) / 12.0;
        let closed = inertia * inertia / (2.0 * (square / p.tw + tips));
        let found = shear_area(&p);
        assert!((found / closed - 1.0).abs() < 1e-4, "{found} {closed}");
        // fillets add some per cent
        let whole = shear_area(hea300);
        assert!(whole > 1.02 * found && whole < 1.1 * found, "{whole} {found}");
    }

    /// Simply supported, R = M/l is known by statics, so that the energy can be written down:
    /// bending of both parts with m = R s, of the panel with m = R t − M t/z … from its middle, and
    /// shear with R outside and R − M/z inside, less M²/(2 G A z).
    #[test]
    fn the_panel_is_relieved_by_the_force_of_the_supports() {
        let (a, z, shear, flexural) = (900.0, 400.0, 3e8, 1e13);
        let l: f64 = 2.0 * a;
        let end = a - 0.5 * z;
        // moments at the panel's edges ± end/l, linear between
        let m = end / l;
        let bending = (2.0 * m * m * end / 3.0 + m * m * z / 3.0) / flexural;
        let inside = 1.0 / l - 1.0 / z;
        let strain = ((l - z) / (l * l) + z * inside * inside - 1.0 / z) / shear;
        let found = column([a, a], [PINNED; 2], z, shear).flexibility().expect("held");
        assert!((found / (bending + strain) - 1.0).abs() < 1e-9, "{found:e}");
        assert!(strain < 0.0);
    }
}
