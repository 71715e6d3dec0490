//! Faults of meshes and mesh files.

use bracket_base::diag::{Diagnostic, Diagnostics};
use std::path::PathBuf;

/// A place in a mesh file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MshPlace {
    /// The file.
    pub file: PathBuf,
    /// Line, from 1; 0: the whole file.
    pub line: usize,
}

/// A fault of the mesh stage.
#[derive(Debug, thiserror::Error)]
pub enum MeshError {
    /// The file cannot be opened or read.
    #[error("the mesh file `{}` cannot be read: {source}", at.file.display())]
    Io {
        /// Where.
        at: MshPlace,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// Not a gmsh file.
    #[error("this is not a gmsh mesh: the first line is not `$MeshFormat`")]
    NotGmsh {
        /// Where.
        at: MshPlace,
    },
    /// A version other than 2.2 or 4.1.
    #[error("gmsh format {version} is not read, only 2.2 and 4.1")]
    Version {
        /// Where.
        at: MshPlace,
        /// The version found.
        version: String,
    },
    /// A binary file.
    #[error("the mesh file is binary, only ASCII is read")]
    Binary {
        /// Where.
        at: MshPlace,
    },
    /// A section is absent.
    #[error("the mesh file has no section `${section}`")]
    MissingSection {
        /// Where.
        at: MshPlace,
        /// Its name.
        section: &'static str,
    },
    /// The file ends inside a section.
    #[error("the mesh file ends inside `${section}`: it is cut off")]
    Truncated {
        /// Where.
        at: MshPlace,
        /// Name of the section.
        section: String,
    },
    /// A line that does not conform to the format.
    #[error("expected {expected} in `${section}`, found `{found}`")]
    Malformed {
        /// Where.
        at: MshPlace,
        /// The section.
        section: String,
        /// Content that the format requires there.
        expected: &'static str,
        /// Content of the file there.
        found: String,
    },
    /// A tag used twice, of a node, an element or a name.
    #[error("{what} is defined twice")]
    Repeated {
        /// Where.
        at: MshPlace,
        /// For example ``node 7``.
        what: String,
    },
    /// A coordinate that is not finite.
    #[error("node {node} has the coordinate {value}, which is not a finite number")]
    NotFinite {
        /// A coordinate that is NaN or infinite.
        at: MshPlace,
        /// Tag of the node.
        node: u64,
        /// The value.
        value: f64,
    },
    /// An element refers to a node that is absent.
    #[error("element {element} uses node {node}, which the file does not contain")]
    UnknownNode {
        /// Where.
        at: MshPlace,
        /// Tag of the element.
        element: u64,
        /// Tag of the node.
        node: u64,
    },
    /// An element block refers to an entity that is absent from `$Entities` (4.1).
    #[error("an element block lies on {kind} {tag}, which `$Entities` does not contain")]
    UnknownEntity {
        /// Where.
        at: MshPlace,
        /// `surface` or `volume`.
        kind: &'static str,
        /// Its tag.
        tag: i64,
    },
    /// An element of higher order.
    #[error("element {element} is a {kind}: only 4-node tetrahedra and 3-node triangles are read")]
    HigherOrder {
        /// Where.
        at: MshPlace,
        /// Tag of the element.
        element: u64,
        /// Description of its type.
        kind: &'static str,
    },
    /// An element that is neither a tet nor a triangle.
    #[error("element {element} is a {kind}: only 4-node tetrahedra and 3-node triangles are read")]
    OtherShape {
        /// Where.
        at: MshPlace,
        /// Tag of the element.
        element: u64,
        /// Description of its type.
        kind: &'static str,
    },
    /// The file contains no tets.
    #[error("the mesh contains no tetrahedron")]
    NoTets {
        /// Where.
        at: MshPlace,
    },
    /// A tet in no physical volume.
    #[error("tetrahedron {element} belongs to no physical volume")]
    NoBody {
        /// Where.
        at: MshPlace,
        /// Tag of the element.
        element: u64,
    },
    /// A volume that belongs to two physical volumes.
    #[error("volume {tag} belongs to {count} physical volumes, a body is one")]
    TwoBodies {
        /// Where.
        at: MshPlace,
        /// Tag of the volume.
        tag: i64,
        /// Number of physical volumes.
        count: usize,
    },
    /// A tet with a volume of nearly zero.
    #[error(
        "tetrahedron {element} is flat: its volume is {volume:e} mm³, at least {limit:e} mm³ is \
         needed for its size"
    )]
    Flat {
        /// Where.
        at: MshPlace,
        /// Tag of the element.
        element: u64,
        /// Its volume \[mm³\].
        volume: f64,
        /// The limit \[mm³\].
        limit: f64,
    },
    /// A tet that is flat or inverted and could not be mended.
    #[error("a tetrahedron of the mesh is flat and could not be mended: {why}")]
    NotMended {
        /// What stands against it.
        why: String,
    },
    /// Two elements with the same nodes.
    #[error("{kind} {element} has the same nodes as {kind} {first}")]
    Duplicate {
        /// Where.
        at: MshPlace,
        /// `tetrahedron` or `triangle`.
        kind: &'static str,
        /// Tag of the later element.
        element: u64,
        /// Tag of the earlier element.
        first: u64,
    },
    /// Two tets on the same side of their common face, or a face of three tets.
    #[error(
        "tetrahedron {element} is inverted or overlaps tetrahedron {other}: both lie on the same \
         side of their common face"
    )]
    Folded {
        /// Where.
        at: MshPlace,
        /// Tag of the later element.
        element: u64,
        /// Tag of the other element.
        other: u64,
    },
    /// Two nodes of one body that are closer than the distance at which nodes of different bodies
    /// are merged.
    #[error(
        "two nodes of body `{body}` near ({}, {}, {}) mm lie within {distance:.1e} mm of each \
         other",
        x[0], x[1], x[2]
    )]
    NearNodes {
        /// Name of the body.
        body: String,
        /// Where \[mm\].
        x: [f64; 3],
        /// Nodes closer than this are merged \[mm\].
        distance: f64,
    },
    /// Two bodies whose triangles do not match where they meet.
    #[error(
        "the triangles of bodies `{a}` and `{b}` do not match where they meet, near \
         ({}, {}, {}) mm",
        x[0], x[1], x[2]
    )]
    NotMatching {
        /// Name of one body.
        a: String,
        /// Name of the other.
        b: String,
        /// Where \[mm\].
        x: [f64; 3],
    },
    /// A named triangle that is not a face of any tet.
    #[error(
        "triangle {element} of the physical surface `{surface}` is not a face of any tetrahedron"
    )]
    LooseTriangle {
        /// Where.
        at: MshPlace,
        /// Tag of the element.
        element: u64,
        /// Name of its physical surface.
        surface: String,
    },
}

