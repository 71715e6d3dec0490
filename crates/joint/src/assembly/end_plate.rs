//! The data of a bolted end plate for the hand checks: the template's `hand_checks` with their
//! values.

use super::actions::PlaneActions;
use super::builder::Context;
use super::code_values::CodeValues;
use super::column_ends::ColumnEnds;
use super::column_span::ColumnSpan;
use super::content::NotChecked;
use super::error::AssemblyError;
use super::rafter::{Rafter, rafter};
use super::small_actions::SmallActions;
use super::spec_checks::system_length;
use super::template::EndPlateEntry;
use crate::catalog::{BoltGrade, BoltSize, IProfile};
use crate::spec::code::{FySource, PartialFactors, PryingRule};
use crate::spec::connection::{BoltCategory, ConnectionSpec};
use crate::spec::expr::{Expr, ExprError};
use crate::spec::loads::LoadSpec;
use crate::spec::welds::WeldSpec;
use crate::strength::Strength;
use bracket_base::say;
use bracket_base::units::limits;
use bracket_base::words::Text;
use serde::Serialize;

/// Cut-off of a stiffener beyond the root radius \[mm\], where the template gives none. Source:
/// usual practice.
const CLIP_BEYOND_ROOT: f64 = 5.0;

/// The column to which an end plate is bolted. Lengths in mm; z is measured from the beam's axis,
/// positive upwards.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ColumnSide {
    /// Section of the column.
    pub section: IProfile,
    /// Steel of the column at the thickness of its flange.
    pub steel: Strength,
    /// z from the beam's axis to the upper end of the column; `None`: the column continues.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub above: Option<f64>,
    /// z from the beam's axis to the lower end of the column; `None`: the column continues.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub below: Option<f64>,
    /// Thickness of the stiffeners; 0: no stiffeners.
    pub stiffener: f64,
    /// Throat of the welds of the stiffeners; 0: butt welds.
    pub stiffener_throat: f64,
    /// Length cut off each stiffener at the root of the column.
    pub stiffener_clip: f64,
    /// Thickness of a supplementary web plate; 0: none.
    pub doubler: f64,
    /// Throat of the welds of the supplementary web plate; 0: butt welds.
    pub doubler_throat: f64,
    /// β for load cases that have no β of their own.
    pub beta: f64,
    /// Axial force of the column beside the joint, tension positive \[N\], if the spec gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial: Option<f64>,
    /// Largest moment of the column beside the joint about its strong axis \[N mm\], if the spec
    /// gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment: Option<f64>,
    /// Reduction of the shear force of the web panel by the column's shear forces, (V_c1 − V_c2)/2
    /// \[N\].
    pub shear: f64,
    /// System length of the column (its storey height), if the spec gives it.
    pub system_length: Option<f64>,
    /// The column of the model between its supports; `None` where it is not known as a beam.
    pub span: Option<ColumnSpan>,
}

impl ColumnSide {
    /// Where the column really ends.
    pub fn ends(&self) -> ColumnEnds {
        ColumnEnds { above: self.above, below: self.below }
    }
}

/// A load that the checks leave out.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UnseenLoad {
    /// Its load case.
    pub case: String,
    /// The reason in one sentence.
    pub why: Text,
    /// What would bring it into the checks.
    pub step: Text,
}

