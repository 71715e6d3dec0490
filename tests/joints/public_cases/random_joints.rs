//! Random joints: every result is a number or a named fault, and rounding changes no verdict.

use super::printed_formulas::Compared;
use crate::numbers::Numbers;
use bracket::catalog::{Catalog, IProfile};
use bracket::checks::design_code::build;
use bracket::checks::verdict::Verdict;
use bracket::checks::{Analysed, Check, Status, joint_checks, judge};
use bracket::driver::demands::demands;
use bracket::result::result_file::ResultFile;
use bracket::spec::connection::ConnectionSpec;
use bracket::yaml;
use std::path::Path;

/// Joints whose numbers are tried: all in an optimised build, which the tests of a release have.
const TRIED: usize = if cfg!(debug_assertions) { 250 } else { 2000 };

/// A joint without its loads.
struct Drawn {
    /// The spec up to its loads.
    text: String,
    beam: IProfile,
    /// f_y of the beam \[MPa\].
    fy: f64,
    /// Its member ends.
    ends: Vec<&'static str>,
    /// The point at which actions are given.
    at: &'static str,
}

/// A random splice or beam-to-column joint: classes 1 to 4, corners, forces of the column, preload.
fn drawn(n: &mut Numbers, columns: &[&IProfile], beams: &[&IProfile]) -> Drawn {
    let (column, beam) = (n.of(columns), n.of(beams));
    let (size, d) = n.of(&[("M12", 12.0), ("M16", 16.0), ("M20", 20.0), ("M24", 24.0)]);
    let steels = [("S235", 235.0), ("S275", 275.0), ("S355", 355.0), ("S460M", 460.0)];
    let ((steel, fy), grade) = (n.of(&steels), n.of(&["8.8", "10.9"]));
    let inner = 0.5 * beam.h - beam.tf - n.between(1.7, 3.0) * d;
    let mut rows = vec![inner, -inner];
    if n.chance(0.5) {
        rows.push(0.5 * beam.h + n.between(1.8, 2.4) * d);
    }
    if n.chance(0.2) {
        rows.push(0.0);
    }
    let bolts = n.of(&["", ", preload: 0.7", ", preload: 0.7, category: C"]);
    let weld = n.of(&[0.0, 3.0, 6.0]);
    let welds = format!("flange_weld: {weld}, web_weld: {weld}");
    let plate = n.between(8.0, 30.0).round();
    if n.chance(0.3) {
        let text = format!(
            "template: beam_splice\nmembers: {{beam: {{profile: {}, steel: {steel}}}}}\nplate: \
             {{thickness: {plate}}}\nbolts: {{size: {size}, grade: \"{grade}\", rows: \
             {rows:?}{bolts}}}\nparameters: {{{welds}}}\nfriction: {{mu: 0.2}}\n",
            beam.name
        );
        return Drawn { text, beam: beam.clone(), fy, ends: vec!["beam_right"], at: "bolt_plane" };
    }
    let both = n.chance(0.4);
    let mut forces = String::new();
    let capacity = 1e-1 * column.area * fy;
    if n.chance(0.3) {
        forces += &format!(", N_Ed: {} kN", (n.between(-0.9, 0.9) * capacity).round());
    }
    if n.chance(0.2) {
        let moment = n.between(0.0, 0.8) * column.w_pl_y * fy * 1e-3;
        forces += &format!(", M_Ed: {} kN m", moment.round());
    }
    if n.chance(0.2) {
        forces += &format!(", V_Ed: {} kN", n.between(-300.0, 300.0).round());
    }
    let corner = n.of(&["", "", ", column_ends_above: true", ", column_ends_below: true"]);
    let doubler = n.of(&["", "", ", doubler: true, doubler_weld: 8"]);
    let stiffened = n.chance(0.5);
    let text = format!(
        "template: beam_to_column_end_plate\nmembers: {{column: {{profile: {}, steel: \
         {steel}{forces}}}, beam: {{profile: {}, steel: {steel}}}}}\nplate: {{thickness: \
         {plate}}}\nbolts: {{size: {size}, grade: \"{grade}\", rows: \
         {rows:?}{bolts}}}\nparameters: {{double_sided: {both}, column_stiffeners: {stiffened}, \
         {welds}{corner}{doubler}}}\nfriction: {{mu: 0.2}}\n",
        column.name, beam.name
    );
    let ends = if both { vec!["beam_right", "beam_left"] } else { vec!["beam_right"] };
    let at = n.of(&["node", "column_face", "bolt_plane"]);
    Drawn { text, beam: beam.clone(), fy, ends, at }
}

