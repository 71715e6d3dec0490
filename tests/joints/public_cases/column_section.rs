//! The column's own section at the joint.

use super::answer::Answer;

const CORNER: &str = "35-corner_column_overloaded.yaml";
const GIVEN: &str = "36-column_N1100_M78.yaml";
const MOMENT: &str = "moment of the column with its shear and axial force";

/// Demand and resistance of the moment of the column in kN m.
fn moment(answer: &Answer) -> [f64; 2] {
    let found = answer.titled(MOMENT);
    assert_eq!(found.len(), 1, "{}", answer.said);
    ["demand", "resistance"].map(|key| 1e-6 * found[0][key].as_f64().expect("a number"))
}

fn near(found: f64, wanted: f64) {
    assert!((found / wanted - 1.0).abs() < 2e-3, "{found} is not {wanted}");
}

/// HEB200, S235: A = 7808 mm², W_pl = 642.5 cm³, t_f = 15: a = (A − 2 b t_f)/A = 0.2316, and
/// M_N,Rd = 151 (1 − n)/(1 − a/2) with n = N/1835 kN.
#[test]
fn given_forces_of_the_column_are_checked() {
    let answer = Answer::of(GIVEN);
    assert_eq!((answer.code, answer.verdict()), (1, "not_ok"), "{}", answer.said);
    let [demand, resistance] = moment(&answer);
    near(demand, 78.0);
    near(resistance, 68.4);
    let text = Answer::input(GIVEN);
    let (area, plastic): (f64, f64) = (7808.0, 642.5e3 * 235e-6);
    let a = (area - 2.0 * 200.0 * 15.0) / area;
    for (axial, m, verdict) in [
        (-1100.0_f64, 60.0_f64, "ok"),
        (1100.0, 78.0, "not_ok"),
        (1100.0, 60.0, "ok"),
        (-500.0, 78.0, "ok"),
    ] {
        let answer = Answer::to(
            &text
                .replace("-1100 kN", &format!("{axial} kN"))
                .replace("78 kN m", &format!("{m} kN m")),
        );
        let part: f64 = axial.abs() / (area * 0.235);
        near(moment(&answer)[1], plastic * ((1.0 - part) / (1.0 - 0.5 * a)).min(1.0));
        assert_eq!(answer.verdict(), verdict, "{axial} {m}: {}", answer.said);
    }
}

/// At a corner the moment of the one column follows from the node.
#[test]
fn a_corner_column_carries_the_moment_of_the_node() {
    let answer = Answer::of(CORNER);
    assert_eq!((answer.code, answer.verdict()), (1, "not_ok"), "{}", answer.said);
    // 172 at the bolt plane, 20 kN 100 mm from the node
    let [demand, resistance] = moment(&answer);
    near(demand, 174.0);
    near(resistance, 151.0);
    let axial = answer.titled("axial force of the column");
    assert!(axial.len() == 1 && axial[0]["demand"] == 20e3, "{axial:?}");
    // one column, so full strength is that of one column
    let class = answer.titled("class by strength");
    assert!(class[0]["formula"].as_str().is_some_and(|f| f.contains("1 M_c,pl,Rd")), "{class:?}");
    let text = Answer::input(CORNER);
    // less of it holds in the column
    let small = Answer::to(&text.replace("172 kN m", "120 kN m"));
    assert_eq!(small.titled(MOMENT)[0]["status"], "ok", "{}", small.said);
    // a horizontal force of the beam bends the column below as well: 50 kN over h_b/2 = 250 mm
    let pulled =
        Answer::to(&text.replace("\"Vz\": \"-20 kN\"", "\"Vz\": \"-20 kN\", \"N\": \"50 kN\""));
    near(moment(&pulled)[0], 174.0 + 50.0 * 0.25);
    let panel = pulled
        .checks()
        .iter()
        .find(|c| c["title"].as_str().is_some_and(|t| t.contains("by equilibrium of the node")))
        .expect("the panel");
    assert!(panel["formula"].as_str().is_some_and(|f| f.contains("− (-50 kN/2)|")), "{panel}");
}

