//! The sections of the page, from the sheet.

use super::base64::base64;
use crate::document::block::{Block, Grid, Span, Spans};
use crate::document::symbols::Piece;
use crate::escaped::escaped;
use crate::sheet::{Bar, Picture, Section, Sheet, TopicSheet, VerdictBox};
use crate::summary::Tone;
use crate::words::Words;
use bracket_base::say;
use std::fmt::Write as _;

/// The page while it is written.
pub struct Content<'a> {
    body: String,
    contents: String,
    sections: usize,
    words: &'a Words,
    picture: &'a dyn Fn(&str) -> Option<Vec<u8>>,
}

impl<'a> Content<'a> {
    /// An empty page in the language of `words` that takes its pictures from `picture`.
    pub fn new(words: &'a Words, picture: &'a dyn Fn(&str) -> Option<Vec<u8>>) -> Self {
        Self { body: String::new(), contents: String::new(), sections: 0, words, picture }
    }

    /// The body and the list of its sections.
    pub fn finish(self) -> (String, String) {
        (self.body, self.contents)
    }

    /// All sections, in the order of the printed report. `viewer` is the 3-D view.
    pub fn report(&mut self, sheet: &Sheet, viewer: Option<String>) {
        self.title(sheet);
        self.verdict(&sheet.verdict);
        let signs = |p: &&Picture| p.file.starts_with("actions");
        self.titled("Joint", |c| {
            sheet.drawings.iter().filter(|p| !signs(p)).for_each(|p| c.figure(p));
        });
        if let Some(viewer) = viewer {
            self.titled("3-D view", |c| c.body.push_str(&viewer));
        }
        if !sheet.actions.rows.is_empty() {
            self.titled("Actions", |c| {
                sheet.drawings.iter().filter(signs).for_each(|p| c.figure(p));
                c.grid(&sheet.actions);
                if !sheet.plane_actions.rows.is_empty() {
                    c.line("p", "", &pieces(&sheet.plane_note));
                    c.grid(&sheet.plane_actions);
                }
            });
        }
        if !sheet.load_cases.rows.is_empty() {
            self.titled("Load cases", |c| {
                c.line("p", "", &pieces(&sheet.load_cases_note));
                let filter = escaped(&c.words.say(&"filter".into()));
                let _ = writeln!(
                    c.body,
                    "<div class=\"cases\"><input type=\"search\" placeholder=\"{filter}\" \
                     aria-label=\"{filter}\" hidden>"
                );
                c.grid(&sheet.load_cases);
                c.body.push_str("</div>\n");
            });
        }
        if !sheet.summary.is_empty() {
            self.titled("Checks", |c| c.summary(sheet));
        }
        if !sheet.answers.is_empty() {
            self.titled("Analysis", |c| {
                for answer in &sheet.answers {
                    c.line("h3", "", &escaped(&answer.name));
                    answer.bar.iter().for_each(|bar| c.bar(bar));
                    answer.blocks.iter().for_each(|b| c.block(b));
                }
            });
        }
        if !sheet.pictures.is_empty() {
            self.titled("Pictures", |c| sheet.pictures.iter().for_each(|p| c.figure(p)));
        }
        self.further(&sheet.analysis);
        if !sheet.topics.is_empty() {
            self.titled("Checks with their numbers", |c| {
                sheet.topics.iter().for_each(|t| c.topic(t));
            });
        }
        self.further(&sheet.method);
        if !sheet.schedule.rows.is_empty() {
            self.titled("Bolts, plates and stiffeners", |c| c.grid(&sheet.schedule));
        }
        if !sheet.welds.rows.is_empty() {
            self.titled("Welds", |c| c.grid(&sheet.welds));
        }
        if !sheet.supports.rows.is_empty() {
            self.titled("Supports", |c| c.grid(&sheet.supports));
        }
        if !sheet.design_values.is_empty() {
            self.titled("Partial factors and strengths", |c| c.design_values(sheet));
        }
        self.list("Warnings", &sheet.warnings);
        self.list("Assumptions and limits", &sheet.assumptions);
        self.further(&sheet.sections);
        let (hash, input) = (escaped(&sheet.head.hash), self.words.say(&"input".into()));
        self.line("footer", "", &format!("{} · {input} {hash}", escaped(&sheet.head.software)));
    }

