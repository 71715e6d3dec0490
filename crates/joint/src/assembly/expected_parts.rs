//! Compares the bolts, plates and members that the hand checks of a family know with those of the
//! geometry. A verdict by code must cover all of it, and must not count what is not there.

use super::assembly::Assembly;
use super::content::{Content, Extent, Fastener, Length, NotChecked, PieceKind, SAME_PLACE};
use super::coverage::others;
use super::error::AssemblyError;
use bracket_base::math::vec3::V3;
use bracket_base::say;
use bracket_base::words::Text;

/// Most bolts that a message names.
const NAMED: usize = 4;

/// A bolt that the checks count.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ExpectedBolt {
    /// Axis of its shank, 0 = x.
    pub axis: usize,
    /// Its place on the two other axes; the value along the shank counts only where it tells two
    /// bolts on one line apart \[mm\].
    pub at: [f64; 3],
    /// Thickness of the plies from head to nut, or from nut to head \[mm\].
    pub plies: Vec<f64>,
}

/// A plate that the checks count.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ExpectedPlate {
    /// What it is.
    pub label: &'static str,
    /// Its place \[mm\].
    pub extent: Extent,
}

/// Flanges and webs of a member that the checks count.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ExpectedMember {
    /// Its role.
    pub role: String,
    /// Where its flanges lie; `None`: anywhere.
    pub flanges: Option<Flanges>,
}

/// Where the flanges of a member lie on its axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Flanges {
    /// Axis of the section's depth, 0 = x.
    pub depth: usize,
    /// Where its web begins at the joint \[mm\].
    pub web: f64,
    /// Each flange: the sign of its side on the axis of the depth, and where it begins at the joint
    /// \[mm\].
    pub starts: [(f64, f64); 2],
}

impl Flanges {
    /// Whether the flanges and the web of a length of profile begin there.
    fn fit(&self, m: &Length) -> bool {
        let (extent, k) = (m.extent(), m.along);
        let ends = |e: &Extent, at: f64| same(e[k][0], at) || same(e[k][1], at);
        let middle = 0.5 * (extent[self.depth][0] + extent[self.depth][1]);
        let flange = |(side, at): &(f64, f64)| {
            let on_side = |f: &&Extent| (f[self.depth][0] - middle) * side > 0.0;
            m.flanges.iter().filter(on_side).any(|f| ends(f, *at))
        };
        ends(&extent, self.web) && self.starts.iter().all(flange)
    }
}

/// What the checks of a family know of the geometry.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Expected {
    pub bolts: Vec<ExpectedBolt>,
    pub plates: Vec<ExpectedPlate>,
    pub members: Vec<ExpectedMember>,
    /// Throat of the fillet welds of the plates; 0: butt welds.
    pub throats: Vec<f64>,
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < SAME_PLACE
}

/// Whether two boxes are one but for rounding.
pub(super) fn same_extent(a: &Extent, b: &Extent) -> bool {
    a.as_flattened().iter().zip(b.as_flattened()).all(|(a, b)| same(*a, *b))
}

/// The box between two corners.
pub(super) fn between(p: V3, q: V3) -> Extent {
    [0, 1, 2].map(|k| [p[k].min(q[k]), p[k].max(q[k])])
}

impl Expected {
    /// Marks what the checks know in `content`, and returns what they do not cover. Bolts that
    /// differ are refused: a check of some bolts would be no check of the joint.
    pub fn compare(
        &self,
        content: &mut Content,
        assembly: &Assembly,
    ) -> Result<Vec<NotChecked>, AssemblyError> {
        self.bolts_agree(&content.fasteners)?;
        for p in &mut content.pieces {
            let is = |e: &&ExpectedPlate| p.is_box() && same_extent(&e.extent, &p.extent);
            if let Some(found) = self.plates.iter().find(is) {
                p.kind = PieceKind::Checked;
                p.label = found.label.into();
            }
        }
        for m in &mut content.members {
            m.known = m.turn.is_none() && self.members.iter().any(|e| e.role == m.role);
        }
        let mut out = self.absent(content);
        out.extend(self.other_plies(content));
        out.extend(self.other_flanges(content));
        out.extend(self.other_welds(content, assembly));
        out.extend(others(content, &[]));
        Ok(out)
    }

