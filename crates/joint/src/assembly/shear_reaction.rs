//! The reaction to shear and torsion that a plate on ground gives at its four edges: tractions that
//! are even along the edges, with their resultant in a given plane.

use super::assembly::{Action, FaceLoad, FaceRule, Surface};
use super::error::AssemblyError;
use super::evaluate::{block, identifier, within};
use super::extent::Extent;
use super::scope::Scope;
use super::template::ShearReactionEntry;
use bracket_base::math::vec3::{self, V3};

/// A torsion below this part of force times size is rounding.
const ROUNDING: f64 = 1e-12;

/// The edges of the plate of an entry.
pub(super) fn edges(entry: &ShearReactionEntry, scope: &Scope) -> Result<Edges, AssemblyError> {
    let at = "shear_reaction";
    let block = block(at, scope, &entry.block)?;
    let part = within(at, scope.text(&entry.part))?;
    let level = within(at, scope.length(&entry.level))?;
    let mut faces = Vec::new();
    for axis in [0, 1] {
        for (side, label) in ["M", "P"].into_iter().enumerate() {
            let (mut min, mut max) = ([0.0; 3], [0.0; 3]);
            for k in 0..3 {
                [min[k], max[k]] = if k == axis { [block[k][side]; 2] } else { block[k] };
            }
            faces.push(FaceRule {
                name: identifier(at, format!("EDGE_{}{label}", ["X", "Y"][axis]))?,
                part: part.clone(),
                surface: Surface::Plane { axis, at: block[axis][side], min, max },
                imprint: false,
            });
        }
    }
    Ok(Edges { block, level, faces })
}

/// The edges of a plate that lies in x and y.
pub(super) struct Edges {
    /// The plate.
    block: Extent,
    /// Height of the plane of the resultant \[mm\].
    level: f64,
    /// Their faces.
    pub faces: Vec<FaceRule>,
}

impl Edges {
    /// What balances force and torsion of the loads on other faces, case by case; a constant
    /// traction is not among them, because its template has no such plate.
    pub(super) fn reactions(&self, loads: &[FaceLoad]) -> Vec<FaceLoad> {
        let mut sums: Vec<(&str, bool, V3, f64)> = Vec::new();
        for load in loads {
            let Action::Resultant { at, force, moment } = load.action else { continue };
            let torsion = moment[2] + vec3::cross(vec3::sub(at, self.centre()), force)[2];
            match sums.iter_mut().find(|s| s.0 == load.case && s.1 == load.dead) {
                Some(s) => (s.2, s.3) = (vec3::add(s.2, force), s.3 + torsion),
                None => sums.push((&load.case, load.dead, force, torsion)),
            }
        }
        let on_faces = |(case, dead, force, torsion): (&str, bool, V3, f64)| {
            let action = self.action(force, torsion);
            let on_face = move |face: &FaceRule| FaceLoad {
                face: face.name.clone(),
                case: case.to_owned(),
                action,
                dead,
            };
            self.faces.iter().map(on_face).collect::<Vec<_>>()
        };
        let acts = |s: &(&str, bool, V3, f64)| s.2[0] != 0.0 || s.2[1] != 0.0 || s.3 != 0.0;
        sums.into_iter().filter(acts).flat_map(on_faces).collect()
    }

    /// Middle of the plate in the plane of the resultant.
    fn centre(&self) -> V3 {
        let middle = |k: usize| 0.5 * (self.block[k][0] + self.block[k][1]);
        [middle(0), middle(1), self.level]
    }

