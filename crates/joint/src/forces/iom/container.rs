//! The document: a container with a model and its results.

use bracket_base::diag::Diagnostic;
use bracket_base::text_file::{self, Table};
use bracket_base::xml::{Element, Xml};
use std::path::Path;

/// The document.
pub struct Container<'a>(Xml<'a>);

/// What to do where something is missing.
const HELP: &str = "save model and results as one container: `OpenModelContainer` with `OpenModel` \
                    and `OpenModelResult`";

/// The text of the file.
pub fn text(file: &Path) -> Result<String, Box<Diagnostic>> {
    let unread = |e| {
        Diagnostic::input("loads/iom", format!("the container cannot be read: {e}"))
            .file(file)
            .help("check the path")
    };
    match text_file::read_table(file, unread)? {
        Table::Text(text) => Ok(text),
        Table::Workbook(_) => {
            let message = "this is a workbook, not an IOM container";
            let help = "name the program that wrote it with `mapping`; an IOM container is XML";
            Err(Diagnostic::input("loads/iom", message).file(file).help(help).into())
        }
    }
}

impl<'a> Container<'a> {
    /// Reads the document.
    pub fn parse(text: &'a str, file: &Path) -> Result<Self, Box<Diagnostic>> {
        Xml::parse(text, file).map(Self)
    }

    /// The model and the results in it.
    pub fn open(&'a self, file: &Path) -> Result<[Element<'a>; 2], Box<Diagnostic>> {
        let root = self.0.root();
        let fault = |message: String, help: &str| {
            let d = Diagnostic::input("loads/iom", message).help(help);
            Box::new(Diagnostic { place: root.place(file), ..d })
        };
        match root.name() {
            "OpenModelContainer" => {}
            "OpenModel" => {
                return Err(fault("this is a model without results (`OpenModel`)".into(), HELP));
            }
            "OpenModelResult" => {
                let message = "these are results without their model (`OpenModelResult`)";
                return Err(fault(message.into(), HELP));
            }
            other => {
                let message = format!("this is an XML document `{other}`, not an IOM container");
                return Err(fault(message, "export an `OpenModelContainer` of IDEA StatiCa"));
            }
        }
        let part = |name: &str| {
            root.child(name).ok_or_else(|| fault(format!("the container has no `{name}`"), HELP))
        };
        Ok([part("OpenModel")?, part("OpenModelResult")?])
    }
}
