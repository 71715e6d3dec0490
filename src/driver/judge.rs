//! Judges what a run has solved: utilisations, demands, checks and verdict, from the result and the
//! hand checks alone.

use crate::driver::solved::{Models, Solved};
use bracket_base::diag::ExitStatus;
use bracket_base::words::Text;
use bracket_codes::route::{self, Found, RouteFacts};
use bracket_codes::verdict::{self, Verdict};
use bracket_codes::{self as codes, Analysed, HandChecks, Judgement};
use bracket_engine::model::AnalysisKind;
use bracket_report::markdown::report_data::GivenActions;
use bracket_report::result::demand::Demand;
use bracket_report::result::judged_case::JudgedCase;
use bracket_report::result::result_file::{CaseResult, HistoryRow, Quantity, ResultFile};
use bracket_report::result::stiffness::joint_stiffness;

/// A solved run with its verdict.
pub struct Judged {
    /// The result with its verdict.
    pub result: ResultFile,
    /// The models of the cases.
    pub models: Models,
}

impl Solved {
    /// Judges the run by its bounds and by the hand checks of its joint. `demands`: the load cases
    /// that the joint must carry.
    pub fn judge(
        self,
        checks: &HandChecks,
        facts: Option<&RouteFacts>,
        demands: &[GivenActions],
    ) -> Judged {
        Judged { result: judged(self.result, checks, facts, demands), models: self.models }
    }
}

impl Judged {
    /// The exit status for the verdict. Without a demand it states whether all analyses are
    /// certified.
    pub fn status(&self) -> ExitStatus {
        let result = &self.result;
        let complete = result.asked.is_empty() || result.cases.len() == result.asked.len();
        match result.verdict {
            Verdict::NotOk => ExitStatus::NotOk,
            Verdict::Undecided => ExitStatus::Undecided,
            Verdict::Ok => ExitStatus::Ok,
            Verdict::None if complete && result.cases.iter().all(certified) => ExitStatus::Ok,
            Verdict::None => ExitStatus::Undecided,
        }
    }
}

/// True if every program that ran gave its bound on some mesh, with a strict certificate, and there
/// is at least one bound.
fn certified(c: &CaseResult) -> bool {
    let ran = |program: fn(&HistoryRow) -> bool| c.history.iter().any(program);
    let given = |ran: bool, bound: bool| bound || !ran;
    c.certificate.is_some_and(|x| x.strict)
        && (c.upper.is_some() || c.lower.is_some())
        && given(ran(|h| h.kinematic.is_some()), c.upper.is_some())
        && given(ran(|h| h.static_.is_some()), c.lower.is_some())
}

/// The result with what follows from its bounds and the hand checks. Of each case: utilisation,
/// demand and joint stiffness; of the whole: checks and verdict.
pub fn judged(
    mut result: ResultFile,
    checks: &HandChecks,
    facts: Option<&RouteFacts>,
    demands: &[GivenActions],
) -> ResultFile {
    for case in &mut result.cases {
        case.utilisation = safe_utilisation(case);
        let demand = demands.iter().find(|d| d.case == case.name);
        case.demand = demand.map(|d| Demand::new(case, d.actions.clone(), checks));
        // the other load cases of a run tell it once
        if no_rule(case) && case.proved_by.is_none() {
            case.warnings.push(
                "no rule of rotation capacity holds: the lower bound alone decides nothing, and \
                 plastic global analysis may not rely on the rotation of the joint (EN \
                 1993-1-8:2005 6.4)"
                    .into(),
            );
        }
        case.joint_stiffness = joint_stiffness(case, checks.moments());
    }
    if checks.brittle.is_some() && !demands.is_empty() && !result.cases.iter().any(no_rule) {
        let warning = Text::from(
            "no rule of rotation capacity holds: plastic global analysis may not rely on the \
             rotation of the joint (EN 1993-1-8:2005 6.4)",
        );
        if !result.warnings.contains(&warning) {
            result.warnings.push(warning);
        }
    }
    // the findings of the analyses complete them
    let mut checks = checks.clone();
    let of_case = |case: &String| analysed(&result, facts, case);
    let analysed: Vec<Analysed> = demanded(demands, &result.asked).iter().map(of_case).collect();
    if analysed.is_empty() {
        result.verdict = if checks.failed() { Verdict::NotOk } else { Verdict::None };
        result.judgement = None;
    } else {
        let (judgement, each) = codes::judge(&mut checks, &analysed);
        for (a, j) in analysed.iter().zip(&each) {
            let demands = result
                .cases
                .iter_mut()
                .filter(|c| c.name == a.case)
                .filter_map(|c| c.demand.as_mut());
            demands.for_each(|d| d.judged(j));
        }
        if each.len() > 1 {
            let pairs = analysed.iter().zip(each);
            let case = |(a, judgement): (&Analysed, Judgement)| JudgedCase {
                case: a.case.clone(),
                by_bounds: a.utilisation,
                judgement,
            };
            result.load_cases = pairs.map(case).collect();
        }
        result.verdict = judgement.verdict;
        result.judgement = Some(judgement);
    }
    result.component_method = checks.methods().cloned().collect();
    result.checks = checks.checks;
    result.neglected = checks.neglected;
    result
}

