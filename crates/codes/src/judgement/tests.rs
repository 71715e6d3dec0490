use super::*;
use crate::Worked;
use crate::formula::Traced;
use crate::route::{RouteStep, StepId, StepState};
use crate::subject::Part;
use crate::{CheckId, Topic, Unit};
use bracket_base::words::Text;

fn check(topic: Topic, value: f64, case: Option<&str>) -> Check {
    let c = Worked::of("6.2", CheckId::MomentAndAxial, "u", Traced::from(value), Unit::Number);
    let mut c = c.utilised(topic, Part::BoltRows, Status::Failed);
    if topic == Topic::ComponentMethod {
        c = c.of_strength();
    }
    Check { case: case.map(Into::into), ..c }
}

fn hand(checks: &[Check], unstable: &[&str]) -> HandChecks {
    let unstable = unstable.iter().map(|s| s.to_string()).collect();
    HandChecks { checks: checks.to_vec(), unstable, ..HandChecks::default() }
}

fn verdicts(checks: &[Check], unstable: &[&str], analysis: Verdict) -> [Verdict; 3] {
    let mut h = hand(checks, unstable);
    let a = Analysed { verdict: analysis, ..Analysed::not("A") };
    let (j, _) = judge(&mut h, &[a]);
    [j.verdict, j.by_code, j.by_analysis]
}

use Verdict::{None as Nothing, NotOk, Ok as Fine, Undecided};

/// Strength by the component method decides where no limit analysis decides. Where it holds, the
/// code's route is complete, and bounds that do not decide change nothing.
#[test]
fn the_component_method_decides_where_no_bracket_does() {
    let over = [check(Topic::ComponentMethod, 1.2, Some("A")), check(Topic::Bolts, 0.9, Some("A"))];
    assert_eq!(verdicts(&over, &[], Nothing), [NotOk, NotOk, Nothing]);
    assert_eq!(verdicts(&over, &[], Undecided), [NotOk, NotOk, Undecided]);
    assert_eq!(
        verdicts(&over, &[], Fine),
        [Fine, Fine, Fine],
        "information beside a bracket that decides"
    );
    assert_eq!(verdicts(&over, &[], NotOk), [NotOk, Fine, NotOk]);
    assert_eq!(verdicts(&over[1..], &[], Nothing), [Fine, Fine, Nothing]);
    assert_eq!(verdicts(&over[1..], &[], Undecided), [Fine, Fine, Undecided]);
    assert_eq!(verdicts(&over[1..], &[], NotOk), [NotOk, Fine, NotOk]);
}

/// The judgement on the case `A`.
fn judged(checks: &[Check], a: Analysed) -> Judgement {
    judge(&mut hand(checks, &[]), &[a]).0
}

/// The route is the code's where its checks hold, the component method included; the bounds' where
/// they stand in for the component method or where the code has no checks.
#[test]
fn the_route_is_the_one_that_is_complete() {
    let method = |used| check(Topic::ComponentMethod, used, Some("A"));
    let bolts = check(Topic::Bolts, 0.9, Some("A"));
    let of = |checks: &[Check], analysis| {
        let j = judged(checks, Analysed { verdict: analysis, ..Analysed::not("A") });
        (j.words(), j.route)
    };
    let code = ("OK — by code", Some(Route::Code));
    let bounds = ("OK — by analysis", Some(Route::Analysis));
    for analysis in [Nothing, Undecided, Fine] {
        assert_eq!(of(&[method(0.8), bolts.clone()], analysis), code);
        assert_eq!(of(&[method(0.8)], analysis), code, "information is still a check of the load");
    }
    assert_eq!(of(&[method(1.2), bolts.clone()], Fine), bounds);
    // a lower bound alone is no complete route
    assert_eq!(of(&[], Fine), ("UNDECIDED", None));
    assert_eq!(of(&[method(1.2), bolts.clone()], Undecided), ("NOT OK", None));
    assert_eq!(of(&[method(0.8), bolts.clone()], NotOk), ("NOT OK", None));
    assert_eq!(of(&[], Undecided), ("UNDECIDED", None));
    // of several cases the weaker route counts
    let two = [method(0.8), bolts.clone(), check(Topic::Bolts, 0.9, Some("B"))];
    let over = check(Topic::ComponentMethod, 1.1, Some("B"));
    let cases = |last| [Analysed::not("A"), Analysed { verdict: last, ..Analysed::not("B") }];
    let all = |checks: &[Check], last| judge(&mut hand(checks, &[]), &cases(last)).0.route;
    assert_eq!(all(&two, Nothing), Some(Route::Code));
    assert_eq!(all(&[&two[..], &[over]].concat(), Fine), Some(Route::Analysis));
}

