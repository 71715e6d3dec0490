//! Who asks for a table of forces: the help of a fault names what this one can write.

use super::program::Program;

/// Who asks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Asked {
    /// A spec: it has the keys `mapping`, `columns` and `sheet`.
    #[default]
    Spec,
    /// A command: it has the options `--mapping` and `--sheet`.
    Command,
}

impl Asked {
    /// How the program of the table is named.
    pub fn mapping(self, program: Option<Program>) -> String {
        match (self, program) {
            (Self::Spec, None) => "`mapping`".into(),
            (Self::Spec, Some(p)) => format!("`mapping: {}`", p.word()),
            (Self::Command, None) => "`--mapping`".into(),
            (Self::Command, Some(p)) => format!("`--mapping {}`", p.word()),
        }
    }

    /// How the sheet of a workbook is named.
    pub fn sheet(self) -> &'static str {
        match self {
            Self::Spec => "`sheet`",
            Self::Command => "`--sheet`",
        }
    }

    /// How it is said which columns hold the actions.
    pub fn columns(self) -> &'static str {
        match self {
            Self::Spec => "name its headers with `columns: {N: …, My: …}`",
            Self::Command => "give its columns Bracket's names: `N`, `Vz`, `My`",
        }
    }
}
