//! The command line as a whole, and the dispatch to its subcommands.

use super::common::{CommandResult, Common};
use super::{
    analyse, batch, catalog, check, doctor, import, mesh, new, report, run, schema, study,
    templates, verify, watch,
};
use clap::{Parser, Subcommand};

/// Steel connections with certified bounds.
#[derive(Debug, Parser)]
#[command(name = "bracket", version, about, propagate_version = true)]
pub struct Cli {
    /// The subcommand.
    #[command(subcommand)]
    pub command: Command,
    /// Options every subcommand takes.
    #[command(flatten)]
    pub common: Common,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Write a commented starter spec.
    New(new::NewArgs),
    /// Connection spec → geometry → mesh → dual analyses → bracket and report.
    Run(run::RunArgs),
    /// The same engine on a mesh you bring.
    Analyse(analyse::AnalyseArgs),
    /// The code's checks, detailing, drawing and verdict by code, at once.
    Check(check::CheckArgs),
    /// Repeat the checks on every change of the spec.
    Watch(watch::WatchArgs),
    /// Geometry and mesh only.
    Mesh(mesh::MeshArgs),
    /// Speed against error: meshes and solvers side by side.
    Study(study::StudyArgs),
    /// Print the report of a finished result as PDF.
    Report(report::ReportArgs),
    /// Recompute the certificate of a finished result.
    Verify(verify::VerifyArgs),
    /// Catalogues of joints: every row or combination checked and analysed.
    Batch(batch::BatchArgs),
    /// From the forces of a frame program to a sweep of all its joints.
    Import(import::ImportArgs),
    /// List and show catalogue data.
    Catalog(catalog::CatalogArgs),
    /// List the connection templates.
    Templates(templates::TemplatesArgs),
    /// Print the JSON Schema of an input file.
    Schema(schema::SchemaArgs),
    /// Report what this machine has and what is missing.
    Doctor(doctor::DoctorArgs),
}

/// Runs the chosen subcommand.
pub fn dispatch(cli: &Cli) -> CommandResult {
    match &cli.command {
        Command::New(args) => new::run(args, &cli.common),
        Command::Run(args) => run::run(args, &cli.common),
        Command::Analyse(args) => analyse::run(args, &cli.common),
        Command::Check(args) => check::run(args, &cli.common),
        Command::Watch(args) => watch::run(args, &cli.common),
        Command::Mesh(args) => mesh::run(args, &cli.common),
        Command::Study(args) => study::run(args, &cli.common),
        Command::Report(args) => report::run(args, &cli.common),
        Command::Verify(args) => verify::run(args, &cli.common),
        Command::Batch(args) => batch::run(args, &cli.common),
        Command::Import(args) => import::run(args, &cli.common),
        Command::Catalog(args) => catalog::run(args, &cli.common),
        Command::Templates(args) => templates::run(args, &cli.common),
        Command::Schema(args) => schema::run(args, &cli.common),
        Command::Doctor(args) => doctor::run(args, &cli.common),
    }
}
