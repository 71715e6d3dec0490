//! Shows which tets make the bracket of a limit load wide, and what narrows it.
//!
//! `cargo bench --bench limit_width -- [OPTIONS] (SPEC.yaml | cantilever | grid NX NY NZ LAYERS)`
//!
//! The model is the joint of a spec, or an I-beam of 900 mm (IPE360 without fillets). The beam is
//! clamped at one end and sheared at the other. It is meshed by gmsh or as a structured grid (NX
//! cells along the span, NY across half a flange, NZ over the height of the web, LAYERS in a
//! flange). Options: `--size-factor F`, `--size PART=MM`, `--layers 1|2|4` through plates, flanges
//! and webs, `--stretch FROM,TO,S` (elements in the spans FROM ≤ |x| ≤ TO are S times as long as
//! they are wide), `--span-growth G`, `--foot N` elements across a footprint, `--hinges S` (size
//! between pulled bolts and toes over the thickness of the plate),
//! `--bins MM`, `--static`,
//! `--kinematic`, `--threads N`.
//!
//! `--weak` solves the static program alone and prints which yield conditions limit its load
//! factor. The multipliers of these conditions are velocities with a dissipation of their own. This
//! dissipation adds up to the load factor.
//!
//! `--gain S MODEL.yaml` makes the elements S times as short in one zone after the other and prints
//! what each gives: the gain of the lower bound (`--kinematic`: of the upper one) per 1 000 tets. A
//! result folder has the models of the last meshes under `fields/`.
//!
//! Prints both bounds, the seconds, and a table by body and position along x. The table gives the
//! share of the tets, of the dissipation, and of the width `∫ π(ε) − σ:ε`. The width is positive in
//! every tet and adds up to the width of the bracket at unit power.
#![allow(missing_docs, clippy::unwrap_used)]

#[path = "../../tests/common/mod.rs"]
mod common;
mod gain;
mod stretch;

use bracket::analysis::event::{Event, Progress};
use bracket::analysis::limit;
use bracket::analysis::limit::{LimitPass, SUBDIVISIONS};
use bracket::analysis::pass::PassOptions;
use bracket::assembly::Assembly;
use bracket::assembly::assembly::{
    FaceRule, MidPlane, Part, PartMaterial, PartRole, Solid, Surface, SymmetryPlane,
};
use bracket::certify::limit_certificate::dissipation_densities;
use bracket::certify::velocity_field::pieces;
use bracket::checks::design_strengths;
use bracket::elements::geometry::centroid;
use bracket::elements::space::Tet10Space;
use bracket::elements::tet10;
use bracket::math::mandel;
use bracket::math::quadrature::tetrahedron_mass;
use bracket::mesh::TetMesh;
use bracket::meshing::joint::{MeshOptions, mesh_joint};
use bracket::model::AnalysisKind;
use bracket::model::AnalysisModel;
use bracket::model::file::Bounds;
use bracket::model::resolve::resolve;
use bracket::model_file::{self, Asked};
use bracket::programs::Static;
use bracket::solve::{SolveOptions, StopRules};
use bracket::strength::{Nominal, NominalStrength};
use common::grid::{Grid, even, joined, name};
use common::solved;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use stretch::{Stretch, lengthen, shorten, shorten_solid};

/// Number of tets that are printed one by one, those with the largest shares.
const STRONGEST: usize = 40;

#[derive(Default)]
struct Options {
    factor: Option<f64>,
    sizes: Vec<(String, f64)>,
    layers: Option<usize>,
    stretch: Vec<Stretch>,
    growth: Option<f64>,
    foot: Option<f64>,
    hinges: Option<f64>,
    bins: f64,
    bounds: Option<Bounds>,
    weak: bool,
    gain: Option<f64>,
}

