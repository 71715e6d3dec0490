//! `report.md`: one page with the answer first and everything that backs it below.

use crate::analysis::cone_shift::FixedPointRun;
use crate::checks::{Status, Topic};
use crate::report::figures::{Rounding, bracket, percent_up, residual, significant};
use crate::report::markdown::limit::{collapse, estimate_words, mechanism};
use crate::report::markdown::page::{ReportData, Table};
use crate::report::markdown::plastic::{displacement, yielding};
use crate::report::markdown::preload::preload_words;
use crate::report::markdown::{checks, comparison, input, summary, verdict};
use crate::result::data::{
    CaseResult, FrictionModel, HistoryRow, ProgramRun, Quantity, RESIDUAL_TOLERANCE, RawBracket,
    Upper,
};
use crate::result::demand::demands;
use crate::result::{forces, polygon, stiffness};
use crate::spec::analysis::AnalysisKind;

/// The text of `report.md`, the same for the same data.
pub fn report_markdown(data: &ReportData) -> String {
    let mut page = String::new();
    title_block(&mut page, data);
    heading(&mut page, "Answer");
    verdict::verdict(&mut page, &data.result);
    checks::failed(&mut page, &data.result.checks);
    summary::table_of_checks(&mut page, &data.result);
    demands(&mut page, &data.result);
    for case in &data.result.cases {
        answer(&mut page, case, data);
        comparison::lines(&mut page, case);
        stiffness::lines(&mut page, case);
        forces::tables(&mut page, case, data.result.symmetry);
    }
    if data.result.cases.is_empty() {
        paragraph(&mut page, "By the code's checks alone: no analysis was run.");
    }
    polygon::section(&mut page, &data.result);
    for picture in &data.pictures {
        paragraph(&mut page, &format!("![{}]({})", inline(&picture.caption), picture.file));
    }
    for case in &data.result.cases {
        mechanism(&mut page, case);
        yielding(&mut page, case);
    }
    warnings(&mut page, data);
    joint(&mut page, data);
    input::sections(&mut page, data);
    checks::checks(&mut page, &data.result.checks);
    if !data.result.cases.is_empty() {
        analyses(&mut page, data);
    }
    input::file(&mut page, data);
    page
}

/// What backs the numbers of the analyses.
fn analyses(page: &mut String, data: &ReportData) {
    heading(page, "Mesh and history");
    if !data.mesh_quality.rows.is_empty() {
        table(page, &data.mesh_quality);
    }
    for case in data.result.cases.iter().filter(|c| !c.history.is_empty()) {
        history(page, case, data.result.symmetry);
    }
    heading(page, "Certificate");
    certificates(page, data);
    heading(page, "Assumptions and limits");
    for sentence in limits(data) {
        page.push_str(&format!("- {}\n", inline(&sentence)));
    }
    page.push('\n');
}

pub(crate) fn heading(page: &mut String, text: &str) {
    page.push_str(&format!("## {text}\n\n"));
}

pub(crate) fn paragraph(page: &mut String, text: &str) {
    page.push_str(text);
    page.push_str("\n\n");
}

/// Text that must not break out of its line or cell.
pub(crate) fn inline(text: &str) -> String {
    text.replace(['\n', '\r'], " ").replace('|', "\\|").replace('<', "&lt;")
}

pub(crate) fn table(page: &mut String, table: &Table) {
    let row = |cells: &[String]| {
        format!("| {} |\n", cells.iter().map(|c| inline(c)).collect::<Vec<_>>().join(" | "))
    };
    page.push_str(&row(&table.columns));
    let number = |c: usize| {
        table.rows.iter().all(|r| {
            r.get(c).is_none_or(|t| {
                t.is_empty() || t.starts_with(|l: char| l.is_ascii_digit() || "-<–".contains(l))
            })
        })
    };
    let rule: Vec<&str> =
        (0..table.columns.len()).map(|c| if number(c) { "---:" } else { "---" }).collect();
    page.push_str(&format!("| {} |\n", rule.join(" | ")));
    for r in &table.rows {
        page.push_str(&row(r));
    }
    page.push('\n');
}

