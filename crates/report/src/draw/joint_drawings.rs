//! Drawings and further files of a joint, by family of connections.

use super::moment_rotation::Frame;
use super::{base_drawing, drawing, dxf, moment_axial, parts_drawing};
use crate::document::picture::PictureRef;
use crate::words::Words;
use bracket_base::say;
use bracket_codes::check::{Unit, number};
use bracket_codes::column_base;
use bracket_codes::end_plate::stocked_length;
use bracket_joint::assembly::{ColumnBase, Content, EndPlate, Facts};
use bracket_joint::spec::connection::Language;

/// What a report shows of a joint before it is analysed.
#[derive(Default)]
pub struct JointDrawings {
    /// Drawings of the joint, with the dimensions that the hand checks read, and of the actions at
    /// the member ends.
    pub pictures: Vec<(PictureRef, String)>,
    /// Files for the workshop, as name and text.
    pub workshop: Vec<(String, String)>,
    /// What the diagram of moment and rotation shows of the frame.
    pub frame: Frame,
    /// Corners N, My \[N, N mm\] of what the code allows of both together, beside the capacity
    /// polygon of these two.
    pub axial_moment: Option<Vec<[f64; 2]>>,
}

impl JointDrawings {
    /// The drawings of a joint.
    pub fn new(facts: Option<&Facts>, content: &Content, language: Language) -> Self {
        match facts {
            Some(Facts::EndPlate(e)) => Self {
                pictures: of_end_plate(e, content),
                workshop: vec![(dxf::DXF_FILE.into(), plate(e, content, language))],
                frame: Frame::of(e),
                axial_moment: None,
            },
            Some(Facts::Simple(e)) => Self::of_parts(content, Some(e.hole), language),
            Some(Facts::ColumnBase(e)) => Self::of_base(e, content, language),
            Some(Facts::CoverSplice(e)) => Self::of_parts(content, Some(e.hole), language),
            None => Self::of_parts(content, None, language),
        }
    }

    /// The drawings of a joint that shows its parts alone, and its bolted plates; `hole`: the
    /// diameter of the holes \[mm\], where hand checks know the plates.
    fn of_parts(content: &Content, hole: Option<f64>, language: Language) -> Self {
        let views = parts_drawing::views(content);
        let pictures = vec![views.picture("drawing.svg", "Two views of the joint")];
        let words = Words::new(language);
        let workshop = hole.map(|hole| dxf::bolted_plates(content, hole, &words));
        Self { pictures, workshop: workshop.unwrap_or_default(), ..Self::default() }
    }

    fn of_base(e: &ColumnBase, content: &Content, language: Language) -> Self {
        let caption = "Elevation and plan of the base";
        let mut out = Self {
            pictures: vec![base_drawing::views(e, content).picture("drawing.svg", caption)],
            ..Self::of_parts(content, Some(e.hole), language)
        };
        if let Some(mut diagram) = column_base::moment_axial(e) {
            let caption = say!(
                "Moment and axial force that the base carries by the code. With My = 0 exactly it \
                 carries N = −{} by 6.2.5, which also counts the area under the web",
                Unit::Force.show(column_base::axial_resistance(e))
            );
            let drawn = moment_axial::drawing(&diagram);
            out.pictures.push(drawn.picture("moment_axial.svg", caption));
            out.axial_moment = diagram.curves.pop().map(|c| c.border);
        }
        out
    }
}

fn of_end_plate(e: &EndPlate, content: &Content) -> Vec<(PictureRef, String)> {
    let views = drawing::views(e, content, stocked_length(e));
    let caption = "Side view of the joint, front view of the end plate";
    let mut out = vec![views.picture("drawing.svg", caption)];
    for (i, diagram) in bracket_codes::end_plate::moment_axial(e).iter().enumerate() {
        let file =
            if i == 0 { "moment_axial.svg".into() } else { format!("moment_axial_{}.svg", i + 1) };
        let caption = match &diagram.curves[..] {
            [only] if e.column.is_some() => say!(
                "Moment and axial force that the joint carries by the component method, β = {}",
                number(only.beta)
            ),
            _ => "Moment and axial force that the joint carries by the component method".into(),
        };
        out.push(moment_axial::drawing(diagram).picture(file, caption));
    }
    if !e.actions.is_empty() {
        let caption =
            "Actions at the member ends with their positive senses, values at the bolt plane";
        out.push(drawing::actions(e).picture("actions.svg", caption));
    }
    out
}

/// The end plate for the workshop. The names of steel and bolt stay as the catalogue has them.
fn plate(e: &EndPlate, content: &Content, language: Language) -> String {
    dxf::end_plate(e, content.end_plates(), &Words::new(language))
}
