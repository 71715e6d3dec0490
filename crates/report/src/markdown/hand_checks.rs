//! The hand checks in the report: one table per topic, with the numbers of every formula.

use crate::document::Doc;
use crate::document::table::{Table, bold, cells};
use crate::summary::{EXCEEDED, used_words};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::{Binding, Check, Status, Step, Topic};

/// The lines below the verdict: the checks that failed, and those that the code leaves undecided.
pub(crate) fn failed(doc: &mut Doc, checks: &[Check]) {
    for (status, one, many) in [
        (Status::Failed, "A check fails", "Checks fail"),
        (
            Status::Undecided,
            "The code does not decide one check",
            "The code does not decide these checks",
        ),
    ] {
        let found: Vec<&Check> = checks.iter().filter(|c| c.status == status).collect();
        if found.is_empty() {
            continue;
        }
        doc.paragraph(say!("**{}**:", if found.len() == 1 { one } else { many }));
        doc.list(each_once(&found).into_iter().map(|(c, cases)| match cases {
            1 => c.sentence(),
            _ => say!("{}; the worst of {} cases", c.sentence(), cases),
        }));
    }
}

/// Checks that differ in nothing but their load case are one, the worst of them, with the number of
/// cases.
fn each_once<'a>(checks: &[&'a Check]) -> Vec<(&'a Check, usize)> {
    let used = |c: &Check| c.utilisation.unwrap_or(f64::INFINITY);
    let mut out: Vec<(&Check, Vec<&Option<String>>)> = Vec::new();
    for &c in checks {
        let same =
            |o: &Check| (&o.title, &o.subject, &o.clause) == (&c.title, &c.subject, &c.clause);
        match out.iter_mut().find(|(o, _)| same(o)) {
            Some((worst, cases)) => {
                if used(c) > used(worst) {
                    *worst = c;
                }
                if !cases.contains(&&c.case) {
                    cases.push(&c.case);
                }
            }
            None => out.push((c, vec![&c.case])),
        }
    }
    out.into_iter().map(|(c, cases)| (c, cases.len())).collect()
}

/// The section of hand checks, below the input.
pub(crate) fn checks(doc: &mut Doc, checks: &[Check]) {
    if checks.is_empty() {
        return;
    }
    doc.heading("Hand checks");
    for (topic, title, words) in TOPICS {
        let mine: Vec<&Check> = checks.iter().filter(|c| c.topic == topic).collect();
        if mine.is_empty() {
            continue;
        }
        doc.paragraph(say!("**{}.** {}", title, words));
        let decided = mine.iter().any(|c| c.utilisation.is_some());
        let rows = mine.iter().map(|c| {
            let mut row = cells![place(c), c.title.text(), formula(c), c.clause.clone()];
            if decided {
                let used = used_words(c);
                let word = status(c);
                let stands_out = matches!(c.status, Status::Failed | Status::Undecided);
                row.extend(cells![used, if stands_out { bold(word) } else { word.into() }]);
            }
            row
        });
        let mut columns = Table::columns(["case, part", "check", "numbers", "clause"]);
        if decided {
            columns.extend(Table::columns(["utilisation", "status"]));
        }
        doc.table(&Table { columns, rows: rows.collect() });
    }
}

/// The topics in the order of the report, each with its title and what a reader must know of it.
pub(crate) const TOPICS: [(Topic, &str, &str); 8] = [
    (
        Topic::Detailing,
        "Detailing",
        "Minimum distances decide the verdict. Maximum distances apply only to exposed or \
         compressed steel, and clearance for tools and washers is a matter of practice: a \
         violation of these is a warning.",
    ),
    (
        Topic::Bolts,
        "Bolts",
        "First the resistances of one bolt, then the demands of the load cases, which decide the \
         verdict. Of an end plate, the tension in a row is its resistance by the component \
         method, prying included, times the utilisation of the joint; shear is shared in \
         proportion to what tension leaves, 1 − F_t,Ed/(1.4 F_t,Rd), so that bolts without \
         tension carry most of it.",
    ),
    (
        Topic::Welds,
        "Welds",
        "Where a weld has no throat, the parts are tied as by a butt weld; fillet welds on both \
         sides need the throats listed here to be as strong. Where a weld has a throat, limit \
         analysis counts with its strength. In the checks the flange welds carry moment and axial \
         force; the web welds carry the shear force and, beside the rows of an end plate in \
         tension, the forces of these rows as well. No weld may be weaker than the joint \
         (6.2.3(4)).",
    ),
    (
        Topic::Member,
        "Member and stiffeners at the joint",
        "The cross-section of the member under the actions at the joint (EN 1993-1-1 6.2), and \
         the column stiffeners of a beam joint with the section that the cut at the root leaves. \
         They decide the verdict, because the mesh contains neither local buckling of the member \
         nor that cut.",
    ),
    (
        Topic::ComponentMethod,
        "Component method",
        "The strength by this method decides a load case that no limit analysis decides. Where a \
         limit analysis decides and no part can buckle, a demand above this resistance is a \
         warning. The rows of an end plate are counted from the tension side, for both senses of \
         bending; every T-stub follows Table 6.2.",
    ),
    (
        Topic::Stability,
        "Stability",
        "Parts that may buckle before they yield. Limit analysis does not cover buckling, so \
         these checks and the component method decide beside any bracket. Where the code gives no \
         resistance, the verdict is at most UNDECIDED.",
    ),
    (
        Topic::Stiffness,
        "Stiffness",
        "For information. The class depends on the system length of the member and on the kind of \
         frame.",
    ),
    (
        Topic::Ductility,
        "Rotation capacity",
        "Limit analysis assumes that every part can deform plastically as far as needed. Where no \
         rule of the code ensures this, bolts may break before the rows have yielded: the lower \
         bound alone then decides nothing, and plastic global analysis may not rely on the \
         rotation of the joint (6.4). The component method needs no such rule.",
    ),
];

/// An intermediate value with its symbol.
pub(crate) fn value_of(step: &Step) -> Text {
    say!("{} = {}", &step.symbol, step.unit.show(step.value))
}

fn formula(c: &Check) -> Text {
    let values = Text::joined(", ", c.values.iter().map(value_of));
    Text::joined("; ", [c.derivation.text(), values])
}

/// Load case and part of a check.
pub(crate) fn place(c: &Check) -> Text {
    Text::joined(", ", [c.case.as_ref().map(Text::given).unwrap_or_default(), c.subject.text()])
}

/// The status of a check in words, the same as in the summary.
pub(crate) fn status(check: &Check) -> &'static str {
    match check.status {
        Status::Ok => "OK",
        Status::Failed => "FAILED",
        Status::Undecided => "UNDECIDED",
        Status::Warning if check.binding == Binding::Strength => EXCEEDED,
        Status::Warning => "warning",
        Status::Information => "information",
    }
}
