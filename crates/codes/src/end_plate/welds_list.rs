//! The welds of a joint: seams with their throats and lengths.

use super::at_plate;
use super::parts_list::DENSITY;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{Content, EndPlate, Facts, Haunch};

/// Equal seams of a joint. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct WeldItem {
    /// Where they are: `beam flange to end plate, outside`, or the two parts.
    pub place: Text,
    /// Throat of a fillet weld; 0: full penetration.
    pub throat: f64,
    /// How many there are.
    pub count: usize,
    /// Length of each along the parts; `None` where the checks do not know it.
    pub length: Option<f64>,
}

impl WeldItem {
    /// Mass of all seams \[kg\] of a fillet weld with equal legs, whose section is a²; `None` for
    /// butt welds, whose preparation is the workshop's.
    pub fn mass(&self) -> Option<f64> {
        let section = self.throat * self.throat;
        self.length.filter(|_| section > 0.0).map(|l| DENSITY * section * l * self.count as f64)
    }
}

/// The welds of a joint: those that the hand checks know, in the order of the parts, then those of
/// further parts as the geometry has them.
pub fn welds_list(facts: Option<&Facts>, joint: &Content) -> Vec<WeldItem> {
    let mut out = match facts {
        Some(Facts::EndPlate(e)) => of_end_plate(e, joint.end_plates()),
        Some(Facts::Simple(_) | Facts::CoverSplice(_) | Facts::ColumnBase(_)) | None => Vec::new(),
    };
    out.extend(joint.seams.iter().map(|s| {
        let [a, b] = &s.between;
        WeldItem {
            place: match a == b {
                true => say!("within {}", a),
                false => say!("{} to {}", a, b),
            },
            throat: s.throat,
            count: 1,
            length: Some(s.length),
        }
    }));
    out
}

/// Adds the welds of a plate: fillets are seams on either side of it, a butt weld is one in all.
fn both(
    out: &mut Vec<WeldItem>,
    place: &'static str,
    throat: f64,
    places: usize,
    length: Option<f64>,
) {
    let count = if throat > 0.0 { 2 * places } else { places };
    out.push(WeldItem { place: place.into(), throat, count, length });
}

/// The welds of `plates` end plates with their beams, and of the column.
fn of_end_plate(e: &EndPlate, plates: usize) -> Vec<WeldItem> {
    let mut out = Vec::new();
    let b = &e.beam;
    let inside = 0.5 * (b.b - b.tw) - b.r;
    // along the plate
    let slope = at_plate::rafter(e).map_or(0.0, |r| r.slope);
    let web = (b.h - 2.0 * (b.tf + b.r)) / slope.cos();
    both(&mut out, "beam web to end plate", e.web_throat, plates, Some(web));
    if let Some(h) = at_plate::haunch(e) {
        of_haunch(e, h, plates, &mut out);
    }
    if e.rib > 0.0 {
        let length = e.top - 0.5 * e.depth();
        both(&mut out, "rib to end plate", e.rib_throat, plates, Some(length));
        both(&mut out, "rib to beam flange", e.rib_throat, plates, None);
    }
    if let Some(c) = &e.column {
        let s = &c.section;
        if c.stiffener > 0.0 {
            let flange = 0.5 * (s.b - s.tw) - c.stiffener_clip;
            let web = s.h - 2.0 * (s.tf + c.stiffener_clip);
            both(&mut out, "stiffener to column flange", c.stiffener_throat, 8, Some(flange));
            both(&mut out, "stiffener to column web", c.stiffener_throat, 4, Some(web));
        }
        if c.doubler > 0.0 {
            // round the plate, on its outside only
            let (place, throat) = ("web doubler, all round".into(), c.doubler_throat);
            out.push(WeldItem { place, throat, count: 1, length: None });
        }
    }
    let flange = |place: &'static str, count, length| WeldItem {
        place: place.into(),
        throat: e.flange_throat,
        count,
        length: Some(length),
    };
    if e.flange_throat > 0.0 {
        out.insert(0, flange("beam flange to end plate, outside", 2 * plates, b.b));
        out.insert(1, flange("beam flange to end plate, inside", 4 * plates, inside));
    } else {
        out.insert(0, flange("beam flange to end plate", 2 * plates, b.b));
    }
    out
}

/// The welds of the haunches of `plates` end plates.
fn of_haunch(e: &EndPlate, h: &Haunch, plates: usize, out: &mut Vec<WeldItem>) {
    let b = &e.beam;
    let [lowest, inner] = [0, 1].map(|i| e.flanges()[i]);
    both(out, "haunch web to end plate", e.web_throat, plates, Some(inner[0] - lowest[1]));
    both(out, "haunch web to beam flange", h.seam_throat, plates, Some(h.length));
    both(out, "haunch flange to beam flange, at its tip", 0.0, plates, Some(h.width));
    if h.stiffener > 0.0 {
        let (wide, high) = (0.5 * (b.b - b.tw), b.h - 2.0 * b.tf);
        both(out, "stiffener at the tip of the haunch to beam flange", 0.0, 4 * plates, Some(wide));
        both(out, "stiffener at the tip of the haunch to beam web", 0.0, 2 * plates, Some(high));
    }
    if e.flange_throat > 0.0 {
        let (place, throat) = ("haunch flange to end plate, outside".into(), e.flange_throat);
        out.push(WeldItem { place, throat, count: plates, length: Some(h.width) });
        let (place, inside) = ("haunch flange to end plate, inside".into(), h.width - h.web);
        out.push(WeldItem { place, throat, count: 2 * plates, length: Some(0.5 * inside) });
    } else {
        let place = "haunch flange to end plate".into();
        out.push(WeldItem { place, throat: 0.0, count: plates, length: Some(h.width) });
    }
}
