//! The component method beside the bracket of a limit analysis.

use crate::assembly::{EndPlate, PlaneActions};
use crate::checks::check::{Unit, number as n};
use crate::checks::component_method::Assessment;
use crate::checks::component_method::assembly::SMALL_AXIAL;
use serde::{Deserialize, Serialize};

/// Resistances of a joint by the component method, for one sense of bending.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Method {
    /// M_j,Rd \[N mm\].
    pub moment: f64,
    /// N_j,Rd of the sense of the axial force \[N\].
    pub axial: f64,
    /// N_pl,Rd of the beam \[N\].
    pub plastic_axial: f64,
    /// β.
    pub beta: f64,
    /// Sense of bending in words.
    pub sense: &'static str,
}

impl Method {
    /// Whether an axial force is left out.
    pub(super) fn small(&self, axial: f64) -> bool {
        axial.abs() <= SMALL_AXIAL * self.plastic_axial
    }
}

/// What the component method says of a load case at one member end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// Load case.
    #[serde(skip)]
    pub case: String,
    /// Member end.
    pub end: String,
    /// Sense of bending: `tension at the top`.
    pub sense: String,
    /// β of 5.3(8); 0 in a splice.
    pub beta: f64,
    /// M_j,Ed at the bolt plane \[N mm\].
    pub demand: f64,
    /// M_j,Rd \[N mm\].
    pub resistance: f64,
    /// The load factor at which moment and axial force reach the resistance; absent where the loads never do.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub factor: Option<f64>,
    /// What limits the rows, from the tension side: a sentence.
    pub limited_by: String,
    /// Lever arm M_j,Rd/ΣF_tr,Rd \[mm\].
    pub lever: f64,
    /// M_c,Rd of the beam \[N mm\].
    pub beam: f64,
    /// Half of the width of a bolt's head across flats \[mm\].
    pub head: f64,
}

impl Comparison {
    pub(super) fn new(e: &EndPlate, a: &PlaneActions, method: &Method, assessment: &Assessment) -> Self {
        let upside_down = a.at(1.0)[1][1] < 0.0;
        let rows: Vec<String> = assessment
            .rows
            .iter()
            .map(|r| {
                let z = if upside_down { -r.z } else { r.z };
                let mode = r.mode.map_or(String::new(), |m| format!(", {}", m.name()));
                format!("z = {} mm {} ({}{mode})", n(z), Unit::Force.show(r.force), r.limited_by)
            })
            .collect();
        let total = assessment.tension();
        Self {
            case: a.case.clone(),
            end: a.end.clone(),
            sense: method.sense.into(),
            beta: method.beta,
            demand: a.at(1.0)[1][1],
            resistance: method.moment,
            factor: factor(a, method),
            limited_by: rows.join("; "),
            lever: if total > 0.0 { method.moment / total } else { 0.0 },
            beam: assessment.beam_moment.value,
            head: 0.5 * e.bolt.head_width,
        }
    }
}

/// The least load factor at which the utilisation by moment and axial force reaches 1; `None` where it never does.
fn factor(a: &PlaneActions, method: &Method) -> Option<f64> {
    let over = |factor: f64| method.share(a.at(factor)).value >= 1.0;
    if over(0.0) {
        return Some(0.0);
    }
    let (mut low, mut high) = (0.0, 1e-3);
    while !over(high) {
        (low, high) = (high, 2.0 * high);
        if high > 1e6 {
            return None;
        }
    }
    // to the last digit
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if over(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(high)
}
