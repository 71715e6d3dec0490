//! The columns of a yielding element: the unknowns of the program that it couples.

/// Full unknowns of an element as combinations of the program's unknowns.
pub struct Columns {
    /// The program's unknowns; `NONE`: held.
    pub unknowns: Vec<u32>,
    /// Terms of each full unknown: position in `unknowns`, and factor. `None`: the full unknowns
    /// are the columns.
    pub terms: Option<Vec<Vec<(usize, f64)>>>,
}

impl Columns {
    /// A row on the full unknowns, transformed to a row on the columns.
    pub fn row(&self, full: &[f64]) -> Vec<f64> {
        let Some(terms) = &self.terms else { return full.to_vec() };
        let mut out = vec![0.0; self.unknowns.len()];
        for (value, terms) in full.iter().zip(terms) {
            terms.iter().for_each(|&(at, c)| out[at] += c * value);
        }
        out
    }
}
