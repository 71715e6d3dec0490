//! Data on standard output; messages go to standard error.

use bracket_base::diag::{Diagnostic, Diagnostics, in_line, visible};
use serde::Serialize;
use std::io::{ErrorKind, Write};

/// Writes text for people to standard output.
pub fn text(text: &str) -> Result<(), Diagnostics> {
    data(&visible(text))
}

/// Writes data for programs to standard output, as they are. A reader that closes the pipe early
/// (`bracket … | head`) is not a fault.
pub fn data(data: &str) -> Result<(), Diagnostics> {
    let mut out = std::io::stdout().lock();
    match out.write_all(data.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(Diagnostic::environment(
            "cli/stdout",
            format!("cannot write to standard output: {e}"),
        )
        .help("check the disk or the pipe the output goes to")
        .into()),
        _ => Ok(()),
    }
}

/// Writes a line to standard error. Nobody reads it any more if standard error is closed; that is
/// not a fault.
pub fn remark(line: &str) {
    let _ = writeln!(std::io::stderr(), "{}", visible(line));
}

/// Writes one JSON document and a newline to standard output.
pub fn json(document: &impl Serialize) -> Result<(), Diagnostics> {
    data(&format!("{:#}\n", serde_json::json!(document)))
}

/// Arranges the cells of each line in columns: the first column left-aligned, numbers
/// right-aligned, two blanks between columns.
pub fn columns(head: &[&str], rows: &[Vec<String>]) -> String {
    // before the widths, so that columns stay in line
    let clean = |row: &Vec<String>| row.iter().map(|cell| in_line(cell)).collect();
    let rows: Vec<Vec<String>> = rows.iter().map(clean).collect();
    let width = |i: usize| {
        rows.iter()
            .map(|r| r[i].chars().count())
            .chain([head[i].chars().count()])
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    let number =
        |i: usize| i > 0 && rows.iter().all(|r| r[i] == "-" || r[i].parse::<f64>().is_ok());
    let right: Vec<bool> = (0..head.len()).map(number).collect();
    let line = |cells: &mut dyn Iterator<Item = &str>| {
        let mut line = String::new();
        for (i, cell) in cells.enumerate() {
            let gap = " ".repeat(widths[i] - cell.chars().count());
            line.push_str(if i > 0 { "  " } else { "" });
            if right[i] {
                line.push_str(&gap);
            }
            line.push_str(cell);
            if !right[i] {
                line.push_str(&gap);
            }
        }
        line.truncate(line.trim_end().len());
        line + "\n"
    };
    let mut text = line(&mut head.iter().copied());
    for row in &rows {
        text += &line(&mut row.iter().map(String::as_str));
    }
    text
}

#[cfg(test)]
mod tests {
    #[test]
    fn numbers_stand_right_and_names_left() {
        let rows = [["IPE80", "80", "a"], ["UB1016", "1016.5", "bb"]]
            .map(|r| r.map(str::to_owned).to_vec());
        let expected = "name         h  text\nIPE80       80  a\nUB1016  1016.5  bb\n";
        assert_eq!(super::columns(&["name", "h", "text"], &rows), expected);
    }
}
