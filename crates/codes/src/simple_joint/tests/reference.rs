//! A second implementation of the checks of simple joints: plain numbers, from the clauses, by other
//! ways of computing them. It shares no function with the first one.

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

    fn weld(&self, t: f64, weaker: (f64, f64), [n, v, m]: [f64; 3]) -> f64 {
        let (a, beta) = (self.e.throat, weaker.1);
        let l = self.hp - 2.0 * a;
        let _ = t;
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
        SimpleKind::FinPlate => fin(&j, &mut out),
        SimpleKind::HeaderPlate => header(&j, &mut out),
    }
    notches(&j, &mut out);
    let b = &e.beam;
    let eps = (235.0 / j.web.0).sqrt();
    let slender = (b.h - 2.0 * b.tf) / b.tw;
    if j.v != 0.0 && slender > 72.0 * eps {
        let lambda = slender / 86.4 / eps;
        let chi = if lambda < 0.83 { 1.0 } else { 0.83 / lambda };
        let r = chi * (b.h - 2.0 * b.tf) * b.tw * j.web.0 / R3;
        out.push(((CheckId::BeamShearBuckling, Some(Part::BeamWeb)), j.v.abs() / r));
    }
    out
}

fn fin(j: &Joint<'_>, out: &mut Expected) {
    let e = j.e;
    let mut say = |id, part: Part, used: f64| out.push(((id, Some(part)), used));
    let (plate, web) = (Part::FinPlate, Part::BeamWeb);
    let (n, v) = (j.n, j.v);
    let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
    let (xc, zc) = (mean(&e.columns), mean(&e.rows));
    let m = j.moment(xc, zc);
    // rotation of the group about its centre
    let stiffness: f64 = e.columns.iter().map(|x| (x - xc).powi(2)).sum::<f64>() * j.n1
        + e.rows.iter().map(|z| (z - zc).powi(2)).sum::<f64>() * j.n2;
    let turn = if m == 0.0 { 0.0 } else { m / stiffness };
    let count = j.n1 * j.n2;
    let mut forces = Vec::new();
    for x in &e.columns {
        for z in &e.rows {
            forces.push([n / count + turn * (z - zc), v / count - turn * (x - xc)]);
        }
    }
    let width = e.columns[e.columns.len() - 1] - e.columns[0];
    let size = n.hypot(v);
    let length = if size > 0.0 { (n.abs() * width + v.abs() * j.p) / size } else { j.p };
    let most = |f: &dyn Fn(&[f64; 2]) -> f64| forces.iter().map(f).fold(0.0, f64::max);
    let acts = n != 0.0 || v != 0.0 || m != 0.0;
    let (p1, p2) = (spacing(&e.rows), spacing(&e.columns));
    let e1p = (e.top - e.rows[0]).min(e.rows[e.rows.len() - 1] - e.bottom);
    let e2p = e.width - e.columns[e.columns.len() - 1];
    let edge = [e.beam.h / 2.0 - e.notches[0].depth, e.beam.h / 2.0 - e.notches[1].depth];
    let e1w = (edge[0] - e.rows[0]).min(e.rows[e.rows.len() - 1] + edge[1]);
    let e2w = e.columns[0] - e.beam_start;
    if acts {
        let one = j.shear_of_bolt(length);
        say(CheckId::BoltInGroup, Part::Bolts, most(&|f| f[0].hypot(f[1])) / one);
        for (part, steel, e1, e2) in [(plate, j.plate, e1p, e2p), (web, j.web, e1w, e2w)] {
            let ver = bearing(j, steel, [Some(e1), p1], [Some(e2), p2], true);
            let hor = bearing(j, steel, [Some(e2), p2], [Some(e1), p1], true);
            let used = most(&|f| ((f[1] / ver).powi(2) + (f[0] / hor).powi(2)).sqrt());
            say(CheckId::BearingInGroup, part, used);
        }
    }
    let (fy, fu, t) = j.plate;
    let lines = width + e2p - (j.n2 - 0.5) * j.d0;
    let gross = j.hp * t * fy / (1.27 * R3);
    let net = (j.hp - j.n1 * j.d0).max(0.0) * t * fu / (R3 * GM2);
    let block = 0.5 * fu * t * lines.max(0.0) / GM2 + fy * t * j.plate_line() / R3;
    let on_web = j.web_shears();
    if v != 0.0 {
        for (part, [g, n, b]) in [(plate, [gross, net, block]), (web, on_web)] {
            say(CheckId::GrossShear, part, v.abs() / g);
            say(CheckId::NetShear, part, v.abs() / n);
            say(CheckId::BlockTearing, part, v.abs() / b);
        }
    }
    let zm = (e.top + e.bottom) / 2.0;
    let bent = [j.moment(0.0, zm), j.moment(xc, zm)].map(f64::abs);
    let bent = bent[0].max(bent[1]);
    let w = t * j.hp * j.hp / 6.0;
    if bent != 0.0 {
        if n == 0.0 && v != 0.0 && j.hp >= 2.73 * bent / v.abs() {
            say(CheckId::PlateBending, plate, 2.73 * bent / v.abs() / j.hp);
        } else {
            say(CheckId::PlateBending, plate, bent / (w * fy) + n.abs() / (j.hp * t * fy));
        }
        if xc > t / 0.15 {
            let lambda = 2.8 * (e.columns[0] * j.hp / 1.5).sqrt() / t;
            let pe = std::f64::consts::PI.powi(2) * 205e3 / lambda.powi(2);
            let plateau = 0.4 * (std::f64::consts::PI.powi(2) * 205e3 / fy).sqrt();
            let eta = match lambda / plateau {
                r if r <= 1.0 => 0.0,
                r if r <= 2.0 => 0.014 * (lambda - plateau),
                r if r <= 3.0 => 0.014 * plateau,
                _ => 0.007 * (lambda - plateau),
            };
            // the smaller root of (p_E − p) (p_y − p) = η p_E p
            let half = (fy + (1.0 + eta) * pe) / 2.0;
            let p = (half - (half * half - pe * fy).sqrt()).min(fy);
            say(CheckId::PlateBuckling, plate, bent * 0.6 / (w * p));
        }
    }
    let (wfy, wfu, wt) = j.web;
    let at_last =
        j.moment(e.columns[e.columns.len() - 1], (e.rows[0] + e.rows[e.rows.len() - 1]) / 2.0);
    if xc > t / 0.15 && !j.is_notched() && at_last != 0.0 && j.n1 > 1.0 {
        let deep = width + e2w;
        let face = |l: f64, holes: f64| {
            (l * wt * wfy / R3).min((l - holes * j.d0).max(0.0) * wt * wfu / (R3 * GM2))
        };
        let (ab, bc) = (face(deep, j.n2 - 0.5), face(j.p, j.n1 - 1.0));
        let least = on_web[0].min(on_web[1]);
        let on_bc = (v.abs() - least + bc).max(0.0);
        let mut mc = wt * wfy * j.p * j.p / 6.0;
        if on_bc > bc / 2.0 {
            let r = v.abs() / least;
            let rho = if r > 0.5 { (2.0 * r - 1.0).powi(2) } else { 0.0 };
            mc = mc.min(1.5 * mc * (1.0 - rho).max(0.0));
        }
        say(CheckId::WebBending, web, at_last.abs() / (mc + ab * j.p));
    }
    if n > 0.0 {
        let eccentric =
            v != 0.0 || j.moment(xc, (e.rows[0] + e.rows[e.rows.len() - 1]) / 2.0) != 0.0;
        let part_of = if eccentric { 0.5 } else { 1.0 };
        let shears = [[gross, net, block], on_web];
        let plies = [(plate, j.plate, e2p), (web, j.web, e2w)];
        for ((part, (fy, fu, t), e2), [g, nt, b]) in plies.into_iter().zip(shears) {
            let pull = (j.hp * t * fy).min(0.9 * (j.hp - j.n1 * j.d0).max(0.0) * t * fu / GM2);
            let sides = (width + e2 - (j.n2 - 0.5) * j.d0).max(0.0);
            let middle = (j.p - (j.n1 - 1.0) * j.d0).max(0.0);
            let torn = part_of * fu * t * middle / GM2 + 2.0 * fy * t * sides / R3;
            say(CheckId::NetTension, part, n / pull);
            say(CheckId::BlockTearing, part, n / torn);
            if v != 0.0 {
                let both = (n / pull).hypot(v / g.min(nt));
                say(CheckId::ShearAndTension, part, both);
                say(CheckId::BlockShearAndTension, part, n / torn + v.abs() / b);
            }
        }
    }
    let sup = match e.support.element {
        SupportElement::ColumnFlange => Part::ColumnFlange,
        SupportElement::ColumnWeb => Part::ColumnWeb,
        SupportElement::BeamWeb => Part::SupportingWeb,
    };
    if sup != Part::ColumnFlange {
        let most = e.support.section.tw * j.sup.1 / (fy * GM2);
        say(CheckId::SupportPunching, sup, t / most);
        if v != 0.0 {
            let r = 2.0 * j.hp * e.support.section.tw * j.sup.0 / R3;
            say(CheckId::SupportShear, sup, v.abs() / r);
        }
    } else if n > 0.0 {
        let r = j.hp * e.support.section.tw * j.sup.0;
        say(CheckId::SupportTension, Part::ColumnWeb, n / r);
    }
    let foot = j.moment(0.0, zm);
    if n != 0.0 || v != 0.0 || foot != 0.0 {
        let weaker = if j.sup.1 < j.plate.1 { &e.support.steel } else { &e.plate_steel };
        let weaker = (weaker.fu.mpa(), weaker.beta_w.unwrap_or(f64::NAN));
        out.push(((CheckId::WeldDirectional, None), j.weld(t, weaker, [n, v, foot])));
    }
}