/// A bolted end plate between a beam and the flange of a column, or between two beams with the same
/// plate. Lengths in mm; z is measured from the beam's axis, or from the middle of the depth of a
/// [`Rafter`] at the plate, positive upwards.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EndPlate {
    /// The column; `None` for a splice.
    pub column: Option<ColumnSide>,
    /// Section of the beam.
    pub beam: IProfile,
    /// Steel of the beam at the thickness of its flange.
    pub beam_steel: Strength,
    /// Steel of the plate.
    pub plate_steel: Strength,
    /// Size of the bolts.
    pub bolt: BoltSize,
    /// Grade of the bolts.
    pub grade: BoltGrade,
    /// Thickness of the plate.
    pub thickness: f64,
    /// Width of the plate.
    pub width: f64,
    /// z of the lower edge of the plate.
    pub bottom: f64,
    /// z of the upper edge of the plate.
    pub top: f64,
    /// Distance between the two columns of bolts.
    pub gauge: f64,
    /// Distance between the two outer columns of bolts; 0 where a row has two bolts.
    pub outer_gauge: f64,
    /// z of the bolt rows, in the order of the spec.
    pub rows: Vec<f64>,
    /// Diameter of the holes.
    pub hole: f64,
    /// Thickness of a rib on the beam's upper flange; 0: none.
    pub rib: f64,
    /// Throat of the welds of the rib; 0: butt welds.
    pub rib_throat: f64,
    /// Throat of the welds of the beam's flanges; 0: butt welds.
    pub flange_throat: f64,
    /// Throat of the welds of the beam's web; 0: butt welds.
    pub web_throat: f64,
    /// Length of the beam between the plates and the section on which the actions act; 0 if
    /// unknown.
    pub bending_length: f64,
    /// System length of the beam, if the spec gives it.
    pub system_length: Option<f64>,
    /// Thickness that the bolts clamp, that of further plates under head or nut included; the
    /// largest, if they differ.
    pub grip: f64,
    /// Slope and haunch of the beam; `None`: its axis is normal to the plate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rafter: Option<Box<Rafter>>,
    /// What the geometry has and the checks do not cover.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_checked: Vec<NotChecked>,
    /// Actions on the plates, one entry per load case and member end.
    pub actions: Vec<PlaneActions>,
    /// Preload of a bolt \[N\]; `None`: the bolts are not preloaded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub preload: Option<f64>,
    /// Category of the bolts, if the spec gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub category: Option<BoltCategory>,
    /// Friction coefficient of the contact surfaces.
    pub mu: f64,
    /// Loads that the checks leave out.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unseen: Vec<UnseenLoad>,
    /// True if prying forces are assumed to develop whatever the length of the bolts.
    pub always_prying: bool,
    /// How the fillet welds are made.
    #[serde(skip_serializing_if = "WeldSpec::is_default")]
    pub welds: WeldSpec,
    /// National annex, as the catalogue names it; `None`: the recommended values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub annex: Option<String>,
    /// Table that the yield strengths come from.
    pub fy_source: FySource,
    /// Partial factors of the design code.
    #[serde(flatten)]
    pub factors: PartialFactors,
}

impl EndPlate {
    /// Depth of the beam at the plate with its haunch, along the plate \[mm\].
    pub fn depth(&self) -> f64 {
        self.rafter.as_ref().map_or(self.beam.h, |r| r.depth)
    }

    /// The flanges at the plate, the lowest first: from z to z \[mm\]. A haunch has its own flange
    /// below those of the beam.
    pub fn flanges(&self) -> Vec<[f64; 2]> {
        let half = 0.5 * self.depth();
        let Some(r) = &self.rafter else {
            let t = self.beam.tf;
            return vec![[-half, -half + t], [half - t, half]];
        };
        let (t, height) = (self.beam.tf / r.slope.cos(), self.beam.h / r.slope.cos());
        let mut out = vec![[half - height, half - height + t], [half - t, half]];
        if let Some(h) = &r.haunch {
            out.insert(0, [-half, -half + h.flange / r.lower_slope().cos()]);
        }
        out
    }

    /// The middles of the lowest and the highest flange at the plate: z \[mm\].
    pub fn flange_levels(&self) -> [f64; 2] {
        let all = self.flanges();
        [all[0], all[all.len() - 1]].map(|f| 0.5 * (f[0] + f[1]))
    }

    /// y of every column of bolts \[mm\].
    pub fn columns(&self) -> Vec<f64> {
        let pair = |gauge: f64| [-0.5 * gauge, 0.5 * gauge];
        let mut out = pair(self.gauge).to_vec();
        if self.outer_gauge > 0.0 {
            out.extend(pair(self.outer_gauge));
        }
        out.sort_by(f64::total_cmp);
        out
    }

