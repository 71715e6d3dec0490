//! The unit of an input is no property of the joint: specs with all lengths, forces and moments
//! rewritten in other units give the same verdict and numbers.

use crate::numbers::Numbers;
use bracket::assembly::Facts;
use bracket::catalog::Catalog;
use bracket::checks::design_code::build;
use bracket::checks::{Analysed, Check, HandChecks, hand_checks, judge};
use bracket::spec::connection::ConnectionSpec;
use bracket::yaml;
use std::path::Path;

/// Names of units with their factors to mm, N and N mm.
const LENGTHS: [(&str, f64); 5] =
    [("mm", 1.0), ("cm", 10.0), ("m", 1e3), ("in", 25.4), ("ft", 304.8)];
const POUND: f64 = 4.448_221_615_260_5;
const FORCES: [(&str, f64); 5] =
    [("N", 1.0), ("kN", 1e3), ("MN", 1e6), ("lbf", POUND), ("kip", 1e3 * POUND)];
const MOMENTS: [(&str, f64); 6] = [
    ("N mm", 1.0),
    ("kN m", 1e6),
    ("kN cm", 1e4),
    ("N m", 1e3),
    ("kip ft", 1e3 * POUND * 304.8),
    ("kip in", 1e3 * POUND * 25.4),
];

/// Writes quantities: in mm, N and N mm, or in units drawn anew for each.
struct Writer(Option<Numbers>);

