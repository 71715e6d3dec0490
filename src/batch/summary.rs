//! `summary.html`: the sweep as one page that opens from disk, without network.

use super::capacity::{Filled, shown};
use super::choice_table::Shown;
use super::counts::Counts;
use super::row::Outcome;
use bracket_base::math::figures::Rounding;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_report::escaped::{escaped, inside_script};
use bracket_report::words::Words;
use serde_json::{Map, Value};

/// Style of the page.
const STYLE: &str = include_str!("summary/summary.css");

/// Sorting, filtering and the chart.
const SCRIPT: &str = include_str!("summary/summary.js");

/// Filter, table of the cases and charts.
const BODY: &str = include_str!("summary/body.html");

/// Rows that the page holds: a browser sorts and filters so many without delay.
const MOST_ROWS: usize = 20_000;

/// The rows, at most `most`: the worst outcome first, then the worst verdict of a load case, then
/// the largest utilisation. Rows that are open come first.
pub fn worst_first(rows: &[Map<String, Value>], most: usize) -> Vec<&Map<String, Value>> {
    let mut out: Vec<&Map<String, Value>> = rows.iter().collect();
    let rank =
        |r: &Map<String, Value>| Outcome::ALL.iter().rev().position(|o| r["outcome"] == o.word());
    let used = |r: &Map<String, Value>| {
        let of = |key: &str| r.get(key).and_then(Value::as_f64);
        let by_bounds = of("utilisation_up");
        of("governing_utilisation").into_iter().chain(by_bounds).fold(f64::NEG_INFINITY, f64::max)
    };
    let verdict = |r: &Map<String, Value>| match r.get("verdict").and_then(Value::as_str) {
        Some("not_ok") => 0,
        Some("undecided") => 1,
        Some("none") => 3,
        _ => 2,
    };
    let order = |r: &Map<String, Value>| (rank(r), verdict(r));
    // a stable sort: equal rows keep the order of the sweep
    out.sort_by(|a, b| order(a).cmp(&order(b)).then(used(b).total_cmp(&used(a))));
    out.truncate(most);
    out
}

/// The page of a sweep.
pub fn page(
    (title, words): (&str, &Words),
    counts: &Counts,
    broken: &[String],
    choice: Option<&Shown>,
    tables: &[Filled],
    rows: &[Map<String, Value>],
) -> String {
    let mut out = String::new();
    let title = escaped(title);
    let say = |text: Text| escaped(&words.say(&text));
    let language = words.code();
    out.push_str(&format!("<!doctype html>\n<html lang=\"{language}\"><head>"));
    out.push_str("<meta charset=\"utf-8\">");
    out.push_str("<meta name=\"viewport\" content=\"width=device-width\">");
    out.push_str(&format!("<title>{title}</title>\n<style>\n{STYLE}</style></head>\n<body>\n"));
    out.push_str(&format!("<h1>{title}</h1>\n<p>{}: ", say(Counts::cases(counts.all()))));
    let outcomes = Outcome::ALL.iter().rev().filter(|o| counts.with(**o) > 0);
    let found: Vec<String> = outcomes
        .map(|o| {
            let word = o.word();
            format!("<b class=\"{word}\">{} {}</b>", counts.with(*o), say(o.plain().into()))
        })
        .collect();
    out.push_str(&found.join(", "));
    if counts.open > 0 {
        out.push_str(&format!(", <b>{} {}</b>", counts.open, say("not finished".into())));
    }
    out.push_str("</p>\n");
    for condition in broken {
        let text = escaped(condition);
        out.push_str(&format!(
            "<p class=\"failed\">{}: <code>{text}</code></p>\n",
            say("Expected, and not so".into())
        ));
    }
    if let Some(shown) = choice {
        out.push_str(&chosen(shown, words));
    }
    tables.iter().for_each(|t| out.push_str(&capacity(t, words)));
    out.push_str(&words.fill(BODY));
    let shown = worst_first(rows, MOST_ROWS);
    if shown.len() < rows.len() {
        let (some, all) = (shown.len(), rows.len());
        let few = say!("{} of {} rows, the worst first; results.csv has all.", some, all);
        out.push_str(&format!("<p>{}</p>\n", say(few)));
    }
    let data = Value::Array(shown.into_iter().cloned().map(Value::Object).collect());
    out.push_str("<script type=\"application/json\" id=\"data\">");
    out.push_str(&inside_script(&data.to_string()));
    let script = words.fill(SCRIPT);
    out.push_str(&format!("</script>\n<script>\n{script}</script>\n</body></html>\n"));
    out
}

