//! Runs both programs for a model from YAML text and a mesh in memory, and checks what must hold
//! for every run.

use super::{oracle, points};
use bracket::analysis::elastic;
use bracket::analysis::energy_pass::EnergyPass;
use bracket::analysis::event::silent;
use bracket::analysis::pass::PassOptions;
use bracket::diag::{Diagnostics, Place};
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;
use bracket::model::file::ModelFile;
use bracket::programs::conic::ConicProgram;
use bracket::programs::{Kinematic, Static};
use bracket::solve::{SolveOptions, SolveStatus};
use std::path::Path;

/// A model and the pass that was run on it.
pub struct Solved {
    pub model: AnalysisModel,
    pub pass: EnergyPass,
}

/// Reads the model. `yaml` has no `mesh` and `analysis: elastic` lines.
pub fn resolve(yaml: &str, mesh: TetMesh) -> Result<AnalysisModel, Diagnostics> {
    resolve_as("elastic", yaml, mesh)
}

/// The same for another kind of analysis.
pub fn resolve_as(kind: &str, yaml: &str, mesh: TetMesh) -> Result<AnalysisModel, Diagnostics> {
    let text = format!("mesh: in memory\nanalysis: {kind}\n{yaml}");
    let parsed = bracket::yaml::parse::<ModelFile>(&text, Path::new("test.yaml"))?;
    bracket::model::resolve::resolve(&parsed.value, mesh, &|_| Place::default())
}

/// Reads and runs a model that must be valid.
pub fn solve(yaml: &str, mesh: TetMesh) -> Solved {
    solve_to(yaml, mesh, &SolveOptions::default())
}

/// The same with other solver options.
pub fn solve_to(yaml: &str, mesh: TetMesh, options: &SolveOptions) -> Solved {
    let mut model = match resolve(yaml, mesh) {
        Ok(model) => model,
        Err(e) => panic!("{e:?}"),
    };
    let pass = elastic::run(
        &model,
        &PassOptions { solve: options.clone(), ..PassOptions::default() },
        &silent(),
    )
    .unwrap();
    // the bounds belong to the problem with this shift
    model.shift = pass.shift.clone();
    model.preload.iter_mut().zip(&pass.preload).for_each(|(p, t)| p.closure = Some(t.closure));
    Solved { model, pass }
}

impl Solved {
    /// Lower and upper bound \[N mm\], after the checks that must hold for every run: both programs
    /// are optimal, the bracket is strict, Σ contributions = gap, no contribution is negative, and
    /// the fields are admissible at random points.
    pub fn strict(&self, name: &str) -> [f64; 2] {
        let p = &self.pass;
        let runs = [p.kinematic.as_ref().unwrap(), p.statics.as_ref().unwrap()];
        for r in runs {
            assert!(r.status.is_solution(), "{name}: {r:?}");
            assert_eq!(r.trouble, None, "{name}");
            let solves = p.fixed_point.as_ref().map_or(1, |f| f.solves as u32);
            assert!(r.iterations <= solves * oracle::MOST_ITERATIONS, "{name}: {r:?}");
        }
        self.agree_with_clarabel(name);
        let b = p.bracket.as_ref().unwrap_or_else(|| panic!("{name}: no bracket"));
        let [lower, upper] = [b.lower().value(), b.upper().value()];
        println!(
            "{name}: [{lower:.10e}, {upper:.10e}] gap {:.3e}; {} tets, dofs {} / {}, iterations \
             {} / {}",
            b.gap(),
            self.model.mesh.tets.len(),
            runs[0].dofs,
            runs[1].dofs,
            runs[0].iterations,
            runs[1].iterations
        );
        assert!(
            b.is_strict(),
            "{name}: {:?} {:?}",
            b.lower().certificate(),
            b.upper().certificate()
        );
        let c = p.contributions.as_ref().unwrap();
        let copies = f64::from(self.model.symmetry);
        let strain = b.lower().certificate().strain_energy.unwrap_or(0.0);
        let scale = lower
            .abs()
            .max(upper.abs())
            .max(b.upper().certificate().work.abs() * copies)
            .max(strain * copies);
        let (total, gap) = (c.total() * copies, upper - lower);
        assert!(
            (total - gap).abs() <= 1e-8 * scale,
            "{name}: Σ contributions {total:e} against {gap:e}, scale {scale:e}"
        );
        let least =
            c.elements.iter().chain(&c.contacts).chain(&c.welds).copied().fold(0.0, f64::min);
        assert!(least >= -1e-12 * scale, "{name}: contribution {least:e}, scale {scale:e}");
        points::check(
            name,
            &self.model,
            p.stress.as_ref().unwrap(),
            p.displacement.as_ref().unwrap(),
        );
        [lower, upper]
    }

