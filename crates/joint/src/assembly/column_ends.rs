//! Where a column really ends above and below the axis of the beam.

use serde::Serialize;

/// Real ends of a column, from the axis of the beam \[mm\]; `None` where the column continues,
/// however long the modelled piece of it is.
///
/// Every distance and effective width at an end comes from here: bearing, block tearing, spacing,
/// T-stubs, compressed zones and the welds of stiffeners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ColumnEnds {
    /// Up to the upper end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub above: Option<f64>,
    /// Down to the lower end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub below: Option<f64>,
}

/// Direction along a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Up.
    Up,
    /// Down.
    Down,
}

impl Way {
    /// Direction of a vertical force, up positive; `None` of no force.
    pub fn of(force: f64) -> Option<Self> {
        match force {
            f if f > 0.0 => Some(Way::Up),
            f if f < 0.0 => Some(Way::Down),
            _ => None,
        }
    }
}

impl ColumnEnds {
    /// Distance from the height `z` above the axis of the beam to the end in a direction \[mm\],
    /// negative beyond the end; `None` where the column continues.
    pub fn from(self, z: f64, way: Way) -> Option<f64> {
        match way {
            Way::Up => self.above.map(|end| end - z),
            Way::Down => self.below.map(|end| end + z),
        }
    }

    /// The smaller of the distances from a height to the two ends \[mm\].
    pub fn nearest(self, z: f64) -> Option<f64> {
        let both = [Way::Up, Way::Down].map(|way| self.from(z, way));
        both.into_iter().flatten().reduce(f64::min)
    }

    /// `wanted` from a height in a direction, as far as the column reaches \[mm\]; not below 0.
    pub fn reach(self, z: f64, way: Way, wanted: f64) -> f64 {
        self.from(z, way).map_or(wanted, |end| wanted.min(end).max(0.0))
    }

    /// The ends upside down.
    #[must_use]
    pub fn mirrored(self) -> Self {
        Self { above: self.below, below: self.above }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_count_towards_the_real_end_alone() {
        let ends = ColumnEnds { above: None, below: Some(212.0) };
        assert_eq!(ends.from(-180.0, Way::Down), Some(32.0));
        assert_eq!(ends.from(-180.0, Way::Up), None);
        assert_eq!(ends.nearest(95.0), Some(307.0));
        assert_eq!(ends.reach(-180.0, Way::Down, 50.0), 32.0);
        assert_eq!(ends.reach(-180.0, Way::Up, 50.0), 50.0);
        assert_eq!(ends.reach(-300.0, Way::Down, 50.0), 0.0);
        assert_eq!(ends.mirrored().from(180.0, Way::Up), Some(32.0));
        assert_eq!(ColumnEnds::default().nearest(0.0), None);
        assert_eq!([-3.0, 0.0, 2.0].map(Way::of), [Some(Way::Down), None, Some(Way::Up)]);
    }
}
