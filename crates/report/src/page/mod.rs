//! `report.html`: the sheet as one page that opens from disk without network, with a 3-D view.
//!
//! The page holds style, script, pictures and fields. Without a script or WebGL2 the pictures stay.
//!
//! The viewer is the program's own script of 35 kB. Three libraries were compared with it: three.js
//! (MIT, 2.1 MB of source that must be bundled), vtk.js (BSD-3-Clause, 2.5 MB) and ogl (public
//! domain, 0.35 MB). Each page is one file, so the library would be part of every report. What the
//! viewer needs beside matrices and shaders is the work on tetrahedra: surfaces, edges, sections
//! and packed fields; only vtk.js has a part of it, and none reads the packed arrays.

pub mod base64;
mod content;
pub mod scene;

use crate::escaped::{escaped, inside_script};
use crate::sheet::Sheet;
use crate::words::Words;
use bracket_base::diag::Diagnostics;
use bracket_base::say;
use content::Content;
use scene::Scene;

/// Name of the page in a result folder.
pub const PAGE_FILE: &str = "report.html";

const STYLE: &str = include_str!("page.css");
const VIEW: &str = include_str!("viewer/view.html");
/// The script in the order in which its parts need each other.
const SCRIPT: [&str; 5] = [
    include_str!("viewer/cases.js"),
    include_str!("viewer/scene.js"),
    include_str!("viewer/camera.js"),
    include_str!("viewer/drawing.js"),
    include_str!("viewer/page.js"),
];
/// Nothing comes from elsewhere, and only what stands in the page runs.
const POLICY: &str =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

/// The page of a full sheet. `picture` reads a picture of the result folder; pictures that it does
/// not have are left out. Without fields there is no 3-D view.
pub fn page(
    sheet: &Sheet,
    scene: &Scene,
    words: &Words,
    picture: impl Fn(&str) -> Option<Vec<u8>>,
) -> Result<String, Diagnostics> {
    let mut content = Content::new(words, &picture);
    let view = !scene.shapes.is_empty();
    content.report(sheet, view.then(|| viewer(scene, words)));
    let (body, contents) = content.finish();
    let title = escaped(&sheet.head.title);
    let (language, aria) = (words.code(), escaped(&words.say(&"contents".into())));
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n<meta \
         http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n<meta name=\"viewport\" \
         content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n<style>\n\
         {STYLE}</style>\n</head>\n<body>\n<div class=\"frame\">\n<nav \
         aria-label=\"{aria}\"><ul>\n{contents}</ul></nav>\n<main>\n{body}</main>\n</div>\n"
    );
    if view {
        let json = scene.json(words).map_err(|e| {
            bracket_base::diag::Diagnostic::environment("report/page", format!("the 3-D view: {e}"))
        })?;
        let json = inside_script(&json);
        page.push_str(&format!("<script type=\"application/json\" id=\"scene\">{json}</script>\n"));
    }
    page.push_str("<script>\n\"use strict\";\n");
    SCRIPT.iter().for_each(|part| page.push_str(&words.fill(part)));
    page.push_str("</script>\n</body>\n</html>\n");
    Ok(page)
}

/// The view with its controls, and the load cases that it leaves out.
fn viewer(scene: &Scene, words: &Words) -> String {
    let mut out = words.fill(VIEW);
    if !scene.left_out.is_empty() {
        let left_out = say!(
            "Not in this view, which would become too large; ParaView opens them from the folder \
             fields: {}",
            scene.left_out.join(", ")
        );
        out.push_str(&format!("<p class=\"quiet\">{}</p>\n", escaped(&words.say(&left_out))));
    }
    out
}

#[cfg(test)]
mod tests;
