use super::*;
use crate::design_code;
use bracket_base::words::Text;
use bracket_base::yaml;
use bracket_joint::assembly::Joint;
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::connection::ConnectionSpec;
use std::path::Path;

const SPEC: &str = include_str!("../../../../examples/splice_extended/joint.yaml");

fn joint(text: &str) -> Joint {
    let spec = yaml::parse::<ConnectionSpec>(text, Path::new("joint.yaml")).expect("a spec");
    let catalog = Catalog::builtin().expect("the shipped catalogue");
    design_code::build(&spec, Path::new("."), &catalog).expect("a joint")
}

/// Forces of every bolt: the same tension and shear by both fields, but for a difference.
fn bolts(facts: &RouteFacts, tension: f64, shear: f64, apart: f64) -> Vec<BoltSections> {
    let of = |(grip, _): &(bracket_joint::assembly::assembly::Grip, _)| {
        let force = |n: f64| grip.axis.map(|a| n * a);
        let mut by_stress = force(tension);
        by_stress[2] += shear;
        let mut by_displacement = force(tension - apart);
        by_displacement[2] += shear;
        let section =
            SectionForce { by_stress: Some(by_stress), by_displacement: Some(by_displacement) };
        BoltSections { bolt: grip.part.clone(), sections: vec![section] }
    };
    facts.bolts.iter().map(of).collect()
}

fn plate(membrane: f64) -> PlateStrain {
    PlateStrain {
        part: "PLATE_R".into(),
        thickness: 20.0,
        membrane,
        membrane_at: [0.0; 3],
        surface: 0.0,
        surface_at: [0.0; 3],
    }
}

fn mode(factor: f64) -> CriticalMode {
    CriticalMode {
        factor,
        part: "BEAM_R".into(),
        share: 1.0,
        at: [0.0; 3],
        antisymmetric: Vec::new(),
    }
}

/// Evidence that holds: two meshes, small strains.
fn meshes(facts: &RouteFacts) -> Vec<Evidence> {
    let one = |tets, membrane| Evidence {
        tets,
        bolts: bolts(facts, 50e3, 10e3, 1e3),
        plates: vec![plate(membrane)],
        welds: Vec::new(),
    };
    vec![one(1000, 0.01), one(1500, 0.012)]
}

fn critical(coarse: f64, fine: f64) -> CriticalFactors {
    CriticalFactors { coarse: vec![mode(coarse)], fine: vec![mode(fine)] }
}

fn found<'a>(meshes: &'a [Evidence], critical: &'a CriticalFactors) -> Found<'a> {
    Found { lower: Some(1.2), copies: 1, meshes, critical: Some(critical), critical_unknown: None }
}

fn state(steps: &[RouteStep], id: StepId) -> StepState {
    steps.iter().find(|s| s.step == id).expect("a step").state
}

/// Every step holds; the values are those of the formulas by hand.
#[test]
fn a_complete_route() {
    let facts = RouteFacts::of(&joint(SPEC));
    let (meshes, critical) = (meshes(&facts), critical(20.0, 17.0));
    let steps = steps(&facts, found(&meshes, &critical));
    assert!(is_complete(&steps), "{steps:#?}");
    let of = |id| steps.iter().find(|s: &&RouteStep| s.step == id).expect("a step");
    // N = 50 + 1 kN, V = 10 kN of the bolt: V/F_v + N/(1.4 F_t), each field by itself
    let (_, limits) = &facts.bolts[0];
    let both = of(StepId::Bolts).uses.iter().find(|u| u.unit == crate::Unit::Number);
    let stress = 10e3 / limits.shear + 50e3 / (1.4 * limits.tension);
    let apart = 1e3 / (1.4 * limits.tension);
    assert!((both.expect("a row").value - (stress + apart)).abs() < 1e-12);
    // strain: 1.2 % and the difference of the meshes, of 5 %
    let strain = of(StepId::Strain).utilisation.expect("a value");
    assert!((strain - (0.012 + 0.002) / 0.05).abs() < 1e-12);
    // α_cr = 0.95 (17 − (20 − 17)/3) = 15.2, α_ult,k = 1.2, λ̄ = 0.281: ρ = 0.958 of curve c
    let buckling = of(StepId::Stability).utilisation.expect("a value");
    assert!((buckling - 1.0 / (1.2 * 0.958)).abs() < 1e-3, "{buckling}");
    assert_eq!(of(StepId::Strength).state, StepState::Proved);
    assert_eq!(of(StepId::Bolts).state, StepState::Estimated);
}