/// The table of the chosen joints.
fn chosen(table: &Shown, words: &Words) -> String {
    let cells = |tag: &str, texts: &mut dyn Iterator<Item = &str>| {
        texts.map(|t| format!("<{tag}>{}</{tag}>", escaped(t))).collect::<String>()
    };
    let heads: Vec<String> = table.heads.iter().map(|h| words.say(&(*h).into())).collect();
    let head = cells("th", &mut heads.iter().map(String::as_str));
    let mut out = format!(
        "<h2>{}</h2>\n<p>{} <code>{}</code>. {}</p>\n\
         <table><thead><tr>{head}</tr></thead>\n<tbody>\n",
        escaped(&words.say(&"Chosen joints".into())),
        escaped(&words.say(&"Least".into())),
        escaped(&table.least),
        escaped(&words.say(&table.sentence))
    );
    for row in &table.cells {
        let row: Vec<String> = row.iter().map(|cell| words.say(cell)).collect();
        let row = cells("td", &mut row.iter().map(String::as_str));
        out.push_str(&format!("<tr>{row}</tr>\n"));
    }
    out.push_str("</tbody></table>\n");
    out
}

/// A capacity table.
pub fn capacity(table: &Filled, words: &Words) -> String {
    let mut out = format!(
        "<h2>{}</h2>\n<p>{}: {}</p>\n",
        escaped(&table.title),
        escaped(&words.say(&table.what)),
        words.fill(
            "<b>⟦at least⟧</b> – ⟦at most⟧, <span class=\"component\">⟦component method⟧</span>"
        )
    );
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
                cell.code_fails
                    .then(|| words.fill("<span class=\"not_ok\">⟦a check fails⟧</span>")),
                cell.outcome.filter(|o| *o >= Outcome::TimedOut).map(|o| {
                    let plain = escaped(&words.say(&Text::from(o.plain())));
                    format!("<span class=\"{}\">{plain}</span>", o.word())
                }),
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
    use bracket_joint::spec::connection::Language;
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
        let page = page(("t", &Words::default()), &Counts::default(), &[], None, &[], &rows);
        assert_eq!(page.matches("\"failed\"").count(), rows.len() / 4);
        assert!(page.contains("20000 of 24000 rows"));
    }

    /// Within an outcome the most used case comes first.
    #[test]
    fn the_worst_case_comes_first() {
        let row = |case: &str, outcome: &str, used: f64| -> Map<String, Value> {
            let values = [
                ("case", json!(case)),
                ("outcome", json!(outcome)),
                ("governing_utilisation", json!(used)),
            ];
            values.into_iter().map(|(k, v)| (k.to_string(), v)).collect()
        };
        let rows = [("a", "ok", 0.5), ("b", "not_ok", 1.1), ("c", "ok", 0.9), ("d", "not_ok", 1.4)];
        let rows = rows.map(|(case, outcome, used)| row(case, outcome, used));
        let order: Vec<&Value> = worst_first(&rows, 3).into_iter().map(|r| &r["case"]).collect();
        assert_eq!(order, ["d", "b", "c"]);
    }

    /// All texts of the page are in the language of the sweep.
    #[test]
    fn a_german_page_is_german() {
        let words = Words::new(Language::De);
        let counts = Counts::default();
        let row: Map<String, Value> = [("outcome".to_string(), json!("ok"))].into_iter().collect();
        let rows = vec![row; MOST_ROWS + 1];
        let page = page(("t", &words), &counts, &["a < b".to_string()], None, &[], &rows);
        assert_eq!(words.unknown(), [""; 0]);
        for text in ["lang=\"de\"", "<h2>Fälle</h2>", "Masse über dem Lastfaktor"] {
            assert!(page.contains(text), "{text}");
        }
        assert!(!page.contains(['⟦', '⟧']));
    }

    /// Names of cases come from users' tables.
    #[test]
    fn hostile_names_stay_text() {
        let name = "</script><img src=x onerror=alert(1)>";
        let mut row = Map::new();
        row.insert("case".into(), json!(name));
        let counts = Counts::default();
        let page = page((name, &Words::default()), &counts, &[name.to_string()], None, &[], &[row]);
        assert_eq!(page.matches("<img").count(), 0, "{page}");
        assert_eq!(page.matches("</script>").count(), 2, "{page}");
    }
}