/// The actions N, Vy, Vz, T, My, Mz with plastic resistances of the beam \[N, N mm\].
fn resistances(d: &Drawn) -> [(&'static str, f64); 6] {
    let (b, tau) = (&d.beam, d.fy / 3f64.sqrt());
    [
        ("N", 1e2 * b.area * d.fy),
        ("Vy", 2.0 * b.b * b.tf * tau),
        ("Vz", b.h * b.tw * tau),
        ("T", b.b * b.tf * b.tf * tau),
        ("My", 1e3 * b.w_pl_y * d.fy),
        ("Mz", 1e3 * b.w_pl_z * d.fy),
    ]
}

fn unit(action: &str) -> &'static str {
    if matches!(action, "T" | "My" | "Mz") { "N mm" } else { "N" }
}

fn load(case: &str, end: &str, at: &str, actions: &[(&str, f64)]) -> String {
    let each: Vec<String> =
        actions.iter().map(|(a, v)| format!(", {a}: {v:e} {}", unit(a))).collect();
    format!("{{name: {case}, end: {end}, at: {at}{}}}", each.concat())
}

/// The result of the checks of a spec; `None` if the template refuses it.
fn result(text: &str, catalog: &Catalog) -> Option<ResultFile> {
    let path = Path::new("joint.yaml");
    let spec =
        yaml::parse::<ConnectionSpec>(text, path).unwrap_or_else(|e| panic!("{e:?}: {text}"));
    let joint = build(&spec, Path::new(""), catalog).ok()?;
    let mut checks = joint_checks(&joint);
    let cases: Vec<Analysed> =
        demands(&spec.value.loads).into_iter().map(|d| Analysed::not(d.case)).collect();
    let (judgement, _) = judge(&mut checks, &cases);
    let mut out = ResultFile::new("0", 1, judgement.verdict);
    out.judgement = Some(judgement);
    out.checks.clone_from(&checks.checks);
    out.neglected.clone_from(&checks.neglected);
    // the numbers of the component method are written with the analyses of a case
    for c in checks.comparisons() {
        let value = serde_json::to_value(c).expect("JSON");
        assert!(!value.to_string().contains("null"), "{value}: {text}");
    }
    for m in checks.moments() {
        assert!(m.component_method.is_finite(), "{m:?}: {text}");
    }
    Some(out)
}

fn profiles<'a>(catalog: &'a Catalog, series: &[&str], depth: [f64; 2]) -> Vec<&'a IProfile> {
    let fits =
        |p: &&IProfile| series.contains(&p.series.as_str()) && (depth[0]..depth[1]).contains(&p.h);
    catalog.profiles().iter().filter(fits).collect()
}

#[test]
fn every_result_is_a_number_or_a_named_fault() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let columns = profiles(&catalog, &["HEA", "HEB", "HEM", "UC", "IPE", "W"], [140.0, 700.0]);
    let beams = profiles(&catalog, &["IPE", "UB", "HEA", "HEB", "W"], [200.0, 700.0]);
    let mut n = Numbers(31);
    let (mut joints, mut seen, mut printed) = (0, [0usize; 3], Compared::default());
    for _ in 0..20 * TRIED {
        if joints == TRIED {
            break;
        }
        let d = drawn(&mut n, &columns, &beams);
        let mut loads = Vec::new();
        for end in &d.ends {
            let mut actions = Vec::new();
            for (action, resistance) in resistances(&d) {
                let size = n.of(&[0.0, 0.0, 1e-9, 0.01, 0.3, 1.0, 1.2, 10.0]);
                if n.chance(0.6) {
                    // some exactly at the resistance, most of any size
                    let part = if n.chance(0.2) { 1.0 } else { n.unit() };
                    actions.push((action, n.of(&[1.0, -1.0]) * size * part * resistance));
                }
            }
            if !actions.is_empty() {
                loads.push(load("A", end, d.at, &actions));
            }
        }
        let text = format!("{}loads: [{}]\n", d.text, loads.join(", "));
        if loads.is_empty() {
            continue;
        }
        let Some(result) = result(&text, &catalog) else { continue };
        joints += 1;
        let written = result.to_json().unwrap_or_else(|e| panic!("{e}: {text}"));
        assert!(!written.contains("NaN"), "{text}");
        for c in &result.checks {
            let without = c.resistance.is_none() || (c.demand.is_none() && c.utilisation.is_none());
            let information = matches!(c.status, Status::Information | Status::Warning);
            let fault = matches!(c.status, Status::Failed | Status::Undecided);
            assert!(!without || information || fault, "{c:?}: {text}");
            assert!(!information || !c.formula().to_string().contains("NaN"), "{c:?}: {text}");
            printed.check(c, &text);
        }
        let at = [Verdict::Ok, Verdict::NotOk, Verdict::Undecided].iter();
        seen[at.clone().position(|v| *v == result.verdict).expect("a verdict")] += 1;
    }
    let clauses = printed.clauses.len();
    println!("{joints} joints, OK, NOT OK, UNDECIDED: {seen:?}; {clauses} formulas compared");
    assert_eq!(joints, TRIED);
    assert!(clauses > 60, "{:#?}", printed.clauses);
    assert!(seen.iter().all(|s| *s > 0), "{seen:?}");
}

