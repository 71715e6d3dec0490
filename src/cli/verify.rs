//! `bracket verify`: the certificate of a finished result, recomputed from its stored fields and
//! mesh alone.

use crate::analysis::engine::Pass;
use crate::analysis::limit::{self, LimitPass};
use crate::analysis::preload::tightened;
use crate::certify::bracket::{Bracket, LowerBound, UpperBound};
use crate::certify::certificate::{TOLERANCE, certify_displacement, certify_stress};
use crate::certify::fields::StressField;
use crate::certify::flow::VelocityField;
use crate::certify::limit_certificate::{certify_lower, certify_upper};
use crate::certify::plastic_certificate::{certify_plastic_motion, certify_yielding_stress};
use crate::certify::sampling::{sample, sample_live, sample_lower, sample_upper};
use crate::certify::slip::distance_from_coulomb;
use crate::certify::{FactorBracket, LowerFactor, UpperFactor};
use crate::cli::{CommandResult, Common, Format};
use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::analysis_pass::{DEAD_FIELD, LIVE_FIELD};
use crate::driver::case::entry_stem;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use crate::model::resolve::load_model;
use crate::recover::free_mechanism::{FreeMechanism, certify_free, is_free};
use crate::recover::unlimited::{Unlimited, certify_unlimited};
use crate::report::console::out;
use crate::result::case::{case_result, energy_bounds};
use crate::result::combine::{PassResult, join};
use crate::result::data::{CaseResult, FrictionModel, RESULT_FILE, RawBracket, ResultFile, Upper};
use crate::result::fields::field_files::{
    read_displacement, read_lower, read_shift, read_stress, read_velocity,
};
use crate::result::fields::plastic_file::read_plastic;
use crate::result::limit_case::{factor_bounds, limit_case_result};
use crate::result::verify::{Proved, case_differences, polygon_differences};
use crate::spec::analysis::AnalysisKind;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// How far the shift of the contact cones may be from the slips of the displacement, part of the
/// largest. The fixed point ends far below; a shift that has nothing to do with Coulomb's law is
/// not missed.
const FAR_FROM_COULOMB: f64 = 0.02;

/// Random points tried per field.
const POINTS: usize = 10_000;

