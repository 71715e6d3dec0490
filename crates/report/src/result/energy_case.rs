//! Converts a pass to the entry of its load case in `result.json`.

use crate::result::bounds::CaseBounds;
use crate::result::case_result::CaseResult;
use crate::result::case_result::PartYield;
use crate::result::case_result::PeakPressure;
use crate::result::case_result::WeldUse;
use crate::result::certificate::Certificate;
use crate::result::face_motion::FaceMotion;
use crate::result::history::{self, HistoryRow, TraceRow};
use crate::result::quantity::{FrictionModel, LoadSize, Quantity, Upper};
use crate::result::refusal::refusal_words;
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::analysis::energy_pass::EnergyPass;
use bracket_engine::analysis::memory::peak_memory_mib;
use bracket_engine::analysis::program_outcome::ProgramOutcome;
use bracket_engine::certify::faces::contact_faces;
use bracket_engine::certify::plastic_certificate::body_states;
use bracket_engine::certify::rigid_fit::rigid_motions;
use bracket_engine::certify::welds::{Utilisation, demands};
use bracket_engine::certify::{LowerBound, TOLERANCE};
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::analysis::{Traction, Weld};
use bracket_engine::model::loads::face_corners;
use bracket_engine::solve::{Iteration, SolveStatus};

pub(crate) fn program_run(run: &ProgramOutcome) -> history::ProgramRun {
    history::ProgramRun {
        seconds: run.assembly_seconds + run.solve_seconds + run.certify_seconds,
        iterations: run.iterations,
        yielding_tets: run.yielding,
        solves: run.yielding.map(|_| run.rounds),
        status: run.status.words().into(),
        assembly_seconds: Some(run.assembly_seconds),
        solve_seconds: Some(run.solve_seconds),
        peak_memory_mib: None,
        factor_entries: run.forecast.map(|f| f.factor_entries),
        forecast_memory_mib: run.forecast.map(|f| f.bytes.max(run.handed_over).div_ceil(1 << 20)),
        forecast_seconds: run.forecast.map(|f| f.seconds),
        trace: run.trace.iter().map(trace_row).collect(),
    }
}

fn trace_row(i: &Iteration) -> TraceRow {
    let number = |x: f64| x.is_finite().then_some(x);
    TraceRow {
        number: i.number,
        gap: number(i.gap),
        residual: number(i.residual),
        step: number(i.step).unwrap_or(0.0),
        seconds: i.seconds,
    }
}

/// The residuals of both fields; if both fields have a residual, the larger one.
fn certificate(pass: &EnergyPass) -> Option<Certificate> {
    let of =
        [pass.upper.as_ref().map(Certificate::from), pass.lower.as_ref().map(Certificate::from)];
    of.into_iter().flatten().reduce(|u, l| u.with(&l))
}

/// The problem whose solution the bracket contains.
pub(crate) fn problem(model: &AnalysisModel) -> FrictionModel {
    let laws: Vec<_> =
        contact_faces(model).into_iter().map(|f| f.law).filter(|l| l.mu > 0.0).collect();
    if laws.is_empty() {
        FrictionModel::Frictionless
    } else if laws.iter().any(|l| l.is_coulomb()) {
        // limit analysis brackets the problem under Coulomb's law itself, the other kinds of
        // analysis bracket the last problem of its fixed point
        if model.analysis == AnalysisKind::Limit {
            FrictionModel::Coulomb
        } else {
            FrictionModel::ShiftedCones
        }
    } else {
        FrictionModel::Associated
    }
}

/// The resultant of the model's only load, if the load's own displacement `−2Π/F` is rigorous. That
/// requires one proportional load, no dead load, no initial gap, no preload, no shifted cones, and
/// no weld that may yield.
fn proportional_load(model: &AnalysisModel) -> Option<LoadSize> {
    let gaps = contact_faces(model).iter().any(|f| !f.law.gap.is_zero());
    let shifted = model.has_coulomb_friction() || model.has_preload();
    let bent = model.has_dead_loads()
        || gaps
        || shifted
        || !model.body_loads.is_empty()
        || !model.welds.is_empty();
    if bent { None } else { only_load(model) }
}

/// The resultant of the only load that carries the load factor: a force \[N\] on a plane face, or
/// one force or moment on a rigid face.
pub(crate) fn only_load(model: &AnalysisModel) -> Option<LoadSize> {
    if model.body_loads.iter().any(|l| !l.dead) {
        return None;
    }
    let live: Vec<_> = model.surface_loads.iter().filter(|l| !l.dead).collect();
    let copies = f64::from(model.symmetry);
    let actions = model
        .rigid
        .iter()
        .flat_map(|r| r.action.into_iter().enumerate())
        .filter(|(_, a)| *a != 0.0);
    match (&live[..], &actions.collect::<Vec<_>>()[..]) {
        ([], [(0..3, force)]) => Some(LoadSize::Force(force.abs() * copies)),
        ([], [(_, moment)]) => Some(LoadSize::Moment(moment.abs() * copies)),
        ([load], []) => {
            let areas: Vec<_> = load
                .faces
                .iter()
                .map(|f| vec3::area_vector(&face_corners(&model.mesh, f)))
                .collect();
            let total: f64 = areas.iter().map(|a| vec3::norm(*a)).sum();
            let resultant = areas.iter().fold([0.0; 3], |s, a| vec3::add(s, *a));
            let plane = vec3::norm(resultant) > (1.0 - 1e-9) * total;
            let stress = match load.traction {
                Traction::Pressure(p) if plane => p.abs(),
                Traction::Linear { traction0, gradient } if gradient == [[0.0; 3]; 3] => {
                    vec3::norm(traction0)
                }
                _ => return None,
            };
            Some(LoadSize::Force(stress * total * copies))
        }
        _ => None,
    }
}

