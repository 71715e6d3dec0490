//! Assembly of the components: row forces and moment resistance. EN 1993-1-8:2005 6.2.7.2.

use super::column_web::{self, CompressedWeb};
use super::joint::EndPlateJoint;
use super::rows::{Component, Rows};
use super::t_stub::Mode;
use super::{beam, stiffness};
use crate::checks::check::{Unit, Worked, number};
use crate::checks::error::CheckError;

/// Part of the tension resistance of a row's bolts above which the rows below may not be plastic, 6.2.7.2(9).
const NEARLY_BOLTS: f64 = 1.9;
/// Part of the plastic axial force of the beam up to which its effect is left out, 6.2.7.1(2).
pub const SMALL_AXIAL: f64 = 0.05;

/// A component that the rows `first..=row` share, row counted from 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The first row of the group.
    pub first: usize,
    /// The component.
    pub component: Component,
}

/// What limits a row.
#[derive(Clone, Debug, PartialEq)]
pub struct RowForce {
    /// z from the beam's axis, tension at the top \[mm\].
    pub z: f64,
    /// Distance h_r from the centre of compression \[mm\].
    pub lever: f64,
    /// The components of the row alone.
    pub alone: Vec<Component>,
    /// Groups of rows above that end with this row.
    pub groups: Vec<Group>,
    /// The least of `alone` \[N\].
    pub single: f64,
    /// After the groups and 6.2.7.2(9) \[N\].
    pub grouped: f64,
    /// F_tr,Rd, after compression and shear as well \[N\].
    pub force: f64,
    /// What limits it, in words.
    pub limited_by: String,
    /// The mode of the T-stub that limits it, if one does.
    pub mode: Option<Mode>,
    /// Whether 6.2.7.2(9) limits it.
    pub elastic: bool,
}

/// Resistance and stiffness of a joint for one sense of bending.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessment {
    /// Rows in tension, from the outermost.
    pub rows: Vec<RowForce>,
    /// Limits of the sum of the rows: column web and beam flange in compression, column web panel over β.
    pub limits: Vec<Worked>,
    /// V_wp,Rd of the column web panel, not over β; `None` without a column.
    pub panel: Option<Worked>,
    /// M_j,Rd.
    pub moment: Worked,
    /// M_c,Rd of the beam.
    pub beam_moment: Worked,
    /// Stiffness coefficients and S_j,ini.
    pub stiffness: stiffness::Stiffness,
}

impl RowForce {
    /// Force of one bolt of the row, prying included, under a part `share` of F_tr,Rd \[N\]: the plastic state of the row's
    /// T-stubs in proportion, which is in equilibrium and nowhere above its resistance.
    pub fn bolt_force(&self, share: f64) -> f64 {
        let force = share * self.force;
        let stubs = self.alone.iter().filter_map(|c| Some(c.bolts? / c.worked.value));
        // half to either bolt
        0.5 * force * stubs.fold(1.0, f64::max)
    }
}

impl Assessment {
    /// Σ F_tr,Rd \[N\].
    pub fn tension(&self) -> f64 {
        self.rows.iter().map(|r| r.force).sum()
    }

    /// Whether the web panel in shear limits the sum.
    pub fn shear_governs(&self) -> bool {
        let total = self.tension();
        self.limits
            .iter()
            .any(|l| l.unit == Unit::Force && l.title.contains("shear") && l.value <= total * (1.0 + 1e-9))
    }
}

/// Row forces, moment resistance and stiffness of a joint with the tension at the top.
///
/// From the outermost row on, each row carries what it can alone, what the groups leave it, what compression and shear leave
/// of the sum, and in proportion to its lever arm where a row above carries more than 1.9 F_t,Rd.
/// `M_j,Rd = Σ h_r F_tr,Rd`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.7.2(1) to (9), formula 6.25.
pub fn assess(joint: &EndPlateJoint) -> Result<Assessment, CheckError> {
    let rows = Rows::new(joint)?;
    let beam_moment = beam::moment_resistance(&joint.beam.section, joint.beam.fy, joint.gamma_m0)?;
    let panel = panel(joint, &rows)?;
    let limits = limits(joint, &rows, beam_moment.value, panel.as_ref());
    let (mut left, mut least) = (f64::INFINITY, "");
    for l in &limits {
        if l.value < left {
            (left, least) = (l.value, l.title);
        }
    }
    let mut found: Vec<RowForce> = Vec::new();
    for r in 0..rows.count() {
        let alone = rows.components(r, r);
        let mut limit = Limit::none();
        for c in &alone {
            limit.lower(c.worked.value, || c.name.into(), c.mode);
        }
        let single = limit.force;
        let mut groups = Vec::new();
        for first in (0..r).rev() {
            let above: f64 = found[first..].iter().map(|f| f.grouped).sum();
            for component in rows.components(first, r) {
                let words = || format!("{}, rows {}–{}", component.name, first + 1, r + 1);
                limit.lower(component.worked.value - above, words, component.mode);
                groups.push(Group { first, component });
            }
        }
        let mut elastic = false;
        for above in &found {
            if above.grouped > NEARLY_BOLTS * joint.bolts.tension {
                let proportional = above.grouped * rows.lever[r] / above.lever;
                elastic |= proportional < limit.force;
                limit.lower(proportional, || "6.2.7.2(9), lever arms".into(), None);
            }
        }
        // what the rows above carry in a group does not depend on compression: once that limits a row, none is left below
        let grouped = limit.force.max(0.0);
        limit.lower(left, || least.into(), None);
        let force = limit.force.max(0.0);
        left -= force;
        found.push(RowForce {
            z: rows.z[r],
            lever: rows.lever[r],
            alone,
            groups,
            single,
            grouped,
            force,
            limited_by: limit.words,
            mode: limit.mode,
            elastic,
        });
    }
    let moment = moment(&found);
    let stiffness = stiffness::initial(joint, &rows)?;
    Ok(Assessment { rows: found, limits, panel, moment, beam_moment, stiffness })
}

