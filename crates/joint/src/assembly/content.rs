//! What a joint is made of: members, plates, bolts with the parts that they clamp, and welds. Lists
//! and drawings show it.

use super::block::Block;
pub use super::extent::{Extent, SAME_PLACE, cut, minus, touching, union};
use super::turn::Turn;
use bracket_base::words::Text;
use serde::Serialize;

/// What a plate is in the joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum PieceKind {
    /// An end plate of the hand checks.
    EndPlate,
    /// A stiffener of the column, level with a beam flange.
    Stiffener,
    /// A supplementary plate on the column web.
    Doubler,
    /// A rib on the beam.
    Rib,
    /// The web or the flange of a haunch below the beam, or a stiffener of the beam at its tip.
    Haunch,
    /// A plate of the hand checks of another family than the end plate's.
    Checked,
    /// A plate that the hand checks do not know.
    Other,
}

/// A plate: a box of the template. A box that the web of a profile cuts is two plates.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Piece {
    /// The part that it belongs to.
    pub part: String,
    /// Words for lists.
    pub label: Text,
    /// What it is.
    pub kind: PieceKind,
    /// Its extent before it is turned; of a plate with an outline the box round it.
    pub extent: Extent,
    /// How it is turned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turn: Option<Turn>,
    /// Axis of its thickness and its outline on the next two axes, before it is turned, where it is
    /// no box \[mm\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outline: Option<(usize, Vec<[f64; 2]>)>,
    /// What it is in space, where it is turned or has an outline; an outline may be a polygon that
    /// is not convex.
    #[serde(skip)]
    pub drawn: Vec<Block>,
    /// Axis of its height, 0 = x, where the hand checks know it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub upright: Option<usize>,
    /// Steel grade.
    pub steel: String,
    /// Reason of the template why it needs no check by code.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_check: Option<Text>,
}

impl Piece {
    /// True if it is a box along the axes of the joint.
    pub fn is_box(&self) -> bool {
        self.turn.is_none() && self.outline.is_none()
    }

    /// The box round it in space.
    pub fn bounds(&self) -> Extent {
        bounds(&self.drawn, || self.extent)
    }

    /// What it is in space; a box is a block along y.
    pub fn solids(&self) -> Vec<Block> {
        match self.is_box() {
            true => vec![Block::of(&self.extent, 1)],
            false => self.drawn.clone(),
        }
    }

    /// Size along an axis \[mm\].
    pub fn size(&self, axis: usize) -> f64 {
        self.extent[axis][1] - self.extent[axis][0]
    }

    /// Thickness, width and length \[mm\]; the length is the height where the hand checks know it.
    pub fn sizes(&self) -> [f64; 3] {
        let mut sizes = [0, 1, 2].map(|k| self.size(k));
        match self.upright {
            Some(k) => {
                sizes.swap(k, 2);
                sizes[..2].sort_by(f64::total_cmp);
            }
            None => sizes.sort_by(f64::total_cmp),
        }
        sizes
    }
}

/// A length of a rolled section.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Length {
    /// The part that it belongs to.
    pub part: String,
    /// Words for lists.
    pub label: Text,
    /// Member role of the spec.
    pub role: String,
    /// Name of the section.
    pub profile: String,
    /// Axis of the member, 0 = x.
    pub along: usize,
    /// Its flanges; a notch shortens them.
    pub flanges: Vec<Extent>,
    /// Its web, in pieces beside notches.
    pub web: Vec<Extent>,
    /// The sides of a circular hollow section as slabs, each with its turn.
    #[serde(skip)]
    pub facets: Vec<(Extent, Turn)>,
    /// How it is turned; flanges and web are those before the turn, and without its cuts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turn: Option<Turn>,
    /// What it is in space, where it is turned or round.
    #[serde(skip)]
    pub drawn: Vec<Block>,
    /// True if the hand checks know it.
    pub known: bool,
    /// Steel grade.
    pub steel: String,
    /// Reason of the template why it needs no check by code.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_check: Option<Text>,
}

