//! A second implementation of the strength of a splice, in plain numbers and with another
//! structure: holes are points of plates, and every bolt looks for its own edges and neighbours. It
//! shares no function with the first.

use super::random::random;
use super::second_web::web;
use crate::check::{Check, CheckId};
use crate::cover_splice::splice_checks;
use bracket_joint::assembly::{CoverSplice, SpliceUse, SplicedMember};
use bracket_joint::spec::connection::BoltCategory;
use std::collections::BTreeMap;

/// Demand and resistance of each check, by subject and id.
pub(super) type Table = BTreeMap<(String, CheckId), [f64; 2]>;

/// A plate with holes, seen along a force: u along it, v across it. An infinite edge is none.
pub(super) struct Holed {
    pub points: Vec<[f64; 2]>,
    pub u: [f64; 2],
    pub v: [f64; 2],
    pub t: f64,
    pub fu: f64,
}

impl Holed {
    /// Least bearing resistance when every bolt may press towards lower and higher u, as told.
    pub fn bearing(&self, e: &CoverSplice, ways: [bool; 2]) -> f64 {
        let same = |a: f64, b: f64| (a - b).abs() < 1e-9;
        let d0 = e.hole;
        let wide = if d0 > e.bolt.hole_normal + 1e-9 { 0.8 } else { 1.0 };
        let mut least = f64::INFINITY;
        for p in &self.points {
            let mut alpha: f64 = 1.0f64.min(e.grade.fub / self.fu);
            let along = self.points.iter().filter(|q| same(q[1], p[1])).map(|q| q[0] - p[0]);
            let along: Vec<f64> = along.filter(|x| x.abs() > 1e-9).collect();
            for (k, sign) in [(0, -1.0), (1, 1.0)] {
                if !ways[k] {
                    continue;
                }
                let next = along.iter().map(|x| sign * x).filter(|x| *x > 0.0);
                let next = next.fold(f64::INFINITY, f64::min);
                if next.is_finite() {
                    alpha = alpha.min(next / (3.0 * d0) - 0.25);
                } else if (self.u[k] - p[0]).is_finite() {
                    alpha = alpha.min((self.u[k] - p[0]).abs() / (3.0 * d0));
                }
            }
            let across = self.points.iter().filter(|q| same(q[0], p[0]));
            let mut k1: f64 = 2.5;
            for q in across.map(|q| (q[1] - p[1]).abs()).filter(|x| *x > 1e-9) {
                k1 = k1.min(1.4 * q / d0 - 1.7);
            }
            for edge in self.v.iter().map(|v| (v - p[1]).abs()).filter(|x| x.is_finite()) {
                k1 = k1.min(2.8 * edge / d0 - 1.7);
            }
            let one = wide * k1 * alpha * self.fu * e.bolt.d * self.t / e.factors.gamma_m2;
            least = least.min(one.max(0.0));
        }
        least
    }
}

fn least_moment(e: &CoverSplice) -> [f64; 2] {
    let of = |m: &SplicedMember| {
        let fyd = m.flange_steel.fy.mpa() / e.factors.gamma_m0;
        [1e3 * m.section.w_pl_y * fyd / 4.0, 1e2 * m.section.area * fyd / 40.0]
    };
    let (l, r) = (of(&e.left), of(&e.right));
    [l[0].min(r[0]), l[1].min(r[1])]
}

pub(super) fn chi(length: f64, t: f64, fy: f64) -> f64 {
    let slender = 0.6 * length * 12f64.sqrt() / t / (std::f64::consts::PI * (2.1e5 / fy).sqrt());
    let phi = 0.5 + 0.245 * (slender - 0.2) + 0.5 * slender.powi(2);
    1f64.min(1.0 / (phi + (phi.powi(2) - slender.powi(2)).sqrt()))
}

/// A member under the actions of a splice.
pub(super) struct Case<'a> {
    pub e: &'a CoverSplice,
    pub m: &'a SplicedMember,
    /// Stands before the parts.
    name: &'a str,
    pub contact: bool,
    pub n: f64,
    pub v: f64,
    /// The moment about the axis of the member, in either sense where the least one acts.
    pub senses: Vec<f64>,
    pub normal: bool,
}

