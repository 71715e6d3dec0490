//! Fills the sheet from the data of the report.

use super::blocks::{Block, Grid, plain, section, sentence};
use super::derivation::derivation;
use super::formula::{Piece, pieces};
use super::head::{Head, Paper};
use super::{
    Bar, BarLabels, CaseAnswer, Extent, Section, Sheet, SummaryLine, TopicSheet, VerdictBox,
    WorkedRow,
};
use crate::figures::{Rounding, significant};
use crate::markdown::answer::answer;
use crate::markdown::assumptions::assumptions;
use crate::markdown::collapse::mechanism;
use crate::markdown::demand::{ON_PLANES, actions};
use crate::markdown::hand_checks::{TOPICS, place, status, value_of};
use crate::markdown::report_data::{PictureRef, ReportData, ResolvedValue, Table};
use crate::markdown::verdict::{next_step, parts};
use crate::markdown::warnings::all_warnings;
use crate::markdown::words::analysis_word;
use crate::markdown::yielding::yielding;
use crate::markdown::{
    certificate, component_method, forces, history, input, method, polygon, stiffness,
};
use crate::result::result_file::{CaseResult, Quantity, ResultFile, Upper};
use crate::summary::{SummaryRow, Tone, summary_rows, used_words};
use crate::words::Words;
use bracket_codes::end_plate::MethodRecord;
use bracket_codes::verdict::Verdict;
use bracket_codes::{Check, CheckId, Status, Unit};
use std::collections::BTreeSet;

/// The sheet of a report.
pub fn sheet(data: &ReportData, words: &Words, extent: Extent, paper: Paper) -> Sheet {
    let full = extent == Extent::Full;
    let title = data.input.project.first().map_or_else(|| data.input.name.clone(), |l| l.1.clone());
    // an office files reports by these lines: what the spec does not give is filled in by hand
    let filed = ["number", "revision", "author", "checker", "date"];
    let given = |name: &str| data.input.project.iter().find(|line| line.0 == name).cloned();
    let block = filed.map(|name| given(name).unwrap_or_else(|| (name.into(), Head::OPEN.into())));
    let others =
        data.input.project.iter().skip(1).filter(|l| !filed.contains(&l.0.as_str())).cloned();
    let project = block.into_iter().chain(others).collect();
    let hash = data.result.input_hash.clone();
    let (rows, note) = match full {
        true => (summary_rows(&data.result), String::new()),
        false => in_worst_case(summary_rows(&data.result)),
    };
    let sentences = |all: Vec<String>| all.iter().map(|s| sentence(&words.say(s))).collect();
    Sheet {
        extent,
        head: Head::new(paper, title, project, words, &data.result.tool, hash),
        verdict: verdict(&data.result, words),
        drawings: captions(&data.input.drawings, words),
        actions: grid(&actions(&data.result, &data.input.demands), words),
        plane_actions: grid(&data.input.plane_actions, words),
        plane_note: pieces(&words.say(ON_PLANES)),
        summary: rows.into_iter().map(|r| summary_line(r, words)).collect(),
        summary_note: pieces(&words.say(&note)),
        answers: data.result.cases.iter().map(|c| case_answer(c, data, words)).collect(),
        frame: if full { Grid::default() } else { grid(&joint_values(&data.result.checks), words) },
        method: method_section(&data.result.component_method, full, words),
        pictures: captions(&data.pictures, words),
        design_values: design_values(&data.input.resolved, words),
        schedule: grid(&data.input.schedule, words),
        welds: grid(&data.input.welds, words),
        supports: grid(&data.input.supports, words),
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
            let shown = found.and_then(|c| c.resistance.map(|v| c.unit.show(v)));
            shown.unwrap_or_else(|| "–".into())
        };
        let ids = [CheckId::MomentResistance, CheckId::InitialStiffness, CheckId::ElasticStiffness];
        std::iter::once(moment.subject.text()).chain(ids.map(value)).collect()
    };
    Table {
        columns: COLUMNS.map(String::from).into(),
        rows: checks.iter().filter(|c| c.id() == CheckId::MomentResistance).map(row).collect(),
    }
}

/// Of more than [`EVERY_CASE`] load cases each check in its worst one, with the note that says so.
fn in_worst_case(mut rows: Vec<SummaryRow>) -> (Vec<SummaryRow>, String) {
    let cases: BTreeSet<String> = rows.iter().map(|r| r.case.clone()).collect();
    if cases.len() <= EVERY_CASE {
        return (rows, String::new());
    }
    let all = rows.len();
    let mut seen = BTreeSet::new();
    // the worst come first
    rows.retain(|r| r.governs || seen.insert((r.check.clone(), r.clause.clone())));
    let note = format!(
        "Each check in its worst load case: {} of {all} rows; report.html and the full report have \
         all.",
        rows.len()
    );
    (rows, note)
}

/// Load cases up to which the short report lists every check of each.
const EVERY_CASE: usize = 4;

/// The component method of every sense of bending, or of those of the load cases.
fn method_section(records: &[MethodRecord], full: bool, words: &Words) -> Vec<Section> {
    let loaded = records.iter().any(|r| r.bends);
    let shown = records.iter().filter(|r| full || !loaded || r.bends);
    titled([(method::TITLE, section(words, |page| method::senses(page, shown)))], words)
}

