//! Moment against rotation: the curve of the component method with the largest demand, the limits
//! of the classes, the bracket of the initial stiffness and the bracket of the resistance.

use crate::document::picture::PictureRef;
use crate::draw::axes::Axes;
use crate::draw::svg::{Anchor, Drawing, LINE, Pen};
use crate::result::case_result::CaseResult;
use crate::result::quantity::{Quantity, Upper};
use crate::result::result_file::ResultFile;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::check::number;
use bracket_codes::end_plate::stiffness_class_limits;
use bracket_codes::subject::Sense;
use bracket_codes::{Check, CheckId};
use bracket_joint::assembly::EndPlate;

/// Exponent of μ for bolted end plates, EN 1993-1-8 Table 6.8.
const PSI: f64 = 2.7;
/// Part of M_j,Rd up to which the joint is elastic, 6.3.1(6).
const ELASTIC: f64 = 2.0 / 3.0;
/// Points of the bent part of a curve.
const POINTS: usize = 24;
const METHOD: &str = "#8a5a00";
const STIFFNESS: &str = "#cfe3cf";
const RESISTANCE: &str = "#dbe7f3";

/// What a diagram shows of the frame around the joint. The default shows nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// Load case, with the member end where there are several, and M_j,Ed at the bolt plane
    /// \[kN m\], positive for tension at the top.
    moments: Vec<(String, f64)>,
    /// Limits of the classes by stiffness, where the length of the beam is given: their factor of
    /// E I_b/L_b, and the stiffness \[kN m/mrad\].
    limits: Vec<(f64, f64)>,
}

impl Frame {
    /// The moments of the ultimate load cases and the limits of the classes.
    pub fn of(e: &EndPlate) -> Self {
        let ultimate = e.actions.iter().filter(|a| a.state.is_ultimate());
        let moments = ultimate.map(|a| (e.case_name(a), 1e-6 * a.at(1.0)[1][1]));
        let limits = stiffness_class_limits(e).into_iter().map(|(k, s)| (k, 1e-9 * s));
        Self { moments: moments.collect(), limits: limits.collect() }
    }

    /// The largest demand in the sense of a curve; `None`: in both.
    fn largest(&self, sense: Option<Sense>) -> Option<(&str, f64)> {
        let counts = |m: f64| match sense {
            Some(Sense::Top) => m > 0.0,
            Some(Sense::Bottom) => m < 0.0,
            None => m != 0.0,
        };
        let mine = self.moments.iter().filter(|(_, m)| counts(*m));
        let sizes = mine.map(|(name, m)| (name.as_str(), m.abs()));
        sizes.reduce(|a, b| if b.1 > a.1 { b } else { a })
    }
}

/// What stands before a line of the legend.
enum Key {
    Line(Pen),
    Area(&'static str),
}

/// The curve for one sense of bending, or for both where they are equal.
struct Curve {
    /// `None`: both.
    sense: Option<Sense>,
    /// M_j,Rd \[kN m\].
    resistance: f64,
    /// S_j,ini \[kN m/mrad\].
    stiffness: f64,
}

impl Curve {
    fn words(&self) -> &'static str {
        self.sense.map_or("both senses of bending", Sense::words)
    }

    /// Rotation \[mrad\] under a moment \[kN m\] up to M_j,Rd.
    ///
    /// # Source
    /// EN 1993-1-8:2005 6.3.1(6): S_j = S_j,ini/μ, μ = (1.5 M_j,Ed/M_j,Rd)^ψ from 2/3 M_j,Rd on.
    fn rotation(&self, moment: f64) -> f64 {
        let mu = (moment / (ELASTIC * self.resistance)).max(1.0).powf(PSI);
        moment * mu / self.stiffness
    }

    fn points(&self) -> Vec<[f64; 2]> {
        let at = |share: f64| share * self.resistance;
        let bent = (0..=POINTS).map(|i| ELASTIC + (1.0 - ELASTIC) * i as f64 / POINTS as f64);
        let point = |m: f64| [self.rotation(m), m];
        std::iter::once([0.0; 2]).chain(bent.map(|s| point(at(s)))).collect()
    }
}