/// A step of the route of analysis.
fn step(id: StepId, state: StepState) -> RouteStep {
    match state {
        StepState::Open => {
            RouteStep::open(id, Text::given("it is not known"), "6.2", "a finer mesh")
        }
        state => RouteStep { state, ..RouteStep::proved(id, Text::given("it holds"), "6.2") },
    }
}

/// A complete route of analysis answers what the code has no method for, in joints without checks
/// and where no rule of rotation capacity holds. It overrules no check that fails, and none for
/// which the code has a method. One open step leaves the case undecided, and is named with what
/// closes it.
#[test]
fn a_complete_route_of_analysis_answers_what_has_no_method() {
    let holds =
        vec![step(StepId::Strength, StepState::Proved), step(StepId::Bolts, StepState::Estimated)];
    let open = vec![holds[0].clone(), step(StepId::Strain, StepState::Open)];
    let carried = |steps: &Vec<RouteStep>| Analysed {
        verdict: Fine,
        steps: steps.clone(),
        ..Analysed::not("A")
    };
    let without = Check::undecided(
        Topic::Bolts,
        Part::Joint,
        "6.2",
        CheckId::WeakAxisOfJoint,
        "no formula",
        "another detail",
    );
    let without = without.without_method().of_case("A");
    let bolts = check(Topic::Bolts, 0.9, Some("A"));
    let outcome = |checks: &[Check], a: Analysed| {
        let j = judged(checks, a);
        (j.words(), j.by_code, j.steps.len())
    };
    let proved = "OK — by analysis";
    let checks = [without.clone(), bolts.clone()];
    assert_eq!(outcome(&checks, carried(&holds)), (proved, Undecided, 0));
    assert_eq!(outcome(&[], carried(&holds)), (proved, Nothing, 0));
    assert_eq!(outcome(&checks, carried(&open)), ("UNDECIDED", Undecided, 0));
    assert_eq!(outcome(&checks, carried(&Vec::new())), ("UNDECIDED", Undecided, 0));
    let reason = judged(&checks, carried(&open)).reason.to_string();
    for word in ["no method for moment of the joint", "strain of the plates", "a finer mesh"] {
        assert!(reason.contains(word), "{reason}");
    }
    // a check that fails, and one that the code leaves open for another reason
    let fails = [without.clone(), check(Topic::Welds, 1.1, Some("A"))];
    assert_eq!(outcome(&fails, carried(&holds)).0, "NOT OK");
    let beside = Check { binding: Binding::Beside, ..without };
    assert_eq!(outcome(&[beside, bolts.clone()], carried(&holds)).0, "UNDECIDED");
    // the steps stand for the rule of rotation capacity
    let brittle = Analysed { verdict: Undecided, brittle: true, no_rule: true, ..carried(&holds) };
    let over = check(Topic::ComponentMethod, 1.01, Some("A"));
    assert_eq!(outcome(&[over.clone(), bolts.clone()], brittle.clone()).0, proved);
    assert_eq!(judged(&[over, bolts], brittle).by_analysis, Fine);
    // an upper bound below the load refuses whatever else is known
    let refused = Analysed { verdict: NotOk, ..carried(&holds) };
    assert_eq!(outcome(&checks, refused).0, "NOT OK");
}

