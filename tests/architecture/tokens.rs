//! Splits Rust source into tokens, without comments, literals and tests.

/// Identifiers, numbers, `::` and single characters. Each string or character literal becomes one
/// `"`.
pub fn tokens(text: &str) -> Vec<String> {
    scan(text, |_| "\"".to_owned())
}

/// The same with each literal as written, quotes included.
pub fn tokens_with_literals(text: &str) -> Vec<String> {
    scan(text, |literal| literal.iter().collect())
}

fn scan(text: &str, of_literal: impl Fn(&[char]) -> String) -> Vec<String> {
    let c: Vec<char> = text.chars().collect();
    let at = |i: usize| c.get(i).copied().unwrap_or('\0');
    let mut out = Vec::new();
    let mut i = 0;
    while i < c.len() {
        if c[i].is_whitespace() {
            i += 1;
        } else if c[i] == '/' && at(i + 1) == '/' {
            while i < c.len() && c[i] != '\n' {
                i += 1;
            }
        } else if c[i] == '/' && at(i + 1) == '*' {
            i = after_block_comment(&c, i);
        } else if let Some(end) = after_literal(&c, i) {
            out.push(of_literal(&c[i..end]));
            i = end;
        } else if c[i] == '\'' {
            // a lifetime
            i += 1;
            while is_word(at(i)) {
                i += 1;
            }
        } else if is_word(c[i]) {
            let start = i;
            while is_word(at(i)) {
                i += 1;
            }
            out.push(c[start..i].iter().collect());
        } else if c[i] == ':' && at(i + 1) == ':' {
            out.push("::".to_owned());
            i += 2;
        } else {
            out.push(c[i].to_string());
            i += 1;
        }
    }
    out
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether a token is an identifier or a keyword.
pub fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

fn after_block_comment(c: &[char], start: usize) -> usize {
    let (mut depth, mut i) = (0, start);
    while i < c.len() {
        match (c[i], c.get(i + 1)) {
            ('/', Some('*')) => (depth, i) = (depth + 1, i + 2),
            ('*', Some('/')) => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            break;
        }
    }
    i
}

/// The position after the string or character literal that starts at `start`, if there is one.
fn after_literal(c: &[char], start: usize) -> Option<usize> {
    let at = |i: usize| c.get(i).copied().unwrap_or('\0');
    let mut i = start;
    while i < start + 2 && matches!(at(i), 'b' | 'c' | 'r') {
        i += 1;
    }
    let raw = c[start..i].contains(&'r');
    let mut hashes = 0;
    while raw && at(i + hashes) == '#' {
        hashes += 1;
    }
    i += hashes;
    match at(i) {
        '"' if raw => {
            let end: Vec<char> = std::iter::once('"').chain(vec!['#'; hashes]).collect();
            let body = c.get(i + 1..)?;
            let found = body.windows(end.len()).position(|w| w == end)?;
            Some(i + 1 + found + end.len())
        }
        '"' => {
            i += 1;
            while i < c.len() && c[i] != '"' {
                i += if c[i] == '\\' { 2 } else { 1 };
            }
            Some(i + 1)
        }
        '\'' if hashes == 0 && at(i + 1) == '\\' => {
            let close = c.get(i + 3..)?.iter().position(|c| *c == '\'')?;
            Some(i + 3 + close + 1)
        }
        '\'' if hashes == 0 && at(i + 2) == '\'' => Some(i + 3),
        _ => None,
    }
}

/// The tokens without the items under `#[cfg(test)]`, and the modules declared under that attribute
/// (`mod tests;` is in a file of its own).
pub fn without_tests(tokens: &[String]) -> (Vec<String>, Vec<String>) {
    let (mut kept, mut modules) = (Vec::new(), Vec::new());
    let mut i = 0;
    while i < tokens.len() {
        let Some((after, whole_file)) = test_attribute(tokens, i) else {
            kept.push(tokens[i].clone());
            i += 1;
            continue;
        };
        if whole_file {
            return (Vec::new(), modules);
        }
        let end = after_item(tokens, after);
        if let Some(m) = tokens[after..end].windows(3).find(|w| w[0] == "mod" && w[2] == ";") {
            modules.push(m[1].clone());
        }
        i = end;
    }
    (kept, modules)
}

/// The position after the attribute `#[cfg(test)]` or `#![cfg(test)]` at `i`, and whether it is the
/// second form, which applies to the whole file. `cfg(all(test, …))` counts as well.
fn test_attribute(tokens: &[String], i: usize) -> Option<(usize, bool)> {
    if tokens[i] != "#" {
        return None;
    }
    let inner = tokens.get(i + 1).is_some_and(|t| t == "!");
    let open = i + 1 + usize::from(inner);
    let starts = |words: &[&str]| {
        tokens.get(open..open + words.len()).is_some_and(|t| t.iter().eq(words.iter()))
    };
    let test = starts(&["[", "cfg", "(", "test", ")"])
        || starts(&["[", "cfg", "(", "all", "(", "test", ","]);
    test.then(|| (after_group(tokens, open), inner))
}

/// The position after the bracket that closes the one at `open`.
fn after_group(tokens: &[String], open: usize) -> usize {
    let mut depth = 0;
    for (i, t) in tokens.iter().enumerate().skip(open) {
        match t.as_str() {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return i + 1;
        }
    }
    tokens.len()
}

/// The position after the item, field or statement that starts at `i`, including its other
/// attributes.
fn after_item(tokens: &[String], mut i: usize) -> usize {
    while tokens.get(i).is_some_and(|t| t == "#") {
        i = after_group(tokens, i + 1);
    }
    // these items end with `;` and may contain braces before it
    let mut semicolon = false;
    let mut item = false;
    while let Some(t) = tokens.get(i) {
        match t.as_str() {
            "use" | "static" | "let" | "type" => (semicolon, item) = (true, true),
            "const" => semicolon = tokens.get(i + 1).is_none_or(|t| t != "fn"),
            "fn" | "struct" | "enum" | "trait" | "impl" | "mod" | "union" => item = true,
            ";" => return i + 1,
            "," if !item && !semicolon => return i + 1,
            ")" | "]" | "}" => return i,
            "(" | "[" => {
                i = after_group(tokens, i);
                continue;
            }
            "{" => {
                i = after_group(tokens, i);
                if !semicolon {
                    return i;
                }
                continue;
            }
            _ => {}
        }
        i += 1;
    }
    i
}

/// Whether the code names a crate in a path or a `use`: `serde_yaml::…` or `use serde_yaml;`, but
/// not `self::clarabel`.
pub fn names_crate(tokens: &[String], name: &str) -> bool {
    let at = |i: usize| tokens.get(i).map_or("", String::as_str);
    tokens.iter().enumerate().filter(|(_, t)| *t == name).any(|(i, _)| {
        let before = if i > 0 { at(i - 1) } else { "" };
        // `::name` names a crate, `a::name` does not
        let inner = before == "::" && i > 1 && (is_name(at(i - 2)) || at(i - 2) == ">");
        let used = matches!(before, "use" | "crate");
        !inner && before != "mod" && (at(i + 1) == "::" || used && matches!(at(i + 1), ";" | "as"))
    })
}
