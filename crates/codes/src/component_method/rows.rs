//! The rows of bolts in tension: their T-stubs alone and in groups, on the side of the column and
//! on that of the beam.
//!
//! Tension is at the top; [`EndPlateJoint::mirrored`] converts the other sense to this one. EN
//! 1993-1-8:2005 6.2.4 to 6.2.6.

use super::component_kind::ComponentKind;
use super::effective_lengths::{self as lengths, Lengths};
use super::joint::{Column, EndPlateJoint};
use super::t_stub::{Mode, Prying, TStub, prying};
use super::{beam, column_web};
use crate::error::CheckError;
use crate::worked::Worked;
use bracket_joint::assembly::Way;
use std::f64::consts::SQRT_2;

mod covered;

/// Fraction of the leg of a fillet weld in which no plastic hinge forms, figures 6.8 and 6.10.
const LEG: f64 = 0.8;
/// The same over the throat of a weld at a right angle: 0.8 a √2.
const WELD: f64 = LEG * SQRT_2;
/// Fraction of a root radius in which no plastic hinge forms, figure 6.8.
const ROOT: f64 = 0.8;

/// One component of the joint and its resistance.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// What it is.
    pub kind: ComponentKind,
    /// Its resistance.
    pub worked: Worked,
    /// Failure mode, if it is a T-stub.
    pub mode: Option<Mode>,
    /// Force of its bolts at the resistance, prying included, if it is a T-stub \[N\].
    pub bolts: Option<f64>,
    /// Its dimensions, if it is a T-stub.
    pub stub: Option<Stub>,
}

/// Dimensions of the T-stub of a row or a group, and its modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Stub {
    /// The T-stub.
    pub of: TStub,
    /// e, or e_x of a row outside the flange \[mm\].
    pub e: f64,
    /// Σ ℓ_eff,cp and Σ ℓ_eff,nc.
    pub lengths: Lengths,
    /// m2 \[mm\] and α of the stiffeners, or flanges of the beam, beside the first and last row.
    pub beside: Vec<(f64, f64)>,
    /// Resistances of its modes \[N\].
    pub modes: Vec<(Mode, f64)>,
}

/// Side of the joint whose T-stub a group forms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Column,
    Beam,
}

/// Which flanges of the beam are in tension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Flanges {
    /// The upper one: a moment decides.
    Upper,
    /// Both: an axial force decides.
    Both,
}

/// Rows in tension of a joint, from the top.
#[derive(Clone, Debug)]
pub struct Rows<'a> {
    joint: &'a EndPlateJoint,
    flanges: Flanges,
    /// z of the rows from the beam's axis, from the top \[mm\].
    pub z: Vec<f64>,
    /// Their distances from the centre of compression \[mm\].
    pub lever: Vec<f64>,
    shear_area: f64,
}

impl<'a> Rows<'a> {
    /// The rows above the centre of compression, the middle of the lower beam flange (figure 6.15).
    pub fn new(joint: &'a EndPlateJoint) -> Result<Self, CheckError> {
        Self::of(joint, Flanges::Upper)
    }

    /// All rows of a joint in axial tension: both flanges of the beam are tension flanges, nothing
    /// is compressed.
    pub fn all(joint: &'a EndPlateJoint) -> Result<Self, CheckError> {
        Self::of(joint, Flanges::Both)
    }

    fn of(joint: &'a EndPlateJoint, flanges: Flanges) -> Result<Self, CheckError> {
        joint.check()?;
        let centre = joint.beam.middle(Way::Down);
        let pulled = |z: &f64| flanges == Flanges::Both || *z > centre;
        let mut z: Vec<f64> = joint.bolts.rows.iter().copied().filter(pulled).collect();
        z.sort_by(|a, b| b.total_cmp(a));
        if z.is_empty() {
            return Err(CheckError::NotCovered {
                what: "no row of bolts lies on the side of the tension".into(),
                clause: "EN 1993-1-8:2005 6.2.7.2",
                step: "a row of bolts on that side (`bolts.rows`)",
            });
        }
        let lever = z.iter().map(|z| z - centre).collect();
        let shear_area = joint.column.as_ref().map_or(0.0, column_web::shear_area);
        let rows = Self { joint, flanges, z, lever, shear_area };
        rows.covered()?;
        Ok(rows)
    }

    /// Number of rows in tension.
    pub fn count(&self) -> usize {
        self.z.len()
    }

