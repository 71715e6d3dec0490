//! Remeshes with Mmg by a metric: as many elements as the design asks for, long where the fields
//! vary little.

use crate::driver::meshing::quality_table;
use crate::driver::remesh::{Made, Places, Remesh};
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::math::mandel::Mandel;
use bracket_engine::mesh::mmg::{MENDED, Remesher};
use bracket_engine::mesh::nearest::Nearest;
use bracket_engine::mesh::polyhedron::Polyhedron;
use bracket_engine::mesh::size_field::Edges;
use bracket_engine::mesh::{TetMesh, mend, quality};
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::file::{ModelFile, Nodes};
use bracket_engine::model::resolve::resolve;
use bracket_engine::refine::metric::{self, Coarsest, Metric, SizeLimits, least_sizes};
use bracket_engine::refine::optimum::Design;
use bracket_engine::refine::plan;
use bracket_engine::refine::twins::{Images, Twins};
use bracket_report::console::log::Log;
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Makes the remesher that takes over where Mmg fails, starting from a mesh.
pub type Fallback<'a> = Rc<dyn Fn(TetMesh) -> Box<dyn Remesh<'a> + 'a> + 'a>;

/// Number of tets that Mmg makes over the number of regular unit tets of the metric, before its
/// first run.
const FILLING: f64 = 2.0;

/// Largest such number of an even mesh. In thin walls the remesher makes many times the elements
/// wanted; sizes that give the count then starve the other bodies (a beam splice: five times the
/// count in the beams, half of it in the bolts, and a worse bound than on isotropic sizes).
const UNEVEN: f64 = 3.5;

/// Relative deviation of the count of tets below which Mmg does not run again.
const NEAR: f64 = 0.15;

/// Relative deviation of the count beyond which a mesh is not used: forecasts of time and memory
/// would not hold, nor the limit of the number of tets.
const FAR: f64 = 0.25;

/// Runs of Mmg for one mesh.
const RUNS: usize = 3;

/// Largest length of an element over that on the first mesh, in any direction, away from contacts,
/// loads and supports, where no element is longer.
const COARSER: f64 = 1.8;

/// Ratio of real to ideal gap of elastic analysis for a four-fold growth: the ideal one knows the
/// sizes of the elements and not their directions (the paper's joint: 0.77 on 26 thousand tets,
/// 0.69 on 74 thousand).
const ELASTIC_LOSS: f64 = 0.8;

/// Time limit of one run of Mmg \[s\].
const SECONDS: f64 = 300.0;

/// What a remesher needs besides the model.
#[derive(Clone)]
pub struct Tools<'a> {
    /// Mmg.
    pub remesher: Remesher,
    /// Its working folder.
    pub dir: PathBuf,
    /// Set by another thread to stop it.
    pub interrupt: Arc<AtomicBool>,
    /// Takes over where it fails.
    pub fallback: Fallback<'a>,
    /// What takes over, in words.
    pub otherwise: &'static str,
}

/// Remeshes with Mmg.
pub struct ByMetric<'a> {
    tools: Tools<'a>,
    file: ModelFile,
    place: Places<'a>,
    last: Last,
    start: Start,
    filling: f64,
    /// The remesher in use since Mmg failed.
    other: Option<Box<dyn Remesh<'a> + 'a>>,
}

/// The last mesh, with what its metric needs.
#[derive(Clone)]
struct Last {
    mesh: TetMesh,
    edges: Edges,
    limits: SizeLimits,
    images: Images,
}

impl Last {
    fn new(mesh: TetMesh, start: &Start) -> Self {
        let (edges, limits) = (Edges::new(&mesh), start.limits(&mesh));
        let images = start.twins.on(&mesh);
        Self { mesh, edges, limits, images }
    }
}

/// The elements of the first mesh; no later mesh is much coarser.
#[derive(Clone)]
struct Start {
    /// Its nodes.
    nearest: Nearest,
    /// The coarsest tensor allowed at each node \[1/mm²\].
    coarsest: Vec<Mandel>,
    /// Bodies that are mirror images of each other.
    twins: Twins,
}

