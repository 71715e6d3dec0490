//! The cases of a plan that one process does.

use super::case::Case;
use super::choice::{Group, groups};
use super::forecast::seconds;
use super::plan::Plan;
use super::screen::Kit;
use super::shard::Shard;

/// A part of a sweep: a shard of its cases, divided by their forecast times.
#[derive(Clone, Debug)]
pub struct Part {
    shard: Shard,
    /// Forecast of each case of the plan \[s\].
    seconds: Vec<f64>,
    /// The groups of which it chooses joints; none where nothing is chosen.
    pub groups: Vec<Group>,
}

impl Part {
    /// The part of a plan that a shard does.
    pub fn new(plan: &Plan, kit: &Kit, shard: Shard) -> Self {
        let seconds = seconds(plan, kit);
        let mut all = plan.header.choose.as_ref().map_or_else(Vec::new, |c| groups(plan, c));
        let of_group = |g: &Group| g.cases.iter().map(|i| seconds[*i]).sum();
        let own = shard.of(&all.iter().map(of_group).collect::<Vec<f64>>());
        let groups = own.into_iter().map(|i| std::mem::take(&mut all[i])).collect();
        Self { shard, seconds, groups }
    }

    /// Positions of its runs among the runs of all cases.
    pub fn runs(&self, runs: &[&[Case]]) -> Vec<usize> {
        let mut from = 0;
        let of_run = |run: &&[Case]| {
            let to = from + run.len();
            let sum = self.seconds[from..to].iter().sum();
            from = to;
            sum
        };
        self.shard.of(&runs.iter().map(of_run).collect::<Vec<f64>>())
    }
}
