//! Quality of the tets of each body.

use super::TetMesh;
use super::tet::FACES;
use bracket_base::math::vec3::{V3, area_vector, dot, norm, sub};
use bracket_base::say;
use bracket_base::words::Text;
use serde::Serialize;

/// Quality of one body's tets.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodyQuality {
    /// Name of the body.
    pub body: String,
    /// Number of tets.
    pub tets: usize,
    /// Volume \[mm³\].
    pub volume: f64,
    /// Smallest dihedral angle of all tets \[degrees\]; 70.5 for the regular tet.
    pub worst_dihedral: f64,
    /// Median over the tets of their smallest dihedral angle \[degrees\].
    pub median_dihedral: f64,
    /// Largest aspect ratio: longest edge divided by smallest height, relative to the regular tet
    /// (1 = regular).
    pub worst_aspect: f64,
    /// Fraction of the tets with all four corners on the surface of the body; such a tet spans the
    /// whole thickness.
    pub surface_only: f64,
    /// Number of flat tets in the mesher's mesh that were mended ([`super::mend`]).
    #[serde(skip_serializing_if = "is_zero")]
    pub mended: usize,
}

/// Most meshes have nothing to mend; their tables do not mention it.
fn is_zero(count: &usize) -> bool {
    *count == 0
}

/// The table, one row per body in the mesh's order.
pub fn table(mesh: &TetMesh) -> Vec<BodyQuality> {
    let on_surface = surface_nodes(mesh);
    let mut rows: Vec<BodyQuality> = Vec::with_capacity(mesh.bodies.len());
    for (b, body) in mesh.bodies.iter().enumerate() {
        let of_body: Vec<usize> =
            (0..mesh.tets.len()).filter(|&e| mesh.tet_body[e] as usize == b).collect();
        let mut angles: Vec<f64> =
            of_body.iter().map(|&e| smallest_dihedral(&mesh.corners(e))).collect();
        angles.sort_by(f64::total_cmp);
        let shallow = of_body
            .iter()
            .filter(|&&e| mesh.tets[e].iter().all(|n| on_surface[b].binary_search(n).is_ok()))
            .count();
        rows.push(BodyQuality {
            body: body.clone(),
            tets: of_body.len(),
            volume: of_body.iter().map(|&e| mesh.volume(e)).sum(),
            worst_dihedral: angles.first().copied().unwrap_or(f64::NAN),
            median_dihedral: angles.get(angles.len() / 2).copied().unwrap_or(f64::NAN),
            worst_aspect: of_body.iter().map(|&e| aspect(&mesh.corners(e))).fold(0.0, f64::max),
            surface_only: shallow as f64 / of_body.len().max(1) as f64,
            mended: 0,
        });
    }
    rows
}

/// The table as text with aligned columns.
pub fn text(rows: &[BodyQuality]) -> String {
    use std::fmt::Write;
    let width = rows.iter().map(|r| r.body.len()).max().unwrap_or(0).max(5);
    let mending = rows.iter().any(|r| r.mended > 0);
    let mut out = format!(
        "{:width$}  {:>8}  {:>12}  {:>9}  {:>9}  {:>7}  {:>8}{}\n",
        "body",
        "tets",
        "volume mm3",
        "worst deg",
        "median",
        "aspect",
        "surface",
        if mending { "    mended" } else { "" }
    );
    for r in rows {
        let _ = write!(
            out,
            "{:width$}  {:>8}  {:>12.0}  {:>9.2}  {:>9.1}  {:>7.1}  {:>7.0}%",
            r.body,
            r.tets,
            r.volume,
            r.worst_dihedral,
            r.median_dihedral,
            r.worst_aspect,
            100.0 * r.surface_only
        );
        if mending {
            let _ = write!(out, "  {:>8}", r.mended);
        }
        out.push('\n');
    }
    out
}

/// Sorted nodes on the surface of each body (faces that belong to only one tet of the body).
fn surface_nodes(mesh: &TetMesh) -> Vec<Vec<u32>> {
    let mut out = vec![Vec::new(); mesh.bodies.len()];
    let table = super::topology::FaceTable::new(&mesh.tets);
    for rows in table.faces() {
        for row in rows {
            let body = mesh.tet_body[row.tet as usize];
            if rows.iter().all(|r| r.tet == row.tet || mesh.tet_body[r.tet as usize] != body) {
                out[body as usize].extend(row.key);
            }
        }
    }
    for list in &mut out {
        list.sort_unstable();
        list.dedup();
    }
    out
}

/// Area vectors of the faces opposite the corners, outward.
fn area_vectors(x: &[V3; 4]) -> [V3; 4] {
    FACES.map(|f| area_vector(&f.map(|v| x[v])))
}

