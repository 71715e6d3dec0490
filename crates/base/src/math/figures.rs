//! Output of numbers for people: significant figures. Bounds are rounded to the safe side.

/// Direction of rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest.
    Nearest,
    /// Never up: for lower bounds.
    Down,
    /// Never down: for upper bounds.
    Up,
}

/// `x` with `decimals` decimal places (negative: rounded to tens, hundreds). A no-break space
/// separates thousands.
pub fn fixed(x: f64, decimals: i32, rounding: Rounding) -> String {
    let places = decimals.max(0) as usize;
    let step = 10.0_f64.powi(decimals.saturating_neg().max(0));
    let mut text = plain(x / step, step, places);
    // compares the printed number, not the intended one, with `x`
    let printed = text.parse::<f64>().unwrap_or(x);
    let nudge = match rounding {
        Rounding::Down if printed > x => -1.0,
        Rounding::Up if printed < x => 1.0,
        _ => 0.0,
    };
    if nudge != 0.0 {
        text = plain((printed + nudge * 10.0_f64.powi(-decimals)) / step, step, places);
    }
    group(&text)
}

fn plain(scaled: f64, step: f64, places: usize) -> String {
    let text = if step > 1.0 {
        format!("{:.0}", scaled.round() * step)
    } else {
        format!("{scaled:.places$}")
    };
    // avoids a negative zero
    if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
        text.trim_start_matches('-').into()
    } else {
        text
    }
}

fn group(text: &str) -> String {
    let (sign, digits) = text.strip_prefix('-').map_or(("", text), |d| ("-", d));
    let (whole, rest) = digits.split_at(digits.find('.').unwrap_or(digits.len()));
    if whole.len() <= 4 {
        return text.into();
    }
    let mut out = String::from(sign);
    for (i, c) in whole.chars().enumerate() {
        if i > 0 && (whole.len() - i) % 3 == 0 {
            out.push('\u{a0}');
        }
        out.push(c);
    }
    out + rest
}

/// `x` with `digits` significant digits.
pub fn significant(x: f64, digits: i32, rounding: Rounding) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if !(1e-4..1e9).contains(&x.abs()) {
        let written = |x: f64| format!("{x:.*e}", (digits - 1).max(0) as usize);
        let safe = |text: &String| match (rounding, text.parse::<f64>()) {
            (Rounding::Down, Ok(printed)) => printed <= x,
            (Rounding::Up, Ok(printed)) => printed >= x,
            _ => true,
        };
        let last = 10.0_f64.powi(x.abs().log10().floor() as i32 + 1 - digits);
        let aside = if rounding == Rounding::Down { x - last } else { x + last };
        // all digits are better than a bound on the wrong side
        return [written(x), written(aside)]
            .into_iter()
            .find(safe)
            .unwrap_or_else(|| format!("{x:e}"));
    }
    fixed(x, digits - 1 - x.abs().log10().floor() as i32, rounding)
}

/// Lower and upper bound with `gap_digits` significant digits of their difference, but at least
/// four and at most twelve significant digits of the larger bound. The lower bound is rounded down,
/// the upper one up. Three digits widen the bracket by at most 2 % of its width, four by 0.2 %.
pub fn bracket(lower: f64, upper: f64, gap_digits: i32) -> (String, String) {
    let size = lower.abs().max(upper.abs());
    if size == 0.0 {
        return ("0".into(), "0".into());
    }
    let power = |x: f64| x.log10().floor() as i32;
    let gap = (upper - lower).abs().max(f64::MIN_POSITIVE);
    let digits = (power(size) - power(gap) + gap_digits).clamp(4, 12);
    if !(1e-4..1e9).contains(&size) {
        return (
            significant(lower, digits, Rounding::Down),
            significant(upper, digits, Rounding::Up),
        );
    }
    let decimals = digits - 1 - power(size);
    (fixed(lower, decimals, Rounding::Down), fixed(upper, decimals, Rounding::Up))
}

/// A fraction in per cent, rounded up, so that a printed gap is never smaller than the true one.
pub fn percent_up(fraction: f64) -> String {
    if fraction > 0.0 && fraction < 1e-6 {
        return "< 0.0001 %".into();
    }
    format!("{} %", significant(100.0 * fraction, 3, Rounding::Up))
}

