//! `bracket batch` as the compiled program: its promises, and what it refuses.

mod choices;
mod processes;
mod sweeps;
mod wrong_sweeps;

/// A flush splice of IPE 330 with its rows below the flanges.
pub const SPLICE: &str = "template: beam_splice\nmembers: {beam: {profile: IPE330, steel: \
                          S235}}\nplate: {thickness: 15}\nbolts: {size: M20, grade: \"8.8\", rows: \
                          [-105, 105]}\nfriction: {mu: 0}\nloads: [{name: ULS1, end: beam_right, \
                          at: bolt_plane, My: -43.2 kN m, Vz: -28.8 kN}]\n";
