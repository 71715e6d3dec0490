//! Spans that are meshed shorter than they are. They are stretched afterwards, so that their
//! elements are long.

use bracket::assembly::assembly::Solid;

/// Spans `from ≤ |x| ≤ to` that are meshed `factor` times shorter and stretched afterwards.
#[derive(Clone, Copy)]
pub struct Stretch {
    pub from: f64,
    pub to: f64,
    pub factor: f64,
}

impl Stretch {
    pub fn short(&self) -> f64 {
        (self.to - self.from) / self.factor
    }
}

/// Coordinate in the shortened joint.
pub fn shorten(stretch: &[Stretch], x: f64) -> f64 {
    let cut = |s: &Stretch| ((x.abs().min(s.to) - s.from).max(0.0)) * (1.0 - 1.0 / s.factor);
    x.signum() * (x.abs() - stretch.iter().map(cut).sum::<f64>())
}

/// The original coordinate of a shortened one. The stretches must be in ascending order.
pub fn lengthen(stretch: &[Stretch], x: f64) -> f64 {
    let mut at = x.abs();
    for s in stretch {
        at += (at - s.from).clamp(0.0, s.short()) * (s.factor - 1.0);
    }
    x.signum() * at
}

pub fn shorten_solid(s: &[Stretch], solid: &mut Solid) {
    match solid {
        Solid::Box { min, max } => [min, max].into_iter().for_each(|c| c[0] = shorten(s, c[0])),
        Solid::Prism { origin, u, v, length, .. } => {
            let along = bracket::math::vec3::cross(*u, *v)[0];
            let end = origin[0] + along * *length;
            let start = origin[0];
            origin[0] = shorten(s, start);
            if along.abs() > 0.5 {
                *length = (shorten(s, end) - origin[0]).abs();
            }
        }
        Solid::Cylinder { base, .. } => {
            assert_eq!(shorten(s, base[0]), base[0], "bolts lie outside stretched spans")
        }
        Solid::Union(list) | Solid::Difference(list) => {
            list.iter_mut().for_each(|x| shorten_solid(s, x))
        }
    }
}
