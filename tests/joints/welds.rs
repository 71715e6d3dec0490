//! Fillet welds of a template: they have finite strength in limit analysis. They are tied in
//! elastic analysis and where they have no throat.

use crate::built::{joint, model};
use bracket::analysis::event::silent;
use bracket::analysis::limit;
use bracket::analysis::pass::PassOptions;
use bracket::certify::welds::demands;
use bracket::checks::design_strengths;
use bracket::diag::Place;
use bracket::model::AnalysisKind;
use bracket::model::file::{Law, ModelFile};
use bracket::model::resolve::resolve;

/// Two IPE 200 with thick plates in tension; throats in mm.
fn splice(flange: f64, web: f64, steel: &str) -> String {
    format!(
        "template: beam_splice\nmembers: {{beam: {{profile: IPE200, steel: {steel}}}}}\nplate: \
         {{thickness: 25, width: 110, z: [-110, 110]}}\nbolts: {{size: M16, grade: \"8.8\", \
         gauge: 70, rows: [-60, 60]}}\nparameters: {{flange_weld: {flange}, web_weld: {web}, \
         beam_length: 200}}\nfriction: {{mu: 0}}\nloads: [{{name: PULL, end: beam_right, at: \
         bolt_plane, N: 100 kN}}]\n"
    )
}

fn welds(file: &ModelFile) -> Vec<&str> {
    let welds = file.interfaces.iter().filter(|i| i.law == Law::Weld);
    welds.filter_map(|i| i.face.as_deref()).collect()
}

/// Throats of 1 mm fail in pure tension: N = a f_u/(√3 β_w γ_M2) (2 (2 b − t_w − 2 r) + 2 (h − 2
/// t_f − 2 r) + 2 π r). Any field of uniform tractions gives this value as a lower bound, and the
/// rigid motion of the beam gives it as an upper bound. All other parts carry twice as much.
#[test]
fn thin_welds_carry_their_throats_times_their_lengths() {
    let (file, mesh) = model(&joint(&splice(1.0, 1.0, "S235")), 3.0, false, AnalysisKind::Limit);
    assert_eq!(welds(&file), ["WELD_TOP_R", "WELD_TOP_L", "WELD_WEB_R", "WELD_WEB_L"]);
    let (b, h, tw, tf, r) = (100.0, 200.0, 5.6, 8.5, 12.0);
    let flange = 2.0 * b - tw - 2.0 * r;
    let web = 2.0 * (h - 2.0 * tf - 2.0 * r) + 2.0 * std::f64::consts::PI * r;
    let carried = 360.0 / (3f64.sqrt() * 0.8 * 1.25) * (2.0 * flange + web) / 100e3;
    let m = resolve(&file, mesh, &|_| Place::default()).unwrap_or_else(|e| panic!("{e:#?}"));
    let pass = limit::run(&m, &PassOptions::default(), &silent()).unwrap();
    let bracket = pass.bracket.as_ref().unwrap();
    assert!(bracket.is_strict());
    let [low, up] = [bracket.lower().value(), bracket.upper().value()];
    println!("[{low:.5}, {up:.5}] against {carried:.5}");
    assert!(low <= carried * (1.0 + 1e-4) && low > 0.97 * carried, "{low} {carried}");
    assert!(up >= carried * (1.0 - 1e-4) && up < 1.01 * carried, "{up} {carried}");
    // at collapse every weld is fully used, also on average
    for d in demands(&m, pass.stress.as_ref().unwrap()) {
        assert!(d.largest <= 1.0 + 1e-9 && d.mean > 0.95 && d.mean <= d.largest, "{d:?}");
    }
}

/// Zero throats mean butt welds. In elastic analysis no weld yields. A steel without β_w cannot
/// have fillet welds.
#[test]
fn welds_without_a_throat_and_welds_of_elastic_analysis_are_tied() {
    for (flange, web, kind, want) in [
        (0.0, 0.0, AnalysisKind::Limit, &[][..]),
        (4.0, 0.0, AnalysisKind::Limit, &["WELD_TOP_R", "WELD_TOP_L"]),
        (0.0, 3.0, AnalysisKind::Limit, &["WELD_WEB_R", "WELD_WEB_L"]),
        (4.0, 3.0, AnalysisKind::Elastic, &[]),
    ] {
        let joint = joint(&splice(flange, web, "S235"));
        let (file, mesh) = model(&joint, 3.0, false, kind);
        let mut found = welds(&file);
        found.sort_unstable_by_key(|name| want.iter().position(|w| w == name));
        assert_eq!(found, want, "{flange} {web} {kind:?}");
        // the mesh contains the faces under any law
        let named = mesh.faces.iter().filter(|f| f.name.starts_with("WELD_")).count();
        assert_eq!(named, 2 * (usize::from(flange > 0.0) + usize::from(web > 0.0)));
    }
    let thickness = |name: &str| {
        let joint = joint(&splice(4.0, 3.0, "S355"));
        let w = joint.assembly.welds.iter().find(|w| w.name == name).unwrap().clone();
        (w.throat, w.thickness, design_strengths(&joint).welds[name].mpa())
    };
    // S355: f_u = 490 (Table 3.1), β_w = 0.9
    let (throat, t, strength) = thickness("WELD_BOTTOM_L");
    assert!(throat == 4.0 && (t - 1700.0 / 170.4).abs() < 0.01, "{t}");
    assert!((strength - 490.0 / (3f64.sqrt() * 0.9 * 1.25)).abs() < 1e-9, "{strength}");
    let (throat, t, _) = thickness("WELD_WEB_R");
    assert!(throat == 3.0 && t > 5.6 && t < 6.5, "{t}");
}