    fn bolts_agree(&self, bolts: &[Fastener]) -> Result<(), AssemblyError> {
        let unseen = bolts.iter().filter(|b| !self.bolts.iter().any(|e| e.is(b)));
        let unseen: Vec<String> = unseen.map(|b| b.name.clone()).collect();
        let absent = self.bolts.iter().filter(|e| !bolts.iter().any(|b| e.is(b))).count();
        if unseen.is_empty() && absent == 0 && bolts.len() == self.bolts.len() {
            return Ok(());
        }
        let mut named = unseen.clone();
        named.truncate(NAMED);
        let which = match (unseen.len(), absent) {
            (0, _) => format!("{absent} of them are not in the geometry"),
            (n, _) => format!("{n} of the geometry are none of these: {}", named.join(", ")),
        };
        Err(AssemblyError::UnseenBolts {
            at: "hand_checks".into(),
            problem: format!(
                "it sees {} bolts, the geometry has {}; {which}",
                self.bolts.len(),
                bolts.len()
            ),
            help: "write the rows and columns of `hand_checks` so that they are the bolts of the \
                   template, or leave `hand_checks` out"
                .into(),
        })
    }

    /// What the checks count and the geometry lacks.
    fn absent(&self, content: &Content) -> Vec<NotChecked> {
        let absent = |e: &&ExpectedPlate| {
            !content.pieces.iter().any(|p| p.is_box() && same_extent(&e.extent, &p.extent))
        };
        let one = |e: &ExpectedPlate| {
            let why = "`hand_checks` of the template counts it, and the parts of the template have \
                       none at that place with these sizes";
            fault(
                vec![e.label.into()],
                e.label.into(),
                why.into(),
                "a template whose parts and `hand_checks` agree".into(),
            )
        };
        self.plates.iter().filter(absent).map(one).collect()
    }

    /// Bolts through other plies than the checks take.
    fn other_plies(&self, content: &Content) -> Option<NotChecked> {
        let strange = content.fasteners.iter().filter(|b| {
            let own: Vec<f64> = b.through.iter().map(|p| p.thickness).collect();
            let fits = |plies: &[f64]| {
                let both = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| same(*a, *b));
                let reversed: Vec<f64> = own.iter().rev().copied().collect();
                plies.len() == own.len() && (both(plies, &own) || both(plies, &reversed))
            };
            !self.bolts.iter().any(|e| e.is(b) && fits(&e.plies))
        });
        let strange: Vec<Text> = strange.map(|b| Text::given(&b.name)).collect();
        let why = "the checks take these bolts through other plies, or plies of other thicknesses";
        let step = "bolts through the plies that `hand_checks` names alone, or a check of them by \
                    hand";
        (!strange.is_empty()).then(|| fault(strange, "bolts".into(), why.into(), step.into()))
    }

    /// Members whose flanges end elsewhere than the checks take: other gaps or notches.
    fn other_flanges(&self, content: &Content) -> Vec<NotChecked> {
        let mut out = Vec::new();
        for m in &content.members {
            let expected = self.members.iter().filter(|e| e.role == m.role);
            let wanted: Vec<_> = expected.filter_map(|e| e.flanges.as_ref()).collect();
            if !wanted.is_empty() && !wanted.iter().any(|f| f.fit(m)) {
                let why = "its flanges end elsewhere than the checks take: another gap, or other \
                           notches";
                let step = "a template whose parts and `hand_checks` agree";
                out.push(fault(
                    vec![Text::given(&m.part)],
                    m.label.clone(),
                    why.into(),
                    step.into(),
                ));
            }
        }
        out
    }

    /// Fillet welds of other throats than the checks take.
    fn other_welds(&self, content: &Content, assembly: &Assembly) -> Option<NotChecked> {
        let of_plate = |part: &str| {
            content.pieces.iter().any(|p| p.kind == PieceKind::Checked && p.part == part)
        };
        let strange = assembly.welds.iter().filter(|w| {
            w.between.iter().any(|p| of_plate(p))
                && !self.throats.iter().any(|t| same(w.throat, *t))
        });
        let strange: Vec<Text> = strange.map(|w| Text::given(&w.name)).collect();
        let step = "a check of these welds by hand";
        let mut throats: Vec<f64> = self.throats.iter().copied().filter(|a| *a > 0.0).collect();
        throats.dedup();
        let throats: Vec<String> = throats.iter().map(f64::to_string).collect();
        let why = match throats.is_empty() {
            true => "the checks take butt welds".into(),
            false => say!("the checks take welds with a throat of {} mm", throats.join(" or ")),
        };
        (!strange.is_empty()).then(|| fault(strange, "welds".into(), why, step.into()))
    }
}

impl ExpectedBolt {
    fn is(&self, b: &Fastener) -> bool {
        let nut = b.head[b.axis] + b.toward * b.grip();
        let [low, high] = [b.head[b.axis].min(nut), b.head[b.axis].max(nut)];
        b.axis == self.axis
            && (0..3).all(|k| match k == b.axis {
                true => (low - SAME_PLACE..=high + SAME_PLACE).contains(&self.at[k]),
                false => same(self.at[k], b.head[k]),
            })
    }
}

fn fault(parts: Vec<Text>, label: Text, why: Text, step: Text) -> NotChecked {
    NotChecked { parts, label, why, step, binds: true }
}
