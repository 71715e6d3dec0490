//! Compares a field file with the file that its own field gives: what is derived from the field
//! (von Mises stresses, utilisations, dissipation densities, bodies) must be what the field gives.

use super::case_files::CaseFiles;
use crate::result::fields::vtu::{Array, VtuGrid};
use bracket_base::diag::{Diagnostic, Diagnostics};

/// Difference allowed between two numbers of an array, over the largest of the array.
const SAME: f64 = 1e-9;

/// Name of the array of contributions to the gap.
const CONTRIBUTIONS: &str = "gap_contribution_N_mm";

impl CaseFiles<'_> {
    /// Compares the file of a field with the grid that the field gives. Contributions to the gap
    /// need the fields of both bounds on one mesh: where `found` has none they are as recorded.
    pub fn compare_grid(
        &self,
        kind: &str,
        found: &VtuGrid,
        refuted: &mut Vec<String>,
    ) -> Result<(), Diagnostics> {
        let mut stored = VtuGrid::from_bytes(&self.field(kind)?).map_err(Diagnostic::from)?;
        if found.cell_array(CONTRIBUTIONS).is_none() {
            stored.cell_data.retain(|a| a.0 != CONTRIBUTIONS);
        }
        let what = grid_difference(&stored, found);
        refuted.extend(what.map(|what| {
            format!(
                "{}: {what} of {}_{kind}.vtu is not what its field gives",
                self.case.name, self.stem
            )
        }));
        Ok(())
    }
}

/// What differs first between a stored and a recomputed grid.
fn grid_difference(stored: &VtuGrid, found: &VtuGrid) -> Option<String> {
    if stored.points != found.points {
        return Some("the list of points".into());
    }
    if stored.cell_type != found.cell_type || stored.cells != found.cells {
        return Some("the list of cells".into());
    }
    let groups = [
        (&stored.point_data, &found.point_data),
        (&stored.cell_data, &found.cell_data),
        (&stored.field_data, &found.field_data),
    ];
    groups.into_iter().find_map(|(stored, found)| arrays_difference(stored, found))
}

fn arrays_difference(stored: &[Array], found: &[Array]) -> Option<String> {
    if let Some(i) = (0..stored.len().max(found.len()))
        .find(|&i| stored.get(i).map(|a| (&a.0, a.1)) != found.get(i).map(|a| (&a.0, a.1)))
    {
        let name = stored.get(i).or(found.get(i)).map_or("", |a| a.0.as_str());
        return Some(format!("the presence of array `{name}`"));
    }
    let differs = |(a, b): &(&Array, &Array)| {
        let size = b.2.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let near = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME * size;
        a.2.len() != b.2.len() || !a.2.iter().zip(&b.2).all(near)
    };
    let pair = stored.iter().zip(found).find(differs)?;
    Some(format!("array `{}`", pair.0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::result::fields::vtu::TETRA;

    #[test]
    fn every_part_of_a_grid_is_compared() {
        let grid = VtuGrid {
            points: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            cells: vec![0, 1, 2, 3],
            cell_type: TETRA,
            point_data: vec![("u".into(), 1, vec![0.0, 1.0, 2.0, -3.0])],
            cell_data: vec![("body".into(), 1, vec![1.0])],
            field_data: vec![("load_factor".into(), 1, vec![2.0])],
        };
        assert_eq!(grid_difference(&grid, &grid), None);
        type Change = (&'static str, fn(&mut VtuGrid));
        let changes: [Change; 7] = [
            ("the list of points", |g| g.points[1][0] = 1.1),
            ("the list of cells", |g| g.cells.swap(0, 1)),
            ("array `u`", |g| g.point_data[0].2[0] = 1e-6),
            ("array `u`", |g| g.point_data[0].2[2] = f64::NAN),
            ("array `body`", |g| g.cell_data[0].2[0] = 0.0),
            ("array `load_factor`", |g| g.field_data[0].2[0] = 2.1),
            ("the presence of array `mine`", |g| g.cell_data.push(("mine".into(), 1, vec![0.0]))),
        ];
        for (words, change) in changes {
            let mut forged = grid.clone();
            change(&mut forged);
            assert_eq!(grid_difference(&forged, &grid).as_deref(), Some(words));
        }
    }
}