/// Where the column continues both ways and nothing is given, its share is not known.
#[test]
fn a_column_that_continues_is_named_as_not_checked() {
    let text = Answer::input(GIVEN)
        .replace("\"N_Ed\": \"-1100 kN\",", "")
        .replace("\"steel\": \"S235\",\n   \"M_Ed\": \"78 kN m\"", "\"steel\": \"S235\"");
    let text = text.replace(",\n   \n   \"M_Ed\": \"78 kN m\"", "");
    assert!(!text.contains("_Ed"), "{text}");
    let answer = Answer::to(&text);
    assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
    let note = answer.titled("column beside the joint, not checked");
    assert!(note.len() == 1 && note[0]["status"] == "information", "{note:?}");
    assert!(answer.titled(MOMENT).is_empty());
}

/// V_Ed of the column is part of the shear flow of a web doubler, as it is of the panel's shear.
#[test]
fn the_welds_of_a_doubler_carry_the_shear_of_the_column() {
    let of = |v: f64| {
        let text = format!(
            "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB200, steel: \
             S235, V_Ed: {v} kN}}, beam: {{profile: IPE300, steel: S235}}}}\nplate: {{thickness: \
             15}}\nbolts: {{size: M20, grade: \"8.8\", rows: [-90, 90, 190]}}\nparameters: \
             {{doubler: true, doubler_weld: 7}}\nloads: [{{name: U, end: beam_right, at: \
             bolt_plane, My: 60 kN m}}]\n"
        );
        let answer = Answer::to(&text);
        let number = |title: &str| {
            let all: Vec<_> = answer.checks().iter().filter(|c| c["case"] == "U").collect();
            let found = all.iter().find(|c| c["title"] == title).expect(title);
            found["demand"].as_f64().expect("a number")
        };
        (number("shear flow in the welds of a web doubler"), number("column web panel in shear"))
    };
    let (flow, panel) = of(-150.0);
    let (less, relieved) = of(50.0);
    // the flow is in proportion to the shear of the panel, which 200 kN part
    assert!((panel - relieved - 200e3).abs() < 1.0, "{panel} {relieved}");
    assert!((flow / panel / (less / relieved) - 1.0).abs() < 1e-9, "{flow} {less}");
}

/// A joint between a beam and a column with these forces, My = `m` kN m at the face of the column.
/// Vz = -75 kN stands 100 mm from the node, so that the node has m + 7.5 kN m.
fn beside(column: &str, m: f64) -> Answer {
    Answer::to(&format!(
        "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB200, steel: \
         S235{column}}}, beam: {{profile: IPE300, steel: S235}}}}\nplate: {{thickness: 15, width: \
         160, z: [-165, 230]}}\nbolts: {{size: M20, grade: \"8.8\", gauge: 100, rows: [-90, 90, \
         190]}}\nloads: [{{name: U, end: beam_right, at: column_face, My: {m} kN m, Vz: -75 kN}}]\n"
    ))
}

/// Where the column continues, one of the two columns has at least half of the moment of the node.
/// M_N,Rd beside -1500 kN is 151 (1 - 1500/1835)/(1 - 0.2316/2) = 31.16 kN m.
#[test]
fn the_column_has_at_least_half_of_the_moment_of_the_node() {
    // 77.5/2 > 31.16, whatever M_Ed is
    let over = beside(", N_Ed: -1500 kN", 70.0);
    assert_eq!((over.code, over.verdict()), (1, "not_ok"), "{}", over.said);
    let [demand, resistance] = moment(&over);
    near(demand, 38.75);
    near(resistance, 31.16);
    // 47.5/2 holds and 47.5 does not: the share decides
    let open = beside(", N_Ed: -1500 kN", 40.0);
    assert_eq!((open.code, open.verdict()), (3, "undecided"), "{}", open.said);
    assert!(open.said.contains("members.column.M_Ed"), "{}", open.said);
    assert!(open.said.contains("at least 23.75 kN m"), "{}", open.said);
    let given = beside(", N_Ed: -1500 kN, M_Ed: 25 kN m", 40.0);
    assert_eq!((given.code, given.verdict()), (0, "ok"), "{}", given.said);
    // all of it holds
    let small = beside(", N_Ed: -1500 kN", 20.0);
    assert_eq!((small.code, small.verdict()), (0, "ok"), "{}", small.said);
    // a moment that contradicts equilibrium proves nothing, however much the column carries
    let wrong = beside(", N_Ed: -100 kN, M_Ed: 1 kN m", 40.0);
    assert_eq!((wrong.code, wrong.verdict()), (3, "undecided"), "{}", wrong.said);
    let formula = wrong.titled(MOMENT)[0]["formula"].to_string();
    assert!(formula.contains("less than half of the moment 47.5 kN m"), "{formula}");
    let rounded = beside(", N_Ed: -100 kN, M_Ed: 23.7 kN m", 40.0);
    assert_eq!((rounded.code, rounded.verdict()), (0, "ok"), "{}", rounded.said);
    near(moment(&rounded)[0], 23.75);
    // nothing given, and the least share is too much already
    let full = Answer::to(
        &Answer::input(CORNER)
            .replace("\"column_ends_above\": true", "\"column_ends_above\": false")
            .replace("172 kN m", "400 kN m"),
    );
    assert_eq!(full.titled(MOMENT)[0]["status"], "failed", "{}", full.said);
}

