//! The solids of a member or plate as the template gives them: lengths of profiles, boxes and
//! prisms.

use super::context::Context;
use crate::assembly::axes::without;
use crate::assembly::block::{Block, crosses_itself, twice_area};
use crate::assembly::content::{
    Content, Extent, Fastener, Length, Piece, PieceKind, Ply, SAME_PLACE, cut,
};
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{block, entry_fault, within};
use crate::assembly::part::Placed;
use crate::assembly::scope::Scope;
use crate::assembly::shaped::{PlacedShape, Walls};
use crate::assembly::template::{PartEntry, PrismEntry, SolidEntry, TurnEntry};
use crate::assembly::turn::Turn;
use crate::catalog::{Section, SectionKind};
use bracket_base::say;

/// A solid in one turn of its loops.
pub(super) struct Shape<'a> {
    pub entry: &'a SolidEntry,
    pub scope: Scope,
    pub body: Body<'a>,
    /// How it is turned before it is cut.
    pub turn: Option<Turn>,
    /// Boxes that are cut out of it.
    pub cuts: Vec<Extent>,
}

impl Shape<'_> {
    /// Each of its plates before anything is cut out of it, where it is turned or has an outline.
    pub fn uncut(&self) -> Vec<Option<Block>> {
        let boxed = |x: Extent| self.turn.map(|t| Block::of(&x, t.axis).turned(&t));
        match &self.body {
            Body::Shaped(_, placed) if placed.is_round() => {
                placed.blocks().into_iter().map(Some).collect()
            }
            Body::Prism(p) => vec![Some(self.turned(p.block()))],
            body => body.boxes().into_iter().map(boxed).collect(),
        }
    }

    /// A block as the solid is turned.
    fn turned(&self, block: Block) -> Block {
        match &self.turn {
            Some(turn) => block.turned(turn),
            None => block,
        }
    }

    /// What the cuts leave of a plate, turned.
    pub fn left(&self, plate: Vec<Block>) -> Vec<Block> {
        let cut = |left: Vec<Block>, c: &Extent| left.iter().flat_map(|b| b.minus(c)).collect();
        self.cuts.iter().fold(plate.into_iter().map(|b| self.turned(b)).collect(), cut)
    }

    /// Its plates: the box or prism, or each flange and the web. Each is the blocks that cuts leave
    /// of it.
    pub fn plates(&self) -> Vec<Vec<Block>> {
        let axis = self.turn.map_or(2, |t| t.axis);
        let whole: Vec<Vec<Block>> = match &self.body {
            Body::Shaped(_, placed) if placed.is_round() => {
                placed.blocks().into_iter().map(|b| vec![b]).collect()
            }
            Body::Prism(p) => vec![Block::triangles(p.axis, p.span, &p.outline)],
            body => body.boxes().iter().map(|x| vec![Block::of(x, axis)]).collect(),
        };
        whole.into_iter().map(|plate| self.left(plate)).collect()
    }
}

/// A plate with an outline.
pub(super) struct Outline {
    /// Direction of the thickness, 0 = x.
    pub axis: usize,
    /// The two faces \[mm\].
    pub span: [f64; 2],
    /// Its corners on the next two axes, counter-clockwise when seen from the tip of the axis
    /// \[mm\].
    pub outline: Vec<[f64; 2]>,
}

impl Outline {
    /// The outline as a block, convex or not.
    fn block(&self) -> Block {
        Block { axis: self.axis, span: self.span, polygon: self.outline.clone() }
    }

    /// The box round it.
    pub fn bounds(&self) -> Extent {
        self.block().bounds()
    }
}

/// A length of a section with its member role, a box, or a plate with an outline.
pub(super) enum Body<'a> {
    Profile(&'a str, Placed<'a>),
    Shaped(&'a str, PlacedShape<'a>),
    Cuboid(Extent),
    Prism(Outline),
}

