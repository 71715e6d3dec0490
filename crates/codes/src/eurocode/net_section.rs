//! Sections of plates beside their holes: EN 1993-1-1:2005 6.2.2 to 6.2.6, EN 1993-1-8:2005 3.10.1.

use super::plate_section::BENDING_BESIDE_SHEAR;
use super::yielding::{in_shear, plastic, plastic_shear};
use crate::check::CheckId;
use crate::formula::{Formula, Number, Traced};
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::strength::Strength;

/// A plate with holes in a straight line across the force. Areas in mm².
#[derive(Clone, Debug, PartialEq)]
pub struct NetSection<'a> {
    /// Area without holes.
    pub gross: Traced,
    /// Area of the holes.
    pub holes: Traced,
    /// Its steel.
    pub steel: &'a Strength,
    /// γ_M0.
    pub gamma_m0: f64,
    /// γ_M2.
    pub gamma_m2: f64,
}

impl NetSection<'_> {
    fn gross(&self) -> Formula {
        Formula::new("A", self.gross.clone(), Unit::Area)
    }

    fn net(&self) -> Formula {
        let left = self.gross.clone() - self.holes.clone();
        // holes wider than the plate leave nothing
        let left = if left.value() < 0.0 { left.max(Traced::from(0.0)) } else { left };
        Formula::new("A_net", left, Unit::Area)
    }

    /// γ_M0, γ_M2, f_y and f_u.
    fn symbols(&self) -> [Traced; 4] {
        [
            Traced::number("γ_M0", self.gamma_m0),
            Traced::number("γ_M2", self.gamma_m2),
            Traced::stress("f_y", self.steel.fy.mpa()),
            Traced::stress("f_u", self.steel.fu.mpa()),
        ]
    }

    /// Resistance to tension \[N\], `min(A f_y/γ_M0, 0.9 A_net f_u/γ_M2)`; where `no_slip` at the
    /// ultimate limit state (category C) also `A_net f_y/γ_M0`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.3(2) and (4); EN 1993-1-8:2005 3.4.1(1)c.
    pub fn tension(&self, id: CheckId, no_slip: bool) -> Worked {
        let (gross, net) = (self.gross(), self.net());
        let [m0, m2, f_y, f_u] = self.symbols();
        let mut value = plastic(gross.traced(), f_y.clone(), m0.clone()).min(plastic(
            Traced::from(0.9) * net.traced(),
            f_u,
            m2,
        ));
        if no_slip {
            value = value.min(plastic(net.traced(), f_y, m0));
        }
        let clause = match no_slip {
            true => "EN 1993-1-1:2005 6.2.3(2) and (4)",
            false => "EN 1993-1-1:2005 6.2.3(2)",
        };
        Worked::of(clause, id, "N_t,Rd", value, Unit::Force)
            .after(crate::formula::Derivation::from(gross).then(net))
    }

    /// Resistance to compression without buckling \[N\], `A f_y/γ_M0`: filled holes count as
    /// steel, but `oversize` ones do not.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.4(2) and (3).
    pub fn compression(&self, id: CheckId, oversize: bool) -> Worked {
        let area = if oversize { self.net() } else { self.gross() };
        let [m0, _, f_y, _] = self.symbols();
        let value = plastic(area.traced(), f_y, m0);
        let clause = "EN 1993-1-1:2005 6.2.4(2) and (3)";
        Worked::of(clause, id, "N_c,Rd", value, Unit::Force).after(area)
    }

    /// Resistance to shear beside the holes \[N\], `A_net f_u/(√3 γ_M2)`.
    ///
    /// # Source
    /// SCI P358 and P398; EN 1993-1-8:2005 3.10.2 has the same strength of a torn face in tension,
    /// f_u/γ_M2, here by von Mises in shear.
    pub fn net_shear(&self, id: CheckId) -> Worked {
        let net = self.net();
        let [_, m2, _, f_u] = self.symbols();
        let value = in_shear(net.traced() * f_u, m2);
        Worked::of("EN 1993-1-1:2005 6.2.6; SCI P398", id, "V_net,Rd", value, Unit::Force)
            .after(net)
    }

    /// Resistance to shear without holes, with the reduction for the bending of a plate that is
    /// bolted beside its free edges \[N\]: `A f_y/(1.27 √3 γ_M0)`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(2); the factor 1.27 is that of SCI P358 and P398.
    pub fn plate_shear(&self, id: CheckId) -> Worked {
        let gross = self.gross();
        let [m0, _, f_y, _] = self.symbols();
        let value = plastic_shear(gross.traced() / Traced::from(BENDING_BESIDE_SHEAR), f_y, m0);
        Worked::of("EN 1993-1-1:2005 6.2.6(2); SCI P398", id, "V_Rd", value, Unit::Force)
            .after(gross)
    }

    /// What the yielding of the gross section takes of the tearing of the net one, to be at most 1
    /// for a ductile part: `(A f_y/γ_M0)/(0.9 A_net f_u/γ_M2)`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.3(3) and 6.2.5(4).
    pub fn yields_first(&self, id: CheckId) -> Worked {
        let (gross, net) = (self.gross(), self.net());
        let [m0, m2, f_y, f_u] = self.symbols();
        let value =
            plastic(gross.traced(), f_y, m0) / plastic(Traced::from(0.9) * net.traced(), f_u, m2);
        Worked::of("EN 1993-1-1:2005 6.2.3(3), 6.2.5(4)", id, "", value, Unit::Number)
            .after(crate::formula::Derivation::from(gross).then(net))
    }
}
