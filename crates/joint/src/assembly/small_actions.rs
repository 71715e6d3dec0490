//! Actions at member ends that are so small beside the member's own resistance that they are
//! neglected, in the checks as in the model.
//!
//! Tables of frame programs contain rounding: a torsion of 0.1 N m beside a moment of 250 kN m. No
//! formula of a joint covers torsion, and it turns half of a symmetric model into the whole one. An
//! action is judged at the bolt plane of its end, where the checks read it, so that the moment of a
//! shear force about the plane counts as well.

use super::error::AssemblyError;
use super::evaluate::within;
use super::member_ends::{End, Mask, Moved};
use super::scope::Scope;
use super::template::Template;
use crate::spec::connection::ConnectionSpec;
use crate::spec::loads::{Action, LimitState, LoadSpec};
use bracket_base::math::vec3::V3;
use bracket_base::say;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Share of the member's own resistance up to which T, Mz and Vy are neglected. N is not: at the
/// lever arm of the rows a part of it is a moment of a weak joint.
///
/// # Source
/// Stated by this program.
pub const SMALL: f64 = 0.01;

/// Share of the largest share of a load case up to which any action is rounding.
const ROUNDING: f64 = 1e-4;

/// Share of the member's own resistance up to which any action is rounding, the only one of its
/// load case as well.
const NOTHING: f64 = 1e-6;

/// The actions in the order of their components: along x′, y′, z′, then about them.
const ACTIONS: [[Action; 3]; 2] =
    [[Action::N, Action::Vy, Action::Vz], [Action::T, Action::My, Action::Mz]];

/// An action that is neglected.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Neglected {
    /// Load case.
    pub case: String,
    /// Member end.
    pub end: String,
    /// `N`, `Vy`, `Vz`, `T`, `My` or `Mz`.
    pub action: String,
    /// Its value at the bolt plane under load factor 1 \[N, N mm\].
    pub value: f64,
    /// Its size over the resistance.
    pub share: f64,
    /// Plastic resistance of the member's section to the action alone, for T that of St. Venant
    /// torsion at first yield \[N, N mm\].
    pub resistance: f64,
}

/// A load case in which nothing acts.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Idle {
    /// Load case.
    pub case: String,
    /// Limit state.
    pub state: LimitState,
    /// Whether it has actions at member ends: only these are a demand on the joint.
    pub demand: bool,
}

/// The small actions of a spec.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct SmallActions {
    /// Those that are neglected, in the order of the loads.
    pub neglected: Vec<Neglected>,
    /// Load cases in which nothing acts, in the order of the loads.
    pub idle: Vec<Idle>,
    /// Load cases and the member ends at which actions count.
    acting: Vec<(String, String)>,
}

/// The actions of one load at its member end.
struct Judged<'a> {
    load: &'a LoadSpec,
    end: &'a str,
    moved: Moved,
    /// Resistances in the order of [`ACTIONS`]; `None` where the member is not known.
    resistance: Option<[V3; 2]>,
}

impl Judged<'_> {
    fn size(&self, i: usize, k: usize) -> f64 {
        let [live, dead] = self.moved.parts.map(|p| p[i][k]);
        live.abs().max(dead.abs()).max((live + dead).abs())
    }

    fn share(&self, i: usize, k: usize) -> f64 {
        self.resistance.map_or(0.0, |r| self.size(i, k) / r[i][k])
    }

    /// Whether a component is small beside the resistance, `largest` the largest share of the load
    /// case.
    fn small(&self, i: usize, k: usize, largest: f64) -> bool {
        let share = self.share(i, k);
        let limit = match ACTIONS[i][k] {
            Action::T | Action::Mz | Action::Vy => SMALL,
            Action::N | Action::Vz | Action::My => 0.0,
        };
        self.resistance.is_some() && share <= limit.max(ROUNDING * largest).max(NOTHING)
    }
}

/// The components of a force and a moment.
fn components() -> impl Iterator<Item = (usize, usize)> {
    (0..2).flat_map(|i| (0..3).map(move |k| (i, k)))
}

