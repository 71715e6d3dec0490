//! The section on yielding in an elastic, perfectly plastic analysis: yielded volume, lower bound
//! of the load's displacement, and the places that needed yield conditions.

use crate::document::Doc;
use crate::document::table::{Table, cells, dash};
use crate::figures::{Rounding, fixed, significant};
use crate::markdown::words::moved;
use crate::result::result_file::CaseResult;
use crate::result::result_file::ProgramRun;
use bracket_base::math::vec3;
use bracket_base::say;

/// Lower bound of the load's displacement.
pub(crate) fn displacement(doc: &mut Doc, case: &CaseResult) {
    if let (Some(load), Some(least)) = (case.load, case.load_displacement_at_least) {
        let (what, unit) = load.moves();
        let low = significant(least, 4, Rounding::Down);
        doc.paragraph(say!(
            "The load of the whole structure is {}. Its {} is at least {} {}; once something \
             yields, an energy does not bound it from above.",
            load.words(),
            moved(what),
            low,
            unit.to_owned()
        ));
    }
}

/// The yielded volume of each body, and the places that needed yield conditions.
pub(crate) fn yielding(doc: &mut Doc, case: &CaseResult) {
    if case.yielding.is_empty() {
        return;
    }
    doc.heading(say!("Yielding of {}", &case.name));
    doc.paragraph(
        "The utilisation is the largest `‖dev σ‖/(√(2/3) f_y)` of the lower bound's stress. The \
         yielded volume is that in which the upper bound's field has plastic strain (an \
         estimate), the plastic work that of this field in the whole structure. The plastic \
         strain is the equivalent one, its largest mean over an element of this field (an \
         estimate that depends on the mesh).",
    );
    let mut parts: Vec<_> = case.yielding.iter().collect();
    parts.sort_by(|a, b| b.dissipation.unwrap_or(0.0).total_cmp(&a.dissipation.unwrap_or(0.0)));
    let rows = parts.iter().map(|p| {
        cells![
            p.part.clone(),
            p.utilisation.map_or_else(dash, |u| fixed(u, 3, Rounding::Up).into()),
            p.yielded.map_or_else(dash, |y| fixed(100.0 * y, 1, Rounding::Nearest).into()),
            p.dissipation.map_or_else(dash, |d| significant(d, 3, Rounding::Nearest).into()),
            p.plastic_strain.map_or_else(dash, |s| fixed(100.0 * s, 2, Rounding::Nearest).into()),
            p.strain_at.map_or_else(dash, |x| x.map(|x| format!("{x:.0}")).join(", ").into()),
        ]
    });
    let columns = Table::columns([
        "body",
        "utilisation",
        "yielded volume [%]",
        "plastic work [N mm]",
        "largest plastic strain [%]",
        "at x, y, z [mm]",
    ]);
    doc.table(&Table { columns, rows: rows.collect() });
    for m in &case.face_motions {
        doc.paragraph(say!(
            "The loaded face {} turns by {} mrad and moves by {} mm (estimates; the bending of \
             the meshed members is part of both).",
            &m.face,
            significant(1e3 * m.turn(), 3, Rounding::Nearest),
            significant(vec3::norm(m.displacement), 3, Rounding::Nearest)
        ));
    }
    let Some(last) = case.history.last() else { return };
    let words = |name: &'static str, run: &Option<ProgramRun>| {
        let run = run.as_ref()?;
        let tets = run.yielding_tets?;
        let percent =
            fixed(100.0 * tets as f64 / last.macro_tets.max(1) as f64, 1, Rounding::Nearest);
        let count = fixed(tets as f64, 0, Rounding::Nearest);
        let solves = match run.solves {
            Some(1) => "1 solve".into(),
            n => say!("{} solves", n.unwrap_or_default()),
        };
        Some(say!(
            "in {} of the tets ({} %) of the {} program, after {}",
            count,
            percent,
            name,
            solves
        ))
    };
    let of_both = [words("static", &last.static_), words("kinematic", &last.kinematic)];
    let where_ = match of_both {
        [Some(a), Some(b)] => say!("{}, and {}", a, b),
        [a, b] => a.or(b).unwrap_or_default(),
    };
    let all = [&last.static_, &last.kinematic]
        .into_iter()
        .flatten()
        .all(|run| run.yielding_tets == Some(last.macro_tets));
    // where every tet has one from the start, there is nothing to say about their places
    if !where_.is_empty() && !all {
        doc.paragraph(say!(
            "Yield conditions were needed {}; everywhere else the stress was found below yield \
             without them.",
            where_
        ));
    }
}
