//! Load cases and combinations to which results belong.

use super::parts::Parts;
use bracket_base::diag::Diagnostic;
use bracket_base::xml::Element;

/// Kinds of combinations whose results act together. The others are extremes of several.
const CONCURRENT: [&str; 2] = ["Linear", "NonLinear"];

/// The load cases and combinations of a model.
pub struct Loadings<'a> {
    /// The model.
    pub parts: &'a Parts<'a>,
}

/// A load case or a combination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loading<'a> {
    /// Its name.
    pub name: &'a str,
    /// True if the model says that it is of the serviceability limit state.
    pub serviceability: bool,
}

impl<'a> Loadings<'a> {
    /// The loading of a result (`LoadingType`, `Id`).
    pub fn of(&self, at: Element<'a>) -> Result<Loading<'a>, Box<Diagnostic>> {
        let parts = self.parts;
        let id = parts.text(at, "Id")?;
        let envelope = |what: String| {
            let message = format!(
                "{what} is an envelope: its actions are extremes of several load cases and do not \
                 act together"
            );
            let help = "export the results of the single load cases and linear combinations";
            parts.fault(at, message, help)
        };
        let list = match at.text_of("LoadingType").unwrap_or("LoadCase") {
            "LoadCase" => "LoadCase",
            "Combination" => "CombiInput",
            "ResultClass" => return Err(envelope(format!("the result class {id}"))),
            other => {
                let message = format!("`{other}` is no type of a loading");
                return Err(parts.fault(at, message, "it is `LoadCase` or `Combination`"));
            }
        };
        let Some(part) = parts.get(list, id) else {
            let message = format!("the model has no `{list}` with the Id {id}");
            let help = "export model and results of the same project together";
            return Err(parts.fault(at, message, help));
        };
        let name = parts.name(part);
        let kind = part.text_of("TypeCalculationCombi").unwrap_or(CONCURRENT[0]);
        if !CONCURRENT.contains(&kind) {
            return Err(envelope(format!("the combination `{name}` (`{kind}`)")));
        }
        if list == "LoadCase" {
            let items = at.child("Items").into_iter().flat_map(Element::all);
            for item in items.filter(|i| i.text_of("Coefficient").is_some()) {
                let factor = parts.number(item, "Coefficient")?;
                if factor != 1.0 {
                    let message =
                        format!("the result of load case `{name}` has the factor {factor}");
                    let help = "export load cases without factors, or combinations: nothing says \
                                whether the forces contain this factor";
                    return Err(parts.fault(item, message, help));
                }
            }
        }
        let serviceability = part.text_of("TypeCombiEC").is_some_and(|t| t.starts_with("SLS"));
        Ok(Loading { name, serviceability })
    }
}
