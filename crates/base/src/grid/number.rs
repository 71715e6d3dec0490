//! Numbers of a table whose decimal sign nobody tells: found from all of them, then read.

use crate::units::plain_minus;

/// The decimal sign of the numbers in `cells`: the point or the comma. The error holds a cell for
/// which it would be the point and one for which it would be the comma; or twice a cell that allows
/// both.
///
/// A sign that stands twice in a number, or before the other one, separates thousands. One that is
/// followed by three digits may do so, any other is a decimal sign.
pub fn decimal_sign<'a>(cells: impl Iterator<Item = &'a str> + Clone) -> Result<char, [String; 2]> {
    let mut told: [Option<&str>; 2] = [None, None];
    let mut untold: [Option<&str>; 2] = [None, None];
    let mut whole = false;
    for cell in cells {
        let number = digits_of(cell);
        let count = SIGNS.map(|s| number.matches(s).count());
        // the sign by this number, and whether it may separate thousands
        let (sign, open) = match count {
            [0, 0] => {
                whole |= number.bytes().any(|b| (b'1'..=b'9').contains(&b));
                continue;
            }
            [1, 0] | [0, 1] => (count[1], may_group(number, SIGNS[count[1]])),
            [_, 0] => (1, false),
            [0, _] => (0, false),
            _ => (usize::from(number.rfind(SIGNS[1]) > number.rfind(SIGNS[0])), false),
        };
        let seen = if open { &mut untold } else { &mut told };
        seen[sign].get_or_insert(cell);
    }
    let pair = |a: &str, b: &str| Err([a.to_string(), b.to_string()]);
    match (told, untold) {
        ([Some(a), Some(b)], _) => pair(a, b),
        ([Some(_), None], _) | ([None, None], [None, None]) => Ok(SIGNS[0]),
        ([None, Some(_)], _) => Ok(SIGNS[1]),
        ([None, None], [Some(a), Some(b)]) => pair(a, b),
        // thousands alone would leave the smaller numbers without a sign
        ([None, None], [Some(a), None] | [None, Some(a)]) if whole => pair(a, a),
        ([None, None], [Some(_), None]) => Ok(SIGNS[0]),
        ([None, None], [None, Some(_)]) => Ok(SIGNS[1]),
    }
}

/// A number with this decimal sign; `None` if the cell is no finite number. What may stand between
/// thousands is left out: the other sign, blanks and apostrophes. They must stand between groups of
/// three digits; the other sign alone, as in `1.003` among decimal commas, is no number: it may be
/// the decimal sign of another hand.
pub fn number(cell: &str, decimal: char) -> Option<f64> {
    let plain = plain_minus(cell.trim());
    let grouping = |c: char| {
        c != decimal && (SIGNS.contains(&c) || c.is_whitespace() || matches!(c, '\'' | '’'))
    };
    let digits = digits_of(&plain);
    let (whole, decimals) =
        digits.split_once(decimal).map_or((digits, None), |(w, d)| (w, Some(d)));
    let groups: Vec<&str> = whole.split(grouping).collect();
    let even = groups[1..].iter().all(|g| g.len() == 3) && groups[0].len() <= 3;
    let alone = decimals.is_none() && groups.len() == 2 && whole.contains(SIGNS);
    if decimals.is_some_and(|d| d.contains(grouping)) || groups.len() > 1 && (!even || alone) {
        return None;
    }
    let kept = |c: &char| !grouping(*c);
    let text: String =
        plain.chars().filter(kept).map(|c| if c == decimal { '.' } else { c }).collect();
    // the words of floating-point numbers are no numbers of a table
    let numeric =
        text.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E'));
    text.parse().ok().filter(|x: &f64| numeric && x.is_finite())
}

const SIGNS: [char; 2] = ['.', ','];

/// A number without its sign and exponent.
fn digits_of(cell: &str) -> &str {
    let number = cell.trim().trim_start_matches(['+', '-', '−']);
    number.split(['e', 'E']).next().unwrap_or_default()
}

/// Whether the sign may separate thousands: `1,250`, not `0,250`, `1250,125` or `1,25`.
fn may_group(number: &str, sign: char) -> bool {
    number.split_once(sign).is_some_and(|(before, after)| {
        (1..=3).contains(&before.len()) && !before.starts_with('0') && after.len() == 3
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_decimal_sign_of_many_numbers() {
        for (cells, sign) in [
            ("1|2|-3", Ok('.')),
            ("12.5|-3", Ok('.')),
            ("12,345|0,120|-7,000", Ok(',')),
            // three decimals throughout, and no number without: no thousands
            ("12,345|-107,250", Ok(',')),
            ("12,345|-107,250|0", Ok(',')),
            ("1.234,5|12,345", Ok(',')),
            ("1,234.5|12,345", Ok('.')),
            ("1.234.567|12", Ok(',')),
            ("1,234,567|12,5e3", Err(["12,5e3"; 2])),
            ("12.5|12,5", Err(["12.5", "12,5"])),
            ("12,345|7", Err(["12,345"; 2])),
            ("12.345|12,345", Err(["12.345", "12,345"])),
            ("-1.5E-14|2", Ok('.')),
            ("", Ok('.')),
        ] {
            let found = decimal_sign(cells.split('|'));
            match sign {
                Ok(sign) => assert_eq!(found, Ok(sign), "{cells}"),
                Err(_) => assert!(found.is_err(), "{cells}: {found:?}"),
            }
        }
    }

    #[test]
    fn numbers_with_a_known_sign() {
        for (cell, decimal, value) in [
            ("12,345", ',', Some(12.345)),
            ("12,345", '.', None),
            ("1.003", ',', None),
            ("1,2.5", '.', None),
            ("1234.567,5", ',', None),
            ("12,345,678", '.', Some(12_345_678.0)),
            ("12,345.6", '.', Some(12_345.6)),
            ("1 234", '.', Some(1234.0)),
            ("−1.234,5", ',', Some(-1234.5)),
            ("1 234,5", ',', Some(1234.5)),
            ("1'234.5", '.', Some(1234.5)),
            (" -1.5E-14 ", '.', Some(-1.5e-14)),
            ("", '.', None),
            ("-", '.', None),
            ("inf", '.', None),
            ("1e999", '.', None),
            ("12 kN", '.', None),
        ] {
            assert_eq!(number(cell, decimal), value, "{cell}");
        }
    }
}
