//! Text of the Markdown report as blocks of plain data, which a layout can set without reading
//! Markdown.

use super::formula::{Piece, pieces};
use crate::words::Words;
use pulldown_cmark::{Alignment, Event, HeadingLevel, Options, Parser, Tag, TagEnd};
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

/// Text with styles.
pub type Text = Vec<Span>;

/// A table with styled cells.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Grid {
    /// Titles.
    pub columns: Vec<Text>,
    /// True for columns of numbers, which are set to the right.
    pub right: Vec<bool>,
    /// Rows, as long as `columns`.
    pub rows: Vec<Vec<Text>>,
}

/// An element of a section.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Block {
    /// A heading.
    Heading {
        /// 1 for sections of the report, 2 below.
        level: u8,
        /// Its text.
        text: Text,
    },
    /// A paragraph.
    Paragraph {
        /// Its text.
        text: Text,
    },
    /// A list, an item a line.
    List {
        /// Its items.
        items: Vec<Text>,
    },
    /// A table.
    Table {
        /// Its cells.
        table: Grid,
    },
    /// Text as given: the input.
    Code {
        /// Its lines.
        text: String,
    },
}

/// A plain text.
pub fn plain(text: impl Into<String>) -> Text {
    vec![Span { text: text.into(), pieces: Vec::new(), bold: false, code: false }]
}

/// A sentence: text in which `M_j,Rd` is a symbol with its subscript, and words between backquotes
/// are code.
pub fn sentence(text: &str) -> Text {
    // between a pair of marks stands code
    let paired = text.matches('`').count().is_multiple_of(2);
    let parts = text.split(|c| c == '`' && paired).enumerate();
    let span = |(i, part): (usize, &str)| Span {
        text: part.into(),
        pieces: Vec::new(),
        bold: false,
        code: i % 2 == 1,
    };
    with_symbols(parts.filter(|p| !p.1.is_empty()).map(span).collect())
}

fn with_symbols(mut text: Text) -> Text {
    for span in text.iter_mut().filter(|s| !s.code) {
        let found = pieces(&span.text);
        if found.iter().any(|p| p.symbol) {
            span.pieces = found;
        }
    }
    text
}

/// The blocks of a text in Markdown. Pictures and links are left out: the layout places the
/// pictures of the result itself.
pub fn blocks(markdown: &str) -> Vec<Block> {
    let mut out = Vec::new();
    let mut text = Text::new();
    let (mut bold, mut in_picture, mut in_item) = (0u32, 0u32, 0u32);
    let mut items = Vec::new();
    let mut grid = Grid::default();
    let mut row = Vec::new();
    let mut code: Option<String> = None;
    let push = |text: &mut Text, words: &str, bold: bool, code: bool| match text.last_mut() {
        Some(last) if (last.bold, last.code) == (bold, code) => last.text.push_str(words),
        _ => text.push(Span { text: words.into(), pieces: Vec::new(), bold, code }),
    };
    for event in Parser::new_ext(markdown, Options::ENABLE_TABLES) {
        match event {
            Event::Start(Tag::Image { .. }) => in_picture += 1,
            Event::End(TagEnd::Image) => in_picture -= 1,
            _ if in_picture > 0 => {}
            Event::Text(t) if code.is_some() => code.get_or_insert_default().push_str(&t),
            Event::Text(t) | Event::Html(t) | Event::InlineHtml(t) => {
                push(&mut text, &t, bold > 0, false);
            }
            Event::Code(t) => push(&mut text, &t, bold > 0, true),
            Event::SoftBreak | Event::HardBreak => push(&mut text, " ", bold > 0, false),
            Event::Start(Tag::Strong) => bold += 1,
            Event::End(TagEnd::Strong) => bold -= 1,
            Event::Start(Tag::CodeBlock(_)) => code = Some(String::new()),
            Event::End(TagEnd::CodeBlock) => {
                out.push(Block::Code { text: code.take().unwrap_or_default() });
            }
            Event::End(TagEnd::Heading(level)) => {
                let level = if level == HeadingLevel::H2 { 1 } else { 2 };
                out.push(Block::Heading { level, text: std::mem::take(&mut text) });
            }
            Event::Start(Tag::Item) => in_item += 1,
            Event::End(TagEnd::Item) => {
                in_item -= 1;
                items.push(with_symbols(std::mem::take(&mut text)));
            }
            Event::End(TagEnd::List(_)) => {
                out.push(Block::List { items: std::mem::take(&mut items) });
            }
            Event::End(TagEnd::Paragraph) if in_item == 0 && !text.is_empty() => {
                out.push(Block::Paragraph { text: with_symbols(std::mem::take(&mut text)) });
            }
            Event::Start(Tag::Table(alignments)) => {
                let right = alignments.iter().map(|a| *a == Alignment::Right).collect();
                grid = Grid { right, ..Grid::default() };
            }
            Event::End(TagEnd::TableCell) => row.push(std::mem::take(&mut text)),
            Event::End(TagEnd::TableHead) => grid.columns = std::mem::take(&mut row),
            Event::End(TagEnd::TableRow) => grid.rows.push(std::mem::take(&mut row)),
            Event::End(TagEnd::Table) => {
                out.push(Block::Table { table: std::mem::take(&mut grid) });
            }
            _ => {}
        }
    }
    out
}

/// The blocks of a section of the Markdown report, in the language of `words`.
pub fn section(words: &Words, write: impl FnOnce(&mut String)) -> Vec<Block> {
    let mut page = String::new();
    write(&mut page);
    blocks(&words.markdown(&page))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_become_blocks_and_nothing_is_run() {
        let found = blocks(
            "## A & B\n\nThe factor is **1.2** of `x`.\n\n- one\n- two\n\n| a | b |\n| --- | \
             ---: |\n| **c** | 1 &lt; 2 |\n\n![p](p.png)\n\n```yaml\nt: \
             \"#eval\"\n```\n\n<script>x</script>\n",
        );
        let span =
            |text: &str, bold, code| Span { text: text.into(), pieces: Vec::new(), bold, code };
        let want = [
            Block::Heading { level: 1, text: plain("A & B") },
            Block::Paragraph {
                text: vec![
                    span("The factor is ", false, false),
                    span("1.2", true, false),
                    span(" of ", false, false),
                    span("x", false, true),
                    span(".", false, false),
                ],
            },
            Block::List { items: vec![plain("one"), plain("two")] },
            Block::Table {
                table: Grid {
                    columns: vec![plain("a"), plain("b")],
                    right: vec![false, true],
                    rows: vec![vec![vec![span("c", true, false)], plain("1 < 2")]],
                },
            },
            Block::Code { text: "t: \"#eval\"\n".into() },
        ];
        assert_eq!(found[..5], want);
    }
}
