//! Catalogue rows and values of one spec: profiles, steels, bolts, parameters, friction.

use super::assembly::PartMaterial;
use super::error::{AssemblyError, known_names, unknown_in};
use super::given::given;
use super::scope::{Given, Resolved, Scope, path_of};
use super::spec_checks;
use super::template::Template;
use crate::catalog::{
    BoltGrade, BoltSize, Catalog, CatalogError, IProfile, Section, SectionKind, Steel,
};
use crate::spec::connection::{ConnectionSpec, PreloadSpec};
use crate::spec::expr::Value;
use crate::strength::{BoltShank, Nominal, NominalStrength, Strength};
use bracket_base::diag::{AtLeastOne, did_you_mean, number};
use bracket_base::units::limits;
use bracket_base::words::Text;
use std::collections::BTreeMap;

/// Young's modulus and Poisson's ratio of bolts (EN 1993-1-1, 3.2.6) \[MPa\].
const BOLT_ELASTIC: (f64, f64) = (210_000.0, 0.3);

/// Catalogue rows and values of one spec.
pub struct Inputs<'a> {
    sections: Vec<(String, Section<'a>)>,
    steels: BTreeMap<String, (String, &'a Steel)>,
    /// Size and grade of the bolts, if the spec has bolts.
    pub bolt: Option<(&'a BoltSize, &'a BoltGrade)>,
    /// Parameter values from the spec.
    pub given: BTreeMap<String, Given>,
    /// Friction coefficient.
    pub mu: f64,
    /// Preload of a bolt \[N\], if the bolts are preloaded.
    pub preload: Option<f64>,
}

fn unlisted(path: String, cause: CatalogError) -> AssemblyError {
    AssemblyError::Catalog { path, cause: cause.into() }
}

/// The section of a member, of a kind that the template takes for its role.
fn section<'a>(
    template: &Template,
    role: &str,
    name: &str,
    catalog: &'a Catalog,
) -> Result<Section<'a>, AssemblyError> {
    let path = || format!("members.{role}.profile");
    let entry = template.members.iter().find(|m| m.role == role);
    let taken = entry.map_or(&[SectionKind::I][..], |m| &m.sections);
    if taken == [SectionKind::I] {
        return catalog.profile(name).map(Section::I).map_err(|e| unlisted(path(), e));
    }
    let section = catalog.section(name).map_err(|e| unlisted(path(), e))?;
    if taken.contains(&section.kind()) {
        return Ok(section);
    }
    let words: Vec<&str> = taken.iter().map(|k| k.words()).collect();
    Err(AssemblyError::Value {
        path: path(),
        problem: format!("{} is {}", section.name(), section.kind().words()),
        help: format!("{role} of {} is {}", template.name, words.join(" or ")),
    })
}