pub(crate) fn strings<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(String::from).to_vec()
}

/// Drawings, bolts and plates.
fn joint(page: &mut String, data: &ReportData) {
    if data.drawings.is_empty() && data.schedule.rows.is_empty() {
        return;
    }
    heading(page, "Joint");
    for drawing in &data.drawings {
        paragraph(page, &format!("![{}]({})", inline(&drawing.caption), drawing.file));
    }
    if !data.schedule.rows.is_empty() {
        paragraph(
            page,
            "Bolts, plates and stiffeners, with masses from nominal sizes at 7850 kg/m³; members \
             by their length on site:",
        );
        table(page, &data.schedule);
    }
}

fn title_block(page: &mut String, data: &ReportData) {
    let mut lines = data.project.iter();
    let title = lines.next().map_or(data.input_name.as_str(), |(_, title)| title.as_str());
    page.push_str(&format!("# {}\n\n", inline(title)));
    let mut rows: Vec<Vec<String>> =
        lines.map(|(name, value)| vec![name.clone(), value.clone()]).collect();
    let tool = &data.result.tool;
    rows.push(vec!["software".into(), format!("{} {}", tool.name, tool.version)]);
    rows.push(vec!["input".into(), data.input_name.clone()]);
    rows.push(vec!["input hash (BLAKE3)".into(), format!("`{}`", data.result.input_hash)]);
    table(page, &Table { columns: strings(["project", "value"]), rows });
}

fn analysis_word(kind: AnalysisKind) -> &'static str {
    match kind {
        AnalysisKind::Elastic => "elastic",
        AnalysisKind::Elastoplastic => "elastic, perfectly plastic",
        AnalysisKind::Limit => "limit analysis",
    }
}

fn problem_words(problem: FrictionModel, contact: bool) -> &'static str {
    match problem {
        FrictionModel::Frictionless if !contact => "",
        FrictionModel::Frictionless => " with frictionless contact",
        FrictionModel::Associated => " with contact and associated friction",
        FrictionModel::Coulomb => " with contact and Coulomb friction",
        FrictionModel::ShiftedCones => {
            " with contact, in the last step of the fixed point for Coulomb friction (shifted \
             cones)"
        }
    }
}

pub(crate) fn is_strict(case: &CaseResult) -> bool {
    case.certificate.is_some_and(|c| c.strict)
}