impl Writer {
    fn write(&mut self, value: f64, units: &[(&'static str, f64)]) -> String {
        let (name, factor) = self.0.as_mut().map_or(units[0], |n| n.of(units));
        format!("{} {name}", value / factor)
    }

    fn mm(&mut self, value: f64) -> String {
        self.write(value, &LENGTHS)
    }

    fn list(&mut self, values: &[f64]) -> String {
        let each: Vec<String> = values.iter().map(|v| self.mm(*v)).collect();
        format!("[{}]", each.join(", "))
    }
}

/// A joint as numbers \[mm, N, N mm\].
struct Joint {
    splice: bool,
    /// A second beam under the same actions.
    double: bool,
    column: &'static str,
    beam: &'static str,
    steel: &'static str,
    thickness: f64,
    width: f64,
    z: [f64; 2],
    size: &'static str,
    grade: &'static str,
    gauge: f64,
    rows: Vec<f64>,
    parameters: Vec<(&'static str, f64)>,
    flags: Vec<&'static str>,
    actions: [f64; 3],
}

/// Columns with their widths, beams with depth, width and thickness of flange and web \[mm\].
const COLUMNS: [(&str, f64); 4] =
    [("HEB200", 200.0), ("HEA240", 240.0), ("HEB300", 300.0), ("HEM220", 226.0)];
const BEAMS: [(&str, [f64; 4]); 4] = [
    ("IPE240", [240.0, 120.0, 9.8, 6.2]),
    ("IPE300", [300.0, 150.0, 10.7, 7.1]),
    ("IPE400", [400.0, 180.0, 13.5, 8.6]),
    ("HEA300", [290.0, 300.0, 14.0, 8.5]),
];
/// Bolts with d, d0 and half of the width across the corners of the head \[mm\].
const BOLTS: [(&str, [f64; 3]); 5] = [
    ("M12", [12.0, 13.0, 10.4]),
    ("M14", [14.0, 15.0, 12.2]),
    ("M16", [16.0, 18.0, 13.9]),
    ("M20", [20.0, 22.0, 17.4]),
    ("M24", [24.0, 26.0, 20.8]),
];

impl Joint {
    /// A joint as in practice. A third of the distances stand exactly at limits of the code: end,
    /// edge and pitch at those of Table 3.3, throats of full strength, holes at the clearances of
    /// EN 1090-2, t at the limit of 6.4.2, ends of the column near the rows.
    fn random(n: &mut Numbers) -> Self {
        let splice = n.chance(0.3);
        let double = !splice && n.chance(0.3);
        let (column, of_column) = n.of(&COLUMNS);
        let (beam, [h, b, tf, tw]) = n.of(&BEAMS);
        let (size, [d, d0, head]) = n.of(&BOLTS);
        let (grade, fub): (_, f64) = n.of(&[("4.6", 400.0), ("8.8", 800.0), ("10.9", 1000.0)]);
        let (steel, fy, fu, beta): (_, f64, f64, f64) =
            n.of(&[("S235", 235.0, 360.0, 0.8), ("S355", 355.0, 490.0, 0.9)]);
        let exact = |n: &mut Numbers| n.chance(0.33);
        let e1 = if exact(n) { 1.2 * d0 } else { n.between(1.3, 2.5) * d0 };
        let e2 = if exact(n) { 1.2 * d0 } else { n.between(1.3, 2.0) * d0 };
        let thickness = match exact(n) {
            true => n.of(&[0.36 * d * (fub / fy).sqrt(), d / 1.9 * (fub / fy).sqrt(), d / 2.5]),
            false => n.of(&[10.0, 12.5, 15.0, 20.0, 25.4]),
        };
        let width = b + n.of(&[5.0, 10.0, 19.05, 30.0]);
        let gauge =
            (width - 2.0 * e2).min(if splice { width } else { of_column - 2.0 * head - 4.0 });
        let full = |t: f64| t * fy * beta * 1.25 / (2f64.sqrt() * fu);
        let flange = if exact(n) { full(tf) } else { n.of(&[0.0, 4.0, 6.35, 8.0]) };
        let web = if exact(n) { full(tw) } else { n.of(&[0.0, 3.0, 5.0]) };
        let clear = 0.5 * h - tf - 1.5 * flange - head - n.between(1.0, 12.0);
        let mut rows = vec![clear, -clear];
        if exact(n) && 2.2 * d0 < clear {
            rows.push(clear - 2.2 * d0);
        }
        let mut top = 0.5 * h + if flange > 0.0 { 1.5 * flange } else { 10.0 };
        let bottom = -top;
        if n.chance(0.5) {
            let outer = 0.5 * h + 1.5 * flange + head + n.between(1.0, 15.0);
            rows.push(outer);
            top = outer + e1;
        }
        let hole = n.of(&[0.0, 1.0, 2.0, 3.0, 4.0, 6.0, 7.5]);
        let mut parameters =
            vec![("flange_weld", flange), ("web_weld", web), ("hole_clearance", hole)];
        let mut flags = Vec::new();
        if !splice {
            let stiffener = n.of(&[3.1, 0.5 * (of_column - 9.0) / 13.0, 10.0, tf]);
            flags.push(n.of(&["column_stiffeners: true", "column_stiffeners: false"]));
            parameters.push(("column_stiffener_thickness", stiffener));
            parameters.push(("stiffener_weld", n.of(&[0.0, 4.0])));
            let below = -bottom + n.of(&[0.1, 0.2, 12.0, 100.0]);
            parameters.push(("column_above", top + n.of(&[0.1, 5.0, 6.3, 100.0])));
            parameters.push(("column_below", below));
            flags.push(n.of(&["column_ends_above: true", "column_ends_above: false"]));
            flags.push(n.of(&["column_ends_below: true", "column_ends_below: false"]));
        }
        let plastic = 1.1 * b * tf * h * fy;
        let shear = h * tw * fy / 3f64.sqrt();
        let actions = [
            n.of(&[0.0, 0.0, 0.0, 0.05, -0.05]) * 1.9 * b * tf * fy,
            n.of(&[0.0, -0.03, -0.1, 0.3]) * shear,
            n.of(&[0.02, -0.04, 0.08, 0.3]) * plastic,
        ];
        Self {
            splice,
            double,
            column,
            beam,
            steel,
            thickness,
            width,
            z: [bottom, top],
            size,
            grade,
            gauge,
            rows,
            parameters,
            flags,
            actions,
        }
    }

    /// The spec.
    fn text(&self, w: &mut Writer) -> String {
        let steel = self.steel;
        let (template, column) = match self.splice {
            true => ("beam_splice", String::new()),
            false => (
                "beam_to_column_end_plate",
                format!("column: {{profile: {}, steel: {steel}}}, ", self.column),
            ),
        };
        let mut parameters: Vec<String> =
            self.parameters.iter().map(|(name, v)| format!("{name}: {}", w.mm(*v))).collect();
        parameters.extend(self.flags.iter().map(|f| f.to_string()));
        if self.double {
            parameters.push("double_sided: true".into());
        }
        let [n, v, m] = self.actions;
        let mut load = |end: &str| {
            let [n, v, m] = [w.write(n, &FORCES), w.write(v, &FORCES), w.write(m, &MOMENTS)];
            format!("{{name: A, end: {end}, at: bolt_plane, N: {n}, Vz: {v}, My: {m}}}")
        };
        let mut loads = load("beam_right");
        if self.double {
            loads = format!("{loads}, {}", load("beam_left"));
        }
        format!(
            "template: {template}\nmembers: {{{column}beam: {{profile: {}, steel: {steel}}}}}\n\
             plate: {{thickness: {}, width: {}, z: {}}}\nbolts: {{size: {}, grade: \"{}\", gauge: \
             {}, rows: {}}}\nparameters: {{{}}}\nfriction: {{mu: 0}}\nloads: [{loads}]\n",
            self.beam,
            w.mm(self.thickness),
            w.mm(self.width),
            w.list(&self.z),
            self.size,
            self.grade,
            w.mm(self.gauge),
            w.list(&self.rows),
            parameters.join(", "),
        )
    }
}

/// The hand checks of a spec, or why it is refused.
fn checks(text: &str, catalog: &Catalog) -> Result<HandChecks, String> {
    let spec = yaml::parse::<ConnectionSpec>(text, Path::new("joint.yaml"))
        .unwrap_or_else(|e| panic!("{e:?}: {text}"));
    let joint =
        build(&spec, Path::new(""), catalog).map_err(|faults| faults.into_first().message)?;
    Ok(joint.facts.as_ref().and_then(Facts::end_plate).map(hand_checks).expect("an end plate"))
}

fn near(a: f64, b: f64) -> bool {
    // forces of less than 1 mN are rounding of zero
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) + 1e-3 * 1e-9 * 1e6
}

fn same(a: &Check, b: &Check) -> Result<(), String> {
    let name = |c: &Check| (c.title.text(), c.subject.text(), c.status, c.clause.clone());
    if name(a) != name(b) {
        return Err(format!("{:?} is not {:?}", name(a), name(b)));
    }
    let all = |c: &Check| -> Vec<Option<f64>> {
        let steps = c.values.iter().map(|s| Some(s.value));
        [c.demand, c.resistance, c.utilisation].into_iter().chain(steps).collect()
    };
    let (left, right) = (all(a), all(b));
    let equal = left.len() == right.len()
        && left.iter().zip(&right).all(|pair| match pair {
            (Some(a), Some(b)) => near(*a, *b),
            (a, b) => a.is_none() && b.is_none(),
        });
    if equal { Ok(()) } else { Err(format!("{a:?}\nis not\n{b:?}")) }
}

#[test]
fn units_change_no_verdict_and_no_number() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let (mut n, mut joints, mut numbers) = (Numbers(41), 0, 0);
    let mut verdicts = [0; 4];
    for drawn in 0..4000 {
        if joints == 300 {
            break;
        }
        let joint = Joint::random(&mut n);
        let (plain, other) =
            (joint.text(&mut Writer(None)), joint.text(&mut Writer(Some(Numbers(drawn)))));
        let (mut a, mut b) = match (checks(&plain, &catalog), checks(&other, &catalog)) {
            (Ok(a), Ok(b)) => (a, b),
            (Err(_), Err(_)) => continue,
            (a, b) => panic!("{:?}, {:?} of\n{plain}{other}", a.err(), b.err()),
        };
        joints += 1;
        let [one, two] = [&mut a, &mut b].map(|h| judge(h, &[Analysed::not("A")]).0);
        assert_eq!(one.verdict, two.verdict, "{}\n{}\n{plain}{other}", one.reason, two.reason);
        verdicts[one.verdict as usize % 4] += 1;
        let titles = |h: &HandChecks| -> Vec<(String, String)> {
            h.checks.iter().map(|c| (c.title.to_string(), c.subject.to_string())).collect()
        };
        let (left, right) = (titles(&a), titles(&b));
        let single = |a: &[(String, String)], b: &[(String, String)]| {
            a.iter().find(|t| !b.contains(t)).cloned()
        };
        let alone = [single(&left, &right), single(&right, &left)];
        assert_eq!(left.len(), right.len(), "{alone:?} of\n{plain}{other}");
        for (x, y) in a.checks.iter().zip(&b.checks) {
            numbers += 1;
            same(x, y).unwrap_or_else(|why| panic!("{why}\n{plain}{other}"));
        }
    }
    println!("{joints} joints, {numbers} checks, verdicts {verdicts:?}");
    assert_eq!(joints, 300);
    assert!(verdicts.iter().filter(|v| **v > 20).count() >= 2, "{verdicts:?}");
}
