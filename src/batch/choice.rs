//! The choice of a sweep: in each group of joints the one of least cost that holds.
//!
//! The checks of the code leave some joints as candidates. From the cheapest upward each is
//! accepted by its checks or analysed, until one holds; the dearer ones are not meshed.

use super::dimension::words;
use super::expansion::{Expansion, typed};
use super::plan::{Header, Plan};
use super::row::{Outcome, Record};
use super::screen::Kit;
use super::sweep::Choose;
use bracket_base::diag::{Diagnostic, did_you_mean};
use bracket_base::units::Dim;
use bracket_joint::assembly::names;
use bracket_joint::assembly::scope::Scope;
use bracket_joint::spec::expr::{Expr, ExprError, Value};
use std::collections::{BTreeSet, HashMap};

/// Names of [`Choose::least`] that come from the record of a case.
const MASS: &str = "mass";
/// See [`MASS`].
const BOLTS: &str = "bolts";

/// Joints of which one is chosen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Group {
    /// The values that its joints share, or the name of the row of the table.
    pub name: String,
    /// Their positions in the plan; none if `where` drops all of them.
    pub cases: Vec<usize>,
}

/// What decides whether a joint holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decider {
    /// Its checks accept it.
    Checks,
    /// Its limit analysis.
    Analysis,
    /// Nothing: the checks leave it undecided, and no analysis follows, or its cost is not known.
    Nothing,
}

/// A joint that may hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Position in the plan.
    pub case: usize,
    /// Its cost; infinite if it is not known.
    pub cost: f64,
    /// What decides.
    pub decider: Decider,
}

/// The groups of a plan, in the order of the sweep; those that `where` emptied are among them.
pub fn groups(plan: &Plan, choose: &Choose) -> Vec<Group> {
    let expansion = &plan.header.expansion;
    let of = dimensions(expansion, choose);
    let mut out: Vec<Group> = Vec::new();
    let mut known: HashMap<Vec<String>, usize> = HashMap::new();
    let mut names: HashMap<String, u32> = HashMap::new();
    let mut add = |positions: &[usize], out: &mut Vec<Group>| {
        let (key, name) = key(expansion, choose, positions);
        *known.entry(key).or_insert_with(|| {
            let n = names.entry(name.clone()).or_default();
            *n += 1;
            let name = if *n > 1 { format!("{name} ({n})") } else { name };
            out.push(Group { name, cases: Vec::new() });
            out.len() - 1
        })
    };
    // every combination of the dimensions that form groups, the last of them fastest
    let mut positions = vec![0; expansion.dimensions.len()];
    loop {
        add(&positions, &mut out);
        let next = of.iter().rev().find(|d| {
            positions[**d] += 1;
            let more = positions[**d] < expansion.dimensions[**d].steps.len();
            if !more {
                positions[**d] = 0;
            }
            more
        });
        if next.is_none() {
            break;
        }
    }
    for (i, case) in plan.cases.iter().enumerate() {
        let at = add(&expansion.positions(case.index), &mut out);
        out[at].cases.push(i);
    }
    out
}

/// The dimensions that form groups.
fn dimensions(expansion: &Expansion, choose: &Choose) -> Vec<usize> {
    let forms = |d: &usize| match &choose.per {
        Some(paths) => {
            expansion.dimensions[*d].paths.iter().any(|p| paths.iter().any(|q| q == p.text()))
        }
        None => expansion.dimensions[*d].table,
    };
    (0..expansion.dimensions.len()).filter(forms).collect()
}

/// What the joints of a group share, and its name.
fn key(expansion: &Expansion, choose: &Choose, positions: &[usize]) -> (Vec<String>, String) {
    match &choose.per {
        Some(paths) => {
            let value = |path: &String| {
                let mut all = expansion.dimensions.iter().zip(positions);
                all.find_map(|(d, step)| {
                    let i = d.paths.iter().position(|p| p.text() == path)?;
                    let value = d.steps[*step].values[i].as_ref();
                    Some(value.or_else(|| d.paths[i].get(&expansion.base)).map(words))
                })
            };
            let key: Vec<String> =
                paths.iter().map(|p| value(p).flatten().unwrap_or_default()).collect();
            let name = key.join(" ");
            (key, name)
        }
        None => match expansion.dimensions.iter().position(|d| d.table) {
            Some(table) => {
                let row = positions[table];
                (vec![row.to_string()], expansion.dimensions[table].steps[row].name())
            }
            None => (Vec::new(), "all joints".into()),
        },
    }
}