impl<'a> Case<'a> {
    fn new(e: &'a CoverSplice, m: &'a SplicedMember, name: &'a str) -> Self {
        let [force, moment] = e.actions[0].at(1.0);
        let (n, mut v, my) = (force[0], force[2].abs(), moment[1]);
        let mut senses = vec![my];
        if e.used == (SpliceUse::Column { contact: false }) {
            let [m_min, v_min] = least_moment(e);
            v = v.max(v_min);
            if my.abs() < m_min {
                senses = vec![-m_min, m_min];
            }
        }
        let senses: Vec<f64> = senses.iter().map(|x| x - n * m.axis).collect();
        let contact = e.used == SpliceUse::Column { contact: true };
        let normal = e.hole <= e.bolt.hole_normal + 1e-9;
        Self { e, m, name, contact, n, v, senses, normal }
    }

    pub fn put(&self, out: &mut Table, part: &str, id: CheckId, numbers: [f64; 2]) {
        let key = (format!("splice, {}{part}", self.name), id);
        let old = out.insert(key.clone(), numbers);
        // the worse of two counts
        if let Some(old) = old.filter(|o| o[0] / o[1] > numbers[0] / numbers[1]) {
            out.insert(key, old);
        }
    }

    pub fn one_plane(&self, length: f64, pack: f64) -> f64 {
        let e = self.e;
        let small = e.bolt.d <= 14.0 && !self.normal && e.grade.grade != "5.6";
        let alpha_v = if e.grade.grade == "10.9" { 0.5 } else { 0.6 };
        let long = (1.0 - (length - 15.0 * e.bolt.d) / (200.0 * e.bolt.d)).clamp(0.75, 1.0);
        let packs = if pack > e.bolt.d / 3.0 {
            9.0 * e.bolt.d / (8.0 * e.bolt.d + 3.0 * pack)
        } else {
            1.0
        };
        let all = long * packs * if small { 0.85 } else { 1.0 };
        all * alpha_v * e.grade.fub * e.bolt.stress_area / e.factors.gamma_m2
    }

    pub fn slip(&self, surfaces: f64) -> f64 {
        let ks = if self.normal { 1.0 } else { 0.85 };
        ks * surfaces * self.e.mu * 1e5 / self.e.factors.gamma_m3
    }

    pub fn tension(&self, gross: f64, net: f64, fy: f64, fu: f64) -> f64 {
        let f = &self.e.factors;
        let net = net.max(0.0);
        let r = (gross * fy / f.gamma_m0).min(0.9 * net * fu / f.gamma_m2);
        let no_slip = self.e.category == Some(BoltCategory::C);
        if no_slip { r.min(net * fy / f.gamma_m0) } else { r }
    }

    pub fn block(&self, t: f64, tension: f64, shear: f64, fy: f64, fu: f64) -> f64 {
        let f = &self.e.factors;
        let torn = tension.max(0.0) * t * fu / f.gamma_m2;
        torn + shear.max(0.0) * t * fy / 3f64.sqrt() / f.gamma_m0
    }
}

pub(super) fn holes(xs: &[f64], ys: &[f64]) -> Vec<[f64; 2]> {
    xs.iter().flat_map(|x| ys.iter().map(move |y| [*x, *y])).collect()
}