impl MeshError {
    /// Stable code, place and remedy.
    fn parts(&self) -> (&'static str, Option<&MshPlace>, &'static str) {
        use MeshError as E;
        let again =
            "write the mesh again with gmsh; the file is cut off, damaged or was edited by hand";
        match self {
            E::Io { at, .. } => (
                "mesh/read",
                Some(at),
                "check the path, which is relative to the file that names it, and the permission \
                 to read it",
            ),
            E::NotGmsh { at } => (
                "mesh/not-gmsh",
                Some(at),
                "save the mesh in gmsh: `gmsh -3 model.geo -format msh41`",
            ),
            E::Version { at, .. } => (
                "mesh/version",
                Some(at),
                "save with `Mesh.MshFileVersion = 4.1;` (or 2.2): `gmsh -format msh41`",
            ),
            E::Binary { at } => ("mesh/binary", Some(at), "save with `Mesh.Binary = 0;`"),
            E::MissingSection { at, .. } => (
                "mesh/missing-section",
                Some(at),
                "write the mesh with gmsh after meshing in three dimensions: `gmsh -3`",
            ),
            E::Truncated { at, .. } => (
                "mesh/truncated",
                Some(at),
                "write the file again and check that the disk is not full",
            ),
            E::Malformed { at, .. } => ("mesh/malformed", Some(at), again),
            E::Repeated { at, .. } => ("mesh/repeated", Some(at), again),
            E::NotFinite { at, .. } => ("mesh/not-finite", Some(at), again),
            E::UnknownNode { at, .. } => ("mesh/unknown-node", Some(at), again),
            E::UnknownEntity { at, .. } => {
                ("mesh/unknown-entity", Some(at), "save an unpartitioned mesh with its entities")
            }
            E::HigherOrder { at, .. } => (
                "mesh/order",
                Some(at),
                "mesh with `Mesh.ElementOrder = 1;`: the analysis adds its own mid-side nodes",
            ),
            E::OtherShape { at, .. } => (
                "mesh/shape",
                Some(at),
                "mesh with tetrahedra: no `Recombine`, no structured or extruded layers",
            ),
            E::NoTets { at } => (
                "mesh/no-tets",
                Some(at),
                "mesh in three dimensions (`gmsh -3`) with a `Physical Volume`",
            ),
            E::NoBody { at, .. } => (
                "mesh/no-body",
                Some(at),
                "put every volume in one `Physical Volume(\"NAME\")`: it becomes a body",
            ),
            E::TwoBodies { at, .. } => {
                ("mesh/two-bodies", Some(at), "put every volume in one `Physical Volume` only")
            }
            E::Flat { at, .. } => (
                "mesh/flat",
                Some(at),
                "remesh with `Mesh.Optimize = 1;` or `Mesh.Algorithm3D = 10;`, or heal the \
                 geometry",
            ),
            E::NotMended { .. } => ("mesh/flat", None, "choose other element sizes"),
            E::Duplicate { at, .. } => (
                "mesh/duplicate",
                Some(at),
                "remove the second copy: a volume meshed twice, or a surface named twice in one \
                 group",
            ),
            E::Folded { at, .. } => (
                "mesh/folded",
                Some(at),
                "remesh: check for overlapping volumes (use `BooleanFragments`) and moved nodes",
            ),
            E::NearNodes { .. } => (
                "mesh/near-nodes",
                None,
                "remove the sliver there, or write `nodes: shared` if the bodies already share \
                 their nodes",
            ),
            E::NotMatching { .. } => (
                "mesh/not-matching",
                None,
                "mesh the bodies together (`BooleanFragments` in gmsh), so that they share the \
                 faces where they meet",
            ),
            E::LooseTriangle { at, .. } => (
                "mesh/loose-triangle",
                Some(at),
                "keep only surfaces of meshed volumes in `Physical Surface`",
            ),
        }
    }
}

impl From<MeshError> for Diagnostic {
    fn from(error: MeshError) -> Self {
        let (code, at, help) = error.parts();
        let mut d = Diagnostic::input(code, error.to_string()).help(help);
        if let Some(at) = at {
            d.place.file = Some(at.file.clone());
            d.place.line = (at.line > 0).then_some(at.line);
        }
        d
    }
}

impl From<MeshError> for Diagnostics {
    fn from(error: MeshError) -> Self {
        Diagnostic::from(error).into()
    }
}
