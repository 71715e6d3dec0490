//! Joints built in code for tests: the paper's joint (docs/benchmarks.md), and two plates with one
//! bolt.

use crate::assembly::Assembly;
use crate::assembly::assembly::*;
use crate::strength::NominalStrength;
use bracket_engine::model::FrictionLaw;
use std::collections::BTreeMap;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Outline of an I section with root fillets; the first coordinate is along the flanges, the second
/// along the web.
fn i_outline(h: f64, b: f64, tw: f64, tf: f64, r: f64) -> ([f64; 2], Vec<OutlineEdge>) {
    let (hy, hz, w, i) = (b / 2.0, h / 2.0, tw / 2.0, h / 2.0 - tf);
    let line = |x: f64, y: f64| OutlineEdge::Line { to: [x, y] };
    let arc = |x: f64, y: f64, cx: f64, cy: f64| OutlineEdge::Arc { to: [x, y], centre: [cx, cy] };
    let edges = vec![
        line(hy, -hz),
        line(hy, -i),
        line(w + r, -i),
        arc(w, -i + r, w + r, -i + r),
        line(w, i - r),
        arc(w + r, i, w + r, i - r),
        line(hy, i),
        line(hy, hz),
        line(-hy, hz),
        line(-hy, i),
        line(-w - r, i),
        arc(-w, i - r, -w - r, i - r),
        line(-w, -i + r),
        arc(-w - r, -i, -w - r, -i + r),
        line(-hy, -i),
        line(-hy, -hz),
    ];
    ([-hy, -hz], edges)
}

fn boxed(min: [f64; 3], max: [f64; 3]) -> Solid {
    Solid::Box { min, max }
}

/// Extruded hexagon of width across flats `s`, with corners along y, on a plane of constant x or z.
fn hexagon(origin: [f64; 3], u: [f64; 3], v: [f64; 3], s: f64, length: f64) -> Solid {
    let (e, h) = (s / 3f64.sqrt(), s / 2.0);
    let p = [[e, 0.0], [e / 2.0, h], [-e / 2.0, h], [-e, 0.0], [-e / 2.0, -h], [e / 2.0, -h]];
    let edges = (1..=6).map(|i| OutlineEdge::Line { to: p[i % 6] }).collect();
    Solid::Prism { origin, u, v, start: p[0], edges, length }
}

fn steel() -> BTreeMap<String, PartMaterial> {
    BTreeMap::from([(
        "steel".to_string(),
        PartMaterial { e: 210000.0, nu: 0.3, strength: NominalStrength::Unlimited, fu: None },
    )])
}

fn part(
    name: &str,
    label: &str,
    role: PartRole,
    solid: Solid,
    convex: Vec<Solid>,
    size: f64,
) -> Part {
    Part {
        name: name.into(),
        label: label.into(),
        role,
        material: "steel".into(),
        solid,
        convex,
        mid_planes: vec![],
        oblique_planes: vec![],
        size,
    }
}

fn contact(a: &str, b: &str, surface: Option<(String, Surface)>) -> InterfaceRule {
    InterfaceRule {
        between: [a.into(), b.into()],
        surface,
        mu: 0.3,
        friction: FrictionLaw::Associated,
        gap: 0.0,
    }
}

/// Number of sides of the meshed bolt circles.
const SEGMENTS: u32 = 12;
const ROWS: [f64; 3] = [-215.0, -125.0, 110.0];

