//! Random splices.

use super::fixture::{CATALOG, RECOMMENDED, actions, member, steel};
use bracket_joint::assembly::{CoverPlate, CoverSplice, InnerCovers, SpliceUse};
use bracket_joint::spec::code::{FySource, PartialFactors};
use bracket_joint::spec::connection::BoltCategory;
use bracket_joint::spec::loads::LimitState;

/// Numbers that a seed determines.
pub(super) struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// A number between 0 and 1.
    pub fn part(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.part()
    }

    pub fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[(self.part() * all.len() as f64) as usize % all.len()]
    }

    pub fn chance(&mut self, part: f64) -> bool {
        self.part() < part
    }

    /// Places from `first` on with `count` places and pitches in a range.
    fn places(&mut self, first: f64, count: usize, pitch: [f64; 2]) -> Vec<f64> {
        let mut out = vec![first];
        for _ in 1..count {
            out.push(out[out.len() - 1] + self.between(pitch[0], pitch[1]));
        }
        out
    }
}

/// A splice of a seed: of sections of class 1 and 2, with all kinds of covers, packs and actions.
pub(super) fn random(seed: u64) -> CoverSplice {
    let mut d = Dice::new(seed);
    let profiles = ["IPE300", "IPE500", "HEB400", "UB457x191x67", "HEB200", "HEB600"];
    let steels = ["S235", "S275", "S355"];
    let profile = d.one_of(&profiles);
    let grade = d.one_of(&steels);
    let mut left = member(profile, steel(grade, 12.0));
    left.web_steel = steel(d.one_of(&steels), 9.0);
    let mut right = left.clone();
    if d.chance(0.4) {
        right = member(d.one_of(&profiles), steel(d.one_of(&steels), 12.0));
        right.axis = if d.chance(0.5) { 0.0 } else { d.between(-30.0, 30.0) };
        right.packs = [d.between(0.0, 20.0), d.between(0.0, 20.0)];
        right.inner_packs = d.between(0.0, 12.0);
        right.web_packs = d.between(0.0, 12.0);
    }
    let size = d.one_of(&["M12", "M16", "M20", "M24"]);
    let bolt = CATALOG.bolt(size).expect("a size").clone();
    let hole = if d.chance(0.7) { bolt.hole_normal } else { bolt.hole_oversize };
    let gap = d.between(2.0, 20.0);
    // the outermost bolts lie inside the narrower flange
    let widest = left.section.b.min(right.section.b) - 2.6 * hole;
    let two = widest > 8.5 * hole && d.chance(0.7);
    let gauge = d.between(3.0 * hole, if two { 0.5 * widest } else { widest });
    let gauges = match two {
        true => vec![gauge, widest.min(gauge + d.between(4.5, 7.0) * hole)],
        false => vec![gauge],
    };
    let outermost = gauges[gauges.len() - 1];
    let edge = |d: &mut Dice| d.between(1.3 * hole, 3.0 * hole);
    let first = 0.5 * gap + edge(&mut d);
    let count = 1 + (d.part() * 5.0) as usize;
    let flange_rows = d.places(first, count, [2.3 * hole, 5.0 * hole]);
    let last = flange_rows[flange_rows.len() - 1];
    let plate = |thickness, width, length, steel| CoverPlate { thickness, width, length, steel };
    let cover_steel = steel(d.one_of(&steels), 12.0);
    let outer = plate(
        d.between(6.0, 25.0),
        outermost + 2.0 * edge(&mut d),
        2.0 * (last + edge(&mut d)),
        cover_steel.clone(),
    );
    let inner = d.chance(0.5).then(|| {
        let from = 0.5 * gauge - d.between(1.0, 1.8) * hole;
        let width = 0.5 * outermost + edge(&mut d) - from;
        let steel = steel(d.one_of(&steels), 12.0);
        let length = 2.0 * (last + edge(&mut d));
        InnerCovers { plate: plate(d.between(6.0, 20.0), width, length, steel), from }
    });
    let rows = 1 + (d.part() * 5.0) as usize;
    let columns = if rows == 1 { 2 } else { 1 + (d.part() * 3.0) as usize };
    let bottom = -d.between(40.0, 180.0);
    let web_rows = d.places(bottom, rows, [2.3 * hole, 6.0 * hole]);
    let first = 0.5 * gap + edge(&mut d);
    let web_columns = d.places(first, columns, [2.5 * hole, 6.0 * hole]);
    let web_middle = 0.5 * (web_rows[0] + web_rows[rows - 1]) + d.between(-5.0, 5.0);
    let height = web_rows[rows - 1] - web_rows[0] + 10.0 + 2.0 * edge(&mut d);
    let length = 2.0 * (web_columns[columns - 1] + edge(&mut d));
    let web = plate(d.between(5.0, 15.0), height, length, cover_steel);
    let sign = |d: &mut Dice| if d.chance(0.5) { 1.0 } else { -1.0 };
    let load = [
        sign(&mut d) * d.between(0.0, 8e5),
        sign(&mut d) * d.between(0.0, 4e5),
        sign(&mut d) * d.between(0.0, 4e8),
    ];
    let load = load.map(|x| if d.chance(0.15) { 0.0 } else { x });
    let state = LimitState::Ultimate;
    let used = match d.part() {
        p if p < 0.5 => SpliceUse::Beam,
        p if p < 0.75 => SpliceUse::Column { contact: true },
        _ => SpliceUse::Column { contact: false },
    };
    let factors = PartialFactors {
        gamma_m0: d.between(1.0, 1.1),
        gamma_m1: d.between(1.0, 1.2),
        gamma_m2: d.between(1.1, 1.3),
        ..RECOMMENDED
    };
    CoverSplice {
        used,
        left,
        right,
        gap,
        outer,
        inner,
        web,
        web_middle,
        flange_rows,
        gauges,
        web_rows,
        web_columns,
        grade: CATALOG.bolt_grade(d.one_of(&["5.6", "8.8", "10.9"])).expect("a grade").clone(),
        hole,
        flange_grip: 40.0,
        web_grip: 30.0,
        not_checked: Vec::new(),
        actions: vec![actions("A", load, state)],
        preload: Some(1e5),
        category: Some(d.one_of(&[BoltCategory::A, BoltCategory::C])),
        mu: d.between(0.2, 0.5),
        unseen: Vec::new(),
        annex: None,
        fy_source: FySource::Table31,
        factors,
        bolt,
    }
}
