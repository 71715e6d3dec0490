//! What stands at the head and foot of every page of a printed report.

use crate::markdown::title::project_word;
use crate::result::result_file::Tool;
use crate::words::Words;
use bracket_base::say;
use serde::Serialize;

/// Size of the paper.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub enum Paper {
    /// 210 × 297 mm.
    #[default]
    #[serde(rename = "a4")]
    A4,
    /// 8.5 × 11 inches.
    #[serde(rename = "us-letter")]
    Letter,
}

/// Title block, and the properties of the document.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Head {
    /// Paper.
    pub paper: Paper,
    /// Title of the joint or of the sweep.
    pub title: String,
    /// Project number, revision, date, author and checker, on every page, as far as given.
    pub running: String,
    /// Author of the report, for the properties of the document.
    pub author: String,
    /// Date of the report as year, month, day; absent without one that can be read.
    pub date: Option<[u32; 3]>,
    /// Title block: names and values.
    pub project: Vec<(String, String)>,
    /// Language of the texts, as a code.
    pub language: &'static str,
    /// Program and version.
    pub software: String,
    /// Hash of the input; empty for a sweep, whose cases have their own.
    pub hash: String,
}

impl Head {
    /// Value of a line of the title block that is filled in by hand.
    pub const OPEN: &str = "–";

    /// The head of a report; `project` are the lines of the title block behind the title.
    pub fn new(
        paper: Paper,
        title: String,
        project: Vec<(String, String)>,
        words: &Words,
        tool: &Tool,
        hash: String,
    ) -> Self {
        let value = |name: &str| {
            project.iter().find(|(n, v)| n == name && v != Self::OPEN).map(|(_, v)| v.as_str())
        };
        let revision = value("revision").map(|r| words.say(&say!("revision {}", r.to_owned())));
        let by = [value("author"), value("checker")].into_iter().flatten().collect::<Vec<_>>();
        let by = Some(by.join(" / ")).filter(|names| !names.is_empty());
        let running =
            [value("number").map(String::from), revision, value("date").map(String::from), by];
        Self {
            paper,
            title,
            running: running.into_iter().flatten().collect::<Vec<_>>().join(", "),
            author: value("author").unwrap_or_default().into(),
            date: value("date").and_then(date),
            software: format!("{} {}", tool.name, tool.version),
            hash,
            language: words.code(),
            project: project.into_iter().map(|(n, v)| (label(&n, words), v)).collect(),
        }
    }
}

/// Name of a line of the title block.
fn label(name: &str, words: &Words) -> String {
    words.say(&project_word(name))
}

/// Year, month and day of `2026-11-23` or `23.11.2026`.
fn date(text: &str) -> Option<[u32; 3]> {
    let numbers = |by: char| -> Option<Vec<u32>> {
        text.trim().split(by).map(|part| part.parse().ok()).collect()
    };
    let (year, month, day) = match (numbers('-').as_deref(), numbers('.').as_deref()) {
        (Some(&[y, m, d]), _) | (_, Some(&[d, m, y])) => (y, m, d),
        _ => return None,
    };
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let days = match month {
        2 if leap => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => 0,
    };
    ((1000..=9999).contains(&year) && (1..=days).contains(&day)).then_some([year, month, day])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_of_a_spec_are_read_or_left_out() {
        for (text, want) in [
            ("2026-11-23", Some([2026, 11, 23])),
            ("23.11.2026", Some([2026, 11, 23])),
            ("29.02.2028", Some([2028, 2, 29])),
            ("29.02.2026", None),
            ("2026-13-01", None),
            ("2026-00-10", None),
            ("11/23/2026", None),
            ("May 2026", None),
            ("", None),
        ] {
            assert_eq!(date(text), want, "{text}");
        }
    }
}
