//! Connection templates: what a template file may say, and where the shipped ones are.
//!
//! A template is data. Adding a connection type means adding a file; no line of Rust knows a
//! template by name.

use super::end_plate::EndPlateEntry;
use super::origin::Origin;
use crate::diag::{Diagnostic, Diagnostics, did_you_mean};
use crate::spec::connection::ParameterValue;
use crate::spec::expr::Expr;
use crate::spec::loads::{ActionPoint, LoadSpec};
use crate::spec::yaml::{self, Parsed};
use crate::text_file;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The shipped templates: name and text, in the order of the names. They are the files of
/// `templates/`.
pub const SHIPPED: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/templates.rs"));

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Along the beams.
    X,
    /// Across.
    Y,
    /// Up.
    Z,
}

impl Axis {
    /// 0, 1, 2.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// A connection template.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Template {
    /// Name, as a spec says it.
    pub name: String,
    /// One line.
    pub title: String,
    /// What it models.
    #[serde(default)]
    pub about: String,
    /// Members the spec must give.
    pub members: Vec<MemberRole>,
    /// Parameters of the spec.
    pub parameters: Vec<Parameter>,
    /// Named intermediate values.
    #[serde(default)]
    pub define: Vec<Definition>,
    /// Conditions on the values.
    #[serde(default)]
    pub checks: Vec<Check>,
    /// Members and plates.
    pub parts: Vec<PartEntry>,
    /// Bolts.
    #[serde(default)]
    pub bolts: Vec<BoltEntry>,
    /// Open interfaces beside those of the bolts.
    #[serde(default)]
    pub contacts: Vec<ContactEntry>,
    /// Fillet welds; where the throat is zero the parts stay tied.
    #[serde(default)]
    pub welds: Vec<WeldEntry>,
    /// Faces that loads can name.
    #[serde(default)]
    pub sections: Vec<SectionEntry>,
    /// Member ends that actions can name.
    #[serde(default)]
    pub ends: Vec<EndEntry>,
    /// Supports.
    #[serde(default)]
    pub supports: Vec<SupportEntry>,
    /// Distances to keep.
    #[serde(default)]
    pub clearances: Vec<ClearanceEntry>,
    /// What the hand checks of the code see of it; absent: none are made.
    pub hand_checks: Option<EndPlateEntry>,
    /// Load of the starter spec.
    pub starter_load: Option<LoadSpec>,
}

/// A member role.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MemberRole {
    /// Role, the key under `members`.
    pub role: String,
    /// What it is.
    pub about: String,
    /// Profile of the starter spec.
    pub profile: String,
    /// Steel of the starter spec.
    pub steel: String,
}

/// What a parameter holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ParameterKind {
    /// A length.
    Length,
    /// A pure number.
    Number,
    /// True or false.
    Flag,
    /// A list of lengths; `name.1` is the first.
    Lengths,
}

/// A parameter of the spec. `plate.*` and `bolts.*` stand there; everything else under
/// `parameters`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Parameter {
    /// Name.
    pub name: String,
    /// What it holds.
    pub kind: ParameterKind,
    /// Smallest value allowed.
    pub min: Option<Expr>,
    /// Largest value allowed.
    pub max: Option<Expr>,
    /// Length of a list, if fixed.
    pub count: Option<usize>,
    /// Value where the spec gives none; absent: the spec must give one.
    pub default: Option<Default>,
    /// Value of the starter where there is no default, as the spec would say it.
    pub example: Option<ParameterValue>,
    /// What it is.
    pub about: String,
}

/// A default: one expression, or one per entry of a list.
#[derive(Clone, Debug)]
pub enum Default {
    /// One value.
    One(Expr),
    /// A list.
    Many(Vec<Expr>),
}

impl<'de> Deserialize<'de> for Default {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        use serde::de::{self, IntoDeserializer};
        struct V;
        impl<'de> de::Visitor<'de> for V {
            type Value = Default;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("an expression or a list of expressions")
            }
            fn visit_bool<E: de::Error>(self, v: bool) -> Result<Default, E> {
                Expr::deserialize(v.into_deserializer()).map(Default::One)
            }
            fn visit_f64<E: de::Error>(self, v: f64) -> Result<Default, E> {
                Expr::deserialize(v.into_deserializer()).map(Default::One)
            }
            fn visit_i64<E: de::Error>(self, v: i64) -> Result<Default, E> {
                self.visit_f64(v as f64)
            }
            fn visit_u64<E: de::Error>(self, v: u64) -> Result<Default, E> {
                self.visit_f64(v as f64)
            }
            fn visit_str<E: de::Error>(self, v: &str) -> Result<Default, E> {
                Expr::deserialize(v.into_deserializer()).map(Default::One)
            }
            fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<Default, A::Error> {
                let mut list = Vec::new();
                while let Some(e) = seq.next_element()? {
                    list.push(e);
                }
                Ok(Default::Many(list))
            }
        }
        d.deserialize_any(V)
    }
}

