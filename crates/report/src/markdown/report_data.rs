//! The data of the printed report. They are plain strings and tables, so that the sections do not
//! depend on the engine.

use crate::document::picture::PictureRef;
use crate::document::table::Table;
use crate::result::demand::EndAction;
use crate::result::result_file::{RESULT_FILE, ResultFile};
use crate::words::Words;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::words::{Collected, Text, collected};
use bracket_codes::verdict::Verdict;
use bracket_joint::spec::connection::Language;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The facts of the input: what a report says of it before anything is analysed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct InputFacts {
    /// Lines of the title block in order, as name (`title`, `number`, `author`, …) and value. The
    /// first line is the heading.
    pub project: Vec<(String, String)>,
    /// Language of the reports.
    #[serde(default)]
    pub language: Language,
    /// Name of the input file as the user gave it.
    #[serde(rename = "input_name")]
    pub name: String,
    /// Text of the input file, as given.
    #[serde(rename = "input_text")]
    pub text: String,
    /// The input as read, as YAML: without comments, with the defaults of its fixed part.
    #[serde(rename = "input_read")]
    pub read: String,
    /// Values that the program looked up, computed or assumed.
    pub resolved: Vec<ResolvedValue>,
    /// Actions at member ends, of each load case that is a demand; a model file has none.
    pub demands: Vec<GivenActions>,
    /// The actions at the bolt planes; empty where they are given there.
    #[serde(default)]
    pub plane_actions: Table,
    /// What the table of the actions at the bolt planes is.
    #[serde(default)]
    pub plane_note: Text,
    /// Rows taken from catalogues.
    pub catalogue_rows: Vec<CatalogueRow>,
    /// Drawings of the joint and of its actions.
    pub drawings: Vec<PictureRef>,
    /// Bolts, plates and their masses; empty if they are not known.
    pub schedule: Table,
    /// Welds; empty if they are not known.
    #[serde(default)]
    pub welds: Table,
    /// Whether one of them is a butt weld.
    #[serde(default)]
    pub butt_welds: bool,
    /// Supports of the model; empty if there are none.
    #[serde(default)]
    pub supports: Table,
}

/// All data of the report. The numbers of the analyses come from `result`, the same as in
/// `result.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReportData {
    /// The facts of the input; the keys of `report.json` do not nest.
    #[serde(flatten)]
    pub input: InputFacts,
    /// The result; `report.json` does not repeat it.
    #[serde(skip, default = "nothing")]
    pub result: ResultFile,
    /// Pictures of the result folder.
    pub pictures: Vec<PictureRef>,
    /// Quality of the last mesh, usually one row for each body.
    pub mesh_quality: Table,
    /// Features of the model, for the sentences about limits.
    pub model: ModelTraits,
    /// Further assumptions, a sentence each.
    pub assumptions: Vec<Text>,
    /// Decisions and remarks of the reader, a sentence each.
    pub notes: Vec<Text>,
    /// The data of the sentences of `report.json` and `result.json`, by which a report says them in
    /// another language.
    #[serde(default)]
    pub words: Collected,
}

/// File of the report's data beside `result.json`.
pub const REPORT_DATA_FILE: &str = "report.json";

/// In place of the result until it is joined.
fn nothing() -> ResultFile {
    ResultFile::new("", 1, Verdict::None)
}

impl ReportData {
    /// The text of `report.json`, with the data of its sentences and of those of the result.
    pub fn to_json(&mut self) -> Result<String, Diagnostics> {
        let fault =
            |e| Diagnostic::environment("report/data", format!("the report's data: {e}")).into();
        let (written, words) = collected(|| {
            serde_json::to_writer(std::io::sink(), &self.result)?;
            serde_json::to_writer(std::io::sink(), self)
        });
        written.map_err(fault)?;
        self.words = words;
        serde_json::to_string_pretty(self).map(|t| t + "\n").map_err(fault)
    }

    /// The words of the reports.
    pub fn words(&self) -> Words {
        Words::new(self.input.language).with(self.words.clone())
    }

    /// The data of a finished result folder.
    pub fn read(folder: &Path) -> Result<Self, Diagnostics> {
        let missing = |file: &str, e: String| {
            let message = format!("`{file}` of the result cannot be read: {e}");
            let help = "name the folder of a result that `bracket run` or `bracket check` wrote";
            Box::new(Diagnostic::input("report/data", message).file(folder.join(file)).help(help))
        };
        let read = |file: &str| {
            bracket_base::text_file::utf8_of(&folder.join(file))
                .map_err(|e| missing(file, e.to_string()))
        };
        let result = ResultFile::from_json(&read(RESULT_FILE)?)
            .map_err(|e| Diagnostic::from(e).file(folder.join(RESULT_FILE)))?;
        let text = read(REPORT_DATA_FILE)?;
        let data: Self =
            serde_json::from_str(&text).map_err(|e| missing(REPORT_DATA_FILE, e.to_string()))?;
        Ok(Self { result, ..data })
    }
}

/// A value that the program resolved.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ResolvedValue {
    /// Its name: `bolts.rows[1]`.
    pub name: String,
    /// Its value with meaningful digits.
    pub value: Text,
    /// Its unit; empty for a plain number or word.
    pub unit: String,
    /// Its origin: `given`, `default`, `catalogue`, `computed`.
    pub origin: Text,
}

/// The actions of a load case at member ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GivenActions {
    /// Name of the load case.
    pub case: String,
    /// Its actions.
    pub actions: Vec<EndAction>,
}

/// A row taken from a catalogue.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CatalogueRow {
    /// Kind: `profile`, `bolt`, `steel`.
    pub kind: Text,
    /// Name of the row.
    pub name: String,
    /// Standard and edition of the numbers.
    pub source: Text,
    /// True if the row is from a table of the user.
    pub own: bool,
    /// Column with unit (`h [mm]`) and value.
    pub values: Vec<(String, String)>,
}

/// Features of the model that the report must mention.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ModelTraits {
    /// There is contact.
    pub contact: bool,
    /// Some contact has friction.
    pub friction: bool,
    /// Some contact with friction follows Coulomb's law (otherwise all of it is associated).
    pub coulomb: bool,
    /// Some contact has an initial gap.
    pub initial_gap: bool,
    /// Some bolt is preloaded.
    pub preload: bool,
    /// Curved surfaces (holes, shanks, fillets) are meshed as facets.
    pub facets: bool,
    /// Members are cut, or planes of symmetry are used.
    pub symmetry: bool,
}
