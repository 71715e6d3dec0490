//! Converts the names that engineers write to one form for comparison.

/// The common form of all spellings of a name: upper case, no blanks, hyphens or underscores, `×`
/// and `*` replaced by `X`.
pub fn normalise(name: &str) -> String {
    name.chars()
        .filter(|c| {
            !c.is_whitespace() && !matches!(c, '-' | '_' | '\u{2010}' | '\u{2011}' | '\u{2013}')
        })
        .map(|c| if matches!(c, '×' | '*') { 'X' } else { c })
        .flat_map(char::to_uppercase)
        .collect()
}

/// The key of a profile: `HE 200 B`, `HE200B`, `HEB 200` → `HEB200`; `IPE 200 A` → `IPEA200`;
/// `533x210x92 UB`, `UKB 533x210x92` → `UB533X210X92`; `w14x90` → `W14X90`.
pub fn profile_key(name: &str) -> String {
    let flat = normalise(name);
    let head: String = flat.chars().take_while(char::is_ascii_alphabetic).collect();
    let tail: String = flat
        .chars()
        .rev()
        .take_while(char::is_ascii_alphabetic)
        .collect::<Vec<_>>()
        .iter()
        .rev()
        .collect();
    if head.len() == flat.len() {
        return flat;
    }
    let figures = &flat[head.len()..flat.len() - tail.len()];
    let series = match (head.as_str(), tail.as_str()) {
        ("HE", "A" | "B" | "M" | "AA") | ("IPE", "A" | "O") => format!("{head}{tail}"),
        ("", "UB" | "UC" | "HD" | "W") => tail,
        ("", "UKB") | ("UKB", "") => "UB".into(),
        ("", "UKC") | ("UKC", "") => "UC".into(),
        (_, "") => head,
        _ => return flat,
    };
    format!("{series}{figures}")
}

/// Series of profiles that are no I or H sections.
const OTHER_SERIES: [&str; 13] =
    ["UPE", "UPN", "UAP", "UPA", "U", "PFC", "RHS", "SHS", "CHS", "HSS", "QRO", "L", "T"];

/// Whether a name is that of a channel, hollow section, angle or tee: `UPE200`, `SHS 100x5`.
pub fn is_no_i_section(name: &str) -> bool {
    let key = profile_key(name);
    let series = key.split(|c: char| c.is_ascii_digit()).next().unwrap_or_default();
    series.len() < key.len() && OTHER_SERIES.contains(&series)
}

/// The key of a bolt grade: `8.8`; `F3125 Grade A325`, `ASTM A325M` → `A325`.
pub fn bolt_grade_key(name: &str) -> String {
    let flat = astm_key(&normalise(name));
    // 10.90 is 10.9
    let flat = flat.parse::<f64>().map_or(flat, |number| number.to_string());
    let flat = flat.strip_prefix("F3125M").or_else(|| flat.strip_prefix("F3125")).unwrap_or(&flat);
    let metric = flat.starts_with('A').then(|| flat.strip_suffix('M')).flatten();
    metric.unwrap_or(flat).to_owned()
}

/// Removes the words that people write around the figures of an ASTM designation:
/// `ASTMA572GRADE50`, `A572GR.50` → `A57250`.
fn astm_key(flat: &str) -> String {
    flat.replace("ASTM", "").replace("GRADE", "").replace("GR.", "").replace("GR", "")
}

/// The key of a steel grade. Quality letters that do not change the strength are dropped: `S355
/// J2+N` → `S355`, `S275NL` → `S275N`, `S460QL1` → `S460Q`, `S355J2H` → `S355H`. A leading standard
/// is kept: `EN 10210-1 S355H` → `EN102101S355H`.
///
/// # Source
/// EN 1993-1-1:2005 Table 3.1 lists the grades without their impact classes (`S 275 N/NL`).
pub fn steel_key(name: &str) -> String {
    let flat = normalise(name);
    if flat.starts_with("ASTM") || flat.starts_with('A') {
        return astm_key(&flat);
    }
    let flat = flat.split('+').next().unwrap_or_default();
    let Some(start) = flat
        .rfind('S')
        .filter(|s| flat[s + 1..].chars().take(3).filter(char::is_ascii_digit).count() == 3)
    else {
        return flat.to_owned();
    };
    let (base, quality) = flat.split_at(start + 4);
    let quality = match quality {
        "JR" | "J0" | "J2" | "K2" => "",
        "JRH" | "J0H" | "J2H" | "K2H" => "H",
        "NL" => "N",
        "ML" => "M",
        "QL" | "QL1" => "Q",
        "NLH" => "NH",
        "J0W" | "J2W" | "K2W" => "W",
        other => other,
    };
    format!("{base}{quality}")
}

/// Splits a key into series, numbers and the text after them: `UB533X210X92` → `UB`, 533 210 92,
/// empty. `None` if the key has no series or no numbers.
fn sizes(key: &str) -> Option<(&str, Vec<f64>, &str)> {
    let first = key.find(|c: char| c.is_ascii_digit())?;
    let end = key.rfind(|c: char| c.is_ascii_digit())? + 1;
    let numbers =
        key[first..end].split('X').map(str::parse).collect::<Result<Vec<f64>, _>>().ok()?;
    Some((&key[..first], numbers, &key[end..]))
}