/// Names of the faces where loads, supports and rigid faces act; symmetry planes, which hold one
/// component only, are left out.
fn acting(file: &ModelFile) -> Vec<String> {
    let held = file.supports.iter().filter(|s| s.fix.len() != 1).map(|s| &s.face);
    let rigid = file.rigid.iter().map(|r| &r.face);
    let loads = file.loads.iter().chain(&file.dead).filter_map(|l| l.face.as_ref());
    held.chain(rigid).chain(loads).cloned().collect()
}

/// The nodes on the given faces and on interfaces between bodies.
fn kept(mesh: &TetMesh, faces: &[String]) -> Vec<bool> {
    let mut body = vec![u32::MAX; mesh.nodes.len()];
    let mut kept = vec![false; mesh.nodes.len()];
    for (t, b) in mesh.tets.iter().zip(&mesh.tet_body) {
        for n in t {
            let n = *n as usize;
            kept[n] |= body[n] != u32::MAX && body[n] != *b;
            body[n] = *b;
        }
    }
    let faces = mesh.faces.iter().filter(|f| faces.contains(&f.name));
    faces.flat_map(|f| &f.triangles).flatten().for_each(|n| kept[*n as usize] = true);
    kept
}

impl Start {
    fn new(mesh: &TetMesh, faces: &[String]) -> Self {
        let loose = COARSER.powi(-2);
        let coarsest = kept(mesh, faces)
            .iter()
            .zip(metric::own(mesh))
            .map(|(kept, own)| if *kept { own } else { own.map(|x| loose * x) })
            .collect();
        let nearest = Nearest::new(mesh.nodes.clone());
        Self { nearest, coarsest, twins: Twins::new(mesh, &Polyhedron::new(mesh)) }
    }

    /// The limits at the nodes of a later mesh.
    fn limits(&self, mesh: &TetMesh) -> SizeLimits {
        let at = |x: &[f64; 3]| self.nearest.to(*x).map_or([0.0; 6], |n| self.coarsest[n]);
        let coarsest: Vec<Mandel> = mesh.nodes.iter().map(at).collect();
        SizeLimits { least: least_sizes(mesh), coarsest: Coarsest::new(&coarsest) }
    }
}

impl<'a> ByMetric<'a> {
    /// Starts from the first mesh, whose bodies share nodes. Planes at mid-thickness of its plates
    /// are given up: between them Mmg makes many times the elements wanted.
    pub fn new(tools: Tools<'a>, file: &ModelFile, place: Places<'a>, mesh: TetMesh) -> Self {
        let mesh = TetMesh { tet_region: Vec::new(), ..mesh };
        let start = Start::new(&mesh, &acting(file));
        let file = ModelFile { nodes: Nodes::Shared, ..file.clone() };
        let (filling, other) = (FILLING, None);
        let last = Last::new(mesh, &start);
        Self { tools, file, place, last, start, filling, other }
    }

    /// The metric whose unit tets are the wanted parts.
    fn metric(&self, wanted: &[f64], directions: &[Mandel]) -> Metric {
        let Last { mesh, edges, limits, images } = &self.last;
        let mut metric = Metric::new(mesh, edges, wanted, directions, limits);
        images.even(&mut metric);
        metric
    }

