//! Kinds of joint that people ask for and this edition does not have.

/// Beginnings of words, and what they mean.
const LATER: [(&str, &str); 8] = [
    ("haunch", "haunches"),
    ("voute", "haunches"),
    ("slope", "sloped members"),
    ("inclin", "sloped members"),
    ("roof", "sloped members"),
    ("skew", "skewed members"),
    ("taper", "tapered members"),
    ("angle", "sloped and skewed members"),
];

/// What a key, parameter or template would be about, if this edition does not have it.
pub fn not_in_this_edition(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    let begins = |start: &str| word.split(['_', '-', '.', ' ']).any(|part| part.starts_with(start));
    LATER.into_iter().find(|(start, _)| begins(start)).map(|(_, what)| what)
}

/// The help for such a word.
pub fn help(what: &str) -> String {
    format!(
        "{what} are not in this edition: its templates join members at right angles; a template of \
         your own can have further plates, which no check by code covers (templates/README.md)"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_later_editions_are_known_in_their_spellings() {
        for word in ["haunch", "haunch_depth", "Haunched", "beam_slope", "inclination", "angle"] {
            assert!(not_in_this_edition(word).is_some(), "{word}");
        }
        for word in ["gauge", "rectangle", "proof", "plate", "beam_length", ""] {
            assert_eq!(not_in_this_edition(word), None, "{word}");
        }
    }
}
