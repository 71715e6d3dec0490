//! Scene → a script for gmsh's OpenCASCADE kernel.
//!
//! A `.geo` file is a program, so only numbers, fixed words and checked identifiers are written to
//! it. The script stops at the first error. The caller still checks the result, because gmsh exits
//! with success after many kinds of error.

use super::flat::{FlatPrism, FlatSolid};
use super::footprint::{self, Rectangle, footprints, weld_lines};
use super::scene::{Body, Scene};
use super::size::{self, SizeRule};
use crate::assembly::assembly::{MidPlane, OutlineEdge, Solid};
use bracket_base::math::vec3::{V3, along};
use std::fmt::Write;

/// Name of the file with target sizes, in the folder of the script.
pub const SIZES_FILE: &str = "sizes.pos";

/// Source of the element sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sizing {
    /// Computed from the parts' sizes.
    Rule(SizeRule),
    /// Read from the view in [`SIZES_FILE`].
    View,
}

/// Purpose of the script.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Purpose {
    /// A mesh: flat facets, imprinted footprints, shared common faces, element sizes.
    Mesh {
        /// Cut plates, flanges, webs and stiffeners at mid-thickness.
        layers: bool,
        /// Element sizes.
        sizes: Sizing,
    },
    /// A CAD file: true circles and arcs, each part separate.
    Cad,
}

/// Text of the script. The same scene and purpose give the same bytes.
pub fn script(scene: &Scene, purpose: Purpose) -> String {
    let mut w = Writer { text: String::new(), solids: 0, exact: purpose == Purpose::Cad };
    w.line("General.AbortOnError = 2;");
    w.line("General.NumThreads = 1;");
    w.line("SetFactory(\"OpenCASCADE\");");
    w.line("Geometry.OCCUnionUnify = 1;");
    w.line("Geometry.OCCBooleanPreserveNumbering = 1;");
    for (i, body) in scene.bodies.iter().enumerate() {
        let layers = matches!(purpose, Purpose::Mesh { layers: true, .. });
        let layered = layers.then_some(&body.part.mid_planes);
        let oblique = if layers { body.part.oblique_planes.as_slice() } else { &[] };
        let cuts = (!w.exact).then(|| scene.shank_cuts(body.part));
        let planes: Vec<MidPlane> =
            layered.into_iter().flatten().copied().chain(cuts.into_iter().flatten()).collect();
        w.body(i, body, &planes, oblique);
    }
    if let Purpose::Mesh { sizes, .. } = purpose {
        w.footprints(scene);
        w.fragments(scene.bodies.len());
        w.groups(scene);
        match sizes {
            Sizing::Rule(rule) => w.text.push_str(&size::fields(scene, &rule)),
            Sizing::View => {
                w.put(format_args!("Merge \"{SIZES_FILE}\";"));
                w.line("Field[1] = PostView;");
                w.line("Background Field = 1;");
            }
        }
        w.line("Mesh.MeshSizeFromPoints = 0;");
        w.line("Mesh.MeshSizeFromCurvature = 0;");
        w.line("Mesh.MeshSizeExtendFromBoundary = 0;");
        w.line("Mesh.Algorithm3D = 10;");
        // Halved plates cannot reach gmsh's default threshold of 0.3. That threshold would take
        // four fifths of the time to gain a degree or two.
        w.line("Mesh.OptimizeThreshold = 0.25;");
        w.line("Mesh.MshFileVersion = 2.2;");
        w.line("Mesh.Binary = 0;");
        w.line("Mesh.SaveAll = 0;");
    } else {
        w.line("Geometry.OCCTargetUnit = \"MM\";");
    }
    w.text
}

struct Writer {
    text: String,
    solids: usize,
    exact: bool,
}

impl Writer {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn put(&mut self, args: std::fmt::Arguments) {
        // Writing to a String cannot fail.
        let _ = self.text.write_fmt(args);
        self.text.push('\n');
    }