/// `, the nearest are …` for a size that a series does not contain. The neighbours of `IPE410` are
/// `IPE400` and `IPE450`; comparing spellings would rank `IPE140` just as near. `rows` are pairs of
/// key and name. `None` if the key does not consist of a series and numbers, or if no row belongs
/// to the series.
pub fn nearest_sizes(key: &str, rows: impl Iterator<Item = (String, String)>) -> Option<String> {
    let (series, wanted, tail) = sizes(key)?;
    let mut near: Vec<(Vec<f64>, String)> = Vec::new();
    for (key, name) in rows {
        let Some((s, numbers, t)) = sizes(&key) else { continue };
        if (s, t) == (series, tail) && !near.iter().any(|(_, n)| *n == name) {
            near.push((numbers, name));
        }
    }
    let off =
        |n: &[f64]| -> Vec<f64> { n.iter().zip(&wanted).map(|(a, b)| (a - b).abs()).collect() };
    // the first number counts most: depth before width before mass
    near.sort_by(|(a, _), (b, _)| off(a).partial_cmp(&off(b)).unwrap_or(std::cmp::Ordering::Equal));
    let side = |smaller: bool| {
        near.iter().find(|(n, _)| if smaller { n[0] < wanted[0] } else { n[0] > wanted[0] })
    };
    let chosen: Vec<&str> = match (wanted.len(), side(true), side(false)) {
        (1, Some(below), Some(above)) if near[0].0.len() == 1 => {
            let mut pair = [below, above];
            pair.sort_by(|a, b| {
                off(&a.0).partial_cmp(&off(&b.0)).unwrap_or(std::cmp::Ordering::Equal)
            });
            pair.iter().map(|(_, name)| name.as_str()).collect()
        }
        (1, ..) if near.first().is_some_and(|(n, _)| n.len() == 1) => {
            // beyond the ends of the series, a zero too many or too few is a likelier error than a
            // size far outside
            let slip = |n: &[f64]| n[0] == 10.0 * wanted[0] || wanted[0] == 10.0 * n[0];
            if let Some((_, name)) = near.iter().find(|(n, _)| slip(n)) {
                return Some(format!(", did you mean `{name}`?"));
            }
            near.iter().take(1).map(|(_, name)| name.as_str()).collect()
        }
        _ => near.iter().take(2).map(|(_, name)| name.as_str()).collect(),
    };
    match chosen[..] {
        [] => None,
        [one] => Some(format!(", the nearest is `{one}`")),
        [first, second, ..] => Some(format!(", the nearest are `{first}` and `{second}`")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn profile_spellings_meet() {
        for (spellings, key) in [
            (&["HEB200", "HE200B", "HE 200 B", "HEB 200", "heb-200", "he 200-b"][..], "HEB200"),
            (&["HE 160 AA", "HEAA160", "HE AA 160"], "HEAA160"),
            (&["ipe360", "IPE 360", "Ipe-360"], "IPE360"),
            (&["IPE A 200", "IPE200A", "IPEA200"], "IPEA200"),
            (
                &[
                    "UB 533x210x92",
                    "533x210x92UB",
                    "533 × 210 × 92 UB",
                    "UKB533x210x92",
                    "533*210*92 UKB",
                ],
                "UB533X210X92",
            ),
            (&["W14X90", "w14x90", "W 14 x 90"], "W14X90"),
            (&["HD 260x54.1", "hd260X54.1"], "HD260X54.1"),
        ] {
            for s in spellings {
                assert_eq!(profile_key(s), key, "{s}");
            }
        }
    }

    #[test]
    fn astm_spellings_meet() {
        for name in ["A572-50", "A572 Gr. 50", "ASTM A572 Grade 50", "a572 gr50"] {
            assert_eq!(steel_key(name), "A57250", "{name}");
        }
        for name in ["A325", "A325M", "F3125 Grade A325", "ASTM F3125M A325M", "F3125 Gr. A325"] {
            assert_eq!(bolt_grade_key(name), "A325", "{name}");
        }
        assert_eq!(bolt_grade_key("10.9"), "10.9");
    }

    #[test]
    fn odd_profile_names_do_not_panic() {
        for s in ["", "X", "200", "é200ß", "HE", "HEB", "B200B", "x×x", "1A1"] {
            let _ = profile_key(s);
        }
    }

    #[test]
    fn steel_spellings_meet() {
        for (name, key) in [
            ("S355", "S355"),
            ("s 355 J2+N", "S355"),
            ("S235JR", "S235"),
            ("S275NL", "S275N"),
            ("S355J2H", "S355H"),
            ("S460QL1", "S460Q"),
            ("EN 10210-1 S355H", "EN102101S355H"),
            ("S3", "S3"),
            ("Sé35", "SÉ35"),
            ("", ""),
        ] {
            assert_eq!(steel_key(name), key, "{name}");
        }
    }
}
