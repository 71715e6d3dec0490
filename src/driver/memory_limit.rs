//! `--memory-limit`: how much memory a run may use.

use bracket_base::diag::{Diagnostic, Diagnostics};

/// Units and their bytes: SI and binary, as schedulers and users write them.
const UNITS: [(&str, f64); 8] = [
    ("MiB", 1048576.0),
    ("GiB", 1073741824.0),
    ("TiB", 1099511627776.0),
    ("MB", 1e6),
    ("GB", 1e9),
    ("TB", 1e12),
    // in batch systems a single letter denotes a binary unit
    ("M", 1048576.0),
    ("G", 1073741824.0),
];

/// Smallest limit \[bytes\]: the program with its smallest model needs about as much.
const LEAST: f64 = 64.0 * 1048576.0;

/// Largest limit \[bytes\]: no machine has more.
const MOST: f64 = 1099511627776.0 * 1024.0;

/// The limit in bytes: `8GiB`, `500 MiB`, `1.5 TB`, `64G`.
pub fn parse(text: &str) -> Result<u64, Diagnostics> {
    let refused = |why: String| {
        let help = "write a number with its unit, for example `--memory-limit 8GiB` or \
                    `--memory-limit 500MiB`";
        Err(Diagnostic::input("cli/value", format!("--memory-limit is `{text}`: {why}"))
            .help(help)
            .into())
    };
    let trimmed = text.trim();
    let split = trimmed.find(|c: char| c.is_alphabetic()).unwrap_or(trimmed.len());
    let (number, unit) = (trimmed[..split].trim_end(), &trimmed[split..]);
    if unit.is_empty() {
        return refused("it has no unit".into());
    }
    let Some((_, bytes)) = UNITS.iter().find(|(name, _)| name.eq_ignore_ascii_case(unit)) else {
        return refused(format!("`{unit}` is not a unit of memory (MiB, GiB, TiB, MB, GB, TB)"));
    };
    // digits and a point only: no sign, no exponent, no thousands
    let plain = number.chars().all(|c| c.is_ascii_digit() || c == '.');
    let Some(value) = number.parse::<f64>().ok().filter(|_| plain) else {
        return refused(format!("`{number}` is not a number like 8 or 1.5"));
    };
    let size = value * bytes;
    if !(LEAST..=MOST).contains(&size) {
        return refused("it must be between 64 MiB and 1024 TiB".into());
    }
    Ok(size as u64)
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn sizes_are_read_in_all_usual_forms() {
        for (text, bytes) in [
            ("8GiB", 8u64 << 30),
            ("8 GiB", 8 << 30),
            (" 8gib ", 8 << 30),
            ("64G", 64 << 30),
            ("500MiB", 500 << 20),
            ("500M", 500 << 20),
            ("0.5 GiB", 1 << 29),
            ("1.5TB", 1_500_000_000_000),
            ("2 TiB", 2 << 40),
            ("8GB", 8_000_000_000),
            ("64MiB", 64 << 20),
            ("100MB", 100_000_000),
        ] {
            assert_eq!(parse(text).ok(), Some(bytes), "{text}");
        }
    }

    #[test]
    fn wrong_sizes_are_refused_with_the_reason() {
        for (text, why) in [
            ("", "no unit"),
            ("8", "no unit"),
            ("8.5", "no unit"),
            ("GiB", "`` is not a number"),
            ("-8GiB", "`-8` is not a number"),
            ("+8GiB", "`+8` is not a number"),
            ("8,5GiB", "`8,5` is not a number"),
            ("8.5.1GiB", "`8.5.1` is not a number"),
            ("8 GiBs", "`GiBs` is not a unit"),
            ("8 KiB", "`KiB` is not a unit"),
            ("8 apples", "`apples` is not a unit"),
            ("1e3GiB", "`e3GiB` is not a unit"),
            ("NaN GiB", "`NaN GiB` is not a unit"),
            ("infGiB", "`infGiB` is not a unit"),
            ("0GiB", "between 64 MiB"),
            ("63MiB", "between 64 MiB"),
            ("1025TiB", "between 64 MiB"),
            ("99999999999999999999999TiB", "between 64 MiB"),
            ("8 Gi B", "`Gi B` is not a unit"),
            ("８GiB", "is not a number"),
        ] {
            let e = parse(text).expect_err(text);
            assert_eq!((e.exit_code(), e.first().code), (2, "cli/value"), "{text}");
            assert!(e.first().message.contains(why), "{text}: {}", e.first().message);
        }
    }
}
