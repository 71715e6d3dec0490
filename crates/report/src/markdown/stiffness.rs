//! The initial stiffness of a joint from its elastic analysis: the bracket, the component method
//! for comparison, and the class.

use crate::document::Doc;
use crate::document::table::{Table, cells};
use crate::figures::{Rounding, bracket, significant};
use crate::result::result_file::CaseResult;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::JointStiffness;
use bracket_codes::check::Unit;
use bracket_codes::end_plate::FrameClass;
use bracket_codes::subject::Frame;

/// A paragraph and a table of the classes.
pub(crate) fn lines(doc: &mut Doc, case: &CaseResult) {
    let Some(s) = &case.joint_stiffness else { return };
    let per_mille = |x: f64, rounding| significant(1e3 * x, 4, rounding);
    let (low, high) = bracket(1e3 * s.rotation[0], 1e3 * s.rotation[1], 3);
    let [each, sections] = match s.ends.len() > 1 {
        true => [" each", "the loaded sections"],
        false => ["", "the loaded section"],
    };
    let parts = match s.classes.is_empty() {
        true => "plates, bolts and contact",
        false => "plates, bolts, contact, web and flanges of the column",
    };
    let range = match s.upper {
        Some(upper) => {
            let (a, b) = bracket(1e-6 * s.lower, 1e-6 * upper, 3);
            say!("lies between {} and {} kN m/rad", a, b)
        }
        None => say!(
            "is at least {} kN m/rad; there is no upper bound, because the lower bound of the \
             rotation does not exceed the rotation of the members",
            significant(1e-6 * s.lower, 3, Rounding::Down)
        ),
    };
    let beam = per_mille(s.beam_rotation, Rounding::Nearest);
    let members = match s.column_rotation {
        0.0 => say!("Of this, {} mrad is the bending of the beam, M L/(E I_b)", beam),
        column => say!(
            "Of this, {} mrad is the bending of the beam, M L/(E I_b), and {} mrad that of the \
             column between its supports, with the relief of its panel by its shear force",
            beam,
            per_mille(column, Rounding::Nearest)
        ),
    };
    doc.paragraph(say!(
        "{}, {}: M = {}{} rotates {} by between {} and {} mrad. {}; this is subtracted. The rest \
         is the rotation of the joint: {}. Its initial stiffness S_j,ini {}. {}.",
        &case.name,
        Text::joined(" and ", s.ends.iter().map(Text::given)),
        Unit::Moment.show(s.moment),
        each,
        sections,
        low,
        high,
        members,
        parts,
        range,
        method(s)
    ));
    if s.classes.is_empty() {
        doc.paragraph(
            "It has no class: EN 1993-1-8 5.2.2.5 gives boundaries for beam-to-column joints only.",
        );
        return;
    }
    doc.paragraph(
        "Class by stiffness (EN 1993-1-8 5.2.2.5(1); S_j,ini against k_b E I_b/L_b and 0.5 E \
         I_b/L_b), where K_b/K_c ≥ 0.1. In other than braced frames with a smaller ratio no joint \
         is rigid:",
    );
    let columns =
        Table::columns(["frame", "nominally pinned", "rigid", "class at the beam's length"]);
    doc.table(&Table { columns, rows: s.classes.iter().map(row).collect() });
}

/// Compares the component method with the bracket.
fn method(s: &JointStiffness) -> Text {
    let cm = s.component_method;
    let ratio = |x: f64, rounding| significant(x / cm, 3, rounding);
    let place = match s.upper {
        _ if cm < s.lower => "softer than the lower bound",
        Some(upper) if cm > upper => "stiffer than the upper bound",
        Some(_) => "inside the bracket",
        None => "above the lower bound",
    };
    let up = s.upper.map_or(String::new(), |u| format!(", FE_up/CM = {}", ratio(u, Rounding::Up)));
    say!(
        "The component method gives {} (6.3), {}: FE_low/CM = {}{}",
        Unit::Rotational.show(cm),
        place,
        ratio(s.lower, Rounding::Down),
        up
    )
}