/// The curves of both senses; one for both where they are equal.
fn curves(checks: &[Check]) -> Vec<Curve> {
    let value = |id: CheckId, sense: Sense| {
        Check::find(checks, id, &sense.into())?.resistance.filter(|v| *v > 0.0)
    };
    let mut out: Vec<Curve> = Vec::new();
    for sense in [Sense::Top, Sense::Bottom] {
        let (Some(m), Some(s)) =
            (value(CheckId::MomentResistance, sense), value(CheckId::InitialStiffness, sense))
        else {
            continue;
        };
        let curve = Curve { sense: Some(sense), resistance: 1e-6 * m, stiffness: 1e-9 * s };
        let same = |c: &&mut Curve| {
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a;
            near(c.resistance, curve.resistance) && near(c.stiffness, curve.stiffness)
        };
        match out.iter_mut().find(same) {
            Some(c) => c.sense = None,
            None => out.push(curve),
        }
    }
    out
}

/// The moment of the demand \[kN m\] with the bracket of a limit analysis times it.
fn resistance(case: &CaseResult) -> Option<[f64; 2]> {
    let method = case.demand.as_ref()?.component_method.first()?;
    let (Quantity::LoadFactor, Some(low), Some(Upper::Finite(up))) =
        (case.quantity, case.lower, case.upper)
    else {
        return None;
    };
    let moment = 1e-6 * method.demand.abs();
    (case.is_strict() && moment > 0.0).then_some([low * moment, up * moment])
}

