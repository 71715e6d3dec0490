//! `result.json` (CONTRACT.md, schema 1): the numbers a run leaves behind for other programs.
//!
//! Absent is absent: what was not computed is `None` and leaves no key behind; no zero, NaN or null
//! stands for it. [`ResultFile::to_json`] refuses a result that breaks this or that calls itself
//! strict without the residuals to show.

use crate::analysis::cone_shift::FixedPointRun;
use crate::analysis::preloaded_bolt::PreloadedBolt;
pub use crate::checks::verdict::Verdict;
use crate::checks::{Check, JointStiffness, Judgement};
use crate::diag::Diagnostic;
use crate::result::demand::Demand;
use crate::result::forces::StaticForces;
pub use crate::result::history::{HistoryRow, Predicted, ProgramRun, TraceRow};
use crate::result::polygon::CapacityPolygon;
use crate::spec::analysis::AnalysisKind;
use serde::{Deserialize, Serialize};

/// Version of the form of `result.json`.
pub const SCHEMA: u32 = 1;

/// Name of the file inside a result folder.
pub const RESULT_FILE: &str = "result.json";

/// Largest certificate residual of a strict bound, dimensionless (CONTRACT.md, `result.json`).
pub const RESIDUAL_TOLERANCE: f64 = 1e-9;

/// A whole `result.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ResultFile {
    /// [`SCHEMA`].
    pub schema: u32,
    /// What wrote it.
    pub tool: Tool,
    /// Hash of the input, see [`input_hash`].
    pub input_hash: String,
    /// How many copies of the meshed part make the structure.
    pub symmetry: u32,
    /// The answer in one word.
    pub verdict: Verdict,
    /// Where a demand is judged: the verdicts by code and by analysis, the reason and what governs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub judgement: Option<Judgement>,
    /// One entry a load case and kind of analysis.
    pub cases: Vec<CaseResult>,
    /// Hand checks of the code.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub checks: Vec<Check>,
    /// What two actions are carried of together.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub polygon: Option<CapacityPolygon>,
    /// What the user must know, beyond any one case.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<String>,
}

/// The program that wrote a result.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tool {
    /// `bracket`.
    pub name: String,
    /// Its version.
    pub version: String,
}

impl Tool {
    /// This program.
    pub fn this() -> Self {
        Self { name: env!("CARGO_PKG_NAME").into(), version: env!("CARGO_PKG_VERSION").into() }
    }
}

/// What `lower` and `upper` bracket.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Potential energy of the whole structure at equilibrium \[N mm\], negative under load.
    PotentialEnergy,
    /// Factor on the loads at collapse.
    LoadFactor,
}

/// The problem whose solution the bracket contains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FrictionModel {
    /// No friction anywhere (also: no contact at all).
    Frictionless,
    /// Associated friction: slip dilates.
    Associated,
    /// Coulomb friction.
    Coulomb,
    /// The last problem of the fixed point for Coulomb friction: cones shifted by the slip of the
    /// one before.
    ShiftedCones,
}

/// An upper bound: a number, or the word `unbounded`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Upper {
    /// A finite bound.
    Finite(f64),
    /// The loads can grow without limit.
    Unbounded(Unbounded),
}

/// The word `unbounded`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Unbounded {
    /// The word itself.
    Unbounded,
}

impl Upper {
    /// The loads can grow without limit.
    pub const UNBOUNDED: Self = Upper::Unbounded(Unbounded::Unbounded);

    /// The finite bound, if it is one.
    pub fn finite(self) -> Option<f64> {
        match self {
            Upper::Finite(x) => Some(x),
            Upper::Unbounded(_) => None,
        }
    }
}

impl From<f64> for Upper {
    fn from(x: f64) -> Self {
        Upper::Finite(x)
    }
}

/// A raw bracket beside the main one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RawBracket {
    /// Lower bound, unit of the case's quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper bound, unit of the case's quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<Upper>,
}

