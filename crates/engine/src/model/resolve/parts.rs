//! The parts and their names; a part consists of bodies tied together.

use crate::mesh::split::{OpenPair, SplitMesh};
use bracket_base::say;
use bracket_base::words::Text;
use std::collections::BTreeSet;

/// Joins the two sides of faces to one part again: the halves of a bolt at its preloaded cut, whose
/// relative motion is only the closure, and bodies tied together.
pub(super) fn join<'a>(split: &mut SplitMesh, pairs: impl Iterator<Item = &'a OpenPair>) {
    for p in pairs {
        let [a, b] = [p.a, p.b].map(|f| split.tet_part[f.tet as usize]);
        if a != b {
            split.tet_part.iter_mut().filter(|t| **t == a.max(b)).for_each(|t| *t = a.min(b));
        }
    }
    // consecutive numbers, in the order of the first tets as before
    let mut used = split.tet_part.clone();
    used.sort_unstable();
    used.dedup();
    split.tet_part.iter_mut().for_each(|t| *t = used.partition_point(|part| part < t) as u32);
    split.parts = used.len();
}

/// Names such as `PLATE+BEAM`; the pieces of a disconnected body are numbered: `BEAM#1`, `BEAM#2`.
pub(super) fn names(cut: &SplitMesh, notes: &mut Vec<Text>) -> Vec<String> {
    let mut bodies: Vec<BTreeSet<u32>> = vec![BTreeSet::new(); cut.parts];
    for (part, body) in cut.tet_part.iter().zip(&cut.mesh.tet_body) {
        bodies[*part as usize].insert(*body);
    }
    let mut pieces = vec![0; cut.mesh.bodies.len()];
    bodies.iter().flatten().for_each(|b| pieces[*b as usize] += 1);
    let mut seen = vec![0; cut.mesh.bodies.len()];
    let names = bodies
        .iter()
        .map(|part| {
            let words: Vec<String> = part
                .iter()
                .map(|b| {
                    let b = *b as usize;
                    seen[b] += 1;
                    let name = &cut.mesh.bodies[b];
                    if pieces[b] > 1 { format!("{name}#{}", seen[b]) } else { name.clone() }
                })
                .collect();
            words.join("+")
        })
        .collect();
    for (name, n) in cut.mesh.bodies.iter().zip(&pieces) {
        if *n > 1 {
            notes.push(say!("the body `{}` falls into {} pieces that share no face", name, *n));
        }
    }
    names
}
