//! Letters drawn as strokes, as on a plotter: no font file, readable at any size.
//!
//! A glyph is a list of polylines on a grid four units wide. `y` increases upwards: the descender
//! is at 0, the baseline at 2, the top of capitals at 8. Each point has two digits; blanks separate
//! polylines.

/// Width of a glyph with the space after it, in grid units.
const ADVANCE: f64 = 6.0;

/// Strokes of one letter. Letters without strokes are shown as an empty box.
fn strokes(letter: char) -> &'static str {
    match letter {
        ' ' => "",
        '0' => "123243473818070312",
        '1' => "062822 1232",
        '2' => "07183847460242",
        '3' => "0718384746354443321203 1535",
        '4' => "32380444",
        '5' => "480805354443321203",
        '6' => "4738180703123243443505",
        '7' => "084812",
        '8' => "15060718384746351504031232434435",
        '9' => "0312324347381807061545",
        'A' => "022842 1434",
        'B' => "02083847463505 3544433202",
        'C' => "4738180703123243",
        'D' => "02082846442202",
        'E' => "48080242 0535",
        'F' => "480802 0535",
        'G' => "47381807031232434525",
        'H' => "0208 4248 0545",
        'I' => "1838 2822 1232",
        'J' => "4843321203",
        'K' => "0208 4805 0542",
        'L' => "080242",
        'M' => "0208254842",
        'N' => "02084248",
        'O' => "123243473818070312",
        'P' => "02083847463505",
        'Q' => "123243473818070312 2442",
        'R' => "02083847463505 2542",
        'S' => "473818070615354443321203",
        'T' => "0848 2822",
        'U' => "080312324348",
        'V' => "082248",
        'W' => "0812263248",
        'X' => "0248 0842",
        'Y' => "082548 2522",
        'Z' => "08480242",
        'a' => "16364542 441403123243",
        'b' => "0802 0516364543321203",
        'c' => "4536160503123243",
        'd' => "4842 4536160503123243",
        'e' => "04444536160503123243",
        'f' => "48382722 1646",
        'g' => "4536160503123243 46413010",
        'h' => "0802 0516364542",
        'i' => "162622 1232 2828",
        'j' => "2636312010 3838",
        'k' => "0802 4604 2542",
        'l' => "182822 1232",
        'm' => "0206 05162522 25364542",
        'n' => "0206 0516364542",
        'o' => "123243453616050312",
        'p' => "0600 0516364543321203",
        'q' => "4640 4536160503123243",
        'r' => "0602 04263645",
        's' => "4616051434433202",
        't' => "1813223243 0636",
        'u' => "0603123243 4642",
        'v' => "062246",
        'w' => "0612253246",
        'x' => "0246 0642",
        'y' => "0622 461000",
        'z' => "06460242",
        // as tall as a stroke is wide: a point of no length is lost where a picture is reduced
        '.' => "2232332322",
        ',' => "2210",
        ':' => "2323 2626",
        ';' => "2310 2626",
        '!' => "2824 2222",
        '?' => "07183847462524 2222",
        '+' => "0545 2327",
        '=' => "0444 0646",
        '/' => "0148",
        '|' => "2028",
        '_' => "0141",
        '(' => "38171332",
        ')' => "18373312",
        '[' => "38181232",
        ']' => "18383212",
        '<' => "470543",
        '>' => "074503",
        '*' => "1337 3317 0545",
        '·' => "2525",
        '×' => "0346 0643",
        '°' => "1728372617",
        '%' => "0248 0718271607 2334433223",
        '²' => "1728371535",
        '³' => "183827362515",
        'α' => "46342212030516263442",
        'σ' => "461605031222333526",
        'λ' => "081842 2602",
        '#' => "1218 3238 0444 0646",
        '…' => "0202 2222 4242",
        '-' | '−' | '–' => "0545",
        'ä' => "16364542 441403123243 1718 3738",
        'ö' => "123243453616050312 1718 3738",
        'ü' => "0603123243 4642 1718 3738",
        'Ä' => "022742 1434 0708 4748",
        'Ö' => "123243473716050312 0708 4748",
        'Ü' => "070312324347 1718 3738",
        'ß' => "020718384746353443321222",
        'µ' | 'μ' => "0600 0603123243 4642",
        '\'' => "2826",
        '"' => "1816 3836",
        _ => "0208484202",
    }
}

/// The line segments of a text whose capitals are `height` tall, starting at `(x, y)` on its
/// baseline, y downward.
pub fn text_segments(text: &str, x: f64, y: f64, height: f64) -> Vec<[[f64; 2]; 2]> {
    let unit = height / 6.0;
    let mut segments = Vec::new();
    for (i, letter) in text.chars().enumerate() {
        let left = x + i as f64 * ADVANCE * unit;
        for line in strokes(letter).split(' ') {
            let points: Vec<[f64; 2]> = line
                .as_bytes()
                .chunks_exact(2)
                .map(|p| {
                    [
                        left + f64::from(p[0] - b'0') * unit,
                        y - (f64::from(p[1] - b'0') - 2.0) * unit,
                    ]
                })
                .collect();
            segments.extend(points.windows(2).map(|p| [p[0], p[1]]));
        }
    }
    segments
}

/// Width of a text whose capitals are `height` tall.
pub fn text_width(text: &str, height: f64) -> f64 {
    (text.chars().count() as f64 * ADVANCE - 2.0).max(0.0) * height / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_printable_letter_is_drawn_inside_its_cell() {
        for letter in
            (' '..='~').chain("−–µμ²³·×°ασλ…äöüÄÖÜß".chars()).filter(|c| !"$&@\\^`{}~".contains(*c))
        {
            assert!(letter == ' ' || strokes(letter) != strokes('\u{0}'), "{letter} is not drawn");
            for line in strokes(letter).split(' ').filter(|_| letter != ' ') {
                assert!(line.len() >= 4 && line.len() % 2 == 0, "{letter}: {line}");
                assert!(
                    line.bytes().step_by(2).all(|b| (b'0'..=b'4').contains(&b)),
                    "{letter}: {line}"
                );
                assert!(
                    line.bytes().skip(1).step_by(2).all(|b| (b'0'..=b'8').contains(&b)),
                    "{letter}: {line}"
                );
            }
        }
    }

    #[test]
    fn capitals_have_the_wanted_height() {
        let ys: Vec<f64> =
            text_segments("HM", 10.0, 50.0, 12.0).iter().flatten().map(|p| p[1]).collect();
        assert_eq!(ys.iter().copied().fold(f64::INFINITY, f64::min), 38.0);
        assert_eq!(ys.iter().copied().fold(f64::NEG_INFINITY, f64::max), 50.0);
    }
}