/// Demand over capacity by the strict bounds of a load factor.
pub fn safe_utilisation(entry: &CaseResult) -> Option<[f64; 2]> {
    if entry.quantity != Quantity::LoadFactor {
        return None;
    }
    let (lower, upper) = entry.safe_bounds();
    verdict::utilisation(lower, upper)
}

/// True where the lower bound of a case decides nothing because no rule of rotation capacity holds.
fn no_rule(case: &CaseResult) -> bool {
    case.demand.as_ref().is_some_and(|d| d.brittle.is_some())
}

/// What the analyses found of a load case. Only limit analysis brackets a resistance.
fn analysed(result: &ResultFile, facts: Option<&RouteFacts>, case: &String) -> Analysed {
    let entries = || result.cases.iter().filter(|c| c.name == *case);
    let limit = entries().find(|c| c.analysis == AnalysisKind::Limit);
    let verdict = limit.and_then(|c| c.demand.as_ref()).map_or(Verdict::None, |d| d.by_analysis);
    let asked = result.asked.iter().filter(|a| *a == case).count();
    let missing = match limit {
        Some(c) => c.lacking().filter(|_| verdict == Verdict::Undecided),
        None => (entries().count() < asked).then(|| "its analysis was not run".into()),
    };
    // only the absence of a rule keeps a lower bound above the load from deciding
    let carried = |c: &CaseResult| c.is_strict() && c.factor_bounds().0 >= Some(1.0);
    let brittle = limit.is_some_and(|c| carried(c) && no_rule(c));
    // only limit analysis can carry the loads by a proof; estimates alone are no route
    let steps = limit.zip(facts).map_or_else(Vec::new, |(c, facts)| {
        let measured = entries().find(|c| c.evidence.is_some());
        let meshes = measured.map_or_else(Vec::new, CaseResult::evidence_of_meshes);
        let critical = measured.and_then(|c| c.critical.as_ref());
        let critical_unknown = measured.and_then(|c| c.critical_unknown.as_ref());
        let (lower, copies) = (c.factor_bounds().0, result.symmetry as usize);
        route::steps(facts, Found { lower, copies, meshes: &meshes, critical, critical_unknown })
    });
    Analysed {
        case: case.clone(),
        verdict,
        utilisation: limit.and_then(|c| c.utilisation),
        brittle,
        no_rule: limit.is_some_and(no_rule),
        missing,
        steps,
    }
}

/// The load cases with a demand. If there are analyses, the cases are in the order of the analyses;
/// those in which nothing acts have none and stand behind.
fn demanded(demands: &[GivenActions], asked: &[String]) -> Vec<String> {
    let demanded = demands.iter().map(|d| &d.case);
    if asked.is_empty() {
        return demanded.cloned().collect();
    }
    let mut out: Vec<String> = Vec::new();
    for case in asked.iter().filter(|a| demanded.clone().any(|d| d == *a)) {
        if !out.contains(case) {
            out.push(case.clone());
        }
    }
    out.extend(demanded.filter(|d| !asked.contains(d)).cloned());
    out
}

/// The verdict by code alone, of all demands and of each, as if nothing were analysed.
pub fn by_code(checks: &mut HandChecks, demands: &[GivenActions]) -> (Judgement, Vec<Judgement>) {
    let alone: Vec<Analysed> = demands.iter().map(|d| Analysed::not(d.case.clone())).collect();
    codes::judge(checks, &alone)
}
