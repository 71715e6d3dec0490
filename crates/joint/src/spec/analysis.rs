//! The `analysis` section of a spec: kind of analysis, limits, mesh.

use bracket_base::units::{Length, Seconds};
use bracket_engine::model::AnalysisKind;
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, de};
use std::fmt;

/// What to compute and how far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct AnalysisSpec {
    /// Kinds of analysis: one, or a list.
    pub kind: Kinds,
    /// Relative gap at which to stop, 0 < target < 1.
    pub target_gap: f64,
    /// Number of meshes at most.
    pub max_passes: u32,
    /// Macro tets at most.
    pub max_macro_tets: usize,
    /// Wall time at most: `20 min`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_limit: Option<Seconds>,
    /// Limit analysis: estimate the load factor under Coulomb's law as well, by a fixed point that
    /// solves the kinematic program up to ten times more on every mesh; the directions of a polygon
    /// have none.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub coulomb_estimate: bool,
    /// Elastoplastic analysis: whether the bolts yield.
    #[serde(skip_serializing_if = "BoltModel::is_yielding")]
    pub bolts: BoltModel,
    /// Elastoplastic analysis: factors of the demand at which the case is analysed as well, on its
    /// last mesh; rising, 1 to 20 of them, above 0 and up to 10. They give a curve of moment and
    /// rotation.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub load_steps: Vec<f64>,
    /// Run what a verdict by analysis needs, and no more: limit analysis, and elastoplastic
    /// analysis with elastic bolts. By default where `kind` has limit analysis and the code has no
    /// method for a load at a member end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub decide: Option<bool>,
    /// Limit analysis of many load cases: whether each of them is analysed. By default each of up
    /// to 12.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub combinations: Option<Combinations>,
    /// Mesh.
    pub mesh: MeshSpec,
}

/// Which load cases limit analysis is run for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Combinations {
    /// For each of them.
    Each,
    /// For as few as bound all of them: what a joint carries is convex, so that bounds of some load
    /// cases prove bounds of others. It ends when every load case is decided or has an analysis of
    /// its own.
    Covered,
}

impl Default for AnalysisSpec {
    fn default() -> Self {
        Self {
            kind: Kinds(vec![AnalysisKind::Elastic]),
            target_gap: 0.05,
            max_passes: 6,
            max_macro_tets: 200_000,
            time_limit: None,
            coulomb_estimate: false,
            bolts: BoltModel::Yielding,
            load_steps: Vec::new(),
            decide: None,
            combinations: None,
            mesh: MeshSpec::default(),
        }
    }
}

/// How the bolts of an elastoplastic analysis behave.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BoltModel {
    /// They yield as their grade does.
    #[default]
    Yielding,
    /// They stay elastic, with the stiffness of their stress area: no force is redistributed by
    /// bolts that yield. Preload is tightened before the loads act; what a verdict by analysis
    /// needs leaves it out.
    Elastic,
}

impl BoltModel {
    /// True for the default.
    pub fn is_yielding(&self) -> bool {
        *self == BoltModel::Yielding
    }
}

impl AnalysisSpec {
    /// The kinds of analysis to run: those of `kind` and, where analysis decides, those that a
    /// verdict by analysis needs.
    pub fn kinds(&self, decide: bool) -> Vec<AnalysisKind> {
        let mut kinds = self.kind.0.clone();
        if decide {
            let needed = [AnalysisKind::Limit, AnalysisKind::Elastoplastic];
            kinds.extend(needed.into_iter().filter(|k| !self.kind.0.contains(k)));
        }
        kinds
    }

    /// Whether the bolts of this kind of analysis stay elastic although plates yield.
    pub fn elastic_bolts(&self, kind: AnalysisKind, decide: bool) -> bool {
        kind == AnalysisKind::Elastoplastic && (decide || self.bolts == BoltModel::Elastic)
    }
}

/// One kind of analysis or a list of them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(transparent)]
#[schemars(transparent)]
pub struct Kinds(
    /// The kinds, in the order given.
    #[schemars(with = "OneOrMany")]
    pub Vec<AnalysisKind>,
);

/// Schema of [`Kinds`] only.
#[derive(JsonSchema)]
#[serde(untagged)]
#[allow(dead_code)]
enum OneOrMany {
    /// One kind.
    One(AnalysisKind),
    /// Several kinds.
    Many(Vec<AnalysisKind>),
}

impl<'de> Deserialize<'de> for Kinds {
    // written by hand, because an untagged enum loses the place and the list of known words
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct V;
        impl<'de> de::Visitor<'de> for V {
            type Value = Kinds;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("elastic, elastoplastic, limit, or a list of them")
            }
            fn visit_str<E: de::Error>(self, v: &str) -> Result<Kinds, E> {
                AnalysisKind::deserialize(de::value::StrDeserializer::new(v))
                    .map(|k| Kinds(vec![k]))
            }
            fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<Kinds, A::Error> {
                let mut kinds = Vec::new();
                while let Some(k) = seq.next_element()? {
                    kinds.push(k);
                }
                if kinds.is_empty() {
                    Err(de::Error::invalid_length(0, &self))
                } else {
                    Ok(Kinds(kinds))
                }
            }
        }
        d.deserialize_any(V)
    }
}

/// Mesh of a spec.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MeshSpec {
    /// Element size of all parts, or `auto`: per part, as the template says.
    pub size: MeshSize,
    /// A mesh plane at mid-thickness of every plate, flange, web and stiffener.
    pub layers: bool,
    /// Sides of the meshed bolt circles, even, 12–48.
    pub segments: u32,
}

impl Default for MeshSpec {
    fn default() -> Self {
        Self { size: MeshSize::Auto, layers: true, segments: 12 }
    }
}

/// Element size of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeshSize {
    /// Each part has the size that the template gives.
    Auto,
    /// All parts have this size.
    Fixed(Length),
}

impl<'de> Deserialize<'de> for MeshSize {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct V;
        impl de::Visitor<'_> for V {
            type Value = MeshSize;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("`auto` or a length (mm, cm, m, in, or a bare number for mm)")
            }
            fn visit_str<E: de::Error>(self, v: &str) -> Result<MeshSize, E> {
                match v {
                    "auto" => Ok(MeshSize::Auto),
                    _ => {
                        Length::deserialize(de::value::StrDeserializer::new(v)).map(MeshSize::Fixed)
                    }
                }
            }
            fn visit_f64<E: de::Error>(self, v: f64) -> Result<MeshSize, E> {
                Length::deserialize(de::value::F64Deserializer::new(v)).map(MeshSize::Fixed)
            }
            fn visit_i64<E: de::Error>(self, v: i64) -> Result<MeshSize, E> {
                self.visit_f64(v as f64)
            }
            fn visit_u64<E: de::Error>(self, v: u64) -> Result<MeshSize, E> {
                self.visit_f64(v as f64)
            }
        }
        d.deserialize_any(V)
    }
}

impl Serialize for MeshSize {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            MeshSize::Auto => s.serialize_str("auto"),
            MeshSize::Fixed(l) => l.serialize(s),
        }
    }
}

impl JsonSchema for MeshSize {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "MeshSize".into()
    }
    fn json_schema(g: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let length = g.subschema_for::<Length>();
        schemars::json_schema!({
            "description": "Element size: `auto`, or a length for all parts.",
            "anyOf": [{"const": "auto"}, length],
        })
    }
}
