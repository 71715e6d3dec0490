//! The plies that the bolts of a simple joint clamp, with their distances.

use crate::check::{largest, within};
use crate::eurocode::bearing::{Along, Bearing, Hole};
use crate::eurocode::block_tearing::Blocks;
use crate::eurocode::bolt_group::BoltGroup;
use crate::eurocode::bolts::{ShearJoint, shear_in_joint};
use crate::eurocode::holes::Clearance;
use crate::eurocode::plate_section::PlateSection;
use crate::formula::{Number, Traced};
use crate::subject::Part;
use crate::worked::Worked;
use bracket_joint::assembly::{SimpleJoint, SimpleKind, SupportElement};
use bracket_joint::strength::Strength;

/// End distance that reduces no bearing resistance, over d0: α_d = 1.
const FAR: f64 = 3.0;

/// A ply with the distances of its outermost bolts \[mm\].
#[derive(Clone, Copy)]
pub(super) struct Ply<'a> {
    /// Plate, beam web or the element of the support.
    pub part: Part,
    /// Thickness.
    pub thickness: f64,
    /// Steel.
    pub steel: &'a Strength,
    /// Least distance from the upper or the lower end; infinite: no end.
    pub e1: f64,
    /// Distance from the edge across; infinite: no edge.
    pub e2: f64,
}

/// The plate: of a fin plate its free edge is the end of the beam's side.
pub(super) fn plate(e: &SimpleJoint) -> Ply<'_> {
    let (part, e2) = match e.kind {
        SimpleKind::FinPlate => (Part::FinPlate, e.width - last(&e.columns)),
        SimpleKind::HeaderPlate => (Part::HeaderPlate, 0.5 * e.width - outermost(e)),
    };
    let e1 = (e.top - first(&e.rows)).min(last(&e.rows) - e.bottom);
    Ply { part, thickness: e.thickness, steel: &e.plate_steel, e1, e2 }
}

/// The web of the beam behind a fin plate.
pub(super) fn web(e: &SimpleJoint) -> Ply<'_> {
    let [top, bottom] = edges(e);
    let e1 = (top - first(&e.rows)).min(last(&e.rows) - bottom);
    let e2 = first(&e.columns) - e.beam_start;
    Ply { part: Part::BeamWeb, thickness: e.beam.tw, steel: &e.beam_steel, e1, e2 }
}

/// The element of the support behind a header plate. It has no end in reach of the bolts.
pub(super) fn support(e: &SimpleJoint) -> Ply<'_> {
    let e2 = match e.support.element {
        SupportElement::ColumnFlange => 0.5 * e.support.section.b - outermost(e),
        SupportElement::ColumnWeb | SupportElement::BeamWeb => f64::INFINITY,
    };
    Ply {
        part: support_part(e),
        thickness: e.support.thickness(),
        steel: &e.support.steel,
        e1: f64::INFINITY,
        e2,
    }
}

/// The two plies that the bolts clamp.
pub(super) fn plies(e: &SimpleJoint) -> [Ply<'_>; 2] {
    match e.kind {
        SimpleKind::FinPlate => [plate(e), web(e)],
        SimpleKind::HeaderPlate => [plate(e), support(e)],
    }
}

/// The element of the support as a part.
pub(super) fn support_part(e: &SimpleJoint) -> Part {
    match e.support.element {
        SupportElement::ColumnFlange => Part::ColumnFlange,
        SupportElement::ColumnWeb => Part::ColumnWeb,
        SupportElement::BeamWeb => Part::SupportingWeb,
    }
}

/// z of the upper and the lower edge of the beam at its end \[mm\].
pub(super) fn edges(e: &SimpleJoint) -> [f64; 2] {
    let [top, bottom] = e.notches.map(|n| n.depth);
    [0.5 * e.beam.h - top, bottom - 0.5 * e.beam.h]
}

/// The first of rows or columns \[mm\].
pub(super) fn first(of: &[f64]) -> f64 {
    of.first().copied().unwrap_or_default()
}

/// The last of rows or columns \[mm\].
pub(super) fn last(of: &[f64]) -> f64 {
    of.last().copied().unwrap_or_default()
}