fn column() -> Part {
    // HEB200 along z. The first outline coordinate is along y, the second along x. As u × v = y × x
    // = −z, the extrusion is downwards.
    let (start, edges) = i_outline(200.0, 200.0, 9.0, 15.0, 18.0);
    let profile =
        Solid::Prism { origin: [0.0, 0.0, 350.0], u: Y, v: X, start, edges, length: 700.0 };
    let mut solids = vec![profile];
    let mut convex = vec![
        boxed([-85.0, -4.5, -350.0], [85.0, 4.5, 350.0]),
        boxed([85.0, -100.0, -350.0], [100.0, 100.0, 350.0]),
        boxed([-100.0, -100.0, -350.0], [-85.0, 100.0, 350.0]),
    ];
    let mut mid_planes: Vec<MidPlane> = [-92.5, 92.5]
        .iter()
        .map(|&at| MidPlane { axis: 0, at, min: [0.0, -100.0, -350.0], max: [0.0, 100.0, 350.0] })
        .collect();
    mid_planes.push(MidPlane {
        axis: 1,
        at: 0.0,
        min: [-85.0, 0.0, -350.0],
        max: [85.0, 0.0, 350.0],
    });
    for [y0, y1] in [[4.5, 100.0], [-100.0, -4.5]] {
        for [z0, z1] in [[167.3, 180.0], [-180.0, -167.3]] {
            let b = boxed([-85.0, y0, z0], [85.0, y1, z1]);
            solids.push(b.clone());
            convex.push(b);
            let at = 0.5 * (z0 + z1);
            mid_planes.push(MidPlane { axis: 2, at, min: [-85.0, y0, 0.0], max: [85.0, y1, 0.0] });
        }
    }
    let mut cut = vec![Solid::Union(solids)];
    for x in [85.0, -100.0] {
        for y in [50.0, -50.0] {
            cut.extend(ROWS.map(|z| Solid::Cylinder {
                base: [x, y, z],
                axis: X,
                radius: 9.0,
                length: 15.0,
                segments: SEGMENTS,
            }));
        }
    }
    Part {
        mid_planes,
        ..part("COLUMN", "column", PartRole::Member, Solid::Difference(cut), convex, 22.5)
    }
}

/// Interval in x for the right side (`side` = 1) or the left side (−1).
fn span(side: f64, near: f64, far: f64) -> [f64; 2] {
    let (a, b) = (side * near, side * far);
    [a.min(b), a.max(b)]
}

fn beam(side: f64) -> Part {
    let (start, edges) = i_outline(360.0, 170.0, 8.0, 12.7, 18.0);
    let [x0, x1] = span(side, 115.0, 1115.0);
    let [s0, s1] = span(side, 1007.5, 1022.5);
    let mut solids =
        vec![Solid::Prism { origin: [x0, 0.0, 0.0], u: Y, v: Z, start, edges, length: 1000.0 }];
    let mut convex = vec![
        boxed([x0, -4.0, -167.3], [x1, 4.0, 167.3]),
        boxed([x0, -85.0, 167.3], [x1, 85.0, 180.0]),
        boxed([x0, -85.0, -180.0], [x1, 85.0, -167.3]),
    ];
    let mut mid_planes: Vec<MidPlane> = [-173.65, 173.65]
        .iter()
        .map(|&at| MidPlane { axis: 2, at, min: [x0, -85.0, 0.0], max: [x1, 85.0, 0.0] })
        .collect();
    mid_planes.push(MidPlane { axis: 1, at: 0.0, min: [x0, 0.0, -167.3], max: [x1, 0.0, 167.3] });
    for [y0, y1] in [[4.0, 85.0], [-85.0, -4.0]] {
        let b = boxed([s0, y0, -167.3], [s1, y1, 167.3]);
        solids.push(b.clone());
        convex.push(b);
        mid_planes.push(MidPlane {
            axis: 0,
            at: side * 1015.0,
            min: [0.0, y0, -167.3],
            max: [0.0, y1, 167.3],
        });
    }
    let (name, label) = if side > 0.0 { ("BEAM_R", "right beam") } else { ("BEAM_L", "left beam") };
    Part { mid_planes, ..part(name, label, PartRole::Member, Solid::Union(solids), convex, 25.4) }
}

