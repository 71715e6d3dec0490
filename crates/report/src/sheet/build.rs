//! Fills the sheet from the data of the report.

use super::derivation::derivation;
use super::head::{Head, Paper};
use super::{
    Bar, BarLabels, CaseAnswer, Extent, Picture, Section, Sheet, SummaryLine, TopicSheet,
    VerdictBox, WorkedRow,
};
use crate::document::block::{Block, Grid};
use crate::document::picture::PictureRef;
use crate::document::symbols::{Piece, pieces};
use crate::document::table::{Table, dash};
use crate::document::{grid, section, spans};
use crate::figures::{Rounding, significant};
use crate::markdown::answer::answer;
use crate::markdown::assumptions::assumptions;
use crate::markdown::collapse::mechanism;
use crate::markdown::demand::actions;
use crate::markdown::hand_checks::{TOPICS, place, status, value_of};
use crate::markdown::report_data::{ReportData, ResolvedValue};
use crate::markdown::verdict::{next_step, parts};
use crate::markdown::warnings::all_warnings;
use crate::markdown::words::analysis_word;
use crate::markdown::yielding::yielding;
use crate::markdown::{
    certificate, component_method, forces, history, input, load_cases, method, polygon, route,
    stiffness,
};
use crate::result::result_file::{CaseResult, Quantity, ResultFile, Upper};
use crate::summary::{SummaryRow, Tone, summary_rows, used_words};
use crate::words::Words;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::end_plate::MethodRecord;
use bracket_codes::verdict::Verdict;
use bracket_codes::{Check, CheckId, Status, Unit};
use std::collections::BTreeSet;

/// The sheet of a report.
pub fn sheet(data: &ReportData, words: &Words, extent: Extent, paper: Paper) -> Sheet {
    let (full, all) = (extent == Extent::Full, data);
    let data = &*load_cases::condensed(all);
    let many = load_cases::are_many(all);
    let most = if full { usize::MAX } else { MOST_LINES };
    let lines = many.then(|| load_cases::lines(&all.result.load_cases, most));
    let (lines, others) = lines.unwrap_or_default();
    let further = say!("{} further load cases are in cases.csv and report.html.", others);
    let notes = [
        Some(load_cases::LINES.into()),
        (others > 0).then_some(further),
        load_cases::proof(&all.result),
    ];
    let lines_note = Text::joined(" ", notes.into_iter().flatten());
    let title = data.input.project.first().map_or_else(|| data.input.name.clone(), |l| l.1.clone());
    // an office files reports by these lines: what the spec does not give is filled in by hand
    let filed = ["number", "revision", "author", "checker", "date"];
    let given = |name: &str| data.input.project.iter().find(|line| line.0 == name).cloned();
    let block = filed.map(|name| given(name).unwrap_or_else(|| (name.into(), Head::OPEN.into())));
    let others =
        data.input.project.iter().skip(1).filter(|l| !filed.contains(&l.0.as_str())).cloned();
    let project = block.into_iter().chain(others).collect();
    let hash = data.result.input_hash.clone();
    let (rows, note) = match summary_rows(&data.result) {
        rows if many => (rows, load_cases::WORST.into()),
        rows if full => (rows, Text::default()),
        rows => in_worst_case(rows),
    };
    let sentences = |all: Vec<Text>| all.iter().map(|t| spans(words, t)).collect();
    Sheet {
        extent,
        head: Head::new(paper, title, project, words, &data.result.tool, hash),
        verdict: verdict(&data.result, words),
        drawings: captions(&data.input.drawings, words),
        actions: grid(
            words,
            &match many {
                true => load_cases::envelope(&all.input.demands),
                false => actions(&data.result, &data.input.demands),
            },
        ),
        load_cases: grid(words, &lines),
        load_cases_note: said(words, &lines_note),
        plane_actions: grid(words, &data.input.plane_actions),
        plane_note: said(words, &data.input.plane_note),
        summary: rows.into_iter().map(|r| summary_line(r, words)).collect(),
        summary_note: said(words, &note),
        answers: data.result.cases.iter().map(|c| case_answer(c, data, words)).collect(),
        frame: if full { Grid::default() } else { grid(words, &joint_values(&data.result.checks)) },
        method: method_section(&data.result.component_method, full, words),
        pictures: captions(&data.pictures, words),
        design_values: design_values(&data.input.resolved, words),
        schedule: grid(words, &data.input.schedule),
        welds: grid(words, &data.input.welds),
        supports: grid(words, &data.input.supports),
        warnings: sentences(all_warnings(data)),
        topics: if full { topics(&data.result.checks, words) } else { Vec::new() },
        assumptions: sentences(assumptions(data)),
        analysis: if full { analysis_sections(data, words) } else { Vec::new() },
        sections: if full { input_sections(data, words) } else { Vec::new() },
    }
}

