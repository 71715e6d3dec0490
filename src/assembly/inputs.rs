//! What the spec says, checked against template and catalogue: profiles, steels, bolts, parameter
//! values, friction.

use super::assembly::PartMaterial;
use super::end_plate::Strength;
use super::error::AssemblyError;
use super::factors::PartialFactors;
use super::scope::{Given, Resolved, Scope, path_of};
use super::template::{Parameter, ParameterKind, Template};
use super::{actions, categories};
use crate::catalog::{BoltGrade, BoltSize, Catalog, CatalogError, IProfile, Steel};
use crate::diag::did_you_mean;
use crate::spec::analysis::AnalysisKind;
use crate::spec::analysis::MeshSize;
use crate::spec::connection::{ConnectionSpec, ParameterValue, PreloadSpec};
use crate::spec::expr::Value;
use crate::spec::friction::FrictionLaw;
use crate::units::{self, Length};
use std::collections::BTreeMap;

/// Young's modulus and Poisson's ratio of bolts (EN 1993-1-1, 3.2.6) \[MPa\].
const BOLT_ELASTIC: (f64, f64) = (210_000.0, 0.3);
/// System lengths of members \[mm\].
const SYSTEM_LENGTHS: std::ops::RangeInclusive<f64> = 100.0..=100e3;
/// k2 of EN 1993-1-8:2005 Table 3.4 for bolts that are not countersunk.
pub const K2: f64 = 0.9;

/// Catalogue rows and values of one spec.
pub struct Inputs<'a> {
    profiles: Vec<(String, &'a IProfile)>,
    steels: BTreeMap<String, (String, &'a Steel)>,
    /// Size and grade, if the spec has bolts.
    pub bolt: Option<(&'a BoltSize, &'a BoltGrade)>,
    /// What the spec says about parameters.
    pub given: BTreeMap<String, Given>,
    /// FrictionLaw coefficient.
    pub mu: f64,
    /// Preload of a bolt \[N\], if the bolts are preloaded.
    pub preload: Option<f64>,
    factors: PartialFactors,
}

fn list<'b>(names: impl Iterator<Item = &'b str>) -> String {
    let all: Vec<&str> = names.collect();
    if all.is_empty() { "nothing".to_owned() } else { all.join(", ") }
}

fn unlisted(path: String, cause: CatalogError) -> AssemblyError {
    AssemblyError::Catalog { path, cause: cause.into() }
}

