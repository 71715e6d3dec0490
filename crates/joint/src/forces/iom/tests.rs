//! Containers as programs write them: beams B1 and B2 of 2 m and a column C of two elements of 3 m.

use super::*;
use crate::forces::force_row::ForceRow;
use crate::forces::program::{Program, Quantity};
use bracket_base::diag::Diagnostic;

fn list(name: &str, parts: &[String]) -> String {
    let part = |(i, p): (usize, &String)| format!("<{name}>\n<Id>{}</Id>{p}</{name}>\n", i + 1);
    format!("<{name}>{}</{name}>\n", parts.iter().enumerate().map(part).collect::<String>())
}

fn reference(name: &str, list: &str, id: usize) -> String {
    format!("<{name}><TypeName>{list}</TypeName><Id>{id}</Id></{name}>")
}

fn model() -> String {
    let point = |[x, y, z]: [f64; 3]| format!("<X>{x}</X><Y>{y}</Y><Z>{z}</Z>");
    let line = |a: usize, b: usize| {
        reference("StartPoint", "Point3D", a) + &reference("EndPoint", "Point3D", b)
    };
    let element =
        |i: usize| format!("<Name>E{i}</Name>") + &reference("Segment", "LineSegment3D", i);
    let member = |name: &str, elements: &[usize], section: usize| {
        let all: String =
            elements.iter().map(|e| reference("ReferenceElement", "Element1D", *e)).collect();
        format!("<Name>{name}</Name><Elements1D>{all}</Elements1D>")
            + &reference("CrossSection", "CrossSection", section)
    };
    let section = |name: &str, kind: &str| {
        let unique = "<Parameters><Parameter><Name>UniqueName</Name><Value>IPE270</Value>\
                      </Parameter></Parameters>";
        format!("<Name>{name}</Name><CrossSectionType>{kind}</CrossSectionType>{unique}")
            + &reference("Material", "MatSteel", 1)
    };
    let combination = |name: &str, kind: &str, state: &str| {
        format!(
            "<Name>{name}</Name><TypeCombiEC>{state}</TypeCombiEC>\
             <TypeCalculationCombi>{kind}</TypeCalculationCombi>"
        )
    };
    [
        list(
            "Point3D",
            &[[0, 0, 0], [2, 0, 0], [0, 0, -3], [0, 0, 3]].map(|p| point(p.map(f64::from))),
        ),
        list("LineSegment3D", &[line(1, 2), line(2, 1), line(3, 1), line(1, 4)]),
        list("Element1D", &[element(1), element(2), element(3), element(4)]),
        list("Member1D", &[member("B1", &[1], 1), member("B2", &[2], 1), member("C", &[3, 4], 1)]),
        list("CrossSection", &[section("beam", "RolledI"), section("angle", "RolledAngle")]),
        list("MatSteel", &["<Name>S 235</Name>".into()]),
        list("LoadCase", &["<Name>LC1</Name>".into()]),
        list(
            "CombiInput",
            &[combination("CO1", "Linear", "ULS"), combination("S1", "Linear", "SLS_Char")],
        ),
    ]
    .concat()
}

/// The result of a section: position, kind and number of the loading, forces in N and N m.
fn section(position: f64, loading: (&str, usize), forces: [f64; 6]) -> String {
    let names = ["N", "Qy", "Qz", "Mx", "My", "Mz"];
    let forces: String = names.iter().zip(forces).map(|(n, x)| format!("<{n}>{x}</{n}>")).collect();
    let (kind, id) = loading;
    format!(
        "<ResultBase i:type=\"ResultOnSection\"><AbsoluteRelative>Relative</AbsoluteRelative>\
         <Position>{position}</Position><Results><SectionResultBase \
         i:type=\"ResultOfInternalForces\"><Loading><LoadingType>{kind}</LoadingType><Id>{id}</Id>\
         <Items><ResultOfLoadingItem><Coefficient>1</Coefficient></ResultOfLoadingItem></Items>\
         </Loading>{forces}</SectionResultBase></Results></ResultBase>\n"
    )
}

fn result(kind: &str, id: usize, system: &str, sections: &[String]) -> String {
    format!(
        "<ResultOnMember><Member><MemberType>{kind}</MemberType><Id>{id}</Id></Member>\
         <ResultType>InternalForces</ResultType><LocalSystemType>{system}</LocalSystemType>\
         <Results>{}</Results></ResultOnMember>\n",
        sections.concat()
    )
}