/// A utilisation with two decimals. It has more where two would print a value on the other side of
/// 1: 1.004 is not 1.00.
pub fn utilisation(x: f64, rounding: Rounding) -> String {
    /// Relative error of the computation, which no digit shows.
    const EQUAL: f64 = 1e-9;
    let x = match rounding {
        Rounding::Nearest => x,
        Rounding::Down => x * (1.0 + EQUAL),
        Rounding::Up => x * (1.0 - EQUAL),
    };
    let side = |x: f64| if (x - 1.0).abs() <= EQUAL { 0.0 } else { (x - 1.0).signum() };
    if (x - 1.0).abs() > 0.1 || side(x) == 0.0 {
        return fixed(x, 2, rounding);
    }
    let texts = (2..=10).map(|decimals| fixed(x, decimals, rounding));
    let mut clear = texts.filter(|t| t.parse().is_ok_and(|printed| side(printed) == side(x)));
    clear.next().unwrap_or_else(|| x.to_string())
}

/// A residual: two digits, rounded up.
pub fn residual(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    // `x` is positive; if the printed number is smaller, its second digit is raised
    let text = format!("{x:.1e}");
    let printed = text.parse::<f64>().unwrap_or(x);
    if printed >= x {
        text
    } else {
        format!("{:.1e}", x + 0.05 * 10.0_f64.powf(x.abs().log10().floor()))
    }
}

#[cfg(test)]
mod tests {
    use super::Rounding::{Down, Nearest, Up};
    use super::*;

    /// What a checker compares with 1 never prints on its other side.
    #[test]
    fn a_utilisation_never_crosses_one() {
        for (x, want) in [
            (0.0, "0.00"),
            (0.4549, "0.45"),
            (0.971, "0.97"),
            (0.997, "0.997"),
            (0.99996, "0.99996"),
            (1.0 - 1e-12, "1.00"),
            (1.0, "1.00"),
            (1.0 + 1e-10, "1.00"),
            (1.004, "1.004"),
            (1.000_000_2, "1.0000002"),
            (1.006, "1.01"),
            (12.345, "12.35"),
        ] {
            assert_eq!(utilisation(x, Rounding::Nearest), want);
        }
        assert_eq!(utilisation(1.0049, Rounding::Down), "1.004");
        assert_eq!(utilisation(0.9951, Rounding::Up), "0.996");
        assert_eq!(utilisation(0.451, Rounding::Up), "0.46");
        assert_eq!([Down, Up].map(|r| utilisation(0.1 + 0.2, r)), ["0.30", "0.30"]);
    }

    #[test]
    fn bounds_are_rounded_outward() {
        assert_eq!(
            bracket(-330_696.184, -322_744.743, 4),
            ("-330\u{a0}697".into(), "-322\u{a0}744".into())
        );
        assert_eq!(
            bracket(5.831_930_787e-5, 6.000_1e-5, 3),
            ("5.831e-5".into(), "6.001e-5".into())
        );
        assert_eq!(fixed(-330_696.184, -1, Down), "-330\u{a0}700");
        assert_eq!(fixed(0.123_41, 4, Down), "0.1234");
        assert_eq!(fixed(0.123_41, 4, Up), "0.1235");
        assert_eq!(fixed(0.1234, 4, Up), "0.1234");
        assert_eq!(fixed(-0.000_01, 2, Up), "0.00");
        assert_eq!(fixed(-0.000_01, 2, Down), "-0.01");
        assert_eq!(fixed(12_345.678, 1, Nearest), "12\u{a0}345.7");
    }

    #[test]
    fn the_printed_bracket_always_contains_the_true_one() {
        let mut seed = 1_u64;
        let mut next = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let back = |s: &str| s.replace('\u{a0}', "").parse::<f64>().expect("a number");
        for _ in 0..20_000 {
            let size = 10.0_f64.powf(20.0 * next() - 8.0) * if next() < 0.5 { -1.0 } else { 1.0 };
            let lower = size;
            let upper = size + size.abs() * 10.0_f64.powf(-9.0 * next());
            let (a, b) = bracket(lower, upper, 4);
            assert!(back(&a) <= lower && back(&b) >= upper, "{lower} {upper}: {a} {b}");
            assert!(
                back(&b) - back(&a) <= 1.0021 * (upper - lower) + 1e-10 * size.abs(),
                "{lower} {upper}: {a} {b}"
            );
        }
    }

    #[test]
    fn residuals_and_gaps_are_never_made_smaller() {
        assert_eq!(residual(3.14e-13), "3.2e-13");
        assert_eq!(residual(3.0e-13), "3.0e-13");
        assert_eq!(residual(9.91e-10), "1.0e-9");
        assert_eq!(residual(-2e-3), "-2.0e-3");
        assert_eq!(percent_up(0.045_801), "4.59 %");
        assert_eq!(percent_up(0.0), "0 %");
    }
}
