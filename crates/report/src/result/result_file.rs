//! `result.json` (docs/results.md, schema 1): the results of a run for other programs.
//!
//! A value that was not computed is `None` and has no key in the file; it is never written as zero,
//! NaN or null. [`ResultFile::to_json`] refuses a result that breaks this rule. It also refuses a
//! result that claims to be strict without residuals within the tolerance.

pub use crate::result::case_result::CaseResult;
pub use crate::result::case_result::PartShare;
pub use crate::result::case_result::PartYield;
pub use crate::result::case_result::PeakPressure;
pub use crate::result::case_result::WeldUse;
pub use crate::result::certificate::{Certificate, RESIDUAL_TOLERANCE};
pub use crate::result::history::{HistoryRow, Predicted, ProgramRun, SoFar, TraceRow};
use crate::result::judged_case::JudgedCase;
use crate::result::polygon::CapacityPolygon;
use crate::result::proved_by::Direction;
pub use crate::result::quantity::{
    FrictionModel, LoadSize, Quantity, RawBracket, Unbounded, Upper,
};
use bracket_base::diag::Diagnostic;
use bracket_base::words::Text;
use bracket_codes::end_plate::MethodRecord;
pub use bracket_codes::verdict::Verdict;
use bracket_codes::{Check, Judgement};
use bracket_joint::assembly::Neglected;
use serde::{Deserialize, Serialize};

/// Version of the form of `result.json`.
pub const SCHEMA: u32 = 1;

/// Name of the program that writes results.
pub const PROGRAM: &str = "bracket";

/// Name of the file inside a result folder.
pub const RESULT_FILE: &str = "result.json";

/// A whole `result.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ResultFile {
    /// [`SCHEMA`].
    pub schema: u32,
    /// The program that wrote the result.
    pub tool: Tool,
    /// Hash of the input; see [`input_hash`].
    pub input_hash: String,
    /// Number of copies of the meshed part that make up the structure.
    pub symmetry: u32,
    /// The verdict on the whole result.
    pub verdict: Verdict,
    /// If a demand is judged: the verdicts by code and by analysis, the reason and the governing
    /// check.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub judgement: Option<Judgement>,
    /// The verdict on each load case, where several are judged.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub load_cases: Vec<JudgedCase>,
    /// Load case of every requested analysis, in the order of the analyses; a case occurs several
    /// times if there are several kinds of analysis.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub asked: Vec<String>,
    /// One entry for each load case and kind of analysis.
    pub cases: Vec<CaseResult>,
    /// Directions of the space of actions that were analysed to bound load cases; their entries
    /// stand behind those of the load cases.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub directions: Vec<Direction>,
    /// Hand checks of the code.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub checks: Vec<Check>,
    /// Actions at member ends that are neglected, in the checks as in the models.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub neglected: Vec<Neglected>,
    /// The component method of each sense of bending, with all numbers of M_j,Rd.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub component_method: Vec<MethodRecord>,
    /// Capacity of the joint under two actions together.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub polygon: Option<CapacityPolygon>,
    /// Warnings that belong to no single case.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Text>,
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
        Self { name: PROGRAM.into(), version: env!("CARGO_PKG_VERSION").into() }
    }
}

/// Reason why a `result.json` cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum ResultError {
    /// A number is NaN or infinite.
    #[error("the result holds a number that is not finite at `{path}`")]
    NotFinite {
        /// Place inside the document.
        path: String,
    },
    /// The certificate claims to be strict, but a residual exceeds the tolerance.
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
    /// The certificate claims to be strict without any residual.
    #[error("case `{case}` calls its bounds strict, but no residual was computed")]
    NoResidual {
        /// Name of the case.
        case: String,
    },
    /// The file does not have the form of schema 1.
    #[error("this is not a result of this program: {0}")]
    Form(#[from] serde_json::Error),
    /// The file has another schema.
    #[error("the result has schema {found}, this program reads schema {SCHEMA}")]
    Schema {
        /// The schema of the file.
        found: u32,
    },
    /// The file was written by another program.
    #[error("the result was written by `{found}`, not by `{}`", PROGRAM)]
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
                let help = "name the folder of a finished `bracket` result; make a result of an \
                            earlier edition again with this one";
                Diagnostic::input("report/not-a-result", text).help(help)
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
            load_cases: Vec::new(),
            asked: Vec::new(),
            cases,
            directions: Vec::new(),
            checks,
            neglected: Vec::new(),
            component_method: Vec::new(),
            polygon: None,
            warnings,
        }
    }

    /// The text of `result.json`. Equal results give equal texts.
    pub fn to_json(&self) -> Result<String, ResultError> {
        for case in &self.cases {
            let Some(certificate) = case.certificate.filter(|c| c.strict) else { continue };
            let known: Vec<_> =
                certificate.residuals().into_iter().filter_map(|(n, _, v)| Some((n, v?))).collect();
            if known.is_empty() {
                return Err(ResultError::NoResidual { case: case.name.clone() });
            }
            // a NaN residual passes here and is reported below with its place
            if let Some(&(residual, value)) = known.iter().find(|(_, v)| *v > RESIDUAL_TOLERANCE) {
                return Err(ResultError::NotStrict { case: case.name.clone(), residual, value });
            }
        }
        let mut text = serde_json::to_string_pretty(self)?;
        // serde_json writes NaN and infinity as null, and no field is null otherwise; a text may
        // have the word
        if text.contains("null")
            && let Some(path) = find_null(&serde_json::to_value(self)?)
        {
            return Err(ResultError::NotFinite { path });
        }
        text.push('\n');
        Ok(text)
    }

    /// Reads `result.json`. Another schema or another program is refused.
    pub fn from_json(text: &str) -> Result<Self, ResultError> {
        Self::is_of_this_program(text)?;
        Ok(serde_json::from_str(text)?)
    }

    /// Whether the text is a `result.json` of this program, of whatever edition: a new result may
    /// replace it, though this edition may miss keys that it reads.
    pub fn is_of_this_program(text: &str) -> Result<(), ResultError> {
        #[derive(Deserialize)]
        struct Head {
            schema: u32,
            tool: Tool,
        }
        let head: Head = serde_json::from_str(text)?;
        if head.tool.name != PROGRAM {
            return Err(ResultError::Tool { found: head.tool.name });
        }
        if head.schema != SCHEMA {
            return Err(ResultError::Schema { found: head.schema });
        }
        Ok(())
    }
}

/// The path of a null within a value.
fn find_null(value: &serde_json::Value) -> Option<String> {
    use serde_json::Value;
    let below = |head: String, v: &Value| {
        let rest = find_null(v)?;
        let dot = if rest.is_empty() || rest.starts_with('[') { "" } else { "." };
        Some(format!("{head}{dot}{rest}"))
    };
    match value {
        Value::Null => Some(String::new()),
        Value::Array(all) => all.iter().enumerate().find_map(|(i, v)| below(format!("[{i}]"), v)),
        Value::Object(map) => map.iter().find_map(|(k, v)| below(k.clone(), v)),
        _ => None,
    }
}

/// Hash of the named parts of an input (spec, mesh, catalogue): BLAKE3 in hex. It covers names and
/// lengths as well, so that two different lists of parts with the same concatenation have different
/// hashes.
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
mod tests;
