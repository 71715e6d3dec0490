//! `bracket doctor` with and without a mesher.

use std::process::{Command, Output};

fn doctor(mesher: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bracket"))
        .args(["doctor", "--format", "json"])
        .env("BRACKET_GMSH", mesher)
        .output()
        .expect("bracket starts")
}

/// A fake mesher that only prints a version.
#[cfg(unix)]
#[test]
fn a_mesher_that_answers_is_found() {
    use std::os::unix::fs::PermissionsExt;
    let dir = tempfile::tempdir().expect("temporary folder");
    let mesher = dir.path().join("gmsh");
    std::fs::write(&mesher, "#!/bin/sh\necho 4.15.2\n").expect("write");
    std::fs::set_permissions(&mesher, std::fs::Permissions::from_mode(0o755))
        .expect("make executable");
    let out = doctor(mesher.to_str().expect("UTF-8 path"));
    let json: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
    let finding = &json["findings"][0];
    assert_eq!(
        (&finding["item"], &finding["status"]),
        (&"mesher".into(), &"ok".into()),
        "{json:#}"
    );
    assert!(finding["found"].as_str().is_some_and(|f| f.contains("4.15.2")));
    assert_eq!(out.status.code(), Some(if json["ok"] == true { 0 } else { 4 }));
}

#[test]
fn a_missing_mesher_is_exit_code_4_with_a_cure() {
    let out = doctor("no-such-program-anywhere");
    assert_eq!(out.status.code(), Some(4));
    let json: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
    assert_eq!(json["ok"], false);
    let finding = &json["findings"][0];
    assert_eq!(finding["status"], "missing");
    assert!(
        finding["found"].as_str().is_some_and(|f| f.contains("no-such-program-anywhere")),
        "{json:#}"
    );
    assert!(finding["cure"].as_str().is_some_and(|c| c.contains("BRACKET_GMSH")));
}