/// All numbers of the flanges of a member.
fn flanges(c: &Case<'_>, out: &mut Table) {
    let (e, m, f, n) = (c.e, c.m, &c.e.factors, c.n);
    let p = &m.section;
    let (area, inertia, hw) = (100.0 * p.area, 1e4 * p.i_y, p.h - 2.0 * p.tf);
    let mut ys: Vec<f64> = e.gauges.iter().flat_map(|g| [g / 2.0, -g / 2.0]).collect();
    ys.sort_by(f64::total_cmp);
    let (per_row, rows) = (ys.len() as f64, e.flange_rows.len());
    let count = per_row * rows as f64;
    let planes = if e.inner.is_some() { 2.0 } else { 1.0 };
    let (x0, x1) = (e.flange_rows[0], e.flange_rows[rows - 1]);
    let mirrored: Vec<f64> =
        e.flange_rows.iter().rev().map(|x| -x).chain(e.flange_rows.iter().copied()).collect();
    let free = mirrored.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
    for (sign, flange, pack) in
        [(1.0, "upper flange", m.packs[0]), (-1.0, "lower flange", m.packs[1])]
    {
        let share = 1.0 - hw.powi(3) * p.tw / 12.0 / inertia;
        let forces: Vec<f64> = c
            .senses
            .iter()
            .map(|my| sign * my * share / (p.h - p.tf) + n * (1.0 - hw * p.tw / area) / 2.0)
            .collect();
        let pulled = forces.iter().copied().fold(0.0, f64::max);
        let pushed = forces.iter().map(|x| -x).fold(0.0, f64::max);
        let by_covers = match c.contact {
            true => 0.25 * (-n).max(0.0) * (1.0 - hw * p.tw / area) / 2.0,
            false => pushed,
        };
        let most = pulled.max(by_covers);
        let bolts = format!("{flange}, flange bolts");
        if most > 0.0 {
            let r = planes * c.one_plane(x1 - x0, pack.max(m.inner_packs));
            c.put(out, &bolts, CheckId::SpliceBoltShear, [most / count, r]);
            if e.category == Some(BoltCategory::C) {
                c.put(out, &bolts, CheckId::SlipUltimate, [most / count, c.slip(planes)]);
            }
        }
        let fl = &m.flange_steel;
        let inside: Vec<f64> = ys.iter().copied().filter(|y| *y > 0.0).collect();
        let half = |w: f64| [-w / 2.0, w / 2.0];
        let infinite = f64::INFINITY;
        // name, thickness, f_u, share, edges across, columns, end that tension presses
        let mut plies = vec![
            (String::from(flange), p.tf, fl.fu.mpa(), 1.0, half(p.b), ys.clone(), None),
            (
                format!("{flange}, outer cover"),
                e.outer.thickness,
                e.outer.steel.fu.mpa(),
                1.0 / planes,
                half(e.outer.width),
                ys.clone(),
                Some(e.outer.length / 2.0),
            ),
        ];
        if let Some(i) = &e.inner {
            plies.push((
                format!("{flange}, inner covers"),
                i.plate.thickness,
                i.plate.steel.fu.mpa(),
                0.5,
                [i.from, i.from + i.plate.width],
                inside.clone(),
                Some(i.plate.length / 2.0),
            ));
        }
        for (part, t, fu, share, v, columns, end) in plies {
            for (force, tension) in [(pulled, true), (by_covers, false)] {
                if force == 0.0 {
                    continue;
                }
                // a cover has the holes of both sides; tension presses its far end, compression the
                // gap; a flange is pressed to its end at the gap, or away from it
                let (xs, u, ways) = match (end, tension) {
                    (Some(end), true) => (e.flange_rows.clone(), [-infinite, end], [false, true]),
                    (Some(_), false) => (mirrored.clone(), [-infinite, infinite], [true, false]),
                    (None, true) => (e.flange_rows.clone(), [e.gap / 2.0, infinite], [true, false]),
                    (None, false) => (e.flange_rows.clone(), [-infinite, infinite], [false, true]),
                };
                let mut r = Holed { points: holes(&xs, &columns), u, v, t, fu }.bearing(e, ways);
                if rows == 1 && e.inner.is_none() {
                    r = r.min(1.5 * fu * e.bolt.d * t / f.gamma_m2);
                }
                c.put(out, &part, CheckId::BearingResistance, [share * force / count, r]);
            }
        }
        let steel = (fl.fy.mpa(), fl.fu.mpa());
        let cut = (x1 - e.gap / 2.0) - (rows as f64 - 0.5) * e.hole;
        let (gross, net) = (p.b * p.tf, p.tf * (p.b - per_row * e.hole));
        if pushed > 0.0 {
            let area = if c.normal { gross } else { net };
            let r = area * steel.0 / f.gamma_m0;
            c.put(out, flange, CheckId::FlangeCompression, [pushed, r]);
        }
        if pulled > 0.0 {
            c.put(
                out,
                flange,
                CheckId::FlangeTension,
                [pulled, c.tension(gross, net, steel.0, steel.1)],
            );
            let first = gross * steel.0 / f.gamma_m0 / (0.9 * net * steel.1 / f.gamma_m2);
            c.put(out, flange, CheckId::FlangeYieldsFirst, [first, 1.0]);
            // both halves beside the web, without the holes of their columns but half of the last
            let torn = p.b - e.gauges[0] - (per_row - 1.0) * e.hole;
            c.put(
                out,
                flange,
                CheckId::BlockTearing,
                [pulled, c.block(p.tf, torn, 2.0 * cut, steel.0, steel.1)],
            );
        }
        let g = [e.gauges[0], e.gauges[e.gauges.len() - 1]];
        let outer = (&e.outer, 1.0, "outer cover");
        let inner = e.inner.as_ref().map(|i| (&i.plate, 2.0, "inner covers"));
        for (plate, number, part) in std::iter::once(outer).chain(inner) {
            let part = format!("{flange}, {part}");
            let (fy, fu) = (plate.steel.fy.mpa(), plate.steel.fu.mpa());
            let gross = number * plate.width * plate.thickness;
            let net = gross - per_row * e.hole * plate.thickness;
            if pulled > 0.0 {
                let r = c.tension(gross, net, fy, fu);
                c.put(out, &part, CheckId::CoverTension, [pulled / planes, r]);
                let line = plate.length / 2.0 - x0 - (rows as f64 - 0.5) * e.hole;
                let torn = match &e.inner {
                    Some(i) if number > 1.0 => {
                        let lost = (per_row / 2.0 - 0.5) * e.hole;
                        let out_of = [i.from + plate.width - g[0] / 2.0, g[1] / 2.0 - i.from];
                        let mut all: Vec<[f64; 2]> =
                            out_of.iter().map(|w| [2.0 * (w - lost), 2.0 * line]).collect();
                        if per_row > 2.0 {
                            all.push([g[1] - g[0] - 2.0 * e.hole, 4.0 * line]);
                        }
                        all
                    }
                    _ => vec![
                        [g[1] - (per_row - 1.0) * e.hole, 2.0 * line],
                        [plate.width - g[0] - (per_row - 1.0) * e.hole, 2.0 * line],
                    ],
                };
                let r = torn.iter().map(|[a, b]| c.block(plate.thickness, *a, *b, fy, fu));
                let r = r.fold(f64::INFINITY, f64::min);
                c.put(out, &part, CheckId::BlockTearing, [pulled / planes, r]);
            }
            if by_covers > 0.0 {
                let area = if c.normal { gross } else { net };
                let mut r = area * fy / f.gamma_m0;
                if free / plate.thickness > 9.0 * (235.0 / fy).sqrt() {
                    r = r.min(chi(free, plate.thickness, fy) * gross * fy / f.gamma_m1);
                }
                c.put(out, &part, CheckId::CoverCompression, [by_covers / planes, r]);
            }
        }
    }
}

