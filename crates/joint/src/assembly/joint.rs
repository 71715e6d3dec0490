//! Spec + template + catalogue → [`Assembly`].

use super::actions;
use super::assembly::{Assembly, Part};
use super::builder::{BoltLine, Context};
use super::code_values::{CodeValues, of_concrete};
use super::content::Content;
use super::coverage;
use super::error::AssemblyError;
use super::evaluate::{entry_fault, rules, within};
use super::facts::Facts;
use super::hole::Hole;
use super::inputs::Inputs;
use super::ledges;
use super::member_ends;
use super::no_effect;
use super::origin::Origin;
use super::scope::{Resolved, Scope};
use super::small_actions::{Idle, Neglected, SmallActions};
use super::symmetry;
use super::template::Template;
use super::template_file::{self, ReadTemplate, Templates};
use crate::catalog::Catalog;
use crate::spec::code::{Edition, PartialFactors};
use crate::spec::connection::ConnectionSpec;
use bracket_base::diag::{AtLeastOne, Diagnostic, Diagnostics};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_base::yaml::Parsed;
use std::collections::BTreeMap;
use std::path::Path;

/// An assembly, and the report's data on how it was built.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Joint {
    /// The assembly.
    pub assembly: Assembly,
    /// Every parameter with its value and the origin of the value.
    pub resolved: Vec<Resolved>,
    /// Catalogue entries used, as role and name.
    pub catalogue: Vec<(String, String)>,
    /// Data of the connection for the hand checks, if the template gives them.
    #[serde(flatten)]
    pub facts: Option<Facts>,
    /// Edition of the design code by which it was built.
    #[serde(skip)]
    pub edition: Edition,
    /// Partial factors of the design code.
    pub factors: PartialFactors,
    /// Notes on the input that the report must contain.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<Text>,
    /// What it is made of.
    pub content: Content,
    /// Lines of action of the bolts whose nuts are in contact.
    pub bolts: Vec<BoltLine>,
    /// Actions at member ends that are neglected, in model and checks.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub neglected: Vec<Neglected>,
    /// Load cases in which nothing acts, of which there is no model.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub idle: Vec<Idle>,
    /// Fillet welds of steels without β_w. They are left out of `assembly`, which no analysis may
    /// use then.
    #[serde(skip)]
    pub welds_without_strength: Vec<Diagnostic>,
}

/// A template with its origin, read once for all the specs that use it.
pub struct LoadedTemplate {
    template: Template,
    origin: Origin,
    texts: Vec<String>,
}

impl LoadedTemplate {
    /// Reads the template of a spec. `base` is the folder of the spec, from which template paths
    /// are resolved.
    pub fn of(spec: &Parsed<ConnectionSpec>, base: &Path) -> Result<Self, Diagnostics> {
        Self::read(spec, Templates::Beside(base))
    }

    /// Reads the template of a spec from the given place.
    pub fn read(spec: &Parsed<ConnectionSpec>, files: Templates<'_>) -> Result<Self, Diagnostics> {
        let ReadTemplate { template, origin, texts } =
            template_file::read(&spec.value.template, files).map_err(|faults| {
                let at_spec = |d: Diagnostic| match &d.place {
                    p if p.file.is_none() => {
                        Diagnostic { place: spec.index.place("template"), ..d }
                    }
                    _ => d,
                };
                faults.map(at_spec)
            })?;
        Ok(Self { template, origin, texts })
    }

    /// The texts of the user's own files: of the template, of the one that it extends, and so on.
    pub fn own_texts(&self) -> &[String] {
        &self.texts
    }

    /// The content of the template as text, for hashes: that of the file and of those it extends.
    pub fn content(&self) -> String {
        format!("{:?}", self.template)
    }
}

