//! The solids of a member or plate as the template gives them: lengths of profiles and boxes.

use super::context::Context;
use crate::assembly::content::{Content, Extent, Fastener, Length, Piece, PieceKind, Ply, cut};
use crate::assembly::error::AssemblyError;
use crate::assembly::evaluate::{entry_fault, within};
use crate::assembly::part::{Placed, without};
use crate::assembly::scope::Scope;
use crate::assembly::template::{BoxEntry, PartEntry, SolidEntry};
use bracket_base::say;

/// A solid in one turn of its loops.
pub(super) struct Shape<'a> {
    pub entry: &'a SolidEntry,
    pub scope: Scope,
    pub body: Body<'a>,
    /// Boxes that are cut out of it.
    pub cuts: Vec<Extent>,
}

impl Shape<'_> {
    /// Its plates: the box, or each flange and the web. Each is the boxes that cuts leave of it.
    pub fn plates(&self) -> Vec<Vec<Extent>> {
        let whole = match &self.body {
            Body::Profile(_, placed) => placed.blocks().to_vec(),
            Body::Cuboid(x) => vec![*x],
        };
        whole.into_iter().map(|x| without(x, &self.cuts)).collect()
    }
}

/// The flanges and the web of a profile without what is cut out.
fn flanges_and_web(placed: &Placed<'_>, cuts: &[Extent]) -> [Vec<Extent>; 2] {
    let [upper, lower, web] = placed.blocks();
    [&[upper, lower][..], &[web]].map(|of| of.iter().flat_map(|b| without(*b, cuts)).collect())
}

/// A length of a profile with its member role, or a box.
pub(super) enum Body<'a> {
    Profile(&'a str, Placed<'a>),
    Cuboid(Extent),
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
                let body = match (&solid.profile, &solid.cuboid) {
                    (Some(p), None) => {
                        let Some(profile) = self.inputs.profile(&p.member) else {
                            return entry_fault(at, format!("there is no member `{}`", p.member));
                        };
                        let (along, depth) = (p.along.index(), p.depth.index());
                        if along == depth {
                            return entry_fault(at, "`along` and `depth` are the same axis");
                        }
                        let span = within(at, s.interval(&[p.from.clone(), p.to.clone()]))?;
                        let centre =
                            p.centre.as_ref().map_or(Ok([0.0; 3]), |c| within(at, s.point(c)))?;
                        Body::Profile(&p.member, Placed { profile, along, depth, span, centre })
                    }
                    (None, Some(b)) => Body::Cuboid(cuboid(at, &s, b)?),
                    _ => {
                        return entry_fault(
                            at,
                            "each solid is a `profile` or a `box`, one of them",
                        );
                    }
                };
                let mut cuts = Vec::new();
                for cut in &solid.cut {
                    for s in within(at, s.turns(&cut.each, cut.when.as_ref()))? {
                        cuts.push(cuboid(at, &s, &cut.cuboid)?);
                    }
                }
                out.push(Shape { entry: solid, scope: s, body, cuts });
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
        for Shape { entry: solid, scope, body, cuts } in shapes {
            let text =
                |t: &Option<String>| t.as_ref().map(|t| within(at, scope.words(t))).transpose();
            let own = text(&solid.label)?;
            let no_check = text(&solid.no_check)?.or(text(&entry.no_check)?);
            match body {
                Body::Profile(role, placed) => {
                    let [flanges, web] = flanges_and_web(&placed, &cuts);
                    out.members.push(Length {
                        part: part.clone(),
                        label: own.unwrap_or_else(|| label.clone()),
                        role: role.to_owned(),
                        profile: placed.profile.name.clone(),
                        along: placed.along,
                        flanges,
                        web,
                        known: false,
                        steel: steel.clone(),
                        no_check,
                    });
                }
                Body::Cuboid(extent) => {
                    let left = without(extent, &cuts);
                    boxes.extend(left.into_iter().map(|e| (e, own.clone(), no_check.clone())));
                }
            }
        }
        let (webs, alone) = (&out.members[first..], out.members.len() == first);
        for (extent, own, no_check) in boxes {
            let cut_by = |pieces: Vec<Extent>, block: &Extent| {
                pieces.into_iter().flat_map(|p| cut(p, block)).collect()
            };
            let extents = webs.iter().flat_map(Length::blocks).fold(vec![extent], cut_by);
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
                upright: None,
                steel: steel.clone(),
                no_check: no_check.clone(),
            }));
        }
        Ok(())
    }
}

/// The extent of a box.
fn cuboid(at: &str, s: &Scope, b: &BoxEntry) -> Result<Extent, AssemblyError> {
    let x = [
        within(at, s.interval(&b.x))?,
        within(at, s.interval(&b.y))?,
        within(at, s.interval(&b.z))?,
    ];
    match (0..3).find(|&k| x[k][1] - x[k][0] <= 0.0) {
        Some(k) => entry_fault(at, format!("a box has no extent along {}", ["x", "y", "z"][k])),
        None => Ok(x),
    }
}
