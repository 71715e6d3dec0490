use super::*;

/// The limit of turns holds before any of them is in memory.
#[test]
fn loops_beyond_the_limit_are_refused() {
    let of = |name: &str, n: usize| Loop {
        each: name.into(),
        values: vec![Expr::parse("1").expect("a number"); n],
        list: None,
        labels: Vec::new(),
    };
    let scope = <Scope as std::default::Default>::default();
    let some = scope.turns(&[of("a", 300), of("b", 300)], None).expect("90 000");
    assert_eq!(some.len(), 90_000);
    for loops in [vec![of("a", 400), of("b", 400)], vec![of("a", 100_001)]] {
        let e = scope.turns(&loops, None).map(drop).expect_err("too many");
        assert!(e.message.contains("more than 100000 turns"), "{e:?}");
    }
}