/// Ids that both implementations have.
const IDS: [CheckId; 18] = [
    CheckId::SpliceBoltShear,
    CheckId::SlipUltimate,
    CheckId::BearingResistance,
    CheckId::BearingAcross,
    CheckId::BlockTearing,
    CheckId::BlockTearingAcross,
    CheckId::FlangeTension,
    CheckId::FlangeCompression,
    CheckId::FlangeYieldsFirst,
    CheckId::CoverTension,
    CheckId::CoverCompression,
    CheckId::WebTension,
    CheckId::WebNetShear,
    CheckId::WebCoverShear,
    CheckId::WebCoverNetShear,
    CheckId::WebCoverBending,
    CheckId::WebCoverNetBending,
    CheckId::WebCoverBuckling,
];

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) || a == b || !(a.is_finite() || b.is_finite())
}

/// 400 random splices: the same checks, with the same demands and resistances.
#[test]
fn a_second_implementation_gives_the_same_numbers() {
    let mut seen: BTreeMap<CheckId, usize> = BTreeMap::new();
    for seed in 1..=400 {
        let e = random(seed);
        let mut want = Table::new();
        let names = match e.left == e.right {
            true => vec![(&e.left, "")],
            false => vec![(&e.left, "left member, "), (&e.right, "right member, ")],
        };
        for (member, name) in names {
            let case = Case::new(&e, member, name);
            flanges(&case, &mut want);
            web(&case, &mut want);
        }
        let all = splice_checks(&e).checks;
        let of_case = |c: &&Check| c.case.is_some() && IDS.contains(&c.id());
        let got: Vec<&Check> = all.iter().filter(of_case).collect();
        assert_eq!(got.len(), want.len(), "seed {seed}: {:?}", {
            let named: Vec<_> = got.iter().map(|c| (c.subject.to_string(), c.id())).collect();
            (want.keys().filter(|k| !named.contains(k)).collect::<Vec<_>>(), named)
        });
        for check in got {
            let key = (check.subject.to_string(), check.id());
            let [demand, resistance] = *want.get(&key).unwrap_or_else(|| panic!("{seed} {key:?}"));
            let infinite = |x: Option<f64>| x.unwrap_or(f64::INFINITY);
            // where two positions compare, the worse one counts: by utilisation
            let ok = close(infinite(check.demand), demand)
                && close(infinite(check.resistance), resistance);
            let sentence = check.sentence();
            assert!(ok, "seed {seed}: {key:?} {demand} {resistance}: {sentence}");
            *seen.entry(check.id()).or_default() += 1;
        }
    }
    // every check occurs often
    for id in IDS {
        assert!(seen.get(&id).is_some_and(|n| *n > 60), "{id:?}: {seen:?}");
    }
}
