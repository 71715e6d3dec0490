//! The static super-element: a tetrahedron split at its centroid into 4 subtets with linear stress
//! in each.
//!
//! Self-equilibrated, traction-continuous stress fields have 30 parameters (of 96), one-to-one with
//! the 36 − 6 self-equilibrated linear tractions on the outer faces. Their basis is computed once,
//! on the reference tetrahedron: the Piola map `σ = J σ̂ Jᵀ / det J` carries it to every element,
//! so an element costs one 30 × 30 Cholesky factor.
//!
//! # Shape
//! Points are `[subtet k][p]`: subtet k holds the outer face opposite macro vertex k, p = 0, 1, 2
//! its vertices in [`FACES`] order, p = 3 the centroid. Tractions are `9 k + 3 p + d` (face, vertex
//! in [`FACES`] order, component).

use crate::elements::geometry::{centroid, jacobian};
use crate::elements::stress_basis::reference;
pub use crate::elements::stress_basis::{PARAMETERS, TRACTIONS};
use crate::elements::stress_maps;
use crate::mesh::tet::FACES;
use bracket_base::math::dense::Cholesky;
use bracket_base::math::mandel::{self, Isotropic, Mandel};
use bracket_base::math::quadrature::{tetrahedron_mass, triangle_mass};
use bracket_base::math::vec3::{self, M3, V3};

/// Stress at the 4 points of each of the 4 subtets.
pub type PointStress = [[Mandel; 4]; 4];

/// `N_eᵀ (∫ C⁻¹) N_e`, from the columns of the Piola map.
fn flexibility(
    columns: &[Mandel; 6],
    volume: f64,
    material: &Isotropic,
) -> Box<[[f64; PARAMETERS]; PARAMETERS]> {
    let strained = columns.map(|c| material.strain(&c));
    let mut f = Box::new([[0.0; PARAMETERS]; PARAMETERS]);
    let mut entry = 0;
    for i in 0..6 {
        for j in i..6 {
            let g = 0.25 * volume * mandel::dot(&columns[i], &strained[j]);
            for (row, h) in f.iter_mut().zip(reference().flexibility[entry].iter()) {
                for (x, y) in row.iter_mut().zip(h) {
                    *x += g * y;
                }
            }
            entry += 1;
        }
    }
    f
}

/// One super-element with its factored flexibility.
pub struct SuperElement {
    corners: [V3; 4],
    jacobian: M3,
    piola: [Mandel; 6],
    factor: Cholesky<PARAMETERS>,
    material: Isotropic,
    volume: f64,
    /// Constant body force and the point its particular stress vanishes at.
    body_force: Option<(V3, V3)>,
    /// `N_eᵀ ∫ C⁻¹ σ_p`.
    particular_flexibility: [f64; PARAMETERS],
}

/// Element matrix of order 36.
pub type Matrix36 = Box<[[f64; TRACTIONS]; TRACTIONS]>;

impl SuperElement {
    /// Sets up the element; `None` when its shape is so poor that its flexibility is not positive
    /// definite in floating point. `body_force` \[N/mm³\] with the origin of its particular stress
    /// `−diag(b_i (x_i − origin_i))`.
    pub fn new(
        corners: [V3; 4],
        material: Isotropic,
        body_force: Option<(V3, V3)>,
    ) -> Option<Self> {
        let (j, _, det) = jacobian(&corners);
        let piola = mandel::piola(&j, det);
        let volume = det / 6.0;
        let r = reference();
        // transformed compliance G = Pᵀ C⁻¹ P
        let columns: [Mandel; 6] =
            std::array::from_fn(|c| std::array::from_fn(|row| piola[row][c]));
        let factor = Cholesky::new(flexibility(&columns, volume, &material))?;
        let mut element = Self {
            corners,
            jacobian: j,
            piola,
            factor,
            material,
            volume,
            body_force,
            particular_flexibility: [0.0; PARAMETERS],
        };
        if body_force.is_some() {
            let s = element.particular();
            let strains = s.map(|t| t.map(|x| material.strain(&x)));
            // transform the strain back to the reference basis: N̂ᵀ Pᵀ ε
            for k in 0..4 {
                for p in 0..4 {
                    let mut e = [0.0; 6];
                    for b in 0..4 {
                        let m = 0.25 * volume * tetrahedron_mass(p, b);
                        (0..6).for_each(|c| e[c] += m * strains[k][b][c]);
                    }
                    let back: Mandel = std::array::from_fn(|c| mandel::dot(&columns[c], &e));
                    for a in 0..PARAMETERS {
                        element.particular_flexibility[a] += mandel::dot(&r.basis[k][p][a], &back);
                    }
                }
            }
        }
        Some(element)
    }

