//! Length of a bolt for the thickness that it clamps.

use crate::check::{Check, CheckId, Status, Topic, within};
use crate::formula::Traced;
use crate::subject::Subject;
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::catalog::BoltSize;

/// Stocked lengths of hexagon bolts \[mm\].
///
/// # Source
/// ISO 4014 / ISO 4017, preferred lengths.
const LENGTHS: [f64; 34] = [
    20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 55.0, 60.0, 65.0, 70.0, 80.0, 90.0, 100.0, 110.0,
    120.0, 130.0, 140.0, 150.0, 160.0, 180.0, 200.0, 220.0, 240.0, 260.0, 280.0, 300.0, 320.0,
    340.0, 360.0, 380.0, 400.0, 420.0, 440.0,
];

/// Elongation length of a bolt \[mm\]: `L_b` = grip + washers + half of head and nut.
///
/// # Source
/// EN 1993-1-8:2005 6.2.4 (Table 6.2, note on L_b) and Table 6.11 (k10).
pub fn elongation_length(bolt: &BoltSize, grip: f64, washers: u32) -> f64 {
    grip + f64::from(washers) * bolt.washer_thickness + 0.5 * (bolt.head_height + bolt.nut_height)
}

/// Least nominal length of a bolt \[mm\]: grip, washers, nut and at least one thread of protrusion.
///
/// # Source
/// EN 1090-2 8.2.2: one full thread protrudes from the nut.
pub fn least_length(bolt: &BoltSize, grip: f64, washers: u32) -> Worked {
    let length = |name: &'static str, value: f64| Traced::length(name, value);
    let washers = Traced::number("n_w", f64::from(washers)) * length("t_w", bolt.washer_thickness);
    let (nut, pitch) = (length("nut", bolt.nut_height), length("pitch", bolt.pitch));
    let value = length("grip", grip) + washers + nut + pitch;
    Worked::of("EN 1090-2 8.2.2", CheckId::BoltLength, "l", value, Unit::Length)
}

/// The shortest stocked length that suffices \[mm\]; `None` beyond the longest.
pub fn stocked_length(least: f64) -> Option<f64> {
    LENGTHS.into_iter().find(|l| within(least, *l))
}

/// Thread length of a bolt of the given length \[mm\]: b up to 125 mm, b + 6 mm up to 200 mm, b +
/// 19 mm above; never more than the bolt.
///
/// # Source
/// ISO 4014, reference length of thread b; `BoltSize::thread_length` is that up to 125 mm.
pub fn thread_length(bolt: &BoltSize, length: f64) -> f64 {
    let more = match length {
        l if l <= 125.0 => 0.0,
        l if l <= 200.0 => 6.0,
        _ => 19.0,
    };
    (bolt.thread_length + more).min(length)
}

/// Whether the nut tightens before it reaches the unthreaded shank: grip and washers must cover the
/// shank.
///
/// # Source
/// EN 1090-2 8.2.2: one full thread at least stays free between the bearing face of the nut and the
/// unthreaded shank.
pub fn shank_check(
    subject: Subject,
    bolt: &BoltSize,
    length: f64,
    grip: f64,
    washers: u32,
) -> Check {
    let [l, b] = [("l", length), ("b", thread_length(bolt, length))];
    let rule =
        Traced::length(l.0, l.1) - Traced::length(b.0, b.1) + Traced::length("pitch", bolt.pitch);
    let clamped = grip + f64::from(washers) * bolt.washer_thickness;
    let what = ("EN 1090-2 8.2.2", CheckId::FreeThread);
    let of = (Topic::Detailing, subject);
    Check::at_least(of, what, "grip + washers", rule, clamped, Status::Failed)
}
