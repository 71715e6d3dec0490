//! Makes load cases of the table that a spec names.

use super::connection::ConnectionSpec;
use super::load_table::{LoadTable, Station};
use super::loads::{Action, ActionPoint, LimitState, LoadSpec};
use crate::forces::{Asked, ForceRow, ForceTable, ForceTables, Program, Quantity, Source, names};
use bracket_base::diag::{Diagnostic, Diagnostics, Place, did_you_mean};
use bracket_base::yaml::Parsed;
use std::collections::BTreeMap;
use std::path::Path;

/// Relative difference of two stations that are one.
const SAME: f64 = 1e-6;

/// Reads the table of a spec, if it names one, and adds its rows to the loads. Paths start from
/// `base`; `stored`: a file that [`written`] made of the table, to be read in its place. False if
/// the spec names no table.
pub fn expand(
    spec: &mut Parsed<ConnectionSpec>,
    base: &Path,
    stored: Option<&Path>,
) -> Result<bool, Diagnostics> {
    let Some(mut table) = spec.value.loads.take_table() else { return Ok(false) };
    let mut file = base.join(&table.table);
    if let Some(stored) = stored {
        (table, file) = (LoadTable::default(), stored.to_path_buf());
    }
    let mut tables = ForceTables::default();
    let loads = listed(&mut tables, &table, &file, |path| spec.index.place(path))?;
    for (line, load) in loads {
        spec.index.add(format!("loads[{}]", spec.value.loads.len()), &file, line);
        spec.value.loads.push(load);
    }
    Ok(true)
}

/// Load cases as a table with Bracket's own headers, from which they are read to the last bit.
pub fn written(loads: &[LoadSpec]) -> String {
    let mut out = csv::Writer::from_writer(Vec::new());
    let given: Vec<Action> =
        Action::ALL.into_iter().filter(|a| loads.iter().any(|l| l.value(*a).is_some())).collect();
    let unit = |a: &Action| if a.direction().1 { "N mm" } else { "N" };
    let headers = given.iter().map(|a| format!("{} [{}]", a.word(), unit(a)));
    let words = ["case", "state", "end", "at"].map(str::to_owned);
    // a writer to memory cannot fail
    let _ = out.write_record(words.into_iter().chain(headers));
    for load in loads {
        let words = [
            load.name.clone(),
            load.state.word().into(),
            load.end.clone().unwrap_or_default(),
            load.at.map_or_else(String::new, |p| p.word().into()),
        ];
        let numbers = given.iter().map(|a| load.value(*a).unwrap_or(0.0).to_string());
        let _ = out.write_record(words.into_iter().chain(numbers));
    }
    out.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// The load cases of a table with their lines; `tables` keeps what is read, `place`: the place of a
/// key of the spec.
pub fn listed(
    tables: &mut ForceTables,
    table: &LoadTable,
    file: &Path,
    place: impl Fn(&str) -> Place,
) -> Result<Vec<(usize, LoadSpec)>, Diagnostics> {
    cases(tables, table, file).map_err(|faults| {
        faults.map(|mut d| {
            // a fault of a row is in the table, one of a key in the spec
            if d.place.file.is_none() && d.place.line.is_some() {
                d.place.file = Some(file.to_path_buf());
            }
            if d.place.file.is_none() {
                d.place = place(d.place.path.as_deref().unwrap_or("loads"));
                d.message = format!("{} (`{}`)", d.message, file.display());
            }
            d
        })
    })
}

fn cases(
    tables: &mut ForceTables,
    table: &LoadTable,
    file: &Path,
) -> Result<Vec<(usize, LoadSpec)>, Diagnostics> {
    let sheet = table.sheet.as_deref();
    let LoadTable { mapping: program, columns, asked, .. } = table;
    let source = Source { file, sheet, program: *program, columns, asked: *asked };
    let forces = tables.of(&source)?;
    if table.mapping.is_some() && table.flip.is_none() && !table.at_an_end() {
        let message = "the table does not say at which end of the member the joint is";
        let help = "write `station: start` or `station: end`; or `flip: false` where the member \
                    starts at the joint and `flip: true` where it ends there";
        return Err(of_key("flip", message.into(), help));
    }
    if let Some(why) = forces.refusal(table.member.as_deref()) {
        return Err(why.clone().into());
    }
    check_states(forces, table)?;
    let rows = of_member(forces.around(table.member.as_deref()), table)?;
    let rows = of_cases(rows, table)?;
    let rows = at_station(rows, table)?;
    let mut loads: Vec<(usize, LoadSpec)> = Vec::new();
    for row in rows {
        let load = load(row, table, forces.given).map_err(|(key, message, help)| {
            let mut d = Diagnostic::input("loads/table", message).help(help);
            d.place = Place {
                file: Some(file.into()),
                line: Some(row.line),
                column: None,
                path: Some(key.into()),
            };
            Diagnostics::from(d)
        })?;
        let same = |(_, l): &&(usize, LoadSpec)| l.name == load.name && l.end == load.end;
        match loads.iter().find(same) {
            Some((_, l)) if *l == load => {}
            Some((line, _)) => {
                let message = format!(
                    "load case `{}` stands in the lines {line} and {} with different actions",
                    load.name, row.line
                );
                let help = "one row is a load case of a joint: choose the rows of one section with \
                            `member`, `station` or `node`";
                let mut d = Diagnostic::input("loads/table", message).help(help);
                d.place.file = Some(file.into());
                d.place.line = Some(row.line);
                return Err(d.into());
            }
            None => loads.push((row.line, load)),
        }
    }
    Ok(loads)
}

/// The fault of a key of `loads`.
fn of_key(key: &str, message: String, help: impl Into<String>) -> Diagnostics {
    Diagnostic::input("loads/table", message).path(format!("loads.{key}")).help(help).into()
}

/// The rows of the member and node that are asked for.
fn of_member<'a>(
    mut kept: Vec<&'a ForceRow>,
    table: &LoadTable,
) -> Result<Vec<&'a ForceRow>, Diagnostics> {
    let asked =
        [("member", Quantity::Member, &table.member), ("node", Quantity::Node, &table.node)];
    for (key, quantity, wanted) in asked {
        let told = || names(kept.iter().copied(), quantity);
        match wanted {
            Some(wanted) => {
                let without = kept.iter().find(|r| r.text(quantity).is_none());
                if let (Some(row), true) =
                    (without, kept.iter().any(|r| r.text(quantity).is_some()))
                {
                    return Err(of_row(row, format!("the row has no {key}"), "fill the cell"));
                }
                let is = |r: &&&ForceRow| r.text(quantity).is_some_and(|t| t == wanted.trim());
                let of: Vec<&ForceRow> = kept.iter().filter(is).copied().collect();
                if of.is_empty() {
                    let texts = kept.iter().filter_map(|r| r.text(quantity));
                    let near = did_you_mean(wanted, texts);
                    let message = format!("the table has no {key} `{wanted}`{near}");
                    return Err(of_key(key, message, format!("it has {}", told())));
                }
                kept = of;
            }
            None if quantity == Quantity::Member => {
                let first = kept.first().and_then(|r| r.text(quantity));
                let one_end = table.end.is_some() || table.mapping.is_some();
                if one_end && kept.iter().any(|r| r.text(quantity) != first) {
                    let message = "the table has rows of several members".to_string();
                    let help = format!("name one with `loads: {{member: …}}`: {}", told());
                    return Err(of_key("table", message, help));
                }
            }
            None => {}
        }
    }
    Ok(kept)
}

