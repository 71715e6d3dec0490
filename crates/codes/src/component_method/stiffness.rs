//! Rotational stiffness: EN 1993-1-8:2005 6.3.

use super::column_web;
use super::compressed_zone::CompressedZone;
use super::joint::EndPlateJoint;
use super::rows::Rows;
use crate::check::{CheckId, Unit};
use crate::error::CheckError;
use crate::formula::{Formula, Number, Traced};
use crate::worked::Worked;
use bracket_joint::assembly::Way;

/// ψ of Table 6.8 for welded joints and bolted end plates.
const PSI: f64 = 2.7;

/// Stiffness coefficients and initial stiffness of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Stiffness {
    /// k1, column web panel in shear \[mm\]; `None` where it does not deform (β = 0).
    pub panel: Option<f64>,
    /// k2, column web in compression \[mm\]; `None` where it is stiffened or there is no column.
    pub compression: Option<f64>,
    /// Of every row: k3, k4, k5, k10 and k_eff,r \[mm\].
    pub rows: Vec<RowStiffness>,
    /// z_eq \[mm\].
    pub lever: f64,
    /// k_eq \[mm\].
    pub equivalent: f64,
    /// S_j,ini \[N mm/rad\].
    pub initial: Worked,
}

/// Stiffness coefficients of a row \[mm\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowStiffness {
    /// h_r.
    pub lever: f64,
    /// k3, column web in tension; `None` without a column.
    pub web: Option<f64>,
    /// k4, column flange in bending; `None` without a column.
    pub flange: Option<f64>,
    /// k5, end plate in bending; a splice has two of them.
    pub plate: f64,
    /// k10, bolts in tension.
    pub bolts: f64,
    /// k_eff,r = 1/Σ(1/k).
    pub effective: f64,
}

/// k1 of an unstiffened web panel in shear \[mm\]: `0.38 A_vc/(β z)`.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.11.
pub fn panel_in_shear(shear_area: f64, beta: f64, lever: f64) -> f64 {
    0.38 * shear_area / (beta * lever)
}

/// k2 of an unstiffened web in compression, or k3 of a web in tension \[mm\]: `0.7 b_eff t_wc/d_c`.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.11.
pub fn web_across(effective_width: f64, web: f64, clear_depth: f64) -> f64 {
    0.7 * effective_width * web / clear_depth
}

/// k4 of a column flange or k5 of an end plate in bending \[mm\]: `0.9 ℓ_eff t³/m³`.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.11.
pub fn flange_in_bending(length: f64, thickness: f64, m: f64) -> f64 {
    0.9 * length * (thickness / m).powi(3)
}

/// k10 of a row of two bolts in tension \[mm\]: `1.6 A_s/L_b`.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.11.
pub fn bolts_in_tension(stress_area: f64, elongation: f64) -> f64 {
    1.6 * stress_area / elongation
}