    /// Sections of the full report.
    fn further(&mut self, sections: &[Section]) {
        for section in sections {
            self.section(&section.title, |c| section.blocks.iter().for_each(|b| c.block(b)));
        }
    }

    fn title(&mut self, sheet: &Sheet) {
        let title = escaped(&sheet.head.title);
        let _ = write!(self.body, "<header>\n<h1 dir=\"auto\">{title}</h1>\n");
        if !sheet.head.project.is_empty() {
            self.body.push_str("<dl class=\"project\">\n");
            for (name, value) in &sheet.head.project {
                let (name, value) = (escaped(name), escaped(value));
                let _ =
                    writeln!(self.body, "<div><dt>{name}</dt><dd dir=\"auto\">{value}</dd></div>");
            }
            self.body.push_str("</dl>\n");
        }
        self.body.push_str("</header>\n");
    }

    fn verdict(&mut self, verdict: &VerdictBox) {
        let _ = write!(
            self.body,
            "<section class=\"verdict {}\" aria-label=\"{}\">\n<strong \
             class=\"word\">{}</strong><p>{}</p>\n",
            tone(verdict.tone),
            escaped(&self.words.say(&"verdict".into())),
            escaped(&verdict.word),
            pieces(&verdict.reason)
        );
        if !verdict.parts.is_empty() {
            self.body.push_str("<ul>\n");
            for (name, word, t, on) in &verdict.parts {
                let (name, word, on) = (escaped(name), escaped(word), spans(on));
                let _ = writeln!(
                    self.body,
                    "<li>{name}: <strong class=\"{}\">{word}</strong> <span \
                     class=\"quiet\">{on}</span></li>",
                    tone(*t)
                );
            }
            self.body.push_str("</ul>\n");
        }
        if !verdict.next.is_empty() {
            let _ = writeln!(self.body, "<p>{}</p>", spans(&verdict.next));
        }
        self.body.push_str("</section>\n");
    }

    /// A section with a title of the program.
    fn titled(&mut self, title: &'static str, write: impl FnOnce(&mut Self)) {
        let title = self.words.say(&title.into());
        self.section(&title, write);
    }

    /// A section that can be closed; without content there is none.
    fn section(&mut self, title: &str, write: impl FnOnce(&mut Self)) {
        let before = self.body.len();
        let (id, title) = (self.sections + 1, escaped(title));
        let _ = write!(
            self.body,
            "<section id=\"s{id}\"><details open>\n<summary><h2>{title}</h2></summary>\n"
        );
        let empty = self.body.len();
        write(self);
        if self.body.len() == empty {
            self.body.truncate(before);
            return;
        }
        self.sections = id;
        self.body.push_str("</details></section>\n");
        let _ = writeln!(self.contents, "<li><a href=\"#s{id}\">{title}</a></li>");
    }

    fn line(&mut self, element: &str, class: &str, html: &str) {
        let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
        let _ = writeln!(self.body, "<{element}{class}>{html}</{element}>");
    }

    fn figure(&mut self, picture: &Picture) {
        let Some(bytes) = (self.picture)(&picture.file) else { return };
        let kind = if picture.file.ends_with(".svg") { "svg+xml" } else { "png" };
        let caption = escaped(&picture.caption);
        let _ = writeln!(
            self.body,
            "<figure><img src=\"data:image/{kind};base64,{}\" \
             alt=\"{caption}\"><figcaption>{caption}</figcaption></figure>",
            base64(&bytes)
        );
    }

    fn list(&mut self, title: &'static str, items: &[Spans]) {
        if !items.is_empty() {
            self.titled(title, |c| c.block(&Block::List { items: items.to_vec() }));
        }
    }

    fn block(&mut self, block: &Block) {
        match block {
            Block::Heading { text, .. } => self.line("h3", "", &spans(text)),
            Block::Paragraph { text } => self.line("p", "", &spans(text)),
            Block::List { items } => {
                self.body.push_str("<ul>\n");
                items.iter().for_each(|i| self.line("li", "", &spans(i)));
                self.body.push_str("</ul>\n");
            }
            Block::Table { table } => self.grid(table),
            Block::Code { text } => self.line("pre", "", &escaped(text)),
            // the page places the pictures itself
            Block::Picture { .. } => {}
        }
    }