/// The rows of the cases that are asked for.
fn of_cases<'a>(
    rows: Vec<&'a ForceRow>,
    table: &LoadTable,
) -> Result<Vec<&'a ForceRow>, Diagnostics> {
    if let Some(row) = rows.iter().find(|r| r.text(Quantity::Case).is_none()) {
        let help = match table.asked {
            Asked::Spec => "give every row a name, or name the column with `columns: {case: …}`",
            Asked::Command => "give every row a name, or call the column of names `case`",
        };
        return Err(of_row(row, "the row has no name of a load case".into(), help));
    }
    if table.cases.is_empty() {
        return Ok(rows);
    }
    for pattern in &table.cases {
        if !rows.iter().any(|r| r.text(Quantity::Case).is_some_and(|c| matches(pattern, c))) {
            let told = names(rows.iter().copied(), Quantity::Case);
            let message = format!("no load case of the table is `{pattern}`");
            return Err(of_key(
                "cases",
                message,
                format!("it has {told}; `*` stands for any letters"),
            ));
        }
    }
    let asked = |r: &&ForceRow| {
        r.text(Quantity::Case).is_some_and(|c| table.cases.iter().any(|p| matches(p, c)))
    };
    Ok(rows.into_iter().filter(asked).collect())
}

/// The rows at the station that is asked for: the first, the last or the one at a distance, of each
/// case at each member and end. All cases of a member have the same sections.
fn at_station<'a>(
    rows: Vec<&'a ForceRow>,
    table: &LoadTable,
) -> Result<Vec<&'a ForceRow>, Diagnostics> {
    let Some(station) = &table.station else { return Ok(rows) };
    let place = |r: &'a ForceRow| [Quantity::Member, Quantity::End].map(|q| r.text(q));
    let key = |r: &'a ForceRow| (place(r), r.text(Quantity::Case));
    let mut groups: BTreeMap<_, Vec<(f64, &ForceRow)>> = BTreeMap::new();
    for row in &rows {
        let Some(x) = row.station else {
            let message = format!("line {} of the table has no station", row.line);
            let help = "name its column with `columns: {station: …}`, or leave `station` out";
            return Err(of_key("station", message, help));
        };
        groups.entry(key(row)).or_default().push((x, row));
    }
    let same = |a: f64, b: f64| (a - b).abs() <= SAME * a.abs().max(b.abs()).max(1.0);
    let mut extreme: BTreeMap<[Option<&str>; 2], f64> = BTreeMap::new();
    let mut kept: Vec<&ForceRow> = Vec::new();
    for ((place, case), group) in &groups {
        let all = || group.iter().map(|(x, _)| *x);
        let wanted = match station {
            Station::Start => all().fold(f64::INFINITY, f64::min),
            Station::End => all().fold(f64::NEG_INFINITY, f64::max),
            Station::At(x) => *x,
        };
        let case = case.unwrap_or_default();
        if *station == Station::End && same(wanted, 0.0) {
            let message =
                format!("load case `{case}` has no section beyond the start of the member");
            let help = "export the section at the end, or write `station: start`";
            return Err(of_row(group[0].1, message, help));
        }
        if !same(*extreme.entry(*place).or_insert(wanted), wanted) {
            let message = format!("load case `{case}` has its {station} at another station");
            let help = "export the same sections of every load case";
            return Err(of_row(group[0].1, message, help));
        }
        let length = group.iter().find_map(|(_, r)| r.length);
        let end = match station {
            Station::Start => Some(0.0),
            Station::End => length,
            Station::At(_) => None,
        };
        if let (Some(length), Some(end)) = (length, end)
            && !same(wanted, end)
        {
            let message = format!(
                "load case `{case}` has no section at the {station} of the member: the nearest is \
                 {wanted} m from the start, and the member is {length} m long"
            );
            let help = "export the sections at both ends; of a member that runs through a node, \
                        one section on each side of it";
            return Err(of_row(group[0].1, message, help));
        }
        let before = kept.len();
        kept.extend(group.iter().filter(|(x, _)| same(*x, wanted)).map(|(_, row)| *row));
        if kept.len() == before {
            let message = format!("load case `{case}` has no row at the station {station}");
            let told = names(group.iter().map(|(_, row)| *row), Quantity::Station);
            return Err(of_key("station", message, format!("it has {told}")));
        }
    }
    kept.sort_by_key(|r| r.line);
    Ok(kept)
}