/// A lower bound that no rule of rotation capacity supports decides nothing, and takes nothing
/// from the code's route.
#[test]
fn a_lack_of_rotation_capacity_limits_the_bound_alone() {
    let brittle = |case| Analysed {
        verdict: Undecided,
        utilisation: Some([0.69, 0.81]),
        brittle: true,
        no_rule: true,
        ..Analysed::not(case)
    };
    let j = judged(&[check(Topic::ComponentMethod, 0.87, Some("A"))], brittle("A"));
    assert_eq!((j.verdict, j.route, j.by_analysis), (Fine, Some(Route::Code), Undecided));
    assert!(j.reason.to_string().contains("utilisation 0.87"), "{}", j.reason);
    assert!(j.reason.to_string().contains("no rule of rotation capacity holds"), "{}", j.reason);
    let j = judged(&[check(Topic::ComponentMethod, 1.01, Some("A"))], brittle("A"));
    assert_eq!(j.verdict, NotOk);
    let j = judged(&[], brittle("A"));
    assert_eq!(j.verdict, Undecided);
    assert!(j.reason.to_string().contains("a rule of rotation capacity holds"), "{}", j.reason);
}

/// An undecided verdict names the first missing step and what would supply it; every verdict names
/// the cases without a lower bound.
#[test]
fn what_is_missing_is_named_with_what_would_supply_it() {
    let lacks = "limit analysis gave no lower bound (time limit)";
    let cut =
        |case| Analysed { verdict: Undecided, missing: Some(lacks.into()), ..Analysed::not(case) };
    let of = |checks: &[Check], a| judged(checks, a).line(3, None);
    let wide = Analysed { verdict: Undecided, ..Analysed::not("A") };
    for (line, words) in [
        (of(&[], Analysed::not("A")), ["no limit analysis was run", "`kind: limit`"]),
        (of(&[], wide), ["the bounds do not decide", "`max_passes`"]),
        (of(&[], cut("A")), [lacks, "`time_limit`"]),
    ] {
        assert!(line.starts_with("verdict: UNDECIDED (by code none"), "{line}");
        assert!(words.iter().all(|w| line.contains(w)), "{line}");
    }
    let unknown = Check::undecided(
        Topic::Stability,
        Part::Panel,
        "6.2.6.1(1)",
        CheckId::Unseen,
        "69",
        "a thick web",
    )
    .of_case("A");
    let line = of(std::slice::from_ref(&unknown), cut("A"));
    for words in [
        "stability that a limit analysis does not see, column web panel (6.2.6.1(1)): 69; ",
        "what would decide it: a thick web",
        lacks,
    ] {
        assert!(line.contains(words), "{line}");
    }
    let checks = [check(Topic::Bolts, 0.9, Some("A")), check(Topic::Bolts, 0.4, Some("B"))];
    let (all, each) = judge(&mut hand(&checks, &[]), &[cut("A"), cut("B")]);
    assert_eq!(all.verdict, Fine);
    assert!(each[1].reason.to_string().contains(lacks), "{}", each[1].reason);
    assert!(all.reason.to_string().ends_with("; without a lower bound: B"), "{}", all.reason);
}

/// Where a component may buckle the component method binds; no bracket overrules it or any
/// other binding check.
#[test]
fn no_bracket_overrules_what_limit_analysis_does_not_know() {
    let over = [check(Topic::ComponentMethod, 1.05, Some("A"))];
    assert_eq!(verdicts(&over, &["A"], Fine), [NotOk, NotOk, Fine]);
    let unknown = Check::undecided(
        Topic::Stability,
        Part::Panel,
        "6.2.6.1(1)",
        CheckId::Unseen,
        "69",
        "a web",
    )
    .of_case("A");
    assert_eq!(
        verdicts(std::slice::from_ref(&unknown), &["A"], Fine),
        [Undecided, Undecided, Fine]
    );
    assert_eq!(
        verdicts(&[unknown, check(Topic::Bolts, 1.01, Some("A"))], &["A"], Fine),
        [NotOk, NotOk, Fine]
    );
    // a bracket does not replace the checks of a joint that the component method does not cover
    let missing = Check::undecided(
        Topic::ComponentMethod,
        Part::BoltRows,
        "Table 6.6",
        CheckId::MethodResistance,
        "two outside",
        "one",
    )
    .of_strength()
    .of_case("A");
    assert_eq!(verdicts(&[missing], &[], Fine), [Undecided, Undecided, Fine]);
    // a distance that is too small fails without a load
    assert_eq!(verdicts(&[check(Topic::Detailing, 1.1, None)], &[], Fine), [NotOk, NotOk, Fine]);
}

