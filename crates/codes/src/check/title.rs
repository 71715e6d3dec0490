//! The title of a check.

use super::check_id::CheckId;
use bracket_base::display_text;
use bracket_base::say;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// The title of a check: its id, and the names of the user that belong to it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "Record", into = "Record")]
pub struct Title {
    /// What is checked.
    pub id: CheckId,
    /// Names of parts of a template, which follow the title.
    pub detail: Option<Text>,
}

impl Title {
    /// The title as a report prints it.
    pub fn text(&self) -> Text {
        match &self.detail {
            Some(detail) => say!("{}: {}", self.id.title(), detail),
            None => self.id.title().into(),
        }
    }
}

display_text!(Title);

impl From<CheckId> for Title {
    fn from(id: CheckId) -> Self {
        Self { id, detail: None }
    }
}

/// How a title is written: the id and the text.
#[derive(Clone, Serialize, Deserialize)]
struct Record {
    id: CheckId,
    title: String,
}

impl From<Title> for Record {
    fn from(of: Title) -> Self {
        Self { title: of.text().to_string(), id: of.id }
    }
}

impl From<Record> for Title {
    /// The id decides. A text that does not fit it stays visible, as no title of a check has it.
    fn from(Record { id, title }: Record) -> Self {
        let rest = title.strip_prefix(id.title());
        let detail = match rest.and_then(|rest| {
            if rest.is_empty() { Some(None) } else { rest.strip_prefix(": ").map(Some) }
        }) {
            Some(None) => None,
            Some(Some(detail)) => Some(Text::given(detail)),
            None => Some(say!("the file says `{}`", title)),
        };
        Self { id, detail }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_is_read_back_and_a_false_one_is_seen() {
        let read = |id: &str, title: &str| -> Title {
            let record = serde_json::json!({"id": id, "title": title});
            serde_json::from_value(record).expect("a title")
        };
        let parts = Title { detail: Some("PLATE_2".into()), ..CheckId::NotChecked.into() };
        for title in [parts.clone(), CheckId::EndDistance.into()] {
            let text = serde_json::to_string(&title).expect("text");
            assert_eq!(serde_json::from_str::<Title>(&text).expect("a title"), title);
        }
        assert_eq!(parts.text(), "not checked: PLATE_2");
        let said = read("end_distance", "edge distance");
        assert_eq!((said.id, said.text() == "edge distance"), (CheckId::EndDistance, false));
        assert_ne!(said, CheckId::EndDistance.into());
        assert_ne!(read("not_checked", "PLATE_2"), parts);
    }

    /// No two ids have one title, so that a reader can tell them apart.
    #[test]
    fn titles_differ() {
        let mut titles: Vec<&str> = CheckId::ALL.iter().map(|id| id.title()).collect();
        titles.sort_unstable();
        let all = titles.len();
        titles.dedup();
        assert_eq!((titles.len(), all > 90), (all, true));
    }
}
