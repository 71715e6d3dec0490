//! Forces and model of the frame as a container of IDEA StatiCa (IOM).

use super::frame::{BASE, CASES, JOINTS, SECTIONS, Section};
use crate::bench::{Bench, Want, expect, none_wrong, refusal};
use std::fmt::Write as _;

/// Members with their nodes and sections.
const MEMBERS: [(&str, [usize; 2], usize); 6] = [
    ("B1", [1, 2], 1),
    ("B2", [2, 3], 1),
    ("C1", [4, 1], 2),
    ("C2", [1, 5], 2),
    ("C3", [6, 2], 2),
    ("C4", [2, 7], 2),
];

/// Coordinates of the nodes \[m\].
const NODES: [[f64; 3]; 7] = [
    [0.0, 0.0, 0.0],
    [6.0, 0.0, 0.0],
    [12.0, 0.0, 0.0],
    [0.0, 0.0, -4.0],
    [0.0, 0.0, 3.0],
    [6.0, 0.0, -4.0],
    [6.0, 0.0, 3.0],
];

/// The import of a container: the program is known by the file.
pub const ARGS: [&str; 8] =
    ["import", "frame.xml", "--joints", "joints.csv", "--base", "base.yaml", "-o", "out"];

fn list(name: &str, parts: impl Iterator<Item = String>) -> String {
    let part = |(i, p): (usize, String)| format!("<{name}>\n<Id>{}</Id>{p}</{name}>\n", i + 1);
    format!("<{name}>\n{}</{name}>\n", parts.enumerate().map(part).collect::<String>())
}

fn reference(name: &str, list: &str, id: usize) -> String {
    format!("<{name}><TypeName>{list}</TypeName><Id>{id}</Id></{name}>")
}

/// The model, with these profiles of beams and columns.
fn model(beam: &str, column: &str) -> String {
    let point = |p: [f64; 3]| format!("<X>{}</X><Y>{}</Y><Z>{}</Z>", p[0], p[1], p[2]);
    let line = |[a, b]: [usize; 2]| {
        reference("StartPoint", "Point3D", a) + &reference("EndPoint", "Point3D", b)
    };
    let element = |i: usize| reference("Segment", "LineSegment3D", i + 1);
    let member = |(i, (name, _, section)): (usize, &(&str, [usize; 2], usize))| {
        let element = reference("ReferenceElement", "Element1D", i + 1);
        format!("<Name>{name}</Name><Elements1D>{element}</Elements1D>")
            + &reference("CrossSection", "CrossSection", *section)
    };
    let section = |name: &str| {
        format!("<Name>{name}</Name><CrossSectionType>RolledI</CrossSectionType>")
            + &reference("Material", "MatSteel", 1)
    };
    let combination = |(name, _): &(&str, f64)| {
        let state = if name.starts_with('S') { "SLS_Char" } else { "ULS" };
        format!(
            "<Name>{name}</Name><TypeCombiEC>{state}</TypeCombiEC>\
             <TypeCalculationCombi>Linear</TypeCalculationCombi>"
        )
    };
    [
        list("Point3D", NODES.into_iter().map(point)),
        list("LineSegment3D", MEMBERS.iter().map(|m| line(m.1))),
        list("Element1D", (0..MEMBERS.len()).map(element)),
        list("Member1D", MEMBERS.iter().enumerate().map(member)),
        list("CrossSection", [beam, column].into_iter().map(section)),
        list("MatSteel", ["<Name>S 235</Name>".to_owned()].into_iter()),
        list("CombiInput", CASES.iter().map(combination)),
    ]
    .concat()
}

/// The results of a member in all load cases.
fn result(id: usize, sections: &[&Section]) -> String {
    let mut all = String::new();
    for Section { x, actions: [n, v, m], .. } in sections {
        let turned = if *x > 0.0 { 1e3 } else { -1e3 };
        let mut of = String::new();
        for (i, (_, f)) in CASES.iter().enumerate() {
            let [n, v, m] = [1e3 * n * f, turned * v * f, -1e3 * m * f];
            let _ = writeln!(
                of,
                "<SectionResultBase xsi:type=\"ResultOfInternalForces\"><Loading><LoadingType>\
                 Combination</LoadingType><Id>{}</Id></Loading><N>{n}</N><Qy>0</Qy><Qz>{v}</Qz>\
                 <Mx>0</Mx><My>{m}</My><Mz>0</Mz></SectionResultBase>",
                i + 1
            );
        }
        let _ = writeln!(
            all,
            "<ResultBase xsi:type=\"ResultOnSection\"><AbsoluteRelative>Absolute\
             </AbsoluteRelative><Position>{x}</Position><Results>\n{of}</Results></ResultBase>"
        );
    }
    format!(
        "<ResultOnMember><Member><MemberType>Member1D</MemberType><Id>{id}</Id></Member>\
         <ResultType>InternalForces</ResultType><LocalSystemType>Principle</LocalSystemType>\
         <Results>\n{all}</Results></ResultOnMember>\n"
    )
}