    /// Name of a load case: with the member end where actions stand at several ends.
    pub fn case_name(&self, a: &PlaneActions) -> String {
        match self.actions.iter().any(|other| other.end != a.end) {
            true => format!("{}, {}", a.case, a.end),
            false => a.case.clone(),
        }
    }

    /// Number of bolts of one end plate.
    pub fn bolt_count(&self) -> usize {
        self.rows.len() * self.columns().len()
    }
}

/// Loads that the hand checks leave out: loads at member ends that `hand_checks` does not name, and
/// loads on sections in a case with actions at member ends, unless the spec gives the forces of the
/// column, whose role is `column`.
pub(super) fn unseen(
    spec: &ConnectionSpec,
    ends: &[String],
    column: Option<&String>,
    small: &SmallActions,
) -> Vec<UnseenLoad> {
    let loads = || spec.loads.iter().filter(|l| !l.of_polygon && small.counts(l));
    let demanded = |case: &str| loads().any(|l| l.name == case && l.end.is_some());
    let given = column
        .and_then(|c| spec.members.get(c))
        .is_some_and(|m| m.n_ed.is_some() || m.m_ed.is_some());
    let why = |l: &LoadSpec| match (&l.end, &l.section) {
        (Some(end), _) if !ends.contains(end) => Some((
            say!(
                "`{}` is none of the ends that `hand_checks` of the template name: what acts \
                 there is not checked",
                end
            ),
            "a template that names this end".into(),
        )),
        (None, Some(section)) if demanded(&l.name) && !given => {
            let step = match column {
                Some(c) => say!("members.{}.N_Ed and M_Ed in the spec", c),
                None => "a load at a member end in its place".into(),
            };
            let why =
                say!("what acts on `{}` beside the member ends is not in the checks", section);
            Some((why, step))
        }
        _ => None,
    };
    let of = |l: &LoadSpec| {
        let (why, step) = why(l)?;
        Some(UnseenLoad { case: l.name.clone(), why, step })
    };
    loads().filter_map(of).collect()
}