    /// The traction that balances a force in the plane and a torsion about the plate's middle.
    ///
    /// Of the force, it is even along each edge and linear over the height h, `f(z) = 1 − 12 e (z −
    /// z_m)/h²` with e the height of the middle z_m above the plane of the resultant, so that
    /// ∫ f dz = h and ∫ f (z − level) dz = 0. Of the torsion it is `k (−y, x)` from the middle,
    /// with k the torsion over the polar moment of the edges.
    fn action(&self, force: V3, torsion: f64) -> Action {
        let [a, b, h] = self.block.map(|[low, high]| high - low);
        let [cx, cy, _] = self.centre();
        let middle = 0.5 * (self.block[2][0] + self.block[2][1]);
        let area = 2.0 * (a + b) * h;
        let slope = -12.0 * (middle - self.level) / (h * h);
        // two edges of each direction: their distance from the middle, and along them
        let polar = h * (b * a * a + b.powi(3) / 3.0 + a * b * b + a.powi(3) / 3.0) / 2.0;
        let size = (force[0].abs() + force[1].abs()) * (a + b);
        let k = if torsion.abs() > ROUNDING * size { -torsion / polar } else { 0.0 };
        let even = [-force[0] / area, -force[1] / area];
        let mut gradient = [[0.0; 3]; 3];
        (gradient[0][2], gradient[1][2]) = (slope * even[0], slope * even[1]);
        (gradient[0][1], gradient[1][0]) = (-k, k);
        let at_origin = 1.0 - slope * middle;
        let traction0 = [even[0] * at_origin + k * cy, even[1] * at_origin - k * cx, 0.0];
        Action::Linear { traction0, gradient }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Force and moment about the origin of the tractions on the faces, by Gauss points.
    fn resultant(edges: &Edges, action: Action) -> (V3, V3) {
        let Action::Linear { traction0, gradient } = action else { panic!("{action:?}") };
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        let points = [-(0.6_f64.sqrt()), 0.0, 0.6_f64.sqrt()].into_iter().zip([5.0, 8.0, 5.0]);
        for face in &edges.faces {
            let Surface::Plane { axis, min, max, .. } = face.surface else { panic!() };
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            for (p, wp) in points.clone() {
                for (q, wq) in points.clone() {
                    let mut x = min;
                    x[u] = 0.5 * (min[u] + max[u] + p * (max[u] - min[u]));
                    x[v] = 0.5 * (min[v] + max[v] + q * (max[v] - min[v]));
                    let share = (max[u] - min[u]) * (max[v] - min[v]) * wp * wq / 324.0;
                    let t = vec3::add(traction0, vec3::mul(&gradient, x));
                    force = vec3::along(force, share, t);
                    moment = vec3::along(moment, share, vec3::cross(x, t));
                }
            }
        }
        (force, moment)
    }

    #[test]
    fn the_edges_balance_shear_and_torsion_in_the_plane_of_the_resultant() {
        let scope = Scope::default();
        let entry = ShearReactionEntry {
            part: "PLATE".into(),
            block: serde_json::from_str(r#"{"x": [-150, 230], "y": [-120, 140], "z": [4, 29]}"#)
                .expect("lengths"),
            level: serde_json::from_str("1.5").expect("a length"),
        };
        let edges = edges(&entry, &scope).expect("numbers");
        assert_eq!(edges.faces.len(), 4);
        let load = |at, force, moment| FaceLoad {
            face: "END".into(),
            case: "A".into(),
            action: Action::Resultant { at, force, moment },
            dead: false,
        };
        let loads = [
            load([0.0, 10.0, 300.0], [20e3, -7e3, -400e3], [1e6, 2e6, 3e5]),
            load([30.0, -8.0, 200.0], [-5e3, 1e3, 10e3], [0.0, 0.0, -9e5]),
        ];
        let reactions = edges.reactions(&loads);
        assert_eq!(reactions.len(), 4);
        let (force, moment) = resultant(&edges, reactions[0].action);
        for (got, right) in force.into_iter().zip([-15e3, 6e3, 0.0]) {
            assert!((got - right).abs() < 1e-6, "{force:?}");
        }
        // about the origin, with the forces in the plane z = 1.5
        let torsion = 3e5 - 10.0 * 20e3 - 9e5 - 8.0 * 5e3 + 30.0 * 1e3;
        for (got, right) in moment.into_iter().zip([-1.5 * 6e3, -1.5 * 15e3, -torsion]) {
            assert!((got - right).abs() < 1e-4, "{moment:?} {right}");
        }
        let along = [load([40.0, 10.0, 0.0], [9.0, 0.0, 1.0], [5.0, 5.0, 0.0])];
        for reaction in edges.reactions(&along) {
            let Action::Linear { gradient, .. } = reaction.action else { panic!() };
            assert_eq!([gradient[0][1], gradient[1][0]], [0.0; 2], "no torsion");
        }
        let idle = [load([0.0, 10.0, 0.0], [0.0, 0.0, 1.0], [5.0, 5.0, 0.0])];
        assert!(edges.reactions(&idle).is_empty());
    }
}