    /// Coordinates of the points.
    pub fn points(corners: &[V3; 4]) -> [[V3; 4]; 4] {
        let c = centroid(corners);
        std::array::from_fn(|k| {
            [corners[FACES[k][0]], corners[FACES[k][1]], corners[FACES[k][2]], c]
        })
    }

    /// Particular stress of the body force, `−diag(b_i (x_i − origin_i))`; zero without one.
    pub fn particular(&self) -> PointStress {
        let Some((b, origin)) = self.body_force else { return [[[0.0; 6]; 4]; 4] };
        Self::points(&self.corners).map(|t| {
            t.map(|x| {
                let d = vec3::sub(x, origin);
                [-b[0] * d[0], -b[1] * d[1], -b[2] * d[2], 0.0, 0.0, 0.0]
            })
        })
    }

    /// Flexibility `F` of the parameters.
    pub fn flexibility(&self) -> Box<[[f64; PARAMETERS]; PARAMETERS]> {
        let columns: [Mandel; 6] =
            std::array::from_fn(|c| std::array::from_fn(|row| self.piola[row][c]));
        flexibility(&columns, self.volume, &self.material)
    }

    /// Mass-weighted outer tractions of each parameter, `T` as `[traction][parameter]`; no body
    /// force.
    pub fn traction_matrix(&self) -> Box<[[f64; PARAMETERS]; TRACTIONS]> {
        let r = reference();
        let mut t = Box::new([[0.0; PARAMETERS]; TRACTIONS]);
        for q in 0..12 {
            for a in 0..PARAMETERS {
                let local = std::array::from_fn(|c| r.traction[3 * q + c][a]);
                let w = vec3::mul(&self.jacobian, local);
                (0..3).for_each(|d| t[3 * q + d][a] = w[d]);
            }
        }
        t
    }

    /// The numbers of [`super::stress_maps`] for parameters in the given unit.
    pub fn map_numbers(&self, unit: f64, radius: f64) -> Vec<f64> {
        stress_maps::numbers(&self.jacobian, &self.piola, unit, radius)
    }

    /// Stress of each parameter at point `p` of subtet `k`; no body force.
    pub fn stress_columns(&self, k: usize, p: usize) -> [Mandel; PARAMETERS] {
        reference().basis[k][p].map(|hat| mandel::mul(&self.piola, &hat))
    }

    /// Stiffness `T F⁻¹ Tᵀ` on the mass-weighted tractions' conjugate displacements.
    pub fn stiffness(&self) -> Matrix36 {
        let r = reference();
        let mut y = Box::new([[0.0; TRACTIONS]; PARAMETERS]);
        for a in 0..PARAMETERS {
            for t in 0..TRACTIONS {
                y[a][t] = r.traction[t][a];
            }
        }
        self.factor.forward(&mut y);
        // rotate: row 3q + d of T is Σ_c J[d][c] T̂[3q + c]
        let mut z = Box::new([[0.0; TRACTIONS]; PARAMETERS]);
        for a in 0..PARAMETERS {
            for q in 0..12 {
                let v = [y[a][3 * q], y[a][3 * q + 1], y[a][3 * q + 2]];
                let w = vec3::mul(&self.jacobian, v);
                z[a][3 * q..3 * q + 3].copy_from_slice(&w);
            }
        }
        let mut k = Box::new([[0.0; TRACTIONS]; TRACTIONS]);
        for row in z.iter() {
            for i in 0..TRACTIONS {
                let x = row[i];
                for j in 0..TRACTIONS {
                    k[i][j] += x * row[j];
                }
            }
        }
        k
    }

