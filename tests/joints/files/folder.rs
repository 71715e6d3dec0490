//! Result folders are complete or do not exist.

use bracket::diag::{Diagnostic, Fault};
use bracket::result::folder::{Content, FolderError, ResultFolder};
use bracket::result::result_file::RESULT_FILE;
use bracket::result::result_file::ResultFile;
use bracket::result::result_file::Verdict;
use std::fs;
use std::path::Path;

fn result() -> String {
    ResultFile::new("00", 1, Verdict::None).to_json().expect("valid")
}

/// Names in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .expect("can be listed")
        .map(|e| e.expect("entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

fn write_whole(target: &Path, page: &str) {
    let folder = ResultFolder::begin(target).expect("begins");
    folder.write("report.md", page.as_bytes()).expect("writes");
    folder.write("fields/TOP_static.vtu", b"field").expect("writes");
    folder.write(RESULT_FILE, result().as_bytes()).expect("writes");
    folder.finish().expect("finishes");
}

fn fault(e: FolderError) -> Diagnostic {
    e.into()
}

#[test]
fn a_result_appears_whole_and_replaces_only_a_result() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let target = dir.path().join("joint");
    write_whole(&target, "first");
    assert_eq!(names(&target), OURS);
    write_whole(&target, "second");
    assert_eq!(names(&target), OURS);
    assert_eq!(fs::read_to_string(target.join("report.md")).expect("reads"), "second");
    assert_eq!(names(dir.path()), ["joint"]);
}

/// The files that `write_whole` leaves.
const OURS: [&str; 4] = ["digests.b3", "fields", "report.md", "result.json"];

#[test]
fn files_of_the_user_stay_in_a_folder_that_is_replaced() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let target = dir.path().join("joint");
    write_whole(&target, "first");
    let mine = ["notes.txt", "fields/view.pvsm", "mine/deep/sketch.txt", "plot.svg"];
    for name in mine {
        let path = target.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        fs::write(path, name).expect("writes");
    }
    std::os::unix::fs::symlink("/nowhere", target.join("link")).expect("linked");
    let folder = ResultFolder::begin(&target).expect("begins");
    folder.write("plot.svg", b"of the program").expect("writes");
    folder.write(RESULT_FILE, result().as_bytes()).expect("writes");
    folder.finish().expect("finishes");
    for name in &mine[..3] {
        assert_eq!(fs::read_to_string(target.join(name)).expect(name), *name);
    }
    assert!(target.join("link").is_symlink() && !target.join("report.md").exists());
    let read = |name: &str| fs::read_to_string(target.join(name)).expect("reads");
    assert_eq!(
        (read("plot.svg").as_str(), read("plot.svg.kept").as_str()),
        ("of the program", "plot.svg")
    );
    assert_eq!(names(dir.path()), ["joint"]);
    // a folder without the list is refused before anything starts
    fs::remove_file(target.join("digests.b3")).expect("removed");
    let e = fault(ResultFolder::begin(&target).expect_err("no list"));
    assert!(e.message.contains("cannot be told from yours"), "{e}");
    assert_eq!(names(dir.path()), ["joint"]);
}

/// `mesh` and `study` replace only files that they have written.
#[test]
fn files_of_the_user_stay_beside_those_of_mesh_and_study() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let target = dir.path().join("joint_study");
    let content = Content::Files { mark: "study.csv", command: "study" };
    let begin = || ResultFolder::begin_with(&target, content);
    // an empty folder is taken
    fs::create_dir(&target).expect("made");
    for rows in ["first", "second"] {
        let folder = begin().expect("begins");
        folder.write("study.csv", rows.as_bytes()).expect("writes");
        folder.finish().expect("finishes");
        fs::write(target.join(format!("{rows}.txt")), "mine").expect("writes");
    }
    assert_eq!(names(&target), ["digests.b3", "first.txt", "second.txt", "study.csv"]);
    assert_eq!(fs::read_to_string(target.join("study.csv")).expect("reads"), "second");
    for (gone, why) in [("digests.b3", "cannot be told from yours"), ("study.csv", "study.csv")] {
        fs::remove_file(target.join(gone)).expect("removed");
        let e = fault(begin().expect_err(gone));
        assert_eq!(e.code, "cli/out-exists");
        assert!(e.message.contains("`bracket study`") && e.message.contains(why), "{e}");
    }
    assert_eq!(names(dir.path()), ["joint_study"]);
}

