//! Tests of the hand checks of an end plate from its spec.

mod annexes;
mod beam_and_classes;
mod fixture;
mod haunched;
mod load_cases;
mod sbe_p11;
mod slip_and_holes;
mod spec_checks;
mod weld_methods;
mod welds_and_stiffeners;
