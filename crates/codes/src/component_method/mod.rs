//! Component method for bolted end plates: EN 1993-1-8:2005, 6.2 and 6.3.

pub mod assembly;
pub mod beam;
pub mod beam_end;
pub mod column_web;
pub mod component_kind;
pub mod compressed_zone;
pub mod effective_lengths;
pub mod equilibrium;
pub mod joint;
pub mod rows;
pub mod sloped_end;
pub mod stability;
pub mod stiffness;
pub mod t_stub;

pub use assembly::{Assessment, assess};
pub use component_kind::{ComponentKind, ElasticRule, LimitedBy, Summed};
pub use equilibrium::Equilibrium;
pub use joint::EndPlateJoint;
pub use stability::Stability;

#[cfg(test)]
mod reference_cases;
#[cfg(test)]
mod tests;