fn plate(side: f64) -> Part {
    let [x0, x1] = span(side, 100.0, 115.0);
    let whole = boxed([x0, -90.0, -250.0], [x1, 90.0, 200.0]);
    let mut cut = vec![whole.clone()];
    for y in [50.0, -50.0] {
        cut.extend(ROWS.map(|z| Solid::Cylinder {
            base: [x0, y, z],
            axis: X,
            radius: 9.0,
            length: 15.0,
            segments: SEGMENTS,
        }));
    }
    let (name, label) = if side > 0.0 {
        ("PLATE_R", "end plate of the right beam")
    } else {
        ("PLATE_L", "end plate of the left beam")
    };
    let mid =
        MidPlane { axis: 0, at: side * 107.5, min: [0.0, -90.0, -250.0], max: [0.0, 90.0, 200.0] };
    Part {
        mid_planes: vec![mid],
        ..part(name, label, PartRole::Plate, Solid::Difference(cut), vec![whole], 15.0)
    }
}

fn bolt(side: f64, y: f64, row: usize) -> Part {
    let z = ROWS[row];
    let [h0, h1] = span(side, 115.0, 126.5);
    let [n0, n1] = span(side, 69.2, 85.0);
    let [s0, s1] = span(side, 85.0, 115.0);
    let solids = vec![
        Solid::Cylinder {
            base: [s0, y, z],
            axis: X,
            radius: 9.0,
            length: s1 - s0,
            segments: SEGMENTS,
        },
        hexagon([h0, y, z], Y, Z, 27.0, h1 - h0),
        hexagon([n0, y, z], Y, Z, 27.0, n1 - n0),
    ];
    let name = format!(
        "BOLT_{}{}{}",
        if side > 0.0 { "R" } else { "L" },
        if y > 0.0 { "P" } else { "N" },
        row + 1
    );
    let label = format!(
        "bolt of row {} ({}, y {})",
        row + 1,
        if side > 0.0 { "right" } else { "left" },
        if y > 0.0 { "positive" } else { "negative" }
    );
    part(&name, &label, PartRole::Bolt, Solid::Union(solids.clone()), solids, 12.6)
}

/// The paper's joint with the dimensions of this project (docs/benchmarks.md, "The paper's joint").
pub(crate) fn paper_joint() -> Assembly {
    let mut parts = vec![column()];
    let mut interfaces = Vec::new();
    let mut faces = Vec::new();
    let mut supports = Vec::new();
    for side in [1.0, -1.0] {
        let (p, b) = (plate(side), beam(side));
        interfaces.push(contact(&p.name, "COLUMN", None));
        for y in [50.0, -50.0] {
            for row in 0..3 {
                let bolt = bolt(side, y, row);
                let mantle = Surface::Mantle {
                    base: [span(side, 100.0, 115.0)[0], y, ROWS[row]],
                    axis: X,
                    radius: 9.0,
                    length: 15.0,
                };
                interfaces.push(contact(&bolt.name, "COLUMN", None));
                // The head is tied to the plate, so only the shank's surface is open.
                let name = bolt.name.replace("BOLT", "SHANK");
                interfaces.push(contact(&bolt.name, &p.name, Some((name, mantle))));
                parts.push(bolt);
            }
        }
        let [s0, s1] = span(side, 1007.5, 1022.5);
        let face = if side > 0.0 { "SUPPORT_R" } else { "SUPPORT_L" };
        faces.push(FaceRule {
            name: face.into(),
            part: b.name.clone(),
            surface: Surface::Plane {
                axis: 2,
                at: -180.0,
                min: [s0, -85.0, 0.0],
                max: [s1, 85.0, 0.0],
            },
            imprint: true,
        });
        supports.push(FaceSupport { face: face.into(), fix: [true; 3], ground: None });
        parts.push(p);
        parts.push(b);
    }
    faces.push(FaceRule {
        name: "LOAD_TOP".into(),
        part: "COLUMN".into(),
        surface: Surface::Plane {
            axis: 2,
            at: 350.0,
            min: [-100.0, -100.0, 0.0],
            max: [100.0, 100.0, 0.0],
        },
        imprint: false,
    });
    Assembly {
        name: "paper_joint".into(),
        parts,
        materials: steel(),
        interfaces,
        faces,
        supports,
        loads: vec![FaceLoad {
            face: "LOAD_TOP".into(),
            case: "TOP".into(),
            action: Action::Traction([0.0, 0.0, -45.0]),
            dead: false,
        }],
        symmetry: vec![SymmetryPlane { axis: 0 }, SymmetryPlane { axis: 1 }],
        clearances: vec![],
        welds: vec![],
        preloads: vec![],
        sections: vec![],
        grips: vec![],
    }
}

