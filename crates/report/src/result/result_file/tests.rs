use crate::result::fixtures::case;
use crate::result::result_file::*;

fn result(case: CaseResult) -> ResultFile {
    ResultFile { cases: vec![case], ..ResultFile::new("00", 4, Verdict::None) }
}

#[test]
fn absent_leaves_no_key_and_doubles_come_back_exactly() {
    let mut c = case();
    c.lower = Some(-1.0 / 3.0);
    let file = result(c);
    let text = file.to_json().expect("valid");
    for key in ["utilisation", "coulomb_estimate", "load_displacement", "warnings", "null", "yield"]
    {
        assert!(!text.contains(key), "{key} in {text}");
    }
    assert_eq!(ResultFile::from_json(&text).expect("reads"), file);
}

#[test]
fn unbounded_is_a_word() {
    let mut c = case();
    c.upper = Some(Upper::UNBOUNDED);
    c.gap = None;
    let file = result(c);
    let text = file.to_json().expect("valid");
    assert!(text.contains("\"upper\": \"unbounded\""), "{text}");
    assert_eq!(ResultFile::from_json(&text).expect("reads"), file);
    assert!(ResultFile::from_json(&text.replace("\"unbounded\"", "\"boundless\"")).is_err());
}

#[test]
fn what_is_not_finite_is_refused_with_its_place() {
    let mut c = case();
    c.utilisation = Some([0.5, f64::NAN]);
    match result(c).to_json() {
        Err(ResultError::NotFinite { path }) => assert_eq!(path, "cases[0].utilisation[1]"),
        other => panic!("{other:?}"),
    }
    let mut c = case();
    c.upper = Some(Upper::Finite(f64::INFINITY));
    assert!(matches!(result(c).to_json(), Err(ResultError::NotFinite { .. })));
}

#[test]
fn strict_needs_residuals_within_tolerance() {
    let mut c = case();
    c.certificate = Some(Certificate { strict: true, contact: Some(2e-9), ..Default::default() });
    assert!(matches!(result(c).to_json(), Err(ResultError::NotStrict { residual: "contact", .. })));
    let mut c = case();
    c.certificate = Some(Certificate { strict: true, ..Default::default() });
    assert!(matches!(result(c).to_json(), Err(ResultError::NoResidual { .. })));
    let mut c = case();
    c.certificate = Some(Certificate { strict: false, contact: Some(2e-3), ..Default::default() });
    assert!(result(c).to_json().is_ok());
}

#[test]
fn other_tools_and_schemas_are_refused() {
    let text = result(case()).to_json().expect("valid");
    assert!(matches!(
        ResultFile::from_json(&text.replace("\"schema\": 1", "\"schema\": 2")),
        Err(ResultError::Schema { found: 2 })
    ));
    assert!(matches!(
        ResultFile::from_json(&text.replace("\"name\": \"bracket\"", "\"name\": \"other\"")),
        Err(ResultError::Tool { .. })
    ));
    assert!(matches!(ResultFile::from_json("{\"nodes\": 3}"), Err(ResultError::Form(_))));
}

/// A result of an edition that had fewer keys is not read, and a new one may replace it.
#[test]
fn a_result_of_an_earlier_edition_may_be_replaced() {
    let earlier = result(case()).to_json().expect("valid").replace("\"verdict\"", "\"ruling\"");
    assert!(matches!(ResultFile::from_json(&earlier), Err(ResultError::Form(_))));
    assert!(ResultFile::is_of_this_program(&earlier).is_ok());
    assert!(ResultFile::is_of_this_program(&earlier[..earlier.len() / 2]).is_err());
}

#[test]
fn the_hash_sees_the_seams() {
    assert_ne!(input_hash(&[("a", b"bc")]), input_hash(&[("ab", b"c")]));
    assert_ne!(input_hash(&[("a", b"b"), ("c", b"d")]), input_hash(&[("a", b"bcd")]));
    assert_eq!(input_hash(&[("a", b"b")]), input_hash(&[("a", b"b")]));
}
