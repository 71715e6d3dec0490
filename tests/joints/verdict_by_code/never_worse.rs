//! An analysis beside the checks of the code.

use super::*;

/// Analyses of every kind beside the hand checks of 40 joints at 0.3 to 1.6 times their moment
/// resistance: none makes the verdict worse than that of the checks alone, unless its upper bound
/// is below the demand. Where the checks fail beyond the component method, none makes it better.
#[test]
fn no_analysis_makes_a_joint_worse_than_its_checks_unless_it_proves_collapse() {
    let catalog = builtin();
    let of = |series: &[&str]| -> Vec<&IProfile> {
        let fits =
            |p: &&IProfile| series.contains(&p.series.as_str()) && (200.0..500.0).contains(&p.h);
        catalog.profiles().iter().filter(fits).collect()
    };
    let (columns, beams) = (of(&["HEA", "HEB"]), of(&["IPE"]));
    let mut n = Numbers(38);
    let (mut joints, mut seen) = (0, [[0usize; 4]; 4]);
    while joints < 40 {
        let (spec, _, _) = random_spec(&mut n, &columns, &beams);
        let at = if spec.contains("splice") { "bolt_plane" } else { "column_face" };
        let with = |m: f64, v: f64| {
            let load = format!(
                "loads: [{{name: A, end: beam_right, at: {at}, My: {m} N mm, Vz: {v} N}}]\n"
            );
            checks(&format!("{spec}{load}"), &catalog)
        };
        let resistance = with(1e6, 0.0).and_then(|h| h.comparisons().next().map(|c| c.resistance));
        let Some(resistance) = resistance else { continue };
        joints += 1;
        let factor = n.between(0.3, 1.6);
        let hand = with(factor * resistance, -n.between(0.0, 50e3)).expect("the same joint");
        let alone = judge(&mut hand.clone(), &[Analysed::not("A")]).0;
        let missing = |text: &'static str| Some(text.into());
        let bracket = |low: f64, up: f64| Some([1.0 / up, 1.0 / low]);
        for a in [
            // not run, cut off, an upper bound alone, wide, wide without a rule, brittle
            Analysed { missing: missing("its analysis was not run"), ..Analysed::not("A") },
            Analysed {
                missing: missing("no bound"),
                verdict: Verdict::Undecided,
                ..Analysed::not("A")
            },
            Analysed {
                missing: missing("no lower bound"),
                verdict: Verdict::Undecided,
                no_rule: true,
                ..Analysed::not("A")
            },
            Analysed {
                verdict: Verdict::Undecided,
                utilisation: bracket(0.5, 2.0),
                ..Analysed::not("A")
            },
            Analysed {
                verdict: Verdict::Undecided,
                utilisation: bracket(0.5, 2.0),
                no_rule: true,
                ..Analysed::not("A")
            },
            Analysed {
                verdict: Verdict::Undecided,
                utilisation: bracket(1.3, 1.5),
                brittle: true,
                no_rule: true,
                ..Analysed::not("A")
            },
            Analysed { verdict: Verdict::Ok, utilisation: bracket(1.3, 1.5), ..Analysed::not("A") },
            Analysed {
                verdict: Verdict::NotOk,
                utilisation: bracket(0.7, 0.9),
                ..Analysed::not("A")
            },
        ] {
            let mut beside = hand.clone();
            let j = judge(&mut beside, std::slice::from_ref(&a)).0;
            let place = || format!("{a:?}: {} for {}: {spec}", j.reason, alone.reason);
            if a.verdict == Verdict::NotOk {
                assert_eq!((j.verdict, j.route), (Verdict::NotOk, None), "{}", place());
                continue;
            }
            assert!(rank(j.verdict) <= rank(alone.verdict), "{}", place());
            if a.verdict != Verdict::Ok {
                assert_eq!((j.verdict, j.route), (alone.verdict, alone.route), "{}", place());
            } else if j.verdict != alone.verdict {
                // a lower bound stands in for the component method, and for nothing else
                assert_eq!(j.route, Some(Route::Analysis), "{}", place());
                let binds = |c: &&Check| {
                    matches!(c.status, Status::Failed | Status::Undecided)
                        && c.case.as_ref().is_none_or(|case| case == "A")
                };
                let mut bad = hand.checks.iter().filter(binds);
                assert!(bad.all(|c| c.binding == Binding::Strength), "{}", place());
            }
            seen[rank(alone.verdict)][rank(j.verdict)] += 1;
        }
    }
    println!("verdicts of the checks alone (rows) and beside an analysis: {seen:?}");
    assert!(seen[1][1] > 50 && seen[3][3] > 50 && seen[3][1] > 0, "{seen:?}");
}
