//! The welds of a joint: seams with their throats and lengths.

use super::at_plate;
use super::parts_list::DENSITY;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{Content, EndPlate, Facts};

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
        Some(Facts::Simple(_) | Facts::CoverSplice(_)) | None => Vec::new(),
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

/// The welds of `plates` end plates with their beams, and of the column.
fn of_end_plate(e: &EndPlate, plates: usize) -> Vec<WeldItem> {
    let mut out = Vec::new();
    // a fillet weld has a seam on either side of a part, a butt weld one in all
    let mut both = |place: &'static str, throat: f64, places: usize, length: Option<f64>| {
        let count = if throat > 0.0 { 2 * places } else { places };
        out.push(WeldItem { place: place.into(), throat, count, length });
    };
    let b = &e.beam;
    let inside = 0.5 * (b.b - b.tw) - b.r;
    // along the plate; seams of a haunch are those of further parts
    let slope = at_plate::rafter(e).map_or(0.0, |r| r.slope);
    let web = (b.h - 2.0 * (b.tf + b.r)) / slope.cos();
    both("beam web to end plate", e.web_throat, plates, Some(web));
    if e.rib > 0.0 {
        let length = e.top - 0.5 * e.depth();
        both("rib to end plate", e.rib_throat, plates, Some(length));
        both("rib to beam flange", e.rib_throat, plates, None);
    }
    if let Some(c) = &e.column {
        let s = &c.section;
        if c.stiffener > 0.0 {
            let flange = 0.5 * (s.b - s.tw) - c.stiffener_clip;
            let web = s.h - 2.0 * (s.tf + c.stiffener_clip);
            both("stiffener to column flange", c.stiffener_throat, 8, Some(flange));
            both("stiffener to column web", c.stiffener_throat, 4, Some(web));
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
