//! Whether the axes of results are those of Bracket: x along the member, z up along the depth of
//! the section.

use super::parts::Parts;
use bracket_base::diag::Diagnostic;
use bracket_base::math::vec3::{V3, cross, dot, norm, scale, sub};
use bracket_base::xml::Element;

/// Sections whose principal axes are along their depth and width: I and H.
const SYMMETRIC: [&str; 4] = ["RolledI", "RolledIPar", "Iw", "Igh"];

/// Cosine of the largest angle between directions that are one; about one degree.
const SAME: f64 = 0.9998;

/// Horizontal part of the direction of a member that stands upright.
const UPRIGHT: f64 = 1e-3;

/// Angle that is none \[rad\].
const NO_ANGLE: f64 = 1e-6;

/// A member whose axes are asked for.
pub struct Axes<'a> {
    /// The model.
    pub parts: &'a Parts<'a>,
    /// The member or element, for messages.
    pub name: &'a str,
    /// Its element.
    pub element: Element<'a>,
    /// Its section.
    pub section: Element<'a>,
    /// The line of its axis.
    pub line: Element<'a>,
    /// Its start and end \[m\].
    pub ends: [V3; 2],
}

/// The unit vector along `v`; a vector of no length stays one.
fn unit(v: V3) -> V3 {
    scale(1.0 / norm(v).max(f64::MIN_POSITIVE), v)
}

/// The unit vector along the part of `v` that is normal to the unit vector `x`.
fn normal(v: V3, x: V3) -> V3 {
    unit(sub(v, scale(dot(v, x), x)))
}

impl Axes<'_> {
    /// Refuses results in this system if their axes are not those of Bracket; `at`: the results.
    pub fn check(&self, system: &str, at: Element<'_>) -> Result<(), Box<Diagnostic>> {
        let Self { parts, name, section, .. } = *self;
        let refused = |what: String, help: &str| {
            Err(parts.fault(at, format!("the forces of `{name}` are in {what}"), help))
        };
        let principal = match system {
            "Principle" => true,
            "Local" => false,
            "Global" => {
                return refused("global axes".into(), "export them in local axes (`Local`)");
            }
            other => return refused(format!("an unknown system `{other}`"), "export them again"),
        };
        let kind = section.text_of("CrossSectionType").unwrap_or("a section of unknown type");
        if principal && !SYMMETRIC.contains(&kind) {
            let what = format!(
                "principal axes, and its section `{}` ({kind}) is no I or H section, whose \
                 principal axes are those of the member",
                parts.name(section)
            );
            return refused(what, "export them in local axes (`Local`)");
        }
        let [start, end] = self.ends;
        let x = unit(sub(end, start));
        let upright = x[0].hypot(x[1]) < UPRIGHT;
        let angle = parts.number_or_zero(self.element, "RotationRx")?
            + parts.number_or_zero(section, "CrossSectionRotation")?;
        // of a turned column in principal axes, My is about the strong axis all the same
        if angle.abs() > NO_ANGLE && !(upright && principal) {
            let what = format!("axes beside which its section is turned by {angle:.3} rad");
            let help = "joints have beams with upright webs; export turned columns in principal \
                        axes (`Principle`)";
            return refused(what, help);
        }
        if upright {
            return Ok(());
        }
        let up = normal([0.0, 0.0, 1.0], x);
        if self.z(x)?.is_some_and(|z| dot(z, up) < SAME) {
            let help = "turn the local axes of the member so that z points up, and export again";
            return refused("local axes whose z does not point up".into(), help);
        }
        Ok(())
    }

    /// The direction of the local z axis, where the line says it; else z is up.
    fn z(&self, x: V3) -> Result<Option<V3>, Box<Diagnostic>> {
        let parts = self.parts;
        let Some(system) = self.line.child("LocalCoordinateSystem") else { return Ok(None) };
        let unknown = |what: &str| {
            let message = format!("`{}` has local axes {what}", self.name);
            parts.fault(system, message, "give them by vectors or by a point (`ZX` or `YX`)")
        };
        match system.kind() {
            None | Some("CoordSystemByZup") => Ok(None),
            Some("CoordSystemByVector") => {
                let vector = |name: &str| {
                    let at = system.child(name).ok_or_else(|| unknown("with a vector missing"))?;
                    parts.vector(at)
                };
                let along = vector("VecX")?;
                if dot(along, x) < SAME * norm(along) {
                    return Err(unknown("whose x is not along the member"));
                }
                Ok(Some(normal(vector("VecZ")?, x)))
            }
            Some("CoordSystemByPoint") => {
                let point = system.child("Point").ok_or_else(|| unknown("without a point"))?;
                let point = parts.vector(point)?;
                let to = normal(sub(point, self.ends[0]), x);
                match system.text_of("InPlane") {
                    Some("ZX" | "XZ") => Ok(Some(to)),
                    Some("YX" | "XY") => Ok(Some(cross(x, to))),
                    _ => Err(unknown("in a plane that is not read")),
                }
            }
            Some(other) => Err(unknown(&format!("of the kind `{other}`"))),
        }
    }
}