/// The least limit so far and what it is.
struct Limit {
    force: f64,
    words: String,
    mode: Option<Mode>,
}

impl Limit {
    fn none() -> Self {
        Self { force: f64::INFINITY, words: String::new(), mode: None }
    }

    fn lower(&mut self, force: f64, words: impl FnOnce() -> String, mode: Option<Mode>) {
        if force < self.force {
            *self = Self { force, words: words(), mode };
        }
    }
}

fn moment(rows: &[RowForce]) -> Worked {
    let value = rows.iter().map(|r| r.lever * r.force).sum();
    let terms: Vec<String> = rows
        .iter()
        .filter(|r| r.force > 0.0)
        .map(|r| format!("{} · {}", Unit::Force.show(r.force), Unit::Length.show(r.lever)))
        .collect();
    let formula = format!("M_j,Rd = Σ h_r F_tr,Rd = {}", terms.join(" + "));
    let title = "moment resistance of the joint";
    Worked::new("EN 1993-1-8:2005 6.2.7.2(1)", title, value, Unit::Moment, formula)
}

/// V_wp,Rd of the column web panel; `None` where there is none or nothing shears it.
fn panel(joint: &EndPlateJoint, rows: &Rows<'_>) -> Result<Option<Worked>, CheckError> {
    let Some(c) = joint.column.as_ref().filter(|_| joint.beta > 0.0) else { return Ok(None) };
    let (s, b) = (&c.section, &joint.beam.section);
    let stiffeners = if c.stiffener > 0.0 {
        let plastic = |t: f64| 0.25 * s.b * t * t * c.fy / joint.gamma_m0;
        column_web::stiffened_panel(plastic(s.tf), plastic(c.stiffener), b.h - b.tf)
    } else {
        0.0
    };
    column_web::panel_shear(rows.shear_area(), c.fy, s.clear_depth(), s.tw, stiffeners, joint.gamma_m0).map(Some)
}

/// What the compressed and the sheared components leave of the sum of the rows.
fn limits(joint: &EndPlateJoint, rows: &Rows<'_>, beam_moment: f64, panel: Option<&Worked>) -> Vec<Worked> {
    let b = &joint.beam;
    let mut out = Vec::new();
    if let Some(c) = &joint.column {
        let s = &c.section;
        // the plate reaches below the compressed flange, the column to its end
        let overhang = -0.5 * b.section.h - joint.plate.bottom;
        let t = joint.plate.thickness;
        let width = column_web::compressed_width(b.section.tf, b.flange_throat, s.tf, s.r, t, overhang);
        let centre = 0.5 * (b.section.h - b.section.tf);
        let width = (0.5 * width).min(c.below - centre).max(0.0) + 0.5 * width;
        let web = CompressedWeb {
            effective_width: width,
            web: column_web::compressed_thickness(s.tw, c.doublers),
            clear_depth: s.clear_depth(),
            fy: c.fy,
            young: joint.young,
            omega: column_web::shear_interaction(joint.beta, width, s.tw, rows.shear_area()),
            longitudinal: c.longitudinal,
            gamma_m0: joint.gamma_m0,
            gamma_m1: joint.gamma_m1,
        };
        let stiffened = c.stiffener > 0.0;
        out.push(if stiffened { web.stiffened(0.5 * (s.b - s.tw), c.stiffener) } else { web.resistance() });
    }
    out.push(beam::flange_compression(&b.section, beam_moment, b.fy, joint.gamma_m0));
    if let Some(panel) = panel {
        let mut panel = panel.clone();
        if joint.beta != 1.0 {
            panel.value /= joint.beta;
            panel.formula += &format!("; over β = {}: {}", number(joint.beta), Unit::Force.show(panel.value));
        }
        out.push(panel);
    }
    out
}

/// Utilisation of a joint under moment and axial force of the beam, to be at most 1: M_j,Ed/M_j,Rd while |N_Ed| ≤ 5 % of
/// N_pl,Rd, otherwise `M_j,Ed/M_j,Rd + N_j,Ed/N_j,Rd`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.7.1(2) and (3), formula 6.24.
pub fn moment_and_axial(moment: [f64; 2], axial: [f64; 2], plastic_axial: f64) -> Worked {
    let ([m_ed, m_rd], [n_ed, n_rd]) = (moment.map(f64::abs), axial.map(f64::abs));
    let small = n_ed <= SMALL_AXIAL * plastic_axial;
    let value = if small { m_ed / m_rd } else { m_ed / m_rd + n_ed / n_rd };
    let show = |x: f64| Unit::Moment.show(x);
    let kn = |x: f64| Unit::Force.show(x);
    let formula = match small {
        true => format!("M_j,Ed/M_j,Rd = {}/{}, N_Ed = {} ≤ 0.05 N_pl,Rd", show(m_ed), show(m_rd), kn(n_ed)),
        false => format!("M_j,Ed/M_j,Rd + N_j,Ed/N_j,Rd = {}/{} + {}/{}", show(m_ed), show(m_rd), kn(n_ed), kn(n_rd)),
    };
    Worked::new("EN 1993-1-8:2005 6.2.7.1(3)", "moment and axial force of the joint", value, Unit::Number, formula)
}
