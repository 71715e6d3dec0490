//! The example of the guide: its files give what it prints.

use crate::bench::{Bench, expect};

/// The blocks of the section, without their fences.
fn blocks() -> Vec<String> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/guide.md");
    let guide = std::fs::read_to_string(path).expect("the guide");
    let (_, section) = guide.split_once("### From a frame program").expect("the section");
    let section = section.split("\n## ").next().expect("its text");
    let inside = section.split("```").skip(1).step_by(2);
    inside.map(|b| b.split_once('\n').expect("a fence").1.to_owned()).collect()
}

#[test]
fn the_example_of_the_guide() {
    let blocks = blocks();
    let [forces, joints, base, command, printed] = &blocks[..] else {
        panic!("{} blocks", blocks.len());
    };
    let bench =
        Bench::new().file("forces.csv", forces).file("joints.csv", joints).file("base.yaml", base);
    let words: Vec<&str> = command.split_whitespace().skip(1).collect();
    let (out, _) = expect(&bench, &words, 0);
    assert_eq!(&out, printed);
    let (_, err) = expect(&bench, &["batch", "frame/sweep.yaml"], 0);
    assert!(err.contains("2 cases: 2 ok"), "{err}");
    // the spec in the folder is one that the program accepts by itself
    expect(&bench, &["check", "frame/base.yaml", "--out", "r"], 0);
}
