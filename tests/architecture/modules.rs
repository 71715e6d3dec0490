//! The modules of the library, the paths that each module names, and the modules these paths lead
//! to.

use super::tokens::{is_name, tokens, without_tests};
use std::collections::{BTreeMap, BTreeSet};

/// A path from the root of the crate, such as `["checks", "verdict", "Verdict"]`.
pub type Path = Vec<String>;

/// The modules that each module uses, each with one of the paths that use it.
pub type Graph = BTreeMap<String, BTreeMap<String, String>>;

/// One binding of a `use`. `use a::{b as c, d::*};` has two.
struct Import {
    path: Path,
    /// The name that is bound; `None` for `*`.
    name: Option<String>,
    public: bool,
}

struct Module {
    path: Path,
    /// Names of the items that the file of the module defines itself.
    items: BTreeSet<String>,
    imports: Vec<Import>,
    /// Paths named in the code, without imports.
    paths: Vec<Path>,
    /// All identifiers of the code, without imports and methods.
    words: BTreeSet<String>,
}

/// The modules of `src` without the test modules.
pub struct Modules(BTreeMap<Path, Module>);

/// The path of the module in a file.
pub fn module_of(file: &str) -> Path {
    let stem = file.trim_start_matches("src/").trim_end_matches(".rs");
    let mut path: Path = stem.split('/').map(str::to_owned).collect();
    if path.last().is_some_and(|l| l == "mod") || path == ["lib"] {
        path.pop();
    }
    path
}

impl Modules {
    /// Reads the modules from files, given as paths such as `src/checks/mod.rs` and their text.
    pub fn read(files: &[(String, String)]) -> Self {
        let mut all = BTreeMap::new();
        let mut tests: Vec<Path> = Vec::new();
        for (file, text) in files.iter().filter(|(file, _)| file != "src/main.rs") {
            let path = module_of(file);
            let (code, test_modules) = without_tests(&tokens(text));
            tests.extend(test_modules.into_iter().map(|m| joined(&path, &[m])));
            all.insert(path.clone(), Module::read(path, &code));
        }
        all.retain(|path, _| !tests.iter().any(|t| path.starts_with(t)));
        Self(all)
    }

    /// Whether this module exists outside the tests.
    pub fn contains(&self, path: &[String]) -> bool {
        self.0.contains_key(path) || path == ["main"]
    }

    /// The path from the root for a path used in a module; `None` if it leads to another crate.
    fn absolute(&self, module: &Module, path: &[String]) -> Option<Path> {
        let mut base = module.path.clone();
        let mut rest = path;
        match rest.first()?.as_str() {
            "crate" => (base, rest) = (Path::new(), &rest[1..]),
            "self" => rest = &rest[1..],
            "super" => {}
            first => {
                let child = joined(&base, &[first.to_owned()]);
                if self.0.contains_key(&child) {
                    return Some(joined(&base, rest));
                }
                let import = module.imports.iter().find(|i| i.name.as_deref() == Some(first))?;
                // `use clap::Parser as clap` leads to no module
                if import.path.first() == path.first() {
                    return None;
                }
                return Some(joined(&self.absolute(module, &import.path)?, &rest[1..]));
            }
        }
        while rest.first().is_some_and(|w| w == "super") {
            base.pop();
            rest = &rest[1..];
        }
        Some(joined(&base, rest))
    }

    /// The module that holds the item at the end of a path. Follows modules as long as there are
    /// any, then the `use` items of the last one.
    fn resolve(&self, path: &[String], depth: usize) -> Option<&Module> {
        let mut module = self.0.get(&Path::new())?;
        for (i, word) in path.iter().enumerate() {
            if let Some(next) = self.0.get(&path[..=i]) {
                module = next;
                continue;
            }
            if module.items.contains(word) || depth == 0 {
                break;
            }
            let rest = &path[i + 1..];
            let named = module.imports.iter().find(|i| i.name.as_ref() == Some(word));
            if let Some(target) = named.and_then(|i| self.absolute(module, &i.path)) {
                return self.resolve(&joined(&target, rest), depth - 1);
            }
            for glob in module.imports.iter().filter(|i| i.name.is_none()) {
                if let Some(found) = self.through(module, glob, word, depth) {
                    return Some(found);
                }
            }
            break;
        }
        Some(module)
    }

