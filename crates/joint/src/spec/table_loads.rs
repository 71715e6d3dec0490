//! Makes load cases of the table that a spec names.

use super::connection::ConnectionSpec;
use super::load_table::{LoadTable, Station};
use super::loads::{Action, ActionPoint, LimitState, LoadSpec};
use crate::forces::{ForceRow, Program, Quantity, Source, names, read};
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
    let loads = listed(&table, &file, |path| spec.index.place(path))?;
    for (line, load) in loads {
        spec.index.add(format!("loads[{}]", spec.value.loads.len()), &file, line);
        spec.value.loads.push(load);
    }
    Ok(true)
}

/// Load cases as a table with Bracket's own headers, from which they are read to the last bit.
pub fn written(loads: &[LoadSpec]) -> String {
    let mut out = csv::Writer::from_writer(Vec::new());
    let value = |l: &LoadSpec, a: Action| l.actions().into_iter().find(|(g, _)| *g == a);
    let given: Vec<Action> =
        Action::ALL.into_iter().filter(|a| loads.iter().any(|l| value(l, *a).is_some())).collect();
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
        let numbers = given.iter().map(|a| value(load, *a).map_or(0.0, |(_, v)| v).to_string());
        let _ = out.write_record(words.into_iter().chain(numbers));
    }
    out.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// The load cases of a table with their lines; `place`: the place of a key of the spec.
pub fn listed(
    table: &LoadTable,
    file: &Path,
    place: impl Fn(&str) -> Place,
) -> Result<Vec<(usize, LoadSpec)>, Diagnostics> {
    cases(table, file).map_err(|faults| {
        faults.map(|mut d| {
            // a fault of the table has its place
            if d.place.file.is_none() {
                d.place = place(d.place.path.as_deref().unwrap_or("loads"));
                d.message = format!("{} (`{}`)", d.message, file.display());
            }
            d
        })
    })
}

fn cases(table: &LoadTable, file: &Path) -> Result<Vec<(usize, LoadSpec)>, Diagnostics> {
    let sheet = table.sheet.as_deref();
    let source = Source { file, sheet, program: table.mapping, columns: &table.columns };
    let (rows, given) = read(&source)?;
    let rows = of_member(&rows, table)?;
    let rows = of_cases(rows, table)?;
    let rows = at_station(rows, table)?;
    let mut loads: Vec<(usize, LoadSpec)> = Vec::new();
    for row in rows {
        let load = load(row, table, given).map_err(|(key, message, help)| {
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
    rows: &'a [ForceRow],
    table: &LoadTable,
) -> Result<Vec<&'a ForceRow>, Diagnostics> {
    let mut kept: Vec<&ForceRow> = rows.iter().collect();
    let asked =
        [("member", Quantity::Member, &table.member), ("node", Quantity::Node, &table.node)];
    for (key, quantity, wanted) in asked {
        let told = || names(kept.iter().copied(), quantity);
        match wanted {
            Some(wanted) => {
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
                if kept.iter().any(|r| r.text(quantity) != first) && table.end.is_some() {
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
/// case.
fn at_station<'a>(
    rows: Vec<&'a ForceRow>,
    table: &LoadTable,
) -> Result<Vec<&'a ForceRow>, Diagnostics> {
    let Some(station) = &table.station else { return Ok(rows) };
    let mut of_case: BTreeMap<Option<&str>, Vec<f64>> = BTreeMap::new();
    for row in &rows {
        let Some(x) = row.station() else {
            let message = format!("line {} of the table has no station", row.line);
            let help = "name its column with `columns: {station: …}`, or leave `station` out";
            return Err(of_key("station", message, help));
        };
        of_case.entry(row.text(Quantity::Case)).or_default().push(x);
    }
    let wanted = |row: &ForceRow| {
        let all = &of_case[&row.text(Quantity::Case)];
        match station {
            Station::Start => all.iter().copied().fold(f64::INFINITY, f64::min),
            Station::End => all.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            Station::At(x) => *x,
        }
    };
    let is = |row: &&&ForceRow| {
        let (x, at) = (row.station().unwrap_or(f64::NAN), wanted(row));
        (x - at).abs() <= SAME * at.abs().max(1.0)
    };
    let kept: Vec<&ForceRow> = rows.iter().filter(is).copied().collect();
    if kept.is_empty() {
        let told = names(rows.iter().copied(), Quantity::Station);
        let message = format!("the table has no row at the station {station}");
        return Err(of_key("station", message, format!("it has {told}")));
    }
    Ok(kept)
}

/// The load of a row; the error holds a header, what is wrong, and what to do.
fn load(
    row: &ForceRow,
    table: &LoadTable,
    given: [bool; 6],
) -> Result<LoadSpec, (&'static str, String, &'static str)> {
    let Some(name) = row.text(Quantity::Case) else {
        let help = "give every row a name, or name the column with `columns: {case: …}`";
        return Err(("case", "the row has no name of a load case".into(), help));
    };
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
