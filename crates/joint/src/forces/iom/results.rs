//! Results on members as rows of a table of forces.

use super::loadings::Loadings;
use super::member::{Member, Members, Piece};
use super::parts::Parts;
use crate::forces::force_row::{ForceRow, Forces};
use crate::forces::program::Quantity;
use bracket_base::diag::Diagnostic;
use bracket_base::xml::Element;
use std::collections::BTreeMap;

/// The forces of a section, with the sign that makes them Bracket's at the start of a member and
/// the factor to N and N mm. Source: IOM coordinate systems, conversion to load effects.
const ACTIONS: [(&str, f64); 6] =
    [("N", 1.0), ("Qy", -1.0), ("Qz", -1.0), ("Mx", 1e3), ("My", -1e3), ("Mz", 1e3)];

/// Distance from a node, as a part of the length of the member, at which a section is the one
/// beside the node: programs write 1e-6.
const BESIDE: f64 = 1e-5;

/// The same of a section that is at the node.
const AT: f64 = 1e-9;

/// Reads the results of all members.
pub fn read<'a>(
    results: Element<'a>,
    parts: &'a Parts<'a>,
    members: &Members<'a>,
    loadings: &Loadings<'a>,
) -> Result<Forces, Box<Diagnostic>> {
    let mut out = Forces { given: [true; 6], ..Forces::default() };
    // two lists of the same name, one in the other
    let lists = results.children("ResultOnMembers").flat_map(|l| l.children("ResultOnMembers"));
    let all = lists.filter_map(|l| l.child("Members")).flat_map(|m| m.children("ResultOnMember"));
    let mut cases = BTreeMap::new();
    for result in all {
        if result.text_of("ResultType").is_some_and(|t| t != "InternalForces") {
            continue;
        }
        let (member, of_piece) = member(result, parts, members)?;
        let sections = sections(result, parts, loadings, &mut cases)?;
        match rows((member, of_piece), &sections, result, parts) {
            Ok(rows) => out.rows.extend(rows),
            Err(why) => {
                for name in member.elements.iter().map(String::as_str).chain([member.name]) {
                    out.refused.entry(name.to_owned()).or_insert_with(|| (*why).clone());
                }
            }
        }
    }
    let refused = &out.refused;
    out.rows.retain(|r| r.text(Quantity::Member).is_none_or(|m| !refused.contains_key(m)));
    if out.rows.is_empty() && out.refused.is_empty() {
        let message = "the container has no internal forces of members".into();
        let help = "calculate the model, and export it with its results";
        return Err(parts.fault(results, message, help));
    }
    Ok(out)
}

/// The member of a result, and which of its elements where it is a result of one.
fn member<'m, 'a>(
    result: Element<'a>,
    parts: &Parts<'a>,
    members: &'m Members<'a>,
) -> Result<(&'m Member<'a>, Option<usize>), Box<Diagnostic>> {
    let Some(at) = result.child("Member") else {
        let message = "the result names no `Member`".into();
        return Err(parts.fault(result, message, "export the file again"));
    };
    let id = parts.text(at, "Id")?;
    let kind = at.text_of("MemberType").unwrap_or("Member1D");
    let found = match kind {
        "Member1D" => members.get(id).map(|m| (m, None)),
        "Element1D" => members.of_element(id).map(|(m, i)| (m, Some(i))),
        _ => None,
    };
    found.ok_or_else(|| {
        let message =
            format!("the result belongs to the {kind} {id}, which the model does not have");
        parts.fault(at, message, "export model and results of the same project together")
    })
}

/// The forces of a section in one load case.
struct Section<'a> {
    at: Element<'a>,
    /// Its position, and whether that is a part of the length.
    position: (f64, bool),
    case: &'a str,
    serviceability: bool,
    actions: [f64; 6],
}