impl Length {
    /// Flanges and web.
    pub fn blocks(&self) -> impl Iterator<Item = &Extent> {
        self.flanges.iter().chain(&self.web)
    }

    /// Extent of the whole section before it is turned.
    pub fn extent(&self) -> Extent {
        let round = self.facets.iter().map(|(e, t)| Block::of(e, t.axis).turned(t).bounds());
        self.blocks().copied().chain(round).reduce(union).unwrap_or_default()
    }

    /// The box round it in space.
    pub fn bounds(&self) -> Extent {
        bounds(&self.drawn, || self.extent())
    }

    /// What it is in space; boxes are blocks along y.
    pub fn solids(&self) -> Vec<Block> {
        match self.drawn.is_empty() {
            false => self.drawn.clone(),
            true => self.blocks().map(|b| Block::of(b, 1)).collect(),
        }
    }

    /// The boxes round its flanges and its web in space.
    pub fn plates_in_space(&self) -> Vec<Extent> {
        match self.drawn.is_empty() {
            false => self.drawn.iter().map(Block::bounds).collect(),
            true => self.blocks().copied().collect(),
        }
    }
}

/// The box round blocks, or another one without any.
fn bounds(blocks: &[Block], otherwise: impl Fn() -> Extent) -> Extent {
    blocks.iter().map(Block::bounds).reduce(union).unwrap_or_else(otherwise)
}

/// A part that a bolt passes through.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ply {
    /// The part.
    pub part: String,
    /// Its thickness \[mm\].
    pub thickness: f64,
}

/// A bolt.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fastener {
    /// Its part.
    pub name: String,
    /// Axis of the shank, 0 = x.
    pub axis: usize,
    /// Direction from head to nut along the axis: 1 or −1.
    pub toward: f64,
    /// Centre of the head's bearing face \[mm\].
    pub head: [f64; 3],
    /// Length of an anchor below the parts, to where it is held \[mm\]; `None`: a bolt.
    pub anchor: Option<f64>,
    /// What it clamps, from head to nut.
    pub through: Vec<Ply>,
}

impl Fastener {
    /// Thickness that the bolt clamps \[mm\].
    pub fn grip(&self) -> f64 {
        self.through.iter().map(|p| p.thickness).sum()
    }

    /// True if it passes the part.
    pub fn passes(&self, part: &str) -> bool {
        self.through.iter().any(|p| p.part == part)
    }
}

/// Welds between two parts of which the hand checks do not know one.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Seam {
    /// The two parts.
    pub between: [String; 2],
    /// Throat of fillet welds \[mm\]; 0: the parts are one body or tied, full penetration.
    pub throat: f64,
    /// Length of all of them \[mm\].
    pub length: f64,
}

/// Parts that no check by code covers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NotChecked {
    /// Names of the parts.
    pub parts: Vec<Text>,
    /// What they are.
    pub label: Text,
    /// Reason, in a sentence.
    pub why: Text,
    /// What would decide about them; empty where nothing binds.
    pub step: Text,
    /// True if a verdict by code cannot be OK for this reason.
    pub binds: bool,
}

/// All that a joint is made of.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Content {
    /// Rolled members.
    pub members: Vec<Length>,
    /// Plates.
    pub pieces: Vec<Piece>,
    /// Bolts.
    pub fasteners: Vec<Fastener>,
    /// Size and grade of the bolts; `None` without bolts.
    pub bolt: Option<(crate::catalog::BoltSize, crate::catalog::BoltGrade)>,
    /// Welds beside those of the hand checks.
    pub seams: Vec<Seam>,
    /// What no check by code covers.
    pub not_checked: Vec<NotChecked>,
}

impl Content {
    /// Number of end plates of the hand checks.
    pub fn end_plates(&self) -> usize {
        self.pieces.iter().filter(|p| p.kind == PieceKind::EndPlate).count()
    }
}
