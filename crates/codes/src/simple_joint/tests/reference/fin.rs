//! A fin plate.

use super::{Expected, GM2, Joint, R3, bearing, spacing};
use crate::check::CheckId;
use crate::subject::Part;
use bracket_joint::assembly::SupportElement;

/// Its utilisations.
pub fn fin(j: &Joint<'_>, out: &mut Expected) {
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
        out.push(((CheckId::WeldDirectional, None), j.weld(weaker, [n, v, foot])));
    }
}