    /// Parameters `F⁻¹ (Tᵀ v − F_p)` of the face displacements `v`.
    ///
    /// With `particular = false` the body force is left out (for corrections).
    pub fn parameters(&self, v: &[f64; TRACTIONS], particular: bool) -> [f64; PARAMETERS] {
        let r = reference();
        let mut a =
            if particular { self.particular_flexibility.map(|x| -x) } else { [0.0; PARAMETERS] };
        for q in 0..12 {
            let w = vec3::mul_t(&self.jacobian, [v[3 * q], v[3 * q + 1], v[3 * q + 2]]);
            for d in 0..3 {
                let row = &r.traction[3 * q + d];
                for i in 0..PARAMETERS {
                    a[i] += row[i] * w[d];
                }
            }
        }
        self.factor.solve(&mut a);
        a
    }

    /// Mass-weighted outer tractions of the parameters, those of the body force included.
    pub fn tractions(&self, parameters: &[f64; PARAMETERS]) -> [f64; TRACTIONS] {
        let r = reference();
        let mut t = self.particular_tractions();
        for q in 0..12 {
            let local: V3 = std::array::from_fn(|d| {
                r.traction[3 * q + d].iter().zip(parameters).map(|(x, y)| x * y).sum()
            });
            let w = vec3::mul(&self.jacobian, local);
            (0..3).for_each(|d| t[3 * q + d] += w[d]);
        }
        t
    }

    /// `N_eᵀ ∫ C⁻¹ σ_p`, the strain of the body force's particular stress on the parameters.
    pub fn particular_flexibility(&self) -> &[f64; PARAMETERS] {
        &self.particular_flexibility
    }

    /// Terms of the body force's particular stress alone in the program: its mass-weighted outer
    /// tractions, linear in the face displacements, and the constant `−½ ∫ σ_p:C⁻¹:σ_p`.
    pub fn particular_terms(&self) -> ([f64; TRACTIONS], f64) {
        let s = self.particular();
        (self.particular_tractions(), -0.5 * integrate(self.volume, &self.material, &s, &s))
    }

    /// Mass-weighted outer tractions of the body force's particular stress.
    fn particular_tractions(&self) -> [f64; TRACTIONS] {
        let mut t = [0.0; TRACTIONS];
        if self.body_force.is_some() {
            let s = self.particular();
            for k in 0..4 {
                let area = vec3::area_vector(&FACES[k].map(|i| self.corners[i]));
                let at: [V3; 3] = std::array::from_fn(|p| mandel::traction(&s[k][p], area));
                for p in 0..3 {
                    for d in 0..3 {
                        t[9 * k + 3 * p + d] = (0..3).map(|b| triangle_mass(p, b) * at[b][d]).sum();
                    }
                }
            }
        }
        t
    }

    /// Terms of the body force in the condensed program: the linear term on the face displacements
    /// and the constant.
    pub fn body_terms(&self) -> ([f64; TRACTIONS], f64) {
        if self.body_force.is_none() {
            return ([0.0; TRACTIONS], 0.0);
        }
        let mut a = self.particular_flexibility;
        self.factor.solve(&mut a);
        let minus = a.map(|x| -x);
        let with_relaxation = self.tractions(&minus);
        let s = self.particular();
        let c_p: f64 = integrate(self.volume, &self.material, &s, &s);
        let fa: f64 = self.particular_flexibility.iter().zip(&a).map(|(x, y)| x * y).sum();
        (with_relaxation, 0.5 * fa - 0.5 * c_p)
    }

    /// Stress at the points.
    pub fn stress(&self, parameters: &[f64; PARAMETERS]) -> PointStress {
        let r = reference();
        let mut s = self.particular();
        for k in 0..4 {
            for p in 0..4 {
                let mut hat = [0.0; 6];
                for a in 0..PARAMETERS {
                    (0..6).for_each(|c| hat[c] += r.basis[k][p][a][c] * parameters[a]);
                }
                let x = mandel::mul(&self.piola, &hat);
                (0..6).for_each(|c| s[k][p][c] += x[c]);
            }
        }
        s
    }
}

