//! The equivalent T-stub in tension: EN 1993-1-8:2005 Table 6.2.

use crate::check::{CheckId, Unit, within};
use crate::formula::{Number, Traced};
use crate::worked::Worked;
use serde::{Deserialize, Serialize};

/// Failure mode of a T-stub.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Mode {
    /// Complete yielding of the flange.
    #[serde(rename = "mode 1")]
    Flange,
    /// Bolt failure with yielding of the flange.
    #[serde(rename = "mode 2")]
    FlangeAndBolts,
    /// Bolt failure.
    #[serde(rename = "mode 3")]
    Bolts,
    /// Yielding of the flange without prying forces.
    #[serde(rename = "mode 1-2")]
    FlangeWithoutPrying,
}

impl Mode {
    /// The mode as the code numbers it.
    pub fn name(self) -> &'static str {
        match self {
            Mode::Flange => "mode 1",
            Mode::FlangeAndBolts => "mode 2",
            Mode::Bolts => "mode 3",
            Mode::FlangeWithoutPrying => "mode 1-2",
        }
    }

    /// The number of the mode alone, as a column of a table has it.
    pub fn number(self) -> &'static str {
        match self {
            Mode::Flange => "1",
            Mode::FlangeAndBolts => "2",
            Mode::Bolts => "3",
            Mode::FlangeWithoutPrying => "1-2",
        }
    }

    /// Whether bending of the flange takes part in the failure.
    pub fn bends(self) -> bool {
        self != Mode::Bolts
    }
}

/// Whether prying forces develop.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Prying {
    /// They develop: the flange bears at its edges.
    #[default]
    Develops,
    /// They do not: the bolts are so long that the flange lifts off.
    Absent,
    /// They develop and load the bolts, but the flange gains nothing by them: column bases,
    /// EN 1993-1-8:2005 6.2.6.11(2).
    BoltsOnly,
}

/// A T-stub flange with its bolts. Lengths in mm, forces in N, strengths in MPa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TStub {
    /// Distance from the bolt to the plastic hinge at the web or weld.
    pub m: f64,
    /// Distance from the bolt to where the prying force acts: min(e_min, 1.25 m).
    pub n: f64,
    /// Thickness of the flange.
    pub thickness: f64,
    /// Nominal yield strength of the flange.
    pub fy: f64,
    /// Σ ℓ_eff,1 of the rows.
    pub length1: f64,
    /// Σ ℓ_eff,2 of the rows.
    pub length2: f64,
    /// Σ F_t,Rd of all bolts.
    pub bolts: f64,
    /// γ_M0.
    pub gamma_m0: f64,
    /// Whether prying forces develop.
    pub prying: Prying,
    /// e_w = d_w/4 of the alternative method for mode 1, with d_w the diameter of the washer or the
    /// width across points of head or nut; `None` for the first method.
    pub washer_quarter: Option<f64>,
}

/// Resistance of a T-stub \[N\].
#[derive(Clone, Debug, PartialEq)]
pub struct Resistance {
    /// The mode that decides.
    pub mode: Mode,
    /// Force of all bolts at that resistance, prying included; at most ΣF_t,Rd.
    pub bolts: f64,
    /// The resistance of each mode.
    pub modes: Vec<(Mode, f64)>,
    /// The least of the modes, with its derivation; each mode is a step of it.
    pub worked: Worked,
}