impl<'a> Inputs<'a> {
    /// Reads a spec. Reports all faults that can be found in one pass, with those that the design
    /// code found in its section of the spec.
    pub fn read(
        spec: &ConnectionSpec,
        template: &Template,
        catalog: &'a Catalog,
        of_code: Vec<AssemblyError>,
    ) -> Result<Self, AtLeastOne<AssemblyError>> {
        let mut faults = Vec::new();
        let mut sections = Vec::new();
        let mut steels = BTreeMap::new();
        let mut wrong: Vec<&str> = Vec::new();
        for (role, member) in &spec.members {
            match section(template, role, &member.profile, catalog) {
                Ok(p) => sections.push((role.clone(), p)),
                Err(_) if wrong.contains(&member.profile.as_str()) => {}
                Err(e) => {
                    wrong.push(&member.profile);
                    faults.push(e);
                }
            }
            match catalog.steel(&member.steel) {
                Ok(s) => drop(steels.insert(role.clone(), (format!("members.{role}.steel"), s))),
                // a name that is wrong twice is reported once
                Err(_) if wrong.contains(&member.steel.as_str()) => {}
                Err(e) => {
                    wrong.push(&member.steel);
                    faults.push(unlisted(format!("members.{role}.steel"), e));
                }
            }
        }
        spec_checks::members(spec, template, &mut faults);
        if let Some(name) = spec.plate.as_ref().and_then(|p| p.steel.as_ref()) {
            match catalog.steel(name) {
                Ok(s) => drop(steels.insert("plate".into(), ("plate.steel".into(), s))),
                Err(_) if wrong.contains(&name.as_str()) => {}
                Err(e) => faults.push(unlisted("plate.steel".into(), e)),
            }
        }
        let bolt = spec.bolts.as_ref().and_then(|b| {
            let size = catalog
                .bolt(&b.size)
                .map_err(|e| faults.push(unlisted("bolts.size".into(), e)))
                .ok();
            let grade = catalog
                .bolt_grade(&b.grade)
                .map_err(|e| faults.push(unlisted("bolts.grade".into(), e)))
                .ok();
            size.zip(grade)
        });
        let preload = bolt.and_then(|(size, grade)| {
            preload(spec, size, grade).map_err(|e| faults.push(e)).ok().flatten()
        });
        faults.extend(of_code);
        let mu = match (spec.friction.mu, &spec.friction.class) {
            (None, Some(c)) => catalog.friction_class(c).map(|f| f.mu).unwrap_or_else(|e| {
                faults.push(unlisted("friction.class".into(), e));
                0.0
            }),
            (mu, _) => mu.unwrap_or(0.0),
        };
        let roles = || template.members.iter().map(|m| m.role.as_str());
        let strange: Vec<(&String, String)> = spec
            .members
            .keys()
            .filter(|r| !roles().any(|m| m == **r))
            .map(|r| (r, did_you_mean(r, roles())))
            .collect();
        for role in &template.members {
            // a misspelled role is not missing as well
            let misspelled = strange.iter().any(|s| s.1.contains(&format!("`{}`", role.role)));
            if !spec.members.contains_key(&role.role) && !misspelled {
                let path = format!("members.{}", role.role);
                faults.push(AssemblyError::Missing { path, about: role.about.clone() });
            }
        }
        for (role, hint) in strange {
            let path = format!("members.{role}");
            faults.push(unknown_in(
                &template.name,
                path,
                "member",
                role,
                hint,
                known_names(roles()),
            ));
        }
        if spec.bolts.is_none() && !template.bolts.is_empty() {
            faults.push(AssemblyError::Missing {
                path: "bolts".into(),
                about: "size, grade and rows of the bolts".into(),
            });
        }
        spec_checks::rest(spec, template, mu, &mut faults);
        let given = given(spec, template, &mut faults);
        AtLeastOne::refuse(faults)?;
        Ok(Self { sections, steels, bolt, given, mu, preload })
    }

    /// The names known before any parameter is resolved: `role.h`, `bolt.d` and others.
    pub fn scope(&self) -> Scope {
        let mut scope = Scope::default();
        for (role, section) in &self.sections {
            for (kind, word, _) in SectionKind::ALL {
                scope.set(format!("{role}.is_{word}"), Value::Truth(section.kind() == kind));
            }
        }
        let mut set =
            |owner: &str, key: &str, v: f64| scope.set(format!("{owner}.{key}"), Value::length(v));
        for (role, section) in &self.sections {
            for (key, v) in section.dimensions() {
                set(role, key, v);
            }
        }
        if let Some((b, _)) = self.bolt {
            for (key, v) in [
                ("d", b.d),
                ("hole", b.hole_normal),
                ("head_width", b.head_width),
                ("head_height", b.head_height),
                ("nut_width", b.nut_width),
                ("nut_height", b.nut_height),
                ("washer_outer", b.washer_outer),
                ("washer_thickness", b.washer_thickness),
            ] {
                set("bolt", key, v);
            }
        }
        scope
    }

