//! The component method of a sense of bending with all numbers from which M_j,Rd follows, so that
//! a reader can compute it again.

use crate::check::{CheckId, Step};
use crate::component_method::assembly::{Limit, RowForce};
use crate::component_method::joint::EndPlateJoint;
use crate::component_method::rows::Component;
use crate::component_method::stiffness::RowStiffness;
use crate::component_method::t_stub::{Mode, Prying};
use crate::component_method::{Assessment, Summed};
use crate::subject::Sense;
use crate::worked::Worked;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// The component method of one sense of bending. Lengths in mm, forces in N, strengths in MPa,
/// moments in N mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MethodRecord {
    /// Sense of bending, with β where there are several.
    pub subject: Text,
    /// True where a load case bends the joint in this sense.
    pub bends: bool,
    /// β of 5.3(8); 0 in a splice.
    pub beta: f64,
    /// F_t,Rd of one bolt, punching included.
    pub bolt: f64,
    /// γ_M0.
    pub gamma_m0: f64,
    /// Rows in tension, from the outermost.
    pub rows: Vec<RowRecord>,
    /// T-stubs of single rows and of groups.
    pub stubs: Vec<StubRecord>,
    /// Components that limit the sum of the rows.
    pub limits: Vec<LimitRecord>,
    /// M_j,Rd.
    pub moment: f64,
    /// Its formula with numbers.
    pub formula: Text,
    /// k1, k2, k_eq, z_eq, as far as they count.
    pub stiffness: Vec<Step>,
    /// S_j,ini with its numbers.
    pub initial_stiffness: Text,
}

/// A row in tension.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RowRecord {
    /// Number, from the outermost in tension.
    pub row: usize,
    /// z from the beam's axis, up positive.
    pub z: f64,
    /// h_r, distance from the centre of compression.
    pub lever: f64,
    /// Least of the components of the row alone.
    pub alone: f64,
    /// After the groups and 6.2.7.2(9).
    pub grouped: f64,
    /// F_tr,Rd.
    pub force: f64,
    /// The component that limits it.
    pub limited_by: Text,
    /// k3, k4, k5, k10 and k_eff,r \[mm\]; k3 and k4 only with a column.
    pub stiffness: Vec<Step>,
}

/// A T-stub of one row or of a group, with the web behind it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StubRecord {
    /// `column flange` or `end plate`.
    pub part: Text,
    /// First and last row.
    pub rows: [usize; 2],
    /// Thickness of the part.
    pub thickness: f64,
    /// f_y of the part.
    pub fy: f64,
    /// m; m_x of a row outside the flange.
    pub m: f64,
    /// e; e_x of a row outside the flange.
    pub e: f64,
    /// n = min(e_min, 1.25 m).
    pub n: f64,
    /// m2 to each stiffener or flange of the beam beside the row.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub m2: Vec<f64>,
    /// α of figure 6.11 for each of them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub alpha: Vec<f64>,
    /// Σ ℓ_eff,cp.
    pub circular: f64,
    /// Σ ℓ_eff,nc.
    pub straight: f64,
    /// e_w of the alternative method for mode 1; absent for the first method.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub washer_quarter: Option<f64>,
    /// False where the bolts are so long that no prying forces develop.
    pub prying: bool,
    /// Resistances of the modes: `mode 1`, `mode 2`, `mode 3`, or `mode 1-2` and `mode 3`.
    pub modes: Vec<(Mode, f64)>,
    /// The mode that decides.
    pub mode: Mode,
    /// F_T,Rd.
    pub resistance: f64,
    /// The web of column or beam in tension behind it; absent beside a row outside the flange.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub web: Option<WebRecord>,
}

/// A web in tension.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WebRecord {
    /// `column web` or `beam web`.
    pub part: Text,
    /// b_eff.
    pub width: f64,
    /// Thickness, supplementary plates included.
    pub thickness: f64,
    /// f_y.
    pub fy: f64,
    /// ω of Table 6.3; 1 for the beam.
    pub omega: f64,
    /// F_t,w,Rd.
    pub resistance: f64,
}

/// A component that limits the sum of the rows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LimitRecord {
    /// The component.
    pub part: Text,
    /// Clause.
    pub clause: Text,
    /// The formula with its numbers.
    pub formula: Text,
    /// Further numbers of the formula.
    pub values: Vec<Step>,
    /// Resistance; of the web panel over β.
    pub resistance: f64,
}

