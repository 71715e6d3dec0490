//! The checks of random joints against the second implementation.

use super::fixture::{CATALOG, actions, fin_plate, header_plate, part_of, steel};
use super::reference::expected;
use crate::check::{Check, CheckId, Topic};
use crate::simple_joint::simple_checks;
use crate::subject::Part;
use bracket_joint::assembly::{Notch, SimpleJoint, SimpleKind, Support, SupportElement};
use std::collections::BTreeMap;

/// Random numbers that are the same everywhere: a linear congruential generator.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    pub fn within(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * (self.next() as f64 / f64::from(1u32 << 31))
    }

    pub fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.next() as usize % of.len()]
    }
}

const BEAMS: [&str; 6] = ["IPEA550", "IPE300", "IPE400", "IPE600", "HEA300", "UB533x210x92"];
const COLUMNS: [&str; 4] = ["HEB200", "HEB300", "HEA240", "IPE500"];

/// A random joint of a kind, with one load case; its bolts lie in the plies.
pub fn random(kind: SimpleKind, dice: &mut Dice) -> SimpleJoint {
    let grades = ["S235", "S275", "S355"];
    let fin = kind == SimpleKind::FinPlate;
    let beam = CATALOG.profile(dice.pick(&BEAMS)).expect("a profile").clone();
    let section = CATALOG.profile(dice.pick(&COLUMNS)).expect("a profile").clone();
    let element = dice.pick(&[
        SupportElement::ColumnFlange,
        SupportElement::ColumnWeb,
        SupportElement::BeamWeb,
    ]);
    let bolt = CATALOG.bolt(dice.pick(&["M16", "M20", "M24"])).expect("a size").clone();
    let grade = CATALOG.bolt_grade(dice.pick(&["4.6", "8.8", "10.9"])).expect("a grade").clone();
    let thickness = dice.within(6.0, 20.0);
    let hole = bolt.hole_normal;
    let room = beam.h - 2.0 * (beam.tf + beam.r) - 4.0 * hole;
    let most = ((room / (2.3 * hole)) as usize + 1).clamp(1, 6);
    let several = if fin { dice.pick(&[1, 1, 2, 3]) } else { dice.pick(&[2, 2, 4]) };
    let least = if fin && several == 1 { 2.min(most) } else { 1 };
    let all: Vec<usize> = (least..=most).collect();
    let n1 = dice.pick(&all);
    let p1 = dice.within(2.2, (room / hole / n1 as f64).clamp(2.3, 5.0)) * hole;
    let uneven = dice.pick(&[0.0, 0.0, 0.2]) * hole;
    let mut rows: Vec<f64> =
        (0..n1).map(|i| -p1 * i as f64 - uneven * (i * i) as f64 / 9.0).collect();
    let shift = -0.5 * (rows[0] + rows[n1 - 1]) + dice.within(-0.3, 0.3) * hole;
    rows.iter_mut().for_each(|z| *z += shift);
    let start = if fin { dice.within(10.0, 30.0) } else { thickness };
    let step = dice.within(2.4, 4.0) * hole;
    let columns: Vec<f64> = match (kind, several) {
        (SimpleKind::FinPlate, n) => {
            let first = start + dice.within(1.2, 3.0) * hole;
            (0..n).map(|i| first + step * i as f64).collect()
        }
        (_, 2) => {
            let y = dice.within(35.0, 75.0);
            vec![-y, y]
        }
        _ => {
            let y = dice.within(35.0, 60.0);
            vec![-y - step, -y, y, y + step]
        }
    };
    let last = columns[columns.len() - 1];
    let e2 = dice.within(1.2, 3.0) * hole;
    // no deeper than the end distance of the bolts allows
    let deep = 0.5 * beam.h - rows[0].abs().max(rows[n1 - 1].abs()) - 1.2 * hole;
    let depths = [(); 2].map(|()| dice.pick(&[0.0, 0.0, 1.0]) * deep.max(0.0));
    let notches = depths.map(|depth| match depth > 0.0 {
        true => Notch { length: (last - start).max(40.0) + dice.within(-8.0, 120.0), depth },
        false => Notch::default(),
    });
    let t_sup = match element {
        SupportElement::ColumnFlange => section.tf,
        _ => section.tw,
    };
    let mut e = SimpleJoint {
        kind,
        beam_steel: steel(dice.pick(&grades), beam.tw),
        plate_steel: steel(dice.pick(&grades), thickness),
        support: Support { element, steel: steel(dice.pick(&grades), t_sup), section },
        width: if fin { last + e2 } else { 2.0 * (last + e2) },
        top: rows[0] + dice.within(1.2, 3.0) * hole,
        bottom: rows[n1 - 1] - dice.within(1.2, 3.0) * hole,
        throat: dice.within(3.0, 8.0),
        beam,
        bolt,
        grade,
        thickness,
        rows,
        columns,
        hole,
        beam_start: start,
        notches,
        ..if fin { fin_plate() } else { header_plate() }
    };
    let v = dice.pick(&[-1.0, -1.0, -1.0, 1.0, 0.0]) * dice.within(50e3, 900e3);
    let n = dice.pick(&[0.0, 0.0, 1.0, -1.0]) * dice.within(10e3, 400e3);
    // no moment at the face of the support, or any
    let (at_face, any) = (v * e.centre(), dice.within(-3e7, 3e7));
    let my = match kind {
        SimpleKind::FinPlate => dice.pick(&[0.0, at_face, at_face, any]),
        SimpleKind::HeaderPlate => 0.0,
    };
    e.actions = vec![actions([n, 0.0, v], [0.0, my, 0.0])];
    e
}

