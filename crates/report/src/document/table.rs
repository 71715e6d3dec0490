//! Tables of texts.

use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// A table: titles with units, rows of text.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Table {
    /// Titles, units in brackets.
    pub columns: Vec<Text>,
    /// Rows, as long as `columns`.
    pub rows: Vec<Vec<Text>>,
}

impl Table {
    /// Titles.
    pub fn columns<const N: usize>(columns: [&'static str; N]) -> Vec<Text> {
        columns.map(Text::from).to_vec()
    }

    /// A table with these titles.
    pub fn new<const N: usize>(
        columns: [&'static str; N],
        rows: impl IntoIterator<Item = [Text; N]>,
    ) -> Self {
        Self { columns: Self::columns(columns), rows: rows.into_iter().map(Vec::from).collect() }
    }
}

/// Texts in bold type.
pub(crate) fn bold(text: impl Into<Text>) -> Text {
    bracket_base::say!("**{}**", text.into())
}

/// The text of a cell without a value.
pub(crate) fn dash() -> Text {
    Text::given("–")
}

/// The cells of a row: texts, and strings that are given.
macro_rules! cells {
    ($($cell:expr),* $(,)?) => {
        vec![$(bracket_base::words::Text::from($cell)),*]
    };
}

pub(crate) use cells;
