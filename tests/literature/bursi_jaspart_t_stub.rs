//! B15, F1: T-stubs, the beam model of EN 1993-1-8 (6.2.4, three modes) against solids.
//!
//! ```text
//!             ↑ F
//!           | |
//!   [head]  | |  [head]        a quarter: symmetry planes x = 0 (web) and y = 0; the flange rests on rigid ground without
//!  +-[  ]---+ +---[  ]-+       friction (the plane between two such T-stubs), bolts pass through holes as wide as they are
//!  |_[  ]_________[  ]_|  t    and are held at their feet
//!  ~~~~~~~~~~~~~~~~~~~~~
//!   n  |  m |   |
//! ```

use crate::common::grid::{Grid, even, joined, name};
use crate::common::limit::{run, strict};
use crate::common::solved;
use crate::common::yielding::FY;
use bracket::analysis::limit::{LimitPass, SUBDIVISIONS};
use bracket::assembly::Assembly;
use bracket::assembly::assembly::{
    FaceRule, InterfaceRule, MidPlane, OutlineEdge, Part, PartMaterial, PartRole, Solid, Surface,
    SymmetryPlane,
};
use bracket::certify::limit_certificate::dissipation_densities;
use bracket::mesh::joint::{MeshOptions, mesh_joint};
use bracket::model::AnalysisModel;
use bracket::spec::friction::FrictionLaw;
use std::collections::BTreeMap;

/// Part of the dissipation that is in bodies whose name starts with BOLT.
fn bolt_share(m: &AnalysisModel, pass: &LimitPass) -> f64 {
    let d = dissipation_densities(m, pass.velocity.as_ref().unwrap(), SUBDIVISIONS);
    let all: Vec<f64> = d.iter().enumerate().map(|(e, d)| d * m.mesh.volume(e)).collect();
    let is_bolt = |e: usize| m.mesh.bodies[m.mesh.tet_body[e] as usize].starts_with("BOLT");
    let bolts: f64 = all.iter().enumerate().filter(|(e, _)| is_bolt(*e)).map(|(_, d)| d).sum();
    bolts / all.iter().sum::<f64>()
}

/// Both bounds of the force \[kN\] and the bolts' share of the dissipation; loads are `force` \[N\]
/// at load factor 1.
fn forces(title: &str, m: &AnalysisModel, force: f64) -> ([f64; 2], f64) {
    let start = std::time::Instant::now();
    let pass = run(m);
    println!("{title}: {:.0} s", start.elapsed().as_secs_f64());
    let f = strict(&format!("{title}, {} tets", m.mesh.tets.len()), m, &pass)
        .map(|f| f * FY * force * 1e-3);
    let share = bolt_share(m, &pass);
    println!(
        "{title}: [{:.1}, {:.1}] kN, bolts {:.1} % of the dissipation",
        f[0],
        f[1],
        100.0 * share
    );
    (f, share)
}

