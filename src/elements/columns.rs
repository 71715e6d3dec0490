//! The columns of an element that yields: which unknowns of a program it works on.

/// Full unknowns of an element in the program's unknowns.
pub struct Columns {
    /// The program's unknowns; `NONE`: held.
    pub unknowns: Vec<u32>,
    /// For each full unknown its terms: position in `unknowns`, factor. `None`: full unknowns and
    /// columns are the same.
    pub terms: Option<Vec<Vec<(usize, f64)>>>,
}

impl Columns {
    /// A row on the full unknowns, in the columns.
    pub fn row(&self, full: &[f64]) -> Vec<f64> {
        let Some(terms) = &self.terms else { return full.to_vec() };
        let mut out = vec![0.0; self.unknowns.len()];
        for (value, terms) in full.iter().zip(terms) {
            terms.iter().for_each(|&(at, c)| out[at] += c * value);
        }
        out
    }
}
