//! The subject of a check: places in the order in which a report names them.

use super::part::Part;
use super::place::Place;
use super::sense::Sense;
use bracket_base::display_text;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// What a check is about.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(from = "Record", into = "Record")]
pub struct Subject {
    /// Its places, in order.
    pub places: Vec<Place>,
}

impl Subject {
    /// The subject with a further place, or with those of another subject.
    #[must_use]
    pub fn and(mut self, further: impl Into<Subject>) -> Self {
        self.places.extend(further.into().places);
        self
    }

    /// The member end, by its name.
    pub fn end(name: &str) -> Self {
        Place::End(name.into()).into()
    }

    /// The subject as a report prints it.
    pub fn text(&self) -> Text {
        match self.places.as_slice() {
            [place] => place.text(),
            all => Text::joined(", ", all.iter().map(Place::text)),
        }
    }
}

display_text!(Subject);

impl From<Place> for Subject {
    fn from(place: Place) -> Self {
        Self { places: vec![place] }
    }
}

impl From<Part> for Subject {
    fn from(part: Part) -> Self {
        Place::Part(part).into()
    }
}

impl From<Sense> for Subject {
    fn from(sense: Sense) -> Self {
        Place::Sense(sense).into()
    }
}

/// How a subject is written: the text, and the data unless they are a name of the user.
#[derive(Clone, Serialize, Deserialize)]
struct Record {
    subject: Text,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    place: Vec<Place>,
}

impl From<Subject> for Record {
    fn from(of: Subject) -> Self {
        match of.places.as_slice() {
            [Place::Named(name)] => Self { subject: name.clone(), place: Vec::new() },
            _ => Self { subject: of.text().sentence(), place: of.places },
        }
    }
}

impl From<Record> for Subject {
    /// A text that does not fit its data counts.
    fn from(record: Record) -> Self {
        let data = Self { places: record.place };
        match data.text() == record.subject {
            true => data,
            false => Place::Named(record.subject).into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::subject::Frame;
    use serde_json::json;

    #[test]
    fn a_subject_is_read_back_and_a_false_text_counts() {
        let seam = Place::Seam { of: Part::CompressedStiffeners, to: Part::ColumnFlange };
        for (subject, text) in [
            (
                Subject::end("beam_right").and(seam),
                "beam_right, compressed stiffeners to the \
                                                    column flange",
            ),
            (Subject::from(Part::EndPlate), "end plate"),
            (Place::Named("haunch".into()).into(), "haunch"),
            (
                Subject::from(Sense::Bottom)
                    .and(Place::Beta(0.75))
                    .and(Place::Row { number: 2, z: -90.5 }),
                "tension at the bottom, β = 0.75, row 2 at z = -90.5 mm",
            ),
            (
                Subject::end("beam_right").and(Part::BeamWeb).and(Place::Rows(vec![90.0, 20.0])),
                "beam_right, beam web, rows at z = 90 and 20 mm",
            ),
            (
                Subject::from(Sense::Top).and(Place::Frame(Frame::Unbraced)),
                "tension at the top, other frames",
            ),
        ] {
            assert_eq!(subject.text(), text);
            let written = serde_json::to_value(&subject).expect("data");
            assert_eq!(written["subject"], text);
            let read: Subject = serde_json::from_value(written).expect("a subject");
            assert_eq!(read, subject);
        }
        let said = json!({"subject": "beam web", "place": [{"part": "end_plate"}]});
        let said: Subject = serde_json::from_value(said).expect("a subject");
        assert_eq!(said, Place::Named("beam web".into()).into());
        assert_ne!(said, Part::BeamWeb.into());
    }
}
