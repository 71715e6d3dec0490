//! The `hand_checks` of a template of any family: its key `kind` says which.

use super::column_base::ColumnBaseEntry;
use super::cover_splice::CoverSpliceEntry;
use super::hand_checks::EndPlateEntry;
use super::simple_joint::SimpleJointEntry;
use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, DeserializeSeed, IntoDeserializer, MapAccess};
use serde::{Deserialize, Deserializer};
use std::fmt;

/// What the hand checks of the code see of a connection. `kind` stands first; without it the
/// connection is a bolted end plate.
#[derive(Clone, Debug, JsonSchema)]
#[serde(untagged)]
pub enum HandCheckEntry {
    /// `kind` absent or `end_plate`.
    EndPlate(Box<EndPlateEntry>),
    /// `kind: fin_plate` or `kind: header_plate`.
    Simple(SimpleJointEntry),
    /// `kind: cover_splice`.
    CoverSplice(CoverSpliceEntry),
    /// `kind: column_base`.
    ColumnBase(Box<ColumnBaseEntry>),
}

impl HandCheckEntry {
    /// The member ends that are joined by the connection.
    pub fn ends(&self) -> &[String] {
        match self {
            HandCheckEntry::EndPlate(e) => &e.ends,
            HandCheckEntry::Simple(e) => &e.ends,
            HandCheckEntry::CoverSplice(e) => &e.ends,
            HandCheckEntry::ColumnBase(e) => &e.ends,
        }
    }

    /// The entry of an end plate; `None` of another family.
    pub fn end_plate(&self) -> Option<&EndPlateEntry> {
        match self {
            HandCheckEntry::EndPlate(e) => Some(e),
            _ => None,
        }
    }
}

/// The values of `kind`.
const KINDS: [&str; 5] = ["end_plate", "fin_plate", "header_plate", "cover_splice", "column_base"];

impl<'de> Deserialize<'de> for HandCheckEntry {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct V;
        impl<'de> de::Visitor<'de> for V {
            type Value = HandCheckEntry;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the quantities of the hand checks")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let key = map.next_key::<String>()?;
                let kind = match key.as_deref() {
                    Some("kind") => Some(map.next_value::<String>()?),
                    _ => None,
                };
                let all = MapAccessDeserializer::new(PutBack { key, value: kind.clone(), map });
                match kind.as_deref() {
                    None | Some("end_plate") => {
                        let entry = EndPlateEntry::deserialize(all)?;
                        Ok(HandCheckEntry::EndPlate(Box::new(entry)))
                    }
                    Some("fin_plate" | "header_plate") => {
                        SimpleJointEntry::deserialize(all).map(HandCheckEntry::Simple)
                    }
                    Some("cover_splice") => {
                        CoverSpliceEntry::deserialize(all).map(HandCheckEntry::CoverSplice)
                    }
                    Some("column_base") => {
                        let entry = ColumnBaseEntry::deserialize(all)?;
                        Ok(HandCheckEntry::ColumnBase(Box::new(entry)))
                    }
                    Some(other) => Err(de::Error::unknown_variant(other, &KINDS)),
                }
            }
        }
        d.deserialize_map(V)
    }
}

/// A mapping whose first key is put back, with its value where that is read too.
struct PutBack<A> {
    key: Option<String>,
    value: Option<String>,
    map: A,
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for PutBack<A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, A::Error> {
        match self.key.take() {
            Some(key) => seed.deserialize(key.into_deserializer()).map(Some),
            None => self.map.next_key_seed(seed),
        }
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, A::Error> {
        match self.value.take() {
            Some(value) => seed.deserialize(value.into_deserializer()),
            None => self.map.next_value_seed(seed),
        }
    }
}
