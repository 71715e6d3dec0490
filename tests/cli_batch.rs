//! `bracket batch` as the compiled program: its promises, and what it refuses.

#[path = "cli/bench.rs"]
mod bench;
#[path = "cli/choices.rs"]
mod choices;
#[path = "cli/processes.rs"]
mod processes;
#[path = "cli/sweeps.rs"]
mod sweeps;
#[path = "cli/wrong_sweeps.rs"]
mod wrong_sweeps;

use bench::Bench;

/// Runs with an expected exit code; returns standard output and standard error.
pub fn expect(bench: &Bench, args: &[&str], code: i32) -> (String, String) {
    let run = bench.run(args);
    let [out, err] = [run.stdout, run.stderr].map(|b| String::from_utf8(b).expect("UTF-8"));
    assert_eq!(run.status.code(), Some(code), "{args:?}\n{out}\n{err}");
    (out, err)
}

/// A flush splice of IPE 330 with its rows below the flanges.
pub const SPLICE: &str = "template: beam_splice\nmembers: {beam: {profile: IPE330, steel: \
                          S235}}\nplate: {thickness: 15}\nbolts: {size: M20, grade: \"8.8\", rows: \
                          [-105, 105]}\nfriction: {mu: 0}\nloads: [{name: ULS1, end: beam_right, \
                          at: bolt_plane, My: -43.2 kN m, Vz: -28.8 kN}]\n";