    /// A_vc of the column \[mm²\]; 0 without a column.
    pub fn shear_area(&self) -> f64 {
        self.shear_area
    }

    /// Whether a row lies outside a tension flange.
    fn outside(&self, z: f64) -> bool {
        self.beyond(z).is_some()
    }

    /// The flange beyond whose middle a row lies.
    fn beyond(&self, z: f64) -> Option<Way> {
        let b = &self.joint.beam;
        [(Way::Up, z > b.middle(Way::Up)), (Way::Down, z < b.middle(Way::Down))]
            .into_iter()
            .find_map(|(flange, beyond)| beyond.then_some(flange))
    }

    /// What a hinge leaves free of the weld on a face of a flange \[mm\].
    fn flange_weld(&self, flange: Way, outer: bool) -> f64 {
        LEG * self.joint.beam.leg(flange, outer) * self.joint.beam.flange_throat
    }

    /// m of the column flange \[mm\], figure 6.8.
    fn m_column(&self, column: &Column) -> f64 {
        let s = &column.section;
        0.5 * (self.joint.bolts.gauge - s.tw) - ROOT * s.root
    }

    /// e of the column flange \[mm\].
    fn e_column(&self, column: &Column) -> f64 {
        0.5 * (column.section.b - self.joint.bolts.gauge)
    }

    /// m of the end plate between the flanges \[mm\], figure 6.10.
    fn m_beam(&self) -> f64 {
        0.5 * (self.joint.bolts.gauge - self.joint.beam.section.tw)
            - WELD * self.joint.beam.web_throat
    }

    /// e of the end plate \[mm\].
    fn e_plate(&self) -> f64 {
        0.5 * (self.joint.plate.width - self.joint.bolts.gauge)
    }

    /// m_x of a row outside the flange \[mm\], figure 6.10.
    fn mx(&self, z: f64) -> f64 {
        let flange = if z > 0.0 { Way::Up } else { Way::Down };
        z.abs() - 0.5 * self.joint.beam.depth() - self.flange_weld(flange, true)
    }

    /// Distance of a row outside a flange from the edge of the plate \[mm\].
    fn ex(&self, z: f64) -> f64 {
        if z > 0.0 { self.joint.plate.top - z } else { z - self.joint.plate.bottom }
    }

    /// m2 of a row between the flanges to the upper and the lower one, as far as they are in
    /// tension \[mm\], figure 6.11.
    fn to_flanges(&self, z: f64) -> [Option<f64>; 2] {
        let b = &self.joint.beam;
        let clear = |flange| 0.5 * b.depth() - b.along(flange) - self.flange_weld(flange, false);
        let lower = (self.flanges == Flanges::Both).then(|| clear(Way::Down) + z);
        [Some(clear(Way::Up) - z), lower]
    }

    /// m2 to the tension flange next above and next below a row between the flanges, where no other
    /// row lies between.
    fn beside_flanges(&self, row: usize) -> [Option<f64>; 2] {
        let [above, below] = self.to_flanges(self.z[row]);
        let first = row == 0 || self.outside(self.z[row - 1]);
        let last = row + 1 == self.count() || self.outside(self.z[row + 1]);
        [above.filter(|_| first), below.filter(|_| last)]
    }

    /// Stretch of the column flange on which a row lies: 0 above the stiffeners, 1 between, 2
    /// below.
    fn stretch(&self, row: usize) -> usize {
        let stiffened = self.joint.column.as_ref().is_some_and(|c| c.stiffener > 0.0);
        match (stiffened, self.outside(self.z[row])) {
            (false, _) => 0,
            (true, false) => 1,
            (true, true) => {
                if self.z[row] > 0.0 {
                    0
                } else {
                    2
                }
            }
        }
    }

    /// m2 to the stiffener next above and next below a row, where no other row lies between \[mm\].
    fn stiffeners(&self, row: usize) -> [Option<f64>; 2] {
        let Some(c) = self.joint.column.as_ref().filter(|c| c.stiffener > 0.0) else {
            return [None, None];
        };
        let z = self.z[row];
        let [upper, lower] = [Way::Up, Way::Down].map(|f| self.joint.beam.middle(f));
        let clear = |distance: f64| distance - 0.5 * c.stiffener - WELD * c.stiffener_throat;
        let first = row == 0 || self.stretch(row - 1) != self.stretch(row);
        let last = row + 1 == self.count() || self.stretch(row + 1) != self.stretch(row);
        match self.stretch(row) {
            0 => [None, last.then(|| clear(z - upper))],
            2 => [first.then(|| clear(lower - z)), None],
            _ => [first.then(|| clear(upper - z)), last.then(|| clear(z - lower))],
        }
    }