fn container(results: &[String]) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-16\"?>\n<OpenModelContainer xmlns:i=\"x\">\
         <OpenModel>\n{}</OpenModel>\n<OpenModelResult><ResultOnMembers><ResultOnMembers><Members>\
         {}</Members></ResultOnMembers></ResultOnMembers></OpenModelResult></OpenModelContainer>",
        model(),
        results.concat()
    )
}

const LC1: (&str, usize) = ("LoadCase", 1);

/// The cantilever with 10 kN down at its tip, drawn from the support and from the tip.
fn cantilever() -> [String; 2] {
    let forces = |qz: f64, my: f64| [0.0, 0.0, qz, 0.0, my, 0.0];
    let from = [section(0.0, LC1, forces(10e3, -20e3)), section(1.0, LC1, forces(10e3, 0.0))];
    let to = [section(0.0, LC1, forces(-10e3, 0.0)), section(1.0, LC1, forces(-10e3, -20e3))];
    [result("Member1D", 1, "Principle", &from), result("Member1D", 2, "Local", &to)]
}

fn read(bytes: &[u8]) -> Result<Forces, Diagnostics> {
    let dir = tempfile::tempdir().expect("a folder");
    let path = dir.path().join("frame.xml");
    std::fs::write(&path, bytes).expect("written");
    forces(&path)
}

fn rows(results: &[String]) -> Vec<ForceRow> {
    let found = read(container(results).as_bytes()).unwrap_or_else(|e| panic!("{e:?}"));
    assert!(found.refused.is_empty(), "{:?}", found.refused);
    found.rows
}

fn at(rows: &[ForceRow], member: &str, station: f64) -> [f64; 6] {
    let is = |r: &&ForceRow| r.text(Quantity::Member) == Some(member) && r.station == Some(station);
    let found: Vec<&ForceRow> = rows.iter().filter(is).collect();
    assert_eq!(found.len(), 1, "{member} at {station}: {rows:?}");
    found[0].actions.map(|a| a + 0.0)
}

/// At the support N = 0, Vz = −P and My = P L, whichever end of the member is there.
#[test]
fn a_cantilever() {
    let rows = rows(&cantilever());
    let support = [0.0, 0.0, -10e3, 0.0, 20e6, 0.0];
    assert_eq!(at(&rows, "B1", 0.0), support);
    let end = Program::at_end(Some(Program::Iom), at(&rows, "B2", 2.0));
    assert_eq!(end.map(|a| a + 0.0), support);
    assert_eq!(rows[0].text(Quantity::Case), Some("LC1"));
    assert_eq!((rows[0].length, rows.len()), (Some(2.0), 4));
}

/// The same load to the side, 10 kN along −y: dMz/dx = Qy, so that `Qy` = P and `Mz` = −P L at the
/// support. On the section there the member pulls the joint along −y: Vy = −P; the moment about z
/// of this force at the tip is −P L.
#[test]
fn a_cantilever_about_the_weak_axis() {
    let sideways = section(0.0, LC1, [0.0, 10e3, 0.0, 0.0, 0.0, -20e3]);
    let rows = rows(&[result("Member1D", 1, "Principle", &[sideways])]);
    assert_eq!(at(&rows, "B1", 0.0), [0.0, -10e3, 0.0, 0.0, 0.0, -20e6]);
}

/// All six forces, a combination of serviceability, and a member without a section at its end.
#[test]
fn factors_and_states() {
    let all = section(0.0, ("Combination", 2), [123.0, 456.0, 789.0, 111.0, 222.0, 333.0]);
    let rows = rows(&[result("Member1D", 2, "Principle", &[all])]);
    assert_eq!(rows[0].actions, [123.0, -456.0, -789.0, 111e3, -222e3, 333e3]);
    let texts = [Quantity::Case, Quantity::State].map(|q| rows[0].text(q));
    assert_eq!(texts, [Some("S1"), Some("SLS")]);
}