/// One load case under one kind of analysis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaseResult {
    /// Name of the load case.
    pub name: String,
    /// Kind of analysis.
    pub analysis: AnalysisKind,
    /// What is bracketed.
    pub quantity: Quantity,
    /// Whose solution is bracketed.
    pub problem: FrictionModel,
    /// Lower bound of the whole structure (−Π_c \[N mm\] or load factor); an estimate unless the
    /// certificate is strict.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper bound of the whole structure (Π_p \[N mm\] or load factor); an estimate unless the
    /// certificate is strict.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<Upper>,
    /// Relative gap, a fraction (MECHANICS section 1).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// Bracket of demand over capacity, lower first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<[f64; 2]>,
    /// What the load case demands, where a demand is judged (`run` with limit analysis).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub demand: Option<Demand>,
    /// Raw bracket of the frictionless problem.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frictionless: Option<RawBracket>,
    /// Raw bracket of the problem with associated friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub associated: Option<RawBracket>,
    /// Limit analysis, where asked for: the load factor of the fixed point for Coulomb's law, an
    /// estimate. That law may have several load factors for one structure; this is one of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coulomb_estimate: Option<f64>,
    /// The preloaded bolts of an elastic analysis.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub preload: Vec<PreloadedBolt>,
    /// Coulomb friction: how the fixed point went; in limit analysis that of the estimate, where it
    /// was reached.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fixed_point: Option<FixedPointRun>,
    /// The only load, at load factor 1, of the whole structure: the one whose displacement or
    /// collapse is bracketed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<LoadSize>,
    /// Bracket of the load's own displacement −2Π/F at load factor 1 \[mm; rad for a moment\],
    /// lower first; only where it is rigorous.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_displacement: Option<[f64; 2]>,
    /// Forces of the bolts and between the parts of a joint, from the stress of the lower bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub static_forces: Option<StaticForces>,
    /// Elastic analysis of a joint under one moment: the bracket of its initial stiffness.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint_stiffness: Option<JointStiffness>,
    /// Residuals of the two fields.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<Certificate>,
    /// Elastic, perfectly plastic analysis: the load's own displacement at load factor 1 is at
    /// least so much \[mm; rad for a moment\]; only where it is rigorous.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_displacement_at_least: Option<f64>,
    /// One row a mesh.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub history: Vec<HistoryRow>,
    /// Limit analysis: where the mechanism of the upper bound dissipates, in the order of the
    /// bodies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub dissipation: Vec<PartShare>,
    /// Elastic, perfectly plastic analysis: what has become of each body that can yield, in the
    /// order of the bodies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub yielding: Vec<PartYield>,
    /// Limit analysis: the body whose stress is nearest to the yield surface at the lower bound;
    /// absent where a weld is nearer to its strength.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limiting_part: Option<String>,
    /// Each weld of finite strength.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub welds: Vec<WeldUse>,
    /// Largest contact pressure on the last mesh, from both sides: estimates, not bounds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_contact_pressure: Option<PeakPressure>,
    /// What the user must know about this case.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<String>,
}

/// What a body adds to the dissipation of a mechanism.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartShare {
    /// Name of the body.
    pub part: String,
    /// Its share, a fraction.
    pub share: f64,
}

/// What a weld bears and dissipates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeldUse {
    /// Name of the weld.
    pub weld: String,
    /// Largest traction of the static field over the strength, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<f64>,
    /// Mean of the length of that traction over the strength, at most; a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mean_utilisation: Option<f64>,
    /// Strength on the throat, of which these are parts \[MPa\]; absent where the model gives a
    /// traction instead.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub throat_strength: Option<f64>,
    /// Limit analysis: its share in the dissipation of the mechanism, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub share: Option<f64>,
    /// Elastic kinds: the work it dissipates with the displacements of the upper bound, of the
    /// meshed part \[N mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work: Option<f64>,
}

