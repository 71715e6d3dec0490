//! Forces and members of an IOM container, the open model of IDEA StatiCa with its results (XML).
//!
//! Units are N, N m and m. Signs are those of the developers' documentation (IOM coordinate
//! systems): z up, `N` a tension, positive `My` and `Mz` pull the fibres with negative z and y, and
//! positive `Vy`, `Vz` move the left face along y and z. On the section whose outward normal is x,
//! Bracket's section at the start of a member, force and moment along x, y, z are thus
//! `N, −Qy, −Qz, Mx, −My, Mz`: the factors with which IDEA itself makes load effects of them.
//!
//! Cantilever with a load P down at its tip, length L, started at the support: `Qz` = P, because
//! dMy/dx = Qz, and `My` = −P L, because the top is pulled. Bracket: Vz = −P, My = P L.

mod axes;
mod container;
mod loadings;
mod member;
mod parts;
mod results;

use super::force_row::Forces;
use super::frame_model::FrameModel;
use bracket_base::diag::Diagnostics;
use container::Container;
use loadings::Loadings;
use member::Members;
use parts::Parts;
use std::path::Path;

/// The forces of a container.
pub fn forces(file: &Path) -> Result<Forces, Diagnostics> {
    let text = container::text(file)?;
    let container = Container::parse(&text, file)?;
    let [model, results] = container.open(file)?;
    let parts = Parts::of(model, file)?;
    let (members, loadings) = (Members::of(&parts), Loadings { parts: &parts });
    Ok(results::read(results, &parts, &members, &loadings)?)
}

/// The members of a container with their profiles and steels.
pub fn model(file: &Path) -> Result<FrameModel, Diagnostics> {
    let text = container::text(file)?;
    let container = Container::parse(&text, file)?;
    let [model, _] = container.open(file)?;
    let parts = Parts::of(model, file)?;
    Ok(Members::of(&parts).model(&parts))
}

#[cfg(test)]
mod tests;
