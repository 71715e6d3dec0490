//! A second implementation of the component method of a sloping or haunched beam, written from the
//! clauses alone, for one end plate on the flange of a continuing column.

use bracket_joint::assembly::EndPlate;
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

/// What the second implementation finds \[mm, N, N mm\].
pub struct Second {
    /// z, tension upwards, and force of the rows.
    pub rows: Vec<[f64; 2]>,
    /// Column web in compression.
    pub column_web: f64,
    /// Flange and web of the beam in compression.
    pub flange: f64,
    /// Column web panel in shear, not over β.
    pub panel: f64,
    /// M_c,Rd.
    pub beam: f64,
    /// M_j,Rd.
    pub moment: f64,
}

/// Flange at the plate: thickness, width, slope, c/t.
#[derive(Clone, Copy)]
struct Flange {
    t: f64,
    b: f64,
    slope: f64,
    outstand: f64,
}

struct Plates<'a> {
    e: &'a EndPlate,
    top: bool,
    bolt: f64,
    elongation: f64,
    rows: Vec<f64>,
    /// Middle of the flange in tension, centre of compression.
    up: f64,
    down: f64,
    /// m_x of z and m2 below the flange, both for z = 0.
    outer_face: f64,
    inner_face: f64,
    tw: f64,
    fy: f64,
    beta: f64,
    area: f64,
}

/// Circular and other patterns.
type Length = [f64; 2];

/// Leg of a fillet weld along the plate over its throat; `closes`: by how much the angle is below a
/// right one.
fn leg(closes: f64) -> f64 {
    if closes > 0.0 { 1.0 / ((FRAC_PI_2 - closes) / 2.0).cos() } else { SQRT_2 }
}

/// Figure 6.11 by bisection on the closed form of SCI P398, appendix G.
fn alpha(m: f64, e: f64, m2: f64) -> f64 {
    let (x, y) = (m / (m + e), m2 / (m + e));
    let curve = |a: f64| {
        let l1 = 1.25 / (a - 2.75);
        let l2 = a * l1 / 2.0;
        let rest = if y < l2 { ((l2 - y) / l2).powf(0.185 * a.powf(1.785)) } else { 0.0 };
        l1 + (1.0 - l1) * rest
    };
    let (mut low, mut high) = (4.0, 8.0);
    if curve(low) <= x || curve(high) >= x {
        return if curve(low) <= x { low } else { high };
    }
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        *(if curve(middle) > x { &mut low } else { &mut high }) = middle;
    }
    (low + high) / 2.0
}

