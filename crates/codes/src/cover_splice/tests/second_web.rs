//! The web in the second implementation: every bolt as a vector.

use super::second::{Case, Holed, Table, chi, holes};
use crate::check::CheckId;
use bracket_joint::spec::connection::BoltCategory;

/// All numbers of the web of a member and of its covers.
pub(super) fn web(c: &Case<'_>, out: &mut Table) {
    let (e, m, f, n, v) = (c.e, c.m, &c.e.factors, c.n, c.v);
    let root3 = 3f64.sqrt();
    let p = &m.section;
    let (area, inertia, hw) = (100.0 * p.area, 1e4 * p.i_y, p.h - 2.0 * p.tf);
    let points: Vec<[f64; 2]> = holes(&e.web_columns, &e.web_rows);
    let k = points.len() as f64;
    let mid = [0, 1].map(|i| points.iter().map(|q| q[i]).sum::<f64>() / k);
    let polar: f64 = points.iter().map(|q| (q[0] - mid[0]).powi(2) + (q[1] - mid[1]).powi(2)).sum();
    let mut n_w = n * hw * p.tw / area;
    if c.contact && n < 0.0 {
        n_w *= 0.25;
    }
    let (mut fx, mut fz, mut fr, mut m_w) = (0f64, 0f64, 0f64, 0f64);
    for my in &c.senses {
        for turn in [v * mid[0], -v * mid[0]] {
            let m_g = my * hw.powi(3) * p.tw / 12.0 / inertia + n_w * (m.axis - mid[1]) + turn;
            m_w = m_w.max(m_g.abs());
            for q in &points {
                let x = n_w / k + m_g * (q[1] - mid[1]) / polar;
                let z = v / k + (m_g * (q[0] - mid[0]) / polar).abs();
                (fx, fz, fr) = (fx.max(x.abs()), fz.max(z), fr.max(x.hypot(z)));
            }
        }
    }
    if fr == 0.0 {
        return;
    }
    let ends = [0, 1].map(|i| {
        let all = points.iter().map(|q| q[i]);
        [all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max)]
    });
    let [[xa, xb], [za, zb]] = ends;
    let r = 2.0 * c.one_plane((xb - xa).hypot(zb - za), m.web_packs);
    c.put(out, "web bolts", CheckId::SpliceBoltShear, [fr, r]);
    if e.category == Some(BoltCategory::C) {
        c.put(out, "web bolts", CheckId::SlipUltimate, [fr, c.slip(2.0)]);
    }
    let (ws, cs) = (&m.web_steel, &e.web.steel);
    let z_edges = [e.web_middle - e.web.width / 2.0, e.web_middle + e.web.width / 2.0];
    let both: Vec<[f64; 2]> = points.iter().flat_map(|q| [*q, [-q[0], q[1]]]).collect();
    let swap = |all: &[[f64; 2]]| -> Vec<[f64; 2]> { all.iter().map(|q| [q[1], q[0]]).collect() };
    let none = [f64::NEG_INFINITY, f64::INFINITY];
    let reach = [-e.web.length / 2.0, e.web.length / 2.0];
    let to_gap = [e.gap / 2.0, f64::INFINITY];
    let any = [true, true];
    let in_web = |points, u, v| Holed { points, u, v, t: p.tw, fu: ws.fu.mpa() }.bearing(e, any);
    let t = e.web.thickness;
    let in_cover = |points, u, v| Holed { points, u, v, t, fu: cs.fu.mpa() }.bearing(e, any);
    if fx > 0.0 {
        let id = CheckId::BearingResistance;
        c.put(out, "web", id, [fx, in_web(points.clone(), to_gap, none)]);
        c.put(out, "web covers", id, [fx / 2.0, in_cover(both.clone(), reach, z_edges)]);
    }
    if fz > 0.0 {
        let id = CheckId::BearingAcross;
        c.put(out, "web", id, [fz, in_web(swap(&points), none, to_gap)]);
        // across the member, a bolt has its neighbours on its own side of the gap
        let r = in_cover(swap(&points), z_edges, [f64::NEG_INFINITY, e.web.length / 2.0]);
        c.put(out, "web covers", id, [fz / 2.0, r]);
    }
    let (n_r, n_c) = (e.web_rows.len() as f64, e.web_columns.len() as f64);
    let (t2, h) = (2.0 * e.web.thickness, e.web.width);
    let (gross, net) = (t2 * h, t2 * (h - n_r * e.hole));
    let (fy, fu) = (cs.fy.mpa(), cs.fu.mpa());
    let out_of_cover = e.web.length / 2.0 - xa - (n_c - 0.5) * e.hole;
    let out_of_web = xb - e.gap / 2.0 - (n_c - 0.5) * e.hole;
    let v_rd = gross * fy / 1.27 / root3 / f.gamma_m0;
    if v > 0.0 {
        c.put(out, "web covers", CheckId::WebCoverShear, [v, v_rd]);
        let id = CheckId::WebCoverNetShear;
        c.put(out, "web covers", id, [v, net.max(0.0) * fu / root3 / f.gamma_m2]);
        let edge = (za - z_edges[0]).min(z_edges[1] - zb);
        let down = edge + zb - za - (n_r - 0.5) * e.hole;
        let id = CheckId::BlockTearingAcross;
        c.put(out, "web covers", id, [v, c.block(t2, out_of_cover / 2.0, down, fy, fu)]);
        let a_v = (area - 2.0 * p.b * p.tf + (p.tw + 2.0 * p.r) * p.tf).max(hw * p.tw);
        let r = (a_v - n_r * e.hole * p.tw).max(0.0) * ws.fu.mpa() / root3 / f.gamma_m2;
        c.put(out, "web", CheckId::WebNetShear, [v, r]);
        if n_r > 1.5 {
            let down = zb - za - (n_r - 1.0) * e.hole;
            let r = c.block(p.tw, out_of_web / 2.0, down, ws.fy.mpa(), ws.fu.mpa());
            c.put(out, "web", id, [v, r]);
        }
    }
    if n_w > 0.0 {
        c.put(out, "web covers", CheckId::CoverTension, [n_w, c.tension(gross, net, fy, fu)]);
        let (a, a_net) = (hw * p.tw, p.tw * (hw - n_r * e.hole));
        let r = c.tension(a, a_net, ws.fy.mpa(), ws.fu.mpa());
        c.put(out, "web", CheckId::WebTension, [n_w, r]);
        if n_r > 1.5 {
            let pulled = zb - za - (n_r - 1.0) * e.hole;
            let id = CheckId::BlockTearing;
            let r = c.block(t2, pulled, 2.0 * out_of_cover, fy, fu);
            c.put(out, "web covers", id, [n_w, r]);
            let r = c.block(p.tw, pulled, 2.0 * out_of_web, ws.fy.mpa(), ws.fu.mpa());
            c.put(out, "web", id, [n_w, r]);
        }
    }
    if n_w != 0.0 || m_w != 0.0 {
        let used = |a: f64, w: f64, f: f64| (n_w.abs() / a + m_w / w) / f;
        let rho = if v > v_rd / 2.0 { (2.0 * v / v_rd - 1.0).powi(2).min(1.0) } else { 0.0 };
        let (w, f_yd) = (t2 * h * h / 6.0, fy / f.gamma_m0);
        let u = used(gross, w, (1.0 - rho) * f_yd);
        c.put(out, "web covers", CheckId::WebCoverBending, [u, 1.0]);
        let lost: f64 = e
            .web_rows
            .iter()
            .map(|z| t2 * e.hole.powi(3) / 12.0 + t2 * e.hole * (z - e.web_middle).powi(2))
            .sum();
        let w_net = (t2 * h.powi(3) / 12.0 - lost) * 2.0 / h;
        let u = used(net, w_net, 0.9 * fu / f.gamma_m2);
        c.put(out, "web covers", CheckId::WebCoverNetBending, [u, 1.0]);
        let mut xs: Vec<f64> = both.iter().map(|q| q[0]).collect();
        xs.sort_by(f64::total_cmp);
        let free = xs.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
        if free / e.web.thickness > 9.0 * (235.0 / fy).sqrt() {
            let u = used(gross, w, chi(free, e.web.thickness, fy) * fy / f.gamma_m1);
            c.put(out, "web covers", CheckId::WebCoverBuckling, [u, 1.0]);
        }
    }
}
