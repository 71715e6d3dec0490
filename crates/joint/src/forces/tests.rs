//! A cantilever in the tables of each program: a member along x with P = 10 kN down at its tip,
//! 2 m from the support. Bracket's actions at the support are N = 0, Vz = −10 kN (the load presses
//! the member down) and My = 20 kN m (hogging: the top is pulled).

use super::*;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::grid::Comments;
use std::collections::BTreeMap;
use std::path::Path;

fn table(
    text: &str,
    program: Option<Program>,
    columns: &[(Quantity, &str)],
) -> Result<Vec<ForceRow>, Diagnostics> {
    let columns: BTreeMap<Quantity, String> =
        columns.iter().map(|(q, h)| (*q, (*h).to_string())).collect();
    let file = Path::new("forces.csv");
    let grid =
        bracket_base::grid::of_text(text, Comments::None).map_err(|d| Diagnostics::from(*d))?;
    let asked = Asked::Spec;
    let source = Source { file, sheet: None, program, columns: &columns, asked };
    read::of_grid(&grid, &source).map(|f| f.rows)
}

fn rows(text: &str, program: Program) -> Vec<ForceRow> {
    table(text, Some(program), &[]).unwrap_or_else(|e| panic!("{e:?}"))
}

fn refused(text: &str, program: Option<Program>) -> Diagnostic {
    table(text, program, &[]).map(drop).expect_err(text).into_first()
}

const SUPPORT: [f64; 6] = [0.0, 0.0, -10e3, 0.0, 20e6, 0.0];

/// Every program writes the support section of the cantilever, started at the support, in its own
/// headers, units and signs; a second row is the same cantilever drawn from its tip, so that the
/// support is at the member's end.
#[test]
fn a_cantilever_in_seven_programs() {
    for (program, text) in [
        (
            Program::Saf,
            "Result on,Member,Member Rib,Result for,Load case,Load combination,Combination key,\
             Section at [m],Index,N [kN],Vy [kN],Vz [kN],Mx [kNm],My [kNm],Mz [kNm]\n\
             On beam,B1,,Load case,LC1,,1*LC1,0,1,0,0,10,0,-20,0\n\
             On beam,B2,,Load combination,,LC1,1*LC1,2,3,0,0,-10,0,-20,0\n",
        ),
        (
            Program::Sap2000,
            "TABLE:  Element Forces - Frames\n\
             Frame\tStation\tOutputCase\tCaseType\tP\tV2\tV3\tT\tM2\tM3\tFrameElem\tElemStation\n\
             Text\tm\tText\tText\tKN\tKN\tKN\tKN-m\tKN-m\tKN-m\tText\tm\n\
             B1\t0\tLC1\tLinStatic\t0\t-10\t0\t0\t0\t-20\tB1-1\t0\n\
             B2\t2\tLC1\tLinStatic\t0\t10\t0\t0\t0\t-20\tB2-1\t2\n",
        ),
        (
            Program::Etabs,
            "TABLE:  Element Forces - Beams\n\
             Story,Beam,Unique Name,Output Case,Case Type,Station,P,V2,V3,T,M2,M3\n\
             ,,,,,m,kN,kN,kN,kN-m,kN-m,kN-m\n\
             S1,B1,B1,LC1,LinStatic,0,0,-10,0,0,0,-20\nS1,B2,B2,LC1,LinStatic,2,0,10,0,0,0,-20\n",
        ),
        (
            Program::Robot,
            "Bar/Node/Case;FX (kN);FY (kN);FZ (kN);MX (kNm);MY (kNm);MZ (kNm)\n\
             B1/1/LC1;0,00;0,00;10,00;0,00;-20,00;0,00\n\
             B2/4/LC1;0,00;0,00;-10,00;0,00;-20,00;0,00\n",
        ),
        (
            Program::Rfem,
            "Member No.;Node No.;Location x [m];LC/CO;N [kN];V-y [kN];V-z [kN];M-T [kNm];M-y [kNm];\
             M-z [kNm]\nB1;1;0,000;LC1;0,000;0,000;10,000;0,000;-20,000;0,000\n\
             B2;2;2,000;LC1;0,000;0,000;-10,000;0,000;-20,000;0,000\n",
        ),
        (Program::Staad, "Beam,L/C,Node,Fx (kN),Fy (kN),Fz (kN),Mx (kN-m),My (kN-m),Mz (kN-m)\n"),
        (
            Program::Scia,
            "Name\tdx [m]\tCase\tN [kN]\tVy [kN]\tVz [kN]\tMx [kNm]\tMy [kNm]\tMz [kNm]\n\
             B1\t0,000\tLC1\t0,00\t0,00\t10,00\t0,00\t-20,00\t0,00\n\
             B2\t2,000\tLC1\t0,00\t0,00\t-10,00\t0,00\t-20,00\t0,00\n",
        ),
    ] {
        let text = match program {
            // forces of the nodes on the ends of the member: the support holds it up at its start
            // with a moment about +z, and at its end with one about −z
            Program::Staad => format!("{text}B1,LC1,1,0,10,0,0,0,20\nB2,LC1,4,0,10,0,0,0,-20\n"),
            _ => text.to_string(),
        };
        let rows = rows(&text, program);
        assert_eq!(rows.len(), 2, "{program:?}");
        assert_eq!(rows[0].actions.map(|a| a + 0.0), SUPPORT, "{program:?} from the support");
        let at_end = Program::at_end(Some(program), rows[1].actions);
        assert_eq!(at_end.map(|a| a + 0.0), SUPPORT, "{program:?} to the support");
        for (row, member) in rows.iter().zip(["B1", "B2"]) {
            assert_eq!(row.text(Quantity::Case), Some("LC1"), "{program:?}");
            assert_eq!(row.text(Quantity::Member), Some(member), "{program:?}");
        }
    }
}

