//! Kinds of joint that people ask for and this edition does not have.

/// Beginnings of words, and what they mean.
const LATER: [(&str, &str); 2] = [("skew", "skewed members"), ("taper", "tapered members")];

/// What a key, parameter or template would be about, if this edition does not have it.
pub fn not_in_this_edition(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    let begins = |start: &str| word.split(['_', '-', '.', ' ']).any(|part| part.starts_with(start));
    LATER.into_iter().find(|(start, _)| begins(start)).map(|(_, what)| what)
}

/// The help for such a word.
pub fn help(what: &str) -> String {
    format!(
        "{what} are not in this edition; a template of your own can have turned solids and plates \
         with outlines, which no check by code covers (templates/README.md)"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_later_editions_are_known_in_their_spellings() {
        for word in ["skew", "skew_angle", "Skewed", "tapered_flange"] {
            assert!(not_in_this_edition(word).is_some(), "{word}");
        }
        for word in ["gauge", "haunch", "slope", "proof", "plate", "beam_length", ""] {
            assert_eq!(not_in_this_edition(word), None, "{word}");
        }
    }
}
