//! Effective lengths of equivalent T-stubs: EN 1993-1-8:2005 Tables 6.4 (unstiffened column
//! flange), 6.5 (stiffened column flange) and 6.6 (end plate).

use std::f64::consts::PI;

/// Effective lengths of the two families of yield lines \[mm\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lengths {
    /// ℓ_eff,cp: circular patterns.
    pub circular: f64,
    /// ℓ_eff,nc: other patterns.
    pub straight: f64,
}

impl Lengths {
    /// ℓ_eff,1, of mode 1: the smaller of both.
    pub fn mode1(self) -> f64 {
        self.straight.min(self.circular)
    }

    /// ℓ_eff,2, of mode 2: other patterns alone.
    pub fn mode2(self) -> f64 {
        self.straight
    }
}

impl std::iter::Sum for Lengths {
    fn sum<I: Iterator<Item = Self>>(lengths: I) -> Self {
        lengths.fold(Self::default(), |a, b| Lengths {
            circular: a.circular + b.circular,
            straight: a.straight + b.straight,
        })
    }
}

/// A row alone, away from stiffeners and ends.
///
/// # Source
/// EN 1993-1-8:2005 Tables 6.4 to 6.6, "other inner bolt-row": 2πm; 4m + 1.25e.
pub fn inner(m: f64, e: f64) -> Lengths {
    Lengths { circular: 2.0 * PI * m, straight: 4.0 * m + 1.25 * e }
}

/// A row alone at the end of the flange, `e1` from it.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.4, "end bolt-row": min(2πm, πm + 2e1); min(4m + 1.25e, 2m + 0.625e +
/// e1).
pub fn end(m: f64, e: f64, e1: f64) -> Lengths {
    Lengths {
        circular: (2.0 * PI * m).min(PI * m + 2.0 * e1),
        straight: (4.0 * m + 1.25 * e).min(2.0 * m + 0.625 * e + e1),
    }
}

/// A row alone next to a stiffener (or below the tension flange of the beam), with α of figure
/// 6.11.
///
/// # Source
/// EN 1993-1-8:2005 Tables 6.5 and 6.6, "bolt-row adjacent to a stiffener": 2πm; αm.
pub fn beside_stiffener(m: f64, alpha: f64) -> Lengths {
    Lengths { circular: 2.0 * PI * m, straight: alpha * m }
}

/// A row alone between a stiffener and the end of the flange, `e1` from the end.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.5, "end bolt-row adjacent to a stiffener": min(2πm, πm + 2e1); e1 + αm
/// − (2m + 0.625e), and no longer than next to a stiffener alone.
pub fn end_beside_stiffener(m: f64, e: f64, e1: f64, alpha: f64) -> Lengths {
    Lengths {
        circular: (2.0 * PI * m).min(PI * m + 2.0 * e1),
        straight: (alpha * m).min(e1 + alpha * m - (2.0 * m + 0.625 * e)),
    }
}

/// The only row outside the tension flange of the beam: end plate with edge distance `ex` beyond
/// the row, edge distance `e`, gauge `w`, width `bp`.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.6, "bolt-row outside tension flange of beam": min(2πmx, πmx + w, πmx +
/// 2e); min(4mx + 1.25ex, e + 2mx + 0.625ex, 0.5bp, 0.5w + 2mx + 0.625ex).
pub fn outside_flange(mx: f64, ex: f64, e: f64, w: f64, bp: f64) -> Lengths {
    let circular = (2.0 * PI * mx).min(PI * mx + w).min(PI * mx + 2.0 * e);
    let straight = (4.0 * mx + 1.25 * ex)
        .min(e + 2.0 * mx + 0.625 * ex)
        .min(0.5 * bp)
        .min(0.5 * w + 2.0 * mx + 0.625 * ex);
    Lengths { circular, straight }
}

/// Contribution of an inner row to a group, with the pitches to its two neighbours.
///
/// # Source
/// EN 1993-1-8:2005 Tables 6.4 to 6.6: 2p; p, with half of each pitch where they differ.
pub fn inner_of_group(above: f64, below: f64) -> Lengths {
    Lengths { circular: above + below, straight: 0.5 * (above + below) }
}

/// Contribution of the first or last row to a group, with the pitch `p` to its neighbour; `e1` only
/// at an end of the flange.
///
/// # Source
/// EN 1993-1-8:2005 Tables 6.4 to 6.6, "other end bolt-row": min(πm + p, 2e1 + p); min(2m + 0.625e
/// + 0.5p, e1 + 0.5p).
pub fn end_of_group(m: f64, e: f64, p: f64, e1: Option<f64>) -> Lengths {
    let e1 = e1.unwrap_or(f64::INFINITY);
    Lengths {
        circular: (PI * m + p).min(2.0 * e1 + p),
        straight: (2.0 * m + 0.625 * e + 0.5 * p).min(e1 + 0.5 * p),
    }
}

/// Contribution of the first or last row to a group where it is next to a stiffener.
///
/// # Source
/// EN 1993-1-8:2005 Tables 6.5 and 6.6: πm + p; 0.5p + αm − (2m + 0.625e).
pub fn beside_stiffener_of_group(m: f64, e: f64, p: f64, alpha: f64) -> Lengths {
    Lengths { circular: PI * m + p, straight: 0.5 * p + alpha * m - (2.0 * m + 0.625 * e) }
}

/// α of figure 6.11 for a row between a web (`m`, `e`) and a stiffener `m2` away, between 4 and 8.
///
/// λ1 = m/(m + e), λ2 = m2/(m + e). A curve of constant α is the straight line λ1 = L1 for λ2 ≥ L2,
/// and below λ1 = L1 + (1 − L1) ((L2 − λ2)/L2)^(0.185 α^1.785), with L1 = 1.25/(α − 2.75) and L2 =
/// α L1/2. Along the straight line αm is 4m + 1.25e: a stiffener far away has no effect. The figure
/// ends with the curve of 4.45; for narrow edges (e < 0.36 m) the same curves go on to 4, so that α
/// is never more than the row has without a stiffener.
///
/// # Source
/// EN 1993-1-8:2005 figure 6.11; the closed form of its curves as published with the code's
/// background (SCI P398, appendix G).
pub fn alpha(m: f64, e: f64, m2: f64) -> f64 {
    let (lambda1, lambda2) = (m / (m + e), m2 / (m + e));
    let (mut low, mut high) = (4.0, 8.0);
    // λ1 of the curve falls as α grows
    if curve(low, lambda2) <= lambda1 {
        return low;
    }
    if curve(high, lambda2) >= lambda1 {
        return high;
    }
    while high - low > 1e-12 {
        let mid = 0.5 * (low + high);
        if curve(mid, lambda2) > lambda1 {
            low = mid;
        } else {
            high = mid;
        }
    }
    0.5 * (low + high)
}

/// λ1 of the curve of a constant α at λ2.
fn curve(alpha: f64, lambda2: f64) -> f64 {
    let l1 = 1.25 / (alpha - 2.75);
    let l2 = 0.5 * alpha * l1;
    if lambda2 >= l2 {
        l1
    } else {
        l1 + (1.0 - l1) * ((l2 - lambda2) / l2).powf(0.185 * alpha.powf(1.785))
    }
}