/// B15: gauge 100, web 10, no fillet, width 160, length 100, m = 45, n = 30, f_y = 235; square
/// bolts of 12 mm with a strength of 100 kN and heads of 24 mm.
///
/// `n` cells across the flange from web to head and from head to tip, `layers` through its
/// thickness.
fn strip_t_stub(t: f64, n: usize, layers: usize) -> AnalysisModel {
    let x = joined(&[
        even(0.0, 5.0, 1),
        even(5.0, 38.0, n),
        even(38.0, 44.0, 1),
        even(44.0, 56.0, 2),
        even(56.0, 62.0, 1),
        even(62.0, 80.0, n.div_ceil(2)),
    ]);
    let y = joined(&[even(0.0, 6.0, 1), even(6.0, 12.0, 1), even(12.0, 50.0, n)]);
    let z = joined(&[even(0.0, t, layers), even(t, t + 12.0, 1), even(t + 12.0, t + 24.0, 1)]);
    let grid = Grid::new([x, y, z]).jittered(0.1, 5);
    let body = |c: [f64; 3]| {
        let off = (c[0] - 50.0).abs().max(c[1]);
        match () {
            () if off < 6.0 && c[2] < t + 12.0 => Some(1),
            () if c[2] < t => Some(0),
            () if off < 12.0 && c[2] < t + 12.0 => Some(1),
            () if c[0] < 5.0 => Some(0),
            () => None,
        }
    };
    let mut mesh =
        grid.mesh(&["T", "BOLT"], body, |axis, c| axis == 2 && (c - 0.5 * t).abs() < 1e-9);
    name(&mut mesh, "X0", "T", |p| p[0] == 0.0);
    name(&mut mesh, "Y0", "T", |p| p[1] == 0.0);
    name(&mut mesh, "YB", "BOLT", |p| p[1] == 0.0);
    name(&mut mesh, "GROUND", "T", |p| p[2] == 0.0);
    name(&mut mesh, "FOOT", "BOLT", |p| p[2] == 0.0);
    name(&mut mesh, "TOP", "T", |p| (p[2] - t - 24.0).abs() < 1e-9);
    let yaml = format!(
        "materials: {{s: {{E: 210000, nu: 0.3, fy: 235}}, b: {{E: 210000, nu: 0.3, fy: \
         {:?}}}}}\nbodies: {{T: s, BOLT: b}}\ninterfaces:\n- {{between: [T, BOLT], law: contact, \
         mu: 0}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: [y]}}\n- {{face: YB, \
         fix: [y]}}\n- {{face: GROUND, law: contact, mu: 0}}\n- {{face: FOOT, fix: \
         [z]}}\nloads:\n- {{face: TOP, traction: [0, 0, 1]}}\n",
        100e3 / 144.0
    );
    solved::resolve(&yaml, mesh).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The beam model's force \[kN\] of each mode for B15.
fn modes(t: f64) -> [f64; 3] {
    let (length, m, n, bolts) = (100.0, 45.0, 30.0, 200.0);
    let plastic = 0.25 * length * t * t * FY * 1e-3;
    [4.0 * plastic / m, (2.0 * plastic + n * bolts) / (m + n), bolts]
}

/// Modes 1, 2 and 3 of the beam model in this order as the flange gets thicker: 75.2, 177.9 and 200
/// kN. The solids show the order of the loads; their mechanisms are not told apart here (at t = 25
/// the bolts dissipate all of it, as in mode 3).
///
/// Tolerance: solids carry 1.00 to 1.35 times the beam model in modes 1 and 2 (a wide flange cannot
/// contract sideways, up to 2/√3; a head holds the flange nearer to the web than the bolt's axis,
/// EN 1993-1-8 table 6.2, method 2), the same in mode 3, where shanks yield in plain tension. The
/// bracket must overlap that range. At t = 12 those two effects bring mode 1 (up to 99 kN) near
/// mode 2 (102.6): the mechanism found may be either, so that only the forces are asked for.
fn mode(number: usize, t: f64, n: usize, layers: usize) -> [f64; 2] {
    let beam = modes(t)[number - 1];
    assert!(modes(t).iter().all(|f| *f >= beam), "mode {number} governs at t = {t}");
    // unit traction on 10 × 100
    let ([low, up], bolts) = forces(&format!("B15, t = {t}"), &strip_t_stub(t, n, layers), 1000.0);
    println!(
        "B15, t = {t}: {:.3} … {:.3} times the beam model's {beam:.1} kN",
        low / beam,
        up / beam
    );
    if number < 3 {
        assert!(low <= 1.35 * beam && up >= beam, "[{low}, {up}] against {beam}");
    } else {
        assert!(
            (low / beam - 1.0).abs() < 0.02 && (up / beam - 1.0).abs() < 0.02,
            "[{low}, {up}] against {beam}"
        );
        assert!(bolts > 0.9, "bolts alone yield in mode 3: {bolts}");
    }
    [low, up]
}

fn three_modes(n: usize, layers: usize) {
    let [one, two, three] =
        [(1, 12.0), (2, 25.0), (3, 40.0)].map(|(number, t)| mode(number, t, n, layers));
    assert!(
        one[1] < two[0] && two[0] < three[0] && two[1] < 1.01 * three[1],
        "{one:?} {two:?} {three:?}"
    );
}

#[test]
fn strip_t_stubs_fail_in_three_modes() {
    three_modes(2, 2);
}

#[test]
#[ignore = "heavy: minutes"]
fn strip_t_stubs_fail_in_three_modes_fine() {
    three_modes(4, 4);
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

fn part(
    name: &str,
    role: PartRole,
    material: &str,
    solid: Solid,
    convex: Vec<Solid>,
    size: f64,
) -> Part {
    Part {
        name: name.into(),
        label: name.to_lowercase(),
        role,
        material: material.into(),
        solid,
        convex,
        mid_planes: vec![],
        size,
    }
}

fn bottom(name: &str, part: &str) -> FaceRule {
    let surface =
        Surface::Plane { axis: 2, at: 0.0, min: [-75.0, -40.0, 0.0], max: [75.0, 40.0, 0.0] };
    FaceRule { name: name.into(), part: part.into(), surface, imprint: false }
}

/// Half of T-stub T1: IPE300, b_f 150, t_f 10.7, t_w 7.1, r 15, length 80; 4 M12 8.8 at gauge 90,
/// pitch 40.
fn bursi_jaspart(size: f64) -> Assembly {
    let (b, tf, w, r, top, length) = (75.0, 10.7, 3.55, 15.0, 50.7, 80.0);
    let line = |x: f64, z: f64| OutlineEdge::Line { to: [x, z] };
    let arc = |x: f64, z: f64, cx: f64| OutlineEdge::Arc { to: [x, z], centre: [cx, tf + r] };
    let edges = vec![
        line(b, 0.0),
        line(b, tf),
        line(w + r, tf),
        arc(w, tf + r, w + r),
        line(w, top),
        line(-w, top),
        line(-w, tf + r),
        arc(-w - r, tf, -w - r),
        line(-b, tf),
        line(-b, 0.0),
    ];
    let profile = Solid::Prism {
        origin: [0.0, 0.5 * length, 0.0],
        u: X,
        v: Z,
        start: [-b, 0.0],
        edges,
        length,
    };
    let places = [[45.0, 20.0], [45.0, -20.0], [-45.0, 20.0], [-45.0, -20.0]];
    let shank = |x: f64, y: f64| Solid::Cylinder {
        base: [x, y, 0.0],
        axis: Z,
        radius: 6.0,
        length: tf,
        segments: 12,
    };
    let mut cut = vec![profile];
    cut.extend(places.map(|[x, y]| shank(x, y)));
    let boxed = |min, max| Solid::Box { min, max };
    let convex = vec![
        boxed([-b, -0.5 * length, 0.0], [b, 0.5 * length, tf]),
        boxed([-w, -0.5 * length, tf], [w, 0.5 * length, top]),
    ];
    let mid = MidPlane { axis: 2, at: 0.5 * tf, min: [-b, -40.0, 0.0], max: [b, 40.0, 0.0] };
    let mut parts = vec![Part {
        mid_planes: vec![mid],
        ..part("T", PartRole::Plate, "flange", Solid::Difference(cut), convex, size)
    }];
    let mut interfaces = Vec::new();
    let mut faces = vec![bottom("GROUND", "T")];
    for (i, [x, y]) in places.into_iter().enumerate() {
        // M12: 18 mm across flats, head 7.5 mm
        let (e, h) = (18.0 / 3f64.sqrt(), 9.0);
        let p = [[e, 0.0], [e / 2.0, h], [-e / 2.0, h], [-e, 0.0], [-e / 2.0, -h], [e / 2.0, -h]];
        let edges = (1..=6).map(|i| OutlineEdge::Line { to: p[i % 6] }).collect();
        let head = Solid::Prism { origin: [x, y, tf], u: X, v: Y, start: p[0], edges, length: 7.5 };
        let solids = vec![shank(x, y), head];
        let name = format!("BOLT_{i}");
        parts.push(part(
            &name,
            PartRole::Bolt,
            "bolt",
            Solid::Union(solids.clone()),
            solids,
            size.min(8.0),
        ));
        faces.push(bottom(&format!("FOOT_{i}"), &name));
        let between = [name, "T".to_string()];
        interfaces.push(InterfaceRule {
            between,
            surface: None,
            mu: 0.0,
            friction: FrictionLaw::Associated,
            gap: 0.0,
        });
    }
    let top = Surface::Plane { axis: 2, at: top, min: [-w, -40.0, 0.0], max: [w, 40.0, 0.0] };
    faces.push(FaceRule { name: "TOP".into(), part: "T".into(), surface: top, imprint: false });
    let steel = |fy| PartMaterial { e: 210_000.0, nu: 0.3, fy: Some(fy) };
    Assembly {
        name: "t1".into(),
        parts,
        materials: BTreeMap::from([
            ("flange".to_string(), steel(431.0)),
            ("bolt".to_string(), steel(640.0)),
        ]),
        interfaces,
        faces,
        supports: vec![],
        loads: vec![],
        symmetry: vec![SymmetryPlane { axis: 0 }, SymmetryPlane { axis: 1 }],
        clearances: vec![],
        welds: vec![],
        preloads: vec![],
    }
}

/// F1: the limit load lies within 134 (beam model, mode 1: 4 M_pl/m with m = 29.45) and 160 kN.
///
/// Source: O. S. Bursi, J. P. Jaspart, Benchmarks for finite element modelling of bolted steel
/// connections, J. Construct. Steel Research 43 (1997): T-stub T1, flange f_y 431 (measured).
/// Bolts: nominal 640 MPa on the shank, 72.4 kN each. Preload drops out of limit analysis.
///
/// Tolerance: the range of the test; the bracket must overlap it, the bolts take only a part of the
/// dissipation.
fn t1(size: f64) {
    let folder = tempfile::tempdir().unwrap();
    let meshed =
        mesh_joint(&bursi_jaspart(size), &MeshOptions::new(folder.path()), &mut |_| {}).unwrap();
    let yaml = "materials: {flange: {E: 210000, nu: 0.3, fy: 431}, bolt: {E: 210000, nu: 0.3, fy: \
                640}}\nbodies: {T: flange, BOLT_0: bolt}\ninterfaces:\n- {between: [BOLT_0, T], \
                law: contact, mu: 0}\nsupports:\n- {face: SYM_X0, fix: [x]}\n- {face: SYM_Y0, \
                fix: [y]}\n- {face: GROUND, law: contact, mu: 0}\n- {face: FOOT_0, fix: \
                [z]}\nloads:\n- {face: TOP, traction: [0, 0, 1]}\n";
    let m = solved::resolve(yaml, meshed.mesh).unwrap_or_else(|e| panic!("{e:?}"));
    let ([low, up], share) = forces(&format!("F1, size {size}"), &m, 7.1 * 80.0);
    assert!(low <= 160.0 && up >= 134.0, "[{low}, {up}]");
    assert!(share < 0.5, "bolts {share}");
}

/// [146.8, 186.1] kN on 1 263 tets.
#[test]
#[ignore = "heavy: half a minute"]
fn t_stub_t1() {
    t1(12.0);
}
