//! Medit ASCII files (`.mesh`, `.sol`), the format of the remesher Mmg.
//!
//! # Source
//! Frey, MEDIT: an interactive mesh visualization software, INRIA RT-0253 (2001), appendix; the
//! keywords that Mmg reads and writes.

use super::polyhedron::Polyhedron;
use bracket_base::math::mandel::{Mandel, to_matrix};
use bracket_base::math::vec3::V3;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Files of Mmg carry more keywords than are read; all of them are passed over.
    #[test]
    fn other_keywords_are_skipped() {
        let text = "MeshVersionFormatted 2\n\nDimension 3\n\nVertices\n4\n0 0 0 0\n1 0 0 2 \n0 1 0 \
                    0\n0 0 1e-1 0\nCorners\n2\n1\n2\nTriangles\n1\n1 2 3 5\nRequiredTriangles\n1\n1\
                    \nTetrahedra\n1\n1 2 3 4 9\nNormals\n1\n0 0 1\nEnd\n";
        let mesh = parse(text).expect("valid");
        assert_eq!(mesh.nodes[3], [0.0, 0.0, 0.1]);
        assert_eq!((mesh.triangles, mesh.tets), (vec![([0, 1, 2], 5)], vec![([0, 1, 2, 3], 9)]));
    }

    #[test]
    fn damaged_files_are_refused() {
        let whole = "Vertices\n1\n0 0 0 0\nTetrahedra\n1\n1 1 1 1 1\nEnd\n";
        assert!(parse(whole).is_ok());
        let cut = &whole[..whole.len() - 5];
        assert_eq!(parse(cut), Err("it is cut off".into()));
        assert_eq!(
            parse(&whole.replace("0 0 0 0", "0 x 0 0")).map(|_| ()),
            Err("`x` stands in place of a coordinate".into())
        );
        assert_eq!(
            parse(&whole.replace("1 1 1 1 1", "1 1 1 2 1")).map(|_| ()),
            Err("node 2 of 1".into())
        );
        assert_eq!(parse("Vertices\n0\nEnd").map(|_| ()), Err("it has no tetrahedra".into()));
    }

    /// The order of the six components: m11, m12, m22, m13, m23, m33.
    #[test]
    fn components_of_the_metric() {
        let m =
            bracket_base::math::mandel::symmetric_part(&[[1., 2., 4.], [2., 3., 5.], [4., 5., 6.]]);
        let text = metric_text(&[m]);
        let line = text.lines().nth(7).expect("the first tensor");
        let numbers: Vec<f64> = line.split(' ').map(|w| w.parse().expect("a number")).collect();
        assert!(numbers.iter().zip([1., 2., 3., 4., 5., 6.]).all(|(a, b)| (a - b).abs() < 1e-9));
    }
}
