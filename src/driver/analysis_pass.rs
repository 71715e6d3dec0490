//! What a pass of either kind leaves, and what becomes of it in the result folder.

use crate::analysis::engine::{self, Pass, PassError, PassOptions, ProgramRun, Progress};
use crate::analysis::hencky;
use crate::analysis::limit::{self, LimitPass};
use crate::analysis::program_run::Program;
use crate::certify::error::Contributions;
use crate::certify::fields::StressField;
use crate::certify::limit_certificate::dissipation_densities;
use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::case::png;
use crate::math::vec3::{self, V3};
use crate::model::AnalysisModel;
use crate::report::draw::raster::{Deformed, Field, PictureOptions, draw};
use crate::report::markdown::page::PictureRef;
use crate::result::bounds::CaseBounds;
use crate::result::case::{case_result, energy_bounds};
use crate::result::data::{CaseResult, FrictionModel};
use crate::result::fields::field_files::{
    displacement_grid, lower_grid, shift_grid, stress_grid, velocity_grid, yielding_stress_grid,
};
use crate::result::fields::plastic_file::plastic_grid;
use crate::result::fields::vtu::VtuGrid;
use crate::result::folder::ResultFolder;
use crate::result::limit_case::{factor_bounds, limit_case_result};
use crate::solve::SolveOptions;
use crate::spec::analysis::AnalysisKind;

/// Kind of the field file of a stress that carries the live loads alone, which the word `unbounded`
/// stands on.
pub const LIVE_FIELD: &str = "static_live";
/// Kind of the one of the dead loads alone beside it.
pub const DEAD_FIELD: &str = "static_dead";

/// A pass of one kind of analysis.
pub enum AnalysisPass {
    /// Bounds of the energy.
    Energy(Box<Pass>),
    /// Bounds of the load factor.
    Factor(Box<LimitPass>),
}

impl AnalysisPass {
    /// Runs the programs that the model's kind of analysis asks for.
    pub fn run(
        model: &AnalysisModel,
        options: &PassOptions,
        progress: &Progress,
    ) -> Result<Self, PassError> {
        Ok(match model.analysis {
            AnalysisKind::Limit => {
                AnalysisPass::Factor(Box::new(limit::run(model, options, progress)?))
            }
            AnalysisKind::Elastoplastic => {
                AnalysisPass::Energy(Box::new(hencky::run(model, options, progress)?))
            }
            AnalysisKind::Elastic => {
                AnalysisPass::Energy(Box::new(engine::run(model, options, progress)?))
            }
        })
    }

    /// The gap at which a solve ends.
    pub fn tolerance(model: &AnalysisModel, asked: &SolveOptions) -> f64 {
        match model.analysis {
            AnalysisKind::Limit => asked.limit_gap,
            AnalysisKind::Elastoplastic => asked.gap.max(hencky::GAP),
            AnalysisKind::Elastic => asked.gap,
        }
    }

    /// The programs that ran or were to run.
    pub fn runs(&self) -> Vec<(Program, &ProgramRun)> {
        match self {
            AnalysisPass::Energy(p) => p.runs().collect(),
            AnalysisPass::Factor(p) => p.runs().collect(),
        }
    }

    /// Contributions to the gap of the bracket that answers, where there is one.
    pub fn contributions(&self) -> Option<&Contributions> {
        match self {
            AnalysisPass::Energy(p) => p.contributions.as_ref(),
            AnalysisPass::Factor(p) => p.contributions.as_ref(),
        }
    }

    /// What each tet holds the lower bound of a load factor down by.
    pub fn yield_multiplier_share(&self) -> Option<&[f64]> {
        match self {
            AnalysisPass::Energy(_) => None,
            AnalysisPass::Factor(p) => p.yield_multiplier_share.as_deref(),
        }
    }

    /// The stress behind the lower bound of the answer, and the load factor it carries.
    pub fn stress(&self, entry: &CaseResult) -> Option<(&StressField, f64)> {
        match self {
            AnalysisPass::Energy(p) => p.stress.as_ref().map(|s| (s, 1.0)),
            AnalysisPass::Factor(p) => p
                .carried(entry.problem == FrictionModel::Coulomb)
                .map(|(stress, bound)| (stress, bound.certificate().factor)),
        }
    }