impl Plates<'_> {
    fn inside(&self, i: usize) -> bool {
        self.rows[i] <= self.up
    }

    fn pitch(&self, i: usize) -> f64 {
        self.rows[i] - self.rows[i + 1]
    }

    /// Table 6.2.
    fn stub(&self, l: Length, [m, n]: [f64; 2], t: f64, fy: f64, rows: f64) -> f64 {
        let l1 = l[0].min(l[1]);
        let plastic = |l: f64| l * t * t * fy / (4.0 * self.e.factors.gamma_m0);
        let bolts = 2.0 * rows * self.bolt;
        let longest = 8.8 * m.powi(3) * self.e.bolt.stress_area * rows / (l1 * t.powi(3));
        if self.elongation > longest && !self.e.always_prying {
            return (2.0 * plastic(l1) / m).min(bolts);
        }
        let mode2 = (2.0 * plastic(l[1]) + n * bolts) / (m + n);
        (4.0 * plastic(l1) / m).min(mode2).min(bolts)
    }

    /// One row of a T-stub with α above and below it; `next` are the pitches to the rows of its
    /// group.
    fn row(m: f64, e: f64, beside: [Option<f64>; 2], next: [Option<f64>; 2]) -> Length {
        let a = beside.map(|m2| m2.map(|m2| alpha(m, e, m2)));
        match next {
            [None, None] => match [a[0], a[1]] {
                [None, None] => [2.0 * PI * m, 4.0 * m + 1.25 * e],
                [x, y] => [2.0 * PI * m, x.unwrap_or(0.0).max(y.unwrap_or(0.0)) * m],
            },
            [Some(p), Some(q)] => [p + q, (p + q) / 2.0],
            [None, Some(p)] | [Some(p), None] => {
                let a = if next[0].is_none() { a[0] } else { a[1] };
                let free = 2.0 * m + 0.625 * e;
                let straight = a.map_or(free + p / 2.0, |a| p / 2.0 + a * m - free);
                [PI * m + p, straight]
            }
        }
    }

    /// Least resistance of the components that the rows from `i` to `j` share; infinite where they
    /// share none.
    fn shared(&self, i: usize, j: usize) -> f64 {
        let (e, c) = (self.e, self.e.column.as_ref().expect("a column"));
        let (s, gamma, count) = (&c.section, e.factors.gamma_m0, (j - i + 1) as f64);
        let e_plate = (e.width - e.gauge) / 2.0;
        let e_column = (s.b - e.gauge) / 2.0;
        let least_e = e_plate.min(e_column);
        let next = |k: usize| [(k > i).then(|| self.pitch(k - 1)), (k < j).then(|| self.pitch(k))];
        let sum = |of: &dyn Fn(usize) -> Length| {
            (i..=j).map(of).fold([0.0; 2], |a, b| [a[0] + b[0], a[1] + b[1]])
        };
        let mut least = f64::INFINITY;
        // column flange, web
        let stiff = c.stiffener > 0.0;
        if !stiff || self.inside(i) == self.inside(j) {
            let m = (e.gauge - s.tw) / 2.0 - 0.8 * s.r;
            let free = |d: f64| d - c.stiffener / 2.0 - 0.8 * SQRT_2 * c.stiffener_throat;
            let beside = |k: usize| {
                let z = self.rows[k];
                let first = k == 0 || self.inside(k - 1) != self.inside(k);
                let last = k + 1 == self.rows.len() || self.inside(k + 1) != self.inside(k);
                match (stiff, self.inside(k)) {
                    (false, _) => [None, None],
                    (_, false) => [None, last.then(|| free(z - self.up))],
                    (_, true) => {
                        [first.then(|| free(self.up - z)), last.then(|| free(z - self.down))]
                    }
                }
            };
            let l = sum(&|k| Self::row(m, e_column, beside(k), next(k)));
            let n = least_e.min(1.25 * m);
            least = least.min(self.stub(l, [m, n], s.tf, c.steel.fy.mpa(), count));
            let b = l[0].min(l[1]);
            least = least.min(self.omega(b) * b * s.tw * c.steel.fy.mpa() / gamma);
        }
        // end plate, beam web
        if self.inside(i) && self.inside(j) {
            let m = (e.gauge - self.tw) / 2.0 - 0.8 * SQRT_2 * e.web_throat;
            let beside = |k: usize| {
                let first = k == 0 || !self.inside(k - 1);
                [first.then(|| self.inner_face - self.rows[k]), None]
            };
            let l = sum(&|k| Self::row(m, e_plate, beside(k), next(k)));
            let n = least_e.min(1.25 * m);
            least = least.min(self.stub(l, [m, n], e.thickness, e.plate_steel.fy.mpa(), count));
            least = least.min(l[0].min(l[1]) * self.tw * self.fy / gamma);
        } else if i == j {
            let (z, w) = (self.rows[i], e.gauge);
            let edge = if self.top { e.top } else { -e.bottom };
            let (mx, ex) = (z - self.outer_face, edge - z);
            let circular = (2.0 * PI * mx).min(PI * mx + w).min(PI * mx + 2.0 * e_plate);
            let half = 2.0 * mx + 0.625 * ex;
            let straight = (2.0 * half).min(e_plate + half).min(e.width / 2.0).min(w / 2.0 + half);
            let n = ex.min(1.25 * mx);
            let t = e.thickness;
            least =
                least.min(self.stub([circular, straight], [mx, n], t, e.plate_steel.fy.mpa(), 1.0));
        }
        least
    }

    /// Table 6.3.
    fn omega(&self, b: f64) -> f64 {
        let s = &self.e.column.as_ref().expect("a column").section;
        let x = (b * s.tw / self.area).powi(2);
        let one = 1.0 / (1.0 + 1.3 * x).sqrt();
        let two = 1.0 / (1.0 + 5.2 * x).sqrt();
        match self.beta {
            b if b <= 0.5 => 1.0,
            b if b <= 1.0 => one + 2.0 * (1.0 - b) * (1.0 - one),
            b => one + (b - 1.0) * (two - one),
        }
    }
}

