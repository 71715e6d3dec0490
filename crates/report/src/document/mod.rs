//! Documents: texts and tables become blocks in the language of the reader, and three writers set
//! the same blocks: Markdown, HTML ([`crate::page`]) and typst ([`crate::pdf`]).

pub mod block;
pub mod markdown;
pub mod picture;
pub mod symbols;
pub mod table;

use crate::words::Words;
use block::{Block, Grid, Span, Spans};
use bracket_base::words::Text;
use picture::PictureRef;
use symbols::pieces;
use table::Table;

/// A document that is being written in a language.
pub struct Doc<'w> {
    words: &'w Words,
    /// Its elements.
    pub blocks: Vec<Block>,
}

impl<'w> Doc<'w> {
    /// An empty document.
    pub fn new(words: &'w Words) -> Self {
        Self { words, blocks: Vec::new() }
    }

    /// Adds the title of the document.
    pub fn title(&mut self, text: impl Into<Text>) {
        self.blocks.push(Block::Heading { level: 0, text: unstyled(self.words, &text.into()) });
    }

    /// Adds the heading of a section.
    pub fn heading(&mut self, text: impl Into<Text>) {
        self.blocks.push(Block::Heading { level: 1, text: unstyled(self.words, &text.into()) });
    }

    /// Adds a paragraph.
    pub fn paragraph(&mut self, text: impl Into<Text>) {
        self.blocks.push(Block::Paragraph { text: spans(self.words, &text.into()) });
    }

    /// Adds a list.
    pub fn list(&mut self, items: impl IntoIterator<Item = impl Into<Text>>) {
        let items = items.into_iter().map(|t| spans(self.words, &t.into())).collect();
        self.blocks.push(Block::List { items });
    }

    /// Adds a table.
    pub fn table(&mut self, table: &Table) {
        self.blocks.push(Block::Table { table: grid(self.words, table) });
    }

    /// Adds a text as given.
    pub fn code(&mut self, text: &str) {
        self.blocks.push(Block::Code { text: text.into() });
    }

    /// Adds a picture; of a drawing the one in the language of the document.
    pub fn picture(&mut self, picture: &PictureRef) {
        let file = self.words.file(&picture.file).unwrap_or_else(|| picture.file.clone());
        let caption = unstyled(self.words, &picture.caption);
        self.blocks.push(Block::Picture { caption, file });
    }
}

/// A text with its styles and symbols. In a message `**bold**` and words between backquotes are
/// styled; what is given has no marks. `M_j,Rd` is a symbol with its subscript.
pub fn spans(words: &Words, text: &Text) -> Spans {
    let mut out = unstyled(words, text);
    for span in out.iter_mut().filter(|s| !s.code) {
        let found = pieces(&span.text);
        if found.iter().any(|p| p.symbol) {
            span.pieces = found;
        }
    }
    out
}

/// A text with its styles.
fn unstyled(words: &Words, text: &Text) -> Spans {
    let mut out = Spans::new();
    let (mut bold, mut code) = (false, false);
    let mut push = |text: &str, bold, code| match out.last_mut() {
        _ if text.is_empty() => {}
        Some(last) if (last.bold, last.code) == (bold, code) => last.text.push_str(text),
        _ => out.push(Span { bold, code, ..Span::plain(text) }),
    };
    for (part, given) in text.parts(words) {
        if given {
            push(&part, bold, code);
            continue;
        }
        for (i, between) in part.split('`').enumerate() {
            code ^= i > 0;
            if code {
                push(between, bold, true);
                continue;
            }
            for (i, run) in between.split("**").enumerate() {
                bold ^= i > 0;
                push(run, bold, false);
            }
        }
    }
    out
}

/// A table in the language of the reader. Columns of numbers are set to the right.
pub fn grid(words: &Words, table: &Table) -> Grid {
    let number = |c: usize| {
        let mut cells = table.rows.iter().filter_map(|r| r.get(c)).map(|text| words.say(text));
        cells.all(|t| {
            let t = t.trim_start_matches(['*', '(']);
            t.is_empty() || t.starts_with(|l: char| l.is_ascii_digit() || "-−<–".contains(l))
        })
    };
    let row = |cells: &Vec<Text>| cells.iter().map(|c| unstyled(words, c)).collect();
    Grid {
        columns: table.columns.iter().map(|c| unstyled(words, c)).collect(),
        right: (0..table.columns.len()).map(number).collect(),
        rows: table.rows.iter().map(row).collect(),
    }
}

/// The blocks of a section.
pub fn section(words: &Words, write: impl FnOnce(&mut Doc)) -> Vec<Block> {
    let mut doc = Doc::new(words);
    write(&mut doc);
    doc.blocks
}

/// A section in English Markdown.
#[cfg(test)]
pub(crate) fn english(write: impl FnOnce(&mut Doc)) -> String {
    markdown::markdown(&section(&Words::default(), write))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_base::say;
    use table::cells;

    /// Marks of a message style it, those of a name are letters; nothing of either is run.
    #[test]
    fn messages_have_styles_and_names_have_none() {
        let hostile = "**a** `b` <script>[x](y)|z";
        let page = english(|doc| {
            doc.title(Text::given(hostile));
            doc.heading("Answer");
            doc.paragraph(say!(
                "**{}** of `{}`, F_t,Rd: {}",
                hostile.to_owned(),
                hostile.to_owned(),
                2
            ));
            doc.list([Text::from("one"), say!("{} mm", 3)]);
            let rows = vec![cells!["a", "1"], cells![hostile.to_owned(), "−2.5"]];
            doc.table(&Table { columns: Table::columns(["what", "size"]), rows });
            doc.code("a: ```");
        });
        let name = "\\*\\*a\\*\\* \\`b\\` &lt;script>[x]\\(y)\\|z";
        let code = "`\\*\\*a\\*\\* 'b' &lt;script>[x]\\(y)\\|z`";
        assert_eq!(
            page,
            format!(
                "# {name}\n\n## Answer\n\n**{name}** of {code}, F_t,Rd: 2\n\n- one\n- 3 mm\n\n\
                 | what | size |\n| --- | ---: |\n| a | 1 |\n| {name} | −2.5 |\n\n\
                 ````yaml\na: ```\n````\n"
            )
        );
        let spans = spans(&Words::default(), &say!("**{}**, M_j,Rd", hostile.to_owned()));
        let styles: Vec<(&str, bool)> = spans.iter().map(|s| (s.text.as_str(), s.bold)).collect();
        assert_eq!(styles, [(hostile, true), (", M_j,Rd", false)]);
        assert!(spans[1].pieces.iter().any(|p| p.symbol && p.below == "j,Rd"));
    }
}