/// A column that yields by N and M fails its check; it is no wrong input.
#[test]
fn a_column_pressed_beyond_yield_is_not_ok() {
    for m in [33.0, 39.0, 300.0] {
        let answer = beside(&format!(", N_Ed: -1500 kN, M_Ed: {m} kN m"), 40.0);
        assert_eq!((answer.code, answer.verdict()), (1, "not_ok"), "{m}: {}", answer.said);
    }
    let crushed = beside(", N_Ed: -5000 kN, M_Ed: 30 kN m", 40.0);
    assert_eq!(crushed.code, 1, "{}", crushed.said);
    assert_eq!(crushed.titled("axial force of the column")[0]["status"], "failed");
}

/// A shear force of the spec against equilibrium relieves nothing where the column ends.
#[test]
fn equilibrium_at_a_corner_is_not_overruled() {
    let corner = |more: &str| {
        let text = Answer::input(CORNER).replace("172 kN m", "120 kN m");
        Answer::to(&text.replace("\"profile\": \"HE", &format!("{more}\"profile\": \"HE")))
    };
    let panel = |answer: &Answer| {
        let found = answer.checks().iter().find(|c| {
            c["case"].is_string()
                && c["title"].as_str().is_some_and(|t| t.starts_with("column web panel in shear"))
        });
        found.expect("the panel")["demand"].as_f64().expect("a number")
    };
    let plain = panel(&corner(""));
    assert!(panel(&corner("\"V_Ed\": \"200 kN\", ")) >= plain);
    assert!(panel(&corner("\"V_Ed\": \"-200 kN\", ")) >= plain);
}

/// The stress of the web takes the whole moment of the node where the spec gives N_Ed alone.
#[test]
fn the_stress_of_the_web_takes_the_moment_of_the_node() {
    let factor = |column: &str| {
        let answer = beside(column, 20.0);
        let all: Vec<_> = answer.checks().iter().filter(|c| c["case"] == "U").collect();
        let value = |c: &&serde_json::Value| {
            let steps = c["values"].as_array()?;
            steps.iter().find(|s| s["symbol"] == "k_wc")?["value"].as_f64()
        };
        all.iter().find_map(value).unwrap_or(f64::NAN)
    };
    let (alone, both) = (factor(", N_Ed: -1100 kN"), factor(", N_Ed: -1100 kN, M_Ed: 27.5 kN m"));
    assert!(alone.is_nan() && both.is_nan() || (alone - both).abs() < 1e-9, "{alone} {both}");
}

/// The base joint with two beams and these loads.
fn double(column: &str, loads: &str) -> Answer {
    Answer::to(&format!(
        "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB200, steel: \
         S235{column}}}, beam: {{profile: IPE300, steel: S235}}}}\nplate: {{thickness: 15, width: \
         160, z: [-165, 230]}}\nbolts: {{size: M20, grade: \"8.8\", gauge: 100, rows: [-90, 90, \
         190]}}\nparameters: {{double_sided: true}}\nloads: [{loads}]\n"
    ))
}