/// Numbers have no more digits than those of the table, whatever its units.
#[test]
fn products_without_noise() {
    let text = "case,N [kN],Vz [N],My [kN m],Mz [kN cm]\nA,1.005,12.3,4.35,-0.0007\n\
                B,-0.10877399322016867,0,8.1,0.07\n";
    let rows = table(text, None, &[]).expect("sound");
    assert_eq!(rows[0].actions, [1005.0, 0.0, 12.3, 0.0, 4.35e6, -7.0]);
    assert_eq!(rows[1].actions[4..], [8.1e6, 700.0]);
    assert!((rows[1].actions[0] + 108.773_993_220_168_67).abs() < 1e-12);
}

/// A fault of decimal signs is in the line of the number that the others contradict.
#[test]
fn lines_of_mixed_decimal_signs() {
    for (text, line, message) in [
        ("case;N [kN];My [kN m]\n1,5;1.5;2.5\nB;7;8\nC;2,25;1\n", 4, "`1.5` in line 2 has"),
        ("case;N [kN]\nA;2,25\nB;7\nC;1.5\n", 4, "`1.5` in line 4 has a point"),
        ("1,250;N [kN];case\n0;7;1,250\n0;1,250;B\n", 3, "`1,250` may be 1.250 or 1250"),
        ("case;N [kN];My [kN m]\nA;1.5;2,5\n", 2, "`1.5` has a point"),
    ] {
        let d = refused(text, None);
        assert_eq!(d.place.line, Some(line), "{text}: {d:#?}");
        assert!(d.message.contains(message), "{text}: {d:#?}");
    }
}

/// A command has options and no keys: its helps do not name `columns`.
#[test]
fn helps_for_a_command() {
    let none = BTreeMap::new();
    for (text, program, help) in [
        ("case,N\nA,1\n", None, "`N [kN]`"),
        ("a,b\n1,2\n", None, "`--mapping`"),
        ("case,N [kN],N [kN]\nA,1,2\n", None, "delete or rename"),
        ("case,N [kN],MY [kNm]\nA,1,2\n", None, "`--mapping` that knows it"),
        (
            "Bar,Case,FX (kN),FY (kN),FZ (kN),MX (kNm),MY (kNm),MZ (kNm)\n1,1,0,0,0,0,0,0\n",
            None,
            "`--mapping robot`",
        ),
        (
            "Member No.;Location x [m];LC;N [kN];My [kNm]\n1;0,00;1;0,00;-2,50\n",
            None,
            "with `--mapping`",
        ),
        ("LC;Stab;N [kN];Q [kNm]\n1;1;0,00;1,5\n", Some(Program::Rfem), "`--mapping` that"),
    ] {
        let grid = bracket_base::grid::of_text(text, Comments::None).expect("a table");
        let file = Path::new("forces.csv");
        let source = Source { file, sheet: None, program, columns: &none, asked: Asked::Command };
        let d = read::of_grid(&grid, &source).map(drop).expect_err(text).into_first();
        let told = d.help.unwrap_or_default();
        assert!(told.contains(help) && !told.contains("columns:"), "{text}: {told}");
        assert!(!d.message.contains("mapping: "), "{text}: {}", d.message);
    }
}

