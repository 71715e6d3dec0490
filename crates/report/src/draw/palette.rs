//! Colours of bodies and of the bands of a field.

use crate::draw::canvas::Rgb;
use crate::draw::options::{Colours, Field};

pub(super) const BACKGROUND: Rgb = [255.0, 255.0, 255.0];
pub(super) const INK: Rgb = [38.0, 42.0, 48.0];
pub(super) const FRAME: Rgb = [150.0, 154.0, 160.0];
pub(super) const UNDEFINED: Rgb = [205.0, 205.0, 205.0];

/// Body colours, in the order in which groups of bodies appear.
pub(super) const BODY_COLOURS: [Rgb; 8] = [
    [176.0, 186.0, 198.0],
    [126.0, 170.0, 214.0],
    [240.0, 188.0, 96.0],
    [214.0, 92.0, 80.0],
    [132.0, 188.0, 122.0],
    [176.0, 142.0, 202.0],
    [98.0, 186.0, 186.0],
    [196.0, 160.0, 124.0],
];

/// Colours of a field from low to high.
const SPECTRUM: [Rgb; 7] = [
    [54.0, 70.0, 158.0],
    [58.0, 142.0, 200.0],
    [92.0, 192.0, 180.0],
    [150.0, 206.0, 104.0],
    [244.0, 220.0, 90.0],
    [240.0, 144.0, 60.0],
    [190.0, 36.0, 44.0],
];
const FIRE: [Rgb; 7] = [
    [222.0, 226.0, 230.0],
    [255.0, 240.0, 150.0],
    [254.0, 206.0, 90.0],
    [252.0, 158.0, 60.0],
    [244.0, 104.0, 42.0],
    [216.0, 40.0, 32.0],
    [140.0, 0.0, 34.0],
];
const VIOLET: [Rgb; 7] = [
    [222.0, 226.0, 230.0],
    [170.0, 222.0, 240.0],
    [110.0, 190.0, 232.0],
    [78.0, 148.0, 220.0],
    [84.0, 96.0, 204.0],
    [106.0, 44.0, 172.0],
    [74.0, 6.0, 112.0],
];

impl Colours {
    /// Name in a page.
    pub fn name(self) -> &'static str {
        match self {
            Colours::Spectrum => "spectrum",
            Colours::Fire => "fire",
            Colours::Violet => "violet",
        }
    }

    /// Colours from low to high.
    pub fn stops(self) -> &'static [Rgb; 7] {
        match self {
            Colours::Spectrum => &SPECTRUM,
            Colours::Fire => &FIRE,
            Colours::Violet => &VIOLET,
        }
    }
}

/// Groups of bodies that share a colour: bodies whose names agree up to the first `_` or digit.
pub struct Groups {
    /// Their names.
    pub names: Vec<String>,
    /// Group of each body.
    pub of_body: Vec<usize>,
}

impl Groups {
    /// The groups of bodies with these names.
    pub fn of(bodies: &[String]) -> Self {
        let mut names: Vec<String> = Vec::new();
        let of_body = bodies
            .iter()
            .map(|body| {
                let stem =
                    body.split(|c: char| c == '_' || c.is_ascii_digit()).next().unwrap_or_default();
                let stem = if stem.is_empty() { body } else { stem };
                names.iter().position(|n| n == stem).unwrap_or_else(|| {
                    names.push(stem.into());
                    names.len() - 1
                })
            })
            .collect();
        Self { names, of_body }
    }

    pub(super) fn colour(&self, body: u32) -> Rgb {
        group_colour(self.of_body.get(body as usize).copied().unwrap_or(0))
    }
}

/// Colour of a group of bodies.
pub fn group_colour(group: usize) -> Rgb {
    BODY_COLOURS[group % BODY_COLOURS.len()]
}

/// Bands of a field, with round limits.
pub(super) struct Bands {
    pub low: f64,
    pub step: f64,
    pub count: usize,
    /// Lowest and highest value of the field itself.
    pub extremes: [f64; 2],
    colours: Colours,
}