/// Builds the joint that a spec describes. `base` is the folder of the spec, from which template
/// paths are resolved. `code` is what the design code says about the spec.
pub fn build(
    spec: &Parsed<ConnectionSpec>,
    base: &Path,
    catalog: &Catalog,
    code: CodeValues,
) -> Result<Joint, Diagnostics> {
    build_from(spec, &LoadedTemplate::of(spec, base)?, catalog, code)
}

/// Builds the joint that a spec describes from its template.
pub fn build_from(
    spec: &Parsed<ConnectionSpec>,
    LoadedTemplate { template, origin, .. }: &LoadedTemplate,
    catalog: &Catalog,
    mut code: CodeValues,
) -> Result<Joint, Diagnostics> {
    // an error in a user's template is reported at its place in the template file
    let one = |f: AssemblyError| match (origin, &f) {
        (
            Origin::File { .. },
            AssemblyError::Template { .. }
            | AssemblyError::TemplateEntry { .. }
            | AssemblyError::UnseenBolts { .. },
        ) => origin.placed(template, f),
        _ => f.placed(&spec.index),
    };
    let placed = |faults: AtLeastOne<AssemblyError>| faults.map(&one);
    let alone = |fault: AssemblyError| Diagnostics::from(one(fault));
    let of_code = std::mem::take(&mut code.faults);
    let inputs = Inputs::read(&spec.value, template, catalog, of_code).map_err(&placed)?;
    let mut scope = inputs.scope();
    let resolved = scope.resolve(template, &inputs.given).map_err(&placed)?;
    rules(template, &scope).map_err(&placed)?;
    let ends = member_ends::ends(template, &scope).map_err(alone)?;
    let small =
        SmallActions::new(&spec.value, template, &code.members, &scope, &ends).map_err(alone)?;
    let context =
        Context { spec: &spec.value, template, inputs: &inputs, scope: &scope, small: &small };
    let (assembly, moved, without_strength) = assembly(&context).map_err(alone)?;
    let bolts = context.bolt_lines().map_err(alone)?;
    let (actions, frames) = match &template.hand_checks {
        Some(entry) => {
            let loads = &spec.value.loads;
            let planes = actions::on_planes(loads, &small, &ends, entry.ends());
            let frames = member_ends::frames(&ends, entry.ends());
            (planes.map_err(alone)?, frames.map_err(alone)?)
        }
        None => Default::default(),
    };
    let mut facts = Facts::of(&context, &code, &assembly, actions, &frames).map_err(alone)?;
    let mut content = context.content().map_err(alone)?;
    if let Some(facts) = &mut facts {
        facts.compare(&context, &assembly, &frames, &mut content).map_err(alone)?;
    }
    content.seams = coverage::seams(&content, &assembly);
    let without_effect =
        no_effect::notes(&spec.value, template, &inputs.given, &scope, facts.as_ref())
            .map_err(alone)?;
    let mut resolved = resolved;
    resolved.extend(inputs.preload_resolved(&spec.value));
    resolved.push(inputs.friction_resolved(&spec.value));
    // the factors of concrete count where something stands on it, or where the spec gives them
    let on_concrete = assembly.supports.iter().any(|s| s.ground.is_some());
    let counts = |r: &Resolved| on_concrete || r.given || !of_concrete(&r.name);
    resolved.extend(code.resolved.into_iter().filter(counts));
    Ok(Joint {
        assembly,
        resolved,
        catalogue: inputs.catalogue(),
        facts,
        edition: code.edition,
        factors: code.factors,
        notes: code
            .notes
            .into_iter()
            .chain(moved.map(note_of_ledges))
            .chain(small.notes())
            .chain(without_effect)
            .collect(),
        content,
        bolts,
        neglected: small.neglected,
        idle: small.idle,
        welds_without_strength: without_strength.into_iter().map(&one).collect(),
    })
}