/// Recompute the certificate of a finished result.
#[derive(Debug, clap::Args)]
pub struct VerifyArgs {
    /// Result folder.
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

/// What was found for one bound.
#[derive(Clone, Debug, Serialize)]
struct Finding {
    case: String,
    bound: &'static str,
    claimed: f64,
    recomputed: f64,
    worst_residual: f64,
    worst_at_random_points: f64,
    strict: bool,
    confirmed: bool,
}

/// Runs `bracket verify`.
pub fn run(args: &VerifyArgs, common: &Common) -> CommandResult {
    let text = read(&args.folder.join(RESULT_FILE))?;
    let result =
        ResultFile::from_json(&String::from_utf8_lossy(&text)).map_err(Diagnostic::from)?;
    let mut findings = Vec::new();
    let mut refuted = Vec::new();
    let mut proved = Vec::new();
    for (i, case) in result.cases.iter().enumerate() {
        let stem = entry_stem(&result.cases[..i], case);
        let (found, (other, of_case)) = verify_case(&args.folder, case, &stem, result.symmetry)?;
        findings.extend(found);
        refuted.extend(other);
        if let Some(of_case) = of_case {
            refuted.extend(case_differences(case, &of_case));
            proved.extend(result.polygon.is_some().then_some(of_case));
        }
    }
    refuted.extend(result.polygon.iter().flat_map(|claimed| polygon_differences(claimed, &proved)));
    let confirmed = findings.iter().all(|f| f.confirmed) && refuted.is_empty();
    match common.format {
        Format::Json => out::json(
            &serde_json::json!({"confirmed": confirmed, "bounds": findings, "refuted": refuted}),
        )?,
        Format::Text => {
            let rows: Vec<Vec<String>> = findings
                .iter()
                .map(|f| {
                    vec![
                        f.case.clone(),
                        f.bound.into(),
                        format!("{:.9e}", f.claimed),
                        format!("{:.9e}", f.recomputed),
                        format!("{:.1e}", f.worst_residual),
                        format!("{:.1e}", f.worst_at_random_points),
                        if !f.confirmed {
                            "REFUTED"
                        } else if f.strict {
                            "confirmed"
                        } else {
                            "confirmed as an estimate"
                        }
                        .into(),
                    ]
                })
                .collect();
            let head = [
                "case",
                "bound",
                "claimed",
                "recomputed",
                "worst residual",
                "random points",
                "finding",
            ];
            out::text(&out::columns(&head, &rows))?;
            for sentence in &refuted {
                out::text(&format!("REFUTED: {sentence}\n"))?;
            }
            if findings.is_empty() {
                out::text("the result claims no bound: nothing to confirm\n")?;
            }
        }
    }
    Ok(u8::from(!confirmed))
}

fn read(path: &Path) -> Result<Vec<u8>, Diagnostics> {
    std::fs::read(path).map_err(|e| {
        Diagnostic::input("verify/read", format!("`{}` cannot be read: {e}", path.display()))
            .file(path)
            .help(
                "name the folder of a finished result, as `bracket run` or `bracket analyse` left \
                 it",
            )
            .into()
    })
}

/// Sentences for what does not agree, and what the files of a case have proved.
type Confirmed = (Vec<String>, Option<Proved>);

/// Recomputes the bounds of a case, and everything that follows from them; sentences for what does
/// not agree.
fn verify_case(
    folder: &Path,
    case: &CaseResult,
    stem: &str,
    symmetry: u32,
) -> Result<(Vec<Finding>, Confirmed), Diagnostics> {
    let own = folder.join(format!("model_{stem}.yaml"));
    let model = load_model(&if own.exists() { own } else { folder.join("model.yaml") })?;
    // where the better lower bound is of another mesh, that stands beside its field
    let beside = folder.join("fields").join(format!("{stem}_static.yaml"));
    let other = if beside.exists() { Some(load_model(&beside)?) } else { None };
    let mut refuted = Vec::new();
    let mut findings = Vec::new();
    let mut found: Option<PassResult> = None;
    let (mut mechanism, mut carried) = (None, None);
    let sides = match &other {
        None => vec![(&model, [true, true])],
        Some(other) => vec![(&model, [true, false]), (other, [false, true])],
    };
    for (model, wanted) in sides {
        if symmetry != model.symmetry {
            refuted.push(format!(
                "the result claims symmetry {symmetry}, its model has {}",
                model.symmetry
            ));
        }
        let scene = Scene { model, case, folder, stem, wanted };
        let (new, side) = match model.analysis {
            AnalysisKind::Limit => {
                let (new, entry, pass) = scene.factors(&mut refuted)?;
                let bounds = factor_bounds(&pass, entry.problem);
                let answers = pass.carried(case.problem == FrictionModel::Coulomb);
                let of_answer =
                    answers.map(|(s, b)| (model.clone(), s.clone(), b.certificate().factor));
                carried = of_answer.or(carried);
                let free = pass.free.map(|f| (f.field, UpperFactor::new(f.certificate)));
                mechanism = pass.velocity.zip(pass.upper).or(free).or(mechanism);
                (new, PassResult { entry, bounds })
            }
            _ => {
                let (new, entry, pass) = scene.energies(&mut refuted)?;
                let bounds = energy_bounds(&pass);
                carried = pass.stress.map(|s| (model.clone(), s, 1.0)).or(carried);
                (new, PassResult { entry, bounds })
            }
        };
        findings.extend(new);
        found = Some(match found {
            None => side,
            Some(mut upper) => {
                match join(upper.clone(), side) {
                    Ok(joined) => upper.entry = joined,
                    Err(e) => refuted.push(format!("{}: {e}", case.name)),
                }
                upper
            }
        });
    }
    let Some(PassResult { entry, .. }) = found else { return Ok((findings, (refuted, None))) };
    refuted.extend(derived_differences(case, &entry));
    Ok((findings, (refuted, Some(Proved { entry, model, mechanism, stress: carried }))))
}

/// A case of a result folder.
struct Scene<'a> {
    model: &'a AnalysisModel,
    case: &'a CaseResult,
    folder: &'a Path,
    stem: &'a str,
    /// Whether the fields of the kinematic and of the static program are of this model's mesh.
    wanted: [bool; 2],
}

