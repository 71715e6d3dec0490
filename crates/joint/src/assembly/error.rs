//! Faults found while a spec is turned into an assembly.

use crate::catalog::CatalogError;
use crate::spec::expr::ExprError;
use bracket_base::diag::Diagnostic;
use bracket_base::later;
use bracket_base::yaml::PlaceIndex;

/// A fault of a spec, or of a template.
#[derive(Debug, thiserror::Error)]
pub enum AssemblyError {
    /// A required value is absent.
    #[error("`{path}` is missing: {about}")]
    Missing {
        /// Path in the spec.
        path: String,
        /// Description of the value.
        about: String,
    },
    /// A name that the template does not contain.
    #[error("{problem}")]
    Unknown {
        /// Path in the spec.
        path: String,
        /// The unknown name, the place that does not know it, and the nearest known name.
        problem: String,
        /// The known names.
        known: String,
    },
    /// A value of the wrong kind or unit.
    #[error("`{path}`: {problem}")]
    Value {
        /// Path in the spec.
        path: String,
        /// Description of the fault.
        problem: String,
        /// Value or form to write instead.
        help: String,
    },
    /// A value outside its range.
    #[error("`{name}` is {value}; allowed: {range}")]
    OutOfRange {
        /// Path in the spec.
        path: String,
        /// Name of the parameter.
        name: String,
        /// Its value.
        value: String,
        /// Allowed range.
        range: String,
    },
    /// A default outside its range, because of a value that the spec gives.
    #[error("{problem}")]
    DefaultOutOfRange {
        /// Path in the spec of a value that default or range follow from, or of the parameter.
        path: String,
        /// Path of the parameter itself.
        own: String,
        /// The value and its default, the range, and the given values that both follow from.
        problem: String,
        /// Allowed range.
        range: String,
    },
    /// A name that the catalogue does not contain, or a value that it cannot give.
    #[error("{cause}")]
    Catalog {
        /// Path in the spec.
        path: String,
        /// Error of the catalogue.
        cause: Box<CatalogError>,
    },
    /// A condition of the template does not hold.
    #[error("{message}")]
    Rule {
        /// Path in the spec.
        path: String,
        /// Message of the template.
        message: String,
        /// Remedy given by the template.
        help: String,
    },
    /// A fault of the template itself, in one of its expressions.
    #[error("the template is wrong at `{at}`: {cause}")]
    Template {
        /// Entry of the template.
        at: String,
        /// Fault of the expression.
        cause: ExprError,
    },
    /// A fault of the template itself, outside its expressions.
    #[error("the template is wrong at `{at}`: {problem}")]
    TemplateEntry {
        /// Entry of the template.
        at: String,
        /// Description of the fault.
        problem: String,
    },
    /// A fillet weld of a steel for which the code has no correlation factor.
    #[error(
        "{what} of {grade}, for which EN 1993-1-8 Table 4.1 has no β_w: no analysis can give them \
         a strength"
    )]
    NoWeldStrength {
        /// Path in the spec.
        path: String,
        /// The parameter with the throat, in words.
        what: String,
        /// Grade of the weaker part joined.
        grade: String,
    },
    /// The bolts of the geometry differ from those of `hand_checks`.
    #[error("`{at}` of the template is not what is meshed: {problem}")]
    UnseenBolts {
        /// Entry of the template.
        at: String,
        /// The numbers of bolts on both sides.
        problem: String,
        /// Text to write instead.
        help: String,
    },
}

/// Error for a name that a template does not contain; `noun` is the kind of name.
pub(super) fn unknown_in(
    template: &str,
    path: String,
    noun: &'static str,
    name: &str,
    hint: String,
    known: String,
) -> AssemblyError {
    let problem = format!("template `{template}` has no {noun} `{name}`{hint}");
    AssemblyError::Unknown { path, problem, known }
}

/// The known names for a help line, or `nothing` if there are none.
pub(super) fn known_names<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let all: Vec<&str> = names.collect();
    if all.is_empty() { "nothing".to_owned() } else { all.join(", ") }
}

impl AssemblyError {
    /// The diagnostic, with its place in the spec.
    pub fn placed(self, index: &PlaceIndex) -> Diagnostic {
        let d = Diagnostic::from(self);
        match &d.place.path {
            Some(path) => {
                let place = index.place(path);
                Diagnostic { place, ..d }
            }
            None => d,
        }
    }
}

impl From<AssemblyError> for Diagnostic {
    fn from(error: AssemblyError) -> Self {
        let message = error.to_string();
        match error {
            AssemblyError::Missing { path, .. } => {
                let key = path.rsplit('.').next().unwrap_or(&path).to_owned();
                Diagnostic::input("spec/missing", message)
                    .help(format!(
                        "add `{key}: …` there; `bracket new` writes a starter with every parameter"
                    ))
                    .path(path)
            }
            AssemblyError::Unknown { path, known, .. } => {
                let name = path.rsplit('.').next().unwrap_or_default();
                let help = later::not_in_this_edition(name)
                    .map_or_else(|| format!("known here: {known}"), later::help);
                Diagnostic::input("spec/unknown-name", message).path(path).help(help)
            }
            AssemblyError::Value { path, help, .. } => {
                Diagnostic::input("spec/value", message).path(path).help(help)
            }
            AssemblyError::OutOfRange { path, range, .. } => {
                Diagnostic::input("spec/range", message)
                    .path(path)
                    .help(format!("choose a value in the range: {range}"))
            }
            AssemblyError::DefaultOutOfRange { path, own, range, .. } => {
                Diagnostic::input("spec/range", message)
                    .path(path)
                    .help(format!("change that value, or give `{own}` in the range: {range}"))
            }
            AssemblyError::Catalog { path, cause } => {
                Diagnostic { message, ..Diagnostic::from(*cause) }.path(path)
            }
            AssemblyError::Rule { path, help, .. } => {
                Diagnostic::input("spec/rule", message).path(path).help(help)
            }
            AssemblyError::Template { .. } | AssemblyError::TemplateEntry { .. } => {
                Diagnostic::input("template/wrong", message)
                    .path("template")
                    .help("correct the template file; templates/README.md explains its language")
            }
            AssemblyError::NoWeldStrength { path, grade, .. } => Diagnostic::input(
                "spec/weld-strength",
                message,
            )
            .path(path)
            .help(format!(
                "`bracket check` leaves these welds undecided and checks the rest; or give β_w: \
                     a row for {grade} under a name of its own with `beta_w`, in a table that \
                     `catalog:` names (catalogs/README.md)"
            )),
            AssemblyError::UnseenBolts { help, .. } => {
                Diagnostic::input("template/hand-checks", message).path("template").help(help)
            }
        }
    }
}