/// A column that runs through a node is two members, each with its own side of the node.
#[test]
fn a_member_of_two_elements() {
    let n = |x: f64| [x, 0.0, 0.0, 0.0, 0.0, 0.0];
    let positions = [(0.0, 1.0), (0.499_999, 2.0), (0.5, 9.0), (0.500_001, 3.0), (1.0, 4.0)];
    let sections = positions.map(|(x, f)| section(x, LC1, n(f)));
    let whole = rows(&[result("Member1D", 3, "Local", &sections)]);
    for (member, station, force) in
        [("C/E3", 0.0, 1.0), ("C/E3", 3.0, 2.0), ("C/E4", 0.0, 3.0), ("C/E4", 3.0, 4.0)]
    {
        assert_eq!(at(&whole, member, station), n(force), "{member} {station}");
    }
    assert_eq!([at(&whole, "C", 0.0), at(&whole, "C", 6.0)], [n(1.0), n(4.0)]);
    let element = |id: usize, forces: [f64; 2]| {
        let of = [0, 1].map(|i| section(i as f64, LC1, n(forces[i])));
        result("Element1D", id, "Local", &of)
    };
    let parts = rows(&[element(3, [1.0, 2.0]), element(4, [3.0, 4.0])]);
    for (member, station) in [("C/E3", 0.0), ("C/E3", 3.0), ("C/E4", 0.0), ("C", 0.0), ("C", 6.0)] {
        assert_eq!(at(&parts, member, station), at(&whole, member, station), "{member} {station}");
    }
}

