//! The data of the printed report. They are plain strings and tables, so that the sections do not
//! depend on the engine.

use crate::result::result_file::ResultFile;

/// All data of the report. The numbers of the analyses come from `result`, the same as in
/// `result.json`.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportData {
    /// Lines of the title block in order, as name (`title`, `number`, `author`, …) and value. The
    /// first line is the heading.
    pub project: Vec<(String, String)>,
    /// The result.
    pub result: ResultFile,
    /// Name of the input file as the user gave it.
    pub input_name: String,
    /// Text of the input file, as given.
    pub input_text: String,
    /// The input as read, as YAML: without comments, with the defaults of its fixed part.
    pub input_read: String,
    /// Values that the program looked up, computed or assumed.
    pub resolved: Vec<ResolvedValue>,
    /// Rows taken from catalogues.
    pub catalogue_rows: Vec<CatalogueRow>,
    /// Drawings of the joint and of its actions.
    pub drawings: Vec<PictureRef>,
    /// Bolts, plates and their masses; empty if they are not known.
    pub schedule: Table,
    /// Pictures of the result folder.
    pub pictures: Vec<PictureRef>,
    /// Quality of the last mesh, usually one row for each body.
    pub mesh_quality: Table,
    /// Features of the model, for the sentences about limits.
    pub model: ModelTraits,
    /// Further assumptions, a sentence each.
    pub assumptions: Vec<String>,
    /// Decisions and remarks of the reader, a sentence each.
    pub notes: Vec<String>,
}

/// A value that the program resolved.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ResolvedValue {
    /// Its name: `bolts.rows[1]`.
    pub name: String,
    /// Its value with meaningful digits.
    pub value: String,
    /// Its unit; empty for a plain number or word.
    pub unit: String,
    /// Its origin: `given`, `default`, `catalogue`, `computed`.
    pub origin: String,
}

/// A row taken from a catalogue.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CatalogueRow {
    /// Kind: `profile`, `bolt`, `steel`.
    pub kind: String,
    /// Name of the row.
    pub name: String,
    /// Standard and edition of the numbers.
    pub source: String,
    /// True if the row is from a table of the user.
    pub own: bool,
    /// Column with unit (`h [mm]`) and value.
    pub values: Vec<(String, String)>,
}

/// A picture of the result folder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PictureRef {
    /// File name, relative to the folder.
    pub file: String,
    /// Caption.
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

/// Features of the model that the report must mention.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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
