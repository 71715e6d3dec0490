//! The context of a connection spec: title block, resolved values, catalogue rows, drawings.

use crate::driver::context::RunContext;
use crate::driver::demands::demands;
use crate::driver::spec_file::SpecFile;
use bracket_base::diag::Diagnostics;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_base::yaml;
use bracket_codes::check::number;
use bracket_codes::design_strengths;
use bracket_codes::end_plate::{parts_list, welds_list};
use bracket_codes::{HandChecks, joint_checks};
use bracket_joint::assembly::assembly::{FaceSupport, Part, Surface};
use bracket_joint::assembly::{Assembly, Facts};
use bracket_joint::spec::connection::ConnectionSpec;
use bracket_joint::spec::loads::ActionPoint;
use bracket_joint::strength::{Bearing, Design, DesignStrengths};
use bracket_report::document::picture::PictureRef;
use bracket_report::document::table::Table;
use bracket_report::draw::contact_map::AXES;
use bracket_report::draw::joint_drawings::JointDrawings;
use bracket_report::markdown::demand::{about_planes, on_planes};
use bracket_report::markdown::report_data::CatalogueRow;
use bracket_report::markdown::report_data::InputFacts;
use bracket_report::markdown::report_data::ResolvedValue;
use bracket_report::markdown::schedule;
use serde_json::json;
use std::collections::BTreeMap;
use std::path::Path;

/// The hand checks of a spec, with the notes of its joint.
pub fn spec_checks(input: &SpecFile) -> HandChecks {
    let mut checks = joint_checks(&input.joint);
    checks.notes.extend(input.joint.notes.iter().cloned());
    checks
}

/// What the folder of a result shows of a spec.
pub fn spec_context(path: &Path, input: &SpecFile) -> Result<RunContext, Diagnostics> {
    let project = &input.spec.value.project;
    let title = project.title.clone().filter(|t| !t.trim().is_empty());
    let stem =
        || path.file_stem().map_or_else(|| "joint".into(), |s| s.to_string_lossy().into_owned());
    let mut block = vec![("title".to_string(), title.unwrap_or_else(stem))];
    for (name, value) in [
        ("number", &project.number),
        ("author", &project.author),
        ("checker", &project.checker),
        ("date", &project.date),
        ("revision", &project.revision),
    ] {
        block.extend(value.clone().map(|v| (name.to_string(), v)));
    }
    let joint = &input.joint;
    let JointDrawings { pictures, workshop, frame, axial_moment } =
        JointDrawings::new(joint.facts.as_ref(), &joint.content, project.language);
    let (drawings, texts): (Vec<PictureRef>, Vec<String>) = pictures.into_iter().unzip();
    let names = drawings.iter().map(|d| d.file.clone());
    let mut files: Vec<(String, String)> = names.zip(texts).collect();
    files.extend(workshop);
    let welds = welds_list(joint.facts.as_ref(), &joint.content);
    Ok(RunContext {
        input: InputFacts {
            project: block,
            language: project.language,
            name: path.file_name().map_or_else(String::new, |s| s.to_string_lossy().into_owned()),
            text: input.text.clone(),
            read: yaml::to_string(&as_read(input))?,
            resolved: resolved_values(input),
            demands: demands(&input.spec.value.loads),
            plane_note: about_planes(input.joint.facts.as_ref().map_or(&[], Facts::actions)),
            plane_actions: plane_actions(input),
            catalogue_rows: catalogue_rows(input),
            drawings,
            schedule: schedule::schedule(&parts_list(&input.joint.content)),
            welds: schedule::welds(&welds),
            butt_welds: schedule::has_butt_welds(&welds),
            supports: supports(&input.joint.assembly, &design_strengths(&input.joint)),
        },
        rotation: frame,
        axial_moment,
        files,
    })
}

/// The rows of the user's own tables as text for the input hash. It is needed because no model
/// contains the values that only the hand checks read.
pub fn own_rows(input: &SpecFile) -> String {
    catalogue_rows(input)
        .iter()
        .filter(|r| r.own)
        .map(|r| format!("{}: {:?}\n", r.name, r.values))
        .collect()
}

/// The spec without the loads that were generated from its polygon.
fn as_read(input: &SpecFile) -> ConnectionSpec {
    let mut spec = input.spec.value.clone();
    spec.loads.retain(|l| !l.of_polygon);
    spec.loads = spec.loads.as_given();
    spec
}

/// The actions at the bolt planes, where the spec gives them elsewhere.
fn plane_actions(input: &SpecFile) -> Table {
    let points = input.spec.value.loads.iter().filter_map(|l| l.at);
    let moved = points.into_iter().any(|at| at != ActionPoint::BoltPlane);
    let facts = input.joint.facts.as_ref().filter(|_| moved);
    facts.map_or_else(Default::default, |f| on_planes(f.actions()))
}