    /// One part: its solid, cut by symmetry planes and by planes inside it. The list `partI()`
    /// contains its volumes.
    fn body(&mut self, index: usize, body: &Body, planes: &[MidPlane], oblique: &[Vec<V3>]) {
        self.put(format_args!("// {}", body.part.name));
        if index > 0 {
            self.line("before() = Volume{:};");
        }
        let mut list = self.solid(&body.part.solid);
        for axis in body.cuts() {
            list = self.keep_positive(&list, axis, body);
        }
        self.inner_planes(&list, body, planes, oblique);
        self.put(format_args!("part{index}() = Volume{{:}};"));
        if index > 0 {
            self.put(format_args!("part{index}() -= before();"));
        }
    }

    /// A new name for a list of volumes.
    fn name(&mut self) -> String {
        self.solids += 1;
        format!("s{}()", self.solids)
    }

    fn solid(&mut self, solid: &Solid) -> String {
        match solid {
            Solid::Box { min, max } => {
                let name = self.name();
                let size = [max[0] - min[0], max[1] - min[1], max[2] - min[2]];
                self.put(format_args!(
                    "v = newv; Box(v) = {{{}, {}}}; {name} = {{v}};",
                    triple(*min),
                    triple(size)
                ));
                name
            }
            Solid::Prism { origin, u, v, start, edges, length } if self.exact => {
                self.exact_prism(*origin, *u, *v, *start, edges, *length)
            }
            Solid::Cylinder { base, axis, radius, length, .. } if self.exact => {
                let name = self.name();
                let d = axis.map(|c| c * length);
                self.put(format_args!(
                    "v = newv; Cylinder(v) = {{{}, {}, {radius}}}; {name} = {{v}};",
                    triple(*base),
                    triple(d)
                ));
                name
            }
            Solid::Prism { .. } | Solid::Cylinder { .. } => match FlatSolid::from_solid(solid) {
                FlatSolid::Prism(p) => self.prism(&p),
                FlatSolid::Union(_) | FlatSolid::Difference(_) => {
                    unreachable!("a primitive flattens to one prism")
                }
            },
            Solid::Union(list) => self.boolean("BooleanUnion", list),
            Solid::Difference(list) => self.boolean("BooleanDifference", list),
        }
    }

    fn boolean(&mut self, operation: &str, list: &[Solid]) -> String {
        let names: Vec<String> = list.iter().map(|s| self.solid(s)).collect();
        let Some((first, rest)) = names.split_first() else {
            let name = self.name();
            self.put(format_args!("{name} = {{}};"));
            return name;
        };
        if rest.is_empty() {
            return first.clone();
        }
        let name = self.name();
        let tools = rest.join(", ");
        self.put(format_args!(
            "{name} = {operation}{{ Volume{{{first}}}; Delete; }}{{ Volume{{{tools}}}; Delete; }};"
        ));
        name
    }

    fn prism(&mut self, prism: &FlatPrism) -> String {
        let corners: Vec<V3> = prism.polygon.iter().map(|&p| prism.point(p, 0.0)).collect();
        self.polygon(&corners);
        self.extrude(prism.w, prism.length)
    }

    /// A plane surface `s` with straight edges.
    fn polygon(&mut self, corners: &[V3]) {
        let n = corners.len();
        self.line("p = newp;");
        for (i, c) in corners.iter().enumerate() {
            self.put(format_args!("Point(p + {i}) = {{{}}};", triple(*c)));
        }
        self.line("l = newl;");
        for i in 0..n {
            self.put(format_args!("Line(l + {i}) = {{p + {i}, p + {}}};", (i + 1) % n));
        }
        self.put(format_args!("k = newll; Curve Loop(k) = {{l:l + {}}};", n - 1));
        self.line("s = news; Plane Surface(s) = {k};");
    }

