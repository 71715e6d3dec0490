//! The mechanism that the multipliers of a static program of limit analysis describe.

use crate::elements::yielding_element::{NONE, YIELD_ROWS};
use crate::programs::static_form::Static;
use bracket_base::math::vec3::V3;

impl Static<'_> {
    /// Share of each tet in the optimal value, carried by the multipliers z of its yield
    /// conditions: the multipliers are plastic strains or velocities, and the share is their
    /// dissipation. Zero in bodies that never yield.
    ///
    /// # Units
    /// Those of the objective. In limit analysis of proportional loads the shares of tets and welds
    /// add up to the load factor.
    pub fn yield_shares(&self, z: &[f64]) -> Vec<f64> {
        let mut shares = vec![0.0; self.elements.model().mesh.tets.len()];
        for batch in self.program.elements.batches.iter() {
            let rows = YIELD_ROWS * batch.shape.points();
            for (own, first) in
                batch.own.into_iter().zip(batch.rows).filter(|(own, _)| *own != NONE)
            {
                // a tet without own unknowns has the same first unknown as the next tet that has
                // some; welds follow the tets
                let e = self.own.partition_point(|start| *start <= own as usize) - 1;
                if let Some(share) = shares.get_mut(e) {
                    let first = first as usize;
                    *share = (first..first + rows).map(|r| self.program.h[r] * z[r]).sum();
                }
            }
        }
        shares
    }

    /// Velocities (in limit analysis; otherwise displacements) of the vertices of the mesh, from
    /// the unknowns of a program: the multipliers of the equilibrium of tractions, averaged over
    /// the faces at a vertex. Their sign and scale have no meaning.
    pub fn vertex_velocities(&self, x: &[f64]) -> Vec<V3> {
        let v = self.map.expand(x);
        let mut sum = vec![([0.0; 3], 0.0); self.elements.model().mesh.nodes.len()];
        for (nodes, v) in self.elements.faces.nodes.iter().zip(v.chunks_exact(9)) {
            for (n, v) in nodes.iter().zip(v.chunks_exact(3)) {
                let (total, count) = &mut sum[*n as usize];
                (0..3).for_each(|c| total[c] += v[c]);
                *count += 1.0;
            }
        }
        sum.into_iter().map(|(total, count)| total.map(|x| x / f64::max(count, 1.0))).collect()
    }
}