/// The sections of a result. `cases`: where each name of a load case came from.
fn sections<'a>(
    result: Element<'a>,
    parts: &Parts<'a>,
    loadings: &Loadings<'a>,
    cases: &mut BTreeMap<&'a str, (Option<&'a str>, Option<&'a str>)>,
) -> Result<Vec<Section<'a>>, Box<Diagnostic>> {
    let mut out = Vec::new();
    let of_kind = |e: &Element<'_>, kind: &str| e.kind().is_none_or(|k| k.ends_with(kind));
    let all = |e: Element<'a>| e.child("Results").into_iter().flat_map(Element::all);
    for section in all(result).filter(|e| of_kind(e, "ResultOnSection")) {
        let relative = match section.text_of("AbsoluteRelative").unwrap_or("Absolute") {
            "Absolute" => false,
            "Relative" => true,
            other => {
                let message = format!("`AbsoluteRelative` is `{other}`");
                return Err(parts.fault(section, message, "it is `Absolute` or `Relative`"));
            }
        };
        let position = (parts.number(section, "Position")?, relative);
        for forces in all(section).filter(|e| of_kind(e, "ResultOfInternalForces")) {
            let Some(of) = forces.child("Loading") else {
                let message = "the forces name no `Loading`".into();
                return Err(parts.fault(forces, message, "export the file again"));
            };
            let loading = loadings.of(of)?;
            let source = (of.text_of("LoadingType"), of.text_of("Id"));
            if *cases.entry(loading.name).or_insert(source) != source {
                let message = format!("two loadings are called `{}`", loading.name);
                let help = "give every load case and combination a name of its own";
                return Err(parts.fault(of, message, help));
            }
            let mut actions = [0.0; 6];
            for (action, (name, factor)) in actions.iter_mut().zip(ACTIONS) {
                *action = factor * parts.number(forces, name)?;
            }
            let (case, serviceability) = (loading.name, loading.serviceability);
            out.push(Section { at: forces, position, case, serviceability, actions });
        }
    }
    Ok(out)
}

/// The rows of a result: of the member, and of each of its elements if it has several.
fn rows<'a>(
    (member, of_piece): (&Member<'a>, Option<usize>),
    sections: &[Section<'a>],
    result: Element<'a>,
    parts: &'a Parts<'a>,
) -> Result<Vec<ForceRow>, Box<Diagnostic>> {
    let pieces = member.pieces(parts)?;
    let system = result.text_of("LocalSystemType").unwrap_or("Principle");
    member.check(parts, &pieces, (system, result))?;
    let nodes = nodes(&pieces);
    let whole = nodes[pieces.len()];
    // where the positions begin and end
    let [from, to] = of_piece.map_or([0.0, whole], |i| [nodes[i], nodes[i + 1]]);
    let mut out = Vec::new();
    for section in sections {
        let (position, relative) = section.position;
        let s = from + if relative { position * (to - from) } else { position };
        if s < from - BESIDE * whole || s > to + BESIDE * whole {
            let unit = if relative { "of its length" } else { "m" };
            let length = to - from;
            let message = format!(
                "a section of `{}` is at {position} {unit}, and it is {length} m long",
                member.name
            );
            return Err(parts.fault(section.at, message, "export model and results together"));
        }
        let row = |name: &str, station: f64, length: f64| row(section, name, station, length);
        let near = |node: f64| (s - node).abs() <= BESIDE * whole;
        let ends = [0.0, whole].into_iter().find(|node| near(*node));
        out.push(row(member.name, ends.unwrap_or(s), whole));
        for (i, name) in member.elements.iter().enumerate() {
            let [a, b] = [nodes[i], nodes[i + 1]];
            // the value at an inner node itself is of neither side, unless the element says it
            let after = i == 0 || s > a + AT * whole;
            let before = i + 1 == pieces.len() || s < b - AT * whole;
            let own = of_piece.map_or(after && before, |p| p == i);
            if own {
                let station = match () {
                    () if near(a) => 0.0,
                    () if near(b) => b - a,
                    () => s - a,
                };
                out.push(row(name, station, b - a));
            }
        }
    }
    Ok(out)
}

/// Distances of the nodes of a member from its start \[m\].
fn nodes(pieces: &[Piece<'_>]) -> Vec<f64> {
    let mut out = vec![0.0];
    for piece in pieces {
        out.push(out[out.len() - 1] + piece.length);
    }
    out
}

fn row(section: &Section<'_>, name: &str, station: f64, length: f64) -> ForceRow {
    let mut texts: BTreeMap<Quantity, String> = [
        (Quantity::Case, section.case.to_owned()),
        (Quantity::Member, name.to_owned()),
        (Quantity::Station, station.to_string()),
    ]
    .into();
    if section.serviceability {
        texts.insert(Quantity::State, "SLS".into());
    }
    let (line, actions) = (section.at.line(), section.actions);
    ForceRow { line, texts, station: Some(station), length: Some(length), actions }
}