    /// Effective lengths of one row on the column flange, and of the same row within the group
    /// `first..=last`.
    fn on_column(&self, column: &Column, row: usize, group: Option<(usize, usize)>) -> Lengths {
        let (m, e) = (self.m_column(column), self.e_column(column));
        let beside = self.stiffeners(row);
        let alpha = |m2: Option<f64>| m2.map(|m2| lengths::alpha(m, e, m2));
        let end = |way| column.ends().from(self.z[row], way);
        let up = end(Way::Up).filter(|_| row == 0);
        // the lowest row in tension is an end row where it is the lowest of all
        let lowest = row + 1 == self.joint.bolts.rows.len();
        let down = end(Way::Down).filter(|_| lowest);
        let Some((first, last)) = group else {
            let alpha = beside.into_iter().filter_map(alpha).reduce(f64::max);
            let nearest = [up, down].into_iter().flatten().reduce(f64::min);
            return match (alpha, nearest) {
                (Some(a), Some(e1)) => lengths::end_beside_stiffener(m, e, e1, a),
                (Some(a), None) => lengths::beside_stiffener(m, a),
                (None, Some(e1)) => lengths::end(m, e, e1),
                (None, None) => lengths::inner(m, e),
            };
        };
        let ([above, below], pitch) = (beside, |i: usize| self.z[i] - self.z[i + 1]);
        let at_end = |stiffener: Option<f64>, p: f64, e1| match alpha(stiffener) {
            Some(a) => lengths::beside_stiffener_of_group(m, e, p, a),
            None => lengths::end_of_group(m, e, p, e1),
        };
        match row {
            r if r == first => at_end(above, pitch(r), up),
            r if r == last => at_end(below, pitch(r - 1), down),
            r => lengths::inner_of_group(pitch(r - 1), pitch(r)),
        }
    }

    /// Effective lengths of one row on the end plate, alone or within a group; a row outside the
    /// flange has no group.
    fn on_plate(&self, row: usize, group: Option<(usize, usize)>) -> Lengths {
        let (j, z) = (self.joint, self.z[row]);
        if self.outside(z) {
            return lengths::outside_flange(
                self.mx(z),
                self.ex(z),
                self.e_plate(),
                j.bolts.gauge,
                j.plate.width,
            );
        }
        let (m, e) = (self.m_beam(), self.e_plate());
        let [above, below] =
            self.beside_flanges(row).map(|m2| m2.map(|m2| lengths::alpha(m, e, m2)));
        let pitch = |i: usize| self.z[i] - self.z[i + 1];
        let at_end = |alpha: Option<f64>, p: f64| match alpha {
            Some(alpha) => lengths::beside_stiffener_of_group(m, e, p, alpha),
            None => lengths::end_of_group(m, e, p, None),
        };
        match group {
            None => match above.into_iter().chain(below).reduce(f64::max) {
                Some(alpha) => lengths::beside_stiffener(m, alpha),
                None => lengths::inner(m, e),
            },
            Some((first, _)) if row == first => at_end(above, pitch(row)),
            Some((_, last)) if row == last => at_end(below, pitch(row - 1)),
            Some(_) => lengths::inner_of_group(pitch(row - 1), pitch(row)),
        }
    }

    /// Whether the rows `first..=last` can form a group on a side: no stiffener and no flange lies
    /// between them.
    fn joined(&self, side: Side, first: usize, last: usize) -> bool {
        match side {
            Side::Column => self.stretch(first) == self.stretch(last),
            Side::Beam => !self.outside(self.z[first]) && !self.outside(self.z[last]),
        }
    }

