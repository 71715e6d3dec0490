//! Checks the names and numbers of an assembly before any geometry is built from it.

use super::error::GeometryError;
use crate::assembly::Assembly;
use crate::assembly::assembly::Solid;
use std::collections::BTreeSet;

/// Faults of names, references and dimensions; empty if there are none.
pub fn faults(assembly: &Assembly) -> Vec<GeometryError> {
    let mut out = Vec::new();
    let mut name = |what: String| out.push(GeometryError::Name { what });
    let mut parts = BTreeSet::new();
    for part in &assembly.parts {
        if !is_identifier(&part.name) {
            name(format!("`{}` ({}) is not a part's name", part.name, part.label));
        }
        if !parts.insert(part.name.as_str()) {
            name(format!("two parts are called {}", part.name));
        }
        if !assembly.materials.contains_key(&part.material) {
            name(format!("the material `{}` of the {} is not given", part.material, part.label));
        }
    }
    let mut surfaces = BTreeSet::new();
    let mut surface = |n: &str, name: &mut dyn FnMut(String)| {
        if !is_identifier(n) || n.starts_with("SYM_") {
            name(format!("`{n}` is not a surface's name"));
        }
        if !surfaces.insert(n.to_string()) {
            name(format!("two surfaces are called {n}"));
        }
    };
    for rule in &assembly.interfaces {
        for n in &rule.between {
            if !parts.contains(n.as_str()) {
                name(format!("an interface names the part `{n}`, which does not exist"));
            }
        }
        if let Some((n, _)) = &rule.surface {
            surface(n, &mut name);
        }
    }
    for face in &assembly.faces {
        surface(&face.name, &mut name);
        if !parts.contains(face.part.as_str()) {
            name(format!(
                "the face {} lies on the part `{}`, which does not exist",
                face.name, face.part
            ));
        }
    }
    for (kind, n) in assembly
        .supports
        .iter()
        .map(|s| ("support", &s.face))
        .chain(assembly.loads.iter().map(|l| ("load", &l.face)))
    {
        if !assembly.faces.iter().any(|f| f.name == *n) {
            name(format!("a {kind} lies on the face `{n}`, which does not exist"));
        }
    }
    for part in &assembly.parts {
        let mut dimension = |what: &str, value: f64| {
            if !(value.is_finite() && value > 0.0) {
                out.push(GeometryError::Dimension {
                    part: part.label.clone(),
                    what: what.to_string(),
                    value,
                });
            }
        };
        dimension("an element size", part.size);
        solid_dimensions(&part.solid, &mut dimension);
        part.convex.iter().for_each(|s| solid_dimensions(s, &mut dimension));
    }
    out
}

fn is_identifier(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_uppercase())
        && name.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_')
}

fn solid_dimensions(solid: &Solid, dimension: &mut dyn FnMut(&str, f64)) {
    let finite = |values: &[f64]| if values.iter().all(|v| v.is_finite()) { 1.0 } else { f64::NAN };
    match solid {
        Solid::Box { min, max } => {
            dimension("a position", finite(min));
            for k in 0..3 {
                dimension(["a length (x)", "a width (y)", "a height (z)"][k], max[k] - min[k]);
            }
        }
        Solid::Prism { origin, start, edges, length, .. } => {
            dimension("a position", finite(origin) * finite(start));
            dimension("a length", *length);
            if let super::flat::FlatSolid::Prism(p) = super::flat::FlatSolid::from_solid(solid)
                && edges.len() > 2
            {
                dimension("a cross-section area", p.area());
            } else {
                dimension("a cross-section area", 0.0);
            }
        }
        Solid::Cylinder { base, radius, length, segments, .. } => {
            dimension("a position", finite(base));
            dimension("a radius", *radius);
            dimension("a length", *length);
            let sides = if *segments >= 3 { f64::from(*segments) } else { 0.0 };
            dimension("a number of sides", sides);
        }
        Solid::Union(list) | Solid::Difference(list) => {
            list.iter().for_each(|s| solid_dimensions(s, dimension))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::fixtures::lap_joint;

    fn told(change: impl FnOnce(&mut Assembly)) -> String {
        let mut joint = lap_joint();
        change(&mut joint);
        faults(&joint).iter().map(|f| f.to_string()).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn names_and_references_are_checked() {
        assert_eq!(told(|_| {}), "");
        assert!(told(|j| j.parts[0].name = "a\"b".into()).contains("`a\"b`"));
        assert!(told(|j| j.parts[1].name = "UPPER".into()).contains("two parts are called UPPER"));
        assert!(told(|j| j.parts[0].material = "S999".into()).contains("`S999`"));
        assert!(told(|j| j.interfaces[0].between[1] = "NONE".into()).contains("`NONE`"));
        assert!(told(|j| j.supports[0].face = "BASSE".into()).contains("`BASSE`"));
        assert!(told(|j| j.faces[1].name = "BASE".into()).contains("two surfaces are called BASE"));
    }

    #[test]
    fn dimensions_are_positive_and_finite() {
        assert!(told(|j| j.parts[0].size = f64::NAN).contains("element size of NaN"));
        let thin = |j: &mut Assembly| {
            if let Solid::Difference(list) = &mut j.parts[0].solid {
                list[0] = Solid::Box { min: [-40.0, -30.0, 0.0], max: [40.0, 30.0, -2.0] };
            }
        };
        let text = told(thin);
        assert!(text.contains("upper plate") && text.contains("height (z) of -2"), "{text}");
    }
}
