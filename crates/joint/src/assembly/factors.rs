//! Partial factors: from the spec, else from its national annex, else the recommended values.

use super::error::AssemblyError;
use super::scope::Resolved;
use crate::catalog::{Catalog, NationalAnnex};
use crate::spec::code::Code;
use bracket_base::units::limits;
use serde::Serialize;

/// Allowed range of a partial factor.
const RANGE: std::ops::RangeInclusive<f64> = 0.5..=3.0;

/// Basis of the row that stands for the code itself.
const RECOMMENDED: &str = "recommended";

/// All partial factors of one spec, in the order of the standard.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PartialFactors {
    /// γ_M0: cross-sections.
    pub gamma_m0: f64,
    /// γ_M1: members and web panels against instability.
    pub gamma_m1: f64,
    /// γ_M2: bolts, welds, net sections.
    pub gamma_m2: f64,
    /// γ_M3: slip at the ultimate limit state.
    pub gamma_m3: f64,
    /// γ_M3,ser: slip at serviceability.
    pub gamma_m3_ser: f64,
    /// γ_M7: preload of bolts.
    pub gamma_m7: f64,
}

/// The partial factors of a spec and their origins.
#[derive(Clone, Debug, PartialEq)]
pub struct FactorsOfSpec {
    /// The values.
    pub values: PartialFactors,
    /// The national annex, as the catalogue names it; `None` for the recommended values.
    pub annex: Option<String>,
    /// Each factor with its origin, for the list of resolved values.
    pub resolved: Vec<Resolved>,
    /// Factors below the recommended values, one sentence each. Possible causes: a typing error or
    /// a national annex.
    pub low: Vec<String>,
}

impl FactorsOfSpec {
    /// Reads the factors. Each fault is added to `faults`, and the factor is then 1.
    pub fn read(code: &Code, catalog: &Catalog, faults: &mut Vec<AssemblyError>) -> Self {
        let annex = code.annex.as_ref().and_then(|name| {
            let unlisted =
                |e| AssemblyError::Catalog { path: "code.annex".into(), cause: Box::new(e) };
            catalog.annex(name).map_err(|e| faults.push(unlisted(e))).ok()
        });
        let (mut resolved, mut low) = (Vec::new(), Vec::new());
        let mut factor =
            |name: &str, given: Option<f64>, of_annex: fn(&NationalAnnex) -> Option<f64>| {
                let path = format!("code.{name}");
                let recommended = catalog.partial_factor(name).map_err(|e| {
                    faults.push(AssemblyError::Catalog { path: path.clone(), cause: Box::new(e) });
                });
                let Ok(recommended) = recommended else { return 1.0 };
                let set = annex.and_then(of_annex);
                let value = given.or(set).unwrap_or(recommended.value);
                if !limits::within(value, &RANGE) {
                    let (path, name, value) = (path.clone(), path.clone(), value.to_string());
                    faults.push(AssemblyError::OutOfRange {
                        path,
                        name,
                        value,
                        range: "0.5 to 3".into(),
                    });
                }
                if !limits::at_least(value, recommended.value) {
                    low.push(format!(
                        "{name} = {value} is below the recommended {}: resistances are larger \
                         than by EN 1993",
                        recommended.value
                    ));
                }
                let origin = match (given, set, annex) {
                    (Some(_), _, Some(a)) => format!("given, in place of annex {}", a.annex),
                    (Some(_), _, None) => "given".into(),
                    (None, Some(_), Some(a)) => {
                        format!("annex {} ({}; {})", a.annex, a.standard, a.basis)
                    }
                    (None, None, Some(a)) if a.basis != RECOMMENDED => {
                        format!(
                            "recommended ({}); the row of annex {} leaves it out: check the annex",
                            recommended.standard, a.annex
                        )
                    }
                    _ => format!("recommended ({})", recommended.standard),
                };
                resolved.push(Resolved {
                    name: path,
                    value: value.to_string(),
                    given: given.is_some(),
                    default: Some(set.unwrap_or(recommended.value).to_string()),
                    range: Some("0.5 to 3".into()),
                    about: recommended.applies_to.clone(),
                    origin: Some(origin),
                });
                value
            };
        let values = PartialFactors {
            gamma_m0: factor("gamma_M0", code.gamma_m0, |a| a.gamma_m0),
            gamma_m1: factor("gamma_M1", code.gamma_m1, |a| a.gamma_m1),
            gamma_m2: factor("gamma_M2", code.gamma_m2, |a| a.gamma_m2),
            gamma_m3: factor("gamma_M3", code.gamma_m3, |a| a.gamma_m3),
            gamma_m3_ser: factor("gamma_M3_ser", code.gamma_m3_ser, |a| a.gamma_m3_ser),
            gamma_m7: factor("gamma_M7", code.gamma_m7, |a| a.gamma_m7),
        };
        let annex = annex.filter(|a| a.basis != RECOMMENDED).map(|a| a.annex.clone());
        Self { values, annex, resolved, low }
    }
}