/// The values of the template's `hand_checks`.
pub(super) fn end_plate(
    context: &Context<'_>,
    entry: &EndPlateEntry,
    code: &CodeValues,
    actions: Vec<PlaneActions>,
) -> Result<EndPlate, AssemblyError> {
    let &Context { spec, inputs, scope, small, .. } = context;
    let wrong = |key: &str, problem: String| AssemblyError::TemplateEntry {
        at: format!("hand_checks.{key}"),
        problem,
    };
    let named = |key: &str, result: Result<f64, ExprError>| {
        result.map_err(|cause| AssemblyError::Template { at: format!("hand_checks.{key}"), cause })
    };
    // evaluates a length and compares it with its smallest allowed value
    let length = |key: &'static str, e: &Expr, least: Option<f64>| {
        let value = named(key, scope.length(e))?;
        match least {
            Some(least) if !limits::at_least(value, least) => {
                let limit = if least == f64::MIN_POSITIVE {
                    "above 0".into()
                } else {
                    format!("at least {least} mm")
                };
                Err(wrong(key, format!("{value} mm; it must be {limit}")))
            }
            _ => Ok(value),
        }
    };
    let (positive, some) = (Some(f64::MIN_POSITIVE), Some(0.0));
    let profile = |key: &str, role: &str| {
        let found = inputs.profile(role);
        found.cloned().ok_or_else(|| wrong(key, format!("there is no member `{role}`")))
    };
    let beam = profile("beam", &entry.beam)?;
    let Some((bolt, grade)) = inputs.bolt else {
        return Err(wrong("rows", "the template has no `bolts`".into()));
    };
    let rows = scope.list(&entry.rows).map_err(|problem| wrong("rows", problem))?;
    let thickness = length("thickness", &entry.thickness, positive)?;
    let or_none = |key, e: &Option<Expr>| e.as_ref().map_or(Ok(0.0), |e| length(key, e, some));
    let (bottom, top) = (length("bottom", &entry.bottom, None)?, length("top", &entry.top, None)?);
    if bottom >= top {
        return Err(wrong(
            "top",
            format!("the upper edge {top} mm is not above the lower edge {bottom} mm"),
        ));
    }
    let role = |r: &String| std::slice::from_ref(r).to_vec();
    let end_of_column = |key, e| or_none(key, e).map(|end| (end > 0.0).then_some(end));
    let (height, depth) =
        ((top - bottom, "height of the end plate"), (beam.h, "depth of the beam"));
    let column = match &entry.column {
        None => None,
        Some(column) => {
            let section = profile("column", column)?;
            let Some(beta) = &entry.beta else {
                return Err(wrong(
                    "beta",
                    "it is missing; a template with a `column` gives it".into(),
                ));
            };
            let beta = named("beta", scope.number(beta))?;
            if !(0.0..=2.0).contains(&beta) {
                return Err(wrong("beta", format!("{beta} does not lie between 0 and 2")));
            }
            let steel = inputs.strength(spec, &role(column), section.tf)?;
            let forces = spec.members.get(column);
            Some(ColumnSide {
                axial: forces.and_then(|m| m.n_ed).map(|n| n.0),
                moment: forces.and_then(|m| m.m_ed).map(|m| m.0),
                shear: forces.and_then(|m| m.v_ed).map_or(0.0, |v| v.0),
                steel,
                stiffener_throat: or_none("stiffener_throat", &entry.stiffener_throat)?,
                stiffener_clip: match &entry.stiffener_clip {
                    Some(clip) => length("stiffener_clip", clip, some)?,
                    None => section.r + CLIP_BEYOND_ROOT,
                },
                doubler_throat: or_none("doubler_throat", &entry.doubler_throat)?,
                section,
                above: end_of_column("column_above", &entry.column_above)?,
                below: end_of_column("column_below", &entry.column_below)?,
                stiffener: or_none("stiffener", &entry.stiffener)?,
                doubler: or_none("doubler", &entry.doubler)?,
                beta,
                system_length: system_length(spec, column, height)?,
                span: None,
            })
        }
    };
    let column_flange = column.as_ref().map(|c: &ColumnSide| c.section.tf);
    Ok(EndPlate {
        beam_steel: inputs.strength(spec, &role(&entry.beam), beam.tf)?,
        plate_steel: inputs.strength(spec, &entry.steel, thickness)?,
        column,
        beam,
        bolt: bolt.clone(),
        grade: grade.clone(),
        thickness,
        width: length("width", &entry.width, positive)?,
        bottom,
        top,
        gauge: length("gauge", &entry.gauge, positive)?,
        outer_gauge: or_none("outer_gauge", &entry.outer_gauge)?,
        rows,
        hole: length("hole", &entry.hole, Some(bolt.d))?,
        // the geometry says more
        grip: thickness + column_flange.unwrap_or(thickness),
        rafter: entry.rafter.as_ref().map(|r| rafter(context, r).map(Box::new)).transpose()?,
        not_checked: Vec::new(),
        rib: or_none("rib", &entry.rib)?,
        rib_throat: or_none("rib_throat", &entry.rib_throat)?,
        flange_throat: or_none("flange_throat", &entry.flange_throat)?,
        web_throat: or_none("web_throat", &entry.web_throat)?,
        bending_length: or_none("bending_length", &entry.bending_length)?,
        system_length: system_length(spec, &entry.beam, depth)?,
        actions,
        preload: inputs.preload,
        category: spec.bolts.as_ref().and_then(|b| b.category),
        mu: inputs.mu,
        unseen: unseen(spec, &entry.ends, entry.column.as_ref(), small),
        always_prying: spec.code.prying == PryingRule::Always,
        welds: spec.welds,
        annex: code.annex.clone(),
        fy_source: spec.code.fy_source,
        factors: code.factors,
    })
}