    fn extrude(&mut self, w: V3, length: f64) -> String {
        let name = self.name();
        self.put(format_args!(
            "e() = Extrude {{{}}} {{ Surface{{s}}; }};",
            triple(w.map(|c| c * length))
        ));
        self.put(format_args!("{name} = {{e(1)}};"));
        name
    }

    fn exact_prism(
        &mut self,
        origin: V3,
        u: V3,
        v: V3,
        start: [f64; 2],
        edges: &[OutlineEdge],
        length: f64,
    ) -> String {
        let place = |p: [f64; 2]| along(along(origin, p[0], u), p[1], v);
        self.put(format_args!(
            "p = newp; Point(p) = {{{}}}; first = p; l = newl; n = 0;",
            triple(place(start))
        ));
        for (i, edge) in edges.iter().enumerate() {
            let last = i + 1 == edges.len();
            let (to, centre) = match edge {
                OutlineEdge::Line { to } => (*to, None),
                OutlineEdge::Arc { to, centre } => (*to, Some(*centre)),
            };
            if let Some(c) = centre {
                self.put(format_args!("c = newp; Point(c) = {{{}}};", triple(place(c))));
            }
            if last {
                self.line("q = first;");
            } else {
                self.put(format_args!("q = newp; Point(q) = {{{}}};", triple(place(to))));
            }
            match centre {
                Some(_) => self.put(format_args!("Circle(l + {i}) = {{p, c, q}}; p = q;")),
                None => self.put(format_args!("Line(l + {i}) = {{p, q}}; p = q;")),
            }
        }
        self.put(format_args!("k = newll; Curve Loop(k) = {{l:l + {}}};", edges.len() - 1));
        self.line("s = news; Plane Surface(s) = {k};");
        self.extrude(bracket_base::math::vec3::cross(u, v), length)
    }

    /// Intersection with the half space `x[axis] ≥ 0`, as a box around the part.
    fn keep_positive(&mut self, list: &str, axis: usize, body: &Body) -> String {
        let margin = 10.0;
        let mut min = body.whole.min.map(|c| c - margin);
        min[axis] = 0.0;
        let max = body.whole.max.map(|c| c + margin);
        let size = [max[0] - min[0], max[1] - min[1], max[2] - min[2]];
        let name = self.name();
        self.put(format_args!("v = newv; Box(v) = {{{}, {}}};", triple(min), triple(size)));
        self.put(format_args!(
            "{name} = BooleanIntersection{{ Volume{{{list}}}; Delete; }}{{ Volume{{v}}; Delete; \
             }};"
        ));
        name
    }

    /// Cuts the volumes by the pieces of planes (mid-thickness planes, sections of shanks)
    /// inside them. A piece that ends inside the part stays as an inner face, so it needs no exact
    /// fit.
    fn inner_planes(&mut self, list: &str, body: &Body, planes: &[MidPlane], oblique: &[Vec<V3>]) {
        let rectangles = planes.iter().filter_map(|&MidPlane { axis, at, min, max }| {
            Some(Rectangle { axis, at, min, max }.clip(&body.planes)?.corners().to_vec())
        });
        let polygons = oblique.iter().filter_map(|p| footprint::clipped(p, &body.planes));
        let kept: Vec<Vec<V3>> = rectangles.chain(polygons).collect();
        if kept.is_empty() {
            return;
        }
        self.line("m() = {};");
        for plane in kept {
            self.polygon(&plane);
            self.put(format_args!(
                "t() = BooleanIntersection{{ Surface{{s}}; Delete; }}{{ Volume{{{list}}}; }};"
            ));
            self.line("m() += t();");
        }
        self.put(format_args!(
            "t() = BooleanFragments{{ Volume{{{list}}}; Delete; }}{{ Surface{{m()}}; Delete; }};"
        ));
    }

    fn footprints(&mut self, scene: &Scene) {
        self.line("f() = {};");
        for drawn in footprints(scene).into_iter().chain(weld_lines(scene)) {
            self.polygon(&drawn.corners());
            self.line("f() += {s};");
        }
    }

