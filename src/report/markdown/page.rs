//! What the printed report is made of: plain strings and tables, so that the writers know nothing
//! of the engine.

use crate::result::data::ResultFile;

/// Everything on the page. The numbers of the analyses come from `result`, the same as in
/// `result.json`.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportData {
    /// Lines of the title block, in order: name (`title`, `number`, `author`, …) and value. The
    /// first is the heading.
    pub project: Vec<(String, String)>,
    /// The result.
    pub result: ResultFile,
    /// Name of the input file as the user gave it.
    pub input_name: String,
    /// Its text, as given.
    pub input_text: String,
    /// What was read from it, as YAML: without comments, with the defaults of its fixed part.
    pub input_read: String,
    /// Values the program looked up, computed or assumed.
    pub resolved: Vec<ResolvedValue>,
    /// Rows taken from catalogues.
    pub catalogue_rows: Vec<CatalogueRow>,
    /// Drawings of the joint and of its actions.
    pub drawings: Vec<PictureRef>,
    /// Bolts, plates and their masses; empty where they are not known.
    pub schedule: Table,
    /// Pictures of the result folder.
    pub pictures: Vec<PictureRef>,
    /// Quality of the last mesh, usually a row a body.
    pub mesh_quality: Table,
    /// What the model holds, for the sentences about limits.
    pub model: ModelTraits,
    /// Further assumptions, a sentence each.
    pub assumptions: Vec<String>,
    /// What the reader decided or noticed, a sentence each.
    pub notes: Vec<String>,
}

/// A value the program resolved.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ResolvedValue {
    /// What it is: `bolts.rows[1]`.
    pub name: String,
    /// Its value with meaningful digits.
    pub value: String,
    /// Its unit; empty for a plain number or word.
    pub unit: String,
    /// Where it comes from: `given`, `default`, `catalogue`, `computed`.
    pub origin: String,
}

/// A row taken from a catalogue.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CatalogueRow {
    /// Kind: `profile`, `bolt`, `steel`.
    pub kind: String,
    /// Name of the row.
    pub name: String,
    /// Standard and edition the numbers come from.
    pub source: String,
    /// Whether the row stands in a table of the user's own.
    pub own: bool,
    /// Column with unit (`h [mm]`) and value.
    pub values: Vec<(String, String)>,
}

/// A picture of the result folder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PictureRef {
    /// File name, relative to the folder.
    pub file: String,
    /// What it shows.
    pub caption: String,
}

/// A table: titles with units, rows of text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    /// Titles, units in brackets.
    pub columns: Vec<String>,
    /// Rows, as long as `columns`.
    pub rows: Vec<Vec<String>>,
}

/// What the model holds, as far as the report must say something about it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ModelTraits {
    /// There is contact.
    pub contact: bool,
    /// Some contact has friction.
    pub friction: bool,
    /// Some contact with friction follows Coulomb's law (otherwise all of it is associated).
    pub coulomb: bool,
    /// Some contact opens with a gap.
    pub initial_gap: bool,
    /// Some bolt is preloaded.
    pub preload: bool,
    /// Curved surfaces (holes, shanks, fillets) are meshed as facets.
    pub facets: bool,
    /// Members are cut, or planes of symmetry are used.
    pub symmetry: bool,
}
