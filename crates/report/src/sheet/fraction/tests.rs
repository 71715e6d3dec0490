use super::*;

/// Pieces as text: fractions in braces.
fn shown(pieces: &[Piece]) -> String {
    let one = |p: &Piece| match (p.top.is_empty(), p.symbol) {
        (false, _) => format!("{{{}|{}}}", shown(&p.top), shown(&p.bottom)),
        (_, true) if !p.below.is_empty() => format!("{}_{}", p.text, p.below),
        _ => p.text.replace('\u{a0}', " "),
    };
    pieces.iter().map(one).collect()
}

#[test]
fn strokes_become_fractions_where_they_divide() {
    for (text, want) in [
        ("F_t,Rd = k2 f_ub A_s / γ_M2 = 5", "F_t,Rd = {k_2 f_ub A_s|γ_M2} = 5"),
        ("0.9 f_y A_vc/(√3 γ_M0)", "{0.9 f_y A_vc|√3 γ_M0}"),
        ("30 kN m/32.14 kN m = 0.93", "{30 kN m|32.14 kN m} = 0.93"),
        (
            "S_j,ini/η = 8852 kN m/rad/2 = 4426 kN m/rad",
            "{S_j,ini|η} = {8852 kN m/rad|2} = 4426 kN m/rad",
        ),
        ("|(M_b1 − M_b2)/z|", "|{M_b1 − M_b2|z}|"),
        ("E z²/Σ(1/k)", "{E z²|Σ({1|k})}"),
        ("(1 − F_t,Ed/(1.4 F_t,Rd)) F_v,Rd", "(1 − {F_t,Ed|1.4 F_t,Rd}) F_v,Rd"),
        ("f_y/γ_M0 (1 − n)/(1 − 0.5 a)", "{f_y|γ_M0} {1 − n|1 − 0.5 a}"),
        (
            "(484000 − 0 · 1647²/(4 · 6.6)) · 235/1 · 1",
            "{(484000 − {0 · 1647²|4 · 6.6}) · 235|1} · 1",
        ),
        (
            "max(F_v,Ed/F_v,Rd + F_t,Ed/(1.4 F_t,Rd), 1/2)",
            "max({F_v,Ed|F_v,Rd} + {F_t,Ed|1.4 F_t,Rd}, {1|2})",
        ),
        ("Σ F_r m/(m + m2)", "Σ {F_r m|m + m_2}"),
        ("r + d_w/2 = 15 + 30/2 mm", "r + {d_w|2} = 15 + 30/2 mm"),
        ("with A_net f_y/γ_M0", "with {A_net f_y|γ_M0}"),
        ("it is of a d/2 or less", "it is of a {d|2} or less"),
        ("a/b/c", "{{a|b}|c}"),
        ("(d/1.9) √(f_ub/f_y)", "({d|1.9}) √({f_ub|f_y})"),
        ("and/or, 5 N/mm, b/", "and/or, 5 N/mm, b/"),
        ("(open/2", "(open/2"),
        ("(x + 1)²/2", "{(x + 1)²|2}"),
        ("l_eff F_w,Rd/ 2", "{l_eff F_w,Rd|2}"),
        ("A_w²/(4 t_w)", "{A_w²|4 t_w}"),
    ] {
        assert_eq!(shown(&formula(text)), want, "{text}");
    }
}

/// A calculator for numbers, `+ − · /`, blanks as products, brackets, roots and squares; products
/// and quotients from the left to the right.
struct Calculator<'a> {
    rest: &'a [char],
}

