//! Converts a pass of limit analysis to the entry of its load case in `result.json`.

use crate::result::bounds::{CaseBounds, FactorLimit};
use crate::result::case_result::CaseResult;
use crate::result::case_result::PartShare;
use crate::result::case_result::PeakPressure;
use crate::result::certificate::Certificate;
use crate::result::energy_case::estimate_warning;
use crate::result::energy_case::only_load;
use crate::result::energy_case::problem;
use crate::result::energy_case::program_run;
use crate::result::energy_case::run_warning;
use crate::result::energy_case::weld_uses;
use crate::result::history::HistoryRow;
use crate::result::interface_use::{GroundUse, ResultantUse, SupportSlip, TieSlip};
use crate::result::quantity::{FrictionModel, Quantity, RawBracket, Upper};
use bracket_base::say;
use bracket_base::words::{Gap, Text};
use bracket_engine::analysis::limit::{LimitPass, NO_LIMIT, SUBDIVISIONS};
use bracket_engine::analysis::memory::peak_memory_mib;
use bracket_engine::analysis::program::Program;
use bracket_engine::analysis::program_outcome::ProgramOutcome;
use bracket_engine::certify::limit_certificate::{dissipation_densities, utilisation};
use bracket_engine::certify::velocity_field::VelocityField;

use bracket_base::math::Sum;
use bracket_engine::certify::{
    FactorBracket, LowerFactor, StressField, UpperFactor, crushing, cut_limits, slip, ties, welds,
};
use bracket_engine::elements::space::Tet10Space;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::analysis::{GroundContact, Support, Tie};
use bracket_engine::model::loads::Loads;
use bracket_engine::model::resultant_limit::ResultantLimit;
use bracket_engine::solve::SolveStatus;

/// The lower bound, the bracket and the static program of the problem that the user posed. Under
/// Coulomb's law these are the ones without friction.
fn answer(
    pass: &LimitPass,
    problem: FrictionModel,
) -> (Option<&LowerFactor>, Option<&FactorBracket>, Option<&ProgramOutcome>) {
    match problem {
        FrictionModel::Coulomb => {
            (pass.frictionless.as_ref(), pass.coulomb.as_ref(), pass.frictionless_run.as_ref())
        }
        _ => (pass.lower.as_ref(), pass.bracket.as_ref(), pass.statics.as_ref()),
    }
}

/// The residuals of both fields; if both fields have a residual, the larger one.
fn certificate(pass: &LimitPass, bounds: &CaseBounds) -> Option<Certificate> {
    if let Some(u) = &pass.unlimited {
        let c = &u.certificate;
        return Some(Certificate {
            strict: c.is_strict(),
            equilibrium: Some(c.equilibrium),
            traction_jump: Some(c.traction_jump),
            yield_: Some(c.deviator),
            contact: c.contact,
            ..Certificate::default()
        });
    }
    let of_upper = bounds.upper_certificate();
    match (bounds.lower_certificate(), of_upper) {
        (Some(l), Some(u)) => Some(u.with(&l)),
        (l, u) => l.or(u),
    }
}

/// True if the static program finds that the load can grow without limit: a stress field in
/// equilibrium exists for every multiple of it.
fn unbounded(run: Option<&ProgramOutcome>) -> bool {
    run.is_some_and(|r| r.status == SolveStatus::Infeasible)
}

/// Warnings of the programs: reasons why one of them gave no bound.
fn program_warnings(pass: &LimitPass, problem: FrictionModel) -> Vec<Text> {
    let runs = pass.runs().map(|(p, run)| {
        let bound = if p == Program::Static { "lower" } else { "upper" };
        (false, (p.name(), bound), run)
    });
    let without = pass.frictionless_run.as_ref();
    let without = without.map(|run| (true, ("frictionless static", "lower"), run));
    let mut warnings: Vec<Text> = Vec::new();
    let mut warn = |text: Text| {
        if !warnings.contains(&text) {
            warnings.push(text);
        }
    };
    for (frictionless, (name, bound), run) in runs.chain(without) {
        match run.status {
            _ if run.trouble.is_some() => warn(run_warning(name, bound, run).unwrap_or_default()),
            status if status.is_solution() => {}
            SolveStatus::Infeasible if frictionless => {
                warn(say!(
                    "without friction {} (the solver says so, no certificate proves it)",
                    NO_LIMIT
                ));
            }
            SolveStatus::Infeasible => warn(say!(
                "{} (the solver says so on this mesh, no certificate proves it); a load that only \
                 presses the parts together or changes their volume does this",
                NO_LIMIT
            )),
            SolveStatus::Unbounded => {
                let parts = run.mechanism.as_ref().map_or_else(Text::default, |m| say!(": {}", m));
                warn(match frictionless {
                    true => say!(
                        "without friction the dead loads alone make it collapse{}; the load \
                         factor has no lower bound",
                        parts
                    ),
                    false => say!(
                        "the dead loads alone make it collapse{}; the load factor has no lower \
                         bound",
                        parts
                    ),
                });
            }
            status => warn(run_warning(name, bound, run).unwrap_or_else(|| {
                say!(
                    "the {} program ended with status `{}`: no {} bound",
                    name,
                    status.words(),
                    bound
                )
            })),
        }
    }
    if let Some(parts) = &pass.moves {
        warn(say!("the live loads move the structure freely: {}", parts));
    }
    if let Some(parts) = &pass.slides {
        warn(say!(
            "friction alone holds the structure, without it the load factor is 0: {}",
            parts
        ));
    }
    let alone = pass.frictionless.is_none() && pass.lower.is_some();
    if problem == FrictionModel::Coulomb && alone && pass.slides.is_none() {
        warn(
            "under Coulomb's law only the bound without friction is safe, and there is none".into(),
        );
    }
    warnings
}