impl Body<'_> {
    /// Its walls that are boxes before any turn: those of a section, or the box. A round section
    /// and an outline have none.
    fn boxes(&self) -> Vec<Extent> {
        match self {
            Body::Profile(_, placed) => placed.blocks().to_vec(),
            Body::Shaped(_, placed) => {
                let walls = placed.walls();
                walls.flanges.into_iter().chain(walls.webs).collect()
            }
            Body::Cuboid(x) => vec![*x],
            Body::Prism(_) => Vec::new(),
        }
    }

    /// A length of a section: its role, the section's name, the axis and the walls; `None` of other
    /// bodies.
    fn section(&self) -> Option<(&str, &str, usize, Walls)> {
        match self {
            Body::Profile(role, p) => {
                let [upper, lower, web] = p.blocks();
                let walls =
                    Walls { flanges: vec![upper, lower], webs: vec![web], ..Walls::default() };
                Some((*role, p.profile.name.as_str(), p.along, walls))
            }
            Body::Shaped(role, p) => Some((*role, p.profile.name.as_str(), p.along, p.walls())),
            Body::Cuboid(_) | Body::Prism(_) => None,
        }
    }
}

impl Context<'_> {
    /// The solids of a part in one turn of its loops.
    pub(super) fn shapes<'s>(
        &'s self,
        entry: &'s PartEntry,
        scope: &Scope,
    ) -> Result<Vec<Shape<'s>>, AssemblyError> {
        let at = entry.name.as_str();
        let mut out = Vec::new();
        for solid in &entry.solids {
            for s in within(at, scope.turns(&solid.each, solid.when.as_ref()))? {
                let body = match (&solid.profile, &solid.cuboid, &solid.prism) {
                    (Some(p), None, None) => {
                        let Some(section) = self.inputs.section(&p.member) else {
                            return entry_fault(at, format!("there is no member `{}`", p.member));
                        };
                        let (along, depth) = (p.along.index(), p.depth.index());
                        if along == depth {
                            return entry_fault(at, "`along` and `depth` are the same axis");
                        }
                        let span = within(at, s.interval(&[p.from.clone(), p.to.clone()]))?;
                        let centre =
                            p.centre.as_ref().map_or(Ok([0.0; 3]), |c| within(at, s.point(c)))?;
                        let mut flip = [false; 3];
                        p.flip.iter().for_each(|k| flip[k.index()] = true);
                        flips(at, section, along, depth, flip)?;
                        match section {
                            Section::I(profile) => {
                                let placed = Placed { profile, along, depth, span, centre };
                                Body::Profile(&p.member, placed)
                            }
                            Section::Shaped(_) if span[1] - span[0] <= 0.0 => {
                                return entry_fault(at, "a profile has no length");
                            }
                            Section::Shaped(_)
                                if section.kind() == SectionKind::Chs && solid.turn.is_some() =>
                            {
                                let problem = "a circular hollow section lies along an axis of \
                                               the joint; it cannot be turned";
                                return entry_fault(at, problem);
                            }
                            Section::Shaped(profile) => {
                                let origin = centre;
                                let placed =
                                    PlacedShape { profile, along, depth, span, origin, flip };
                                Body::Shaped(&p.member, placed)
                            }
                        }
                    }
                    (None, Some(b), None) => Body::Cuboid(block(at, &s, b)?),
                    (None, None, Some(p)) => Body::Prism(outline(at, &s, p)?),
                    _ => {
                        return entry_fault(
                            at,
                            "each solid is a `profile`, a `box` or a `prism`, one of them",
                        );
                    }
                };
                let turn = solid.turn.as_ref().map(|t| turn(at, &s, t)).transpose()?;
                if let (Some(turn), Body::Prism(p)) = (&turn, &body)
                    && turn.axis != p.axis
                {
                    return entry_fault(at, "a prism is turned about its own axis alone");
                }
                let mut cuts = Vec::new();
                for cut in &solid.cut {
                    for s in within(at, s.turns(&cut.each, cut.when.as_ref()))? {
                        cuts.push(block(at, &s, &cut.cuboid)?);
                    }
                }
                out.push(Shape { entry: solid, scope: s, body, turn, cuts });
            }
        }
        Ok(out)
    }

    /// All lengths of profile with a member role, and the parts that they belong to.
    pub(in crate::assembly) fn lengths_of(
        &self,
        role: &str,
    ) -> Result<Vec<(String, Placed<'_>)>, AssemblyError> {
        let mut out = Vec::new();
        for entry in &self.template.parts {
            let at = entry.name.as_str();
            for scope in within(at, self.scope.turns(&entry.each, entry.when.as_ref()))? {
                let part = within(at, scope.text(at))?;
                for shape in self.shapes(entry, &scope)? {
                    if let Body::Profile(member, placed) = shape.body
                        && member == role
                    {
                        out.push((part.clone(), placed));
                    }
                }
            }
        }
        Ok(out)
    }

    /// Members, plates and bolts of the joint. The hand checks know none of them yet.
    pub(in crate::assembly) fn content(&self) -> Result<Content, AssemblyError> {
        let mut out = Content::default();
        for entry in &self.template.parts {
            let at = entry.name.as_str();
            for scope in within(at, self.scope.turns(&entry.each, entry.when.as_ref()))? {
                self.add_part(entry, &scope, &mut out)?;
            }
        }
        let bolts = self.bolts()?;
        out.bolt = self
            .inputs
            .bolt
            .filter(|_| !bolts.is_empty())
            .map(|(size, grade)| (size.clone(), grade.clone()));
        out.fasteners = bolts
            .into_iter()
            .map(|b| Fastener {
                anchor: b.anchor,
                name: b.name,
                axis: b.hole.axis,
                toward: b.hole.toward,
                head: b.hole.base,
                through: b
                    .through
                    .into_iter()
                    .map(|(part, thickness)| Ply { part, thickness })
                    .collect(),
            })
            .collect();
        Ok(out)
    }

    fn add_part(
        &self,
        entry: &PartEntry,
        scope: &Scope,
        out: &mut Content,
    ) -> Result<(), AssemblyError> {
        let at = entry.name.as_str();
        let part = within(at, scope.text(at))?;
        let label = within(at, scope.words(&entry.label))?;
        let thickness = within(at, scope.length(&entry.thickness))?;
        let steel = self.inputs.strength(self.spec, &entry.steel, thickness)?.grade;
        let shapes = self.shapes(entry, scope)?;
        let first = out.members.len();
        let mut boxes = Vec::new();
        for shape in shapes {
            let drawn = match (&shape.turn, &shape.body) {
                (None, Body::Shaped(_, p)) if !p.is_round() => Vec::new(),
                (None, Body::Profile(..) | Body::Cuboid(_)) => Vec::new(),
                // an outline stays one, for drawings
                (_, Body::Prism(_)) if shape.cuts.is_empty() => {
                    shape.uncut().into_iter().flatten().collect()
                }
                _ => shape.plates().into_iter().flatten().collect(),
            };
            let Shape { entry: solid, scope, body, turn, cuts } = shape;
            let text =
                |t: &Option<String>| t.as_ref().map(|t| within(at, scope.words(t))).transpose();
            let own = text(&solid.label)?;
            let no_check = text(&solid.no_check)?.or(text(&entry.no_check)?);
            match &body {
                Body::Profile(..) | Body::Shaped(..) => {
                    let Some((role, profile, along, walls)) = body.section() else { continue };
                    // the cuts of a turned section have other axes: `drawn` shows them
                    let cuts = if turn.is_some() { &[][..] } else { &cuts };
                    let left = |of: Vec<Extent>| of.into_iter().flat_map(|b| without(b, cuts));
                    out.members.push(Length {
                        part: part.clone(),
                        label: own.unwrap_or_else(|| label.clone()),
                        role: role.to_owned(),
                        profile: profile.to_owned(),
                        along,
                        flanges: left(walls.flanges).collect(),
                        web: left(walls.webs).collect(),
                        facets: walls.facets,
                        turn,
                        drawn,
                        known: false,
                        steel: steel.clone(),
                        no_check,
                    });
                }
                Body::Cuboid(extent) => {
                    let left = match turn {
                        Some(_) => vec![*extent],
                        None => without(*extent, &cuts),
                    };
                    let piece = |e| (e, turn, None, drawn.clone(), own.clone(), no_check.clone());
                    boxes.extend(left.into_iter().map(piece));
                }
                Body::Prism(p) => {
                    let outline = Some((p.axis, p.outline.clone()));
                    boxes.push((p.bounds(), turn, outline, drawn, own, no_check));
                }
            }
        }
        let (webs, alone) = (&out.members[first..], out.members.len() == first);
        for (extent, turn, outline, drawn, own, no_check) in boxes {
            let cut_by = |pieces: Vec<Extent>, block: &Extent| {
                pieces.into_iter().flat_map(|p| cut(p, block)).collect()
            };
            // a web cuts what is turned with it
            let with = webs.iter().filter(|m| outline.is_none() && m.turn == turn);
            let extents = with.flat_map(Length::blocks).fold(vec![extent], cut_by);
            let words = match alone {
                true => label.clone(),
                false => say!("plate of the {}", &label),
            };
            let label = own.unwrap_or(words);
            out.pieces.extend(extents.into_iter().map(|extent| Piece {
                part: part.clone(),
                label: label.clone(),
                kind: PieceKind::Other,
                extent,
                turn,
                outline: outline.clone(),
                drawn: drawn.clone(),
                upright: None,
                steel: steel.clone(),
                no_check: no_check.clone(),
            }));
        }
        Ok(())
    }
}