/// Tension is positive in Bracket, whatever the program says, and a moment about the weak axis that
/// pulls the side of +y′ is negative.
#[test]
fn axial_forces_and_weak_axes() {
    let of = |text: &str, p| rows(text, p)[0].actions;
    let robot = "Bar;Case;FX [kN];FY [kN];MZ [kNm]\n1;1;5;2;3\n";
    assert_eq!(of(robot, Program::Robot), [-5e3, -2e3, -0.0, -0.0, -0.0, -3e6]);
    let rfem = "Stab Nr.;LF;N [kN];Vy [kN];Mz [kNm]\n1;1;5,5;2,5;3,5\n";
    assert_eq!(of(rfem, Program::Rfem), [5.5e3, -2.5e3, 0.0, 0.0, 0.0, -3.5e6]);
    // axis 3 of SAP2000 is −y′, axis 2 is z′; M2 compresses the side of +3, M3 that of +2
    let sap = "Frame,OutputCase,P [kN],V3 [kN],M2 [kN m]\n1,A,5,2,3\n";
    assert_eq!(of(sap, Program::Sap2000), [5e3, -2e3, 0.0, 0.0, 0.0, -3e6]);
}

/// Bracket's own headers in the units of the table, and headers that the user names.
#[test]
fn headers_units_and_signs() {
    let own = "case;N [kN];Vz [N];My (kN cm)\nULS1;1,5;-20;300\n";
    let row = &table(own, None, &[]).expect("sound")[0];
    assert_eq!(row.actions, [1.5e3, 0.0, -20.0, 0.0, 3e6, 0.0]);
    let foreign = "Comb.\tF-x\tM strong [kNm]\nULS1\t-3\t7\n";
    let named = [(Quantity::Case, "Comb."), (Quantity::N, "-F-x [kN]"), (Quantity::My, "M strong")];
    let row = &table(foreign, None, &named).expect("sound")[0];
    assert_eq!(row.actions, [3e3, 0.0, 0.0, 0.0, 7e6, 0.0]);
    assert_eq!((row.line, row.text(Quantity::Case)), (2, Some("ULS1")));
    // the signs of a program hold for headers that the user names
    let rfem = table(
        "case;M-y\nA;7\n",
        Some(Program::Rfem),
        &[(Quantity::Case, "case"), (Quantity::My, "M-y [kNm]")],
    );
    assert_eq!(rfem.expect("sound")[0].actions[4], -7e6);
    // a name may begin with the mark of a comment
    assert_eq!(table("case,N [kN]\n#1,5\n", None, &[]).expect("sound")[0].actions[0], 5e3);
    // names that stand a row higher, over empty cells and over `Nr.`
    let two = "Stab;Knoten;Stelle;Lastfall;Kräfte;\n\
               Nr.;Nr.;x [m];;N [kN];M-y [kNm]\n12;7;0,000;LK 1;-3,88;-2,50\n";
    let row = &rows(two, Program::Rfem)[0];
    let texts = [Quantity::Member, Quantity::Node, Quantity::Case].map(|q| row.text(q));
    assert_eq!(texts, [Some("12"), Some("7"), Some("LK 1")]);
    assert_eq!((row.actions[0], row.actions[4]), (-3.88e3, 2.5e6));
    // a load case may have a name with `max`
    assert_eq!(table("case,N [kN]\nmax snow,1\n", None, &[]).expect("sound").len(), 1);
    // empty cells are zero, and a unit row may stand in brackets
    let units = "case,N,My\n,[kN],[kNm]\nA,,2\n";
    assert_eq!(table(units, None, &[]).expect("sound")[0].actions[4], 2e6);
}

