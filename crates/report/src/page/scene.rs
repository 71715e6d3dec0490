//! What the 3-D view of the page shows: meshes, motions and fields, packed as text.
//!
//! Numbers are quantised to 16 bits between their extremes, which is finer than a screen shows.
//! `viewer/scene.js` unpacks them.

use super::base64::base64;
use crate::draw::options::Colours;
use crate::draw::palette::{Groups, group_colour};
use crate::markdown::words::case_title;
use crate::result::result_file::ResultFile;
use crate::words::Words;
use bracket_base::math::vec3::V3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::mesh::TetMesh;
use serde::Serialize;

/// Most packed text of a page \[bytes\]: cases beyond it are left out and named.
const MOST: usize = 3_600_000;
/// Largest step of a quantised number.
const STEPS: f64 = 65_535.0;
/// Part of the values that the colours of a field cover: a few peaks do not make the rest dark.
const COVERED: f64 = 0.995;

/// The scene of a page.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Scene {
    /// The parts of all shapes.
    pub parts: Vec<Part>,
    /// Axes of the planes of symmetry.
    pub mirror: Vec<usize>,
    /// Meshes.
    pub shapes: Vec<Shape>,
    /// Fields on the shapes.
    pub views: Vec<View>,
    /// Colours of the fields from low to high, by name.
    scales: Vec<Scale>,
    /// Load cases that are not in the page because it would be too large.
    pub left_out: Vec<String>,
    #[serde(skip)]
    size: usize,
}

/// A part of the joint.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Its group: parts whose names differ in the number have one colour.
    pub group: String,
    /// Red, green, blue from 0 to 255.
    colour: [f32; 3],
    /// Yield strength \[MPa\], where the material has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fy: Option<f64>,
    /// What is known of it: load case, quantity, value.
    pub facts: Vec<[Text; 3]>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Scale {
    name: &'static str,
    stops: Vec<[f32; 3]>,
}

/// A mesh.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Shape {
    /// Number of its nodes.
    pub nodes: usize,
    /// Its parts with the number of tetrahedra of each, in the order of the tetrahedra.
    pub parts: Vec<(usize, usize)>,
    /// Coordinates, 3 a node.
    points: Packed,
    /// Nodes of the tetrahedra.
    tets: String,
    /// True if nodes have 32 bits each; 16 otherwise.
    wide: bool,
    /// The tetrahedron of the mesh that each of the shape is.
    #[serde(skip)]
    order: Vec<usize>,
    #[serde(skip)]
    origin: Vec<V3>,
}

/// Numbers between `low` and `high`.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Packed {
    low: f64,
    high: f64,
    /// Steps from `low` in 16 bits each, low byte first, base 64.
    steps: String,
}

/// Values of a field.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// One a node.
    Nodes(Vec<f64>),
    /// Four a tetrahedron, one a corner.
    Corners(Vec<f64>),
    /// Three a face: nodes and values.
    Faces(Vec<([u32; 3], [f64; 3])>),
    /// The length of the motion.
    Motion,
}

/// A field of a load case on a shape.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct View {
    /// Load case.
    pub case: String,
    /// What it shows.
    pub title: Text,
    /// Unit; empty for relative values.
    pub unit: String,
    /// Number of its shape.
    pub shape: usize,
    /// `nodes`, `corners`, `faces` or `motion`.
    on: &'static str,
    /// Name of its colours.
    colours: &'static str,
    /// Values.
    #[serde(skip_serializing_if = "Option::is_none")]
    values: Option<Packed>,
    /// Nodes of faces.
    #[serde(skip_serializing_if = "String::is_empty")]
    faces: String,
    /// Of their nodes, as of the shape.
    wide: bool,
    /// Displacement of the nodes, 3 each.
    #[serde(skip_serializing_if = "Option::is_none")]
    motion: Option<Packed>,
    /// Values at the ends of the colours; absent for the length of a motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    shown: Option<[f64; 2]>,
}

