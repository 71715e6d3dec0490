//! `bracket new`.

use super::common::{CommandResult, Common};
use bracket_base::diag::{AtLeastOne, Diagnostic, Diagnostics, ExitStatus};
use bracket_base::units::{self, Length};
use bracket_joint::assembly::inputs::Inputs;
use bracket_joint::assembly::origin::Origin;
use bracket_joint::assembly::scope::Resolved;
use bracket_joint::assembly::template::Template;
use bracket_joint::assembly::template_file;
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::analysis::AnalysisSpec;
use bracket_joint::spec::connection::{
    BoltSpec, ConnectionSpec, MemberSpec, ParameterValue, PlateSpec,
};
use bracket_joint::spec::loads::{ActionPoint, LoadSpec};
use bracket_report::console::out;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Component, Path, PathBuf};

/// Size and grade of the bolts in the starter.
const BOLT: (&str, &str) = ("M18", "8.8");

/// Write a commented starter spec.
#[derive(Debug, clap::Args)]
pub struct NewArgs {
    /// Connection template (`bracket templates`), or the path of your own.
    #[arg(value_name = "TEMPLATE")]
    pub template: String,
    /// File to write; it must not exist. Without it the starter goes to standard output.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Runs `bracket new`.
pub fn run(args: &NewArgs, common: &Common) -> CommandResult {
    let (template, origin) =
        template_file::load(&args.template, Path::new(".")).map_err(named_on_the_command_line)?;
    let catalog = Catalog::builtin().map_err(Diagnostic::from)?;
    let name = match (&args.output, &origin) {
        (Some(spec), Origin::File { file, .. }) => seen_from(file, spec),
        _ => args.template.clone(),
    };
    let text = starter(&template, &origin, &name, &catalog, &today())?;
    let Some(path) = &args.output else {
        out::data(&text)?;
        return Ok(ExitStatus::Ok);
    };
    write_new(path, &text)?;
    if !common.quiet {
        let path = path.display();
        out::remark(&format!(
            "wrote {path}; check it with `bracket check {path}`, run it with `bracket run {path}`"
        ));
    }
    Ok(ExitStatus::Ok)
}

/// Whether a joint of the template stands on concrete.
fn on_ground(template: &Template) -> bool {
    template.supports.iter().any(|s| s.ground.is_some())
}

/// Today's date in ISO form, from the machine's clock in UTC.
fn today() -> String {
    let since = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    // a clock before 1970 gives no date; 1970-01-01 shows that the clock is wrong
    iso_date(since.map_or(0, |d| d.as_secs() / 86_400))
}

/// The date `days` days after 1970-01-01.
fn iso_date(days: u64) -> String {
    let leap = |y: u64| y.is_multiple_of(4) && (!y.is_multiple_of(100) || y.is_multiple_of(400));
    let (mut year, mut left) = (1970, days);
    while left >= 365 + u64::from(leap(year)) {
        left -= 365 + u64::from(leap(year));
        year += 1;
    }
    let mut month = 1;
    for days in [31, 28 + u64::from(leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if left < days {
            break;
        }
        left -= days;
        month += 1;
    }
    format!("{year:04}-{month:02}-{:02}", left + 1)
}

/// Removes the YAML path from faults without a file: a template named on the command line has no
/// place in a spec.
pub fn named_on_the_command_line(mut faults: Diagnostics) -> Diagnostics {
    faults.iter_mut().filter(|d| d.place.file.is_none()).for_each(|d| d.place.path = None);
    faults
}

/// The path of a template as the spec at `spec` must give it: relative to the spec's folder. The
/// path is absolute if the user gave an absolute one or if no relative path exists.
fn seen_from(template: &Path, spec: &Path) -> String {
    let plain = || template.display().to_string();
    let folder = spec.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let (Ok(file), Ok(folder)) = (template.canonicalize(), folder.canonicalize()) else {
        return plain();
    };
    if template.is_absolute() {
        return plain();
    }
    let shared = file.components().zip(folder.components()).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return file.display().to_string();
    }
    let up = folder.components().skip(shared).map(|_| Component::ParentDir);
    let path: PathBuf = up.chain(file.components().skip(shared)).collect();
    let text = path.display().to_string();
    // a name without folder would be read as that of a shipped template
    if template_file::is_path(&text) { text } else { format!("./{text}") }
}

/// Writes a file that must not exist yet. If the disk is full, nothing is left behind.
fn write_new(path: &Path, text: &str) -> Result<(), Diagnostics> {
    let fault = |e: std::io::Error| match e.kind() {
        std::io::ErrorKind::AlreadyExists => Diagnostic::input(
            "new/exists",
            format!("`{}` exists already and is left as it is", path.display()),
        )
        .help("choose another name with -o, or remove the file first"),
        std::io::ErrorKind::NotFound => Diagnostic::input(
            "new/no-folder",
            format!("`{}` cannot be written: its folder does not exist", path.display()),
        )
        .help("make the folder first"),
        _ => Diagnostic::environment(
            "new/write",
            format!("`{}` cannot be written: {e}", path.display()),
        )
        .help("check free space and permissions"),
    };
    let mut file =
        std::fs::OpenOptions::new().write(true).create_new(true).open(path).map_err(fault)?;
    file.write_all(text.as_bytes()).map_err(|e| {
        // otherwise the next attempt would be refused because a half-written starter exists
        let _ = std::fs::remove_file(path);
        fault(e).into()
    })
}

/// The spec with a template's starter values: profiles, steels and examples. Everything else has
/// its default.
fn example(template: &Template, name: &str) -> ConnectionSpec {
    let length = |v: &ParameterValue| -> Option<Length> {
        match v {
            ParameterValue::Number(x) => Some(Length(*x)),
            ParameterValue::Text(t) => units::parse(t, units::Kind::Length).ok().map(Length),
            _ => None,
        }
    };
    let mut spec = ConnectionSpec {
        catalog: None,
        project: Default::default(),
        code: Default::default(),
        template: name.to_owned(),
        members: Default::default(),
        plate: None,
        bolts: None,
        parameters: Default::default(),
        welds: Default::default(),
        friction: Default::default(),
        loads: template.starter_load.iter().cloned().collect::<Vec<_>>().into(),
        polygon: None,
        analysis: AnalysisSpec::default(),
    };
    for m in &template.members {
        spec.members.insert(
            m.role.clone(),
            MemberSpec {
                profile: m.profile.clone(),
                steel: m.steel.clone(),
                ..MemberSpec::default()
            },
        );
    }
    if !template.bolts.is_empty() {
        spec.bolts = Some(BoltSpec {
            size: BOLT.0.into(),
            grade: BOLT.1.into(),
            gauge: None,
            rows: None,
            preload: None,
            category: None,
        });
    }
    for p in &template.parameters {
        let Some(value) = &p.example else { continue };
        let mut plate = spec.plate.clone().unwrap_or_default();
        match (p.name.as_str(), value) {
            ("plate.thickness", v) => plate.thickness = length(v),
            ("plate.width", v) => plate.width = length(v),
            ("plate.z", ParameterValue::List(l)) => {
                plate.z = <[Length; 2]>::try_from(l.as_slice()).ok()
            }
            ("bolts.gauge", v) => spec.bolts.iter_mut().for_each(|b| b.gauge = length(v)),
            ("bolts.rows", ParameterValue::List(l)) => {
                spec.bolts.iter_mut().for_each(|b| b.rows = Some(l.clone()))
            }
            (name, v) => drop(spec.parameters.insert(name.to_owned(), v.clone())),
        }
        if plate != PlateSpec::default() {
            spec.plate = Some(plate);
        }
    }
    spec
}

/// The text of the starter. Required values are written out; defaults are written as comments that
/// the user can activate. `date` is the date of the title block.
pub fn starter(
    template: &Template,
    origin: &Origin,
    name: &str,
    catalog: &Catalog,
    date: &str,
) -> Result<String, Diagnostics> {
    let spec = example(template, name);
    let wrong = |faults: AtLeastOne<bracket_joint::assembly::AssemblyError>| {
        faults.map(|f| origin.placed(template, f))
    };
    let inputs = Inputs::read(&spec, template, catalog, Vec::new()).map_err(wrong)?;
    let resolved = inputs.scope().resolve(template, &inputs.given).map_err(wrong)?;
    let mut out = String::new();
    let about = |text: &str| text.replace('\n', " ");
    let _ = writeln!(out, "# {}.", template.title);
    for line in wrap(&template.about, 116) {
        let _ = writeln!(out, "# {line}");
    }
    out.push_str(
        "#\n# Lengths: a bare number is mm, `1.5 cm` works too. Forces, moments and stresses need \
         a unit: 80 kN, 120 kN m,\n# 45 MPa. A commented line shows the default: take the `#` \
         away to change it; values that follow from the profiles\n# are shown for those written \
         here. `bracket schema spec` prints the JSON Schema for your editor, `bracket catalog\n# \
         list` the profiles, bolts and steels.\n\n",
    );
    let _ = write!(
        out,
        "project:\n  title: New joint\n  date: {date:?}\n  # number: \"\"  # project number\n  # \
         author: \"\"  # who made it\n  # checker: \"\"  # who checks it\n  # revision: \"A\"  # \
         revision\n  # language: en  # of the reports; or de\n\n",
    );
    out.push_str(
        "code:\n  edition: EN 1993-1-8:2005\n  # annex: recommended  # national annex of the \
         partial factors: UK, DE … (`bracket catalog list annexes`)\n  # gamma_M0: 1.0  # partial \
         factor of cross-sections; each of them 0.5 to 3, in place of the annex\n  # gamma_M1: \
         1.0  # of instability\n  # gamma_M2: 1.25  # of bolts and welds\n  # gamma_M3: 1.25  # \
         of slip at the ultimate limit state\n  # gamma_M3_ser: 1.1  # of slip at \
         serviceability\n  # gamma_M7: 1.1  # of the preload of bolts\n",
    );
    if on_ground(template) {
        out.push_str(
            "  # gamma_c: 1.5  # of concrete\n  # alpha_cc: 1.0  # coefficient of the strength of \
             concrete; 0.8 to 1\n",
        );
    }
    out.push_str(
        "  # fy_source: table_3_1  # or product_standard: steps of f_y from 16 mm up\n  # prying: \
         by_length  # or always: prying forces in every T-stub, whatever the length of the \
         bolts\n\n",
    );
    // blanks, `#` and quotes in a path would end the YAML text
    let plain = |c: char| c.is_alphanumeric() || "_-./\\".contains(c);
    let name = if name.chars().all(plain) { name.to_owned() } else { format!("{name:?}") };
    let own = "# catalog: my_tables  # folder with .csv tables of your own, beside the built-in \
               catalogue";
    let _ = writeln!(out, "template: {name}\n{own}\n");
    out.push_str(
        "# length: system length, of a beam between the centres of the columns, of a column its \
         storey height: class of the joint by stiffness\n",
    );
    if let Some(column) = template.column() {
        let _ = writeln!(
            out,
            "# N_Ed (tension positive), M_Ed, V_Ed: forces of the column beside the joint; they \
             are checked, and reduce the column web: {column}: {{…, length: 3.5 m, N_Ed: -400 kN, \
             M_Ed: 30 kN m}}"
        );
    }
    out.push_str("members:\n");
    for m in &template.members {
        let _ = writeln!(
            out,
            "  {}: {{profile: {}, steel: {}}}  # {}",
            m.role,
            m.profile,
            m.steel,
            about(&m.about)
        );
    }
    let inside = |head: &str| -> Vec<&Resolved> {
        resolved.iter().filter(|r| r.name.starts_with(head)).collect()
    };
    let plate = inside("plate.");
    if !plate.is_empty() {
        out.push_str("\nplate:\n");
        plate.iter().for_each(|r| line(&mut out, r.name.trim_start_matches("plate."), r));
        let _ = writeln!(
            out,
            "  # steel: {}  # steel grade of the plate",
            template.members.last().map_or("S235", |m| &m.steel)
        );
    }
    if spec.bolts.is_some() {
        let _ = writeln!(
            out,
            "\nbolts:\n  size: {}  # `bracket catalog list bolts`\n  grade: \"{}\"  # property \
             class",
            BOLT.0, BOLT.1
        );
        inside("bolts.")
            .iter()
            .for_each(|r| line(&mut out, r.name.trim_start_matches("bolts."), r));
        out.push_str(
            "  # preload: none  # or a part of f_ub A_s (0.7: F_p,C of EN 1993-1-8 3.9.1), or a \
             force: 98.7 kN\n  # category: A  # of EN 1993-1-8 Table 3.2: A or D in bearing or \
             tension; B, C or E preloaded\n",
        );
    }
    let others: Vec<&Resolved> = resolved.iter().filter(|r| !r.name.contains('.')).collect();
    if !others.is_empty() {
        out.push_str("\nparameters:\n");
        others.iter().for_each(|r| line(&mut out, &r.name, r));
    }
    out.push_str(
        "\n# welds: {ends: returned, bearing_in_contact: false}  # fillet welds: returned at the \
         tips of the flanges, open or all_round; true: compression goes through the contact of \
         beam and plate\n\nfriction:\n  mu: 0  # friction coefficient of all contact \
         surfaces, 0 to 2, 0 is on the safe side; or `class: C` (A, B, C, D of EN 1090-2)\n  # \
         law: coulomb  # no dilation, by a fixed point; associated: slip dilates, both bounds are \
         strict for this law\n\n",
    );
    let sections: Vec<&str> = template.sections.iter().map(|s| s.name.as_str()).collect();
    if !sections.is_empty() {
        let list = sections.join(", ");
        let _ = writeln!(
            out,
            "# section: {list}; pressure: positive pushes on the face, or traction: [x, y, z]"
        );
    }
    let ends: Vec<String> = template.ends.iter().flat_map(|e| e.names()).collect();
    if !ends.is_empty() {
        let senses = match on_ground(template) {
            true => {
                "N lifts, Vz acts along the depth of the column, My pulls its side of positive x"
            }
            false => "N pulls, Vz lifts, My pulls the top of the section (hogging)",
        };
        let _ = writeln!(
            out,
            "# end: {}; at: the point N, Vy, Vz, T, My, Mz refer to. {senses}\n# factor: which of \
             them the load factor multiplies (all, if left out)",
            ends.join(", ")
        );
    }
    out.push_str("loads:\n");
    for l in spec.loads.iter() {
        let _ = writeln!(out, "  - {{{}}}", load_words(l));
    }
    let a = &spec.analysis;
    if let Some(load) = template.starter_load.as_ref().filter(|l| l.end.is_some()) {
        let (end, at) = (
            load.end.as_deref().unwrap_or_default(),
            load.at.map_or("bolt_plane", ActionPoint::word),
        );
        let _ = writeln!(
            out,
            "\n# polygon: {{end: {end}, at: {at}, My: 100 kN m, N: 200 kN}}  # what is carried of \
             two actions at once, by limit analysis in several directions; sizes: about what is \
             carried of each alone; directions: 4, 8 (default), 12 … 32"
        );
    }
    let _ = write!(
        out,
        "\nanalysis:\n  kind: limit  # limit (the load at collapse), elastic, elastoplastic, or a \
         list: [elastic, limit]; the hand checks run with each\n  target_gap: {}  # wanted gap \
         between the bounds, a fraction between 0 and 1; meshes are refined where it comes from \
         until it is reached\n  # max_passes: {}  # meshes at most; 1: the first one alone\n  # \
         max_macro_tets: {}  # tetrahedra at most; 1 or more\n  # time_limit: 20 min  # s, min, \
         h; no limit by default\n  # coulomb_estimate: false  # limit with friction: estimate the \
         load under Coulomb's law as well; up to ten solves more a mesh\n  # decide: \
         false  # also run what a verdict by analysis needs where the code has no method: limit, \
         and elastoplastic with elastic bolts\n  # bolts: yielding  # elastoplastic: yielding or \
         elastic\n  # load_steps: []  # elastoplastic: factors of the demand at which it is run as \
         well, such as [0.25, 0.5, 0.75, 1]\n  mesh:\n    size: auto  \
         # auto, or a length from 0.5 mm to 1000 mm\n    # layers: true  # a mesh plane at \
         mid-thickness of every plate, flange, web and stiffener\n    # segments: {}  # sides of \
         the meshed bolt circles; even, 12 to 48\n",
        a.target_gap, a.max_passes, a.max_macro_tets, a.mesh.segments
    );
    Ok(out)
}

/// A load as one line of the starter.
fn load_words(l: &LoadSpec) -> String {
    let mut words = vec![format!("name: {}", l.name)];
    words.extend(l.section.iter().map(|s| format!("section: {s}")));
    words.extend(l.pressure.iter().map(|p| format!("pressure: {} MPa", p.0)));
    words.extend(l.end.iter().map(|e| format!("end: {e}")));
    words.extend(l.at.iter().map(|p| format!("at: {}", p.word())));
    words.extend(l.actions().into_iter().map(|(action, v)| match action.direction() {
        (_, false) => format!("{}: {} kN", action.word(), v * 1e-3),
        (_, true) => format!("{}: {} kN m", action.word(), v * 1e-6),
    }));
    words.join(", ")
}

/// Breaks a text at blanks into lines of at most `width` characters.
fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(l) if l.is_empty() => l.push_str(word),
            Some(l) if l.len() + 1 + word.len() <= width => {
                l.push(' ');
                l.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Writes one parameter: as a value if the starter gives it, as a comment if it is the default.
fn line(out: &mut String, key: &str, r: &Resolved) {
    let mut note = r.about.replace('\n', " ");
    if let Some(d) = r.default.as_ref().filter(|d| r.value != d.as_str()) {
        let _ = write!(note, "; default {d}");
    }
    if let Some(range) = &r.range {
        let _ = write!(note, "; {range}");
    }
    let off = if r.given { "" } else { "# " };
    let _ = writeln!(out, "  {off}{key}: {}  # {note}", r.value);
}

#[cfg(test)]
mod tests;
