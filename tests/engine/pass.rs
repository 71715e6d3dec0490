//! Passes under limits of memory and time and under interrupts, and the message for a program
//! without a solution.

use crate::common::solved::{resolve, solve_to};
use crate::common::{Block, beside, triangles_where};
use bracket::analysis::energy_pass::EnergyPass;
use bracket::analysis::event::{Event, Progress};
use bracket::analysis::memory::{Limit, Room};
use bracket::analysis::pass::PassOptions;
use bracket::analysis::program::Program;
use bracket::analysis::program_outcome::ProgramOutcome;
use bracket::analysis::{diagnosis, elastic};
use bracket::mesh::{NamedFaces, TetMesh};
use bracket::model::AnalysisModel;
use bracket::programs::Kinematic;
use bracket::result::energy_case::case_result;
use bracket::solve::{SolveOptions, SolveStatus, Solver};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

/// A block on rigid ground with friction, pushed obliquely.
const ON_GROUND: &str = "materials: {s: {E: 210000, nu: 0.3}}\nbodies: {BLOCK: s}\nsupports: \
                         [{face: Z0, law: contact, mu: 0.3, friction: associated}]\nloads: \
                         [{face: Z1, traction: [2, 0, -40]}]\n";

fn on_ground() -> AnalysisModel {
    let mesh =
        Block::new([3, 2, 3], [30.0, 20.0, 30.0]).jittered(5).mesh(&["BLOCK"], |_| 0, |_, _| false);
    resolve(ON_GROUND, mesh).expect("a sound model")
}

/// Runs a pass and records its events as words.
fn with_events(run: impl FnOnce(&Progress) -> EnergyPass) -> (EnergyPass, Vec<String>) {
    let words: Arc<Mutex<Vec<String>>> = Arc::default();
    let kept = words.clone();
    let progress: Progress = Arc::new(move |program, event| {
        let word = match event {
            Event::Assembly => "assembly".into(),
            Event::Forecast { unknowns, forecast } => {
                format!("forecast {unknowns} {}", forecast.is_some())
            }
            Event::Waits { needed, room } => format!("waits {needed} {}", room.bytes),
            Event::Later { .. } => "later".into(),
            Event::Refused(r) => format!("refused {} {}", r.needed, r.room.bytes),
            Event::Solve { forecast } => format!("solve {}", forecast.is_some()),
            Event::Iteration(_) => return,
            Event::HandOver { bytes } => format!("hand over {bytes}"),
            Event::Tightening => "tightening".into(),
            Event::ConeShift { .. } => "slips".into(),
            Event::Certify => "certify".into(),
            Event::Frictionless => "frictionless".into(),
            Event::Yielding { tets } => format!("yielding {tets}"),
            Event::Coulomb => "coulomb".into(),
            Event::Ended(run) => format!("ended {}", run.status.words()),
        };
        kept.lock().expect("whole").push(format!("{} {word}", program.name()));
    });
    let pass = run(&progress);
    let words = words.lock().expect("whole").clone();
    (pass, words)
}

fn both(pass: &EnergyPass) -> [&ProgramOutcome; 2] {
    [pass.kinematic.as_ref().expect("asked for"), pass.statics.as_ref().expect("asked for")]
}

/// Options with the given amounts of free memory: one amount for each query, the last one for all
/// further queries.
fn rooms(limit: Limit, bytes: &[u64]) -> PassOptions {
    let (asked, bytes) = (AtomicUsize::new(0), bytes.to_vec());
    let room = move || {
        let k = asked.fetch_add(1, Ordering::Relaxed).min(bytes.len() - 1);
        Some(Room { bytes: bytes[k], limit })
    };
    PassOptions { room: Arc::new(room), ..PassOptions::default() }
}

/// Runs the model with these amounts of free memory.
fn in_rooms(model: &AnalysisModel, limit: Limit, bytes: &[u64]) -> (EnergyPass, Vec<String>) {
    with_events(|p| elastic::run(model, &rooms(limit, bytes), p).expect("no fault of the model"))
}

/// Which programs gave a bound.
fn bounds(pass: &EnergyPass) -> [bool; 2] {
    assert_eq!(pass.bracket.is_some(), pass.upper.is_some() && pass.lower.is_some());
    [pass.upper.is_some(), pass.lower.is_some()]
}

fn at(words: &[String], word: &str) -> usize {
    words.iter().position(|w| w == word).unwrap_or_else(|| panic!("{word:?} in {words:?}"))
}