impl<'a> Inputs<'a> {
    /// Reads a spec; reports every fault it can find at once.
    pub fn read(
        spec: &ConnectionSpec,
        template: &Template,
        catalog: &'a Catalog,
    ) -> Result<Self, Vec<AssemblyError>> {
        let mut faults = Vec::new();
        let mut profiles = Vec::new();
        let mut steels = BTreeMap::new();
        for (role, member) in &spec.members {
            match catalog.profile(&member.profile) {
                Ok(p) => profiles.push((role.clone(), p)),
                Err(e) => faults.push(unlisted(format!("members.{role}.profile"), e)),
            }
            match catalog.steel(&member.steel) {
                Ok(s) => drop(steels.insert(role.clone(), (format!("members.{role}.steel"), s))),
                Err(e) => faults.push(unlisted(format!("members.{role}.steel"), e)),
            }
        }
        let lengths = spec.members.iter().filter_map(|(role, m)| Some((role, m.length?.0)));
        for (role, length) in lengths.filter(|(_, l)| !SYSTEM_LENGTHS.contains(l)) {
            faults.push(AssemblyError::Value {
                path: format!("members.{role}.length"),
                problem: format!("a system length of {length} mm; allowed: from 100 mm to 100 m"),
                help: "give the distance between the centres of the columns, with its unit: \
                       `length: 6 m`"
                    .into(),
            });
        }
        column_forces(spec, template, &mut faults);
        if let Some(name) = spec.plate.as_ref().and_then(|p| p.steel.as_ref()) {
            match catalog.steel(name) {
                Ok(s) => drop(steels.insert("plate".into(), ("plate.steel".into(), s))),
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
        let factors = PartialFactors::read(&spec.code, catalog, &mut faults);
        let mu = match (spec.friction.mu, &spec.friction.class) {
            (None, Some(c)) => catalog.friction_class(c).map(|f| f.mu).unwrap_or_else(|e| {
                faults.push(unlisted("friction.class".into(), e));
                0.0
            }),
            (mu, _) => mu.unwrap_or(0.0),
        };
        for role in &template.members {
            if !spec.members.contains_key(&role.role) {
                let path = format!("members.{}", role.role);
                faults.push(AssemblyError::Missing { path, about: role.about.clone() });
            }
        }
        for role in spec.members.keys().filter(|r| !template.members.iter().any(|m| m.role == **r))
        {
            let roles = || template.members.iter().map(|m| m.role.as_str());
            let path = format!("members.{role}");
            faults.push(unknown(
                template,
                path,
                "member",
                role,
                did_you_mean(role, roles()),
                list(roles()),
            ));
        }
        if spec.bolts.is_none() && !template.bolts.is_empty() {
            faults.push(AssemblyError::Missing {
                path: "bolts".into(),
                about: "size, grade and rows of the bolts".into(),
            });
        }
        numbers(spec, &mut faults);
        coulomb_estimate(spec, mu, &mut faults);
        loads(spec, template, &mut faults);
        categories::check(spec, &mut faults);
        let given = given(spec, template, &mut faults);
        if faults.is_empty() {
            Ok(Self { profiles, steels, bolt, given, mu, preload, factors })
        } else {
            Err(faults)
        }
    }

    /// The names that stand before any parameter: `role.h`, `bolt.d` and so on.
    pub fn scope(&self) -> Scope {
        let mut scope = Scope::default();
        let mut set =
            |owner: &str, key: &str, v: f64| scope.set(format!("{owner}.{key}"), Value::length(v));
        for (role, p) in &self.profiles {
            for (key, v) in [("h", p.h), ("b", p.b), ("tw", p.tw), ("tf", p.tf), ("r", p.r)] {
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

    /// The profile of a role.
    pub fn profile(&self, role: &str) -> Option<&'a IProfile> {
        self.profiles.iter().find(|(r, _)| r == role).map(|(_, p)| *p)
    }

    /// Adds the material of a part and returns its key: grade, and thickness where two strengths of
    /// a grade meet.
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
            .map_err(|cause| AssemblyError::Catalog { path: path.clone(), cause: cause.into() })?;
        let material =
            PartMaterial { e: steel.e, nu: steel.nu, fy: Some(fy / self.factors.gamma_m0) };
        Ok(insert(materials, &steel.grade, thickness, material))
    }

    /// The first steel that the spec gives, with its path.
    fn steel(&self, from: &[String]) -> Result<&(String, &'a Steel), AssemblyError> {
        from.iter().find_map(|f| self.steels.get(f)).ok_or_else(|| {
            let problem = format!("none of {} has a steel in the spec", from.join(", "));
            AssemblyError::TemplateEntry { at: "steel".into(), problem }
        })
    }

    /// Nominal strengths of the first steel that the spec gives, at a thickness \[mm\].
    pub fn strength(
        &self,
        spec: &ConnectionSpec,
        from: &[String],
        thickness: f64,
    ) -> Result<Strength, AssemblyError> {
        let (path, steel) = self.steel(from)?;
        let table = spec.code.fy_source;
        let fault = |cause: CatalogError| AssemblyError::Catalog {
            path: path.clone(),
            cause: cause.into(),
        };
        Ok(Strength {
            grade: steel.grade.clone(),
            fy: steel.fy_by(table, thickness).map_err(fault)?,
            fu: steel.fu_by(table, thickness).map_err(fault)?,
            e: steel.e,
            beta_w: steel.beta_w,
        })
    }

    /// What the reader of the report must know about factors and grades: partial factors below the
    /// recommended ones, ASTM steels and bolts under the checks of a European code.
    pub fn notes(&self) -> Vec<String> {
        let foreign = |standard: &str| standard.starts_with("ASTM");
        let mut grades: Vec<String> = Vec::new();
        let steels = self
            .steels
            .values()
            .filter(|(_, s)| foreign(&s.standard))
            .map(|(_, s)| s.grade.clone());
        let bolts = self.bolt.iter().filter(|(_, g)| g.standard.as_deref().is_some_and(foreign));
        for name in steels.chain(bolts.map(|(_, g)| format!("bolts {}", g.grade))) {
            if !grades.contains(&name) {
                grades.push(name);
            }
        }
        let mut out = self.factors.low.clone();
        if grades.is_empty() {
            return out;
        }
        let text = "the checks are those of EN 1993-1-8, which does not list them; the checks of \
                    AISC 360 are not in this edition";
        out.push(format!("grades of ASTM standards ({}): {text}", grades.join(", ")));
        out
    }

    /// The partial factors with their origins.
    pub fn partial_factors(&self) -> &PartialFactors {
        &self.factors
    }

    /// Adds the material of a bolt: its shank, meshed with the nominal area, yields at F_t,Rd of EN
    /// 1993-1-8 Table 3.4.
    pub fn bolt_material(
        &self,
        size: &BoltSize,
        grade: &BoltGrade,
        materials: &mut BTreeMap<String, PartMaterial>,
    ) -> String {
        let area = std::f64::consts::PI * size.d * size.d / 4.0;
        let fy = K2 * grade.fub * size.stress_area / self.factors.gamma_m2 / area;
        let material = PartMaterial { e: BOLT_ELASTIC.0, nu: BOLT_ELASTIC.1, fy: Some(fy) };
        insert(materials, &format!("bolt_{}_{}", size.size, grade.grade), size.d, material)
    }

    /// The friction coefficient, for the list of resolved values.
    pub fn friction_resolved(&self, spec: &ConnectionSpec) -> Resolved {
        Resolved {
            name: "friction.mu".into(),
            value: self.mu.to_string(),
            given: spec.friction.mu.is_some() || spec.friction.class.is_some(),
            default: Some("0".into()),
            range: Some("0 to 2".into()),
            about: "friction coefficient of all contact surfaces; 0 where the spec gives none"
                .into(),
            origin: None,
        }
    }

    /// The preload of a bolt, for the list of resolved values; absent without bolts.
    pub fn preload_resolved(&self, spec: &ConnectionSpec) -> Option<Resolved> {
        let (size, grade) = self.bolt?;
        Some(Resolved {
            name: "bolts.preload".into(),
            value: self.preload.map_or("none".into(), |f| Value::force(f).to_string()),
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

    /// Catalogue entries used: role and name.
    pub fn catalogue(&self) -> Vec<(String, String)> {
        let mut out: Vec<(String, String)> = self
            .profiles
            .iter()
            .map(|(r, p)| (format!("members.{r}.profile"), p.name.clone()))
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

/// The preload a spec asks for \[N\], if any: above zero, below what the thread yields at, of a
/// grade made for it (EN 1993-1-8:2005
/// 3.1.2).
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
        Some(PreloadSpec::Force(force)) => (force, Value::force(force).to_string()),
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
    if force > 0.0 && force <= most {
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

/// Inserts under the plain name, or with the thickness when that name has other constants already.
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

fn unknown(
    t: &Template,
    path: String,
    noun: &'static str,
    name: &str,
    hint: String,
    known: String,
) -> AssemblyError {
    let problem = format!("template `{}` has no {noun} `{name}`{hint}", t.name);
    AssemblyError::Unknown { path, problem, known }
}

/// Forces beside the joint are read of the column alone: elsewhere they would be ignored.
fn column_forces(spec: &ConnectionSpec, template: &Template, faults: &mut Vec<AssemblyError>) {
    let column = template.hand_checks.as_ref().and_then(|h| h.column.as_ref());
    for (role, m) in spec.members.iter().filter(|(role, _)| Some(*role) != column) {
        let given =
            [("N_Ed", m.n_ed.is_some()), ("M_Ed", m.m_ed.is_some()), ("V_Ed", m.v_ed.is_some())];
        for (key, _) in given.into_iter().filter(|g| g.1) {
            faults.push(AssemblyError::Value {
                path: format!("members.{role}.{key}"),
                problem: format!(
                    "`{key}` is a force of the column beside the joint; `{role}` is none"
                ),
                help: "forces at the end of a beam stand under `loads`".into(),
            });
        }
    }
}

/// Checks of the fixed part that no template has to repeat.
fn numbers(spec: &ConnectionSpec, faults: &mut Vec<AssemblyError>) {
    let mut range = |path: &str, value: f64, ok: bool, range: &str| {
        if !ok {
            let name = path.to_owned();
            let (value, range) = (value.to_string(), range.to_owned());
            faults.push(AssemblyError::OutOfRange { path: path.into(), name, value, range });
        }
    };
    let a = &spec.analysis;
    let mu = spec.friction.mu.unwrap_or(0.0);
    range("friction.mu", mu, (0.0..=2.0).contains(&mu), "0 to 2 (0: frictionless)");
    range(
        "analysis.target_gap",
        a.target_gap,
        a.target_gap > 0.0 && a.target_gap < 1.0,
        "between 0 and 1, a fraction: 0.05 is 5 %",
    );
    range("analysis.max_passes", f64::from(a.max_passes), a.max_passes >= 1, "at least 1");
    range("analysis.max_macro_tets", a.max_macro_tets as f64, a.max_macro_tets >= 1, "at least 1");
    let n = a.mesh.segments;
    range(
        "analysis.mesh.segments",
        f64::from(n),
        (12..=48).contains(&n) && n.is_multiple_of(2),
        "even, 12 to 48",
    );
    if let MeshSize::Fixed(Length(h)) = a.mesh.size {
        range("analysis.mesh.size", h, (0.5..=1000.0).contains(&h), "0.5 mm to 1000 mm, or `auto`");
    }
    if spec.friction.mu.is_some() && spec.friction.class.is_some() {
        faults.push(AssemblyError::Value {
            path: "friction.class".into(),
            problem: "`mu` and `class` are both given".into(),
            help: "keep one of them: `class` takes mu from the catalogue".into(),
        });
    }
}

/// An estimate under Coulomb's law needs limit analysis and that law.
fn coulomb_estimate(spec: &ConnectionSpec, mu: f64, faults: &mut Vec<AssemblyError>) {
    let a = &spec.analysis;
    let (problem, help) = match () {
        _ if !a.coulomb_estimate => return,
        _ if !a.kind.0.contains(&AnalysisKind::Limit) => (
            "it estimates the load factor of limit analysis, which `kind` does not ask for",
            "write `kind: limit` or a list with `limit`, or leave `coulomb_estimate` out",
        ),
        _ if spec.friction.law != FrictionLaw::Coulomb => (
            "the law of friction is `associated`: there is nothing to estimate beside its bracket",
            "write `law: coulomb` under `friction`, or leave `coulomb_estimate` out",
        ),
        _ if mu == 0.0 => (
            "without friction there is nothing to estimate beside the bracket",
            "give `mu` or `class` under `friction`, or leave `coulomb_estimate` out",
        ),
        () => return,
    };
    let path = "analysis.coulomb_estimate".into();
    faults.push(AssemblyError::Value { path, problem: problem.into(), help: help.into() });
}

fn loads(spec: &ConnectionSpec, template: &Template, faults: &mut Vec<AssemblyError>) {
    if spec.loads.is_empty() {
        let about = "what acts on the joint; for example `{name: TOP, section: column_top, \
                     pressure: 45 MPa}`";
        faults.push(AssemblyError::Missing { path: "loads".into(), about: about.into() });
    }
    let sections = || template.sections.iter().map(|s| s.name.as_str());
    for (i, l) in spec.loads.iter().enumerate() {
        let path = l.path(i);
        // the directions of a polygon are alike: one of them is told
        if l.of_polygon && spec.loads[..i].iter().any(|o| o.of_polygon) {
            continue;
        }
        if actions::is_at_an_end(l) {
            actions::check(&spec.loads, i, template, faults);
            continue;
        }
        let mut value = |problem: String, help: &str| {
            faults.push(AssemblyError::Value { path: path.clone(), problem, help: help.into() });
        };
        match &l.section {
            None => value(
                "the load does not say where it acts".into(),
                "add `section: …`; `bracket templates NAME` lists them",
            ),
            Some(s) if !sections().any(|k| k == s) => {
                let hint = did_you_mean(s, sections());
                let at = format!("{path}.section");
                faults.push(unknown(template, at, "section", s, hint, list(sections())));
                continue;
            }
            Some(s) => {
                if spec.loads[..i].iter().any(|o| o.section.as_ref() == Some(s) && o.name == l.name)
                {
                    value(
                        format!("load case `{}` already loads `{s}`", l.name),
                        "give it another name, or add the values",
                    );
                }
            }
        }
        if l.pressure.is_some() == l.traction.is_some() {
            faults.push(AssemblyError::Value {
                path: path.clone(),
                problem: "a load on a section has `pressure` or `traction`, one of them".into(),
                help: "write `pressure: 45 MPa` (positive pushes on the face) or `traction: [0 \
                       MPa, 0 MPa, -45 MPa]`"
                    .into(),
            });
        }
    }
}

/// What the spec says about the template's parameters, by name.
fn given(
    spec: &ConnectionSpec,
    template: &Template,
    faults: &mut Vec<AssemblyError>,
) -> BTreeMap<String, Given> {
    let one = |l: Length| Given::One(Value::length(l.0));
    let many = |l: &[Length]| Given::Many(l.iter().map(|x| x.0).collect());
    let mut out = BTreeMap::new();
    if let Some(p) = &spec.plate {
        out.extend(p.thickness.map(|v| ("plate.thickness".to_owned(), one(v))));
        out.extend(p.width.map(|v| ("plate.width".to_owned(), one(v))));
        out.extend(p.z.as_ref().map(|v| ("plate.z".to_owned(), many(v))));
    }
    if let Some(b) = &spec.bolts {
        out.extend(b.gauge.map(|v| ("bolts.gauge".to_owned(), one(v))));
        out.extend(b.rows.as_ref().map(|v| ("bolts.rows".to_owned(), many(v))));
    }
    let find = |name: &str| template.parameters.iter().find(|p| p.name == name);
    for (name, value) in &spec.parameters {
        match find(name).filter(|p| path_of(&p.name).starts_with("parameters.")) {
            Some(p) => match parameter(p, value) {
                Ok(v) => drop(out.insert(name.clone(), v)),
                Err((problem, help)) => {
                    faults.push(AssemblyError::Value {
                        path: format!("parameters.{name}"),
                        problem,
                        help,
                    });
                }
            },
            None => {
                let names = || {
                    template.parameters.iter().map(|p| p.name.as_str()).filter(|n| !n.contains('.'))
                };
                let path = format!("parameters.{name}");
                faults.push(unknown(
                    template,
                    path,
                    "parameter",
                    name,
                    did_you_mean(name, names()),
                    list(names()),
                ));
            }
        }
    }
    for name in out.keys().filter(|n| find(n).is_none()) {
        let names = || template.parameters.iter().map(|p| p.name.as_str());
        faults.push(unknown(
            template,
            path_of(name),
            "parameter",
            name,
            did_you_mean(name, names()),
            list(names()),
        ));
    }
    for (name, value) in &out {
        let (Some(Parameter { count: Some(n), .. }), Given::Many(list)) = (find(name), value)
        else {
            continue;
        };
        if list.len() != *n {
            let problem = format!("{} values are given, {n} are wanted", list.len());
            let help = find(name).map_or_else(String::new, |p| p.about.clone());
            faults.push(AssemblyError::Value { path: path_of(name), problem, help });
        }
    }
    for (name, value) in &out {
        if matches!(value, Given::Many(list) if list.is_empty()) {
            let help = find(name).map_or_else(String::new, |p| p.about.clone());
            faults.push(AssemblyError::Value {
                path: path_of(name),
                problem: "the list is empty".into(),
                help: format!("give at least one value: {help}"),
            });
        }
    }
    out
}

fn parameter(p: &Parameter, value: &ParameterValue) -> Result<Given, (String, String)> {
    let wanted = match p.kind {
        ParameterKind::Length => "write a length: mm, cm, m, in, or a bare number for mm",
        ParameterKind::Number => "write a plain number",
        ParameterKind::Flag => "write true or false",
        ParameterKind::Lengths => "write a list of lengths: [-100 mm, 100 mm]",
    };
    let quantity = |r: Result<f64, units::UnitError>| {
        r.map(|v| Given::One(Value::length(v))).map_err(|e| (e.to_string(), wanted.to_owned()))
    };
    match (p.kind, value) {
        (ParameterKind::Length, ParameterValue::Number(x)) => {
            quantity(units::bare(*x, units::Kind::Length))
        }
        (ParameterKind::Length, ParameterValue::Text(t)) => {
            quantity(units::parse(t, units::Kind::Length))
        }
        (ParameterKind::Number, ParameterValue::Number(x)) => Ok(Given::One(Value::number(*x))),
        (ParameterKind::Flag, ParameterValue::Flag(f)) => Ok(Given::One(Value::Truth(*f))),
        (ParameterKind::Lengths, ParameterValue::List(l)) => {
            Ok(Given::Many(l.iter().map(|x| x.0).collect()))
        }
        _ => Err((format!("the value does not fit: {}", p.about), wanted.to_owned())),
    }
}

/// The template's conditions on the values.
pub fn rules(template: &Template, scope: &Scope) -> Result<(), Vec<AssemblyError>> {
    let mut faults = Vec::new();
    for check in &template.checks {
        let at = |cause| {
            vec![AssemblyError::Template { at: format!("checks: {}", check.that.text()), cause }]
        };
        for s in scope.turns(&check.each, check.when.as_ref()).map_err(at)? {
            if !s.truth(&check.that).map_err(at)? {
                faults.push(AssemblyError::Rule {
                    path: s.text(&check.at).map_err(at)?,
                    message: s.text(&check.say).map_err(at)?,
                    help: s.text(&check.help).map_err(at)?,
                });
            }
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}