/// What has become of a body that can yield.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartYield {
    /// Name of the body.
    pub part: String,
    /// Largest `‖dev σ‖/(√(2/3) f_y)` of the lower bound's stress.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<f64>,
    /// Part of its volume where the upper bound's field has plastic strain, a fraction; an
    /// estimate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yielded: Option<f64>,
    /// Plastic work of that field in all copies of the body \[N mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dissipation: Option<f64>,
}

/// The size of a load, not negative, at load factor 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LoadSize {
    /// A force \[N\].
    Force(f64),
    /// A moment \[N mm\].
    Moment(f64),
}

/// Largest contact pressure \[MPa\], positive in pressure. Estimates: no bound on a local value is
/// claimed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PeakPressure {
    /// Of the displacement's stress at the vertices of contact faces.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kinematic: Option<f64>,
    /// Of the static program's tractions.
    #[serde(default, skip_serializing_if = "Option::is_none", rename = "static")]
    pub static_: Option<f64>,
}

/// Residuals of the recovered fields, dimensionless (definitions in CONTRACT.md), recomputed
/// without the solver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// True when every residual is within [`RESIDUAL_TOLERANCE`]: only then `lower` and `upper` are
    /// bounds.
    pub strict: bool,
    /// max |div σ + b| h / max |σ|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub equilibrium: Option<f64>,
    /// max |Δt| / max |t|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub traction_jump: Option<f64>,
    /// max ‖s‖ / (√2 k) − 1; negative inside the yield surface.
    #[serde(default, rename = "yield", skip_serializing_if = "Option::is_none")]
    pub yield_: Option<f64>,
    /// max cone violation / max |r|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<f64>,
    /// max |u − u_d| / max |u|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub compatibility: Option<f64>,
    /// Limit analysis: max |tr ε| h / max |v|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume: Option<f64>,
}

impl Certificate {
    /// Name, definition and value of each residual, in the order of CONTRACT.md.
    pub fn residuals(&self) -> [(&'static str, &'static str, Option<f64>); 6] {
        [
            ("equilibrium", "max |div σ + b| h / max |σ|", self.equilibrium),
            ("traction jump", "max |Δt| / max |t|", self.traction_jump),
            ("yield", "max ‖s‖ / (√2 k) − 1", self.yield_),
            ("contact", "max cone violation / max |r|", self.contact),
            ("compatibility", "max |u − u_d| / max |u|", self.compatibility),
            ("volume", "max |tr ε| h / max |v|", self.volume),
        ]
    }
}

/// Why a `result.json` cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum ResultError {
    /// A number is NaN or infinite.
    #[error("the result holds a number that is not finite at `{path}`")]
    NotFinite {
        /// Place inside the document.
        path: String,
    },
    /// The certificate calls itself strict, its residuals do not.
    #[error(
        "case `{case}` calls its bounds strict, but the {residual} residual is {value:e} (limit \
         {RESIDUAL_TOLERANCE:e})"
    )]
    NotStrict {
        /// Name of the case.
        case: String,
        /// Name of the residual.
        residual: &'static str,
        /// Its value.
        value: f64,
    },
    /// A strict bracket without any residual.
    #[error("case `{case}` calls its bounds strict, but no residual was computed")]
    NoResidual {
        /// Name of the case.
        case: String,
    },
    /// Not the form of schema 1.
    #[error("this is not a result of this program: {0}")]
    Form(#[from] serde_json::Error),
    /// Another schema.
    #[error("the result has schema {found}, this program reads schema {SCHEMA}")]
    Schema {
        /// The schema of the file.
        found: u32,
    },
    /// Written by something else.
    #[error("the result was written by `{found}`, not by `{}`", env!("CARGO_PKG_NAME"))]
    Tool {
        /// Name of the tool in the file.
        found: String,
    },
}

