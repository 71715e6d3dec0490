//! Compares the component method over random joints with a second implementation, which was written
//! from the clauses in another language (`tests/independent/component_method.py`).

use crate::numbers::Numbers;
use bracket::catalog::{Catalog, IProfile};
use bracket::checks::component_method::joint::{Beam, Bolts, Column, EndPlateJoint, Plate};
use bracket::checks::component_method::{Assessment, Equilibrium, Summed, assess};
use serde_json::Value;
use std::io::Write;
use std::process::{Command, Stdio};

/// F_t,Rd [N], A_s [mm²], d [mm] of a bolt.
const BOLTS: [(f64, f64, f64); 6] = [
    (90_432.0, 157.0, 16.0),
    (141_120.0, 245.0, 20.0),
    (176_400.0, 245.0, 20.0),
    (203_328.0, 353.0, 24.0),
    (254_160.0, 353.0, 24.0),
    (269_280.0, 561.0, 30.0),
];

/// A random joint as in practice: sections of all series, one beam, two beams or a splice, end
/// plates flush or extended on one side or both, stiffeners, doublers, column ends near and far,
/// fillet and butt welds.
fn random_joint(n: &mut Numbers, profiles: &[&IProfile]) -> EndPlateJoint {
    let strength = [235.0, 275.0, 355.0, 460.0];
    let beam = n.of(profiles);
    let (tension, stress_area, d) = n.of(&BOLTS);
    let column = n.chance(0.85).then(|| n.of(profiles));
    let widest = column.map_or(f64::INFINITY, |c| c.b);
    let web = beam.tw.max(column.map_or(0.0, |c| c.tw + 1.7 * c.r));
    let width = (beam.b + n.between(0.0, 60.0)).max(web + 5.0 * d);
    let gauge = n.between(web + 2.2 * d, (widest.min(width) - 2.4 * d).max(web + 2.3 * d));
    let half = 0.5 * beam.h;
    let (flange_throat, web_throat) =
        if n.chance(0.8) { (n.between(3.0, 10.0), n.between(3.0, 6.0)) } else { (0.0, 0.0) };
    let clear = half - beam.tf - 1.7 * d - 1.2 * flange_throat;
    let mut rows = Vec::new();
    let extension = |rows: &mut Vec<f64>, n: &mut Numbers, sign: f64| {
        if n.chance(0.6) {
            rows.push(sign * (half + 1.2 * flange_throat + n.between(1.2, 2.5) * d));
            half + 1.2 * flange_throat + 6.0 * d
        } else {
            half + n.between(1.5 * flange_throat, 30.0)
        }
    };
    let (top, bottom) = (extension(&mut rows, n, 1.0), extension(&mut rows, n, -1.0));
    if clear > 0.0 {
        let mut z = clear - n.between(0.0, 0.3) * clear;
        let count = 1 + (n.unit() * 4.0) as usize;
        for _ in 0..count {
            rows.push(z);
            z -= n.between(2.3, 5.0) * d;
            if z < -clear {
                break;
            }
        }
        if n.chance(0.5) && z > -clear {
            rows.push(-clear);
        }
    }
    let column = column.map(|c| {
        let stiffener = if n.chance(0.4) { n.between(6.0, 20.0) } else { 0.0 };
        let doublers = if n.chance(0.2) { 1 } else { 0 };
        let fy = n.of(&strength);
        let end = |n: &mut Numbers| n.chance(0.3).then(|| top.max(bottom) + n.between(20.0, 400.0));
        Column {
            section: c.into(),
            fy,
            above: end(n),
            below: end(n),
            stiffener,
            stiffener_throat: if n.chance(0.5) { 4.0 } else { 0.0 },
            doublers,
            doubler_width: if doublers > 0 { 0.8 * c.h } else { 0.0 },
            longitudinal: if n.chance(0.3) { n.unit() * fy } else { 0.0 },
        }
    });
    let beta = if column.is_some() { n.of(&[0.0, 0.3, 0.7, 1.0, 1.5, 2.0]) } else { 0.0 };
    let plate_thickness = n.between(8.0, 35.0);
    EndPlateJoint {
        column,
        beam: Beam {
            section: beam.into(),
            fy: n.of(&strength),
            flange_throat,
            web_throat,
            shear: if n.chance(0.3) {
                n.between(0.0, 0.55) * beam.h * beam.tw * 235.0
            } else {
                0.0
            },
            sloped: None,
        },
        plate: Plate {
            thickness: plate_thickness,
            width,
            bottom: -bottom,
            top,
            fy: n.of(&strength[..3]),
        },
        bolts: Bolts {
            gauge,
            rows,
            tension,
            stress_area,
            elongation: plate_thickness + n.between(10.0, 40.0) + 1.2 * d,
            washer: if n.chance(0.2) { Some(1.8 * d) } else { None },
            always_prying: n.chance(0.3),
        },
        beta,
        young: 210_000.0,
        gamma_m0: n.of(&[1.0, 1.1]),
        gamma_m1: n.of(&[1.0, 1.1]),
        triangular: false,
    }
}

