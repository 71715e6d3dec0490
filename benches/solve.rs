//! Measures the cost of a solve: `cargo bench --bench solve -- [--limit] [OPTIONS] MODEL.yaml…`, or
//! `--size-factor F SPEC.yaml` for a spec.
//!
//! Prints for each model and program: the sizes, the forecast, the iterations, the time of the
//! whole solve, and the time of one factorisation and two solves of the same matrix in the same
//! run. It also prints the ratio Y = solve ÷ (iterations × (one factorisation + two solves)).

use bracket::checks::design_strengths;
use bracket::elements::hencky_kinematic::Flow;
use bracket::mesh::gmsh::Mesher;
use bracket::meshing::joint::{MeshOptions, mesh_joint};
use bracket::model::AnalysisKind;
use bracket::model::AnalysisModel;
use bracket::model::resolve::resolve;
use bracket::model_file::{self, Asked};
use bracket::programs::conic::ConicProgram;
use bracket::programs::{Kinematic, Static};
use bracket::solve;
use bracket::solve::{SolveOptions, Solver};
use std::path::Path;
use std::time::Instant;

struct Options {
    programs: Vec<&'static str>,
    solver: Solver,
    trace: bool,
    factor_only: bool,
    limit: bool,
}

fn main() {
    let mut options = Options {
        programs: vec!["kinematic", "static"],
        solver: Solver::Condensed,
        trace: false,
        factor_only: false,
        limit: false,
    };
    let mut models = Vec::new();
    let mut threads = 1;
    let mut size_factor = None;
    let mut args = std::env::args().skip(1);
    while let Some(arg) = args.next() {
        match arg.as_str() {
            "--kinematic" => options.programs = vec!["kinematic"],
            "--static" => options.programs = vec!["static"],
            "--clarabel" => options.solver = Solver::Clarabel,
            "--trace" => options.trace = true,
            "--limit" => options.limit = true,
            "--factor" => options.factor_only = true,
            "--threads" => threads = args.next().and_then(|n| n.parse().ok()).unwrap_or(1),
            "--size-factor" => size_factor = args.next().and_then(|n| n.parse().ok()),
            // cargo passes this argument to every bench
            "--bench" => {}
            model => models.push(model.to_string()),
        }
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global()
        .expect("the pool is built once");
    bracket::math::dense::sequential_kernels();
    println!(
        "dense Cholesky rate {:.1} GFLOP/s, {threads} threads",
        solve::sparse::dense::dense_rate() / 1e9
    );
    for path in &models {
        let model = match size_factor {
            Some(factor) => model_of_spec(Path::new(path), factor),
            None => {
                bracket::model::resolve::load_model(Path::new(path)).expect("the model is readable")
            }
        };
        println!("{path}: {} macro tets", model.mesh.tets.len());
        options.programs.iter().for_each(|p| run(&model, path, p, &options));
    }
}

/// The first load case of a connection spec, its mesh sizes multiplied by `factor`.
fn model_of_spec(path: &Path, factor: f64) -> AnalysisModel {
    let input = bracket::driver::spec_file::read(path, None).expect("the spec is sound");
    let folder = std::env::temp_dir().join(format!("bracket-bench-{}", std::process::id()));
    let mut options = MeshOptions::new(&folder);
    options.layers = input.spec.value.analysis.mesh.layers;
    options.sizes.factor = factor;
    options.mesher = Some(Mesher::find().expect("gmsh is installed"));
    let assembly = &input.joint.assembly;
    let meshed = mesh_joint(assembly, &options, &mut |_| {}).expect("the joint can be meshed");
    std::fs::remove_dir_all(&folder).expect("the folder is ours");
    let case = &model_file::cases(assembly)[0];
    let kind = AnalysisKind::Elastic;
    let file = model_file::model_file(
        assembly,
        &design_strengths(&input.joint),
        &meshed.mesh,
        &meshed.symmetry_used,
        "mesh.msh",
        &Asked::new(case, kind),
    );
    let place = |path: &str| input.spec.index.place(path);
    resolve(&file, meshed.mesh, &place).expect("the model is sound")
}

fn run(model: &AnalysisModel, path: &str, name: &str, options: &Options) {
    let start = Instant::now();
    let built = match (name, options.limit) {
        ("kinematic", false) => Kinematic::new(model).map(|k| (k.program, k.map.block)),
        ("kinematic", true) => {
            Kinematic::limit(model, Flow::Split).map(|k| (k.program, k.map.block))
        }
        (_, false) => Static::new(model).map(|s| (s.program, s.map.block)),
        (_, true) => Static::limit(model).map(|s| (s.program, s.map.block)),
    };
    let (program, block): (ConicProgram, Vec<u32>) = built.expect("the model is sound");
    let assembly = start.elapsed().as_secs_f64();
    println!(
        "{path} {name}: {} unknowns, {} cones, assembled in {assembly:.2} s",
        program.p.n,
        program.cones.len()
    );
    measure(name, &program, &block, options);
    println!("  peak memory {} MiB", bracket::analysis::memory::peak_memory_mib().unwrap_or(0));
}

fn measure(name: &str, program: &ConicProgram, block: &[u32], options: &Options) {
    let mut settings = SolveOptions { solver: options.solver, ..SolveOptions::default() };
    if options.limit {
        settings = if name == "kinematic" {
            settings.with(settings.stop.for_mechanism())
        } else {
            settings.with(settings.stop.for_resistance())
        };
    }
    if options.trace {
        settings.progress = Some(std::sync::Arc::new(|i: &solve::Iteration| {
            println!(
                "    {:3} gap {:9.2e} residual {:9.2e} step {:5.3} {:8.2} s",
                i.number, i.gap, i.residual, i.step, i.seconds
            );
        }));
    }
    let start = Instant::now();
    let mut prepared = solve::prepare(program, block, &settings);
    let setup = start.elapsed().as_secs_f64();
    if let Some(f) = prepared.forecast() {
        println!(
            "  set up in {setup:.2} s; forecast: {} unknowns, {:.1} M factor entries, {:.1} GFLOP \
             a factor, {:.2} GiB, {:.0} s",
            f.unknowns,
            f.factor_entries as f64 / 1e6,
            f.factor_flops / 1e9,
            f.gib(),
            f.seconds
        );
    }
    let yardstick = prepared.yardstick();
    if let Some(y) = &yardstick {
        println!(
            "  one factor {:.3} s ({:.1} GFLOP/s), one solve {:.3} s",
            y.factor,
            prepared.forecast().map_or(0.0, |f| f.factor_flops / 1e9 / y.factor),
            y.solve
        );
    }
    if options.factor_only {
        return;
    }
    let start = Instant::now();
    let solution = prepared.solve(&settings);
    let seconds = setup + start.elapsed().as_secs_f64();
    println!(
        "  {}: {} iterations, {seconds:.2} s, objective {:.9e}",
        solution.status.words(),
        solution.iterations,
        program.objective(&solution.x, &solution.z)
    );
    if let Some(y) = yardstick {
        let unit = f64::from(solution.iterations.max(1)) * (y.factor + 2.0 * y.solve);
        println!("  Y = {:.3}", seconds / unit);
    }
}