impl Scene<'_> {
    fn field(&self, kind: &str) -> Result<Vec<u8>, Diagnostics> {
        read(&self.folder.join("fields").join(format!("{}_{kind}.vtu", self.stem)))
    }

    /// The bounds of the energy, and the entry they make.
    fn energies(
        &self,
        refuted: &mut Vec<String>,
    ) -> Result<(Vec<Finding>, CaseResult, Pass), Diagnostics> {
        let Self { model: given, case, wanted: [kinematic, statics], .. } = *self;
        let claims_strict = case.certificate.is_some_and(|c| c.strict);
        let yields = given.analysis == AnalysisKind::Elastoplastic;
        let mut findings = Vec::new();
        let mut pass = Pass { fixed_point: case.fixed_point.clone(), ..Pass::default() };
        let bounded = case.lower.is_some() || case.upper.is_some();
        if given.has_coulomb_friction() && bounded {
            pass.shift = read_shift(given, &self.field("shift")?).map_err(Diagnostic::from)?;
        }
        let mut model = AnalysisModel { shift: pass.shift.clone(), ..given.clone() };
        for bolt in &mut model.preload {
            let told = case.preload.iter().find(|t| t.body == bolt.body && t.cut == bolt.cut);
            bolt.closure = told.map(|t| t.closure);
            if bounded && told.is_none_or(|t| t.force != bolt.force) {
                refuted.push(format!(
                    "{}: the preload of `{}` is not that of the model",
                    case.name, bolt.body
                ));
            }
        }
        let model = &model;
        if let Some(claimed) = case.lower.filter(|_| statics) {
            let stress = read_stress(model, &self.field("static")?).map_err(Diagnostic::from)?;
            let mut random = sample(model, None, Some(&stress), POINTS);
            let certificate = match yields {
                true => {
                    let inside = sample_lower(model, &stress, 1.0, POINTS);
                    random.traction_jump = random.traction_jump.max(inside.utilisation - 1.0);
                    certify_yielding_stress(model, &stress)
                }
                false => certify_stress(model, &stress, Loads::ALL),
            };
            let bound = LowerBound::new(certificate, model.symmetry);
            let c = bound.certificate();
            let over = c.weld.map_or(0.0, |used| used - 1.0).max(c.yields.unwrap_or(0.0));
            let worst = c.equilibrium.max(c.traction_jump).max(c.contact.unwrap_or(0.0)).max(over);
            let random = random.traction_jump.max(random.traction_cone).max(random.weld - 1.0);
            let numbers = [claimed, bound.value(), worst, random];
            findings.push(finding(case, "lower", numbers, bound.is_strict(), claims_strict));
            pass.lower = Some(bound);
            pass.stress = Some(stress);
        }
        if let Some(claimed) = case.upper.and_then(|u| u.finite()).filter(|_| kinematic) {
            let bytes = self.field("kinematic")?;
            let (displacement, certificate) = if yields {
                let field = read_plastic(model, &bytes).map_err(Diagnostic::from)?;
                let certificate = certify_plastic_motion(model, &field);
                let nodes = field.nodes.clone();
                pass.plastic = Some(field);
                (nodes, certificate)
            } else {
                let u = read_displacement(model, &bytes).map_err(Diagnostic::from)?;
                let certificate = certify_displacement(model, &u);
                (u, certificate)
            };
            let off = distance_from_coulomb(model, &pass.shift, &displacement);
            if off > FAR_FROM_COULOMB {
                refuted.push(format!(
                    "{}: the shift of the contact cones is off the slips of Coulomb's law by \
                     {off:.1e} of the largest",
                    case.name
                ));
            }
            let random = sample(model, Some(&displacement), None, POINTS).gap_cone;
            let bound = UpperBound::new(certificate, model.symmetry);
            let c = bound.certificate();
            let worst = c.compatibility.max(c.contact.unwrap_or(0.0));
            let numbers = [claimed, bound.value(), worst, random];
            findings.push(finding(case, "upper", numbers, bound.is_strict(), claims_strict));
            pass.upper = Some(bound);
        }
        pass.preload = tightened(model, pass.lower.as_ref().map(|l| &l.certificate().tensions[..]));
        if let (Some(l), Some(u)) = (&pass.lower, &pass.upper) {
            match Bracket::new(l.clone(), u.clone()) {
                Ok(b) => pass.bracket = Some(b),
                Err(e) => refuted.push(format!("{}: {e}", case.name)),
            }
        }
        let entry = case_result(&case.name, given, &pass, None);
        Ok((findings, entry, pass))
    }

    /// The bounds of the load factor, and the entry they make.
    fn factors(
        &self,
        refuted: &mut Vec<String>,
    ) -> Result<(Vec<Finding>, CaseResult, LimitPass), Diagnostics> {
        let Self { model, case, wanted: [kinematic, statics], .. } = *self;
        let claims_strict = case.certificate.is_some_and(|c| c.strict);
        let coulomb = case.problem == FrictionModel::Coulomb;
        let mut findings = Vec::new();
        let mut pass = LimitPass::default();
        let raw = if coulomb { case.associated.and_then(|a| a.lower) } else { case.lower };
        if let Some(claimed) = raw.filter(|_| statics) {
            // a raw bound beside the answer is told only where it is strict
            let (mut found, bound, stress) =
                self.lower_factor(model, "static", claimed, claims_strict || coulomb)?;
            found.bound = if coulomb { "lower, associated" } else { "lower" };
            findings.push(found);
            pass.lower = Some(bound);
            pass.stress = Some(stress);
        }
        let smooth =
            case.frictionless.and_then(|f| f.lower).or(if coulomb { case.lower } else { None });
        if let Some(claimed) = smooth.filter(|_| statics) {
            let without = model.without_friction();
            let strict = claims_strict || !coulomb;
            let (mut found, bound, stress) =
                self.lower_factor(&without, "static_frictionless", claimed, strict)?;
            found.bound = if coulomb { "lower" } else { "lower, frictionless" };
            findings.push(found);
            pass.frictionless = Some(bound);
            pass.frictionless_stress = Some(stress);
        }
        if let Some(claimed) = case.upper.and_then(|u| u.finite()).filter(|_| kinematic) {
            let nodes =
                read_velocity(model, &self.field("kinematic")?).map_err(Diagnostic::from)?;
            let field = limit::velocity(nodes);
            if claimed == 0.0 {
                let certificate = certify_free(model, &field);
                let free = is_free(&certificate);
                let worst = certificate
                    .rigid
                    .max(certificate.compatibility)
                    .max(certificate.contact.unwrap_or(0.0));
                // velocities that are no free mechanism prove nothing of zero
                let recomputed = if free { 0.0 } else { f64::INFINITY };
                let random = sample_upper(model, &field, POINTS).gap_cone;
                findings.push(finding(
                    case,
                    "upper",
                    [claimed, recomputed, worst, random],
                    free,
                    claims_strict,
                ));
                pass.free = free.then_some(FreeMechanism { field, certificate });
            } else {
                let (found, bound) = self.upper_factor(&field, claimed, claims_strict);
                findings.push(found);
                pass.upper = Some(bound);
                pass.velocity = Some(field);
            }
        }
        for (lower, bracket) in
            [(&pass.lower, &mut pass.bracket), (&pass.frictionless, &mut pass.coulomb)]
        {
            let (Some(l), Some(u)) = (lower, &pass.upper) else { continue };
            match FactorBracket::new(l.clone(), u.clone()) {
                Ok(b) => *bracket = Some(b),
                Err(e) => refuted.push(format!("{}: {e}", case.name)),
            }
        }
        if let Some(Upper::Unbounded(_)) = case.upper
            && claims_strict
        {
            let (found, unlimited) = self.no_limit()?;
            findings.push(found);
            pass.unlimited = Some(unlimited);
        }
        let mut found = limit_case_result(&case.name, model, &pass, None);
        // nothing in the files proves it: the claim stands as the estimate it must be
        if let Some(Upper::Unbounded(_)) = case.upper {
            found.upper = case.upper;
        }
        Ok((findings, found, pass))
    }

    /// The upper bound of stored velocities.
    fn upper_factor(
        &self,
        field: &VelocityField,
        claimed: f64,
        claims_strict: bool,
    ) -> (Finding, UpperFactor) {
        let sampled = sample_upper(self.model, field, POINTS);
        let bound = UpperFactor::new(certify_upper(self.model, field, limit::SUBDIVISIONS));
        let c = bound.certificate();
        let worst = [c.volume, c.rigid, c.compatibility, c.contact.unwrap_or(0.0)]
            .into_iter()
            .fold(0.0, f64::max);
        let numbers = [claimed, bound.value(), worst, sampled.strain.max(sampled.gap_cone)];
        (finding(self.case, "upper", numbers, bound.is_strict(), claims_strict), bound)
    }

    /// What the stored fields prove of a load factor that is claimed to have no limit. The
    /// finding's numbers are the deviator that is left: nothing else is claimed.
    fn no_limit(&self) -> Result<(Finding, Unlimited), Diagnostics> {
        let model = self.model;
        let field = read_stress(model, &self.field(LIVE_FIELD)?).map_err(Diagnostic::from)?;
        let dead = match model.has_dead_loads() {
            true => Some(read_lower(model, &self.field(DEAD_FIELD)?).map_err(Diagnostic::from)?.0),
            false => None,
        };
        let certificate = certify_unlimited(model, &field, dead.as_ref());
        let c = &certificate;
        let residuals = [c.equilibrium, c.traction_jump, c.deviator, c.contact.unwrap_or(0.0)];
        let worst = residuals.into_iter().fold(0.0, f64::max);
        let sampled = sample_live(model, &field, POINTS);
        let numbers = [0.0, 0.0, worst, sampled];
        let found = finding(self.case, "no limit", numbers, certificate.is_strict(), true);
        Ok((found, Unlimited { field, dead, certificate }))
    }

    /// The lower bound of a stored stress field of `model`.
    fn lower_factor(
        &self,
        model: &AnalysisModel,
        kind: &str,
        claimed: f64,
        claims_strict: bool,
    ) -> Result<(Finding, LowerFactor, StressField), Diagnostics> {
        let (stress, factor) = read_lower(model, &self.field(kind)?).map_err(Diagnostic::from)?;
        let sampled = sample_lower(model, &stress, factor, POINTS);
        let bound = LowerFactor::new(certify_lower(model, &stress, factor));
        let c = bound.certificate();
        let outside = (c.worst() + c.cover - 1.0).max(0.0);
        let residuals = [c.equilibrium, c.traction_jump, c.contact.unwrap_or(0.0), outside];
        let worst = residuals.into_iter().fold(0.0, f64::max);
        let random =
            sampled.traction_jump.max(sampled.traction_cone).max(sampled.utilisation - 1.0);
        let numbers = [claimed, bound.value(), worst, random];
        Ok((finding(self.case, "lower", numbers, bound.is_strict(), claims_strict), bound, stress))
    }
}

