//! Faults of a model file, collected with their places.

use bracket_base::diag::{Diagnostic, Diagnostics, Place};

/// The faults found so far.
pub(super) struct Faults<'a> {
    /// Place of a path such as `supports[1].face` in the file.
    place: &'a dyn Fn(&str) -> Place,
    all: Vec<Diagnostic>,
}

impl<'a> Faults<'a> {
    /// No faults yet.
    pub fn new(place: &'a dyn Fn(&str) -> Place) -> Self {
        Self { place, all: Vec::new() }
    }

    /// Adds a fault of the value at `path`.
    pub fn add(
        &mut self,
        code: &'static str,
        path: &str,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        let mut d = Diagnostic::input(code, message).help(help);
        d.place = (self.place)(path);
        self.all.push(d);
    }

    /// All faults as an error, if there are any.
    pub fn into_result(self) -> Result<(), Diagnostics> {
        Diagnostics::refuse(self.all)
    }
}