/// The drawing of a result with the text of its file; `None` where the component method gives no
/// curve.
pub fn drawing(result: &ResultFile, frame: &Frame) -> Option<(PictureRef, String)> {
    let curves = curves(&result.checks);
    if curves.is_empty() {
        return None;
    }
    let stiffness = result.cases.iter().find_map(|c| Some((c, c.joint_stiffness.as_ref()?)));
    // a bracket of an analysis of its own is narrower
    let mut analysed = result.cases.iter().filter(|c| c.proved_by.is_none());
    let bracket = analysed.find_map(|c| Some((c, resistance(c)?)));
    let ends = curves.iter().map(|c| [1.35 * c.rotation(c.resistance), c.resistance]);
    let mut largest = ends.fold([0.0f64; 2], |r, c| [r[0].max(c[0]), r[1].max(c[1])]);
    let demands = curves.iter().filter_map(|c| Some((c, frame.largest(c.sense)?)));
    let demands: Vec<(&Curve, (&str, f64))> = demands.collect();
    let moments = demands.iter().map(|(_, (_, m))| *m).chain(bracket.map(|(_, [_, up])| up));
    largest[1] = moments.fold(largest[1], f64::max);
    let axes = Axes::quadrant(largest);
    let mut d = Drawing::default();
    let mut legend: Vec<(Text, Key)> = Vec::new();
    if let Some((case, [low, up])) = bracket {
        let [a, b] = [[0.0, low], [axes.reach()[0], up]].map(|p| axes.at(p));
        d.rectangle(Pen::None, RESISTANCE, a, b);
        legend.push((
            say!("{}: bracket of the resistance, times M_j,Ed", &case.name),
            Key::Area(RESISTANCE),
        ));
    }
    if let Some((case, s)) = stiffness {
        // up to the moment at which the elastic part of the curve ends
        let top = curves.iter().map(|c| ELASTIC * c.resistance).fold(0.0, f64::max);
        let at = |s: f64| axes.at([(top / (1e-9 * s)).min(axes.reach()[0]), top]);
        let stiff = s.upper.map_or(axes.at([0.0, top]), at);
        d.polygon(Pen::None, STIFFNESS, &[axes.at([0.0; 2]), stiff, at(s.lower)]);
        legend
            .push((say!("{}: bracket of the initial stiffness", &case.name), Key::Area(STIFFNESS)));
    }
    let pens = [Pen::Edge, Pen::Hidden];
    for (curve, pen) in curves.iter().zip(pens) {
        let mut points: Vec<[f64; 2]> = curve.points().into_iter().map(|p| axes.at(p)).collect();
        points.push(axes.at([axes.reach()[0], curve.resistance]));
        points.windows(2).for_each(|w| d.line(pen, w[0], w[1]));
        legend.push((say!("component method, {}", curve.words()), Key::Line(pen)));
        let [x, y] = axes.at([curve.rotation(curve.resistance), curve.resistance]);
        d.circle(Pen::Edge, METHOD, [x, y], 3.0);
    }
    for (curve, (name, moment)) in demands {
        // beyond M_j,Rd there is no rotation to read
        let rotation = (moment <= curve.resistance).then(|| curve.rotation(moment));
        let end = axes.at([rotation.unwrap_or(axes.reach()[0]), moment]);
        d.line(Pen::Action, axes.at([0.0, moment]), end);
        if let Some(rotation) = rotation {
            d.line(Pen::Action, end, axes.at([rotation, 0.0]));
        }
        let text = say!("M_j,Ed of {}: {} kN m", name.to_owned(), number(moment));
        legend.push((text, Key::Line(Pen::Action)));
    }
    for (factor, slope) in &frame.limits {
        let reach = axes.reach();
        let end = [(reach[1] / slope).min(reach[0]), (reach[0] * slope).min(reach[1])];
        d.line(Pen::Thin, axes.at([0.0; 2]), axes.at(end));
        // beside the line, within the frame
        let [x, y] = axes.at(end);
        let steep = end[1] >= reach[1];
        let (place, anchor) = match steep {
            true => ([x + 4.0, y + 10.0], Anchor::Start),
            false => ([x - 4.0, y - 8.0], Anchor::End),
        };
        d.text(place, anchor, Text::given(number(*factor)));
    }
    if !frame.limits.is_empty() {
        legend.push(("limits of the classes, times E I_b/L_b".into(), Key::Line(Pen::Thin)));
    }
    let [left, top] = axes.draw(&mut d, ["rotation φ [mrad]".into(), Text::given("M_j [kN m]")]);
    for (i, (text, key)) in legend.into_iter().enumerate() {
        let y = top + (2.0 + 1.5 * i as f64) * LINE;
        match key {
            Key::Line(pen) => d.line(pen, [left, y + 6.0], [left + 22.0, y + 6.0]),
            Key::Area(colour) => {
                d.rectangle(Pen::Edge, colour, [left, y], [left + 22.0, y + 12.0]);
            }
        }
        d.text([left + 30.0, y + 6.0], Anchor::Start, text);
    }
    let caption = "Moment and rotation of the joint (EN 1993-1-8 6.3.1); the circle is M_j,Rd, the \
                   rotation beyond it is limited by the rotation capacity";
    Some(d.finish("Moment and rotation of the joint").picture("moment_rotation.svg", caption))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The curve is straight up to two thirds of the resistance; there S_j = S_j,ini, and at the
    /// resistance the rotation is 1.5^2.7 ≈ 2.99 times the elastic one (Table 6.8).
    #[test]
    fn the_curve_bends_from_two_thirds_of_the_resistance() {
        let curve = Curve { sense: None, resistance: 90.0, stiffness: 20.0 };
        assert_eq!(curve.rotation(30.0), 1.5);
        assert_eq!(curve.rotation(60.0), 3.0);
        let ratio = curve.rotation(90.0) / 4.5;
        assert!((ratio - 2.9885).abs() < 1e-3, "{ratio}");
        let points = curve.points();
        assert_eq!((points[0], points[1]), ([0.0, 0.0], [3.0, 60.0]));
        assert!(points.windows(2).all(|w| w[0][0] < w[1][0] && w[0][1] < w[1][1]));
    }

    /// The largest moment of each sense is the demand on its curve.
    #[test]
    fn the_largest_demand_of_a_sense_is_drawn() {
        let moments = [("A", 30.0), ("B", -50.0), ("C", 40.0)];
        let frame =
            Frame { moments: moments.map(|(n, m)| (n.to_owned(), m)).into(), limits: Vec::new() };
        assert_eq!(frame.largest(Some(Sense::Top)), Some(("C", 40.0)));
        assert_eq!(frame.largest(Some(Sense::Bottom)), Some(("B", 50.0)));
        assert_eq!(frame.largest(None), Some(("B", 50.0)));
        assert_eq!(Frame::default().largest(None), None);
    }
}
