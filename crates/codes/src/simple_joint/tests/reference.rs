//! A second implementation of the checks of simple joints: plain numbers, from the clauses, by
//! other ways of computing them. It shares no function with the first one.

mod fin;
mod header;

use crate::check::CheckId;
use crate::subject::Part;
use bracket_joint::assembly::{PlaneActions, SimpleJoint, SimpleKind, SupportElement};

/// Utilisations by what is checked; several of one kind in no order.
pub type Expected = Vec<((CheckId, Option<Part>), f64)>;

/// f_y, f_u and thickness of a ply.
type Steel = (f64, f64, f64);

/// A joint with its numbers by their symbols.
struct Joint<'a> {
    e: &'a SimpleJoint,
    n1: f64,
    n2: f64,
    d0: f64,
    hp: f64,
    /// Spread of the rows.
    p: f64,
    plate: Steel,
    web: Steel,
    sup: Steel,
    n: f64,
    v: f64,
    my: f64,
}

const GM2: f64 = 1.25;
const R3: f64 = 1.732_050_807_568_877_2;

fn spacing(of: &[f64]) -> Option<f64> {
    let mut sorted = of.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.windows(2).map(|w| w[1] - w[0]).min_by(f64::total_cmp)
}

/// F_b,Rd for end distance, pitch, edge distance and pitch across; `None` where there is none.
fn bearing(
    j: &Joint<'_>,
    (_, fu, t): Steel,
    end: [Option<f64>; 2],
    side: [Option<f64>; 2],
    lap: bool,
) -> f64 {
    let fub = j.e.grade.fub;
    let mut alpha: f64 = 1.0f64.min(fub / fu);
    if let Some(e1) = end[0] {
        alpha = alpha.min(e1 / 3.0 / j.d0);
    }
    if let Some(p1) = end[1] {
        alpha = alpha.min(p1 / 3.0 / j.d0 - 0.25);
    }
    let mut k1: f64 = 2.5;
    if let Some(e2) = side[0] {
        k1 = k1.min(2.8 * e2 / j.d0 - 1.7);
    }
    if let Some(p2) = side[1] {
        k1 = k1.min(1.4 * p2 / j.d0 - 1.7);
    }
    let unit = fu * j.e.bolt.d * t / GM2;
    let found = (k1 * alpha * unit).max(0.0);
    if lap && end[1].is_none() { found.min(1.5 * unit) } else { found }
}

impl<'a> Joint<'a> {
    fn new(e: &'a SimpleJoint, a: &PlaneActions) -> Self {
        let [[n, _, v], [_, my, _]] = a.live;
        let of = |s: &bracket_joint::strength::Strength, t| (s.fy.mpa(), s.fu.mpa(), t);
        let sup = match e.support.element {
            SupportElement::ColumnFlange => e.support.section.tf,
            _ => e.support.section.tw,
        };
        Self {
            e,
            n1: e.rows.len() as f64,
            n2: e.columns.len() as f64,
            d0: e.hole,
            hp: e.top - e.bottom,
            p: e.rows[0] - e.rows[e.rows.len() - 1],
            plate: of(&e.plate_steel, e.thickness),
            web: of(&e.beam_steel, e.beam.tw),
            sup: of(&e.support.steel, sup),
            n,
            v,
            my,
        }
    }

    /// Moment at a section, from the equilibrium of the piece between it and the bolt plane.
    fn moment(&self, x: f64, z: f64) -> f64 {
        let plane = match self.e.kind {
            SimpleKind::FinPlate => self.e.columns.iter().sum::<f64>() / self.n2,
            SimpleKind::HeaderPlate => 0.0,
        };
        self.my + (x - plane) * self.v - z * self.n
    }

    fn shear_of_bolt(&self, length: f64) -> f64 {
        let (d, g) = (self.e.bolt.d, &self.e.grade);
        let long = (1.075 - length / (200.0 * d)).clamp(0.75, 1.0);
        long * g.alpha_v_thread * g.fub * self.e.bolt.stress_area / GM2
    }

    /// A_v, W, A and centroid of what notches of these depths leave, by strips cut at all levels.
    fn cut(&self, depth: [f64; 2]) -> [f64; 4] {
        let b = &self.e.beam;
        let (top, bottom) = (b.h / 2.0 - depth[0], depth[1] - b.h / 2.0);
        let mut levels = vec![(bottom, top, b.tw)];
        let mut av = b.tw * (top - bottom);
        for (i, d) in depth.into_iter().enumerate() {
            if d == 0.0 {
                let z = if i == 0 { b.h / 2.0 - b.tf } else { -b.h / 2.0 };
                // beside the web, so that nothing counts twice
                levels.push((z, z + b.tf, b.b - b.tw));
                av += (b.r - b.tw / 2.0) * b.tf;
            }
        }
        let area: f64 = levels.iter().map(|(l, u, w)| w * (u - l)).sum();
        let first: f64 = levels.iter().map(|(l, u, w)| w * (u * u - l * l) / 2.0).sum();
        let second: f64 = levels.iter().map(|(l, u, w)| w * (u.powi(3) - l.powi(3)) / 3.0).sum();
        let z = first / area;
        let w = (second - area * z * z) / (top - z).max(z - bottom);
        [av, w, area, z]
    }

