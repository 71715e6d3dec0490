//! Pictures of the route of analysis: strain of the plates and buckling modes. They can be made
//! again from the files of the result.

use crate::bench::Bench;
use bracket::diag::Place;
use bracket::mesh::msh;
use bracket::model::AnalysisModel;
use bracket::model::file::ModelFile;
use bracket::model::resolve::resolve;
use bracket::report::draw::mode_picture::mode_pictures;
use bracket::report::draw::strain_picture::strain_pictures;
use bracket::report::markdown::compose::report_markdown;
use bracket::report::markdown::report_data::ReportData;
use bracket::result::fields::route_files::{read_modes, read_strains};
use std::fs;
use std::path::Path;

/// Two T-stubs pressed together: their webs are a column that is free at its head.
const SPEC: &str = "template: t_stub
members: {tee: {profile: IPE300, steel: S235}}
bolts: {size: M16, grade: \"8.8\", rows: [0]}
parameters: {length: 80}
friction: {mu: 0}
loads: [{name: PRESS, end: top, at: bolt_plane, N: -10 kN}]
analysis: {kind: limit}
";

/// The model and mesh of the elastoplastic analysis of a result.
fn model(folder: &Path) -> AnalysisModel {
    let path = folder.join("model_PRESS_elastoplastic.yaml");
    let text = fs::read_to_string(&path).expect("the model");
    let file = bracket::yaml::parse::<ModelFile>(&text, &path).expect("a model").value;
    let mesh = msh::read(&folder.join(&file.mesh)).expect("its mesh");
    resolve(&file, mesh, &|_| Place::default()).unwrap_or_else(|e| panic!("{e:#?}"))
}

/// Every picture has its value in words, is listed with its digest, and has the same bytes again
/// from the stored fields; so has the report.
#[test]
fn strain_and_modes_are_drawn_and_can_be_drawn_again() {
    let bench = Bench::new();
    fs::write(bench.path().join("press.yaml"), SPEC).expect("written");
    let run = bench.run(&["run", "press.yaml", "--size-factor", "2"]);
    let told = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(3), "{told}");
    let folder = bench.path().join("press");
    let data = ReportData::read(&folder).expect("the data of the report");
    let words = data.words();
    let case = data.result.cases.iter().find(|c| c.critical.is_some()).expect("critical factors");
    // the webs buckle antisymmetrically: a quarter of the joint alone does not show it
    let factors = case.critical.as_ref().expect("critical factors");
    assert_eq!(factors.fine[0].antisymmetric, [0]);
    // a column of 80 × 7.1 mm, 0.6 m long and free at its head: Euler's load is 3.43 kN; the
    // flanges in its middle make it shorter
    assert!(factors.fine[0].factor > 0.343 && factors.fine[0].factor < 0.43, "{factors:?}");
    let stem = "PRESS_elastoplastic";
    let caption = |file: &str| {
        let picture = data.pictures.iter().find(|p| p.file == file);
        picture.unwrap_or_else(|| panic!("no {file}")).caption.to_string()
    };
    let counted = bracket::checks::unit::number(factors.counted());
    let mode = caption(&format!("mode_1_{stem}.png"));
    let title = format!("buckling mode 1, α_cr = {counted}, antisymmetric to x = 0");
    assert!(mode.contains(&title), "{mode}");
    let report = bench.read("press/report.md");
    assert!(report.contains(&format!("α_cr = {counted} (")), "the step has the same value");
    let plates = &case.evidence.as_ref().expect("estimates").plates;
    let largest = plates.iter().map(|p| p.membrane).fold(0.0, f64::max);
    let percent = bracket::report::figures::percent(largest);
    let strain = caption(&format!("strain_{stem}.png"));
    assert!(strain.contains(&format!("The largest value is {percent} % in")), "{strain}");
    assert!(report.contains("| part | thickness [mm] | membrane strain [%] |"));

    let model = model(&folder);
    let read = |name: &str| fs::read(folder.join(name)).expect(name);
    let strains = read_strains(&model, &read(&format!("fields/{stem}_strain.vtu")));
    let modes = read_modes(&model, &read(&format!("fields/{stem}_modes.vtu"))).expect("modes");
    assert_eq!(modes.len(), factors.fine.len());
    let how = (stem, &[0, 1][..], &words);
    let mut again = strain_pictures(&model.mesh, &strains.expect("strains"), case, how);
    again.extend(mode_pictures(&model.mesh, &modes, case, how));
    assert!(again.len() > modes.len(), "a picture of each mode, and of the strain");
    let digests = bench.read("press/digests.b3");
    for (picture, drawn) in again {
        let file = &picture.file;
        assert!(read(file) == drawn.to_png().expect("encodes"), "{file}");
        assert!(data.pictures.contains(&picture), "{file}");
        assert!(digests.contains(file.as_str()) && report.contains(file.as_str()), "{file}");
    }
    assert!(digests.contains("_strain.vtu") && digests.contains("_modes.vtu"));
    assert_eq!(report_markdown(&data, &words), report);
    let verified = bench.run(&["verify", "press"]);
    let told = String::from_utf8_lossy(&verified.stdout).into_owned();
    assert_eq!(verified.status.code(), Some(0), "{told}");
}
