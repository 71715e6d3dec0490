//! Partial factors: from the spec, else from its national annex, else the recommended values.

use bracket_base::say;
use bracket_base::units::limits;
use bracket_base::words::Text;
use bracket_joint::assembly::AssemblyError;
use bracket_joint::assembly::scope::Resolved;
use bracket_joint::catalog::{Catalog, NationalAnnex};
use bracket_joint::spec::code::{Code, ConcreteFactors, Edition, PartialFactors};

/// Allowed range of a partial factor.
const RANGE: std::ops::RangeInclusive<f64> = 0.5..=3.0;

/// Allowed range of α_cc. Source: EN 1992-1-1:2004 3.1.6(1), 0.8 to 1.0.
const ALPHA_CC: std::ops::RangeInclusive<f64> = 0.8..=1.0;

/// Basis of the row that stands for the code itself.
const RECOMMENDED: &str = "recommended";

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
    pub low: Vec<Text>,
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
        let mut factor = |name: &str,
                          given: Option<f64>,
                          of_annex: fn(&NationalAnnex) -> Option<f64>| {
            let path = format!("code.{name}");
            let (range, words) = match name {
                "alpha_cc" => (&ALPHA_CC, "0.8 to 1"),
                _ => (&RANGE, "0.5 to 3"),
            };
            let concrete = matches!(name, "gamma_c" | "alpha_cc");
            let of_code = match code.edition {
                Edition::Ec2005 => catalog.partial_factor(name),
            };
            let recommended = of_code.map_err(|e| {
                faults.push(AssemblyError::Catalog { path: path.clone(), cause: Box::new(e) });
            });
            let Ok(recommended) = recommended else { return 1.0 };
            let set = annex.and_then(of_annex);
            let value = given.or(set).unwrap_or(recommended.value);
            if !limits::within(value, range) {
                let (path, name, value) = (path.clone(), path.clone(), value.to_string());
                faults.push(AssemblyError::OutOfRange { path, name, value, range: words.into() });
            }
            // a smaller α_cc is the safe side
            if name != "alpha_cc" && !limits::at_least(value, recommended.value) {
                low.push(say!(
                    "{} = {} is below the recommended {}: resistances are larger than by EN \
                         1993",
                    name.to_owned(),
                    value.to_string(),
                    recommended.value.to_string()
                ));
            }
            let origin: Text = match (given, set, annex) {
                (Some(_), _, Some(a)) => say!("given, in place of annex {}", &a.annex),
                (Some(_), _, None) => "given".into(),
                (None, Some(_), Some(a)) if concrete => {
                    let basis = a.concrete_basis.clone().unwrap_or_default();
                    say!("annex {} ({}; {})", &a.annex, "EN 1992-1-1/NA", &basis)
                }
                (None, Some(_), Some(a)) => {
                    say!("annex {} ({}; {})", &a.annex, &a.standard, &a.basis)
                }
                (None, None, Some(a)) if a.basis != RECOMMENDED => {
                    say!(
                        "recommended ({}); the row of annex {} leaves it out: check the annex",
                        &recommended.standard,
                        &a.annex
                    )
                }
                _ => say!("recommended ({})", &recommended.standard),
            };
            resolved.push(Resolved {
                name: path,
                value: Text::given(value.to_string()),
                given: given.is_some(),
                default: Some(set.unwrap_or(recommended.value).to_string()),
                range: Some(words.into()),
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
            concrete: ConcreteFactors {
                gamma_c: factor("gamma_c", code.gamma_c, |a| a.gamma_c),
                alpha_cc: factor("alpha_cc", code.alpha_cc, |a| a.alpha_cc),
            },
        };
        let annex = annex.filter(|a| a.basis != RECOMMENDED).map(|a| a.annex.clone());
        Self { values, annex, resolved, low }
    }
}
