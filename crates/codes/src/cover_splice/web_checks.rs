//! The web and its covers: shear, bending beside axial force, holes, block tearing.

use super::cover_buckling::{Buckling, buckling, free_length};
use super::distances::{ends, from_ends, span};
use super::side::Side;
use super::web_share::WebForces;
use crate::check::{Check, CheckId, Status, Topic, Unit, largest};
use crate::eurocode::block_tearing::Blocks;
use crate::eurocode::net_section::NetSection;
use crate::eurocode::section::shear_reduction;
use crate::formula::{Formula, Number, Traced};
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::CoverSplice;
use bracket_joint::spec::connection::BoltCategory;
use bracket_joint::strength::Strength;

/// Number of web covers.
const COVERS: f64 = 2.0;

/// Section of both covers across the member.
fn covers(e: &CoverSplice) -> NetSection<'_> {
    let thickness = || Traced::from(COVERS) * Traced::length("t", e.web.thickness);
    let holes = Traced::number("n_h", e.web_rows.len() as f64) * Traced::length("d0", e.hole);
    NetSection {
        gross: thickness() * Traced::length("h", e.web.width),
        holes: thickness() * holes,
        steel: &e.web.steel,
        gamma_m0: e.factors.gamma_m0,
        gamma_m2: e.factors.gamma_m2,
    }
}

/// Section of the web with an area, across the member.
fn web<'a>(e: &CoverSplice, side: &Side<'a>, area: Traced) -> NetSection<'a> {
    let holes = Traced::number("n_h", e.web_rows.len() as f64) * Traced::length("d0", e.hole);
    NetSection {
        gross: area,
        holes: holes * Traced::length("t_w", side.section.tw),
        steel: &side.member.web_steel,
        gamma_m0: e.factors.gamma_m0,
        gamma_m2: e.factors.gamma_m2,
    }
}

/// A block that the bolts of the web tear out, for `count` plates.
fn block(count: f64, [tension, shear]: [f64; 2], thickness: f64, steel: &Strength) -> Blocks {
    Blocks { count, tension, shear, thickness, fy: steel.fy.mpa(), fu: steel.fu.mpa() }
}

/// All checks of a web and its covers.
pub(super) fn checks(
    e: &CoverSplice,
    side: &Side<'_>,
    forces: &[WebForces],
    subject: &Subject,
) -> Vec<Check> {
    let of_web = side.of(subject.clone(), Part::SplicedWeb);
    let of_covers = side.of(subject.clone(), Part::WebCovers);
    let mut out = shear(e, side, forces, [&of_web, &of_covers]);
    out.extend(tension(e, side, forces, [&of_web, &of_covers]));
    out.extend(bending(e, forces, &of_covers));
    out
}

/// Shear of web and covers, beside the holes, and the blocks that it tears out.
///
/// # Source
/// EN 1993-1-8:2005 3.10.2(3), EN 1993-1-1:2005 6.2.6, SCI P398.
fn shear(
    e: &CoverSplice,
    side: &Side<'_>,
    forces: &[WebForces],
    [of_web, of_covers]: [&Subject; 2],
) -> Vec<Check> {
    let Some(force) = largest(forces, |f| f.shear.value).filter(|f| f.shear.value > 0.0) else {
        return Vec::new();
    };
    let against = |worked: Worked, subject: &Subject| {
        worked.against(Topic::Member, subject.clone(), force.shear.value, Status::Failed)
    };
    let (m0, m2) = (e.factors.gamma_m0, e.factors.gamma_m2);
    let [first, last] = ends(&e.web_columns);
    let (rows, columns) = (e.web_rows.len() as f64, e.web_columns.len() as f64);
    let (wide, high) = (span(&e.web_columns), span(&e.web_rows));
    let half = 0.5 * e.web.width;
    let edge = from_ends(&e.web_rows, e.web_middle - half, e.web_middle + half);
    let across = |end: f64| end + wide - (columns - 0.5) * e.hole;
    let lines = [across(0.5 * e.web.length - last), edge + high - (rows - 0.5) * e.hole];
    let mut torn = block(COVERS, lines, e.web.thickness, &e.web.steel).eccentric(m0, m2);
    torn.id = CheckId::BlockTearingAcross;
    let covers = covers(e);
    let mut out = vec![
        against(covers.plate_shear(CheckId::WebCoverShear), of_covers),
        against(covers.net_shear(CheckId::WebCoverNetShear), of_covers),
        against(torn, of_covers),
    ];
    let area = Traced::area("A_v", side.section.shear_area());
    out.push(against(web(e, side, area).net_shear(CheckId::WebNetShear), of_web));
    // the flanges hold the web, so that the line of holes tears between the outermost rows
    if e.web_rows.len() > 1 {
        let lines = [across(first - 0.5 * e.gap), high - (rows - 1.0) * e.hole];
        let steel = &side.member.web_steel;
        let mut torn = block(1.0, lines, side.section.tw, steel).eccentric(m0, m2);
        torn.id = CheckId::BlockTearingAcross;
        out.push(against(torn, of_web));
    }
    out
}

