//! The M–N diagram of the component method: resistance of a joint to moment and axial force, with
//! the load cases.

use crate::draw::axes::Axes;
use crate::draw::svg::{Anchor, Drawing, LINE, Pen, Svg};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::MomentAxial;
use bracket_codes::check::number;
use bracket_codes::end_plate::Point;

/// Load cases up to which each has its name in the diagram; of more only those that use most.
const NAMED: usize = 12;

/// Fill of the region of the first curve and of that within it.
const REGIONS: [&str; 2] = ["#dbe7f3", "#b7cfe6"];
/// Load cases that are carried, and that are not.
const CARRIED: &str = "#1d6b3a";
const BEYOND: &str = "#c03a00";

/// The diagram. The axial force points to the right (tension positive), the moment
/// upwards (tension at the top positive).
pub fn drawing(diagram: &MomentAxial) -> Svg {
    let show = |p: [f64; 2]| [1e-3 * p[0], 1e-6 * p[1]];
    let borders: Vec<Vec<[f64; 2]>> =
        diagram.curves.iter().map(|c| c.border.iter().copied().map(show).collect()).collect();
    let mut demands: Vec<&Point> = diagram.demands.iter().collect();
    demands.sort_by(|a, b| b.utilisation.total_cmp(&a.utilisation));
    let shown = demands.iter().map(|d| show(d.at));
    let seen = borders.iter().flatten().copied().chain(shown);
    let largest = seen.fold([0.0f64; 2], |r, c| [r[0].max(c[0].abs()), r[1].max(c[1].abs())]);
    let axes = Axes::new(largest);
    let mut d = Drawing::default();
    for (border, fill) in borders.iter().zip(REGIONS) {
        let points: Vec<[f64; 2]> = border.iter().map(|p| axes.at(*p)).collect();
        d.polygon(Pen::Edge, fill, &points);
    }
    // the strip in which 6.2.7.1(2) neglects the axial force
    for x in diagram.small.iter().flat_map(|n| [-1e-3 * n, 1e-3 * n]) {
        d.line(Pen::Hidden, axes.at([x, -axes.reach()[1]]), axes.at([x, axes.reach()[1]]));
    }
    // a compressive force does not raise the moment resistance above M_j,Rd
    for resistance in diagram.curves.iter().filter_map(|c| c.resistance) {
        let [top_sense, bottom_sense] = resistance.map(|m| show([0.0, m])[1]);
        for y in [top_sense, -bottom_sense] {
            d.line(Pen::Hidden, axes.at([-axes.reach()[0], y]), axes.at([axes.reach()[0], y]));
        }
    }
    let [legend, top] = axes.draw(&mut d, ["N [kN]", "M_j [kN m]"].map(Text::given));
    let many = demands.len() > NAMED;
    for point in demands.iter().take(NAMED) {
        d.name(axes.at(show(point.at)), &point.case);
    }
    // those that use most on top
    for point in demands.iter().rev() {
        let fill = if point.is_carried() { CARRIED } else { BEYOND };
        d.circle(Pen::Edge, fill, axes.at(show(point.at)), if many { 2.5 } else { 3.5 });
    }
    let mut y = top + 2.0 * LINE;
    for (curve, fill) in diagram.curves.iter().zip(REGIONS) {
        d.rectangle(Pen::Edge, fill, [legend, y], [legend + 22.0, y + 12.0]);
        let text = match (diagram.curves.len(), curve.resistance) {
            (_, None) => "forces of both sides within their resistances".into(),
            (1, _) => "in plastic equilibrium of the components".into(),
            _ => say!("in plastic equilibrium of the components, β = {}", number(curve.beta)),
        };
        d.text([legend + 30.0, y + 6.0], Anchor::Start, text);
        y += 1.5 * LINE;
    }
    let limited = diagram.curves.iter().any(|c| c.resistance.is_some());
    let dashed = [
        (limited, "horizontal: M_j,Rd, the limit also under compression"),
        (diagram.small.is_some(), "vertical: 5 % of N_pl,Rd, inside which N is not added"),
    ];
    for (_, text) in dashed.into_iter().filter(|(drawn, _)| *drawn) {
        d.line(Pen::Hidden, [legend, y + 6.0], [legend + 22.0, y + 6.0]);
        d.text([legend + 30.0, y + 6.0], Anchor::Start, text);
        y += 1.5 * LINE;
    }
    for (fill, carried) in [(CARRIED, true), (BEYOND, false)] {
        let count = demands.iter().filter(|p| p.is_carried() == carried).count();
        if count == 0 {
            continue;
        }
        let text = match carried {
            true => say!("{} load cases inside", count),
            false => say!("{} load cases beyond it", count),
        };
        d.circle(Pen::Edge, fill, [legend + 11.0, y + 6.0], 3.5);
        d.text([legend + 30.0, y + 6.0], Anchor::Start, text);
        y += 1.5 * LINE;
    }
    d.text([legend, y + 6.0], Anchor::Start, "welds and members have checks of their own");
    y += 1.5 * LINE;
    if many {
        let text = say!("names: the {} that use most", NAMED);
        d.text([legend + 30.0, y + 6.0], Anchor::Start, text);
    }
    d.finish("Moment and axial force by the component method")
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_codes::end_plate::Curve;

    fn point(case: String, at: [f64; 2], utilisation: f64) -> Point {
        Point { case, at, utilisation }
    }

    fn curve(beta: f64, scale: f64) -> Curve {
        let border = [[4e5, 0.0], [0.0, 8e7], [-9e5, 0.0], [0.0, -6e7]];
        let border = border.map(|p| p.map(|x| scale * x)).into();
        Curve { beta, border, resistance: Some([8e7, 6e7]) }
    }

    /// The border, every load case by name and the strip without axial force.
    #[test]
    fn the_diagram_shows_border_demands_and_the_strip() {
        let diagram = MomentAxial {
            curves: vec![curve(1.0, 1.0)],
            small: Some(6e4),
            demands: vec![
                point("ULS1".into(), [1e5, 5e7], 0.9),
                point("ULS2".into(), [-2e5, 1e7], 1.1),
            ],
        };
        let svg = drawing(&diagram).file;
        // two load cases and their two kinds in the legend
        assert_eq!((svg.matches("<polygon").count(), svg.matches("<circle").count()), (1, 4));
        for part in ["ULS1", "ULS2", "N [kN]", "M_j [kN m]", "5 %", ">−400<", "1 load cases beyond"]
        {
            assert!(svg.contains(part), "{part}: {svg}");
        }
    }

    /// Of many load cases every one is a point, and those that use most have their names.
    #[test]
    fn many_load_cases_are_a_cloud() {
        let at = |i: usize| [1e3 * i as f64, 1e6 * (i % 7) as f64];
        let demands = (0..50).map(|i| point(format!("LC{i}"), at(i), 0.021 * i as f64)).collect();
        let curves = vec![curve(0.5, 1.0), curve(1.5, 0.7)];
        let svg = drawing(&MomentAxial { curves, small: Some(6e4), demands }).file;
        assert_eq!((svg.matches("<polygon").count(), svg.matches("<circle").count()), (2, 52));
        assert!(svg.contains("LC49") && svg.contains("LC38") && !svg.contains("LC37"), "{svg}");
        for part in ["β = 0.5", "β = 1.5", "48 load cases inside", "2 load cases beyond", "the 12 "]
        {
            assert!(svg.contains(part), "{part}: {svg}");
        }
    }
}
