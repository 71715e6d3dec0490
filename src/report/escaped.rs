//! Text of the user inside HTML, SVG and scripts, where it must stay text.

use crate::diag::visible;

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

/// JSON that may stand inside a `script` element: no `<` can end it.
pub fn inside_script(json: &str) -> String {
    json.replace('<', "\\u003c").replace('\u{2028}', "\\u2028").replace('\u{2029}', "\\u2029")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_ends_an_element_an_attribute_or_a_script() {
        let text = "<b a='1' c=\"2\">&\u{7}\n";
        assert_eq!(escaped(text), "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;\u{fffd}\n");
        assert_eq!(unescaped(&escaped("<b a='1' c=\"2\">&amp;")), "<b a='1' c=\"2\">&amp;");
        assert_eq!(inside_script("\"</script>\u{2028}\""), "\"\\u003c/script>\\u2028\"");
    }
}
