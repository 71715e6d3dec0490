//! The component method with the numbers of its T-stubs, rows and limits, from which a reader can
//! compute M_j,Rd again.

use crate::document::Doc;
use crate::document::table::{Table, cells, dash};
use crate::figures::{Rounding, fixed};
use crate::markdown::hand_checks::value_of;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::component_method::t_stub::Mode;
use bracket_codes::end_plate::{LimitRecord, MethodRecord, RowRecord, StubRecord, WebRecord};

/// The section of `report.md`: every sense of bending.
pub(crate) fn section(doc: &mut Doc, records: &[MethodRecord]) {
    if !records.is_empty() {
        doc.heading(TITLE);
        senses(doc, records.iter());
    }
}

/// Title of the section.
pub(crate) const TITLE: &str = "Component method with its numbers";

/// How the columns of the T-stubs follow from each other.
const KEY: &str = "Lengths in mm, forces in kN. ℓ_eff,1 = min(ℓ_eff,cp, ℓ_eff,nc), ℓ_eff,2 = \
                   ℓ_eff,nc, M_pl = 0.25 ℓ_eff t² f_y/γ_M0; mode 1: 4 M_pl,1/m; mode 2: (2 M_pl,2 \
                   + n ΣF_t,Rd)/(m + n); mode 3: ΣF_t,Rd; mode 1-2, without prying: 2 M_pl,1/m; \
                   web behind it: ω ℓ_eff,1 t_w f_y/γ_M0. Of a row outside the beam, m is m_x and \
                   e is e_x.";

/// The records of some senses of bending.
pub(crate) fn senses<'a>(doc: &mut Doc, records: impl Iterator<Item = &'a MethodRecord>) {
    for (i, record) in records.enumerate() {
        doc.paragraph(given(record));
        doc.table(&stubs(&record.stubs));
        if i == 0 {
            doc.paragraph(KEY);
        }
        doc.table(&rows(&record.rows));
        let limits = record.limits.iter().map(limit_words);
        let values = Text::joined(", ", record.stiffness.iter().map(value_of));
        let stiffness = say!("{}; {}", &record.initial_stiffness, values);
        doc.list(limits.chain([record.formula.clone(), stiffness]));
    }
}

/// Sense of bending with the values that all its T-stubs share.
fn given(r: &MethodRecord) -> Text {
    let mut parts = vec![
        Text::from(format!("F_t,Rd = {} kN", force(r.bolt))),
        format!("γ_M0 = {}", trimmed(r.gamma_m0, 3)).into(),
    ];
    if r.beta > 0.0 {
        parts.push(format!("β = {}", trimmed(r.beta, 4)).into());
    }
    let mut steel = |name: &Text, thickness: f64, fy: f64| {
        let text = say!("{}: t = {} mm, f_y = {} MPa", name, length(thickness), trimmed(fy, 1));
        if !parts.contains(&text) {
            parts.push(text);
        }
    };
    for stub in &r.stubs {
        steel(&stub.part, stub.thickness, stub.fy);
        stub.web.iter().for_each(|w| steel(&w.part, w.thickness, w.fy));
    }
    say!("**{}**: {}.", &r.subject, Text::joined("; ", parts))
}

fn stubs(stubs: &[StubRecord]) -> Table {
    let row = |s: &StubRecord| {
        let [first, last] = s.rows;
        let rows = if first == last { first.to_string() } else { format!("{first}–{last}") };
        let list = |all: &[f64], places| {
            let all: Vec<String> = all.iter().map(|x| trimmed(*x, places)).collect();
            if all.is_empty() { dash() } else { all.join("/").into() }
        };
        let mode = |of: Mode| s.modes.iter().find(|m| m.0 == of).map(|m| Text::from(force(m.1)));
        let one = mode(Mode::Flange).or(mode(Mode::FlangeWithoutPrying));
        let web = |of: fn(&WebRecord) -> String| s.web.as_ref().map_or_else(dash, |w| of(w).into());
        cells![
            rows,
            s.part.clone(),
            length(s.m),
            length(s.e),
            length(s.n),
            list(&s.m2, 2),
            list(&s.alpha, 3),
            length(s.circular),
            length(s.straight),
            one.unwrap_or_else(dash),
            mode(Mode::FlangeAndBolts).unwrap_or_else(dash),
            mode(Mode::Bolts).unwrap_or_else(dash),
            s.mode.number(),
            web(|w| trimmed(w.omega, 4)),
            web(|w| force(w.resistance)),
        ]
    };
    let columns = Table::columns([
        "row",
        "part",
        "m",
        "e",
        "n",
        "m2",
        "α",
        "ℓ_eff,cp",
        "ℓ_eff,nc",
        "mode 1",
        "mode 2",
        "mode 3",
        "mode",
        "ω",
        "web",
    ]);
    Table { columns, rows: stubs.iter().map(row).collect() }
}

fn rows(rows: &[RowRecord]) -> Table {
    let mut columns =
        Table::columns(["row", "z", "h_r", "alone", "after groups", "F_tr,Rd", "limited by"]);
    let symbols = rows.first().map_or(&[][..], |r| &r.stiffness);
    columns.extend(symbols.iter().map(|s| s.symbol.clone()));
    let row = |r: &RowRecord| {
        let mut cells = cells![
            r.row.to_string(),
            length(r.z).replace('-', "−"),
            length(r.lever),
            force(r.alone),
            force(r.grouped),
            force(r.force),
            r.limited_by.clone(),
        ];
        cells.extend(r.stiffness.iter().map(|k| Text::from(trimmed(k.value, 3))));
        cells
    };
    Table { columns, rows: rows.iter().map(row).collect() }
}

fn limit_words(l: &LimitRecord) -> Text {
    let values = Text::joined(", ", l.values.iter().map(value_of));
    say!("{}: {} ({})", &l.part, Text::joined("; ", [l.formula.clone(), values]), &l.clause)
}

/// A length with two decimals \[mm\].
fn length(x: f64) -> String {
    trimmed(x, 2)
}

/// A force in kN with two decimals.
fn force(x: f64) -> String {
    fixed(1e-3 * x, 2, Rounding::Nearest)
}

fn trimmed(x: f64, places: i32) -> String {
    let text = fixed(x, places, Rounding::Nearest);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}