    /// Compares the condensed method with Clarabel for each program, if Clarabel takes little time.
    fn agree_with_clarabel(&self, name: &str) {
        let kinematic = Kinematic::new(&self.model).unwrap();
        let statics = Static::new(&self.model).unwrap();
        let loaded =
            |p: &ConicProgram| !p.cones.is_empty() && p.p.n < 3000 && p.q.iter().any(|q| *q != 0.0);
        // the form that a pass gives to its solver
        let program = kinematic.program.measured_from(&kinematic.closed(&self.model));
        if loaded(&kinematic.program) {
            oracle::agree(&format!("{name} kinematic"), &program, &kinematic.map.block);
        }
        let program = statics.program.measured_from(&statics.closed());
        if loaded(&statics.program) {
            oracle::agree(&format!("{name} static"), &program, &statics.map.block);
        }
    }

    /// Checks that the bracket is strict and that both ends agree with `exact` to `tolerance`
    /// (relative).
    pub fn exact(&self, name: &str, exact: f64, tolerance: f64) {
        let [lower, upper] = self.strict(name);
        println!(
            "{name}: exact {exact:.10e}, relative errors {:.1e} {:.1e}",
            lower / exact - 1.0,
            upper / exact - 1.0
        );
        for x in [lower, upper] {
            assert!(
                (x - exact).abs() <= tolerance * exact.abs(),
                "{name}: {x:.12e} against {exact:.12e}"
            );
        }
    }

    /// Checks that the bracket is strict and contains `exact`, up to rounding.
    pub fn contains(&self, name: &str, exact: f64) -> [f64; 2] {
        let [lower, upper] = self.strict(name);
        let slack = 1e-9 * exact.abs();
        assert!(
            lower <= exact + slack && exact <= upper + slack,
            "{name}: {exact:e} outside [{lower:e}, {upper:e}]"
        );
        [lower, upper]
    }

    /// Checks that there is no equilibrium: both programs are unbounded, and each names `part`.
    pub fn no_equilibrium(&self, name: &str, part: &str) {
        assert!(
            self.pass.bracket.is_none() && self.pass.lower.is_none() && self.pass.upper.is_none(),
            "{name}"
        );
        for (which, r) in [("kinematic", &self.pass.kinematic), ("static", &self.pass.statics)] {
            // under Coulomb's law the static program needs the slips of the kinematic one
            if which == "static" && self.model.has_coulomb_friction() {
                assert!(r.is_none(), "{name}: {r:?}");
                continue;
            }
            let r = r.as_ref().unwrap();
            println!("{name}: {which} {:?} after {}: {:?}", r.status, r.iterations, r.mechanism);
            assert_eq!(r.status, SolveStatus::Unbounded, "{name}: {which}");
            // at most 15 on a processor with AVX-512, 17 on one without: the order of sums differs
            assert!(
                r.iterations <= 20,
                "{name}: {which} took {} iterations to its certificate",
                r.iterations
            );
            let mechanism = r.mechanism.clone().unwrap_or_default().to_string();
            assert!(mechanism.contains(part), "{name}: {which} {mechanism}");
        }
    }
}