/// A field before it is packed.
#[derive(Clone, Debug)]
pub struct Field<'a> {
    /// What it shows.
    pub title: Text,
    /// Unit; empty for relative values.
    pub unit: &'static str,
    /// Its values.
    pub values: Values,
    /// Its colours.
    pub colours: Colours,
    /// Values at the ends of the colours; from the values where it is `None`.
    pub shown: Option<[f64; 2]>,
    /// Displacement of the nodes.
    pub motion: Option<&'a [V3]>,
}

impl Scene {
    /// A scene without shapes, to be completed by reflection along `mirror`.
    pub fn new(mirror: &[usize]) -> Self {
        let scale = |c: Colours| Scale { name: c.name(), stops: c.stops().to_vec() };
        let scales = [Colours::Spectrum, Colours::Fire, Colours::Violet].map(scale).to_vec();
        Self { mirror: mirror.to_vec(), scales, ..Self::default() }
    }

    /// Adds the fields of a load case on a mesh, unless the page would become too large.
    /// `strengths` are those of the bodies \[MPa\].
    pub fn add(
        &mut self,
        case: &str,
        mesh: &TetMesh,
        strengths: &[Option<f64>],
        fields: Vec<Field<'_>>,
    ) {
        let known = self.shapes.iter().position(|s| s.origin == mesh.nodes);
        let number = known.unwrap_or(self.shapes.len());
        let new = if known.is_none() { Some(self.shape(mesh, strengths)) } else { None };
        let shape = new.as_ref().unwrap_or_else(|| &self.shapes[number]);
        let views: Vec<View> = fields.into_iter().map(|f| view(f, case, (number, shape))).collect();
        let more = new.as_ref().map_or(0, Shape::size);
        let size = self.size + more + views.iter().map(View::size).sum::<usize>();
        if size <= MOST || self.views.is_empty() {
            self.size = size;
            self.shapes.extend(new);
            self.views.extend(views);
        } else if !self.left_out.iter().any(|c| c == case) {
            self.left_out.push(case.into());
        }
    }

    fn shape(&mut self, mesh: &TetMesh, strengths: &[Option<f64>]) -> Shape {
        let groups = Groups::of(&mesh.bodies);
        let mut part_of = Vec::new();
        for (b, name) in mesh.bodies.iter().enumerate() {
            let known = self.parts.iter().position(|p| p.name == *name);
            part_of.push(known.unwrap_or(self.parts.len()));
            if known.is_none() {
                let group = groups.names[groups.of_body[b]].clone();
                let colour = group_colour(groups.of_body[b]);
                let fy = strengths.get(b).copied().flatten();
                let name = name.clone();
                self.parts.push(Part { name, group, colour, fy, facts: Vec::new() });
            }
        }
        let mut order: Vec<usize> = (0..mesh.tets.len()).collect();
        order.sort_by_key(|e| mesh.tet_body[*e]);
        let runs = order.chunk_by(|a, b| mesh.tet_body[*a] == mesh.tet_body[*b]);
        let parts = runs.map(|r| (part_of[mesh.tet_body[r[0]] as usize], r.len())).collect();
        let nodes = order.iter().flat_map(|e| mesh.tets[*e]);
        Shape {
            nodes: mesh.nodes.len(),
            parts,
            points: pack(mesh.nodes.iter().flatten().copied()),
            tets: indices(nodes, is_wide(mesh.nodes.len())),
            wide: is_wide(mesh.nodes.len()),
            order,
            origin: mesh.nodes.clone(),
        }
    }

    /// The scene as JSON, with titles of fields and facts of parts in the language of `words`.
    pub fn json(&self, words: &Words) -> serde_json::Result<String> {
        let mut said = self.clone();
        let say = |text: &mut Text| *text = Text::given(words.say(text));
        said.views.iter_mut().for_each(|v| say(&mut v.title));
        said.parts.iter_mut().flat_map(|p| &mut p.facts).flatten().for_each(say);
        serde_json::to_string(&said)
    }

