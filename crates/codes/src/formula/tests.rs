//! Formulas as text, and text against value.

mod evaluator;

use super::{Formula, Number, Style, Traced};
use crate::unit::Unit;
use evaluator::evaluate;

fn length(name: &'static str, value: f64) -> Traced {
    Traced::symbol(name, value, Unit::Length)
}

/// The symbols and the numbers of a term, with its value.
fn printed(of: Traced) -> (String, String) {
    (of.term().print(Style::Symbols), of.term().print(Style::Numbers))
}

#[test]
fn brackets_stand_where_a_reader_needs_them() {
    let [a, b, c] = [length("a", 1.0), length("b", 2.0), length("c", 3.0)];
    let n = Traced::from;
    let (a, b, c) = (|| a.clone(), || b.clone(), || c.clone());
    for (term, symbols, numbers) in [
        (a() + b() * c(), "a + b c", "1 + 2 · 3"),
        ((a() + b()) * c(), "(a + b) c", "(1 + 2) · 3"),
        (a() - (b() - c()), "a − (b − c)", "1 − (2 − 3)"),
        (a() - b() - c(), "a − b − c", "1 − 2 − 3"),
        (a() + (b() + c()), "a + b + c", "1 + 2 + 3"),
        (a() / (b() * c()), "a/(b c)", "1/(2 · 3)"),
        (a() / b() / c(), "a/(b c)", "1/(2 · 3)"),
        (a() / b() * c(), "a c/b", "1 · 3/2"),
        (a() / (b() / c()), "a c/b", "1 · 3/2"),
        ((a() + b()) / (a() - c()), "(a + b)/(a − c)", "(1 + 2)/(1 − 3)"),
        (n(2.0) * a() * n(3.0), "2 a · 3", "2 · 1 · 3"),
        (n(2.0).sqrt() * a(), "√2 a", "√2 · 1"),
        ((a() + b()).sqrt(), "√(a + b)", "√(1 + 2)"),
        ((a() * b()).powi(2), "(a b)²", "(1 · 2)²"),
        (a().powi(3) / b(), "a³/b", "1³/2"),
        (a().powf(n(1.5)), "a^1.5", "1^1.5"),
        (-a() * b(), "(−a) b", "(−1) · 2"),
        ((a() - c()).abs(), "|a − c|", "|1 − 3|"),
        (a().min(b()).min(c()), "min(a, b, c)", "min(1, 2, 3)"),
        (a().max(b().min(c())), "max(a, min(b, c))", "max(1, min(2, 3))"),
        (n(1.0) / a(), "1/a", "1/1"),
        (a() * length("d", -4.0), "a d", "1 · (-4)"),
        (a() - length("d", -4.0), "a − d", "1 − (-4)"),
        (a() - length("d", -4.0) / b(), "a − d/b", "1 − (-4/2)"),
        (Traced::series([a() * b(), a() * c()]), "Σ a b", "1 · 2 + 1 · 3"),
    ] {
        assert_eq!(printed(term), (symbols.to_owned(), numbers.to_owned()));
    }
}

#[test]
fn forces_stand_in_kilonewtons_with_their_unit() {
    let force = Traced::symbol("F_Ed", 12_340.0, Unit::Force);
    let formula = Formula::new("F_w,Ed", force / length("l_eff", 100.0), Unit::ForcePerLength);
    assert_eq!(formula.text(), "F_w,Ed = F_Ed/l_eff = 12.34 kN/100 = 123.4 N/mm");
    let alone = Formula::new("", Traced::from(3.0), Unit::Length);
    assert_eq!(alone.text(), "3 mm");
    let named = (Traced::from(2.0) * length("a", 4.0)).named("l", Unit::Length);
    assert_eq!(printed(named.clone() + length("b", 1.0)).0, "l + b");
    assert_eq!(Formula::new("l", named, Unit::Length).text(), "l = 2 a = 2 · 4 = 8 mm");
}

/// Trees of all operations: the text with all digits gives the value, and so does the text with
/// symbols.
#[test]
fn a_printed_formula_has_the_value_of_its_operations() {
    // a small generator of its own (xorshift), so that the trees are the same everywhere
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = move |below: u64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state % below
    };
    const NAMES: [&str; 6] = ["k2", "f_ub", "A_s", "γ_M2", "σ_com,Ed", "Σℓ_eff,1"];
    for _ in 0..3000 {
        let values: Vec<f64> = NAMES.iter().map(|_| 0.1 + next(1000) as f64 / 77.0).collect();
        let leaf = |i: u64| match i as usize {
            i if i < NAMES.len() => Traced::symbol(NAMES[i], values[i], Unit::Number),
            i => Traced::from(0.25 * i as f64),
        };
        let mut tree = leaf(next(9));
        for _ in 0..1 + next(7) {
            let other = leaf(next(9));
            tree = match next(13) {
                0 => tree + other,
                1 => other + tree,
                2 => tree - other,
                3 => other - tree,
                4 => tree * other,
                5 => other * tree,
                6 => tree / other,
                7 => other / (tree.abs() + Traced::from(0.5)),
                8 => tree.abs().sqrt(),
                9 => tree.min(other),
                10 => other.max(tree),
                11 => -tree,
                _ => tree.powi(2),
            };
        }
        let value = tree.value();
        let symbols = tree.term().symbols();
        let names: Vec<(&str, f64)> = symbols.iter().map(|s| (&*s.0.id, s.1)).collect();
        for (text, known) in [
            (tree.term().print(Style::Exact), &[][..]),
            (tree.term().print(Style::Symbols), &names),
        ] {
            let read = evaluate(&text, known).unwrap_or_else(|e| panic!("{text}: {e}"));
            let size = value.abs().max(1e-3);
            assert!((read - value).abs() <= 1e-9 * size, "{text}: {read} against {value}");
        }
    }
}

#[test]
fn a_derivation_survives_a_file() {
    let f = Traced::symbol("F", f64::INFINITY, Unit::Force) / length("l", 3.0);
    let derivation = super::Derivation::from("words").then(Formula::new("q", f, Unit::Number));
    let json = serde_json::to_string(&derivation).expect("json");
    assert!(json.starts_with(r#"{"formula":"words; q = F/l = "#), "{json}");
    assert_eq!(serde_json::from_str::<super::Derivation>(&json).expect("read"), derivation);
    let old = serde_json::from_str::<super::Derivation>(r#"{"formula":"as it was"}"#);
    assert_eq!(old.expect("read").text(), "as it was");
    // a text that its data do not say is kept as it stands, so that a comparison finds it
    let other = json.replace("words; q", "words; k");
    let read = serde_json::from_str::<super::Derivation>(&other).expect("read");
    assert!(read.text().to_string().starts_with("words; k = ") && read != derivation, "{read:?}");
}