/// M_j,Rd and the stiffness of the joint for each sense of bending.
fn joint_values(checks: &[Check]) -> Table {
    const COLUMNS: [&str; 4] =
        ["sense of bending", "moment resistance", "initial stiffness", "for elastic analysis"];
    let row = |moment: &Check| {
        let value = |id: CheckId| {
            let found = Check::find(checks, id, &moment.subject);
            let shown = found.and_then(|c| c.resistance.map(|v| c.unit.show(v).into()));
            shown.unwrap_or_else(dash)
        };
        let [resistance, initial, elastic] =
            [CheckId::MomentResistance, CheckId::InitialStiffness, CheckId::ElasticStiffness]
                .map(value);
        [moment.subject.text(), resistance, initial, elastic]
    };
    let moments = checks.iter().filter(|c| c.id() == CheckId::MomentResistance);
    Table::new(COLUMNS, moments.map(row))
}

/// A text with its symbols, without styles.
fn said(words: &Words, text: &Text) -> Vec<Piece> {
    pieces(&words.say(text))
}

/// Of more than [`EVERY_CASE`] load cases each check in its worst one, with the note that says so.
fn in_worst_case(mut rows: Vec<SummaryRow>) -> (Vec<SummaryRow>, Text) {
    let cases: BTreeSet<Text> = rows.iter().map(|r| r.case.clone()).collect();
    if cases.len() <= EVERY_CASE {
        return (rows, Text::default());
    }
    let all = rows.len();
    let mut seen = BTreeSet::new();
    // the worst come first
    rows.retain(|r| r.governs || seen.insert((r.check.clone(), r.clause.clone())));
    let note = say!(
        "Each check in its worst load case: {} of {} rows; report.html and the full report have \
         all.",
        rows.len(),
        all
    );
    (rows, note)
}

/// Most load cases of which the short report has a line.
const MOST_LINES: usize = 40;

/// Load cases up to which the short report lists every check of each.
const EVERY_CASE: usize = 4;

/// The component method of every sense of bending, or of those of the load cases.
fn method_section(records: &[MethodRecord], full: bool, words: &Words) -> Vec<Section> {
    let loaded = records.iter().any(|r| r.bends);
    let shown = records.iter().filter(|r| full || !loaded || r.bends);
    titled([(method::TITLE, section(words, |doc| method::senses(doc, shown)))], words)
}

fn summary_line(row: SummaryRow, words: &Words) -> SummaryLine {
    SummaryLine {
        what: said(words, &row.check),
        case: words.say(&row.case),
        demand: row.demand,
        resistance: row.resistance,
        utilisation: row.utilisation,
        clause: words.say(&row.clause),
        status: words.say(&row.status),
        tone: row.tone,
        governs: row.governs,
    }
}

fn captions(pictures: &[PictureRef], words: &Words) -> Vec<Picture> {
    let one = |p: &PictureRef| Picture { caption: words.say(&p.caption), file: p.file.clone() };
    pictures.iter().map(one).collect()
}