impl JsonSchema for Default {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Default".into()
    }
    fn json_schema(g: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let expression = g.subschema_for::<Expr>();
        schemars::json_schema!({
            "description": "A default: one expression, or one per entry of a list.",
            "anyOf": [expression, {"type": "array", "items": expression}],
        })
    }
}

/// A named intermediate value.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Definition {
    /// Name.
    pub name: String,
    /// Value.
    pub value: Expr,
}

/// One loop; several make nested loops, the last runs fastest.
///
/// In expressions `each` is the value and `each.n` the number from 1; in texts `{#each}` is the
/// label (or the number) and `{@each}` the index from 0.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Loop {
    /// Name of the variable.
    pub each: String,
    /// Its values; or
    #[serde(default)]
    pub values: Vec<Expr>,
    /// the list parameter it runs over.
    pub list: Option<String>,
    /// Labels for names.
    #[serde(default)]
    pub labels: Vec<String>,
}

/// A condition on the values.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Check {
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// What must hold.
    pub that: Expr,
    /// Path in the spec to point at.
    pub at: String,
    /// Message if it does not.
    pub say: String,
    /// Cure.
    pub help: String,
}

/// Role of a part in a template.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RoleEntry {
    /// A rolled member.
    Member,
    /// A plate.
    Plate,
}

/// A member or plate.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartEntry {
    /// Identifier.
    pub name: String,
    /// Words for messages.
    pub label: String,
    /// What it is.
    pub role: RoleEntry,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// Whose steel: the first of these that the spec gives (`plate` or a member role).
    pub steel: Vec<String>,
    /// Thickness that decides its yield strength.
    pub thickness: Expr,
    /// Element size for `size: auto`.
    pub size: Expr,
    /// The solids it is made of, united.
    pub solids: Vec<SolidEntry>,
}

/// One solid of a part: a profile or a box.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolidEntry {
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// A rolled section; or
    pub profile: Option<ProfileEntry>,
    /// a box.
    #[serde(default, rename = "box")]
    pub cuboid: Option<BoxEntry>,
    /// How its plane at mid-thickness differs from the box's own extent.
    pub mid: Option<MidEntry>,
}

/// A length of rolled section.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProfileEntry {
    /// Member role.
    pub member: String,
    /// Axis of the member.
    pub along: Axis,
    /// Direction of the section's depth.
    pub depth: Axis,
    /// One end along the axis.
    pub from: Expr,
    /// The other end.
    pub to: Expr,
    /// Position of the member's axis, x, y, z; the component along the axis is ignored.
    pub centre: Option<[Expr; 3]>,
}

/// A box; the order of the two ends does not matter.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxEntry {
    /// Extent along x.
    pub x: [Expr; 2],
    /// Extent along y.
    pub y: [Expr; 2],
    /// Extent along z.
    pub z: [Expr; 2],
}

/// The plane at mid-thickness of a box: normal axis, and extents that differ from the box's.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MidEntry {
    /// Direction of the thickness.
    pub axis: Axis,
    /// Extent along x.
    pub x: Option<[Expr; 2]>,
    /// Extent along y.
    pub y: Option<[Expr; 2]>,
    /// Extent along z.
    pub z: Option<[Expr; 2]>,
}

/// A bolt with hexagon head and nut, from the bearing face of the head through parts to that of the
/// nut.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoltEntry {
    /// Identifier.
    pub name: String,
    /// Words for messages.
    pub label: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// Axis of the shank.
    pub axis: Axis,
    /// +1 or −1: direction from head to nut along the axis.
    pub toward: Expr,
    /// Centre of the head's bearing face.
    pub head: [Expr; 3],
    /// Axis on which corners of the hexagons lie.
    pub corner: Axis,
    /// The parts it passes, from the head on.
    pub through: Vec<GripEntry>,
    /// True: the head is in contact with the first part; false: glued to it.
    pub head_contact: Expr,
    /// The same for the nut and the last part.
    pub nut_contact: Expr,
    /// Initial gap between shank and hole all round.
    pub shank_gap: Expr,
    /// Element size for `size: auto`.
    pub size: Expr,
}

/// One part a bolt passes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GripEntry {
    /// Its name.
    pub part: String,
    /// Its thickness along the shank.
    pub thickness: Expr,
}

/// A rectangle on a coordinate plane.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RectangleEntry {
    /// Normal axis.
    pub axis: Axis,
    /// Coordinate.
    pub at: Expr,
    /// Extent along x.
    pub x: Option<[Expr; 2]>,
    /// Extent along y.
    pub y: Option<[Expr; 2]>,
    /// Extent along z.
    pub z: Option<[Expr; 2]>,
}