/// What the reference has: numbers against a resistance, but for the limits of spacing, tools and
/// sizes that belong to no load and are those of end plates too.
fn compared(check: &Check) -> bool {
    let sizes = [CheckId::LeastThroat, CheckId::LeastWeldLength, CheckId::WeldFullStrength];
    let limits = matches!(check.topic, Topic::Detailing | Topic::Ductility);
    check.utilisation.is_some() && !limits && !sizes.contains(&check.id())
}

type Sorted = BTreeMap<String, Vec<f64>>;

fn sorted(all: impl IntoIterator<Item = ((CheckId, Option<Part>), f64)>) -> Sorted {
    let mut out = Sorted::new();
    for (key, value) in all {
        out.entry(format!("{key:?}")).or_default().push(value);
    }
    out.values_mut().for_each(|v| v.sort_by(f64::total_cmp));
    out
}

#[test]
fn random_joints_by_two_implementations() {
    let mut hits: BTreeMap<String, usize> = BTreeMap::new();
    for kind in [SimpleKind::FinPlate, SimpleKind::HeaderPlate] {
        for seed in 0..300 {
            let e = random(kind, &mut Dice::new(seed));
            let found = simple_checks(&e).checks;
            let key = |c: &Check| match c.id() {
                CheckId::WeldDirectional => (c.id(), None),
                id => (id, part_of(c)),
            };
            let got = found.iter().filter(|c| compared(c));
            let got = sorted(got.map(|c| (key(c), c.utilisation.expect("compared"))));
            // a resistance of zero has no utilisation
            let want = expected(&e, &e.actions[0]).into_iter();
            let want = sorted(want.filter(|(_, used)| used.is_finite()));
            let keys = |s: &Sorted| s.iter().map(|(k, v)| (k.clone(), v.len())).collect::<Vec<_>>();
            assert_eq!(keys(&got), keys(&want), "{kind:?} {seed}: {e:#?}");
            for (key, values) in &got {
                for (a, b) in values.iter().zip(&want[key]) {
                    assert!(
                        (a - b).abs() <= 1e-9 * b.abs(),
                        "{kind:?} {seed} {key}: {a} {b}\n{e:#?}"
                    );
                }
                *hits.entry(format!("{kind:?} {key}")).or_default() += values.len();
            }
        }
    }
    // every formula is met often enough to count
    let ids = |kind: &str| hits.keys().filter(|k| k.starts_with(kind)).count();
    assert!(hits.values().all(|n| *n >= 10), "{hits:#?}");
    assert_eq!((ids("FinPlate"), ids("HeaderPlate")), (28, 18), "{hits:#?}");
}
