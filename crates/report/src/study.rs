//! Output of a study of speed against error: table, CSV and plots.

use crate::document::markdown::inline;
use crate::draw::plot::{Plot, Series};
use crate::escaped::csv_cell;
use crate::figures::{Rounding, fixed, percent_up};
use crate::result::result_file::RESIDUAL_TOLERANCE;
use crate::result::study::{Meshes, Row, Study};
use crate::words::Words;
use bracket_base::diag::{Diagnostic, Diagnostics, visible};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::mesh::mesher_error::MesherError;
use bracket_engine::mesh::msh_write::write_whole;
use std::fmt::Write;
use std::path::Path;

/// The file that marks a folder as that of a study.
pub const MARK: &str = "study.csv";

impl Row {
    fn series(&self) -> Text {
        let meshes = match self.meshes {
            Meshes::Uniform => "uniform",
            Meshes::Adaptive => "adaptive",
        };
        say!("{}, {}", meshes, &self.solver)
    }
}

impl Study {
    /// The table, in Markdown.
    pub fn markdown(&self) -> String {
        let head = [
            "case",
            "meshes",
            "mesh",
            "macro tets",
            "unknowns",
            "gap",
            "this mesh [s]",
            "in all [s]",
            "memory [MiB]",
        ];
        let mut text = format!("| {} |\n|{}\n", head.join(" | "), " ---: |".repeat(head.len()));
        let dash = || "–".to_string();
        for r in &self.rows {
            let cells = [
                format!("{} ({})", inline(&r.case), r.analysis.word()),
                r.series().to_string(),
                r.mesh.to_string(),
                fixed(r.macro_tets as f64, 0, Rounding::Nearest),
                fixed(r.dofs as f64, 0, Rounding::Nearest),
                r.gap.map_or_else(dash, percent_up),
                format!("{:.1}", r.seconds),
                format!("{:.1}", r.total_seconds),
                r.peak_memory_mib.map_or_else(dash, |m| m.to_string()),
            ];
            // writing to a String cannot fail
            let _ = writeln!(text, "| {} |", cells.join(" | "));
        }
        text
    }

    /// The rows as CSV; an absent value is an empty cell.
    pub fn csv(&self) -> String {
        let mut text = "case,analysis,meshes,solver,mesh,macro_tets,dofs,lower,upper,gap,\
                        expected_gap,seconds,total_seconds,peak_memory_mib\n"
            .to_string();
        let number = |x: Option<f64>| x.map_or(String::new(), |x| x.to_string());
        for r in &self.rows {
            let meshes = if r.meshes == Meshes::Uniform { "uniform" } else { "adaptive" };
            let cells = [
                format!("\"{}\"", csv_cell(&r.case).replace('"', "\"\"")),
                r.analysis.word().into(),
                meshes.into(),
                r.solver.clone(),
                r.mesh.to_string(),
                r.macro_tets.to_string(),
                r.dofs.to_string(),
                number(r.lower),
                number(r.upper),
                number(r.gap),
                number(r.expected_gap),
                format!("{:.3}", r.seconds),
                format!("{:.3}", r.total_seconds),
                r.peak_memory_mib.map_or(String::new(), |m| m.to_string()),
            ];
            text.push_str(&cells.join(","));
            text.push('\n');
        }
        text
    }

    /// A plot for each load case, kind of analysis and abscissa, with the stem of its file.
    fn plots(&self) -> Vec<(String, Plot)> {
        let mut cases: Vec<(&str, &'static str)> = Vec::new();
        for r in &self.rows {
            let case = (&r.case[..], r.analysis.word());
            if !cases.contains(&case) {
                cases.push(case);
            }
        }
        type Abscissa = (&'static str, &'static str, fn(&Row) -> Option<f64>);
        let abscissas: [Abscissa; 4] = [
            ("time", "wall time, all meshes [s]", |r| Some(r.total_seconds)),
            ("tets", "macro tets", |r| Some(r.macro_tets as f64)),
            ("dofs", "unknowns of both programs", |r| Some(r.dofs as f64)),
            ("memory", "peak memory [MiB]", |r| r.peak_memory_mib.map(|m| m as f64)),
        ];
        let mut plots = Vec::new();
        for (i, case) in cases.iter().enumerate() {
            for (name, x, of) in &abscissas {
                let mut series: Vec<Series> = Vec::new();
                for r in self.rows.iter().filter(|r| (&r.case[..], r.analysis.word()) == *case) {
                    let Some(point) = of(r).zip(r.gap).map(|(x, g)| [x, 100.0 * g]) else {
                        continue;
                    };
                    match series.iter_mut().find(|s| s.name == r.series()) {
                        Some(s) => s.points.push(point),
                        None => series.push(Series { name: r.series(), points: vec![point] }),
                    }
                }
                let plot = Plot {
                    title: say!("{} ({})", case.0.to_owned(), case.1),
                    x: (*x).into(),
                    y: "certified gap [%]".into(),
                    series,
                    level: Some((100.0 * self.target_gap, "target".into())),
                };
                let stem =
                    if cases.len() == 1 { name.to_string() } else { format!("{name}_{}", i + 1) };
                plots.push((stem, plot));
            }
        }
        plots
    }

    /// Writes `study.csv`, `study.md` and the plots into a folder.
    pub fn write(&self, folder: &Path) -> Result<(), Diagnostics> {
        let mut page = format!(
            "# Speed against error\n\nGaps are certified: residuals at most \
             {RESIDUAL_TOLERANCE:.0e}. A row of adaptive meshes takes the best bounds of all \
             meshes up to it; its total time includes theirs.\n\n{}\n",
            self.markdown()
        );
        for (stem, plot) in self.plots() {
            write_whole(&folder.join(format!("{stem}.svg")), &plot.svg().file)?;
            let path = folder.join(format!("{stem}.png"));
            let bytes = plot.picture(&Words::default()).to_png().map_err(|e| {
                Diagnostic::environment(
                    "report/picture",
                    format!("the picture cannot be encoded: {e}"),
                )
            })?;
            std::fs::write(&path, bytes).map_err(|e| MesherError::write(&path, e))?;
            let _ = writeln!(page, "![Certified gap against {}]({stem}.png)\n", plot.x);
        }
        write_whole(&folder.join("study.md"), &visible(&page))?;
        Ok(write_whole(&folder.join(MARK), &self.csv())?)
    }
}