/// An open interface.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ContactEntry {
    /// Name of the surface.
    pub name: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// The two parts; the normal points out of the first.
    pub between: [String; 2],
    /// Where.
    pub face: RectangleEntry,
    /// Initial gap.
    pub gap: Option<Expr>,
}

/// Fillet welds along both sides of a plate.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WeldEntry {
    /// Name of the surface.
    pub name: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// The two parts, parts of members or plates; the weld is as strong as the weaker steel lets it
    /// be.
    pub between: [String; 2],
    /// Where.
    pub face: RectangleEntry,
    /// True when edges of the parts do not bound it.
    #[serde(default)]
    pub imprint: bool,
    /// Throat of each weld; 0 mm: full penetration, the parts are tied.
    pub throat: Expr,
    /// Area of the interface over half of the length of its welds: the thickness of a plate with a
    /// weld on either side.
    pub thickness: Expr,
}

/// A face that loads can name.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SectionEntry {
    /// Name, as a load says it.
    pub name: String,
    /// What it is.
    pub about: String,
    /// Its part.
    pub part: String,
    /// +1 or −1: direction of the outward normal along the axis.
    pub outward: i8,
    /// Where.
    pub face: RectangleEntry,
    /// True when edges of the part do not bound it.
    #[serde(default)]
    pub imprint: bool,
}

/// A member end that N, V, M and T can act on. The member's own axes: x′ along `outward`, out of
/// the joint; z′ along `depth`; y′ = z′ × x′. The end section stays plane.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EndEntry {
    /// Name, as a load says it.
    pub name: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// What it is.
    pub about: String,
    /// Its part.
    pub part: String,
    /// +1 or −1: direction of the outward normal along the face's axis.
    pub outward: Expr,
    /// Direction of the section's depth, upwards.
    pub depth: Axis,
    /// Where the end section is.
    pub face: RectangleEntry,
    /// Points that `at` can name: `node`, `column_face`, `bolt_plane`.
    pub points: BTreeMap<ActionPoint, [Expr; 3]>,
}

impl EndEntry {
    /// The names it may give, whatever its `when` says.
    pub fn names(&self) -> Vec<String> {
        self.each.iter().fold(vec![self.name.clone()], |names, l| {
            let fill = |label: &String| {
                names.iter().map(|n| n.replace(&format!("{{#{}}}", l.each), label)).collect()
            };
            l.labels.iter().flat_map(|label| -> Vec<String> { fill(label) }).collect()
        })
    }

    /// What `at` can say.
    pub fn point_words(&self) -> Vec<&'static str> {
        self.points.keys().map(|p| p.word()).collect()
    }
}

/// A support.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SupportEntry {
    /// Name of the face.
    pub name: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// Its part.
    pub part: String,
    /// Where.
    pub face: RectangleEntry,
    /// Components held.
    pub fix: Vec<Axis>,
    /// True when edges of the part do not bound it.
    #[serde(default)]
    pub imprint: bool,
}

/// Two parts that must stay apart.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClearanceEntry {
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// The two parts.
    pub between: [String; 2],
    /// Smallest distance.
    pub min: Expr,
    /// What needs the room.
    pub reason: String,
}

/// True for what names a file of the user's rather than a shipped template.
pub fn is_path(name: &str) -> bool {
    name.contains(['/', '\\']) || name.ends_with(".yaml") || name.ends_with(".yml")
}

/// Reads a shipped template, or a file of the user's: `name` is a path if it ends in `.yaml` or
/// `.yml` or holds a separator, and is taken relative to `base` (the folder of the spec).
pub fn load(name: &str, base: &Path) -> Result<(Template, Origin), Diagnostics> {
    if is_path(name) {
        let file = if base == Path::new(".") { PathBuf::from(name) } else { base.join(name) };
        let text = text_file::read(&file, |e| {
            Diagnostic::input(
                "template/unreadable",
                format!("template `{}` cannot be read: {e}", file.display()),
            )
            .path("template")
            .help("the path is relative to the spec; `bracket templates` lists the shipped ones")
        })?;
        let Parsed { value, index } = yaml::parse::<Template>(&text, &file)?;
        return Ok((value, Origin::File { file, index }));
    }
    let Some((shipped, text)) = SHIPPED.iter().find(|(n, _)| *n == name) else {
        let hint = did_you_mean(name, SHIPPED.iter().map(|(n, _)| *n));
        let d =
            Diagnostic::input("template/unknown", format!("there is no template `{name}`{hint}"));
        return Err(d
            .path("template")
            .help(
                "`bracket templates` lists the shipped ones; a path to your own .yaml file works \
                 too",
            )
            .into());
    };
    let file = PathBuf::from(format!("templates/{shipped}.yaml"));
    Ok((yaml::parse::<Template>(text, &file)?.value, Origin::Shipped))
}
