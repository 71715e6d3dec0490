//! The report in Markdown. `compose` assembles the sections; each section has its own file.

pub mod answer;
pub mod assumptions;
pub mod certificate;
pub mod collapse;
pub mod component_method;
pub mod compose;
pub mod demand;
pub mod forces;
pub mod hand_checks;
pub mod history;
pub mod input;
pub mod joint;
pub mod load_steps;
pub mod method;
pub mod polygon;
pub mod preload;
pub mod report_data;
pub mod route;
pub mod schedule;
pub mod stiffness;
pub mod summary;
pub mod title;
pub mod verdict;
pub mod warnings;
pub mod words;
pub mod yielding;