fn main() {
    let mut o = Options { bins: 100.0, ..Options::default() };
    let mut words = Vec::new();
    let mut threads = 2;
    let mut args = std::env::args().skip(1);
    let number = |s: Option<String>| s.and_then(|s| s.parse::<f64>().ok()).expect("a number");
    while let Some(arg) = args.next() {
        match arg.as_str() {
            "--bench" => {}
            "--size-factor" => o.factor = Some(number(args.next())),
            "--layers" => o.layers = Some(number(args.next()) as usize),
            "--span-growth" => o.growth = Some(number(args.next())),
            "--hinges" => o.hinges = Some(number(args.next())),
            "--foot" => o.foot = Some(number(args.next())),
            "--bins" => o.bins = number(args.next()),
            "--threads" => threads = number(args.next()) as usize,
            "--static" => o.bounds = Some(Bounds::Static),
            "--kinematic" => o.bounds = Some(Bounds::Kinematic),
            "--weak" => o.weak = true,
            "--gain" => o.gain = Some(number(args.next())),
            "--size" => {
                let text = args.next().unwrap();
                let (part, size) = text.split_once('=').expect("PART=MM");
                o.sizes.push((part.into(), size.parse().expect("mm")));
            }
            "--stretch" => {
                let v: Vec<f64> =
                    args.next().unwrap().split(',').map(|s| s.parse().unwrap()).collect();
                o.stretch.push(Stretch { from: v[0], to: v[1], factor: v[2] });
            }
            word => words.push(word.to_string()),
        }
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global()
        .expect("the pool is built once");
    bracket::math::dense::sequential_kernels();
    if let Some(finer) = o.gain {
        gain::table(Path::new(&words[0]), o.bounds.unwrap_or(Bounds::Static), finer);
        return;
    }
    let mut model = match words[0].as_str() {
        "cantilever" => cantilever(&o),
        "grid" => {
            let n: Vec<usize> = words[1..].iter().map(|w| w.parse().unwrap()).collect();
            grid(n[0], n[1], n[2], n[3])
        }
        spec => joint(Path::new(spec), &o),
    };
    if let Some(b) = o.bounds {
        model.bounds = b;
    }
    if o.weak {
        weak(&model, o.bins);
        return;
    }
    let start = Instant::now();
    // the third program, without friction, is not requested
    let enough = Arc::new(AtomicBool::new(false));
    let stop = enough.clone();
    let progress: Progress = Arc::new(move |_, event| {
        if matches!(event, Event::Frictionless) {
            stop.store(true, Ordering::Relaxed);
        }
    });
    let solve = SolveOptions { interrupt: Some(enough), ..SolveOptions::default() };
    let pass = limit::run(&model, &PassOptions { solve, ..PassOptions::default() }, &progress)
        .expect("the pass runs");
    println!("{} tets, {:.1} s", model.mesh.tets.len(), start.elapsed().as_secs_f64());
    for (program, r) in pass.runs() {
        let trouble = r.trouble.clone().unwrap_or_default();
        println!(
            "  {} {} {} iterations {:.1} s {trouble}",
            program.name(),
            r.status.words(),
            r.iterations,
            r.solve_seconds
        );
    }
    println!(
        "  lower {:?} upper {:?}",
        pass.lower.as_ref().map(|b| b.value()),
        pass.upper.as_ref().map(|b| b.value())
    );
    table(&model, &pass, o.bins);
}

/// Shares of the static program's load factor by body and place: the multiplier of each yield point
/// times the strength.
fn weak(model: &AnalysisModel, width: f64) {
    let statics = Static::limit(model).expect("the model is sound");
    let program = &statics.program;
    let options = SolveOptions::default().with(StopRules::default().for_resistance());
    let solution = bracket::solve::solve(program, &statics.map.block, &options);
    let factor = solution.x.last().copied().unwrap_or(0.0);
    println!(
        "{} tets, static {}: {factor:.4}, {} iterations, {:.1} s",
        model.mesh.tets.len(),
        solution.status.words(),
        solution.iterations,
        solution.seconds
    );
    let shares = statics.yield_shares(&solution.z);
    let all: f64 = shares.iter().sum();
    let mut rows: BTreeMap<(u32, i64), [f64; 2]> = BTreeMap::new();
    for (e, share) in shares.iter().enumerate() {
        let x = centroid(&model.mesh.corners(e))[0];
        let row = rows.entry((model.mesh.tet_body[e], (x / width).floor() as i64)).or_default();
        row[0] += 1.0;
        row[1] += share / all * 100.0;
    }
    println!("  yield points {all:.4}\n  body            x from   tets   of the factor %");
    for ((body, bin), r) in rows {
        println!(
            "  {:12} {:9.0} {:6.0} {:15.1}",
            model.mesh.bodies[body as usize],
            bin as f64 * width,
            r[0],
            r[1]
        );
    }
    let mut tets: Vec<(usize, f64)> = shares.iter().map(|s| s / all * 100.0).enumerate().collect();
    tets.sort_by(|a, b| b.1.total_cmp(&a.1));
    println!("  body              x        y        z    of the factor %   of its volume, mean 1");
    let volume: f64 = (0..tets.len()).map(|e| model.mesh.volume(e)).sum();
    for &(e, share) in tets.iter().take(STRONGEST) {
        let c = centroid(&model.mesh.corners(e));
        let density = share / 100.0 * volume / model.mesh.volume(e);
        let body = &model.mesh.bodies[model.mesh.tet_body[e] as usize];
        println!("  {body:12} {:8.1} {:8.1} {:8.1} {share:15.2} {density:15.0}", c[0], c[1], c[2]);
    }
}

fn table(model: &AnalysisModel, pass: &LimitPass, width: f64) {
    let (Some(velocity), Some(stress), Some(b)) = (&pass.velocity, &pass.stress, &pass.bracket)
    else {
        return;
    };
    let space = Tet10Space::new(&model.mesh);
    let power = b.upper().certificate().live_power;
    let mut rows: BTreeMap<(u32, i64), [f64; 3]> = BTreeMap::new();
    let mut all = [0.0; 3];
    for (e, d) in dissipation_densities(model, velocity, SUBDIVISIONS).into_iter().enumerate() {
        let volume = model.mesh.volume(e);
        let mut work = 0.0;
        for (k, p) in pieces(model, &space, velocity, true, e).iter().enumerate() {
            let strains = tet10::vertex_strains(&p.corners, &p.velocities);
            for i in 0..4 {
                for j in 0..4 {
                    work += p.volume
                        * tetrahedron_mass(i, j)
                        * mandel::dot(&stress.points[e][k][i], &strains[j]);
                }
            }
        }
        let x = centroid(&model.mesh.corners(e))[0];
        let row = rows.entry((model.mesh.tet_body[e], (x / width).floor() as i64)).or_default();
        for (i, value) in
            [1.0, d * volume / power, (d * volume - work) / power].into_iter().enumerate()
        {
            row[i] += value;
            all[i] += value;
        }
    }
    println!(
        "  dissipation {:.4}, width {:.4} of which in tets {:.4}",
        all[1],
        b.upper().value() - b.lower().value(),
        all[2]
    );
    println!("  body            x from   tets   dissipation %   width %   width/dissipation");
    for ((body, bin), r) in rows {
        let name = &model.mesh.bodies[body as usize];
        let at = bin as f64 * width;
        let parts = [r[1] / all[1] * 100.0, r[2] / all[2] * 100.0, r[2] / r[1]];
        println!(
            "  {name:12} {at:9.0} {:6.0} {:15.1} {:9.1} {:12.3}",
            r[0], parts[0], parts[1], parts[2]
        );
    }
}

fn changed(assembly: &Assembly, o: &Options) -> Assembly {
    let mut a = assembly.clone();
    for p in &mut a.parts {
        shorten_solid(&o.stretch, &mut p.solid);
        p.convex.iter_mut().for_each(|s| shorten_solid(&o.stretch, s));
        if let Some((_, size)) = o.sizes.iter().find(|(name, _)| p.name.starts_with(name)) {
            p.size = *size;
        }
        if o.layers == Some(4) {
            more_planes(p);
        }
        for m in &mut p.mid_planes {
            (m.min[0], m.max[0]) = (shorten(&o.stretch, m.min[0]), shorten(&o.stretch, m.max[0]));
            if m.axis == 0 {
                m.at = shorten(&o.stretch, m.at);
            }
        }
    }
    for f in &mut a.faces {
        if let Surface::Plane { axis, at, min, max } = &mut f.surface {
            (min[0], max[0]) = (shorten(&o.stretch, min[0]), shorten(&o.stretch, max[0]));
            if *axis == 0 {
                *at = shorten(&o.stretch, *at);
            }
        }
    }
    a
}

/// Adds planes at the quarters of every plate that has one plane at its middle. Half the thickness
/// is the distance along the normal to the surface.
fn more_planes(p: &mut Part) {
    let solid = bracket::geometry::FlatSolid::from_solid(&p.solid);
    let planes = p.mid_planes.clone();
    for m in planes {
        let mut direction = [0.0; 3];
        direction[m.axis] = 1.0;
        // a point of the plane away from edges, webs and holes
        let mut start: [f64; 3] = std::array::from_fn(|d| m.min[d] + 0.137 * (m.max[d] - m.min[d]));
        start[m.axis] = m.at;
        let line = bracket::geometry::line::Line { start, direction };
        let inside = line.through(&solid);
        let Some(s) = inside.iter().find(|s| s[0] < 0.0 && s[1] > 0.0) else {
            panic!("{}: {m:?} {inside:?}", p.name)
        };
        let half = s[1].min(-s[0]);
        if half > 20.0 {
            continue;
        }
        for side in [-0.5, 0.5] {
            p.mid_planes.push(MidPlane { at: m.at + side * half, ..m });
        }
    }
}

fn meshed(assembly: &Assembly, o: &Options) -> bracket::meshing::joint::JointMesh {
    let folder = tempfile::tempdir().unwrap();
    let mut options = MeshOptions::new(folder.path());
    options.layers = o.layers != Some(1);
    options.sizes.factor = o.factor.unwrap_or(1.0);
    options.sizes.span_growth = o.growth.unwrap_or(options.sizes.span_growth);
    options.sizes.across_footprint = o.foot.unwrap_or(options.sizes.across_footprint);
    options.sizes.at_hinges = o.hinges;
    let mut m = mesh_joint(&changed(assembly, o), &options, &mut |_| {})
        .unwrap_or_else(|e| panic!("{e:#?}"));
    m.mesh.nodes.iter_mut().for_each(|x| x[0] = lengthen(&o.stretch, x[0]));
    m
}

fn joint(path: &Path, o: &Options) -> AnalysisModel {
    let input = bracket::driver::spec_file::read(path, None).expect("the spec is sound");
    let assembly = &input.joint.assembly;
    let meshed = meshed(assembly, o);
    let case = &model_file::cases(assembly)[0];
    let file = model_file::model_file(
        assembly,
        &design_strengths(&input.joint),
        &meshed.mesh,
        &meshed.symmetry_used,
        "mesh.msh",
        &Asked::new(case, AnalysisKind::Limit),
    );
    resolve(&file, meshed.mesh, &|path| input.spec.index.place(path)).expect("the model is sound")
}

const SPAN: f64 = 900.0;
const CANTILEVER: &str =
    "bodies: {BEAM: s}\nsupports:\n- {face: CLAMP, fix: [x, z]}\n- {face: SYM_Y0, fix: [y]}\n";

/// The load factor is the moment at the clamp over `f_y (b t_f (h − t_f) + t_w (h − 2 t_f)²/4)`.
fn loaded(mesh: TetMesh) -> AnalysisModel {
    let plastic = 235.0 * (170.0 * 12.7 * 347.3 + 8.0 * 334.6 * 334.6 / 4.0);
    let materials = common::yielding::MATERIALS;
    let load = format!(
        "rigid:\n- {{face: END, components: [z], free: [uz], force: [0, 0, {:?}]}}\n",
        -0.5 * plastic / SPAN
    );
    solved::resolve(&format!("{materials}{CANTILEVER}{load}"), mesh)
        .unwrap_or_else(|e| panic!("{e:?}"))
}

fn cantilever(o: &Options) -> AnalysisModel {
    let boxed = |min, max| Solid::Box { min, max };
    let solids = vec![
        boxed([0.0, -4.0, -167.3], [SPAN, 4.0, 167.3]),
        boxed([0.0, -85.0, 167.3], [SPAN, 85.0, 180.0]),
        boxed([0.0, -85.0, -180.0], [SPAN, 85.0, -167.3]),
    ];
    let mid = |axis, at: f64, z: [f64; 2]| MidPlane {
        axis,
        at,
        min: [0.0, -85.0, z[0]],
        max: [SPAN, 85.0, z[1]],
    };
    let mid_planes =
        vec![mid(2, -173.65, [0.0; 2]), mid(2, 173.65, [0.0; 2]), mid(1, 0.0, [-167.3, 167.3])];
    let part = Part {
        name: "BEAM".into(),
        label: "beam".into(),
        role: PartRole::Member,
        material: "s".into(),
        solid: Solid::Union(solids.clone()),
        convex: solids,
        mid_planes,
        oblique_planes: vec![],
        size: 25.4,
    };
    let face = |name: &str, at| FaceRule {
        name: name.into(),
        part: "BEAM".into(),
        surface: Surface::Plane { axis: 0, at, min: [at, -85.0, -180.0], max: [at, 85.0, 180.0] },
        imprint: false,
    };
    let assembly = Assembly {
        name: "cantilever".into(),
        parts: vec![part],
        materials: BTreeMap::from([(
            "s".into(),
            PartMaterial {
                e: 210_000.0,
                nu: 0.3,
                strength: NominalStrength::Steel(Nominal::new(235.0)),
                fu: None,
            },
        )]),
        interfaces: vec![],
        faces: vec![face("CLAMP", 0.0), face("END", SPAN)],
        supports: vec![],
        loads: vec![],
        symmetry: vec![SymmetryPlane { axis: 1 }],
        clearances: vec![],
        welds: vec![],
        preloads: vec![],
        sections: vec![],
        grips: vec![],
    };
    loaded(meshed(&assembly, o).mesh)
}

fn grid(nx: usize, ny: usize, nz: usize, layers: usize) -> AnalysisModel {
    let x = even(0.0, SPAN, nx);
    let y = joined(&[even(0.0, 4.0, layers.div_ceil(2)), even(4.0, 85.0, ny)]);
    let z = joined(&[
        even(-180.0, -167.3, layers),
        even(-167.3, 167.3, nz),
        even(167.3, 180.0, layers),
    ]);
    let flat = |axis: usize, c: f64| axis == 2 && (c.abs() - 173.65).abs() < 1e-9;
    let mut mesh = Grid::new([x, y, z]).jittered(0.1, 1).mesh(
        &["BEAM"],
        |c| (c[1] < 4.0 || c[2].abs() > 167.3).then_some(0),
        flat,
    );
    name(&mut mesh, "CLAMP", "BEAM", |p| p[0] == 0.0);
    name(&mut mesh, "END", "BEAM", |p| p[0] == SPAN);
    name(&mut mesh, "SYM_Y0", "BEAM", |p| p[1] == 0.0);
    loaded(mesh)
}
