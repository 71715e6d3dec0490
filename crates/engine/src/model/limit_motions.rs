//! The motions of the resultant limits of a model, and the jumps of its cuts under them.

use crate::model::analysis::{AnalysisModel, Cut, FacePair};
use crate::model::resultant_limit::ResultantLimit;
use bracket_base::math::vec3::{self, V3};

impl AnalysisModel {
    /// A resultant limit over the area of its largest cut, an order of magnitude \[MPa\].
    pub fn mean_strength(&self, limit: &ResultantLimit) -> f64 {
        let area = |cut: &Cut| -> f64 {
            let corners = |f: &FacePair| f.nodes_a.map(|n| self.mesh.nodes[n as usize]);
            cut.faces.iter().map(|f| vec3::norm(vec3::area_vector(&corners(f)))).sum()
        };
        let factor = limit.rows().map(|r| vec3::norm(*r)).fold(0.0, f64::max);
        let cuts = limit.cuts.iter().map(|c| area(&self.cuts[c.0]));
        limit.at_most / (factor * cuts.fold(0.0, f64::max))
    }

    /// Number of unknowns of the motions of all resultant limits.
    pub fn limit_motions(&self) -> usize {
        self.resultant_limits.iter().map(ResultantLimit::motions).sum()
    }

    /// Each resultant limit with its part of the motions, given limit by limit.
    pub fn motions_of_limits<'a>(
        &'a self,
        motions: &'a [f64],
    ) -> impl Iterator<Item = (&'a ResultantLimit, &'a [f64])> {
        let mut rest = motions;
        self.resultant_limits.iter().map(move |limit| {
            let (mine, others) = rest.split_at(limit.motions());
            rest = others;
            (limit, mine)
        })
    }

    /// The jump δ of each cut under the motions of all limits \[mm\].
    pub fn cut_jumps(&self, motions: &[f64]) -> Vec<V3> {
        let mut jumps = vec![[0.0; 3]; self.cuts.len()];
        for (limit, motion) in self.motions_of_limits(motions) {
            let jump = limit.jump(motion);
            for &(cut, sign) in &limit.cuts {
                jumps[cut] = vec3::along(jumps[cut], sign, jump);
            }
        }
        jumps
    }
}
