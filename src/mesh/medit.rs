//! Medit ASCII files (`.mesh`, `.sol`), the format of the remesher Mmg.
//!
//! # Source
//! Frey, MEDIT: an interactive mesh visualization software, INRIA RT-0253 (2001), appendix; the
//! keywords that Mmg reads and writes.

use super::polyhedron::Polyhedron;
use crate::math::mandel::{Mandel, to_matrix};
use crate::math::vec3::V3;
use std::fmt::Write;
use std::str::FromStr;

/// The content of a mesh file: nodes from 0, references as in the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeditMesh {
    /// Coordinates \[mm\].
    pub nodes: Vec<V3>,
    /// Tets with their references.
    pub tets: Vec<([u32; 4], u32)>,
    /// Triangles with their references.
    pub triangles: Vec<([u32; 3], u32)>,
}

/// A mesh with the polyhedron it fills as a `.mesh` file. References are regions and facets,
/// counted from 1. Corners are required vertices.
pub fn mesh_text(nodes: &[V3], tets: &[[u32; 4]], p: &Polyhedron) -> String {
    let mut out = String::with_capacity(64 * nodes.len() + 32 * tets.len());
    // writing to a String cannot fail
    let _ = writeln!(out, "MeshVersionFormatted 2\nDimension 3\n\nVertices\n{}", nodes.len());
    for [x, y, z] in nodes {
        let _ = writeln!(out, "{x} {y} {z} 0");
    }
    let _ = writeln!(out, "\nTetrahedra\n{}", tets.len());
    for (t, region) in tets.iter().zip(&p.region_of_tet) {
        let [a, b, c, d] = t.map(|n| n + 1);
        let _ = writeln!(out, "{a} {b} {c} {d} {}", region + 1);
    }
    let _ = writeln!(out, "\nTriangles\n{}", p.triangles.len());
    for (t, facet) in &p.triangles {
        let [a, b, c] = t.map(|n| n + 1);
        let _ = writeln!(out, "{a} {b} {c} {}", facet + 1);
    }
    let _ = writeln!(out, "\nEdges\n{}", p.edges.len());
    for [a, b] in &p.edges {
        let _ = writeln!(out, "{} {} 1", a + 1, b + 1);
    }
    let _ = writeln!(out, "\nRidges\n{}", p.ridges.len());
    for ridge in &p.ridges {
        if let Ok(i) = p.edges.binary_search(ridge) {
            let _ = writeln!(out, "{}", i + 1);
        }
    }
    for keyword in ["Corners", "RequiredVertices"] {
        let _ = writeln!(out, "\n{keyword}\n{}", p.corners.len());
        for n in &p.corners {
            let _ = writeln!(out, "{}", n + 1);
        }
    }
    out.push_str("\nEnd\n");
    out
}

/// Metric tensors at the nodes \[1/mm²\] as a `.sol` file.
pub fn metric_text(metric: &[Mandel]) -> String {
    let mut out = String::with_capacity(100 * metric.len());
    let n = metric.len();
    let _ = writeln!(out, "MeshVersionFormatted 2\nDimension 3\n\nSolAtVertices\n{n}\n1 3\n");
    for m in metric {
        let a = to_matrix(m);
        let lower = [a[0][0], a[0][1], a[1][1], a[0][2], a[1][2], a[2][2]];
        let words: Vec<String> = lower.iter().map(|x| format!("{x:.10e}")).collect();
        let _ = writeln!(out, "{}", words.join(" "));
    }
    out.push_str("\nEnd\n");
    out
}

/// The words of a file, read in turn.
struct Words<'a> {
    words: std::str::SplitWhitespace<'a>,
}

impl Words<'_> {
    fn number<T: FromStr>(&mut self, what: &str) -> Result<T, String> {
        let word = self.words.next().ok_or_else(|| format!("it ends before {what}"))?;
        word.parse().map_err(|_| format!("`{word}` stands in place of {what}"))
    }

    fn nodes<const N: usize>(&mut self, count: usize) -> Result<([u32; N], u32), String> {
        let mut nodes = [0; N];
        for n in &mut nodes {
            let number: u32 = self.number("a node")?;
            if number == 0 || number as usize > count {
                return Err(format!("node {number} of {count}"));
            }
            *n = number - 1;
        }
        Ok((nodes, self.number("a reference")?))
    }
}

/// Reads a `.mesh` file; entities other than vertices, triangles and tets are skipped.
pub fn parse(text: &str) -> Result<MeditMesh, String> {
    let mut mesh = MeditMesh::default();
    let mut w = Words { words: text.split_whitespace() };
    let mut complete = false;
    while let Some(keyword) = w.words.next() {
        match keyword {
            "Vertices" => {
                for _ in 0..w.number::<usize>("the number of vertices")? {
                    let mut x = [0.0; 3];
                    for c in &mut x {
                        *c = w.number("a coordinate")?;
                    }
                    let _: f64 = w.number("a reference")?;
                    mesh.nodes.push(x);
                }
            }
            "Triangles" => {
                for _ in 0..w.number::<usize>("the number of triangles")? {
                    mesh.triangles.push(w.nodes(mesh.nodes.len())?);
                }
            }
            "Tetrahedra" => {
                for _ in 0..w.number::<usize>("the number of tets")? {
                    mesh.tets.push(w.nodes(mesh.nodes.len())?);
                }
            }
            "End" => {
                complete = true;
                break;
            }
            _ => {}
        }
    }
    if !complete {
        return Err("it is cut off".into());
    }
    if mesh.tets.is_empty() {
        return Err("it has no tetrahedra".into());
    }
    Ok(mesh)
}
