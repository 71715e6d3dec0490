//! The history of a case: the rows that prove its bounds, and the others, which may claim nothing
//! that the answer does not have.

use crate::result::history::{HistoryRow, SoFar};
use crate::result::quantity::{FrictionModel, Quantity, Upper};
use crate::result::result_file::CaseResult;
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::file::Bounds;
use bracket_engine::programs::{Kinematic, Static};

/// Tetrahedra of a mesh and unknowns of the programs on it.
pub struct MeshSizes {
    tets: usize,
    kinematic: Option<usize>,
    statics: Option<usize>,
}

impl MeshSizes {
    /// The sizes of a model; no unknowns where a program cannot be made of it.
    pub fn of(model: &AnalysisModel) -> Self {
        let limit = model.analysis == AnalysisKind::Limit;
        Self {
            tets: model.mesh.tets.len(),
            kinematic: Kinematic::unknowns(model, limit).ok(),
            statics: Static::unknowns(model, limit).ok(),
        }
    }

    /// True if a row of the history is of a mesh of these sizes.
    fn fit(&self, row: &HistoryRow) -> bool {
        row.macro_tets == self.tets
            && row.kinematic_dofs.is_none_or(|n| Some(n) == self.kinematic)
            && row.static_dofs.is_none_or(|n| Some(n) == self.statics)
    }
}

fn near(a: Option<f64>, b: Option<f64>) -> bool {
    match (a, b) {
        // infinities and NaN never agree
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()),
        (a, b) => a.is_none() && b.is_none(),
    }
}

/// True if two relative gaps agree; the difference of two bounds has fewer digits than they.
pub fn near_gap(a: Option<f64>, b: Option<f64>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) + 1e-13,
        (a, b) => a.is_none() && b.is_none(),
    }
}

fn near_upper(a: Option<Upper>, b: Option<Upper>) -> bool {
    match (a, b) {
        (Some(Upper::Finite(a)), Some(Upper::Finite(b))) => near(Some(a), Some(b)),
        (a, b) => a == b,
    }
}

/// A claimed history and what is known about the case.
struct History<'a> {
    claimed: &'a CaseResult,
    /// The entry that the fields give.
    found: &'a CaseResult,
    strict: bool,
    /// Every mesh has its own problem, so that both bounds are from one of them.
    apart: bool,
    preloaded: bool,
}

/// Sentences about the history of a case. `sizes`: of the mesh of the upper bound, and of that of
/// the lower bound where it is another one; `bounds`: those that the model asks for.
pub fn history_differences(
    claimed: &CaseResult,
    found: &CaseResult,
    (upper, lower): (&MeshSizes, Option<&MeshSizes>),
    bounds: Bounds,
) -> Vec<String> {
    let preloaded = !claimed.preload.is_empty();
    let history = History {
        claimed,
        found,
        strict: found.is_strict(),
        apart: preloaded || found.problem == FrictionModel::ShiftedCones,
        preloaded,
    };
    let mut out = Vec::new();
    if !history.proved_by_rows(upper, lower) {
        out.push("no row of history has the bounds and the sizes of their mesh".to_owned());
    }
    for (i, row) in claimed.history.iter().enumerate() {
        let faults = [
            history.gap_fault(row),
            history.so_far_fault(i),
            history.run_fault(i, bounds),
            history.repeats(i).then_some("the mesh and its bounds stand in an earlier row"),
        ];
        out.extend(faults.into_iter().flatten().map(|what| format!("history[{i}]: {what}")));
    }
    if !history.frictionless_ran() {
        out.push("no row of history has the program behind the bound without friction".to_owned());
    }
    let best = claimed.history.len().checked_sub(1).map(|last| history.best(last));
    let as_found = |b: &SoFar| near(b.lower, found.lower) && near_upper(b.upper, found.upper);
    if !best.as_ref().is_some_and(as_found) {
        out.push("the best bounds of history are not those of the answer".to_owned());
    }
    out.into_iter().map(|what| format!("{}: {what}", claimed.name)).collect()
}

