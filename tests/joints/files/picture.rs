//! Pictures of a small bolted block: the picture is not empty, nothing is cut off, and the bytes
//! are the same every time.
//!
//! If `BRACKET_TEST_PICTURES` names a folder, the test keeps the pictures there for inspection.

use bracket::mesh::TetMesh;
use bracket::report::draw::Picture;
use bracket::report::draw::raster::{Colours, Deformed, Field, PictureOptions, draw, draw_surface};
use bracket::report::draw::surface::{Surface, SurfaceTriangle};

/// A box of `n` cells along each axis, five tets a cell, as body `body`.
fn add_box(mesh: &mut TetMesh, name: &str, low: [f64; 3], high: [f64; 3], n: [usize; 3]) {
    let first = mesh.nodes.len();
    let index =
        |i: usize, j: usize, k: usize| (first + (k * (n[1] + 1) + j) * (n[0] + 1) + i) as u32;
    for k in 0..=n[2] {
        for j in 0..=n[1] {
            for i in 0..=n[0] {
                let at = [i, j, k];
                mesh.nodes.push(
                    [0, 1, 2].map(|a| low[a] + (high[a] - low[a]) * at[a] as f64 / n[a] as f64),
                );
            }
        }
    }
    mesh.bodies.push(name.into());
    for k in 0..n[2] {
        for j in 0..n[1] {
            for i in 0..n[0] {
                let c: Vec<u32> =
                    (0..8).map(|b| index(i + (b & 1), j + (b >> 1 & 1), k + (b >> 2))).collect();
                // Kuhn's six tets: all share the main diagonal and match across cells
                for [a, b] in [[1, 3], [3, 2], [2, 6], [6, 4], [4, 5], [5, 1]] {
                    mesh.tets.push([c[0], c[a], c[b], c[7]]);
                    mesh.tet_body.push(mesh.bodies.len() as u32 - 1);
                }
            }
        }
    }
}

/// A quarter of a T made of two plates and a block, on the positive side of x = 0 and y = 0.
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
        std::fs::write(path, picture.to_png().expect("encodes"))
            .expect("the folder can be written");
    }
}

/// Fraction of the pixels that are not white.
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
    for (name, mirror) in
        [("quarter.png", &[][..]), ("half.png", &[1][..]), ("whole.png", &[0, 1][..])]
    {
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
    let picture =
        draw(&mesh, &PictureOptions { eye: Some([0.0, -1.0, 0.2]), ..Default::default() });
    assert_eq!(picture.width, 1600);
    assert!(picture.height < 400, "{}", picture.height);
    assert!(border_is_white(&picture));
}

