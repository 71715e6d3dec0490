//! Text of the user inside HTML, SVG and scripts, where it must stay text.

use bracket_base::diag::visible;

/// A text for HTML and XML: elements and attributes. Control characters, which XML refuses, become
/// the replacement character.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in visible(text).chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}

/// The text that [`escaped`] gave.
pub fn unescaped(text: &str) -> String {
    let marks = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")];
    marks.iter().fold(text.to_owned(), |text, (mark, c)| text.replace(mark, c))
}

/// A text for a cell of a CSV file. A text that a spreadsheet would take for a formula gets an
/// apostrophe; the quotes of CSV are the writer's.
pub fn csv_cell(text: &str) -> String {
    let text = visible(text);
    let begins = text.trim_start_matches([' ', '\u{a0}', '\n']);
    let formula = begins.starts_with(['=', '+', '@', '\t', '\u{ff1d}', '\u{ff0b}', '\u{ff20}'])
        || (begins.starts_with('-') && begins.parse::<f64>().is_err() && negative_formula(begins));
    if formula { format!("'{text}") } else { text }
}

/// True if a text behind a minus sign is no quantity such as `-43.2 kN m`.
fn negative_formula(text: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || " ./^".contains(c);
    !(text[1..].trim_start().starts_with(|c: char| c.is_ascii_digit())
        && text[1..].chars().all(plain))
}

/// JSON that may stand inside a `script` element: no `<` can end it, and its texts turn no
/// direction of writing.
pub fn inside_script(json: &str) -> String {
    visible(json).replace('<', "\\u003c")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_of_tables_are_no_formulas() {
        for (text, cell) in [
            ("=1+1", "'=1+1"),
            (" =1+1", "' =1+1"),
            ("\t=1", "'\t=1"),
            ("＝1", "'＝1"),
            ("@x", "'@x"),
            ("-43.2 kN m", "-43.2 kN m"),
            ("-cmd|x", "'-cmd|x"),
            ("-2+cmd|x", "'-2+cmd|x"),
            ("IPE200", "IPE200"),
            ("a\u{1b}[31m", "a\u{fffd}[31m"),
        ] {
            assert_eq!(csv_cell(text), cell);
        }
    }

    #[test]
    fn nothing_ends_an_element_an_attribute_or_a_script() {
        let text = "<b a='1' c=\"2\">&\u{7}\n";
        assert_eq!(escaped(text), "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;\u{fffd}\n");
        assert_eq!(unescaped(&escaped("<b a='1' c=\"2\">&amp;")), "<b a='1' c=\"2\">&amp;");
        assert_eq!(inside_script("\"</script>\u{2028}\""), "\"\\u003c/script>\u{fffd}\"");
    }
}
