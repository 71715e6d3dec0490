//! The end plate as a DXF drawing (R12, ASCII) for the workshop: outline, holes and a note in the
//! language of the spec, at full size in mm. The origin is the axis of the beam, y upward.

use crate::words::Words;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::check::number;
use bracket_joint::assembly::EndPlate;
use std::fmt::Write;

/// Name of the file in a result folder.
pub const DXF_FILE: &str = "end_plate.dxf";

/// Height of the letters of the note \[mm\].
const LETTERS: f64 = 8.0;
/// Part of the hole by which its centre marks are longer than its radius.
const MARK: f64 = 0.3;
/// Layers with their colour numbers.
const LAYERS: [(&str, u8); 4] = [("PLATE", 7), ("HOLES", 1), ("CENTRES", 8), ("NOTES", 3)];

/// The drawing with its note in `words`. `pieces` is the number of plates of the joint.
pub fn end_plate(e: &EndPlate, pieces: usize, words: &Words) -> String {
    let mut d = Dxf::new();
    let half = 0.5 * e.width;
    let corners = [[-half, e.bottom], [half, e.bottom], [half, e.top], [-half, e.top]];
    for i in 0..4 {
        d.line("PLATE", corners[i], corners[(i + 1) % 4]);
    }
    let radius = 0.5 * e.hole;
    let reach = (1.0 + MARK) * radius;
    for &z in &e.rows {
        for y in e.columns() {
            d.circle("HOLES", [y, z], radius);
            d.line("CENTRES", [y - reach, z], [y + reach, z]);
            d.line("CENTRES", [y, z - reach], [y, z + reach]);
        }
    }
    let holes = e.rows.len() * e.columns().len();
    let size = [e.thickness, e.width, e.top - e.bottom].map(number).join(" x ");
    let notes: [Text; 3] = [
        say!("end plate {} {}, {} off", size, &e.plate_steel.grade, pieces),
        say!("{} holes {} mm for {} bolts", holes, number(e.hole), &e.bolt.size),
        "all dimensions in mm, origin at the axis of the beam".into(),
    ];
    for (i, note) in notes.iter().enumerate() {
        let below = e.bottom - (2.0 + 1.6 * i as f64) * LETTERS;
        d.text("NOTES", [-half, below], LETTERS, &words.say(note));
    }
    d.finish()
}

/// A drawing in the making: group codes and values, a line each.
struct Dxf(String);

impl Dxf {
    fn new() -> Self {
        let mut d = Self(String::new());
        d.groups(&[(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"), (0, "ENDSEC")]);
        let count = LAYERS.len().to_string();
        d.groups(&[(0, "SECTION"), (2, "TABLES"), (0, "TABLE"), (2, "LAYER"), (70, &count)]);
        for (name, colour) in LAYERS {
            let colour = colour.to_string();
            d.groups(&[(0, "LAYER"), (2, name), (70, "0"), (62, &colour), (6, "CONTINUOUS")]);
        }
        d.groups(&[(0, "ENDTAB"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]);
        d
    }

    fn groups(&mut self, groups: &[(u16, &str)]) {
        for (code, value) in groups {
            // writing to a string never fails
            let _ = write!(self.0, "{code:>3}\r\n{value}\r\n");
        }
    }

    fn point(&mut self, first: u16, [x, y]: [f64; 2]) {
        for (code, value) in [(first, x), (first + 10, y), (first + 20, 0.0)] {
            // ten digits after the point: below any tolerance of a workshop
            self.groups(&[(code, &format!("{value:.10}"))]);
        }
    }

    fn line(&mut self, layer: &str, from: [f64; 2], to: [f64; 2]) {
        self.groups(&[(0, "LINE"), (8, layer)]);
        self.point(10, from);
        self.point(11, to);
    }

    fn circle(&mut self, layer: &str, centre: [f64; 2], radius: f64) {
        self.groups(&[(0, "CIRCLE"), (8, layer)]);
        self.point(10, centre);
        self.groups(&[(40, &format!("{radius:.10}"))]);
    }

    fn text(&mut self, layer: &str, at: [f64; 2], height: f64, words: &str) {
        self.groups(&[(0, "TEXT"), (8, layer)]);
        self.point(10, at);
        // R12 is ASCII, and a line break would end the value
        self.groups(&[(40, &format!("{height:.1}")), (1, &ascii(words))]);
    }

    fn finish(mut self) -> String {
        self.groups(&[(0, "ENDSEC"), (0, "EOF")]);
        self.0
    }
}

/// A text in ASCII. German letters are spelled out, other ones become `_`.
fn ascii(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            'ä' => out.push_str("ae"),
            'ö' => out.push_str("oe"),
            'ü' => out.push_str("ue"),
            'Ä' => out.push_str("Ae"),
            'Ö' => out.push_str("Oe"),
            'Ü' => out.push_str("Ue"),
            'ß' => out.push_str("ss"),
            c if c == ' ' || c.is_ascii_graphic() => out.push(c),
            _ => out.push('_'),
        }
    }
    out
}