impl Bands {
    pub(super) fn of(field: Field) -> Self {
        let defined = field.values.iter().copied().filter(|v| v.is_finite());
        let extremes = [
            defined.clone().fold(f64::INFINITY, f64::min),
            defined.fold(f64::NEG_INFINITY, f64::max),
        ];
        let [low, high] = field.range.unwrap_or(extremes);
        if !(low.is_finite() && high.is_finite() && high > low) {
            // no value, or one value everywhere: a single band around it
            let value = if low.is_finite() { low } else { 0.0 };
            let step = nice(value.abs().max(1.0));
            return Self {
                low: (value / step).floor() * step,
                step,
                count: 1,
                extremes,
                colours: field.colours,
            };
        }
        let step = nice((high - low) / 12.0);
        let first = (low / step + 1e-9).floor();
        let count = ((high / step - 1e-9).ceil() - first).max(1.0) as usize;
        Self { low: first * step, step, count, extremes, colours: field.colours }
    }

    #[inline]
    pub(super) fn band(&self, value: f64) -> usize {
        (((value - self.low) / self.step).max(0.0) as usize).min(self.count - 1)
    }

    /// True if the last band also contains values above its limit.
    pub(super) fn exceeded(&self) -> bool {
        self.extremes[1] > self.low + (self.count as f64 + 1e-9) * self.step
    }

    #[inline]
    pub(super) fn colour(&self, band: usize) -> Rgb {
        let stops = self.colours.stops();
        let last = stops.len() - 1;
        let t =
            if self.count > 1 { band as f64 / (self.count - 1) as f64 * last as f64 } else { 0.0 };
        let i = (t as usize).min(last - 1);
        mix(stops[i], stops[i + 1], (t - i as f64) as f32)
    }

    /// A limit with enough digits to distinguish it from the next.
    pub(super) fn label(&self, limit: usize) -> String {
        let value = self.low + limit as f64 * self.step;
        let decimals = (-self.step.log10().floor()).max(0.0) as usize;
        if decimals > 5 || value.abs() >= 1e7 {
            return format!("{value:.2e}");
        }
        let text = format!("{value:.decimals$}");
        if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
            "0".into()
        } else {
            text
        }
    }
}

/// The smallest of 1, 2, 2.5, 5, 10 times a power of ten that is at least `x`.
pub(super) fn nice(x: f64) -> f64 {
    let power = 10.0_f64.powf(x.log10().floor());
    [1.0, 2.0, 2.5, 5.0, 10.0]
        .into_iter()
        .map(|m| m * power)
        .find(|s| *s >= x * (1.0 - 1e-9))
        .unwrap_or(10.0 * power)
}

#[inline]
pub(super) fn mix(a: Rgb, b: Rgb, t: f32) -> Rgb {
    [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_steps() {
        for (x, wanted) in [
            (0.9, 1.0),
            (1.0, 1.0),
            (1.1, 2.0),
            (2.2, 2.5),
            (26.0, 50.0),
            (70.0, 100.0),
            (0.003, 0.005),
        ] {
            assert!((nice(x) - wanted).abs() < 1e-12 * wanted, "{x} {}", nice(x));
        }
    }

    #[test]
    fn bands_cover_the_field_with_round_limits() {
        let values = [-3.0, f64::NAN, 97.0];
        let bands = Bands::of(Field {
            name: "s",
            unit: "MPa",
            values: &values,
            range: None,
            colours: Colours::Spectrum,
        });
        assert_eq!((bands.low, bands.step, bands.count), (-10.0, 10.0, 11));
        assert_eq!(
            (bands.band(-3.0), bands.band(0.0), bands.band(97.0), bands.band(1e9)),
            (0, 1, 10, 10)
        );
        assert_eq!((bands.label(0), bands.label(1)), ("-10".to_string(), "0".to_string()));
        assert!(!bands.exceeded());
        let cut = Bands::of(Field {
            name: "s",
            unit: "MPa",
            values: &values,
            range: Some([0.0, 50.0]),
            colours: Colours::Fire,
        });
        assert!(cut.exceeded() && cut.band(97.0) == cut.count - 1 && cut.band(-3.0) == 0);
        for values in [vec![], vec![5.0; 3], vec![0.0; 2], vec![f64::NAN]] {
            let bands = Bands::of(Field {
                name: "s",
                unit: "",
                values: &values,
                range: None,
                colours: Colours::Spectrum,
            });
            assert!(bands.count == 1 && bands.step > 0.0, "{values:?}");
        }
    }

    #[test]
    fn bodies_are_grouped_by_the_stem_of_their_names() {
        let names = ["COLUMN", "BEAM_R", "BOLT_RP1", "BOLT_RP2", "BEAM2", "9A"].map(String::from);
        let groups = Groups::of(&names);
        assert_eq!(groups.names, ["COLUMN", "BEAM", "BOLT", "9A"]);
        assert_eq!(groups.of_body, [0, 1, 2, 2, 1, 3]);
    }
}