fn answer(page: &mut String, case: &CaseResult, data: &ReportData) {
    let contact = data.model.contact;
    let (what, unit) = match case.quantity {
        Quantity::PotentialEnergy => ("potential energy of the whole structure", " N mm"),
        Quantity::LoadFactor => ("load factor at collapse", ""),
    };
    let strict = is_strict(case);
    let name = format!(
        "**{}** ({}{})",
        inline(&case.name),
        analysis_word(case.analysis),
        problem_words(case.problem, contact)
    );
    let text = match (case.lower, case.upper) {
        (_, Some(Upper::Finite(0.0))) if case.quantity == Quantity::LoadFactor => {
            let verb = if strict { "is" } else { "is estimated as" };
            format!(
                "{name}: the {what} {verb} **0**: a mechanism moves the structure freely, and the \
                 live loads drive it."
            )
        }
        (Some(lower), Some(Upper::Finite(upper))) => {
            let digits = if case.quantity == Quantity::PotentialEnergy { 4 } else { 3 };
            let (low, high) = bracket(lower, upper, digits);
            let verb = if strict { "lies between" } else { "is estimated between" };
            let gap = case.gap.map(|g| format!(", gap **{}**", percent_up(g))).unwrap_or_default();
            format!("{name}: the {what} {verb} **{low}** and **{high}**{unit}{gap}.")
        }
        (Some(lower), Some(Upper::Unbounded(_))) => {
            let low = significant(lower, 6, Rounding::Down);
            format!(
                "{name}: the loads can grow without limit; the {what} is unbounded above and at \
                 least **{low}**{unit}."
            )
        }
        (Some(lower), None) => {
            let low = significant(lower, 6, Rounding::Down);
            let verb = if strict { "is at least" } else { "is estimated (from below) at" };
            format!("{name}: the {what} {verb} **{low}**{unit}; no upper value was computed.")
        }
        (None, Some(Upper::Finite(upper))) => {
            let high = significant(upper, 6, Rounding::Up);
            let verb = if strict { "is at most" } else { "is estimated (from above) at" };
            format!("{name}: the {what} {verb} **{high}**{unit}; no lower value was computed.")
        }
        (None, Some(Upper::Unbounded(_))) => {
            let proof = if strict {
                ": the stress field of the live loads alone nowhere comes nearer to yield"
            } else {
                ""
            };
            format!("{name}: the loads can grow without limit{proof}.")
        }
        (None, None) => format!("{name}: no value was obtained; the history below says why."),
    };
    paragraph(page, &text);
    if !strict && (case.lower.is_some() || case.upper.is_some()) {
        paragraph(
            page,
            "**These are estimates, not bounds**: a residual of the certificate exceeds its \
             tolerance, or no certificate was computed.",
        );
    }
    meaning(page, case, data);
}

/// What the numbers mean to an engineer.
fn meaning(page: &mut String, case: &CaseResult, data: &ReportData) {
    let word = if is_strict(case) { "lies" } else { "is estimated" };
    match (case.quantity, case.load.zip(case.load_displacement)) {
        (Quantity::PotentialEnergy, Some((load, [low, high]))) => {
            let (a, b) = bracket(low, high, 3);
            let (what, unit) = load.moves();
            let mean = if what == "displacement" {
                " (along the load, the mean over its face)"
            } else {
                ""
            };
            let [soft, stiff] = [high, low].map(|u| load.value() * load.scale() / u);
            let (soft, stiff) = bracket(soft, stiff, 3);
            paragraph(
                page,
                &format!(
                    "The load of the whole structure is {}. Its {what}{mean} {word} between {a} \
                     and {b} {unit}, so the initial stiffness between {soft} and {stiff} \
                     {}/{unit}.",
                    load.words(),
                    load.unit()
                ),
            );
        }
        (Quantity::PotentialEnergy, None) => {
            let shifted = case.problem == FrictionModel::ShiftedCones;
            let all = [
                (data.model.preload, "preload"),
                (data.model.initial_gap, "initial gaps"),
                (shifted, "Coulomb friction"),
            ];
            let with: Vec<&str> =
                all.into_iter().filter(|(is, _)| *is).map(|(_, what)| what).collect();
            let why = match with.len() {
                0 => String::new(),
                _ => format!(": with {} it does not bracket a displacement", with.join(" and ")),
            };
            paragraph(page, &format!("The bracket is one of the energy only{why}."));
            displacement(page, case);
        }
        (Quantity::LoadFactor, _) => collapse(page, case),
    }
    if let Some([low, high]) = case.utilisation {
        let (a, b) = (significant(low, 3, Rounding::Down), significant(high, 3, Rounding::Up));
        paragraph(page, &format!("Utilisation (demand over capacity) between {a} and {b}."));
    }
    for (label, raw) in
        [("Frictionless", case.frictionless), ("Associated friction", case.associated)]
    {
        if let Some(raw) = raw {
            paragraph(page, &format!("{label} alone: {}.", raw_bracket(raw)));
        }
    }
    for bolt in &case.preload {
        paragraph(page, &preload_words(bolt));
    }
    match (case.coulomb_estimate, &case.fixed_point) {
        (Some(estimate), run) => paragraph(page, &estimate_words(estimate, run.as_ref())),
        (None, Some(run)) => paragraph(page, &fixed_point_words(run)),
        (None, None) => {}
    }
    if let Some(peak) = case.peak_contact_pressure {
        let side = |name: &str, p: Option<f64>| {
            p.map(|p| format!("{} MPa ({name})", significant(p, 3, Rounding::Nearest)))
        };
        let sides: Vec<String> =
            [side("static side", peak.static_), side("kinematic side", peak.kinematic)]
                .into_iter()
                .flatten()
                .collect();
        if !sides.is_empty() {
            paragraph(
                page,
                &format!(
                    "Peak contact pressure: {}; local values are estimates.",
                    sides.join(", ")
                ),
            );
        }
    }
}

