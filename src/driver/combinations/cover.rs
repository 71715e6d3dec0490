//! Load cases of one model that differ in their actions alone, and what the limit analyses that ran
//! prove of them.

use bracket_base::math::gauge::gauge;
use bracket_codes::verdict::Verdict;
use bracket_engine::certify::half_space::Actions;
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::file::{ModelFile, RigidEntry};
use bracket_report::result::case_result::CaseResult;
use bracket_report::result::derived_bounds::{Run, derived_case};
use bracket_report::result::proved_by::{ProvedBy, Weight};
use bracket_report::result::quantity::{FrictionModel, Quantity};

/// The actions of a model file on its rigid faces.
pub fn actions_of(file: &ModelFile) -> Actions {
    file.rigid.iter().map(RigidEntry::action).collect()
}

/// The model file with these actions.
pub fn with_actions(file: &ModelFile, actions: &[[f64; 6]]) -> ModelFile {
    let mut out = file.clone();
    for (rigid, [fx, fy, fz, mx, my, mz]) in out.rigid.iter_mut().zip(actions) {
        (rigid.force, rigid.moment) = ([*fx, *fy, *fz], [*mx, *my, *mz]);
    }
    out
}

/// Whether nothing but actions on rigid faces loads a model in limit analysis, all of them times
/// the load factor: what it carries is then convex and contains zero.
fn is_live(file: &ModelFile) -> bool {
    let mut dead = file.rigid.iter().flat_map(RigidEntry::dead_action);
    file.analysis == AnalysisKind::Limit
        && file.loads.is_empty()
        && file.dead.is_empty()
        && dead.all(|x| x == 0.0)
}

/// The cases in groups of equal models but for the actions, by their indices. A case that no other
/// one can bound is a group of its own.
pub fn groups(files: &[ModelFile]) -> Vec<Vec<usize>> {
    let mut out: Vec<(Option<ModelFile>, Vec<usize>)> = Vec::new();
    for (i, file) in files.iter().enumerate() {
        let bare = is_live(file).then(|| with_actions(file, &vec![[0.0; 6]; file.rigid.len()]));
        match out.iter_mut().find(|(of, _)| bare.is_some() && *of == bare) {
            Some((_, group)) => group.push(i),
            None => out.push((bare, vec![i])),
        }
    }
    out.into_iter().map(|(_, group)| group).collect()
}

/// The entry of a load case of which nothing is known.
fn without_bounds(name: &str) -> CaseResult {
    let of = (Quantity::LoadFactor, FrictionModel::Frictionless);
    let proved_by = Some(ProvedBy::default());
    CaseResult { proved_by, ..CaseResult::empty(name, AnalysisKind::Limit, of) }
}

/// A group of load cases with the analyses that ran.
pub struct Cover {
    /// Name and actions of each case.
    cases: Vec<(String, Actions)>,
    /// The largest force and the largest moment on each face \[N, N mm\]; 1 where there is none.
    scales: Vec<[f64; 2]>,
    /// The analyses that ran.
    pub runs: Vec<Run>,
}

impl Cover {
    /// The cases before any analysis.
    pub fn new(cases: Vec<(String, Actions)>) -> Self {
        let faces = cases.first().map_or(0, |(_, a)| a.len());
        let largest = |face: usize, kind: std::ops::Range<usize>| {
            let all = cases.iter().flat_map(|(_, a)| &a[face][kind.clone()]);
            let most = all.fold(0.0f64, |m, x| m.max(x.abs()));
            if most > 0.0 { most } else { 1.0 }
        };
        let scales = (0..faces).map(|f| [largest(f, 0..3), largest(f, 3..6)]).collect();
        Self { cases, scales, runs: Vec::new() }
    }

    /// Number of cases.
    pub fn len(&self) -> usize {
        self.cases.len()
    }

    /// Name of a case.
    pub fn name(&self, case: usize) -> &str {
        &self.cases[case].0
    }

    /// The actions of a case.
    pub fn actions(&self, case: usize) -> &Actions {
        &self.cases[case].1
    }

    /// Actions as coordinates near 1.
    pub fn scaled(&self, actions: &[[f64; 6]]) -> Vec<f64> {
        let face = |(a, s): (&[f64; 6], &[f64; 2])| {
            let (a, s) = (*a, *s);
            (0..6).map(move |k| a[k] / s[k / 3])
        };
        actions.iter().zip(&self.scales).flat_map(face).collect()
    }

    /// Actions of scaled coordinates.
    pub fn unscaled(&self, point: &[f64]) -> Actions {
        let face = |(p, s): (&[f64], &[f64; 2])| std::array::from_fn(|k| p[k] * s[k / 3]);
        point.chunks_exact(6).zip(&self.scales).map(face).collect()
    }

    /// True if a case has an analysis of its own.
    pub fn has_run(&self, case: usize) -> bool {
        self.runs.iter().any(|r| r.entry.name == self.cases[case].0)
    }

    /// What the analyses prove of a case.
    pub fn derive(&self, case: usize) -> CaseResult {
        let (name, actions) = &self.cases[case];
        let carried: Vec<(&Run, f64)> =
            self.runs.iter().filter_map(|r| Some((r, r.lower().filter(|l| *l > 0.0)?))).collect();
        let points: Vec<Vec<f64>> = carried
            .iter()
            .map(|(r, factor)| self.scaled(&r.actions).iter().map(|x| factor * x).collect())
            .collect();
        let weights = gauge(&points, &self.scaled(actions)).unwrap_or_default();
        let of = |((r, _), weight): (&(&Run, f64), f64)| Weight {
            analysis: r.entry.name.clone(),
            weight,
        };
        let lower = carried.iter().zip(weights).filter(|(_, w)| *w > 0.0).map(of).collect();
        let bounds =
            self.runs.iter().filter_map(|r| Some((r, r.half_space.as_ref()?.factor(actions)?)));
        let least = bounds.min_by(|a, b| a.1.total_cmp(&b.1));
        let upper = least.map(|(r, _)| r.entry.name.clone());
        let with = |lower| {
            derived_case(name, actions, ProvedBy { lower, upper: upper.clone() }, &self.runs)
        };
        // weights that are right to rounding only in the scaled coordinates prove nothing
        with(lower).or_else(|| with(Vec::new())).unwrap_or_else(|| without_bounds(name))
    }

    /// The cases without an analysis of their own that the analyses do not decide.
    pub fn open(&self) -> Vec<usize> {
        let undecided = |i: &usize| self.derive(*i).by_bounds() == Verdict::Undecided;
        (0..self.cases.len()).filter(|i| !self.has_run(*i)).filter(undecided).collect()
    }
}
