//! The only reader of XML: documents of other programs. A document with a DTD is refused, and with
//! it every entity that could grow or lead to another file.

use crate::diag::{Diagnostic, Place};
use roxmltree::{Document, Error, Node, ParsingOptions};
use std::fs::File;
use std::io::Read as _;
use std::path::Path;

/// Most nodes of a document that are read.
const MOST_NODES: u32 = 50_000_000;

/// Bytes in which a document shows that it is one.
const BEGINNING: u64 = 256;

/// A document.
#[derive(Debug)]
pub struct Xml<'a> {
    document: Document<'a>,
    /// Where each line of the text begins.
    lines: Vec<usize>,
}

/// An element of a document.
#[derive(Clone, Copy, Debug)]
pub struct Element<'a> {
    node: Node<'a, 'a>,
    lines: &'a [usize],
}

/// Whether a file begins as XML does, in UTF-8 or UTF-16.
pub fn is_xml(file: &Path) -> bool {
    let mut bytes = Vec::new();
    let read = File::open(file).and_then(|f| f.take(BEGINNING).read_to_end(&mut bytes));
    // in UTF-16 every other byte of the first letters is zero
    let letters = bytes.iter().filter(|b| !matches!(b, 0 | 0xef | 0xbb | 0xbf | 0xfe | 0xff));
    read.is_ok() && letters.copied().find(|b| !b.is_ascii_whitespace()) == Some(b'<')
}

impl<'a> Xml<'a> {
    /// Reads a document; `file`: for messages.
    pub fn parse(text: &'a str, file: &Path) -> Result<Self, Box<Diagnostic>> {
        let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
        // the mark of UTF-8 may stand before the document
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let document = Document::parse_with_options(text, options).map_err(|e| {
            let fault = |message: String, help: &str| {
                Diagnostic::input("xml/document", message).file(file).help(help)
            };
            let at = e.pos();
            match e {
                Error::DtdDetected => fault(
                    "the document has a DTD (`<!DOCTYPE …>`), which is not read".into(),
                    "delete it: entities of a DTD may grow without limit or lead to other files",
                ),
                Error::NodesLimitReached => fault(
                    format!("the document has more than {MOST_NODES} elements and texts"),
                    "export fewer members or load cases",
                ),
                other => fault(
                    format!("this is no complete XML document: {other}"),
                    "export the file again: it may have been cut or edited",
                )
                .at(at.row as usize, at.col as usize),
            }
        })?;
        let ends = text.bytes().enumerate().filter(|(_, b)| *b == b'\n');
        let lines = std::iter::once(0).chain(ends.map(|(i, _)| i + 1)).collect();
        Ok(Self { document, lines })
    }

    /// The outermost element.
    pub fn root(&'a self) -> Element<'a> {
        Element { node: self.document.root_element(), lines: &self.lines }
    }
}

impl<'a> Element<'a> {
    /// Its name, without a namespace.
    pub fn name(self) -> &'a str {
        self.node.tag_name().name()
    }