#[test]
fn what_does_not_fit_side_by_side_takes_turns_and_what_does_not_fit_alone_is_refused() {
    let model = on_ground();
    let (free, words) = in_rooms(&model, Limit::Machine, &[u64::MAX]);
    assert_eq!(bounds(&free), [true, true]);
    assert!(!words.iter().any(|w| w.contains("waits") || w.contains("refused")), "{words:?}");
    for program in ["kinematic", "static"] {
        let run = if program == "kinematic" { both(&free)[0] } else { both(&free)[1] };
        let order = [
            "assembly",
            &format!("forecast {} true", run.dofs),
            "solve true",
            "certify",
            "ended optimal",
        ];
        assert!(order.map(|w| at(&words, &format!("{program} {w}"))).is_sorted(), "{words:?}");
    }
    let [k, s] = both(&free).map(|r| r.forecast.expect("condensed").bytes);
    assert!(0 < k && k < s, "{k} {s}");
    let values =
        |p: &EnergyPass| [p.lower.as_ref().map(|b| b.value()), p.upper.as_ref().map(|b| b.value())];

    // free memory for exactly both, for one byte less, and for exactly the larger one
    let (pass, words) = in_rooms(&model, Limit::Machine, &[k + s]);
    assert!(!words.iter().any(|w| w.contains("waits")), "{words:?}");
    assert_eq!(values(&pass), values(&free));
    for room in [k + s - 1, s] {
        let (pass, words) = in_rooms(&model, Limit::Machine, &[room]);
        let waits = at(&words, &format!("static waits {} {room}", k + s));
        let order = ["kinematic solve true", "kinematic ended optimal", "static solve true"]
            .map(|w| at(&words, w));
        assert!(waits < order[0] && order.is_sorted(), "{words:?}");
        // in turn or side by side, the result is the same to the last digit
        assert_eq!(values(&pass), values(&free));
    }
    // the larger one alone does not fit
    for room in [s - 1, k] {
        let (pass, words) = in_rooms(&model, Limit::Asked(1 << 30), &[room]);
        assert_eq!(bounds(&pass), [true, false]);
        assert_eq!(pass.upper.as_ref().map(|b| b.value()), free.upper.as_ref().map(|b| b.value()));
        assert!(
            at(&words, &format!("static refused {s} {room}")) < at(&words, "kinematic solve true"),
            "{words:?}"
        );
        let [_, refused] = both(&pass);
        assert_eq!((refused.status, refused.iterations), (SolveStatus::TooLarge, 0));
        let refusal = refused.refusal.expect("why");
        assert_eq!(
            (refusal.needed, refusal.room.bytes, refusal.room.limit),
            (s, room, Limit::Asked(1 << 30))
        );
    }
    let warnings = |pass: &EnergyPass| case_result("A", &model, pass, None).warnings;
    let (pass, _) = in_rooms(&model, Limit::Machine, &[k]);
    let messages = warnings(&pass);
    assert!(
        messages.len() == 1
            && messages[0].to_string().starts_with(
                "the static program was not started, so there is no lower bound: it needs"
            )
    );
    // neither fits: the caller reports it, so there is no event
    let (pass, words) = in_rooms(&model, Limit::Machine, &[k - 1]);
    assert_eq!(bounds(&pass), [false, false]);
    assert!(both(&pass).iter().all(|r| r.status == SolveStatus::TooLarge && r.refusal.is_some()));
    assert!(!words.iter().any(|w| w.contains("solve") || w.contains("refused")), "{words:?}");
}

/// Other processes may take memory while the first program runs. A limit set by the user does not
/// shrink.
#[test]
fn a_program_that_waits_checks_the_free_memory_again() {
    let model = on_ground();
    let (free, _) = in_rooms(&model, Limit::Machine, &[u64::MAX]);
    let [k, s] = both(&free).map(|r| r.forecast.expect("condensed").bytes);
    let (pass, words) = in_rooms(&model, Limit::Machine, &[s, s - 1]);
    assert_eq!(bounds(&pass), [true, false]);
    assert_eq!(both(&pass)[1].status, SolveStatus::TooLarge);
    assert!(
        at(&words, "kinematic ended optimal")
            < at(&words, &format!("static refused {s} {}", s - 1))
    );
    let (pass, _) = in_rooms(&model, Limit::Asked(1 << 30), &[s, k]);
    assert_eq!(bounds(&pass), [true, true]);
}

