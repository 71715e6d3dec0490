//! A model whose welds of finite strength never yield.

use crate::model::analysis::{AnalysisModel, FreeMode, Tie, Weld};

impl AnalysisModel {
    /// The same model with ties in place of its welds: both sides move together, and bodies that
    /// are welded together are one part.
    pub fn with_welds_tied(&self) -> Self {
        let mut tied = self.clone();
        let as_tie = |w: Weld| Tie { name: w.name, strength: w.strength, faces: w.faces };
        tied.ties.extend(std::mem::take(&mut tied.welds).into_iter().map(as_tie));
        let mut root: Vec<usize> = (0..self.parts.len()).collect();
        for (_, face) in self.weld_faces() {
            let [a, b] = [face.a, face.b].map(|f| root[self.tet_part[f.tet as usize] as usize]);
            root.iter_mut().filter(|r| **r == a.max(b)).for_each(|r| *r = a.min(b));
        }
        let kept: Vec<usize> = (0..root.len()).filter(|&p| root[p] == p).collect();
        let place = |part: usize| kept.partition_point(|k| *k < root[part]);
        tied.tet_part.iter_mut().for_each(|p| *p = place(*p as usize) as u32);
        tied.parts = vec![String::new(); kept.len()];
        for (part, name) in self.parts.iter().enumerate() {
            let joined = &mut tied.parts[place(part)];
            let plus = if joined.is_empty() { "" } else { "+" };
            *joined = format!("{joined}{plus}{name}");
        }
        let of_kept =
            |mode: &FreeMode| FreeMode { motions: kept.iter().map(|&p| mode.motions[p]).collect() };
        tied.free_modes = self.free_modes.iter().map(of_kept).collect();
        tied
    }
}
