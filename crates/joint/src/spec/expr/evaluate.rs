//! Evaluates the syntax tree of an expression and checks dimensions on the way.

use super::node::{Kind, Node};
use super::stock::stock;
use super::value::{ExprError, Value, fault};
use bracket_base::units::{Dim, Quantity, limits};

pub(super) struct Eval<'a> {
    pub(super) text: &'a str,
    pub(super) lookup: &'a mut dyn FnMut(&str) -> Result<Value, String>,
}

impl Eval<'_> {
    pub(super) fn node(&mut self, node: &Node) -> Result<Value, ExprError> {
        let value = match &node.kind {
            Kind::Literal(v) => *v,
            Kind::Name(name) => {
                (self.lookup)(name).map_err(|m| fault(self.text, node.span.clone(), m))?
            }
            Kind::Unary('!', a) => Value::Truth(!self.truth(a)?),
            Kind::Unary(_, a) => {
                let q = self.quantity(a)?;
                Value::Quantity(Quantity { value: -q.value, ..q })
            }
            Kind::Binary(op, a, b) => self.binary(op, a, b, node)?,
            Kind::Call(name, args) => self.call(name, args, node)?,
        };
        match value {
            Value::Quantity(q) if !q.value.is_finite() => Err(fault(
                self.text,
                node.span.clone(),
                format!("the result is not finite ({})", q.value),
            )),
            _ => Ok(value),
        }
    }

    pub(super) fn truth(&mut self, node: &Node) -> Result<bool, ExprError> {
        match self.node(node)? {
            Value::Truth(t) => Ok(t),
            Value::Quantity(_) => {
                Err(fault(self.text, node.span.clone(), "true or false is wanted here"))
            }
        }
    }

    fn quantity(&mut self, node: &Node) -> Result<Quantity, ExprError> {
        match self.node(node)? {
            Value::Quantity(q) => Ok(q),
            Value::Truth(_) => Err(fault(self.text, node.span.clone(), "a number is wanted here")),
        }
    }

    /// Two quantities of the same dimension.
    fn pair(&mut self, a: &Node, b: &Node) -> Result<(f64, f64, Dim), ExprError> {
        let (p, q) = (self.quantity(a)?, self.quantity(b)?);
        if p.dim == q.dim {
            Ok((p.value, q.value, p.dim))
        } else {
            Err(fault(
                self.text,
                b.span.clone(),
                format!("units do not match: {} and {}", p.dim, q.dim),
            ))
        }
    }

    fn binary(&mut self, op: &str, a: &Node, b: &Node, node: &Node) -> Result<Value, ExprError> {
        let overflow = || fault(self.text, node.span.clone(), "the unit's exponent is too large");
        Ok(match op {
            // short-circuit evaluation, so that a condition can protect what follows it
            "and" => Value::Truth(self.truth(a)? && self.truth(b)?),
            "or" => Value::Truth(self.truth(a)? || self.truth(b)?),
            "*" | "/" => {
                let overflow = overflow();
                let (p, q) = (self.quantity(a)?, self.quantity(b)?);
                let (value, sign) =
                    if op == "*" { (p.value * q.value, 1) } else { (p.value / q.value, -1) };
                let dim = q.dim.power(sign).and_then(|d| p.dim.times(d)).ok_or(overflow)?;
                Value::Quantity(Quantity { value, dim })
            }
            "^" => {
                let overflow = overflow();
                let (p, q) = (self.quantity(a)?, self.quantity(b)?);
                if q.dim != Dim::NONE {
                    return Err(fault(self.text, b.span.clone(), "an exponent has no unit"));
                }
                let dim = if p.dim == Dim::NONE {
                    Dim::NONE
                } else if q.value.fract() == 0.0 && q.value.abs() <= 16.0 {
                    p.dim.power(q.value as i8).ok_or(overflow)?
                } else {
                    return Err(fault(
                        self.text,
                        b.span.clone(),
                        "a quantity with a unit takes a whole exponent up to 16",
                    ));
                };
                Value::Quantity(Quantity { value: p.value.powf(q.value), dim })
            }
            "+" | "-" => {
                let (p, q, dim) = self.pair(a, b)?;
                Value::Quantity(Quantity { value: if op == "+" { p + q } else { p - q }, dim })
            }
            _ => {
                let (p, q, _) = self.pair(a, b)?;
                Value::Truth(match op {
                    "<" => !limits::at_least(p, q),
                    "<=" => limits::at_most(p, q),
                    ">" => !limits::at_most(p, q),
                    ">=" => limits::at_least(p, q),
                    "==" => limits::same(p, q),
                    _ => !limits::same(p, q),
                })
            }
        })
    }

    fn call(&mut self, name: &str, args: &[Node], node: &Node) -> Result<Value, ExprError> {
        const FUNCTIONS: [&str; 12] = [
            "min", "max", "abs", "sqrt", "ceil", "round_up", "stock", "if", "sin", "cos", "tan",
            "atan",
        ];
        if !FUNCTIONS.contains(&name) {
            let hint = bracket_base::diag::did_you_mean(name, FUNCTIONS);
            let known = FUNCTIONS.join(", ");
            return Err(fault(
                self.text,
                node.span.clone(),
                format!("unknown function `{name}`{hint} (known: {known})"),
            ));
        }
        let wanted = match name {
            "min" | "max" => args.len().max(1),
            "round_up" => 2,
            "if" => 3,
            _ => 1,
        };
        if args.len() != wanted {
            let message = format!("`{name}` takes {wanted} argument(s), not {}", args.len());
            return Err(fault(self.text, node.span.clone(), message));
        }
        match name {
            "if" => {
                let chosen = if self.truth(&args[0])? { &args[1] } else { &args[2] };
                self.node(chosen)
            }
            "abs" | "ceil" | "sqrt" => {
                let q = self.quantity(&args[0])?;
                match name {
                    "abs" => Ok(Value::Quantity(Quantity { value: q.value.abs(), ..q })),
                    "ceil" if q.dim == Dim::NONE => Ok(Value::number(q.value.ceil())),
                    "sqrt"
                        if q.dim.length % 2 == 0
                            && q.dim.force % 2 == 0
                            && q.dim.angle % 2 == 0 =>
                    {
                        let dim = Dim {
                            length: q.dim.length / 2,
                            force: q.dim.force / 2,
                            angle: q.dim.angle / 2,
                        };
                        Ok(Value::Quantity(Quantity { value: q.value.sqrt(), dim }))
                    }
                    "ceil" => Err(fault(
                        self.text,
                        node.span.clone(),
                        "`ceil` takes a number without unit; use round_up(x, step)",
                    )),
                    _ => Err(fault(
                        self.text,
                        node.span.clone(),
                        format!("`sqrt` of a {} has no unit", q.dim),
                    )),
                }
            }
            "sin" | "cos" | "tan" => {
                let q = self.quantity(&args[0])?;
                if q.dim != Dim::ANGLE {
                    let message = format!("`{name}` takes an angle, `6 deg`, not a {}", q.dim);
                    return Err(fault(self.text, args[0].span.clone(), message));
                }
                let of = match name {
                    "sin" => f64::sin,
                    "cos" => f64::cos,
                    _ => f64::tan,
                };
                Ok(Value::number(of(q.value)))
            }
            "atan" => {
                let q = self.quantity(&args[0])?;
                if q.dim != Dim::NONE {
                    let message = format!("`atan` takes a number without unit, not a {}", q.dim);
                    return Err(fault(self.text, args[0].span.clone(), message));
                }
                Ok(Value::angle(q.value.atan()))
            }
            "stock" => {
                let q = self.quantity(&args[0])?;
                if q.dim != Dim::LENGTH {
                    let message = format!("`stock` takes a thickness, not a {}", q.dim);
                    return Err(fault(self.text, args[0].span.clone(), message));
                }
                Ok(Value::length(stock(q.value)))
            }
            "round_up" => {
                let (x, step, dim) = self.pair(&args[0], &args[1])?;
                if step <= 0.0 {
                    return Err(fault(
                        self.text,
                        args[1].span.clone(),
                        "the step of `round_up` must be positive",
                    ));
                }
                // a value that exceeds a multiple only by rounding error counts as the multiple:
                // 0.1 + 0.2 exceeds 0.3
                Ok(Value::Quantity(Quantity { value: (x / step - 1e-9).ceil() * step, dim }))
            }
            _ => {
                let mut best = self.quantity(&args[0])?;
                for a in &args[1..] {
                    let (_, x, _) = self.pair(&args[0], a)?;
                    best.value = if name == "min" { best.value.min(x) } else { best.value.max(x) };
                }
                Ok(Value::Quantity(best))
            }
        }
    }
}
