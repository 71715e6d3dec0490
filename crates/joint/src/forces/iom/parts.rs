//! The parts of a model by their numbers, and what their elements hold.

use bracket_base::diag::Diagnostic;
use bracket_base::xml::Element;
use std::collections::BTreeMap;
use std::path::Path;

/// The lists that are read.
const LISTS: [&str; 8] = [
    "Point3D",
    "LineSegment3D",
    "Element1D",
    "Member1D",
    "CrossSection",
    "MatSteel",
    "LoadCase",
    "CombiInput",
];

/// The parts of a model.
pub struct Parts<'a> {
    /// The file, for messages.
    pub file: &'a Path,
    lists: BTreeMap<&'static str, BTreeMap<&'a str, Element<'a>>>,
}

impl<'a> Parts<'a> {
    /// Finds the parts; refuses two with the same number.
    pub fn of(model: Element<'a>, file: &'a Path) -> Result<Self, Box<Diagnostic>> {
        let mut out = Self { file, lists: BTreeMap::new() };
        for list in LISTS {
            let mut parts = BTreeMap::new();
            for part in model.child(list).into_iter().flat_map(Element::all) {
                let id = out.text(part, "Id")?;
                if parts.insert(id, part).is_some() {
                    let message = format!("the model has two `{list}` with the Id {id}");
                    let help = "export the model again: references would lead to either of them";
                    return Err(out.fault(part, message, help));
                }
            }
            out.lists.insert(list, parts);
        }
        Ok(out)
    }

    /// The parts of a list.
    pub fn all(&self, list: &str) -> impl Iterator<Item = (&'a str, Element<'a>)> {
        self.lists.get(list).into_iter().flatten().map(|(id, part)| (*id, *part))
    }

    /// A part by its number.
    pub fn get(&self, list: &str, id: &str) -> Option<Element<'a>> {
        self.lists.get(list)?.get(id).copied()
    }

    /// The part that a reference (`TypeName`, `Id`) names, which must be in this list.
    pub fn referred(&self, at: Element<'a>, list: &str) -> Result<Element<'a>, Box<Diagnostic>> {
        let id = self.text(at, "Id")?;
        let told = at.text_of("TypeName").unwrap_or(list);
        self.get(list, id).filter(|_| told == list).ok_or_else(|| {
            let message = match told == list {
                true => format!("the model has no `{list}` with the Id {id}"),
                false => format!("a `{told}` stands where only a `{list}` is read"),
            };
            self.fault(at, message, "export the whole model; members are straight lines")
        })
    }

    /// A fault at an element.
    pub fn fault(&self, at: Element<'_>, message: String, help: &str) -> Box<Diagnostic> {
        let d = Diagnostic::input("loads/iom", message).help(help);
        Diagnostic { place: at.place(self.file), ..d }.into()
    }

    /// The text of a child, which must be there.
    pub fn text(&self, at: Element<'a>, name: &str) -> Result<&'a str, Box<Diagnostic>> {
        at.text_of(name).ok_or_else(|| {
            let message = format!("`{}` has no `{name}`", at.name());
            self.fault(at, message, "export the file again: it may have been cut or edited")
        })
    }

    /// The number in a child, which must be there.
    pub fn number(&self, at: Element<'a>, name: &str) -> Result<f64, Box<Diagnostic>> {
        let text = self.text(at, name)?;
        text.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| {
            let message = format!("`{name}` of `{}` is `{text}`, which is no number", at.name());
            let help = "numbers of XML have a decimal point and no unit: export the file again";
            self.fault(at.child(name).unwrap_or(at), message, help)
        })
    }

    /// The same; zero if the child is not there.
    pub fn number_or_zero(&self, at: Element<'a>, name: &str) -> Result<f64, Box<Diagnostic>> {
        at.text_of(name).map_or(Ok(0.0), |_| self.number(at, name))
    }

    /// The three numbers of a point or vector.
    pub fn vector(&self, at: Element<'a>) -> Result<[f64; 3], Box<Diagnostic>> {
        Ok([self.number(at, "X")?, self.number(at, "Y")?, self.number(at, "Z")?])
    }

    /// The name of a part; its number if it has none.
    pub fn name(&self, part: Element<'a>) -> &'a str {
        part.text_of("Name").or(part.text_of("Id")).unwrap_or_default()
    }
}
