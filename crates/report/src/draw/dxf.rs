//! Bolted plates as DXF drawings (R12, ASCII) for the workshop: outline, holes and a note in the
//! language of the spec, at full size in mm. The origin of an end plate is the axis of the beam,
//! that of another plate its lower left corner; y upward.

use crate::words::Words;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::check::number;
use bracket_joint::assembly::content::{Piece, PieceKind, SAME_PLACE};
use bracket_joint::assembly::{Content, EndPlate};
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
    let half = 0.5 * e.width;
    let row = |&z: &f64| e.columns().into_iter().map(move |y| [y, z]);
    let holes: Vec<[f64; 2]> = e.rows.iter().flat_map(row).collect();
    let size = [e.thickness, e.width, e.top - e.bottom].map(number).join(" x ");
    let notes: [Text; 3] = [
        say!("end plate {} {}, {} off", size, &e.plate_steel.grade, pieces),
        say!("{} holes {} mm for {} bolts", holes.len(), number(e.hole), &e.bolt.size),
        "all dimensions in mm, origin at the axis of the beam".into(),
    ];
    rectangle([[-half, e.bottom], [half, e.top]], &holes, e.hole, notes.map(|n| words.say(&n)))
}

/// A rectangular plate between two corners, with the centres of its holes, their diameter \[mm\]
/// and notes below it.
fn rectangle(
    [[left, bottom], [right, top]]: [[f64; 2]; 2],
    holes: &[[f64; 2]],
    diameter: f64,
    notes: [String; 3],
) -> String {
    let mut d = Dxf::new();
    let corners = [[left, bottom], [right, bottom], [right, top], [left, top]];
    for i in 0..4 {
        d.line("PLATE", corners[i], corners[(i + 1) % 4]);
    }
    holes.iter().for_each(|at| d.hole(*at, diameter));
    for (i, note) in notes.iter().enumerate() {
        let below = bottom - (2.0 + 1.6 * i as f64) * LETTERS;
        d.text("NOTES", [left, below], LETTERS, note);
    }
    d.finish()
}

/// A flat plate with its holes.
#[derive(Clone, Debug)]
struct Flat<'a> {
    piece: &'a Piece,
    /// Thickness, width and height \[mm\].
    sizes: [f64; 3],
    /// Centres of the holes from the lower left corner \[mm\].
    holes: Vec<[f64; 2]>,
    count: usize,
}

impl<'a> Flat<'a> {
    fn new(piece: &'a Piece, content: &Content) -> Self {
        let thinner = |a: usize, b: usize| piece.size(a) < piece.size(b);
        let normal = [1, 2].into_iter().fold(0, |t, k| if thinner(k, t) { k } else { t });
        // z is up on the drawing; of a plate that lies, x is across
        let [u, v] = [[1, 2], [0, 2], [0, 1]][normal];
        let inside = |at: [f64; 3]| {
            [u, v].iter().all(|&k| piece.extent[k][0] < at[k] && at[k] < piece.extent[k][1])
        };
        let bolts = content.fasteners.iter();
        let bolts = bolts.filter(|b| b.axis == normal && b.passes(&piece.part) && inside(b.head));
        let mut holes: Vec<[f64; 2]> =
            bolts.map(|b| [u, v].map(|k| b.head[k] - piece.extent[k][0])).collect();
        sort(&mut holes);
        Self { piece, sizes: [normal, u, v].map(|k| piece.size(k)), holes, count: 1 }
    }

    /// True if both are one plate, perhaps turned over or upside down.
    fn is(&self, other: &Self) -> bool {
        let same = |a: f64, b: f64| (a - b).abs() < SAME_PLACE;
        let sizes = self.sizes.iter().zip(&other.sizes).all(|(a, b)| same(*a, *b));
        let [_, width, height] = self.sizes;
        let turned = [[false, false], [true, false], [false, true], [true, true]];
        sizes
            && self.piece.label == other.piece.label
            && self.piece.steel == other.piece.steel
            && self.holes.len() == other.holes.len()
            && turned.into_iter().any(|[across, down]| {
                let flip = |x: f64, size: f64, on: bool| if on { size - x } else { x };
                let turn = |h: &[f64; 2]| [flip(h[0], width, across), flip(h[1], height, down)];
                let mut holes: Vec<[f64; 2]> = other.holes.iter().map(turn).collect();
                sort(&mut holes);
                let mut pairs = self.holes.iter().zip(&holes);
                pairs.all(|(a, b)| same(a[0], b[0]) && same(a[1], b[1]))
            })
    }
}

/// Orders holes by height, then across; heights that differ by rounding alone are equal.
fn sort(holes: &mut [[f64; 2]]) {
    let place = |h: &[f64; 2]| h.map(|x| (x / SAME_PLACE).round() as i64);
    holes.sort_by_key(|h| {
        let [x, y] = place(h);
        [y, x]
    });
}

/// The bolted plates of the hand checks, equal ones once, as names of files with their drawings.
/// `hole` is the diameter of the holes \[mm\].
pub fn bolted_plates(content: &Content, hole: f64, words: &Words) -> Vec<(String, String)> {
    let mut plates: Vec<Flat<'_>> = Vec::new();
    for piece in content.pieces.iter().filter(|p| p.kind == PieceKind::Checked) {
        let flat = Flat::new(piece, content);
        match plates.iter_mut().find(|p| p.is(&flat)) {
            Some(same) => same.count += 1,
            None => plates.push(flat),
        }
    }
    let mut out: Vec<(String, String)> = Vec::new();
    for plate in plates {
        // the English label, so that the name of a file is the same in every language
        let stem = plate.piece.label.to_string().replace(' ', "_");
        let taken = |name: &str| out.iter().any(|(file, _)| file == name);
        let names = (2..).map(|n| format!("{stem}_{n}.dxf"));
        let mut names = [format!("{stem}.dxf")].into_iter().chain(names);
        let Some(file) = names.find(|n| !taken(n)) else { continue };
        out.push((file, plate.drawing(content, hole, words)));
    }
    out
}

impl Flat<'_> {
    fn drawing(&self, content: &Content, hole: f64, words: &Words) -> String {
        let [_, width, height] = self.sizes;
        let size = self.sizes.map(number).join(" x ");
        let bolt = content.bolt.as_ref().map_or(String::new(), |(size, _)| size.size.clone());
        let notes: [Text; 3] = [
            say!("{} {} {}, {} off", &self.piece.label, size, &self.piece.steel, self.count),
            say!("{} holes {} mm for {} bolts", self.holes.len(), number(hole), bolt),
            "all dimensions in mm, origin at the lower left corner".into(),
        ];
        let notes = notes.map(|n| words.say(&n));
        rectangle([[0.0, 0.0], [width, height]], &self.holes, hole, notes)
    }
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

    /// A hole with its centre lines.
    fn hole(&mut self, [x, y]: [f64; 2], diameter: f64) {
        let radius = 0.5 * diameter;
        let reach = (1.0 + MARK) * radius;
        self.circle("HOLES", [x, y], radius);
        self.line("CENTRES", [x - reach, y], [x + reach, y]);
        self.line("CENTRES", [x, y - reach], [x, y + reach]);
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
