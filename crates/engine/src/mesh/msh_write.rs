//! Writes a mesh as gmsh 2.2 ASCII. Every coordinate reads back to the same bits.

use super::TetMesh;
use super::mesher_error::MesherError;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

/// The text of the file. Bodies are physical volumes 1, 2, …, their regions elementary volumes;
/// named faces are physical surfaces 1001, 1002, ….
pub fn text(mesh: &TetMesh) -> String {
    let mut out = String::with_capacity(64 * mesh.nodes.len() + 40 * mesh.tets.len());
    let first_face = 1001;
    out.push_str("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n");
    // Writing to a String cannot fail.
    let _ = writeln!(out, "{}", mesh.bodies.len() + mesh.faces.len());
    for (i, face) in mesh.faces.iter().enumerate() {
        let _ = writeln!(out, "2 {} \"{}\"", first_face + i, face.name);
    }
    for (i, body) in mesh.bodies.iter().enumerate() {
        let _ = writeln!(out, "3 {} \"{body}\"", i + 1);
    }
    let _ = writeln!(out, "$EndPhysicalNames\n$Nodes\n{}", mesh.nodes.len());
    for (i, x) in mesh.nodes.iter().enumerate() {
        // The shortest digits that read back to the same number (at most 17).
        let _ = writeln!(out, "{} {} {} {}", i + 1, x[0], x[1], x[2]);
    }
    let triangles: usize = mesh.faces.iter().map(|f| f.triangles.len()).sum();
    let _ = writeln!(out, "$EndNodes\n$Elements\n{}", triangles + mesh.tets.len());
    let mut tag = 0;
    for (i, face) in mesh.faces.iter().enumerate() {
        let id = first_face + i;
        for t in &face.triangles {
            tag += 1;
            let _ = writeln!(out, "{tag} 2 2 {id} {id} {} {} {}", t[0] + 1, t[1] + 1, t[2] + 1);
        }
    }
    for (e, (t, body)) in mesh.tets.iter().zip(&mesh.tet_body).enumerate() {
        tag += 1;
        let (id, entity) = (body + 1, mesh.tet_region.get(e).unwrap_or(body) + 1);
        let _ = writeln!(
            out,
            "{tag} 4 2 {id} {entity} {} {} {} {}",
            t[0] + 1,
            t[1] + 1,
            t[2] + 1,
            t[3] + 1
        );
    }
    out.push_str("$EndElements\n");
    out
}

/// Writes the file under a temporary name and renames it, so that a file of the final name is
/// always complete.
pub fn write(mesh: &TetMesh, path: &Path) -> Result<(), MesherError> {
    write_whole(path, &text(mesh))
}

/// Writes a text file under a temporary name and renames it.
pub fn write_whole(path: &Path, text: &str) -> Result<(), MesherError> {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(".part");
    let aside = path.with_file_name(name);
    let result = write_and_rename(&aside, path, text.as_bytes());
    if result.is_err() {
        let _ = std::fs::remove_file(&aside);
    }
    result
}

fn write_and_rename(aside: &Path, path: &Path, bytes: &[u8]) -> Result<(), MesherError> {
    let mut file = std::fs::File::create(aside).map_err(|e| MesherError::write(aside, e))?;
    write_all(&mut file, bytes, path)?;
    file.sync_all().map_err(|e| MesherError::write(path, e))?;
    drop(file);
    std::fs::rename(aside, path).map_err(|e| MesherError::write(path, e))
}

/// Writes to an open file; an error reports `path`.
fn write_all(file: &mut std::fs::File, bytes: &[u8], path: &Path) -> Result<(), MesherError> {
    file.write_all(bytes).map_err(|e| MesherError::write(path, e))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::NamedFaces;

    fn mesh() -> TetMesh {
        TetMesh {
            nodes: vec![
                [0.1 + 0.2, 0.0, 0.0],
                [1.0, 1e-17, 0.0],
                [0.0, 1.0 / 3.0, 0.0],
                [0.0, 0.0, 1e22],
            ],
            tets: vec![[0, 1, 2, 3]],
            tet_body: vec![0],
            tet_region: Vec::new(),
            bodies: vec!["BLOCK".into()],
            faces: vec![NamedFaces { name: "BASE".into(), triangles: vec![[0, 1, 2]] }],
        }
    }

    #[test]
    fn reads_back_to_the_same_bits() {
        let mut mesh = mesh();
        mesh.nodes[3] = [0.0, 0.0, 1.0 / 7.0];
        let (back, _) =
            crate::mesh::msh::parse(text(&mesh).as_bytes(), Path::new("m.msh")).expect("valid");
        assert_eq!(back, mesh);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_full_disk_is_told_apart() {
        let mut full =
            std::fs::OpenOptions::new().write(true).open("/dev/full").expect("Linux has it");
        let error = write_all(&mut full, &vec![b'x'; 1 << 20], Path::new("out/mesh.msh"))
            .expect_err("full");
        let d = bracket_base::diag::Diagnostic::from(error);
        assert_eq!((d.code, d.fault.exit_code()), ("mesher/disk", 4));
        assert!(d.message.contains("out/mesh.msh"), "{}", d.message);
    }

    #[test]
    fn nothing_half_written_is_left() {
        let dir = tempfile::tempdir().expect("temporary folder");
        // a folder has the name of the file, so the rename fails after the text is written
        let path = dir.path().join("mesh.msh");
        std::fs::create_dir(&path).expect("folder");
        std::fs::write(path.join("keep"), "x").expect("file");
        write(&mesh(), &path).expect_err("cannot replace a folder");
        let names: Vec<_> = std::fs::read_dir(dir.path())
            .expect("folder")
            .map(|e| e.expect("entry").file_name())
            .collect();
        assert_eq!(names, ["mesh.msh"]);
    }
}