#[test]
fn what_is_wrong_with_a_table() {
    let rfem = Some(Program::Rfem);
    for (text, program, why, help) in [
        ("", None, "the table is empty", "each further row a load case"),
        ("a,b\n1,2\n", None, "no row has the header of an action", "`a`, `b`"),
        ("case,N [kN]\n", None, "has no rows", "a load case"),
        ("case,N\nA,1\n", None, "the column `N` has no unit", "N [kN]"),
        // a unit that cannot be read is the fault of its own column
        ("case,N,My\n,kN,kNn\nA,1,2\n", None, "`My`: `kNn` is no unit of a moment", "kN m"),
        ("case,N,My\n,kip,t m\nA,1,2\n", None, "`My`: `t m` is no unit of a moment", "kN m"),
        ("case,N,My\n,,kN m\nA,1,2\n", None, "the column `N` has no unit", "N [kN]"),
        ("case,N [kN m]\nA,1\n", None, "`kN m` is no unit of a force", "kN"),
        ("case,N [kN],N [kN]\nA,1,2\n", None, "both `N [kN]` and `N [kN]`", "name one"),
        ("case,N [kN],MY [kNm]\nA,1,2\n", None, "`MY [kNm]` has a unit of actions", "columns"),
        ("case,N [kN],My [kNm]\nA,1,5,-30,5\n", None, "has 5 cells, the header 3", "comma"),
        ("case;N [kN];My [kNm]\nA;1\n", None, "has 2 cells, the header 3", "comma"),
        ("case,N [kN]\n,N\nA,1\n", None, "has two units: `kN` and `N`", "correct"),
        ("case,N [kN]\nA,much\n", None, "`much` is not a number", "a number"),
        ("case,N [kN]\nA,1 kN\n", None, "`1 kN` is not a number", "without a unit"),
        ("case,StepType,N [kN]\nA,Max,1\n", None, "`Max` belongs to an envelope", "single"),
        ("Member;LC;x;N [kN];My [kNm]\n1;RC1;max My;1;2\n", rfem, "`max My` belongs", "single"),
        ("case;N [kN];My [kN m]\nA;1.5;2,5\n", None, "`1.5` has a point", "the same sign"),
        ("case;N [kN];My [kN m]\nA;1.003;2,5\n", None, "`1.003` is not a number", "a number"),
        ("case,N [kN]\nENV_Max,1\n", None, "`ENV_Max` belongs to an envelope", "single"),
        ("case,N [kN]\nUmhüllende 1,1\n", None, "belongs to an envelope", "single"),
        ("case,N [kN]\nminMy,1\n", None, "`minMy` belongs to an envelope", "single"),
        ("case;N [kN]\nA;1,250\nB;7\n", None, "`1,250` may be 1.250 or 1250", "thousands"),
        (
            "Member No.;Location x [m];LC;N [kN];My [kNm]\n1;0,00;1;0,00;-2,50\n",
            None,
            "is a header of `mapping: rfem`",
            "`mapping`",
        ),
        (
            "Bar,Node,Case,FX (kN),FY (kN),FZ (kN),MX (kNm),MY (kNm),MZ (kNm)\n1,1,1,0,0,0,0,0,0\n",
            None,
            "no row has the header",
            "`mapping: robot`",
        ),
    ] {
        let d = refused(text, program);
        assert!(d.message.contains(why), "{text}: {d:#?}");
        assert!(d.help.as_deref().is_some_and(|h| h.contains(help)), "{text}: {d:#?}");
        assert!(d.place.line.is_some() && d.place.file.is_some(), "{text}: {d:#?}");
    }
    let many: String = (0..20).map(|i| format!("C{i},x\n")).collect();
    let faults = table(&format!("case,N [kN]\n{many}"), None, &[]).expect_err("many");
    assert_eq!(faults.iter().count(), 6);
    let named = [(Quantity::N, "Fxx")];
    let d = table("case,Fx\nA,1\n", None, &named).expect_err("unknown").into_first();
    assert!(d.message.contains("no row has the header"), "{d:#?}");
    let named = [(Quantity::N, "Fxx"), (Quantity::My, "My [kNm]")];
    let d = table("case,Fx,My\nA,1,2\n", None, &named).expect_err("unknown").into_first();
    assert!(d.message.contains("`Fxx`, which is not there, did you mean `Fx`"), "{d:#?}");
}
