//! The hand checks on the page: one table a topic, with the numbers of every formula.

use crate::checks::{Check, Status, Topic};
use crate::report::figures::{Rounding, significant};
use crate::report::markdown::markup::{heading, inline, paragraph, strings, table};
use crate::report::markdown::page::Table;

/// Under the verdict: what failed, and what the code leaves undecided.
pub(crate) fn failed(page: &mut String, checks: &[Check]) {
    for (status, one, many) in [
        (Status::Failed, "A check fails", "Checks fail"),
        (
            Status::Undecided,
            "One check cannot be made by the code",
            "These checks cannot be made by the code",
        ),
    ] {
        let found: Vec<&Check> = checks.iter().filter(|c| c.status == status).collect();
        if found.is_empty() {
            continue;
        }
        paragraph(page, &format!("**{}**:", if found.len() == 1 { one } else { many }));
        for c in found {
            page.push_str(&format!("- {}\n", inline(&c.sentence())));
        }
        page.push('\n');
    }
}

/// The hand checks, below the input.
pub(crate) fn checks(page: &mut String, checks: &[Check]) {
    if checks.is_empty() {
        return;
    }
    heading(page, "Hand checks");
    for (topic, title, words) in TOPICS {
        let mine: Vec<&Check> = checks.iter().filter(|c| c.topic == topic).collect();
        if mine.is_empty() {
            continue;
        }
        paragraph(page, &format!("**{title}.** {words}"));
        let decided = mine.iter().any(|c| c.utilisation.is_some());
        let rows = mine.iter().map(|c| {
            let case = c.case.as_ref().map_or(String::new(), |case| format!("{case}, "));
            let mut row =
                vec![format!("{case}{}", c.subject), c.title.clone(), formula(c), c.clause.clone()];
            if decided {
                let used =
                    c.utilisation.map_or_else(|| "–".into(), |u| significant(u, 3, Rounding::Up));
                row.extend([used, status(c.status).into()]);
            }
            row
        });
        let mut columns = strings(["of", "check", "numbers", "clause"]);
        if decided {
            columns.extend(strings(["utilisation", "status"]));
        }
        table(page, &Table { columns, rows: rows.collect() });
    }
}

const TOPICS: [(Topic, &str, &str); 8] = [
    (
        Topic::Detailing,
        "Detailing",
        "Least distances decide the verdict. Greatest distances bind exposed or compressed steel \
         alone, room for tools and washers is practice: passing them is a warning.",
    ),
    (
        Topic::Bolts,
        "Bolts",
        "Resistances of one bolt; below them what the actions of the load cases ask, which \
         decides the verdict. A row carries the part of its resistance that the joint uses of its \
         own (component method), prying included; shear goes to the bolts by what tension leaves \
         of them, 1 − F_t,Ed/(1.4 F_t,Rd), so that bolts without tension carry most of it.",
    ),
    (
        Topic::Welds,
        "Welds",
        "Beam and end plate are tied where the weld has no throat, as by a butt weld; fillet \
         welds on both sides need these throats to be as strong. Welds with a throat have its \
         strength in limit analysis; here, those of the flanges take moment and axial force, \
         those of the web the shear force and beside the rows in tension the rows' forces too; \
         and none may be weaker than the joint (6.2.3(4)).",
    ),
    (
        Topic::Member,
        "Beam and stiffeners at the joint",
        "The beam's cross-section under the actions at the joint (EN 1993-1-1 6.2) and the \
         column's stiffeners on what is left of them at the root. They decide the verdict: \
         neither the local buckling of the beam nor the cut is in the mesh.",
    ),
    (
        Topic::ComponentMethod,
        "Component method",
        "For both senses of bending; rows count from the tension side. Every T-stub follows Table \
         6.2. Of a load case, strength by this method decides where no limit analysis does; where \
         one decides and nothing may buckle, a demand above its resistance is a warning.",
    ),
    (
        Topic::Stability,
        "Stability",
        "What may buckle before it yields. Limit analysis does not see it, so that these checks \
         and the component method decide beside any bracket; where the code gives no resistance, \
         the verdict is at most UNDECIDED.",
    ),
    (
        Topic::Stiffness,
        "Stiffness",
        "Information; the class needs the system length of the beam and the kind of frame.",
    ),
    (
        Topic::Ductility,
        "Rotation capacity",
        "Limit analysis takes every part to yield as long as it must. Where no rule holds, bolts \
         may break before the rows have yielded, and the verdict is at most UNDECIDED.",
    ),
];

fn formula(c: &Check) -> String {
    let values = c.values.iter().map(|s| format!("{} = {}", s.symbol, s.unit.show(s.value)));
    let values: Vec<String> = values.collect();
    if values.is_empty() {
        c.formula.clone()
    } else {
        format!("{}; {}", c.formula, values.join(", "))
    }
}

fn status(status: Status) -> &'static str {
    match status {
        Status::Ok => "OK",
        Status::Failed => "**FAILED**",
        Status::Undecided => "**UNDECIDED**",
        Status::Warning => "warning",
        Status::Information => "information",
    }
}