fn summary_line(mut row: SummaryRow, words: &Words) -> SummaryLine {
    for text in [&mut row.case, &mut row.demand, &mut row.resistance, &mut row.clause] {
        *text = words.say(text);
    }
    row.status = words.say(&row.status);
    SummaryLine { what: pieces(&words.say(&row.check)), row }
}

fn captions(pictures: &[PictureRef], words: &Words) -> Vec<PictureRef> {
    let one = |p: &PictureRef| PictureRef { caption: words.say(&p.caption), file: p.file.clone() };
    pictures.iter().map(one).collect()
}

fn grid(table: &Table, words: &Words) -> Grid {
    let number = |c: usize| {
        let mut cells = table.rows.iter().filter_map(|r| r.get(c)).filter(|t| !t.is_empty());
        cells.all(|t| t.starts_with(|l: char| l.is_ascii_digit() || "-−–".contains(l)))
    };
    Grid {
        columns: table.columns.iter().map(|c| plain(words.say(c))).collect(),
        right: (0..table.columns.len()).map(number).collect(),
        rows: table.rows.iter().map(|r| r.iter().map(|c| plain(words.say(c))).collect()).collect(),
    }
}

fn verdict(result: &ResultFile, words: &Words) -> VerdictBox {
    let tone = result.verdict.into();
    let Some(j) = &result.judgement else {
        let word = words.say(result.verdict.words());
        let reason = match result.verdict {
            Verdict::NotOk => "A check that needs no load fails.",
            _ => "No load is a demand on the joint: only actions at member ends are.",
        };
        let reason = pieces(&words.say(reason));
        return VerdictBox { word, tone, reason, parts: Vec::new(), next: Vec::new() };
    };
    let part = |(name, v, on): (&str, Verdict, String)| {
        (words.say(name), words.say(v.words()), Tone::from(v), sentence(&words.say(&on)))
    };
    let next = |step: &str| sentence(&words.say(&format!("Next step: {step}.")));
    VerdictBox {
        word: words.say(j.words()),
        tone,
        reason: pieces(&words.say(&format!("{}.", j.reason))),
        parts: parts(j, result).into_iter().map(part).collect(),
        next: next_step(result).map(next).unwrap_or_default(),
    }
}

fn case_answer(case: &CaseResult, data: &ReportData, words: &Words) -> CaseAnswer {
    let blocks = section(words, |page| {
        answer(page, case, data);
        component_method::lines(page, case);
        stiffness::lines(page, case);
        forces::tables(page, case, data.result.symmetry);
    });
    CaseAnswer {
        name: format!("{}, {}", case.name, words.say(analysis_word(case.analysis))),
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
        Some((pieces("f_y"), words.say(material), value(v)))
    };
    resolved.iter().filter_map(one).collect()
}

fn topics(checks: &[Check], words: &Words) -> Vec<TopicSheet> {
    let of = |(topic, title, about): &(bracket_codes::Topic, &str, &str)| {
        let mine: Vec<&Check> = checks.iter().filter(|c| c.topic == *topic).collect();
        let rows = mine.into_iter().map(|c| worked(c, words)).collect::<Vec<_>>();
        let sheet = TopicSheet { title: words.say(title), words: pieces(&words.say(about)), rows };
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
        check: pieces(&words.say(&c.title.text())),
        formula: derivation(&c.derivation, words),
        values: ratio(c)
            .into_iter()
            .chain(c.values.iter().map(|s| words.say(&value_of(s))))
            .map(|s| pieces(&s))
            .collect(),
        clause: words.say(&c.clause),
        utilisation: used_words(c),
        status: words.say(status(c)),
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
    let formula = c.formula();
    let said = formula.contains(&demand) && formula.contains(&resistance);
    (!said).then(|| format!("E_d / R_d = {demand} / {resistance} = {used}"))
}

/// The sections with a text, in the language of `words`.
fn titled<const N: usize>(all: [(&str, Vec<Block>); N], words: &Words) -> Vec<Section> {
    let some = all.into_iter().filter(|(_, blocks)| !blocks.is_empty());
    some.map(|(title, blocks)| Section { title: words.say(title), blocks }).collect()
}

fn analysis_sections(data: &ReportData, words: &Words) -> Vec<Section> {
    let cases = || data.result.cases.iter();
    let polygon = section(words, |page| polygon::section(page, &data.result));
    let collapse = section(words, |page| {
        cases().for_each(|c| {
            mechanism(page, c);
            yielding(page, c);
        });
    });
    let (mut meshes, mut certificate) = (Vec::new(), Vec::new());
    if !data.result.cases.is_empty() {
        meshes = section(words, |page| {
            let run = cases().filter(|c| !c.history.is_empty());
            run.for_each(|c| history::history(page, c, data.result.symmetry));
        });
        if !data.mesh_quality.rows.is_empty() {
            meshes.insert(0, Block::Table { table: grid(&data.mesh_quality, words) });
        }
        certificate = section(words, |page| certificate::certificates(page, data));
    }
    let all = [
        ("Capacity for two actions", polygon),
        ("Mechanism and yielding", collapse),
        ("Mesh and history", meshes),
        ("Certificate", certificate),
    ];
    titled(all, words)
}

fn input_sections(data: &ReportData, words: &Words) -> Vec<Section> {
    let values = section(words, |page| input::values(page, data));
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