/// Stiffness coefficients and initial stiffness of a joint.
///
/// `k_eff,r = 1/Σ(1/k_i,r)`, `z_eq = Σ k_eff,r h_r²/Σ k_eff,r h_r`, `k_eq = Σ k_eff,r h_r/z_eq`,
/// `S_j,ini = E z²/(1/k1 + 1/k2 + 1/k_eq)`.
///
/// # Source
/// EN 1993-1-8:2005 6.3.1(4), 6.3.3.1, formulas 6.27, 6.29 to 6.31; Table 6.10: a splice counts k5
/// of both plates and k10.
pub fn initial(joint: &EndPlateJoint, rows: &Rows<'_>) -> Result<Stiffness, CheckError> {
    let c = joint.column.as_ref();
    let each = |r: usize| {
        let (on_column, (on_plate, m_plate)) = rows.stiffness_lengths(r);
        let of_column = c.zip(on_column).map(|(c, (length, m))| {
            let s = &c.section;
            let thickness = column_web::tension_thickness(s.tw, c.doublers, c.fy);
            [web_across(length, thickness, s.clear_depth()), flange_in_bending(length, s.tf, m)]
        });
        let plate = flange_in_bending(on_plate, joint.plate.thickness, m_plate);
        let bolts = bolts_in_tension(joint.bolts.stress_area, joint.bolts.elongation);
        // the other side of a splice is the same plate again
        let other = of_column.map_or(vec![plate], |k| k.to_vec());
        let effective = 1.0 / other.into_iter().chain([plate, bolts]).map(|k| 1.0 / k).sum::<f64>();
        let [web, flange] = of_column.map_or([None; 2], |k| k.map(Some));
        RowStiffness { lever: rows.lever[r], web, flange, plate, bolts, effective }
    };
    let found: Vec<RowStiffness> = (0..rows.count()).map(each).collect();
    let first: f64 = found.iter().map(|r| r.effective * r.lever).sum();
    let second: f64 = found.iter().map(|r| r.effective * r.lever * r.lever).sum();
    let lever = second / first;
    let equivalent = first / lever;
    let sheared = c.is_some() && joint.beta > 0.0;
    let panel = sheared.then(|| panel_in_shear(rows.shear_area(), joint.beta, lever));
    let compression = c.filter(|c| c.stiffener == 0.0).map(|c| {
        let web = CompressedZone::new(joint, c, Way::Down, rows.shear_area()).web;
        web_across(web.effective_width, web.web, web.clear_depth)
    });
    let terms = [("k1", panel), ("k2", compression), ("k_eq", Some(equivalent))];
    let flexibility = terms
        .into_iter()
        .filter_map(|(symbol, k)| Some(Traced::from(1.0) / Traced::length(symbol, k?)));
    let flexibility = flexibility.reduce(|sum, k| sum + k).unwrap_or(0.0.into());
    let z = Traced::length("z_eq", lever);
    let value = Traced::stress("E", joint.young) * z.clone() * z / flexibility;
    // Table 6.11 has k1 = ∞ for a stiffened panel; with transverse stiffeners alone the panel still
    // deforms in shear
    let kept = panel.is_some() && c.is_some_and(|c| c.stiffener > 0.0);
    let (clause, unit) = ("EN 1993-1-8:2005 6.3.1(4)", Unit::Rotational);
    let mut worked = Worked::of(clause, CheckId::InitialStiffness, "S_j,ini", value, unit);
    if kept {
        worked = worked.after("k1 kept finite beside transverse stiffeners");
    }
    for (symbol, k) in terms.into_iter().chain([("z_eq", Some(lever))]) {
        if let Some(k) = k {
            worked = worked.with(symbol, k, Unit::Length);
        }
    }
    Ok(Stiffness { panel, compression, rows: found, lever, equivalent, initial: worked })
}

/// Rotational stiffness S_j at a moment M_j,Ed ≤ M_j,Rd \[N mm/rad\].
///
/// `S_j = S_j,ini/μ`; μ = 1 up to 2/3 M_j,Rd, then (1.5 M_j,Ed/M_j,Rd)^2.7.
///
/// # Source
/// EN 1993-1-8:2005 6.3.1(4) and (6), formula 6.28, Table 6.8.
pub fn at_moment(initial: f64, demand: f64, resistance: f64) -> Worked {
    let initial = Traced::symbol("S_j,ini", initial, Unit::Rotational);
    let moment = |symbol, value: f64| Traced::symbol(symbol, value, Unit::Moment);
    let ratio = match demand == 0.0 {
        true => Traced::from(0.0),
        false => moment("M_j,Ed", demand.abs()) / moment("M_j,Rd", resistance),
    };
    let elastic = ratio.value() <= 2.0 / 3.0;
    let mu = if elastic { 1.0.into() } else { (Traced::from(1.5) * ratio).powf(PSI.into()) };
    let mu = mu.named("μ", Unit::Number);
    let (clause, id) = ("EN 1993-1-8:2005 6.3.1(6)", CheckId::StiffnessAtMoment);
    let worked = Worked::of(clause, id, "S_j", initial / mu.clone(), Unit::Rotational);
    let worked = worked.with("μ", mu.value(), Unit::Number);
    if elastic { worked } else { worked.after(Formula::new("μ", mu, Unit::Number)) }
}

/// Members that a connection joins, for the factor η of elastic analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joins {
    /// A beam and a column.
    BeamToColumn,
    /// Anything else: two beams, a splice, a column base.
    Other,
}

/// Rotational stiffness for elastic analysis up to M_j,Rd: `S_j,ini/η`, η = 2 for bolted end plates
/// between beam and column, 3 for other joints \[N mm/rad\].
///
/// # Source
/// EN 1993-1-8:2005 5.1.2(4), Table 5.2.
pub fn for_elastic_analysis(initial: f64, joins: Joins) -> Worked {
    let eta = match joins {
        Joins::BeamToColumn => 2.0,
        Joins::Other => 3.0,
    };
    let initial = Traced::symbol("S_j,ini", initial, Unit::Rotational);
    let value = initial / Traced::number("η", eta);
    let (clause, unit) = ("EN 1993-1-8:2005 5.1.2(4)", Unit::Rotational);
    Worked::of(clause, CheckId::ElasticStiffness, "S_j,ini/η", value, unit)
}
