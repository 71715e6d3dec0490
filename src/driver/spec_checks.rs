//! Checks of a spec before the mesher starts.

use crate::driver::spec_file::SpecFile;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::units::limits;
use bracket_base::yaml::Parsed;
use bracket_engine::model::AnalysisKind;
use bracket_joint::spec::analysis::Combinations;
use bracket_joint::spec::connection::ConnectionSpec;
use bracket_joint::spec::loads::LoadSpec;
use bracket_report::result::file_names::{file_stem, stem_of};

/// All checks of a spec for these kinds of analysis; `kinds` is empty for the hand checks alone.
pub fn check_input(input: &SpecFile, kinds: &[AnalysisKind]) -> Result<(), Diagnostics> {
    check_loads(&input.spec, kinds)?;
    check_combinations(input, kinds)?;
    match input.joint.welds_without_strength.first().filter(|_| !kinds.is_empty()) {
        Some(weld) => Err(weld.clone().into()),
        None => check_preload(input, kinds),
    }
}

/// Refuses `combinations: covered` where each load case needs its own analysis.
fn check_combinations(input: &SpecFile, kinds: &[AnalysisKind]) -> Result<(), Diagnostics> {
    let asked = input.spec.value.analysis.combinations == Some(Combinations::Covered);
    let Some(why) = input.needs_each(kinds).filter(|_| asked && !kinds.is_empty()) else {
        return Ok(());
    };
    let message = format!("`combinations: covered` beside {why}, which needs every load case");
    let help = "write `kind: limit` and `decide: false` for bounds of all load cases by few \
                analyses; or leave `combinations` out";
    let mut d = Diagnostic::input("spec/value", message).help(help);
    d.place = input.spec.index.place("analysis.combinations");
    Err(d.into())
}

/// The checks of names and sizes of loads.
pub fn check_loads(
    spec: &Parsed<ConnectionSpec>,
    kinds: &[AnalysisKind],
) -> Result<(), Diagnostics> {
    check_names(spec, kinds)?;
    check_sizes(spec)
}

/// The kinds of analysis that the spec requests, each once.
pub fn analysis_kinds(input: &SpecFile) -> Result<Vec<AnalysisKind>, Diagnostics> {
    let place = |path: &str| input.spec.index.place(path);
    let mut wanted = Vec::new();
    for kind in input.kinds() {
        if wanted.contains(&kind) {
            let mut d =
                Diagnostic::input("spec/value", "`analysis.kind` names the same kind twice")
                    .help("name each kind once: `kind: [elastic, limit]`");
            d.place = place("analysis.kind");
            return Err(d.into());
        }
        wanted.push(kind);
    }
    Ok(wanted)
}

/// Refuses preload together with yielding bolts: a bolt that yields loses its preload, which a
/// holonomic law does not follow.
fn check_preload(input: &SpecFile, kinds: &[AnalysisKind]) -> Result<(), Diagnostics> {
    let asked = kinds.contains(&AnalysisKind::Elastoplastic);
    let elastic = input.elastic_bolts(AnalysisKind::Elastoplastic);
    if input.joint.assembly.preloads.is_empty() || !asked || elastic {
        return Ok(());
    }
    let message = "preloaded bolts that may yield: an elastic, perfectly plastic analysis tightens \
                   elastic bolts only";
    let help = "add `bolts: elastic` under `analysis`; or take `preload: none`, `kind: elastic`, \
                or `limit`, where the preload drops out";
    let mut d = Diagnostic::input("model/unavailable", message).help(help);
    d.place = input.spec.index.place("bolts.preload");
    Err(d.into())
}

/// Checks the names of load cases. They become file names: each case needs a name, and no two may
/// give the same file.
fn check_names(spec: &Parsed<ConnectionSpec>, kinds: &[AnalysisKind]) -> Result<(), Diagnostics> {
    let loads = &spec.value.loads;
    let stems = |name: &str| -> Vec<String> {
        kinds.iter().enumerate().map(|(k, kind)| stem_of(name, *kind, k > 0)).collect()
    };
    for (i, load) in loads.iter().enumerate() {
        let (stem, mine) = (file_stem(&load.name), stems(&load.name));
        let clash =
            |o: &&LoadSpec| o.name != load.name && stems(&o.name).iter().any(|s| mine.contains(s));
        let other = loads[..i].iter().find(clash);
        let message = match other {
            Some(o) => format!(
                "the load cases `{}` and `{}` would write the same files `{stem}_…`",
                o.name, load.name
            ),
            None if stem.is_empty() => "the name of a load case is empty".to_string(),
            None => continue,
        };
        let mut d = Diagnostic::input("spec/value", message)
            .help("give each load case a name of letters and digits");
        d.place = spec.index.place(&format!("loads[{i}].name"));
        return Err(d.into());
    }
    Ok(())
}

/// Refuses a spec without load, and loads whose energy is beyond the range of numbers (1e300 MPa).
fn check_sizes(spec: &Parsed<ConnectionSpec>) -> Result<(), Diagnostics> {
    let refuse = |path: String, code, message: String, help: &str| {
        let mut d = Diagnostic::input(code, message).help(help);
        d.place = spec.index.place(&path);
        Err(d.into())
    };
    let loads = &spec.value.loads;
    for (i, load) in loads.iter().enumerate() {
        for Quantity { key, value, unit, sizes } in quantities(load) {
            let size = value.abs();
            if size != 0.0 && !limits::within(size, &sizes) {
                let [least, most] = [sizes.start(), sizes.end()].map(|s| format!("{s:e} {unit}"));
                let message = format!(
                    "`loads[{i}].{key}` is {value:e} {unit}; allowed: zero, or a size from \
                     {least} to {most}"
                );
                return refuse(
                    format!("loads[{i}].{key}"),
                    "spec/range",
                    message,
                    "check the number and its unit",
                );
            }
        }
    }
    // a case in which nothing acts has its answer beside others or as a demand, but a spec without
    // any load most likely lacks one
    let demand = loads.iter().any(|l| l.end.is_some());
    if !loads.is_empty() && !demand && loads.iter().flat_map(quantities).all(|q| q.value == 0.0) {
        return refuse(
            "loads".into(),
            "model/no-load",
            "nothing acts on the joint: every load is zero".into(),
            "give a load that is not zero",
        );
    }
    Ok(())
}

/// A number of a load with its permitted range. Energies are proportional to its square, so the
/// square must be finite too.
struct Quantity {
    key: &'static str,
    value: f64,
    unit: &'static str,
    sizes: std::ops::RangeInclusive<f64>,
}

/// The numbers of a load.
fn quantities(load: &LoadSpec) -> Vec<Quantity> {
    let stress = |key, value| Quantity { key, value, unit: "MPa", sizes: 1e-9..=1e9 };
    let mut out: Vec<Quantity> = load.pressure.iter().map(|p| stress("pressure", p.0)).collect();
    out.extend(load.traction.into_iter().flatten().map(|t| stress("traction", t.0)));
    out.extend(load.actions().into_iter().map(|(action, value)| match action.direction() {
        (_, false) => Quantity { key: action.word(), value, unit: "N", sizes: 1e-100..=1e12 },
        (_, true) => Quantity { key: action.word(), value, unit: "N mm", sizes: 1e-100..=1e15 },
    }));
    out
}