    fn depths(&self, reach: f64) -> [f64; 2] {
        self.e.notches.map(|n| if n.length >= reach - 1e-9 { n.depth } else { 0.0 })
    }

    fn is_notched(&self) -> bool {
        self.e.notches.iter().any(|n| n.depth > 0.0)
    }

    fn web_shears(&self) -> [f64; 3] {
        let (fy, fu, t) = self.web;
        let b = &self.e.beam;
        let av = if self.is_notched() {
            self.cut(self.e.notches.map(|n| n.depth))[0]
        } else {
            let rolled = 100.0 * b.area - 2.0 * b.b * b.tf + (b.tw + 2.0 * b.r) * b.tf;
            rolled.max((b.h - 2.0 * b.tf) * b.tw)
        };
        let net = (av - self.n1 * self.d0 * t).max(0.0);
        let last = self.e.columns[self.e.columns.len() - 1] - self.e.beam_start;
        let (side, reach) = if self.v <= 0.0 {
            (0, self.e.beam.h / 2.0 - self.e.rows[self.e.rows.len() - 1])
        } else {
            (1, self.e.rows[0] + self.e.beam.h / 2.0)
        };
        let notch = &self.e.notches[side];
        let open = notch.depth > 0.0 && notch.length >= last;
        let line = match open {
            true => reach - notch.depth - (self.n1 - 0.5) * self.d0,
            false => reach - (self.n1 - 1.0) * self.d0,
        };
        let pulled = last - (self.n2 - 0.5) * self.d0;
        let block = 0.5 * fu * t * pulled.max(0.0) / GM2 + fy * t * line.max(0.0) / R3;
        [av * fy / R3, net * fu / (R3 * GM2), block]
    }

    fn plate_line(&self) -> f64 {
        let e = self.e;
        let from =
            if self.v <= 0.0 { e.rows[0] - e.bottom } else { e.top - e.rows[e.rows.len() - 1] };
        (from - (self.n1 - 0.5) * self.d0).max(0.0)
    }

    fn weld(&self, weaker: (f64, f64), [n, v, m]: [f64; 3]) -> f64 {
        let (a, beta) = (self.e.throat, weaker.1);
        let l = self.hp - 2.0 * a;
        let across = (n.abs() / l + 6.0 * m.abs() / (l * l)) / 2.0 / (2f64.sqrt() * a);
        let along = v.abs() / l / 2.0 / a;
        let equivalent = (4.0 * across * across + 3.0 * along * along).sqrt();
        (equivalent * beta * GM2 / weaker.0).max(across * GM2 / (0.9 * weaker.0))
    }
}

/// All utilisations under a load case.
pub fn expected(e: &SimpleJoint, a: &PlaneActions) -> Expected {
    let j = Joint::new(e, a);
    let mut out = Vec::new();
    match e.kind {
        SimpleKind::FinPlate => fin::fin(&j, &mut out),
        SimpleKind::HeaderPlate => header::header(&j, &mut out),
    }
    notches(&j, &mut out);
    out
}

fn notches(j: &Joint<'_>, out: &mut Expected) {
    let e = j.e;
    let there: Vec<f64> = e.notches.iter().filter(|n| n.depth > 0.0).map(|n| n.length).collect();
    if there.is_empty() {
        return;
    }
    let web = Some(Part::BeamWeb);
    let last = e.columns[e.columns.len() - 1] - e.beam_start;
    let several = e.kind == SimpleKind::FinPlate && j.n2 > 1.0;
    let mut cuts: Vec<(CheckId, f64, bool)> = there
        .iter()
        .map(|l| (CheckId::NotchMoment, *l, several && l - last < 2.0 * e.bolt.d))
        .collect();
    if several && there.iter().any(|l| *l > last) {
        cuts.push((CheckId::LastLineMoment, last, true));
    }
    for (id, at, torn) in cuts {
        let [av, w, area, z] = j.cut(j.depths(at));
        let m = j.moment(e.beam_start + at, z);
        if m == 0.0 && j.n == 0.0 {
            continue;
        }
        let mut vpl = av * j.web.0 / R3;
        if torn {
            vpl = vpl.min(j.web_shears()[2]);
        }
        let r = j.v.abs() / vpl;
        let left = if r > 0.5 { (1.0 - (2.0 * r - 1.0).powi(2)).max(0.0) } else { 1.0 };
        out.push(((id, web), m.abs() / (w * left * j.web.0) + j.n.abs() / (area * j.web.0)));
    }
    let deepest = e.notches.iter().map(|n| n.depth).fold(0.0, f64::max);
    let most = if there.len() > 1 { e.beam.h / 5.0 } else { e.beam.h / 2.0 };
    out.push(((CheckId::NotchDepth, web), deepest / most));
    let (slender, c) = if j.web.0 <= 275.0 { (54.3, 160e3) } else { (48.0, 110e3) };
    let ratio = e.beam.h / e.beam.tw;
    let most = if ratio <= slender { e.beam.h } else { c * e.beam.h / ratio / ratio / ratio };
    out.push(((CheckId::NotchLength, web), there.iter().copied().fold(0.0, f64::max) / most));
}
