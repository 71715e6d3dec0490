//! Compares the component method with the bracket of a load case.

use crate::document::Doc;
use crate::figures::{Rounding, significant};
use crate::result::result_file::CaseResult;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::Comparison;
use bracket_codes::check::Unit;

/// Factor on the bending strength of a plate that cannot contract along its yield line (plane
/// strain, von Mises): 2/√3.
const PLANE_STRAIN: f64 = 1.154_700_538_379_251_5;

/// One line for each member end. If the component method lies outside the bracket, the line gives
/// the reasons.
pub(crate) fn lines(doc: &mut Doc, case: &CaseResult) {
    let Some(demand) = &case.demand else { return };
    for c in &demand.component_method {
        doc.paragraph(line(&case.name, c, case.factor_bounds()));
    }
    if let Some(why) = &demand.brittle {
        doc.paragraph(say!("The lower bound alone decides nothing: {}.", why));
    }
}

fn line(case: &str, c: &Comparison, bounds: (Option<f64>, Option<f64>)) -> Text {
    let beta = match c.beta {
        0.0 => String::new(),
        beta => format!(", β = {}", significant(beta, 3, Rounding::Nearest)),
    };
    let gives = say!(
        "{}, {}: the component method gives M_j,Rd = {} for {}{}; the demand of the load case is \
         {}.",
        case.to_owned(),
        &c.end,
        Unit::Moment.show(c.resistance),
        &c.sense,
        beta,
        Unit::Moment.show(c.demand.abs())
    );
    let Some(method) = c.factor.filter(|f| *f > 0.0) else { return gives };
    let low = |b: f64| format!("FE_low/CM = {}", significant(b / method, 3, Rounding::Down));
    let up = |b: f64| format!("FE_up/CM = {}", significant(b / method, 3, Rounding::Up));
    let ratios = match bounds {
        (Some(l), Some(u)) => {
            say!("{}, {}: it lies {}", low(l), up(u), place(method, l, u, c))
        }
        (Some(l), None) => say!("{}.", low(l)),
        (None, Some(u)) => say!("{}.", up(u)),
        (None, None) => Text::default(),
    };
    let factor = significant(method, 3, Rounding::Nearest);
    match ratios.is_empty() {
        true => say!("{} Its load factor is {}.", gives, factor),
        false => say!("{} Its load factor is {}; {}", gives, factor, ratios),
    }
}

/// Position of the component method relative to the bracket, with the numbers that explain it.
fn place(method: f64, low: f64, up: f64, c: &Comparison) -> Text {
    let percent = |part: f64| significant(100.0 * part, 2, Rounding::Nearest);
    let lever = significant(c.lever, 3, Rounding::Nearest);
    let rows = say!("its rows: {}; lever arm {} mm", &c.limited_by, lever);
    let beam = Unit::Moment.show(c.beam);
    if method < low && !c.stability.is_empty() {
        return say!(
            "{} % below the lower bound. Limit analysis does not cover buckling, so the component \
             method decides: {}; {}; the beam alone carries {}.",
            percent(1.0 - method / low),
            Text::joined("; ", c.stability.iter().cloned()),
            rows,
            beam
        );
    }
    if method < low {
        return say!(
            "{} % below the lower bound. The model carries more for two reasons. Plates and \
             flanges bend at f_y in the component method; in the model a plate that cannot \
             contract along a hinge carries up to 2/√3 = {} times that. The component method \
             measures to the bolt axis; in the model the bolt head, {} mm to either side of it, \
             holds the plate nearer to the web. Component method: {}; the beam alone carries {}.",
            percent(1.0 - method / low),
            significant(PLANE_STRAIN, 4, Rounding::Nearest),
            significant(c.head, 3, Rounding::Nearest),
            rows,
            beam
        );
    }
    if method > up {
        return say!(
            "{} % above the upper bound, because the mechanism of the model collapses at a lower \
             load than the sum of the components: {}; the beam alone carries {}; M_j,Rd takes no \
             account of the shear force, and of the column only its web and flange at the joint.",
            percent(method / up - 1.0),
            rows,
            beam
        );
    }
    say!("inside the bracket ({}).", rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::english;
    use crate::result::demand::Demand;
    use crate::result::fixtures::case;
    use crate::result::result_file::FrictionModel;
    use crate::result::result_file::Quantity;
    use crate::result::result_file::Upper;
    use bracket_codes::HandChecks;

    fn comparison(factor: f64) -> Comparison {
        Comparison {
            case: "ULS1".into(),
            end: "beam_right".into(),
            sense: "tension at the top".into(),
            beta: 1.0,
            demand: 50e6,
            resistance: 50e6 * factor,
            factor: Some(factor),
            limited_by: "z = 190 mm 180 kN (end plate, mode 2)".into(),
            stability: Vec::new(),
            lever: 300.0,
            beam: 148e6,
            head: 15.0,
        }
    }

    /// The line gives the two ratios, rounded outwards, and the side on which the component method
    /// lies.
    #[test]
    fn the_line_says_on_which_side_and_by_how_much() {
        let line = |factor| line("ULS1", &comparison(factor), (Some(1.2), Some(1.5))).to_string();
        let inside = line(1.3);
        assert!(
            inside.contains("FE_low/CM = 0.923, FE_up/CM = 1.16: it lies inside the bracket"),
            "{inside}"
        );
        let below = line(1.0);
        assert!(
            below.contains("17 % below the lower bound") && below.contains("2/√3 = 1.155"),
            "{below}"
        );
        // if buckling is possible, a component method below the bracket must not be called safe
        let mut unstable = comparison(1.0);
        unstable.stability =
            vec!["the column web buckles: ρ = 0.645 (EN 1993-1-8:2005 6.2.6.2)".into()];
        let decided = super::line("ULS1", &unstable, (Some(1.2), Some(1.5))).to_string();
        assert!(
            decided.contains("does not cover buckling") && decided.contains("ρ = 0.645"),
            "{decided}"
        );
        assert!(
            !decided.contains("2/√3") && !decided.contains("safe") && !below.contains("safe"),
            "{decided}"
        );
        let above = line(1.8);
        assert!(above.contains("20 % above the upper bound") && above.contains("148"), "{above}");
        let one = super::line("ULS1", &comparison(1.0), (Some(1.2), None)).to_string();
        assert!(one.ends_with("FE_low/CM = 1.2.") || one.ends_with("FE_low/CM = 1.20."), "{one}");
    }
    /// The bounds of an elastic case are energies: nothing is compared with them.
    #[test]
    fn energies_are_not_compared_with_the_component_method() {
        let text = |quantity| {
            let mut case = CaseResult {
                quantity,
                problem: FrictionModel::Frictionless,
                lower: Some(-2.1e5),
                upper: Some(Upper::Finite(-2.0e5)),
                ..case()
            };
            let mut demand = Demand::new(&case, Vec::new(), &HandChecks::default());
            demand.component_method = vec![comparison(1.3)];
            case.demand = Some(demand);
            english(|doc| lines(doc, &case))
        };
        let elastic = text(Quantity::PotentialEnergy);
        assert!(
            elastic.contains("Its load factor is 1.30.") && !elastic.contains("FE_"),
            "{elastic}"
        );
        assert!(text(Quantity::LoadFactor).contains("FE_low/CM"));
    }
}