impl From<ResultError> for Diagnostic {
    fn from(e: ResultError) -> Self {
        let text = e.to_string();
        match e {
            ResultError::NotFinite { path } => Diagnostic::undecided("report/not-finite", text)
                .path(path)
                .help("no result was written; the analysis gave no usable number"),
            ResultError::NotStrict { .. } | ResultError::NoResidual { .. } => {
                Diagnostic::undecided("report/not-strict", text)
                    .help("no result was written; please report this fault")
            }
            ResultError::Form(_) | ResultError::Schema { .. } | ResultError::Tool { .. } => {
                Diagnostic::input("report/not-a-result", text)
                    .help("name the folder of a finished `bracket` result")
            }
        }
    }
}

impl ResultFile {
    /// An empty result of this program.
    pub fn new(input_hash: impl Into<String>, symmetry: u32, verdict: Verdict) -> Self {
        let (cases, checks, warnings) = (vec![], vec![], vec![]);
        let (tool, input_hash) = (Tool::this(), input_hash.into());
        Self {
            schema: SCHEMA,
            tool,
            input_hash,
            symmetry,
            verdict,
            judgement: None,
            cases,
            checks,
            polygon: None,
            warnings,
        }
    }

    /// The text of `result.json`, the same for the same result.
    pub fn to_json(&self) -> Result<String, ResultError> {
        for case in &self.cases {
            let Some(certificate) = case.certificate.filter(|c| c.strict) else { continue };
            let known: Vec<_> =
                certificate.residuals().into_iter().filter_map(|(n, _, v)| Some((n, v?))).collect();
            if known.is_empty() {
                return Err(ResultError::NoResidual { case: case.name.clone() });
            }
            // a NaN residual passes here and is caught below with its place
            if let Some(&(residual, value)) = known.iter().find(|(_, v)| *v > RESIDUAL_TOLERANCE) {
                return Err(ResultError::NotStrict { case: case.name.clone(), residual, value });
            }
        }
        // serde_json writes NaN and infinity as null, and no field of ours ever is null otherwise
        let value = serde_json::to_value(self)?;
        if let Some(path) = find_null(&value, String::new()) {
            return Err(ResultError::NotFinite { path });
        }
        let mut text = serde_json::to_string_pretty(&value)?;
        text.push('\n');
        Ok(text)
    }

    /// Reads `result.json`; another schema or tool is refused.
    pub fn from_json(text: &str) -> Result<Self, ResultError> {
        #[derive(Deserialize)]
        struct Head {
            schema: u32,
            tool: Tool,
        }
        let head: Head = serde_json::from_str(text)?;
        if head.tool.name != env!("CARGO_PKG_NAME") {
            return Err(ResultError::Tool { found: head.tool.name });
        }
        if head.schema != SCHEMA {
            return Err(ResultError::Schema { found: head.schema });
        }
        Ok(serde_json::from_str(text)?)
    }
}

fn find_null(value: &serde_json::Value, path: String) -> Option<String> {
    use serde_json::Value;
    match value {
        Value::Null => Some(path),
        Value::Array(items) => {
            items.iter().enumerate().find_map(|(i, v)| find_null(v, format!("{path}[{i}]")))
        }
        Value::Object(map) => map.iter().find_map(|(k, v)| {
            let dot = if path.is_empty() { "" } else { "." };
            find_null(v, format!("{path}{dot}{k}"))
        }),
        _ => None,
    }
}

/// Hash of the named pieces of an input (spec, mesh, catalogue): BLAKE3 in hex, over names and
/// lengths as well, so that no two different lists of pieces hash alike by concatenation.
pub fn input_hash(pieces: &[(&str, &[u8])]) -> String {
    let mut hasher = blake3::Hasher::new();
    for (name, bytes) in pieces {
        for part in [name.as_bytes(), bytes] {
            hasher.update(&(part.len() as u64).to_le_bytes());
            hasher.update(part);
        }
    }
    hasher.finalize().to_hex().to_string()
}

#[cfg(test)]
pub(crate) mod tests;
