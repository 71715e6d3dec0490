//! Assembly of the components: row forces and moment resistance. EN 1993-1-8:2005 6.2.7.2.

use super::column_web::{self, ShearPanel};
use super::component_kind::{ComponentKind, ElasticRule, LimitedBy, Summed};
use super::compressed_zone::CompressedZone;
use super::joint::EndPlateJoint;
use super::rows::{Component, Rows};
use super::stability::{Stability, stability};
use super::t_stub::Mode;
use super::{beam, stiffness};
use crate::check::{CheckId, Unit, within};
use crate::error::CheckError;
use crate::formula::{Formula, Traced};
use crate::subject::Part;
use crate::worked::Worked;
use bracket_joint::assembly::Way;

/// Force of a row over F_t,Rd of one bolt above which the rows below stay elastic, 6.2.7.2(9).
const NEARLY_BOLTS: f64 = 1.9;

/// Largest force of a row that stays elastic beside the rows above \[N\], and the rule; the row
/// has the lever arm `lever`.
///
/// `F_tr,Rd ≤ F_tx,Rd h_r/h_x` below every row x with more than 1.9 F_t,Rd; with the triangular
/// limit, below the outermost row whatever its force.
///
/// # Source
/// EN 1993-1-8:2005 6.2.7.2(9), formula 6.26; the UK annex, NA.2.7, for the outermost row.
pub(super) fn elastic_limit(
    joint: &EndPlateJoint,
    above: &[RowForce],
    lever: f64,
) -> Option<(f64, ElasticRule)> {
    let of = |x: &RowForce| x.grouped * lever / x.lever;
    let near = above.iter().filter(|x| x.nearly_bolts(joint.bolts.tension));
    let near = near.map(|x| (of(x), ElasticRule::NearlyBolts));
    let outermost = above.first().filter(|_| joint.triangular);
    let outermost = outermost.map(|x| (of(x), ElasticRule::Triangular));
    near.chain(outermost).reduce(|a, b| if b.0 < a.0 { b } else { a })
}

/// A component that the rows `first..=row` share; rows are counted from 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The first row of the group.
    pub first: usize,
    /// The component.
    pub component: Component,
}

/// Force of a row and the components that limit it.
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
    /// What limits it.
    pub limited_by: LimitedBy,
    /// The mode of the T-stub that limits it, if one does.
    pub mode: Option<Mode>,
    /// Whether 6.2.7.2(9), or the UK annex's rule in its place, reduces it.
    pub elastic: bool,
}

/// A limit of the sum of the rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The component.
    pub of: Summed,
    /// Its resistance \[N\].
    pub worked: Worked,
}

/// Resistance and stiffness of a joint for one sense of bending.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessment {
    /// Rows in tension, from the outermost.
    pub rows: Vec<RowForce>,
    /// Limits of the sum of the rows: column web and beam flange in compression, column web panel
    /// over β.
    pub limits: Vec<Limit>,
    /// V_wp,Rd of the column web panel, not over β; `None` without a column.
    pub panel: Option<Worked>,
    /// M_j,Rd.
    pub moment: Worked,
    /// M_c,Rd of the beam.
    pub beam_moment: Worked,
    /// Components that may buckle, which a limit analysis does not model.
    pub stability: Vec<Stability>,
    /// Stiffness coefficients and S_j,ini.
    pub stiffness: stiffness::Stiffness,
}

impl RowForce {
    /// Whether the row is so near to the resistance of its bolts, `bolt` F_t,Rd of one \[N\], that
    /// the rows below stay elastic, 6.2.7.2(9).
    pub(super) fn nearly_bolts(&self, bolt: f64) -> bool {
        !within(self.grouped, NEARLY_BOLTS * bolt)
    }

    /// The part whose bending, alone or with the bolts, limits the row; `None` where another
    /// component does.
    pub fn bending_of(&self) -> Option<Part> {
        self.mode.filter(|m| m.bends() && self.force > 0.0)?;
        self.limited_by.component().map(ComponentKind::part)
    }