/// The component method of an end plate; `top`: tension at the top.
pub fn second(e: &EndPlate, top: bool, beta: f64, bolt: f64, elongation: f64) -> Second {
    let c = e.column.as_ref().expect("a column");
    let (r, s, p) = (e.rafter.as_deref().expect("a rafter"), &c.section, &e.beam);
    let (gamma, fyc) = (e.factors.gamma_m0, c.steel.fy.mpa());
    let own =
        Flange { t: p.tf, b: p.b, slope: r.slope, outstand: ((p.b - p.tw) / 2.0 - p.r) / p.tf };
    let (mut low, mut tw, mut fy) = (own, p.tw, e.beam_steel.fy.mpa());
    if let Some(h) = &r.haunch {
        let outstand = (h.width - h.web) / 2.0 / h.flange;
        low = Flange { t: h.flange, b: h.width, slope: r.slope + h.angle, outstand };
        (tw, fy) = (tw.min(h.web), fy.min(h.steel.fy.mpa()));
    }
    // tension upwards: turned upside down a rising flange falls
    let turn = |f: Flange| Flange { slope: -f.slope, ..f };
    let (up, down) = if top { (own, low) } else { (turn(low), turn(own)) };
    let along = |f: Flange| f.t / f.slope.cos();
    let half = r.depth / 2.0;
    let (z_up, z_down) = (half - along(up) / 2.0, along(down) / 2.0 - half);
    let mut rows: Vec<f64> = e.rows.iter().map(|z| if top { *z } else { -z }).collect();
    rows.retain(|z| *z > z_down);
    rows.sort_by(|a, b| b.total_cmp(a));
    let a = e.flange_throat;
    let shear_area = {
        let (area, web) = (100.0 * s.area, (s.h - 2.0 * s.tf) * s.tw);
        (area - 2.0 * s.b * s.tf + (s.tw + 2.0 * s.r) * s.tf).max(web)
    };
    let j = Plates {
        e,
        top,
        bolt,
        elongation,
        rows,
        up: z_up,
        down: z_down,
        outer_face: half + 0.8 * leg(up.slope) * a,
        inner_face: half - along(up) - 0.8 * leg(-up.slope) * a,
        tw,
        fy,
        beta,
        area: shear_area,
    };
    // 6.2.6.2
    let bottom = if top { e.bottom } else { -e.top };
    let spread = (-half - bottom - SQRT_2 * a).clamp(0.0, e.thickness);
    let b_eff = along(down)
        + (leg(-down.slope) + leg(down.slope)) * a
        + 5.0 * (s.tf + s.r)
        + e.thickness
        + spread;
    let d = s.h - 2.0 * (s.tf + s.r);
    let young = e.beam_steel.e;
    let lambda = 0.932 * (b_eff * d * fyc / (young * s.tw * s.tw)).sqrt();
    let rho = if lambda > 0.72 { (lambda - 0.2) / (lambda * lambda) } else { 1.0 };
    let crush = j.omega(b_eff) * b_eff * s.tw * fyc;
    let mut web = (crush / gamma).min(rho * crush / e.factors.gamma_m1);
    let z_f = z_up - z_down;
    let mut panel = 0.9 * fyc * shear_area / (3f64.sqrt() * gamma);
    if c.stiffener > 0.0 {
        let t = c.stiffener;
        let eps = (235.0 / fyc).sqrt();
        let beside = (15.0 * eps * s.tw) + (15.0 * eps * s.tw).min((z_f - t) / 2.0);
        let area = (s.b - s.tw) * t + (beside + t) * s.tw;
        let inertia = t * s.b.powi(3) / 12.0 + beside * s.tw.powi(3) / 12.0;
        let slender = 0.75 * d / (inertia / area).sqrt() / (PI * (young / fyc).sqrt());
        let phi = (1.0 + 0.49 * (slender - 0.2) + slender * slender) / 2.0;
        let chi = (1.0 / (phi + (phi * phi - slender * slender).sqrt())).min(1.0);
        let cross = match slender <= 0.2 {
            true => area * fyc / gamma,
            false => chi * area * fyc / e.factors.gamma_m1,
        };
        web = web.max(cross);
        let plastic = |t: f64| s.b * t * t * fyc / 4.0 / gamma;
        let both = 2.0 * plastic(s.tf) + 2.0 * plastic(t);
        panel += (4.0 * plastic(s.tf)).min(both) / z_f;
    }
    let (beam, flange) = beam(e, [up, down], z_f, tw, fy);
    // 6.2.7.2
    let mut left = web.min(flange);
    if beta > 0.0 {
        left = left.min(panel / beta);
    }
    let mut found: Vec<[f64; 3]> = Vec::new();
    for k in 0..j.rows.len() {
        let lever = j.rows[k] - z_down;
        let mut force = j.shared(k, k);
        for i in 0..k {
            let above: f64 = found[i..].iter().map(|f| f[0]).sum();
            force = force.min(j.shared(i, k) - above);
        }
        for x in found.iter().filter(|x| x[0] > 1.9 * bolt * (1.0 + 1e-12)) {
            force = force.min(x[0] * lever / x[2]);
        }
        let grouped = force.max(0.0);
        let force = grouped.min(left).max(0.0);
        left -= force;
        found.push([grouped, force, lever]);
    }
    Second {
        rows: j.rows.iter().zip(&found).map(|(z, f)| [*z, f[1]]).collect(),
        column_web: web,
        flange,
        panel,
        beam,
        moment: found.iter().map(|f| f[1] * f[2]).sum(),
    }
}