/// The supports of the model, with the section that each holds. Ground has its bearing strength.
fn supports(assembly: &Assembly, strengths: &DesignStrengths) -> Table {
    let row = |support: &FaceSupport| -> Option<[Text; 4]> {
        let face = assembly.faces.iter().find(|f| f.name == support.face)?;
        let held: Vec<&str> =
            AXES.into_iter().zip(support.fix).filter(|(_, fix)| *fix).map(|(a, _)| a).collect();
        let place = match face.surface {
            Surface::Plane { axis, at, .. } => format!("{} = {} mm", AXES[axis], number(at)),
            Surface::Mantle { radius, .. } => format!("r = {} mm", number(radius)),
        };
        let held = match strengths.ground.get(&support.face) {
            Some(Bearing { strength: f, stiffness: None }) => {
                say!("pressure up to {} MPa", number(f.mpa()))
            }
            Some(Bearing { strength: f, stiffness: Some(k) }) => say!(
                "pressure up to {} MPa; elastic: {} N/mm³",
                number(f.mpa()),
                number((1e3 * k).round() / 1e3)
            ),
            None => Text::given(held.join(" ")),
        };
        let [name, part] = [&face.name, &face.part].map(Text::given);
        Some([name, part, Text::given(place), held])
    };
    let columns = ["support", "part", "section", "held along"];
    Table::new(columns, assembly.supports.iter().filter_map(row))
}

/// The values of the joint with their origin.
fn resolved_values(input: &SpecFile) -> Vec<ResolvedValue> {
    let value = |name: String, strength: Design, origin: Text| ResolvedValue {
        name,
        value: number(strength.mpa()).into(),
        unit: "MPa".into(),
        origin,
    };
    let DesignStrengths { materials, bolts, perforated, .. } = design_strengths(&input.joint);
    let parts = &input.joint.assembly.parts;
    // parts with the same key share the least of their strengths
    let least = |of: &dyn Fn(&Part) -> Option<Design>| -> BTreeMap<&String, Design> {
        let mut out: BTreeMap<&String, Design> = BTreeMap::new();
        for (key, f) in parts.iter().filter_map(|p| Some((&p.material, of(p)?))) {
            let kept = out.entry(key).or_insert(f);
            if f.mpa() < kept.mpa() {
                *kept = f;
            }
        }
        out
    };
    let cut = |p: &Part| input.joint.assembly.sections.iter().any(|s| s.part == p.name);
    let shanks = least(&|p| bolts.get(&p.name).filter(|_| cut(p)).map(|b| b.shank));
    let net = least(&|p| {
        let net = *perforated.get(&p.name)?;
        let fyd = (*materials.get(&p.material)?)?;
        (net.mpa() < fyd.mpa()).then_some(net)
    });
    let strength = |(name, fy): (&String, &Option<Design>)| {
        let path = format!("materials.{name}.fy");
        let origin = match shanks.contains_key(name) {
            false => "yield strength in the analyses",
            true => "yield strength in elastoplastic analysis",
        };
        Some(value(path, (*fy)?, origin.into()))
    };
    let strengths = materials.iter().filter_map(strength);
    let limited = shanks.iter().map(|(name, fy)| {
        let origin = "yield strength in limit analysis, beside the limits of the bolt's forces";
        value(format!("materials.{name}.fy (limit)"), *fy, origin.into())
    });
    let weaker = net.iter().map(|(name, fy)| {
        let origin = "yield strength of parts with holes in the analyses";
        value(format!("materials.{name}.fy (with holes)"), *fy, origin.into())
    });
    input
        .joint
        .resolved
        .iter()
        .map(|r| {
            // in a list every entry has its unit
            let text = r.value.to_string();
            let (value, unit) = match text.split_once(' ') {
                Some((value, unit)) if !text.starts_with('[') => (Text::given(value), unit),
                _ => (r.value.clone(), ""),
            };
            let origin = match (&r.default, r.given) {
                _ if r.origin.is_some() => r.origin.clone().unwrap_or_default(),
                (_, true) => "given".into(),
                (Some(expression), false) => say!("default `{}`", expression),
                (None, false) => "default".into(),
            };
            ResolvedValue { name: r.name.clone(), value, unit: unit.into(), origin }
        })
        .chain(strengths)
        .chain(limited)
        .chain(weaker)
        .collect()
}