    /// Force of one bolt of the row, prying included, under a fraction `share` of F_tr,Rd \[N\]:
    /// the plastic state of the row's T-stubs scaled down, which is in equilibrium and nowhere
    /// above its resistance.
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
        self.limits.iter().any(|l| l.of == Summed::Panel && within(l.worked.value, total))
    }

    /// Resistance of a component that limits the sum \[N\].
    pub fn limit(&self, of: Summed) -> Option<&Worked> {
        self.limits.iter().find(|l| l.of == of).map(|l| &l.worked)
    }
}

/// Row forces, moment resistance and stiffness of a joint with the tension at the top.
///
/// From the outermost row on, the force of each row is the least of: its own resistance, the rest
/// of each group, the rest of the sum that compression and shear allow, and a force in proportion
/// to its lever arm where a row above has more than 1.9 F_t,Rd. `M_j,Rd = Σ h_r F_tr,Rd`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.7.2(1) to (9), formula 6.25.
pub fn assess(joint: &EndPlateJoint) -> Result<Assessment, CheckError> {
    let rows = Rows::new(joint)?;
    let beam_moment = beam::end_bending(&joint.beam, joint.gamma_m0);
    let panel = panel(joint, &rows).map(|p| (with_stiffeners(p.resistance(), joint), p));
    let (resistance, panel) = panel.unzip();
    // with β = 0 the moments bring no shear into the panel; the shear of the column still may
    let sheared = joint.beta > 0.0;
    let limiting = resistance.as_ref().filter(|_| sheared);
    let limits = limits(joint, &rows, beam_moment.value, limiting);
    let stability = stability(joint, &rows, panel.as_ref().filter(|_| sheared));
    let (mut left, mut least) = (f64::INFINITY, None);
    for l in &limits {
        if !within(left, l.worked.value) {
            least = Some(LimitedBy::Sum(l.worked.id));
        }
        left = left.min(l.worked.value);
    }
    let mut found: Vec<RowForce> = Vec::new();
    for r in 0..rows.count() {
        let alone = rows.components(r, r);
        let mut limit = Least::none();
        for c in &alone {
            limit.lower(c.worked.value, LimitedBy::Row(c.kind), c.mode);
        }
        let single = limit.force;
        let mut groups = Vec::new();
        for first in (0..r).rev() {
            let above: f64 = found[first..].iter().map(|f| f.grouped).sum();
            for component in rows.components(first, r) {
                let by = LimitedBy::Group { component: component.kind, rows: [first, r] };
                limit.lower(component.worked.value - above, by, component.mode);
                groups.push(Group { first, component });
            }
        }
        let mut elastic = false;
        if let Some((proportional, rule)) = elastic_limit(joint, &found, rows.lever[r]) {
            elastic = proportional < limit.force;
            limit.lower(proportional, LimitedBy::Elastic(rule), None);
        }
        // the forces of the rows in a group do not depend on compression: once compression limits a
        // row, nothing remains for the rows below
        let grouped = limit.force.max(0.0);
        if let Some(by) = least {
            limit.lower(left, by, None);
        }
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
            limited_by: limit.by,
            mode: limit.mode,
            elastic,
        });
    }
    let moment = moment(&found);
    let stiffness = stiffness::initial(joint, &rows)?;
    Ok(Assessment {
        rows: found,
        limits,
        panel: resistance,
        moment,
        beam_moment,
        stability,
        stiffness,
    })
}

/// The least limit so far and its component.
struct Least {
    force: f64,
    by: LimitedBy,
    mode: Option<Mode>,
}

impl Least {
    /// Before any limit; every row has an end plate.
    fn none() -> Self {
        let by = LimitedBy::Row(ComponentKind::EndPlate);
        Self { force: f64::INFINITY, by, mode: None }
    }