/// A program can be killed after each of the steps in which it replaces a result.
#[test]
fn the_next_run_puts_in_order_what_a_killed_one_left() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let (target, old) = (dir.path().join("joint"), dir.path().join("joint.old.part"));
    write_whole(&target, "first");
    fs::write(target.join("notes.txt"), "mine").expect("writes");
    // the old result was moved away, and the new one was not in place
    fs::rename(&target, &old).expect("moved");
    drop(ResultFolder::begin(&target).expect("begins"));
    assert_eq!(fs::read_to_string(target.join("report.md")).expect("reads"), "first");
    // the new one was in place, and the old one still there
    fs::rename(&target, &old).expect("moved");
    let elsewhere = dir.path().join("other");
    write_whole(&elsewhere, "second");
    fs::rename(&elsewhere, &target).expect("moved");
    drop(ResultFolder::begin(&target).expect("begins"));
    assert_eq!(fs::read_to_string(target.join("report.md")).expect("reads"), "second");
    assert_eq!(fs::read_to_string(target.join("notes.txt")).expect("reads"), "mine");
    assert_eq!(names(dir.path()), ["joint"]);
}

#[test]
fn what_is_not_ours_is_left_alone() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let cases: [(&str, Option<&str>); 4] = [
        ("empty", None),
        ("foreign", Some("{\"nodes\": 3}")),
        ("later", Some(r#"{"schema": 99, "tool": {"name": "bracket", "version": "9"}}"#)),
        ("broken", Some("{")),
    ];
    for (name, content) in cases {
        let target = dir.path().join(name);
        fs::create_dir(&target).expect("makes");
        if let Some(content) = content {
            fs::write(target.join(RESULT_FILE), content).expect("writes");
        }
        let before = names(&target);
        let e = fault(ResultFolder::begin(&target).expect_err(name));
        assert_eq!((e.fault, e.fault.exit_code()), (Fault::Input, 2), "{name}: {e}");
        assert!(e.message.contains(&*target.to_string_lossy()), "{name}: {e}");
        assert!(e.help.is_some());
        assert_eq!(names(&target), before);
    }
    let file = dir.path().join("file");
    fs::write(&file, "precious").expect("writes");
    assert_eq!(fault(ResultFolder::begin(&file).expect_err("a file")).fault.exit_code(), 2);
    assert_eq!(fs::read_to_string(&file).expect("reads"), "precious");
}

#[test]
fn an_unfinished_run_leaves_nothing_and_keeps_the_old_result() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let target = dir.path().join("joint");
    write_whole(&target, "first");
    {
        let folder = ResultFolder::begin(&target).expect("begins");
        folder.write("report.md", b"second").expect("writes");
        assert_eq!(names(dir.path()), ["joint", "joint.part"]);
    }
    assert_eq!(names(dir.path()), ["joint"]);
    assert_eq!(fs::read_to_string(target.join("report.md")).expect("reads"), "first");
    {
        let _deep = ResultFolder::begin(&dir.path().join("a/b/c")).expect("begins");
    }
    assert_eq!(names(dir.path()), ["joint"]);
}

#[test]
fn finishing_without_a_valid_result_is_refused() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let target = dir.path().join("joint");
    let folder = ResultFolder::begin(&target).expect("begins");
    folder.write("report.md", b"page").expect("writes");
    assert!(matches!(folder.finish(), Err(FolderError::Incomplete { .. })));
    let folder = ResultFolder::begin(&target).expect("begins");
    folder.write(RESULT_FILE, b"{\"schema\": 1}").expect("writes");
    assert!(matches!(folder.finish(), Err(FolderError::Incomplete { .. })));
    assert!(names(dir.path()).is_empty());
}

#[test]
fn a_folder_that_turns_foreign_meanwhile_is_not_replaced() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let target = dir.path().join("joint");
    let folder = ResultFolder::begin(&target).expect("begins");
    folder.write(RESULT_FILE, result().as_bytes()).expect("writes");
    fs::create_dir(&target).expect("makes");
    fs::write(target.join("thesis.tex"), "precious").expect("writes");
    assert!(matches!(folder.finish(), Err(FolderError::NotOurs { .. })));
    assert_eq!(names(dir.path()), ["joint"]);
    assert_eq!(names(&target), ["thesis.tex"]);
}