/// How near the problem of the bracket is to Coulomb's law.
fn fixed_point_words(run: &FixedPointRun) -> String {
    let problems =
        if run.solves == 1 { "one problem".into() } else { format!("{} problems", run.solves) };
    let contraction = match run.contraction {
        Some(c) => format!("; a plain step leaves {} of the error", percent_up(c)),
        None => String::new(),
    };
    format!(
        "Coulomb's law was reached through {problems}; the last changed the slips by at most {} \
         of the largest{contraction}. The bracket is strict for that last problem.",
        percent_up(run.change)
    )
}

fn raw_bracket(raw: RawBracket) -> String {
    match (raw.lower, raw.upper) {
        (Some(lower), Some(Upper::Finite(upper))) => {
            let (a, b) = bracket(lower, upper, 3);
            format!("between {a} and {b}")
        }
        (lower, upper) => {
            let low = lower.map(|l| format!("at least {}", significant(l, 6, Rounding::Down)));
            let high = upper.map(|u| match u {
                Upper::Finite(u) => format!("at most {}", significant(u, 6, Rounding::Up)),
                Upper::Unbounded(_) => "unbounded above".into(),
            });
            [low, high].into_iter().flatten().collect::<Vec<_>>().join(", ")
        }
    }
}

fn warnings(page: &mut String, data: &ReportData) {
    let of_cases = data
        .result
        .cases
        .iter()
        .flat_map(|c| c.warnings.iter().map(move |w| format!("{}: {w}", c.name)));
    let detailing = data
        .result
        .checks
        .iter()
        .filter(|c| c.topic == Topic::Detailing && c.status == Status::Warning);
    let detailing = detailing.map(|c| format!("detailing: {}", c.sentence()));
    let all: Vec<String> =
        data.result.warnings.iter().cloned().chain(detailing).chain(of_cases).collect();
    if !all.is_empty() {
        heading(page, "Warnings");
        for warning in all {
            page.push_str(&format!("- {}\n", inline(&warning)));
        }
        page.push('\n');
    }
}

fn history(page: &mut String, case: &CaseResult, symmetry: u32) {
    let part = match symmetry {
        1 => "the whole structure is meshed".to_string(),
        2 => "half of the structure is meshed".to_string(),
        4 => "a quarter of the structure is meshed".to_string(),
        n => format!("one of {n} equal parts of the structure is meshed"),
    };
    let unit = match case.quantity {
        Quantity::PotentialEnergy => " [N mm]",
        Quantity::LoadFactor => "",
    };
    let what = if is_strict(case) { "bounds" } else { "estimates" };
    paragraph(
        page,
        &format!(
            "**{}** ({}; {part}, {what} are of the whole):",
            inline(&case.name),
            analysis_word(case.analysis)
        ),
    );
    let columns = vec![
        "mesh".into(),
        "macro tets".into(),
        "mesh [s]".into(),
        format!("lower{unit}"),
        format!("upper{unit}"),
        "gap".into(),
        "peak memory [MiB]".into(),
    ];
    let rows = case.history.iter().enumerate().map(|(i, h)| {
        let (low, high) = match (h.lower, h.upper) {
            (Some(l), Some(Upper::Finite(u))) => {
                let (l, u) = bracket(l, u, 4);
                (Some(l), Some(u))
            }
            (l, u) => (
                l.map(|l| significant(l, 6, Rounding::Down)),
                u.map(|u| {
                    u.finite().map_or("unbounded".into(), |u| significant(u, 6, Rounding::Up))
                }),
            ),
        };
        vec![
            (i + 1).to_string(),
            count(Some(h.macro_tets)),
            seconds(h.mesh_seconds),
            low.unwrap_or_else(dash),
            high.unwrap_or_else(dash),
            h.gap.map_or_else(dash, percent_up),
            h.peak_memory_mib.map_or_else(dash, |m| m.to_string()),
        ]
    });
    table(page, &Table { columns, rows: rows.collect() });
    expectations(page, case);
    let columns = strings([
        "mesh",
        "program",
        "unknowns",
        "assembly [s]",
        "solution [s]",
        "in all [s]",
        "iterations",
        "peak memory [MiB]",
        "status",
    ]);
    let rows: Vec<_> =
        case.history.iter().enumerate().flat_map(|(i, h)| programs(i + 1, h)).collect();
    if !rows.is_empty() {
        table(page, &Table { columns, rows });
    }
}

