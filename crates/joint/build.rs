//! Lists the connection templates: a new one is a new file in `templates/`, and no line of Rust.

use std::fmt::Write;
use std::path::Path;

fn main() -> std::io::Result<()> {
    println!("cargo:rerun-if-changed=../../templates");
    let folder = Path::new(&std::env::var("CARGO_MANIFEST_DIR").map_err(std::io::Error::other)?)
        .join("../../templates");
    let mut files: Vec<_> =
        std::fs::read_dir(folder)?.map(|e| Ok(e?.path())).collect::<std::io::Result<_>>()?;
    files.retain(|f| f.extension().is_some_and(|e| e == "yaml"));
    files.sort();
    let mut list = String::from("&[\n");
    for file in &files {
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        // the text itself, not its path: a build stays valid when its folder moves
        let text = std::fs::read_to_string(file)?;
        writeln!(list, "    ({name:?}, {text:?}),").map_err(std::io::Error::other)?;
    }
    list.push_str("]\n");
    let out = std::env::var("OUT_DIR").map_err(std::io::Error::other)?;
    std::fs::write(Path::new(&out).join("templates.rs"), list)
}