/// Two plates 80 × 60 × 10 mm, lapped at z = 0, with one bolt of 16 mm diameter.
pub(crate) fn lap_joint() -> Assembly {
    let hole = |z: f64, length: f64| Solid::Cylinder {
        base: [0.0, 0.0, z],
        axis: Z,
        radius: 8.0,
        length,
        segments: 16,
    };
    let lap = |name: &str, label: &str, z: f64| {
        let whole = boxed([-40.0, -30.0, z], [40.0, 30.0, z + 10.0]);
        let mid =
            MidPlane { axis: 2, at: z + 5.0, min: [-40.0, -30.0, 0.0], max: [40.0, 30.0, 0.0] };
        Part {
            mid_planes: vec![mid],
            ..part(
                name,
                label,
                PartRole::Plate,
                Solid::Difference(vec![whole.clone(), hole(z, 10.0)]),
                vec![whole],
                12.0,
            )
        }
    };
    let bolt = vec![
        hole(-10.0, 20.0),
        hexagon([0.0, 0.0, 10.0], X, Y, 24.0, 10.0),
        hexagon([0.0, 0.0, -23.0], X, Y, 24.0, 13.0),
    ];
    let face = |name: &str, part: &str, x: f64| FaceRule {
        name: name.into(),
        part: part.into(),
        surface: Surface::Plane {
            axis: 0,
            at: x,
            min: [0.0, -30.0, -10.0],
            max: [0.0, 30.0, 10.0],
        },
        imprint: false,
    };
    Assembly {
        name: "lap".into(),
        parts: vec![
            lap("UPPER", "upper plate", 0.0),
            lap("LOWER", "lower plate", -10.0),
            part("BOLT", "bolt", PartRole::Bolt, Solid::Union(bolt.clone()), bolt, 10.0),
        ],
        materials: steel(),
        interfaces: vec![
            contact("UPPER", "LOWER", None),
            contact("BOLT", "UPPER", None),
            contact("BOLT", "LOWER", None),
        ],
        faces: vec![face("BASE", "LOWER", -40.0), face("PULL", "UPPER", 40.0)],
        supports: vec![FaceSupport { face: "BASE".into(), fix: [true; 3], ground: None }],
        loads: vec![FaceLoad {
            face: "PULL".into(),
            case: "PULL".into(),
            action: Action::Traction([10.0, 0.0, 0.0]),
            dead: false,
        }],
        symmetry: vec![SymmetryPlane { axis: 1 }],
        clearances: vec![],
        welds: vec![],
        preloads: vec![],
        sections: vec![],
        grips: vec![],
    }
}

/// Moves one part of a joint with its convex pieces and mid-thickness planes.
pub(crate) fn move_part(joint: &mut Assembly, name: &str, by: [f64; 3]) {
    let part = joint.parts.iter_mut().find(|p| p.name == name).expect("the fixture has this part");
    translate(&mut part.solid, by);
    part.convex.iter_mut().for_each(|s| translate(s, by));
    for m in &mut part.mid_planes {
        m.at += by[m.axis];
        for k in 0..3 {
            m.min[k] += by[k];
            m.max[k] += by[k];
        }
    }
}

fn translate(solid: &mut Solid, by: [f64; 3]) {
    let shift = |p: &mut [f64; 3]| (0..3).for_each(|k| p[k] += by[k]);
    match solid {
        Solid::Box { min, max } => {
            shift(min);
            shift(max);
        }
        Solid::Prism { origin, .. } => shift(origin),
        Solid::Cylinder { base, .. } => shift(base),
        Solid::Union(list) | Solid::Difference(list) => {
            list.iter_mut().for_each(|s| translate(s, by))
        }
    }
}