fn verdict(result: &ResultFile, words: &Words) -> VerdictBox {
    let tone = result.verdict.into();
    let Some(j) = &result.judgement else {
        let reason = match result.verdict {
            Verdict::NotOk => "A check that needs no load fails.",
            _ => "No load is a demand on the joint: only actions at member ends are.",
        };
        return VerdictBox {
            word: words.say(&result.verdict.words().into()),
            tone,
            reason: said(words, &reason.into()),
            parts: Vec::new(),
            next: Vec::new(),
        };
    };
    let part = |(name, v, on): (&'static str, Verdict, Text)| {
        let [name, word] = [name, v.words()].map(|t| words.say(&t.into()));
        (name, word, Tone::from(v), spans(words, &on))
    };
    let next = |step: &'static str| spans(words, &say!("Next step: {}.", step));
    VerdictBox {
        word: words.say(&j.words().into()),
        tone,
        reason: said(words, &say!("{}.", &j.reason)),
        parts: parts(j, result).into_iter().map(part).collect(),
        next: next_step(result).map(next).unwrap_or_default(),
    }
}

fn case_answer(case: &CaseResult, data: &ReportData, words: &Words) -> CaseAnswer {
    let blocks = section(words, |doc| {
        answer(doc, case, data);
        component_method::lines(doc, case);
        stiffness::lines(doc, case);
        forces::tables(doc, case, &data.result);
    });
    CaseAnswer {
        name: words.say(&say!("{}, {}", &case.name, analysis_word(case.analysis))),
        bar: bar(case),
        blocks,
    }
}

/// The bracket of a load factor; `None` for energies and without a bound.
fn bar(case: &CaseResult) -> Option<Bar> {
    if case.quantity != Quantity::LoadFactor || !case.is_strict() {
        return None;
    }
    let up = match case.upper {
        Some(Upper::Finite(up)) => Some(up),
        _ => None,
    };
    let low = case.lower.unwrap_or(0.0);
    let methods = case.demand.iter().flat_map(|d| &d.component_method).filter_map(|c| c.factor);
    let method = methods.reduce(f64::min).filter(|f| f.is_finite() && *f > 0.0);
    let label = |x: f64, rounding| significant(x, 3, rounding);
    let labels = BarLabels {
        low: (low > 0.0).then(|| label(low, Rounding::Down)),
        up: up.map(|u| label(u, Rounding::Up)),
        method: method.map(|m| label(m, Rounding::Nearest)),
    };
    (low > 0.0 || up.is_some()).then_some(Bar { low, up, method, labels })
}

/// Partial factors, and strengths of the materials.
fn design_values(resolved: &[ResolvedValue], words: &Words) -> Vec<(Vec<Piece>, String, String)> {
    let value = |v: &ResolvedValue| format!("{} {}", v.value, v.unit).trim().to_string();
    let one = |v: &ResolvedValue| {
        if let Some(which) = v.name.strip_prefix("code.gamma_") {
            return Some((
                pieces(&format!("γ_{}", which.replace('_', ","))),
                String::new(),
                value(v),
            ));
        }
        let material = v.name.strip_prefix("materials.")?.strip_suffix(".fy")?;
        Some((pieces("f_y"), words.say(&Text::given(material)), value(v)))
    };
    resolved.iter().filter_map(one).collect()
}

fn topics(checks: &[Check], words: &Words) -> Vec<TopicSheet> {
    let of = |(topic, title, about): &(bracket_codes::Topic, &'static str, &'static str)| {
        let mine: Vec<&Check> = checks.iter().filter(|c| c.topic == *topic).collect();
        let rows = mine.into_iter().map(|c| worked(c, words)).collect::<Vec<_>>();
        let (title, words) = (words.say(&(*title).into()), said(words, &(*about).into()));
        let sheet = TopicSheet { title, words, rows };
        (!sheet.rows.is_empty()).then_some(sheet)
    };
    TOPICS.iter().filter_map(of).collect()
}

