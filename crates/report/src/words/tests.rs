use super::*;

fn german(names: &[&str]) -> Words {
    Words::new(Language::De, names.iter().map(|n| n.to_string()))
}

/// Every text of layouts and scripts has a translation, which cannot break them.
#[test]
fn layouts_are_filled() {
    let words = german(&[]);
    for layout in [
        include_str!("../page/viewer/view.html"),
        include_str!("../page/viewer/page.js"),
        include_str!("../page/viewer/scene.js"),
        include_str!("../pdf/common.typ"),
        include_str!("../pdf/report.typ"),
    ] {
        let marked = layout.split('⟦').skip(1).filter_map(|t| t.split_once('⟧'));
        let said: Vec<String> = marked.map(|(text, _)| words.say(text)).collect();
        assert!(!said.is_empty());
        let code = |t: &&String| t.contains(['"', '\\', '<', '#', '$', '*', '_', '`']);
        assert_eq!(said.iter().find(code), None);
        assert!(!words.fill(layout).contains(['⟦', '⟧']));
    }
    assert!(words.unknown().is_empty(), "{:?}", words.unknown());
}

/// Every gap of a text stands in its translation.
#[test]
fn the_language_file_is_read_and_its_gaps_agree() {
    let texts: BTreeMap<String, String> =
        yaml::parse(GERMAN, Path::new("de.yaml")).expect("a language file").value;
    assert!(texts.len() > 400, "{}", texts.len());
    let gaps =
        |text: &str| (1..10).filter(|n| text.contains(&format!("{{{n}}}"))).collect::<Vec<_>>();
    for (english, german) in &texts {
        assert_eq!(gaps(english), gaps(german), "{english}");
        assert!(!english.is_empty() && !german.trim().is_empty(), "{english}");
        assert!(!english.ends_with('.') && !german.ends_with('.'), "without stop: {english}");
    }
}

#[test]
fn texts_are_translated_whole_or_in_parts_and_names_stay() {
    let words = german(&["Bolts", "beam_right"]);
    assert_eq!(words.say("Checks"), "Nachweise");
    assert_eq!(words.say("load factor 1.20"), "Lastfaktor 1.20");
    assert_eq!(words.say("end plate, row at z = 105 mm"), "Stirnplatte, Reihe bei z = 105 mm");
    assert_eq!(
        words.say("**Detailing.** Minimum distances decide the verdict."),
        "**Konstruktive Regeln.** Mindestabstände entscheiden das Urteil."
    );
    assert_eq!(words.say("**Checks fail**:"), "**Nachweise sind nicht erfüllt**:");
    assert_eq!(
        words.say("end plate, row at z = 90 mm, tension capped at F_t,Rd"),
        "Stirnplatte, Reihe bei z = 90 mm, Zug höchstens mit F_t,Rd"
    );
    assert_eq!(words.say("**tension at the top**"), "**Zug oben**");
    assert_eq!(words.say(" Bolts "), " Bolts ");
    assert_eq!(words.say("Bolts: every check holds"), "Bolts: every check holds");
    assert_eq!(words.unknown(), ["Bolts: every check holds"]);
    assert_eq!(german(&[]).say("Bolts"), "Schrauben");
    let english = Words::new(Language::En, []);
    assert_eq!(english.say("Checks"), "Checks");
    assert_eq!(english.fill("a ⟦Checks⟧ b"), "a Checks b");
    assert_eq!(words.fill("a ⟦Checks⟧ b ⟦Welds⟧"), "a Nachweise b Schweißnähte");
}

/// Headings, cells and captions are translated; code and titles are not. A drawing is the one
/// beside it with German texts.
#[test]
fn markdown_keeps_its_form() {
    let english = "# Checks\n\n## Checks\n\n| check | a\\|b |\n| --- | ---: |\n| tension | 1 |\n\n\
                   - Welds\n\n![Pictures](Welds.svg)\n\n```yaml\nWelds: 1\n``` \n```\nWelds.\n";
    let german = german(&[]).markdown(english);
    assert_eq!(
        german,
        "# Checks\n\n## Nachweise\n\n| Nachweis | a\\|b |\n| --- | ---: |\n| Zug | 1 |\n\n- \
         Schweißnähte\n\n![Bilder](Welds.de.svg)\n\n```yaml\nWelds: 1\n``` \n```\nSchweißnähte.\n"
    );
}

/// A drawing grows where a longer word needs it, and its texts stay escaped.
#[test]
fn drawings_are_translated_and_widened() {
    let svg = "<svg width=\"50\" height=\"9\" viewBox=\"0 0 50 9\">\n<rect width=\"50\"/>\n<text \
               x=\"10.0\" y=\"1\" text-anchor=\"start\">side view</text>\n<text x=\"10.0\" \
               y=\"1\" text-anchor=\"end\">a &lt; b</text>\n</svg>\n";
    let text = german(&[]).drawing(svg);
    assert!(text.contains(">Seitenansicht<") && text.contains(">a &lt; b<"), "{text}");
    assert!(text.contains("<svg width=\"117\" height=\"9\" viewBox=\"0 0 117 9\">"), "{text}");
    assert_eq!(Words::new(Language::En, []).drawing(svg), svg);
}