/// M_c,Rd and F_c,fb,Rd.
fn beam(e: &EndPlate, [up, down]: [Flange; 2], z_f: f64, tw: f64, fy: f64) -> (f64, f64) {
    let (p, r) = (&e.beam, e.rafter.as_deref().expect("a rafter"));
    let eps = (235.0 / fy).sqrt();
    let gamma = e.factors.gamma_m0;
    let cut = |m: f64, b: f64, t: f64| {
        let force = m / z_f;
        if r.depth > 600.0 { force.min(b * t * fy / (0.8 * gamma)) } else { force }
    };
    let worst = |c: f64, w: f64, most: [f64; 2]| (c / most[0]).max(w / most[1]) / eps;
    let Some(h) = &r.haunch else {
        let (c, w) = (up.outstand, (p.h - 2.0 * (p.tf + p.r)) / p.tw);
        let m = match (worst(c, w, [10.0, 83.0]) <= 1.0, worst(c, w, [14.0, 124.0]) <= 1.0) {
            (true, _) => 1e3 * p.w_pl_y * fy,
            (_, true) => 1e3 * p.w_el_y * fy,
            _ => 1e3 * p.w_el_y * fy / worst(c, w, [14.0, 124.0]).powi(2),
        };
        return (m / gamma, cut(m / gamma, p.b, p.tf * r.slope.cos()));
    };
    let b = up.b.min(down.b);
    let t = (up.t * up.slope.cos()).min(down.t * down.slope.cos());
    let web = z_f - t;
    let w_pl = b * t * z_f + tw * web * web / 4.0;
    let inertia = (b * (z_f + t).powi(3) - (b - tw) * web.powi(3)) / 12.0;
    let w_el = inertia / ((z_f + t) / 2.0);
    // the flange between the webs: its lower face is the depth of the rafter below the upper face
    let of_haunch = r.depth - p.h / r.slope.cos() - h.flange / (r.slope + h.angle).cos();
    let panel = (p.h - 2.0 * (p.tf + p.r)).max(of_haunch) / tw;
    let c = up.outstand.max(down.outstand);
    let class = |flange: f64, bent: f64, pressed: f64| {
        (c / flange).max((web / tw / bent).min(panel / pressed)) / eps
    };
    let m = match (class(10.0, 83.0, 38.0) <= 1.0, class(14.0, 124.0, 42.0) <= 1.0) {
        (true, _) => w_pl * fy,
        (_, true) => w_el * fy,
        _ => w_el * fy / class(14.0, 124.0, 42.0).powi(2),
    };
    (m / gamma, cut(m / gamma, b, t))
}
