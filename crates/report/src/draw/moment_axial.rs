//! The M–N diagram of the component method: resistance of a joint to moment and axial force, with
//! the load cases.

use crate::draw::axes::Axes;
use crate::draw::svg::{Anchor, Drawing, LINE, Pen, Svg};
use bracket_base::words::Text;
use bracket_codes::MomentAxial;

/// The diagram. The axial force points to the right (tension positive), the moment
/// upwards (tension at the top positive).
pub fn drawing(diagram: &MomentAxial) -> Svg {
    let show = |p: [f64; 2]| [1e-3 * p[0], 1e-6 * p[1]];
    let border: Vec<[f64; 2]> = diagram.border.iter().copied().map(show).collect();
    let demands: Vec<(&str, [f64; 2])> =
        diagram.demands.iter().map(|d| (d.0.as_str(), show(d.1))).collect();
    let seen = border.iter().chain(demands.iter().map(|d| &d.1));
    let largest = seen.fold([0.0f64; 2], |r, c| [r[0].max(c[0].abs()), r[1].max(c[1].abs())]);
    let axes = Axes::new(largest);
    let mut d = Drawing::default();
    let points: Vec<[f64; 2]> = border.iter().map(|p| axes.at(*p)).collect();
    d.polygon(Pen::Edge, "#dbe7f3", &points);
    // the strip in which 6.2.7.1(2) neglects the axial force
    let [small, _] = show([diagram.small, 0.0]);
    for x in [-small, small] {
        d.line(Pen::Hidden, axes.at([x, -axes.reach()[1]]), axes.at([x, axes.reach()[1]]));
    }
    // a compressive force does not raise the moment resistance above M_j,Rd
    let [top_sense, bottom_sense] = diagram.resistance.map(|m| show([0.0, m])[1]);
    for y in [top_sense, -bottom_sense] {
        d.line(Pen::Hidden, axes.at([-axes.reach()[0], y]), axes.at([axes.reach()[0], y]));
    }
    let [legend, top] = axes.draw(&mut d, ["N [kN]", "M_j [kN m]"].map(Text::given));
    for (name, point) in &demands {
        d.name(axes.at(*point), name);
    }
    for (_, point) in &demands {
        d.circle(Pen::Edge, "#c03a00", axes.at(*point), 3.5);
    }
    let y = |line: f64| top + (2.0 + 1.5 * line) * LINE;
    d.rectangle(Pen::Edge, "#dbe7f3", [legend, y(0.0)], [legend + 22.0, y(0.0) + 12.0]);
    d.text(
        [legend + 30.0, y(0.0) + 6.0],
        Anchor::Start,
        "in plastic equilibrium of the components",
    );
    let dashed = [
        "horizontal: M_j,Rd, the limit also under compression",
        "vertical: 5 % of N_pl,Rd, inside which N is not added",
    ];
    for (i, text) in dashed.into_iter().enumerate() {
        let at = y(1.0 + i as f64) + 6.0;
        d.line(Pen::Hidden, [legend, at], [legend + 22.0, at]);
        d.text([legend + 30.0, at], Anchor::Start, text);
    }
    d.finish("Moment and axial force by the component method")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The border, every load case by name and the strip without axial force.
    #[test]
    fn the_diagram_shows_border_demands_and_the_strip() {
        let diagram = MomentAxial {
            beta: 1.0,
            border: vec![[4e5, 0.0], [0.0, 8e7], [-9e5, 0.0], [0.0, -6e7]],
            resistance: [8e7, 6e7],
            small: 6e4,
            demands: vec![("ULS1".into(), [1e5, 5e7]), ("ULS2".into(), [-2e5, 1e7])],
        };
        let svg = drawing(&diagram).file;
        assert_eq!((svg.matches("<polygon").count(), svg.matches("<circle").count()), (1, 2));
        for part in ["ULS1", "ULS2", "N [kN]", "M_j [kN m]", "5 %", ">−400<"] {
            assert!(svg.contains(part), "{part}: {svg}");
        }
    }
}