    /// The module that holds `word`, if a `use …::*` of `module` imports it.
    fn through(
        &self,
        module: &Module,
        glob: &Import,
        word: &String,
        depth: usize,
    ) -> Option<&Module> {
        let target = self.absolute(module, &glob.path)?;
        // a glob import of an enum or of another crate names no module
        let of = self.0.get(&target)?;
        if of.path == module.path {
            return None;
        }
        let child = self.0.get(&joined(&target, std::slice::from_ref(word)));
        let bound = of.imports.iter().any(|i| i.name.as_ref() == Some(word));
        if of.items.contains(word) {
            Some(of)
        } else if child.is_some() {
            child
        } else if bound && depth > 0 {
            self.resolve(&joined(&target, std::slice::from_ref(word)), depth - 1)
        } else {
            let globs = of.imports.iter().filter(|i| i.name.is_none() && depth > 0);
            globs.into_iter().find_map(|g| self.through(of, g, word, depth - 1))
        }
    }

    /// All paths of a module into the library: the path where it starts and the module where it
    /// ends.
    fn uses<'a>(&'a self, module: &'a Module) -> Vec<(Path, &'a Module)> {
        let mut found = Vec::new();
        let mut add = |path: Path| {
            if let Some(target) = self.resolve(&path, 8) {
                found.push((path, target));
            }
        };
        for import in &module.imports {
            let Some(path) = self.absolute(module, &import.path) else { continue };
            match &import.name {
                // a parent does not use what it only re-exports from its children
                Some(name) if import.public && path.starts_with(&module.path) => {
                    if module.words.contains(name) {
                        add(path);
                    }
                }
                // a glob import of a module is resolved by the names it imports
                None if self.0.contains_key(&path) => {}
                _ => add(path),
            }
        }
        for path in &module.paths {
            if let Some(path) = self.absolute(module, path) {
                add(path);
            }
        }
        let own = |w: &String| {
            module.items.contains(w) || module.imports.iter().any(|i| i.name.as_ref() == Some(w))
        };
        for glob in module.imports.iter().filter(|i| i.name.is_none() && !i.public) {
            for word in module.words.iter().filter(|w| !own(w)) {
                if let Some(target) = self.through(module, glob, word, 8) {
                    found.push((joined(&target.path, std::slice::from_ref(word)), target));
                }
            }
        }
        found
    }

    /// The modules that each module uses. A file that only declares modules and re-exports names is
    /// not a module here: whoever uses such a name uses the module that defines it.
    pub fn graph(&self) -> Graph {
        let mut graph = Graph::new();
        for module in self.0.values().filter(|m| !m.items.is_empty()) {
            let edges = graph.entry(module.path.join("::")).or_default();
            for (path, target) in self.uses(module) {
                if target.path != module.path && !target.items.is_empty() {
                    edges.entry(target.path.join("::")).or_insert_with(|| path.join("::"));
                }
            }
        }
        graph
    }

    /// The rooms that a module names: where its paths start and where they end.
    pub fn rooms(&self) -> Vec<(String, Vec<(String, String)>)> {
        let named = |module: &Module| {
            let mut rooms = BTreeSet::new();
            for (path, target) in self.uses(module) {
                // a name that the root re-exports starts in no room
                let start = path.get(..1).filter(|first| self.0.contains_key(*first));
                for room in [start.map(|s| &s[0]), target.path.first()].into_iter().flatten() {
                    rooms.insert((room.clone(), path.join("::")));
                }
            }
            rooms.into_iter().collect()
        };
        let inner = self.0.values().filter(|m| !m.path.is_empty());
        inner.map(|m| (m.path.join("::"), named(m))).collect()
    }
}

fn joined(base: &[String], rest: &[String]) -> Path {
    base.iter().chain(rest).cloned().collect()
}

