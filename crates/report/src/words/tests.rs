use super::*;
use bracket_base::say;
use bracket_base::words::collected;
use bracket_codes::CheckId;

/// Every message of layouts and scripts has a translation, which cannot break them.
#[test]
fn layouts_are_filled() {
    let words = Words::new(Language::De);
    for layout in [
        include_str!("../page/viewer/view.html"),
        include_str!("../page/viewer/page.js"),
        include_str!("../page/viewer/scene.js"),
        include_str!("../pdf/common.typ"),
        include_str!("../pdf/report.typ"),
    ] {
        let marked = layout.split('⟦').skip(1).filter_map(|t| t.split_once('⟧'));
        let said: Vec<Cow<str>> = marked.filter_map(|(id, _)| words.message(id)).collect();
        assert!(!said.is_empty());
        let code = |t: &&Cow<str>| t.contains(['"', '\\', '<', '#', '$', '*', '_', '`']);
        assert_eq!(said.iter().find(code), None);
        assert!(!words.fill(layout).contains(['⟦', '⟧']));
    }
    assert_eq!(words.unknown(), [""; 0]);
    assert_eq!(words.fill("a ⟦Checks⟧ b ⟦Welds⟧"), "a Nachweise b Schweißnähte");
    assert_eq!(Words::default().fill("a ⟦Checks⟧ b"), "a Checks b");
}

#[test]
fn the_language_files_are_read() {
    for (name, text) in Language::ALL.into_iter().flat_map(files) {
        let read = yaml::parse::<BTreeMap<String, String>>(text, Path::new(name));
        let read = read.unwrap_or_else(|e| panic!("{name}: {e:#?}")).value;
        assert!(read.len() > 20, "{name}: {}", read.len());
    }
}

/// Titles are words of an enum: no `say!` names them.
#[test]
fn every_title_of_a_check_has_its_message() {
    let words = Words::new(Language::De);
    for id in CheckId::ALL {
        words.say(&id.title().into());
    }
    assert_eq!(words.unknown(), [""; 0]);
}

/// A text is said by its data, also when it comes from a file; names stay.
#[test]
fn texts_are_said_and_names_stay() {
    let words = Words::new(Language::De);
    let text = say!("{} and {}", "Bolts", Text::given("Bolts"));
    assert_eq!(words.say(&text), "Schrauben und Bolts");
    let (json, read) = collected(|| serde_json::to_string(&text));
    let text: Text = serde_json::from_str(&json.expect("text")).expect("a text");
    assert_eq!(words.say(&text), "Bolts and Bolts");
    assert_eq!(words.unknown(), ["Bolts and Bolts"]);
    assert_eq!(Words::new(Language::De).with(read).say(&text), "Schrauben und Bolts");
    assert_eq!(Words::default().say(&text), "Bolts and Bolts");
}