    /// Merges common faces, so that the mesh is conformal.
    fn fragments(&mut self, bodies: usize) {
        let parts: Vec<String> = (0..bodies).map(|i| format!("part{i}()")).collect();
        let parts = parts.join(", ");
        self.line("If (#f() > 0)");
        self.put(format_args!(
            "t() = BooleanFragments{{ Volume{{{parts}}}; Delete; }}{{ Surface{{f()}}; Delete; }};"
        ));
        self.line("Else");
        self.put(format_args!("t() = BooleanFragments{{ Volume{{{parts}}}; Delete; }}{{ }};"));
        self.line("EndIf");
    }

    fn groups(&mut self, scene: &Scene) {
        for (i, body) in scene.bodies.iter().enumerate() {
            self.put(format_args!(
                "Physical Volume(\"{}\", {}) = {{part{i}()}};",
                body.part.name,
                i + 1
            ));
        }
    }
}

/// `x, y, z` with the shortest digits that read back to the same numbers.
fn triple(p: V3) -> String {
    let [x, y, z] = p.map(|c| c + 0.0);
    format!("{x}, {y}, {z}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::fixtures::{lap_joint, paper_joint};

    const MESH: Purpose = Purpose::Mesh {
        layers: true,
        sizes: Sizing::Rule(SizeRule {
            factor: 1.0,
            growth: 0.5,
            across_footprint: 2.0,
            span_growth: 0.1,
            span_limit: 2.0,
            at_hinges: None,
        }),
    };

    #[test]
    fn stops_at_the_first_error_and_repeats_itself_exactly() {
        let joint = paper_joint();
        let text = script(&Scene::new(&joint, false), MESH);
        assert!(text.starts_with("General.AbortOnError = 2;\n"));
        assert_eq!(text, script(&Scene::new(&joint, false), MESH));
    }

    #[test]
    fn holds_no_word_of_the_user() {
        let mut joint = lap_joint();
        joint.name = "x\"; System(\"rm\");".into();
        for p in &mut joint.parts {
            p.label = "evil; System(\"rm\")".into();
        }
        for purpose in [MESH, Purpose::Mesh { layers: true, sizes: Sizing::View }, Purpose::Cad] {
            let text = script(&Scene::new(&joint, false), purpose);
            assert!(!text.contains("System") && !text.contains("evil"));
        }
    }

    #[test]
    fn quarter_leaves_out_the_other_parts_and_cuts_what_crosses() {
        let joint = paper_joint();
        let quarter = script(&Scene::new(&joint, false), MESH);
        assert_eq!(quarter.matches("Physical Volume").count(), 6);
        // COLUMN in x and y, PLATE_R and BEAM_R in y
        assert_eq!(quarter.matches("BooleanIntersection{ Volume").count(), 4);
        let full = script(&Scene::new(&joint, true), MESH);
        assert_eq!(full.matches("Physical Volume").count(), 17);
        assert_eq!(full.matches("BooleanIntersection{ Volume").count(), 0);
    }

    #[test]
    fn mid_planes_on_a_symmetry_plane_are_not_cut_again() {
        let joint = paper_joint();
        let cuts = |full: bool, layers: bool| {
            let sizes = Sizing::Rule(SizeRule::default());
            let purpose = Purpose::Mesh { layers, sizes };
            script(&Scene::new(&joint, full), purpose)
                .matches("BooleanIntersection{ Surface")
                .count()
        };
        // column flange, two stiffeners; plate; two beam flanges, support stiffener
        assert_eq!(cuts(false, true), 7);
        // column: two flanges, web, four stiffeners; each side: plate, two flanges, web, two
        // stiffeners
        assert_eq!(cuts(true, true), 7 + 2 * 6);
        assert_eq!(cuts(true, false), 0);
    }
}