impl TStub {
    /// Design tension resistance.
    ///
    /// `M_pl = 0.25 Σℓ_eff t_f² f_y/γ_M0`; mode 1 `4 M_pl,1/m`, by the alternative method
    /// `(8n − 2e_w) M_pl,1/(2mn − e_w(m + n))`; mode 2 `(2 M_pl,2 + n ΣF_t,Rd)/(m + n)`; mode 3
    /// `ΣF_t,Rd`; without prying `2 M_pl,1/m` in place of modes 1 and 2; with prying for the bolts
    /// only `2 M_pl,1/m` in place of mode 1.
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 6.2, without backing plates (6.2.4.3).
    pub fn resistance(&self) -> Resistance {
        let plastic =
            |length: f64| 0.25 * length * self.thickness * self.thickness * self.fy / self.gamma_m0;
        let plastic @ [mpl1, mpl2] = [plastic(self.length1), plastic(self.length2)];
        let modes: &[Mode] = match self.prying {
            Prying::Absent => &[Mode::FlangeWithoutPrying, Mode::Bolts],
            Prying::Develops => &[Mode::Flange, Mode::FlangeAndBolts, Mode::Bolts],
            Prying::BoltsOnly => &[Mode::FlangeWithoutPrying, Mode::FlangeAndBolts, Mode::Bolts],
        };
        let modes: Vec<(Mode, f64)> =
            modes.iter().map(|mode| (*mode, self.of_mode(*mode, plastic))).collect();
        // of equal modes the first decides
        let least = *modes.iter().fold(&modes[0], |a, b| if within(a.1, b.1) { a } else { b });
        // tracing a formula takes longer than computing it: only that of the mode that decides
        let force: Traced = self.of_mode(least.0, plastic);
        let (clause, id) = ("EN 1993-1-8:2005 Table 6.2", CheckId::TStub);
        let mut worked = Worked::of(clause, id, "F_T,Rd", force, Unit::Force)
            .after(least.0.name())
            .with("m", self.m, Unit::Length)
            .with("n", self.n, Unit::Length)
            .with("Σℓ_eff,1", self.length1, Unit::Length)
            .with("Σℓ_eff,2", self.length2, Unit::Length)
            .with("M_pl,1", mpl1, Unit::Moment)
            .with("M_pl,2", mpl2, Unit::Moment);
        for (mode, value) in &modes {
            worked = worked.with(mode.name(), *value, Unit::Force);
        }
        // mode 1: the prying force Q = M_pl/n of either edge beside the hinge at the bolts, a share
        // m/(2n) of the force of the T-stub; mode 2: the bolts are at F_t,Rd
        let bolts = match (least.0, self.prying) {
            (Mode::Flange, _) => least.1 + 2.0 * mpl1 / self.n,
            (Mode::FlangeAndBolts | Mode::Bolts, _) => self.bolts,
            (Mode::FlangeWithoutPrying, Prying::BoltsOnly) => {
                least.1 * (1.0 + 0.5 * self.m / self.n)
            }
            (Mode::FlangeWithoutPrying, _) => least.1,
        };
        Resistance { mode: least.0, bolts: bolts.min(self.bolts), modes, worked }
    }

    /// Resistance of a mode \[N\] with M_pl,1 and M_pl,2 \[N mm\].
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 6.2.
    fn of_mode<N: Number>(&self, mode: Mode, [mpl1, mpl2]: [f64; 2]) -> N {
        let number = N::from;
        let m = N::symbol("m", self.m, Unit::Length);
        let n = || N::symbol("n", self.n, Unit::Length);
        let mpl1 = || N::symbol("M_pl,1", mpl1, Unit::Moment);
        let bolts = || N::symbol("ΣF_t,Rd", self.bolts, Unit::Force);
        match (mode, self.washer_quarter) {
            (Mode::FlangeWithoutPrying, _) => number(2.0) * mpl1() / m,
            (Mode::Flange, None) => number(4.0) * mpl1() / m,
            (Mode::Flange, Some(ew)) => {
                let ew = N::symbol("e_w", ew, Unit::Length);
                let below = number(2.0) * m.clone() * n() - ew.clone() * (m + n());
                (number(8.0) * n() - number(2.0) * ew) * mpl1() / below
            }
            (Mode::FlangeAndBolts, _) => {
                let mpl2 = N::symbol("M_pl,2", mpl2, Unit::Moment);
                (number(2.0) * mpl2 + n() * bolts()) / (m + n())
            }
            (Mode::Bolts, _) => bolts(),
        }
    }
}

/// Whether prying forces develop in a T-stub of `rows` rows: where the bolts are no longer than
/// L_b*.
///
/// `L_b ≤ L_b* = 8.8 m³ A_s n_b/(Σℓ_eff,1 t_f³)`; `elongation` L_b \[mm\], `stress_area` A_s of one
/// bolt \[mm²\].
///
/// # Source
/// EN 1993-1-8:2005 Table 6.2 with the corrigendum of 2009 (n_b rows of two bolts).
pub fn prying(
    elongation: f64,
    m: f64,
    stress_area: f64,
    rows: usize,
    length1: f64,
    thickness: f64,
) -> Prying {
    let limit = 8.8 * m.powi(3) * stress_area * rows as f64 / (length1 * thickness.powi(3));
    if within(elongation, limit) { Prying::Develops } else { Prying::Absent }
}