/// The fault of a row; its file is that of the table.
fn of_row(row: &ForceRow, message: String, help: &str) -> Diagnostics {
    let mut d = Diagnostic::input("loads/table", message).help(help);
    d.place.line = Some(row.line);
    d.into()
}

/// Refuses a pattern of a limit state that no load case has, and a load case of two states.
fn check_states(forces: &ForceTable, table: &LoadTable) -> Result<(), Diagnostics> {
    let names = || forces.cases.iter().map(String::as_str);
    for (state, patterns) in &table.state {
        for pattern in patterns {
            if !names().any(|name| matches(pattern, name)) {
                let message = format!("no load case of the table is `{pattern}`");
                let help = "`*` stands for any letters, and case counts";
                return Err(of_key(&format!("state.{}", state.word()), message, help));
            }
        }
    }
    let fits = |name: &str| {
        let of = |patterns: &&Vec<String>| patterns.iter().any(|p| matches(p, name));
        table.state.values().filter(of).count()
    };
    if let Some(name) = names().find(|name| fits(name) > 1) {
        let message = format!("load case `{name}` is of two limit states");
        return Err(of_key("state", message, "let each name fit one of them"));
    }
    Ok(())
}

/// The load of a row; the error holds a header, what is wrong, and what to do.
fn load(
    row: &ForceRow,
    table: &LoadTable,
    given: [bool; 6],
) -> Result<LoadSpec, (&'static str, String, &'static str)> {
    let name = row.text(Quantity::Case).unwrap_or_default();
    let end = row.text(Quantity::End).or(table.end.as_deref()).map(str::to_owned);
    let at = match row.text(Quantity::At) {
        None => table.at,
        Some(word) => Some(ActionPoint::of(word).ok_or_else(|| {
            let help = "write node, column_face or bolt_plane";
            ("at", format!("`{word}` is no point at which actions act"), help)
        })?),
    };
    let mut state = LimitState::default();
    if let Some(word) = row.text(Quantity::State) {
        state = LimitState::of(word)
            .ok_or_else(|| ("state", format!("`{word}` is no limit state"), "write ULS or SLS"))?;
    } else if let Some((told, _)) =
        table.state.iter().find(|(_, patterns)| patterns.iter().any(|p| matches(p, name)))
    {
        state = *told;
    }
    let actions = match table.runs_into_the_joint() {
        true => Program::at_end(table.mapping, row.actions),
        false => row.actions,
    };
    let mut load = LoadSpec { name: name.into(), end, at, state, ..LoadSpec::default() };
    for ((action, value), given) in Action::ALL.into_iter().zip(actions).zip(given) {
        if given {
            // −0 of a sign would print as such
            load.set(action, value + 0.0);
        }
    }
    Ok(load)
}

/// Whether a name fits a pattern, in which `*` stands for any letters; case counts.
fn matches(pattern: &str, name: &str) -> bool {
    let mut parts = pattern.split('*');
    let Some(mut rest) = parts.next().and_then(|first| name.strip_prefix(first)) else {
        return false;
    };
    let mut parts = parts.peekable();
    if parts.peek().is_none() {
        return rest.is_empty();
    }
    while let Some(part) = parts.next() {
        if parts.peek().is_none() {
            return rest.ends_with(part);
        }
        let Some(at) = rest.find(part) else { return false };
        rest = &rest[at + part.len()..];
    }
    true
}

#[cfg(test)]
mod tests;
