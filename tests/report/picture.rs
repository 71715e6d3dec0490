//! Pictures of a small bolted block: something is drawn, nothing is cut off, the same bytes every time.
//!
//! With `BRACKET_TEST_PICTURES` naming a folder, the pictures are kept there to be looked at.

use bracket::mesh::TetMesh;
use bracket::report::raster::{Deformed, Field, PictureOptions, draw};
use bracket::report::{Picture, surface::Surface};

/// A box of `n` cells along each axis, five tets a cell, as body `body`.
fn add_box(mesh: &mut TetMesh, name: &str, low: [f64; 3], high: [f64; 3], n: [usize; 3]) {
    let first = mesh.nodes.len();
    let index = |i: usize, j: usize, k: usize| (first + (k * (n[1] + 1) + j) * (n[0] + 1) + i) as u32;
    for k in 0..=n[2] {
        for j in 0..=n[1] {
            for i in 0..=n[0] {
                let at = [i, j, k];
                mesh.nodes.push([0, 1, 2].map(|a| low[a] + (high[a] - low[a]) * at[a] as f64 / n[a] as f64));
            }
        }
    }
    mesh.bodies.push(name.into());
    for k in 0..n[2] {
        for j in 0..n[1] {
            for i in 0..n[0] {
                let c: Vec<u32> = (0..8).map(|b| index(i + (b & 1), j + (b >> 1 & 1), k + (b >> 2))).collect();
                // Kuhn's six tets: all share the main diagonal and match across cells
                for [a, b] in [[1, 3], [3, 2], [2, 6], [6, 4], [4, 5], [5, 1]] {
                    mesh.tets.push([c[0], c[a], c[b], c[7]]);
                    mesh.tet_body.push(mesh.bodies.len() as u32 - 1);
                }
            }
        }
    }
}

/// A quarter of a T of two plates and a block, all on the positive side of x = 0 and y = 0.
fn quarter() -> TetMesh {
    let mut mesh = TetMesh::default();
    add_box(&mut mesh, "COLUMN", [0.0, 0.0, -200.0], [40.0, 60.0, 200.0], [2, 3, 16]);
    add_box(&mut mesh, "PLATE_R", [40.0, 0.0, -120.0], [55.0, 80.0, 120.0], [1, 4, 10]);
    add_box(&mut mesh, "BOLT_R1", [55.0, 30.0, 60.0], [70.0, 50.0, 80.0], [1, 2, 2]);
    assert!((0..mesh.tets.len()).all(|e| mesh.volume(e) > 0.0));
    mesh
}

fn keep(picture: &Picture, name: &str) {
    if let Some(folder) = std::env::var_os("BRACKET_TEST_PICTURES") {
        let path = std::path::Path::new(&folder).join(name);
        std::fs::write(path, picture.to_png().expect("encodes")).expect("the folder can be written");
    }
}

/// Share of pixels that are not white.
fn covered(picture: &Picture) -> f64 {
    let n = picture.width * picture.height;
    (0..n).filter(|i| picture.rgb[3 * i..3 * i + 3] != [255; 3]).count() as f64 / n as f64
}

fn border_is_white(picture: &Picture) -> bool {
    let (w, h) = (picture.width, picture.height);
    let white = |x: usize, y: usize| picture.pixel(x, y) == [255; 3];
    (0..w).all(|x| white(x, 0) && white(x, h - 1)) && (0..h).all(|y| white(0, y) && white(w - 1, y))
}

#[test]
fn the_whole_shape_is_in_the_picture() {
    let mesh = quarter();
    for (name, mirror) in [("quarter.png", &[][..]), ("half.png", &[1][..]), ("whole.png", &[0, 1][..])] {
        let options = PictureOptions { width: 700, max_height: 600, mirror, ..Default::default() };
        let picture = draw(&mesh, &options);
        keep(&picture, name);
        assert_eq!(picture.width, 700);
        assert!(picture.height <= 600);
        assert!(covered(&picture) > 0.05, "{name} is nearly empty: {}", covered(&picture));
        assert!(border_is_white(&picture), "{name} is cut off");
        assert_eq!(picture, draw(&mesh, &options), "{name} differs from run to run");
    }
}

#[test]
fn a_flat_shape_makes_a_flat_picture() {
    let mut mesh = TetMesh::default();
    add_box(&mut mesh, "BEAM", [0.0, 0.0, 0.0], [1000.0, 20.0, 20.0], [20, 1, 1]);
    let picture = draw(&mesh, &PictureOptions { eye: Some([0.0, -1.0, 0.2]), ..Default::default() });
    assert_eq!(picture.width, 1600);
    assert!(picture.height < 400, "{}", picture.height);
    assert!(border_is_white(&picture));
}

