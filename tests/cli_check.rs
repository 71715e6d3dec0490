//! `bracket check`, `bracket watch`, the verdict by code of `bracket run` and the printed report,
//! as the compiled program.

#[path = "cli/bench.rs"]
mod bench;
#[path = "cli/check.rs"]
mod check;
#[cfg(feature = "pdf")]
#[path = "cli/hostile_texts.rs"]
mod hostile_texts;
#[path = "cli/plate_dxf.rs"]
mod plate_dxf;
#[cfg(feature = "pdf")]
#[path = "cli/printed_report.rs"]
mod printed_report;

use bench::Bench;

/// Runs with an expected exit code; returns standard output and standard error.
pub fn expect(bench: &Bench, args: &[&str], code: i32) -> (String, String) {
    let run = bench.run(args);
    let [out, err] = [run.stdout, run.stderr].map(|b| String::from_utf8(b).expect("UTF-8"));
    assert_eq!(run.status.code(), Some(code), "{args:?}\n{out}\n{err}");
    (out, err)
}
