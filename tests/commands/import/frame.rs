//! A made-up frame of two bays in equilibrium at its two nodes: A, where the beam B1 begins, and B
//! between B1 and B2. Columns go on above and below.

use super::workbook::workbook;
use std::fmt::Write as _;

/// Joints, with values of the spec.
pub const JOINTS: &str = "joint,end,member,station,end2,member2,station2,column_below,\
                          column_above,parameters.double_sided\n\
                          A,beam_right,B1,start,,,,C1,C2,false\n\
                          B,beam_right,B2,start,beam_left,B1,end,C3,C4,true\n";

/// The spec that both joints start from.
pub const BASE: &str = "template: beam_to_column_end_plate\n\
                        members: {column: {profile: HEB180, steel: S235}, beam: {profile: \
                        IPE270, steel: S235}}\nplate: {thickness: 12, width: 150, z: [-150, \
                        150]}\nbolts: {size: M16, grade: \"8.8\", gauge: 90, rows: [-80, 80]}\n\
                        parameters: {column_stiffeners: false}\n";

/// The import of the frame as SAP2000 writes it.
pub const SAP2000_ARGS: [&str; 10] = [
    "import",
    "forces.txt",
    "--joints",
    "joints.csv",
    "--base",
    "base.yaml",
    "--mapping",
    "sap2000",
    "-o",
    "out",
];

/// Load cases and the factors of all actions.
pub const CASES: [(&str, f64); 3] = [("ULS1", 1.0), ("ULS2", -0.4), ("SLS1", 0.7)];

/// A section at the end of a member: its name, the distance from its start \[m\], and N, Vz \[kN\]
/// and My \[kN m\] in Bracket's axes of the joint.
#[derive(Clone, Copy)]
pub struct Section {
    pub member: &'static str,
    pub x: f64,
    pub actions: [f64; 3],
}

const fn s(member: &'static str, x: f64, actions: [f64; 3]) -> Section {
    Section { member, x, actions }
}

/// All sections. At A: 60 = 1160 − 1100 and 30 = 18 + 12; at B: 70 + 65 = 485 − 350 and
/// 40 − 35 = 3 + 2.
pub const SECTIONS: [Section; 12] = [
    s("B1", 0.0, [0.0, -60.0, 30.0]),
    s("B1", 6.0, [0.0, -70.0, 40.0]),
    s("B2", 0.0, [0.0, -65.0, 35.0]),
    s("B2", 6.0, [0.0, -65.0, 35.0]),
    s("C1", 0.0, [-1160.0, 7.0, 9.0]),
    s("C1", 4.0, [-1160.0, 7.0, -18.0]),
    s("C2", 0.0, [-1100.0, 7.0, 12.0]),
    s("C2", 3.0, [-1100.0, 7.0, 9.0]),
    s("C3", 0.0, [-485.0, 2.0, 3.0]),
    s("C3", 4.0, [-485.0, 2.0, 3.0]),
    s("C4", 0.0, [-350.0, 2.0, -2.0]),
    s("C4", 3.0, [-350.0, 2.0, 3.0]),
];

/// The frame as a table of SAP2000.
pub fn sap2000(sections: &[Section]) -> String {
    let mut text = "TABLE:  Element Forces - Frames\n\
                    Frame\tStation\tOutputCase\tCaseType\tP\tV2\tV3\tT\tM2\tM3\n\
                    Text\tm\tText\tText\tKN\tKN\tKN\tKN-m\tKN-m\tKN-m\n"
        .to_string();
    for Section { member, x, actions: [n, v, m] } in sections {
        let turned = if *x > 0.0 { -1.0 } else { 1.0 };
        for (case, f) in CASES {
            let [n, v, m] = [n * f, turned * v * f, -m * f];
            let _ = writeln!(text, "{member}\t{x}\t{case}\tCombination\t{n}\t{v}\t0\t0\t0\t{m}");
        }
    }
    text
}

/// The sheets of a SAF workbook of the frame: results, and the model with these sections of beams
/// and columns. Case and order of headers are those of no version.
pub fn saf_sheets(
    sections: &[Section],
    beam: &str,
    column: &str,
) -> Vec<(&'static str, Vec<String>)> {
    let head = "Result on|Member|Member Rib|Result for|Load case|Load combination|Combination \
                key|Section at [m]|Index|N [kN]|Vy [kN]|Vz [kN]|Mx [kNm]|My [kNm]|Mz [kNm]";
    let mut results = vec![head.to_string()];
    for Section { member, x, actions: [n, v, m] } in sections {
        let turned = if *x > 0.0 { 1.0 } else { -1.0 };
        for (case, f) in CASES {
            let [n, v, m] = [n * f, turned * v * f, -m * f];
            results.push(format!(
                "On beam|{member}||Load combination||{case}|1.35*LC1|{x}|1|{n}|0|{v}|0|{m}|0"
            ));
        }
    }
    let mut members = vec!["Type|NAME|Cross-Section|Length [m]".to_string()];
    for name in ["B1", "B2", "C1", "C2", "C3", "C4"] {
        let section = if name.starts_with('B') { "CS1" } else { "CS2" };
        members.push(format!("beam|{name}|{section}|6"));
    }
    let of = |name: &str, code_and_profile: &str| format!("{name}|Steel|{code_and_profile}");
    let sections =
        vec!["Name|material|Form Code|Profile".into(), of("CS1", beam), of("CS2", column)];
    vec![
        ("Model", vec!["Name|made up".into()]),
        ("StructuralMaterial", vec!["Name|Type|Quality".into(), "Steel|STEEL|S 235".into()]),
        ("StructuralCrossSection", sections),
        ("structuralcurvemember", members),
        ("ResultInternalForce1D", results),
    ]
}

/// The SAF workbook.
pub fn saf(sections: &[Section], beam: &str, column: &str) -> Vec<u8> {
    workbook(&saf_sheets(sections, beam, column))
}