/// The names of a template with their values for a spec, without the parts of the joint.
pub fn names(
    spec: &ConnectionSpec,
    LoadedTemplate { template, .. }: &LoadedTemplate,
    catalog: &Catalog,
) -> Result<Scope, AtLeastOne<AssemblyError>> {
    let inputs = Inputs::read(spec, template, catalog, Vec::new())?;
    let mut scope = inputs.scope();
    scope.resolve(template, &inputs.given)?;
    Ok(scope)
}

/// The names that need no parameter but those of the spec: of the catalogue's rows, and the
/// parameters that the spec gives.
pub fn given_names(
    spec: &ConnectionSpec,
    LoadedTemplate { template, .. }: &LoadedTemplate,
    catalog: &Catalog,
) -> Result<Scope, AtLeastOne<AssemblyError>> {
    let inputs = Inputs::read(spec, template, catalog, Vec::new())?;
    let mut scope = inputs.scope();
    inputs.given.iter().for_each(|(name, value)| scope.take(name, value));
    Ok(scope)
}

/// Says that plates were moved onto profiles by at most `largest` \[mm\].
fn note_of_ledges(largest: f64) -> Text {
    say!(
        "edges of plates were moved by up to {} onto those of the profiles, because no element \
         fits between them",
        format!("{largest:.3} mm")
    )
}

/// All parts, interfaces, supports, loads and symmetry planes of a joint, how far its plates were
/// moved to close ledges \[mm\], and the welds that no steel gives a strength.
fn assembly(
    context: &Context<'_>,
) -> Result<(Assembly, Option<f64>, Vec<AssemblyError>), AssemblyError> {
    let bolts = context.bolts()?;
    let mut holes: BTreeMap<&str, Vec<Hole>> = BTreeMap::new();
    for b in &bolts {
        for (part, _) in &b.through {
            holes.entry(part).or_default().push(b.hole);
        }
    }
    let mut materials = BTreeMap::new();
    let mut parts = Vec::new();
    for entry in &context.template.parts {
        for scope in within(&entry.name, context.scope.turns(&entry.each, entry.when.as_ref()))? {
            parts.push(context.part(entry, &scope, &holes, &mut materials)?);
        }
    }
    for b in &bolts {
        parts.push(context.bolt_part(b, &mut materials)?);
    }
    let names: Vec<&str> = parts.iter().map(|p: &Part| p.name.as_str()).collect();
    for (i, name) in names.iter().enumerate() {
        if names[..i].contains(name) {
            return entry_fault(name, "two parts have this name");
        }
    }
    let known = |at: &str, name: &str| {
        if names.contains(&name) {
            Ok(())
        } else {
            entry_fault(at, format!("there is no part `{name}`"))
        }
    };
    for b in &bolts {
        b.through.iter().try_for_each(|(part, _)| known(&b.name, part))?;
    }
    let mut interfaces = context.contacts()?;
    for b in &bolts {
        interfaces.extend(context.bolt_contacts(b)?);
    }
    for i in &interfaces {
        i.between.iter().try_for_each(|p| known("contacts", p))?;
    }
    let mut faces = Vec::new();
    let supports = context.supports(&bolts, &mut faces)?;
    let loads = context.loads(&mut faces)?;
    for f in &faces {
        known(&f.name, &f.part)?;
    }
    let name = context.spec.project.title.clone().unwrap_or_else(|| context.template.title.clone());
    let clearances = context.clearances()?;
    let symmetry = Vec::new();
    let (welds, without_strength) = context.welds()?;
    for w in &welds {
        w.between.iter().try_for_each(|p| known("welds", p))?;
    }
    let preloads = context.preloads(&bolts);
    let grips = context.grips(&bolts, &holes)?;
    let mut a = Assembly {
        name,
        parts,
        materials,
        interfaces,
        faces,
        supports,
        loads,
        symmetry,
        clearances,
        welds,
        preloads,
        sections: context.sections(&bolts),
        grips,
    };
    let moved = ledges::close(&mut a);
    a.symmetry = symmetry::planes(&a);
    Ok((a, moved, without_strength))
}
