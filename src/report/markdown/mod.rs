//! The report in Markdown.

pub mod checks;
pub mod comparison;
pub mod input;
pub mod limit;
pub mod page;
pub mod plastic;
pub mod preload;
pub mod schedule;
pub mod summary;
pub mod text;
pub mod verdict;
