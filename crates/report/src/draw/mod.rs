//! Drawings, plots and pictures.

pub mod axes;
mod base_drawing;
pub mod canvas;
pub mod contact_map;
pub mod drawing;
pub mod dxf;
pub mod enlarged;
pub mod joint_drawings;
pub mod legend;
pub mod lettering;
pub mod load_steps;
pub mod mode_picture;
pub mod moment_axial;
pub mod moment_rotation;
pub mod options;
pub mod palette;
pub mod parts_drawing;
pub mod plot;
pub mod polygon;
mod rafter_drawing;
pub mod raster;
mod scale;
pub mod section;
pub mod sight;
pub mod strain_picture;
pub mod surface;
pub mod svg;
pub mod view;
pub mod weld_symbol;
pub mod whole;

pub use canvas::Picture;