/// Clarabel takes over from a solver without an answer where it has its memory.
#[test]
fn clarabel_takes_over_within_the_memory() {
    let handed = |room: u64| {
        let mut options = rooms(Limit::Asked(1 << 40), &[1 << 40, room]);
        options.solve.stop.max_iterations = 2;
        let (pass, words) = with_events(|p| elastic::run(&on_ground(), &options, p).expect("runs"));
        let said = |run: &str| words.iter().any(|w| w.starts_with(&format!("{run} hand over")));
        (both(&pass).map(|r| r.handed_over > 0), [said("kinematic"), said("static")])
    };
    assert_eq!(handed(1 << 40), ([true; 2], [true; 2]));
    assert_eq!(handed(1), ([false; 2], [false; 2]));
}

#[test]
fn one_program_alone_needs_its_own_room_only() {
    let mut model = on_ground();
    let (free, _) = in_rooms(&model, Limit::Machine, &[u64::MAX]);
    let [k, s] = both(&free).map(|r| r.forecast.expect("condensed").bytes);
    model.bounds = bracket::model::file::Bounds::Kinematic;
    let (pass, words) = in_rooms(&model, Limit::Machine, &[k]);
    assert!(
        pass.statics.is_none()
            && pass.upper.is_some()
            && !words.iter().any(|w| w.contains("waits")),
        "{words:?}"
    );
    let (pass, _) = in_rooms(&model, Limit::Machine, &[k - 1]);
    assert_eq!(pass.kinematic.map(|r| r.status), Some(SolveStatus::TooLarge));
    model.bounds = bracket::model::file::Bounds::Static;
    let (pass, _) = in_rooms(&model, Limit::Machine, &[s]);
    assert!(pass.kinematic.is_none() && pass.lower.is_some());
}

/// The general solver has no memory forecast. It starts with any amount of free memory and reports
/// that its demand is not known.
#[test]
fn a_solver_without_forecast_is_not_held_back() {
    let model = on_ground();
    let mut options = rooms(Limit::Machine, &[0]);
    options.solve.solver = Solver::Clarabel;
    let (pass, words) =
        with_events(|p| elastic::run(&model, &options, p).expect("no fault of the model"));
    assert_eq!(bounds(&pass), [true, true]);
    let n = both(&pass)[0].dofs;
    at(&words, &format!("kinematic forecast {n} false"));
    at(&words, "static solve false");
}

#[test]
fn every_iteration_is_kept_and_reported() {
    let model = on_ground();
    for solver in [Solver::Condensed, Solver::Clarabel] {
        let solve = SolveOptions { solver, ..SolveOptions::default() };
        let count: Arc<[AtomicUsize; 2]> = Arc::default();
        let counted = count.clone();
        let progress: Progress = Arc::new(move |program, event| {
            if let Event::Iteration(_) = event {
                counted[usize::from(program == Program::Static)].fetch_add(1, Ordering::Relaxed);
            }
        });
        let pass =
            elastic::run(&model, &PassOptions { solve, ..PassOptions::default() }, &progress)
                .expect("sound");
        for (run, reported) in both(&pass).into_iter().zip(count.iter()) {
            let trace = &run.trace;
            assert_eq!(trace.len(), reported.load(Ordering::Relaxed));
            assert!(trace.len() > run.iterations as usize && run.iterations > 3, "{trace:?}");
            assert_eq!(trace[0].number, 0);
            assert!(
                trace.windows(2).all(|w| w[0].number < w[1].number && w[0].seconds <= w[1].seconds),
                "{trace:?}"
            );
            assert!(
                trace.last().is_some_and(|i| i.gap < 1e-7 && i.seconds <= run.solve_seconds),
                "{trace:?}"
            );
            assert!(trace[1..].iter().all(|i| i.step > 0.0 && i.step <= 1.0), "{trace:?}");
        }
    }
}

