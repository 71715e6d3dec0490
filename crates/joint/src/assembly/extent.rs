//! Boxes along the axes of the joint: what they have in common and what is left of them.

/// Extent along x, y and z \[mm\].
pub type Extent = [[f64; 2]; 3];

/// Largest difference of two coordinates at the same place \[mm\].
pub const SAME_PLACE: f64 = 0.01;

/// The least extent that holds both.
pub fn union(a: Extent, b: Extent) -> Extent {
    std::array::from_fn(|k| [a[k][0].min(b[k][0]), a[k][1].max(b[k][1])])
}

/// What both have in common along each axis; negative where they are apart.
fn common(a: &Extent, b: &Extent) -> [f64; 3] {
    std::array::from_fn(|k| a[k][1].min(b[k][1]) - a[k][0].max(b[k][0]))
}

/// Sides of the rectangle in which two boxes touch, the shorter first; `None` where they do not
/// touch in a face.
pub fn touching(a: &Extent, b: &Extent) -> Option<[f64; 2]> {
    let mut sides = common(a, b);
    sides.sort_by(f64::total_cmp);
    (sides[0] > -SAME_PLACE && sides[1] > SAME_PLACE).then_some([sides[1], sides[2]])
}

/// The parts of a box on both sides of a block that cuts it right through; otherwise the box.
pub fn cut(of: Extent, block: &Extent) -> Vec<Extent> {
    let covers =
        |k: usize| block[k][0] <= of[k][0] + SAME_PLACE && block[k][1] >= of[k][1] - SAME_PLACE;
    let inside =
        |k: usize| block[k][0] > of[k][0] + SAME_PLACE && block[k][1] < of[k][1] - SAME_PLACE;
    match (0..3).find(|&k| inside(k) && (0..3).all(|l| l == k || covers(l))) {
        None => vec![of],
        Some(k) => {
            let (mut low, mut high) = (of, of);
            (low[k][1], high[k][0]) = (block[k][0], block[k][1]);
            vec![low, high]
        }
    }
}

/// What is left of a box without another one, in boxes that do not overlap.
pub fn minus(of: Extent, cut: &Extent) -> Vec<Extent> {
    let apart =
        (0..3).any(|k| cut[k][0] > of[k][1] - SAME_PLACE || cut[k][1] < of[k][0] + SAME_PLACE);
    if apart {
        return vec![of];
    }
    let (mut out, mut rest) = (Vec::new(), of);
    for k in 0..3 {
        if cut[k][0] > rest[k][0] + SAME_PLACE {
            let mut low = rest;
            (low[k][1], rest[k][0]) = (cut[k][0], cut[k][0]);
            out.push(low);
        }
        if cut[k][1] < rest[k][1] - SAME_PLACE {
            let mut high = rest;
            (high[k][0], rest[k][1]) = (cut[k][1], cut[k][1]);
            out.push(high);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_web_cuts_a_stiffener_in_two_and_a_plate_beside_it_stays_whole() {
        let stiffener = [[-85.0, 85.0], [-100.0, 100.0], [140.0, 150.0]];
        let web = [[-85.0, 85.0], [-4.5, 4.5], [-500.0, 500.0]];
        let halves = cut(stiffener, &web);
        assert_eq!(halves.iter().map(|h| h[1]).collect::<Vec<_>>(), [[-100.0, -4.5], [4.5, 100.0]]);
        let doubler = [[-67.0, 67.0], [4.5, 12.5], [-165.0, 230.0]];
        assert_eq!(cut(doubler, &web), [doubler]);
    }

    /// A notch at the end of a beam: the flange is shorter, the web is left in two boxes.
    #[test]
    fn a_box_without_another_one() {
        let notch = [[-5.0, 60.0], [-200.0, 200.0], [110.0, 900.0]];
        let flange = [[0.0, 400.0], [-75.0, 75.0], [139.3, 150.0]];
        assert_eq!(minus(flange, &notch), [[[60.0, 400.0], [-75.0, 75.0], [139.3, 150.0]]]);
        let web = [[0.0, 400.0], [-3.5, 3.5], [-139.3, 139.3]];
        let left = [
            [[60.0, 400.0], [-3.5, 3.5], [-139.3, 139.3]],
            [[0.0, 60.0], [-3.5, 3.5], [-139.3, 110.0]],
        ];
        assert_eq!(minus(web, &notch), left);
        let volume = |e: &Extent| e.iter().map(|i| i[1] - i[0]).product::<f64>();
        let hole = [[10.0, 20.0], [-1.0, 1.0], [0.0, 30.0]];
        let around: f64 = minus(web, &hole).iter().map(volume).sum();
        assert!((around - volume(&web) + volume(&hole)).abs() < 1e-6, "{around}");
        assert_eq!(minus(web, &[[400.0, 500.0], [-9.0, 9.0], [0.0, 9.0]]), [web], "beside it");
    }

    #[test]
    fn boxes_touch_in_faces_and_not_in_edges() {
        let a = [[0.0, 10.0], [0.0, 20.0], [0.0, 30.0]];
        let beside = |x: f64, y: f64| [[x, x + 10.0], [y, y + 5.0], [0.0, 30.0]];
        assert_eq!(touching(&a, &beside(10.0, 0.0)), Some([5.0, 30.0]));
        assert_eq!(touching(&a, &beside(10.0, 20.0)), None, "an edge");
        assert_eq!(touching(&a, &beside(11.0, 0.0)), None, "apart");
    }
}
