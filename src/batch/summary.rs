//! `summary.html`: the sweep as one page that opens from disk, without network.

use super::capacity::{Filled, shown};
use super::choice_table::Shown;
use super::counts::Counts;
use super::row::Outcome;
use crate::math::figures::Rounding;
use crate::report::escaped::{escaped, inside_script};
use serde_json::{Map, Value};

/// Style of the page.
const STYLE: &str = include_str!("summary/summary.css");

/// Sorting, filtering and the chart.
const SCRIPT: &str = include_str!("summary/summary.js");

/// Rows that the page holds: a browser sorts and filters so many without delay.
const MOST_ROWS: usize = 20_000;

/// All rows, or the `most` with the worst outcomes.
pub fn worst_first(rows: &[Map<String, Value>], most: usize) -> Vec<&Map<String, Value>> {
    let mut out: Vec<&Map<String, Value>> = rows.iter().collect();
    if out.len() > most {
        let rank = |r: &Map<String, Value>| {
            Outcome::ALL.iter().rev().position(|o| r["outcome"] == o.word())
        };
        // a stable sort; rows that are open come first
        out.sort_by_key(|r| rank(r));
        out.truncate(most);
    }
    out
}

/// The page of a sweep.
pub fn page(
    title: &str,
    counts: &Counts,
    broken: &[String],
    choice: Option<&Shown>,
    tables: &[Filled],
    rows: &[Map<String, Value>],
) -> String {
    let mut out = String::new();
    let title = escaped(title);
    out.push_str("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">");
    out.push_str("<meta name=\"viewport\" content=\"width=device-width\">");
    out.push_str(&format!("<title>{title}</title>\n<style>\n{STYLE}</style></head>\n<body>\n"));
    out.push_str(&format!("<h1>{title}</h1>\n<p>{} cases: ", counts.all()));
    let outcomes = Outcome::ALL.iter().rev().filter(|o| counts.with(**o) > 0);
    let words: Vec<String> = outcomes
        .map(|o| {
            let word = o.word();
            format!("<b class=\"{word}\">{} {}</b>", counts.with(*o), word.replace('_', " "))
        })
        .collect();
    out.push_str(&words.join(", "));
    if counts.open > 0 {
        out.push_str(&format!(", <b>{} not finished</b>", counts.open));
    }
    out.push_str("</p>\n");
    for condition in broken {
        let text = escaped(condition);
        out.push_str(&format!(
            "<p class=\"failed\">Expected, and not so: <code>{text}</code></p>\n"
        ));
    }
    if let Some(shown) = choice {
        out.push_str(&chosen(shown));
    }
    tables.iter().for_each(|t| out.push_str(&capacity(t)));
    out.push_str("<h2>Cases</h2>\n<p><label>Filter: <input id=\"filter\" type=\"search\" ");
    out.push_str(
        "placeholder=\"words, e.g. IPE330 undecided\"></label> <span id=\"shown\"></span></p>\n",
    );
    out.push_str("<div class=\"wide\"><table id=\"cases\"></table></div>\n");
    out.push_str("<h2>Mass against load factor</h2>\n<p>Mass of plates and bolts; a bar from the ");
    out.push_str("lower to the upper bound of the load factor, a tick for the component method. ");
    out.push_str("The line is the given load.</p>\n<div id=\"chart\"></div>\n");
    out.push_str("<h2>Gap against time</h2>\n<p>How far apart the bounds of a case are, over the ");
    out.push_str("time that it took.</p>\n<div id=\"effort\"></div>\n");
    let shown = worst_first(rows, MOST_ROWS);
    if shown.len() < rows.len() {
        let (some, all) = (shown.len(), rows.len());
        out.push_str(&format!(
            "<p>This page holds {some} of {all} rows, the worst first; results.csv has all.</p>\n"
        ));
    }
    let data = Value::Array(shown.into_iter().cloned().map(Value::Object).collect());
    out.push_str("<script type=\"application/json\" id=\"data\">");
    out.push_str(&inside_script(&data.to_string()));
    out.push_str(&format!("</script>\n<script>\n{SCRIPT}</script>\n</body></html>\n"));
    out
}

/// The table of the chosen joints.
fn chosen(table: &Shown) -> String {
    let cells = |tag: &str, texts: &mut dyn Iterator<Item = &str>| {
        texts.map(|t| format!("<{tag}>{}</{tag}>", escaped(t))).collect::<String>()
    };
    let head = cells("th", &mut table.heads.iter().copied());
    let mut out = format!(
        "<h2>Chosen joints</h2>\n<p>Least <code>{}</code>. {}</p>\n\
         <table><thead><tr>{head}</tr></thead>\n<tbody>\n",
        escaped(&table.least),
        escaped(&table.sentence)
    );
    for row in &table.cells {
        let row = cells("td", &mut row.iter().map(String::as_str));
        out.push_str(&format!("<tr>{row}</tr>\n"));
    }
    out.push_str("</tbody></table>\n");
    out
}

/// A capacity table.
pub fn capacity(table: &Filled) -> String {
    let mut out = format!(
        "<h2>{}</h2>\n<p>{}: <b>at least</b> – at most, ",
        escaped(&table.title),
        escaped(&table.what)
    );
    out.push_str("<span class=\"component\">component method</span></p>\n");
    let corner = format!("{} \\ {}", escaped(&table.row_path), escaped(&table.column_path));
    out.push_str(&format!("<table class=\"capacity\"><thead><tr><th>{corner}</th>"));
    table.columns.iter().for_each(|c| out.push_str(&format!("<th>{}</th>", escaped(c))));
    out.push_str("</tr></thead>\n<tbody>\n");
    for (head, cells) in table.rows.iter().zip(&table.cells) {
        out.push_str(&format!("<tr><th>{}</th>", escaped(head)));
        for cell in cells {
            out.push_str("<td>");
            let bounds = [
                cell.lower.map(|v| format!("<b>{}</b>", shown(Some(v), Rounding::Down))),
                cell.upper.map(|v| format!("– {}", shown(Some(v), Rounding::Up))),
                cell.component.map(|v| {
                    format!("<span class=\"component\">{}</span>", shown(Some(v), Rounding::Down))
                }),
                cell.code_fails.then(|| "<span class=\"not_ok\">a check fails</span>".to_string()),
                cell.outcome
                    .filter(|o| *o >= Outcome::TimedOut)
                    .map(|o| format!("<span class=\"{0}\">{1}</span>", o.word(), o.plain())),
            ];
            out.push_str(&bounds.into_iter().flatten().collect::<Vec<_>>().join(" "));
            out.push_str("</td>");
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody></table>\n");
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// Of many rows the page holds the worst, and says so.
    #[test]
    fn many_rows() {
        let row = |i: usize| -> Map<String, Value> {
            let outcome = if i.is_multiple_of(4) { "failed" } else { "ok" };
            let values = [("case", json!(format!("c{i}"))), ("outcome", json!(outcome))];
            values.into_iter().map(|(k, v)| (k.to_string(), v)).collect()
        };
        let rows: Vec<_> = (0..MOST_ROWS + 4000).map(row).collect();
        let page = page("t", &Counts::default(), &[], None, &[], &rows);
        assert_eq!(page.matches("\"failed\"").count(), rows.len() / 4);
        assert!(page.contains("20000 of 24000 rows"));
    }

    /// Names of cases come from users' tables.
    #[test]
    fn hostile_names_stay_text() {
        let name = "</script><img src=x onerror=alert(1)>";
        let mut row = Map::new();
        row.insert("case".into(), json!(name));
        let page = page(name, &Counts::default(), &[name.to_string()], None, &[], &[row]);
        assert_eq!(page.matches("<img").count(), 0, "{page}");
        assert_eq!(page.matches("</script>").count(), 2, "{page}");
    }
}