/// Runs until `program` reaches `iteration`, then sets the flag.
fn interrupted_at(
    model: &AnalysisModel,
    solver: Solver,
    at: impl Fn(Program, &Event<'_>) -> bool + Send + Sync + 'static,
) -> EnergyPass {
    let flag = Arc::new(AtomicBool::new(false));
    let set = flag.clone();
    let progress: Progress = Arc::new(move |program, event| {
        if at(program, &event) {
            set.store(true, Ordering::Relaxed);
        }
    });
    let solve = SolveOptions { solver, interrupt: Some(flag), ..SolveOptions::default() };
    // in turn, the kinematic program first, so that the position of the interrupt is known
    let (free, _) = in_rooms(model, Limit::Machine, &[u64::MAX]);
    let s = both(&free)[1].forecast.expect("condensed").bytes;
    let options = PassOptions { solve, ..rooms(Limit::Machine, &[s]) };
    elastic::run(model, &options, &progress).expect("no fault of the model")
}

#[test]
fn an_interrupt_ends_at_the_next_iteration_and_leaves_what_is_certified() {
    let model = on_ground();
    let pass = interrupted_at(&model, Solver::Condensed, |p, e| {
        p == Program::Kinematic && matches!(e, Event::Iteration(i) if i.number == 2)
    });
    assert_eq!(bounds(&pass), [false, false]);
    let [k, s] = both(&pass);
    assert_eq!((k.status, k.iterations, k.trace.len()), (SolveStatus::Interrupted, 2, 3));
    assert_eq!((s.status, s.iterations, s.trace.len()), (SolveStatus::Interrupted, 0, 0));

    // the kinematic bound is kept and certified
    let pass = interrupted_at(&model, Solver::Condensed, |p, e| {
        p == Program::Static && matches!(e, Event::Iteration(i) if i.number == 3)
    });
    assert_eq!(bounds(&pass), [true, false]);
    assert!(pass.upper.as_ref().is_some_and(|b| b.is_strict()));
    assert_eq!((both(&pass)[1].status, both(&pass)[1].iterations), (SolveStatus::Interrupted, 3));
    let entry = case_result("A", &model, &pass, None);
    assert_eq!(
        entry.warnings,
        ["the static program was interrupted after 3 iterations: no lower bound"]
    );
    assert!(entry.upper.is_some() && entry.lower.is_none() && entry.load_displacement.is_none());

    // interrupt during the certification of the first field: it is completed, and the other program
    // does not start
    let pass = interrupted_at(&model, Solver::Condensed, |p, e| {
        p == Program::Kinematic && matches!(e, Event::Certify)
    });
    assert_eq!(bounds(&pass), [true, false]);

    // before the ordering starts
    let pass = interrupted_at(&model, Solver::Condensed, |_, e| matches!(e, Event::Assembly));
    assert_eq!(bounds(&pass), [false, false]);
    assert!(
        both(&pass).iter().all(|r| r.status == SolveStatus::Interrupted && r.forecast.is_none())
    );
}

#[test]
fn the_general_solver_is_interrupted_too() {
    let model = on_ground();
    let pass = interrupted_at(
        &model,
        Solver::Clarabel,
        |_, e| matches!(e, Event::Iteration(i) if i.number == 2),
    );
    assert_eq!(bounds(&pass), [false, false]);
    assert!(both(&pass).iter().any(|r| r.status == SolveStatus::Interrupted && r.iterations >= 2));
}

/// The time limit counts from the start of the pass. It does not start again for a program that
/// waits.
#[test]
fn a_program_that_waits_has_less_time() {
    let model = on_ground();
    let (free, _) = in_rooms(&model, Limit::Machine, &[u64::MAX]);
    let s = both(&free)[1].forecast.expect("condensed").bytes;
    let mut options = rooms(Limit::Machine, &[s]);
    options.solve.time_limit = 2.0;
    let slow: Progress = Arc::new(|program, event| {
        if program == Program::Kinematic && matches!(event, Event::Certify) {
            std::thread::sleep(std::time::Duration::from_millis(2100));
        }
    });
    let pass = elastic::run(&model, &options, &slow).expect("no fault of the model");
    assert_eq!(bounds(&pass), [true, false]);
    assert_eq!(both(&pass)[1].status, SolveStatus::TimeLimit);
}

/// A block between two walls. Its sides can only shift rigidly along x. The initial gaps are
/// negative nowhere, but their quadratic coefficients on the mesh are negative. The kinematic
/// program would have to open both walls at once by a shift, which is impossible.
fn wedged(mu: f64) -> (String, TetMesh) {
    let mut mesh = Block::new([2, 1, 2], [20.0, 10.0, 20.0]).mesh(&["BLOCK"], |_| 0, |_, _| false);
    let mut triangles = triangles_where(&mesh, |x| x[1] == 0.0);
    triangles.extend(triangles_where(&mesh, |x| x[1] == 10.0));
    mesh.faces.push(NamedFaces { name: "SIDES".into(), triangles });
    // 1e-3 (z − 5)²
    let gap = "{quadratic: [0.025, 0, 0, -0.01, 0, 0, 1.0e-3, 0, 0, 0]}";
    let yaml = format!(
        "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{BLOCK: s}}\nsupports:\n  - {{face: \
         X0, law: contact, mu: {mu}, friction: associated, gap: {gap}}}\n  - {{face: X1, law: \
         contact, mu: {mu}, friction: associated, gap: {gap}}}\nrigid: [{{face: SIDES, \
         components: [x, y, z], free: [ux], at: [0, 0, 0], force: [100, 0, 0]}}]\nloads: []\n"
    );
    (yaml, mesh)
}

#[test]
fn contacts_that_exclude_each_other_are_named() {
    for mu in [0.0, 0.3] {
        let (yaml, mesh) = wedged(mu);
        let solved = solve_to(&yaml, mesh, &SolveOptions::default());
        let run = solved.pass.kinematic.as_ref().expect("asked for");
        println!("{mu}: {:?} {:?}", run.status, run.conflict);
        assert_eq!(run.status, SolveStatus::Infeasible);
        assert!(solved.pass.upper.is_none());
        let warnings = case_result("A", &solved.model, &solved.pass, None).warnings;
        assert!(
            warnings[0].to_string().starts_with(
                "the kinematic program has no solution, so there is no upper bound: the solver \
                 found"
            ) && warnings[0].to_string().ends_with(
                "check initial gaps and what holds the parts there, or refine the mesh there"
            ),
            "{warnings:?}"
        );
        assert_eq!(
            run.conflict.as_ref().map(ToString::to_string).as_deref(),
            Some(
                "the solver found no displacement on this mesh that satisfies the contacts `X0` \
                 (part BLOCK against the ground) and `X1` (part BLOCK against the ground) together"
            )
        );
    }
}

/// Multipliers that prove nothing name no contact.
#[test]
fn what_is_no_certificate_names_no_contact() {
    let (yaml, mesh) = wedged(0.3);
    let model = resolve(&yaml, mesh).expect("a sound model");
    let kinematic = Kinematic::new(&model).expect("it has a program");
    let contacts: Vec<usize> = kinematic.points.iter().map(|p| p.contact).collect();
    let conflict = |z: &[f64]| diagnosis::conflict(&model, &kinematic.program, &contacts, z);
    let rows = kinematic.program.h.len();
    // the first row of each cone with three rows
    let pressed =
        |size: f64| (0..rows).map(|r| if r % 3 == 0 { size } else { 0.0 }).collect::<Vec<f64>>();
    assert!(contacts.contains(&0) && contacts.contains(&1) && rows == 3 * contacts.len());
    for z in [
        vec![0.0; rows],
        pressed(1.0),
        pressed(-1.0),
        vec![1.0; rows],
        pressed(f64::NAN),
        pressed(1.0)[1..].to_vec(),
    ] {
        assert_eq!(conflict(&z), None);
    }
}

/// A further body without influence is not named.
#[test]
fn only_the_contacts_in_conflict_are_named() {
    let (yaml, mesh) = wedged(0.0);
    let mut other = Block::new([1, 1, 1], [10.0, 10.0, 10.0]);
    other.min = [100.0, 0.0, 0.0];
    other.max = [110.0, 10.0, 10.0];
    let mut other = other.mesh(&["OTHER"], |_| 0, |_, _| false);
    other.faces.retain(|f| f.name == "Z0" || f.name == "Z1");
    other.faces.iter_mut().for_each(|f| f.name = format!("OTHER_{}", f.name));
    let yaml = yaml
        .replace("{BLOCK: s}", "{BLOCK: s, OTHER: s}")
        .replace("supports:\n", "supports:\n  - {face: OTHER_Z0, law: contact, mu: 0.0}\n")
        .replace("loads: []", "loads: [{face: OTHER_Z1, traction: [0, 0, -1]}]");
    let solved = solve_to(&yaml, beside(mesh, other), &SolveOptions::default());
    let conflict = solved.pass.kinematic.and_then(|r| r.conflict).unwrap_or_default().to_string();
    assert!(
        conflict.contains("`X0`") && conflict.contains("`X1`") && !conflict.contains("OTHER"),
        "{conflict}"
    );
}