/// Tension of web and covers beside the holes, and the blocks that it tears out.
///
/// # Source
/// EN 1993-1-1:2005 6.2.3(2), EN 1993-1-8:2005 3.10.2(2).
fn tension(
    e: &CoverSplice,
    side: &Side<'_>,
    forces: &[WebForces],
    [of_web, of_covers]: [&Subject; 2],
) -> Vec<Check> {
    let Some(force) = largest(forces, |f| f.axial.value).filter(|f| f.axial.value > 0.0) else {
        return Vec::new();
    };
    let against = |worked: Worked, subject: &Subject| {
        let worked = worked.after(force.axial.clone());
        worked.against(Topic::Member, subject.clone(), force.axial.value, Status::Failed)
    };
    let (m0, m2) = (e.factors.gamma_m0, e.factors.gamma_m2);
    let no_slip = e.category == Some(BoltCategory::C);
    let (s, steel) = (&side.section, &side.member.web_steel);
    let area = Traced::length("h_w", s.web_depth()) * Traced::length("t_w", s.tw);
    let mut out = vec![
        against(covers(e).tension(CheckId::CoverTension, no_slip), of_covers),
        against(web(e, side, area).tension(CheckId::WebTension, no_slip), of_web),
    ];
    let (rows, columns) = (e.web_rows.len() as f64, e.web_columns.len() as f64);
    if e.web_rows.len() > 1 {
        let [first, last] = ends(&e.web_columns);
        let pulled = span(&e.web_rows) - (rows - 1.0) * e.hole;
        let line = |end: f64| 2.0 * (end + span(&e.web_columns) - (columns - 0.5) * e.hole);
        let of_cover = [pulled, line(0.5 * e.web.length - last)];
        let torn = block(COVERS, of_cover, e.web.thickness, &e.web.steel).resistance(m0, m2);
        out.push(against(torn, of_covers));
        let in_web = [pulled, line(first - 0.5 * e.gap)];
        let torn = block(1.0, in_web, s.tw, steel).resistance(m0, m2);
        out.push(against(torn, of_web));
    }
    out
}

/// Axial force and moment of the covers.
struct Bending<'a> {
    e: &'a CoverSplice,
    force: &'a WebForces,
}

