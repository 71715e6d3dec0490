//! Names of the parts; a part consists of bodies tied together.

use crate::mesh::split::SplitMesh;
use std::collections::BTreeSet;

/// Names such as `PLATE+BEAM`; the pieces of a disconnected body are numbered: `BEAM#1`, `BEAM#2`.
pub(super) fn names(cut: &SplitMesh, notes: &mut Vec<String>) -> Vec<String> {
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
            notes.push(format!("the body `{name}` falls into {n} pieces that share no face"));
        }
    }
    names
}