/// Reason why there is no estimate under Coulomb's law although the model requests one.
fn estimate_missing(model: &AnalysisModel, pass: &LimitPass) -> Option<Text> {
    let why = match &pass.coulomb_estimate {
        Some(e) => Gap::from(e.trouble.clone()?),
        None if !model.coulomb_estimate || pass.unlimited.is_some() || pass.free.is_some() => {
            return None;
        }
        None => "the program with associated friction has no answer to begin with".into(),
    };
    Some(say!("no estimate of the load factor under Coulomb's law by the fixed point: {}", why))
}

/// Shares in the dissipation of a mechanism.
#[derive(Default)]
struct Shares {
    bodies: Vec<PartShare>,
    welds: Vec<f64>,
    /// Supports along which it slips.
    supports: Vec<SupportSlip>,
    /// Ties along which it slips.
    ties: Vec<TieSlip>,
    ground: Vec<f64>,
    resultants: Vec<f64>,
}

fn shares(model: &AnalysisModel, velocity: &VelocityField) -> Shares {
    let mesh = &model.mesh;
    let mut bodies = vec![Sum::default(); mesh.bodies.len()];
    for (e, density) in dissipation_densities(model, velocity, SUBDIVISIONS).into_iter().enumerate()
    {
        bodies[mesh.tet_body[e] as usize].add(density * mesh.volume(e));
    }
    let welds = welds::dissipations(model, &velocity.nodes.u);
    let space = Tet10Space::new(mesh);
    let supports = slip::dissipations(model, &space, &velocity.nodes.u);
    let ties = ties::dissipations(model, &space, &velocity.nodes.u);
    let ground = crushing::dissipations(model, &space, &velocity.nodes.u);
    let resultants = cut_limits::costs(model, velocity);
    let interfaces = [&welds, &supports, &ties, &ground, &resultants].into_iter().flatten();
    let total = Sum::of(bodies.iter().map(|d| d.value()).chain(interfaces.copied()));
    let share = |d: f64| if total > 0.0 { d / total } else { 0.0 };
    let bodies = mesh.bodies.iter().zip(&bodies);
    let bodies = bodies.map(|(name, d)| PartShare { part: name.clone(), share: share(d.value()) });
    let supports = model.supports.iter().zip(supports).filter(|(_, d)| *d > 0.0);
    let slip = |(s, d): (&Support, f64)| SupportSlip { support: s.name.clone(), share: share(d) };
    let ties = model.ties.iter().zip(ties).filter(|(_, d)| *d > 0.0);
    let tie = |(t, d): (&Tie, f64)| TieSlip { tie: t.name.clone(), share: share(d) };
    Shares {
        bodies: bodies.collect(),
        welds: welds.into_iter().map(share).collect(),
        supports: supports.map(slip).collect(),
        ties: ties.map(tie).collect(),
        ground: ground.into_iter().map(share).collect(),
        resultants: resultants.into_iter().map(share).collect(),
    }
}

/// Each contact with ground that crushes: under a stress field with the load factor that it
/// carries, and with its share in the dissipation.
fn ground_uses(
    model: &AnalysisModel,
    carried: Option<(&StressField, f64)>,
    share: &[f64],
) -> Vec<GroundUse> {
    let used = carried.map(|(s, factor)| crushing::utilisations(model, s, Loads::at(factor)));
    let of = |(i, ground): (usize, &GroundContact)| {
        Some(GroundUse {
            ground: ground.name.clone(),
            strength: ground.strength?,
            utilisation: used.as_ref().and_then(|u| u.get(i).copied()),
            share: share.get(i).copied(),
        })
    };
    model.ground.iter().enumerate().filter_map(of).collect()
}

/// The entry of each resultant limit: its use by the stress of the lower bound and its share in the
/// mechanism, where there are these fields.
fn resultant_uses(
    model: &AnalysisModel,
    stress: Option<&StressField>,
    share: &[f64],
) -> Vec<ResultantUse> {
    let resultants = stress.map(|s| cut_limits::resultants(model, s));
    let of = |(i, limit): (usize, &ResultantLimit)| ResultantUse {
        limit: limit.name.clone(),
        at_most: limit.at_most,
        force: resultants.as_ref().map(|r| limit.resultant(r)),
        utilisation: resultants.as_ref().map(|r| limit.value(r) / limit.at_most),
        share: share.get(i).copied(),
    };
    model.resultant_limits.iter().enumerate().map(of).collect()
}

