use super::*;
use crate::draw::svg::overlaps;
use bracket_base::yaml;
use bracket_codes::design_code::build;
use bracket_joint::assembly::Facts;
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::ConnectionSpec;
use std::path::Path;

fn joint(text: &str) -> (EndPlate, Content) {
    let spec = yaml::parse::<ConnectionSpec>(text, Path::new("joint.yaml")).expect("a spec");
    let joint =
        build(&spec, Path::new("."), &Catalog::builtin().expect("catalogue")).expect("a joint");
    let Some(Facts::EndPlate(e)) = joint.facts else { panic!("an end plate") };
    (e, joint.content)
}

const COLUMN: &str = "template: beam_to_column_end_plate\nmembers: {column: {profile: HEB200, \
                      steel: S235}, beam: {profile: IPE300, steel: S235}}\nplate: {thickness: \
                      15}\nbolts: {size: M20, grade: \"8.8\", rows: [-90, 90, \
                      190]}\nparameters: {column_stiffeners: true, double_sided: true, \
                      doubler: true, rib: true}\nloads: [{name: A, end: beam_right, at: node, \
                      My: 40 kN m, Vz: -30 kN}, {name: A, end: beam_left, at: node, My: 30 kN \
                      m, Mz: 1 kN m}]\n";
const SPLICE: &str = "template: beam_splice\nmembers: {beam: {profile: IPE600, steel: \
                      S235}}\nplate: {thickness: 6, z: [-400, 310]}\nbolts: {size: M20, \
                      grade: \"8.8\", rows: [-350, -200, -155, 155]}\nloads: [{name: A, end: \
                      beam_right, at: bolt_plane, My: 40 kN m}]\n";

/// No two texts overlap, and the drawing gives every dimension that a fitter needs.
#[test]
fn drawings_give_every_size_and_no_text_covers_another() {
    let one = COLUMN
        .replace("double_sided: true, ", "")
        .replace(", {name: A, end: beam_left, at: node, My: 30 kN m, Mz: 1 kN m}", "");
    for text in [COLUMN, &one, SPLICE] {
        let (e, joint) = joint(text);
        let drawings = [sheet(&e, &joint, Some(65.0)), loads(&e)];
        for d in &drawings {
            assert_eq!(overlaps(&d.labels), 0, "{:?}", d.labels);
            assert!(d.labels.iter().all(|l| l[0] >= 0.0 && l[1] >= 0.0), "{:?}", d.labels);
        }
    }
    let (e, content) = joint(COLUMN);
    let text = views(&e, &content, Some(65.0)).file;
    for wanted in
        [">200<", ">15<", ">300<", ">100<", ">180<", ">12 bolts M20 × 65 8.8, holes of 22 mm<"]
    {
        assert!(text.contains(wanted), "{wanted}");
    }
    // two beams, twelve bolts in the side view of three rows, six hexagons in front
    assert_eq!(text.matches("<circle").count(), 6);
    let sketch = actions(&e).file;
    assert!(sketch.contains("A, beam_right: N = 0 kN, Vz = −30 kN, My = 37 kN m"), "{sketch}");
    assert!(sketch.contains("Mz = 1 kN m"), "{sketch}");
}