    /// The entry of the result.
    pub fn entry(
        &self,
        name: &str,
        model: &AnalysisModel,
        mesh_seconds: Option<f64>,
    ) -> CaseResult {
        match self {
            AnalysisPass::Energy(p) => case_result(name, model, p, mesh_seconds),
            AnalysisPass::Factor(p) => limit_case_result(name, model, p, mesh_seconds),
        }
    }

    /// The bounds behind the entry of the result.
    pub fn bounds(&self, entry: &CaseResult) -> CaseBounds {
        match self {
            AnalysisPass::Energy(p) => energy_bounds(p),
            AnalysisPass::Factor(p) => factor_bounds(p, entry.problem),
        }
    }

    /// Writes the fields of the kinematic program and those of the static one, as far as they are
    /// wanted.
    pub fn write_fields(
        &self,
        model: &AnalysisModel,
        stem: &str,
        folder: &ResultFolder,
        [kinematic, statics]: [bool; 2],
    ) -> Result<(), Diagnostics> {
        let write = |kind: &str, grid: VtuGrid| -> Result<(), Diagnostics> {
            let bytes = grid.to_bytes().map_err(Diagnostic::from)?;
            Ok(folder.write(&format!("fields/{stem}_{kind}.vtu"), &bytes)?)
        };
        match self {
            AnalysisPass::Energy(p) => {
                let contributions = p.contributions.as_ref().map(|c| &c.elements[..]);
                if let Some(u) = p.plastic.as_ref().filter(|_| kinematic) {
                    write("kinematic", plastic_grid(model, u, contributions))?;
                } else if let Some(u) = p.displacement.as_ref().filter(|_| kinematic) {
                    write("kinematic", displacement_grid(model, u, contributions))?;
                }
                if let Some(s) = p.stress.as_ref().filter(|_| statics) {
                    let yields = model.analysis == AnalysisKind::Elastoplastic;
                    write(
                        "static",
                        if yields { yielding_stress_grid(model, s) } else { stress_grid(model, s) },
                    )?;
                }
                if !p.shift.faces.is_empty() {
                    write("shift", shift_grid(model, &p.shift))?;
                }
            }
            AnalysisPass::Factor(p) => {
                if let Some(v) = p.velocity.as_ref().filter(|_| kinematic) {
                    let densities = dissipation_densities(model, v, limit::SUBDIVISIONS);
                    write("kinematic", velocity_grid(model, v, densities))?;
                }
                if let Some(free) = &p.free {
                    let densities = vec![0.0; model.mesh.tets.len()];
                    write("kinematic", velocity_grid(model, &free.field, densities))?;
                }
                if let Some(u) = &p.unlimited {
                    write(LIVE_FIELD, stress_grid(model, &u.field))?;
                    if let Some(dead) = &u.dead {
                        write(DEAD_FIELD, lower_grid(model, dead, 0.0))?;
                    }
                }
                for (kind, stress, bound) in [
                    ("static", &p.stress, &p.lower),
                    ("static_frictionless", &p.frictionless_stress, &p.frictionless),
                ] {
                    if let (true, Some(s), Some(b)) = (statics, stress, bound) {
                        write(kind, lower_grid(model, s, b.certificate().factor))?;
                    }
                }
            }
        }
        Ok(())
    }

    /// The part of a mechanism's dissipation that is not that of welds; `None` where nothing
    /// dissipates.
    fn part_of_the_bodies(&self) -> Option<f64> {
        let AnalysisPass::Factor(pass) = self else { return None };
        let c = pass.upper.as_ref()?.certificate();
        let [bodies, welds] = [&c.dissipation, &c.welds].map(|d| d.iter().sum::<f64>());
        (bodies + welds > 0.0).then(|| bodies / (bodies + welds))
    }