fn worked(c: &Check, words: &Words) -> WorkedRow {
    let tone = match c.status {
        Status::Ok => Tone::Good,
        Status::Failed => Tone::Bad,
        Status::Undecided => Tone::Open,
        Status::Warning | Status::Information => Tone::Quiet,
    };
    WorkedRow {
        of: words.say(&place(c)),
        check: said(words, &c.title.text()),
        formula: derivation(&c.derivation, words),
        values: ratio(c)
            .into_iter()
            .map(|s| pieces(&s))
            .chain(c.values.iter().map(|s| said(words, &value_of(s))))
            .collect(),
        clause: words.say(&c.clause),
        utilisation: used_words(c),
        status: words.say(&status(c).into()),
        tone,
    }
}

/// Demand over resistance with their numbers, where the formula does not end with it.
fn ratio(c: &Check) -> Option<String> {
    if c.case.is_none() || c.utilisation.is_none() || c.is_limit() || c.unit == Unit::Number {
        return None;
    }
    let [demand, resistance] = [c.demand?, c.resistance?].map(|v| c.unit.show(v));
    let used = used_words(c);
    let formula = c.formula().to_string();
    let said = formula.contains(&demand) && formula.contains(&resistance);
    (!said).then(|| format!("E_d / R_d = {demand} / {resistance} = {used}"))
}

/// The sections with a text, in the language of `words`.
fn titled<const N: usize>(all: [(&'static str, Vec<Block>); N], words: &Words) -> Vec<Section> {
    let some = all.into_iter().filter(|(_, blocks)| !blocks.is_empty());
    some.map(|(title, blocks)| Section { title: words.say(&title.into()), blocks }).collect()
}

fn analysis_sections(data: &ReportData, words: &Words) -> Vec<Section> {
    let cases = || data.result.cases.iter();
    let route = section(words, |doc| route::steps(doc, &data.result));
    let polygon = section(words, |doc| polygon::section(doc, &data.result));
    let collapse = section(words, |doc| {
        cases().for_each(|c| {
            mechanism(doc, c);
            yielding(doc, c);
        });
    });
    let (mut meshes, mut certificate) = (Vec::new(), Vec::new());
    if !data.result.cases.is_empty() {
        meshes = section(words, |doc| {
            let run = cases().filter(|c| !c.history.is_empty());
            run.for_each(|c| history::history(doc, c, data.result.symmetry));
        });
        if !data.mesh_quality.rows.is_empty() {
            meshes.insert(0, Block::Table { table: grid(words, &data.mesh_quality) });
        }
        certificate = section(words, |doc| certificate::certificates(doc, data));
    }
    let all = [
        ("Route of analysis", route),
        ("Capacity for two actions", polygon),
        ("Mechanism and yielding", collapse),
        ("Mesh and history", meshes),
        ("Certificate", certificate),
    ];
    titled(all, words)
}

fn input_sections(data: &ReportData, words: &Words) -> Vec<Section> {
    let values = section(words, |doc| input::values(doc, data));
    let input = vec![Block::Code { text: data.input.text.clone() }];
    let all =
        [("Resolved values, catalogue rows and notes", values), ("Input file as given", input)];
    titled(all, words)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::result::fixtures::limit_case;

    /// Only strict bounds are drawn, and a bound that is not known stays open.
    #[test]
    fn the_bar_shows_what_is_proved() {
        let at = |low, up, strict: bool| {
            let mut case = limit_case(low, up);
            case.certificate.iter_mut().for_each(|c| c.strict = strict);
            bar(&case).map(|b| (b.low, b.up))
        };
        assert_eq!(at(Some(1.2), Some(1.5), true), Some((1.2, Some(1.5))));
        assert_eq!(at(None, Some(1.5), true), Some((0.0, Some(1.5))));
        assert_eq!(at(Some(1.2), None, true), Some((1.2, None)));
        assert_eq!(at(None, None, true), None);
        assert_eq!(at(Some(1.2), Some(1.5), false), None);
    }
}