/// 200 joints under one main action, and the same with noise of a millionth of it in the other
/// five: the same verdict and the same checks.
#[test]
fn noise_of_a_millionth_changes_no_verdict() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let columns = profiles(&catalog, &["HEA", "HEB", "HEM", "UC"], [150.0, 420.0]);
    let beams = profiles(&catalog, &["IPE", "UB"], [200.0, 560.0]);
    let mut n = Numbers(3);
    let (mut joints, mut seen) = (0, [0usize; 3]);
    for _ in 0..4000 {
        if joints == 200 {
            break;
        }
        let d = drawn(&mut n, &columns, &beams);
        let all = resistances(&d);
        let main = n.of(&["My", "My", "Vz", "N"]);
        let (_, resistance) = *all.iter().find(|a| a.0 == main).expect("an action");
        let size = n.of(&[1.0, -1.0]) * n.between(0.02, 1.1) * resistance;
        let of = |noise: &[(&str, f64)]| {
            // the noise of a moment is a moment: forces turn about the depth of the beam
            let of_main = if unit(main) == "N" { 1.0 } else { 1.0 / d.beam.h };
            let noisy = noise.iter().filter(|(a, _)| *a != main).map(|(a, part)| {
                let arm = if unit(a) == "N" { 1.0 } else { d.beam.h };
                (*a, 1e-6 * part * size.abs() * of_main * arm)
            });
            let actions: Vec<(&str, f64)> = [(main, size)].into_iter().chain(noisy).collect();
            let mut loads = vec![load("A", d.ends[0], d.at, &actions)];
            if let (Some(end), false) = (d.ends.get(1), noise.is_empty()) {
                // the other beam has rounding alone
                loads.push(load("A", end, d.at, &actions[1..]));
            }
            result(&format!("{}loads: [{}]\n", d.text, loads.join(", ")), &catalog)
        };
        let Some(clean) = of(&[]) else { continue };
        joints += 1;
        let noise: Vec<(&str, f64)> = all.iter().map(|(a, _)| (*a, n.between(-1.0, 1.0))).collect();
        let noisy = of(&noise).expect("the same joint");
        assert_eq!(noisy.verdict, clean.verdict, "{main} {size} {noise:?} on {}", d.text);
        // the noise of My at the node is part of the moment of Vz about the bolt plane
        let alike = |a: &Check, b: &Check| {
            let used = [a, b].map(|c| c.utilisation.unwrap_or(-1.0));
            let same = (used[0] - used[1]).abs() <= 1e-5 * used[0].abs().max(1.0);
            // of two rows that are used alike the larger by rounding is named
            (&a.title, a.status) == (&b.title, b.status) && same
        };
        let mut pairs = noisy.checks.iter().zip(&clean.checks);
        let place = || format!("{main} {size} {noise:?} on {}", d.text);
        assert_eq!(noisy.checks.len(), clean.checks.len(), "{}", place());
        let other = pairs.find(|(a, b)| !alike(a, b));
        assert!(other.is_none(), "{other:?}: {}", place());
        let at = [Verdict::Ok, Verdict::NotOk, Verdict::Undecided].iter();
        seen[at.clone().position(|v| *v == clean.verdict).expect("a verdict")] += 1;
    }
    println!("{joints} joints, OK, NOT OK, UNDECIDED: {seen:?}");
    assert_eq!(joints, 200);
    assert!(seen[0] > 20 && seen[1] > 30, "{seen:?}");
}
