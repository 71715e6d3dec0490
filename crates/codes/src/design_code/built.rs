//! Builds the joint of a spec by the design code that the spec names.

use super::values::values;
use bracket_base::diag::Diagnostics;
use bracket_base::yaml::Parsed;
use bracket_joint::assembly::{self, Joint, LoadedTemplate};
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::connection::ConnectionSpec;
use std::path::Path;

/// Builds the joint that a spec describes. `base` is the folder of the spec, from which template
/// paths are resolved.
pub fn build(
    spec: &Parsed<ConnectionSpec>,
    base: &Path,
    catalog: &Catalog,
) -> Result<Joint, Diagnostics> {
    assembly::build(spec, base, catalog, values(&spec.value, catalog))
}

/// Builds the joint that a spec describes from its template.
pub fn build_from(
    spec: &Parsed<ConnectionSpec>,
    template: &LoadedTemplate,
    catalog: &Catalog,
) -> Result<Joint, Diagnostics> {
    assembly::build_from(spec, template, catalog, values(&spec.value, catalog))
}