/// What is missing, too large or not converged leaves its step open, and no step but its own.
#[test]
fn each_step_opens_alone() {
    let facts = RouteFacts::of(&joint(SPEC));
    let good = meshes(&facts);
    let stable = critical(20.0, 17.0);
    let only_open = |found: Found<'_>, id: StepId| {
        let steps = steps(&facts, found);
        for s in &steps {
            assert_eq!(s.holds(), s.step != id, "{s:#?}");
            assert_eq!(s.next.is_some(), s.step == id);
        }
        assert!(!is_complete(&steps));
    };
    let with = |change: &dyn Fn(&mut Evidence)| {
        let mut meshes = good.clone();
        change(&mut meshes[1]);
        meshes
    };
    let (_, limits) = &facts.bolts[0];
    // more than the bolt carries; two fields that differ by more than 5 % of the resistance; one
    // field alone; a bolt without forces
    let (tension, apart) = (1.01 * limits.tension, 0.06 * limits.tension);
    let pulled = with(&|e| e.bolts = bolts(&facts, tension, 0.0, 0.0));
    only_open(found(&pulled, &stable), StepId::Bolts);
    let vague = with(&|e| e.bolts = bolts(&facts, 50e3, 0.0, apart));
    only_open(found(&vague, &stable), StepId::Bolts);
    // unless the displacement of a coarser mesh gives the same forces; the difference still counts
    let mut converged = vague.clone();
    let moved = 0.025 * limits.tension;
    converged[0].bolts = bolts(&facts, 50e3 + moved, 0.0, apart);
    let steps_of = steps(&facts, found(&converged, &stable));
    assert!(is_complete(&steps_of), "{steps_of:#?}");
    converged[0].bolts = bolts(&facts, 50e3 + 2.0 * moved, 0.0, apart);
    only_open(found(&converged, &stable), StepId::Bolts);
    let half = with(&|e| e.bolts[0].sections[0].by_displacement = None);
    only_open(found(&half, &stable), StepId::Bolts);
    let lacking = with(&|e| _ = e.bolts.pop());
    only_open(found(&lacking, &stable), StepId::Bolts);
    // a copy of the meshed part has the bolts that the part lacks
    let mirrored = with(&|e| e.bolts.truncate(facts.bolts.len() / 2));
    let two = Found { copies: 2, ..found(&mirrored, &stable) };
    assert!(is_complete(&steps(&facts, two)));
    // strains beyond 5 %, not converged, not a number, of one mesh
    for membrane in [0.049, 0.025, f64::NAN] {
        let strained = with(&|e| e.plates[0].membrane = membrane);
        only_open(found(&strained, &stable), StepId::Strain);
    }
    only_open(found(&good[1..], &stable), StepId::Strain);
    let same = with(&|e| e.tets = 1000);
    only_open(found(&same, &stable), StepId::Strain);
    // buckling: too low, or unknown
    only_open(found(&good, &critical(3.0, 1.5)), StepId::Stability);
    let apart = critical(30.0, 2.0);
    only_open(found(&good, &apart), StepId::Stability);
    let told = steps(&facts, found(&good, &apart));
    let step = told.iter().find(|s| s.step == StepId::Stability).expect("a step");
    assert_eq!(step.finding, "the critical factor is 30 on the mesh, 2 on one twice as fine");
    let fine_alone = CriticalFactors { coarse: Vec::new(), fine: vec![mode(20.0)] };
    only_open(found(&good, &fine_alone), StepId::Stability);
    let (none, why) = (Found { critical: None, ..found(&good, &stable) }, Text::given("no memory"));
    only_open(none, StepId::Stability);
    let told = steps(&facts, Found { critical_unknown: Some(&why), ..none });
    let step = told.iter().find(|s| s.step == StepId::Stability).expect("a step");
    assert_eq!(step.finding, "the critical factor is not known: no memory");
    let none = CriticalFactors { coarse: Vec::new(), fine: Vec::new() };
    assert!(is_complete(&steps(&facts, found(&good, &none))));
    // without hand checks the lower bound needs a reserve
    let own = RouteFacts { hand_checked: false, ..facts.clone() };
    for (lower, holds) in [(1.11, false), (1.13, true)] {
        let steps = steps(&own, Found { lower: Some(lower), ..found(&good, &stable) });
        assert_eq!(state(&steps, StepId::Strength) != StepState::Open, holds);
    }
    // a lower bound below the load
    let steps = steps(&facts, Found { lower: Some(0.99), ..found(&good, &stable) });
    assert_eq!(state(&steps, StepId::Strength), StepState::Open);
}

