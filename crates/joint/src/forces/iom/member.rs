//! Members of a model: their elements, lengths and sections.

use super::axes::Axes;
use super::parts::Parts;
use crate::forces::frame_model::{FrameMember, FrameModel};
use bracket_base::diag::Diagnostic;
use bracket_base::math::vec3::{V3, norm, sub};
use bracket_base::xml::Element;
use std::collections::BTreeMap;

/// The members of a model.
pub struct Members<'a> {
    /// The members by number.
    by_id: BTreeMap<&'a str, Member<'a>>,
    /// Number of the member and place in it of each element.
    of_element: BTreeMap<&'a str, (&'a str, usize)>,
}

/// A member.
#[derive(Clone, Debug)]
pub struct Member<'a> {
    /// Its name in the table of forces.
    pub name: &'a str,
    /// Names under which its elements are in the table of forces, `C/E1`; none if it has only one,
    /// which is the member.
    pub elements: Vec<String>,
    /// True if another member has the same name.
    shared: bool,
    part: Element<'a>,
}

/// A piece of a member from node to node.
pub struct Piece<'a> {
    element: Element<'a>,
    line: Element<'a>,
    ends: [V3; 2],
    /// Its length \[m\].
    pub length: f64,
}

impl<'a> Members<'a> {
    /// The members of a model.
    pub fn of(parts: &Parts<'a>) -> Self {
        let (mut by_id, mut of_element) = (BTreeMap::new(), BTreeMap::new());
        let mut count: BTreeMap<&str, usize> = BTreeMap::new();
        for (_, part) in parts.all("Member1D") {
            *count.entry(parts.name(part)).or_default() += 1;
        }
        for (id, part) in parts.all("Member1D") {
            let name = parts.name(part);
            let ids: Vec<&str> = elements(part).filter_map(|e| e.text_of("Id")).collect();
            let element = |id: &&str| {
                let of = parts.get("Element1D", id).map_or(*id, |e| parts.name(e));
                format!("{name}/{of}")
            };
            let alone = ids.len() < 2;
            let names = if alone { Vec::new() } else { ids.iter().map(element).collect() };
            of_element.extend(ids.into_iter().enumerate().map(|(i, e)| (e, (id, i))));
            let shared = count.get(name).is_some_and(|n| *n > 1);
            by_id.insert(id, Member { name, elements: names, shared, part });
        }
        Self { by_id, of_element }
    }

    /// A member by its number.
    pub fn get(&self, id: &str) -> Option<&Member<'a>> {
        self.by_id.get(id)
    }

    /// The member that has this element, and which of its elements it is.
    pub fn of_element(&self, id: &str) -> Option<(&Member<'a>, usize)> {
        let (member, i) = self.of_element.get(id)?;
        Some((self.by_id.get(member)?, *i))
    }

    /// Profiles and steels of the members. Those whose parts are missing are left out.
    pub fn model(&self, parts: &Parts<'a>) -> FrameModel {
        let mut out = Vec::new();
        for member in self.by_id.values() {
            let Ok(section) = member.section(parts) else { continue };
            let steel = section.child("Material");
            let steel = steel.filter(|m| m.text_of("TypeName") == Some("MatSteel"));
            let steel = steel.and_then(|m| parts.get("MatSteel", m.text_of("Id")?));
            let of_member = FrameMember {
                place: member.part.place(parts.file),
                section: parts.name(section).to_owned(),
                profile: profile(section).unwrap_or_default().to_owned(),
                steel: steel.map_or("", |s| parts.name(s)).to_owned(),
                turned: false,
            };
            let names = member.elements.iter().map(String::as_str).chain([member.name]);
            out.extend(names.map(|name| (name.to_owned(), of_member.clone())));
        }
        out.into_iter().collect()
    }
}

/// The references to the elements of a member.
fn elements(member: Element<'_>) -> impl Iterator<Item = Element<'_>> {
    member.child("Elements1D").into_iter().flat_map(Element::all)
}

/// The name of the rolled profile of a section.
fn profile(section: Element<'_>) -> Option<&str> {
    let mut parameters = section.child("Parameters")?.all();
    parameters.find(|p| p.text_of("Name") == Some("UniqueName"))?.text_of("Value")
}

impl<'a> Member<'a> {
    /// Its pieces from node to node.
    pub fn pieces(&self, parts: &Parts<'a>) -> Result<Vec<Piece<'a>>, Box<Diagnostic>> {
        let mut out: Vec<Piece<'a>> = Vec::new();
        for at in elements(self.part) {
            let element = parts.referred(at, "Element1D")?;
            let segment = element.child("Segment").unwrap_or(element);
            let line = parts.referred(segment, "LineSegment3D")?;
            let end = |name: &str| {
                let at = line.child(name).unwrap_or(line);
                parts.vector(parts.referred(at, "Point3D")?)
            };
            let ends = [end("StartPoint")?, end("EndPoint")?];
            let length = norm(sub(ends[1], ends[0]));
            if length <= 0.0 {
                let message = format!("`{}` has an element without length", self.name);
                return Err(parts.fault(line, message, "give start and end different points"));
            }
            out.push(Piece { element, line, ends, length });
        }
        if out.is_empty() {
            let message = format!("the member `{}` has no elements", self.name);
            return Err(parts.fault(self.part, message, "export the whole model"));
        }
        Ok(out)
    }

    /// Its section: its own, or in older files that of its first element.
    fn section(&self, parts: &Parts<'a>) -> Result<Element<'a>, Box<Diagnostic>> {
        let own = self.part.child("CrossSection");
        let first = || {
            let element = parts.get("Element1D", elements(self.part).next()?.text_of("Id")?)?;
            element.child("CrossSectionBegin")
        };
        match own.or_else(first) {
            Some(at) => parts.referred(at, "CrossSection"),
            None => {
                let message = format!("the member `{}` has no section", self.name);
                Err(parts.fault(self.part, message, "export the whole model"))
            }
        }
    }

    /// Refuses results in axes that are not those of Bracket, and a name of several members; `at`:
    /// the results.
    pub fn check(
        &self,
        parts: &'a Parts<'a>,
        pieces: &[Piece<'a>],
        (system, at): (&str, Element<'a>),
    ) -> Result<(), Box<Diagnostic>> {
        if self.shared {
            let message = format!("several members of the model are called `{}`", self.name);
            let help = "give every member a name of its own, and export again";
            return Err(parts.fault(self.part, message, help));
        }
        let section = self.section(parts)?;
        for Piece { element, line, ends, .. } in pieces {
            let (element, line, ends) = (*element, *line, *ends);
            let name = self.name;
            Axes { parts, name, element, section, line, ends }.check(system, at)?;
        }
        Ok(())
    }
}