/// Warnings of the programs: reasons why one of them gave no bound.
fn program_warnings(pass: &EnergyPass) -> Vec<Text> {
    // an admissible motion proves the reason; the status of the static program adds nothing
    if let Some(m) = pass.kinematic.as_ref().and_then(|r| r.mechanism.as_ref()) {
        let stands = pass.lower.as_ref().is_some_and(LowerBound::is_strict);
        return vec![if stands {
            // a motion cannot disprove a stress field in equilibrium: it is one of rounding
            "the kinematic program gave no upper bound: numbers of the model differ too much in \
             size (stiffness, loads or gaps)"
                .into()
        } else {
            say!("no equilibrium exists under these loads: {}", m)
        }];
    }
    let mut warnings = Vec::new();
    // an unbounded program leaves the other one without solution: this is one fault and is reported
    // once
    let runs_away = pass.statics.as_ref().is_some_and(|r| r.mechanism.is_some());
    for (program, run) in pass.runs() {
        let (name, bound) = (program.name(), program.bound());
        let common = run_warning(name, bound, run);
        warnings.push(match (run.status, run) {
            _ if common.is_some() => common.unwrap_or_default(),
            // the motion of the static program may only show that no stress field on this mesh is
            // in equilibrium
            (_, ProgramOutcome { mechanism: Some(m), .. }) => {
                say!("no stress of this mesh is in equilibrium with the loads: {}", m)
            }
            (status, _) if status.is_solution() => continue,
            (SolveStatus::Infeasible, ProgramOutcome { conflict: Some(c), .. }) => say!(
                "the {} program has no solution, so there is no {} bound: {}; check initial gaps \
                 and what holds the parts there, or refine the mesh there",
                name,
                bound,
                c
            ),
            _ if runs_away => continue,
            (status, _) => {
                say!("the {} program ended with status `{}`: no bound", name, status.words())
            }
        });
    }
    warnings
}

/// Reason why a program that was interrupted, refused, not certified or stopped by long tets gave
/// no bound; `None` for every other reason.
pub(crate) fn run_warning(
    name: &'static str,
    bound: &'static str,
    run: &ProgramOutcome,
) -> Option<Text> {
    Some(match (run.status, run) {
        (_, ProgramOutcome { trouble: Some(t), .. }) => {
            say!("the {} solution could not be certified: {}", name, t)
        }
        (status, ProgramOutcome { long_tets: Some(tets), .. }) => say!(
            "the {} program ended with status `{}`: no {} bound; {}",
            name,
            status.words(),
            bound,
            tets
        ),
        (SolveStatus::Interrupted, ProgramOutcome { iterations: 0, .. }) => say!(
            "the {} program was interrupted before its first iteration: no {} bound",
            name,
            bound
        ),
        (SolveStatus::Interrupted, ProgramOutcome { iterations: 1, .. }) => {
            say!("the {} program was interrupted after 1 iteration: no {} bound", name, bound)
        }
        (SolveStatus::Interrupted, run) => say!(
            "the {} program was interrupted after {} iterations: no {} bound",
            name,
            run.iterations,
            bound
        ),
        (SolveStatus::TooLarge, ProgramOutcome { refusal: Some(r), .. }) => say!(
            "the {} program was not started, so there is no {} bound: it {}",
            name,
            bound,
            refusal_words(r)
        ),
        _ => return None,
    })
}

/// The warning for a certificate that is not strict.
pub(crate) fn estimate_warning(certificate: Option<Certificate>) -> Option<Text> {
    let c = certificate.filter(|c| !c.strict)?;
    let worst = c
        .residuals()
        .into_iter()
        .filter_map(|(n, _, v)| Some((n, v?)))
        .max_by(|a, b| a.1.total_cmp(&b.1));
    worst.map(|(residual, value)| {
        say!(
            "the numbers are estimates, not bounds: the {} residual is {}, the tolerance {}",
            residual,
            format!("{value:.1e}"),
            format!("{TOLERANCE:.0e}")
        )
    })
}

/// The entry of each weld, from utilisations, shares in the dissipation and works, as far as they
/// exist.
pub(crate) fn weld_uses(
    model: &AnalysisModel,
    used: Vec<Utilisation>,
    share: Vec<f64>,
    work: Vec<f64>,
) -> Vec<WeldUse> {
    let weld = |(i, w): (usize, &Weld)| WeldUse {
        weld: w.name.clone(),
        utilisation: used.get(i).map(|u| u.largest),
        mean_utilisation: used.get(i).map(|u| u.mean),
        throat_strength: w.throat_strength,
        share: share.get(i).copied(),
        work: work.get(i).copied(),
    };
    model.welds.iter().enumerate().map(weld).collect()
}

