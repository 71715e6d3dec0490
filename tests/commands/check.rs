//! `bracket check`, `bracket watch`, the verdict by code of `bracket run` and the printed report,
//! as the compiled program.

#[cfg(feature = "pdf")]
mod hostile_texts;
mod load_tables;
mod once;
mod plate_dxf;
#[cfg(feature = "pdf")]
mod printed_report;