/// Equal moments of two beams leave the panel the shear of the column: V_wp,Rd = 303.2 kN.
#[test]
fn the_shear_of_the_column_loads_the_panel_between_equal_moments() {
    let both = |m: f64| {
        format!(
            "{{name: U, end: beam_right, at: column_face, My: 40 kN m, Vz: -75 kN}}, {{name: U, \
             end: beam_left, at: column_face, My: {m} kN m, Vz: -75 kN}}"
        )
    };
    let answer = double(", V_Ed: 330 kN", &both(40.0));
    assert_eq!((answer.code, answer.verdict()), (1, "not_ok"), "{}", answer.said);
    let mut panel = answer.titled("column web panel in shear");
    panel.retain(|c| c["case"] == "U");
    assert_eq!(panel.len(), 1, "{panel:?}");
    near(1e-3 * panel[0]["demand"].as_f64().expect("a number"), 330.0);
    // without it nothing shears the panel
    let none = double("", &both(40.0));
    assert_eq!(none.verdict(), "ok", "{}", none.said);
}

/// V_pl,Rd of the column is 336.9 kN. One of the columns above and below has at least half of what
/// pushes at the node, and V_Ed is the mean of both.
#[test]
fn the_shear_of_a_continuous_column_is_that_of_its_worse_side() {
    let shear = |column: &str, load: &str| {
        let answer = Answer::to(&format!(
            "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB200, steel: \
             S235{column}}}, beam: {{profile: IPE300, steel: S235}}}}\nplate: {{thickness: 15, \
             width: 160, z: [-165, 230]}}\nbolts: {{size: M20, grade: \"8.8\", gauge: 100, rows: \
             [-90, 90, 190]}}\nparameters: {{column_stiffeners: true}}\nloads: [{{name: U, end: \
             beam_right, at: column_face, {load}}}]\n"
        ));
        let found = answer.titled("shear of the column");
        (found.first().map_or(0.0, |c| 1e-3 * c["demand"].as_f64().expect("a number")), answer.code)
    };
    assert_eq!(shear("", "My: 40 kN m, Vz: -75 kN").0, 0.0);
    let alone = shear(", V_Ed: 350 kN", "My: 40 kN m, Vz: -75 kN");
    assert_eq!(alone, (350.0, 1));
    let pushed = shear("", "N: -800 kN");
    assert_eq!(pushed, (400.0, 1));
    let together =
        shear(", N_Ed: -100 kN, M_Ed: 30 kN m, V_Ed: 260 kN", "My: 20 kN m, Vz: -75 kN, N: 180 kN");
    assert_eq!(together, (350.0, 1));
}

/// A column that ends above and below holds nothing but beams in balance.
#[test]
fn a_stub_of_a_column_holds_beams_in_balance_alone() {
    let text = Answer::input(CORNER).replace(
        "\"column_ends_above\": true",
        "\"column_ends_above\": true, \"column_ends_below\": true",
    );
    let answer = Answer::to(&text.replace("172 kN m", "20 kN m"));
    assert_eq!((answer.code, answer.verdict()), (3, "undecided"), "{}", answer.said);
    assert!(answer.said.contains("column_ends_above"), "{}", answer.said);
}

/// N is left out of no joint but as rounding, however strong the beam is; up to 5 % of N_pl,Rd a
/// warning says what the equilibrium of the rows gives.
#[test]
fn a_small_axial_force_counts_in_a_weak_joint() {
    let weak = |rows: &str, loads: &str| {
        Answer::to(&format!(
            "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB200, steel: \
             S235}}, beam: {{profile: IPE300, steel: S235}}}}\nplate: {{thickness: 15, width: 160, \
             z: [-165, 230]}}\nbolts: {{size: M20, grade: \"8.8\", gauge: 100, rows: \
             [{rows}]}}\nloads: [{{name: U, end: beam_right, at: column_face, {loads}}}]\n"
        ))
    };
    // the row needs (10 + 60 x 0.1447)/0.05465 = 342 kN against 191.4 kN
    let warned = weak("-90", "N: 60 kN, My: 10 kN m");
    let found = warned.titled("axial force that the code leaves out, in equilibrium");
    assert_eq!(found.len(), 1, "{}", warned.said);
    assert_eq!(found[0]["status"], "warning");
    near(found[0]["utilisation"].as_f64().expect("a number"), 342.0 / 191.4);
    assert!(
        weak("-90, 90, 190", "N: 10 kN, My: 10 kN m")
            .titled("axial force that the code leaves out, in equilibrium")
            .is_empty()
    );
    // 9 kN are 0.7 % of N_pl,Rd and stay
    let small = weak("-90", "N: 9 kN, My: 10 kN m");
    assert!(!small.said.contains("neglected"), "{}", small.said);
}
