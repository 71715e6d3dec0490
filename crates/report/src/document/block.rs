//! The elements of a document: plain data in the language of the reader, which a writer sets.

use super::symbols::Piece;
use serde::Serialize;

/// A run of text in one style.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Span {
    /// The text.
    pub text: String,
    /// The text with its symbols; empty where it has none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pieces: Vec<Piece>,
    /// True in bold type.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub bold: bool,
    /// True in the type of code.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub code: bool,
}

impl Span {
    /// A text without symbols and styles.
    pub fn plain(text: impl Into<String>) -> Self {
        Self { text: text.into(), pieces: Vec::new(), bold: false, code: false }
    }
}

/// Text with styles.
pub type Spans = Vec<Span>;

/// A table with styled cells.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Grid {
    /// Titles.
    pub columns: Vec<Spans>,
    /// True for columns of numbers, which are set to the right.
    pub right: Vec<bool>,
    /// Rows, as long as `columns`.
    pub rows: Vec<Vec<Spans>>,
}

/// An element of a section.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Block {
    /// A heading.
    Heading {
        /// 0 for the title of the document, 1 for its sections.
        level: u8,
        /// Its text.
        text: Spans,
    },
    /// A paragraph.
    Paragraph {
        /// Its text.
        text: Spans,
    },
    /// A list, an item a line.
    List {
        /// Its items.
        items: Vec<Spans>,
    },
    /// A table.
    Table {
        /// Its cells.
        table: Grid,
    },
    /// Text as given: the input, in YAML.
    Code {
        /// Its lines.
        text: String,
    },
    /// A picture of the result folder.
    Picture {
        /// Its caption.
        caption: Spans,
        /// File name, relative to the folder.
        file: String,
    },
}
