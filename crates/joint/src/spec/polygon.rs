//! Capacity polygon of a connection spec: two actions at a member end, analysed in several
//! directions.

use super::loads::{Action, ActionPoint, LoadSpec};
use bracket_base::diag::AtLeastOne;
use bracket_base::units::{Force, Moment, limits};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Largest number of directions.
const MOST: u32 = 32;
/// Range of values that an action may have as the unit of its axis \[N, N mm\].
const SIZES: std::ops::RangeInclusive<f64> = 1.0..=1e12;

/// The capacity polygon of two actions at a member's end: what it carries of both at once, by limit
/// analysis in several directions (dead loads and other load cases have no part in it).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PolygonSpec {
    /// Member end the actions act on: `beam_right`.
    pub end: String,
    /// Where they act: the lever arm must be said.
    pub at: ActionPoint,
    /// Axial force along x′, as the unit of its axis: about what the joint carries of it, positive.
    #[serde(default, rename = "N", skip_serializing_if = "Option::is_none")]
    pub n: Option<Force>,
    /// Shear force along y′, likewise.
    #[serde(default, rename = "Vy", skip_serializing_if = "Option::is_none")]
    pub vy: Option<Force>,
    /// Shear force along z′, likewise.
    #[serde(default, rename = "Vz", skip_serializing_if = "Option::is_none")]
    pub vz: Option<Force>,
    /// Torsion, likewise.
    #[serde(default, rename = "T", skip_serializing_if = "Option::is_none")]
    pub t: Option<Moment>,
    /// Moment about y′ (strong axis), likewise.
    #[serde(default, rename = "My", skip_serializing_if = "Option::is_none")]
    pub my: Option<Moment>,
    /// Moment about z′ (weak axis), likewise.
    #[serde(default, rename = "Mz", skip_serializing_if = "Option::is_none")]
    pub mz: Option<Moment>,
    /// Directions all around, evenly spread where both units count alike: 4, 8, 12, … 32.
    #[serde(default = "eight")]
    pub directions: u32,
}

fn eight() -> u32 {
    8
}

/// A fault of a polygon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PolygonFault {
    /// YAML path.
    pub path: String,
    /// What is wrong.
    pub problem: String,
    /// Remedy.
    pub help: String,
}

/// One direction of a polygon.
#[derive(Clone, Debug, PartialEq)]
pub struct Direction {
    /// Name of its load case: `polygon_45`.
    pub case: String,
    /// The two actions in units of their axes; the vector has length 1.
    pub unit: [f64; 2],
}

impl PolygonSpec {
    /// The two actions and their units \[N, N mm\]. If exactly one of them is a moment, it comes
    /// first.
    ///
    /// `None` unless exactly two actions are given.
    pub fn axes(&self) -> Option<[(Action, f64); 2]> {
        let mut given = self.as_load().actions();
        given.sort_by_key(|(a, _)| !a.direction().1);
        <[(Action, f64); 2]>::try_from(given).ok()
    }

    /// The directions, from the first axis towards the second. Multiples of 90° are exact.
    pub fn directions(&self) -> Vec<Direction> {
        let n = self.directions;
        let quarter = (n / 4).max(1);
        (0..n)
            .map(|k| {
                let (s, c) = match k % quarter {
                    0 => (0.0, 1.0),
                    r => (2.0 * std::f64::consts::PI * f64::from(r) / f64::from(n)).sin_cos(),
                };
                let unit = match k / quarter {
                    0 => [c, s],
                    1 => [-s, c],
                    2 => [-c, -s],
                    _ => [s, -c],
                };
                let case = format!("polygon_{}", 360.0 * f64::from(k) / f64::from(n));
                Direction { case, unit: unit.map(|x| x + 0.0) }
            })
            .collect()
    }

