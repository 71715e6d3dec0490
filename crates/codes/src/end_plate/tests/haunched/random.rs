//! Haunched joints for the tests, given and random.

use bracket_joint::assembly::{EndPlate, Haunch, Rafter};
use bracket_joint::catalog::Catalog;

/// Random numbers by the generator of Numerical Recipes.
pub struct Random(pub u64);

impl Random {
    /// Between 0 and 1.
    pub fn unit(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
        all[((self.unit() * all.len() as f64) as usize).min(all.len() - 1)]
    }

    fn chance(&mut self, part: f64) -> bool {
        self.unit() < part
    }
}

/// IPE300 that rises by 6° with a haunch of the same section, twice as deep at the plate.
pub fn of_ipe300(base: &EndPlate, catalog: &Catalog) -> EndPlate {
    let mut e = base.clone();
    let slope = 6f64.to_radians();
    e.beam = catalog.profile("IPE300").expect("catalogued").clone();
    let depth = 2.0 * e.beam.h / slope.cos();
    haunch(&mut e, slope, depth, 1500.0);
    (e.top, e.bottom) = (depth / 2.0 + 80.0, -depth / 2.0 - 30.0);
    e.rows = vec![depth / 2.0 + 40.0, depth / 2.0 - 60.0, depth / 2.0 - 140.0, -depth / 2.0 + 90.0];
    e
}

/// A haunch of the rafter's own thicknesses.
fn haunch(e: &mut EndPlate, slope: f64, depth: f64, length: f64) {
    // at the tip nothing is left of the depth below the beam
    let below = depth - e.beam.h / slope.cos();
    let angle = (below * slope.cos() / (length - below * slope.sin())).atan();
    e.rafter = Some(Box::new(Rafter {
        slope,
        depth,
        haunch: Some(Haunch {
            length,
            angle,
            flange: e.beam.tf,
            width: e.beam.b,
            web: e.beam.tw,
            steel: e.beam_steel.clone(),
            seam_throat: 4.0,
            stiffener: 0.0,
        }),
    }));
}

/// A random joint: column, rafter, slope, haunch or none, rows outside and inside.
pub fn haunched(base: &EndPlate, catalog: &Catalog, n: &mut Random) -> EndPlate {
    let mut e = base.clone();
    let profile = |name: &str| catalog.profile(name).expect("catalogued").clone();
    e.beam = profile(n.of(&["IPE240", "IPE300", "IPE400", "IPE500", "IPE600", "HEA300", "HEB260"]));
    let c = e.column.as_mut().expect("a column");
    c.section = profile(n.of(&["HEB200", "HEB300", "HEA400", "HEM240", "HEB500"]));
    (c.above, c.below) = (None, None);
    c.stiffener = if n.chance(0.4) { n.between(10.0, 20.0) } else { 0.0 };
    c.stiffener_throat = if n.chance(0.5) { 4.0 } else { 0.0 };
    let slope = if n.chance(0.2) { 0.0 } else { n.between(-8.0, 15.0).to_radians() };
    let deep = n.between(1.3, 2.2);
    let depth = deep * e.beam.h / slope.cos();
    let length = n.between(2.5, 6.0) * e.beam.h;
    haunch(&mut e, slope, depth, length);
    let r = e.rafter.as_mut().expect("a rafter");
    if n.chance(0.25) {
        (r.depth, r.haunch) = (e.beam.h / slope.cos(), None);
    }
    if let Some(h) = &mut r.haunch {
        h.flange *= n.between(0.9, 1.5);
        h.width *= n.between(0.9, 1.2);
        h.web *= n.between(0.8, 1.3);
        h.stiffener = if n.chance(0.5) { 12.0 } else { 0.0 };
        h.seam_throat = if n.chance(0.7) { n.between(3.0, 6.0) } else { 0.0 };
        if n.chance(0.3) {
            h.steel.fy = bracket_joint::strength::Nominal::new(225.0);
        }
    }
    let half = 0.5 * r.depth;
    e.thickness = n.between(12.0, 30.0);
    e.flange_throat = if n.chance(0.8) { n.between(3.0, 8.0) } else { 0.0 };
    e.web_throat = n.between(3.0, 5.0);
    e.always_prying = n.chance(0.5);
    let widest = e.column.as_ref().map_or(0.0, |c| c.section.b);
    e.width = e.beam.b.min(widest) + n.between(0.0, 20.0);
    let web = e.column.as_ref().map_or(0.0, |c| c.section.tw + 1.8 * c.section.r) + 30.0;
    let most = (e.width.min(widest) - 50.0).max(web + 1.0);
    e.gauge = n.between(web, most).min(0.98 * e.beam.b.min(135.0f64.max(0.9 * e.beam.b)));
    e.rows.clear();
    let extended = [n.chance(0.6), n.chance(0.3)];
    let beyond = |out: bool| if out { 90.0 } else { 25.0 };
    (e.top, e.bottom) = (half + beyond(extended[0]), -half - beyond(extended[1]));
    if extended[0] {
        e.rows.push(half + n.between(35.0, 50.0));
    }
    let mut z = half - e.beam.tf - n.between(45.0, 70.0);
    let count = 1 + (n.unit() * 4.0) as usize;
    for _ in 0..count {
        if z > -half + 80.0 {
            e.rows.push(z);
        }
        z -= n.between(60.0, 130.0);
    }
    if n.chance(0.6) {
        e.rows.push(-half + n.between(65.0, 78.0));
    }
    if extended[1] {
        e.rows.push(-half - n.between(40.0, 50.0));
    }
    e
}