    /// The components that the rows `first..=last` share; for one row the components of the row
    /// alone.
    pub fn components(&self, first: usize, last: usize) -> Vec<Component> {
        let j = self.joint;
        let rows = last + 1 - first;
        let group = (first < last).then_some((first, last));
        let e_min =
            j.column.as_ref().map_or(f64::INFINITY, |c| self.e_column(c)).min(self.e_plate());
        // stiffeners or flanges above the first and below the last row, those that count
        let beside = |m: f64, e: f64, of: &dyn Fn(usize) -> [Option<f64>; 2]| -> Vec<(f64, f64)> {
            let m2 = [of(first)[0], of(last)[1]].into_iter().flatten();
            m2.map(|m2| (m2, lengths::alpha(m, e, m2))).collect()
        };
        let stub =
            |kind, lengths: Lengths, (m, e): (f64, f64), edge: f64, (thickness, fy), beside| {
                let length1 = lengths.mode1();
                let stub = TStub {
                    m,
                    n: edge.min(1.25 * m),
                    thickness,
                    fy,
                    length1,
                    length2: lengths.mode2(),
                    bolts: 2.0 * rows as f64 * j.bolts.tension,
                    gamma_m0: j.gamma_m0,
                    prying: if j.bolts.always_prying {
                        Prying::Develops
                    } else {
                        prying(j.bolts.elongation, m, j.bolts.stress_area, rows, length1, thickness)
                    },
                    washer_quarter: j.bolts.washer.map(|d| 0.25 * d),
                };
                let r = stub.resistance();
                let stub = Some(Stub { of: stub, e, lengths, beside, modes: r.modes });
                Component { kind, mode: Some(r.mode), bolts: Some(r.bolts), worked: r.worked, stub }
            };
        let web = |kind, worked| Component { kind, worked, mode: None, bolts: None, stub: None };
        let mut out = Vec::new();
        let grouped = |side| rows == 1 || self.joined(side, first, last);
        if let Some(c) = j.column.as_ref().filter(|_| grouped(Side::Column)) {
            let lengths: Lengths = (first..=last).map(|row| self.on_column(c, row, group)).sum();
            let (m, e) = (self.m_column(c), self.e_column(c));
            let beside = beside(m, e, &|row| self.stiffeners(row));
            let steel = (c.section.tf, c.fy);
            out.push(stub(ComponentKind::ColumnFlange, lengths, (m, e), e_min, steel, beside));
            let omega = column_web::shear_interaction(
                j.beta,
                lengths.mode1(),
                c.section.tw,
                self.shear_area,
            );
            let thickness = column_web::tension_thickness(c.section.tw, c.doublers, c.fy);
            let length = lengths.mode1();
            let worked = column_web::tension(length, thickness, c.fy, omega, j.gamma_m0);
            out.push(web(ComponentKind::ColumnWeb, worked));
        }
        if grouped(Side::Beam) {
            let lengths: Lengths = (first..=last).map(|row| self.on_plate(row, group)).sum();
            let z = self.z[first];
            let (m, e, edge, beside) = if self.outside(z) {
                (self.mx(z), self.ex(z), self.ex(z), Vec::new())
            } else {
                let (m, e) = (self.m_beam(), self.e_plate());
                (m, e, e_min, beside(m, e, &|row| self.beside_flanges(row)))
            };
            let steel = (j.plate.thickness, j.plate.fy);
            out.push(stub(ComponentKind::EndPlate, lengths, (m, e), edge, steel, beside));
            if !self.outside(z) {
                let worked =
                    beam::web_tension(lengths.mode1(), j.beam.section.tw, j.beam.fy, j.gamma_m0);
                out.push(web(ComponentKind::BeamWeb, worked));
            }
        }
        out
    }

    /// Smallest effective lengths of a row, alone or in any group of consecutive rows, and m, on
    /// column and plate \[mm\]: those of the stiffness coefficients; `None` for the column of a
    /// splice.
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 6.11: "the smallest of the effective lengths (individually or as part
    /// of a group of bolt rows)".
    pub fn stiffness_lengths(&self, row: usize) -> (Option<(f64, f64)>, (f64, f64)) {
        let smallest = |side: Side, lengths: &dyn Fn(Option<(usize, usize)>) -> Lengths| {
            let groups =
                (0..=row).flat_map(|first| (row..self.count()).map(move |last| (first, last)));
            let groups =
                groups.filter(|(first, last)| first < last && self.joined(side, *first, *last));
            groups.map(|g| lengths(Some(g)).mode1()).fold(lengths(None).mode1(), f64::min)
        };
        let z = self.z[row];
        let m = if self.outside(z) { self.mx(z) } else { self.m_beam() };
        let column =
            |c| (smallest(Side::Column, &|group| self.on_column(c, row, group)), self.m_column(c));
        (
            self.joint.column.as_ref().map(column),
            (smallest(Side::Beam, &|group| self.on_plate(row, group)), m),
        )
    }
}