#[test]
fn two_encodings_and_the_model() {
    let text = container(&cantilever());
    let wide: Vec<u8> =
        [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    let [one, other] = [text.as_bytes(), &wide].map(|b| read(b).expect("a container").rows);
    assert_eq!(one, other);
    let dir = tempfile::tempdir().expect("a folder");
    let path = dir.path().join("frame.xml");
    std::fs::write(&path, &wide).expect("written");
    let model = super::model(&path).expect("a model");
    for name in ["B1", "C", "C/E4"] {
        let member = model.member(name).expect(name);
        assert_eq!((member.profile.as_str(), member.steel.as_str()), ("IPE270", "S 235"));
        assert_eq!((member.section.as_str(), member.turned), ("beam", false));
    }
}

/// What is wrong with the file refuses all of it; what is wrong with a member refuses that member.
#[test]
fn what_is_wrong_is_told_with_its_place() {
    let by_vectors = |x: &str, z: &str| {
        format!(
            "</EndPoint><LocalCoordinateSystem i:type=\"CoordSystemByVector\">\
             <VecX><X>{x}</X><Y>0</Y><Z>0</Z></VecX><VecZ><X>0</X><Y>0</Y><Z>{z}</Z></VecZ>\
             </LocalCoordinateSystem>"
        )
    };
    let [down, against] = [by_vectors("1", "-1"), by_vectors("-1", "1")];
    let arc = "<TypeName>ArcSegment3D</TypeName><Id>1</Id></Segment>";
    let beam = "<TypeName>CrossSection</TypeName><Id>1</Id>";
    let angle = "<TypeName>CrossSection</TypeName><Id>2</Id>";
    let of_file = [
        ("<OpenModel>", "<!DOCTYPE a><OpenModel>", "no complete XML", "", "again"),
        (
            "<?xml version=\"1.0\" encoding=\"utf-16\"?>",
            "<!DOCTYPE a [<!ENTITY b \"c\">]>",
            "has a DTD",
            "",
            "delete it",
        ),
        ("</OpenModelContainer>", "", "no complete XML", "", "cut or edited"),
        ("OpenModelContainer", "OpenModel", "a model without results", "OpenModel", "container"),
        ("OpenModelContainer", "OpenModelResult", "without their model", "OpenModelResult", "cont"),
        ("OpenModelContainer", "Project", "`Project`, not an IOM", "Project", "export an"),
        ("OpenModelResult", "Other", "has no `OpenModelResult`", "OpenModelContainer", "one con"),
        (
            "InternalForces</ResultType>",
            "Deformation</ResultType>",
            "no internal forces",
            "OpenModelResult",
            "calculate",
        ),
        ("<Qz>10000</Qz>", "", "has no `Qz`", "SectionResultBase", "cut or edited"),
        ("<Qz>10000</Qz>", "<Qz>10,5</Qz>", "is `10,5`, which is no number", "Qz", "point"),
        ("<My>-20000</My>", "<My>NaN</My>", "which is no number", "My", "point"),
        (
            "LoadCase</LoadingType>",
            "ResultClass</LoadingType>",
            "class 1 is an envelope",
            "ResultOnMember[1]",
            "single",
        ),
        (
            "LoadCase</LoadingType><Id>1",
            "LoadCase</LoadingType><Id>7",
            "no `LoadCase` with the Id 7",
            "Loading",
            "same project",
        ),
        (
            "LoadCase</LoadingType>",
            "Combination</LoadingType>",
            "`CO1` (`Envelope`) is an envelope",
            "Loading",
            "linear",
        ),
        (
            "<Coefficient>1<",
            "<Coefficient>1.35<",
            "has the factor 1.35",
            "ResultOfLoadingItem",
            "without factors",
        ),
        (
            "Member1D</MemberType><Id>1",
            "Member1D</MemberType><Id>8",
            "Member1D 8, which the model",
            "Member",
            "same project",
        ),
        (
            "Relative</AbsoluteRelative>",
            "Both</AbsoluteRelative>",
            "is `Both`",
            "ResultBase",
            "`Absolute` or",
        ),
        (
            "<Point3D>\n<Id>2</Id>",
            "<Point3D>\n<Id>1</Id>",
            "two `Point3D` with the Id 1",
            "OpenModel/Point3D/Point3D[2]",
            "either",
        ),
    ];
    let of_member: [(&str, &str, &str, &str, &str); 11] = [
        ("Principle<", "Global<", "in global axes", "ResultOnMember[1]", "`Local`"),
        (beam, angle, "`angle` (RolledAngle) is no I or H", "ResultOnMember[1]", "`Local`"),
        ("</EndPoint>", &down, "z does not point up", "ResultOnMember[1]", "turn the"),
        ("</EndPoint>", &against, "x is not along the member", "LocalCoordinateSystem", "vectors"),
        (
            "<Name>E1</Name>",
            "<Name>E1</Name><RotationRx>1.5</RotationRx>",
            "turned by 1.500 rad",
            "ResultOnMember[1]",
            "upright webs",
        ),
        (
            "<Name>beam</Name>",
            "<CrossSectionRotation>0.5</CrossSectionRotation>",
            "turned by 0.500 rad",
            "ResultOnMember[1]",
            "upright webs",
        ),
        (
            "<TypeName>LineSegment3D</TypeName><Id>1</Id></Segment>",
            arc,
            "`ArcSegment3D` stands where",
            "Segment",
            "straight lines",
        ),
        (
            "<Position>0</Position>",
            "<Position>3</Position>",
            "at 3 of its length",
            "SectionResultBase",
            "together",
        ),
        (
            "<Name>B2</Name>",
            "<Name>B1</Name>",
            "several members of the model are called `B1`",
            "Member1D",
            "name of its own",
        ),
        ("<X>2</X>", "<X>0</X>", "an element without length", "LineSegment3D", "different points"),
        ("<X>2</X>", "<X>two</X>", "which is no number", "X", "point"),
    ];
    let text = container(&cantilever());
    let changed = |old: &str, new: &str| {
        assert!(text.contains(old), "{old}");
        // an outermost name stands twice; else the first place counts
        let count = if old.starts_with("Open") || old.starts_with("Inter") { 4 } else { 1 };
        let text = text.replacen(old, new, count);
        let envelope = new.starts_with("Combination");
        if envelope { text.replacen(">Linear<", ">Envelope<", 1) } else { text }
    };
    let told = |d: &Diagnostic, [why, place, help]: [&str; 3]| {
        assert!(d.message.contains(why), "{why}: {d:#?}");
        assert!(d.help.as_deref().is_some_and(|h| h.contains(help)), "{d:#?}");
        assert!(d.place.file.is_some(), "{d:#?}");
        let path = d.place.path.as_deref().unwrap_or_default();
        assert!(path.contains(place) && (place.is_empty() || d.place.line.is_some()), "{d:#?}");
    };
    for (old, new, why, place, help) in of_file {
        let faults = read(changed(old, new).as_bytes()).map(drop).expect_err(why);
        assert_eq!(faults.iter().count(), 1, "{faults:?}");
        told(&faults.into_first(), [why, place, help]);
    }
    for (old, new, why, place, help) in of_member {
        let found = read(changed(old, new).as_bytes()).unwrap_or_else(|e| panic!("{old}: {e:?}"));
        told(found.refused.get("B1").expect(why), [why, place, help]);
        let read = |r: &ForceRow| r.text(Quantity::Member) == Some("B1");
        assert!(!found.rows.iter().any(read), "{why}");
    }
}