/// The bounds of the load factor from a pass, for the problem that the user posed.
pub fn factor_bounds(pass: &LimitPass, problem: FrictionModel) -> CaseBounds {
    let (lower, _, _) = answer(pass, problem);
    let mechanism = pass.upper.clone().map(FactorLimit::Mechanism);
    let free = pass.free.as_ref().map(|f| UpperFactor::new(f.certificate.clone()));
    let limit = mechanism.or(free.map(FactorLimit::FreeMechanism));
    // if both programs find no limit, the word `unbounded` is based on the static one
    let no_limit = pass.unlimited.is_some() || unbounded(pass.statics.as_ref());
    let upper = limit.or(no_limit.then_some(FactorLimit::Unbounded));
    CaseBounds::Factor { lower: lower.cloned(), upper }
}

/// The entry of a load case after one pass of limit analysis.
pub fn limit_case_result(
    name: &str,
    model: &AnalysisModel,
    pass: &LimitPass,
    mesh_seconds: Option<f64>,
) -> CaseResult {
    let problem = problem(model);
    let (low, bracket, static_run) = answer(pass, problem);
    let bounds = factor_bounds(pass, problem);
    let (lower, upper) = (bounds.lower(), bounds.upper());
    let gap = bracket.map(FactorBracket::gap).filter(|g| g.is_finite());
    let mut certificate = certificate(pass, &bounds);
    let mut warnings = program_warnings(pass, problem);
    warnings.extend(estimate_warning(certificate));
    warnings.extend(estimate_missing(model, pass));
    // no residual proves the solver's status `infeasible`, and a result is either strict as a whole
    // or not strict
    if let (Some(c), Some(Upper::Unbounded(_)), None) = (&mut certificate, upper, &pass.unlimited) {
        c.strict = false;
    }
    // the entry has no separate certificate for a raw value beside the answer, so a raw value is
    // reported only if it is a bound
    let strict =
        |b: &Option<LowerFactor>| b.as_ref().filter(|b| b.is_strict()).map(LowerFactor::value);
    let frictionless =
        strict(&pass.frictionless).map(|low| RawBracket { lower: Some(low), upper: None });
    let associated = (problem == FrictionModel::Coulomb
        && (pass.lower.is_some() || upper.is_some()))
    .then(|| RawBracket { lower: strict(&pass.lower), upper });
    let stress =
        if problem == FrictionModel::Coulomb { &pass.frictionless_stress } else { &pass.stress };
    let body = |tet: usize| model.mesh.bodies[model.mesh.tet_body[tet] as usize].clone();
    let used = stress.as_ref().map_or(Vec::new(), |s| welds::demands(model, s));
    let shares = pass.velocity.as_ref().map_or_else(Shares::default, |v| shares(model, v));
    let limits = resultant_uses(model, stress.as_ref(), &shares.resultants);
    let ground =
        ground_uses(model, stress.as_ref().zip(low.map(LowerFactor::value)), &shares.ground);
    let nearest = stress.as_ref().map(|s| utilisation(model, s));
    let limiting_part = nearest
        .filter(|(most, _)| used.iter().all(|w| w.largest <= *most))
        .filter(|(most, _)| ground.iter().all(|g| g.utilisation.is_none_or(|u| u <= *most)))
        .filter(|(most, _)| limits.iter().all(|r| r.utilisation.is_none_or(|u| u <= *most)))
        .and_then(|n| n.1)
        .map(body);
    let peak = low.and_then(|b| b.certificate().peak_pressure);
    CaseResult {
        lower,
        upper,
        gap,
        frictionless,
        associated,
        coulomb_estimate: pass.coulomb_estimate.as_ref().and_then(|e| e.factor),
        fixed_point: pass
            .coulomb_estimate
            .as_ref()
            .filter(|e| e.factor.is_some())
            .map(|e| e.run.clone()),
        load: only_load(model).filter(|l| l.value() > 0.0),
        certificate,
        history: vec![HistoryRow {
            macro_tets: model.mesh.tets.len(),
            kinematic_dofs: pass.kinematic.as_ref().map(|r| r.dofs),
            static_dofs: pass.statics.as_ref().or(static_run).map(|r| r.dofs),
            lower,
            upper,
            gap,
            kinematic: pass.kinematic.as_ref().map(program_run),
            static_: pass.statics.as_ref().map(program_run),
            static_frictionless: pass.frictionless_run.as_ref().map(program_run),
            seconds: None,
            so_far: None,
            predicted: None,
            mesh_seconds,
            peak_memory_mib: peak_memory_mib(),
        }],
        dissipation: shares.bodies,
        limiting_part,
        welds: weld_uses(model, used, shares.welds, Vec::new()),
        support_slip: shares.supports,
        tie_slip: shares.ties,
        crushing: ground,
        resultants: limits,
        peak_contact_pressure: peak.map(|p| PeakPressure { kinematic: None, static_: Some(p) }),
        warnings,
        ..CaseResult::empty(name, model.analysis, (Quantity::LoadFactor, problem))
    }
}
