//! Texts with gaps: `between {1} and {2}`.

/// A text with gaps, which fits texts with anything in the gaps.
#[derive(Clone, Debug)]
pub struct Gapped {
    /// What stands before, between and behind the gaps.
    fixed: Vec<String>,
    /// Numbers of the gaps.
    gaps: Vec<usize>,
}

impl Gapped {
    /// Reads `between {1} and {2}`.
    pub fn new(text: &str) -> Self {
        let mut fixed = vec![String::new()];
        let mut gaps = Vec::new();
        let mut rest = text;
        while let Some(found) = next_gap(rest) {
            let (start, end, number) = found;
            fixed.last_mut().into_iter().for_each(|f| f.push_str(&rest[..start]));
            fixed.push(String::new());
            gaps.push(number);
            rest = &rest[end..];
        }
        fixed.last_mut().into_iter().for_each(|f| f.push_str(rest));
        Self { fixed, gaps }
    }

    /// Number of fixed letters.
    pub fn letters(&self) -> usize {
        self.fixed.iter().map(String::len).sum()
    }

    /// What stands in the gaps of `text`, by their numbers from 1; `None` if the text does not fit.
    pub fn fit<'t>(&self, text: &'t str) -> Option<Vec<&'t str>> {
        let rest = text.strip_prefix(self.fixed.first()?.as_str())?;
        let mut found = Vec::new();
        self.rest(0, rest, &mut found)?;
        let mut out = vec![""; self.gaps.iter().max().copied().unwrap_or(0)];
        for (number, part) in self.gaps.iter().zip(found) {
            out[number - 1] = part;
        }
        Some(out)
    }

    /// Fits the gaps from `gap` on; the shortest part comes first.
    fn rest<'t>(&self, gap: usize, text: &'t str, found: &mut Vec<&'t str>) -> Option<()> {
        let Some(next) = self.fixed.get(gap + 1) else { return text.is_empty().then_some(()) };
        let last = gap + 2 == self.fixed.len();
        let ends: Box<dyn Iterator<Item = usize>> = if last {
            Box::new(text.ends_with(next.as_str()).then(|| text.len() - next.len()).into_iter())
        } else {
            Box::new(text.match_indices(next.as_str()).map(|m| m.0))
        };
        let ends = ends.filter(|e| *e > 0 && balanced(&text[..*e]));
        // a gap is no more than a part of a sentence
        for end in ends.take_while(|e| !text[..*e].contains(". ")) {
            found.push(&text[..end]);
            if self.rest(gap + 1, &text[end + next.len()..], found).is_some() {
                return Some(());
            }
            found.pop();
        }
        None
    }
}

/// True if every bracket of a text is closed in it.
pub fn balanced(text: &str) -> bool {
    let step = |open: Option<u32>, c: char| match c {
        '(' => open.map(|n| n + 1),
        ')' => open.and_then(|n| n.checked_sub(1)),
        _ => open,
    };
    text.chars().fold(Some(0), step) == Some(0)
}

/// Start, end and number of the first gap.
fn next_gap(text: &str) -> Option<(usize, usize, usize)> {
    text.match_indices('{').find_map(|(start, _)| {
        let end = start + text[start..].find('}')?;
        let number = text[start + 1..end].parse().ok().filter(|n| *n > 0)?;
        Some((start, end + 1, number))
    })
}

/// A text with its gaps filled.
pub fn filled(text: &str, parts: &[String]) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some((start, end, number)) = next_gap(rest) {
        out.push_str(&rest[..start]);
        out.push_str(parts.get(number - 1).map_or("", String::as_str));
        rest = &rest[end..];
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_take_parts_of_one_sentence() {
        let fit = |pattern: &str, text: &'static str| Gapped::new(pattern).fit(text);
        assert_eq!(fit("between {1} and {2}", "between 1 and 2"), Some(vec!["1", "2"]));
        assert_eq!(fit("{2} of {1}", "3 of a and of b"), Some(vec!["a and of b", "3"]));
        assert_eq!(fit("{1} and {2} end", "a and b and c end"), Some(vec!["a", "b and c"]));
        assert_eq!(fit("about {1}", "about a. And b"), None);
        assert_eq!(fit("about {1}", "about "), None);
        assert_eq!(fit("a ({1})", "a (b (c))"), Some(vec!["b (c)"]));
        assert_eq!(fit("a ({1})", "a (b); a (c)"), None);
        assert_eq!(fit("{a} {1}", "{a} b"), Some(vec!["b"]));
        assert_eq!(filled("{2}, {1}, {0} {3}", &["a".into(), "b".into()]), "b, a, {0} ");
    }
}