/// The results of the second implementation.
fn independent(joints: &[EndPlateJoint]) -> Vec<Value> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/independent/component_method.py");
    let mut python = Command::new("python3")
        .arg(script)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("python3 runs the second implementation");
    let input = serde_json::to_vec(joints).expect("JSON");
    let mut pipe = python.stdin.take().expect("a pipe");
    let writer = std::thread::spawn(move || pipe.write_all(&input).expect("python reads"));
    let output = python.wait_with_output().expect("python ends");
    writer.join().expect("written");
    assert!(output.status.success(), "the second implementation ended with {}", output.status);
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// Counts the compared values and records the largest difference.
#[derive(Default)]
struct Compared {
    count: usize,
    worst: f64,
}

impl Compared {
    fn near(&mut self, what: &str, joint: &EndPlateJoint, mine: f64, other: &Value) {
        let other = other.as_f64().unwrap_or_else(|| panic!("{what}: {mine} and no number"));
        let difference = (mine - other).abs() / mine.abs().max(other.abs()).max(1e3);
        self.count += 1;
        self.worst = self.worst.max(difference);
        assert!(
            difference <= 0.01,
            "{what}: {mine}, independently {other}, of {}",
            serde_json::json!(joint)
        );
    }
}

fn compare(
    joint: &EndPlateJoint,
    sense: &str,
    mine: &Assessment,
    other: &Value,
    seen: &mut Compared,
) {
    let sign = if sense == "bottom" { -1.0 } else { 1.0 };
    let rows = other["rows"]
        .as_array()
        .unwrap_or_else(|| panic!("{sense}: {other} of {}", serde_json::json!(joint)));
    assert_eq!(rows.len(), mine.rows.len(), "{sense} of {}", serde_json::json!(joint));
    for (r, row) in mine.rows.iter().zip(rows) {
        assert!(
            (sign * r.z - row["z"].as_f64().unwrap_or(f64::NAN)).abs() < 1e-9,
            "{sense}: rows in another order"
        );
        for c in &r.alone {
            let what = format!("{sense}, row at {}, {}", r.z, c.kind.words());
            seen.near(
                &what,
                joint,
                c.worked.value,
                &row[c.kind.words().replace(' ', "_").as_str()],
            );
        }
        seen.near(
            &format!("{sense}, row at {}, after groups", r.z),
            joint,
            r.grouped,
            &row["grouped"],
        );
        seen.near(&format!("{sense}, row at {}", r.z), joint, r.force, &row["force"]);
    }
    for (of, key) in [
        (Summed::ColumnWeb, "compression"),
        (Summed::BeamFlange, "beam_flange"),
        (Summed::Panel, "panel"),
    ] {
        match mine.limit(of) {
            Some(limit) => seen.near(&format!("{sense}, {key}"), joint, limit.value, &other[key]),
            None => assert!(other[key].is_null(), "{sense}, {key}: {}", other[key]),
        }
    }
    seen.near(&format!("{sense}, M_j,Rd"), joint, mine.moment.value, &other["moment"]);
    seen.near(
        &format!("{sense}, S_j,ini"),
        joint,
        mine.stiffness.initial.value,
        &other["stiffness"],
    );
}

/// Compares every component, the row forces, M_j,Rd, S_j,ini and N_j,Rd of 500 random joints in
/// both senses of bending. They agree within 1 %.
#[test]
fn random_joints_agree_with_the_second_implementation() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let series = ["IPE", "HEA", "HEB", "HEM", "UB", "UC", "W"];
    let fits =
        |p: &&IProfile| series.contains(&p.series.as_str()) && (180.0..=760.0).contains(&p.h);
    let profiles: Vec<&IProfile> = catalog.profiles().iter().filter(fits).collect();
    assert!(profiles.len() > 200, "{}", profiles.len());
    let mut n = Numbers(20);
    let joints: Vec<EndPlateJoint> = (0..500).map(|_| random_joint(&mut n, &profiles)).collect();
    let others = independent(&joints);
    let (mut seen, mut senses, mut axial) = (Compared::default(), 0, 0);
    for (joint, other) in joints.iter().zip(&others) {
        for (sense, turned) in [("top", joint.clone()), ("bottom", joint.mirrored())] {
            match assess(&turned) {
                Ok(mine) => {
                    senses += 1;
                    compare(joint, sense, &mine, &other[sense], &mut seen);
                }
                Err(why) => assert!(
                    other[sense].get("error").is_some(),
                    "{why}, but {} of {joint:?}",
                    other[sense]
                ),
            }
        }
        if other["n_tension"].is_null() {
            continue;
        }
        let e = Equilibrium::new(joint).expect("both senses are covered");
        axial += 1;
        seen.near("N_j,Rd in tension", joint, e.tension, &other["n_tension"]);
        seen.near("N_j,Rd in compression", joint, e.compression, &other["n_compression"]);
    }
    println!(
        "{} numbers of {senses} senses, {axial} N_j,Rd; largest difference {:.1e}",
        seen.count, seen.worst
    );
    assert!(senses >= 600 && axial >= 250, "{senses} senses, {axial} N_j,Rd were covered");
}

/// The second implementation reproduces its own published and closed-form cases.
#[test]
fn the_second_implementation_meets_its_published_cases() {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/independent/component_method.py");
    let ended = Command::new("python3").args([script, "--self-test"]).output().expect("python3");
    assert!(ended.status.success(), "{}", String::from_utf8_lossy(&ended.stdout));
}
