//! Thicknesses of plates that are in stock.

use bracket_base::units::limits;

/// Thicknesses of hot-rolled plate that merchants keep \[mm\].
const STOCK: [f64; 19] = [
    4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 50.0, 60.0, 80.0, 100.0,
    120.0, 150.0, 200.0,
];
/// Step beyond the thickest of them \[mm\].
const STEP: f64 = 50.0;

/// The thinnest plate in stock that is at least `x` \[mm\] thick.
pub(super) fn stock(x: f64) -> f64 {
    let listed = STOCK.into_iter().find(|t| limits::at_most(x, *t));
    listed.unwrap_or_else(|| (x / STEP - limits::SLACK).ceil() * STEP)
}