    /// The section of a role.
    pub fn section(&self, role: &str) -> Option<Section<'a>> {
        self.sections.iter().find(|(r, _)| r == role).map(|(_, p)| *p)
    }

    /// The I section of a role; `None` also where it has another kind of section.
    pub fn profile(&self, role: &str) -> Option<&'a IProfile> {
        match self.section(role)? {
            Section::I(p) => Some(p),
            Section::Shaped(_) => None,
        }
    }

    /// Adds the material of a part and returns its key: the grade, plus the thickness if the same
    /// grade occurs with two strengths.
    pub fn steel_material(
        &self,
        spec: &ConnectionSpec,
        from: &[String],
        thickness: f64,
        materials: &mut BTreeMap<String, PartMaterial>,
    ) -> Result<String, AssemblyError> {
        let (path, steel) = self.steel(from)?;
        let fy = steel
            .fy_by(spec.code.fy_source, thickness)
            .map_err(|cause| self.at_thickness(path, thickness, cause))?;
        let fu = steel
            .fu_by(spec.code.fy_source, thickness)
            .map_err(|cause| self.at_thickness(path, thickness, cause))?;
        let strength = NominalStrength::Steel(Nominal::new(fy));
        let fu = Some(Nominal::new(fu));
        let material = PartMaterial { e: steel.e, nu: steel.nu, strength, fu };
        Ok(insert(materials, &steel.grade, thickness, material))
    }

    /// The first steel of the list that the spec gives, with its path.
    fn steel(&self, from: &[String]) -> Result<&(String, &'a Steel), AssemblyError> {
        from.iter().find_map(|f| self.steels.get(f)).ok_or_else(|| {
            let problem = format!("none of {} has a steel in the spec", from.join(", "));
            AssemblyError::TemplateEntry { at: "steel".into(), problem }
        })
    }

    /// A fault of a steel at a thickness, at the place of the parameter of the spec that gives it,
    /// else at that of the steel.
    fn at_thickness(&self, steel: &str, thickness: f64, cause: CatalogError) -> AssemblyError {
        let same = |(name, given): &(&String, &Given)| {
            name.contains("thickness") && **given == Given::One(Value::length(thickness))
        };
        let parameter = self.given.iter().find(same).map(|(name, _)| path_of(name));
        let path = match cause {
            CatalogError::Thickness { .. } => parameter,
            _ => None,
        };
        unlisted(path.unwrap_or_else(|| steel.to_owned()), cause)
    }

    /// Nominal strengths, at a given thickness \[mm\], of the first steel of the list that the spec
    /// gives.
    pub fn strength(
        &self,
        spec: &ConnectionSpec,
        from: &[String],
        thickness: f64,
    ) -> Result<Strength, AssemblyError> {
        let (path, steel) = self.steel(from)?;
        let table = spec.code.fy_source;
        let fault = |cause: CatalogError| self.at_thickness(path, thickness, cause);
        Ok(Strength {
            grade: steel.grade.clone(),
            fy: Nominal::new(steel.fy_by(table, thickness).map_err(fault)?),
            fu: Nominal::new(steel.fu_by(table, thickness).map_err(fault)?),
            e: steel.e,
            beta_w: steel.beta_w,
        })
    }

    /// Adds the material of a bolt, whose shank is meshed with the nominal area, and returns its
    /// key.
    pub fn bolt_material(
        &self,
        size: &BoltSize,
        grade: &BoltGrade,
        materials: &mut BTreeMap<String, PartMaterial>,
    ) -> String {
        let strength = NominalStrength::Bolt(BoltShank {
            fub: Nominal::new(grade.fub),
            stress_area: size.stress_area,
            shank_area: std::f64::consts::PI * size.d * size.d / 4.0,
        });
        let material = PartMaterial { e: BOLT_ELASTIC.0, nu: BOLT_ELASTIC.1, strength, fu: None };
        insert(materials, &format!("bolt_{}_{}", size.size, grade.grade), size.d, material)
    }

    /// The friction coefficient, for the list of resolved values.
    pub fn friction_resolved(&self, spec: &ConnectionSpec) -> Resolved {
        Resolved {
            name: "friction.mu".into(),
            value: Text::given(self.mu.to_string()),
            given: spec.friction.mu.is_some() || spec.friction.class.is_some(),
            default: Some("0".into()),
            range: Some("0 to 2".into()),
            about: "friction coefficient of all contact surfaces; 0 where the spec gives none"
                .into(),
            origin: None,
        }
    }

    /// The preload of a bolt, for the list of resolved values; `None` without bolts.
    pub fn preload_resolved(&self, spec: &ConnectionSpec) -> Option<Resolved> {
        let (size, grade) = self.bolt?;
        Some(Resolved {
            name: "bolts.preload".into(),
            value: self.preload.map_or("none".into(), |f| Value::force(f).text()),
            given: spec.bolts.as_ref().is_some_and(|b| b.preload.is_some()),
            default: Some("none".into()),
            range: Some(format!(
                "none, or up to {}, where the thread yields",
                Value::force(thread_yields(size, grade))
            )),
            about: "preload of a bolt: none, a part of f_ub A_s (0.7), or a force".into(),
            origin: None,
        })
    }

    /// Catalogue entries used, as role and name.
    pub fn catalogue(&self) -> Vec<(String, String)> {
        let mut out: Vec<(String, String)> = self
            .sections
            .iter()
            .map(|(r, p)| (format!("members.{r}.profile"), p.name().to_owned()))
            .collect();
        out.extend(self.steels.values().map(|(path, s)| (path.clone(), s.grade.clone())));
        if let Some((b, g)) = self.bolt {
            out.push(("bolts.size".into(), b.size.clone()));
            out.push(("bolts.grade".into(), g.grade.clone()));
        }
        out
    }
}

