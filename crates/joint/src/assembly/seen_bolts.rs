//! Compares the bolts of the mesh with those of the hand checks, because a verdict by code must
//! cover all of them.

use super::assembly::{Part, PartRole};
use super::end_plate::EndPlate;
use super::error::AssemblyError;
use super::member_ends::Frame;
use bracket_base::math::vec3::V3;

/// Largest distance between two bolts at the same place \[mm\].
const SAME_PLACE: f64 = 0.01;
/// Largest number of bolts named in a message.
const NAMED: usize = 4;

/// A bolt of the geometry.
pub(super) struct Meshed<'a> {
    /// Name of its part.
    pub name: &'a str,
    /// Axis of its shank, 0 = x.
    pub axis: usize,
    /// A point on its axis \[mm\].
    pub position: V3,
    /// The parts that it passes through.
    pub through: Vec<&'a str>,
}

/// Rejects a template whose bolts through an end plate differ from rows × columns of its
/// `hand_checks`. `frames` are the frames of the member ends named there; if empty, the beam runs
/// along x through the origin.
pub(super) fn check(
    bolts: &[Meshed<'_>],
    parts: &[Part],
    frames: &[Frame],
    seen: &EndPlate,
) -> Result<(), AssemblyError> {
    let upright = [Frame { origin: [0.0; 3], along: 0, depth: 2, outward: 1.0 }];
    let frames = if frames.is_empty() { &upright } else { frames };
    let listed: Vec<[f64; 2]> =
        seen.rows.iter().flat_map(|&z| seen.columns().into_iter().map(move |y| [y, z])).collect();
    let plates = || parts.iter().filter(|p| p.role == PartRole::Plate);
    let of = |plate: &Part| -> Vec<&Meshed<'_>> {
        bolts.iter().filter(|b| b.through.contains(&plate.name.as_str())).collect()
    };
    let bolted: Vec<(&str, Vec<&Meshed<'_>>)> =
        plates().map(|p| (p.name.as_str(), of(p))).filter(|(_, bolts)| !bolts.is_empty()).collect();
    let lost: Vec<&Meshed<'_>> =
        bolts.iter().filter(|b| !bolted.iter().any(|(p, _)| b.through.contains(p))).collect();
    if !lost.is_empty() {
        let problem = format!(
            "{} of the {} bolts pass no part of role `plate`: {}; `hand_checks` does not see them",
            lost.len(),
            bolts.len(),
            names(lost.iter().map(|b| b.name.to_owned()))
        );
        return wrong(
            problem,
            "give the end plates `role: plate`, or leave these bolts out of a template with \
             `hand_checks`",
        );
    }
    let faults_of = |bolts: &[&Meshed<'_>]| -> Vec<String> {
        frames.iter().filter_map(|f| mismatch(f, bolts, &listed)).collect()
    };
    let all_listed = |bolts: &[&Meshed<'_>]| faults_of(bolts).len() < frames.len();
    let (end_plates, others): (Vec<_>, Vec<_>) =
        bolted.iter().partition(|(_, bolts)| all_listed(bolts));
    // a further plate under some of the bolts of an end plate, for example a backing plate
    let beside = |bolts: &[&Meshed<'_>]| {
        bolts.iter().all(|b| end_plates.iter().any(|(p, _)| b.through.contains(p)))
    };
    if let Some((plate, bolts)) = others.iter().find(|(_, bolts)| !beside(bolts)) {
        let faults = faults_of(bolts);
        let rows: Vec<String> = seen.rows.iter().map(f64::to_string).collect();
        let columns: Vec<String> = seen.columns().iter().map(f64::to_string).collect();
        let problem = format!(
            "it sees {} bolts (rows at z = {} mm, columns at y = {} mm), the geometry has {} in \
             `{plate}`: {}",
            listed.len(),
            rows.join(", "),
            columns.join(", "),
            bolts.len(),
            faults.first().map_or("", String::as_str)
        );
        let help = "write `rows` and `gauge` of `hand_checks` so that rows × 2 columns are the \
                    bolts of the template; a plate with more than two columns has no hand checks \
                    yet: leave `hand_checks` out";
        return wrong(problem, help);
    }
    Ok(())
}

fn wrong(problem: String, help: &str) -> Result<(), AssemblyError> {
    Err(AssemblyError::UnseenBolts { at: "hand_checks.rows".into(), problem, help: help.into() })
}

/// Bolts that `hand_checks` does not list, or listed bolts that do not exist, in one member's
/// frame; `None` if both agree.
fn mismatch(frame: &Frame, bolts: &[&Meshed<'_>], listed: &[[f64; 2]]) -> Option<String> {
    let across = 3 - frame.along - frame.depth;
    let place = |b: &Meshed<'_>| [across, frame.depth].map(|k| b.position[k] - frame.origin[k]);
    let same = |a: &[f64; 2], b: &[f64; 2]| (0..2).all(|k| (a[k] - b[k]).abs() < SAME_PLACE);
    let told = |p: &[f64; 2]| format!("y = {} mm, z = {} mm", rounded(p[0]), rounded(p[1]));
    let turned: Vec<String> =
        bolts.iter().filter(|b| b.axis != frame.along).map(|b| b.name.to_owned()).collect();
    if !turned.is_empty() {
        return Some(format!("{} do not run along the beam", names(turned.into_iter())));
    }
    let unseen = bolts.iter().filter(|b| !listed.iter().any(|l| same(l, &place(b))));
    let unseen: Vec<String> =
        unseen.map(|b| format!("{} at {}", b.name, told(&place(b)))).collect();
    if !unseen.is_empty() {
        return Some(format!(
            "not seen {} {}",
            if unseen.len() == 1 { "is" } else { "are" },
            names(unseen.into_iter())
        ));
    }
    let absent = listed.iter().filter(|l| !bolts.iter().any(|b| same(l, &place(b))));
    let absent: Vec<String> = absent.map(told).collect();
    (!absent.is_empty()).then(|| format!("there is no bolt at {}", names(absent.into_iter())))
}

/// A coordinate rounded for messages.
fn rounded(x: f64) -> f64 {
    (x * 100.0).round() / 100.0 + 0.0
}

/// The first names, and the number of the others.
fn names(all: impl Iterator<Item = String>) -> String {
    let mut all: Vec<String> = all.collect();
    let more = all.len().saturating_sub(NAMED);
    all.truncate(NAMED);
    let list = all.join("; ");
    if more > 0 { format!("{list}; and {more} more") } else { list }
}

#[cfg(test)]
mod tests {
    use crate::assembly::template_file::SHIPPED;
    use crate::assembly::tests::{code, with};
    use crate::catalog::Catalog;
    use crate::spec::ConnectionSpec;
    use bracket_base::diag::Diagnostics;
    use bracket_base::yaml;
    use std::path::Path;

    fn shipped() -> &'static str {
        SHIPPED
            .iter()
            .find(|(n, _)| *n == "double_sided_end_plate")
            .map(|(_, t)| *t)
            .expect("shipped")
    }

    /// Builds the paper's joint from a user's template: the shipped one with some texts replaced.
    fn build(changes: &[(&str, &str)]) -> Result<(), Diagnostics> {
        let folder = tempfile::tempdir().expect("a folder");
        let mut template = shipped().to_owned();
        for (old, new) in changes {
            assert_eq!(template.matches(old).count(), 1, "{old}");
            template = template.replace(old, new);
        }
        std::fs::write(folder.path().join("mine.yaml"), template).expect("written");
        let spec = with("template: double_sided_end_plate", "template: mine.yaml");
        let spec = yaml::parse::<ConnectionSpec>(&spec, Path::new("joint.yaml"))?;
        let catalog = Catalog::builtin().expect("sound");
        crate::assembly::build(&spec, folder.path(), &catalog, code()).map(drop)
    }

    const COLUMNS: &str = "  - name: \"BOLT_{#side}{#row}{#col}\"
    label: \"bolt of the {#side} beam in row {#row} at z = {row}, y = {col * bolts.gauge / 2}\"
    for:
      - {each: side, labels: [R, L], values: [1, -1]}
      - {each: row, list: bolts.rows}
      - {each: col, labels: [P, M], values: [1, -1]}";

    #[test]
    fn bolts_that_the_hand_checks_do_not_see_are_refused_in_the_template() {
        build(&[]).unwrap_or_else(|e| panic!("{e:#?}"));
        let head = "head: [side * beam_start, col * bolts.gauge / 2, row]";
        let four = COLUMNS.replace(
            "labels: [P, M], values: [1, -1]",
            "labels: [P, M, Q, N], values: [1, -1, 1.5, -1.5]",
        );
        let one = COLUMNS.replace("labels: [P, M], values: [1, -1]", "labels: [P], values: [1]");
        type Case<'a> = (&'a str, Vec<(&'a str, &'a str)>, &'a str);
        let cases: Vec<Case<'_>> = vec![
            (
                "four columns",
                vec![(COLUMNS, four.as_str())],
                "it sees 6 bolts (rows at z = -215, -125, 110 mm, columns at y = -50, 50 mm), the \
                 geometry has 12 in `PLATE_R`: not seen are BOLT_R1Q at y = 75 mm, z = -215 mm",
            ),
            (
                "another gauge",
                vec![("  gauge: bolts.gauge\n", "  gauge: bolts.gauge + 1 mm\n")],
                "columns at y = -50.5, 50.5 mm",
            ),
            (
                "one column",
                vec![(COLUMNS, one.as_str())],
                "the geometry has 3 in `PLATE_R`: there is no bolt at y = -50 mm, z = -215 mm",
            ),
            (
                "shifted rows",
                vec![(head, "head: [side * beam_start, col * bolts.gauge / 2, row + 5 mm]")],
                "BOLT_R1P at y = 50 mm, z = -210 mm",
            ),
            (
                "plates that are none",
                vec![(
                    "    label: \"end plate of the {#side} beam\"\n    role: plate\n",
                    "    label: \"end plate of the {#side} beam\"\n    role: member\n",
                )],
                "12 of the 12 bolts pass no part of role `plate`",
            ),
        ];
        for (what, changes, words) in &cases {
            let d = build(changes).expect_err(what).into_first();
            assert_eq!(d.code, "template/hand-checks", "{what}: {d:#?}");
            assert!(
                d.message.contains(words) && d.message.contains("hand_checks.rows"),
                "{what}: {d:#?}"
            );
            assert!(
                d.place.file.as_ref().is_some_and(|f| f.ends_with("mine.yaml"))
                    && d.place.line.is_some(),
                "{d:#?}"
            );
            assert!(d.help.as_ref().is_some_and(|h| h.contains("hand_checks")), "{what}: {d:#?}");
        }
        // without hand checks the same geometry is accepted
        let (before, _) = shipped().split_once("\nhand_checks:").expect("there");
        let rest =
            shipped().strip_prefix(before).and_then(|r| r.split_once("\n\n")).expect("an entry").0;
        build(&[(COLUMNS, &four), (rest, "\n")]).unwrap_or_else(|e| panic!("{e:#?}"));
    }
}
