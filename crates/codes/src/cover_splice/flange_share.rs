//! Forces of a flange by its elastic share of axial force and moment.

use super::least_forces::{BESIDE_CONTACT, Demand};
use super::side::Side;
use crate::check::{Unit, largest};
use crate::eurocode::i_section::Section;
use crate::formula::{Formula, Number, Traced};
use bracket_joint::assembly::{CoverSplice, SpliceUse, Way};

/// I_w of the web between the flanges \[mm⁴\].
pub(super) fn web_inertia(s: &Section) -> f64 {
    s.tw * s.web_depth().powi(3) / 12.0
}

/// 1 − A_w/A, A_w of the web between the flanges.
fn axial_share(s: &Section) -> Traced {
    let web = Traced::area("A_w", s.web_depth() * s.tw);
    Traced::from(1.0) - web / Traced::area("A", s.area)
}

/// What a flange of a load case carries. A force that does not occur is `None`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FlangeForces {
    /// Tension.
    pub tension: Option<Formula>,
    /// Compression of the flange itself.
    pub compression: Option<Formula>,
    /// Compression that its covers transfer; less than that of the flange beside contact.
    pub transferred: Option<Formula>,
}

impl FlangeForces {
    /// The forces that bolts transfer.
    pub fn of_bolts(&self) -> impl Iterator<Item = &Formula> {
        [&self.tension, &self.transferred].into_iter().flatten()
    }
}

/// Force of a flange, tension positive \[N\], with the term of its size.
///
/// `F_f = ±(1 − I_w/I) M/(h − t_f) + (1 − A_w/A) N/2`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.7.1(16); elastic distribution, SCI P398.
fn force(s: &Section, flange: Way, d: &Demand) -> (f64, Traced) {
    let n = Traced::from;
    let lever = Traced::length("h", s.h) - Traced::length("t_f", s.tf);
    let inertia = Traced::number("I_w", web_inertia(s)) / Traced::number("I", s.i);
    let moment = Traced::symbol("M_Ed", d.moment.abs(), Unit::Moment);
    let moment = (n(1.0) - inertia) * moment / lever;
    let axial = axial_share(s) * Traced::force("N_Ed", d.axial.abs()) / n(2.0);
    let pulls = if flange == Way::Up { d.moment } else { -d.moment };
    let signs = [pulls, d.axial].map(|x| if x < 0.0 { -1.0 } else { 1.0 });
    let value = signs[0] * moment.value() + signs[1] * axial.value();
    let size = match (d.moment == 0.0, d.axial == 0.0) {
        (_, true) => moment,
        (true, false) => axial,
        (false, false) if signs[0] == signs[1] => moment + axial,
        (false, false) if moment.value() >= axial.value() => moment - axial,
        (false, false) => axial - moment,
    };
    (value, size)
}

/// The forces of a flange under the actions on its member.
pub(super) fn flange_forces(
    e: &CoverSplice,
    side: &Side<'_>,
    flange: Way,
    demands: &[Demand],
) -> FlangeForces {
    let s = &side.section;
    let all: Vec<(f64, Traced)> = demands.iter().map(|d| force(s, flange, d)).collect();
    let most = |sign: f64| {
        let acting = all.iter().filter(|(value, _)| sign * value > 0.0);
        let worst = largest(acting, |(value, _)| sign * value);
        worst.map(|(_, size)| Formula::new("F_f,Ed", size.clone(), Unit::Force))
    };
    let compression = most(-1.0);
    let transferred = match e.used {
        SpliceUse::Column { contact: true } => {
            let push = demands.iter().map(|d| -d.axial).fold(0.0, f64::max);
            let part = axial_share(s) * Traced::force("N_Ed", push) / Traced::from(2.0);
            let part = Traced::from(BESIDE_CONTACT) * part;
            (push > 0.0).then(|| Formula::new("F_f,Ed", part, Unit::Force))
        }
        _ => compression.clone(),
    };
    FlangeForces { tension: most(1.0), compression, transferred }
}
