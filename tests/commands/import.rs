//! `bracket import` as the compiled program: a frame of two bays becomes a sweep of its joints.

mod container;
mod doubts;
mod frame;
mod guide;
mod refused;
mod residuals;
mod sweeps;
mod workbook;
