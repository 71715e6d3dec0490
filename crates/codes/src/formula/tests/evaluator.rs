//! Reads a printed formula and computes it: an implementation of its own, which knows nothing of
//! the tree that was printed.
//!
//! Blanks between factors bind more strongly than the stroke: `a f_u/(√3 β_w)`.

/// The value of a text; `names` are the symbols with their values.
pub fn evaluate(text: &str, names: &[(&str, f64)]) -> Result<f64, String> {
    let mut names: Vec<(Vec<char>, f64)> =
        names.iter().map(|(name, value)| (name.chars().collect(), *value)).collect();
    // the longest name that fits is meant
    names.sort_by_key(|(name, _)| std::cmp::Reverse(name.len()));
    let mut reader = Reader { chars: text.chars().collect(), at: 0, names };
    let value = reader.sum()?;
    match reader.at == reader.chars.len() {
        true => Ok(value),
        false => Err(format!("does not end at character {}", reader.at)),
    }
}

struct Reader {
    chars: Vec<char>,
    at: usize,
    names: Vec<(Vec<char>, f64)>,
}

impl Reader {
    fn take(&mut self, text: &str) -> bool {
        let text: Vec<char> = text.chars().collect();
        let found = self.chars[self.at..].starts_with(&text);
        if found {
            self.at += text.len();
        }
        found
    }

    fn sum(&mut self) -> Result<f64, String> {
        let mut value = if self.take("−") { -self.quotient()? } else { self.quotient()? };
        loop {
            if self.take(" + ") {
                value += self.quotient()?;
            } else if self.take(" − ") {
                value -= self.quotient()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn quotient(&mut self) -> Result<f64, String> {
        let mut value = self.product()?;
        while self.take("/") {
            value /= self.factor()?;
        }
        Ok(value)
    }

    fn product(&mut self) -> Result<f64, String> {
        let mut value = self.factor()?;
        loop {
            let sum = [" + ", " − "].iter().any(|sign| {
                let sign: Vec<char> = sign.chars().collect();
                self.chars[self.at..].starts_with(&sign)
            });
            if sum {
                return Ok(value);
            }
            if self.take(" · ") || self.take(" ") {
                value *= self.factor()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn factor(&mut self) -> Result<f64, String> {
        let mut value = self.atom()?;
        loop {
            if self.take("²") {
                value *= value;
            } else if self.take("³") {
                value = value * value * value;
            } else if self.take("^") {
                value = value.powf(self.atom()?);
            } else {
                return Ok(value);
            }
        }
    }

    fn atom(&mut self) -> Result<f64, String> {
        if self.take("√") {
            return Ok(self.atom()?.sqrt());
        }
        if self.take("min(") {
            return Ok(self.list()?.into_iter().fold(f64::INFINITY, f64::min));
        }
        if self.take("max(") {
            return Ok(self.list()?.into_iter().fold(f64::NEG_INFINITY, f64::max));
        }
        if self.take("(") {
            let value = self.sum()?;
            return if self.take(")") { Ok(value) } else { Err("`)` is missing".into()) };
        }
        if self.take("|") {
            let value = self.sum()?;
            return if self.take("|") { Ok(value.abs()) } else { Err("`|` is missing".into()) };
        }
        let known = self.names.iter().find(|(n, _)| self.chars[self.at..].starts_with(n));
        if let Some((name, value)) = known {
            self.at += name.len();
            return Ok(*value);
        }
        self.number()
    }

    fn list(&mut self) -> Result<Vec<f64>, String> {
        let mut out = vec![self.sum()?];
        while self.take(", ") {
            out.push(self.sum()?);
        }
        if self.take(")") { Ok(out) } else { Err("`)` is missing behind a list".into()) }
    }

    fn number(&mut self) -> Result<f64, String> {
        let start = self.at;
        for c in ["-", "inf", "NaN"] {
            self.take(c);
        }
        while self.chars.get(self.at).is_some_and(|c| c.is_ascii_digit() || matches!(c, '.' | 'e'))
            || (self.chars.get(self.at) == Some(&'-') && self.chars.get(self.at - 1) == Some(&'e'))
        {
            self.at += 1;
        }
        let text: String = self.chars[start..self.at].iter().collect();
        text.parse().map_err(|_| format!("no number at character {start}: `{text}`"))
    }
}