fn row(c: &FrameClass) -> Vec<Text> {
    let metres = |mm: f64, rounding| format!("{} m", significant(1e-3 * mm, 3, rounding));
    let frame = match c.frame {
        Frame::Braced => "braced, k_b = 8",
        Frame::Unbraced => "other, k_b = 25",
    };
    let pinned = match c.pinned_to {
        Some(l) => say!("beams up to {}", metres(l, Rounding::Down)),
        None => "open".into(),
    };
    let from = metres(c.rigid_from, Rounding::Up);
    let rigid = match c.not_rigid_below {
        Some(l) => {
            say!("beams from {}; not rigid below {}", from, metres(l, Rounding::Down))
        }
        None => say!("beams from {}", from),
    };
    let class = match c.class {
        None => "no `length` is given".into(),
        Some([a, b]) if a == b => Text::from(a.words()),
        Some([a, b]) => say!("UNDECIDED: from {} to {}", a.words(), b.words()),
    };
    cells![frame, pinned, rigid, class]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::english;
    use crate::result::fixtures;
    use bracket_codes::classification::StiffnessClass;

    fn stiffness() -> JointStiffness {
        JointStiffness {
            ends: vec!["beam_right".into()],
            moment: 40e6,
            rotation: [3e-3, 5e-3],
            beam_rotation: 1e-3,
            column_rotation: 5e-4,
            lower: 1e10,
            upper: Some(2e10),
            component_method: 1.6e10,
            classes: Vec::new(),
        }
    }

    /// The component method is reported as inside, softer or stiffer, with ratios rounded outwards.
    #[test]
    fn the_component_method_stands_beside_the_bracket() {
        let s = stiffness();
        assert!(
            method(&s)
                .to_string()
                .ends_with("inside the bracket: FE_low/CM = 0.625, FE_up/CM = 1.25"),
            "{}",
            method(&s)
        );
        let softer = method(&JointStiffness { component_method: 0.9e10, ..s.clone() }).to_string();
        assert!(
            softer.contains("softer than the lower bound: FE_low/CM = 1.11, FE_up/CM = 2.23"),
            "{softer}"
        );
        let stiffer = method(&JointStiffness { component_method: 3e10, ..s.clone() }).to_string();
        assert!(
            stiffer.contains("30000 kN m/rad (6.3), stiffer than the upper bound"),
            "{stiffer}"
        );
        let open = method(&JointStiffness { upper: None, ..s }).to_string();
        assert!(open.ends_with("above the lower bound: FE_low/CM = 0.625"), "{open}");
    }

    /// The paragraph is plain text: no mark of Markdown is left in it. It names both members.
    #[test]
    fn no_mark_stands_in_the_paragraph() {
        let case = CaseResult { joint_stiffness: Some(stiffness()), ..fixtures::case() };
        let page = english(|doc| lines(doc, &case));
        let (a, b) = bracket(1e4, 2e4, 3);
        assert!(page.contains(&format!("S_j,ini lies between {a} and {b} kN m/rad")), "{page}");
        assert!(page.contains("1.000 mrad is the bending of the beam"), "{page}");
        assert!(page.contains("0.5000 mrad that of the column"), "{page}");
        assert!(!page.contains('*'), "{page}");
    }

    /// The lengths are on the safe side, and a class that the bracket does not decide is undecided.
    #[test]
    fn an_open_class_is_undecided() {
        let c = FrameClass {
            frame: Frame::Braced,
            rigid_from: 10_001.0,
            not_rigid_below: Some(5_009.0),
            pinned_to: Some(312.9),
            class: Some([StiffnessClass::SemiRigid, StiffnessClass::Rigid]),
        };
        let cells = row(&c);
        assert_eq!(cells[1], "beams up to 0.312 m");
        assert_eq!(cells[2], "beams from 10.1 m; not rigid below 5.00 m");
        assert_eq!(cells[3], "UNDECIDED: from semi-rigid to rigid");
        assert_eq!(row(&FrameClass { class: Some([StiffnessClass::Rigid; 2]), ..c })[3], "rigid");
    }
}