/// Tension at which the thread of a bolt yields \[N\].
fn thread_yields(size: &BoltSize, grade: &BoltGrade) -> f64 {
    grade.fyb * size.stress_area
}

/// The preload given in the spec \[N\], if any. It must be above zero and below the tension at
/// which the thread yields, and the grade must be suitable for preloading (EN 1993-1-8:2005 3.1.2).
fn preload(
    spec: &ConnectionSpec,
    size: &BoltSize,
    grade: &BoltGrade,
) -> Result<Option<f64>, AssemblyError> {
    let path = || "bolts.preload".to_owned();
    let strength = grade.fub * size.stress_area;
    let (force, said) = match spec.bolts.as_ref().and_then(|b| b.preload) {
        None | Some(PreloadSpec::None) => return Ok(None),
        Some(PreloadSpec::Part(part)) => (part * strength, format!("{part} f_ub A_s")),
        Some(PreloadSpec::Force(force)) => (force, format!("{} kN", number(1e-3 * force))),
    };
    if !grade.preloadable {
        return Err(AssemblyError::Value {
            path: path(),
            problem: format!(
                "bolts of grade {} are not made to be preloaded (EN 1993-1-8:2005 3.1.2)",
                grade.grade
            ),
            help: "use grade 8.8 or 10.9, or leave the preload out".into(),
        });
    }
    let most = thread_yields(size, grade);
    if force > 0.0 && limits::at_most(force, most) {
        return Ok(Some(force));
    }
    Err(AssemblyError::OutOfRange {
        path: path(),
        name: path(),
        value: said,
        range: format!(
            "above 0, up to {:.1} kN or {} f_ub A_s, at which the thread of {} {} yields; usual: \
             0.7 f_ub A_s (F_p,C)",
            most / 1e3,
            most / strength,
            size.size,
            grade.grade
        ),
    })
}

/// Inserts under the plain name, or under the name with the thickness if the plain name already has
/// other constants.
fn insert(
    materials: &mut BTreeMap<String, PartMaterial>,
    name: &str,
    thickness: f64,
    m: PartMaterial,
) -> String {
    let word: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    let key = match materials.get(&word) {
        Some(other) if *other != m => {
            format!("{word}_t{}", thickness.to_string().replace('.', "_"))
        }
        _ => word,
    };
    materials.insert(key.clone(), m);
    key
}