/// The joints of a group that may hold, the cheapest first; equal costs keep the order of the plan.
/// `checked` holds the records of the checks by position in the plan; a case without one is left
/// out.
pub fn candidates(
    group: &Group,
    plan: &Plan,
    kit: &Kit,
    choose: &Choose,
    checked: &[Option<Record>],
) -> Vec<Candidate> {
    let mut out = Vec::new();
    for &case in &group.cases {
        let Some(record) = &checked[case] else { continue };
        let decider = match record.outcome {
            Outcome::BadInput => continue,
            _ if plan.header.wants(record) => Decider::Analysis,
            Outcome::Ok => Decider::Checks,
            Outcome::NotOk => continue,
            _ => Decider::Nothing,
        };
        let index = plan.cases[case].index;
        out.push(match cost(&choose.least, index, &plan.header, kit, record) {
            Some(cost) => Candidate { case, cost, decider },
            None => Candidate { case, cost: f64::INFINITY, decider: Decider::Nothing },
        });
    }
    // a stable sort
    out.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    out
}

/// True if a cost needs names of the template.
fn uses_template(least: &Expr) -> bool {
    least.names().into_iter().any(|n| n != MASS && n != BOLTS)
}

/// The names of a combination in its template.
fn scope(index: u64, header: &Header, kit: &Kit) -> Option<Scope> {
    let spec = typed(&kit.spec(&header.expansion, index).ok()?, &kit.file).ok()?;
    names(&spec, kit.template(&spec).ok()?, &kit.catalog).ok()
}

fn evaluate(
    least: &Expr,
    mass: Option<f64>,
    bolts: Option<u32>,
    scope: Option<&Scope>,
) -> Result<f64, ExprError> {
    let unknown = |what: &str| format!("{what} of this joint is not known");
    let mut lookup = |name: &str| match (name, scope) {
        (MASS, _) => mass.map(Value::number).ok_or_else(|| unknown("the mass")),
        (BOLTS, _) => {
            bolts.map(|n| Value::number(n.into())).ok_or_else(|| unknown("the number of bolts"))
        }
        (_, Some(scope)) => scope.get(name).map_err(|e| match did_you_mean(name, [MASS, BOLTS]) {
            hint if hint.is_empty() => e,
            hint => format!("unknown name `{name}`{hint}"),
        }),
        (_, None) => Err(format!("unknown name `{name}`")),
    };
    least.eval_as(Dim::NONE, &mut lookup)
}

/// The cost of a case; `None` if it is not known: bolts longer than stocked have no mass, and an
/// expression may have no value for some joints.
fn cost(least: &Expr, index: u64, header: &Header, kit: &Kit, record: &Record) -> Option<f64> {
    let scope = if uses_template(least) { Some(scope(index, header, kit)?) } else { None };
    evaluate(least, record.mass, record.bolts, scope.as_ref()).ok().filter(|c| c.is_finite())
}

/// Refuses groups that mix loads: a joint would be chosen for the smallest of them.
fn one_load_each(plan: &Plan, choose: &Choose) -> Result<(), Box<Diagnostic>> {
    let expansion = &plan.header.expansion;
    let loads = |i: &usize| {
        expansion.dimensions[*i].paths.iter().find(|p| p.text().starts_with("loads")).cloned()
    };
    let all: Vec<usize> = (0..expansion.dimensions.len()).collect();
    let with_loads: Vec<_> = all.iter().filter_map(|i| Some((*i, loads(i)?))).collect();
    for group in groups(plan, choose) {
        let positions = |i: usize| {
            let of = |c: &usize| expansion.positions(plan.cases[*c].index)[i];
            group.cases.iter().map(of).collect::<BTreeSet<_>>()
        };
        if let Some((_, path)) = with_loads.iter().find(|(i, _)| positions(*i).len() > 1) {
            let message = format!(
                "the group `{}` of `choose` has joints with different loads: `{path}` varies in it",
                group.name
            );
            let help = "a joint would be chosen for the smallest load: add the path to \
                        `choose.per`, leave `per` out, or give all loads of a joint as load cases";
            return Err(Box::new(Diagnostic::input("sweep/choose", message).help(help)));
        }
    }
    Ok(())
}