/// Smallest and largest distance of neighbours; `None` of one alone.
pub(super) fn pitches(of: &[f64]) -> Option<[f64; 2]> {
    let steps = of.windows(2).map(|w| (w[1] - w[0]).abs());
    steps.fold(None, |range: Option<[f64; 2]>, p| {
        Some(range.map_or([p, p], |[a, b]| [a.min(p), b.max(p)]))
    })
}

/// Largest distance of a bolt of a header plate from the web of the beam \[mm\].
fn outermost(e: &SimpleJoint) -> f64 {
    e.columns.iter().fold(0.0, |most, y| most.max(y.abs()))
}

/// Number of all bolts.
pub(super) fn bolts(e: &SimpleJoint) -> f64 {
    (e.rows.len() * e.columns.len()) as f64
}

/// The bolts in the plane of a fin plate.
pub(super) fn group(e: &SimpleJoint) -> BoltGroup {
    BoltGroup::new(&e.columns, &e.rows)
}

/// Resistance of a bolt in shear under a force on the group, as `[along the beam, upwards]`; of a
/// header plate the force is vertical.
pub(super) fn bolt_shear(e: &SimpleJoint, force: [f64; 2]) -> Worked {
    let length = match e.kind {
        SimpleKind::FinPlate => group(e).extent(force),
        SimpleKind::HeaderPlate => first(&e.rows) - last(&e.rows),
    };
    let joint = ShearJoint { hole: e.hole, length, pack: 0.0 };
    shear_in_joint(&e.bolt, &e.grade, joint, e.factors.gamma_m2)
}

/// Kind of the holes for bearing: with 2 mm clearance of small bolts a normal hole if every bolt
/// carries in bearing what it carries in shear, otherwise an oversize one. `None` for holes that
/// the code does not have.
///
/// # Source
/// EN 1993-1-8:2005 3.6.1(5); Table 3.4 note 1.
pub(super) fn hole(e: &SimpleJoint) -> Option<Hole> {
    match Clearance::of(&e.bolt, e.hole) {
        Clearance::Beyond => None,
        Clearance::Normal => Some(Hole::Normal),
        Clearance::Small if within(bolt_shear(e, [0.0, -1.0]).value, least_bearing(e)) => {
            Some(Hole::Normal)
        }
        Clearance::Small | Clearance::Oversize => Some(Hole::Oversize),
    }
}

/// Least bearing resistance of a bolt in normal holes under a vertical force \[N\].
pub(super) fn least_bearing(e: &SimpleJoint) -> f64 {
    let of = |p: Ply<'_>| p.vertical(e, Hole::Normal).value;
    plies(e).map(of).into_iter().fold(f64::INFINITY, f64::min)
}