impl Bending<'_> {
    fn size(symbol: &'static str, value: f64, unit: Unit) -> Traced {
        Traced::symbol(symbol, value.abs(), unit)
    }

    /// N and M over an area and a modulus with a strength.
    fn used(&self, area: &Formula, modulus: &Formula, strength: &Traced) -> Traced {
        let axial = Self::size("N_w,Ed", self.force.axial.value, Unit::Force);
        let moment = Self::size("M_w,Ed", self.force.moment.value, Unit::Moment);
        axial / (area.traced() * strength.clone()) + moment / (modulus.traced() * strength.clone())
    }

    /// Elastic bending without holes, the strength reduced beside shear.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.1(7), 6.2.8(3), 6.2.10(3); SCI P398.
    fn gross(&self) -> Worked {
        let (n, cover) = (Traced::from, &self.e.web);
        let [t, h] = [("t", cover.thickness), ("h", cover.width)]
            .map(|(symbol, value)| Traced::length(symbol, value));
        let shear = covers(self.e).plate_shear(CheckId::WebCoverShear).traced();
        let rho = shear_reduction(self.force.shear.traced() / shear).min(n(1.0));
        let rho = Formula::new("ρ", rho, Unit::Number);
        let mut strength = Traced::stress("f_y", cover.steel.fy.mpa())
            / Traced::number("γ_M0", self.e.factors.gamma_m0);
        let mut words = self.force.derivation();
        if rho.value > 0.0 {
            strength = (n(1.0) - rho.traced()) * strength;
            words = words.then(rho);
        }
        let area = Formula::new("A", n(COVERS) * t.clone() * h.clone(), Unit::Area);
        let modulus = n(COVERS) * t * h.powi(2) / n(6.0);
        let modulus = Formula::new("W_el", modulus, Unit::Number);
        let used = self.used(&area, &modulus, &strength);
        let id = CheckId::WebCoverBending;
        let clause = "EN 1993-1-1:2005 6.2.1(7), 6.2.8(3), 6.2.10";
        Worked::of(clause, id, "", used, Unit::Number).after(words.then(area).then(modulus))
    }

    /// Elastic bending of the section beside its holes, up to `0.9 f_u/γ_M2`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.3(2)b and 6.2.5(4), as stresses: the holes of the whole depth are taken
    /// off, on the safe side.
    fn net(&self) -> Worked {
        let (n, e) = (Traced::from, self.e);
        let [t, h, d0] = [("t", e.web.thickness), ("h", e.web.width), ("d0", e.hole)]
            .map(|(symbol, value)| Traced::length(symbol, value));
        let rows = Traced::number("n_h", e.web_rows.len() as f64);
        let area = n(COVERS) * t.clone() * (h.clone() - rows.clone() * d0.clone());
        let area = Formula::new("A_net", area, Unit::Area);
        let squares: f64 = e.web_rows.iter().map(|z| (z - e.web_middle).powi(2)).sum();
        let squares = Traced::area("Σz²", squares);
        let holes = rows * d0.clone().powi(3) / n(12.0) + d0 * squares;
        let inertia = n(COVERS) * t * (h.clone().powi(3) / n(12.0) - holes);
        let inertia = Formula::new("I_net", inertia, Unit::Number);
        let modulus = n(2.0) * inertia.traced() / h;
        let modulus = Formula::new("W_net", modulus, Unit::Number);
        let strength = n(0.9) * Traced::stress("f_u", e.web.steel.fu.mpa())
            / Traced::number("γ_M2", e.factors.gamma_m2);
        let used = self.used(&area, &modulus, &strength);
        let words = self.force.derivation().then(area).then(inertia).then(modulus);
        let (clause, id) = ("EN 1993-1-1:2005 6.2.3(2)b, 6.2.5(4)", CheckId::WebCoverNetBending);
        Worked::of(clause, id, "", used, Unit::Number).after(words)
    }

    /// The compressed edge of the covers as a member between the bolts. The stress of the edge is
    /// taken over the whole cover, on the safe side; `None` where nothing buckles.
    fn buckling(&self) -> Option<Worked> {
        let e = self.e;
        let p = free_length(&e.web_columns);
        let Buckling { before, chi } = buckling(p, e.web.thickness, &e.web.steel);
        let chi = chi?;
        let [t, h] = [e.web.thickness, e.web.width];
        let area = Formula::new("A", Traced::area("A", COVERS * t * h), Unit::Area);
        let modulus = Traced::number("W_el", COVERS * t * h * h / 6.0);
        let modulus = Formula::new("W_el", modulus, Unit::Number);
        let strength = chi.traced() * Traced::stress("f_y", e.web.steel.fy.mpa())
            / Traced::number("γ_M1", e.factors.gamma_m1);
        let used = self.used(&area, &modulus, &strength);
        let (clause, id) = ("EN 1993-1-8:2005 Table 3.3 note 2", CheckId::WebCoverBuckling);
        let words = self.force.derivation().followed_by(before).then(chi);
        Some(Worked::of(clause, id, "", used, Unit::Number).after(words))
    }
}

/// Bending of the covers with their axial force, the worst of all forces.
fn bending(e: &CoverSplice, forces: &[WebForces], subject: &Subject) -> Vec<Check> {
    let acts = |f: &&WebForces| f.axial.value != 0.0 || f.moment.value != 0.0;
    let each = || forces.iter().filter(acts).map(|force| Bending { e, force });
    let worst = |all: Vec<Worked>| largest(all, |w| w.value);
    let gross = worst(each().map(|b| b.gross()).collect());
    let net = worst(each().map(|b| b.net()).collect());
    let used = |w: Worked| w.utilised(Topic::Member, subject.clone(), Status::Failed);
    let mut out: Vec<Check> = [gross, net].into_iter().flatten().map(used).collect();
    out.extend(worst(each().filter_map(|b| b.buckling()).collect()).map(|w| {
        let step = "thicker web covers, or bolts nearer to the gap";
        let check = w.utilised(Topic::Stability, subject.clone(), Status::Undecided);
        check.decided_by(step)
    }));
    out
}
