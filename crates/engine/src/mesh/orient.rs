//! Orients the tets of a mesh alike by their common faces, whatever their volumes. A flat or
//! inverted tet has no orientation of its own.

use super::TetMesh;
use super::topology::FaceTable;

/// Turns tets (swaps two nodes) until any two with a common face lie on opposite sides of it and
/// each connected part has a positive volume. Returns the number of tets turned, or two tets that
/// contradict each other: they overlap, or more than two meet at a face.
pub fn alike(mesh: &mut TetMesh) -> Result<usize, [u32; 2]> {
    let table = FaceTable::new(&mesh.tets);
    // neighbours, and whether one of both has to be turned
    let mut beside: Vec<Vec<(u32, bool)>> = vec![Vec::new(); mesh.tets.len()];
    for rows in table.faces() {
        match rows {
            [_] => {}
            [p, q] => {
                let turn = p.even == q.even;
                beside[p.tet as usize].push((q.tet, turn));
                beside[q.tet as usize].push((p.tet, turn));
            }
            _ => return Err([rows[0].tet, rows[rows.len() - 1].tet]),
        }
    }
    let mut turned: Vec<Option<bool>> = vec![None; mesh.tets.len()];
    let mut count = 0;
    for start in 0..mesh.tets.len() {
        if turned[start].is_some() {
            continue;
        }
        turned[start] = Some(false);
        let mut part = vec![start as u32];
        let (mut seen, mut volume) = (0, 0.0);
        while let Some(&e) = part.get(seen) {
            seen += 1;
            let own = turned[e as usize] == Some(true);
            volume += if own { -mesh.volume(e as usize) } else { mesh.volume(e as usize) };
            for (other, turn) in &beside[e as usize] {
                match turned[*other as usize] {
                    None => {
                        turned[*other as usize] = Some(own != *turn);
                        part.push(*other);
                    }
                    Some(found) if found != (own != *turn) => return Err([e, *other]),
                    Some(_) => {}
                }
            }
        }
        for e in part {
            if (turned[e as usize] == Some(true)) != (volume < 0.0) {
                mesh.tets[e as usize].swap(2, 3);
                count += 1;
            }
        }
    }
    Ok(count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::fixtures::cubes;

    /// Tets of any orientation, one of them flat: all are oriented alike, and the flat one has the
    /// side that its neighbours leave to it.
    #[test]
    fn flat_tets_take_the_side_that_their_neighbours_leave() {
        let right = cubes(&[([0, 0, 0], "A"), ([1, 0, 0], "A"), ([0, 1, 0], "B")]);
        let mut mesh = right.clone();
        (0..mesh.tets.len()).step_by(3).for_each(|e| mesh.tets[e].swap(2, 3));
        assert_eq!(alike(&mut mesh), Ok(6));
        assert!((0..mesh.tets.len()).all(|e| mesh.volume(e) > 0.0));
        // a common node of all tets of the first cube moves into one of their faces
        let [a, b, c, d] = right.tets[0];
        let x = [b, c, d].map(|n| right.nodes[n as usize]);
        mesh.nodes[a as usize] = std::array::from_fn(|k| (x[0][k] + x[1][k] + x[2][k]) / 3.0);
        mesh.tets[0].swap(2, 3);
        assert_eq!(alike(&mut mesh), Ok(1));
        let even = |m: &TetMesh| {
            let table = FaceTable::new(&m.tets);
            let mut all: Vec<_> = table.faces().map(|r| (r[0].key, r[0].even)).collect();
            all.sort_unstable();
            all
        };
        assert_eq!(even(&mesh), even(&right));
    }

    #[test]
    fn overlapping_tets_contradict_each_other() {
        let mut mesh = cubes(&[([0, 0, 0], "A")]);
        let tet = mesh.tets[0];
        mesh.nodes.push([3.0, 3.0, 3.0]);
        mesh.tets.push([tet[0], tet[1], tet[2], 8]);
        mesh.tets.push([tet[0], tet[1], tet[3], 8]);
        mesh.tet_body.extend([0, 0]);
        assert!(alike(&mut mesh).is_err());
    }
}
