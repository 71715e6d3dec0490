//! Markdown elements: headings, paragraphs, tables, and text that is safe inside them.

use crate::markdown::report_data::Table;

/// The text of a cell without a value.
pub(crate) fn dash() -> String {
    "–".into()
}

pub(crate) fn heading(page: &mut String, text: &str) {
    page.push_str(&format!("## {text}\n\n"));
}

pub(crate) fn paragraph(page: &mut String, text: &str) {
    page.push_str(text);
    page.push_str("\n\n");
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

/// Around words that the program sets bold. Unlike `**`, no text of a user looks like it, so that
/// [`inline`] can write it as Markdown.
const BOLD: char = '\u{e000}';

/// Bold words within a text for [`inline`] or a cell of a table.
pub(crate) fn bold(text: &str) -> String {
    format!("{BOLD}{text}{BOLD}")
}

pub(crate) fn table(page: &mut String, table: &Table) {
    let row = |cells: &[String]| {
        format!("| {} |\n", cells.iter().map(|c| inline(c)).collect::<Vec<_>>().join(" | "))
    };
    page.push_str(&row(&table.columns));
    let number = |c: usize| {
        table.rows.iter().all(|r| {
            r.get(c).is_none_or(|t| {
                let t = t.trim_start_matches(BOLD);
                t.is_empty() || t.starts_with(|l: char| l.is_ascii_digit() || "-−<–".contains(l))
            })
        })
    };
    let rule: Vec<&str> =
        (0..table.columns.len()).map(|c| if number(c) { "---:" } else { "---" }).collect();
    page.push_str(&format!("| {} |\n", rule.join(" | ")));
    for r in &table.rows {
        page.push_str(&row(r));
    }
    page.push('\n');
}

pub(crate) fn strings<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(String::from).to_vec()
}

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
        assert_eq!(inline(&format!("a {} *b*", bold("1|2"))), "a **1\\|2** \\*b\\*");
        // texts of the program have these marks and stay as they are
        for text in ["F_t,Rd = 2 * γ_M2 [mm]", "`max_passes` of 3", "-43.2 kN m", "~ 3: 4/5 (EN)"]
        {
            assert_eq!(inline(text), text);
        }
    }
}