#[cfg(test)]
mod tests {
    use crate::assembly::tests::{PAPER, joint, ok};

    fn with_code(code: &str) -> String {
        format!("code: {code}\n{PAPER}")
    }

    fn origins(code: &str) -> Vec<(String, String, String)> {
        let all = ok(&with_code(code)).resolved.into_iter().filter(|r| r.name.starts_with("code."));
        all.map(|r| (r.name, r.value, r.origin.unwrap_or_default())).collect()
    }

    #[test]
    fn what_is_given_wins_over_the_annex_and_the_annex_over_the_recommended_value() {
        let e = ok(PAPER).end_plate.expect("hand checks");
        let six = |e: &crate::assembly::EndPlate| {
            let f = &e.factors;
            [f.gamma_m0, f.gamma_m1, f.gamma_m2, f.gamma_m3, f.gamma_m3_ser, f.gamma_m7]
        };
        assert_eq!(six(&e), [1.0, 1.0, 1.25, 1.25, 1.1, 1.1]);
        let e = ok(&with_code("{annex: Germany, gamma_M2: 1.3}")).end_plate.expect("hand checks");
        assert_eq!(six(&e), [1.0, 1.1, 1.3, 1.25, 1.1, 1.1]);
        let all = "{gamma_M0: 1.01, gamma_M1: 1.02, gamma_M2: 1.03, gamma_M3: 1.04, gamma_M3_ser: \
                   1.05, gamma_M7: 1.06}";
        assert_eq!(
            six(&ok(&with_code(all)).end_plate.expect("hand checks")),
            [1.01, 1.02, 1.03, 1.04, 1.05, 1.06]
        );
    }

    /// A factor below the recommended one gives a warning; one that an annex raises does not.
    #[test]
    fn a_factor_below_the_recommended_one_is_a_warning() {
        let notes = |code: &str| ok(&with_code(code)).notes;
        let words =
            "gamma_M2 = 1.1 is below the recommended 1.25: resistances are larger than by EN 1993";
        assert_eq!(notes("{gamma_M2: 1.1}"), [words]);
        assert!(notes("{}").is_empty() && notes("{annex: DE, gamma_M0: 1.0}").is_empty());
    }

    #[test]
    fn every_factor_tells_where_it_comes_from() {
        let plain = origins("{}");
        assert_eq!(plain.len(), 6);
        assert!(
            plain.iter().all(|(_, _, o)| o.starts_with("recommended (EN 1993-1-")),
            "{plain:#?}"
        );
        assert_eq!(plain, origins("{annex: recommended}"));
        let norway = origins("{annex: NO, gamma_M1: 1}");
        let told: Vec<&str> = norway.iter().map(|(_, _, o)| o.as_str()).collect();
        assert!(told[0].starts_with("annex NO (NS-EN 1993-1-1/NA; unverified"), "{told:#?}");
        assert_eq!(told[1], "given, in place of annex NO");
        assert!(
            told[3].ends_with("the row of annex NO leaves it out: check the annex"),
            "{told:#?}"
        );
    }

    #[test]
    fn wrong_factors_and_annexes_name_place_and_limit() {
        for (code, place, words) in [
            ("{gamma_M1: 0}", "code.gamma_M1", "`code.gamma_M1` is 0; allowed: 0.5 to 3"),
            ("{gamma_M3: -1.25}", "code.gamma_M3", "is -1.25; allowed: 0.5 to 3"),
            ("{gamma_M3_ser: 3.01}", "code.gamma_M3_ser", "is 3.01; allowed: 0.5 to 3"),
            ("{gamma_M7: 11}", "code.gamma_M7", "is 11; allowed: 0.5 to 3"),
            ("{gamma_M7: .nan}", "code.gamma_M7", "finite"),
            ("{gamma_M1: 1,1}", "code.1", "`20.5 mm`, not `20,5 mm`"),
            ("{gamma_M1: '1,1'}", "code.gamma_M1", "expected a number without a unit"),
            ("{gamma_M3ser: 1.1}", "code.gamma_M3ser", "did you mean `gamma_M3_ser`?"),
            ("{gamma_m1: 1.1}", "code.gamma_m1", "did you mean `gamma_M1`?"),
            ("{annex: XX}", "code.annex", "national annex `XX` is not in the catalogue"),
            ("{annex: XX}", "code.annex", "(known: recommended, UK, DE, FR, NL, NO, AT, BE,"),
            ("{annex: recomended}", "code.annex", "did you mean `recommended`?"),
            ("{annex: [DE]}", "code.annex", "expected a text"),
        ] {
            let d = joint(&with_code(code)).map(drop).expect_err(code).into_first();
            let told = format!("{} {}", d.message, d.help.clone().unwrap_or_default());
            assert!(told.contains(words), "{code}: {d:#?}");
            assert_eq!(d.place.path.as_deref(), Some(place), "{code}: {d:#?}");
        }
    }
}
