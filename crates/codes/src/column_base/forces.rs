//! Forces of the two sides of a base under N and M: equilibrium of the lever arms of
//! EN 1993-1-8:2005 Table 6.7.
//!
//! M_j,Rd of the table at the constant eccentricity e = M/N is M over the largest utilisation of
//! these forces: `F_T z/(z_C/e + 1)` is the moment at which `(M + N z_C)/z` reaches F_T.

use super::compression::{IBase, under_flange, z_c};
use super::tension_side::{TensionSide, tension_side};
use crate::check::{Unit, within};
use crate::formula::{Formula, Traced};
use bracket_joint::assembly::ColumnBase;

/// A force of one side.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Force {
    /// Compression under the flange.
    Compression(Formula),
    /// Tension of the anchor row.
    Tension(Box<TensionSide>, Formula),
}

/// The forces of a load case: the side of each, 1 at positive x, and its force.
pub(super) type Forces = Vec<(f64, Force)>;

fn length(name: &'static str, value: f64) -> Traced {
    Traced::length(name, value)
}

/// The forces under N, tension positive \[N\], and My, tension at positive x \[N mm\]; an error
/// says why the tables have no tension side. N and My are not both zero.
///
/// # Source
/// EN 1993-1-8:2005 6.2.8.3, Table 6.7, all four signs.
pub(super) fn forces(e: &IBase<'_>, axial: f64, moment: f64) -> Result<Forces, &'static str> {
    let side = if moment < 0.0 { -1.0 } else { 1.0 };
    let (m, zc) = (moment.abs(), z_c(e));
    let moment = || Traced::symbol("M_Ed", m, Unit::Moment);
    let normal = || Traced::force("N_Ed", axial.abs());
    let z_c = || length("z_C", zc);
    let compression = |of: Traced| Force::Compression(Formula::new("F_C,Ed", of, Unit::Force));
    let tension = |row: TensionSide, of: Traced| {
        Force::Tension(Box::new(row), Formula::new("F_T,Ed", of, Unit::Force))
    };
    if axial < 0.0 && within(m, -axial * zc) {
        let both = || z_c() + z_c();
        let near = (normal() * z_c() - moment()) / both();
        let far = (normal() * z_c() + moment()) / both();
        return Ok(vec![(side, compression(near)), (-side, compression(far))]);
    }
    let row = tension_side(e, side)?;
    let z_t = || length("z_T", row.z);
    if axial > 0.0 && within(m, axial * row.z) {
        let other = tension_side(e, -side)?;
        let z_o = || length("z_T,o", other.z);
        let all = || z_t() + z_o();
        let near = (moment() + normal() * z_o()) / all();
        let far = (normal() * z_t() - moment()) / all();
        return Ok(vec![(side, tension(row.clone(), near)), (-side, tension(other.clone(), far))]);
    }
    let arm = || z_t() + z_c();
    let (pull, push) = match axial {
        0.0 => (moment() / arm(), moment() / arm()),
        x if x < 0.0 => {
            ((moment() - normal() * z_c()) / arm(), (moment() + normal() * z_t()) / arm())
        }
        _ => ((moment() + normal() * z_c()) / arm(), (moment() - normal() * z_t()) / arm()),
    };
    Ok(vec![(side, tension(row.clone(), pull)), (-side, compression(push))])
}

/// M_j,Rd beside a constant N, tension positive \[N\], with tension at positive x (`side` 1) or at
/// negative x (−1) \[N mm\]; `None` where the code has none, or N alone is too much.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.7, the forces of which are linear in M.
pub fn moment_resistance(e: &ColumnBase, axial: f64, side: f64) -> Option<f64> {
    let e = &IBase::of(e)?;
    let zc = z_c(e);
    let crushed = |side: f64| under_flange(e, side, 0.0).ok().map(|w| w.value);
    let far = crushed(-side)?;
    if axial < 0.0 {
        // with both flanges in compression
        let most = 2.0 * zc * far + axial * zc;
        let near = axial.abs() * zc - 2.0 * zc * crushed(side)?;
        if most < 0.0 || most < near {
            return None;
        }
        if most <= -axial * zc {
            return Some(most);
        }
    }
    let Ok(row) = tension_side(e, side) else {
        return (axial < 0.0).then_some(-axial * zc);
    };
    let z = row.z + zc;
    let limits = [row.resistance.value * z - axial * zc, far * z + axial * row.z];
    let least = limits[0].min(limits[1]);
    if axial > 0.0 && least < axial * row.z {
        let other = tension_side(e, -side).ok()?;
        let most = row.resistance.value * (row.z + other.z) - axial * other.z;
        let lifts = axial * row.z - other.resistance.value * (row.z + other.z);
        return (most >= 0.0 && most >= lifts).then_some(most.min(axial * row.z));
    }
    Some(least)
}