#[test]
fn a_field_shows_its_bands_and_grey_where_it_is_not_defined() {
    let mesh = quarter();
    let values: Vec<f64> = mesh.nodes.iter().map(|p| if p[2] < -100.0 { f64::NAN } else { p[2] * 1.7 }).collect();
    let displacement: Vec<[f64; 3]> = mesh.nodes.iter().map(|p| [0.0, 0.0, -1e-4 * p[0] * p[0]]).collect();
    let field = Field { name: "von Mises stress", unit: "MPa", values: &values, range: None };
    let options = PictureOptions {
        width: 800,
        max_height: 700,
        mirror: &[0, 1],
        field: Some(field),
        deformed: Some(Deformed { displacement: &displacement, factor: 50.0 }),
        ..Default::default()
    };
    let picture = draw(&mesh, &options);
    keep(&picture, "field.png");
    assert!(border_is_white(&picture));
    let reddish = picture.rgb.chunks(3).filter(|p| p[0] > 120 && p[1] < 80 && p[2] < 80).count();
    let bluish = picture.rgb.chunks(3).filter(|p| p[2] > 100 && p[0] < 80 && p[1] < 100).count();
    assert!(reddish > 500 && bluish > 500, "{reddish} {bluish}");
}

#[test]
fn close_up_is_larger_than_the_whole() {
    let mesh = quarter();
    let red = |p: &Picture| p.rgb.chunks(3).filter(|c| c[0] > 150 && c[1] < 110 && c[2] < 110).count();
    let base = PictureOptions { width: 700, max_height: 600, mirror: &[0, 1], ..Default::default() };
    let far = draw(&mesh, &base);
    let near = draw(&mesh, &PictureOptions { focus: &["BOLT_R1"], ..base });
    keep(&near, "near.png");
    assert!(red(&near) > 4 * red(&far), "{} {}", red(&near), red(&far));
}

#[test]
fn nothing_to_draw_is_no_panic() {
    let picture = draw(&TetMesh::default(), &PictureOptions::default());
    assert!(picture.width == 1600 && picture.to_png().is_ok());
    assert!(Surface::of(&TetMesh::default()).triangles.is_empty());
}

/// A `.msh` 2.2 ASCII file, named by `BRACKET_TEST_MSH`, drawn to be looked at.
#[test]
fn a_mesh_file_of_your_own() {
    let Some(file) = std::env::var_os("BRACKET_TEST_MSH") else { return };
    let text = std::fs::read_to_string(file).expect("the mesh can be read");
    let lines: Vec<&str> = text.lines().collect();
    let find = |w: &str| lines.iter().position(|l| *l == w).expect(w);
    let mut mesh = TetMesh::default();
    let (names, nodes, elements) = (find("$PhysicalNames"), find("$Nodes"), find("$Elements"));
    let mut tags = Vec::new();
    for l in &lines[names + 2..find("$EndPhysicalNames")] {
        let w: Vec<&str> = l.split_whitespace().collect();
        if w[0] == "3" {
            tags.push(w[1].parse::<usize>().expect("tag"));
            mesh.bodies.push(w[2].trim_matches('"').into());
        }
    }
    let mut index = std::collections::BTreeMap::new();
    for l in &lines[nodes + 2..find("$EndNodes")] {
        let w: Vec<&str> = l.split_whitespace().collect();
        index.insert(w[0], mesh.nodes.len() as u32);
        mesh.nodes.push([1, 2, 3].map(|i| w[i].parse().expect("coordinate")));
    }
    for l in &lines[elements + 2..find("$EndElements")] {
        let w: Vec<&str> = l.split_whitespace().collect();
        if w[1] == "4" {
            let skip = 3 + w[2].parse::<usize>().expect("number of tags");
            let tag: usize = w[3].parse().expect("physical tag");
            mesh.tet_body.push(tags.iter().position(|t| *t == tag).expect("named volume") as u32);
            let mut tet = [0, 1, 2, 3].map(|i| index[w[skip + i]]);
            if bracket::mesh::tet::signed_volume(&tet.map(|n| mesh.nodes[n as usize])) < 0.0 {
                tet.swap(2, 3);
            }
            mesh.tets.push(tet);
        }
    }
    let start = std::time::Instant::now();
    let whole = PictureOptions { mirror: &[0, 1], ..Default::default() };
    keep(&draw(&mesh, &whole), "mesh_whole.png");
    eprintln!("whole picture: {:.2} s", start.elapsed().as_secs_f64());
    keep(&draw(&mesh, &PictureOptions::default()), "mesh_quarter.png");
    let near: Vec<&str> = mesh.bodies.iter().map(String::as_str).filter(|b| b.starts_with("PLATE")).collect();
    keep(&draw(&mesh, &PictureOptions { focus: &near, ..whole.clone() }), "mesh_near.png");
    let values: Vec<f64> = mesh.nodes.iter().map(|p| p[0].hypot(p[2]) * 0.3).collect();
    let displacement: Vec<[f64; 3]> = mesh.nodes.iter().map(|p| [0.0, 0.0, -2e-7 * p[0] * p[0]]).collect();
    let options = PictureOptions {
        field: Some(Field { name: "von Mises stress", unit: "MPa", values: &values, range: None }),
        deformed: Some(Deformed { displacement: &displacement, factor: 250.0 }),
        ..whole
    };
    keep(&draw(&mesh, &options), "mesh_field.png");
}