/// Smallest of the six dihedral angles \[degrees\].
pub fn smallest_dihedral(x: &[V3; 4]) -> f64 {
    let n = area_vectors(x);
    let mut largest = -1.0f64;
    for i in 0..4 {
        for j in i + 1..4 {
            let c = -dot(n[i], n[j]) / (dot(n[i], n[i]) * dot(n[j], n[j])).sqrt();
            largest = largest.max(c);
        }
    }
    largest.min(1.0).acos().to_degrees()
}

/// Longest edge divided by smallest height, relative to the regular tet (1 = regular).
pub fn aspect(x: &[V3; 4]) -> f64 {
    length_over_thickness(x) * (2.0f64 / 3.0).sqrt()
}

/// A tet is flat if its volume is below this factor times the cube of its longest edge. Slivers of
/// a thousandth of a degree (1e-6) still pass; the round-off in the product of three edges is
/// 1e-16.
pub const FLAT_VOLUME: f64 = 1e-12;

/// Length of the longest edge \[mm\].
pub fn longest_edge(x: &[V3; 4]) -> f64 {
    let squares = super::tet::EDGES.map(|[i, j]| sub(x[j], x[i])).map(|d| dot(d, d));
    squares.into_iter().fold(0.0, f64::max).sqrt()
}

/// Longest edge divided by smallest height.
pub fn length_over_thickness(x: &[V3; 4]) -> f64 {
    let longest = longest_edge(x);
    let volume = super::tet::signed_volume(x);
    let largest = area_vectors(x).map(norm).into_iter().fold(0.0, f64::max);
    longest * largest / (3.0 * volume)
}

/// Number, body, place and shape of a tet.
pub fn tet_words(mesh: &TetMesh, tet: usize) -> Text {
    let corners = mesh.corners(tet);
    let body = mesh.bodies.get(mesh.tet_body[tet] as usize).map_or("", String::as_str);
    // rounded before it is printed, and without the sign of a zero
    let tenth = |x: f64| (10.0 * x).round() / 10.0 + 0.0;
    let [x, y, z] = [0, 1, 2].map(|k| tenth(corners.iter().map(|c| 0.25 * c[k]).sum::<f64>()));
    let ratio = length_over_thickness(&corners);
    say!(
        "tet {} of body `{}` near {} mm, {} times as long as thick",
        tet,
        body.to_owned(),
        format!("({x:.1}, {y:.1}, {z:.1})"),
        format!("{ratio:.0}")
    )
}

/// The tets that are more than `least` times as long as thick, the longest first.
pub fn long_tets(mesh: &TetMesh, least: f64) -> Vec<usize> {
    let ratios = (0..mesh.tets.len()).map(|e| (length_over_thickness(&mesh.corners(e)), e));
    let mut long: Vec<(f64, usize)> = ratios.filter(|(ratio, _)| *ratio > least).collect();
    long.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    long.into_iter().map(|(_, e)| e).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regular_and_corner_tet() {
        let regular = [[1.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0], [-1.0, -1.0, 1.0]];
        assert!((smallest_dihedral(&regular) - (1.0f64 / 3.0).acos().to_degrees()).abs() < 1e-10);
        assert!((aspect(&regular).abs() - 1.0).abs() < 1e-12);
        let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!(
            (smallest_dihedral(&corner) - (1.0 / 3f64.sqrt()).acos().to_degrees()).abs() < 1e-10
        );
        // longest edge √2, smallest height 1/√3
        assert!((aspect(&corner) - 2.0).abs() < 1e-12);
        assert!((length_over_thickness(&corner) - 6.0f64.sqrt()).abs() < 1e-12);
    }

    /// Two tets of height 0.1 and 0.01 over a right triangle with legs of 4 mm.
    #[test]
    fn long_tets_are_named_with_the_longest_first() {
        let foot = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        let mesh = TetMesh {
            nodes: foot.into_iter().chain([[1.0, 1.0, 0.1], [1.0, 1.0, -0.01]]).collect(),
            tets: vec![[0, 1, 2, 3], [0, 2, 1, 4]],
            tet_body: vec![0, 1],
            bodies: vec!["A".into(), "B".into()],
            ..TetMesh::default()
        };
        assert_eq!(long_tets(&mesh, 50.0), [1, 0]);
        assert_eq!(long_tets(&mesh, 100.0), [1]);
        let words = "tet 1 of body `B` near (1.3, 1.3, 0.0) mm, 566 times as long as thick";
        assert_eq!(tet_words(&mesh, 1).to_string(), words);
    }
}