/// Refuses `flip` where it says nothing: along the member, of sections that are symmetrical.
fn flips(
    at: &str,
    section: Section<'_>,
    along: usize,
    depth: usize,
    flip: [bool; 3],
) -> Result<(), AssemblyError> {
    let width = 3 - along - depth;
    let takes = match section.kind() {
        SectionKind::Angle => &[depth, width][..],
        SectionKind::Channel => &[width],
        SectionKind::I | SectionKind::Rhs | SectionKind::Chs => &[],
    };
    match (0..3).find(|k| flip[*k] && !takes.contains(k)) {
        Some(k) => {
            let axis = ["x", "y", "z"][k];
            let kind = section.kind().words();
            entry_fault(at, format!("`flip` along {axis} leaves {kind} as it is: leave it out"))
        }
        None => Ok(()),
    }
}

/// The plate of an entry with an outline.
fn outline(at: &str, s: &Scope, p: &PrismEntry) -> Result<Outline, AssemblyError> {
    let axis = p.axis.index();
    let span = within(at, s.interval(&[p.from.clone(), p.to.clone()]))?;
    if span[1] - span[0] <= 0.0 {
        return entry_fault(at, "a prism has no thickness");
    }
    let mut outline = Vec::with_capacity(p.outline.len());
    for [a, b] in &p.outline {
        let corner = [within(at, s.length(a))?, within(at, s.length(b))?];
        // the axes after y are z and x
        outline.push(if axis == 1 { [corner[1], corner[0]] } else { corner });
    }
    let n = outline.len();
    let short = |i: usize| {
        let (a, b) = (outline[i], outline[(i + 1) % n]);
        (b[0] - a[0]).hypot(b[1] - a[1]) < SAME_PLACE
    };
    if n < 3 || (0..n).any(short) {
        return entry_fault(at, "an outline has three corners or more, no two at one place");
    }
    if crosses_itself(&outline) {
        return entry_fault(at, "the edges of an outline cross or touch each other");
    }
    if twice_area(&outline) < 0.0 {
        outline.reverse();
    }
    Ok(Outline { axis, span, outline })
}

/// The turn of an entry.
fn turn(at: &str, s: &Scope, t: &TurnEntry) -> Result<Turn, AssemblyError> {
    let angle = within(at, s.angle(&t.by))?;
    let point = t.at.as_ref().map_or(Ok([0.0; 3]), |p| within(at, s.point(p)))?;
    Ok(Turn { axis: t.about.index(), angle, at: point })
}
