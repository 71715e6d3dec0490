//! Words inside drawings.

use super::Words;
use crate::escaped::{escaped, unescaped};
use crate::lettering::width;
use bracket_base::words::Text;

impl Words {
    /// The file beside a drawing with its texts in the language, such as `drawing.de.svg`; `None`
    /// for English and for other pictures, whose lettering is in the language from the start.
    pub fn file(&self, name: &str) -> Option<String> {
        self.messages?;
        Some(format!("{}.{}.svg", name.strip_suffix(".svg")?, self.code()))
    }

    /// A drawing of this program with its texts in the language, each as a whole by the data that
    /// are kept beside the file ([`Words::with`]). It becomes wider where a text needs that.
    pub fn drawing(&self, svg: &str) -> String {
        if self.messages.is_none() {
            return svg.into();
        }
        let (mut out, mut right) = (String::with_capacity(svg.len()), 0.0_f64);
        for line in svg.lines() {
            let title = line.strip_prefix("<title>").and_then(|l| l.strip_suffix("</title>"));
            if let Some(title) = title {
                out.push_str(&format!("<title>{}</title>\n", escaped(&self.said(title))));
                continue;
            }
            let text = line.strip_prefix("<text ").and_then(|l| l.strip_suffix("</text>"));
            let Some((attributes, text)) = text.and_then(|t| t.split_once('>')) else {
                out.push_str(line);
                out.push('\n');
                continue;
            };
            let said = self.said(text);
            let width = width(&said);
            let x = attribute(attributes, "x").unwrap_or(0.0);
            right = right.max(match attributes {
                a if a.contains("\"middle\"") => x + 0.5 * width,
                a if a.contains("\"end\"") => x,
                _ => x + width,
            });
            out.push_str(&format!("<text {attributes}>{}</text>\n", escaped(&said)));
        }
        widened(out, right)
    }

    /// A text of an English drawing, escaped there, in the language.
    fn said(&self, english: &str) -> String {
        self.say(&Text { id: unescaped(english).into(), gaps: Vec::new() })
    }
}

/// The number of an attribute.
fn attribute(attributes: &str, name: &str) -> Option<f64> {
    let (_, rest) = attributes.split_once(&format!("{name}=\""))?;
    rest.split_once('"')?.0.parse().ok()
}

/// A drawing that reaches `right` at least.
fn widened(svg: String, right: f64) -> String {
    let size = svg.split_once("viewBox=\"0 0 ").and_then(|(_, rest)| rest.split_once(' '));
    let Some(old) = size.map(|s| s.0.to_owned()) else { return svg };
    let new = (right + 16.0).ceil();
    if old.parse().is_ok_and(|old: f64| old >= new) {
        return svg;
    }
    svg.replace(&format!("viewBox=\"0 0 {old} "), &format!("viewBox=\"0 0 {new} "))
        .replace(&format!("width=\"{old}\""), &format!("width=\"{new}\""))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_base::say;
    use bracket_base::words::collected;
    use bracket_joint::spec::connection::Language;

    /// Every text is said as a whole, names of the user stay, and the drawing grows where a longer
    /// word needs it. Texts stay escaped.
    #[test]
    fn drawings_are_said_by_the_data_of_their_texts_and_widened() {
        let text = |x: u32, anchor: &str, text: &str| {
            format!("<text x=\"{x}.0\" y=\"1\" text-anchor=\"{anchor}\">{text}</text>\n")
        };
        let svg = format!(
            "<svg width=\"50\" height=\"9\" viewBox=\"0 0 50 9\">\n<title>Joint, two \
             views</title>\n<rect width=\"50\"/>\n{}{}{}{}</svg>\n",
            text(10, "start", "side view"),
            text(10, "end", "beam a &lt; b S235"),
            text(10, "end", "column"),
            text(10, "end", "12.5")
        );
        let beam = say!("beam {} {}", "a < b".to_owned(), "S235".to_owned());
        let (_, kept) = collected(|| serde_json::to_string(&[beam, Text::given("column")]));
        let german = Words::new(Language::De).with(kept);
        let said = german.drawing(&svg);
        for part in [
            "<title>Anschluss, zwei Ansichten</title>",
            ">Seitenansicht<",
            ">Träger a &lt; b S235<",
            ">column<",
            ">12.5<",
            "<svg width=\"117\" height=\"9\" viewBox=\"0 0 117 9\">",
        ] {
            assert!(said.contains(part), "{part}: {said}");
        }
        assert_eq!(german.unknown(), [""; 0]);
        assert_eq!(Words::default().drawing(&svg), svg);
    }
}
