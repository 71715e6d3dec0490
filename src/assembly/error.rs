//! What can be wrong between a spec and its assembly.

use crate::catalog::CatalogError;
use crate::diag::Diagnostic;
use crate::spec::expr::ExprError;
use crate::spec::yaml::PlaceIndex;

/// A fault of a spec, or of a template.
#[derive(Debug, thiserror::Error)]
pub enum AssemblyError {
    /// A required value is absent.
    #[error("`{path}` is missing: {about}")]
    Missing {
        /// Path in the spec.
        path: String,
        /// What it is.
        about: String,
    },
    /// A name the template does not know.
    #[error("{problem}")]
    Unknown {
        /// Path in the spec.
        path: String,
        /// What is unknown to what, and the nearest name that is known.
        problem: String,
        /// What there is.
        known: String,
    },
    /// A value of the wrong kind or unit.
    #[error("`{path}`: {problem}")]
    Value {
        /// Path in the spec.
        path: String,
        /// What is wrong.
        problem: String,
        /// What to write.
        help: String,
    },
    /// A value outside its range.
    #[error("`{name}` is {value}; allowed: {range}")]
    OutOfRange {
        /// Path in the spec.
        path: String,
        /// Parameter.
        name: String,
        /// Its value.
        value: String,
        /// What is allowed.
        range: String,
    },
    /// A name the catalogue does not know, or a value it cannot give.
    #[error("{cause}")]
    Catalog {
        /// Path in the spec.
        path: String,
        /// The catalogue's words.
        cause: Box<CatalogError>,
    },
    /// A condition of the template does not hold.
    #[error("{message}")]
    Rule {
        /// Path in the spec.
        path: String,
        /// The template's words.
        message: String,
        /// The template's cure.
        help: String,
    },
    /// The template itself is wrong.
    #[error("the template is wrong at `{at}`: {cause}")]
    Template {
        /// Entry of the template.
        at: String,
        /// Why.
        cause: ExprError,
    },
    /// The template itself is wrong, without an expression to blame.
    #[error("the template is wrong at `{at}`: {problem}")]
    TemplateEntry {
        /// Entry of the template.
        at: String,
        /// What is wrong.
        problem: String,
    },
    /// The bolts of the geometry are others than those of `hand_checks`.
    #[error("`{at}` of the template is not what is meshed: {problem}")]
    UnseenBolts {
        /// Entry of the template.
        at: String,
        /// The numbers on both sides.
        problem: String,
        /// What to write.
        help: String,
    },
}

/// A name that a template does not have; `noun` says of which kind.
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

/// The known names for a help line, `nothing` where there are none.
pub(super) fn known_names<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let all: Vec<&str> = names.collect();
    if all.is_empty() { "nothing".to_owned() } else { all.join(", ") }
}

impl AssemblyError {
    /// The diagnostic, placed in the spec.
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
                Diagnostic::input("spec/unknown-name", message)
                    .path(path)
                    .help(format!("known here: {known}"))
            }
            AssemblyError::Value { path, help, .. } => {
                Diagnostic::input("spec/value", message).path(path).help(help)
            }
            AssemblyError::OutOfRange { path, range, .. } => {
                Diagnostic::input("spec/range", message)
                    .path(path)
                    .help(format!("choose a value in the range: {range}"))
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
            AssemblyError::UnseenBolts { help, .. } => {
                Diagnostic::input("template/hand-checks", message).path("template").help(help)
            }
        }
    }
}