impl SmallActions {
    /// Judges the loads at member ends beside the resistances of the members
    /// ([`CodeValues::members`](super::CodeValues::members)). The directions of a polygon are no
    /// demand and stay as they are.
    pub fn new(
        spec: &ConnectionSpec,
        template: &Template,
        members: &BTreeMap<String, [V3; 2]>,
        scope: &Scope,
        ends: &[End<'_>],
    ) -> Result<Self, AssemblyError> {
        let mut judged = Vec::new();
        for load in spec.loads.iter().filter(|l| !l.of_polygon) {
            let Some(end) = ends.iter().find(|e| load.end.as_deref() == Some(e.name.as_str()))
            else {
                continue;
            };
            let Some(moved) = end.to_plane(load)? else { continue };
            let role = member_of(template, scope, &end.part()?)?;
            let resistance = role.and_then(|r| members.get(&r).copied());
            judged.push(Judged { load, end: &end.name, moved, resistance });
        }
        let mut out = Self::default();
        for j in &judged {
            let case = judged.iter().filter(|o| o.load.name == j.load.name);
            let shares = case.flat_map(|o| components().map(|(i, k)| o.share(i, k)));
            let largest = shares.fold(0.0, f64::max);
            for (i, k) in components().filter(|(i, k)| j.size(*i, *k) > 0.0) {
                let resistance = j.resistance.filter(|_| j.small(i, k, largest));
                let Some(resistance) = resistance else {
                    out.acting.push((j.load.name.clone(), j.end.into()));
                    continue;
                };
                out.neglected.push(Neglected {
                    case: j.load.name.clone(),
                    end: j.end.into(),
                    action: ACTIONS[i][k].word().into(),
                    value: j.moved.parts.iter().map(|p| p[i][k]).sum(),
                    share: j.share(i, k),
                    resistance: resistance[i][k],
                });
            }
        }
        for load in spec.loads.iter() {
            let of_case = || spec.loads.iter().filter(|l| l.name == load.name);
            let known = out.idle.iter().any(|i| i.case == load.name);
            if known || of_case().any(|l| out.counts(l)) {
                continue;
            }
            out.idle.push(Idle {
                case: load.name.clone(),
                state: load.state,
                demand: of_case().any(|l| l.end.is_some()),
            });
        }
        Ok(out)
    }

    /// The components that are neglected at a member end; `None` where all count.
    pub fn mask(&self, load: &LoadSpec, end: &str) -> Option<Mask> {
        let of_load = |n: &&Neglected| n.case == load.name && n.end == end && !load.of_polygon;
        let mut mask = None;
        for n in self.neglected.iter().filter(of_load) {
            let mask: &mut Mask = mask.get_or_insert_default();
            for (i, k) in components().filter(|(i, k)| ACTIONS[*i][*k].word() == n.action) {
                mask[i][k] = true;
            }
        }
        mask
    }

    /// Whether a load acts, beside what is neglected.
    pub fn counts(&self, load: &LoadSpec) -> bool {
        let pressure = load.pressure.is_some_and(|p| p.0 != 0.0);
        let traction = load.traction.is_some_and(|t| t.iter().any(|s| s.0 != 0.0));
        let of_load =
            |(case, end): &(String, String)| *case == load.name && load.end.as_ref() == Some(end);
        pressure || traction || load.of_polygon || self.acting.iter().any(of_load)
    }

    /// Whether nothing acts in a load case.
    pub fn is_idle(&self, case: &str) -> bool {
        self.idle.iter().any(|i| i.case == case)
    }

    /// What the report says about neglected actions and idle load cases: a sentence each.
    pub fn notes(&self) -> Vec<Text> {
        let mut out: Vec<Text> = self.note_of_neglected().into_iter().collect();
        let idle: Vec<Text> = self.idle.iter().map(|i| say!("`{}`", &i.case)).collect();
        out.extend(match &idle[..] {
            [] => None,
            [one] => Some(say!("nothing acts in the load case {}", one)),
            all => {
                let cases = Text::joined(", ", all.to_vec());
                Some(say!("nothing acts in the load cases {}", cases))
            }
        });
        out
    }

    /// The neglected actions in one sentence, each action with its largest share.
    fn note_of_neglected(&self) -> Option<Text> {
        let of = |action: &Action| {
            let all = || self.neglected.iter().filter(|n| n.action == action.word());
            let most = all().reduce(|a, b| if b.share > a.share { b } else { a })?;
            let mut cases: Vec<&str> = all().map(|n| n.case.as_str()).collect();
            cases.dedup();
            let (unit, scale) = if action.direction().1 { ("kN m", 1e-6) } else { ("kN", 1e-3) };
            let cases = match cases.len() {
                1 => Text::given(&most.case),
                count => say!("{} load cases", count),
            };
            let value = format!("{:.2e} {unit}", most.value * scale);
            let share = format!("{:.1e}", most.share);
            Some(say!("{} = {} ({}, {})", action.word().to_owned(), value, cases, share))
        };
        let each: Vec<Text> = ACTIONS.iter().flatten().filter_map(of).collect();
        (!each.is_empty()).then(|| {
            say!(
                "actions that are neglected, because they are small beside the member's own \
                 resistance (up to 1 % for T, Mz, Vy; up to \
                 0.01 % of the largest share for any action), each with its largest value and \
                 share: {}",
                Text::joined(", ", each)
            )
        })
    }
}

/// Role of the member that a part of the joint is: that of its first profile.
fn member_of(
    template: &Template,
    scope: &Scope,
    part: &str,
) -> Result<Option<String>, AssemblyError> {
    for entry in &template.parts {
        let at = entry.name.as_str();
        for s in within(at, scope.turns(&entry.each, entry.when.as_ref()))? {
            if within(at, s.text(at))? == part {
                let profile = entry.solids.iter().find_map(|s| s.profile.as_ref());
                return Ok(profile.map(|p| p.member.clone()));
            }
        }
    }
    Ok(None)
}