    /// The mesh of a design.
    fn make(&mut self, design: &Design, seconds: f64, log: &Log) -> Result<TetMesh, Diagnostics> {
        let start = Instant::now();
        let mesh = &self.last.mesh;
        let polyhedron = Polyhedron::new(mesh);
        if let Some(i) = polyhedron.loose.first() {
            let name = &mesh.faces[*i as usize].name;
            let message = format!("the face {name} lies inside a body and bounds no part of it");
            return Err(Diagnostic::undecided("mesh/loose", message).into());
        }
        let metric = self.metric(&design.wanted, &design.directions);
        let wanted: f64 = metric.parts(mesh).iter().sum();
        let mut best: Option<(f64, TetMesh)> = None;
        let mut failed = None;
        for _ in 0..RUNS {
            let left = (seconds - start.elapsed().as_secs_f64()).clamp(0.0, SECONDS);
            log.stage("remeshing");
            let made = self.tools.remesher.remesh(
                mesh,
                &polyhedron,
                &metric.scaled(self.filling.cbrt()).tensors,
                &self.tools.dir,
                Duration::from_secs_f64(left),
                Some(&self.tools.interrupt),
            );
            let made = match made {
                Ok(made) => made,
                Err(error) => {
                    failed = Some(Diagnostic::from(error));
                    break;
                }
            };
            let miss = (made.tets.len() as f64 / wanted).ln();
            if miss.exp() * self.filling > UNEVEN {
                failed = Some(uneven(&made, wanted));
                break;
            }
            let made = mended(made, &self.tools.interrupt, log);
            let flat = mend::worst_flat(&made, mend::FLAT).is_some();
            if !flat && best.as_ref().is_none_or(|b| miss.abs() < b.0) {
                best = Some((miss.abs(), made));
            }
            if miss.abs() < NEAR && !flat {
                break;
            }
            // the count follows the sizes with the power −3; other sizes also move flat tets
            let factor = if miss.abs() < NEAR { 0.9 } else { miss.exp() };
            self.filling = (self.filling * factor).clamp(0.5, UNEVEN);
        }
        match (best, failed) {
            (Some((miss, mesh)), _) if miss < FAR => Ok(mesh),
            (Some((_, mesh)), _) => Err(uneven(&mesh, wanted).into()),
            (None, Some(fault)) => Err(fault.into()),
            (None, None) => {
                Err(Diagnostic::undecided("mesh/flat", "every mesh had flat tets").into())
            }
        }
    }
}

/// The mesh with its flat tets mended, as far as they can be.
fn mended(mesh: TetMesh, interrupt: &AtomicBool, log: &Log) -> TetMesh {
    if mend::worst_flat(&mesh, MENDED).is_none() {
        return mesh;
    }
    match mend::mend(&mesh, MENDED, &|| interrupt.load(Ordering::Relaxed)) {
        Ok((made, mended)) => {
            log.stage(mended.words());
            made
        }
        Err(_) => mesh,
    }
}

/// The fault of a mesh that misses the wanted count.
fn uneven(made: &TetMesh, wanted: f64) -> Diagnostic {
    let message = format!("Mmg makes {} tets where {wanted:.0} are wanted", made.tets.len());
    Diagnostic::undecided("mesh/uneven", message)
}

impl<'a> Remesh<'a> for ByMetric<'a> {
    fn twin(&self) -> Box<dyn Remesh<'a> + 'a> {
        Box::new(Self {
            tools: self.tools.clone(),
            file: self.file.clone(),
            place: self.place,
            last: self.last.clone(),
            start: self.start.clone(),
            filling: self.filling,
            other: self.other.as_ref().map(|o| o.twin()),
        })
    }

    fn realised(&self, wanted: &[f64], directions: &[Mandel]) -> Vec<f64> {
        match &self.other {
            Some(other) => other.realised(wanted, directions),
            None => self.metric(wanted, directions).parts(&self.last.mesh),
        }
    }

    fn loss(&self) -> f64 {
        match &self.other {
            Some(other) => other.loss(),
            None if self.file.analysis == AnalysisKind::Elastic => ELASTIC_LOSS,
            None => plan::LOSS,
        }
    }

    fn remesh(&mut self, design: &Design, seconds: f64, log: &Log) -> Result<Made, Diagnostics> {
        if let Some(other) = &mut self.other {
            return other.remesh(design, seconds, log);
        }
        let start = Instant::now();
        let made = self.make(design, seconds, log);
        let _ = std::fs::remove_dir_all(&self.tools.dir);
        let mesh = match made {
            Ok(mesh) => mesh,
            Err(faults) => {
                let why = &faults.first().message;
                log.line(format!("{} from here on: {why}", self.tools.otherwise));
                let mut other = (self.tools.fallback)(self.last.mesh.clone());
                let left = seconds - start.elapsed().as_secs_f64();
                let made = other.remesh(design, left, log);
                self.other = Some(other);
                return made;
            }
        };
        let model = resolve(&self.file, mesh.clone(), self.place)?;
        self.last = Last::new(mesh.clone(), &self.start);
        let quality = quality_table(&quality::table(&mesh));
        let seconds = start.elapsed().as_secs_f64();
        Ok(Made { model, mesh, file: self.file.clone(), quality, seconds })
    }
}