#[test]
fn two_runs_do_not_share_a_target_and_a_killed_one_does_not_block() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let target = dir.path().join("joint");
    let first = ResultFolder::begin(&target).expect("begins");
    let e = fault(ResultFolder::begin(&target).expect_err("busy"));
    assert_eq!((e.code, e.fault.exit_code()), ("report/folder-busy", 2));
    first.write("report.md", b"page").expect("still there");
    // a killed run releases its lock but leaves its folder
    let part = dir.path().join("joint.part");
    let copy = dir.path().join("copy");
    fs::create_dir(&copy).expect("makes");
    fs::copy(part.join(".bracket-run"), copy.join(".bracket-run")).expect("copies");
    drop(first);
    fs::rename(&copy, &part).expect("renames");
    write_whole(&target, "after the killed run");
    assert_eq!(names(dir.path()), ["joint"]);
    // a folder of that name that the program did not write is kept
    fs::create_dir(&part).expect("makes");
    fs::write(part.join("mine.txt"), "precious").expect("writes");
    assert!(matches!(ResultFolder::begin(&target), Err(FolderError::InTheWay { .. })));
    assert_eq!(names(&part), ["mine.txt"]);
}

#[test]
fn names_cannot_leave_the_folder() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let folder = ResultFolder::begin(&dir.path().join("joint")).expect("begins");
    for name in ["../escape", "/etc/escape", "", "a/../../b", ".bracket-run"] {
        assert!(matches!(folder.write(name, b""), Err(FolderError::Name { .. })), "{name}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_named_and_leaves_nothing() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let target = dir.path().join("joint");
    let folder = ResultFolder::begin(&target).expect("begins");
    // every write to this device fails as on a full disk
    std::os::unix::fs::symlink("/dev/full", folder.path().join("report.md")).expect("links");
    let e = fault(folder.write("report.md", b"page").expect_err("full"));
    assert_eq!((e.code, e.fault.exit_code()), ("report/disk-full", 4));
    let shown = target.join("report.md");
    assert!(e.message.contains(&*shown.to_string_lossy()), "{e}");
    drop(folder);
    assert!(names(dir.path()).is_empty());
}

#[cfg(target_os = "linux")]
#[test]
fn a_place_that_cannot_be_written_is_an_environment_fault() {
    // nobody may make folders there, not even root
    for target in ["/proc/joint", "/sys/joint"] {
        let e = fault(ResultFolder::begin(Path::new(target)).expect_err(target));
        assert_eq!(e.fault.exit_code(), 4, "{e}");
        assert!(e.message.contains(target), "{e}");
    }
    use std::os::unix::fs::PermissionsExt;
    let dir = tempfile::tempdir().expect("temporary folder");
    fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o555)).expect("changes");
    match ResultFolder::begin(&dir.path().join("joint")) {
        Err(e) => assert_eq!(fault(e).code, "report/read-only"),
        // root may write anywhere
        Ok(folder) => drop(folder),
    }
    assert!(names(dir.path()).is_empty());
    fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o755)).expect("changes");
}

/// A discarded folder is removed together with the parent folders made for it. An earlier result
/// and a finished result are kept.
#[test]
fn what_is_given_up_leaves_nothing_and_touches_no_result() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let target = dir.path().join("deep/er/joint");
    let folder = ResultFolder::begin(&target).expect("begins");
    folder.write("fields/TOP_static.vtu", b"field").expect("writes");
    folder.give_up()();
    assert!(names(dir.path()).is_empty(), "{:?}", names(dir.path()));
    // skips the drop of the discarded folder, as if the program ended here
    std::mem::forget(folder);

    let target = dir.path().join("joint");
    write_whole(&target, "first");
    let folder = ResultFolder::begin(&target).expect("begins");
    folder.write(RESULT_FILE, result().as_bytes()).expect("writes");
    let give_up = folder.give_up();
    give_up();
    assert_eq!(fs::read_to_string(target.join("report.md")).expect("reads"), "first");
    assert_eq!(names(dir.path()), ["joint"]);
    std::mem::forget(folder);

    let folder = ResultFolder::begin(&target).expect("begins");
    folder.write("report.md", b"second").expect("writes");
    folder.write(RESULT_FILE, result().as_bytes()).expect("writes");
    let give_up = folder.give_up();
    folder.finish().expect("finishes");
    give_up();
    assert_eq!(fs::read_to_string(target.join("report.md")).expect("reads"), "second");
}