/// What was expected of each further mesh, beside what came.
fn expectations(page: &mut String, case: &CaseResult) {
    let further = case.history.iter().enumerate().filter_map(|(i, h)| Some((i, h, h.predicted?)));
    let rows: Vec<Vec<String>> = further
        .map(|(i, h, p)| {
            vec![
                (i + 1).to_string(),
                count(Some(p.macro_tets)),
                count(Some(h.macro_tets)),
                percent_up(p.gap),
                h.gap.map_or_else(dash, percent_up),
                seconds(Some(p.seconds)),
                seconds(h.seconds),
            ]
        })
        .collect();
    if rows.is_empty() {
        return;
    }
    paragraph(page, "What was expected of each further mesh before it was made, and what came:");
    let columns = strings([
        "mesh",
        "tets expected",
        "tets",
        "gap expected",
        "gap",
        "expected in all [s]",
        "in all [s]",
    ]);
    table(page, &Table { columns, rows });
}

fn programs(mesh: usize, h: &HistoryRow) -> Vec<Vec<String>> {
    let row = |name: &str, unknowns: Option<usize>, run: &ProgramRun| {
        vec![
            mesh.to_string(),
            name.into(),
            count(unknowns),
            seconds(run.assembly_seconds),
            seconds(run.solve_seconds),
            seconds(Some(run.seconds)),
            run.iterations.to_string(),
            run.peak_memory_mib.map_or_else(dash, |m| m.to_string()),
            run.status.clone(),
        ]
    };
    let kinematic = h.kinematic.as_ref().map(|r| row("kinematic", h.kinematic_dofs, r));
    let static_ = h.static_.as_ref().map(|r| row("static", h.static_dofs, r));
    // its unknowns are those of the static program: friction adds none
    let smooth =
        h.static_frictionless.as_ref().map(|r| row("static, frictionless", h.static_dofs, r));
    kinematic.into_iter().chain(static_).chain(smooth).collect()
}

fn dash() -> String {
    "–".into()
}

fn count(n: Option<usize>) -> String {
    n.map_or_else(dash, |n| crate::report::figures::fixed(n as f64, 0, Rounding::Nearest))
}

fn seconds(s: Option<f64>) -> String {
    s.map_or_else(dash, |s| if s < 10.0 { format!("{s:.2}") } else { format!("{s:.1}") })
}