    /// Its attribute `type` (`xsi:type`), in any namespace.
    pub fn kind(self) -> Option<&'a str> {
        self.node.attributes().find(|a| a.name() == "type").map(|a| a.value())
    }

    /// The elements in it.
    pub fn all(self) -> impl Iterator<Item = Self> {
        self.node.children().filter(Node::is_element).map(move |node| Self { node, ..self })
    }

    /// The elements of this name in it.
    pub fn children(self, name: &str) -> impl Iterator<Item = Self> {
        self.all().filter(move |e| e.name() == name)
    }

    /// The first element of this name in it.
    pub fn child(self, name: &str) -> Option<Self> {
        self.children(name).next()
    }

    /// The element at the end of a way from child to child.
    pub fn at(self, way: &[&str]) -> Option<Self> {
        way.iter().try_fold(self, |e, name| e.child(name))
    }

    /// Its text without blanks around it; empty if it has none.
    pub fn text(self) -> &'a str {
        self.node.text().unwrap_or_default().trim()
    }

    /// The text of the child of this name; `None` if there is no such child or it is empty.
    pub fn text_of(self, name: &str) -> Option<&'a str> {
        self.child(name).map(Self::text).filter(|t| !t.is_empty())
    }

    /// Its line in the document.
    pub fn line(self) -> usize {
        let start = self.node.range().start;
        self.lines.partition_point(|begins| *begins <= start)
    }

    /// The names of the elements around it and its own, with its number among those of its name:
    /// `OpenModelResult/ResultOnMembers/Members/ResultOnMember[2]`.
    pub fn path(self) -> String {
        let mut names: Vec<String> = Vec::new();
        for node in self.node.ancestors().filter(Node::is_element) {
            let name = node.tag_name().name();
            let same = |n: &Node<'_, '_>| n.is_element() && n.tag_name().name() == name;
            let before = node.prev_siblings().skip(1).filter(same).count();
            let after = node.next_siblings().skip(1).any(|n| same(&n));
            names.push(match before > 0 || after {
                true => format!("{name}[{}]", before + 1),
                false => name.to_owned(),
            });
        }
        names.reverse();
        names.join("/")
    }

    /// Its place: file, line and path.
    pub fn place(self, file: &Path) -> Place {
        let line = Some(self.line());
        Place { file: Some(file.into()), line, column: None, path: Some(self.path()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "<?xml version=\"1.0\" encoding=\"utf-16\"?>\n\
                        <a xmlns:i=\"x\">\n<b><c> 1 </c></b>\n<b i:type=\"K\"><c/></b></a>";

    #[test]
    fn elements_with_texts_lines_and_paths() {
        let xml = Xml::parse(TEXT, Path::new("a.xml")).expect("a document");
        let root = xml.root();
        assert_eq!((root.name(), root.path().as_str(), root.line()), ("a", "a", 2));
        let [one, two] = [0, 1].map(|i| root.children("b").nth(i).expect("two"));
        assert_eq!((one.text_of("c"), two.text_of("c"), one.text_of("d")), (Some("1"), None, None));
        assert_eq!((one.kind(), two.kind()), (None, Some("K")));
        let c = two.child("c").expect("empty");
        assert_eq!((c.path().as_str(), c.line()), ("a/b[2]/c", 4));
        assert!(root.at(&["b", "c"]).is_some() && root.at(&["b", "d"]).is_none());
    }

    #[test]
    fn what_is_no_document_is_refused() {
        let growing = "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY x \"y\">]><a>&x;</a>";
        let other = "<!DOCTYPE a [<!ENTITY x SYSTEM \"file:///etc/hosts\">]><a>&x;</a>";
        for (text, message) in [
            (growing, "a DTD"),
            (other, "a DTD"),
            ("<a>&x;</a>", "no complete XML"),
            ("<a><b></a>", "no complete XML"),
            ("<a>", "no complete XML"),
            ("", "no complete XML"),
            ("case,N\n", "no complete XML"),
        ] {
            let d = Xml::parse(text, Path::new("a.xml")).map(drop).expect_err(text);
            assert!(d.message.contains(message) && d.help.is_some(), "{text}: {d:?}");
            assert!(d.place.file.is_some(), "{text}: {d:?}");
        }
        // a document may be as deep as it likes
        let deep = "<a>".repeat(100_000) + &"</a>".repeat(100_000);
        assert!(Xml::parse(&deep, Path::new("a.xml")).is_ok());
    }

    #[test]
    fn a_file_shows_that_it_is_a_document() {
        let dir = tempfile::tempdir().expect("a folder");
        let path = dir.path().join("a");
        let wide: Vec<u8> = [0xff, 0xfe]
            .into_iter()
            .chain(TEXT.encode_utf16().flat_map(u16::to_le_bytes))
            .collect();
        for (bytes, is) in [
            (wide.as_slice(), true),
            (TEXT.as_bytes(), true),
            (b"\xef\xbb\xbf \n<a/>", true),
            (b"case;N\n<1;2", false),
            (b"", false),
        ] {
            std::fs::write(&path, bytes).expect("written");
            assert_eq!(is_xml(&path), is);
        }
        assert!(!is_xml(dir.path()));
    }
}