    /// The load cases of the directions. `others` are the other loads of the spec. Every value that
    /// makes no sense is an error.
    pub fn loads(&self, others: &[LoadSpec]) -> Result<Vec<LoadSpec>, AtLeastOne<PolygonFault>> {
        let mut faults = Vec::new();
        let mut fault = |key: &str, problem: String, help: &str| {
            let path = if key.is_empty() { "polygon".into() } else { format!("polygon.{key}") };
            faults.push(PolygonFault { path, problem, help: help.into() });
        };
        let given = self.as_load().actions();
        for (action, size) in &given {
            let unit = if action.direction().1 { "N mm" } else { "N" };
            if !limits::within(*size, &SIZES) {
                let [least, most] = [SIZES.start(), SIZES.end()].map(|s| format!("{s:e} {unit}"));
                let problem = format!(
                    "`{0}` is {size:e} {unit}; the unit of an axis is positive, from {least} to \
                     {most}",
                    action.word()
                );
                fault(
                    action.word(),
                    problem,
                    "write about what the joint carries of this action alone",
                );
            }
        }
        if given.len() != 2 {
            let words: Vec<&str> = given.iter().map(|(a, _)| a.word()).collect();
            let named = if words.is_empty() { "none".into() } else { words.join(", ") };
            let problem =
                format!("a polygon is of two actions, {} are given: {named}", given.len());
            fault(
                "",
                problem,
                "give two of N, Vy, Vz, T, My, Mz with their units, for example `My: 100 kN m, N: \
                 200 kN`",
            );
        }
        if !(4..=MOST).contains(&self.directions) || !self.directions.is_multiple_of(4) {
            let problem = format!(
                "`directions` is {}, it must be a multiple of 4 from 4 to {MOST}",
                self.directions
            );
            fault("directions", problem, "8 shows the shape; every direction is a limit analysis");
        }
        AtLeastOne::refuse(faults)?;
        let Some([first, second]) = self.axes() else { return Ok(Vec::new()) };
        let mut out = Vec::new();
        for Direction { case, unit } in self.directions() {
            if let Some(i) = others.iter().position(|l| l.name == case) {
                let problem = format!("`{case}` is the name of a direction of the polygon");
                let help = "give the load case another name".into();
                let path = format!("loads[{i}].name");
                return Err(PolygonFault { path, problem, help }.into());
            }
            let mut load = LoadSpec {
                name: case,
                end: Some(self.end.clone()),
                at: Some(self.at),
                of_polygon: true,
                ..LoadSpec::default()
            };
            for ((action, size), part) in
                [first, second].into_iter().zip(unit).filter(|(_, part)| *part != 0.0)
            {
                load.set(action, part * size);
            }
            out.push(load);
        }
        Ok(out)
    }

    fn as_load(&self) -> LoadSpec {
        let Self { n, vy, vz, t, my, mz, .. } = *self;
        LoadSpec { n, vy, vz, t, my, mz, ..LoadSpec::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(rest: &str) -> PolygonSpec {
        serde_yaml::from_str(&format!("{{end: beam_right, at: column_face, {rest}}}"))
            .expect("reads")
    }

    #[test]
    fn directions_are_even_exact_on_the_axes_and_named_by_their_angle() {
        for n in [4, 8, 12, 16, 32] {
            let p = polygon(&format!("N: 200 kN, My: 100 kN m, directions: {n}"));
            assert_eq!(p.axes().expect("two").map(|a| a.0), [Action::My, Action::N]);
            let d = p.directions();
            let exact: Vec<[f64; 2]> =
                d.iter().map(|d| d.unit).filter(|u| u.contains(&0.0)).collect();
            assert_eq!(exact, [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]);
            for (k, d) in d.iter().enumerate() {
                let angle = 2.0 * std::f64::consts::PI * k as f64 / f64::from(n);
                assert!(
                    (d.unit[0] - angle.cos()).abs() < 1e-15
                        && (d.unit[1] - angle.sin()).abs() < 1e-15,
                    "{d:?}"
                );
            }
        }
        let loads = polygon("My: 100 kN m, N: 200 kN").loads(&[]).expect("sound");
        assert_eq!(loads.len(), 8);
        assert_eq!(
            (loads[0].name.as_str(), loads[0].actions()),
            ("polygon_0", vec![(Action::My, 1e8)])
        );
        assert_eq!(loads[2].actions(), [(Action::N, 2e5)]);
        assert_eq!(loads[6].actions(), [(Action::N, -2e5)]);
        let half = 0.5f64.sqrt();
        let [(first, n), (second, my)] = loads[3].actions()[..] else {
            panic!("two actions: {:?}", loads[3])
        };
        assert_eq!((first, second), (Action::N, Action::My));
        assert!((n / 2e5 - half).abs() < 1e-15 && (my / 1e8 + half).abs() < 1e-15, "{n} {my}");
    }

    #[test]
    fn wrong_values_are_refused_with_their_path() {
        for (rest, path, words) in [
            ("My: 100 kN m", "polygon", "1 are given: My"),
            ("directions: 8", "polygon", "0 are given: none"),
            ("My: 100 kN m, N: 1 kN, Vz: 1 kN", "polygon", "3 are given"),
            ("My: 0 kN m, N: 200 kN", "polygon.My", "positive"),
            ("My: -100 kN m, N: 200 kN", "polygon.My", "positive"),
            ("My: 100 kN m, N: 1e-9 kN", "polygon.N", "positive"),
            ("My: 1e12 kN m, N: 1 kN", "polygon.My", "positive"),
            ("My: 100 kN m, N: 1 kN, directions: 0", "polygon.directions", "multiple of 4"),
            ("My: 100 kN m, N: 1 kN, directions: 6", "polygon.directions", "multiple of 4"),
            ("My: 100 kN m, N: 1 kN, directions: 36", "polygon.directions", "from 4 to 32"),
        ] {
            let faults = polygon(rest).loads(&[]).expect_err(rest);
            assert!(
                faults.iter().any(|f| f.path == path && f.problem.contains(words)),
                "{rest}: {faults:?}"
            );
        }
        let mine = LoadSpec { name: "polygon_45".into(), ..LoadSpec::default() };
        let faults = polygon("My: 100 kN m, N: 1 kN").loads(&[mine]).expect_err("clash");
        assert_eq!(faults.first().path, "loads[0].name");
    }
}