    /// Adds to the parts what the result knows of them: forces of bolts and of contacts.
    pub fn add_facts(&mut self, result: &ResultFile) {
        for case in &result.cases {
            let Some(forces) = &case.static_forces else { continue };
            let kn = |force: f64| Text::given(format!("{:.1} kN", 1e-3 * force));
            let factor = format!("{:.3}", forces.load_factor);
            let place = say!("{}, load factor {}", case_title(case, result), factor);
            let mut add = |name: &str, what: Text, value: Text| {
                let part = self.parts.iter_mut().find(|p| p.name == name);
                part.into_iter().for_each(|p| {
                    p.facts.push([place.clone(), what.clone(), value.clone()]);
                });
            };
            for b in &forces.bolts {
                add(&b.bolt, "tension".into(), kn(b.tension));
                add(&b.bolt, "shear".into(), kn(b.shear));
            }
            for c in &forces.contacts {
                let [a, b] = &c.between;
                for (part, other) in [(a, b), (b, a)] {
                    add(part, say!("compression from {}", other), kn(c.compression));
                }
            }
        }
    }
}

fn view(field: Field<'_>, case: &str, (number, shape): (usize, &Shape)) -> View {
    let mut view = View {
        case: case.into(),
        title: field.title,
        unit: field.unit.into(),
        shape: number,
        wide: shape.wide,
        colours: field.colours.name(),
        motion: field.motion.map(|m| pack(m.iter().flatten().copied())),
        ..View::default()
    };
    let values: Vec<f64> = match field.values {
        Values::Nodes(values) => {
            view.on = "nodes";
            values
        }
        Values::Corners(values) => {
            view.on = "corners";
            shape.order.iter().flat_map(|e| values[4 * e..4 * e + 4].iter().copied()).collect()
        }
        Values::Faces(faces) => {
            view.on = "faces";
            view.faces = indices(faces.iter().flat_map(|f| f.0), shape.wide);
            faces.iter().flat_map(|f| f.1).collect()
        }
        Values::Motion => {
            view.on = "motion";
            return view;
        }
    };
    view.shown = Some(field.shown.unwrap_or_else(|| covered(&values)));
    view.values = Some(pack(values.into_iter()));
    view
}

impl Shape {
    fn size(&self) -> usize {
        self.points.steps.len() + self.tets.len()
    }
}

impl View {
    fn size(&self) -> usize {
        let packed = [&self.values, &self.motion];
        self.faces.len() + packed.into_iter().flatten().map(|p| p.steps.len()).sum::<usize>()
    }
}

/// From the least value, at most 0, to that below which almost all values lie.
fn covered(values: &[f64]) -> [f64; 2] {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let at = ((sorted.len() as f64 * COVERED) as usize).min(sorted.len().saturating_sub(1));
    let high = sorted.get(at).copied().unwrap_or(0.0);
    let low = sorted.first().copied().unwrap_or(0.0).min(0.0);
    [low, if high > low { high } else { low + 1.0 }]
}

fn pack(values: impl Iterator<Item = f64> + Clone) -> Packed {
    let finite = || values.clone().filter(|v| v.is_finite());
    let low = finite().fold(f64::INFINITY, f64::min);
    let high = finite().fold(f64::NEG_INFINITY, f64::max);
    let (low, high) = if low <= high { (low, high) } else { (0.0, 0.0) };
    let step = if high > low { STEPS / (high - low) } else { 0.0 };
    let bytes: Vec<u8> = values
        .flat_map(|v| {
            // a NaN becomes 0, the least value
            (((v - low) * step).round() as u16).to_le_bytes()
        })
        .collect();
    Packed { low, high, steps: base64(&bytes) }
}

/// True if 16 bits do not hold the numbers of so many nodes.
fn is_wide(nodes: usize) -> bool {
    nodes > usize::from(u16::MAX) + 1
}

fn indices(nodes: impl Iterator<Item = u32>, wide: bool) -> String {
    let width = if wide { 4 } else { 2 };
    let bytes: Vec<u8> = nodes.flat_map(|n| n.to_le_bytes().into_iter().take(width)).collect();
    base64(&bytes)
}