    fn grid(&mut self, grid: &Grid) {
        let right = |c: usize| grid.right.get(c).copied().unwrap_or(false);
        let head: Vec<(String, bool)> =
            grid.columns.iter().enumerate().map(|(c, t)| (spans(t), right(c))).collect();
        let row = |r: &Vec<Spans>| {
            (false, r.iter().enumerate().map(|(c, t)| (spans(t), right(c))).collect())
        };
        self.table(&head, grid.rows.iter().map(row));
    }

    /// A table: cells as HTML with `true` for numbers, rows with `true` where they govern.
    fn table(
        &mut self,
        head: &[(String, bool)],
        rows: impl Iterator<Item = (bool, Vec<(String, bool)>)>,
    ) {
        let class = |right: bool| if right { " class=\"right\"" } else { "" };
        self.body.push_str("<div class=\"table\"><table>\n<thead><tr>");
        for (title, right) in head {
            let _ = write!(self.body, "<th scope=\"col\"{}>{title}</th>", class(*right));
        }
        self.body.push_str("</tr></thead>\n<tbody>\n");
        for (governs, cells) in rows {
            self.body.push_str(if governs { "<tr class=\"governs\">" } else { "<tr>" });
            for (cell, right) in cells {
                let _ = write!(self.body, "<td{}>{cell}</td>", class(right));
            }
            self.body.push_str("</tr>\n");
        }
        self.body.push_str("</tbody></table></div>\n");
    }

    fn summary(&mut self, sheet: &Sheet) {
        let titles = [
            ("case", false),
            ("check", false),
            ("required", true),
            ("provided", true),
            ("utilisation", true),
            ("clause", false),
            ("status", false),
        ];
        let head = titles.map(|(t, right)| (escaped(&self.words.say(&t.into())), right));
        let rows = sheet.summary.iter().map(|line| {
            let row = line;
            let cells = vec![
                (escaped(&row.case), false),
                (pieces(&line.what), false),
                (escaped(&row.demand), true),
                (escaped(&row.resistance), true),
                (escaped(&row.utilisation), true),
                (escaped(&row.clause), false),
                (judged(&row.status, row.tone), false),
            ];
            (row.governs, cells)
        });
        self.table(&head, rows);
    }

    fn design_values(&mut self, sheet: &Sheet) {
        let head =
            ["symbol", "of", "value"].map(|t| (escaped(&self.words.say(&t.into())), t == "value"));
        let rows = sheet.design_values.iter().map(|(symbol, of, value)| {
            (false, vec![(pieces(symbol), false), (escaped(of), false), (escaped(value), true)])
        });
        self.table(&head, rows);
    }

    fn topic(&mut self, topic: &TopicSheet) {
        self.line("h3", "", &escaped(&topic.title));
        self.line("p", "", &pieces(&topic.words));
        let titles = ["case, part", "check", "clause", "utilisation", "status"];
        let head = titles.map(|t| (escaped(&self.words.say(&t.into())), t == "utilisation"));
        let rows = topic.rows.iter().map(|row| {
            let values: Vec<String> =
                row.values.iter().map(|v| format!("<span>{}</span>", pieces(v))).collect();
            let check = format!(
                "<strong>{}</strong><br>{}<div class=\"values\">{}</div>",
                pieces(&row.check),
                pieces(&row.formula),
                values.concat()
            );
            let cells = vec![
                (escaped(&row.of), false),
                (check, false),
                (escaped(&row.clause), false),
                (escaped(&row.utilisation), true),
                (judged(&row.status, row.tone), false),
            ];
            (false, cells)
        });
        self.table(&head, rows);
    }

