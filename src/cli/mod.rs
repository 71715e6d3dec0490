//! The command line: a file per subcommand.

pub mod analyse;
pub mod catalog;
pub mod check;
pub mod doctor;
pub mod mesh;
pub mod new;
pub mod run;
pub mod schema;
pub mod spec_file;
pub mod study;
pub mod templates;
pub mod verify;
pub mod watch;

pub use crate::driver::CommandResult;
use clap::{Parser, Subcommand, ValueEnum};

/// Form of the data on standard output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For people.
    #[default]
    Text,
    /// For programs.
    Json,
}

/// Options every subcommand takes.
#[derive(Clone, Debug, clap::Args)]
pub struct Common {
    /// Form of the data on standard output.
    #[arg(long, global = true, value_enum, default_value = "text")]
    pub format: Format,
    /// Threads to use (default: all).
    #[arg(long, global = true, value_name = "N")]
    pub threads: Option<usize>,
    /// No progress, no talk; errors only.
    #[arg(long, short, global = true)]
    pub quiet: bool,
}

/// Steel connections with certified bounds.
#[derive(Debug, Parser)]
#[command(name = "bracket", version, about, propagate_version = true)]
pub struct Cli {
    /// What to do.
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
    /// The code's checks, detailing, drawing and verdict by code, at once
    Check(check::CheckArgs),
    /// The checks again on every change of the spec
    Watch(watch::WatchArgs),
    /// Geometry and mesh only.
    Mesh(mesh::MeshArgs),
    /// Speed against error: meshes and solvers side by side.
    Study(study::StudyArgs),
    /// Recompute the certificate of a finished result.
    Verify(verify::VerifyArgs),
    /// List and show catalogue data.
    Catalog(catalog::CatalogArgs),
    /// List the connection templates.
    Templates(templates::TemplatesArgs),
    /// Print the JSON Schema of an input file.
    Schema(schema::SchemaArgs),
    /// Say what this machine has and what is missing.
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
        Command::Verify(args) => verify::run(args, &cli.common),
        Command::Catalog(args) => catalog::run(args, &cli.common),
        Command::Templates(args) => templates::run(args, &cli.common),
        Command::Schema(args) => schema::run(args, &cli.common),
        Command::Doctor(args) => doctor::run(args, &cli.common),
    }
}