/// Refuses a cost with a name or a dimension that does not fit a template of the sweep, or with the
/// mass of a template that has no list of parts.
pub fn check(plan: &Plan, kit: &Kit, choose: &Choose) -> Result<(), Box<Diagnostic>> {
    one_load_each(plan, choose)?;
    if choose.least.names().is_empty() {
        let message = format!("`choose.least` is `{}`, the same for all", choose.least.text());
        let help = "write `mass`, `bolts` or an expression of them";
        return Err(Box::new(Diagnostic::input("sweep/choose", message).help(help)));
    }
    let header = &plan.header;
    let mut open: BTreeSet<&str> = kit.templates.keys().map(String::as_str).collect();
    for case in &plan.cases {
        let spec = kit.spec(&header.expansion, case.index);
        let Ok(spec) = spec.and_then(|s| typed(&s, &kit.file)) else { continue };
        if !open.contains(spec.template.as_str()) {
            continue;
        }
        let Some(scope) = scope(case.index, header, kit) else { continue };
        let template = spec.template.clone();
        // whether the template has parts does not depend on the values of a case that builds
        let Ok((joint, _)) = kit.joint(spec) else { continue };
        open.remove(template.as_str());
        let refuse = |message: String, help: &str| {
            let message = format!("`choose.least`, template `{template}`: {message}");
            Err(Box::new(Diagnostic::input("sweep/choose", message).help(help)))
        };
        if joint.facts.is_none() && choose.least.names().contains(&MASS) {
            let help = "write `bolts`, or an expression of the names of the template";
            return refuse("it has no list of parts, so its mass is not known".into(), help);
        }
        if let Err(e) = evaluate(&choose.least, Some(10.5), Some(7), Some(&scope)) {
            let help = "a cost is a number of `mass` (kg), `bolts` and the names of the template; \
                        a length becomes a number by division: `plate.thickness / 1 mm`";
            return refuse(e.to_string(), help);
        }
        if open.is_empty() {
            break;
        }
    }
    Ok(())
}

/// A remark where the mass leaves out what the sweep varies.
pub fn remark(plan: &Plan, choose: &Choose) -> Option<String> {
    let paths = plan.header.expansion.paths();
    let left_out = |p: &&str| p.contains("doubler") || p.contains("rib");
    let path = paths.into_iter().find(left_out)?;
    choose.least.names().contains(&MASS).then(|| {
        format!(
            "`mass` leaves out supplementary web plates and ribs, and `{path}` varies: add their \
             cost to `choose.least`"
        )
    })
}

/// What became of a group.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// The group.
    pub group: String,
    /// Number of its joints.
    pub joints: usize,
    /// Those that may hold, the cheapest first.
    pub candidates: Vec<Candidate>,
    /// Position of the chosen one among the candidates.
    pub chosen: Option<usize>,
    /// Candidates that are cheaper than the chosen one and neither hold nor fail for certain.
    pub undecided: usize,
    /// Joints whose input is wrong: nothing is known of them.
    pub wrong: usize,
    /// Candidates that were analysed.
    pub analysed: usize,
    /// Whether a candidate still waits for its checks or its analysis.
    pub open: bool,
}

impl Decision {
    /// Decides a group. `checked` and `analysed` hold the records by position in the plan.
    pub fn new(
        group: &Group,
        candidates: Vec<Candidate>,
        checked: &[Option<Record>],
        analysed: &[Option<Record>],
    ) -> Self {
        let of = |outcome| {
            let is = |i: &&usize| checked[**i].as_ref().is_some_and(|r| r.outcome == outcome);
            group.cases.iter().filter(is).count()
        };
        let by_analysis =
            |c: &&Candidate| c.decider == Decider::Analysis && analysed[c.case].is_some();
        let mut out = Self {
            group: group.name.clone(),
            joints: group.cases.len(),
            wrong: of(Outcome::BadInput),
            analysed: candidates.iter().filter(by_analysis).count(),
            candidates,
            chosen: None,
            undecided: 0,
            open: group.cases.iter().any(|&i| checked[i].is_none()),
        };
        if out.open {
            return out;
        }
        for (i, c) in out.candidates.iter().enumerate() {
            let outcome = match c.decider {
                Decider::Checks => Some(Outcome::Ok),
                Decider::Analysis => analysed[c.case].as_ref().map(|r| r.outcome),
                Decider::Nothing => Some(Outcome::Undecided),
            };
            match outcome {
                Some(Outcome::Ok) => {
                    out.chosen = Some(i);
                    break;
                }
                Some(Outcome::NotOk) => {}
                Some(_) => out.undecided += 1,
                None => {
                    out.open = true;
                    break;
                }
            }
        }
        out
    }

    /// The chosen candidate.
    pub fn choice(&self) -> Option<Candidate> {
        self.chosen.map(|i| self.candidates[i])
    }

    /// The candidates behind the chosen one: none of them needs an analysis.
    pub fn dearer(&self) -> &[Candidate] {
        self.chosen.map_or(&[], |i| &self.candidates[i + 1..])
    }

    /// The outcome of the group: ok if one is chosen, not ok if no joint of it holds for certain.
    pub fn outcome(&self) -> Outcome {
        match self.chosen {
            Some(_) => Outcome::Ok,
            None if self.open || self.undecided + self.wrong > 0 => Outcome::Undecided,
            None => Outcome::NotOk,
        }
    }
}
