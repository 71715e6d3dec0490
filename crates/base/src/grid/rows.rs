//! A table as rows of cells.

/// A row of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Line of a text file, or row of a sheet, from 1.
    pub line: usize,
    /// Its cells, without blanks around them.
    pub cells: Vec<String>,
}

/// A table.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Rows with at least one cell that is not empty.
    pub rows: Vec<Row>,
    /// Character between the cells of a text; `None` for a workbook.
    pub separator: Option<char>,
    /// Sheet of the workbook; `None` for a text.
    pub sheet: Option<String>,
}