impl Ply<'_> {
    /// Bearing resistance at one bolt \[N\].
    fn bearing(&self, e: &SimpleJoint, along: Along, [e2, p2]: [f64; 2], hole: Hole) -> Bearing {
        Bearing {
            along,
            e2,
            p2,
            hole,
            d: e.bolt.d,
            d0: e.hole,
            thickness: self.thickness,
            fu: self.steel.fu.mpa(),
            fub: e.grade.fub,
        }
    }

    /// Least bearing resistance of the bolts in one direction: the distance of the end and the
    /// pitches along the force, the same across it. One bolt alone along the force is a single lap
    /// joint with one bolt row.
    fn least(
        &self,
        e: &SimpleJoint,
        (end, along): (f64, Option<[f64; 2]>),
        (edge, across): (f64, Option<[f64; 2]>),
        hole: Hole,
    ) -> Worked {
        let p2 = across.map_or(f64::INFINITY, |p| p[0]);
        let gamma = e.factors.gamma_m2;
        let of = |at: Along| self.bearing(e, at, [edge, p2], hole);
        let inner = along.map(|[p1, _]| Along::Inner { p1 });
        let end = Some(end).filter(|end| end.is_finite()).map(|e1| Along::End { e1 });
        let each = [end, inner].into_iter().flatten().map(|at| of(at).resistance(gamma));
        // a bolt far from any end and any other
        let far = of(Along::End { e1: FAR * e.hole });
        let least = largest(each, |w| -w.value).unwrap_or_else(|| far.resistance(gamma));
        if along.is_some() {
            return least;
        }
        let most = far.of_one_row(gamma);
        if within(least.value, most.value) { least } else { most }
    }

    /// Least bearing resistance of a bolt under a vertical force \[N\].
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 3.4, 3.6.1(10).
    pub fn vertical(&self, e: &SimpleJoint, hole: Hole) -> Worked {
        self.least(e, (self.e1, pitches(&e.rows)), (self.e2, pitches(&e.columns)), hole)
    }

    /// Least bearing resistance of a bolt of a fin plate under a force along the beam \[N\].
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 3.4, 3.6.1(10); e1 and e2, p1 and p2 change places.
    pub fn along(&self, e: &SimpleJoint, hole: Hole) -> Worked {
        self.least(e, (self.e2, pitches(&e.columns)), (self.e1, pitches(&e.rows)), hole)
    }

    /// Bearing resistance of all bolts under a vertical force \[N\]: the sum over end and inner
    /// rows where each bolt carries more in shear, else the least of them for all.
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.7(1).
    pub fn all_vertical(&self, e: &SimpleJoint, hole: Hole, bolt_shear: f64) -> Traced {
        let pitch = pitches(&e.rows);
        let across = (self.e2, pitches(&e.columns));
        let none = f64::INFINITY;
        let end = self.least(e, (self.e1, pitch), across, hole).value;
        // inner rows of one pitch; a joint of one or two rows has none
        let inner = match e.rows.len() {
            0..=2 => end,
            _ => self.least(e, (none, pitch), across, hole).value,
        };
        let end_rows = if self.e1.is_finite() { e.rows.len().min(2) } else { 0 };
        let in_row = e.columns.len() as f64;
        let force = |name: &'static str, value| Traced::force(name, value);
        let count = |name: &'static str, rows: usize| Traced::number(name, rows as f64 * in_row);
        let inner_rows = e.rows.len() - end_rows;
        if inner_rows == 0 || end == inner {
            return count("n", e.rows.len()) * force("F_b,Rd", end.min(inner));
        }
        if end_rows == 0 {
            return count("n", e.rows.len()) * force("F_b,Rd", inner);
        }
        let [f_end, f_inner] = [force("F_b,Rd,end", end), force("F_b,Rd,inner", inner)];
        match within(end.max(inner), bolt_shear) {
            true => count("n_end", end_rows) * f_end + count("n_inner", inner_rows) * f_inner,
            false => count("n", e.rows.len()) * f_end.min(f_inner),
        }
    }

    /// The section of the ply through the rows of bolts, over the height of the plate.
    pub fn section<'a>(&'a self, e: &'a SimpleJoint, count: f64) -> PlateSection<'a> {
        PlateSection {
            height: e.height(),
            thickness: self.thickness,
            holes: e.rows.len(),
            hole: e.hole,
            count,
            steel: self.steel,
            factors: &e.factors,
        }
    }

    /// A face from the last bolt to the edge through `columns` lines of bolts \[mm\]: the net
    /// length.
    pub fn edge_face(&self, e: &SimpleJoint) -> f64 {
        let lines = match e.kind {
            SimpleKind::FinPlate => e.columns.len() as f64,
            // the lines on one side of the web
            SimpleKind::HeaderPlate => 0.5 * e.columns.len() as f64,
        };
        let spread = match (e.kind, pitches(&e.columns)) {
            (SimpleKind::FinPlate, Some(_)) => last(&e.columns) - first(&e.columns),
            (SimpleKind::HeaderPlate, Some(_)) => {
                let nearest = e.columns.iter().fold(f64::INFINITY, |n, y| n.min(y.abs()));
                outermost(e) - nearest
            }
            (_, None) => 0.0,
        };
        self.e2 + spread - (lines - 0.5) * e.hole
    }

    /// Faces of a block of this ply.
    pub fn blocks(&self, count: f64, tension: f64, shear: f64) -> Blocks {
        Blocks {
            count,
            tension,
            shear,
            thickness: self.thickness,
            fy: self.steel.fy.mpa(),
            fu: self.steel.fu.mpa(),
        }
    }
}