/// What a result derives from its bounds, claimed against recomputed.
fn derived_differences(claimed: &CaseResult, found: &CaseResult) -> Vec<String> {
    let near = |a: Option<f64>, b: Option<f64>| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-6 * a.abs().max(b.abs()) + 1e-12,
        (a, b) => a.is_none() && b.is_none(),
    };
    let end = |c: &CaseResult, i: usize| c.load_displacement.map(|d| d[i]);
    let strict = |c: &CaseResult| c.certificate.is_some_and(|x| x.strict);
    // the answer is the best of its history: each bound stands in a row, both with their gap where
    // one mesh gave both
    let upper = |u: Option<Upper>| u.and_then(|u| u.finite());
    let row = |l: bool, u: bool| {
        claimed.history.iter().any(|h| {
            let both = near(h.lower, found.lower) && near(upper(h.upper), upper(found.upper));
            (!l || near(h.lower, found.lower))
                && (!u || near(upper(h.upper), upper(found.upper)))
                && (!both || near(h.gap, found.gap))
        })
    };
    let history = row(true, false) && row(false, true);
    let raw = |a: Option<RawBracket>, b: Option<RawBracket>| {
        let numbers =
            |r: Option<RawBracket>| (r.and_then(|r| r.lower), r.and_then(|r| r.upper?.finite()));
        let (a, b) = (numbers(a), numbers(b));
        near(a.0, b.0) && near(a.1, b.1)
    };
    let bolts = claimed.preload.iter().zip(&found.preload);
    let preload = claimed.preload.len() == found.preload.len()
        && bolts.into_iter().all(|(a, b)| near(a.tension, b.tension));
    let shares = claimed.dissipation.len() == found.dissipation.len()
        && claimed
            .dissipation
            .iter()
            .zip(&found.dissipation)
            .all(|(a, b)| a.part == b.part && near(Some(a.share), Some(b.share)));
    let welds = claimed.welds.len() == found.welds.len()
        && claimed.welds.iter().zip(&found.welds).all(|(a, b)| {
            a.weld == b.weld
                && near(a.utilisation, b.utilisation)
                // results of earlier versions do not tell it
                && (a.mean_utilisation.is_none() || near(a.mean_utilisation, b.mean_utilisation))
                && near(a.share, b.share)
                && near(a.work, b.work)
        });
    let yielding = claimed.yielding.len() == found.yielding.len()
        && claimed.yielding.iter().zip(&found.yielding).all(|(a, b)| {
            a.part == b.part
                && near(a.utilisation, b.utilisation)
                && near(a.yielded, b.yielded)
                && near(a.dissipation, b.dissipation)
        });
    let agree = [
        ("gap", near(claimed.gap, found.gap)),
        // results of earlier versions do not tell it
        (
            "load",
            claimed.load.is_none_or(|a| {
                found
                    .load
                    .is_some_and(|b| a.unit() == b.unit() && near(Some(a.value()), Some(b.value())))
            }),
        ),
        ("load_displacement", (0..2).all(|i| near(end(claimed, i), end(found, i)))),
        ("problem", claimed.problem == found.problem),
        ("analysis", claimed.analysis == found.analysis),
        ("quantity", claimed.quantity == found.quantity),
        ("frictionless", raw(claimed.frictionless, found.frictionless)),
        ("associated", raw(claimed.associated, found.associated)),
        ("preload", preload),
        ("dissipation", shares),
        ("welds", welds),
        (
            "load_displacement_at_least",
            near(claimed.load_displacement_at_least, found.load_displacement_at_least),
        ),
        ("yielding", yielding),
        ("limiting_part", claimed.limiting_part == found.limiting_part),
        ("certificate.strict", !strict(claimed) || strict(found)),
        ("history", history),
    ];
    agree
        .into_iter()
        .filter(|(_, agrees)| !agrees)
        .map(|(what, _)| format!("{}: {what} is not what the fields give", claimed.name))
        .collect()
}

/// Confirmed: the same number to 1e-9, and strict where strictness is claimed, at random points as
/// well.
fn finding(
    case: &CaseResult,
    bound: &'static str,
    [claimed, recomputed, worst_residual, worst_at_random_points]: [f64; 4],
    strict: bool,
    claims_strict: bool,
) -> Finding {
    let same = (claimed - recomputed).abs() <= 1e-9 * claimed.abs().max(recomputed.abs());
    let admissible = strict && worst_at_random_points <= TOLERANCE;
    Finding {
        case: case.name.clone(),
        bound,
        claimed,
        recomputed,
        worst_residual,
        worst_at_random_points,
        strict: admissible,
        confirmed: same && (admissible || !claims_strict),
    }
}
