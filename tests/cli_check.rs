//! `bracket check`, `bracket watch` and the verdict by code of `bracket run`, as the compiled
//! program.

#[path = "cli/bench.rs"]
mod bench;
#[path = "cli/check.rs"]
mod check;

use bench::Bench;

/// Runs with an expected exit code; returns standard output and standard error.
pub fn expect(bench: &Bench, args: &[&str], code: i32) -> (String, String) {
    let run = bench.run(args);
    let [out, err] = [run.stdout, run.stderr].map(|b| String::from_utf8(b).expect("UTF-8"));
    assert_eq!(run.status.code(), Some(code), "{args:?}\n{out}\n{err}");
    (out, err)
}