impl Calculator<'_> {
    fn blanks(&mut self) {
        while self.rest.first() == Some(&' ') {
            self.rest = &self.rest[1..];
        }
    }

    fn next(&mut self, c: char) -> bool {
        self.blanks();
        let found = self.rest.first() == Some(&c);
        if found {
            self.rest = &self.rest[1..];
        }
        found
    }

    fn sum(&mut self) -> Option<f64> {
        let mut value = self.product()?;
        loop {
            if self.next('+') {
                value += self.product()?;
            } else if self.next('−') {
                value -= self.product()?;
            } else {
                return Some(value);
            }
        }
    }

    fn product(&mut self) -> Option<f64> {
        let mut value = self.factor()?;
        loop {
            if self.next('·') {
                value *= self.factor()?;
            } else if self.next('/') {
                value /= self.factor()?;
            } else if self
                .rest
                .first()
                .is_some_and(|c| c.is_ascii_digit() || matches!(c, '(' | '√'))
            {
                value *= self.factor()?;
            } else {
                return Some(value);
            }
        }
    }

    fn factor(&mut self) -> Option<f64> {
        self.blanks();
        let mut value = if self.next('√') {
            self.factor()?.sqrt()
        } else if self.next('(') {
            let value = self.sum()?;
            self.next(')').then_some(value)?
        } else {
            let end = self.rest.iter().take_while(|c| c.is_ascii_digit() || **c == '.').count();
            let text: String = self.rest[..end].iter().collect();
            self.rest = &self.rest[end..];
            text.parse().ok()?
        };
        while self.rest.first() == Some(&'²') {
            self.rest = &self.rest[1..];
            value *= value;
        }
        Some(value)
    }
}

fn value(text: &str) -> Option<f64> {
    let mut text = text.to_string();
    for unit in UNITS {
        text = text.replace(&format!(" {unit}"), "");
    }
    let chars: Vec<char> = text.chars().collect();
    let mut calculator = Calculator { rest: &chars };
    let value = calculator.sum()?;
    calculator.blanks();
    calculator.rest.is_empty().then_some(value)
}

/// Pieces in one line again, with brackets round both parts of a fraction.
fn linear(pieces: &[Piece]) -> String {
    let one = |p: &Piece| match p.top.is_empty() {
        false => format!("(({})/({}))", linear(&p.top), linear(&p.bottom)),
        true => p.text.replace('\u{a0}', " "),
    };
    pieces.iter().map(one).collect()
}

/// The fractions of real formulas have the value of the line that they come from, and this is what
/// the formula says.
#[test]
fn fractions_have_the_value_of_the_line() {
    let formulas = [
        "0.6 · 800 · 157 / 1.25 = 60288",
        "10.2 · 235/1 · 0.8 · 1.25/(√2 · 360) = 4.708",
        "2214 · 235/(√3 · 1) = 300390",
        "(484000 − 0.5 · 1647²/(4 · 6.6)) · 235/1 · (1 − 0.2)/(1 − 0.5 · 0.3) = 95684000",
        "(2 · 1809 + 30 · 180.9)/(41.7 + 30) = 126.15",
        "210000 · 179.7²/(1/4.28 + 1/8.74 + 1/2.393) = 8852500000",
        "15.22/60.29 + 84.41/(1.4 · 90.43) = 0.9192",
        "0.36 · 16 · √(800/235) = 10.628",
        "77.25 kN · 31.1/(31.1 + 40) + 139.8 kN · 31.1/(31.1 + 49.3) = 87.87",
        "8852 kN m/rad/2 = 4426",
        "8 · 210000 · 57900000/8852 = 10989000000",
        "12/2/3 · 4 = 8",
    ];
    for line in formulas {
        let (left, right) = line.split_once(" = ").expect("an equation");
        let [in_line, in_fractions, said] =
            [left, &linear(&formula(left)), right].map(|t| value(t).unwrap_or(f64::NAN));
        assert!((in_line - in_fractions).abs() <= 1e-12 * in_line.abs(), "{line}: {in_fractions}");
        assert!((in_line - said).abs() <= 2e-3 * said.abs(), "{line}: {in_line}");
        let stroke = |p: &Piece| !p.top.is_empty();
        assert!(formula(left).iter().any(|p| stroke(p) || p.text.contains('√')), "{line}");
    }
}
