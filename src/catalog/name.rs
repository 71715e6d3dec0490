//! Names as engineers write them, brought to one form.

/// One form for all spellings of a name: upper case, without blanks, hyphens and underscores, `×` and `*` as `X`.
pub fn normalise(name: &str) -> String {
    name.chars()
        .filter(|c| !c.is_whitespace() && !matches!(c, '-' | '_' | '\u{2010}' | '\u{2011}' | '\u{2013}'))
        .map(|c| if matches!(c, '×' | '*') { 'X' } else { c })
        .flat_map(char::to_uppercase)
        .collect()
}

/// The key of a profile: `HE 200 B`, `HE200B`, `HEB 200` → `HEB200`; `IPE 200 A` → `IPEA200`;
/// `533x210x92 UB`, `UKB 533x210x92` → `UB533X210X92`; `w14x90` → `W14X90`.
pub fn profile_key(name: &str) -> String {
    let flat = normalise(name);
    let head: String = flat.chars().take_while(char::is_ascii_alphabetic).collect();
    let tail: String =
        flat.chars().rev().take_while(char::is_ascii_alphabetic).collect::<Vec<_>>().iter().rev().collect();
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

/// The key of a steel grade: quality letters that do not change the strength are dropped, so `S355 J2+N` → `S355`,
/// `S275NL` → `S275N`, `S460QL1` → `S460Q`, `S355J2H` → `S355H`. A leading standard stays: `EN 10210-1 S355H` →
/// `EN102101S355H`.
///
/// # Source
/// EN 1993-1-1:2005 Table 3.1 lists the grades without their impact classes (`S 275 N/NL`).
pub fn steel_key(name: &str) -> String {
    let flat = normalise(name);
    let flat = flat.split('+').next().unwrap_or_default();
    let Some(start) =
        flat.rfind('S').filter(|s| flat[s + 1..].chars().take(3).filter(char::is_ascii_digit).count() == 3)
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
                &["UB 533x210x92", "533x210x92UB", "533 × 210 × 92 UB", "UKB533x210x92", "533*210*92 UKB"],
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