fn certificates(page: &mut String, data: &ReportData) {
    paragraph(
        page,
        "Residuals of the two fields, recomputed from the fields themselves by code that shares \
         nothing with the solver; all dimensionless.",
    );
    let mut rows = Vec::new();
    for case in &data.result.cases {
        let Some(certificate) = case.certificate else {
            rows.push(vec![
                case.name.clone(),
                dash(),
                dash(),
                dash(),
                dash(),
                "no certificate".into(),
            ]);
            continue;
        };
        for (name, definition, value) in certificate.residuals() {
            if let Some(value) = value {
                let pass = if value <= RESIDUAL_TOLERANCE { "pass" } else { "FAIL" };
                let tolerance = format!("{RESIDUAL_TOLERANCE:.0e}");
                rows.push(vec![
                    case.name.clone(),
                    name.into(),
                    definition.into(),
                    residual(value),
                    tolerance,
                    pass.into(),
                ]);
            }
        }
        let (value, pass) =
            if certificate.strict { ("yes", "bounds") } else { ("no", "estimates only") };
        rows.push(vec![
            case.name.clone(),
            "strict".into(),
            "all of the above".into(),
            value.into(),
            dash(),
            pass.into(),
        ]);
    }
    let columns = strings(["case", "residual", "definition", "value", "tolerance", ""]);
    table(page, &Table { columns, rows });
}

fn limits(data: &ReportData) -> Vec<String> {
    let kinds: Vec<AnalysisKind> = data.result.cases.iter().map(|c| c.analysis).collect();
    let limit = kinds.contains(&AnalysisKind::Limit);
    let model = data.model;
    let mut out = vec![
        "Small displacements: equilibrium is that of the undeformed shape. Buckling and \
         second-order effects are not covered."
            .to_string(),
        "The bounds hold for the mechanical model: bodies, materials, supports and loads as \
         listed above. They say nothing about how well the model stands for the building."
            .to_string(),
        "What is bracketed is the quantity named in the answer. Local values (stresses, \
         pressures, displacements of a point) come without a guarantee."
            .to_string(),
    ];
    if kinds.contains(&AnalysisKind::Elastic) {
        out.push("Elastic analysis: no part yields, whatever its stress.".into());
    }
    if kinds.contains(&AnalysisKind::Elastoplastic) {
        out.push(
            "Elastic, perfectly plastic analysis (Hencky): all loads grow together from zero and \
             nothing that has yielded unloads; no hardening, no strain limit."
                .into(),
        );
    }
    if limit {
        out.push(
            "Limit analysis: rigid, perfectly plastic material with enough ductility to \
             redistribute; no strain limit is checked."
                .into(),
        );
        if model.preload || model.initial_gap {
            out.push(
                "In limit analysis preload drops out and contacts with an initial gap count as \
                 closed."
                    .into(),
            );
        }
    }
    if model.friction {
        out.push(
            "Associated friction lets sliding faces lift off each other (slip dilates). The \
             collapse load of the same joint with Coulomb friction is at least that without \
             friction and at most that with associated friction: a lower bound with associated \
             friction is not safe for a Coulomb structure, the frictionless lower bound is."
                .into(),
        );
        if model.coulomb
            && data.result.cases.iter().any(|c| c.problem == FrictionModel::ShiftedCones)
        {
            out.push(
                "Coulomb friction is reached by a fixed point over problems with shifted cones. \
                 The bounds are strict for the last of these problems; they are not bounds of \
                 Coulomb's."
                    .into(),
            );
        }
    }
    if model.preload && kinds.contains(&AnalysisKind::Elastic) {
        out.push(
            "Preload: the bolts are tightened first, under the dead loads alone; then the \
             closures of their cuts stay. The bounds are strict for the structure with these \
             closures, and they bracket its energy only."
                .into(),
        );
    }
    if model.facets {
        out.push(
            "Holes, shanks and fillets are meshed as flat facets. The meshed body is the body for \
             both programs, so the bracket is strict for it; the difference between facets and \
             true curves is not part of the gap."
                .into(),
        );
    }
    if model.symmetry {
        out.push(
            "Geometry, supports and loads are symmetric about the planes used; a solution is \
             taken to be so too."
                .into(),
        );
    }
    out.extend(data.assumptions.iter().cloned());
    out
}