/// `∫ a : C⁻¹ : b` over a macro tet of volume `volume`, both fields linear in its 4 subtets.
pub fn integrate(volume: f64, material: &Isotropic, a: &PointStress, b: &PointStress) -> f64 {
    let mut total = 0.0;
    for k in 0..4 {
        let strain = b[k].map(|x| material.strain(&x));
        for p in 0..4 {
            for r in 0..4 {
                total += tetrahedron_mass(p, r) * mandel::dot(&a[k][p], &strain[r]);
            }
        }
    }
    0.25 * volume * total
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::stress_basis::equilibrium_rows;
    use bracket_base::math::dense::Mat;

    fn random_tet(seed: &mut u64) -> [V3; 4] {
        let mut next = || {
            *seed ^= *seed << 13;
            *seed ^= *seed >> 7;
            *seed ^= *seed << 17;
            (*seed >> 11) as f64 / (1u64 << 53) as f64
        };
        loop {
            let mut x: [V3; 4] = std::array::from_fn(|_| std::array::from_fn(|_| next()));
            let d = jacobian(&x).2;
            if d < 0.0 {
                x.swap(1, 2);
            }
            if d.abs() > 0.02 {
                return x;
            }
        }
    }

    fn rank(rows: &[Vec<f64>]) -> usize {
        let m = Mat::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j]);
        let s = m.singular_values().expect("a small dense matrix");
        s.iter().filter(|x| **x > 1e-9 * s[0]).count()
    }

    /// The 66 rows have rank 66, 30 parameters remain, and their tractions have rank 30, on 100
    /// random tetrahedra; the mapped reference basis satisfies the rows of the element itself.
    #[test]
    fn ranks_are_66_30_30() {
        let mut seed = 0x9e37_79b9_7f4a_7c15;
        let r = reference();
        for _ in 0..100 {
            let x = random_tet(&mut seed);
            let rows = equilibrium_rows(&x);
            assert_eq!(rank(&rows.iter().map(|r| r.to_vec()).collect::<Vec<_>>()), 66);
            let (j, _, det) = jacobian(&x);
            let piola = mandel::piola(&j, det);
            let mut columns = Vec::new();
            for a in 0..PARAMETERS {
                let mut column = vec![0.0; 96];
                for k in 0..4 {
                    for p in 0..4 {
                        column[24 * k + 6 * p..][..6]
                            .copy_from_slice(&mandel::mul(&piola, &r.basis[k][p][a]));
                    }
                }
                let size = column.iter().fold(0.0f64, |m, c| m.max(c.abs()));
                for row in &rows {
                    let residual: f64 = row.iter().zip(&column).map(|(a, b)| a * b).sum();
                    assert!(residual.abs() < 1e-12 * size, "{residual} {size}");
                }
                columns.push(column);
            }
            assert_eq!(rank(&columns), PARAMETERS);
            let e = SuperElement::new(x, Isotropic::new(1.0, 0.3), None).expect("a good shape");
            let tractions: Vec<Vec<f64>> = (0..PARAMETERS)
                .map(|a| {
                    let mut unit = [0.0; PARAMETERS];
                    unit[a] = 1.0;
                    e.tractions(&unit).to_vec()
                })
                .collect();
            assert_eq!(rank(&tractions), 30);
        }
    }

    /// The stiffness has exactly the six rigid motions in its kernel.
    #[test]
    fn kernel_is_rigid() {
        let mut seed = 7;
        for _ in 0..20 {
            let x = random_tet(&mut seed);
            let e =
                SuperElement::new(x, Isotropic::new(210_000.0, 0.3), None).expect("a good shape");
            let k = e.stiffness();
            let rows: Vec<Vec<f64>> = k.iter().map(|r| r.to_vec()).collect();
            assert_eq!(rank(&rows), 30);
            for m in 0..6 {
                let mut v = [0.0; TRACTIONS];
                for f in 0..4 {
                    for p in 0..3 {
                        let y = x[FACES[f][p]];
                        let mut u = [0.0; 3];
                        if m < 3 {
                            u[m] = 1.0;
                        } else {
                            let mut w = [0.0; 3];
                            w[m - 3] = 1.0;
                            u = vec3::cross(w, y);
                        }
                        v[9 * f + 3 * p..][..3].copy_from_slice(&u);
                    }
                }
                let largest = rows.iter().flatten().fold(0.0f64, |a, b| a.max(b.abs()));
                for row in &rows {
                    let f: f64 = row.iter().zip(&v).map(|(a, b)| a * b).sum();
                    assert!(f.abs() < 1e-12 * largest, "{f} {largest}");
                }
            }
        }
    }
}