/// Plastic state of each body that can yield.
fn yielding(model: &AnalysisModel, pass: &EnergyPass) -> Vec<PartYield> {
    let (motion, stress) = (pass.plastic.as_ref(), pass.stress.as_ref());
    if motion.is_none() && stress.is_none() {
        return Vec::new();
    }
    let states = body_states(model, motion, stress).into_iter().zip(&model.mesh.bodies);
    states
        .filter_map(|(state, name)| {
            let s = state?;
            Some(PartYield {
                part: name.clone(),
                utilisation: stress.map(|_| s.utilisation),
                yielded: motion.map(|_| s.flowing),
                dissipation: motion.map(|_| s.dissipation * f64::from(model.symmetry)),
                plastic_strain: motion.map(|_| s.strain),
                strain_at: motion.and((s.strain > 0.0).then_some(s.strain_at)),
            })
        })
        .collect()
}

/// Motion of each rigid face that carries an action; none without plastic strain in the field.
fn face_motions(model: &AnalysisModel, pass: &EnergyPass) -> Vec<FaceMotion> {
    let Some(motion) = &pass.plastic else { return Vec::new() };
    let motions = rigid_motions(model, &motion.nodes.u);
    let loaded = model
        .rigid
        .iter()
        .zip(motions)
        .filter(|(r, _)| r.action.iter().chain(&r.dead_action).any(|a| *a != 0.0));
    loaded
        .map(|(r, [x, y, z, a, b, c])| FaceMotion {
            face: r.name.clone(),
            displacement: [x, y, z],
            rotation: [a, b, c],
        })
        .collect()
}

/// The bounds of the potential energy from a pass.
pub fn energy_bounds(pass: &EnergyPass) -> CaseBounds {
    CaseBounds::Energy { lower: pass.lower.clone(), upper: pass.upper.clone() }
}

/// The entry of a load case after one pass.
pub fn case_result(
    name: &str,
    model: &AnalysisModel,
    pass: &EnergyPass,
    mesh_seconds: Option<f64>,
) -> CaseResult {
    let lower = pass.lower.as_ref().map(|b| b.value());
    let upper = pass.upper.as_ref().map(|b| b.value());
    let gap = pass.bracket.as_ref().map(|b| b.gap());
    let strict = certificate(pass).is_some_and(|c| c.strict);
    let load = proportional_load(model).filter(|f| f.value() > 0.0 && strict);
    let elastic = model.analysis == AnalysisKind::Elastic;
    let load_displacement = match (lower, upper, load) {
        (Some(l), Some(u), Some(f)) if elastic => {
            Some([-2.0 * u / f.value(), -2.0 * l / f.value()])
        }
        _ => None,
    };
    // an admissible stress remains admissible when scaled down, so −Π grows at least with the
    // square of the load, and its slope is at least −2Π
    let load_displacement_at_least = match (upper, load) {
        (Some(u), Some(f)) if !elastic => Some((-2.0 * u / f.value()).max(0.0)),
        _ => None,
    };
    let peak = PeakPressure {
        kinematic: pass.upper.as_ref().and_then(|b| b.certificate().peak_pressure),
        static_: pass.lower.as_ref().and_then(|b| b.certificate().peak_pressure),
    };
    let mut warnings = program_warnings(pass);
    warnings.extend(estimate_warning(certificate(pass)));
    CaseResult {
        lower,
        upper: upper.map(Upper::Finite),
        gap,
        preload: pass.preload.clone(),
        fixed_point: pass.fixed_point.clone(),
        load,
        load_displacement,
        load_displacement_at_least,
        certificate: certificate(pass),
        history: vec![HistoryRow {
            macro_tets: model.mesh.tets.len(),
            kinematic_dofs: pass.kinematic.as_ref().map(|r| r.dofs),
            static_dofs: pass.statics.as_ref().map(|r| r.dofs),
            lower,
            upper: upper.map(Upper::Finite),
            gap,
            kinematic: pass.kinematic.as_ref().map(program_run),
            static_: pass.statics.as_ref().map(program_run),
            static_frictionless: None,
            seconds: None,
            so_far: None,
            predicted: None,
            mesh_seconds,
            peak_memory_mib: peak_memory_mib(),
        }],
        yielding: if elastic { Vec::new() } else { yielding(model, pass) },
        face_motions: face_motions(model, pass),
        welds: weld_uses(
            model,
            pass.stress.as_ref().map_or(Vec::new(), |s| demands(model, s)),
            Vec::new(),
            pass.upper.as_ref().map_or(Vec::new(), |b| b.certificate().welds.clone()),
        ),
        peak_contact_pressure: (peak != PeakPressure::default()).then_some(peak),
        warnings,
        ..CaseResult::empty(name, model.analysis, (Quantity::PotentialEnergy, problem(model)))
    }
}