#[test]
fn a_field_shows_its_bands_and_grey_where_it_is_not_defined() {
    let mesh = quarter();
    let values: Vec<f64> =
        mesh.nodes.iter().map(|p| if p[2] < -100.0 { f64::NAN } else { p[2] * 1.7 }).collect();
    let displacement: Vec<[f64; 3]> =
        mesh.nodes.iter().map(|p| [0.0, 0.0, -1e-4 * p[0] * p[0]]).collect();
    let field = Field {
        name: "von Mises stress",
        unit: "MPa",
        values: &values,
        range: None,
        colours: Colours::Spectrum,
    };
    let options = PictureOptions {
        width: 800,
        max_height: 700,
        mirror: &[0, 1],
        field: Some(field),
        deformed: Some(Deformed {
            displacement: &displacement,
            factor: 50.0,
            caption: "displacements × 50",
        }),
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
    // the bolt is the third group of bodies: amber
    let amber = |p: &Picture| {
        p.rgb.chunks(3).filter(|c| c[0] > 130 && c[2] < c[0] / 2 && c[1] > c[2]).count()
    };
    let base =
        PictureOptions { width: 700, max_height: 600, mirror: &[0, 1], ..Default::default() };
    let far = draw(&mesh, &base);
    let near = draw(&mesh, &PictureOptions { focus: &["BOLT_R1"], ..base });
    keep(&near, "near.png");
    let (near, far) = (amber(&near), amber(&far));
    assert!(far > 100 && near > 4 * far, "{near} {far}");
}

#[test]
fn nothing_to_draw_is_no_panic() {
    let picture = draw(&TetMesh::default(), &PictureOptions::default());
    assert!(picture.width == 1600 && picture.to_png().is_ok());
    assert!(Surface::of(&TetMesh::default()).triangles.is_empty());
}

/// A zone of a field, enlarged: more of the picture has its colour.
#[test]
fn a_zone_is_enlarged() {
    let mesh = quarter();
    let values: Vec<f64> =
        mesh.nodes.iter().map(|x| if x[2] > 150.0 && x[0] < 30.0 { 1.0 } else { 0.0 }).collect();
    let field = Field {
        name: "zone",
        unit: "",
        values: &values,
        range: Some([0.0, 1.0]),
        colours: Colours::Fire,
    };
    let whole = PictureOptions { field: Some(field), mesh_lines: false, ..Default::default() };
    let close = PictureOptions { around: Some(0.5), ..whole.clone() };
    // left of the legend
    let coloured = |p: &Picture| {
        let red = |x: usize, y: usize| {
            let [r, g, b] = p.pixel(x, y).map(i32::from);
            r > g + 40 && r > b + 20
        };
        let width = p.width - 260;
        (0..p.height)
            .flat_map(|y| (0..width).map(move |x| (x, y)))
            .filter(|(x, y)| red(*x, *y))
            .count()
    };
    let [whole, close] = [draw(&mesh, &whole), draw(&mesh, &close)];
    keep(&close, "zone.png");
    assert!(coloured(&whole) > 500, "{}", coloured(&whole));
    assert!(coloured(&close) > 3 * coloured(&whole), "{} {}", coloured(&close), coloured(&whole));
}

/// The edges at rest appear beside the deformed shape, and only there.
#[test]
fn edges_at_rest_are_drawn_behind() {
    let mesh = quarter();
    let moved: Vec<[f64; 3]> =
        mesh.nodes.iter().map(|x| [0.0, 0.0, -0.1 * (200.0 + x[2])]).collect();
    let deformed = Deformed { displacement: &moved, factor: 1.0, caption: "at rest" };
    let options = PictureOptions { deformed: Some(deformed), ghost: true, ..Default::default() };
    let with = draw(&mesh, &options);
    keep(&with, "ghost.png");
    // above the deformed top, which sank by 40 mm, lines remain on white ground
    let shape = |p: &Picture, y: usize| (0..p.width).filter(|x| p.pixel(*x, y) != [255; 3]).count();
    let first = (0..with.height).find(|y| shape(&with, *y) > 0).expect("drawn");
    let line = shape(&with, first + 20);
    assert!(line > 0 && line < 60, "{line} pixels in a row that only lines cross");
    // at rest the shape covers its own edges
    let still = vec![[0.0; 3]; mesh.nodes.len()];
    let rest = Deformed { displacement: &still, ..deformed };
    let still =
        |ghost| draw(&mesh, &PictureOptions { deformed: Some(rest), ghost, ..Default::default() });
    let changed = still(true).rgb.iter().zip(&still(false).rgb).filter(|(a, b)| a != b).count();
    assert!(changed * 200 < still(true).rgb.len(), "{changed} bytes differ");
}

/// Two bodies that meet on a line, each with a flat triangle that touches the line with a corner
/// only: the line between the bodies has no gap there.
#[test]
fn lines_have_no_gaps_at_corners() {
    let points: Vec<[f64; 3]> = [
        [-10.0, 0.0],
        [0.0, 0.0],
        [10.0, 0.0],
        [-10.0, 1.0],
        [10.0, 1.0],
        [-10.0, -1.0],
        [10.0, -1.0],
    ]
    .map(|[x, y]| [x, y, 0.0])
    .to_vec();
    let triangle = |nodes, body| SurfaceTriangle { nodes, body };
    let surface = Surface {
        triangles: vec![
            triangle([0, 1, 3], 0),
            triangle([1, 4, 3], 0),
            triangle([1, 2, 4], 0),
            triangle([0, 5, 1], 1),
            triangle([1, 5, 6], 1),
            triangle([1, 6, 2], 1),
        ],
        bodies: vec!["A".into(), "B".into()],
        origin: (0..points.len() as u32).collect(),
        signs: vec![[1.0; 3]; points.len()],
        points,
    };
    let options = PictureOptions {
        width: 800,
        eye: Some([0.0, 0.0, 1.0]),
        mesh_lines: false,
        ..Default::default()
    };
    let picture = draw_surface(surface, &options);
    keep(&picture, "line.png");
    let rows: Vec<usize> =
        (0..picture.height).filter(|y| picture.pixel(740, *y) != [255; 3]).collect();
    // the strip below the shape is empty at this column
    let middle = (rows[0] + rows[rows.len() - 1]) / 2;
    for x in 60..740 {
        let darkest = (middle - 4..=middle + 4).map(|y| picture.pixel(x, y)[0]).min();
        assert!(darkest.is_some_and(|d| d < 110), "{darkest:?} in column {x}");
    }
}
