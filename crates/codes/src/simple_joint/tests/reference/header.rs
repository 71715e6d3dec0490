//! A header plate.

use super::{Expected, GM2, Joint, R3, Steel, bearing, spacing};
use crate::check::CheckId;
use crate::subject::Part;
use bracket_joint::assembly::SupportElement;

/// Its utilisations.
pub fn header(j: &Joint<'_>, out: &mut Expected) {
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
        let used = j.weld(weaker, [n, 1.27 * v, 0.0]);
        out.push(((CheckId::WeldDirectional, None), used));
    }
}