/// Steels and bolts that the rules do not cover keep the route open.
#[test]
fn the_route_stays_in_the_range_of_the_rules() {
    let scope = |facts: &RouteFacts| {
        let (meshes, critical) = (meshes(facts), critical(20.0, 17.0));
        state(&steps(facts, found(&meshes, &critical)), StepId::Scope)
    };
    let good = RouteFacts::of(&joint(SPEC));
    assert_eq!(scope(&good), StepState::Proved);
    let change = |edit: &dyn Fn(&mut RouteFacts)| {
        let mut facts = good.clone();
        edit(&mut facts);
        scope(&facts)
    };
    use bracket_joint::strength::Nominal;
    let steel = |fy, fu| [Nominal::new(fy), Nominal::new(fu)];
    assert_eq!(change(&|f| f.steels[0].1 = steel(690.0, 770.0)), StepState::Open);
    assert_eq!(change(&|f| f.steels[0].1 = steel(355.0, 380.0)), StepState::Open);
    assert_eq!(change(&|f| f.bolts[0].0.grade.fub = 1200.0), StepState::Open);
    assert_eq!(change(&|f| f.bolts[0].0.hole = 60.0), StepState::Open);
    assert_eq!(change(&|f| f.bolts[0].1.bearing[0] = None), StepState::Open);
}

/// The next mesh: none for a load that nothing carries, a coarser one to compare with, a finer one
/// where the fields are too far apart.
#[test]
fn what_the_next_mesh_is_for() {
    let facts = RouteFacts::of(&joint(SPEC));
    let good = meshes(&facts);
    let (_, limits) = &facts.bolts[0];
    let pulled = |tension: f64, apart: f64| {
        let mut meshes = good.clone();
        meshes[1].bolts = bolts(&facts, tension * limits.tension, 0.0, apart * limits.tension);
        meshes
    };
    let next = |meshes: &[Evidence]| next_mesh(&facts, 1, meshes);
    assert_eq!(next(&good), NextMesh::None);
    assert_eq!(next(&[]), NextMesh::Finer);
    assert_eq!(next(&good[1..]), NextMesh::Coarser);
    assert_eq!(next(&pulled(0.5, 0.06)[1..]), NextMesh::Coarser);
    // above the resistance with the difference of the fields, below it without
    assert_eq!(next(&pulled(0.98, 0.03)[1..]), NextMesh::Finer);
    assert_eq!(next(&pulled(0.98, 0.03)), NextMesh::Finer);
    assert_eq!(next(&pulled(1.05, 0.02)[1..]), NextMesh::Hopeless);
}