/// The catalogue rows that provide values of the joint.
fn catalogue_rows(input: &SpecFile) -> Vec<CatalogueRow> {
    let c = &input.catalog;
    let mut rows: Vec<CatalogueRow> = Vec::new();
    for (role, name) in &input.joint.catalogue {
        let (kind, row) = if role.ends_with(".profile") {
            ("profile", c.profile(name).map(|r| json!(r)))
        } else if role.ends_with("bolts.size") {
            ("bolt", c.bolt(name).map(|r| json!(r)))
        } else if role.ends_with("bolts.grade") {
            ("bolt grade", c.bolt_grade(name).map(|r| json!(r)))
        } else {
            ("steel", c.steel(name).map(|r| json!(r)))
        };
        // the joint was built with the same names, so every row exists
        let Ok(row) = row else { continue };
        let standard = row["standard"].as_str().unwrap_or_default();
        let file = row["source"]["file"].as_str().unwrap_or_default();
        let provenance = c.provenance(file);
        let builtin = provenance.and_then(|p| p.standard.clone());
        let own = builtin.is_none();
        let source = builtin.unwrap_or_else(|| {
            // for the user's own tables the report names file and line, so that the row can be
            // checked
            let line = say!("{} line {}", file.to_owned(), row["source"]["line"].to_string());
            let read_from = provenance.map(|p| Text::given(&p.read_from)).unwrap_or_default();
            let standard = (!standard.is_empty()).then(|| Text::given(standard));
            Text::joined("; ", [standard.unwrap_or_default(), line, read_from])
        });
        if !rows.iter().any(|r| r.kind == kind && r.name == *name) {
            rows.push(CatalogueRow { own, ..catalogue_row(kind, name, row, source) });
        }
    }
    rows
}

/// Values of a catalogue row as the report shows them.
fn catalogue_row(
    kind: &'static str,
    name: &str,
    row: serde_json::Value,
    source: Text,
) -> CatalogueRow {
    let values = row.as_object().map_or(Vec::new(), |fields| {
        fields
            .iter()
            .filter(|(key, _)| {
                !["name", "size", "grade", "source", "series", "standard"].contains(&key.as_str())
            })
            .filter_map(|(key, v)| match v {
                serde_json::Value::Number(n) => Some((key.clone(), n.to_string())),
                serde_json::Value::String(s) => Some((key.clone(), s.clone())),
                serde_json::Value::Bool(b) => {
                    Some((key.clone(), if *b { "yes" } else { "no" }.into()))
                }
                _ => None,
            })
            .collect()
    });
    CatalogueRow { kind: kind.into(), name: name.into(), source, values, own: false }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::driver::spec_file;

    #[test]
    fn rows_of_an_own_table_show_their_file_and_line() {
        let dir = tempfile::tempdir().expect("a folder");
        let table = "grade,fyb_MPa,fub_MPa,alpha_v_threads_in_shear_plane,\
                     alpha_v_shank_in_shear_plane,preloadable\nMY8.8,640,800,0.6,0.6,yes\n";
        let spec =
            include_str!("../../examples/paper_joint/joint.yaml").replace("\"8.8\"", "MY8.8");
        for (name, text) in [("g.csv", table), ("joint.yaml", &spec)] {
            std::fs::write(dir.path().join(name), text).expect("written");
        }
        let input = spec_file::read(&dir.path().join("joint.yaml"), Some(dir.path()))
            .unwrap_or_else(|e| panic!("{e:#?}"));
        let rows = catalogue_rows(&input);
        let own: Vec<&CatalogueRow> = rows.iter().filter(|r| r.own).collect();
        assert_eq!(own.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["MY8.8"]);
        assert!(own[0].source.to_string().ends_with("g.csv line 2"), "{}", own[0].source);
        assert!(
            rows.iter().any(|r| r.name == "HEB200" && r.source.to_string().starts_with("EN 10365")),
            "{rows:#?}"
        );
    }

    #[test]
    fn the_input_as_read_is_the_spec_without_comments_and_polygon_directions_and_reads_back() {
        let dir = tempfile::tempdir().expect("a folder");
        let text = "# a comment\ntemplate: beam_to_column_end_plate\nmembers: {column: {profile: \
                    HEB200, steel: S235}, beam: {profile: IPE300, steel: S235}}\nplate: \
                    {thickness: 5/8 in}\nbolts: {size: M20, grade: '8.8', rows: [-90, 90, \
                    190]}\nloads: [{name: ULS1, end: beam_right, at: column_face, My: 80 kN m, \
                    Vz: -60.5 kN}]\npolygon: {end: beam_right, at: column_face, My: 100 kN m, N: \
                    200 kN}\nanalysis: {kind: limit}\n";
        std::fs::write(dir.path().join("joint.yaml"), text).expect("written");
        let input = spec_file::read(&dir.path().join("joint.yaml"), None)
            .unwrap_or_else(|e| panic!("{e:#?}"));
        assert!(input.spec.value.loads.len() > 1, "the polygon has directions");
        let context = yaml::to_string(&as_read(&input)).expect("YAML");
        for words in
            ["My: 80 kN m", "Vz: -60.5 kN", "thickness: 15.875 mm", "polygon:", "target_gap: 0.05"]
        {
            assert!(context.contains(words), "{words} in\n{context}");
        }
        assert!(!context.contains("comment") && context.matches("name:").count() == 1, "{context}");
        let again = yaml::parse::<ConnectionSpec>(&context, Path::new("context.yaml"))
            .unwrap_or_else(|e| panic!("{e:#?}"));
        assert_eq!(again.value, as_read(&input));
    }
}