/// A check of another case does not affect this one; without checks the verdict is undecided, a
/// lower bound that carries the load or not.
#[test]
fn a_demand_always_ends_with_a_verdict() {
    let other = [check(Topic::Bolts, 2.0, Some("B"))];
    assert_eq!(verdicts(&other, &[], Fine), [Undecided, Nothing, Fine]);
    assert_eq!(verdicts(&[], &[], Nothing), [Undecided, Nothing, Nothing]);
    assert_eq!(
        verdicts(&[check(Topic::Detailing, 0.5, None)], &[], Nothing),
        [Undecided, Nothing, Nothing]
    );
}

/// A case at serviceability without a check does not affect the verdict; alone it leaves the
/// verdict undecided.
#[test]
fn a_case_at_serviceability_does_not_stand_for_the_ultimate_one() {
    let mut h = hand(&[check(Topic::Bolts, 0.9, Some("A"))], &[]);
    h.serviceability = vec!["S".into()];
    let (j, each) = judge(&mut h.clone(), &[Analysed::not("A"), Analysed::not("S")]);
    assert_eq!((j.verdict, each[1].verdict), (Fine, Nothing));
    let limit = Analysed { verdict: Fine, ..Analysed::not("S") };
    let alone = judge(&mut h.clone(), &[limit]).0;
    assert_eq!((alone.verdict, alone.route), (Undecided, None));
    // a bracket that does not decide leaves the case as it is without one
    let wide = Analysed { verdict: Undecided, ..Analysed::not("S") };
    assert_eq!(judge(&mut h, &[Analysed::not("A"), wide]).0.verdict, Fine);
}

/// The line names the governing check: the failed check of the worst case, with clause and
/// utilisation.
#[test]
fn the_last_line_names_what_governs() {
    let checks = [check(Topic::Bolts, 0.9, Some("A")), check(Topic::Stability, 1.05, Some("B"))];
    let case = |name: &str| Analysed {
        verdict: Fine,
        utilisation: Some([0.69, 0.81]),
        ..Analysed::not(name)
    };
    let (j, each) = judge(&mut hand(&checks, &[]), &[case("A"), case("B")]);
    assert_eq!(each.iter().map(|j| j.verdict).collect::<Vec<_>>(), [Fine, NotOk]);
    let line = j.line(1, None);
    for words in [
        "verdict: NOT OK (by code NOT OK, by analysis OK)",
        "B, moment and axial force of the joint, bolt rows, utilisation 1.05 (6.2)",
        "exit code 1",
    ] {
        assert!(line.contains(words), "{line}");
    }
    assert!(j.reason.to_string().contains("limit analysis does not know"), "{}", j.reason);
    // where all checks hold, the largest utilisation governs
    let (j, _) = judge(&mut hand(&checks[..1], &[]), &[case("A")]);
    assert!(j.line(0, None).contains("utilisation 0.90 (6.2)"), "{}", j.line(0, None));
    let (j, _) = judge(&mut hand(&[check(Topic::Bolts, 0.7, Some("A"))], &[]), &[case("A")]);
    assert!(
        j.line(0, None).contains("utilisation 0.69 … 0.81 (limit analysis)"),
        "{}",
        j.line(0, None)
    );
}

/// A strength without a load case governs like any other; a length that is kept never does.
#[test]
fn a_check_without_a_load_case_governs_where_it_is_used_most() {
    let throat = ((Topic::Welds, Part::BeamWeb), ("4.5.2", CheckId::LeastThroat));
    let kept = Check::at_least(throat.0, throat.1, "a", 5.0, 5.0, Status::Failed);
    let checks = [check(Topic::Bolts, 0.6, Some("A")), check(Topic::Welds, 0.9, None), kept];
    let j = judged(&checks, Analysed::not("A"));
    let governing = j.governing.expect("one governs");
    assert_eq!((governing.case, governing.utilisation), (None, Some([0.9, 0.9])));
    // a recommendation that is followed never governs
    let advice =
        Worked::of("6.2.3(5)", CheckId::FlangeWeldOfHinge, "u", Traced::from(1.0), Unit::Number);
    let advice = advice.utilised(Topic::Welds, Part::Welds, Status::Warning);
    let checks = [check(Topic::Bolts, 0.6, Some("A")), advice];
    let governing = judged(&checks, Analysed::not("A")).governing.expect("one governs");
    assert_eq!(governing.utilisation, Some([0.6, 0.6]));
}
