//! Words inside drawings.

use super::Words;
use crate::escaped::{escaped, unescaped};
use crate::lettering::width;

impl Words {
    /// The file beside a drawing with its texts in the language, such as `drawing.de.svg`; `None`
    /// for English and for other pictures, whose lettering is in the language from the start.
    pub fn file(&self, name: &str) -> Option<String> {
        self.dictionary?;
        Some(format!("{}.{}.svg", name.strip_suffix(".svg")?, self.code()))
    }

    /// A drawing of this program with its texts in the language. It becomes wider where a text
    /// needs that.
    pub fn drawing(&self, svg: &str) -> String {
        if self.dictionary.is_none() {
            return svg.into();
        }
        let (mut out, mut right) = (String::with_capacity(svg.len()), 0.0_f64);
        for line in svg.lines() {
            let text = line.strip_prefix("<text ").and_then(|l| l.strip_suffix("</text>"));
            let Some((attributes, text)) = text.and_then(|t| t.split_once('>')) else {
                out.push_str(line);
                out.push('\n');
                continue;
            };
            let said = self.say(&unescaped(text));
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
