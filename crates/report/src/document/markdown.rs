//! The writer of Markdown: blocks, and text that is safe inside them.

use super::block::{Block, Grid, Span};

/// The text of blocks in Markdown.
pub fn markdown(blocks: &[Block]) -> String {
    let mut page = String::new();
    for block in blocks {
        match block {
            Block::Heading { level, text } => {
                page.push_str(&format!("{} {}\n", "#".repeat(usize::from(*level) + 1), line(text)));
            }
            Block::Paragraph { text } => page.push_str(&format!("{}\n", line(text))),
            Block::List { items } => {
                items.iter().for_each(|text| page.push_str(&format!("- {}\n", line(text))));
            }
            Block::Table { table } => write_table(&mut page, table),
            Block::Code { text } => fenced(&mut page, text),
            Block::Picture { caption, file } => {
                page.push_str(&format!("![{}]({file})\n", line(caption)));
            }
        }
        page.push('\n');
    }
    page.truncate(page.trim_end().len());
    page.push('\n');
    page
}

fn fenced(page: &mut String, text: &str) {
    // the input cannot close a fence that is longer than any run of backticks in it
    let mut longest = 2;
    let mut run = 0;
    for c in text.chars() {
        run = if c == '`' { run + 1 } else { 0 };
        longest = longest.max(run);
    }
    let fence = "`".repeat(longest + 1);
    page.push_str(&format!("{fence}yaml\n{}\n{fence}\n", text.trim_end()));
}

/// Spans on one line. Only code has backticks of its own.
fn line(text: &[Span]) -> String {
    let mut out = String::new();
    for span in text {
        match (span.bold, span.code) {
            (true, _) => out.push_str(&format!("{BOLD}{}{BOLD}", ticks(&span.text))),
            (_, true) => out.push_str(&format!("`{}`", span.text.replace('`', "'"))),
            _ => out.push_str(&ticks(&span.text)),
        }
    }
    inline(&out)
}

/// A text whose backticks make no code.
fn ticks(text: &str) -> String {
    text.replace('`', &TICK.to_string())
}

fn write_table(page: &mut String, table: &Grid) {
    let row = |cells: &[Vec<Span>]| {
        format!("| {} |\n", cells.iter().map(|c| line(c)).collect::<Vec<_>>().join(" | "))
    };
    page.push_str(&row(&table.columns));
    let rule = table.right.iter().map(|right| if *right { "---:" } else { "---" });
    page.push_str(&format!("| {} |\n", rule.collect::<Vec<_>>().join(" | ")));
    table.rows.iter().for_each(|r| page.push_str(&row(r)));
}

/// Escapes a text so that it remains within its line or cell, and becomes no link, no picture, no
/// emphasis and no element of HTML. Code in backticks stays code.
pub fn inline(text: &str) -> String {
    let chars: Vec<char> = text.trim_start().chars().collect();
    // a backtick without its partner would make code of what follows
    let odd_ticks = chars.iter().filter(|c| **c == '`').count() % 2 == 1;
    let mut out = String::with_capacity(text.len());
    for (i, &c) in chars.iter().enumerate() {
        let before = i.checked_sub(1).map(|k| chars[k]);
        let after = chars.get(i + 1).copied();
        let is = |c: Option<char>, of: &str| c.is_some_and(|c| of.contains(c));
        let word = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
        let gap = |c: Option<char>| c.is_none_or(char::is_whitespace);
        let escaped = match c {
            '\n' | '\r' | '\u{2028}' | '\u{2029}' => {
                out.push(' ');
                continue;
            }
            '<' => {
                out.push_str("&lt;");
                continue;
            }
            // `&#42;` would be a character
            '&' if is(after, "#") || word(after) => {
                out.push_str("&amp;");
                continue;
            }
            '\\' | '|' => true,
            // links, pictures and definitions of links
            '(' | ':' => is(before, "]"),
            '[' => is(before, "]!"),
            // addresses become links without any mark
            '/' => is(before, ":") && is(after, "/"),
            '.' => i >= 3 && chars[i - 3..i].iter().all(|c| c.eq_ignore_ascii_case(&'w')),
            '*' => !(gap(before) && gap(after)),
            '_' => !(word(before) && word(after)),
            '~' => is(before, "~") || is(after, "~"),
            BOLD => {
                out.push_str("**");
                continue;
            }
            '`' => odd_ticks,
            TICK => {
                out.push_str("\\`");
                continue;
            }
            // the begin of a heading, a quotation or a list
            '#' | '>' => i == 0,
            '-' | '+' => i == 0 && gap(after),
            _ => false,
        };
        if escaped {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

/// Around words that the program sets bold. Unlike `**`, no text of a user looks like it.
const BOLD: char = '\u{e000}';

/// In place of a backtick of the user.
const TICK: char = '\u{e001}';

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_of_the_user_stay_text() {
        for (text, shown) in [
            ("[c](javascript:x)", "[c]\\(javascript:x)"),
            ("![i](http://e/x.png)", "!\\[i]\\(http:\\//e/x.png)"),
            ("[c][d] [d]: x", "[c]\\[d] [d]\\: x"),
            ("see https://e.x or www.e.x", "see https:\\//e.x or www\\.e.x"),
            (
                "**b** *i* _i_ __b__ ~~s~~",
                "\\*\\*b\\*\\* \\*i\\* \\_i\\_ \\_\\_b\\_\\_ \\~\\~s\\~\\~",
            ),
            ("a|b\\|c\nd", "a\\|b\\\\\\|c d"),
            ("<b> &#42; &lt; a & b", "&lt;b> &amp;#42; &amp;lt; a & b"),
            ("`code` `a", "\\`code\\` \\`a"),
            ("# head", "\\# head"),
            ("- list", "\\- list"),
        ] {
            assert_eq!(inline(text), shown);
        }
        assert_eq!(inline(&format!("a {BOLD}1|2{BOLD} *b*")), "a **1\\|2** \\*b\\*");
        // texts of the program have these marks and stay as they are
        for text in ["F_t,Rd = 2 * γ_M2 [mm]", "`max_passes` of 3", "-43.2 kN m", "~ 3: 4/5 (EN)"]
        {
            assert_eq!(inline(text), text);
        }
    }
}