fn header(j: &Joint<'_>, out: &mut Expected) {
    let e = j.e;
    let (n, v) = (j.n, j.v);
    let (fy, fu, t) = j.plate;
    let sup = match e.support.element {
        SupportElement::ColumnFlange => Part::ColumnFlange,
        SupportElement::ColumnWeb => Part::ColumnWeb,
        SupportElement::BeamWeb => Part::SupportingWeb,
    };
    let mut say = |id, part: Part, used: f64| out.push(((id, Some(part)), used));
    let plate = Part::HeaderPlate;
    let one = j.shear_of_bolt(j.p);
    let (p1, p2) = (spacing(&e.rows), spacing(&e.columns));
    let outer = e.columns[e.columns.len() - 1];
    let inner = e.columns.iter().map(|y| y.abs()).fold(f64::INFINITY, f64::min);
    let e1 = (e.top - e.rows[0]).min(e.rows[e.rows.len() - 1] - e.bottom);
    let e2 = e.width / 2.0 - outer;
    if v != 0.0 {
        say(CheckId::BoltGroupShear, Part::Bolts, v.abs() / (0.8 * j.n1 * j.n2 * one));
        // the plate: rows at its ends, the rest between
        let side = [Some(e2), p2];
        let end = bearing(j, j.plate, [Some(e1), p1], side, true);
        let mid = if j.n1 > 2.0 { bearing(j, j.plate, [None, p1], side, true) } else { end };
        let sum = match mid.max(end) <= one {
            true => j.n2 * (2.0f64.min(j.n1) * end + (j.n1 - 2.0).max(0.0) * mid),
            false => j.n1 * j.n2 * end.min(mid),
        };
        say(CheckId::BearingOfGroup, plate, v.abs() / sum);
        let edge = match e.support.element {
            SupportElement::ColumnFlange => Some(e.support.section.b / 2.0 - outer),
            _ => None,
        };
        let each = bearing(j, j.sup, [None, p1], [edge, p2], true);
        say(CheckId::BearingOfGroup, sup, v.abs() / (j.n1 * j.n2 * each));
        say(CheckId::GrossShear, plate, v.abs() * 1.27 * R3 / (2.0 * j.hp * t * fy));
        let net = 2.0 * (j.hp - j.n1 * j.d0).max(0.0) * t * fu / (R3 * GM2);
        say(CheckId::NetShear, plate, v.abs() / net);
        let p3 = 2.0 * e.columns.iter().map(|y| y.abs()).sum::<f64>() / j.n2;
        let bends = j.hp < 1.36 * p3;
        let half = if bends && j.n1 > 1.0 { 0.5 } else { 1.0 };
        let across = (outer - inner + e2 - (j.n2 / 2.0 - 0.5) * j.d0).max(0.0);
        let block = 2.0 * t * (half * fu * across / GM2 + fy * j.plate_line() / R3);
        say(CheckId::BlockTearing, plate, v.abs() / block);
        if bends {
            let r = 4.0 * t * j.hp * j.hp / 6.0 * fy / (p3 - e.beam.tw);
            say(CheckId::PlateBending, plate, v.abs() / r);
        }
        let web = 0.9 * j.hp * j.web.2 * j.web.0 / R3;
        say(CheckId::WebAtPlate, Part::BeamWeb, v.abs() / web);
        if j.is_notched() {
            say(CheckId::GrossShear, Part::BeamWeb, v.abs() / j.web_shears()[0]);
        }
    }
    if n > 0.0 {
        let b = &e.bolt;
        let points = b.head_corners / b.head_width;
        let dm = b.head_width.min(b.nut_width) * (1.0 + points) / 2.0;
        let pull = 0.9 * e.grade.fub * b.stress_area / GM2;
        let punch = |(_, fu, t): Steel| 0.6 * std::f64::consts::PI * dm * t * fu / GM2;
        let pull = pull.min(punch(j.plate)).min(punch(j.sup));
        let m = inner - e.beam.tw / 2.0 - 0.8 * 2f64.sqrt() * e.throat;
        let edge = e.width / 2.0 - inner;
        let nn = edge.min(1.25 * m);
        let reach = (2.0 * m + 0.625 * edge).min(std::f64::consts::PI * m);
        let mut length = 2.0 * reach.min(e1);
        for w in e.rows.windows(2) {
            length += 2.0 * reach.min((w[0] - w[1]) / 2.0);
        }
        let mpl = length * t * t * fy / 4.0;
        let all = 2.0 * j.n1 * pull;
        let ew = b.washer_outer / 4.0;
        let modes = [
            (8.0 * nn - 2.0 * ew) * mpl / (2.0 * m * nn - ew * (m + nn)),
            (2.0 * mpl + nn * all) / (m + nn),
            all,
        ];
        let least = modes.iter().copied().fold(f64::INFINITY, f64::min);
        say(CheckId::TStub, plate, n / least);
        let with_prying =
            if modes[0] <= least * (1.0 + 1e-12) { least + 2.0 * mpl / nn } else { all };
        let ft = n * with_prying.min(all) / least / (2.0 * j.n1);
        let fv = v.abs() / (j.n1 * j.n2);
        let used = (fv / one + ft / 1.4 / pull).max(ft / pull);
        say(CheckId::BoltShearAndTension, Part::Bolts, used);
        say(CheckId::BeamWebTension, Part::BeamWeb, n / (j.hp * j.web.2 * j.web.0));
    }
    if n != 0.0 || v != 0.0 {
        let weaker = if j.plate.1 < j.web.1 { &e.plate_steel } else { &e.beam_steel };
        let weaker = (weaker.fu.mpa(), weaker.beta_w.unwrap_or(f64::NAN));
        let used = j.weld(j.web.2, weaker, [n, 1.27 * v, 0.0]);
        out.push(((CheckId::WeldDirectional, None), used));
    }
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