    /// The bracket on an axis of load factors.
    fn bar(&mut self, bar: &Bar) {
        let known = [Some(bar.low), bar.up, bar.method, Some(1.0)];
        let most = 1.15 * known.into_iter().flatten().fold(0.0, f64::max);
        let at = |x: f64| 10.0 + 620.0 * x / most;
        let end = bar.up.map_or(630.0, at);
        let mut marks = String::new();
        let mut mark = |x: f64, y: f64, colour: &str, text: String| {
            let x = at(x);
            let _ = write!(
                marks,
                "<line x1=\"{x:.1}\" x2=\"{x:.1}\" y1=\"22\" y2=\"58\" stroke=\"{colour}\" \
                 stroke-width=\"2\"/><text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\" \
                 fill=\"{colour}\">{text}</text>"
            );
        };
        let (mut said, labels, words) = (Vec::new(), &bar.labels, self.words);
        if let Some(low) = &labels.low {
            said.push(words.say(&say!("at least {}", low)));
            mark(bar.low, 74.0, "var(--accent)", format!("≥ {low}"));
        }
        if let (Some(x), Some(up)) = (bar.up, &labels.up) {
            said.push(words.say(&say!("at most {}", up)));
            mark(x, 90.0, "var(--accent)", format!("≤ {up}"));
        }
        let demand = escaped(&words.say(&"demand 1".into()));
        mark(1.0, 14.0, "var(--bad)", demand.clone());
        if let (Some(x), Some(method)) = (bar.method, &labels.method) {
            let method = words.say(&say!("component method {}", method));
            mark(x, 106.0, "var(--open)", escaped(&method));
            said.push(method);
        }
        let (from, said) = (at(bar.low), escaped(&said.join(", ")));
        let what = escaped(&words.say(&"load factor".into()));
        let _ = writeln!(
            self.body,
            "<svg class=\"bounds\" viewBox=\"0 0 640 112\" role=\"img\" aria-label=\"{what}: \
             {said}; {demand}\" font-size=\"13\"><line x1=\"10\" x2=\"630\" y1=\"40\" y2=\"40\" \
             stroke=\"currentColor\"/><rect x=\"{from:.1}\" width=\"{:.1}\" y=\"30\" \
             height=\"20\" fill=\"var(--accent)\" opacity=\"0.4\"/>{marks}</svg>",
            end - from
        );
    }
}

fn tone(tone: Tone) -> &'static str {
    match tone {
        Tone::Good => "good",
        Tone::Bad => "bad",
        Tone::Open => "open",
        Tone::Quiet => "quiet",
    }
}

fn judged(word: &str, t: Tone) -> String {
    format!("<strong class=\"{}\">{}</strong>", tone(t), escaped(word))
}

/// Text with symbols and fractions, as HTML.
fn pieces(pieces: &[Piece]) -> String {
    let one = |p: &Piece| match (p.top.is_empty(), p.symbol, p.below.is_empty()) {
        (false, ..) => format!("<math>{}</math>", math(std::slice::from_ref(p))),
        (_, false, _) => escaped(&p.text),
        (_, true, true) => format!("<i>{}</i>", escaped(&p.text)),
        _ => format!("<i>{}</i><sub>{}</sub>", escaped(&p.text), escaped(&p.below)),
    };
    pieces.iter().map(one).collect()
}

/// The same in MathML.
fn math(pieces: &[Piece]) -> String {
    let one = |p: &Piece| match (p.top.is_empty(), p.symbol) {
        (false, _) => format!(
            "<mfrac displaystyle=\"true\"><mrow>{}</mrow><mrow>{}</mrow></mfrac>",
            math(&p.top),
            math(&p.bottom)
        ),
        // blanks at the ends of `mtext` would be lost
        (_, false) => format!("<mtext>{}</mtext>", escaped(&p.text.replace(' ', "\u{a0}"))),
        (_, true) if p.below.is_empty() => format!("<mi>{}</mi>", escaped(&p.text)),
        _ => format!(
            "<msub><mi>{}</mi><mtext>{}</mtext></msub>",
            escaped(&p.text),
            escaped(&p.below)
        ),
    };
    pieces.iter().map(one).collect()
}

fn spans(text: &Spans) -> String {
    let one = |s: &Span| {
        let inner = if s.pieces.is_empty() { escaped(&s.text) } else { pieces(&s.pieces) };
        match (s.code, s.bold) {
            (true, _) => format!("<code>{inner}</code>"),
            (false, true) => format!("<strong>{inner}</strong>"),
            (false, false) => inner,
        }
    };
    text.iter().map(one).collect()
}