    /// The deformed shape with the size of the displacement as colours, or the mechanism with its
    /// dissipation.
    pub fn picture(
        &self,
        name: &str,
        model: &AnalysisModel,
        mirror: &[usize],
        stem: &str,
        folder: &ResultFolder,
    ) -> Result<Option<PictureRef>, Diagnostics> {
        let mesh = &model.mesh;
        let (field, u) = match self {
            AnalysisPass::Energy(p) => (None, p.displacement.as_ref()),
            AnalysisPass::Factor(p) => {
                let v = p.velocity.as_ref().or(p.free.as_ref().map(|f| &f.field));
                (v, v.map(|v| &v.nodes))
            }
        };
        let Some(u) = u else { return Ok(None) };
        let vertices = &u.u[..mesh.nodes.len()];
        let size: Vec<f64> = vertices.iter().map(|x| vec3::norm(*x)).collect();
        let Some(factor) = enlargement(&mesh.nodes, &size) else { return Ok(None) };
        let (values, range);
        let (colours, file, caption) = match field {
            None => (
                Field { name: "displacement", unit: "mm", values: &size, range: None },
                format!("deformed_{stem}.png"),
                format!("Case {}: deformed shape, {factor} times enlarged", name),
            ),
            Some(v) => {
                let mut densities = dissipation_densities(model, v, limit::SUBDIVISIONS);
                let words = match self.part_of_the_bodies() {
                    Some(part) if part < LITTLE => {
                        // what rounding leaves of the flow is no picture of it
                        densities.fill(0.0);
                        "the welds dissipate all, the parts do not flow"
                    }
                    _ => "coloured by its dissipation",
                };
                (values, range) = plastic_zones(model, &densities);
                (
                    Field { name: "dissipation, relative", unit: "", values: &values, range },
                    format!("mechanism_{stem}.png"),
                    format!("Case {name}: mechanism of the upper bound, {words}"),
                )
            }
        };
        let deformed = Some(Deformed { displacement: vertices, factor, to_scale: field.is_none() });
        let options = PictureOptions {
            mirror,
            mesh_lines: false,
            field: Some(colours),
            deformed,
            ..PictureOptions::default()
        };
        folder.write(&file, &png(&draw(mesh, &options))?)?;
        Ok(Some(PictureRef { file, caption }))
    }
}

/// Part of the dissipation below which bodies do not flow beside their welds.
const LITTLE: f64 = 1e-3;

/// A round factor that draws the largest displacement as about a twentieth of the shape; `None`
/// where nothing moves.
fn enlargement(nodes: &[V3], size: &[f64]) -> Option<f64> {
    let largest = size.iter().fold(0.0f64, |a, b| a.max(*b));
    if largest == 0.0 {
        return None;
    }
    let (lo, hi) = nodes.iter().fold(([f64::MAX; 3], [f64::MIN; 3]), |(lo, hi), x| {
        (std::array::from_fn(|d| lo[d].min(x[d])), std::array::from_fn(|d| hi[d].max(x[d])))
    });
    let wanted = 0.05 * vec3::norm(vec3::sub(hi, lo)) / largest;
    let power = 10f64.powf(wanted.log10().floor());
    Some([5.0, 2.0, 1.0].into_iter().map(|m| m * power).find(|f| *f <= wanted).unwrap_or(power))
}

/// Dissipation densities at the nodes over their mean where the mechanism dissipates, and the range
/// of colours: up to the largest value drawn, but no further than the mean, for a single corner
/// with a huge density must not leave all the rest dark.
fn plastic_zones(model: &AnalysisModel, densities: &[f64]) -> (Vec<f64>, Option<[f64; 2]>) {
    let mesh = &model.mesh;
    let mut nodes = vec![(0.0, 0.0); mesh.nodes.len()];
    let (mut square, mut total) = (0.0, 0.0);
    for (e, (tet, d)) in mesh.tets.iter().zip(densities).enumerate() {
        let v = mesh.volume(e);
        square += v * d * d;
        total += v * d;
        tet.iter().for_each(|&n| {
            let sum = &mut nodes[n as usize];
            *sum = (sum.0 + v * d, sum.1 + v);
        });
    }
    let mean = if total > 0.0 { square / total } else { 1.0 };
    let values: Vec<f64> =
        nodes.into_iter().map(|(d, v)| if v > 0.0 { d / v / mean } else { 0.0 }).collect();
    let largest = values.iter().fold(0.0f64, |m, x| m.max(*x));
    let top = if largest > 0.0 { largest.min(1.0) } else { 1.0 };
    (values, Some([0.0, top]))
}
