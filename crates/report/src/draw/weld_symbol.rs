//! Weld symbols of ISO 2553: an arrow to the joint, a reference line, the symbol on it.

use crate::draw::svg::{Anchor, Drawing, Pen};
use bracket_base::words::Text;
use bracket_codes::check::number as n;

/// Side of a symbol \[pixels\].
const SIDE: f64 = 9.0;
/// Length of the reference line \[pixels\].
const LINE: f64 = 50.0;

/// The sides of a part with a weld.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Sides {
    /// Both.
    Both,
    /// The side of the arrow: below the line.
    Arrow,
}

impl Sides {
    /// The sides of the reference line, −1 above it.
    fn of_line(self) -> &'static [f64] {
        match self {
            Sides::Both => &[-1.0, 1.0],
            Sides::Arrow => &[1.0],
        }
    }
}

/// A weld of a part at `joint`, from a reference line that begins at `elbow` and runs to the right:
/// fillets of a throat \[mm\], or full penetration where it is 0.
pub(super) fn weld_symbol(
    d: &mut Drawing,
    joint: [f64; 2],
    elbow: [f64; 2],
    throat: f64,
    sides: Sides,
) {
    let [x, y] = elbow;
    d.leader(elbow, joint);
    d.line(Pen::Thin, elbow, [x + LINE, y]);
    let at = x + 0.68 * LINE;
    if throat > 0.0 {
        // a right-angled triangle on each side of the line, its size before it
        for side in sides.of_line() {
            let triangle = [[at, y], [at, y + side * SIDE], [at + SIDE, y]];
            d.polygon(Pen::Thin, "none", &triangle);
        }
        let size = Text::given(format!("a{}", n(throat)));
        d.text([at - 4.0, y - 8.0], Anchor::End, size);
    } else {
        // a double bevel: an upright stroke and one at 45° on each side
        let top = if sides == Sides::Both { y - SIDE } else { y };
        d.line(Pen::Thin, [at, top], [at, y + SIDE]);
        for side in sides.of_line() {
            d.line(Pen::Thin, [at, y], [at + SIDE, y + side * SIDE]);
        }
    }
}