/// The container.
pub fn container(beam: &str, column: &str) -> String {
    let result = |(i, (name, ..)): (usize, &(&str, [usize; 2], usize))| {
        let own: Vec<&Section> = SECTIONS.iter().filter(|s| s.member == *name).collect();
        result(i + 1, &own)
    };
    let results: String = MEMBERS.iter().enumerate().map(result).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-16\"?>\n<OpenModelContainer \
         xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\">\n<OpenModel>\n{}</OpenModel>\n\
         <OpenModelResult><ResultOnMembers><ResultOnMembers><Members>\n{results}</Members>\
         </ResultOnMembers></ResultOnMembers></OpenModelResult>\n</OpenModelContainer>\n",
        model(beam, column)
    )
}

/// A text as .NET writes it.
pub fn utf16(text: &str) -> Vec<u8> {
    [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect()
}

fn bench(text: &str) -> Bench {
    Bench::new().file("frame.xml", text).file("joints.csv", JOINTS).file("base.yaml", BASE)
}

/// A spec may name the container too.
#[test]
fn a_spec_with_a_container() {
    let loads = "loads: {table: frame.xml, mapping: iom, member: B1, station: start, end: \
                 beam_right, at: node}\n";
    let text = container("IPE270", "HEB180");
    let bench = bench(&text).file("joint.yaml", format!("{BASE}{loads}"));
    let (out, _) = expect(&bench, &["check", "joint.yaml", "--format", "json"], 0);
    assert!(out.contains("\"ULS2\""), "{out}");
    let mut results = Vec::new();
    for (new, code, message, cure) in [
        ("", "loads/table", "this is an XML file", "`mapping: iom`"),
        ("mapping: rfem, ", "loads/table", "this is an XML file", "`mapping: iom`"),
        ("mapping: iom, sheet: A, ", "loads/iom", "has no sheets", "leave it out"),
        ("mapping: iom, columns: {N: Fx}, ", "loads/iom", "has no headers", "leave it out"),
    ] {
        let loads = loads.replace("mapping: iom, ", new);
        let bench = self::bench(&text).file("joint.yaml", format!("{BASE}{loads}"));
        let want = Want { exit: 2, code, place: "frame.xml", message, cure };
        let run = refusal(&bench, &mut bench.command(&["check", "joint.yaml"]), &want);
        results.push((new.to_owned(), run));
    }
    none_wrong(results);
}

#[test]
fn wrong_containers_are_refused_in_words() {
    let text = container("IPE270", "HEB180");
    let mut results = Vec::new();
    for (old, new, code, place, message, cure) in [
        ("<OpenModel>", "<!DOCTYPE a>", "xml/document", "frame.xml", "XML", "again"),
        ("<OpenModelResult>", "<Results>", "xml/document", "frame.xml", "no complete XML", "again"),
        ("Combination<", "ResultClass<", "loads/iom", "frame.xml", "is an envelope", "single"),
        ("<Name>ULS2<", "<Name>ULS1<", "loads/iom", "frame.xml", "two loadings", "of its own"),
        (">Linear<", ">Code610<", "loads/iom", "frame.xml", "`ULS1` (`Code610`)", "linear"),
        (">Principle<", ">Global<", "loads/iom", "frame.xml", "`B1` are in global axes", "`Local`"),
        ("RolledI<", "RolledU<", "loads/iom", "frame.xml", "is no I or H section", "`Local`"),
        (
            "<Position>0<",
            "<Position>1<",
            "loads/table",
            "frame.xml",
            "no section at the start of the member: the nearest is 1 m",
            "both ends",
        ),
        ("IPE270", "IPE275", "import/model", "frame.xml", "`IPE270`", "members.beam.profile"),
        ("Position>6<", "Position>6.5<", "loads/iom", "frame.xml", "is at 6.5 m", "together"),
        ("<Name>B1<", "<Name>B9<", "import/model", "joints.csv:2", "no member `B1`", "whole model"),
        ("<Qz>60000<", "<Qz>60 kN<", "loads/iom", "frame.xml", "`60 kN`, which is no", "no unit"),
    ] {
        assert!(text.contains(old), "{old}");
        let bench = bench(&text.replacen(old, new, 1));
        let want = Want { exit: 2, code, place, message, cure };
        results
            .push((format!("{old} -> {new}"), refusal(&bench, &mut bench.command(&ARGS), &want)));
    }
    none_wrong(results);
}