impl History<'_> {
    /// True if a row has the bounds that the fields prove and the sizes of their meshes.
    fn proved_by_rows(&self, upper: &MeshSizes, lower: Option<&MeshSizes>) -> bool {
        let mut rows = self.claimed.history.iter();
        let of_upper = |r: &HistoryRow| near_upper(r.upper, self.found.upper) && upper.fit(r);
        let of_lower =
            |r: &HistoryRow, on: &MeshSizes| near(r.lower, self.found.lower) && on.fit(r);
        match lower {
            None => {
                rows.any(|r| of_upper(r) && of_lower(r, upper) && near_gap(r.gap, self.found.gap))
            }
            Some(on) => rows.clone().any(of_upper) && rows.any(|r| of_lower(r, on)),
        }
    }

    /// The gap of two bounds; `None` where it is infinite.
    fn gap(&self, lower: f64, upper: f64) -> Option<f64> {
        match self.found.quantity {
            Quantity::LoadFactor => (lower > 0.0).then(|| (upper - lower) / lower),
            Quantity::PotentialEnergy => {
                let scale = if lower == 0.0 { upper.abs() } else { lower.abs() };
                Some(if scale > 0.0 { (upper - lower) / scale } else { 0.0 })
            }
        }
    }

    /// The gap of a row is that of its bounds. With preload it needs the strain energy of a mesh
    /// that is not stored.
    fn gap_fault(&self, row: &HistoryRow) -> Option<&'static str> {
        let agrees = match (row.lower, row.upper.and_then(Upper::finite)) {
            (Some(_), Some(_)) if self.preloaded => row.gap.is_some(),
            (Some(l), Some(u)) => near_gap(row.gap, self.gap(l, u)),
            _ => row.gap.is_none(),
        };
        (!agrees).then_some("the gap is not that of the bounds")
    }

    /// The best bounds of the rows up to `last`, joined as those of the answer.
    fn best(&self, last: usize) -> SoFar {
        let rows = &self.claimed.history[..=last];
        let has_bound = |r: &HistoryRow| r.lower.is_some() || r.upper.is_some();
        let strict = self.strict && rows.iter().any(has_bound);
        if self.apart {
            let gaps = rows.iter().filter(|r| r.gap.is_some());
            let narrowest = gaps.reduce(|a, b| if b.gap < a.gap { b } else { a });
            let bounded = rows.iter().rfind(|r| has_bound(r));
            let row = narrowest.or(bounded).unwrap_or(&rows[last]);
            return SoFar { lower: row.lower, upper: row.upper, gap: row.gap, strict };
        }
        let lower = rows.iter().filter_map(|r| r.lower).reduce(f64::max);
        let finite = rows.iter().filter_map(|r| r.upper?.finite()).reduce(f64::min);
        let unbounded = rows.iter().find_map(|r| r.upper);
        let gap = lower.zip(finite).and_then(|(l, u)| self.gap(l, u));
        SoFar { lower, upper: finite.map(Upper::Finite).or(unbounded), gap, strict }
    }

    /// The best bounds so far are those of the rows so far. Where none of them is a bound of a
    /// strict result, they are estimates and say so.
    fn so_far_fault(&self, i: usize) -> Option<&'static str> {
        let Some(claimed) = &self.claimed.history[i].so_far else {
            return Some("so_far is missing");
        };
        let best = self.best(i);
        let estimate = self.strict && best.lower.is_none() && best.upper.is_none();
        let agrees = claimed.strict == best.strict
            && (estimate
                || near(claimed.lower, best.lower)
                    && near_upper(claimed.upper, best.upper)
                    && near_gap(claimed.gap, best.gap));
        (!agrees).then_some("so_far does not have the best bounds of the rows so far")
    }

    /// True if an earlier row has the mesh and the bounds of row `i`. No mesh is solved twice, and
    /// two meshes with the same number of tetrahedra do not have the same digits. Bounds of zero
    /// and without limit do not depend on the mesh.
    fn repeats(&self, i: usize) -> bool {
        let rows = &self.claimed.history;
        let row = &rows[i];
        let finite = row.upper.and_then(Upper::finite);
        let of_mesh = [row.lower, finite].into_iter().flatten().any(|bound| bound != 0.0);
        let same = |r: &HistoryRow| {
            (r.macro_tets, r.lower, r.upper) == (row.macro_tets, row.lower, row.upper)
        };
        of_mesh && rows[..i].iter().any(same)
    }

    /// True if a row has the program that proves the bound without friction. A load factor of zero
    /// needs none.
    fn frictionless_ran(&self) -> bool {
        let lower = self.found.frictionless.and_then(|f| f.lower);
        let mut rows = self.claimed.history.iter();
        lower.is_none_or(|l| l == 0.0) || rows.any(|r| r.static_frictionless.is_some())
    }

    /// True if a mesh after the first served the estimates of a verdict by analysis alone: they
    /// need no stress on it.
    fn is_for_estimates(&self, i: usize) -> bool {
        let row = &self.claimed.history[i];
        let mut before = self.claimed.evidence_before.iter();
        i > 0 && row.lower.is_none() && before.any(|e| e.tets == row.macro_tets)
    }

    /// The programs whose bounds are asked for have run: whether a result is certified depends on
    /// the programs without a bound too.
    fn run_fault(&self, i: usize, bounds: Bounds) -> Option<&'static str> {
        let row = &self.claimed.history[i];
        let energy = self.found.quantity == Quantity::PotentialEnergy;
        let finite = row.upper.and_then(Upper::finite);
        let shifted = self.found.problem == FrictionModel::ShiftedCones;
        // a load factor of zero or without limit is proved without any program
        let kinematic = match energy {
            true => bounds != Bounds::Static || shifted,
            false => finite.is_some_and(|u| u != 0.0),
        };
        let statics = match energy {
            // the static program solves the last problem of the fixed point, if there is one
            true => {
                let solved = !shifted || finite.is_some();
                bounds != Bounds::Kinematic && solved && !self.is_for_estimates(i)
            }
            false => row.lower.is_some_and(|l| l != 0.0),
        };
        let coulomb = self.found.problem == FrictionModel::Coulomb;
        let smooth = coulomb && row.static_frictionless.is_some();
        let ran = [row.kinematic.is_some(), row.static_.is_some() || smooth];
        let of_both = i == 0 && !energy && bounds == Bounds::Both && (ran[0] || ran[1]);
        if (kinematic || of_both) && !ran[0] || (statics || of_both) && !ran[1] {
            return Some("a program that the model asks for has no run");
        }
        let dofs = [row.kinematic_dofs.is_some(), row.static_dofs.is_some()];
        (dofs != ran).then_some("the unknowns are not those of the programs")
    }
}