impl MethodRecord {
    /// The record of an assessment of `joint`, which is turned by `sense`.
    pub(super) fn new(
        subject: Text,
        bends: bool,
        sense: Sense,
        joint: &EndPlateJoint,
        a: &Assessment,
    ) -> Self {
        let rows = a.rows.iter().zip(&a.stiffness.rows).enumerate();
        let mut stubs = Vec::new();
        for (r, row) in a.rows.iter().enumerate() {
            stubs.extend(StubRecord::all([r, r], row.alone.iter()));
            for first in (0..r).rev() {
                let group = row.groups.iter().filter(|g| g.first == first);
                stubs.extend(StubRecord::all([first, r], group.map(|g| &g.component)));
            }
        }
        Self {
            subject,
            bends,
            beta: joint.beta,
            bolt: joint.bolts.tension,
            gamma_m0: joint.gamma_m0,
            rows: rows.map(|(r, (row, k))| RowRecord::new(r, sense, row, k)).collect(),
            stubs,
            limits: a.limits.iter().map(LimitRecord::new).collect(),
            moment: a.moment.value,
            formula: a.moment.formula(),
            stiffness: a.stiffness.initial.steps.clone(),
            initial_stiffness: a.stiffness.initial.formula(),
        }
    }
}

impl RowRecord {
    fn new(r: usize, sense: Sense, row: &RowForce, k: &RowStiffness) -> Self {
        let all = [
            ("k3", k.web),
            ("k4", k.flange),
            ("k5", Some(k.plate)),
            ("k10", Some(k.bolts)),
            ("k_eff", Some(k.effective)),
        ];
        let step = |(symbol, k): (&'static str, Option<f64>)| Some(Step::length(symbol, k?));
        Self {
            row: r + 1,
            z: sense.z(row.z),
            lever: row.lever,
            alone: row.single,
            grouped: row.grouped,
            force: row.force,
            limited_by: row.limited_by.text(),
            stiffness: all.into_iter().filter_map(step).collect(),
        }
    }
}

impl StubRecord {
    /// The T-stubs among the components of rows, each with the web that follows it.
    fn all<'a>([first, last]: [usize; 2], of: impl Iterator<Item = &'a Component>) -> Vec<Self> {
        let mut out: Vec<Self> = Vec::new();
        for c in of {
            let (Some(stub), Some(mode)) = (&c.stub, c.mode) else {
                if let Some(last) = out.last_mut() {
                    last.web = WebRecord::of(c);
                }
                continue;
            };
            out.push(Self {
                part: c.kind.words().into(),
                rows: [first + 1, last + 1],
                thickness: stub.of.thickness,
                fy: stub.of.fy,
                m: stub.of.m,
                e: stub.e,
                n: stub.of.n,
                m2: stub.beside.iter().map(|b| b.0).collect(),
                alpha: stub.beside.iter().map(|b| b.1).collect(),
                circular: stub.lengths.circular,
                straight: stub.lengths.straight,
                washer_quarter: stub.of.washer_quarter,
                prying: stub.of.prying == Prying::Develops,
                modes: stub.modes.clone(),
                mode,
                resistance: c.worked.value,
                web: None,
            });
        }
        out
    }
}

impl WebRecord {
    fn of(c: &Component) -> Option<Self> {
        let step = |symbol| c.worked.step(symbol);
        Some(Self {
            part: c.kind.words().into(),
            width: step("b_eff")?,
            thickness: step("t_w")?,
            fy: step("f_y")?,
            omega: step("ω").unwrap_or(1.0),
            resistance: c.worked.value,
        })
    }
}

impl LimitRecord {
    fn new(limit: &Limit) -> Self {
        let id = match limit.of {
            Summed::ColumnWeb => CheckId::ColumnWebCompression,
            Summed::BeamFlange => CheckId::BeamFlangeCompression,
            Summed::Panel => CheckId::ColumnPanel,
        };
        let Worked { clause, steps, value, .. } = &limit.worked;
        Self {
            part: id.title().into(),
            clause: (*clause).into(),
            formula: limit.worked.formula(),
            values: steps.clone(),
            resistance: *value,
        }
    }
}
