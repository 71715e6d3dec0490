//! Circular imports: modules that use each other, directly or through other modules.

use super::modules::Graph;
use std::collections::BTreeSet;

/// All modules that can be reached from `start` in one or more steps.
pub fn reached(graph: &Graph, start: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open = vec![start.to_owned()];
    while let Some(module) = open.pop() {
        for next in graph.get(&module).into_iter().flat_map(|edges| edges.keys()) {
            if found.insert(next.clone()) {
                open.push(next.clone());
            }
        }
    }
    found
}

/// The strongly connected components with more than one module, each in order.
pub fn circles(graph: &Graph) -> Vec<Vec<String>> {
    let reach: Vec<(&String, BTreeSet<String>)> =
        graph.keys().map(|m| (m, reached(graph, m))).collect();
    let mut seen = BTreeSet::new();
    let mut found = Vec::new();
    for (module, from) in &reach {
        if !from.contains(*module) || seen.contains(*module) {
            continue;
        }
        let back = |m: &&(&String, BTreeSet<String>)| from.contains(m.0) && m.1.contains(*module);
        let circle: Vec<String> = reach.iter().filter(back).map(|(m, _)| (*m).clone()).collect();
        seen.extend(circle.iter().cloned());
        found.push(circle);
    }
    found
}

/// Describes a circle as text: one line for each edge, with the path that makes it.
pub fn described(graph: &Graph, circle: &[String]) -> String {
    let mut lines = vec![format!("circle of {} modules:", circle.len())];
    for module in circle {
        for (target, path) in graph.get(module).into_iter().flatten() {
            if circle.contains(target) {
                lines.push(format!("    {module} -> {target}   by {path}"));
            }
        }
    }
    lines.join("\n")
}