impl Module {
    fn read(path: Path, code: &[String]) -> Self {
        let mut module = Self {
            path,
            items: BTreeSet::new(),
            imports: Vec::new(),
            paths: Vec::new(),
            words: BTreeSet::new(),
        };
        let at = |i: usize| code.get(i).map_or("", String::as_str);
        // modules inside the file: their `super` leads to this module
        let mut inside: Vec<(usize, String)> = Vec::new();
        let (mut depth, mut i) = (0, 0);
        while i < code.len() {
            match at(i) {
                "{" => depth += 1,
                "}" => {
                    depth -= 1;
                    inside.retain(|(d, _)| *d < depth);
                }
                "mod" if is_name(at(i + 1)) && at(i + 2) == "{" => {
                    inside.push((depth, at(i + 1).to_owned()));
                }
                // `macro_rules! name { … }` and items that define a name
                "macro_rules" if at(i + 1) == "!" => {
                    module.items.insert(at(i + 2).to_owned());
                }
                "fn" | "struct" | "enum" | "trait" | "type" | "const" | "static" | "union"
                    if depth == inside.len() && is_name(at(i + 1)) && at(i + 1) != "fn" =>
                {
                    let name = if at(i + 1) == "mut" { at(i + 2) } else { at(i + 1) };
                    module.items.insert(name.to_owned());
                }
                // items that define no name but are no declarations either
                "impl" if depth == inside.len() => {
                    module.items.insert("impl".to_owned());
                }
                // precise capturing, `impl Trait + use<'a>`, is not an import
                "use" if at(i + 1) != "<" => {
                    let public =
                        i > 0 && (at(i - 1) == "pub" || at(i - 1) == ")" && restricted(code, i));
                    i = module.import(code, i + 1, &[], public, &inside);
                    continue;
                }
                word if is_name(word) => {
                    i = module.path_at(code, i, &inside);
                    continue;
                }
                _ => {}
            }
            i += 1;
        }
        module
    }

    /// Reads the tree of a `use` from position `i`, below `prefix`. Returns the position after it.
    fn import(
        &mut self,
        code: &[String],
        mut i: usize,
        prefix: &[String],
        public: bool,
        inside: &[(usize, String)],
    ) -> usize {
        let at = |i: usize| code.get(i).map_or("", String::as_str);
        let mut path = prefix.to_vec();
        let mut name = None;
        loop {
            match at(i) {
                "{" => {
                    i += 1;
                    while at(i) != "}" && i < code.len() {
                        i = self.import(code, i, &path, public, inside);
                        i += usize::from(at(i) == ",");
                    }
                    return i + 1;
                }
                "*" => {
                    self.add_import(path, None, public, inside);
                    return i + 1;
                }
                "as" => {
                    name = Some(at(i + 1).to_owned());
                    i += 2;
                }
                "::" => i += 1,
                word if is_name(word) => {
                    path.push(word.to_owned());
                    i += 1;
                }
                _ => {
                    // `use a::b::{self}` binds b
                    if path.len() > 1 && path.last().is_some_and(|l| l == "self") {
                        path.pop();
                    }
                    let name = name.or_else(|| path.last().cloned());
                    self.add_import(path, name, public, inside);
                    return i;
                }
            }
        }
    }

    fn add_import(
        &mut self,
        path: Path,
        name: Option<String>,
        public: bool,
        inside: &[(usize, String)],
    ) {
        if let Some(path) = outward(path, inside) {
            self.imports.push(Import { path, name, public });
        }
    }

    /// Reads the word at `i`, or the path that starts there. Returns the position after it.
    fn path_at(&mut self, code: &[String], i: usize, inside: &[(usize, String)]) -> usize {
        let at = |i: usize| code.get(i).map_or("", String::as_str);
        let before = if i > 0 { at(i - 1) } else { "" };
        // `pub(in crate::solve)` only limits who may use an item
        let visibility = before == "in" && i > 2 && at(i - 2) == "(" && at(i - 3) == "pub";
        let mut path = vec![at(i).to_owned()];
        let mut end = i + 1;
        while at(end) == "::" && is_name(at(end + 1)) {
            path.push(at(end + 1).to_owned());
            end += 2;
        }
        if before == "." || before == "fn" || visibility {
            return end;
        }
        self.words.insert(path[0].clone());
        // `$crate` in a macro leads to the root, as `crate` does
        if path.len() > 1 && !(before == "::" && i > 1) {
            self.paths.extend(outward(path, inside));
        }
        end
    }
}

/// Whether the `)` before `i` closes a `pub(crate)` or `pub(in …)`.
fn restricted(code: &[String], i: usize) -> bool {
    let open = code[..i].iter().rposition(|t| t == "(");
    open.is_some_and(|o| o > 0 && code[o - 1] == "pub")
}

/// The path as seen from the module of the file; `None` if it stays in a module inside the file.
fn outward(mut path: Path, inside: &[(usize, String)]) -> Option<Path> {
    if inside.is_empty() || path.first().is_none_or(|w| w != "super" && w != "self") {
        return Some(path);
    }
    if path[0] == "self" {
        return None;
    }
    let up = path.iter().take_while(|w| *w == "super").count();
    if up < inside.len() {
        return None;
    }
    path.drain(..inside.len());
    if up == inside.len() {
        path.insert(0, "self".to_owned());
    }
    Some(path)
}