    fn lower(&mut self, force: f64, by: LimitedBy, mode: Option<Mode>) {
        // of equal limits the first names the row
        if !within(self.force, force) {
            *self = Self { force, by, mode };
        }
        self.force = self.force.min(force);
    }
}

/// M_j,Rd.
fn moment(rows: &[RowForce]) -> Worked {
    let of = |r: &RowForce| Traced::length("h_r", r.lever) * Traced::force("F_tr,Rd", r.force);
    let value = Traced::series(rows.iter().filter(|r| r.force > 0.0).map(of));
    let (clause, id) = ("EN 1993-1-8:2005 6.2.7.2(1)", CheckId::MomentResistance);
    Worked::of(clause, id, "M_j,Rd", value, Unit::Moment)
}

/// The column web panel; `None` without a column.
fn panel(joint: &EndPlateJoint, rows: &Rows<'_>) -> Option<ShearPanel> {
    let c = joint.column.as_ref()?;
    let s = &c.section;
    let stiffeners = match panel_stiffeners(joint) {
        Some([flange, stiffener, distance]) => {
            column_web::stiffened_panel(flange, stiffener, distance)
        }
        None => 0.0,
    };
    Some(ShearPanel {
        area: rows.shear_area(),
        fy: c.fy,
        clear_depth: s.clear_depth(),
        web_depth: s.h - 2.0 * s.tf,
        web: s.tw,
        stiffeners,
        gamma_m0: joint.gamma_m0,
        gamma_m1: joint.gamma_m1,
    })
}

/// M_pl,fc,Rd of the column flange, M_pl,st,Rd of a stiffener \[N mm\] and their distance d_s
/// \[mm\], 6.2.6.1(4); `None` without stiffeners.
fn panel_stiffeners(joint: &EndPlateJoint) -> Option<[f64; 3]> {
    let c = joint.column.as_ref().filter(|c| c.stiffener > 0.0)?;
    let plastic = |t: f64| 0.25 * c.section.b * t * t * c.fy / joint.gamma_m0;
    Some([plastic(c.section.tf), plastic(c.stiffener), joint.beam.lever()])
}

/// The resistance of the panel with the numbers of the part that stiffeners add.
fn with_stiffeners(worked: Worked, joint: &EndPlateJoint) -> Worked {
    match panel_stiffeners(joint) {
        Some(numbers) => {
            let symbols = ["M_pl,fc,Rd", "M_pl,st,Rd", "d_s"];
            let units = [Unit::Moment, Unit::Moment, Unit::Length];
            let all = [0, 1, 2].map(|i| Traced::symbol(symbols[i], numbers[i], units[i]));
            let worked = worked.with_symbols(all.each_ref());
            let [flange, stiffener, distance] = all;
            let added = column_web::stiffened_panel(flange, stiffener, distance);
            worked.after(Formula::new("V_wp,add,Rd", added, Unit::Force))
        }
        None => worked,
    }
}

/// Limits of the sum of the rows by the components in compression and in shear.
fn limits(
    joint: &EndPlateJoint,
    rows: &Rows<'_>,
    beam_moment: f64,
    panel: Option<&Worked>,
) -> Vec<Limit> {
    let mut out = Vec::new();
    if let Some(c) = &joint.column {
        let worked = CompressedZone::new(joint, c, Way::Down, rows.shear_area()).resistance();
        out.push(Limit { of: Summed::ColumnWeb, worked });
    }
    let worked = beam::end_compression(&joint.beam, beam_moment, joint.gamma_m0);
    out.push(Limit { of: Summed::BeamFlange, worked });
    if let Some(panel) = panel {
        let mut worked = panel.clone();
        if joint.beta != 1.0 {
            let each = worked.traced() / Traced::number("β", joint.beta);
            let symbol = each.term().text();
            worked = worked.becomes(symbol, each);
        }
        out.push(Limit { of: Summed::Panel, worked });
    }
    out
}
